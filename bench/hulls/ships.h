// Tables of ships as hulls, as boxes and as discs, at the density of S-100000 in the plane.
//
//   Ships ships(100000);
//   ShipTable hulls(ShipKind::hulls, ships), boxes(ShipKind::boxes, ships);
//   hulls.insert(ships.all(), 5000), hulls.update(ships.reports(100000));
//
// Places and motions are those of L-3 (workloads.h), a unit of which is 100 m and a second 200 s: up to 1.5
// m/s per axis, horizon 600 s. Each ship has one of 50 hulls, of five corners, 100 to 200 m long and 15 %
// as wide, along its course. Its box is the smallest around its position and the turned hull, its disc
// reaches to bow and stern. Reports are those of reports/feed.h; the heading follows the course.
#pragma once

#include <array>

#include "reports/feed.h"
#include "shape/outline/outline.h"
#include "sql.h"

namespace foresee::bench {

constexpr double ship_horizon = 600;

struct Ship {
  std::int64_t id;
  double t, x, y, vx, vy, heading;
  std::size_t hull;
  double hx, hy, r;
};

class Ships {
 public:
  Ships();

  const std::string& hull_text(std::size_t hull) const { return texts_[hull]; }
  /// As they were last reported, in the order of their ids.
  std::vector<Ship> all() const;
  /// Of ships drawn at random.
  std::vector<Ship> reports(std::size_t count);
  /// The side of the square that holds the ships.
  double side() const;

 private:
  Ship ship(std::size_t i, const double* row) const;

  Feed feed_;
  std::vector<Outline> hulls_;
  std::vector<std::string> texts_;
};

enum class ShipKind { hulls, boxes, discs, points };

/// A table "ships" of them in memory.
class ShipTable {
 public:
  ShipTable(ShipKind kind, const Ships& ships);

  Database& db() { return db_; }
  void insert(const std::vector<Ship>& ships, std::size_t a_transaction);
  /// Updates t, position, speed and heading or box by id, in one transaction.
  void update(const std::vector<Ship>& reports);

 private:
  void bind_motion(Statement& statement, int first, const Ship& ship);

  const ShipKind kind_;
  const Ships& ships_;
  Database db_{":memory:"};
  std::unique_ptr<Statement> insert_, update_;
};

/// All kinds of the same ships, loaded.
struct ShipTables {
  explicit ShipTables(const Ships& ships);
  ShipTable hulls, boxes, discs;
};

/// The smallest box around the position and a turned outline.
std::array<double, 2> half_extents_of(const Outline& outline, double heading);

}  // namespace foresee::bench
