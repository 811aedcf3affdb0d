// SPDX-License-Identifier: MIT
// Shows a figure where <script src="maple.js"></script> stands in an article. Every figure has a frame, so that the styles of
// the article and its own leave each other alone, and all of them share one worker and so one engine.

/** @param {Figures} figures */
export function embed({ title, page, engine, worker }) {
  const script = document.currentScript;
  if (!script) return; // it is a module, and stands nowhere
  const { entry, title: name, tool } = script.dataset;
  /** @type {Map<string, Worker>} */
  const workers = Reflect.get(window, "barycageWorkers") ?? new Map(); // that of each version of the program
  Reflect.set(window, "barycageWorkers", workers);
  const shared = workers.get(engine + worker) ?? new Worker(URL.createObjectURL(new Blob([worker], { type: "text/javascript" })));
  if (!workers.has(engine + worker)) shared.postMessage({ kind: "start", wasm: engine });
  workers.set(engine + worker, shared);
  const frame = document.createElement("iframe");
  /** @type {Article} */
  const article = { entry, title: name, holdsMaps: tool === "maps",
    worker() {
      const { port1, port2 } = new MessageChannel();
      shared.postMessage(null, [port2]);
      return port1;
    },
    resized(height) {
      frame.style.height = `${height}px`;
    },
  };
  frame.title = name ?? entry ?? title;
  frame.allow = "clipboard-write";
  frame.style.cssText = "display: block; width: 100%; height: 600px; border: 0";
  frame.srcdoc = page;
  script.after(Object.assign(frame, { barycage: article }));
}
