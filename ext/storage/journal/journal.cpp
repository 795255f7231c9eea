#include "storage/journal/journal.h"

#include <algorithm>

namespace foresee {

Journal::Participant::Participant(Journal& journal, Scope scope) : journal_(journal), scope_(scope) {
  journal_.participants_.push_back(this);
}

Journal::Participant::~Participant() {
  for (Level& level : journal_.levels_)
    std::erase_if(level.joined, [this](const Joined& joined) { return joined.participant == this; });
  std::erase(journal_.participants_, this);
}

// Reserves memory for all participants, so that nothing that follows can fail for lack of it.
void Journal::push() {
  if (depth_ == levels_.size()) levels_.emplace_back();
  Level& level = levels_[depth_];
  level.joined.reserve(participants_.size());
  level.number = newest_ = ++last_;
  ++depth_;
}

void Journal::pop() noexcept {
  levels_[--depth_].joined.clear();
  newest_ = depth_ > 0 ? levels_[depth_ - 1].number : 0;
}

void Journal::begin() {
  if (depth_ == 0) push();
}

Journal::Mark Journal::set_mark() {
  push();
  return depth_ - 1;
}

void Journal::join(Participant& participant) {
  Level& level = levels_[depth_ - 1];
  const bool takes_part = depth_ > 1 || participant.scope_ == Participant::Scope::transaction;
  const bool is_new = std::none_of(level.joined.begin(), level.joined.end(),
                                   [&](const Joined& joined) { return joined.participant == &participant; });
  if (takes_part && is_new) level.joined.push_back({&participant, participant.keep()});
  participant.joined_ = level.number;
}

bool Journal::rewind_level(Level& level) noexcept {
  const bool changed = !level.joined.empty();
  for (const Joined& joined : level.joined) {
    joined.participant->rewind(joined.position);
    joined.participant->joined_ = 0;
  }
  level.joined.clear();
  return changed;
}

bool Journal::rewind(Mark mark) noexcept {
  bool changed = false;
  for (; depth_ > mark + 1; pop()) changed |= rewind_level(levels_[depth_ - 1]);
  return rewind_level(levels_[mark]) || changed;
}

// The older position of a participant holds for both marks.
void Journal::forget(Mark mark) noexcept {
  for (; depth_ > mark && depth_ > 1; pop()) {
    Level& older = levels_[depth_ - 2];
    for (const Joined& joined : levels_[depth_ - 1].joined) {
      const auto same = std::find_if(older.joined.begin(), older.joined.end(), [&](const Joined& other) {
        return other.participant == joined.participant;
      });
      if (same != older.joined.end())
        joined.participant->merge(same->position, joined.position);
      else if (depth_ > 2 || joined.participant->scope_ == Participant::Scope::transaction)
        older.joined.push_back(joined);
      else
        joined.participant->forget();
    }
  }
}

void Journal::end(Ended how) noexcept {
  for (; depth_ > 0; pop())
    for (const Joined& joined : levels_[depth_ - 1].joined)
      if (how == Ended::rolled_back && joined.participant->scope_ == Participant::Scope::transaction)
        joined.participant->rewind(joined.position);
  for (Participant* participant : participants_) {
    participant->joined_ = 0;
    participant->end(how);
  }
}

}  // namespace foresee
