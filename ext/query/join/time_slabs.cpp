#include "query/join/time_slabs.h"

#include <algorithm>
#include <cmath>

#include "base/float_environment.h"

namespace foresee {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double growth = 8;  // few additional slabs, and the first ones stay short

double after(double x) {
  return std::nextafter(x, inf);
}
double before(double x) {
  return std::nextafter(x, -inf);
}

}  // namespace

TimeSlabs::TimeSlabs(const JoinQuestion& question, const SlabLengths& lengths)
    : horizon_{question.now, question.h}, lengths_(lengths) {
  const FloatEnvironment environment;
  // A dt of at least d stands for a real number above the double before d, and so on.
  start_ = std::max({question.now, question.queried_t.min, question.now + before(question.queried_dt.min)});
  end_ = std::min(
      {question.now + question.h, question.queried_t.max, question.now + after(question.queried_dt.max)});
  at_ = start_;
  done_ = !(start_ <= end_);
}

std::optional<TimeSlab> TimeSlabs::next() {
  if (done_) return {};
  const FloatEnvironment environment;
  const double start = at_;
  double end;
  if (lengths_.instant && start == horizon_.now) {
    lengths_.instant = false;
    end = after(start);
  } else {
    end = start + lengths_.first;
    lengths_.first = std::min(lengths_.first * growth, lengths_.step);
  }
  // A short remainder belongs to the slab before it; so does everything if a step is too short to change t.
  done_ = !(start < end && end + lengths_.first / growth < end_);
  at_ = end;
  return slab(start, end, done_);
}

TimeSlab TimeSlabs::slab(double start, double end, bool last) const {
  // A time that rounds to a t >= start is no earlier than the double before start; one that rounds to a
  // t < end is earlier than end; and no time lies outside [now, now + h].
  const double first = start > horizon_.now ? before(start) : horizon_.now;
  const double length = after((last ? after(end_) : end) - first);
  return {start > start_ ? start : -inf, last ? inf : end, {first, std::min(length, horizon_.h)}};
}

}  // namespace foresee
