// How long the editor's frames take while a brush paints, a month changes and a landscape is opened: the window's own frame
// (update, panels, 2D map, 3D view), without a window, with the worker computing in the background.
//   bench_frames [SAMPLE] [SECONDS] [map|split]   SAMPLE: valley (1024 x 1024, the default), valley-1m (4096 x 4096);
//                                     seconds of each stroke; only the map, or the map and the 3D view beside it
//   bench_frames SAMPLE 0 answers     only how soon strokes in the 3D view are answered there

#include <epoxy/gl.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "render/offscreen_context.hpp"
#include "tests/bench/drawing_clock.hpp"
#include "ui/editor_actions.hpp"
#include "ui/editor_window.hpp"

using namespace biotope;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int width = 1280;
constexpr int height = 720;
constexpr double frame_seconds = 1.0 / 60;
constexpr double limit = 33;  // ms

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Frames of one part of the script, ms.
struct FrameTimes {
  std::vector<double> whole;
  std::vector<double> computing;  ///< what is left of it without drawing
  std::vector<double> processor;  ///< the same, but only while the window's thread ran: without waits for a core
};

double thread_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

void print_row(const char* what, std::vector<double> times) {
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  const auto share = [&](double part) { return times[std::min(times.size() - 1, std::size_t(part * double(times.size())))]; };
  const auto over = std::count_if(times.begin(), times.end(), [](double t) { return t > limit; });
  std::printf("  %-12s p50 %6.1f  p90 %6.1f  p99 %6.1f  worst %7.1f ms, over %.0f ms: %d of %d\n", what, share(0.5), share(0.9),
              share(0.99), times.back(), limit, int(over), int(times.size()));
}

/// Milliseconds from a stroke's last point to the frame that shows what it changed.
struct Answer {
  double shown = 1e9;   ///< to the end of that frame
  double begun = 1e9;   ///< to its begin
  double before = 1e9;  ///< of `shown`, what was not drawing
  int frames = 0;
};

/// The editor without its window: what app/editor.cpp does in a frame, on a picture in memory.
class Bench {
 public:
  Bench() : target_(width, height) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(float(width), float(height));
    ImGui_ImplOpenGL3_Init("#version 450 core");
    theme_ = make_theme(true, 1);
    apply_theme(theme_);
    ImGui_ImplOpenGL3_CreateFontsTexture();
    auto window = EditorWindow::create();
    if (!window) {
      std::printf("%s\n", window.error().message.c_str());
      std::exit(1);
    }
    window_ = std::move(*window);
    state_.worker = std::make_unique<Worker>();
    state_.view.shown[std::size_t(Tab::terrain)] = {MapKind::none};
    state_.view.shown[std::size_t(Tab::climate)] = {MapKind::moisture};
    state_.view.shown[std::size_t(Tab::plants)] = {MapKind::group_cover, int(Stratum::tree)};
  }
  ~Bench() {
    window_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  EditorState& state() { return state_; }

  void frame(FrameTimes& times) {
    const auto begin = Clock::now();
    const double ran = thread_milliseconds();
    drawing_.restart();
    ImGuiIO& io = ImGui::GetIO();
    const double passed = std::max(milliseconds_since(frame_begun_) / 1000, 1e-4);
    frame_begun_ = begin;
    io.DeltaTime = float(passed);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    now_ += passed;
    update(state_, now_, passed);
    window_->draw({state_, theme_, commands_});
    ImGui::Render();
    target_.bind();
    {
      const DrawingClock::Part panels;
      ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }
    glFinish();
    const double whole = milliseconds_since(begin);
    times.whole.push_back(whole);
    times.computing.push_back(std::max(0.0, whole - drawing_.milliseconds()));
    times.processor.push_back(std::max(0.0, thread_milliseconds() - ran - drawing_.thread_milliseconds()));
    const double rest = frame_seconds - whole / 1000;
    if (rest > 0) std::this_thread::sleep_for(std::chrono::duration<double>(rest));
  }

  /// Frames until `done`, at most `seconds`.
  void run_until(FrameTimes& times, double seconds, const std::function<bool()>& done) {
    const auto begin = Clock::now();
    while (milliseconds_since(begin) < 1000 * seconds && !done()) frame(times);
  }

  bool settled() const {
    return state_.has_document && state_.shown && state_.shown->complete &&
           state_.posted_revision == state_.shown->document_revision && !animates(state_) && !state_.counting.running() &&
           !window_->refining();
  }

  /// A short stroke at a place of the window, and how soon the frame comes that shows its ground and plants, all of them.
  Answer answer(ImVec2 at) {
    ImGuiIO& io = ImGui::GetIO();
    FrameTimes times;
    Clock::time_point last;
    for (int i = 0; i < 6; ++i) {
      io.MousePos = ImVec2(at.x + 4 * float(i), at.y);
      if (i > 0) io.MouseDown[0] = true;
      state_.path.held = i > 0;
      if (i > 0) state_.path.points.push_back({io.MousePos.x, io.MousePos.y, 1.0F});
      last = Clock::now();
      frame(times);
    }
    const std::uint64_t wanted = state_.posted_revision + (state_.must_post ? 1 : 0);
    io.MouseDown[0] = false;
    state_.path.held = false;
    double drawing = times.whole.back() - times.computing.back();
    for (int frames = 1; milliseconds_since(last) < 20000; ++frames) {
      const double begun = milliseconds_since(last);
      frame(times);
      drawing += times.whole.back() - times.computing.back();
      // The pause after the frame that shows it is not waited for.
      const double shown = begun + times.whole.back();
      if (window_->landscape().answered() >= wanted) return {shown, begun, shown - drawing, frames};
    }
    return {};
  }

  /// A brush in circles over the map for some seconds.
  void stroke(FrameTimes& times, double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    const auto begin = Clock::now();
    const bool split = state_.view.mode == ViewMode::split;
    const ImVec2 middle(split ? 240.0F : 460.0F, 350);
    while (milliseconds_since(begin) < 1000 * seconds) {
      const double turn = milliseconds_since(begin) / 1000 * 1.7;
      const double radius = 60 + 50 * std::sin(turn * 0.23);
      io.MousePos = ImVec2(middle.x + float(radius * std::cos(turn)), middle.y + float(radius * std::sin(turn)));
      if (!io.MouseDown[0]) state_.path.points.clear();
      io.MouseDown[0] = true;
      state_.path.held = true;
      state_.path.points.push_back({io.MousePos.x, io.MousePos.y, 1.0F});
      frame(times);
    }
    io.MouseDown[0] = false;
    state_.path.held = false;
    frame(times);
    io.MousePos = ImVec2(-1000, -1000);
  }

 private:
  RenderTarget target_;
  EditorState state_;
  Theme theme_;
  CommandTable commands_{editor_commands(), {}};
  std::unique_ptr<EditorWindow> window_;
  DrawingClock drawing_;
  double now_ = 0;
  Clock::time_point frame_begun_ = Clock::now();
};

/// Memory of the process, MB; 0 where it is not told.
double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double size = 0;
  double resident = 0;
  file >> size >> resident;
  return resident * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

void report(const char* name, const FrameTimes& times) {
  std::printf("%s (%.0f MB resident)\n", name, resident_megabytes());
  print_row("whole", times.whole);
  print_row("computing", times.computing);
  print_row("processor", times.processor);
  std::fflush(stdout);
}

/// Chooses what the brush paints.
void choose_plant(EditorState& state) {
  select_species(state, state.web()->levels[0].front());
  state.view.tab = Tab::plants;
  state.view.shown[std::size_t(Tab::plants)] = {MapKind::plant_cover, state.selected_species};
}
void choose_moisture(EditorState& state) {
  state.view.tab = Tab::climate;
  state.view.shown[std::size_t(Tab::climate)] = {MapKind::moisture};
}

void choose_ground(EditorState& state) {
  state.view.tab = Tab::terrain;
  state.view.shown[std::size_t(Tab::terrain)] = {MapKind::none};
}

/// What a stroke paints.
struct Part {
  const char* name;
  void (*choose)(EditorState&);
  Tool more = Tool::add;
  Tool less = Tool::erase;
};

void measure(const std::string& sample, ViewMode mode, double seconds) {
  std::printf("%s, %s view\n", sample.c_str(), mode == ViewMode::map ? "map" : "split");
  Bench bench;
  EditorState& state = bench.state();
  state.view.mode = mode;
  const auto settle = [&](FrameTimes& times) { bench.run_until(times, 120, [&] { return bench.settled(); }); };
  FrameTimes opening;
  open(state, "sample:" + sample);
  settle(opening);
  report("opening", opening);
  if (!state.has_document) {
    std::printf("'%s' is no sample\n", sample.c_str());
    return;
  }
  state.tool = Tool::add;
  state.brush.radius = 40 * float(state.document.terrain->height.width()) / 1024;
  for (const Part& part : {Part{"plant stroke", choose_plant}, Part{"moisture stroke", choose_moisture}}) {
    part.choose(state);
    FrameTimes choosing;
    bench.run_until(choosing, 1, [] { return false; });
    FrameTimes times;
    bench.stroke(times, seconds);
    report(part.name, times);
    FrameTimes after;
    settle(after);
    report("  and after it, until all is settled", after);
  }
  FrameTimes season;
  for (int month = 6; month < 10; ++month) {
    state.clock.month = month;
    bench.run_until(season, 1.5, [] { return false; });
  }
  report("month changes", season);
}

/// Strokes in the 3D view, answered there.
void measure_answers(const std::string& sample, int strokes) {
  std::printf("%s, 3D view: from a stroke's last point to its plants\n", sample.c_str());
  Bench bench;
  EditorState& state = bench.state();
  state.view.mode = ViewMode::landscape;
  FrameTimes times;
  const auto settle = [&] { bench.run_until(times, 120, [&] { return bench.settled(); }); };
  open(state, "sample:" + sample);
  settle();
  if (!state.has_document) return;
  state.brush.radius = 10;
  for (const Part& part : {Part{"plants", choose_plant}, Part{"ground", choose_ground, Tool::raise, Tool::lower}}) {
    part.choose(state);
    std::vector<Answer> took;
    for (int i = 0; i < strokes; ++i) {
      state.tool = i % 2 == 0 ? part.more : part.less;
      settle();
      took.push_back(bench.answer(ImVec2(460, 480)));
    }
    std::sort(took.begin(), took.end(), [](const Answer& a, const Answer& b) { return a.shown < b.shown; });
    for (const auto& [which, one] :
         {std::pair("fastest", took.front()), {"p50", took[took.size() / 2]}, {"worst", took.back()}}) {
      std::printf("  %-8s %-8s its frame begins after %6.1f, ends after %6.1f ms (%d frames); not drawing: %6.1f ms\n", part.name,
                  which, one.begun, one.shown, one.frames, one.before);
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::string sample = count > 1 ? arguments[1] : "valley";
  const double seconds = count > 2 ? std::atof(arguments[2]) : 20;
  const auto context = OffscreenContext::create();
  if (!context) {
    std::printf("%s\n", context.error().message.c_str());
    return 1;
  }
  std::printf("drawn by %s\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  if (count > 3 && std::string(arguments[3]) == "answers") {
    measure_answers(sample, 12);
    return 0;
  }
  const std::string only = count > 3 ? arguments[3] : "";
  if (only != "split") measure(sample, ViewMode::map, seconds);
  if (only != "map") measure(sample, ViewMode::split, seconds);
  return 0;
}
