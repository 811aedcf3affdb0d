<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccessibleHandle</name>
    <message>
        <source>Move left</source>
        <translation>Nach links bewegen</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>Nach rechts bewegen</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben bewegen</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten bewegen</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Attraktor</translation>
    </message>
    <message>
        <source>A system has one attractor if some power of it contracts: then every start leads to the same set.</source>
        <translation>Ein System hat genau einen Attraktor, wenn eine Potenz davon kontrahiert: Dann führt jeder Anfang zur selben Menge.</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Kontraktion</translation>
    </message>
    <message>
        <source>‖A‖ of each map that takes part: the most by which it stretches distances.</source>
        <translation>‖A‖ jeder beteiligten Abbildung: das Meiste, um das sie Abstände streckt.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that holds the attractor; certified.</source>
        <translation>Das kleinste achsenparallele Rechteck, das den Attraktor enthält; bewiesen.</translation>
    </message>
    <message>
        <source>Canonical simplex</source>
        <translation>Kanonisches Simplex</translation>
    </message>
    <message>
        <source>%1, leg %2, corner %3</source>
        <translation>%1, Kathete %2, Ecke %3</translation>
    </message>
    <message>
        <source>Similarity dimension</source>
        <translation>Ähnlichkeitsdimension</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved exactly: the centre of mass of the picture.</source>
        <translation>Mittelwert des invarianten Maßes, exakt gelöst: der Schwerpunkt des Bildes.</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Kovarianz</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Fixpunkte</translation>
    </message>
    <message>
        <source>The point that each map leaves where it is; it lies on the attractor.</source>
        <translation>Der Punkt, den jede Abbildung an seinem Ort lässt; er liegt auf dem Attraktor.</translation>
    </message>
    <message>
        <source>The D with Σ sᵢᴰ = 1 over the ratios sᵢ, when all maps are similarities in some coordinates. It is the dimension of the attractor when the pieces do not overlap.</source>
        <translation>Das D mit Σ sᵢᴰ = 1 über die Faktoren sᵢ, wenn alle Abbildungen in gewissen Koordinaten Ähnlichkeiten sind. Es ist die Dimension des Attraktors, wenn die Teile sich nicht überlappen.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Affinitätsdimension</translation>
    </message>
    <message>
        <source>Falconer’s dimension: where the sum of the singular value functions of all words of one length neither grows nor falls, at most 2. An upper bound of the box-counting dimension, and equal to it for almost all translations when the maps contract enough.</source>
        <translation>Falconers Dimension: wo die Summe der Singulärwertfunktionen aller Wörter gleicher Länge weder wächst noch fällt, höchstens 2. Eine obere Schranke der Boxdimension und ihr gleich für fast alle Verschiebungen, wenn die Abbildungen genug kontrahieren.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Boxdimension</translation>
    </message>
    <message>
        <source>Slope of the least-squares line through ln N against ln 1/ε, where N boxes of side ε meet the attractor. An estimate: it depends on the sizes counted.</source>
        <translation>Steigung der Ausgleichsgeraden durch ln N gegen ln 1/ε, wo N Kästchen der Seite ε den Attraktor treffen. Eine Schätzung: Sie hängt von den gezählten Größen ab.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture spreads. The ellipse is the one on which an even mass has the same mean and covariance.</source>
        <translation>Kovarianz xx, xy, yy des invarianten Maßes, exakt gelöst: wie weit das Bild streut. Die Ellipse ist die, auf der eine gleichmäßige Masse denselben Mittelwert und dieselbe Kovarianz hat.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that holds the attractor; certified. The signs are the directions of its legs.</source>
        <translation>Das kleinste gleichschenklig-rechtwinklige Dreieck mit achsenparallelen Katheten, das den Attraktor enthält; bewiesen. Die Vorzeichen sind die Richtungen der Katheten.</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Fläche der Hülle</translation>
    </message>
    <message>
        <source>Area of the convex hull: of the polygon whose vertices were found on the attractor. The hull itself is larger by at most its border times the error bound.</source>
        <translation>Fläche der konvexen Hülle: des Vielecks, dessen Ecken auf dem Attraktor gefunden wurden. Die Hülle selbst ist höchstens um ihren Rand mal die Fehlerschranke größer.</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Ecken der Hülle</translation>
    </message>
    <message>
        <source>Corners of the convex hull as found, each a point of the attractor. A hull with infinitely many has as many as its tolerance asks for.</source>
        <translation>Ecken der konvexen Hülle, wie gefunden, jede ein Punkt des Attraktors. Eine Hülle mit unendlich vielen hat so viele, wie ihre Toleranz verlangt.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Fehlerschranke der Hülle</translation>
    </message>
    <message>
        <source>The attractor reaches at most this far beyond the polygon; certified.</source>
        <translation>Der Attraktor reicht höchstens so weit über das Vieleck hinaus; bewiesen.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… und %n weitere</numerusform>
            <numerusform>… und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes: hyperbolic, every map contracts by %1 or less.</source>
        <translation>Ja: hyperbolisch, jede Abbildung kontrahiert mit Faktor %1 oder weniger.</translation>
    </message>
    <message>
        <source>Yes: eventually contractive, every word of %1 maps contracts (%2 a map).</source>
        <translation>Ja: schließlich kontrahierend, jedes Wort aus %1 Abbildungen kontrahiert (%2 je Abbildung).</translation>
    </message>
    <message>
        <source>None: the word %1 does not contract (%2 a map).</source>
        <translation>Keiner: das Wort %1 kontrahiert nicht (%2 je Abbildung).</translation>
    </message>
    <message>
        <source>Undecided: no proof either way was found.</source>
        <translation>Unentschieden: es wurde weder für das eine noch für das andere ein Beweis gefunden.</translation>
    </message>
    <message>
        <source>None: no map takes part.</source>
        <translation>Keiner: keine Abbildung nimmt teil.</translation>
    </message>
    <message>
        <source>None: map %1 does not contract (%2 a map).</source>
        <translation>Keiner: Abbildung %1 kontrahiert nicht (%2 je Abbildung).</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Take a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Fass ein Fraktal an seinen Ecken: ein Editor für iterierte Funktionensysteme.</translation>
    </message>
    <message>
        <source>.ifs files to open, a window each</source>
        <translation>.ifs-Dateien, die geöffnet werden, jede in einem Fenster</translation>
    </message>
    <message>
        <source>a window with the maple, whatever was open before</source>
        <translation>ein Fenster mit dem Ahorn, was auch immer zuvor offen war</translation>
    </message>
    <message>
        <source>a window that shows the collection</source>
        <translation>ein Fenster, das die Sammlung zeigt</translation>
    </message>
    <message>
        <source>a window with fractals made by chance to pick from</source>
        <translation>ein Fenster mit zufälligen Fraktalen zur Auswahl</translation>
    </message>
</context>
<context>
    <name>CageEdits</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Dieser Eintrag hat keine Abbildungen der Ebene.</translation>
    </message>
    <message>
        <source>The cage is at rest: the code is what is displayed.</source>
        <translation>Der Käfig ist in Ruhe: Gezeigt wird der Code selbst.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code has a bent picture. Choose “Affine fit” to bake what comes nearest to it.</source>
        <translation>Der Käfig biegt das Bild, und kein affiner Code hat ein gebogenes Bild. Mit „Affin angepasst“ lässt sich einrechnen, was ihm am nächsten kommt.</translation>
    </message>
    <message>
        <source>The cage is flat: no code has this picture. Open the cage first.</source>
        <translation>Der Käfig ist flach: Kein Code hat dieses Bild. Zuerst den Käfig öffnen.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. The code stays as it is until you bake.</source>
        <translation>Den Käfig zu bewegen bewegt das Bild. Der Code bleibt, wie er ist, bis Sie einrechnen.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can follow, and leaves it.</source>
        <translation>Den ganzen Käfig zu bewegen schreibt den Code um. Einzelne Ecken zu bewegen biegt das Bild; dem kann kein Code folgen, und er bleibt.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites every coefficient of the code, and the cage rests where it is.</source>
        <translation>Den Käfig zu bewegen schreibt jeden Koeffizienten des Codes um, und der Käfig ruht, wo er ist.</translation>
    </message>
    <message>
        <source>The cage already places the code.</source>
        <translation>Der Käfig platziert den Code bereits.</translation>
    </message>
    <message>
        <source>Only a triangle can be taken out of the code.</source>
        <translation>Nur ein Dreieck kann aus dem Code herausgerechnet werden.</translation>
    </message>
    <message>
        <source>The cage has a notch: the picture may fold over itself there.</source>
        <translation>Der Käfig hat eine Kerbe: Dort kann sich das Bild überfalten.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture lie over one another. Move the vertices apart to unfold it.</source>
        <translation>Der Käfig ist gefaltet: Teile des Bildes liegen übereinander. Bewegen Sie die Ecken auseinander, um ihn zu entfalten.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to enclose.</source>
        <translation>Keine Abbildung nimmt teil; es gibt nichts einzuschließen.</translation>
    </message>
    <message>
        <source>A bent picture cannot be held by another cage. Reset the cage, or choose “Affine fit”, first.</source>
        <translation>Ein gebogenes Bild kann kein anderer Käfig halten. Setzen Sie zuerst den Käfig zurück oder wählen Sie „Affin angepasst“.</translation>
    </message>
    <message>
        <source>The cage is flat. Open the triangle, or reset it, first.</source>
        <translation>Der Käfig ist flach. Öffnen Sie zuerst das Dreieck oder setzen Sie es zurück.</translation>
    </message>
    <message>
        <source>This system has no attractor that could be enclosed.</source>
        <translation>Dieses System hat keinen Attraktor, der eingeschlossen werden könnte.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>Der Käfig ist in Ruhe.</translation>
    </message>
</context>
<context>
    <name>Collection</name>
    <message>
        <source>From the paper</source>
        <translation>Aus dem Aufsatz</translation>
    </message>
    <message>
        <source>The two systems of E. Hadzieva and M. Shuminoska, with the coefficients as printed.</source>
        <translation>Die beiden Systeme von E. Hadzieva und M. Shuminoska, mit den gedruckten Koeffizienten.</translation>
    </message>
    <message>
        <source>Ferns</source>
        <translation>Farne</translation>
    </message>
    <message>
        <source>Fronds: a long slow map climbs the rachis, two short ones hang the pinnae, a flat one draws the stem.</source>
        <translation>Wedel: Eine lange, langsame Abbildung steigt die Spindel hinauf, zwei kurze hängen die Fiedern an, eine flache zeichnet den Stiel.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <source>Trunks that fork: the whole tree stands on its own branches.</source>
        <translation>Stämme, die sich gabeln: Der ganze Baum steht auf seinen eigenen Ästen.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Drachen</translation>
    </message>
    <message>
        <source>Folded paper curves and the fractals of two or three twisted similarities.</source>
        <translation>Kurven aus gefaltetem Papier und die Fraktale von zwei oder drei gedrehten Ähnlichkeiten.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Sierpiński-Familie</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon holds shrunken copies of itself and keeps its holes.</source>
        <translation>Siebe und Teppiche: Ein Vieleck enthält verkleinerte Kopien von sich und behält seine Löcher.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Koch-Familie</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment, and the islands they bound.</source>
        <translation>Kurven, die durch Ersetzen einer Strecke entstehen, und die Inseln, die sie umranden.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Spiralen</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small ones that bead its path.</source>
        <translation>Eine Abbildung, die dreht und ein wenig schrumpft, und kleine, die ihren Weg besetzen.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Blätter und Blüten</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are turned copies of one another.</source>
        <translation>Umrisse von Blättern, und Blüten, deren Blätter gedrehte Kopien voneinander sind.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Kacheln und Reptiles</translation>
    </message>
    <message>
        <source>Sets that tile the plane: copies of themselves, rep-tiles, and the central tiles of number systems.</source>
        <translation>Mengen, die die Ebene pflastern: Kopien ihrer selbst, Rep-Tiles und die mittleren Kacheln von Zahlsystemen.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Cantormengen und Staub</translation>
    </message>
    <message>
        <source>Sets full of gaps at every scale: points everywhere near, hardly any of them joined.</source>
        <translation>Mengen voller Lücken in jeder Größe: überall Punkte in der Nähe, kaum welche verbunden.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Kristalle und Schneeflocken</translation>
    </message>
    <message>
        <source>Sets with the symmetry of frost: five, six and more arms.</source>
        <translation>Mengen mit der Symmetrie des Frosts: fünf, sechs und mehr Arme.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Kurven und Graphen</translation>
    </message>
    <message>
        <source>Graphs of strange functions, smooth curves as attractors, space-filling coordinates.</source>
        <translation>Graphen seltsamer Funktionen, glatte Kurven als Attraktoren, raumfüllende Koordinaten.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Abstrakt</translation>
    </message>
    <message>
        <source>Affine patterns without a name in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Affine Muster ohne Namen in der Natur: Verwandte des Siebs, Geflechte, Rosetten.</translation>
    </message>
</context>
<context>
    <name>ExportJob</name>
    <message>
        <source>There is not enough memory for this picture. Make it smaller, or supersample less.</source>
        <translation>Für dieses Bild reicht der Speicher nicht. Machen Sie es kleiner oder verringern Sie die Überabtastung.</translation>
    </message>
</context>
<context>
    <name>FlameCard</name>
    <message>
        <source>Flames</source>
        <translation>Flames</translation>
    </message>
    <message numerus="yes">
        <source>%n flames</source>
        <translation>
            <numerusform>%n Flame</numerusform>
            <numerusform>%n Flames</numerusform>
        </translation>
    </message>
    <message>
        <source>In flames y grows downwards. They were turned over, so that they look here as they do in flame programs.</source>
        <translation>In Flames wächst y nach unten. Sie wurden umgedreht, damit sie hier aussehen wie in Flame-Programmen.</translation>
    </message>
    <message>
        <source>Leave &amp;y as it is written</source>
        <translation>&amp;y lassen, wie es geschrieben ist</translation>
    </message>
    <message>
        <source>Takes the numbers of the flames as they are in the text. The picture is then upside down.</source>
        <translation>Nimmt die Zahlen der Flames, wie sie im Text stehen. Das Bild steht dann auf dem Kopf.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Leave y as it is written</source>
        <translation>y lassen, wie es geschrieben ist</translation>
    </message>
    <message>
        <source>Turn the flames over</source>
        <translation>Flames umdrehen</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures that carry their fractal (*.png *.svg);;All files (*)</source>
        <translation>Fractint-Sammlungen (*.ifs *.par);;Flames (*.flame *.flam3);;Zahlentabellen (*.csv *.tsv *.txt);;Bilder, die ihr Fraktal enthalten (*.png *.svg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation>Das Feld „%1“ zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Einträge</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Take the maple by a corner and pull. Or press D and define another triangle by three clicks.</source>
        <translation>Fassen Sie den Ahorn an einer Ecke und ziehen Sie. Oder drücken Sie D und legen Sie mit drei Klicks ein anderes Dreieck fest.</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>%1 konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Recovered %1. It is not saved yet.</source>
        <translation>%1 wurde wiederhergestellt. Es ist noch nicht gespeichert.</translation>
    </message>
    <message numerus="yes">
        <source>%n entries</source>
        <translation>
            <numerusform>%n Eintrag</numerusform>
            <numerusform>%n Einträge</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them could not be read and are kept as they are</source>
        <translation>
            <numerusform>, %n davon konnte nicht gelesen werden und bleibt, wie er ist</numerusform>
            <numerusform>, %n davon konnten nicht gelesen werden und bleiben, wie sie sind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with a remark</source>
        <translation>
            <numerusform>, %n mit einer Bemerkung gelesen</numerusform>
            <numerusform>, %n mit einer Bemerkung gelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation>Möchten Sie sie speichern?</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Auf der Platte geändert</translation>
    </message>
    <message>
        <source>“%1” was changed by another program since it was opened here.</source>
        <translation>„%1“ wurde von einem anderen Programm geändert, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Saving replaces what the other program wrote.</source>
        <translation>Speichern ersetzt, was das andere Programm geschrieben hat.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs)</source>
        <translation>Fractint-Sammlungen (*.ifs)</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurückkehren</translation>
    </message>
    <message>
        <source>Go back to “%1” as it is on disk? The changes made since then are lost.</source>
        <translation>Zu „%1“ zurückkehren, wie es auf der Platte ist? Die Änderungen seither gehen verloren.</translation>
    </message>
    <message>
        <source>%1 could not be read again</source>
        <translation>%1 konnte nicht noch einmal gelesen werden</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine zuletzt benutzten Dateien</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Diese Liste leeren</translation>
    </message>
    <message>
        <source>%1[*] — %2</source>
        <comment>file, entry</comment>
        <translation>%1[*] — %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>what it does, shortcut</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Start with a Sierpiński triangle</source>
        <translation>Mit einem Sierpiński-Dreieck beginnen</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Neues Fens&amp;ter</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation>Ein weiteres Fenster öffnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a collection of fractals</source>
        <translation>Eine Sammlung von Fraktalen öffnen</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt benutzt</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the file; entries not edited keep every byte</source>
        <translation>Die Datei speichern; unbearbeitete Einträge behalten jedes Byte</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Save the file under another name</source>
        <translation>Die Datei unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Zu&amp;rückkehren</translation>
    </message>
    <message>
        <source>Go back to the file as it is on disk</source>
        <translation>Zur Datei zurückkehren, wie sie auf der Platte ist</translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation>Bild &amp;exportieren…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen</source>
        <translation>Das Bild als PNG, SVG oder PDF exportieren, im Ausschnitt des Bildschirms</translation>
    </message>
    <message>
        <source>Export &amp;Data…</source>
        <translation>D&amp;aten exportieren…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Export the maps or points as a flame, for IFStile, as a table or a point cloud</source>
        <translation>Abbildungen oder Punkte als Flame, für IFStile, als Tabelle oder als Punktwolke exportieren</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy the picture to the clipboard</source>
        <translation>Das Bild in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>Das Bild ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>Print the picture, its name and its coefficients</source>
        <translation>Das Bild, seinen Namen und seine Koeffizienten drucken</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Alle Fenster schließen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Ctrl+Z</translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation>Die letzte Bearbeitung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Make the edit again that was taken back</source>
        <translation>Die zurückgenommene Bearbeitung noch einmal machen</translation>
    </message>
    <message>
        <source>&amp;Transform…</source>
        <translation>&amp;Transformieren…</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Rotate, scale, shear, reflect or move the whole fractal by numbers</source>
        <translation>Das ganze Fraktal nach Zahlen drehen, skalieren, scheren, spiegeln oder verschieben</translation>
    </message>
    <message>
        <source>&amp;Mutate…</source>
        <translation>&amp;Mutieren…</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Pick one of many variations of this fractal</source>
        <translation>Eine von vielen Abwandlungen dieses Fraktals wählen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Pick one of many fractals made by chance, and add it to the file</source>
        <translation>Eines von vielen zufällig entstandenen Fraktalen wählen und der Datei hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>Einste&amp;llungen…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Language, theme, quality of the picture at rest, what is opened at the start</source>
        <translation>Sprache, Farben, Güte des ruhenden Bildes, und was beim Start geöffnet wird</translation>
    </message>
    <message>
        <source>&amp;Cage</source>
        <translation>&amp;Käfig</translation>
    </message>
    <message>
        <source>&amp;Drag the Cage</source>
        <translation>Den &amp;Käfig ziehen</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Take the fractal by the vertices of its control triangle</source>
        <translation>Das Fraktal an den Ecken seines Kontrolldreiecks fassen</translation>
    </message>
    <message>
        <source>De&amp;fine Triangle</source>
        <translation>Dreieck &amp;festlegen</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Define the control triangle by three clicks</source>
        <translation>Das Kontrolldreieck mit drei Klicks festlegen</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>&amp;Minimales kanonisches Simplex anpassen</translation>
    </message>
    <message>
        <source>Hold the attractor in the smallest isosceles right triangle around it</source>
        <translation>Den Attraktor im kleinsten gleichschenklig-rechtwinkligen Dreieck um ihn halten</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Put the cage back to rest: the code is drawn as it is</source>
        <translation>Den Käfig in Ruhe versetzen: Gezeigt wird der Code, wie er ist</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Einrechnen</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Make the placement part of the code: the picture stays, the coefficients change</source>
        <translation>Die Lage in den Code einrechnen: Das Bild bleibt, die Koeffizienten ändern sich</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Herausrechnen</translation>
    </message>
    <message>
        <source>Take the placement out of the code: the picture stays, the code becomes that of the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Die Lage aus dem Code herausrechnen: Das Bild bleibt, der Code wird der des Dreiecks (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Re&amp;gelmäßig machen</translation>
    </message>
    <message>
        <source>Put the vertices on the regular polygon nearest to them</source>
        <translation>Die Ecken auf das nächste regelmäßige Vieleck setzen</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>Affin &amp;invariante Form…</translation>
    </message>
    <message>
        <source>Show every map as a row-stochastic matrix over the control triangle</source>
        <translation>Jede Abbildung als zeilenstochastische Matrix über dem Kontrolldreieck zeigen</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Platzieren</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation>Den Käfig zu bewegen bewegt das Bild; der Code bleibt</translation>
    </message>
    <message>
        <source>Re&amp;write</source>
        <translation>&amp;Umschreiben</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Den Käfig zu bewegen schreibt den Code um</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Show the whole fractal</source>
        <translation>Das ganze Fraktal zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100 %</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Show one unit as one hundred pixels</source>
        <translation>Eine Einheit als hundert Pixel zeigen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Gi&amp;tter</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Das Gitter zeigen</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Achsen</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Show the axes</source>
        <translation>Die Achsen zeigen</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>&amp;y-Achse nach unten</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Let y grow downwards, as in window coordinates</source>
        <translation>y nach unten wachsen lassen, wie in Fensterkoordinaten</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas but the picture</source>
        <translation>Alles außer dem Bild verbergen</translation>
    </message>
    <message>
        <source>&amp;Snap To</source>
        <translation>E&amp;inrasten an</translation>
    </message>
    <message>
        <source>&amp;Vertices</source>
        <translation>&amp;Ecken</translation>
    </message>
    <message>
        <source>Let dragged vertices snap to this</source>
        <translation>Gezogene Ecken hieran einrasten lassen</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Felder</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Den ganzen Bildschirm nutzen</translation>
    </message>
    <message>
        <source>How It Arises</source>
        <translation>Wie er entsteht</translation>
    </message>
    <message>
        <source>&amp;How It Arises</source>
        <translation>&amp;Wie er entsteht</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor arise: by steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Zusehen, wie der Attraktor entsteht: in Schritten des deterministischen Algorithmus oder durch das Chaos-Spiel</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>Befehl &amp;finden…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Find any command by typing what it does</source>
        <translation>Jeden Befehl finden, indem man tippt, was er tut</translation>
    </message>
    <message>
        <source>&amp;Keyboard and Mouse…</source>
        <translation>&amp;Tastatur und Maus…</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Every shortcut and gesture</source>
        <translation>Alle Tastenkürzel und Gesten</translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>Read the user guide</source>
        <translation>Das Handbuch lesen</translation>
    </message>
    <message>
        <source>&amp;About Barycage</source>
        <translation>Ü&amp;ber Barycage</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version und Lizenz</translation>
    </message>
    <message>
        <source>About Barycage</source>
        <translation>Über Barycage</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Take a fractal by its corners: an editor for iterated function systems whose attractors are held in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Fass ein Fraktal an seinen Ecken: ein Editor für iterierte Funktionensysteme, deren Attraktoren in baryzentrischen Koordinaten eines Kontrolldreiecks gehalten werden.&lt;/p&gt;&lt;p&gt;Nach E. Hadzieva und M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT-Lizenz.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>The toolkit this program is built with</source>
        <translation>Das Toolkit, mit dem dieses Programm gebaut ist</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>The fractals of the open file. The one chosen here is in the picture.</source>
        <translation>Die Fraktale der offenen Datei. Das hier gewählte ist im Bild.</translation>
    </message>
    <message>
        <source>Fractals to begin with, by theme, and your own folders of them.</source>
        <translation>Fraktale zum Anfangen, nach Themen, und Ihre eigenen Ordner davon.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map in a row.</source>
        <translation>Die Abbildungen des Fraktals: sein Code, eine Abbildung je Zeile.</translation>
    </message>
    <message>
        <source>The control cage by numbers: where its vertices are, where they are at rest, what moving them does, and other cages to choose from.</source>
        <translation>Der Kontrollkäfig in Zahlen: wo seine Ecken sind, wo sie in Ruhe sind, was ihre Bewegung bewirkt, und andere Käfige zur Wahl.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Farben, Helligkeit und Hintergrund des Bildes. Sie werden mit dem Fraktal gespeichert.</translation>
    </message>
    <message>
        <source>What mathematics knows of this fractal. Point at a name to read what it means.</source>
        <translation>Was die Mathematik von diesem Fraktal weiß. Zeigen Sie auf einen Namen, um zu lesen, was er bedeutet.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Choose one to go back to it, or forward.</source>
        <translation>Jeder Schritt, seit die Datei geöffnet wurde. Wählen Sie einen, um zu ihm zurück- oder vorzugehen.</translation>
    </message>
    <message>
        <source>What was odd in the file, with line and column. It is kept as it is.</source>
        <translation>Was an der Datei auffiel, mit Zeile und Spalte. Es bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>Six short steps in this window: contraction, fixed point, chaos game, address, barycentric coordinates, dimension</source>
        <translation>Sechs kurze Schritte in diesem Fenster: Kontraktion, Fixpunkt, Chaos-Spiel, Adresse, baryzentrische Koordinaten, Dimension</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Click anything to read what it is for</source>
        <translation>Klicken Sie irgendwohin, um zu lesen, wozu es dient</translation>
    </message>
    <message>
        <source>No recovery</source>
        <translation>Keine Wiederherstellung</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Systeme &amp;ohne Attraktor erlauben</translation>
    </message>
    <message>
        <source>Let maps be dragged to where they no longer contract; otherwise the drag stops there</source>
        <translation>Abbildungen dorthin ziehen lassen, wo sie nicht mehr kontrahieren; sonst hält das Ziehen dort an</translation>
    </message>
    <message>
        <source>Drag t&amp;he Maps</source>
        <translation>Die &amp;Abbildungen ziehen</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Show the maps as images of the cage and take them by their corners</source>
        <translation>Die Abbildungen als Bilder des Käfigs zeigen und an ihren Ecken fassen</translation>
    </message>
    <message>
        <source>Drag a Bra&amp;nch</source>
        <translation>Einen As&amp;t ziehen</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Click a point of the attractor and take the branch that it belongs to</source>
        <translation>Auf einen Punkt des Attraktors klicken und den Ast fassen, zu dem er gehört</translation>
    </message>
    <message>
        <source>Maps and Branches</source>
        <translation>Abbildungen und Äste</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Add the fractals on the clipboard to the file: entries of an .ifs file, flames or a table of numbers</source>
        <translation>Die Fraktale aus der Zwischenablage zur Datei hinzufügen: Einträge einer .ifs-Datei, Flames oder eine Zahlentabelle</translation>
    </message>
    <message>
        <source>The unsaved work is here all the same.</source>
        <translation>Die ungespeicherte Arbeit ist trotzdem hier.</translation>
    </message>
    <message>
        <source>%1 was not recovered. It is offered again at the next start.</source>
        <translation>%1 wurde nicht wiederhergestellt. Beim nächsten Start wird es erneut angeboten.</translation>
    </message>
    <message>
        <source>Esc brings menus and panels back.</source>
        <translation>Esc bringt Menüs und Felder zurück.</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>Vo&amp;rführung</translation>
    </message>
    <message>
        <source>Shift+F11</source>
        <translation>Shift+F11</translation>
    </message>
    <message>
        <source>Leave the whole screen to the canvas, as for a projector; Esc brings the rest back</source>
        <translation>Der Zeichenfläche den ganzen Bildschirm überlassen, etwa für einen Projektor; Esc bringt das Übrige zurück</translation>
    </message>
    <message>
        <source>Add Ra&amp;ndom Fractal…</source>
        <translation>Zu&amp;fälliges Fraktal hinzufügen…</translation>
    </message>
    <message>
        <source>Only the Pi&amp;cture</source>
        <translation>&amp;Nur das Bild</translation>
    </message>
</context>
<context>
    <name>NumberField</name>
    <message>
        <source>The number must be greater than %1.</source>
        <translation>Die Zahl muss größer als %1 sein.</translation>
    </message>
    <message>
        <source>The number must be at least %1.</source>
        <translation>Die Zahl muss mindestens %1 sein.</translation>
    </message>
    <message>
        <source>The number must be less than %1.</source>
        <translation>Die Zahl muss kleiner als %1 sein.</translation>
    </message>
    <message>
        <source>The number must be at most %1.</source>
        <translation>Die Zahl darf höchstens %1 sein.</translation>
    </message>
    <message>
        <source>A number is missing here.</source>
        <translation>Hier fehlt eine Zahl.</translation>
    </message>
    <message>
        <source>“%1” is a fraction: write it as a decimal number.</source>
        <translation>„%1“ ist ein Bruch: Schreiben Sie ihn als Dezimalzahl.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>„%1“ ist eine zu große Zahl.</translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Nicht gespeicherte Arbeit wiederherstellen</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen …</translation>
    </message>
    <message>
        <source>Reading “%1” was cancelled.</source>
        <translation>Das Lesen von „%1“ wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>„%1“ wird gespeichert …</translation>
    </message>
    <message>
        <source>Saving “%1” was cancelled. The file on the disk is as it was.</source>
        <translation>Das Speichern von „%1“ wurde abgebrochen. Die Datei ist, wie sie war.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and cannot be opened.</source>
        <translation>„%1“ ist keine gewöhnliche Datei und kann nicht geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Maple</source>
        <translation>Ahorn</translation>
    </message>
    <message>
        <source>Fern</source>
        <translation>Farn</translation>
    </message>
    <message>
        <source>Glacier</source>
        <translation>Gletscher</translation>
    </message>
    <message>
        <source>Orchid</source>
        <translation>Orchidee</translation>
    </message>
    <message>
        <source>Aurora</source>
        <translation>Polarlicht</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Dämmerung</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Kupfer</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Lagune</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>Silber</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinte</translation>
    </message>
    <message>
        <source>Herbarium</source>
        <translation>Herbarium</translation>
    </message>
    <message>
        <source>Sanguine</source>
        <translation>Rötel</translation>
    </message>
    <message>
        <source>Cyanotype</source>
        <translation>Cyanotypie</translation>
    </message>
</context>
<context>
    <name>PngSystem</name>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed its text.</source>
        <translation>Das Bild enthält kein System: Es wurde nicht von Barycage geschrieben, oder ein anderes Programm hat seinen Text entfernt.</translation>
    </message>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>Das System im Bild hat mehr als 8 MB.</translation>
    </message>
    <message>
        <source>The file is no PNG picture, or it is damaged.</source>
        <translation>Die Datei ist kein PNG-Bild, oder sie ist beschädigt.</translation>
    </message>
</context>
<context>
    <name>PngWriter</name>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Das Bild kann nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>%1, %2</source>
        <comment>file, time</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Unsaved work was found</source>
        <translation>Nicht gespeicherte Arbeit wurde gefunden</translation>
    </message>
    <message>
        <source>Barycage ended last time before this work was saved:</source>
        <translation>Barycage endete letztes Mal, bevor diese Arbeit gespeichert war:</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Ask Later</source>
        <translation>Später fragen</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for recovery: the folder “%1” cannot be written to, or the disk is full. Save often.</source>
        <translation>Nicht gespeicherte Arbeit kann nicht zur Wiederherstellung aufbewahrt werden: In den Ordner „%1“ kann nicht geschrieben werden, oder der Datenträger ist voll. Speichern Sie oft.</translation>
    </message>
    <message>
        <source>Unsaved work of last time is damaged and cannot be recovered. What is left of it lies in:</source>
        <translation>Nicht gespeicherte Arbeit vom letzten Mal ist beschädigt und lässt sich nicht wiederherstellen. Was davon übrig ist, liegt in:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Nicht gespeicherte Arbeit wird gesucht …</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 G points</source>
        <translation>%1 Mrd. Punkte</translation>
    </message>
    <message>
        <source>%1 M points</source>
        <translation>%1 Mio. Punkte</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>hyperbolisch, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 (words of %2 maps)</source>
        <translation>schließlich kontraktiv, γ = %1 (Wörter aus %2 Abbildungen)</translation>
    </message>
    <message>
        <source>no attractor: the word %1 does not contract</source>
        <translation>kein Attraktor: Das Wort %1 kontrahiert nicht</translation>
    </message>
    <message>
        <source>existence of an attractor undecided</source>
        <translation>Existenz eines Attraktors unentschieden</translation>
    </message>
    <message>
        <source>no map takes part</source>
        <translation>keine Abbildung nimmt teil</translation>
    </message>
    <message>
        <source>Pointer position</source>
        <translation>Ort des Zeigers</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and the factor by which it contracts</source>
        <translation>Ob das System einen Attraktor hat, und der Faktor, um den es kontrahiert</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Points drawn so far and the time of the last pass</source>
        <translation>Bisher gezeichnete Punkte und die Zeit des letzten Durchgangs</translation>
    </message>
    <message>
        <source>  barycentric (%1)</source>
        <translation>  baryzentrisch (%1)</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D: noch nicht gezeigt</translation>
    </message>
    <message>
        <source>this entry could not be read</source>
        <translation>dieser Eintrag konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>World and barycentric coordinates of the pointer; the address of the point of the attractor under it, outermost map first, and the fixed point of its branch</source>
        <translation>Welt- und baryzentrische Koordinaten des Zeigers; die Adresse des Punktes des Attraktors darunter, äußerste Abbildung zuerst, und der Fixpunkt seines Astes</translation>
    </message>
    <message>
        <source>  address %1</source>
        <translation>  Adresse %1</translation>
    </message>
    <message>
        <source>  fixed point of %1 (%2, %3)</source>
        <translation>  Fixpunkt von %1 (%2, %3)</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>no attractor: map %1 does not contract</source>
        <translation>kein Attraktor: Abbildung %1 kontrahiert nicht</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>Das System im Bild hat mehr als 8 MB.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>Das System im Bild ist beschädigt.</translation>
    </message>
    <message>
        <source>The picture declares a document type, which Barycage never writes and does not read.</source>
        <translation>Das Bild nennt einen Dokumenttyp, was Barycage nie schreibt und nicht liest.</translation>
    </message>
    <message>
        <source>The file is no SVG picture, or it is damaged.</source>
        <translation>Die Datei ist kein SVG-Bild, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed it.</source>
        <translation>Das Bild enthält kein System: Es wurde nicht von Barycage geschrieben, oder ein anderes Programm hat es entfernt.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a document type is not accepted in a flame file</source>
        <translation>ein Dokumenttyp wird in einer Flame-Datei nicht angenommen</translation>
    </message>
    <message>
        <source>The XML ends here: %1.</source>
        <translation>Das XML endet hier: %1.</translation>
    </message>
    <message>
        <source>There is no flame in this file.</source>
        <translation>In dieser Datei ist keine Flame.</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Das Bild wird gezeichnet…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Print “%1”</source>
        <translation>„%1“ drucken</translation>
    </message>
    <message>
        <source>in space</source>
        <translation>im Raum</translation>
    </message>
    <message>
        <source>no attractor</source>
        <translation>kein Attraktor</translation>
    </message>
    <message>
        <source>The sheet would be %1 by %2 pixels; at most %3 a side can be drawn. Take smaller tiles, or other columns.</source>
        <translation>Das Blatt wäre %1 mal %2 Pixel groß; höchstens %3 je Seite können gezeichnet werden. Nehmen Sie kleinere Kacheln oder andere Spalten.</translation>
    </message>
    <message>
        <source>the amount of “%1” is not a number</source>
        <translation>der Anteil von „%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>it uses a variation other than linear</source>
        <translation>sie benutzt eine andere Variation als linear</translation>
    </message>
    <message>
        <source>it acts in space (“%1”)</source>
        <translation>sie wirkt im Raum („%1“)</translation>
    </message>
    <message>
        <source>it uses the variation “%1”</source>
        <translation>sie benutzt die Variation „%1“</translation>
    </message>
    <message>
        <source>its “coefs” are not six numbers</source>
        <translation>ihre „coefs“ sind nicht sechs Zahlen</translation>
    </message>
    <message>
        <source>its “post” is not six numbers</source>
        <translation>ihr „post“ sind nicht sechs Zahlen</translation>
    </message>
    <message>
        <source>its “chaos” allows some successors only, which a list of maps cannot say</source>
        <translation>ihr „chaos“ erlaubt nur manche Nachfolger, was eine Liste von Abbildungen nicht sagen kann</translation>
    </message>
    <message>
        <source>it takes part without being drawn (opacity 0)</source>
        <translation>sie nimmt teil, ohne gezeichnet zu werden (opacity 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>ihr Gewicht ist keine Zahl</translation>
    </message>
    <message>
        <source>it has a final transform</source>
        <translation>sie hat eine Schlusstransformation</translation>
    </message>
    <message>
        <source>it adds a symmetry</source>
        <translation>sie fügt eine Symmetrie hinzu</translation>
    </message>
    <message>
        <source>it has motion</source>
        <translation>sie hat Bewegung</translation>
    </message>
    <message>
        <source>it has layers</source>
        <translation>sie hat Ebenen</translation>
    </message>
    <message>
        <source>The flame “%1” is not a system of affine maps: %2.</source>
        <translation>Die Flame „%1“ ist kein System affiner Abbildungen: %2.</translation>
    </message>
    <message>
        <source>it has more than %1 transforms</source>
        <translation>sie hat mehr als %1 Transformationen</translation>
    </message>
    <message>
        <source>transform %1: %2</source>
        <translation>Transformation %1: %2</translation>
    </message>
    <message>
        <source>The flame “%1” has no transforms.</source>
        <translation>Die Flame „%1“ hat keine Transformationen.</translation>
    </message>
    <message>
        <source>The entry that opens here is not closed by “}” before the next entry or the end of the file.</source>
        <translation>Der hier beginnende Eintrag wird vor dem nächsten Eintrag oder dem Ende der Datei nicht mit „}“ geschlossen.</translation>
    </message>
    <message>
        <source>%1 more problems in this entry are not listed.</source>
        <translation>%1 weitere Probleme dieses Eintrags sind nicht aufgeführt.</translation>
    </message>
    <message>
        <source>The name “%1” holds a blank; Fractint takes only its first word.</source>
        <translation>Der Name „%1“ enthält ein Leerzeichen; Fractint nimmt nur sein erstes Wort.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint cuts it there.</source>
        <translation>Der Name „%1“ ist länger als 18 Bytes; Fractint schneidet ihn dort ab.</translation>
    </message>
    <message>
        <source>The opening brace stands on a line of its own; Fractint does not find this entry.</source>
        <translation>Die öffnende Klammer steht in einer eigenen Zeile; Fractint findet diesen Eintrag nicht.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>Der Eintrag hat mehr als %1 Abbildungen; das ist die Grenze.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be read as a decimal point or between two numbers, and both give whole rows. Write decimal points and blanks.</source>
        <translation>„%1“: Das Komma kann als Dezimalzeichen oder zwischen zwei Zahlen gelesen werden, und beides ergibt ganze Zeilen. Schreiben Sie Dezimalpunkte und Leerzeichen.</translation>
    </message>
    <message>
        <source>“%1”: neither as a decimal point nor between two numbers does the comma give whole rows of 7 numbers (13 with “(3D)”).</source>
        <translation>„%1“: Weder als Dezimalzeichen noch zwischen zwei Zahlen ergibt das Komma ganze Zeilen von 7 Zahlen (13 mit „(3D)“).</translation>
    </message>
    <message>
        <source>The numbers on the line of the opening brace are ignored, as Fractint ignores them.</source>
        <translation>Die Zahlen in der Zeile der öffnenden Klammer werden übergangen, wie Fractint sie übergeht.</translation>
    </message>
    <message>
        <source>“%1” is not understood by this version of Barycage; the line is kept.</source>
        <translation>„%1“ wird von dieser Version von Barycage nicht verstanden; die Zeile bleibt erhalten.</translation>
    </message>
    <message>
        <source>The entry holds no numbers.</source>
        <translation>Der Eintrag enthält keine Zahlen.</translation>
    </message>
    <message>
        <source>This line has %1 numbers and the entry %2, which is no multiple of %3: a map is %3 numbers%4.</source>
        <translation>Diese Zeile hat %1 Zahlen und der Eintrag %2, was kein Vielfaches von %3 ist: Eine Abbildung besteht aus %3 Zahlen%4.</translation>
    </message>
    <message>
        <source> in an entry marked “(3D)”</source>
        <translation> in einem Eintrag mit „(3D)“</translation>
    </message>
    <message>
        <source>“%1” is not a plain number: Fractint reads %2 and ignores the rest. Write it as one decimal number.</source>
        <translation>„%1“ ist keine einfache Zahl: Fractint liest %2 und übergeht den Rest. Schreiben Sie es als eine Dezimalzahl.</translation>
    </message>
    <message>
        <source>“%1” is not a finite number.</source>
        <translation>„%1“ ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>“%1” is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>„%1“ ist größer, als ein Koeffizient sein kann (3,4e38).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Write the plain “-”.</source>
        <translation>„%1“ beginnt mit einem typografischen Minuszeichen (U+2212). Schreiben Sie das einfache „-“.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>Numbers stand on the line of the opening brace, where Fractint ignores them; they are read.</source>
        <translation>In der Zeile der öffnenden Klammer stehen Zahlen, wo Fractint sie übergeht; sie werden gelesen.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads other numbers here.</source>
        <translation>Kommas werden als Dezimalzeichen gelesen; Fractint liest hier andere Zahlen.</translation>
    </message>
    <message>
        <source>Commas or apostrophes stand between the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Zwischen den Zahlen stehen Kommas oder Apostrophe; Iterated Dynamics kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each); weights are taken from the determinants. Fractint cannot read this entry.</source>
        <translation>Die Abbildungen haben keine Gewichte (je %1 Zahlen); die Gewichte kommen von den Determinanten. Fractint kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Zeilen von %1 Zahlen ohne „(3D)“ hinter dem Namen werden als 3D-System gelesen; Fractint kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>The lines do not hold 7 numbers each, but all numbers together fill rows of 7 and are read so, as Fractint does. Probably the weights are missing.</source>
        <translation>Die Zeilen haben nicht je 7 Zahlen, aber alle Zahlen zusammen füllen Zeilen von 7 und werden so gelesen, wie bei Fractint. Wahrscheinlich fehlen die Gewichte.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>Die schließende Klammer berührt die letzte Zahl; Fractint kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint cuts it there.</source>
        <translation>Die Zeile ist länger als 200 Bytes; Fractint schneidet sie dort ab.</translation>
    </message>
    <message>
        <source>A NUL byte; the rest of the line is ignored, as Fractint ignores it.</source>
        <translation>Ein NUL-Byte; der Rest der Zeile wird übergangen, wie Fractint ihn übergeht.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>Der Eintrag hat %1 Abbildungen; Fractint und Iterated Dynamics lesen höchstens 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map counts as switched off.</source>
        <translation>Das Gewicht der Abbildung %1 ist negativ; die Abbildung gilt als ausgeschaltet.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0; the map takes no part.</source>
        <translation>Das Gewicht der Abbildung %1 ist 0; die Abbildung nimmt nicht teil.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are used in proportion; Fractint gives what is missing to the last map and cuts what is too much.</source>
        <translation>Die Summe der Gewichte ist %1 und nicht 1. Sie werden im Verhältnis benutzt; Fractint gibt, was fehlt, der letzten Abbildung und kürzt, was zu viel ist.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>These are Fractint parameter sets or formulas; no iterated function system is among them.</source>
        <translation>Dies sind Parametersätze oder Formeln von Fractint; kein iteriertes Funktionensystem ist darunter.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry is a name, “{”, rows of 7 numbers and “}”.</source>
        <translation>Kein iteriertes Funktionensystem wurde gefunden: Ein Eintrag besteht aus Name, „{“, Zeilen von 7 Zahlen und „}“.</translation>
    </message>
    <message>
        <source>The file has more than %1 entries; the rest is kept as text but not shown.</source>
        <translation>Die Datei hat mehr als %1 Einträge; der Rest bleibt als Text erhalten, wird aber nicht gezeigt.</translation>
    </message>
    <message>
        <source>A block without a name is kept as text; Fractint does not list it.</source>
        <translation>Ein Block ohne Namen bleibt als Text erhalten; Fractint führt ihn nicht auf.</translation>
    </message>
    <message>
        <source>Two opening braces on one line: no reader finds an entry here. The text is kept.</source>
        <translation>Zwei öffnende Klammern in einer Zeile: Kein Programm findet hier einen Eintrag. Der Text bleibt erhalten.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>„%1“ ist ein Parametersatz oder eine Formel, kein iteriertes Funktionensystem; es bleibt als Text erhalten.</translation>
    </message>
    <message>
        <source>The name is taken by the entry in line %1 (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>Den Namen trägt schon der Eintrag in Zeile %1 (Fractint vergleicht 18 Zeichen ohne Groß- und Kleinschreibung); Fractint erreicht diesen nie.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint takes for a part of the first name.</source>
        <translation>Die Datei beginnt mit einer Bytereihenfolgemarke, die Fractint für einen Teil des ersten Namens hält.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); the entries after it are read all the same.</source>
        <translation>Fractint hört bei diesem Byte (^Z) zu lesen auf; die Einträge danach werden trotzdem gelesen.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use the first 2000.</source>
        <translation>Die Datei hat %1 Einträge; Fractint und Iterated Dynamics benutzen die ersten 2000.</translation>
    </message>
    <message>
        <source>The entry has no map that takes part and is left out.</source>
        <translation>Der Eintrag hat keine beteiligte Abbildung und wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 maps that take no part are left out.</source>
        <translation>%1 unbeteiligte Abbildungen werden weggelassen.</translation>
    </message>
    <message>
        <source>The entry is written under the name “%1”: other programs take 18 plain characters, and each name once.</source>
        <translation>Der Eintrag wird unter dem Namen „%1“ geschrieben: Andere Programme nehmen 18 einfache Zeichen, und jeden Namen einmal.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>Der Eintrag hat %1 Abbildungen; Fractint bis 17.2 liest höchstens 31.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>hyperbolisch, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 from words of length %2</source>
        <translation>schließlich kontraktiv, γ = %1 aus Wörtern der Länge %2</translation>
    </message>
    <message>
        <source>none: a word of length %1 does not contract</source>
        <translation>keiner: Ein Wort der Länge %1 kontrahiert nicht</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>none: no map takes part</source>
        <translation>keiner: Keine Abbildung nimmt teil</translation>
    </message>
    <message>
        <source>   norm %1, determinant %2</source>
        <translation>   Norm %1, Determinante %2</translation>
    </message>
    <message>
        <source>map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>attractor</source>
        <translation>Attraktor</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>covariance</source>
        <translation>Kovarianz</translation>
    </message>
    <message>
        <source>bounding box</source>
        <translation>umschließendes Rechteck</translation>
    </message>
    <message>
        <source>canonical simplex</source>
        <translation>kanonisches Simplex</translation>
    </message>
    <message>
        <source>convex hull</source>
        <translation>konvexe Hülle</translation>
    </message>
    <message>
        <source>%1 vertices, %2 facets, volume %3; error at most %4</source>
        <translation>%1 Ecken, %2 Seitenflächen, Volumen %3; Fehler höchstens %4</translation>
    </message>
    <message>
        <source>similarity dimension</source>
        <translation>Ähnlichkeitsdimension</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>Affinitätsdimension</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2 maps</source>
        <translation>%1 — in der Ebene, %2 Abbildungen</translation>
    </message>
    <message>
        <source>%1 — in space, %2 maps</source>
        <translation>%1 — im Raum, %2 Abbildungen</translation>
    </message>
    <message>
        <source>%1 — could not be read</source>
        <translation>%1 — konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>cage at rest</source>
        <translation>Käfig in Ruhe</translation>
    </message>
    <message>
        <source>cage now</source>
        <translation>Käfig jetzt</translation>
    </message>
    <message>
        <source>The stored cage is not usable (its lists of vertices do not match, or its rest vertices lie on one line, cross each other or are more than 64) and is not applied.</source>
        <translation>Der gespeicherte Käfig ist nicht brauchbar (seine Eckenlisten passen nicht zusammen, oder seine Ruheecken liegen auf einer Geraden, überkreuzen sich oder sind mehr als 64) und wird nicht angewandt.</translation>
    </message>
    <message>
        <source>The stored palette “%1” is unknown and is not applied.</source>
        <translation>Die gespeicherte Palette „%1“ ist unbekannt und wird nicht angewandt.</translation>
    </message>
    <message>
        <source>Map %1 was switched off here, but another program has given it a weight.</source>
        <translation>Abbildung %1 war hier ausgeschaltet, aber ein anderes Programm hat ihr ein Gewicht gegeben.</translation>
    </message>
    <message>
        <source>A palette has at most %1 colours; the others are left out.</source>
        <translation>Eine Palette hat höchstens %1 Farben; die übrigen werden weggelassen.</translation>
    </message>
    <message>
        <source>This line is left out: three whole numbers from 0 to 255 make a colour.</source>
        <translation>Diese Zeile wird weggelassen: Drei ganze Zahlen von 0 bis 255 ergeben eine Farbe.</translation>
    </message>
    <message>
        <source>The file holds no colours.</source>
        <translation>Die Datei enthält keine Farben.</translation>
    </message>
    <message>
        <source>The file has more than 16 MB, which no palette needs.</source>
        <translation>Die Datei hat mehr als 16 MB; das braucht keine Palette.</translation>
    </message>
    <message>
        <source>The file is no text, so it is no palette.</source>
        <translation>Die Datei ist kein Text, also keine Palette.</translation>
    </message>
    <message>
        <source>This is a GIMP gradient; palettes are read from .gpl, .ugr and .map files.</source>
        <translation>Dies ist ein GIMP-Farbverlauf; Paletten werden aus .gpl-, .ugr- und .map-Dateien gelesen.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the others are left out.</source>
        <translation>Die Datei hat mehr als %1 Paletten; die übrigen werden weggelassen.</translation>
    </message>
    <message>
        <source>The file holds no gradient.</source>
        <translation>Die Datei enthält keinen Farbverlauf.</translation>
    </message>
    <message>
        <source>The gradient of line %1 is not closed.</source>
        <translation>Der Farbverlauf von Zeile %1 ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>“%1” is no whole number.</source>
        <translation>„%1“ ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, of which alone points are written.</source>
        <translation>„%1“ ist kein System der Ebene; nur von solchen werden Punkte geschrieben.</translation>
    </message>
    <message>
        <source>“%1” has no map that takes part, so it has no points.</source>
        <translation>„%1“ hat keine beteiligte Abbildung und also keine Punkte.</translation>
    </message>
    <message>
        <source>A cage of more than three corners bends the picture, and its points are not written.</source>
        <translation>Ein Käfig mit mehr als drei Ecken biegt das Bild; dessen Punkte werden nicht geschrieben.</translation>
    </message>
    <message>
        <source>A point cloud has from 1 to %1 points.</source>
        <translation>Eine Punktwolke hat 1 bis %1 Punkte.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>„%1“ ist ein Ordner. Wählen Sie einen Dateinamen.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and is not replaced. Choose another name.</source>
        <translation>„%1“ ist keine gewöhnliche Datei und wird nicht ersetzt. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The folder “%1” does not exist. Create it, or save somewhere else.</source>
        <translation>Der Ordner „%1“ existiert nicht. Legen Sie ihn an oder speichern Sie anderswo.</translation>
    </message>
    <message>
        <source>“%1” is read-only. Save under another name, or change its permissions.</source>
        <translation>„%1“ ist schreibgeschützt. Speichern Sie unter anderem Namen oder ändern Sie die Rechte.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again; the file on the disk is as it was.</source>
        <translation>„%1“ wurde nicht gespeichert: Der Datenträger ist voll. Schaffen Sie Platz und speichern Sie noch einmal; die Datei ist, wie sie war.</translation>
    </message>
    <message>
        <source>“%1” was not saved: you may not write to the folder “%2”. Save somewhere else.</source>
        <translation>„%1“ wurde nicht gespeichert: Sie dürfen nicht in den Ordner „%2“ schreiben. Speichern Sie anderswo.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>„%1“ wurde nicht gespeichert: Der Name ist zu lang.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2. The file on the disk is as it was.</source>
        <translation>„%1“ wurde nicht gespeichert: %2. Die Datei ist, wie sie war.</translation>
    </message>
    <message>
        <source>The file has no name. Choose one.</source>
        <translation>Die Datei hat keinen Namen. Wählen Sie einen.</translation>
    </message>
    <message>
        <source>“%1” does not exist.</source>
        <translation>„%1“ existiert nicht.</translation>
    </message>
    <message>
        <source>“%1” is a folder, not a file.</source>
        <translation>„%1“ ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>“%1” is larger than 256 MB, which is the limit for a file.</source>
        <translation>„%1“ ist größer als 256 MB; das ist die Grenze für eine Datei.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>„%1“ kann nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>Only plane systems can be written as a scalable picture.</source>
        <translation>Nur Systeme der Ebene können als skalierbares Bild geschrieben werden.</translation>
    </message>
    <message>
        <source>The system has no attractor of which an outline could be certified, so there is nothing to make copies of.</source>
        <translation>Das System hat keinen Attraktor, dessen Umriss bewiesen werden könnte; es gibt nichts zu kopieren.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>In dieser Ansicht ist das Bild zu groß, um als Formen geschrieben zu werden.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row is a b c d e f and perhaps a weight.</source>
        <translation>Es gibt keine Zeilen von Zahlen: Eine Zeile ist a b c d e f und vielleicht ein Gewicht.</translation>
    </message>
    <message>
        <source>After the count, a map is its weight and a matrix of 3 rows.</source>
        <translation>Nach der Anzahl besteht eine Abbildung aus ihrem Gewicht und einer Matrix von 3 Zeilen.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map is 0 0 1.</source>
        <translation>Die letzte Zeile der Matrix einer affinen Abbildung ist 0 0 1.</translation>
    </message>
    <message>
        <source>The table says that it has %1 maps, and it has %2.</source>
        <translation>Die Tabelle gibt %1 Abbildungen an und hat %2.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>Die Überschrift sagt nicht, welche Spalte a, b, c, d, e und f ist; wählen Sie die Reihenfolge der Spalten.</translation>
    </message>
    <message>
        <source>This row has %1 numbers; a map is 6 numbers, or 7 with its weight.</source>
        <translation>Diese Zeile hat %1 Zahlen; eine Abbildung hat 6 Zahlen, oder 7 mit ihrem Gewicht.</translation>
    </message>
    <message>
        <source>“%1” is not a decimal number.</source>
        <translation>„%1“ ist keine Dezimalzahl.</translation>
    </message>
    <message>
        <source>The table has more than %1 rows, which is the limit.</source>
        <translation>Die Tabelle hat mehr als %1 Zeilen; das ist die Grenze.</translation>
    </message>
    <message>
        <source>This is a %1 file, not a text with iterated function systems.</source>
        <translation>Dies ist eine %1-Datei, kein Text mit iterierten Funktionensystemen.</translation>
    </message>
    <message>
        <source>This is a text in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
        <translation>Dies ist ein Text in UTF-16. Speichern Sie ihn als UTF-8 oder ASCII und öffnen Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>This is a list written by a Racket program (wgmitchener&apos;s IFS editor), not a Fractint collection.</source>
        <translation>Dies ist eine Liste eines Racket-Programms (IFS-Editor von wgmitchener), keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is a flame file (XML), not a Fractint collection.</source>
        <translation>Dies ist eine Flame-Datei (XML), keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is an SVG picture, not a Fractint collection.</source>
        <translation>Dies ist ein SVG-Bild, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is an XML file of an IFS program such as IFS Explorer, not a Fractint collection.</source>
        <translation>Dies ist eine XML-Datei eines IFS-Programms wie IFS Explorer, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is an XML or HTML file, not a Fractint collection.</source>
        <translation>Dies ist eine XML- oder HTML-Datei, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is an IFStile file (.aifs), not a Fractint collection.</source>
        <translation>Dies ist eine IFStile-Datei (.aifs), keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is a XaoS position file, not a Fractint collection.</source>
        <translation>Dies ist eine XaoS-Positionsdatei, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>The lines are expressions in x and y, as pyfractal writes them, not a Fractint collection.</source>
        <translation>Die Zeilen sind Ausdrücke in x und y, wie pyfractal sie schreibt, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is a table of the program Fraktale: a count, maps with cumulative percentages and a window. It is not a Fractint collection.</source>
        <translation>Dies ist eine Tabelle des Programms Fraktale: eine Anzahl, Abbildungen mit aufsummierten Prozenten und ein Fenster. Es ist keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This table has 5 numbers per map (scales, shifts and a rotation in pixels). It is not a Fractint collection.</source>
        <translation>Diese Tabelle hat 5 Zahlen je Abbildung (Skalierungen, Verschiebungen und eine Drehung in Pixeln). Es ist keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is a StyrofoamIFS script, not a Fractint collection.</source>
        <translation>Dies ist ein StyrofoamIFS-Skript, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text with iterated function systems.</source>
        <translation>Dies ist eine Binärdatei (vielleicht ein fraktal komprimiertes Bild oder eine Symbolbibliothek), kein Text mit iterierten Funktionensystemen.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and for a table of numbers the file is too large: the limit is 64 MB.</source>
        <translation>Kein iteriertes Funktionensystem wurde gefunden, und für eine Zahlentabelle ist die Datei zu groß: Die Grenze ist 64 MB.</translation>
    </message>
    <message>
        <source>a number is larger than a coefficient can be (3.4e38 in size)</source>
        <translation>eine Zahl ist größer, als ein Koeffizient sein kann (3.4e38)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest is left out.</source>
        <translation>Die Datei hat mehr als %1 Flames; der Rest wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 flames in all are no systems of affine maps.</source>
        <translation>Insgesamt %1 Flames sind keine Systeme affiner Abbildungen.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>Der Eintrag hat mehr als %1 Zeilen; das ist die Grenze. Er bleibt als Text erhalten.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1 Ecken, davon %2 mit periodischen Adressen, Fläche %3; Fehler höchstens %4</translation>
    </message>
    <message>
        <source>deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>affine fit</source>
        <translation>affine Anpassung</translation>
    </message>
    <message>
        <source>A number of this row is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>Eine Zahl dieser Zeile ist größer, als ein Koeffizient sein kann (3.4e38).</translation>
    </message>
    <message>
        <source>The text has more than 64 MB, which is the limit for a table of numbers.</source>
        <translation>Der Text hat mehr als 64 MB; das ist die Grenze für eine Zahlentabelle.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Ein Element hat mehr als %1 Attribute; das ist die Grenze.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 deep, which is the limit.</source>
        <translation>Die Elemente sind tiefer als %1 verschachtelt; das ist die Grenze.</translation>
    </message>
    <message>
        <source>The file has more than 64 MB, which is the limit for XML.</source>
        <translation>Die Datei hat mehr als 64 MB; das ist die Grenze für XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>verschobener Ast</translation>
    </message>
    <message>
        <source>A stored place of a branch is not usable (its map is incomplete, or its address names maps that are not there, or occurs twice, or there are too many) and is not applied.</source>
        <translation>Ein gespeicherter Ort eines Astes ist nicht brauchbar (seine Abbildung ist unvollständig, seine Adresse nennt Abbildungen, die es nicht gibt, oder kommt zweimal vor, oder es sind zu viele) und wird nicht angewandt.</translation>
    </message>
    <message>
        <source>%1 lines of blocks that are no iterated function systems are left out.</source>
        <translation>%1 Zeilen von Blöcken, die keine iterierten Funktionensysteme sind, werden weggelassen.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Eine Zelle dieser Zeile ist leer.</translation>
    </message>
    <message>
        <source>A comma can be read as a decimal point or between two numbers here, and both give whole rows. Write decimal points.</source>
        <translation>Ein Komma kann hier als Dezimalzeichen oder zwischen zwei Zahlen gelesen werden, und beides ergibt ganze Zeilen. Schreiben Sie Dezimalpunkte.</translation>
    </message>
    <message>
        <source>The cage and the colours of the entry are left out.</source>
        <translation>Der Käfig und die Farben des Eintrags werden weggelassen.</translation>
    </message>
    <message>
        <source>The code is written without its cage and moved branches: other programs draw another picture.</source>
        <translation>Der Code wird ohne seinen Käfig und verschobene Äste geschrieben: andere Programme zeichnen ein anderes Bild.</translation>
    </message>
    <message>
        <source>The table has maps of the plane and maps of space.</source>
        <translation>Die Tabelle hat Abbildungen der Ebene und Abbildungen des Raums.</translation>
    </message>
    <message>
        <source>This is a list of other files, as the program Fraktale has one, not a Fractint collection.</source>
        <translation>Dies ist eine Liste anderer Dateien, wie das Programm Fraktale sie hat, keine Fractint-Sammlung.</translation>
    </message>
    <message>
        <source>This row has %1 numbers, and the header names %2 columns.</source>
        <translation>Diese Zeile hat %1 Zahlen, und die Überschrift nennt %2 Spalten.</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>Grund</translation>
    </message>
    <message numerus="yes">
        <source>%n more maps</source>
        <translation>
            <numerusform>%n weitere Abbildung</numerusform>
            <numerusform>%n weitere Abbildungen</numerusform>
        </translation>
    </message>
    <message>
        <source>No column is called “%1”: they are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Keine Spalte heißt „%1“: Es gibt a b c d oder r s theta phi, e f, und p oder cumulative.</translation>
    </message>
    <message>
        <source>“%1” is there twice.</source>
        <translation>„%1“ kommt zweimal vor.</translation>
    </message>
    <message>
        <source>A row has one weight: p or cumulative.</source>
        <translation>Eine Zeile hat ein Gewicht: p oder cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi do not go together.</source>
        <translation>a b c d und r s theta phi passen nicht zusammen.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Es fehlt: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than programs read in one path. Choose a smaller depth.</source>
        <translation>Der Umriss hat mehr Ecken, als Programme in einem Pfad lesen. Wählen Sie eine kleinere Tiefe.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers are those of the picture at rest.</source>
        <translation>Der Käfig biegt das Bild oder drückt es flach. Die Zahlen sind die des Bildes in Ruhe.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8. Please rename the file, or lead to it by a link.</source>
        <translation>Der Name „%1“ ist nicht in UTF-8. Bitte benennen Sie die Datei um, oder führen Sie durch einen Link zu ihr.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so the weights of all maps are taken from the determinants and those that are given are not used.</source>
        <translation>Die Abbildung %1 hat kein Gewicht; daher kommen die Gewichte aller Abbildungen von den Determinanten, und die angegebenen werden nicht verwendet.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Contraction</source>
        <translation>Kontraktion</translation>
    </message>
    <message>
        <source>Every row of this table is a map that makes a smaller copy of the whole, and the picture is all copies together. Double-click a number and type another: the copy moves as you type. ‖A‖ is the most by which a map stretches. While it is less than 1, the map contracts. Ctrl+Z takes everything back.</source>
        <translation>Jede Zeile dieser Tabelle ist eine Abbildung, die eine kleinere Kopie des Ganzen macht, und das Bild sind alle Kopien zusammen. Klicken Sie doppelt auf eine Zahl und tippen Sie eine andere: Die Kopie bewegt sich mit. ‖A‖ ist das Meiste, um das eine Abbildung streckt. Solange es kleiner als 1 ist, kontrahiert sie. Strg+Z nimmt alles zurück.</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Fixpunkt</translation>
    </message>
    <message>
        <source>A map that contracts leaves exactly one point where it is: its fixed point. Switch off all maps but two by the boxes on the left of the table, and see how little is left of the picture. With one map alone nothing is left but its fixed point. Ctrl+Z brings the maps back.</source>
        <translation>Eine kontrahierende Abbildung lässt genau einen Punkt, wo er ist: ihren Fixpunkt. Schalten Sie mit den Kästchen links in der Tabelle alle Abbildungen bis auf zwei aus und sehen Sie, wie wenig vom Bild bleibt. Bei einer einzigen bleibt nichts als ihr Fixpunkt. Strg+Z bringt die Abbildungen zurück.</translation>
    </message>
    <message>
        <source>Chaos game</source>
        <translation>Chaos-Spiel</translation>
    </message>
    <message>
        <source>Press Chaos Game and then the triangle that starts it. One point jumps about, each time by a map drawn at random, and leaves a dot where it lands. Let it go faster: whatever the dice say, the dots fill the same picture, the attractor.</source>
        <translation>Drücken Sie „Chaos-Spiel“ und dann das Dreieck, das es startet. Ein Punkt springt umher, jedes Mal nach einer ausgelosten Abbildung, und hinterlässt einen Fleck, wo er landet. Lassen Sie es schneller laufen: Was auch die Würfel sagen, die Flecken füllen dasselbe Bild, den Attraktor.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The map that made the last jump to a point, the one before it, and so on: these numbers are the address of the point. Choose Colour by: Address. Points whose addresses begin alike lie close together, and now they look alike.</source>
        <translation>Die Abbildung des letzten Sprungs zu einem Punkt, die davor, und so weiter: Diese Zahlen sind die Adresse des Punktes. Wählen Sie „Färben nach: Adresse“. Punkte, deren Adressen gleich beginnen, liegen nah beieinander, und nun sehen sie auch so aus.</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Baryzentrische Koordinaten</translation>
    </message>
    <message>
        <source>Every point of the picture is a weighted mean of the three corners of the triangle. Take a corner and pull: the points keep their weights, and the whole fractal follows. Squeeze the triangle flat and open it again: nothing is lost. The weights at the pointer stand at the bottom of the window.</source>
        <translation>Jeder Punkt des Bildes ist ein gewichtetes Mittel der drei Ecken des Dreiecks. Fassen Sie eine Ecke und ziehen Sie: Die Punkte behalten ihre Gewichte, und das ganze Fraktal folgt. Drücken Sie das Dreieck flach und öffnen Sie es wieder: Nichts geht verloren. Die Gewichte beim Zeiger stehen unten im Fenster.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Dimension</translation>
    </message>
    <message>
        <source>How much of the plane does the attractor fill? The dimension of a curve is 1, that of an area is 2, and most attractors lie between the two. Change a map and look here again. That was the tour; the user guide under Help tells the rest.</source>
        <translation>Wie viel von der Ebene füllt der Attraktor? Die Dimension einer Kurve ist 1, die einer Fläche 2, und die meisten Attraktoren liegen dazwischen. Ändern Sie eine Abbildung und sehen Sie wieder hierher. Das war der Rundgang; das Handbuch unter „Hilfe“ erzählt den Rest.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>New here?</source>
        <translation>Neu hier?</translation>
    </message>
    <message>
        <source>Six short steps show what an attractor is, by pulling on one. You can take the tour later, too: it is in the Help menu.</source>
        <translation>Sechs kurze Schritte zeigen, was ein Attraktor ist, indem Sie an einem ziehen. Der Rundgang ist auch später im Menü „Hilfe“ zu finden.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Start the Tour</source>
        <translation>Rundgang &amp;starten</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>The last files, and the collection.</source>
        <translation>Die letzten Dateien und die Sammlung.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Weiter mit</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>A file, or the collection.</source>
        <translation>Eine Datei oder die Sammlung.</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <source>Co&amp;llection</source>
        <translation>&amp;Sammlung</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Takes what the dialog shows, and closes it.</source>
        <translation>Übernimmt, was der Dialog zeigt, und schließt ihn.</translation>
    </message>
    <message>
        <source>Closes the dialog and changes nothing.</source>
        <translation>Schließt den Dialog und ändert nichts.</translation>
    </message>
    <message>
        <source>Closes the dialog.</source>
        <translation>Schließt den Dialog.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Dieser Eintrag hat keine Abbildungen der Ebene.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Affin invariante Form</translation>
    </message>
    <message>
        <source>Row j of a matrix holds the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. The matrices do not change when the triangle is dragged. Where no entry is negative, the map takes the triangle into itself.</source>
        <translation>Zeile j einer Matrix enthält die baryzentrischen Koordinaten des Bildes der Ecke j im Dreieck; jede Zeile hat also die Summe 1. Die Matrizen ändern sich nicht, wenn das Dreieck gezogen wird. Wo kein Eintrag negativ ist, führt die Abbildung das Dreieck in sich über.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Every map as a matrix that takes barycentric coordinates over the control triangle to barycentric coordinates: each row has the sum 1.</source>
        <translation>Jede Abbildung als Matrix, die baryzentrische Koordinaten über dem Kontrolldreieck in baryzentrische Koordinaten überführt: Jede Zeile hat die Summe 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices with all digits.</source>
        <translation>Kopiert das Dreieck und die Matrizen mit allen Stellen.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy takes all of them.
</source>
        <translation>
… und %1 weitere. „Kopieren“ nimmt alle.
</translation>
    </message>
</context>
<context>
    <name>view::AnalysisPanel</name>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Copy All</source>
        <translation>Alles kopieren</translation>
    </message>
    <message>
        <source>Copy all facts with all digits</source>
        <translation>Alle Tatsachen mit allen Stellen kopieren</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D: noch nicht gezeigt.</translation>
    </message>
    <message>
        <source>This entry could not be read, so nothing is known of it.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden; es ist nichts von ihm bekannt.</translation>
    </message>
    <message>
        <source>Copy with All Digits</source>
        <translation>Mit allen Stellen kopieren</translation>
    </message>
    <message>
        <source>Copy All Facts</source>
        <translation>Alle Tatsachen kopieren</translation>
    </message>
    <message>
        <source>Copies every line as its name and its value with all digits.</source>
        <translation>Kopiert jede Zeile als Namen und Wert mit allen Stellen.</translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation>Auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Outline the certified bounding box</source>
        <translation>Das bewiesene umschließende Rechteck zeichnen</translation>
    </message>
    <message>
        <source>Hull</source>
        <translation>Hülle</translation>
    </message>
    <message>
        <source>Outline the convex hull</source>
        <translation>Die konvexe Hülle zeichnen</translation>
    </message>
    <message>
        <source>Simplex</source>
        <translation>Simplex</translation>
    </message>
    <message>
        <source>Outline the minimal canonical simplex</source>
        <translation>Das minimale kanonische Simplex zeichnen</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Show the mean and the ellipse of the covariance</source>
        <translation>Den Mittelwert und die Ellipse der Kovarianz zeigen</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Fixpunkte</translation>
    </message>
    <message>
        <source>Mark the fixed point of each map in its colour</source>
        <translation>Den Fixpunkt jeder Abbildung in ihrer Farbe zeigen</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with an address of the same length, in the colour of its first map</source>
        <translation>Die Hüllen aller Teile mit gleich langer Adresse zeichnen, in der Farbe ihrer ersten Abbildung</translation>
    </message>
    <message>
        <source>Length of the addresses</source>
        <translation>Länge der Adressen</translation>
    </message>
    <message>
        <source>How many symbols the addresses of the cylinders have; fewer where there would be thousands</source>
        <translation>Wie viele Zeichen die Adressen der Zylinder haben; weniger, wo es Tausende wären</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Adresslänge</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system has it. These are facts of the code; on the canvas they are bent with the picture.</source>
        <translation>Der Käfig biegt das Bild, und kein System hat es. Dies sind Tatsachen des Codes; auf der Zeichenfläche sind sie mit dem Bild gebogen.</translation>
    </message>
</context>
<context>
    <name>view::AppearancePanel</name>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Reset to Default</source>
        <translation>Auf Standard zurücksetzen</translation>
    </message>
    <message>
        <source>Every setting of this panel as in a new fractal</source>
        <translation>Alle Einstellungen dieses Felds wie bei einem neuen Fraktal</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>The palette follows the density of points</source>
        <translation>Die Palette folgt der Dichte der Punkte</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>The colour of the last map applied</source>
        <translation>Die Farbe der zuletzt angewandten Abbildung</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The palette follows the address of each point</source>
        <translation>Die Palette folgt der Adresse jedes Punktes</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>One colour; the density is its opacity</source>
        <translation>Eine Farbe; die Dichte ist ihre Deckkraft</translation>
    </message>
    <message>
        <source>Change what the colour shows</source>
        <translation>Ändern, was die Farbe zeigt</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Einzelfarbe</translation>
    </message>
    <message>
        <source>Change the plain colour</source>
        <translation>Die Einzelfarbe ändern</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Change the palette</source>
        <translation>Die Palette ändern</translation>
    </message>
    <message>
        <source>Edit Palette</source>
        <translation>Palette bearbeiten</translation>
    </message>
    <message>
        <source>Edit the palette, or load one from a file</source>
        <translation>Die Palette bearbeiten oder eine aus einer Datei laden</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Hintergrundfarbe</translation>
    </message>
    <message>
        <source>Change the background colour</source>
        <translation>Die Hintergrundfarbe ändern</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Make the background transparent</source>
        <translation>Den Hintergrund durchsichtig machen</translation>
    </message>
    <message>
        <source>Make the background opaque</source>
        <translation>Den Hintergrund undurchsichtig machen</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Change the brightness</source>
        <translation>Die Helligkeit ändern</translation>
    </message>
    <message>
        <source>How early thin parts become visible: κ of the logarithmic tone curve</source>
        <translation>Wie früh dünne Teile sichtbar werden: κ der logarithmischen Tonkurve</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Change the gamma</source>
        <translation>Das Gamma ändern</translation>
    </message>
    <message>
        <source>Exponent of the tone curve: higher values lift the dark parts</source>
        <translation>Exponent der Tonkurve: Höhere Werte heben die dunklen Teile</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Überabtastung</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>%1 × %1 sub-pixels</source>
        <translation>%1 × %1 Unterpixel</translation>
    </message>
    <message>
        <source>Change the supersampling</source>
        <translation>Die Überabtastung ändern</translation>
    </message>
    <message>
        <source>Map colours</source>
        <translation>Farben der Abbildungen</translation>
    </message>
    <message>
        <source>Reset the appearance</source>
        <translation>Das Aussehen zurücksetzen</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Farbe der Abbildung %1</translation>
    </message>
    <message>
        <source>Change the colour of map %1</source>
        <translation>Die Farbe der Abbildung %1 ändern</translation>
    </message>
    <message>
        <source>What the colour of a point tells: how many points fall there, which map came last, or the whole address.</source>
        <translation>Was die Farbe eines Punktes sagt: wie viele Punkte dorthin fallen, welche Abbildung zuletzt kam, oder die ganze Adresse.</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, or along the addresses.</source>
        <translation>Die Farben von den dünnsten zu den dichtesten Teilen oder die Adressen entlang.</translation>
    </message>
    <message>
        <source>Leaves the background out of exported pictures.</source>
        <translation>Lässt den Hintergrund aus exportierten Bildern weg.</translation>
    </message>
    <message>
        <source>Draws every pixel from several finer ones: smoother edges, for more memory and time.</source>
        <translation>Zeichnet jedes Pixel aus mehreren feineren: glattere Ränder für mehr Speicher und Zeit.</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The number beside it is the same value.</source>
        <translation>Ziehen Sie oder benutzen Sie die Pfeiltasten. Die Zahl daneben ist derselbe Wert.</translation>
    </message>
</context>
<context>
    <name>view::ArisingBar</name>
    <message>
        <source>How the attractor arises</source>
        <translation>Wie der Attraktor entsteht</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>The invariant measure, refined while nothing moves</source>
        <translation>Das invariante Maß, verfeinert, solange sich nichts bewegt</translation>
    </message>
    <message>
        <source>Steps Wⁿ</source>
        <translation>Schritte Wⁿ</translation>
    </message>
    <message>
        <source>The deterministic algorithm: all maps applied n times to the cage at rest</source>
        <translation>Der deterministische Algorithmus: alle Abbildungen n-mal auf den ruhenden Käfig angewandt</translation>
    </message>
    <message>
        <source>Chaos Game</source>
        <translation>Chaos-Spiel</translation>
    </message>
    <message>
        <source>One point that jumps by maps drawn at random; the first 14 points are not plotted</source>
        <translation>Ein Punkt, der nach ausgelosten Abbildungen springt; die ersten 14 Punkte werden nicht gezeichnet</translation>
    </message>
    <message>
        <source>n: how often all maps are applied</source>
        <translation>n: wie oft alle Abbildungen angewandt werden</translation>
    </message>
    <message>
        <source>Begin Again</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>No points yet, and other dice</source>
        <translation>Noch keine Punkte, und andere Würfel</translation>
    </message>
    <message>
        <source>One Point</source>
        <translation>Ein Punkt</translation>
    </message>
    <message>
        <source>Plot one more point</source>
        <translation>Einen Punkt mehr zeichnen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Let points appear</source>
        <translation>Punkte erscheinen lassen</translation>
    </message>
    <message>
        <source>Points a second</source>
        <translation>Punkte je Sekunde</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>W%1: the cage itself</source>
        <translation>W%1: der Käfig selbst</translation>
    </message>
    <message>
        <source>W%1: %2 copies of the cage</source>
        <translation>W%1: %2 Kopien des Käfigs</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stay at these points</source>
        <translation>Bei diesen Punkten bleiben</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>, the last by map %1</source>
        <translation>, der letzte von Abbildung %1</translation>
    </message>
    <message>
        <source>How often all maps are applied to the cage: 0 is the cage itself, and with every step the picture comes closer to the attractor.</source>
        <translation>Wie oft alle Abbildungen auf den Käfig angewandt werden: 0 ist der Käfig selbst, und mit jedem Schritt kommt das Bild dem Attraktor näher.</translation>
    </message>
    <message>
        <source>How many points the chaos game plots in a second.</source>
        <translation>Wie viele Punkte das Chaos-Spiel in einer Sekunde zeichnet.</translation>
    </message>
    <message>
        <source>no points yet: press ▶</source>
        <translation>noch keine Punkte: ▶ drücken</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Diagramm der Kästchenzählung</translation>
    </message>
    <message>
        <source>How many boxes meet the attractor, against how fine they are: log₂ N over k for boxes of side L·2⁻ᵏ, L the side of the square around the attractor. Points in outline are left out of the line: there the size of the whole or of a cell shows.</source>
        <translation>Wie viele Kästchen den Attraktor treffen, gegen ihre Feinheit: log₂ N über k für Kästchen der Seite L·2⁻ᵏ, L die Seite des Quadrats um den Attraktor. Umrissene Punkte zählen für die Gerade nicht: Dort zeigt sich die Größe des Ganzen oder einer Zelle.</translation>
    </message>
    <message>
        <source>Slope %1 over %2 sizes</source>
        <translation>Steigung %1 über %2 Größen</translation>
    </message>
    <message>
        <source>Copy Sizes and Counts</source>
        <translation>Größen und Anzahlen kopieren</translation>
    </message>
    <message>
        <source>log₂ N</source>
        <translation>log₂ N</translation>
    </message>
    <message>
        <source>k, boxes of side L·2⁻ᵏ</source>
        <translation>k, Kästchen der Seite L·2⁻ᵏ</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>Steigung %1</translation>
    </message>
</context>
<context>
    <name>view::BranchBar</name>
    <message>
        <source>Maps and branches</source>
        <translation>Abbildungen und Äste</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Tiefe</translation>
    </message>
    <message>
        <source>Depth of the branch</source>
        <translation>Tiefe des Astes</translation>
    </message>
    <message>
        <source>How many maps of the address name the branch (Shift + wheel over the canvas)</source>
        <translation>Wie viele Abbildungen der Adresse den Ast benennen (Umschalt + Rad über der Zeichenfläche)</translation>
    </message>
    <message>
        <source>The address of the point clicked, outermost map first; the branch is what is bold</source>
        <translation>Die Adresse des angeklickten Punktes, äußerste Abbildung zuerst; der Ast ist, was fett ist</translation>
    </message>
    <message>
        <source>this branch, as a map of its own</source>
        <translation>diesen Ast, als eigene Abbildung</translation>
    </message>
    <message>
        <source>The system gets a map for this branch and one for every branch beside it. Its change is seen again at all smaller scales.</source>
        <translation>Das System bekommt eine Abbildung für diesen Ast und eine für jeden Ast daneben. Die Änderung zeigt sich in allen kleineren Größen wieder.</translation>
    </message>
    <message>
        <source>the last map of its address</source>
        <translation>die letzte Abbildung seiner Adresse</translation>
    </message>
    <message>
        <source>The code keeps its maps. All branches that this map makes change alike.</source>
        <translation>Der Code behält seine Abbildungen. Alle Äste, die diese Abbildung macht, ändern sich gleich.</translation>
    </message>
    <message>
        <source>What changing the branch changes</source>
        <translation>Was die Änderung des Astes ändert</translation>
    </message>
    <message>
        <source>&amp;Weave</source>
        <translation>&amp;Weben</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Winkel, um den die gewählten Abbildungen um ihre Wurzeln schwingen</translation>
    </message>
    <message>
        <source>Lets the selected maps swing, each about the image of the lowest point of the fractal; the slider goes back to the middle when it is let go</source>
        <translation>Lässt die gewählten Abbildungen schwingen, jede um das Bild des tiefsten Punktes des Fraktals; losgelassen geht der Regler in die Mitte zurück</translation>
    </message>
    <message>
        <source>no branch selected</source>
        <translation>kein Ast gewählt</translation>
    </message>
    <message>
        <source>branch &lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation>Ast &lt;b&gt;%1&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Let maps swing</source>
        <translation>Abbildungen schwingen lassen</translation>
    </message>
    <message>
        <source>where it is shown, and it alone</source>
        <translation>wo er gezeigt wird, und nur er</translation>
    </message>
    <message>
        <source>The code stays as it is. This branch is shown elsewhere, and nothing like it at other scales.</source>
        <translation>Der Code bleibt, wie er ist. Dieser Ast wird anderswo gezeigt, und nichts seinesgleichen in anderen Größen.</translation>
    </message>
    <message>
        <source>Put &amp;Back</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Put All &amp;Back</source>
        <translation>Alle &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Shows the branch where its maps put it</source>
        <translation>Zeigt den Ast dort, wohin ihn seine Abbildungen legen</translation>
    </message>
    <message>
        <source>Shows every branch where its maps put it</source>
        <translation>Zeigt jeden Ast dort, wohin ihn seine Abbildungen legen</translation>
    </message>
    <message>
        <source>Put branch %1 back</source>
        <translation>Ast %1 zurücksetzen</translation>
    </message>
    <message>
        <source>Put all branches back</source>
        <translation>Alle Äste zurücksetzen</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>Ä&amp;ndern</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Klicken Sie auf einen Punkt des Attraktors, um seinen Ast zu wählen.</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
    <message>
        <source>Move corner %1 of branch %2</source>
        <translation>Ecke %1 des Astes %2 bewegen</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Ast %1 bewegen</translation>
    </message>
    <message>
        <source>Rotate branch %1</source>
        <translation>Ast %1 drehen</translation>
    </message>
    <message>
        <source>Scale branch %1</source>
        <translation>Ast %1 skalieren</translation>
    </message>
    <message>
        <source>This branch is map 1 now. Numbers in the table change it further.</source>
        <translation>Dieser Ast ist jetzt Abbildung 1. Zahlen in der Tabelle ändern ihn weiter.</translation>
    </message>
</context>
<context>
    <name>view::CageActions</name>
    <message>
        <source>This entry is not a system of the plane, so it has no control cage.</source>
        <translation>Dieser Eintrag ist kein System der Ebene und hat daher keinen Kontrollkäfig.</translation>
    </message>
    <message>
        <source>The cage is too flat to be undone. Open it by dragging a vertex, or reset it, and try again.</source>
        <translation>Der Käfig ist zu flach, um ihn rückgängig zu machen. Öffnen Sie ihn durch Ziehen einer Ecke oder setzen Sie ihn zurück und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The three points lie on one line and hold no coordinates. Put the third one beside the line.</source>
        <translation>Die drei Punkte liegen auf einer Geraden und tragen keine Koordinaten. Setzen Sie den dritten neben die Gerade.</translation>
    </message>
    <message>
        <source>Fit the minimal canonical simplex</source>
        <translation>Das minimale kanonische Simplex anpassen</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Den Käfig zurücksetzen</translation>
    </message>
    <message>
        <source>Bake the placement into the code</source>
        <translation>Die Lage in den Code einrechnen</translation>
    </message>
    <message>
        <source>Define the control triangle</source>
        <translation>Das Kontrolldreieck festlegen</translation>
    </message>
    <message>
        <source>Vertex %1 is there already.</source>
        <translation>Die Ecke %1 ist schon dort.</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Ecke %1 bewegen</translation>
    </message>
    <message>
        <source>A cage has at most %1 vertices.</source>
        <translation>Ein Käfig hat höchstens %1 Ecken.</translation>
    </message>
    <message>
        <source>There is no room for a vertex here.</source>
        <translation>Hier ist kein Platz für eine Ecke.</translation>
    </message>
    <message>
        <source>Insert a vertex</source>
        <translation>Eine Ecke einfügen</translation>
    </message>
    <message>
        <source>A cage has at least three vertices.</source>
        <translation>Ein Käfig hat mindestens drei Ecken.</translation>
    </message>
    <message>
        <source>Without this vertex the cage at rest would cross itself or be flat.</source>
        <translation>Ohne diese Ecke würde sich der ruhende Käfig überkreuzen oder wäre flach.</translation>
    </message>
    <message>
        <source>Delete vertex %1</source>
        <translation>Ecke %1 löschen</translation>
    </message>
    <message>
        <source>Make the cage regular</source>
        <translation>Den Käfig regelmäßig machen</translation>
    </message>
    <message>
        <source>Unbake: take the placement out of the code</source>
        <translation>Die Lage aus dem Code herausrechnen</translation>
    </message>
    <message>
        <source>Without these vertices the cage at rest would cross itself or be flat.</source>
        <translation>Ohne diese Ecken würde sich der ruhende Käfig überkreuzen oder wäre flach.</translation>
    </message>
    <message>
        <source>Delete %1 vertices</source>
        <translation>%1 Ecken löschen</translation>
    </message>
    <message>
        <source>The cage is the minimal canonical simplex already.</source>
        <translation>Der Käfig ist schon das minimale kanonische Simplex.</translation>
    </message>
    <message>
        <source>The cage is regular already.</source>
        <translation>Der Käfig ist schon regelmäßig.</translation>
    </message>
</context>
<context>
    <name>view::CagePanel</name>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>State of the cage</source>
        <translation>Zustand des Käfigs</translation>
    </message>
    <message>
        <source>Warning about the cage</source>
        <translation>Warnung zum Käfig</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Platzieren</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Umschreiben</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation>Den Käfig zu bewegen bewegt das Bild; der Code bleibt</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Den Käfig zu bewegen schreibt den Code um</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>Affine fit</source>
        <translation>Affin angepasst</translation>
    </message>
    <message>
        <source>Every vertex is followed; the picture bends, which cannot be baked into a code</source>
        <translation>Jeder Ecke wird gefolgt; das Bild biegt sich, was sich nicht in einen Code einrechnen lässt</translation>
    </message>
    <message>
        <source>The picture moves by the affine map that comes nearest to the vertices; it can be baked</source>
        <translation>Das Bild folgt der affinen Abbildung, die den Ecken am nächsten kommt; sie lässt sich einrechnen</translation>
    </message>
    <message>
        <source>Bend the picture</source>
        <translation>Das Bild biegen</translation>
    </message>
    <message>
        <source>Fit the picture by an affine map</source>
        <translation>Das Bild affin anpassen</translation>
    </message>
    <message>
        <source>Define…</source>
        <translation>Festlegen…</translation>
    </message>
    <message>
        <source>Define the triangle by three clicks on the canvas; the picture stays</source>
        <translation>Das Dreieck mit drei Klicks auf die Zeichenfläche festlegen; das Bild bleibt</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Einrechnen</translation>
    </message>
    <message>
        <source>Minimal Canonical Simplex</source>
        <translation>Minimales kanonisches Simplex</translation>
    </message>
    <message>
        <source>Canonical Simplex %1</source>
        <translation>Kanonisches Simplex %1</translation>
    </message>
    <message>
        <source>Bounding Box</source>
        <translation>Umschließendes Rechteck</translation>
    </message>
    <message numerus="yes">
        <source>%n Corners</source>
        <translation>
            <numerusform>%n Ecke</numerusform>
            <numerusform>%n Ecken</numerusform>
        </translation>
    </message>
    <message>
        <source>Convex Hull, Simplified to</source>
        <translation>Konvexe Hülle, vereinfacht auf</translation>
    </message>
    <message>
        <source>Regular Polygon with</source>
        <translation>Regelmäßiges Vieleck mit</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Den Käfig anpassen</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Rest cage</source>
        <translation>Ruhekäfig</translation>
    </message>
    <message>
        <source>Show the vertices that hold the attractor while the cage is at rest</source>
        <translation>Die Ecken zeigen, die den Attraktor halten, solange der Käfig ruht</translation>
    </message>
    <message>
        <source>Show the rest cage</source>
        <translation>Den Ruhekäfig zeigen</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>x at rest</source>
        <translation>x in Ruhe</translation>
    </message>
    <message>
        <source>y at rest</source>
        <translation>y in Ruhe</translation>
    </message>
    <message>
        <source>Minimal canonical simplex</source>
        <translation>Minimales kanonisches Simplex</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs say to which side its legs point from the right angle.</source>
        <translation>Das kleinste gleichschenklig-rechtwinklige Dreieck mit achsenparallelen Katheten, das das Bild enthält. Die Vorzeichen sagen, nach welcher Seite seine Katheten vom rechten Winkel aus zeigen.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Baryzentrische Koordinaten eines Punktes</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 that the vertices take to balance in the point.</source>
        <translation>Die Gewichte a, b, c mit a + b + c = 1, mit denen sich die Ecken in dem Punkt die Waage halten.</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>x des Punktes</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>y des Punktes</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Baryzentrische Koordinaten</translation>
    </message>
    <message>
        <source>%1 of vertex %2</source>
        <translation>%1 der Ecke %2</translation>
    </message>
    <message>
        <source>%1 of rest vertex %2</source>
        <translation>%1 der Ruheecke %2</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Ecke %1 bewegen</translation>
    </message>
    <message>
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Die drei Punkte liegen auf einer Geraden: Der Ruhekäfig muss eine Fläche umschließen.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>Der Ruhekäfig muss ein Vieleck sein, das sich nicht überkreuzt.</translation>
    </message>
    <message>
        <source>Define vertex %1</source>
        <translation>Ecke %1 festlegen</translation>
    </message>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>Das Bild ist zu dünn für einen solchen Käfig.</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Den Käfig zurücksetzen</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Den Käfig in den Code einrechnen</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D: noch nicht gezeigt.</translation>
    </message>
    <message>
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden und hat daher keinen Käfig.</translation>
    </message>
    <message>
        <source>At rest: the picture is that of the code.</source>
        <translation>In Ruhe: Das Bild ist das des Codes.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture is that of the code.</source>
        <translation>%1 Ecken, in Ruhe: Das Bild ist das des Codes.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates, not bakeable.</source>
        <translation>%1 Ecken: mit Wachspress-Koordinaten gebogen, nicht einrechenbar.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, not bakeable.</source>
        <translation>%1 Ecken: mit Mittelwertkoordinaten gebogen, nicht einrechenbar.</translation>
    </message>
    <message>
        <source>Flat: the picture lies on one line. Open the cage and it comes back.</source>
        <translation>Flach: Das Bild liegt auf einer Geraden. Öffnen Sie den Käfig, und es kommt wieder.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the sense of rotation is reversed.</source>
        <translation>Platziert und gespiegelt: Flächen ändern sich um den Faktor %1, und der Drehsinn kehrt sich um.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Platziert: Flächen ändern sich um den Faktor %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it holds no coordinates.</source>
        <translation>Das Dreieck ist flach: Es trägt keine Koordinaten.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, Kathete %2, Ecke (%3, %4)</translation>
    </message>
    <message>
        <source>Hold the picture by a fitted cage; the picture stays</source>
        <translation>Das Bild mit einem angepassten Käfig halten; das Bild bleibt</translation>
    </message>
    <message>
        <source>Put the cage and the picture back to rest</source>
        <translation>Käfig und Bild zurück in die Ruhelage bringen</translation>
    </message>
    <message>
        <source>Make the displayed picture the code; the cage then rests</source>
        <translation>Das gezeigte Bild zum Code machen; der Käfig ruht danach</translation>
    </message>
    <message>
        <source>The cage is there already.</source>
        <translation>Der Käfig ist schon dort.</translation>
    </message>
    <message>
        <source>The coordinates are read over a triangle.</source>
        <translation>Die Koordinaten werden über einem Dreieck abgelesen.</translation>
    </message>
</context>
<context>
    <name>view::CageTool</name>
    <message>
        <source>Move the cage</source>
        <translation>Den Käfig bewegen</translation>
    </message>
    <message>
        <source>Rotate the cage</source>
        <translation>Den Käfig drehen</translation>
    </message>
    <message>
        <source>Scale the cage</source>
        <translation>Den Käfig skalieren</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Ecke %1 bewegen</translation>
    </message>
    <message>
        <source>Move edge %1–%2</source>
        <translation>Kante %1–%2 bewegen</translation>
    </message>
    <message>
        <source>Move %1 vertices</source>
        <translation>%1 Ecken bewegen</translation>
    </message>
    <message>
        <source>Select a vertex first.</source>
        <translation>Erst eine Ecke wählen.</translation>
    </message>
    <message>
        <source>Point at an edge, or select a vertex, to insert one.</source>
        <translation>Zum Einfügen einer Ecke auf eine Kante zeigen oder eine Ecke wählen.</translation>
    </message>
</context>
<context>
    <name>view::Canvas</name>
    <message>
        <source>No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). Make it smaller, or switch it off.</source>
        <translation>Kein Attraktor: Abbildung %1 kontrahiert nicht (größter Singulärwert %2, Spektralradius %3). Verkleinern Sie sie oder schalten Sie sie aus.</translation>
    </message>
    <message>
        <source>No attractor: the maps %1, one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Kein Attraktor: Die Abbildungen %1, nacheinander angewandt, kontrahieren nicht (größter Singulärwert %2, Spektralradius %3). Verkleinern Sie eine davon oder schalten Sie sie aus.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor: map %1 stretches by %2. Points that run away are left out.</source>
        <translation>Ob dieses System einen Attraktor hat, steht nicht fest: Abbildung %1 streckt um %2. Punkte, die davonlaufen, werden weggelassen.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor. Points that run away are left out.</source>
        <translation>Ob dieses System einen Attraktor hat, steht nicht fest. Punkte, die davonlaufen, werden weggelassen.</translation>
    </message>
    <message>
        <source>This entry is a system in space: not yet shown. It is kept as it is.</source>
        <translation>Dieser Eintrag ist ein System im Raum: noch nicht gezeigt. Er bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept as it is in the file.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden. Sein Text bleibt in der Datei, wie er ist.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Keine Abbildung nimmt teil; es gibt nichts zu zeichnen. Fügen Sie eine hinzu oder schalten Sie eine ein.</translation>
    </message>
    <message>
        <source>This is as deep as the arithmetic reaches: zoom out a little for a true picture.</source>
        <translation>Tiefer reicht die Arithmetik nicht: Verkleinern Sie ein wenig für ein wahres Bild.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than asked for: more would need more memory than allowed.</source>
        <translation>Mit weniger Iterationen gezeichnet als verlangt: Mehr bräuchten mehr Speicher als erlaubt.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a vertex to open it: nothing is lost.</source>
        <translation>Der Käfig ist flach und das Bild auch. Ziehen Sie eine Ecke, um ihn zu öffnen: Nichts geht verloren.</translation>
    </message>
    <message>
        <source>Stopped: any farther, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Angehalten: Weiter würde Abbildung %1 nicht kontrahieren (größter Singulärwert %2, Spektralradius %3), und es gäbe keinen Attraktor.</translation>
    </message>
    <message>
        <source>Stopped: any farther, the maps %1, one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Angehalten: Weiter würden die Abbildungen %1, nacheinander angewandt, nicht kontrahieren (größter Singulärwert %2, Spektralradius %3), und es gäbe keinen Attraktor.</translation>
    </message>
    <message>
        <source>Stopped: any farther, it is not settled whether there would be an attractor (map %1 has the largest singular value, %2).</source>
        <translation>Angehalten: Weiter steht nicht fest, ob es einen Attraktor gäbe (Abbildung %1 hat den größten Singulärwert, %2).</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point.</source>
        <translation>Eine Abbildung allein: nichts bleibt als ihr Fixpunkt.</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point (%1, %2).</source>
        <translation>Eine Abbildung allein: nichts bleibt als ihr Fixpunkt (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is on has a weight above 0, so there is nothing to draw. Give one a weight.</source>
        <translation>Keine eingeschaltete Abbildung hat ein Gewicht über 0; es gibt nichts zu zeichnen. Geben Sie einer ein Gewicht.</translation>
    </message>
</context>
<context>
    <name>view::CanvasMenu</name>
    <message>
        <source>Vertex %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>&amp;Coordinates…</source>
        <translation>&amp;Koordinaten…</translation>
    </message>
    <message>
        <source>Types the place of this vertex</source>
        <translation>Den Ort dieser Ecke eintippen</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>Diese Ecke &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Puts this vertex back to rest</source>
        <translation>Diese Ecke in die Ruhelage zurückbringen</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid Point (%1, %2)</source>
        <translation>An &amp;Gitterpunkt (%1, %2) einrasten</translation>
    </message>
    <message>
        <source>Moves this vertex to the nearest point of the grid</source>
        <translation>Diese Ecke zum nächsten Gitterpunkt bewegen</translation>
    </message>
    <message>
        <source>Snap to the &amp;x Axis</source>
        <translation>An der &amp;x-Achse einrasten</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the x axis</source>
        <translation>Diese Ecke gerade zur x-Achse bewegen</translation>
    </message>
    <message>
        <source>Snap to the &amp;y Axis</source>
        <translation>An der &amp;y-Achse einrasten</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the y axis</source>
        <translation>Diese Ecke gerade zur y-Achse bewegen</translation>
    </message>
    <message>
        <source>&amp;Delete This Vertex</source>
        <translation>Diese Ecke &amp;löschen</translation>
    </message>
    <message>
        <source>Takes this vertex out of the cage</source>
        <translation>Diese Ecke aus dem Käfig nehmen</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>&amp;Drehpunkt hierher setzen</translation>
    </message>
    <message>
        <source>Turns and scales the cage about this vertex</source>
        <translation>Den Käfig um diese Ecke drehen und skalieren</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>&amp;Insert a Vertex Here</source>
        <translation>Hier eine Ecke &amp;einfügen</translation>
    </message>
    <message>
        <source>Puts one more vertex on this edge; a double click does the same</source>
        <translation>Eine weitere Ecke auf diese Kante setzen; ein Doppelklick tut dasselbe</translation>
    </message>
    <message>
        <source>Rotate: Shift turns in steps of 15°</source>
        <translation>Drehen: Umschalt dreht in Schritten von 15°</translation>
    </message>
    <message>
        <source>Scale: Shift keeps to x or y</source>
        <translation>Skalieren: Umschalt bleibt bei x oder y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Middle</source>
        <translation>&amp;Drehpunkt in die Mitte setzen</translation>
    </message>
    <message>
        <source>Turns and scales the cage about its middle</source>
        <translation>Den Käfig um seine Mitte drehen und skalieren</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>&amp;Minimales kanonisches Simplex anpassen</translation>
    </message>
    <message>
        <source>Holds the picture by the smallest right-angled triangle around it</source>
        <translation>Das Bild im kleinsten rechtwinkligen Dreieck um es halten</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Dreieck festlegen</translation>
    </message>
    <message>
        <source>Holds the picture by three points that are clicked</source>
        <translation>Das Bild an drei angeklickten Punkten halten</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>Käfig &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Puts every vertex back to rest</source>
        <translation>Jede Ecke in die Ruhelage zurückbringen</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Re&amp;gelmäßig machen</translation>
    </message>
    <message>
        <source>Puts the vertices on the regular polygon nearest to them</source>
        <translation>Die Ecken auf das nächste regelmäßige Vieleck setzen</translation>
    </message>
    <message>
        <source>&amp;Bake Placement into the Code</source>
        <translation>Lage in den Code &amp;einrechnen</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw what is shown, with the cage at rest</source>
        <translation>Die Abbildungen so umschreiben, dass sie zeichnen, was gezeigt wird, bei ruhendem Käfig</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>&amp;Fit	F</source>
        <translation>&amp;Einpassen	F</translation>
    </message>
    <message>
        <source>Shows the whole picture and its cage</source>
        <translation>Das ganze Bild und seinen Käfig zeigen</translation>
    </message>
    <message>
        <source>&amp;100 %	1</source>
        <translation>&amp;100 %	1</translation>
    </message>
    <message>
        <source>Shows one unit of the plane as a hundred pixels</source>
        <translation>Eine Einheit der Ebene als hundert Pixel zeigen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Gitter</translation>
    </message>
    <message>
        <source>Shows or hides the grid</source>
        <translation>Das Gitter zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Achsen</translation>
    </message>
    <message>
        <source>Shows or hides the axes and their numbers</source>
        <translation>Die Achsen und ihre Zahlen zeigen oder verbergen</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>&amp;y-Achse nach unten</translation>
    </message>
    <message>
        <source>Turns the plane over, as on the screen of a computer</source>
        <translation>Die Ebene umklappen, wie auf dem Bildschirm eines Computers</translation>
    </message>
    <message>
        <source>&amp;Only the Picture	H</source>
        <translation>&amp;Nur das Bild	H</translation>
    </message>
    <message>
        <source>Hides the cage, the grid and the axes</source>
        <translation>Käfig, Gitter und Achsen verbergen</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copies the picture as it is seen, without the cage</source>
        <translation>Das Bild kopieren, wie es zu sehen ist, ohne den Käfig</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>&amp;Switch On</source>
        <translation>&amp;Einschalten</translation>
    </message>
    <message>
        <source>&amp;Switch Off</source>
        <translation>&amp;Ausschalten</translation>
    </message>
    <message>
        <source>Lets this map take part, or not</source>
        <translation>Diese Abbildung teilnehmen lassen oder nicht</translation>
    </message>
    <message>
        <source>Switch on map %1</source>
        <translation>Abbildung %1 einschalten</translation>
    </message>
    <message>
        <source>Switch off map %1</source>
        <translation>Abbildung %1 ausschalten</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>D&amp;uplizieren</translation>
    </message>
    <message>
        <source>Puts a copy of this map beside it</source>
        <translation>Eine Kopie dieser Abbildung daneben setzen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Takes this map out of the system</source>
        <translation>Diese Abbildung aus dem System nehmen</translation>
    </message>
</context>
<context>
    <name>view::CanvasScene</name>
    <message>
        <source>Vertex %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>Edge from vertex %1</source>
        <translation>Kante von Ecke %1</translation>
    </message>
    <message>
        <source>The whole cage</source>
        <translation>Der ganze Käfig</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>Rotate handle</source>
        <translation>Drehgriff</translation>
    </message>
    <message>
        <source>Scale handle</source>
        <translation>Skaliergriff</translation>
    </message>
    <message>
        <source>the arrow keys move both its ends</source>
        <translation>die Pfeiltasten bewegen ihre beiden Enden</translation>
    </message>
    <message>
        <source>the arrow keys move it</source>
        <translation>die Pfeiltasten bewegen es</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, Ecke %2</translation>
    </message>
    <message>
        <source>the arrow keys turn by one degree</source>
        <translation>die Pfeiltasten drehen um ein Grad</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>die Pfeiltasten skalieren um ein Prozent</translation>
    </message>
    <message>
        <source>Drag the pivot: turning and scaling are about it.</source>
        <translation>Den Drehpunkt ziehen: Um ihn wird gedreht und skaliert.</translation>
    </message>
    <message>
        <source>Drag to turn about the pivot; Shift: in steps of 15°.</source>
        <translation>Ziehen dreht um den Drehpunkt; Umschalt: in Schritten von 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; Shift: along x or y only.</source>
        <translation>Ziehen skaliert um den Drehpunkt; Umschalt: nur in x oder y.</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab goes from handle to handle, the arrow keys move the one in focus, F6 leaves the canvas.</source>
        <translation>Der Attraktor und sein Kontrollkäfig. Tab geht von Griff zu Griff, die Pfeiltasten bewegen den gewählten, F6 verlässt die Zeichenfläche.</translation>
    </message>
    <message>
        <source>Define triangle</source>
        <translation>Dreieck festlegen</translation>
    </message>
    <message>
        <source>The cage is flat, so new vertices cannot be related to the picture.</source>
        <translation>Der Käfig ist flach; neue Ecken lassen sich nicht auf das Bild beziehen.</translation>
    </message>
    <message>
        <source>Put the cage back to rest first?</source>
        <translation>Den Käfig zuerst in die Ruhelage zurückbringen?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Käfig zurücksetzen</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press H to see the cage again.</source>
        <translation>Nur das Bild wird gezeigt. Drücken Sie H, um den Käfig wieder zu sehen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; Ctrl turns, Alt scales, Shift keeps directions. The wheel zooms at the pointer, the middle button moves the plane. Tab goes from handle to handle, arrow keys move them, F6 leaves.</source>
        <translation>Das Bild und sein Käfig. Ziehen Sie eine Ecke, eine Kante oder das Innere des Käfigs; Strg dreht, Alt skaliert, Umschalt hält Richtungen. Das Rad zoomt am Zeiger, die mittlere Taste bewegt die Ebene. Tab geht von Griff zu Griff, die Pfeiltasten bewegen sie, F6 verlässt die Fläche.</translation>
    </message>
</context>
<context>
    <name>view::Clipboard</name>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>eingefügt</translation>
    </message>
</context>
<context>
    <name>view::CollectionModel</name>
    <message>
        <source>Theme: %1</source>
        <translation>Thema: %1</translation>
    </message>
    <message>
        <source>%1, from %2, a favourite</source>
        <translation>%1, aus %2, ein Favorit</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, aus %2</translation>
    </message>
</context>
<context>
    <name>view::CollectionPanel</name>
    <message>
        <source>Collection</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Die Sammlung durchsuchen</translation>
    </message>
    <message>
        <source>Show only fractals whose name, title, theme or source contains these words.</source>
        <translation>Nur Fraktale zeigen, deren Name, Titel, Thema oder Quelle diese Wörter enthält.</translation>
    </message>
    <message>
        <source>Fractals of the collection</source>
        <translation>Fraktale der Sammlung</translation>
    </message>
    <message>
        <source>No favourites yet. Choose a fractal and press Ctrl+D.</source>
        <translation>Noch keine Favoriten. Wählen Sie ein Fraktal und drücken Sie Strg+D.</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Nichts hier enthält diese Wörter.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>Open the chosen fractal as a document of its own.</source>
        <translation>Das gewählte Fraktal als eigenes Dokument öffnen.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>Zu dieser D&amp;atei hinzufügen</translation>
    </message>
    <message>
        <source>Add the chosen fractal to the open file.</source>
        <translation>Das gewählte Fraktal der offenen Datei hinzufügen.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>Fa&amp;vorit</translation>
    </message>
    <message>
        <source>Mark the chosen fractal as one of your favourites.</source>
        <translation>Das gewählte Fraktal als Favoriten merken.</translation>
    </message>
    <message>
        <source>Only Fa&amp;vourites</source>
        <translation>Nur Fa&amp;voriten</translation>
    </message>
    <message>
        <source>Show nothing but your favourites.</source>
        <translation>Nichts als die Favoriten zeigen.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>&amp;Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>Show the .ifs files of a folder of yours here, too.</source>
        <translation>Auch die .ifs-Dateien eines eigenen Ordners hier zeigen.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>Ordner „%1“ &amp;entfernen</translation>
    </message>
    <message>
        <source>Show this folder here no more. Its files stay as they are.</source>
        <translation>Diesen Ordner hier nicht mehr zeigen. Seine Dateien bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Ordner mit .ifs-Dateien</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment has these words. Enter opens the first of them.</source>
        <translation>Zeigt nur die Fraktale, deren Name, Thema oder Kommentar diese Wörter enthält. Eingabe öffnet das erste davon.</translation>
    </message>
    <message>
        <source>Fractals to begin with. Double-click or Enter opens one in this window; the menu of the right button adds it to the file instead.</source>
        <translation>Fraktale zum Anfangen. Doppelklick oder Eingabe öffnet eines in diesem Fenster; das Menü der rechten Taste fügt es stattdessen der Datei hinzu.</translation>
    </message>
    <message>
        <source>Files of the collection that were read</source>
        <translation>Gelesene Dateien der Sammlung</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Nicht weiter lesen</translation>
    </message>
    <message>
        <source>Stop reading this folder. What was read so far stays here.</source>
        <translation>Diesen Ordner nicht weiter lesen. Was schon gelesen ist, bleibt hier.</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Die Sammlung wird gelesen …</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen …</translation>
    </message>
</context>
<context>
    <name>view::ColourButton</name>
    <message>
        <source>transparent</source>
        <translation>durchsichtig</translation>
    </message>
    <message>
        <source>%1, %2 % opaque</source>
        <translation>%1, zu %2 % deckend</translation>
    </message>
    <message>
        <source>Click to choose another colour.</source>
        <translation>Klicken, um eine andere Farbe zu wählen.</translation>
    </message>
</context>
<context>
    <name>view::ColumnOrders</name>
    <message>
        <source>a b c d e f p: Fractint, Barnsley</source>
        <translation>a b c d e f p: Fractint, Barnsley</translation>
    </message>
    <message>
        <source>a b e c d f p: each equation in a row</source>
        <translation>a b e c d f p: jede Gleichung in einer Reihe</translation>
    </message>
    <message>
        <source>a c b d e f p: column by column</source>
        <translation>a c b d e f p: Spalte für Spalte</translation>
    </message>
    <message>
        <source>p a b c d e f: the weight first</source>
        <translation>p a b c d e f: das Gewicht zuerst</translation>
    </message>
    <message>
        <source>r s theta phi e f p: scales, and angles in degrees</source>
        <translation>r s theta phi e f p: Skalierungen, und Winkel in Grad</translation>
    </message>
    <message>
        <source>a b c d e f, and weights that add up row by row</source>
        <translation>a b c d e f, und Gewichte, die sich Zeile für Zeile aufsummieren</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Andere …</translation>
    </message>
    <message>
        <source>Order of the columns</source>
        <translation>Reihenfolge der Spalten</translation>
    </message>
    <message>
        <source>Names of the columns in their order</source>
        <translation>Namen der Spalten in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>The names of the columns in their order: a b c d or r s theta phi, then e and f, each once, and p for a weight or cumulative for a sum of weights where there is one. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Die Namen der Spalten in ihrer Reihenfolge: a b c d oder r s theta phi, dazu e und f, jeder einmal, und p für ein Gewicht oder cumulative für eine Summe von Gewichten, wo es sie gibt. x′ = a·x + b·y + e und y′ = c·x + d·y + f.</translation>
    </message>
</context>
<context>
    <name>view::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Befehlspalette</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Tippen Sie, was Sie tun möchten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Passende Befehle</translation>
    </message>
    <message>
        <source>Type some letters of what you want to do. Arrow keys choose, Enter does it.</source>
        <translation>Tippen Sie ein paar Buchstaben von dem, was Sie tun möchten. Die Pfeiltasten wählen, die Eingabetaste führt aus.</translation>
    </message>
    <message>
        <source>The commands whose names have these letters.</source>
        <translation>Die Befehle, deren Namen diese Buchstaben haben.</translation>
    </message>
    <message>
        <source>No command is called that.</source>
        <translation>Kein Befehl heißt so.</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three vertices. The picture stays where it is; Esc leaves.</source>
        <translation>Klicken Sie auf die erste der drei Ecken. Das Bild bleibt, wo es ist; Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click the second vertex. Backspace takes the first one back.</source>
        <translation>Klicken Sie auf die zweite Ecke. Die Rücktaste nimmt die erste zurück.</translation>
    </message>
    <message>
        <source>Click the third vertex. Backspace takes the second one back.</source>
        <translation>Klicken Sie auf die dritte Ecke. Die Rücktaste nimmt die zweite zurück.</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Kommentar zu „%1“</translation>
    </message>
    <message>
        <source>Comment behind the name</source>
        <translation>Kommentar hinter dem Namen</translation>
    </message>
    <message>
        <source>Written on the first line of the entry, for example its title or author.</source>
        <translation>Steht in der ersten Zeile des Eintrags, zum Beispiel Titel oder Autor.</translation>
    </message>
    <message>
        <source>Comment lines</source>
        <translation>Kommentarzeilen</translation>
    </message>
    <message>
        <source>Written as lines of their own below the name, each behind a semicolon.</source>
        <translation>Stehen als eigene Zeilen unter dem Namen, jede hinter einem Semikolon.</translation>
    </message>
    <message>
        <source>Reason why the comment cannot be kept</source>
        <translation>Grund, warum der Kommentar nicht behalten werden kann</translation>
    </message>
    <message>
        <source>Keep or discard the comment</source>
        <translation>Den Kommentar behalten oder verwerfen</translation>
    </message>
    <message>
        <source>&amp;Behind the name:</source>
        <translation>&amp;Hinter dem Namen:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Kommentarzeilen:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines keep the cage and the colours.</source>
        <translation>Ein Kommentar kann nicht mit „barycage:“ beginnen; solche Zeilen bewahren Käfig und Farben.</translation>
    </message>
    <message>
        <source>A line holds at most %1 bytes; Fractint cuts longer ones. Break it in two.</source>
        <translation>Eine Zeile hat höchstens %1 Bytes; Fractint schneidet längere ab. Teilen Sie sie.</translation>
    </message>
</context>
<context>
    <name>view::EntriesDelegate</name>
    <message>
        <source>Name of the entry</source>
        <translation>Name des Eintrags</translation>
    </message>
</context>
<context>
    <name>view::EntriesEdits</name>
    <message>
        <source>An entry needs a name.</source>
        <translation>Ein Eintrag braucht einen Namen.</translation>
    </message>
    <message>
        <source>A name holds no blanks: Fractint would read its first word only.</source>
        <translation>Ein Name enthält keine Leerzeichen: Fractint würde nur sein erstes Wort lesen.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>„%1“ kann nicht Teil eines Namens sein, weil es in .ifs-Dateien eine Bedeutung hat.</translation>
    </message>
    <message>
        <source>A name has at most %1 characters; Fractint ignores the rest.</source>
        <translation>Ein Name hat höchstens %1 Zeichen; Fractint übergeht den Rest.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint führt einen Eintrag namens „%1“ nicht auf; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case count as equal).</source>
        <translation>Ein anderer Eintrag heißt „%1“ (Groß- und Kleinbuchstaben gelten als gleich).</translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D: noch nicht gezeigt</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 Abbildung</translation>
    </message>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n Abbildung</numerusform>
            <numerusform>%n Abbildungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, no attractor</source>
        <translation>%1, kein Attraktor</translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation>Zeile %1, Spalte %2: </translation>
    </message>
    <message>
        <source>modified</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>has errors</source>
        <translation>hat Fehler</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>hat Warnungen</translation>
    </message>
</context>
<context>
    <name>view::EntriesPanel</name>
    <message>
        <source>Entries of the file</source>
        <translation>Einträge der Datei</translation>
    </message>
    <message>
        <source>Filter entries by name</source>
        <translation>Einträge nach Namen filtern</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Show only the entries whose name contains this text.</source>
        <translation>Nur die Einträge zeigen, deren Name diesen Text enthält.</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Einträge</translation>
    </message>
    <message>
        <source>This file holds no entries. Add one, or paste the text of an .ifs file.</source>
        <translation>Diese Datei enthält keine Einträge. Fügen Sie einen hinzu oder fügen Sie den Text einer .ifs-Datei ein.</translation>
    </message>
    <message>
        <source>&amp;Add Entry</source>
        <translation>Eintrag &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add a Sierpiński triangle as a new entry.</source>
        <translation>Ein Sierpiński-Dreieck als neuen Eintrag hinzufügen.</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of each selected entry.</source>
        <translation>Von jedem gewählten Eintrag eine Kopie hinzufügen.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected entries from the file.</source>
        <translation>Die gewählten Einträge aus der Datei löschen.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Give the entry another name.</source>
        <translation>Dem Eintrag einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>Edit &amp;Comment…</source>
        <translation>&amp;Kommentar bearbeiten…</translation>
    </message>
    <message>
        <source>Edit the comment of the entry.</source>
        <translation>Den Kommentar des Eintrags bearbeiten.</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move the selected entries towards the top of the file.</source>
        <translation>Die gewählten Einträge zum Anfang der Datei hin bewegen.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>Move the selected entries towards the end of the file.</source>
        <translation>Die gewählten Einträge zum Ende der Datei hin bewegen.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected entries as .ifs text.</source>
        <translation>Die gewählten Einträge als .ifs-Text kopieren.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Paste the entries of .ifs text behind the current entry.</source>
        <translation>Die Einträge eines .ifs-Textes hinter dem aktuellen Eintrag einfügen.</translation>
    </message>
    <message>
        <source>Add an entry</source>
        <translation>Einen Eintrag hinzufügen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n entries</source>
        <translation>
            <numerusform>%n Eintrag löschen</numerusform>
            <numerusform>%n Einträge löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>An entry that could not be read cannot be duplicated: it would keep its name.</source>
        <translation>Ein Eintrag, der nicht gelesen werden konnte, kann nicht dupliziert werden: Er behielte seinen Namen.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 duplizieren</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n entries</source>
        <translation>
            <numerusform>%n Eintrag duplizieren</numerusform>
            <numerusform>%n Einträge duplizieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit the comment of %1</source>
        <translation>Den Kommentar von %1 bearbeiten</translation>
    </message>
    <message>
        <source>There is no entry of an .ifs file in what was pasted.</source>
        <translation>Im Eingefügten ist kein Eintrag einer .ifs-Datei.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n entries</source>
        <translation>
            <numerusform>%n Eintrag einfügen</numerusform>
            <numerusform>%n Einträge einfügen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pasted entries could not be read; their text is kept as it is.</source>
        <translation>
            <numerusform>%n eingefügter Eintrag konnte nicht gelesen werden; sein Text bleibt, wie er ist.</numerusform>
            <numerusform>%n eingefügte Einträge konnten nicht gelesen werden; ihr Text bleibt, wie er ist.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message numerus="yes">
        <source>Move %n entries</source>
        <translation>
            <numerusform>%n Eintrag bewegen</numerusform>
            <numerusform>%n Einträge bewegen</numerusform>
        </translation>
    </message>
    <message>
        <source>No entry has “%1” in its name.</source>
        <translation>Kein Eintrag hat „%1“ in seinem Namen.</translation>
    </message>
    <message>
        <source>Shows only the entries whose name has these letters.</source>
        <translation>Zeigt nur die Einträge, deren Name diese Buchstaben hat.</translation>
    </message>
    <message>
        <source>The fractals of the file. Click one to edit it, drag it to another place, press F2 to give it another name.</source>
        <translation>Die Fraktale der Datei. Klicken Sie auf eines, um es zu bearbeiten, ziehen Sie es an einen anderen Platz, drücken Sie F2, um es umzubenennen.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>Nichts wurde eingefügt: In der Zwischenablage ist kein Text.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Das Eingefügte wird gelesen …</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Einträge werden hinzugefügt …</translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Daten von „%1“ exportieren</translation>
    </message>
    <message>
        <source>What the file will hold</source>
        <translation>Was die Datei enthalten wird</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>&amp;Text kopieren</translation>
    </message>
    <message>
        <source>Flame: flam3, Apophysis, JWildfire, Fractorium</source>
        <translation>Flame: flam3, Apophysis, JWildfire, Fractorium</translation>
    </message>
    <message>
        <source>IFStile (.aifs)</source>
        <translation>IFStile (.aifs)</translation>
    </message>
    <message>
        <source>Table with commas (.csv)</source>
        <translation>Tabelle mit Kommas (.csv)</translation>
    </message>
    <message>
        <source>Table with tabs (.tsv)</source>
        <translation>Tabelle mit Tabulatoren (.tsv)</translation>
    </message>
    <message>
        <source>Points (.csv)</source>
        <translation>Punkte (.csv)</translation>
    </message>
    <message>
        <source>Points, coloured (.ply)</source>
        <translation>Punkte, farbig (.ply)</translation>
    </message>
    <message>
        <source>&amp;Turn y around, so that the flame is the same way up</source>
        <translation>y &amp;umdrehen, damit die Flame gleich herum steht</translation>
    </message>
    <message>
        <source>&amp;Bake the placement, so that the maps draw what is shown</source>
        <translation>Die Lage &amp;einrechnen, damit die Abbildungen zeichnen, was gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Spalten:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>&amp;Punkte:</translation>
    </message>
    <message>
        <source>Only the numbers of plane systems can be exported.</source>
        <translation>Nur die Zahlen von Systemen der Ebene können exportiert werden.</translation>
    </message>
    <message>
        <source>The points of the chaos game where they are shown, without the first 14.</source>
        <translation>Die Punkte des Chaos-Spiels, wo sie gezeigt werden, ohne die ersten 14.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Daten exportieren</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>The text is on the clipboard.</source>
        <translation>Der Text ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>Der Export wurde angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>Der Anfang der Datei, wie sie geschrieben wird.</translation>
    </message>
    <message>
        <source>For which program the data are: each format has what that program reads.</source>
        <translation>Für welches Programm die Daten sind: Jedes Format hat, was dieses Programm liest.</translation>
    </message>
    <message>
        <source>The order in which each row has its coefficients; other programs expect other orders.</source>
        <translation>Die Reihenfolge, in der jede Zeile ihre Koeffizienten hat; andere Programme erwarten andere Reihenfolgen.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Wie viele Punkte des Chaos-Spiels geschrieben werden.</translation>
    </message>
    <message>
        <source>Flame programs let y grow downwards. With this the flame looks as the fractal does here; without it the numbers are the same.</source>
        <translation>Flame-Programme lassen y nach unten wachsen. Hiermit sieht die Flame aus wie das Fraktal hier; ohne dies bleiben die Zahlen gleich.</translation>
    </message>
    <message>
        <source>With this, the cage is made part of the maps. Without it, the maps are written as they stand in the table.</source>
        <translation>Hiermit wird der Käfig Teil der Abbildungen. Ohne dies werden die Abbildungen geschrieben, wie sie in der Tabelle stehen.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it.</source>
        <translation>Fragt nach dem Namen der Datei und schreibt sie.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Kopiert den ganzen Text in die Zwischenablage, statt eine Datei zu schreiben.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>„%1“ exportieren</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>PNG: pixels</source>
        <translation>PNG: Pixel</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG: Formen für Zeichenprogramme</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF: Formen für den Druck</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Include the &amp;control triangle</source>
        <translation>Mit &amp;Kontrolldreieck</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>Draft: 25 samples a pixel</source>
        <translation>Entwurf: 25 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Good: 100 samples a pixel</source>
        <translation>Gut: 100 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Fine: 400 samples a pixel</source>
        <translation>Fein: 400 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Finest: 2000 samples a pixel</source>
        <translation>Am feinsten: 2000 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Cells along the side of a pixel</source>
        <translation>Zellen längs der Seite eines Pixels</translation>
    </message>
    <message>
        <source>8 bits a channel</source>
        <translation>8 Bit je Kanal</translation>
    </message>
    <message>
        <source>16 bits a channel, for further work on the picture</source>
        <translation>16 Bit je Kanal, zur weiteren Arbeit am Bild</translation>
    </message>
    <message>
        <source>Colour depth</source>
        <translation>Farbtiefe</translation>
    </message>
    <message>
        <source>Memory needed</source>
        <translation>Benötigter Speicher</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Güte:</translation>
    </message>
    <message>
        <source>&amp;Supersampling:</source>
        <translation>&amp;Überabtastung:</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>F&amp;arbtiefe:</translation>
    </message>
    <message>
        <source>Memory:</source>
        <translation>Speicher:</translation>
    </message>
    <message>
        <source>Copies of copies: a small file</source>
        <translation>Kopien von Kopien: eine kleine Datei</translation>
    </message>
    <message>
        <source>Outline, for cutters and plotters</source>
        <translation>Umriss, für Schneidegeräte und Plotter</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Kind of shapes</source>
        <translation>Art der Formen</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>As deep as a pixel &amp;needs</source>
        <translation>So tief, wie ein Pixel es &amp;braucht</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Ebenen von Kopien</translation>
    </message>
    <message>
        <source>What the picture will be like</source>
        <translation>Wie das Bild sein wird</translation>
    </message>
    <message>
        <source>S&amp;hapes:</source>
        <translation>F&amp;ormen:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>&amp;Punkte:</translation>
    </message>
    <message>
        <source>&amp;Depth:</source>
        <translation>&amp;Tiefe:</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Only plane systems can be exported as a picture.</source>
        <translation>Nur Systeme der Ebene können als Bild exportiert werden.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>One dot for every point of the chaos game that is in view.</source>
        <translation>Ein Fleck für jeden Punkt des Chaos-Spiels, der zu sehen ist.</translation>
    </message>
    <message>
        <source> The cage bends the picture, which copies cannot follow: the affine fit of the cage is written. A PNG shows the bend.</source>
        <translation> Der Käfig biegt das Bild, was Kopien nicht können: Geschrieben wird die affine Anpassung des Käfigs. Ein PNG zeigt die Biegung.</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>Scalable pictures (*.svg)</source>
        <translation>Skalierbare Bilder (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>Der Export wurde angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message>
        <source>PNG is a picture of pixels; SVG and PDF are made of shapes, which stay sharp at every size.</source>
        <translation>PNG ist ein Bild aus Pixeln; SVG und PDF bestehen aus Formen, die in jeder Größe scharf bleiben.</translation>
    </message>
    <message>
        <source>The picture has no background and can be laid over another.</source>
        <translation>Das Bild hat keinen Hintergrund und kann über ein anderes gelegt werden.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Zeichnet den Käfig über das Bild.</translation>
    </message>
    <message>
        <source>How many points are drawn for each pixel: more make a smoother picture and take longer.</source>
        <translation>Wie viele Punkte je Pixel gezeichnet werden: Mehr machen ein glatteres Bild und dauern länger.</translation>
    </message>
    <message>
        <source>Every pixel is drawn from so many finer ones along its side: smoother edges, for more memory and time.</source>
        <translation>Jedes Pixel wird aus so vielen feineren längs seiner Seite gezeichnet: glattere Ränder für mehr Speicher und Zeit.</translation>
    </message>
    <message>
        <source>16 bits keep fine steps of brightness for later work in a picture editor; 8 bits are enough to look at.</source>
        <translation>16 Bit bewahren feine Helligkeitsstufen für die spätere Bearbeitung; 8 Bit genügen zum Ansehen.</translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation>Kopien von Kopien geben eine kleine Datei, die Zeichenprogramme bearbeiten können; der Umriss ist ein einziger Pfad; Punkte sind Flecken des Chaos-Spiels.</translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation>Wie viele Flecken des Chaos-Spiels gezeichnet werden.</translation>
    </message>
    <message>
        <source>How many levels of copies the picture has. The file hardly grows with it, the time to draw it does.</source>
        <translation>Wie viele Ebenen von Kopien das Bild hat. Die Datei wächst damit kaum, die Zeit zum Zeichnen schon.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it. The window can be used meanwhile.</source>
        <translation>Fragt nach dem Namen der Datei und schreibt sie. Das Fenster lässt sich inzwischen benutzen.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Das Bild wird kopiert …</translation>
    </message>
    <message>
        <source>Copies are made smaller until no pixel of this size could tell the difference, or programs would take long to draw them.</source>
        <translation>Kopien werden so klein gemacht, bis kein Pixel dieser Größe den Unterschied zeigen könnte oder Programme lange an ihnen zeichnen würden.</translation>
    </message>
    <message>
        <source>%1 references (fewer than %3 are allowed). Nothing that is drawn is farther than %2 pixels from the attractor, and nothing of it is farther from what is drawn.</source>
        <translation>%1 Verweise (weniger als %3 sind erlaubt). Nichts Gezeichnetes ist weiter als %2 Pixel vom Attraktor entfernt, und nichts von ihm ist weiter von dem Gezeichneten.</translation>
    </message>
    <message>
        <source> A pixel needs more: this is as deep as programs draw without a long wait.</source>
        <translation> Ein Pixel braucht mehr: Tiefer zeichnen Programme nicht, ohne dass man lange wartet.</translation>
    </message>
    <message>
        <source>Working out the shapes…</source>
        <translation>Die Formen werden berechnet …</translation>
    </message>
</context>
<context>
    <name>view::ExportSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × der Bildschirm</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Eigene Größe</translation>
    </message>
    <message>
        <source>Size relative to the screen</source>
        <translation>Größe im Verhältnis zum Bildschirm</translation>
    </message>
    <message>
        <source>Keep shape</source>
        <translation>Form behalten</translation>
    </message>
    <message>
        <source>Keep the shape of the picture on the screen</source>
        <translation>Die Form des Bildes auf dem Bildschirm behalten</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Resolution in dots per inch</source>
        <translation>Auflösung in Punkten je Zoll</translation>
    </message>
    <message>
        <source>A length in the unit chosen beside it. The other side follows while the shape is kept.</source>
        <translation>Eine Länge in der daneben gewählten Einheit. Die andere Seite folgt, solange die Form behalten wird.</translation>
    </message>
    <message>
        <source>In pixels, or on paper at the resolution given.</source>
        <translation>In Pixeln oder auf Papier in der angegebenen Auflösung.</translation>
    </message>
    <message>
        <source>The picture as on the screen or some times as large.</source>
        <translation>Das Bild wie auf dem Bildschirm oder einige Male so groß.</translation>
    </message>
    <message>
        <source>How many pixels go on an inch of paper: 300 is usual in print.</source>
        <translation>Wie viele Pixel auf ein Zoll Papier kommen: 300 sind im Druck üblich.</translation>
    </message>
</context>
<context>
    <name>view::GradientChooser</name>
    <message>
        <source>of this fractal</source>
        <translation>dieses Fraktals</translation>
    </message>
    <message>
        <source>%1 (of this fractal)</source>
        <translation>%1 (dieses Fraktals)</translation>
    </message>
</context>
<context>
    <name>view::GradientEditor</name>
    <message>
        <source>Palette editor</source>
        <translation>Palettenbearbeitung</translation>
    </message>
    <message>
        <source>Colour of the stop</source>
        <translation>Farbe der Marke</translation>
    </message>
    <message>
        <source>Position of the stop</source>
        <translation>Ort der Marke</translation>
    </message>
    <message>
        <source>Position of the stop, from 0 to 1</source>
        <translation>Ort der Marke, von 0 bis 1</translation>
    </message>
    <message>
        <source>Add Stop</source>
        <translation>Marke hinzufügen</translation>
    </message>
    <message>
        <source>Add a stop after the chosen one</source>
        <translation>Eine Marke nach der gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Marke löschen</translation>
    </message>
    <message>
        <source>Delete the chosen stop</source>
        <translation>Die gewählte Marke löschen</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Turn the palette round</source>
        <translation>Die Palette umkehren</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Verteilen</translation>
    </message>
    <message>
        <source>Put the stops at equal distances</source>
        <translation>Die Marken in gleiche Abstände setzen</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ugr or .map file</source>
        <translation>Eine Palette aus einer .gpl-, .ugr- oder .map-Datei laden</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save the palette as a .gpl file</source>
        <translation>Die Palette als .gpl-Datei speichern</translation>
    </message>
    <message>
        <source>Change a colour of the palette</source>
        <translation>Eine Farbe der Palette ändern</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Eine Marke der Palette bewegen</translation>
    </message>
    <message>
        <source>Save Palette</source>
        <translation>Palette speichern</translation>
    </message>
    <message>
        <source>palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>GIMP palettes (*.gpl)</source>
        <translation>GIMP-Paletten (*.gpl)</translation>
    </message>
    <message>
        <source>Reverse the palette</source>
        <translation>Die Palette umkehren</translation>
    </message>
    <message>
        <source>Distribute the stops of the palette</source>
        <translation>Die Marken der Palette verteilen</translation>
    </message>
    <message>
        <source>Load Palette</source>
        <translation>Palette laden</translation>
    </message>
    <message>
        <source>Palettes (*.gpl *.ugr *.gradient *.map);;All files (*)</source>
        <translation>Paletten (*.gpl *.ugr *.gradient *.map);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Load the palette %1</source>
        <translation>Die Palette %1 laden</translation>
    </message>
    <message>
        <source>Palettes of the file</source>
        <translation>Paletten der Datei</translation>
    </message>
    <message>
        <source>Load a palette</source>
        <translation>Eine Palette laden</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>The palettes that the file holds. Choose one.</source>
        <translation>Die Paletten, die die Datei enthält. Wählen Sie eine.</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Marken des Farbverlaufs</translation>
    </message>
    <message>
        <source>Double-click: new stop, or the colour of one. Drag: move. Del: delete it.
Keys: Page Up and Page Down choose a stop, the arrows move it, Ins adds one, Enter opens its colour.</source>
        <translation>Doppelklick: neue Marke oder Farbe der getroffenen. Ziehen: bewegen. Entf: löschen.
Tasten: Bild auf und Bild ab wählen eine Marke, die Pfeile bewegen sie, Einfg fügt eine hinzu, Eingabe öffnet ihre Farbe.</translation>
    </message>
    <message>
        <source>Stop %1 of %2 at %3 %, %4</source>
        <translation>Marke %1 von %2 bei %3 %, %4</translation>
    </message>
    <message>
        <source>Add a stop to the palette</source>
        <translation>Der Palette eine Marke hinzufügen</translation>
    </message>
    <message>
        <source>Delete a stop of the palette</source>
        <translation>Eine Marke der Palette löschen</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Eine Marke der Palette bewegen</translation>
    </message>
</context>
<context>
    <name>view::Guide</name>
    <message>
        <source>User Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>The user guide: what can be done here, in the order in which one needs it.</source>
        <translation>Das Handbuch: was sich hier tun lässt, in der Reihenfolge, in der man es braucht.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Marks these words in the guide. Enter shows the next place, Shift+Enter the one before. Ctrl+F leads here.</source>
        <translation>Markiert diese Wörter im Handbuch. Die Eingabetaste zeigt die nächste Stelle, mit der Umschalttaste die vorige. Strg+F führt hierher.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Nicht gefunden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>view::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Schritte des Verlaufs</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward.</source>
        <translation>Wählen Sie einen Schritt, um zu ihm zurück- oder vorzugehen.</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward. The disk marks what is saved.</source>
        <translation>Wählen Sie einen Schritt, um zu ihm zurück- oder vorzugehen. Die Diskette zeigt, was gespeichert ist.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
</context>
<context>
    <name>view::MapShapeEditor</name>
    <message>
        <source>Rotation °</source>
        <translation>Drehung °</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise with y up</source>
        <translation>Winkel in Grad, gegen den Uhrzeigersinn bei y nach oben</translation>
    </message>
    <message>
        <source>Scale x</source>
        <translation>Skalierung x</translation>
    </message>
    <message>
        <source>Length of the image of the x unit vector</source>
        <translation>Länge des Bildes des x-Einheitsvektors</translation>
    </message>
    <message>
        <source>Scale y</source>
        <translation>Skalierung y</translation>
    </message>
    <message>
        <source>Scale across; negative when the map reflects</source>
        <translation>Skalierung quer dazu; negativ, wenn die Abbildung spiegelt</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scherung</translation>
    </message>
    <message>
        <source>Shear along x, applied before everything else</source>
        <translation>Scherung längs x, vor allem anderen angewandt</translation>
    </message>
    <message>
        <source>Shift x</source>
        <translation>Verschiebung x</translation>
    </message>
    <message>
        <source>Translation e, applied last</source>
        <translation>Verschiebung e, zuletzt angewandt</translation>
    </message>
    <message>
        <source>Shift y</source>
        <translation>Verschiebung y</translation>
    </message>
    <message>
        <source>Translation f, applied last</source>
        <translation>Verschiebung f, zuletzt angewandt</translation>
    </message>
    <message>
        <source>No map is selected</source>
        <translation>Keine Abbildung ist gewählt</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Change the shape of map %1</source>
        <translation>Die Form der Abbildung %1 ändern</translation>
    </message>
</context>
<context>
    <name>view::MapsDelegate</name>
    <message>
        <source>%1 of map %2</source>
        <translation>%1 der Abbildung %2</translation>
    </message>
    <message>
        <source>%1 The cell keeps its value.</source>
        <translation>%1 Die Zelle behält ihren Wert.</translation>
    </message>
</context>
<context>
    <name>view::MapsModel</name>
    <message>
        <source>similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>reflected similarity</source>
        <translation>gespiegelte Ähnlichkeit</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>affin</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>singulär</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>konstant</translation>
    </message>
    <message>
        <source>A similarity keeps shapes: it turns, scales and shifts.</source>
        <translation>Eine Ähnlichkeit erhält Formen: Sie dreht, skaliert und verschiebt.</translation>
    </message>
    <message>
        <source>A reflected similarity keeps shapes, as a mirror does, and scales and shifts them.</source>
        <translation>Eine gespiegelte Ähnlichkeit erhält Formen wie ein Spiegel, skaliert und verschiebt sie.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels, not angles.</source>
        <translation>Eine affine Abbildung erhält Geraden und Parallelen, nicht Winkel.</translation>
    </message>
    <message>
        <source>A singular map takes the plane to a line.</source>
        <translation>Eine singuläre Abbildung führt die Ebene in eine Gerade über.</translation>
    </message>
    <message>
        <source>A constant map takes the plane to one point.</source>
        <translation>Eine konstante Abbildung führt die Ebene in einen Punkt über.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>det</source>
        <translation>det</translation>
    </message>
    <message>
        <source>‖A‖</source>
        <translation>‖A‖</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>The map takes (x, y) to (a x + b y + e, c x + d y + f).</source>
        <translation>Die Abbildung führt (x, y) in (a x + b y + e, c x + d y + f) über.</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage. Bake makes it the code.</source>
        <translation>Wirksamer Code: die Abbildung, wie sie unter dem jetzigen Käfig auf das Bild wirkt. Einrechnen macht sie zum Code.</translation>
    </message>
    <message>
        <source>Whether the map takes part.</source>
        <translation>Ob die Abbildung teilnimmt.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map.</source>
        <translation>Farbe der Abbildung, wenn das Bild nach Abbildungen gefärbt wird.</translation>
    </message>
    <message>
        <source>Weight as given: how often the chaos game takes the map. The weights need not sum to 1.</source>
        <translation>Gewicht wie angegeben: wie oft das Chaos-Spiel die Abbildung nimmt. Die Summe muss nicht 1 sein.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor of areas; negative when the map reflects.</source>
        <translation>Determinante ad − bc: der Faktor der Flächen; negativ, wenn die Abbildung spiegelt.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the most by which distances grow.</source>
        <translation>Kontraktionsfaktor ‖A‖, der größte Singulärwert: das Meiste, um das Abstände wachsen.</translation>
    </message>
    <message>
        <source>What the map is geometrically.</source>
        <translation>Was die Abbildung geometrisch ist.</translation>
    </message>
    <message>
        <source>Map %1 takes part.</source>
        <translation>Abbildung %1 nimmt teil.</translation>
    </message>
    <message>
        <source>Map %1 is switched off.</source>
        <translation>Abbildung %1 ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Colour of map %1. Press Space or double-click to change it.</source>
        <translation>Farbe der Abbildung %1. Leertaste oder Doppelklick ändert sie.</translation>
    </message>
    <message>
        <source>The cage is flat or bent: there is no effective code.</source>
        <translation>Der Käfig ist flach oder gebogen: Es gibt keinen wirksamen Code.</translation>
    </message>
    <message>
        <source>No weight is given; the determinant rule makes the probability %1.</source>
        <translation>Kein Gewicht ist angegeben; nach der Determinantenregel ist die Wahrscheinlichkeit %1.</translation>
    </message>
    <message>
        <source>Weight %1: a weight that is not positive switches the map off.</source>
        <translation>Gewicht %1: Ein Gewicht, das nicht positiv ist, schaltet die Abbildung aus.</translation>
    </message>
    <message>
        <source>Weight %1, probability %2.</source>
        <translation>Gewicht %1, Wahrscheinlichkeit %2.</translation>
    </message>
    <message>
        <source>%1, not contracting</source>
        <translation>%1, nicht kontrahierend</translation>
    </message>
    <message>
        <source>colour %1</source>
        <translation>Farbe %1</translation>
    </message>
    <message>
        <source>Map %1 does not contract: it stretches by up to %2. The system may still have an attractor if longer words contract.</source>
        <translation>Abbildung %1 kontrahiert nicht: Sie streckt um bis zu %2. Das System kann dennoch einen Attraktor haben, wenn längere Wörter kontrahieren.</translation>
    </message>
    <message>
        <source>Map %1. Drag to reorder.</source>
        <translation>Abbildung %1. Ziehen, um sie umzuordnen.</translation>
    </message>
    <message>
        <source>Change weight of map %1</source>
        <translation>Gewicht der Abbildung %1 ändern</translation>
    </message>
    <message>
        <source>Change %1 of map %2</source>
        <translation>%1 der Abbildung %2 ändern</translation>
    </message>
    <message>
        <source>Switch map %1 on</source>
        <translation>Abbildung %1 einschalten</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Abbildung %1 ausschalten</translation>
    </message>
    <message>
        <source>Change colour of map %1</source>
        <translation>Farbe der Abbildung %1 ändern</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a map of half the size</source>
        <translation>Eine Abbildung halber Größe hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Die gewählten Abbildungen duplizieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Die gewählten Abbildungen löschen</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move the selected maps up</source>
        <translation>Die gewählten Abbildungen nach oben bewegen</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Move the selected maps down</source>
        <translation>Die gewählten Abbildungen nach unten bewegen</translation>
    </message>
    <message>
        <source>Copy Rows</source>
        <translation>Zeilen kopieren</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f p, separated by tabs</source>
        <translation>Die gewählten Abbildungen als Zeilen a b c d e f p kopieren, durch Tabulatoren getrennt</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>An Ort und Stelle einfügen</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 6 or 7 numbers from the clipboard</source>
        <translation>Die gewählten Abbildungen durch Zeilen von 6 oder 7 Zahlen aus der Zwischenablage ersetzen</translation>
    </message>
    <message>
        <source>Paste as New Maps</source>
        <translation>Als neue Abbildungen einfügen</translation>
    </message>
    <message>
        <source>Add rows of 6 or 7 numbers from the clipboard as new maps</source>
        <translation>Zeilen von 6 oder 7 Zahlen aus der Zwischenablage als neue Abbildungen hinzufügen</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Einrechnen</translation>
    </message>
    <message>
        <source>Make the effective code the code; the cage then rests</source>
        <translation>Den wirksamen Code zum Code machen; der Käfig ruht danach</translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Nach |Determinante|</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, so that the picture is even</source>
        <translation>Gewichte im Verhältnis der Flächen der Bilder, damit das Bild gleichmäßig wird</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>Dasselbe Gewicht für jede Abbildung</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Nach Dimension</translation>
    </message>
    <message>
        <source>Weights for an even cover of the attractor at its own dimension</source>
        <translation>Gewichte, die den Attraktor in seiner eigenen Dimension gleichmäßig bedecken</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normieren</translation>
    </message>
    <message>
        <source>The same proportions, with the sum 1</source>
        <translation>Dieselben Verhältnisse, mit der Summe 1</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Weights of all maps that are on, by a rule</source>
        <translation>Gewichte aller eingeschalteten Abbildungen nach einer Regel</translation>
    </message>
    <message>
        <source>Show columns: %1</source>
        <translation>Spalten zeigen: %1</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Show the coefficients a … f</source>
        <translation>Die Koeffizienten a … f zeigen</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>Tatsachen</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Determinante, Kontraktionsfaktor und Art jeder Abbildung zeigen</translation>
    </message>
    <message>
        <source>Effective code</source>
        <translation>Wirksamer Code</translation>
    </message>
    <message>
        <source>Show the maps as they act on the picture under the current cage</source>
        <translation>Die Abbildungen zeigen, wie sie unter dem jetzigen Käfig auf das Bild wirken</translation>
    </message>
    <message>
        <source>Table of maps</source>
        <translation>Tabelle der Abbildungen</translation>
    </message>
    <message>
        <source>No maps: add one, or paste rows of 6 or 7 numbers.</source>
        <translation>Keine Abbildungen: Fügen Sie eine hinzu oder fügen Sie Zeilen von 6 oder 7 Zahlen ein.</translation>
    </message>
    <message>
        <source>3D: not yet shown.
The entry is kept as it is.</source>
        <translation>3D: noch nicht gezeigt.
Der Eintrag bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>This entry could not be read. It is kept as it is.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden. Er bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>Add a map</source>
        <translation>Eine Abbildung hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate a map</source>
        <translation>Eine Abbildung duplizieren</translation>
    </message>
    <message>
        <source>Duplicate %1 maps</source>
        <translation>%1 Abbildungen duplizieren</translation>
    </message>
    <message>
        <source>Delete a map</source>
        <translation>Eine Abbildung löschen</translation>
    </message>
    <message>
        <source>Delete %1 maps</source>
        <translation>%1 Abbildungen löschen</translation>
    </message>
    <message>
        <source>Reorder maps</source>
        <translation>Abbildungen umordnen</translation>
    </message>
    <message>
        <source>Nothing was pasted. Line %1 of the clipboard: %2</source>
        <translation>Nichts wurde eingefügt. Zeile %1 der Zwischenablage: %2</translation>
    </message>
    <message>
        <source>Nothing was pasted. %1</source>
        <translation>Nichts wurde eingefügt. %1</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard holds no rows of 6 or 7 numbers.</source>
        <translation>Nichts wurde eingefügt: Die Zwischenablage enthält keine Zeilen von 6 oder 7 Zahlen.</translation>
    </message>
    <message>
        <source>Paste a map</source>
        <translation>Eine Abbildung einfügen</translation>
    </message>
    <message>
        <source>Paste %1 maps</source>
        <translation>%1 Abbildungen einfügen</translation>
    </message>
    <message>
        <source>Maps added: %1.</source>
        <translation>Hinzugefügte Abbildungen: %1.</translation>
    </message>
    <message>
        <source>The selected maps were replaced; maps pasted: %1.</source>
        <translation>Die gewählten Abbildungen wurden ersetzt; eingefügte Abbildungen: %1.</translation>
    </message>
    <message>
        <source>Set the weights</source>
        <translation>Die Gewichte setzen</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Den Käfig in den Code einrechnen</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Farbe der Abbildung %1</translation>
    </message>
    <message>
        <source>Every row is a map: (x, y) goes to (a x + b y + e, c x + d y + f), as often as its weight p says. Double-click a number, or begin to type, to change it; the picture follows every key. Drag the number of a row to move it.</source>
        <translation>Jede Zeile ist eine Abbildung: (x, y) geht über in (a x + b y + e, c x + d y + f), so oft, wie ihr Gewicht p sagt. Klicken Sie doppelt auf eine Zahl oder beginnen Sie zu tippen, um sie zu ändern; das Bild folgt jeder Taste. Ziehen Sie die Nummer einer Zeile, um sie zu verschieben.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Das Eingefügte wird gelesen …</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Nummern der Abbildungen</translation>
    </message>
    <message>
        <source>Drag a number to put the map elsewhere. A mark warns of a map that does not contract.</source>
        <translation>Ziehen Sie eine Nummer, um die Abbildung anderswohin zu setzen. Ein Zeichen warnt vor einer Abbildung, die nicht kontrahiert.</translation>
    </message>
</context>
<context>
    <name>view::MapsTool</name>
    <message>
        <source>Move corner %1 of map %2</source>
        <translation>Ecke %1 der Abbildung %2 bewegen</translation>
    </message>
    <message>
        <source>Move map %1</source>
        <translation>Abbildung %1 bewegen</translation>
    </message>
    <message>
        <source>Move %1 maps</source>
        <translation>%1 Abbildungen bewegen</translation>
    </message>
    <message>
        <source>Rotate map %1</source>
        <translation>Abbildung %1 drehen</translation>
    </message>
    <message>
        <source>Rotate %1 maps</source>
        <translation>%1 Abbildungen drehen</translation>
    </message>
    <message>
        <source>Scale map %1</source>
        <translation>Abbildung %1 skalieren</translation>
    </message>
    <message>
        <source>Scale %1 maps</source>
        <translation>%1 Abbildungen skalieren</translation>
    </message>
    <message>
        <source>What is flat on the screen cannot be taken. Open the cage, or the maps, first.</source>
        <translation>Was auf dem Bildschirm flach ist, lässt sich nicht fassen. Öffnen Sie zuerst den Käfig oder die Abbildungen.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Erst eine Abbildung wählen.</translation>
    </message>
    <message>
        <source>Of so many maps only some are shown. Zoom in to see the others.</source>
        <translation>Von so vielen Abbildungen werden nur einige gezeigt. Die übrigen zeigt ein näherer Ausschnitt.</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Abwandlungen von „%1“</translation>
    </message>
    <message>
        <source>Fractals by Chance</source>
        <translation>Zufällige Fraktale</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Abwandlungen</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Dieses nehmen</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>Der Datei &amp;hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Vary This One</source>
        <translation>Dieses &amp;abwandeln</translation>
    </message>
    <message>
        <source>Make the chosen one what the variations start from</source>
        <translation>Das gewählte zum Ausgangspunkt der Abwandlungen machen</translation>
    </message>
    <message>
        <source>How different the variations are</source>
        <translation>Wie verschieden die Abwandlungen sind</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Startwert der Zufallszahlen</translation>
    </message>
    <message>
        <source>The same seed gives the same sheet again</source>
        <translation>Derselbe Startwert gibt wieder dasselbe Blatt</translation>
    </message>
    <message>
        <source>&amp;Others</source>
        <translation>A&amp;ndere</translation>
    </message>
    <message>
        <source>Another sheet: the next seed</source>
        <translation>Ein anderes Blatt: der nächste Startwert</translation>
    </message>
    <message>
        <source>&amp;Difference:</source>
        <translation>&amp;Unterschied:</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Startwert:</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>Abwandlung %1</translation>
    </message>
    <message>
        <source>Mutate</source>
        <translation>Mutieren</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Zufälliges Fraktal hinzufügen</translation>
    </message>
    <message>
        <source>Choose one and press OK, or double-click it: it takes the place of the fractal, as one step that can be undone.</source>
        <translation>Wählen Sie eines und drücken Sie OK, oder klicken Sie doppelt darauf: Es tritt an die Stelle des Fraktals, in einem Schritt, der sich zurücknehmen lässt.</translation>
    </message>
    <message>
        <source>To the left the variations are much like what they start from, to the right they are wild.</source>
        <translation>Links sind die Abwandlungen dem Ausgangspunkt sehr ähnlich, rechts sind sie wild.</translation>
    </message>
    <message>
        <source>Takes the chosen one, as one step that can be undone.</source>
        <translation>Nimmt das gewählte, in einem Schritt, der sich zurücknehmen lässt.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma. Arrow keys and the wheel change it: with Shift ten times as fast, with Alt a tenth. Esc takes back what was typed.</source>
        <translation>Eine Zahl, mit Dezimalpunkt oder Komma. Pfeiltasten und Rad ändern sie: mit Umschalt zehnmal so schnell, mit Alt ein Zehntel so schnell. Esc nimmt das Getippte zurück.</translation>
    </message>
</context>
<context>
    <name>view::PasteTableDialog</name>
    <message>
        <source>Paste maps</source>
        <translation>Abbildungen einfügen</translation>
    </message>
    <message>
        <source>Paste a Table</source>
        <translation>Eine Tabelle einfügen</translation>
    </message>
    <message>
        <source>The rows do not say which column is which, and programs differ. Choose the order in which the picture behind this dialog is the one you expect.</source>
        <translation>Die Zeilen sagen nicht, welche Spalte welche ist, und Programme unterscheiden sich. Wählen Sie die Reihenfolge, bei der das Bild hinter diesem Dialog das erwartete ist.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Die Abbildungen, wie sie eingefügt werden</translation>
    </message>
    <message>
        <source>The maps in the order chosen: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
        <translation>Die Abbildungen in der gewählten Reihenfolge: (x, y) geht über in (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>What the maps do</source>
        <translation>Was die Abbildungen tun</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Spalten:</translation>
    </message>
    <message>
        <source>There are no rows of 6 or 7 numbers.</source>
        <translation>Es gibt keine Zeilen von 6 oder 7 Zahlen.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>In this order every map contracts.</source>
        <translation>In dieser Reihenfolge kontrahiert jede Abbildung.</translation>
    </message>
    <message>
        <source>In this order these maps do not contract: %1. Perhaps the columns mean something else.</source>
        <translation>In dieser Reihenfolge kontrahieren diese Abbildungen nicht: %1. Vielleicht bedeuten die Spalten etwas anderes.</translation>
    </message>
    <message>
        <source>Order of the Columns</source>
        <translation>Reihenfolge der Spalten</translation>
    </message>
    <message>
        <source>&amp;Use This Order</source>
        <translation>Diese &amp;Reihenfolge</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>The language changes when Barycage is started again.</source>
        <translation>Die Sprache wechselt, wenn Barycage neu gestartet wird.</translation>
    </message>
    <message>
        <source>&amp;Open the files of last time at the start</source>
        <translation>Beim Start die zuletzt geöffneten Dateien &amp;öffnen</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>That of the desktop</source>
        <translation>Die der Arbeitsumgebung</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The language of menus and messages. Files and numbers are the same in every language.</source>
        <translation>Die Sprache der Menüs und Meldungen. Dateien und Zahlen sind in jeder Sprache gleich.</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie die Arbeitsumgebung</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>The colours of windows and panels. The picture keeps its own.</source>
        <translation>Die Farben von Fenstern und Feldern. Das Bild behält seine eigenen.</translation>
    </message>
    <message>
        <source>Draft: 50 million points</source>
        <translation>Entwurf: 50 Millionen Punkte</translation>
    </message>
    <message>
        <source>Good: 200 million points</source>
        <translation>Gut: 200 Millionen Punkte</translation>
    </message>
    <message>
        <source>Fine: 1000 million points</source>
        <translation>Fein: 1000 Millionen Punkte</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Ruhendes Bild</translation>
    </message>
    <message>
        <source>How many points are drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Wie viele Punkte gezeichnet werden, solange sich nichts bewegt. Mehr Punkte machen ein glatteres Bild und beschäftigen den Prozessor länger.</translation>
    </message>
    <message>
        <source>When on, Barycage opens the files that were open when it was closed, a window each.</source>
        <translation>Wenn dies an ist, öffnet Barycage die Dateien, die beim Beenden offen waren, jede in einem Fenster.</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Sprache:</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Farbschema:</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>&amp;Ruhendes Bild:</translation>
    </message>
    <message>
        <source>Puts every choice of this dialog back to what it is at first.</source>
        <translation>Setzt jede Wahl dieses Dialogs auf den Anfangswert zurück.</translation>
    </message>
</context>
<context>
    <name>view::ProblemsModel</name>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Line:column</source>
        <translation>Zeile:Spalte</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Eintrag</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
</context>
<context>
    <name>view::ProblemsPanel</name>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Problems found while reading</source>
        <translation>Beim Lesen gefundene Probleme</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Choose a line to show the entry it concerns.</source>
        <translation>Wählen Sie eine Zeile, um den Eintrag zu sehen, den sie betrifft.</translation>
    </message>
    <message>
        <source>Number of problems</source>
        <translation>Anzahl der Probleme</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected problems as text.</source>
        <translation>Die gewählten Probleme als Text kopieren.</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Select all problems.</source>
        <translation>Alle Probleme auswählen.</translation>
    </message>
    <message>
        <source>1 problem was found while reading.</source>
        <translation>Beim Lesen wurde 1 Problem gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n problems were found while reading.</source>
        <translation>
            <numerusform>Beim Lesen wurde %n Problem gefunden.</numerusform>
            <numerusform>Beim Lesen wurden %n Probleme gefunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>What could not be read is kept as it is.</source>
        <translation>Was nicht gelesen werden konnte, bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Nothing to report: every entry was read.</source>
        <translation>Nichts zu berichten: Jeder Eintrag wurde gelesen.</translation>
    </message>
    <message>
        <source>What the reader of the file remarked, with line and column. Double-click a line to go to its entry.</source>
        <translation>Was beim Lesen der Datei auffiel, mit Zeile und Spalte. Klicken Sie doppelt auf eine Zeile, um zu ihrem Eintrag zu gehen.</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsDialog</name>
    <message>
        <source>On the canvas</source>
        <translation>Auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>Move a vertex, an edge, the whole cage</source>
        <translation>Eine Ecke, eine Kante, den ganzen Käfig bewegen</translation>
    </message>
    <message>
        <source>drag it</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>Rotate about the pivot</source>
        <translation>Um den Drehpunkt drehen</translation>
    </message>
    <message>
        <source>Ctrl + drag, or the round handle</source>
        <translation>Strg + Ziehen, oder der runde Griff</translation>
    </message>
    <message>
        <source>Scale about the pivot</source>
        <translation>Um den Drehpunkt skalieren</translation>
    </message>
    <message>
        <source>Alt + drag, or the square handle</source>
        <translation>Alt + Ziehen, oder der eckige Griff</translation>
    </message>
    <message>
        <source>Move or scale along one axis, turn in steps of 15°</source>
        <translation>Längs einer Achse bewegen oder skalieren, in Schritten von 15° drehen</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Umschalt beim Ziehen</translation>
    </message>
    <message>
        <source>Take the drag back</source>
        <translation>Das Ziehen zurücknehmen</translation>
    </message>
    <message>
        <source>Esc while dragging</source>
        <translation>Esc beim Ziehen</translation>
    </message>
    <message>
        <source>Next or previous handle</source>
        <translation>Nächster oder voriger Griff</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>Nudge the handle</source>
        <translation>Den Griff ein wenig bewegen</translation>
    </message>
    <message>
        <source>arrow keys; Shift ×10, Alt ×0.1</source>
        <translation>Pfeiltasten; Umschalt ×10, Alt ×0.1</translation>
    </message>
    <message>
        <source>Leave the canvas</source>
        <translation>Die Zeichenfläche verlassen</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Am Zeiger zoomen</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>middle drag, or Space + drag</source>
        <translation>mit der mittleren Taste, oder Leertaste + Ziehen</translation>
    </message>
    <message>
        <source>Keyboard and Mouse</source>
        <translation>Tastatur und Maus</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Die Tastenkürzel durchsuchen</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Was es tut</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>Shows only the lines that have these words.</source>
        <translation>Zeigt nur die Zeilen, die diese Wörter enthalten.</translation>
    </message>
    <message>
        <source>What every key and every movement of the mouse does.</source>
        <translation>Was jede Taste und jede Bewegung der Maus tut.</translation>
    </message>
    <message>
        <source>Shift or Ctrl + click</source>
        <translation>Umschalt oder Strg + Klick</translation>
    </message>
    <message>
        <source>Select map 1 … 9, all maps</source>
        <translation>Abbildung 1 … 9 wählen, alle Abbildungen</translation>
    </message>
    <message>
        <source>Alt + digit, Ctrl+A</source>
        <translation>Alt + Ziffer, Strg+A</translation>
    </message>
    <message>
        <source>A deeper or a larger branch</source>
        <translation>Ein tieferer oder größerer Ast</translation>
    </message>
    <message>
        <source>Shift + wheel, Page Down, Page Up</source>
        <translation>Umschalt + Rad, Bild ab, Bild auf</translation>
    </message>
    <message>
        <source>Select the maps, or the vertices, in a rectangle</source>
        <translation>Abbildungen oder Ecken in einem Rechteck wählen</translation>
    </message>
    <message>
        <source>drag from the empty canvas; Shift adds</source>
        <translation>von der leeren Fläche aus ziehen; Umschalt fügt hinzu</translation>
    </message>
    <message>
        <source>Select one more map or vertex, or one less</source>
        <translation>Eine Abbildung oder Ecke mehr oder weniger wählen</translation>
    </message>
    <message>
        <source>Delete the selected vertices or maps</source>
        <translation>Die gewählten Ecken oder Abbildungen löschen</translation>
    </message>
    <message>
        <source>Insert a vertex on an edge, duplicate the selected maps</source>
        <translation>Eine Ecke auf einer Kante einfügen, die gewählten Abbildungen verdoppeln</translation>
    </message>
    <message>
        <source>Take the last vertex back while a triangle is defined</source>
        <translation>Die letzte Ecke zurücknehmen, während ein Dreieck festgelegt wird</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Choose another stop</source>
        <translation>Eine andere Marke wählen</translation>
    </message>
    <message>
        <source>Page Up, Page Down, Home, End, or Ctrl + Left, Right</source>
        <translation>Bild auf, Bild ab, Pos1, Ende oder Strg + Links, Rechts</translation>
    </message>
    <message>
        <source>Move the stop</source>
        <translation>Die Marke verschieben</translation>
    </message>
    <message>
        <source>Left, Right; Shift ×10</source>
        <translation>Links, Rechts; Umschalt ×10</translation>
    </message>
    <message>
        <source>Add a stop</source>
        <translation>Eine Marke hinzufügen</translation>
    </message>
    <message>
        <source>Ins or +, or double-click</source>
        <translation>Einfg oder +, oder Doppelklick</translation>
    </message>
    <message>
        <source>Delete the stop</source>
        <translation>Die Marke löschen</translation>
    </message>
    <message>
        <source>Del or Backspace</source>
        <translation>Entf oder Rücktaste</translation>
    </message>
    <message>
        <source>Change the colour of the stop</source>
        <translation>Die Farbe der Marke ändern</translation>
    </message>
    <message>
        <source>Enter or Space, or double-click it</source>
        <translation>Eingabe oder Leertaste, oder Doppelklick darauf</translation>
    </message>
    <message>
        <source>Take the change back</source>
        <translation>Die Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>On the strip of the gradient</source>
        <translation>Auf dem Streifen des Verlaufs</translation>
    </message>
</context>
<context>
    <name>view::TransformDialog</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Transform by Numbers</source>
        <translation>Nach Zahlen transformieren</translation>
    </message>
    <message>
        <source>x of the fixed point</source>
        <translation>x des Fixpunkts</translation>
    </message>
    <message>
        <source>y of the fixed point</source>
        <translation>y des Fixpunkts</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Shear along x</source>
        <translation>Scherung längs x</translation>
    </message>
    <message>
        <source>Scale in x</source>
        <translation>Skalierung in x</translation>
    </message>
    <message>
        <source>Scale in y</source>
        <translation>Skalierung in y</translation>
    </message>
    <message>
        <source>Same in x and y</source>
        <translation>Gleich in x und y</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise</source>
        <translation>Drehung in Grad, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Translation in x</source>
        <translation>Verschiebung in x</translation>
    </message>
    <message>
        <source>Translation in y</source>
        <translation>Verschiebung in y</translation>
    </message>
    <message>
        <source>Done in this order, from top to bottom.</source>
        <translation>In dieser Reihenfolge, von oben nach unten.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Start Again</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>All values as they were when the dialog opened</source>
        <translation>Alle Werte wie beim Öffnen des Dialogs</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Das Bild platzieren</translation>
    </message>
    <message>
        <source>The code stays; the cage moves</source>
        <translation>Der Code bleibt; der Käfig bewegt sich</translation>
    </message>
    <message>
        <source>Rewrite the code</source>
        <translation>Den Code umschreiben</translation>
    </message>
    <message>
        <source>Every map w becomes T∘w∘T⁻¹; the cage follows</source>
        <translation>Aus jeder Abbildung w wird T∘w∘T⁻¹; der Käfig folgt</translation>
    </message>
    <message>
        <source>The point that stays</source>
        <translation>Der Punkt, der bleibt</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>den Ursprung</translation>
    </message>
    <message>
        <source>the mean of the invariant measure</source>
        <translation>den Mittelwert des invarianten Maßes</translation>
    </message>
    <message>
        <source>a typed point</source>
        <translation>einen eingetippten Punkt</translation>
    </message>
    <message>
        <source>in the line at the angle °</source>
        <translation>an der Geraden im Winkel °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Winkel der Spiegelgeraden in Grad: 0 ist waagrecht, 90 senkrecht</translation>
    </message>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Dieser Eintrag hat keine Abbildungen der Ebene.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be undone, so it cannot be written into the code. Choose other scales, or place the picture.</source>
        <translation>Diese Transformation ist zu flach, um sie umzukehren, und kann nicht in den Code geschrieben werden. Wählen Sie andere Skalierungen oder platzieren Sie das Bild.</translation>
    </message>
    <message>
        <source>Transform the picture</source>
        <translation>Das Bild transformieren</translation>
    </message>
    <message>
        <source>Transform the code</source>
        <translation>Den Code transformieren</translation>
    </message>
    <message>
        <source>Keeps the factor in y equal to that in x.</source>
        <translation>Hält den Faktor in y gleich dem in x.</translation>
    </message>
    <message>
        <source>About which point the fractal is turned, scaled and reflected: it stays where it is.</source>
        <translation>Um welchen Punkt das Fraktal gedreht, skaliert und gespiegelt wird: Er bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Mirrors in a line through the point that stays; the angle is counted from the x axis.</source>
        <translation>Spiegelt an einer Geraden durch den Punkt, der bleibt; der Winkel zählt von der x-Achse.</translation>
    </message>
    <message>
        <source>Change:</source>
        <translation>Ändern:</translation>
    </message>
    <message>
        <source>About:</source>
        <translation>Um:</translation>
    </message>
    <message>
        <source>Reflect:</source>
        <translation>Spiegeln:</translation>
    </message>
    <message>
        <source>Shear:</source>
        <translation>Scherung:</translation>
    </message>
    <message>
        <source>Scale:</source>
        <translation>Skalieren:</translation>
    </message>
    <message>
        <source>Rotate °:</source>
        <translation>Drehen °:</translation>
    </message>
    <message>
        <source>Translate:</source>
        <translation>Verschieben:</translation>
    </message>
    <message>
        <source>the middle of the picture’s box</source>
        <translation>die Mitte des Rechtecks um das Bild</translation>
    </message>
</context>
<context>
    <name>view::VertexDialog</name>
    <message>
        <source>Move vertex %1</source>
        <translation>Ecke %1 bewegen</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Ecke %1</translation>
    </message>
    <message>
        <source>x of the vertex</source>
        <translation>x der Ecke</translation>
    </message>
    <message>
        <source>y of the vertex</source>
        <translation>y der Ecke</translation>
    </message>
    <message>
        <source>What is wrong with the numbers</source>
        <translation>Was an den Zahlen nicht stimmt</translation>
    </message>
    <message>
        <source>&amp;x</source>
        <translation>&amp;x</translation>
    </message>
    <message>
        <source>&amp;y</source>
        <translation>&amp;y</translation>
    </message>
    <message>
        <source>“%1” is not a number. Write it with a decimal point, for example -0.25.</source>
        <translation>„%1“ ist keine Zahl. Schreiben Sie sie mit einem Dezimalpunkt, zum Beispiel -0.25.</translation>
    </message>
    <message>
        <source>A coordinate of the vertex, with a decimal point or comma. The picture follows as you type.</source>
        <translation>Eine Koordinate der Ecke, mit Dezimalpunkt oder Komma. Das Bild folgt beim Tippen.</translation>
    </message>
</context>
</TS>
