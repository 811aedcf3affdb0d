// SPDX-License-Identifier: MIT
// The entries of a collection as small pictures, which are drawn as they come into sight, to be found by name.

import { byId, element } from "./dom.js";
import { filled } from "./texts.js";

/** @typedef {import("./drawing.js").Drawing} Drawing */
/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./texts.js").Texts} Texts */

const tileWidth = 240, tileHeight = 180; // of a picture, in pixels of the page
const tilePoints = 6e5;
const nearby = "300px"; // what comes into sight soon is drawn, too

/** Without case and accents. @param {string} text */
const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").replace(/_/g, " ").toLowerCase();

export class Gallery {
  /** @param {Entry[]} entries @param {string} title @param {string} caption @param {Texts} texts @param {Drawing} drawing
   * @param {(index: number) => void} choose */
  constructor(entries, title, caption, texts, drawing, choose) {
    this.entries = entries;
    this.texts = texts;
    this.drawing = drawing;
    this.scroll = 0;
    this.isDrawing = false;
    /** @type {Set<number>} */
    this.inSight = new Set();
    /** @type {Set<number>} */
    this.drawn = new Set();
    this.search = element("input", { type: "search", id: "find", placeholder: texts.find, "aria-label": texts.find,
      autocomplete: "off", spellcheck: "false" });
    this.found = element("p", { id: "found", role: "status" });
    this.tiles = entries.map((entry, index) => this.tile(entry, index, choose));
    byId("gallery").replaceChildren(
      element("header", {}, [element("h1", {}, [title]), this.search]),
      element("p", { class: "notice" }, [byId("notice").textContent ?? ""]), element("p", { class: "caption" }, [caption].filter(Boolean)),
      this.found, element("ul", { id: "tiles" }, this.tiles));
    this.search.addEventListener("input", () => this.filter());
    this.filter();
    const watching = new IntersectionObserver((changes) => {
      for (const { target, isIntersecting } of changes) {
        const index = this.tiles.indexOf(/** @type {HTMLLIElement} */ (target));
        if (isIntersecting) this.inSight.add(index);
        else this.inSight.delete(index);
      }
      this.draw();
    }, { rootMargin: nearby });
    for (const tile of this.tiles) watching.observe(tile);
  }

  /** @param {Entry} entry @param {number} index @param {(index: number) => void} choose */
  tile(entry, index, choose) {
    const canvas = element("canvas", { width: String(tileWidth), height: String(tileHeight), "aria-hidden": "true" });
    const [red, green, blue, alpha] = entry.appearance?.background ?? [13, 16, 23, 255];
    canvas.style.background = `rgb(${red} ${green} ${blue} / ${alpha / 255})`;
    const button = element("button", { type: "button", class: "tile" }, [canvas, element("span", {}, [entry.name])]);
    button.addEventListener("click", () => choose(index));
    return element("li", {}, [button]);
  }

  filter() {
    const wanted = plain(this.search.value.trim());
    let count = 0;
    this.entries.forEach(({ name }, i) => {
      this.tiles[i].hidden = !plain(name).includes(wanted);
      count += this.tiles[i].hidden ? 0 : 1;
    });
    this.found.textContent = filled(this.texts.found, count, this.entries.length);
  }

  get isShown() {
    return document.body.dataset.view === "gallery";
  }

  /** Pictures of what is in sight, one after the other: a figure that is chosen waits for one at most. */
  async draw() {
    if (this.isDrawing) return;
    this.isDrawing = true;
    const ratio = Math.min(devicePixelRatio, 2);
    for (;;) {
      const next = [...this.inSight].sort((a, b) => a - b).find((index) => !this.drawn.has(index));
      if (next === undefined || !this.isShown) break;
      this.drawn.add(next);
      const canvas = this.tiles[next].querySelector("canvas");
      const { pixels, width = 1, height = 1 } = await this.drawing.ask({ kind: "thumbnail", entry: this.entries[next],
        width: Math.round(tileWidth * ratio), height: Math.round(tileHeight * ratio), samples: tilePoints });
      if (!canvas || !pixels) continue;
      canvas.width = width;
      canvas.height = height;
      canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
    }
    this.isDrawing = false;
  }

  /** @param {number | null} index whose tile is to have the focus */
  show(index) {
    document.body.dataset.view = "gallery";
    scrollTo(0, this.scroll);
    if (index !== null) this.tiles[index].querySelector("button")?.focus({ preventScroll: true });
    this.draw();
  }

  hide() {
    if (this.isShown) this.scroll = scrollY;
    document.body.dataset.view = "figure";
    scrollTo(0, 0);
  }
}
