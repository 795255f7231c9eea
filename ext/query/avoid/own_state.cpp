#include "query/avoid/own_state.h"

#include <algorithm>
#include <cmath>

#include "motion/plan/plan_legs.h"
#include "query/join/question.h"

namespace foresee {
namespace {

/// Calls use(number of the record, number of the motion) for each number that both have.
template <class Record, class Motion, class Use>
void with_places(const Layout& layout, Record& record, Motion& motion, Use&& use) {
  const Offsets at = record_offsets(layout);
  const auto vector = [&](int place, auto& numbers) {
    if (place == Offsets::absent) return;
    for (int axis = 0; axis < layout.axes; ++axis)
      use(record[static_cast<std::size_t>(place + axis)], numbers[static_cast<std::size_t>(axis)]);
  };
  const auto number = [&](int place, auto& value) {
    if (place != Offsets::absent) use(record[static_cast<std::size_t>(place)], value);
  };
  number(at.t, motion.t);
  number(at.until, motion.until);
  number(at.mass, motion.mass);
  number(at.heading, motion.heading);
  vector(at.x, motion.x);
  vector(at.v, motion.v);
  vector(at.a, motion.a);
  vector(at.force, motion.force);
}

bool has_legs(const AvoidQuestion& question) {
  return question.plan || question.resume || question.how == Manoeuvre::wait;
}

/// Adds t and until, and leaves out what records say of plans.
void add_lifetime(Layout& layout, std::vector<double>& record) {
  const auto place = [](int offset) { return static_cast<std::ptrdiff_t>(offset); };
  if (layout.has_plan) {
    layout.has_plan = false;
    record.erase(record.end() - 2, record.end());
  }
  if (!layout.has_t) {
    layout.has_t = true;
    record.insert(record.begin(), 0.0);
  }
  if (layout.has_until) return;
  layout.has_until = true;
  record.insert(record.begin() + place(record_offsets(layout).until), no_end);
}

/// A time after which no leg that starts, earlier by a delay, is in contact within the horizon; rounded up.
double last_start(const AvoidQuestion& question) {
  const double earlier = std::max(0.0, -question.lo.value_or(0));
  const double size = std::abs(question.now) + question.h + earlier;
  return question.now + question.h + earlier + 0x1p-50 * size;
}

}  // namespace

OwnMotion motion_in(const Layout& layout, const std::vector<double>& record) {
  OwnMotion motion;
  with_places(layout, record, motion, [](double stored, double& number) { number = stored; });
  if (motion.mass != 0)
    for (std::size_t j = 0; j < 3; ++j) motion.a[j] = motion.force[j] / motion.mass;
  return motion;
}

std::vector<double> with_motion(const Layout& layout, std::vector<double> record, const OwnMotion& motion) {
  with_places(layout, record, motion, [](double& stored, double number) { stored = number; });
  return record;
}

OwnState::OwnState(const AvoidQuestion& question)
    : layout(question.own_scene->layout), record(question.record) {
  if (has_legs(question)) add_lifetime(layout, record);
  stored = motion_in(layout, record);
  if (question.plan) {
    const double end = stored.until, last = last_start(question);
    for (const Leg& one : legs_of(*question.plan)) {
      if (one.t > end || (one.t > last && !legs.empty())) break;
      OwnMotion motion = stored;
      motion.t = one.t;
      motion.until = std::min(one.until, end);
      motion.x = one.x;
      motion.v = one.v;
      motion.a = one.a;
      if (legs.empty() && legs_before == 0) stored = motion;
      if (motion.until < question.now)
        ++legs_before;
      else
        legs.push_back(motion);
    }
    const double start = legs.empty() ? question.now : std::max(question.now, legs[0].t);
    while (current_leg + 1 < legs.size() && legs[current_leg + 1].t <= start) ++current_leg;
  }
  const OwnMotion& here = legs.empty() ? stored : legs[current_leg];
  base = motion_from(here, std::max(question.now, here.t));
}

bool OwnState::is_there(const Horizon& horizon) const {
  const auto lives = [&](const OwnMotion& one) { return !life_of(one.t, one.until, horizon).none; };
  return legs.empty() ? legs_before == 0 && lives(stored) : std::any_of(legs.begin(), legs.end(), lives);
}

std::vector<double> OwnState::record_of(const OwnMotion& motion) const {
  return with_motion(layout, record, motion);
}

OwnState::Records OwnState::records_of(const std::vector<OwnMotion>& motions) const {
  Records records;
  for (const OwnMotion& motion : motions) records.push_back(record_of(motion));
  return records;
}

std::vector<OwnMotion> ChangedLegs::motions_at_start() const {
  std::vector<OwnMotion> motions{legs[0]->unchanged()};
  if (legs[0]->starts_vary())
    for (std::size_t i = 1; i < legs.size(); ++i) {
      const OwnMotion next = legs[i]->unchanged();
      if (next.t > motions[0].t) break;
      motions.push_back(next);
    }
  for (std::size_t i = legs.size() - ending; i < legs.size(); ++i) motions.push_back(legs[i]->unchanged());
  return motions;
}

ChangedLegs changed_legs(const AvoidQuestion& question, const OwnState& own, const QueriedChanges& queried) {
  ChangedLegs changed;
  const auto add = [&](std::unique_ptr<Changes> leg) { changed.legs.push_back(std::move(leg)); };
  const Manoeuvre how = queried.manoeuvre;
  if (how == Manoeuvre::wait) {
    changed.are_later = true;
    add(rests_of(own.base));
    add(delays_of(own.base, 0));
    for (std::size_t i = own.current_leg + 1; i < own.legs.size(); ++i) add(delays_of(own.legs[i], 0));
    for (std::size_t i = 0; i <= own.current_leg && i < own.legs.size(); ++i) {
      if (i == own.current_leg && own.legs[i].t == own.base.t) break;
      add(end_of(own.legs[i], std::min(own.legs[i].until, own.base.t)));
      ++changed.ending;
    }
  } else if (how == Manoeuvre::delay) {
    changed.are_later = true;
    if (own.legs.empty()) add(delays_of(own.stored, queried.lo));
    for (const OwnMotion& leg : own.legs) add(delays_of(leg, queried.lo));
  } else if (question.resume) {
    OwnMotion first = own.base;
    const double time = own.base.t + *question.resume;
    first.until = std::min(first.until, time);
    add(changes_by(how, first));
    if (time < own.base.until) add(resumed_after(changes_by(how, first), own.base, time));
  } else {
    add(changes_by(how, own.base, question.on_globe));
  }
  return changed;
}

}  // namespace foresee
