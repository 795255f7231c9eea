#include "query/avoid/own_state.h"

#include <algorithm>

namespace foresee {
namespace {

/// Calls use(number of the record, number of the motion) for each number that both have.
template <class Record, class Motion, class Use>
void with_places(const Layout& layout, Record& record, Motion& motion, Use&& use) {
  const Offsets at = record_offsets(layout);
  const auto vector = [&](int place, auto& numbers) {
    if (place == Offsets::absent) return;
    for (int axis = 0; axis < layout.axes; ++axis)
      use(record[static_cast<std::size_t>(place + axis)], numbers[static_cast<std::size_t>(axis)]);
  };
  const auto number = [&](int place, auto& value) {
    if (place != Offsets::absent) use(record[static_cast<std::size_t>(place)], value);
  };
  number(at.t, motion.t), number(at.until, motion.until), number(at.mass, motion.mass);
  number(at.heading, motion.heading);
  vector(at.x, motion.x), vector(at.v, motion.v), vector(at.a, motion.a), vector(at.force, motion.force);
}

OwnMotion motion_in(const Layout& layout, const std::vector<double>& record) {
  OwnMotion motion;
  with_places(layout, record, motion, [](double stored, double& number) { number = stored; });
  if (motion.mass != 0)
    for (std::size_t j = 0; j < 3; ++j) motion.a[j] = motion.force[j] / motion.mass;
  return motion;
}

}  // namespace

OwnState::OwnState(const AvoidQuestion& question)
    : layout(question.own->layout),
      record(question.record),
      stored(motion_in(layout, record)),
      base(motion_from(stored, std::max(question.now, stored.t))) {}

std::vector<double> OwnState::record_of(const OwnMotion& motion) const {
  std::vector<double> numbers = record;
  with_places(layout, numbers, motion, [](double& stored_number, double number) { stored_number = number; });
  return numbers;
}

}  // namespace foresee
