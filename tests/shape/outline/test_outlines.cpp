#include "shape/outline/test_outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace foresee {

namespace {

int drawn(std::mt19937_64& random, int lowest, int highest) {
  return lowest + static_cast<int>(random() % static_cast<unsigned>(highest - lowest + 1));
}

/// The boundaries of a set of cells, with the cells to the left. Where two meet in a corner only, the ring
/// turns right if `apart`, so that it does not go over to the other cell.
class CellBoundaries {
 public:
  CellBoundaries(std::vector<std::vector<bool>> cells, bool apart)
      : cells_(std::move(cells)), apart_(apart) {}

  std::vector<std::vector<Corner>> rings() {
    const int n = static_cast<int>(cells_.size());
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x < n; ++x)
        if (is_step(x, y, 0) && !taken_[{x, y, 0}]) rings_.push_back(ring_from(x, y));
    return rings_;
  }

 private:
  struct Step {
    int x, y, direction;
    friend auto operator<=>(const Step&, const Step&) = default;
  };
  static constexpr int dx[] = {1, 0, -1, 0}, dy[] = {0, 1, 0, -1};

  bool cell(int x, int y) const {
    const int n = static_cast<int>(cells_.size());
    return x >= 0 && y >= 0 && x < n && y < n &&
           cells_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  }
  /// Whether there is a cell to the left and none to the right.
  bool is_step(int x, int y, int direction) const {
    static constexpr int left_x[] = {0, -1, -1, 0}, left_y[] = {0, 0, -1, -1};
    static constexpr int right_x[] = {0, 0, -1, -1}, right_y[] = {-1, 0, 0, -1};
    return cell(x + left_x[direction], y + left_y[direction]) &&
           !cell(x + right_x[direction], y + right_y[direction]);
  }
  std::vector<Corner> ring_from(int x, int y) {
    std::vector<Corner> ring;
    int direction = 0;
    while (!taken_[{x, y, direction}]) {
      taken_[{x, y, direction}] = true;
      ring.push_back({double(x), double(y)});
      x += dx[direction], y += dy[direction];
      for (const int turn : {apart_ ? 1 : 3, 0, apart_ ? 3 : 1})
        if (is_step(x, y, (direction + turn) % 4)) {
          direction = (direction + turn) % 4;
          break;
        }
    }
    return ring;
  }

  std::vector<std::vector<bool>> cells_;
  bool apart_;
  std::map<Step, bool> taken_;
  std::vector<std::vector<Corner>> rings_;
};

double signed_area(const std::vector<Corner>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

/// Even-odd, for a point that is no corner of the grid.
bool contains(const std::vector<Corner>& ring, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y > y) != (b.y > y) && x < a.x) inside = !inside;
  }
  return inside;
}

/// The innermost ring around a hole encloses its part.
std::vector<Rings> parts_of(const std::vector<std::vector<Corner>>& rings) {
  std::vector<Rings> parts;
  for (const auto& ring : rings)
    if (signed_area(ring) > 0) parts.push_back({ring});
  for (const auto& ring : rings) {
    if (signed_area(ring) > 0) continue;
    // Just outside of the hole, within the cells around it: its first step has a cell to its left.
    const double x = ring[0].x + 0.5, y = ring[0].y + 0.5;
    Rings* around = nullptr;
    for (Rings& part : parts)
      if (contains(part[0], x, y) && (!around || signed_area(part[0]) < signed_area((*around)[0])))
        around = &part;
    if (around) around->push_back(ring);
  }
  return parts;
}

/// The ring without corners at which it goes straight on.
std::vector<Corner> simplified(const std::vector<Corner>& ring) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Corner &a = ring[(i + ring.size() - 1) % ring.size()], &b = ring[i],
                 &c = ring[(i + 1) % ring.size()];
    if (!((a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y))) kept.push_back(b);
  }
  return kept;
}

}  // namespace

Outline outline_of_parts(const std::vector<Rings>& parts) {
  Outline outline;
  for (const Rings& rings : parts)
    for (std::size_t r = 0; r < rings.size(); ++r) {
      r == 0 ? outline.begin_part() : outline.begin_hole();
      for (const Corner& corner : rings[r]) outline.add(corner);
      outline.close_ring();
    }
  return outline;
}

Outline outline_of(const Rings& rings) {
  return outline_of_parts({rings});
}

Outline random_rings(std::mt19937_64& random) {
  const int size = drawn(random, 2, 5);
  Outline outline;
  if (random() % 2 == 0) {
    const double s = size;
    outline = outline_of({{{0, 0}, {s, 0}, {s, s}, {0, s}}});
  }
  for (int r = drawn(random, 1, 3); r > 0; --r) {
    outline.rings() == 0 || drawn(random, 0, 2) == 0 ? outline.begin_part() : outline.begin_hole();
    for (int n = drawn(random, 3, 6); n > 0; --n)
      outline.add({double(drawn(random, 0, size)), double(drawn(random, 0, size))});
    outline.close_ring();
  }
  return outline;
}

Outline random_cells(std::mt19937_64& random) {
  const int n = drawn(random, 2, 6), share = drawn(random, 3, 8);
  std::vector<std::vector<bool>> cells(static_cast<std::size_t>(n),
                                       std::vector<bool>(static_cast<std::size_t>(n)));
  for (auto& row : cells)
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = drawn(random, 0, 9) < share;
  cells[0][0] = true;
  std::vector<Rings> parts = parts_of(CellBoundaries(cells, random() % 2 == 0).rings());
  const bool simple = random() % 2 == 0;
  for (Rings& rings : parts)
    for (auto& ring : rings) {
      if (simple) ring = simplified(ring);
      if (random() % 2 == 0) std::reverse(ring.begin(), ring.end());
    }
  const double a = drawn(random, -3, 3), b = drawn(random, -3, 3);
  return moved(outline_of_parts(parts), [&](const Corner& c) {
    return Corner{c.x + a * c.y, b * c.x + (a * b + 1) * c.y};
  });
}

Outline random_star(std::mt19937_64& random, int n) {
  Rings rings(1);
  std::uniform_real_distribution<double> radius(20, 100);
  for (int i = 0; i < n; ++i) {
    const double r = radius(random), angle = 2 * std::numbers::pi * i / n;
    rings[0].push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return outline_of(rings);
}

Outline comb(int teeth) {
  Rings rings(1);
  for (int i = 0; i < teeth; ++i)
    rings[0].push_back({double(i % 7) / 8, 2.0 * i}), rings[0].push_back({100, 2.0 * i + 1});
  rings[0].push_back({-1, 2.0 * teeth});
  rings[0].push_back({-1, -1});
  return outline_of(rings);
}

Outline spiral(int turns) {
  Rings rings(1);
  std::vector<Corner> inner;
  for (int i = 0; i < 4 * turns; ++i) {
    const double r = 4.0 * turns + 8 - i;
    static constexpr double x[] = {1, -1, -1, 1}, y[] = {1, 1, -1, -1};
    rings[0].push_back({r * x[i % 4], r * y[i % 4]});
    inner.push_back({(r - 1) * x[i % 4], (r - 1) * y[i % 4]});
  }
  rings[0].insert(rings[0].end(), inner.rbegin(), inner.rend());
  return outline_of(rings);
}

Outline chain_of_holes(int holes) {
  const double n = holes;
  Rings rings{{{0, -5}, {2 * n, -5}, {2 * n, 0}, {2 * n, 5}, {0, 5}, {0, 0}}};
  for (double i = 0; i < n; ++i)
    rings.push_back({{2 * i, 0}, {2 * i + 1, 2}, {2 * i + 2, 0}, {2 * i + 1, -1}});
  return outline_of(rings);
}

Outline scaled(const Outline& outline, int exponent) {
  return moved(outline, [&](const Corner& c) {
    return Corner{std::ldexp(c.x, exponent), std::ldexp(c.y, exponent)};
  });
}

Outline shaken(const Outline& outline, std::mt19937_64& random) {
  const auto neighbour = [&](double value) {
    const auto which = random() % 4;
    return which == 0   ? std::nextafter(value, HUGE_VAL)
           : which == 1 ? std::nextafter(value, -HUGE_VAL)
                        : value;
  };
  return moved(outline, [&](const Corner& c) { return Corner{neighbour(c.x), neighbour(c.y)}; });
}

}  // namespace foresee
