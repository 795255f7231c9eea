// The contact set of some pairs of pieces, for the exact stage: what doubles leave open hangs on these alone.
//
// A set like those of other shapes (set/contact_set.h), made for one pair of objects: its lengths are the
// corners, as given numbers, and their exact differences.
#pragma once

#include <span>

#include "contact/outline/object_pieces.h"
#include "contact/pieces/tested_pairs.h"
#include "contact/set/contact_set.h"
#include "contact/set/relative_motion.h"

namespace foresee {

struct CriticalPieces {
  ContactSet set;
  std::vector<std::uint32_t> ends;  ///< of each pair: how many pieces it and those before it have in the set
};

/// `grown`: how near counts as touching is more than 0, for these objects.
CriticalPieces critical_pieces(const Setup& setup, const ObjectPieces& a, const ObjectPieces& b,
                               std::span<const PiecePair> pairs, bool grown);

}  // namespace foresee
