// SPDX-License-Identifier: MIT
// Elements of the page. Text is set as text, never as markup.

/** @param {string} id @returns {HTMLElement} */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no ${id}`);
  return found;
}

/** @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name @param {Record<string, string>} attributes @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Name]} */
export function element(name, attributes = {}, children = []) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name @param {Record<string, string>} attributes
 * @returns {SVGElementTagNameMap[Name]} */
export function shape(name, attributes = {}) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

/** Red, green, blue and perhaps alpha up to 255, for a style sheet. @param {number[]} colour */
export function coloured([red, green, blue, alpha = 255]) {
  return `rgb(${red} ${green} ${blue} / ${alpha / 255})`;
}

/** That of a picture of this entry. @param {Entry} entry */
export function backgroundOf(entry) {
  return coloured(entry.appearance?.background ?? [13, 16, 23]);
}

/** @param {HTMLCanvasElement} canvas @param {Uint8ClampedArray<ArrayBuffer>} pixels @param {number} width @param {number} height */
export function showPixels(canvas, pixels, width, height) {
  Object.assign(canvas, { width, height });
  canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
}

/** Hands a file to the reader of the page.
 * @param {Blob} blob @param {string} name */
export function save(blob, name) {
  const address = URL.createObjectURL(blob);
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
