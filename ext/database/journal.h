// Undo journal of one table: restores in memory what a rollback takes back, whichever object holds it.
//
//   Journal journal;
//   Journaled<int> count(journal, 7);
//   journal.begin();                                    // a transaction
//   const Journal::Mark mark = journal.set_mark();
//   count.change() = 8;
//   journal.rewind(mark);                               // count.get() == 7 again; the mark stays
//   journal.forget(mark);                               // nothing will be rewound to it
//   journal.end(Journal::Ended::committed);
//
// A savepoint and the change of one statement are both marks, which form a stack; the start of a transaction
// is the lowest one. State that a rollback restores is a participant, so new transactional state is one class,
// or one Journaled<T>. A participant joins a mark with its first change after it. So a mark costs nothing for
// state that does not change, and a statement pays only for what it changes.
//
// Large state, such as nodes, keeps nothing for the start of the transaction (Scope::marks): SQLite restores the
// rows, so it forgets what the transaction changed and reads again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace foresee {

class Journal {
 public:
  using Mark = std::size_t;  ///< its depth in the stack
  enum class Ended : std::uint8_t { committed, rolled_back };

  class Participant {
   public:
    enum class Scope : std::uint8_t { marks, transaction };

    /// The journal must outlive it.
    Participant(Journal& journal, Scope scope);
    Participant(const Participant&) = delete;
    Participant& operator=(const Participant&) = delete;
    virtual ~Participant();

   protected:
    /// Call it before each change. If it throws, nothing has changed. Cost: a comparison; once per mark, keep().
    /// Without a transaction, as after Journal::end(), both numbers are 0, and nothing is kept.
    void join() {
      if (joined_ != journal_.newest_) journal_.join(*this);
    }
    /// True if a change may be rewound: then a log is kept. Scope::marks keeps nothing for the lowest mark, and
    /// nothing is kept for an abandoned newest one.
    bool is_marked() const {
      const std::size_t unused =
          std::size_t{scope_ == Scope::marks} + std::size_t{abandoned_ == journal_.newest_};
      return journal_.depth_ > unused;
    }
    /// The newest mark can restore this state no more, because rows were written: what it keeps is passed on.
    void abandon_newest_mark() { journal_.abandon(*this); }
    /// Calls each(position) for every mark that this has joined.
    template <class Each>
    void for_each_position(Each each) const {
      for (std::size_t depth = 0; depth < journal_.depth_; ++depth)
        for (const Joined& joined : journal_.levels_[depth].joined)
          if (joined.participant == this) each(joined.position);
    }

   private:
    friend class Journal;

    /// Prepares a later rewind() to the present state, and returns its position.
    virtual std::size_t keep() = 0;
    /// If it throws, only the end of the transaction restores this.
    virtual void rewind(std::size_t position) = 0;
    /// No rewind() to this position follows; one to an older position may.
    virtual void merge(std::size_t /*newer*/) noexcept {}
    /// No rewind() to any position so far follows.
    virtual void forget() noexcept {}
    /// The transaction has ended, or all of it is rolled back. Scope::transaction is already restored.
    virtual void end(Ended how) noexcept = 0;

    Journal& journal_;
    Scope scope_;
    std::uint64_t joined_ = 0;     ///< number of the mark that it has joined last; 0: none
    std::uint64_t abandoned_ = 0;  ///< … that it has abandoned last
  };

  /// A transaction starts. Requires: none is open.
  void begin();
  bool is_open() const { return depth_ > 0; }
  /// False after a rewind() that threw, until end().
  bool is_whole() const { return is_whole_; }
  /// Requires: a transaction is open.
  Mark set_mark();
  /// Restores the state as of the mark and forgets newer ones. Returns whether anything had changed. If it throws,
  /// only end() restores the state.
  bool rewind(Mark mark);
  /// True if a participant cannot be rewound to the mark. Requires: no newer mark is set.
  bool is_abandoned(Mark mark) const { return levels_[mark].abandoned; }
  /// Forgets the mark and all newer ones; the state stays.
  void forget(Mark mark) noexcept;
  /// Forgets all marks. Rolled back: restores the state as of begin().
  void end(Ended how) noexcept;

 private:
  struct Joined {
    Participant* participant;
    std::size_t position;
    std::uint64_t before;  ///< number of the mark that it had joined before
  };
  struct Level {
    std::uint64_t number = 0;
    bool abandoned = false;
    std::vector<Joined> joined = {};
  };

  /// Memory for all participants at each mark, so that nothing that follows can fail for lack of it. push() does it for
  /// its mark.
  void reserve();
  void push();
  void pop() noexcept;
  void join(Participant& participant);
  void abandon(Participant& participant);
  bool rewind_level(Level& level);
  /// The mark above `depth` marks no longer restores this participant: the newest of those takes its position.
  void pass_on(const Joined& passed, std::size_t depth) noexcept;
  static bool has(const Level& level, const Participant& participant) noexcept;
  bool has_joined(const Level& level, const Joined& passed) const noexcept;

  std::vector<Participant*> participants_;
  std::vector<Level> levels_;  ///< those from depth_ on are unused, and keep their memory
  std::size_t depth_ = 0;
  bool is_whole_ = true;
  std::uint64_t newest_ = 0;  ///< number of the newest mark; 0: no transaction
  std::uint64_t last_ = 0;    ///< the last number given; the first is 1
};

/// A small value that rollbacks restore: at each mark after which it changes, it is copied once.
template <class T>
class Journaled final : public Journal::Participant {
 public:
  explicit Journaled(Journal& journal, T value = {})
      : Participant(journal, Scope::transaction), value_(std::move(value)) {}

  const T& get() const { return value_; }
  const T* operator->() const { return &value_; }
  T& change() {
    join();
    return value_;
  }

 private:
  std::size_t keep() override {
    log_.push_back(value_);
    return log_.size() - 1;
  }
  void rewind(std::size_t position) noexcept override {
    value_ = std::move(log_[position]);
    merge(position);
  }
  void merge(std::size_t newer) noexcept override {
    log_.erase(log_.begin() + static_cast<std::ptrdiff_t>(newer), log_.end());
  }
  void end(Journal::Ended) noexcept override { log_.clear(); }

  T value_;
  std::vector<T> log_;
};

}  // namespace foresee
