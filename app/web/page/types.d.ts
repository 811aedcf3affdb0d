// SPDX-License-Identifier: MIT
// What the program writes into a page (model/io/page), and what page and worker tell each other. Programs and pages never
// see this file: it is for the type checker and for people.

type Point = number[]; // two or three coordinates
type Size = { width: number; height: number }; // in pixels of the page
/** A map: its matrix by rows, its translation and its weight, null where none is given. */
type Row = (number | null)[];
type Cage = { rest: Point[]; current: Point[]; bends: boolean };
type Palette = { name: string; stops: number[][] };
/** Of an entry; and of one that moves, what its picture reaches at several moments: boxes, and the corners of a cage that moves. */
type Extent = { box: number[]; simplex: Point[]; reach?: { box: number[]; corners: Point[] }[] };
/** What moves in an entry: how many frames there are in a second and in a round, and what keys set; “turns” is a motion. */
type Motion = { rate: number; length: number; frames: number; isEndless: boolean; movesCage: boolean; movesCamera: boolean;
  movesLook: boolean; turns: boolean; movesMap: boolean[] };
/** What a picture of an entry that moves shows; the camera is that of barycage_shown(). */
type Shown = { rows: Row[]; corners: Point[]; camera: number[] | null };

/** An entry of a collection. */
interface Entry {
  name: string;
  dimension: number; // 2 or 3
  maps: Row[];
  links?: number[][];
  symmetry?: { group: number; order: number; angle: number; centre: Point; frame: number[] };
  branches?: { word: number[]; change: number[] }[];
  cage?: Cage;
  appearance?: Appearance;
  solid?: Solid;
  view?: number[];
  box?: number[]; // of what is shown in the plane: least and greatest coordinates
  palette?: string; // of those of the program, chosen on the page
  text?: { begin: string; lines: string[]; rows: string[] }; // as a collection has it
}

/** In space: attractor::LookInSpace and SolidColour; clip is a normal and two heights, null without end. */
type Solid = { look: number; colour: number; light: number[]; fog: number; clip?: (number | null)[] };

interface Appearance {
  colourBy?: number;
  brightness?: number;
  gamma?: number;
  contrast?: number;
  vibrancy?: number;
  supersample?: number;
  plain?: number[];
  background?: number[];
  stops?: number[][];
  mapColours?: [number, number[]][];
  mapBlends?: [number, number, number][];
}

/** What can be dragged, as it is shown: the cage, or a map as its image of the cage; and the cage as it is placed. */
type Held = { map: number | null; row: Row; points: Point[]; current: Point[] };
/** What of it moves: indices of points. Where nothing moves, it is the view. */
type Grip = Held & { moving: number[] };
/** What the pointer has pressed, as it was then. */
type Press = Grip & { pixel: Point; camera: import("./camera.js").Camera };
type Mode = "move" | "rotate" | "scale";
/** What is to be drawn: sizes in pixels of the page, and of the screen for each of them. */
type Scene = Size & Cage & { ratio: number; view: number[]; frame: number; follows: boolean };
/** Why there is no text in a link. */
type LinkFlaw = "linkCut" | "linkDamaged" | "linkTooLarge";

/** A step of a lesson shows an entry by its index, and of the plane an area: its middle, width and height. */
type Step = { title: string; text: string; entry: number; maps: boolean; area?: number[] };
/** The content of a page: an entry, a gallery or a lesson. */
interface Content {
  entry: Entry;
  text?: string; // of the entry, in a notebook
  entries?: Entry[];
  steps?: Step[];
  title?: string;
  caption?: string;
  allow: string[];
  points: number;
}

/** What a script for articles holds: the page of its figures, and what draws them. */
type Figures = { title: string; page: string; engine: string; worker: string };
/** What a figure in an article knows of it: the entry that it is to show, if there are several, and how. */
interface Article {
  entry?: string;
  title?: string; // in place of the name of the entry
  holdsMaps: boolean; // its maps can be dragged first, not its cage
  worker(): MessagePort;
  resized(height: number): void;
}

/** A map that is dragged: its row as it is shown, and where the hand is. */
type Change = { map: number; from: Row; to: Row };
/** What the page asks of the worker; cage and camera are those of the moment. */
type Question =
  | { kind: "start"; wasm: string }
  | { kind: "load"; entry: Entry; change?: Change }
  | { kind: "look"; appearance: Appearance }
  | { kind: "still"; map: number; row: Row; frame: number }
  | { kind: "thumbnail"; entry: Entry; width: number; height: number; samples: number; frame?: number }
  | (Cage & { kind: "draw"; width: number; height: number; view: number[]; frame: number; follows: boolean; samples: number;
      begin: boolean; keepExposure: boolean });
/** What the worker answers, and what it cannot. */
type Answer = Partial<Size> & {
  failure?: string;
  palettes?: Palette[];
  versions?: string;
  knowsSpace?: boolean;
  extent?: Extent | null;
  motion?: Motion | null;
  shown?: Shown;
  row?: Row;
  isStopped?: boolean;
  pixels?: Uint8ClampedArray<ArrayBuffer>;
  samples?: number;
  milliseconds?: number;
};
