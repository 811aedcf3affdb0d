// SPDX-License-Identifier: MIT
// What the page says: texts.json has it in the languages of the program, the page in its own or in all of them.

import { byId } from "./dom.js";

/** @typedef {typeof import("./texts.json")["en"]} Texts */

/** @type {Record<string, Texts>} */
const languages = JSON.parse(byId("texts").textContent ?? "");

/** The first of these languages that the page speaks, else English.
 * @param {readonly string[]} wanted */
export function spokenLanguage(wanted) {
  return wanted.map((tag) => tag.toLowerCase().split("-")[0]).find((tag) => Object.hasOwn(languages, tag)) ?? "en";
}

/** @param {string} language @returns {Texts} */
export function textsOf(language) {
  return languages[language];
}

/** @param {string} text with {0}, {1} … @param {...(string | number)} values */
export function filled(text, ...values) {
  return text.replace(/\{(\d)\}/g, (_, i) => String(values[Number(i)]));
}
