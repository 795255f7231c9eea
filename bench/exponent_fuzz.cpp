// Maximum cost of one pair of hostile numbers: one row per pair of shapes, axes, law and fuzz, as CSV.
//
//   bench_exponent_fuzz [--quick]
//
// Every number of a pair (places, speeds, accelerations, extents, times, within, now, the horizon) gets a
// power of two of its own:
//
//   wide      up to 2^1000 and down to 2^-1000
//   few       the same, but all from four numbers, their negatives and 0: ties and coincidences
//   ends      the smallest and the largest doubles, and 0, 1 and 0.1
//   grid      small whole numbers with one far exponent among them
//
// A pair's cost is that of its decision and, if it touches, both times; processor time, the minimum of three
// runs. Fails if a pair takes more than 10 ms.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "contact/pair_by_hand.h"
#include "measure.h"
#include "scenes.h"

namespace foresee::bench {
namespace {

using testing_by_hand::Object;

enum class Fuzz { wide, few, ends, grid };
constexpr const char* fuzz_names[] = {"wide", "few", "ends", "grid"};

class Numbers {
 public:
  Numbers(Fuzz fuzz, std::uint64_t seed) : fuzz_(fuzz), random_(seed) {}

  void next_pair() {
    for (double& number : pool_) number = far();
  }

  double number() {
    switch (fuzz_) {
      case Fuzz::wide:
        return far();
      case Fuzz::few:
        return random_.below(4) == 0 ? 0 : signed_by_chance(pool_[random_.below(4)]);
      case Fuzz::ends: {
        constexpr double ends[] = {0, 0, 1, 0.1, 5e-324, 2.2e-308, 1e-154, 1e154, 8e307, 1e300};
        return signed_by_chance(ends[random_.below(std::size(ends))]);
      }
      default:
        return random_.below(16) == 0 ? far() : std::floor(random_.in(-4, 5));
    }
  }
  double size() { return std::abs(number()); }
  bool chance() { return random_.below(2) == 0; }

 private:
  double far() { return std::ldexp(random_.in(-1, 1), static_cast<int>(random_.below(2001)) - 1000); }
  double signed_by_chance(double value) { return chance() ? value : -value; }

  Fuzz fuzz_;
  testing::Random random_;
  std::array<double, 4> pool_{};
};

Object object(Numbers& numbers, int axes, Shape shape, Law law) {
  Object o = testing_by_hand::object(axes, shape);
  o.layout.law = law;
  for (int j = 0; j < axes; ++j) {
    o.x[j] = numbers.number(), o.v[j] = numbers.number(), o.a[j] = numbers.number();
    o.half[j] = numbers.size();
  }
  o.r = numbers.size(), o.hz = numbers.size();
  if (numbers.chance()) o.t = numbers.number();
  return o;
}

struct Kind {
  const char* name;
  Shape a, b;
  int min_axes;
};

struct PairCost {
  std::size_t pairs = 0, hits = 0;
  double mean = 0, max = 0;  ///< seconds
};

double cost_of(const Object& a, const Object& b, const ContactQuestion& question, bool& hit) {
  const std::vector<double> row_a = a.row(), row_b = b.row();
  const Bodies bodies_a(a.layout, row_a.data(), 1), bodies_b(b.layout, row_b.data(), 1);
  const auto contact = make_contact(bodies_a, bodies_b, question, "a", "b");
  const Pair pair{0, 0};
  std::vector<Pair> hits;
  std::vector<ContactTimes> times;
  double fastest = 1e9;
  for (int run = 0; run < 3; ++run) {
    hits.clear(), times.clear();
    const auto first_contacts = [&] { contact->first_contacts({&pair, 1}, TimesWanted::both, hits, times); };
    fastest = std::min(fastest, seconds_of(first_contacts));
  }
  hit = !hits.empty();
  return fastest;
}

PairCost cost_of(const Kind& kind, int axes, Law law, Fuzz fuzz, std::size_t pairs) {
  Numbers numbers(fuzz, 20260101);
  PairCost cost;
  while (cost.pairs < pairs) {
    numbers.next_pair();
    const Object a = object(numbers, axes, kind.a, law);
    Object b = object(numbers, axes, kind.b, law);
    if (numbers.chance()) std::copy_n(a.x, 3, b.x);
    ContactQuestion question{.horizon = {numbers.number(), numbers.size()}};
    if (numbers.chance()) question.within = numbers.size();
    bool hit = false;
    const double seconds = cost_of(a, b, question, hit);
    ++cost.pairs, cost.hits += hit;
    cost.mean += seconds / static_cast<double>(pairs), cost.max = std::max(cost.max, seconds);
  }
  return cost;
}

constexpr Kind kinds[] = {
    {"box, box", Shape::box, Shape::box, 1},
    {"ball, ball", Shape::ball, Shape::ball, 1},
    {"box, ball", Shape::box, Shape::ball, 1},
    {"cylinder, cylinder", Shape::cylinder, Shape::cylinder, 3},
    {"cylinder, box", Shape::cylinder, Shape::box, 3},
};

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  using namespace foresee;
  using namespace foresee::bench;
  const std::size_t pairs = count > 1 && std::strcmp(arguments[1], "--quick") == 0 ? 100 : 2000;
  constexpr double max_allowed = 0.010;
  double worst = 0;
  std::printf("pair,axes,law,numbers,pairs,hits,mean_us,worst_us\n");
  for (const Kind& kind : kinds)
    for (int axes = kind.min_axes; axes <= 3; ++axes)
      for (Law law : {Law::uniform, Law::accelerated})
        for (Fuzz fuzz : {Fuzz::wide, Fuzz::few, Fuzz::ends, Fuzz::grid}) {
          const PairCost cost = cost_of(kind, axes, law, fuzz, pairs);
          worst = std::max(worst, cost.max);
          std::printf("\"%s\",%d,%s,%s,%zu,%zu,%.1f,%.1f\n", kind.name, axes,
                      law == Law::uniform ? "uniform" : "accelerated", fuzz_names[static_cast<int>(fuzz)],
                      cost.pairs, cost.hits, cost.mean * 1e6, cost.max * 1e6);
          std::fflush(stdout);
        }
  std::fprintf(stderr, "worst pair: %.2f ms\n", worst * 1e3);
  return worst <= max_allowed ? 0 : 1;
}
