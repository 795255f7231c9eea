// Joins in tiles through SQL: the cost of cutting a join, on one connection, on one file and shipped.
//
//   bench_sql_tiles [--quick] [name …]                         S-1000000, P-zipf-1000000 and M-1000000
//
//   plane   own_* that leave nothing out against the warm join without
//   file    16 tiles of one file, each from opening it, against one join from opening it
//   shipped 16 tables filled by predictive_sweep: their joins together against the one of the whole, each the
//           first after loading; and the number of objects in all of them
//   sweep   predictive_sweep of a sixteenth against all; rows by id in its order
//
// The tiles cut the objects' low corners in halves four times, by x and y in turn. Processor time, medians; a
// ratio is of one repetition, the goal in brackets is that of the first workload. Fails where the tiles
// together have other numbers of pairs than the whole. (--quick: S-100000 alone.)
#include <algorithm>
#include <array>
#include <cstdio>

#include "base/axes.h"
#include "files.h"
#include "measure.h"
#include "program.h"
#include "query/sweep/sweep.h"
#include "query/tile/tile.h"
#include "shape/swept_boxes.h"
#include "sql_ours.h"

namespace foresee::bench {
namespace {

/// Tiles with equally many low corners each.
std::vector<Tile> sixteen_tiles(const Workload& w) {
  using Corner = std::array<double, 2>;
  std::vector<Corner> corners(w.count);
  const Bodies bodies = w.bodies();
  for (std::size_t i = 0; i < w.count; ++i)
    with_axes(w.layout.axes, [&]<int D>(Axes<D>) {
      const Box<D> box = swept_box<D>(bodies, i, {0, w.h}, Vec<D>::zero());
      corners[i] = {box.lower[0], D > 1 ? box.lower[1] : 0};
    });
  struct Part {
    Tile tile;
    std::vector<Corner> corners;
  };
  std::vector<Part> parts{{{}, std::move(corners)}};
  for (std::size_t cut = 0; cut < 4; ++cut) {
    const std::size_t axis = w.layout.axes == 1 ? 0 : cut % 2;
    std::vector<Part> halves;
    for (Part& part : parts) {
      const auto middle = part.corners.begin() + static_cast<std::ptrdiff_t>(part.corners.size() / 2);
      std::nth_element(part.corners.begin(), middle, part.corners.end(),
                       [&](const Corner& l, const Corner& r) { return l[axis] < r[axis]; });
      const double place = (*middle)[axis];
      Part behind{part.tile, {middle, part.corners.end()}};
      part.corners.erase(middle, part.corners.end());
      (axis == 0 ? part.tile.x1 : part.tile.y1) = place;
      (axis == 0 ? behind.tile.x0 : behind.tile.y0) = place;
      halves.push_back(std::move(part)), halves.push_back(std::move(behind));
    }
    parts = std::move(halves);
  }
  std::vector<Tile> tiles;
  for (const Part& part : parts) tiles.push_back(part.tile);
  return tiles;
}

std::string join_sql(const Workload& w, bool in_tile) {
  return "SELECT a, b, t FROM predictive_join(" + std::to_string(w.h) + ", 'ships', 0, NULL, 0" +
         (in_tile ? ", NULL, NULL, NULL, ?1, ?2, ?3, ?4)" : ")");
}

void bind(Statement& statement, const Tile& tile, int first = 1) {
  statement.bind(first, tile.x0), statement.bind(first + 1, tile.x1);
  statement.bind(first + 2, tile.y0), statement.bind(first + 3, tile.y1);
}

std::int64_t pairs_in(Database& db, const Workload& w, const Tile* tile) {
  Statement join(db, join_sql(w, tile != nullptr));
  if (tile) bind(join, *tile);
  return join.step_all();
}

struct Ratios {
  std::vector<double> ratios, wholes;

  void add(double part, double whole) { ratios.push_back(part / whole), wholes.push_back(whole); }
  void print(const Workload& w, const char* what, const char* goal) const {
    std::printf("%-18s %-8s %6.2f x of %8.3f s   (%s)\n", w.name.c_str(), what, median(ratios),
                median(wholes), goal);
    std::fflush(stdout);
  }
};

void require_equal(std::int64_t tiles, std::int64_t whole) {
  if (tiles == whole) return;
  throw Error("the tiles have " + std::to_string(tiles) + " pairs, the whole has " + std::to_string(whole));
}

void measure_plane(Database& db, const Workload& w, int repetitions) {
  const Tile plane{-1e300, 1e300, -1e300, 1e300};
  const std::int64_t whole = pairs_in(db, w, nullptr);
  Ratios times;
  for (int i = 0; i < repetitions; ++i) {
    const double warm = seconds_of([&] { pairs_in(db, w, nullptr); });
    times.add(seconds_of([&] { require_equal(pairs_in(db, w, &plane), whole); }), warm);
  }
  times.print(w, "plane", "at most 1.1");
}

void measure_file(const std::string& path, const Workload& w, const std::vector<Tile>& tiles,
                  int repetitions) {
  const auto from_opening = [&](const Tile* tile) {
    Database db(path);
    register_foresee(db);
    return pairs_in(db, w, tile);
  };
  Ratios times;
  for (int i = 0; i < repetitions; ++i) {
    std::int64_t whole = 0, together = 0;
    const double fresh = seconds_of([&] { whole = from_opening(nullptr); });
    times.add(seconds_of([&] {
                for (const Tile& tile : tiles) together += from_opening(&tile);
              }),
              fresh);
    require_equal(together, whole);
  }
  times.print(w, "file", "at most 1.3");
}

std::string sweep_sql(const Workload& w) {
  return "SELECT id FROM predictive_sweep(" + std::to_string(w.h) +
         ", 'ships', 0, 0, NULL, 'whole') WHERE x0 < ?2 AND x1 >= ?1 AND y0 < ?4 AND y1 >= ?3";
}

void measure_shipped(const std::string& path, const Workload& w, const std::vector<Tile>& tiles,
                     int repetitions) {
  Ratios times;
  double copies = 0;
  for (int i = 0; i < repetitions; ++i) {
    double in_tiles = 0;
    std::int64_t together = 0, objects = 0, whole = 0;
    for (const Tile& tile : tiles) {
      Database db(":memory:");
      create_ours(db, w);
      db.run("ATTACH '" + path + "' AS whole");
      Statement ship(db, "INSERT INTO ships SELECT * FROM whole.ships WHERE id IN (" + sweep_sql(w) + ")");
      bind(ship, tile);
      ship.step_all();
      objects += Statement(db, "SELECT * FROM ships").step_all();
      in_tiles += seconds_of([&] { together += pairs_in(db, w, &tile); });
    }
    Database db(":memory:");
    create_ours(db, w);
    load_ours(db, w);
    Statement(db, "SELECT * FROM ships").step_all();
    times.add(in_tiles, seconds_of([&] { whole = pairs_in(db, w, nullptr); }));
    require_equal(together, whole);
    copies = static_cast<double>(objects) / static_cast<double>(w.count);
  }
  times.print(w, "shipped", "at most 1.1; zipf and M 1.5");
  std::printf("%-18s %.3f copies of an object\n", "", copies);
}

void measure_sweep(Database& db, const Workload& w, const Tile& tile, int repetitions) {
  const std::string sweep = "predictive_sweep(" + std::to_string(w.h) + ", 'ships', 0, 0)";
  const std::string bounds = " b WHERE b.x0 < ?2 AND b.x1 >= ?1 AND b.y0 < ?4 AND b.y1 >= ?3";
  Statement all(db, "SELECT id, x0, x1, y0, y1 FROM " + sweep);
  Statement part(db, "SELECT id, x0, x1, y0, y1 FROM " + sweep + bounds);
  Statement rows(db, "SELECT o.* FROM " + sweep + " b CROSS JOIN ships o ON o.id = b.id" + bounds.substr(2));
  bind(part, tile), bind(rows, tile);
  Ratios times;
  std::vector<double> row_times;
  for (int i = 0; i < repetitions; ++i) {
    const double whole = seconds_of([&] { all.step_all(); });
    const double of_part = seconds_of([&] { part.step_all(); });
    times.add(of_part, whole);
    std::int64_t count = 0;
    const double of_rows = seconds_of([&] { count = rows.step_all(); });
    row_times.push_back((of_rows - of_part) / static_cast<double>(count));
  }
  times.print(w, "sweep", "at most 0.1");
  std::printf("%-18s %.2f us per row by id in its order (at most 1.5)\n", "", median(row_times) * 1e6);
}

int main_of(const Options& options) {
  const bool quick = options.has("--quick");
  const int repetitions = quick ? 3 : 5;
  const std::vector<std::string> usual = {"S-1000000", "P-zipf-1000000", "M-1000000"};
  for (const std::string& name : options.names(quick ? std::vector<std::string>{"S-100000"} : usual)) {
    const Workload w = make_workload(name);
    const std::vector<Tile> tiles = sixteen_tiles(w);
    const ScratchFile file("tiles");
    Database db(file.path);
    create_ours(db, w);
    load_ours(db, w);
    measure_plane(db, w, repetitions);
    measure_sweep(db, w, tiles[5], repetitions);
    measure_file(file.path, w, tiles, repetitions);
    measure_shipped(file.path, w, tiles, quick ? 1 : 3);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
