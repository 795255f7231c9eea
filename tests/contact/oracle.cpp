#include "contact/oracle.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace foresee::oracle {
namespace {

/// Contact in an interval of time: the polynomial of a region, <= 0; or a known answer.
constexpr int always = -1, never = -2;

/// The signs of the borders at a time, two per axis: of x + half, of x - half.
using Signs = std::vector<int>;

class Regions {
 public:
  explicit Regions(const Rule& rule) : rule_(rule), is_round_(rule.axes.size()) {
    for (int j : rule.round) is_round_[j] = true;
    // Around a point there is one region only.
    around_a_point_ =
        std::all_of(rule.round.begin(), rule.round.end(), [&](int j) { return is_zero(rule.half[j]); });
    for (std::size_t j = 0; j < rule.axes.size(); ++j)
      for (int side : {1, -1}) {
        Coefficients p = rule.axes[j];
        add(p, rule.half[j], side);
        borders_.emplace_back(around_a_point_ && is_round_[j] ? Integers{} : integers_of(p));
      }
  }

  const std::vector<Sturm>& borders() const { return borders_; }

  /// The region whose polynomial decides: a digit for every round axis, 0 inside, 1 below, 2 above.
  int region(const Signs& signs) const {
    for (std::size_t j = 0; j < is_round_.size(); ++j)
      if (!is_round_[j] && (signs[2 * j] < 0 || signs[2 * j + 1] > 0)) return never;
    int region = 0, weight = 1;
    for (int j : rule_.round) {
      if (around_a_point_ || signs[2 * j] < 0) region += weight;
      if (!around_a_point_ && signs[2 * j + 1] > 0) region += 2 * weight;
      weight *= 3;
    }
    return region == 0 ? always : region;
  }

  /// Squared distance minus R^2 in a region.
  const Sturm& excess(int region) {
    const auto known = excesses_.find(region);
    if (known != excesses_.end()) return known->second;
    Coefficients sum(5);
    for (std::size_t k = 0; k < rule_.radius.size(); ++k)
      for (std::size_t l = 0; l < rule_.radius.size(); ++l) sum[k + l] -= rule_.radius[k] * rule_.radius[l];
    int digits = region;
    for (int j : rule_.round) {
      const int where = digits % 3;
      digits /= 3;
      if (where == 0) continue;
      Coefficients p = rule_.axes[j];
      add(p, rule_.half[j], where == 1 ? 1 : -1);
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum[k + l] += p[k] * p[l];
    }
    return excesses_.emplace(region, integers_of(sum)).first->second;
  }

 private:
  static bool is_zero(const Coefficients& p) {
    return std::all_of(p.begin(), p.end(), [](const Exact& c) { return c.sign() == 0; });
  }
  static void add(Coefficients& p, const Coefficients& more, int sign) {
    for (std::size_t k = 0; k < more.size(); ++k) p[k] += sign > 0 ? more[k] : -more[k];
  }

  const Rule& rule_;
  std::vector<bool> is_round_;
  bool around_a_point_;
  std::vector<Sturm> borders_;
  std::map<int, Sturm> excesses_;
};

/// A time at which some borders are crossed.
struct Crossing {
  TimePoint time;
  std::vector<int> zero_here;  ///< which borders vanish
};

/// An end of the first contact: an end of the queried interval, or a root.
struct Found {
  enum { nothing, at_start, at_end, at_time } where = nothing;
  std::optional<TimePoint> time = {};
};

/// Start and end of one contact.
struct FoundContact {
  Found first, last;
};

/// Visits the intervals in order of time and keeps the first contact, or all.
class Walk {
 public:
  Walk(const Rule& rule, const QueriedInterval& queried, bool all)
      : queried_(queried), regions_(rule), all_(all) {
    std::size_t border = 0;
    for (const Sturm& sturm : regions_.borders()) {
      for (TimePoint& time : times_between(sturm, queried.begin, queried.end))
        add(time, static_cast<int>(border));
      ++border;
    }
    // Later bisection keeps separate times separate.
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.time.low < b.time.low; });
    go();
  }

  std::vector<FoundContact> contacts;

 private:
  void add(TimePoint& time, int border) {
    for (Crossing& known : crossings_)
      if (same_time(time, known.time)) {
        known.zero_here.push_back(border);
        return;
      }
    crossings_.push_back({time, {border}});
  }

  void go() {
    point({Found::at_start}, holds_at(queried_.begin));
    if (!(queried_.begin < queried_.end)) return;
    reached_ = queried_.begin;
    Crossing* before = nullptr;
    for (Crossing& next : crossings_) {
      stretch(before, &next);
      if (over_) return;
      Signs signs = signs_at(stretch_sample_);
      for (int border : next.zero_here) signs[border] = 0;
      point({Found::at_time, next.time}, holds_at(next.time, regions_.region(signs)));
      if (over_) return;
      pass(next.time);
      before = &next;
    }
    if (!(reached_ < queried_.end)) return;
    stretch(before, nullptr);
    if (!over_) point({Found::at_end}, holds_at(queried_.end));
  }

  /// From one crossing (or the start) to the next (or the end), both exclusive.
  void stretch(Crossing* from, Crossing* to) {
    stretch_sample_ = sample_before(to ? &to->time : nullptr);
    const int region = regions_.region(signs_at(stretch_sample_));
    if (region < 0) return gap(region == always);
    const Sturm& excess = regions_.excess(region);
    std::vector<TimePoint> roots = roots_within(excess, from, to);
    if (from) reached_ = from->time.high;
    for (TimePoint& root : roots) {
      gap(sign_at(excess.polynomial(), sample_before(&root)) <= 0);
      if (over_) return;
      if (root.compare(queried_.end) == 0) return;  // counts as the end
      point({Found::at_time, root}, true);
      pass(root);
    }
    gap(sign_at(excess.polynomial(), sample_before(to ? &to->time : nullptr)) <= 0);
  }

  /// Bisects the crossings until every root is certainly inside or outside.
  std::vector<TimePoint> roots_within(const Sturm& p, Crossing* from, Crossing* to) {
    const Exact low = from ? from->time.low : reached_, high = to ? to->time.high : queried_.end;
    std::vector<TimePoint> roots;
    for (TimePoint& root : times_between(p, low, high)) {
      if (from && (same_time(root, from->time) || root.low < from->time.low)) continue;
      if (to && (same_time(root, to->time) || to->time.low < root.low)) continue;
      roots.push_back(root);
    }
    return roots;
  }

  /// A number after all that has been visited and before the next crossing (or the end).
  Exact sample_before(TimePoint* time) {
    if (!time) return middle(reached_, queried_.end);
    while (!(time->low > reached_)) time->halve();
    return middle(reached_, time->low);
  }

  void pass(TimePoint& time) {
    if (time.compare(queried_.end) < 0)
      while (time.high == queried_.end) time.halve();
    reached_ = time.high;
  }

  Signs signs_at(const Exact& x) const {
    Signs signs;
    for (const Sturm& border : regions_.borders()) signs.push_back(sign_at(border.polynomial(), x));
    return signs;
  }
  bool holds_at(const Exact& x) {
    const int region = regions_.region(signs_at(x));
    return region < 0 ? region == always : sign_at(regions_.excess(region).polynomial(), x) <= 0;
  }
  bool holds_at(TimePoint& time, int region) {
    return region < 0 ? region == always : time.sign_of(regions_.excess(region)) <= 0;
  }

  void gap(bool holds) {
    if (holds) return;
    inside_ = false;
    over_ = over_ || (!all_ && !contacts.empty());
  }
  void point(const Found& where, bool holds) {
    if (!holds) return gap(false);
    if (!inside_) contacts.push_back({where, where});
    inside_ = true;
    contacts.back().last = where;
  }

  const QueriedInterval& queried_;
  Regions regions_;
  std::vector<Crossing> crossings_;
  Exact reached_, stretch_sample_;
  const bool all_;
  bool inside_ = false, over_ = false;
};

}  // namespace

Coefficients relative_axis(const testing_by_hand::Object& a, const testing_by_hand::Object& b, int axis,
                           double now) {
  auto absolute = [axis, now](const testing_by_hand::Object& o) -> Coefficients {
    const Exact s = Exact(now) - Exact(o.layout.has_t ? o.t : 0), x(o.x[axis]);
    const Exact v(o.layout.law == Law::rest ? 0 : o.v[axis]);
    const Exact acceleration(o.layout.law < Law::accelerated ? 0 : o.a[axis]);
    return {x + v * s + half(acceleration * s * s), v + acceleration * s, half(acceleration)};
  };
  Coefficients pa = absolute(a), pb = absolute(b);
  for (int k = 0; k < 3; ++k) pb[k] -= pa[k];
  return pb;
}

QueriedInterval queried_interval(const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                                 const Horizon& horizon) {
  const Exact now(horizon.now);
  QueriedInterval queried{0.0, horizon.h};
  for (const auto* o : {&a, &b}) {
    queried.begin = std::max(queried.begin, Exact(o->layout.has_t ? o->t : 0) - now);
    if (o->layout.has_until && o->until != std::numeric_limits<double>::infinity())
      queried.end = std::min(queried.end, Exact(o->until) - now);
  }
  return queried;
}

namespace {

/// Compares the answer for one contact with the exact one.
std::string compared(const FoundContact& exact, const QueriedInterval& queried, double now,
                     const ContactTimes& answer) {
  auto right = [&](const Found& found, double value, const Exact& offset) {
    return is_nearest(value, [&](const Exact& tie) {
      const Exact x = tie - offset;
      if (found.where == Found::at_start) return (queried.begin - x).sign();
      if (found.where == Found::at_end) return (queried.end - x).sign();
      return std::optional<TimePoint>(found.time)->compare(x);
    });
  };
  if (!right(exact.first, answer.dt, 0.0)) return "dt is not the nearest double";
  if (!right(exact.last, answer.dt_end, 0.0)) return "dt_end is not the nearest double";
  if (!right(exact.first, answer.t, now)) return "t is not the nearest double";
  if (!right(exact.last, answer.t_end, now)) return "t_end is not the nearest double";
  return "";
}

}  // namespace

std::string judge(const Rule& rule, const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                  const Horizon& horizon, const std::optional<ContactTimes>& answer) {
  const QueriedInterval queried = queried_interval(a, b, horizon);
  if (queried.begin > queried.end) return answer ? "a contact of objects that never exist together" : "";
  const Walk walk(rule, queried, false);
  if (walk.contacts.empty()) return answer ? "an invented contact" : "";
  if (!answer) return "a missed contact";
  return compared(walk.contacts[0], queried, horizon.now, *answer);
}

std::string judge_all(const Rule& rule, const testing_by_hand::Object& a, const testing_by_hand::Object& b,
                      const Horizon& horizon, std::span<const ContactTimes> answers) {
  const QueriedInterval queried = queried_interval(a, b, horizon);
  if (queried.begin > queried.end)
    return answers.empty() ? "" : "a contact of objects that never exist together";
  const Walk walk(rule, queried, true);
  if (walk.contacts.size() != answers.size())
    return std::to_string(answers.size()) + " contacts in place of " + std::to_string(walk.contacts.size());
  for (std::size_t i = 0; i < answers.size(); ++i)
    if (const std::string wrong = compared(walk.contacts[i], queried, horizon.now, answers[i]);
        !wrong.empty())
      return "contact " + std::to_string(i + 1) + ": " + wrong;
  return "";
}

}  // namespace foresee::oracle
