#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/document/brush.hpp"
#include "core/document/document.hpp"
#include "tests/scenes/small_valley.hpp"

namespace biotope {

/// What a person does in one step of a random session. What exactly follows from `number` and the document it meets alone, so
/// that a session without some of its steps is a session again.
enum class StepKind : std::uint8_t {
  paint,
  clear,
  hide,
  place,
  remove_placed,
  plan,
  climate,
  species,
  proportions,
  seed,
  inflow,
  undo,
  redo
};
inline constexpr int step_kinds = 13;

/// How the maps are brought up to date after a step.
enum class Answer : std::uint8_t {
  none,     ///< not at all: the next answer has to see both steps
  whole,    ///< to the end
  stopped,  ///< stopped somewhere in the middle
};

struct Step {
  StepKind kind = StepKind::paint;
  std::uint64_t number = 0;
  Answer answer = Answer::whole;
};

/// A landscape of two by two tiles on which a solve takes milliseconds: plants of every stratum, grazers, an omnivore and a
/// predator.
inline Result<Document> tiny_document(int width = 70, int height = 66) {
  auto document = scenes::small_document(std::string(BIOTOPE_SOURCE_DIR) + "/assets");
  if (!document) return document;
  document->terrain = std::make_shared<const Terrain>(scenes::small_valley(width, height));
  document->inflows = {{width / 2, 0, 2.0e8}};
  static constexpr std::array<const char*, 10> kept{"poaceae",      "apiaceae",          "pistacia",     "alnus",
                                                    "pinus",        "bison-priscus",     "dama-roberti", "ovis-ammon",
                                                    "ursus-arctos", "canis-mosbachensis"};
  std::vector<Species> species;
  for (const Species& one : *document->species) {
    if (std::find(kept.begin(), kept.end(), one.name) == kept.end()) continue;
    species.push_back(one);
    if (one.is_plant()) continue;
    for (Need& need : std::get<AnimalTraits>(species.back().traits).diet) {
      std::erase_if(need.foods, [&](const Food& food) {
        const bool known = std::any_of(document->species->begin(), document->species->end(),
                                       [&](const Species& s) { return s.name == food.name; });
        return known && std::find(kept.begin(), kept.end(), food.name) == kept.end();
      });
    }
  }
  document->species = std::make_shared<const std::vector<Species>>(std::move(species));
  return document;
}

/// Deterministic choices of one step.
class Chance {
 public:
  explicit Chance(std::uint64_t number) : number_(number) {}
  int whole(int low, int high) { return random_int(low, high, {number_, drawn_++}); }
  float real(float low, float high) { return low + (high - low) * float(random_unit({number_, drawn_++})); }

 private:
  std::uint64_t number_;
  std::uint64_t drawn_ = 0;
};

/// A session: the document and what can be undone.
struct Session {
  std::vector<Document> states;
  std::size_t position = 0;

  explicit Session(Document start) : states{std::move(start)} {}
  [[nodiscard]] const Document& document() const { return states[position]; }
  void perform(const Step& step);
};

[[nodiscard]] std::string to_string(const Step& step);
[[nodiscard]] std::vector<Step> random_steps(std::uint64_t seed, int count);

}  // namespace biotope
