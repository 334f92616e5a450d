// Line charts and maps of values (uPlot), each with words and a table for those who do not see it.
import uPlot from 'uplot';
import {colourOf, css, onPalette, palette} from './colour.js';
import {doubles, floats} from './data.js';
import {element, extent, fixed, labelled, number} from './text.js';

const FONT = '12px system-ui, sans-serif';
const all = [];

// keep a chart as wide as its place, and in the page's colours
function live(place, plot, height) {
  all.push(plot);
  new ResizeObserver(() => {
    const width = Math.floor(place.clientWidth);
    if (width > 0 && width !== plot.width) plot.setSize({width, height});
  }).observe(place);
  return plot;
}
onPalette(() => all.forEach(plot => plot.redraw(false, true)));

const tick = (_, values) => {
  const step = values.length > 1 ? Math.abs(values[1] - values[0]) : 1;
  const places = Math.min(9, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  return values.map(v => (step < 1e-6 ? number(v) : fixed(v, places)));
};

function axes(x, y, height) {
  const common = {
    stroke: () => palette().faint,
    font: FONT,
    labelFont: FONT,
    labelGap: 2,
    values: tick,
    grid: {stroke: () => palette().grid, width: 1},
    ticks: {stroke: () => palette().grid, size: 4}
  };
  // a label that is longer than the axis would be cut off; title and legend say what the unit is of
  const short = y.length > (height - 60) / 6.5 && y.includes('[') ? y.slice(y.lastIndexOf('[')) : y;
  return [
    {...common, label: x, size: 30, labelSize: 20, space: 64},
    {
      ...common,
      label: short,
      labelSize: 20,
      space: 36,
      size: (_, values) => 16 + 6.6 * Math.max(5, ...(values ?? []).map(v => v.length))
    }
  ];
}

// a little more than the values span; around a line that is level, one unit up and down
const spread = (_, low, high) =>
  low === null ? [0, 1] : low === high ? [low - 1, high + 1] : uPlot.rangeNum(low, high, 0.08, true);

const listed = typed => Array.from(typed, v => (Number.isNaN(v) ? null : v));

// every series of a chart over one of its abscissae as uPlot's columns: lines, and the edges of bands
function columns(chart, axis) {
  const tables = chart.series.map(series => {
    const x = axis === 1 && series.x2 !== undefined ? series.x2 : series.x;
    const ids = [series.y, ...(series.low === undefined ? [] : [series.high, series.low])];
    return {x: listed(doubles(x)), id: x, y: ids.map(id => listed(doubles(id)))};
  });
  if (tables.every(table => table.id === tables[0].id)) return [tables[0].x, ...tables.flatMap(table => table.y)];
  // points need not be in order, a joined table must be
  const sorted = tables.map(({x, y}) => {
    const order = x
      .map((_, i) => i)
      .filter(i => x[i] !== null)
      .sort((i, j) => x[i] - x[j]);
    // the join keeps one row an abscissa; points that share one are set apart by less than can be seen
    const apart = order.map(i => x[i]);
    for (let k = 1; k < apart.length; k++)
      if (apart[k] <= apart[k - 1]) apart[k] = apart[k - 1] + Math.max(Math.abs(apart[k - 1]), 1e-30) * 1e-12;
    return [apart, ...y.map(column => order.map(i => column[i]))];
  });
  return uPlot.join(sorted);
}

function paintSpans(chart, plot, axis) {
  const {ctx, bbox} = plot,
    ratio = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.font = `${11 * ratio}px system-ui, sans-serif`;
  ctx.textBaseline = 'top';
  ctx.textAlign = 'left';
  chart.spans.forEach((span, i) => {
    const left = plot.valToPos(span.from[axis], 'x', true),
      right = plot.valToPos(span.to[axis], 'x', true);
    if (i % 2 === 0) {
      ctx.fillStyle = palette().span;
      ctx.fillRect(left, bbox.top, right - left, bbox.height);
    }
    const start = Math.max(left, bbox.left) + 5 * ratio;
    if (ctx.measureText(span.label).width + 8 * ratio < Math.min(right, bbox.left + bbox.width) - start) {
      ctx.fillStyle = palette().faint;
      ctx.fillText(span.label, start, bbox.top + 4 * ratio);
    }
  });
  ctx.restore();
}

// a table of a chart's numbers, made when it is opened
function numbers(chart, axis) {
  const details = element('details', {className: 'numbers'}, element('summary', {}, 'Numbers'));
  details.addEventListener('toggle', () => {
    if (!details.open || details.querySelector('table')) return;
    const data = columns({series: chart.series.map(({low, high, ...rest}) => rest)}, axis());
    const most = 2000,
      rows = Math.min(data[0].length, most);
    const head = [
      labelled(chart.axes[axis()].label, chart.axes[axis()].unit),
      ...chart.series.map(s => labelled(s.label, chart.unit))
    ];
    const body = element('tbody');
    for (let r = 0; r < rows; r++)
      body.append(
        element('tr', {}, ...data.map(column => element('td', {className: 'number'}, number(column[r] ?? null))))
      );
    const table = element(
      'table',
      {},
      element(
        'thead',
        {},
        element('tr', {}, ...head.map(text => element('th', {scope: 'col', className: 'number'}, text)))
      ),
      body
    );
    details.append(element('div', {className: 'scroll'}, table));
    if (rows < data[0].length)
      details.append(element('p', {className: 'note'}, `The first ${number(rows)} of ${number(data[0].length)} rows.`));
  });
  return details;
}

function words(chart) {
  const lines = chart.series.map(series => {
    const range = extent(doubles(series.y));
    return range
      ? `${series.label} from ${number(range[0])} to ${number(range[1])} ${chart.unit}`
      : `${series.label} has no values`;
  });
  return `${chart.title}: ${lines.join('; ')}.`;
}

function seriesOptions(chart) {
  const options = [{}],
    bands = [];
  chart.series.forEach((series, i) => {
    const colour = () => palette().series[i % 8],
      range = extent(doubles(series.y));
    const span = range ? `${number(range[0])} to ${number(range[1])}` : '\u2013';
    options.push({
      label: labelled(series.label, chart.unit),
      stroke: colour,
      width: 1.5,
      spanGaps: false,
      dash: series.mark === 'dashed' ? [6, 4] : undefined,
      paths: series.mark === 'points' ? () => null : undefined,
      points:
        series.mark === 'points' ? {show: true, size: 6, stroke: colour, fill: () => palette().page} : {show: false},
      // without a cursor the legend says what the series spans
      value: (_, v, __, at) => (at === null || at === undefined ? span : number(v ?? null))
    });
    if (series.low === undefined) return;
    const edge = {stroke: 'transparent', width: 0, points: {show: false}, class: 'edge'};
    options.push({...edge, label: 'high'}, {...edge, label: 'low'});
    bands.push({series: [options.length - 2, options.length - 1], fill: () => `${palette().series[i % 8]}33`});
  });
  return {options, bands};
}

// uPlot's legend hides and shows series by mouse; let keys do it too
function reachLegend(plot) {
  plot.root.querySelectorAll('.u-legend .u-series').forEach((row, i) => {
    const head = row.querySelector('th');
    if (i === 0 || !head || row.classList.contains('edge')) return;
    head.tabIndex = 0;
    head.setAttribute('role', 'button');
    head.addEventListener('keydown', event => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      head.click();
    });
  });
}

// a figure of a chart; sync names the charts whose cursors move together, those over the same abscissa
export function chartFigure(chart, sync, height = 220) {
  const place = element('div', {className: 'plot', role: 'img', 'aria-label': words(chart)});
  let axis = 0,
    plot = null,
    bandsShown = true;
  const build = () => {
    if (plot) {
      all.splice(all.indexOf(plot), 1);
      plot.destroy();
    }
    const {options, bands} = seriesOptions(chart);
    const x = labelled(chart.axes[axis].label, chart.axes[axis].unit);
    options[0] = {label: x, value: (_, v, __, at) => (at === null || at === undefined ? '' : number(v ?? null))};
    plot = new uPlot(
      {
        width: Math.max(place.clientWidth, 280),
        height,
        scales: {x: {time: false}, y: {range: spread}},
        series: options,
        bands: bandsShown ? bands : [],
        axes: axes(x, labelled(chart.label, chart.unit), height),
        legend: {live: true},
        cursor: {
          sync: sync ? {key: `${sync}-${chart.axes[axis].label}`, setSeries: false} : undefined,
          points: {size: 6},
          drag: {x: true, y: false}
        },
        hooks: {drawClear: [u => paintSpans(chart, u, axis)]}
      },
      columns(chart, axis),
      place
    );
    live(place, plot, height);
    reachLegend(plot);
  };
  const caption = element('figcaption', {}, element('h3', {}, chart.title));
  const figure = element('figure', {className: 'chart'}, caption);
  if (chart.series.some(series => series.low !== undefined)) {
    const box = element('input', {type: 'checkbox', checked: true});
    box.addEventListener('change', () => {
      bandsShown = box.checked;
      build();
    });
    caption.append(element('label', {className: 'option'}, box, ' bands'));
  }
  if (chart.note) caption.append(element('p', {className: 'note'}, chart.note));
  figure.append(
    place,
    numbers(chart, () => axis)
  );
  const shown = Math.max(...chart.series.map(s => s.total)) > 10000;
  if (shown)
    figure.append(
      element('p', {className: 'note'}, 'Long series are drawn by the lowest and highest value of each short run.')
    );
  return {
    figure,
    start: build,
    over: k => {
      if (chart.axes[k]) {
        axis = k;
        build();
      }
    }
  };
}

// the edges of cells from their centres
function edges(centre) {
  const out = new Float64Array(centre.length + 1);
  for (let i = 1; i < centre.length; i++) out[i] = (centre[i - 1] + centre[i]) / 2;
  out[0] = 2 * centre[0] - out[1];
  out[centre.length] = 2 * centre[centre.length - 1] - out[centre.length - 1];
  return out;
}

function cellAt(edge, v) {
  let low = 0,
    high = edge.length - 2;
  if (!(v >= edge[0] && v <= edge[edge.length - 1])) return -1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (edge[middle] <= v) low = middle;
    else high = middle - 1;
  }
  return low;
}

function paintMap(plot, map, xe, ye, value, scale) {
  const {left, top, width, height} = plot.bbox;
  const image = plot.ctx.createImageData(Math.round(width), Math.round(height)),
    missing = palette().missing;
  const columnOf = Array.from({length: image.width}, (_, i) => cellAt(xe, plot.posToVal(left + i + 0.5, 'x', true)));
  const table = Array.from({length: 512}, (_, i) => colourOf(scale, scale.low + ((scale.high - scale.low) * i) / 511));
  for (let j = 0, k = 0; j < image.height; j++) {
    const row = cellAt(ye, plot.posToVal(top + j + 0.5, 'y', true));
    for (let i = 0; i < image.width; i++, k += 4) {
      if (row < 0 || columnOf[i] < 0) continue;
      const v = value[row * (xe.length - 1) + columnOf[i]];
      if (map.blank_missing && Number.isNaN(v)) continue;
      const rgb = Number.isNaN(v)
        ? missing
        : table[Math.min(511, Math.max(0, Math.round(((v - scale.low) / (scale.high - scale.low)) * 511)))];
      image.data.set([rgb[0], rgb[1], rgb[2], 255], k);
    }
  }
  plot.ctx.putImageData(image, Math.round(left), Math.round(top));
}

// names of bands of rows in place of numbers, between rules
function bandAxis(axis, bands, ye) {
  const ends = bands.map((_, b) => ye[b + 1 < bands.length ? bands[b + 1].row : ye.length - 1]);
  const middles = bands.map((band, b) => (ye[band.row] + ends[b]) / 2);
  return {
    ...axis,
    label: undefined,
    labelSize: 0,
    space: 1,
    splits: () => middles,
    values: () => bands.map(band => band.label),
    grid: {show: false},
    ticks: {show: false}
  };
}

function ruleBands(plot, bands, ye) {
  const {left, width} = plot.bbox;
  plot.ctx.fillStyle = palette().faint;
  for (const band of bands.slice(1))
    plot.ctx.fillRect(left, Math.round(plot.valToPos(ye[band.row], 'y', true)), width, 1);
}

// a strip of a scale's colours with its ends named
export function strip(scale, unit) {
  const canvas = element('canvas', {width: 256, height: 10, className: 'strip', 'aria-hidden': 'true'});
  const paint = () => {
    const ctx = canvas.getContext('2d');
    for (let i = 0; i < 256; i++) {
      ctx.fillStyle = css(colourOf(scale, scale.low + ((scale.high - scale.low) * (i + 0.5)) / 256));
      ctx.fillRect(i, 0, 1, 10);
    }
  };
  paint();
  return element(
    'div',
    {className: 'strip-row'},
    element('span', {}, number(scale.low)),
    canvas,
    element('span', {}, `${number(scale.high)} ${unit}`)
  );
}

// a figure of a map
export function mapFigure(map, height = 260) {
  const x = doubles(map.x),
    y = doubles(map.y),
    value = floats(map.value),
    xe = edges(x),
    ye = edges(y);
  const range = extent(value) ?? [0, 1];
  const limit = map.limit || Math.max(Math.abs(range[0]), Math.abs(range[1])) || 1;
  const scale =
    map.scale === 'diverging'
      ? {kind: 'diverging', low: -limit, high: limit, tolerance: 0}
      : {kind: 'sequential', low: Math.min(range[0], 0), high: map.limit || range[1]};
  const bands = map.bands ?? [];
  const rows = bands.length ? bands.map(band => band.label).join(', ') : map.y_label;
  const label =
    `${map.title}: ${map.label} over ${map.x_label} and ${rows}, ` +
    `from ${number(range[0])} to ${number(range[1])} ${map.unit}.`;
  const place = element('div', {className: 'plot', role: 'img', 'aria-label': label});
  const readout = element('p', {className: 'note readout-line'}, '\u00a0');
  const rowText = j => {
    const band = bands.filter(each => each.row <= j).pop();
    return band ? `${band.label}, row ${j - band.row + 1}` : `${map.y_label} ${number(y[j])} ${map.y_unit}`;
  };
  const start = () => {
    const ends = e => [e[0], e[e.length - 1]];
    const [xAxis, yAxis] = axes(labelled(map.x_label, map.x_unit), labelled(map.y_label, map.y_unit), height);
    const plot = new uPlot(
      {
        width: Math.max(place.clientWidth, 280),
        height,
        legend: {show: false},
        scales: {x: {time: false, range: () => ends(xe)}, y: {range: () => ends(ye)}},
        series: [{}, {stroke: 'transparent', points: {show: false}}],
        axes: [xAxis, bands.length ? bandAxis(yAxis, bands, ye) : yAxis],
        cursor: {drag: {x: false, y: false}, points: {show: false}},
        hooks: {
          drawClear: [
            u => {
              paintMap(u, map, xe, ye, value, scale);
              ruleBands(u, bands, ye);
            }
          ],
          setCursor: [
            u => {
              const i = cellAt(xe, u.posToVal(u.cursor.left, 'x')),
                j = cellAt(ye, u.posToVal(u.cursor.top, 'y'));
              readout.textContent =
                i < 0 || j < 0 || u.cursor.left < 0
                  ? '\u00a0'
                  : `${map.x_label} ${number(x[i])} ${map.x_unit}, ${rowText(j)}: ` +
                    `${number(value[j * x.length + i])} ${map.unit}`;
            }
          ]
        }
      },
      [Array.from(x), Array.from(x, () => null)],
      place
    );
    live(place, plot, height);
  };
  const figure = element(
    'figure',
    {className: 'chart'},
    element(
      'figcaption',
      {},
      element('h3', {}, map.title),
      map.note ? element('p', {className: 'note'}, map.note) : null
    ),
    place,
    element('div', {className: 'strip-label'}, labelled(map.label, map.unit), strip(scale, map.unit)),
    readout
  );
  return {figure, start};
}
