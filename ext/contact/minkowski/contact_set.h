// The contact set of a pair of shapes as data: the relative positions at which two objects touch, as a union
// of pieces, each an intersection of primitives.
//
//   ContactSet set;                                        // two discs
//   const int radius = set.sum(set.in_both(at_a.r, at_b.r), set.given(within));
//   const AxisPart centre[] = {{.axis = 0}, {.axis = 1}};
//   set.add_piece({.all = {set.ball(centre, {radius})}});
//
// A set is made once per statement, from the distance of two tables: contact_set(setup). It contains no number of any
// pair: it names the lengths of a pair by their source, and the primitives and pieces. Each stage of contact
// computes the lengths in its own number type (AllLengths, PairLengths) and the polynomials of the primitives
// (primitive.h). So primitive number i is the same in all stages. The number of primitives and pieces is not
// limited.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/constraint/constraint.h"
#include "contact/minkowski/primitive.h"
#include "shape/row_layout.h"

namespace foresee {

struct Setup;  // contact/setup.h

/// The formula of a length of a pair: one addition, or two products and their sum.
struct Length {
  enum class From : std::uint8_t {
    both_rows,  ///< the numbers of the rows at places a and b, added; an absent one is 0
    growth,     ///< the same, each times the time from its row's t to `number`
    given,      ///< a number that is the same for every pair
    sum,        ///< of the lengths a and b
    difference  ///< of the lengths a and b
  };
  From from;
  int a = no_length, b = no_length;
  double number = 0;
  bool varies = true;                    ///< from pair to pair
  int t_a = no_length, t_b = no_length;  ///< of growth: the places of t; an absent t is 0
};

/// Both faces of a box across one axis: -x <= below and x <= above, if they exist.
struct Faces {
  int axis;
  Size below = {}, above = {};
  bool has_below = true, has_above = true;
};

/// A union of pieces; see the head of this file.
class ContactSet : public ConstraintUnion {
 public:
  /// The whole set, for kernels.
  struct Arrays {
    const Length* lengths;
    int length_count;
    const Primitive* primitives;
    int primitive_count;
    const Piece* pieces;
    int piece_count;
    const int* members;
    const Faces* hull;
    int hull_count;
  };

  // Lengths; each function returns the number of a length, or no_length if it is 0 for every pair.

  /// The numbers of both rows, added.
  int in_both(int place_a, int place_b) {
    if (place_a == Offsets::absent && place_b == Offsets::absent) return no_length;
    return add({Length::From::both_rows, place_a, place_b});
  }
  /// The growth of both until `time`; t_a and t_b are the places of t in the rows.
  int growth(int place_a, int place_b, int t_a, int t_b, double time) {
    if (place_a == Offsets::absent && place_b == Offsets::absent) return no_length;
    return add({Length::From::growth, place_a, place_b, time, true, t_a, t_b});
  }
  /// A number that is the same for every pair.
  int given(double number) {
    if (number == 0) return no_length;
    return add({Length::From::given, no_length, no_length, number, false});
  }
  int sum(int a, int b) {
    if (a == no_length || b == no_length) return a == no_length ? b : a;
    return add({Length::From::sum, a, b, 0, varies(a) || varies(b)});
  }
  int difference(int a, int b) {
    if (b == no_length) return a;
    return add({Length::From::difference, a, b, 0, varies(a) || varies(b)});
  }

  /// The sum of two sizes.
  Size sum(const Size& a, const Size& b) { return {sum(a.value, b.value), sum(a.rate, b.rate)}; }

  // Primitives; each function returns the number of a primitive. Pieces may share primitives.

  /// The half space in which sign x <= size on one axis.
  int bound(int axis, int sign, const Size& size);
  int ball(std::span<const AxisPart> centre, const Size& radius);

  /// Adds to the hull two faces, between which all pieces are at all times: for the filter (chord.h).
  void enclose(const Faces& faces) { hull_.push_back(faces); }

  std::span<const Length> lengths() const { return lengths_; }
  std::span<const int> varying() const { return varying_; }  ///< the lengths that vary from pair to pair
  std::span<const Primitive> primitives() const { return primitives_; }
  std::span<const Faces> hull() const { return hull_; }
  /// The highest power of time in the sizes.
  int degree() const;
  Arrays arrays() const;

 private:
  bool varies(int length) const {
    return length != no_length && lengths_[static_cast<std::size_t>(length)].varies;
  }
  int add(const Length& length);
  int add(const Primitive& primitive);

  std::vector<Length> lengths_;
  std::vector<int> varying_;
  std::vector<Primitive> primitives_;
  std::vector<Faces> hull_;
};

/// The contact set of the setup (contact/setup.h): between its tables, or between its window and the second
/// table. Requires: neither has outlines or meshes.
ContactSet contact_set(const Setup& setup);

template <class T>
T length_of(const ContactSet& set, const double* row_a, const double* row_b, int number);

/// The lengths of one pair, each computed at every access.
template <class T>
struct PairLengths {
  const ContactSet& set;
  const double *row_a, *row_b;

  T operator[](int number) const { return length_of<T>(set, row_a, row_b, number); }
};

/// The two rows of a pair; an absent number is 0.
template <class T>
struct TwoRows {
  const double *a, *b;

  T in_both(int place_a, int place_b) const {
    return Exactly<T>::number(value_or(a, place_a, 0)) + Exactly<T>::number(value_or(b, place_b, 0));
  }
  T growth(const Length& length) const {
    return growth_in(a, length.a, length.t_a, length.number) +
           growth_in(b, length.b, length.t_b, length.number);
  }

 private:
  static T growth_in(const double* row, int place, int t, double time) {
    if (place == Offsets::absent) return T{};
    return Exactly<T>::difference_of(time, value_or(row, t, 0)) * Exactly<T>::number(row[place]);
  }
};

/// The value of a length that is not given, from `known`, the lengths before it, and `rows`, for example
/// TwoRows.
template <class T, class Lengths, class Rows>
T varying_length(const Length& length, const Lengths& known, const Rows& rows) {
  switch (length.from) {
    case Length::From::both_rows:
      return rows.in_both(length.a, length.b);
    case Length::From::growth:
      return rows.growth(length);
    case Length::From::sum:
      return known[length.a] + known[length.b];
    default:
      return length_at<T>(known, length.a) - known[length.b];
  }
}

/// The value of one length of a pair.
template <class T>
T length_of(const ContactSet& set, const double* row_a, const double* row_b, int number) {
  const Length& length = set.lengths()[static_cast<std::size_t>(number)];
  if (length.from == Length::From::given) return Exactly<T>::number(length.number);
  return varying_length<T>(length, PairLengths<T>{set, row_a, row_b}, TwoRows<T>{row_a, row_b});
}

/// All lengths of one pair after another, by number. Lengths that are the same for all pairs are computed
/// once.
template <class T>
class AllLengths {
 public:
  explicit AllLengths(const ContactSet& set) : lengths_(set.lengths().size()) {
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      if (!set.lengths()[i].varies) lengths_[i] = length_of<T>(set, nullptr, nullptr, static_cast<int>(i));
  }

  /// Computes the lengths of this pair.
  void compute(const ContactSet& set, const double* row_a, const double* row_b) {
    T* const out = lengths_.data();
    const TwoRows<T> rows{row_a, row_b};
    for (const int i : set.varying())
      out[i] = varying_length<T>(set.lengths()[static_cast<std::size_t>(i)], out, rows);
  }

  const T& operator[](int number) const { return lengths_[static_cast<std::size_t>(number)]; }
  const T* data() const { return lengths_.data(); }

 private:
  std::vector<T> lengths_;
};

}  // namespace foresee
