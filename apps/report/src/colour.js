// Colours: scales that keep their order for every kind of colour vision, and the page's palette in light and dark.

// viridis (van der Walt and Smith 2015), eleven stops
const VIRIDIS = '440154 482475 414487 355f8d 2a788e 21918c 22a884 44bf70 7ad151 bddf26 fde725'
  .split(' ')
  .map(hex => [0, 2, 4].map(i => parseInt(hex.slice(i, i + 2), 16)));

function viridis(t) {
  const s = Math.min(Math.max(t, 0), 1) * (VIRIDIS.length - 1),
    i = Math.min(Math.floor(s), VIRIDIS.length - 2);
  return [0, 1, 2].map(k => Math.round(VIRIDIS[i][k] + (s - i) * (VIRIDIS[i + 1][k] - VIRIDIS[i][k])));
}

// Oklab (Ottosson 2020) to sRGB bytes
function oklab(L, a, b) {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s
  ].map(x => {
    const c = Math.min(Math.max(x, 0), 1);
    return Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
  });
}

// blue below, orange above; lightness falls the same way on both sides
function diverging(t) {
  const size = Math.min(Math.abs(t), 1),
    hue = ((t < 0 ? 252 : 48) * Math.PI) / 180;
  const chroma = 0.145 * size ** 0.75;
  return oklab(0.91 - 0.48 * size, chroma * Math.cos(hue), chroma * Math.sin(hue));
}

const STEPS = 5;

// scale: {kind, low, high, tolerance, bands}; the colour of a value as [r, g, b]
export function colourOf(scale, value) {
  if (scale.kind === 'diverging') {
    const size = Math.abs(value);
    if (size <= scale.tolerance) return diverging(0);
    let t = (size - scale.tolerance) / Math.max(scale.high - scale.tolerance, 1e-30);
    if (scale.bands) t = Math.min(Math.ceil(t * STEPS), STEPS) / STEPS;
    // beyond the tolerance the colour begins with a step that can be seen
    if (scale.tolerance > 0) t = 0.18 + 0.82 * t;
    return diverging(Math.sign(value) * t);
  }
  let t = (value - scale.low) / Math.max(scale.high - scale.low, 1e-30);
  if (scale.bands) t = (Math.min(Math.max(Math.floor(t * 2 * STEPS), 0), 2 * STEPS - 1) + 0.5) / (2 * STEPS);
  return viridis(t);
}

export const css = rgb => `rgb(${rgb[0]},${rgb[1]},${rgb[2]})`;

export const LIGHT = {
  page: '#fbfbfa',
  text: '#1b1d1f',
  faint: '#5d6369',
  rule: '#dcdedf',
  grid: 'rgba(0,0,0,0.07)',
  span: 'rgba(0,0,0,0.035)',
  view: 0xffffff,
  line: 0x2b3035,
  outline: 0x8b9299,
  accent: 0xc2410c,
  missing: [158, 163, 168],
  series: ['#0b63a5', '#c2500a', '#0a7d5c', '#8e4a9e', '#5c5c5c', '#a07800', '#1b96b8', '#b03060']
};
export const DARK = {
  page: '#15171a',
  text: '#e6e7e6',
  faint: '#9aa1a8',
  rule: '#32363b',
  grid: 'rgba(255,255,255,0.08)',
  span: 'rgba(255,255,255,0.045)',
  view: 0x1d2024,
  line: 0xd4d8dc,
  outline: 0x767d85,
  accent: 0xffa55e,
  missing: [104, 109, 114],
  series: ['#62aee8', '#f0955a', '#3fc79d', '#cf94dc', '#b4b4b4', '#d9b13f', '#5fcfe8', '#ee86a8']
};

const dark = matchMedia('(prefers-color-scheme: dark)');
const watchers = [];
let printing = false;

export const palette = () => (dark.matches && !printing ? DARK : LIGHT);
export const onPalette = watcher => watchers.push(watcher);
const announce = () => watchers.forEach(watcher => watcher(printing));

dark.addEventListener('change', announce);
// paper is white: everything that was painted is painted again
addEventListener('beforeprint', () => {
  printing = true;
  announce();
});
addEventListener('afterprint', () => {
  printing = false;
  announce();
});
