#include "core/exchange/edit_script_files.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/edit_script_open.hpp"
#include "core/exchange/height_source.hpp"
#include "core/exchange/scene_raster.hpp"

namespace biotope {
namespace {

/// A script of a long day is a few megabytes. Our choice.
constexpr std::size_t most_script_bytes = std::size_t(256) << 20;

/// Calls `use` with every file name of an entry; it may change the name.
void for_each_file(ScriptEntry& entry, const std::function<void(std::string&)>& use) {
  const auto with_name = [&](std::string& name) {
    if (!name.empty()) use(name);
  };
  if (auto* stroke = std::get_if<StrokeEntry>(&entry.what)) with_name(stroke->stamp);
  if (auto* fill = std::get_if<FillEntry>(&entry.what)) with_name(fill->stamp);
  if (auto* image = std::get_if<ImageEntry>(&entry.what)) with_name(image->file);
  if (auto* mix = std::get_if<MixEntry>(&entry.what)) with_name(mix->file);
  if (auto* mask = std::get_if<MaskEntry>(&entry.what)) with_name(mask->file);
  if (auto* lock = std::get_if<LockEntry>(&entry.what)) with_name(lock->file);
  if (auto* open = std::get_if<OpenEntry>(&entry.what)) with_name(open->file);
  if (auto* group = std::get_if<GroupEntry>(&entry.what)) {
    for (ScriptEntry& part : group->entries) for_each_file(part, use);
  }
}

Status write_attachment(const std::filesystem::path& file, const Result<std::string>& bytes) {
  if (!bytes) return fail(file.string() + ": " + bytes.error().message);
  return write_text(file, *bytes);
}

}  // namespace

std::vector<std::string> files_of(const ScriptEntry& entry) {
  std::vector<std::string> names;
  ScriptEntry copy = entry;
  for_each_file(copy, [&](const std::string& name) { names.push_back(name); });
  return names;
}

Status save_edit_script(const std::filesystem::path& file, EditScript script, const ScriptAttachments& attachments) {
  const std::string inside = file.stem().string() + "-files";
  const std::filesystem::path folder = file.parent_path() / inside;
  if (!attachments.empty()) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(folder.string() + ": the folder cannot be made (" + error.message() + ").");
  }
  std::set<std::string> used;
  for (const ScriptEntry& entry : script.entries) {
    for (std::string& name : files_of(entry)) used.insert(std::move(name));
  }
  const auto write_used = [&](const auto& held, const auto& encode) -> Status {
    for (const auto& [name, object] : held) {
      if (!used.contains(name)) continue;
      if (Status written = write_attachment(folder / name, encode(*object)); !written) return written;
    }
    return {};
  };
  const auto encode_raster = [](const Grid<float>& raster) { return encode_floats(raster, {}); };
  if (Status written = write_used(attachments.rasters, encode_raster); !written) return written;
  if (Status written = write_used(attachments.paints, encode_paint); !written) return written;
  if (Status written = write_used(attachments.masks, encode_selection); !written) return written;
  std::map<std::string, std::string> brought;
  for (ScriptEntry& entry : script.entries) {
    if (auto* open = std::get_if<OpenEntry>(&entry.what); open != nullptr && !open->file.empty()) {
      std::string& beside = brought[open->file];
      if (beside.empty()) {
        auto name = bring_beside(open->file, file.parent_path(), inside);
        if (!name) return tl::unexpected(name.error());
        beside = std::move(*name);
      }
      open->file = beside;
      continue;
    }
    for_each_file(entry, [&](std::string& name) {
      if (attachments.contains(name)) name = inside + "/" + name;
    });
  }
  return write_text(file, edit_script_to_json(script));
}

Result<std::filesystem::path> script_file(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path base = folder.empty() ? std::filesystem::path(".") : folder;
  const std::filesystem::path path = base / name;
  if (Status readable = check_readable(path); !readable) return tl::unexpected(readable.error());
  std::error_code error;
  const auto home = std::filesystem::canonical(base, error);
  const auto real = error ? std::filesystem::path() : std::filesystem::canonical(path, error);
  if (error) return fail(path.string() + ": cannot be read (" + error.message() + ").");
  const auto [mismatch, unused] = std::mismatch(home.begin(), home.end(), real.begin(), real.end());
  if (mismatch != home.end()) return fail(path.string() + ": leads out of the script's folder.");
  return path;
}

Result<EditScript> load_edit_script(const std::filesystem::path& file) {
  if (Status readable = check_readable(file); !readable) return tl::unexpected(readable.error());
  const auto text = read_text(file, most_script_bytes);
  if (!text) return tl::unexpected(text.error());
  auto script = parse_edit_script(*text, file.filename().string());
  if (!script) return script;
  for (std::size_t i = 0; i < script->entries.size(); ++i) {
    for (const std::string& name : files_of(script->entries[i])) {
      if (const auto found = script_file(file.parent_path(), name); !found) {
        return fail(file.filename().string() + ": edit " + std::to_string(i + 1) + " (" + entry_kind(script->entries[i]) +
                    "): " + found.error().message);
      }
    }
  }
  return script;
}

}  // namespace biotope
