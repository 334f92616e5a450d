// Put the page together: the answer first, then the view, the sections, and where it all came from.
import {Cases} from './cases.js';
import {chartFigure, mapFigure} from './chart.js';
import {report} from './data.js';
import {Surface} from './surface.js';
import {tableFigure} from './table.js';
import {element, withUnit} from './text.js';

const page = document.getElementById('page');
const later = [];
let shown = null; // the cases of a study

function facts(list, className) {
  return element(
    'dl',
    {className},
    ...list.map(fact =>
      element(
        'div',
        {},
        element('dt', {}, fact.label),
        element(
          'dd',
          {},
          fact.text !== undefined
            ? fact.text + (fact.unit ? `\u00a0${fact.unit}` : '')
            : withUnit(fact.value, fact.unit)
        )
      )
    )
  );
}

// one choice of abscissa for all charts of a section
function abscissa(charts, figures, name) {
  const both = charts.find(chart => chart.axes.length > 1);
  if (!both) return null;
  return element(
    'fieldset',
    {className: 'controls'},
    element('legend', {}, 'Over'),
    ...both.axes.map((axis, k) => {
      const input = element('input', {type: 'radio', name: `over-${name}`, checked: k === 0});
      input.addEventListener('change', () => figures.forEach(figure => figure.over(k)));
      return element('label', {}, input, ` ${axis.label}`);
    })
  );
}

function section(part, i) {
  const charts = part.charts.map(chart => chartFigure(chart, part.charts.length > 1 ? `section-${i}` : null));
  const maps = part.maps.map(map => mapFigure(map));
  const cases = part.cases ? new Cases(part.cases, report.scene) : null;
  later.push(...charts, ...maps, ...(cases ? [cases] : []));
  if (cases) shown = cases;
  return element(
    'section',
    {},
    element('h2', {}, part.title),
    part.note ? element('p', {className: 'note'}, part.note) : null,
    cases?.figure,
    abscissa(part.charts, charts, i),
    charts.length
      ? element('p', {className: 'note hint'}, 'Drag across a chart to see a part of it, double-click to see all.')
      : null,
    charts.length || maps.length
      ? element('div', {className: 'charts'}, ...charts.map(c => c.figure), ...maps.map(m => m.figure))
      : null,
    ...part.tables.map(table => tableFigure(table))
  );
}

function provenance() {
  const {sources, options, version, verb} = report;
  return element(
    'section',
    {className: 'provenance'},
    element('h2', {}, 'Where this came from'),
    sources.length
      ? tableFigure({
          title: 'Files',
          note: null,
          rows: sources.length,
          columns: [
            {label: 'role', unit: '', texts: sources.map(s => s.role)},
            {label: 'file', unit: '', texts: sources.map(s => s.name)},
            {label: 'SHA-256', unit: '', texts: sources.map(s => s.sha256)}
          ]
        })
      : null,
    facts([{label: 'program', text: `wirecut ${version}, ${verb}`}, ...options], 'facts options')
  );
}

let surface = null;
page.querySelector('header').append(...(report.facts.length ? [facts(report.facts, 'facts')] : []));
page.querySelector('.verdict').classList.add(report.tone);
if (report.scene) {
  surface = new Surface(report.scene);
  page.append(surface.figure);
}
page.append(...report.sections.map(section), provenance());
if (surface && shown) surface.aboutPart = row => shown.about(row);
surface?.start();
later.forEach(part => part.start());

// what a test asks of the page
window.wirecut = {
  report,
  surface,
  cases: shown,
  pick: (x, y) => {
    const index = surface.view.pick(x, y);
    return index < 0 ? null : surface.select(index);
  },
  ready: true
};
