/** What a connection needs for foresee to be loaded: better-sqlite3, libsql and node:sqlite have it. */
export interface Loadable {
  loadExtension(path: string, entryPoint?: string): unknown;
  enableLoadExtension?(allow: boolean): void;
}

/** Where the module is, as loadExtension() takes it. */
export declare function getLoadablePath(): string;

/** Brings foresee into an open connection, and gives it back. Where the host can, loading is off afterwards. */
export declare function load<Database extends Loadable>(db: Database): Database;

declare const foresee: { getLoadablePath: typeof getLoadablePath; load: typeof load };
export default foresee;
