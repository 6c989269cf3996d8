#include "ui/autosave.hpp"

#include <sys/resource.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>

#include "ui/editor_actions.hpp"

namespace biotope {
namespace {

constexpr std::string_view prefix = "recovery-";
/// Of the writing thread: behind the window, before the maps. Our choice.
constexpr int niceness = 5;

/// Whose a recovery file is. A process is known by its number and when it started, since numbers are used again.
struct Owner {
  int process = 0;
  std::string start;  ///< clock ticks since the machine started; empty in files of older versions
};

/// Nothing when it is no recovery file's name.
std::optional<Owner> owner_of(const std::filesystem::path& file) {
  const std::string name = file.stem().string();
  if (file.extension() != ".biotope" || !name.starts_with(prefix)) return std::nullopt;
  Owner owner;
  const char* const end = name.data() + name.size();
  const auto [last, error] = std::from_chars(name.data() + prefix.size(), end, owner.process);
  if (error != std::errc() || owner.process <= 0 || (last != end && *last != '-')) return std::nullopt;
  if (last != end) owner.start.assign(last + 1, end);
  return owner;
}

/// What the system tells of a process.
struct ProcessFacts {
  std::string name;
  char state = 'Z';
  std::string start;
};

/// Nothing when there is no such process. See proc(5), /proc/[pid]/stat: the name in brackets, then the state, and the start as
/// field 22.
std::optional<ProcessFacts> process_facts(const std::string& process) {
  std::ifstream in("/proc/" + process + "/stat");
  std::string line;
  std::getline(in, line);
  const std::size_t begin = line.find('(');
  const std::size_t end = line.rfind(')');
  if (begin == std::string::npos || end == std::string::npos) return std::nullopt;
  ProcessFacts facts;
  facts.name = line.substr(begin + 1, end - begin - 1);
  std::istringstream fields(line.substr(end + 1));
  fields >> facts.state;
  for (int field = 4; field <= 22; ++field) fields >> facts.start;
  return facts;
}

/// True while that process is an editor: a number may have passed to another program, and an ended one may still be listed.
bool runs(const Owner& owner) {
  const auto facts = process_facts(std::to_string(owner.process));
  if (!facts || facts->state == 'Z') return false;
  if (!owner.start.empty()) return owner.start == facts->start;
  const auto own = process_facts("self");
  return own && facts->name == own->name;
}

std::string own_name() {
  const auto own = process_facts("self");
  return std::string(prefix) + std::to_string(getpid()) + (own ? "-" + own->start : "") + ".biotope";
}

/// Halves of copies whose writing was cut off.
void remove_leftovers(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> leftovers;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    const std::string start = "." + std::string(prefix);
    const std::size_t end = name.find(".tmp.biotope");
    if (!name.starts_with(start) || end == std::string::npos) continue;
    // .recovery-<process>-<start>-<writer>-<count>.tmp.biotope
    const auto owner = owner_of(name.substr(1, name.find('-', start.size()) - 1) + ".biotope");
    if (owner && !process_facts(std::to_string(owner->process))) leftovers.push_back(entry.path());
  }
  for (const auto& file : leftovers) std::filesystem::remove(file, error);
}

}  // namespace

Autosave::Autosave(const std::filesystem::path& folder) : file_(folder / own_name()) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  remove_leftovers(folder);
}

Autosave::~Autosave() {
  writing_.cancel();
  drop();
}

void Autosave::drop() {
  std::error_code error;
  std::filesystem::remove(file_, error);
  there_ = false;
  written_edits_ = 0;
  written_stroking_ = false;
  cache_ = std::make_shared<SceneCache>();
}

void Autosave::finish_writing(EditorState& state) {
  const auto written = writing_.take();
  if (!written) return;
  if (*written) {
    there_ = true;
    told_ = false;
    return;
  }
  // Tried again after the usual time, but told only once: the disk may have room by then.
  written_edits_ = 0;
  if (!std::exchange(told_, true)) complain(state, "Autosave does not work", written->error());
}

/// Rescued work goes from the disk once it is in this editor's own copy, or saved, or given up. Where it was thrown away, what
/// other sessions left is offered next.
void Autosave::retire_rescued(EditorState& state) const {
  if (state.recovery_file.empty() || state.dialogs.recovery || state.loading.running()) return;
  std::error_code error;
  if (!std::filesystem::exists(state.recovery_file, error)) {
    state.recovery_file.clear();
    const auto next = find_abandoned(file_.parent_path());
    if (!next) return;
    state.recovery_file = *next;
    state.dialogs.recovery = true;
  } else if (!state.rescued) {
    // The question was closed without an answer: it is asked again the next time.
    state.recovery_file.clear();
  } else if (there_ || !state.dirty()) {
    std::filesystem::remove(state.recovery_file, error);
    state.recovery_file.clear();
    state.rescued = false;
  }
}

void Autosave::start_writing(const EditorState& state) {
  written_edits_ = state.edits;
  written_stroking_ = state.painting.stroking();
  writing_.start("Autosave",
                 [file = file_, document = state.document, cache = cache_,
                  views = saved_views_to_json(state.views)](const TaskContext&) -> Result<bool> {
                   // The window comes first: one thread, behind the others; not so far that other programs could starve it.
                   setpriority(PRIO_PROCESS, 0, std::min(19, getpriority(PRIO_PROCESS, 0) + niceness));
                   Status saved;
                   tbb::task_arena one_thread(1);
                   one_thread.execute([&] { saved = save_scene(file, document, cache.get(), views); });
                   if (!saved) return tl::unexpected(saved.error());
                   return true;
                 });
}

void Autosave::tick(EditorState& state, double now) {
  finish_writing(state);
  retire_rescued(state);
  const bool stroking = state.has_document && state.painting.stroking();
  if (!state.dirty() && !stroking) {
    due_.reset();
    if (there_ && !writing_.running() && !state.saving.running()) drop();
    return;
  }
  const bool changed = stroking || written_stroking_ || state.edits != written_edits_;
  if (!changed) return;
  // Counted while a copy is still being written too: a slow disk must not make the next one later.
  if (!due_) due_ = now + double(state.settings.autosave_seconds);
  if (now < *due_ || writing_.running()) return;
  due_.reset();
  start_writing(state);
}

std::vector<std::filesystem::path> abandoned_files(const std::filesystem::path& folder) {
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const auto owner = owner_of(entry.path());
    if (!owner || runs(*owner)) continue;
    found.emplace_back(entry.last_write_time(error), entry.path());
  }
  std::sort(found.begin(), found.end(), std::greater<>());
  std::vector<std::filesystem::path> files;
  for (auto& [time, file] : found) files.push_back(std::move(file));
  return files;
}

std::optional<std::filesystem::path> find_abandoned(const std::filesystem::path& folder) {
  const auto files = abandoned_files(folder);
  if (files.empty()) return std::nullopt;
  return files.front();
}

}  // namespace biotope
