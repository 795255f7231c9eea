#include "contact/exact_contact.h"

#include <algorithm>

#include "contact/roots.h"

namespace foresee {
namespace {

/// Truth of a formula where the signs of its polynomials are asked for one by one, as far as needed.
template <class SignOf>
bool holds(const Formula& formula, int node, SignOf&& sign_of) {
  const Formula::Node& n = formula.nodes[node];
  switch (n.op) {
    case Formula::Op::leaf:
      return sign_of(n.first) <= 0;
    case Formula::Op::all:
      return holds(formula, n.first, sign_of) && holds(formula, n.second, sign_of);
    default:
      return holds(formula, n.first, sign_of) || holds(formula, n.second, sign_of);
  }
}

class ExactPair {
 public:
  ExactPair(const Formula& formula, const ExactMoments& moments) : formula_(formula), moments_(moments) {
    // The sign between the ends, for polynomials that have no root there.
    if (moments.begin < moments.end)
      for (const Polynomial& p : formula.polynomials)
        inside_.push_back(descartes(p, moments.begin, moments.end));
  }

  bool touches() { return holds_at(moments_.begin) || holds_at(moments_.end) || touches_between(); }

  ContactTimes times() {
    const Moments& m = moments_.rounded;
    ContactTimes times{m.t_end, m.t_end, m.dt_end, m.dt_end};
    const bool at_once = holds_at(moments_.begin);
    if (at_once) {
      times.t = m.t_begin, times.dt = m.dt_begin;
      if (!holds_after_begin()) return {m.t_begin, m.t_begin, m.dt_begin, m.dt_begin};
    }
    for_each_root([&](int source, Root& root) {
      if (!holds_at_root(source, root)) return true;
      const double dt = root.rounded_with(Dyadic());
      const double t = root.rounded_with(moments_.now);
      if (!at_once) times.dt = std::min(times.dt, dt), times.t = std::min(times.t, t);
      if (!holds_after_root(source, root))
        times.dt_end = std::min(times.dt_end, dt), times.t_end = std::min(times.t_end, t);
      return true;
    });
    return times;
  }

 private:
  bool holds_at(const Dyadic& tau) const {
    return holds(formula_, formula_.top, [&](int i) { return sign_at(formula_.polynomials[i], tau); });
  }

  bool holds_after_begin() const {
    if (inside_.empty()) return false;
    return holds(formula_, formula_.top, [&](int i) { return inside_[i].first; });
  }

  bool touches_between() {
    bool found = false;
    for_each_root([&](int source, Root& root) {
      found = holds_at_root(source, root);
      return !found;
    });
    return found;
  }

  int sign_at_root(int i, int source, Root& root) const {
    if (i == source) return 0;
    if (inside_[i].variations == 0) return inside_[i].first;
    return root.sign_of(formula_.polynomials[i]);
  }

  bool holds_at_root(int source, Root& root) const {
    return holds(formula_, formula_.top, [&](int i) { return sign_at_root(i, source, root); });
  }

  /// Just after the root a polynomial has the sign of its first derivative that is not zero at it.
  bool holds_after_root(int source, Root& root) const {
    return holds(formula_, formula_.top, [&](int i) {
      int sign = sign_at_root(i, source, root);
      for (Polynomial p = formula_.polynomials[i]; sign == 0 && p.degree > 0;) {
        p = derivative(p);
        sign = root.sign_of(p);
      }
      return sign;
    });
  }

  /// Every root of every polynomial strictly between the ends, until `use` says false.
  template <class Use>
  void for_each_root(Use&& use) {
    for (std::size_t i = 0; i < inside_.size(); ++i) {
      if (inside_[i].variations == 0) continue;
      Polynomial square_free_part;
      for (Root& root :
           roots_between(formula_.polynomials[i], moments_.begin, moments_.end, square_free_part))
        if (!use(static_cast<int>(i), root)) return;
    }
  }

  const Formula& formula_;
  const ExactMoments& moments_;
  std::vector<Descartes> inside_;
};

}  // namespace

ExactMoments exact_moments_of(const Setup& setup, const double* row_a, const double* row_b) {
  ExactMoments moments;
  moments.rounded = moments_of(setup, row_a, row_b);
  moments.now = Dyadic(setup.horizon.now);
  const Moments& m = moments.rounded;
  moments.begin = Dyadic(m.t_begin) - moments.now;
  moments.end = m.ends_with_horizon ? Dyadic(setup.horizon.h) : Dyadic(m.t_end) - moments.now;
  return moments;
}

bool exact_touches(const Formula& formula, const ExactMoments& moments) {
  return ExactPair(formula, moments).touches();
}

ContactTimes exact_times(const Formula& formula, const ExactMoments& moments) {
  return ExactPair(formula, moments).times();
}

}  // namespace foresee
