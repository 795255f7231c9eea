// Do the outlines that objects name exist, and are their boxes those of the outlines? A part of the integrity
// check (integrity_check.h).
//
//   OutlineCheck check(rows, format);
//   check.read(say);                          // every stored outline: a fault of each that is damaged
//   check.object(42, record, say);            // what is wrong with one object
//
// Cost: all outlines in memory; an outline is turned anew for each object.
#pragma once

#include <map>
#include <memory>

#include "shape/outline/cut_outline.h"
#include "storage/format/node_format.h"
#include "storage/rows/shape_rows.h"

namespace foresee::storage {

class OutlineCheck {
 public:
  OutlineCheck(ShapeRows& rows, const NodeFormat& format) : rows_(rows), format_(format) {}

  template <class Say>
  void read(Say say) {
    rows_.read_all([&](std::int64_t number, const char* fault, const Outline& outline) {
      if (fault) say("outline " + std::to_string(number) + " is damaged: " + fault);
      outlines_[number] = fault ? nullptr : std::make_shared<const CutOutline>(outline);
    });
  }

  /// Requires: `record` is one that a leaf without fault has.
  template <class Say>
  void object(std::int64_t id, const double* record, Say say) const {
    const std::string fault = object_fault(record);
    if (!fault.empty()) say("object " + std::to_string(id) + " " + fault);
  }

 private:
  std::string object_fault(const double* record) const;

  ShapeRows& rows_;
  const NodeFormat& format_;
  std::map<std::int64_t, std::shared_ptr<const CutOutline>> outlines_;  // null: damaged
};

}  // namespace foresee::storage
