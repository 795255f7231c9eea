// Parameters of a join, its rows and its exact contact test, shared by join, plan, stages and SQL functions.
//
//   JoinQuestion question{.a = ships, .b = ferries, .now = 600, .h = 600, .within = 926};
//   require_valid(question);
//   auto contact = contact_of(question);
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include "contact/contact.h"
#include "index/gpcd_grid/work_space.h"
#include "query/margin.h"
#include "query/scene.h"
#include "query/tile/tile.h"

namespace foresee {

enum class JoinMethod : std::uint8_t { automatic, grid, tree, scan, gpcd };

/// Throws Error for an unknown name, listing the known ones.
JoinMethod join_method(std::string_view name);
const char* name_of(JoinMethod method);

struct JoinWants {
  bool contact = true;   ///< t, dt
  bool ends = true;      ///< t_end, dt_end; only together with contact
  bool approach = true;  ///< t_cpa, dt_cpa, d_cpa
};

/// Closed interval of times; rows outside are left out.
struct QueriedTimes {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  bool holds(double time) const { return min <= time && time <= max; }
  bool are_all() const { return min == QueriedTimes{}.min && max == QueriedTimes{}.max; }
};

inline constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

enum class JoinOrder : std::uint8_t {
  any,
  by_t,  ///< ascending
  by_dt,
  by_t_and_ids,  ///< by t, a, b
};

struct Ownership;
struct PairKinds;

/// A join: its scenes, the query, the resources that it may use, and what Join derives from these.
struct JoinQuestion {
  std::shared_ptr<const Scene> a = nullptr;  ///< must be set
  std::shared_ptr<const Scene> b = nullptr;  ///< null: pairs within a, each once
  double now = 0;
  double h = 0;
  double within = 0;
  std::optional<double> within_z = {};
  JoinMethod method = JoinMethod::automatic;  ///< tree: both scenes have levels
  std::optional<std::int64_t> only_a = {};  ///< only pairs whose column a has this id: linear in the objects
  std::optional<std::int64_t> only_b = {};
  std::optional<Tile> tile = {};  ///< only pairs that it owns
  QueriedTimes queried_t = {}, queried_dt = {};
  JoinOrder order = JoinOrder::any;
  std::size_t likely_rows = all_rows;  ///< to be read; in an ordered join, reading more repeats work
  JoinWants wants = {};
  /// Threads that the grid may use besides the caller's: at most 16, or twice the machine's processors if that is more.
  std::size_t helpers = 0;
  std::shared_ptr<GridSpace> space = nullptr;  ///< memory kept between joins, not shared by two at a time
  /// Of the tile; null: all pairs. Join sets it by in_tile() (join_scenes.h).
  std::shared_ptr<const Ownership> own = nullptr;
  /// Null: all pairs may meet. Join sets it by with_kinds() (pair_kinds.h).
  std::shared_ptr<const PairKinds> kinds = nullptr;
  /// A row for each contact of a pair, not for outlines and meshes; else for the first.
  bool all_contacts = false;

  /// Side b, which is a for pairs within one scene.
  const Scene& side_b() const { return b ? *b : *a; }
  bool queries_all_times() const { return queried_t.are_all() && queried_dt.are_all(); }
};

struct JoinRow {
  JoinRow() {}  // leaves columns that are not wanted uninitialized
  std::int64_t a, b;
  ContactTimes contact;
  ClosestApproach approach;
};

/// Whether an object of either side may have a plan: then rows of a scene are legs, and ids repeat.
inline bool has_plans(const JoinQuestion& question) {
  return question.a->layout.has_plan || (question.b && question.b->layout.has_plan);
}

/// Whether paths of either side may bend: then two rows may be in contact more than once.
inline bool has_bent_paths(const JoinQuestion& question) {
  const auto is_bent = [](const Scene& scene) { return degree_of(scene.layout.law) > 1; };
  return is_bent(*question.a) || (question.b && is_bent(*question.b));
}

/// Whether a pair may have several rows. Straight paths of two objects meet once at most.
inline bool may_repeat_pairs(const JoinQuestion& question) {
  return question.all_contacts && (has_plans(question) || has_bent_paths(question));
}

/// Throws Error if h, within or within_z is negative or not finite, now is not finite, or the axes of both
/// scenes differ. Also if the tile is empty or has a bound on an axis that the scenes do not have. Also if scene a is
/// missing, if the sizes of a scene do not fit its layout, and for the method tree if a scene has no levels.
void require_valid(const JoinQuestion& question);

/// The inflation of the swept boxes of both sides together. Throws Error for shapes without a distance.
PairRule::Reach reach_of(const JoinQuestion& question);

/// Half of reach_of(), rounded up: the inflation of the swept boxes of each side.
template <int D>
Vec<D> margin_of(const JoinQuestion& question) {
  return margin_of<D>(reach_of(question));
}

/// The contact test for the pairs of `question`: make_contact() with its scenes, which must outlive it, and
/// its distances. With `rectangles_for_outlines` the smallest boxes take the place of outlines and meshes.
std::unique_ptr<Contact> contact_of(const JoinQuestion& question, bool rectangles_for_outlines = false);

}  // namespace foresee
