// Changes of the time at which an object starts.
#include <algorithm>
#include <cmath>

#include "motion/changes.h"

namespace foresee {
namespace {

/// Sets refer to the earliest start: no k of the range makes the object start before.
class DelayChanges final : public ChangesOf<DelayChanges> {
 public:
  DelayChanges(const OwnMotion& stored, double lo)
      : ChangesOf(reference_of(stored, lo)), stored_(stored), later_(stored.t - reference().t) {}

  const OwnMotion& unchanged() const override { return stored_; }
  bool starts_vary() const override { return true; }
  double min_change(double p, double q) const override {
    return 2 * rounding_at(std::max(std::abs(p), std::abs(q)));
  }

  template <int D>
  MotionSet<D> set_of(double p, double q) const {
    MotionSet<D> set = unchanged_set<D>();
    const double unsure = min_change(p, q);
    set.starts = {p + later_ - unsure, q + later_ + unsure, set.velocity};
    p += later_, q += later_;
    const double middle = p + 0.5 * (q - p);
    const Vec<D> v = vector_of<D>(reference().v), a = vector_of<D>(reference().a);
    const double furthest = std::max(std::abs(p), std::abs(q)), rounding = rounding_at(furthest);
    const double half = std::max(middle - p, q - middle) * (1 + 0x1p-50) + rounding;
    set.place.centre = -middle * (v - (0.5 * middle) * a);
    set.place.along = half * (v - middle * a);
    set.place.pad = 0.5 * half * half * a.abs() +
                    pad_of_stored * (furthest * (v.abs() + furthest * a.abs()) + half * v.abs());
    set.velocity = added_vectors<D>(v, -a, middle, half);
    set.begin = std::max(0.0, p - rounding);
    set.end += q + rounding;
    if (reference().until < std::numeric_limits<double>::infinity())
      set.end += 0x1p-52 * (std::abs(reference().until) + furthest + later_);
    return set;
  }

 private:
  static OwnMotion reference_of(OwnMotion stored, double lo) {
    const double t = lo < 0 ? stored.t + lo : stored.t;
    if (t < stored.t) stored.until -= stored.t - t, stored.t = t;
    return stored;
  }
  void change(OwnMotion& motion, double k) const override { motion.t += k, motion.until += k; }
  /// Of the stored sum t + k, and of `later` and its sums.
  double rounding_at(double furthest) const {
    return 0x1p-52 * (std::abs(reference().t) + furthest + 2 * later_);
  }

  OwnMotion stored_;
  double later_;
};

class NoChanges final : public ChangesOf<NoChanges> {
 public:
  using ChangesOf::ChangesOf;

  double min_change(double /*p*/, double /*q*/) const override { return 0; }
  template <int D>
  MotionSet<D> set_of(double /*p*/, double /*q*/) const {
    return unchanged_set<D>();
  }

 private:
  void change(OwnMotion& /*motion*/, double /*k*/) const override {}
};

}  // namespace

std::unique_ptr<Changes> delays_of(const OwnMotion& stored, double lo) {
  return std::make_unique<DelayChanges>(stored, lo);
}

std::unique_ptr<Changes> no_changes_of(const OwnMotion& motion) {
  return std::make_unique<NoChanges>(motion);
}

}  // namespace foresee
