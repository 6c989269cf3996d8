#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/pen.hpp"
#include "ui/autosave.hpp"
#include "ui/commands.hpp"
#include "ui/editor_state.hpp"
#include "ui/input_queue.hpp"
#include "ui/theme.hpp"

struct GLFWwindow;

namespace biotope {

/// What ties the editor to its window: events, theme and scale, full screen, screenshots, closing, autosave.
class EditorHost {
 public:
  EditorHost(GLFWwindow* window, const Settings& settings, const std::filesystem::path& settings_file);
  ~EditorHost();
  EditorHost(const EditorHost&) = delete;
  EditorHost& operator=(const EditorHost&) = delete;

  [[nodiscard]] GLFWwindow* window() const { return window_; }
  [[nodiscard]] EditorState& state() { return state_; }
  [[nodiscard]] const Theme& theme() const { return theme_; }
  [[nodiscard]] const CommandTable& commands() const { return commands_; }

  /// Before a frame: makes fonts and colours again when theme or scale changed.
  void follow_theme();
  /// After a frame is drawn and before it is shown: screenshot, full screen, autosave.
  void after_draw(int width, int height);
  /// True, once, when there was input since it was last asked.
  [[nodiscard]] bool take_input();
  /// True when the window may close: asked to, and no unsaved work or the person has answered.
  [[nodiscard]] bool should_close();
  void set_autosave(Autosave* autosave) { autosave_ = autosave; }
  /// Offers the work of an editor that ended without saving.
  void offer_recovery();
  /// Takes the window's size into the settings.
  void remember_window();

  /// After the backend began a frame and before Dear ImGui does: the input of this frame.
  void feed_input();

  /// For GLFW's callbacks.
  void note_input() { input_ = true; }
  void note(const InputEvent& event);
  /// A motion or a button, where the pointer is now.
  void note_pointer(const InputEvent& event);
  void drop(const std::vector<std::string>& files);

 private:
  void apply(const InputEvent& event);
  void note_key(const InputEvent& event);
  void write_screenshot(int width, int height);
  void toggle_full_screen();
  void follow_title();

  GLFWwindow* window_;
  EditorState state_;
  Pen pen_;
  Theme theme_;
  CommandTable commands_;
  Autosave* autosave_ = nullptr;
  InputQueue queue_;
  PointerState pointer_;
  bool input_ = true;
  std::string title_;
  bool close_agreed_ = false;
  bool fonts_made_ = false;
  struct Placement {
    int x = 0, y = 0, width = 1280, height = 720;
  };
  Placement before_full_screen_;
};

}  // namespace biotope
