// In which leaf is this object, probably, and where in it?
//
//   hints.reserve(200000);                    // so many places, roughly: two an id
//   hints.learn(leaf.keys, 7);                // the objects of leaf 7
//   const LeafHints::Hint hint = hints.find(42);
//   if (hint.leaf != 0) hint.slot_in(leaf.keys, 42)     // looks there first
//
// The stored map answers this for certain, by a look into a table of the database: a microsecond or two. A
// hint costs some nanoseconds and need not be true, so whoever asks looks into that leaf. Fibonacci hashing
// (Knuth, The Art of Computer Programming 3, 6.4): while half of the places are free, ids that count up, as
// most do, share none; of others that do, the last one stays. Cost: 4 bytes a place: 24 bits of the leaf's
// number, so that leaves with larger ones have no hints, and the last 8 of the slot.
//
// Nobody waits while a large table doubles: it is made of parts, by the hash, which double one after another,
// a few with every reserve(), so that meanwhile some have twice the size of the others (linear hashing, W.
// Litwin, VLDB 1980, by parts). No call adds more than 128 kB.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace foresee {

class LeafHints {
 public:
  struct Hint {
    std::int64_t leaf = 0;  ///< 0: nothing is known
    std::size_t slot = 0;   ///< the remainder by `slots`

    /// Where `id` is among the ids of the leaf; their number if it is not there.
    std::size_t slot_in(std::span<const std::int64_t> ids, std::int64_t id) const {
      for (std::size_t i = slot; i < ids.size(); i += slots)
        if (ids[i] == id) return i;
      return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
    }
  };

  /// Nobody has asked yet: there is nothing to learn for.
  bool empty() const { return places_ == 0; }
  std::size_t places() const { return places_; }

  /// Grows, by a step, towards so many places.
  void reserve(std::size_t places) {
    if (empty()) make_parts();
    const std::size_t wanted = std::min(std::bit_ceil(places), max_places);
    for (std::size_t added = 0; places_ < wanted && (added == 0 || added + parts_[next_].size() <= step);)
      added += double_next_part();
  }

  /// Requires: reserved.
  void learn(std::int64_t id, std::int64_t leaf, std::size_t slot = 0) {
    if (leaf >= leaves) return;
    const Place place = place_of(id);
    parts_[place.part][place.at] =
        static_cast<std::uint32_t>(static_cast<std::size_t>(leaf) * slots + slot % slots);
  }
  void learn(std::span<const std::int64_t> ids, std::int64_t leaf) {
    for (std::size_t i = 0; i < ids.size(); ++i) learn(ids[i], leaf, i);
  }

  Hint find(std::int64_t id) const {
    if (empty()) return {};
    const Place place = place_of(id);
    const std::uint32_t hint = parts_[place.part][place.at];
    return {hint / slots, hint % slots};
  }

  void clear() noexcept { *this = {}; }

 private:
  static constexpr std::size_t max_places = 1 << 22;
  static constexpr std::uint32_t slots = 1 << 8;
  static constexpr std::size_t line = 16;  ///< hints that the processor fetches together
  static constexpr std::int64_t leaves = 1 << 24;
  static constexpr int part_bits = 6;
  static constexpr std::size_t step = max_places >> part_bits >> 1;  ///< the largest part there is to double

  using Part = std::vector<std::uint32_t>;  ///< a power of two, in lines

  struct Place {
    std::size_t part, at;
  };
  /// A part by the first bits of the hash of the id's upper digits, a line by the next ones; in it a place by
  /// the last digit, which the hash turns round, for ids that all end in the same one.
  Place place_of(std::int64_t id) const {
    const std::uint64_t hash = (static_cast<std::uint64_t>(id) / line) * 0x9e3779b97f4a7c15;
    const std::size_t part = hash >> (64 - part_bits);
    const std::size_t at = (hash << part_bits >> 1) >> (63 - std::countr_zero(parts_[part].size() / line));
    const std::uint64_t in_line = (static_cast<std::uint64_t>(id) + hash / (std::uint64_t{1} << 32)) % line;
    return {part, at * line + static_cast<std::size_t>(in_line)};
  }

  void make_parts() {
    for (Part& part : parts_) part.assign(line, 0);
    places_ = parts_.size() * line;
  }

  /// An id's line becomes either of two. Returns how many places that adds.
  std::size_t double_next_part() {
    Part& part = parts_[next_];
    Part doubled(2 * part.size());
    for (std::size_t i = 0; i < doubled.size(); ++i) doubled[i] = part[i / (2 * line) * line + i % line];
    part.swap(doubled);
    next_ = (next_ + 1) % parts_.size();
    places_ += doubled.size();
    return doubled.size();
  }

  std::array<Part, 1 << part_bits> parts_;
  std::size_t places_ = 0;
  std::size_t next_ = 0;  ///< the part that doubles next; those before it have
};

}  // namespace foresee
