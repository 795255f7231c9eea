// When could two of many boxes touch, at most? What the chord (certain/chord.h) says of their faces, for
// boxes that all lie within two others: whatever is the same for all of them is added up first.
//
//   const BoxChord<2> chord(Chord<2>(relative, end), box_around_a, box_around_b, grown);
//   const Period<double> near = chord.between(box_of_a, box_of_b, asked);        // empty: they never touch
//
// Rounding loses far less than the slack that all of it is given. Numbers too large for that take the way of
// the chord itself. Cost: some nanoseconds.
#pragma once

#include "contact/certain/chord.h"
#include "motion/box.h"

namespace foresee {

/// Of boxes on the first axes of D.
template <int axes, int D = axes>
class BoxChord {
 public:
  /// `grown`: how near counts as touching.
  BoxChord(const Chord<D>& chord, const Box<axes>& around_a, const Box<axes>& around_b, const Bounded& grown)
      : chord_(chord), grown_(grown) {
    const Vec<axes> sizes = reach(around_a) + reach(around_b);
    for (int j = 0; j < axes; ++j) {
      const auto [at, steep, room] = chord.along(j);
      const double more = grown.value + grown.error;
      const double beside = room + more + 0x1p-40 * (sizes[j] + std::abs(at) + more);
      steep_[j] = steep, below_[j] = -beside - at, above_[j] = beside - at;
      is_plain_ &= sizes[j] + beside + std::abs(at) < 0x1p1000 && std::abs(steep) <= 0x1p1000;
    }
  }

  /// Of `asked`.
  Period<double> between(const Box<axes>& a, const Box<axes>& b, const Period<double>& asked) const {
    return is_plain_ ? plainly_between(a, b, asked) : carefully_between(a, b, asked);
  }

  bool is_plain() const { return is_plain_; }
  /// Also of boxes of floats. Requires: is_plain().
  template <class AnyBox>
  Period<double> plainly_between(const AnyBox& a, const AnyBox& b, Period<double> asked) const {
    const auto gap = [](double to, double from) { return to - from; };
    for (int i = 0; i < axes; ++i) {
      const auto j = static_cast<decltype(a.lower.size())>(i);
      const double one = (gap(a.lower[j], b.upper[j]) + below_[i]) * steep_[i];
      const double other = (gap(a.upper[j], b.lower[j]) + above_[i]) * steep_[i];
      asked.begin = greater(lesser(one, other), asked.begin);
      asked.end = lesser(greater(one, other), asked.end);
    }
    return asked;
  }

 private:
  static Vec<axes> reach(const Box<axes>& box) { return box.lower.abs().max(box.upper.abs()); }

  [[gnu::noinline]] Period<double> carefully_between(const Box<axes>& a, const Box<axes>& b,
                                                     const Period<double>& asked) const {
    static constexpr Faces faces[] = {{.axis = 0, .below = {0}, .above = {1}},
                                      {.axis = 1, .below = {2}, .above = {3}},
                                      {.axis = 2, .below = {4}, .above = {5}}};
    Bounded most[2 * axes];
    for (int j = 0; j < axes; ++j) {
      most[2 * j] = Bounded{b.upper[j]} - Bounded{a.lower[j]} + grown_;
      most[2 * j + 1] = Bounded{a.upper[j]} - Bounded{b.lower[j]} + grown_;
    }
    return chord_.between(faces, axes, most, asked);
  }

  const Chord<D>& chord_;
  const Bounded grown_;
  double steep_[axes], below_[axes], above_[axes];
  bool is_plain_ = true;
};

}  // namespace foresee
