#include "database/statement.h"

#include <cstdarg>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "database/sqlite_api.h"
#include "database/value_text.h"

namespace foresee {

namespace {

struct FreeSqlite {
  void operator()(void* memory) const { sqlite3_free(memory); }
};

}  // namespace

std::string format_sql(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const std::unique_ptr<char, FreeSqlite> text(sqlite3_vmprintf(format, arguments));
  va_end(arguments);
  if (!text) throw std::bad_alloc();
  return text.get();
}

std::string quoted_name(const std::string& name) {
  return format_sql("\"%w\"", name.c_str());
}

void throw_sqlite_error(sqlite3* db, int code) {
  if ((code & 0xff) == SQLITE_NOMEM) throw std::bad_alloc();
  // SQLite reads a changed schema again; when that is interrupted, it keeps the message about the change.
  const bool is_interrupt = (code & 0xff) == SQLITE_INTERRUPT;
  throw StoreError(code, is_interrupt ? "interrupted" : sqlite3_errmsg(db));
}

void execute(sqlite3* db, const std::string& sql) {
  const int code = sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) throw_sqlite_error(db, code);
}

Statement::Statement(Statement&& other) noexcept {
  *this = std::move(other);
}

Statement& Statement::operator=(Statement&& other) noexcept {
  std::swap(db_, other.db_);
  std::swap(sql_, other.sql_);
  std::swap(reads_, other.reads_);
  std::swap(statement_, other.statement_);
  std::swap(running_, other.running_);
  return *this;
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

sqlite3_stmt* Statement::prepare() {
  if (statement_) return statement_;
  const unsigned flags = SQLITE_PREPARE_PERSISTENT | (reads_ == Reads::tables ? SQLITE_PREPARE_NO_VTAB : 0u);
  const int code =
      sqlite3_prepare_v3(db_, sql_.c_str(), static_cast<int>(sql_.size()) + 1, flags, &statement_, nullptr);
  if (code != SQLITE_OK) throw_sqlite_error(db_, code);
  return statement_;
}

Statement::Run::Run(Statement& statement) : owner_(statement), statement_(statement.prepare()) {
  // A trigger on a shadow table may call back.
  if (owner_.running_)
    throw StoreError(SQLITE_LOCKED_VTAB,
                     "a trigger on a shadow table uses the virtual table itself; DROP the trigger");
  owner_.running_ = true;
}

Statement::Run::~Run() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
  owner_.running_ = false;
}

void Statement::Run::require_ok(int code) {
  if (code != SQLITE_OK) throw_sqlite_error(owner_.db_, code);
}

void Statement::Run::bind(int place, std::int64_t value) {
  require_ok(sqlite3_bind_int64(statement_, place, value));
}

void Statement::Run::bind(int place, double value) {
  require_ok(sqlite3_bind_double(statement_, place, value));
}

void Statement::Run::bind(int place, std::string_view text) {
  require_ok(sqlite3_bind_text64(statement_, place, text.data(), text.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void Statement::Run::bind(int place, std::span<const std::byte> blob) {
  require_ok(sqlite3_bind_blob64(statement_, place, blob.data(), blob.size(), SQLITE_STATIC));
}

void Statement::Run::bind(int place, const sqlite3_value* value) {
  require_ok(sqlite3_bind_value(statement_, place, value));
}

bool Statement::Run::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  throw_sqlite_error(owner_.db_, code);
}

std::string Statement::Run::text(int column, std::size_t limit) {
  return text_of(statement_, column, limit);
}

std::span<const std::byte> Statement::Run::blob(int column) {
  if (sqlite3_column_type(statement_, column) != SQLITE_BLOB) return {};
  const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_, column));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  if (!bytes && size > 0) throw std::bad_alloc();
  return {bytes, size};
}

namespace {

/// SQLite calls a progress handler once per N of its instructions; a usual N is a thousand. A poll about once
/// per millisecond runs as many, in a few microseconds.
std::string thousand_instructions() {
  std::string sql = "SELECT count(*) FROM (VALUES(0)";
  for (int i = 1; i < 200; ++i) sql += ",(0)";
  return sql + ")";
}

}  // namespace

void StatementInterrupt::finalize() noexcept {
  sqlite3_finalize(statement_);
  statement_ = nullptr;
}

// While the statement runs this function alone owns it: SQLite may recompile it, and before that disconnect
// tables, which calls finalize().
void StatementInterrupt::poll() {
  sqlite3_stmt* statement = std::exchange(statement_, nullptr);
  int rc = SQLITE_OK;
  const auto prepare = [&](const std::string& sql) {
    return sqlite3_prepare_v3(db_, sql.c_str(), -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  };
  if (statement == nullptr) rc = prepare(thousand_instructions());
  // The host may limit the length of statements, or forbid functions.
  if (rc == SQLITE_ERROR || rc == SQLITE_AUTH || rc == SQLITE_TOOBIG) rc = prepare("SELECT 1");
  if (rc == SQLITE_OK) {
    sqlite3_step(statement);
    rc = sqlite3_reset(statement);
  }
  statement_ = statement;
  if (rc == SQLITE_OK) return;
  next_ = {};  // if the caller ignores the error, the next check reports it again
  if (rc == SQLITE_INTERRUPT) throw Interrupted();
  if (rc == SQLITE_NOMEM) throw std::bad_alloc();
  throw StoreError(rc, sqlite3_errmsg(db_));
}

}  // namespace foresee
