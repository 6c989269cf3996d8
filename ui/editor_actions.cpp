#include "ui/editor_actions.hpp"

#include <algorithm>
#include <cmath>

#include "core/exchange/open_input.hpp"
#include "core/exchange/scene_file.hpp"
#include "ui/activity_curve.hpp"

namespace biotope {
namespace {

constexpr std::size_t most_named_routes = 12;

void measure_terrain(EditorState& state) {
  const Terrain& terrain = *state.document.terrain;
  const auto heights = terrain.height.cells();
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  state.height_range = heights.empty() ? std::array<float, 2>{} : std::array<float, 2>{*low, *high};
  const auto filled = std::count(terrain.voids.cells().begin(), terrain.voids.cells().end(), std::uint8_t(1));
  state.void_share = terrain.voids.empty() ? 0 : double(filled) / double(terrain.voids.size());
}

void measure_water(EditorState& state) {
  if (!state.shown || state.shown->hydrology == state.water_of) return;
  state.water_of = state.shown->hydrology;
  state.water = {};
  if (!state.water_of) return;
  const double area = state.shown->terrain().cell_area();
  for (const WaterKind kind : state.water_of->water.cells()) {
    state.water.lake_area += kind == WaterKind::lake ? area : 0;
    state.water.sea_area += kind == WaterKind::sea ? area : 0;
  }
  for (const RiverReach& reach : state.water_of->reaches)
    state.water.discharge = std::max(state.water.discharge, reach.discharge);
}

void set_document(EditorState& state, Document document) {
  state.document = std::move(document);
  measure_terrain(state);
  state.has_document = true;
  state.history.clear();
  state.edits = state.saved_edits = 0;
  state.painting.close();
  state.maps.clear();
  state.question.reset();
  state.view.framed = false;
  state.view.camera_placed = false;
  state.view.camera_untouched = true;
  state.view.visible_species.clear();
  state.selected_species = -1;
  state.also_selected.clear();
  state.companions.close();
  state.companion_grounds.clear();
  state.dragged_value.reset();
  state.dragged_climate.reset();
  state.counting.cancel();
  state.preparing.cancel();
  state.figures.clear();
  state.shortages.clear();
  // The ground is shown at once; what lives on it follows.
  auto bare = std::make_shared<MapsSnapshot>();
  bare->document = state.document;
  state.newest = state.shown = bare;
  state.posted_revision = state.worker->post(state.document);
  state.must_post = false;
}

void finish_loading(EditorState& state) {
  const std::string what = state.loading.what();
  std::optional<Result<Document>> loaded = state.loading.take();
  if (!loaded) return;
  if (!*loaded) {
    if (loaded->error().message == "stopped") return;
    complain(state, "This could not be opened", loaded->error());
    // A terrain may only need to be told its cell size or layout: the import preview asks for them.
    std::error_code error;
    const bool terrain = !what.starts_with("sample:") && std::filesystem::path(what).extension() != ".biotope";
    if (terrain && std::filesystem::is_regular_file(what, error)) {
      state.import_path = what;
      state.dialogs.import_file = true;
    }
    return;
  }
  const bool is_scene = std::filesystem::path(what).extension() == ".biotope" && what != state.recovery_file;
  state.scene_file = is_scene ? std::filesystem::path(what) : std::filesystem::path();
  set_document(state, std::move(**loaded));
  if (what == state.recovery_file) {
    state.edits = 1;  // rescued work is not saved yet
  } else {
    remember_recent(state.settings, what);
  }
}

void finish_saving(EditorState& state) {
  std::optional<Result<bool>> saved = state.saving.take();
  if (!saved) return;
  if (!*saved) {
    complain(state, "The scene was not saved", saved->error());
    return;
  }
  announce(state, "Saved " + state.scene_file.filename().string());
}

/// Takes the worker's newest snapshots, if they are of this landscape.
void take_snapshots(EditorState& state) {
  const auto belongs = [&](const std::shared_ptr<const MapsSnapshot>& snapshot) {
    return snapshot && snapshot->document.terrain == state.document.terrain;
  };
  const auto newest = state.worker->latest();
  if (!belongs(newest) || newest == state.newest) return;
  const bool failed_before = state.newest && !state.newest->status;
  state.newest = newest;
  const auto complete = state.worker->latest_complete();
  state.shown = belongs(complete) ? complete : newest;
  if (!newest->status && !failed_before) complain(state, "The landscape could not be computed", newest->status.error());
}

/// Figures of the species list follow the newest landscape, one count at a time.
void count_species(EditorState& state) {
  if (auto counted = state.counting.take(); counted && *counted) {
    state.figures = std::move((*counted)->figures);
    state.shortages = std::move((*counted)->shortages);
  }
  if (state.counting.running() || !state.shown || state.shown == state.figures_of) return;
  state.figures_of = state.shown;
  state.counting.start("Counting", [snapshot = state.shown](const TaskContext&) -> Result<EditorState::SpeciesCount> {
    return EditorState::SpeciesCount{species_figures(*snapshot), shortage_maps(*snapshot)};
  });
}

/// The stroke's own picture goes when the worker's map of the same paint is there.
void retire_paint_picture(EditorState& state) {
  if (state.painting.stroking() || !state.painting.shown() || state.painting.awaited() == 0 || !state.newest ||
      !state.newest->web)
    return;
  if (state.newest->document_revision < state.painting.awaited()) return;
  const MapId map = map_of_layer(state.painting.layer(), *state.newest->web);
  const bool animal = map.kind == MapKind::animal_density;
  if (animal && !state.newest->complete) return;
  if (state.maps.request(animal ? state.shown : state.newest, map).current) state.painting.close();
}

}  // namespace

void open(EditorState& state, const std::string& input, const DemImportOptions& options) {
  state.loading.start(input, [input, options](const TaskContext& context) { return open_input(input, options, context); });
}

void unless_unsaved(EditorState& state, std::function<void(EditorState&)> then) {
  if (!state.dirty()) {
    then(state);
    return;
  }
  state.after_unsaved = std::move(then);
  state.dialogs.unsaved = true;
}

void open_asking(EditorState& state, const std::string& input, const DemImportOptions& options) {
  unless_unsaved(state, [input, options](EditorState& later) { open(later, input, options); });
}

void open_or_import(EditorState& state, const std::string& input) {
  if (input.starts_with("sample:") || std::filesystem::path(input).extension() == ".biotope") {
    open_asking(state, input);
    return;
  }
  state.import_path = input;
  state.dialogs.import_file = true;
}

void save(EditorState& state) {
  if (!state.has_document) return;
  if (state.scene_file.empty()) {
    state.dialogs.save_file = true;
    return;
  }
  save_as(state, state.scene_file);
}

void save_as(EditorState& state, std::filesystem::path file) {
  if (file.extension() != ".biotope") file += ".biotope";
  state.scene_file = file;
  state.settings.last_folder = file.parent_path().string();
  remember_recent(state.settings, file.string());
  state.saved_edits = state.edits;
  state.saving.start("Saving", [file, document = state.document](const TaskContext&) -> Result<bool> {
    const Status saved = save_scene(file, document);
    if (!saved) return tl::unexpected(saved.error());
    return true;
  });
}

void change_document(EditorState& state, std::string name, const std::function<void(Document&)>& change) {
  if (!state.has_document) return;
  Document after = state.document;
  change(after);
  state.history.perform(state.document, std::make_unique<DocumentCommand>(std::move(name), state.document, std::move(after)));
  ++state.edits;
  state.must_post = true;
}

void undo(EditorState& state) {
  if (state.painting.stroking() || !state.history.undo(state.document)) return;
  ++state.edits;
  state.painting.close();
  state.must_post = true;
}

void redo(EditorState& state) {
  if (state.painting.stroking() || !state.history.redo(state.document)) return;
  ++state.edits;
  state.painting.close();
  state.must_post = true;
}

void go_to_step(EditorState& state, std::size_t position) {
  while (state.history.position() > position && state.history.can_undo()) undo(state);
  while (state.history.position() < position && state.history.can_redo()) redo(state);
}

void recompute_from_scratch(EditorState& state) {
  if (!state.has_document) return;
  state.posted_revision = state.worker->post_from_scratch(state.document);
  state.must_post = false;
  announce(state, "Computing everything again");
}

void cancel_work(EditorState& state) {
  if (state.loading.running()) {
    state.loading.cancel();
    announce(state, "Opening was stopped");
  } else if (state.worker->progress().busy) {
    state.worker->cancel();
    announce(state, "Stopped; the last maps stay. F5 computes again");
  }
}

std::string document_name(const EditorState& state) {
  if (!state.has_document) return {};
  if (!state.scene_file.empty()) return state.scene_file.stem().string();
  if (!state.document.title.empty()) return state.document.title;
  return state.document.terrain->name.empty() ? "Untitled" : state.document.terrain->name;
}

void announce(EditorState& state, std::string text) {
  state.notice = std::move(text);
  state.notice_until = -1;  // `update` knows the time
}

void complain(EditorState& state, std::string title, const Error& error) {
  state.messages.push_back({std::move(title), error.message});
}

void select_species(EditorState& state, int species) {
  state.selected_species = species;
  state.also_selected.clear();
  const FoodWeb* web = state.web();
  if (web == nullptr || species < 0 || species >= int(web->species.size())) return;
  const bool plant = web->species[std::size_t(species)].is_plant();
  const Tab tab = plant ? Tab::plants : Tab::animals;
  MapId& map = state.view.shown[std::size_t(tab)];
  // The kind of map that was looked at is kept, so that fitness can be compared from species to species.
  const bool keeps_kind = map.kind != MapKind::none && map.kind != MapKind::group_cover;
  map = {keeps_kind ? map.kind : plant ? MapKind::plant_cover : MapKind::animal_density, species};
}

void toggle_species(EditorState& state, int species) {
  const FoodWeb* web = state.web();
  if (web == nullptr || species < 0 || species >= int(web->species.size())) return;
  const int selected = state.selected_species;
  const bool alone = selected < 0 || selected >= int(web->species.size()) ||
                     web->species[std::size_t(selected)].is_plant() != web->species[std::size_t(species)].is_plant();
  if (alone) {
    select_species(state, species);
  } else if (species == selected) {
    if (state.also_selected.empty()) return;
    // Another of the group takes its place.
    std::set<int> others = state.also_selected;
    const int next = *others.begin();
    others.erase(next);
    select_species(state, next);
    state.also_selected = std::move(others);
  } else if (state.also_selected.erase(species) == 0) {
    state.also_selected.insert(species);
  }
}

const MapId& shown_map(const EditorState& state) { return state.view.shown[std::size_t(state.view.tab)]; }

MapId visible_map(const EditorState& state) {
  MapId map = shown_map(state);
  const bool monthly = map.kind == MapKind::illumination || map.kind == MapKind::temperature || map.kind == MapKind::moisture;
  map.month = monthly && state.view.by_month ? state.clock.month : -1;
  return map;
}

void show_map(EditorState& state, const MapId& map) {
  state.view.shown[std::size_t(state.view.tab)] = map;
  const FoodWeb* web = state.web();
  if (web == nullptr) return;
  const std::optional<LayerId> layer = layer_of_map(map, *web);
  if (!layer || layer->kind == LayerKind::resource) return;
  if (state.selected_species != map.item) state.also_selected.clear();
  state.selected_species = map.item;
}

void ask_why(EditorState& state, int x, int y) {
  if (!state.shown || !state.shown->document.terrain || !state.shown->terrain().height.contains(x, y)) return;
  CellQuestion question{x, y, state.selected_species, std::nullopt, state.shown->revision};
  const MapsSnapshot& snapshot = *state.shown;
  const FoodWeb* web = snapshot.web.get();
  if (web != nullptr && question.species >= 0 && question.species < int(web->species.size())) {
    const bool plant = web->species[std::size_t(question.species)].is_plant();
    if (plant && snapshot.environment && !snapshot.cover.empty()) {
      question.answer = explain_plant(*web, snapshot.plant_environment(), question.species, snapshot.cover, x, y);
    } else if (!plant) {
      const AnimalPlace place = find_animal(snapshot, question.species);
      if (place.level != nullptr) question.answer = explain_animal(*web, *place.level, question.species, snapshot.ground(), x, y);
    }
  }
  state.question = std::move(question);
}

void update(EditorState& state, double now, double frame_seconds) {
  state.frame_seconds = float(frame_seconds);
  finish_loading(state);
  finish_saving(state);
  if (state.must_post && state.has_document) {
    state.posted_revision = state.worker->post(state.document);
    if (state.painting.shown()) state.painting.wait_for(state.posted_revision);
    state.must_post = false;
  }
  take_snapshots(state);
  retire_paint_picture(state);
  prepare_painting(state);
  count_species(state);
  measure_water(state);
  if (state.shown && state.shown->plans != state.activity_of) {
    state.activity_of = state.shown->plans;
    state.activity = activity_curve(*state.shown);
  }
  if (state.shown && state.shown->trails != state.trail_figures_of) {
    state.trail_figures_of = state.shown->trails;
    state.trail_figures = state.trail_figures_of
                              ? trail_figures(*state.trail_figures_of, state.shown->terrain().cell_size, most_named_routes)
                              : TrailFigures{};
  }
  if (state.clock.playing) {
    state.clock.hour = std::fmod(state.clock.hour + state.clock.speed * std::min(frame_seconds, 0.25), 24.0);
  }
  if (state.notice_until < 0) state.notice_until = now + 5;
  if (now > state.notice_until) state.notice.clear();
  if (state.question && state.shown && state.question->revision != state.shown->revision) {
    const CellQuestion asked = *state.question;
    ask_why(state, asked.x, asked.y);
  }
}

bool animates(const EditorState& state) {
  return state.clock.playing || state.loading.running() || state.saving.running() || state.preparing.running() ||
         state.maps.busy() || state.painting.stroking() || state.must_post || (state.worker && state.worker->progress().busy);
}

}  // namespace biotope
