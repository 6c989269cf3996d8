#include "render/offscreen_context.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace biotope {

namespace {

/// True when the client supports an extension that makes displays without a window system.
bool has_client_extension(const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); }

/// Initialised displays to try, the software-capable surfaceless platform first, then every EGL device (NVIDIA offers those).
std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> displays;
  if (!has_client_extension("EGL_EXT_platform_base")) return displays;
  if (has_client_extension("EGL_MESA_platform_surfaceless")) {
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  if (has_client_extension("EGL_EXT_platform_device") && has_client_extension("EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count) == EGL_TRUE) {
      for (EGLint i = 0; i < count; ++i) {
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr));
      }
    }
  }
  return displays;
}

/// An OpenGL 4.5 core context of `display`, or EGL_NO_CONTEXT.
EGLContext make_context(EGLDisplay display) {
  constexpr std::array<EGLint, 5> config_attributes{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                                                    EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, config_attributes.data(), &config, 1, &count) != EGL_TRUE || count == 0) config = nullptr;
  constexpr std::array<EGLint, 7> attributes{
      EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

}  // namespace

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create() {
  for (const EGLDisplay display : candidate_displays()) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) continue;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_TRUE) {
      const EGLContext context = make_context(display);
      if (context != EGL_NO_CONTEXT) {
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) {
          std::unique_ptr<OffscreenContext> offscreen(new OffscreenContext);
          offscreen->display_ = display;
          offscreen->context_ = context;
          return offscreen;
        }
        eglDestroyContext(display, context);
      }
    }
    eglTerminate(display);
  }
  return fail(
      "No OpenGL 4.5 context without a window: EGL offers neither a surfaceless nor a device display. Install Mesa's EGL "
      "(libegl-mesa0) or a graphics driver with EGL.");
}

OffscreenContext::~OffscreenContext() {
  if (display_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

bool drawn_by_processor() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name != nullptr ? name : "";
  return renderer.find("llvmpipe") != std::string_view::npos || renderer.find("softpipe") != std::string_view::npos;
}

}  // namespace biotope
