// SQLite and foresee from the module of this folder's build: SQL in, rows out. Used by the page and by the docs site.
//
//   const database = await openForesee(text);               // text: the module, gzipped, in base64
//   database.query("SELECT 1 AS a")                         // {columns: ["a"], rows: [[1]], ms: 0.1}: of the last statement with columns
//   database.texts("SELECT 1 AS a; SELECT 95.0")            // {results: [{columns, rows: [["1"]]}, {columns, rows: [["95.0"]]}], ms}
//   database.reopen()                                       // an empty database
'use strict';

async function unpacked(text) {
  const packed = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

async function openForesee(text) {
  const module = await foreseeModule({wasmBinary: await unpacked(text)});
  const reopen = () => { if (module._foresee_open() !== 0) throw new Error('SQLite did not open a database'); };
  const call = (name) => (sql) => {
    const size = module.lengthBytesUTF8(sql) + 1, at = module._malloc(size);
    module.stringToUTF8(sql, at, size);
    const answer = JSON.parse(module.UTF8ToString(module[name](at)));
    module._free(at);
    if (answer.error !== undefined) throw Object.assign(new Error(answer.error), {offset: answer.offset});
    return answer;
  };
  reopen();
  return {query: call('_foresee_query'), texts: call('_foresee_texts'), reopen};
}
