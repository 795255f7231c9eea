#include "contact/mesh/disc_tests.h"

#include <limits>

namespace foresee {
namespace {

const BoundingDiscs* discs_of(const SpacePieces& pieces) {
  const TriangleTree* const triangles = pieces.triangles();
  return triangles && triangles->discs().are_there() ? &triangles->discs() : nullptr;
}

double size_around(const Box<3>& box) {
  return box.lower.abs().max(box.upper.abs()).sum();
}

}  // namespace

DiscTests::DiscTests(const SpacePieces& a, const SpacePieces& b, const Chord<3>& chord,
                     const CertainMotion<3>& relative, const SpaceSizes<Bounded>& sizes, double end)
    : boxes_(a, b, chord, relative, sizes, end),
      radius_(sizes.radius.value.value + sizes.radius.value.error),
      end_(end) {
  if (!discs_of(a) || !discs_of(b) || !boxes_.boxes().is_plain()) return;
  a_ = discs_of(a), b_ = discs_of(b);
  double size = size_around(a.box(SpacePieces::root)) + size_around(b.box(SpacePieces::root)), lost = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& r = relative.axis[j];
    place_[j] = r.x, speed_[j] = r.v + end * r.a, swing_[j] = end * (end * r.a) / 4;
    size += std::abs(r.x) + end * (std::abs(r.v) + end * std::abs(r.a));
    lost += r.ex + end * (r.ev + end * r.ea) + relative.underflow;
  }
  slack_ = 0x1p-40 * (size + radius_) + 4 * lost + 0x1p-1000;
}

Interval<double> DiscTests::cut(const BoundingDisc& a, const BoundingDisc& b, Interval<double> near) const {
  const auto dot = [](const auto& m, const auto& n) {
    return double{m[0]} * double{n[0]} + double{m[1]} * double{n[1]} + double{m[2]} * double{n[2]};
  };
  const double cosine = dot(a.normal, b.normal);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0) + 0x1p-20);
  const Triple gap{double{a.middle[0]} - double{b.middle[0]}, double{a.middle[1]} - double{b.middle[1]},
                   double{a.middle[2]} - double{b.middle[2]}};
  const auto across = [&](const BoundingDisc& own, const BoundingDisc& other) {
    const auto& n = own.normal;
    const double reach = own.half + std::abs(cosine) * other.half + sine * other.radius + radius_;
    const double swing = std::abs(dot(n, swing_)), at = dot(n, place_), speed = dot(n, speed_);
    const double extent = reach * (1 + 0x1p-20) + swing + slack_, middle = dot(n, gap) - at;
    if (!(std::abs(speed) * end_ > slack_)) {
      if (std::abs(middle) > extent + 4 * slack_) near.end = -unbounded;
      return;
    }
    const double steep = 1 / speed, one = (middle - extent) * steep, other_one = (middle + extent) * steep;
    near.begin = std::max(near.begin, std::min(one, other_one));
    near.end = std::min(near.end, std::max(one, other_one));
  };
  across(a, b);
  across(b, a);
  return near;
}

}  // namespace foresee
