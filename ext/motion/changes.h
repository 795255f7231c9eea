// Manoeuvres as objects: the motions of one object that a manoeuvre by any k of a range can give.
//
//   const auto turns = changes_by(Manoeuvre::turn, base);        // base: the motion at the start
//   turns->changed(15)                                           // 15 degrees to starboard, as it is stored
//   turns->between<2>(-10, 10).velocity.support({0, 1})          // no such motion is faster northward
//
// Each manoeuvre is one class that knows the changed motion of k, the set of all motions of a range, and the
// smallest difference of k that rounding leaves visible. k = 0 changes nothing. Each stored number is the exact value
// rounded once, the same on every machine; 0 is never -0. If a force gives the acceleration, the force is changed.
// Cost: microseconds per changed motion, tens of nanoseconds per set.
#pragma once

#include <memory>

#include "motion/manoeuvre.h"
#include "motion/motion_set.h"

namespace foresee {

class Changes {
 public:
  explicit Changes(const OwnMotion& reference) : reference_(reference) {}
  Changes(const Changes&) = delete;
  Changes& operator=(const Changes&) = delete;
  virtual ~Changes() = default;

  /// The motion to which sets and estimates refer. None of the changed motions exists before its t.
  const OwnMotion& reference() const { return reference_; }
  /// The motion without a change: what it touches at its first time, it touches already.
  virtual const OwnMotion& unchanged() const { return reference_; }

  /// The motion to store for k; numbers that overflow are infinite. Requires: k finite.
  OwnMotion changed(double k) const;
  /// The smallest difference between two k of [p, q] that exceeds the pads of their motions: no finer end can
  /// be proven.
  virtual double min_change(double p, double q) const = 0;
  /// The motions of all k in [p, q]. Requires: p <= q.
  template <int D>
  MotionSet<D> between(double p, double q) const {
    MotionSet<D> set;
    find_set(p, q, set);
    return set;
  }
  /// Near the motion of k; it proves nothing.
  template <int D>
  TrajectoryEstimate<D> estimate(double k) const {
    TrajectoryEstimate<D> one;
    find_estimate(k, one);
    return one;
  }

  /// Whether the motions turn, and an outline with a heading with them.
  virtual bool turns() const { return false; }
  /// Whether the k that touch another object are one interval, if no path is bent.
  virtual bool touches_in_one_interval() const { return !turns(); }
  /// Whether each motion starts at a time of its own.
  virtual bool starts_vary() const { return false; }

 protected:
  virtual void change(OwnMotion& motion, double k) const = 0;
  virtual void find_set(double p, double q, MotionSet<1>& set) const = 0;
  virtual void find_set(double p, double q, MotionSet<2>& set) const = 0;
  virtual void find_set(double p, double q, MotionSet<3>& set) const = 0;
  virtual void find_estimate(double k, TrajectoryEstimate<1>& one) const = 0;
  virtual void find_estimate(double k, TrajectoryEstimate<2>& one) const = 0;
  virtual void find_estimate(double k, TrajectoryEstimate<3>& one) const = 0;

 private:
  OwnMotion reference_;
};

/// Turn, speed, climb or accelerate. `base`: the motion at the start. `scales_bend`: Manoeuvre::speed keeps the path,
/// so its acceleration changes by the square. Requires: a course for Manoeuvre::speed and accelerate.
std::unique_ptr<Changes> changes_by(Manoeuvre manoeuvre, const OwnMotion& base, bool scales_bend = false);

/// Start and end of `stored` are later by k, which is at least `lo`.
std::unique_ptr<Changes> delays_of(const OwnMotion& stored, double lo);

/// The object rests at the place of `base` from its t on, for k. Requires: k >= 0.
std::unique_ptr<Changes> rests_of(const OwnMotion& base);

/// What follows changes of `base` at `time`: the velocity that it would have had then, at the place that the changed
/// motion has reached. Requires: turn, speed or climb; time >= base.t.
std::unique_ptr<Changes> resumed_after(std::unique_ptr<Changes> changes, const OwnMotion& base, double time);

/// The motion itself, for every k.
std::unique_ptr<Changes> no_changes_of(const OwnMotion& motion);

/// The motion until `time`, for every k; sets are those of that time alone.
std::unique_ptr<Changes> end_of(OwnMotion motion, double time);

// A class of changes has only templates for its sets: this adds the rest.

template <class One>
class ChangesOf : public Changes {
 public:
  using Changes::Changes;

 protected:
  /// The set of the reference itself.
  template <int D>
  MotionSet<D> unchanged_set() const {
    MotionSet<D> set;
    set.velocity = stored_vector<D>(vector_of<D>(reference().v));
    set.acceleration.centre = vector_of<D>(reference().a);
    set.end = (reference().until - reference().t) * (1 + 0x1p-50);
    return set;
  }
  /// One may hide it by a faster one.
  template <int D>
  TrajectoryEstimate<D> estimate_of(double k) const {
    const MotionSet<D> one = static_cast<const One&>(*this).template set_of<D>(k, k);
    return {one.place.centre, one.velocity.centre, one.acceleration.centre, one.begin, one.end};
  }

 private:
  const One& one() const { return static_cast<const One&>(*this); }
  void find_set(double p, double q, MotionSet<1>& set) const final { set = one().template set_of<1>(p, q); }
  void find_set(double p, double q, MotionSet<2>& set) const final { set = one().template set_of<2>(p, q); }
  void find_set(double p, double q, MotionSet<3>& set) const final { set = one().template set_of<3>(p, q); }
  void find_estimate(double k, TrajectoryEstimate<1>& e) const final { e = one().template estimate_of<1>(k); }
  void find_estimate(double k, TrajectoryEstimate<2>& e) const final { e = one().template estimate_of<2>(k); }
  void find_estimate(double k, TrajectoryEstimate<3>& e) const final { e = one().template estimate_of<3>(k); }
};

}  // namespace foresee
