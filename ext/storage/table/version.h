// Version of a table's contents: the stored stamp, what readers are shown of it, and whether this transaction has
// written it.
//
//   Journal journal;
//   Version version(journal);
//   version.note_valid(17);                        // stored by an earlier transaction: memory is valid under it
//   journal.begin();
//   version.wrote(4711);                           // this transaction has stored a new stamp
//   version.written_here() && version.shown(4711) != version.shown(17);
//   journal.end(Journal::Ended::rolled_back);      // 17 again
//
// A stamp is a random number in `_meta`, which every transaction that writes replaces. Memory holds the contents
// under one stamp. A transaction that finds stamp S0:
//
//   start          seen = shown = S0
//   first change   stores S1                           seen = shown = S1, written_here, before = S0
//   flush          stores S2 for the same contents     seen = S2, shown = S1 still: scenes of readers stay valid
//   COMMIT         a watch compares its stamp with before_first_change() (S0), and stores S2
//
// What a transaction knows dies with it: after any rewind the stamps are those of the mark.
#pragma once

#include <atomic>
#include <optional>

#include "database/journal.h"

namespace foresee {

/// Version of a table's contents: equal versions of one table on one connection mean equal contents.
struct ContentVersion {
  std::uint64_t stamp = 0;    ///< stored; every write transaction replaces it by a random number
  std::uint64_t changes = 0;  ///< advances with uncommitted changes of this connection and with rollbacks

  friend bool operator==(const ContentVersion&, const ContentVersion&) = default;
};

/// Read state of one statement: the transaction of the connection in which it has last checked the stamp.
/// Valid only while SQLite holds the statement's read transaction on the database, which excludes commits of
/// other connections.
struct StatementReadState {
  std::uint64_t transaction = 0;  ///< 0: not yet
};

class Version {
 public:
  explicit Version(Journal& journal) : stamps_(journal) {}

  /// The stamp under which memory is valid; nothing: what memory holds must be read again.
  std::optional<std::int64_t> seen() const { return stamps_->seen; }
  /// True if this transaction has stored the seen stamp: until it ends no other connection can write.
  bool written_here() const { return stamps_->written_here; }
  /// The seen stamp before the first change of this transaction. Requires: written_here().
  std::optional<std::int64_t> before_first_change() const { return stamps_->before; }

  /// Memory is valid under the stored stamp from now on.
  void note_valid(std::int64_t stamp) {
    stamps_.change() = {.seen = stamp, .shown = stamp, .changes = stamps_->changes};
  }
  void forget() { stamps_.change().seen.reset(); }
  /// This transaction has stored the stamp, before a change, or after it for the same contents.
  void wrote(std::int64_t stamp, bool same_contents = false) {
    Stamps& stamps = stamps_.change();
    if (!stamps.written_here) stamps.before = stamps.seen;
    if (!same_contents || !stamps.seen) stamps.shown = stamp;
    stamps.seen = stamp;
    stamps.written_here = true;
  }
  /// The contents differ from those of the last shown() from now on.
  void note_change() noexcept { differs_ = true; }

  /// What readers are shown if this stamp is stored.
  ContentVersion shown(std::int64_t stored) {
    static std::atomic<std::uint64_t> last_change{0};
    if (differs_) stamps_.change().changes = ++last_change;
    differs_ = false;
    const std::int64_t stamp = stored == stamps_->seen ? stamps_->shown : stored;
    return {static_cast<std::uint64_t>(stamp), stamps_->changes};
  }

  bool is_checked(const StatementReadState* state) const {
    return state && state->transaction == transaction_;
  }
  void note_checked(StatementReadState* state) const {
    if (state) state->transaction = transaction_;
  }

  /// A transaction starts, or has ended; call it beside the journal's begin() and after its end().
  void begin() noexcept { differed_ = differs_; }
  void end(Journal::Ended how) {
    ++transaction_;
    stamps_.change().written_here = false;
    if (how == Journal::Ended::rolled_back) differs_ = differed_;
  }

 private:
  struct Stamps {
    std::optional<std::int64_t> seen = {};
    std::int64_t shown = 0;  ///< what readers see for `seen`
    bool written_here = false;
    std::optional<std::int64_t> before = {};  ///< `seen` before the first change
    std::uint64_t changes = 0;                ///< what shown() returned last
  };

  Journaled<Stamps> stamps_;
  bool differs_ = false;   ///< the contents differ from those of the last shown()
  bool differed_ = false;  ///< differs_ at begin()
  std::uint64_t transaction_ = 1;
};

}  // namespace foresee
