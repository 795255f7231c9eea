// A read-only view of many moving objects: the input of contact, swept boxes and queries.
//
//   double rows[] = {0, 0, 1, 0,    10, 0, -1, 0};                       // x, y, vx, vy of two points
//   Bodies ships{Layout{.axes = 2, .law = Law::uniform}, rows, 2};
//   ships.row(1)[ships.at.v] == -1
//
// Rows are `at.size` doubles each, one after another, in the order of row_offsets(layout).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "base/error.h"
#include "base/pair.h"
#include "motion/motion.h"
#include "shape/form_rows.h"
#include "shape/row_layout.h"

namespace foresee {

struct Bodies {
  Bodies() = default;
  Bodies(const Layout& of_layout, const double* first_row, std::size_t row_count)
      : layout(of_layout), at(row_offsets(of_layout)), rows(first_row), count(row_count) {}

  const double* row(std::size_t i) const { return rows + i * static_cast<std::size_t>(at.size); }

  Layout layout;
  Offsets at;
  const double* rows = nullptr;
  std::size_t count = 0;
  const OutlineRows* outlines = nullptr;  ///< of Shape::outline, for contact: each row's outline
  const MeshRows* meshes = nullptr;       ///< of Shape::mesh, likewise
};

template <int D>
Motion<D> motion_of(const Bodies& bodies, std::size_t i) {
  const double* row = bodies.row(i);
  const Offsets& at = bodies.at;
  auto vector_at = [row](int place) {
    return place == Offsets::absent ? Vec<D>::zero() : Vec<D>::at(row + place);
  };
  return {value_or(row, at.t, 0), vector_at(at.x), vector_at(at.v), vector_at(at.a),
          value_or(row, at.until, std::numeric_limits<double>::infinity())};
}

}  // namespace foresee
