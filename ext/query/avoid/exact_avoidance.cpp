#include "query/avoid/exact_avoidance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "base/axes.h"
#include "base/interrupt_steps.h"
#include "index/tpr_tree/moving_box.h"
#include "query/join/question.h"
#include "query/margin.h"
#include "shape/shapes.h"

namespace foresee {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t pairs_at_once = 4096;

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

/// From the t to the until of each row.
IntervalTree lives_of(const Bodies& bodies) {
  std::vector<IntervalTree::Interval> lives;
  for (std::size_t i = 0; i < bodies.count; ++i)
    lives.push_back({value_or(bodies.row(i), bodies.at.t, -infinity),
                     value_or(bodies.row(i), bodies.at.until, infinity)});
  return IntervalTree(lives);
}

/// Leaves the pairs whose moving boxes meet. Outlines alone are worth it: the first test of one turns it.
void keep_near_outlines(const Bodies& a, const Bodies& b, const Horizon& horizon, const PairRule& rule,
                        std::vector<Pair>& pairs) {
  if (a.layout.shape != Shape::outline && b.layout.shape != Shape::outline) return;
  with_axes(a.layout.axes, [&]<int D>(Axes<D>) {
    const Vec<D> margin = margin_of<D>(rule.reach());
    MovingBox<D> own;
    std::uint32_t known = std::numeric_limits<std::uint32_t>::max();
    std::erase_if(pairs, [&](const Pair& pair) {
      if (pair.a != known) {
        own = moving_box<D>(a, pair.a, horizon, margin);
        known = pair.a;
      }
      const MovingBox<D> other = moving_box<D>(b, pair.b, horizon, margin);
      SharedInterval span = shared_span(own, other);
      return span.is_empty() || !narrow_to_contact(own, other, span);
    });
  });
}

/// The form of the object that changes.
struct OneForm final : FormSource {
  explicit OneForm(std::shared_ptr<const Form> only) : only(std::move(only)) {}
  std::shared_ptr<const Form> form(std::int64_t /*number*/) override { return only; }

  std::shared_ptr<const Form> only;
};

}  // namespace

ExactAvoidance::ExactAvoidance(const ManoeuvreCase& manoeuvre, Interrupt& interrupt)
    : manoeuvre_(manoeuvre), question_(manoeuvre.question), interrupt_(interrupt) {
  const OwnState& own = manoeuvre.own;
  const std::size_t max_legs = std::max(manoeuvre.changed.legs.size(), own.legs.size());
  moved_.name = question_.own_scene->name;
  moved_.layout = own.layout;
  moved_.layout.starts_as_point = false;
  if (moved_.layout.shape == Shape::outline && grows(moved_.layout)) moved_.layout.has_radius = true;
  moved_.ids.resize(max_legs);
  moved_.rows.resize(max_legs * static_cast<std::size_t>(row_offsets(moved_.layout).size));
  for (std::size_t leg = 0; leg < max_legs; ++leg) set_row(leg, own.record);
  set_motion({own.record});
  for (std::size_t table = 0; table < tables(); ++table)
    contacts_.push_back(contact(table, {question_.now, question_.h}));
  for (std::size_t table = 0; table < tables(); ++table)
    lives_.push_back(lives_of(near_scene(table).bodies()));
  start_contacts_.resize(tables());
}

ExactAvoidance::~ExactAvoidance() = default;

void ExactAvoidance::set_motion(const Records& legs) {
  legs_ = static_cast<std::uint32_t>(legs.size());
  Steps steps(interrupt_);
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    steps();
    set_row(leg, legs[leg]);
  }
  if (moved_.layout.shape == Shape::outline) set_forms();
  const double first =
      std::max(question_.now, value_or(legs[0].data(), record_offsets(manoeuvre_.own.layout).t, 0));
  if (first == start_) return;
  start_ = first;
  for (auto& contact : start_contacts_) contact.reset();
}

void ExactAvoidance::set_row(std::size_t leg, const std::vector<double>& record) {
  const Layout& layout = manoeuvre_.own.layout;
  double* const own_row =
      moved_.rows.data() + leg * static_cast<std::size_t>(row_offsets(moved_.layout).size);
  if (!grows(layout)) return row_from_record(layout, record.data(), own_row);
  std::vector<double> row(static_cast<std::size_t>(row_offsets(layout).size));
  row_from_record(layout, record.data(), row.data());
  const int t = record_offsets(layout).t;
  const double age = value_or(record.data(), t, 0) - value_or(manoeuvre_.own.record.data(), t, 0);
  grow_row(layout, row.data(), age, moved_.layout, own_row);
}

void ExactAvoidance::set_forms() {
  const Offsets at = row_offsets(moved_.layout);
  std::vector<double> headings;
  Extents<3> around;
  for (std::size_t leg = 0; leg < moved_.size(); ++leg) {
    double* const row = moved_.rows.data() + leg * static_cast<std::size_t>(at.size);
    headings.push_back(value_or(row, at.heading, 0));
    if (!question_.form) continue;
    if (leg == 0 || headings[leg] != headings[leg - 1]) around = question_.form->extents(headings[leg]);
    for (int axis = 0; axis < 2; ++axis) {
      row[at.bounds + axis] = around.lower[axis];
      row[at.bounds + 2 + axis] = around.upper[axis];
    }
  }
  if (moved_.forms && headings == headings_) return;
  headings_ = headings;
  if (!moved_.forms) moved_.forms = std::make_unique<RowForms>();
  OneForm source(question_.form);
  moved_.forms->assign(moved_.bodies(), source, interrupt_);
}

std::unique_ptr<Contact> ExactAvoidance::contact(std::size_t table, const Horizon& horizon) const {
  const Scene& others = near_scene(table);
  auto contact = make_contact(moved_.bodies(), others.bodies(),
                              {horizon, question_.within, question_.within_z}, moved_.name, others.name);
  contact->set_interrupt(interrupt_);
  return contact;
}

void ExactAvoidance::find_rows(std::uint32_t leg, std::size_t table, std::vector<std::uint32_t>& rows) const {
  rows.clear();
  if (legs_ == 1) {
    rows.resize(near_scene(table).size());
    std::iota(rows.begin(), rows.end(), std::uint32_t{0});
    return;
  }
  const Bodies own = moved_.bodies();
  lives_[table].find(value_or(own.row(leg), own.at.t, -infinity),
                     value_or(own.row(leg), own.at.until, infinity), [&](std::size_t row) {
                       rows.push_back(static_cast<std::uint32_t>(row));
                       return true;
                     });
  std::sort(rows.begin(), rows.end());
}

std::vector<NearRow> ExactAvoidance::decided(std::vector<std::unique_ptr<Contact>>& contacts,
                                             const Horizon& horizon,
                                             const std::vector<std::vector<std::uint8_t>>& left_out) {
  std::vector<NearRow> touching;
  for (std::size_t table = 0; table < tables(); ++table) {
    std::vector<Pair> pairs, hits;
    const PairRule rule(moved_.layout, near_scene(table).layout, question_.within, question_.within_z);
    const auto decide = [&] {
      interrupt_.check();
      keep_near_outlines(moved_.bodies(), near_scene(table).bodies(), horizon, rule, pairs);
      contacts[table]->decide(pairs, hits);
      pairs.clear();
    };
    std::vector<std::uint32_t> rows;
    for (std::uint32_t leg = 0; leg < legs_; ++leg) {
      find_rows(leg, table, rows);
      for (const std::uint32_t row : rows) {
        if (!left_out.empty() && left_out[table][row]) continue;
        pairs.push_back({leg, row});
        if (pairs.size() == pairs_at_once) decide();
      }
    }
    decide();
    std::vector<std::uint8_t> is_listed(legs_ > 1 ? near_scene(table).size() : 0);
    for (const Pair& hit : hits) {
      if (legs_ > 1 && std::exchange(is_listed[hit.b], 1)) continue;
      touching.push_back({table, hit.b});
    }
  }
  return touching;
}

void ExactAvoidance::add_other_legs_of(std::vector<NearRow>& touching) const {
  for (std::size_t table = 0; table < tables(); ++table) {
    const Scene& others = near_scene(table);
    if (!others.layout.has_plan) continue;
    std::unordered_set<std::int64_t> ids;
    for (const NearRow& one : touching)
      if (one.table == table) ids.insert(others.ids[one.row]);
    std::erase_if(touching, [&](const NearRow& one) { return one.table == table; });
    for (std::uint32_t row = 0; row < others.size(); ++row)
      if (ids.count(others.ids[row]) > 0) touching.push_back({table, row});
  }
}

std::vector<NearRow> ExactAvoidance::touching_at_start(const Records& legs) {
  set_motion(legs);
  if (!(start_ - question_.now <= question_.h)) return {};
  for (std::size_t table = 0; table < tables(); ++table)
    if (!start_contacts_[table]) start_contacts_[table] = contact(table, {start_, 0});
  std::vector<NearRow> touching = decided(start_contacts_, {start_, 0}, {});
  if (question_.touching == Touching::ignore) add_other_legs_of(touching);
  return touching;
}

bool ExactAvoidance::touches(Contact& contact, std::uint32_t leg, const NearRow& near_row) const {
  const Pair pair{leg, near_row.row};
  std::vector<Pair> hits;
  contact.decide({&pair, 1}, hits);
  return !hits.empty();
}

std::vector<NearRow> ExactAvoidance::touching(const Records& legs, const std::vector<NearRow>& exempt) {
  set_motion(legs);
  std::vector<std::vector<std::uint8_t>> left_out;
  for (std::size_t table = 0; table < tables(); ++table) left_out.emplace_back(near_scene(table).size());
  for (const NearRow& near_row : exempt) left_out[near_row.table][near_row.row] = 1;
  std::vector<NearRow> touching = decided(contacts_, {question_.now, question_.h}, left_out);
  if (question_.touching == Touching::part)
    for (const NearRow& near_row : exempt)
      if (!all_separate(near_row)) touching.push_back(near_row);
  return touching;
}

std::optional<Blocker> ExactAvoidance::first_touching(const Records& legs,
                                                      const std::vector<NearRow>& touching) {
  set_motion(legs);
  std::optional<Blocker> first;
  std::vector<Pair> pairs, hits;
  std::vector<ContactTimes> times;
  for (std::size_t table = 0; table < tables(); ++table) {
    pairs.clear();
    hits.clear();
    times.clear();
    std::vector<std::uint32_t> of_table, rows;
    for (const NearRow& near_row : touching)
      if (near_row.table == table) of_table.push_back(near_row.row);
    std::sort(of_table.begin(), of_table.end());
    for (std::uint32_t leg = 0; leg < legs_ && !of_table.empty(); ++leg) {
      find_rows(leg, table, rows);
      for (const std::uint32_t row : rows)
        if (std::binary_search(of_table.begin(), of_table.end(), row)) pairs.push_back({leg, row});
    }
    contacts_[table]->first_contacts(pairs, TimesWanted::starts, hits, times);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const Blocker blocker{near_scene(table).ids[hits[i].b], static_cast<int>(table), times[i].t};
      if (!first ||
          std::tie(blocker.t, blocker.table, blocker.id) < std::tie(first->t, first->table, first->id))
        first = blocker;
    }
  }
  return first;
}

}  // namespace foresee
