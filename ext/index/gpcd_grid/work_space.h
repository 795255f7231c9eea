// Memory that a grid computes in, kept from one query to the next.
//
//   Buffer<float> rows;
//   float* values = rows.room(count);                    // at least so many, contents undefined
//
// Fresh memory costs more than the numbers written to it: the system clears every page when it is first
// touched. A work space grows to what the largest query needed and is given back as a whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "motion/pair.h"

namespace foresee {

/// An array that only grows and never clears. T has no constructor.
template <class T>
class Buffer {
 public:
  /// Room for at least `count`; what was in it is lost if it grows. Pointers from before are then invalid.
  T* room(std::size_t count) {
    if (count > capacity_) {
      capacity_ = 0;
      values_.reset();
      values_.reset(new T[count + count / 8]);
      capacity_ = count + count / 8;
    }
    return values_.get();
  }
  T* data() { return values_.get(); }
  const T* data() const { return values_.get(); }
  std::size_t bytes() const { return capacity_ * sizeof(T); }

 private:
  std::unique_ptr<T[]> values_;
  std::size_t capacity_ = 0;
};

/// What a grid computes in. Used by one grid at a time.
struct GridSpace {
  struct Side {
    Buffer<float> rows;
    Buffer<std::uint32_t> cells;
    Buffer<std::uint64_t> keys;
    struct Lanes {
      Buffer<float> floats;
      Buffer<std::uint32_t> words;
    } inside, crossing;
  } sides[2];
  Buffer<Pair> batch;
};

}  // namespace foresee
