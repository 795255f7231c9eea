// Kinds of objects: collision filtering by category bits and mask bits, the rule that says which kinds may meet.
//
//   const Kinds moored{.category = 2, .mask = 1}, under_way{.category = 1, .mask = 3};
//   may_meet(moored, under_way);           // true: each has a category bit that the other's mask has
//   !may_meet(moored, moored);
//
// The rule is that of Box2D, Jolt and Bullet. A node of a tree keeps the kinds of all objects beneath it, or-ed:
// if two nodes may not meet, no two of their objects may. A table without the columns has the default kinds.
#pragma once

#include <cstdint>
#include <optional>

#include "shape/row_layout.h"

namespace foresee {

/// Every category bit, or every mask bit.
inline constexpr std::uint32_t every_kind = 0xffffffff;

struct Kinds {
  std::uint32_t category = 1;
  std::uint32_t mask = every_kind;

  /// Of no object: meets nothing.
  static constexpr Kinds none() { return {0, 0}; }

  constexpr void include(Kinds other) { category |= other.category, mask |= other.mask; }
  constexpr bool contains(Kinds other) const {
    return (other.category & ~category) == 0 && (other.mask & ~mask) == 0;
  }
  friend constexpr bool operator==(const Kinds&, const Kinds&) = default;
};

constexpr bool may_meet(Kinds a, Kinds b) {
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

/// The kinds that a search accepts: those that may meet an object, or those with one of some categories.
class KindTest {
 public:
  /// Accepts what may meet an object of these kinds.
  static constexpr KindTest of_partners(Kinds object) { return {object.mask, object.category}; }
  /// Accepts a category with a bit of `mask`, whatever its own mask is.
  static constexpr KindTest of_categories(std::uint32_t mask) { return {mask, std::nullopt}; }

  /// `kinds`: of one object, or of many, or-ed: then false if none of them is accepted.
  constexpr bool accepts(Kinds kinds) const {
    return (kinds.category & categories_) != 0 && (!masks_ || (kinds.mask & *masks_) != 0);
  }

 private:
  constexpr KindTest(std::uint32_t categories, std::optional<std::uint32_t> masks)
      : categories_(categories), masks_(masks) {}

  std::uint32_t categories_;
  std::optional<std::uint32_t> masks_;
};

constexpr bool has_kinds(const Layout& layout) {
  return layout.has_category || layout.has_mask;
}

/// The bits of a stored number; none of a number that has no bits, as NaN or -1.
constexpr std::uint32_t kind_bits(double number) {
  return number >= 0 && number <= every_kind ? static_cast<std::uint32_t>(number) : 0;
}

/// The kinds of an object, from its record or its row, whose offsets `at` has.
inline Kinds kinds_of(const double* numbers, const Offsets& at) {
  Kinds kinds;
  if (at.category != Offsets::absent) kinds.category = kind_bits(numbers[at.category]);
  if (at.mask != Offsets::absent) kinds.mask = kind_bits(numbers[at.mask]);
  return kinds;
}

}  // namespace foresee
