// "Run" on the SQL blocks of the site: SQLite and foresee in the page. Nothing is requested until a button is clicked, and then of this site.
//
// stage.py writes the page's blocks as JSON, also those that it hides, in order: {kind, text, runs}. A click runs all blocks before its own
// on an empty database, then its own, and prints what that prints in the shell's box mode.
'use strict';

const siteFolder = new URL('.', document.currentScript.src);
let opening = null;

function openDatabase() {
  opening ??= new Promise((resolve, reject) => {
    const script = Object.assign(document.createElement('script'), {src: new URL('foresee_module.js', siteFolder)});
    script.onload = () => resolve(openForesee(foreseePacked));
    script.onerror = () => { opening = null; reject(new Error('The module of this site could not be read.')); };
    document.head.append(script);
  });
  return opening;
}

// As the shell's box mode: names in the middle, values on the left.
function boxed({columns, rows}) {
  const wide = (text) => [...text].length, texts = rows.map((row) => row.map((value) => value ?? ''));
  const widths = columns.map((name, i) => Math.max(wide(name), ...texts.map((row) => wide(row[i]))));
  const rule = (left, cross, right) => left + widths.map((width) => '─'.repeat(width + 2)).join(cross) + right;
  const middle = (name, width) => { const rest = width - wide(name); return ' '.repeat(rest >> 1) + name + ' '.repeat(rest - (rest >> 1)); };
  const line = (cells) => '│ ' + cells.join(' │ ') + ' │';
  return [rule('┌', '┬', '┐'), line(columns.map((name, i) => middle(name, widths[i]))), rule('├', '┼', '┤'),
          ...texts.map((row) => line(row.map((value, i) => value + ' '.repeat(widths[i] - wide(value))))), rule('└', '┴', '┘')].join('\n');
}

function printed(database, blocks, number) {
  database.reopen();
  for (const block of blocks.slice(0, number)) {
    try { database.texts(block.text); } catch (error) { if (block.kind !== 'sql error') throw new Error(`A block before this one: ${error.message}`); }
  }
  const {results, ms} = database.texts(blocks[number].text);
  const shown = results.filter((result) => result.rows.length > 0).map(boxed).join('\n');
  return `${shown || 'Done.'}\n${ms.toFixed(1)} ms`;
}

function addButton(place, blocks, number) {
  const button = Object.assign(document.createElement('button'), {className: 'md-button run', textContent: 'Run', type: 'button'});
  const output = Object.assign(document.createElement('pre'), {className: 'run-output', hidden: true});
  output.setAttribute('aria-live', 'polite');
  button.title = 'Runs this block, and those before it, in this page';
  button.addEventListener('click', async () => {
    button.disabled = true;
    try {
      output.textContent = 'reading the module …';
      output.hidden = false;
      output.textContent = printed(await openDatabase(), blocks, number);
      output.classList.remove('failed');
    } catch (error) {
      output.textContent = `Error: ${error.message}`;
      output.classList.add('failed');
    }
    button.disabled = false;
  });
  place.append(button);
  place.after(output);
}

function addButtons() {
  const data = document.getElementById('sql-blocks');
  if (!data) return;
  const blocks = JSON.parse(data.textContent), places = [...document.querySelectorAll('.md-content div.highlight.language-sql, .md-content div.language-sql.highlight')];
  const shown = blocks.flatMap((block, number) => block.kind === 'setup' ? [] : [number]);
  if (shown.length !== places.length) return;
  shown.forEach((number, i) => { if (blocks[number].runs) addButton(places[i], blocks, number); });
}

addButtons();
