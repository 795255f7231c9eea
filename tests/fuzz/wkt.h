// Shared by the fuzzers of outlines and meshes: coordinates, corrupted texts, and checks of turned shapes.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/number_text.h"
#include "bytes.h"

namespace foresee::testing {

inline void require(bool holds, const char* what, const std::string& text) {
  if (holds) return;
  std::fprintf(stderr, "%s: %s\n", what, text.c_str());
  std::abort();
}

/// A coordinate on a small grid, an ulp beside it, or of any size.
inline std::string fuzz_coordinate(FuzzBytes& bytes) {
  switch (bytes.in_range(0, 9)) {
    case 0: {
      const auto bits = bytes.any<std::uint64_t>();
      double any;
      std::memcpy(&any, &bits, sizeof any);
      return shown(any);
    }
    case 1: {
      const int exponent = bytes.in_range(-300, 200);
      return shown(std::ldexp(bytes.in_range(-9, 9), exponent));
    }
    case 2: {
      const double whole = bytes.in_range(0, 5);
      return shown(std::nextafter(whole, bytes.flag() ? 9 : -9));
    }
    default:
      return std::to_string(bytes.in_range(0, 5));
  }
}

/// A few characters changed, cut out or doubled.
inline void spoil(std::string& text, FuzzBytes& bytes) {
  for (int n = bytes.in_range(1, 4); n > 0 && !text.empty(); --n) {
    const std::size_t at = bytes.in_range<std::size_t>(0, text.size() - 1), length = bytes.in_range(0, 8);
    const int kind = bytes.in_range(0, 3);
    if (kind == 0) text[at] = static_cast<char>(bytes.any<std::uint8_t>());
    if (kind == 1) text[at] = "()., -+e19nP"[bytes.in_range(0, 11)];
    if (kind == 2) text.erase(at, length);
    if (kind == 3) text.insert(at, text.substr(at, length));
  }
}

}  // namespace foresee::testing
