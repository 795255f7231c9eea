//! When will moving objects meet? The SQLite extension foresee in connections of rusqlite.
//!
//! ```
//! # fn main() -> rusqlite::Result<()> {
//! let db = foresee::load(rusqlite::Connection::open_in_memory()?)?;
//! db.execute_batch(
//!     "CREATE VIRTUAL TABLE ships USING moving_objects(id, x, y, vx, vy, r);
//!      INSERT INTO ships VALUES (1, 0, 0, 6, 0, 30), (2, 1200, 0, -6, 0, 30)",
//! )?;
//! let t: f64 = db.query_row("SELECT t FROM predictive_join(300)", [], |row| row.get(0))?;
//! assert_eq!(t, 95.0);
//! # Ok(())
//! # }
//! ```
//!
//! | feature | foresee comes from |
//! |---|---|
//! | `linked`, the default | libforesee.a, which becomes part of the program |
//! | `loaded` | the module `foresee.so`, opened while the program runs ([`load_from`]) |

use rusqlite::{Connection, Result};
use std::borrow::Borrow;

#[cfg(not(any(feature = "linked", feature = "loaded")))]
compile_error!("foresee: choose the feature `linked` or `loaded`");

#[cfg(feature = "linked")]
extern "C" {
    fn sqlite3_foresee_init(
        db: *mut rusqlite::ffi::sqlite3,
        message: *mut *mut std::os::raw::c_char,
        api: *const std::os::raw::c_void,
    ) -> std::os::raw::c_int;
}

/// Loads foresee into an open connection, and returns the connection; `C` is `Connection`, `&Connection` or `&mut Connection`.
///
/// Each connection is loaded separately. A second call changes nothing. Without the feature `linked`, the module is the one
/// that the Debian package installs: `load_from(connection, "foresee")`.
pub fn load<C: Borrow<Connection>>(connection: C) -> Result<C> {
    #[cfg(feature = "linked")]
    initialize(connection.borrow())?;
    #[cfg(not(feature = "linked"))]
    open_module(connection.borrow(), std::path::Path::new("foresee"))?;
    Ok(connection)
}

/// Loads the module at `path`, without its ending: `/opt/foresee/lib/foresee`. Loading of extensions is off afterwards.
#[cfg(feature = "loaded")]
pub fn load_from<C: Borrow<Connection>>(
    connection: C,
    path: impl AsRef<std::path::Path>,
) -> Result<C> {
    open_module(connection.borrow(), path.as_ref())?;
    Ok(connection)
}

#[cfg(feature = "linked")]
fn initialize(connection: &Connection) -> Result<()> {
    use rusqlite::{ffi, Error};
    use std::{ffi::CStr, ptr};

    let mut message = ptr::null_mut();
    // SAFETY: the handle is open as long as `connection` is; the linked archive calls SQLite directly and reads no `api`.
    let status = unsafe { sqlite3_foresee_init(connection.handle(), &mut message, ptr::null()) };
    if status == ffi::SQLITE_OK {
        return Ok(());
    }
    let text = (!message.is_null()).then(|| {
        // SAFETY: a message is a C string that SQLite allocated.
        let text = unsafe { CStr::from_ptr(message) }
            .to_string_lossy()
            .into_owned();
        unsafe { ffi::sqlite3_free(message.cast()) };
        text
    });
    Err(Error::SqliteFailure(ffi::Error::new(status), text))
}

#[cfg(feature = "loaded")]
fn open_module(connection: &Connection, path: &std::path::Path) -> Result<()> {
    // SAFETY: no SQL runs while loading is on, except foresee's own.
    unsafe {
        let _on = rusqlite::LoadExtensionGuard::new(connection)?;
        connection.load_extension(path, None::<&str>)
    }
}
