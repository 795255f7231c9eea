#include "pair_costs.h"

#include <cstdio>

#include "measure.h"

namespace foresee::bench {
namespace {

template <class Work>
double nanoseconds_a_pair(std::size_t pairs, Work&& work) {
  return seconds_of(work) * 1e9 / static_cast<double>(pairs);
}

}  // namespace

void PairCosts::add_rival(std::string name, std::size_t max_pairs, int repetitions,
                          std::function<double(const Pair&)> first_time) {
  rivals_.push_back(
      {std::move(name), std::min(max_pairs, pairs_.size()), repetitions, std::move(first_time)});
}

/// The first repetition warms up.
void PairCosts::measure(int repetitions) {
  for (int i = 0; i <= repetitions; ++i) {
    measure_ours(i > 0);
    for (Rival& rival : rivals_)
      if (i <= rival.repetitions) measure_rival(rival, i > 0 || rival.repetitions == 0);
  }
}

void PairCosts::measure_ours(bool counts) {
  std::vector<Pair> hits;
  std::vector<ContactTimes> times;
  const auto run = [&](std::vector<double>& costs, auto&& work) {
    hits.clear(), times.clear();
    const double cost = nanoseconds_a_pair(pairs_.size(), work);
    if (counts) costs.push_back(cost);
  };
  run(decide_, [&] { contact_.decide(pairs_, hits); });
  run(starts_, [&] { contact_.first_contacts(pairs_, TimesWanted::starts, hits, times); });
  run(both_, [&] { contact_.first_contacts(pairs_, TimesWanted::both, hits, times); });
  instants_ = times_of(pairs_, hits, times);
}

void PairCosts::measure_rival(Rival& rival, bool counts) const {
  rival.instants.assign(rival.pairs, never);
  const double cost = nanoseconds_a_pair(rival.pairs, [&] {
    for (std::size_t i = 0; i < rival.pairs; ++i) rival.instants[i] = rival.first_time(pairs_[i]);
  });
  if (counts) rival.costs.push_back(cost);
}

void PairCosts::print(const char* scene) const {
  const double decide = median(decide_), starts = median(starts_), both = median(both_);
  const auto touch = [](std::span<const double> instants) {
    return std::count_if(instants.begin(), instants.end(), [](double time) { return time >= 0; });
  };
  std::printf("%s: %zu pairs, %td touch; %s\n", scene, pairs_.size(), touch(instants_),
              contact_.effort().c_str());
  std::printf("    %-26s %9.0f ns decide %9.0f ns t %9.0f ns t, t_end\n", "foresee", decide, starts, both);
  for (const Rival& rival : rivals_) {
    const double cost = median(rival.costs);
    const Agreement found = agreement_of(instants_, rival.instants);
    std::printf(
        "    %-26s %9.0f ns: %.3gx %.3gx %.3gx; of %td in %zu pairs misses %zu, invents %zu, t off by %.2g "
        "s\n",
        rival.name.c_str(), cost, cost / decide, cost / starts, cost / both,
        touch(std::span(instants_).first(rival.pairs)), rival.pairs, found.missed, found.invented, found.off);
  }
  std::fflush(stdout);
}

}  // namespace foresee::bench
