// Numbers and elements: four significant digits, a true minus sign, text never parsed as markup.
const NARROW = '\u202f';

const group = digits => digits.replace(/\B(?=(\d{3})+(?!\d))/g, NARROW);

// a number with a fixed number of decimals
export function fixed(value, decimals) {
  if (value === null || Number.isNaN(value)) return '\u2013';
  const [whole, part] = Math.abs(value).toFixed(decimals).split('.');
  const sign = value < 0 && Number(`${whole}.${part ?? 0}`) !== 0 ? '\u2212' : '';
  return sign + (whole.length > 4 ? group(whole) : whole) + (part ? `.${part}` : '');
}

// decimals that show four significant digits of the largest of some numbers
export const decimals = largest => (largest > 0 ? Math.min(9, Math.max(0, 3 - Math.floor(Math.log10(largest)))) : 0);

const raised = '\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';
const power = exponent => `10${[...String(exponent)].map(c => raised['-0123456789'.indexOf(c)]).join('')}`;

// a number by itself: integers whole, others with four significant digits
export function number(value) {
  if (value === null || Number.isNaN(value)) return '\u2013';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) {
    const [mantissa, exponent] = value.toExponential(2).split('e');
    return `${mantissa.replace('-', '\u2212')}${NARROW}\u00b7${NARROW}${power(Number(exponent))}`;
  }
  if (Number.isInteger(value)) return fixed(value, 0);
  return fixed(value, decimals(size))
    .replace(/(\.\d*?)0+$/, '$1')
    .replace(/\.$/, '');
}

export const withUnit = (value, unit) => (unit ? `${number(value)}\u00a0${unit}` : number(value));
export const labelled = (label, unit) => (unit ? `${label} [${unit}]` : label);

// an element with properties and children; strings become text
export function element(name, properties, ...children) {
  const out = document.createElement(name);
  for (const [key, value] of Object.entries(properties ?? {})) {
    if (value === undefined || value === null) continue;
    if (key in out && key !== 'list') out[key] = value;
    else out.setAttribute(key, value);
  }
  out.append(...children.filter(child => child !== null && child !== undefined));
  return out;
}

// lowest and highest of the numbers that are there
export function extent(values) {
  let low = Infinity,
    high = -Infinity;
  for (const v of values) {
    if (v < low) low = v;
    if (v > high) high = v;
  }
  return low <= high ? [low, high] : null;
}
