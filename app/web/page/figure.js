// SPDX-License-Identifier: MIT
// The picture with its cage: what is held, dragged, turned and zoomed.

import { byId, shape } from "./dom.js";
import { carried, dragged, fitted, fittedInSpace, middle, minus, offsetInSpace, partAt, plus, times, toPixel, toPixelInSpace,
  toWorld, zoomed } from "./geometry.js";
import { readable } from "./numbers.js";
import { filled } from "./texts.js";

/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./engine.js").Extent} Extent */
/** @typedef {import("./geometry.js").Point} Point */
/** @typedef {import("./geometry.js").PlaneView} PlaneView */
/** @typedef {import("./geometry.js").SpaceView} SpaceView */
/** @typedef {import("./texts.js").Texts} Texts */
/** What the pointer has pressed, as it was then.
 * @typedef {{moving: number[], from: Point, pixel: Point, vertices: Point[], plane: PlaneView, space: SpaceView}} Press
 */

const reachOfFinger = 26, reachOfMouse = 14; // pixels
const margin = 0.09;

export class Figure {
  /** @param {Entry} entry @param {Texts} texts @param {string} language @param {boolean} isHeld may its cage be dragged
   * @param {{draw: (findsExposure?: boolean) => void, setLive: (isLive: boolean) => void}} drawing */
  constructor(entry, texts, language, isHeld, drawing) {
    this.stage = byId("stage");
    this.canvas = /** @type {HTMLCanvasElement} */ (byId("canvas"));
    this.svg = byId("cage");
    this.said = byId("said");
    this.texts = texts;
    this.language = language;
    this.isHeld = isHeld;
    this.drawing = drawing;
    /** @type {Extent | null} */
    this.extent = null;
    /** @type {Point[]} */
    this.rest = [];
    /** @type {Point[]} */
    this.current = [];
    /** @type {PlaneView} */
    this.plane = { centre: [0, 0], scale: 100 };
    /** @type {SpaceView} */
    this.home = { target: [0, 0, 0], azimuth: 30, elevation: 20, height: 2, field: 0 };
    this.space = this.home;
    this.size = { width: 1, height: 1 };
    /** @type {Press | null} */
    this.press = null;
    /** @type {Map<number, Point>} */
    this.pointers = new Map();
    this.isSpace = false;
    this.isKnown = false; // the engine has the entry
    this.entry = entry;
    this.take(entry);
    this.listen();
  }

  /** Shows this entry from now on, once hold() has its extent. @param {Entry} entry */
  take(entry) {
    this.entry = entry;
    this.isKnown = false;
    this.extent = null;
    this.rest = this.current = [];
    const [x, y, z, azimuth, elevation, height, field] = entry.view ?? [0, 0, 0, 30, 20, 2, 0];
    this.home = { target: [x, y, z], azimuth, elevation, height, field };
    this.space = this.home;
    this.isSpace = entry.dimension === 3;
    this.stage.setAttribute("aria-label", filled(this.isSpace ? this.texts.orbit : this.texts.figure, entry.name));
  }

  listen() {
    const stage = this.stage;
    stage.addEventListener("pointerdown", (e) => this.pressed(e));
    stage.addEventListener("pointermove", (e) => this.moved(e));
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel"]))
      stage.addEventListener(kind, (e) => this.released(e, kind === "pointercancel"));
    stage.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(this.place(e), Math.exp(-e.deltaY / (e.deltaMode === 1 ? 20 : 400)));
    }, { passive: false });
    stage.addEventListener("keydown", (e) => this.keyed(e));
    stage.addEventListener("dblclick", (e) => {
      if (!this.partUnder(this.place(e), reachOfMouse)) this.fit();
    });
    new ResizeObserver(() => this.resized()).observe(stage);
  }

  /** Takes up an extent and a cage: those of the entry, or of one whose maps have been typed.
   * @param {Extent | null} extent */
  hold(extent) {
    const before = { rest: this.rest, current: this.current };
    const { cage } = this.entry;
    this.extent = extent;
    this.isKnown = true;
    if (cage && before.rest.length === 0) {
      this.rest = cage.rest;
      this.current = cage.current;
    } else if (!cage) {
      this.rest = extent?.simplex ?? [];
      const isPlaced = before.rest.length > 0 && this.rest.length > 0;
      this.current = isPlaced ? carried(before.rest, before.current, this.rest) : this.rest;
    }
    this.makeHandles();
    if (this.isSpace && !this.entry.view && extent && before.rest.length === 0)
      this.home = fittedInSpace(this.home, [...this.current, extent.box.slice(0, 3), extent.box.slice(3, 6)], margin);
    if (before.rest.length === 0) this.fit();
    else this.change();
  }

  makeHandles() {
    const handles = this.isHeld ? this.current.map((_, i) => {
      const handle = shape("g", { class: "corner", tabindex: "0", role: "button", "aria-describedby": "corner-help" });
      handle.append(shape("circle", { class: "reach", r: "22" }), shape("circle", { class: "dot", r: "7.5" }));
      handle.dataset.corner = String(i);
      return handle;
    }) : [];
    const lines = this.isSpace
      ? this.current.flatMap((_, i) => this.current.slice(i + 1).map(() => shape("line", { class: "edge" })))
      : [shape("polygon", { class: "rest" }), shape("polygon", { class: "edge" })];
    this.svg.replaceChildren(...(this.isHeld && (!this.isSpace || this.current.length === 4) ? lines : []), ...handles);
  }

  /** Moves the handles to where the corners are. */
  layOut() {
    const corners = this.corners();
    const text = (/** @type {Point[]} */ points) => points.map((p) => p.map((x) => x.toFixed(2)).join()).join(" ");
    const rest = this.svg.querySelector(".rest"), edge = this.svg.querySelector("polygon.edge");
    rest?.setAttribute("points", text(this.rest.map((p) => toPixel(this.plane, this.size, p))));
    rest?.classList.toggle("moved", this.rest.some((p, i) => p.some((x, k) => x !== this.current[i][k])));
    edge?.setAttribute("points", text(corners));
    const pairs = corners.flatMap((a, i) => corners.slice(i + 1).map((b) => [a, b]));
    this.svg.querySelectorAll("line.edge").forEach((line, i) => {
      ["x1", "y1", "x2", "y2"].forEach((name, k) => line.setAttribute(name, pairs[i].flat()[k].toFixed(2)));
    });
    this.svg.querySelectorAll(".corner").forEach((handle, i) => {
      handle.setAttribute("transform", `translate(${corners[i].map((x) => x.toFixed(2)).join()})`);
      handle.setAttribute("aria-label", filled(this.texts.corner, i + 1, this.spoken(this.current[i])));
    });
  }

  /** @param {Point} point */
  spoken(point) {
    return `(${point.map((x) => readable(x, this.language)).join("; ")})`;
  }

  /** The corners in pixels of the page. */
  corners() {
    return this.current.map((p) => this.isSpace ? toPixelInSpace(this.shownSpace(), this.size, p)
      : toPixel(this.plane, this.size, p));
  }

  /** The camera in space, which shows all of what is as wide as high also where the picture is narrow. */
  shownSpace() {
    return { ...this.space, height: this.space.height * Math.max(1, this.size.height / this.size.width) };
  }

  /** As barycage_camera() has it, in pixels of the page. @returns {number[]} */
  view() {
    if (!this.isSpace) return [...this.plane.centre, this.plane.scale];
    const { target, azimuth, elevation, height, field } = this.shownSpace();
    return [...target, azimuth, elevation, height, field];
  }

  change(findsExposure = false) {
    if (!this.isKnown) return; // the handles are of another entry
    this.layOut();
    this.drawing.draw(findsExposure);
  }

  resized() {
    const { width, height } = this.stage.getBoundingClientRect();
    if (width === 0) return; // it is hidden
    const isFirst = this.size.width === 1;
    const factor = Math.min(width / this.size.width, height / this.size.height);
    this.size = { width, height };
    if (isFirst) this.fit();
    else {
      this.plane = { centre: this.plane.centre, scale: this.plane.scale * factor };
      this.change();
    }
  }

  fit() {
    this.space = this.home;
    const box = this.extent?.box;
    const ofBox = box ? [[box[0], box[1]], [box[2], box[1]], [box[0], box[3]], [box[2], box[3]]] : [];
    const isTriangle = this.current.length === 3;
    const cage = this.isHeld || !box ? this.current : [];
    const points = [...cage, ...(isTriangle ? carried(this.rest, this.current, ofBox) : ofBox)];
    if (!this.isSpace) this.plane = fitted(points.length > 0 ? points : [[-1, -1], [1, 1]], this.size, margin);
    this.change(true);
  }

  reset() {
    this.current = this.rest;
    this.fit();
  }

  /** @param {Point} pixel @param {number} factor */
  zoom(pixel, factor) {
    this.plane = zoomed(this.plane, this.size, pixel, factor);
    this.space = { ...this.space, height: this.space.height / factor };
    this.change();
  }

  /** @param {MouseEvent} event @returns {Point} in pixels of the page, from the corner of the stage */
  place(event) {
    const { left, top } = this.stage.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  /** @param {Point} pixel @param {number} reach */
  partUnder(pixel, reach) {
    if (!this.isHeld || this.current.length === 0) return null;
    const part = partAt(this.corners(), pixel, reach);
    return this.isSpace && part?.part !== "vertex" ? null : part;
  }

  /** @param {PointerEvent} event */
  pressed(event) {
    if (event.button !== 0 || !(event.target instanceof Element) || event.target.closest("button")) return;
    const pixel = this.place(event);
    this.pointers.set(event.pointerId, pixel);
    this.stage.setPointerCapture(event.pointerId);
    if (this.pointers.size > 1) this.press = null; // fingers that zoom
    else this.begin(pixel, event.pointerType === "mouse" ? reachOfMouse : reachOfFinger);
    this.drawing.setLive(true);
  }

  /** @param {Point} pixel @param {number} reach */
  begin(pixel, reach) {
    const part = this.partUnder(pixel, reach);
    const all = this.current.map((_, i) => i);
    const moving = !part ? [] : part.part === "inside" ? all
      : part.part === "edge" ? [part.index, (part.index + 1) % all.length] : [part.index];
    this.press = { moving, from: toWorld(this.plane, this.size, pixel), pixel, vertices: this.current,
      plane: this.plane, space: this.space };
    this.stage.classList.toggle("dragging", moving.length > 0);
    this.svg.querySelectorAll(".corner").forEach((handle, i) =>
      handle.classList.toggle("held", moving.length === 1 && moving[0] === i));
  }

  /** @param {PointerEvent} event */
  moved(event) {
    const pixel = this.place(event);
    if (!this.pointers.has(event.pointerId)) {
      const part = this.partUnder(pixel, reachOfMouse);
      this.stage.dataset.under = part?.part ?? "";
      return;
    }
    const before = [...this.pointers.values()];
    this.pointers.set(event.pointerId, pixel);
    if (this.pointers.size === 2) this.pinch(before, [...this.pointers.values()]);
    else if (this.press) this.drag(this.press, pixel, event);
  }

  /** @param {Point[]} before @param {Point[]} after two fingers */
  pinch(before, after) {
    const spread = (/** @type {Point[]} */ [a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);
    const shift = minus(middle(after), middle(before));
    this.pan(shift);
    this.zoom(middle(after), spread(after) / Math.max(spread(before), 1));
  }

  /** @param {Point} shift in pixels */
  pan(shift) {
    const { centre, scale } = this.plane;
    this.plane = { centre: [centre[0] - shift[0] / scale, centre[1] + shift[1] / scale], scale };
    if (this.isSpace) {
      const offset = offsetInSpace(this.shownSpace(), this.size, this.space.target, shift);
      this.space = { ...this.space, target: minus(this.space.target, offset) };
    }
  }

  /** @param {Press} press @param {Point} pixel @param {{ctrlKey: boolean, altKey: boolean, shiftKey: boolean}} keys */
  drag(press, pixel, keys) {
    const shift = minus(pixel, press.pixel);
    if (press.moving.length === 0) {
      if (this.isSpace) this.turnTo(press.space.azimuth - shift[0] * 0.4, press.space.elevation + shift[1] * 0.4);
      else {
        const { centre, scale } = press.plane;
        this.plane = { centre: [centre[0] - shift[0] / scale, centre[1] + shift[1] / scale], scale };
      }
    } else if (this.isSpace) {
      const offset = offsetInSpace(this.shownSpace(), this.size, press.vertices[press.moving[0]], shift);
      this.current = press.vertices.map((v, i) => (press.moving.includes(i) ? plus(v, offset) : v));
    } else {
      const isWhole = press.moving.length === this.current.length;
      const mode = isWhole && keys.ctrlKey ? "rotate" : isWhole && keys.altKey ? "scale" : "move";
      const to = toWorld(press.plane, this.size, pixel);
      this.current = dragged(press.vertices, press.moving, mode, press.from, to, keys.shiftKey);
    }
    this.change();
  }

  /** @param {number} azimuth @param {number} elevation */
  turnTo(azimuth, elevation) {
    this.space = { ...this.space, azimuth: azimuth % 360, elevation: Math.min(90, Math.max(-90, elevation)) };
  }

  /** @param {PointerEvent} event @param {boolean} isCancelled */
  released(event, isCancelled) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.press && isCancelled) this.cancel();
    if (this.press && this.press.moving.length === 1)
      this.say(this.press.moving[0]);
    this.press = null;
    this.stage.classList.remove("dragging");
    this.svg.querySelectorAll(".held").forEach((handle) => handle.classList.remove("held"));
    if (this.pointers.size === 0) this.drawing.setLive(false);
  }

  cancel() {
    if (!this.press) return;
    this.current = this.press.vertices;
    this.plane = this.press.plane;
    this.space = this.press.space;
    this.press = null;
    this.change();
  }

  /** @param {number} corner */
  say(corner) {
    this.said.textContent = filled(this.texts.corner, corner + 1, this.spoken(this.current[corner]));
  }

  /** @param {KeyboardEvent} event */
  keyed(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    /** @type {Record<string, Point>} */
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const corner = event.target instanceof SVGElement ? event.target.closest("g")?.dataset.corner : undefined;
    const centre = [this.size.width / 2, this.size.height / 2];
    if (Object.hasOwn(arrows, event.key)) {
      const step = times(arrows[event.key], event.shiftKey ? 40 : 8);
      if (corner !== undefined) this.moveBy([Number(corner)], step);
      else if (this.isSpace) {
        this.turnTo(this.space.azimuth - step[0] / 2, this.space.elevation + step[1] / 2);
        this.change();
      } else if (this.isHeld && this.current.length > 0) this.moveBy(this.current.map((_, i) => i), step);
      else {
        this.pan(times(step, -1));
        this.change();
      }
    } else if (event.key === "+" || event.key === "=") this.zoom(centre, 1.25);
    else if (event.key === "-") this.zoom(centre, 0.8);
    else if (event.key === "0") this.fit();
    else if (event.key === "Escape") this.cancel();
    else return;
    event.preventDefault();
  }

  /** @param {number[]} moving @param {Point} pixels */
  moveBy(moving, pixels) {
    const offset = (/** @type {Point} */ v) => this.isSpace ? offsetInSpace(this.shownSpace(), this.size, v, pixels)
      : [pixels[0] / this.plane.scale, -pixels[1] / this.plane.scale];
    this.current = this.current.map((v, i) => (moving.includes(i) ? plus(v, offset(v)) : v));
    this.change();
    if (moving.length === 1) this.say(moving[0]);
  }
}
