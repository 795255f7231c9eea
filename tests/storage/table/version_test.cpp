// Version: equal only for equal contents, and as it was after every rollback.
#include "storage/table/version.h"

#include <gtest/gtest.h>

namespace foresee {
namespace {

class Versions : public ::testing::Test {
 protected:
  Versions() {
    version.note_valid(17);
    begin();
  }
  void begin() {
    journal.begin();
    version.begin();
  }
  void end(Journal::Ended how) {
    journal.end(how);
    version.end(how);
  }
  ContentVersion shown() { return version.shown(*version.seen()); }

  Journal journal;
  Version version{journal};
};

TEST_F(Versions, AFlushStoresAnotherStampForTheSameContents) {
  version.wrote(4711);
  version.note_change();
  const ContentVersion changed = shown();
  EXPECT_NE(changed, version.shown(17));
  version.wrote(4712, true);
  EXPECT_EQ(shown(), changed);
  EXPECT_EQ(version.before_first_change(), 17);
  end(Journal::Ended::committed);
  EXPECT_EQ(shown(), changed);
  EXPECT_FALSE(version.written_here());
  EXPECT_EQ(version.seen(), 4712);
}

TEST_F(Versions, ARollbackRestoresWhatTheTransactionHasFound) {
  const ContentVersion before = shown();
  version.wrote(4711);
  version.note_change();
  shown();
  version.wrote(4712, true);
  end(Journal::Ended::rolled_back);
  EXPECT_EQ(version.seen(), 17);
  EXPECT_FALSE(version.written_here());
  EXPECT_EQ(shown(), before);
}

TEST_F(Versions, ARollbackToASavepointTakesTheOwnStampBack) {
  const Journal::Mark mark = journal.set_mark();
  version.wrote(4711);
  journal.rewind(mark);
  EXPECT_FALSE(version.written_here());
  EXPECT_EQ(version.seen(), 17);
  version.wrote(4712);
  const Journal::Mark later = journal.set_mark();
  version.wrote(4713, true);
  journal.rewind(later);
  EXPECT_TRUE(version.written_here());
  EXPECT_EQ(version.seen(), 4712);
  EXPECT_EQ(version.before_first_change(), 17);
}

TEST_F(Versions, RemembersAnUnreadChangeOfACommittedTransaction) {
  const ContentVersion old = shown();
  version.wrote(4711);
  version.note_change();
  const ContentVersion first = shown();
  version.note_change();
  end(Journal::Ended::committed);
  begin();
  version.wrote(4712);
  version.note_change();
  end(Journal::Ended::rolled_back);
  EXPECT_NE(shown(), first) << "another change followed it";
  EXPECT_NE(shown(), old);
}

TEST_F(Versions, AStatementChecksTheStampOncePerTransaction) {
  StatementReadState state;
  EXPECT_FALSE(version.is_checked(&state));
  version.note_checked(&state);
  EXPECT_TRUE(version.is_checked(&state));
  EXPECT_FALSE(version.is_checked(nullptr));
  end(Journal::Ended::committed);
  EXPECT_FALSE(version.is_checked(&state));
}

}  // namespace
}  // namespace foresee
