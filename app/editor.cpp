#include "app/editor.hpp"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <chrono>

#include "app/editor_host.hpp"
#include "ui/autosave.hpp"
#include "ui/editor_actions.hpp"
#include "ui/editor_window.hpp"
#include "ui/keep_settings.hpp"

namespace biotope {
namespace {

constexpr int frames_after_input = 4;  // Dear ImGui settles within a few frames
constexpr double idle_seconds = 0.5;   // between looks at the background while nothing moves
constexpr double busy_seconds = 0.1;   // while only progress moves; more would take the processor from the work
constexpr double frame_seconds = 1.0 / 60;

/// GLFW for the life of the editor.
struct Glfw {
  bool started = glfwInit() == GLFW_TRUE;
  ~Glfw() {
    if (started) glfwTerminate();
  }
};

struct WindowDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowPointer = std::unique_ptr<GLFWwindow, WindowDeleter>;

/// Dear ImGui and its backends for the life of the window.
struct ImGuiSession {
  explicit ImGuiSession(GLFWwindow* window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
    // The host hands input over frame by frame.
    ImGui_ImplGlfw_InitForOpenGL(window, false);
    ImGui_ImplOpenGL3_Init("#version 450 core");
  }
  ~ImGuiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
};

WindowPointer make_window(const Settings& settings) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_MAXIMIZED, settings.maximized ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  WindowPointer window(glfwCreateWindow(settings.window_width, settings.window_height, "Biotope", nullptr, nullptr));
  if (window) glfwSetWindowSizeLimits(window.get(), 900, 560, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return window;
}

std::string glfw_problem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

void draw_frame(EditorHost& host, EditorWindow& editor) {
  host.follow_theme();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  host.feed_input();
  ImGui::NewFrame();
  update(host.state(), ImGui::GetTime(), ImGui::GetIO().DeltaTime);
  editor.draw({host.state(), host.theme(), host.commands()});
  ImGui::Render();
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(host.window(), &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  const ImVec4& background = host.theme().window;
  glClearColor(background.x, background.y, background.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  host.after_draw(width, height);
  glfwSwapBuffers(host.window());
}

/// Draws while something moves, sleeps while nothing does.
void run_loop(EditorHost& host, EditorWindow& editor) {
  int frames_left = frames_after_input;
  double drawn_at = 0;
  while (!host.should_close()) {
    const EditorState& state = host.state();
    const bool flowing = frames_left > 0 || state.clock.playing || state.painting.stroking() || editor.refining();
    const bool waiting = animates(state) || !state.notice.empty();
    const double pause = flowing ? frame_seconds - (glfwGetTime() - drawn_at) : waiting ? busy_seconds : idle_seconds;
    if (pause > 0) {
      glfwWaitEventsTimeout(pause);
    } else {
      glfwPollEvents();
    }
    if (host.take_input()) frames_left = frames_after_input;
    frames_left = std::max(frames_left - 1, 0);
    drawn_at = glfwGetTime();
    draw_frame(host, editor);
  }
}

}  // namespace

bool display_available() {
  const Glfw glfw;
  return glfw.started;
}

Status run_editor(const EditorOptions& options) {
  const Glfw glfw;
  if (!glfw.started) {
    return fail("No window can be opened: " + glfw_problem() + ". Without a display, use 'biotope solve' and 'biotope render'.");
  }
  const std::filesystem::path settings_file = config_folder() / "settings.json";
  const Settings settings = load_settings(settings_file);
  const WindowPointer window = make_window(settings);
  if (!window)
    return fail("The editor needs OpenGL 4.5: " + glfw_problem() +
                ". Update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1.");
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  EditorHost host(window.get(), settings, settings_file);
  const ImGuiSession session(window.get());
  auto editor = EditorWindow::create();
  if (!editor) return tl::unexpected(editor.error());
  open(host.state(), options.input, options.import);
  host.offer_recovery();
  Autosave autosave(state_folder());
  host.set_autosave(&autosave);
  run_loop(host, **editor);
  host.remember_window();
  keep_settings(host.state());
  return save_settings(settings_file, host.state().settings);
}

}  // namespace biotope
