#include "sqlite/extreme_scenes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace foresee::testing {
namespace {

std::string text(double number) {
  char digits[40];
  return {digits, std::to_chars(digits, digits + sizeof digits, number, std::chars_format::scientific).ptr};
}

/// Builds a scene: a table `objects` of the given columns, rows in order, ids from 1.
class Builder {
 public:
  Builder(const std::string& name, const std::string& columns) {
    scene_.name = name;
    scene_.setup = "CREATE VIRTUAL TABLE objects USING moving_objects(id, " + columns + ");\nBEGIN;\n";
  }
  int add(std::initializer_list<double> numbers) {
    scene_.setup += "INSERT INTO objects VALUES (" + std::to_string(++last_);
    for (double number : numbers) scene_.setup += ", " + text(number);
    scene_.setup += ");\n";
    return last_;
  }
  /// An expected row, with times measured from now.
  void expect(int a, int b, double dt, double dt_end) {
    const double first = std::min(a, b), second = std::max(a, b);
    scene_.expected.push_back({first, second, now_ + dt, now_ + dt_end, dt, dt_end});
  }
  void set_now(double now) { now_ = now; }

  ExtremeScene scene(double h) {
    ExtremeScene scene = scene_;
    scene.setup += "COMMIT;";
    scene.query = "SELECT a, b, t, t_end, dt, dt_end FROM predictive_join(" + text(h) +
                  ", 'objects', 0, NULL, " + text(now_) + ") ORDER BY a, b";
    std::sort(scene.expected.begin(), scene.expected.end());
    return scene;
  }

 private:
  ExtremeScene scene_;
  int last_ = 0;
  double now_ = 0;
};

/// 2^20 newtons on 2^-100 kilograms: 1.3e36 m/s^2. The discs touch after half a metre, and separate after one
/// and a half.
ExtremeScene light_mass_and_huge_force() {
  Builder b("light mass, huge force", "x, y, vx, vy, fx, fy, m, r");
  for (int pair = 0; pair < 50; ++pair) {
    const double y = 10 * pair;
    const auto light = b.add({0, y, 0, 0, 0x1p20, 0, 0x1p-100, 0.25});
    const auto still = b.add({1, y, 0, 0, 0, 0, 1, 0.25});
    b.expect(light, still, 0x1p-60, std::sqrt(3.0) * 0x1p-60);
  }
  return b.scene(1);
}

/// Discs at a micrometre per second, and three that overtake them all at a thousand kilometres per second.
ExtremeScene speeds_twelve_orders_apart() {
  Builder b("speeds twelve orders apart", "x, y, vx, vy, r");
  constexpr double slow = 0x1p-20, fast = 0x1p20;
  std::vector<int> creeping;
  for (int i = 0; i < 200; ++i) creeping.push_back(b.add({10.0 * i, 0, slow, 0, 0.5}));
  for (int k = 1; k <= 3; ++k) {
    const double start = -k * fast;
    const auto racer = b.add({start, 0, fast, 0, 0.5});
    for (int i = 0; i < 200; ++i) {
      const double distance = 10.0 * i - start;
      b.expect(creeping[static_cast<std::size_t>(i)], racer, (distance - 1) / (fast - slow),
               (distance + 1) / (fast - slow));
    }
  }
  // Head on, and touching when both have crept 2^-20.
  const auto left = b.add({0, 100, slow, 0, 0.5}), right = b.add({1 + 2 * slow, 100, -slow, 0, 0.5});
  b.expect(left, right, 1, 4);
  return b.scene(4);
}

/// Pairs of points that meet after 0.5e-12, 0.5e-11, … 0.5e12 seconds, joined with horizons 1e-12 to 1e12.
void horizons(std::vector<ExtremeScene>& scenes) {
  for (int power = -12; power <= 12; power += 3) {
    Builder b("horizon 1e" + std::to_string(power), "x, y, vx, vy");
    for (int k = -12; k <= 12; ++k) {
      const double distance = 0.5 * std::stod("1e" + std::to_string(k));
      const auto still = b.add({distance, 1000.0 * k, 0, 0}), comes = b.add({0, 1000.0 * k, 1, 0});
      if (k <= power) b.expect(still, comes, distance, distance);
    }
    scenes.push_back(b.scene(std::stod("1e" + std::to_string(power))));
  }
}

/// One second apart and two millimetres wide, where doubles are an eighth of a metre apart. One of three
/// pairs misses by an eighth.
ExtremeScene coordinates_of_1e15() {
  Builder b("coordinates of 1e15, extents of 1e-3", "x, y, vx, vy, hx, hy");
  constexpr double far = 1e15, half = 1e-3, width = 2 * half;
  for (int i = 0; i < 50; ++i) {
    const double x = far + 64 * i;
    const auto a = b.add({x, far, 1, 0, half, half}), to_a = b.add({x + 1, far, 0, 0, half, half});
    b.expect(a, to_a, 1 - width, 1 + width);
    b.add({x, -far, 1, 0.125, half, half});
    b.add({x + 1, 0.25 - far, 0, 0, half, half});  // still an eighth above when the first is below it
    const auto d = b.add({x, 0, 1, 0.125, half, half}), to_d = b.add({x + 1, 0.125, 0, 0, half, half});
    b.expect(d, to_d, 1 - width, 1 + width);
  }
  return b.scene(2);
}

/// Half a microsecond of contact at 1.7e9 seconds: dt keeps what the absolute time cannot.
ExtremeScene unix_times() {
  Builder b("Unix times, microsecond encounters", "t, x, y, vx, vy, r");
  constexpr double now = 1.7e9, speed = 4096, radius = 0x1p-10;
  b.set_now(now);
  for (int i = 0; i < 100; ++i) {
    const double y = i, distance = 1 + i;
    // The second object of each pair was reported half a second earlier.
    const auto east = b.add({now, 0, y, speed, 0, radius});
    const auto west = b.add({now - 0.5, distance + speed / 2, y, -speed, 0, radius});
    b.expect(east, west, (distance - 2 * radius) / (2 * speed), (distance + 2 * radius) / (2 * speed));
  }
  return b.scene(1);
}

/// Two columns of forty ships pass each other side by side. Their sides touch exactly, or are moved by one
/// unit in the last place.
ExtremeScene grazing_fleets(bool boxes, double apart) {
  const std::string how = apart == 1 ? "exactly" : apart < 1 ? "an ulp closer" : "an ulp farther";
  Builder b(std::string("grazing fleets of ") + (boxes ? "boxes, " : "discs, ") + how,
            boxes ? "x, y, vx, vy, hx, hy" : "x, y, vx, vy, r");
  std::vector<int> east, west;
  for (int i = 0; i < 40; ++i) {
    east.push_back(boxes ? b.add({-4.0 * i, 0, 1, 0, 0.5, 0.5}) : b.add({-4.0 * i, 0, 1, 0, 0.5}));
    west.push_back(boxes ? b.add({4.0 * i + 8, apart, -1, 0, 0.5, 0.5})
                         : b.add({4.0 * i + 8, apart, -1, 0, 0.5}));
  }
  for (std::size_t i = 0; i < 40 && apart <= 1; ++i)
    for (std::size_t j = 0; j < 40; ++j) {
      const double distance = 8 + 4.0 * static_cast<double>(i + j);
      // Discs an ulp closer: half the chord is sqrt(1 - apart^2), and 1 - apart^2 = 2^-52 - 2^-106 here.
      const double chord = boxes ? 1 : apart == 1 ? 0 : std::sqrt(0x1p-52 - 0x1p-106);
      b.expect(east[i], west[j], (distance - chord) / 2, (distance + chord) / 2);
    }
  return b.scene(1000);
}

/// Accelerated aircraft, all of which reach the origin after eight seconds.
Builder aircraft(const char* what, int count, double radius) {
  Builder b(std::to_string(count) + what, "x, y, z, vx, vy, vz, ax, ay, az, r");
  for (int i = 0; i < count; ++i) {
    // At the meeting all speeds differ by at least one, and all accelerations by so little that no two meet
    // again.
    const double v[] = {i % 16 - 7.5, i / 16 - 9.0, 16.0 + i * 7 % 11};
    const double a[] = {i * 5 % 7 / 128.0, i * 3 % 5 / 128.0, 0.25};
    double x[3], early[3];
    for (int j = 0; j < 3; ++j) x[j] = -8 * v[j] + 32 * a[j], early[j] = v[j] - 8 * a[j];
    b.add({x[0], x[1], x[2], early[0], early[1], early[2], a[0], a[1], a[2], radius});
  }
  return b;
}

ExtremeScene one_point_at_one_instant(int count) {
  Builder b = aircraft(" aircraft meet in one point", count, 0);
  for (int i = 1; i <= count; ++i)
    for (int j = i + 1; j <= count; ++j) b.expect(i, j, 8, 8);
  return b.scene(20);
}

ExtremeScene balls_at_one_instant(int count) {
  ExtremeScene scene = aircraft(" balls meet in one point", count, 0.5).scene(20);
  scene.query =
      "SELECT count(*), min(t_cpa), max(t_cpa), max(d_cpa), max(t) < 8, min(t_end) > 8, max(dt_end - dt) <= "
      "2 "
      "FROM predictive_join(20, 'objects', 0, NULL, 0)";
  scene.expected = {{count * (count - 1) / 2.0, 8, 8, 0, 1, 1, 1}};
  return scene;
}

}  // namespace

std::vector<ExtremeScene> extreme_scenes(int aircraft) {
  std::vector<ExtremeScene> scenes{light_mass_and_huge_force(), speeds_twelve_orders_apart()};
  horizons(scenes);
  scenes.push_back(coordinates_of_1e15());
  scenes.push_back(unix_times());
  for (bool boxes : {true, false})
    for (double apart : {1.0, 1 - 0x1p-53, 1 + 0x1p-52}) scenes.push_back(grazing_fleets(boxes, apart));
  scenes.push_back(one_point_at_one_instant(aircraft));
  scenes.push_back(balls_at_one_instant(aircraft));
  return scenes;
}

}  // namespace foresee::testing
