// Reusable memory of a grid, kept from one query to the next.
//
//   Buffer<float> rows;
//   float* values = rows.room(count);                    // at least so many, contents undefined
//
// New memory costs more than writing the numbers: the operating system clears every page at its first access.
// A work space grows to the need of the largest query; trim() frees what the last query did not need.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "base/pair.h"

namespace foresee {

/// An array that grows on demand and is never cleared. T has no constructor.
template <class T>
class Buffer {
 public:
  /// Memory for at least `count` values. If the buffer grows, its contents are lost and earlier pointers are
  /// invalid.
  T* room(std::size_t count) {
    largest_request_ = std::max(largest_request_, count);
    if (count > capacity_) {
      capacity_ = 0;
      values_.reset();
      values_.reset(new T[count + count / 8]);
      capacity_ = count + count / 8;
    }
    return values_.get();
  }
  /// room() that keeps the first `used` values.
  T* grown(std::size_t count, std::size_t used) {
    largest_request_ = std::max(largest_request_, count);
    if (count > capacity_) {
      std::unique_ptr<T[]> larger(new T[count + count / 2]);
      std::copy_n(values_.get(), used, larger.get());
      values_ = std::move(larger);
      capacity_ = count + count / 2;
    }
    return values_.get();
  }
  /// Frees the memory if no request since the last trim() needed a quarter of it.
  void trim() {
    constexpr std::size_t not_worth_it = 1 << 16;
    if (bytes() > not_worth_it && capacity_ / 4 > largest_request_) {
      capacity_ = 0;
      values_.reset();
    }
    largest_request_ = 0;
  }
  std::size_t bytes() const { return capacity_ * sizeof(T); }

 private:
  std::unique_ptr<T[]> values_;
  std::size_t capacity_ = 0;
  std::size_t largest_request_ = 0;  // since the last trim()
};

/// All memory of a grid. One grid at a time uses it.
struct GridSpace {
  /// The entries that one thread has collected from one side.
  struct Part {
    Buffer<std::uint64_t> keys;
    Buffer<std::uint32_t> stripes, counts;
  };

  /// The objects of one side.
  struct Side {
    Buffer<float> rows;
    Buffer<std::uint32_t> stripes;
    Buffer<std::uint64_t> keys;
    std::vector<Part> parts;
  } sides[2];

  /// The memory with which one thread visits stripes.
  struct Visit {
    struct LaneMemory {
      Buffer<float> floats, reach;
      Buffer<std::uint32_t> words, buckets, kinds;
      Buffer<std::uint64_t> keys;
    } inside[2], crossing[2];
    Buffer<Pair> batch;
  };

  /// A pool of such memory, for one thread or several.
  class Visits {
   public:
    class Taken {
     public:
      explicit Taken(Visits& visits) : visits_(visits), visit_(visits.take()) {}
      ~Taken() { visits_.put_back(std::move(visit_)); }
      Taken(const Taken&) = delete;
      Taken& operator=(const Taken&) = delete;
      Visit& operator*() const { return *visit_; }

     private:
      Visits& visits_;
      std::unique_ptr<Visit> visit_;
    };

    /// Requires: no thread has taken any.
    template <class Work>
    void for_each(Work work) {
      for (const auto& visit : unused_) work(*visit);
    }

   private:
    std::unique_ptr<Visit> take() {
      const std::lock_guard lock(mutex_);
      if (unused_.empty()) {
        unused_.reserve(++made_);  // so that put_back() never allocates
        return std::make_unique<Visit>();
      }
      std::unique_ptr<Visit> visit = std::move(unused_.back());
      unused_.pop_back();
      return visit;
    }
    void put_back(std::unique_ptr<Visit> visit) {
      const std::lock_guard lock(mutex_);
      unused_.push_back(std::move(visit));
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<Visit>> unused_;
    std::size_t made_ = 0;
  } visits;

  /// Called after each query: the space is at most a few times as large as the last query needed.
  void trim() {
    for_each([](auto& buffer) { buffer.trim(); });
  }
  std::size_t bytes() {
    std::size_t sum = 0;
    for_each([&sum](auto& buffer) { sum += buffer.bytes(); });
    return sum;
  }

 private:
  template <class Work>
  static void for_each(Visit::LaneMemory& lanes, Work work) {
    work(lanes.floats);
    work(lanes.reach);
    work(lanes.words);
    work(lanes.buckets);
    work(lanes.kinds);
    work(lanes.keys);
  }
  template <class Work>
  static void for_each(Visit& visit, Work work) {
    for (int i = 0; i < 2; ++i)
      for (Visit::LaneMemory* lanes : {&visit.inside[i], &visit.crossing[i]}) for_each(*lanes, work);
    work(visit.batch);
  }
  template <class Work>
  void for_each(Work work) {
    for (Side& side : sides) {
      work(side.rows);
      work(side.stripes);
      work(side.keys);
      for (Part& part : side.parts) {
        work(part.keys);
        work(part.stripes);
        work(part.counts);
      }
    }
    visits.for_each([&work](Visit& other) { for_each(other, work); });
  }
};

}  // namespace foresee
