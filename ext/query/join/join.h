// Which pairs will meet, and when? predictive_join as a library call: candidates, contact, rows.
//
//   Join join({.a = ships, .now = 600, .h = 600, .within = 926}, interrupt);
//   while (auto rows = join.next(); !rows.empty())
//     for (const JoinRow& row : rows) use(row.a, row.b, row.contact.t);
//
// Guarantee: every pair that touches during [now, now + h] comes exactly once, whatever the method; in a
// self-join a < b. A scene joined with itself as two sides (b == a) gives every such pair in both orders, and
// never an object with itself. Columns that `wants` leaves out are not computed.
//
// Rows come in the order that is asked for. The grid answers long horizons in time slabs (time_slabs.h), and
// questions for an order in slabs that begin short: whoever stops after the first rows does not pay for the
// others. With helpers (slab_helpers.h) rows and their order are the same. Memory: the scenes, about a
// hundred bytes an object, one batch of pairs, and 24 bytes for each row of a slab that has to be sorted, or
// for some times as many as are read of it (likely_rows).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "contact/contact.h"
#include "index/candidates.h"
#include "index/gpcd_grid/work_space.h"
#include "query/scene.h"

namespace foresee::query {

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
struct AskedTimes {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  bool holds(double time) const { return least <= time && time <= most; }
  bool are_all() const { return least == AskedTimes{}.least && most == AskedTimes{}.most; }
};

/// By dt that is above 0: pairs that touch already are left out.
inline constexpr AskedTimes after_now{std::numeric_limits<double>::denorm_min()};

inline constexpr std::size_t all_rows = std::numeric_limits<std::size_t>::max();

enum class JoinOrder : std::uint8_t {
  any,
  by_t,  ///< rising
  by_dt,
  by_t_and_ids,  ///< by t, a, b
};

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
  AskedTimes asked_t = {}, asked_dt = {};
  JoinOrder order = JoinOrder::any;
  std::size_t likely_rows = all_rows;  ///< that will be read; of more, in an order, some are found twice
  JoinWants wants = {};
  std::size_t helpers = 0;                     ///< threads that the grid may use beside the caller's
  std::shared_ptr<GridSpace> space = nullptr;  ///< memory kept between joins, not shared by two at a time

  bool asks_about_all_times() const { return asked_t.are_all() && asked_dt.are_all(); }
};

struct JoinRow {
  JoinRow() {}  // not even zeros in columns that are not wanted
  std::int64_t a, b;
  ContactTimes contact;
  ClosestApproach approach;
};

class Join {
 public:
  /// Throws Error for a wrong question (h, within or within_z negative or not finite; now not finite;
  /// different axes; shapes without a distance). `interrupt` must outlive the join.
  Join(JoinQuestion question, Interrupt& interrupt);
  ~Join();
  Join(const Join&) = delete;
  Join& operator=(const Join&) = delete;

  /// The next rows, some thousands at most; empty once there are none left. Valid until the next call.
  std::span<const JoinRow> next();

 private:
  struct Progress;

  std::unique_ptr<Progress> progress_;
};

}  // namespace foresee::query
