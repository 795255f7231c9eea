// The inputs and rows of a query for manoeuvres that avoid contact, and the checks of the inputs.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "motion/manoeuvre.h"
#include "motion/plan/plan.h"
#include "query/scene.h"

namespace foresee {

class Changes;
struct OwnState;

/// What is required of objects that touch already when the manoeuvre starts.
enum class Touching : std::uint8_t {
  part,   ///< the distance of the centres never decreases while they touch, and they do not touch again
  ignore  ///< nothing
};

struct AvoidQuestion {
  std::shared_ptr<const Scene> own_scene = nullptr;  ///< the object that changes, or no object; must be set
  /// Its numbers as they are stored (OwnState::record may have t and until besides); empty: no object.
  std::vector<double> record = {};
  std::shared_ptr<const Form> form = {};  ///< its outline, or null
  std::shared_ptr<const Plan> plan = {};  ///< or null; own_scene has its legs
  /// No column of its table stores the t of its records, or the velocity: a table with plans has both without columns.
  bool lacks_t = false;
  bool lacks_velocity = false;
  SearchTarget others = {};  ///< its table: the object with its id is left out
  std::optional<SearchTarget> also = {};
  double now = 0;
  bool now_given = false;
  double h = 0;
  double within = 0;
  std::optional<double> within_z = {};
  std::optional<Manoeuvre> how = {};       ///< default: turn and speed; on one axis speed
  std::optional<double> lo = {}, hi = {};  ///< default: those of the manoeuvre
  Touching touching = Touching::part;
  std::optional<double> resume = {};  ///< a turn, speed or climb lasts so long; default: it lasts
  bool on_globe = false;              ///< paths bend towards the Earth, and another speed or start keeps them
  bool wants_motion = true;           ///< record
  bool wants_ends = true;             ///< below, above
  bool wants_plan = false;            ///< plan
  bool in_degrees = false;  ///< the table stores knots only: their legs may differ in the last digits
};

/// The object that is touched at an end of a row.
struct Blocker {
  std::int64_t id;
  int table;  ///< 0: others, 1: also
  double t;   ///< as of predictive_join, for the first change that certainly touches
};

struct AvoidRow {
  Manoeuvre manoeuvre;
  bool clear;
  double k_from, k_to, k;
  std::vector<double> record;  ///< to be stored for k; empty if it is not wanted
  std::optional<Blocker> below, above;
  /// To be stored for k, of what has several legs; else, or if it is not wanted, nothing.
  std::optional<Plan> plan = {};
};

/// Throws Error for an unknown name, listing the known ones.
Manoeuvre manoeuvre_of(std::string_view name);
Touching touching_of(std::string_view name);

/// Whether the object's table can store an object without a plan as one: its motion then needs no other column.
inline bool takes_plan(const AvoidQuestion& question) {
  return question.own_scene->layout.has_plan && !question.in_degrees;
}

/// Throws Error for everything that is wrong for any object: numbers that are not limits, shapes without a
/// distance, a range that the manoeuvre cannot have. Also for columns that the table does not declare.
void require_valid(const AvoidQuestion& question);

/// Whether the outline of the object rotates with its course.
bool turns_with_course(const AvoidQuestion& question, const Changes& changes);

/// A manoeuvre and the range of changes that is queried.
struct QueriedChanges {
  Manoeuvre manoeuvre;
  double lo, hi;
};
/// The manoeuvres and ranges of a valid `question`. Empty if the object has no course for them, or has started. Throws
/// Error for a delay to before now, and for what an object with a plan cannot do.
std::vector<QueriedChanges> queried_changes(const AvoidQuestion& question, const OwnState& own);

}  // namespace foresee
