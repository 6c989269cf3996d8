#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/brush.hpp"
#include "core/document/document.hpp"
#include "core/document/history.hpp"
#include "core/ecosystem/explanation.hpp"
#include "core/pipeline/worker.hpp"
#include "render/camera.hpp"
#include "render/map_renderer.hpp"
#include "ui/background_task.hpp"
#include "ui/brush_presets.hpp"
#include "ui/chain_changes.hpp"
#include "ui/edit_player.hpp"
#include "ui/edit_recorder.hpp"
#include "ui/exploring.hpp"
#include "ui/file_listing.hpp"
#include "ui/file_request.hpp"
#include "ui/herd_day.hpp"
#include "ui/image_import.hpp"
#include "ui/inspector_layout.hpp"
#include "ui/map_cache.hpp"
#include "ui/map_catalogue.hpp"
#include "ui/paint_grounds.hpp"
#include "ui/paint_session.hpp"
#include "ui/painting_state.hpp"
#include "ui/pending_edits.hpp"
#include "ui/placing_session.hpp"
#include "ui/saved_views.hpp"
#include "ui/settings.hpp"
#include "ui/shortcut.hpp"
#include "ui/species_figures.hpp"
#include "ui/tools.hpp"
#include "ui/trail_figures.hpp"
#include "ui/view_actions.hpp"

namespace biotope {

enum class ViewMode : std::uint8_t { map, landscape, split };

/// The day that herds and light follow.
struct EditorClock {
  double hour = 10.5;
  bool playing = false;
  /// Hours of the landscape a second.
  double speed = 0.25;
  int month = 5;  ///< 0 is January
};

/// What a person looks at.
struct EditorView {
  Tab tab = Tab::plants;
  ViewMode mode = ViewMode::split;
  /// Part of the canvas that the map has in split view.
  float split = 0.5F;
  MapView map;
  /// False until the map has been fitted to the canvas.
  bool framed = false;
  Camera camera;
  bool camera_placed = false;
  /// True until somebody moves the camera: it then goes to the best first place once the landscape is known.
  bool camera_untouched = true;
  /// The map shown under each tab.
  std::array<MapId, tab_count> shown{};
  /// Monthly maps show the clock's month instead of the yearly mean.
  bool by_month = false;
  bool water = true;
  bool contours = true;
  bool trails = true;
  bool herds = true;
  bool plants = true;
  bool hatch = true;
  bool iso_lines = false;
  bool food_chain = false;
  /// The map that is looked at lies over the 3D view too: always, or while it is painted.
  bool drape = false;
  bool drape_while_painting = true;
  /// 'Why?' follows the pointer instead of waiting for clicks.
  bool why_follows = false;
  float opacity = 0.85F;
  /// What drawing the 3D view costs, over it.
  bool statistics = false;
  /// Factor of the quality level (LandscapeOptions::quality); the measured one where the level is automatic.
  float quality = 0.5F;
  /// The 3D view is drawn by the processor.
  bool software = false;
  /// Time of what moves by itself in the 3D view, s.
  double seconds = 0;
  std::vector<bool> visible_species;
};

/// A cell somebody asked about.
struct CellQuestion {
  int x = 0;
  int y = 0;
  int species = -1;
  std::optional<Explanation> answer;
  /// The snapshot the answer is about.
  std::uint64_t revision = 0;
};

/// Where the pointer went with the left button held since it was last drawn, window pixels: a stroke follows every point of it,
/// however slowly the window draws.
struct PointerPath {
  /// x, y, pressure 0..1 (1 for a mouse).
  std::vector<std::array<float, 3>> points;
  bool held = false;
};

/// A key that went down or repeated since the last frame. A queue, because a quick tap may be over before a slow frame looks.
struct KeyPress {
  Shortcut keys;
  bool repeat = false;
};

/// What lies under the pointer, for the status bar.
struct PointerReadout {
  bool over_map = false;
  float x = 0;  ///< cells
  float y = 0;
};

/// A message somebody must see.
struct EditorMessage {
  std::string title;
  std::string text;
};

/// Windows over the editor that are open.
struct OpenDialogs {
  bool palette = false;
  bool shortcuts = false;
  bool about = false;
  bool samples = false;
  bool settings = false;
  bool open_file = false;
  bool save_file = false;
  bool import_file = false;
  bool unsaved = false;
  bool recovery = false;
  bool first_steps = false;
  bool select_range = false;
  bool import_image = false;
  bool views = false;
  bool picture = false;
  bool unsaved_recording = false;
};

/// What the terrain panel says about the ground.
struct GroundFigures {
  /// Lowest and highest, m.
  std::array<float, 2> height_range{};
  /// Share of cells that were filled in.
  double void_share = 0;
};

/// What the terrain panel says about water.
struct WaterFigures {
  double lake_area = 0;  ///< m2
  double sea_area = 0;
  float discharge = 0;  ///< greatest mean of the year, m3/s
};

/// What the cards of the inspector were about in the frame before.
struct InspectorSubjects {
  std::array<int, 2> asked{-1, -1};
  struct Herd {
    std::string species;
    PathPoint home;
    int number = 0;
    bool operator==(const Herd&) const = default;
  };
  Herd herd;
  Tool tool = Tool::select;
};

/// Everything the editor knows that is not on the graphics card. Changed only by the functions of editor_actions.hpp and by
/// panels.
struct EditorState {
  Document document;
  bool has_document = false;
  /// Figures of the open landscape.
  GroundFigures ground;
  WaterFigures water;
  History history;
  /// Counts changes of the document; `saved_edits` is its value at the last save.
  std::uint64_t edits = 0;
  std::uint64_t saved_edits = 0;
  std::filesystem::path scene_file;

  std::unique_ptr<Worker> worker;
  std::uint64_t posted_revision = 0;
  bool must_post = false;
  /// Where the history stood when the document was last posted.
  std::size_t posted_position = 0;
  /// Newest snapshot for maps, and the one herds, trails and plants are shown from (complete where there is one).
  std::shared_ptr<const MapsSnapshot> newest;
  std::shared_ptr<const MapsSnapshot> shown;
  /// What the 3D view shows: the newest plants with the herds of `shown` (pictured_maps).
  std::shared_ptr<const MapsSnapshot> pictured;

  MapCache maps;
  BackgroundTask<Document> loading;
  /// How the landscape that is being opened is read.
  DemImportOptions loading_options;
  BackgroundTask<bool> saving;
  PaintSession painting;
  PaintGrounds grounds;
  PaintSetup paint;
  /// The left button held for a tool that acts when it is let go.
  std::optional<ToolGesture> gesture;
  std::optional<CopiedPaint> copied;
  PendingEdits pending;
  ImageImport image_import;
  BackgroundTask<ImageEdit> importing;
  BackgroundTask<bool> exporting;
  /// The person's own brushes, once they have been read.
  std::optional<std::vector<BrushPreset>> presets;
  /// The one thrown away last, and where it stood: it can be taken back.
  std::optional<std::pair<std::size_t, BrushPreset>> thrown_preset;
  /// Told of every edit once it is part of the history (a recorder).
  std::function<void(EditorState&, const Edit&)> edit_listener;
  EditRecorder recorder;
  EditPlayer player;

  /// Figures of the species list and the snapshot they are of.
  struct LandscapeCount {
    std::vector<SpeciesFigures> species;
    ShortageMaps shortages;
    /// Absent: as before.
    std::optional<GroundFigures> ground;
    std::optional<WaterFigures> water;
    std::optional<TrailFigures> trails;
    std::optional<std::vector<float>> activity;
  };
  BackgroundTask<LandscapeCount> counting;
  std::vector<SpeciesFigures> figures;
  ShortageMaps shortages;
  std::shared_ptr<const MapsSnapshot> figures_of;
  /// What the last edit did to whom.
  ChainChanges changes;

  /// Share of animals awake by half hour, of the plans they were made from.
  TrailFigures trail_figures;
  std::vector<float> activity;

  /// Fords, rivers, trails ... being placed, drawn or moved.
  PlacingSession placing;
  /// The herd whose day is looked at.
  HerdDay herd_day;

  EditorView view;
  InspectorState inspector;
  InspectorSubjects inspector_subjects;
  Exploring exploring;
  /// Bookmarks and the camera's path; saved with the scene.
  SavedViews views;
  PictureSession pictures;
  EditorClock clock;
  Tool tool = Tool::select;
  Brush brush;
  /// Selected species' number in the web; -1: none.
  int selected_species = -1;
  /// The plant and the animal that were selected last: back on the tab of one, it is selected again.
  std::array<int, 2> last_selected{-1, -1};
  /// Species that are painted together with the selected one, by number; all plants or all animals.
  std::set<int> also_selected;
  std::optional<CellQuestion> question;
  double ask_again_at = 0;
  /// A value being dragged in a panel that becomes one step of the history when it is let go.
  std::optional<float> dragged_value;
  /// The same for a month dragged in the climate diagram.
  std::optional<Climate> dragged_climate;
  PointerReadout pointer;
  PointerPath path;
  std::vector<KeyPress> key_presses;

  Settings settings;
  std::filesystem::path settings_file;
  /// Somebody was told that the settings cannot be written.
  bool settings_complained = false;
  std::vector<Climate> climates;
  OpenDialogs dialogs;
  std::vector<EditorMessage> messages;
  std::string notice;  ///< a short confirmation in the status bar
  double notice_until = 0;
  /// What waits for the answer to 'unsaved work?'.
  std::function<void(EditorState&)> after_unsaved;
  /// What waits until the scene is on the disk; it does not happen when saving fails.
  std::function<void(EditorState&)> after_saved;
  /// Saving was asked for again while a save was running.
  bool save_again = false;
  FileBrowser browser;
  /// A file somebody is asked for.
  std::optional<FileRequest> file_request;
  std::filesystem::path import_path;
  std::string palette_text;
  int palette_choice = 0;
  std::filesystem::path recovery_file;
  /// The document came from `recovery_file`.
  bool rescued = false;

  bool wants_close = false;
  bool wants_screenshot = false;
  bool wants_full_screen = false;
  bool theme_changed = true;
  float frame_seconds = 0;

  [[nodiscard]] bool dirty() const { return has_document && edits != saved_edits; }
  [[nodiscard]] const FoodWeb* web() const {
    return shown && shown->web ? shown->web.get() : newest ? newest->web.get() : nullptr;
  }
};

}  // namespace biotope
