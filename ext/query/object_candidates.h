// Stage one of a window: which objects are worth a look, from a scene or from a tree.
#pragma once

#include <memory>
#include <vector>

#include "contact/window_contact.h"
#include "motion/error.h"
#include "query/searched.h"

namespace foresee {

class ObjectCandidates {
 public:
  virtual ~ObjectCandidates() = default;

  /// Where the rows of a batch are found: the same place for all batches.
  virtual const Bodies& bodies() const = 0;

  /// Replaces `rows` by the next row numbers, some hundreds at most; false once there are none left.
  virtual bool next(std::vector<std::uint32_t>& rows) = 0;

  /// Of a row of the latest batch.
  virtual std::int64_t id(std::uint32_t row) const = 0;
};

/// Every object that can touch the window during the horizon, once, and others.
std::unique_ptr<ObjectCandidates> window_candidates(const Searched& objects, const WindowFaces& faces,
                                                    const Horizon& horizon, Interrupt& interrupt);

}  // namespace foresee
