// Changes at once: turn, speed, climb and accelerate.
#include <algorithm>
#include <cmath>

#include "motion/changes.h"
#include "numbers/correct_rounding.h"

namespace foresee {
namespace {

void set_acceleration_of_force(OwnMotion& motion) {
  if (motion.mass == 0) return;
  for (std::size_t j = 0; j < 3; ++j) motion.a[j] = motion.force[j] / motion.mass;
}

/// The middle of a range, and an upper bound of the distance of its ends from it.
struct Middle {
  Middle(double p, double q) : k(p + 0.5 * (q - p)), half(std::max(k - p, q - k) * (1 + 0x1p-50)) {}

  double k, half;
};

class TurnChanges final : public ChangesOf<TurnChanges> {
 public:
  using ChangesOf::ChangesOf;

  bool turns() const override { return true; }
  double min_change(double /*p*/, double /*q*/) const override { return 0x1p-41; }

  template <int D>
  MotionSet<D> set_of(double p, double q) const {
    MotionSet<D> set = unchanged_set<D>();
    const Middle middle(p, q);
    const Vec<D> a = set.acceleration.centre;
    set.velocity = turned_vectors<D>(vector_of<D>(reference().v), middle.k, middle.half);
    if ((a != 0).any()) {
      set.acceleration = turned_vectors<D>(a, middle.k, middle.half);
      set.acceleration.pad += pad_of_stored * a.abs();
    }
    return set;
  }
  template <int D>
  TrajectoryEstimate<D> estimate_of(double k) const {
    if constexpr (D == 1) {
      return ChangesOf::estimate_of<D>(k);
    } else {
      const SineCosine<double> by = quick_sine_cosine(k);
      const auto turned_by = [&](Vec<D> vector) {
        const double x = vector[0];
        vector[0] = x * by.cosine + vector[1] * by.sine;
        vector[1] = vector[1] * by.cosine - x * by.sine;
        return vector;
      };
      return {Vec<D>::zero(), turned_by(vector_of<D>(reference().v)), turned_by(vector_of<D>(reference().a)),
              0, reference().until - reference().t};
    }
  }

 private:
  void change(OwnMotion& motion, double k) const override {
    turn(motion.v, k);
    turn(motion.force, k);
    turn(motion.a, k);
    set_acceleration_of_force(motion);
    motion.heading = turned_heading(motion.heading, k);
  }
  /// Turns the vector in x and y.
  static void turn(std::array<double, 3>& vector, double degrees) {
    const Turned turned = turned_clockwise(vector[0], vector[1], degrees);
    vector[0] = turned.x, vector[1] = turned.y;
  }
  /// The sum, with a whole turn subtracted or added if it is beyond 360 or below -360.
  static double turned_heading(double heading, double degrees) {
    Dyadic sum = Dyadic(heading) + Dyadic(degrees);
    const Dyadic whole(360.0);
    if (sum > whole) sum = sum - whole;
    if (sum < -whole) sum = sum + whole;
    return rounded(sum) + 0.0;
  }
};

class SpeedChanges final : public ChangesOf<SpeedChanges> {
 public:
  SpeedChanges(const OwnMotion& base, bool scales_bend)
      : ChangesOf(base), speed_(speed_of(base)), scales_bend_(scales_bend) {}

  double min_change(double p, double q) const override {
    return 2 * pad_of_stored * (speed_ + std::max(std::abs(p), std::abs(q)));
  }

  template <int D>
  MotionSet<D> set_of(double p, double q) const {
    MotionSet<D> set = unchanged_set<D>();
    const Middle middle(p, q);
    const Vec<D> v = vector_of<D>(reference().v), a = set.acceleration.centre;
    set.velocity = added_vectors<D>(v, v / speed_, middle.k, middle.half);
    if (scales_bend_ && (a != 0).any()) set.acceleration = vectors_scaled_by_square<D>(a, speed_, p, q);
    return set;
  }

 private:
  void change(OwnMotion& motion, double k) const override {
    const Dyadic m(speed_), speed = m + Dyadic(k);
    for (double& v : motion.v) v = rounded_quotient(Dyadic(v) * speed, m);
    if (!scales_bend_) return;
    for (double& a : motion.a) a = rounded_quotient(Dyadic(a) * speed * speed, m * m);
  }

  double speed_;
  bool scales_bend_;
};

class ClimbChanges final : public ChangesOf<ClimbChanges> {
 public:
  using ChangesOf::ChangesOf;

  double min_change(double p, double q) const override {
    return 2 * pad_of_stored * (std::abs(reference().v[2]) + std::max(std::abs(p), std::abs(q)));
  }

  template <int D>
  MotionSet<D> set_of(double p, double q) const {
    MotionSet<D> set = unchanged_set<D>();
    const Middle middle(p, q);
    Vec<D> up = Vec<D>::zero();
    up[D - 1] = 1;
    set.velocity = added_vectors<D>(vector_of<D>(reference().v), up, middle.k, middle.half);
    return set;
  }

 private:
  void change(OwnMotion& motion, double k) const override { motion.v[2] += k; }
};

class AccelerationChanges final : public ChangesOf<AccelerationChanges> {
 public:
  explicit AccelerationChanges(const OwnMotion& base) : ChangesOf(base), speed_(speed_of(base)) {}

  double min_change(double p, double q) const override {
    const std::array<double, 3>& a = reference().a;
    return 2 * pad_of_stored *
           (std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]) + std::max(std::abs(p), std::abs(q)));
  }

  template <int D>
  MotionSet<D> set_of(double p, double q) const {
    MotionSet<D> set = unchanged_set<D>();
    const Middle middle(p, q);
    set.acceleration = added_vectors<D>(set.acceleration.centre, vector_of<D>(reference().v) / speed_,
                                        middle.k, middle.half);
    return set;
  }

 private:
  void change(OwnMotion& motion, double k) const override {
    for (std::size_t j = 0; j < 3; ++j) {
      if (motion.mass == 0) {
        motion.a[j] = added_along(motion.a[j], k, motion.v[j], speed_);
        continue;
      }
      const Dyadic along = Dyadic(k) * Dyadic(motion.mass) * Dyadic(motion.v[j]);
      motion.force[j] = rounded_quotient(Dyadic(motion.force[j]) * Dyadic(speed_) + along, Dyadic(speed_));
    }
    set_acceleration_of_force(motion);
  }
  /// a + k b / m, where b is one component of the velocity.
  static double added_along(double a, double k, double b, double m) {
    return rounded_quotient(Dyadic(a) * Dyadic(m) + Dyadic(k) * Dyadic(b), Dyadic(m));
  }

  double speed_;
};

}  // namespace

OwnMotion Changes::changed(double k) const {
  OwnMotion motion = unchanged();
  if (k != 0 && is_finite(motion)) change(motion, k);
  return motion;
}

std::unique_ptr<Changes> changes_by(Manoeuvre manoeuvre, const OwnMotion& base, bool scales_bend) {
  switch (manoeuvre) {
    case Manoeuvre::turn:
      return std::make_unique<TurnChanges>(base);
    case Manoeuvre::speed:
      return std::make_unique<SpeedChanges>(base, scales_bend);
    case Manoeuvre::climb:
      return std::make_unique<ClimbChanges>(base);
    default:
      return std::make_unique<AccelerationChanges>(base);
  }
}

}  // namespace foresee
