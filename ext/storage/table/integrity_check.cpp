#include "storage/table/integrity_check.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "base/interrupt_steps.h"
#include "database/sqlite_api.h"
#include "database/value_text.h"
#include "format/inner_node.h"
#include "format/leaf_node.h"
#include "format/node_format.h"
#include "index/tpr_tree/tpr_tree.h"

namespace foresee {
namespace {

constexpr std::size_t max_faults = 100;

struct ObjectPlace {
  std::int64_t id, leaf;
};

/// All outlines or meshes of a table. Usually each is rotated once for all objects of one heading.
struct FormsInMemory {
  std::map<std::int64_t, std::shared_ptr<const Form>> forms = {};  ///< null: damaged
  /// By form and heading; some megabytes at most.
  std::map<std::pair<std::int64_t, double>, Extents<3>> extents = {};
};

/// "outline 3"
std::string name_of(const NodeFormat& format, std::int64_t form) {
  return name_of_form(format.layout.shape) + (' ' + std::to_string(form));
}

/// What is wrong between an object and its form: "has other bounds than outline 3"; "": nothing. Requires: `record` is
/// from a leaf without fault.
std::string form_fault(const NodeFormat& format, const double* record, FormsInMemory& known) {
  const auto number = static_cast<std::int64_t>(record[format.at.outline]);
  if (number == 0) return "";
  const std::string named = name_of(format, number);
  const auto found = known.forms.find(number);
  if (found == known.forms.end()) return "has " + named + ", which is missing";
  if (!found->second) return "";  // damaged: reported already
  Extents<3> around = Extents<3>::none();
  try {
    const std::pair pose{number, value_or(record, format.at.heading, 0)};
    if (known.extents.size() >= 1 << 16) known.extents.clear();
    auto turned = known.extents.find(pose);
    if (turned == known.extents.end())
      turned = known.extents.emplace(pose, found->second->extents(pose.second)).first;
    around = turned->second;
  } catch (const Error& error) {
    return "has a heading that " + named + " cannot have: " + error.what();
  }
  const double* const bounds = record + format.at.bounds;
  const int axes = bounded_axes(format.layout.shape);
  const bool agree = std::equal(bounds, bounds + axes, around.lower.data()) &&
                     std::equal(bounds + axes, bounds + 2 * axes, around.upper.data());
  return agree ? "" : "has other bounds than " + named;
}

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
    const auto sends = [this](std::int64_t id, std::int64_t leaf) {
      return "the map sends " + object(id) + " to node " + std::to_string(leaf);
    };
    compare([&](auto each) { rows_.map().read(each); }, "map",
            [&](std::int64_t id, std::int64_t leaf) { say(sends(id, leaf) + ", but no leaf has it"); },
            [&](const ObjectPlace& in, std::int64_t leaf) {
              if (in.leaf != leaf) say(sends(in.id, leaf) + ", but it is in node " + std::to_string(in.leaf));
            });
  } catch (const StoreError& error) {
    note(error);
  }

  void forms(ShapeRows& rows) try {
    FormsInMemory known;
    rows.read_all([&](std::int64_t number, const char* fault, std::shared_ptr<const Form> form) {
      if (fault) say(name_of(format_, number) + " is damaged: " + fault);
      known.forms[number] = fault ? nullptr : std::move(form);
    });
    for_each_object([&](std::int64_t id, const double* record) {
      if (const std::string fault = form_fault(format_, record, known); !fault.empty())
        say("object " + std::to_string(id) + " " + fault);
    });
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

  void auxiliaries(ShadowRows& rows) try {
    compare([&](auto each) { rows.read_auxiliary_ids(each); }, "auxiliary columns",
            [&](std::int64_t id) {
              say("there are auxiliary columns of " + object(id) + ", but no leaf has it");
            },
            [](const ObjectPlace&) {});
  } catch (const StoreError& error) {
    note(error);
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
  /// compare_ascending() of the objects and these rows; `table`: which the objects without a row are missing in.
  template <class Read, class OnlyRow, class Both>
  void compare(Read read, const char* table, OnlyRow only_row, Both both) {
    compare_ascending(
        objects_, &ObjectPlace::id,
        [&](auto each) {
          read([&](auto... columns) {
            step_();
            each(columns...);
          });
        },
        [&](const ObjectPlace& entry) {
          say(object(entry.id) + " of node " + std::to_string(entry.leaf) + " is missing in the " + table);
        },
        only_row, both);
  }
  /// Damage is reported as a fault; any other error ends the check.
  void note(const StoreError& error) {
    if (!error.is_damage()) throw error;
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
