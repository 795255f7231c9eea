// Some pairs at once against their contact set: which are certainly apart, which certainly touch, and when
// the others could.
//
//   SetLanes lanes;
//   lanes.a[l] = row_a, lanes.b[l] = row_b;                     // pair number l of `width`
//   set_kernel<2, 1>().classify(question, lanes);
//   lanes.begin[l] > lanes.end[l];                              // certainly they never touch
//   lanes.touches[l] > 0;                                       // certainly they do
//
// The chord (chord.h) says when each pair could touch; in the middle of that time the set's primitives are
// asked for their values, with error bounds. What neither settles is for an Advancement, within that time.
// The set is read once for a register of pairs, so that its being data costs next to nothing here: some
// twenty nanoseconds a pair.
#pragma once

#include "base/simd.h"
#include "contact/set/contact_set.h"

namespace foresee {

/// What is the same for all pairs, as arrays.
struct LanesQuestion {
  Offsets a, b;
  double now, h;
  ContactSet::Arrays set;
  const Bounded* lengths;  ///< by number; those that vary are anything
  bool touches_wanted;
  double* space;  ///< aligned, and as long as lanes_space() says
};

struct SetLanes {
  static constexpr int width = 16;

  const double *a[width], *b[width];  ///< rows
  // What is found, from now on:
  alignas(64) double begin[width], end[width];  ///< only within can they touch, if at all
  double touches[width];                        ///< above 0: certainly; only where that is wanted
};

/// As many numbers as the widest register holds: kernels read and write aligned ones.
struct alignas(64) LanesLine {
  double numbers[8] = {};
};

/// So many of them: two a length, one a primitive.
inline std::size_t lanes_space(const ContactSet& set) {
  return 2 * set.lengths().size() + set.primitives().size();
}

template <int D, int Degree>
struct SetKernel {
  /// Fills in what is found. Requires: each lane has rows.
  void (*classify)(const LanesQuestion& question, SetLanes& lanes);
};

template <int D, int Degree, Simd simd>
const SetKernel<D, Degree>& set_kernel();

/// Of the widest instructions in use.
template <int D, int Degree>
const SetKernel<D, Degree>& set_kernel() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const SetKernel<D, Degree>& { return set_kernel<D, Degree, simd>(); });
}

}  // namespace foresee
