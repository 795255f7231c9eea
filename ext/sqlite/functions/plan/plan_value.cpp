#include "sqlite/functions/plan/plan_value.h"

#include <new>
#include <span>
#include <string>

#include "base/error.h"
#include "motion/plan/packed_legs.h"
#include "motion/plan/plan_text.h"
#include "storage/rows/value_text.h"

namespace foresee {

std::optional<Plan> plan_of(sqlite3_value* value) {
  if (is_null_or_empty(value)) return std::nullopt;
  const int type = sqlite3_value_type(value);
  if (type == SQLITE_TEXT) return read_plan(text_of(value));
  if (type != SQLITE_BLOB)
    throw Error(shown(value) + " is no plan: write text as in 'LINESTRING M(0 0 0, 4 0 9)', or a blob");
  const auto size = static_cast<std::size_t>(sqlite3_value_bytes(value));
  const auto* bytes = static_cast<const std::byte*>(sqlite3_value_blob(value));
  if (size > 0 && bytes == nullptr) throw std::bad_alloc();
  return decode_plan({bytes, size});
}

void result_plan(sqlite3_context* context, const Plan& plan, bool as_text) {
  if (as_text) {
    const std::string text = write_plan(plan);
    sqlite3_result_text64(context, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
  } else {
    const std::vector<std::byte> blob = encode_plan(plan);
    sqlite3_result_blob64(context, blob.data(), blob.size(), SQLITE_TRANSIENT);
  }
}

}  // namespace foresee
