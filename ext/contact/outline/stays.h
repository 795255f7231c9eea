// When are polynomials certainly, and when possibly, at most 0 together? Stays: stretches of time whose ends
// are known up to rounding.
//
//   Stays stays({0, 600});                                 // all of it
//   stays.keep(inside(p, lost, 600));                      // for each polynomial p that has to be <= 0
//   stays[0].is_certain()                                  // surely not empty
//
// The two ends are enclosed apart from each other. Nothing possible is ever lost: a stay may turn out not to
// be one, and then it is not certain. Roots come from the formula that does not cancel, with error bounds.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "numbers/powers.h"

namespace foresee::contact {

struct Enclosure {
  double low, high;

  bool meets(const Enclosure& other) const { return low <= other.high && other.low <= high; }
};

/// Closed.
struct Stay {
  Enclosure begin, end;

  bool is_possible() const { return begin.low <= end.high; }
  bool is_certain() const { return begin.high <= end.low; }

  static constexpr double inf = std::numeric_limits<double>::infinity();
  static constexpr Stay always() { return {{-inf, -inf}, {inf, inf}}; }
  /// Possibly always, certainly never.
  static constexpr Stay in_doubt() { return {{-inf, inf}, {-inf, inf}}; }
};

/// When one polynomial is at most 0: in order, and apart from each other where it is certain.
struct Inside {
  std::array<Stay, 2> list;
  int count;

  static Inside never() { return {{}, 0}; }
  static Inside one(const Stay& stay) { return {{stay}, 1}; }
};

/// For 0 <= s <= length; `lost`: what underflow takes from a coefficient.
Inside inside(const Powers<Bounded, 1>& p, double lost, double length);
Inside inside(const Powers<Bounded, 2>& p, double lost, double length);

class Stays {
 public:
  /// Begins anew, with one stay.
  void begin(const Stay& stay) { list_.assign(1, stay); }
  /// What is in both.
  void keep(const Inside& other);

  bool empty() const { return list_.empty(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }

 private:
  std::vector<Stay> list_, kept_;
};

}  // namespace foresee::contact
