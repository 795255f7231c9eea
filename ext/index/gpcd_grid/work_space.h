// Memory that a grid computes in, kept from one query to the next.
//
//   Buffer<float> rows;
//   float* values = rows.room(count);                    // at least so many, contents undefined
//
// Fresh memory costs more than the numbers written to it: the system clears every page when it is first
// touched. A work space grows to what the largest query needed; trim() gives back what the last one had no
// use for.
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

/// An array that grows as needed and never clears. T has no constructor.
template <class T>
class Buffer {
 public:
  /// Room for at least `count`; what was in it is lost if it grows. Pointers from before are then invalid.
  T* room(std::size_t count) {
    most_ = std::max(most_, count);
    if (count > capacity_) {
      capacity_ = 0;
      values_.reset();
      values_.reset(new T[count + count / 8]);
      capacity_ = count + count / 8;
    }
    return values_.get();
  }
  /// The same, but the first `used` values stay.
  T* grown(std::size_t count, std::size_t used) {
    most_ = std::max(most_, count);
    if (count > capacity_) {
      std::unique_ptr<T[]> larger(new T[count + count / 2]);
      std::copy_n(values_.get(), used, larger.get());
      values_ = std::move(larger);
      capacity_ = count + count / 2;
    }
    return values_.get();
  }
  /// Gives the memory back if nobody has asked for a quarter of it since the last trim().
  void trim() {
    constexpr std::size_t not_worth_it = 1 << 16;
    if (bytes() > not_worth_it && capacity_ / 4 > most_) {
      capacity_ = 0;
      values_.reset();
    }
    most_ = 0;
  }
  std::size_t bytes() const { return capacity_ * sizeof(T); }

 private:
  std::unique_ptr<T[]> values_;
  std::size_t capacity_ = 0;
  std::size_t most_ = 0;  // asked for since the last trim()
};

/// What a grid computes in. Used by one grid at a time.
struct GridSpace {
  /// What one thread has read of one side.
  struct Part {
    Buffer<std::uint64_t> keys;
    Buffer<std::uint32_t> stripes, counts;
  };

  /// What is kept of the objects of one side.
  struct Side {
    Buffer<float> rows;
    Buffer<std::uint32_t> stripes;
    Buffer<std::uint64_t> keys;
    std::vector<Part> parts;
  } sides[2];

  /// What one thread needs to visit stripes.
  struct Visit {
    struct Lanes {
      Buffer<float> floats, reach;
      Buffer<std::uint32_t> words, buckets;
      Buffer<std::uint64_t> keys;
    } inside[2], crossing[2];
    Buffer<Pair> batch;
  } visit;

  /// The same for several threads, which take and return it.
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

    /// Where nobody has taken any.
    template <class Work>
    void for_each(Work work) {
      for (const auto& visit : unused_) work(*visit);
    }

   private:
    std::unique_ptr<Visit> take() {
      const std::lock_guard lock(mutex_);
      if (unused_.empty()) {
        unused_.reserve(++made_);  // there is always a place to put it back
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

  /// After each query: the space stays at most some times as large as the last one needed.
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
  static void for_each(Visit& visit, Work work) {
    for (int i = 0; i < 2; ++i)
      for (Visit::Lanes* lanes : {&visit.inside[i], &visit.crossing[i]})
        work(lanes->floats), work(lanes->reach), work(lanes->words), work(lanes->buckets), work(lanes->keys);
    work(visit.batch);
  }
  template <class Work>
  void for_each(Work work) {
    for (Side& side : sides) {
      work(side.rows), work(side.stripes), work(side.keys);
      for (Part& part : side.parts) work(part.keys), work(part.stripes), work(part.counts);
    }
    for_each(visit, work);
    visits.for_each([&work](Visit& other) { for_each(other, work); });
  }
};

}  // namespace foresee
