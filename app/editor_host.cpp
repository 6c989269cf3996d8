#include "app/editor_host.hpp"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <ctime>

#include "core/exchange/open_input.hpp"
#include "render/image.hpp"
#include "ui/dropped_files.hpp"
#include "ui/editor_actions.hpp"
#include "ui/keep_settings.hpp"

namespace biotope {
namespace {

constexpr float double_click_seconds = 0.3F;

EditorHost& host_of(GLFWwindow* window) { return *static_cast<EditorHost*>(glfwGetWindowUserPointer(window)); }

/// Where the pointer is now, with the pen's pressure.
InputEvent at_pointer(GLFWwindow* window, InputEvent event, float pressure) {
  double x = 0;
  double y = 0;
  glfwGetCursorPos(window, &x, &y);
  event.x = float(x);
  event.y = float(y);
  event.pressure = pressure;
  return event;
}

void install_input_callbacks(GLFWwindow* window) {
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { host_of(w).note_pointer({InputEvent::Kind::pointer}); });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    host_of(w).note_pointer({InputEvent::Kind::button, button, 0, modifiers, action == GLFW_PRESS});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    host_of(w).note({InputEvent::Kind::wheel, 0, 0, 0, false, false, float(x), float(y)});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
    host_of(w).note({InputEvent::Kind::key, key, scancode, modifiers, action != GLFW_RELEASE, action == GLFW_REPEAT});
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    host_of(w).note({InputEvent::Kind::character, int(character)});
  });
}

void install_callbacks(GLFWwindow* window) {
  install_input_callbacks(window);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { host_of(w).note_input(); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { host_of(w).note_input(); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    host_of(w).note_input();
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    host_of(w).note_input();
    ImGui_ImplGlfw_CursorEnterCallback(w, entered);
  });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) {
    host_of(w).note_input();
    host_of(w).state().theme_changed = true;
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    host_of(w).drop(std::vector<std::string>(paths, paths + std::max(count, 0)));
  });
}

float monitor_scale(GLFWwindow* window) {
  float x = 1;
  float y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::clamp(std::max(x, y), 1.0F, 4.0F);
}

/// The pictures folder if there is one, else the home folder.
std::filesystem::path pictures_folder() {
  const char* home = std::getenv("HOME");
  const std::filesystem::path base = home != nullptr ? home : ".";
  const std::filesystem::path pictures = base / "Pictures";
  std::error_code error;
  return std::filesystem::is_directory(pictures, error) ? pictures : base;
}

std::string time_stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32] = {};
  std::strftime(text, sizeof(text), "%Y-%m-%d-%H%M%S", &local);
  return text;
}

}  // namespace

EditorHost::EditorHost(GLFWwindow* window, const Settings& settings, const std::filesystem::path& settings_file)
    : window_(window), commands_(editor_commands(), settings.shortcuts) {
  state_.settings = settings;
  state_.settings_file = settings_file;
  state_.brush = settings.brush;
  take_up_brush(state_);
  state_.view.contours = settings.contours;
  state_.view.opacity = settings.overlay_opacity;
  state_.dialogs.first_steps = !settings.first_steps_closed;
  state_.view.shown[std::size_t(Tab::terrain)] = {MapKind::none};
  state_.view.shown[std::size_t(Tab::climate)] = {MapKind::moisture};
  state_.view.shown[std::size_t(Tab::plants)] = {MapKind::group_cover, int(Stratum::tree)};
  state_.worker = std::make_unique<Worker>();
  if (const auto assets = assets_folder()) {
    if (auto climates = load_climates(*assets / "climates")) state_.climates = std::move(*climates);
  }
  for (const std::string& problem : commands_.problems()) state_.messages.push_back({"A shortcut in the settings", problem});
  glfwSetWindowUserPointer(window_, this);
  install_callbacks(window_);
}

EditorHost::~EditorHost() { glfwSetWindowUserPointer(window_, nullptr); }

void EditorHost::follow_theme() {
  if (!state_.theme_changed && fonts_made_) return;
  state_.theme_changed = false;
  const float scale = state_.settings.scale > 0 ? state_.settings.scale : monitor_scale(window_);
  theme_ = make_theme(state_.settings.dark, scale);
  apply_theme(theme_);
  if (fonts_made_) ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  fonts_made_ = true;
  input_ = true;
}

bool EditorHost::take_input() {
  // Motions come from the whole screen: read in time, or they pile up.
  (void)pen_.pressure();
  const bool input = input_;
  input_ = false;
  return input;
}

void EditorHost::note(const InputEvent& event) {
  input_ = true;
  queue_.push(event);
}

void EditorHost::note_pointer(const InputEvent& event) { note(at_pointer(window_, event, pen_.pressure())); }

void EditorHost::apply(const InputEvent& event) {
  pointer_.follow(event);
  switch (event.kind) {
    case InputEvent::Kind::pointer:
      if (state_.path.held) state_.path.points.push_back({event.x, event.y, event.pressure});
      break;
    case InputEvent::Kind::button:
      ImGui_ImplGlfw_MouseButtonCallback(window_, event.code, event.down ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
      if (event.code != GLFW_MOUSE_BUTTON_LEFT) break;
      if (event.down) state_.path.points.clear();
      state_.path.held = event.down;
      state_.path.points.push_back({event.x, event.y, event.pressure});
      break;
    case InputEvent::Kind::wheel:
      ImGui_ImplGlfw_ScrollCallback(window_, double(event.x), double(event.y));
      break;
    case InputEvent::Kind::key:
      ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode,
                                 !event.down    ? GLFW_RELEASE
                                 : event.repeat ? GLFW_REPEAT
                                                : GLFW_PRESS,
                                 event.modifiers);
      if (event.down) note_key(event);
      break;
    case InputEvent::Kind::character:
      ImGui_ImplGlfw_CharCallback(window_, unsigned(event.code));
      break;
  }
}

void EditorHost::feed_input() {
  bool pressed = false;
  for (const InputEvent& event : queue_.take()) {
    apply(event);
    pressed = pressed || event.kind == InputEvent::Kind::button;
  }
  ImGuiIO& io = ImGui::GetIO();
  for (int button = 0; button < PointerState::buttons; ++button) io.MouseDown[button] = pointer_.down[std::size_t(button)];
  // A click is where it was made, also where the pointer has gone on since.
  if (pressed || !queue_.empty()) io.MousePos = ImVec2(pointer_.x, pointer_.y);
  io.MouseDoubleClickTime = std::max(double_click_seconds, 2.5F * io.DeltaTime);
  if (!queue_.empty()) input_ = true;
}

void EditorHost::note_key(const InputEvent& event) {
  const int modifiers = event.modifiers;
  const Shortcut keys{event.code, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0,
                      (modifiers & GLFW_MOD_ALT) != 0};
  state_.key_presses.push_back({keys, event.repeat});
}

void EditorHost::drop(const std::vector<std::string>& files) {
  input_ = true;
  drop_files(state_, files);
}

bool EditorHost::should_close() {
  if (glfwWindowShouldClose(window_) != 0) {
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    state_.wants_close = true;
  }
  if (state_.wants_close) {
    state_.wants_close = false;
    input_ = true;
    unless_recording_unsaved(state_,
                             [this](EditorState&) { unless_unsaved(state_, [this](EditorState&) { close_agreed_ = true; }); });
  }
  return close_agreed_ && !state_.saving.running();
}

void EditorHost::after_draw(int width, int height) {
  if (state_.wants_screenshot) {
    state_.wants_screenshot = false;
    write_screenshot(width, height);
  }
  if (state_.wants_full_screen) {
    state_.wants_full_screen = false;
    toggle_full_screen();
  }
  follow_title();
  if (autosave_ != nullptr) autosave_->tick(state_, glfwGetTime());
}

void EditorHost::follow_title() {
  const std::string name = document_name(state_);
  const std::string title = name.empty() ? "Biotope" : (state_.dirty() ? "* " : "") + name + " - Biotope";
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title_.c_str());
}

void EditorHost::write_screenshot(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4)};
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  const std::size_t row = std::size_t(width) * 4;
  for (std::size_t y = 0; y < std::size_t(height) / 2; ++y) {
    std::swap_ranges(image.rgba.begin() + std::ptrdiff_t(y * row), image.rgba.begin() + std::ptrdiff_t((y + 1) * row),
                     image.rgba.end() - std::ptrdiff_t((y + 1) * row));
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  const std::filesystem::path file = pictures_folder() / ("biotope-" + time_stamp() + ".png");
  const Status written = write_png(file, image);
  if (written) {
    announce(state_, "Screenshot: " + file.string());
  } else {
    complain(state_, "The screenshot was not written", written.error());
  }
}

void EditorHost::toggle_full_screen() {
  input_ = true;
  if (glfwGetWindowMonitor(window_) != nullptr) {
    glfwSetWindowMonitor(window_, nullptr, before_full_screen_.x, before_full_screen_.y, before_full_screen_.width,
                         before_full_screen_.height, 0);
    return;
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;
  glfwGetWindowPos(window_, &before_full_screen_.x, &before_full_screen_.y);
  glfwGetWindowSize(window_, &before_full_screen_.width, &before_full_screen_.height);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void EditorHost::offer_recovery() {
  const auto left = find_abandoned(state_folder());
  if (!left) return;
  state_.recovery_file = *left;
  state_.dialogs.recovery = true;
}

void EditorHost::remember_window() {
  Settings& settings = state_.settings;
  settings.maximized = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
  if (settings.maximized || glfwGetWindowMonitor(window_) != nullptr) return;
  glfwGetWindowSize(window_, &settings.window_width, &settings.window_height);
}

}  // namespace biotope
