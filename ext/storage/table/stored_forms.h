// The outlines or meshes of one table: shared by content, each stored once, and those in use in memory.
//
//   StoredForms outlines(tables, Shape::outline);
//   const auto [number, hull] = outlines.find_or_add("POLYGON((-8 -90, 8 -90, 0 90, -8 -90))");
//   outlines.form(number)->text()                      // the same corners, later or in another connection
//
// Numbers begin at 1. What memory knows of them is true for the stamp under which it was learned: the store
// says when another connection has written. Of its own accord nobody gives a number again that a rollback
// took back, so that a question which goes on meanwhile still finds what it began with. Memory knows which
// texts were read last, so that a feed which sends the same hull with every report pays a hash for it. Which
// numbers rows have is not known here: forms that no row has any more stay until keep_only().
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>

#include "shape/form.h"
#include "storage/rows/shape_rows.h"

namespace foresee {

class StoredForms {
 public:
  struct Known {
    std::int64_t number;
    std::shared_ptr<const Form> form;
  };

  /// `shape`: of the layout of the table.
  StoredForms(const ShadowTables& tables, Shape shape) : shape_(shape), rows_(tables, shape) {}

  /// The tables go by another name now.
  void connect(const ShadowTables& tables) { rows_ = ShapeRows(tables, shape_); }
  ShapeRows& rows() { return rows_; }

  /// Throws StoreError where the table has none of this number, and what is stored is damaged.
  std::shared_ptr<const Form> form(std::int64_t number);

  using ByNumber = std::unordered_map<std::int64_t, std::shared_ptr<const Form>>;
  /// Those in memory, which a snapshot keeps: what is forgotten later it still has, and what is learned
  /// meanwhile it has too.
  std::shared_ptr<const ByNumber> known();

  /// Of well-known text; stored if it was not. Throws Error, before anything is stored, for a text that is
  /// none.
  Known find_or_add(std::string_view text);

  /// Removes all others.
  void keep_only(const std::unordered_set<std::int64_t>& numbers);

  /// What was stored in this transaction may be so no more.
  void forget_texts() noexcept { texts_.clear(), text_bytes_ = 0; }
  /// Somebody else may have written.
  void forget_all() noexcept { forget_texts(), known_.reset(), corners_ = 0; }

 private:
  std::shared_ptr<const Form> find_known(std::int64_t number) const;
  void remember(std::int64_t number, const std::shared_ptr<const Form>& form);

  Shape shape_;
  ShapeRows rows_;
  std::int64_t last_number_ = 0;     ///< the largest that was given
  std::shared_ptr<ByNumber> known_;  ///< null: none
  std::unordered_map<std::string, Known> texts_;
  std::size_t corners_ = 0;     ///< of all known forms
  std::size_t text_bytes_ = 0;  ///< of all known texts
};

}  // namespace foresee
