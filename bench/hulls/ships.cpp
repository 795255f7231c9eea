#include "hulls/ships.h"

#include <cmath>
#include <cstdio>

#include "shape/outline/outline_rotation.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

constexpr double metres = 100;   // a unit of the workload
constexpr double seconds = 200;  // a second of the workload
constexpr std::size_t hulls = 50;
constexpr double degree = 0.017453292519943295;

Workload scaled() {
  Workload w = make_workload("L-3");
  const Offsets at = w.bodies().at;
  for (double* row = w.rows.data(); row != w.rows.data() + w.rows.size(); row += at.size)
    for (int axis = 0; axis < 2; ++axis) row[at.x + axis] *= metres, row[at.v + axis] *= metres / seconds;
  return w;
}

std::string text_of(const Outline& outline) {
  std::string text;
  char corner[80];
  for (const Corner& c : outline.corners()) {
    std::snprintf(corner, sizeof corner, "%.17g %.17g, ", c.x, c.y);
    text += corner;
  }
  const Corner& first = outline.corners()[0];
  std::snprintf(corner, sizeof corner, "%.17g %.17g", first.x, first.y);
  return "POLYGON((" + text + corner + "))";
}

const char* columns_of(ShipKind kind) {
  const char* columns[] = {"shape, heading", "hx, hy", "r", ""};
  return columns[static_cast<int>(kind)];
}

}  // namespace

std::array<double, 2> half_extents_of(const Outline& outline, double heading) {
  const Extents<2> extents = turned(outline, heading).extents();
  return {std::max(-extents.lower[0], extents.upper[0]), std::max(-extents.lower[1], extents.upper[1])};
}

Ships::Ships() : feed_(scaled()) {
  for (std::size_t i = 0; i < hulls; ++i) {
    const double bow = 50 + static_cast<double>(i), side = std::floor(0.15 * bow);
    Outline& hull = hulls_.emplace_back();
    hull.begin_part();
    for (const Corner& c : {Corner{-side, -bow}, Corner{side, -bow}, Corner{side, bow - 2 * side},
                            Corner{0, bow}, Corner{-side, bow - 2 * side}})
      hull.add(c);
    texts_.push_back(text_of(hull));
  }
}

double Ships::side() const {
  return metres * std::sqrt(14.0 * static_cast<double>(feed_.objects().count));
}

Ship Ships::ship(std::size_t i, const double* row) const {
  const Offsets at = feed_.objects().bodies().at;
  const std::size_t hull = i % hulls;
  const double vx = row[at.v], vy = row[at.v + 1], heading = std::atan2(vx, vy) / degree;
  const auto [hx, hy] = half_extents_of(hulls_[hull], heading);
  const double r = hulls_[hull].extents().upper[1];
  return {static_cast<std::int64_t>(i + 1),
          row[at.t],
          row[at.x],
          row[at.x + 1],
          vx,
          vy,
          heading,
          hull,
          hx,
          hy,
          r};
}

std::vector<Ship> Ships::all() const {
  std::vector<Ship> all;
  for (std::size_t i = 0; i < feed_.objects().count; ++i)
    all.push_back(ship(i, feed_.objects().bodies().row(i)));
  return all;
}

std::vector<Ship> Ships::reports(std::size_t count) {
  const Reports reports = feed_.random_reports(count);
  const auto size = static_cast<std::size_t>(feed_.objects().bodies().at.size);
  std::vector<Ship> ships;
  for (std::size_t i = 0; i < count; ++i)
    ships.push_back(ship(reports.objects[i], reports.rows.data() + i * size));
  return ships;
}

ShipTable::ShipTable(ShipKind kind, const Ships& ships) : kind_(kind), ships_(ships) {
  register_foresee(db_);
  const std::string more = columns_of(kind),
                    columns = "id, t, x, y, vx, vy" + (more.empty() ? "" : ", " + more);
  db_.run("CREATE VIRTUAL TABLE ships USING moving_objects(" + columns + ")");
  insert_ =
      std::make_unique<Statement>(db_, "INSERT INTO ships(" + columns + ") VALUES(?1, ?2, ?3, ?4, ?5, ?6" +
                                           (kind == ShipKind::points  ? ")"
                                            : kind == ShipKind::discs ? ", ?7)"
                                                                      : ", ?7, ?8)"));
  const char* turns[] = {", heading = ?7", ", hx = ?7, hy = ?8", "", ""};
  update_ = std::make_unique<Statement>(
      db_, std::string("UPDATE ships SET t = ?2, x = ?3, y = ?4, vx = ?5, vy = ?6") +
               turns[static_cast<int>(kind)] + " WHERE id = ?1");
}

void ShipTable::bind_motion(Statement& statement, int first, const Ship& ship) {
  statement.bind(first++, ship.id);
  for (const double number : {ship.t, ship.x, ship.y, ship.vx, ship.vy}) statement.bind(first++, number);
}

void ShipTable::insert(const std::vector<Ship>& ships, std::size_t a_transaction) {
  for (std::size_t i = 0; i < ships.size(); ++i) {
    const Ship& ship = ships[i];
    if (i % a_transaction == 0) db_.run(i == 0 ? "BEGIN" : "COMMIT; BEGIN");
    bind_motion(*insert_, 1, ship);
    if (kind_ == ShipKind::hulls) {
      const std::string& text = ships_.hull_text(ship.hull);
      sqlite3_bind_text(insert_->handle(), 7, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
      insert_->bind(8, ship.heading);
    }
    if (kind_ == ShipKind::boxes) insert_->bind(7, ship.hx), insert_->bind(8, ship.hy);
    if (kind_ == ShipKind::discs) insert_->bind(7, ship.r);
    insert_->step();
  }
  db_.run("COMMIT");
}

void ShipTable::update(const std::vector<Ship>& reports) {
  db_.run("BEGIN");
  for (const Ship& ship : reports) {
    bind_motion(*update_, 1, ship);
    if (kind_ == ShipKind::hulls) update_->bind(7, ship.heading);
    if (kind_ == ShipKind::boxes) update_->bind(7, ship.hx), update_->bind(8, ship.hy);
    update_->step();
  }
  db_.run("COMMIT");
}

ShipTables::ShipTables(const Ships& ships)
    : hulls(ShipKind::hulls, ships), boxes(ShipKind::boxes, ships), discs(ShipKind::discs, ships) {
  for (ShipTable* table : {&hulls, &boxes, &discs}) table->insert(ships.all(), ships.all().size());
}

}  // namespace foresee::bench
