#include "query/join/slab_helpers.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "base/float_environment.h"
#include "base/parallel.h"
#include "query/join/join_candidates.h"

namespace foresee {
namespace {

constexpr std::size_t parts_ahead_per_thread = 16;
constexpr std::size_t bytes_enough = 1 << 18;          // of a batch: handing one over costs microseconds
constexpr std::size_t bytes_at_once = 1 << 12;         // of a batch that the reader waits for
constexpr std::size_t bytes_ahead = 3 * bytes_enough;  // of a partition

}  // namespace

std::size_t useful_helpers(std::size_t wanted) {
  constexpr std::size_t some = 16;
  // To count the processors takes a file of the system, and as long as a whole join of few objects.
  if (wanted <= some) return wanted;
  return std::min(wanted, std::max(some, 2 * std::size_t{std::thread::hardware_concurrency()}));
}

struct SlabHelpers::Shared {
  struct Part {
    std::deque<SlabBatch> batches;
    std::size_t bytes = 0;  // of `batches`
    std::exception_ptr failure;
    bool done = false;
  };

  Shared(const JoinQuestion& of_join, const TimeSlab& part_of_time, bool sorted, Interrupt& of_caller)
      : question(of_join),
        slab(part_of_time),
        sorts(sorted),
        interrupt(of_caller),
        candidates(divided_candidates(question, slab.horizon, interrupt)),
        parts(candidates->parts()),
        own(question, interrupt) {}

  ~Shared() {
    {
      const std::lock_guard lock(mutex);
      stop.stop();
    }
    changed.notify_all();
    threads.clear();
  }

  /// The body of a helper thread.
  void run(ContactStage& stage) noexcept {
    const FloatEnvironment environment;
    for (std::size_t i; take_part(i);) {
      try {
        answer(i, stage);
      } catch (...) {
        const std::lock_guard lock(mutex);
        parts[i].failure = std::current_exception();
      }
      const std::lock_guard lock(mutex);
      parts[i].done = true;
      changed.notify_all();
    }
  }

  /// With the mutex held.
  bool none_left() const { return taken >= parts.size(); }
  bool may_take() const { return !none_left() && taken < read + ahead; }
  bool has_room(std::size_t i) const { return parts[i].bytes < bytes_ahead; }

  bool take_part(std::size_t& part) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return stop.stopped() || none_left() || may_take(); });
    if (stop.stopped() || none_left()) return false;
    part = taken++;
    return true;
  }

  void answer(std::size_t i, ContactStage& stage) {
    const std::unique_ptr<Candidates> part = candidates->part(i, stop);
    std::vector<Pair> pairs;
    SlabBatch batch;
    for (bool more = true; more;) {
      more = answer_some(*part, stage, pairs, batch);
      if (batch.bytes() < (more ? bytes_enough : 1)) continue;
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return stop.stopped() || has_room(i); });
      stop.check();
      hand_over(i, batch);
    }
  }

  /// Appends results to the batch; false at the end of the partition.
  bool answer_some(Candidates& part, ContactStage& stage, std::vector<Pair>& pairs, SlabBatch& batch) const {
    pairs.clear();
    if (!part.next(pairs)) return false;
    const BatchProof proof = proof_of(part);
    if (sorts)
      stage.find_hits(pairs, proof, slab, batch.hits);
    else if (!stage.would_only_write(proof))
      batch.add_rows([&](std::vector<JoinRow>& rows) { stage.find_and_write(pairs, proof, slab, rows); });
    else if (stage.queries_start(slab))
      batch.add_touching(pairs);
    return true;
  }

  /// Moves the batch to the reader and reuses the memory of one that has been read. With the mutex held.
  void hand_over(std::size_t i, SlabBatch& batch) {
    parts[i].bytes += batch.bytes();
    parts[i].batches.push_back(std::move(batch));
    changed.notify_all();
    batch = {};
    if (spares.empty()) return;
    batch = std::move(spares.back());
    spares.pop_back();
    batch.clear();
  }

  /// Called by the reader: false once there are no batches left.
  bool next(SlabBatch& batch) {
    std::unique_lock lock(mutex);
    while (read < parts.size()) {
      Part& part = parts[read];
      if (!part.batches.empty()) {
        spares.push_back(std::move(batch));
        batch = std::move(part.batches.front());
        part.batches.pop_front();
        part.bytes -= batch.bytes();
        changed.notify_all();
        return true;
      }
      if (part.failure) std::rethrow_exception(part.failure);
      if (part.done) {
        ++read;
        changed.notify_all();
        continue;
      }
      const bool works = own.part ? has_room(own.number) : may_take();
      if (!works) stop.pause(lock);
      if (works && !own.part) own.number = taken++;
      lock.unlock();
      interrupt.check();
      if (works) work();
      lock.lock();
    }
    return false;
  }

  /// Answers some candidates of the caller's own partition.
  void work() {
    if (!own.part) own.part = candidates->part(own.number, interrupt);
    const bool more = answer_some(*own.part, own.stage, own.pairs, own.batch);
    if (!more) own.part.reset();
    const std::lock_guard lock(mutex);
    // If the reader waits for this partition, a small batch is handed over.
    const std::size_t enough = own.number > read ? bytes_enough : bytes_at_once;
    if (own.batch.bytes() >= (more ? enough : 1)) hand_over(own.number, own.batch);
    if (!more) parts[own.number].done = true;
  }

  const JoinQuestion& question;
  const TimeSlab slab;
  const bool sorts;
  Interrupt& interrupt;
  std::unique_ptr<DividedCandidates> candidates;
  std::size_t ahead = 0;
  std::condition_variable changed;
  WakingInterrupt stop{changed};

  std::mutex mutex;  // guards what follows
  std::vector<Part> parts;
  std::size_t taken = 0, read = 0;
  std::vector<SlabBatch> spares;

  /// The caller's own partition, on which it works while no batch is ready.
  struct Own {
    Own(const JoinQuestion& question, Interrupt& interrupt) : stage(question, interrupt) {}
    ContactStage stage;
    std::size_t number = 0;
    std::unique_ptr<Candidates> part;
    std::vector<Pair> pairs;
    SlabBatch batch;
  } own;

  std::deque<ContactStage> stages;    // one per helper
  std::vector<std::jthread> threads;  // last member: joined first
};

SlabHelpers::SlabHelpers(const JoinQuestion& question, const TimeSlab& slab, bool sorts, Interrupt& interrupt)
    : shared_(std::make_unique<Shared>(question, slab, sorts, interrupt)) {
  Shared& shared = *shared_;
  shared.ahead = parts_ahead_per_thread * (question.helpers + 1);
  shared.threads.reserve(question.helpers);
  for (std::size_t i = 0; i < question.helpers; ++i) shared.stages.emplace_back(question, shared.stop);
  for (ContactStage& stage : shared.stages) {
    try {
      shared.threads.emplace_back([&shared, &stage] { shared.run(stage); });
    } catch (const std::system_error&) {
      break;  // no more threads: the caller works too
    }
  }
}

SlabHelpers::~SlabHelpers() = default;

bool SlabHelpers::next(SlabBatch& batch) {
  return shared_->next(batch);
}

}  // namespace foresee
