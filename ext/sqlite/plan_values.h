// Conversion of SQL values into plans of a table, and of stored plans into SQL values.
//
//   const PlanValues plans(declaration, interrupt);
//   const Plan plan = plans.stored(std::move(*plans.written(value)), origin);   // metres, legs checked
//   result_plan(context, plans.shown(plan, frame), interrupt);
//
// A table of metres stores a plan as it is written. A table in degrees takes knots as longitude and latitude; each one
// is projected, to the bits of its columns lat, lon, and legs are straight on the plane. Such knots read back within
// 1e-9 degrees. Throws Error, without table and row, for a value that is no plan of the table. Cost: that of
// plan_text.h or packed_legs.h; in degrees a microsecond or two per knot.
#pragma once

#include <optional>
#include <vector>

#include "base/error.h"
#include "base/text/wkt_lexer.h"
#include "database/sqlite_api.h"
#include "format/declaration.h"
#include "geography/frame.h"
#include "motion/plan/plan.h"

namespace foresee {

/// Text or blob; nothing for NULL and ''. Throws Error for a value that is no plan.
std::optional<Plan> plan_of(sqlite3_value* value, Interrupt& interrupt, WktUnit unit = WktUnit::metres);

/// Text of well-known words, or a blob. Requires for a text: PlanKind::knots on two or three axes.
void result_plan(sqlite3_context* context, const Plan& plan, bool as_text, Interrupt& interrupt);
/// Text wherever a text holds the plan, else a blob.
void result_plan(sqlite3_context* context, const Plan& plan, Interrupt& interrupt);

/// Throws Error unless the plan has knots whose first two axes can be longitude and latitude.
void require_places(const Plan& plan);
/// A knot of longitude and latitude on the plane of `frame`, and back as columns show it. Throws Error for numbers
/// that are not a place, or one beyond 1500 km from the origin.
Knot knot_on_plane(const Plan& plan, std::size_t knot, const Frame& frame);
Knot knot_in_degrees(const Knot& knot, const Frame& frame);

/// How many of the first doubles of a record are those of its first leg: t, x…, v…, a…. Requires: a layout with plans.
std::size_t leg_doubles(const Layout& layout);

class PlanValues {
 public:
  /// Requires: a layout with plans; `interrupt` outlives the values.
  PlanValues(const Declaration& declaration, Interrupt& interrupt)
      : layout_(declaration.layout), in_degrees_(declaration.frame.in_degrees()), interrupt_(interrupt) {}

  /// As it is written: on the axes of the table, in degrees if that is; nothing for NULL and ''.
  std::optional<Plan> written(sqlite3_value* value) const;
  /// The plan as the store takes it. `origin`: of a table in degrees. Throws Error for a place that the table cannot
  /// store.
  Plan stored(Plan written, const std::optional<LatLon>& origin) const;
  /// A stored plan as the column shows it. `frame`: of the store.
  Plan shown(const Plan& stored, const Frame& frame) const;

 private:
  Layout layout_;
  bool in_degrees_;
  Interrupt& interrupt_;
};

}  // namespace foresee
