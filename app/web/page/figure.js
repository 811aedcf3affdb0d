// SPDX-License-Identifier: MIT
// The picture with its cage: what is held, dragged, turned and zoomed.

import { Camera } from "./camera.js";
import { byId, coloured, shape } from "./dom.js";
import { carried, dragged, edgeAt, image, isInside, middle, minus, plus, times, withImagesMoved } from "./geometry.js";
import { readable } from "./numbers.js";
import { filled, language, texts } from "./texts.js";

const reachOfFinger = 26, reachOfMouse = 14; // pixels
const margin = 0.09;
const mostHandled = 60; // maps
// As attractor::categoricalColour().
const mapColours = ["#f5ae39", "#37aae3", "#f75f4c", "#59d38c", "#d476cd", "#e0d653", "#7382e6", "#47c7c7", "#f07999",
  "#71a255", "#e5b28a", "#ae96da"];

export class Figure {
  /** @param {Entry} entry @param {boolean} isHeld may its cage be dragged @param {{draw: (findsExposure?: boolean) => void,
   * setLive: (isLive: boolean) => void, changeMap: (map: number, row: Row) => Promise<void>, pause: () => void}} drawing */
  constructor(entry, isHeld, drawing) {
    this.stage = byId("stage");
    this.svg = byId("cage");
    this.mayHold = isHeld;
    this.motion = /** @type {Motion | null} */ (null);
    this.shown = /** @type {Shown | null} */ (null); // of an entry that moves
    this.follows = false; // the camera of the keys
    this.drawing = drawing;
    this.extent = /** @type {Extent | null} */ (null);
    this.rest = /** @type {Point[]} */ ([]);
    this.current = /** @type {Point[]} */ ([]);
    this.camera = this.home = new Camera([0, 0], 1);
    this.isFitted = true; // the camera shows all
    this.size = { width: 1, height: 1 };
    this.press = /** @type {Press | null} */ (null);
    this.pointers = /** @type {Map<number, Point>} */ (new Map());
    this.isKnown = false; // the engine has the entry
    this.holdsMaps = false; // not the cage
    this.chosen = 0; // map, whose corners have handles
    this.groups = /** @type {SVGGElement[]} */ ([]); // of handles
    this.changed = /** @type {Promise<void> | undefined} */ (undefined); // when the picture has a map as it was dragged
    this.entry = entry;
    this.take(entry);
    this.listen();
  }

  /** Shows this entry from now on, once hold() has its extent. @param {Entry} entry */
  take(entry) {
    this.entry = entry;
    this.isKnown = false;
    this.extent = this.motion = this.shown = null;
    this.rest = this.current = this.groups = [];
    const [x, y, z, azimuth, elevation, height, field] = entry.view ?? [0, 0, 0, 30, 20, 2, 0];
    const isSpace = entry.dimension === 3;
    const flat = new Camera([0, 0], 2 / (1 - 2 * margin)); // of what has neither an attractor nor a cage
    this.camera = this.home = isSpace ? new Camera([x, y, z], height, azimuth, elevation, field) : flat;
    this.stage.setAttribute("aria-label", filled(isSpace ? texts.orbit : texts.figure, entry.name));
  }

  listen() {
    const stage = this.stage;
    stage.addEventListener("pointerdown", (e) => this.pressed(e));
    stage.addEventListener("pointermove", (e) => this.moved(e));
    for (const kind of /** @type {const} */ (["pointerup", "pointercancel"]))
      stage.addEventListener(kind, (e) => this.released(e, kind === "pointercancel"));
    stage.addEventListener("wheel", (e) => {
      const isUsed = document.hasFocus() && stage.contains(document.activeElement);
      if (document.body.dataset.place === "article" && !isUsed && !e.ctrlKey) return; // the article scrolls
      e.preventDefault();
      this.zoom(this.place(e), Math.exp(-e.deltaY / (e.deltaMode === 1 ? 20 : 400)));
    }, { passive: false });
    stage.addEventListener("keydown", (e) => this.keyed(e));
    stage.addEventListener("dblclick", (e) => {
      if (!this.gripUnder(this.place(e), reachOfMouse)) this.fit();
    });
    new ResizeObserver(() => this.resized()).observe(stage);
  }

  /** Takes up an extent and a cage: those of the entry, or of one whose maps have been typed.
   * @param {Extent | null} extent @param {Motion | null} motion */
  hold(extent, motion) {
    const before = { rest: this.rest, current: this.current };
    const { cage } = this.entry;
    this.extent = extent;
    this.motion = motion;
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
    if (this.camera.isSpace && !this.entry.view && extent && before.rest.length === 0)
      this.home = this.home.fitted([...this.current, extent.box.slice(0, 3), extent.box.slice(3, 6)], { width: 1, height: 1 }, margin);
    if (this.camera.isSpace && extent?.reach && before.rest.length === 0) { // all of it from every side
      const far = this.home.target.map((x, i) => Math.max(...(extent.reach ?? []).map(({ box }) => Math.max(x - box[i], box[i + 3] - x))));
      this.home = this.home.with({ height: Math.max(this.home.height, 2 * Math.hypot(...far)) });
    }
    if (before.rest.length === 0) this.fit();
    else this.change();
  }

  /** Whether maps can be held: where the cage carries them by an affine map. */
  get hasMaps() {
    const { movesCage = false, movesMap = [] } = this.motion ?? {};
    return this.rest.length === this.entry.dimension + 1 && !movesCage && !movesMap.includes(true);
  }

  /** Whether the cage can be dragged: what keys move is theirs. */
  get isHeld() {
    return this.mayHold && !this.motion?.movesCage;
  }

  /** The corners as they are shown: a motion may turn them. */
  get placed() {
    const isMoved = this.motion?.movesCage || (this.motion?.turns && !this.camera.isSpace);
    return isMoved && this.shown?.corners.length === this.current.length ? this.shown.corners : this.current;
  }

  /** Takes up what the newest picture shows of an entry that moves. @param {Shown} shown */
  takeShown(shown) {
    this.shown = shown;
    if (this.follows && shown.camera) this.camera = this.camera.moved(shown.camera, this.size);
    this.layOut();
  }

  /** The camera of the newest picture. */
  get eye() {
    const turned = this.camera.isSpace && this.motion?.turns ? this.shown?.camera : null;
    return turned ? this.camera.moved(turned, this.size) : this.camera;
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
    const { placed, current } = this;
    if (!this.holdsMaps) return current.length > 0 ? [{ map: null, row: [], points: placed, current }] : [];
    return (this.shown?.rows ?? this.entry.maps).slice(0, mostHandled).map((row, map) =>
      ({ map, row: [...row], points: carried(this.rest, placed, this.rest.map((p) => image(row, p))), current }));
  }

  makeHandles() {
    const edge = (/** @type {Point[]} */ points) => !this.camera.isSpace ? [shape("polygon", { class: "edge" })]
      : points.length === 4 ? Array.from({ length: 6 }, () => shape("line", { class: "edge" })) : [];
    this.groups = (this.isHeld || this.holdsMaps ? this.held() : []).map(({ map, points }) => {
      const group = shape("g");
      group.style.setProperty("--cage", map === null ? "" : this.colour(map));
      const handles = [...(map === null ? [] : [this.handle(map, points.length, String(map + 1))]),
        ...points.map((_, i) => this.handle(map, i, ""))]; // a map comes before its corners
      group.append(...edge(points), ...handles);
      return group;
    });
    const around = this.camera.isSpace ? [] : [shape("polygon", { class: "rest" })];
    this.svg.replaceChildren(...(this.groups.length > 0 ? around : []), ...this.groups);
  }

  /** @param {number} map */
  colour(map) {
    const own = this.entry.appearance?.mapColours?.find(([index]) => index === map);
    return own ? coloured(own[1].slice(0, 3)) : mapColours[map % mapColours.length];
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
    const isMoved = this.rest.some((p, i) => p.some((x, k) => x !== this.placed[i][k]));
    rest?.setAttribute("points", text((this.holdsMaps ? this.placed : this.rest).map((p) => this.pixel(p))));
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
    const place = `(${[...points, middle(points)][corner].map((x) => readable(x, language)).join("; ")})`;
    if (map === null) return filled(texts.corner, corner + 1, place);
    return corner < points.length ? filled(texts.mapCorner, corner + 1, map + 1, place) : filled(texts.mapPlace, map + 1, place);
  }

  /** @param {Point} point @returns {Point} in pixels of the page */
  pixel(point) {
    return this.eye.toPixel(this.size, point);
  }

  change(findsExposure = false) {
    if (!this.isKnown) return; // the handles are of another entry
    this.layOut();
    this.drawing.draw(findsExposure);
  }

  resized() {
    const { width, height } = this.stage.getBoundingClientRect();
    if (width === 0) return; // it is hidden
    this.size = { width, height };
    if (this.isFitted && !this.press) this.fit();
    else this.change();
  }

  fit() {
    const { rest, current, extent } = this, points = this.isHeld || !extent ? [...current] : [];
    for (const { box: [left, bottom, right, top], corners } of extent?.reach ?? (extent ? [{ box: extent.box, corners: [] }] : [])) {
      const box = [[left, bottom], [right, bottom], [left, top], [right, top]], at = corners.length > 0 ? corners : current;
      points.push(...(this.isHeld ? corners : []), ...(at.length === 3 ? carried(rest, at, box) : box));
    }
    this.look(this.camera.isSpace || points.length === 0 ? this.home : this.home.fitted(points, this.size, margin), true);
    this.isFitted = true;
  }

  /** @param {number[]} area of the plane: its middle, width and height */
  lookAt([x, y, width, height]) {
    const corners = [[x - width / 2, y - height / 2], [x + width / 2, y + height / 2]];
    this.look(this.home.fitted(corners, this.size, 0), true);
  }

  /** @param {Camera} camera */
  look(camera, findsExposure = false) {
    this.camera = camera;
    this.isFitted = this.follows = false;
    this.change(findsExposure);
  }

  reset() {
    this.current = this.rest;
    this.fit();
  }

  /** @param {Point} pixel @param {number} factor */
  zoom(pixel, factor) {
    this.look(this.camera.zoomed(this.size, pixel, factor));
  }

  /** @param {MouseEvent} event @returns {Point} in pixels of the page, from the corner of the stage */
  place(event) {
    const { left, top } = this.stage.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  /** What is held there: the nearest handle that is seen, then an edge or the inside, of the chosen map before others.
   * @param {Point} pixel @param {number} reach @returns {Grip | null} */
  gripUnder(pixel, reach) {
    const held = this.groups.length > 0 ? this.held() : [];
    const isChosen = (/** @type {Held} */ { map }) => map === null || map === this.chosen;
    const allOf = (/** @type {Held} */ { points }) => points.map((_, i) => i);
    const handles = held.flatMap((shown) => [
      ...(isChosen(shown) ? shown.points.map((point, i) => ({ ...shown, point, moving: [i] })) : []),
      ...(shown.map === null ? [] : [{ ...shown, point: middle(shown.points), moving: allOf(shown) }])]);
    const distances = handles.map(({ point }) => Math.hypot(...minus(this.pixel(point), pixel)));
    const least = Math.min(...distances);
    if (least <= reach) return handles[distances.lastIndexOf(least)];
    if (this.camera.isSpace) return null;
    for (const shown of [...held.filter(isChosen), ...held]) {
      const corners = shown.points.map((p) => this.pixel(p)), edge = edgeAt(corners, pixel, reach / 2);
      if (edge >= 0 && shown.map === null) return { ...shown, moving: [edge, (edge + 1) % corners.length] };
      if (edge >= 0 || isInside(pixel, corners)) return { ...shown, moving: allOf(shown) };
    }
    return null;
  }

  /** @param {PointerEvent} event */
  pressed(event) {
    if (event.button !== 0 || !(event.target instanceof Element) || event.target.closest("button")) return;
    const pixel = this.place(event);
    this.pointers.set(event.pointerId, pixel);
    this.stage.setPointerCapture(event.pointerId);
    this.drawing.setLive(true);
    this.press = null;
    if (this.pointers.size > 1) return; // fingers that zoom
    const grip = this.gripUnder(pixel, event.pointerType === "mouse" ? reachOfMouse : reachOfFinger)
      ?? { map: null, row: [], points: this.current, current: this.current, moving: [] };
    const { map, moving } = this.press = { ...grip, pixel, camera: this.camera };
    if (map !== null) {
      this.choose(map);
      this.drawing.pause();
    }
    if (moving.length === 1) this.groups[map ?? 0].querySelector(`[data-corner="${moving[0]}"]`)?.classList.add("held");
  }

  /** Brings what is held to other points. @param {Held} held @param {Point[]} points */
  put({ map, points: before, row, current }, points) {
    if (map === null) {
      const d = this.entry.dimension + 1; // what a motion turns is dragged as it is seen
      this.current = before === current ? points : carried(before.slice(0, d), current.slice(0, d), points);
      if (this.shown) this.shown.corners = points;
      this.change();
      return;
    }
    const inCode = carried(this.placed, this.rest, [...before, ...points]);
    const offsets = before.map((_, i) => minus(inCode[before.length + i], inCode[i]));
    if (!offsets.flat().every(Number.isFinite)) return; // the cage is flat
    this.entry.cage ??= { rest: this.rest, current: this.current, bends: true }; // it stays where it is
    this.changed = this.drawing.changeMap(map, withImagesMoved(row, this.rest, offsets));
  }

  /** @param {PointerEvent} event */
  moved(event) {
    const pixel = this.place(event), before = [...this.pointers.values()];
    if (!this.pointers.has(event.pointerId)) {
      this.stage.classList.toggle("grip", this.gripUnder(pixel, reachOfMouse) !== null);
      return;
    }
    this.pointers.set(event.pointerId, pixel);
    if (this.pointers.size === 2) this.pinch(before, [...this.pointers.values()]);
    else if (this.press) this.drag(this.press, pixel, event);
  }

  /** @param {Point[]} before @param {Point[]} after two fingers */
  pinch(before, after) {
    const spread = (/** @type {Point[]} */ [a, b]) => Math.hypot(...minus(a, b));
    this.camera = this.camera.panned(this.size, minus(middle(after), middle(before)));
    this.zoom(middle(after), spread(after) / Math.max(spread(before), 1));
  }

  /** @param {Press} press @param {Point} pixel @param {{ctrlKey: boolean, altKey: boolean, shiftKey: boolean}} keys */
  drag(press, pixel, keys) {
    const { camera, points, moving } = press, shift = minus(pixel, press.pixel);
    if (moving.length === 0) {
      this.look(this.camera.isSpace ? camera.turned(times(shift, 0.4)) : camera.panned(this.size, shift));
    } else if (this.camera.isSpace) {
      this.shift(press, shift);
    } else {
      const isWhole = moving.length === points.length;
      const mode = isWhole && keys.ctrlKey ? "rotate" : isWhole && keys.altKey ? "scale" : "move";
      const [from, to] = [press.pixel, pixel].map((p) => camera.toWorld(this.size, p));
      this.put(press, dragged(points, moving, mode, from, to, keys.shiftKey));
    }
  }

  /** Moves what is held in the plane of the screen. @param {Grip} grip @param {Point} pixels */
  shift(grip, pixels) {
    const { points, moving } = grip;
    const offset = this.eye.offset(this.size, pixels, middle(moving.map((i) => points[i])));
    this.put(grip, points.map((v, i) => (moving.includes(i) ? plus(v, offset) : v)));
  }

  /** @param {PointerEvent} event @param {boolean} isCancelled */
  released(event, isCancelled) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.press && isCancelled) this.cancel();
    if (this.press && this.press.moving.length > 0) this.say(this.press.map, this.press.moving);
    this.press = null;
    this.svg.querySelectorAll(".held").forEach((handle) => handle.classList.remove("held"));
    if (this.pointers.size === 0) this.drawing.setLive(false);
  }

  cancel() {
    if (!this.press) return;
    const { press } = this;
    this.press = null;
    if (press.moving.length > 0) this.put(press, press.points);
    this.look(press.camera);
  }

  /** Says where a corner or a map is, once it is there. @param {number | null} map @param {number[]} moving */
  async say(map, moving) {
    await this.changed;
    if (map !== null || moving.length === 1) byId("said").textContent = this.name(map, moving.length > 1 ? moving.length : moving[0]);
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
      else if (this.camera.isSpace) this.look(this.camera.turned(times(step, 1 / 2)));
      else if (this.isHeld && !this.holdsMaps && this.current.length > 0) this.moveBy(null, this.current.length, step);
      else this.look(this.camera.panned(this.size, times(step, -1)));
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
    if (map !== null) this.drawing.pause();
    const held = this.held()[map ?? 0];
    const moving = corner < held.points.length ? [corner] : held.points.map((_, i) => i);
    this.shift({ ...held, moving }, pixels);
    this.say(map, moving);
  }
}
