// Rows for people: names in place of numbers, minutes from now in place of times, metres without decimals. The title of a cell is the value.
'use strict';

const SHOWN_ROWS = 1000;
const TIMES = ['t', 't_end', 't_cpa'], SPANS = ['dt', 'dt_end', 'dt_cpa'], LENGTHS = ['d_cpa', 'distance'];

// How the columns of an answer are shown: [{title, unit, text: (value) => string}].
function columnsFor(answer, scene) {
  const minutes = scene && scene.horizon >= 120, unit = minutes ? 'min' : 's', scale = minutes ? 60 : 1;
  const isOfPairs = scene && scene.pairs.length > 0;
  return answer.columns.map((name, i) => {
    const spans = (from) => ({title: name, unit, text: (value) => typeof value === 'number' ? ((value - from) / scale).toFixed(1) : plain(value)});
    if (!isOfPairs) return {title: name, text: plain};
    if (name === 'a' || name === 'b') {
      const names = scene.tables[name === 'a' ? 0 : scene.tables.length - 1].styles;
      return {title: name, text: (value) => names.get(String(value))?.name || plain(value)};
    }
    if (TIMES.includes(name)) return spans(scene.now);
    if (SPANS.includes(name)) return spans(0);
    if (LENGTHS.includes(name)) return {title: name, unit: 'm', text: (value) => typeof value === 'number' ? value.toFixed(value < 10 ? 2 : 0) : plain(value)};
    return {title: name, text: plain};
  });
}

function plain(value) {
  if (value === null) return '';
  if (typeof value !== 'number' || Number.isInteger(value)) return String(value);
  return String(Number(value.toPrecision(7)));
}

function showRows(table, answer, scene, choose) {
  const columns = columnsFor(answer, scene), head = document.createElement('tr');
  // A column is text if its first value is shown as such.
  const isText = columns.map((column, i) => answer.rows.length > 0 && !/^-?[\d.]+(e[+-]\d+)?$|^$/i.test(column.text(answer.rows[0][i])));
  head.append(...columns.map((column, i) => {
    const cell = Object.assign(document.createElement('th'), {textContent: column.title, className: isText[i] ? 'text' : ''});
    if (column.unit) cell.append(Object.assign(document.createElement('small'), {textContent: column.unit}));
    return cell;
  }));
  table.tHead.replaceChildren(head);
  table.tBodies[0].replaceChildren(...answer.rows.slice(0, SHOWN_ROWS).map((row, number) => {
    const line = document.createElement('tr');
    line.tabIndex = 0;
    line.append(...row.map((value, i) => Object.assign(document.createElement('td'), {
      textContent: columns[i].text(value), className: isText[i] ? 'text' : '', title: value === null ? 'NULL' : String(value)})));
    line.onclick = () => choose(number);
    line.onkeydown = (event) => { if (event.key === 'Enter') choose(number); };
    return line;
  }));
}
