// Changes of the time at which an object starts, and legs that follow a change.
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
    p += later_;
    q += later_;
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
    if (t < stored.t) {
      stored.until -= stored.t - t;
      stored.t = t;
    }
    return stored;
  }
  void change(OwnMotion& motion, double k) const override {
    motion.t += k;
    motion.until += k;
  }
  /// Of the stored sum t + k, and of `later` and its sums.
  double rounding_at(double furthest) const {
    return 0x1p-52 * (std::abs(reference().t) + furthest + 2 * later_);
  }

  OwnMotion stored_;
  double later_;
};

/// It stands until k after the start: the set is that of the longest stand.
class RestChanges final : public ChangesOf<RestChanges> {
 public:
  explicit RestChanges(OwnMotion base) : ChangesOf(resting(base)) {}

  double min_change(double p, double q) const override {
    return 0x1p-51 * (std::abs(reference().t) + std::max(std::abs(p), std::abs(q)));
  }

  template <int D>
  MotionSet<D> set_of(double /*p*/, double q) const {
    MotionSet<D> set;
    set.end = q * (1 + 0x1p-50) + 0x1p-52 * (std::abs(reference().t) + q);
    return set;
  }

 private:
  static OwnMotion resting(OwnMotion base) {
    base.v = base.a = base.force = {};
    base.until = std::numeric_limits<double>::infinity();
    return base;
  }
  void change(OwnMotion& motion, double k) const override { motion.until = motion.t + k; }
};

/// The leg after a change that lasts until the t of the reference.
class ResumedChanges final : public ChangesOf<ResumedChanges> {
 public:
  ResumedChanges(std::unique_ptr<Changes> changes, const OwnMotion& base, double time)
      : ChangesOf(reference_of(base, time)),
        changes_(std::move(changes)),
        unchanged_(motion_from(base, time)),
        lasts_(time - base.t) {}

  const OwnMotion& unchanged() const override { return unchanged_; }
  bool touches_in_one_interval() const override { return changes_->touches_in_one_interval(); }
  double min_change(double p, double q) const override { return changes_->min_change(p, q); }

  template <int D>
  MotionSet<D> set_of(double p, double q) const {
    MotionSet<D> set = unchanged_set<D>();
    const MotionSet<D> before = changes_->between<D>(p, q);
    set.place = reached(before.velocity, before.acceleration, p, q);
    // The stored place is rounded, and so are these lines.
    const Vec<D> x = vector_of<D>(reference().x).abs();
    set.place.pad += 0x1p-50 * (x + set.place.centre.abs() + set.place.along.abs() + set.place.radius);
    return set;
  }

 private:
  static OwnMotion reference_of(const OwnMotion& base, double time) {
    OwnMotion reference = motion_from(base, time);
    reference.x = base.x;
    return reference;
  }
  /// Where the changed motions are when they end, relative to their start.
  template <int D>
  VectorSet<D> reached(const VectorSet<D>& velocity, const VectorSet<D>& acceleration, double p,
                       double q) const {
    const double bend = 0.5 * lasts_ * lasts_;
    VectorSet<D> place = velocity;
    if (velocity.is_arc) {
      const double middle = p + 0.5 * (q - p);
      const Vec<D> v = vector_of<D>(changes_->reference().v), a = vector_of<D>(changes_->reference().a);
      place =
          turned_vectors<D>(lasts_ * v + bend * a, middle, std::max(middle - p, q - middle) * (1 + 0x1p-50));
      place.pad += lasts_ * velocity.pad + bend * acceleration.pad +
                   0x1p-50 * (lasts_ * v.abs().sum() + bend * a.abs().sum());
      return place;
    }
    place.centre = lasts_ * velocity.centre + bend * acceleration.centre;
    place.along = lasts_ * velocity.along;
    place.pad = lasts_ * velocity.pad + bend * (acceleration.pad + acceleration.along.abs()) +
                0x1p-50 * (lasts_ * velocity.centre.abs() + bend * acceleration.centre.abs());
    return place;
  }
  void change(OwnMotion& motion, double k) const override {
    motion.x = motion_from(changes_->changed(k), motion.t).x;
  }

  std::unique_ptr<Changes> changes_;
  OwnMotion unchanged_;
  double lasts_;
};

class NoChanges final : public ChangesOf<NoChanges> {
 public:
  explicit NoChanges(const OwnMotion& motion) : ChangesOf(motion), stored_(motion) {}
  /// Seen from its last time.
  NoChanges(const OwnMotion& motion, const OwnMotion& at_end) : ChangesOf(at_end), stored_(motion) {
    for (std::size_t j = 0; j < 3; ++j) rounding_[j] = 0x1p-52 * std::abs(at_end.x[j]);
  }

  const OwnMotion& unchanged() const override { return stored_; }
  double min_change(double /*p*/, double /*q*/) const override { return 0; }
  template <int D>
  MotionSet<D> set_of(double /*p*/, double /*q*/) const {
    MotionSet<D> set = unchanged_set<D>();
    set.place.pad = vector_of<D>(rounding_);
    return set;
  }

 private:
  void change(OwnMotion& /*motion*/, double /*k*/) const override {}

  OwnMotion stored_;
  std::array<double, 3> rounding_{};  ///< of the place of the reference
};

}  // namespace

std::unique_ptr<Changes> delays_of(const OwnMotion& stored, double lo) {
  return std::make_unique<DelayChanges>(stored, lo);
}

std::unique_ptr<Changes> rests_of(const OwnMotion& base) {
  return std::make_unique<RestChanges>(base);
}

std::unique_ptr<Changes> resumed_after(std::unique_ptr<Changes> changes, const OwnMotion& base, double time) {
  return std::make_unique<ResumedChanges>(std::move(changes), base, time);
}

std::unique_ptr<Changes> no_changes_of(const OwnMotion& motion) {
  return std::make_unique<NoChanges>(motion);
}

std::unique_ptr<Changes> end_of(OwnMotion motion, double time) {
  motion.until = time;
  return std::make_unique<NoChanges>(motion, motion_from(motion, time));
}

}  // namespace foresee
