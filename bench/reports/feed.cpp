#include "reports/feed.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foresee::bench {
namespace {

constexpr double noise = 0.05;         // of the distance moved
constexpr double scale = 1.25;         // at most, and its inverse at least
constexpr double turn = 0.7853981634;  // 45 degrees

/// The workload's objects with t = 0 before their other columns.
Workload with_times(const Workload& workload) {
  Workload timed{workload.name, workload.layout, {}, workload.count, workload.h};
  timed.layout.has_t = true;
  const auto size = static_cast<std::ptrdiff_t>(workload.bodies().at.size);
  for (auto row = workload.rows.begin(); row != workload.rows.end(); row += size) {
    timed.rows.push_back(0);
    timed.rows.insert(timed.rows.end(), row, row + size);
  }
  return timed;
}

void turn_by(double angle, double* vector) {
  const double c = std::cos(angle), s = std::sin(angle), x = vector[0], y = vector[1];
  vector[0] = c * x - s * y, vector[1] = s * x + c * y;
}

}  // namespace

Feed::Feed(const Workload& workload) : now_(with_times(workload)), at_(now_.bodies().at) {
  const auto axes = static_cast<std::size_t>(now_.layout.axes);
  lower_.assign(axes, HUGE_VAL), upper_.assign(axes, -HUGE_VAL);
  for (std::size_t i = 0; i < now_.count; ++i)
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double x = now_.bodies().row(i)[static_cast<std::size_t>(at_.x) + axis];
      lower_[axis] = std::min(lower_[axis], x), upper_[axis] = std::max(upper_[axis], x);
    }
}

Reports Feed::random_reports(std::size_t count) {
  Reports reports;
  for (std::size_t i = 0; i < count; ++i) report(random_.below(now_.count), reports);
  return reports;
}

Reports Feed::reports_of_all() {
  std::vector<std::size_t> order(now_.count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t left = order.size(); left > 1; --left)
    std::swap(order[left - 1], order[random_.below(left)]);
  Reports reports;
  for (const std::size_t object : order) report(object, reports);
  return reports;
}

void Feed::report(std::size_t object, Reports& reports) {
  double* row = now_.rows.data() + object * static_cast<std::size_t>(at_.size);
  const double clock = static_cast<double>(++made_) / static_cast<double>(now_.count);
  move(row, clock - row[at_.t]);
  row[at_.t] = clock;
  steer(row);
  mirror(row);
  reports.objects.push_back(object);
  reports.rows.insert(reports.rows.end(), row, row + at_.size);
}

void Feed::move(double* row, double dt) {
  for (int axis = 0; axis < now_.layout.axes; ++axis) {
    const double a = at_.a == Offsets::absent ? 0 : row[at_.a + axis];
    const double moved = (row[at_.v + axis] + 0.5 * a * dt) * dt;
    row[at_.x + axis] += moved * (1 + random_.in(-noise, noise));
  }
}

void Feed::steer(double* row) {
  const bool scales = random_.below(2) == 0;
  const double by = scales ? std::pow(scale, random_.in(-1, 1)) : random_.in(-turn, turn);
  for (const int vector : {at_.v, at_.a}) {
    if (vector == Offsets::absent) continue;
    if (scales)
      for (int axis = 0; axis < now_.layout.axes; ++axis) row[vector + axis] *= by;
    else
      turn_by(by, row + vector);
  }
}

/// An object that is fast enough to pass several times is mirrored several times.
void Feed::mirror(double* row) const {
  for (int axis = 0; axis < now_.layout.axes; ++axis) {
    const double lower = lower_[static_cast<std::size_t>(axis)];
    const double side = upper_[static_cast<std::size_t>(axis)] - lower;
    double& x = row[at_.x + axis];
    if (x >= lower && x <= lower + side) continue;
    double beyond = std::fmod(x - lower, 2 * side);
    if (beyond < 0) beyond += 2 * side;
    const bool back = beyond > side;
    x = lower + (back ? 2 * side - beyond : beyond);
    if (!back) continue;
    row[at_.v + axis] = -row[at_.v + axis];
    if (at_.a != Offsets::absent) row[at_.a + axis] = -row[at_.a + axis];
  }
}

}  // namespace foresee::bench
