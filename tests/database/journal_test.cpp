// Journal: after a rewind every participant has the state of the mark, however marks are set and forgotten.
#include "database/journal.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

namespace foresee {
namespace {

/// Large state: a list of numbers, empty at the start of each transaction.
class Numbers final : public Journal::Participant {
 public:
  explicit Numbers(Journal& journal) : Participant(journal, Scope::marks) {}

  void add(int number) {
    join();
    all.push_back(number);
    is_logged = is_marked();
  }

  void abandon() { abandon_newest_mark(); }

  std::vector<int> all;
  bool is_logged = false;
  int kept = 0;

 private:
  std::size_t keep() override {
    ++kept;
    return all.size();
  }
  void rewind(std::size_t position) override { all.resize(position); }
  void forget() noexcept override { is_logged = false; }
  void end(Journal::Ended) noexcept override { all.clear(); }
};

struct State {
  int value;
  std::vector<int> numbers;
  friend bool operator==(const State&, const State&) = default;
};

class Journals : public ::testing::Test {
 protected:
  State now() const { return {value.get(), numbers.all}; }

  Journal journal;
  Journaled<int> value{journal, 7};
  Numbers numbers{journal};
};

TEST_F(Journals, ARewindRestoresEveryParticipantAndKeepsItsMark) {
  journal.begin();
  numbers.add(1);
  const Journal::Mark mark = journal.set_mark();
  EXPECT_FALSE(journal.rewind(mark)) << "nothing has changed";
  for (int twice = 0; twice < 2; ++twice) {
    value.change() = 8;
    numbers.add(2);
    EXPECT_TRUE(journal.rewind(mark));
    EXPECT_EQ(now(), (State{7, {1}}));
  }
  numbers.add(3);
  journal.forget(mark);
  journal.end(Journal::Ended::committed);
  EXPECT_EQ(now(), (State{7, {}}));
}

TEST_F(Journals, AMarkCostsNothingForStateThatDoesNotChange) {
  journal.begin();
  numbers.add(1);
  EXPECT_EQ(numbers.kept, 0) << "the start of the transaction needs nothing of large state";
  EXPECT_FALSE(numbers.is_logged);
  for (int i = 0; i < 5; ++i) journal.set_mark();
  numbers.add(2);
  numbers.add(3);
  EXPECT_EQ(numbers.kept, 1);
  EXPECT_TRUE(numbers.is_logged);
  journal.forget(1);
  EXPECT_FALSE(numbers.is_logged) << "no rewind can follow";
}

TEST_F(Journals, TheEndOfATransactionRestoresSmallStateIfItIsRolledBack) {
  journal.begin();
  value.change() = 8;
  journal.set_mark();
  value.change() = 9;
  journal.end(Journal::Ended::rolled_back);
  EXPECT_EQ(value.get(), 7);
  journal.begin();
  value.change() = 8;
  journal.end(Journal::Ended::committed);
  value.change() = 10;
  EXPECT_EQ(value.get(), 10);
  EXPECT_FALSE(journal.is_open());
}

TEST_F(Journals, AgreesWithCopiesThroughRandomPrograms) {
  std::mt19937 random(20261124);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::pair<Journal::Mark, State>> marks;
    journal.begin();
    const int before = value.get();
    for (int step = 0; step < 80; ++step) {
      switch (random() % 8) {
        case 0:
        case 1:
          marks.push_back({journal.set_mark(), now()});
          break;
        case 2:
          if (marks.empty()) break;
          marks.resize(random() % marks.size() + 1);
          journal.rewind(marks.back().first);
          ASSERT_EQ(now(), marks.back().second) << round << ", " << step;
          break;
        case 3: {
          if (marks.empty()) break;
          const std::size_t which = random() % marks.size();
          const State kept = now();
          journal.forget(marks[which].first);
          marks.resize(which);
          ASSERT_EQ(now(), kept);
          break;
        }
        case 4:
        case 5:
          value.change() = static_cast<int>(random());
          break;
        default:
          numbers.add(static_cast<int>(random()));
      }
    }
    const int last = value.get();
    const bool committed = random() % 2;
    journal.end(committed ? Journal::Ended::committed : Journal::Ended::rolled_back);
    ASSERT_EQ(now(), (State{committed ? last : before, {}})) << round;
  }
}

TEST_F(Journals, AnAbandonedMarkRestoresNothingOfOneParticipantAndAnOlderOneDoes) {
  journal.begin();
  numbers.add(1);
  const Journal::Mark savepoint = journal.set_mark(), change = journal.set_mark();
  numbers.add(2);
  value.change() = 8;
  EXPECT_FALSE(journal.is_abandoned(change));
  numbers.abandon();
  numbers.add(3);
  EXPECT_TRUE(numbers.is_logged) << "for the savepoint";
  EXPECT_TRUE(journal.is_abandoned(change));
  journal.rewind(change);
  EXPECT_EQ(now(), (State{7, {1, 2, 3}}));
  journal.forget(change);
  journal.rewind(savepoint);
  EXPECT_EQ(now(), (State{7, {1}}));
  journal.forget(savepoint);
  journal.set_mark();
  numbers.abandon();
  numbers.add(4);
  EXPECT_FALSE(numbers.is_logged) << "only the end of the transaction can restore it";
}

TEST_F(Journals, AParticipantMayGoWhileMarksAreSet) {
  journal.begin();
  const Journal::Mark mark = journal.set_mark();
  {
    Journaled<int> other{journal, 1};
    other.change() = 2;
    value.change() = 8;
  }
  journal.rewind(mark);
  EXPECT_EQ(value.get(), 7);
}

}  // namespace
}  // namespace foresee
