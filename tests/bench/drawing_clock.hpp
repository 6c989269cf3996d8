#pragma once

#include <epoxy/gl.h>

namespace biotope {

/// Counts the time that goes into OpenGL's drawing commands, so that the rest of a frame can be told from it: on a machine
/// without a graphics card the processor draws too, and makes and frees the memory of textures. One at a time may live; it puts
/// itself between the program and OpenGL.
class DrawingClock {
 public:
  DrawingClock();
  ~DrawingClock();
  DrawingClock(const DrawingClock&) = delete;
  DrawingClock& operator=(const DrawingClock&) = delete;

  /// While it lives, time counts as drawing.
  class Part {
   public:
    Part();
    ~Part();
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    double begin_;
    double ran_;
  };

  void restart();
  /// Time of drawing since restart().
  [[nodiscard]] double milliseconds() const;
  /// The part of it that the calling thread ran.
  [[nodiscard]] double thread_milliseconds() const;
};

}  // namespace biotope
