// What is asked of a join, and what does a row of its answer hold? The words in which join, plan, stages and
// SQL's functions speak of it.
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
#include "query/scene.h"
#include "query/sweep_margin.h"
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

/// Both ends included. Rows outside are left out.
struct QueriedTimes {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  bool holds(double time) const { return min <= time && time <= max; }
  bool are_all() const { return min == QueriedTimes{}.min && max == QueriedTimes{}.max; }
};

inline constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

enum class JoinOrder : std::uint8_t {
  any,
  by_t,  ///< rising
  by_dt,
  by_t_and_ids,  ///< by t, a, b
};

struct Ownership;

struct JoinQuestion {
  std::shared_ptr<const Scene> a;
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
  std::size_t likely_rows = all_rows;  ///< that will be read; of more, in an order, some are found twice
  JoinWants wants = {};
  std::size_t helpers = 0;                     ///< threads that the grid may use beside the caller's
  std::shared_ptr<GridSpace> space = nullptr;  ///< memory kept between joins, not shared by two at a time
  std::shared_ptr<const Ownership> own =
      nullptr;  ///< of the tile, by in_tile() (tile_scenes.h); null: all pairs

  bool queries_all_times() const { return queried_t.are_all() && queried_dt.are_all(); }
};

struct JoinRow {
  JoinRow() {}  // not even zeros in columns that are not wanted
  std::int64_t a, b;
  ContactTimes contact;
  ClosestApproach approach;
};

/// Throws Error for h, within or within_z that is negative or not finite, for now that is not finite, for
/// different axes, and for a tile that is empty or bounded on an axis that is not there.
void require_valid(const JoinQuestion& question);

/// The contact that decides this question's pairs: make_contact() with its scenes, which must outlive the
/// contact, and its limits; or the same about the smallest boxes around outlines
/// and meshes.
std::unique_ptr<Contact> contact_of(const JoinQuestion& question, bool rectangles_for_outlines = false);

}  // namespace foresee
