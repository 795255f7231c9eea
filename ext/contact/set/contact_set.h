// When does a pair touch? Its contact set as data: a union of pieces, in each of which all of some primitives
// hold.
//
//   ContactSet set;                                        // two discs
//   const int radius = set.sum(set.in_both(at_a.r, at_b.r), set.given(within));
//   const AxisPart centre[] = {{.axis = 0}, {.axis = 1}};
//   set.add_piece({.all = {set.ball(centre, {radius})}});
//
// A set is made once a statement, by the pair of shapes (shape_pairs.h). It names where a pair's lengths come
// from and which primitives and pieces there are, and holds no number of any pair: each stage of contact
// computes the lengths in its own number type (AllLengths, PairLengths) and asks the primitives for their
// polynomials (primitive.h). So primitive number i is the same in all of them. There may be any number of
// primitives and pieces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/set/primitive.h"
#include "shape/layout.h"

namespace foresee {

/// A length of a pair: one addition, or two products and their sum.
struct Length {
  enum class From : std::uint8_t {
    both_rows,  ///< what the rows have at places a and b; what a row does not have is 0
    growth,     ///< what the rows have at places a and b, each times the time from its row's t to `number`
    given,      ///< a number that is the same for every pair
    sum,        ///< of the lengths a and b
    difference  ///< of the lengths a and b
  };
  From from;
  int a = no_length, b = no_length;
  double number = 0;
  bool varies = true;                    ///< from pair to pair
  int t_a = no_length, t_b = no_length;  ///< of growth: the places of t, which is 0 where there is none
};

/// One piece: where the primitives `all` are at most 0. Two lists change no piece and save work: where the
/// piece holds, those `around` it hold too; and of the union nothing is lost if `beyond` must be at least 0,
/// as elsewhere another piece covers this one. `ball` is a ball or strip, one of `all` that no other piece
/// has: its roots are costly, so the exact stage looks for them last, and only when the rest holds.
struct Conditions {
  std::vector<int> all, around = {}, beyond = {};
  int ball = -1;  ///< -1: none
};

/// Both faces of a box across one axis: -x <= below and x <= above, if they are there.
struct Faces {
  int axis;
  Size below = {}, above = {};
  bool has_below = true, has_above = true;
};

class ContactSet {
 public:
  /// Some of the list of members.
  struct Part {
    std::uint32_t begin, end;
  };
  struct Piece {
    Part all, around, beyond;
    int ball;
  };

  /// All of it, for kernels.
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

  // Lengths; each function gives a length's number, or no_length for what is 0 in every pair.
  int in_both(int place_a, int place_b) {
    if (place_a == Offsets::absent && place_b == Offsets::absent) return no_length;
    return add({Length::From::both_rows, place_a, place_b});
  }
  /// What has grown by `time`; t_a and t_b are where the rows have their t.
  int growth(int place_a, int place_b, int t_a, int t_b, double time) {
    if (place_a == Offsets::absent && place_b == Offsets::absent) return no_length;
    return add({Length::From::growth, place_a, place_b, time, true, t_a, t_b});
  }
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

  /// Of two sizes.
  Size sum(const Size& a, const Size& b) { return {sum(a.value, b.value), sum(a.rate, b.rate)}; }

  // Primitives; each function gives a primitive's number. What pieces share is made once.
  int bound(int axis, int sign, const Size& size);
  int half_space(std::span<const AxisPart> line, const Size& size);
  int strip(std::span<const AxisPart> line, const Size& half_width);
  int ball(std::span<const AxisPart> centre, const Size& radius);

  /// The set is the union of all pieces that were added.
  void add_piece(const Conditions& conditions);
  /// Says that all pieces lie between these faces at all times: for the cheap answer (chord.h).
  void enclose(const Faces& faces) { hull_.push_back(faces); }

  std::span<const Length> lengths() const { return lengths_; }
  std::span<const int> varying() const { return varying_; }  ///< the lengths that vary from pair to pair
  std::span<const Primitive> primitives() const { return primitives_; }
  std::span<const Piece> pieces() const { return pieces_; }
  std::span<const Faces> hull() const { return hull_; }
  std::span<const int> members(const Part& part) const {
    return {members_.data() + part.begin, members_.data() + part.end};
  }
  /// The highest power of time in its sizes.
  int degree() const;
  Arrays arrays() const;

 private:
  bool varies(int length) const {
    return length != no_length && lengths_[static_cast<std::size_t>(length)].varies;
  }
  int add(const Length& length);
  int add(const Primitive& primitive);
  Part add(const std::vector<int>& members);

  std::vector<Length> lengths_;
  std::vector<int> varying_;
  std::vector<Primitive> primitives_;
  std::vector<Piece> pieces_;
  std::vector<int> members_;
  std::vector<Faces> hull_;
};

template <class T>
T length_of(const ContactSet& set, const double* row_a, const double* row_b, int number);

/// The lengths of one pair, each when it is asked for.
template <class T>
struct PairLengths {
  const ContactSet& set;
  const double *row_a, *row_b;

  T operator[](int number) const { return length_of<T>(set, row_a, row_b, number); }
};

/// The two rows of a pair; what a row does not have is 0.
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

/// A length that is not given, from `known`, those before it, and the rows, as TwoRows has them.
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

/// One length of a pair, from nothing.
template <class T>
T length_of(const ContactSet& set, const double* row_a, const double* row_b, int number) {
  const Length& length = set.lengths()[static_cast<std::size_t>(number)];
  if (length.from == Length::From::given) return Exactly<T>::number(length.number);
  return varying_length<T>(length, PairLengths<T>{set, row_a, row_b}, TwoRows<T>{row_a, row_b});
}

/// All lengths of one pair after another, in the order of their numbers; what is the same for all is computed
/// once.
template <class T>
class AllLengths {
 public:
  explicit AllLengths(const ContactSet& set) : lengths_(set.lengths().size()) {
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      if (!set.lengths()[i].varies) lengths_[i] = length_of<T>(set, nullptr, nullptr, static_cast<int>(i));
  }

  /// From now on the lengths of this pair.
  void take(const ContactSet& set, const double* row_a, const double* row_b) {
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
