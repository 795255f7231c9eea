#include "contact/approach_oracle.h"

#include <cmath>

namespace foresee::oracle {
namespace {

Coefficients squared_distance(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                              double now) {
  Coefficients sum(5);
  for (int j = 0; j < a.layout.axes; ++j) {
    const Coefficients p = relative_axis(a, b, j, now);
    for (int k = 0; k < 3; ++k)
      for (int l = 0; l < 3; ++l) sum[k + l] += p[k] * p[l];
  }
  return sum;
}

/// A time at which the distance may be smallest: an exact one, or a root of the slope.
struct Candidate {
  Exact at;
  std::optional<TimePoint> root = {};

  int compare(const Exact& x) const { return root ? root->compare(x) : (at - x).sign(); }
};

class Distances {
 public:
  explicit Distances(Coefficients square) : square_(std::move(square)) {}

  /// The sign of the squared distance at the candidate minus a number.
  int beyond(Candidate& c, const Exact& number) const {
    if (!c.root) return (value_at(square_, c.at) - number).sign();
    Coefficients difference = square_;
    difference[0] -= number;
    return c.root->sign_of(Sturm(integers_of(difference)));
  }

  /// Whether the distance at a is less than at b, which is earlier and the smallest so far.
  bool less(Candidate& a, Candidate& b) const {
    if (!a.root) return beyond(b, value_at(square_, a.at)) > 0;
    if (!b.root) return beyond(a, value_at(square_, b.at)) < 0;
    if (beyond(b, 0.0) == 0) return false;
    if (is_square_and_constant()) return false;  // two equal minima: b is the earlier
    for (;; a.root->halve(), b.root->halve()) {
      const Exact gap = value_at(square_, b.root->low) - value_at(square_, a.root->low);
      const Exact doubt = spread(*a.root) + spread(*b.root);
      if (gap > doubt) return true;
      if (gap < -doubt) return false;
    }
  }

 private:
  /// Whether the squared distance is c (t^2 + p t + q)^2 + d.
  bool is_square_and_constant() const {
    const Exact &f1 = square_[1], &f2 = square_[2], &f3 = square_[3], &f4 = square_[4];
    return Exact(8.0) * f4 * f4 * f1 == f3 * (Exact(4.0) * f4 * f2 - f3 * f3);
  }

  /// The maximal change of the squared distance within a bracket.
  Exact spread(const TimePoint& m) const {
    Exact steepest;
    for (std::size_t k = square_.size(); k-- > 1;) {
      const Exact term = square_[k] * Exact(static_cast<double>(k));
      steepest = steepest * m.high + (term.sign() < 0 ? -term : term);
    }
    return steepest * (m.high - m.low);
  }

  Coefficients square_;
};

}  // namespace

std::string judge_approach(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                           const Horizon& horizon, const ClosestApproach& answer) {
  const QueriedInterval queried = queried_interval(a, b, horizon);
  const Coefficients square = squared_distance(a, b, horizon.now);
  const Distances distances(square);
  const Sturm slope(derivative(integers_of(square)));
  Candidate best{queried.begin};
  for (TimePoint& root : times_between(slope, queried.begin, queried.end))
    if (Candidate other{{}, root}; distances.less(other, best)) best = other;
  if (Candidate end{queried.end}; distances.less(end, best)) best = end;

  auto time_is = [&](double value, const Exact& offset) {
    return is_nearest(value, [&](const Exact& tie) { return best.compare(tie - offset); });
  };
  if (!time_is(answer.dt, 0.0)) return "dt is not the nearest double";
  if (!time_is(answer.t, horizon.now)) return "t is not the nearest double";
  if (distances.beyond(best, 0.0) == 0) return answer.d == 0 ? "" : "d is not 0";
  if (!is_nearest(answer.d,
                  [&](const Exact& tie) { return tie.sign() < 0 ? 1 : distances.beyond(best, tie * tie); }))
    return "d is not the nearest double";
  return "";
}

}  // namespace foresee::oracle
