#include "render/animal_season.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace biotope {

namespace {

std::string_view genus_of(std::string_view scientific_name) { return scientific_name.substr(0, scientific_name.find(' ')); }

/// Share of the winter coat by month: it comes in September and October and goes in April and May, as deer's do (British Deer
/// Society; other animals: our choice).
constexpr std::array<float, 12> winter_share{1, 1, 1, 0.8F, 0.4F, 0, 0, 0, 0.25F, 0.65F, 0.95F, 1};

/// Coats of midwinter. What changes is what field guides say (red deer grey-brown, fallow deer dark and all but unspotted, roe
/// and mule deer grey, reindeer and wolves paler, chamois nearly black, ibex and boar darker); how much is our choice.
/// Deer whose calves are born in May or June, spotted until August (roe deer; others our choice).
constexpr std::array<std::string_view, 3> spotted_young{"Cervus", "Capreolus", "Odocoileus"};
constexpr std::array<float, 12> young_spots{0, 0, 0, 0, 0.9F, 0.9F, 0.9F, 0.7F, 0.25F, 0, 0, 0};

constexpr AnimalCoat usual_winter{0.25F, 0, 0.92F, 0.012F, 0.6F};
constexpr std::array<std::pair<std::string_view, AnimalCoat>, 19> winter_coats{{
    {"Cervus", {0.50F, 0.13F, 1.00F, 0.014F, 0}},
    {"Dama", {0.65F, 0.02F, 0.76F, 0.012F, 0.12F}},
    {"Rangifer", {0.35F, 0.36F, 1, 0.022F, 1}},
    {"Alces", {0.40F, 0.04F, 0.92F, 0.014F, 1}},
    {"Odocoileus", {0.70F, 0.08F, 0.98F, 0.012F, 1}},
    {"Capreolus", {0.75F, 0.10F, 0.95F, 0.014F, 1}},
    {"Bison", {0.10F, 0, 0.92F, 0.020F, 1}},
    {"Bos", {0.10F, 0, 0.88F, 0.014F, 1}},
    {"Equus", {0.20F, 0.12F, 0.98F, 0.014F, 1}},
    {"Capra", {0.15F, 0, 0.84F, 0.018F, 1}},
    {"Hemitragus", {0.10F, 0, 0.82F, 0.026F, 1}},
    {"Rupicapra", {0.35F, 0, 0.58F, 0.020F, 1}},
    {"Ovis", {0.15F, 0, 0.88F, 0.016F, 1}},
    {"Canis", {0.40F, 0.20F, 1, 0.026F, 1}},
    {"Vulpes", {0.05F, 0.05F, 1, 0.040F, 1}},
    {"Lynx", {0.50F, 0.24F, 1, 0.026F, 0.5F}},
    {"Ursus", {0.05F, 0, 0.94F, 0.022F, 1}},
    {"Sus", {0.30F, 0.04F, 0.88F, 0.022F, 1}},
    {"Stephanorhinus", {0, 0, 1, 0, 1}},
}};

/// How far antlers have grown at the middle of each month, and whether they are in velvet.
struct AntlerYear {
  std::array<float, 12> grown;
  int first_velvet;  ///< months, both included; may pass the year's end
  int last_velvet;
};
/// Red, fallow and roe deer: the table of antler cycles of the British Deer Society. Reindeer bulls cast in December and January,
/// cows after calving in May; moose in January, mule deer in February: our choice of the months, all are in velvet until August.
constexpr AntlerYear red_year{{1, 1, 1, 0.05F, 0.35F, 0.7F, 0.95F, 1, 1, 1, 1, 1}, 3, 7};
constexpr AntlerYear fallow_year{{1, 1, 1, 1, 0.1F, 0.5F, 0.85F, 1, 1, 1, 1, 1}, 4, 7};
constexpr AntlerYear roe_year{{0.4F, 0.8F, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0.1F}, 11, 2};
constexpr AntlerYear reindeer_bull_year{{0, 0, 0.1F, 0.25F, 0.5F, 0.75F, 0.95F, 1, 1, 1, 1, 1}, 2, 7};
constexpr AntlerYear reindeer_cow_year{{1, 1, 1, 1, 1, 0.15F, 0.5F, 0.9F, 1, 1, 1, 1}, 5, 7};
constexpr AntlerYear moose_year{{0, 0, 0.05F, 0.2F, 0.5F, 0.75F, 0.95F, 1, 1, 1, 1, 1}, 2, 7};
constexpr AntlerYear mule_deer_year{{1, 0, 0, 0.15F, 0.4F, 0.7F, 0.9F, 1, 1, 1, 1, 1}, 3, 7};

const AntlerYear* antler_year(std::string_view genus, bool male) {
  if (genus == "Cervus") return &red_year;
  if (genus == "Dama") return &fallow_year;
  if (genus == "Capreolus") return &roe_year;
  if (genus == "Rangifer") return male ? &reindeer_bull_year : &reindeer_cow_year;
  if (genus == "Alces" || genus == "Megaloceros") return &moose_year;
  if (genus == "Odocoileus") return &mule_deer_year;
  return nullptr;
}

}  // namespace

AnimalCoat animal_coat(std::string_view scientific_name, int month) {
  const auto found = std::find_if(winter_coats.begin(), winter_coats.end(),
                                  [&](const auto& entry) { return entry.first == genus_of(scientific_name); });
  const AnimalCoat& winter = found != winter_coats.end() ? found->second : usual_winter;
  const float share = winter_share[std::size_t(month)];
  const bool spotted = std::find(spotted_young.begin(), spotted_young.end(), genus_of(scientific_name)) != spotted_young.end();
  return {share * winter.grey,
          share * winter.pale,
          1 + share * (winter.shade - 1),
          share * winter.hair,
          1 + share * (winter.spots - 1),
          spotted ? young_spots[std::size_t(month)] : 0.0F};
}

AntlerState antlers(std::string_view scientific_name, bool male, int month, float early) {
  const AntlerYear* year = antler_year(genus_of(scientific_name), male);
  if (year == nullptr) return {};
  const auto within = [&](int m) {
    return year->first_velvet <= year->last_velvet ? m >= year->first_velvet && m <= year->last_velvet
                                                   : m >= year->first_velvet || m <= year->last_velvet;
  };
  const int next = (month + 1) % 12;
  const float now = year->grown[std::size_t(month)];
  const float then = year->grown[std::size_t(next)];
  // Some cast within the month, some later; those in velvet grow on.
  if (then < now - 0.2F) return early < 0.5F ? AntlerState{now, within(month)} : AntlerState{then, within(next)};
  return {now + (then - now) * 0.5F * early, early < 0.7F || !within(month) ? within(month) : within(next)};
}

}  // namespace biotope
