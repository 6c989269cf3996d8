#include "core/movement/herd_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.hpp"

namespace biotope {

namespace {

/// Rounds in which bodies push each other apart, and how far one moves in a round at most, m.
constexpr int rounds = 14;
constexpr double most_a_round = 0.45;
/// A little more than half of an overlap each, so that few rounds do.
constexpr double share_of_overlap = 1.06;
/// Metres before and behind a trunk within which one who walks goes around it; and how much room it leaves.
constexpr double way_around = 3.5;
constexpr double room_around = 0.08;
/// Trunks are looked up by squares of this side, m.
constexpr double stem_square = 16;
/// And bodies by squares of this one.
constexpr double body_square = 5;
/// Bodies that are listed together in one task.
constexpr std::size_t bodies_a_task = 64;

struct Contact {
  Place out;         ///< unit vector from the other one to this one
  double depth = 0;  ///< m
};

Place point_of(const HerdBody& body, double along) { return body.at + body.along * along; }

/// The point of a body's line that is nearest to a place.
Place nearest_on(const HerdBody& body, Place place) {
  return point_of(body, std::clamp(dot(place - body.at, body.along), -body.back, body.front));
}

/// The nearest points of two bodies' lines, as the way from the second's to the first's; nothing where they cross.
Place between(const HerdBody& a, const HerdBody& b) {
  const Place gap = a.at - b.at;
  const double turned = a.along.x * b.along.y - a.along.y * b.along.x;
  if (std::abs(turned) > 1e-9) {
    // Where the two lines meet, measured along each.
    const double on_a = (b.along.x * gap.y - b.along.y * gap.x) / turned;
    const double on_b = (a.along.x * gap.y - a.along.y * gap.x) / turned;
    if (on_a >= -a.back && on_a <= a.front && on_b >= -b.back && on_b <= b.front) return {};
  }
  Place best{1e9, 0};
  const auto consider = [&](Place way) {
    if (dot(way, way) < dot(best, best)) best = way;
  };
  for (const double end : {-a.back, a.front}) consider(point_of(a, end) - nearest_on(b, point_of(a, end)));
  for (const double end : {-b.back, b.front}) consider(nearest_on(a, point_of(b, end)) - point_of(b, end));
  return best;
}

Contact contact(const HerdBody& a, const HerdBody& b) {
  const double apart = a.radius + b.radius;
  const Place gap = a.at - b.at;
  const double reach = apart + std::max(a.back, a.front) + std::max(b.back, b.front);
  if (dot(gap, gap) >= reach * reach) return {};
  const Place way = between(a, b);
  const double distance = length(way);
  if (distance >= apart) return {};
  if (distance > 1e-6) return {way * (1 / distance), apart - distance};
  // One across the other: each to the side on which its middle is; or by their names.
  const double side = a.name < b.name ? 1 : -1;
  return {unit_of(gap, unit_of(Place{std::cos(double(std::min(a.name, b.name) % 4096) * 2.4), 1} * side)), apart};
}

Contact contact(const HerdBody& body, const Stem& stem) {
  const double apart = body.radius + stem.radius;
  const Place way = nearest_on(body, stem.at) - stem.at;
  const double distance2 = dot(way, way);
  if (distance2 >= apart * apart) return {};
  const double distance = std::sqrt(distance2);
  const Place left{-body.along.y, body.along.x};
  return {distance > 1e-6 ? way * (1 / distance) : left, apart - distance};
}

/// Trunks around bodies, by squares of the ground.
class StemSquares {
 public:
  StemSquares(const HerdWorld& world, std::span<const HerdBody> bodies) {
    if (!world.details) return;
    constexpr double reach = way_around + 3;
    for (const HerdBody& body : bodies) {
      for (int y = index(body.at.y - reach); y <= index(body.at.y + reach); ++y) {
        for (int x = index(body.at.x - reach); x <= index(body.at.x + reach); ++x) squares_.push_back({y, x, 0, 0});
      }
    }
    const auto key = [](const Square& square) { return std::pair(square.y, square.x); };
    std::sort(squares_.begin(), squares_.end(), [&](const Square& a, const Square& b) { return key(a) < key(b); });
    squares_.erase(
        std::unique(squares_.begin(), squares_.end(), [&](const Square& a, const Square& b) { return key(a) == key(b); }),
        squares_.end());
    for (Square& square : squares_) {
      square.first = stems_.size();
      const Place low{square.x * stem_square, square.y * stem_square};
      world.details->stems(low, low + Place{stem_square, stem_square}, stems_);
      square.last = stems_.size();
    }
  }
  /// Calls body(stem) for every trunk within `reach` metres each way, always in the same order.
  template <class Body>
  void near(Place at, double reach, const Body& body) const {
    for (int y = index(at.y - reach); y <= index(at.y + reach); ++y) {
      auto square = std::lower_bound(squares_.begin(), squares_.end(), std::pair(y, index(at.x - reach)),
                                     [](const Square& s, std::pair<int, int> k) { return std::pair(s.y, s.x) < k; });
      for (; square != squares_.end() && square->y == y && square->x <= index(at.x + reach); ++square) {
        for (std::size_t i = square->first; i < square->last; ++i) {
          const Place gap = stems_[i].at - at;
          if (std::abs(gap.x) <= reach && std::abs(gap.y) <= reach) body(stems_[i]);
        }
      }
    }
  }
  [[nodiscard]] bool empty() const { return stems_.empty(); }

 private:
  struct Square {
    int y;
    int x;
    std::size_t first;
    std::size_t last;
  };
  [[nodiscard]] static int index(double metres) { return int(std::floor(metres / stem_square)); }
  std::vector<Square> squares_;
  std::vector<Stem> stems_;
};

/// How far to the left one that walks goes around the trunks before and beside it: the least that is clear of all of them.
double aside(const HerdBody& body, const StemSquares& stems) {
  std::array<std::pair<double, double>, 24> taken;
  std::size_t count = 0;
  const Place left{-body.along.y, body.along.x};
  stems.near(body.at, way_around + 2.5, [&](const Stem& stem) {
    const double ahead = dot(stem.at - body.at, body.along);
    const double wide = stem.radius + body.radius + room_around;
    const double before = ahead - body.front - 0.5 * wide;
    const double behind = -ahead - body.back - 0.5 * wide;
    const double clear = wide * (1 - smooth_step(0, way_around, std::max(before, behind)));
    const double offset = dot(stem.at - body.at, left);
    if (clear > 0.02 && std::abs(offset) < 4 && count < taken.size()) taken[count++] = {offset - clear, offset + clear};
  });
  std::sort(taken.begin(), taken.begin() + std::ptrdiff_t(count));
  // Gaps between trunks that stand close are none; of the stretch around the straight way the nearer end is taken.
  double low = 0;
  double high = 0;
  for (std::size_t i = 0; i < count;) {
    auto [from, until] = taken[i];
    for (++i; i < count && taken[i].first < until; ++i) until = std::max(until, taken[i].second);
    if (from < 0 && until > 0) {
      low = from;
      high = until;
    }
  }
  return -low < high ? low : high;
}

void go_around(const StemSquares& stems, std::vector<HerdBody>& bodies) {
  parallel_each((bodies.size() + bodies_a_task - 1) / bodies_a_task, [&](std::size_t task) {
    const std::size_t last = std::min(bodies.size(), (task + 1) * bodies_a_task);
    for (std::size_t i = task * bodies_a_task; i < last; ++i) {
      HerdBody& body = bodies[i];
      const double walks = smooth_step(0.1, 0.5, body.speed);
      if (walks <= 0) continue;
      const double metres = aside(body, stems) * walks;
      const Place to = body.at + Place{-body.along.y, body.along.x} * metres;
      if (metres != 0 && body.cast->passable(to)) body.at = to;
    }
  });
}

/// Bodies by squares of the ground. Squares do not depend on who is listed, so that sums over neighbours do not either.
class BodySquares {
 public:
  explicit BodySquares(std::span<const HerdBody> bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      entries_.emplace_back(std::pair(index(bodies[i].at.y), index(bodies[i].at.x)), std::uint32_t(i));
    std::sort(entries_.begin(), entries_.end());
  }
  /// Calls visit(number) for every body in the squares within `reach` metres each way.
  template <class Visit>
  void near(Place at, double reach, const Visit& visit) const {
    for (int y = index(at.y - reach); y <= index(at.y + reach); ++y) {
      const std::pair last(y, index(at.x + reach));
      const Entry first(std::pair(y, index(at.x - reach)), 0);
      for (auto entry = std::lower_bound(entries_.begin(), entries_.end(), first);
           entry != entries_.end() && entry->first <= last; ++entry) {
        visit(std::size_t(entry->second));
      }
    }
  }

 private:
  using Entry = std::pair<std::pair<int, int>, std::uint32_t>;
  [[nodiscard]] static int index(double metres) { return int(std::floor(metres / body_square)); }
  std::vector<Entry> entries_;
};

/// Where a body is after a round: away from all that it is in.
Place pushed(std::span<const HerdBody> bodies, std::size_t number, const BodySquares& squares, double farthest,
             const StemSquares& stems) {
  const HerdBody& body = bodies[number];
  Place push{};
  squares.near(body.at, farthest, [&](std::size_t other) {
    if (other == number) return;
    const HerdBody& b = bodies[other];
    const Contact met = contact(body, b);
    if (met.depth <= 0) return;
    const double own = body.radius * body.radius;
    push = push + met.out * (met.depth * share_of_overlap * b.radius * b.radius / (own + b.radius * b.radius));
  });
  stems.near(body.at, std::max(body.back, body.front) + body.radius + 1.5, [&](const Stem& stem) {
    const Contact met = contact(body, stem);
    if (met.depth > 0) push = push + met.out * (met.depth * share_of_overlap);
  });
  const double metres = length(push);
  if (metres <= 0) return body.at;
  if (metres > most_a_round) push = push * (most_a_round / metres);
  const Place to = body.at + push;
  if (body.cast->passable(to)) return to;
  // Along the edge, or not at all.
  for (const Place part : {Place{push.x, 0}, Place{0, push.y}}) {
    if (body.cast->passable(body.at + part)) return body.at + part;
  }
  return body.at;
}

double reach_of(const HerdBody& body) { return std::max(body.back, body.front) + body.radius; }

}  // namespace

HerdBody herd_body(const HerdCast& cast, double size, Place at, double heading, double speed, std::uint64_t name) {
  HerdBody body;
  body.at = at;
  body.along = {std::sin(heading), std::cos(heading)};
  // Shares of length and height of a quadruped seen from above. Our choice.
  body.radius = std::max(0.115 * cast.body_length, 0.19 * cast.shoulder) * size;
  body.back = std::max(0.0, 0.31 * cast.body_length * size - body.radius);
  body.front = std::max(0.0, 0.42 * cast.body_length * size - body.radius);
  body.speed = speed;
  body.name = name;
  body.cast = &cast;
  return body;
}

double overlap(const HerdBody& a, const HerdBody& b) { return contact(a, b).depth; }
double overlap(const HerdBody& body, const Stem& stem) { return contact(body, stem).depth; }

void settle(const HerdWorld& world, std::vector<HerdBody>& bodies) {
  const StemSquares stems(world, bodies);
  if (!stems.empty()) go_around(stems, bodies);
  double farthest = 0;
  for (const HerdBody& body : bodies) farthest = std::max(farthest, 2 * reach_of(body));
  std::vector<Place> places(bodies.size());
  // Only those near one that moved in the last round can move in this one.
  std::vector<std::uint8_t> awake(bodies.size(), 1);
  for (int round = 0; round < rounds; ++round) {
    const BodySquares squares(bodies);
    parallel_each((bodies.size() + bodies_a_task - 1) / bodies_a_task, [&](std::size_t task) {
      const std::size_t last = std::min(bodies.size(), (task + 1) * bodies_a_task);
      for (std::size_t i = task * bodies_a_task; i < last; ++i)
        places[i] = awake[i] != 0 ? pushed(bodies, i, squares, farthest, stems) : bodies[i].at;
    });
    std::fill(awake.begin(), awake.end(), std::uint8_t(0));
    bool moved = false;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].at == places[i]) continue;
      moved = true;
      squares.near(bodies[i].at, farthest + 2 * most_a_round, [&](std::size_t other) { awake[other] = 1; });
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].at = places[i];
    if (!moved) return;
  }
}

}  // namespace biotope
