// Which column names does moving_objects know? The fixed vocabulary of motion and shape, without `id`.
//
//   find_word("VX")->quantity == Quantity::velocity && find_word("VX")->axis == 0
//   nearest_word("vxx") == "vx"
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace foresee {

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
  until,  // the last one
};
constexpr int quantity_count = static_cast<int>(Quantity::until) + 1;

struct Word {
  std::string_view name;
  Quantity quantity;
  int axis;  ///< 0 where the quantity has no axes
};

/// The word of this name in any case, or null.
const Word* find_word(std::string_view name);

/// The word for a quantity along an axis, e.g. "vy".
std::string_view word_for(Quantity quantity, int axis);

/// "id" and all words, as messages list them: "id, t, x, …".
std::string known_words();

/// What reports call a thing that is another word here, or has to be converted: what to write for "lat",
/// "sog", "radius" and the like; "" for other names.
std::string_view advice_for(std::string_view name);

/// The known word (or "id") that differs from `name` by one letter or two, or "" if none is that near.
std::string_view nearest_word(std::string_view name);

}  // namespace foresee
