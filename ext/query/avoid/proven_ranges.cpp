#include "query/avoid/proven_ranges.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/axes.h"
#include "base/integer_of.h"
#include "contact/clearance/departure.h"

namespace foresee {
namespace {

/// Whether the error of any number may decide its sign.
template <int D>
bool seem_zero(const Vec<D>& numbers, const Vec<D>& errors) {
  return (errors > 0 && numbers.abs() <= 0x1p30 * errors).any();
}

/// Whether rounding errors alone may decide if the two seem to touch at the start, or to separate. `touches`: by
/// exact contact.
template <int D>
bool rounding_may_decide(const Encounter<D>& encounter, bool touches) {
  return starts_nearly_touching(encounter) &&
         (!touches || seem_zero<D>(encounter.x, encounter.ex) || seem_zero<D>(encounter.v, encounter.ev));
}

/// For a delay, and for an intruder that does not exist yet, only the gap is valid.
template <int D>
void set_exact_state(Encounter<D>& encounter, const ExactAvoidance::InitialState& exact, bool delayed) {
  encounter.square_gap = exact.square_gap;
  if (delayed || encounter.begin > 0) return;
  for (int axis = 0; axis < D; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    encounter.x[axis] = exact.x[j];
    encounter.ex[axis] = exact.ex[j];
    encounter.v[axis] = exact.v[j];
    encounter.ev[axis] = exact.ev[j];
  }
}

/// An intruder, and what it is sorted by.
template <int D>
struct OrderedIntruder {
  double nearness;
  std::size_t table;
  std::int64_t id;
  std::size_t leg;
  double t;
  Intruder<D> intruder;
};

/// The encounters of all legs of the changed object with all near objects.
template <int D>
class Encounters {
 public:
  Encounters(const ManoeuvreCase& manoeuvre, ExactAvoidance& exact, Interrupt& interrupt)
      : manoeuvre_(manoeuvre),
        question_(manoeuvre.question),
        exact_(exact),
        interrupt_(interrupt),
        own_bodies_(question_.own_scene->bodies()) {}

  /// This must outlive the intruders, whose outlines refer to it.
  std::vector<Intruder<D>> nearest_first() {
    touches_at_start_ = marked(exact_.touching_at_start(manoeuvre_.records_at_start()));
    if (first_leg().starts_vary()) touches_if_it_rests_ = marked(touching_if_it_rests());
    for (const NearObjects& near : manoeuvre_.near_objects) others_.push_back(near.scene->bodies());
    for (std::size_t table = 0; table < manoeuvre_.near_objects.size(); ++table) add_table(table);
    std::sort(ordered_.begin(), ordered_.end(), [](const OrderedIntruder<D>& a, const OrderedIntruder<D>& b) {
      return std::tie(a.nearness, a.table, a.id, a.leg, a.t) <
             std::tie(b.nearness, b.table, b.id, b.leg, b.t);
    });
    std::vector<Intruder<D>> intruders;
    for (OrderedIntruder<D>& one : ordered_) intruders.push_back(std::move(one.intruder));
    return intruders;
  }

 private:
  using AtStart = typename Intruder<D>::AtStart;
  using Marks = std::vector<std::vector<std::uint8_t>>;

  const Changes& first_leg() const { return manoeuvre_.first_leg(); }

  /// Marks 1 for these rows of each table, 0 for the others.
  Marks marked(const std::vector<NearRow>& some) const {
    Marks marks;
    for (const NearObjects& near : manoeuvre_.near_objects) marks.emplace_back(near.scene->size());
    for (const NearRow& near_row : some) marks[near_row.table][near_row.row] = 1;
    return marks;
  }

  /// What the object touches at any time if it remains at its start.
  std::vector<NearRow> touching_if_it_rests() {
    OwnMotion resting = first_leg().unchanged();
    resting.t = first_leg().reference().t;
    resting.until = std::numeric_limits<double>::infinity();
    resting.v = resting.a = resting.force = {};
    return exact_.touching({manoeuvre_.own.record_of(resting)}, {});
  }

  /// Adds the encounters of each leg with the near objects of one table.
  void add_table(std::size_t table) {
    const NearObjects& near = manoeuvre_.near_objects[table];
    const Bodies& there = others_[table];
    const PairRule rule(own_bodies_.layout, there.layout, question_.within, question_.within_z);
    const bool outlines = rule.pieces == PieceKind::planar;
    for (std::size_t leg = 0; leg < manoeuvre_.changed.legs.size(); ++leg) {
      // Only the first leg turns: what follows has the stored heading.
      const auto own_outline = outlines ? std::make_shared<const OwnOutline>(
                                              own_bodies_, 0, manoeuvre_.rotates_outline && leg == 0)
                                        : nullptr;
      const std::size_t count = near.of_leg.empty() ? there.count : near.of_leg[leg].size();
      for (std::size_t i = 0; i < count; ++i) {
        if (i % 4096 == 0) interrupt_.check();
        add(table, near.of_leg.empty() ? i : near.of_leg[leg][i], leg, rule, there, own_outline);
      }
    }
  }

  /// Adds one encounter, if the two ever exist together and contact at the start is not ignored.
  void add(std::size_t table, std::size_t row, std::size_t leg, const PairRule& rule, const Bodies& there,
           const std::shared_ptr<const OwnOutline>& own_outline) {
    const bool touches = touches_at_start_[table][row] != 0;
    if (touches && question_.touching == Touching::ignore) return;
    const OwnMotion& reference = manoeuvre_.changed.legs[leg]->reference();
    const auto extents = extents_of_both<D>(rule, own_bodies_.row(0), there.row(row), reference.t);
    const Horizon horizon{question_.now, question_.h};
    auto encounter = encounter_of<D>(reference, horizon, there, there.row(row), extents);
    if (encounter.begin > encounter.end) return;
    const double far = (encounter.x.abs() - encounter.extents.half).largest() - encounter.extents.radius;
    const auto pair = own_outline ? std::make_shared<const OutlinePair>(own_outline, there, row,
                                                                        given_outline(table, there, row))
                                  : nullptr;
    const bool touches_if_it_rests = first_leg().starts_vary() && touches_if_it_rests_[table][row] != 0;
    const AtStart known = at_start(encounter, leg, touches, touches_if_it_rests);
    if (leg == 0 && rounding_may_decide(encounter, touches)) {
      const NearRow near_row{table, static_cast<std::uint32_t>(row)};
      set_exact_state(encounter, exact_.initial_state(manoeuvre_.records_at_start(), near_row),
                      first_leg().starts_vary());
    }
    const double t = value_or(there.row(row), there.at.t, 0);
    ordered_.push_back(
        {far, table, manoeuvre_.near_objects[table].scene->ids[row], leg, t, {encounter, known, pair, leg}});
  }

  /// The outline of a row before its rotation; null: not known.
  const SharedOutline* given_outline(std::size_t table, const Bodies& there, std::size_t row) {
    const SearchTarget& target = table == 0 ? question_.others : *question_.also;
    if (!target.tree || there.layout.shape != Shape::outline) return nullptr;
    const std::int64_t number = integer_of(there.row(row)[there.at.outline]).value_or(0);
    if (number == 0) return nullptr;
    std::shared_ptr<const Form>& form = forms_[{table, number}];
    if (!form) form = target.tree->forms()->form(number);
    return static_cast<const SharedOutline*>(form.get());
  }

  /// For a delay only the state of a resting intruder is known: it has the same position at every start. What is later
  /// by k has no exempt contact; of later legs nothing is known.
  AtStart at_start(const Encounter<D>& encounter, std::size_t leg, bool touches,
                   bool touches_if_it_rests) const {
    if (leg > 0) return AtStart::unknown;
    if (first_leg().starts_vary()) {
      const bool rests = (encounter.v == 0).all() && (encounter.ev == 0).all() && !encounter.bends() &&
                         !encounter.extents.grows;
      return rests && !touches_if_it_rests ? AtStart::apart : AtStart::unknown;
    }
    if (touches) return manoeuvre_.changed.are_later ? AtStart::unknown : AtStart::touches;
    return encounter.begin > 0 || manoeuvre_.rotates_outline ? AtStart::unknown : AtStart::apart;
  }

  const ManoeuvreCase& manoeuvre_;
  const AvoidQuestion& question_;
  ExactAvoidance& exact_;
  Interrupt& interrupt_;
  Bodies own_bodies_;
  std::map<std::pair<std::size_t, std::int64_t>, std::shared_ptr<const Form>> forms_;
  std::vector<Bodies> others_;  ///< of each table; outlines of intruders refer to them
  /// The rows of each table that touch at the start. For delays: what the object would touch if it stayed there.
  Marks touches_at_start_, touches_if_it_rests_;
  std::vector<OrderedIntruder<D>> ordered_;
};

}  // namespace

std::vector<KRange> proven_ranges(const ManoeuvreCase& manoeuvre, ExactAvoidance& exact,
                                  Interrupt& interrupt) {
  return with_axes(manoeuvre.own.layout.axes, [&]<int D>(Axes<D>) {
    Encounters<D> encounters(manoeuvre, exact, interrupt);
    RangeBisection<D> bisection(manoeuvre.changed.legs, encounters.nearest_first(), interrupt);
    return bisection.clear_ranges(manoeuvre.queried.lo, manoeuvre.queried.hi);
  });
}

}  // namespace foresee
