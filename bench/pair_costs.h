// Cost of the contact test of one pair, ours beside rivals, and the pairs that these miss.
//
//   PairCosts costs(*contact, pairs);                      // decide(), starts, starts and ends
//   costs.add_rival("FCL, 10 samples", pairs.size(), [&](const Pair& pair) { return time or never; });
//   costs.measure(15), costs.print("meshes of 80 triangles");
//
// In every repetition each method runs once, one after the other. Figures are nanoseconds of processor time
// per pair, medians. A rival's ratios are its time over that of our three results, in this order.
#pragma once

#include <functional>
#include <string>

#include "agreement.h"

namespace foresee::bench {

class PairCosts {
 public:
  /// `contact` must outlive this.
  PairCosts(Contact& contact, std::vector<Pair> pairs) : contact_(contact), pairs_(std::move(pairs)) {}

  const std::vector<Pair>& pairs() const { return pairs_; }
  /// Runs on the first `max_pairs` pairs, in at most `repetitions` repetitions; 0: once, without warm-up.
  void add_rival(std::string name, std::size_t max_pairs, int repetitions,
                 std::function<double(const Pair&)> first_time);
  void measure(int repetitions);
  void print(const char* scene) const;

 private:
  struct Rival {
    std::string name;
    std::size_t pairs;
    int repetitions;
    std::function<double(const Pair&)> first_time;
    std::vector<double> costs = {}, instants = {};
  };

  void measure_ours(bool counts);
  void measure_rival(Rival& rival, bool counts) const;

  Contact& contact_;
  const std::vector<Pair> pairs_;
  std::vector<double> decide_, starts_, both_;  ///< nanoseconds per pair, of each repetition
  std::vector<double> instants_;
  std::vector<Rival> rivals_;
};

}  // namespace foresee::bench
