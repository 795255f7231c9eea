/** What a connection needs for foresee to be loaded: better-sqlite3, libsql and node:sqlite have it. */
export interface Loadable {
  loadExtension(path: string, entryPoint?: string): unknown;
  enableLoadExtension?(allow: boolean): void;
}

/** The module's path, as loadExtension() takes it: without its ending. Throws if no package of this target is installed. */
export declare function getLoadablePath(): string;

/** Loads foresee into an open connection, and returns the connection. Where the host can, loading is off afterwards. */
export declare function load<Database extends Loadable>(db: Database): Database;

declare const foresee: { getLoadablePath: typeof getLoadablePath; load: typeof load };
export default foresee;
