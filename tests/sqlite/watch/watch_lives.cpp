#include "sqlite/watch/watch_lives.h"

namespace foresee::testing {
namespace {

constexpr const char* planar = "t, x, y, vx, vy, r";
constexpr const char* disc = "T, N, N, V, V, S";

/// A column of kinds among the columns; null without one.
const char* of_kinds(std::string_view columns) {
  if (columns.ends_with("mask")) return "mask";
  return columns.ends_with("category") ? "category" : nullptr;
}

}  // namespace

const std::vector<WatchLife>& watch_lives() {
  static const std::vector<WatchLife> all = {
      {"Discs", "t, x, y, vx, vy, r, +name", "T, N, N, V, V, S, 'n'", "horizon = 10, within = 2",
       "h = 10 AND within = 2"},
      {"InContact", planar, disc, "horizon = 0, within = 5", "h = 0 AND within = 5"},
      {"Tolerance", planar, disc, "horizon = 20, tolerance = 2.5", "h = 20", nullptr, nullptr, 2.5},
      {"Manual", planar, disc, "horizon = 12, clock = manual", "h = 12"},
      {"FewKept", planar, disc, "horizon = 12, keep = 25", "h = 12"},
      {"Ahead", planar, disc, "horizon = 15, ahead = 3", "h = 15"},
      {"FarHorizon", planar, disc, "horizon = 1e7, within = 1", "h = 1e7 AND within = 1"},
      {"WithItself", planar, disc, "horizon = 12, other = ships", "h = 12 AND other = 'ships'"},
      {"Kinds", "t, x, y, vx, vy, r, category, mask", "T, N, N, V, V, S, 1 + S, 3 - S",
       "horizon = 12, within = 4", "h = 12 AND within = 4"},
      {"KindsAhead", "t, x, y, vx, vy, r, mask", "T, N, N, V, V, S, S", "horizon = 15, within = 3, ahead = 3",
       "h = 15 AND within = 3"},
      {"KindsAndPlain", "t, x, y, vx, vy, r, category, mask", "T, N, N, V, V, S, 1 + S, 3 - S",
       "horizon = 9, within = 4, other = ferries", "h = 9 AND within = 4 AND other = 'ferries'",
       "x, y, vx, vy, r, category", "N, N, V, V, S, S"},
      {"TwoTables", planar, disc, "horizon = 12, other = ferries", "h = 12 AND other = 'ferries'", planar,
       disc},
      {"DiscsAndBoxes", planar, disc, "horizon = 8, within = 1, other = ferries",
       "h = 8 AND within = 1 AND other = 'ferries'", "x, y, vx, vy, hx, hy", "N, N, V, V, S, S"},
      {"MeetAgain", "t, x, y, vx, vy, ax, ay, r", "T, N, N, V, V, V * 0.5, V * 0.5, S",
       "horizon = 12, within = 2", "h = 12 AND within = 2"},
      {"AcceleratedBoxes", "t, x, y, z, vx, vy, vz, ax, ay, az, hx, hy, hz, until",
       "T, N, N, N, V, V, V, V * 0.25, V * 0.25, 0, S, S, S, T + 20", "horizon = 6, within = 1",
       "h = 6 AND within = 1"},
      {"WithoutT", "x, y, hx, hy", "N, N, S, S", "horizon = 6, within = 1", "h = 6 AND within = 1"},
      {"MovingWithoutT", "x, y, vx, vy", "N, S, V, V", "horizon = 6, within = 1", "h = 6 AND within = 1"},
      {"Cylinders", "t, x, y, z, vx, vy, vz, r, hz", "T, N, N, N, V, V, V, S, S",
       "horizon = 9, within = 1, within_z = 2", "h = 9 AND within = 1 AND within_z = 2"},
      {"Growing", "t, x, y, vx, vy, r, growth", "T, N, N, V, V, S, 0.25 * S", "horizon = 12, within = 1",
       "h = 12 AND within = 1"},
      {"GrowingBoxes", "t, x, y, z, hx, hy, hz, growth, growth_z", "T, N, N, S, S, S, S, 0.5 * S, 0.25",
       "horizon = 9", "h = 9"},
      {"GrowingOutlines", "t, x, y, vx, vy, shape, growth",
       "T, N, N, V, V, CASE S WHEN 0 THEN NULL ELSE 'POLYGON((-2 -9, 2 -9, 2 6, 0 9, -2 6, -2 -9))' END, "
       "0.25",
       "horizon = 9", "h = 9"},
      {"Outlines", "t, x, y, vx, vy, shape, heading, r",
       "T, N, N, V, V, CASE S WHEN 0 THEN NULL ELSE 'POLYGON((-2 -9, 2 -9, 2 6, 0 9, -2 6, -2 -9))' END, 45 "
       "* V, S",
       "horizon = 9", "h = 9"},
      {"Prisms", "t, x, y, z, vx, vy, vz, shape, heading, r, hz",
       "T, N, N, S * 3, V, V, V, 'POLYGON((-2 -9, 2 -9, 2 6, 0 9, -2 6, -2 -9))', 45 * V, S, S",
       "horizon = 9, within_z = 1", "h = 9 AND within_z = 1"},
      {"Meshes", "t, x, y, z, vx, vy, vz, shape, heading, r",
       "T, N, N, S * 3, V, V, V, CASE S WHEN 0 THEN NULL WHEN 1 THEN 'TIN Z(((-9 -9 0, 9 -9 0, 0 9 4, -9 -9 "
       "0)))' "
       "ELSE 'POLYHEDRALSURFACE Z(((0 0 -2, 0 7 0, 7 0 0, 0 0 -2)), ((0 0 -2, 7 0 0, -7 -7 0, 0 0 -2)), "
       "((0 0 -2, -7 -7 0, 0 7 0, 0 0 -2)), ((7 0 0, 0 7 0, -7 -7 0, 7 0 0)))' END, 45 * V, S",
       "horizon = 9, within = 1", "h = 9 AND within = 1"},
  };
  return all;
}

std::string LifeScript::tables() const {
  const auto table = [](const std::string& name, const char* columns) {
    return "CREATE VIRTUAL TABLE " + name + " USING moving_objects(id, " + columns + ");";
  };
  return table("ships", life_.columns) + (life_.other_columns ? table("ferries", life_.other_columns) : "") +
         "CREATE VIRTUAL TABLE alerts USING predictive_watch(ships, " + life_.options + ")";
}

std::string LifeScript::values(const char* pattern) {
  std::string text;
  for (const char* c = pattern; *c; ++c) {
    const bool is_word = (c[1] == ',' || c[1] == ' ' || c[1] == 0) && (c == pattern || c[-1] == ' ');
    if (is_word && *c == 'N')
      text += std::to_string(below(81) - 40);
    else if (is_word && *c == 'V')
      text += "(" + std::to_string(below(9) - 4) + ")";
    else if (is_word && *c == 'S')
      text += std::to_string(below(3));
    else if (is_word && *c == 'T')
      text += std::to_string(time_ - (below(4) == 0 ? 3 : 0) + (below(9) == 0 ? 4 : 0));
    else
      text += *c;
  }
  return text;
}

std::string LifeScript::change() {
  const bool of_other = life_.other_columns && below(2);
  const std::string table = of_other ? "ferries" : "ships", id = std::to_string(below(50));
  const std::string put =
      " INTO " + table + " VALUES (" + id + ", " + values(of_other ? life_.other_values : life_.values) + ")";
  switch (below(8)) {
    case 0:
      return "DELETE FROM " + table + " WHERE id = " + id;
    case 1:
      return "UPDATE OR REPLACE " + table + " SET id = " + std::to_string(below(50)) + " WHERE id = " + id;
    case 2:
      if (const char* kind = of_kinds(of_other ? life_.other_columns : life_.columns); kind && below(4))
        return "UPDATE " + table + " SET " + kind + " = " + std::to_string(below(4)) + " WHERE id = " + id;
      return "UPDATE " + table + " SET y = y + 1 WHERE id = " + id;
    case 3:  // the newest row
      return "DELETE FROM " + table + " WHERE id = (SELECT max(id) FROM " + table + ")";
    case 4:  // used again at once
      return "DELETE FROM " + table + " WHERE id = " + id + "; INSERT" + put;
    default:
      return "INSERT OR REPLACE" + put;
  }
}

std::string LifeScript::changes(int max_count) {
  std::string sql;
  for (int i = 1 + below(max_count); i > 0; --i) sql += change() + ";";
  return sql;
}

std::string LifeScript::advance() {
  const int time = below(6) == 0 ? time_ - 9 : below(9) == 0 ? time_ + 500 : time_ + 1;
  return "INSERT INTO alerts(alerts, now) VALUES('advance', " + std::to_string(time) + ");";
}

std::string LifeScript::next() {
  time_ += below(20) == 0 ? 40 : below(3);
  switch (below(12)) {
    case 0:
      return advance();
    case 1:
      return below(2) ? "INSERT INTO ships(ships) VALUES('rebuild')"
                      : "INSERT INTO ships(ships) VALUES('optimize')";
    case 2:
      return "BEGIN;" + changes(9) + "SAVEPOINT s;" + changes(9) + advance() + "ROLLBACK TO s;" + changes(3) +
             "COMMIT";
    case 3:
      return "BEGIN;" + changes(9) + advance() + "ROLLBACK";
    case 4:
      return "BEGIN;" + changes(70) + "SAVEPOINT s;" + changes(3) + "RELEASE s; COMMIT";
    case 5:
      return "BEGIN; SAVEPOINT s;" + changes(9) + advance() + "RELEASE s; COMMIT";
    case 6:
      return "BEGIN;" + changes(3) + "SELECT count(*) FROM alerts; SAVEPOINT s;" + changes(3) +
             "SELECT a, t FROM alerts WHERE b = 7; ROLLBACK TO s; SELECT count(*) FROM alerts; COMMIT";
    default:
      return change();
  }
}

}  // namespace foresee::testing
