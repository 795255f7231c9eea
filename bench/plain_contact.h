// Contact of boxes as a textbook has it: quadratic formulas in plain double, no error bounds. What exactness
// costs is measured against this.
//
// Lean, so that the comparison is fair: one square root an axis where one is enough, the next axis only if
// the ones before leave any moment, rows of later pairs fetched ahead.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "shape/bodies.h"

namespace foresee::bench {

template <int D, int Degree>
class PlainContact {
 public:
  PlainContact(const Bodies& bodies, double h) : bodies_(bodies), h_(h) {}

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) const {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      fetch_ahead(pairs, i);
      if (first_contact(pairs[i]) >= 0) hits.push_back(pairs[i]);
    }
  }
  void first_contacts(std::span<const Pair> pairs, std::vector<Pair>& hits,
                      std::vector<double>& times) const {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      fetch_ahead(pairs, i);
      const double t = first_contact(pairs[i]);
      if (t >= 0) hits.push_back(pairs[i]), times.push_back(t);
    }
  }

 private:
  /// Disjoint moments in order: one axis leaves at most two spans of each.
  struct Spans {
    double begin[1 << D], end[1 << D];
    int count;
  };

  /// Keeps what lies in [begin, end].
  static void keep(const Spans& from, double begin, double end, Spans& kept) {
    for (int i = 0; i < from.count; ++i) {
      const double low = begin > from.begin[i] ? begin : from.begin[i];
      const double high = end < from.end[i] ? end : from.end[i];
      if (low <= high) kept.begin[kept.count] = low, kept.end[kept.count++] = high;
    }
  }

  /// |x + v t + a t^2| <= half
  static void keep_within(const Spans& from, double x, double v, double a, double half, Spans& kept) {
    if (a < 0) x = -x, v = -v, a = -a;
    if (a == 0) {
      if (v == 0) {
        if (std::abs(x) <= half) kept = from;
        return;
      }
      const double one = (-half - x) / v, other = (half - x) / v;
      return keep(from, one < other ? one : other, one < other ? other : one, kept);
    }
    const double outer = v * v - 4 * a * (x - half);
    if (outer < 0) return;
    const double scale = 0.5 / a, wide = std::sqrt(outer), inner = v * v - 4 * a * (x + half);
    if (inner <= 0) return keep(from, (-v - wide) * scale, (-v + wide) * scale, kept);
    const double narrow = std::sqrt(inner);
    keep(from, (-v - wide) * scale, (-v - narrow) * scale, kept);
    keep(from, (-v + narrow) * scale, (-v + wide) * scale, kept);
  }

  /// -1: none
  double first_contact(const Pair& pair) const {
    const double *a = bodies_.row(pair.a), *b = bodies_.row(pair.b);
    const Offsets& at = bodies_.at;
    Spans spans{{0}, {h_}, 1};
    for (int j = 0; j < D; ++j) {
      Spans kept;
      kept.count = 0;
      const double turn = Degree < 2 ? 0 : 0.5 * (b[at.a + j] - a[at.a + j]);
      keep_within(spans, b[at.x + j] - a[at.x + j], b[at.v + j] - a[at.v + j], turn,
                  a[at.half + j] + b[at.half + j], kept);
      if (kept.count == 0) return -1;
      spans = kept;
    }
    double first = spans.begin[0];
    for (int i = 1; i < spans.count; ++i) first = spans.begin[i] < first ? spans.begin[i] : first;
    return first;
  }

  void fetch_ahead(std::span<const Pair> pairs, std::size_t i) const {
    constexpr std::size_t ahead = 8, doubles_per_line = 8;
    if (i + ahead >= pairs.size()) return;
    for (const double* row : {bodies_.row(pairs[i + ahead].a), bodies_.row(pairs[i + ahead].b)}) {
      __builtin_prefetch(row);
      __builtin_prefetch(row + doubles_per_line);
    }
  }

  Bodies bodies_;
  double h_;
};

}  // namespace foresee::bench
