// What does exactness cost? The same join with the exact contact and with a textbook's in plain double: the
// same grid, the same candidates, the same output.
//
//   bench_contact_cost [--quick] [workload ...]
//
// Prints nanoseconds of processor time an object and the ratio of exact to plain (medians over repetitions in
// which both ran one after the other): for a count and for (a, b, t), of the whole join and of contact alone.
#include <cstdio>
#include <iterator>
#include <string>

#include "contact/contact.h"
#include "index/gpcd_grid/gpcd_grid.h"
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

/// The grid's candidates in batches, each given to `take`.
template <int D, class Take>
Cost joined(const Workload& w, Take&& take) {
  Cost cost;
  cost.whole = seconds_of([&] {
    const std::vector<Box<D>> boxes = swept_boxes<D>(w.bodies(), {0, w.h}, Vec<D>::Zero(), never);
    const auto grid = make_gpcd_grid<D>(std::span<const Box<D>>(boxes), never);
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
  const auto contact = make_contact(w.bodies(), w.bodies(), {.horizon = {0, w.h}}, w.name, w.name);
  std::vector<ContactTimes> times;
  return joined<D>(w, [&](const std::vector<Pair>& candidates, std::vector<Pair>& hits) {
    if (!with_times) return contact->decide(candidates, hits);
    times.clear();
    contact->first_contacts(candidates, TimesWanted::begins, hits, times);
  });
}

template <int D, int Degree>
Cost plain_join(const Workload& w, bool with_times) {
  const PlainContact<D, Degree> contact(w.bodies(), w.h);
  std::vector<double> times;
  return joined<D>(w, [&](const std::vector<Pair>& candidates, std::vector<Pair>& hits) {
    if (!with_times) return contact.decide(candidates, hits);
    times.clear();
    contact.first_contacts(candidates, hits, times);
  });
}

/// Both ways, one after the other.
template <int D>
void compare(const Workload& w, int repetitions) {
  std::printf("%s\n", w.name.c_str());
  for (const bool with_times : {false, true}) {
    std::vector<double> whole, contact, plain_ns, exact_ns;
    Cost plain, exact;
    for (int repetition = 0; repetition <= repetitions; ++repetition) {  // the first only warms up
      plain =
          w.layout.law < Law::accelerated ? plain_join<D, 1>(w, with_times) : plain_join<D, 2>(w, with_times);
      exact = exact_join<D>(w, with_times);
      if (repetition == 0) continue;
      whole.push_back(exact.whole / plain.whole);
      contact.push_back(exact.contact / plain.contact);
      plain_ns.push_back(plain.whole * 1e9 / static_cast<double>(w.count));
      exact_ns.push_back(exact.whole * 1e9 / static_cast<double>(w.count));
    }
    std::printf(
        "    %-8s plain %7.0f ns, exact %7.0f ns an object: %5.2fx; contact alone %5.2fx; pairs %zu, %zu\n",
        with_times ? "a, b, t" : "count", median(plain_ns), median(exact_ns), median(whole), median(contact),
        plain.pairs, exact.pairs);
  }
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  for (const std::string& name : options.names({"S-100000", "P-zipf-5000", "L-30", "M-100000"})) {
    const Workload w = make_workload(name);
    const int repetitions = (quick ? 5 : 15) * (w.count <= 10000 ? 10 : 1);
    w.layout.axes == 2 ? compare<2>(w, repetitions) : compare<3>(w, repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
