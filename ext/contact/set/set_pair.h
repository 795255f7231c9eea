// First contact of a pair by one contact set, as far as doubles and DoubleDouble certify it. It works as
// certified/union_pair.h, for a set instead of pieces under trees, with the early exits of conservative advancement.
//
//   SetPair<2, 1> pair(context, space);
//   if (pair.first_contact().touches == Verdict::yes) end = pair.end_of_contact();
//
// The pieces of a set are few and share primitives, so all are evaluated at one time after another
// (advancement.h). Only the primitives that may be 0 in a bracket so found have a root to round.
#pragma once

#include "contact/certified/pair_context.h"
#include "contact/set/advancement.h"

namespace foresee {

/// A set and its lengths for one pair after another.
class SetPieces {
 public:
  void load(const ContactSet& set, const double* row_a, const double* row_b) {
    if (!lengths_) {
      set_ = &set;
      lengths_.emplace(set);
    }
    lengths_->compute(set, row_a, row_b);
  }

  const ContactSet& set() const { return *set_; }
  const AllLengths<Bounded>& lengths() const { return *lengths_; }
  std::size_t count() const { return set_ ? set_->pieces().size() : 0; }

 private:
  const ContactSet* set_ = nullptr;
  std::optional<AllLengths<Bounded>> lengths_;
};

/// The input of all stages for a pair, as PairContext is for pieces under trees. The set is that of `a`.
template <int D, int Degree>
struct SetPairContext : PairInput<SetPieces> {
  [[gnu::always_inline]] explicit SetPairContext(const PairInput<SetPieces>& input)
      : PairInput(input), relative(certain_motion_of<D, Degree>(setup, row_a, row_b)) {}

  const CertainMotion<D> relative;
};

/// Scratch space, reused for one pair after another. By primitive:
struct SetSpace {
  std::vector<double> known;
  std::vector<Instant> crossings;  ///< those that were computed
  std::vector<char> tested;
};

/// The time of a crossing that an Advancement has bracketed. Within the bracket a primitive either keeps its sign,
/// or its polynomial is monotone and has at most one root. Roots of different primitives are rounded
/// separately and then compared, because rounding is monotone.
template <CrossingDirection direction, int D, int Degree>
class SetCrossing {
 public:
  /// Requires: an Advancement has found the bracket, for this pair and this direction.
  SetCrossing(const SetPairContext<D, Degree>& context, CertainSet<D, Degree>& certain,
              const Bracket& bracket, SetSpace& space)
      : certain_(certain),
        lengths_{context.a.set(), context.row_a, context.row_b},
        space_(space),
        base_(bracket.before),
        now_(context.setup.horizon.now) {
    const auto relative = relative_motion_of<DoubleDouble, D>(context.setup, context.row_a, context.row_b);
    width_ = (bracket.after - bracket.before) * (1 + 4 * unit_roundoff);
    certain.expand_at(base_);
    const DoubleDouble tau{base_, 0};
    for (std::size_t j = 0; j < D; ++j) {
      const auto& [x, v, half_a] = relative[j];
      place_[j][0] = Degree < 2 ? x + tau * v : x + tau * (v + tau * half_a);
    }
    space.crossings.resize(certain.set().primitives().size());
    space.tested.assign(space.crossings.size(), false);
  }

  /// When the pair enters or leaves the set, or unknown. The set is the union of its pieces: the pair enters it with
  /// the first piece that it enters, and leaves it with the last.
  Instant instant() {
    Instant whole = outside;
    for (const ContactSet::Piece& piece : certain_.set().pieces()) whole = any(whole, of_piece(piece));
    return whole;
  }

 private:
  static constexpr double crossed = direction == CrossingDirection::entering ? -unbounded : unbounded;
  static constexpr Instant inside{crossed, crossed}, outside{-crossed, -crossed};

  static Instant all(const Instant& a, const Instant& b) {
    return direction == CrossingDirection::entering ? later(a, b) : earlier(a, b);
  }
  static Instant any(const Instant& a, const Instant& b) {
    return direction == CrossingDirection::entering ? earlier(a, b) : later(a, b);
  }
  static bool is_outside(const Instant& instant) { return instant.dt == outside.dt; }

  /// When it enters or leaves a piece. Outside one primitive is outside, even if others are undecided.
  Instant of_piece(const ContactSet::Piece& piece) {
    Instant crossing = inside;
    for (const int i : certain_.set().members(piece.all)) {
      const Instant one = of_primitive(i);
      if (is_outside(one)) return outside;
      crossing = all(crossing, one);
    }
    return crossing;
  }

  /// When primitive number i is crossed; computed once.
  Instant of_primitive(int i) {
    const auto place = static_cast<std::size_t>(i);
    if (!space_.tested[place]) {
      space_.tested[place] = true;
      space_.crossings[place] = computed(certain_.set().primitives()[place]);
    }
    return space_.crossings[place];
  }

  Instant computed(const Primitive& primitive) const {
    return certain_.with_polynomial(
        primitive, [this, &primitive](const auto& p) { return this->in_bracket(primitive, p); });
  }

  /// When its polynomial changes sign: `inside` or `outside` if it certainly keeps that sign in the whole
  /// bracket, else its root, rounded once, or unknown.
  template <std::size_t N>
  Instant in_bracket(const Primitive& primitive, const std::array<Bounded, N>& p) const {
    const double lost = certain_.lost(primitive), error = p[0].error_bound(lost);
    double moved = 0;
    for (std::size_t k = N - 1; k > 0; --k) moved = width_ * (upper_bound(p[k]) + moved);
    const double certain = error + 2 * moved;
    if (p[0].value < -certain || positive_during(p, -1, lost, width_) > width_) return inside;
    if (p[0].value > certain || positive_during(p, 1, lost, width_) > width_) return outside;
    const DoubleDouble value = polynomial_of<0>(primitive, place_, lengths_, base_)[0];
    return rounded_crossing<direction>(p, value, certain_.relative().underflow, now_, base_, width_);
  }

  static double upper_bound(const Bounded& c) { return std::abs(c.value) + c.error_bound(0x1p-1060); }

  CertainSet<D, Degree>& certain_;
  const PairLengths<DoubleDouble> lengths_;
  SetSpace& space_;
  Coefficients<DoubleDouble, 0> place_[D];
  double base_, width_, now_;
};

template <int D, int Degree>
class SetPair {
 public:
  using Context = SetPairContext<D, Degree>;

  SetPair(const Context& context, SetSpace& space)
      : context_(context),
        space_(space),
        certain_(context.a.set(), context.relative, context.a.lengths().data(), space.known),
        advancement_(certain_, context.lifetime, context.near) {}

  SetPair(const SetPair&) = delete;  // advancement_ refers to certain_
  SetPair& operator=(const SetPair&) = delete;

  /// Whether they touch. Stops at the first time at which they certainly do.
  Verdict touches() { return advancement_.touches(); }

  /// Whether they touch, and when contact starts. Its end is not searched.
  FirstContact first_contact() {
    const Verdict touches = advancement_.first_contact(first_);
    if (touches != Verdict::yes) return {touches};
    Instant begin = context_.lifetime.start();
    if (first_.after > begin.dt) begin = later(crossing<CrossingDirection::entering>(first_), begin);
    return {begin.known() ? Verdict::yes : Verdict::uncertain, begin};
  }

  /// After `yes`: a time by which contact has certainly started.
  double contact_by() const { return first_.after; }
  /// In place of first_contact(): they certainly touch at this time.
  void start_at(double time) { first_.after = time; }

  /// When the contact ends that first_contact() or start_at() has found, or unknown.
  Instant end_of_contact() {
    Bracket last;
    const Verdict leaves = advancement_.end_of_contact(first_.after, last);
    if (leaves == Verdict::uncertain) return unknown_instant();
    const Instant end = context_.lifetime.end();
    return leaves == Verdict::no ? end : earlier(crossing<CrossingDirection::leaving>(last), end);
  }

  const Context& context() const { return context_; }

 private:
  /// The time in the bracket at which the pair enters or leaves the set, rounded once, or unknown.
  template <CrossingDirection direction>
  Instant crossing(const Bracket& bracket) {
    return SetCrossing<direction, D, Degree>(context_, certain_, bracket, space_).instant();
  }

  const Context& context_;
  SetSpace& space_;
  CertainSet<D, Degree> certain_;
  Advancement<D, Degree> advancement_;
  Bracket first_;
};

}  // namespace foresee
