#include "ui/autosave.hpp"

#include <unistd.h>

#include <charconv>
#include <fstream>
#include <string>

#include "core/exchange/scene_file.hpp"
#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

constexpr std::string_view prefix = "recovery-";

/// The process number in a recovery file's name; 0 when it is no such name.
int process_of(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  if (file.extension() != ".biotope" || !name.starts_with(prefix)) return 0;
  int process = 0;
  const char* end = name.data() + name.size();
  const auto [last, error] = std::from_chars(name.data() + prefix.size(), end, process);
  return error == std::errc() && last == end ? process : 0;
}

/// Name and state of a process as the system tells them ("biotope) S"); empty when there is none.
std::string process_line(const std::string& process) {
  std::ifstream in("/proc/" + process + "/stat");
  std::string line;
  std::getline(in, line);
  const std::size_t begin = line.find('(');
  const std::size_t end = line.rfind(')');
  return begin == std::string::npos || end == std::string::npos || end + 2 >= line.size()
             ? std::string()
             : line.substr(begin + 1, end - begin + 2);
}

/// True while that process is an editor: a number may have passed to another program, and an ended one may still be listed.
bool runs(int process) {
  const std::string line = process_line(std::to_string(process));
  if (line.empty() || line.back() == 'Z') return false;
  const std::string own = process_line("self");
  return line.substr(0, line.size() - 1) == own.substr(0, own.size() - 1);
}

}  // namespace

Autosave::Autosave(const std::filesystem::path& folder)
    : file_(folder / (std::string(prefix) + std::to_string(getpid()) + ".biotope")) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
}

Autosave::~Autosave() {
  writing_.cancel();
  drop();
}

void Autosave::drop() {
  std::error_code error;
  std::filesystem::remove(file_, error);
  written_edits_ = 0;
}

void Autosave::tick(EditorState& state, double now) {
  const auto written = writing_.take();
  if (written && !*written && !told_) {
    told_ = true;  // once is enough; the next try may succeed
    complain(state, "Autosave does not work", written->error());
  }
  const bool safe = (written && *written) || !state.dirty();
  if (safe && !state.recovery_file.empty() && !state.dialogs.recovery && !state.loading.running()) {
    // Rescued work is in this editor's own copy, or saved, or given up.
    std::error_code error;
    std::filesystem::remove(state.recovery_file, error);
    state.recovery_file.clear();
  }
  if (!state.dirty()) {
    if (written_edits_ != 0 && !writing_.running()) drop();
    return;
  }
  const bool changed = state.edits != written_edits_;
  if (!changed || writing_.running() || state.painting.stroking() || now - last_ < autosave_seconds) return;
  last_ = now;
  written_edits_ = state.edits;
  writing_.start("Autosave", [file = file_, document = state.document](const TaskContext&) -> Result<bool> {
    const Status saved = save_scene(file, document);
    if (!saved) return tl::unexpected(saved.error());
    return true;
  });
}

std::optional<std::filesystem::path> find_abandoned(const std::filesystem::path& folder) {
  std::optional<std::filesystem::path> newest;
  std::filesystem::file_time_type newest_time{};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const int process = process_of(entry.path());
    if (process == 0 || runs(process)) continue;
    const auto time = entry.last_write_time(error);
    if (newest && time <= newest_time) continue;
    newest = entry.path();
    newest_time = time;
  }
  return newest;
}

}  // namespace biotope
