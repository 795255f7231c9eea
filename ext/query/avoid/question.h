// What is asked about measures to avoid collision, and what does a row of the answer hold? The words in which
// the stages of avoid.h and SQL's function speak of it.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "motion/manoeuvre.h"
#include "query/scene.h"
#include "query/search_target.h"

namespace foresee {

/// What is asked of who touches the object already when the change is made.
enum class Touching : std::uint8_t {
  part,   ///< the distance of the centres never shrinks while they touch, and they do not touch again
  ignore  ///< nothing
};

struct AvoidQuestion {
  std::shared_ptr<const Scene> own;       ///< the object that changes, or nobody
  std::vector<double> record;             ///< its numbers as they are stored; empty: nobody
  std::shared_ptr<const Form> form = {};  ///< the outline that it has; null: none
  SearchTarget others;                    ///< own's table: an object with own's id is own itself
  std::optional<SearchTarget> also = {};
  double now = 0;
  bool now_given = false;
  double h = 0;
  double within = 0;
  std::optional<double> within_z = {};
  std::optional<Manoeuvre> how = {};       ///< none: turn and speed; on one axis speed
  std::optional<double> lo = {}, hi = {};  ///< none: what the manoeuvre has by default
  Touching touching = Touching::part;
  bool wants_motion = true;  ///< record
  bool wants_ends = true;    ///< below, above
};

/// Who is touched at an end of a row.
struct Blocker {
  std::int64_t id;
  int table;  ///< 0: others, 1: also
  double t;   ///< predictive_join's, of the first change that certainly touches
};

struct AvoidRow {
  Manoeuvre manoeuvre;
  bool clear;
  double k_from, k_to, k;
  std::vector<double> record;  ///< to be stored for k; empty where it is not wanted
  std::optional<Blocker> below, above;
};

/// Throws Error for an unknown name, listing the known ones.
Manoeuvre manoeuvre_of(std::string_view name);
Touching touching_of(std::string_view name);

/// Throws Error for all that is wrong with a question whoever the object is: numbers that are no limits, a
/// range that the manoeuvre cannot have, columns that the table does not declare, shapes without a distance.
void require_valid(const AvoidQuestion& question);

/// Whether what the object looks like turns too.
bool turns_with_course(const AvoidQuestion& question, Manoeuvre manoeuvre);

/// A manoeuvre and the changes asked about.
struct QueriedChanges {
  Manoeuvre manoeuvre;
  double lo, hi;
};
/// Those of a valid question about an object of this motion, and the same as of the change; none where the
/// object has no course for them, or has started. Throws Error for a delay that would begin before now.
std::vector<QueriedChanges> queried_changes(const AvoidQuestion& question, const OwnMotion& stored,
                                            const OwnMotion& base);

}  // namespace foresee
