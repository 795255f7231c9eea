#include "query/join/movers/leg_join.h"

#include <utility>

#include "query/join/join_candidates.h"
#include "query/join/pair_kinds.h"
#include "query/legs/leg_scene.h"
#include "query/tile/tile.h"

namespace foresee {
namespace {

/// A scan, and candidates of one object, are made of whole scenes.
SlabLegs::Slabs slabs_for(const JoinPlan& plan, const JoinQuestion& question) {
  if (plan.method == JoinMethod::scan || question.only_a || question.only_b) return SlabLegs::Slabs::whole;
  return plan.slabs == 1 ? SlabLegs::Slabs::one : SlabLegs::Slabs::several;
}

std::vector<TileMarks> marks_of(const std::vector<TileMarks>& whole, const SlabLegs& legs) {
  std::vector<TileMarks> marks(whole.empty() ? 0 : legs.scene()->size());
  for (std::uint32_t row = 0; row < marks.size(); ++row) marks[row] = whole[legs.leg(row)];
  return marks;
}

}  // namespace

LegJoin::LegJoin(JoinQuestion question, Interrupt& interrupt)
    : question_(std::move(question)),
      interrupt_(interrupt),
      a_(question_.a),
      other_(question_.b && question_.b != question_.a ? std::optional<Movers>(question_.b) : std::nullopt),
      b_(other_ ? *other_ : a_),
      contact_(contact_of(question_)),
      pair_(a_, b_, *contact_, {question_.now, question_.h}, interrupt),
      plan_(plan_join(question_)),
      slabs_(slabs_of(plan_, question_)),
      legs_a_(a_, leg_times_of({question_.now, question_.h}), slabs_for(plan_, question_)),
      found_(question_, a_, b_, pair_, plan_.slabs == 1 && question_.order == JoinOrder::any) {
  contact_->set_interrupt(interrupt);
  if (other_) legs_b_.emplace(b_, leg_times_of({question_.now, question_.h}), slabs_for(plan_, question_));
}

LegJoin::~LegJoin() {
  question_.space->trim();
}

JoinQuestion LegJoin::question_of_legs() const {
  JoinQuestion legs = question_;
  const SlabLegs& of_b = legs_b_ ? *legs_b_ : legs_a_;
  legs.a = legs_a_.scene();
  if (question_.b) legs.b = of_b.scene();
  // Rows are not written, but sorted as hits. Where nearly all hits are rows, their ends cost less at once.
  const bool at_once = (plan_.slabs == 1 || !plan_.with_helpers) && question_.order == JoinOrder::any &&
                       question_.queries_all_times();
  legs.order = at_once ? JoinOrder::any : JoinOrder::by_t;
  legs.wants = {.contact = true, .ends = at_once && question_.wants.ends, .approach = false};
  legs.all_contacts = question_.all_contacts && has_bent_paths(question_);
  if (legs.a == question_.a && (!question_.b || legs.b == question_.b)) return legs;
  if (question_.kinds) legs = with_kinds(std::move(legs));
  if (!question_.own) return legs;
  auto own = std::make_shared<Ownership>();
  own->needed_a = question_.own->needed_a, own->needed_b = question_.own->needed_b;
  own->a = marks_of(question_.own->a, legs_a_), own->b = marks_of(question_.own->b, of_b);
  legs.own = std::move(own);
  return legs;
}

bool LegJoin::join_slab() {
  const std::optional<TimeSlab> slab = slabs_.next();
  if (!slab) return false;
  legs_a_.take(leg_times_of(slab->horizon));
  if (legs_b_) legs_b_->take(leg_times_of(slab->horizon));
  const JoinQuestion question = question_of_legs();
  const bool is_whole = question.a == question_.a && question.b == question_.b;
  ContactStage stage(question, is_whole ? contact_ : contact_of(question), interrupt_);
  if (plan_.with_helpers) {
    SlabHelpers helpers(question, *slab, true, interrupt_);
    for (SlabBatch batch; helpers.next(batch);) add(batch.hits);
  } else {
    const auto candidates = join_candidates(question, plan_.method, slab->horizon, interrupt_);
    for (pairs_.clear(); candidates->next(pairs_); pairs_.clear()) {
      hits_.clear();
      if (found_.knows_pairs()) found_.drop_found(pairs_, legs_a_, legs_b_ ? *legs_b_ : legs_a_);
      stage.find_hits(pairs_, proof_of(*candidates), *slab, hits_);
      add(hits_);
    }
  }
  found_.finish(*slab, interrupt_);
  return true;
}

void LegJoin::add(Hits& hits) {
  found_.add(hits, legs_a_, legs_b_ ? *legs_b_ : legs_a_);
}

std::span<const JoinRow> LegJoin::next() {
  rows_.clear();
  while (rows_.empty()) {
    interrupt_.check();
    if (found_.any()) {
      found_.take(taken_, interrupt_);
      write(taken_);
    } else if (!join_slab()) {
      break;
    }
  }
  return rows_;
}

void LegJoin::write(std::span<const MoverHit> hits) {
  const auto& ids_a = a_.scene()->ids;
  const auto& ids_b = b_.scene()->ids;
  rows_.resize(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    rows_[i].a = ids_a[hits[i].legs.a], rows_[i].b = ids_b[hits[i].legs.b];
    rows_[i].contact = hits[i].times;
    if (question_.wants.approach) rows_[i].approach = pair_.closest_approach(hits[i].legs);
  }
}

}  // namespace foresee
