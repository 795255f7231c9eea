#include "plain_contact.h"

#include "base/error.h"
#include "plain_shapes.h"

namespace foresee::bench {
namespace {

template <class Touch>
class TypedPlainContact final : public PlainContact {
 public:
  explicit TypedPlainContact(const Workload& w)
      : a_(w.bodies()), b_(w.second().bodies()), touch_(a_.at, b_.at, w.h) {}

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (first<false>(pairs, i) >= 0) hits.push_back(pairs[i]);
  }
  void first_contacts(std::span<const Pair> pairs, std::vector<Pair>& hits,
                      std::vector<double>& times) const override {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double t = first<true>(pairs, i);
      if (t >= 0) hits.push_back(pairs[i]), times.push_back(t);
    }
  }

 private:
  template <bool Timed>
  double first(std::span<const Pair> pairs, std::size_t i) const {
    fetch_ahead(pairs, i);
    return touch_.template first<Timed>(a_.row(pairs[i].a), b_.row(pairs[i].b));
  }

  void fetch_ahead(std::span<const Pair> pairs, std::size_t i) const {
    constexpr std::size_t ahead = 8, doubles_per_line = 8;
    if (i + ahead >= pairs.size()) return;
    for (const double* row : {a_.row(pairs[i + ahead].a), b_.row(pairs[i + ahead].b)}) {
      __builtin_prefetch(row);
      __builtin_prefetch(row + doubles_per_line);
    }
  }

  Bodies a_, b_;
  Touch touch_;
};

template <int D, int Degree>
std::unique_ptr<PlainContact> typed_contact(const Workload& w) {
  const Shape a = w.layout.shape, b = w.second().layout.shape;
  if (a == Shape::box && b == Shape::box) return std::make_unique<TypedPlainContact<BoxAndBox<D, Degree>>>(w);
  if (a == Shape::ball && b == Shape::ball)
    return std::make_unique<TypedPlainContact<BallAndBall<D, Degree>>>(w);
  if (D == 2 && a == Shape::box && b == Shape::ball)
    return std::make_unique<TypedPlainContact<BoxAndDisc<Degree>>>(w);
  if (D == 3 && a == Shape::cylinder && b == Shape::cylinder)
    return std::make_unique<TypedPlainContact<CylinderAndCylinder<Degree>>>(w);
  throw Error("no textbook's contact for the shapes of '" + w.name + "'");
}

}  // namespace

std::unique_ptr<PlainContact> make_plain_contact(const Workload& w) {
  const bool accelerated = w.layout.law == Law::accelerated;
  if (w.layout.axes == 2) return accelerated ? typed_contact<2, 2>(w) : typed_contact<2, 1>(w);
  return accelerated ? typed_contact<3, 2>(w) : typed_contact<3, 1>(w);
}

}  // namespace foresee::bench
