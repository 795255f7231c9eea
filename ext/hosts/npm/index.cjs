// Loads foresee into a connection of better-sqlite3, libsql or node:sqlite.
//
//   const db = new Database("fleet.db");
//   require("foresee").load(db);
//
// The module lies in a package of its own per target, foresee-linux-x64-gnu for example, that is installed beside this one.
"use strict";

const path = require("node:path");
const { packages, version } = require("./package.json");

/** gnu where Node's report names glibc, else musl; an engine without reports is taken for gnu. */
function libcOfLinux() {
  const report = process.report;
  if (typeof report?.getReport !== "function") return "gnu";
  const excluded = report.excludeNetwork;
  report.excludeNetwork = true;     // else Node looks up the name of every open socket
  try {
    return report.getReport().header.glibcVersionRuntime ? "gnu" : "musl";
  } finally {
    report.excludeNetwork = excluded;
  }
}

function thisTarget() {
  const machine = `${process.platform}-${process.arch}`;
  return process.platform === "linux" ? `${machine}-${libcOfLinux()}` : machine;
}

function findModule() {
  const target = thisTarget();
  const name = packages[target];
  if (name === undefined)
    throw new Error(`foresee: no package for ${target}; build it from the sources and give its path to db.loadExtension()`);
  let about;
  try {
    about = require.resolve(`${name}/package.json`);
  } catch (error) {
    throw new Error(`foresee: no module for ${target} is installed; npm install ./${name}-${version}.tgz, a file of the same release`,
      { cause: error });
  }
  const found = require(about).version;
  if (found !== version)
    throw new Error(`foresee: ${name} ${found} is installed beside foresee ${version}; npm install ./${name}-${version}.tgz`);
  return path.join(path.dirname(about), "foresee");
}

let loadable;

/** The module's path, as loadExtension() takes it: without its ending. */
function getLoadablePath() {
  loadable ??= findModule();
  return loadable;
}

/** Loads foresee into an open connection, and returns the connection. Where the host can, loading is off afterwards. */
function load(db) {
  if (db === null || typeof db !== "object" || typeof db.loadExtension !== "function")
    throw new TypeError("foresee.load(db): db has no loadExtension(); give a Database of better-sqlite3, libsql or node:sqlite");
  const module = getLoadablePath();
  const switchable = typeof db.enableLoadExtension === "function";
  try {
    if (switchable) db.enableLoadExtension(true);
    db.loadExtension(module);
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
