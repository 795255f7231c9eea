// Cost of inserting and of turning an outline.
//
//   bench_outlines [--quick]
//
// Prints nanoseconds of processor time per corner, or per object (medians over repetitions). Measured are
// reading the text, checking, cutting into convex pieces, turning and checking again. The outlines are a
// ship, a ragged star of 100 corners, and hard outlines of 10,000 and 65,536 corners. These are a star, a
// comb whose teeth are slanted, so that the box of each intersects those of all, a spiral, and holes that
// touch each other.
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "measure.h"
#include "program.h"
#include "shape/outline/convex_pieces.h"
#include "shape/outline/outline_rotation.h"
#include "shape/outline/validity.h"
#include "shape/outline/wkt.h"

namespace foresee::bench {
namespace {

using Ring = std::vector<Corner>;

Outline outline_of(const std::vector<Ring>& rings) {
  Outline outline;
  for (const Ring& ring : rings) {
    outline.rings() == 0 ? outline.begin_part() : outline.begin_hole();
    for (const Corner& corner : ring) outline.add(corner);
  }
  return outline;
}

Outline ship() {
  return outline_of({{{-8, -90}, {8, -90}, {8, 60}, {0, 90}, {-8, 60}}});
}

Outline star(int corners) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> radius(20, 100);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double r = radius(random), angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return outline_of({ring});
}

Outline slanted_comb(int corners) {
  Ring ring;
  const double teeth = corners / 2 - 1;
  for (double i = 0; i < teeth; ++i) ring.push_back({i, -i}), ring.push_back({i + 1e6, 1e6 - i});
  ring.push_back({teeth, -teeth});
  ring.push_back({-1, -teeth});
  return outline_of({ring});
}

Outline spiral(int corners) {
  Ring outer, inner;
  for (int i = 0; i < corners / 2; ++i) {
    const double r = corners / 2 + 8 - i;
    static constexpr double x[] = {1, -1, -1, 1}, y[] = {1, 1, -1, -1};
    outer.push_back({r * x[i % 4], r * y[i % 4]});
    inner.push_back({(r - 1) * x[i % 4], (r - 1) * y[i % 4]});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outline_of({outer});
}

Outline holes(int corners) {
  const int count = corners / 4 - 2;
  const double end = 2 * count;
  std::vector<Ring> rings{{{0, -5}, {end, -5}, {end, 0}, {end, 5}, {0, 5}, {0, 0}}};
  for (double x = 0; x < end; x += 2) rings.push_back({{x, 0}, {x + 1, 2}, {x + 2, 0}, {x + 1, -1}});
  return outline_of(rings);
}

/// Seconds of one `work`.
double median_of(int repetitions, const std::function<void()>& work) {
  constexpr double shortest = 2e-3;  // a shorter measurement would be of the clock
  int times = 1;
  const auto seconds = [&] {
    return seconds_of([&] {
      for (int i = 0; i < times; ++i) work();
    });
  };
  while (seconds() < shortest) times *= 2;
  std::vector<double> all;
  for (int i = 0; i < repetitions; ++i) all.push_back(seconds() / times);
  return median(all);
}

void measure(const char* name, const Outline& outline, int repetitions) {
  const std::string text = write_outline(outline);
  const auto corners = static_cast<double>(outline.corners().size());
  double heading = 0;
  const auto next_heading = [&] { return heading = std::fmod(heading + 1.618, 360); };
  const ConvexPieces pieces = convex_pieces(outline);
  const Outline rotated = turned(outline, 37.5);
  const double read = median_of(repetitions, [&] { read_outline(text); });
  const double check = median_of(repetitions, [&] { check_outline(outline); });
  const double cut = median_of(repetitions, [&] { convex_pieces(outline); });
  const double turn = median_of(repetitions, [&] { turned(outline, next_heading()); });
  const double again =
      median_of(repetitions, [&] { check_turned(outline, edge_touch_of(outline), rotated, 37.5); });
  const double recut = median_of(repetitions, [&] { turned_pieces(pieces, rotated); });
  const double ns = 1e9 / corners;
  std::printf("%-14s %6.0f %7zu %9.1f %9.1f %9.1f %9.1f %9.1f %9.1f %14.1f\n", name, corners, pieces.count(),
              read * ns, check * ns, cut * ns, turn * ns, again * ns, recut * ns, (read + check + cut) * 1e6);
}

int main_of(const Options& options) {
  const int repetitions = options.has("--quick") ? 5 : 25;
  Turn turn(1);
  double heading = 0, sum = 0;
  const auto next_heading = [&] { return heading = std::fmod(heading + 1.618, 360); };
  const double object = median_of(repetitions, [&] { turn = Turn(next_heading()); });
  const double corner = median_of(repetitions, [&] { sum += turn({3.7, next_heading()}).x; });
  std::printf("a turn: %.0f ns per object, %.0f ns per corner\n\n", object * 1e9, corner * 1e9);
  if (!std::isfinite(sum)) return 1;
  std::printf("nanoseconds per corner\n%-14s %6s %7s %9s %9s %9s %9s %9s %9s %14s\n", "outline", "corners",
              "pieces", "read", "check", "cut", "turn", "re-check", "re-cut", "insert, us");
  measure("ship", ship(), repetitions);
  for (const int corners : {100, 10'000, 65'536}) measure("star", star(corners), repetitions);
  for (const int corners : {10'000, 65'536}) {
    measure("slanted comb", slanted_comb(corners), repetitions);
    measure("spiral", spiral(corners), repetitions);
    measure("holes", holes(corners), repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
