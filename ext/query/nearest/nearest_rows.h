// The k nearest rows found so far in a search: of objects, or of movers that are offered leg by leg.
//
//   NearestMovers best(10);
//   best.offer({7, 12.5, 600, 0});                 // a leg of object 7
//   best.offer({7, 3.25, 610, 10});                // a nearer leg: replaces it
//   while (bound <= best.reach()) …
//   const std::vector<NearestRow> rows = std::move(best).ranked();
//
// Guarantee: rows by distance, then id; of the legs of one object the nearest, of equal distances the earliest. A row
// farther than reach() changes nothing. Cost: log k per row; for movers also a look-up.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>

#include "query/nearest/nearest.h"

namespace foresee {

inline bool ranks_before(const NearestRow& a, const NearestRow& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

/// One double above the largest distance of k rows: an object whose distance rounds to that may still precede it by
/// its id.
inline double reach_beyond(double distance) {
  return std::nextafter(distance, std::numeric_limits<double>::infinity());
}

/// Each object is offered once.
class NearestObjects {
 public:
  explicit NearestObjects(std::int64_t k) : k_(static_cast<std::uint64_t>(k)) {}

  void offer(const NearestRow& row) {
    if (rows_.size() == k_) {
      if (!ranks_before(row, rows_.front())) return;
      std::pop_heap(rows_.begin(), rows_.end(), ranks_before);
      rows_.pop_back();
    }
    rows_.push_back(row);
    std::push_heap(rows_.begin(), rows_.end(), ranks_before);
  }

  double reach() const {
    return rows_.size() == k_ ? reach_beyond(rows_.front().distance)
                              : std::numeric_limits<double>::infinity();
  }

  std::vector<NearestRow> ranked() && {
    std::sort_heap(rows_.begin(), rows_.end(), ranks_before);
    return std::move(rows_);
  }

 private:
  std::uint64_t k_;
  std::vector<NearestRow> rows_;  ///< a heap with the last row on top
};

/// An object may be offered often.
class NearestMovers {
 public:
  explicit NearestMovers(std::int64_t k) : k_(static_cast<std::uint64_t>(k)) {}

  void offer(const NearestRow& row) {
    const auto known = by_id_.find(row.id);
    if (known != by_id_.end()) {
      const NearestRow& before = *known->second;
      if (row.distance > before.distance || (row.distance == before.distance && row.t >= before.t)) return;
      rows_.erase(known->second);
      known->second = rows_.insert(row).first;
      return;
    }
    if (rows_.size() == k_) {
      const auto last = std::prev(rows_.end());
      if (!ranks_before(row, *last)) return;
      by_id_.erase(last->id);
      rows_.erase(last);
    }
    by_id_.emplace(row.id, rows_.insert(row).first);
  }

  double reach() const {
    return rows_.size() == k_ ? reach_beyond(std::prev(rows_.end())->distance)
                              : std::numeric_limits<double>::infinity();
  }

  std::vector<NearestRow> ranked() && { return {rows_.begin(), rows_.end()}; }

 private:
  struct RanksBefore {
    bool operator()(const NearestRow& a, const NearestRow& b) const { return ranks_before(a, b); }
  };
  using Rows = std::set<NearestRow, RanksBefore>;

  std::uint64_t k_;
  Rows rows_;
  std::unordered_map<std::int64_t, Rows::iterator> by_id_;
};

}  // namespace foresee
