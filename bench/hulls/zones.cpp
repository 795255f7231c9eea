// Zones of 100 corners over points, against windows of their boxes and steps in plain double.
#include <cmath>

#include "hulls/modes.h"
#include "hulls/query_costs.h"
#include "hulls/ships.h"
#include "plain_outline.h"

namespace foresee::bench {
namespace {

constexpr int corners = 100;
constexpr std::size_t number_of_zones = 100;

struct Zone {
  std::vector<Corner> ring;
  double x0, x1, y0, y1;
};

/// Ragged stars, 2 to 4 km across.
std::vector<Zone> random_zones(double side) {
  testing::Random random(17);
  std::vector<Zone> zones;
  for (std::size_t i = 0; i < number_of_zones; ++i) {
    const double x = random.in(0, side), y = random.in(0, side);
    Zone zone{{}, HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    for (int k = 0; k < corners; ++k) {
      const double r = random.in(1000, 2000), angle = 6.283185307179586 * k / corners;
      const Corner c{x + r * std::cos(angle), y + r * std::sin(angle)};
      zone.ring.push_back(c);
      zone.x0 = std::min(zone.x0, c.x), zone.x1 = std::max(zone.x1, c.x);
      zone.y0 = std::min(zone.y0, c.y), zone.y1 = std::max(zone.y1, c.y);
    }
    zones.push_back(zone);
  }
  return zones;
}

std::string text_of(const Zone& zone) {
  std::string text;
  for (std::size_t k = 0; k <= zone.ring.size(); ++k) {
    const Corner& c = zone.ring[k % zone.ring.size()];
    char corner[80];
    std::snprintf(corner, sizeof corner, "%s%.17g %.17g", k == 0 ? "" : ", ", c.x, c.y);
    text += corner;
  }
  return "POLYGON((" + text + "))";
}

void insert(Database& db, const std::vector<Zone>& zones) {
  db.run("CREATE TABLE zones(id INTEGER PRIMARY KEY, wkt TEXT, x0, x1, y0, y1)");
  Statement insert(db, "INSERT INTO zones VALUES(NULL, ?1, ?2, ?3, ?4, ?5)");
  for (const Zone& zone : zones) {
    const std::string text = text_of(zone);
    sqlite3_bind_text(insert.handle(), 1, text.c_str(), -1, SQLITE_TRANSIENT);
    insert.bind(2, zone.x0), insert.bind(3, zone.x1), insert.bind(4, zone.y0), insert.bind(5, zone.y1);
    insert.step();
  }
}

/// The number of candidates, points that touch the zones' boxes, found in the zones in steps of 0.1 s.
std::int64_t step_through_candidates(Database& db, const std::vector<Zone>& zones,
                                     const std::vector<Ship>& points) {
  Statement candidates(db, "SELECT id FROM predictive_window(600, 'ships', ?1, ?2, ?3, ?4)");
  std::int64_t found = 0;
  for (const Zone& zone : zones) {
    candidates.bind(1, zone.x0), candidates.bind(2, zone.x1), candidates.bind(3, zone.y0),
        candidates.bind(4, zone.y1);
    while (candidates.step()) {
      const Ship& point = points[static_cast<std::size_t>(candidates.integer(0)) - 1];
      for (int i = 0; i <= 10 * ship_horizon; ++i)
        if (is_within(zone.ring, point.x + 0.1 * i * point.vx, point.y + 0.1 * i * point.vy)) {
          ++found;
          break;
        }
    }
  }
  return found;
}

}  // namespace

void measure_zones(bool quick) {
  const Ships ships;
  const std::vector<Ship> points = ships.all();
  ShipTable table(ShipKind::points, ships);
  table.insert(points, points.size());
  const std::vector<Zone> zones = random_zones(ships.side());
  insert(table.db(), zones);
  double t_alone = 0;
  std::int64_t found = 0;
  for (const auto& [name, what] : {std::pair("id", "count(*)"),
                                   {"t", "count(*), sum(w.t)"},
                                   {"t, t_end", "count(*), sum(w.t), sum(w.t_end)"}}) {
    const std::string select = std::string("SELECT ") + what + " FROM zones z JOIN predictive_window w ";
    TimedQuery by_zone(table.db(), select + "ON w.h = 600 AND w.tbl = 'ships' AND w.zone = z.wkt");
    TimedQuery by_box(table.db(), select +
                                      "ON w.h = 600 AND w.tbl = 'ships' AND w.x0 = z.x0 AND w.x1 = z.x1 AND "
                                      "w.y0 = z.y0 AND w.y1 = z.y1");
    query_in_turns({&by_zone, &by_box}, quick ? 3 : 15, step_through);
    const double zone = median(by_zone.seconds) / number_of_zones,
                 box = median(by_box.seconds) / number_of_zones;
    std::printf(
        "zone of 100 corners, %-9s %8.1f us   window of its box %8.1f us, zones take %.2f times as long\n",
        name, zone * 1e6, box * 1e6, zone / box);
    std::printf(
        "  rows a zone: %.1f of %.1f that meet its box; the zone takes %.0f ns a row of its box longer\n",
        static_cast<double>(by_zone.rows) / number_of_zones,
        static_cast<double>(by_box.rows) / number_of_zones,
        (zone - box) * 1e9 * number_of_zones / static_cast<double>(by_box.rows));
    if (std::string(name) == "t") t_alone = zone, found = by_zone.rows;
  }
  std::int64_t stepped = 0;
  const double steps =
      seconds_of([&] { stepped = step_through_candidates(table.db(), zones, points); }) / number_of_zones;
  std::printf(
      "steps of 0.1 s in plain double %8.1f us a zone, %.0f times the zone with t (mark: 10x); misses %lld "
      "of %lld\n",
      steps * 1e6, steps / t_alone, static_cast<long long>(found - stepped), static_cast<long long>(found));
}

}  // namespace foresee::bench
