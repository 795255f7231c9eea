// What must a store remember to go back to a savepoint? Positions in its logs; nothing is copied.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "storage/nodes/pending_objects.h"
#include "storage/nodes/undo_log.h"
#include "storage/table/object_count.h"

namespace foresee {

/// The largest id, known within a write transaction only.
struct LargestId {
  bool known = false;
  bool exact = false;  ///< else no id is larger
  std::optional<std::int64_t> id = {};
};

struct StoreSavepoint {
  int level;
  UndoLog::Handle mark;
  std::size_t map_position;
  std::shared_ptr<PendingObjects> pending;
  std::size_t pending_position;
  std::size_t changes_position;
  LargestId largest;
  ObjectCount count;
  std::uint64_t undo_position;
  std::optional<std::int64_t> own_stamp;
  std::string table;
  bool waits;  ///< something that only memory knows
};

}  // namespace foresee
