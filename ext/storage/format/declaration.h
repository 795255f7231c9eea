// What CREATE VIRTUAL TABLE said: the declared columns in their order, the auxiliary columns, the options.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shape/layout.h"

namespace foresee {

/// One declared column of the motion vocabulary (the id is not among them) and its place in the stored
/// record.
struct MotionColumn {
  std::string name;      ///< as docs/sql_reference.md#columns spells it: t, x, vy, fz, m, hx, r, shape, until
  int place;             ///< index among the record's doubles
  bool is_form = false;  ///< what stands there is the number of an outline
};

/// `+name TYPE`: carried along.
struct AuxiliaryColumn {
  std::string name;
  std::string type;  ///< what stands behind the name, possibly empty
};

struct Declaration {
  Layout layout;
  std::vector<MotionColumn> columns = {};  ///< in the order in which they were declared
  std::vector<AuxiliaryColumn> auxiliaries = {};
  double horizon = 60;  ///< the look-ahead for which the tree is tuned
};

}  // namespace foresee
