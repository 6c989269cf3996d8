#pragma once

#include <memory>

namespace biotope {

/// How hard a tablet's pen is pressed, which GLFW does not tell. Read from the X server's own events (XInput 2), which Wayland's
/// X server passes on too; without an X server, without the extension or without a tablet everything counts as pressed wholly.
class Pen {
 public:
  Pen();
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  /// 0..1 as of the newest motion; 1 when what moved last has no pressure (a mouse). To be asked every frame: it reads what
  /// waits.
  [[nodiscard]] float pressure();

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

/// Share of an axis that runs from `least` to `most`, 0..1; 1 for an axis without a range.
[[nodiscard]] float axis_share(double value, double least, double most);

}  // namespace biotope
