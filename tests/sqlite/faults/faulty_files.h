// A VFS that injects file faults: it wraps SQLite's own VFS, and the nth operation of one kind fails, once or
// from then on.
//
//   FaultyFiles files;                                       // registers the VFS "faulty"
//   Database db("file:ships.db?vfs=faulty");
//   files.arm(FileFault::write_fails, 3, FaultyFiles::once);
//   db.exec(…);  bool fired = files.disarm();
#pragma once

#include <sqlite3.h>

#include <cstring>

namespace foresee::testing {

enum class FileFault { read_fails, write_fails, disk_full, sync_fails, truncate_fails, open_fails };

inline constexpr FileFault all_file_faults[] = {FileFault::read_fails,     FileFault::write_fails,
                                                FileFault::disk_full,      FileFault::sync_fails,
                                                FileFault::truncate_fails, FileFault::open_fails};

class FaultyFiles {
 public:
  static constexpr bool once = false, for_good = true;
  static constexpr bool default_for_all = true;  ///< also for databases that name no VFS

  explicit FaultyFiles(bool is_default = false) {
    real_ = sqlite3_vfs_find(nullptr);
    vfs_ = *real_;
    vfs_.zName = "faulty";
    vfs_.pNext = nullptr;
    vfs_.szOsFile = static_cast<int>(sizeof(File)) + real_->szOsFile;
    vfs_.xOpen = open;
    vfs_.xDelete = erase;
    sqlite3_vfs_register(&vfs_, is_default);
  }
  ~FaultyFiles() { sqlite3_vfs_unregister(&vfs_); }
  FaultyFiles(const FaultyFiles&) = delete;
  FaultyFiles& operator=(const FaultyFiles&) = delete;

  void arm(FileFault fault, long after, bool for_good_then) {
    state_ = {.armed = true, .for_good = for_good_then, .fired = false, .fault = fault, .left = after};
  }
  /// True if the fault happened.
  bool disarm() {
    const bool fired = state_.fired;
    state_ = {};
    return fired;
  }

 private:
  struct State {
    bool armed, for_good, fired;
    FileFault fault;
    long left;
  };
  struct File {
    sqlite3_file base;
    sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
  };

  static bool fails(FileFault operation) {
    if (!state_.armed || state_.fault != operation || state_.left-- > 0) return false;
    state_.fired = true;
    if (!state_.for_good) state_.armed = false;
    return true;
  }
  static sqlite3_file* real(sqlite3_file* file) { return reinterpret_cast<File*>(file)->real(); }
  static const sqlite3_io_methods* methods(sqlite3_file* file) { return real(file)->pMethods; }

  static int open(sqlite3_vfs*, sqlite3_filename name, sqlite3_file* file, int flags, int* out) {
    file->pMethods = nullptr;
    if (fails(FileFault::open_fails)) return SQLITE_CANTOPEN;
    const int rc = real_->xOpen(real_, name, real(file), flags, out);
    if (rc == SQLITE_OK) file->pMethods = &methods_;
    return rc;
  }
  static int erase(sqlite3_vfs*, const char* name, int) { return real_->xDelete(real_, name, 0); }
  static int read(sqlite3_file* file, void* to, int size, sqlite3_int64 at) {
    if (fails(FileFault::read_fails)) return SQLITE_IOERR_READ;
    return methods(file)->xRead(real(file), to, size, at);
  }
  static int write(sqlite3_file* file, const void* from, int size, sqlite3_int64 at) {
    if (fails(FileFault::write_fails)) return SQLITE_IOERR_WRITE;
    if (fails(FileFault::disk_full)) return SQLITE_FULL;
    return methods(file)->xWrite(real(file), from, size, at);
  }
  static int truncate(sqlite3_file* file, sqlite3_int64 size) {
    if (fails(FileFault::truncate_fails)) return SQLITE_IOERR_TRUNCATE;
    return methods(file)->xTruncate(real(file), size);
  }
  static int sync(sqlite3_file*, int) {  // these tests have no power failures, so a sync need not wait
    return fails(FileFault::sync_fails) ? SQLITE_IOERR_FSYNC : SQLITE_OK;
  }

  /// Calls that never fail.
  template <auto method>
  struct Pass;
  template <class... Arguments, int (*sqlite3_io_methods::*method)(sqlite3_file*, Arguments...)>
  struct Pass<method> {
    static int call(sqlite3_file* file, Arguments... arguments) {
      return (methods(file)->*method)(real(file), arguments...);
    }
  };
  static void barrier(sqlite3_file* file) { methods(file)->xShmBarrier(real(file)); }

  static inline State state_{};
  static inline sqlite3_vfs* real_ = nullptr;
  static inline const sqlite3_io_methods methods_{
      .iVersion = 2,
      .xClose = Pass<&sqlite3_io_methods::xClose>::call,
      .xRead = read,
      .xWrite = write,
      .xTruncate = truncate,
      .xSync = sync,
      .xFileSize = Pass<&sqlite3_io_methods::xFileSize>::call,
      .xLock = Pass<&sqlite3_io_methods::xLock>::call,
      .xUnlock = Pass<&sqlite3_io_methods::xUnlock>::call,
      .xCheckReservedLock = Pass<&sqlite3_io_methods::xCheckReservedLock>::call,
      .xFileControl = Pass<&sqlite3_io_methods::xFileControl>::call,
      .xSectorSize = Pass<&sqlite3_io_methods::xSectorSize>::call,
      .xDeviceCharacteristics = Pass<&sqlite3_io_methods::xDeviceCharacteristics>::call,
      .xShmMap = Pass<&sqlite3_io_methods::xShmMap>::call,
      .xShmLock = Pass<&sqlite3_io_methods::xShmLock>::call,
      .xShmBarrier = barrier,
      .xShmUnmap = Pass<&sqlite3_io_methods::xShmUnmap>::call,
      .xFetch = nullptr,
      .xUnfetch = nullptr};

  sqlite3_vfs vfs_;
};

}  // namespace foresee::testing
