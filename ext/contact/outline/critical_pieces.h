// The contact set of the pairs of convex pieces that doubles leave undecided, for the exact stage.
//
// It is a set like those of other shapes (set/contact_set.h), made for one pair of objects. Its lengths
// are the corners, as given numbers, and their exact differences.
#pragma once

#include <span>

#include "contact/outline/object_pieces.h"
#include "contact/pieces/pair_tests.h"
#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

struct CriticalPieces {
  ContactSet set;
  std::vector<std::uint32_t> ends;  ///< of each pair: the number of set pieces up to and with it
};

/// `grown`: the contact distance of these objects is more than 0.
CriticalPieces critical_pieces(const Setup& setup, const ObjectPieces& a, const ObjectPieces& b,
                               std::span<const PiecePair> pairs, bool grown);

}  // namespace foresee
