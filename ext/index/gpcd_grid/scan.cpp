#include "index/gpcd_grid/scan.h"

namespace foresee::gpcd {
namespace {

/// One row against the lanes from `lane` on; every pointer is a lane array.
template <int D>
struct Row {
  float lower[D], upper[D];
  std::uint32_t classes, id;

  Row(const Lanes<D>& rows, std::size_t i) : classes(rows.classes[i]), id(rows.ids[i]) {
    for (int axis = 0; axis < D; ++axis) lower[axis] = rows.lower[axis][i], upper[axis] = rows.upper[axis][i];
  }
};

/// 1 for each of the next lanes whose box overlaps the row and whose pair belongs to this stripe. `sorted`:
/// lanes begin no earlier than the row, so that one comparison along x is enough.
template <int D, bool sorted>
inline void overlaps(const Row<D>& row, const Lanes<D>& lanes, std::size_t lane,
                     std::uint32_t (&hit)[lanes_per_step]) {
  const float* lower[D];
  const float* upper[D];
  for (int axis = 0; axis < D; ++axis) {
    lower[axis] = lanes.lower[axis].data() + lane;
    upper[axis] = lanes.upper[axis].data() + lane;
  }
  const std::uint32_t* classes = lanes.classes.data() + lane;
  for (std::size_t l = 0; l < lanes_per_step; ++l) {
    std::uint32_t h = lower[0][l] <= row.upper[0];
    if constexpr (!sorted) h &= upper[0][l] >= row.lower[0];
    for (int axis = 1; axis < D; ++axis) {
      h &= lower[axis][l] <= row.upper[axis];
      h &= upper[axis][l] >= row.lower[axis];
    }
    if constexpr (D > 1) h &= (classes[l] & row.classes) == 0;
    hit[l] = h;
  }
}

/// The first lane that can reach the row.
template <int D>
std::size_t first_lane(Scan<D>& scan, float row_lower) {
  const Lanes<D>& lanes = *scan.lanes;
  while (scan.left < lanes.size &&
         static_cast<double>(lanes.lower[0][scan.left]) + lanes.longest < static_cast<double>(row_lower))
    ++scan.left;
  return scan.left;
}

template <int D, bool sorted, bool swap>
std::size_t run_rows(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  const Lanes<D>& lanes = *scan.lanes;
  const float* begins = lanes.lower[0].data();
  const std::uint32_t* ids = lanes.ids.data();
  const std::size_t full = room < lanes_per_step ? 0 : room - lanes_per_step + 1;
  std::size_t written = 0;
  for (; scan.row < scan.rows->size; ++scan.row, scan.begun = false) {
    const Row<D> row(*scan.rows, scan.row);
    std::size_t lane = scan.begun ? scan.lane : sorted ? scan.row + 1 : first_lane(scan, row.lower[0]);
    for (std::size_t left = steps;; --left, lane += lanes_per_step) {
      if (left == 0 || written >= full) {
        steps = left, scan.lane = lane, scan.begun = true;
        return written;
      }
      if (begins[lane] > row.upper[0]) {
        steps = left - 1;
        break;
      }
      std::uint32_t hit[lanes_per_step];
      overlaps<D, sorted>(row, lanes, lane, hit);
      for (std::size_t l = 0; l < lanes_per_step; ++l) {
        out[written] = swap ? Pair{ids[lane + l], row.id} : Pair{row.id, ids[lane + l]};
        written += hit[l];
      }
    }
  }
  return written;
}

}  // namespace

template <int D>
std::size_t run(Scan<D>& scan, Pair* out, std::size_t room, std::size_t& steps) {
  if (scan.rows == scan.lanes) return run_rows<D, true, false>(scan, out, room, steps);
  if (scan.swap) return run_rows<D, false, true>(scan, out, room, steps);
  return run_rows<D, false, false>(scan, out, room, steps);
}

template std::size_t run(Scan<1>&, Pair*, std::size_t, std::size_t&);
template std::size_t run(Scan<2>&, Pair*, std::size_t, std::size_t&);
template std::size_t run(Scan<3>&, Pair*, std::size_t, std::size_t&);

}  // namespace foresee::gpcd
