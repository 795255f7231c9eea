// The legs of an opened chunk: checks of their numbers, and those of some times.
#include <bit>
#include <cmath>
#include <cstring>

#include "format/chunk_blob.h"
#include "format/node_format.h"
#include "motion/plan/plan_legs.h"

namespace foresee {
namespace {

constexpr const char *not_finite = "a number is not finite", *out_of_order = "its times do not rise",
                     *no_velocity = "no double holds the velocity of a leg";

class NumberReader {
 public:
  NumberReader(const std::byte* at, std::size_t axes) : at_(at), axes_(axes) {}

  double number() {
    const auto value = load_number<double>(at_);
    at_ += sizeof value;
    return value;
  }
  /// Anything but finite numbers makes is_finite() false.
  double finite() {
    const double value = number();
    sum_ += value * 0;
    return value;
  }
  std::array<double, 3> vector() {
    std::array<double, 3> numbers{};
    for (std::size_t axis = 0; axis < axes_; ++axis) numbers[axis] = finite();
    return numbers;
  }
  bool is_finite() const { return sum_ == 0; }

 private:
  const std::byte* at_;
  std::size_t axes_;
  double sum_ = 0;  ///< 0, or NaN
};

/// Calls leg(start, end, ends_part) for each leg between knots; only the end of the last may be infinite.
template <class Each>
const char* read_knots(const StoredChunk& chunk, Each leg) {
  NumberReader reader(chunk.numbers, chunk.axes);
  const auto read_knot = [&](bool may_rest) {
    Knot knot;
    knot.t = may_rest ? reader.number() : reader.finite();
    knot.x = reader.vector();
    return knot;
  };
  Knot start = read_knot(false);
  for (std::size_t i = 0; i < chunk.legs; ++i) {
    const bool ends_part = (chunk.ends >> i & 1) != 0, is_last = i + 1 == chunk.legs;
    const Knot end = read_knot(is_last);
    if (!reader.is_finite()) return not_finite;
    if (!(start.t < end.t)) return out_of_order;
    if (end.t == no_end && start.x != end.x) return "a knot without end is not where the mover rests";
    if (const char* fault = leg(start, end, ends_part)) return fault;
    if (is_last) break;
    start = end;
    if (!ends_part) continue;
    start = read_knot(false);
    if (!(end.t <= start.t)) return out_of_order;
  }
  return nullptr;
}

/// Calls leg(read) for each leg with a velocity; only the last until may be infinite.
template <class Each>
const char* read_legs(const StoredChunk& chunk, Each each) {
  NumberReader reader(chunk.numbers, chunk.axes);
  Leg leg;
  double next = reader.number();
  for (std::size_t i = 0; i < chunk.legs; ++i) {
    const bool is_last = i + 1 == chunk.legs;
    leg.t = next;
    if (chunk.has_untils) leg.until = reader.number();
    leg.x = reader.vector();
    leg.v = reader.vector();
    if (chunk.kind == PlanKind::accelerated) leg.a = reader.vector();
    if (!is_last || !chunk.has_untils) next = reader.number();
    if (!chunk.has_untils) leg.until = next;
    if (!reader.is_finite() || !std::isfinite(leg.t) || (!is_last && !std::isfinite(leg.until)))
      return not_finite;
    if (!(leg.t <= leg.until) || (!is_last && !(leg.until <= next))) return out_of_order;
    each(leg);
  }
  return nullptr;
}

}  // namespace

const char* check_legs(const StoredChunk& chunk) {
  if (chunk.kind != PlanKind::knots) return read_legs(chunk, [](const Leg&) {});
  return read_knots(chunk, [](const Knot&, const Knot&, bool) -> const char* { return nullptr; });
}

StoredChunk legs_during(const StoredChunk& chunk, const LegTimes& times) {
  const bool knots = chunk.kind == PlanKind::knots;
  if (knots && (chunk.ends & ~(1u << (chunk.legs - 1))) != 0) return chunk;  // a part ends between two legs
  const std::size_t vectors = knots ? 1 : chunk.kind == PlanKind::uniform ? 2 : 3;
  const std::size_t leg_bytes = sizeof(double) * (1 + chunk.has_untils + vectors * chunk.axes);
  const auto t = [&](std::size_t leg) { return load_number<double>(chunk.numbers + leg * leg_bytes); };
  // A leg ends at the start of the next one, or before.
  std::size_t first = 0, end = chunk.legs;
  for (std::size_t step = std::bit_floor(chunk.legs); step > 0; step /= 2)
    if (first + step < chunk.legs && t(first + step) < times.from) first += step;
  while (end > first + 1 && t(end - 1) > times.until) --end;
  StoredChunk part = chunk;
  part.is_first = false;
  part.ends = 0;
  part.numbers += first * leg_bytes;
  part.legs = end - first;
  return part;
}

const char* append_legs(const StoredChunk& chunk, std::vector<Leg>& legs, const LegTimes& times) {
  if (chunk.kind != PlanKind::knots)
    return read_legs(chunk, [&](const Leg& leg) {
      if (times.meet(leg.t, leg.until)) legs.push_back(leg);
    });
  return read_knots(chunk, [&](const Knot& start, const Knot& end, bool) -> const char* {
    if (!times.meet(start.t, end.t)) return nullptr;
    Leg& leg = legs.emplace_back(Leg{start.t, end.t, start.x, {}, {}});
    for (std::size_t axis = 0; axis < chunk.axes; ++axis) {
      leg.v[axis] = velocity_between(start.x[axis], end.x[axis], start.t, end.t);
      if (!std::isfinite(leg.v[axis])) return no_velocity;
    }
    return nullptr;
  });
}

const char* append_to_plan(const StoredChunk& chunk, Plan& plan) {
  const bool is_empty = plan.knots.empty() && plan.legs.empty();
  if (chunk.is_first != is_empty) return "it is not where the plan has it";
  if (is_empty) {
    plan.kind = chunk.kind;
    plan.axes = static_cast<int>(chunk.axes);
  }
  if (plan.kind != chunk.kind) return "it has another kind than the plan";
  if (chunk.kind != PlanKind::knots) {
    if (!is_empty && !(plan.legs.back().until <= chunk.t())) return out_of_order;
    return read_legs(chunk, [&](const Leg& leg) { plan.legs.push_back(leg); });
  }
  // A part that goes on repeats its last knot; one that starts is noted where the one before it ended.
  bool goes_on = !is_empty && plan.part_starts.back() < plan.knots.size();
  if (goes_on && std::memcmp(&plan.knots.back(), chunk.numbers, sizeof(double) * (1 + chunk.axes)) != 0)
    return "it does not go on where the chunk before it ends";
  if (!is_empty && !(plan.knots.back().t <= chunk.t())) return out_of_order;
  return read_knots(chunk, [&](const Knot& start, const Knot& end, bool ends_part) -> const char* {
    for (std::size_t axis = 0; axis < chunk.axes; ++axis)
      if (!std::isfinite(velocity_between(start.x[axis], end.x[axis], start.t, end.t))) return no_velocity;
    if (!goes_on) plan.knots.push_back(start);
    plan.knots.push_back(end);
    goes_on = !ends_part;
    if (ends_part) plan.part_starts.push_back(plan.knots.size());
    return nullptr;
  });
}

}  // namespace foresee
