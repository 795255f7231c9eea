// Outlines or meshes of one table: each is stored once, shared by content, and cached in memory.
//
//   StoredForms outlines(journal, tables, Shape::outline);
//   const auto [number, hull] = outlines.find_or_add("POLYGON((-8 -90, 8 -90, 0 90, -8 -90))");
//   outlines.form(number)->text()                      // the same corners, also in another connection
//
// Numbers start at 1. The cache is valid for the stamp under which it was filled: the store calls
// forget_all() when another connection has written. A number that a rollback has freed is not reused within
// this object, so a query in progress still finds its forms. The texts read last are cached too: a feed that
// sends the same hull with every report costs one hash per report. This class does not know which numbers
// rows use: unused forms stay until keep_only().
#pragma once

#include <functional>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "database/journal.h"
#include "shape/shared_form.h"
#include "storage/rows/shape_rows.h"

namespace foresee {

class StoredForms final : public Journal::Participant {
 public:
  struct Known {
    std::int64_t number;
    std::shared_ptr<const Form> form;
  };

  /// `shape`: the shape of the layout.
  StoredForms(Journal& journal, const ShadowTables& tables, Shape shape)
      : Participant(journal, Scope::transaction), shape_(shape), rows_(tables, shape) {}

  /// Uses these tables from now on, after a rename.
  void connect(const ShadowTables& tables) { rows_ = ShapeRows(tables, shape_); }
  ShapeRows& rows() { return rows_; }

  /// Throws StoreError if there is no form of this number, or if it is damaged.
  std::shared_ptr<const Form> form(std::int64_t number);

  using ByNumber = std::unordered_map<std::int64_t, std::shared_ptr<const Form>>;
  /// The cached forms, for a snapshot: it keeps them after forget_all(), and it sees forms that are cached
  /// later.
  std::shared_ptr<const ByNumber> known();

  using Reader = std::function<std::shared_ptr<const Form>(std::string_view text)>;
  /// The form of a well-known text, stored if it is new. `read`: reads the text, in place of read_form(); the
  /// same for all calls. Throws Error for an invalid text, before anything is stored.
  Known find_or_add(std::string_view text, const Reader& read = {});

  /// Deletes all other forms.
  void keep_only(const std::unordered_set<std::int64_t>& numbers);

  /// After a commit of another connection.
  void forget_all() noexcept {
    forget_texts();
    known_.reset();
    corners_ = 0;
  }

 private:
  // A rollback may remove the forms that were stored since: their texts have no number then.
  std::size_t keep() override { return 0; }
  void rewind(std::size_t) noexcept override { forget_texts(); }
  void end(Journal::Ended) noexcept override {}
  void forget_texts() noexcept {
    texts_.clear();
    text_bytes_ = 0;
  }

  std::shared_ptr<const Form> find_known(std::int64_t number) const;
  void remember(std::int64_t number, const std::shared_ptr<const Form>& form);

  Shape shape_;
  ShapeRows rows_;
  std::int64_t last_number_ = 0;     ///< the largest number given so far
  std::shared_ptr<ByNumber> known_;  ///< null: empty
  std::unordered_map<std::string, Known> texts_;
  std::size_t corners_ = 0;     ///< of all known forms
  std::size_t text_bytes_ = 0;  ///< of all known texts
};

}  // namespace foresee
