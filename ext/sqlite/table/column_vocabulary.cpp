#include "sqlite/table/column_vocabulary.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "sqlite/sql_tokens.h"

namespace foresee {
namespace {

constexpr std::array words = {
    Word{"t", Quantity::reference_time, 0}, Word{"x", Quantity::centre, 0},
    Word{"y", Quantity::centre, 1},         Word{"z", Quantity::centre, 2},
    Word{"vx", Quantity::velocity, 0},      Word{"vy", Quantity::velocity, 1},
    Word{"vz", Quantity::velocity, 2},      Word{"ax", Quantity::acceleration, 0},
    Word{"ay", Quantity::acceleration, 1},  Word{"az", Quantity::acceleration, 2},
    Word{"fx", Quantity::force, 0},         Word{"fy", Quantity::force, 1},
    Word{"fz", Quantity::force, 2},         Word{"m", Quantity::mass, 0},
    Word{"hx", Quantity::half_extent, 0},   Word{"hy", Quantity::half_extent, 1},
    Word{"hz", Quantity::half_extent, 2},   Word{"r", Quantity::radius, 0},
    Word{"shape", Quantity::form, 0},       Word{"heading", Quantity::heading, 0},
    Word{"growth", Quantity::growth, 0},    Word{"growth_z", Quantity::growth, 2},
    Word{"until", Quantity::until, 0},      Word{"category", Quantity::category, 0},
    Word{"mask", Quantity::mask, 0},        Word{"plan", Quantity::plan, 0},
    Word{"lat", Quantity::centre, 0},       Word{"lon", Quantity::centre, 1},
    Word{"speed", Quantity::velocity, 0},   Word{"course", Quantity::velocity, 1},
    Word{"zone", Quantity::form, 0},
};

/// A column name of other data formats.
struct ForeignWord {
  std::string_view name, hint;
};
constexpr ForeignWord foreign_words[] = {
    {"latitude", "did you mean lat?"},
    {"lng", "did you mean lon?"},
    {"long", "did you mean lon?"},
    {"longitude", "did you mean lon?"},
    {"sog", "did you mean speed, with speed_unit = knots?"},
    {"cog", "did you mean course?"},
    {"velocity", "did you mean speed and course, or vx and vy?"},
    {"radius", "did you mean r?"},
    {"time", "did you mean t?"},
    {"timestamp", "did you mean t?"},
    {"width", "did you mean hx, half of it?"},
    {"length", "did you mean hy, half of it?"},
    {"height", "did you mean hz, half of it, or z?"},
    {"altitude", "did you mean z?"},
    {"alt", "did you mean z?"},
    {"climb", "did you mean vz?"},
    {"floor", "did you mean z, the middle, and hz, half of the height?"},
    {"ceiling", "did you mean z, the middle, and hz, half of the height?"},
    {"mmsi", "did you mean id?"},
    {"mass", "did you mean m?"},
    {"path", "did you mean plan?"},
    {"route", "did you mean plan?"},
    {"trip", "did you mean plan?"},
};

/// Levenshtein distance from a to b, without case.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchanged = diagonal + (same_name(a.substr(i - 1, 1), b.substr(j - 1, 1)) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, exchanged});
    }
  }
  return row[b.size()];
}

}  // namespace

const Word* find_word(std::string_view name) {
  const auto* found =
      std::find_if(words.begin(), words.end(), [&](const Word& word) { return same_name(word.name, name); });
  return found == words.end() ? nullptr : found;
}

std::string_view word_for(Quantity quantity, int axis, bool in_degrees) {
  std::string_view name;
  for (const Word& word : words)
    if (word.quantity == quantity && word.axis == axis && (name.empty() || in_degrees)) name = word.name;
  return name;
}

GeoColumn geo_column(std::string_view name, const Frame& frame) {
  constexpr std::array<std::string_view, geo_columns> names{"", "lat", "lon", "z", "speed", "course", "vz"};
  for (std::size_t i = 1; i < names.size(); ++i) {
    const auto column = static_cast<GeoColumn>(i);
    const bool of_globe = column == GeoColumn::height || column == GeoColumn::climb;
    if (same_name(names[i], name) && (!of_globe || frame.on_globe())) return column;
  }
  return GeoColumn::none;
}

Offsets declared_offsets(const Declaration& declaration) {
  Offsets at = record_offsets(declaration.layout);
  const auto stores = [&](Quantity quantity) {
    const auto has = [&](const MotionColumn& column) { return find_word(column.name)->quantity == quantity; };
    return std::any_of(declaration.columns.begin(), declaration.columns.end(), has);
  };
  if (!stores(Quantity::reference_time)) at.t = Offsets::absent;
  if (!stores(Quantity::until)) at.until = Offsets::absent;
  if (!stores(Quantity::velocity)) at.v = Offsets::absent;
  return at;
}

std::string known_words() {
  std::string list = "id";
  for (const Word& word : words) list += ", " + std::string(word.name);
  return list;
}

std::string_view hint_for(std::string_view name) {
  for (const ForeignWord& word : foreign_words)
    if (same_name(word.name, name)) return word.hint;
  return "";
}

std::string_view nearest_word(std::string_view name) {
  // One edit turns a one-letter word into any other, so only names of two letters or more have a neighbour.
  // At least half of the letters must match.
  std::string_view nearest;
  std::size_t limit = name.size() < 2 ? 0 : std::min<std::size_t>(2, name.size() / 2) + 1;
  auto consider = [&](std::string_view word) {
    const std::size_t edits = edits_between(name, word);
    if (word.size() > 1 && edits < limit) {
      limit = edits;
      nearest = word;
    }
  };
  consider("id");
  for (const Word& word : words) consider(word.name);
  return nearest;
}

}  // namespace foresee
