// Column vocabulary of moving_objects: the fixed names of motion and shape columns, without `id`.
//
//   find_word("VX")->quantity == Quantity::velocity && find_word("VX")->axis == 0
//   nearest_word("vxx") == "vx"
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "format/declaration.h"

namespace foresee {

/// The physical quantity that a column holds.
enum class Quantity : std::uint8_t {
  reference_time,
  centre,
  velocity,
  acceleration,
  force,
  mass,
  half_extent,
  radius,
  form,
  heading,
  growth,
  category,
  mask,
  plan,
  until,  // must stay last: quantity_count depends on it
};
constexpr int quantity_count = static_cast<int>(Quantity::until) + 1;

/// Whether a quantity is one of the kinds (shape/kinds.h) and not of the motion.
constexpr bool is_kind(Quantity quantity) {
  return quantity == Quantity::category || quantity == Quantity::mask;
}

/// Whether the first leg of a plan gives the quantity.
constexpr bool is_of_leg(Quantity quantity) {
  return quantity <= Quantity::acceleration;
}

/// One known column name.
struct Word {
  std::string_view name;
  Quantity quantity;
  int axis;  ///< 0 where the quantity has no axes
};

/// The word with this name, compared without case, or null.
const Word* find_word(std::string_view name);

/// The word for a quantity along an axis: "vy", or "course" in a table in degrees.
std::string_view word_for(Quantity quantity, int axis, bool in_degrees = false);

/// lat, lon, speed or course, on the globe also z and vz; `none` for all other words.
GeoColumn geo_column(std::string_view name, const Frame& frame = {});

/// Places of a record, without the t, until and velocity that no column stores: plans and accelerations need them.
Offsets declared_offsets(const Declaration& declaration);

/// "id" and all words as one comma-separated list for messages: "id, t, x, …".
std::string known_words();

/// Hint for a name of AIS and other data formats, such as "lat", "sog" or "radius": the known word, or the
/// function that converts it. "" for other names.
std::string_view hint_for(std::string_view name);

/// The known word (or "id") within edit distance 2 of `name`, or "" if no word is that near.
std::string_view nearest_word(std::string_view name);

}  // namespace foresee
