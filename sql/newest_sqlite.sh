# shellcheck shell=bash
# The newest SQLite: its amalgamation inside an npm package, kept in build/. Sourced by tests/run.sh, which tests against
# it, and ext/hosts/browser/pack_page.sh, which packs it.
newest_sqlite=build/sqlite_newest
fetch_newest_sqlite() {
  [ -f $newest_sqlite/sqlite3.c ] && return 0
  mkdir -p $newest_sqlite
  (
    cd $newest_sqlite
    timeout 120 npm pack --silent --fetch-retries=1 --fetch-retry-mintimeout=1000 better-sqlite3 >/dev/null 2>npm.log || exit 1
    tar -xzf better-sqlite3-*.tgz --strip-components=3 package/deps/sqlite3
  )
}
