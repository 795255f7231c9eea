// A query as the fragment of a link: it stays in the browser, no server sees it. Packed JSON of {sql, example}.
'use strict';

const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

async function fragmentOf(shared) {
  const packed = new Uint8Array(await through(new TextEncoder().encode(JSON.stringify(shared)), new CompressionStream('gzip')));
  return '#q=' + btoa(String.fromCharCode(...packed)).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

// null where the fragment holds none; an Error where it is damaged.
async function sharedBy(fragment) {
  if (!fragment.startsWith('#q=')) return null;
  try {
    const packed = Uint8Array.from(atob(fragment.slice(3).replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    const shared = JSON.parse(new TextDecoder().decode(await through(packed, new DecompressionStream('gzip'))));
    if (typeof shared.sql !== 'string') throw new Error();
    return shared;
  } catch {
    throw new Error('The link is damaged: it holds no query.');
  }
}
