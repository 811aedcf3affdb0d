// SPDX-License-Identifier: MIT
// Puts the page together: the entry it carries, the figure, the table, the palettes and the files it saves.

import { backgroundOf, byId, coloured, element, save, showPixels } from "./dom.js";
import { Drawing } from "./drawing.js";
import { readEntry } from "./entry_reader.js";
import { Figure } from "./figure.js";
import { Gallery } from "./gallery.js";
import { entryText } from "./ifs_text.js";
import { Lesson } from "./lesson.js";
import { linkData, packed, unpacked } from "./link.js";
import { Player } from "./player.js";
import { fillTable } from "./table.js";
import { filled, language, texts } from "./texts.js";

const content = /** @type {Content} */ (JSON.parse(byId("content").textContent ?? ""));
/** @type {Article | undefined} the one that shows the page by a script: embed.js */
const article = Reflect.get(frameElement ?? {}, "barycage");
const entries = article && !content.steps ? undefined : content.entries; // of a gallery or of a lesson
let entry = content.entries?.find(({ name }) => name === article?.entry) ?? content.entries?.[0] ?? content.entry; // or that of a link, or one that is chosen
let first = structuredClone(entry); // as it was shown first
const [isHeld, isDragged, isTyped] = ["cage", "maps", "code"].map((edit) => content.allow.includes(edit));
let isEdited = false;
const playedMilliseconds = 24; // for a picture of an animation

function speak() {
  document.documentElement.lang = language;
  const textOf = (/** @type {string | undefined} */ key) => String(texts[/** @type {keyof typeof texts} */ (key)]);
  for (const place of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-text], [data-label]"))) {
    const { text, label } = place.dataset;
    if (text) place.textContent = textOf(text);
    else place.title = place.ariaLabel = textOf(label);
  }
}

/** @param {Figure} figure */
function speakOfEntry({ holdsMaps, hasMaps, isHeld }) {
  const isTouch = matchMedia("(pointer: coarse)").matches, isSolid = entry.dimension === 3;
  const maps = isTouch || isSolid ? texts.touchMap : texts.dragMap;
  const cage = !isHeld ? "" : isSolid ? texts.deform : isTouch ? texts.touch : texts.drag;
  byId("hint").textContent = `${isSolid ? texts.turn : ""} ${holdsMaps ? maps : cage}`;
  byId("hold-maps").hidden = !isDragged || !hasMaps;
  byId("hold-maps").setAttribute("aria-pressed", String(holdsMaps));
}

function failed() {
  document.body.dataset.state = "still";
  byId("plain").textContent = texts.failed;
  byId("plain").hidden = false;
}

/** The entry of the text in the page, or of the link by which it was opened, if there is one that can be shown.
 * @param {Palette[]} palettes @param {boolean} knowsSpace whether the engine draws solids @returns {Promise<Entry | null>} */
async function linkedEntry(palettes, knowsSpace) {
  if (location.hash.length < 2 && content.text === undefined) return null;
  const found = content.text !== undefined ? { text: content.text }
    : await unpacked(location.hash.slice(1)).catch(() => ({ flaw: /** @type {const} */ ("linkForeign") }));
  const read = "text" in found ? readEntry(found.text, palettes) : found;
  if ("entry" in read && (read.entry.dimension === 2 || knowsSpace)) return read.entry;
  byId("notice").textContent = texts["flaw" in read ? read.flaw : "linkForeign"];
  return null;
}

/** Shows this entry in place of the one that the program has put here. @param {Entry} shown */
function takeEntry(shown) {
  entry = shown;
  first = structuredClone(shown);
  if (isEdited) byId("notice").textContent = "";
  isEdited = false;
  document.title = entry.name;
  byId("name").textContent = entry.name;
  byId("caption").textContent = ""; // it is of the other entry
  byId("stage").style.background = backgroundOf(entry);
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

/** @param {Answer} picture */
function showPicture({ width = 0, height = 0, pixels, samples = 0 }) {
  if (pixels) showPixels(/** @type {HTMLCanvasElement} */ (byId("canvas")), pixels, width, height);
  document.body.dataset.state = "live";
  const millions = new Intl.NumberFormat(language, { maximumFractionDigits: 1 }).format(samples / 1e6);
  byId("points").textContent = samples > 0 ? filled(texts.points, millions) : "";
}

/** @param {Palette[]} palettes @param {(palette: Palette) => void} choose */
function fillPalettes(palettes, choose) {
  const given = JSON.stringify(entry.appearance?.stops ?? palettes[0].stops);
  byId("palettes").replaceChildren(...palettes.map((palette, i) => {
    const title = texts.palettes[i] ?? palette.name;
    const swatch = element("button", { type: "button", role: "radio", class: "swatch", "aria-label": title, title,
      "aria-checked": String(JSON.stringify(palette.stops) === given) });
    swatch.style.backgroundImage = `linear-gradient(90deg, ${palette.stops.map(([at, ...colour]) =>
      `${coloured(colour)} ${100 * at}%`).join()})`;
    swatch.addEventListener("click", () => {
      for (const other of byId("palettes").children) other.setAttribute("aria-checked", String(other === swatch));
      choose(palette);
    });
    return swatch;
  }));
}

/** @param {Drawing} drawing @param {Figure} figure @param {Player} player @param {Palette[]} palettes
 * @returns {{showEntry: () => Promise<void>, showNumbers: () => void, changeMap: (map: number, to: Row) => Promise<void>}} what
 *   shows the entry of the page, and the numbers of its maps, and what drags a map of it */
function connect(drawing, figure, player, palettes) {
  /** @type {{map: number, to: Row} | undefined} */
  let next;
  let showNumbers = () => {};
  /** What a map must be at rest to be this at the moment. @param {number} map @param {Row} row */
  const stillRow = async (map, row) =>
    figure.motion ? (await drawing.ask({ kind: "still", map, row, frame: player.frame })).row ?? row : row;
  /** Shows the table of the entry, once it is known what keys move. @param {Motion | null} motion */
  const showMotion = (motion) => {
    /** @param {number} map */
    const typed = async (map) => {
      isEdited = true;
      if (figure.shown) entry.maps[map] = await stillRow(map, figure.shown.rows[map]);
      reload();
    };
    showNumbers = fillTable(byId("maps"), entry, () => figure.shown?.rows ?? entry.maps,
      (map) => (isTyped && !motion?.movesMap[map] ? typed : null), (sentence) => (byId("problem").textContent = sentence));
    byId("palettes").closest("section")?.toggleAttribute("hidden", motion?.movesLook ?? false);
    if (motion?.movesCamera) player.show();
  };
  const load = async () => {
    const loaded = entry, taken = next;
    next = undefined;
    const change = taken && { map: taken.map, to: await stillRow(taken.map, taken.to), from: entry.maps[taken.map] };
    const { extent = null, row, isStopped, motion = figure.motion } = await drawing.ask({ kind: "load", entry, change });
    if (loaded !== entry) return;
    if (extent && change) extent.reach = figure.extent?.reach;
    const sentence = isStopped ? texts.stopped : extent ? "" : texts.noAttractor;
    byId("problem").textContent = change ? "" : sentence;
    if (isEdited) byId("notice").textContent = change ? sentence : "";
    if (change) {
      Object.assign(entry.maps[change.map], row);
      showNumbers();
    }
    const isNew = !figure.isKnown;
    if (isNew) player.take(motion);
    figure.hold(extent, motion);
    if (isNew) showMotion(motion);
    speakOfEntry(figure);
  };
  let isOld = false;
  let loading = /** @type {Promise<void> | null} */ (null);
  const reload = () => {
    isOld = true;
    return loading ??= (async () => {
      while (isOld) {
        isOld = false;
        await load();
      }
      loading = null;
    })();
  };
  const showEntry = async () => {
    drawing.stop();
    player.take(null);
    figure.take(entry);
    fillPalettes(palettes, async (palette) => {
      entry.palette = palette.name;
      entry.appearance = { ...entry.appearance, stops: palette.stops };
      await drawing.ask({ kind: "look", appearance: entry.appearance });
      drawing.begin();
    });
    await load();
  };
  byId("hold-maps").addEventListener("click", () => {
    figure.setHoldsMaps(!figure.holdsMaps);
    speakOfEntry(figure);
  });
  byId("reset").addEventListener("click", async () => {
    if (isEdited) {
      entry = { ...structuredClone(first), appearance: entry.appearance, palette: entry.palette };
      isEdited = false;
      byId("notice").textContent = "";
      await showEntry();
    }
    figure.reset();
  });
  byId("fit").addEventListener("click", () => figure.fit());
  byId("maps").addEventListener("focusin", () => player.pause());
  byId("png").addEventListener("click", async () => {
    const canvas = /** @type {HTMLCanvasElement} */ (byId("canvas")), name = entry.name + (figure.motion ? ` ${player.frame}` : "");
    player.pause();
    if (figure.motion) await drawing.rested();
    canvas.toBlob((blob) => blob && save(blob, `${name}.png`));
  });
  byId("ifs").addEventListener("click", () =>
    save(new Blob([entryText(entry, figure.rest, figure.current, isEdited)], { type: "text/plain" }), `${entry.name}.ifs`));
  byId("copy-link").addEventListener("click", () => copyLink(figure));
  return { showEntry, showNumbers: () => showNumbers(), changeMap(map, to) {
    next = { map, to };
    isEdited = true;
    return reload();
  } };
}

/** The gallery of a collection, a click in which leads to a figure, and the browser's Back from there.
 * @param {Entry[]} entries @param {Drawing} drawing @param {Player} player @param {() => Promise<void>} showEntry
 * @param {boolean} isLinked whether the figure is shown first */
function openGallery(entries, drawing, player, showEntry, isLinked) {
  const title = content.title ?? "";
  const gallery = new Gallery(entries, title, content.caption ?? "", drawing, (index) => {
    history.pushState({ entry: index }, "");
    open(index);
  });
  let shown = /** @type {number | null} */ (null);
  const open = (/** @type {number} */ index) => {
    shown = index;
    gallery.hide();
    takeEntry(structuredClone(entries[index]));
    byId("name").focus();
    showEntry();
  };
  const close = () => {
    player.pause();
    drawing.stop();
    document.title = title;
    gallery.show(shown);
  };
  byId("back").hidden = false;
  byId("back").addEventListener("click", () => (history.state?.entry === undefined ? close() : history.back()));
  const showStated = () => { // also of a page that is opened again
    const index = history.state?.entry;
    if (entries[index]) open(index);
    else close();
  };
  addEventListener("popstate", showStated);
  if (isLinked) gallery.hide();
  else showStated();
}

/** The lesson of a collection. Each step begins with the entry as it was.
 * @param {Entry[]} entries @param {Step[]} steps @param {Figure} figure @param {() => Promise<void>} showEntry */
function openLesson(entries, steps, figure, showEntry) {
  const { title = "", caption = "" } = content;
  new Lesson(title, steps, async (step) => {
    const own = structuredClone(entries[step.entry]);
    takeEntry(own);
    document.title = `${step.title} – ${title}`;
    byId("caption").textContent = caption;
    await showEntry();
    if (entry !== own) return; // another step is shown
    figure.setHoldsMaps(step.maps && isDragged);
    if (step.area) figure.lookAt(step.area);
    speakOfEntry(figure);
  }).go(0);
}

/** Fits the page into an article, which shows all of its height. @param {Article} article */
function settleIn(article) {
  document.body.dataset.place = "article";
  new ResizeObserver(() => article.resized(Math.ceil(document.body.getBoundingClientRect().height))).observe(document.body);
  if (content.entries && !content.steps) {
    byId("still").remove(); // of another entry
    takeEntry(entry);
  }
  if (article.title) byId("name").textContent = article.title;
}

function ownWorker() {
  const source = new Blob([byId("worker").textContent ?? ""], { type: "text/javascript" });
  const worker = new Worker(URL.createObjectURL(source));
  worker.onerror = failed;
  return worker;
}

async function start() {
  byId("plain").hidden = true; // here are scripts
  speak();
  listenForLinks();
  if (article) settleIn(article);
  /** @type {Figure} */
  let figure;
  /** @type {Player} */
  let player;
  const drawing = new Drawing(article?.worker() ?? ownWorker(), () => ({ ...figure.size, ratio: Math.min(devicePixelRatio, 2),
    view: figure.camera.numbers(figure.size), rest: figure.rest, current: figure.current, bends: entry.cage?.bends ?? true,
    frame: player.frame, follows: figure.follows }), (answer) => {
    showPicture(answer);
    if (!answer.shown || !figure.isKnown) return; // or it is of the entry before
    figure.takeShown(answer.shown);
    showNumbers();
  }, failed, content.points);
  const { palettes = [], versions, knowsSpace = false } =
    await drawing.ask({ kind: "start", wasm: byId("engine").textContent ?? "" });
  const linked = await linkedEntry(palettes, knowsSpace);
  if (linked) takeEntry(linked);
  figure = new Figure(entry, isHeld, {
    draw: (findsExposure) => document.body.dataset.view !== "gallery" && drawing.begin(findsExposure),
    setLive: (isLive) => player.run || drawing.setLive(isLive),
    changeMap: (map, row) => changeMap(map, row),
    pause: () => player.pause(),
  });
  player = new Player(() => {
    figure.follows = figure.motion?.movesCamera ?? false;
    drawing.begin();
  }, (isPlaying) => drawing.setLive(isPlaying || figure.pointers.size > 0, isPlaying ? playedMilliseconds : undefined));
  const { showEntry, showNumbers, changeMap } = connect(drawing, figure, player, palettes);
  // For tests, and for the curious.
  Object.assign(window, { barycage: { drawing, figure, player, versions, get entry() { return entry; } } });
  if (entries) document.body.dataset.state = "live";
  if (content.steps && entries && !linked) openLesson(entries, content.steps, figure, showEntry);
  else if (entries && !content.steps) openGallery(entries, drawing, player, showEntry, linked !== null);
  if (!entries || linked) await showEntry();
  if (article?.holdsMaps && isDragged) {
    figure.setHoldsMaps(true);
    speakOfEntry(figure);
  }
}

start().catch(failed);
