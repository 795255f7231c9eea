#include "query/join/join.h"

#include <cmath>
#include <utility>

#include "base/float_environment.h"
#include "query/join/join_candidates.h"
#include "query/join/join_plan.h"
#include "query/join/slab_helpers.h"
#include "query/join/sorted_hits.h"
#include "query/join/tile_scenes.h"

namespace foresee {

/// A question and how far it is answered.
struct Join::Progress {
  Progress(JoinQuestion queried, Interrupt& interrupt)
      : question(with_space(in_tile(std::move(queried), interrupt))),
        interrupt(interrupt),
        stage(question, interrupt),
        plan(plan_join(question, stage.reach())),
        slabs(slabs_of(plan, question)),
        sorted(question) {}
  ~Progress() {
    candidates.reset();
    helpers.reset();
    question.space->trim();
  }

  /// The question, with a space of its own if it brings none.
  static JoinQuestion with_space(JoinQuestion question) {
    if (!question.space) question.space = std::make_shared<GridSpace>();
    return question;
  }

  /// The next slab, or the same one for what was left out of it.
  bool open_slab() {
    if (!sorted.leaves_some_out()) slab = slabs.next();
    if (!slab) return false;
    // What touches at `now` has one t.
    sorts = question.order == JoinOrder::by_t ? slab->before > std::nextafter(question.now, HUGE_VAL)
                                              : question.order != JoinOrder::any;
    if (plan.with_helpers)
      helpers = std::make_unique<SlabHelpers>(question, *slab, sorts, stage.reach(), interrupt);
    else
      candidates = join_candidates(question, plan.method, slab->horizon, stage.reach(), interrupt);
    return true;
  }

  /// One batch, or the end of the slab: then the next one may have its space.
  void advance() {
    if (helpers ? !advance_helpers() : !advance_alone()) {
      helpers.reset();
      candidates.reset();
      sorted.sort(interrupt);
    }
  }

  /// A batch's rows are given, or its hits added where the slab has to be sorted. False if there is none.
  bool advance_alone() {
    pairs.clear();
    if (!candidates->next(pairs)) return false;
    if (!sorts) {
      stage.answer(*candidates, pairs, *slab, rows);
      given = rows;
      return true;
    }
    hits.clear();
    stage.query(*candidates, pairs, *slab, hits);
    sorted.add(hits, interrupt);
    return true;
  }

  /// Some rows of a batch, or the next one.
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
  std::unique_ptr<Candidates> candidates;  // of the slab, until it has no more, or
  std::unique_ptr<SlabHelpers> helpers;
  SlabBatch batch;
  bool sorts = false;
  SortedHits sorted;
  std::vector<Pair> pairs;
  Hits hits;
  std::vector<JoinRow> rows;
  std::span<const JoinRow> given;  // the rows of one next()
};

Join::Join(JoinQuestion question, Interrupt& interrupt)
    : progress_(std::make_unique<Progress>(std::move(question), interrupt)) {}

Join::~Join() = default;

std::span<const JoinRow> Join::next() {
  const FloatEnvironment environment;
  Progress& p = *progress_;
  p.rows.clear(), p.given = {};
  while (p.given.empty()) {
    p.interrupt.check();
    if (p.sorted.any()) {
      p.sorted.take(p.hits);
      p.stage.write(p.hits, p.rows);
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
