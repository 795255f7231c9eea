// Which pairs will meet, and when? predictive_join as a library call: candidates, contact, rows.
//
//   Join join({.a = ships, .now = 600, .h = 600, .within = 926}, interrupt);
//   while (auto rows = join.next(); !rows.empty())
//     for (const JoinRow& row : rows) use(row.a, row.b, row.contact.t);
//
// Guarantee: every pair that touches during [now, now + h] comes exactly once, whatever the method; in a
// self-join a < b. A scene joined with itself as two sides (b == a) gives every such pair in both orders, and
// never an object with itself. Rows come in no particular order. Columns that `wants` leaves out are not
// computed. Memory: the scenes, one swept box an object, and one batch of pairs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "contact/contact.h"
#include "index/candidates.h"
#include "index/gpcd_grid/work_space.h"
#include "motion/error.h"
#include "query/scene.h"

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

struct JoinQuestion {
  std::shared_ptr<const Scene> a;
  std::shared_ptr<const Scene> b = nullptr;  ///< null: pairs within a, each once
  double now = 0;
  double h = 0;
  double within = 0;
  std::optional<double> within_z = {};
  JoinMethod method = JoinMethod::automatic;  ///< tree: both scenes have an outline
  std::optional<std::int64_t> only_a = {};  ///< only pairs whose column a has this id: linear in the objects
  std::optional<std::int64_t> only_b = {};
  bool skip_touching = false;  ///< leave out pairs that touch at `now` already: dt = 0
  JoinWants wants = {};
  std::shared_ptr<GridSpace> space = nullptr;  ///< memory kept between joins, not shared by two at a time
};

struct JoinRow {
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
  template <class Work>
  void in_slices(std::size_t count, Work work);
  void keep_asked_pairs();
  void find_hits();
  void make_rows();

  JoinQuestion question_;
  Interrupt& interrupt_;
  std::unique_ptr<Contact> contact_;
  std::unique_ptr<Candidates> candidates_;
  std::vector<Pair> pairs_, hits_;
  std::vector<ContactTimes> times_;
  std::vector<ClosestApproach> approaches_;
  std::vector<JoinRow> rows_;
};

}  // namespace foresee
