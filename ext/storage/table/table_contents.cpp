#include "storage/table/table_contents.h"

#include <utility>

namespace foresee {

TableContents::TableContents(sqlite3* db, QualifiedName name, Declaration declaration,
                             const NodeFormat& format, std::unique_ptr<ShadowRows> rows, bool is_new,
                             std::shared_ptr<MemoryBudget> memory)
    : name_(std::move(name)),
      declaration_(std::move(declaration)),
      format_(format),
      memory_(std::move(memory)),
      transaction_(db, *this, name_.table, is_new),
      shadow_rows_(std::move(rows)),
      tree_(db, format_, name_, declaration_.horizon, transaction_.journal(), *memory_,
            [this] { write_out(); }),
      totals_(transaction_.journal()),
      origin_(transaction_.journal()),
      watch_names_(transaction_.journal()) {
  Journal& journal = transaction_.journal();
  const Layout& layout = declaration_.layout;
  const ShadowTables tables = shadow_tables(db, name_, declaration_);
  tree_.connect(shadow_rows_->tree());
  if (is_stored_apart(layout.shape)) forms_ = std::make_unique<StoredForms>(journal, tables, layout.shape);
  if (!layout.has_plan) return;
  plans_ = std::make_unique<StoredPlans>(db, format_, name_, declaration_.horizon, journal, *memory_,
                                         [this] { write_out(); });
  plans_->connect(tables, shadow_rows_->meta());
}

TableContents::~TableContents() = default;

void TableContents::connect(const QualifiedName& name) {
  const ShadowTables tables = shadow_tables(transaction_.db(), name, declaration_);
  shadow_rows_ = std::make_unique<ShadowRows>(tables, declaration_);
  tree_.connect(shadow_rows_->tree());
  if (forms_) forms_->connect(tables);
  if (plans_) plans_->connect(tables, shadow_rows_->meta());
}

// --- what is valid in memory

// While this connection writes no other one can. At any other time another one may have written.
void TableContents::revalidate_cache(StatementReadState* statement_state) {
  transaction_.resolve_doubt();
  Version& valid = version();
  if (valid.written_here() || (valid.seen() && valid.is_checked(statement_state))) return;
  const auto stamp = shadow_rows().read_stamp();
  if (!stamp) throw_damaged(name_, "the stamp is missing");
  if (valid.seen() != stamp) {
    forget_rows();
    valid.forget();
    totals_.change().count.stored = shadow_rows().read_objects();
    watch_names_.change().reset();
    origin_.change() = {};
    valid.note_valid(*stamp);
  }
  valid.note_checked(statement_state);
}

// Damage is not reported here, but where it is read: DROP TABLE starts a transaction too.
void TableContents::revalidate_at_begin() try { revalidate_cache(); } catch (const StoreError& error) {
  if (!error.is_of_contents()) throw;
  forget_rows();
  version().forget();
}

ContentVersion TableContents::read_version() {
  revalidate_cache();
  const auto stamp = version().written_here() ? shadow_rows().read_stamp() : version().seen();
  if (!stamp) throw_damaged(name_, "the stamp is missing");
  return version().shown(*stamp);
}

void TableContents::forget_rows() {
  tree_.nodes().forget_all();
  if (plans_) plans_->tree().nodes().forget_all();
  if (forms_) forms_->forget_all();
}

void TableContents::forget_clean_nodes() {
  tree_.nodes().forget_clean();
  if (plans_) plans_->tree().nodes().forget_clean();
}

void TableContents::note_memory() noexcept {
  tree_.note_memory();
  if (plans_) plans_->tree().note_memory();
}

void TableContents::note_end() noexcept {
  totals_.change().largest = {};
  note_memory();
}

// --- from memory to the rows

bool TableContents::has_unwritten() const {
  return tree_.has_unwritten() || (plans_ && plans_->tree().has_unwritten()) || totals_->count.added != 0 ||
         origin_->unwritten;
}

bool TableContents::must_merge(TreeStore::Reason reason) const {
  return tree_.must_merge(reason) || (plans_ && plans_->tree().must_merge(reason));
}

void TableContents::merge_pending(TreeStore::Reason reason) {
  if (!must_merge(reason)) return;
  transaction_.require_usable();
  StatementInterrupt interrupt(transaction_.db());
  AtomicChange atomic_change(transaction_);
  tree_.merge_pending(reason, interrupt);
  if (plans_) plans_->tree().merge_pending(reason, interrupt);
  atomic_change.done_with_same_contents();
}

// The new stamp comes last: a connection that reads uncommitted rows (shared cache) has seen the first stamp with
// other rows.
void TableContents::flush(TreeStore::Reason reason) {
  if (!has_unwritten() && !must_merge(reason)) return;
  if (transaction_.was_rolled_back()) return transaction_.restart();
  merge_pending(reason);
  transaction_.require_usable();
  const OwnStatements own(transaction_);
  StatementInterrupt interrupt(transaction_.db());
  tree_.write(interrupt);
  if (plans_) plans_->tree().write(interrupt);
  if (totals_->count.added != 0) {
    const std::optional<std::int64_t> sum = totals_->count.sum();
    write_count(sum ? *sum : shadow_rows().tree().map().count_ids());
  }
  if (origin_->unwritten) {
    shadow_rows().meta().write("origin", origin_text(*origin_->value));
    origin_.change().unwritten = false;
  }
  write_new_stamp(true);
}

void TableContents::write_new_stamp(bool same_contents) {
  std::int64_t stamp;
  sqlite3_randomness(sizeof stamp, &stamp);
  shadow_rows().write_stamp(stamp);
  version().wrote(stamp, same_contents);
}

void TableContents::write_count(std::int64_t objects) {
  shadow_rows().write_objects(objects);
  ObjectCount& count = totals_.change().count;
  count.stored = objects;
  count.added = 0;
}

void TableContents::write_out() {
  if (!transaction_.runs_own_statements() && !transaction_.is_torn()) flush(TreeStore::Reason::memory);
  note_memory();
}

}  // namespace foresee
