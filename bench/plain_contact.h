// Textbook contact test: formulas in plain double without error bounds, the reference for the cost of
// exactness.
//
//   auto contact = make_plain_contact(workload);
//   contact->first_contacts(candidates, hits, times);
//
// Boxes, discs, balls, upright cylinders and boxes with discs (plain_shapes.h). Optimized, so that the
// comparison is fair: the shapes are selected once, and rows of later pairs are prefetched.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "workloads.h"

namespace foresee::bench {

class PlainContact {
 public:
  virtual ~PlainContact() = default;

  /// Appends to `hits` those of `pairs` that touch.
  virtual void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) const = 0;
  /// The same, and appends the first time of contact of each hit to `times`.
  virtual void first_contacts(std::span<const Pair> pairs, std::vector<Pair>& hits,
                              std::vector<double>& times) const = 0;
};

/// Between the workload's two sides. Throws Error for shapes that are not in the list above. The workload
/// must outlive the contact.
std::unique_ptr<PlainContact> make_plain_contact(const Workload& workload);

}  // namespace foresee::bench
