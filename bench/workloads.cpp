#include "workloads.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "scenes.h"

namespace foresee::bench {
namespace {

using testing::Random;

/// The name's last part as a number.
double number_at_end(const std::string& name) {
  const double number = std::strtod(name.c_str() + name.rfind('-') + 1, nullptr);
  if (!(number > 0)) throw Error("workload '" + name + "' needs a number at its end");
  return number;
}

struct Writer {
  Workload& workload;
  Offsets at = row_offsets(workload.layout);

  double* add() {
    workload.rows.resize(workload.rows.size() + static_cast<std::size_t>(at.size));
    ++workload.count;
    return workload.rows.data() + workload.rows.size() - at.size;
  }
};

/// Members that are left out are those of S-<n>.
struct EvenScene {
  std::size_t count;
  int axes = 2;
  Shape shape = Shape::box;
  double space_per_object = 14;  ///< area or volume
  Law law = Law::accelerated;
  double h = 3;
  std::uint64_t seed = count;
};

/// A square or a cube full of objects of half extents 0.5.
Workload even_scene(const std::string& name, const EvenScene& scene) {
  Workload w{name, {scene.axes, scene.law, scene.shape}, {}, 0, scene.h};
  Writer writer{w};
  Random random(scene.seed);
  const double space = scene.space_per_object * static_cast<double>(scene.count);
  const double side = scene.axes == 2 ? std::sqrt(space) : std::cbrt(space);
  w.rows.reserve(scene.count * static_cast<std::size_t>(writer.at.size));
  for (std::size_t i = 0; i < scene.count; ++i) {
    double* row = writer.add();
    for (int axis = 0; axis < scene.axes; ++axis) {
      row[writer.at.x + axis] = random.in(0, side);
      row[writer.at.v + axis] = random.in(-3, 3);
      if (scene.law == Law::accelerated) row[writer.at.a + axis] = random.in(-0.5, 0.5);
    }
    const int sizes = writer.at.half != Offsets::absent ? writer.at.half : writer.at.r;
    std::fill(row + sizes, row + writer.at.size, 0.5);
  }
  return w;
}

/// Every hundredth object 1000 times faster, every thousandth 1000 times larger.
void mix(Workload& w) {
  const Offsets at = w.bodies().at;
  for (std::size_t i = 0; i < w.count; ++i) {
    double* row = w.rows.data() + i * static_cast<std::size_t>(at.size);
    for (int axis = 0; axis < 2; ++axis) {
      if (i % 100 == 7) row[at.v + axis] *= 1000;
      if (i % 1000 == 11) row[at.half + axis] *= 1000;
    }
  }
}

std::uint64_t morton(double x, double y) {
  const auto a = static_cast<std::uint32_t>(x * 16), b = static_cast<std::uint32_t>(y * 16);
  std::uint64_t code = 0;
  for (int bit = 0; bit < 32; ++bit)
    code |= std::uint64_t{a >> bit & 1} << (2 * bit) | std::uint64_t{b >> bit & 1} << (2 * bit + 1);
  return code;
}

void cluster(Workload& w) {
  const auto size = static_cast<std::size_t>(w.bodies().at.size);
  const auto x = static_cast<std::size_t>(w.bodies().at.x);
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < w.count; ++i)
    order.push_back({morton(w.rows[i * size + x], w.rows[i * size + x + 1]), i});
  std::sort(order.begin(), order.end());
  std::vector<double> rows;
  for (const auto& [code, i] : order)
    rows.insert(rows.end(), w.rows.begin() + static_cast<std::ptrdiff_t>(i * size),
                w.rows.begin() + static_cast<std::ptrdiff_t>((i + 1) * size));
  w.rows = std::move(rows);
}

/// The given percentage of the objects, spread evenly over the rows, is 100 times larger.
void add_giants(Workload& w, double per_cent) {
  const Offsets at = w.bodies().at;
  const auto step = static_cast<std::size_t>(100 / per_cent);
  for (std::size_t i = step / 2; i < w.count; i += step)
    for (int axis = 0; axis < 2; ++axis)
      w.rows[i * static_cast<std::size_t>(at.size) + static_cast<std::size_t>(at.half + axis)] *= 100;
}

/// Draws centres on one axis of [0, 10000].
class Centres {
 public:
  Centres(Spread spread, Random& random) : spread_(spread), random_(random) {
    double sum = 0;
    for (int k = 1; k <= 1000; ++k) cumulative_.push_back(sum += std::pow(k, -0.8));
    for (double& city : cities_) city = random_.in(0, 10000);
  }

  void draw(double* x) {
    const std::uint64_t city = random_.below(50);
    for (int axis = 0; axis < 2; ++axis) {
      if (spread_ == Spread::uniform) x[axis] = random_.in(0, 10000);
      if (spread_ == Spread::zipf) {
        const auto bin =
            std::lower_bound(cumulative_.begin(), cumulative_.end(), random_.in(0, cumulative_.back()));
        x[axis] = (static_cast<double>(bin - cumulative_.begin()) + random_.unit()) * 10;
      }
      if (spread_ == Spread::city)
        x[axis] = cities_[city * 2 + static_cast<std::uint64_t>(axis)] + 150 * normal();
    }
  }

 private:
  /// Standard normal, by Box and Muller.
  double normal() {
    return std::sqrt(-2 * std::log(1 - random_.unit())) * std::cos(6.283185307179586 * random_.unit());
  }

  Spread spread_;
  Random& random_;
  std::vector<double> cumulative_;
  double cities_[100];
};

/// Half of the objects are boxes, the others discs; twice as dense as S, since only half of the pairs count.
Workload boxes_and_discs(const std::string& name, std::size_t count) {
  const std::size_t half = count / 2;
  Workload boxes = even_scene(name, {.count = half});
  boxes.other = std::make_shared<Workload>(
      even_scene(name + " discs", {.count = half, .shape = Shape::ball, .seed = half + 1}));
  return boxes;
}

}  // namespace

std::string name_of(Spread spread) {
  const char* names[] = {"uniform", "zipf", "city"};
  return names[static_cast<int>(spread)];
}

Workload paper_workload(const PaperScene& scene, const std::string& name) {
  const Law law = scene.accelerated ? Law::accelerated : Law::uniform;
  Workload w{name, {3, law, Shape::box}, {}, 0, scene.h};
  Writer writer{w};
  Random random(scene.count + scene.seed * 0x9e3779b97f4a7c15u);
  Centres centres(scene.spread, random);
  for (std::size_t i = 0; i < scene.count; ++i) {
    double* row = writer.add();
    centres.draw(row + writer.at.x);
    row[writer.at.x + 2] = random.in(0, 50);
    for (int axis = 0; axis < 3; ++axis) {
      row[writer.at.v + axis] = random.in(-scene.v_max, scene.v_max) * (axis == 2 ? 0.1 : 1);
      const double a = axis == 2 ? 0 : random.in(-scene.a_max, scene.a_max);
      if (scene.accelerated) row[writer.at.a + axis] = a;
      row[writer.at.half + axis] = 2.5;
    }
  }
  return w;
}

Workload make_workload(const std::string& name) {
  const double number = number_at_end(name);
  const auto count = static_cast<std::size_t>(number);
  if (name.starts_with("S-")) return even_scene(name, {.count = count});
  if (name.starts_with("U-")) return even_scene(name, {.count = count, .law = Law::uniform});
  if (name.starts_with("D-")) return even_scene(name, {.count = count, .shape = Shape::ball});
  if (name.starts_with("C-"))
    return even_scene(name, {.count = count, .axes = 3, .shape = Shape::cylinder, .space_per_object = 28});
  if (name.starts_with("X-")) return boxes_and_discs(name, count);
  if (name.starts_with("G-")) {
    Workload w = even_scene(name, {.count = 100000});
    add_giants(w, number);
    return w;
  }
  if (name.starts_with("L-")) return even_scene(name, {.count = 100000, .law = Law::uniform, .h = number});
  for (Spread spread : all_spreads)
    if (name.starts_with("P-" + name_of(spread) + "-"))
      return paper_workload({.spread = spread, .count = count}, name);
  if (name.starts_with("P-cube-"))
    return even_scene(name, {.count = count, .axes = 3, .space_per_object = 40});
  if (!name.starts_with("K-") && !name.starts_with("M-")) throw Error("unknown workload '" + name + "'");
  Workload w = even_scene(name, {.count = count});
  name.starts_with("K-") ? cluster(w) : mix(w);
  return w;
}

}  // namespace foresee::bench
