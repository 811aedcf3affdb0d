// SPDX-License-Identifier: MIT
// Plays an entry that moves: a button, a slider of frames, and a clock by which frames are left out rather than shown late.

import { byId } from "./dom.js";
import { filled, language, texts } from "./texts.js";

const longestStep = 250; // milliseconds: after a longer one, as where the page was hidden, time goes on from there

/** Whether the reader of the page wants to see motion. */
export const wantsMotion = () => !matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Player {
  /** @param {() => void} show shows the frame @param {(isPlaying: boolean) => void} changed */
  constructor(show, changed) {
    this.show = show;
    this.changed = changed;
    this.motion = /** @type {Motion | null} */ (null);
    this.frame = -1; // the entry at rest
    this.run = 0; // that is under way, counted from 1; 0 where none is
    this.runs = 0;
    this.isSeen = true;
    this.button = byId("play");
    this.slider = /** @type {HTMLInputElement} */ (byId("time"));
    this.button.addEventListener("click", () => this.toggle());
    this.slider.addEventListener("input", () => {
      this.pause();
      this.go(Number(this.slider.value));
    });
    addEventListener("keydown", (event) => {
      const isOwn = event.target instanceof Element && event.target.closest("button, input:not([type=range])");
      if (event.key !== " " || isOwn || event.ctrlKey || event.altKey || event.metaKey || !this.button.offsetParent) return;
      event.preventDefault();
      if (!event.repeat) this.toggle();
    });
    new IntersectionObserver((seen) => (this.isSeen = seen.some((each) => each.isIntersecting))).observe(byId("stage"));
  }

  /** Shows this motion from its first frame, and plays it to those who want to see it. @param {Motion | null} motion */
  take(motion) {
    this.pause();
    this.motion = motion;
    this.frame = motion ? 0 : -1;
    byId("player").hidden = !motion;
    document.body.toggleAttribute("data-moves", motion !== null);
    this.slider.max = String((motion?.frames ?? 1) - 1);
    this.tell();
    if (motion && wantsMotion()) this.play();
  }

  /** Says which frame is shown. */
  tell() {
    const seconds = new Intl.NumberFormat(language, { minimumFractionDigits: 2, maximumFractionDigits: 2 });
    const said = filled(texts.frame, Math.max(this.frame, 0), seconds.format(Math.max(this.frame, 0) / (this.motion?.rate ?? 1)));
    this.slider.value = String(this.frame);
    this.slider.setAttribute("aria-valuetext", said);
    byId("clock").textContent = said;
    this.button.title = this.button.ariaLabel = this.run ? texts.pause : texts.play;
    this.button.classList.toggle("playing", this.run > 0);
  }

  /** @param {number} frame */
  go(frame) {
    if (frame === this.frame) return;
    this.frame = frame;
    this.tell();
    this.show();
  }

  toggle() {
    if (this.run) this.pause();
    else this.play();
  }

  pause() {
    if (!this.run) return;
    this.run = 0;
    this.tell();
    this.changed(false);
  }

  play() {
    if (!this.motion) return;
    const { rate, frames, isEndless } = this.motion, run = (this.run = ++this.runs);
    if (!isEndless && this.frame >= frames - 1) this.frame = 0;
    let time = this.frame / rate, last = performance.now();
    this.tell();
    this.changed(true);
    const step = (/** @type {number} */ now) => {
      if (this.run !== run) return; // it was paused
      if (!document.hidden && this.isSeen) time += Math.min(Math.max(now - last, 0), longestStep) / 1000;
      last = now;
      const frame = Math.floor(time * rate + 1e-6);
      this.go(isEndless ? frame % frames : Math.min(frame, frames - 1));
      if (!isEndless && frame >= frames - 1) this.pause();
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}
