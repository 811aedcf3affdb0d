// SPDX-License-Identifier: MIT
// The maps as matrices that can be typed.

import { element } from "./dom.js";
import { evaluate } from "./numbers.js";
import { filled } from "./texts.js";

/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./texts.js").Texts} Texts */

const shownMaps = 60; // more than that nobody types
const letters = "abcdefghijkl";

/** Short digits, for a cell that is not being typed in.
 * @param {number | null} value @param {number} count */
function digits(value, count) {
  return value === null ? "" : String(Number(value.toPrecision(count)));
}

/** The order in which the cells of a map stand: each row of the matrix, then its part of the translation.
 * @param {number} dimension @returns {number[]} indices of coefficients */
function cellOrder(dimension) {
  return Array.from({ length: dimension }, (_, row) => [
    ...Array.from({ length: dimension }, (_, column) => row * dimension + column), dimension * dimension + row]).flat();
}

/** Fills `place` with the maps of the entry. `changed` hears of a new value that is a number.
 * @param {HTMLElement} place @param {Entry} entry @param {Texts} texts @param {boolean} isEditable
 * @param {(map: number, index: number, value: number | null) => void} changed
 * @param {(sentence: string) => void} say
 * @returns {() => void} shows numbers that have changed elsewhere */
export function fillTable(place, entry, texts, isEditable, changed, say) {
  const count = entry.dimension === 3 ? 4 : 5;
  const weightAt = entry.dimension * (entry.dimension + 1);
  /** @type {(() => void)[]} */
  const cells = [];
  const cards = entry.maps.slice(0, shownMaps).map((map, number) => {
    /** @param {number} index @param {string} label */
    const cell = (index, label) => {
      const input = element("input", { type: "text", inputmode: "text", autocomplete: "off", spellcheck: "false",
        "aria-label": filled(texts.cell, label, number + 1) });
      const show = () => {
        input.value = digits(map[index] ?? null, count);
        input.title = String(map[index] ?? "");
        input.removeAttribute("aria-invalid");
      };
      show();
      cells.push(show);
      input.readOnly = !isEditable;
      input.addEventListener("focus", () => {
        if (isEditable && !input.hasAttribute("aria-invalid")) input.value = String(map[index] ?? "");
        input.select();
      });
      input.addEventListener("blur", () => {
        if (!input.hasAttribute("aria-invalid")) input.value = digits(map[index] ?? null, count);
      });
      input.addEventListener("input", () => {
        const isEmptyWeight = index === weightAt && input.value.trim() === "";
        const value = isEmptyWeight ? null : evaluate(input.value);
        if (value === null && !isEmptyWeight) {
          input.setAttribute("aria-invalid", "true");
          say(filled(texts.notANumber, input.value));
          return;
        }
        input.removeAttribute("aria-invalid");
        say("");
        map[index] = value;
        input.title = String(value ?? "");
        changed(number, index, value);
      });
      return element("label", { class: "cell" }, [element("span", { "aria-hidden": "true" }, [label]), input]);
    };
    const matrix = cellOrder(entry.dimension).map((index) => cell(index, letters[index]));
    const weight = cell(weightAt, "p");
    weight.classList.add("weight");
    const head = element("div", { class: "head" }, [element("h3", {}, [filled(texts.map, number + 1)]), weight]);
    return element("li", { class: `map dimension-${entry.dimension}` }, [head,
      element("div", { class: "matrix" }, matrix)]);
  });
  if (entry.maps.length > shownMaps)
    cards.push(element("li", { class: "more" }, [`… ${entry.maps.length}`]));
  place.replaceChildren(...cards);
  return () => cells.forEach((show) => show());
}
