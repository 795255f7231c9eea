// A method that joins the moving objects of a plane, whose costs are measured apart: to build what it keeps, to
// take reports, to join.
//
//   for (const ContestantKind& kind : contestant_kinds()) {
//     const auto contestant = kind.make(objects);
//     contestant->build();
//     contestant->report(7, {x, y, vx, vy});
//     const Answer answer = contestant->join();
//   }
//
// Every contestant gives the pairs that touch during [0, h] with their first times. foresee's own and its
// tables decide exactly; the others use a textbook's contact in plain double. All but stepping find the same
// pairs of the scenes of compare.cpp.
#pragma once

#include <memory>
#include <vector>

#include "core_rivals.h"
#include "workloads.h"

namespace foresee::bench {

struct Report {
  double x, y, vx, vy;
};

class Contestant {
 public:
  /// Reads and moves `objects`, which must outlive the contestant.
  explicit Contestant(Workload& objects) : objects_(objects) {}
  virtual ~Contestant() = default;
  Contestant(const Contestant&) = delete;
  Contestant& operator=(const Contestant&) = delete;

  virtual void build() {}
  /// Reports come in one transaction.
  virtual void begin() {}
  virtual void commit() {}
  /// The position and velocity of the object of this row now.
  virtual void report(std::uint32_t row, const Report& report) { write(row, report); }
  virtual Answer join() = 0;

 protected:
  void write(std::uint32_t row, const Report& report) {
    double* const numbers = row_of(row);
    numbers[0] = report.x, numbers[1] = report.y, numbers[2] = report.vx, numbers[3] = report.vy;
  }
  double* row_of(std::uint32_t row) {
    return objects_.rows.data() + row * static_cast<std::size_t>(objects_.bodies().at.size);
  }

  Workload& objects_;
};

struct ContestantKind {
  const char* name;
  bool keeps_index;  ///< else it has nothing to build, and a report is a write into an array
  bool takes_reports = true;
  bool misses_pairs = false;
  std::unique_ptr<Contestant> (*make)(Workload& objects);
  bool (*accepts)(const Workload& objects) = [](const Workload&) { return true; };
};

/// foresee's production grid first.
std::vector<ContestantKind> contestant_kinds();

/// Its parts, one per file.
std::vector<ContestantKind> contestants_in_memory();
std::vector<ContestantKind> contestants_in_sql();
#ifdef FORESEE_SPATIALINDEX
ContestantKind spatialindex_contestant();
#endif

}  // namespace foresee::bench
