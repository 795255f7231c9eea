#include "storage/table/integrity_check.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/interrupt_steps.h"
#include "index/tpr_tree/tpr_tree.h"
#include "storage/format/inner_node.h"
#include "storage/format/leaf_node.h"
#include "storage/format/node_format.h"
#include "storage/rows/shape_rows.h"
#include "storage/rows/store_error.h"
#include "storage/rows/value_text.h"

namespace foresee {

// Check of outlines or meshes as part of the integrity check: those that objects refer to exist, and the
// boxes of the objects fit them.
//
//   FormCheck check(rows, format);
//   check.read(say);                          // all stored forms; reports each damaged one
//   check.object(42, record, say);            // reports what is wrong with one object
//
// Cost: all forms in memory; usually a form is rotated once for all objects of one heading.

class FormCheck {
 public:
  FormCheck(ShapeRows& rows, const NodeFormat& format) : rows_(rows), format_(format) {}

  template <class Say>
  void read(Say say) {
    rows_.read_all([&](std::int64_t number, const char* fault, std::shared_ptr<const Form> form) {
      if (fault) say(name(number) + " is damaged: " + fault);
      forms_[number] = fault ? nullptr : std::move(form);
    });
  }

  /// Requires: `record` is from a leaf without fault.
  template <class Say>
  void object(std::int64_t id, const double* record, Say say) {
    const std::string fault = object_fault(record);
    if (!fault.empty()) say("object " + std::to_string(id) + " " + fault);
  }

 private:
  /// "outline 3"
  std::string name(std::int64_t number) const {
    return name_of_form(format_.layout.shape) + (' ' + std::to_string(number));
  }
  std::string object_fault(const double* record);

  ShapeRows& rows_;
  const NodeFormat& format_;
  std::map<std::int64_t, std::shared_ptr<const Form>> forms_;  // null: damaged
  std::map<std::pair<std::int64_t, double>, Extents<3>>
      known_;  // by form and heading; some megabytes at most
};

std::string FormCheck::object_fault(const double* record) {
  const auto number = static_cast<std::int64_t>(record[format_.at.outline]);
  if (number == 0) return "";
  const std::string named = name(number);
  const auto found = forms_.find(number);
  if (found == forms_.end()) return "has " + named + ", which is missing";
  if (!found->second) return "";  // damaged: reported already
  Extents<3> around = Extents<3>::none();
  try {
    const std::pair pose{number, value_or(record, format_.at.heading, 0)};
    if (known_.size() >= 1 << 16) known_.clear();
    auto known = known_.find(pose);
    if (known == known_.end()) known = known_.emplace(pose, found->second->extents(pose.second)).first;
    around = known->second;
  } catch (const Error& error) {
    return "has a heading that " + named + " cannot have: " + error.what();
  }
  const double* const bounds = record + format_.at.bounds;
  const int axes = bounded_axes(format_.layout.shape);
  const bool agree = std::equal(bounds, bounds + axes, around.lower.data()) &&
                     std::equal(bounds + axes, bounds + 2 * axes, around.upper.data());
  return agree ? "" : "has other bounds than " + named;
}

namespace {

constexpr std::size_t max_faults = 100;

struct ObjectPlace {
  std::int64_t id, leaf;
};

class IntegrityCheck {
 public:
  /// Of one tree; `noun`: what its items are.
  IntegrityCheck(TreeRows& rows, NodeCache& cache, const NodeFormat& format, const QualifiedName& name,
                 const char* noun, Interrupt& interrupt)
      : rows_(rows),
        cache_(cache),
        format_(format),
        name_(name),
        noun_(noun),
        interrupt_(interrupt),
        step_(interrupt) {}

  void nodes() {
    rows_.nodes().read_all([&](std::int64_t number, std::span<const std::byte> blob) {
      interrupt_.check();
      ++nodes_;
      if (const char* fault = cache_.fault(number, blob))
        return say("node " + std::to_string(number) + " is damaged: " + fault);
      if (is_inner(format_, blob, number)) return;
      const LeafView leaf(format_, blob);
      for (int i = 0; i < leaf.count(); ++i) objects_.push_back({leaf.id(i), number});
    });
    std::sort(objects_.begin(), objects_.end(), [this](const ObjectPlace& a, const ObjectPlace& b) {
      step_();
      return a.id != b.id ? a.id < b.id : a.leaf < b.leaf;
    });
    for (std::size_t i = 1; i < objects_.size(); step_(), ++i)
      if (objects_[i - 1].id == objects_[i].id)
        say(object(objects_[i].id) + " is in nodes " + std::to_string(objects_[i - 1].leaf) + " and " +
            std::to_string(objects_[i].leaf));
    const auto same_id = [this](const ObjectPlace& a, const ObjectPlace& b) {
      step_();
      return a.id == b.id;
    };
    objects_.erase(std::unique(objects_.begin(), objects_.end(), same_id), objects_.end());
    count_ = objects_.size();
  }

  void map() try {
    std::size_t next = 0;
    rows_.map().read([&](std::int64_t id, std::int64_t leaf) {
      step_();
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
  } catch (const StoreError& error) {
    note(error);
  }

  void forms(ShapeRows& rows) try {
    FormCheck check(rows, format_);
    const auto say = [this](const std::string& fault) { this->say(fault); };
    check.read(say);
    for_each_object([&](std::int64_t id, const double* record) { check.object(id, record, say); });
  } catch (const StoreError& error) {
    note(error);
  }

  /// The plans of these objects, and their tree.
  void plans(StoredPlans& plans) try {
    IntegrityCheck chunks(plans.tree_rows(), plans.tree().nodes(), plans.tree().format(), plans.tree_name(),
                          "chunk", interrupt_);
    chunks.nodes();
    chunks.map();
    chunks.tree();
    for (std::string& fault : chunks.faults_) faults_.push_back(std::move(fault));
    if (!chunks.faults_.empty()) return;
    std::vector<StoredPlans::Head> heads;
    std::vector<double> records;
    for_each_object([&](std::int64_t id, const double* record) {
      if (!has_plan(format_.at, record)) return;
      heads.push_back(plans.head_of(id, record, heads.size()));
      records.insert(records.end(), record, record + format_.at.size);
    });
    plans.check(
        heads, records, [this](const std::string& fault) { say(fault); }, interrupt_);
  } catch (const StoreError& error) {
    note(error);
  }

  void auxiliaries(ShadowRows& rows) {
    std::size_t next = 0;
    rows.read_auxiliary_ids([&](std::int64_t id) {
      step_();
      for (; next < objects_.size() && objects_[next].id < id; ++next)
        not_in("auxiliary columns", objects_[next]);
      if (next == objects_.size() || objects_[next].id != id)
        return say("there are auxiliary columns of " + object(id) + ", but no leaf has it");
      ++next;
    });
    for (; next < objects_.size(); ++next) not_in("auxiliary columns", objects_[next]);
  }

  // Relations between sound nodes. After an earlier fault they would only repeat it, once per object.
  void tree() {
    if (!faults_.empty()) return;
    objects_ = {};  // check_tree() needs memory for a list of its own
    try {
      const TreeReport report = check_tree(cache_, interrupt_);
      for (const std::string& problem : report.problems) say(problem);
      if (report.problems.empty() && report.nodes < nodes_)
        say("nodes that are not part of the tree: " + std::to_string(nodes_ - report.nodes));
    } catch (const StoreError& error) {
      note(error);
    } catch (const BrokenTree& error) {
      say(error.what());
    }
  }

  void meta(ShadowRows& rows) {
    if (!rows.read_stamp()) say("the stamp is missing");
  }

  // Version 0.1 stored no count. After other faults the count may be wrong too, so it is not checked.
  void count(ShadowRows& rows) {
    const std::string said = rows.meta().read("objects");
    if (faults_.empty() && !said.empty() && said != std::to_string(count_))
      say("the count of objects is " + without_nul(said) + ", but there are " + std::to_string(count_));
  }

  std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  /// Skips damaged leaves, which are reported already.
  template <class Each>
  void for_each_object(Each each) {
    std::vector<double> record(static_cast<std::size_t>(format_.at.size));
    rows_.nodes().read_all([&](std::int64_t number, std::span<const std::byte> blob) {
      interrupt_.check();
      if (cache_.fault(number, blob) || is_inner(format_, blob, number)) return;
      const LeafView leaf(format_, blob);
      for (int i = 0; i < leaf.count(); ++i) {
        leaf.copy_record(i, record.data());
        each(leaf.id(i), record.data());
      }
    });
  }

  std::string object(std::int64_t id) const { return noun_ + (' ' + std::to_string(id)); }
  void not_in(const char* table, const ObjectPlace& entry) {
    say(object(entry.id) + " of node " + std::to_string(entry.leaf) + " is missing in the " + table);
  }
  /// Damage is reported as a fault; any other error ends the check.
  void note(const StoreError& error) {
    if ((error.code & 0xff) != SQLITE_CORRUPT) throw error;
    faults_.push_back(error.what());
  }
  void say(const std::string& fault) {
    if (faults_.size() < max_faults) faults_.push_back(name_.table + ": " + fault);
  }

  TreeRows& rows_;
  NodeCache& cache_;
  const NodeFormat& format_;
  const QualifiedName& name_;
  std::string noun_;
  Interrupt& interrupt_;
  Steps step_;
  std::vector<ObjectPlace> objects_;  // the leaf of each object, by id
  std::vector<std::string> faults_;
  std::size_t nodes_ = 0, count_ = 0;
};

}  // namespace

std::vector<std::string> check_integrity(ShadowRows& rows, NodeCache& cache, const NodeFormat& format,
                                         const QualifiedName& name, bool has_auxiliaries, ShapeRows* shapes,
                                         StoredPlans* plans, Interrupt& interrupt) {
  IntegrityCheck check(rows.tree(), cache, format, name, "object", interrupt);
  check.meta(rows);
  check.nodes();
  check.map();
  if (shapes) check.forms(*shapes);
  if (plans) check.plans(*plans);
  if (has_auxiliaries) check.auxiliaries(rows);
  check.tree();
  check.count(rows);
  return std::move(check).faults();
}

}  // namespace foresee
