#include "shape/outline/outline.h"

#include <algorithm>

#include "numbers/double_double.h"
#include "numbers/dyadic.h"

namespace foresee {
namespace {

int sign_of(double number) {
  return (number > 0) - (number < 0);
}

/// Whether a product of two such differences is exact as a sum of two doubles.
bool exact_in_products(const DoubleDouble& gap) {
  const double size = std::abs(gap.high);
  return gap.low == 0 && (size == 0 || (size > 0x1p-450 && size < 0x1p450));
}

}  // namespace

void Outline::begin_part() {
  part_starts_.push_back(static_cast<std::uint32_t>(rings()));
  begin_hole();
}

void Outline::begin_hole() {
  ring_ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
}

void Outline::add(const Corner& corner) {
  const bool first = ring(rings() - 1).empty();
  if (!first && corners_.back() == corner) return;
  corners_.push_back({corner.x + 0.0, corner.y + 0.0});  // -0 becomes 0
  ++ring_ends_.back();
}

bool Outline::close_ring() {
  const std::span<const Corner> last = ring(rings() - 1);
  if (last.size() < 2 || last.front() != last.back()) return false;
  corners_.pop_back();
  --ring_ends_.back();
  return true;
}

Extents<2> Outline::extents() const {
  Extents<2> around{{corners_[0].x, corners_[0].y}, {corners_[0].x, corners_[0].y}};
  for (const Corner& corner : corners_) {
    const Vec<2> at{corner.x, corner.y};
    around.lower = around.lower.min(at), around.upper = around.upper.max(at);
  }
  return around;
}

int close_turn_sign(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const DoubleDouble ax = difference(b.x, a.x), ay = difference(b.y, a.y);
  const DoubleDouble bx = difference(d.x, c.x), by = difference(d.y, c.y);
  if (exact_in_products(ax) && exact_in_products(ay) && exact_in_products(bx) && exact_in_products(by)) {
    const DoubleDouble left = product(ax.high, by.high), right = product(ay.high, bx.high);
    // Equal products have equal parts; a greater product has a high part that is not smaller.
    return left.high != right.high ? sign_of(left.high - right.high) : sign_of(left.low - right.low);
  }
  return ((Dyadic(b.x) - Dyadic(a.x)) * (Dyadic(d.y) - Dyadic(c.y)) -
          (Dyadic(b.y) - Dyadic(a.y)) * (Dyadic(d.x) - Dyadic(c.x)))
      .sign();
}

bool is_counterclockwise(std::span<const Corner> ring) {
  const auto first =
      static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), before) - ring.begin());
  const Corner &last = ring[(first == 0 ? ring.size() : first) - 1], &next = ring[(first + 1) % ring.size()];
  return orientation(last, ring[first], next) > 0;
}

int convex_direction(std::span<const Corner> ring) {
  const std::size_t n = ring.size();
  if (n < 3) return 0;
  int direction = 0, reversals = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Corner &last = ring[(i == 0 ? n : i) - 1], &here = ring[i], &next = ring[i + 1 == n ? 0 : i + 1];
    const int turn = orientation(last, here, next);
    const bool reverses = before(last, here) != before(here, next);
    if (turn == 0 ? reverses : turn == -direction) return 0;
    if (turn != 0) direction = turn;
    reversals += reverses;
  }
  return reversals == 2 ? direction : 0;
}

}  // namespace foresee
