// SPDX-License-Identifier: MIT
// The conversation with the worker: one request at a time, the newest wins, and a picture at rest is refined.

const liveMilliseconds = 11; // for a picture of a drag
const refinedAtOnce = 40; // milliseconds, for one of those that follow

export class Drawing {
  /** @param {Worker | MessagePort} worker @param {() => Scene} scene @param {(answer: Answer) => void} show
   * @param {() => void} fail @param {number} enough points of a picture at rest */
  constructor(worker, scene, show, fail, enough) {
    this.worker = worker;
    this.scene = scene;
    this.show = show;
    this.enough = enough;
    this.waiting = /** @type {((answer: Answer) => void)[]} */ ([]);
    this.isBusy = false; // with a picture
    this.isStopped = false; // until it begins again
    this.isStale = false; // the newest picture is not of the scene as it is
    this.isLive = false; // in a drag, or while it plays
    this.goal = liveMilliseconds;
    this.findsExposure = true;
    this.live = 4e5; // points of a picture of a drag
    this.liveRatio = 1; // of the resolution
    this.refined = 1e6;
    this.total = 0;
    this.drawn = 0; // pictures
    this.isCoarse = false; // the newest picture has less than the resolution of the screen
    this.size = { width: 1, height: 1 }; // of the newest picture, in its pixels
    this.view = /** @type {number[]} */ ([]);
    worker.onmessage = (/** @type {MessageEvent<Answer>} */ event) => {
      if (event.data.failure) fail();
      else this.waiting.shift()?.(event.data);
    };
  }

  /** @param {Question} request @returns {Promise<Answer>} */
  ask(request) {
    this.worker.postMessage(request);
    return new Promise((answered) => this.waiting.push(answered));
  }

  /** Draws the scene as it is now. @param {boolean} findsExposure whether its brightness is found anew */
  begin(findsExposure = false) {
    this.findsExposure ||= findsExposure;
    this.isStale = true;
    this.isStopped = false;
    if (!this.isBusy) this.next();
  }

  /** Lets the engine do something else: what is drawn now is the last picture. */
  stop() {
    this.isStopped = true;
    this.isStale = false;
  }

  next() {
    if (this.isStopped) return;
    if (!this.isStale && (this.isLive || this.total === 0 || this.total >= this.enough)) return;
    const scene = this.scene();
    const begin = this.isStale;
    if (begin) {
      const ratio = scene.ratio * (this.isLive ? this.liveRatio : 1);
      this.isCoarse = ratio < scene.ratio;
      this.size = { width: Math.max(1, Math.round(scene.width * ratio)), height: Math.max(1, Math.round(scene.height * ratio)) };
      this.view = [...scene.view];
      if (this.view.length < 7) this.view[2] *= ratio;
    }
    const { width, height } = this.size;
    const samples = Math.round(begin ? this.live : this.refined);
    const wasLive = this.isLive;
    const keepExposure = !this.findsExposure;
    this.isStale = this.findsExposure = false;
    this.isBusy = true;
    this.ask({ kind: "draw", width, height, view: this.view, rest: scene.rest, current: scene.current,
      bends: scene.bends, frame: scene.frame, follows: scene.follows, samples, begin, keepExposure }).then((answer) => {
      this.isBusy = false;
      this.total = answer.samples ?? 0;
      ++this.drawn;
      this.adapt(answer.milliseconds ?? 0, begin, wasLive);
      this.show(answer);
      this.next();
    });
  }

  /** @param {number} milliseconds @param {boolean} begin @param {boolean} wasLive */
  adapt(milliseconds, begin, wasLive) {
    const factor = (/** @type {number} */ goal) => Math.min(2, Math.max(0.5, goal / Math.max(milliseconds, 0.5)));
    if (!begin) this.refined = Math.min(5e6, Math.max(2e5, this.refined * factor(refinedAtOnce)));
    else this.live = Math.min(3e6, Math.max(1e5, this.live * factor(this.goal)));
    if (wasLive && milliseconds > 3 * this.goal) this.liveRatio = Math.max(0.5, this.liveRatio * 0.8);
    else if (wasLive && milliseconds < this.goal) this.liveRatio = Math.min(1, this.liveRatio * 1.1);
  }

  /** Once the picture is at rest and has all of its points. */
  async rested() {
    while (this.isBusy || this.isStale || (this.total > 0 && this.total < this.enough)) await new Promise((on) => setTimeout(on, 20));
  }

  /** A drag or an animation begins or ends. @param {boolean} isLive @param {number} goal milliseconds for a picture */
  setLive(isLive, goal = liveMilliseconds) {
    this.isLive = isLive;
    this.goal = goal;
    if (!isLive && this.isCoarse) this.begin();
    else if (!this.isBusy) this.next();
  }
}
