#include "query/avoid/exact_avoidance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/axes.h"
#include "contact/minkowski/relative_motion.h"
#include "numbers/dyadic.h"
#include "query/avoid/intruder_certificate.h"
#include "query/join/question.h"
#include "shape/shapes.h"

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t pairs_at_once = 4096;

/// Whether the distance of the centres never decreases. On straight paths its slope increases, so the first
/// decides.
template <int D>
bool separates_exactly(const Setup& setup, const double* own, const double* other) {
  const auto relative = relative_motion_of<Dyadic, D>(setup, own, other);
  Dyadic slope;
  for (int axis = 0; axis < D; ++axis) slope = slope + relative.x[axis] * relative.v[axis];
  return slope.sign() >= 0;
}

bool bends(const Bodies& bodies, const double* row) {
  if (bodies.at.a == Offsets::absent) return false;
  return std::any_of(row + bodies.at.a, row + bodies.at.a + bodies.layout.axes,
                     [](double a) { return a != 0; });
}

template <int D>
bool grows_at_all(const Bodies& bodies, const double* row) {
  return (growth_of<D>(bodies.layout.shape, row, bodies.at) > 0).any();
}

/// Writes a row of the same object with the sizes that it has after growing for `age`, rounded up.
/// `out_layout`: the same layout without omitted sizes.
void grow_row(const Layout& layout, const double* row, double age, Layout out_layout, double* out) {
  const Offsets from = row_offsets(layout), to = row_offsets(out_layout);
  const int left_out = from.size == to.size ? to.size : to.r;  // r, or r and hz
  std::copy_n(row, std::min(left_out, from.size), out);
  if (left_out < to.size) {
    double* const rest = std::fill_n(out + left_out, to.size - from.size, 0.0);
    std::copy(row + left_out, row + from.size, rest);
  }
  const auto grow = [&](int place, int axis) {
    const double more = age * value_or(row, growth_place(layout.shape, from, axis), 0);
    const double size = (out[place] + more) * (more > 0 ? 1 + 0x1p-49 : 1);
    out[place] = std::min(size, std::numeric_limits<double>::max());
  };
  if (to.half != Offsets::absent)
    for (int axis = 0; axis < layout.axes; ++axis) grow(to.half + axis, axis);
  if (to.r != Offsets::absent) grow(to.r, 0);
  if (to.hz != Offsets::absent) grow(to.hz, 2);
}

/// The form of the object that changes.
struct OneForm final : FormSource {
  explicit OneForm(std::shared_ptr<const Form> only) : only(std::move(only)) {}
  std::shared_ptr<const Form> form(std::int64_t /*number*/) override { return only; }

  std::shared_ptr<const Form> only;
};

bool are_convex(const PairRule& rule, const Bodies& own, const Bodies& others, std::size_t row) {
  if (rule.pieces == PieceKind::none) return true;
  ObjectPieces one, other;
  one.take_row(own, own.outlines, 0), other.take_row(others, others.outlines, row);
  return one.count() == 1 && other.count() == 1;
}

}  // namespace

ExactAvoidance::ExactAvoidance(const AvoidQuestion& question, Scenes near, Interrupt& interrupt)
    : question_(question), interrupt_(interrupt), near_(std::move(near)) {
  own_.name = question.own->name, own_.layout = question.own->layout;
  own_.layout.starts_as_point = false;
  if (own_.layout.shape == Shape::outline && grows(own_.layout)) own_.layout.has_radius = true;
  own_.ids = {0};
  own_.rows.resize(static_cast<std::size_t>(row_offsets(own_.layout).size));
  take(question.record);
  for (std::size_t table = 0; table < near_.size(); ++table)
    contacts_.push_back(contact(table, {question.now, question.h}));
  at_first_.resize(near_.size());
}

ExactAvoidance::~ExactAvoidance() = default;

void ExactAvoidance::take(const std::vector<double>& record) {
  const Layout& layout = question_.own->layout;
  const double t = value_or(record.data(), record_offsets(layout).t, 0);
  if (grows(layout)) {
    std::vector<double> row(static_cast<std::size_t>(row_offsets(layout).size));
    row_from_record(layout, record.data(), row.data());
    const double age = t - value_or(question_.record.data(), record_offsets(layout).t, 0);
    grow_row(layout, row.data(), age, own_.layout, own_.rows.data());
  } else {
    row_from_record(layout, record.data(), own_.rows.data());
  }
  if (layout.shape == Shape::outline) take_form();
  const double first = std::max(question_.now, t);
  if (first == start_) return;
  start_ = first;
  for (auto& contact : at_first_) contact.reset();
}

void ExactAvoidance::take_form() {
  const Offsets at = row_offsets(own_.layout);
  const double heading = value_or(own_.rows.data(), at.heading, 0);
  if (question_.form) {
    const Extents<3> around = question_.form->extents(heading);
    for (int axis = 0; axis < 2; ++axis) {
      own_.rows[static_cast<std::size_t>(at.bounds + axis)] = around.lower[axis];
      own_.rows[static_cast<std::size_t>(at.bounds + 2 + axis)] = around.upper[axis];
    }
  }
  if (own_.forms && heading == heading_) return;
  heading_ = heading;
  if (!own_.forms) own_.forms = std::make_unique<RowForms>();
  OneForm source(question_.form);
  own_.forms->assign(own_.bodies(), source, interrupt_);
}

std::unique_ptr<Contact> ExactAvoidance::contact(std::size_t table, const Horizon& horizon) const {
  const Scene& near = *near_[table];
  auto contact = make_contact(own_.bodies(), near.bodies(), {horizon, question_.within, question_.within_z},
                              own_.name, near.name);
  contact->set_interrupt(interrupt_);
  return contact;
}

std::vector<Intruder> ExactAvoidance::decided(std::vector<std::unique_ptr<Contact>>& contacts,
                                              const std::vector<std::vector<std::uint8_t>>& left_out) {
  std::vector<Intruder> touching;
  for (std::size_t table = 0; table < near_.size(); ++table) {
    std::vector<Pair> pairs, hits;
    const auto count = static_cast<std::uint32_t>(near_[table]->size());
    for (std::uint32_t row = 0; row < count;) {
      interrupt_.check();
      pairs.clear();
      for (; row < count && pairs.size() < pairs_at_once; ++row)
        if (left_out.empty() || !left_out[table][row]) pairs.push_back({0, row});
      contacts[table]->decide(pairs, hits);
    }
    for (const Pair& hit : hits) touching.push_back({static_cast<int>(table), hit.b});
  }
  return touching;
}

std::vector<Intruder> ExactAvoidance::touching_at_start(const std::vector<double>& record) {
  take(record);
  if (!(start_ - question_.now <= question_.h)) return {};
  for (std::size_t table = 0; table < near_.size(); ++table)
    if (!at_first_[table]) at_first_[table] = contact(table, {start_, 0});
  return decided(at_first_, {});
}

bool ExactAvoidance::touches(Contact& contact, const Intruder& intruder) const {
  const Pair pair{0, intruder.row};
  std::vector<Pair> hits;
  contact.decide({&pair, 1}, hits);
  return !hits.empty();
}

bool ExactAvoidance::touches_at_start(const Intruder& intruder) {
  const auto table = static_cast<std::size_t>(intruder.table);
  if (!at_first_[table]) at_first_[table] = contact(table, {start_, 0});
  return touches(*at_first_[table], intruder);
}

bool ExactAvoidance::separates(const Intruder& intruder) {
  const Scene& near = *near_[static_cast<std::size_t>(intruder.table)];
  const Bodies own = own_.bodies(), others = near.bodies();
  const double *own_row = own.row(0), *row = others.row(intruder.row);
  const PairLifetime lifetime = pair_lifetime_of({own, others, {question_.now, question_.h}}, own_row, row);
  if (lifetime.none || (lifetime.t_start == lifetime.t_end && lifetime.dt_start == lifetime.dt_end))
    return true;
  const Horizon first{start_, 0};
  const PairRule rule(own.layout, others.layout, question_.within, question_.within_z);
  const bool has_outlines = rule.pieces == PieceKind::planar;
  if (has_outlines && !touches_at_start(intruder))
    return !touches(*contacts_[static_cast<std::size_t>(intruder.table)], intruder);
  return with_axes(own.layout.axes, [&]<int D>(Axes<D>) {
    const bool grow = grows_at_all<D>(own, own_row) || grows_at_all<D>(others, row);
    if (!grow && !bends(own, own_row) && !bends(others, row) && are_convex(rule, own, others, intruder.row))
      return separates_exactly<D>({own, others, first}, own_row, row);
    OwnMotion motion;
    motion.t = value_or(own_row, own.at.t, 0), motion.until = value_or(own_row, own.at.until, infinity);
    for (int axis = 0; axis < D; ++axis) {
      const AxisMotion<double> one = axis_motion(own, own_row, axis);
      const auto j = static_cast<std::size_t>(axis);
      motion.x[j] = one.x, motion.v[j] = one.v, motion.a[j] = one.a;
    }
    const OwnMotion base = motion_from(motion, std::max(start_, motion.t));
    const auto encounter = encounter_of<D>(base, {question_.now, question_.h}, others, row,
                                           extents_of_both<D>(rule, own_row, row, base.t));
    std::shared_ptr<const OutlinePair> outlines;
    if (has_outlines)
      outlines =
          std::make_shared<OutlinePair>(std::make_shared<OwnOutline>(own, 0, false), others, intruder.row);
    return is_clear_of<D>({encounter, IntruderCertificate<D>::AtFirst::touches, outlines},
                          trajectory_family<D>(*no_changes_of(base), 0, 0), 0);
  });
}

std::vector<Intruder> ExactAvoidance::touching(const std::vector<double>& record,
                                               const std::vector<Intruder>* first) {
  std::vector<Intruder> own_first;
  if (first)
    take(record);
  else
    own_first = touching_at_start(record), first = &own_first;
  std::vector<std::vector<std::uint8_t>> left_out;
  for (const auto& near : near_) left_out.emplace_back(near->size());
  for (const Intruder& intruder : *first)
    left_out[static_cast<std::size_t>(intruder.table)][intruder.row] = 1;
  std::vector<Intruder> touching = decided(contacts_, left_out);
  if (question_.touching == Touching::part)
    for (const Intruder& intruder : *first)
      if (!separates(intruder)) touching.push_back(intruder);
  return touching;
}

std::optional<Blocker> ExactAvoidance::first_touching(const std::vector<double>& record,
                                                      const std::vector<Intruder>& touching) {
  take(record);
  std::optional<Blocker> first;
  std::vector<Pair> pairs, hits;
  std::vector<ContactTimes> times;
  for (std::size_t table = 0; table < near_.size(); ++table) {
    pairs.clear(), hits.clear(), times.clear();
    for (const Intruder& intruder : touching)
      if (static_cast<std::size_t>(intruder.table) == table) pairs.push_back({0, intruder.row});
    contacts_[table]->first_contacts(pairs, TimesWanted::starts, hits, times);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Blocker blocker{near_[table]->ids[hits[i].b], static_cast<int>(table), times[i].t};
      if (!first ||
          std::tie(blocker.t, blocker.table, blocker.id) < std::tie(first->t, first->table, first->id))
        first = blocker;
    }
  }
  return first;
}

}  // namespace foresee
