// SPDX-License-Identifier: MIT
// The entries of a collection as small pictures, which are drawn as they come into sight, to be found by name.

import { backgroundOf, byId, element, showPixels } from "./dom.js";
import { wantsMotion } from "./player.js";
import { filled, texts } from "./texts.js";

/** @import { Drawing } from "./drawing.js" */

const tileWidth = 240, tileHeight = 180; // of a picture, in pixels of the page
const tilePoints = 6e5;
const nearby = "300px"; // what comes into sight soon is drawn, too

/** Without case and accents. @param {string} text */
const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").replace(/_/g, " ").toLowerCase();

/** @param {Entry} entry */
const moves = (entry) => entry.text?.lines.some((line) => line.startsWith("; barycage: animation ")) ?? false;

export class Gallery {
  /** @param {Entry[]} entries @param {string} title @param {string} caption @param {Drawing} drawing
   * @param {(index: number) => void} choose */
  constructor(entries, title, caption, drawing, choose) {
    this.entries = entries;
    this.drawing = drawing;
    this.scroll = 0;
    this.isDrawing = false;
    this.waiting = /** @type {Set<Element>} */ (new Set()); // tiles in sight that have no picture yet
    this.search = element("input", { type: "search", id: "find", placeholder: texts.find, "aria-label": texts.find,
      autocomplete: "off", spellcheck: "false" });
    this.search.addEventListener("input", () => this.filter());
    this.found = element("p", { id: "found", role: "status" });
    this.tiles = entries.map((entry, index) => this.tile(entry, () => choose(index)));
    byId("gallery").replaceChildren(
      element("header", {}, [element("h1", {}, [title]), this.search]),
      element("p", { class: "notice" }, [byId("notice").textContent ?? ""]), element("p", { class: "caption" }, [caption].filter(Boolean)),
      this.found, element("ul", { id: "tiles" }, this.tiles));
    this.filter();
    this.watching = new IntersectionObserver((changes) => {
      for (const { target, isIntersecting } of changes) this.waiting[isIntersecting ? "add" : "delete"](target);
      this.draw();
    }, { rootMargin: nearby });
    for (const tile of this.tiles) this.watching.observe(tile);
  }

  /** @param {Entry} entry @param {() => void} choose */
  tile(entry, choose) {
    const canvas = element("canvas", { width: String(tileWidth), height: String(tileHeight), "aria-hidden": "true" });
    canvas.style.background = backgroundOf(entry);
    const button = element("button", { type: "button", class: "tile" }, [canvas, element("span", {}, [entry.name])]);
    button.addEventListener("click", choose);
    if (moves(entry))
      button.addEventListener("pointerenter", ({ pointerType }) => pointerType === "mouse" && wantsMotion() && this.play(entry, canvas, button));
    return element("li", {}, [button]);
  }

  filter() {
    const wanted = plain(this.search.value.trim());
    this.tiles.forEach((tile, i) => (tile.hidden = !plain(this.entries[i].name).includes(wanted)));
    this.found.textContent = filled(texts.found, this.tiles.filter((tile) => !tile.hidden).length, this.tiles.length);
  }

  get isShown() {
    return document.body.dataset.view === "gallery";
  }

  /** Pictures of what is in sight, one after the other: a figure that is chosen waits for one at most. */
  async draw() {
    if (this.isDrawing) return;
    this.isDrawing = true;
    while (this.isShown && this.waiting.size > 0) {
      const index = this.tiles.findIndex((tile) => this.waiting.has(tile)), tile = this.tiles[index];
      this.waiting.delete(tile);
      this.watching.unobserve(tile);
      const canvas = tile.querySelector("canvas");
      if (moves(this.entries[index])) await this.motionOf(this.entries[index]);
      if (canvas) await this.drawTile(this.entries[index], canvas);
    }
    this.isDrawing = false;
  }

  /** @param {Entry} entry @param {HTMLCanvasElement} canvas @param {number} [frame] */
  async drawTile(entry, canvas, frame) {
    const ratio = Math.min(devicePixelRatio, 2), samples = frame === undefined ? tilePoints : tilePoints / 3;
    const { pixels, width = 1, height = 1 } = await this.drawing.ask({ kind: "thumbnail", entry, frame, samples,
      width: Math.round(tileWidth * ratio), height: Math.round(tileHeight * ratio) });
    if (pixels) showPixels(canvas, pixels, width, height);
  }

  /** What moves in an entry, whose pictures show all of its motion from then on. @param {Entry} entry */
  async motionOf(entry) {
    const { motion, extent } = await this.drawing.ask({ kind: "load", entry }), boxes = extent?.reach?.map(({ box }) => box) ?? [];
    if (boxes.length > 0 && entry.dimension === 2 && !entry.cage)
      entry.box = boxes[0].map((_, i) => Math[i < 2 ? "min" : "max"](...boxes.map((box) => box[i])));
    return motion;
  }

  /** Plays an entry under the pointer, until that leaves. @param {Entry} entry @param {HTMLCanvasElement} canvas @param {Element} tile */
  async play(entry, canvas, tile) {
    const motion = await this.motionOf(entry), began = performance.now();
    while (motion && this.isShown && tile.matches(":hover")) {
      const frame = Math.floor(((performance.now() - began) * motion.rate) / 1000);
      await this.drawTile(entry, canvas, motion.isEndless ? frame % motion.frames : Math.min(frame, motion.frames - 1));
      await new Promise((next) => requestAnimationFrame(next));
    }
    await this.drawTile(entry, canvas);
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
