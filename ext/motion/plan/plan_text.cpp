#include "motion/plan/plan_text.h"

#include "base/float_environment.h"
#include "base/interrupt_steps.h"
#include "base/number_text.h"
#include "motion/plan/plan_legs.h"

namespace foresee {
namespace {

constexpr unsigned steps_per_knot = 200;

class PlanReader : WktLexer {
 public:
  PlanReader(std::string_view text, Interrupt& interrupt, WktUnit unit)
      : WktLexer(text), unit_(unit), steps_(interrupt) {}

  Plan plan() {
    skip_srid(unit_);
    if (next_is("LINESTRING") || next_is("LINESTRINGM") || next_is("LINESTRINGZM")) {
      take_kind("LINESTRING");
      part();
    } else if (next_is("MULTILINESTRING") || next_is("MULTILINESTRINGM") || next_is("MULTILINESTRINGZM")) {
      take_kind("MULTILINESTRING");
      parts();
    } else {
      refuse_other_formats();
      expected("LINESTRING M or LINESTRING ZM");
    }
    must_end();
    check_plan(plan_);
    return std::move(plan_);
  }

 private:
  /// Reads the word and its M or ZM, together or apart.
  void take_kind(const std::string& word) {
    const bool in_plane = take_word(word + "M"), in_space = !in_plane && take_word(word + "ZM");
    if (!in_plane && !in_space) {
      take_word(word);
      refuse_empty();
      if (next_is("Z")) fail("write " + word + " ZM: the fourth number is the time");
      if (!next_is("M") && !next_is("ZM"))
        fail("write " + word + " M: the third number is the time, or " + word + " ZM: the fourth");
    }
    plan_.axes = in_space || (!in_plane && next_is("ZM")) ? 3 : 2;
    if (!in_plane && !in_space) take_word(plan_.axes == 3 ? "ZM" : "M");
  }

  /// What other tools write, with what to write instead.
  void refuse_other_formats() {
    const std::string_view found = token();
    if (rest().starts_with('{'))
      fail("expected LINESTRING M, found JSON: read it with json_each and plan_points(t, x, y)");
    const bool is_hex = found.size() > 18 && found.find_first_not_of("0123456789ABCDEFabcdef") == found.npos;
    if (is_hex) fail("expected LINESTRING M, found a geometry in hexadecimal digits: write ST_AsText(g, 17)");
  }

  void refuse_empty() {
    if (next_is("EMPTY")) fail("EMPTY is no plan: write NULL and x, y");
  }

  void parts() {
    refuse_empty();
    must_take('(');
    do {
      if (!plan_.knots.empty()) plan_.part_starts.push_back(plan_.knots.size());
      part();
    } while (take(','));
    must_take(')');
  }

  void part() {
    refuse_empty();
    must_take('(');
    const std::size_t first = plan_.knots.size();
    do {
      try {
        knot();
      } catch (const Error& error) {
        throw Error(std::string(error.what()) + " (knot " + std::to_string(plan_.knots.size() - first + 1) +
                    ')');
      }
    } while (take(','));
    if (!take(')')) expected(", or )");
  }

  bool next_is_infinity() { return next_is("INF") || next_is("INFINITY"); }

  /// "10 0 5": as many numbers as axes, and the time.
  void knot() {
    steps_.costly(steps_per_knot);
    rest();
    const WktLexer start = *this;
    const int wanted = plan_.axes + 1;
    Knot knot;
    for (int i = 0; i < wanted; ++i) {
      const std::string_view left = rest();
      if (i > 0 && (left.starts_with(',') || left.starts_with(')'))) refuse_count(start, i);
      if (i == plan_.axes)
        knot.t = time();
      else
        knot.x[static_cast<std::size_t>(i)] = number();
    }
    int count = wanted;
    for (; next_is_number() || next_is_infinity(); ++count) {
      steps_();
      time();
    }
    if (count != wanted) refuse_count(start, count);
    plan_.knots.push_back(knot);
  }

  [[noreturn]] void refuse_count(const WktLexer& start, int found) const {
    start.fail("expected " + std::to_string(plan_.axes + 1) +
               (plan_.axes == 3 ? " numbers (x y z t)" : " numbers (x y t)") + ", found " +
               std::to_string(found));
  }

  double time() {
    if (take_word("INF") || take_word("INFINITY")) return no_end;
    if (starts_with_date(token()))
      fail("expected a number, found '" + std::string(token()) + "': write seconds, as unixepoch('" +
           std::string(token()) + "') gives them");
    return number();
  }

  WktUnit unit_;
  Steps steps_;
  Plan plan_;
};

/// "(0 0 0, 10 0 5)"
void write_part(const Plan& plan, std::size_t part, std::string& text, Steps& steps) {
  for (std::size_t i = plan.part_starts[part]; i < plan.part_end(part); ++i) {
    steps.costly(steps_per_knot);
    text += i == plan.part_starts[part] ? "(" : ", ";
    for (int j = 0; j < plan.axes; ++j) text += shown(plan.knots[i].x[static_cast<std::size_t>(j)]) + ' ';
    text += shown(plan.knots[i].t);
  }
  text += ')';
}

}  // namespace

Plan read_plan(std::string_view text, Interrupt& interrupt, WktUnit unit) {
  const FloatEnvironment environment;
  return PlanReader(text, interrupt, unit).plan();
}

std::string write_plan(const Plan& plan, Interrupt& interrupt) {
  const FloatEnvironment environment;
  Steps steps(interrupt);
  std::string text = plan.parts() == 1 ? "LINESTRING " : "MULTILINESTRING ";
  text += plan.axes == 3 ? "ZM" : "M";
  for (std::size_t part = 0; part < plan.parts(); ++part) {
    if (plan.parts() > 1) text += part == 0 ? "(" : ", ";
    write_part(plan, part, text, steps);
  }
  return plan.parts() == 1 ? text : text + ')';
}

}  // namespace foresee
