// One pair on its way through the horizon, in double arithmetic with certified signs.
//
// A contact set is made of primitives joined by "all" and "any". The track leaps forward: while the pair is
// certainly apart, by the longest stretch for which that is certain; then, from a moment at which it
// certainly touches, by the longest stretches of contact. What stays in doubt is a sliver around each
// crossing, or everything where the crossing is a graze: then the answer is `uncertain`, and other means must
// decide.
#pragma once

#include <cstdint>

#include "contact/certified.h"
#include "contact/chord.h"

namespace foresee {

enum class Verdict : std::uint8_t { no, yes, uncertain };

/// Joins the answers of apart(...): a set of which all parts are needed is missed while one of them is.
template <int D, int Degree>
struct ApartVisitor {
  const AxisView (&view)[D];
  double underflow, room;

  double all(double a, double b) const { return a > b ? a : b; }
  double any(double a, double b) const { return a < b ? a : b; }
  double always() const { return not_certain; }
  double slab(int axis, double half) const { return slab_apart(view[axis], half); }
  double face(int axis, Face which, double bound) const { return face_apart(view[axis], which, bound); }
  template <std::size_t N>
  double ball(const std::array<Centre<double>, N>& centre, double radius) const {
    return ball_apart<Degree>(ball_view<Degree>(view, centre, radius, underflow), room);
  }
};

/// Joins the answers of within(...).
template <int D, int Degree>
struct WithinVisitor {
  const AxisView (&view)[D];
  double underflow, room;

  double all(double a, double b) const { return a < b ? a : b; }
  double any(double a, double b) const { return a > b ? a : b; }
  double always() const { return for_ever; }
  double slab(int axis, double half) const { return slab_within(view[axis], half); }
  double face(int axis, Face which, double bound) const { return face_within(view[axis], which, bound); }
  template <std::size_t N>
  double ball(const std::array<Centre<double>, N>& centre, double radius) const {
    return ball_within<Degree>(ball_view<Degree>(view, centre, radius, underflow), room);
  }
};

/// Certainly met (or missed) at this moment: 0, otherwise not_certain.
template <int D, int Degree>
struct NowWithinVisitor {
  const AxisView (&view)[D];
  double underflow, room;

  double all(double a, double b) const { return a < b ? a : b; }
  double any(double a, double b) const { return a > b ? a : b; }
  double always() const { return 0; }
  double slab(int axis, double half) const { return slab_now_within(view[axis], half) ? 0 : not_certain; }
  double face(int axis, Face which, double bound) const {
    return face_now_within(view[axis], which, bound) ? 0 : not_certain;
  }
  template <std::size_t N>
  double ball(const std::array<Centre<double>, N>& centre, double radius) const {
    return ball_now_within(ball_view<Degree>(view, centre, radius, underflow)) ? 0 : not_certain;
  }
};

template <int D, int Degree>
struct NowApartVisitor {
  const AxisView (&view)[D];
  double underflow, room;

  double all(double a, double b) const { return a > b ? a : b; }
  double any(double a, double b) const { return a < b ? a : b; }
  double always() const { return not_certain; }
  double slab(int axis, double half) const { return slab_now_apart(view[axis], half) ? 0 : not_certain; }
  double face(int axis, Face which, double bound) const {
    return face_now_apart(view[axis], which, bound) ? 0 : not_certain;
  }
  template <std::size_t N>
  double ball(const std::array<Centre<double>, N>& centre, double radius) const {
    return ball_now_apart(ball_view<Degree>(view, centre, radius, underflow)) ? 0 : not_certain;
  }
};

/// A crossing that is certain: apart (or within) up to `before`, the opposite at `after`. Both equal the
/// limit where there is none.
struct Bracket {
  double before = 0, after = 0;
};

template <class Kind, int Degree>
class Track {
 public:
  static constexpr int D = Kind::axes;
  using Sizes = typename Kind::template Sizes<double>;

  Track(const Setup& setup, const double* row_a, const double* row_b, const Moments& moments)
      : relative_(relative_of<D, Degree>(setup, row_a, row_b)),
        sizes_(Kind::template sizes<double>(raw_sizes_of<double, D>(setup, row_a, row_b), setup)) {
    constexpr double u = unit_roundoff;
    const double begin = moments.dt_begin, end = moments.dt_end;
    begin_ = moments.begin_exact ? begin : begin * (1 - 2 * u);
    inner_begin_ = moments.begin_exact ? begin : begin * (1 + 2 * u);
    end_ = moments.end_exact ? end : end * (1 + 2 * u);
    inner_end_ = moments.end_exact ? end : end * (1 - 2 * u);
  }

  /// The cheap answer that lets most candidates go.
  bool certainly_missed() const {
    return Kind::visit(sizes_, ChordVisitor<D>(relative_, begin_, end_)).none();
  }

  /// Is there a contact? Looks for any moment of it, not for its begin.
  Verdict touches() const {
    if (certainly_missed()) return Verdict::no;
    double tau = begin_;
    for (int leaps = 0; leaps < most_leaps; ++leaps) {
      const double step = ask<ApartVisitor<D, Degree>>(tau);
      const double next = step >= 0 ? after_leap(tau, step) : tau;
      if (next > end_) return Verdict::no;
      const double inside = std::max(next * (1 + 0x1p-20), inner_begin_);
      if (inside <= inner_end_ && ask<NowWithinVisitor<D, Degree>>(inside) >= 0) return Verdict::yes;
      if (!(next > tau)) break;
      tau = next;
    }
    Bracket first;
    return first_contact(first);
  }

  /// Is there a contact? If yes, `first` brackets its begin.
  Verdict first_contact(Bracket& first) const {
    const double stopped = leap<ApartVisitor<D, Degree>>(begin_, end_);
    if (stopped > end_) return Verdict::no;
    first = {stopped, stopped};
    return witness<NowWithinVisitor<D, Degree>>(first, inner_begin_) ? Verdict::yes : Verdict::uncertain;
  }

  /// From a moment of certain contact: brackets its end. yes: it ends; no: it lasts to the end of the
  /// horizon.
  Verdict end_of_contact(double from, Bracket& last) const {
    const double stopped = leap<WithinVisitor<D, Degree>>(from, end_);
    if (stopped > end_) return Verdict::no;
    last = {stopped, stopped};
    return witness<NowApartVisitor<D, Degree>>(last, stopped) ? Verdict::yes : Verdict::uncertain;
  }

  const Relative<D>& relative() const { return relative_; }
  const Sizes& sizes() const { return sizes_; }

 private:
  static constexpr int most_leaps = 48;

  static double after_leap(double tau, double step) {
    return (tau + step) * (1 - 4 * unit_roundoff) - 0x1p-1060;
  }

  template <class Visitor>
  double ask(double tau) const {
    AxisView view[D];
    view_from<D, Degree>(relative_, tau, view);
    return Kind::visit(sizes_, Visitor{view, relative_.underflow, (end_ - tau) * (1 + 4 * unit_roundoff)});
  }

  /// The moment up to which the visitor's answer stays certain; beyond `limit` if it is for the whole of
  /// [tau, limit].
  template <class Visitor>
  double leap(double tau, double limit) const {
    for (int leaps = 0; leaps < most_leaps; ++leaps) {
      const double step = ask<Visitor>(tau);
      if (!(step >= 0)) return tau;
      const double next = after_leap(tau, step);
      if (next > limit) return for_ever;
      if (!(next > tau)) return tau;
      tau = next;
      if (step < 0x1p-40 * tau) return tau;  // as near to the crossing as a bracket needs to be
    }
    return tau;
  }

  /// Looks just behind bracket.before for a moment at which the visitor is certain.
  template <class Visitor>
  bool witness(Bracket& bracket, double earliest) const {
    double step = bracket.before > 0 ? 0x1p-48 * bracket.before : 0x1p-60 * inner_end_;
    for (int attempt = 0; attempt < 9; ++attempt, step *= 64) {
      const double tau = std::max(bracket.before + (attempt == 0 ? 0 : step), earliest);
      if (tau > inner_end_) break;
      if (ask<Visitor>(tau) < 0) continue;
      bracket.after = tau;
      return true;
    }
    bracket.after = inner_end_;
    return inner_end_ >= earliest && ask<Visitor>(inner_end_) >= 0;
  }

  Relative<D> relative_;
  Sizes sizes_;
  double begin_, inner_begin_, inner_end_, end_;
};

}  // namespace foresee
