// Where WebGL is missing: the shape from above, drawn on a plain canvas. The same calls as a View, but nothing turns.
import {colourOf, css, palette} from './colour.js';

const TABLE = 512;
const hex = number => `#${number.toString(16).padStart(6, '0')}`;

export class Plan {
  constructor(canvas) {
    this.canvas = canvas;
    this.lines = new Map();
    this.scale = null;
  }

  setShape(shape) {
    this.shape = shape;
    const {position} = shape;
    this.low = [Infinity, Infinity];
    this.high = [-Infinity, -Infinity];
    for (let i = 0; i < position.length; i += 3)
      for (let k = 0; k < 2; k++) {
        this.low[k] = Math.min(this.low[k], position[i + k]);
        this.high[k] = Math.max(this.high[k], position[i + k]);
      }
  }

  setValues(values) {
    this.values = values;
  }
  setScale(scale) {
    this.scale = scale;
    this.draw();
  }
  setShade() {}
  setLines(group, lines, colour) {
    this.lines.set(group, {lines, colour, shown: true});
  }
  clearLines(group) {
    this.lines.delete(group);
  }
  showLines(group, shown) {
    if (this.lines.has(group)) this.lines.get(group).shown = shown;
    this.draw();
  }
  home() {
    this.draw();
  }
  turn() {}
  zoom() {}
  pan() {}

  resize() {
    const ratio = Math.min(devicePixelRatio, 2);
    this.canvas.width = Math.round(this.canvas.clientWidth * ratio);
    this.canvas.height = Math.round(this.canvas.clientHeight * ratio);
    this.draw();
  }

  // x runs to the right, the feed direction y upward
  project(x, y) {
    const width = this.canvas.clientWidth,
      height = this.canvas.clientHeight,
      margin = 36;
    const size = [0, 1].map(k => Math.max(this.high[k] - this.low[k], 1e-9));
    const zoom = Math.min((width - 2 * margin) / size[0], (height - 2 * margin) / size[1]);
    return [
      width / 2 + (x - (this.low[0] + this.high[0]) / 2) * zoom,
      height / 2 - (y - (this.low[1] + this.high[1]) / 2) * zoom
    ];
  }

  draw() {
    const {canvas, shape, values, scale} = this,
      colours = palette();
    if (!scale || !canvas.width) return;
    const ctx = canvas.getContext('2d'),
      ratio = canvas.width / canvas.clientWidth;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.fillStyle = hex(colours.view);
    ctx.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    const table = Array.from({length: TABLE}, (_, i) =>
      css(colourOf(scale, scale.low + ((scale.high - scale.low) * i) / (TABLE - 1)))
    );
    const colour = v =>
      Number.isNaN(v)
        ? css(colours.missing)
        : table[
            Math.min(TABLE - 1, Math.max(0, Math.round(((v - scale.low) / (scale.high - scale.low)) * (TABLE - 1))))
          ];
    const at = i => this.project(shape.position[3 * i], shape.position[3 * i + 1]);
    if (shape.triangles)
      for (let t = 0; t < shape.triangles.length; t += 3) {
        const [a, b, c] = [at(shape.triangles[t]), at(shape.triangles[t + 1]), at(shape.triangles[t + 2])];
        ctx.fillStyle = ctx.strokeStyle = colour(values[shape.triangles[t]]);
        ctx.beginPath();
        ctx.moveTo(...a);
        ctx.lineTo(...b);
        ctx.lineTo(...c);
        ctx.closePath();
        ctx.fill();
        ctx.stroke();
      }
    else
      for (let i = 0; i < values.length; i++) {
        const [x, y] = at(i);
        ctx.fillStyle = colour(values[i]);
        ctx.fillRect(x - 1, y - 1, 2, 2);
      }
    for (const {lines, colour: name, shown} of this.lines.values()) {
      if (!shown) continue;
      ctx.strokeStyle = hex(colours[name === 'weak' ? 'line' : name]);
      ctx.globalAlpha = name === 'weak' ? 0.28 : 1;
      ctx.beginPath();
      for (const line of lines)
        for (let i = 0; i < line.length; i += 3) ctx[i ? 'lineTo' : 'moveTo'](...this.project(line[i], line[i + 1]));
      ctx.stroke();
      ctx.globalAlpha = 1;
    }
    this.drawn?.();
  }

  pick(x, y, reach = 14) {
    const {position} = this.shape;
    let best = -1,
      nearest = reach;
    for (let i = 0; i < position.length / 3; i++) {
      const [px, py] = this.project(position[3 * i], position[3 * i + 1]),
        away = Math.hypot(px - x, py - y);
      if (away < nearest) [best, nearest] = [i, away];
    }
    return best;
  }
}
