#pragma once

#include <filesystem>
#include <string>

#include "core/exchange/dem_import.hpp"
#include "ui/editor_state.hpp"

namespace biotope {

// Opening and saving. Long work runs in the background; its outcome arrives in `update`.

/// Opens a scene, a DEM or "sample:NAME"; what is there stays until the new landscape has been read.
void open(EditorState& state, const std::string& input, const DemImportOptions& options = {});
/// Opens at once or, with unsaved work, after the person has been asked.
void open_asking(EditorState& state, const std::string& input, const DemImportOptions& options = {});
/// What a file dropped on the window or chosen in File > Open means: scenes and samples are opened, anything else goes to the
/// import preview.
void open_or_import(EditorState& state, const std::string& input);
void save(EditorState& state);
void save_as(EditorState& state, std::filesystem::path file);
/// Runs `then` now, or after 'unsaved work?' has been answered.
void unless_unsaved(EditorState& state, std::function<void(EditorState&)> then);

// Changing the document. Every change is one step of the history and is posted to the worker once a frame.

/// Changes parameters: `change` edits a copy of the document.
void change_document(EditorState& state, const std::string& name, const std::function<void(Document&)>& change);
void undo(EditorState& state);
void redo(EditorState& state);
/// Goes to the place in the history where `position` steps are done.
void go_to_step(EditorState& state, std::size_t position);
void recompute_from_scratch(EditorState& state);
void cancel_work(EditorState& state);

// Painting.

/// The layer the brush works on now; nothing while no species or resource is chosen.
[[nodiscard]] std::optional<LayerId> paint_target(const EditorState& state);
/// Why one cannot paint now; empty when one can.
[[nodiscard]] std::string paint_hindrance(const EditorState& state);
/// Once a frame: has the map under the brush made ready in the background, so that the first dab does not wait for it.
void prepare_painting(EditorState& state);
void begin_stroke(EditorState& state, float x, float y, float pressure = 1);
void continue_stroke(EditorState& state, float x, float y, float pressure = 1);
void end_stroke(EditorState& state);
/// The brush with the mode of the tool and the limits of the target.
[[nodiscard]] Brush brush_of_tool(const EditorState& state);
/// Takes all paint off a layer.
void clear_paint(EditorState& state, const LayerId& layer);

// Looking.

void select_species(EditorState& state, int species);
/// On the tabs of plants and animals a species of their kind is always selected: the one that was last, else the first. The map
/// that is shown stays.
void select_for_tab(EditorState& state);
/// Puts a species among those painted together, or takes it out; one of another kind is selected alone.
void toggle_species(EditorState& state, int species);
void show_map(EditorState& state, const MapId& map);
[[nodiscard]] const MapId& shown_map(const EditorState& state);
/// The map the canvas shows: the tab's, with the clock's month where maps follow it.
[[nodiscard]] MapId visible_map(const EditorState& state);
/// Asks why the selected species is, or is not, at a cell.
void ask_why(EditorState& state, int x, int y);
/// Asks again where the pointer is, while the question follows it; not so often that the window would notice.
void follow_pointer(EditorState& state, double now);
/// What a person calls the open landscape: its file, its title or its terrain; empty when nothing is open.
[[nodiscard]] std::string document_name(const EditorState& state);
void announce(EditorState& state, std::string text);
void complain(EditorState& state, std::string title, const Error& error);

/// Hands what was edited to the worker. At the end of a frame too, so that an edit need not wait for the next one.
void post_edits(EditorState& state);
/// Another landscape in place of the one that is open, unsaved work or not; its history begins anew.
void replace_document(EditorState& state, Document document);

/// Once a frame: takes what background work has made, posts what changed, moves the clock.
void update(EditorState& state, double now, double frame_seconds);
/// True while something moves by itself, so that the window draws without input.
[[nodiscard]] bool animates(const EditorState& state);

}  // namespace biotope
