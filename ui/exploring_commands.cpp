#include "ui/exploring_commands.hpp"

#include <string>

#include "render/landscape_renderer.hpp"
#include "ui/editor_actions.hpp"
#include "ui/exploring.hpp"
#include "ui/icons.hpp"
#include "ui/show_places.hpp"
#include "ui/weather_control.hpp"

namespace biotope {
namespace {

bool has_herds(const EditorState& state) { return state.shown && state.shown->plans && !state.shown->plans->empty(); }
bool has_herd(const EditorState& state) { return state.herd_day.herd && chosen_plan(state) != nullptr; }

EditorCommand& add(std::vector<EditorCommand>& list, const char* id, const char* name, const char* keys, const char* tooltip,
                   const char* icon, std::function<void(EditorState&)> action) {
  list.push_back(landscape_command(id, "Explore", name, keys, tooltip, icon, std::move(action)));
  return list.back();
}

/// Chooses the next herd and looks at it, or goes along with it where one was followed.
void go_to_neighbour(EditorState& state, int step) {
  const bool followed = state.exploring.following;
  if (!choose_plan(state, neighbouring_plan(state, step))) return;
  if (followed) {
    set_following(state, true);
  } else {
    go_to_herd(state);
  }
}

/// The chosen herd, or the nearest one when none is chosen.
void with_some_herd(EditorState& state, void (*then)(EditorState&)) {
  if (!has_herd(state) && !choose_nearest_herd(state)) return;
  then(state);
}

void add_moving(std::vector<EditorCommand>& list) {
  add(list, "explore.walk", "Walk", "O", "On foot at eye height: W A S D walk, Shift runs; again to fly", icons::walk,
      [](EditorState& s) { set_walking(s, !s.exploring.walking); })
      .checked = [](const EditorState& s) { return s.exploring.walking; };
  add(list, "explore.overview", "Look at all of it", "Shift+Home", "See the whole landscape from above", icons::frame,
      [](EditorState& s) {
        if (!s.shown) return;
        s.exploring = {};
        fly_to(s, overview(*s.shown));
      });
  add(list, "explore.first", "Go to the first view", "Home", "Back to where the landscape was first looked at", icons::cube,
      [](EditorState& s) {
        if (!s.shown) return;
        s.exploring = {};
        fly_to(s, first_view(*s.shown));
      });
}

void add_herds(std::vector<EditorCommand>& list) {
  EditorCommand& go = add(list, "explore.herd", "Go to herd", "Shift+P", "Look at the chosen herd from near", icons::paw,
                          [](EditorState& s) { with_some_herd(s, go_to_herd); });
  go.enabled = has_herds;
  go.line_before = true;
  EditorCommand& follow =
      add(list, "explore.follow", "Follow herd", "P", "Go along with the chosen herd as the day passes; drag to look around it",
          icons::follow, [](EditorState& s) {
            if (s.exploring.following) {
              set_following(s, false);
            } else {
              with_some_herd(s, [](EditorState& with) { set_following(with, true); });
            }
          });
  follow.enabled = has_herds;
  follow.checked = [](const EditorState& s) { return s.exploring.following; };
  EditorCommand& next = add(list, "explore.next_herd", "Next herd", ".", "Go to the next herd of the same species", icons::next,
                            [](EditorState& s) { go_to_neighbour(s, 1); });
  next.enabled = has_herds;
  next.repeats = true;
  EditorCommand& previous = add(list, "explore.previous_herd", "Previous herd", ",", "Go to the herd of the same species before",
                                icons::previous, [](EditorState& s) { go_to_neighbour(s, -1); });
  previous.enabled = has_herds;
  previous.repeats = true;
}

void add_places(std::vector<EditorCommand>& list) {
  EditorCommand& species = add(list, "explore.species", "Go to the chosen species", "Shift+V",
                               "Fly to the nearest herd of the animal, or to where the plant grows well", icons::place,
                               [](EditorState& s) { show_species(s, s.selected_species); });
  species.enabled = [](const EditorState& s) { return s.selected_species >= 0 && s.shown && s.shown->web; };
  species.line_before = true;
  add(list, "explore.crossing", "Go to the next ford or exit", "Shift+C", "Fly from one ford and exit to the next", icons::road,
      show_next_crossing);
}

void add_showing(std::vector<EditorCommand>& list) {
  EditorCommand& map =
      add(list, "explore.mini_map", "Mini-map", "Shift+M", "A small map in the corner of the 3D view; click or drag to go there",
          icons::map, [](EditorState& s) { s.settings.mini_map = !s.settings.mini_map; });
  map.checked = [](const EditorState& s) { return s.settings.mini_map; };
  map.line_before = true;
  add(list, "explore.statistics", "What is drawn", "F3", "Plants, animals, triangles, memory and time of a picture", icons::meter,
      [](EditorState& s) { s.view.statistics = !s.view.statistics; })
      .checked = [](const EditorState& s) { return s.view.statistics; };
}

void add_views(std::vector<EditorCommand>& list) {
  EditorCommand& window =
      add(list, "explore.views", "Bookmarks and camera path", "Ctrl+B", "Views to come back to, and a path the camera flies",
          icons::bookmark, [](EditorState& s) { s.dialogs.views = !s.dialogs.views; });
  window.checked = [](const EditorState& s) { return s.dialogs.views; };
  window.line_before = true;
  add(list, "explore.bookmark", "Bookmark this view", "Ctrl+D", "Remember where the camera is, with hour and month", icons::star,
      add_bookmark);
  add(list, "explore.path_key", "Add this view to the path", "Ctrl+Shift+D", "The camera comes by here after the last view",
      icons::film, add_path_key);
  EditorCommand& play =
      add(list, "explore.play_path", "Fly along the path", "F8", "Play the camera's path, or stop", icons::play, play_path);
  play.enabled = [](const EditorState& s) { return s.views.path.keys.size() >= 2; };
  play.checked = [](const EditorState& s) { return s.pictures.playing >= 0; };
  for (std::size_t i = 0; i < 9; ++i) {
    const std::string number = std::to_string(i + 1);
    EditorCommand& go =
        add(list, ("explore.bookmark_" + number).c_str(), ("Go to bookmark " + number).c_str(), ("Alt+" + number).c_str(),
            "Fly to this bookmark", icons::place, [i](EditorState& s) { go_to_bookmark(s, i); });
    go.menu.clear();
    go.enabled = [i](const EditorState& s) { return i < s.views.bookmarks.size(); };
  }
}

void add_weather(std::vector<EditorCommand>& list) {
  bool first = true;
  for (const NamedWeather& named : named_weathers()) {
    const std::string name(named.name);
    EditorCommand& made = add(list, ("weather." + name).c_str(), ("Weather: " + name).c_str(), "",
                              ("Show the landscape in this weather: " + name).c_str(), named.icon,
                              [name](EditorState& s) { choose_weather(s, name); });
    made.enabled = {};
    made.checked = [name](const EditorState& s) {
      const NamedWeather* now = name_of_weather(s.settings.weather);
      return now != nullptr && now->name == name;
    };
    made.line_before = first;
    first = false;
  }
  EditorCommand& snow = add(list, "weather.snow", "Snow cover", "", "Snow lies where month and height let it", icons::snow,
                            [](EditorState& s) { s.settings.weather.snow_cover = !s.settings.weather.snow_cover; });
  snow.enabled = {};
  snow.checked = [](const EditorState& s) { return s.settings.weather.snow_cover; };
  EditorCommand& animate = add(list, "explore.animate", "Leaves, water and rain move", "Y",
                               "Let what moves by itself move; off, the picture stands still and is finer", icons::leaf,
                               [](EditorState& s) { s.settings.animate = !moves_by_itself(s); });
  animate.enabled = {};
  animate.checked = moves_by_itself;
}

}  // namespace

void add_picture_commands(std::vector<EditorCommand>& list) {
  EditorCommand& picture =
      add(list, "file.picture", "Save picture ...", "Shift+F12", "Draw the 3D view into a file, up to 8K and beyond",
          icons::image, [](EditorState& s) { s.dialogs.picture = true; });
  picture.menu = "File";
  picture.enabled = [](const EditorState& s) { return s.shown && !s.pictures.running; };
}

void add_exploring_commands(std::vector<EditorCommand>& list) {
  add_moving(list);
  add_herds(list);
  add_places(list);
  add_showing(list);
  add_views(list);
  add_weather(list);
}

}  // namespace biotope
