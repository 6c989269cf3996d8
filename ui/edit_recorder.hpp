#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>

#include "core/document/edit.hpp"
#include "core/exchange/edit_script.hpp"
#include "core/exchange/edit_script_files.hpp"

namespace biotope {

/// Writes down what a person does to a document, as an edit script. It is told of every edit once the document shows it, with the
/// number of the history's step that it became (steps dropped from the history count on).
class EditRecorder {
 public:
  /// Forgets what was recorded and begins with a document.
  void start(const Document& document, std::size_t step);
  /// What was recorded stays until the next start.
  void stop() { recording_ = false; }
  [[nodiscard]] bool recording() const { return recording_; }
  /// Recorded entries.
  [[nodiscard]] std::size_t count() const { return script_.entries.size(); }
  /// True when something was recorded that has not been saved.
  [[nodiscard]] bool unsaved() const { return !saved_ && !script_.entries.empty(); }
  void mark_saved() { saved_ = true; }

  /// An edit that was done. A step that was merged into the one before (a slider being dragged) is merged here too.
  void record(const Edit& edit, const Document& after, std::size_t step);
  /// Another landscape was opened (`input` as open_input() takes it): the history begins anew.
  void record_open(const std::string& input, const DemImportOptions& options, const Document& after);
  /// The history went back, or forward, by one step. Steps from before the recording began are written as what they changed.
  void record_undo(const Document& after, std::size_t step);
  void record_redo(const Document& after, std::size_t step);

  [[nodiscard]] const EditScript& script() const { return script_; }
  [[nodiscard]] const ScriptAttachments& attachments() const { return attachments_; }
  /// Changes that no script can hold: given environment maps.
  [[nodiscard]] std::size_t missed() const { return missed_; }

 private:
  ScriptEntry entry_of(const Edit& edit, const Document& after);
  ScriptEntry entry_of(const StrokeEdit& edit, const Document& after);
  ScriptEntry entry_of(const FillEdit& edit, const Document& after);
  ScriptEntry entry_of(const ImageEdit& edit, const Document& after);
  ScriptEntry entry_of(const MixEdit& edit, const Document& after);
  ScriptEntry entry_of(const PartsEdit& edit, const Document& after);
  /// Whatever makes `after` of `before`, as one entry.
  ScriptEntry difference(const Document& before, const Document& after, const std::string& name);
  void add_layer_differences(const Document& before, const Document& after, std::vector<ScriptEntry>& entries);
  void write_difference(const Document& after);
  void follow(const Document& after, std::size_t step);

  std::string raster_name(const std::shared_ptr<const Grid<float>>& raster, const char* kind);
  std::string paint_name(const std::shared_ptr<const PaintLayer>& paint);
  std::string mask_name(const std::shared_ptr<const SelectionMask>& mask);

  bool recording_ = false;
  bool saved_ = false;
  EditScript script_;
  ScriptAttachments attachments_;
  /// The document before and after the last entry.
  Document before_;
  Document now_;
  std::size_t step_ = 0;
  /// The last entry is a PartsEdit's and may grow.
  bool may_merge_ = false;
  /// Recorded steps that undo takes back, and that redo does again.
  std::size_t undoable_ = 0;
  std::size_t redoable_ = 0;
  std::size_t missed_ = 0;
};

}  // namespace biotope
