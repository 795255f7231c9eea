#include "storage/check.h"

#include <algorithm>

#include "storage/id_changes.h"
#include "storage/leaf_node.h"

namespace foresee {
namespace {

constexpr std::size_t most_faults = 100;

class Check {
 public:
  Check(ShadowRows& rows, const NodeFormat& format, const QualifiedName& name, Interrupt& interrupt)
      : rows_(rows), format_(format), name_(name), interrupt_(interrupt) {}

  void nodes() {
    rows_.read_all_nodes([&](std::int64_t number, std::span<const std::byte> blob) {
      pause();
      const char* fault = number < 1 ? "nodes are numbered from 1" : leaf_fault(format_, blob, number);
      if (fault) return say("node " + std::to_string(number) + " is damaged: " + fault);
      const LeafView leaf(format_, blob);
      for (int i = 0; i < leaf.count(); ++i) objects_.push_back({leaf.id(i), number});
    });
    std::sort(objects_.begin(), objects_.end(), [](const IdChange& a, const IdChange& b) {
      return a.id != b.id ? a.id < b.id : a.leaf < b.leaf;
    });
    for (std::size_t i = 1; i < objects_.size(); ++i)
      if (objects_[i - 1].id == objects_[i].id)
        say(object(objects_[i].id) + " is in nodes " + std::to_string(objects_[i - 1].leaf) + " and " +
            std::to_string(objects_[i].leaf));
    const auto same_id = [](const IdChange& a, const IdChange& b) { return a.id == b.id; };
    objects_.erase(std::unique(objects_.begin(), objects_.end(), same_id), objects_.end());
  }

  void map() {
    std::size_t next = 0;
    rows_.read_map([&](std::int64_t id, std::int64_t leaf) {
      pause();
      for (; next < objects_.size() && objects_[next].id < id; ++next) not_in("map", objects_[next]);
      if (next == objects_.size() || objects_[next].id != id)
        return say("the map sends " + object(id) + " to node " + std::to_string(leaf) +
                   ", but no leaf has it");
      if (objects_[next].leaf != leaf)
        say("the map sends " + object(id) + " to node " + std::to_string(leaf) + ", but it is in node " +
            std::to_string(objects_[next].leaf));
      ++next;
    });
    for (; next < objects_.size(); ++next) not_in("map", objects_[next]);
  }

  void auxiliaries() {
    std::size_t next = 0;
    rows_.read_auxiliary_ids([&](std::int64_t id) {
      pause();
      for (; next < objects_.size() && objects_[next].id < id; ++next)
        not_in("auxiliary columns", objects_[next]);
      if (next == objects_.size() || objects_[next].id != id)
        return say("there are auxiliary columns of " + object(id) + ", but no leaf has it");
      ++next;
    });
    for (; next < objects_.size(); ++next) not_in("auxiliary columns", objects_[next]);
  }

  void meta() {
    if (!rows_.stamp()) say("the stamp is missing");
  }

  std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  static std::string object(std::int64_t id) { return "object " + std::to_string(id); }
  void not_in(const char* table, const IdChange& entry) {
    say(object(entry.id) + " of node " + std::to_string(entry.leaf) + " is missing in the " + table);
  }
  void say(const std::string& fault) {
    if (faults_.size() < most_faults) faults_.push_back(name_.table + ": " + fault);
  }
  void pause() {
    if (++steps_ % 1024 == 0) interrupt_.check();
  }

  ShadowRows& rows_;
  const NodeFormat& format_;
  const QualifiedName& name_;
  Interrupt& interrupt_;
  std::vector<IdChange> objects_;  // where each object is, by id
  std::vector<std::string> faults_;
  std::size_t steps_ = 0;
};

}  // namespace

std::vector<std::string> check_tables(ShadowRows& rows, const NodeFormat& format, const QualifiedName& name,
                                      bool has_auxiliaries, Interrupt& interrupt) {
  Check check(rows, format, name, interrupt);
  check.meta();
  check.nodes();
  check.map();
  if (has_auxiliaries) check.auxiliaries();
  return std::move(check).faults();
}

}  // namespace foresee
