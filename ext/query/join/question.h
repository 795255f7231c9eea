// What every answer to a JoinQuestion begins with: is it in order, and which contact does it ask about?
#pragma once

#include <cmath>
#include <limits>

#include "query/join/join.h"

namespace foresee::query {

/// Throws Error as Join's constructor says.
void require_valid(const JoinQuestion& question);

/// The contact that decides this question's pairs: make_contact() with its scenes, which must outlive the
/// contact, and its limits.
std::unique_ptr<Contact> contact_of(const JoinQuestion& question);

/// Each side's swept boxes grow by half the reach, rounded up: two grown boxes meet wherever the pair can
/// touch.
template <int D>
Vec<D> margin_of(const Contact::Reach& reach) {
  auto half = [](double whole) {
    return whole > 0 ? std::nextafter(whole / 2, std::numeric_limits<double>::infinity()) : 0.0;
  };
  Vec<D> margin = Vec<D>::Constant(half(reach.within));
  if constexpr (D == 3) margin[2] = half(reach.within_z);
  return margin;
}

}  // namespace foresee::query
