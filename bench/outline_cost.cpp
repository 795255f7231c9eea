// What does exact contact of outlines cost? Beside a textbook's: all corners of each against all edges of the
// other, in plain double.
//
//   bench_outline_cost [--quick] [ships] [stars] [points]
//
// Ships of 5 to 11 corners over 600 s, stars of 100 corners over 60 s, points and such a star. The pairs are
// candidates: their swept boxes meet. Prints nanoseconds of processor time a pair, medians over repetitions
// in which both ran one after the other, and ratios of ours to plain, which finds the first moment: of
// deciding, of the first moment, of that and the end.
#include <cmath>
#include <cstdio>
#include <random>

#include "contact/outline_contact.h"
#include "measure.h"
#include "motion/swept_box.h"
#include "plain_outline.h"
#include "program.h"
#include "shape/outline/convex_pieces.h"

namespace foresee::bench {
namespace {

/// Objects that move uniformly, each with an outline; or points.
struct Fleet final : OutlineRows {
  std::vector<double> rows;
  std::vector<Outline> outlines;
  std::vector<ConvexPieces> cut;

  const ConvexPieces* pieces(std::size_t row) const override { return cut.empty() ? nullptr : &cut[row]; }

  static Layout layout() { return {.axes = 2, .law = Law::uniform}; }
  Bodies bodies() const { return {layout(), rows.data(), rows.size() / 4}; }
  void add(double x, double y, double vx, double vy) {
    for (const double number : {x, y, vx, vy}) rows.push_back(number);
  }
  void add(const Outline& outline) {
    outlines.push_back(outline);
    cut.push_back(convex_pieces(outline));
  }
};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /// A hull along a random course: bow and stern, and corners on both sides, some of which lie inward.
  Outline ship() {
    const int sides = static_cast<int>(number(1, 4.999));
    const double length = number(30, 150), beam = length * number(0.06, 0.09), turn = number(0, 6.283);
    std::vector<Corner> hull{{-beam, -length}, {beam, -length}};
    for (int i = 1; i <= sides; ++i) hull.push_back({beam * number(0.7, 1), length * (1.6 * i / sides - 1)});
    hull.push_back({0, length});
    for (int i = sides; i > 0; --i) hull.push_back({-beam * number(0.7, 1), length * (1.6 * i / sides - 1)});
    Outline outline;
    outline.begin_part();
    for (const Corner& c : hull)
      outline.add({c.x * std::cos(turn) + c.y * std::sin(turn), c.y * std::cos(turn) - c.x * std::sin(turn)});
    return outline;
  }

  Outline star(int corners) {
    Outline outline;
    outline.begin_part();
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * 3.14159265358979 * i / corners, r = number(50, 100);
      outline.add({r * std::cos(angle), r * std::sin(angle)});
    }
    return outline;
  }

 private:
  std::mt19937_64 random_;
};

struct Scene {
  const char* name;
  Fleet a, b;
  double h;
};

Scene ships(std::size_t count) {
  Scene scene{"ships of 5 to 11 corners, 600 s", {}, {}, 600};
  Draw draw(1);
  for (Fleet* fleet : {&scene.a, &scene.b})
    for (std::size_t i = 0; i < count; ++i) {
      fleet->add(draw.number(-6000, 6000), draw.number(-6000, 6000), draw.number(-9, 9), draw.number(-9, 9));
      fleet->add(draw.ship());
    }
  return scene;
}

Scene stars(std::size_t count) {
  Scene scene{"stars of 100 corners, 60 s", {}, {}, 60};
  Draw draw(2);
  for (Fleet* fleet : {&scene.a, &scene.b})
    for (std::size_t i = 0; i < count; ++i) {
      fleet->add(draw.number(-150, 150), draw.number(-150, 150), draw.number(-3, 3), draw.number(-3, 3));
      fleet->add(draw.star(100));
    }
  return scene;
}

Scene points(std::size_t count) {
  Scene scene{"points and a star of 100 corners, 60 s", {}, {}, 60};
  Draw draw(3);
  scene.a.add(0, 0, 1, 1);
  scene.a.add(draw.star(100));
  for (std::size_t i = 0; i < count; ++i)
    scene.b.add(draw.number(-300, 300), draw.number(-300, 300), draw.number(-9, 9), draw.number(-9, 9));
  return scene;
}

/// The pairs whose swept boxes meet.
std::vector<Pair> candidates(const Scene& scene, std::size_t most) {
  const auto swept = [&scene](const Fleet& fleet, std::size_t i) {
    const Extents<2> extents = fleet.outlines.empty() ? Extents<2>::none() : fleet.outlines[i].extents();
    return swept_box<2>(motion_of<2>(fleet.bodies(), i), {0, scene.h}, extents);
  };
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < scene.a.bodies().count; ++i) {
    const Box<2> box = swept(scene.a, i);
    for (std::uint32_t j = 0; j < scene.b.bodies().count && pairs.size() < most; ++j)
      if (box.meets(swept(scene.b, j))) pairs.push_back({i, j});
  }
  return pairs;
}

PlainOutlines plain_pair(const Scene& scene, const Pair& pair) {
  static constexpr Corner point[] = {{0, 0}};
  const double *a = scene.a.bodies().row(pair.a), *b = scene.b.bodies().row(pair.b);
  const auto ring = [](const Fleet& fleet, std::size_t i) {
    return fleet.outlines.empty() ? std::span<const Corner>(point) : fleet.outlines[i].ring(0);
  };
  return {ring(scene.a, pair.a), ring(scene.b, pair.b), b[0] - a[0], b[1] - a[1],
          b[2] - a[2],           b[3] - a[3],           scene.h};
}

/// Nanoseconds a pair.
struct Costs {
  std::vector<double> plain, decide, first, both;
};

void compare(const Scene& scene, int repetitions) {
  const std::vector<Pair> pairs = candidates(scene, 20000);
  const Setup setup{scene.a.bodies(), scene.b.bodies(), {0, scene.h}};
  const auto contact = make_outline_contact(setup, {&scene.a, &scene.b}, 1);
  std::vector<Pair> hits, decided;
  std::vector<ContactTimes> times;
  std::size_t plain_hits = 0;
  const auto cost_of = [&](auto&& work) {
    hits.clear(), times.clear();
    return seconds_of(work) * 1e9 / static_cast<double>(pairs.size());
  };
  Costs costs;
  for (int i = 0; i <= repetitions; ++i) {
    plain_hits = 0;
    const double plain = cost_of([&] {
      for (const Pair& pair : pairs) plain_hits += first_touch(plain_pair(scene, pair)) >= 0;
    });
    const double decide = cost_of([&] { contact->decide(pairs, hits); });
    const double first = cost_of([&] { contact->first_contacts(pairs, TimesWanted::begins, hits, times); });
    const double both = cost_of([&] { contact->first_contacts(pairs, TimesWanted::both, hits, times); });
    if (i == 0) continue;  // only warms up
    costs.plain.push_back(plain), costs.decide.push_back(decide);
    costs.first.push_back(first), costs.both.push_back(both);
  }
  const double plain = median(costs.plain);
  std::printf("%s: %zu pairs, %zu touch (plain: %zu)\n    plain %.0f ns", scene.name, pairs.size(),
              hits.size(), plain_hits, plain);
  for (const auto& [name, list] :
       {std::pair("decide", &costs.decide), std::pair("t", &costs.first), std::pair("t, t_end", &costs.both)})
    std::printf("; %s %.0f ns, %.2fx", name, median(*list), median(*list) / plain);
  std::printf("\n");
}

int main_of(const Options& options) {
  const int repetitions = options.has("--quick") ? 3 : 15;
  for (const std::string& name : options.names({"ships", "stars", "points"}))
    compare(name == "ships" ? ships(400) : name == "stars" ? stars(60) : points(20000), repetitions);
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
