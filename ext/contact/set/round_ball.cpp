#include "contact/set/round_ball.h"

#include "contact/set/rounded_box.h"

namespace foresee {

void add_ball(ContactSet& set, int axes, const Size& radius, const Faces* along_z) {
  Conditions piece;
  if (along_z) {
    piece.all = between(set, {along_z, 1});
    set.enclose(*along_z);
  }
  std::vector<AxisPart> centre;
  for (int axis = 0; axis < axes; ++axis) {
    centre.push_back({.axis = axis});
    const Faces around{.axis = axis, .below = radius, .above = radius};
    set.enclose(around);
    for (const int bound : between(set, {&around, 1})) piece.around.push_back(bound);
  }
  piece.ball = set.ball(centre, radius);
  piece.all.push_back(piece.ball);
  set.add_piece(piece);
}

}  // namespace foresee
