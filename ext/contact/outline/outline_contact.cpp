#include "contact/outline_contact.h"

#include <algorithm>

#include "contact/outline/flat_kit.h"
#include "contact/pieces/union_contact.h"
#include "contact/pieces/window_near.h"

namespace foresee::contact {

template <int D, int Degree>
void FlatKit<D, Degree>::take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables,
                              const Pair& pair) {
  if (setup.window && !tables.a)
    a.take_box(window_near<2>(setup, setup.b.row(pair.b)));
  else
    a.take_row(setup.a, tables.a, pair.a);
  b.take_row(setup.b, tables.b, pair.b);
  if (a.is_point() && b.is_point()) a.take_box(0, 0);  // a sum needs edges
}

template <int D, int Degree>
PlainAnswer FlatKit<D, Degree>::plain_answer(const Setup& setup, const double* row_a, const double* row_b,
                                             const Pieces& a, const Pieces& b, const Moments& moments,
                                             bool times_wanted) {
  if (setup.window) return {};  // as large as doubles go
  const CertainMotion<D> relative = certain_motion_of<D, Degree>(setup, row_a, row_b);
  const double last = moments.dt_end, length = last - moments.dt_begin;
  PlainWay way{};
  const auto take_axis = [&](const CertainAxisMotion<double>& d, double& begin, double& end) {
    const AxisView<double> first = view_from<Degree>(d, moments.dt_begin, relative.underflow);
    const AxisView<double> then = view_from<Degree>(d, last, relative.underflow);
    begin = first.p, end = then.p;
    // Also for moments that doubles round.
    way.slack += std::max(first.ep, then.ep) + 0x1p-45 * (last * (std::abs(d.v) + last * std::abs(d.a)));
    way.bend += 0.3 * (length * (length * (std::abs(d.a) + d.ea)));
  };
  take_axis(relative.axis[0], way.begin.x, way.end.x);
  take_axis(relative.axis[1], way.begin.y, way.end.y);
  // Anything between its first size and its last.
  const MovingSize<Bounded> grown = contact::sizes_of<Bounded>(setup, row_a, row_b).radius;
  Bounded radius = seen_from(grown, moments.dt_begin).value;
  if (grown.moves) {
    const Bounded more = Bounded{0.5 * length} * grown.rate;
    radius = radius + more, radius.error += more.value * (1 + 0x1p-40) + more.error;
  }
  const PlainAnswer plain = plainly_near(way, a, b, radius, D == 2 && times_wanted);
  return D == 2 || plain.touches == Verdict::no ? plain : PlainAnswer{};
}

std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree) {
  if (setup.a.layout.axes < 3) {
    if (degree < 2) return std::make_unique<UnionContact<FlatKit<2, 1>>>(setup, outlines);
    return std::make_unique<UnionContact<FlatKit<2, 2>>>(setup, outlines);
  }
  if (degree < 2) return std::make_unique<UnionContact<FlatKit<3, 1>>>(setup, outlines);
  return std::make_unique<UnionContact<FlatKit<3, 2>>>(setup, outlines);
}

}  // namespace foresee::contact
