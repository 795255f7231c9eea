#include "motion/plan/packed_legs.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "motion/plan/plan_legs.h"

namespace foresee {
namespace {

constexpr std::size_t header_size = 8, axes_at = 3, kind_at = 4;
constexpr std::byte format{1};

std::size_t numbers_per_item(PlanKind kind, std::size_t axes) {
  return kind == PlanKind::knots ? 1 + axes : 2 + axes * (kind == PlanKind::uniform ? 2 : 3);
}

static_assert(std::endian::native == std::endian::little,
              "plans are stored in the byte order of a little-endian CPU");

class Writer {
 public:
  Writer(PlanKind kind, int axes, std::size_t items, Interrupt& interrupt)
      : step_(interrupt), axes_(static_cast<std::size_t>(axes)) {
    bytes_.reserve(header_size + 8 * items * numbers_per_item(kind, axes_));
    bytes_.resize(header_size);
    bytes_[0] = std::byte{'p'}, bytes_[1] = std::byte{'l'}, bytes_[2] = format;
    bytes_[axes_at] = std::byte(axes), bytes_[kind_at] = std::byte(kind);
  }

  void put(double number) {
    step_();
    const auto* first = reinterpret_cast<const std::byte*>(&number);
    bytes_.insert(bytes_.end(), first, first + sizeof number);
  }
  void put(const std::array<double, 3>& vector) {
    for (std::size_t j = 0; j < axes_; ++j) put(vector[j]);
  }
  std::vector<std::byte> finish() { return std::move(bytes_); }

 private:
  Steps step_;
  std::size_t axes_;
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  Reader(std::span<const std::byte> bytes, std::size_t axes, Interrupt& interrupt)
      : step_(interrupt), bytes_(bytes), axes_(axes) {}

  bool at_end() const { return at_ == bytes_.size(); }

  double finite() {
    const double value = number();
    if (!std::isfinite(value)) refuse();
    return value;
  }
  /// Skips a knot whose `numbers` numbers are all NaN, between two others; false if the next one is another.
  bool takes_separator(std::size_t numbers) {
    const std::size_t end = at_ + 8 * numbers;
    if (at_ == header_size || end >= bytes_.size()) return false;
    for (std::size_t at = at_; at < end; at += 8)
      if (!std::isnan(number_at(at))) return false;
    at_ = end;
    return true;
  }
  /// Infinite only as the last time of the plan, behind which `more` numbers follow.
  double time(std::size_t more) {
    const double value = number();
    const bool is_last = at_ + 8 * more == bytes_.size();
    if (!std::isfinite(value) && !(is_last && value == no_end)) refuse();
    return value;
  }
  std::array<double, 3> vector() {
    std::array<double, 3> numbers{};
    for (std::size_t j = 0; j < axes_; ++j) numbers[j] = finite();
    return numbers;
  }

 private:
  double number_at(std::size_t at) const {
    double value;
    std::memcpy(&value, &bytes_[at], sizeof value);
    return value;
  }
  double number() {
    step_();
    const double value = number_at(at_);
    at_ += sizeof value;
    return value;
  }
  [[noreturn]] void refuse() const {
    throw Error("byte " + std::to_string(at_ - sizeof(double)) + ": not a finite number");
  }

  Steps step_;
  std::span<const std::byte> bytes_;
  std::size_t axes_;
  std::size_t at_ = header_size;
};

/// The kind, of a blob whose header and size are right. Throws Error.
PlanKind checked_kind(std::span<const std::byte> blob) {
  if (blob.empty()) throw Error("an empty blob is no plan");
  if (blob.size() < header_size || blob[0] != std::byte{'p'} || blob[1] != std::byte{'l'}) {
    const bool is_text = blob[0] == std::byte{'L'} || blob[0] == std::byte{'M'};  // LINESTRING, as bytes
    throw Error("a blob of " + std::to_string(blob.size()) +
                " bytes that does not start with 'pl' is no plan: write " +
                (is_text ? "the text as text, not as a blob" : "one of plan_points"));
  }
  const auto refuse = [&](std::size_t at, const char* rule) {
    throw Error("byte " + std::to_string(at) + " is " + std::to_string(std::to_integer<int>(blob[at])) +
                rule);
  };
  if (blob[2] != format) refuse(2, ", a format that this version does not know; write 1");
  const auto axes = std::to_integer<std::size_t>(blob[axes_at]),
             kind = std::to_integer<std::size_t>(blob[kind_at]);
  if (axes < 1 || axes > 3) refuse(axes_at, " axes; write 1, 2 or 3");
  if (kind > 2) refuse(kind_at, ", no kind of plan; write 0, 1 or 2");
  for (std::size_t at = kind_at + 1; at < header_size; ++at)
    if (blob[at] != std::byte{0}) refuse(at, "; write 0");
  const std::size_t item = 8 * numbers_per_item(static_cast<PlanKind>(kind), axes);
  if ((blob.size() - header_size) % item != 0)
    throw Error("a blob of " + std::to_string(blob.size()) + " bytes: write 8 bytes and " +
                std::to_string(item) + (kind == 0 ? " per knot" : " per leg"));
  return static_cast<PlanKind>(kind);
}

}  // namespace

std::vector<std::byte> encode_plan(const Plan& plan, Interrupt& interrupt) {
  const bool has_knots = plan.kind == PlanKind::knots;
  const std::size_t items = has_knots ? plan.knots.size() + plan.parts() - 1 : plan.legs.size();
  Writer writer(plan.kind, plan.axes, items, interrupt);
  const auto put_knot = [&writer](const Knot& knot) {
    writer.put(knot.t);
    writer.put(knot.x);
  };
  for (std::size_t part = 0; has_knots && part < plan.parts(); ++part) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (part > 0) put_knot({nan, {nan, nan, nan}});
    for (std::size_t i = plan.part_starts[part]; i < plan.part_end(part); ++i) put_knot(plan.knots[i]);
  }
  for (const Leg& leg : plan.legs) {
    writer.put(leg.t);
    writer.put(leg.until);
    writer.put(leg.x);
    writer.put(leg.v);
    if (plan.kind == PlanKind::accelerated) writer.put(leg.a);
  }
  return writer.finish();
}

Plan decode_plan(std::span<const std::byte> blob, Interrupt& interrupt) {
  const FloatEnvironment environment;
  Plan plan;
  plan.kind = checked_kind(blob);
  plan.axes = std::to_integer<int>(blob[axes_at]);
  const auto axes = static_cast<std::size_t>(plan.axes);
  const std::size_t per_item = numbers_per_item(plan.kind, axes),
                    items = (blob.size() - header_size) / 8 / per_item;
  Reader reader(blob, axes, interrupt);
  if (plan.kind == PlanKind::knots) {
    plan.knots.reserve(items);
    while (!reader.at_end()) {
      if (reader.takes_separator(per_item)) plan.part_starts.push_back(plan.knots.size());
      const double t = reader.time(axes);
      plan.knots.push_back({t, reader.vector()});
    }
  } else {
    plan.legs.reserve(items);
    while (!reader.at_end()) {
      Leg leg;
      leg.t = reader.finite();
      leg.until = reader.time(per_item - 2);
      leg.x = reader.vector(), leg.v = reader.vector();
      if (plan.kind == PlanKind::accelerated) leg.a = reader.vector();
      plan.legs.push_back(leg);
    }
  }
  check_plan(plan);
  return plan;
}

}  // namespace foresee
