#include <algorithm>

#include "contact/certified/union_contact.h"
#include "contact/contact_factories.h"
#include "contact/outline/flat_traits.h"

namespace foresee {

template <int D, int Degree>
FilterAnswer FlatTraits<D, Degree>::filter_answer(const PairContext<FlatTraits>& context) {
  constexpr std::size_t few = 8, some = 16;
  if (context.a.count() * context.b.count() > some) return {};
  const double first = context.lifetime.dt_start, last = context.lifetime.dt_end, length = last - first;
  std::array<BoxedPair, few> pairs;
  std::size_t count = 0;
  context.walk.visit(
      Order::earlier_first, [&](const Interval<double>&) { return count <= few; },
      [&](std::size_t a, std::size_t b, const Interval<double>& near) {
        if (count < few) pairs[count] = {a, b, near.begin <= first};
        ++count;
      });
  if (count == 0) return {.touches = Verdict::no};
  if (count > few) return {};
  LinearPath plain{};
  const auto take_axis = [&](const CertainAxisMotion<double>& d, double& begin, double& end) {
    const CertainAxisMotion<double> from = view_from<Degree>(d, first, context.relative.underflow);
    const CertainAxisMotion<double> to = view_from<Degree>(d, last, context.relative.underflow);
    begin = from.x, end = to.x;
    // The slack also covers times that doubles round.
    plain.slack += std::max(from.ex, to.ex) + 0x1p-45 * (last * (std::abs(d.v) + last * std::abs(d.a)));
    plain.bend += 0.3 * (length * (length * (std::abs(d.a) + d.ea)));
  };
  take_axis(context.relative.axis[0], plain.begin.x, plain.end.x);
  take_axis(context.relative.axis[1], plain.begin.y, plain.end.y);
  // An enclosure of all sizes between the first and the last.
  const MovingSize<Bounded>& grown = context.sizes.radius;
  Bounded radius = expanded_at(grown, first).value;
  if (grown.moves) {
    const Bounded more = Bounded{0.5 * length} * grown.rate;
    radius = radius + more, radius.error += more.value * (1 + 0x1p-40) + more.error;
  }
  const FilterAnswer answer = filter_outlines(plain, context.a, context.b, std::span(pairs).first(count),
                                              radius, D == 2 && context.times_wanted);
  return D == 2 || answer.touches == Verdict::no ? answer : FilterAnswer{};
}

std::unique_ptr<Contact> make_outline_contact(const Setup& setup, const OutlineTables& outlines, int degree) {
  if (setup.a.layout.axes < 3) {
    if (degree < 2) return std::make_unique<UnionContact<FlatTraits<2, 1>>>(setup, outlines);
    return std::make_unique<UnionContact<FlatTraits<2, 2>>>(setup, outlines);
  }
  if (degree < 2) return std::make_unique<UnionContact<FlatTraits<3, 1>>>(setup, outlines);
  return std::make_unique<UnionContact<FlatTraits<3, 2>>>(setup, outlines);
}

}  // namespace foresee
