// SPDX-License-Identifier: MIT
// The steps of a lesson: a text above the figure, and the way back and on.

import { byId, element } from "./dom.js";
import { texts } from "./texts.js";

export class Lesson {
  /** @param {string} title @param {Step[]} steps @param {(step: Step) => void} show */
  constructor(title, steps, show) {
    this.steps = steps;
    this.show = show;
    this.step = 0;
    this.heading = element("h2");
    this.text = element("p", { class: "caption" });
    this.place = element("span", { class: "place" });
    const button = (/** @type {string} */ text, /** @type {number} */ by) => {
      const made = element("button", { type: "button", id: by > 0 ? "next" : "previous" }, [text]);
      made.addEventListener("click", () => this.go(this.step + by));
      return made;
    };
    this.previous = button(texts.back, -1);
    this.next = button(texts.next, 1);
    const section = byId("lesson");
    section.append(element("p", { class: "status" }, [title, this.place]),
      element("div", { "aria-live": "polite" }, [this.heading, this.text]), element("div", { class: "files" }, [this.previous, this.next]));
    section.setAttribute("aria-label", title);
    section.hidden = false;
    addEventListener("keydown", (event) => { // the keys of presenters
      const by = event.key === "PageDown" ? 1 : event.key === "PageUp" ? -1 : 0;
      if (by === 0 || event.target instanceof HTMLInputElement) return;
      event.preventDefault();
      this.go(this.step + by);
    });
  }

  /** @param {number} step */
  go(step) {
    const shown = this.steps[step];
    if (!shown) return;
    this.step = step;
    this.heading.textContent = shown.title;
    this.text.textContent = shown.text;
    this.place.textContent = `${step + 1} / ${this.steps.length}`;
    this.previous.setAttribute("aria-disabled", String(step === 0)); // and keep the focus
    this.next.setAttribute("aria-disabled", String(step === this.steps.length - 1));
    this.show(shown);
  }
}
