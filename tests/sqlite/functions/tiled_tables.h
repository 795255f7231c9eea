// Tables of SQL for joins that are divided into tiles.
#pragma once

#include "sqlite/scene_table.h"

namespace foresee::testing {

inline const char* const all_columns = "a, b, t, t_end, dt, dt_end, t_cpa, dt_cpa, d_cpa";

/// Tables `objects` and `others` of one layout, and `tiles` whose edges are corners of both.
class TiledTables {
 public:
  TiledTables(const Layout& layout, SceneKind kind, std::size_t count = 500)
      : scene_(random_scene({.layout = layout, .kind = kind, .count = count, .seed = 31})) {
    db.exec("PRAGMA page_size = 512");  // several levels
    build_table(db, "objects", scene_);
    build_table(db, "others", random_scene({.layout = layout, .kind = kind, .count = count / 2, .seed = 32}));
    db.exec("CREATE TABLE tiles AS WITH xs(x0, x1) AS (" + intervals("x") + "), ys(y0, y1) AS (" +
            (layout.axes > 1 ? intervals("y") : "SELECT NULL, NULL") + ") SELECT * FROM xs, ys");
  }

  /// `other` and `method` as SQL writes them.
  std::string join(const std::string& other, const std::string& method, const std::string& own = "") const {
    return "predictive_join(" + number(scene_.h) + ", 'objects', " + number(scene_.within) + ", " + other +
           ", " + number(scene_.now) + ", " + method + ", NULL, NULL" + own + ") ";
  }
  std::string sweep() const {
    return "predictive_sweep(" + number(scene_.h) + ", 'objects', " + number(scene_.within) + ", " +
           number(scene_.now) + ") ";
  }

  void expect_tiles_agree(const std::string& other, const std::string& method,
                          const std::string& where = "") {
    const std::string columns = std::string("SELECT ") + all_columns + " FROM ";
    const std::string whole = db.rows(columns + join(other, method) + where + " ORDER BY a, b");
    const std::string in_tiles = db.rows(columns + "tiles CROSS JOIN " +
                                         join(other, method, ", x0, x1, y0, y1") + where + " ORDER BY a, b");
    EXPECT_TRUE(in_tiles == whole) << method << " with " << other << where << ": " << whole.substr(0, 200)
                                   << "\ntiles: " << in_tiles.substr(0, 200);
    answered += whole.size();
  }

  Database db;
  std::size_t answered = 0;

 private:
  static std::string number(double value) { return std::to_string(value); }
  std::string intervals(const std::string& axis) const {
    return "WITH cuts(c) AS (SELECT NULL UNION SELECT " + axis + "0 FROM " + sweep() +
           "WHERE id IN (3, 90, 140) " + "UNION SELECT " + axis + "1 FROM " + sweep() +
           "WHERE id IN (41, 77)) SELECT c, lead(c) OVER (ORDER BY c) FROM cuts WHERE coalesce(abs(c) < "
           "1e999, 1)";
  }

  RandomScene scene_;
};

inline const Layout tiled_layouts[] = {
    {2, Law::uniform, Shape::ball, true, false},
    {2, Law::accelerated, Shape::box, false, true},
    {3, Law::forced, Shape::cylinder, true, true},
    {1, Law::uniform, Shape::point, true, false},
    {.axes = 2, .law = Law::uniform, .shape = Shape::ball, .has_growth = true}};

}  // namespace foresee::testing
