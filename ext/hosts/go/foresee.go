// Package foresee links the SQLite extension foresee into a program: every connection that the program opens afterwards has it.
//
//	import (
//		"database/sql"
//
//		_ "foresee"
//		_ "github.com/mattn/go-sqlite3" // built with -tags libsqlite3
//	)
//
//	db, err := sql.Open("sqlite3", "fleet.db")
//	rows, err := db.Query("SELECT a, b, t FROM predictive_join(300)")
//
// The archive libforesee.a and foresee.h are those that pkg-config finds. foresee and the driver must use one SQLite, the
// system's: hence the tag libsqlite3.
package foresee

// #cgo pkg-config: foresee
// #include <foresee.h>
// #include <sqlite3.h>
//
// static int register_foresee(void) { return sqlite3_auto_extension((void (*)(void))sqlite3_foresee_init); }
import "C"

import "fmt"

func init() {
	if status := C.register_foresee(); status != C.SQLITE_OK {
		panic(fmt.Sprintf("foresee: sqlite3_auto_extension ended with status %d", status))
	}
}
