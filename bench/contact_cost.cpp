// Cost of exactness: the same join with the exact contact and with a textbook's in plain double, with the
// same grid, candidates and output.
//
//   bench_contact_cost [--quick] [workload ...]
//
// Boxes, discs, cylinders, and boxes with discs (workloads.h). Prints nanoseconds of processor time per
// object and the ratio of exact to plain, for a count and for (a, b, t), of the whole join and of contact
// alone. Figures are medians over repetitions in which both ran one after the other.
#include <cstdio>
#include <iterator>
#include <string>

#include "contact/contact.h"
#include "index/gpcd_grid/gpcd_grid.h"
#include "index/resting_bodies.h"
#include "measure.h"
#include "plain_contact.h"
#include "program.h"
#include "workloads.h"

namespace foresee::bench {
namespace {

NeverInterrupt never;

struct Cost {
  double whole = 0, contact = 0;
  std::size_t pairs = 0;
};

template <int D>
std::unique_ptr<Candidates> candidates_of(const Workload& w) {
  const auto boxes_of = [&](const Workload& side) {
    return testing::RestingBodies<D>(swept_boxes<D>(side.bodies(), {0, w.h}, Vec<D>::zero(), never));
  };
  const testing::RestingBodies<D> boxes = boxes_of(w);
  if (!w.other) return make_gpcd_grid<D>(boxes.side(), nullptr, never);
  const testing::RestingBodies<D> others = boxes_of(*w.other);
  const MovingBoxes<D> second = others.side();
  return make_gpcd_grid<D>(boxes.side(), &second, never);
}

/// The grid's candidates in batches, each given to `take`.
template <int D, class Take>
Cost joined(const Workload& w, Take&& take) {
  Cost cost;
  cost.whole = seconds_of([&] {
    const auto grid = candidates_of<D>(w);
    std::vector<Pair> hits;
    for (std::vector<Pair> batch; grid->next(batch); batch.clear()) {
      hits.clear();
      cost.contact += seconds_of([&] { take(batch, hits); });
      cost.pairs += hits.size();
    }
  });
  return cost;
}

template <int D>
Cost exact_join(const Workload& w, bool with_times) {
  const Workload& other = w.second();
  const auto contact = make_contact(w.bodies(), other.bodies(), {.horizon = {0, w.h}}, w.name, other.name);
  std::vector<ContactTimes> times;
  return joined<D>(w, [&](const std::vector<Pair>& candidates, std::vector<Pair>& hits) {
    if (!with_times) return contact->decide(candidates, hits);
    times.clear();
    contact->first_contacts(candidates, TimesWanted::starts, hits, times);
  });
}

template <int D>
Cost plain_join(const Workload& w, bool with_times) {
  const auto contact = make_plain_contact(w);
  std::vector<double> times;
  return joined<D>(w, [&](const std::vector<Pair>& candidates, std::vector<Pair>& hits) {
    if (!with_times) return contact->decide(candidates, hits);
    times.clear();
    contact->first_contacts(candidates, hits, times);
  });
}

/// Both contacts, one after the other.
template <int D>
void compare(const Workload& w, int repetitions) {
  std::printf("%s\n", w.name.c_str());
  for (const bool with_times : {false, true}) {
    std::vector<double> whole, contact, plain_ns, exact_ns;
    Cost plain, exact;
    for (int repetition = 0; repetition <= repetitions; ++repetition) {  // the first is a warm-up
      plain = plain_join<D>(w, with_times);
      exact = exact_join<D>(w, with_times);
      if (repetition == 0) continue;
      whole.push_back(exact.whole / plain.whole);
      contact.push_back(exact.contact / plain.contact);
      plain_ns.push_back(plain.whole * 1e9 / static_cast<double>(w.objects()));
      exact_ns.push_back(exact.whole * 1e9 / static_cast<double>(w.objects()));
    }
    std::printf(
        "    %-8s plain %7.0f ns, exact %7.0f ns per object: %5.2fx; contact alone %5.2fx; pairs %zu, %zu\n",
        with_times ? "a, b, t" : "count", median(plain_ns), median(exact_ns), median(whole), median(contact),
        plain.pairs, exact.pairs);
  }
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  for (const std::string& name :
       options.names({"S-100000", "P-zipf-5000", "L-30", "M-100000", "D-100000", "C-100000", "X-100000"})) {
    const Workload w = make_workload(name);
    const int repetitions = (quick ? 5 : 15) * (w.objects() <= 10000 ? 10 : 1);
    w.layout.axes == 2 ? compare<2>(w, repetitions) : compare<3>(w, repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
