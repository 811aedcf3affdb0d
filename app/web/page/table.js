// SPDX-License-Identifier: MIT
// The maps as matrices that can be typed.

import { element } from "./dom.js";
import { evaluate } from "./numbers.js";
import { filled, texts } from "./texts.js";

const shownMaps = 60; // more than that nobody types
const letters = "abcdefghijkl";

/** A number of a map in a field, all of its digits while somebody types.
 * @param {Entry} entry @param {() => Row[]} rows @param {number} number of the map @param {number} index
 * @param {((map: number) => void) | null} changed @param {(sentence: string) => void} say */
function cellOf({ dimension, maps }, rows, number, index, changed, say) {
  const isWeight = index === dimension * (dimension + 1), label = isWeight ? "p" : letters[index];
  const input = element("input", { type: "text", inputmode: "text", autocomplete: "off", spellcheck: "false",
    "aria-label": filled(texts.cell, label, number + 1) });
  const show = (isWhole = false) => {
    if (!isWhole && input === document.activeElement) return;
    const value = rows()[number][index] ?? null;
    input.title = String(value ?? "");
    const isMoving = rows() !== maps; // then as many digits as stay where they are
    const short = () => Number(isMoving ? value?.toFixed(4) : value?.toPrecision(dimension === 3 ? 4 : 5));
    input.value = value === null || isWhole ? input.title : String(short());
    input.setAttribute("aria-invalid", "false");
  };
  show();
  input.readOnly = changed === null;
  const isWrong = () => input.getAttribute("aria-invalid") === "true"; // and so left as it was typed
  input.addEventListener("focus", () => {
    if (!isWrong()) show(changed !== null);
    input.select();
  });
  input.addEventListener("blur", () => isWrong() || show());
  input.addEventListener("input", () => {
    const isEmptyWeight = isWeight && input.value.trim() === "", value = isEmptyWeight ? null : evaluate(input.value);
    const isNumber = value !== null || isEmptyWeight;
    input.setAttribute("aria-invalid", String(!isNumber));
    say(isNumber ? "" : filled(texts.notANumber, input.value));
    if (!isNumber) return;
    rows()[number][index] = value;
    input.title = String(value ?? "");
    changed?.(number);
  });
  return { show, cell: element("label", { class: "cell" }, [element("span", { "aria-hidden": "true" }, [label]), input]) };
}

/** Fills `place` with the maps of the entry. @param {HTMLElement} place @param {Entry} entry @param {() => Row[]} rows those
 * that are shown @param {(map: number) => ((map: number) => void) | null} changed what hears of a new number; null where nobody
 * can type @param {(sentence: string) => void} say @returns {() => void} shows numbers that have changed elsewhere */
export function fillTable(place, entry, rows, changed, say) {
  const { dimension, maps } = entry, weightAt = dimension * (dimension + 1);
  const cells = /** @type {(() => void)[]} */ ([]);
  const cards = maps.slice(0, shownMaps).map((_, number) => {
    const cellAt = (/** @type {number} */ index) => {
      const { show, cell } = cellOf(entry, rows, number, index, changed(number), say);
      cells.push(show);
      return cell;
    };
    // Each row of the matrix, then its part of the translation.
    const matrix = Array.from({ length: weightAt }, (_, i) => {
      const row = Math.floor(i / (dimension + 1)), column = i % (dimension + 1);
      return cellAt(column < dimension ? row * dimension + column : dimension * dimension + row);
    });
    const weight = cellAt(weightAt);
    weight.classList.add("weight");
    return element("li", { class: `map dimension-${dimension}` }, [
      element("div", { class: "head" }, [element("h3", {}, [filled(texts.map, number + 1)]), weight]),
      element("div", { class: "matrix" }, matrix)]);
  });
  if (maps.length > shownMaps) cards.push(element("li", { class: "more" }, [`… ${maps.length}`]));
  place.replaceChildren(...cards);
  return () => cells.forEach((show) => show());
}
