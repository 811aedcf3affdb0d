// SPDX-License-Identifier: MIT
// Numbers as people write and read them.

/** @type {Record<string, number>} */
const constants = { pi: Math.PI, "π": Math.PI, e: Math.E, phi: (1 + Math.sqrt(5)) / 2, "φ": (1 + Math.sqrt(5)) / 2 };

/** Exact where a whole number of degrees has a rational sine. @param {number} x */
function sine(x) {
  const degrees = (x * 180) / Math.PI, whole = Math.round(degrees);
  const isWhole = Math.abs(degrees - whole) <= 1e-13 * Math.max(1, Math.abs(degrees));
  const place = isWhole ? Math.abs(whole % 180) : NaN;
  if (place === 0) return 0;
  return place === 30 || place === 150 ? Math.sign(Math.sin(x)) / 2 : Math.sin(x);
}

/** Exact where the cosine is rational. @param {number} x */
function cosine(x) {
  const exact = sine(x + Math.PI / 2);
  return [0, 0.5, -0.5].includes(exact) ? exact : Math.cos(x);
}

/** @type {Record<string, (...values: number[]) => number>} */
const functions = {
  sin: sine, cos: cosine, tan: (x) => sine(x) / cosine(x), asin: Math.asin, acos: Math.acos, atan: Math.atan,
  atan2: Math.atan2, sinh: Math.sinh, cosh: Math.cosh, tanh: Math.tanh, sqrt: Math.sqrt, cbrt: Math.cbrt,
  exp: Math.exp, ln: Math.log, log: Math.log10, log2: Math.log2, abs: Math.abs, min: Math.min, max: Math.max,
};
const withTwoArguments = new Set(["atan2", "min", "max"]);
/** How tightly an operator binds; “^” is right-associative, the others are not.
 * @type {Record<string, {rank: number, right: number, of: (a: number, b: number) => number}>} */
const operators = {
  "+": { rank: 1, right: 2, of: (a, b) => a + b }, "-": { rank: 1, right: 2, of: (a, b) => a - b },
  "*": { rank: 2, right: 3, of: (a, b) => a * b }, "/": { rank: 2, right: 3, of: (a, b) => a / b },
  "^": { rank: 4, right: 4, of: (a, b) => a ** b },
};
const signRank = 3; // -2^2 is -(2^2)
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
  /** @param {number} rank the least one of operators that are read @returns {number} */
  const read = (rank) => {
    let value = take("-") ? -read(signRank) : take("+") ? read(signRank) : inDegrees();
    for (let operator = operators[tokens[at]]; operator?.rank >= rank; operator = operators[tokens[at]]) {
      ++at;
      value = operator.of(value, read(operator.right));
    }
    return value;
  };
  const inDegrees = () => {
    let value = primary();
    while (take("°")) value *= Math.PI / 180;
    return value;
  };
  /** @returns {number} */
  const primary = () => {
    const token = tokens[at++] ?? "";
    if (/^[\d.]/.test(token)) return Number(token);
    if (Object.hasOwn(constants, token)) return constants[token];
    const of = Object.hasOwn(functions, token) ? functions[token] : undefined;
    if (of ? !take("(") : token !== "(") return NaN;
    const values = [read(1)];
    while (of && take(",")) values.push(read(1));
    if (!take(")") || values.length !== (withTwoArguments.has(token) ? 2 : 1)) return NaN;
    return of ? of(...values) : values[0];
  };
  const value = read(1);
  return at === tokens.length && Number.isFinite(value) ? value : null;
}

/** Short, for people: at most four decimals.
 * @param {number} value
 * @param {string} language */
export function readable(value, language) {
  return new Intl.NumberFormat(language, { maximumFractionDigits: 4, maximumSignificantDigits: 6 }).format(
    Math.abs(value) < 5e-5 ? 0 : value);
}
