// A field's numbers for the reader: quantiles of all values, shares, a scale to begin with, histogram with colour bar.
import {colourOf, css, onPalette, palette} from './colour.js';
import {floats} from './data.js';
import {element, number} from './text.js';

// the value below which a share p of all values lies
export function quantile(field, p) {
  const q = floats(field.quantiles),
    s = p * (q.length - 1),
    i = Math.min(Math.floor(s), q.length - 2);
  return q[i] + (s - i) * (q[i + 1] - q[i]);
}

// the share of all values that are at most v
export function shareBelow(field, v) {
  const q = floats(field.quantiles),
    n = q.length - 1;
  if (v < q[0]) return 0;
  if (v >= q[n]) return 1;
  let low = 0,
    high = n;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (q[middle] <= v) low = middle;
    else high = middle;
  }
  return (low + (v - q[low]) / (q[high] - q[low])) / n;
}

// a short number not below a number
function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  return (
    power * [1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 10].find(step => step * power >= value * (1 - 1e-9))
  );
}

// the scale that shows nearly all of a field
export function firstScale(field) {
  if (field.quantiles === undefined)
    return {kind: field.scale, low: field.scale === 'diverging' ? -1 : 0, high: 1, tolerance: 0};
  const low = quantile(field, 0.005),
    high = quantile(field, 0.995);
  if (field.scale === 'diverging') {
    const limit = roundUp(Math.max(Math.abs(low), Math.abs(high), 1.5 * field.tolerance));
    return {kind: 'diverging', low: -limit, high: limit, tolerance: field.tolerance};
  }
  if (low >= 0 && low < 0.25 * high) return {kind: 'sequential', low: 0, high: roundUp(high)};
  const step = roundUp((high - low) / 20 || Math.abs(high) / 20 || 1);
  return {kind: 'sequential', low: Math.floor(low / step) * step, high: Math.ceil(high / step + 1e-9) * step};
}

// what the colours say in words
export function sentence(field, scale) {
  if (field.quantiles === undefined) return 'No value was measured.';
  const percent = p => `${(100 * p).toFixed(1)}\u00a0%`;
  const all = `${number(field.count)} values`;
  if (scale.kind === 'diverging' && scale.tolerance > 0) {
    const under = shareBelow(field, -scale.tolerance),
      over = 1 - shareBelow(field, scale.tolerance);
    return (
      `Of ${all}, ${percent(1 - under - over)} lie within \u00b1${number(scale.tolerance)} ${field.unit}, ` +
      `${percent(over)} above, ${percent(under)} below.`
    );
  }
  return (
    `Of ${all}, half lie between ${number(quantile(field, 0.25))} and ` +
    `${number(quantile(field, 0.75))} ${field.unit}; ` +
    `lowest ${number(quantile(field, 0))}, highest ${number(quantile(field, 1))} ${field.unit}.`
  );
}

const BINS = 64;

function ticks(low, high, most) {
  const rough = (high - low) / most,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(s => s * power >= rough),
    out = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + step * 1e-9; i++) out.push(i * step);
  return out;
}

// the histogram of a field above its colour bar
export class Histogram {
  constructor() {
    this.canvas = element('canvas', {className: 'histogram', role: 'img'});
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    onPalette(() => this.paint());
  }

  show(field, scale) {
    this.field = field;
    this.scale = scale;
    this.canvas.setAttribute('aria-label', `Histogram of ${field.label}. ${sentence(field, scale)}`);
    this.paint();
  }

  paint() {
    const {canvas, field, scale} = this,
      width = canvas.clientWidth,
      height = canvas.clientHeight;
    if (!field || !width) return;
    const ratio = Math.min(devicePixelRatio, 2),
      ctx = canvas.getContext('2d'),
      colours = palette();
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    ctx.scale(ratio, ratio);
    const left = 8,
      right = width - 8,
      top = 4,
      bar = height - 42,
      thick = 10;
    const span = scale.high - scale.low,
      at = v => left + ((v - scale.low) / span) * (right - left);
    this.paintBars(ctx, left, right, top, bar - 3);
    for (let x = left; x < right; x++) {
      ctx.fillStyle = css(colourOf(scale, scale.low + ((x + 0.5 - left) / (right - left)) * span));
      ctx.fillRect(x, bar, 1, thick);
    }
    ctx.fillStyle = ctx.strokeStyle = colours.faint;
    ctx.font = '12px system-ui, sans-serif';
    ctx.textAlign = 'center';
    ctx.textBaseline = 'top';
    for (const v of ticks(scale.low, scale.high, Math.max(2, Math.floor(width / 90)))) {
      ctx.fillRect(at(v) - 0.5, bar + thick, 1, 4);
      ctx.textAlign = at(v) < left + 16 ? 'left' : at(v) > right - 16 ? 'right' : 'center';
      ctx.fillText(number(Number(v.toPrecision(10))), at(v), bar + thick + 6);
    }
    if (scale.kind === 'diverging' && scale.tolerance > 0 && scale.tolerance < scale.high) {
      ctx.setLineDash([3, 3]);
      for (const v of [-scale.tolerance, scale.tolerance]) {
        ctx.beginPath();
        ctx.moveTo(at(v), top);
        ctx.lineTo(at(v), bar + thick);
        ctx.stroke();
      }
    }
  }

  paintBars(ctx, left, right, top, bottom) {
    const {field, scale} = this,
      step = (scale.high - scale.low) / BINS,
      share = [];
    if (field.quantiles === undefined) return;
    for (let i = 0; i < BINS; i++)
      share.push(
        shareBelow(field, scale.low + (i + 1) * step) -
          (i ? shareBelow(field, scale.low + i * step) : shareBelow(field, scale.low - 1e-12 * step))
      );
    const most = Math.max(...share, 1e-12),
      wide = (right - left) / BINS;
    share.forEach((s, i) => {
      const tall = s > 0 ? Math.max(1, (s / most) * (bottom - top)) : 0;
      ctx.fillStyle = css(colourOf(scale, scale.low + (i + 0.5) * step));
      ctx.fillRect(left + i * wide, bottom - tall, Math.max(wide - 1, 1), tall);
      if (tall < 4) return;
      // pale colours on a pale page still have an upper edge
      ctx.fillStyle = palette().faint;
      ctx.fillRect(left + i * wide, bottom - tall, Math.max(wide - 1, 1), 0.75);
    });
  }
}
