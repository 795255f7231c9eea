// Contact of two tables of boxes. Pairs are decided sixteen at a time in vector lanes (box_lanes.h). A pair that its
// lane leaves undecided, which is rare, is decided alone like a pair of any other shapes (set/set_traits.h).
#include <algorithm>

#include "contact/boxes/box_lanes.h"
#include "contact/contact_factories.h"
#include "contact/minkowski/contact_set.h"
#include "contact/set/set_filter.h"
#include "contact/set/set_traits.h"

namespace foresee {
namespace {

template <int D, int Degree>
class BoxContact final : public SetContact<D, Degree> {
 public:
  explicit BoxContact(const Setup& setup) : SetContact<D, Degree>(setup, contact_set(setup)) {
    std::fill_n(lanes_.end, lanes_width, setup.horizon.h);
    take_places(rows_.a, setup.a.at, setup.rule.extent[0].a);
    take_places(rows_.b, setup.b.at, setup.rule.extent[0].b);
    rows_.within = setup.rule.within(), rows_.now = setup.horizon.now;
  }

  void decide(std::span<const Pair> pairs, std::vector<Pair>& hits) override {
    const FloatEnvironment environment;
    in_lanes(pairs, false, [&](std::span<const Pair> some, Settled settled) {
      if (settled == Settled::all_touch_now) {
        hits.insert(hits.end(), some.begin(), some.end());
        return;
      }
      for (int l = 0; l < static_cast<int>(some.size()); ++l) {
        if (lanes_.misses[l] > 0) continue;
        const Pair& pair = some[static_cast<std::size_t>(l)];
        if (lanes_.touches_now[l] > 0 || lanes_.meets[l] > 0 || this->touches(pair)) hits.push_back(pair);
      }
    });
  }

  void first_contacts(std::span<const Pair> pairs, TimesWanted wanted, std::vector<Pair>& hits,
                      std::vector<ContactTimes>& times) override {
    const FloatEnvironment environment;
    const double now = setup_.horizon.now;
    in_lanes(pairs, wanted == TimesWanted::both, [&](std::span<const Pair> some, Settled settled) {
      if (settled == Settled::all_touch_now) {
        hits.insert(hits.end(), some.begin(), some.end());
        times.insert(times.end(), some.size(), {now, now, 0, 0});
        return;
      }
      find_meetings_of(some, settled);
      if (wanted == TimesWanted::both && settled == Settled::by_rows) find_ends();
      for (int l = 0; l < static_cast<int>(some.size()); ++l) {
        if (lanes_.misses[l] > 0) continue;
        const Pair& pair = some[static_cast<std::size_t>(l)];
        auto found = quick_contact(pair, l, settled, wanted);
        if (!found) found = this->first_contact(pair, any_time, wanted);
        if (!found) continue;
        hits.push_back(pair);
        times.push_back(*found);
      }
    });
  }

 private:
  /// What lanes_ holds: pairs whose rows are in rows_, other pairs, or nothing because all pairs touch now.
  enum class Settled : std::uint8_t { by_rows, by_motion, all_touch_now };

  /// Settles the pairs, up to lanes_width at a time, and calls `visit` with each group.
  template <class Visit>
  void in_lanes(std::span<const Pair> pairs, bool ends_wanted, Visit&& visit) {
    for (std::size_t begin = 0; begin < pairs.size(); begin += lanes_width) {
      const auto some = pairs.subspan(begin, std::min<std::size_t>(lanes_width, pairs.size() - begin));
      for (std::size_t l = 0; l < some.size(); ++l) fetch_ahead(setup_, pairs, begin + l);
      visit(some, settle(some, ends_wanted));
    }
  }

  Settled settle(std::span<const Pair> some, bool ends_wanted) {
    if (own_ends_ || !all_fresh(some)) {
      for (std::size_t l = 0; l < some.size(); ++l)
        put_aged(row_a(some[l]), row_b(some[l]), static_cast<int>(l));
      kernel_.settle(lanes_);
      return Settled::by_motion;
    }
    // Lanes without a pair repeat the last one.
    for (std::size_t l = 0; l < lanes_width; ++l) {
      const Pair& pair = some[std::min(l, some.size() - 1)];
      rows_.a.rows[l] = row_a(pair), rows_.b.rows[l] = row_b(pair);
    }
    return kernel_.settle_rows(rows_, ends_wanted, lanes_) ? Settled::all_touch_now : Settled::by_rows;
  }

  /// Whether the reference time of all motions is `now`.
  bool all_fresh(std::span<const Pair> some) const {
    const double now = setup_.horizon.now;
    const int t_a = setup_.a.at.t, t_b = setup_.b.at.t;
    if (t_a == Offsets::absent && t_b == Offsets::absent) return now == 0;
    return std::all_of(some.begin(), some.end(), [&](const Pair& pair) {
      return value_or(row_a(pair), t_a, 0) == now && value_or(row_b(pair), t_b, 0) == now;
    });
  }

  /// `half`: the place of the extent on the first axis; the others follow it.
  static void take_places(typename RowLanes<D>::Side& side, const Offsets& at, int half) {
    side.at_x = at.x, side.at_v = at.v, side.at_a = at.a, side.at_half = half;
  }

  /// Fills lane l with a pair of other reference times, or whose lifetime may end within the horizon.
  [[gnu::noinline]] void put_aged(const double* a, const double* b, int l) {
    const PairLifetime lifetime = pair_lifetime_of(setup_, a, b);
    const CertainMotion<D> relative = certain_motion_of<D, Degree>(setup_, a, b);
    double half[D];
    for (int j = 0; j < D; ++j) half[j] = size_as_of_t<double>(setup_.rule.extent[j], a, b);
    put_motion(lanes_, l, relative, half,
               lifetime.end_exact ? lifetime.dt_end : lifetime.dt_end * (1 + 2 * unit_roundoff));
    // A lane requires that both objects exist from now on, and times below 2^40. Other pairs are left
    // undecided.
    const bool from_now = !lifetime.none && lifetime.start_exact && lifetime.dt_start == 0;
    if (!from_now || relative.underflow > usual_underflow) lanes_.x[0][l] = std::nan("");
  }

  /// The contact times from lane l; no value if the lane does not decide them.
  std::optional<ContactTimes> quick_contact(const Pair& pair, int l, Settled settled, TimesWanted wanted) {
    const bool touches_now = lanes_.touches_now[l] > 0;
    if (!touches_now && !(lanes_.meets_first[l] > 0)) return {};
    const Instant begin =
        touches_now ? Instant{0, setup_.horizon.now} : Instant{meetings_.dt[l], meetings_.t[l]};
    Instant end = begin;
    if (wanted == TimesWanted::both && begin.known()) {
      end = settled == Settled::by_rows ? quick_end(l) : unknown_instant();
      if (!end.known()) end = this->end_of_contact(pair, touches_now ? 0 : lanes_.after[l]);
    }
    if (!begin.known() || !end.known()) return {};
    return ContactTimes{begin.t, end.t, begin.dt, end.dt};
  }

  Instant quick_end(int l) const {
    const Horizon& horizon = setup_.horizon;
    if (ends_.lasts[l] > 0) return {horizon.h, horizon.now + horizon.h};
    return ends_.leaves[l] > 0 ? Instant{endings_.dt[l], endings_.t[l]} : unknown_instant();
  }

  void find_ends() {
    for (int l = 0; l < lanes_width; ++l) ends_.from[l] = lanes_.touches_now[l] > 0 ? 0 : lanes_.after[l];
    kernel_.settle_ends(lanes_, ends_);
    if (std::none_of(ends_.leaves, ends_.leaves + lanes_width, [](double certain) { return certain > 0; }))
      return;
    kernel_.take_ends(rows_, ends_, endings_);
    kernel_.find_ends(endings_, setup_.horizon.now);
  }

  /// Finds the start times of all pairs whose lanes found a first contact.
  void find_meetings_of(std::span<const Pair> pairs, Settled settled) {
    bool any = false;
    for (int l = 0; l < static_cast<int>(pairs.size()); ++l) {
      if (!(lanes_.meets_first[l] > 0)) continue;
      any = true;
      if (settled == Settled::by_rows) break;
      put_meeting(row_a(pairs[static_cast<std::size_t>(l)]), row_b(pairs[static_cast<std::size_t>(l)]), l);
    }
    if (!any) return;
    if (settled == Settled::by_rows) kernel_.take_meetings(rows_, lanes_, meetings_);
    kernel_.find_meetings(meetings_, setup_.horizon.now);
  }

  [[gnu::flatten]] void put_meeting(const double* a, const double* b, int l) {
    const int j = static_cast<int>(lanes_.axis[l]);
    const auto [x, v, half_a] = relative_axis_motion_of<DoubleDouble>(setup_, a, b, j);
    const auto half = size_as_of_t<DoubleDouble>(setup_.rule.extent[j], a, b);
    MeetingLanes& m = meetings_;
    m.x[l] = x.high, m.v[l] = v.high, m.a[l] = half_a.high, m.half[l] = half.high;
    m.x_low[l] = x.low, m.v_low[l] = v.low, m.a_low[l] = half_a.low, m.half_low[l] = half.low;
    m.ex[l] = lanes_.ex[j][l], m.ev[l] = lanes_.ev[j][l];
    m.side[l] = lanes_.side[l], m.time[l] = lanes_.time[l], m.room[l] = lanes_.room[l];
  }

  using SetContact<D, Degree>::setup_, SetContact<D, Degree>::row_a, SetContact<D, Degree>::row_b;
  const BoxKernel<D, Degree>& kernel_ = box_kernel<D, Degree>();
  /// Lifetimes may end within the horizon, or the horizon is too long for the lanes.
  const bool own_ends_ = setup_.a.layout.has_until || setup_.b.layout.has_until || setup_.horizon.h > 0x1p39;
  RowLanes<D> rows_;
  BoxLanes<D, Degree> lanes_;
  EndLanes ends_;
  MeetingLanes meetings_, endings_;
};

}  // namespace

std::unique_ptr<Contact> make_box_contact(const Setup& setup, int degree) {
  return make_typed<BoxContact>(setup.a.layout.axes, degree, setup);
}

}  // namespace foresee
