// The loops of SetKernel over a register of pairs at a time: a kernel (base/simd.h).
#include "contact/set/set_lanes.h"

#include "base/doubles.h"
#include "contact/certified/chord.h"

namespace foresee {
namespace {

using BoundedDoubles = BoundedOf<Doubles>;

/// The rows of one table.
struct Rows {
  const double* const* row;

  Doubles operator()(int place, double otherwise = 0) const {
    return place == Offsets::absent ? Doubles(otherwise) : Doubles(column(row, place));
  }
};

/// Lengths by number, in memory.
struct LengthLanes {
  double* at;

  BoundedDoubles operator[](int i) const {
    return {Doubles(load(place(i))), Doubles(load(place(i) + register_width))};
  }
  void put(int i, const BoundedDoubles& length) const {
    store(place(i), length.value.of);
    store(place(i) + register_width, length.error.of);
  }
  double* place(int i) const { return at + 2 * register_width * i; }
};

/// TwoRows of contact_set.h, for a register of pairs.
struct LengthRows {
  const Rows &a, &b;

  BoundedDoubles in_both(int place_a, int place_b) const {
    return BoundedDoubles{a(place_a)} + BoundedDoubles{b(place_b)};
  }
  BoundedDoubles growth(const Length& length) const {
    return growth_in(a, length.a, length.t_a, length.number) +
           growth_in(b, length.b, length.t_b, length.number);
  }

 private:
  static BoundedDoubles growth_in(const Rows& rows, int place, int t, double time) {
    return (BoundedDoubles{Doubles(time)} - BoundedDoubles{rows(t)}) * BoundedDoubles{rows(place)};
  }
};

/// When both objects exist, from now on: rounded outward, and inward.
struct Lives {
  Interval<Doubles> queried, inner;

  Lives(const LanesQuestion& q, const Rows& a, const Rows& b) {
    constexpr double u = unit_roundoff;
    const Doubles start = greater(greater(a(q.a.t), b(q.b.t)), Doubles(q.now)) - q.now;
    const Doubles stop = lesser(a(q.a.until, unbounded), b(q.b.until, unbounded)) - q.now;
    queried = {start * (1 - 2 * u), lesser(stop * (1 + 2 * u), Doubles(q.h))};
    inner = {start * (1 + 2 * u), lesser(stop * (1 - 2 * u), Doubles(q.h))};
  }
};

/// The evaluation of a register of pairs. A NaN proves nothing.
template <int D, int Degree>
class PairRegister {
 public:
  /// Computes lifetimes, motions and lengths of these pairs. `q` must outlive it.
  PairRegister(const LanesQuestion& q, const Rows& a, const Rows& b)
      : q_(q),
        lives_(q, a, b),
        lengths_{q.space},
        values_(q.space + 2 * register_width * q.set.length_count) {
    take_motion(a, b);
    take_lengths(a, b);
  }

  /// The pairs can touch only within it.
  Interval<Doubles> interval() const {
    const Chord<D, Doubles> chord(relative_, lives_.queried.end);
    const Interval<Doubles> near = chord.between(q_.set.hull, q_.set.hull_count, lengths_, lives_.queried);
    return {select(usual_, near.begin, lives_.queried.begin), select(usual_, near.end, lives_.queried.end)};
  }

  /// Whether they certainly touch at `time`.
  DoublesMask touches(const Doubles& time) const {
    Coefficients<BoundedDoubles, 0> x[D];
    for (int j = 0; j < D; ++j) {
      const CertainAxisMotion<Doubles> view = view_from<Degree>(relative_.axis[j], time, relative_.underflow);
      x[j][0] = {view.x, view.ex};
    }
    for (int i = 0; i < q_.set.primitive_count; ++i) {
      const BoundedDoubles p = polynomial_of<0>(q_.set.primitives[i], x, lengths_, time)[0];
      store(values_ + register_width * i, (p.value + p.error_bound(usual_underflow + 0x1p-1060)).of);
    }
    DoublesMask in_some = Doubles(0.0) < Doubles(0.0);
    for (int i = 0; i < q_.set.piece_count; ++i) in_some = in_some | in_piece(q_.set.pieces[i]);
    return in_some & usual_ & (lives_.inner.begin <= time) & (time <= lives_.inner.end);
  }

 private:
  /// The relative motion, each number with a bound on its error, and the lanes in which those bounds hold.
  void take_motion(const Rows& a, const Rows& b) {
    const Doubles s_a = q_.now - a(q_.a.t), s_b = q_.now - b(q_.b.t);
    usual_ = 1 + greater(abs(s_a), abs(s_b)) + q_.h <= usual_age;
    relative_.underflow = usual_underflow;
    for (int j = 0; j < D; ++j)
      relative_.axis[j] =
          axis_of_any_age<Degree>(motion(a, q_.a, j), motion(b, q_.b, j), s_a, s_b, relative_.underflow);
  }

  static AxisMotion<Doubles> motion(const Rows& rows, const Offsets& at, int j) {
    const auto number = [&rows, j](int place) {
      return place == Offsets::absent ? Doubles(0.0) : rows(place + j);
    };
    return {number(at.x), number(at.v), Degree < 2 ? Doubles(0.0) : number(at.a)};
  }

  /// All lengths of the set, with error bounds.
  void take_lengths(const Rows& a, const Rows& b) {
    const LengthRows rows{a, b};
    for (int i = 0; i < q_.set.length_count; ++i) {
      const Length& length = q_.set.lengths[i];
      lengths_.put(i, length.varies
                          ? varying_length<BoundedDoubles>(length, lengths_, rows)
                          : BoundedDoubles{Doubles(q_.lengths[i].value), Doubles(q_.lengths[i].error)});
    }
  }

  /// Whether all primitives of the piece are certainly negative.
  DoublesMask in_piece(const ContactSet::Piece& piece) const {
    DoublesMask in_all = Doubles(0.0) <= Doubles(0.0);
    for (auto i = piece.all.begin; i < piece.all.end; ++i)
      in_all = in_all & (Doubles(load(values_ + register_width * q_.set.members[i])) < 0.0);
    return in_all;
  }

  const LanesQuestion& q_;
  const Lives lives_;
  CertainMotion<D, Doubles> relative_;
  DoublesMask usual_;  ///< no age is so large that underflow exceeds usual_underflow
  const LengthLanes lengths_;
  double* const values_;  ///< an upper bound of each primitive
};

/// SetKernel::classify, register by register.
template <int D, int Degree>
void classify_lanes(const LanesQuestion& q, SetLanes& lanes) {
  for (int l = 0; l < lanes.width; l += register_width) {
    const PairRegister<D, Degree> pairs(q, Rows{lanes.a + l}, Rows{lanes.b + l});
    const Interval<Doubles> interval = pairs.interval();
    store(lanes.begin + l, interval.begin.of);
    store(lanes.end + l, interval.end.of);
    const Doubles time = q.times_wanted ? Doubles(0.0) : 0.5 * (interval.begin + interval.end);
    DoublesMask found = (interval.begin <= interval.end) & (interval.begin <= time);
    if (any(found)) found = found & pairs.touches(time);
    store(lanes.touches + l, select(found, Doubles(1.0), Doubles(0.0)).of);
  }
}

}  // namespace

template <int D, int Degree, Simd simd>
const SetKernel<D, Degree>& set_kernel() {
  static constexpr SetKernel<D, Degree> kernel{classify_lanes<D, Degree>};
  return kernel;
}

template const SetKernel<1, 1>& set_kernel<1, 1, Simd::FORESEE_SIMD>();
template const SetKernel<1, 2>& set_kernel<1, 2, Simd::FORESEE_SIMD>();
template const SetKernel<2, 1>& set_kernel<2, 1, Simd::FORESEE_SIMD>();
template const SetKernel<2, 2>& set_kernel<2, 2, Simd::FORESEE_SIMD>();
template const SetKernel<3, 1>& set_kernel<3, 1, Simd::FORESEE_SIMD>();
template const SetKernel<3, 2>& set_kernel<3, 2, Simd::FORESEE_SIMD>();

}  // namespace foresee
