// foresee in a connection of better-sqlite3, libsql or node:sqlite.
//
//   const db = new Database("fleet.db");
//   require("foresee").load(db);
"use strict";

const path = require("node:path");

/** Where the module is, as loadExtension() takes it. */
function getLoadablePath() {
  return path.join(__dirname, "foresee.so");
}

/** Brings foresee into an open connection, and gives it back. Where the host can, loading is off afterwards. */
function load(db) {
  if (db === null || typeof db !== "object" || typeof db.loadExtension !== "function")
    throw new TypeError("foresee.load(db): db has no loadExtension(); give a Database of better-sqlite3, libsql or node:sqlite");
  const switchable = typeof db.enableLoadExtension === "function";
  try {
    if (switchable) db.enableLoadExtension(true);
    db.loadExtension(getLoadablePath());
  } catch (error) {
    if (/extension loading is not allowed|enable extension loading because it was disabled/i.test(error.message))
      throw new Error("foresee.load(db): node:sqlite allows extensions to a connection that was opened so: " +
        "new DatabaseSync(path, { allowExtension: true })", { cause: error });
    throw error;
  }
  if (switchable) db.enableLoadExtension(false);
  return db;
}

module.exports = { getLoadablePath, load };
