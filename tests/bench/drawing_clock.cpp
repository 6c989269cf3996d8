#include "tests/bench/drawing_clock.hpp"

#include <epoxy/egl.h>

#include <ctime>

namespace biotope {
namespace {

double read_clock(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

// OpenGL's functions know no object that could hold these.
double spent = 0;
double ran = 0;

/// Stands in for the OpenGL function that epoxy's pointer `Entry` holds, and counts the time it takes.
template <auto* Entry>
struct Between;
template <class... Arguments, void (**Entry)(Arguments...)>
struct Between<Entry> {
  static inline void (*original)(Arguments...) = nullptr;
  static void call(Arguments... arguments) {
    const DrawingClock::Part part;
    original(arguments...);
  }
  static void enter(const char* name) {
    // Epoxy finds a function at its first call, through the same pointer: it must be found before.
    original = reinterpret_cast<decltype(original)>(eglGetProcAddress(name));
    *Entry = call;
  }
  static void leave() { *Entry = original; }
};

}  // namespace

DrawingClock::DrawingClock() {
  Between<&epoxy_glDrawArrays>::enter("glDrawArrays");
  Between<&epoxy_glDrawElements>::enter("glDrawElements");
  Between<&epoxy_glDrawArraysInstanced>::enter("glDrawArraysInstanced");
  Between<&epoxy_glDrawElementsInstanced>::enter("glDrawElementsInstanced");
  Between<&epoxy_glDrawElementsInstancedBaseInstance>::enter("glDrawElementsInstancedBaseInstance");
  Between<&epoxy_glClear>::enter("glClear");
  Between<&epoxy_glClearNamedFramebufferfv>::enter("glClearNamedFramebufferfv");
  Between<&epoxy_glMultiDrawArraysIndirect>::enter("glMultiDrawArraysIndirect");
  Between<&epoxy_glCopyImageSubData>::enter("glCopyImageSubData");
  Between<&epoxy_glBlitNamedFramebuffer>::enter("glBlitNamedFramebuffer");
  Between<&epoxy_glGenerateTextureMipmap>::enter("glGenerateTextureMipmap");
  Between<&epoxy_glFinish>::enter("glFinish");
  Between<&epoxy_glTextureStorage2D>::enter("glTextureStorage2D");
  Between<&epoxy_glTextureStorage3D>::enter("glTextureStorage3D");
  Between<&epoxy_glDeleteTextures>::enter("glDeleteTextures");
}

DrawingClock::~DrawingClock() {
  Between<&epoxy_glDrawArrays>::leave();
  Between<&epoxy_glDrawElements>::leave();
  Between<&epoxy_glDrawArraysInstanced>::leave();
  Between<&epoxy_glDrawElementsInstanced>::leave();
  Between<&epoxy_glDrawElementsInstancedBaseInstance>::leave();
  Between<&epoxy_glClear>::leave();
  Between<&epoxy_glClearNamedFramebufferfv>::leave();
  Between<&epoxy_glMultiDrawArraysIndirect>::leave();
  Between<&epoxy_glCopyImageSubData>::leave();
  Between<&epoxy_glBlitNamedFramebuffer>::leave();
  Between<&epoxy_glGenerateTextureMipmap>::leave();
  Between<&epoxy_glFinish>::leave();
  Between<&epoxy_glTextureStorage2D>::leave();
  Between<&epoxy_glTextureStorage3D>::leave();
  Between<&epoxy_glDeleteTextures>::leave();
}

DrawingClock::Part::Part() : begin_(read_clock(CLOCK_MONOTONIC)), ran_(read_clock(CLOCK_THREAD_CPUTIME_ID)) {}
DrawingClock::Part::~Part() {
  spent += read_clock(CLOCK_MONOTONIC) - begin_;
  ran += read_clock(CLOCK_THREAD_CPUTIME_ID) - ran_;
}

void DrawingClock::restart() { spent = ran = 0; }
double DrawingClock::milliseconds() const { return spent; }
double DrawingClock::thread_milliseconds() const { return ran; }

}  // namespace biotope
