#include "query/join/join.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/float_environment.h"
#include "query/join/join_candidates.h"
#include "query/join/join_plan.h"
#include "query/join/join_scenes.h"
#include "query/join/movers/leg_join.h"
#include "query/join/pair_kinds.h"
#include "query/join/slab_helpers.h"
#include "query/join/sorted_hits.h"

namespace foresee {

namespace {

/// The query with what a join computes with: scenes without objects that no row needs, the kinds of pairs, the
/// ownership of a tile, and a grid space. Throws Error as require_valid() does.
JoinQuestion prepared(JoinQuestion question, Interrupt& interrupt) {
  require_valid(question);
  question.helpers = useful_helpers(question.helpers);
  question = with_kinds(in_tile(without_inert(std::move(question), interrupt), interrupt));
  question.all_contacts = may_repeat_pairs(question);
  if (!question.space) question.space = std::make_shared<GridSpace>();
  return question;
}

}  // namespace

/// A join of tables without plans: the query, the contact test, the plan, and the slabs, of which one is open at a
/// time.
struct Join::ObjectJoin {
  /// `of_join`: prepared.
  ObjectJoin(JoinQuestion of_join, Interrupt& interrupt)
      : question(std::move(of_join)),
        interrupt(interrupt),
        stage(question, interrupt),
        plan(plan_join(question)),
        slabs(slabs_of(plan, question)),
        sorted(question) {}
  ~ObjectJoin() {
    close_slab();
    question.space->trim();
  }

  std::span<const JoinRow> next() {
    rows.clear();
    given = {};
    while (given.empty()) {
      interrupt.check();
      if (sorted.any())
        write_sorted();
      else if (candidates || helpers)
        process_batch();
      else if (!open_slab())
        break;
    }
    return given;
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

  /// Frees the grid of the slab.
  void close_slab() {
    candidates.reset();
    helpers.reset();
  }

  /// Gives the rows of a batch, or adds its hits if the slab has to be sorted. At the end of the slab sorts them.
  void process_batch() {
    const bool more = helpers ? process_helper_batch() : process_own_batch();
    if (more) return;
    close_slab();
    if (sorts) sorted.sort(interrupt);
  }

  /// False at the end of the slab.
  bool process_own_batch() {
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

  /// Gives some rows of the last batch of a helper, or takes the next batch. False at the end of the slab.
  bool process_helper_batch() {
    given = batch.next(stage);
    if (!given.empty()) return true;
    if (!helpers->next(batch)) return false;
    if (sorts) sorted.add(batch.hits, interrupt);
    return true;
  }

  /// Gives the rows of some sorted hits.
  void write_sorted() {
    sorted.take(hits);
    stage.write_rows(hits, rows);
    given = rows;
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
    objects_ = std::make_unique<ObjectJoin>(std::move(question), interrupt);
}

Join::~Join() = default;

std::span<const JoinRow> Join::next() {
  const FloatEnvironment environment;
  return unbroken_.run("the join", [this] { return legs_ ? legs_->next() : objects_->next(); });
}

}  // namespace foresee
