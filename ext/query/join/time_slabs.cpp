#include "query/join/time_slabs.h"

#include <algorithm>
#include <cmath>

#include "base/float_environment.h"

namespace foresee {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double growth = 8;  // few slabs more, and the first ones stay short

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
  begin_ = std::max({question.now, question.queried_t.min, question.now + before(question.queried_dt.min)});
  end_ = std::min(
      {question.now + question.h, question.queried_t.max, question.now + after(question.queried_dt.max)});
  at_ = begin_;
  done_ = !(begin_ <= end_);
}

std::optional<TimeSlab> TimeSlabs::next() {
  if (done_) return {};
  const FloatEnvironment environment;
  const double begin = at_;
  double end;
  if (lengths_.instant && begin == horizon_.now) {
    lengths_.instant = false;
    end = after(begin);
  } else {
    end = begin + lengths_.first;
    lengths_.first = std::min(lengths_.first * growth, lengths_.step);
  }
  // A short remainder goes with the slab before it; so does all where a step is too short for t.
  done_ = !(begin < end && end + lengths_.first / growth < end_);
  at_ = end;
  return slab(begin, end, done_);
}

TimeSlab TimeSlabs::slab(double begin, double end, bool last) const {
  // What rounds to a t >= begin is no earlier than the double before it; what rounds to a t < end is earlier
  // than end; and nothing lies outside [now, now + h].
  const double first = begin > horizon_.now ? before(begin) : horizon_.now;
  const double length = after((last ? after(end_) : end) - first);
  return {begin > begin_ ? begin : -inf, last ? inf : end, {first, std::min(length, horizon_.h)}};
}

}  // namespace foresee
