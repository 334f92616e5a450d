// Tables: numbers right-aligned with the decimals their column needs.
import {decimals, element, fixed, labelled, number} from './text.js';

// own: every number has its own decimals, for columns that mix quantities; a column of units says that they do
export function tableFigure(table, own = false) {
  const mixed = own || table.columns.some(column => !column.numbers && column.label === 'unit');
  const head = element('tr'),
    body = element('tbody');
  const show = table.columns.map(column => {
    head.append(
      element('th', {scope: 'col', className: column.numbers ? 'number' : ''}, labelled(column.label, column.unit))
    );
    if (!column.numbers) return r => element('td', {}, column.texts[r] ?? '\u2013');
    const there = column.numbers.filter(v => v !== null);
    const whole = there.every(Number.isInteger),
      largest = Math.max(0, ...there.map(Math.abs)),
      smallest = Math.min(...there.map(v => Math.abs(v) || Infinity));
    // a column that spans many decades cannot share its decimals
    const alone = mixed || largest >= 1e7 || largest / smallest > 1e5 || largest < 1e-4;
    return r =>
      element(
        'td',
        {className: 'number'},
        alone && !whole ? number(column.numbers[r]) : fixed(column.numbers[r], whole ? 0 : decimals(largest))
      );
  });
  for (let r = 0; r < table.rows; r++) body.append(element('tr', {}, ...show.map(cell => cell(r))));
  return element(
    'figure',
    {className: 'table'},
    element(
      'figcaption',
      {},
      element('h3', {}, table.title),
      table.note ? element('p', {className: 'note'}, table.note) : null
    ),
    element(
      'div',
      {className: 'scroll', tabIndex: 0, role: 'region', 'aria-label': table.title},
      element('table', {}, element('thead', {}, head), body)
    )
  );
}
