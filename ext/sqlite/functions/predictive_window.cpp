// predictive_window(h, …) in SQL: reads the inputs, opens the table, and returns the rows.
#include "geography/zone.h"
#include "query/window/window.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"
#include "sqlite/functions/join_inputs.h"
#include "sqlite/functions/searched_table.h"
#include "sqlite/functions/table_functions.h"

namespace foresee {
namespace {

constexpr ColumnList window_outputs{"id INTEGER", "t REAL", "t_end REAL", "dt REAL", "dt_end REAL"};
constexpr int out_id = window_outputs["id"], out_t = window_outputs["t"], out_t_end = window_outputs["t_end"],
              out_dt = window_outputs["dt"], out_dt_end = window_outputs["dt_end"];
constexpr ColumnList window_inputs{"h",   "tbl", "x0",  "x1",     "y0",     "y1",   "z0",   "z1",      "now",
                                   "wvx", "wvy", "wvz", "method", "schema", "zone", "mask", "contacts"};
constexpr int in_h = window_inputs["h"], in_tbl = window_inputs["tbl"], in_x0 = window_inputs["x0"],
              in_now = window_inputs["now"], in_wvx = window_inputs["wvx"],
              in_method = window_inputs["method"], in_schema = window_inputs["schema"],
              in_zone = window_inputs["zone"], in_mask = window_inputs["mask"],
              in_contacts = window_inputs["contacts"];

class WindowRows final : public FunctionRows {
 public:
  WindowRows(WindowQuestion question, Interrupt& interrupt)
      : has_starts_(question.wants.starts || question.all_contacts),
        has_ends_(question.wants.ends || question.all_contacts),
        window_(std::move(question), interrupt) {}

  bool next() override {
    if (++row_ >= batch_.size()) {
      batch_ = window_.next();
      row_ = 0;
    }
    return !batch_.empty();
  }

  void output(sqlite3_context* context, int output) const override {
    const WindowRow& row = batch_[row_];
    const ContactTimes& contact = row.contact;
    const bool is_end = output == out_t_end || output == out_dt_end;
    if (output != out_id && !(is_end ? has_ends_ : has_starts_)) return;  // as in JoinRows
    switch (output) {
      case out_id:
        return sqlite3_result_int64(context, row.id);
      case out_t:
        return sqlite3_result_double(context, contact.t);
      case out_t_end:
        return sqlite3_result_double(context, contact.t_end);
      case out_dt:
        return sqlite3_result_double(context, contact.dt);
      default:
        return sqlite3_result_double(context, contact.dt_end);
    }
  }

 private:
  bool has_starts_, has_ends_;
  Window window_;
  std::span<const WindowRow> batch_;
  std::size_t row_ = 0;
};

/// The outline on the plane of the table: from longitude and latitude where it takes degrees.
Outline outline_of(const std::string& text, const Frame& frame, Interrupt& interrupt) {
  if (frame.in_degrees()) {
    const Outline degrees = read_outline(text, WktUnit::degrees);
    const Corner first = degrees.corners()[0];
    // Without an origin the table is empty: any origin shows what is wrong with the zone.
    return zone_on_plane(degrees, frame.origin.value_or(LatLon{first.y, first.x}), interrupt);
  }
  Outline outline = read_outline(text);
  check_outline(outline);
  return outline;
}

std::shared_ptr<const SharedOutline> shared_zone(const std::string& text, const Frame& frame,
                                                 Interrupt& interrupt) try {
  return std::make_shared<const SharedOutline>(outline_of(text, frame, interrupt));
} catch (const Error& error) {
  throw Error(std::string("zone: ") + error.what());
}

std::shared_ptr<const SharedOutline> zone_of(const FunctionCall& call, const Frame& frame) {
  const auto text = call.text(in_zone, "well-known text as in 'POLYGON((0 0, 4 0, 0 3, 0 0))', or left out");
  return text ? shared_zone(*text, frame, call.connection().interrupt()) : nullptr;
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  WindowQuestion question;
  question.h = call.required_number(in_h);
  WindowFaces& faces = question.faces;
  for (int axis = 0; axis < 3; ++axis) {
    const auto j = static_cast<std::size_t>(axis);
    faces.lower[j] = call.number(in_x0 + 2 * axis).value_or(faces.lower[j]);
    faces.upper[j] = call.number(in_x0 + 2 * axis + 1).value_or(faces.upper[j]);
    faces.velocity[j] = call.number(in_wvx + axis).value_or(0);
    call.reads_back_as(in_wvx + axis, 0.0);
  }
  question.mask = call.bits(in_mask);
  question.all_contacts = all_contacts_input(call, in_contacts);
  std::optional<SearchedObject> only;
  if (const auto id = call.only(out_id)) only = {*id, question.h};
  SearchedTable table = searched_table(call, {in_tbl, in_now, in_method, in_schema}, only);
  if (table.frame.on_globe() && call.text(in_zone))
    throw Error("zone is for tables on a plane, " + table.objects.name +
                " is on the globe; leave it out, or write origin = 'LAT LON' in " + table.objects.name);
  question.zone = zone_of(call, table.frame);
  question.objects = std::move(table.objects);
  question.now = table.now;
  question.wants.starts = call.reads(out_t) || call.reads(out_dt);
  question.wants.ends = call.reads(out_t_end) || call.reads(out_dt_end);
  return std::make_unique<WindowRows>(std::move(question), call.connection().interrupt());
}

}  // namespace

const TableFunction& predictive_window() {
  static const TableFunction function = {
      .name = "predictive_window",
      .outputs = window_outputs,
      .inputs = window_inputs,
      .key = "id, t, t_end",
      .hinted = 1u << out_id,
      .estimate = estimate_window,
      .start = start,
      .probed = 1u << out_id,
      .estimate_probe = estimate_window_of_one,
      .unread_if_left_out = (0x3fu << in_x0) | 1u << in_mask | 1u << in_zone};
  return function;
}

}  // namespace foresee
