// Queries of avoidance, and the reference answer: single changes, decided by exact contact.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "base/number_text.h"
#include "never_interrupt.h"
#include "query/avoid/avoid.h"
#include "query/search_cases.h"

namespace foresee::testing {

/// About the object in row `i` of the scene.
inline AvoidQuestion avoid_question(const RandomScene& scene, std::size_t i, const SearchTarget& others) {
  const auto stored = static_cast<std::size_t>(record_offsets(scene.layout).size);
  const auto read = static_cast<std::size_t>(row_offsets(scene.layout).size);
  AvoidQuestion question;
  question.own_scene = scene_of(scene.layout, {scene.ids[i]},
                                {scene.rows.begin() + static_cast<std::ptrdiff_t>(i * read),
                                 scene.rows.begin() + static_cast<std::ptrdiff_t>((i + 1) * read)});
  question.record = {scene.records.begin() + static_cast<std::ptrdiff_t>(i * stored),
                     scene.records.begin() + static_cast<std::ptrdiff_t>((i + 1) * stored)};
  question.others = others;
  question.now = scene.now, question.now_given = true;
  question.h = scene.h, question.within = scene.within;
  return question;
}

inline std::vector<AvoidRow> rows_of(const AvoidQuestion& question) {
  return avoid(question, never);
}

/// Whether one change is clear, decided exactly.
inline bool is_clear(AvoidQuestion question, Manoeuvre manoeuvre, double k) {
  question.how = manoeuvre, question.lo = question.hi = k;
  question.wants_motion = question.wants_ends = false;
  return rows_of(question).at(0).clear;
}

/// The query of the same object once the change is stored, with velocities off by some units in the last
/// place. For a turn that is the last place of the largest component.
inline AvoidQuestion after(const AvoidQuestion& question, Manoeuvre manoeuvre, double k, Random& random) {
  AvoidQuestion changed = question;
  changed.how = manoeuvre, changed.lo = changed.hi = k, changed.wants_ends = false;
  changed.record = rows_of(changed).at(0).record;
  const Layout& layout = question.own_scene->layout;
  const Offsets at = record_offsets(layout);
  if (at.v != Offsets::absent) {
    double* const v = changed.record.data() + at.v;
    double longest = 0;
    for (int axis = 0; axis < layout.axes; ++axis) longest = std::max(longest, std::abs(v[axis]));
    for (int axis = 0; axis < layout.axes; ++axis) {
      const bool turns = manoeuvre == Manoeuvre::turn && axis < 2;
      const double unit = turns ? longest : std::abs(v[axis]);
      const double ulp = std::nextafter(unit, HUGE_VAL) - unit;
      if (unit > 0) v[axis] += (static_cast<double>(random.below(9)) - 4) * ulp;
    }
  }
  std::vector<double> row(static_cast<std::size_t>(row_offsets(layout).size));
  row_from_record(layout, changed.record.data(), row.data());
  changed.own_scene = scene_of(layout, question.own_scene->ids, row);
  return changed;
}

/// The rows as text, to compare them.
inline std::string text_of(const std::vector<AvoidRow>& rows) {
  std::string text;
  for (const AvoidRow& row : rows) {
    text += std::string(name_of(row.manoeuvre)) + (row.clear ? " clear " : " blocked ") + shown(row.k_from) +
            " to " + shown(row.k_to) + " by";
    for (const auto& end : {row.below, row.above})
      text +=
          end ? " " + std::to_string(end->table) + "." + std::to_string(end->id) + "@" + shown(end->t) : " -";
    text += "\n";
  }
  return text;
}

/// Rows tile the range; ends of clear rows are clear, and so are the changes inside.
inline void expect_sound(const AvoidQuestion& question, const std::vector<AvoidRow>& rows, Random& random) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const AvoidRow& row = rows[i];
    ASSERT_LE(row.k_from, row.k_to);
    ASSERT_TRUE(row.k_from <= row.k && row.k <= row.k_to);
    if (i > 0 && rows[i - 1].manoeuvre == row.manoeuvre) {
      ASSERT_EQ(rows[i - 1].k_to, row.k_from);
      ASSERT_NE(rows[i - 1].clear, row.clear);
    }
    if (row.k_from <= 0 && row.k_to >= 0 && row.clear) {
      ASSERT_TRUE(is_clear(question, row.manoeuvre, 0));
    }
    if (!row.clear) continue;
    const double width = row.k_to - row.k_from;
    std::vector<double> queried{row.k_from, row.k_to, row.k};
    for (int j = 0; j < 6; ++j) queried.push_back(row.k_from + width * random.unit());
    for (int j = 0; j < 4; ++j) {
      const double near = width * std::exp2(-random.in(1, 45));
      queried.push_back(row.k_from + near), queried.push_back(row.k_to - near);
    }
    // An object ignored because it has grown since its report need not touch at first in a new one.
    const bool ignores = question.touching == Touching::ignore && grows(question.own_scene->layout);
    if (width > 0 && row.manoeuvre != Manoeuvre::delay && !ignores)
      for (const double k : {row.k_from, row.k_to}) {
        if (k == 0) continue;
        AvoidQuestion stored = after(question, row.manoeuvre, k, random);
        stored.how = Manoeuvre::speed, stored.lo = stored.hi = 0;  // as it is
        stored.wants_motion = false;
        const std::vector<AvoidRow> answer = rows_of(stored);
        ASSERT_TRUE(answer.empty() || answer[0].clear) << shown(k) << " nearby, in\n" << text_of(rows);
      }
    for (const double k : queried)
      if (row.k_from <= k && k <= row.k_to) {
        ASSERT_TRUE(is_clear(question, row.manoeuvre, k))
            << name_of(row.manoeuvre) << " " << shown(k) << " in\n"
            << text_of(rows);
      }
  }
}

/// Blocked rows hold no clear range of more than 10^-6 of all; an end is as near as that to a touching
/// change.
inline void expect_tight(const AvoidQuestion& question, const std::vector<AvoidRow>& rows, Random& random) {
  if (rows.empty()) return;
  const double lo = rows.front().k_from, hi = rows.back().k_to, tolerance = 1e-6 * (hi - lo);
  // A start is stored to a unit in its last place: near 1e9 no end is that near.
  if (rows[0].manoeuvre == Manoeuvre::delay && question.now > 1e6) return;
  for (const AvoidRow& row : rows) {
    if (row.clear || !(row.k_to - row.k_from > tolerance)) continue;
    for (const bool upward : {true, false}) {
      bool touches = false;
      for (const double share : {0.0, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
        const double k = upward ? row.k_from + share * tolerance : row.k_to - share * tolerance;
        touches = touches || !is_clear(question, row.manoeuvre, k);
      }
      ASSERT_TRUE(touches) << (upward ? "lower" : "upper") << " end of a blocked row in\n" << text_of(rows);
    }
    for (int j = 0; j < 8; ++j) {
      const double k = random.in(row.k_from + tolerance, row.k_to - tolerance);
      bool clear = true;
      for (int step = -4; step <= 4; ++step)
        clear = clear && is_clear(question, row.manoeuvre, k + 0.25 * step * tolerance);
      ASSERT_FALSE(clear) << shown(k) << " seems clear in\n" << text_of(rows);
    }
  }
}

}  // namespace foresee::testing
