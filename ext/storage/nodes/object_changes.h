// Which objects has this transaction changed, and what were they before?
//
//   if (!changes.knows(42)) changes.add(42, record);     // about to change for the first time; {}: it is new
//   changes.for_each([&](std::int64_t id, std::span<const double> before) { … });
//   const auto position = changes.position();            // … and back to it: changes.rewind(position)
//
// The first change of an object keeps its record, later ones nothing: what it is now the store knows. Going
// back to a savepoint forgets the objects that had not been changed before it. Cost: a look-up for each
// change, and some 40 bytes and the record for each object changed.
#pragma once

#include <span>

#include "storage/rows/id_hash_map.h"

namespace foresee {

class ObjectChanges {
 public:
  bool knows(std::int64_t id) const noexcept { return known_.find(id) != IdHashMap::unknown; }
  /// Requires: not known. `before`: the object's record, empty if there was none. All or nothing.
  void add(std::int64_t id, std::span<const double> before);

  std::size_t count() const { return firsts_.size(); }
  std::size_t memory() const;
  /// Calls each(id, before) for every object in the order of their first changes.
  template <class Each>
  void for_each(Each each) const {
    std::size_t begin = 0;
    for (const First& first : firsts_) {
      each(first.id, std::span<const double>(records_.data() + begin, first.end - begin));
      begin = first.end;
    }
  }

  std::size_t position() const { return firsts_.size(); }
  void rewind(std::size_t position) noexcept;
  void clear() noexcept;

 private:
  struct First {
    std::int64_t id;
    std::size_t end;  ///< of its record in records_, which begins where the one before ends
  };

  std::vector<First> firsts_;
  std::vector<double> records_;
  IdHashMap known_;
};

}  // namespace foresee
