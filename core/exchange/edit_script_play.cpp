#include "core/exchange/edit_script_play.hpp"

#include <limits>
#include <map>
#include <stop_token>
#include <utility>

#include "core/exchange/atomic_file.hpp"
#include "core/exchange/edit_script_files.hpp"
#include "core/exchange/edit_script_open.hpp"
#include "core/exchange/layer_image.hpp"
#include "core/exchange/scene_raster.hpp"
#include "core/pipeline/edit_grounds.hpp"

namespace biotope {
namespace {

class SharedCommand final : public Command {
 public:
  explicit SharedCommand(std::shared_ptr<const Command> command) : command_(std::move(command)) {}
  [[nodiscard]] std::string name() const override { return command_->name(); }
  void apply(Document& document) const override { command_->apply(document); }
  void revert(Document& document) const override { command_->revert(document); }
  [[nodiscard]] std::size_t bytes() const override { return command_->bytes(); }

 private:
  std::shared_ptr<const Command> command_;
};

using CommandPointer = std::unique_ptr<Command>;

/// More than the paint of the largest terrain takes.
constexpr std::size_t most_paint_bytes = std::size_t(1) << 32;

/// Solves a document as far as an edit's needs go. What is finished by then stays in the cache.
Result<std::shared_ptr<const MapsSnapshot>> solve_as_far_as(const EditNeeds& needs, const Document& document, SolveCache& cache,
                                                            const TaskContext& context) {
  auto bare = std::make_shared<MapsSnapshot>();
  bare->document = document;
  if (holds(*bare, needs)) return bare;
  std::shared_ptr<const MapsSnapshot> reached;
  std::stop_source enough;
  const std::stop_callback forward(context.stop, [&enough] { enough.request_stop(); });
  TaskContext inner;
  inner.stop = enough.get_token();
  auto solved = solve(document, &cache, inner, [&](std::shared_ptr<const MapsSnapshot> snapshot) {
    if (reached || !holds(*snapshot, needs)) return;
    reached = std::move(snapshot);
    enough.request_stop();
  });
  if (context.stopped()) return fail(stopped_message);
  if (reached) return reached;
  return solved;
}

/// Plays the entries of one script.
class Player {
 public:
  Player(Document document, const PlayOptions& options, SolveCache& cache, const TaskContext& context)
      : document_(std::move(document)), options_(options), cache_(cache), context_(context) {}

  /// Plays one entry; says what it did.
  Result<PlayedEntry> play(const ScriptEntry& entry, const std::string& where) {
    PlayedEntry played;
    if (const auto* undo = std::get_if<UndoEntry>(&entry.what)) return go(-undo->steps, where);
    if (const auto* redo = std::get_if<RedoEntry>(&entry.what)) return go(redo->steps, where);
    if (const auto* open = std::get_if<OpenEntry>(&entry.what)) return begin_anew(*open, where);
    auto command = command_of(document_, entry, where);
    if (!command) return tl::unexpected(command.error());
    played.command = std::move(*command);
    history_.perform(document_, shared_command(played.command));
    return played;
  }

  [[nodiscard]] const Document& document() const { return document_; }
  [[nodiscard]] Document take_document() { return std::move(document_); }

 private:
  Result<PlayedEntry> begin_anew(const OpenEntry& entry, const std::string& where) {
    auto opened = open_entry(entry, options_.folder, context_);
    if (!opened && context_.stopped()) return fail(stopped_message);
    if (!opened) return fail(where + ": " + opened.error().message);
    document_ = std::move(*opened);
    history_.clear();
    stamps_.clear();
    PlayedEntry played;
    played.opened = std::make_shared<const Document>(document_);
    return played;
  }

  Result<PlayedEntry> go(int steps, const std::string& where) {
    for (int i = 0; i < std::abs(steps); ++i) {
      if (steps < 0 ? history_.undo(document_) : history_.redo(document_)) continue;
      return fail(where + ": there is nothing left to " + (steps < 0 ? "undo" : "redo") + " after " + std::to_string(i) + " of " +
                  std::to_string(std::abs(steps)) + " steps.");
    }
    PlayedEntry played;
    played.steps = steps;
    return played;
  }

  /// The command of an entry on `document`; an empty one where nothing changes.
  Result<CommandPointer> command_of(const Document& document, const ScriptEntry& entry, const std::string& where) {
    if (const auto* group = std::get_if<GroupEntry>(&entry.what)) return group_command(document, *group, where);
    const auto edit = edit_of(document, entry, where);
    if (!edit) return tl::unexpected(edit.error());
    const EditNeeds needs = needs_of(*edit);
    auto maps = solve_as_far_as(needs, document, cache_, context_);
    if (!maps) {
      if (context_.stopped()) return tl::unexpected(maps.error());
      return fail(where + ": " + maps.error().message);
    }
    auto command = make_command(document, *edit, edit_grounds(*maps, needs));
    if (!command) return fail(where + ": " + command.error().message);
    if (!*command) return std::make_unique<GroupCommand>(edit_name(*edit, document), std::vector<CommandPointer>{});
    return command;
  }

  Result<CommandPointer> group_command(const Document& document, const GroupEntry& group, const std::string& where) {
    Document changed = document;
    std::vector<CommandPointer> commands;
    for (std::size_t i = 0; i < group.entries.size(); ++i) {
      const std::string place = where + ", part " + std::to_string(i + 1) + " (" + entry_kind(group.entries[i]) + ")";
      auto command = command_of(changed, group.entries[i], place);
      if (!command) return command;
      (*command)->apply(changed);
      commands.push_back(std::move(*command));
    }
    return std::make_unique<GroupCommand>(group.name.empty() ? "Several changes" : group.name, std::move(commands));
  }

  Result<Edit> edit_of(const Document& document, const ScriptEntry& entry, const std::string& where) {
    if (const auto* stroke = std::get_if<StrokeEntry>(&entry.what)) return with_stamp(*stroke, where);
    if (const auto* fill = std::get_if<FillEntry>(&entry.what)) return with_stamp(*fill, where);
    if (const auto* select = std::get_if<SelectEdit>(&entry.what)) return *select;
    if (const auto* clear = std::get_if<ClearEdit>(&entry.what)) return *clear;
    if (const auto* image = std::get_if<ImageEntry>(&entry.what)) return image_edit(document, *image, where);
    if (const auto* mix = std::get_if<MixEntry>(&entry.what)) return mix_edit(document, *mix, where);
    if (const auto* mask = std::get_if<MaskEntry>(&entry.what)) return mask_edit(document, *mask, where);
    if (const auto* lock = std::get_if<LockEntry>(&entry.what)) return lock_edit(document, *lock, where);
    return parts_edit(document, std::get<PartsPatch>(entry.what), where);
  }

  template <class Entry>
  Result<Edit> with_stamp(const Entry& entry, const std::string& where) {
    auto edit = entry.edit;
    if (entry.stamp.empty()) return edit;
    auto& stamp = stamps_[entry.stamp];
    if (!stamp) {
      const auto file = script_file(options_.folder, entry.stamp);
      if (!file) return fail(where + ": " + file.error().message);
      auto read = read_stamp(*file);
      if (!read) return fail(where + ": " + read.error().message);
      stamp = std::make_shared<const Grid<float>>(std::move(*read));
    }
    edit.brush.stamp = stamp;
    return edit;
  }

  Result<Edit> image_edit(const Document& document, const ImageEntry& entry, const std::string& where) {
    const auto file = script_file(options_.folder, entry.file);
    if (!file) return fail(where + ": " + file.error().message);
    std::optional<ValueRange> range;
    if (entry.low || entry.high) {
      const ValueRange usual = usual_range(entry.layer).value_or(ValueRange{});
      range = ValueRange{entry.low.value_or(usual.low), entry.high.value_or(usual.high)};
    }
    auto values = read_layer_image(*file, entry.layer, *document.terrain, range);
    if (!values) return fail(where + ": " + values.error().message);
    return ImageEdit{entry.layer, std::make_shared<const Grid<float>>(std::move(*values)), entry.file, entry.opacity,
                     entry.filter};
  }

  Result<Edit> mix_edit(const Document& document, const MixEntry& entry, const std::string& where) {
    MixEdit edit{entry.into, entry.from, nullptr, entry.mix};
    if (entry.file.empty()) return edit;
    const auto bytes = file_bytes(entry.file, where);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto& height = document.terrain->height;
    auto paint = decode_paint(*bytes, height.width(), height.height(), entry.file);
    if (!paint) return fail(where + ": " + paint.error().message);
    edit.paint = std::make_shared<const PaintLayer>(std::move(*paint));
    return edit;
  }

  Result<Edit> mask_edit(const Document& document, const MaskEntry& entry, const std::string& where) {
    std::shared_ptr<const SelectionMask> selection;
    if (!entry.file.empty()) {
      auto mask = read_mask(document, entry.file, where);
      if (!mask) return tl::unexpected(mask.error());
      selection = std::move(*mask);
    }
    return PartsEdit{"Select", [selection](Document& target) { target.selection = selection; }};
  }

  Result<Edit> lock_edit(const Document& document, const LockEntry& entry, const std::string& where) {
    if (entry.file.empty()) return entry.edit;
    const auto mask = read_mask(document, entry.file, where);
    if (!mask) return tl::unexpected(mask.error());
    return PartsEdit{"Lock", [locked = *mask](Document& target) { target.locked_area = locked; }};
  }

  [[nodiscard]] Result<std::shared_ptr<const SelectionMask>> read_mask(const Document& document, const std::string& file,
                                                                       const std::string& where) const {
    const auto bytes = file_bytes(file, where);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto& height = document.terrain->height;
    auto mask = decode_selection(*bytes, height.width(), height.height(), file);
    if (!mask) return fail(where + ": " + mask.error().message);
    return std::make_shared<const SelectionMask>(std::move(*mask));
  }

  [[nodiscard]] Result<std::string> file_bytes(const std::string& name, const std::string& where) const {
    const auto file = script_file(options_.folder, name);
    if (!file) return fail(where + ": " + file.error().message);
    auto bytes = read_text(*file, most_paint_bytes);
    if (!bytes) return fail(where + ": " + bytes.error().message);
    return bytes;
  }

  Result<Edit> parts_edit(const Document& document, const PartsPatch& patch, const std::string& where) {
    Document changed = document;
    if (Status applied = apply(patch, changed, where); !applied) return tl::unexpected(applied.error());
    const auto change = [changed = std::move(changed)](Document& target) { target = changed; };
    return PartsEdit{patch.name.empty() ? "Change settings" : patch.name, change};
  }

  Document document_;
  const PlayOptions& options_;
  SolveCache& cache_;
  const TaskContext& context_;
  History history_{std::numeric_limits<std::size_t>::max()};
  std::map<std::string, std::shared_ptr<const Grid<float>>> stamps_;
};

Status check_terrain(const Document& document, const EditScript& script, const std::string& label) {
  if (!document.terrain || document.terrain->height.empty()) return fail(label + ": there is no terrain to play the edits on.");
  const int width = document.terrain->height.width();
  const int height = document.terrain->height.height();
  if (script.width == 0 || (script.width == width && script.height == height)) return {};
  const auto size = [](int w, int h) { return std::to_string(w) + " x " + std::to_string(h); };
  return fail(label + ": was recorded on a terrain of " + size(script.width, script.height) + " cells, this one has " +
              size(width, height) + "; positions would not fit. Play it on a scene of its own size.");
}

}  // namespace

std::unique_ptr<Command> shared_command(std::shared_ptr<const Command> command) {
  return std::make_unique<SharedCommand>(std::move(command));
}

Result<Document> play(Document document, const EditScript& script, const PlayOptions& options, SolveCache& cache,
                      const TaskContext& context, const OnPlayed& played) {
  if (Status fits = check_terrain(document, script, options.label); !fits) return tl::unexpected(fits.error());
  Player player(std::move(document), options, cache, context);
  for (std::size_t i = 0; i < script.entries.size(); ++i) {
    if (context.stopped()) return fail(stopped_message);
    context.report("playing edits", double(i) / double(script.entries.size()));
    const ScriptEntry& entry = script.entries[i];
    const std::string where = options.label + ": edit " + std::to_string(i + 1) + " (" + entry_kind(entry) + ")";
    auto step = player.play(entry, where);
    if (!step) return tl::unexpected(step.error());
    step->number = i + 1;
    step->count = script.entries.size();
    step->document = &player.document();
    if (played) played(*step);
  }
  return player.take_document();
}

}  // namespace biotope
