// Filter of many pairs for contact of one contact set: the lanes (set_lanes.h) discard most pairs.
//
//   SetFilter<2, 1> filter(setup, set);
//   filter.for_each(pairs, CertainContact::at_start, [&](const Pair& pair, const Interval<double>& near, bool) { … });
//
// Cost: some twenty nanoseconds per pair.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/pair.h"
#include "contact/certified/pair_context.h"
#include "contact/certified/root_bracketing.h"
#include "contact/set/set_lanes.h"
#include "contact/setup.h"

namespace foresee {

/// Prefetches the rows of a later pair: neighbours in space are seldom neighbours in memory, and memory
/// latency would be a quarter of the cost of a decision.
inline void fetch_ahead(const Setup& setup, std::span<const Pair> pairs, std::size_t i) {
  constexpr std::size_t ahead = 16, doubles_per_line = 8;
  if (i + ahead >= pairs.size()) return;
  const double* row_a = setup.a.row(pairs[i + ahead].a);
  const double* row_b = setup.b.row(pairs[i + ahead].b);
  __builtin_prefetch(row_a);
  __builtin_prefetch(row_a + doubles_per_line);
  __builtin_prefetch(row_b);
  __builtin_prefetch(row_b + doubles_per_line);
}

/// The filter of many pairs: the lanes.
template <int D, int Degree>
class SetFilter {
 public:
  /// Both must outlive this.
  SetFilter(const Setup& setup, const ContactSet& set)
      : setup_(setup),
        lengths_(set),
        space_(lanes_space(set)),
        question_{.a = setup.a.at,
                  .b = setup.b.at,
                  .now = setup.horizon.now,
                  .h = setup.horizon.h,
                  .set = set.arrays(),
                  .lengths = lengths_.data(),
                  .times_wanted = false,
                  .space = reinterpret_cast<double*>(space_.data())} {}

  /// As EachPair::for_each().
  template <class Visit>
  void for_each(std::span<const Pair> pairs, CertainContact certain, Visit&& visit) {
    constexpr std::size_t width = SetLanes::width;
    question_.times_wanted = certain == CertainContact::at_start;
    for (std::size_t begin = 0; begin < pairs.size(); begin += width) {
      const auto some = pairs.subspan(begin, std::min(width, pairs.size() - begin));
      for (std::size_t l = 0; l < width; ++l) {
        fetch_ahead(setup_, pairs, begin + l);
        const Pair& pair = some[std::min(l, some.size() - 1)];  // lanes without a pair repeat the last one
        lanes_.a[l] = setup_.a.row(pair.a), lanes_.b[l] = setup_.b.row(pair.b);
      }
      kernel_.classify(question_, lanes_);
      for (std::size_t l = 0; l < some.size(); ++l)
        if (!(lanes_.begin[l] > lanes_.end[l]))
          visit(some[l], Interval<double>{lanes_.begin[l], lanes_.end[l]}, lanes_.touches[l] > 0);
    }
  }

 private:
  const Setup& setup_;
  const AllLengths<Bounded> lengths_;
  std::vector<LanesLine> space_;
  LanesQuestion question_;
  SetLanes lanes_;
  const SetKernel<D, Degree>& kernel_ = set_kernel<D, Degree>();
};

}  // namespace foresee
