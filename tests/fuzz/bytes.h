// Whole numbers from a fuzzer's bytes, taken from the front one after another.
//
//   FuzzBytes bytes({data, size});
//   const int kind = bytes.in_range(0, 3);
//
// After the last byte every number is the smallest of its range. Like libFuzzer's own provider, but for every
// compiler.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace foresee::testing {

class FuzzBytes {
 public:
  explicit FuzzBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }

  bool flag() { return (next() & 1) != 0; }

  /// A number of the closed range. Takes as many bytes as the range needs.
  template <class T>
  T in_range(T min, T max) {
    const std::uint64_t range = static_cast<std::uint64_t>(max) - static_cast<std::uint64_t>(min);
    std::uint64_t drawn = 0;
    for (std::uint64_t rest = range; rest > 0 && left() > 0; rest >>= 8) drawn = drawn << 8 | next();
    if (range != UINT64_MAX) drawn %= range + 1;
    return static_cast<T>(static_cast<std::uint64_t>(min) + drawn);
  }

  template <class T>
  T any() {
    using Bits = std::make_unsigned_t<T>;
    Bits bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) bits = static_cast<Bits>(std::uint64_t{bits} << 8 | next());
    return static_cast<T>(bits);
  }

 private:
  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return first;
  }

  std::span<const std::uint8_t> bytes_;
};

}  // namespace foresee::testing
