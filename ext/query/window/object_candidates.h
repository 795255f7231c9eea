// Stage one of a window: which objects are worth a look, from a scene or from a tree, and which of them need
// none.
#pragma once

#include <memory>
#include <vector>

#include "base/error.h"
#include "contact/window_contact.h"
#include "query/searched.h"

namespace foresee {

/// Row numbers, some hundreds at most.
struct CandidateBatch {
  std::vector<std::uint32_t> doubtful;  ///< contact decides
  std::vector<std::uint32_t> inside;    ///< exist at `now` and touch the window then

  bool empty() const { return doubtful.empty() && inside.empty(); }
  void clear() { doubtful.clear(), inside.clear(); }
};

class ObjectCandidates {
 public:
  virtual ~ObjectCandidates() = default;

  /// Where the rows of a batch are found: the same place for all batches.
  virtual const Bodies& bodies() const = 0;

  /// Replaces `batch` by the next one; false once there are no candidates left.
  virtual bool next(CandidateBatch& batch) = 0;

  /// Of a row of the latest batch.
  virtual std::int64_t id(std::uint32_t row) const = 0;
};

/// Every object that can touch the window during the horizon, once, and others. `is_zone`: what is between
/// the faces need not be in the window, which is a zone that they enclose.
std::unique_ptr<ObjectCandidates> window_candidates(const Searched& objects, const WindowFaces& faces,
                                                    bool is_zone, const Horizon& horizon,
                                                    Interrupt& interrupt);

}  // namespace foresee
