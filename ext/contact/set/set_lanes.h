// Contact sets of several pairs at a time, in vector registers: which pairs are certainly apart, which
// certainly touch, and when the others can touch.
//
//   SetLanes lanes;
//   lanes.a[l] = row_a, lanes.b[l] = row_b;                     // pair number l of `width`
//   set_kernel<2, 1>().classify(question, lanes);
//   lanes.begin[l] > lanes.end[l];                              // certainly they never touch
//   lanes.touches[l] > 0;                                       // certainly they do
//
// The chord (chord.h) bounds when each pair can touch. At one time the primitives of the set are evaluated with
// error bounds: in the middle of that interval, or now if the start of contact is wanted. Pairs that neither
// decides are for the engine of single pairs, within that interval. The set is read once per register of pairs,
// so that its interpretation as data costs little: some twenty nanoseconds per pair.
#pragma once

#include "base/simd.h"
#include "contact/minkowski/contact_set.h"

namespace foresee {

/// The inputs that all pairs share, as arrays.
struct LanesQuestion {
  Offsets a, b;
  double now, h;
  ContactSet::Arrays set;
  const Bounded* lengths;  ///< by number; those that vary from pair to pair are unspecified
  /// Then `touches` is about the time at which both exist first, if that is now. Else it is about any time.
  bool times_wanted;
  double* space;  ///< aligned, lanes_space() lines long
};

struct SetLanes {
  static constexpr int width = 16;

  const double *a[width], *b[width];  ///< rows
  // The results; times are measured from now:
  alignas(64) double begin[width], end[width];  ///< they can touch only within
  double touches[width];                        ///< above 0: certainly
};

/// As many numbers as the widest register holds, aligned for the kernels.
struct alignas(64) LanesLine {
  double numbers[8] = {};
};

/// The number of lines that a set needs: two per length, one per primitive.
inline std::size_t lanes_space(const ContactSet& set) {
  return 2 * set.lengths().size() + set.primitives().size();
}

template <int D, int Degree>
struct SetKernel {
  /// Fills in the results. Requires: each lane has rows.
  void (*classify)(const LanesQuestion& question, SetLanes& lanes);
};

template <int D, int Degree, Simd simd>
const SetKernel<D, Degree>& set_kernel();

/// The kernel of the widest instructions in use.
template <int D, int Degree>
const SetKernel<D, Degree>& set_kernel() {
  return with_simd_in_use(
      []<Simd simd>(Level<simd>) -> const SetKernel<D, Degree>& { return set_kernel<D, Degree, simd>(); });
}

}  // namespace foresee
