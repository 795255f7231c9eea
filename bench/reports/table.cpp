#include "reports/table.h"

#include "shape/swept_boxes.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

template <int D>
void add_swept_box(const Bodies& bodies, std::size_t i, double h, std::vector<double>& boxes) {
  const Box<D> box = swept_box<D>(bodies, i, {value_or(bodies.row(i), bodies.at.t, 0), h}, Vec<D>::zero());
  for (int axis = 0; axis < D; ++axis) boxes.insert(boxes.end(), {box.lower[axis], box.upper[axis]});
}

Writes writes_of(std::vector<std::int64_t> ids, const std::vector<double>& rows, const Workload& w) {
  Writes writes{std::move(ids), rows, {}};
  const Bodies bodies(w.layout, writes.rows.data(), writes.size());
  for (std::size_t i = 0; i < writes.size(); ++i)
    w.layout.axes == 2 ? add_swept_box<2>(bodies, i, w.h, writes.boxes)
                       : add_swept_box<3>(bodies, i, w.h, writes.boxes);
  return writes;
}

/// The columns of position and motion: all but the size.
std::string moving_columns_of(Layout layout) {
  layout.shape = Shape::point;
  return columns_of(layout);
}

std::string box_columns_of(int axes) {
  return axes == 2 ? "x0, x1, y0, y1" : "x0, x1, y0, y1, z0, z1";
}

int number_of(const std::string& columns) {
  return 1 + static_cast<int>(std::count(columns.begin(), columns.end(), ','));
}

std::string insert_sql(const std::string& table, const std::string& columns) {
  std::string places = "?";
  for (int i = 0; i < number_of(columns); ++i) places += ", ?";
  return "INSERT INTO " + table + "(id, " + columns + ") VALUES(" + places + ")";
}

std::string update_sql(const std::string& table, std::string columns) {
  for (std::size_t at = 0; (at = columns.find(',', at)) != std::string::npos; at += 5)
    columns.replace(at, 1, " = ?,");
  return "UPDATE " + table + " SET " + columns + " = ? WHERE id = ?";
}

void bind(Statement& statement, int first, const double* values, int count) {
  for (int k = 0; k < count; ++k) statement.bind(first + k, values[k]);
}

const double* of(std::size_t i, const std::vector<double>& numbers, int columns) {
  return numbers.data() + i * static_cast<std::size_t>(columns);
}

}  // namespace

const char* name_of(Medium medium) {
  const char* names[] = {"memory", "file, journal", "file, WAL"};
  return names[static_cast<int>(medium)];
}

std::vector<Medium> mediums_of(const Options& options, std::vector<Medium> otherwise) {
  std::vector<Medium> mediums;
  if (options.has("--memory")) mediums.push_back(Medium::memory);
  if (options.has("--journal")) mediums.push_back(Medium::journal);
  if (options.has("--wal")) mediums.push_back(Medium::wal);
  return mediums.empty() ? otherwise : mediums;
}

Writes writes_of(const Workload& w) {
  std::vector<std::int64_t> ids;
  for (std::size_t i = 1; i <= w.count; ++i) ids.push_back(static_cast<std::int64_t>(i));
  return writes_of(std::move(ids), w.rows, w);
}

Writes writes_of(const Reports& reports, const Workload& w) {
  std::vector<std::int64_t> ids;
  for (const std::size_t object : reports.objects) ids.push_back(static_cast<std::int64_t>(object + 1));
  return writes_of(std::move(ids), reports.rows, w);
}

Table::Table(Kind kind, const Workload& w, Medium medium, const std::string& path)
    : columns_(w.bodies().at.size),
      moving_columns_(number_of(moving_columns_of(w.layout))),
      box_columns_(2 * w.layout.axes),
      db_(medium == Medium::memory ? ":memory:" : path) {
  if (medium != Medium::memory) db_.run("PRAGMA synchronous = OFF");
  if (medium == Medium::wal) db_.run("PRAGMA journal_mode = WAL");
  const std::string columns = columns_of(w);
  if (kind == foresee)
    create_ours(db_, w);
  else
    db_.run("CREATE TABLE ships(id INTEGER PRIMARY KEY, " + columns + ")");
  insert_ = std::make_unique<Statement>(db_, insert_sql("ships", columns));
  update_ = std::make_unique<Statement>(db_, update_sql("ships", moving_columns_of(w.layout)));
  if (kind != rtree) return;
  const std::string bounds = box_columns_of(w.layout.axes);
  db_.run("CREATE VIRTUAL TABLE boxes USING rtree(id, " + bounds + ")");
  insert_box_ = std::make_unique<Statement>(db_, insert_sql("boxes", bounds));
  update_box_ = std::make_unique<Statement>(db_, update_sql("boxes", bounds));
}

void Table::insert(const Writes& writes, std::size_t i) {
  insert(writes.ids[i], of(i, writes.rows, columns_));
  if (!insert_box_) return;
  insert_box_->bind(1, writes.ids[i]);
  bind(*insert_box_, 2, of(i, writes.boxes, box_columns_), box_columns_);
  insert_box_->step();
}

void Table::insert(std::int64_t id, const double* row) {
  insert_->bind(1, id);
  bind(*insert_, 2, row, columns_);
  insert_->step();
}

void Table::update(const Writes& writes, std::size_t i) {
  bind(*update_, 1, of(i, writes.rows, columns_), moving_columns_);
  update_->bind(moving_columns_ + 1, writes.ids[i]);
  update_->step();
  if (!update_box_) return;
  bind(*update_box_, 1, of(i, writes.boxes, box_columns_), box_columns_);
  update_box_->bind(box_columns_ + 1, writes.ids[i]);
  update_box_->step();
}

void Table::insert_all(const Writes& writes) {
  begin_.step();
  for (std::size_t i = 0; i < writes.size(); ++i) insert(writes, i);
  commit_.step();
}

void Table::update_all(const Writes& writes) {
  begin_.step();
  for (std::size_t i = 0; i < writes.size(); ++i) update(writes, i);
  commit_.step();
}

void Table::update_alone(const Writes& writes, std::size_t i) {
  begin_.step();
  update(writes, i);
  commit_.step();
}

bool same_rows(Table& a, Table& b) {
  Statement of_a(a.db(), "SELECT * FROM ships ORDER BY id"), of_b(b.db(), "SELECT * FROM ships ORDER BY id");
  while (of_a.step()) {
    if (!of_b.step()) return false;
    for (int k = 0; k < of_a.columns(); ++k)
      if (of_a.number(k) != of_b.number(k)) return false;
  }
  return !of_b.step();
}

}  // namespace foresee::bench
