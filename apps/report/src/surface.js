// The figure in space: choose a shape and a field, read colours and points, follow a station and a node.
import {Vector3} from 'three';
import {onPalette, palette} from './colour.js';
import {chartFigure} from './chart.js';
import {floats, given, ints} from './data.js';
import {Histogram, firstScale, quantile, sentence} from './field.js';
import {Plan} from './plan.js';
import {tableFigure} from './table.js';
import {element, labelled, number, withUnit} from './text.js';
import {View, gridTriangles, steer} from './view.js';

const EVERY = 24; // lines of the grid that are drawn, in each direction

const original = (k, stride, total) => Math.min(k * stride, total - 1);

// positions of a row or a column of a grid
function gridLine(shape, index, alongRow) {
  const count = alongRow ? shape.columns : shape.rows,
    out = new Float32Array(3 * count),
    position = floats(shape.position);
  for (let k = 0; k < count; k++) {
    const i = alongRow ? index * shape.columns + k : k * shape.columns + index;
    out.set(position.subarray(3 * i, 3 * i + 3), 3 * k);
  }
  return out;
}

function gridLines(shape, alongRow) {
  const count = alongRow ? shape.rows : shape.columns,
    step = Math.max(1, Math.round((count - 1) / EVERY)),
    out = [];
  for (let k = 0; k < count - 1; k += step) out.push(gridLine(shape, k, alongRow));
  out.push(gridLine(shape, count - 1, alongRow));
  return out;
}

// what stands for a big shape while it is being turned on a slow machine: about 40,000 points, or the triangles of a
// grid with every k-th row and column
function coarse(shape) {
  const step = Math.ceil(Math.sqrt(shape.count / 40000));
  if (step < 2 || (shape.triangles && !shape.rows)) return null;
  if (!shape.rows) return Uint32Array.from({length: Math.floor(shape.count / step ** 2)}, (_, i) => i * step ** 2);
  const rows = Math.ceil((shape.rows - 1) / step) + 1,
    columns = Math.ceil((shape.columns - 1) / step) + 1;
  return gridTriangles(rows, columns).map(
    i =>
      Math.min(Math.floor(i / columns) * step, shape.rows - 1) * shape.columns +
      Math.min((i % columns) * step, shape.columns - 1)
  );
}

function boxLines([w, l, h]) {
  const corner = i => [i & 1 ? w : 0, i & 2 ? l : 0, i & 4 ? h : 0],
    out = [];
  for (let i = 0; i < 8; i++)
    for (const bit of [1, 2, 4]) if (!(i & bit)) out.push(new Float32Array([...corner(i), ...corner(i | bit)]));
  return out;
}

// the box and the sphere that hold all that is shown
function bounds(scene) {
  const low = new Vector3(Infinity, Infinity, Infinity),
    high = low.clone().negate(),
    p = new Vector3();
  const add = points => {
    for (let i = 0; i < points.length; i += 3) {
      p.fromArray(points, i);
      low.min(p);
      high.max(p);
    }
  };
  scene.shapes.forEach(shape => add(floats(shape.position)));
  if (scene.block[0] > 0) add([0, 0, 0, ...scene.block]);
  const corners = Array.from(
    {length: 8},
    (_, i) => new Vector3(i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z)
  );
  return {centre: low.clone().add(high).multiplyScalar(0.5), radius: Math.max(low.distanceTo(high) / 2, 1e-6), corners};
}

export class Surface {
  constructor(scene) {
    this.scene = scene;
    this.histogram = new Histogram();
    this.words = element('p', {className: 'note share'});
    this.readout = element('dl', {className: 'readout', 'aria-live': 'polite'});
    this.part = element('p', {className: 'note share', 'aria-live': 'polite'});
    this.aboutPart = null; // what the page says of a part of a shape
    this.profiles = element('div', {className: 'charts'});
    this.canvas = element('canvas', {tabIndex: 0, role: 'img'});
    this.overlay = element('canvas', {className: 'overlay', 'aria-hidden': 'true'});
    this.paper = element('img', {className: 'paper', alt: ''});
    this.frame = element('div', {className: 'frame'}, this.canvas, this.overlay, this.paper);
    this.range = element('div', {className: 'controls'});
    this.finder = element('div', {className: 'controls'});
    this.notice = element('p', {className: 'notice', hidden: true});
    this.figure = element(
      'section',
      {className: 'surface', 'aria-label': scene.title},
      element('h2', {}, scene.title),
      scene.note ? element('p', {className: 'note'}, scene.note) : null,
      this.notice,
      this.controls(),
      this.frame,
      (this.hint = element(
        'p',
        {className: 'note hint'},
        'Drag to turn, shift-drag to move, click and scroll to zoom, click a point to read it. ' +
          'Keys: arrows, + and \u2212, 0 to start over.'
      )),
      element(
        'div',
        {className: 'scale'},
        (this.scaleLabel = element('p', {className: 'scale-label'})),
        this.histogram.canvas,
        this.words,
        this.range
      ),
      this.finder,
      this.part,
      this.readout,
      this.profiles,
      this.statistics()
    );
  }

  start() {
    // asked of a canvas that is thrown away: the renderer gets its own with the attributes it wants
    this.space = Boolean(document.createElement('canvas').getContext('webgl2'));
    this.view = this.space ? new View(this.canvas, bounds(this.scene)) : new Plan(this.canvas);
    if (!this.space) {
      this.notice.hidden = false;
      this.hint.textContent = 'Click a point to read it.';
      this.notice.textContent =
        'This browser offers no WebGL 2, so the view in space is replaced by a map seen from above: ' +
        'x to the right, feed direction y upward.';
    }
    this.view.drawn = () => this.paintOverlay();
    if (this.scene.block[0] > 0) this.view.setLines('block', boxLines(this.scene.block), 'outline');
    this.givenLines();
    this.choose(0, 0);
    steer(this.view, this.canvas, (x, y) => this.select(this.view.pick(x, y)));
    new ResizeObserver(() => this.view.resize()).observe(this.frame);
    this.view.resize();
    onPalette(printing => {
      this.view.draw(true);
      if (printing) this.print();
    });
  }

  // a picture for paper, of the view as it stands
  print() {
    const copy = element('canvas', {width: this.canvas.width, height: this.canvas.height}),
      ctx = copy.getContext('2d');
    ctx.drawImage(this.canvas, 0, 0);
    ctx.drawImage(this.overlay, 0, 0, copy.width, copy.height);
    this.paper.src = copy.toDataURL('image/png');
    this.paper.alt = this.canvas.getAttribute('aria-label');
  }

  controls() {
    this.select1 = element('select', {});
    this.scene.shapes.forEach((shape, s) => {
      const options = shape.fields.map((field, f) =>
        element('option', {value: `${s} ${f}`}, labelled(field.label, field.unit))
      );
      this.select1.append(
        ...(this.scene.shapes.length > 1 ? [element('optgroup', {label: shape.name}, ...options)] : options)
      );
    });
    this.select1.addEventListener('change', () => this.choose(...this.select1.value.split(' ').map(Number)));
    this.lines = element('span', {className: 'checks'});
    return element('div', {className: 'controls'}, element('label', {}, 'Colour by ', this.select1), this.lines);
  }

  // a box that shows and hides a group of lines
  box(text, shown, change) {
    const input = element('input', {type: 'checkbox', checked: shown});
    input.addEventListener('change', () => change(input.checked));
    return element('label', {}, input, ` ${text}`);
  }

  givenLines() {
    this.marks = [];
    this.groups = [...new Set(this.scene.lines.map(line => line.group))].map(name => {
      const lines = this.scene.lines.filter(line => line.group === name);
      const points = lines.map(line => ({label: line.label, points: floats(line.points)}));
      this.view.setLines(
        `given ${name}`,
        points.filter(p => p.points.length > 3).map(p => p.points),
        'line'
      );
      const group = {name, marks: points.filter(p => p.points.length === 3), shown: true};
      this.marks.push(group);
      return group;
    });
  }

  // boxes: shading and the grid's own lines, then the groups that came with the scene
  buildBoxes(shape) {
    const boxes = [];
    if (shape.rows) {
      for (const [label, alongRow] of [
        [shape.row_label, true],
        [shape.column_label, false]
      ]) {
        const name = alongRow ? `${label} lines` : `${label} curves`;
        this.view.setLines(name, gridLines(shape, alongRow), 'weak');
        const shown = this.shown?.[name] ?? true;
        this.view.showLines(name, shown);
        boxes.push(
          this.box(name, shown, on => {
            (this.shown ??= {})[name] = on;
            this.view.showLines(name, on);
          })
        );
      }
    }
    for (const group of this.groups)
      boxes.push(
        this.box(group.name, group.shown, on => {
          group.shown = on;
          this.view.showLines(`given ${group.name}`, on);
        })
      );
    if (shape.triangles && this.space) boxes.push(this.box('shading', true, on => this.view.setShade(on)));
    this.lines.replaceChildren(...boxes);
  }

  choose(s, f) {
    const shape = this.scene.shapes[s],
      changed = this.shape !== shape;
    this.shape = shape;
    this.field = shape.fields[f];
    this.select1.value = `${s} ${f}`;
    if (changed) {
      if (this.gridNames) this.gridNames.forEach(name => this.view.clearLines(name));
      this.gridNames = shape.rows ? [`${shape.row_label} lines`, `${shape.column_label} curves`] : [];
      shape.triangles = shape.rows
        ? gridTriangles(shape.rows, shape.columns)
        : given(shape.triangle_array)
          ? new Uint32Array(ints(shape.triangle_array))
          : null;
      this.view.setShape({position: floats(shape.position), triangles: shape.triangles, coarse: coarse(shape)});
      this.buildBoxes(shape);
      this.buildFinder(shape);
      this.select(-1);
    }
    this.view.setValues(floats(this.field.value));
    this.rescale({...firstScale(this.field), bands: this.scale?.bands ?? false});
    this.buildRange();
    if (this.index >= 0) this.buildProfiles();
  }

  rescale(scale) {
    this.scale = scale;
    this.view.setScale(scale);
    this.histogram.show(this.field, scale);
    this.words.textContent = sentence(this.field, scale);
    this.scaleLabel.textContent = labelled(this.field.label, this.field.unit);
    const {name, total, count} = this.shape;
    this.canvas.setAttribute(
      'aria-label',
      `${name} coloured by ${this.field.label}, ${number(scale.low)} to ${number(scale.high)} ${this.field.unit}. ` +
        sentence(this.field, scale) +
        (count < total ? ` The view shows ${number(count)} of ${number(total)} points.` : '')
    );
  }

  // number boxes for the ends of the scale and the tolerance
  buildRange() {
    const entry = (text, value, change) => {
      const input = element('input', {type: 'number', step: 'any', value: Number(value.toPrecision(6))});
      input.addEventListener('input', () => {
        if (input.value !== '' && Number.isFinite(input.valueAsNumber)) change(input.valueAsNumber);
      });
      return element('label', {}, `${text} `, input, this.field.unit ? ` ${this.field.unit}` : '');
    };
    const change = part => {
      const next = {...this.scale, ...part};
      if (next.high > next.low) this.rescale(next);
    };
    const {kind, low, high, tolerance} = this.scale;
    const inputs =
      kind === 'diverging'
        ? [
            entry('Tolerance \u00b1', tolerance, v => {
              if (v >= 0) change({tolerance: v});
            }),
            entry('full colour at \u00b1', high, v => {
              if (v > 0) change({low: -v, high: v});
            })
          ]
        : [entry('Colours from', low, v => change({low: v})), entry('to', high, v => change({high: v}))];
    const again = element('button', {type: 'button'}, 'Reset');
    again.addEventListener('click', () => {
      this.rescale({...firstScale(this.field), bands: this.scale.bands});
      this.buildRange();
    });
    this.range.replaceChildren(
      ...inputs,
      this.box('bands', this.scale.bands, on => change({bands: on})),
      again
    );
  }

  // the same as a click, by keyboard
  buildFinder(shape) {
    const entry = (label, most, step, change) => {
      const input = element('input', {type: 'number', min: 0, max: most, step});
      input.addEventListener('input', () => {
        if (input.value !== '' && input.checkValidity()) change(input.valueAsNumber);
      });
      return [element('label', {}, `${label} `, input), input];
    };
    if (shape.rows) {
      const nearest = (v, stride, count) => Math.min(Math.round(v / stride), count - 1);
      const both = () => {
        if (rowInput.value === '' || columnInput.value === '') return;
        this.select(
          nearest(rowInput.valueAsNumber, shape.row_stride, shape.rows) * shape.columns +
            nearest(columnInput.valueAsNumber, shape.column_stride, shape.columns),
          true
        );
      };
      const [row, rowInput] = entry(`Read at ${shape.row_label}`, shape.row_total - 1, 1, both);
      const [column, columnInput] = entry(shape.column_label, shape.column_total - 1, 1, both);
      this.finder.replaceChildren(row, column);
      this.found = index => {
        rowInput.value = original(Math.floor(index / shape.columns), shape.row_stride, shape.row_total);
        columnInput.value = original(index % shape.columns, shape.column_stride, shape.column_total);
      };
    } else {
      const [point, input] = entry('Read at point', shape.count - 1, 1, v => this.select(v, true));
      this.finder.replaceChildren(point);
      this.found = index => {
        input.value = index;
      };
    }
  }

  // what is known of a vertex
  at(index) {
    const {shape} = this,
      position = floats(shape.position);
    return {
      shape: shape.name,
      index,
      row: shape.rows ? original(Math.floor(index / shape.columns), shape.row_stride, shape.row_total) : null,
      column: shape.rows ? original(index % shape.columns, shape.column_stride, shape.column_total) : null,
      position: Array.from(position.subarray(3 * index, 3 * index + 3)),
      values: shape.fields.map(field => ({label: field.label, unit: field.unit, value: floats(field.value)[index]}))
    };
  }

  select(index, typed = false) {
    this.index = index;
    if (index < 0) {
      this.readout.replaceChildren();
      this.part.replaceChildren();
      this.profiles.replaceChildren();
      this.view.clearLines('picked');
      this.view.draw();
      return null;
    }
    const point = this.at(index),
      {shape} = this;
    if (!typed) this.found(index);
    if (this.aboutPart && given(shape.part)) this.part.replaceChildren(...this.aboutPart(ints(shape.part)[index]));
    const pairs = [
      ...(shape.rows
        ? [
            [shape.row_label, number(point.row)],
            [shape.column_label, number(point.column)]
          ]
        : [['point', number(index)]]),
      ...['x', 'y', 'z'].map((name, k) => [name, withUnit(point.position[k], 'mm')]),
      ...point.values.map(({label, unit, value}) => [label, Number.isNaN(value) ? 'none' : withUnit(value, unit)])
    ];
    this.readout.replaceChildren(
      ...pairs.map(([label, value]) => element('div', {}, element('dt', {}, label), element('dd', {}, value)))
    );
    if (shape.rows)
      this.view.setLines(
        'picked',
        [gridLine(shape, Math.floor(index / shape.columns), true), gridLine(shape, index % shape.columns, false)],
        'accent'
      );
    this.view.draw();
    this.buildProfiles();
    return point;
  }

  // the field along the picked row and column, or for a cloud across the feed at the picked point
  buildProfiles() {
    const {shape, field, index} = this,
      values = floats(field.value);
    const chart = (title, x, y) =>
      chartFigure(
        {
          title,
          note: null,
          axes: [x.axis],
          label: field.label,
          unit: field.unit,
          spans: [],
          series: [{label: field.label, mark: x.mark, total: y.length, x: x.values, y}]
        },
        null,
        200
      );
    const charts = [];
    if (shape.rows) {
      for (const alongRow of [true, false]) {
        const line = alongRow ? Math.floor(index / shape.columns) : index % shape.columns,
          points = gridLine(shape, line, alongRow);
        const count = points.length / 3,
          x = new Float64Array(count),
          y = new Float64Array(count);
        for (let k = 0; k < count; k++) {
          const j = 3 * k;
          if (k)
            x[k] =
              x[k - 1] +
              Math.hypot(points[j] - points[j - 3], points[j + 1] - points[j - 2], points[j + 2] - points[j - 1]);
          y[k] = values[alongRow ? line * shape.columns + k : k * shape.columns + line];
        }
        const label = alongRow ? shape.row_label : shape.column_label;
        const name = original(
          line,
          alongRow ? shape.row_stride : shape.column_stride,
          alongRow ? shape.row_total : shape.column_total
        );
        charts.push(
          chart(
            `${field.label} along ${label} ${number(name)}`,
            {axis: {label: `distance along ${label}`, unit: 'mm'}, mark: 'line', values: x},
            y
          )
        );
      }
    } else if (!given(shape.part)) {
      const position = floats(shape.position),
        y0 = position[3 * index + 1];
      const half = this.slab(position),
        picked = [];
      for (let i = 0; i < values.length; i++) if (Math.abs(position[3 * i + 1] - y0) <= half) picked.push(i);
      picked.sort((a, b) => position[3 * a] - position[3 * b]);
      charts.push(
        chart(
          `${field.label} across the feed at y = ${number(y0)} \u00b1 ${number(half)} mm`,
          {axis: {label: 'x', unit: 'mm'}, mark: 'points', values: Float64Array.from(picked, i => position[3 * i])},
          Float64Array.from(picked, i => values[i])
        )
      );
    }
    this.profiles.replaceChildren(...charts.map(c => c.figure));
    charts.forEach(c => c.start());
  }

  // half the thickness of a section through a cloud: a 400th of its length
  slab(position) {
    let low = Infinity,
      high = -Infinity;
    for (let i = 1; i < position.length; i += 3) {
      low = Math.min(low, position[i]);
      high = Math.max(high, position[i]);
    }
    return Math.max((high - low) / 400, 1e-6);
  }

  // names on top of the picture: block edges with their lengths, marks, the picked point
  paintOverlay() {
    const {overlay, frame, view} = this,
      width = frame.clientWidth,
      height = frame.clientHeight,
      ratio = Math.min(devicePixelRatio, 2);
    if (!width) return;
    overlay.width = Math.round(width * ratio);
    overlay.height = Math.round(height * ratio);
    const ctx = overlay.getContext('2d'),
      colours = palette();
    ctx.scale(ratio, ratio);
    ctx.font = '12px system-ui, sans-serif';
    ctx.textBaseline = 'middle';
    const background = `#${colours.view.toString(16).padStart(6, '0')}`;
    const text = (words, [x, y], colour, align = 'center') => {
      ctx.textAlign = align;
      ctx.lineWidth = 4;
      ctx.lineJoin = 'round';
      ctx.strokeStyle = background;
      ctx.strokeText(words, x, y);
      ctx.fillStyle = colour;
      ctx.fillText(words, x, y);
    };
    const [w, l, h] = this.scene.block;
    if (w > 0)
      [
        ['x', [w / 2, 0, 0], w],
        ['y', [w, l / 2, 0], l],
        ['z', [0, 0, h / 2], h]
      ]
        .slice(0, this.space ? 3 : 2)
        .forEach(([name, place, size]) => text(`${name} ${number(size)} mm`, view.project(...place), colours.faint));
    ctx.lineWidth = 2;
    for (const group of this.marks ?? [])
      if (group.shown)
        for (const {label, points} of group.marks) {
          const [x, y] = view.project(...points);
          ctx.beginPath();
          ctx.arc(x, y, 3.5, 0, 7);
          ctx.fillStyle = colours.text;
          ctx.fill();
          if (label) text(label.length > 32 ? `${label.slice(0, 31)}\u2026` : label, [x + 8, y], colours.text, 'left');
        }
    if (this.index >= 0 && this.shape) {
      const [x, y] = view.project(...floats(this.shape.position).subarray(3 * this.index, 3 * this.index + 3));
      ctx.beginPath();
      ctx.arc(x, y, 6, 0, 7);
      ctx.lineWidth = 4;
      ctx.strokeStyle = background;
      ctx.stroke();
      ctx.lineWidth = 2;
      ctx.strokeStyle = colours.text;
      ctx.stroke();
    }
  }

  // quantiles of every field of every shape
  statistics() {
    const rows = this.scene.shapes.flatMap(shape => shape.fields.map(field => ({shape, field})));
    const q = p => rows.map(({field}) => (field.quantiles === undefined ? null : quantile(field, p)));
    const column = (label, numbers) => ({label, unit: '', numbers});
    const figure = tableFigure(
      {
        title: 'Values',
        note: null,
        rows: rows.length,
        columns: [
          ...(this.scene.shapes.length > 1 ? [{label: 'shape', unit: '', texts: rows.map(r => r.shape.name)}] : []),
          {label: 'field', unit: '', texts: rows.map(r => r.field.label)},
          {label: 'unit', unit: '', texts: rows.map(r => r.field.unit || '1')},
          column(
            'values',
            rows.map(r => r.field.count)
          ),
          column('lowest', q(0)),
          column('1 %', q(0.01)),
          column('median', q(0.5)),
          column('99 %', q(0.99)),
          column('highest', q(1))
        ]
      },
      true
    );
    for (const shape of this.scene.shapes)
      if (shape.count < shape.total)
        figure.append(
          element(
            'p',
            {className: 'note'},
            `${shape.name}: the view shows ${number(shape.count)} of ${number(shape.total)} points; ` +
              'the values count all of them.' +
              (shape.triangle_total && !given(shape.triangle_array)
                ? ' Its triangles are too many for a page, so it is shown as points.'
                : '')
          )
        );
    return figure;
  }
}
