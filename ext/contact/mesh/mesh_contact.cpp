#include <algorithm>

#include "contact/contact_factories.h"
#include "contact/exact/pair_polynomials.h"
#include "contact/mesh/containment.h"
#include "contact/mesh/disc_tests.h"
#include "contact/mesh/space_condition.h"
#include "contact/mesh/space_sum.h"
#include "contact/mesh/space_tests.h"
#include "contact/pieces/bounded_window.h"
#include "contact/pieces/pair_context.h"
#include "contact/pieces/pair_tests.h"
#include "contact/pieces/union_contact.h"

namespace foresee {

/// The exact polynomials of the pairs of pieces that doubles leave undecided. The pieces of the set are
/// the parts of each pair (space_sum.h); its primitives are their conditions, in order.
class SpacePolynomials final : public PiecePolynomials {
 public:
  /// `grown`: the contact distance of these objects is more than 0.
  SpacePolynomials(const Setup& setup, const double* row_a, const double* row_b, const SpacePieces& a,
                   const SpacePieces& b, std::span<const PiecePair> pairs, bool grown);

  PiecePolynomials& all() { return *this; }
  /// For each pair, the number of set pieces up to and with it.
  std::span<const std::uint32_t> ends() const { return ends_; }
  const ContactSet& set() const override { return set_; }
  std::size_t number_of(int primitive) override;
  Polynomial exact_polynomial(int primitive) const override;

 private:
  void add(const SpacePiece& a, const SpacePiece& b, bool grown);
  int add(const SpaceCondition& condition);
  template <class T>
  Coefficients<T, 4> polynomial_of(int primitive, const std::array<Coefficients<T, 2>, 3>& x) const;

  const Setup& setup_;
  const double *row_a_, *row_b_;
  std::vector<SpaceCondition> conditions_;
  ContactSet set_;
  std::vector<std::uint32_t> ends_;
  std::vector<int> number_of_;  ///< of each condition's polynomial; -1: not made yet
  const std::array<Coefficients<Midrad128, 2>, 3> rough_motion_;
  mutable std::optional<std::array<Coefficients<Dyadic, 2>, 3>> exact_motion_;  ///< made when first needed
};

SpacePolynomials::SpacePolynomials(const Setup& setup, const double* row_a, const double* row_b,
                                   const SpacePieces& a, const SpacePieces& b,
                                   std::span<const PiecePair> pairs, bool grown)
    : setup_(setup),
      row_a_(row_a),
      row_b_(row_b),
      rough_motion_(motion_coefficients<Midrad128>(setup, row_a, row_b)) {
  for (const PiecePair& pair : pairs) {
    add(a.piece(pair.a), b.piece(pair.b), grown);
    ends_.push_back(static_cast<std::uint32_t>(set_.pieces().size()));
  }
  number_of_.assign(conditions_.size(), -1);
}

int SpacePolynomials::add(const SpaceCondition& condition) {
  conditions_.push_back(condition);
  return static_cast<int>(conditions_.size()) - 1;
}

void SpacePolynomials::add(const SpacePiece& a, const SpacePiece& b, bool grown) {
  Conditions core;
  SpaceHull(a, b).for_each([&](const SpacePlanes& planes) {
    core.all.push_back(add(planes.before)), core.all.push_back(add(planes.beyond));
    return true;
  });
  set_.add_piece(core);
  if (!grown) return;
  RoundParts(a, b).for_each([this](const RoundPart& part) {
    Conditions conditions;
    for (int i = 0; i < part.count; ++i)
      conditions.all.push_back(add(part.beside[static_cast<std::size_t>(i)]));
    conditions.ball = add(part.round);
    conditions.all.push_back(conditions.ball);
    set_.add_piece(conditions);
    return true;
  });
}

template <class T>
Coefficients<T, 4> SpacePolynomials::polynomial_of(int primitive,
                                                   const std::array<Coefficients<T, 2>, 3>& x) const {
  Coefficients<T, 4> all{};
  const SpaceSizes<T> sizes{.radius = size_as_of_t<T>(setup_.rule.radius, row_a_, row_b_)};
  with_polynomial<2>(conditions_[static_cast<std::size_t>(primitive)], x, sizes,
                     [&all](const auto& p) { std::copy(p.begin(), p.end(), all.begin()); });
  return all;
}

std::size_t SpacePolynomials::number_of(int primitive) {
  int& number = number_of_[static_cast<std::size_t>(primitive)];
  if (number < 0) {
    number = static_cast<int>(polynomials_.size());
    polynomials_.emplace_back(polynomial_of(primitive, rough_motion_), *this, primitive);
  }
  return static_cast<std::size_t>(number);
}

Polynomial SpacePolynomials::exact_polynomial(int primitive) const {
  if (!exact_motion_) exact_motion_ = motion_coefficients<Dyadic>(setup_, row_a_, row_b_);
  return Polynomial(polynomial_of(primitive, *exact_motion_));
}

/// Traits of contact between meshes (pieces/pair_context.h): triangles, boxes and points in space.
template <int Degree>
struct SpaceTraits {
  static constexpr int axes = 3, degree = Degree;
  static constexpr bool has_solids = true;
  using Tables = MeshTables;
  using Pieces = SpacePieces;
  using Condition = SpaceCondition;
  template <class T>
  using Sizes = SpaceSizes<T>;
  using Space = PieceWorkspace<SpaceCondition>;
  using Tests = SpaceTests<Degree>;
  using NodeTests = DiscTests;
  using Containment = foresee::Containment;
  using Polynomials = SpacePolynomials;

  template <class T>
  static SpaceSizes<T> sizes_of(const Setup& setup, const double* row_a, const double* row_b) {
    return {size_as_of_t<T>(setup.rule.radius, row_a, row_b), steady_axes_of(setup, row_a, row_b)};
  }
  /// Nothing: the filter of meshes tests single pairs of triangles (triangle_filter.h).
  static FilterAnswer filter_answer(const PairContext<SpaceTraits>&, bool) { return {}; }
  static constexpr bool is_cut(const SpaceCondition&) { return false; }
  /// Reads the pieces of a pair of rows.
  static void take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables, const Pair& pair);
};

namespace {

Vec<3> place_at(const double* numbers) {
  return Vec<3>(numbers[0], numbers[1], numbers[2]);
}

/// Reads the pieces of a row.
void take_row(SpacePieces& pieces, const Bodies& bodies, const MeshRows* meshes, std::size_t i) {
  const TriangleTree* const known = meshes ? meshes->triangles(i, pieces.own()) : nullptr;
  if (known) return pieces.take(*known);
  const double* const row = bodies.row(i);
  const Offsets& at = bodies.at;
  if (!meshes && at.bounds != Offsets::absent)
    return pieces.take_box({place_at(row + at.bounds), place_at(row + at.bounds + 3)});
  if (at.half == Offsets::absent) return pieces.take_point();
  pieces.take_box({-place_at(row + at.half), place_at(row + at.half)});
}

}  // namespace

template <int Degree>
void SpaceTraits<Degree>::take(Pieces& a, Pieces& b, const Setup& setup, const Tables& tables,
                               const Pair& pair) {
  if (setup.window)
    a.take_box(bounded_window<3>(setup, setup.b.row(pair.b)));
  else
    take_row(a, setup.a, tables.a, pair.a);
  take_row(b, setup.b, tables.b, pair.b);
}

std::unique_ptr<Contact> make_mesh_contact(const Setup& setup, const MeshTables& meshes, int degree) {
  if (degree < 2) return std::make_unique<UnionContact<SpaceTraits<1>>>(setup, meshes);
  return std::make_unique<UnionContact<SpaceTraits<2>>>(setup, meshes);
}

}  // namespace foresee
