// The cases of a study: parallel coordinates with brushes, a scatter of any two columns, the best cases with pictures.
import {colourOf, css, onPalette, palette} from './colour.js';
import {doubles, floats, given, ints} from './data.js';
import {element, extent, labelled, number} from './text.js';

const TOP = 34; // room for an axis' name and its highest value
const FOOT = 20;
const FONT = '12px system-ui, sans-serif';
const LISTED = 20; // of the cases of a study; of the parts of a whole all but the largest
const LISTED_PARTS = 1000;

// a column as positions in [0, 1] on its axis, with the values at its ends; words get places of their own
function axisOf(column) {
  if (column.numbers !== undefined) {
    const value = doubles(column.numbers);
    const [low, high] = extent(value) ?? [0, 1];
    const span = high - low || 1;
    const at = v => (high > low ? (v - low) / span : 0.5);
    return {column, value, at, low, high, show: r => number(value[r]), ends: [number(low), number(high)]};
  }
  const words = [...new Set(column.texts.filter(text => text !== null))].sort();
  const value = Float64Array.from(column.texts, text => (text === null ? NaN : words.indexOf(text)));
  const at = v => (words.length > 1 ? v / (words.length - 1) : 0.5);
  return {column, value, at, words, low: 0, high: words.length - 1, show: r => column.texts[r] ?? '\u2013', ends: []};
}

// a canvas that is as sharp as the screen and as wide as its place; paint(context, width, height)
function sheet(height, label, paint) {
  const canvas = element('canvas', {className: 'sheet', role: 'img', 'aria-label': label});
  canvas.style.height = `${height}px`;
  const draw = () => {
    const width = canvas.clientWidth,
      ratio = devicePixelRatio;
    if (width < 1) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext('2d');
    context.scale(ratio, ratio);
    context.font = FONT;
    paint(context, width, height);
  };
  new ResizeObserver(draw).observe(canvas);
  onPalette(draw);
  return {canvas, draw};
}

// a text that is cut to a width
function shorten(context, text, room) {
  if (context.measureText(text).width <= room) return text;
  let kept = text;
  while (kept.length > 1 && context.measureText(`\u2026${kept}`).width > room) kept = kept.slice(1);
  return `\u2026${kept}`;
}

// a small picture of a mesh, seen from above and in front: nearer triangles last, lighter where they face the light
function picture(shape) {
  const position = floats(shape.position),
    triangles = given(shape.triangle_array) ? ints(shape.triangle_array) : new Int32Array(0);
  const count = position.length / 3,
    x = new Float64Array(count),
    y = new Float64Array(count),
    depth = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const [a, b, c] = position.subarray(3 * i, 3 * i + 3);
    const [u, v] = [0.8 * a - 0.6 * b, 0.6 * a + 0.8 * b];
    x[i] = u;
    y[i] = -0.5 * v - 0.866 * c;
    depth[i] = 0.866 * v - 0.5 * c;
  }
  const [left, right] = extent(x) ?? [0, 1],
    [top, bottom] = extent(y) ?? [0, 1];
  const heights = Array.from(
    triangles.filter((_, k) => k % 3 === 0),
    i => position[3 * i + 2]
  );
  const [low, high] = extent(heights) ?? [0, 1];
  const order = Array.from({length: triangles.length / 3}, (_, t) => t).sort(
    (s, t) => depth[triangles[3 * t]] - depth[triangles[3 * s]]
  );
  return sheet(150, `${shape.name} seen from above`, (context, width, height) => {
    const scale = 0.94 * Math.min(width / (right - left || 1), height / (bottom - top || 1));
    const px = i => width / 2 + (x[i] - (left + right) / 2) * scale,
      py = i => height / 2 + (y[i] - (top + bottom) / 2) * scale;
    for (const t of order) {
      const [a, b, c] = triangles.subarray(3 * t, 3 * t + 3);
      context.fillStyle = css(colourOf({kind: 'sequential', low, high}, position[3 * a + 2]));
      context.strokeStyle = context.fillStyle;
      context.lineWidth = 0.5;
      context.beginPath();
      context.moveTo(px(a), py(a));
      context.lineTo(px(b), py(b));
      context.lineTo(px(c), py(c));
      context.closePath();
      context.fill();
      context.stroke();
    }
  });
}

export class Cases {
  constructor(cases, scene) {
    this.cases = cases;
    this.axes = cases.columns.map(axisOf);
    this.number = ints(cases.number);
    this.brush = this.axes.map(() => null);
    this.on = new Uint8Array(cases.rows).fill(1);
    this.goal = cases.goal < 0 ? this.axes.findIndex(axis => !axis.words) : cases.goal;
    this.sign = cases.highest ? -1 : 1; // of the order in the list
    if (this.goal < 0) this.goal = 0;
    const names = cases.columns.map(column => column.label);
    this.parallel = sheet(
      320,
      `Parallel coordinates of ${cases.rows} ${cases.called}s over ${names.join(', ')}.`,
      (...a) => this.paintParallel(...a)
    );
    // a narrow screen scrolls along the axes
    this.parallel.canvas.style.minWidth = `${72 * this.axes.length}px`;
    this.scatter = sheet(320, `Scatter of the ${cases.called}s over two columns.`, (...a) => this.paintScatter(...a));
    this.count = element('p', {className: 'note share', 'aria-live': 'polite'});
    this.list = element('div', {
      className: 'scroll',
      tabIndex: 0,
      role: 'region',
      'aria-label': `Selected ${cases.called}s`
    });
    this.pick = element(
      'p',
      {className: 'note share', 'aria-live': 'polite'},
      `Click a point to see its ${cases.called}.`
    );
    const numeric = this.axes.map((axis, i) => (axis.words ? -1 : i)).filter(i => i >= 0);
    this.x = numeric[0] ?? 0;
    this.y = this.axes[this.goal].words ? (numeric[1] ?? this.x) : this.goal;
    this.pictures = scene ? scene.shapes.slice(0, cases.best.length).map(picture) : [];
    this.figure = element('div', {className: 'cases'}, this.brushPart(), this.scatterPart(), this.bestPart());
  }

  start() {
    this.refresh();
    this.pictures.forEach(one => one.draw());
  }

  chooser(label, chosen, change) {
    const select = element('select', {});
    this.axes.forEach((axis, i) =>
      select.append(
        element('option', {value: i, selected: i === chosen}, labelled(axis.column.label, axis.column.unit))
      )
    );
    select.addEventListener('change', () => change(Number(select.value)));
    return element('label', {}, `${label} `, select);
  }

  link(r, text = `${this.cases.called} ${this.number[r]}`) {
    const href = this.cases.links[r];
    return href ? element('a', {href}, text) : text;
  }

  // ---- parallel coordinates ----

  brushPart() {
    const clear = element('button', {type: 'button'}, 'Clear brushes');
    clear.addEventListener('click', () => {
      this.brush.fill(null);
      this.refresh();
    });
    this.steerBrush();
    this.goalChooser = this.chooser('Colour and order by', this.goal, i => {
      this.goal = i;
      this.sign = this.cases.highest && i === this.cases.goal ? -1 : 1;
      this.refresh();
    });
    return element(
      'figure',
      {className: 'chart'},
      element('figcaption', {}, element('h3', {}, 'Parallel coordinates')),
      element('div', {className: 'controls'}, this.goalChooser, clear),
      element('div', {className: 'scroll'}, this.parallel.canvas),
      element(
        'p',
        {className: 'note hint'},
        `Drag along an axis to select ${this.cases.called}s; click it to take the selection away.`
      ),
      this.brushTable(),
      this.count,
      this.list
    );
  }

  // the same by keyboard: a lowest and a highest value for each axis of numbers
  brushTable() {
    this.entries = [];
    const rows = this.axes.map((axis, i) => {
      if (axis.words) return null;
      const entry = side => {
        const input = element('input', {type: 'number', step: 'any', 'aria-label': `${axis.column.label} ${side}`});
        input.addEventListener('change', () => {
          const [low, high] = this.entries[i].map(e => (e.value === '' ? null : e.valueAsNumber));
          this.brush[i] = low === null && high === null ? null : [low ?? axis.low, high ?? axis.high];
          this.refresh();
        });
        return input;
      };
      this.entries[i] = [entry('from'), entry('to')];
      return element(
        'tr',
        {},
        element('td', {}, labelled(axis.column.label, axis.column.unit)),
        ...this.entries[i].map(e => element('td', {}, e))
      );
    });
    return element(
      'details',
      {className: 'numbers'},
      element('summary', {}, 'Select by numbers'),
      element('div', {className: 'scroll'}, element('table', {}, element('tbody', {}, ...rows)))
    );
  }

  axisX(i, width) {
    const side = Math.min(60, width / 10);
    return this.axes.length > 1 ? side + (i * (width - 2 * side)) / (this.axes.length - 1) : width / 2;
  }

  steerBrush() {
    const {canvas} = this.parallel;
    let held = null;
    const place = event => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const valueAt = (axis, y) => {
      const t = Math.min(1, Math.max(0, 1 - (y - TOP) / (canvas.clientHeight - TOP - FOOT)));
      return axis.low + t * (axis.high - axis.low);
    };
    canvas.addEventListener('pointerdown', event => {
      const [x, y] = place(event);
      const gaps = this.axes.map((_, i) => Math.abs(this.axisX(i, canvas.clientWidth) - x));
      const i = gaps.indexOf(Math.min(...gaps));
      if (gaps[i] > 24) return;
      held = {i, y, from: valueAt(this.axes[i], y)};
      canvas.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    canvas.addEventListener('pointermove', event => {
      if (!held) return;
      const [, y] = place(event);
      if (Math.abs(y - held.y) < 3) return;
      const to = valueAt(this.axes[held.i], y);
      this.brush[held.i] = [Math.min(held.from, to), Math.max(held.from, to)];
      held.moved = true;
      this.refresh();
    });
    canvas.addEventListener('pointerup', () => {
      if (held && !held.moved) {
        this.brush[held.i] = null;
        this.refresh();
      }
      held = null;
    });
    canvas.addEventListener('pointercancel', () => {
      held = null;
    });
  }

  refresh() {
    const half = this.axes.map(axis => (axis.words ? 0.5 : 1e-9 * (axis.high - axis.low)));
    for (let r = 0; r < this.cases.rows; r++)
      this.on[r] = this.brush.every((range, i) => {
        const v = this.axes[i].value[r];
        return !range || (v >= range[0] - half[i] && v <= range[1] + half[i]);
      })
        ? 1
        : 0;
    const chosen = this.on.reduce((n, v) => n + v, 0);
    this.count.textContent = `${number(chosen)} of ${number(this.cases.rows)} ${this.cases.called}s are selected.`;
    this.entries.forEach((pair, i) => {
      const range = this.brush[i];
      pair?.forEach((entry, k) => {
        if (document.activeElement !== entry) entry.value = range ? Number(range[k].toPrecision(6)) : '';
      });
    });
    this.fillList();
    this.parallel.draw();
    this.scatter.draw();
  }

  colour(r) {
    const axis = this.axes[this.goal],
      v = axis.value[r];
    return Number.isNaN(v)
      ? css(palette().missing)
      : css(colourOf({kind: 'sequential', low: 0, high: 1}, 0.92 * axis.at(v)));
  }

  paintParallel(context, width, height) {
    const y = t => TOP + (1 - t) * (height - TOP - FOOT);
    const line = r => {
      context.beginPath();
      let drawn = false;
      this.axes.forEach((axis, i) => {
        const v = axis.value[r];
        if (Number.isNaN(v)) {
          drawn = false;
          return;
        }
        if (drawn) context.lineTo(this.axisX(i, width), y(axis.at(v)));
        else context.moveTo(this.axisX(i, width), y(axis.at(v)));
        drawn = true;
      });
      context.stroke();
    };
    // those that are not selected lie behind
    context.lineWidth = 1;
    context.strokeStyle = palette().grid;
    for (let r = 0; r < this.cases.rows; r++) if (!this.on[r]) line(r);
    context.globalAlpha = Math.max(0.08, Math.min(0.9, 60 / this.cases.rows + 0.1));
    for (let r = 0; r < this.cases.rows; r++)
      if (this.on[r]) {
        context.strokeStyle = this.colour(r);
        line(r);
      }
    context.globalAlpha = 1;
    this.axes.forEach((axis, i) => this.paintAxis(context, axis, i, width, height, y));
  }

  paintAxis(context, axis, i, width, height, y) {
    const x = this.axisX(i, width),
      room = (width - 12) / this.axes.length - 4;
    context.strokeStyle = palette().faint;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, y(1));
    context.lineTo(x, y(0));
    context.stroke();
    const range = this.brush[i];
    if (range) {
      context.fillStyle = `${palette().series[1]}88`;
      const [a, b] = range.map(v => y((v - axis.low) / (axis.high - axis.low || 1)));
      context.fillRect(x - 6, Math.min(a, b) - 1, 12, Math.abs(a - b) + 2);
    }
    context.textAlign = 'center';
    context.textBaseline = 'alphabetic';
    context.fillStyle = palette().text;
    context.fillText(shorten(context, axis.column.label, room), x, 13);
    context.fillStyle = palette().faint;
    if (!axis.words) {
      context.fillText(shorten(context, axis.ends[1], room), x, TOP - 6);
      context.fillText(shorten(context, axis.ends[0], room), x, height - 6);
      return;
    }
    // words stand at their places, beside the axis
    context.textAlign = x > width / 2 ? 'right' : 'left';
    axis.words.slice(0, 12).forEach((word, k) => {
      const text = shorten(context, word, Math.max(room, 70)),
        at = y(axis.at(k)) + 4,
        to = x + (x > width / 2 ? -8 : 8),
        wide = context.measureText(text).width;
      context.fillStyle = palette().page;
      context.fillRect(x > width / 2 ? to - wide - 2 : to - 2, at - 11, wide + 4, 14);
      context.fillStyle = palette().text;
      context.fillText(text, to, at);
    });
  }

  orderBy(i) {
    if (i === this.goal) this.sign = -this.sign;
    else [this.goal, this.sign] = [i, 1];
    this.goalChooser.querySelector('select').value = String(i);
    this.refresh();
  }

  // what is known of a row, for who picked it in space
  about(r) {
    if (!(r >= 0 && r < this.cases.rows)) return [];
    const words = this.axes.map(axis => `${labelled(axis.column.label, axis.column.unit)} ${axis.show(r)}`).join(', ');
    return [this.link(r), `: ${words}`];
  }

  fillList() {
    const rows = Array.from({length: this.cases.rows}, (_, r) => r).filter(r => this.on[r]);
    const {value} = this.axes[this.goal];
    const key = r => (Number.isNaN(value[r]) ? Infinity : this.sign * value[r]);
    rows.sort((a, b) => key(a) - key(b) || a - b);
    const head = element('tr', {}, element('th', {scope: 'col'}, this.cases.called));
    this.axes.forEach((axis, i) => {
      // a click orders by the column, another one turns the order
      const own = i === this.goal;
      const button = element(
        'button',
        {type: 'button', className: 'sort'},
        labelled(axis.column.label, axis.column.unit) + (own ? (this.sign > 0 ? ' \u25b2' : ' \u25bc') : '')
      );
      button.addEventListener('click', () => this.orderBy(i));
      head.append(
        element(
          'th',
          {
            scope: 'col',
            className: axis.words ? '' : 'number',
            'aria-sort': own ? (this.sign > 0 ? 'ascending' : 'descending') : 'none'
          },
          button
        )
      );
    });
    const body = element('tbody');
    const listed = this.cases.called === 'case' ? LISTED : LISTED_PARTS;
    for (const r of rows.slice(0, listed))
      body.append(
        element(
          'tr',
          {},
          element('td', {}, this.link(r, String(this.number[r]))),
          ...this.axes.map(axis => element('td', {className: axis.words ? '' : 'number'}, axis.show(r)))
        )
      );
    this.list.replaceChildren(
      element('table', {}, element('thead', {}, head), body),
      rows.length > listed ? element('p', {className: 'note'}, `The first ${listed} of ${number(rows.length)}.`) : ''
    );
  }

  // ---- scatter ----

  scatterPart() {
    this.scatter.canvas.addEventListener('click', event => this.pickPoint(event));
    const controls = element(
      'div',
      {className: 'controls'},
      this.chooser('Across', this.x, i => {
        this.x = i;
        this.scatter.draw();
      }),
      this.chooser('up', this.y, i => {
        this.y = i;
        this.scatter.draw();
      })
    );
    return element(
      'figure',
      {className: 'chart'},
      element('figcaption', {}, element('h3', {}, 'Any two columns')),
      controls,
      this.scatter.canvas,
      this.pick
    );
  }

  pointPlace(r, width, height) {
    const [a, b] = [this.axes[this.x], this.axes[this.y]];
    return [70 + a.at(a.value[r]) * (width - 100), height - 46 - b.at(b.value[r]) * (height - 66)];
  }

  paintScatter(context, width, height) {
    const [a, b] = [this.axes[this.x], this.axes[this.y]];
    context.strokeStyle = palette().faint;
    context.beginPath();
    context.moveTo(60, 14);
    context.lineTo(60, height - 36);
    context.lineTo(width - 20, height - 36);
    context.stroke();
    for (const selected of [0, 1])
      for (let r = 0; r < this.cases.rows; r++) {
        if (this.on[r] !== selected || Number.isNaN(a.value[r]) || Number.isNaN(b.value[r])) continue;
        const [x, y] = this.pointPlace(r, width, height);
        context.fillStyle = selected ? this.colour(r) : palette().grid;
        context.beginPath();
        context.arc(x, y, 3.5, 0, 2 * Math.PI);
        context.fill();
      }
    // what the ends of both axes are
    context.fillStyle = palette().faint;
    context.textBaseline = 'alphabetic';
    const ends = axis => (axis.words ? [axis.words[0] ?? '', axis.words[axis.words.length - 1] ?? ''] : axis.ends);
    context.textAlign = 'left';
    context.fillText(shorten(context, ends(a)[0], 90), 60, height - 20);
    context.textAlign = 'right';
    context.fillText(shorten(context, ends(a)[1], 90), width - 20, height - 20);
    context.fillText(shorten(context, ends(b)[0], 54), 56, height - 40);
    context.fillText(shorten(context, ends(b)[1], 54), 56, 22);
    context.fillStyle = palette().text;
    context.textAlign = 'center';
    context.fillText(
      shorten(context, labelled(a.column.label, a.column.unit), width - 260),
      (40 + width) / 2,
      height - 6
    );
    context.save();
    context.translate(12, (height - 30) / 2);
    context.rotate(-Math.PI / 2);
    context.fillText(shorten(context, labelled(b.column.label, b.column.unit), height - 60), 0, 0);
    context.restore();
    this.scatter.canvas.setAttribute(
      'aria-label',
      `Scatter of ${b.column.label} over ${a.column.label}; the table of selected cases holds the numbers.`
    );
  }

  pickPoint(event) {
    const {canvas} = this.scatter,
      box = canvas.getBoundingClientRect();
    let best = -1,
      least = 400;
    for (let r = 0; r < this.cases.rows; r++) {
      const [x, y] = this.pointPlace(r, canvas.clientWidth, canvas.clientHeight);
      const gap = (x - event.clientX + box.left) ** 2 + (y - event.clientY + box.top) ** 2 - (this.on[r] ? 0.5 : 0);
      if (gap < least) [best, least] = [r, gap];
    }
    if (best < 0) return;
    const words = this.axes.map(axis => `${axis.column.label} ${axis.show(best)}`).join(', ');
    this.pick.replaceChildren(this.link(best), `: ${words}`);
  }

  // ---- the best ----

  bestPart() {
    const {best, goal, highest} = this.cases;
    if (goal < 0 || best.length === 0) return null;
    const {column, show} = this.axes[goal];
    return element(
      'figure',
      {className: 'chart'},
      element('figcaption', {}, element('h3', {}, `Best cases: ${highest ? 'highest' : 'lowest'} ${column.label}`)),
      element(
        'ol',
        {className: 'best'},
        ...best.map((r, i) =>
          element(
            'li',
            {},
            this.pictures[i]?.canvas,
            element('strong', {}, this.link(r)),
            ` ${show(r)}${column.unit ? `\u00a0${column.unit}` : ''}`,
            element(
              'p',
              {className: 'note'},
              this.axes
                .slice(0, this.cases.parameters)
                .map(axis => `${axis.column.label.split('/').pop()} ${axis.show(r)}`)
                .join(', ')
            )
          )
        )
      ),
      this.pictures.length
        ? null
        : element(
            'p',
            {className: 'note'},
            'No mesh stands among the results of the best cases, so they have no pictures.'
          )
    );
  }
}
