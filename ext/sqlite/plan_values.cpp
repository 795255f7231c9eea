#include "sqlite/plan_values.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>
#include <string>

#include "base/error.h"
#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "base/number_text.h"
#include "database/statement.h"
#include "database/value_text.h"
#include "motion/plan/packed_legs.h"
#include "motion/plan/plan_legs.h"
#include "motion/plan/plan_text.h"

namespace foresee {
namespace {

/// The words for a plan on so many axes.
std::string example_on(int axes) {
  return axes == 2 ? "LINESTRING M" : axes == 3 ? "LINESTRING ZM" : "plan_points(t, x)";
}

void require_axes(const Plan& plan, int axes) {
  if (plan.axes == axes) return;
  std::string message = std::to_string(plan.axes) + (plan.axes == 1 ? " axis" : " axes") +
                        ", and the table has " + std::to_string(axes) + ": write " + example_on(axes);
  if (plan.axes > axes) message += std::string(", or declare ") + (plan.axes == 3 ? "z" : "y");
  if (plan.axes == 2 && axes == 3 && plan.kind != PlanKind::knots)
    message += ", or give the legs of plan_rows a z and a vz";
  throw Error(message);
}

/// The acceleration of a plan needs columns, from which it can be read.
void require_law(const Plan& plan, const Layout& layout) {
  if (plan.kind != PlanKind::accelerated || layout.law == Law::accelerated) return;
  std::string columns;
  for (int axis = 0; axis < layout.axes; ++axis)
    columns += (axis == 0 ? std::string("a") : std::string(", a")) + "xyz"[axis];
  throw Error("a blob of accelerated legs: declare " + columns);
}

/// "knot 3": counted from 1 through all parts.
std::string name_of(std::size_t knot) {
  return "knot " + std::to_string(knot + 1);
}

LatLon place_of_knot(const Plan& plan, std::size_t knot) {
  const auto [lon, lat] = std::pair(plan.knots[knot].x[0], plan.knots[knot].x[1]);
  if (!(std::abs(lat) <= 90))
    throw Error(name_of(knot) + " has latitude " + shown(lat) +
                ", beyond 90: write longitude, then latitude");
  if (!(std::abs(lon) <= 180))
    throw Error(name_of(knot) + " has longitude " + shown(lon) + ", beyond 180: write " +
                shown(std::remainder(lon, 360)));
  return {lat, lon};
}

void require_near_origin(const Metres& point, std::size_t knot, const LatLon& origin) {
  const double distance = std::hypot(point.x[0], point.x[1]);
  if (distance <= max_distance_from_origin) return;
  throw Error(name_of(knot) + " is " + shown(std::ceil(distance / 1000)) + " km from the origin '" +
              origin_text(origin) + "', the limit is 1500: write longitude first, or a nearer origin");
}

}  // namespace

std::optional<Plan> plan_of(sqlite3_value* value, Interrupt& interrupt, WktUnit unit) {
  if (is_null_or_empty(value)) return std::nullopt;
  const int type = sqlite3_value_type(value);
  if (type == SQLITE_TEXT) return read_plan(text_of(value), interrupt, unit);
  if (type != SQLITE_BLOB)
    throw Error(shown(value) + " is no plan: write text as in 'LINESTRING M(0 0 0, 4 0 9)', or a blob");
  const auto size = static_cast<std::size_t>(sqlite3_value_bytes(value));
  const auto* bytes = static_cast<const std::byte*>(sqlite3_value_blob(value));
  if (size > 0 && bytes == nullptr) throw std::bad_alloc();
  return decode_plan({bytes, size}, interrupt);
}

void result_plan(sqlite3_context* context, const Plan& plan, bool as_text, Interrupt& interrupt) {
  if (as_text) {
    const std::string text = write_plan(plan, interrupt);
    sqlite3_result_text64(context, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  } else {
    const std::vector<std::byte> blob = encode_plan(plan, interrupt);
    sqlite3_result_blob64(context, blob.data(), blob.size(), SQLITE_TRANSIENT);
  }
}

void result_plan(sqlite3_context* context, const Plan& plan, Interrupt& interrupt) {
  result_plan(context, plan, plan.kind == PlanKind::knots && plan.axes > 1, interrupt);
}

void require_places(const Plan& plan) {
  if (plan.axes < 2) require_axes(plan, 2);
  if (plan.kind != PlanKind::knots)
    throw Error(
        "a blob of legs with velocities: with lat, lon a plan has knots; "
        "write plan_points(t, lon, lat)");
}

Knot knot_on_plane(const Plan& plan, std::size_t knot, const Frame& frame) {
  const Metres point = frame.to_metres({{place_of_knot(plan, knot), {}}, 0, 0});
  require_near_origin(point, knot, *frame.origin);
  const Knot& written = plan.knots[knot];
  return {written.t, {point.x[0], point.x[1], written.x[2]}};
}

Knot knot_in_degrees(const Knot& knot, const Frame& frame) {
  const LatLon place = frame.shown({{knot.x[0], knot.x[1], 0}, {}}).fix.place;
  return {knot.t, {place.lon, place.lat, knot.x[2]}};
}

std::size_t leg_doubles(const Layout& layout) {
  const Offsets at = record_offsets(layout);
  return static_cast<std::size_t>((at.a == Offsets::absent ? at.v : at.a) + layout.axes);
}

std::optional<Plan> PlanValues::written(sqlite3_value* value) const {
  std::optional<Plan> plan = plan_of(value, interrupt_, in_degrees_ ? WktUnit::degrees : WktUnit::metres);
  if (!plan) return plan;
  require_axes(*plan, layout_.axes);
  check_size(*plan);
  if (in_degrees_) require_places(*plan);
  require_law(*plan, layout_);
  return plan;
}

Plan PlanValues::stored(Plan written, const std::optional<LatLon>& origin) const {
  if (!in_degrees_) return written;
  Plan plan = written;
  const FloatEnvironment environment;
  const Frame frame{.kind = FrameKind::degrees, .origin = origin};
  Steps steps(interrupt_);
  for (std::size_t i = 0; i < plan.knots.size(); ++i) {
    steps.costly(1000);
    plan.knots[i] = knot_on_plane(written, i, frame);
  }
  return plan;
}

Plan PlanValues::shown(const Plan& stored, const Frame& frame) const {
  Plan plan = stored;
  if (!in_degrees_) return plan;
  const FloatEnvironment environment;
  Steps steps(interrupt_);
  for (Knot& knot : plan.knots) {
    steps.costly(1000);
    knot = knot_in_degrees(knot, frame);
  }
  return plan;
}

}  // namespace foresee
