// SPDX-License-Identifier: MIT
// The picture with its cage: what is held, dragged, turned and zoomed.

import { byId, shape } from "./dom.js";
import { carried, dragged, fitted, fittedInSpace, image, middle, minus, offsetInSpace, partAt, plus, times, toPixel,
  toPixelInSpace, toWorld, withImagesMoved, zoomed } from "./geometry.js";
import { readable } from "./numbers.js";
import { filled } from "./texts.js";

/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./engine.js").Extent} Extent */
/** @typedef {import("./geometry.js").Point} Point */
/** @typedef {import("./geometry.js").PlaneView} PlaneView */
/** @typedef {import("./geometry.js").SpaceView} SpaceView */
/** @typedef {import("./texts.js").Texts} Texts */
/** What can be dragged, as it is shown: the cage, or a map as its image of the cage.
 * @typedef {{map: number | null, points: Point[]}} Held */
/** What of it moves: indices of points.
 * @typedef {Held & {part: string, moving: number[]}} Grip */
/** What the pointer has pressed, as it was then. Where nothing moves, it is the view.
 * @typedef {Grip & {row: (number | null)[], from: Point, pixel: Point, plane: PlaneView, space: SpaceView}} Press */

const reachOfFinger = 26, reachOfMouse = 14; // pixels
const margin = 0.09;
const mostHandled = 60; // maps
// As attractor::categoricalColour().
const mapColours = ["#f5ae39", "#37aae3", "#f75f4c", "#59d38c", "#d476cd", "#e0d653", "#7382e6", "#47c7c7", "#f07999",
  "#71a255", "#e5b28a", "#ae96da"];

export class Figure {
  /** @param {Entry} entry @param {Texts} texts @param {string} language @param {boolean} isHeld may its cage be dragged
   * @param {{draw: (findsExposure?: boolean) => void, setLive: (isLive: boolean) => void,
   *   changeMap: (map: number, row: (number | null)[]) => Promise<void>}} drawing */
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
    this.holdsMaps = false; // not the cage
    this.chosen = 0; // map, whose corners have handles
    /** @type {SVGGElement[]} */
    this.groups = []; // of handles
    /** @type {Promise<void> | undefined} */
    this.changed = undefined; // when the picture has a map as it was dragged
    this.entry = entry;
    this.take(entry);
    this.listen();
  }

  /** Shows this entry from now on, once hold() has its extent. @param {Entry} entry */
  take(entry) {
    this.entry = entry;
    this.isKnown = false;
    this.extent = null;
    this.rest = this.current = this.groups = [];
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
    this.holdsMaps &&= this.hasMaps;
    if (this.groups.length !== this.held().length || !this.holdsMaps) this.makeHandles();
    if (this.isSpace && !this.entry.view && extent && before.rest.length === 0)
      this.home = fittedInSpace(this.home, [...this.current, extent.box.slice(0, 3), extent.box.slice(3, 6)], margin);
    if (before.rest.length === 0) this.fit();
    else this.change();
  }

  /** Whether maps can be held: where the cage carries them by an affine map. */
  get hasMaps() {
    return this.rest.length === this.entry.dimension + 1;
  }

  /** @param {boolean} holdsMaps */
  setHoldsMaps(holdsMaps) {
    const hadFocus = this.svg.contains(document.activeElement);
    this.holdsMaps = holdsMaps && this.hasMaps;
    this.chosen = 0;
    this.makeHandles();
    this.layOut();
    if (hadFocus) this.stage.focus();
  }

  /** @returns {Held[]} */
  held() {
    if (!this.holdsMaps) return this.current.length > 0 ? [{ map: null, points: this.current }] : [];
    return this.entry.maps.slice(0, mostHandled).map((row, map) =>
      ({ map, points: carried(this.rest, this.current, this.rest.map((p) => image(row, p))) }));
  }

  makeHandles() {
    const edge = (/** @type {Point[]} */ points) => !this.isSpace ? [shape("polygon", { class: "edge" })]
      : points.length === 4 ? Array.from({ length: 6 }, () => shape("line", { class: "edge" })) : [];
    this.groups = (this.isHeld || this.holdsMaps ? this.held() : []).map(({ map, points }) => {
      const group = shape("g");
      group.style.setProperty("--cage", map === null ? "" : this.colour(map));
      const handles = [...(map === null ? [] : [this.handle(map, points.length, String(map + 1))]),
        ...points.map((_, i) => this.handle(map, i, ""))]; // a map comes before its corners
      group.append(...edge(points), ...handles);
      return group;
    });
    const around = this.isSpace ? [] : [shape("polygon", { class: "rest" })];
    this.svg.replaceChildren(...(this.groups.length > 0 ? around : []), ...this.groups);
  }

  /** @param {number} map */
  colour(map) {
    const own = this.entry.appearance?.mapColours?.find(([index]) => index === map);
    return own ? `rgb(${own[1].slice(0, 3).join(" ")})` : mapColours[map % mapColours.length];
  }

  /** Of a corner or, with a number in it, of a map as a whole.
   * @param {number | null} map @param {number} corner @param {string} number */
  handle(map, corner, number) {
    const handle = shape("g", { class: number ? "corner middle" : "corner", tabindex: "0", role: "button", "aria-describedby": "corner-help" });
    handle.append(shape("circle", { class: "reach", r: "22" }), shape("circle", { class: "dot", r: number ? "11" : "7.5" }));
    if (number) handle.append(shape("text", { "aria-hidden": "true", dy: ".36em" }));
    if (number) handle.children[2].textContent = number;
    handle.dataset.corner = String(corner);
    handle.dataset.map = String(map ?? "");
    handle.addEventListener("focus", () => this.choose(map));
    return handle;
  }

  /** The map whose corners can be held from now on. @param {number | null} map */
  choose(map) {
    this.chosen = map ?? 0;
    this.groups.forEach((group, i) => group.classList.toggle("chosen", !this.holdsMaps || i === this.chosen));
  }

  /** Moves the handles to where the corners are. */
  layOut() {
    const text = (/** @type {Point[]} */ points) => points.map((p) => p.map((x) => x.toFixed(2)).join()).join(" ");
    const rest = this.svg.querySelector(".rest");
    const isMoved = this.rest.some((p, i) => p.some((x, k) => x !== this.current[i][k]));
    rest?.setAttribute("points", text((this.holdsMaps ? this.current : this.rest).map((p) => this.pixel(p))));
    rest?.classList.toggle("moved", isMoved || this.holdsMaps);
    this.held().slice(0, this.groups.length).forEach(({ map, points }, n) => {
      const corners = points.map((p) => this.pixel(p)), all = [...corners, this.pixel(middle(points))];
      this.groups[n].querySelector("polygon")?.setAttribute("points", text(corners));
      const pairs = corners.flatMap((a, i) => corners.slice(i + 1).map((b) => [a, b]));
      this.groups[n].querySelectorAll("line").forEach((line, i) => {
        ["x1", "y1", "x2", "y2"].forEach((name, k) => line.setAttribute(name, pairs[i].flat()[k].toFixed(2)));
      });
      for (const handle of /** @type {NodeListOf<SVGElement>} */ (this.groups[n].querySelectorAll(".corner"))) {
        const corner = Number(handle.dataset.corner);
        handle.setAttribute("transform", `translate(${text([all[corner]])})`);
        handle.setAttribute("aria-label", this.name(map, corner));
      }
    });
    this.choose(this.chosen);
  }

  /** A handle and where it is, for those who listen. @param {number | null} map @param {number} corner */
  name(map, corner) {
    const { points } = this.held()[map ?? 0];
    const place = this.spoken([...points, middle(points)][corner]), { texts } = this;
    return map === null ? filled(texts.corner, corner + 1, place)
      : corner < points.length ? filled(texts.mapCorner, corner + 1, map + 1, place) : filled(texts.mapPlace, map + 1, place);
  }

  /** @param {Point} point */
  spoken(point) {
    return `(${point.map((x) => readable(x, this.language)).join("; ")})`;
  }

  /** @param {Point} point @returns {Point} in pixels of the page */
  pixel(point) {
    return this.isSpace ? toPixelInSpace(this.shownSpace(), this.size, point) : toPixel(this.plane, this.size, point);
  }

  /** The corners of the cage, in pixels of the page. */
  corners() {
    return this.current.map((p) => this.pixel(p));
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

  /** @param {number[]} area of the plane: its middle, width and height */
  look([x, y, width, height]) {
    this.plane = { centre: [x, y], scale: Math.min(this.size.width / width, this.size.height / height) };
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

  /** What is held there: the nearest handle that is seen, then an edge or the inside, of the chosen map before others.
   * @param {Point} pixel @param {number} reach @returns {Grip | null} */
  partUnder(pixel, reach) {
    const held = this.groups.length > 0 ? this.held() : [];
    const isChosen = (/** @type {Held} */ { map }) => map === null || map === this.chosen;
    /** @type {Grip | null} */
    let found = null;
    for (const shown of held)
      [...shown.points, middle(shown.points)].forEach((point, i, { length }) => {
        const isWhole = i === length - 1, apart = Math.hypot(...minus(this.pixel(point), pixel));
        if (apart > reach || !(isWhole ? shown.map !== null : isChosen(shown))) return;
        reach = apart;
        found = { ...shown, part: "vertex", moving: isWhole ? shown.points.map((_, k) => k) : [i] };
      });
    if (found || this.isSpace) return found;
    for (const shown of [...held.filter(isChosen), ...held]) {
      const { map, points } = shown, all = points.map((_, k) => k);
      const part = partAt(points.map((p) => this.pixel(p)), pixel, reach);
      if (part) return { ...shown, part: part.part, moving: part.part === "edge" && map === null ? [part.index, (part.index + 1) % all.length] : all };
    }
    return null;
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
    const grip = this.partUnder(pixel, reach) ?? { map: null, points: this.current, part: "", moving: [] };
    this.press = { ...grip, row: this.rowOf(grip.map), from: toWorld(this.plane, this.size, pixel), pixel,
      plane: this.plane, space: this.space };
    if (grip.map !== null) this.choose(grip.map);
    this.stage.classList.toggle("dragging", grip.moving.length > 0);
    this.groups[grip.map ?? 0]?.querySelectorAll(".corner").forEach((handle) =>
      handle.classList.toggle("held", grip.moving.length === 1 && handle.getAttribute("data-corner") === String(grip.moving[0])));
  }

  /** @param {number | null} map */
  rowOf(map) {
    return map === null ? [] : [...this.entry.maps[map]];
  }

  /** Brings what is held to other points. @param {Held & {row: (number | null)[]}} held @param {Point[]} points */
  put({ map, points: before, row }, points) {
    if (map === null) {
      this.current = points;
      this.change();
      return;
    }
    const inCode = carried(this.current, this.rest, [...before, ...points]);
    const offsets = before.map((_, i) => minus(inCode[before.length + i], inCode[i]));
    if (!offsets.flat().every(Number.isFinite)) return; // the cage is flat
    this.entry.cage ??= { rest: this.rest, current: this.current, bends: true }; // it stays where it is
    this.changed = this.drawing.changeMap(map, withImagesMoved(row, this.rest, offsets));
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
      const offset = offsetInSpace(this.shownSpace(), this.size, press.points[press.moving[0]], shift);
      this.put(press, press.points.map((v, i) => (press.moving.includes(i) ? plus(v, offset) : v)));
    } else {
      const isWhole = press.moving.length === press.points.length;
      const mode = isWhole && keys.ctrlKey ? "rotate" : isWhole && keys.altKey ? "scale" : "move";
      const to = toWorld(press.plane, this.size, pixel);
      this.put(press, dragged(press.points, press.moving, mode, press.from, to, keys.shiftKey));
    }
    if (press.moving.length === 0) this.change();
  }

  /** @param {number} azimuth @param {number} elevation */
  turnTo(azimuth, elevation) {
    this.space = { ...this.space, azimuth: azimuth % 360, elevation: Math.min(90, Math.max(-90, elevation)) };
  }

  /** @param {PointerEvent} event @param {boolean} isCancelled */
  released(event, isCancelled) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.press && isCancelled) this.cancel();
    if (this.press && this.press.moving.length > 0) this.say(this.press.map, this.press.moving);
    this.press = null;
    this.stage.classList.remove("dragging");
    this.svg.querySelectorAll(".held").forEach((handle) => handle.classList.remove("held"));
    if (this.pointers.size === 0) this.drawing.setLive(false);
  }

  cancel() {
    if (!this.press) return;
    if (this.press.moving.length > 0) this.put(this.press, this.press.points);
    this.plane = this.press.plane;
    this.space = this.press.space;
    this.press = null;
    this.change();
  }

  /** Says where a corner or a map is, once it is there. @param {number | null} map @param {number[]} moving */
  async say(map, moving) {
    await this.changed;
    if (map !== null || moving.length === 1) this.said.textContent = this.name(map, moving.length > 1 ? moving.length : moving[0]);
  }

  /** @param {KeyboardEvent} event */
  keyed(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    /** @type {Record<string, Point>} */
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const handle = event.target instanceof SVGElement ? event.target.closest("g")?.dataset : undefined;
    const centre = [this.size.width / 2, this.size.height / 2];
    if (Object.hasOwn(arrows, event.key)) {
      const step = times(arrows[event.key], event.shiftKey ? 40 : 8);
      if (handle) this.moveBy(handle.map ? Number(handle.map) : null, Number(handle.corner), step);
      else if (this.isSpace) {
        this.turnTo(this.space.azimuth - step[0] / 2, this.space.elevation + step[1] / 2);
        this.change();
      } else if (this.isHeld && !this.holdsMaps && this.current.length > 0) this.moveBy(null, this.current.length, step);
      else {
        this.pan(times(step, -1));
        this.change();
      }
    } else if (event.key === "+" || event.key === "=") this.zoom(centre, 1.25);
    else if (event.key === "-") this.zoom(centre, 0.8);
    else if (event.key === "0") this.fit();
    else if (event.key === "Escape") this.cancel();
    else if (event.key.toLowerCase() === "m" && !this.press) byId("hold-maps").click();
    else return;
    event.preventDefault();
  }

  /** @param {number | null} map @param {number} corner that of a handle @param {Point} pixels */
  moveBy(map, corner, pixels) {
    const { points } = this.held()[map ?? 0], moving = corner < points.length ? [corner] : points.map((_, i) => i);
    const offset = (/** @type {Point} */ v) => this.isSpace ? offsetInSpace(this.shownSpace(), this.size, v, pixels)
      : [pixels[0] / this.plane.scale, -pixels[1] / this.plane.scale];
    const by = offset(moving.length === 1 ? points[corner] : middle(points));
    this.put({ map, points, row: this.rowOf(map) }, points.map((v, i) => (moving.includes(i) ? plus(v, by) : v)));
    this.say(map, moving);
  }
}
