// SPDX-License-Identifier: MIT
// What the page says: texts.json has it in the languages of the program, the page in its own or in all of them.

import { byId } from "./dom.js";

const spoken = /** @type {Record<string, typeof import("./texts.json")["en"]>} */ (JSON.parse(byId("texts").textContent ?? ""));

/** The first language of the browser that the page speaks, else English, else the only one. */
export const language = [...navigator.languages.map((tag) => tag.toLowerCase().split("-")[0]), "en", ...Object.keys(spoken)]
  .find((tag) => Object.hasOwn(spoken, tag)) ?? "";
export const texts = spoken[language];

/** @param {string} text with {0}, {1} … @param {...(string | number)} values */
export function filled(text, ...values) {
  return text.replace(/\{(\d)\}/g, (_, i) => String(values[Number(i)]));
}
