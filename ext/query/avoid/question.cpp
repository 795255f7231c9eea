#include "query/avoid/question.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "query/avoid/own_state.h"
#include "query/input_checks.h"
#include "query/join/question.h"

namespace foresee {
namespace {

/// Half the width of a range must be a finite double.
void require_width(double lo, double hi) {
  if (!std::isfinite(hi - lo))
    throw Error("hi - lo must be a finite number: lo is " + shown(lo) + ", hi is " + shown(hi) +
                "; write changes that the object can make, as in -10, 10");
}

void require_range(const AvoidQuestion& question) {
  const auto& [lo, hi] = std::pair(question.lo, question.hi);
  if (lo.has_value() != hi.has_value())
    throw Error(std::string(lo ? "hi" : "lo") + " is missing: give lo and hi together, or leave out both");
  if (!lo) return;
  if (!question.how)
    throw Error(
        "lo and hi need one manoeuvre; write how = 'turn', 'speed', 'climb', 'accelerate', 'delay' or "
        "'wait'");
  require_finite("lo", *lo);
  require_finite("hi", *hi);
  require_order("lo", *lo, "hi", *hi);
  require_width(*lo, *hi);
  if (question.how == Manoeuvre::turn && (*lo < -360 || *hi > 360))
    throw Error("a turn is given in degrees from -360 to 360: lo is " + shown(*lo) + ", hi is " + shown(*hi));
}

void require_range_given(const AvoidQuestion& question, const char* example) {
  if (!question.lo)
    throw Error("'" + std::string(name_of(*question.how)) +
                "' has no range of its own: give lo and hi, as in " + example);
}

/// Whether the object has, or can get, a plan, which has every start and every velocity; or there is no object.
bool needs_no_column(const AvoidQuestion& question) {
  return question.plan || takes_plan(question) || question.record.empty();
}

bool stores_start(const AvoidQuestion& question) {
  return question.own_scene->layout.has_t && (!question.lacks_t || needs_no_column(question));
}

bool stores_velocity(const AvoidQuestion& question) {
  return question.own_scene->layout.law != Law::rest &&
         (!question.lacks_velocity || needs_no_column(question));
}

/// The table must have the columns that the manoeuvre changes.
void require_columns(const AvoidQuestion& question) {
  const Layout& layout = question.own_scene->layout;
  const std::string& name = question.own_scene->name;
  const auto how = question.how;
  if (!how) return;
  if (question.on_globe &&
      (*how == Manoeuvre::turn || *how == Manoeuvre::climb || *how == Manoeuvre::accelerate))
    throw Error("'" + std::string(name_of(*how)) + "' is for tables on a plane, " + name +
                " is on the globe; write 'speed', 'delay' or 'wait'");
  if (*how == Manoeuvre::turn && layout.axes < 2)
    throw Error("a turn needs x and y: " + name + " has one axis; write 'speed'");
  if (*how == Manoeuvre::climb) {
    require_range_given(question, "'climb', -5, 5");
    if (layout.axes < 3) throw Error("'climb' changes vz: " + name + " has no z");
    if (!stores_velocity(question)) throw Error("'climb' changes vz: declare vx, vy, vz in " + name);
  }
  if (*how == Manoeuvre::accelerate) {
    require_range_given(question, "'accelerate', -1, 1");
    if (layout.law != Law::accelerated && layout.law != Law::forced)
      throw Error("'accelerate' changes an acceleration or a force: declare ax … or fx … with m in " + name);
  }
  if (*how == Manoeuvre::wait) {
    require_range_given(question, "'wait', 0, 600");
    if (*question.lo < 0)
      throw Error("a 'wait' is not less than 0; write lo = 0 or more, not " + shown(*question.lo));
  }
  if (*how == Manoeuvre::delay) {
    require_range_given(question, "'delay', 0, 600");
    if (!stores_start(question)) throw Error("'delay' changes t: declare t in " + name);
    if (!question.now_given)
      throw Error("'delay' needs now: nothing can start before it; write WHERE now = ...");
  }
}

/// How long a change lasts.
void require_resume(const AvoidQuestion& question) {
  if (!question.resume) return;
  const double resume = *question.resume;
  require_finite("resume", resume);
  if (!(resume > 0)) throw Error("resume must be greater than 0, not " + shown(resume) + ": write a time");
  const Manoeuvre how = question.how.value_or(Manoeuvre::turn);
  if (how != Manoeuvre::turn && how != Manoeuvre::speed && how != Manoeuvre::climb)
    throw Error("resume ends a 'turn', 'speed' or 'climb', not '" + std::string(name_of(how)) +
                "': leave it out");
  if (question.on_globe)
    throw Error("resume is for tables on a plane, " + question.own_scene->name +
                " is on the globe; leave it out");
}

void require_no_meshes(const AvoidQuestion& question) {
  const auto require = [](const std::string& name, const Layout& layout) {
    if (layout.shape == Shape::mesh)
      throw Error(
          "meshes of " + name +
          " are not examined: declare hz beside shape for prisms, or query a table with r around each");
  };
  require(question.own_scene->name, question.own_scene->layout);
  if (question.also) require(question.also->name, question.also->layout());
}

/// The object, its table, and the record that has its numbers.
void require_object(const AvoidQuestion& question) {
  require_set(question.own_scene != nullptr, "predictive_avoid has no object", "AvoidQuestion::own_scene");
  const Scene& own = *question.own_scene;
  const std::string& name = own.name;
  require_layout(name, own.layout);
  const Offsets at = record_offsets(own.layout);
  const auto size = static_cast<std::size_t>(at.size);
  if (own.ids.empty() && question.record.empty()) return;
  if (question.record.size() != size)
    throw Error(name + ": a record has " + std::to_string(size) + " numbers, not " +
                std::to_string(question.record.size()) + "; set AvoidQuestion::record");
  if (own.ids.empty()) return;
  require_numbers(name, own.ids[0], number_columns(own.layout, at), at, question.record.data());
}

std::shared_ptr<const Scene> no_objects(const std::string& name, const Layout& layout) {
  auto none = std::make_shared<Scene>();
  none->name = name;
  none->layout = layout;
  return none;
}

/// Throws what a join of the two tables throws.
void require_join(const AvoidQuestion& question, const SearchTarget& others) {
  JoinQuestion join{.a = no_objects(question.own_scene->name, question.own_scene->layout),
                    .b = no_objects(others.name, others.layout())};
  join.now = question.now;
  join.h = question.h;
  join.within = question.within;
  join.within_z = question.within_z;
  require_valid(join);
  contact_of(join);
}

/// The first delay: lo. If that is now - t as SQL computes it, rounded, the object may start before `now`: then the
/// smallest one after which it does not.
double first_delay(const AvoidQuestion& question, const OwnMotion& stored) {
  double lo = *question.lo;
  if (stored.t + lo < question.now) {
    const double given = std::exchange(lo, question.now - stored.t);
    const bool is_rounded = given == lo;
    while (stored.t + lo < question.now) lo = std::nextafter(lo, 0.0);
    if (!is_rounded)
      throw Error(
          "'delay' cannot make an object start before now: lo must not be less than now - t, which is " +
          shown(lo) + "; lo is " + shown(given));
  }
  if (lo < 0 && grows(question.own_scene->layout))
    throw Error("'delay' with lo = " + shown(lo) +
                " is not supported for objects that grow; write lo >= 0 for " + question.own_scene->name);
  return lo;
}

/// A velocity that has grown until the start of the manoeuvre must be stored, too.
void require_velocity_at_start(const AvoidQuestion& question, const OwnState& own) {
  if (stores_velocity(question) || own.base.v == std::array<double, 3>{}) return;
  throw Error(question.own_scene->name + ": row " + std::to_string(question.own_scene->ids[0]) +
              " has a velocity at " + shown(own.base.t) +
              ", which no column stores: declare vx …, or write now = " + shown(own.stored.t));
}

void require_one_heading(const AvoidQuestion& question) {
  const Layout& layout = question.own_scene->layout;
  if (!question.wants_plan || !takes_plan(question) || !question.resume) return;
  if (question.how.value_or(Manoeuvre::turn) != Manoeuvre::turn || !layout.has_heading || !question.form)
    return;
  throw Error(
      "a 'turn' with resume turns the outline back, and a plan has one heading: leave plan out and store the "
      "first leg, or leave resume out");
}

void require_manoeuvre_of_plan(const AvoidQuestion& question) {
  if (question.how == Manoeuvre::delay || question.how == Manoeuvre::wait) return;
  throw Error(question.own_scene->name + ": row " + std::to_string(question.own_scene->ids[0]) +
              " has a plan: write 'wait' or 'delay' with lo and hi, as in 'wait', 0, 600");
}

}  // namespace

Manoeuvre manoeuvre_of(std::string_view name) {
  for (const Manoeuvre known : {Manoeuvre::turn, Manoeuvre::speed, Manoeuvre::climb, Manoeuvre::accelerate,
                                Manoeuvre::delay, Manoeuvre::wait})
    if (name == name_of(known)) return known;
  throw Error("how must be 'turn', 'speed', 'climb', 'accelerate', 'delay' or 'wait', not '" +
              std::string(name) + "'");
}

Touching touching_of(std::string_view name) {
  if (name == "part") return Touching::part;
  if (name == "ignore") return Touching::ignore;
  throw Error("touching must be 'part' or 'ignore', not '" + std::string(name) + "'");
}

void require_valid(const AvoidQuestion& question) {
  require_object(question);
  require_target(question.others, "predictive_avoid has no objects to avoid", "AvoidQuestion::others");
  if (question.also) require_target(*question.also, "a second table has no objects", "AvoidQuestion::also");
  require_range(question);
  require_columns(question);
  require_resume(question);
  require_no_meshes(question);
  require_join(question, question.others);
  if (question.also) require_join(question, *question.also);
  require_one_heading(question);
  if (!stores_start(question) && question.now != 0)
    throw Error("now must be 0 in a table without t: write now = 0, or declare t in " +
                question.own_scene->name + "; a change from " + shown(question.now) +
                " on cannot be stored there");
}

bool turns_with_course(const AvoidQuestion& question, const Changes& changes) {
  return changes.turns() && question.own_scene->layout.has_heading && question.form;
}

std::vector<QueriedChanges> queried_changes(const AvoidQuestion& question, const OwnState& own) {
  if (question.plan) require_manoeuvre_of_plan(question);
  if (question.how != Manoeuvre::delay) require_velocity_at_start(question, own);
  const double m = speed_of(own.base);
  std::vector<QueriedChanges> queried;
  const auto add = [&](Manoeuvre manoeuvre, double lo, double hi) {
    queried.push_back({manoeuvre, question.lo.value_or(lo), question.hi.value_or(hi)});
    require_width(queried.back().lo, queried.back().hi);
  };
  const bool moves = m > 0 && std::isfinite(m);
  if (!question.how && question.own_scene->layout.axes > 1) add(Manoeuvre::turn, -180, 180);
  if (!question.how && moves) add(Manoeuvre::speed, -m, m);
  if (!question.how) return queried;
  switch (*question.how) {
    case Manoeuvre::turn:
      add(Manoeuvre::turn, -180, 180);
      break;
    case Manoeuvre::speed:
    case Manoeuvre::accelerate:
      if (moves) add(*question.how, -m, m);
      break;
    case Manoeuvre::climb:
      add(Manoeuvre::climb, 0, 0);
      break;
    case Manoeuvre::wait:
      add(Manoeuvre::wait, 0, 0);
      break;
    case Manoeuvre::delay:
      if (own.stored.t < question.now) break;
      queried.push_back({Manoeuvre::delay, first_delay(question, own.stored), *question.hi});
      queried.back().hi = std::max(queried.back().hi, queried.back().lo);
      require_width(queried.back().lo, queried.back().hi);
      break;
  }
  return queried;
}

}  // namespace foresee
