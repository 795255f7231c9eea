// What does one pair cost, ours beside rivals, and what do these miss?
//
//   PairCosts costs(*contact, pairs);                      // decide(), begins, begins and ends
//   costs.add_rival("FCL, 10 samples", pairs.size(), [&](const Pair& pair) { return time or never; });
//   costs.measure(15), costs.print("meshes of 80 triangles");
//
// In every repetition each way runs once, one after the other: nanoseconds of processor time a pair, medians.
// A rival's ratios are its time over that of our three answers, in this order.
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
  /// Asked about the first `most` pairs, in as many repetitions at most; 0: once, without warming up.
  void add_rival(std::string name, std::size_t most, int repetitions,
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
  std::vector<double> decide_, starts_, both_;  ///< nanoseconds a pair, of each repetition
  std::vector<double> instants_;
  std::vector<Rival> rivals_;
};

}  // namespace foresee::bench
