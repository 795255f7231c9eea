#include "query/window/mover_window.h"

#include <algorithm>

#include "query/distinct_contacts.h"
#include "query/legs/leg_scene.h"

namespace foresee {
namespace {

constexpr std::size_t pairs_at_once = 256;

/// The first contact by its start alone.
ContactTimes first_start(std::span<const ContactTimes> contacts) {
  ContactTimes first = contacts.front();
  for (const ContactTimes& contact : contacts)
    first.t = std::min(first.t, contact.t), first.dt = std::min(first.dt, contact.dt);
  return first;
}

}  // namespace

MoverWindow::MoverWindow(std::shared_ptr<const Scene> scene, const MovingWindow& window,
                         const Horizon& horizon, const MoverWants& wants, Interrupt& interrupt)
    : scene_(std::move(scene)),
      bodies_(scene_->bodies()),
      horizon_(horizon),
      wants_(wants),
      interrupt_(interrupt),
      has_zone_(window.has_zone()),
      contact_(make_window_contact(window, bodies_, horizon)) {
  contact_->set_interrupt(interrupt);
}

void MoverWindow::take_pairs() {
  pairs_.clear();
  for (; next_ < scene_->object_count() && pairs_.size() < pairs_at_once; ++next_) {
    const RowRange rows = rows_during(bodies_, scene_->rows_of(next_), horizon_);
    if (rows.size() == 0) continue;
    if (wants_.test && !wants_.test->accepts(kinds_of(bodies_.row(rows.first), bodies_.at))) continue;
    for (std::size_t row = rows.first; row < rows.last; ++row)
      pairs_.push_back({0, static_cast<std::uint32_t>(row)});
  }
}

bool MoverWindow::next(std::vector<WindowRow>& rows) {
  take_pairs();
  if (pairs_.empty()) return false;
  hits_.clear();
  times_.clear();
  for (std::size_t first = 0; first < pairs_.size(); first += pairs_at_once) {
    interrupt_.check();
    const auto pairs = std::span(pairs_).subspan(first, std::min(pairs_at_once, pairs_.size() - first));
    if (wants_.all_contacts)
      contact_->all_contacts(pairs, hits_, times_);
    else if (wants_.wants.starts || wants_.wants.ends)
      contact_->first_contacts(pairs, wants_.wants.ends ? TimesWanted::both : TimesWanted::starts, hits_,
                               times_);
    else
      contact_->decide(pairs, hits_);
  }
  times_.resize(hits_.size());
  for (std::size_t first = 0, last; first < hits_.size(); first = last) {
    for (last = first; last < hits_.size() && scene_->ids[hits_[last].b] == scene_->ids[hits_[first].b];)
      ++last;
    add_rows(first, last, rows);
  }
  return true;
}

void MoverWindow::add_rows(std::size_t first, std::size_t last, std::vector<WindowRow>& rows) {
  const std::int64_t id = scene_->ids[hits_[first].b];
  if (!wants_.all_contacts && (last == first + 1 || !wants_.wants.ends)) {
    rows.push_back({id, first_start(std::span(times_).subspan(first, last - first))});
    return;
  }
  take_contacts(first, last);
  std::vector<ContactTimes> contacts = mover_contacts(contacts_);
  if (!wants_.all_contacts) {
    rows.push_back({id, contacts.front()});
    return;
  }
  std::vector<Pair> pairs(contacts.size());
  join_equal_contacts(0, pairs, contacts);
  for (const ContactTimes& contact : contacts) rows.push_back({id, contact});
}

/// Where several legs touch and a leg may do so twice, a later contact of one can join with those of the next.
bool MoverWindow::can_meet_again() const {
  return bodies_.layout.law == Law::accelerated && !is_stored_apart(bodies_.layout.shape) && !has_zone_;
}

void MoverWindow::take_contacts(std::size_t first, std::size_t last) {
  contacts_.clear();
  std::span<const Pair> hits = std::span(hits_).subspan(first, last - first);
  std::span<const ContactTimes> times = std::span(times_).subspan(first, last - first);
  if (!wants_.all_contacts && can_meet_again()) {
    again_.clear();
    times_again_.clear();
    contact_->all_contacts(hits, again_, times_again_);
    hits = again_, times = times_again_;
  }
  for (std::size_t i = 0; i < hits.size(); ++i) contacts_.push_back({hits[i].a, hits[i].b, times[i]});
}

}  // namespace foresee
