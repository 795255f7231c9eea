#include "query/join/join.h"

#include <cmath>
#include <utility>

#include "base/float_environment.h"
#include "query/join/join_candidates.h"
#include "query/join/join_plan.h"
#include "query/join/movers/leg_join.h"
#include "query/join/pair_kinds.h"
#include "query/join/slab_helpers.h"
#include "query/join/sorted_hits.h"
#include "query/join/tile_scenes.h"

namespace foresee {

namespace {

/// The same query about the objects that it needs, with a grid space of its own if the caller gives none. Throws Error
/// as require_valid() does.
JoinQuestion prepared(JoinQuestion whole, Interrupt& interrupt) {
  require_valid(whole);
  JoinQuestion question = with_kinds(in_tile(without_inert(std::move(whole)), interrupt));
  // Straight paths of two objects meet once at most.
  if (!has_plans(question) && !has_bent_paths(question)) question.all_contacts = false;
  if (!question.space) question.space = std::make_shared<GridSpace>();
  return question;
}

}  // namespace

/// The state of a join: the query, the contact test, the plan, and the slabs, of which one is open at a time.
struct Join::Progress {
  /// `whole`: prepared, and of tables without plans.
  Progress(JoinQuestion whole, Interrupt& interrupt)
      : question(std::move(whole)),
        interrupt(interrupt),
        stage(question, interrupt),
        plan(plan_join(question)),
        slabs(slabs_of(plan, question)),
        sorted(question) {}
  ~Progress() {
    candidates.reset();
    helpers.reset();
    question.space->trim();
  }

  /// Opens the next slab, or the same one again for the hits that were left out.
  bool open_slab() {
    if (!sorted.take_left_out()) slab = slabs.next();
    if (!slab) return false;
    // A slab of pairs that touch at `now` has a single t: already in order.
    sorts = question.order == JoinOrder::by_t ? slab->before > std::nextafter(question.now, HUGE_VAL)
                                              : question.order != JoinOrder::any;
    if (plan.with_helpers)
      helpers = std::make_unique<SlabHelpers>(question, *slab, sorts, interrupt);
    else
      candidates = join_candidates(question, plan.method, slab->horizon, interrupt);
    return true;
  }

  /// Processes one batch, or closes the slab: sorts its hits and frees its grid.
  void advance() {
    if (helpers ? advance_helpers() : advance_alone()) return;
    helpers.reset();
    candidates.reset();
    sorted.sort(interrupt);
  }

  /// Gives the rows of a batch, or adds its hits if the slab has to be sorted. False at the end of the slab.
  bool advance_alone() {
    pairs.clear();
    if (!candidates->next(pairs)) return false;
    if (!sorts) {
      stage.find_and_write(pairs, proof_of(*candidates), *slab, rows);
      given = rows;
      return true;
    }
    hits.clear();
    stage.find_hits(pairs, proof_of(*candidates), *slab, hits);
    sorted.add(hits, interrupt);
    return true;
  }

  /// Gives some rows of a batch, or reads the next batch. False at the end of the slab.
  bool advance_helpers() {
    given = batch.next(stage);
    if (!given.empty()) return true;
    if (!helpers->next(batch)) return false;
    if (sorts) sorted.add(batch.hits, interrupt);
    return true;
  }

  JoinQuestion question;
  Interrupt& interrupt;
  ContactStage stage;
  JoinPlan plan;
  TimeSlabs slabs;
  std::optional<TimeSlab> slab;
  std::unique_ptr<Candidates> candidates;  // of the open slab, or else:
  std::unique_ptr<SlabHelpers> helpers;
  SlabBatch batch;
  bool sorts = false;
  SortedHits sorted;
  std::vector<Pair> pairs;
  Hits hits;
  std::vector<JoinRow> rows;
  std::span<const JoinRow> given;  // the result of one next()
};

Join::Join(JoinQuestion question, Interrupt& interrupt) {
  question = prepared(std::move(question), interrupt);
  if (has_plans(question))
    legs_ = std::make_unique<LegJoin>(std::move(question), interrupt);
  else
    progress_ = std::make_unique<Progress>(std::move(question), interrupt);
}

Join::~Join() = default;

std::span<const JoinRow> Join::next() {
  const FloatEnvironment environment;
  if (legs_) return legs_->next();
  Progress& p = *progress_;
  p.rows.clear(), p.given = {};
  while (p.given.empty()) {
    p.interrupt.check();
    if (p.sorted.any()) {
      p.sorted.take(p.hits);
      p.stage.write_rows(p.hits, p.rows);
      p.given = p.rows;
    } else if (p.candidates || p.helpers) {
      p.advance();
    } else if (!p.open_slab()) {
      break;
    }
  }
  return p.given;
}

}  // namespace foresee
