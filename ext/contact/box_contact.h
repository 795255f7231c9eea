// Contact of boxes: eight pairs at once where that gives certain answers, which is nearly always; one by one
// as for any other pair kind where it does not.
#pragma once

#include "contact/box_box.h"
#include "contact/box_lanes.h"
#include "contact/typed_contact.h"

namespace foresee {

/// Lane number l: a pair that exists from now to `end` (rounded up) and whose times stay below 2^40.
template <int D, int Degree>
void put_course(BoxLanes<D, Degree>& lanes, int l, const Relative<D>& relative, const double (&half)[D],
                double end) {
  for (int j = 0; j < D; ++j) {
    lanes.x[j][l] = relative.x[j], lanes.v[j][l] = relative.v[j], lanes.half[j][l] = half[j];
    lanes.ex[j][l] = relative.ex[j], lanes.ev[j][l] = relative.ev[j];
    if constexpr (Degree == 2) lanes.a[j][l] = relative.a[j];
  }
  lanes.end[l] = end;
}

template <int D, int Degree>
class BoxContact final : public TypedContact<BoxBox<D>, Degree> {
 public:
  explicit BoxContact(const Setup& setup) : TypedContact<BoxBox<D>, Degree>(setup) {}

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    in_lanes(pairs, [&](std::span<const Pair> some) {
      for (int l = 0; l < static_cast<int>(some.size()); ++l) {
        if (lanes_.misses[l] > 0) continue;
        const Pair& pair = some[static_cast<std::size_t>(l)];
        if (lanes_.touches_now[l] > 0 || lanes_.meets[l] > 0 || this->touches(row_a(pair), row_b(pair)))
          hits.push_back(pair);
      }
    });
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    ContactTimes found;
    in_lanes(pairs, [&](std::span<const Pair> some) {
      find_meetings_of(some);
      for (int l = 0; l < static_cast<int>(some.size()); ++l) {
        if (lanes_.misses[l] > 0) continue;
        const Pair& pair = some[static_cast<std::size_t>(l)];
        if (!quick_contact(pair, l, wanted, found) &&
            !this->first_contact(row_a(pair), row_b(pair), wanted, found))
          continue;
        hits.push_back(pair);
        times.push_back(found);
      }
    });
  }

 private:
  using Lanes = BoxLanes<D, Degree>;

  /// Settles the pairs, some at a time, and visits those.
  template <class Visit>
  void in_lanes(std::span<const Pair> pairs, Visit&& visit) {
    for (std::size_t begin = 0; begin < pairs.size(); begin += Lanes::width) {
      const auto some = pairs.subspan(begin, std::min<std::size_t>(Lanes::width, pairs.size() - begin));
      for (std::size_t l = 0; l < some.size(); ++l) {
        this->fetch_ahead(pairs, begin + l);
        put(row_a(some[l]), row_b(some[l]), static_cast<int>(l));
      }
      settle(lanes_);
      visit(some);
    }
  }

  [[gnu::flatten]] void put(const double* a, const double* b, int l) {
    const double now = setup_.horizon.now;
    const bool fresh = value_or(a, setup_.a.at.t, 0) == now && value_or(b, setup_.b.at.t, 0) == now;
    if (!fresh || own_ends_) return put_aged(a, b, l);
    for (int j = 0; j < D; ++j) {
      const AxisMotion from = axis_motion(setup_.a, a, j), to = axis_motion(setup_.b, b, j);
      lanes_.x[j][l] = to.x - from.x, lanes_.v[j][l] = to.v - from.v;
      lanes_.ex[j][l] = lanes_.ev[j][l] = 0;
      if constexpr (Degree == 2) lanes_.a[j][l] = 0.5 * (to.a - from.a);
    }
    const auto sizes = this->template sizes<double>(a, b);
    for (int j = 0; j < D; ++j) lanes_.half[j][l] = sizes.half[j];
    lanes_.end[l] = setup_.horizon.h;
  }

  /// Of other reference times, or with a life that may end within the horizon.
  [[gnu::noinline]] void put_aged(const double* a, const double* b, int l) {
    const Moments moments = moments_of(setup_, a, b);
    const Relative<D> relative = relative_of<D, Degree>(setup_, a, b);
    put_course(lanes_, l, relative, this->template sizes<double>(a, b).half,
               moments.end_exact ? moments.dt_end : moments.dt_end * (1 + 2 * unit_roundoff));
    // Lanes look at pairs that both exist from now on, and at no times beyond 2^40: for others, no answer.
    const bool from_now = !moments.none && moments.begin_exact && moments.dt_begin == 0;
    if (!from_now || relative.underflow > usual_underflow) lanes_.x[0][l] = std::nan("");
  }

  /// The times, where the lane tells them.
  bool quick_contact(const Pair& pair, int l, TimesWanted wanted, ContactTimes& found) const {
    const bool touches_now = lanes_.touches_now[l] > 0;
    if (!touches_now && !(lanes_.meets_first[l] > 0)) return false;
    const Instant begin =
        touches_now ? Instant{0, setup_.horizon.now} : Instant{meetings_.dt[l], meetings_.t[l]};
    Instant end = begin;
    if (wanted == TimesWanted::both && begin.known()) {
      const double *a = row_a(pair), *b = row_b(pair);
      const Moments moments = moments_of(setup_, a, b);
      const double from = touches_now ? 0 : lanes_.after[l];
      end = this->end_of_contact(this->track(a, b, moments), from, moments, a, b);
    }
    found = {begin.t, end.t, begin.dt, end.dt};
    return begin.known() && end.known();
  }

  /// Finds the moments of all pairs that meet on their lanes.
  void find_meetings_of(std::span<const Pair> pairs) {
    bool any = false;
    for (int l = 0; l < static_cast<int>(pairs.size()); ++l) {
      if (!(lanes_.meets_first[l] > 0)) continue;
      put_meeting(row_a(pairs[static_cast<std::size_t>(l)]), row_b(pairs[static_cast<std::size_t>(l)]), l);
      any = true;
    }
    if (any) find_meetings(meetings_, setup_.horizon.now);
  }

  [[gnu::flatten]] void put_meeting(const double* a, const double* b, int l) {
    const int j = static_cast<int>(lanes_.axis[l]);
    const auto course = axis_course_of<DoubleDouble>(setup_, a, b, j);
    const DoubleDouble half = this->template sizes<DoubleDouble>(a, b).half[j];
    MeetingLanes& m = meetings_;
    m.x[l] = course.x.high, m.v[l] = course.v.high, m.a[l] = course.a.high, m.half[l] = half.high;
    m.x_low[l] = course.x.low, m.v_low[l] = course.v.low, m.a_low[l] = course.a.low, m.half_low[l] = half.low;
    m.ex[l] = lanes_.ex[j][l], m.ev[l] = lanes_.ev[j][l];
    m.side[l] = lanes_.x[j][l] < 0 ? -1 : 1;
    m.moment[l] = lanes_.moment[l], m.room[l] = lanes_.after[l] - lanes_.before[l];
  }

  const double* row_a(const Pair& pair) const { return setup_.a.row(pair.a); }
  const double* row_b(const Pair& pair) const { return setup_.b.row(pair.b); }

  using TypedContact<BoxBox<D>, Degree>::setup_;
  /// Of some bodies the motion may end within the horizon, or it is too long for what lanes look at.
  const bool own_ends_ = setup_.a.layout.has_until || setup_.b.layout.has_until || setup_.horizon.h > 0x1p39;
  Lanes lanes_;
  MeetingLanes meetings_;
};

}  // namespace foresee
