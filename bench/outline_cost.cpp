// What does exact contact of outlines cost? Beside a textbook's: all corners of each against all edges of the
// other, in plain double.
//
//   bench_outline_cost [--quick] [ships] [stars] [points] [ships-50]
//
// Ships of 5 to 11 corners over 600 s, stars of 100 corners over 60 s, points and such a star; ships that
// come within 50 m, without a rival. The pairs are candidates: their swept boxes meet. Prints nanoseconds of
// processor time a pair, medians over repetitions in which both ran one after the other, and ratios: of
// deciding and of the first moment to the plain first moment, of that and the end to all plain moments.
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
  double within = 0;
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

Scene within(Scene scene, const char* name, double distance) {
  scene.name = name, scene.within = distance;
  return scene;
}

/// The pairs whose swept boxes meet.
std::vector<Pair> candidates(const Scene& scene, std::size_t most) {
  const auto swept = [&scene](const Fleet& fleet, std::size_t i) {
    const Extents<2> extents = fleet.outlines.empty() ? Extents<2>::none() : fleet.outlines[i].extents();
    return swept_box<2>(motion_of<2>(fleet.bodies(), i), {0, scene.h},
                        grown<2>(extents, Vec<2>::Constant(scene.within / 2)));
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

/// Both ways, one after the other.
void compare(const Scene& scene, int repetitions) {
  const std::vector<Pair> pairs = candidates(scene, 20000);
  const Setup setup{scene.a.bodies(), scene.b.bodies(), {0, scene.h}, scene.within};
  const auto contact = make_outline_contact(setup, {&scene.a, &scene.b}, 1);
  std::vector<Pair> hits;
  std::vector<ContactTimes> times;
  std::size_t plain_hits = 0;
  const auto plain = [&](bool all) {
    plain_hits = 0;
    for (const Pair& pair : pairs) plain_hits += first_touch(plain_pair(scene, pair), all) >= 0;
  };
  const auto ours = [&](TimesWanted wanted) { contact->first_contacts(pairs, wanted, hits, times); };
  enum { first, all, decided, begins, both, count };
  std::vector<double> costs[count];
  for (int i = 0; i <= repetitions; ++i)
    for (int what = 0; what < count; ++what) {
      hits.clear(), times.clear();
      const double seconds = seconds_of([&] {
        if (what == first || what == all) return plain(what == all);
        if (what == decided) return contact->decide(pairs, hits);
        ours(what == begins ? TimesWanted::begins : TimesWanted::both);
      });
      if (i > 0) costs[what].push_back(seconds * 1e9 / static_cast<double>(pairs.size()));
    }
  std::printf("%s: %zu pairs, %zu touch", scene.name, pairs.size(), hits.size());
  const bool has_rival = scene.within == 0;
  if (has_rival)
    std::printf(" (plain: %zu)\n    plain first %.0f ns, all %.0f ns", plain_hits, median(costs[first]),
                median(costs[all]));
  for (const auto& [name, what, rival] :
       {std::tuple("decide", decided, first), {"t", begins, first}, {"t, t_end", both, all}}) {
    std::printf("%s%s %.0f ns", has_rival || what != decided ? "; " : "\n    ", name, median(costs[what]));
    if (has_rival) std::printf(", %.2fx", median(costs[what]) / median(costs[rival]));
  }
  std::printf("\n");
}

int main_of(const Options& options) {
  const int repetitions = options.has("--quick") ? 3 : 15;
  for (const std::string& name : options.names({"ships", "stars", "points", "ships-50"})) {
    if (name == "ships") compare(ships(400), repetitions);
    if (name == "stars") compare(stars(60), repetitions);
    if (name == "points") compare(points(20000), repetitions);
    if (name == "ships-50") compare(within(ships(400), "the same ships, within 50 m", 50), repetitions);
  }
  return 0;
}

}  // namespace
}  // namespace foresee::bench

int main(int count, char** arguments) {
  return foresee::bench::run_program(count, arguments, foresee::bench::main_of);
}
