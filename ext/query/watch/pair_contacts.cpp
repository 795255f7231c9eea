#include "query/watch/pair_contacts.h"

#include <algorithm>
#include <limits>

#include "base/float_environment.h"
#include "query/join/contact_stage.h"
#include "query/join/pair_kinds.h"

namespace foresee {
namespace {

constexpr std::size_t batch_size = 1024;

/// Stands for pairs that the caller gives: no search.
class NoCandidates final : public Candidates {
 public:
  bool next(std::vector<Pair>&) override { return false; }
};

}  // namespace

std::vector<JoinRow> pair_contacts(const JoinQuestion& queried, std::span<const Pair> pairs,
                                   Interrupt& interrupt) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const FloatEnvironment environment;
  require_valid(queried);
  std::vector<JoinRow> rows;
  if (pairs.empty()) return rows;
  std::optional<JoinQuestion> with;
  if (has_kinds(queried)) with = with_kinds(queried);
  const JoinQuestion& question = with ? *with : queried;
  ContactStage stage(question, interrupt);
  const TimeSlab all{-inf, inf, {question.now, question.h}};
  const NoCandidates none;
  std::vector<Pair> batch;
  for (std::size_t begin = 0; begin < pairs.size(); begin += batch_size) {
    interrupt.check();
    const auto part = pairs.subspan(begin, std::min(batch_size, pairs.size() - begin));
    batch.assign(part.begin(), part.end());
    if (question.kinds)
      std::erase_if(batch, [&](const Pair& pair) { return !question.kinds->may_meet(pair); });
    stage.answer(none, batch, all, rows);
  }
  return rows;
}

}  // namespace foresee
