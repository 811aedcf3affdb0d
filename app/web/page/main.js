// SPDX-License-Identifier: MIT
// Puts the page together: the entry it carries, the figure, the table, the palettes and the files it saves.

import { byId, element, save } from "./dom.js";
import { Drawing } from "./drawing.js";
import { readEntry } from "./entry_reader.js";
import { Figure } from "./figure.js";
import { entryText } from "./ifs_text.js";
import { linkData, packed, unpacked } from "./link.js";
import { fillTable } from "./table.js";
import { filled, paletteTitle, spokenLanguage, textsOf } from "./texts.js";

/** @typedef {import("./engine.js").Entry} Entry */
/** @typedef {import("./engine.js").Palette} Palette */
/** What the program has written into the page.
 * @typedef {{entry: Entry, show: string, allow: string[], language: string, points: number}} Content */

const content = /** @type {Content} */ (JSON.parse(byId("content").textContent ?? ""));
const language = content.language || spokenLanguage(navigator.languages);
const texts = textsOf(language);
let { entry } = content; // or that of a link
const isHeld = content.allow.includes("cage"), isTyped = content.allow.includes("code");
let isEdited = false;

/** @param {number} points */
function tellPoints(points) {
  const millions = new Intl.NumberFormat(language, { maximumFractionDigits: 1 }).format(points / 1e6);
  byId("points").textContent = points > 0 ? filled(texts.points, millions) : "";
}

/** @param {string} sentence */
function tell(sentence) {
  byId("problem").textContent = sentence;
}

function speak() {
  document.documentElement.lang = language;
  for (const place of document.querySelectorAll("[data-text]"))
    place.textContent = texts[/** @type {keyof typeof texts} */ (place.getAttribute("data-text"))];
  for (const place of document.querySelectorAll("[data-label]")) {
    const text = texts[/** @type {keyof typeof texts} */ (place.getAttribute("data-label"))];
    place.setAttribute("aria-label", text);
    place.setAttribute("title", text);
  }
  const isTouch = matchMedia("(pointer: coarse)").matches;
  const hints = entry.dimension === 3 ? [texts.turn, texts.deform] : ["", isTouch ? texts.touch : texts.drag];
  byId("hint").textContent = hints.slice(0, isHeld ? 2 : 1).join(" ");
}

function failed() {
  document.body.dataset.state = "still";
  byId("plain").textContent = texts.failed;
}

/** Takes up the entry of the link by which the page was opened, if there is one.
 * @param {Palette[]} palettes @param {boolean} knowsSpace whether the engine draws solids */
async function takeLink(palettes, knowsSpace) {
  if (location.hash.length < 2) return;
  const found = await unpacked(location.hash.slice(1)).catch(() => ({ flaw: /** @type {const} */ ("linkForeign") }));
  const read = "text" in found ? readEntry(found.text, palettes) : found;
  if ("flaw" in read || (read.entry.dimension === 3 && !knowsSpace)) {
    byId("notice").textContent = texts["flaw" in read ? read.flaw : "linkForeign"];
    return;
  }
  entry = read.entry;
  document.title = entry.name;
  document.querySelector("h1")?.replaceChildren(entry.name);
  document.querySelector(".caption")?.replaceChildren(); // it is of the other entry
  const [red, green, blue, alpha] = entry.appearance?.background ?? [13, 16, 23, 255];
  byId("stage").style.background = `rgb(${red} ${green} ${blue} / ${alpha / 255})`;
  speak();
}

/** @param {Figure} figure */
async function copyLink(figure) {
  const data = await packed(entryText(entry, figure.rest, figure.current, isEdited));
  const field = /** @type {HTMLInputElement} */ (byId("link")), said = byId("copied");
  field.hidden = true;
  said.textContent = "";
  if (data === null) said.textContent = texts.linkTooLong;
  else {
    const hasAddress = ["http:", "https:", "file:"].includes(location.protocol);
    field.value = (hasAddress ? `${location.href.replace(/#.*/, "")}#` : "barycage:") + data;
    try {
      await navigator.clipboard.writeText(field.value);
      said.textContent = texts.copied;
    } catch {
      field.hidden = false;
      field.select();
      said.textContent = texts.copyThis;
    }
  }
}

function listenForLinks() {
  addEventListener("hashchange", () => location.reload());
  document.addEventListener("paste", (event) => {
    const data = event.target instanceof HTMLInputElement ? "" : linkData(event.clipboardData?.getData("text/plain") ?? "");
    if (data) location.hash = data;
  });
}

/** @param {{width?: number, height?: number, pixels?: Uint8ClampedArray<ArrayBuffer>, samples?: number}} picture */
function showPicture({ width = 0, height = 0, pixels, samples = 0 }) {
  const canvas = /** @type {HTMLCanvasElement} */ (byId("canvas"));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  if (pixels) canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
  document.body.dataset.state = "live";
  tellPoints(samples);
}

/** @param {Palette[]} palettes @param {(palette: Palette) => void} choose */
function fillPalettes(palettes, choose) {
  const given = JSON.stringify(entry.appearance?.stops ?? palettes[0].stops);
  byId("palettes").replaceChildren(...palettes.map((palette) => {
    const title = paletteTitle(palette.name, language);
    const swatch = element("button", { type: "button", role: "radio", class: "swatch", "aria-label": title, title,
      "aria-checked": String(JSON.stringify(palette.stops) === given) });
    swatch.style.backgroundImage = `linear-gradient(90deg, ${palette.stops.map(([at, r, g, b]) =>
      `rgb(${r} ${g} ${b}) ${100 * at}%`).join()})`;
    swatch.addEventListener("click", () => {
      for (const other of byId("palettes").children) other.setAttribute("aria-checked", String(other === swatch));
      choose(palette);
    });
    return swatch;
  }));
}

/** @param {Drawing} drawing @param {Figure} figure */
function connect(drawing, figure) {
  const load = async () => {
    const { extent } = await drawing.ask({ kind: "load", entry });
    tell(extent ? "" : texts.noAttractor);
    figure.hold(extent ?? null);
  };
  let isLoading = false, isOld = false;
  const reload = async () => {
    isOld = true;
    if (isLoading) return;
    isLoading = true;
    while (isOld) {
      isOld = false;
      await load();
    }
    isLoading = false;
  };
  fillTable(byId("maps"), entry, texts, isTyped, () => {
    isEdited = true;
    reload();
  }, tell);
  byId("reset").addEventListener("click", () => figure.reset());
  byId("fit").addEventListener("click", () => figure.fit());
  byId("png").addEventListener("click", () => {
    const canvas = /** @type {HTMLCanvasElement} */ (byId("canvas"));
    canvas.toBlob((blob) => blob && save(blob, `${entry.name}.png`));
  });
  byId("ifs").addEventListener("click", () =>
    save(new Blob([entryText(entry, figure.rest, figure.current, isEdited)], { type: "text/plain" }), `${entry.name}.ifs`));
  byId("copy-link").addEventListener("click", () => copyLink(figure));
  return load;
}

async function start() {
  speak();
  listenForLinks();
  const source = new Blob([byId("worker").textContent ?? ""], { type: "text/javascript" });
  const worker = new Worker(URL.createObjectURL(source));
  /** @type {Figure} */
  let figure;
  const drawing = new Drawing(worker, () => ({ ...figure.size, ratio: Math.min(devicePixelRatio, 2),
    view: figure.view(), rest: figure.rest, current: figure.current, bends: entry.cage?.bends ?? true }),
    showPicture, failed, content.points);
  const { palettes = [], versions, knowsSpace = false } =
    await drawing.ask({ kind: "start", wasm: byId("engine").textContent ?? "" });
  await takeLink(palettes, knowsSpace);
  let isReady = false;
  figure = new Figure(entry, texts, language, isHeld, {
    draw: (findsExposure) => isReady && drawing.begin(findsExposure),
    setLive: (isLive) => drawing.setLive(isLive),
  });
  const load = connect(drawing, figure);
  fillPalettes(palettes, async (palette) => {
    entry.palette = palette.name;
    entry.appearance = { ...entry.appearance, stops: palette.stops };
    await drawing.ask({ kind: "look", appearance: entry.appearance });
    drawing.begin();
  });
  isReady = true;
  await load();
  // For tests, and for the curious.
  Object.assign(window, { barycage: { drawing, figure, entry, versions } });
}

start().catch(failed);
