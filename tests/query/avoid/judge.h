// The reference answer of avoidance for single changes, and scenes where the last bits decide touching.
// It is decided by exact contact or, for separation on bent paths, in long double.
//
//   const Judge judge(question);
//   judge.is_surely_clear(12.5)
//
// Every clear interval wider than 10^-6 of the range must be in a clear row, if velocities within 64 units in
// the last place leave it clear. On bent paths, for delays and beside objects that start later, sizes within
// 10^-13 of the lengths at hand must leave it clear, too (docs/explanation/avoidance.md, "Tight").
#pragma once

#include "query/avoid/avoid_cases.h"
#include "query/avoid/plain_pair.h"

namespace foresee::testing {

/// Random scenes in which many pairs touch exactly, or miss by 2^-40: many sizes, positions and velocities
/// are small whole numbers.
class SceneOfTies {
 public:
  SceneOfTies(const Layout& layout, Random& random) : at_(record_offsets(layout)), random_(random) {
    scene_.layout = layout;
    scene_.h = random.below(3) == 0 ? 100 : static_cast<double>(1 + random.below(30));
  }

  RandomScene made() {
    const bool starts_later = random_.below(3) == 0;
    add(starts_later ? static_cast<double>(random_.below(20)) : 0, vector(random_.below(3) == 0 ? 100 : 0),
        vector(8), bent());
    const std::size_t count = 1 + random_.below(4);
    for (std::size_t i = 0; i < count; ++i) add_other();
    scene_.rows.clear();
    std::vector<double> row(static_cast<std::size_t>(row_offsets(scene_.layout).size));
    for (std::size_t i = 0; i < scene_.size(); ++i) {
      row_from_record(scene_.layout, record(i), row.data());
      scene_.rows.insert(scene_.rows.end(), row.begin(), row.end());
    }
    return scene_;
  }

 private:
  using Numbers = std::array<double, 3>;

  const double* record(std::size_t i) const {
    return scene_.records.data() + i * static_cast<std::size_t>(at_.size);
  }
  double tie() { return (static_cast<double>(random_.below(3)) - 1) * 0x1p-40; }
  double number(double size) {
    if (size == 0) return 0;
    return random_.below(2) ? std::floor(random_.in(-size, size + 1)) : random_.in(-size, size);
  }
  Numbers vector(double size) {
    Numbers numbers{};
    for (int axis = 0; axis < scene_.layout.axes; ++axis)
      numbers[static_cast<std::size_t>(axis)] = random_.below(4) == 0 ? 0 : number(size);
    return numbers;
  }
  Numbers bent() { return scene_.layout.law == Law::accelerated && random_.below(3) ? vector(1) : Numbers{}; }

  void add(double t, const Numbers& x, const Numbers& v, const Numbers& a, double size = 5) {
    std::vector<double> one(static_cast<std::size_t>(at_.size), size);
    const auto put = [&](int place, const Numbers& numbers) {
      for (int axis = 0; axis < scene_.layout.axes && place != Offsets::absent; ++axis)
        one[static_cast<std::size_t>(place + axis)] = numbers[static_cast<std::size_t>(axis)];
    };
    put(at_.x, x), put(at_.v, v), put(at_.a, a);
    if (at_.t != Offsets::absent) one[static_cast<std::size_t>(at_.t)] = t;
    if (at_.until != Offsets::absent)
      one[static_cast<std::size_t>(at_.until)] =
          random_.below(3) ? HUGE_VAL : t + static_cast<double>(1 + random_.below(30));
    scene_.records.insert(scene_.records.end(), one.begin(), one.end());
    scene_.ids.push_back(static_cast<std::int64_t>(scene_.size()) + 1);
  }

  /// An object on nearly the same course, moored or anywhere; beside the first within some last bits, or
  /// anywhere.
  void add_other() {
    const double* const own = record(0);
    const auto axes = static_cast<std::size_t>(scene_.layout.axes);
    Numbers x{}, v{}, a = bent();
    const std::uint64_t course = random_.below(4);
    for (std::size_t axis = 0; axis < axes; ++axis)
      v[axis] = course == 0 ? own[at_.v + static_cast<int>(axis)] + (random_.below(2) ? tie() : 0) : 0;
    if (course > 1) v = vector(8);
    const double own_t = own[at_.t], t = random_.below(2) ? own_t : static_cast<double>(random_.below(20));
    const std::uint64_t place = random_.below(5);
    if (place == 0) return add(t, vector(40), v, a, random_.below(2) ? 5 : random_.in(1, 9));
    // At the distance at which both just touch, or overlap, at the own t.
    static constexpr double pythagorean[][3] = {{1, 0, 0}, {0, 1, 0},  {0.6, 0.8, 0}, {-0.8, 0.6, 0},
                                                {0, 0, 1}, {-1, 0, 0}, {0, -1, 0},    {0.28, -0.96, 0}};
    const auto& side = pythagorean[axes == 1 ? 5 * random_.below(2) : random_.below(8)];
    const double far = place < 3 ? 10 + (place == 1 ? tie() : 0) : random_.in(0, 12);
    const bool askew = scene_.layout.law == Law::uniform && t == own_t && random_.below(2);
    for (std::size_t axis = 0; axis < axes; ++axis) {
      x[axis] = own[at_.x + static_cast<int>(axis)] + far * side[axis] + (askew ? tie() : 0);
      x[axis] -= (own_t - t) * (v[axis] + 0.5 * (own_t - t) * a[axis]);
    }
    add(t, x, v, a);
  }

  RandomScene scene_;
  Offsets at_;
  Random& random_;
};

/// Decides single changes of a query with a given range.
class Judge {
 public:
  explicit Judge(const AvoidQuestion& question) : queried_(question) {
    queried_.wants_motion = queried_.wants_ends = false;
    for (unsigned signs = 0; signs < 1U << question.own_scene->layout.axes; ++signs)
      aside_.push_back(aside(signs));
  }

  bool is_clear(double k) const { return is_clear_in(queried_, k); }
  /// For all last bits of the velocity, and for objects that are larger by 10^-13 of the lengths at hand.
  bool is_surely_clear(double k) const {
    if (!is_clear(k)) return false;
    for (const AvoidQuestion& one : aside_)
      if (!is_clear_in(one, k)) return false;
    return is_clear_of_larger(k);
  }

  /// With all sizes smaller by a billionth: what still touches does not only graze.
  bool is_clear_of_smaller(double k) const {
    AvoidQuestion smaller = queried_;
    const Scene &own = *queried_.own_scene, &others = *queried_.others.scene;
    std::vector<double> own_rows = own.rows, other_rows = others.rows;
    const auto shrink = [](const Layout& layout, const Offsets& at, std::vector<double>& rows) {
      for (std::size_t first = 0; first < rows.size(); first += static_cast<std::size_t>(at.size))
        for (const int place : {at.r, at.hz, at.half, at.half + 1, at.half + 2}) {
          if (place < 0 || (at.half == Offsets::absent && place != at.r && place != at.hz)) continue;
          if (at.half != Offsets::absent && place >= at.half + layout.axes) continue;
          rows[first + static_cast<std::size_t>(place)] *= 1 - 1e-9;
        }
    };
    shrink(own.layout, row_offsets(own.layout), own_rows);
    shrink(others.layout, row_offsets(others.layout), other_rows);
    shrink(own.layout, record_offsets(own.layout), smaller.record);
    smaller.own_scene = scene_of(own.layout, own.ids, own_rows);
    smaller.others.scene = scene_of(others.layout, others.ids, other_rows);
    return is_clear_in(smaller, k);
  }

 private:
  /// On bent paths, of objects that start later and of delays doubles cannot decide less than `share`. What is
  /// nearer than that at the start counts as touching, and must separate.
  bool is_clear_of_larger(double k) const {
    const bool bends = queried_.own_scene->layout.law == Law::accelerated,
               delays = *queried_.how == Manoeuvre::delay;
    AvoidQuestion question = queried_;
    question.touching = Touching::ignore, question.lo = question.hi = k, question.wants_motion = true;
    const std::vector<double> record = rows_of(question).at(0).record;
    const Scene& others = *queried_.others.scene;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (others.ids[i] == queried_.own_scene->ids[0]) continue;
      const PlainPair pair = pair_of(queried_, record, others.bodies(), i);
      const bool starts_later = pair.end < 0;
      if (!bends && !delays && !starts_later) continue;
      const PlainPair::Real share = 0x1p-43L * pair.length();
      question.within = static_cast<double>(share);
      if (question.own_scene->layout.shape == Shape::cylinder) question.within_z = question.within;
      if (!delays && !starts_later && touches_first(queried_, record, i)) {
        if (queried_.touching == Touching::part && !(separates_by(pair, share) && separates_nearby(pair)))
          return false;
      } else if (!delays && !starts_later && touches_first(question, record, i)) {
        if (!pair.grown(share).separates()) return false;
      } else if (touches(question, record, i)) {
        return false;
      }
    }
    return true;
  }
  /// With all sizes larger or smaller by up to `share`.
  static bool separates_by(const PlainPair& pair, PlainPair::Real share) {
    for (int i = 0; i < 8; ++i, share /= 4)
      if (!pair.grown(share).separates() || !pair.grown(-share).separates()) return false;
    return true;
  }
  /// With the own velocity off by last places towards the other object, or along its acceleration.
  bool separates_nearby(const PlainPair& pair) const {
    PlainPair towards = pair, along = pair;
    PlainPair::Real times = HUGE_VAL;
    for (int axis = 0; axis < pair.axes; ++axis) {
      const auto j = static_cast<std::size_t>(axis);
      const PlainPair::Real off = last_places(axis);
      if (pair.d[j] != 0) towards.w[j] -= pair.d[j] > 0 ? off : -off;
      if (pair.b[j] != 0) times = std::min(times, off / std::abs(pair.b[j]));
    }
    for (std::size_t j = 0; j < 3 && times < HUGE_VAL; ++j) along.w[j] -= times * pair.b[j];
    return towards.separates() && along.separates();
  }
  /// 64 units in the last place of the own velocity; for a turn, of its longest component.
  double last_places(int axis) const {
    const Layout& layout = queried_.own_scene->layout;
    const double* const v = queried_.record.data() + record_offsets(layout).v;
    double unit = std::abs(v[axis]);
    if (*queried_.how == Manoeuvre::turn && axis < 2)
      for (int one = 0; one < layout.axes; ++one) unit = std::max(unit, std::abs(v[one]));
    return unit > 0 ? 64 * (std::nextafter(unit, HUGE_VAL) - unit) : 0;
  }
  /// With the own velocity off by last places, along each axis to the side that a bit says.
  AvoidQuestion aside(unsigned signs) const {
    AvoidQuestion other = queried_;
    const Layout& layout = other.own_scene->layout;
    double* const v = other.record.data() + record_offsets(layout).v;
    for (int axis = 0; axis < layout.axes; ++axis)
      v[axis] += (signs >> axis & 1 ? 1 : -1) * last_places(axis);
    std::vector<double> row(static_cast<std::size_t>(row_offsets(layout).size));
    row_from_record(layout, other.record.data(), row.data());
    other.own_scene = scene_of(layout, other.own_scene->ids, row);
    return other;
  }

  static bool is_clear_in(AvoidQuestion question, double k) {
    const bool parts = question.touching == Touching::part && *question.how != Manoeuvre::delay &&
                       question.own_scene->layout.law == Law::accelerated;
    if (!parts) return testing::is_clear(question, *question.how, k);
    question.touching = Touching::ignore;
    if (!testing::is_clear(question, *question.how, k)) return false;
    question.lo = question.hi = k, question.wants_motion = true;
    const std::vector<double> record = rows_of(question).at(0).record;
    const Scene& others = *question.others.scene;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (others.ids[i] == question.own_scene->ids[0]) continue;
      const PlainPair pair = pair_of(question, record, others.bodies(), i);
      if (pair.end >= 0 && touches_first(question, record, i) && !pair.separates()) return false;
    }
    return true;
  }

  static bool touches_first(const AvoidQuestion& question, const std::vector<double>& record, std::size_t i) {
    const double t = record[static_cast<std::size_t>(record_offsets(question.own_scene->layout).t)];
    return touches_during(question, record, i, {std::max(question.now, t), 0});
  }
  static bool touches(const AvoidQuestion& question, const std::vector<double>& record, std::size_t i) {
    return touches_during(question, record, i, {question.now, question.h});
  }
  static bool touches_during(const AvoidQuestion& question, const std::vector<double>& record, std::size_t i,
                             const Horizon& horizon) {
    const Layout& layout = question.own_scene->layout;
    std::vector<double> own(static_cast<std::size_t>(row_offsets(layout).size));
    row_from_record(layout, record.data(), own.data());
    const auto contact = make_contact({layout, own.data(), 1}, question.others.scene->bodies(),
                                      {horizon, question.within, question.within_z}, "own", "others");
    const Pair pair{0, static_cast<std::uint32_t>(i)};
    std::vector<Pair> hits;
    contact->decide({&pair, 1}, hits);
    return !hits.empty();
  }

  static PlainPair pair_of(const AvoidQuestion& question, const std::vector<double>& record,
                           const Bodies& others, std::size_t i) {
    const Layout& layout = question.own_scene->layout;
    std::vector<double> own(static_cast<std::size_t>(row_offsets(layout).size));
    row_from_record(layout, record.data(), own.data());
    const double* const other = others.row(i);
    const Offsets& at = others.at;
    const double first = std::max(question.now, own[static_cast<std::size_t>(at.t)]);
    PlainPair pair;
    pair.axes = layout.axes;
    pair.round = layout.shape == Shape::ball ? layout.axes : layout.shape == Shape::cylinder ? 2 : 0;
    const auto side = [&](const double* row, int sign) {
      const PlainPair::Real age = static_cast<PlainPair::Real>(first) - row[at.t];
      for (int axis = 0; axis < layout.axes; ++axis) {
        const auto j = static_cast<std::size_t>(axis);
        const double a = value_or(row, at.a == Offsets::absent ? at.a : at.a + axis, 0);
        pair.d[j] += sign * (row[at.x + axis] + age * (row[at.v + axis] + age * a / 2));
        pair.w[j] += sign * (row[at.v + axis] + age * a), pair.b[j] += sign * static_cast<PlainPair::Real>(a);
        if (at.half != Offsets::absent) pair.half[j] += row[at.half + axis];
      }
      if (at.r != Offsets::absent) pair.radius += row[at.r];
      if (at.hz != Offsets::absent) pair.half[2] += row[at.hz];
    };
    side(own.data(), -1), side(other, 1);
    pair.radius += question.within, pair.half[2] += question.within_z.value_or(0);
    if (at.half != Offsets::absent)
      for (auto& half : pair.half) half += question.within;
    const double until = std::min({question.now + question.h, value_or(own.data(), at.until, HUGE_VAL),
                                   value_or(other, at.until, HUGE_VAL)});
    pair.end = other[at.t] <= first ? static_cast<PlainPair::Real>(until) - first : -1;
    return pair;
  }

  AvoidQuestion queried_;
  std::vector<AvoidQuestion> aside_;
};

}  // namespace foresee::testing
