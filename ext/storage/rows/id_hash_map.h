// What is known of this id? A number for each of many ids, looked up in some nanoseconds.
//
//   map.prepare(42);             // may throw; says nothing about 42 yet
//   map.set(42, 7);              // cannot fail: the second half of a change that is all or nothing
//   map.find(42) == 7
//
// An open hash table with linear probing, never more than half full. Its hash is keyed at random, so that no
// choice of ids makes it slow. Cost: 16 bytes a slot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace foresee {

class IdHashMap {
 public:
  static constexpr std::int64_t unknown = -1;  ///< what find() says of an id that nobody set

  struct Entry {
    std::int64_t id, value;
  };

  IdHashMap();

  std::int64_t find(std::int64_t id) const noexcept;
  /// Makes room for `id`.
  void prepare(std::int64_t id);
  /// Requires: prepared since the last clear(), or value is unknown.
  void set(std::int64_t id, std::int64_t value) noexcept;
  /// All ids become unknown; those that are prepared stay so.
  void reset() noexcept;
  /// Holds no memory afterwards.
  void clear() noexcept;

  /// Ids that are prepared.
  std::size_t size() const noexcept { return size_; }
  std::size_t memory() const noexcept { return slots_.capacity() * sizeof(Entry); }
  /// Everything known, in no order.
  std::vector<Entry> known() const;

 private:
  static constexpr std::int64_t free_slot = std::numeric_limits<std::int64_t>::min();

  std::size_t place_of(std::int64_t id) const noexcept;
  void grow();

  std::vector<Entry> slots_;  // none, or a power of two; at least half of them free
  std::size_t size_ = 0;
  std::uint64_t key_;
};

}  // namespace foresee
