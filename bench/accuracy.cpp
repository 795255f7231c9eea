// Error against run time: every method to compute when two moving objects touch, on every hard family, beside
// the exact result.
//
//   bench_accuracy FOLDER [--quick]
//
// Writes FOLDER/accuracy.csv (a row per family and method) and FOLDER/stages.csv (which stage of the exact
// engine decided). docs/explanation/accuracy.md explains them; accuracy.sh runs this and draws the pictures.
// Fails if the exact engine is wrong anywhere.
#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "accuracy/engine.h"
#include "measure.h"

namespace foresee::bench {
namespace {

constexpr std::uint64_t seed = 20260101;

struct Effort {
  std::size_t pairs = 2000, judged = 100;
  double seconds_a_run = 0.02;
  int runs = 5, max_steps = 100000;
};

/// Median, 99th percentile, maximum.
struct Summary {
  double median = 0, p99 = 0, max = 0;

  explicit Summary(std::vector<double> values) {
    if (values.empty()) return;
    std::sort(values.begin(), values.end());
    median = values[values.size() / 2];
    p99 = values[std::min(values.size() - 1, values.size() * 99 / 100)];
    max = values.back();
  }
};

/// The number of doubles between two times that are not negative; the largest possible for a NaN.
double ulps_between(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return 0x1p63;
  const auto place = [](double x) {
    return static_cast<double>(std::bit_cast<std::int64_t>(std::max(x, 0.0) + 0.0));
  };
  const auto near = std::bit_cast<std::int64_t>(a + 0.0) - std::bit_cast<std::int64_t>(b + 0.0);
  return a >= 0 && b >= 0 ? std::abs(static_cast<double>(near)) : std::abs(place(a) - place(b));
}

struct Measured {
  std::size_t pairs = 0, hits = 0, missed = 0, invented = 0;
  double ns = 0;                      ///< median over the runs
  double ns_p99 = 0;                  ///< over single pairs, with some 30 ns of clock in each
  std::vector<double> ulps, seconds;  ///< of pairs that truly meet and are found
};

Measured measure(const Method& method, const Truth& truth, const Effort& effort) {
  Measured m;
  std::vector<Answer> answers(truth.answers.size());
  const std::size_t few = std::min<std::size_t>(16, answers.size());
  const double guess = seconds_of([&] { method.answer(0, few, answers.data()); }) / static_cast<double>(few);
  m.pairs = static_cast<std::size_t>(
      std::clamp(effort.seconds_a_run / std::max(guess, 1e-9), 24.0, static_cast<double>(answers.size())));
  std::vector<double> runs;
  for (int run = 0; run < effort.runs; ++run)
    runs.push_back(seconds_of([&] { method.answer(0, m.pairs, answers.data()); }) * 1e9 /
                   static_cast<double>(m.pairs));
  m.ns = median(runs);
  std::vector<double> single;
  for (std::size_t i = 0; i < m.pairs; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    method.answer(i, 1, &answers[i]);
    single.push_back(
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count());
  }
  m.ns_p99 = Summary(single).p99;
  for (std::size_t i = 0; i < m.pairs; ++i) {
    const Answer &given = answers[i], &right = truth.answers[i];
    m.hits += right.hit;
    m.missed += right.hit && !given.hit;
    m.invented += given.hit && !right.hit;
    if (!given.hit || !right.hit) continue;
    m.ulps.push_back(ulps_between(given.dt, right.dt));
    m.seconds.push_back(std::abs(given.dt - right.dt));
  }
  return m;
}

std::vector<Method> methods_for(const Family& family, const Effort& effort) {
  std::vector<Method> methods;
  for (int steps = 10; steps <= effort.max_steps; steps *= 10) methods.push_back(stepping(family, steps));
  methods.push_back(textbook_float(family));
  methods.push_back(textbook_double(family));
  methods.push_back(textbook_fma(family));
  for (double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) methods.push_back(bisection(family, tolerance));
  if (Method boost = boost_quartic(family); boost.answer) methods.push_back(std::move(boost));
  methods.push_back(exact_stage(family));
  methods.push_back(filtered_engine(family));
  return methods;
}

class Report {
 public:
  Report(const std::string& folder, const Effort& effort)
      : effort_(effort), accuracy_(folder + "/accuracy.csv"), stages_(folder + "/stages.csv") {
    accuracy_
        << "family,shape,method,parameter,pairs,hits,missed,invented,ns_median,ns_p99,ulp_median,ulp_p99,"
           "ulp_max,s_median,s_p99,s_max\n";
    stages_ << "family,pairs,chord,certified,exact,hits,at_once,double_double,exact_time,judged,complaints\n";
  }

  /// False if the exact engine has a wrong decision or a time that is not the nearest double.
  bool add(const std::string& name) {
    const Family family = make_family(name, effort_.pairs, seed);
    const Truth truth = truth_of(family, effort_.judged);
    bool right = truth.complaints == 0;
    for (const Method& method : methods_for(family, effort_)) {
      const Measured m = measure(method, truth, effort_);
      write(family, method, m);
      if (method.name == "filtered") right &= m.missed + m.invented == 0 && Summary(m.ulps).max == 0;
    }
    const StageShares s = stage_shares(family);
    stages_ << name << ',' << family.count << ',' << s.chord << ',' << s.certified << ',' << s.exact << ','
            << s.hits << ',' << s.at_once << ',' << s.double_double << ',' << s.exact_time << ','
            << truth.judged << ',' << truth.complaints << '\n';
    std::printf("%-28s %s\n", name.c_str(), right ? "exact everywhere" : "WRONG SOMEWHERE");
    std::fflush(stdout);
    return right;
  }

 private:
  void write(const Family& family, const Method& method, const Measured& m) {
    const Summary ulps(m.ulps), seconds(m.seconds);
    char line[400];
    std::snprintf(line, sizeof line, "%s,%s,%s,%s,%zu,%zu,%zu,%zu,%.1f,%.1f,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g\n",
                  family.name.c_str(), family.balls() ? "ball" : "box", method.name.c_str(),
                  method.parameter.c_str(), m.pairs, m.hits, m.missed, m.invented, m.ns, m.ns_p99,
                  ulps.median, ulps.p99, ulps.max, seconds.median, seconds.p99, seconds.max);
    accuracy_ << line;
  }

  Effort effort_;
  std::ofstream accuracy_, stages_;
};

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  using namespace foresee::bench;
  if (count < 2) {
    std::fprintf(stderr, "usage: bench_accuracy FOLDER [--quick]\n");
    return 2;
  }
  Effort effort;
  if (count > 2 && std::strcmp(arguments[2], "--quick") == 0) effort = {300, 20, 0.002, 5, 1000};
  Report report(arguments[1], effort);
  bool right = true;
  for (const std::string& name : family_names()) right &= report.add(name);
  return right ? 0 : 1;
}
