#include "query/join/question.h"

#include <string>

#include "base/error.h"
#include "base/number_text.h"
#include "contact/pair_rule.h"
#include "query/input_checks.h"

namespace foresee {
namespace {

std::string axes_of(const Scene& scene) {
  return scene.name + " has " + std::to_string(scene.layout.axes) +
         (scene.layout.axes == 1 ? " axis" : " axes");
}

void require_less(const char* lower_name, double lower, const char* upper_name, double upper) {
  if (lower < upper) return;
  throw Error(std::string(lower_name) + " must be less than " + upper_name + ": " + lower_name + " is " +
              shown(lower) + ", " + upper_name + " is " + shown(upper));
}

void require_valid(const Tile& tile, const std::shared_ptr<const Scene>& scene) {
  require_less("own_x0", tile.x0, "own_x1", tile.x1);
  const char* const given_y = tile.y0 != Tile().y0 ? "own_y0" : tile.y1 != Tile().y1 ? "own_y1" : nullptr;
  if (given_y && scene->layout.axes < 2) reject_axis({scene->name, scene, nullptr}, given_y);
  require_less("own_y0", tile.y0, "own_y1", tile.y1);
}

}  // namespace

JoinMethod join_method(std::string_view name) {
  if (name == "auto") return JoinMethod::automatic;
  if (name == "grid") return JoinMethod::grid;
  if (name == "tree") return JoinMethod::tree;
  if (name == "scan") return JoinMethod::scan;
  if (name == "gpcd") return JoinMethod::gpcd;
  throw Error("method must be 'auto', 'grid', 'tree', 'scan' or 'gpcd', not '" + std::string(name) + "'");
}

const char* name_of(JoinMethod method) {
  switch (method) {
    case JoinMethod::automatic:
      return "auto";
    case JoinMethod::grid:
      return "grid";
    case JoinMethod::tree:
      return "tree";
    case JoinMethod::scan:
      return "scan";
    case JoinMethod::gpcd:
      return "gpcd";
  }
  return "";
}

void require_valid(const JoinQuestion& question) {
  require_set(question.a != nullptr, "a join has no scene a", "JoinQuestion::a");
  for (const Scene* scene : {question.a.get(), question.b.get()}) {
    if (!scene) continue;
    require_whole(*scene);
    require_forms(*scene);
    const bool of_one = question.only_a || question.only_b;
    if (question.method == JoinMethod::tree && !of_one && !has_plans(question) && !scene->levels &&
        scene->size() > 0)
      throw Error(scene->name +
                  ": method 'tree' needs levels, which MemoryTable::all() has; choose another method");
  }
  require_not_negative("h", question.h);
  require_not_negative("within", question.within);
  if (question.within_z) require_not_negative("within_z", *question.within_z);
  require_finite("now", question.now);
  if (question.b && question.a->layout.axes != question.b->layout.axes)
    throw Error(axes_of(*question.a) + " and " + axes_of(*question.b) +
                ": a join takes two tables with the same number of axes");
  if (question.tile) require_valid(*question.tile, question.a);
  if (question.all_contacts) {
    refuse_all_contacts_of_forms(question.a->layout);
    if (question.b) refuse_all_contacts_of_forms(question.b->layout);
  }
}

PairRule::Reach reach_of(const JoinQuestion& question) {
  const Scene &a = *question.a, &b = question.side_b();
  require_distance(a.layout, b.layout, question.within_z, a.name, b.name);
  return PairRule(a.layout, b.layout, question.within, question.within_z).reach();
}

std::unique_ptr<Contact> contact_of(const JoinQuestion& question, bool rectangles_for_outlines) {
  const Scene &a = *question.a, &b = question.side_b();
  const ContactQuestion contact_question{
      {question.now, question.h}, question.within, question.within_z, rectangles_for_outlines};
  return make_contact(a.bodies(), b.bodies(), contact_question, a.name, b.name);
}

}  // namespace foresee
