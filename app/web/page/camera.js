// SPDX-License-Identifier: MIT
// How a picture is looked at, in the plane or in space. A camera is a value: what changes it gives another one. Pixels are
// those of the page, from the upper left of the picture.

import { dot, minus, plus, times } from "./geometry.js";

const least = 1e-12, greatest = 1e12; // of heights

export class Camera {
  /** @param {Point} target in the middle of the picture @param {number} height in world units, of a picture as wide as high:
   *   others show all of it @param {number} azimuth in degrees, as elevation and field of view, 0 for parallel rays */
  constructor(target, height, azimuth = 0, elevation = 0, field = 0) {
    this.target = target;
    this.height = height;
    this.azimuth = azimuth;
    this.elevation = elevation;
    this.field = field;
    this.turn = [0, 0]; // in the plane: radians, and whether y points down
    this.frame = /** @type {ReturnType<Camera["axes"]> | null} */ (null); // in space: that of keys and motions
  }

  get isSpace() {
    return this.target.length === 3;
  }

  /** @param {Partial<Camera>} changes @returns {Camera} */
  with(changes) {
    return Object.assign(Object.create(Camera.prototype), this, changes);
  }

  /** Seen from the same direction, all points with a margin, given as a part of the picture.
   * @param {Point[]} points @param {Size} size @param {number} margin */
  fitted(points, size, margin) {
    const target = this.target.map((_, i) => {
      const all = points.map((p) => p[i]);
      return (Math.min(...all) + Math.max(...all)) / 2;
    });
    const { right, up } = this.axes();
    const reach = (/** @type {Point} */ axis) => 2 * Math.max(...points.map((p) => Math.abs(dot(minus(p, target), axis))));
    const unitsPerPixel = Math.max(reach(right) / size.width, reach(up) / size.height) / (1 - 2 * margin);
    const height = unitsPerPixel * Math.min(size.width, size.height);
    return this.with({ target, height: height > 0 && height < Infinity ? height : this.height });
  }

  /** The one that keys and motions set. @param {number[]} numbers as barycage_shown() has them @param {Size} size @returns {Camera} */
  moved(numbers, { width, height }) {
    if (!this.isSpace) {
      const [x, y, all, isDown, rotation] = numbers;
      return this.with({ target: [x, y], height: all * Math.min(1, width / height), turn: [rotation, isDown] });
    }
    const [target, right, up, eye] = [0, 3, 6, 9].map((at) => numbers.slice(at, at + 3)), away = times(eye, -1);
    return this.with({ target, frame: { right, up, away }, height: numbers[12] / Math.max(1, height / width), field: numbers[13],
      azimuth: (Math.atan2(eye[0], eye[2]) * 180) / Math.PI, elevation: (Math.asin(Math.max(-1, Math.min(1, eye[1]))) * 180) / Math.PI });
  }

  /** To the right, up, and away from the eye. @returns {{right: Point, up: Point, away: Point}} */
  axes() {
    if (this.frame) return this.frame;
    if (!this.isSpace) {
      const [angle, isDown] = this.turn, c = Math.cos(angle), s = Math.sin(angle), sign = isDown ? -1 : 1;
      return { right: [c, -sign * s], up: [s, sign * c], away: [0, 0] };
    }
    const a = (this.azimuth * Math.PI) / 180, e = (this.elevation * Math.PI) / 180;
    return { right: [Math.cos(a), 0, -Math.sin(a)],
      up: [-Math.sin(a) * Math.sin(e), Math.cos(e), -Math.cos(a) * Math.sin(e)],
      away: [-Math.sin(a) * Math.cos(e), -Math.sin(e), -Math.cos(a) * Math.cos(e)] };
  }

  /** How many pixels a unit has where a point is. @param {Size} size @param {Point} point */
  scale(size, point = this.target) {
    const scale = Math.min(size.width, size.height) / this.height;
    if (!(this.field > 0)) return scale;
    const distance = size.height / scale / (2 * Math.tan((this.field * Math.PI) / 360));
    const depth = dot(minus(point, this.target), this.axes().away);
    return distance + depth > 0 ? (scale * distance) / (distance + depth) : Infinity;
  }

  /** @param {Size} size @param {Point} point @returns {Point} */
  toPixel(size, point) {
    const { right, up } = this.axes(), seen = times(minus(point, this.target), this.scale(size, point));
    return [size.width / 2 + dot(seen, right), size.height / 2 - dot(seen, up)];
  }

  /** By how much a point moves that follows the pointer in the plane of the screen.
   * @param {Size} size @param {Point} pixels @param {Point} point @returns {Point} */
  offset(size, [x, y], point = this.target) {
    const { right, up } = this.axes(), scale = this.scale(size, point);
    return plus(times(right, x / scale), times(up, -y / scale));
  }

  /** What is there, as near or far as the target. @param {Size} size @param {Point} pixel */
  toWorld(size, pixel) {
    return plus(this.target, this.offset(size, minus(pixel, [size.width / 2, size.height / 2])));
  }

  /** @param {Size} size @param {Point} pixels */
  panned(size, pixels) {
    return this.with({ target: minus(this.target, this.offset(size, pixels)) });
  }

  /** In the plane, what is under the pixel stays there. @param {Size} size @param {Point} pixel @param {number} factor */
  zoomed(size, pixel, factor) {
    const zoomed = this.with({ height: Math.min(Math.max(this.height / factor, least), greatest) });
    if (this.isSpace) return zoomed;
    return zoomed.with({ target: plus(this.target, minus(this.toWorld(size, pixel), zoomed.toWorld(size, pixel))) });
  }

  /** As a hand turns what it sees. @param {Point} degrees to the right and down */
  turned([x, y]) {
    return this.with({ frame: null, azimuth: (this.azimuth - x) % 360, elevation: Math.min(90, Math.max(-90, this.elevation + y)) });
  }

  /** As barycage_camera() has it. @param {Size} size */
  numbers(size) {
    if (!this.isSpace) return [...this.target, this.scale(size), ...this.turn];
    return [...this.target, this.azimuth, this.elevation, this.height * Math.max(1, size.height / size.width), this.field];
  }
}
