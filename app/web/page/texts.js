// SPDX-License-Identifier: MIT
// What the page says, in the languages of the program.

const english = {
  figure: "{0}: a fractal in its cage. Drag the corners of the cage.",
  orbit: "{0}: a fractal in space. Drag to turn it.",
  corner: "Corner {0}, at {1}",
  cornerHelp: "Arrow keys move the corner, with Shift farther.",
  cage: "Cage",
  cageHelp: "Arrow keys move the cage, with Shift farther; plus and minus zoom, 0 shows all.",
  reset: "Reset",
  fit: "Show All",
  png: "Save Picture",
  ifs: "Save .ifs",
  palette: "Palette",
  table: "Maps",
  map: "Map {0}",
  cell: "{0} of map {1}",
  weight: "Weight",
  notANumber: "“{0}” is not a number.",
  noAttractor: "These maps have no attractor, so the picture may be incomplete.",
  points: "{0} million points",
  drag: "Drag a corner: the fractal follows, every point of it. Hold Ctrl to rotate and Alt to scale.",
  touch: "Drag a corner: the fractal follows, every point of it. Two fingers zoom.",
  turn: "Drag to turn it.",
  deform: "Drag a corner to deform it.",
  failed: "This browser cannot draw the fractal live: it needs WebAssembly with SIMD.",
  made: "Made with Barycage",
};
/** @typedef {typeof english} Texts */

const paletteNames = ["Maple", "Fern", "Glacier", "Orchid", "Aurora", "Dusk", "Copper", "Lagoon", "Silver", "Ink",
  "Herbarium", "Sanguine", "Cyanotype"];

/** @type {Record<string, Texts>} */
const languages = {
  en: english,
  de: {
    figure: "{0}: ein Fraktal in seinem Käfig. Ziehen Sie an den Ecken des Käfigs.",
    orbit: "{0}: ein Fraktal im Raum. Ziehen Sie, um es zu drehen.",
    corner: "Ecke {0}, bei {1}",
    cornerHelp: "Pfeiltasten bewegen die Ecke, mit der Umschalttaste weiter.",
    cage: "Käfig",
    cageHelp: "Pfeiltasten bewegen den Käfig, mit der Umschalttaste weiter; Plus und Minus zoomen, 0 zeigt alles.",
    reset: "Zurücksetzen",
    fit: "Alles zeigen",
    png: "Bild speichern",
    ifs: ".ifs speichern",
    palette: "Palette",
    table: "Abbildungen",
    map: "Abbildung {0}",
    cell: "{0} von Abbildung {1}",
    weight: "Gewicht",
    notANumber: "„{0}“ ist keine Zahl.",
    noAttractor: "Diese Abbildungen haben keinen Attraktor, deshalb kann das Bild unvollständig sein.",
    points: "{0} Millionen Punkte",
    drag: "Ziehen Sie an einer Ecke: Das Fraktal folgt, mit jedem seiner Punkte. Strg dreht, Alt skaliert.",
    touch: "Ziehen Sie an einer Ecke: Das Fraktal folgt, mit jedem seiner Punkte. Zwei Finger zoomen.",
    turn: "Ziehen Sie, um es zu drehen.",
    deform: "Ziehen Sie an einer Ecke, um es zu verformen.",
    failed: "Dieser Browser kann das Fraktal nicht live zeichnen: Er bräuchte WebAssembly mit SIMD.",
    made: "Erstellt mit Barycage",
  },
  es: {
    figure: "{0}: un fractal en su jaula. Arrastre los vértices de la jaula.",
    orbit: "{0}: un fractal en el espacio. Arrastre para girarlo.",
    corner: "Vértice {0}, en {1}",
    cornerHelp: "Las flechas mueven el vértice, con Mayús más lejos.",
    cage: "Jaula",
    cageHelp: "Las flechas mueven la jaula, con Mayús más lejos; más y menos acercan y alejan, 0 lo muestra todo.",
    reset: "Restablecer",
    fit: "Mostrar todo",
    png: "Guardar imagen",
    ifs: "Guardar .ifs",
    palette: "Paleta",
    table: "Aplicaciones",
    map: "Aplicación {0}",
    cell: "{0} de la aplicación {1}",
    weight: "Peso",
    notANumber: "«{0}» no es un número.",
    noAttractor: "Estas aplicaciones no tienen atractor, así que la imagen puede estar incompleta.",
    points: "{0} millones de puntos",
    drag: "Arrastre un vértice: el fractal lo sigue, con todos sus puntos. Ctrl gira y Alt cambia la escala.",
    touch: "Arrastre un vértice: el fractal lo sigue, con todos sus puntos. Con dos dedos se amplía.",
    turn: "Arrastre para girarlo.",
    deform: "Arrastre un vértice para deformarlo.",
    failed: "Este navegador no puede dibujar el fractal en vivo: necesitaría WebAssembly con SIMD.",
    made: "Hecho con Barycage",
  },
  fr: {
    figure: "{0} : une fractale dans sa cage. Faites glisser les sommets de la cage.",
    orbit: "{0} : une fractale dans l’espace. Faites glisser pour la tourner.",
    corner: "Sommet {0}, en {1}",
    cornerHelp: "Les flèches déplacent le sommet, plus loin avec Maj.",
    cage: "Cage",
    cageHelp: "Les flèches déplacent la cage, plus loin avec Maj ; plus et moins zooment, 0 montre tout.",
    reset: "Réinitialiser",
    fit: "Tout afficher",
    png: "Enregistrer l’image",
    ifs: "Enregistrer en .ifs",
    palette: "Palette",
    table: "Applications",
    map: "Application {0}",
    cell: "{0} de l’application {1}",
    weight: "Poids",
    notANumber: "« {0} » n’est pas un nombre.",
    noAttractor: "Ces applications n’ont pas d’attracteur ; l’image peut être incomplète.",
    points: "{0} millions de points",
    drag: "Faites glisser un sommet : la fractale suit, avec tous ses points. Ctrl la tourne, Alt l’agrandit.",
    touch: "Faites glisser un sommet : la fractale suit, avec tous ses points. Deux doigts zooment.",
    turn: "Faites glisser pour la tourner.",
    deform: "Faites glisser un sommet pour la déformer.",
    failed: "Ce navigateur ne peut pas dessiner la fractale en direct : il lui faudrait WebAssembly avec SIMD.",
    made: "Fait avec Barycage",
  },
  mk: {
    figure: "{0}: фрактал во својот кафез. Влечете ги темињата на кафезот.",
    orbit: "{0}: фрактал во просторот. Влечете за да го завртите.",
    corner: "Теме {0}, во {1}",
    cornerHelp: "Стрелките го поместуваат темето, со Shift подалеку.",
    cage: "Кафез",
    cageHelp: "Стрелките го поместуваат кафезот, со Shift подалеку; плус и минус зумираат, 0 прикажува сѐ.",
    reset: "Врати",
    fit: "Прикажи сѐ",
    png: "Зачувај слика",
    ifs: "Зачувај .ifs",
    palette: "Палета",
    table: "Пресликувања",
    map: "Пресликување {0}",
    cell: "{0} на пресликувањето {1}",
    weight: "Тежина",
    notANumber: "„{0}“ не е број.",
    noAttractor: "Овие пресликувања немаат атрактор, па сликата може да биде нецелосна.",
    points: "{0} милиони точки",
    drag: "Повлечете теме: фракталот го следи, со сите свои точки. Ctrl врти, Alt ја менува големината.",
    touch: "Повлечете теме: фракталот го следи, со сите свои точки. Со два прста се зумира.",
    turn: "Влечете за да го завртите.",
    deform: "Повлечете теме за да го деформирате.",
    failed: "Овој прелистувач не може да го црта фракталот во живо: потребен е WebAssembly со SIMD.",
    made: "Направено со Barycage",
  },
};

/** @type {Record<string, string[]>} */
const palettes = {
  en: paletteNames,
  de: ["Ahorn", "Farn", "Gletscher", "Orchidee", "Polarlicht", "Dämmerung", "Kupfer", "Lagune", "Silber", "Tinte",
    "Herbarium", "Rötel", "Cyanotypie"],
  es: ["Arce", "Helecho", "Glaciar", "Orquídea", "Aurora", "Crepúsculo", "Cobre", "Laguna", "Plata", "Tinta",
    "Herbario", "Sanguina", "Cianotipo"],
  fr: ["Érable", "Fougère", "Glacier", "Orchidée", "Aurore", "Crépuscule", "Cuivre", "Lagon", "Argent", "Encre",
    "Herbier", "Sanguine", "Cyanotype"],
  mk: ["Јавор", "Папрат", "Глечер", "Орхидеја", "Поларна светлина", "Самрак", "Бакар", "Лагуна", "Сребро",
    "Мастило", "Хербариум", "Сангвина", "Цијанотипија"],
};

/** The first of these languages that the page speaks, else English.
 * @param {readonly string[]} wanted */
export function spokenLanguage(wanted) {
  return wanted.map((tag) => tag.toLowerCase().split("-")[0]).find((tag) => Object.hasOwn(languages, tag)) ?? "en";
}

/** @param {string} language @returns {Texts} */
export function textsOf(language) {
  return languages[language] ?? english;
}

/** @param {string} name in English @param {string} language */
export function paletteTitle(name, language) {
  return palettes[language]?.[paletteNames.indexOf(name)] ?? name;
}

/** @param {string} text with {0}, {1} … @param {...(string | number)} values */
export function filled(text, ...values) {
  return text.replace(/\{(\d)\}/g, (_, i) => String(values[Number(i)]));
}
