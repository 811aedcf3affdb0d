// SPDX-License-Identifier: MIT
// Numbers as people write and read them.

/** @type {Record<string, number>} */
const constants = { pi: Math.PI, "π": Math.PI, e: Math.E, phi: (1 + Math.sqrt(5)) / 2, "φ": (1 + Math.sqrt(5)) / 2 };

/** Whole degrees, of which sines and cosines are exact where they are rational; NaN for other angles.
 * @param {number} radians */
function wholeDegrees(radians) {
  const degrees = (radians * 180) / Math.PI;
  const whole = Math.round(degrees);
  return Math.abs(degrees - whole) <= 1e-13 * Math.max(1, Math.abs(degrees)) ? whole : NaN;
}

/** @param {number} x */
function sine(x) {
  const degrees = wholeDegrees(x);
  if (degrees % 180 === 0) return 0;
  if (Math.abs(degrees % 180) === 30 || Math.abs(degrees % 180) === 150) return Math.sign(Math.sin(x)) / 2;
  return Math.sin(x);
}

/** @param {number} x */
function cosine(x) {
  const degrees = wholeDegrees(x);
  if (Math.abs(degrees % 180) === 90) return 0;
  if (Math.abs(degrees % 180) === 60 || Math.abs(degrees % 180) === 120) return Math.sign(Math.cos(x)) / 2;
  return Math.cos(x);
}

/** @type {Record<string, (...values: number[]) => number>} */
const functions = {
  sin: sine, cos: cosine, tan: (x) => sine(x) / cosine(x), asin: Math.asin, acos: Math.acos, atan: Math.atan,
  atan2: Math.atan2, sinh: Math.sinh, cosh: Math.cosh, tanh: Math.tanh, sqrt: Math.sqrt, cbrt: Math.cbrt,
  exp: Math.exp, ln: Math.log, log: Math.log10, log2: Math.log2, abs: Math.abs, min: Math.min, max: Math.max,
};
const arguments2 = new Set(["atan2", "min", "max"]);
const longest = 200; // characters of an expression

/** The value of an expression such as 1/2, sqrt(3)/6, cos(36°) or 3^2, as in the table of the program.
 * null where there is none or it is not finite.
 * @param {string} text
 * @returns {number | null} */
export function evaluate(text) {
  if (text.length > longest) return null;
  const tokens = text.toLowerCase().replaceAll("−", "-").replaceAll("·", "*")
    .match(/\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?|[a-zπφ]+\d?|[-+*/^(),°]|\S/g) ?? [];
  let at = 0;
  /** @param {string} token */
  const take = (token) => tokens[at] === token && ++at > 0;
  /** @returns {number} */
  const sum = () => {
    let value = product();
    for (;;) {
      if (take("+")) value += product();
      else if (take("-")) value -= product();
      else return value;
    }
  };
  /** @returns {number} */
  const product = () => {
    let value = signed();
    for (;;) {
      if (take("*")) value *= signed();
      else if (take("/")) value /= signed();
      else return value;
    }
  };
  /** @returns {number} */
  const signed = () => (take("-") ? -signed() : take("+") ? signed() : power());
  /** @returns {number} */
  const power = () => {
    const base = postfix();
    return take("^") ? base ** signed() : base;
  };
  const postfix = () => {
    let value = primary();
    while (take("°")) value *= Math.PI / 180;
    return value;
  };
  /** @returns {number} */
  const primary = () => {
    const token = tokens[at++] ?? "";
    if (token === "(") {
      const value = sum();
      return take(")") ? value : NaN;
    }
    if (/^[\d.]/.test(token)) return Number(token);
    if (Object.hasOwn(constants, token)) return constants[token];
    if (!Object.hasOwn(functions, token) || !take("(")) return NaN;
    const values = [sum()];
    while (take(",")) values.push(sum());
    if (!take(")") || values.length !== (arguments2.has(token) ? 2 : 1)) return NaN;
    return functions[token](...values);
  };
  const value = sum();
  return at === tokens.length && Number.isFinite(value) ? value : null;
}

/** Short, for people: at most four decimals.
 * @param {number} value
 * @param {string} language */
export function readable(value, language) {
  return new Intl.NumberFormat(language, { maximumFractionDigits: 4, maximumSignificantDigits: 6 }).format(
    Math.abs(value) < 5e-5 ? 0 : value);
}
