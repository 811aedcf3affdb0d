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
    <name>ActionDetails</name>
    <message>
        <source>Drag an edge to move both its ends, the inside to move the whole cage. Ctrl rotates, Alt scales, Shift keeps directions. The fractal follows at once, and each drag is one step of the history.</source>
        <translation>Eine Kante bewegt ihre beiden Enden, das Innere den ganzen Käfig. Strg dreht, Alt skaliert, Umschalt behält Richtungen bei. Das Fraktal folgt sofort, und jeder Zug ist ein Schritt im Verlauf.</translation>
    </message>
    <message>
        <source>Each map is shown as the image of the cage in its colour. A corner changes one map; the inside moves all selected maps. A drag stops where the attractor would be lost.</source>
        <translation>Jede Abbildung erscheint als Bild des Käfigs in ihrer Farbe. Eine Ecke ändert eine Abbildung, das Innere bewegt alle gewählten. Ein Zug hält an, wo der Attraktor verloren ginge.</translation>
    </message>
    <message>
        <source>The picture stays where it is and follows the new triangle from now on. Backspace removes the last point, Esc cancels.</source>
        <translation>Das Bild bleibt, wo es ist: Von nun an wird es am neuen Dreieck gehalten. Die Rücktaste nimmt die letzte Ecke zurück, Esc bricht ab.</translation>
    </message>
    <message>
        <source>The picture stays where it is. Every point of the fractal then has barycentric coordinates that are not negative.</source>
        <translation>Das Bild bleibt, wo es ist. Danach hat jeder Punkt des Fraktals baryzentrische Koordinaten, die nicht negativ sind.</translation>
    </message>
    <message>
        <source>The coefficients do not change. To keep the picture as it is and change the coefficients instead, use Bake.</source>
        <translation>Die Koeffizienten ändern sich nicht. Soll das Bild bleiben und sollen sich stattdessen die Koeffizienten ändern, hilft Einrechnen.</translation>
    </message>
    <message>
        <source>Each map w becomes T w T⁻¹, where T is the affine map from the cage at rest to the current cage. The cage is at rest afterwards. A cage that is flat or bends the picture cannot be baked.</source>
        <translation>Jede Abbildung w wird zu T w T⁻¹, wobei T das ist, was der Käfig mit dem Bild macht. Danach ist der Käfig in Ruhe. Ein flacher Käfig oder einer, der das Bild biegt, lässt sich nicht einrechnen.</translation>
    </message>
    <message>
        <source>The table of maps keeps its numbers, and Bake writes the placement into them later.</source>
        <translation>Die Tabelle der Abbildungen behält ihre Zahlen; Einrechnen schreibt die Lage später hinein.</translation>
    </message>
    <message>
        <source>The table of maps shows the new numbers during the drag, and the cage is at rest again afterwards.</source>
        <translation>Die Tabelle der Abbildungen zeigt die neuen Zahlen schon während des Ziehens, und danach ist der Käfig wieder in Ruhe.</translation>
    </message>
    <message>
        <source>The cage is included if that needs little space. The fractal itself does not change.</source>
        <translation>Der Käfig gehört dazu, wo das wenig Platz kostet. Das Fraktal selbst ändert sich nicht.</translation>
    </message>
    <message>
        <source>Only the view is flipped: coefficients and coordinates do not change.</source>
        <translation>Nur die Ansicht wird gespiegelt: Koeffizienten und Koordinaten ändern sich nicht.</translation>
    </message>
    <message>
        <source>Press the key again to show the cage, handles, grid, axes and outlines.</source>
        <translation>Käfig, Griffe, Gitter, Achsen und Umrisse kehren zurück, wenn Sie die Taste noch einmal drücken.</translation>
    </message>
    <message>
        <source>A bar appears under the canvas: choose the number of steps, or let the chaos game run point by point at any speed.</source>
        <translation>Unter der Zeichenfläche erscheint eine Leiste: Wählen Sie die Zahl der Schritte, oder lassen Sie das Chaosspiel Punkt für Punkt in beliebigem Tempo laufen.</translation>
    </message>
    <message>
        <source>As a placement, it leaves the coefficients unchanged; as code, it replaces them by those of the transformed fractal. The canvas shows the result before you accept it.</source>
        <translation>Als Lage bleiben die Koeffizienten; als Code werden sie zu denen des transformierten Fraktals. Die Zeichenfläche zeigt das Ergebnis, bevor Sie es annehmen.</translation>
    </message>
    <message>
        <source>A new language takes effect at the next start; everything else at once, in all windows.</source>
        <translation>Eine neue Sprache gilt ab dem nächsten Start, alles andere sofort und in allen Fenstern.</translation>
    </message>
    <message>
        <source>Choose a motion, which needs no keys, or set keys. A change to something that has keys sets a key at the playhead; any other change applies to the whole animation.</source>
        <translation>Wählen Sie eine Bewegung, die keine Schlüssel braucht, oder setzen Sie Schlüssel: Was Schlüssel hat, bekommt einen weiteren, wo immer Sie es ändern; was keine hat, ändert sich für die ganze Animation.</translation>
    </message>
    <message>
        <source>If a table does not name its columns, you are asked for their order. In the Maps panel, Paste adds the copied maps, or rows of numbers, to the fractal.</source>
        <translation>Wenn eine Tabelle ihre Spalten nicht benennt, werden Sie nach deren Reihenfolge gefragt. Im Feld „Abbildungen“ fügt „Einfügen“ die kopierten Abbildungen oder Zeilen von Zahlen zum Fraktal hinzu.</translation>
    </message>
    <message>
        <source>Acts on maps while the table of maps, or the canvas with the Maps tool, has the focus, and on entries while the list of entries has it.</source>
        <translation>Es gilt, was den Fokus hat: Die Tabelle der Abbildungen und die Zeichenfläche mit dem Werkzeug Abbildungen verschieben Abbildungen, die Liste der Einträge Einträge.</translation>
    </message>
    <message>
        <source>Maps are copied with their names and as rows of numbers, entries as .ifs text that other programs can read.</source>
        <translation>Abbildungen werden mit ihren Namen und als Zeilen von Zahlen kopiert, Einträge als .ifs-Text, den andere Programme lesen können.</translation>
    </message>
    <message>
        <source>A locked map cannot be edited in the table, dragged, nudged, arranged, fitted or deleted. Changes to the whole fractal, such as a cage that rewrites the code, also change its locked maps.</source>
        <translation>Eine gesperrte Abbildung lässt sich nicht überschreiben, ziehen, schieben, anordnen, anpassen oder löschen. Was das ganze Fraktal ändert, etwa ein Käfig, der den Code umschreibt, ändert auch seine gesperrten Abbildungen.</translation>
    </message>
    <message>
        <source>Draws only the part of the attractor that this map makes. The file does not change. If you select another entry, its whole attractor is shown.</source>
        <translation>Nur der Teil des Attraktors, den die Abbildung erzeugt, wird gezeichnet. Die Datei ändert sich nicht, und ein anderer Eintrag erscheint wieder ganz.</translation>
    </message>
    <message>
        <source>Shift + wheel chooses how deep the branch is. The bar under the canvas says what the drag changes: a new map for this branch, the last map of its address, only this branch, or this branch and the same one inside it.</source>
        <translation>Umschalt + Mausrad wählt, wie tief der Ast liegt. Die Leiste unter der Zeichenfläche sagt, was der Zug ändert: eine neue Abbildung für diesen Ast, die letzte Abbildung seiner Adresse, nur diesen Ast oder diesen Ast und denselben in ihm.</translation>
    </message>
    <message>
        <source>The spacing of its lines follows the zoom. Vertices snap to it if this is chosen under View › Canvas › Snap To.</source>
        <translation>Der Abstand seiner Linien folgt dem Zoom. Ecken rasten daran ein, wenn das unter Ansicht › Zeichenfläche › Einrasten an gewählt ist.</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Attraktor</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Kontraktion</translation>
    </message>
    <message>
        <source>‖A‖ of each active map: the largest factor by which it stretches distances.</source>
        <translation>‖A‖ jeder aktiven Abbildung: der größte Faktor, um den sie Abstände streckt.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
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
        <source>Covariance</source>
        <translation>Kovarianz</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Fixpunkte</translation>
    </message>
    <message>
        <source>The point that each map leaves unchanged; it belongs to the attractor.</source>
        <translation>Der Punkt, den jede Abbildung an seinem Ort lässt; er liegt auf dem Attraktor.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Affinitätsdimension</translation>
    </message>
    <message>
        <source>Falconer’s dimension, at most 2: the exponent at which the sum of the singular value functions of all words of one length neither grows nor shrinks as the words get longer. It is an upper bound for the box-counting dimension, and equal to it for almost all translations if the maps contract enough.</source>
        <translation>Falconers Dimension: wo die Summe der Singulärwertfunktionen aller Wörter gleicher Länge weder wächst noch fällt, höchstens 2. Eine obere Schranke der Boxdimension und ihr gleich für fast alle Verschiebungen, wenn die Abbildungen genug kontrahieren.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Boxdimension</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Fläche der Hülle</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Ecken der Hülle</translation>
    </message>
    <message>
        <source>Vertices of the computed hull; each is a point of the attractor. If the exact hull has infinitely many, as many are computed as the tolerance requires.</source>
        <translation>Ecken der konvexen Hülle, wie gefunden, jede ein Punkt des Attraktors. Eine Hülle mit unendlich vielen hat so viele, wie ihre Toleranz verlangt.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Fehlerschranke der Hülle</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polygon; certified.</source>
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
        <source>Separation</source>
        <translation>Trennung</translation>
    </message>
    <message>
        <source>Whether the pieces that the maps make of the attractor are disjoint (strong separation, proved by disjoint covers), or words of maps coincide, so that the open set condition fails.</source>
        <translation>Ob die Teile, die die Abbildungen aus dem Attraktor machen, disjunkt sind (starke Trennung, durch disjunkte Überdeckungen bewiesen) oder Wörter von Abbildungen zusammenfallen, sodass die Offene-Mengen-Bedingung verletzt ist.</translation>
    </message>
    <message>
        <source>Connectedness</source>
        <translation>Zusammenhang</translation>
    </message>
    <message>
        <source>Overlaps</source>
        <translation>Überlappungen</translation>
    </message>
    <message>
        <source>Different words that compose to the same map, neither a prefix of the other: their pieces coincide.</source>
        <translation>Wörter von Abbildungen, die ein und dieselbe Abbildung sind und von denen keines der Anfang des anderen ist: ihre Teile fallen zusammen.</translation>
    </message>
    <message>
        <source>Joint spectral radius</source>
        <translation>Gemeinsamer Spektralradius</translation>
    </message>
    <message>
        <source>Entropy</source>
        <translation>Entropie</translation>
    </message>
    <message>
        <source>−Σ pᵢ ln pᵢ: the uncertainty of one step of the chaos game, in nats.</source>
        <translation>−Σ pᵢ ln pᵢ: wie viel ein Schritt des Chaosspiels offenlässt, in Nat.</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Ljapunow-Exponent</translation>
    </message>
    <message>
        <source>Σ pᵢ ln sᵢ: how the logarithm of a distance changes per step of the chaos game, if all maps are similarities in some coordinates.</source>
        <translation>Σ pᵢ ln sᵢ: wie sich der Logarithmus eines Abstands je Schritt des Chaosspiels ändert, wenn alle Abbildungen in geeigneten Koordinaten Ähnlichkeiten sind.</translation>
    </message>
    <message>
        <source>Dimension of the measure</source>
        <translation>Dimension des Maßes</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 2: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Entropie geteilt durch den negativen Ljapunow-Exponenten, höchstens 2: die Dimension des invarianten Maßes unter der Offene-Mengen-Bedingung, sonst eine obere Schranke dafür.</translation>
    </message>
    <message>
        <source>The number D with Σ sᵢᴰ = 1, where sᵢ are the ratios of the maps, if all maps are similarities in some coordinates. It is the dimension of the attractor under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Die Zahl D mit Σ sᵢᴰ = 1, wobei sᵢ die Verhältnisse der Abbildungen sind, wenn alle in geeigneten Koordinaten Ähnlichkeiten sind. Sie ist die Dimension des Attraktors unter der Offene-Mengen-Bedingung, sonst eine obere Schranke dafür.</translation>
    </message>
    <message>
        <source>Slope of the least-squares line of ln N against ln 1/ε, where N is the number of boxes of side ε that meet the attractor, over the sizes where it is most stable. This is an estimate: the uncertainty is the difference between parts of that range, not a proven bound.</source>
        <translation>Steigung der Ausgleichsgeraden von ln N über ln 1/ε, wobei N die Anzahl der Kästchen der Seite ε ist, die den Attraktor treffen, über die Größen, bei denen sie am gleichmäßigsten ist. Es ist eine Schätzung; die Unsicherheit folgt daraus, wie sich Teile dieses Bereichs unterscheiden, und ist kein Beweis.</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved without sampling: the centre of mass of the picture.</source>
        <translation>Mittelwert des invarianten Maßes, ohne Stichproben berechnet: der Schwerpunkt des Bildes.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved without sampling: how far the picture spreads. A uniform mass on the ellipse has the same mean and covariance.</source>
        <translation>Kovarianz xx, xy, yy des invarianten Maßes, ohne Stichproben berechnet: wie weit sich das Bild ausbreitet. Eine gleichmäßige Masse, die die Ellipse füllt, hat denselben Mittelwert und dieselbe Kovarianz.</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that contains the attractor; certified. Each side is off by at most the error.</source>
        <translation>Das kleinste achsenparallele Rechteck, das den Attraktor enthält; zertifiziert. Seine Seiten weichen höchstens um den Fehler ab.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>Das kleinste gleichschenklig-rechtwinklige Dreieck mit achsenparallelen Katheten, das den Attraktor enthält; zertifiziert. Die Vorzeichen geben die Richtungen seiner Katheten an. Bei einem einzelnen Punkt ist die Kathete 1.</translation>
    </message>
    <message>
        <source>Area of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most its perimeter times the error bound e, and πe² for the corners.</source>
        <translation>Fläche der berechneten Hülle, deren Ecken Punkte des Attraktors sind. Die exakte konvexe Hülle ist höchstens um ihren Umfang mal die Fehlerschranke e und πe² für die Ecken größer.</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 3: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Entropie geteilt durch das Negative des Ljapunow-Exponenten, höchstens 3: die Dimension des invarianten Maßes unter der Offene-Mengen-Bedingung, sonst eine obere Schranke dafür.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, xz, yy, yz, zz of the invariant measure, solved without sampling: how far the picture spreads.</source>
        <translation>Kovarianz xx, xy, xz, yy, yz, zz des invarianten Maßes, ohne Stichproben berechnet: wie weit sich das Bild ausbreitet.</translation>
    </message>
    <message>
        <source>Box</source>
        <comment>in space</comment>
        <translation>Quader</translation>
    </message>
    <message>
        <source>The smallest box with edges parallel to the axes that contains the attractor, to the error bound.</source>
        <translation>Der kleinste achsenparallele Quader, der den Attraktor enthält, bis auf die Fehlerschranke.</translation>
    </message>
    <message>
        <source>Box error bound</source>
        <translation>Fehlerschranke des Quaders</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the box; certified.</source>
        <translation>Der Attraktor reicht höchstens so weit über den Quader hinaus; bewiesen.</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>Das kleinste Tetraeder mit drei gleich langen, achsenparallelen Schenkeln, das den Attraktor enthält; zertifiziert. Die Vorzeichen geben die Richtungen der Schenkel an. Bei einem einzelnen Punkt ist der Schenkel 1.</translation>
    </message>
    <message>
        <source>Hull volume</source>
        <translation>Volumen der Hülle</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polyhedron; certified.</source>
        <translation>Der Attraktor reicht höchstens so weit über das Polyeder hinaus; bewiesen.</translation>
    </message>
    <message>
        <source>Tile area</source>
        <translation>Fläche der Kachel</translation>
    </message>
    <message>
        <source>Boundary dimension</source>
        <translation>Dimension des Randes</translation>
    </message>
    <message>
        <source>Dimension of the boundary, if all maps are similarities of one ratio whose pieces fill an area and meet in finitely many ways: from the growth of the number of contacts.</source>
        <translation>Dimension des Randes, wenn alle Abbildungen Ähnlichkeiten mit einem Faktor sind, deren Teile eine Fläche füllen und sich auf endlich viele Arten berühren: aus dem Wachstum der Zahl der Berührungen.</translation>
    </message>
    <message>
        <source>Moran equation</source>
        <translation>Moran-Gleichung</translation>
    </message>
    <message>
        <source>Σ sᵢᴰ = 1 with the ratios of these maps, equal ratios combined. Its solution is the similarity dimension.</source>
        <translation>Σ sᵢᴰ = 1 mit den Verhältnissen dieser Abbildungen, gleiche zusammengefasst. Ihre Lösung ist die Ähnlichkeitsdimension.</translation>
    </message>
    <message>
        <source>A compact set to which the iterates of every compact set converge. A system has one if and only if its maps contract in some norm.</source>
        <translation>Eine kompakte Menge, zu der jede kompakte Ausgangsmenge Schritt für Schritt führt. Ein System hat genau dann eine, wenn seine Abbildungen in einer Norm kontrahieren.</translation>
    </message>
    <message>
        <source>An attractor is connected if and only if its pieces are joined by common points (Hata). Common points are looked for among fixed points of short words, and their absence is proved by disjoint covers.</source>
        <translation>Ein Attraktor hängt genau dann zusammen, wenn gemeinsame Punkte seine Teile verbinden (Hata). Gemeinsame Punkte werden unter den Fixpunkten kurzer Wörter gesucht; dass es keine gibt, beweisen disjunkte Überdeckungen.</translation>
    </message>
    <message>
        <source>The largest factor per map by which long words stretch. Both ends of the interval are proved; a system contracts in some norm if and only if it is less than 1.</source>
        <translation>Der größte Faktor je Abbildung, um den lange Wörter strecken. Beide Enden des Intervalls sind bewiesen; ein System kontrahiert genau dann in einer Norm, wenn er kleiner als 1 ist.</translation>
    </message>
    <message>
        <source>Volume of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most the error.</source>
        <translation>Volumen der berechneten Hülle, deren Ecken Punkte des Attraktors sind. Die exakte konvexe Hülle ist höchstens um den Fehler größer.</translation>
    </message>
    <message>
        <source>There is no value, because it is not proved that there is an attractor.</source>
        <translation>Es gibt keinen Wert, weil nicht bewiesen ist, dass es einen Attraktor gibt.</translation>
    </message>
    <message>
        <source>There is no value, because there is no attractor.</source>
        <translation>Es gibt keinen Wert, weil es keinen Attraktor gibt.</translation>
    </message>
    <message>
        <source>There is no value: for these maps, none could be computed.</source>
        <translation>Es gibt keinen Wert: für diese Abbildungen ließ sich keiner berechnen.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not all similarities in the same coordinates.</source>
        <translation>Es gibt keinen Wert, weil nicht alle Abbildungen in denselben Koordinaten Ähnlichkeiten sind.</translation>
    </message>
    <message>
        <source>No overlaps were found.</source>
        <translation>Es wurden keine Überlappungen gefunden.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not of this kind.</source>
        <translation>Es gibt keinen Wert, weil diese Abbildungen nicht von dieser Art sind.</translation>
    </message>
    <message>
        <source>There is no value, because the maps are linked: the equation is another.</source>
        <translation>Es gibt keinen Wert, weil die Abbildungen verknüpft sind: Die Gleichung ist eine andere.</translation>
    </message>
    <message>
        <source>There is no value, because the maps contract by too little to bound it.</source>
        <translation>Es gibt keinen Wert, weil die Abbildungen zu wenig kontrahieren, um ihn abzuschätzen.</translation>
    </message>
    <message>
        <source>Open set condition</source>
        <translation>Offene-Mengen-Bedingung</translation>
    </message>
    <message>
        <source>Whether there is an open set with disjoint images in it. It is proved where the pieces are disjoint, where an area of the attractor is, and where the neighbours of pieces of one size are finitely many, and none of them coincides with its neighbour.</source>
        <translation>Ob es eine offene Menge gibt, die ihre Bilder enthält und deren Bilder disjunkt sind. Das ist bewiesen, wo die Teile disjunkt sind, wo der Attraktor bewiesenermaßen eine Fläche hat und wo gleich große Teile nur endlich viele Nachbarn haben, von denen keiner mit dem Teil zusammenfällt.</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Hausdorff-Dimension</translation>
    </message>
    <message>
        <source>Dimension of the attractor, where it is proved: the similarity dimension under the open set condition; or, where pieces coincide and there are finitely many neighbours, by the growth of the number of different maps.</source>
        <translation>Dimension des Attraktors, wo sie bewiesen ist: unter der Offene-Mengen-Bedingung die Ähnlichkeitsdimension; wo Teile zusammenfallen und es nur endlich viele Nachbarn gibt, aus dem Wachstum der Anzahl verschiedener Abbildungen.</translation>
    </message>
    <message>
        <source>There is no value: it is not known how much the pieces overlap, or the maps are no similarities.</source>
        <translation>Es gibt keinen Wert: Es ist nicht bekannt, wie weit die Teile sich überlappen, oder die Abbildungen sind keine Ähnlichkeiten.</translation>
    </message>
    <message>
        <source>Area of the attractor, if its copies, moved by a lattice and turned by a few turns, cover the plane equally often; proved by the contacts of the copies, or by counting those that hold a point.</source>
        <translation>Fläche des Attraktors, wenn seine Kopien, um ein Gitter verschoben und um wenige Winkel gedreht, die Ebene überall gleich oft überdecken; bewiesen durch die Berührungen der Kopien oder durch Abzählen der Kopien, in denen ein Punkt liegt.</translation>
    </message>
    <message>
        <source>There is no value: it is not proved that copies of the attractor cover the plane in this way.</source>
        <translation>Es gibt keinen Wert: Es ist nicht bewiesen, dass Kopien des Attraktors die Ebene auf diese Weise überdecken.</translation>
    </message>
    <message>
        <source>%1 (approximation)</source>
        <translation>%1 (Näherung)</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Grab a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Fass ein Fraktal an seinen Ecken: ein Editor für iterierte Funktionensysteme.</translation>
    </message>
    <message>
        <source>.ifs files to open, each in its own window</source>
        <translation>.ifs-Dateien, die geöffnet werden, jede in einem eigenen Fenster</translation>
    </message>
    <message>
        <source>start with the maple instead of the last session</source>
        <translation>mit dem Ahorn statt mit der letzten Sitzung beginnen</translation>
    </message>
    <message>
        <source>open a window with the collection</source>
        <translation>ein Fenster mit der Sammlung öffnen</translation>
    </message>
    <message>
        <source>open a window with random fractals to choose from</source>
        <translation>ein Fenster mit zufälligen Fraktalen zur Auswahl öffnen</translation>
    </message>
    <message>
        <source>draw the maple to a PNG file instead; needs no display</source>
        <translation>stattdessen den Ahorn in eine PNG-Datei zeichnen; braucht keinen Bildschirm</translation>
    </message>
    <message>
        <source>The system does not let Barycage start another thread. Close other programs, or raise the limit on processes, and try again.</source>
        <translation>Das System lässt Barycage keinen weiteren Thread starten. Schließen Sie andere Programme oder erhöhen Sie die erlaubte Zahl der Prozesse, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
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
        <translation>Die beiden Systeme von E. Hadzieva und M. Shuminoska mit den Koeffizienten, wie sie gedruckt sind.</translation>
    </message>
    <message>
        <source>Ferns</source>
        <translation>Farne</translation>
    </message>
    <message>
        <source>Fronds: one large map climbs the rachis, two small ones attach the pinnae, and a flat one draws the stem.</source>
        <translation>Wedel: Eine große Abbildung steigt die Spindel hinauf, zwei kleine setzen die Fiedern an, und eine flache zeichnet den Stiel.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Bäume</translation>
    </message>
    <message>
        <source>Forking trunks: the branches of the tree are copies of the whole tree.</source>
        <translation>Stämme, die sich gabeln: Die Äste des Baums sind Kopien des ganzen Baums.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Drachen</translation>
    </message>
    <message>
        <source>Paper-folding curves, and fractals of two or three rotating similarities.</source>
        <translation>Kurven aus gefaltetem Papier und Fraktale aus zwei oder drei Drehstreckungen.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Sierpiński-Familie</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon made of smaller copies of itself, with holes between them.</source>
        <translation>Siebe und Teppiche: ein Vieleck aus kleineren Kopien seiner selbst, mit Löchern dazwischen.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Koch-Familie</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment again and again, and the islands they enclose.</source>
        <translation>Kurven, bei denen eine Strecke immer wieder ersetzt wird, und die Inseln, die sie umschließen.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Spiralen</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small maps that set beads along its path.</source>
        <translation>Eine Abbildung, die ein wenig dreht und verkleinert, und kleine, die Perlen auf ihren Weg setzen.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Blätter und Blüten</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are rotated copies of one another.</source>
        <translation>Umrisse von Blättern, und Blüten, deren Blütenblätter gedrehte Kopien voneinander sind.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Kacheln und Reptiles</translation>
    </message>
    <message>
        <source>Sets that tile the plane: rep-tiles, which are made of copies of themselves, and the central tiles of number systems.</source>
        <translation>Mengen, die die Ebene pflastern: Rep-Tiles, die aus Kopien ihrer selbst bestehen, und die zentralen Kacheln von Zahlsystemen.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Cantormengen und Staub</translation>
    </message>
    <message>
        <source>Sets with gaps at every scale: the points crowd together, but hardly any are connected.</source>
        <translation>Mengen mit Lücken in jeder Größe: Die Punkte drängen sich, aber kaum welche hängen zusammen.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Kristalle und Schneeflocken</translation>
    </message>
    <message>
        <source>Sets with the symmetry of snow crystals: five, six and more arms.</source>
        <translation>Mengen mit der Symmetrie von Schneekristallen: fünf, sechs und mehr Arme.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Kurven und Graphen</translation>
    </message>
    <message>
        <source>Graphs of unusual functions, smooth curves as attractors, and coordinates of space-filling curves.</source>
        <translation>Graphen ungewöhnlicher Funktionen, glatte Kurven als Attraktoren und Koordinaten raumfüllender Kurven.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Abstrakt</translation>
    </message>
    <message>
        <source>Affine patterns with no counterpart in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Affine Muster ohne Vorbild in der Natur: Verwandte des Siebs, Geflechte, Rosetten.</translation>
    </message>
    <message>
        <source>Polyhedra in space</source>
        <translation>Polyeder im Raum</translation>
    </message>
    <message>
        <source>A polyhedron made of smaller copies of itself, one at each corner.</source>
        <translation>Ein Polyeder aus kleineren Kopien seiner selbst, eine an jeder Ecke.</translation>
    </message>
    <message>
        <source>Sponges and cubes in space</source>
        <translation>Schwämme und Würfel im Raum</translation>
    </message>
    <message>
        <source>Cubes divided into smaller cubes, some of which are left out or turned.</source>
        <translation>In kleinere Würfel zerlegte Würfel, von denen einige weggelassen oder gedreht sind.</translation>
    </message>
    <message>
        <source>Plants in space</source>
        <translation>Pflanzen im Raum</translation>
    </message>
    <message>
        <source>Fronds and trees with branches all around the stem.</source>
        <translation>Wedel und Bäume mit Ästen rings um den Stamm.</translation>
    </message>
    <message>
        <source>Shells and corals in space</source>
        <translation>Schnecken und Korallen im Raum</translation>
    </message>
    <message>
        <source>Helical shells, cones arranged by the golden angle, and corals with thick branches.</source>
        <translation>Schraubenförmige Gehäuse, im Goldenen Winkel angeordnete Kegel und Korallen mit dicken Ästen.</translation>
    </message>
    <message>
        <source>Dragons in space</source>
        <translation>Drachen im Raum</translation>
    </message>
    <message>
        <source>Folded surfaces, and polyhedra whose copies are turned.</source>
        <translation>Gefaltete Flächen und Polyeder, deren Kopien gedreht sind.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>Fractals that move: wind, folding, growing, morphs, endless zooms, and flights in space.</source>
        <translation>Fraktale, die sich bewegen: Wind, Falten, Wachsen, Verwandlungen, endlose Zooms und Flüge im Raum.</translation>
    </message>
    <message>
        <source>Linked maps</source>
        <translation>Verknüpfte Abbildungen</translation>
    </message>
    <message>
        <source>Maps that may follow only certain maps: Penrose tiles, boundaries, and chaos games with rules.</source>
        <translation>Abbildungen, die nur auf manche folgen dürfen: Penrose-Kacheln, Ränder und Chaosspiele mit Regeln.</translation>
    </message>
    <message>
        <source>Fractal transformations</source>
        <translation>Fraktale Transformationen</translation>
    </message>
    <message>
        <source>Fractals coloured by a picture on another fractal; a double click opens both side by side.</source>
        <translation>Fraktale in den Farben eines Bildes auf einem anderen; ein Doppelklick öffnet beide nebeneinander.</translation>
    </message>
</context>
<context>
    <name>CollectionNames</name>
    <message>
        <source>Maple</source>
        <translation>Ahorn</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Blüte</translation>
    </message>
    <message>
        <source>Maple in the wind</source>
        <translation>Ahorn im Wind</translation>
    </message>
    <message>
        <source>Fern that unrolls</source>
        <translation>Farn, der sich entrollt</translation>
    </message>
    <message>
        <source>Paper strip that folds to a dragon</source>
        <translation>Papierstreifen, der sich zum Drachen faltet</translation>
    </message>
    <message>
        <source>Koch curve that grows spikes</source>
        <translation>Koch-Kurve, der Stacheln wachsen</translation>
    </message>
    <message>
        <source>Zoom into a flake without end</source>
        <translation>Endloser Zoom in eine Flocke</translation>
    </message>
    <message>
        <source>Walk through a weaving flower</source>
        <translation>Gang durch eine wogende Blüte</translation>
    </message>
    <message>
        <source>Tree in a storm</source>
        <translation>Baum im Sturm</translation>
    </message>
    <message>
        <source>Sea fan in the swell</source>
        <translation>Fächerkoralle in der Dünung</translation>
    </message>
    <message>
        <source>Bracts that breathe</source>
        <translation>Atmende Hochblätter</translation>
    </message>
    <message>
        <source>Pentagons that turn in place</source>
        <translation>Fünfecke, die sich auf der Stelle drehen</translation>
    </message>
    <message>
        <source>Menger sponge that turns</source>
        <translation>Menger-Schwamm, der sich dreht</translation>
    </message>
    <message>
        <source>Flight into the Menger sponge</source>
        <translation>Flug in den Menger-Schwamm</translation>
    </message>
    <message>
        <source>Tree in space that sways</source>
        <translation>Schwankender Baum im Raum</translation>
    </message>
    <message>
        <source>Snow star that becomes a fern of ice</source>
        <translation>Schneestern, der zum Eisfarn wird</translation>
    </message>
    <message>
        <source>Maple that becomes a fern</source>
        <translation>Ahorn, der zum Farn wird</translation>
    </message>
    <message>
        <source>Black spleenwort fern</source>
        <translation>Schwarzer Streifenfarn</translation>
    </message>
    <message>
        <source>Maiden fern</source>
        <translation>Sumpffarn</translation>
    </message>
    <message>
        <source>Culcita fern</source>
        <translation>Culcita-Farn</translation>
    </message>
    <message>
        <source>Fishbone fern</source>
        <translation>Schwertfarn</translation>
    </message>
    <message>
        <source>Fiddlehead: a frond still curled</source>
        <translation>Junger Farn: ein noch eingerollter Wedel</translation>
    </message>
    <message>
        <source>Bracken: opposite pinnae at the same height</source>
        <translation>Adlerfarn: gegenständige Fiedern auf gleicher Höhe</translation>
    </message>
    <message>
        <source>Lady fern: alternate pinnae, a nodding tip</source>
        <translation>Frauenfarn: wechselständige Fiedern, eine nickende Spitze</translation>
    </message>
    <message>
        <source>Maidenhair: a fan on a fine stalk</source>
        <translation>Frauenhaarfarn: ein Fächer auf feinem Stiel</translation>
    </message>
    <message>
        <source>Ostrich fern: a shuttlecock plume</source>
        <translation>Straußenfarn: ein Federbusch wie ein Federball</translation>
    </message>
    <message>
        <source>Golden fern: pinnae smaller by the golden ratio squared</source>
        <translation>Goldener Farn: Fiedern, verkleinert mit dem Quadrat des Goldenen Schnitts</translation>
    </message>
    <message>
        <source>Moss: a frond of frond-like feathers</source>
        <translation>Moos: ein Wedel aus wedelartigen Federn</translation>
    </message>
    <message>
        <source>Fractal tree</source>
        <translation>Fraktaler Baum</translation>
    </message>
    <message>
        <source>Golden tree: branches of 1/phi at 60 degrees, just touching</source>
        <translation>Goldener Baum: Äste im Verhältnis 1/φ unter 60°, die einander eben berühren</translation>
    </message>
    <message>
        <source>Stone pine: an umbrella of three boughs</source>
        <translation>Pinie: ein Schirm aus drei Ästen</translation>
    </message>
    <message>
        <source>Spruce: whorls of drooping boughs</source>
        <translation>Fichte: Quirle hängender Äste</translation>
    </message>
    <message>
        <source>Willow: branches that bend down</source>
        <translation>Weide: Äste, die sich herabneigen</translation>
    </message>
    <message>
        <source>Tree in the wind</source>
        <translation>Baum im Wind</translation>
    </message>
    <message>
        <source>Bonsai pine: flat cushions on a leaning trunk</source>
        <translation>Bonsai-Kiefer: flache Polster auf geneigtem Stamm</translation>
    </message>
    <message>
        <source>Cypress</source>
        <translation>Zypresse</translation>
    </message>
    <message>
        <source>Thorn bush: alternate twigs</source>
        <translation>Dornbusch: wechselständige Zweige</translation>
    </message>
    <message>
        <source>Poplar: narrow and steep</source>
        <translation>Pappel: schmal und steil</translation>
    </message>
    <message>
        <source>Ternary tree: three halves, drawn with their branches</source>
        <translation>Dreiästiger Baum: drei Hälften, mit ihren Ästen gezeichnet</translation>
    </message>
    <message>
        <source>Branching coral</source>
        <translation>Verzweigte Koralle</translation>
    </message>
    <message>
        <source>H-tree: right angles all the way</source>
        <translation>H-Baum: lauter rechte Winkel</translation>
    </message>
    <message>
        <source>Heighway dragon</source>
        <translation>Heighway-Drache</translation>
    </message>
    <message>
        <source>Twindragon</source>
        <translation>Zwillingsdrache</translation>
    </message>
    <message>
        <source>Levy dragon (C curve)</source>
        <translation>Lévy-Drache (C-Kurve)</translation>
    </message>
    <message>
        <source>Terdragon</source>
        <translation>Terdragon</translation>
    </message>
    <message>
        <source>Golden dragon</source>
        <translation>Goldener Drache</translation>
    </message>
    <message>
        <source>Tame twindragon</source>
        <translation>Zahmer Zwillingsdrache</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 100 degrees only</source>
        <translation>Drachenkurve, nur bis 100° entfaltet</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 115 degrees</source>
        <translation>Drachenkurve, bis 115° entfaltet</translation>
    </message>
    <message>
        <source>C curve on triangles of 100 degrees</source>
        <translation>C-Kurve auf Dreiecken von 100°</translation>
    </message>
    <message>
        <source>Z dragon: the three strokes of a Z</source>
        <translation>Z-Drache: die drei Striche eines Z</translation>
    </message>
    <message>
        <source>Sierpinski triangle</source>
        <translation>Sierpiński-Dreieck</translation>
    </message>
    <message>
        <source>Right-angled Sierpinski triangle</source>
        <translation>Rechtwinkliges Sierpiński-Dreieck</translation>
    </message>
    <message>
        <source>Sierpinski carpet</source>
        <translation>Sierpiński-Teppich</translation>
    </message>
    <message>
        <source>Vicsek fractal (saltire)</source>
        <translation>Vicsek-Fraktal (Andreaskreuz)</translation>
    </message>
    <message>
        <source>Vicsek fractal (cross)</source>
        <translation>Vicsek-Fraktal (Kreuz)</translation>
    </message>
    <message>
        <source>Sierpinski pentagon</source>
        <translation>Sierpiński-Fünfeck</translation>
    </message>
    <message>
        <source>Sierpinski hexagon</source>
        <translation>Sierpiński-Sechseck</translation>
    </message>
    <message>
        <source>Sierpinski heptagon</source>
        <translation>Sierpiński-Siebeneck</translation>
    </message>
    <message>
        <source>Sierpinski octagon</source>
        <translation>Sierpiński-Achteck</translation>
    </message>
    <message>
        <source>Sierpinski dodecagon</source>
        <translation>Sierpiński-Zwölfeck</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 3</source>
        <translation>Pascalsches Dreieck modulo 3</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 5</source>
        <translation>Pascalsches Dreieck modulo 5</translation>
    </message>
    <message>
        <source>Sierpinski pedal triangle</source>
        <translation>Sierpiński-Dreieck aus Höhenfußpunkten</translation>
    </message>
    <message>
        <source>Bedford-McMullen carpet</source>
        <translation>Bedford-McMullen-Teppich</translation>
    </message>
    <message>
        <source>Bedford-McMullen weave of 3 by 5 cells</source>
        <translation>Bedford-McMullen-Geflecht aus 3 mal 5 Feldern</translation>
    </message>
    <message>
        <source>Carpet of fifths with a cross-shaped hole</source>
        <translation>Teppich aus Fünfteln mit kreuzförmigem Loch</translation>
    </message>
    <message>
        <source>Carpet of quarters with a square hole</source>
        <translation>Teppich aus Vierteln mit quadratischem Loch</translation>
    </message>
    <message>
        <source>Checkered carpet</source>
        <translation>Schachbrettteppich</translation>
    </message>
    <message>
        <source>Koch curve</source>
        <translation>Koch-Kurve</translation>
    </message>
    <message>
        <source>Koch snowflake, filled</source>
        <translation>Koch-Schneeflocke, ausgefüllt</translation>
    </message>
    <message>
        <source>Cesaro curve of 85 degrees</source>
        <translation>Cesàro-Kurve mit 85°</translation>
    </message>
    <message>
        <source>Quadratic Koch curve of five edges</source>
        <translation>Quadratische Koch-Kurve aus fünf Strecken</translation>
    </message>
    <message>
        <source>Minkowski sausage</source>
        <translation>Minkowski-Wurst</translation>
    </message>
    <message>
        <source>Mandelbrot-Given curve</source>
        <translation>Mandelbrot-Given-Kurve</translation>
    </message>
    <message>
        <source>Ice fractal on a square</source>
        <translation>Eisfraktal auf einem Quadrat</translation>
    </message>
    <message>
        <source>Ice fractal with a pair of spikes</source>
        <translation>Eisfraktal mit zwei Stacheln</translation>
    </message>
    <message>
        <source>Koch curve drawn on both sides</source>
        <translation>Koch-Kurve nach beiden Seiten</translation>
    </message>
    <message>
        <source>Koch curve with peaks turned inwards</source>
        <translation>Koch-Kurve mit Zacken nach innen</translation>
    </message>
    <message>
        <source>Pentigree</source>
        <translation>Pentigree</translation>
    </message>
    <message>
        <source>Pentadendrite</source>
        <translation>Pentadendrit</translation>
    </message>
    <message>
        <source>Edge of the Gosper island</source>
        <translation>Rand der Gosper-Insel</translation>
    </message>
    <message>
        <source>Spiral of spirals</source>
        <translation>Spirale aus Spiralen</translation>
    </message>
    <message>
        <source>Swirl</source>
        <translation>Strudel</translation>
    </message>
    <message>
        <source>Galaxy with two arms</source>
        <translation>Galaxie mit zwei Armen</translation>
    </message>
    <message>
        <source>Whorl of three-fold rosettes</source>
        <translation>Quirl dreizähliger Rosetten</translation>
    </message>
    <message>
        <source>Ram&apos;s horn</source>
        <translation>Widderhorn</translation>
    </message>
    <message>
        <source>Whirl of pentagons</source>
        <translation>Wirbel aus Fünfecken</translation>
    </message>
    <message>
        <source>Double spiral between two eyes</source>
        <translation>Doppelspirale zwischen zwei Augen</translation>
    </message>
    <message>
        <source>Spiral of feathers</source>
        <translation>Spirale aus Federn</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a golden spiral</source>
        <translation>Nautilus: Kammern längs einer Goldenen Spirale</translation>
    </message>
    <message>
        <source>Sunflower: seeds at the golden angle</source>
        <translation>Sonnenblume: Kerne im Goldenen Winkel</translation>
    </message>
    <message>
        <source>Shell: ribs that follow the turn</source>
        <translation>Schneckenhaus: Rippen, die der Drehung folgen</translation>
    </message>
    <message>
        <source>Three spirals passing into one another</source>
        <translation>Drei Spiralen, die ineinander übergehen</translation>
    </message>
    <message>
        <source>Maple leaf</source>
        <translation>Ahornblatt</translation>
    </message>
    <message>
        <source>Pointed leaf</source>
        <translation>Spitzes Blatt</translation>
    </message>
    <message>
        <source>Poinsettia: five bracts</source>
        <translation>Weihnachtsstern: fünf Hochblätter</translation>
    </message>
    <message>
        <source>Edelweiss: eight woolly rays</source>
        <translation>Edelweiß: acht wollige Strahlen</translation>
    </message>
    <message>
        <source>Lily of six petals</source>
        <translation>Lilie mit sechs Blütenblättern</translation>
    </message>
    <message>
        <source>Oak leaf</source>
        <translation>Eichenblatt</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>Plane-tree leaf: five blades from one root</source>
        <translation>Platanenblatt: fünf Lappen aus einem Ansatz</translation>
    </message>
    <message>
        <source>Dill umbel</source>
        <translation>Dilldolde</translation>
    </message>
    <message>
        <source>Thistle head</source>
        <translation>Distelkopf</translation>
    </message>
    <message>
        <source>Dandelion clock</source>
        <translation>Pusteblume</translation>
    </message>
    <message>
        <source>Marigold: rings of petals</source>
        <translation>Ringelblume: Kränze aus Blütenblättern</translation>
    </message>
    <message>
        <source>Ear of wheat</source>
        <translation>Weizenähre</translation>
    </message>
    <message>
        <source>Chair rep-tile (L tromino)</source>
        <translation>Stuhl-Rep-Tile (L-Tromino)</translation>
    </message>
    <message>
        <source>Golden bee (Ammann&apos;s chair)</source>
        <translation>Goldene Biene (Ammanns Stuhl)</translation>
    </message>
    <message>
        <source>Gosper island</source>
        <translation>Gosper-Insel</translation>
    </message>
    <message>
        <source>Quintet</source>
        <translation>Quintett</translation>
    </message>
    <message>
        <source>Eisenstein fractal</source>
        <translation>Eisenstein-Fraktal</translation>
    </message>
    <message>
        <source>Rauzy fractal (tribonacci)</source>
        <translation>Rauzy-Fraktal (Tribonacci)</translation>
    </message>
    <message>
        <source>Hokkaido tile</source>
        <translation>Hokkaido-Kachel</translation>
    </message>
    <message>
        <source>Tile of Narayana&apos;s cows</source>
        <translation>Kachel von Narayanas Kühen</translation>
    </message>
    <message>
        <source>Tile of x^2 + x + 3</source>
        <translation>Kachel von x² + x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 3</source>
        <translation>Kachel von x² + 2x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 3 x + 3</source>
        <translation>Kachel von x² + 3x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 4</source>
        <translation>Kachel von x² + 2x + 4</translation>
    </message>
    <message>
        <source>Jigsaw square: nine thirds, one pushed out</source>
        <translation>Puzzle-Quadrat: neun Drittel, eines hinausgeschoben</translation>
    </message>
    <message>
        <source>Numbers in base -2+i with digits 0 to 4</source>
        <translation>Zahlen zur Basis −2+i mit den Ziffern 0 bis 4</translation>
    </message>
    <message>
        <source>Fudgeflake: three terdragons round a point</source>
        <translation>Fudgeflake: drei Terdragons um einen Punkt</translation>
    </message>
    <message>
        <source>Central tile of x^3 = 2 x^2 + x + 1</source>
        <translation>Zentrale Kachel von x³ = 2x² + x + 1</translation>
    </message>
    <message>
        <source>Penrose tiles</source>
        <translation>Penrose-Kacheln</translation>
    </message>
    <message>
        <source>Penrose tiles, cracked</source>
        <translation>Penrose-Kacheln mit Rissen</translation>
    </message>
    <message>
        <source>Parts of the Rauzy fractal</source>
        <translation>Teile des Rauzy-Fraktals</translation>
    </message>
    <message>
        <source>Boundary of the dragon</source>
        <translation>Rand des Drachen</translation>
    </message>
    <message>
        <source>Boundary of the twindragon</source>
        <translation>Rand des Zwillingsdrachen</translation>
    </message>
    <message>
        <source>Golden mean carpet</source>
        <translation>Teppich des Goldenen Schnitts</translation>
    </message>
    <message>
        <source>Golden mean dragon</source>
        <translation>Drache des Goldenen Schnitts</translation>
    </message>
    <message>
        <source>Restless pentagon</source>
        <translation>Rastloses Fünfeck</translation>
    </message>
    <message>
        <source>One-way square</source>
        <translation>Einbahnquadrat</translation>
    </message>
    <message>
        <source>Neighbouring corners</source>
        <translation>Benachbarte Ecken</translation>
    </message>
    <message>
        <source>Steps around a hexagon</source>
        <translation>Schritte um ein Sechseck</translation>
    </message>
    <message>
        <source>Steps around a pentagon</source>
        <translation>Schritte um ein Fünfeck</translation>
    </message>
    <message>
        <source>Old and young</source>
        <translation>Alt und Jung</translation>
    </message>
    <message>
        <source>Sunset in a triangle</source>
        <translation>Sonnenuntergang im Dreieck</translation>
    </message>
    <message>
        <source>Triangle for the sunset</source>
        <translation>Dreieck für den Sonnenuntergang</translation>
    </message>
    <message>
        <source>Bent window</source>
        <translation>Verbogenes Glasfenster</translation>
    </message>
    <message>
        <source>Triangle for the glass</source>
        <translation>Dreieck für das Glasfenster</translation>
    </message>
    <message>
        <source>Tartan in a square</source>
        <translation>Schottenkaro im Quadrat</translation>
    </message>
    <message>
        <source>Square for the tartan</source>
        <translation>Quadrat für das Schottenkaro</translation>
    </message>
    <message>
        <source>Grid of a square</source>
        <translation>Gitter eines Quadrats</translation>
    </message>
    <message>
        <source>Square for the grid</source>
        <translation>Quadrat für das Gitter</translation>
    </message>
    <message>
        <source>Rainbow fern</source>
        <translation>Regenbogenfarn</translation>
    </message>
    <message>
        <source>Maple for the fern</source>
        <translation>Ahorn für den Farn</translation>
    </message>
    <message>
        <source>Autumn maple</source>
        <translation>Herbstahorn</translation>
    </message>
    <message>
        <source>Square for the maple</source>
        <translation>Quadrat für den Ahorn</translation>
    </message>
    <message>
        <source>Dragon of paper</source>
        <translation>Drache aus Papier</translation>
    </message>
    <message>
        <source>Sheet for the dragon</source>
        <translation>Bogen Papier für den Drachen</translation>
    </message>
    <message>
        <source>Curve of waves</source>
        <translation>Kurve aus Wellen</translation>
    </message>
    <message>
        <source>Sheet for the curve</source>
        <translation>Bogen Papier für die Kurve</translation>
    </message>
    <message>
        <source>Koch curve across a square</source>
        <translation>Koch-Kurve quer durch ein Quadrat</translation>
    </message>
    <message>
        <source>Square for the curve</source>
        <translation>Quadrat für die Kurve</translation>
    </message>
    <message>
        <source>Hilbert curve along a coast</source>
        <translation>Hilbert-Kurve an einer Küste entlang</translation>
    </message>
    <message>
        <source>Curve for the square</source>
        <translation>Kurve für das Quadrat</translation>
    </message>
    <message>
        <source>Broken picture</source>
        <translation>Zerbrochenes Bild</translation>
    </message>
    <message>
        <source>Square to break</source>
        <translation>Quadrat zum Zerbrechen</translation>
    </message>
    <message>
        <source>Gasket of a dragon</source>
        <translation>Sieb eines Drachen</translation>
    </message>
    <message>
        <source>Terdragon for the gasket</source>
        <translation>Terdragon für das Sieb</translation>
    </message>
    <message>
        <source>Cantor dust</source>
        <translation>Cantor-Staub</translation>
    </message>
    <message>
        <source>Cantor comb: a Cantor set times an interval</source>
        <translation>Cantor-Kamm: eine Cantormenge mal ein Intervall</translation>
    </message>
    <message>
        <source>Dust on a triangle</source>
        <translation>Staub auf einem Dreieck</translation>
    </message>
    <message>
        <source>Dust on a pentagon</source>
        <translation>Staub auf einem Fünfeck</translation>
    </message>
    <message>
        <source>Dust of unequal ratios</source>
        <translation>Staub mit ungleichen Verhältnissen</translation>
    </message>
    <message>
        <source>Dust on an octagon</source>
        <translation>Staub auf einem Achteck</translation>
    </message>
    <message>
        <source>Rings of dust</source>
        <translation>Ringe aus Staub</translation>
    </message>
    <message>
        <source>Tartan dust</source>
        <translation>Schottenkaro aus Staub</translation>
    </message>
    <message>
        <source>Pinwheel dust</source>
        <translation>Windrad aus Staub</translation>
    </message>
    <message>
        <source>Swirling dust of three</source>
        <translation>Staubwirbel aus drei Kopien</translation>
    </message>
    <message>
        <source>Hexaflake</source>
        <translation>Sechseckflocke</translation>
    </message>
    <message>
        <source>Pentaflake</source>
        <translation>Fünfeckflocke</translation>
    </message>
    <message>
        <source>Stellar snowflake</source>
        <translation>Sternförmige Schneeflocke</translation>
    </message>
    <message>
        <source>Fern-like snowflake</source>
        <translation>Farnartige Schneeflocke</translation>
    </message>
    <message>
        <source>Sectored plate</source>
        <translation>Schneeplättchen mit Sektoren</translation>
    </message>
    <message>
        <source>Needle snowflake</source>
        <translation>Nadelförmige Schneeflocke</translation>
    </message>
    <message>
        <source>Frost flower</source>
        <translation>Eisblume</translation>
    </message>
    <message>
        <source>Decaflake</source>
        <translation>Zehneckflocke</translation>
    </message>
    <message>
        <source>Pentagram flake</source>
        <translation>Pentagrammflocke</translation>
    </message>
    <message>
        <source>Quartz: four-fold lattice</source>
        <translation>Quarz: vierzähliges Gitter</translation>
    </message>
    <message>
        <source>Crystal of two maps</source>
        <translation>Kristall aus zwei Abbildungen</translation>
    </message>
    <message>
        <source>Dendrite snowflake</source>
        <translation>Dendritische Schneeflocke</translation>
    </message>
    <message>
        <source>Eight-pointed star</source>
        <translation>Achtzackiger Stern</translation>
    </message>
    <message>
        <source>Frost cross: squares turned by 45 degrees</source>
        <translation>Frostkreuz: um 45° gedrehte Quadrate</translation>
    </message>
    <message>
        <source>Takagi curve (blancmange)</source>
        <translation>Takagi-Kurve (Blancmange-Kurve)</translation>
    </message>
    <message>
        <source>Quadratic Bezier arc by de Casteljau</source>
        <translation>Quadratischer Bézier-Bogen nach de Casteljau</translation>
    </message>
    <message>
        <source>Devil&apos;s staircase</source>
        <translation>Teufelstreppe</translation>
    </message>
    <message>
        <source>Okamoto function, a = 2/3 (Bourbaki&apos;s)</source>
        <translation>Okamoto-Funktion, a = 2/3 (die von Bourbaki)</translation>
    </message>
    <message>
        <source>Okamoto function, a = 5/6 (Perkins&apos;s)</source>
        <translation>Okamoto-Funktion, a = 5/6 (die von Perkins)</translation>
    </message>
    <message>
        <source>Kiesswetter curve</source>
        <translation>Kiesswetter-Kurve</translation>
    </message>
    <message>
        <source>Bolzano function</source>
        <translation>Bolzano-Funktion</translation>
    </message>
    <message>
        <source>Fractal interpolation of four points</source>
        <translation>Fraktale Interpolation von vier Punkten</translation>
    </message>
    <message>
        <source>Mountain skyline</source>
        <translation>Bergsilhouette</translation>
    </message>
    <message>
        <source>First coordinate of Peano&apos;s curve</source>
        <translation>Erste Koordinate der Peano-Kurve</translation>
    </message>
    <message>
        <source>Lebesgue&apos;s singular function, a = 0.3</source>
        <translation>Lebesgues singuläre Funktion, a = 0,3</translation>
    </message>
    <message>
        <source>Takagi curve and its mirror image</source>
        <translation>Takagi-Kurve und ihr Spiegelbild</translation>
    </message>
    <message>
        <source>Hilbert&apos;s four maps, shrunk so that the seams open</source>
        <translation>Hilberts vier Abbildungen, verkleinert, bis die Nähte aufgehen</translation>
    </message>
    <message>
        <source>Relative of the Sierpinski triangle</source>
        <translation>Verwandter des Sierpiński-Dreiecks</translation>
    </message>
    <message>
        <source>Zigzag of two maps</source>
        <translation>Zickzack aus zwei Abbildungen</translation>
    </message>
    <message>
        <source>Coral</source>
        <translation>Koralle</translation>
    </message>
    <message>
        <source>Rosette of three</source>
        <translation>Dreiteilige Rosette</translation>
    </message>
    <message>
        <source>Rosette of five</source>
        <translation>Fünfteilige Rosette</translation>
    </message>
    <message>
        <source>Rosette of seven</source>
        <translation>Siebenteilige Rosette</translation>
    </message>
    <message>
        <source>Mandala of twelve</source>
        <translation>Zwölfteiliges Mandala</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Klöppelspitze</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Geflecht</translation>
    </message>
    <message>
        <source>Twigs: a turn and a mirror</source>
        <translation>Zweige: eine Drehung und eine Spiegelung</translation>
    </message>
    <message>
        <source>Heather</source>
        <translation>Heidekraut</translation>
    </message>
    <message>
        <source>Breaking wave</source>
        <translation>Brechende Welle</translation>
    </message>
    <message>
        <source>City seen from above</source>
        <translation>Stadt von oben</translation>
    </message>
    <message>
        <source>Flames</source>
        <translation>Flammen</translation>
    </message>
    <message>
        <source>Hills in haze</source>
        <translation>Hügel im Dunst</translation>
    </message>
    <message>
        <source>Knotwork: four copies turned by 45 degrees</source>
        <translation>Knotenmuster: vier um 45° gedrehte Kopien</translation>
    </message>
    <message>
        <source>Sea dragon</source>
        <translation>Seedrache</translation>
    </message>
    <message>
        <source>Kaleidoscope</source>
        <translation>Kaleidoskop</translation>
    </message>
    <message>
        <source>Sierpinski tetrahedron</source>
        <translation>Sierpiński-Tetraeder</translation>
    </message>
    <message>
        <source>Octahedron flake</source>
        <translation>Oktaederflocke</translation>
    </message>
    <message>
        <source>Sierpinski pyramid</source>
        <translation>Sierpiński-Pyramide</translation>
    </message>
    <message>
        <source>Icosahedron flake</source>
        <translation>Ikosaederflocke</translation>
    </message>
    <message>
        <source>Dodecahedron flake</source>
        <translation>Dodekaederflocke</translation>
    </message>
    <message>
        <source>Cuboctahedron flake</source>
        <translation>Kuboktaederflocke</translation>
    </message>
    <message>
        <source>Menger sponge</source>
        <translation>Menger-Schwamm</translation>
    </message>
    <message>
        <source>Mosely snowflake</source>
        <translation>Mosely-Schneeflocke</translation>
    </message>
    <message>
        <source>Jerusalem cube</source>
        <translation>Jerusalem-Würfel</translation>
    </message>
    <message>
        <source>Cross in space</source>
        <translation>Kreuz im Raum</translation>
    </message>
    <message>
        <source>Saltire in space</source>
        <translation>Andreaskreuz im Raum</translation>
    </message>
    <message>
        <source>Cantor dust in space</source>
        <translation>Cantor-Staub im Raum</translation>
    </message>
    <message>
        <source>Cube corner: seven of eight cubes</source>
        <translation>Würfelecke: sieben von acht Würfeln</translation>
    </message>
    <message>
        <source>Cube corners in mirrors</source>
        <translation>Würfelecken in Spiegeln</translation>
    </message>
    <message>
        <source>Quadratic Koch surface: cubes on squares</source>
        <translation>Quadratische Koch-Fläche: Würfel auf Quadraten</translation>
    </message>
    <message>
        <source>Fern in space</source>
        <translation>Farn im Raum</translation>
    </message>
    <message>
        <source>Tree with three boughs</source>
        <translation>Baum mit drei Ästen</translation>
    </message>
    <message>
        <source>Oak with a leader and four boughs</source>
        <translation>Eiche mit Leittrieb und vier Ästen</translation>
    </message>
    <message>
        <source>Fir: drooping whorls around a leader</source>
        <translation>Tanne: hängende Quirle um einen Leittrieb</translation>
    </message>
    <message>
        <source>Poplar: pairs of steep twigs</source>
        <translation>Pappel: Paare steiler Zweige</translation>
    </message>
    <message>
        <source>Umbel: six rays from the top of a stalk</source>
        <translation>Dolde: sechs Strahlen von der Spitze eines Stängels</translation>
    </message>
    <message>
        <source>Thuja: flat sprays turned by the golden angle</source>
        <translation>Lebensbaum: flache Zweige, um den Goldenen Winkel gedreht</translation>
    </message>
    <message>
        <source>Romanesco: cones on a cone, by the golden angle</source>
        <translation>Romanesco: Kegel auf einem Kegel, im Goldenen Winkel</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Blumenkohl</translation>
    </message>
    <message>
        <source>Turret shell</source>
        <translation>Turmschnecke</translation>
    </message>
    <message>
        <source>Top shell: whorls of whorls</source>
        <translation>Kreiselschnecke: Windungen aus Windungen</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a flat spiral</source>
        <translation>Nautilus: Kammern längs einer ebenen Spirale</translation>
    </message>
    <message>
        <source>Double helix that narrows to a point</source>
        <translation>Doppelhelix, die spitz zuläuft</translation>
    </message>
    <message>
        <source>Staghorn coral</source>
        <translation>Geweihkoralle</translation>
    </message>
    <message>
        <source>Bush coral</source>
        <translation>Buschkoralle</translation>
    </message>
    <message>
        <source>Sea fan: forks almost in one plane</source>
        <translation>Fächerkoralle: Gabelungen fast in einer Ebene</translation>
    </message>
    <message>
        <source>Allium: a ball of twelve stalks with alliums at their ends</source>
        <translation>Zierlauch: eine Kugel aus zwölf Stängeln, an deren Enden Zierlauch sitzt</translation>
    </message>
    <message>
        <source>Dragon in space: each fold about another axis</source>
        <translation>Drache im Raum: jede Faltung um eine andere Achse</translation>
    </message>
    <message>
        <source>C curve in space</source>
        <translation>C-Kurve im Raum</translation>
    </message>
    <message>
        <source>Terdragon in space</source>
        <translation>Terdragon im Raum</translation>
    </message>
    <message>
        <source>Tetrahedra, each turned by 60 degrees</source>
        <translation>Tetraeder, jedes um 60° gedreht</translation>
    </message>
    <message>
        <source>Cubes, each turned by 60 degrees</source>
        <translation>Würfel, jeder um 60° gedreht</translation>
    </message>
    <message>
        <source>Octahedra, each turned by 45 degrees</source>
        <translation>Oktaeder, jedes um 45° gedreht</translation>
    </message>
</context>
<context>
    <name>FirstChips</name>
    <message>
        <source>What to try next</source>
        <translation>Was Sie als Nächstes versuchen können</translation>
    </message>
</context>
<context>
    <name>FirstMinute</name>
    <message>
        <source>Take a corner.</source>
        <translation>Fassen Sie eine Ecke an.</translation>
    </message>
    <message>
        <source>Make it sway</source>
        <translation>Im Wind wiegen</translation>
    </message>
    <message>
        <source>Grow variations</source>
        <translation>Abwandlungen züchten</translation>
    </message>
    <message>
        <source>Save a poster</source>
        <translation>Als Poster speichern</translation>
    </message>
</context>
<context>
    <name>FlameBanner</name>
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
        <source>In flame files, y points down. The flames were flipped so that they look the same here as in flame programs.</source>
        <translation>In Flames wächst y nach unten. Sie wurden umgedreht, damit sie hier aussehen wie in Flame-Programmen.</translation>
    </message>
    <message>
        <source>Keep &amp;y As Written</source>
        <translation>&amp;y lassen, wie es geschrieben ist</translation>
    </message>
    <message>
        <source>Uses the numbers as they are in the file. The picture is then upside down.</source>
        <translation>Nimmt die Zahlen der Flames, wie sie im Text stehen. Das Bild steht dann auf dem Kopf.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Keep y as written</source>
        <translation>y lassen, wie es geschrieben ist</translation>
    </message>
    <message>
        <source>Flip the flames</source>
        <translation>Flames umdrehen</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Show or hide the “%1” panel</source>
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
        <source>, %n of them could not be read and are kept unchanged</source>
        <translation>
            <numerusform>, %n davon konnte nicht gelesen werden und bleibt, wie er ist</numerusform>
            <numerusform>, %n davon konnten nicht gelesen werden und bleiben, wie sie sind</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with warnings</source>
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
        <source>“%1” has unsaved changes.</source>
        <translation>„%1“ hat ungespeicherte Änderungen.</translation>
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
        <source>Another program has changed “%1” since you opened it.</source>
        <translation>Ein anderes Programm hat „%1“ geändert, seit Sie es geöffnet haben.</translation>
    </message>
    <message>
        <source>Saving overwrites the changes made by the other program.</source>
        <translation>Speichern überschreibt die Änderungen des anderen Programms.</translation>
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
        <source>Revert to “%1” as it is on disk? Your changes since then will be lost.</source>
        <translation>Zu „%1“ zurückkehren, wie es auf der Platte ist? Die Änderungen seither gehen verloren.</translation>
    </message>
    <message>
        <source>%1 could not be reloaded</source>
        <translation>%1 konnte nicht noch einmal gelesen werden</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine zuletzt benutzten Dateien</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>%1[*] — %2</source>
        <comment>file, entry</comment>
        <translation>%1[*] — %2</translation>
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
        <source>Save the file; entries that you did not edit stay unchanged, byte for byte</source>
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
        <source>Discard your changes and reload the file from disk</source>
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
        <source>The picture was copied to the clipboard.</source>
        <translation>Das Bild wurde in die Zwischenablage kopiert.</translation>
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
        <source>Undo the last edit</source>
        <translation>Die letzte Bearbeitung rückgängig machen</translation>
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
        <source>Redo the last edit that was undone</source>
        <translation>Die zuletzt rückgängig gemachte Bearbeitung wiederholen</translation>
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
        <source>Rotate, scale, shear, reflect or move the whole fractal by exact amounts</source>
        <translation>Das ganze Fraktal nach Zahlen drehen, skalieren, scheren, spiegeln oder verschieben</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Choose from a sheet of random fractals and add one to the file</source>
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
        <source>De&amp;fine Triangle</source>
        <translation>Dreieck &amp;festlegen</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>&amp;Minimales kanonisches Simplex anpassen</translation>
    </message>
    <message>
        <source>Fit the smallest isosceles right triangle with legs parallel to the axes around the attractor</source>
        <translation>Das kleinste gleichschenklig-rechtwinklige Dreieck mit achsenparallelen Katheten um den Attraktor legen</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Return the cage to rest: the picture shows the code as it is</source>
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
        <source>Write the placement into the code: the picture stays, and the coefficients change</source>
        <translation>Die Lage in den Code einrechnen: Das Bild bleibt, die Koeffizienten ändern sich</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Herausrechnen</translation>
    </message>
    <message>
        <source>Extract the placement from the code: the picture stays, and the code is rewritten for the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Die Lage aus dem Code herausrechnen: Das Bild bleibt, der Code wird der des Dreiecks (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Re&amp;gelmäßig machen</translation>
    </message>
    <message>
        <source>Move the vertices to the nearest regular polygon</source>
        <translation>Die Ecken auf das nächste regelmäßige Vieleck setzen</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>Affin &amp;invariante Form…</translation>
    </message>
    <message>
        <source>Show every map as a matrix over the control triangle, with rows that sum to 1</source>
        <translation>Jede Abbildung als zeilenstochastische Matrix über dem Kontrolldreieck zeigen</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Platzieren</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code does not change</source>
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
        <source>Point the y axis down, as in window coordinates</source>
        <translation>Die y-Achse nach unten richten, wie in Fensterkoordinaten</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas except the picture</source>
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
        <source>Make dragged vertices snap to this</source>
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
        <source>Fill the whole screen</source>
        <translation>Den ganzen Bildschirm nutzen</translation>
    </message>
    <message>
        <source>How It Is Built</source>
        <translation>Wie er entsteht</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor being built: in steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Zusehen, wie der Attraktor entsteht: in Schritten des deterministischen Algorithmus oder durch das Chaosspiel</translation>
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
        <translation>&amp;Handbuch (englisch)</translation>
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
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Grab a fractal by its corners: an editor for iterated function systems that describes their attractors in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Fass ein Fraktal an seinen Ecken: ein Editor für iterierte Funktionensysteme, deren Attraktoren in baryzentrischen Koordinaten eines Kontrolldreiecks gehalten werden.&lt;/p&gt;&lt;p&gt;Nach E. Hadzieva und M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT-Lizenz.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Über &amp;Qt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Rundgang</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>&amp;Was ist das?</translation>
    </message>
    <message>
        <source>Click anything to see what it does</source>
        <translation>Klicken Sie irgendwohin, um zu lesen, wozu es dient</translation>
    </message>
    <message>
        <source>Recovery Unavailable</source>
        <translation>Wiederherstellung nicht möglich</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Systeme &amp;ohne Attraktor erlauben</translation>
    </message>
    <message>
        <source>Let a drag of maps continue where an attractor is no longer guaranteed</source>
        <translation>Abbildungen auch dorthin ziehen lassen, wo ein Attraktor nicht mehr gesichert ist</translation>
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
        <source>Show each map as its image of the cage, and drag it by its corners</source>
        <translation>Jede Abbildung als ihr Bild des Käfigs zeigen und an ihren Ecken ziehen</translation>
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
        <source>Click a point of the attractor and drag the branch that contains it</source>
        <translation>Auf einen Punkt des Attraktors klicken und den Ast ziehen, zu dem er gehört</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Your unsaved work was recovered nevertheless.</source>
        <translation>Die ungespeicherte Arbeit ist trotzdem hier.</translation>
    </message>
    <message>
        <source>%1 was not recovered. Barycage will offer it again at the next start.</source>
        <translation>%1 wurde nicht wiederhergestellt. Beim nächsten Start wird es erneut angeboten.</translation>
    </message>
    <message>
        <source>Press Esc to bring back the menus and panels.</source>
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
        <source>Show only the canvas in full screen, for example on a projector; press Esc to return</source>
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
    <message>
        <source>Ca&amp;mera</source>
        <translation>Ka&amp;mera</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Vorne</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Rechts</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Links</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Oben</translation>
    </message>
    <message>
        <source>Look down (7 on the keypad)</source>
        <translation>Nach unten sehen (7 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>&amp;Unten</translation>
    </message>
    <message>
        <source>Look up (Ctrl+7 on the keypad)</source>
        <translation>Nach oben sehen (Strg+7 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isometrisch</translation>
    </message>
    <message>
        <source>Look from a corner (Home)</source>
        <translation>Von einer Ecke aus sehen (Pos1)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>In the menu %1.</source>
        <translation>Im Menü „%1“.</translation>
    </message>
    <message>
        <source>Shortcut: %1</source>
        <translation>Tastenkürzel: %1</translation>
    </message>
    <message>
        <source>Tool Options</source>
        <translation>Werkzeugoptionen</translation>
    </message>
    <message>
        <source>Show the options of the tool under the canvas</source>
        <translation>Die Optionen des Werkzeugs unter der Zeichenfläche zeigen</translation>
    </message>
    <message>
        <source>A bar with the options of the current tool, or a reminder of how to use it.</source>
        <translation>Eine Leiste mit den Optionen des aktuellen Werkzeugs oder einem Hinweis, wie es benutzt wird.</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>Abbi&amp;ldungen</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>&amp;Waagrecht spiegeln</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the vertical line through their centre</source>
        <translation>Die gewählten Abbildungen an der Senkrechten durch ihren Mittelpunkt spiegeln</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>&amp;Senkrecht spiegeln</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the horizontal line through their centre</source>
        <translation>Die gewählten Abbildungen an der Waagrechten durch ihren Mittelpunkt spiegeln</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Left</source>
        <translation>Um 90° nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Rotate the selected maps counter-clockwise about their centre</source>
        <translation>Die gewählten Abbildungen gegen den Uhrzeigersinn um ihren Mittelpunkt drehen</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Right</source>
        <translation>Um 90° nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Rotate the selected maps clockwise about their centre</source>
        <translation>Die gewählten Abbildungen im Uhrzeigersinn um ihren Mittelpunkt drehen</translation>
    </message>
    <message>
        <source>Ali&amp;gn Centres</source>
        <translation>Mittelpunkte a&amp;usrichten</translation>
    </message>
    <message>
        <source>In a &amp;Row</source>
        <translation>In einer &amp;Zeile</translation>
    </message>
    <message>
        <source>Move the selected maps up or down until their centres are at the same height</source>
        <translation>Die gewählten Abbildungen nach oben oder unten schieben, bis ihre Mittelpunkte auf gleicher Höhe liegen</translation>
    </message>
    <message>
        <source>In a &amp;Column</source>
        <translation>In einer &amp;Spalte</translation>
    </message>
    <message>
        <source>Move the selected maps left or right until their centres are one below the other</source>
        <translation>Die gewählten Abbildungen nach links oder rechts schieben, bis ihre Mittelpunkte untereinander liegen</translation>
    </message>
    <message>
        <source>D&amp;istribute Centres</source>
        <translation>Mittelpunkte &amp;verteilen</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Waagrecht</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from left to right</source>
        <translation>Die Mittelpunkte der gewählten Abbildungen von links nach rechts gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>&amp;Senkrecht</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from bottom to top</source>
        <translation>Die Mittelpunkte der gewählten Abbildungen von unten nach oben gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>&amp;Fit to Corners</source>
        <translation>An die &amp;Ecken setzen</translation>
    </message>
    <message>
        <source>Move each selected map so that it leaves the nearest corner of the cage fixed</source>
        <translation>Jede gewählte Abbildung verschieben, bis sie die nächste Ecke des Käfigs auf sich selbst abbildet</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Erst eine Abbildung wählen.</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Die gewählten Abbildungen duplizieren</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Die gewählten Abbildungen löschen</translation>
    </message>
    <message>
        <source>Select all maps</source>
        <translation>Alle Abbildungen auswählen</translation>
    </message>
    <message>
        <source>&amp;Duplicate Maps</source>
        <translation>Abbildungen &amp;duplizieren</translation>
    </message>
    <message>
        <source>D&amp;elete Maps</source>
        <translation>Abbildungen lös&amp;chen</translation>
    </message>
    <message>
        <source>Select &amp;All Maps</source>
        <translation>&amp;Alle Abbildungen auswählen</translation>
    </message>
    <message>
        <source>Missing on disk</source>
        <translation>Auf der Platte nicht mehr da</translation>
    </message>
    <message>
        <source>“%1” has been deleted, renamed or moved since you opened it.</source>
        <translation>„%1“ wurde gelöscht, umbenannt oder verschoben, seit Sie es geöffnet haben.</translation>
    </message>
    <message>
        <source>Saving creates it again in its old location.</source>
        <translation>Speichern legt es am alten Ort wieder an.</translation>
    </message>
    <message>
        <source>Other names of the file (hard links) keep the old contents.</source>
        <translation>Andere Namen der Datei (harte Links) behalten den alten Inhalt.</translation>
    </message>
    <message>
        <source>&amp;Lift to Space</source>
        <translation>In den Raum he&amp;ben</translation>
    </message>
    <message>
        <source>Lift to Space</source>
        <translation>In den Raum heben</translation>
    </message>
    <message>
        <source>&amp;Flatten to the Plane</source>
        <translation>In die Ebene drüc&amp;ken</translation>
    </message>
    <message>
        <source>Flatten to the Plane</source>
        <translation>In die Ebene drücken</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen, or a solid as a mesh for 3D printing</source>
        <translation>Exportiert das Bild als PNG, SVG oder PDF im Ausschnitt des Bildschirms; einen Körper auch zum Drucken</translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation>A&amp;nimation</translation>
    </message>
    <message>
        <source>A&amp;nimate</source>
        <translation>A&amp;nimieren</translation>
    </message>
    <message>
        <source>Show the timeline under the canvas</source>
        <translation>Die Zeitleiste unter der Zeichenfläche zeigen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play or stop the animation (Space on the canvas)</source>
        <translation>Die Animation abspielen oder anhalten (Leertaste auf der Zeichenfläche)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>P&amp;revious Frame</source>
        <translation>&amp;Voriges Bild</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Move the playhead back one frame</source>
        <translation>Den Abspielkopf ein Bild zurücksetzen</translation>
    </message>
    <message>
        <source>Ne&amp;xt Frame</source>
        <translation>Nächstes &amp;Bild</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Move the playhead forward one frame</source>
        <translation>Den Abspielkopf ein Bild weitersetzen</translation>
    </message>
    <message>
        <source>Pre&amp;vious Key</source>
        <translation>V&amp;origer Schlüssel</translation>
    </message>
    <message>
        <source>Alt+,</source>
        <translation>Alt+,</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Den Abspielkopf zum Schlüssel davor bewegen</translation>
    </message>
    <message>
        <source>Nex&amp;t Key</source>
        <translation>Nä&amp;chster Schlüssel</translation>
    </message>
    <message>
        <source>Alt+.</source>
        <translation>Alt+.</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Den Abspielkopf zum nächsten Schlüssel bewegen</translation>
    </message>
    <message>
        <source>Set &amp;Key</source>
        <translation>&amp;Schlüssel setzen</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Key the current track at the playhead</source>
        <translation>Einen Schlüssel der gewählten Spur am Abspielkopf setzen</translation>
    </message>
    <message>
        <source>Set Keys of &amp;All Tracks</source>
        <translation>Schlüssel aller Sp&amp;uren setzen</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Key all tracks that have keys at the playhead, or all tracks if none has</source>
        <translation>Schlüssel aller Spuren, die schon welche haben, am Abspielkopf setzen, oder aller Spuren, wenn keine welche hat</translation>
    </message>
    <message>
        <source>&amp;Delete Keys</source>
        <translation>Schlüssel &amp;löschen</translation>
    </message>
    <message>
        <source>Delete the selected keys</source>
        <translation>Die gewählten Schlüssel löschen</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Fractal &amp;Transformation</source>
        <translation>Fraktale &amp;Transformation</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Show another entry beside this one, and colour this one by a picture placed on the other</source>
        <translation>Einen anderen Eintrag daneben zeigen und diesen mit einem Bild darauf färben</translation>
    </message>
    <message>
        <source>Export Ani&amp;mation…</source>
        <translation>Ani&amp;mation exportieren …</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Export the animation as a video, an animated image or frames, on this computer or on a cluster</source>
        <translation>Die Animation als Video, bewegtes Bild oder Einzelbilder exportieren, hier oder auf einem Cluster</translation>
    </message>
    <message>
        <source>Nothing moves in this entry yet. Choose a motion in the timeline first: Animation, Animate.</source>
        <translation>In diesem Eintrag bewegt sich noch nichts. Wählen Sie zuerst eine Bewegung in der Zeitleiste: Animation, Animieren.</translation>
    </message>
    <message>
        <source>A mesh needs a solid, and this entry lies in a plane: lift it to space first.</source>
        <translation>Ein Körper zum Drucken braucht den Raum, und dieser Eintrag liegt in der Ebene: Heben Sie ihn zuerst in den Raum.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen…</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verknüpfungen</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Collage</translation>
    </message>
    <message>
        <source>Four &amp;Views</source>
        <translation>&amp;Vier Ansichten</translation>
    </message>
    <message>
        <source>Define the control triangle with three clicks, or in space the tetrahedron with four</source>
        <translation>Legt das Kontrolldreieck mit drei Klicks fest, im Raum das Tetraeder mit vier</translation>
    </message>
    <message>
        <source>Look from the front (1 on the keypad)</source>
        <translation>Von vorn blicken (1 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>Look from behind (Ctrl+1 on the keypad)</source>
        <translation>Von hinten blicken (Strg+1 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>Look from the right (3 on the keypad)</source>
        <translation>Von rechts blicken (3 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>Look from the left (Ctrl+3 on the keypad)</source>
        <translation>Von links blicken (Strg+3 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>&amp;Z Up</source>
        <translation>&amp;Z nach oben</translation>
    </message>
    <message>
        <source>Point the z axis up, as in CAD programs; the fractal stays as it is</source>
        <translation>Die z-Achse zeigt nach oben wie in CAD-Programmen; das Fraktal bleibt, wie es ist</translation>
    </message>
    <message>
        <source>De&amp;fine Tetrahedron</source>
        <translation>Tetraeder &amp;festlegen</translation>
    </message>
    <message>
        <source>Select maps or entries first: in their panels, or on the canvas with the Maps tool.</source>
        <translation>Erst Abbildungen oder Einträge wählen: in ihren Feldern, oder Abbildungen auf der Zeichenfläche mit ihrem Werkzeug.</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>A&amp;usschneiden</translation>
    </message>
    <message>
        <source>Move the selected maps or entries to the clipboard</source>
        <translation>Die gewählten Abbildungen oder Einträge in die Zwischenablage verschieben</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Add fractals from the clipboard to the file: entries of an .ifs file, flames or a table of numbers; or maps to the fractal</source>
        <translation>Fraktale aus der Zwischenablage zur Datei hinzufügen: Einträge einer .ifs-Datei, Flames oder eine Zahlentabelle; oder Abbildungen zum Fraktal</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate the selected maps or entries</source>
        <translation>Die gewählten Abbildungen oder Einträge duplizieren</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the selected maps or entries</source>
        <translation>Die gewählten Abbildungen oder Einträge löschen</translation>
    </message>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Select all maps or all entries</source>
        <translation>Alle Abbildungen oder alle Einträge auswählen</translation>
    </message>
    <message>
        <source>Breed variations of this fractal, or cross it with another one</source>
        <translation>Abwandlungen dieses Fraktals züchten oder es mit einem anderen kreuzen</translation>
    </message>
    <message>
        <source>The Chaos Game</source>
        <translation>Das Chaosspiel</translation>
    </message>
    <message>
        <source>Why the Maple Fits Its Triangle</source>
        <translation>Warum der Ahorn in sein Dreieck passt</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Lektion</translation>
    </message>
    <message>
        <source>&amp;Play Lesson</source>
        <translation>Lektion &amp;abspielen</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>&amp;Nächster Schritt</translation>
    </message>
    <message>
        <source>Show the next step of the lesson being played</source>
        <translation>Den nächsten Schritt der Lektion zeigen, die läuft</translation>
    </message>
    <message>
        <source>Previous &amp;Step</source>
        <translation>&amp;Voriger Schritt</translation>
    </message>
    <message>
        <source>Show the previous step of the lesson being played</source>
        <translation>Den vorigen Schritt der Lektion zeigen, die läuft</translation>
    </message>
    <message>
        <source>&amp;Add Step</source>
        <translation>Schritt &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Add a step to the lesson, with the current state of the window</source>
        <translation>Der Lektion einen Schritt mit dem jetzigen Zustand des Fensters hinzufügen</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>Lektion &amp;speichern…</translation>
    </message>
    <message>
        <source>The step now has the current state of the window.</source>
        <translation>Der Schritt hat nun den Zustand des Fensters.</translation>
    </message>
    <message>
        <source>End the lesson before you save (Esc).</source>
        <translation>Beenden Sie vor dem Speichern die Lektion (Esc).</translation>
    </message>
    <message>
        <source>Play this lesson, in a window of its own if this one is in use</source>
        <translation>Diese Lektion abspielen, in einem eigenen Fenster, falls dieses benutzt wird</translation>
    </message>
    <message>
        <source>Unsaved lesson</source>
        <translation>Nicht gespeicherte Lektion</translation>
    </message>
    <message>
        <source>The lesson “%1” has unsaved changes.</source>
        <translation>Die Lektion „%1“ hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>The lesson was not saved</source>
        <translation>Die Lektion wurde nicht gespeichert</translation>
    </message>
    <message>
        <source>Lessons (*.lesson)</source>
        <translation>Lektionen (*.lesson)</translation>
    </message>
    <message>
        <source>The fractals have unsaved changes.</source>
        <translation>Die Fraktale haben ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Step %1 has the current state of the window. Now write its text.</source>
        <translation>Schritt %1 hat den Zustand des Fensters. Schreiben Sie seinen Text.</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Schnappschüsse</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exporte</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>&amp;Ready-Made Lessons</source>
        <translation>&amp;Fertige Lektionen</translation>
    </message>
    <message>
        <source>Re&amp;name Map</source>
        <translation>Abbildung &amp;umbenennen</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Der aktuellen Abbildung einen Namen geben</translation>
    </message>
    <message>
        <source>Loc&amp;k or Unlock Maps</source>
        <translation>Abbildungen sperren oder &amp;freigeben</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing, or unlock them</source>
        <translation>Die gewählten Abbildungen vor Änderungen schützen oder wieder freigeben</translation>
    </message>
    <message>
        <source>Show Map Al&amp;one</source>
        <translation>Abbildung alle&amp;in zeigen</translation>
    </message>
    <message>
        <source>Show the current map alone, or all of them again</source>
        <translation>Die aktuelle Abbildung allein zeigen, oder wieder alle</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>Ge&amp;speicherte Ansichten</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>Ansicht &amp;speichern…</translation>
    </message>
    <message>
        <source>Keep what the canvas shows under a name, with the fractal</source>
        <translation>Was die Zeichenfläche zeigt, unter einem Namen mit dem Fraktal aufbewahren</translation>
    </message>
    <message>
        <source>&amp;Edit Views…</source>
        <translation>Ansichten &amp;bearbeiten…</translation>
    </message>
    <message>
        <source>Go to saved views, rename or delete them</source>
        <translation>Zu gespeicherten Ansichten gehen, sie umbenennen oder löschen</translation>
    </message>
    <message>
        <source>No saved views</source>
        <translation>Keine gespeicherten Ansichten</translation>
    </message>
    <message>
        <source>Views that you save are listed here.</source>
        <translation>Hier stehen die Ansichten, die Sie speichern.</translation>
    </message>
    <message>
        <source>Show this part of the fractal again</source>
        <translation>Diesen Teil des Fraktals wieder zeigen</translation>
    </message>
    <message>
        <source>Save the view “%1”</source>
        <translation>Die Ansicht „%1“ speichern</translation>
    </message>
    <message>
        <source>Print &amp;Handout…</source>
        <translation>&amp;Handout drucken…</translation>
    </message>
    <message>
        <source>Print entries for a class: pictures with cage, maps and formulas, or a blank worksheet</source>
        <translation>Einträge für den Unterricht drucken: Bilder mit Käfig, Abbildungen und Formeln, oder ein leeres Aufgabenblatt</translation>
    </message>
    <message>
        <source>Copy as La&amp;TeX</source>
        <translation>Als &amp;LaTeX kopieren</translation>
    </message>
    <message>
        <source>&amp;Table of Maps</source>
        <translation>&amp;Tabelle der Abbildungen</translation>
    </message>
    <message>
        <source>Copy the coefficients as a tabular</source>
        <translation>Die Koeffizienten als tabular kopieren</translation>
    </message>
    <message>
        <source>&amp;Formulas with Matrices</source>
        <translation>&amp;Formeln mit Matrizen</translation>
    </message>
    <message>
        <source>Copy each map as a matrix and a vector</source>
        <translation>Jede Abbildung als Matrix und Vektor kopieren</translation>
    </message>
    <message>
        <source>&amp;Affine Invariant Form</source>
        <translation>&amp;Affin invariante Form</translation>
    </message>
    <message>
        <source>Copy one matrix per map, in barycentric coordinates of the triangle</source>
        <translation>Je Abbildung eine Matrix in baryzentrischen Koordinaten des Dreiecks kopieren</translation>
    </message>
    <message>
        <source>Fi&amp;gure (TikZ)</source>
        <translation>Fi&amp;gur (TikZ)</translation>
    </message>
    <message>
        <source>Copy the cage and its images under the maps, with numbers and fixed points, as shown on the canvas</source>
        <translation>Den Käfig und seine Bilder unter den Abbildungen mit Nummern und Fixpunkten kopieren, wie sie zu sehen sind</translation>
    </message>
    <message>
        <source>Copied. The document needs %1.</source>
        <translation>Kopiert. Das Dokument braucht %1.</translation>
    </message>
    <message>
        <source>Map numbers</source>
        <translation>Nummern</translation>
    </message>
    <message>
        <source>&amp;Numbers of Maps</source>
        <translation>N&amp;ummern der Abbildungen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Show the number and the fixed point of each map</source>
        <translation>Die Nummer und den Fixpunkt jeder Abbildung zeigen</translation>
    </message>
    <message>
        <source>Rotate View &amp;Left</source>
        <translation>Ansicht nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate the view counter-clockwise by 15°</source>
        <translation>Den Inhalt der Zeichenfläche um 15° gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Rotate View &amp;Right</source>
        <translation>Ansicht nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>Rotate the view clockwise by 15°</source>
        <translation>Den Inhalt der Zeichenfläche um 15° im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Re&amp;set Rotation</source>
        <translation>Drehung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Return the view to upright</source>
        <translation>Die Ansicht wieder aufrichten</translation>
    </message>
    <message>
        <source>Side &amp;by Side</source>
        <translation>Ne&amp;beneinander</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Show another entry beside this one, to compare and edit both</source>
        <translation>Einen anderen Eintrag daneben zeigen, um beide zu vergleichen und zu bearbeiten</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Kopiert.</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Suchen …</translation>
    </message>
    <message>
        <source>Find “%1”</source>
        <translation>„%1“ suchen</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs *.par)</source>
        <translation>Fractint-Sammlungen (*.ifs *.par)</translation>
    </message>
    <message>
        <source>The lesson now refers to %1. Save the lesson to keep this change.</source>
        <translation>Die Lektion gehört jetzt zu %1. Speichern Sie die Lektion, damit es so bleibt.</translation>
    </message>
    <message>
        <source>The fractal transformation was hidden to show how the attractor is built.</source>
        <translation>Die fraktale Transformation wurde ausgeblendet, um zu zeigen, wie der Attraktor entsteht.</translation>
    </message>
    <message>
        <source>Add a third dimension to every map; the picture stays flat until you move a map</source>
        <translation>Gibt jeder Abbildung eine dritte Dimension; das Bild bleibt flach, bis Sie eine Abbildung bewegen</translation>
    </message>
    <message>
        <source>Replace the solid by its projection along the first axis that every map keeps</source>
        <translation>Ersetzt den Körper durch seine Projektion längs der ersten Achse, die jede Abbildung beibehält</translation>
    </message>
    <message>
        <source>Plays this lesson in full screen, with its text next to the picture. Page Down and Page Up go to the next and the previous step. Esc ends the lesson.</source>
        <translation>Spielt diese Lektion im Vollbild ab, mit ihrem Text neben dem Bild. Bild ab und Bild auf führen zum nächsten und zum vorigen Schritt. Esc beendet die Lektion.</translation>
    </message>
    <message>
        <source>Make distant parts look smaller (5 on the keypad)</source>
        <translation>Entfernte Teile kleiner zeigen (5 auf dem Ziffernblock)</translation>
    </message>
    <message>
        <source>Snapshots are not saved with the file and will be lost: %1. To keep one, cancel and choose Add as Entry in the Snapshots panel.</source>
        <translation>Schnappschüsse werden nicht mit der Datei gespeichert und gehen verloren: %1. Um einen zu behalten, brechen Sie ab und wählen Sie im Feld „Schnappschüsse“ „Als Eintrag hinzufügen“.</translation>
    </message>
    <message>
        <source>The target in the Collage panel is not saved with the file.</source>
        <translation>Das Ziel im Feld „Collage“ wird nicht mit der Datei gespeichert.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Die Lektion auf dem ganzen Bildschirm abspielen, von Anfang an oder ab dem Schritt, den Sie in der Liste angeklickt haben</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>The lesson has unsaved changes.</source>
        <translation>Die Lektion hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Die Lektion als Text speichern, der auf ihre Fraktale verweist</translation>
    </message>
    <message>
        <source>Sa&amp;ve Lesson As…</source>
        <translation>Lektion speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the lesson under another name or in another folder</source>
        <translation>Die Lektion unter einem anderen Namen oder in einem anderen Ordner speichern</translation>
    </message>
    <message>
        <source>The lesson names no file of fractals (“file: name.ifs”).</source>
        <translation>Die Lektion nennt keine Datei mit Fraktalen („file: name.ifs“).</translation>
    </message>
    <message>
        <source>The file of its fractals, “%1”, was not found. It may have been renamed or moved.</source>
        <translation>Die Datei mit ihren Fraktalen, „%1“, wurde nicht gefunden. Vielleicht wurde sie umbenannt oder verschoben.</translation>
    </message>
    <message>
        <source>Save Lesson</source>
        <translation>Lektion speichern</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. Save the fractals as a .ifs file first, with no : * ? &quot; &lt; &gt; | in its name and folders.</source>
        <translation>Eine Lektion kann nicht auf „%1“ verweisen. Speichern Sie die Fraktale zuerst als Datei .ifs, deren Name und Ordner kein : * ? &quot; &lt; &gt; | enthalten.</translation>
    </message>
    <message>
        <source>If you discard the changes, the snapshots of them will be lost, too: %1.</source>
        <translation>Wenn Sie die Änderungen verwerfen, gehen auch ihre Schnappschüsse verloren: %1.</translation>
    </message>
    <message>
        <source>Unsaved snapshots</source>
        <translation>Nicht gespeicherte Schnappschüsse</translation>
    </message>
    <message>
        <source>“%1” has snapshots that are not saved.</source>
        <translation>„%1“ hat Schnappschüsse, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Revert to “%1” as it is on disk?</source>
        <translation>Zu „%1“ zurückkehren, wie es auf der Platte ist?</translation>
    </message>
    <message>
        <source>Replace the view “%1”</source>
        <translation>Die Ansicht „%1“ ersetzen</translation>
    </message>
    <message>
        <source>Drag the corners of the cage</source>
        <translation>Die Ecken des Käfigs ziehen</translation>
    </message>
    <message>
        <source>Show the solid from the top, the front and the right, and in perspective</source>
        <translation>Den Körper von oben, von vorne, von rechts und perspektivisch zeigen</translation>
    </message>
    <message>
        <source>%1 names a file outside its folder.</source>
        <translation>%1 nennt eine Datei außerhalb ihres Ordners.</translation>
    </message>
    <message>
        <source>Its fractals are in “%1”. Open that file only if you trust the lesson.</source>
        <translation>Ihre Fraktale sind in „%1“. Diese Datei nur öffnen, wenn Sie der Lektion vertrauen.</translation>
    </message>
    <message>
        <source>&amp;Open It</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>Save a Copy for Other Programs</source>
        <translation>Kopie für andere Programme speichern</translation>
    </message>
    <message>
        <source>A copy needs another name than the file itself.</source>
        <translation>Eine Kopie braucht einen anderen Namen als die Datei selbst.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>„%1“ wird gespeichert …</translation>
    </message>
    <message>
        <source>Saved the copy %1.</source>
        <translation>Die Kopie %1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Other programs still draw these entries differently: %1.</source>
        <translation>Andere Programme zeichnen diese Einträge weiterhin anders: %1.</translation>
    </message>
    <message>
        <source>Save a Copy &amp;for Other Programs…</source>
        <translation>Kop&amp;ie für andere Programme speichern…</translation>
    </message>
    <message>
        <source>Save a copy with the placements written into the code and every map listed, so that other programs draw what you see</source>
        <translation>Eine Kopie speichern, in deren Code jede Lage eingerechnet und jede Abbildung aufgeführt ist, damit andere Programme zeichnen, was Sie sehen</translation>
    </message>
    <message>
        <source>The previous version is %1.</source>
        <translation>Die vorige Fassung ist %1.</translation>
    </message>
    <message>
        <source>The previous version was not kept: there is already a file %1 that Barycage did not make.</source>
        <translation>Die vorige Fassung wurde nicht aufbewahrt: Es gibt schon eine Datei %1, die nicht von Barycage stammt.</translation>
    </message>
    <message>
        <source>The previous version could not be kept as %1.</source>
        <translation>Die vorige Fassung konnte nicht als %1 aufbewahrt werden.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n files?</source>
        <translation>
            <numerusform>%n Datei öffnen?</numerusform>
            <numerusform>%n Dateien öffnen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Each of them opens in a window of its own.</source>
        <translation>Jede öffnet sich in einem eigenen Fenster.</translation>
    </message>
    <message>
        <source>Open &amp;All</source>
        <translation>&amp;Alle öffnen</translation>
    </message>
    <message>
        <source>Open the &amp;First %1</source>
        <translation>Die &amp;ersten %1 öffnen</translation>
    </message>
    <message>
        <source>Opening files…</source>
        <translation>Dateien werden geöffnet…</translation>
    </message>
    <message>
        <source>%1 is also open in another window of Barycage. Whichever saves last replaces what the other saved.</source>
        <translation>%1 ist auch in einem anderen Barycage-Fenster offen. Wer zuletzt speichert, ersetzt, was im anderen gespeichert wurde.</translation>
    </message>
    <message>
        <source>Export Web Page</source>
        <translation>Webseite exportieren</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>%1 was written. Open it in a browser, or mail it: it needs no network.</source>
        <translation>%1 wurde geschrieben. Öffnen Sie die Seite in einem Browser, oder verschicken Sie sie: Sie braucht kein Netz.</translation>
    </message>
    <message>
        <source>Stretch Ke&amp;ys…</source>
        <translation>Schlüssel &amp;dehnen…</translation>
    </message>
    <message>
        <source>Make a range of frames slower or faster: the keys of all tracks spread</source>
        <translation>Macht einen Bereich langsamer oder schneller: die Schlüssel aller Spuren verteilen sich neu</translation>
    </message>
    <message>
        <source>There are no keys to stretch. Choose Set Key first.</source>
        <translation>Es gibt keine Schlüssel zum Dehnen. Setzen Sie zuerst einen.</translation>
    </message>
    <message>
        <source>Copy the picture, the selected maps or the selected entries</source>
        <translation>Kopiert das Bild, die gewählten Abbildungen oder die gewählten Einträge</translation>
    </message>
    <message>
        <source>Export We&amp;b Page…</source>
        <translation>We&amp;bseite exportieren…</translation>
    </message>
    <message>
        <source>Export the fractal in its cage as one file for browsers, in which it can be dragged</source>
        <translation>Das Fraktal in seinem Käfig als eine Datei für Browser exportieren, in denen man daran ziehen kann</translation>
    </message>
    <message>
        <source>Six short steps that you do yourself: drag, squeeze, undo, collection, wind, export</source>
        <translation>Sechs kurze Schritte, die Sie selbst tun: ziehen, quetschen, rückgängig machen, Sammlung, Wind, Export</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Show a centre and height, the point of an address, or a fixed point</source>
        <translation>Zeigt eine Mitte und Höhe, den Punkt einer Adresse oder einen Fixpunkt</translation>
    </message>
    <message>
        <source>Language, theme, picture quality, shortcuts, and what opens at startup</source>
        <translation>Sprache, Farben, Bildqualität, Tastenkürzel und was beim Start geöffnet wird</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>A&amp;bwandlungen…</translation>
    </message>
    <message>
        <source>S&amp;hadow</source>
        <translation>S&amp;chatten</translation>
    </message>
    <message>
        <source>Lay a flat, dark copy of the picture on the ground behind it</source>
        <translation>Eine flache, dunkle Kopie des Bildes hinter ihm auf den Boden legen</translation>
    </message>
    <message>
        <source>Add a shadow</source>
        <translation>Schatten hinzufügen</translation>
    </message>
    <message>
        <source>Remove the shadow</source>
        <translation>Schatten entfernen</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animieren</translation>
    </message>
    <message>
        <source>&amp;Keys and Frames</source>
        <translation>&amp;Schlüssel und Bilder</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ast</translation>
    </message>
    <message>
        <source>M&amp;ore</source>
        <translation>&amp;Mehr</translation>
    </message>
    <message>
        <source>D&amp;iscover</source>
        <translation>&amp;Entdecken</translation>
    </message>
    <message>
        <source>&amp;Collection</source>
        <translation>&amp;Sammlung</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Search the fractals that come with the program, and your favourites</source>
        <translation>Die mitgelieferten Fraktale und Ihre Favoriten durchsuchen</translation>
    </message>
    <message>
        <source>S&amp;napshots</source>
        <translation>Sch&amp;nappschüsse</translation>
    </message>
    <message>
        <source>&amp;Fractal</source>
        <translation>&amp;Fraktal</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>&amp;Selected Maps</source>
        <translation>Aus&amp;gewählte Abbildungen</translation>
    </message>
    <message>
        <source>&amp;Teach</source>
        <translation>&amp;Unterrichten</translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation>&amp;Navigieren</translation>
    </message>
    <message>
        <source>&amp;Go To…</source>
        <translation>&amp;Gehe zu…</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Zeichenfläche</translation>
    </message>
    <message>
        <source>How It Is &amp;Built</source>
        <translation>&amp;Wie er entsteht</translation>
    </message>
    <message>
        <source>Web page written</source>
        <translation>Webseite geschrieben</translation>
    </message>
    <message>
        <source>Copy &amp;Link</source>
        <translation>Li&amp;nk kopieren</translation>
    </message>
    <message>
        <source>Copy a link that holds the fractal: Barycage opens it when it is pasted</source>
        <translation>Einen Link kopieren, der das Fraktal enthält: Barycage öffnet ihn, wenn er eingefügt wird</translation>
    </message>
    <message>
        <source>The link was copied to the clipboard. It holds the whole fractal.</source>
        <translation>Der Link wurde in die Zwischenablage kopiert. Er enthält das ganze Fraktal.</translation>
    </message>
    <message>
        <source>Hidden in this small window: %1 (View › Panels).</source>
        <translation>In diesem kleinen Fenster ausgeblendet: %1 (Ansicht › Felder).</translation>
    </message>
    <message>
        <source>Pr&amp;int Lesson…</source>
        <translation>Lektion &amp;drucken…</translation>
    </message>
    <message>
        <source>Print the steps of the lesson, with their pictures and texts</source>
        <translation>Die Schritte der Lektion mit Bildern und Texten drucken</translation>
    </message>
    <message>
        <source>Copy as &amp;Python</source>
        <translation>Als &amp;Python kopieren</translation>
    </message>
    <message>
        <source>Copy lines for a notebook that make the fractal with the Python package “barycage”</source>
        <translation>Zeilen für ein Notebook kopieren, die das Fraktal mit dem Python-Paket „barycage“ erzeugen</translation>
    </message>
    <message>
        <source>Files with fractals (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures with an embedded fractal (*.png *.svg);;Lessons (*.lesson);;All files (*)</source>
        <translation>Dateien mit Fraktalen (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Fractint-Sammlungen (*.ifs *.par);;Flames (*.flame *.flam3);;Zahlentabellen (*.csv *.tsv *.txt);;Bilder, die ihr Fraktal enthalten (*.png *.svg);;Lektionen (*.lesson);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The lesson is not saved yet: choose Save Lesson.</source>
        <translation>Die Lektion ist noch nicht gespeichert: Wählen Sie „Lektion speichern“.</translation>
    </message>
    <message>
        <source>laser plotter cutter engrave dxf outline millimetres millimeters</source>
        <translation>Laser Laserschnitt Plotter Schneideplotter gravieren schneiden Umriss Kontur Millimeter</translation>
    </message>
    <message>
        <source>Copy saved</source>
        <translation>Kopie gespeichert</translation>
    </message>
    <message>
        <source>%1 was saved for other programs.</source>
        <translation>%1 wurde für andere Programme gespeichert.</translation>
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
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>„%1“ ist eine zu große Zahl.</translation>
    </message>
    <message>
        <source>“%1” has no finite value.</source>
        <translation>„%1“ hat keinen endlichen Wert.</translation>
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
        <source>Saving “%1” was cancelled. The file on disk is unchanged.</source>
        <translation>Das Speichern von „%1“ wurde abgebrochen. Die Datei ist, wie sie war.</translation>
    </message>
    <message>
        <source>Adjust Picture Paths</source>
        <translation>Pfade der Bilder anpassen</translation>
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
    <message>
        <source>%1 Glow</source>
        <translation>Glühen in %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 nach %2</translation>
    </message>
    <message>
        <source>%1 into %2</source>
        <translation>%1 gegen %2</translation>
    </message>
    <message>
        <source>%1 Spectrum</source>
        <translation>Spektrum ab %1</translation>
    </message>
    <message>
        <source>%1 Pastel</source>
        <translation>Pastell %1</translation>
    </message>
    <message>
        <source>%1 Metal</source>
        <translation>Metall %1</translation>
    </message>
    <message>
        <source>%1 Bands</source>
        <translation>Bänder in %1</translation>
    </message>
    <message>
        <source>%1 Ink</source>
        <translation>Tinte %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 Twilight</source>
        <translation>Dämmerung %1</translation>
    </message>
    <message>
        <source>%1 Wheel</source>
        <translation>Farbkreis ab %1</translation>
    </message>
    <message>
        <source>Rose</source>
        <translation>Rose</translation>
    </message>
    <message>
        <source>Crimson</source>
        <translation>Karmesin</translation>
    </message>
    <message>
        <source>Scarlet</source>
        <translation>Scharlach</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Zinnober</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Bernstein</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>Gold</translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation>Zitrone</translation>
    </message>
    <message>
        <source>Lime</source>
        <translation>Limette</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>Gras</translation>
    </message>
    <message>
        <source>Emerald</source>
        <translation>Smaragd</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>Jade</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>Petrol</translation>
    </message>
    <message>
        <source>Sea</source>
        <translation>Meer</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Azure</source>
        <translation>Azur</translation>
    </message>
    <message>
        <source>Cobalt</source>
        <translation>Kobalt</translation>
    </message>
    <message>
        <source>Sapphire</source>
        <translation>Saphir</translation>
    </message>
    <message>
        <source>Indigo</source>
        <translation>Indigo</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violett</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Purpur</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Fuchsia</source>
        <translation>Fuchsie</translation>
    </message>
</context>
<context>
    <name>PlacementBanner</name>
    <message>
        <source>Saved with dragged corners</source>
        <translation>Mit gezogenen Ecken gespeichert</translation>
    </message>
    <message>
        <source>Other programs will show “%1” without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>Andere Programme zeigen „%1“ ohne Ihre gezogenen Ecken: Sie stehen nur in Kommentaren. Einrechnen schreibt sie in die Zahlen, die jedes Programm liest.</translation>
    </message>
    <message numerus="yes">
        <source>Other programs will show %n entries without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>
            <numerusform>Andere Programme zeigen %n Eintrag ohne Ihre gezogenen Ecken: Sie stehen nur in Kommentaren. Einrechnen schreibt sie in die Zahlen, die jedes Programm liest.</numerusform>
            <numerusform>Andere Programme zeigen %n Einträge ohne Ihre gezogenen Ecken: Sie stehen nur in Kommentaren. Einrechnen schreibt sie in die Zahlen, die jedes Programm liest.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Einrechnen</translation>
    </message>
    <message>
        <source>Writes the placements into the code, as one step of the history.</source>
        <translation>Schreibt die Lagen in den Code: ein Schritt im Verlauf.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Bake the placements into the code</source>
        <translation>Die Lagen in den Code einrechnen</translation>
    </message>
    <message>
        <source>Not baked, because no code has this picture or keys move it: %1.</source>
        <translation>Nicht eingerechnet, weil kein Code dieses Bild hat oder Schlüsselbilder es bewegen: %1.</translation>
    </message>
    <message>
        <source>This cage cannot be baked: it bends or flattens the picture, or keys move it.</source>
        <translation>Dieser Käfig lässt sich nicht einrechnen: Er verbiegt das Bild oder drückt es flach, oder Schlüssel bewegen ihn.</translation>
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
        <source>In the last session, Barycage ended before this work was saved:</source>
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
        <source>Unsaved work cannot be kept for recovery: the folder “%1” is not writable, or the disk is full. Save often.</source>
        <translation>Nicht gespeicherte Arbeit kann nicht zur Wiederherstellung aufbewahrt werden: In den Ordner „%1“ kann nicht geschrieben werden, oder der Datenträger ist voll. Speichern Sie oft.</translation>
    </message>
    <message>
        <source>The unsaved work from the last session is damaged and cannot be recovered. What remains of it is in:</source>
        <translation>Nicht gespeicherte Arbeit vom letzten Mal ist beschädigt und lässt sich nicht wiederherstellen. Was davon übrig ist, liegt in:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Nicht gespeicherte Arbeit wird gesucht …</translation>
    </message>
    <message numerus="yes">
        <source>(%n windows)</source>
        <translation>
            <numerusform>(%n Fenster)</numerusform>
            <numerusform>(%n Fenster)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SnapshotBanner</name>
    <message>
        <source>Snapshot on the canvas</source>
        <translation>Schnappschuss auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B: %1</translation>
    </message>
    <message>
        <source>Back to the Fractal</source>
        <translation>Zurück zum Fraktal</translation>
    </message>
    <message>
        <source>Shows the fractal again. Nothing has changed.</source>
        <translation>Zeigt wieder das Fraktal. Nichts hat sich geändert.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Restores the fractal to this snapshot, as one step of the history.</source>
        <translation>Macht das Fraktal so, wie es in diesem Schnappschuss war: ein Schritt im Verlauf.</translation>
    </message>
    <message>
        <source>The canvas shows “%1”.</source>
        <translation>Die Zeichenfläche zeigt „%1“.</translation>
    </message>
</context>
<context>
    <name>SnapshotCommands</name>
    <message>
        <source>Snapshots cannot be compared while a fractal transformation is shown.</source>
        <translation>Schnappschüsse lassen sich nicht vergleichen, während eine fraktale Transformation gezeigt wird.</translation>
    </message>
    <message>
        <source>Ta&amp;ke Snapshot</source>
        <translation>&amp;Schnappschuss aufnehmen</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Keep the current state of this fractal in the Snapshots panel</source>
        <translation>Den jetzigen Zustand dieses Fraktals im Feld „Schnappschüsse“ festhalten</translation>
    </message>
    <message>
        <source>C&amp;ompare with Snapshot</source>
        <translation>Mit Schnappschuss &amp;vergleichen</translation>
    </message>
    <message>
        <source>Q</source>
        <translation>Q</translation>
    </message>
    <message>
        <source>Kept as “%1”. To see it, choose View, Panels, Snapshots.</source>
        <translation>Als „%1“ festgehalten. „Ansicht“, „Felder“, „Schnappschüsse“ zeigt ihn.</translation>
    </message>
    <message>
        <source>Show the snapshot selected in the Snapshots panel, or the newest one, in place of the fractal; to return, press the key again, or hold it and release it</source>
        <translation>Anstelle des Fraktals den Schnappschuss zeigen, der im Feld „Schnappschüsse“ ausgewählt ist, oder den neuesten; drücken Sie noch einmal, oder halten Sie die Taste und lassen los, um zurückzukehren</translation>
    </message>
    <message>
        <source>Snapshots can be compared only while the density is shown. Choose Density in the bar under the canvas first.</source>
        <translation>Schnappschüsse lassen sich nur vergleichen, solange die Dichte gezeigt wird. Wählen Sie zuerst „Dichte“ in der Leiste unter der Zeichenfläche.</translation>
    </message>
</context>
<context>
    <name>SpaceBranch</name>
    <message>
        <source>No branch can be selected here: the address of this point is not known.</source>
        <translation>Hier lässt sich kein Ast wählen: Die Adresse dieses Punktes ist nicht bekannt.</translation>
    </message>
    <message>
        <source>A branch cannot be dragged while it or the cage is flat.</source>
        <translation>Ein Ast lässt sich nicht ziehen, solange er oder der Käfig flach ist.</translation>
    </message>
</context>
<context>
    <name>SpaceDefinition</name>
    <message>
        <source>Click the first of the four corners. The picture stays where it is; Esc cancels.</source>
        <translation>Klicken Sie die erste der vier Ecken. Das Bild bleibt, wo es ist; Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Klicken Sie die zweite Ecke. Rücktaste entfernt den letzten Punkt.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Klicken Sie die dritte Ecke. Rücktaste entfernt den letzten Punkt.</translation>
    </message>
    <message>
        <source>Click the fourth corner, in front of the other three. The wheel pushes it away, and the right button turns the view.</source>
        <translation>Klicken Sie die vierte Ecke, vor den anderen drei. Das Rad schiebt sie weg, und die rechte Taste dreht die Ansicht.</translation>
    </message>
</context>
<context>
    <name>SpaceMapDrag</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Angehalten: Darüber hinaus würde der Ast in sich selbst nicht kleiner.</translation>
    </message>
</context>
<context>
    <name>SpaceMaps</name>
    <message>
        <source>Maps cannot be dragged while the cage is flat. First open or reset the cage.</source>
        <translation>Abbildungen lassen sich nicht ziehen, solange der Käfig flach ist. Öffnen Sie ihn erst oder setzen Sie ihn zurück.</translation>
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
        <source>Pointer position</source>
        <translation>Ort des Zeigers</translation>
    </message>
    <message>
        <source>Existence of an attractor</source>
        <translation>Existenz eines Attraktors</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and its contraction factor</source>
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
        <source>Plane and barycentric coordinates of the pointer; the address of the point of the attractor under it, outermost map first, and the fixed point of its branch</source>
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
        <source>latest changes not yet kept for recovery</source>
        <translation>letzte Änderungen noch nicht zur Wiederherstellung aufbewahrt</translation>
    </message>
    <message>
        <source>A crash would lose your latest changes: keeping them takes longer than two seconds, because the disk is slow or full or the file is very large. Save what you do not want to lose.</source>
        <translation>Bei einem Absturz gingen Ihre letzten Änderungen verloren: Sie aufzubewahren dauert länger als zwei Sekunden, weil der Datenträger langsam oder voll oder die Datei sehr groß ist. Speichern Sie, was nicht verloren gehen darf.</translation>
    </message>
    <message>
        <source>  depth %1</source>
        <translation>  Tiefe %1</translation>
    </message>
    <message>
        <source>  along %1</source>
        <translation>  entlang %1</translation>
    </message>
    <message>
        <source>  across %1</source>
        <translation>  quer zu %1</translation>
    </message>
    <message>
        <source>  along the normal</source>
        <translation>  entlang der Normalen</translation>
    </message>
    <message>
        <source>  azimuth %1°  elevation %2°</source>
        <translation>  Azimut %1°  Höhe %2°</translation>
    </message>
    <message>
        <source>Rotation of the view</source>
        <translation>Drehung der Ansicht</translation>
    </message>
    <message>
        <source>How far the view is turned, counter-clockwise; choose View, Rotate View, Reset Rotation to return it to upright</source>
        <translation>Wie weit die Ansicht gegen den Uhrzeigersinn gedreht ist; Ansicht, Ansicht drehen, Drehung zurücksetzen richtet sie wieder auf</translation>
    </message>
    <message>
        <source>rotated %1°</source>
        <translation>gedreht um %1°</translation>
    </message>
    <message>
        <source>attractor: %1</source>
        <translation>Attraktor: %1</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>Das System im Bild hat mehr als 8 MB.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>Das System im Bild ist beschädigt.</translation>
    </message>
    <message>
        <source>The picture contains a document type declaration, which Barycage neither writes nor reads.</source>
        <translation>Das Bild enthält eine Dokumenttyp-Deklaration, die Barycage weder schreibt noch liest.</translation>
    </message>
    <message>
        <source>The file is not an SVG picture, or it is damaged.</source>
        <translation>Die Datei ist kein SVG-Bild, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed it.</source>
        <translation>Das Bild enthält kein System: Es wurde nicht von Barycage geschrieben, oder ein anderes Programm hat es entfernt.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a flame file cannot contain a document type declaration</source>
        <translation>eine Flame-Datei darf keine Dokumenttyp-Deklaration enthalten</translation>
    </message>
    <message>
        <source>The XML cannot be read beyond this point: %1.</source>
        <translation>Das XML endet hier: %1.</translation>
    </message>
    <message>
        <source>The file contains no flames.</source>
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
        <source>no attractor</source>
        <translation>kein Attraktor</translation>
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
        <source>it uses the variation “%1”</source>
        <translation>sie benutzt die Variation „%1“</translation>
    </message>
    <message>
        <source>it is active but not drawn (opacity 0)</source>
        <translation>sie ist aktiv, wird aber nicht gezeichnet (opacity 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>ihr Gewicht ist keine Zahl</translation>
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
        <source>The entry that starts here has no closing “}” before the next entry or the end of the file.</source>
        <translation>Der hier beginnende Eintrag wird vor dem nächsten Eintrag oder dem Ende der Datei nicht mit „}“ geschlossen.</translation>
    </message>
    <message>
        <source>The name “%1” contains a control character, at which other programs may end it.</source>
        <translation>Der Name „%1“ enthält ein Steuerzeichen, an dem andere Programme ihn enden lassen können.</translation>
    </message>
    <message>
        <source>The name “%1” contains a space; Fractint uses only its first word.</source>
        <translation>Der Name „%1“ enthält ein Leerzeichen; Fractint nimmt nur sein erstes Wort.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint truncates it.</source>
        <translation>Der Name „%1“ ist länger als 18 Bytes; Fractint schneidet ihn dort ab.</translation>
    </message>
    <message>
        <source>The opening brace is on a line of its own; Fractint does not find this entry.</source>
        <translation>Die öffnende Klammer steht in einer eigenen Zeile; Fractint findet diesen Eintrag nicht.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>Der Eintrag hat mehr als %1 Abbildungen; das ist die Grenze.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be a decimal comma or a separator; both readings give complete rows. Use decimal points and spaces.</source>
        <translation>„%1“: Das Komma kann als Dezimalzeichen oder zwischen zwei Zahlen gelesen werden, und beides ergibt ganze Zeilen. Schreiben Sie Dezimalpunkte und Leerzeichen.</translation>
    </message>
    <message>
        <source>“%1”: the comma gives complete rows of 7 numbers (13 with “(3D)”) neither as a decimal comma nor as a separator.</source>
        <translation>„%1“: Weder als Dezimalzeichen noch zwischen zwei Zahlen ergibt das Komma ganze Zeilen von 7 Zahlen (13 mit „(3D)“).</translation>
    </message>
    <message>
        <source>Numbers on the line of the opening brace are ignored, as in Fractint.</source>
        <translation>Die Zahlen in der Zeile der öffnenden Klammer werden übergangen, wie Fractint sie übergeht.</translation>
    </message>
    <message>
        <source>This version of Barycage does not understand “%1”; the line is kept.</source>
        <translation>„%1“ wird von dieser Version von Barycage nicht verstanden; die Zeile bleibt erhalten.</translation>
    </message>
    <message>
        <source>The entry contains no numbers.</source>
        <translation>Der Eintrag enthält keine Zahlen.</translation>
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
        <source>“%1” is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>„%1“ ist größer, als ein Koeffizient sein kann (3,4e38).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Use a plain “-”.</source>
        <translation>„%1“ beginnt mit einem typografischen Minuszeichen (U+2212). Schreiben Sie das einfache „-“.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>There are numbers on the line of the opening brace, where Fractint ignores them; Barycage reads them.</source>
        <translation>In der Zeile der öffnenden Klammer stehen Zahlen, wo Fractint sie übergeht; sie werden gelesen.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads different numbers here.</source>
        <translation>Kommas werden als Dezimalzeichen gelesen; Fractint liest hier andere Zahlen.</translation>
    </message>
    <message>
        <source>Commas or apostrophes separate the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Zwischen den Zahlen stehen Kommas oder Apostrophe; Iterated Dynamics kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each), so the weights are computed from the determinants. Fractint cannot read this entry.</source>
        <translation>Die Abbildungen haben keine Gewichte (je %1 Zahlen); die Gewichte kommen von den Determinanten. Fractint kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Zeilen von %1 Zahlen ohne „(3D)“ hinter dem Namen werden als 3D-System gelesen; Fractint kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>The lines do not have 7 numbers each, but together the numbers fill rows of 7 and are read that way, as in Fractint. The weights are probably missing.</source>
        <translation>Die Zeilen haben nicht je 7 Zahlen, aber alle Zahlen zusammen füllen Zeilen von 7 und werden so gelesen, wie bei Fractint. Wahrscheinlich fehlen die Gewichte.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>Die schließende Klammer berührt die letzte Zahl; Fractint kann diesen Eintrag nicht lesen.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint truncates it.</source>
        <translation>Die Zeile ist länger als 200 Bytes; Fractint schneidet sie dort ab.</translation>
    </message>
    <message>
        <source>There is a NUL byte here; the rest of the line is ignored, as in Fractint.</source>
        <translation>Ein NUL-Byte; der Rest der Zeile wird übergangen, wie Fractint ihn übergeht.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>Der Eintrag hat %1 Abbildungen; Fractint und Iterated Dynamics lesen höchstens 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map is treated as switched off.</source>
        <translation>Das Gewicht der Abbildung %1 ist negativ; die Abbildung gilt als ausgeschaltet.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0, so the map is inactive.</source>
        <translation>Das Gewicht der Abbildung %1 ist 0; die Abbildung ist inaktiv.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are scaled in proportion; Fractint gives any shortfall to the last map and cuts off any excess.</source>
        <translation>Die Summe der Gewichte ist %1 und nicht 1. Sie werden im Verhältnis benutzt; Fractint gibt, was fehlt, der letzten Abbildung und kürzt, was zu viel ist.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>The file contains Fractint parameter sets or formulas, but no iterated function system.</source>
        <translation>Dies sind Parametersätze oder Formeln von Fractint; kein iteriertes Funktionensystem ist darunter.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry consists of a name, “{”, rows of 7 numbers and “}”.</source>
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
        <source>There are two opening braces on one line: no program finds an entry here. The text is kept.</source>
        <translation>Zwei öffnende Klammern in einer Zeile: Kein Programm findet hier einen Eintrag. Der Text bleibt erhalten.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>„%1“ ist ein Parametersatz oder eine Formel, kein iteriertes Funktionensystem; es bleibt als Text erhalten.</translation>
    </message>
    <message>
        <source>The entry in line %1 has the same name (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>Den Namen trägt schon der Eintrag in Zeile %1 (Fractint vergleicht 18 Zeichen ohne Groß- und Kleinschreibung); Fractint erreicht diesen nie.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint treats as part of the first name.</source>
        <translation>Die Datei beginnt mit einer Bytereihenfolgemarke, die Fractint für einen Teil des ersten Namens hält.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); Barycage reads the entries after it too.</source>
        <translation>Fractint hört bei diesem Byte (^Z) zu lesen auf; die Einträge danach werden trotzdem gelesen.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use only the first 2000.</source>
        <translation>Die Datei hat %1 Einträge; Fractint und Iterated Dynamics benutzen die ersten 2000.</translation>
    </message>
    <message>
        <source>The entry has no active map and is omitted.</source>
        <translation>Der Eintrag hat keine aktive Abbildung und wird weggelassen.</translation>
    </message>
    <message>
        <source>The entry is saved under the name “%1”: other programs need unique names of at most 18 plain characters.</source>
        <translation>Der Eintrag wird unter dem Namen „%1“ geschrieben: Andere Programme nehmen 18 einfache Zeichen, und jeden Namen einmal.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>Der Eintrag hat %1 Abbildungen; Fractint bis 17.2 liest höchstens 31.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>none: no map is active</source>
        <translation>keiner: Keine Abbildung ist aktiv</translation>
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
        <source>similarity dimension</source>
        <translation>Ähnlichkeitsdimension</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>Affinitätsdimension</translation>
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
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its rest polygon is flat, crosses itself or has more than 64 vertices.</source>
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
        <source>A palette can have at most %1 colours; the rest are ignored.</source>
        <translation>Eine Palette hat höchstens %1 Farben; die übrigen werden weggelassen.</translation>
    </message>
    <message>
        <source>This line is ignored: a colour consists of three whole numbers from 0 to 255.</source>
        <translation>Diese Zeile wird weggelassen: Drei ganze Zahlen von 0 bis 255 ergeben eine Farbe.</translation>
    </message>
    <message>
        <source>The file contains no colours.</source>
        <translation>Die Datei enthält keine Farben.</translation>
    </message>
    <message>
        <source>The file is larger than 16 MB, which is the limit for a palette.</source>
        <translation>Die Datei hat mehr als 16 MB; das braucht keine Palette.</translation>
    </message>
    <message>
        <source>The file is not a text file, so it is not a palette.</source>
        <translation>Die Datei ist kein Text, also keine Palette.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the rest are ignored.</source>
        <translation>Die Datei hat mehr als %1 Paletten; die übrigen werden weggelassen.</translation>
    </message>
    <message>
        <source>The file contains no gradients.</source>
        <translation>Die Datei enthält keinen Farbverlauf.</translation>
    </message>
    <message>
        <source>The gradient that starts in line %1 is not closed.</source>
        <translation>Der Farbverlauf von Zeile %1 ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>„%1“ ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so it has no points.</source>
        <translation>„%1“ hat keine aktive Abbildung und daher keine Punkte.</translation>
    </message>
    <message>
        <source>A point cloud can have from 1 to %1 points.</source>
        <translation>Eine Punktwolke hat 1 bis %1 Punkte.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>„%1“ ist ein Ordner. Wählen Sie einen Dateinamen.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and will not be replaced. Choose another name.</source>
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
        <source>“%1” was not saved: you do not have permission to write to the folder “%2”. Save somewhere else.</source>
        <translation>„%1“ wurde nicht gespeichert: Sie dürfen nicht in den Ordner „%2“ schreiben. Speichern Sie anderswo.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>„%1“ wurde nicht gespeichert: Der Name ist zu lang.</translation>
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
        <source>Only systems in the plane can be written as vector graphics.</source>
        <translation>Nur Systeme der Ebene können als Vektorgrafik geschrieben werden.</translation>
    </message>
    <message>
        <source>No outline of an attractor could be certified for this system, so there is nothing to copy.</source>
        <translation>Das System hat keinen Attraktor, dessen Umriss bewiesen werden könnte; es gibt nichts zu kopieren.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>In dieser Ansicht ist das Bild zu groß, um als Formen geschrieben zu werden.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row consists of a b c d e f and optionally a weight.</source>
        <translation>Es gibt keine Zeilen von Zahlen: Eine Zeile ist a b c d e f und vielleicht ein Gewicht.</translation>
    </message>
    <message>
        <source>After the count, a map consists of its weight and a matrix of 3 rows.</source>
        <translation>Nach der Anzahl besteht eine Abbildung aus ihrem Gewicht und einer Matrix von 3 Zeilen.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map must be 0 0 1.</source>
        <translation>Die letzte Zeile der Matrix einer affinen Abbildung ist 0 0 1.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>Die Überschrift sagt nicht, welche Spalte a, b, c, d, e und f ist; wählen Sie die Reihenfolge der Spalten.</translation>
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
        <source>This is a %1 file, not a text file with iterated function systems.</source>
        <translation>Dies ist eine %1-Datei, kein Text mit iterierten Funktionensystemen.</translation>
    </message>
    <message>
        <source>This text is encoded in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
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
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text file with iterated function systems.</source>
        <translation>Dies ist eine Binärdatei (vielleicht ein fraktal komprimiertes Bild oder eine Symbolbibliothek), kein Text mit iterierten Funktionensystemen.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and the file is too large for a table of numbers: the limit is 64 MB.</source>
        <translation>Kein iteriertes Funktionensystem wurde gefunden, und für eine Zahlentabelle ist die Datei zu groß: Die Grenze ist 64 MB.</translation>
    </message>
    <message>
        <source>a number is too large for a coefficient (the largest absolute value is 3.4e38)</source>
        <translation>eine Zahl ist größer, als ein Koeffizient sein kann (3.4e38)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest are ignored.</source>
        <translation>Die Datei hat mehr als %1 Flames; der Rest wird weggelassen.</translation>
    </message>
    <message>
        <source>%1 flames in total are not systems of affine maps.</source>
        <translation>Insgesamt %1 Flames sind keine Systeme affiner Abbildungen.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>Der Eintrag hat mehr als %1 Zeilen; das ist die Grenze. Er bleibt als Text erhalten.</translation>
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
        <source>A number in this row is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>Eine Zahl dieser Zeile ist größer, als ein Koeffizient sein kann (3.4e38).</translation>
    </message>
    <message>
        <source>The text is larger than 64 MB, which is the limit for a table of numbers.</source>
        <translation>Der Text hat mehr als 64 MB; das ist die Grenze für eine Zahlentabelle.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Ein Element hat mehr als %1 Attribute; das ist die Grenze.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 levels deep, which is the limit.</source>
        <translation>Die Elemente sind tiefer als %1 verschachtelt; das ist die Grenze.</translation>
    </message>
    <message>
        <source>The file is larger than 64 MB, which is the limit for XML.</source>
        <translation>Die Datei hat mehr als 64 MB; das ist die Grenze für XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>verschobener Ast</translation>
    </message>
    <message>
        <source>The stored position of a branch is not valid and is not applied: its map is incomplete, its address names maps that do not exist or occurs twice, or there are too many.</source>
        <translation>Ein gespeicherter Ort eines Astes ist nicht brauchbar (seine Abbildung ist unvollständig, seine Adresse nennt Abbildungen, die es nicht gibt, oder kommt zweimal vor, oder es sind zu viele) und wird nicht angewandt.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Eine Zelle dieser Zeile ist leer.</translation>
    </message>
    <message>
        <source>A comma can be a decimal comma or a separator here; both readings give complete rows. Use decimal points.</source>
        <translation>Ein Komma kann hier als Dezimalzeichen oder zwischen zwei Zahlen gelesen werden, und beides ergibt ganze Zeilen. Schreiben Sie Dezimalpunkte.</translation>
    </message>
    <message>
        <source>The table mixes maps of the plane and maps of space.</source>
        <translation>Die Tabelle hat Abbildungen der Ebene und Abbildungen des Raums.</translation>
    </message>
    <message>
        <source>This is a list of other files, as used by the program Fraktale, not a Fractint collection.</source>
        <translation>Dies ist eine Liste anderer Dateien, wie das Programm Fraktale sie hat, keine Fractint-Sammlung.</translation>
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
        <source>There is no column “%1”: the columns are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Keine Spalte heißt „%1“: Es gibt a b c d oder r s theta phi, e f, und p oder cumulative.</translation>
    </message>
    <message>
        <source>“%1” occurs twice.</source>
        <translation>„%1“ kommt zweimal vor.</translation>
    </message>
    <message>
        <source>A row has only one weight: p or cumulative.</source>
        <translation>Eine Zeile hat ein Gewicht: p oder cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi cannot be combined.</source>
        <translation>a b c d und r s theta phi passen nicht zusammen.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Es fehlt: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than other programs can read in one path. Choose a smaller depth.</source>
        <translation>Der Umriss hat mehr Ecken, als Programme in einem Pfad lesen. Wählen Sie eine kleinere Tiefe.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers describe the picture at rest.</source>
        <translation>Der Käfig biegt das Bild oder drückt es flach. Die Zahlen sind die des Bildes in Ruhe.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid UTF-8. Rename the file, or open it through a symbolic link.</source>
        <translation>Der Name „%1“ ist kein gültiges UTF-8. Benennen Sie die Datei um, oder öffnen Sie sie über einen symbolischen Link.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so all weights are computed from the determinants and the given ones are ignored.</source>
        <translation>Die Abbildung %1 hat kein Gewicht; daher kommen die Gewichte aller Abbildungen von den Determinanten, und die angegebenen werden nicht verwendet.</translation>
    </message>
    <message>
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its vertices at rest are in one plane or coincide.</source>
        <translation>Der gespeicherte Käfig ist nicht brauchbar (seine Eckenlisten passen nicht zusammen, oder seine Ruheecken liegen in einer Ebene oder fallen zusammen) und wird nicht angewandt.</translation>
    </message>
    <message>
        <source>This entry is %1-dimensional, but its stored cage or moved branches are not: they are not applied, and their lines are kept.</source>
        <translation>Dieser Eintrag ist %1-dimensional, sein gespeicherter Käfig oder seine verschobenen Äste sind es nicht: Sie werden nicht angewandt, und ihre Zeilen bleiben erhalten.</translation>
    </message>
    <message>
        <source>none: ρ(A) ≥ 1 for the word %1</source>
        <translation>keiner: ρ(A) ≥ 1 für das Wort %1</translation>
    </message>
    <message>
        <source>(of the attractor: its pieces are disjoint)</source>
        <translation>(des Attraktors: seine Teile sind disjunkt)</translation>
    </message>
    <message>
        <source>(upper bound: pieces coincide)</source>
        <translation>(obere Schranke: Teile fallen zusammen)</translation>
    </message>
    <message>
        <source>(if the open set condition holds; else an upper bound)</source>
        <translation>(wenn die Offene-Mengen-Bedingung gilt; sonst eine obere Schranke)</translation>
    </message>
    <message>
        <source>strong: no two pieces meet</source>
        <translation>stark: keine zwei Teile berühren sich</translation>
    </message>
    <message>
        <source>none: pieces coincide</source>
        <translation>keine: Teile fallen zusammen</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>zusammenhängend</translation>
    </message>
    <message>
        <source>connected, within rounding error</source>
        <translation>zusammenhängend, soweit die Rundung es erkennen lässt</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht zusammenhängend</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>Trennung</translation>
    </message>
    <message>
        <source>connectedness</source>
        <translation>Zusammenhang</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map</source>
        <translation>die Wörter %1 und %2 sind dieselbe Abbildung</translation>
    </message>
    <message>
        <source>joint spectral radius</source>
        <translation>gemeinsamer Spektralradius</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>entropy</source>
        <translation>Entropie</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Ljapunow-Exponent</translation>
    </message>
    <message>
        <source>dimension of measure</source>
        <translation>Dimension des Maßes</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of 6 numbers, line by line, or as %2 maps of 7 numbers, whose weights then sum to 1. They are read line by line; for the other reading, put 7 numbers on each line.</source>
        <translation>Die Zahlen lassen sich zeilenweise als %1 Abbildungen aus 6 Zahlen lesen oder als %2 Abbildungen aus 7 Zahlen, deren Gewichte dann die Summe 1 haben. Sie werden zeilenweise gelesen; für die andere Lesart setzen Sie 7 Zahlen in jede Zeile.</translation>
    </message>
    <message>
        <source>The block names no maps: a line such as “A=(f1|f2)*A” is missing.</source>
        <translation>Der Block nennt keine Abbildungen: eine Zeile wie „A=(f1|f2)*A“ fehlt.</translation>
    </message>
    <message>
        <source>“%1” is not understood: Barycage reads blocks of affine maps, such as “f1=[e,f]*[a,b,c,d]” and “A=(f1|f2)*A”.</source>
        <translation>„%1“ wird nicht verstanden: Barycage liest Blöcke affiner Abbildungen wie „f1=[e,f]*[a,b,c,d]“ und „A=(f1|f2)*A“.</translation>
    </message>
    <message>
        <source>The file has more than %1 blocks, which is the limit; the rest was not read.</source>
        <translation>Die Datei hat mehr als %1 Blöcke, die Obergrenze; der Rest wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>This IFStile file contains no affine system.</source>
        <translation>Diese IFStile-Datei enthält kein affines System.</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of %2 numbers, line by line, or as %3 maps of 7 numbers, whose weights then sum to 1. They are read line by line, unlike in Fractint; for the other reading, put 7 numbers on each line.</source>
        <translation>Die Zahlen lassen sich zeilenweise als %1 Abbildungen aus %2 Zahlen lesen oder als %3 Abbildungen aus 7 Zahlen, deren Gewichte dann die Summe 1 haben. Sie werden, anders als in Fractint, zeilenweise gelesen; für die andere Lesart setzen Sie 7 Zahlen in jede Zeile.</translation>
    </message>
    <message>
        <source>The numbers are read line by line, as %1 maps of %2 numbers. Fractint ignores line ends and reads %3 maps of 7 numbers.</source>
        <translation>Die Zahlen werden zeilenweise gelesen, als %1 Abbildungen aus %2 Zahlen. Fractint ignoriert Zeilenenden und liest %3 Abbildungen aus 7 Zahlen.</translation>
    </message>
    <message>
        <source>Entries whose names begin with “ifs:” belong in parameter files (.par); in a collection, Fractint takes the prefix as part of the name.</source>
        <translation>Einträge, deren Namen mit „ifs:“ beginnen, gehören in Parameterdateien (.par); in einer Sammlung hält Fractint das Präfix für einen Teil des Namens.</translation>
    </message>
    <message>
        <source>The lines end with CR alone, as on old Macintosh computers; Fractint reads such a file as a single line.</source>
        <translation>Die Zeilen enden nur mit CR, wie auf alten Macintosh-Rechnern; Fractint liest eine solche Datei als eine einzige Zeile.</translation>
    </message>
    <message>
        <source>The convex hull has an error of up to %1: the tolerance %2 was not reached.</source>
        <translation>Die konvexe Hülle hat einen Fehler von bis zu %1: die Toleranz %2 wurde nicht erreicht.</translation>
    </message>
    <message>
        <source>contractive in an ellipsoidal norm, γ %1</source>
        <translation>kontraktiv in einer ellipsoidischen Norm, γ %1</translation>
    </message>
    <message>
        <source>contractive in a polytope norm, γ %1</source>
        <translation>kontraktiv in einer Polytopnorm, γ %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ %1 from words of length %2</source>
        <translation>schließlich kontraktiv, γ %1 aus Wörtern der Länge %2</translation>
    </message>
    <message>
        <source>hyperbolic, s %1</source>
        <translation>hyperbolisch, s %1</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 Abbildung</translation>
    </message>
    <message>
        <source>%1 maps</source>
        <translation>%1 Abbildungen</translation>
    </message>
    <message>
        <source>%1 — in space, %2</source>
        <translation>%1 – im Raum, %2</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2</source>
        <translation>%1 – in der Ebene, %2</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>in space, %1</source>
        <translation>im Raum, %1</translation>
    </message>
    <message>
        <source>in the plane, %1</source>
        <translation>in der Ebene, %1</translation>
    </message>
    <message>
        <source>its cage</source>
        <translation>seinen Käfig</translation>
    </message>
    <message>
        <source>its moved branches</source>
        <translation>seine bewegten Äste</translation>
    </message>
    <message>
        <source>its palette</source>
        <translation>seine Palette</translation>
    </message>
    <message>
        <source>its background</source>
        <translation>seinen Hintergrund</translation>
    </message>
    <message>
        <source>its other colour settings</source>
        <translation>seine übrigen Farbeinstellungen</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>“%1” is written without %2: other programs will draw a different picture.</source>
        <translation>„%1“ wird ohne %2 geschrieben: andere Programme werden ein anderes Bild zeichnen.</translation>
    </message>
    <message>
        <source>“%1” is written without %2.</source>
        <translation>„%1“ wird ohne %2 geschrieben.</translation>
    </message>
    <message>
        <source>The stored animation is not applied, because “%1” is not understood; its lines are kept.</source>
        <translation>Die gespeicherte Animation wird nicht angewendet, weil „%1“ nicht verstanden wird; ihre Zeilen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The entry has more than one stored animation: the last valid one is used, and the lines of the others are kept.</source>
        <translation>Der Eintrag hat mehr als eine gespeicherte Animation: Die letzte gültige wird verwendet, die Zeilen der anderen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The stored animation is not valid and is not applied: it moves maps or vertices that do not exist, a frame, number or curve is out of its range, or keys are not in order. Its lines are kept.</source>
        <translation>Die gespeicherte Animation ist ungültig und wird nicht angewendet: Sie bewegt Abbildungen oder Ecken, die es nicht gibt, ein Bild, eine Zahl oder eine Kurve liegt außerhalb ihres Bereichs, oder Schlüsselbilder sind nicht in der richtigen Reihenfolge. Ihre Zeilen bleiben erhalten.</translation>
    </message>
    <message>
        <source>in a cycle</source>
        <translation>in einer Schleife</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>hin und zurück</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message>
        <source>animation</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>This is not the format of a fractal program. Its lists of numbers are read as tables of maps (systems: %1, maps: %2), in the order a b c d e f unless names give another order.</source>
        <translation>Dies ist kein Format von Fraktalprogrammen. Seine Zahlenlisten werden als Tabellen von Abbildungen gelesen (Systeme: %1, Abbildungen: %2), in der Reihenfolge a b c d e f, wo Namen keine andere angeben.</translation>
    </message>
    <message>
        <source>it acts in space after its variations (“%1”)</source>
        <translation>sie wirkt nach ihren Variationen im Raum („%1“)</translation>
    </message>
    <message>
        <source>its “%1” is not six numbers</source>
        <translation>„%1“ besteht nicht aus sechs Zahlen</translation>
    </message>
    <message>
        <source>The flame names a palette of another program by its number; its colours are not in the file.</source>
        <translation>Die Flame nennt eine Palette eines anderen Programms nur mit deren Nummer; die Farben stehen nicht in der Datei.</translation>
    </message>
    <message>
        <source>“%1” could not be read, so it has no points.</source>
        <translation>„%1“ konnte nicht gelesen werden und hat deshalb keine Punkte.</translation>
    </message>
    <message>
        <source>This is JSON text (data of another program), not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>Dies ist JSON-Text (Daten eines anderen Programms), keine Fractint-Sammlung, und keine seiner Listen besteht aus affinen Abbildungen.</translation>
    </message>
    <message>
        <source>This is the text of a program, not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>Dies ist der Text eines Programms, keine Fractint-Sammlung, und keine seiner Listen besteht aus affinen Abbildungen.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it has no solid.</source>
        <translation>„%1“ ist kein System im Raum und hat deshalb keinen Körper.</translation>
    </message>
    <message>
        <source>The cage of “%1” bends the picture, so its solid cannot be written.</source>
        <translation>Der Käfig von „%1“ biegt das Bild; sein Körper kann deshalb nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>“%1” has no certified attractor, so it has no solid.</source>
        <translation>„%1“ hat keinen nachgewiesenen Attraktor und deshalb keinen Körper.</translation>
    </message>
    <message>
        <source>“%1” would need more than %2 parts in OpenSCAD. Choose larger voxels.</source>
        <translation>„%1“ bräuchte in OpenSCAD mehr als %2 Teile. Wählen Sie größere Voxel.</translation>
    </message>
    <message>
        <source>“%1” is too large for a solid.</source>
        <translation>„%1“ ist zu groß für einen Körper.</translation>
    </message>
    <message>
        <source>“%1” is a single point: only the size of its voxel can be chosen.</source>
        <translation>„%1“ ist ein einzelner Punkt: Nur die Größe des Voxels kann gewählt werden.</translation>
    </message>
    <message>
        <source>The surface of “%1” is not closed, so it was not written.</source>
        <translation>Die Oberfläche von „%1“ ist nicht geschlossen und wurde deshalb nicht geschrieben.</translation>
    </message>
    <message>
        <source>Size: %1 × %2 × %3 mm; volume: %4 mm³; triangles: %5.</source>
        <translation>Größe: %1 × %2 × %3 mm; Volumen: %4 mm³; Dreiecke: %5.</translation>
    </message>
    <message>
        <source>Distance from the attractor: at most %1 mm = √3 · %2 mm + %3 mm for the wall.</source>
        <translation>Abstand vom Attraktor: höchstens %1 mm = √3 · %2 mm + %3 mm für die Wand.</translation>
    </message>
    <message>
        <source>Cavities filled: %1, with %2 mm³.</source>
        <translation>Gefüllte Hohlräume: %1, mit %2 mm³.</translation>
    </message>
    <message>
        <source>Closed cavities: %1, with %2 mm³.</source>
        <translation>Geschlossene Hohlräume: %1, mit %2 mm³.</translation>
    </message>
    <message>
        <source>Separate bodies: %1.</source>
        <translation>Getrennte Körper: %1.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>„%1“: %2</translation>
    </message>
    <message>
        <source>“%1” belongs to another picture: the entry, the view, the size, the seed or the format differs.</source>
        <translation>„%1“ gehört zu einem anderen Bild: Eintrag, Ausschnitt, Größe, Startwert oder Format sind verschieden.</translation>
    </message>
    <message>
        <source>“%1” belongs to a picture with a different number of points, so the sums cannot be combined.</source>
        <translation>„%1“ gehört zu einem Bild mit anderer Punktzahl; die Summen lassen sich nicht addieren.</translation>
    </message>
    <message>
        <source>“%1” and “%2” hold the same part of the picture, which would be counted twice.</source>
        <translation>„%1“ und „%2“ enthalten denselben Teil des Bildes, der doppelt gezählt würde.</translation>
    </message>
    <message>
        <source>“%1” was written by another version of the program, which may draw other pixels.</source>
        <translation>„%1“ wurde von einer anderen Version des Programms geschrieben, die andere Pixel zeichnen kann.</translation>
    </message>
    <message>
        <source>The picture is incomplete: only %1 % of it is present. Add the files of the other parts, or merge to a .sum file.</source>
        <translation>Das Bild ist nicht vollständig: %1 % sind vorhanden. Fügen Sie die Dateien der anderen Teile hinzu, oder schreiben Sie eine .sum-Datei.</translation>
    </message>
    <message>
        <source>This is not a file of sums.</source>
        <translation>Dies ist keine Summendatei.</translation>
    </message>
    <message>
        <source>The file of sums is damaged or incomplete.</source>
        <translation>Die Summendatei ist beschädigt oder unvollständig.</translation>
    </message>
    <message>
        <source>“%1” is a symbolic link that leads back to itself, or through too many others.</source>
        <translation>„%1“ ist ein symbolischer Link, der auf sich selbst zurückführt oder über zu viele andere.</translation>
    </message>
    <message>
        <source>You do not have permission to enter the folder “%1”.</source>
        <translation>Sie dürfen den Ordner „%1“ nicht betreten.</translation>
    </message>
    <message>
        <source>not computed within the budget</source>
        <translation>innerhalb des Zeitbudgets nicht berechnet</translation>
    </message>
    <message>
        <source>A cage with more than four corners bends the solid; its points cannot be written.</source>
        <translation>Ein Käfig mit mehr als vier Ecken biegt den Körper; dessen Punkte können nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>The sheet would have %1 by %2 pixels; the limit is %3 pixels in width. Use smaller tiles or fewer columns.</source>
        <translation>Das Blatt wäre %1 mal %2 Pixel groß; es kann höchstens %3 Pixel breit sein. Nehmen Sie kleinere Kacheln oder weniger Spalten.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it down.</source>
        <translation>Das Bild hat %1 × %2 Pixel. Höchstens 32 Millionen Pixel können gelesen werden; verkleinern Sie es.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. Each side needs at least %3 pixels.</source>
        <translation>Das Bild hat %1 × %2 Pixel. Jede Seite braucht mindestens %3 Pixel.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete.</source>
        <translation>Das Bild ist beschädigt oder unvollständig.</translation>
    </message>
    <message>
        <source>The picture is a JPEG in CMYK colours, which programs read differently. Convert it to RGB or grey levels.</source>
        <translation>Das Bild ist ein JPEG in CMYK-Farben, die jedes Programm anders liest. Wandeln Sie es in RGB oder Graustufen um.</translation>
    </message>
    <message>
        <source>The picture is animated. Save one of its frames as a picture of its own.</source>
        <translation>Das Bild ist animiert. Speichern Sie eines seiner Einzelbilder als eigenes Bild.</translation>
    </message>
    <message>
        <source>The picture is too long and thin to be traced.</source>
        <translation>Das Bild ist zu lang und schmal, um nachgezeichnet zu werden.</translation>
    </message>
    <message>
        <source>There is no fractal transformation between these entries.</source>
        <translation>Zwischen diesen Einträgen gibt es keine fraktale Transformation.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane.</source>
        <translation>„%1“ ist kein System der Ebene.</translation>
    </message>
    <message>
        <source>The cage of “%1” is flat or bends the picture. Bake or reset it first.</source>
        <translation>Der Käfig von „%1“ ist flach oder verbiegt das Bild. Schreiben Sie ihn zuerst in den Code, oder setzen Sie ihn zurück.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so there is nothing to draw.</source>
        <translation>„%1“ hat keine aktive Abbildung, also gibt es nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>No attractor could be proved for “%1”, so its points have no addresses.</source>
        <translation>„%1“ hat keinen nachweisbaren Attraktor, also haben seine Punkte keine Adressen.</translation>
    </message>
    <message>
        <source>The stored order does not list every active map of “%1” once.</source>
        <translation>Die gespeicherte Reihenfolge nennt nicht jede aktive Abbildung von „%1“ genau einmal.</translation>
    </message>
    <message>
        <source>“%1” has %2 maps; with a symmetry of %3 elements they would be more than %4, which is the limit.</source>
        <translation>„%1“ hat %2 Abbildungen; mit einer Symmetrie aus %3 Elementen wären es mehr als %4, und das ist die Grenze.</translation>
    </message>
    <message>
        <source>The maps of “%1” move in its animation, and the copies that its symmetry makes would not move with them. Remove the motions and the keys of the maps first.</source>
        <translation>Die Abbildungen von „%1“ bewegen sich in der Animation, und die Kopien, die die Symmetrie macht, würden sich nicht mitbewegen. Entfernen Sie zuerst die Bewegungen und die Schlüsselbilder der Abbildungen.</translation>
    </message>
    <message>
        <source>its “chaos” is not a list of numbers from 0 upwards</source>
        <translation>sein „chaos“ ist keine Liste von Zahlen ab 0</translation>
    </message>
    <message>
        <source>its symmetry is not of a kind from −%1 to %1</source>
        <translation>die Art seiner Symmetrie liegt nicht zwischen −%1 und %1</translation>
    </message>
    <message>
        <source>it links more than %1 transforms by “chaos”</source>
        <translation>sie verknüpft mehr als %1 Transformationen durch „chaos“</translation>
    </message>
    <message>
        <source>it links transforms in space by “chaos”</source>
        <translation>sie verknüpft Transformationen im Raum durch „chaos“</translation>
    </message>
    <message>
        <source>Maps of a system in space cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>Abbildungen eines Systems im Raum lassen sich nicht verknüpfen: Die Verknüpfungen werden nicht angewandt, ihre Zeilen bleiben erhalten.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>Mehr als %1 Abbildungen lassen sich nicht verknüpfen: Die Verknüpfungen werden nicht angewandt, ihre Zeilen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The links of map %1 are not valid, so no links are applied: a row of links has one number for each map, 0 or larger.</source>
        <translation>Die Verknüpfungen von Abbildung %1 sind ungültig, daher werden keine angewandt: Eine Zeile von Verknüpfungen hat für jede Abbildung eine Zahl ab 0.</translation>
    </message>
    <message>
        <source>With these links every sequence of maps ends, so no map is active.</source>
        <translation>Durch die Verknüpfungen endet jede Folge von Abbildungen; daher ist keine Abbildung aktiv.</translation>
    </message>
    <message>
        <source>With its stored symmetry the entry would have more than %1 maps, which is the limit. The symmetry is not applied; its lines are kept.</source>
        <translation>Mit der gespeicherten Symmetrie hätte der Eintrag mehr als %1 Abbildungen, und das ist die Grenze. Die Symmetrie wird nicht angewandt; ihre Zeilen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The maps are linked, so the picture is not made of copies of itself.</source>
        <translation>Die Abbildungen sind verknüpft; daher besteht das Bild nicht aus Kopien seiner selbst.</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 Ecke</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>%1, area %2; error at most %3; periodic addresses not computed within the budget</source>
        <translation>%1, Fläche %2; Fehler höchstens %3; periodische Adressen innerhalb des Zeitbudgets nicht berechnet</translation>
    </message>
    <message>
        <source>%1, all of them with periodic addresses, area %2; exact</source>
        <translation>%1, alle mit periodischen Adressen, Fläche %2; exakt</translation>
    </message>
    <message>
        <source>%1, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1, davon %2 mit periodischen Adressen, Fläche %3; Fehler höchstens %4</translation>
    </message>
    <message>
        <source>%1, %2, volume %3; error at most %4</source>
        <translation>%1, %2, Volumen %3; Fehler höchstens %4</translation>
    </message>
    <message>
        <source>1 facet</source>
        <translation>1 Seitenfläche</translation>
    </message>
    <message>
        <source>%1 facets</source>
        <translation>%1 Seitenflächen</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>(within rounding error)</source>
        <translation>(soweit die Rundung es erkennen lässt)</translation>
    </message>
    <message>
        <source>area of the tile</source>
        <translation>Fläche der Kachel</translation>
    </message>
    <message>
        <source>dimension of boundary</source>
        <translation>Dimension des Randes</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>takes no part: after it, the chaos game ends</source>
        <translation>nimmt nicht teil: nach ihr endet das Chaosspiel</translation>
    </message>
    <message>
        <source>takes no part: no map leads to it</source>
        <translation>nimmt nicht teil: keine Abbildung führt zu ihr</translation>
    </message>
    <message>
        <source>takes no part: the chaos game leaves it and never returns</source>
        <translation>nimmt nicht teil: das Chaosspiel verlässt sie und kehrt nie zurück</translation>
    </message>
    <message>
        <source>links from map %1</source>
        <translation>Verknüpfungen von Abbildung %1</translation>
    </message>
    <message>
        <source>linked maps</source>
        <translation>verknüpfte Abbildungen</translation>
    </message>
    <message>
        <source>separation, connectedness, joint spectral radius and periodic addresses are not computed for linked maps</source>
        <translation>Trennung, Zusammenhang, gemeinsamer Spektralradius und periodische Adressen werden für verknüpfte Abbildungen nicht bestimmt</translation>
    </message>
    <message>
        <source>the links of its maps</source>
        <translation>die Verknüpfungen seiner Abbildungen</translation>
    </message>
    <message>
        <source>The symmetry of “%1” is written as the maps that it stands for.</source>
        <translation>Die Symmetrie von „%1“ wird als die Abbildungen geschrieben, für die sie steht.</translation>
    </message>
    <message>
        <source>, in a frame of its own</source>
        <translation>, in einem eigenen Bezugssystem</translation>
    </message>
    <message>
        <source>mirror at %1° through %2</source>
        <translation>Spiegelung bei %1° durch %2</translation>
    </message>
    <message>
        <source>%1-fold rotation about %2</source>
        <translation>%1-zählige Drehung um %2</translation>
    </message>
    <message>
        <source>%1-fold dihedral about %2, a mirror at %3°</source>
        <translation>%1-zählige Diedersymmetrie um %2, eine Spiegelachse bei %3°</translation>
    </message>
    <message>
        <source>rotations of the tetrahedron about %1</source>
        <translation>Drehungen des Tetraeders um %1</translation>
    </message>
    <message>
        <source>rotations of the octahedron about %1</source>
        <translation>Drehungen des Oktaeders um %1</translation>
    </message>
    <message>
        <source>rotations of the icosahedron about %1</source>
        <translation>Drehungen des Ikosaeders um %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, so not every address is one of its points.</source>
        <translation>Die Abbildungen von „%1“ sind verknüpft; deshalb ist nicht jede Adresse einer seiner Punkte.</translation>
    </message>
    <message>
        <source>A GIMP gradient states its number of segments here, from 1 to %1.</source>
        <translation>Hier steht in einem GIMP-Farbverlauf die Zahl seiner Segmente, von 1 bis %1.</translation>
    </message>
    <message>
        <source>This is not a segment of a GIMP gradient that continues the one before.</source>
        <translation>Dies ist kein Segment eines GIMP-Farbverlaufs, das das vorige fortsetzt.</translation>
    </message>
    <message>
        <source>its fractal transformation</source>
        <translation>seine fraktale Transformation</translation>
    </message>
    <message>
        <source>its saved views</source>
        <translation>seine gespeicherten Ansichten</translation>
    </message>
    <message>
        <source>the names of its maps</source>
        <translation>die Namen seiner Abbildungen</translation>
    </message>
    <message>
        <source>the locks of its maps</source>
        <translation>die Sperren seiner Abbildungen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Datum:</translation>
    </message>
    <message>
        <source>part of map %1</source>
        <translation>Teil der Abbildung %1</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>This is not a PNG, JPEG, GIF, BMP, PNM, WebP, TIFF or OpenEXR picture.</source>
        <translation>Dies ist kein PNG-, JPEG-, GIF-, BMP-, PNM-, WebP-, TIFF- oder OpenEXR-Bild.</translation>
    </message>
    <message>
        <source>The picture stores its pixels in a way that cannot be read. Save it as a PNG picture.</source>
        <translation>Das Bild speichert seine Pixel auf eine Weise, die nicht gelesen werden kann. Speichern Sie es als PNG-Bild.</translation>
    </message>
    <message>
        <source>Too many maps to bound the jumps</source>
        <translation>Zu viele Abbildungen, um die Sprünge abzuschätzen</translation>
    </message>
    <message>
        <source>Proved continuous: the pieces do not touch</source>
        <translation>Bewiesen stetig: Die Teile berühren sich nicht</translation>
    </message>
    <message>
        <source>Proved so far: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Bisher bewiesen: Kein Sprung zwischen Teilen ist größer als %1 (%2 % des Partners), am schlechtesten bei %3</translation>
    </message>
    <message>
        <source>Proved: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Bewiesen: Kein Sprung zwischen Teilen ist größer als %1 (%2 % des Partners), am schlechtesten bei %3</translation>
    </message>
    <message>
        <source>Proved to be a homeomorphism</source>
        <translation>Bewiesen ein Homöomorphismus</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism</source>
        <translation>Bewiesen kein Homöomorphismus</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism</source>
        <translation>Nicht bekannt, ob es ein Homöomorphismus ist</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>Bewiesen kein Homöomorphismus; zurück ist kein Sprung größer als %1 (%2 % dieses Fraktals), am schlechtesten bei %3</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>Nicht bekannt, ob es ein Homöomorphismus ist; zurück ist kein Sprung größer als %1 (%2 % dieses Fraktals), am schlechtesten bei %3</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map within rounding error</source>
        <translation>die Wörter %1 und %2 sind bis auf Rundung dieselbe Abbildung</translation>
    </message>
    <message>
        <source>Omitted lines of blocks that are not iterated function systems: %1.</source>
        <translation>Ausgelassene Zeilen von Blöcken, die keine iterierten Funktionensysteme sind: %1.</translation>
    </message>
    <message>
        <source>Omitted inactive maps: %1.</source>
        <translation>Ausgelassene inaktive Abbildungen: %1.</translation>
    </message>
    <message>
        <source>a point; exact</source>
        <translation>ein Punkt; exakt</translation>
    </message>
    <message>
        <source>(upper bound: the open set condition fails)</source>
        <translation>(obere Schranke: die Offene-Mengen-Bedingung gilt nicht)</translation>
    </message>
    <message>
        <source>%1, and inside itself</source>
        <translation>%1, und in sich selbst</translation>
    </message>
    <message>
        <source>The picture in “%1” needs more than 4 GB of memory in space.</source>
        <translation>Das Bild in „%1“ braucht im Raum mehr als 4 GB Speicher.</translation>
    </message>
    <message>
        <source>The stored symmetry “%1” is not valid for this entry and is not applied; its lines are kept. A rotation repeats each map 2 to %2 times; polyhedra belong to space.</source>
        <translation>Die gespeicherte Symmetrie „%1“ ist für diesen Eintrag nicht gültig und wird nicht angewendet; ihre Zeilen bleiben erhalten. Eine Drehung wiederholt jede Abbildung 2- bis %2-mal; Polyeder gehören in den Raum.</translation>
    </message>
    <message>
        <source>“%1” and “%2” must have the same number of active maps; they have %3 and %4.</source>
        <translation>„%1“ und „%2“ brauchen gleich viele aktive Abbildungen; sie haben %3 und %4.</translation>
    </message>
    <message>
        <source>Other problems in this entry, not listed: %1.</source>
        <translation>Weitere Probleme dieses Eintrags, nicht aufgeführt: %1.</translation>
    </message>
    <message>
        <source>Numbers are missing or left over: this line has %1, the entry has %2, and each map has %3%4.</source>
        <translation>Zahlen fehlen oder sind übrig: Diese Zeile hat %1, der Eintrag hat %2, und jede Abbildung hat %3%4.</translation>
    </message>
    <message>
        <source>moved branches</source>
        <translation>verschobene Äste</translation>
    </message>
    <message>
        <source>all figures are those of the code, where no branch is moved</source>
        <translation>alle Kennwerte sind die des Codes, in dem kein Ast verschoben ist</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time. Choose a lower resolution, which makes larger voxels.</source>
        <translation>Die Teile von „%1“ überlappen oder berühren sich zu stark, um die Voxel in vertretbarer Zeit zu bestimmen. Wählen Sie eine geringere Auflösung, also größere Voxel.</translation>
    </message>
    <message>
        <source>The surface of “%1” would have more than %2 million triangles. Choose a lower resolution, which makes larger voxels.</source>
        <translation>Die Oberfläche von „%1“ hätte mehr als %2 Millionen Dreiecke. Wählen Sie eine geringere Auflösung, also größere Voxel.</translation>
    </message>
    <message>
        <source>The count says %1, but the number of maps is %2.</source>
        <translation>Angegeben ist die Anzahl %1, vorhanden sind aber so viele Abbildungen: %2.</translation>
    </message>
    <message>
        <source>The header names %2 columns, but this row has %1.</source>
        <translation>Die Überschrift nennt %2 Spalten, diese Zeile hat aber %1.</translation>
    </message>
    <message>
        <source>A map has 6 numbers, or 7 with its weight; this row has %1.</source>
        <translation>Eine Abbildung hat 6 Zahlen, oder 7 mit ihrem Gewicht; diese Zeile hat %1.</translation>
    </message>
    <message>
        <source>its animation</source>
        <translation>seine Animation</translation>
    </message>
    <message>
        <source>tracks: %1</source>
        <translation>Spuren: %1</translation>
    </message>
    <message>
        <source>motions: %1</source>
        <translation>Bewegungen: %1</translation>
    </message>
    <message>
        <source>frames: %1, %2 per second, %3</source>
        <translation>Bilder: %1, %2 pro Sekunde, %3</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose larger voxels.</source>
        <translation>Der Körper von „%1“ bräuchte mehr als %2 Millionen Voxel. Wählen Sie größere Voxel.</translation>
    </message>
    <message>
        <source>The wall is too thick for a solid of this size. Choose a thinner wall.</source>
        <translation>Die Wand ist zu dick für einen Körper dieser Größe. Wählen Sie eine dünnere Wand.</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose a lower resolution: at most %3.</source>
        <translation>Der Körper von „%1“ bräuchte mehr als %2 Millionen Voxel. Wählen Sie eine geringere Auflösung: höchstens %3.</translation>
    </message>
    <message>
        <source>Transform %1 has opacity %2; its points are drawn in full.</source>
        <translation>Transformation %1 hat die Deckkraft %2; ihre Punkte werden voll gezeichnet.</translation>
    </message>
    <message>
        <source>The file on disk is unchanged.</source>
        <translation>Die Datei ist, wie sie war.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2.</source>
        <translation>„%1“ wurde nicht gespeichert: %2.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again.</source>
        <translation>„%1“ wurde nicht gespeichert: Der Datenträger ist voll. Schaffen Sie Platz und speichern Sie noch einmal.</translation>
    </message>
    <message>
        <source>“%1” is too small for its distance from the origin: the numbers in the file cannot distinguish its points. Move it to the origin, or make it larger.</source>
        <translation>„%1“ ist zu klein für seinen Abstand vom Ursprung: Die Zahlen der Datei können seine Punkte nicht unterscheiden. Verschieben Sie es zum Ursprung, oder vergrößern Sie es.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and cannot be opened.</source>
        <translation>„%1“ ist keine gewöhnliche Datei und kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The system does not follow the symbolic link “%1”, because another user may have put it there. Choose another name.</source>
        <translation>Das System folgt dem symbolischen Link „%1“ nicht, weil ihn ein anderer Benutzer dort abgelegt haben könnte. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The picture is a JPEG with more than %1 scans. Save it as a PNG picture.</source>
        <translation>Das Bild ist ein JPEG mit mehr als %1 Durchgängen. Speichern Sie es als PNG-Bild.</translation>
    </message>
    <message>
        <source>This is read as %3 (systems: %1, maps: %2).</source>
        <translation>Gelesen als: %3 (Systeme: %1, Abbildungen: %2).</translation>
    </message>
    <message>
        <source>Nothing names its columns: their order is taken to be a b c d e f.</source>
        <translation>Nichts benennt die Spalten: Angenommen wird die Reihenfolge a b c d e f.</translation>
    </message>
    <message>
        <source>In %1, row %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>The text is encoded in UTF-16; it is saved as UTF-8.</source>
        <translation>Der Text ist in UTF-16 kodiert; gespeichert wird er als UTF-8.</translation>
    </message>
    <message>
        <source>This is a program, a page or another document, not a Fractint collection, and none of its numbers are affine maps.</source>
        <translation>Das ist ein Programm, eine Webseite oder ein anderes Dokument, keine Fractint-Sammlung, und keine seiner Zahlen sind affine Abbildungen.</translation>
    </message>
    <message>
        <source>final transform: %1</source>
        <translation>Schlusstransformation: %1</translation>
    </message>
    <message>
        <source>it has several final transforms</source>
        <translation>sie hat mehrere Schlusstransformationen</translation>
    </message>
    <message>
        <source>it has a final transform in space</source>
        <translation>sie hat eine Schlusstransformation im Raum</translation>
    </message>
    <message>
        <source>it has a final transform and a symmetry</source>
        <translation>sie hat eine Schlusstransformation und eine Symmetrie</translation>
    </message>
    <message>
        <source>its final transform flattens the picture</source>
        <translation>ihre Schlusstransformation drückt das Bild flach</translation>
    </message>
    <message>
        <source>The attribute “%1” occurs twice; the first one is read.</source>
        <translation>Das Attribut „%1“ kommt zweimal vor; das erste wird gelesen.</translation>
    </message>
    <message>
        <source>A blank is missing before the attribute “%1”; it is read as if there were one.</source>
        <translation>Vor dem Attribut „%1“ fehlt ein Leerzeichen; es wird gelesen, als stünde dort eines.</translation>
    </message>
    <message>
        <source>The attribute “%1” contains “%2”, which must be “%3” in XML; it is read as it stands.</source>
        <translation>Das Attribut „%1“ enthält „%2“, das in XML „%3“ heißen muss; es wird gelesen, wie es dasteht.</translation>
    </message>
    <message>
        <source>%1 flames with different times are the keys of this animation, a frame for each unit of time. Its colours are those of the first one.</source>
        <translation>%1 Flames mit verschiedenen Zeiten sind die Schlüssel dieser Animation, ein Einzelbild je Zeiteinheit. Ihre Farben sind die der ersten.</translation>
    </message>
    <message>
        <source>Columns that do not belong to a map are not read: %1.</source>
        <translation>Spalten, die nicht zu einer Abbildung gehören, werden nicht gelesen: %1.</translation>
    </message>
    <message>
        <source>The weights rise to %1, so they may be running sums. They are read as weights; to read them as sums, name their column “cumulative” instead of “p”.</source>
        <translation>Die Gewichte steigen bis %1, sind also vielleicht laufende Summen. Sie werden als Gewichte gelesen; um sie als Summen zu lesen, benennen Sie ihre Spalte „cumulative“ statt „p“.</translation>
    </message>
    <message>
        <source>YAML</source>
        <translation>YAML</translation>
    </message>
    <message>
        <source>a text of GIMP’s IFS Fractal</source>
        <translation>Text von GIMPs „IFS-Fraktal“</translation>
    </message>
    <message>
        <source>a LaTeX table</source>
        <translation>LaTeX-Tabelle</translation>
    </message>
    <message>
        <source>an HTML table</source>
        <translation>HTML-Tabelle</translation>
    </message>
    <message>
        <source>a Markdown table</source>
        <translation>Markdown-Tabelle</translation>
    </message>
    <message>
        <source>a wiki table</source>
        <translation>Wiki-Tabelle</translation>
    </message>
    <message>
        <source>matrices in LaTeX</source>
        <translation>Matrizen in LaTeX</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>Gleichungen</translation>
    </message>
    <message>
        <source>Standard output cannot be written to: %1.</source>
        <translation>Auf die Standardausgabe kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>%n exports from the last session are in the queue.</source>
        <translation>
            <numerusform>%n Export vom letzten Mal ist in der Warteschlange.</numerusform>
            <numerusform>%n Exporte vom letzten Mal sind in der Warteschlange.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export is not finished</source>
        <translation>Export ist nicht fertig</translation>
    </message>
    <message>
        <source>A file is still being exported.</source>
        <translation>Eine Datei wird noch exportiert.</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>&amp;Animation…</translation>
    </message>
    <message>
        <source>Exports the motion instead, as GIF, MP4 and others.</source>
        <translation>Exportiert stattdessen die Bewegung, als GIF, MP4 und in anderen Formaten.</translation>
    </message>
    <message>
        <source>If you stop now, no file is written.</source>
        <translation>Wenn Sie jetzt anhalten, wird keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>&amp;Stop Export</source>
        <translation>Export an&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
        <source>Exports are not finished</source>
        <translation>Exporte sind nicht fertig</translation>
    </message>
    <message numerus="yes">
        <source>Barycage closes when they are finished. Closed now, it continues with them at its next start.</source>
        <translation>
            <numerusform>Barycage schließt sich, wenn er fertig ist. Schließen Sie es jetzt, läuft er beim nächsten Start weiter.</numerusform>
            <numerusform>Barycage schließt sich, wenn sie fertig sind. Schließen Sie es jetzt, laufen sie beim nächsten Start weiter.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Schließen</translation>
    </message>
    <message numerus="yes">
        <source>%n exports are still in the queue.</source>
        <translation>
            <numerusform>%n Export ist noch in der Warteschlange.</numerusform>
            <numerusform>%n Exporte sind noch in der Warteschlange.</numerusform>
        </translation>
    </message>
    <message>
        <source>The file has no entry “%1”.</source>
        <translation>Die Datei hat keinen Eintrag „%1“.</translation>
    </message>
    <message>
        <source>Show a step of the lesson</source>
        <translation>Einen Schritt der Lektion zeigen</translation>
    </message>
    <message>
        <source>The cage of this entry does not have the same corners as in the lesson.</source>
        <translation>Der Käfig dieses Eintrags hat andere Ecken als in der Lektion.</translation>
    </message>
    <message>
        <source>The fractals in the open file. The canvas shows the one you select here.</source>
        <translation>Die Fraktale der offenen Datei. Das hier gewählte ist im Bild.</translation>
    </message>
    <message>
        <source>Ready-made fractals by theme, and your own folders of fractals.</source>
        <translation>Fraktale zum Anfangen, nach Themen, und Ihre eigenen Ordner davon.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map per row.</source>
        <translation>Die Abbildungen des Fraktals: sein Code, eine Abbildung je Zeile.</translation>
    </message>
    <message>
        <source>Which map may follow which in the chaos game, as a graph and as a matrix.</source>
        <translation>Welche Abbildungen das Chaosspiel nach welchen anwenden darf, als Graph und als Matrix.</translation>
    </message>
    <message>
        <source>The control cage in numbers: its vertices, their positions at rest, what moving them does, and other cages to choose from.</source>
        <translation>Der Kontrollkäfig in Zahlen: wo seine Ecken sind, wo sie in Ruhe sind, was ihre Bewegung bewirkt, und andere Käfige zur Wahl.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Farben, Helligkeit und Hintergrund des Bildes. Sie werden mit dem Fraktal gespeichert.</translation>
    </message>
    <message>
        <source>Mathematical properties of this fractal. Point to a name to see what it means.</source>
        <translation>Mathematische Kennwerte dieses Fraktals. Zeigen Sie auf einen Namen, um zu lesen, was er bedeutet.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Select one to go back or forward to it.</source>
        <translation>Jeder Schritt, seit die Datei geöffnet wurde. Wählen Sie einen, um zu ihm zurück- oder vorzugehen.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept while working on it. Click one to restore it.</source>
        <translation>Zustände dieses Fraktals, die Sie beim Arbeiten festgehalten haben. Klicken Sie einen an, um ihn wiederherzustellen.</translation>
    </message>
    <message>
        <source>The animation of this fractal: its motions, and the keys of everything that can move.</source>
        <translation>Die Animation dieses Fraktals: seine Bewegungen und die Schlüssel von allem, was sich bewegen kann.</translation>
    </message>
    <message>
        <source>Find a fractal that looks like a picture: the target, how well the fractal agrees with it, and ways to fit it.</source>
        <translation>Ein Fraktal zu einem Bild: das Ziel, wie gut das Fraktal mit ihm übereinstimmt, und Anpassungen.</translation>
    </message>
    <message>
        <source>Pictures drawn one after another in the background, with the progress of each.</source>
        <translation>Bilder, die nacheinander im Hintergrund gezeichnet werden, und wie weit jedes ist.</translation>
    </message>
    <message>
        <source>A lesson about these fractals: its steps, each with a text and the state of the window, to be played in full screen.</source>
        <translation>Eine Lektion über diese Fraktale: ihre Schritte, jeder mit einem Text und dem Zustand des Fensters, auf dem ganzen Bildschirm abzuspielen.</translation>
    </message>
    <message>
        <source>Problems found in the file, with line and column. The text in the file is kept unchanged.</source>
        <translation>In der Datei gefundene Probleme, mit Zeile und Spalte. Der Text der Datei bleibt unverändert.</translation>
    </message>
    <message>
        <source>%1 is already open in this window.</source>
        <translation>%1 ist in diesem Fenster bereits geöffnet.</translation>
    </message>
    <message>
        <source>%1 by %2°</source>
        <translation>%1 um %2°</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 um den Faktor %2</translation>
    </message>
    <message>
        <source>%1 to (%2, %3)</source>
        <translation>%1 nach (%2, %3)</translation>
    </message>
    <message>
        <source>%1 by (%2, %3)</source>
        <translation>%1 um (%2, %3)</translation>
    </message>
    <message>
        <source>%1°</source>
        <comment>an angle</comment>
        <translation>%1°</translation>
    </message>
    <message>
        <source>× %1</source>
        <comment>a factor</comment>
        <translation>× %1</translation>
    </message>
    <message>
        <source>Δ (%1, %2)  length %3</source>
        <translation>Δ (%1, %2)  Länge %3</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>edges %1 and %2</source>
        <translation>Kanten %1 und %2</translation>
    </message>
    <message>
        <source>Map %1</source>
        <comment>begins a sentence</comment>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Map that takes no part</source>
        <translation>Abbildung, die nicht teilnimmt</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, Ecke %2</translation>
    </message>
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
        <source>Round handle</source>
        <translation>Runder Griff</translation>
    </message>
    <message>
        <source>Square handle</source>
        <translation>Quadratischer Griff</translation>
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
        <source>the arrow keys turn by one degree</source>
        <translation>die Pfeiltasten drehen um ein Grad</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>die Pfeiltasten skalieren um ein Prozent</translation>
    </message>
    <message>
        <source>Drag to move the pivot, the centre of rotation and scaling.</source>
        <translation>Den Drehpunkt ziehen: Um ihn wird gedreht und skaliert.</translation>
    </message>
    <message>
        <source>Drag to rotate about the pivot; hold Shift for steps of 15°.</source>
        <translation>Ziehen dreht um den Drehpunkt; Umschalt: in Schritten von 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; hold Shift for x or y only.</source>
        <translation>Ziehen skaliert um den Drehpunkt; Umschalt: nur in x oder y.</translation>
    </message>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>eingefügt</translation>
    </message>
    <message>
        <source>The name “%1” does not match the chosen format. Choose another name.</source>
        <translation>Der Name „%1“ passt nicht zum gewählten Format. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Another export in the queue writes “%1”. Choose another name.</source>
        <translation>Ein anderer Export in der Warteschlange schreibt „%1“. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Added to the queue: %1.</source>
        <translation>In die Warteschlange aufgenommen: %1.</translation>
    </message>
    <message>
        <source>%1 × %2 are %3 million pixels. Drawing them may take hours, and the file may need up to %4.</source>
        <translation>%1 × %2 sind %3 Millionen Pixel. Sie zu zeichnen kann Stunden dauern, und die Datei kann bis zu %4 groß werden.</translation>
    </message>
    <message>
        <source>Memory needed: about %1.</source>
        <translation>Benötigter Speicher: etwa %1.</translation>
    </message>
    <message>
        <source>Very large picture</source>
        <translation>Sehr großes Bild</translation>
    </message>
    <message>
        <source>This picture is very large.</source>
        <translation>Dieses Bild ist sehr groß.</translation>
    </message>
    <message>
        <source>&amp;Export Anyway</source>
        <translation>Trotzdem &amp;exportieren</translation>
    </message>
    <message>
        <source>%1 could not be written. Print it to another folder.</source>
        <translation>%1 konnte nicht geschrieben werden. Drucken Sie in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Finds these words in the guide. Enter goes to the next match, Shift+Enter to the previous one. Ctrl+F comes back here.</source>
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
    <message>
        <source>User Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>The user guide: what you can do with Barycage, in the order in which you need it.</source>
        <translation>Das Handbuch: was sich hier tun lässt, in der Reihenfolge, in der man es braucht.</translation>
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
    <message>
        <source>Smallest Rectangle</source>
        <translation>Kleinstes Rechteck</translation>
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
        <source>Three Edges of the Bounding Box</source>
        <translation>Drei Kanten des umgebenden Quaders</translation>
    </message>
    <message>
        <source>Bounding Box, Eight Corners</source>
        <translation>Hüllquader, acht Ecken</translation>
    </message>
    <message>
        <source>Octahedron</source>
        <translation>Oktaeder</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Das Eingefügte wird gelesen …</translation>
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
        <source>Nothing was pasted: the clipboard contains no rows of 6 or 7 numbers.</source>
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
    <message numerus="yes">
        <source>%n maps added.</source>
        <translation>
            <numerusform>%n Abbildung hinzugefügt.</numerusform>
            <numerusform>%n Abbildungen hinzugefügt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The selected maps were replaced; %n maps pasted.</source>
        <translation>
            <numerusform>Die ausgewählten Abbildungen wurden ersetzt; %n Abbildung eingefügt.</numerusform>
            <numerusform>Die ausgewählten Abbildungen wurden ersetzt; %n Abbildungen eingefügt.</numerusform>
        </translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Nach |Determinante|</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Gleich</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Nach Dimension</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normieren</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>Dasselbe Gewicht für jede Abbildung</translation>
    </message>
    <message>
        <source>Weights that cover the attractor evenly at its own dimension</source>
        <translation>Gewichte, die den Attraktor in seiner eigenen Dimension gleichmäßig bedecken</translation>
    </message>
    <message>
        <source>Scale all weights so that they sum to 1</source>
        <translation>Dieselben Verhältnisse, mit der Summe 1</translation>
    </message>
    <message>
        <source>Set the weights of all maps that are switched on by a rule</source>
        <translation>Gewichte aller eingeschalteten Abbildungen nach einer Regel</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>„%1“ wird gespeichert …</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegelung</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Dihedral</source>
        <translation>Diedergruppe</translation>
    </message>
    <message>
        <source>Tetrahedral</source>
        <translation>Tetraedergruppe</translation>
    </message>
    <message>
        <source>Octahedral</source>
        <translation>Oktaedergruppe</translation>
    </message>
    <message>
        <source>Icosahedral</source>
        <translation>Ikosaedergruppe</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Dieser Eintrag hat keine Abbildungen der Ebene.</translation>
    </message>
    <message>
        <source>The cage is at rest: the picture shows the code.</source>
        <translation>Der Käfig ist in Ruhe: Gezeigt wird der Code selbst.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code produces a bent picture. Choose “Affine fit” to bake the closest affine placement.</source>
        <translation>Der Käfig biegt das Bild, und kein affiner Code hat ein gebogenes Bild. Mit „Affin angepasst“ lässt sich einrechnen, was ihm am nächsten kommt.</translation>
    </message>
    <message>
        <source>The cage is flat, so its placement cannot be baked into the code. Open the cage first.</source>
        <translation>Der Käfig ist flach, seine Lage lässt sich nicht in den Code einrechnen. Öffnen Sie zuerst den Käfig.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>Der Käfig ist in Ruhe.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. Bake to change the code.</source>
        <translation>Den Käfig zu bewegen bewegt das Bild. Der Code bleibt, wie er ist, bis Sie einrechnen.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can reproduce, so the code does not change.</source>
        <translation>Den ganzen Käfig zu bewegen schreibt den Code um. Einzelne Ecken zu bewegen biegt das Bild; dem kann kein Code folgen, und er bleibt.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites all coefficients of the code; the cage is then at rest in its new position.</source>
        <translation>Den Käfig zu bewegen schreibt jeden Koeffizienten des Codes um, und der Käfig ruht, wo er ist.</translation>
    </message>
    <message>
        <source>The cage is not at rest: it already holds a placement.</source>
        <translation>Der Käfig ist nicht in Ruhe: Er hält bereits eine Lage.</translation>
    </message>
    <message>
        <source>Only a cage with three vertices can be unbaked.</source>
        <translation>Nur ein Dreieck kann aus dem Code herausgerechnet werden.</translation>
    </message>
    <message>
        <source>The cage is not convex: the picture may fold over itself at the notch.</source>
        <translation>Der Käfig hat eine Kerbe: Dort kann sich das Bild überfalten.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture overlap. Move the vertices apart to unfold it.</source>
        <translation>Der Käfig ist gefaltet: Teile des Bildes liegen übereinander. Bewegen Sie die Ecken auseinander, um ihn zu entfalten.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to enclose.</source>
        <translation>Keine Abbildung ist aktiv; es gibt nichts einzuschließen.</translation>
    </message>
    <message>
        <source>The maps are linked; a cage cannot be fitted to linked maps.</source>
        <translation>Die Abbildungen sind verknüpft; verknüpften Abbildungen lässt sich kein Käfig anpassen.</translation>
    </message>
    <message>
        <source>A bent picture cannot be given another cage. First reset the cage or choose “Affine fit”.</source>
        <translation>Ein gebogenes Bild kann kein anderer Käfig halten. Setzen Sie zuerst den Käfig zurück oder wählen Sie „Affin angepasst“.</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the triangle.</source>
        <translation>Der Käfig ist flach. Öffnen Sie zuerst das Dreieck oder setzen Sie es zurück.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Dieses System hat keinen Attraktor, der eingeschlossen werden könnte.</translation>
    </message>
    <message>
        <source>All maps are off.</source>
        <translation>Alle Abbildungen sind aus.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be compared with a picture.</source>
        <translation>Die Abbildungen sind verknüpft. Nur Abbildungen, die alle aufeinander folgen dürfen, lassen sich mit einem Bild vergleichen.</translation>
    </message>
    <message>
        <source>A symmetry repeats the maps. Expand it to compare them with a picture.</source>
        <translation>Eine Symmetrie wiederholt die Abbildungen. Schreiben Sie sie aus, um die Abbildungen mit einem Bild zu vergleichen.</translation>
    </message>
    <message>
        <source>The cage bends the picture, or is flat. Reset the cage to compare the maps.</source>
        <translation>Der Käfig verbiegt das Bild oder ist flach. Setzen Sie ihn zurück, um die Abbildungen zu vergleichen.</translation>
    </message>
    <message>
        <source>The animation of “%1” cannot be taken to another dimension, so it is left out.</source>
        <translation>Die Animation von „%1“ kann nicht in eine andere Dimension mitgenommen werden und entfällt.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, so it cannot be lifted.</source>
        <translation>„%1“ ist kein System in der Ebene und kann deshalb nicht in den Raum gehoben werden.</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, and maps in space cannot be linked.</source>
        <translation>Die Abbildungen von „%1“ sind verknüpft, was Abbildungen im Raum nicht sein können.</translation>
    </message>
    <message>
        <source>The cage of “%1” has more than three corners, so it cannot become a tetrahedron. Bake or reset it first.</source>
        <translation>Der Käfig von „%1“ hat mehr als drei Ecken, aus denen kein Tetraeder wird. Rechnen Sie ihn zuerst ein oder setzen Sie ihn zurück.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it cannot be flattened.</source>
        <translation>„%1“ ist kein System im Raum und kann deshalb nicht abgeflacht werden.</translation>
    </message>
    <message>
        <source>The direction must have a length other than 0.</source>
        <translation>Die Richtung darf nicht die Länge 0 haben.</translation>
    </message>
    <message>
        <source>“%1” has moved branches, which cannot be flattened. Reset them first.</source>
        <translation>„%1“ hat verschobene Äste, die nicht abgeflacht werden können. Setzen Sie sie zuerst zurück.</translation>
    </message>
    <message>
        <source>The cage of “%1” cannot be baked into its maps, so it cannot be flattened.</source>
        <translation>Der Käfig von „%1“ kann nicht in die Abbildungen eingerechnet werden; deshalb ist kein Abflachen möglich.</translation>
    </message>
    <message>
        <source>Map %1 of “%2” does not keep this direction, so the projection is not an iterated function system. Export a picture seen from that direction instead.</source>
        <translation>Abbildung %1 von „%2“ ändert die Richtung; die Projektion ist deshalb kein iteriertes Funktionensystem. Exportieren Sie stattdessen ein Bild von dieser Seite.</translation>
    </message>
    <message>
        <source>An entry needs a name.</source>
        <translation>Ein Eintrag braucht einen Namen.</translation>
    </message>
    <message>
        <source>Names cannot contain spaces: Fractint reads only the first word.</source>
        <translation>Namen dürfen keine Leerzeichen enthalten: Fractint liest nur das erste Wort.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>„%1“ kann nicht Teil eines Namens sein, weil es in .ifs-Dateien eine Bedeutung hat.</translation>
    </message>
    <message>
        <source>A name can have at most %1 characters; Fractint ignores the rest.</source>
        <translation>Ein Name hat höchstens %1 Zeichen; Fractint übergeht den Rest.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint führt einen Eintrag namens „%1“ nicht auf; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case are not distinguished).</source>
        <translation>Ein anderer Eintrag heißt „%1“ (Groß- und Kleinbuchstaben gelten als gleich).</translation>
    </message>
    <message>
        <source>A branch</source>
        <translation>Ein Ast</translation>
    </message>
    <message>
        <source>%1 has keys, which the maps of the new system could not follow. Remove its keys in the timeline first.</source>
        <translation>%1 hat Schlüsselbilder, denen die Abbildungen des neuen Systems nicht folgen könnten. Entfernen Sie sie zuerst aus der Zeitleiste.</translation>
    </message>
    <message>
        <source>A motion moves single maps, and the maps of the new system are others. Remove this motion from the timeline first.</source>
        <translation>Eine Bewegung bewegt einzelne Abbildungen, und die des neuen Systems sind andere. Entfernen Sie diese Bewegung zuerst aus der Zeitleiste.</translation>
    </message>
    <message>
        <source>%1 has keys: it would be rewritten at this frame only, and what has none at every frame. Remove its keys in the timeline first.</source>
        <translation>%1 hat Schlüsselbilder und würde nur in diesem Bild umgeschrieben, alles ohne Schlüsselbilder dagegen in jedem. Entfernen Sie diese zuerst aus der Zeitleiste.</translation>
    </message>
    <message>
        <source>Maps in space cannot be linked.</source>
        <translation>Abbildungen im Raum lassen sich nicht verknüpfen.</translation>
    </message>
    <message>
        <source>This entry could not be read, so its maps cannot be linked.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden; seine Abbildungen lassen sich nicht verknüpfen.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked.</source>
        <translation>Mehr als %1 Abbildungen lassen sich nicht verknüpfen.</translation>
    </message>
    <message>
        <source>With the links of “%1” every sequence of maps ends, so plain maps would have nothing to draw.</source>
        <translation>Die Verknüpfungen von „%1“ lassen jede Folge von Abbildungen enden, also gibt es nichts, was einfache Abbildungen zeichnen könnten.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be more than %2 words of its maps, which is the limit. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Einfache Abbildungen von „%1“ wären mehr als %2 Wörter seiner Abbildungen, was die Grenze ist. Behalten Sie die Verknüpfungen in einer .ifs- oder .flame-Datei, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>The links of “%1” cannot be written as plain maps: a sequence of maps can go on for ever without reaching one that may follow every map. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Die Verknüpfungen von „%1“ lassen sich nicht als einfache Abbildungen schreiben: Eine Folge von Abbildungen kann endlos weitergehen, ohne eine zu erreichen, die auf jede Abbildung folgen darf. Behalten Sie die Verknüpfungen in einer .ifs- oder .flame-Datei, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be words of its maps, which cannot take part in its animation or in its moved branches. Remove these first.</source>
        <translation>Einfache Abbildungen von „%1“ wären Wörter seiner Abbildungen, die an seiner Animation oder seinen bewegten Ästen nicht teilnehmen können. Entfernen Sie diese zuerst.</translation>
    </message>
    <message>
        <source>Map %1 is locked. Unlock it in the Maps panel first.</source>
        <translation>Abbildung %1 ist gesperrt. Geben Sie sie erst im Feld „Abbildungen“ frei.</translation>
    </message>
    <message>
        <source>Maps %1 are locked. Unlock them in the Maps panel first.</source>
        <translation>Die Abbildungen %1 sind gesperrt. Geben Sie sie erst im Feld „Abbildungen“ frei.</translation>
    </message>
    <message>
        <source>Lock a map</source>
        <translation>Eine Abbildung sperren</translation>
    </message>
    <message>
        <source>Unlock a map</source>
        <translation>Eine Abbildung freigeben</translation>
    </message>
    <message>
        <source>Lock %1 maps</source>
        <translation>%1 Abbildungen sperren</translation>
    </message>
    <message>
        <source>Unlock %1 maps</source>
        <translation>%1 Abbildungen freigeben</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Den Namen der Abbildung %1 entfernen</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Abbildung %1 „%2“ nennen</translation>
    </message>
    <message>
        <source>Only a cage with four vertices can be unbaked.</source>
        <translation>Nur ein Käfig mit vier Ecken kann herausgelöst werden.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so no other cage would show it. First reset the cage or choose “Affine fit”.</source>
        <translation>Der Käfig biegt das Bild, und kein anderer Käfig zeigt dasselbe. Setzen Sie ihn erst zurück oder wählen Sie „Affin angepasst“.</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the tetrahedron.</source>
        <translation>Der Käfig ist flach. Öffnen Sie zuerst das Tetraeder oder setzen Sie es zurück.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Erst eine Abbildung wählen.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be shown alone.</source>
        <translation>Die Abbildungen sind verknüpft. Nur Abbildungen, die alle aufeinander folgen dürfen, lassen sich allein zeigen.</translation>
    </message>
    <message>
        <source>The cage bends the picture, in which no map can be shown alone. Reset the cage first.</source>
        <translation>Der Käfig biegt das Bild, in dem sich keine Abbildung allein zeigen lässt. Setzen Sie erst den Käfig zurück.</translation>
    </message>
    <message>
        <source>Map %1 takes everything to one point, so there is nothing to show alone.</source>
        <translation>Abbildung %1 führt alles in einen Punkt, es gibt also nichts allein zu zeigen.</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Dieser Eintrag ist kein System im Raum.</translation>
    </message>
    <message>
        <source>This entry has no maps to vary.</source>
        <translation>Dieser Eintrag hat keine Abbildungen, die sich abwandeln ließen.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>Der Ordner %1 kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size or the supersampling.</source>
        <translation>Für dieses Bild reicht der Speicher nicht. Machen Sie es kleiner oder verringern Sie die Überabtastung.</translation>
    </message>
    <message>
        <source>It is damaged.</source>
        <translation>Er ist beschädigt.</translation>
    </message>
    <message>
        <source>It is not an export of this program.</source>
        <translation>Es ist kein Export dieses Programms.</translation>
    </message>
    <message>
        <source>Its settings are not supported by this version.</source>
        <translation>Seine Einstellungen gibt es in dieser Version nicht.</translation>
    </message>
    <message>
        <source>Its file name does not match its format.</source>
        <translation>Die Datei, die er nennt, passt nicht zu seinem Format.</translation>
    </message>
    <message>
        <source>It is not a regular file.</source>
        <translation>Es ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>Er kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Er ist zu groß.</translation>
    </message>
    <message>
        <source>An export from the last session was skipped. %1 Its damaged file was renamed to %2.</source>
        <translation>Ein Export vom letzten Mal wurde übergangen. %1 Seine beschädigte Datei wurde in %2 umbenannt.</translation>
    </message>
    <message>
        <source>A file “%1” was created after you added this export. Choose Try Again to replace it.</source>
        <translation>Seit Sie diesen Export hinzugefügt haben, ist eine Datei „%1“ entstanden. „Erneut versuchen“ ersetzt sie.</translation>
    </message>
    <message>
        <source>The fractal in this export cannot be read.</source>
        <translation>Das Fraktal in diesem Export kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Für dieses Bild reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>The lesson is larger than 4 MB, which is the limit.</source>
        <translation>Die Lektion ist größer als 4 MB, die Grenze.</translation>
    </message>
    <message>
        <source>This is not a lesson: its first line does not begin with “lesson:”.</source>
        <translation>Das ist keine Lektion: Die erste Zeile beginnt nicht mit „lesson:“.</translation>
    </message>
    <message>
        <source>The lesson has no steps.</source>
        <translation>Die Lektion hat keine Schritte.</translation>
    </message>
    <message>
        <source>This line was ignored: settings look like “file: name.ifs”, and steps begin with “##”.</source>
        <translation>Diese Zeile wurde übergangen: Einstellungen sehen aus wie „file: name.ifs“, Schritte beginnen mit „##“.</translation>
    </message>
    <message>
        <source>The lesson has more than %1 steps; the others were ignored.</source>
        <translation>Die Lektion hat mehr als %1 Schritte; die übrigen wurden übergangen.</translation>
    </message>
    <message>
        <source>The text of step %1 is longer than %2 characters and was cut.</source>
        <translation>Der Text von Schritt %1 ist länger als %2 Zeichen und wurde gekürzt.</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. It can refer to a file in its own folder, or to a .ifs or .par file in another one.</source>
        <translation>Eine Lektion kann nicht auf „%1“ verweisen, nur auf eine Datei in ihrem eigenen Ordner oder auf eine Datei .ifs oder .par in einem anderen.</translation>
    </message>
    <message>
        <source>“%1: %2” was not understood.</source>
        <translation>„%1: %2“ wurde nicht verstanden.</translation>
    </message>
    <message>
        <source>“%1” is unknown to this version and is kept.</source>
        <translation>„%1“ ist dieser Version unbekannt und bleibt erhalten.</translation>
    </message>
    <message>
        <source>A %1 picture has at most %2 pixels along a side.</source>
        <translation>Ein %1-Bild hat höchstens %2 Pixel je Seite.</translation>
    </message>
    <message>
        <source>A JPEG picture cannot be transparent. Choose a background colour or another format.</source>
        <translation>Ein JPEG-Bild kann nicht durchsichtig sein. Wählen Sie eine Hintergrundfarbe oder ein anderes Format.</translation>
    </message>
    <message>
        <source>A JPEG picture has at most %1 dots per inch.</source>
        <translation>Ein JPEG-Bild hat höchstens %1 Punkte pro Zoll.</translation>
    </message>
    <message>
        <source>Such a picture cannot be written as %1.</source>
        <translation>Ein solches Bild kann nicht als %1 geschrieben werden.</translation>
    </message>
    <message>
        <source>The picture cannot be opened.</source>
        <translation>Das Bild kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture.</source>
        <translation>Die Datei ist kein PNG-Bild.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete. Draw it again.</source>
        <translation>Das Bild ist beschädigt oder unvollständig. Zeichnen Sie es neu.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed the text that holds it.</source>
        <translation>Das Bild enthält kein System: Es wurde nicht von Barycage geschrieben, oder ein anderes Programm hat seinen Text entfernt.</translation>
    </message>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>Das System im Bild hat mehr als 8 MB.</translation>
    </message>
    <message>
        <source>The picture contains too much text: the limit is 40 MB in total.</source>
        <translation>Das Bild trägt zu viel Text: Die Grenze liegt bei insgesamt 40 MB.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture, or it is damaged.</source>
        <translation>Die Datei ist kein PNG-Bild, oder sie ist beschädigt.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Das Bild kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The picture is damaged, or its text cannot be read.</source>
        <translation>Das Bild ist beschädigt, oder sein Text kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>the WebP encoder does not have enough memory.</source>
        <translation>der WebP-Kodierer hat nicht genug Speicher.</translation>
    </message>
    <message>
        <source>An exact picture of this system would take too long. Draw it with points.</source>
        <translation>Ein exaktes Bild dieses Systems würde zu lange dauern. Zeichnen Sie es mit Punkten.</translation>
    </message>
    <message>
        <source>The folder for temporary files does not have enough space for the frames: %1.</source>
        <translation>Im Ordner für temporäre Dateien ist kein Platz für die Einzelbilder: %1.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries are not installed on this machine, so no videos can be written. Install them, or write the frames as PNG pictures instead.</source>
        <translation>FFmpegs Bibliotheken sind auf diesem Rechner nicht installiert, also können keine Videos geschrieben werden. Installieren Sie sie, oder schreiben Sie die Einzelbilder stattdessen als PNG-Bilder.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries on this machine cannot write %1 files: the encoder %2 is missing. Choose another format.</source>
        <translation>Die Bibliotheken von FFmpeg auf diesem Rechner können keine %1-Dateien schreiben: Der Encoder %2 fehlt. Wählen Sie ein anderes Format.</translation>
    </message>
    <message>
        <source>The video cannot be written: %1.</source>
        <translation>Das Video kann nicht geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>Flip maps</source>
        <translation>Abbildungen spiegeln</translation>
    </message>
    <message>
        <source>Rotate maps by 90°</source>
        <translation>Abbildungen um 90° drehen</translation>
    </message>
    <message>
        <source>Rotate maps by −90°</source>
        <translation>Abbildungen um −90° drehen</translation>
    </message>
    <message>
        <source>Align maps</source>
        <translation>Abbildungen ausrichten</translation>
    </message>
    <message>
        <source>Distribute maps</source>
        <translation>Abbildungen verteilen</translation>
    </message>
    <message>
        <source>Fit maps to the corners</source>
        <translation>Abbildungen an die Ecken setzen</translation>
    </message>
    <message>
        <source>Only maps in the plane can be arranged.</source>
        <translation>Nur Abbildungen in der Ebene lassen sich anordnen.</translation>
    </message>
    <message>
        <source>Select at least two maps first.</source>
        <translation>Erst mindestens zwei Abbildungen wählen.</translation>
    </message>
    <message>
        <source>Select at least three maps first.</source>
        <translation>Erst mindestens drei Abbildungen wählen.</translation>
    </message>
    <message>
        <source>The cage is flat, so maps cannot be moved in it. Reset the cage first.</source>
        <translation>Der Käfig ist flach, darum lassen sich Abbildungen darin nicht bewegen. Setzen Sie zuerst den Käfig zurück.</translation>
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
        <source>contractive in some norm, γ &lt; 1</source>
        <translation>kontraktiv in einer passenden Norm, γ &lt; 1</translation>
    </message>
    <message>
        <source>(the open set condition holds)</source>
        <translation>(die Offene-Mengen-Bedingung gilt)</translation>
    </message>
    <message>
        <source>(the open set condition holds, within rounding error)</source>
        <translation>(die Offene-Mengen-Bedingung gilt, soweit die Rundung es erkennen lässt)</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>gilt</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>gilt nicht</translation>
    </message>
    <message>
        <source>open set condition</source>
        <translation>Offene-Mengen-Bedingung</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Hausdorff-Dimension</translation>
    </message>
    <message>
        <source>(finite type)</source>
        <translation>(endlicher Typ)</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>holds, within rounding error</source>
        <translation>gilt, soweit die Rundung es erkennen lässt</translation>
    </message>
    <message>
        <source>fails, within rounding error</source>
        <translation>gilt nicht, soweit die Rundung es erkennen lässt</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time, even at the lowest resolution.</source>
        <translation>Die Teile von „%1“ überlappen oder berühren sich zu sehr, um die Voxel in vertretbarer Zeit zu finden, selbst bei der niedrigsten Auflösung.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries cannot be loaded, so no videos can be written: %1.</source>
        <translation>Die Bibliotheken von FFmpeg können nicht geladen werden, daher können keine Videos geschrieben werden: %1.</translation>
    </message>
    <message>
        <source>This entry is not an iterated function system.</source>
        <translation>Dieser Eintrag ist kein iteriertes Funktionensystem.</translation>
    </message>
    <message>
        <source>This entry has %1 maps; a web page can have at most %2.</source>
        <translation>Dieser Eintrag hat %1 Abbildungen; eine Webseite kann höchstens %2 haben.</translation>
    </message>
    <message>
        <source>A solid has no shadow on the ground. Move its light in the Appearance panel: the solid darkens the side that faces away from it.</source>
        <translation>Ein Körper wirft keinen Schatten auf den Boden. Verschieben Sie sein Licht im Feld „Aussehen“: Die abgewandte Seite des Körpers wird dunkel.</translation>
    </message>
    <message>
        <source>This entry could not be read, so there is no picture to cast a shadow.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden, also gibt es kein Bild, das einen Schatten wirft.</translation>
    </message>
    <message>
        <source>its shadow</source>
        <translation>seinen Schatten</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size.</source>
        <translation>Für dieses Bild reicht der Speicher nicht. Verkleinern Sie es.</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Ein Bild</translation>
    </message>
    <message>
        <source>Both eyes, side by side</source>
        <translation>Beide Augen, nebeneinander</translation>
    </message>
    <message>
        <source>Stereo, &amp;Side by Side</source>
        <translation>Stereo, &amp;nebeneinander</translation>
    </message>
    <message>
        <source>Show the views of both eyes side by side, the left eye on the left</source>
        <translation>Zeigt, was jedes Auge sieht, das linke links</translation>
    </message>
    <message>
        <source>Red and cyan glasses</source>
        <translation>Rot-Cyan-Brille</translation>
    </message>
    <message>
        <source>Stereo, for Red and &amp;Cyan Glasses</source>
        <translation>Stereo, für Rot-&amp;Cyan-Brillen</translation>
    </message>
    <message>
        <source>Show the views of both eyes in one picture, in red and cyan</source>
        <translation>Zeigt in einem Bild, was beide Augen sehen, in Rot und Cyan</translation>
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
        <source>Formulas and a figure for LaTeX (.tex)</source>
        <translation>Formeln und eine Zeichnung für LaTeX (.tex)</translation>
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
        <source>PNG: pixels</source>
        <translation>PNG: Pixel</translation>
    </message>
    <message>
        <source>JPEG: pixels, a small file</source>
        <translation>JPEG: Pixel, eine kleine Datei</translation>
    </message>
    <message>
        <source>WebP: pixels, for web pages</source>
        <translation>WebP: Pixel, für Webseiten</translation>
    </message>
    <message>
        <source>TIFF: pixels, for print</source>
        <translation>TIFF: Pixel, für den Druck</translation>
    </message>
    <message>
        <source>OpenEXR: linear light, for compositing</source>
        <translation>OpenEXR: lineares Licht, fürs Compositing</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF: Formen für den Druck</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG: Formen für Zeichenprogramme</translation>
    </message>
    <message>
        <source>Mesh for 3D printing (.stl)</source>
        <translation>Körper zum Drucken (.stl)</translation>
    </message>
    <message>
        <source>Mesh (.obj)</source>
        <translation>Körper (.obj)</translation>
    </message>
    <message>
        <source>Mesh (.glb)</source>
        <translation>Körper (.glb)</translation>
    </message>
    <message>
        <source>Mesh (.ply)</source>
        <translation>Körper (.ply)</translation>
    </message>
    <message>
        <source>“%1” has %2 numbers for %3 maps, so it is not read as their weights, which are computed from the determinants.</source>
        <translation>„%1“ hat %2 Zahlen für %3 Abbildungen und wird deshalb nicht als deren Gewichte gelesen; diese kommen von den Determinanten.</translation>
    </message>
    <message>
        <source>MP4: plays everywhere</source>
        <translation>MP4: läuft überall</translation>
    </message>
    <message>
        <source>WebM: for web pages, with transparency</source>
        <translation>WebM: für Webseiten, mit Transparenz</translation>
    </message>
    <message>
        <source>MKV: lossless, for editing</source>
        <translation>MKV: verlustfrei, zum Bearbeiten</translation>
    </message>
    <message>
        <source>GIF: 256 colours</source>
        <translation>GIF: 256 Farben</translation>
    </message>
    <message>
        <source>WebP: a lossless animated image</source>
        <translation>WebP: bewegtes Bild ohne Verlust</translation>
    </message>
    <message>
        <source>APNG: a lossless animated image</source>
        <translation>APNG: bewegtes Bild ohne Verlust</translation>
    </message>
    <message>
        <source>The link holds more than 1 MB of text, which is the limit.</source>
        <translation>Der Link enthält mehr als 1 MB Text; das ist die Grenze.</translation>
    </message>
    <message>
        <source>This link is damaged, or it holds no fractal.</source>
        <translation>Dieser Link ist beschädigt, oder er enthält kein Fraktal.</translation>
    </message>
    <message>
        <source>This link was cut off: its end is missing. Copy all of it.</source>
        <translation>Dieser Link wurde abgeschnitten: Sein Ende fehlt. Kopieren Sie ihn ganz.</translation>
    </message>
    <message>
        <source>Drawing the pictures…</source>
        <translation>Die Bilder werden gezeichnet…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>PDF: a page with the picture</source>
        <translation>PDF: eine Seite mit dem Bild</translation>
    </message>
    <message>
        <source>SVG: a page with the picture</source>
        <translation>SVG: eine Seite mit dem Bild</translation>
    </message>
    <message>
        <source>There is not enough memory for the video.</source>
        <translation>Der Speicher reicht für das Video nicht aus.</translation>
    </message>
    <message>
        <source>The encoder of the video does not work. There may not be enough memory for it.</source>
        <translation>Der Encoder des Videos arbeitet nicht. Vielleicht reicht der Speicher dafür nicht aus.</translation>
    </message>
    <message>
        <source>lists of numbers</source>
        <translation>Listen von Zahlen</translation>
    </message>
    <message>
        <source>This map is not understood, so none is read.</source>
        <translation>Diese Abbildung wird nicht verstanden, daher wird keine gelesen.</translation>
    </message>
    <message>
        <source>“%1” is not understood, so no map is read.</source>
        <translation>„%1“ wird nicht verstanden, daher wird keine Abbildung gelesen.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
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
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Fertig</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Drag a corner of the triangle: the whole picture follows.</source>
        <translation>Ziehen Sie an einer Ecke des Dreiecks: das ganze Bild folgt.</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Quetschen</translation>
    </message>
    <message>
        <source>Push a corner onto the opposite side until the picture is flat, then pull it open again.</source>
        <translation>Schieben Sie eine Ecke auf die gegenüberliegende Seite, bis das Bild flach ist, und ziehen Sie sie wieder heraus.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Press %1 to take back what you have just done.</source>
        <translation>Drücken Sie %1, um das eben Getane zurückzunehmen.</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>Double-click a picture of the collection that you like.</source>
        <translation>Doppelklicken Sie in der Sammlung auf ein Bild, das Ihnen gefällt.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Press Wind in the timeline and watch the picture sway.</source>
        <translation>Drücken Sie in der Zeitleiste auf Wind und sehen Sie zu, wie sich das Bild wiegt.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Press %1 to save the picture for others.</source>
        <translation>Drücken Sie %1, um das Bild für andere zu speichern.</translation>
    </message>
    <message>
        <source>That Is It</source>
        <translation>Das war’s</translation>
    </message>
    <message>
        <source>Three more steps show what the picture is made of.</source>
        <translation>Drei weitere Schritte zeigen, woraus das Bild besteht.</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Each row is a map that makes one smaller copy of the whole: double-click a number and type another.</source>
        <translation>Jede Zeile ist eine Abbildung, die eine kleinere Kopie des Ganzen macht: doppelklicken Sie auf eine Zahl und tippen Sie eine andere.</translation>
    </message>
    <message>
        <source>Click a point: the maps that lead there are its address, and you hold the branch that they make.</source>
        <translation>Klicken Sie auf einen Punkt: die Abbildungen, die dorthin führen, sind seine Adresse, und Sie halten den Zweig, den sie bilden.</translation>
    </message>
    <message>
        <source>Norm</source>
        <translation>Norm</translation>
    </message>
    <message>
        <source>‖A‖ is how far a map stretches at most: change a number, and keep it below 1.</source>
        <translation>‖A‖ sagt, wie stark eine Abbildung höchstens streckt: ändern Sie eine Zahl, und bleiben Sie unter 1.</translation>
    </message>
    <message>
        <source>In the timeline, choose Wind under Add Motion and watch the picture sway as well.</source>
        <translation>Wählen Sie in der Zeitleiste unter „Bewegung hinzufügen“ Wind und sehen Sie zu, wie sich das Bild außerdem wiegt.</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>Über&amp;springen</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>&amp;Weiter</translation>
    </message>
    <message>
        <source>Open the panel %1 again: it is under View › Panels.</source>
        <translation>Öffnen Sie das Feld %1 wieder: Es steht unter Ansicht › Felder.</translation>
    </message>
    <message>
        <source>That Is All</source>
        <translation>Das war alles</translation>
    </message>
    <message>
        <source>Now take whatever you like by its corners.</source>
        <translation>Jetzt können Sie alles, was Ihnen gefällt, an den Ecken packen.</translation>
    </message>
    <message>
        <source>Press %1 once more: the picture is still flat.</source>
        <translation>Drücken Sie noch einmal %1: Das Bild ist noch flach.</translation>
    </message>
</context>
<context>
    <name>VideoSystem</name>
    <message>
        <source>The file is not a video.</source>
        <translation>Die Datei ist kein Video.</translation>
    </message>
    <message>
        <source>The video contains no system: it was not written by Barycage, it is damaged, or another program removed the text that holds it.</source>
        <translation>Das Video enthält kein System: Es wurde nicht von Barycage geschrieben, es ist beschädigt, oder ein anderes Programm hat den Text entfernt, der es enthält.</translation>
    </message>
    <message>
        <source>The system in the video is larger than 8 MB.</source>
        <translation>Das System im Video ist größer als 8 MB.</translation>
    </message>
</context>
<context>
    <name>VideoWriter</name>
    <message>
        <source>There is not enough memory for a frame of the video.</source>
        <translation>Für ein Einzelbild des Videos reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>A frame of the GIF cannot be created.</source>
        <translation>Ein Einzelbild des GIF kann nicht erstellt werden.</translation>
    </message>
    <message>
        <source>The animation cannot be stored in the video.</source>
        <translation>Die Animation kann nicht im Video gespeichert werden.</translation>
    </message>
    <message>
        <source>A side of %1 pixels is too long for this format; the limit is %2.</source>
        <translation>Eine Seite von %1 Pixeln ist für dieses Format zu lang; die Grenze ist %2.</translation>
    </message>
    <message>
        <source>This format shows at most %1 frames per second. Choose a lower rate.</source>
        <translation>Dieses Format zeigt höchstens %1 Bilder pro Sekunde. Wählen Sie eine niedrigere Rate.</translation>
    </message>
    <message>
        <source>This build of Barycage does not include FFmpeg&apos;s libraries and cannot write videos. Write the frames as PNG pictures instead.</source>
        <translation>Dieses Barycage wurde ohne die Bibliotheken von FFmpeg gebaut und schreibt keine Videos. Schreiben Sie die Einzelbilder stattdessen als PNG-Bilder.</translation>
    </message>
    <message>
        <source>There is not enough memory for the palette of the GIF.</source>
        <translation>Der Speicher reicht für die Palette des GIF nicht aus.</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Recent files and the collection.</source>
        <translation>Die letzten Dateien und die Sammlung.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Continue with</source>
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
        <source>A file or the collection.</source>
        <translation>Eine Datei oder die Sammlung.</translation>
    </message>
    <message>
        <source>Start with</source>
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
        <source>Accepts the settings and closes the dialog.</source>
        <translation>Übernimmt, was der Dialog zeigt, und schließt ihn.</translation>
    </message>
    <message>
        <source>Closes the dialog without changing anything.</source>
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
    <message>
        <source>%1 Panel “%2”: %3</source>
        <comment>what it does, panel, what the panel is for</comment>
        <translation>%1 Feld „%2“: %3</translation>
    </message>
</context>
<context>
    <name>WrittenBanner</name>
    <message>
        <source>Show in Folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Zeigt den Ordner der geschriebenen Datei in der Dateiverwaltung.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Printed to a file</source>
        <translation>In eine Datei gedruckt</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>%1 wurde geschrieben.</translation>
    </message>
</context>
<context>
    <name>document::CageActions</name>
    <message>
        <source>This entry is not a system in the plane, so it has no control cage.</source>
        <translation>Dieser Eintrag ist kein System der Ebene und hat daher keinen Kontrollkäfig.</translation>
    </message>
    <message>
        <source>The cage is too flat to be inverted. Open it by dragging a corner, or reset it, and try again.</source>
        <translation>Der Käfig ist zu flach, um ihn rückgängig zu machen. Öffnen Sie ihn durch Ziehen einer Ecke oder setzen Sie ihn zurück und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The three points are on one line, so they define no coordinates. Click a third point off the line.</source>
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
        <source>Vertex %1 is already there.</source>
        <translation>Die Ecke %1 ist schon dort.</translation>
    </message>
    <message>
        <source>A cage can have at most %1 vertices.</source>
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
        <source>A cage needs at least three vertices.</source>
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
        <source>Unbake: extract the placement from the code</source>
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
        <source>The cage is already the minimal canonical simplex.</source>
        <translation>Der Käfig ist schon das minimale kanonische Simplex.</translation>
    </message>
    <message>
        <source>The cage is already regular.</source>
        <translation>Der Käfig ist schon regelmäßig.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Ecke %1 nach (%2, %3) verschieben</translation>
    </message>
    <message>
        <source>The four points are in one plane, so they define no coordinates. Click the fourth point off the plane.</source>
        <translation>Die vier Punkte liegen in einer Ebene und legen daher keine Koordinaten fest. Klicken Sie den vierten Punkt außerhalb der Ebene.</translation>
    </message>
    <message>
        <source>Define the control tetrahedron</source>
        <translation>Kontrolltetraeder festlegen</translation>
    </message>
</context>
<context>
    <name>document::Document</name>
    <message>
        <source>%1 (frame %2)</source>
        <comment>what is done, at which frame</comment>
        <translation>%1 (Bild %2)</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Dieser Eintrag hat keine Abbildungen der Ebene.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Affin invariante Form</translation>
    </message>
    <message>
        <source>Row j of a matrix contains the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. Dragging the triangle does not change the matrices. If no entry is negative, the map takes the triangle to a part of itself.</source>
        <translation>Zeile j einer Matrix enthält die baryzentrischen Koordinaten des Bildes der Ecke j im Dreieck; jede Zeile hat also die Summe 1. Die Matrizen ändern sich nicht, wenn das Dreieck gezogen wird. Wo kein Eintrag negativ ist, führt die Abbildung das Dreieck in sich über.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Each map as a matrix that acts on barycentric coordinates in the control triangle; every row sums to 1.</source>
        <translation>Jede Abbildung als Matrix, die baryzentrische Koordinaten über dem Kontrolldreieck in baryzentrische Koordinaten überführt: Jede Zeile hat die Summe 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices at full precision.</source>
        <translation>Kopiert das Dreieck und die Matrizen mit allen Stellen.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy includes all of them.
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
        <source>Copy all properties at full precision</source>
        <translation>Alle Kennwerte mit allen Stellen kopieren</translation>
    </message>
    <message>
        <source>This entry could not be read, so it cannot be analysed.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden; es ist nichts von ihm bekannt.</translation>
    </message>
    <message>
        <source>Copy at Full Precision</source>
        <translation>Mit allen Stellen kopieren</translation>
    </message>
    <message>
        <source>Copies the name and the value of every line, at full precision.</source>
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
        <source>Show the mean and the covariance ellipse</source>
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
        <source>Length of the addresses</source>
        <translation>Länge der Adressen</translation>
    </message>
    <message>
        <source>The number of symbols in the addresses of the cylinders; fewer if there would be thousands of cylinders</source>
        <translation>Wie viele Zeichen die Adressen der Zylinder haben; weniger, wo es Tausende wären</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Adresslänge</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system produces a bent picture. These are the properties of the code; on the canvas, the outlines bend with the picture.</source>
        <translation>Der Käfig biegt das Bild, und kein System erzeugt ein gebogenes Bild. Dies sind Kennwerte des Codes; auf der Zeichenfläche werden die Umrisse mit dem Bild gebogen.</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with addresses of the same length, each in the colour of its first map; click one to see its address</source>
        <translation>Die Hüllen aller Teile mit gleich langer Adresse zeichnen, in der Farbe ihrer ersten Abbildung; ein Klick auf eine zeigt ihre Adresse</translation>
    </message>
    <message>
        <source>This value is still being computed.</source>
        <translation>Dieser Wert wird noch berechnet.</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>Branches are moved. Box, simplex, hull, mean and covariance are those of the picture; the other properties are those of the code.</source>
        <translation>Äste sind verschoben. Rechteck, Simplex, Hülle, Mittelwert und Kovarianz sind die des Bildes; die übrigen Kennwerte sind die des Codes.</translation>
    </message>
    <message>
        <source>How Pieces Meet…</source>
        <translation>Wie Teile sich berühren…</translation>
    </message>
    <message>
        <source>Read in the user guide what these properties mean and how they are proved</source>
        <translation>Im Handbuch nachlesen, was diese Eigenschaften bedeuten und wie sie bewiesen werden</translation>
    </message>
    <message>
        <source>Opens the user guide where it explains how the pieces of an attractor meet.</source>
        <translation>Öffnet das Handbuch an der Stelle, die erklärt, wie die Teile eines Attraktors sich berühren.</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Kopiert.</translation>
    </message>
</context>
<context>
    <name>view::AnimationExportDialog</name>
    <message>
        <source>Export the Animation “%1”</source>
        <translation>Animation „%1“ exportieren</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>PNG: one picture for each frame</source>
        <translation>PNG: ein Bild für jeden Zeitpunkt</translation>
    </message>
    <message>
        <source>A video, an animated image for web pages and messages, or one picture for each frame. All of them contain the animation, so Barycage can open them again.</source>
        <translation>Ein Video, ein bewegtes Bild für Seiten und Nachrichten oder ein Bild für jeden Zeitpunkt. Alle enthalten die Animation, und Barycage öffnet sie wieder.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Die Ansicht auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>The whole animation</source>
        <translation>Die ganze Animation</translation>
    </message>
    <message>
        <source>What the frames show where the camera has no keys: the view on the canvas, or everything that becomes visible, with a small margin.</source>
        <translation>Was die Bilder zeigen, wenn kein Schlüssel der Kamera es festlegt: was die Zeichenfläche zeigt, oder alles, was ins Bild kommt, mit kleinem Rand.</translation>
    </message>
    <message>
        <source>&amp;Size in pixels:</source>
        <translation>&amp;Größe in Pixeln:</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>The first frame to export.</source>
        <translation>Das erste Bild, das exportiert wird.</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>The last frame to export.</source>
        <translation>Das letzte Bild, das exportiert wird.</translation>
    </message>
    <message>
        <source>F&amp;rames:</source>
        <translation>&amp;Bilder:</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>The number of points for each pixel of each frame: more points make smoother frames and take longer.</source>
        <translation>Die Zahl der Punkte für jedes Pixel jedes Bildes: mehr Punkte machen die Bilder glatter und brauchen länger.</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Entwurf: 25 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Gut: 100 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Fein: 400 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Feinste: 2000 Punkte je Pixel</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Güte:</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Verschluss</translation>
    </message>
    <message>
        <source>Motion blur: the angle for which the shutter is open around each frame. 180° is half the time of a frame, as in films.</source>
        <translation>Bewegungsunschärfe: der Winkel, um den der Verschluss um jedes Bild herum offen ist. 180° sind die halbe Zeit eines Bildes, wie im Film.</translation>
    </message>
    <message>
        <source>No motion blur</source>
        <translation>Keine Bewegungsunschärfe</translation>
    </message>
    <message>
        <source>S&amp;hutter:</source>
        <translation>Verschl&amp;uss:</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Smooth: no flicker</source>
        <translation>Gleitend: ohne Flackern</translation>
    </message>
    <message>
        <source>Fixed: as in frame 0</source>
        <translation>Fest: die von Bild 0</translation>
    </message>
    <message>
        <source>Each: frame by frame</source>
        <translation>Einzeln: jedes für sich</translation>
    </message>
    <message>
        <source>How bright the frames are: following the whole animation without flicker, all like frame 0, or each as bright as it is on the canvas.</source>
        <translation>Wie hell die Bilder sind: der ganzen Animation ohne Flackern folgend, alle wie Bild 0, oder jedes so hell wie auf der Zeichenfläche.</translation>
    </message>
    <message>
        <source>E&amp;xposure:</source>
        <translation>Bel&amp;ichtung:</translation>
    </message>
    <message>
        <source>Tasks on a cluster</source>
        <translation>Aufgaben auf einem Cluster</translation>
    </message>
    <message>
        <source>How many cluster tasks share the frames when you choose On a Cluster.</source>
        <translation>Auf wie viele Aufgaben eines Clusters die Bilder verteilt werden, wenn Sie „Auf einem Cluster“ wählen.</translation>
    </message>
    <message>
        <source>&amp;Tasks on a cluster:</source>
        <translation>&amp;Aufgaben auf einem Cluster:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the animation. You can continue editing in the meantime: the animation is exported as it was when this dialog opened.</source>
        <translation>Fragt nach einem Dateinamen und schreibt die Animation. Sie können währenddessen weiterarbeiten: Exportiert wird die Animation, wie sie beim Öffnen dieses Dialogs war.</translation>
    </message>
    <message>
        <source>On a &amp;Cluster…</source>
        <translation>Auf einem &amp;Cluster …</translation>
    </message>
    <message>
        <source>Writes a folder with the animation and with scripts that draw it on a Slurm cluster, and submits the job if sbatch is found.</source>
        <translation>Schreibt einen Ordner mit der Animation und mit Skripten, die sie auf einem Slurm-Cluster zeichnen, und reicht ihn ein, wo sbatch gefunden wird.</translation>
    </message>
    <message>
        <source>Export Animation</source>
        <translation>Animation exportieren</translation>
    </message>
    <message>
        <source>Measuring the brightness…</source>
        <translation>Die Helligkeit wird gemessen …</translation>
    </message>
    <message>
        <source>Export stopped. The pictures written so far are complete; export again to draw the others.</source>
        <translation>Export angehalten. Die bisher geschriebenen Bilder sind vollständig; exportieren Sie erneut, um die übrigen zu zeichnen.</translation>
    </message>
    <message>
        <source>Written to %1 and so on, up to %2.</source>
        <translation>Geschrieben nach %1 und so weiter bis %2.</translation>
    </message>
    <message>
        <source>Folder That the Cluster Can Read and Write</source>
        <translation>Ordner, den der Cluster lesen und schreiben kann</translation>
    </message>
    <message>
        <source>Writing the job folder…</source>
        <translation>Der Auftragsordner wird geschrieben …</translation>
    </message>
    <message>
        <source>Cancelled; the folder may be incomplete.</source>
        <translation>Abgebrochen; der Ordner ist vielleicht unvollständig.</translation>
    </message>
    <message>
        <source>The job is in %1. sbatch was not found on this computer: run submit.sh in this folder on the cluster.</source>
        <translation>Der Auftrag ist in %1. Hier gibt es kein sbatch: Führen Sie submit.sh in diesem Ordner auf dem Cluster aus.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>Die Ansicht „%1“</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Bild ohne Attraktor</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Au&amp;sschnitt:</translation>
    </message>
    <message>
        <source>The animation “%1” is still being exported.</source>
        <translation>Die Animation „%1“ wird noch exportiert.</translation>
    </message>
    <message>
        <source>The pictures written so far are complete and will be kept.</source>
        <translation>Die bisher geschriebenen Bilder sind vollständig und bleiben erhalten.</translation>
    </message>
    <message>
        <source>Summary of the export</source>
        <translation>Zusammenfassung des Exports</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), %1 s.</source>
        <translation>
            <numerusform>%n Bild, %1 s.</numerusform>
            <numerusform>%n Bilder, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for existing pictures…</source>
        <translation>Vorhandene Bilder werden gesucht …</translation>
    </message>
    <message>
        <source>Replace Files?</source>
        <translation>Dateien ersetzen?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) with the names of these pictures exist already and hold something else.</source>
        <translation>
            <numerusform>%n Datei mit dem Namen eines dieser Bilder gibt es schon, und sie enthält etwas anderes.</numerusform>
            <numerusform>%n Dateien mit den Namen dieser Bilder gibt es schon, und sie enthalten etwas anderes.</numerusform>
        </translation>
    </message>
    <message>
        <source>The first one is “%1”. If you replace them, their contents are lost.</source>
        <translation>Die erste ist „%1“. Wenn Sie sie ersetzen, ist ihr Inhalt verloren.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>E&amp;rsetzen</translation>
    </message>
    <message>
        <source>Frame of the preview</source>
        <translation>Bild der Vorschau</translation>
    </message>
    <message>
        <source>The frame that the preview shows</source>
        <translation>Das Bild, das die Vorschau zeigt</translation>
    </message>
    <message>
        <source>Choose how many tasks share the frames, then click On a Cluster… again.</source>
        <translation>Wählen Sie, wie viele Aufgaben sich die Bilder teilen, und klicken Sie noch einmal auf „Auf einem Cluster …“.</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Überabtastung</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Zeichnet so viele Pixel längs jeder Seite eines Pixels: glattere Kanten.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>Ü&amp;berabtastung:</translation>
    </message>
    <message>
        <source>%1 needs even sides: the last column or row is shown twice.</source>
        <translation>%1 braucht gerade Seiten: Die letzte Spalte oder Zeile wird doppelt gezeigt.</translation>
    </message>
    <message>
        <source>%1 has no transparency: the background becomes black.</source>
        <translation>%1 kennt keine Transparenz: Der Hintergrund wird schwarz.</translation>
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
        <source>Reset every setting of this panel to its default</source>
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
        <source>Colour by the density of points</source>
        <translation>Die Palette folgt der Dichte der Punkte</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>Colour by the last map applied</source>
        <translation>Die Farbe der zuletzt angewandten Abbildung</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Colour by the address of each point</source>
        <translation>Die Palette folgt der Adresse jedes Punktes</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>One colour, with the density as its opacity</source>
        <translation>Eine Farbe; die Dichte ist ihre Deckkraft</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Einzelfarbe</translation>
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
        <source>How strongly thin parts show: κ of the logarithmic tone curve</source>
        <translation>Wie früh dünne Teile sichtbar werden: κ der logarithmischen Tonkurve</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
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
        <source>Makes the background of exported pictures transparent.</source>
        <translation>Lässt den Hintergrund aus exportierten Bildern weg.</translation>
    </message>
    <message>
        <source>Computes every pixel from several smaller ones: smoother edges, at the cost of memory and time.</source>
        <translation>Zeichnet jedes Pixel aus mehreren feineren: glattere Ränder für mehr Speicher und Zeit.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Färben nach: %1</translation>
    </message>
    <message>
        <source>Palette: %1</source>
        <translation>Palette: %1</translation>
    </message>
    <message>
        <source>Supersampling: %1</source>
        <translation>Überabtastung: %1</translation>
    </message>
    <message>
        <source>More Palettes…</source>
        <translation>Weitere Paletten…</translation>
    </message>
    <message>
        <source>Browse hundreds of palettes, change their hue and shift them</source>
        <translation>Hunderte Paletten durchsehen, drehen und verschieben</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Above 1, light parts become lighter and dark parts darker</source>
        <translation>Über 1 werden helle Teile heller und dunkle dunkler</translation>
    </message>
    <message>
        <source>Above 1, tones lighter than the middle become lighter, and darker ones darker. Below 1, they come closer together. Black, middle and white stay.</source>
        <translation>Über 1 werden Töne, die heller sind als der mittlere, heller und dunklere dunkler. Unter 1 rücken sie zusammen. Schwarz, Mitte und Weiß bleiben.</translation>
    </message>
    <message>
        <source>Vibrancy</source>
        <translation>Leuchtkraft</translation>
    </message>
    <message>
        <source>Below 1, colours are paler, the more so the higher the gamma</source>
        <translation>Unter 1 sind die Farben blasser, umso mehr, je höher das Gamma</translation>
    </message>
    <message>
        <source>At 1, the gamma decides only how strongly a colour shows, and the colour keeps its hue. At 0, the gamma acts on red, green and blue as well, and colours are paler. Flames have the same setting.</source>
        <translation>Bei 1 bestimmt das Gamma nur, wie stark eine Farbe erscheint, und die Farbe behält ihren Farbton. Bei 0 wirkt das Gamma auch auf Rot, Grün und Blau, und die Farben sind blasser. Flames haben dieselbe Einstellung.</translation>
    </message>
    <message>
        <source>What the colour of a point shows: how many points fall there, which map came last, the whole address, or the blend of the colours of all maps applied, as in flames. The position of each map on the palette, and its speed, are in the Maps panel.</source>
        <translation>Was die Farbe eines Punktes sagt: wie viele Punkte dorthin fallen, welche Abbildung zuletzt kam, die ganze Adresse oder die Mischung der Farben aller Abbildungen auf dem Weg, wie bei Flames. Das Bedienfeld „Abbildungen“ hat den Platz jeder Abbildung auf der Palette und ihr Tempo.</translation>
    </message>
    <message>
        <source>Blend of maps</source>
        <translation>Mischung der Abbildungen</translation>
    </message>
    <message>
        <source>As in flames: each map moves colours towards its position on the palette</source>
        <translation>Wie bei Flames: jede Abbildung zieht Farben zu ihrem Platz auf der Palette</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, along the addresses, or along the positions between which maps blend.</source>
        <translation>Die Farben von den dünnsten zu den dichtesten Teilen, die Adressen entlang oder entlang der Plätze, zwischen denen die Abbildungen mischen.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Opacity of the shadow on the ground behind the picture; 0: no shadow</source>
        <translation>Deckkraft des Schattens auf dem Boden hinter dem Bild; 0: kein Schatten</translation>
    </message>
    <message>
        <source>The shadow is the picture once more: darker, flattened, and laid on the ground on which the picture stands. Drag its tip on the canvas to turn it.</source>
        <translation>Der Schatten ist das Bild noch einmal: dunkler, flachgedrückt und auf den Boden gelegt, auf dem das Bild steht. Ziehen Sie auf der Zeichenfläche an seiner Spitze, um ihn zu drehen.</translation>
    </message>
    <message>
        <source>Shadow sideways</source>
        <translation>Schatten seitwärts</translation>
    </message>
    <message>
        <source>How far to the right the shadow of what is 1 high ends; below 0, to the left</source>
        <translation>Wie weit rechts der Schatten dessen endet, was 1 hoch ist; unter 0 links</translation>
    </message>
    <message>
        <source>Shadow backwards</source>
        <translation>Schatten nach hinten</translation>
    </message>
    <message>
        <source>How far up the shadow of what is 1 high ends; below 0, it falls to the front</source>
        <translation>Wie weit oben der Schatten dessen endet, was 1 hoch ist; unter 0 fällt er nach vorn</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The field next to it shows the same value.</source>
        <translation>Ziehen Sie oder benutzen Sie die Pfeiltasten. Die Zahl daneben ist derselbe Wert.</translation>
    </message>
</context>
<context>
    <name>view::AttractorWatch</name>
    <message>
        <source>At frame %1, it could not be decided whether there is an attractor.</source>
        <translation>Bei Bild %1 ließ sich nicht entscheiden, ob es einen Attraktor gibt.</translation>
    </message>
    <message>
        <source>Weaken the motions.</source>
        <translation>Schwächen Sie die Bewegungen ab.</translation>
    </message>
    <message>
        <source>Change the maps.</source>
        <translation>Ändern Sie die Abbildungen.</translation>
    </message>
    <message>
        <source>Weaken the motions, or change the keys of the maps (frames: %1).</source>
        <translation>Schwächen Sie die Bewegungen ab, oder ändern Sie die Schlüssel der Abbildungen (Bilder: %1).</translation>
    </message>
    <message>
        <source>Change the keys of the maps (frames: %1).</source>
        <translation>Ändern Sie die Schlüssel der Abbildungen (Bilder: %1).</translation>
    </message>
    <message>
        <source>Set a key there, or change the keys of the maps (frames: %1).</source>
        <translation>Setzen Sie dort einen Schlüssel, oder ändern Sie die Schlüssel der Abbildungen (Bilder: %1).</translation>
    </message>
    <message>
        <source>At frame %1, there is no attractor.</source>
        <translation>Bei Bild %1 gibt es keinen Attraktor.</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Diagramm der Kästchenzählung</translation>
    </message>
    <message>
        <source>The number of boxes that meet the attractor, against their fineness: log₂ N over k for boxes of side L·2⁻ᵏ, where L is the side of the square around the attractor. Hollow points are not used for the line: at those sizes, the size of the whole or of a cell affects the count.</source>
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
        <source>The number of maps in the address of the branch (Shift + wheel over the canvas)</source>
        <translation>Wie viele Abbildungen der Adresse den Ast benennen (Umschalt + Rad über der Zeichenfläche)</translation>
    </message>
    <message>
        <source>The address of the clicked point, outermost map first; the bold part is the address of the branch</source>
        <translation>Die Adresse des angeklickten Punktes, äußerste Abbildung zuerst; der fette Teil ist die Adresse des Astes</translation>
    </message>
    <message>
        <source>New map for this branch</source>
        <translation>Neue Abbildung für diesen Ast</translation>
    </message>
    <message>
        <source>Gives this branch and each of its sibling branches a map of its own. The change appears again at all smaller scales.</source>
        <translation>Dieser Ast und jeder Ast daneben bekommt eine eigene Abbildung. Die Änderung zeigt sich auch in allen kleineren Größen.</translation>
    </message>
    <message>
        <source>Last map of the address</source>
        <translation>Letzte Abbildung der Adresse</translation>
    </message>
    <message>
        <source>The system keeps its number of maps. All branches that this map makes change in the same way.</source>
        <translation>Die Zahl der Abbildungen bleibt gleich. Alle Äste, die diese Abbildung erzeugt, ändern sich gleich.</translation>
    </message>
    <message>
        <source>What editing the branch changes</source>
        <translation>Was eine Änderung des Astes bewirkt</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Winkel, um den die gewählten Abbildungen um ihre Wurzeln schwingen</translation>
    </message>
    <message>
        <source>Swings the selected maps, each about the image of the lowest point of the fractal; the slider returns to the middle when you release it</source>
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
        <source>Swing maps</source>
        <translation>Abbildungen schwingen lassen</translation>
    </message>
    <message>
        <source>Only here</source>
        <translation>Nur hier</translation>
    </message>
    <message>
        <source>The code does not change. Only this branch is shown in another position; the same change does not appear at other scales.</source>
        <translation>Der Code ändert sich nicht. Nur dieser Ast wird anderswo gezeigt; in anderen Größen wiederholt sich die Änderung nicht.</translation>
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
        <source>Shows the branch in its original position, given by its maps</source>
        <translation>Zeigt den Ast dort, wohin ihn seine Abbildungen legen</translation>
    </message>
    <message>
        <source>Shows all branches in their original positions, given by their maps</source>
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
    <message>
        <source>What changes in the code when you drag the branch</source>
        <translation>Was sich im Code ändert, wenn Sie den Ast ziehen</translation>
    </message>
    <message>
        <source>Here and inside it</source>
        <translation>Hier und darin</translation>
    </message>
    <message>
        <source>The code does not change. This branch is shown in another position, and so is the same branch inside it, again and again: a frond curls up. Nothing beside it changes.</source>
        <translation>Der Code ändert sich nicht. Dieser Ast wird an anderer Stelle gezeigt, und ebenso derselbe Ast in ihm, immer wieder: Ein Wedel rollt sich ein. Daneben ändert sich nichts.</translation>
    </message>
    <message>
        <source>Maps cannot swing while the cage is flat. First open or reset the cage.</source>
        <translation>Abbildungen können nicht schwingen, solange der Käfig flach ist. Öffnen Sie ihn erst oder setzen Sie ihn zurück.</translation>
    </message>
    <message>
        <source>S&amp;wing</source>
        <translation>Sch&amp;wingen</translation>
    </message>
</context>
<context>
    <name>view::BranchChoice</name>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Klicken Sie auf einen Punkt des Attraktors, um seinen Ast zu wählen.</translation>
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
        <source>Move corner %1 of branch %2</source>
        <translation>Ecke %1 des Astes %2 bewegen</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Ast %1 bewegen</translation>
    </message>
    <message>
        <source>This branch is now map 1. You can change it further in the table.</source>
        <translation>Dieser Ast ist jetzt Abbildung 1. Zahlen in der Tabelle ändern ihn weiter.</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Angehalten: Darüber hinaus würde der Ast in sich selbst nicht kleiner.</translation>
    </message>
</context>
<context>
    <name>view::CageFitter</name>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>Das Bild ist zu dünn für einen solchen Käfig.</translation>
    </message>
    <message>
        <source>The cage already has this shape.</source>
        <translation>Der Käfig ist schon dort.</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Den Käfig anpassen</translation>
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
        <source>Moving the cage moves the picture; the code does not change</source>
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
        <source>The picture follows every vertex and bends; a bent picture cannot be baked into the code</source>
        <translation>Jeder Ecke wird gefolgt; das Bild biegt sich, was sich nicht in einen Code einrechnen lässt</translation>
    </message>
    <message>
        <source>The picture follows the vertices by the closest affine map; it can be baked</source>
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
        <source>Define the triangle with three clicks on the canvas; the picture stays</source>
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
        <source>Show the positions of the vertices when the cage is at rest</source>
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
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from the right angle.</source>
        <translation>Das kleinste gleichschenklig-rechtwinklige Dreieck mit achsenparallelen Katheten, das das Bild enthält. Die Vorzeichen sagen, nach welcher Seite seine Katheten vom rechten Winkel aus zeigen.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Baryzentrische Koordinaten eines Punktes</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 for which the point is the weighted mean of the vertices.</source>
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
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Die drei Punkte liegen auf einer Geraden: Der Ruhekäfig muss eine Fläche umschließen.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>Der Ruhekäfig muss ein Vieleck sein, das sich nicht überkreuzt.</translation>
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
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden und hat daher keinen Käfig.</translation>
    </message>
    <message>
        <source>At rest: the picture shows the code.</source>
        <translation>In Ruhe: Das Bild ist das des Codes.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture shows the code.</source>
        <translation>%1 Ecken, in Ruhe: Das Bild ist das des Codes.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates; cannot be baked.</source>
        <translation>%1 Ecken: mit Wachspress-Koordinaten gebogen, nicht einrechenbar.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates; cannot be baked.</source>
        <translation>%1 Ecken: mit Mittelwertkoordinaten gebogen, nicht einrechenbar.</translation>
    </message>
    <message>
        <source>Flat: the picture is squeezed onto a line. Open the cage to get it back.</source>
        <translation>Flach: Das Bild liegt auf einer Geraden. Öffnen Sie den Käfig, und es kommt wieder.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the orientation is reversed.</source>
        <translation>Platziert und gespiegelt: Flächen ändern sich um den Faktor %1, und der Drehsinn kehrt sich um.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Platziert: Flächen ändern sich um den Faktor %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it defines no coordinates.</source>
        <translation>Das Dreieck ist flach: Es trägt keine Koordinaten.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, Kathete %2, Ecke (%3, %4)</translation>
    </message>
    <message>
        <source>Replace the cage by one fitted to the picture; the picture stays</source>
        <translation>Das Bild mit einem angepassten Käfig halten; das Bild bleibt</translation>
    </message>
    <message>
        <source>Return the cage and the picture to rest</source>
        <translation>Käfig und Bild zurück in die Ruhelage bringen</translation>
    </message>
    <message>
        <source>Write the displayed picture into the code; the cage is then at rest</source>
        <translation>Das gezeigte Bild zum Code machen; der Käfig ruht danach</translation>
    </message>
    <message>
        <source>Available for triangles only.</source>
        <translation>Nur für Dreiecke verfügbar.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Ecke %1 nach (%2, %3) verschieben</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3)</source>
        <translation>Ecke %1 bei (%2, %3) festlegen</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>z at rest</source>
        <translation>z in Ruhe</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from their common corner.</source>
        <translation>Das kleinste Tetraeder mit drei gleich langen achsenparallelen Kanten an einer Ecke, das das Bild enthält. Die Vorzeichen sagen, wohin diese Kanten von ihrer gemeinsamen Ecke aus zeigen.</translation>
    </message>
    <message>
        <source>The weights a, b, c, d with a + b + c + d = 1 for which the point is the weighted mean of the vertices.</source>
        <translation>Die Gewichte a, b, c, d mit a + b + c + d = 1, für die der Punkt der Schwerpunkt der Ecken ist.</translation>
    </message>
    <message>
        <source>z of the point</source>
        <translation>z des Punkts</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3, %4)</source>
        <translation>Ecke %1 nach (%2, %3, %4) bewegen</translation>
    </message>
    <message>
        <source>The vertices are in one plane: the rest cage must enclose a volume.</source>
        <translation>Die Ecken liegen in einer Ebene: Der ruhende Käfig muss ein Volumen umschließen.</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3, %4)</source>
        <translation>Ecke %1 bei (%2, %3, %4) festlegen</translation>
    </message>
    <message>
        <source>Flat: the solid is squeezed onto a plane or a line. Open the cage to get it back.</source>
        <translation>Flach: Der Körper ist auf eine Ebene oder Gerade gedrückt. Öffnen Sie den Käfig, und er kommt zurück.</translation>
    </message>
    <message>
        <source>Placed and mirrored: volumes change by the factor %1, and the orientation is reversed.</source>
        <translation>Platziert und gespiegelt: Volumen ändern sich um den Faktor %1, und die Orientierung ist umgekehrt.</translation>
    </message>
    <message>
        <source>Placed: volumes change by the factor %1.</source>
        <translation>Platziert: Volumen ändern sich um den Faktor %1.</translation>
    </message>
    <message>
        <source>Available for tetrahedra only.</source>
        <translation>Nur für Tetraeder verfügbar.</translation>
    </message>
    <message>
        <source>The tetrahedron is flat: it defines no coordinates.</source>
        <translation>Das Tetraeder ist flach: Es legt keine Koordinaten fest.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Dieses System hat keinen Attraktor, der eingeschlossen werden kann.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4, %5)</source>
        <translation>%1, Kante %2, Ecke (%3, %4, %5)</translation>
    </message>
    <message>
        <source>The system has very many maps. Computing the cage around it…</source>
        <translation>Das System hat sehr viele Abbildungen: Der Käfig darum wird gerade gesucht …</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, cannot be baked.</source>
        <translation>%1 Ecken: mit Mittelwertkoordinaten gebogen, nicht einrechenbar.</translation>
    </message>
    <message>
        <source>Define the tetrahedron with four clicks on the canvas; the picture stays</source>
        <translation>Legt das Tetraeder mit vier Klicks auf der Zeichenfläche fest; das Bild bleibt</translation>
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
        <source>Select a corner first.</source>
        <translation>Erst eine Ecke wählen.</translation>
    </message>
    <message>
        <source>To insert a corner, point to an edge or select a corner.</source>
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
        <source>No attractor: the maps %1, applied one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Kein Attraktor: Die Abbildungen %1, nacheinander angewandt, kontrahieren nicht (größter Singulärwert %2, Spektralradius %3). Verkleinern Sie eine davon oder schalten Sie sie aus.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor: map %1 stretches by up to %2. Points that escape are left out.</source>
        <translation>Ob dieses System einen Attraktor hat, steht nicht fest: Abbildung %1 streckt um %2. Punkte, die davonlaufen, werden weggelassen.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor. Points that escape are left out.</source>
        <translation>Ob dieses System einen Attraktor hat, steht nicht fest. Punkte, die davonlaufen, werden weggelassen.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept unchanged in the file.</source>
        <translation>Dieser Eintrag konnte nicht gelesen werden. Sein Text bleibt in der Datei, wie er ist.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Keine Abbildung ist aktiv; es gibt nichts zu zeichnen. Fügen Sie eine hinzu oder schalten Sie eine ein.</translation>
    </message>
    <message>
        <source>This is the limit of numerical precision: zoom out a little for an accurate picture.</source>
        <translation>Tiefer reicht die Arithmetik nicht: Verkleinern Sie ein wenig für ein wahres Bild.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than requested: more would exceed the memory limit.</source>
        <translation>Mit weniger Iterationen gezeichnet als verlangt: Mehr bräuchten mehr Speicher als erlaubt.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a corner to open it: nothing is lost.</source>
        <translation>Der Käfig ist flach und das Bild auch. Ziehen Sie eine Ecke, um ihn zu öffnen: Nichts geht verloren.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Angehalten: Weiter würde Abbildung %1 nicht kontrahieren (größter Singulärwert %2, Spektralradius %3), und es gäbe keinen Attraktor.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, the maps %1, applied one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Angehalten: Weiter würden die Abbildungen %1, nacheinander angewandt, nicht kontrahieren (größter Singulärwert %2, Spektralradius %3), und es gäbe keinen Attraktor.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, an attractor is not guaranteed (map %1 has the largest singular value, %2).</source>
        <translation>Angehalten: Darüber hinaus ist ein Attraktor nicht gesichert (Abbildung %1 hat den größten Singulärwert, %2).</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point is left.</source>
        <translation>Bei einer einzigen Abbildung bleibt nur ihr Fixpunkt.</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point (%1, %2) is left.</source>
        <translation>Bei einer einzigen Abbildung bleibt nur ihr Fixpunkt (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is switched on has a positive weight, so there is nothing to draw. Give one of them a weight.</source>
        <translation>Keine eingeschaltete Abbildung hat ein Gewicht über 0; es gibt nichts zu zeichnen. Geben Sie einer ein Gewicht.</translation>
    </message>
    <message>
        <source>Whether this system has an attractor is undecided.</source>
        <translation>Ob dieses System einen Attraktor hat, ist nicht entschieden.</translation>
    </message>
    <message>
        <source>This system has no attractor, so the picture may be incomplete or empty.</source>
        <translation>Dieses System hat keinen Attraktor, deshalb kann das Bild unvollständig oder leer sein.</translation>
    </message>
    <message>
        <source>So many pieces overlap that parts of this solid may be missing. The look Cloud shows all of it.</source>
        <translation>So viele Teile liegen übereinander, dass Stücke dieses Körpers fehlen können. Die Darstellung „Wolke“ zeigt ihn ganz.</translation>
    </message>
    <message>
        <source>What lies far behind this small view may be drawn in the wrong order. Zoom out a little for an accurate picture.</source>
        <translation>Was weit hinter diesem kleinen Ausschnitt liegt, kann in falscher Reihenfolge erscheinen. Verkleinern Sie ein wenig für ein wahres Bild.</translation>
    </message>
    <message>
        <source>Nothing here. Press %1 to see the whole picture.</source>
        <translation>Hier ist nichts. Drücken Sie %1, um das ganze Bild zu sehen.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Den Käfig zu bewegen schreibt den Code um</translation>
    </message>
</context>
<context>
    <name>view::CanvasInput</name>
    <message>
        <source>Cylinder %1</source>
        <translation>Zylinder %1</translation>
    </message>
    <message>
        <source>Corner outside the view: click to fit the picture and its cage</source>
        <translation>Ecke außerhalb der Ansicht: ein Klick passt Bild und Käfig ein</translation>
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
        <source>Lets you type the coordinates of this vertex</source>
        <translation>Koordinaten dieser Ecke eingeben</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>Diese Ecke &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Returns this vertex to its position at rest</source>
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
        <source>Removes this vertex from the cage</source>
        <translation>Diese Ecke aus dem Käfig nehmen</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>&amp;Drehpunkt hierher setzen</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about this vertex</source>
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
        <source>Inserts a vertex on this edge; double-clicking does the same</source>
        <translation>Eine weitere Ecke auf diese Kante setzen; ein Doppelklick tut dasselbe</translation>
    </message>
    <message>
        <source>Rotate: hold Shift for steps of 15°</source>
        <translation>Drehen: Umschalt dreht in Schritten von 15°</translation>
    </message>
    <message>
        <source>Scale: hold Shift for x or y only</source>
        <translation>Skalieren: Umschalt bleibt bei x oder y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Centre</source>
        <translation>&amp;Drehpunkt in die Mitte setzen</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about its centre</source>
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
        <source>Fits the smallest isosceles right triangle with legs parallel to the axes around the picture</source>
        <translation>Das kleinste gleichschenklig-rechtwinklige Dreieck mit achsenparallelen Katheten um das Bild legen</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Dreieck festlegen</translation>
    </message>
    <message>
        <source>Defines the triangle with three clicks; the picture stays</source>
        <translation>Das Bild an drei angeklickten Punkten halten</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>Käfig &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Returns every vertex to its position at rest</source>
        <translation>Jede Ecke in die Ruhelage zurückbringen</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Re&amp;gelmäßig machen</translation>
    </message>
    <message>
        <source>Moves the vertices to the nearest regular polygon</source>
        <translation>Die Ecken auf das nächste regelmäßige Vieleck setzen</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw the picture as shown, with the cage at rest</source>
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
        <source>Shows one unit of the plane as one hundred pixels</source>
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
        <source>Points the y axis down, as in window coordinates</source>
        <translation>Die y-Achse nach unten richten, wie in Fensterkoordinaten</translation>
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
        <source>Copies the picture as shown, without the cage</source>
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
        <source>Switches this map on or off</source>
        <translation>Diese Abbildung ein- oder ausschalten</translation>
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
        <source>Adds a copy of this map</source>
        <translation>Eine Kopie dieser Abbildung hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Removes this map from the system</source>
        <translation>Diese Abbildung aus dem System nehmen</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>&amp;Freigeben</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Sperren</translation>
    </message>
    <message>
        <source>Lets this map be edited again</source>
        <translation>Lässt diese Abbildung wieder ändern</translation>
    </message>
    <message>
        <source>Locks this map against editing</source>
        <translation>Schützt diese Abbildung vor Änderungen</translation>
    </message>
    <message>
        <source>&amp;Reset Rotation</source>
        <translation>D&amp;rehung zurücksetzen</translation>
    </message>
    <message>
        <source>Returns the view to upright</source>
        <translation>Richtet die Ansicht wieder auf</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Einrechnen</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab moves from handle to handle, the arrow keys move the handle in focus, F6 leaves the canvas.</source>
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
        <source>Reset the cage first?</source>
        <translation>Den Käfig zuerst in die Ruhelage zurückbringen?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Käfig zurücksetzen</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press %1 to see the cage again.</source>
        <translation>Nur das Bild wird gezeigt. Drücken Sie %1, um den Käfig wieder zu sehen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; hold Ctrl to rotate, Alt to scale, Shift to keep directions. The wheel zooms at the pointer, the middle button pans. Tab moves from handle to handle, the arrow keys move the handle, F6 leaves the canvas.</source>
        <translation>Das Bild und sein Käfig. Ziehen Sie eine Ecke, eine Kante oder das Innere des Käfigs; Strg dreht, Alt skaliert, Umschalt hält Richtungen. Das Rad zoomt am Zeiger, die mittlere Taste bewegt die Ebene. Tab geht von Griff zu Griff, die Pfeiltasten bewegen sie, F6 verlässt die Fläche.</translation>
    </message>
</context>
<context>
    <name>view::ClusterQueue</name>
    <message>
        <source>%1 running</source>
        <translation>%1 laufen</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 warten</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 fehlgeschlagen</translation>
    </message>
    <message>
        <source>Drawing: %1.</source>
        <translation>Zeichnen: %1.</translation>
    </message>
    <message>
        <source>Video: done.</source>
        <translation>Video: fertig.</translation>
    </message>
    <message>
        <source>Video: failed.</source>
        <translation>Video: fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Video: running.</source>
        <translation>Video: läuft.</translation>
    </message>
    <message>
        <source>Video: waiting.</source>
        <translation>Video: wartet.</translation>
    </message>
    <message>
        <source>Submitting…</source>
        <translation>Wird eingereicht …</translation>
    </message>
    <message>
        <source>The script ended without submitting anything.</source>
        <translation>Das Skript endete, ohne etwas einzureichen.</translation>
    </message>
    <message>
        <source>The result is in %1.</source>
        <translation>Das Ergebnis ist in %1.</translation>
    </message>
    <message>
        <source>The reason is in the logs in %1.</source>
        <translation>Der Grund steht in den Protokollen in %1.</translation>
    </message>
    <message>
        <source>Slurm did not accept the job: %1</source>
        <translation>Slurm hat den Auftrag nicht angenommen: %1</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 von %2 fertig</translation>
    </message>
</context>
<context>
    <name>view::CollageNumbers</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 px</source>
        <comment>pixels</comment>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>The part of the target that is covered</source>
        <translation>Der Anteil des Ziels, der bedeckt ist</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Überschuss</translation>
    </message>
    <message>
        <source>Overlap (IoU)</source>
        <translation>Überlappung (IoU)</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Mittlerer Abstand</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % innerhalb</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>The Hausdorff distance; the mark on the canvas shows where it is</source>
        <translation>Der Hausdorff-Abstand; die Marke auf der Zeichenfläche zeigt, wo er ist</translation>
    </message>
    <message>
        <source>%1 (s = %2)</source>
        <translation>%1 (s = %2)</translation>
    </message>
    <message>
        <source>none: a map stretches by %1</source>
        <translation>keine: eine Abbildung streckt um %1</translation>
    </message>
    <message>
        <source>No point of the target is farther from the attractor than this, and no point of the attractor from the target. The value is larger during a drag, when a coarser picture is measured</source>
        <translation>Kein Punkt des Ziels ist weiter vom Attraktor entfernt als so, und umgekehrt. Während Sie ziehen, ist sie größer, weil ein gröberes Bild gemessen wird</translation>
    </message>
    <message>
        <source>%1 (ellipsoidal norm, γ = %2)</source>
        <translation>%1 (ellipsoidische Norm, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (polytope norm, γ = %2)</source>
        <translation>%1 (Polytopnorm, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (any %2 maps in a row contract, γ = %3)</source>
        <translation>%1 (je %2 Abbildungen hintereinander kontrahieren, γ = %3)</translation>
    </message>
    <message>
        <source>The area covered outside the target, relative to the area of the target</source>
        <translation>Die überdeckte Fläche außerhalb des Ziels, als Anteil der Fläche des Ziels</translation>
    </message>
    <message>
        <source>The area that both cover, relative to the area that either covers</source>
        <translation>Die Fläche, die beide überdecken, als Anteil der Fläche, die mindestens eines überdeckt</translation>
    </message>
    <message>
        <source>How often the images of the maps cover the same places: their areas together, divided by the area that they cover. It is 1 where no two of them overlap</source>
        <translation>Wie oft die Bilder der Abbildungen dieselben Stellen bedecken: ihre Flächen zusammen, geteilt durch die Fläche, die sie bedecken. Es ist 1, wenn keine zwei sich überlappen</translation>
    </message>
    <message>
        <source>95 % of all points are within this distance of the other shape</source>
        <translation>95 % aller Punkte sind höchstens so weit von der anderen Form entfernt</translation>
    </message>
    <message>
        <source>From each point to the nearest point of the other shape, in pixels of the picture as it is traced</source>
        <translation>Von jedem Punkt zum nächsten Punkt der anderen Form, in Pixeln des Bildes, wie es nachgezeichnet wird</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Mean distance of the collage: %1 → %2.</source>
        <translation>Mittlerer Abstand der Collage: %1 → %2.</translation>
    </message>
    <message>
        <source>Mean distance of the attractor: %1 → %2.</source>
        <translation>Mittlerer Abstand des Attraktors: %1 → %2.</translation>
    </message>
    <message>
        <source>Guarantee: %1 → %2.</source>
        <translation>Garantie: %1 → %2.</translation>
    </message>
    <message>
        <source>The distance has increased, but the overlap (IoU) has improved.</source>
        <translation>Der Abstand ist größer geworden, aber die Überlappung (IoU) besser.</translation>
    </message>
    <message>
        <source>Nothing is guaranteed any more.</source>
        <translation>Garantiert ist nichts mehr.</translation>
    </message>
    <message>
        <source>The guarantee is now weaker.</source>
        <translation>Die Garantie ist jetzt schwächer.</translation>
    </message>
    <message>
        <source>Overlap of the maps</source>
        <translation>Überlappung der Abbildungen</translation>
    </message>
    <message>
        <source>Guaranteed within</source>
        <translation>Garantiert innerhalb</translation>
    </message>
</context>
<context>
    <name>view::CollagePanel</name>
    <message>
        <source>Use Suggestion</source>
        <translation>Vorschlag verwenden</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Abbildungen verbessern</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Attraktor verbessern</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Gewichte anpassen</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Käfig anpassen</translation>
    </message>
    <message>
        <source>Add Map</source>
        <translation>Abbildung hinzufügen</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Collage</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Übereinstimmung</translation>
    </message>
    <message>
        <source>of the collage</source>
        <translation>der Collage</translation>
    </message>
    <message>
        <source>of the attractor</source>
        <translation>des Attraktors</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>nicht gezeigt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>The maps do not contract, so there is no attractor to compare.</source>
        <translation>Die Abbildungen ziehen nicht zusammen; es gibt keinen Attraktor zum Vergleichen.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
    <message numerus="yes">
        <source>%n suggestions. Click one to use it.</source>
        <translation>
            <numerusform>%n Vorschlag. Klicken Sie ihn an, um ihn zu verwenden.</numerusform>
            <numerusform>%n Vorschläge. Klicken Sie einen an, um ihn zu verwenden.</numerusform>
        </translation>
    </message>
    <message>
        <source>The fractal has changed meanwhile, so the result was not used.</source>
        <translation>Das Fraktal hat sich inzwischen geändert; das Ergebnis wurde nicht verwendet.</translation>
    </message>
    <message>
        <source>No better agreement was found.</source>
        <translation>Es wurde nichts gefunden, das besser übereinstimmt.</translation>
    </message>
    <message>
        <source>Guarantee for the shades</source>
        <translation>Garantie für die Helligkeiten</translation>
    </message>
    <message>
        <source>Moved by at most this distance on average, the shades of the attractor become those of the picture</source>
        <translation>Im Mittel um höchstens diesen Abstand verschoben, werden die Helligkeiten des Attraktors zu denen des Bildes</translation>
    </message>
    <message>
        <source>On average, the shades of the attractor are guaranteed to lie within %1 px of those of the picture.</source>
        <translation>Im Mittel liegen die Helligkeiten des Attraktors garantiert höchstens %1 px von denen des Bildes entfernt.</translation>
    </message>
    <message>
        <source>With these weights, the maps do not contract on average, so nothing is guaranteed for the shades.</source>
        <translation>Mit diesen Gewichten ziehen die Abbildungen im Mittel nicht zusammen; für die Helligkeiten ist nichts garantiert.</translation>
    </message>
    <message>
        <source>Choose what the canvas compares with the target</source>
        <translation>Wählen, was die Zeichenfläche mit dem Ziel vergleicht</translation>
    </message>
    <message>
        <source>Compares the target with its images under the maps, or with the attractor. Agreement is grey, excess red, and missing parts blue.</source>
        <translation>Vergleicht das Ziel mit seinen Bildern unter den Abbildungen oder mit dem Attraktor. Gemeinsames ist grau, Überschüssiges rot, Fehlendes blau.</translation>
    </message>
    <message>
        <source>Result of refining</source>
        <translation>Ergebnis der Verbesserung</translation>
    </message>
    <message>
        <source>What the last refinement has made of the distance and of the guarantee</source>
        <translation>Was die letzte Verbesserung aus dem Abstand und der Garantie gemacht hat</translation>
    </message>
    <message>
        <source>1. Choose a picture</source>
        <translation>1. Bild wählen</translation>
    </message>
    <message>
        <source>2. Ask for suggestions</source>
        <translation>2. Vorschlagen lassen</translation>
    </message>
    <message>
        <source>3. Pick one</source>
        <translation>3. Einen Vorschlag wählen</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>More ways to trace</source>
        <translation>Weiteres zum Nachzeichnen</translation>
    </message>
    <message>
        <source>Show how the picture is read, the agreement, and what refines a suggestion</source>
        <translation>Zeigt, wie das Bild gelesen wird, die Übereinstimmung und was einen Vorschlag verfeinert</translation>
    </message>
    <message>
        <source>Another picture is shown, so the search for the last one was cancelled.</source>
        <translation>Ein anderes Bild ist zu sehen, darum wurde die Suche für das vorige abgebrochen.</translation>
    </message>
</context>
<context>
    <name>view::CollectionGrid</name>
    <message>
        <source>Fractals of the collection</source>
        <translation>Fraktale der Sammlung</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>No favourites yet. Select a fractal and press Ctrl+D.</source>
        <translation>Noch keine Favoriten. Wählen Sie ein Fraktal und drücken Sie Strg+D.</translation>
    </message>
    <message>
        <source>Fractals that you use appear here.</source>
        <translation>Fraktale, die Sie verwenden, erscheinen hier.</translation>
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
    <message>
        <source>solid 3D space</source>
        <comment>words of a search</comment>
        <translation>Körper 3D Raum räumlich</translation>
    </message>
    <message>
        <source>moving animation motion</source>
        <comment>words of a search</comment>
        <translation>bewegt Bewegung Animation</translation>
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
        <source>Open the selected fractal as a separate document.</source>
        <translation>Das gewählte Fraktal als eigenes Dokument öffnen.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>Zu dieser D&amp;atei hinzufügen</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Das gewählte Fraktal der offenen Datei hinzufügen.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>Fa&amp;vorit</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites.</source>
        <translation>Das gewählte Fraktal als Favoriten merken.</translation>
    </message>
    <message>
        <source>Fa&amp;vourites Only</source>
        <translation>Nur Fa&amp;voriten</translation>
    </message>
    <message>
        <source>Show only your favourites.</source>
        <translation>Nichts als die Favoriten zeigen.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>&amp;Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>Add the .ifs files of one of your own folders to this list.</source>
        <translation>Auch die .ifs-Dateien eines eigenen Ordners hier zeigen.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>Ordner „%1“ &amp;entfernen</translation>
    </message>
    <message>
        <source>Remove this folder from the list. Its files are not changed.</source>
        <translation>Diesen Ordner aus der Liste entfernen. Seine Dateien bleiben unverändert.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Ordner mit .ifs-Dateien</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>Zeigt nur die Fraktale, deren Name, Thema oder Kommentar diese Wörter enthält. Eingabe öffnet das erste davon.</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it in this window; right-click it to add it to the file instead.</source>
        <translation>Fraktale zum Anfangen. Doppelklick oder Eingabe öffnet eines in diesem Fenster; das Menü der rechten Taste fügt es stattdessen der Datei hinzu.</translation>
    </message>
    <message>
        <source>Progress of reading the collection</source>
        <translation>Gelesene Dateien der Sammlung</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Nicht weiter lesen</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Die Sammlung wird gelesen …</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen …</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Das ausgewählte Fraktal zur geöffneten Datei hinzufügen oder öffnen, wenn noch nichts bearbeitet wurde.</translation>
    </message>
    <message>
        <source>&amp;Open as New Document</source>
        <translation>Als &amp;neues Dokument öffnen</translation>
    </message>
    <message>
        <source>Stop reading this folder; files that were already read stay in the list</source>
        <translation>Diesen Ordner nicht weiter lesen; was schon gelesen ist, bleibt in der Liste</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchblättern…</translation>
    </message>
    <message>
        <source>Show the collection over the whole window, in large pictures.</source>
        <translation>Die Sammlung über das ganze Fenster zeigen, in großen Bildern.</translation>
    </message>
    <message>
        <source>&amp;Recent Only</source>
        <translation>Nur &amp;zuletzt verwendete</translation>
    </message>
    <message>
        <source>Show only the fractals that you used last.</source>
        <translation>Nur die zuletzt verwendeten Fraktale zeigen.</translation>
    </message>
</context>
<context>
    <name>view::CollectionWindow</name>
    <message>
        <source>Collection</source>
        <translation>Sammlung</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it. Those with a triangle in the corner move under the pointer.</source>
        <translation>Fertige Fraktale. Ein Doppelklick oder die Eingabetaste öffnet eines. Die mit einem Dreieck in der Ecke bewegen sich unter dem Zeiger.</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Die Sammlung durchsuchen</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>Zeigt nur die Fraktale, deren Name, Thema oder Kommentar diese Wörter enthält. Eingabe öffnet das erste davon.</translation>
    </message>
    <message>
        <source>Themes</source>
        <translation>Themen</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites (Ctrl+D)</source>
        <translation>Das ausgewählte Fraktal zu den Favoriten hinzufügen (Strg+D)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Das ausgewählte Fraktal zur geöffneten Datei hinzufügen oder öffnen, wenn noch nichts bearbeitet wurde.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>Zu dieser D&amp;atei hinzufügen</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Das gewählte Fraktal der offenen Datei hinzufügen.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoriten</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt verwendet</translation>
    </message>
    <message>
        <source>Double-click a fractal to open it.</source>
        <translation>Ein Doppelklick auf ein Fraktal öffnet es.</translation>
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
        <source>a b e c d f p: one equation after the other</source>
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
        <source>a b c d e f, and cumulative weights</source>
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
        <source>Column names in order</source>
        <translation>Namen der Spalten in ihrer Reihenfolge</translation>
    </message>
    <message>
        <source>The names of the columns in order: a b c d or r s theta phi, then e and f, each once; if there are weights, also p, or cumulative for running sums of weights. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Die Namen der Spalten in ihrer Reihenfolge: a b c d oder r s theta phi, dazu e und f, jeder einmal, und p für ein Gewicht oder cumulative für eine Summe von Gewichten, wo es sie gibt. x′ = a·x + b·y + e und y′ = c·x + d·y + f.</translation>
    </message>
    <message>
        <source>The names of the columns in their order, such as a b c d e f p</source>
        <translation>Die Namen der Spalten in ihrer Reihenfolge, etwa a b c d e f p</translation>
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
        <source>Type some letters of what you want to do. The arrow keys select a command, Enter runs it.</source>
        <translation>Tippen Sie ein paar Buchstaben von dem, was Sie tun möchten. Die Pfeiltasten wählen, die Eingabetaste führt aus.</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Keine passenden Befehle</translation>
    </message>
    <message>
        <source>Commands whose names contain these words come first, then those whose descriptions do.</source>
        <translation>Die Befehle, deren Namen diese Wörter haben, dann die, deren Beschreibungen sie haben.</translation>
    </message>
    <message>
        <source>Search the guide for “%1”</source>
        <translation>Im Handbuch nach „%1“ suchen</translation>
    </message>
</context>
<context>
    <name>view::CommandSynonyms</name>
    <message>
        <source>render save image picture png svg pdf jpeg tiff webp exr poster wallpaper stl obj ply glb mesh print 3d laser plotter cutter engrave dxf outline vector transparent millimetres</source>
        <translation>rendern speichern Bild png svg pdf jpeg tiff Poster Plakat Hintergrundbild stl obj ply Netz 3d-Druck Laser Plotter Schneideplotter gravieren dxf Umriss Vektor transparent durchsichtig Millimeter</translation>
    </message>
    <message>
        <source>render video movie film mp4 webm gif apng frames cluster slurm</source>
        <translation>rendern Video Film mp4 webm gif apng Einzelbilder Rechencluster slurm</translation>
    </message>
    <message>
        <source>flame apophysis csv table points cloud ply ifstile save</source>
        <translation>flame apophysis csv Tabelle Punkte Punktwolke ply ifstile speichern</translation>
    </message>
    <message>
        <source>clipboard screenshot image</source>
        <translation>Zwischenablage Bildschirmfoto Bild kopieren</translation>
    </message>
    <message>
        <source>paper printer pdf page</source>
        <translation>Papier Drucker pdf Seite ausdrucken</translation>
    </message>
    <message>
        <source>surprise chance lucky generate dice new</source>
        <translation>Überraschung Zufall erzeugen Würfel neu</translation>
    </message>
    <message>
        <source>mirror reflect reverse</source>
        <translation>spiegeln umdrehen kippen</translation>
    </message>
    <message>
        <source>mirror reflect upside down</source>
        <translation>spiegeln umdrehen auf den Kopf kippen</translation>
    </message>
    <message>
        <source>hull triangle tight smallest</source>
        <translation>Hülle Dreieck eng kleinstes</translation>
    </message>
    <message>
        <source>apply freeze write flatten</source>
        <translation>anwenden einfrieren schreiben</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>kopieren klonen</translation>
    </message>
    <message>
        <source>centre home whole zoom all</source>
        <translation>zentrieren alles ganze Ansicht</translation>
    </message>
    <message>
        <source>maximise whole</source>
        <translation>maximieren Vollbild</translation>
    </message>
    <message>
        <source>3d extrude solid</source>
        <translation>3d extrudieren Körper dritte Dimension</translation>
    </message>
    <message>
        <source>settings options language theme dark light configuration motion</source>
        <translation>Optionen Sprache Thema dunkel hell Konfiguration Bewegung</translation>
    </message>
    <message>
        <source>shortcuts keys hotkeys gestures</source>
        <translation>Kürzel Tastenkürzel Gesten</translation>
    </message>
    <message>
        <source>help manual documentation</source>
        <translation>Hilfe Handbuch Dokumentation</translation>
    </message>
    <message>
        <source>tutorial introduction beginner learn</source>
        <translation>Einführung Anfänger lernen Tutorial</translation>
    </message>
    <message>
        <source>sway wind storm blow</source>
        <translation>wiegen Brise Sturm wehen schwingen</translation>
    </message>
    <message>
        <source>turntable spin rotate camera</source>
        <translation>Drehteller drehen rotieren Kamera kreisen</translation>
    </message>
    <message>
        <source>spin rotate</source>
        <translation>drehen rotieren</translation>
    </message>
    <message>
        <source>pulse grow shrink</source>
        <translation>pulsieren wachsen schrumpfen</translation>
    </message>
    <message>
        <source>colours rainbow</source>
        <translation>Farben Regenbogen</translation>
    </message>
    <message>
        <source>infinite dive</source>
        <translation>unendlich eintauchen hineinzoomen</translation>
    </message>
    <message>
        <source>mutate mutation vary breed evolve grow similar</source>
        <translation>mutieren Mutation variieren Variationen züchten entwickeln wachsen ähnlich</translation>
    </message>
    <message>
        <source>shade silhouette drop cast ground light sun</source>
        <translation>Schattenwurf Silhouette Boden Licht Sonne</translation>
    </message>
    <message>
        <source>share send email mail post message url</source>
        <translation>teilen senden verschicken E-Mail Mail Nachricht url</translation>
    </message>
    <message>
        <source>dimension proof certificate | prove certified Hausdorff area measure overlap connected</source>
        <translation>Dimension Beweis Zertifikat | beweisen bewiesen Hausdorff Fläche Maß Überlappung zusammenhängend</translation>
    </message>
    <message>
        <source>reorder rearrange order sort</source>
        <translation>umordnen anordnen Reihenfolge sortieren</translation>
    </message>
    <message>
        <source>gallery examples library favourites leaf tree fern snowflake dragon sponge</source>
        <translation>Galerie Beispiele Bibliothek Favoriten Blatt Baum Farn Schneeflocke Drache Schwamm</translation>
    </message>
    <message>
        <source>linked maps graph-directed which follows which forbidden</source>
        <translation>verknüpft verbundene Abbildungen Graph verboten</translation>
    </message>
    <message>
        <source>colours palette gradient hue background transparent brightness contrast black white grey</source>
        <translation>Farben Palette Verlauf Farbton Hintergrund durchsichtig Helligkeit Kontrast schwarz weiß grau</translation>
    </message>
    <message>
        <source>flip mirror reflect | rotate scale shear move shift turn size resize bigger larger smaller</source>
        <translation>spiegeln Spiegelung umklappen | drehen skalieren scheren verschieben Größe größer kleiner</translation>
    </message>
    <message>
        <source>timeline motion movie keyframes speed faster slower morph</source>
        <translation>Zeitleiste Bewegung Film Schlüsselbilder Tempo schneller langsamer Morphen verwandeln</translation>
    </message>
    <message>
        <source>share send browser html embed publish interactive mail email</source>
        <translation>teilen senden Browser html einbetten veröffentlichen interaktiv mailen E-Mail</translation>
    </message>
    <message>
        <source>worksheet class students exercise paper teacher</source>
        <translation>Arbeitsblatt Klasse Schüler Übung Papier Lehrer Lehrerin</translation>
    </message>
    <message>
        <source>undo original restore straighten start over again</source>
        <translation>ursprünglich wiederherstellen zurück von vorn neu anfangen</translation>
    </message>
</context>
<context>
    <name>view::ComparePane</name>
    <message>
        <source>Entry to compare with</source>
        <translation>Eintrag zum Vergleich</translation>
    </message>
    <message>
        <source>Canvas of the entry to compare with</source>
        <translation>Zeichenfläche des Eintrags zum Vergleich</translation>
    </message>
    <message>
        <source>There is no other entry in this file. Add or duplicate one to compare it.</source>
        <translation>Diese Datei hat keinen anderen Eintrag. Fügen Sie zum Vergleich einen hinzu, oder verdoppeln Sie diesen.</translation>
    </message>
    <message>
        <source>The entry that is shown beside the current one</source>
        <translation>Der Eintrag, der neben dem jetzigen steht</translation>
    </message>
    <message>
        <source>Link Views</source>
        <translation>Ansichten koppeln</translation>
    </message>
    <message>
        <source>Pan and zoom both together, at the same position and scale</source>
        <translation>Beide zusammen verschieben und zoomen, an derselben Stelle und im selben Maßstab</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Show the current entry alone</source>
        <translation>Nur den jetzigen Eintrag zeigen</translation>
    </message>
    <message>
        <source>An entry in the plane and one in space cannot share a view</source>
        <translation>Ein Eintrag der Ebene und einer des Raums haben keine gemeinsame Ansicht</translation>
    </message>
    <message>
        <source>Another entry of the file beside the current one, to compare the two.</source>
        <translation>Ein anderer Eintrag der Datei neben dem aktuellen, um beide zu vergleichen.</translation>
    </message>
</context>
<context>
    <name>view::ConstructionBar</name>
    <message>
        <source>How the attractor is built</source>
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
        <source>Chaos Game</source>
        <translation>Chaosspiel</translation>
    </message>
    <message>
        <source>One point that jumps by maps chosen at random; the first 14 points are not plotted</source>
        <translation>Ein Punkt, der nach ausgelosten Abbildungen springt; die ersten 14 Punkte werden nicht gezeichnet</translation>
    </message>
    <message>
        <source>n: how many times all maps are applied</source>
        <translation>n: wie oft alle Abbildungen angewandt werden</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Clear the points and start with new random numbers</source>
        <translation>Noch keine Punkte, und andere Würfel</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Plot points continuously</source>
        <translation>Punkte erscheinen lassen</translation>
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
        <source>Stop at these points</source>
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
        <source>no points yet: press Play (▶)</source>
        <translation>noch keine Punkte: „Abspielen“ (▶) drücken</translation>
    </message>
    <message>
        <source>How many times all maps are applied: 0 is the starting shape, and with every step the picture gets closer to the attractor. Each image has the colour of its outermost map.</source>
        <translation>Wie oft alle Abbildungen angewandt werden: 0 ist die Ausgangsfigur, und mit jedem Schritt kommt das Bild dem Attraktor näher. Jede Kopie hat die Farbe ihrer äußersten Abbildung.</translation>
    </message>
    <message>
        <source>One Jump</source>
        <translation>Ein Sprung</translation>
    </message>
    <message>
        <source>Roll the die once and jump</source>
        <translation>Einmal würfeln und springen</translation>
    </message>
    <message>
        <source>Jumps per second</source>
        <translation>Sprünge je Sekunde</translation>
    </message>
    <message>
        <source>How many jumps the chaos game makes per second. At up to ten per second, the die shows each map that is rolled.</source>
        <translation>Wie viele Sprünge das Chaosspiel je Sekunde macht. Bis zu zehn je Sekunde zeigt der Würfel jede Abbildung, die fällt.</translation>
    </message>
    <message>
        <source>W%1: the start</source>
        <translation>W%1: die Ausgangsfigur</translation>
    </message>
    <message>
        <source>W%1: %2 copies</source>
        <translation>W%1: %2 Kopien</translation>
    </message>
    <message>
        <source>The Hausdorff distance from the picture to the attractor A, and its upper bound</source>
        <translation>Der Hausdorff-Abstand des Bildes vom Attraktor A, und was er nicht übersteigen kann</translation>
    </message>
    <message>
        <source>The Hausdorff distance from Wⁿ(B) to the attractor A, measured on cells of side %1. It is at most sⁿ times the distance from the start B to A, where s = %2 is the largest contraction factor of the maps.</source>
        <translation>Der Hausdorff-Abstand von Wⁿ(B) zum Attraktor A, gemessen auf Zellen der Seite %1. Er ist höchstens sⁿ-mal der Abstand der Ausgangsfigur B von A, wobei s = %2 der größte Kontraktionsfaktor der Abbildungen ist.</translation>
    </message>
    <message>
        <source>no bound: a map has the contraction factor %1</source>
        <translation>keine Schranke: eine Abbildung hat den Kontraktionsfaktor %1</translation>
    </message>
    <message>
        <source>distance to A at most %1</source>
        <translation>Abstand von A höchstens %1</translation>
    </message>
    <message>
        <source>distance to A &lt; %1, at most %2</source>
        <translation>Abstand von A &lt; %1, höchstens %2</translation>
    </message>
    <message>
        <source>distance to A ≈ %1, at most %2</source>
        <translation>Abstand von A ≈ %1, höchstens %2</translation>
    </message>
    <message>
        <source>jump %1 of the %2 that are not plotted</source>
        <translation>Sprung %1 der %2, die nicht gezeichnet werden</translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>jumps per second</comment>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Step by Step</source>
        <translation>Schritt für Schritt</translation>
    </message>
    <message>
        <source>All maps at once, applied n times to the cage or another shape (Wⁿ)</source>
        <translation>Alle Abbildungen zugleich, n-mal auf den Käfig oder eine andere Figur angewandt (Wⁿ)</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three corners. The picture stays where it is; Esc cancels.</source>
        <translation>Klicken Sie die erste der drei Ecken. Das Bild bleibt, wo es ist; Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Klicken Sie auf die zweite Ecke. Die Rücktaste löscht den letzten Punkt.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Klicken Sie auf die dritte Ecke. Die Rücktaste löscht den letzten Punkt.</translation>
    </message>
</context>
<context>
    <name>view::Die</name>
    <message>
        <source>Die</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <source>The die of the chaos game. It has a face for each map, as wide as the probability of the map. The face that was rolled is shown in the colour of its map, and so is the point that the map leads to. At more than ten jumps per second, the die rolls too fast to be read.</source>
        <translation>Der Würfel des Chaosspiels. Er hat für jede Abbildung eine Seite, so breit wie deren Wahrscheinlichkeit. Die gefallene Seite erscheint in der Farbe ihrer Abbildung, ebenso der Punkt, zu dem diese geführt hat. Bei mehr als zehn Sprüngen je Sekunde rollt er zu schnell, um abgelesen zu werden.</translation>
    </message>
    <message>
        <source>Each map has a face, as wide as its probability.</source>
        <translation>Jede Abbildung hat eine Seite, so breit wie ihre Wahrscheinlichkeit.</translation>
    </message>
    <message>
        <source>Map %1 was rolled; its probability is %2.</source>
        <translation>Gefallen ist Abbildung %1 mit der Wahrscheinlichkeit %2.</translation>
    </message>
</context>
<context>
    <name>view::EaseDialog</name>
    <message>
        <source>Custom Ease</source>
        <translation>Eigener Übergang</translation>
    </message>
    <message>
        <source>Curve: time to the right, progress upwards</source>
        <translation>Kurve: Zeit nach rechts, Weg nach oben</translation>
    </message>
    <message>
        <source>How the motion to the next key progresses over time. Drag the two handles.</source>
        <translation>Wie der Weg zum nächsten Schlüssel mit der Zeit zurückgelegt wird. Ziehen Sie die zwei Griffe.</translation>
    </message>
    <message>
        <source>Time of the first handle</source>
        <translation>Zeit des ersten Griffs</translation>
    </message>
    <message>
        <source>Progress of the first handle</source>
        <translation>Weg des ersten Griffs</translation>
    </message>
    <message>
        <source>Time of the second handle</source>
        <translation>Zeit des zweiten Griffs</translation>
    </message>
    <message>
        <source>Progress of the second handle</source>
        <translation>Weg des zweiten Griffs</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>First handle:</source>
        <translation>Erster Griff:</translation>
    </message>
    <message>
        <source>Second handle:</source>
        <translation>Zweiter Griff:</translation>
    </message>
    <message>
        <source>A number from 0 to 1. A curve that would be too steep is flattened.</source>
        <translation>Ein Anteil von 0 bis 1. Eine zu steile Kurve wird abgeflacht.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Kommentar zu „%1“</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
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
        <source>Written on separate lines below the name, each after a semicolon.</source>
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
        <source>&amp;Title:</source>
        <translation>&amp;Titel:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Kommentarzeilen:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines store the cage and the colours.</source>
        <translation>Ein Kommentar kann nicht mit „barycage:“ beginnen; solche Zeilen bewahren Käfig und Farben.</translation>
    </message>
    <message>
        <source>A line can have at most %1 bytes; Fractint truncates longer ones. Split it in two.</source>
        <translation>Eine Zeile hat höchstens %1 Bytes; Fractint schneidet längere ab. Teilen Sie sie.</translation>
    </message>
    <message>
        <source>Comments are stored with the entry in the file and do not change the fractal.</source>
        <translation>Kommentare werden mit dem Eintrag in der Datei gespeichert und ändern das Fraktal nicht.</translation>
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
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>„%1“ in „%2“ umbenennen</translation>
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
    <message>
        <source>%1 in space</source>
        <translation>%1 im Raum</translation>
    </message>
    <message>
        <source>%1, placed</source>
        <translation>%1, in anderer Lage</translation>
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
        <source>This file contains no entries. Add one, or paste the text of an .ifs file.</source>
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
        <source>Paste entries from .ifs text after the current entry.</source>
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
        <source>An entry that could not be read cannot be duplicated: the copy would have the same name.</source>
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
        <source>The pasted text contains no entry of an .ifs file.</source>
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
        <source>%n pasted entries could not be read; their text is kept unchanged.</source>
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
        <source>No entry name contains “%1”.</source>
        <translation>Kein Eintrag hat „%1“ in seinem Namen.</translation>
    </message>
    <message>
        <source>Shows only the entries whose names contain these letters.</source>
        <translation>Zeigt nur die Einträge, deren Name diese Buchstaben hat.</translation>
    </message>
    <message>
        <source>The fractals in the file. Click one to edit it, drag it to move it, press F2 to rename it.</source>
        <translation>Die Fraktale der Datei. Klicken Sie auf eines, um es zu bearbeiten, ziehen Sie es an einen anderen Platz, drücken Sie F2, um es umzubenennen.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>Nichts wurde eingefügt: In der Zwischenablage ist kein Text.</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Das Eingefügte wird gelesen …</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Einträge werden hinzugefügt …</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Aus&amp;schneiden</translation>
    </message>
    <message>
        <source>Move the selected entries to the clipboard.</source>
        <translation>Verschiebt die gewählten Einträge in die Zwischenablage.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 ausschneiden</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n entries</source>
        <translation>
            <numerusform>%n Eintrag ausschneiden</numerusform>
            <numerusform>%n Einträge ausschneiden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Daten von „%1“ exportieren</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Was die Datei enthalten wird</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>&amp;Text kopieren</translation>
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
        <source>Flip &amp;y so that the flame is the right way up</source>
        <translation>y &amp;umdrehen, damit die Flame gleich herum steht</translation>
    </message>
    <message>
        <source>&amp;Bake the placement so that the maps draw the picture as shown</source>
        <translation>Die La&amp;ge einrechnen, damit die Abbildungen zeichnen, was gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>C&amp;olumns:</source>
        <translation>Spa&amp;lten:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>&amp;Punkte:</translation>
    </message>
    <message>
        <source>The points of the chaos game as shown, without the first 14.</source>
        <translation>Die Punkte des Chaosspiels, wo sie gezeigt werden, ohne die ersten 14.</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Daten exportieren</translation>
    </message>
    <message>
        <source>The text was copied to the clipboard.</source>
        <translation>Der Text wurde in die Zwischenablage kopiert.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>Der Anfang der Datei, wie sie geschrieben wird.</translation>
    </message>
    <message>
        <source>The program that will read the data; each format contains what that program understands.</source>
        <translation>Für welches Programm die Daten sind: Jedes Format hat, was dieses Programm liest.</translation>
    </message>
    <message>
        <source>The order of the coefficients in each row; programs differ.</source>
        <translation>Die Reihenfolge, in der jede Zeile ihre Koeffizienten hat; andere Programme erwarten andere Reihenfolgen.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Wie viele Punkte des Chaosspiels geschrieben werden.</translation>
    </message>
    <message>
        <source>In flame programs, y points down. With this option, the flame looks as it does here; without it, the numbers stay the same.</source>
        <translation>Flame-Programme lassen y nach unten wachsen. Hiermit sieht die Flame aus wie das Fraktal hier; ohne dies bleiben die Zahlen gleich.</translation>
    </message>
    <message>
        <source>With this option, the cage becomes part of the maps. Without it, the maps are written as they are in the table.</source>
        <translation>Hiermit wird der Käfig Teil der Abbildungen. Ohne dies werden die Abbildungen geschrieben, wie sie in der Tabelle stehen.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Fragt nach dem Namen der Datei und schreibt sie.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Kopiert den ganzen Text in die Zwischenablage, statt eine Datei zu schreiben.</translation>
    </message>
    <message>
        <source>This format can store only systems in the plane.</source>
        <translation>Dieses Format kann nur Systeme der Ebene speichern.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>„%1“ exportieren</translation>
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
        <source>Include the ca&amp;ge</source>
        <translation>Mit &amp;Käfig</translation>
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
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Cells along each side of a pixel</source>
        <translation>Zellen längs der Seite eines Pixels</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 Bit je Kanal</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
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
        <source>S&amp;upersampling:</source>
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
        <source>&amp;Automatic depth</source>
        <translation>&amp;Automatische Tiefe</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Ebenen von Kopien</translation>
    </message>
    <message>
        <source>Description of the picture</source>
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
        <source>Only systems in the plane can be exported as a picture.</source>
        <translation>Nur Systeme der Ebene können als Bild exportiert werden.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>One dot for every visible point of the chaos game.</source>
        <translation>Ein Fleck für jeden Punkt des Chaosspiels, der zu sehen ist.</translation>
    </message>
    <message>
        <source>Guaranteed accuracy: %1.</source>
        <translation>Garantierte Genauigkeit: %1.</translation>
    </message>
    <message>
        <source>The shape itself measures %1 × %2.</source>
        <translation>Die Form selbst misst %1 × %2.</translation>
    </message>
    <message>
        <source>Shades of density need pixels: the shapes have one colour.</source>
        <translation>Abstufungen der Dichte brauchen Pixel: Die Formen haben eine einzige Farbe.</translation>
    </message>
    <message>
        <source>The cage bends the picture, which copies cannot reproduce: the affine fit of the cage is written instead. A PNG shows the bend.</source>
        <translation>Der Käfig biegt das Bild, was Kopien nicht können: Geschrieben wird die affine Anpassung des Käfigs. Ein PNG zeigt die Biegung.</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>The picture has no background and can be placed over another.</source>
        <translation>Das Bild hat keinen Hintergrund und kann über ein anderes gelegt werden.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Zeichnet den Käfig über das Bild.</translation>
    </message>
    <message>
        <source>The number of points drawn for each pixel: more points make a smoother picture and take longer.</source>
        <translation>Wie viele Punkte je Pixel gezeichnet werden: Mehr machen ein glatteres Bild und dauern länger.</translation>
    </message>
    <message>
        <source>The number of smaller cells along each side of a pixel: more cells make smoother edges, at the cost of memory and time.</source>
        <translation>Jedes Pixel wird aus so vielen feineren längs seiner Seite gezeichnet: glattere Ränder für mehr Speicher und Zeit.</translation>
    </message>
    <message>
        <source>16 bits keep fine gradations for later editing; 8 bits are enough for viewing.</source>
        <translation>16 Bit bewahren feine Helligkeitsstufen für die spätere Bearbeitung; 8 Bit genügen zum Ansehen.</translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation>Kopien von Kopien geben eine kleine Datei, die Zeichenprogramme bearbeiten können; der Umriss ist ein einziger Pfad; Punkte sind Flecken des Chaosspiels.</translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation>Wie viele Flecken des Chaosspiels gezeichnet werden.</translation>
    </message>
    <message>
        <source>The number of levels of copies. More levels hardly enlarge the file, but the picture takes longer to draw.</source>
        <translation>Wie viele Ebenen von Kopien das Bild hat. Die Datei wächst damit kaum, die Zeit zum Zeichnen schon.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file. You can keep working in the meantime.</source>
        <translation>Fragt nach dem Namen der Datei und schreibt sie. Das Fenster lässt sich inzwischen benutzen.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Das Bild wird kopiert …</translation>
    </message>
    <message>
        <source>Makes the copies smaller until they cannot be distinguished from the attractor at this pixel size, or until programs would take long to draw them.</source>
        <translation>Kopien werden so klein gemacht, bis kein Pixel dieser Größe den Unterschied zeigen könnte oder Programme lange an ihnen zeichnen würden.</translation>
    </message>
    <message>
        <source>More levels would be more accurate, but programs would take long to draw them.</source>
        <translation>Mehr Stufen wären genauer, aber Programme würden lange daran zeichnen.</translation>
    </message>
    <message>
        <source>Computing the shapes…</source>
        <translation>Die Formen werden berechnet …</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Die Ansicht auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>Der ganze Attraktor</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Au&amp;sschnitt:</translation>
    </message>
    <message>
        <source>SVG and PDF are made of shapes, which stay sharp at every size; the others are made of pixels. If the file name has the ending of another format, that format is written.</source>
        <translation>SVG und PDF bestehen aus Formen, die in jeder Größe scharf bleiben, die anderen aus Pixeln. Hat der Dateiname die Endung eines anderen Formats, wird dieses geschrieben.</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format: it must end with .png, .jpg, .webp, .tiff, .exr, .svg or .pdf.</source>
        <translation>Der Name „%1“ nennt kein Format: Er muss auf .png, .jpg, .webp, .tiff, .exr, .svg oder .pdf enden.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the picture to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Fragt nach einem Dateinamen und zeichnet das Bild, wenn es an der Reihe ist, nach denen, die im Feld „Exporte“ warten. Die Warteschlange läuft nach einem Neustart weiter.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>Die Ansicht „%1“</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Was das Bild zeigt: was die Zeichenfläche zeigt, oder den Attraktor mit schmalem Rand, wohin die Zeichenfläche auch blickt. Gespeicherte Ansichten stehen ebenfalls in der Liste.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Guaranteed accuracy: %2. Copies drawn by programs that open the file: %1 (the limit is %3).</source>
        <translation>Garantierte Genauigkeit: %2. Kopien, die Programme beim Öffnen der Datei zeichnen: %1 (höchstens %3).</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Entwurf: 25 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Gut: 100 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Fein: 400 Punkte je Pixel</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Feinste: 2000 Punkte je Pixel</translation>
    </message>
</context>
<context>
    <name>view::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>What the file will show</source>
        <translation>Was die Datei zeigen wird</translation>
    </message>
    <message>
        <source>The picture as it will be exported: its proportions and the section it shows. A chequerboard marks transparent parts. The preview follows every field.</source>
        <translation>Das Bild, wie es exportiert wird: seine Form und der Ausschnitt, den es zeigt. Wo es durchsichtig ist, scheint ein Schachbrett durch. Es folgt jedem Feld.</translation>
    </message>
    <message>
        <source>Drawing the preview…</source>
        <translation>Die Vorschau wird gezeichnet…</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Keine Vorschau</translation>
    </message>
</context>
<context>
    <name>view::ExportProgress</name>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>Noch etwa %n Sekunde.</numerusform>
            <numerusform>Noch etwa %n Sekunden.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n minute(s) left.</source>
        <translation>
            <numerusform>Noch etwa %n Minute.</numerusform>
            <numerusform>Noch etwa %n Minuten.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n hour(s) left.</source>
        <translation>
            <numerusform>Noch etwa %n Stunde.</numerusform>
            <numerusform>Noch etwa %n Stunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Restzeit</translation>
    </message>
</context>
<context>
    <name>view::ExportQueue</name>
    <message>
        <source>Barycage ended unexpectedly twice while drawing this picture. Try it again alone, or export a smaller one.</source>
        <translation>Das Programm wurde zweimal beendet, während es dieses Bild zeichnete. Versuchen Sie es allein noch einmal, oder exportieren Sie ein kleineres.</translation>
    </message>
    <message>
        <source>The export queue cannot be saved for the next session: its folder is not writable, or the disk is full.</source>
        <translation>Die Warteschlange der Exporte kann nicht für den nächsten Start aufbewahrt werden: Ihr Ordner ist nicht beschreibbar, oder der Datenträger ist voll.</translation>
    </message>
</context>
<context>
    <name>view::ExportShell</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Add to Queue…</source>
        <translation>In die Warteschlange…</translation>
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
        <source>Export stopped; nothing was written.</source>
        <translation>Der Export wurde angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Geschrieben nach %1.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Zeigt den Ordner der geschriebenen Datei in der Dateiverwaltung.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>%1-Dateien (*.%2)</translation>
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
        <source>Same as on the screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × der Bildschirm</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Benutzerdefiniert</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Seitenverhältnis beibehalten</translation>
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
        <source>A length in the selected unit. The other side follows as long as the proportions are locked.</source>
        <translation>Eine Länge in der daneben gewählten Einheit. Die andere Seite folgt, solange die Form behalten wird.</translation>
    </message>
    <message>
        <source>Pixels, or a length on paper at the given resolution.</source>
        <translation>In Pixeln oder auf Papier in der angegebenen Auflösung.</translation>
    </message>
    <message>
        <source>The number of pixels per inch of paper: 300 is usual for print.</source>
        <translation>Wie viele Pixel auf ein Zoll Papier kommen: 300 sind im Druck üblich.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Benannte Größe</translation>
    </message>
    <message>
        <source>The size of the picture on the screen or a multiple of it, of a common screen, or of a sheet of paper. Everything that the window shows stays in the picture; if the proportions differ, the picture shows more around it.</source>
        <translation>Die Größe des Bildes auf dem Bildschirm oder ein Vielfaches davon, die eines gängigen Bildschirms oder eines Blattes Papier. Alles, was das Fenster zeigt, bleibt im Bild; wo die Form abweicht, ist ringsum mehr zu sehen.</translation>
    </message>
    <message>
        <source>Keep the proportions of the picture</source>
        <translation>Das Seitenverhältnis des Bildes beibehalten</translation>
    </message>
    <message>
        <source>Full HD: 1920 × 1080</source>
        <translation>Full HD: 1920 × 1080</translation>
    </message>
    <message>
        <source>4K: 3840 × 2160</source>
        <translation>4K: 3840 × 2160</translation>
    </message>
    <message>
        <source>8K: 7680 × 4320</source>
        <translation>8K: 7680 × 4320</translation>
    </message>
    <message>
        <source>Square: 2048 × 2048</source>
        <translation>Quadrat: 2048 × 2048</translation>
    </message>
    <message>
        <source>A4 at 300 dpi</source>
        <translation>A4 mit 300 dpi</translation>
    </message>
    <message>
        <source>A3 at 300 dpi</source>
        <translation>A3 mit 300 dpi</translation>
    </message>
    <message>
        <source>The size of the picture, in pixels or on paper.</source>
        <translation>Die Größe des Bildes, in Pixeln oder auf Papier.</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Hoch- oder Querformat</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Breite und Höhe vertauschen</translation>
    </message>
</context>
<context>
    <name>view::ExportsModel</name>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>noch etwa %n Sekunde</numerusform>
            <numerusform>noch etwa %n Sekunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n minute(s) left</source>
        <translation>
            <numerusform>noch etwa %n Minute</numerusform>
            <numerusform>noch etwa %n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n hour(s) left</source>
        <translation>
            <numerusform>noch etwa %n Stunde</numerusform>
            <numerusform>noch etwa %n Stunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Paused at %1 %</source>
        <translation>Angehalten bei %1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 %, %2</source>
        <comment>how much is done, time left</comment>
        <translation>%1 %, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>file, how far it is</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>view::ExportsPanel</name>
    <message>
        <source>Exports</source>
        <translation>Exporte</translation>
    </message>
    <message>
        <source>Queue of exports</source>
        <translation>Warteschlange der Exporte</translation>
    </message>
    <message>
        <source>The exports, drawn from top to bottom.</source>
        <translation>Die Exporte, von oben nach unten gezeichnet.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Draw the selected export earlier.</source>
        <translation>Den ausgewählten Export früher zeichnen.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>Draw the selected export later.</source>
        <translation>Den ausgewählten Export später zeichnen.</translation>
    </message>
    <message>
        <source>&amp;Try Again</source>
        <translation>&amp;Erneut versuchen</translation>
    </message>
    <message>
        <source>Try again to draw the selected exports that failed.</source>
        <translation>Die ausgewählten Exporte, die fehlgeschlagen sind, noch einmal zeichnen.</translation>
    </message>
    <message>
        <source>Show the folder of the selected export in the file manager.</source>
        <translation>Den Ordner des ausgewählten Exports in der Dateiverwaltung zeigen.</translation>
    </message>
    <message>
        <source>&amp;Cancel Export</source>
        <translation>Export a&amp;bbrechen</translation>
    </message>
    <message>
        <source>Clear &amp;Finished</source>
        <translation>Fertige entf&amp;ernen</translation>
    </message>
    <message>
        <source>Remove all finished exports from the list; their files are kept.</source>
        <translation>Alle fertigen Exporte von der Liste nehmen; ihre Dateien bleiben.</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Fortsetzen</translation>
    </message>
    <message>
        <source>The exports that you have added to the queue. They are drawn one after another, from top to bottom, while you continue editing. Exports that are not finished when you quit continue the next time you start Barycage.</source>
        <translation>Die Exporte, die Sie in die Warteschlange gestellt haben. Sie werden von oben nach unten nacheinander gezeichnet, während Sie weiterarbeiten. Exporte, die beim Beenden nicht fertig sind, gehen beim nächsten Start von Barycage weiter.</translation>
    </message>
    <message>
        <source>Pause or resume all exports without losing progress.</source>
        <translation>Alle Exporte anhalten oder fortsetzen; was schon gezeichnet ist, geht nicht verloren.</translation>
    </message>
    <message>
        <source>Cancel the selected exports and remove them from the list; files already written are kept.</source>
        <translation>Die ausgewählten Exporte abbrechen und von der Liste nehmen; schon geschriebene Dateien bleiben erhalten.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>No exports are waiting. Choose Add to Queue in File › Export › Export Picture… to draw pictures one after another while you continue editing.</source>
        <translation>Keine Exporte warten. Wählen Sie „In die Warteschlange“ unter „Datei › Exportieren › Bild exportieren…“, um Bilder nacheinander zu zeichnen, während Sie weiterarbeiten.</translation>
    </message>
</context>
<context>
    <name>view::FamilySliders</name>
    <message>
        <source>Parameter %1 of the family</source>
        <translation>Parameter %1 der Familie</translation>
    </message>
    <message>
        <source>Change Family</source>
        <translation>Familie ändern</translation>
    </message>
</context>
<context>
    <name>view::FitBox</name>
    <message>
        <source>Best of 2 to 8</source>
        <translation>Die beste von 2 bis 8</translation>
    </message>
    <message>
        <source>How many maps a suggestion has; in a range, a map is added only if it improves the fit enough</source>
        <translation>Wie viele Abbildungen ein Vorschlag hat; in einem Bereich muss sich jede lohnen</translation>
    </message>
    <message>
        <source>Number of maps</source>
        <translation>Anzahl der Abbildungen</translation>
    </message>
    <message>
        <source>Maps:</source>
        <translation>Abbildungen:</translation>
    </message>
    <message>
        <source>Seconds to search</source>
        <translation>Sekunden der Suche</translation>
    </message>
    <message>
        <source>How long to search for suggestions</source>
        <translation>Wie lange nach Vorschlägen gesucht wird</translation>
    </message>
    <message>
        <source>Seconds:</source>
        <translation>Sekunden:</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Startwert der Zufallszahlen</translation>
    </message>
    <message>
        <source>Another seed gives another search</source>
        <translation>Ein anderer Startwert sucht an anderen Stellen</translation>
    </message>
    <message>
        <source>Seed:</source>
        <translation>Startwert:</translation>
    </message>
    <message>
        <source>Similarities only</source>
        <translation>Nur Ähnlichkeiten</translation>
    </message>
    <message>
        <source>Only maps that keep all angles</source>
        <translation>Nur Abbildungen, die alle Winkel erhalten</translation>
    </message>
    <message>
        <source>No mirror images</source>
        <translation>Keine Spiegelbilder</translation>
    </message>
    <message>
        <source>Only maps without reflection</source>
        <translation>Nur Abbildungen, die nicht spiegeln</translation>
    </message>
    <message>
        <source>First map a stem</source>
        <translation>Erste Abbildung ein Stiel</translation>
    </message>
    <message>
        <source>The first map flattens the shape to a line, like the stem of a fern</source>
        <translation>Die erste Abbildung drückt die Form zu einer Linie zusammen, wie der Stiel eines Farns</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>Multiples of %1°</source>
        <translation>Vielfache von %1°</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>The angles by which the maps may rotate</source>
        <translation>Um welche Winkel die Abbildungen drehen dürfen</translation>
    </message>
    <message>
        <source>Angles:</source>
        <translation>Winkel:</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Vorschlagen</translation>
    </message>
    <message>
        <source>Find systems whose attractor looks like the target</source>
        <translation>Systeme finden, deren Attraktor dem Ziel gleicht</translation>
    </message>
    <message>
        <source>Add a Map</source>
        <translation>Abbildung hinzufügen</translation>
    </message>
    <message>
        <source>Add a map where the agreement is worst</source>
        <translation>Dort eine Abbildung hinzufügen, wo die Übereinstimmung am schlechtesten ist</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Abbildungen verbessern</translation>
    </message>
    <message>
        <source>Move the maps so that their images of the target cover it better</source>
        <translation>Die Abbildungen so bewegen, dass ihre Bilder des Ziels es besser bedecken</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Attraktor verbessern</translation>
    </message>
    <message>
        <source>Move the maps so that the attractor itself comes closer to the target</source>
        <translation>Die Abbildungen so bewegen, dass der Attraktor selbst dem Ziel näher kommt</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Gewichte anpassen</translation>
    </message>
    <message>
        <source>Find the weights that reproduce the shades of the picture</source>
        <translation>Die Gewichte finden, die die Helligkeiten des Bildes wiedergeben</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Käfig anpassen</translation>
    </message>
    <message>
        <source>Deform the attractor by a cage so that its outline follows that of the target</source>
        <translation>Den Attraktor mit einem Käfig so verformen, dass sein Umriss dem des Ziels folgt</translation>
    </message>
    <message>
        <source>Refine selected maps only</source>
        <translation>Nur ausgewählte Abbildungen verbessern</translation>
    </message>
    <message>
        <source>The maps that are not selected stay as they are</source>
        <translation>Nicht ausgewählte Abbildungen bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Locked maps stay as they are while others are refined</source>
        <translation>Gesperrte Abbildungen bleiben, wie sie sind, während andere verbessert werden</translation>
    </message>
    <message>
        <source>Corners of the cage</source>
        <translation>Ecken des Käfigs</translation>
    </message>
    <message>
        <source>How many corners the fitted cage has</source>
        <translation>Wie viele Ecken der angepasste Käfig hat</translation>
    </message>
    <message>
        <source>Corners of the cage:</source>
        <translation>Ecken des Käfigs:</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Lock Selected Maps</source>
        <translation>Ausgewählte Abbildungen sperren</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>Gesperrt: %1</translation>
    </message>
    <message>
        <source>Stop without changing anything</source>
        <translation>Beenden, ohne etwas zu ändern</translation>
    </message>
</context>
<context>
    <name>view::FourViews</name>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
</context>
<context>
    <name>view::FrameSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>The width of the frames in pixels.</source>
        <translation>Die Breite der Bilder in Pixeln.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>The height of the frames in pixels.</source>
        <translation>Die Höhe der Bilder in Pixeln.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Benannte Größe</translation>
    </message>
    <message>
        <source>Usual sizes of videos.</source>
        <translation>Übliche Größen von Videos.</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Seitenverhältnis beibehalten</translation>
    </message>
    <message>
        <source>Keep the proportions of the frames</source>
        <translation>Das Seitenverhältnis der Bilder beibehalten</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Hoch- oder Querformat</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Breite und Höhe vertauschen</translation>
    </message>
    <message>
        <source>Full HD: 1920 × 1080</source>
        <translation>Full HD: 1920 × 1080</translation>
    </message>
    <message>
        <source>HD: 1280 × 720</source>
        <translation>HD: 1280 × 720</translation>
    </message>
    <message>
        <source>4K: 3840 × 2160</source>
        <translation>4K: 3840 × 2160</translation>
    </message>
    <message>
        <source>Square: 1080 × 1080</source>
        <translation>Quadrat: 1080 × 1080</translation>
    </message>
    <message>
        <source>Portrait: 1080 × 1920</source>
        <translation>Hochformat: 1080 × 1920</translation>
    </message>
    <message>
        <source>For a message: 640 × 360</source>
        <translation>Für eine Nachricht: 640 × 360</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Benutzerdefiniert</translation>
    </message>
</context>
<context>
    <name>view::GoToDialog</name>
    <message>
        <source>Centre, x</source>
        <translation>Mitte, x</translation>
    </message>
    <message>
        <source>The x coordinate in the middle of the view.</source>
        <translation>Die x-Koordinate in der Mitte der Ansicht.</translation>
    </message>
    <message>
        <source>Centre, y</source>
        <translation>Mitte, y</translation>
    </message>
    <message>
        <source>The y coordinate in the middle of the view.</source>
        <translation>Die y-Koordinate in der Mitte der Ansicht.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>How much of the plane is seen, from the lower edge to the upper one.</source>
        <translation>Wie viel von der Ebene zu sehen ist, vom unteren Rand bis zum oberen.</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>such as 3 2 1</source>
        <translation>etwa 3 2 1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Numbers of maps, as the status bar shows them for the point under the pointer. They repeat, and the centre becomes the point that they lead to.</source>
        <translation>Nummern von Abbildungen, wie die Statuszeile sie für den Punkt unter dem Zeiger zeigt. Sie wiederholen sich, und die Mitte wird der Punkt, zu dem sie führen.</translation>
    </message>
    <message>
        <source>Choose a map</source>
        <translation>Abbildung wählen</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Fixpunkt</translation>
    </message>
    <message>
        <source>The centre becomes the point that this map leaves where it is.</source>
        <translation>Die Mitte wird der Punkt, den diese Abbildung an seinem Ort lässt.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>&amp;Centre:</source>
        <translation>&amp;Mitte:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Höhe:</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse:</translation>
    </message>
    <message>
        <source>&amp;Fixed point of:</source>
        <translation>&amp;Fixpunkt von:</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Los</translation>
    </message>
    <message>
        <source>Shows this part of the plane. The fractal stays as it is.</source>
        <translation>Zeigt diesen Teil der Ebene. Das Fraktal bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>No point has this address: a map in it is switched off, or does not contract.</source>
        <translation>Kein Punkt hat diese Adresse: eine Abbildung darin ist ausgeschaltet oder kontrahiert nicht.</translation>
    </message>
    <message>
        <source>An address has the numbers of maps, from 1 to %1.</source>
        <translation>Eine Adresse besteht aus Nummern von Abbildungen, von 1 bis %1.</translation>
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
        <source>Stop Colour</source>
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
        <source>Add a stop after the selected one</source>
        <translation>Eine Marke nach der gewählten hinzufügen</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Marke löschen</translation>
    </message>
    <message>
        <source>Delete the selected stop</source>
        <translation>Die gewählte Marke löschen</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Reverse the order of the colours</source>
        <translation>Die Palette umkehren</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Verteilen</translation>
    </message>
    <message>
        <source>Space the stops evenly</source>
        <translation>Die Marken in gleiche Abstände setzen</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
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
        <source>The palettes in the file. Select one.</source>
        <translation>Die Paletten, die die Datei enthält. Wählen Sie eine.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen …</translation>
    </message>
    <message>
        <source>Take the palette from a picture</source>
        <translation>Palette aus einem Bild nehmen</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ggr, .ugr or .map file, or take it from a picture</source>
        <translation>Eine Palette aus einer Datei .gpl, .ggr, .ugr oder .map laden oder aus einem Bild nehmen</translation>
    </message>
    <message>
        <source>Palettes and pictures (%1);;All files (*)</source>
        <translation>Paletten und Bilder (%1);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Marken des Farbverlaufs</translation>
    </message>
    <message>
        <source>Double-click: add a stop, or change the colour of one. Drag: move. Del: delete.
Keys: Page Up and Page Down select a stop, the arrow keys move it, Ins adds one, Enter opens its colour.</source>
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
    <name>view::HandoutDialog</name>
    <message>
        <source>&amp;Cage and maps</source>
        <translation>&amp;Käfig und Abbildungen</translation>
    </message>
    <message>
        <source>&amp;Formulas</source>
        <translation>&amp;Formeln</translation>
    </message>
    <message>
        <source>&amp;Line for name and date</source>
        <translation>Zei&amp;le für Name und Datum</translation>
    </message>
    <message>
        <source>Print a Handout</source>
        <translation>Handout drucken</translation>
    </message>
    <message>
        <source>Pre&amp;view…</source>
        <translation>&amp;Vorschau…</translation>
    </message>
    <message>
        <source>Show the pages before they are printed</source>
        <translation>Die Seiten vor dem Druck zeigen</translation>
    </message>
    <message>
        <source>&amp;Entries:</source>
        <translation>&amp;Einträge:</translation>
    </message>
    <message>
        <source>Entries to print</source>
        <translation>Zu druckende Einträge</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Alle</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>Kei&amp;ne</translation>
    </message>
    <message>
        <source>Print all entries of the list</source>
        <translation>Alle Einträge der Liste drucken</translation>
    </message>
    <message>
        <source>Remove all ticks</source>
        <translation>Alle Kreuze entfernen</translation>
    </message>
    <message>
        <source>Handout with pictures</source>
        <translation>Handout mit Bildern</translation>
    </message>
    <message>
        <source>Blank worksheet</source>
        <translation>Leeres Aufgabenblatt</translation>
    </message>
    <message>
        <source>Kind of sheet</source>
        <translation>Art des Blatts</translation>
    </message>
    <message>
        <source>Entries per page</source>
        <translation>Einträge je Seite</translation>
    </message>
    <message>
        <source>How many entries are printed on one page.</source>
        <translation>Wie viele Einträge auf eine Seite gedruckt werden.</translation>
    </message>
    <message>
        <source>Draw the cage and its numbered images over the picture</source>
        <translation>Den Käfig und seine nummerierten Bilder über das Bild zeichnen</translation>
    </message>
    <message>
        <source>Print the formula and the probability of each map</source>
        <translation>Formel und Wahrscheinlichkeit jeder Abbildung drucken</translation>
    </message>
    <message>
        <source>Leave lines at the top of each page for a name and a date</source>
        <translation>Oben auf jeder Seite Linien für Name und Datum lassen</translation>
    </message>
    <message>
        <source>&amp;Sheet:</source>
        <translation>&amp;Blatt:</translation>
    </message>
    <message>
        <source>Entries per &amp;page:</source>
        <translation>Einträge je Sei&amp;te:</translation>
    </message>
    <message>
        <source>Choose at most %1 entries</source>
        <translation>Höchstens %1 Einträge wählen</translation>
    </message>
    <message>
        <source>Choose an entry first</source>
        <translation>Zuerst einen Eintrag wählen</translation>
    </message>
    <message>
        <source>%1-handout.pdf</source>
        <comment>name of a file</comment>
        <translation>%1-Handout.pdf</translation>
    </message>
    <message>
        <source>Prints entries of the file for a class: with pictures and formulas, or as blank worksheets.</source>
        <translation>Druckt Einträge der Datei für den Unterricht: mit Bildern und Formeln oder als leere Arbeitsblätter.</translation>
    </message>
    <message>
        <source>The entries of the file that could be read. Ticked entries are printed in this order, up to %1 of them.</source>
        <translation>Die Einträge der Datei, die gelesen werden konnten. Gedruckt werden die angekreuzten in dieser Reihenfolge, höchstens %1.</translation>
    </message>
    <message>
        <source>A handout has the picture of each entry, with its cage, its maps and their formulas. A blank worksheet has the cage, in the plane on a grid, and an empty table, to be filled in by hand.</source>
        <translation>Ein Handout zeigt das Bild jedes Eintrags mit seinem Käfig, seinen Abbildungen und deren Formeln. Ein leeres Aufgabenblatt zeigt den Käfig, in der Ebene auf einem Gitter, und eine leere Tabelle, die von Hand ausgefüllt wird.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
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
        <source>Select a step to go back or forward to it.</source>
        <translation>Wählen Sie einen Schritt, um zu ihm zurück- oder vorzugehen.</translation>
    </message>
    <message>
        <source>Select a step to go back or forward to it. The disk marks the saved state.</source>
        <translation>Wählen Sie einen Schritt, um zu ihm zurück- oder vorzugehen. Die Diskette zeigt, was gespeichert ist.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
</context>
<context>
    <name>view::LessonCard</name>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Text des Schritts</translation>
    </message>
    <message>
        <source>Show the previous step (Page Up)</source>
        <translation>Den vorigen Schritt zeigen (Bild auf)</translation>
    </message>
    <message>
        <source>Show the next step (Page Down)</source>
        <translation>Den nächsten Schritt zeigen (Bild ab)</translation>
    </message>
    <message>
        <source>End the lesson and return to the window as it was (Esc)</source>
        <translation>Die Lektion beenden und zum Fenster zurückkehren, wie es war (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
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
        <source>A lesson in progress: the text of the current step, and buttons to go to the others.</source>
        <translation>Eine laufende Lektion: der Text des aktuellen Schritts und Knöpfe, die zu den anderen führen.</translation>
    </message>
</context>
<context>
    <name>view::LessonNotebook</name>
    <message>
        <source>Rename lesson</source>
        <translation>Lektion umbenennen</translation>
    </message>
    <message>
        <source>Add step</source>
        <translation>Schritt hinzufügen</translation>
    </message>
    <message>
        <source>Update step</source>
        <translation>Schritt aktualisieren</translation>
    </message>
    <message>
        <source>Rename step</source>
        <translation>Schritt umbenennen</translation>
    </message>
    <message>
        <source>Edit text</source>
        <translation>Text ändern</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>Schritt entfernen</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Schritt verschieben</translation>
    </message>
</context>
<context>
    <name>view::LessonPanel</name>
    <message>
        <source>Arrange the window as you want to show it, and press Add Step. Then write the text of the step.</source>
        <translation>Richten Sie das Fenster so ein, wie die Klasse es sehen soll, und klicken Sie auf „Schritt hinzufügen“. Schreiben Sie dann, was Sie dazu sagen wollen.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>Lektion &amp;speichern…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Add Step</source>
        <translation>Schritt hinzufügen</translation>
    </message>
    <message>
        <source>Add a step with the current state of the window</source>
        <translation>Einen Schritt mit dem jetzigen Zustand des Fensters hinzufügen</translation>
    </message>
    <message>
        <source>Update Step</source>
        <translation>Schritt aktualisieren</translation>
    </message>
    <message>
        <source>Replace the state of the selected step by the current state of the window</source>
        <translation>Dem gewählten Schritt den jetzigen Zustand des Fensters geben</translation>
    </message>
    <message>
        <source>Show Step</source>
        <translation>Schritt zeigen</translation>
    </message>
    <message>
        <source>Restore the window to the state of the selected step</source>
        <translation>Das Fenster in den Zustand des gewählten Schritts bringen</translation>
    </message>
    <message>
        <source>Remove Step</source>
        <translation>Schritt entfernen</translation>
    </message>
    <message>
        <source>Remove the selected step</source>
        <translation>Den gewählten Schritt entfernen</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Show the selected step earlier</source>
        <translation>Den gewählten Schritt früher zeigen</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Show the selected step later</source>
        <translation>Den gewählten Schritt später zeigen</translation>
    </message>
    <message>
        <source>Undo in the Lesson</source>
        <translation>In der Lektion rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change of the lesson</source>
        <translation>Die letzte Änderung der Lektion rückgängig machen</translation>
    </message>
    <message>
        <source>Redo in the Lesson</source>
        <translation>In der Lektion wiederholen</translation>
    </message>
    <message>
        <source>Redo the change of the lesson</source>
        <translation>Die Änderung der Lektion wiederholen</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Titel der Lektion</translation>
    </message>
    <message>
        <source>Shown above every step while the lesson is played</source>
        <translation>Steht über jedem Schritt, während die Lektion läuft</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Schritte der Lektion</translation>
    </message>
    <message>
        <source>Double-click a step to restore its state of the window</source>
        <translation>Ein Doppelklick auf einen Schritt bringt das Fenster in seinen Zustand</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>Titel des Schritts</translation>
    </message>
    <message>
        <source>Shown in large letters above the text</source>
        <translation>Steht in großer Schrift über dem Text</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Text des Schritts</translation>
    </message>
    <message>
        <source>Shown beside the picture; leave a line empty to begin a paragraph</source>
        <translation>Steht neben dem Bild; eine leere Zeile beginnt einen Absatz</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>The panels that this step shows beside the canvas; all others are hidden</source>
        <translation>Die Felder, die dieser Schritt neben der Zeichenfläche zeigt; alle anderen sind verborgen</translation>
    </message>
    <message>
        <source>Panels of the step</source>
        <translation>Felder des Schritts</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and title of a step</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. A lesson is a list of steps. Each has a text, and the state of the window that belongs to it: the entry, the view, the tool, colours and outlines.</source>
        <translation>%1. Eine Lektion ist eine Liste von Schritten. Zu jedem gehören ein Text und ein Zustand des Fensters: der Eintrag, was von ihm zu sehen ist, das Werkzeug, Farben und Umrisse.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Die Lektion auf dem ganzen Bildschirm abspielen, von Anfang an oder ab dem Schritt, den Sie in der Liste angeklickt haben</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Die Lektion als Text speichern, der auf ihre Fraktale verweist</translation>
    </message>
</context>
<context>
    <name>view::LightBall</name>
    <message>
        <source>Direction of the light</source>
        <translation>Richtung des Lichts</translation>
    </message>
    <message>
        <source>Drag the light over the sphere, or use the arrow keys</source>
        <translation>Ziehen Sie das Licht über die Kugel, oder benutzen Sie die Pfeiltasten</translation>
    </message>
    <message>
        <source>Azimuth %1°, elevation %2°</source>
        <translation>Azimut %1°, Höhe %2°</translation>
    </message>
</context>
<context>
    <name>view::LinePicture</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it; click to take all</source>
        <translation>Ziehen Sie eine Linie, um nur die Farben auf ihr zu nehmen; klicken Sie, um alle zu nehmen</translation>
    </message>
</context>
<context>
    <name>view::LinkGraph</name>
    <message>
        <source>Graph of links</source>
        <translation>Graph der Verknüpfungen</translation>
    </message>
    <message>
        <source>Drag from one map to another to link them; click an arrow and press Delete to remove it.</source>
        <translation>Ziehen Sie von einer Abbildung zu einer anderen, um sie zu verknüpfen; klicken Sie auf einen Pfeil und drücken Sie Entf, um ihn zu entfernen.</translation>
    </message>
    <message>
        <source>Each circle is a map, and an arrow leads to each map that may follow it in the chaos game; thicker arrows have more weight. Drag from one map to another to link them, or out of a map and back to link it to itself. Click an arrow and press Delete to remove it, or double-click it to enter its weight. With the keyboard: Left and Right walk through the maps, Up and Down through the arrows of a map; Space begins a new arrow, Left and Right choose its end, Enter adds it. Maps with a dashed ring take no part; the reason is shown beside them.</source>
        <translation>Jeder Kreis ist eine Abbildung, und ein Pfeil führt zu jeder Abbildung, die im Chaosspiel auf sie folgen darf; dickere Pfeile haben mehr Gewicht. Ziehen Sie von einer Abbildung zu einer anderen, um sie zu verknüpfen, oder aus einer Abbildung heraus und zurück, um sie mit sich selbst zu verknüpfen. Klicken Sie auf einen Pfeil und drücken Sie Entf, um ihn zu entfernen, oder doppelklicken Sie, um sein Gewicht einzugeben. Mit der Tastatur: Links und Rechts gehen durch die Abbildungen, Auf und Ab durch die Pfeile einer Abbildung; die Leertaste beginnt einen neuen Pfeil, Links und Rechts wählen sein Ende, die Eingabetaste fügt ihn hinzu. Abbildungen mit gestricheltem Ring nehmen nicht teil; der Grund steht daneben.</translation>
    </message>
    <message>
        <source>No map is selected.</source>
        <translation>Keine Abbildung ist ausgewählt.</translation>
    </message>
    <message>
        <source>New arrow from map %1 to map %2. Enter adds it, Esc cancels.</source>
        <translation>Neuer Pfeil von Abbildung %1 zu Abbildung %2. Die Eingabetaste fügt ihn hinzu, Esc nicht.</translation>
    </message>
    <message>
        <source>Map %1: %2</source>
        <translation>Abbildung %1: %2</translation>
    </message>
</context>
<context>
    <name>view::LinksModel</name>
    <message>
        <source>Switched off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Unreached: no map leads to it</source>
        <translation>Unerreicht: Keine Abbildung führt zu ihr</translation>
    </message>
    <message>
        <source>Transient: the chaos game never returns</source>
        <translation>Verlassen: Das Chaosspiel kehrt nie zurück</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Nimmt teil</translation>
    </message>
    <message>
        <source>From map %1 to map %2: %3</source>
        <translation>Von Abbildung %1 zu Abbildung %2: %3</translation>
    </message>
    <message>
        <source>Link map %1 to map %2</source>
        <translation>Abbildung %1 mit Abbildung %2 verknüpfen</translation>
    </message>
    <message>
        <source>In the chaos game</source>
        <translation>Im Chaosspiel</translation>
    </message>
    <message>
        <source>Whether the chaos game keeps applying the map, or why not</source>
        <translation>Ob die Abbildung immer wieder angewandt wird, oder warum nicht</translation>
    </message>
    <message>
        <source>To map %1</source>
        <translation>Zu Abbildung %1</translation>
    </message>
    <message>
        <source>From map %1</source>
        <translation>Von Abbildung %1</translation>
    </message>
    <message>
        <source>Unlink map %1 from map %2</source>
        <translation>Abbildung %1 von Abbildung %2 lösen</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n link(s)</source>
        <translation>
            <numerusform>%n Verbindung entfernen</numerusform>
            <numerusform>%n Verbindungen entfernen</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends: every sequence from here stops</source>
        <translation>Endet: Jede Folge von hier hört auf</translation>
    </message>
    <message>
        <source>Directly after map %1, map %2 has %3 times its weight.</source>
        <translation>Unmittelbar nach Abbildung %1 wird Abbildung %2 mit dem %3-Fachen ihres Gewichts angewandt.</translation>
    </message>
    <message>
        <source>Map %2 is never applied directly after map %1.</source>
        <translation>Unmittelbar nach Abbildung %1 wird Abbildung %2 nie angewandt.</translation>
    </message>
</context>
<context>
    <name>view::LinksPanel</name>
    <message>
        <source>Remove All Links</source>
        <translation>Alle Verknüpfungen entfernen</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verknüpfungen</translation>
    </message>
    <message>
        <source>Links between maps</source>
        <translation>Verknüpfungen zwischen Abbildungen</translation>
    </message>
    <message>
        <source>Rows are the maps applied before, columns the maps applied after. A number multiplies the weight of the map in its column: 1 leaves it unchanged, 0 forbids the link.</source>
        <translation>Zeilen sind die zuvor angewandten Abbildungen, Spalten die danach. Eine Zahl vervielfacht das Gewicht der Abbildung der Spalte: 1 lässt es unverändert, 0 verbietet sie.</translation>
    </message>
    <message>
        <source>Any map may follow any other again</source>
        <translation>Jede Abbildung darf wieder auf jede folgen</translation>
    </message>
    <message>
        <source>Every sequence of maps ends, so nothing is drawn.</source>
        <translation>Jede Folge von Abbildungen endet; daher wird nichts gezeichnet.</translation>
    </message>
    <message>
        <source>Remove all links</source>
        <translation>Alle Verknüpfungen entfernen</translation>
    </message>
    <message>
        <source>Any map may follow any other. Click an arrow and press Delete to forbid it.</source>
        <translation>Jede Abbildung darf auf jede folgen. Klicken Sie auf einen Pfeil und drücken Sie Entf, um es zu verbieten.</translation>
    </message>
    <message>
        <source>No map has a choice of what follows it, so only single points are drawn.</source>
        <translation>Auf jede Abbildung kann nur eine folgen, deshalb werden nur einzelne Punkte gezeichnet.</translation>
    </message>
    <message>
        <source>Row: the map before. Column: the map after.</source>
        <translation>Zeile: die Abbildung davor. Spalte: die danach.</translation>
    </message>
</context>
<context>
    <name>view::MapBlendRow</name>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>The position on the palette to which this map moves colours, from 0 to 1</source>
        <translation>Wohin auf der Palette diese Abbildung Farben zieht: von 0, ihrem Anfang, bis 1</translation>
    </message>
    <message>
        <source>Whenever this map is applied, the colour of the point moves towards the position of the map on the palette: 0 is the beginning of the palette, 1 its end. Flame programs call it the colour coordinate.</source>
        <translation>Immer wenn eine Abbildung angewandt wird, rückt die Farbe eines Punktes zum Platz dieser Abbildung auf der Palette: 0 ist der Anfang der Palette, 1 ihr Ende. Bei Flames heißt das die Farbkoordinate.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How far this map moves colours each time, from 0 (not at all) to 1 (all the way)</source>
        <translation>Wie weit diese Abbildung Farben jedes Mal zieht: von 0, gar nicht, bis 1, den ganzen Weg</translation>
    </message>
    <message>
        <source>How far the map moves colours towards its position on the palette each time: with 1, its piece has a single colour; with 0, all colours stay as they are. Flame programs call it the colour speed.</source>
        <translation>Welchen Teil des Weges zu ihrem Platz auf der Palette die Abbildung Farben jedes Mal mitnimmt: bei 1 hat ihr Teil eine einzige Farbe, bei 0 lässt sie alle Farben, wie sie sind. Bei Flames heißt das die Farbgeschwindigkeit.</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
</context>
<context>
    <name>view::MapOrder</name>
    <message>
        <source>Order of the maps</source>
        <translation>Reihenfolge der Abbildungen</translation>
    </message>
    <message>
        <source>Where pieces overlap, the map that is higher in this list is on top; drag a map to move it</source>
        <translation>Wo sich Teile überlappen, liegt die Abbildung oben, die in dieser Liste höher steht; ziehen Sie eine Abbildung, um sie zu verschieben</translation>
    </message>
    <message>
        <source>Move the map towards the top</source>
        <translation>Die Abbildung nach oben verschieben</translation>
    </message>
    <message>
        <source>Move the map towards the bottom</source>
        <translation>Die Abbildung nach unten verschieben</translation>
    </message>
    <message>
        <source>On top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Reihenfolge zurücksetzen</translation>
    </message>
    <message>
        <source>Reset Order: puts the maps back in the order of their numbers</source>
        <translation>Reihenfolge zurücksetzen: ordnet die Abbildungen wieder nach ihren Nummern</translation>
    </message>
    <message>
        <source>Puts the maps back in the order of their numbers, which is that of the Maps panel: map 1 is on top. This is one step that you can undo.</source>
        <translation>Ordnet die Abbildungen wieder nach ihren Nummern, also wie im Feld „Abbildungen“: Abbildung 1 liegt oben. Das ist ein Schritt, den Sie rückgängig machen können.</translation>
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
        <source>Scale at right angles to that; negative if the map reflects</source>
        <translation>Skalierung quer dazu; negativ, wenn die Abbildung spiegelt</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Scherung</translation>
    </message>
    <message>
        <source>Shear along x, applied first</source>
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
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Axis of the rotation; only its direction matters</source>
        <translation>Achse der Drehung; nur ihre Richtung zählt</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>Achse x</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Achse y</translation>
    </message>
    <message>
        <source>Axis z</source>
        <translation>Achse z</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise as seen from the tip of the axis looking back</source>
        <translation>Winkel in Grad, gegen den Uhrzeigersinn, wenn man von der Spitze der Achse zurückblickt</translation>
    </message>
    <message>
        <source>Scale along y, before the rotation</source>
        <translation>Skalierung längs y, vor der Drehung</translation>
    </message>
    <message>
        <source>Scale z</source>
        <translation>Skalierung z</translation>
    </message>
    <message>
        <source>Scale along z, before the rotation; negative if the map reflects</source>
        <translation>Skalierung längs z, vor der Drehung; negativ, wenn die Abbildung spiegelt</translation>
    </message>
    <message>
        <source>Shear xy</source>
        <translation>Scherung xy</translation>
    </message>
    <message>
        <source>What y adds to x, applied first</source>
        <translation>Was y zu x beiträgt; zuerst angewandt</translation>
    </message>
    <message>
        <source>Shear xz</source>
        <translation>Scherung xz</translation>
    </message>
    <message>
        <source>What z adds to x, applied first</source>
        <translation>Was z zu x beiträgt; zuerst angewandt</translation>
    </message>
    <message>
        <source>Shear yz</source>
        <translation>Scherung yz</translation>
    </message>
    <message>
        <source>What z adds to y, applied first</source>
        <translation>Was z zu y beiträgt; zuerst angewandt</translation>
    </message>
    <message>
        <source>Translation j, applied last</source>
        <translation>Verschiebung j, zuletzt angewandt</translation>
    </message>
    <message>
        <source>Translation k, applied last</source>
        <translation>Verschiebung k, zuletzt angewandt</translation>
    </message>
    <message>
        <source>Shift z</source>
        <translation>Verschiebung z</translation>
    </message>
    <message>
        <source>Translation l, applied last</source>
        <translation>Verschiebung l, zuletzt angewandt</translation>
    </message>
    <message>
        <source>Map %1, locked</source>
        <translation>Abbildung %1, gesperrt</translation>
    </message>
</context>
<context>
    <name>view::MapsClipboard</name>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in space.</source>
        <translation>Nichts wurde eingefügt: Die kopierten Abbildungen gehören zu einem System im Raum.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in the plane.</source>
        <translation>Nichts wurde eingefügt: Die kopierten Abbildungen gehören zu einem System in der Ebene.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard contains no rows of 12 or 13 numbers.</source>
        <translation>Nichts wurde eingefügt: Die Zwischenablage enthält keine Zeilen von 12 oder 13 Zahlen.</translation>
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
    <message>
        <source>Name of map %1</source>
        <translation>Name der Abbildung %1</translation>
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
        <source>A reflected similarity keeps shapes but mirrors them; it also turns, scales and shifts them.</source>
        <translation>Eine gespiegelte Ähnlichkeit erhält Formen wie ein Spiegel, skaliert und verschiebt sie.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels but not angles.</source>
        <translation>Eine affine Abbildung erhält Geraden und Parallelen, nicht Winkel.</translation>
    </message>
    <message>
        <source>A singular map takes the whole plane to a line.</source>
        <translation>Eine singuläre Abbildung führt die Ebene in eine Gerade über.</translation>
    </message>
    <message>
        <source>A constant map takes the whole plane to one point.</source>
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
        <source>Effective code: the map as it acts on the picture under the current cage. Bake turns it into the code.</source>
        <translation>Effektiver Code: die Abbildung, wie sie unter dem jetzigen Käfig auf das Bild wirkt. Einrechnen macht sie zum Code.</translation>
    </message>
    <message>
        <source>Weight as entered: how often the chaos game chooses the map. The weights need not sum to 1.</source>
        <translation>Gewicht wie angegeben: wie oft das Chaosspiel die Abbildung nimmt. Die Summe muss nicht 1 sein.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor by which areas change; negative if the map reflects.</source>
        <translation>Determinante ad − bc: der Faktor der Flächen; negativ, wenn die Abbildung spiegelt.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the largest factor by which distances are stretched.</source>
        <translation>Kontraktionsfaktor ‖A‖, der größte Singulärwert: der größte Faktor, um den Abstände gestreckt werden.</translation>
    </message>
    <message>
        <source>The geometric kind of the map.</source>
        <translation>Was die Abbildung geometrisch ist.</translation>
    </message>
    <message>
        <source>Map %1 is switched on.</source>
        <translation>Abbildung %1 ist eingeschaltet.</translation>
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
        <translation>Der Käfig ist flach oder gebogen: Es gibt keinen effektiven Code.</translation>
    </message>
    <message>
        <source>No weight is given; the determinant rule gives the probability %1.</source>
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
        <source>Switch map %1 on</source>
        <translation>Abbildung %1 einschalten</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Abbildung %1 ausschalten</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Set %1 of map %2 to %3</source>
        <translation>%1 der Abbildung %2 auf %3 setzen</translation>
    </message>
    <message>
        <source>Colour of map %1: %2</source>
        <translation>Farbe der Abbildung %1: %2</translation>
    </message>
    <message>
        <source>A singular map takes the whole of space to a plane or a line.</source>
        <translation>Eine singuläre Abbildung führt den ganzen Raum in eine Ebene oder Gerade.</translation>
    </message>
    <message>
        <source>A constant map takes the whole of space to one point.</source>
        <translation>Eine konstante Abbildung führt den ganzen Raum in einen Punkt.</translation>
    </message>
    <message>
        <source>The map takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</source>
        <translation>Die Abbildung führt (x, y, z) in (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l) über.</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage.</source>
        <translation>Effektiver Code: die Abbildung, wie sie unter dem jetzigen Käfig auf das Bild wirkt.</translation>
    </message>
    <message>
        <source>Determinant: the factor by which volumes change; negative if the map reflects.</source>
        <translation>Determinante: der Faktor der Volumen; negativ, wenn die Abbildung spiegelt.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Whether the map is switched on. Alt+click shows one map alone.</source>
        <translation>Ob die Abbildung eingeschaltet ist. Alt+Klick zeigt eine Abbildung allein.</translation>
    </message>
    <message>
        <source>Whether the map is locked: then it cannot be edited, moved or deleted by mistake.</source>
        <translation>Ob die Abbildung gesperrt ist: Dann lässt sie sich nicht versehentlich ändern, verschieben oder löschen.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map, and the part of the attractor that the map makes.</source>
        <translation>Farbe der Abbildung, wenn das Bild nach Abbildungen gefärbt ist, und der Teil des Attraktors, den die Abbildung erzeugt.</translation>
    </message>
    <message>
        <source>Name of the map.</source>
        <translation>Name der Abbildung.</translation>
    </message>
    <message>
        <source>Map %1 is shown alone.</source>
        <translation>Abbildung %1 wird allein gezeigt.</translation>
    </message>
    <message>
        <source>Map %1 is locked.</source>
        <translation>Abbildung %1 ist gesperrt.</translation>
    </message>
    <message>
        <source>Map %1 is not locked.</source>
        <translation>Abbildung %1 ist nicht gesperrt.</translation>
    </message>
    <message>
        <source>Map %1 has no name. Double-click to name it.</source>
        <translation>Abbildung %1 hat keinen Namen. Doppelklick gibt ihr einen.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>nicht gesperrt</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>kein Name</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Den Namen der Abbildung %1 entfernen</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Abbildung %1 „%2“ nennen</translation>
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
        <source>Replace the code by the effective code; the cage is then at rest</source>
        <translation>Den effektiven Code zum Code machen; der Käfig ruht danach</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, for an even picture</source>
        <translation>Gewichte im Verhältnis der Flächen der Bilder, damit das Bild gleichmäßig wird</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
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
        <source>Properties</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Determinante, Kontraktionsfaktor und Art jeder Abbildung zeigen</translation>
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
        <source>This entry could not be read. It is kept unchanged.</source>
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
        <source>Reorder maps</source>
        <translation>Abbildungen umordnen</translation>
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
        <source>Each row is a map: it takes (x, y) to (a x + b y + e, c x + d y + f) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Jede Zeile ist eine Abbildung: (x, y) geht über in (a x + b y + e, c x + d y + f), so oft, wie ihr Gewicht p sagt. Klicken Sie doppelt auf eine Zahl oder beginnen Sie zu tippen, um sie zu ändern; das Bild folgt jeder Taste. Ziehen Sie die Nummer einer Zeile, um sie zu verschieben.</translation>
    </message>
    <message>
        <source>Properties of the map</source>
        <translation>Eigenschaften der Abbildung</translation>
    </message>
    <message>
        <source>det %1    ‖A‖ %2    %3</source>
        <translation>det %1    ‖A‖ %2    %3</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>Gewichte: %1</translation>
    </message>
    <message>
        <source>No maps: add one.</source>
        <translation>Keine Abbildungen: Fügen Sie eine hinzu.</translation>
    </message>
    <message>
        <source>Weights in proportion to the volumes of the images, for an even picture</source>
        <translation>Gewichte im Verhältnis der Volumen der Bilder, damit das Bild gleichmäßig wird</translation>
    </message>
    <message>
        <source>Show the coefficients a … l</source>
        <translation>Die Koeffizienten a … l zeigen</translation>
    </message>
    <message>
        <source>Each row is a map: it takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Jede Zeile ist eine Abbildung: (x, y, z) geht über in (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l), so oft, wie ihr Gewicht p sagt. Klicken Sie doppelt auf eine Zahl oder beginnen Sie zu tippen, um sie zu ändern; das Bild folgt jeder Taste. Ziehen Sie die Nummer einer Zeile, um sie zu verschieben.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Move the selected maps to the clipboard</source>
        <translation>Die gewählten Abbildungen in die Zwischenablage verschieben</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Der aktuellen Abbildung einen Namen geben</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing</source>
        <translation>Die gewählten Abbildungen vor Änderungen schützen</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Show the current map alone; the file does not change</source>
        <translation>Die aktuelle Abbildung allein zeigen; die Datei ändert sich nicht</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Show the names of the maps</source>
        <translation>Die Namen der Abbildungen zeigen</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f g h i j k l p, separated by tabs</source>
        <translation>Die gewählten Abbildungen als Zeilen a b c d e f g h i j k l p kopieren, durch Tabulatoren getrennt</translation>
    </message>
    <message>
        <source>Add rows of 12 or 13 numbers from the clipboard as new maps</source>
        <translation>Zeilen von 12 oder 13 Zahlen aus der Zwischenablage als neue Abbildungen hinzufügen</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 12 or 13 numbers from the clipboard</source>
        <translation>Die gewählten Abbildungen durch Zeilen von 12 oder 13 Zahlen aus der Zwischenablage ersetzen</translation>
    </message>
    <message>
        <source>Cut a map</source>
        <translation>Eine Abbildung ausschneiden</translation>
    </message>
    <message>
        <source>Cut %1 maps</source>
        <translation>%1 Abbildungen ausschneiden</translation>
    </message>
    <message>
        <source>Effective</source>
        <translation>Effektiv</translation>
    </message>
    <message>
        <source>Select a map to see and edit it here.</source>
        <translation>Wählen Sie eine Abbildung, um sie hier zu sehen und zu bearbeiten.</translation>
    </message>
    <message>
        <source>Map %1 only, of %2 selected    %3</source>
        <translation>Nur Abbildung %1, von %2 gewählten    %3</translation>
    </message>
    <message>
        <source>Show the coefficients of the maps</source>
        <translation>Die Koeffizienten der Abbildungen zeigen</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Nummern der Abbildungen</translation>
    </message>
    <message>
        <source>Drag a number to move the map. A warning sign marks a map that does not contract, or that a negative weight switches off.</source>
        <translation>Ziehen Sie eine Nummer, um die Abbildung anderswohin zu setzen. Ein Zeichen warnt vor einer Abbildung, die nicht kontrahiert oder die ein negatives Gewicht ausschaltet.</translation>
    </message>
</context>
<context>
    <name>view::MapsTable</name>
    <message>
        <source>Drag the name of a number left or right to change it in the current map: a tenth as fast with Shift, ten times as fast with Ctrl. The wheel does the same while the pointer is over the current cell. Drag the edge of a name to change the width of its column.</source>
        <translation>Ziehen Sie den Namen einer Zahl nach links oder rechts, um sie in der aktuellen Abbildung zu ändern: mit Umschalt ein Zehntel so schnell, mit Strg zehnmal so schnell. Das Mausrad tut dasselbe, solange der Zeiger über der aktuellen Zelle ist. Ziehen Sie den Rand eines Namens, um die Breite seiner Spalte zu ändern.</translation>
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
        <source>Maps that are flat on the screen cannot be dragged. First open the cage or the maps.</source>
        <translation>Abbildungen, die auf dem Bildschirm flach sind, lassen sich nicht ziehen. Öffnen Sie zuerst den Käfig oder die Abbildungen.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Erst eine Abbildung wählen.</translation>
    </message>
    <message>
        <source>There are too many maps to show them all. Zoom in to see the others.</source>
        <translation>Es sind zu viele Abbildungen, um alle zu zeigen. Vergrößern Sie, um die übrigen zu sehen.</translation>
    </message>
</context>
<context>
    <name>view::MorphDialog</name>
    <message>
        <source>A fractal in the plane cannot become one in space.</source>
        <translation>Ein Fraktal der Ebene kann nicht zu einem im Raum werden.</translation>
    </message>
    <message>
        <source>One of the two fractals has more than 256 maps.</source>
        <translation>Eines der beiden Fraktale hat mehr als 256 Abbildungen.</translation>
    </message>
    <message>
        <source>The maps of one of the two fractals are linked.</source>
        <translation>Die Abbildungen eines der beiden Fraktale sind verknüpft.</translation>
    </message>
    <message>
        <source>A bent cage has no code to start from. Reset or bake it first.</source>
        <translation>Zu einem gebogenen Käfig gehört kein Code, von dem auszugehen wäre. Setzen Sie ihn zuerst zurück oder rechnen Sie ihn ein.</translation>
    </message>
    <message>
        <source>One of the two fractals has no attractor.</source>
        <translation>Eines der beiden Fraktale hat keinen Attraktor.</translation>
    </message>
    <message>
        <source>Morph “%1”</source>
        <translation>„%1“ verwandeln</translation>
    </message>
    <message>
        <source>The entry of this file that the fractal becomes.</source>
        <translation>Der Eintrag dieser Datei, zu dem das Fraktal wird.</translation>
    </message>
    <message>
        <source>&amp;Becomes:</source>
        <translation>&amp;Wird zu:</translation>
    </message>
    <message>
        <source>&amp;Add Morph</source>
        <translation>Verwandlung &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Adds the morph to the file as an entry of its own, in one step that you can undo.</source>
        <translation>Fügt die Verwandlung der Datei als eigenen Eintrag hinzu, in einem Schritt, den Sie rückgängig machen können.</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>Paare &amp;lösen</translation>
    </message>
    <message>
        <source>Pairs all maps so that the total distance is shortest.</source>
        <translation>Lässt alle Abbildungen den kürzesten Weg gehen.</translation>
    </message>
    <message>
        <source>The morph at %1 %</source>
        <translation>Die Verwandlung bei %1 %</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Diese Datei hat kein anderes Fraktal dieser Dimension.</translation>
    </message>
</context>
<context>
    <name>view::MorphLines</name>
    <message>
        <source>Pairs of maps</source>
        <translation>Paare von Abbildungen</translation>
    </message>
    <message>
        <source>The maps of this fractal are on the left, those of the other one on the right. A line shows what a map becomes, and its thickness shows its share of the weight. Drag from a map to one in the other column to pin the pair, and again to unpin it. With the keyboard: choose a map with the arrow keys, press Space, go to the other map and press Space again. Del removes all pins of a map.</source>
        <translation>Links die Abbildungen dieses Fraktals, rechts die des anderen. Eine Linie zeigt, was aus einer Abbildung wird, und ihre Dicke, wie viel des Gewichts diesen Weg geht. Ziehen Sie von einer Abbildung zu einer in der anderen Spalte, um das Paar festzuhalten, und noch einmal, um es zu lösen. Mit der Tastatur: Wählen Sie eine Abbildung mit den Pfeiltasten, drücken Sie die Leertaste, gehen Sie zur anderen Abbildung und drücken Sie sie noch einmal. Entf löst alle Paare einer Abbildung.</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>%1 (%2 %, pinned)</source>
        <translation>%1 (%2 %, festgehalten)</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Map %1 takes no part.</source>
        <translation>Abbildung %1 nimmt nicht teil.</translation>
    </message>
    <message>
        <source>Map %1 becomes map %2.</source>
        <translation>Aus Abbildung %1 wird Abbildung %2.</translation>
    </message>
    <message>
        <source>Map %1 comes from map %2.</source>
        <translation>Abbildung %1 entsteht aus Abbildung %2.</translation>
    </message>
</context>
<context>
    <name>view::MotionDialog</name>
    <message>
        <source>Change the motion “%1”</source>
        <translation>Die Bewegung „%1“ ändern</translation>
    </message>
    <message>
        <source>Motion: %1</source>
        <translation>Bewegung: %1</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How far the branches swing at most, as an angle about their roots. A negative strength swings them the other way.</source>
        <translation>Wie weit die Äste höchstens schwingen, als Winkel um die Stelle, an der sie beginnen. Bei einer negativen Stärke schwingen sie andersherum.</translation>
    </message>
    <message>
        <source>How much the maps swell and shrink at most. With a negative strength they shrink first.</source>
        <translation>Wie sehr die Abbildungen höchstens wachsen und schrumpfen. Bei einer negativen Stärke schrumpfen sie zuerst.</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Umdrehungen</translation>
    </message>
    <message>
        <source>Cycles of wave %1</source>
        <translation>Zyklen der Welle %1</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Zyklen</translation>
    </message>
    <message>
        <source>How many turns it makes during the animation. A negative number turns the other way.</source>
        <translation>Wie oft sie in der Länge der Animation herumgeht. Bei einer negativen Zahl geht sie andersherum.</translation>
    </message>
    <message>
        <source>How many times it moves back and forth during the animation.</source>
        <translation>Wie oft sie in der Länge der Animation hin- und hergeht.</translation>
    </message>
    <message>
        <source>Limit of the strength</source>
        <translation>Grenze der Stärke</translation>
    </message>
    <message>
        <source>Only %1 is used: with more there would be no attractor at some moment.</source>
        <translation>Verwendet wird nur %1: Mit mehr gäbe es in manchem Augenblick keinen Attraktor.</translation>
    </message>
</context>
<context>
    <name>view::MotionPage</name>
    <message>
        <source>Make Keys</source>
        <translation>Schlüssel setzen</translation>
    </message>
    <message>
        <source>Make a first key, and show the tracks</source>
        <translation>Einen ersten Schlüssel setzen und die Spuren zeigen</translation>
    </message>
    <message>
        <source>Or set a key, move the playhead, and change the fractal.</source>
        <translation>Oder setzen Sie einen Schlüssel, bewegen Sie den Abspielkopf und ändern Sie das Fraktal.</translation>
    </message>
    <message>
        <source>Nothing moves yet. Choose a motion:</source>
        <translation>Noch bewegt sich nichts. Wählen Sie eine Bewegung:</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Abwandlungen von „%1“</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Abwandlungen</translation>
    </message>
    <message>
        <source>How strongly the variations differ</source>
        <translation>Wie stark die Abwandlungen abweichen</translation>
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
        <source>&amp;New Set</source>
        <translation>&amp;Neue Auswahl</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Ein anderes Blatt: der nächste Startwert</translation>
    </message>
    <message>
        <source>S&amp;trength:</source>
        <translation>S&amp;tärke:</translation>
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
        <source>The fractal in the middle replaces the one that you began with, in one step that you can undo.</source>
        <translation>Das Fraktal in der Mitte ersetzt das, mit dem Sie begonnen haben, in einem Schritt, den Sie rückgängig machen können.</translation>
    </message>
    <message>
        <source>Line of descent</source>
        <translation>Abstammungslinie</translation>
    </message>
    <message>
        <source>Every parent so far, the oldest at the top. Select one to go back to it. Its descendants stay in the list until you choose another child of it.</source>
        <translation>Alle bisherigen Elternbilder, das älteste oben. Wählen Sie eines, um zu ihm zurückzukehren. Seine Nachkommen bleiben in der Liste, bis Sie ein anderes Kind von ihm wählen.</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Line of &amp;descent</source>
        <translation>Abstammungs&amp;linie</translation>
    </message>
    <message>
        <source>How far the variations are from their parent</source>
        <translation>Wie weit die Abwandlungen vom Elternbild entfernt sind</translation>
    </message>
    <message>
        <source>On the left, the variations stay close to their parent; on the right, they differ greatly.</source>
        <translation>Links bleiben die Abwandlungen dem Elternbild ähnlich, rechts weichen sie stark ab.</translation>
    </message>
    <message>
        <source>Sha&amp;pe</source>
        <translation>&amp;Form</translation>
    </message>
    <message>
        <source>Turn, stretch and move the maps</source>
        <translation>Die Abbildungen drehen, strecken und verschieben</translation>
    </message>
    <message>
        <source>The maps are turned, stretched and moved, and occasionally one is added or removed. Locked maps, and maps that are off, stay as they are.</source>
        <translation>Die Abbildungen werden gedreht, gestreckt und verschoben; hin und wieder kommt eine hinzu oder fällt weg. Gesperrte und ausgeschaltete Abbildungen bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>Far&amp;be</translation>
    </message>
    <message>
        <source>Try other colours</source>
        <translation>Andere Farben ausprobieren</translation>
    </message>
    <message>
        <source>The hues of the palette, the plain colour and the colours of the maps change. The background and the meaning of the colours stay the same.</source>
        <translation>Palette, einfache Farbe und die Farben der Abbildungen ändern ihren Farbton. Der Hintergrund bleibt, ebenso das, wofür die Farben stehen.</translation>
    </message>
    <message>
        <source>&amp;Weights</source>
        <translation>&amp;Gewichte</translation>
    </message>
    <message>
        <source>Make some maps denser and others fainter</source>
        <translation>Manche Abbildungen dichter, andere schwächer machen</translation>
    </message>
    <message>
        <source>The weights change at random and follow the sizes of the maps. Otherwise, each map keeps its weight. A solid in space does not depend on weights; a cloud does.</source>
        <translation>Die Gewichte ändern sich zufällig und folgen der Größe der Abbildungen. Sonst behält jede Abbildung ihr Gewicht. Ein Körper im Raum hängt nicht von den Gewichten ab, eine Wolke schon.</translation>
    </message>
    <message>
        <source>What may change:</source>
        <translation>Was sich ändern darf:</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Diese Datei hat kein anderes Fraktal dieser Dimension.</translation>
    </message>
    <message>
        <source>Mix the parent with another entry of this file</source>
        <translation>Das Elternbild mit einem anderen Eintrag dieser Datei mischen</translation>
    </message>
    <message>
        <source>The variations take some maps from the parent, some from the other entry, and some that are halfway between two corresponding maps. The checkboxes above determine whether shape, colour and weights are mixed. Every child has an attractor.</source>
        <translation>Die Abwandlungen übernehmen manche Abbildungen vom Elternbild, manche vom anderen Eintrag, und manche liegen zwischen zwei zusammengehörigen. Die Kästchen oben bestimmen, ob Form, Farbe und Gewichte gemischt werden. Jedes Kind hat einen Attraktor.</translation>
    </message>
    <message>
        <source>C&amp;ross with:</source>
        <translation>&amp;Kreuzen mit:</translation>
    </message>
    <message>
        <source>The number from which the variations are generated. With the same parent, the same settings and the same seed you get the same sheet again.</source>
        <translation>Die Zahl, aus der die Abwandlungen entstehen. Mit demselben Elternbild, denselben Einstellungen und demselben Startwert erhalten Sie wieder dasselbe Blatt.</translation>
    </message>
    <message>
        <source>Shows other variations of the same parent, from the next seed.</source>
        <translation>Zeigt andere Abwandlungen desselben Elternbilds, mit dem nächsten Startwert.</translation>
    </message>
    <message>
        <source>Variation %1, not ready yet</source>
        <translation>Abwandlung %1, noch nicht fertig</translation>
    </message>
    <message>
        <source>Generation %1</source>
        <translation>Generation %1</translation>
    </message>
    <message>
        <source>Parent: the original</source>
        <translation>Elternbild: das Original</translation>
    </message>
    <message>
        <source>Parent: generation %1</source>
        <translation>Elternbild: Generation %1</translation>
    </message>
    <message>
        <source>Nothing may change, so there are no variations. Tick at least one of the checkboxes.</source>
        <translation>Nichts darf sich ändern, also gibt es keine Abwandlungen. Kreuzen Sie mindestens ein Kästchen an.</translation>
    </message>
    <message>
        <source>All maps are locked and keep their weights: the variations differ only in colours and, occasionally, in an added map. Many look like their parent.</source>
        <translation>Alle Abbildungen sind gesperrt und behalten ihre Gewichte: Die Abwandlungen unterscheiden sich nur in den Farben und ab und zu durch eine zusätzliche Abbildung. Viele gleichen dem Elternbild.</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Dieses verwenden</translation>
    </message>
    <message>
        <source>Use a variation</source>
        <translation>Abwandlung übernehmen</translation>
    </message>
    <message>
        <source>Around the picture in the middle are its variations. Click one, or press Enter on it, to put it in the middle. Double-click one to use it at once.</source>
        <translation>Rings um das Bild in der Mitte sind seine Abwandlungen. Klicken Sie auf eine oder drücken Sie darauf die Eingabetaste, um sie in die Mitte zu nehmen. Ein Doppelklick verwendet sie sofort.</translation>
    </message>
    <message>
        <source>Click a picture to put it in the middle, with variations of its own around it.</source>
        <translation>Klicken Sie auf ein Bild, um es mit eigenen Abwandlungen ringsum in die Mitte zu nehmen.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma, or an expression such as 1/2, sqrt(3)/6, cos(36°) or pi. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Eine Zahl mit Dezimalpunkt oder Komma oder ein Ausdruck wie 1/2, sqrt(3)/6, cos(36°) oder pi. Die Pfeiltasten und das Mausrad ändern sie: mit Umschalt zehnmal so schnell, mit Alt ein Zehntel so schnell. Esc stellt die vorherige Zahl wieder her.</translation>
    </message>
    <message>
        <source>An angle in degrees, with or without °, or an expression such as 360/7. An expression with pi, or with asin, acos, atan or atan2, is in radians and becomes degrees: pi/2 is 90. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Ein Winkel in Grad, mit oder ohne °, oder ein Ausdruck wie 360/7. Ein Ausdruck mit pi oder mit asin, acos, atan oder atan2 steht im Bogenmaß und wird in Grad umgerechnet: pi/2 ist 90. Die Pfeiltasten und das Mausrad ändern ihn: mit Umschalt zehnmal so schnell, mit Alt ein Zehntel so schnell. Esc stellt die vorherige Zahl wieder her.</translation>
    </message>
    <message>
        <source>%1: the number stays as it was. %2</source>
        <translation>%1: Die Zahl bleibt, wie sie war. %2</translation>
    </message>
</context>
<context>
    <name>view::OrbitRows</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>The axis that the camera goes round.</source>
        <translation>Die Achse, um die die Kamera geht.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>How far the axis is tilted, like that of a globe. With 180° the camera goes round the other way.</source>
        <translation>Wie weit die Achse geneigt ist, wie die eines Globus. Bei 180° geht die Kamera andersherum.</translation>
    </message>
    <message>
        <source>Direction of the tilt</source>
        <translation>Richtung der Neigung</translation>
    </message>
    <message>
        <source>Where the axis is tilted to: at 0° to the next one, X to Y, Y to Z and Z to X, and at 90° to the one after that.</source>
        <translation>Wohin die Achse geneigt ist: bei 0° zur nächsten, X zu Y, Y zu Z und Z zu X, und bei 90° zur übernächsten.</translation>
    </message>
    <message>
        <source>Centre of the fractal</source>
        <translation>Mitte des Fraktals</translation>
    </message>
    <message>
        <source>A point</source>
        <translation>Ein Punkt</translation>
    </message>
    <message>
        <source>Middle of the view</source>
        <translation>Mitte der Ansicht</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Drehpunkt</translation>
    </message>
    <message>
        <source>What stays in its place while everything turns.</source>
        <translation>Was an seinem Platz bleibt, während sich alles dreht.</translation>
    </message>
    <message>
        <source>%1 of the pivot</source>
        <translation>%1 des Drehpunkts</translation>
    </message>
    <message>
        <source>The point that stays in its place.</source>
        <translation>Der Punkt, der an seinem Platz bleibt.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
</context>
<context>
    <name>view::PaletteBrowser</name>
    <message>
        <source>Palettes</source>
        <translation>Paletten</translation>
    </message>
    <message>
        <source>&amp;Use This Palette</source>
        <translation>Diese Palette &amp;verwenden</translation>
    </message>
    <message>
        <source>Search palettes</source>
        <translation>Paletten suchen</translation>
    </message>
    <message>
        <source>&amp;Favourites Only</source>
        <translation>Nur &amp;Favoriten</translation>
    </message>
    <message>
        <source>Shows only the palettes that you marked with the star.</source>
        <translation>Zeigt nur die Paletten, die Sie mit dem Stern markiert haben.</translation>
    </message>
    <message>
        <source>Palettes made in Oklab, whose steps look equally large. Select one to see it on the fractal; double-click it to keep it.</source>
        <translation>Paletten aus Oklab, deren Schritte gleich groß aussehen. Wählen Sie eine aus, um sie am Fraktal zu sehen; ein Doppelklick behält sie.</translation>
    </message>
    <message>
        <source>The palette as it will be used</source>
        <translation>Die Palette, wie sie verwendet wird</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>Mark the selected palette as a favourite (Ctrl+D)</source>
        <translation>Die ausgewählte Palette als Favorit markieren (Strg+D)</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>&amp;Reversed</source>
        <translation>&amp;Umgekehrt</translation>
    </message>
    <message>
        <source>%1, a favourite</source>
        <translation>%1, ein Favorit</translation>
    </message>
    <message>
        <source>No favourites yet. Select a palette and press Ctrl+D.</source>
        <translation>Noch keine Favoriten. Wählen Sie eine Palette aus und drücken Sie Strg+D.</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Keine Treffer</translation>
    </message>
    <message>
        <source>Rotate all hues by this many degrees; the lightness stays the same</source>
        <translation>Alle Farbtöne um so viele Grad drehen; die Helligkeit bleibt gleich</translation>
    </message>
    <message>
        <source>Start farther along the palette; the part before moves to the end</source>
        <translation>Weiter hinten in der Palette beginnen; der Teil davor kommt ans Ende</translation>
    </message>
    <message>
        <source>All palettes: search them, mark favourites, and adjust the one that is selected.</source>
        <translation>Alle Paletten: Sie können suchen, Favoriten kennzeichnen und die ausgewählte anpassen.</translation>
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
        <source>The rows do not say which column is which, and programs differ. Choose the order that gives the picture you expect in the background.</source>
        <translation>Die Zeilen sagen nicht, welche Spalte welche ist, und Programme unterscheiden sich. Wählen Sie die Reihenfolge, bei der das Bild hinter diesem Dialog das erwartete ist.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Die Abbildungen, wie sie eingefügt werden</translation>
    </message>
    <message>
        <source>The maps in the chosen order: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
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
        <source>C&amp;olumns:</source>
        <translation>Spa&amp;lten:</translation>
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
        <source>In this order these maps do not contract: %1. The columns may have a different meaning.</source>
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
    <message>
        <source>&amp;Keep as It Is</source>
        <translation>&amp;So lassen</translation>
    </message>
</context>
<context>
    <name>view::PicturePaletteDialog</name>
    <message>
        <source>Palette from Picture</source>
        <translation>Palette aus Bild</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>How many colours the palette has</source>
        <translation>Wie viele Farben die Palette hat</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it.</source>
        <translation>Ziehen Sie eine Linie, um nur die Farben auf ihr zu nehmen.</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Farben:</translation>
    </message>
    <message>
        <source>Makes a palette of the colours of a picture, or of those along a line in it.</source>
        <translation>Macht eine Palette aus den Farben eines Bildes oder aus denen entlang einer Linie darin.</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>Restart to change the language.</source>
        <translation>Die neue Sprache gilt nach einem Neustart.</translation>
    </message>
    <message>
        <source>Re&amp;open last files on startup</source>
        <translation>Beim Start die letzten Dateien wieder &amp;öffnen</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Systemvorgabe</translation>
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
        <source>The colours of windows and panels. The picture keeps its own colours.</source>
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
        <source>The number of points drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Wie viele Punkte gezeichnet werden, solange sich nichts bewegt. Mehr Punkte machen ein glatteres Bild und beschäftigen den Prozessor länger.</translation>
    </message>
    <message>
        <source>When this is on, Barycage reopens the files that were open when you closed it, each in its own window.</source>
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
        <source>Not saved yet: %1.</source>
        <translation>Noch nicht gespeichert: %1.</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>How a drag turns a solid. On a turntable, vertical lines stay vertical. A trackball turns freely about the axes of the screen, even over the poles; to level the view again, look along an axis.</source>
        <translation>Wie Ziehen einen Körper dreht. Auf einem Drehteller bleibt Senkrechtes senkrecht. Ein Trackball dreht frei um die Achsen des Bildschirms, auch über die Pole; um die Ansicht wieder auszurichten, blicken Sie entlang einer Achse.</translation>
    </message>
    <message>
        <source>Restart &amp;Now</source>
        <translation>Jetzt n&amp;eu starten</translation>
    </message>
    <message>
        <source>Closes all windows, asking about unsaved changes first, and opens the same files again in the new language.</source>
        <translation>Schließt alle Fenster, fragt vorher nach ungespeicherten Änderungen und öffnet dieselben Dateien in der neuen Sprache wieder.</translation>
    </message>
    <message>
        <source>&amp;Keep the previous version of files</source>
        <translation>&amp;Vorige Fassung von Dateien aufbewahren</translation>
    </message>
    <message>
        <source>When this is on, the first time that you save a file after opening it, the version before stays beside it under the same name with “~” behind it, such as maple.ifs~.</source>
        <translation>Wenn dies eingeschaltet ist, bleibt beim ersten Speichern nach dem Öffnen die vorige Fassung daneben liegen, unter demselben Namen mit „~“ dahinter, etwa maple.ifs~.</translation>
    </message>
    <message>
        <source>Play when opened</source>
        <translation>Beim Öffnen abspielen</translation>
    </message>
    <message>
        <source>Still until played</source>
        <translation>Still, bis man abspielt</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Whether an entry that moves plays as soon as it is opened. When your desktop asks for less motion, the system default shows a still picture until you press Play.</source>
        <translation>Ob ein Eintrag, der sich bewegt, gleich beim Öffnen abgespielt wird. Wenn Ihr Desktop um weniger Bewegung bittet, zeigt die Systemvorgabe ein stilles Bild, bis Sie auf Abspielen drücken.</translation>
    </message>
    <message>
        <source>&amp;Motion:</source>
        <translation>Be&amp;wegung:</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Allgemein</translation>
    </message>
    <message>
        <source>S&amp;hortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>Resets every setting on this page to its default.</source>
        <translation>Setzt alle Einstellungen dieser Seite auf ihre Vorgaben zurück.</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Bild in Ruhe</translation>
    </message>
    <message>
        <source>Solids turn like</source>
        <translation>Körper drehen sich wie</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>&amp;Bild in Ruhe:</translation>
    </message>
    <message>
        <source>&amp;Solids turn like:</source>
        <translation>&amp;Körper drehen sich wie:</translation>
    </message>
    <message>
        <source>&amp;Names under the symbols of the toolbar</source>
        <translation>&amp;Namen unter den Symbolen der Werkzeugleiste</translation>
    </message>
    <message>
        <source>When this is on, the toolbar shows the name of each command under its symbol.</source>
        <translation>Ist das an, zeigt die Werkzeugleiste den Namen jedes Befehls unter seinem Symbol.</translation>
    </message>
    <message>
        <source>The settings of windows and pictures, the commands of the toolbar, and the keys of commands.</source>
        <translation>Die Einstellungen von Fenstern und Bildern, die Befehle der Werkzeugleiste und die Tasten der Befehle.</translation>
    </message>
    <message>
        <source>Tool&amp;bar</source>
        <translation>Werkzeug&amp;leiste</translation>
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
        <source>Problem</source>
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
        <source>Select a line to show its entry.</source>
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
        <source>Text that could not be read is kept unchanged.</source>
        <translation>Text, der nicht gelesen werden konnte, bleibt unverändert.</translation>
    </message>
    <message>
        <source>No problems: every entry was read.</source>
        <translation>Keine Probleme: Alle Einträge wurden gelesen.</translation>
    </message>
    <message>
        <source>The problems found while reading the file, with line and column. Double-click a line to go to its entry.</source>
        <translation>Die beim Lesen der Datei gefundenen Probleme, mit Zeile und Spalte. Klicken Sie doppelt auf eine Zeile, um zu ihrem Eintrag zu gehen.</translation>
    </message>
</context>
<context>
    <name>view::RandomDialog</name>
    <message>
        <source>Random Fractals</source>
        <translation>Zufällige Fraktale</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>Der Datei &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Adds the selected one as an entry of its own, in one step that you can undo.</source>
        <translation>Fügt das gewählte als eigenen Eintrag hinzu, in einem Schritt, den Sie rückgängig machen können.</translation>
    </message>
    <message>
        <source>Random fractals</source>
        <translation>Zufällige Fraktale</translation>
    </message>
    <message>
        <source>Select one and confirm, or double-click it: it is added to the file, in one step that you can undo.</source>
        <translation>Wählen Sie eines und bestätigen Sie, oder klicken Sie doppelt darauf: Es wird der Datei hinzugefügt, in einem Schritt, den Sie rückgängig machen können.</translation>
    </message>
    <message>
        <source>In the plane</source>
        <translation>In der Ebene</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Im Raum</translation>
    </message>
    <message>
        <source>Plane or space</source>
        <translation>Ebene oder Raum</translation>
    </message>
    <message>
        <source>Make systems in the plane or in space</source>
        <translation>Systeme in der Ebene oder im Raum erzeugen</translation>
    </message>
    <message>
        <source>In the plane, the contraction of the maps follows a rule that makes the fractal fill its view. In space there is no such rule: the two larger scale factors of each map follow that of the plane, and the third is smaller.</source>
        <translation>In der Ebene folgt die Stärke, mit der die Abbildungen zusammenziehen, einer Regel, nach der das Fraktal sein Bild füllt. Im Raum gibt es keine solche Regel: Die beiden größeren Streckungen jeder Abbildung folgen der Regel der Ebene, die dritte ist kleiner.</translation>
    </message>
    <message>
        <source>How many maps the systems have</source>
        <translation>Wie viele Abbildungen die Systeme haben</translation>
    </message>
    <message>
        <source>How many maps each system lists. With a symmetry, each of them also acts rotated or mirrored.</source>
        <translation>Wie viele Abbildungen in der Liste jedes Systems stehen. Mit einer Symmetrie wirkt jede auch gedreht oder gespiegelt.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Make systems that are symmetric about the origin</source>
        <translation>Systeme erzeugen, die um den Ursprung symmetrisch sind</translation>
    </message>
    <message>
        <source>Each map also acts rotated or mirrored about the origin, so the fractal is symmetric. You can change the symmetry later in the Maps panel. The tetrahedral, octahedral and icosahedral groups exist in space only.</source>
        <translation>Jede Abbildung wirkt auch um den Ursprung gedreht oder gespiegelt, sodass das Fraktal symmetrisch ist. Später können Sie die Symmetrie im Feld „Abbildungen“ ändern. Tetraeder-, Oktaeder- und Ikosaedergruppe gibt es nur im Raum.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Ordnung der Symmetrie</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Wie oft sich das Fraktal bei einer vollen Drehung wiederholt</translation>
    </message>
    <message>
        <source>A rotation of order 5 repeats the fractal five times in a full turn.</source>
        <translation>Eine Drehung der Ordnung 5 wiederholt das Fraktal fünfmal bei einer vollen Drehung.</translation>
    </message>
    <message>
        <source>&amp;Maps:</source>
        <translation>Abbil&amp;dungen:</translation>
    </message>
    <message>
        <source>S&amp;ymmetry:</source>
        <translation>S&amp;ymmetrie:</translation>
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
        <source>The number from which the systems are generated. With the same settings and the same seed you get the same sheet again.</source>
        <translation>Die Zahl, aus der die Systeme entstehen. Mit denselben Einstellungen und demselben Startwert erhalten Sie wieder dasselbe Blatt.</translation>
    </message>
    <message>
        <source>&amp;New Set</source>
        <translation>&amp;Neue Auswahl</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Ein anderes Blatt: der nächste Startwert</translation>
    </message>
    <message>
        <source>Shows other systems of the same kind, from the next seed.</source>
        <translation>Zeigt andere Systeme derselben Art, mit dem nächsten Startwert.</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Startwert:</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>Fractal %1</source>
        <translation>Fraktal %1</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Zufälliges Fraktal hinzufügen</translation>
    </message>
</context>
<context>
    <name>view::SaveViewDialog</name>
    <message>
        <source>Save View</source>
        <translation>Ansicht speichern</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Name der Ansicht</translation>
    </message>
    <message>
        <source>The name under which the view is listed in View, Saved Views, beside the zoom and in the export dialogs.</source>
        <translation>Der Name, unter dem die Ansicht in „Ansicht“, „Gespeicherte Ansichten“, neben dem Zoom und in den Exportdialogen steht.</translation>
    </message>
    <message>
        <source>&amp;Name of the view:</source>
        <translation>&amp;Name der Ansicht:</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>A fractal can have at most %1 saved views. Delete one first.</source>
        <translation>Ein Fraktal kann höchstens %1 gespeicherte Ansichten haben. Löschen Sie zuerst eine.</translation>
    </message>
    <message>
        <source>Replaces the view of this name.</source>
        <translation>Ersetzt die Ansicht dieses Namens.</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Wird als „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>Keeps the view with the fractal: one step of the history. A view of the same name is replaced.</source>
        <translation>Bewahrt die Ansicht mit dem Fraktal auf: ein Schritt im Verlauf. Eine Ansicht gleichen Namens wird ersetzt.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>E&amp;rsetzen</translation>
    </message>
</context>
<context>
    <name>view::SavedViewsDialog</name>
    <message>
        <source>Saved Views</source>
        <translation>Gespeicherte Ansichten</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>Gespeicherte Ansichten</translation>
    </message>
    <message>
        <source>The views of this fractal. Double-click one to go to it, press F2 to rename it.</source>
        <translation>Die Ansichten dieses Fraktals. Ein Doppelklick geht zu einer Ansicht, F2 benennt sie um.</translation>
    </message>
    <message>
        <source>&amp;Go To</source>
        <translation>&amp;Gehe zu</translation>
    </message>
    <message>
        <source>Shows this view on the canvas.</source>
        <translation>Zeigt diese Ansicht auf der Zeichenfläche.</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Aktualisieren</translation>
    </message>
    <message>
        <source>Replaces it by the current view of the canvas.</source>
        <translation>Ersetzt sie durch das, was die Zeichenfläche jetzt zeigt.</translation>
    </message>
    <message>
        <source>Update the view “%1”</source>
        <translation>Die Ansicht „%1“ aktualisieren</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Gives the view another name.</source>
        <translation>Gibt der Ansicht einen anderen Namen.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Deletes the view; the fractal stays as it is.</source>
        <translation>Löscht die Ansicht; das Fraktal bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Delete the view “%1”</source>
        <translation>Die Ansicht „%1“ löschen</translation>
    </message>
    <message>
        <source>Rename the view “%1” to “%2”</source>
        <translation>Die Ansicht „%1“ in „%2“ umbenennen</translation>
    </message>
</context>
<context>
    <name>view::ShadowTool</name>
    <message>
        <source>Turn the shadow</source>
        <translation>Schatten drehen</translation>
    </message>
</context>
<context>
    <name>view::Shortcuts</name>
    <message>
        <source>“%1” is used on the canvas and in fields. Choose other keys.</source>
        <translation>„%1“ wird auf der Zeichenfläche und in Feldern gebraucht. Wählen Sie andere Tasten.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
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
        <source>Move or scale along one axis, rotate in steps of 15°</source>
        <translation>Längs einer Achse bewegen oder skalieren, in Schritten von 15° drehen</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Umschalt beim Ziehen</translation>
    </message>
    <message>
        <source>Cancel the drag</source>
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
        <source>Shows only the lines that contain these words.</source>
        <translation>Zeigt nur die Zeilen, die diese Wörter enthalten.</translation>
    </message>
    <message>
        <source>All keys and mouse gestures, and what they do.</source>
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
        <source>Select a deeper or a larger branch</source>
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
        <source>Add a map or vertex to the selection, or remove it</source>
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
        <source>Remove the last vertex while defining a triangle</source>
        <translation>Die letzte Ecke zurücknehmen, während ein Dreieck festgelegt wird</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Select another stop</source>
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
        <source>Enter or Space, or double-click it</source>
        <translation>Eingabe oder Leertaste, oder Doppelklick darauf</translation>
    </message>
    <message>
        <source>Cancel the change</source>
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
    <message>
        <source>Next or previous part of the window</source>
        <translation>Nächster oder vorheriger Teil des Fensters</translation>
    </message>
    <message>
        <source>F6, Shift+F6</source>
        <translation>F6, Umschalt+F6</translation>
    </message>
    <message>
        <source>Play or stop the animation</source>
        <translation>Die Animation abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Move the playhead</source>
        <translation>Den Abspielkopf bewegen</translation>
    </message>
    <message>
        <source>drag in the ruler, or Left, Right</source>
        <translation>im Lineal ziehen, oder Links, Rechts</translation>
    </message>
    <message>
        <source>Previous or next key</source>
        <translation>Voriger oder nächster Schlüssel</translation>
    </message>
    <message>
        <source>Ctrl + Left, Right</source>
        <translation>Strg + Links, Rechts</translation>
    </message>
    <message>
        <source>First or last frame</source>
        <translation>Erstes oder letztes Bild</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>Select another row</source>
        <translation>Eine andere Zeile wählen</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Auf, Ab</translation>
    </message>
    <message>
        <source>Make or delete the key of the row</source>
        <translation>Den Schlüssel der Zeile setzen oder löschen</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Move the selected keys</source>
        <translation>Die gewählten Schlüssel verschieben</translation>
    </message>
    <message>
        <source>drag them</source>
        <translation>sie ziehen</translation>
    </message>
    <message>
        <source>Move all later keys of the row, too</source>
        <translation>Auch alle späteren Schlüssel der Zeile verschieben</translation>
    </message>
    <message>
        <source>Alt while dragging</source>
        <translation>Alt beim Ziehen</translation>
    </message>
    <message>
        <source>Copy the keys</source>
        <translation>Die Schlüssel kopieren</translation>
    </message>
    <message>
        <source>Ctrl while dragging</source>
        <translation>Strg beim Ziehen</translation>
    </message>
    <message>
        <source>Copy, paste, select all keys</source>
        <translation>Schlüssel kopieren, einfügen, alle wählen</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V, Ctrl+A</source>
        <translation>Strg+C, Strg+V, Strg+A</translation>
    </message>
    <message>
        <source>Delete the selected keys, or the motion</source>
        <translation>Die gewählten Schlüssel oder die Bewegung löschen</translation>
    </message>
    <message>
        <source>Choose how a key leads to the next</source>
        <translation>Wählen, wie ein Schlüssel zum nächsten führt</translation>
    </message>
    <message>
        <source>right-click it</source>
        <translation>Rechtsklick darauf</translation>
    </message>
    <message>
        <source>Zoom the ruler</source>
        <translation>Das Lineal vergrößern</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Strg + Mausrad</translation>
    </message>
    <message>
        <source>In the timeline</source>
        <translation>In der Zeitleiste</translation>
    </message>
    <message>
        <source>In the table of maps</source>
        <translation>In der Tabelle der Abbildungen</translation>
    </message>
    <message>
        <source>Show one map alone, or all of them again</source>
        <translation>Eine Abbildung allein zeigen, oder wieder alle</translation>
    </message>
    <message>
        <source>Alt + click on its eye</source>
        <translation>Alt + Klick auf ihr Auge</translation>
    </message>
    <message>
        <source>Rotate the view</source>
        <translation>Die Ansicht drehen</translation>
    </message>
    <message>
        <source>Ctrl + Shift + wheel</source>
        <translation>Strg + Umschalt + Mausrad</translation>
    </message>
    <message>
        <source>Change the stop colour</source>
        <translation>Die Farbe der Marke ändern</translation>
    </message>
    <message>
        <source>Ball of axes, after the last handle: choose an end</source>
        <translation>Achsenkugel, nach dem letzten Griff: ein Ende wählen</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Ball of axes: look along the axis, then from behind</source>
        <translation>Achsenkugel: entlang der Achse blicken, dann von hinten</translation>
    </message>
    <message>
        <source>Enter or Space</source>
        <translation>Eingabe oder Leertaste</translation>
    </message>
    <message>
        <source>Ball of axes: turn the view, return to the canvas</source>
        <translation>Achsenkugel: die Ansicht drehen, zurück zur Zeichenfläche</translation>
    </message>
    <message>
        <source>Shift + arrow keys, Esc</source>
        <translation>Umschalt + Pfeiltasten, Esc</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsPage</name>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Vorgabe</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>T&amp;auschen</translation>
    </message>
    <message>
        <source>Find a command or keys</source>
        <translation>Befehl oder Tasten suchen</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Shortcut:</source>
        <translation>Tasten&amp;kürzel:</translation>
    </message>
    <message>
        <source>Press the keys that the selected command is to have. Tab goes on to the next field.</source>
        <translation>Drücken Sie die Tasten, die der gewählte Befehl haben soll. Die Tabulatortaste führt zum nächsten Feld.</translation>
    </message>
    <message>
        <source>Takes the keys from the selected command.</source>
        <translation>Nimmt dem gewählten Befehl seine Tasten.</translation>
    </message>
    <message>
        <source>Gives the selected command the keys that it has without your choice.</source>
        <translation>Gibt dem gewählten Befehl die Tasten zurück, die er von Haus aus hat.</translation>
    </message>
    <message>
        <source>Gives these keys to the selected command, and its present ones to the other.</source>
        <translation>Gibt diese Tasten dem gewählten Befehl und dessen bisherige dem anderen.</translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”.</source>
        <translation>„%1“ gehört zu „%2“.</translation>
    </message>
    <message>
        <source>“%1” has no keys now.</source>
        <translation>„%1“ hat jetzt keine Tasten.</translation>
    </message>
    <message>
        <source>“%1” has “%2” now.</source>
        <translation>„%1“ hat jetzt „%2“.</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Show only the commands whose name, synonyms or keys begin with these words.</source>
        <translation>Zeigt nur die Befehle, deren Name, Synonyme oder Tasten mit diesen Wörtern beginnen.</translation>
    </message>
    <message>
        <source>The commands of the menus and their keys; your own are bold. Select one to change its keys.</source>
        <translation>Die Befehle der Menüs und ihre Tasten; Ihre eigenen sind fett. Wählen Sie einen Befehl, um seine Tasten zu ändern.</translation>
    </message>
</context>
<context>
    <name>view::SliceRows</name>
    <message>
        <source>Slice</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Ganz</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Hälfte</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Lage der Ebene</translation>
    </message>
    <message>
        <source>Thickness of the slice</source>
        <translation>Dicke der Scheibe</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Direction of the plane</source>
        <translation>Richtung der Ebene</translation>
    </message>
    <message>
        <source>Sets the plane perpendicular to an axis or the diagonal; type any other normal in the fields below.</source>
        <translation>Legt die Ebene quer zu einer Achse oder zur Diagonalen; die Felder darunter nehmen jede Normale.</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>Quer zu X</translation>
    </message>
    <message>
        <source>Across Y</source>
        <translation>Quer zu Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>Quer zu Z</translation>
    </message>
    <message>
        <source>Across the diagonal</source>
        <translation>Quer zur Diagonalen</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Wie eingegeben</translation>
    </message>
    <message>
        <source>Turn the Slice</source>
        <translation>Schnitt drehen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>x of the normal</source>
        <translation>x der Normalen</translation>
    </message>
    <message>
        <source>y of the normal</source>
        <translation>y der Normalen</translation>
    </message>
    <message>
        <source>z of the normal</source>
        <translation>z der Normalen</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Show the Whole Solid</source>
        <translation>Den ganzen Körper zeigen</translation>
    </message>
    <message>
        <source>Cut the Solid</source>
        <translation>Den Körper aufschneiden</translation>
    </message>
    <message>
        <source>Cuts the picture open by hiding everything in front of a plane, or everything outside a slice. Drag the plane by the handle at its centre.</source>
        <translation>Schneidet das Bild auf: Alles vor einer Ebene oder alles außerhalb einer Scheibe wird ausgeblendet. Ziehen Sie die Ebene am Griff in ihrer Mitte.</translation>
    </message>
    <message>
        <source>The direction perpendicular to the plane</source>
        <translation>Die Richtung senkrecht zur Ebene</translation>
    </message>
    <message>
        <source>Thin slice</source>
        <translation>Scheibe</translation>
    </message>
</context>
<context>
    <name>view::SnapshotDelegate</name>
    <message>
        <source>Name of the snapshot</source>
        <translation>Name des Schnappschusses</translation>
    </message>
</context>
<context>
    <name>view::SnapshotLook</name>
    <message>
        <source>There is no snapshot to compare with yet. Take one first: Edit, Take Snapshot.</source>
        <translation>Es gibt noch keinen Schnappschuss zum Vergleichen. Nehmen Sie zuerst einen auf: „Bearbeiten“, „Schnappschuss aufnehmen“.</translation>
    </message>
    <message>
        <source>Nothing has changed since “%1”.</source>
        <translation>Seit „%1“ hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>“%1” cannot be compared: one is in the plane, the other in space. Click the snapshot to restore it.</source>
        <translation>„%1“ lässt sich nicht vergleichen: Eines liegt in der Ebene, das andere im Raum. Klicken Sie den Schnappschuss an, um ihn wiederherzustellen.</translation>
    </message>
    <message>
        <source>This is “%1”. Esc returns to the fractal.</source>
        <translation>Das ist „%1“. Esc kehrt zum Fraktal zurück.</translation>
    </message>
</context>
<context>
    <name>view::Snapshots</name>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Ein Eintrag, der nicht gelesen werden konnte, hat keine Schnappschüsse.</translation>
    </message>
    <message>
        <source>“%1” is the same as the fractal.</source>
        <translation>„%1“ ist bereits dasselbe.</translation>
    </message>
    <message>
        <source>Snapshot %1</source>
        <translation>Schnappschuss %1</translation>
    </message>
    <message>
        <source>Restore “%1”</source>
        <translation>„%1“ wiederherstellen</translation>
    </message>
    <message>
        <source>“%1” was deleted. To bring it back, use the menu of the panel.</source>
        <translation>„%1“ wurde gelöscht. Das Kontextmenü des Feldes holt ihn zurück.</translation>
    </message>
    <message>
        <source>Add “%1” as an entry</source>
        <translation>„%1“ als Eintrag hinzufügen</translation>
    </message>
    <message>
        <source>Added to the file as the entry “%1”.</source>
        <translation>Als Eintrag „%1“ zur Datei hinzugefügt.</translation>
    </message>
    <message>
        <source>%1 of “%2”</source>
        <comment>snapshot, entry</comment>
        <translation>%1 von „%2“</translation>
    </message>
</context>
<context>
    <name>view::SnapshotsPanel</name>
    <message>
        <source>Snapshots</source>
        <translation>Schnappschüsse</translation>
    </message>
    <message>
        <source>Snapshots of the fractal</source>
        <translation>Schnappschüsse des Fraktals</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Restore the fractal to this snapshot.</source>
        <translation>Das Fraktal so machen, wie es in diesem Schnappschuss war.</translation>
    </message>
    <message>
        <source>&amp;Add as Entry</source>
        <translation>&amp;Als Eintrag hinzufügen</translation>
    </message>
    <message>
        <source>Add the snapshot to the file as an entry of its own, after this one.</source>
        <translation>Den Schnappschuss als eigenen Eintrag hinter diesem zur Datei hinzufügen.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Give the snapshot another name.</source>
        <translation>Dem Schnappschuss einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete the snapshot; the fractal stays as it is.</source>
        <translation>Den Schnappschuss löschen; das Fraktal bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>&amp;Bring Back</source>
        <translation>&amp;Zurückholen</translation>
    </message>
    <message>
        <source>Bring back the snapshot that was deleted last.</source>
        <translation>Den zuletzt gelöschten Schnappschuss zurückholen.</translation>
    </message>
    <message>
        <source>shown on the canvas</source>
        <translation>auf der Zeichenfläche gezeigt</translation>
    </message>
    <message>
        <source>the one to compare with</source>
        <translation>der zum Vergleichen</translation>
    </message>
    <message>
        <source>&amp;Bring Back “%1”</source>
        <translation>„%1“ &amp;zurückholen</translation>
    </message>
    <message>
        <source>No snapshots of this fractal yet. Press %1 to keep its state, change it, and press %2 to compare.</source>
        <translation>Noch keine Schnappschüsse dieses Fraktals. Drücken Sie %1, um seinen Zustand festzuhalten, ändern Sie es, und drücken Sie %2, um zu vergleichen.</translation>
    </message>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Ein Eintrag, der nicht gelesen werden konnte, hat keine Schnappschüsse.</translation>
    </message>
    <message>
        <source>Click a snapshot to restore it; undo goes back. The arrow keys or a right click select the one to compare with. F2 renames it, Del deletes it.</source>
        <translation>Klicken Sie einen Schnappschuss an, um ihn wiederherzustellen; Rückgängig führt zurück. Mit den Pfeiltasten oder einem Rechtsklick wählen Sie den aus, mit dem verglichen wird. F2 benennt ihn um, Entf löscht ihn.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept. Click one to restore it, as one step of the history. The frame marks the snapshot that the canvas shows. The B marks the selected snapshot, the one to compare with: the newest, until you select another one with the arrow keys or a right click. Snapshots last until the file is closed; Add as Entry keeps one in the file.</source>
        <translation>Zustände dieses Fraktals, die Sie festgehalten haben. Klicken Sie einen an, um ihn wiederherzustellen: ein Schritt im Verlauf. Der umrahmte ist der, den die Zeichenfläche zeigt. Der, der ein B trägt, ist ausgewählt, und mit ihm wird verglichen: mit dem neuesten, bis Sie mit den Pfeiltasten oder einem Rechtsklick einen anderen auswählen. Schnappschüsse bleiben, bis die Datei geschlossen wird; „Als Eintrag hinzufügen“ bewahrt einen in der Datei auf.</translation>
    </message>
</context>
<context>
    <name>view::SoloMap</name>
    <message>
        <source>One map is shown alone. Choose Solo again to show all; the file does not change.</source>
        <translation>Eine Abbildung wird allein gezeigt. Solo noch einmal wählen zeigt alle; die Datei ändert sich nicht.</translation>
    </message>
</context>
<context>
    <name>view::SpaceExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>„%1“ exportieren</translation>
    </message>
    <message>
        <source>OpenSCAD program (.scad)</source>
        <translation>OpenSCAD-Programm (.scad)</translation>
    </message>
    <message>
        <source>A picture as the camera shows it, a watertight mesh that contains the attractor, or the maps as a program for OpenSCAD.</source>
        <translation>Ein Bild, wie es die Kamera zeigt, ein wasserdichter Körper, der den Attraktor enthält, oder die Abbildungen als Programm für OpenSCAD.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Fragt nach dem Namen der Datei und schreibt sie.</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Größe:</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Zeichnet so viele Pixel längs jeder Seite eines Pixels: glattere Kanten.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>Ü&amp;berabtastung:</translation>
    </message>
    <message>
        <source>Bits per channel. Depths always have 16.</source>
        <translation>Bit für jeden Kanal. Tiefen haben immer 16.</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>Makes the surroundings of the solid transparent.</source>
        <translation>Lässt weg, was um den Körper herum ist.</translation>
    </message>
    <message>
        <source>For both eyes: two pictures side by side, or one in red and cyan.</source>
        <translation>Für beide Augen: zwei Bilder nebeneinander, oder eines in Rot und Cyan.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The longest side of the mesh.</source>
        <translation>Die längste Seite des Körpers.</translation>
    </message>
    <message>
        <source>&amp;Longest side:</source>
        <translation>Lä&amp;ngste Seite:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>Auf&amp;lösung:</translation>
    </message>
    <message>
        <source>Thinner parts are thickened to this, so that they can be printed.</source>
        <translation>Dünnere Teile werden so dick gemacht, dass sie sich drucken lassen.</translation>
    </message>
    <message>
        <source>Smallest &amp;wall:</source>
        <translation>Kleinste &amp;Wand:</translation>
    </message>
    <message>
        <source>Fill closed ca&amp;vities</source>
        <translation>Geschlossene &amp;Hohlräume füllen</translation>
    </message>
    <message>
        <source>Fills spaces that are closed off from the outside.</source>
        <translation>Füllt, was von außen abgeschlossen ist.</translation>
    </message>
    <message>
        <source>One multmatrix for each map; open it in OpenSCAD to render it.</source>
        <translation>Ein multmatrix für jede Abbildung; öffnen Sie es in OpenSCAD, um es zu berechnen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Depths can be written only as PNG.</source>
        <translation>Tiefen werden nur als PNG geschrieben.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the file to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Fragt nach einem Dateinamen und erstellt die Datei, wenn sie an der Reihe ist, nach denen, die im Feld „Exporte“ warten. Die Warteschlange läuft nach einem Neustart weiter.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Die Ansicht auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>Die Ansicht „%1“</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Ausschn&amp;itt:</translation>
    </message>
    <message>
        <source>A closed surface around the attractor, for a printer.</source>
        <translation>Eine geschlossene Fläche um den Attraktor, für einen Drucker.</translation>
    </message>
    <message>
        <source>The whole solid is written, not only the slice.</source>
        <translation>Der ganze Körper wird geschrieben, nicht nur der Schnitt.</translation>
    </message>
    <message>
        <source>Voxels along the longest side: more voxels make finer steps. A solid has at most %1 million voxels and %2 million triangles.</source>
        <translation>Voxel längs der längsten Seite: feinere Stufen, und mehr davon. Ein Körper hat höchstens %1 Millionen Voxel und %2 Millionen Dreiecke.</translation>
    </message>
    <message>
        <source>A solid has no shapes: the file contains its picture in pixels.</source>
        <translation>Ein Körper hat keine Formen: Die Datei enthält sein Bild in Pixeln.</translation>
    </message>
    <message>
        <source>Stere&amp;o:</source>
        <translation>Stere&amp;o:</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format. It must end with one of these: %2.</source>
        <translation>Der Name „%1“ nennt kein Format. Er muss auf eine dieser Endungen enden: %2.</translation>
    </message>
    <message>
        <source>Include the ca&amp;ge</source>
        <translation>Mit &amp;Käfig</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Zeichnet den Käfig über das Bild.</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>Der ganze Attraktor</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Was das Bild zeigt: was die Zeichenfläche zeigt, oder den Attraktor mit schmalem Rand, wohin die Zeichenfläche auch blickt. Gespeicherte Ansichten stehen ebenfalls in der Liste.</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 Bit je Kanal</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
        <translation>16 Bit je Kanal, zur weiteren Arbeit am Bild</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>F&amp;arbtiefe:</translation>
    </message>
</context>
<context>
    <name>view::SpaceInput</name>
    <message>
        <source>Rotate Cage</source>
        <translation>Käfig drehen</translation>
    </message>
    <message>
        <source>Scale Cage</source>
        <translation>Käfig skalieren</translation>
    </message>
    <message>
        <source>Move Vertex %1</source>
        <translation>Ecke %1 bewegen</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Move Face %1</source>
        <translation>Seite %1 bewegen</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Mittelpunkt der Symmetrie verschieben</translation>
    </message>
</context>
<context>
    <name>view::SpaceRows</name>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>A lit solid, the density of its points, or data for other programs.</source>
        <translation>Ein beleuchteter Körper, die Dichte seiner Punkte, oder Zahlen für andere Programme.</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Stein</translation>
    </message>
    <message>
        <source>A solid lit by a lamp that you can move</source>
        <translation>Ein Körper im Licht einer Lampe, die sich bewegen lässt</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tusche</translation>
    </message>
    <message>
        <source>A solid with dark creases on paper, for print</source>
        <translation>Ein Körper mit dunklen Falten auf Papier, zum Drucken</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Wolke</translation>
    </message>
    <message>
        <source>The density of points, as in the plane</source>
        <translation>Die Dichte der Punkte, wie in der Ebene</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Röntgenbild</translation>
    </message>
    <message>
        <source>The density of points, coloured by their mean depth</source>
        <translation>Die Dichte der Punkte, gefärbt nach ihrer mittleren Tiefe</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Near white, far black</source>
        <translation>Nahes weiß, Fernes schwarz</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normalen</translation>
    </message>
    <message>
        <source>The direction of the surface as a colour, for compositing</source>
        <translation>Die Richtung der Oberfläche als Farbe, zum Weiterverarbeiten</translation>
    </message>
    <message>
        <source>Look: %1</source>
        <translation>Darstellung: %1</translation>
    </message>
    <message>
        <source>Colour of the solid by</source>
        <translation>Farbe des Körpers nach</translation>
    </message>
    <message>
        <source>What the colour of the surface shows.</source>
        <translation>Was die Farbe der Oberfläche zeigt.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Eine Farbe</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Abbildung</translation>
    </message>
    <message>
        <source>The colour of the map whose piece it is</source>
        <translation>Die Farbe der Abbildung, zu deren Teil es gehört</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The palette along the addresses</source>
        <translation>Die Palette entlang der Adressen</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>The palette from bottom to top</source>
        <translation>Die Palette von unten nach oben</translation>
    </message>
    <message>
        <source>The palette from near to far</source>
        <translation>Die Palette von nah nach fern</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Färben nach: %1</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>The direction of the light as seen by the camera; in the middle, it shines from the camera.</source>
        <translation>Wo die Lampe vom Auge aus gesehen steht: In der Mitte ist sie das Auge selbst.</translation>
    </message>
    <message>
        <source>Light: %1°, %2°</source>
        <translation>Licht: %1°, %2°</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>How fast colours fade with depth</source>
        <translation>Wie schnell Farben mit der Tiefe verblassen</translation>
    </message>
    <message>
        <source>Fog: %1</source>
        <translation>Nebel: %1</translation>
    </message>
</context>
<context>
    <name>view::SpaceView</name>
    <message>
        <source>Canvas in space</source>
        <translation>Zeichenfläche im Raum</translation>
    </message>
    <message>
        <source>The solid and its tetrahedron. Drag a corner: X, Y or Z keeps it on an axis, with Shift in a plane, and the wheel pushes it away. Drag anywhere else to turn the view; the wheel zooms at the pointer, the middle button pans. Double-click the solid to turn about that point.</source>
        <translation>Der Körper und sein Tetraeder. Ziehen Sie eine Ecke: X, Y oder Z hält sie auf einer Achse, mit Umschalt in einer Ebene, und das Rad schiebt sie fort. Ziehen Sie anderswo, um die Ansicht zu drehen; das Rad zoomt am Zeiger, die mittlere Taste verschiebt. Ein Doppelklick auf den Körper macht den Punkt zur Mitte der Drehung.</translation>
    </message>
    <message>
        <source>Vertex %1 at %2, %3, %4</source>
        <translation>Ecke %1 bei %2, %3, %4</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Einpassen</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspektive</translation>
    </message>
    <message>
        <source>Look from the F&amp;ront</source>
        <translation>Von &amp;vorne sehen</translation>
    </message>
    <message>
        <source>Look from the &amp;Right</source>
        <translation>Von &amp;rechts sehen</translation>
    </message>
    <message>
        <source>Look from &amp;Above</source>
        <translation>Von &amp;oben sehen</translation>
    </message>
    <message>
        <source>Canvas in space: %1</source>
        <translation>Zeichenfläche im Raum: %1</translation>
    </message>
    <message>
        <source>Map %5, corner %1 at %2, %3, %4</source>
        <translation>Abbildung %5, Ecke %1 bei %2, %3, %4</translation>
    </message>
    <message>
        <source>Corner %1 of the branch at %2, %3, %4</source>
        <translation>Ecke %1 des Astes bei %2, %3, %4</translation>
    </message>
    <message>
        <source>Map %4, its middle at %1, %2, %3</source>
        <translation>Abbildung %4, ihre Mitte bei %1, %2, %3</translation>
    </message>
    <message>
        <source>The middle of the branch at %1, %2, %3</source>
        <translation>Die Mitte des Astes bei %1, %2, %3</translation>
    </message>
    <message>
        <source>The attractor and its control tetrahedron. Tab moves from corner to corner and to the ball of axes, the arrow keys move the corner in focus or turn the view, F6 leaves the canvas.</source>
        <translation>Der Attraktor und sein Kontrolltetraeder. Tab wechselt von Ecke zu Ecke und zur Achsenkugel, die Pfeiltasten bewegen die Ecke mit dem Fokus oder drehen die Ansicht, F6 verlässt die Zeichenfläche.</translation>
    </message>
    <message>
        <source>Ball of axes, positive end of %1.</source>
        <translation>Achsenkugel, positives Ende von %1.</translation>
    </message>
    <message>
        <source>Ball of axes, negative end of %1.</source>
        <translation>Achsenkugel, negatives Ende von %1.</translation>
    </message>
    <message>
        <source>The view looks from there; Enter looks from behind.</source>
        <translation>Die Ansicht blickt von dort; die Eingabetaste blickt von hinten.</translation>
    </message>
    <message>
        <source>Enter looks from there, the arrow keys choose another end.</source>
        <translation>Die Eingabetaste blickt von dort, die Pfeiltasten wählen ein anderes Ende.</translation>
    </message>
</context>
<context>
    <name>view::StartShapeBox</name>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Aus</translation>
    </message>
    <message>
        <source>The Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>A Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>A Letter</source>
        <translation>Buchstabe</translation>
    </message>
    <message>
        <source>A Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>What the steps start from</source>
        <translation>Woraus die Schritte hervorgehen</translation>
    </message>
    <message>
        <source>What the steps start from. Whatever you choose, the images get closer to the same attractor: a square, a letter that you type, or the dark shape in a picture, each as large as the attractor.</source>
        <translation>Woraus die Schritte hervorgehen. Was immer Sie wählen, die Bilder kommen demselben Attraktor näher: ein Quadrat, ein getippter Buchstabe oder die dunkle Form in einem Bild, jeweils so groß wie der Attraktor.</translation>
    </message>
    <message>
        <source>Letters to start from</source>
        <translation>Buchstaben am Anfang</translation>
    </message>
    <message>
        <source>One letter, or up to three</source>
        <translation>Ein Buchstabe, oder bis zu drei</translation>
    </message>
    <message>
        <source>The letter that the steps start from, or up to three letters. One that is not symmetric, such as R, shows how the maps turn and reflect.</source>
        <translation>Der Buchstabe, aus dem die Schritte hervorgehen, oder bis zu drei. Einer ohne Symmetrie, etwa R, zeigt, wie die Abbildungen drehen und spiegeln.</translation>
    </message>
    <message>
        <source>Choose a Picture to Start From</source>
        <translation>Ausgangsbild wählen</translation>
    </message>
</context>
<context>
    <name>view::StepsBridge</name>
    <message>
        <source>The picture has no dark shape on a light background.</source>
        <translation>Das Bild enthält keine dunkle Form auf hellem Grund.</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Das Bild konnte nicht gelesen werden.</translation>
    </message>
</context>
<context>
    <name>view::StoringReport</name>
    <message>
        <source>The settings cannot be saved: “%1” is not writable, or the disk is full.</source>
        <translation>Die Einstellungen können nicht gespeichert werden: „%1“ ist nicht beschreibbar, oder der Datenträger ist voll.</translation>
    </message>
</context>
<context>
    <name>view::StretchDialog</name>
    <message>
        <source>From frame</source>
        <translation>Von Bild</translation>
    </message>
    <message>
        <source>Keys up to this frame stay where they are.</source>
        <translation>Schlüssel bis zu diesem Bild bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>Bis Bild</translation>
    </message>
    <message>
        <source>The end of the range. Later keys keep their distance to it.</source>
        <translation>Das Ende des Bereichs. Spätere Schlüssel behalten ihren Abstand dazu.</translation>
    </message>
    <message>
        <source>Ends at frame</source>
        <translation>Endet bei Bild</translation>
    </message>
    <message>
        <source>Where the range ends from now on: later for slower, earlier for faster.</source>
        <translation>Wo der Bereich künftig endet: später für langsamer, früher für schneller.</translation>
    </message>
    <message>
        <source>Stretch Keys</source>
        <translation>Schlüssel dehnen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>&amp;Stretch</source>
        <translation>&amp;Dehnen</translation>
    </message>
    <message>
        <source>Moves the keys of all tracks, in one step that you can undo.</source>
        <translation>Verschiebt die Schlüssel aller Spuren, in einem Schritt, den Sie rückgängig machen können.</translation>
    </message>
    <message>
        <source>&amp;From frame:</source>
        <translation>&amp;Von Bild:</translation>
    </message>
    <message>
        <source>&amp;To frame:</source>
        <translation>&amp;Bis Bild:</translation>
    </message>
    <message>
        <source>&amp;Ends at frame:</source>
        <translation>&amp;Endet bei Bild:</translation>
    </message>
    <message>
        <source>The range has to end after its first frame.</source>
        <translation>Der Bereich muss nach seinem ersten Bild enden.</translation>
    </message>
    <message>
        <source>Two keys would meet at one frame, or the animation would be too long.</source>
        <translation>Zwei Schlüssel würden auf ein Bild fallen, oder die Animation würde zu lang.</translation>
    </message>
    <message>
        <source>Stretch keys</source>
        <translation>Schlüssel dehnen</translation>
    </message>
</context>
<context>
    <name>view::SuggestionList</name>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n Abbildung</numerusform>
            <numerusform>%n Abbildungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean distance %1 px</source>
        <translation>Mittlerer Abstand %1 px</translation>
    </message>
    <message>
        <source>Overlap %1 %</source>
        <translation>Überlappung %1 %</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>Click a suggestion to use it; undo goes back</source>
        <translation>Klicken Sie einen Vorschlag an, um ihn zu verwenden; Rückgängig führt zurück</translation>
    </message>
    <message>
        <source>Guaranteed within %1 px</source>
        <translation>Garantiert bis auf %1 px</translation>
    </message>
</context>
<context>
    <name>view::SymmetryRow</name>
    <message>
        <source>Symmetry</source>
        <translation>Symmetrie</translation>
    </message>
    <message>
        <source>Repeat every map under a group of rotations or mirror images</source>
        <translation>Jede Abbildung unter einer Gruppe von Drehungen oder Spiegelungen wiederholen</translation>
    </message>
    <message>
        <source>With a symmetry, each map of the list also acts rotated or mirrored about the centre, so the fractal is symmetric. The copies are not listed; Expand lists them. On the canvas, drag the handle of the centre.</source>
        <translation>Mit einer Symmetrie wirkt jede Abbildung der Liste auch um den Mittelpunkt gedreht oder gespiegelt, sodass das Fraktal symmetrisch ist. Die Kopien stehen nicht in der Liste; „Ausschreiben“ nimmt sie auf. Auf der Zeichenfläche ziehen Sie den Griff des Mittelpunkts.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Ordnung der Symmetrie</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Wie oft sich das Fraktal bei einer vollen Drehung wiederholt</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Ausschreiben</translation>
    </message>
    <message>
        <source>Expand the symmetry</source>
        <translation>Symmetrie ausschreiben</translation>
    </message>
    <message>
        <source>Writes the copies that the symmetry makes into the list, as maps of their own, so that you can change them individually. The picture stays the same.</source>
        <translation>Schreibt die Kopien, die die Symmetrie macht, als eigene Abbildungen in die Liste, sodass Sie eine allein ändern können. Das Bild bleibt gleich.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mittelpunkt x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mittelpunkt y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Mittelpunkt z</translation>
    </message>
    <message>
        <source>Centre of the symmetry, x</source>
        <translation>Mittelpunkt der Symmetrie, x</translation>
    </message>
    <message>
        <source>Centre of the symmetry, y</source>
        <translation>Mittelpunkt der Symmetrie, y</translation>
    </message>
    <message>
        <source>Centre of the symmetry, z</source>
        <translation>Mittelpunkt der Symmetrie, z</translation>
    </message>
    <message>
        <source>The point that the symmetry leaves unchanged</source>
        <translation>Der Punkt, den die Symmetrie an seinem Platz lässt</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Mittelpunkt der Symmetrie verschieben</translation>
    </message>
    <message>
        <source>Angle of the mirror</source>
        <translation>Winkel der Spiegelachse</translation>
    </message>
    <message>
        <source>Direction of a mirror, in degrees counter-clockwise</source>
        <translation>Richtung einer Spiegelachse, in Grad gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Winkel °</translation>
    </message>
    <message>
        <source>Turn the mirrors of the symmetry</source>
        <translation>Spiegelachsen der Symmetrie drehen</translation>
    </message>
    <message>
        <source>List the maps that the symmetry stands for</source>
        <translation>Die Abbildungen auflisten, für die die Symmetrie steht</translation>
    </message>
    <message>
        <source>Remove the symmetry</source>
        <translation>Symmetrie entfernen</translation>
    </message>
    <message>
        <source>Set the symmetry</source>
        <translation>Symmetrie festlegen</translation>
    </message>
</context>
<context>
    <name>view::SymmetryTool</name>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Mittelpunkt der Symmetrie verschieben</translation>
    </message>
</context>
<context>
    <name>view::TargetBox</name>
    <message>
        <source>Only maps that contract give a shape to trace.</source>
        <translation>Nur Abbildungen, die zusammenziehen, ergeben eine Form zum Nachzeichnen.</translation>
    </message>
    <message>
        <source>The attractor is a single point.</source>
        <translation>Der Attraktor ist ein einzelner Punkt.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Choose the picture that the fractal should look like</source>
        <translation>Das Bild wählen, dem das Fraktal gleichen soll</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Entry of This File</source>
        <translation>Eintrag dieser Datei</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Use the picture on the clipboard</source>
        <translation>Das Bild der Zwischenablage verwenden</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape:</source>
        <translation>Form:</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Trace the background instead</source>
        <translation>Stattdessen den Hintergrund nachzeichnen</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>The shade up to which a pixel belongs to the shape</source>
        <translation>Der Grauwert, bis zu dem ein Pixel zur Form gehört</translation>
    </message>
    <message>
        <source>Threshold:</source>
        <translation>Schwelle:</translation>
    </message>
    <message>
        <source>Automatic threshold</source>
        <translation>Automatische Schwelle</translation>
    </message>
    <message>
        <source>Find the threshold that best separates dark from light (Otsu)</source>
        <translation>Dunkel und Hell so gut trennen, wie eine Schwelle es kann (Otsu)</translation>
    </message>
    <message>
        <source>Opacity of the target</source>
        <translation>Deckkraft des Ziels</translation>
    </message>
    <message>
        <source>How strongly the target is shown on the canvas</source>
        <translation>Wie kräftig das Ziel auf der Zeichenfläche erscheint</translation>
    </message>
    <message>
        <source>Opacity:</source>
        <translation>Deckkraft:</translation>
    </message>
    <message>
        <source>Crop to Shape</source>
        <translation>Auf die Form zuschneiden</translation>
    </message>
    <message>
        <source>Use only the part around the shape</source>
        <translation>Nur den Teil um die Form verwenden</translation>
    </message>
    <message>
        <source>Whole Picture</source>
        <translation>Ganzes Bild</translation>
    </message>
    <message>
        <source>Use the whole picture again</source>
        <translation>Wieder das ganze Bild verwenden</translation>
    </message>
    <message>
        <source>There is no picture on the clipboard.</source>
        <translation>In der Zwischenablage ist kein Bild.</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Eingefügtes Bild</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>„%1“ wird gelesen…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Das Bild konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels</source>
        <translation>%1, %2 × %3 Pixel</translation>
    </message>
    <message>
        <source>Choose, paste or drop a picture on the window.</source>
        <translation>Wählen Sie ein Bild, fügen Sie eines ein oder ziehen Sie eines auf das Fenster.</translation>
    </message>
    <message>
        <source>With these settings, the shape is empty or fills the picture.</source>
        <translation>Mit diesen Einstellungen ist die Form leer oder füllt das Bild.</translation>
    </message>
    <message>
        <source>Remove the target and work without one</source>
        <translation>Das Ziel entfernen und ohne Ziel arbeiten</translation>
    </message>
    <message>
        <source>Dark pixels</source>
        <translation>Dunkle Pixel</translation>
    </message>
    <message>
        <source>Opaque pixels</source>
        <translation>Deckende Pixel</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape</source>
        <translation>Welche Pixel zur Form gehören</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape. Automatic takes the opaque pixels if any part of the picture is transparent, otherwise the dark ones.</source>
        <translation>Welche Pixel zur Form gehören. Automatisch sind es die deckenden, wenn das Bild irgendwo durchsichtig ist, sonst die dunklen.</translation>
    </message>
    <message>
        <source>%1, reduced to %2 × %3 pixels</source>
        <translation>%1, verkleinert auf %2 × %3 Pixel</translation>
    </message>
    <message>
        <source>The target is not saved with the file. It is kept while the file is open.</source>
        <translation>Das Ziel wird nicht mit der Datei gespeichert. Es bleibt, solange die Datei geöffnet ist.</translation>
    </message>
    <message>
        <source>Choose a Picture</source>
        <translation>Bild wählen</translation>
    </message>
</context>
<context>
    <name>view::TargetPreview</name>
    <message>
        <source>Preview of the target</source>
        <translation>Vorschau des Ziels</translation>
    </message>
    <message>
        <source>Drag a rectangle to crop the picture; double-click to use all of it</source>
        <translation>Ziehen Sie ein Rechteck, um das Bild zuzuschneiden; ein Doppelklick nimmt wieder das ganze</translation>
    </message>
</context>
<context>
    <name>view::TheftExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>„%1“ exportieren</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the picture. You can keep working in the meantime.</source>
        <translation>Fragt nach einem Dateinamen und schreibt das Bild. Sie können währenddessen weiterarbeiten.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Die Ansicht auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>Der ganze Attraktor</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Ausschnitt</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin.</source>
        <translation>Was das Bild zeigt: was die Zeichenfläche zeigt, oder den Attraktor mit schmalem Rand, wohin die Zeichenfläche auch blickt.</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Au&amp;sschnitt:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Größe:</translation>
    </message>
    <message>
        <source>Export Stolen Picture</source>
        <translation>Gestohlenes Bild exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The name “%1” does not end with .png. Choose another name.</source>
        <translation>Der Name „%1“ endet nicht auf .png. Wählen Sie einen anderen Namen.</translation>
    </message>
</context>
<context>
    <name>view::Timeline</name>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Atmen</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Farbwechsel</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Käfig</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Motions need no keys. Select a track first.</source>
        <translation>Bewegungen brauchen keine Schlüssel. Wählen Sie zuerst eine Spur.</translation>
    </message>
    <message>
        <source>Key of %1 (frame %2)</source>
        <translation>Schlüssel: %1 (Bild %2)</translation>
    </message>
    <message>
        <source>Keys of all tracks (frame %1)</source>
        <translation>Schlüssel aller Spuren (Bild %1)</translation>
    </message>
    <message>
        <source>Delete keys</source>
        <translation>Schlüssel löschen</translation>
    </message>
    <message>
        <source>Delete the motion “%1”</source>
        <translation>Die Bewegung „%1“ löschen</translation>
    </message>
    <message>
        <source>Copy keys</source>
        <translation>Schlüssel kopieren</translation>
    </message>
    <message>
        <source>Move keys and all later ones</source>
        <translation>Schlüssel und alle späteren verschieben</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Schlüssel verschieben</translation>
    </message>
    <message>
        <source>None of these keys fits this fractal.</source>
        <translation>Keiner dieser Schlüssel passt zu diesem Fraktal.</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Schlüssel einfügen</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Slow Start and End</source>
        <translation>Langsam an Anfang und Ende</translation>
    </message>
    <message>
        <source>Slow Start</source>
        <translation>Langsam am Anfang</translation>
    </message>
    <message>
        <source>Slow End</source>
        <translation>Langsam am Ende</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Ease to the Next Key</source>
        <translation>Übergang zum nächsten Schlüssel</translation>
    </message>
    <message>
        <source>Copy Keys</source>
        <translation>Schlüssel kopieren</translation>
    </message>
    <message>
        <source>Paste Keys at the Playhead</source>
        <translation>Schlüssel am Abspielkopf einfügen</translation>
    </message>
    <message>
        <source>Delete Keys</source>
        <translation>Schlüssel löschen</translation>
    </message>
    <message>
        <source>Key at the Playhead</source>
        <translation>Schlüssel am Abspielkopf</translation>
    </message>
    <message>
        <source>Delete the Motion</source>
        <translation>Die Bewegung löschen</translation>
    </message>
    <message>
        <source>Custom…</source>
        <translation>Eigener …</translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) beyond the new end deleted. Undo brings them back.</source>
        <translation>
            <numerusform>%n Schlüssel hinter dem neuen Ende gelöscht. Rückgängig bringt ihn zurück.</numerusform>
            <numerusform>%n Schlüssel hinter dem neuen Ende gelöscht. Rückgängig bringt sie zurück.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) not pasted: beyond the end of the animation, or of a part that this fractal does not have.</source>
        <translation>
            <numerusform>%n Schlüssel nicht eingefügt: hinter dem Ende der Animation, oder von einem Teil, den dieses Fraktal nicht hat.</numerusform>
            <numerusform>%n Schlüssel nicht eingefügt: hinter dem Ende der Animation, oder von einem Teil, den dieses Fraktal nicht hat.</numerusform>
        </translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Fließend</translation>
    </message>
    <message>
        <source>Ease of keys (frame %1)</source>
        <translation>Übergang von Schlüsseln (Bild %1)</translation>
    </message>
    <message>
        <source>Ease of keys (frames %1–%2)</source>
        <translation>Übergang von Schlüsseln (Bilder %1–%2)</translation>
    </message>
    <message>
        <source>Edit the Motion…</source>
        <translation>Die Bewegung bearbeiten …</translation>
    </message>
    <message>
        <source>Branch %1, inside itself</source>
        <translation>Ast %1, in sich selbst</translation>
    </message>
    <message>
        <source>Stretch Keys…</source>
        <translation>Schlüssel dehnen…</translation>
    </message>
</context>
<context>
    <name>view::TimelinePanel</name>
    <message>
        <source>Breeze</source>
        <translation>Brise</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Böen</translation>
    </message>
    <message>
        <source>Storm</source>
        <translation>Sturm</translation>
    </message>
    <message>
        <source>Under Water</source>
        <translation>Unter Wasser</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Ruhig</translation>
    </message>
    <message>
        <source>Add Motion</source>
        <translation>Bewegung hinzufügen</translation>
    </message>
    <message>
        <source>Add a motion that needs no keys, or a morph to another entry</source>
        <translation>Eine Bewegung hinzufügen, die keine Schlüssel braucht, oder eine Verwandlung in einen anderen Eintrag</translation>
    </message>
    <message>
        <source>Add &amp;Motion</source>
        <translation>Be&amp;wegung hinzufügen</translation>
    </message>
    <message>
        <source>It is one step of the history.</source>
        <translation>Das ist ein Schritt im Verlauf.</translation>
    </message>
    <message>
        <source>There are no maps to move.</source>
        <translation>Es gibt keine Abbildungen, die sich bewegen könnten.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>All branches sway about their roots.</source>
        <translation>Alle Äste schwingen um die Stelle, an der sie beginnen.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Each map turns once in its place.</source>
        <translation>Die Abbildungen drehen sich einmal an ihrem Ort.</translation>
    </message>
    <message>
        <source>Turn the maps</source>
        <translation>Die Abbildungen drehen</translation>
    </message>
    <message>
        <source>No map can turn without losing the attractor.</source>
        <translation>Keine Abbildung kann sich drehen, ohne dass der Attraktor verloren geht.</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>The whole picture turns once.</source>
        <translation>Das ganze Bild läuft einmal herum.</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Atmen</translation>
    </message>
    <message>
        <source>The maps swell and shrink.</source>
        <translation>Die Abbildungen schwellen an und wieder ab.</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Farbwechsel</translation>
    </message>
    <message>
        <source>The colours run through the palette and back.</source>
        <translation>Die Farben laufen durch die Palette und zurück.</translation>
    </message>
    <message>
        <source>Cycle the palette</source>
        <translation>Die Farben wechseln</translation>
    </message>
    <message>
        <source>Zoom In Endlessly</source>
        <translation>Endlos hineinzoomen</translation>
    </message>
    <message>
        <source>The view moves into a small copy of the whole; the last frame matches the first.</source>
        <translation>Die Ansicht taucht in eine kleine Kopie des Ganzen ein; dort ist das letzte Bild das erste.</translation>
    </message>
    <message>
        <source>Zoom in endlessly</source>
        <translation>Endlos hineinzoomen</translation>
    </message>
    <message>
        <source>No map makes a scaled copy of the fractal that is clear of the others.</source>
        <translation>Keine Abbildung verkleinert das Fraktal nur zu einer Kopie, die frei von den anderen steht.</translation>
    </message>
    <message>
        <source>Morph To</source>
        <translation>Verwandeln in</translation>
    </message>
    <message>
        <source>The fractal becomes another entry of this file, and returns.</source>
        <translation>Das Fraktal wird zu einem anderen Eintrag dieser Datei und wieder zurück.</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Wind: %1</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension</source>
        <translation>Diese Datei hat kein anderes Fraktal dieser Dimension</translation>
    </message>
    <message>
        <source>Morph to %1</source>
        <translation>Verwandeln in %1</translation>
    </message>
    <message>
        <source>Trying the motion…</source>
        <translation>Die Bewegung wird erprobt…</translation>
    </message>
    <message>
        <source>Choose &amp;Pairs…</source>
        <translation>&amp;Paare wählen…</translation>
    </message>
    <message>
        <source>Shows which map becomes which, and lets you pin pairs.</source>
        <translation>Zeigt, welche Abbildung zu welcher wird, und lässt Sie Paare festhalten.</translation>
    </message>
    <message>
        <source>Pairing the maps…</source>
        <translation>Die Abbildungen werden gepaart…</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Bild ohne Attraktor</translation>
    </message>
    <message>
        <source>Steady Sway</source>
        <translation>Gleichmäßiges Wiegen</translation>
    </message>
</context>
<context>
    <name>view::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation>Werkzeugoptionen</translation>
    </message>
    <message>
        <source>Drag a corner, an edge or the inside of the cage.  Ctrl rotates  ·  Alt scales  ·  Shift keeps directions  ·  double-click an edge for a new corner</source>
        <translation>Ecke, Kante oder Inneres des Käfigs ziehen.  Strg dreht  ·  Alt skaliert  ·  Umschalt behält Richtungen bei  ·  Doppelklick auf eine Kante: neue Ecke</translation>
    </message>
    <message>
        <source>Click the three corners of the new triangle.  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Die drei Ecken des neuen Dreiecks anklicken.  Rücktaste entfernt den letzten Punkt  ·  Esc bricht ab</translation>
    </message>
    <message>
        <source>Click the four corners of the new tetrahedron, the fourth in front of the others.  The wheel pushes it away  ·  right-drag turns the view  ·  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Klicken Sie die vier Ecken des neuen Tetraeders, die vierte vor den anderen.  Das Rad schiebt sie weg  ·  Ziehen mit rechts dreht die Ansicht  ·  Rücktaste entfernt den letzten Punkt  ·  Esc bricht ab</translation>
    </message>
    <message>
        <source>Drag a corner or a face of the cage.  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Eine Ecke oder eine Fläche des Käfigs ziehen.  X, Y, Z halten eine Achse  ·  Strg dreht  ·  Alt skaliert  ·  anderswo ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>Click a corner of a map to select it, Shift+click for more.  Drag its corners or its middle  ·  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Auf eine Ecke einer Abbildung klicken wählt sie aus, Umschalt+Klick weitere.  Ihre Ecken oder ihre Mitte ziehen  ·  X, Y, Z halten eine Achse  ·  Strg dreht  ·  Alt skaliert  ·  anderswo ziehen dreht die Ansicht</translation>
    </message>
    <message>
        <source>Side by side, the fractal can be turned and zoomed.  To change it, switch stereo off.</source>
        <translation>Nebeneinander kann das Fraktal gedreht und gezoomt werden.  Um es zu ändern, Stereo ausschalten.</translation>
    </message>
</context>
<context>
    <name>view::ToolbarPage</name>
    <message>
        <source>Move &amp;Up</source>
        <translation>Nach &amp;oben</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Nach &amp;unten</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Commands in the toolbar</source>
        <translation>Befehle in der Werkzeugleiste</translation>
    </message>
    <message>
        <source>The toolbar from left to right. Drag a command to move it.</source>
        <translation>Die Werkzeugleiste von links nach rechts. Ziehen Sie einen Befehl, um ihn zu verschieben.</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Befehl wählen</translation>
    </message>
    <message>
        <source>Command to add</source>
        <translation>Befehl zum Hinzufügen</translation>
    </message>
    <message>
        <source>Adds a command of the menus, or a separator, after the selected one.</source>
        <translation>Fügt nach dem ausgewählten Befehl einen Befehl der Menüs oder eine Trennlinie ein.</translation>
    </message>
    <message>
        <source>&amp;Add:</source>
        <translation>&amp;Hinzufügen:</translation>
    </message>
    <message>
        <source>Moves the selected command towards the left end of the toolbar.</source>
        <translation>Verschiebt den ausgewählten Befehl zum linken Ende der Werkzeugleiste hin.</translation>
    </message>
    <message>
        <source>Moves the selected command towards the right end of the toolbar.</source>
        <translation>Verschiebt den ausgewählten Befehl zum rechten Ende der Werkzeugleiste hin.</translation>
    </message>
    <message>
        <source>Takes the selected command out of the toolbar. It stays in its menu.</source>
        <translation>Nimmt den ausgewählten Befehl aus der Werkzeugleiste. In seinem Menü bleibt er.</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Trennlinie</translation>
    </message>
</context>
<context>
    <name>view::TrackView</name>
    <message>
        <source>Tracks and keys</source>
        <translation>Spuren und Schlüssel</translation>
    </message>
    <message>
        <source>Unit of the ruler</source>
        <translation>Einheit des Lineals</translation>
    </message>
    <message>
        <source>Switch the ruler between frames and seconds</source>
        <translation>Das Lineal zwischen Bildern und Sekunden umschalten</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, Bild %2</translation>
    </message>
    <message>
        <source>, key</source>
        <translation>, Schlüssel</translation>
    </message>
    <message>
        <source>, keys in this row: %1</source>
        <translation>, Schlüssel in dieser Zeile: %1</translation>
    </message>
    <message>
        <source>One row for each part that can move. The diamond on the left sets a key at the playhead, or deletes it. Drag keys to move them: Alt moves all later ones too, Ctrl copies. Drag in the ruler to move the playhead, or from an empty area to select keys. Ctrl + wheel zooms. Right-click a key for its ease. Round keys are smooth: the motion runs through them without a corner. Double-click a motion to change its strength or number of turns.</source>
        <translation>Eine Zeile für jeden Teil, der sich bewegen kann. Die Raute davor setzt einen Schlüssel am Abspielkopf oder löscht ihn. Ziehen Sie Schlüssel, um sie zu verschieben: Alt nimmt alle späteren mit, Strg kopiert. Ziehen im Lineal bewegt den Abspielkopf, Ziehen von einer leeren Stelle aus wählt Schlüssel. Strg + Mausrad vergrößert. Ein Rechtsklick auf einen Schlüssel wählt seinen Übergang. Runde Schlüssel sind fließend: Die Bewegung läuft ohne Knick durch sie hindurch. Ein Doppelklick auf eine Bewegung ändert ihre Stärke oder die Zahl ihrer Umdrehungen.</translation>
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
        <source>Transform</source>
        <translation>Transformieren</translation>
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
        <source>Applied in this order, from top to bottom.</source>
        <translation>In dieser Reihenfolge, von oben nach unten.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problem</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Reset all values to what they were when the dialog opened</source>
        <translation>Alle Werte wie beim Öffnen des Dialogs</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Das Bild platzieren</translation>
    </message>
    <message>
        <source>The cage moves; the code does not change</source>
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
        <source>Fixed point</source>
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
        <source>a point of your choice</source>
        <translation>einen eingetippten Punkt</translation>
    </message>
    <message>
        <source>in the line at the angle (°)</source>
        <translation>an der Geraden im Winkel °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Winkel der Spiegelgeraden in Grad: 0 ist waagrecht, 90 senkrecht</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Dieser Eintrag hat keine Abbildungen der Ebene.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be inverted, so it cannot be written into the code. Choose other scales, or place the picture.</source>
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
        <source>The point about which the fractal is rotated, scaled and reflected; it stays where it is.</source>
        <translation>Um welchen Punkt das Fraktal gedreht, skaliert und gespiegelt wird: Er bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Reflects in a line through the fixed point; the angle is measured from the x axis.</source>
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
        <source>the centre of the picture’s box</source>
        <translation>die Mitte des Rechtecks um das Bild</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Reflects, shears, scales, rotates and translates the whole fractal by numbers.</source>
        <translation>Spiegelt, schert, skaliert, dreht und verschiebt das ganze Fraktal nach Zahlen.</translation>
    </message>
    <message>
        <source>z of the fixed point</source>
        <translation>z des Fixpunkts</translation>
    </message>
    <message>
        <source>Scale in z</source>
        <translation>Skalierung in z</translation>
    </message>
    <message>
        <source>Axis:</source>
        <translation>Achse:</translation>
    </message>
    <message>
        <source>x of the direction of the axis</source>
        <translation>x der Richtung der Achse</translation>
    </message>
    <message>
        <source>y of the direction of the axis</source>
        <translation>y der Richtung der Achse</translation>
    </message>
    <message>
        <source>z of the direction of the axis</source>
        <translation>z der Richtung der Achse</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise as seen from the tip of the axis</source>
        <translation>Drehung in Grad, gegen den Uhrzeigersinn, von der Spitze der Achse aus gesehen</translation>
    </message>
    <message>
        <source>Translation in z</source>
        <translation>Verschiebung in z</translation>
    </message>
    <message>
        <source>Same in x, y and z</source>
        <translation>Gleich in x, y und z</translation>
    </message>
    <message>
        <source>Keeps the factors in x, y and z equal.</source>
        <translation>Hält die Faktoren in x, y und z gleich.</translation>
    </message>
    <message>
        <source>Axis of the rotation</source>
        <translation>Drehachse</translation>
    </message>
    <message>
        <source>The axis of the rotation; it passes through the fixed point.</source>
        <translation>Die Drehachse; sie geht durch den Fixpunkt.</translation>
    </message>
    <message>
        <source>the x axis</source>
        <translation>die x-Achse</translation>
    </message>
    <message>
        <source>the y axis</source>
        <translation>die y-Achse</translation>
    </message>
    <message>
        <source>the z axis</source>
        <translation>die z-Achse</translation>
    </message>
    <message>
        <source>a direction of your choice</source>
        <translation>eine eingetippte Richtung</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Dieser Eintrag ist kein System im Raum.</translation>
    </message>
    <message>
        <source>The axis has no direction.</source>
        <translation>Die Achse hat keine Richtung.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so only a transformation that scales alike in all directions can be written into the code. Choose equal scales, or place the picture.</source>
        <translation>Der Käfig verbiegt das Bild; deshalb kann nur eine Transformation, die in allen Richtungen gleich skaliert, in den Code geschrieben werden. Wählen Sie gleiche Skalierungen, oder platzieren Sie das Bild.</translation>
    </message>
</context>
<context>
    <name>view::TransformationBar</name>
    <message>
        <source>Partner</source>
        <translation>Partner</translation>
    </message>
    <message>
        <source>The entry on which the picture is placed</source>
        <translation>Der Eintrag, auf dem das Bild liegt</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>What the fractal transformation does with the picture</source>
        <translation>Was die fraktale Transformation mit dem Bild macht</translation>
    </message>
    <message>
        <source>Fractal transformation</source>
        <translation>Fraktale Transformation</translation>
    </message>
    <message>
        <source>Steal Colours</source>
        <translation>Farben stehlen</translation>
    </message>
    <message>
        <source>Transform a Picture</source>
        <translation>Bild transformieren</translation>
    </message>
    <message>
        <source>Deformation Grid</source>
        <translation>Verformungsgitter</translation>
    </message>
    <message>
        <source>Filter: Reduce</source>
        <translation>Filter: Verkleinern</translation>
    </message>
    <message>
        <source>Filter: Posterise</source>
        <translation>Filter: Posterisieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Save the stolen picture as PNG</source>
        <translation>Das gestohlene Bild als PNG speichern</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The picture on the partner; you can also drop one there</source>
        <translation>Das Bild auf dem Partner; Sie können auch eines dort ablegen</translation>
    </message>
    <message>
        <source>Choose Picture…</source>
        <translation>Bild wählen …</translation>
    </message>
    <message>
        <source>Colour Wheel</source>
        <translation>Farbkreis</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Sonnenuntergang</translation>
    </message>
    <message>
        <source>Starters</source>
        <translation>Anfänge</translation>
    </message>
    <message>
        <source>Add two entries with the same addresses, whose parameters you can slide</source>
        <translation>Zwei Einträge mit denselben Adressen hinzufügen, deren Parameter sich schieben lassen</translation>
    </message>
    <message>
        <source>Triangle Family</source>
        <translation>Dreiecksfamilie</translation>
    </message>
    <message>
        <source>Square Family</source>
        <translation>Quadratfamilie</translation>
    </message>
    <message>
        <source>%1 →</source>
        <translation>%1 →</translation>
    </message>
    <message>
        <source>The picture on the partner: %1</source>
        <translation>Das Bild auf dem Partner: %1</translation>
    </message>
    <message>
        <source>Find Picture…</source>
        <translation>Bild suchen …</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Wörter teilen</translation>
    </message>
    <message>
        <source>Choose the current location of the picture</source>
        <translation>Das Bild dort wählen, wo es jetzt ist</translation>
    </message>
    <message>
        <source>Divide maps of both entries into words until both have the same number</source>
        <translation>Abbildungen beider Einträge in Wörter teilen, bis es gleich viele sind</translation>
    </message>
    <message>
        <source>Stained Glass</source>
        <translation>Buntglas</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Marmor</translation>
    </message>
    <message>
        <source>Tartan</source>
        <translation>Schottenkaro</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>State of the fractal transformation</source>
        <translation>Zustand der fraktalen Transformation</translation>
    </message>
    <message>
        <source>There is no stolen picture yet</source>
        <translation>Es gibt noch kein gestohlenes Bild</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Übereinander</translation>
    </message>
    <message>
        <source>Show the two fractals one above the other instead of side by side</source>
        <translation>Die beiden Fraktale übereinander statt nebeneinander zeigen</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Überlagern</translation>
    </message>
    <message>
        <source>Show the partner half transparent over the fractal, in the same coordinates</source>
        <translation>Den Partner halb durchsichtig über dem Fraktal zeigen, in denselben Koordinaten</translation>
    </message>
    <message>
        <source>Embed in the File</source>
        <translation>In die Datei einbetten</translation>
    </message>
    <message>
        <source>Store the picture itself with the entry, not only its path</source>
        <translation>Das Bild selbst mit dem Eintrag speichern, nicht nur seinen Pfad</translation>
    </message>
    <message>
        <source>Stores the picture itself with the entry, so that the file shows it wherever it goes. A picture of more than 128 KB is stored smaller. Otherwise only its path is stored.</source>
        <translation>Speichert das Bild selbst mit dem Eintrag, sodass die Datei es überall zeigt. Ein Bild von mehr als 128 KB wird verkleinert gespeichert. Sonst wird nur sein Pfad gespeichert.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Reihenfolge zurücksetzen</translation>
    </message>
    <message>
        <source>Put the maps back in the order of their numbers</source>
        <translation>Die Abbildungen wieder nach ihren Nummern ordnen</translation>
    </message>
    <message>
        <source>Open It</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open this picture, which is outside the folder of the file</source>
        <translation>Dieses Bild öffnen, das außerhalb des Ordners der Datei liegt</translation>
    </message>
</context>
<context>
    <name>view::TransformationView</name>
    <message>
        <source>Canvas of the partner</source>
        <translation>Zeichenfläche des Partners</translation>
    </message>
    <message>
        <source>Choose Partner</source>
        <translation>Partner wählen</translation>
    </message>
    <message>
        <source>Choose Mode</source>
        <translation>Modus wählen</translation>
    </message>
    <message>
        <source>Choose Picture</source>
        <translation>Bild wählen</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Wörter teilen</translation>
    </message>
    <message>
        <source>There is no other entry of the plane in this file. Add one, or choose a starter.</source>
        <translation>In dieser Datei gibt es keinen anderen Eintrag der Ebene. Fügen Sie einen hinzu, oder wählen Sie einen Anfang.</translation>
    </message>
    <message>
        <source>The partner “%1” is not in this file. Choose another one.</source>
        <translation>Der Partner „%1“ ist nicht in dieser Datei. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Add Family</source>
        <translation>Familie hinzufügen</translation>
    </message>
    <message>
        <source>Points of two fractals that have the same address correspond to each other. A picture on the partner is carried over to this fractal in that way.</source>
        <translation>Punkte zweier Fraktale mit derselben Adresse entsprechen einander. So wird ein Bild auf dem Partner auf dieses Fraktal übertragen.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Reihenfolge zurücksetzen</translation>
    </message>
    <message>
        <source>Reorder Overlapping Maps</source>
        <translation>Reihenfolge ändern</translation>
    </message>
    <message>
        <source>Do Not Embed Picture</source>
        <translation>Bild nicht einbetten</translation>
    </message>
    <message>
        <source>Embed Picture</source>
        <translation>Bild einbetten</translation>
    </message>
    <message>
        <source>The file names a picture outside its folder: %1. Open it only if you trust the file.</source>
        <translation>Die Datei nennt ein Bild außerhalb ihres Ordners: %1. Es nur öffnen, wenn Sie der Datei vertrauen.</translation>
    </message>
</context>
<context>
    <name>view::TransportBar</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>Die Animation abspielen</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The frame that is shown and edited</source>
        <translation>Das Bild, das gezeigt und bearbeitet wird</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>The length of the animation in frames</source>
        <translation>Wie viele Bilder die Animation lang ist</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>The number of frames played per second</source>
        <translation>Wie viele Bilder in einer Sekunde abgespielt werden</translation>
    </message>
    <message>
        <source>Previous Key</source>
        <translation>Voriger Schlüssel</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Den Abspielkopf zum Schlüssel davor bewegen</translation>
    </message>
    <message>
        <source>Next Key</source>
        <translation>Nächster Schlüssel</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Den Abspielkopf zum nächsten Schlüssel bewegen</translation>
    </message>
    <message>
        <source>Frame:</source>
        <translation>Bild:</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>Länge:</translation>
    </message>
    <message>
        <source>fps:</source>
        <translation>Bilder/s:</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Schleife:</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>What happens after the last frame</source>
        <translation>Was nach dem letzten Bild kommt</translation>
    </message>
    <message>
        <source>Off: the animation stops at its last frame. Cycle: it starts again from frame 0. There and Back: it runs backwards to the start.</source>
        <translation>Aus: Die Animation hält beim letzten Bild an. Kreis: Sie beginnt von vorn, und das Bild an ihrem Ende ist Bild 0. Hin und zurück: Sie läuft rückwärts zum Anfang.</translation>
    </message>
    <message>
        <source>Off</source>
        <comment>loop</comment>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>There and Back</source>
        <translation>Hin und zurück</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>The number of frames drawn per second during playback</source>
        <translation>Wie viele Bilder pro Sekunde beim Abspielen gezeichnet werden</translation>
    </message>
    <message>
        <source>Frames per second: %1</source>
        <translation>Bilder pro Sekunde: %1</translation>
    </message>
    <message>
        <source>Loop: %1</source>
        <translation>Schleife: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop at this frame</source>
        <translation>Bei diesem Bild anhalten</translation>
    </message>
    <message>
        <source>The number of frames played per second: a number or a fraction, such as 24, 12.5 or 30000/1001. 29.97 stands for the latter, the rate of television.</source>
        <translation>Wie viele Bilder in einer Sekunde abgespielt werden: eine Zahl oder ein Bruch wie 24, 12.5 oder 30000/1001. 29.97 steht für den letzten, die Bildrate des Fernsehens.</translation>
    </message>
    <message>
        <source>“%1” is not a frame rate. Enter frames per second, above 0 and at most %2, such as 24, 29.97 or 30000/1001.</source>
        <translation>„%1“ ist keine Bildrate. Geben Sie Bilder pro Sekunde ein, über 0 und höchstens %2, zum Beispiel 24, 29.97 oder 30000/1001.</translation>
    </message>
    <message numerus="yes">
        <source>Length of the animation: %n frame(s)</source>
        <translation>
            <numerusform>Länge der Animation: %n Bild</numerusform>
            <numerusform>Länge der Animation: %n Bilder</numerusform>
        </translation>
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
        <source>Problem with the numbers</source>
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
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Ecke %1 nach (%2, %3) verschieben</translation>
    </message>
</context>
<context>
    <name>view::ZoomBox</name>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Zoom in percent: 100 % shows a unit of the plane as 100 pixels; type another value, or choose one</source>
        <translation>Zoom in Prozent: Bei 100 % ist eine Einheit der Ebene 100 Pixel lang; geben Sie einen anderen Wert ein oder wählen Sie einen aus</translation>
    </message>
    <message>
        <source>Zoom in percent: at 100 %, one unit of the plane is 100 pixels long. Type a number, or choose a value, a saved view, or Fit, which shows the whole attractor.</source>
        <translation>Zoom in Prozent: Bei 100 % ist eine Einheit der Ebene 100 Pixel lang. Geben Sie eine Zahl ein oder wählen Sie einen Wert, eine gespeicherte Ansicht oder „Einpassen“, das den ganzen Attraktor zeigt.</translation>
    </message>
</context>
</TS>
