// Store: the commands 'rebuild', 'optimize' and 'integrity-check'.
#include "storage/table/integrity_check.h"
#include "storage/table/store.h"
#include "storage/table/store_change.h"

namespace foresee {

void Store::rebuild(Interrupt& interrupt) {
  changes_.note_others();  // in a damaged table it may recover objects
  pack(interrupt);
  const OwnStatements own(*this);
  if (!has_auxiliaries()) return;
  flush();
  shadow_rows().match_auxiliaries_to_map();
}

void Store::optimize(Interrupt& interrupt) {
  const std::vector<std::string> faults = integrity_check(interrupt);
  if (!faults.empty()) throw StoreError(SQLITE_CORRUPT_VTAB, faults.front());
  pack(interrupt);
}

// Forms stay while a snapshot may still read them.
void Store::pack(Interrupt& interrupt) {
  start_change({});
  flush();
  TreeStore::Rebuild rebuild(tree(), interrupt);
  AtomicChange atomic_change(*this);
  rebuild.write();
  write_count(static_cast<std::int64_t>(rebuild.objects()));
  if (plans_) pack_plans(interrupt);
  if (forms_ && !tree_.nodes().has_snapshots()) forms_->keep_only(rebuild.forms());
  atomic_change.done();
}

std::vector<std::string> Store::integrity_check(Interrupt& interrupt) {
  flush();
  nodes().forget_clean();
  if (plans_) plans_->tree().nodes().forget_clean();
  std::vector<std::string> faults = tree_.reporting_damage([&] {
    return check_integrity(shadow_rows(), tree_.nodes(), format_, name_, has_auxiliaries(),
                           forms_ ? &forms_->rows() : nullptr, plans_.get(), interrupt);
  });
  origin_.change() = {};
  try {
    frame();
  } catch (const StoreError& error) {
    if ((error.code & 0xff) != SQLITE_CORRUPT) throw;
    faults.push_back(std::string(error.what()).substr(name_.table.size() + 2));
  }
  return faults;
}

}  // namespace foresee
