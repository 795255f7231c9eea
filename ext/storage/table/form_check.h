// Do the outlines or meshes that objects name exist, and are their boxes those of these? A part of the
// integrity check (integrity_check.h).
//
//   FormCheck check(rows, format);
//   check.read(say);                          // every stored form: a fault of each that is damaged
//   check.object(42, record, say);            // what is wrong with one object
//
// Cost: all forms in memory; a form is turned once for all objects of one heading, as a rule.
#pragma once

#include <map>
#include <memory>

#include "shape/known_extents.h"
#include "storage/format/node_format.h"
#include "storage/rows/shape_rows.h"

namespace foresee {

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

  /// Requires: `record` is one that a leaf without fault has.
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
  KnownExtents known_;
};

}  // namespace foresee
