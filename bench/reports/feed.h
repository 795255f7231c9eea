// Feed of reports of moving objects: the workload by which updates are measured.
//
//   Feed feed(make_workload("S-100000"));                 // its objects at t = 0
//   load(feed.objects());
//   const Reports reports = feed.random_reports(100000);  // feed.objects() now has their values
//
// The feed's clock runs on by 1/n second with every report, so that each of the n objects reports once per
// second on average. A report is made of an object's last one, dt seconds ago, by these rules:
//
//   t      the clock
//   place  the expected one, x + v dt + a dt²/2, and on every axis up to 5 % more or less of the distance
//   speed  v of the last report, half of the time scaled by 0.8 to 1.25, else turned in the plane of x and y
//          by up to 45° either way; a is scaled or turned together with v
//
// The law of the workload decides whether a exists. An object that passes a side of the scene (the box around
// all centres at t = 0) is mirrored there, with v and a. So the density of the scene stays the same, however
// many reports follow. Sizes do not change. Seeded, and the same on every machine.
#pragma once

#include "scenes.h"
#include "workloads.h"

namespace foresee::bench {

/// Reports in the order of their t.
struct Reports {
  std::vector<std::size_t> objects;  ///< rows of the workload; the id is one more
  std::vector<double> rows;          ///< as the workload's rows

  std::size_t size() const { return objects.size(); }
};

class Feed {
 public:
  explicit Feed(const Workload& workload);

  /// As they were last reported; the layout is the workload's with times.
  const Workload& objects() const { return now_; }

  /// Of objects drawn at random, each as likely as any other.
  Reports random_reports(std::size_t count);

  /// One of every object, in random order.
  Reports reports_of_all();

 private:
  void report(std::size_t object, Reports& reports);
  void move(double* row, double dt);
  void steer(double* row);
  void mirror(double* row) const;

  Workload now_;
  Offsets at_;
  std::vector<double> lower_, upper_;  // of the scene, per axis
  std::size_t made_ = 0;               // reports; the clock is made_ / n seconds
  testing::Random random_{13};
};

}  // namespace foresee::bench
