#include "database/journal.h"

#include <algorithm>

namespace foresee {

Journal::Participant::Participant(Journal& journal, Scope scope) : journal_(journal), scope_(scope) {
  journal_.participants_.push_back(this);
  try {
    journal_.reserve();  // it may join marks that are set already
  } catch (...) {
    journal_.participants_.pop_back();
    throw;
  }
}

Journal::Participant::~Participant() {
  for (Level& level : journal_.levels_)
    std::erase_if(level.joined, [this](const Joined& joined) { return joined.participant == this; });
  std::erase(journal_.participants_, this);
}

void Journal::reserve() {
  for (std::size_t depth = 0; depth < depth_; ++depth) levels_[depth].joined.reserve(participants_.size());
}

void Journal::push() {
  if (depth_ == levels_.size()) levels_.emplace_back();
  Level& level = levels_[depth_];
  level.joined.reserve(participants_.size());
  level.number = newest_ = ++last_;
  level.abandoned = false;
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

// A plain loop: the list has few participants, mostly none.
bool Journal::has(const Level& level, const Participant& participant) noexcept {
  for (const Joined& joined : level.joined)
    if (joined.participant == &participant) return true;
  return false;
}

void Journal::join(Participant& participant) {
  Level& level = levels_[depth_ - 1];
  const bool takes_part = depth_ > 1 || participant.scope_ == Participant::Scope::transaction;
  if (takes_part && !has(level, participant))
    level.joined.push_back({&participant, participant.keep(), participant.joined_});
  participant.joined_ = level.number;
}

bool Journal::rewind_level(Level& level) {
  const bool changed = !level.joined.empty();
  while (!level.joined.empty()) {
    const Joined joined = level.joined.back();
    level.joined.pop_back();
    joined.participant->joined_ = 0;
    joined.participant->rewind(joined.position);
  }
  return changed;
}

bool Journal::rewind(Mark mark) {
  bool changed = false;
  is_whole_ = false;  // until it is done
  for (; depth_ > mark + 1; pop()) changed |= rewind_level(levels_[depth_ - 1]);
  changed |= rewind_level(levels_[mark]);
  is_whole_ = true;
  return changed;
}

// Without a search in most cases: a level that a participant has joined, and not abandoned, has it.
bool Journal::has_joined(const Level& level, const Joined& passed) const noexcept {
  if (passed.before == level.number && !level.abandoned) return true;
  return has(level, *passed.participant);
}

// The older position of a participant holds for both marks.
void Journal::pass_on(const Joined& passed, std::size_t depth) noexcept {
  Level& older = levels_[depth - 1];
  if (depth == 1 && passed.participant->scope_ == Participant::Scope::marks)
    passed.participant->forget();
  else if (has_joined(older, passed))
    passed.participant->merge(passed.position);
  else
    older.joined.push_back(passed);
  passed.participant->joined_ = older.number;
}

void Journal::forget(Mark mark) noexcept {
  while (depth_ > mark && depth_ > 1) {
    std::vector<Joined>& forgotten = levels_[depth_ - 1].joined;
    newest_ = levels_[--depth_ - 1].number;
    for (const Joined& joined : forgotten) pass_on(joined, depth_);
    forgotten.clear();
  }
}

void Journal::abandon(Participant& participant) {
  if (depth_ < 2) return;
  participant.join();
  Level& level = levels_[depth_ - 1];
  level.abandoned = true;
  participant.abandoned_ = level.number;
  const auto joined = std::find_if(level.joined.begin(), level.joined.end(),
                                   [&](const Joined& one) { return one.participant == &participant; });
  if (joined == level.joined.end()) return;
  const Joined passed = *joined;
  level.joined.erase(joined);
  pass_on(passed, depth_ - 1);
  participant.joined_ = level.number;
}

void Journal::end(Ended how) noexcept {
  for (; depth_ > 0; pop())
    for (const Joined& joined : levels_[depth_ - 1].joined)
      if (how == Ended::rolled_back && joined.participant->scope_ == Participant::Scope::transaction)
        joined.participant->rewind(joined.position);
  is_whole_ = true;
  for (Participant* participant : participants_) participant->joined_ = 0;
  for (Participant* participant : participants_) participant->end(how);
}

}  // namespace foresee
