#include "query/legs/mover_contacts.h"

#include <algorithm>
#include <tuple>

namespace foresee {
namespace {

auto key_of(const ContactTimes& times) {
  return std::tie(times.t, times.t_end, times.dt, times.dt_end);
}

/// Least starts and greatest ends.
void add_to(ContactTimes& joined, const ContactTimes& more) {
  joined.t = std::min(joined.t, more.t), joined.dt = std::min(joined.dt, more.dt);
  joined.t_end = std::max(joined.t_end, more.t_end), joined.dt_end = std::max(joined.dt_end, more.dt_end);
}

/// Groups of contacts that are one contact each. Contacts are added in order of t.
class ContactGroups {
 public:
  explicit ContactGroups(std::size_t count) {
    parents_.reserve(count);
    times_.reserve(count);
  }

  void add(const LegContact& contact) {
    const std::size_t number = parents_.size();
    parents_.push_back(number);
    times_.push_back(contact.times);
    std::erase_if(lasting_, [&](const Lasting& one) { return one.contact.times.t_end < contact.times.t; });
    for (const Lasting& one : lasting_)
      if (one.contact.leg_a != contact.leg_a || one.contact.leg_b != contact.leg_b) join(one.number, number);
    lasting_.push_back({contact, number});
  }

  /// The contact of each group, in no order.
  std::vector<ContactTimes> contacts() {
    std::vector<ContactTimes> contacts;
    for (std::size_t i = 0; i < parents_.size(); ++i)
      if (parents_[i] == i) contacts.push_back(times_[i]);
    return contacts;
  }

 private:
  /// A contact that ends no earlier than the last one starts.
  struct Lasting {
    LegContact contact;
    std::size_t number;
  };

  std::size_t root_of(std::size_t number) {
    while (parents_[number] != number) number = parents_[number] = parents_[parents_[number]];
    return number;
  }
  void join(std::size_t a, std::size_t b) {
    a = root_of(a), b = root_of(b);
    if (a == b) return;
    parents_[b] = a;
    add_to(times_[a], times_[b]);
  }

  std::vector<std::size_t> parents_;
  std::vector<ContactTimes> times_;  ///< of a root: those of its group
  std::vector<Lasting> lasting_;
};

bool precedes(const ContactTimes& a, const ContactTimes& b) {
  return key_of(a) < key_of(b);
}

}  // namespace

std::vector<ContactTimes> mover_contacts(std::vector<LegContact>& contacts) {
  std::sort(contacts.begin(), contacts.end(), [](const LegContact& a, const LegContact& b) {
    return std::tuple(key_of(a.times), a.leg_a, a.leg_b) < std::tuple(key_of(b.times), b.leg_a, b.leg_b);
  });
  ContactGroups groups(contacts.size());
  for (const LegContact& contact : contacts) groups.add(contact);
  std::vector<ContactTimes> found = groups.contacts();
  std::sort(found.begin(), found.end(), precedes);
  return found;
}

}  // namespace foresee
