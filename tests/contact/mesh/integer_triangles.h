// Two triangles in whole numbers: when do they meet while one flies past the other, and how far are they from
// each other? Each of corner on triangle and edge on edge by Cramer's rule.
//
// A triangle may be an edge or a point, with corners that are equal: its edges speak for it.
#pragma once

#include <array>
#include <optional>

#include "contact/sturm.h"

namespace foresee::oracle {

struct Arrow {
  Whole x, y, z;

  friend bool operator==(const Arrow&, const Arrow&) = default;
};
Arrow operator+(const Arrow& a, const Arrow& b);
Arrow operator-(const Arrow& a, const Arrow& b);
Arrow operator*(const Whole& factor, const Arrow& a);
Arrow cross(const Arrow& a, const Arrow& b);
Whole dot(const Arrow& a, const Arrow& b);

/// A triangle. A place as seen from it, gap from its first corner, is u e1 + w e2 + h normal with e1 and e2
/// to its other corners; u, w and h all times the square of the normal are products with gap.
struct Facet {
  std::array<Arrow, 3> corners;
  std::array<Arrow, 3> edges;  ///< from each corner to the next
  Arrow normal;
  Arrow to_u, to_w;
  Whole squared;  ///< of the normal; 0: a line or a point

  explicit Facet(const std::array<Arrow, 3>& corners);
};

/// Is the other wholly above its plane (1), wholly below (2), or neither (0)? By more than a distance whose
/// square this is.
unsigned side_of(const Facet& plane, const Facet& other, const Whole& squared);

/// above / below, not reduced; below is positive.
struct Fraction {
  Whole above, below;

  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.above * b.below < b.above * a.below;
  }
};

/// Closed.
struct Span {
  Fraction begin, end;
};

/// When, of `queried`, is a corner that flies past the triangle on it? Never where the triangle has no area.
std::optional<Span> corner_meets(const Arrow& corner, const Arrow& velocity, const Facet& facet,
                                 Span queried);

/// When, of `queried`, does the edge from p along e meet that from q along f, which flies by?
std::optional<Span> edge_meets(const Arrow& p, const Arrow& e, const Arrow& q, const Arrow& f,
                               const Arrow& velocity, Span queried);

/// The times of `queried` at which a corner of one triangle is on the other, or their edges meet: from the
/// first to the last of all. b flies past a.
std::optional<Span> features_meet(const Facet& a, const Facet& b, const Arrow& velocity, const Span& queried);

/// Both at rest.
bool touch(const Facet& a, const Facet& b);

/// Both at rest, and apart: whether by a distance whose square is no greater.
bool are_near(const Facet& a, const Facet& b, const Whole& squared);

/// How often does a ray from a corner cross the triangle? None: it meets an edge or runs along the triangle,
/// so that another ray must decide. Requires: the corner is not on the triangle.
std::optional<int> crossings(const Arrow& corner, const Arrow& ray, const Facet& facet);

}  // namespace foresee::oracle
