// predictive_avoid(h, tbl, id, …) in SQL: looks the object up and searches the tree for the others.
#include <algorithm>
#include <cmath>

#include "base/float_environment.h"
#include "base/integer_of.h"
#include "database/value_text.h"
#include "geography/frame.h"
#include "index/tpr_tree/tpr_tree.h"
#include "motion/plan/plan_legs.h"
#include "query/avoid/avoid.h"
#include "sqlite/functions/searched_table.h"
#include "sqlite/functions/table_functions.h"
#include "sqlite/names/open_table.h"
#include "sqlite/plan_values.h"
#include "sqlite/table/column_vocabulary.h"
#include "sqlite/table/degrees_columns.h"

namespace foresee {
namespace {

constexpr ColumnList avoid_outputs{
    "manoeuvre TEXT", "clear INTEGER", "k_from REAL",   "k_to REAL",      "k REAL",       "t REAL",
    "until REAL",     "x REAL",        "y REAL",        "z REAL",         "vx REAL",      "vy REAL",
    "vz REAL",        "ax REAL",       "ay REAL",       "az REAL",        "fx REAL",      "fy REAL",
    "fz REAL",        "heading REAL",  "below INTEGER", "below_tbl TEXT", "t_below REAL", "above INTEGER",
    "above_tbl TEXT", "t_above REAL",  "lat REAL",      "lon REAL",       "speed REAL",   "course REAL",
    "height REAL",    "climb REAL",    "plan"};
constexpr int out_manoeuvre = avoid_outputs["manoeuvre"], out_clear = avoid_outputs["clear"],
              out_k_from = avoid_outputs["k_from"], out_k_to = avoid_outputs["k_to"],
              out_k = avoid_outputs["k"], out_t = avoid_outputs["t"], out_until = avoid_outputs["until"],
              out_x = avoid_outputs["x"], out_v = avoid_outputs["vx"], out_a = avoid_outputs["ax"],
              out_f = avoid_outputs["fx"], out_heading = avoid_outputs["heading"],
              out_below = avoid_outputs["below"], out_below_tbl = avoid_outputs["below_tbl"],
              out_t_below = avoid_outputs["t_below"], out_above = avoid_outputs["above"],
              out_above_tbl = avoid_outputs["above_tbl"], out_t_above = avoid_outputs["t_above"],
              out_lat = avoid_outputs["lat"], out_lon = avoid_outputs["lon"],
              out_speed = avoid_outputs["speed"], out_course = avoid_outputs["course"],
              out_height = avoid_outputs["height"], out_climb = avoid_outputs["climb"],
              out_plan = avoid_outputs["plan"];
constexpr ColumnList avoid_inputs{"h",   "tbl",  "id",       "within",   "how",    "lo",    "hi",
                                  "now", "also", "within_z", "touching", "schema", "resume"};
constexpr int in_h = avoid_inputs["h"], in_tbl = avoid_inputs["tbl"], in_id = avoid_inputs["id"],
              in_within = avoid_inputs["within"], in_how = avoid_inputs["how"], in_lo = avoid_inputs["lo"],
              in_hi = avoid_inputs["hi"], in_now = avoid_inputs["now"], in_also = avoid_inputs["also"],
              in_within_z = avoid_inputs["within_z"], in_touching = avoid_inputs["touching"],
              in_schema = avoid_inputs["schema"], in_resume = avoid_inputs["resume"];

class AvoidRows final : public FunctionRows {
 public:
  AvoidRows(std::vector<AvoidRow> rows, const OpenTables& tables, std::vector<double> stored,
            Interrupt& interrupt)
      : rows_(std::move(rows)),
        layout_(tables.a.store->declaration().layout),
        at_(layout_.has_plan ? record_offsets(layout_) : declared_offsets(tables.a.store->declaration())),
        tables_{tables.a.table, tables.b ? tables.b->table : ""},
        frame_(tables.a.store->frame()),
        stored_(std::move(stored)),
        interrupt_(interrupt) {}

  bool next() override {
    is_report_known_ = false;
    return next_++ < rows_.size();
  }

  void output(sqlite3_context* context, int output) const override {
    const AvoidRow& row = rows_[next_ - 1];
    switch (output) {
      case out_manoeuvre:
        return result_text(context, name_of(row.manoeuvre));
      case out_clear:
        return sqlite3_result_int64(context, row.clear);
      case out_k_from:
        return sqlite3_result_double(context, row.k_from);
      case out_k_to:
        return sqlite3_result_double(context, row.k_to);
      case out_k:
        return sqlite3_result_double(context, row.k);
      case out_below:
      case out_below_tbl:
      case out_t_below:
        return result_blocker(context, row.below, output - out_below);
      case out_above:
      case out_above_tbl:
      case out_t_above:
        return result_blocker(context, row.above, output - out_above);
      case out_lat:
      case out_lon:
      case out_speed:
      case out_course:
      case out_height:
      case out_climb:
        return result_report(context, row, output);
      case out_plan:
        return row.plan ? result_plan(context, *row.plan, interrupt_) : void();
      default:
        return result_stored(context, row, output);
    }
  }

 private:
  static void result_text(sqlite3_context* context, std::string_view text) {
    sqlite3_result_text(context, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
  }

  void result_blocker(sqlite3_context* context, const std::optional<Blocker>& blocker, int column) const {
    if (!blocker) return;
    if (column == 0) return sqlite3_result_int64(context, blocker->id);
    if (column == 2) return sqlite3_result_double(context, blocker->t);
    result_text(context, tables_[static_cast<std::size_t>(blocker->table)]);
  }

  /// A number of the changed record. NULL if the table has no such column or the number is infinite.
  void result_stored(sqlite3_context* context, const AvoidRow& row, int output) const {
    const int place = place_of(output);
    if (place == Offsets::absent) return;
    const double value = row.record[static_cast<std::size_t>(place)];
    if (std::isfinite(value)) sqlite3_result_double(context, value);
  }

  /// Place, motion and height of the changed record, as a table in degrees takes them; NULL for plain tables.
  void result_report(sqlite3_context* context, const AvoidRow& row, int output) const {
    const bool on_height = output == out_height || output == out_climb;
    if (!frame_.knows_places() || row.record.empty() || (on_height && layout_.axes < 3)) return;
    if (!is_report_known_) report_ = report_of(row.record), is_report_known_ = true;
    if (!report_ || (output == out_climb && at_.v == Offsets::absent)) return;
    constexpr std::array columns{GeoColumn::lat,    GeoColumn::lon,    GeoColumn::speed,
                                 GeoColumn::course, GeoColumn::height, GeoColumn::climb};
    const auto number = shown_number(columns[static_cast<std::size_t>(output - out_lat)], *report_);
    if (number) sqlite3_result_double(context, *number);
  }

  /// All digits, so that what is written back is clear. Where the change keeps the place or the motion, what the
  /// table's columns show: an UPDATE then keeps the stored bits.
  std::optional<Flight> report_of(const std::vector<double>& record) const {
    const FloatEnvironment environment;
    const auto axes = static_cast<std::ptrdiff_t>(frame_.axes_of_place());
    const auto is_kept = [&](int place) {
      const auto first = record.begin() + place;
      return std::equal(first, first + axes, stored_.begin() + place);
    };
    Metres point = metres_of(frame_, at_, record.data());
    if (layout_.axes == 3 && !frame_.on_globe()) {
      const auto up = [&](int place) { return record[static_cast<std::size_t>(place) + 2]; };
      point.x[2] = up(at_.x);
      if (point.motion) point.motion->v[2] = up(at_.v);
    }
    try {
      Flight report = frame_.from_metres(point);
      const Flight shown = frame_.shown(point);
      if (is_kept(at_.x)) {
        report.fix.place = shown.fix.place, report.height = shown.height;
        if (point.motion && is_kept(at_.v)) report.fix.course = shown.fix.course, report.climb = shown.climb;
      }
      return report;
    } catch (const Error&) {
      return std::nullopt;  // beyond the Earth
    }
  }

  int place_of(int output) const {
    if (output == out_t) return at_.t;
    if (output == out_until) return at_.until;
    const auto on_axis = [&](int first, int place) {
      const int axis = output - first;
      return place == Offsets::absent || axis >= layout_.axes ? Offsets::absent : place + axis;
    };
    if (output < out_v) return on_axis(out_x, at_.x);
    if (output < out_a) return on_axis(out_v, at_.v);
    if (output < out_f) return on_axis(out_a, at_.a);
    if (output < out_heading) return on_axis(out_f, at_.force);
    return at_.heading;
  }

  std::vector<AvoidRow> rows_;
  Layout layout_;
  Offsets at_;
  std::array<std::string, 2> tables_;
  Frame frame_;
  std::vector<double> stored_;  ///< the record of the object before any change
  Interrupt& interrupt_;
  std::size_t next_ = 0;
  mutable std::optional<Flight> report_;  ///< of the current row, if it is known
  mutable bool is_report_known_ = false;
};

bool reads_any(const FunctionCall& call, int output, int last) {
  return call.reads(output) || (output < last && reads_any(call, output + 1, last));
}

void read_inputs(const FunctionCall& call, AvoidQuestion& question) {
  question.h = call.required_number(in_h);
  question.within = call.number(in_within).value_or(0);
  question.within_z = call.number(in_within_z);
  if (const auto how = call.text(in_how)) question.how = manoeuvre_of(without_nul(*how));
  question.lo = call.number(in_lo), question.hi = call.number(in_hi);
  question.resume = call.number(in_resume);
  const auto now = call.number(in_now);
  question.now = now.value_or(0), question.now_given = now.has_value();
  if (const auto touching = call.text(in_touching)) question.touching = touching_of(without_nul(*touching));
}

void read_wanted_outputs(const FunctionCall& call, AvoidQuestion& question) {
  question.wants_motion = reads_any(call, out_t, out_heading) || reads_any(call, out_lat, out_climb);
  question.wants_plan = call.reads(out_plan);
  question.wants_ends = reads_any(call, out_below, out_t_above);
}

/// The table of the object, and the one that is searched too; sets what depends on them.
OpenTables open_tables(const FunctionCall& call, AvoidQuestion& question) {
  const TableName tbl{call.text(in_tbl), call.text(in_schema)};
  OpenTables tables{open_table(call.connection(), tbl)};
  require_upright(tables.a, question.within_z);
  question.on_globe = tables.a.store->frame().on_globe();
  StoredTable own(call.connection(), tables.a);
  question.others = trees_of(own);
  call.reads_back_as(in_tbl, tables.a.table);
  call.reads_back_as(in_schema, tables.a.schema);
  if (const auto also = call.text(in_also)) {
    tables.b = open_table(call.connection(), {also, tbl.schema});
    require_one_frame(tables.a, *tables.b);
    StoredTable other(call.connection(), *tables.b);
    question.also = trees_of(other);
  }
  return tables;
}

/// Sets its numbers, plan and outline, and a scene of all its legs; if it does not exist, an empty scene.
void read_object(const OpenTable& table, std::int64_t id, Interrupt& interrupt, AvoidQuestion& question) {
  const FloatEnvironment environment;  // accelerations are computed on loading
  Store& store = *table.store;
  auto own = std::make_shared<Scene>();
  own->name = table.table, own->layout = store.declaration().layout;
  const Offsets &at = store.format().at, declared = declared_offsets(store.declaration());
  question.lacks_t = at.t != declared.t, question.lacks_velocity = at.v != declared.v;
  if (auto record = store.read(id)) {
    question.record = std::move(*record);
    const double* const numbers = question.record.data();
    if (has_plan(at, numbers)) {
      question.plan = std::make_shared<const Plan>(store.read_plan(id, question.record));
      own->add(id, numbers, legs_of(*question.plan));
    } else {
      own->add(id, numbers);
    }
    const auto form = integer_of(value_or(numbers, at.outline, 0)).value_or(0);
    if (form != 0) question.form = store.forms()->form(form);
  }
  question.in_degrees = store.frame().knows_places();
  own->take_forms(store.forms(), interrupt);
  question.own_scene = std::move(own);
}

/// Plans as the table shows them: knots in degrees.
void show_plans(Store& store, Interrupt& interrupt, std::vector<AvoidRow>& rows) {
  PlanValues values(store.declaration(), interrupt);
  for (AvoidRow& row : rows)
    if (row.plan) row.plan = values.shown(*row.plan, store.frame());
}

std::unique_ptr<FunctionRows> start(const FunctionCall& call) {
  Interrupt& interrupt = call.connection().interrupt();
  AvoidQuestion question;
  read_inputs(call, question);
  read_wanted_outputs(call, question);
  const OpenTables tables = open_tables(call, question);
  if (question.on_globe && !question.how) question.how = Manoeuvre::speed;
  if (!question.now_given) {
    question.now = read_newest_t(*question.others.tree);
    if (question.also) question.now = std::max(question.now, read_newest_t(*question.also->tree));
  }
  call.reads_back_as(in_now, question.now);
  call.reads_back_as(in_within, question.within);
  call.reads_back_as(in_touching, "part");
  read_object(tables.a, call.required_integer(in_id), interrupt, question);
  if (!question.now_given) require_default_now(tables, question.record, question.now);
  std::vector<AvoidRow> rows = avoid(question, interrupt);
  if (const auto clear = call.only(out_clear))
    std::erase_if(rows, [&](const AvoidRow& row) { return *clear != (row.clear ? 1 : 0); });
  if (question.own_scene->layout.has_plan && question.in_degrees)
    show_plans(*tables.a.store, interrupt, rows);
  return std::make_unique<AvoidRows>(std::move(rows), tables, std::move(question.record), interrupt);
}

}  // namespace

const TableFunction& predictive_avoid() {
  static const TableFunction function = {
      .name = "predictive_avoid",
      .outputs = avoid_outputs,
      .inputs = avoid_inputs,
      .key = "manoeuvre, k_from, clear",
      .hinted = 1u << out_clear,
      .estimate = estimate_avoid,
      .start = start,
      .unread_if_left_out = 0x7u << in_how | 1u << in_also | 1u << in_within_z | 1u << in_resume};
  return function;
}

}  // namespace foresee
