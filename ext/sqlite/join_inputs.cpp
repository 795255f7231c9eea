#include "sqlite/join_inputs.h"

#include <algorithm>

#include "sqlite/open_table.h"

namespace foresee {
namespace {

enum Input { in_h, in_tbl, in_within, in_other, in_now, in_method, in_within_z, in_schema };

/// The scenes of tbl and other. The same table as `other` is the same scene: pairs in both orders.
void open_scenes(const Call& call, JoinQuestion& question) {
  const auto schema = call.text(in_schema);
  const OpenScene a = open_scene(call.connection(), {call.text(in_tbl), schema});
  question.a = a.scene;
  if (const auto other = call.text(in_other)) {
    const OpenScene b = open_scene(call.connection(), {other, schema});
    question.b = b.number == a.number ? a.scene : b.scene;
  }
}

double newest_t_of(const JoinQuestion& question) {
  const double newest = newest_t(*question.a);
  return question.b ? std::max(newest, newest_t(*question.b)) : newest;
}

}  // namespace

std::vector<const char*> join_inputs() {
  return {"h", "tbl", "within", "other", "now", "method", "within_z", "schema"};
}

JoinQuestion read_join_inputs(const Call& call) {
  JoinQuestion question;
  question.h = call.required_number(in_h);
  question.within = call.number(in_within).value_or(0);
  question.within_z = call.number(in_within_z);
  if (const auto method = call.text(in_method)) question.method = join_method(*method);
  const auto now = call.number(in_now);
  open_scenes(call, question);
  question.now = now ? *now : newest_t_of(question);
  return question;
}

}  // namespace foresee
