<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AccessibleHandle</name>
    <message>
        <source>Move left</source>
        <translation>Déplacer à gauche</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>Déplacer à droite</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Déplacer vers le haut</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Déplacer vers le bas</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Attracteur</translation>
    </message>
    <message>
        <source>A system has one attractor if some power of it contracts: then every start leads to the same set.</source>
        <translation>Un système a un unique attracteur dès que l’une de ses puissances est contractante&#x202f;: tout ensemble de départ mène alors au même ensemble.</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Contraction</translation>
    </message>
    <message>
        <source>‖A‖ of each map that takes part: the most by which it stretches distances.</source>
        <translation>‖A‖ pour chaque application active&#x202f;: le plus grand facteur dont elle étire les distances.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte englobante</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that holds the attractor; certified.</source>
        <translation>Le plus petit rectangle aux côtés parallèles aux axes qui contient l’attracteur&#x202f;; résultat certifié.</translation>
    </message>
    <message>
        <source>Canonical simplex</source>
        <translation>Simplexe canonique</translation>
    </message>
    <message>
        <source>%1, leg %2, corner %3</source>
        <translation>%1, cathète %2, angle droit en %3</translation>
    </message>
    <message>
        <source>Similarity dimension</source>
        <translation>Dimension de similitude</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved exactly: the centre of mass of the picture.</source>
        <translation>Moyenne de la mesure invariante, calculée exactement&#x202f;: le centre de masse de l’image.</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Covariance</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Points fixes</translation>
    </message>
    <message>
        <source>The point that each map leaves where it is; it lies on the attractor.</source>
        <translation>Le point que chaque application laisse à sa place ; il est sur l’attracteur.</translation>
    </message>
    <message>
        <source>The D with Σ sᵢᴰ = 1 over the ratios sᵢ, when all maps are similarities in some coordinates. It is the dimension of the attractor when the pieces do not overlap.</source>
        <translation>Le D tel que Σ sᵢᴰ = 1 sur les rapports sᵢ, quand toutes les applications sont des similitudes dans certaines coordonnées. C’est la dimension de l’attracteur quand les morceaux ne se recouvrent pas.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Dimension d’affinité</translation>
    </message>
    <message>
        <source>Falconer’s dimension: where the sum of the singular value functions of all words of one length neither grows nor falls, at most 2. An upper bound of the box-counting dimension, and equal to it for almost all translations when the maps contract enough.</source>
        <translation>La dimension de Falconer : là où la somme des fonctions de valeurs singulières de tous les mots d’une même longueur ni ne croît ni ne décroît, au plus 2. Une borne supérieure de la dimension par comptage de boîtes, égale à elle pour presque toutes les translations quand les applications contractent assez.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Dimension par comptage de boîtes</translation>
    </message>
    <message>
        <source>Slope of the least-squares line through ln N against ln 1/ε, where N boxes of side ε meet the attractor. An estimate: it depends on the sizes counted.</source>
        <translation>Pente de la droite des moindres carrés de ln N en fonction de ln 1/ε, où N boîtes de côté ε rencontrent l’attracteur. Une estimation : elle dépend des tailles comptées.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture spreads. The ellipse is the one on which an even mass has the same mean and covariance.</source>
        <translation>Covariance xx, xy, yy de la mesure invariante, résolue exactement : l’étendue de l’image. L’ellipse est celle sur laquelle une masse uniforme a la même moyenne et la même covariance.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that holds the attractor; certified. The signs are the directions of its legs.</source>
        <translation>Le plus petit triangle rectangle isocèle à côtés parallèles aux axes qui contient l’attracteur ; certifié. Les signes sont les directions de ses côtés.</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Aire de l’enveloppe</translation>
    </message>
    <message>
        <source>Area of the convex hull: of the polygon whose vertices were found on the attractor. The hull itself is larger by at most its border times the error bound.</source>
        <translation>Aire de l’enveloppe convexe : du polygone dont les sommets ont été trouvés sur l’attracteur. L’enveloppe elle-même est plus grande d’au plus son bord fois la borne d’erreur.</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Sommets de l’enveloppe</translation>
    </message>
    <message>
        <source>Corners of the convex hull as found, each a point of the attractor. A hull with infinitely many has as many as its tolerance asks for.</source>
        <translation>Sommets de l’enveloppe convexe tels que trouvés, chacun un point de l’attracteur. Une enveloppe qui en a une infinité en a autant que sa tolérance l’exige.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Borne d’erreur de l’enveloppe</translation>
    </message>
    <message>
        <source>The attractor reaches at most this far beyond the polygon; certified.</source>
        <translation>L’attracteur dépasse le polygone d’au plus cette distance ; certifié.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… et %n autre</numerusform>
            <numerusform>… et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes: hyperbolic, every map contracts by %1 or less.</source>
        <translation>Oui : hyperbolique, chaque application contracte d’un facteur %1 ou moins.</translation>
    </message>
    <message>
        <source>Yes: eventually contractive, every word of %1 maps contracts (%2 a map).</source>
        <translation>Oui : finalement contractant, chaque mot de %1 applications contracte (%2 par application).</translation>
    </message>
    <message>
        <source>None: the word %1 does not contract (%2 a map).</source>
        <translation>Aucun : le mot %1 ne contracte pas (%2 par application).</translation>
    </message>
    <message>
        <source>Undecided: no proof either way was found.</source>
        <translation>Indécis : aucune preuve n’a été trouvée, ni dans un sens ni dans l’autre.</translation>
    </message>
    <message>
        <source>None: no map takes part.</source>
        <translation>Aucun : aucune application ne participe.</translation>
    </message>
    <message>
        <source>None: map %1 does not contract (%2 a map).</source>
        <translation>Aucun : l’application %1 ne contracte pas (%2 par application).</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Take a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Prenez une fractale par les coins&#x202f;: un éditeur de systèmes de fonctions itérées.</translation>
    </message>
    <message>
        <source>.ifs files to open, a window each</source>
        <translation>Fichiers .ifs à ouvrir, chacun dans sa fenêtre</translation>
    </message>
    <message>
        <source>a window with the maple, whatever was open before</source>
        <translation>une fenêtre avec l’érable, quoi qui ait été ouvert auparavant</translation>
    </message>
    <message>
        <source>a window that shows the collection</source>
        <translation>une fenêtre qui montre la collection</translation>
    </message>
    <message>
        <source>a window with fractals made by chance to pick from</source>
        <translation>une fenêtre avec des fractales au hasard à choisir</translation>
    </message>
</context>
<context>
    <name>CageEdits</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Cette entrée n’a pas d’applications du plan.</translation>
    </message>
    <message>
        <source>The cage is at rest: the code is what is displayed.</source>
        <translation>La cage est au repos&#x202f;: l’image affichée est celle du code.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code has a bent picture. Choose “Affine fit” to bake what comes nearest to it.</source>
        <translation>La cage courbe l’image, et aucun code affine ne donne une image courbée. Choisissez «&#x202f;Ajustement affine&#x202f;» pour intégrer au code ce qui s’en approche le plus.</translation>
    </message>
    <message>
        <source>The cage is flat: no code has this picture. Open the cage first.</source>
        <translation>La cage est plate&#x202f;: aucun code ne donne cette image. Ouvrez d’abord la cage.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. The code stays as it is until you bake.</source>
        <translation>Déplacer la cage déplace l’image. Le code reste tel quel tant que vous n’y intégrez pas le placement.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can follow, and leaves it.</source>
        <translation>Déplacer la cage entière réécrit le code. Déplacer un seul sommet courbe l’image, ce qu’aucun code ne peut suivre&#x202f;; le code reste alors tel quel.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites every coefficient of the code, and the cage rests where it is.</source>
        <translation>Déplacer la cage réécrit tous les coefficients du code, et la cage est au repos là où elle se trouve.</translation>
    </message>
    <message>
        <source>The cage already places the code.</source>
        <translation>La cage place déjà le code.</translation>
    </message>
    <message>
        <source>Only a triangle can be taken out of the code.</source>
        <translation>Seul un triangle peut être extrait du code.</translation>
    </message>
    <message>
        <source>The cage has a notch: the picture may fold over itself there.</source>
        <translation>La cage a une encoche&#x202f;: l’image peut s’y replier sur elle-même.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture lie over one another. Move the vertices apart to unfold it.</source>
        <translation>La cage est repliée&#x202f;: des parties de l’image se superposent. Écartez les sommets pour la déplier.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to enclose.</source>
        <translation>Aucune application n’est active&#x202f;: il n’y a rien à entourer.</translation>
    </message>
    <message>
        <source>A bent picture cannot be held by another cage. Reset the cage, or choose “Affine fit”, first.</source>
        <translation>Une image courbée ne peut pas être confiée à une autre cage. Réinitialisez d’abord la cage, ou choisissez «&#x202f;Ajustement affine&#x202f;».</translation>
    </message>
    <message>
        <source>The cage is flat. Open the triangle, or reset it, first.</source>
        <translation>La cage est plate. Ouvrez d’abord le triangle, ou réinitialisez-le.</translation>
    </message>
    <message>
        <source>This system has no attractor that could be enclosed.</source>
        <translation>Ce système n’a pas d’attracteur à entourer.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>La cage est au repos.</translation>
    </message>
</context>
<context>
    <name>Collection</name>
    <message>
        <source>From the paper</source>
        <translation>Tirées de l’article</translation>
    </message>
    <message>
        <source>The two systems of E. Hadzieva and M. Shuminoska, with the coefficients as printed.</source>
        <translation>Les deux systèmes de E. Hadzieva et M. Shuminoska, avec les coefficients imprimés.</translation>
    </message>
    <message>
        <source>Ferns</source>
        <translation>Fougères</translation>
    </message>
    <message>
        <source>Fronds: a long slow map climbs the rachis, two short ones hang the pinnae, a flat one draws the stem.</source>
        <translation>Frondes&#x202f;: une longue application lente monte le long du rachis, deux courtes y accrochent les pennes, une plate trace la tige.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Arbres</translation>
    </message>
    <message>
        <source>Trunks that fork: the whole tree stands on its own branches.</source>
        <translation>Des troncs qui se ramifient&#x202f;: l’arbre entier se tient sur chacune de ses branches.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Dragons</translation>
    </message>
    <message>
        <source>Folded paper curves and the fractals of two or three twisted similarities.</source>
        <translation>Courbes de papier plié et fractales de deux ou trois similitudes avec rotation.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Famille de Sierpiński</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon holds shrunken copies of itself and keeps its holes.</source>
        <translation>Tamis et tapis&#x202f;: un polygone contient des copies réduites de lui-même et garde ses trous.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Famille de Koch</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment, and the islands they bound.</source>
        <translation>Des courbes construites en remplaçant un segment, et les îles qu’elles délimitent.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Spirales</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small ones that bead its path.</source>
        <translation>Une application qui tourne et réduit un peu, et de petites qui s’égrènent le long de son parcours.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Feuilles et fleurs</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are turned copies of one another.</source>
        <translation>Contours de feuilles, et fleurs dont les pétales se déduisent les uns des autres par rotation.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Pavages et reptuiles</translation>
    </message>
    <message>
        <source>Sets that tile the plane: copies of themselves, rep-tiles, and the central tiles of number systems.</source>
        <translation>Des ensembles qui pavent le plan&#x202f;: copies d’eux-mêmes, reptuiles, et tuiles centrales de systèmes de numération.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Ensembles de Cantor et poussières</translation>
    </message>
    <message>
        <source>Sets full of gaps at every scale: points everywhere near, hardly any of them joined.</source>
        <translation>Des ensembles pleins de lacunes à toutes les échelles&#x202f;: partout des points proches, presque aucun relié à un autre.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Cristaux et flocons de neige</translation>
    </message>
    <message>
        <source>Sets with the symmetry of frost: five, six and more arms.</source>
        <translation>Des ensembles qui ont la symétrie du givre&#x202f;: cinq, six branches et davantage.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Courbes et graphes</translation>
    </message>
    <message>
        <source>Graphs of strange functions, smooth curves as attractors, space-filling coordinates.</source>
        <translation>Graphes de fonctions étranges, courbes lisses en attracteurs, coordonnées de courbes remplissant le plan.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Abstraites</translation>
    </message>
    <message>
        <source>Affine patterns without a name in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Motifs affines sans nom dans la nature&#x202f;: parents du tamis, entrelacs, rosaces.</translation>
    </message>
</context>
<context>
    <name>ExportJob</name>
    <message>
        <source>There is not enough memory for this picture. Make it smaller, or supersample less.</source>
        <translation>La mémoire ne suffit pas pour cette image. Réduisez-la, ou diminuez le suréchantillonnage.</translation>
    </message>
</context>
<context>
    <name>FlameCard</name>
    <message>
        <source>Flames</source>
        <translation>Flammes</translation>
    </message>
    <message numerus="yes">
        <source>%n flames</source>
        <translation>
            <numerusform>%n flamme</numerusform>
            <numerusform>%n flammes</numerusform>
        </translation>
    </message>
    <message>
        <source>In flames y grows downwards. They were turned over, so that they look here as they do in flame programs.</source>
        <translation>Dans les flammes, y croît vers le bas. Elles ont été retournées, pour avoir ici la même allure que dans les programmes de flammes.</translation>
    </message>
    <message>
        <source>Leave &amp;y as it is written</source>
        <translation>Laisser &amp;y comme il est écrit</translation>
    </message>
    <message>
        <source>Takes the numbers of the flames as they are in the text. The picture is then upside down.</source>
        <translation>Prend les nombres des flammes tels qu’ils sont dans le texte. L’image est alors à l’envers.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Leave y as it is written</source>
        <translation>Laisser y comme il est écrit</translation>
    </message>
    <message>
        <source>Turn the flames over</source>
        <translation>Retourner les flammes</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures that carry their fractal (*.png *.svg);;All files (*)</source>
        <translation>Collections Fractint (*.ifs *.par);;Flammes (*.flame *.flam3);;Tableaux de nombres (*.csv *.tsv *.txt);;Images contenant leur fractale (*.png *.svg);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation>Afficher ou masquer le panneau «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Collection</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Applications</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Take the maple by a corner and pull. Or press D and define another triangle by three clicks.</source>
        <translation>Prenez l’érable par un coin et tirez. Ou appuyez sur D et définissez un autre triangle en trois clics.</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>Impossible d’ouvrir %1</translation>
    </message>
    <message>
        <source>Recovered %1. It is not saved yet.</source>
        <translation>%1 a été récupéré, mais n’est pas encore enregistré.</translation>
    </message>
    <message numerus="yes">
        <source>%n entries</source>
        <translation>
            <numerusform>%n entrée</numerusform>
            <numerusform>%n entrées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them could not be read and are kept as they are</source>
        <translation>
            <numerusform>, dont %n qui n’a pas pu être lue et reste telle quelle</numerusform>
            <numerusform>, dont %n qui n’ont pas pu être lues et restent telles quelles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with a remark</source>
        <translation>
            <numerusform>, %n lue avec une remarque</numerusform>
            <numerusform>, %n lues avec une remarque</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>«&#x202f;%1&#x202f;» contient des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation>Voulez-vous les enregistrer&#x202f;?</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Modifié sur le disque</translation>
    </message>
    <message>
        <source>“%1” was changed by another program since it was opened here.</source>
        <translation>«&#x202f;%1&#x202f;» a été modifié par un autre programme depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Saving replaces what the other program wrote.</source>
        <translation>L’enregistrement remplacera ce que l’autre programme a écrit.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>%1 n’a pas été enregistré</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 est enregistré.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs)</source>
        <translation>Collections Fractint (*.ifs)</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Go back to “%1” as it is on disk? The changes made since then are lost.</source>
        <translation>Revenir à «&#x202f;%1&#x202f;» tel qu’il est sur le disque&#x202f;? Les modifications faites depuis seront perdues.</translation>
    </message>
    <message>
        <source>%1 could not be read again</source>
        <translation>Impossible de relire %1</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Aucun fichier récent</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vider cette liste</translation>
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
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>Start with a Sierpiński triangle</source>
        <translation>Commencer par un triangle de Sierpiński</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Nouvelle fenê&amp;tre</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation>Ouvrir une autre fenêtre</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open a collection of fractals</source>
        <translation>Ouvrir une collection de fractales</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Ouvrir un fichier &amp;récent</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the file; entries not edited keep every byte</source>
        <translation>Enregistrer le fichier&#x202f;; les entrées non modifiées sont conservées à l’octet près</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Save the file under another name</source>
        <translation>Enregistrer le fichier sous un autre nom</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Re&amp;venir à la version enregistrée</translation>
    </message>
    <message>
        <source>Go back to the file as it is on disk</source>
        <translation>Revenir au fichier tel qu’il est sur le disque</translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation>E&amp;xporter l’image…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen</source>
        <translation>Exporter l’image en PNG, SVG ou PDF, cadrée comme à l’écran</translation>
    </message>
    <message>
        <source>Export &amp;Data…</source>
        <translation>Exporter les &amp;données…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Export the maps or points as a flame, for IFStile, as a table or a point cloud</source>
        <translation>Exporter les applications ou les points&#x202f;: flamme, IFStile, tableau ou nuage de points</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>&amp;Copier l’image</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy the picture to the clipboard</source>
        <translation>Copier l’image dans le presse-papiers</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>L’image est dans le presse-papiers.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimer…</translation>
    </message>
    <message>
        <source>Print the picture, its name and its coefficients</source>
        <translation>Imprimer l’image, son nom et ses coefficients</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>Fer&amp;mer</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Fermer cette fenêtre</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Fermer toutes les fenêtres</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Ctrl+Z</translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation>Annuler la dernière modification</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
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
        <translation>Refaire la modification annulée</translation>
    </message>
    <message>
        <source>&amp;Transform…</source>
        <translation>&amp;Transformer…</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Rotate, scale, shear, reflect or move the whole fractal by numbers</source>
        <translation>Faire tourner, redimensionner, cisailler, réfléchir ou déplacer toute la fractale en saisissant des nombres</translation>
    </message>
    <message>
        <source>&amp;Mutate…</source>
        <translation>Faire &amp;muter…</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Pick one of many variations of this fractal</source>
        <translation>Choisir parmi de nombreuses variations de cette fractale</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Pick one of many fractals made by chance, and add it to the file</source>
        <translation>Choisir parmi de nombreuses fractales nées du hasard, et l’ajouter au fichier</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Préférences…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Language, theme, quality of the picture at rest, what is opened at the start</source>
        <translation>Langue, thème, qualité de l’image au repos, fichiers ouverts au démarrage</translation>
    </message>
    <message>
        <source>&amp;Cage</source>
        <translation>&amp;Cage</translation>
    </message>
    <message>
        <source>&amp;Drag the Cage</source>
        <translation>&amp;Déplacer la cage</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Take the fractal by the vertices of its control triangle</source>
        <translation>Saisir la fractale par les sommets de son triangle de contrôle</translation>
    </message>
    <message>
        <source>De&amp;fine Triangle</source>
        <translation>Définir un &amp;triangle</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Define the control triangle by three clicks</source>
        <translation>Définir le triangle de contrôle en trois clics</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Ajuster le simplexe canonique &amp;minimal</translation>
    </message>
    <message>
        <source>Hold the attractor in the smallest isosceles right triangle around it</source>
        <translation>Tenir l’attracteur par le plus petit triangle rectangle isocèle qui le contient</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>Put the cage back to rest: the code is drawn as it is</source>
        <translation>Remettre la cage au repos&#x202f;: le code est dessiné tel quel</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Intégrer au code</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Make the placement part of the code: the picture stays, the coefficients change</source>
        <translation>Intégrer le placement au code&#x202f;: l’image reste, les coefficients changent</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Extraire du code</translation>
    </message>
    <message>
        <source>Take the placement out of the code: the picture stays, the code becomes that of the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Extraire le placement du code&#x202f;: l’image reste, le code devient celui du triangle (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Rendre ré&amp;gulière</translation>
    </message>
    <message>
        <source>Put the vertices on the regular polygon nearest to them</source>
        <translation>Mettre les sommets sur le polygone régulier le plus proche</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>Forme &amp;affinement invariante…</translation>
    </message>
    <message>
        <source>Show every map as a row-stochastic matrix over the control triangle</source>
        <translation>Montrer chaque application comme une matrice stochastique par lignes relative au triangle de contrôle</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>P&amp;lacer</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation>Déplacer la cage déplace l’image&#x202f;; le code reste</translation>
    </message>
    <message>
        <source>Re&amp;write</source>
        <translation>Réé&amp;crire</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Déplacer la cage réécrit le code</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;juster à la vue</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Show the whole fractal</source>
        <translation>Montrer la fractale entière</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Zoom a&amp;vant</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>&amp;100&#x202f;%</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Show one unit as one hundred pixels</source>
        <translation>Afficher une unité sur cent pixels</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Afficher la grille</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Axes</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Show the axes</source>
        <translation>Afficher les axes</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>Axe des &amp;y vers le bas</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Let y grow downwards, as in window coordinates</source>
        <translation>Faire croître y vers le bas, comme dans les coordonnées d’une fenêtre</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas but the picture</source>
        <translation>Masquer tout ce qui n’est pas l’image</translation>
    </message>
    <message>
        <source>&amp;Snap To</source>
        <translation>A&amp;ccrochage</translation>
    </message>
    <message>
        <source>&amp;Vertices</source>
        <translation>&amp;Sommets</translation>
    </message>
    <message>
        <source>Let dragged vertices snap to this</source>
        <translation>Accrocher à ceci les sommets que l’on déplace</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Pa&amp;nneaux</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Utiliser tout l’écran</translation>
    </message>
    <message>
        <source>How It Arises</source>
        <translation>Genèse de l’attracteur</translation>
    </message>
    <message>
        <source>&amp;How It Arises</source>
        <translation>Genèse de l’attrac&amp;teur</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor arise: by steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Regarder naître l’attracteur&#x202f;: par les étapes de l’algorithme déterministe, ou par le jeu du chaos</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>&amp;Rechercher une commande…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Find any command by typing what it does</source>
        <translation>Trouver n’importe quelle commande en tapant ce qu’elle fait</translation>
    </message>
    <message>
        <source>&amp;Keyboard and Mouse…</source>
        <translation>&amp;Clavier et souris…</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Every shortcut and gesture</source>
        <translation>Tous les raccourcis et tous les gestes</translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation>&amp;Guide d’utilisation</translation>
    </message>
    <message>
        <source>Read the user guide</source>
        <translation>Lire le guide d’utilisation</translation>
    </message>
    <message>
        <source>&amp;About Barycage</source>
        <translation>À &amp;propos de Barycage</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version et licence</translation>
    </message>
    <message>
        <source>About Barycage</source>
        <translation>À propos de Barycage</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Take a fractal by its corners: an editor for iterated function systems whose attractors are held in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Prenez une fractale par les coins&#x202f;: un éditeur de systèmes de fonctions itérées dont les attracteurs sont tenus par les coordonnées barycentriques d’un triangle de contrôle.&lt;/p&gt;&lt;p&gt;D’après E. Hadzieva et M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Licence MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>À propos de &amp;Qt</translation>
    </message>
    <message>
        <source>The toolkit this program is built with</source>
        <translation>La bibliothèque avec laquelle ce programme est construit</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>The fractals of the open file. The one chosen here is in the picture.</source>
        <translation>Les fractales du fichier ouvert. Celle que l’on choisit ici est à l’image.</translation>
    </message>
    <message>
        <source>Fractals to begin with, by theme, and your own folders of them.</source>
        <translation>Des fractales pour commencer, classées par thème, et vos propres dossiers de fractales.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map in a row.</source>
        <translation>Les applications de la fractale&#x202f;: son code, une application par ligne.</translation>
    </message>
    <message>
        <source>The control cage by numbers: where its vertices are, where they are at rest, what moving them does, and other cages to choose from.</source>
        <translation>La cage de contrôle en nombres&#x202f;: où sont ses sommets, où ils sont au repos, ce que produit leur déplacement, et d’autres cages à choisir.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Couleurs, luminosité et fond de l’image. Ils sont enregistrés avec la fractale.</translation>
    </message>
    <message>
        <source>What mathematics knows of this fractal. Point at a name to read what it means.</source>
        <translation>Ce que les mathématiques savent de cette fractale. Pointez un nom pour lire ce qu’il signifie.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Choose one to go back to it, or forward.</source>
        <translation>Toutes les étapes depuis l’ouverture du fichier. Choisissez-en une pour y revenir ou pour y avancer.</translation>
    </message>
    <message>
        <source>What was odd in the file, with line and column. It is kept as it is.</source>
        <translation>Ce que le fichier a d’inhabituel, avec la ligne et la colonne. Il est conservé tel quel.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>Six short steps in this window: contraction, fixed point, chaos game, address, barycentric coordinates, dimension</source>
        <translation>Six courtes étapes dans cette fenêtre&#x202f;: contraction, point fixe, jeu du chaos, adresse, coordonnées barycentriques, dimension</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>Qu’est-ce que c’&amp;est&#x202f;?</translation>
    </message>
    <message>
        <source>Click anything to read what it is for</source>
        <translation>Cliquez sur un élément pour lire à quoi il sert</translation>
    </message>
    <message>
        <source>No recovery</source>
        <translation>Pas de récupération</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Autoriser les systèmes &amp;sans attracteur</translation>
    </message>
    <message>
        <source>Let maps be dragged to where they no longer contract; otherwise the drag stops there</source>
        <translation>Laisser tirer les applications là où elles ne contractent plus ; sinon le glissement s’arrête là</translation>
    </message>
    <message>
        <source>Drag t&amp;he Maps</source>
        <translation>Tirer les a&amp;pplications</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Show the maps as images of the cage and take them by their corners</source>
        <translation>Montrer les applications comme images de la cage et les saisir par leurs coins</translation>
    </message>
    <message>
        <source>Drag a Bra&amp;nch</source>
        <translation>Tirer une bra&amp;nche</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Click a point of the attractor and take the branch that it belongs to</source>
        <translation>Cliquer sur un point de l’attracteur et saisir la branche à laquelle il appartient</translation>
    </message>
    <message>
        <source>Maps and Branches</source>
        <translation>Applications et branches</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Add the fractals on the clipboard to the file: entries of an .ifs file, flames or a table of numbers</source>
        <translation>Ajouter au fichier les fractales du presse-papiers : entrées d’un fichier .ifs, flames ou tableau de nombres</translation>
    </message>
    <message>
        <source>The unsaved work is here all the same.</source>
        <translation>Le travail non enregistré est ici malgré tout.</translation>
    </message>
    <message>
        <source>%1 was not recovered. It is offered again at the next start.</source>
        <translation>%1 n’a pas été récupéré. Il sera proposé à nouveau au prochain démarrage.</translation>
    </message>
    <message>
        <source>Esc brings menus and panels back.</source>
        <translation>Échap ramène les menus et les panneaux.</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>Pr&amp;ésentation</translation>
    </message>
    <message>
        <source>Shift+F11</source>
        <translation>Shift+F11</translation>
    </message>
    <message>
        <source>Leave the whole screen to the canvas, as for a projector; Esc brings the rest back</source>
        <translation>Laisser tout l’écran à la zone de dessin, par exemple pour un projecteur&#x202f;; Échap ramène le reste</translation>
    </message>
    <message>
        <source>Add Ra&amp;ndom Fractal…</source>
        <translation>Ajouter une &amp;fractale aléatoire…</translation>
    </message>
    <message>
        <source>Only the Pi&amp;cture</source>
        <translation>&amp;Image seule</translation>
    </message>
</context>
<context>
    <name>NumberField</name>
    <message>
        <source>The number must be greater than %1.</source>
        <translation>Le nombre doit être strictement supérieur à %1.</translation>
    </message>
    <message>
        <source>The number must be at least %1.</source>
        <translation>Le nombre doit être au moins égal à %1.</translation>
    </message>
    <message>
        <source>The number must be less than %1.</source>
        <translation>Le nombre doit être strictement inférieur à %1.</translation>
    </message>
    <message>
        <source>The number must be at most %1.</source>
        <translation>Le nombre doit être au plus égal à %1.</translation>
    </message>
    <message>
        <source>A number is missing here.</source>
        <translation>Il manque ici un nombre.</translation>
    </message>
    <message>
        <source>“%1” is a fraction: write it as a decimal number.</source>
        <translation>«&#x202f;%1&#x202f;» est une fraction&#x202f;: écrivez-la sous forme décimale.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>«&#x202f;%1&#x202f;» est un nombre trop grand.</translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Récupérer le travail non enregistré</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>Reading “%1” was cancelled.</source>
        <translation>La lecture de «&#x202f;%1&#x202f;» a été annulée.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Enregistrement de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>Saving “%1” was cancelled. The file on the disk is as it was.</source>
        <translation>L’enregistrement de «&#x202f;%1&#x202f;» a été annulé. Le fichier sur le disque est resté tel quel.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and cannot be opened.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier ordinaire et ne peut pas être ouvert.</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Maple</source>
        <translation>Érable</translation>
    </message>
    <message>
        <source>Fern</source>
        <translation>Fougère</translation>
    </message>
    <message>
        <source>Glacier</source>
        <translation>Glacier</translation>
    </message>
    <message>
        <source>Orchid</source>
        <translation>Orchidée</translation>
    </message>
    <message>
        <source>Aurora</source>
        <translation>Aurore</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Crépuscule</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Cuivre</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Lagon</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>Argent</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Encre</translation>
    </message>
    <message>
        <source>Herbarium</source>
        <translation>Herbier</translation>
    </message>
    <message>
        <source>Sanguine</source>
        <translation>Sanguine</translation>
    </message>
    <message>
        <source>Cyanotype</source>
        <translation>Cyanotype</translation>
    </message>
</context>
<context>
    <name>PngSystem</name>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed its text.</source>
        <translation>L’image ne contient pas de système&#x202f;: elle n’a pas été écrite par Barycage, ou un autre programme en a retiré le texte.</translation>
    </message>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>Le système contenu dans l’image dépasse 8 Mo.</translation>
    </message>
    <message>
        <source>The file is no PNG picture, or it is damaged.</source>
        <translation>Le fichier n’est pas une image PNG, ou il est endommagé.</translation>
    </message>
</context>
<context>
    <name>PngWriter</name>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Impossible d’écrire l’image&#x202f;: %1</translation>
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
        <translation>Un travail non enregistré a été trouvé</translation>
    </message>
    <message>
        <source>Barycage ended last time before this work was saved:</source>
        <translation>La dernière fois, Barycage s’est arrêté avant que ce travail ne soit enregistré&#x202f;:</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Ask Later</source>
        <translation>Demander plus tard</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for recovery: the folder “%1” cannot be written to, or the disk is full. Save often.</source>
        <translation>Le travail non enregistré ne peut pas être gardé pour la récupération : on ne peut pas écrire dans le dossier « %1 », ou le disque est plein. Enregistrez souvent.</translation>
    </message>
    <message>
        <source>Unsaved work of last time is damaged and cannot be recovered. What is left of it lies in:</source>
        <translation>Un travail non enregistré de la dernière fois est endommagé et ne peut pas être récupéré. Ce qu’il en reste se trouve dans&#x202f;:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Recherche du travail non enregistré…</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 G points</source>
        <translation>%1 Md de points</translation>
    </message>
    <message>
        <source>%1 M points</source>
        <translation>%1 M de points</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>hyperbolique, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 (words of %2 maps)</source>
        <translation>ultimement contractant, γ = %1 (mots de %2 applications)</translation>
    </message>
    <message>
        <source>no attractor: the word %1 does not contract</source>
        <translation>pas d’attracteur&#x202f;: le mot %1 n’est pas contractant</translation>
    </message>
    <message>
        <source>existence of an attractor undecided</source>
        <translation>existence d’un attracteur indécise</translation>
    </message>
    <message>
        <source>no map takes part</source>
        <translation>aucune application active</translation>
    </message>
    <message>
        <source>Pointer position</source>
        <translation>Position du pointeur</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and the factor by which it contracts</source>
        <translation>Si le système a un attracteur, et le facteur dont il contracte</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Points drawn so far and the time of the last pass</source>
        <translation>Points dessinés jusqu’ici et durée de la dernière passe</translation>
    </message>
    <message>
        <source>  barycentric (%1)</source>
        <translation>  barycentriques (%1)</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D&#x202f;: pas encore affiché</translation>
    </message>
    <message>
        <source>this entry could not be read</source>
        <translation>cette entrée n’a pas pu être lue</translation>
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
        <translation>Coordonnées cartésiennes et barycentriques du pointeur ; l’adresse du point de l’attracteur qui est dessous, l’application la plus extérieure d’abord, et le point fixe de sa branche</translation>
    </message>
    <message>
        <source>  address %1</source>
        <translation>  adresse %1</translation>
    </message>
    <message>
        <source>  fixed point of %1 (%2, %3)</source>
        <translation>  point fixe de %1 (%2, %3)</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>no attractor: map %1 does not contract</source>
        <translation>pas d’attracteur&#x202f;: l’application %1 n’est pas contractante</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>Le système contenu dans l’image dépasse 8 Mo.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>Le système contenu dans l’image est endommagé.</translation>
    </message>
    <message>
        <source>The picture declares a document type, which Barycage never writes and does not read.</source>
        <translation>L’image déclare un type de document, ce que Barycage n’écrit jamais et ne lit pas.</translation>
    </message>
    <message>
        <source>The file is no SVG picture, or it is damaged.</source>
        <translation>Le fichier n’est pas une image SVG, ou il est endommagé.</translation>
    </message>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed it.</source>
        <translation>L’image ne contient pas de système&#x202f;: elle n’a pas été écrite par Barycage, ou un autre programme l’en a retiré.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a document type is not accepted in a flame file</source>
        <translation>un type de document n’est pas accepté dans un fichier de flammes</translation>
    </message>
    <message>
        <source>The XML ends here: %1.</source>
        <translation>Le XML s’arrête ici&#x202f;: %1.</translation>
    </message>
    <message>
        <source>There is no flame in this file.</source>
        <translation>Ce fichier ne contient pas de flamme.</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Dessin de l’image…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Print “%1”</source>
        <translation>Imprimer «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>in space</source>
        <translation>dans l’espace</translation>
    </message>
    <message>
        <source>no attractor</source>
        <translation>pas d’attracteur</translation>
    </message>
    <message>
        <source>The sheet would be %1 by %2 pixels; at most %3 a side can be drawn. Take smaller tiles, or other columns.</source>
        <translation>La planche ferait %1 sur %2 pixels&#x202f;; on peut dessiner au plus %3 pixels par côté. Prenez des vignettes plus petites, ou un autre nombre de colonnes.</translation>
    </message>
    <message>
        <source>the amount of “%1” is not a number</source>
        <translation>le coefficient de «&#x202f;%1&#x202f;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>it uses a variation other than linear</source>
        <translation>elle utilise une variation autre que linear</translation>
    </message>
    <message>
        <source>it acts in space (“%1”)</source>
        <translation>elle agit dans l’espace («&#x202f;%1&#x202f;»)</translation>
    </message>
    <message>
        <source>it uses the variation “%1”</source>
        <translation>elle utilise la variation «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>its “coefs” are not six numbers</source>
        <translation>ses «&#x202f;coefs&#x202f;» ne sont pas six nombres</translation>
    </message>
    <message>
        <source>its “post” is not six numbers</source>
        <translation>son «&#x202f;post&#x202f;» n’est pas formé de six nombres</translation>
    </message>
    <message>
        <source>its “chaos” allows some successors only, which a list of maps cannot say</source>
        <translation>son «&#x202f;chaos&#x202f;» n’autorise que certains successeurs, ce qu’une liste d’applications ne peut exprimer</translation>
    </message>
    <message>
        <source>it takes part without being drawn (opacity 0)</source>
        <translation>elle agit sans être dessinée (opacity 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>son poids n’est pas un nombre</translation>
    </message>
    <message>
        <source>it has a final transform</source>
        <translation>elle a une transformation finale</translation>
    </message>
    <message>
        <source>it adds a symmetry</source>
        <translation>elle ajoute une symétrie</translation>
    </message>
    <message>
        <source>it has motion</source>
        <translation>elle est animée</translation>
    </message>
    <message>
        <source>it has layers</source>
        <translation>elle a des calques</translation>
    </message>
    <message>
        <source>The flame “%1” is not a system of affine maps: %2.</source>
        <translation>La flamme «&#x202f;%1&#x202f;» n’est pas un système d’applications affines&#x202f;: %2.</translation>
    </message>
    <message>
        <source>it has more than %1 transforms</source>
        <translation>elle a plus de %1 transformations</translation>
    </message>
    <message>
        <source>transform %1: %2</source>
        <translation>transformation %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>The flame “%1” has no transforms.</source>
        <translation>La flamme «&#x202f;%1&#x202f;» n’a pas de transformations.</translation>
    </message>
    <message>
        <source>The entry that opens here is not closed by “}” before the next entry or the end of the file.</source>
        <translation>L’entrée qui s’ouvre ici n’est pas fermée par «&#x202f;}&#x202f;» avant l’entrée suivante ou la fin du fichier.</translation>
    </message>
    <message>
        <source>%1 more problems in this entry are not listed.</source>
        <translation>%1 autres problèmes de cette entrée ne sont pas listés.</translation>
    </message>
    <message>
        <source>The name “%1” holds a blank; Fractint takes only its first word.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» contient une espace&#x202f;; Fractint n’en retient que le premier mot.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint cuts it there.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» dépasse 18 octets&#x202f;; Fractint le coupe là.</translation>
    </message>
    <message>
        <source>The opening brace stands on a line of its own; Fractint does not find this entry.</source>
        <translation>L’accolade ouvrante est seule sur sa ligne&#x202f;; Fractint ne trouve pas cette entrée.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>L’entrée a plus de %1 applications, ce qui est la limite.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be read as a decimal point or between two numbers, and both give whole rows. Write decimal points and blanks.</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: la virgule peut être décimale ou séparer deux nombres, et les deux lectures donnent des lignes complètes. Écrivez des points décimaux et des espaces.</translation>
    </message>
    <message>
        <source>“%1”: neither as a decimal point nor between two numbers does the comma give whole rows of 7 numbers (13 with “(3D)”).</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: que la virgule soit décimale ou sépare deux nombres, on n’obtient pas de lignes complètes de 7 nombres (13 avec «&#x202f;(3D)&#x202f;»).</translation>
    </message>
    <message>
        <source>The numbers on the line of the opening brace are ignored, as Fractint ignores them.</source>
        <translation>Les nombres placés sur la ligne de l’accolade ouvrante sont ignorés, comme le fait Fractint.</translation>
    </message>
    <message>
        <source>“%1” is not understood by this version of Barycage; the line is kept.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas compris par cette version de Barycage&#x202f;; la ligne est conservée.</translation>
    </message>
    <message>
        <source>The entry holds no numbers.</source>
        <translation>L’entrée ne contient pas de nombres.</translation>
    </message>
    <message>
        <source>This line has %1 numbers and the entry %2, which is no multiple of %3: a map is %3 numbers%4.</source>
        <translation>Cette ligne a %1 nombres et l’entrée %2, ce qui n’est pas un multiple de %3&#x202f;: une application compte %3 nombres%4.</translation>
    </message>
    <message>
        <source> in an entry marked “(3D)”</source>
        <translation> dans une entrée marquée «&#x202f;(3D)&#x202f;»</translation>
    </message>
    <message>
        <source>“%1” is not a plain number: Fractint reads %2 and ignores the rest. Write it as one decimal number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre simple&#x202f;: Fractint lit %2 et ignore le reste. Écrivez-le comme un seul nombre décimal.</translation>
    </message>
    <message>
        <source>“%1” is not a finite number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>“%1” is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>«&#x202f;%1&#x202f;» est plus grand que ne peut l’être un coefficient (3,4e38 en valeur absolue).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Write the plain “-”.</source>
        <translation>«&#x202f;%1&#x202f;» commence par un signe moins typographique (U+2212). Écrivez le simple «&#x202f;-&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>Numbers stand on the line of the opening brace, where Fractint ignores them; they are read.</source>
        <translation>Des nombres se trouvent sur la ligne de l’accolade ouvrante, où Fractint les ignore&#x202f;; ils sont lus.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads other numbers here.</source>
        <translation>Les virgules sont lues comme des séparateurs décimaux&#x202f;; Fractint lit ici d’autres nombres.</translation>
    </message>
    <message>
        <source>Commas or apostrophes stand between the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Des virgules ou des apostrophes séparent les nombres&#x202f;; Iterated Dynamics ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each); weights are taken from the determinants. Fractint cannot read this entry.</source>
        <translation>Les applications n’ont pas de poids (%1 nombres chacune)&#x202f;; les poids sont tirés des déterminants. Fractint ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Des lignes de %1 nombres sans «&#x202f;(3D)&#x202f;» après le nom sont lues comme un système 3D&#x202f;; Fractint ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>The lines do not hold 7 numbers each, but all numbers together fill rows of 7 and are read so, as Fractint does. Probably the weights are missing.</source>
        <translation>Les lignes n’ont pas 7 nombres chacune, mais tous les nombres réunis remplissent des lignes de 7 et sont lus ainsi, comme le fait Fractint. Les poids manquent probablement.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>L’accolade fermante touche le dernier nombre&#x202f;; Fractint ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint cuts it there.</source>
        <translation>La ligne dépasse 200 octets&#x202f;; Fractint la coupe là.</translation>
    </message>
    <message>
        <source>A NUL byte; the rest of the line is ignored, as Fractint ignores it.</source>
        <translation>Un octet NUL&#x202f;; le reste de la ligne est ignoré, comme le fait Fractint.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>L’entrée a %1 applications&#x202f;; Fractint et Iterated Dynamics en lisent au plus 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map counts as switched off.</source>
        <translation>Le poids de l’application %1 est négatif&#x202f;; l’application est considérée comme désactivée.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0; the map takes no part.</source>
        <translation>Le poids de l’application %1 est nul&#x202f;; l’application n’est pas active.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are used in proportion; Fractint gives what is missing to the last map and cuts what is too much.</source>
        <translation>La somme des poids est %1, et non 1. Ils sont utilisés en proportion&#x202f;; Fractint donne ce qui manque à la dernière application et coupe ce qui est en trop.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Le fichier est vide.</translation>
    </message>
    <message>
        <source>These are Fractint parameter sets or formulas; no iterated function system is among them.</source>
        <translation>Ce sont des jeux de paramètres ou des formules de Fractint&#x202f;; aucun système de fonctions itérées n’y figure.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry is a name, “{”, rows of 7 numbers and “}”.</source>
        <translation>Aucun système de fonctions itérées n’a été trouvé&#x202f;: une entrée est un nom, «&#x202f;{&#x202f;», des lignes de 7 nombres et «&#x202f;}&#x202f;».</translation>
    </message>
    <message>
        <source>The file has more than %1 entries; the rest is kept as text but not shown.</source>
        <translation>Le fichier a plus de %1 entrées&#x202f;; le reste est conservé comme texte, mais n’est pas affiché.</translation>
    </message>
    <message>
        <source>A block without a name is kept as text; Fractint does not list it.</source>
        <translation>Un bloc sans nom est conservé comme texte&#x202f;; Fractint ne le liste pas.</translation>
    </message>
    <message>
        <source>Two opening braces on one line: no reader finds an entry here. The text is kept.</source>
        <translation>Deux accolades ouvrantes sur une même ligne&#x202f;: aucun programme ne trouve d’entrée ici. Le texte est conservé.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>«&#x202f;%1&#x202f;» est un jeu de paramètres ou une formule, et non un système de fonctions itérées&#x202f;; il est conservé comme texte.</translation>
    </message>
    <message>
        <source>The name is taken by the entry in line %1 (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>Le nom est déjà pris par l’entrée de la ligne %1 (Fractint compare 18 caractères sans distinguer majuscules et minuscules)&#x202f;; Fractint n’atteint jamais celle-ci.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint takes for a part of the first name.</source>
        <translation>Le fichier commence par une marque d’ordre des octets (BOM), que Fractint prend pour une partie du premier nom.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); the entries after it are read all the same.</source>
        <translation>Fractint cesse de lire à cet octet (^Z)&#x202f;; les entrées suivantes sont lues malgré tout.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use the first 2000.</source>
        <translation>Le fichier a %1 entrées&#x202f;; Fractint et Iterated Dynamics utilisent les 2000 premières.</translation>
    </message>
    <message>
        <source>The entry has no map that takes part and is left out.</source>
        <translation>L’entrée n’a aucune application active et est omise.</translation>
    </message>
    <message>
        <source>%1 maps that take no part are left out.</source>
        <translation>%1 applications inactives sont omises.</translation>
    </message>
    <message>
        <source>The entry is written under the name “%1”: other programs take 18 plain characters, and each name once.</source>
        <translation>L’entrée est écrite sous le nom «&#x202f;%1&#x202f;»&#x202f;: d’autres programmes acceptent 18 caractères simples, et chaque nom une seule fois.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>L’entrée a %1 applications&#x202f;; Fractint jusqu’à 17.2 en lit au plus 31.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>hyperbolique, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 from words of length %2</source>
        <translation>ultimement contractant, γ = %1 pour les mots de longueur %2</translation>
    </message>
    <message>
        <source>none: a word of length %1 does not contract</source>
        <translation>aucun&#x202f;: un mot de longueur %1 n’est pas contractant</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>indécis</translation>
    </message>
    <message>
        <source>none: no map takes part</source>
        <translation>aucun&#x202f;: pas d’application active</translation>
    </message>
    <message>
        <source>   norm %1, determinant %2</source>
        <translation>   norme %1, déterminant %2</translation>
    </message>
    <message>
        <source>map %1</source>
        <translation>application %1</translation>
    </message>
    <message>
        <source>attractor</source>
        <translation>attracteur</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>moyenne</translation>
    </message>
    <message>
        <source>covariance</source>
        <translation>covariance</translation>
    </message>
    <message>
        <source>bounding box</source>
        <translation>boîte englobante</translation>
    </message>
    <message>
        <source>canonical simplex</source>
        <translation>simplexe canonique</translation>
    </message>
    <message>
        <source>convex hull</source>
        <translation>enveloppe convexe</translation>
    </message>
    <message>
        <source>%1 vertices, %2 facets, volume %3; error at most %4</source>
        <translation>%1 sommets, %2 faces, volume %3&#x202f;; erreur d’au plus %4</translation>
    </message>
    <message>
        <source>similarity dimension</source>
        <translation>dimension de similitude</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>dimension d’affinité</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2 maps</source>
        <translation>%1 — dans le plan, %2 applications</translation>
    </message>
    <message>
        <source>%1 — in space, %2 maps</source>
        <translation>%1 — dans l’espace, %2 applications</translation>
    </message>
    <message>
        <source>%1 — could not be read</source>
        <translation>%1 — n’a pas pu être lue</translation>
    </message>
    <message>
        <source>cage at rest</source>
        <translation>cage au repos</translation>
    </message>
    <message>
        <source>cage now</source>
        <translation>cage actuelle</translation>
    </message>
    <message>
        <source>The stored cage is not usable (its lists of vertices do not match, or its rest vertices lie on one line, cross each other or are more than 64) and is not applied.</source>
        <translation>La cage enregistrée est inutilisable (ses listes de sommets ne se correspondent pas, ou ses sommets au repos sont alignés, forment un polygone croisé ou sont plus de 64) et n’est pas appliquée.</translation>
    </message>
    <message>
        <source>The stored palette “%1” is unknown and is not applied.</source>
        <translation>La palette enregistrée «&#x202f;%1&#x202f;» est inconnue et n’est pas appliquée.</translation>
    </message>
    <message>
        <source>Map %1 was switched off here, but another program has given it a weight.</source>
        <translation>L’application %1 était désactivée ici, mais un autre programme lui a donné un poids.</translation>
    </message>
    <message>
        <source>A palette has at most %1 colours; the others are left out.</source>
        <translation>Une palette a au plus %1 couleurs&#x202f;; les autres sont omises.</translation>
    </message>
    <message>
        <source>This line is left out: three whole numbers from 0 to 255 make a colour.</source>
        <translation>Cette ligne est omise&#x202f;: une couleur est formée de trois entiers de 0 à 255.</translation>
    </message>
    <message>
        <source>The file holds no colours.</source>
        <translation>Le fichier ne contient pas de couleurs.</translation>
    </message>
    <message>
        <source>The file has more than 16 MB, which no palette needs.</source>
        <translation>Le fichier dépasse 16 Mo, bien plus qu’il n’en faut à une palette.</translation>
    </message>
    <message>
        <source>The file is no text, so it is no palette.</source>
        <translation>Le fichier n’est pas un texte, ce n’est donc pas une palette.</translation>
    </message>
    <message>
        <source>This is a GIMP gradient; palettes are read from .gpl, .ugr and .map files.</source>
        <translation>C’est un dégradé GIMP&#x202f;; les palettes sont lues dans des fichiers .gpl, .ugr et .map.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the others are left out.</source>
        <translation>Le fichier a plus de %1 palettes&#x202f;; les autres sont omises.</translation>
    </message>
    <message>
        <source>The file holds no gradient.</source>
        <translation>Le fichier ne contient pas de dégradé.</translation>
    </message>
    <message>
        <source>The gradient of line %1 is not closed.</source>
        <translation>Le dégradé de la ligne %1 n’est pas fermé.</translation>
    </message>
    <message>
        <source>“%1” is no whole number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un entier.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, of which alone points are written.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un système du plan&#x202f;; on n’écrit de points que pour ceux-ci.</translation>
    </message>
    <message>
        <source>“%1” has no map that takes part, so it has no points.</source>
        <translation>«&#x202f;%1&#x202f;» n’a aucune application active, donc pas de points.</translation>
    </message>
    <message>
        <source>A cage of more than three corners bends the picture, and its points are not written.</source>
        <translation>Une cage de plus de trois sommets courbe l’image, et ses points ne sont pas écrits.</translation>
    </message>
    <message>
        <source>A point cloud has from 1 to %1 points.</source>
        <translation>Un nuage de points compte de 1 à %1 points.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>«&#x202f;%1&#x202f;» est un dossier. Choisissez un nom de fichier.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and is not replaced. Choose another name.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier ordinaire et n’est pas remplacé. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The folder “%1” does not exist. Create it, or save somewhere else.</source>
        <translation>Le dossier «&#x202f;%1&#x202f;» n’existe pas. Créez-le, ou enregistrez ailleurs.</translation>
    </message>
    <message>
        <source>“%1” is read-only. Save under another name, or change its permissions.</source>
        <translation>«&#x202f;%1&#x202f;» est en lecture seule. Enregistrez sous un autre nom, ou changez ses permissions.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again; the file on the disk is as it was.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: le disque est plein. Libérez de la place et enregistrez à nouveau&#x202f;; le fichier sur le disque est resté tel quel.</translation>
    </message>
    <message>
        <source>“%1” was not saved: you may not write to the folder “%2”. Save somewhere else.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: vous n’avez pas le droit d’écrire dans le dossier «&#x202f;%2&#x202f;». Enregistrez ailleurs.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: le nom est trop long.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2. The file on the disk is as it was.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: %2. Le fichier sur le disque est resté tel quel.</translation>
    </message>
    <message>
        <source>The file has no name. Choose one.</source>
        <translation>Le fichier n’a pas de nom. Choisissez-en un.</translation>
    </message>
    <message>
        <source>“%1” does not exist.</source>
        <translation>«&#x202f;%1&#x202f;» n’existe pas.</translation>
    </message>
    <message>
        <source>“%1” is a folder, not a file.</source>
        <translation>«&#x202f;%1&#x202f;» est un dossier, et non un fichier.</translation>
    </message>
    <message>
        <source>“%1” is larger than 256 MB, which is the limit for a file.</source>
        <translation>«&#x202f;%1&#x202f;» dépasse 256 Mo, ce qui est la limite pour un fichier.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas être lu&#x202f;: %2.</translation>
    </message>
    <message>
        <source>Only plane systems can be written as a scalable picture.</source>
        <translation>Seuls les systèmes du plan peuvent être écrits comme image vectorielle.</translation>
    </message>
    <message>
        <source>The system has no attractor of which an outline could be certified, so there is nothing to make copies of.</source>
        <translation>Le système n’a pas d’attracteur dont on puisse certifier un contour&#x202f;: il n’y a donc rien à copier.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>Dans cette vue, l’image est trop grande pour être écrite en formes vectorielles.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row is a b c d e f and perhaps a weight.</source>
        <translation>Il n’y a pas de lignes de nombres&#x202f;: une ligne est a b c d e f, suivie éventuellement d’un poids.</translation>
    </message>
    <message>
        <source>After the count, a map is its weight and a matrix of 3 rows.</source>
        <translation>Après leur nombre, chaque application est donnée par son poids et une matrice de 3 lignes.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map is 0 0 1.</source>
        <translation>La dernière ligne de la matrice d’une application affine est 0 0 1.</translation>
    </message>
    <message>
        <source>The table says that it has %1 maps, and it has %2.</source>
        <translation>Le tableau annonce %1 applications, et il en a %2.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>L’en-tête ne dit pas quelles colonnes sont a, b, c, d, e et f&#x202f;; choisissez l’ordre des colonnes.</translation>
    </message>
    <message>
        <source>This row has %1 numbers; a map is 6 numbers, or 7 with its weight.</source>
        <translation>Cette ligne a %1 nombres&#x202f;; une application en compte 6, ou 7 avec son poids.</translation>
    </message>
    <message>
        <source>“%1” is not a decimal number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre décimal.</translation>
    </message>
    <message>
        <source>The table has more than %1 rows, which is the limit.</source>
        <translation>Le tableau a plus de %1 lignes, ce qui est la limite.</translation>
    </message>
    <message>
        <source>This is a %1 file, not a text with iterated function systems.</source>
        <translation>C’est un fichier %1, et non un texte contenant des systèmes de fonctions itérées.</translation>
    </message>
    <message>
        <source>This is a text in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
        <translation>C’est un texte en UTF-16. Enregistrez-le en UTF-8 ou en ASCII et ouvrez-le à nouveau.</translation>
    </message>
    <message>
        <source>This is a list written by a Racket program (wgmitchener&apos;s IFS editor), not a Fractint collection.</source>
        <translation>C’est une liste écrite par un programme Racket (l’éditeur d’IFS de wgmitchener), et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is a flame file (XML), not a Fractint collection.</source>
        <translation>C’est un fichier de flammes (XML), et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is an SVG picture, not a Fractint collection.</source>
        <translation>C’est une image SVG, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is an XML file of an IFS program such as IFS Explorer, not a Fractint collection.</source>
        <translation>C’est un fichier XML d’un programme d’IFS comme IFS Explorer, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is an XML or HTML file, not a Fractint collection.</source>
        <translation>C’est un fichier XML ou HTML, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is an IFStile file (.aifs), not a Fractint collection.</source>
        <translation>C’est un fichier IFStile (.aifs), et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is a XaoS position file, not a Fractint collection.</source>
        <translation>C’est un fichier de position de XaoS, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>The lines are expressions in x and y, as pyfractal writes them, not a Fractint collection.</source>
        <translation>Les lignes sont des expressions en x et y, telles que les écrit pyfractal, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is a table of the program Fraktale: a count, maps with cumulative percentages and a window. It is not a Fractint collection.</source>
        <translation>C’est un tableau du programme Fraktale&#x202f;: un nombre, des applications avec pourcentages cumulés et une fenêtre. Ce n’est pas une collection Fractint.</translation>
    </message>
    <message>
        <source>This table has 5 numbers per map (scales, shifts and a rotation in pixels). It is not a Fractint collection.</source>
        <translation>Ce tableau a 5 nombres par application (facteurs d’échelle, translations et rotation, en pixels). Ce n’est pas une collection Fractint.</translation>
    </message>
    <message>
        <source>This is a StyrofoamIFS script, not a Fractint collection.</source>
        <translation>C’est un script StyrofoamIFS, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text with iterated function systems.</source>
        <translation>C’est un fichier binaire (peut-être une image à compression fractale ou une bibliothèque d’icônes), et non un texte contenant des systèmes de fonctions itérées.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and for a table of numbers the file is too large: the limit is 64 MB.</source>
        <translation>Aucun système de fonctions itérées n’a été trouvé, et pour un tableau de nombres le fichier est trop grand : la limite est de 64 Mo.</translation>
    </message>
    <message>
        <source>a number is larger than a coefficient can be (3.4e38 in size)</source>
        <translation>un nombre est plus grand que ne peut l’être un coefficient (3.4e38 en valeur absolue)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest is left out.</source>
        <translation>Le fichier a plus de %1 flammes ; le reste est omis.</translation>
    </message>
    <message>
        <source>%1 flames in all are no systems of affine maps.</source>
        <translation>%1 flammes en tout ne sont pas des systèmes d’applications affines.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>L’entrée a plus de %1 lignes, ce qui est la limite ; elle est gardée comme texte.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1 sommets, dont %2 à adresse périodique, aire %3 ; erreur d’au plus %4</translation>
    </message>
    <message>
        <source>deformation</source>
        <translation>déformation</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>courbure</translation>
    </message>
    <message>
        <source>affine fit</source>
        <translation>ajustement affine</translation>
    </message>
    <message>
        <source>A number of this row is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>Un nombre de cette ligne est plus grand que ne peut l’être un coefficient (3.4e38 en valeur absolue).</translation>
    </message>
    <message>
        <source>The text has more than 64 MB, which is the limit for a table of numbers.</source>
        <translation>Le texte dépasse 64 Mo, ce qui est la limite pour un tableau de nombres.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Une balise a plus de %1 attributs, ce qui est la limite.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 deep, which is the limit.</source>
        <translation>Les éléments sont imbriqués à plus de %1 niveaux, ce qui est la limite.</translation>
    </message>
    <message>
        <source>The file has more than 64 MB, which is the limit for XML.</source>
        <translation>Le fichier dépasse 64 Mo, ce qui est la limite pour le XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>branche déplacée</translation>
    </message>
    <message>
        <source>A stored place of a branch is not usable (its map is incomplete, or its address names maps that are not there, or occurs twice, or there are too many) and is not applied.</source>
        <translation>Une place enregistrée d’une branche n’est pas utilisable (son application est incomplète, son adresse nomme des applications qui n’existent pas ou apparaît deux fois, ou il y en a trop) et n’est pas appliquée.</translation>
    </message>
    <message>
        <source>%1 lines of blocks that are no iterated function systems are left out.</source>
        <translation>%1 lignes de blocs qui ne sont pas des systèmes de fonctions itérées sont omises.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Une cellule de cette ligne est vide.</translation>
    </message>
    <message>
        <source>A comma can be read as a decimal point or between two numbers here, and both give whole rows. Write decimal points.</source>
        <translation>La virgule peut ici être décimale ou séparer deux nombres, et les deux lectures donnent des lignes complètes. Écrivez des points décimaux.</translation>
    </message>
    <message>
        <source>The cage and the colours of the entry are left out.</source>
        <translation>La cage et les couleurs de l’entrée sont omises.</translation>
    </message>
    <message>
        <source>The code is written without its cage and moved branches: other programs draw another picture.</source>
        <translation>Le code est écrit sans sa cage ni ses branches déplacées : d’autres programmes dessinent une autre image.</translation>
    </message>
    <message>
        <source>The table has maps of the plane and maps of space.</source>
        <translation>Le tableau a des applications du plan et des applications de l’espace.</translation>
    </message>
    <message>
        <source>This is a list of other files, as the program Fraktale has one, not a Fractint collection.</source>
        <translation>C’est une liste d’autres fichiers, comme celle du programme Fraktale, et non une collection Fractint.</translation>
    </message>
    <message>
        <source>This row has %1 numbers, and the header names %2 columns.</source>
        <translation>Cette ligne a %1 nombres, et l’en-tête nomme %2 colonnes.</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>raison</translation>
    </message>
    <message numerus="yes">
        <source>%n more maps</source>
        <translation>
            <numerusform>%n autre application</numerusform>
            <numerusform>%n autres applications</numerusform>
        </translation>
    </message>
    <message>
        <source>No column is called “%1”: they are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Aucune colonne ne s’appelle «&#x202f;%1&#x202f;»&#x202f;: il y a a b c d ou r s theta phi, e f, et p ou cumulative.</translation>
    </message>
    <message>
        <source>“%1” is there twice.</source>
        <translation>«&#x202f;%1&#x202f;» apparaît deux fois.</translation>
    </message>
    <message>
        <source>A row has one weight: p or cumulative.</source>
        <translation>Une ligne a un seul poids&#x202f;: p ou cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi do not go together.</source>
        <translation>a b c d et r s theta phi ne vont pas ensemble.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Il manque&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than programs read in one path. Choose a smaller depth.</source>
        <translation>Le contour a plus de sommets que les programmes n’en lisent dans un seul tracé. Choisissez une profondeur plus petite.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers are those of the picture at rest.</source>
        <translation>La cage courbe ou aplatit l’image. Les nombres sont ceux de l’image au repos.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8. Please rename the file, or lead to it by a link.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» n’est pas en UTF-8. Renommez le fichier, ou menez-y par un lien.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so the weights of all maps are taken from the determinants and those that are given are not used.</source>
        <translation>L’application %1 n’a pas de poids&#x202f;; les poids de toutes les applications sont donc tirés des déterminants, et ceux qui sont donnés ne sont pas utilisés.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Contraction</source>
        <translation>Contraction</translation>
    </message>
    <message>
        <source>Every row of this table is a map that makes a smaller copy of the whole, and the picture is all copies together. Double-click a number and type another: the copy moves as you type. ‖A‖ is the most by which a map stretches. While it is less than 1, the map contracts. Ctrl+Z takes everything back.</source>
        <translation>Chaque ligne de ce tableau est une application qui fait une copie réduite du tout, et l’image est la réunion de toutes les copies. Double-cliquez sur un nombre et tapez-en un autre&#x202f;: la copie bouge à mesure que vous tapez. ‖A‖ est le plus grand facteur dont l’application étire les distances. Tant qu’il est inférieur à 1, l’application est contractante. Ctrl+Z annule tout.</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Point fixe</translation>
    </message>
    <message>
        <source>A map that contracts leaves exactly one point where it is: its fixed point. Switch off all maps but two by the boxes on the left of the table, and see how little is left of the picture. With one map alone nothing is left but its fixed point. Ctrl+Z brings the maps back.</source>
        <translation>Une application contractante laisse exactement un point à sa place&#x202f;: son point fixe. Désactivez toutes les applications sauf deux avec les cases à gauche du tableau, et voyez le peu qui reste de l’image. Avec une seule application, il ne reste plus que son point fixe. Ctrl+Z rétablit les applications.</translation>
    </message>
    <message>
        <source>Chaos game</source>
        <translation>Jeu du chaos</translation>
    </message>
    <message>
        <source>Press Chaos Game and then the triangle that starts it. One point jumps about, each time by a map drawn at random, and leaves a dot where it lands. Let it go faster: whatever the dice say, the dots fill the same picture, the attractor.</source>
        <translation>Appuyez sur Jeu du chaos, puis sur le triangle qui le lance. Un seul point saute, chaque fois par une application tirée au hasard, et laisse une marque là où il tombe. Accélérez-le&#x202f;: quoi que disent les dés, les points remplissent la même image, l’attracteur.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The map that made the last jump to a point, the one before it, and so on: these numbers are the address of the point. Choose Colour by: Address. Points whose addresses begin alike lie close together, and now they look alike.</source>
        <translation>L’application du dernier saut vers un point, celle d’avant, et ainsi de suite&#x202f;: ces numéros forment l’adresse du point. Choisissez Colorer selon&#x202f;: Adresse. Les points dont les adresses commencent de la même façon sont voisins, et maintenant ils se ressemblent.</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Coordonnées barycentriques</translation>
    </message>
    <message>
        <source>Every point of the picture is a weighted mean of the three corners of the triangle. Take a corner and pull: the points keep their weights, and the whole fractal follows. Squeeze the triangle flat and open it again: nothing is lost. The weights at the pointer stand at the bottom of the window.</source>
        <translation>Chaque point de l’image est une moyenne pondérée des trois sommets du triangle. Prenez un sommet et tirez&#x202f;: les points gardent leurs poids, et la fractale entière suit. Aplatissez le triangle et rouvrez-le&#x202f;: rien n’est perdu. Les poids au pointeur se lisent au bas de la fenêtre.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Dimension</translation>
    </message>
    <message>
        <source>How much of the plane does the attractor fill? The dimension of a curve is 1, that of an area is 2, and most attractors lie between the two. Change a map and look here again. That was the tour; the user guide under Help tells the rest.</source>
        <translation>Quelle part du plan l’attracteur remplit-il&#x202f;? La dimension d’une courbe est 1, celle d’une surface est 2, et la plupart des attracteurs se situent entre les deux. Modifiez une application et regardez de nouveau ici. La visite est finie&#x202f;; le guide d’utilisation, dans le menu Aide, dit le reste.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Précédent</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>New here?</source>
        <translation>C’est votre première fois&#x202f;?</translation>
    </message>
    <message>
        <source>Six short steps show what an attractor is, by pulling on one. You can take the tour later, too: it is in the Help menu.</source>
        <translation>Six courtes étapes montrent ce qu’est un attracteur, en tirant sur l’un d’eux. Vous pourrez aussi faire la visite plus tard&#x202f;: elle est dans le menu Aide.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>&amp;Start the Tour</source>
        <translation>Commencer la &amp;visite</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Suivant</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>The last files, and the collection.</source>
        <translation>Les derniers fichiers et la collection.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenue</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Continuer avec</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>A file, or the collection.</source>
        <translation>Un fichier ou la collection.</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Commencer par</translation>
    </message>
    <message>
        <source>Co&amp;llection</source>
        <translation>Co&amp;llection</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Takes what the dialog shows, and closes it.</source>
        <translation>Applique ce que montre le dialogue, et le ferme.</translation>
    </message>
    <message>
        <source>Closes the dialog and changes nothing.</source>
        <translation>Ferme le dialogue sans rien changer.</translation>
    </message>
    <message>
        <source>Closes the dialog.</source>
        <translation>Ferme le dialogue.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Cette entrée n’a pas d’applications du plan.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Forme affinement invariante</translation>
    </message>
    <message>
        <source>Row j of a matrix holds the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. The matrices do not change when the triangle is dragged. Where no entry is negative, the map takes the triangle into itself.</source>
        <translation>La ligne j d’une matrice contient les coordonnées barycentriques, dans le triangle, de l’image du sommet j&#x202f;; la somme de chaque ligne est donc 1. Les matrices ne changent pas quand on déplace le triangle. Là où aucun coefficient n’est négatif, l’application envoie le triangle dans lui-même.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Every map as a matrix that takes barycentric coordinates over the control triangle to barycentric coordinates: each row has the sum 1.</source>
        <translation>Chaque application comme une matrice qui, relativement au triangle de contrôle, envoie des coordonnées barycentriques sur des coordonnées barycentriques&#x202f;: la somme de chaque ligne est 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices with all digits.</source>
        <translation>Copie le triangle et les matrices avec tous les chiffres.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy takes all of them.
</source>
        <translation>
… et %1 de plus. «&#x202f;Copier&#x202f;» les prend toutes.
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
        <translation>Tout copier</translation>
    </message>
    <message>
        <source>Copy all facts with all digits</source>
        <translation>Copier toutes les propriétés avec tous les chiffres</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D&#x202f;: pas encore affiché.</translation>
    </message>
    <message>
        <source>This entry could not be read, so nothing is known of it.</source>
        <translation>Cette entrée n’a pas pu être lue&#x202f;: on n’en sait donc rien.</translation>
    </message>
    <message>
        <source>Copy with All Digits</source>
        <translation>Copier avec tous les chiffres</translation>
    </message>
    <message>
        <source>Copy All Facts</source>
        <translation>Copier toutes les propriétés</translation>
    </message>
    <message>
        <source>Copies every line as its name and its value with all digits.</source>
        <translation>Copie chaque ligne comme son nom et sa valeur avec tous les chiffres.</translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation>Sur la zone de dessin</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Outline the certified bounding box</source>
        <translation>Tracer la boîte englobante certifiée</translation>
    </message>
    <message>
        <source>Hull</source>
        <translation>Enveloppe</translation>
    </message>
    <message>
        <source>Outline the convex hull</source>
        <translation>Tracer l’enveloppe convexe</translation>
    </message>
    <message>
        <source>Simplex</source>
        <translation>Simplexe</translation>
    </message>
    <message>
        <source>Outline the minimal canonical simplex</source>
        <translation>Tracer le simplexe canonique minimal</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Show the mean and the ellipse of the covariance</source>
        <translation>Montrer la moyenne et l’ellipse de la covariance</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Points fixes</translation>
    </message>
    <message>
        <source>Mark the fixed point of each map in its colour</source>
        <translation>Marquer le point fixe de chaque application dans sa couleur</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Cylindres</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with an address of the same length, in the colour of its first map</source>
        <translation>Tracer les enveloppes de tous les morceaux dont l’adresse a la même longueur, dans la couleur de sa première application</translation>
    </message>
    <message>
        <source>Length of the addresses</source>
        <translation>Longueur des adresses</translation>
    </message>
    <message>
        <source>How many symbols the addresses of the cylinders have; fewer where there would be thousands</source>
        <translation>Combien de symboles ont les adresses des cylindres ; moins là où il y en aurait des milliers</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Longueur d’adresse</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system has it. These are facts of the code; on the canvas they are bent with the picture.</source>
        <translation>La cage courbe l’image, et aucun système ne l’a. Ce sont des faits du code&#x202f;; sur la zone de dessin ils sont courbés avec l’image.</translation>
    </message>
</context>
<context>
    <name>view::AppearancePanel</name>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Reset to Default</source>
        <translation>Valeurs par défaut</translation>
    </message>
    <message>
        <source>Every setting of this panel as in a new fractal</source>
        <translation>Rétablir tous les réglages de ce panneau comme pour une nouvelle fractale</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colorer selon</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>The palette follows the density of points</source>
        <translation>La palette suit la densité des points</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Application</translation>
    </message>
    <message>
        <source>The colour of the last map applied</source>
        <translation>La couleur de la dernière application appliquée</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The palette follows the address of each point</source>
        <translation>La palette suit l’adresse de chaque point</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Uni</translation>
    </message>
    <message>
        <source>One colour; the density is its opacity</source>
        <translation>Une seule couleur&#x202f;; la densité en donne l’opacité</translation>
    </message>
    <message>
        <source>Change what the colour shows</source>
        <translation>Changer ce que montre la couleur</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Couleur unie</translation>
    </message>
    <message>
        <source>Change the plain colour</source>
        <translation>Changer la couleur unie</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Palette</translation>
    </message>
    <message>
        <source>Change the palette</source>
        <translation>Changer la palette</translation>
    </message>
    <message>
        <source>Edit Palette</source>
        <translation>Modifier la palette</translation>
    </message>
    <message>
        <source>Edit the palette, or load one from a file</source>
        <translation>Modifier la palette, ou en charger une depuis un fichier</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Couleur du fond</translation>
    </message>
    <message>
        <source>Change the background colour</source>
        <translation>Changer la couleur du fond</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Make the background transparent</source>
        <translation>Rendre le fond transparent</translation>
    </message>
    <message>
        <source>Make the background opaque</source>
        <translation>Rendre le fond opaque</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Luminosité</translation>
    </message>
    <message>
        <source>Change the brightness</source>
        <translation>Changer la luminosité</translation>
    </message>
    <message>
        <source>How early thin parts become visible: κ of the logarithmic tone curve</source>
        <translation>À partir de quelle densité les parties ténues deviennent visibles&#x202f;: κ de la courbe de tons logarithmique</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Change the gamma</source>
        <translation>Changer le gamma</translation>
    </message>
    <message>
        <source>Exponent of the tone curve: higher values lift the dark parts</source>
        <translation>Exposant de la courbe de tons&#x202f;: une valeur plus grande éclaircit les parties sombres</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Suréchantillonnage</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>%1 × %1 sub-pixels</source>
        <translation>%1 × %1 sous-pixels</translation>
    </message>
    <message>
        <source>Change the supersampling</source>
        <translation>Changer le suréchantillonnage</translation>
    </message>
    <message>
        <source>Map colours</source>
        <translation>Couleurs des applications</translation>
    </message>
    <message>
        <source>Reset the appearance</source>
        <translation>Réinitialiser l’apparence</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Couleur de l’application %1</translation>
    </message>
    <message>
        <source>Change the colour of map %1</source>
        <translation>Changer la couleur de l’application %1</translation>
    </message>
    <message>
        <source>What the colour of a point tells: how many points fall there, which map came last, or the whole address.</source>
        <translation>Ce que dit la couleur d’un point&#x202f;: combien de points tombent là, quelle application a agi en dernier, ou l’adresse entière.</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, or along the addresses.</source>
        <translation>Les couleurs, des parties les plus ténues aux plus denses, ou le long des adresses.</translation>
    </message>
    <message>
        <source>Leaves the background out of exported pictures.</source>
        <translation>Omet le fond dans les images exportées.</translation>
    </message>
    <message>
        <source>Draws every pixel from several finer ones: smoother edges, for more memory and time.</source>
        <translation>Dessine chaque pixel à partir de plusieurs pixels plus fins&#x202f;: des bords plus lisses, pour plus de mémoire et de temps.</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The number beside it is the same value.</source>
        <translation>Faites glisser, ou utilisez les touches fléchées. Le nombre à côté est la même valeur.</translation>
    </message>
</context>
<context>
    <name>view::ArisingBar</name>
    <message>
        <source>How the attractor arises</source>
        <translation>Comment naît l’attracteur</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>The invariant measure, refined while nothing moves</source>
        <translation>La mesure invariante, affinée tant que rien ne bouge</translation>
    </message>
    <message>
        <source>Steps Wⁿ</source>
        <translation>Étapes Wⁿ</translation>
    </message>
    <message>
        <source>The deterministic algorithm: all maps applied n times to the cage at rest</source>
        <translation>L’algorithme déterministe&#x202f;: toutes les applications appliquées n fois à la cage au repos</translation>
    </message>
    <message>
        <source>Chaos Game</source>
        <translation>Jeu du chaos</translation>
    </message>
    <message>
        <source>One point that jumps by maps drawn at random; the first 14 points are not plotted</source>
        <translation>Un point qui saute par des applications tirées au hasard&#x202f;; les 14 premiers points ne sont pas tracés</translation>
    </message>
    <message>
        <source>n: how often all maps are applied</source>
        <translation>n&#x202f;: combien de fois toutes les applications sont appliquées</translation>
    </message>
    <message>
        <source>Begin Again</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>No points yet, and other dice</source>
        <translation>Repartir sans aucun point, avec d’autres tirages</translation>
    </message>
    <message>
        <source>One Point</source>
        <translation>Un point</translation>
    </message>
    <message>
        <source>Plot one more point</source>
        <translation>Tracer un point de plus</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Let points appear</source>
        <translation>Faire apparaître des points</translation>
    </message>
    <message>
        <source>Points a second</source>
        <translation>Points par seconde</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 par seconde</translation>
    </message>
    <message>
        <source>W%1: the cage itself</source>
        <translation>W%1&#x202f;: la cage elle-même</translation>
    </message>
    <message>
        <source>W%1: %2 copies of the cage</source>
        <translation>W%1&#x202f;: %2 copies de la cage</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stay at these points</source>
        <translation>En rester à ces points</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>, the last by map %1</source>
        <translation>, le dernier par l’application %1</translation>
    </message>
    <message>
        <source>How often all maps are applied to the cage: 0 is the cage itself, and with every step the picture comes closer to the attractor.</source>
        <translation>Combien de fois toutes les applications sont appliquées à la cage&#x202f;: 0 donne la cage elle-même, et à chaque étape l’image se rapproche de l’attracteur.</translation>
    </message>
    <message>
        <source>How many points the chaos game plots in a second.</source>
        <translation>Combien de points le jeu du chaos trace en une seconde.</translation>
    </message>
    <message>
        <source>no points yet: press ▶</source>
        <translation>pas encore de points&#x202f;: appuyez sur ▶</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Diagramme du comptage de boîtes</translation>
    </message>
    <message>
        <source>How many boxes meet the attractor, against how fine they are: log₂ N over k for boxes of side L·2⁻ᵏ, L the side of the square around the attractor. Points in outline are left out of the line: there the size of the whole or of a cell shows.</source>
        <translation>Combien de boîtes rencontrent l’attracteur selon leur finesse : log₂ N en fonction de k pour des boîtes de côté L·2⁻ᵏ, L le côté du carré autour de l’attracteur. Les points évidés ne comptent pas pour la droite : là se voit la taille de l’ensemble ou d’une cellule.</translation>
    </message>
    <message>
        <source>Slope %1 over %2 sizes</source>
        <translation>Pente %1 sur %2 tailles</translation>
    </message>
    <message>
        <source>Copy Sizes and Counts</source>
        <translation>Copier les tailles et les nombres</translation>
    </message>
    <message>
        <source>log₂ N</source>
        <translation>log₂ N</translation>
    </message>
    <message>
        <source>k, boxes of side L·2⁻ᵏ</source>
        <translation>k, boîtes de côté L·2⁻ᵏ</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>pente %1</translation>
    </message>
</context>
<context>
    <name>view::BranchBar</name>
    <message>
        <source>Maps and branches</source>
        <translation>Applications et branches</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Profondeur</translation>
    </message>
    <message>
        <source>Depth of the branch</source>
        <translation>Profondeur de la branche</translation>
    </message>
    <message>
        <source>How many maps of the address name the branch (Shift + wheel over the canvas)</source>
        <translation>Combien d’applications de l’adresse nomment la branche (Maj + molette sur la zone de dessin)</translation>
    </message>
    <message>
        <source>The address of the point clicked, outermost map first; the branch is what is bold</source>
        <translation>L’adresse du point cliqué, l’application la plus extérieure d’abord ; la branche est ce qui est en gras</translation>
    </message>
    <message>
        <source>this branch, as a map of its own</source>
        <translation>cette branche, comme application à part</translation>
    </message>
    <message>
        <source>The system gets a map for this branch and one for every branch beside it. Its change is seen again at all smaller scales.</source>
        <translation>Le système reçoit une application pour cette branche et une pour chaque branche voisine. Le changement se revoit à toutes les échelles plus petites.</translation>
    </message>
    <message>
        <source>the last map of its address</source>
        <translation>la dernière application de son adresse</translation>
    </message>
    <message>
        <source>The code keeps its maps. All branches that this map makes change alike.</source>
        <translation>Le code garde ses applications. Toutes les branches que fait cette application changent de même.</translation>
    </message>
    <message>
        <source>What changing the branch changes</source>
        <translation>Ce que change la modification de la branche</translation>
    </message>
    <message>
        <source>&amp;Weave</source>
        <translation>&amp;Tisser</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Angle dont les applications choisies oscillent autour de leurs racines</translation>
    </message>
    <message>
        <source>Lets the selected maps swing, each about the image of the lowest point of the fractal; the slider goes back to the middle when it is let go</source>
        <translation>Fait osciller les applications choisies, chacune autour de l’image du point le plus bas de la fractale ; relâché, le curseur revient au milieu</translation>
    </message>
    <message>
        <source>no branch selected</source>
        <translation>aucune branche choisie</translation>
    </message>
    <message>
        <source>branch &lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation>branche &lt;b&gt;%1&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Let maps swing</source>
        <translation>Faire osciller des applications</translation>
    </message>
    <message>
        <source>where it is shown, and it alone</source>
        <translation>où elle est montrée, et elle seule</translation>
    </message>
    <message>
        <source>The code stays as it is. This branch is shown elsewhere, and nothing like it at other scales.</source>
        <translation>Le code reste tel quel. Cette branche est montrée ailleurs, et rien de semblable aux autres échelles.</translation>
    </message>
    <message>
        <source>Put &amp;Back</source>
        <translation>&amp;Remettre en place</translation>
    </message>
    <message>
        <source>Put All &amp;Back</source>
        <translation>Tout &amp;remettre en place</translation>
    </message>
    <message>
        <source>Shows the branch where its maps put it</source>
        <translation>Montre la branche là où ses applications la mettent</translation>
    </message>
    <message>
        <source>Shows every branch where its maps put it</source>
        <translation>Montre chaque branche là où ses applications la mettent</translation>
    </message>
    <message>
        <source>Put branch %1 back</source>
        <translation>Remettre la branche %1 en place</translation>
    </message>
    <message>
        <source>Put all branches back</source>
        <translation>Remettre toutes les branches en place</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>&amp;Modifier</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Cliquez sur un point de l’attracteur pour choisir sa branche.</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Branche %1</translation>
    </message>
    <message>
        <source>Move corner %1 of branch %2</source>
        <translation>Déplacer le coin %1 de la branche %2</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Déplacer la branche %1</translation>
    </message>
    <message>
        <source>Rotate branch %1</source>
        <translation>Tourner la branche %1</translation>
    </message>
    <message>
        <source>Scale branch %1</source>
        <translation>Mettre à l’échelle la branche %1</translation>
    </message>
    <message>
        <source>This branch is map 1 now. Numbers in the table change it further.</source>
        <translation>Cette branche est maintenant l’application 1. Les nombres du tableau continuent de la modifier.</translation>
    </message>
</context>
<context>
    <name>view::CageActions</name>
    <message>
        <source>This entry is not a system of the plane, so it has no control cage.</source>
        <translation>Cette entrée n’est pas un système du plan&#x202f;; elle n’a donc pas de cage de contrôle.</translation>
    </message>
    <message>
        <source>The cage is too flat to be undone. Open it by dragging a vertex, or reset it, and try again.</source>
        <translation>La cage est trop plate pour que l’on puisse l’inverser. Ouvrez-la en déplaçant un sommet, ou réinitialisez-la, puis réessayez.</translation>
    </message>
    <message>
        <source>The three points lie on one line and hold no coordinates. Put the third one beside the line.</source>
        <translation>Les trois points sont alignés et ne portent pas de coordonnées. Placez le troisième à côté de la droite.</translation>
    </message>
    <message>
        <source>Fit the minimal canonical simplex</source>
        <translation>Ajuster le simplexe canonique minimal</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Réinitialiser la cage</translation>
    </message>
    <message>
        <source>Bake the placement into the code</source>
        <translation>Intégrer le placement au code</translation>
    </message>
    <message>
        <source>Define the control triangle</source>
        <translation>Définir le triangle de contrôle</translation>
    </message>
    <message>
        <source>Vertex %1 is there already.</source>
        <translation>Le sommet %1 y est déjà.</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Déplacer le sommet %1</translation>
    </message>
    <message>
        <source>A cage has at most %1 vertices.</source>
        <translation>Une cage a au plus %1 sommets.</translation>
    </message>
    <message>
        <source>There is no room for a vertex here.</source>
        <translation>Il n’y a pas de place ici pour un sommet.</translation>
    </message>
    <message>
        <source>Insert a vertex</source>
        <translation>Insérer un sommet</translation>
    </message>
    <message>
        <source>A cage has at least three vertices.</source>
        <translation>Une cage a au moins trois sommets.</translation>
    </message>
    <message>
        <source>Without this vertex the cage at rest would cross itself or be flat.</source>
        <translation>Sans ce sommet, la cage au repos serait croisée ou plate.</translation>
    </message>
    <message>
        <source>Delete vertex %1</source>
        <translation>Supprimer le sommet %1</translation>
    </message>
    <message>
        <source>Make the cage regular</source>
        <translation>Rendre la cage régulière</translation>
    </message>
    <message>
        <source>Unbake: take the placement out of the code</source>
        <translation>Extraire le placement du code</translation>
    </message>
    <message>
        <source>Without these vertices the cage at rest would cross itself or be flat.</source>
        <translation>Sans ces sommets, la cage au repos serait croisée ou plate.</translation>
    </message>
    <message>
        <source>Delete %1 vertices</source>
        <translation>Supprimer %1 sommets</translation>
    </message>
    <message>
        <source>The cage is the minimal canonical simplex already.</source>
        <translation>La cage est déjà le simplexe canonique minimal.</translation>
    </message>
    <message>
        <source>The cage is regular already.</source>
        <translation>La cage est déjà régulière.</translation>
    </message>
</context>
<context>
    <name>view::CagePanel</name>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>State of the cage</source>
        <translation>État de la cage</translation>
    </message>
    <message>
        <source>Warning about the cage</source>
        <translation>Avertissement sur la cage</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Placer</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Réécrire</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation>Déplacer la cage déplace l’image&#x202f;; le code reste</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Déplacer la cage réécrit le code</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Courber</translation>
    </message>
    <message>
        <source>Affine fit</source>
        <translation>Ajustement affine</translation>
    </message>
    <message>
        <source>Every vertex is followed; the picture bends, which cannot be baked into a code</source>
        <translation>Chaque sommet est suivi&#x202f;; l’image se courbe, ce qui ne peut pas être intégré à un code</translation>
    </message>
    <message>
        <source>The picture moves by the affine map that comes nearest to the vertices; it can be baked</source>
        <translation>L’image suit l’application affine qui s’approche le plus des sommets&#x202f;; celle-ci peut être intégrée au code</translation>
    </message>
    <message>
        <source>Bend the picture</source>
        <translation>Courber l’image</translation>
    </message>
    <message>
        <source>Fit the picture by an affine map</source>
        <translation>Ajuster l’image par une application affine</translation>
    </message>
    <message>
        <source>Define…</source>
        <translation>Définir…</translation>
    </message>
    <message>
        <source>Define the triangle by three clicks on the canvas; the picture stays</source>
        <translation>Définir le triangle en trois clics dans la zone de dessin&#x202f;; l’image reste</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Intégrer</translation>
    </message>
    <message>
        <source>Minimal Canonical Simplex</source>
        <translation>Simplexe canonique minimal</translation>
    </message>
    <message>
        <source>Canonical Simplex %1</source>
        <translation>Simplexe canonique %1</translation>
    </message>
    <message>
        <source>Bounding Box</source>
        <translation>Boîte englobante</translation>
    </message>
    <message numerus="yes">
        <source>%n Corners</source>
        <translation>
            <numerusform>%n sommet</numerusform>
            <numerusform>%n sommets</numerusform>
        </translation>
    </message>
    <message>
        <source>Convex Hull, Simplified to</source>
        <translation>Enveloppe convexe simplifiée à</translation>
    </message>
    <message>
        <source>Regular Polygon with</source>
        <translation>Polygone régulier à</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Ajuster la cage</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Rest cage</source>
        <translation>Cage au repos</translation>
    </message>
    <message>
        <source>Show the vertices that hold the attractor while the cage is at rest</source>
        <translation>Montrer les sommets qui tiennent l’attracteur quand la cage est au repos</translation>
    </message>
    <message>
        <source>Show the rest cage</source>
        <translation>Afficher la cage au repos</translation>
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
        <translation>x au repos</translation>
    </message>
    <message>
        <source>y at rest</source>
        <translation>y au repos</translation>
    </message>
    <message>
        <source>Minimal canonical simplex</source>
        <translation>Simplexe canonique minimal</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs say to which side its legs point from the right angle.</source>
        <translation>Le plus petit triangle rectangle isocèle aux cathètes parallèles aux axes qui contient l’image. Les signes disent de quel côté pointent ses cathètes depuis l’angle droit.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Coordonnées barycentriques d’un point</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 that the vertices take to balance in the point.</source>
        <translation>Les poids a, b, c, avec a + b + c = 1, qu’il faut donner aux sommets pour que le point en soit le barycentre.</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>x du point</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>y du point</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Coordonnées barycentriques</translation>
    </message>
    <message>
        <source>%1 of vertex %2</source>
        <translation>%1 du sommet %2</translation>
    </message>
    <message>
        <source>%1 of rest vertex %2</source>
        <translation>%1 du sommet au repos %2</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Déplacer le sommet %1</translation>
    </message>
    <message>
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Les trois points sont alignés&#x202f;: la cage au repos doit entourer une aire.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>La cage au repos doit être un polygone non croisé.</translation>
    </message>
    <message>
        <source>Define vertex %1</source>
        <translation>Définir le sommet %1</translation>
    </message>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>L’image est trop mince pour une telle cage.</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Réinitialiser la cage</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Intégrer la cage au code</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D&#x202f;: pas encore affiché.</translation>
    </message>
    <message>
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Cette entrée n’a pas pu être lue&#x202f;; elle n’a donc pas de cage.</translation>
    </message>
    <message>
        <source>At rest: the picture is that of the code.</source>
        <translation>Au repos&#x202f;: l’image est celle du code.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture is that of the code.</source>
        <translation>%1 sommets, au repos&#x202f;: l’image est celle du code.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates, not bakeable.</source>
        <translation>%1 sommets&#x202f;: image courbée par les coordonnées de Wachspress, impossible à intégrer au code.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, not bakeable.</source>
        <translation>%1 sommets&#x202f;: image courbée par les coordonnées de la valeur moyenne, impossible à intégrer au code.</translation>
    </message>
    <message>
        <source>Flat: the picture lies on one line. Open the cage and it comes back.</source>
        <translation>Plate&#x202f;: l’image est tout entière sur une droite. Ouvrez la cage et elle réapparaît.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the sense of rotation is reversed.</source>
        <translation>Placée et retournée&#x202f;: les aires sont multipliées par %1, et l’orientation est inversée.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Placée&#x202f;: les aires sont multipliées par %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it holds no coordinates.</source>
        <translation>Le triangle est plat&#x202f;: il ne porte pas de coordonnées.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, cathète %2, angle droit en (%3, %4)</translation>
    </message>
    <message>
        <source>Hold the picture by a fitted cage; the picture stays</source>
        <translation>Tenir l’image par une cage ajustée&#x202f;; l’image reste</translation>
    </message>
    <message>
        <source>Put the cage and the picture back to rest</source>
        <translation>Remettre la cage et l’image au repos</translation>
    </message>
    <message>
        <source>Make the displayed picture the code; the cage then rests</source>
        <translation>Faire de l’image affichée le code&#x202f;; la cage est ensuite au repos</translation>
    </message>
    <message>
        <source>The cage is there already.</source>
        <translation>La cage y est déjà.</translation>
    </message>
    <message>
        <source>The coordinates are read over a triangle.</source>
        <translation>Les coordonnées se lisent sur un triangle.</translation>
    </message>
</context>
<context>
    <name>view::CageTool</name>
    <message>
        <source>Move the cage</source>
        <translation>Déplacer la cage</translation>
    </message>
    <message>
        <source>Rotate the cage</source>
        <translation>Faire tourner la cage</translation>
    </message>
    <message>
        <source>Scale the cage</source>
        <translation>Redimensionner la cage</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Déplacer le sommet %1</translation>
    </message>
    <message>
        <source>Move edge %1–%2</source>
        <translation>Déplacer l’arête %1–%2</translation>
    </message>
    <message>
        <source>Move %1 vertices</source>
        <translation>Déplacer %1 sommets</translation>
    </message>
    <message>
        <source>Select a vertex first.</source>
        <translation>Choisissez d’abord un sommet.</translation>
    </message>
    <message>
        <source>Point at an edge, or select a vertex, to insert one.</source>
        <translation>Pour insérer un sommet, pointez une arête ou choisissez un sommet.</translation>
    </message>
</context>
<context>
    <name>view::Canvas</name>
    <message>
        <source>No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). Make it smaller, or switch it off.</source>
        <translation>Pas d’attracteur&#x202f;: l’application %1 n’est pas contractante (plus grande valeur singulière %2, rayon spectral %3). Réduisez-la, ou désactivez-la.</translation>
    </message>
    <message>
        <source>No attractor: the maps %1, one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Pas d’attracteur&#x202f;: les applications %1, l’une après l’autre, ne sont pas contractantes (plus grande valeur singulière %2, rayon spectral %3). Réduisez l’une d’elles, ou désactivez-la.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor: map %1 stretches by %2. Points that run away are left out.</source>
        <translation>On n’a pas pu décider si ce système a un attracteur&#x202f;: l’application %1 étire d’un facteur %2. Les points qui s’échappent sont omis.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor. Points that run away are left out.</source>
        <translation>On n’a pas pu décider si ce système a un attracteur. Les points qui s’échappent sont omis.</translation>
    </message>
    <message>
        <source>This entry is a system in space: not yet shown. It is kept as it is.</source>
        <translation>Cette entrée est un système de l’espace&#x202f;: pas encore affiché. Elle est conservée telle quelle.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept as it is in the file.</source>
        <translation>Cette entrée n’a pas pu être lue. Son texte est conservé tel qu’il est dans le fichier.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Aucune application n’est active&#x202f;: il n’y a rien à dessiner. Ajoutez une application ou activez-en une.</translation>
    </message>
    <message>
        <source>This is as deep as the arithmetic reaches: zoom out a little for a true picture.</source>
        <translation>L’arithmétique ne descend pas plus profond&#x202f;: faites un petit zoom arrière pour une image fidèle.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than asked for: more would need more memory than allowed.</source>
        <translation>Dessiné avec moins d’itérations que demandé&#x202f;: davantage exigerait plus de mémoire que permis.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a vertex to open it: nothing is lost.</source>
        <translation>La cage est plate, et l’image aussi. Tirez un sommet pour l’ouvrir&#x202f;: rien n’est perdu.</translation>
    </message>
    <message>
        <source>Stopped: any farther, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Arrêté : plus loin, l’application %1 ne contracterait pas (plus grande valeur singulière %2, rayon spectral %3), et il n’y aurait pas d’attracteur.</translation>
    </message>
    <message>
        <source>Stopped: any farther, the maps %1, one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Arrêté : plus loin, les applications %1, l’une après l’autre, ne contracteraient pas (plus grande valeur singulière %2, rayon spectral %3), et il n’y aurait pas d’attracteur.</translation>
    </message>
    <message>
        <source>Stopped: any farther, it is not settled whether there would be an attractor (map %1 has the largest singular value, %2).</source>
        <translation>Arrêté : plus loin, il n’est pas établi qu’il y aurait un attracteur (l’application %1 a la plus grande valeur singulière, %2).</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point.</source>
        <translation>Une seule application : il ne reste que son point fixe.</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point (%1, %2).</source>
        <translation>Une seule application : il ne reste que son point fixe (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is on has a weight above 0, so there is nothing to draw. Give one a weight.</source>
        <translation>Aucune application activée n’a un poids supérieur à 0&#x202f;: il n’y a rien à dessiner. Donnez un poids à l’une d’elles.</translation>
    </message>
</context>
<context>
    <name>view::CanvasMenu</name>
    <message>
        <source>Vertex %1</source>
        <translation>Sommet %1</translation>
    </message>
    <message>
        <source>&amp;Coordinates…</source>
        <translation>&amp;Coordonnées…</translation>
    </message>
    <message>
        <source>Types the place of this vertex</source>
        <translation>Saisir la position de ce sommet</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>Ré&amp;initialiser ce sommet</translation>
    </message>
    <message>
        <source>Puts this vertex back to rest</source>
        <translation>Remettre ce sommet au repos</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid Point (%1, %2)</source>
        <translation>Accrocher au point de la &amp;grille (%1, %2)</translation>
    </message>
    <message>
        <source>Moves this vertex to the nearest point of the grid</source>
        <translation>Déplacer ce sommet jusqu’au point de la grille le plus proche</translation>
    </message>
    <message>
        <source>Snap to the &amp;x Axis</source>
        <translation>Accrocher à l’axe des &amp;x</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the x axis</source>
        <translation>Projeter ce sommet sur l’axe des x</translation>
    </message>
    <message>
        <source>Snap to the &amp;y Axis</source>
        <translation>Accrocher à l’axe des &amp;y</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the y axis</source>
        <translation>Projeter ce sommet sur l’axe des y</translation>
    </message>
    <message>
        <source>&amp;Delete This Vertex</source>
        <translation>&amp;Supprimer ce sommet</translation>
    </message>
    <message>
        <source>Takes this vertex out of the cage</source>
        <translation>Retirer ce sommet de la cage</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>Placer le &amp;pivot ici</translation>
    </message>
    <message>
        <source>Turns and scales the cage about this vertex</source>
        <translation>Faire tourner et redimensionner la cage autour de ce sommet</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>&amp;Insert a Vertex Here</source>
        <translation>&amp;Insérer un sommet ici</translation>
    </message>
    <message>
        <source>Puts one more vertex on this edge; a double click does the same</source>
        <translation>Mettre un sommet de plus sur cette arête&#x202f;; un double-clic fait de même</translation>
    </message>
    <message>
        <source>Rotate: Shift turns in steps of 15°</source>
        <translation>Rotation&#x202f;: Maj tourne par pas de 15°</translation>
    </message>
    <message>
        <source>Scale: Shift keeps to x or y</source>
        <translation>Échelle&#x202f;: Maj s’en tient à x ou à y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Middle</source>
        <translation>Placer le &amp;pivot au milieu</translation>
    </message>
    <message>
        <source>Turns and scales the cage about its middle</source>
        <translation>Faire tourner et redimensionner la cage autour de son milieu</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Ajuster le simplexe canonique &amp;minimal</translation>
    </message>
    <message>
        <source>Holds the picture by the smallest right-angled triangle around it</source>
        <translation>Tenir l’image par le plus petit triangle rectangle isocèle qui la contient</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Définir un triangle</translation>
    </message>
    <message>
        <source>Holds the picture by three points that are clicked</source>
        <translation>Tenir l’image par trois points choisis d’un clic</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>&amp;Réinitialiser la cage</translation>
    </message>
    <message>
        <source>Puts every vertex back to rest</source>
        <translation>Remettre tous les sommets au repos</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Rendre régu&amp;lière</translation>
    </message>
    <message>
        <source>Puts the vertices on the regular polygon nearest to them</source>
        <translation>Mettre les sommets sur le polygone régulier le plus proche</translation>
    </message>
    <message>
        <source>&amp;Bake Placement into the Code</source>
        <translation>In&amp;tégrer le placement au code</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw what is shown, with the cage at rest</source>
        <translation>Réécrire les applications pour qu’elles dessinent ce qui est montré, la cage étant au repos</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>&amp;Fit	F</source>
        <translation>A&amp;juster à la vue	F</translation>
    </message>
    <message>
        <source>Shows the whole picture and its cage</source>
        <translation>Montrer l’image entière et sa cage</translation>
    </message>
    <message>
        <source>&amp;100 %	1</source>
        <translation>&amp;100&#x202f;%	1</translation>
    </message>
    <message>
        <source>Shows one unit of the plane as a hundred pixels</source>
        <translation>Afficher une unité du plan sur cent pixels</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Grille</translation>
    </message>
    <message>
        <source>Shows or hides the grid</source>
        <translation>Afficher ou masquer la grille</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Axes</translation>
    </message>
    <message>
        <source>Shows or hides the axes and their numbers</source>
        <translation>Afficher ou masquer les axes et leurs nombres</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>Axe des &amp;y vers le bas</translation>
    </message>
    <message>
        <source>Turns the plane over, as on the screen of a computer</source>
        <translation>Retourner le plan, comme sur l’écran d’un ordinateur</translation>
    </message>
    <message>
        <source>&amp;Only the Picture	H</source>
        <translation>&amp;Image seule	H</translation>
    </message>
    <message>
        <source>Hides the cage, the grid and the axes</source>
        <translation>Masquer la cage, la grille et les axes</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>&amp;Copier l’image</translation>
    </message>
    <message>
        <source>Copies the picture as it is seen, without the cage</source>
        <translation>Copier l’image telle qu’on la voit, sans la cage</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Zone de dessin</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>&amp;Switch On</source>
        <translation>&amp;Activer</translation>
    </message>
    <message>
        <source>&amp;Switch Off</source>
        <translation>&amp;Désactiver</translation>
    </message>
    <message>
        <source>Lets this map take part, or not</source>
        <translation>Faire participer cette application, ou non</translation>
    </message>
    <message>
        <source>Switch on map %1</source>
        <translation>Activer l’application %1</translation>
    </message>
    <message>
        <source>Switch off map %1</source>
        <translation>Désactiver l’application %1</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>D&amp;upliquer</translation>
    </message>
    <message>
        <source>Puts a copy of this map beside it</source>
        <translation>Met une copie de cette application à côté</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Takes this map out of the system</source>
        <translation>Retire cette application du système</translation>
    </message>
</context>
<context>
    <name>view::CanvasScene</name>
    <message>
        <source>Vertex %1</source>
        <translation>Sommet %1</translation>
    </message>
    <message>
        <source>Edge from vertex %1</source>
        <translation>Arête partant du sommet %1</translation>
    </message>
    <message>
        <source>The whole cage</source>
        <translation>La cage entière</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <source>Rotate handle</source>
        <translation>Poignée de rotation</translation>
    </message>
    <message>
        <source>Scale handle</source>
        <translation>Poignée d’échelle</translation>
    </message>
    <message>
        <source>the arrow keys move both its ends</source>
        <translation>les touches fléchées déplacent ses deux extrémités</translation>
    </message>
    <message>
        <source>the arrow keys move it</source>
        <translation>les touches fléchées déplacent l’élément</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Branche %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, coin %2</translation>
    </message>
    <message>
        <source>the arrow keys turn by one degree</source>
        <translation>les flèches tournent d’un degré</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>les flèches changent l’échelle d’un pour cent</translation>
    </message>
    <message>
        <source>Drag the pivot: turning and scaling are about it.</source>
        <translation>Tirez le pivot : rotation et mise à l’échelle se font autour de lui.</translation>
    </message>
    <message>
        <source>Drag to turn about the pivot; Shift: in steps of 15°.</source>
        <translation>Tirez pour tourner autour du pivot ; Maj : par pas de 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; Shift: along x or y only.</source>
        <translation>Tirez pour mettre à l’échelle autour du pivot ; Maj : selon x ou y seulement.</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Zone de dessin</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab goes from handle to handle, the arrow keys move the one in focus, F6 leaves the canvas.</source>
        <translation>L’attracteur et sa cage de contrôle. Tab passe d’une poignée à l’autre, les touches fléchées déplacent celle qui a le focus, F6 quitte la zone de dessin.</translation>
    </message>
    <message>
        <source>Define triangle</source>
        <translation>Définir un triangle</translation>
    </message>
    <message>
        <source>The cage is flat, so new vertices cannot be related to the picture.</source>
        <translation>La cage est plate&#x202f;: de nouveaux sommets ne peuvent pas être rapportés à l’image.</translation>
    </message>
    <message>
        <source>Put the cage back to rest first?</source>
        <translation>Remettre d’abord la cage au repos&#x202f;?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Réinitialiser la cage</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press H to see the cage again.</source>
        <translation>Seule l’image est affichée. Appuyez sur H pour revoir la cage.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; Ctrl turns, Alt scales, Shift keeps directions. The wheel zooms at the pointer, the middle button moves the plane. Tab goes from handle to handle, arrow keys move them, F6 leaves.</source>
        <translation>L’image et sa cage. Tirez un sommet, une arête ou l’intérieur de la cage&#x202f;; Ctrl fait tourner, Alt redimensionne, Maj garde les directions. La molette zoome sur le pointeur, le bouton du milieu déplace le plan. Tab passe d’une poignée à l’autre, les touches fléchées les déplacent, F6 quitte la zone.</translation>
    </message>
</context>
<context>
    <name>view::Clipboard</name>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>collage</translation>
    </message>
</context>
<context>
    <name>view::CollectionModel</name>
    <message>
        <source>Theme: %1</source>
        <translation>Thème&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1, from %2, a favourite</source>
        <translation>%1, de %2, en favori</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, de %2</translation>
    </message>
</context>
<context>
    <name>view::CollectionPanel</name>
    <message>
        <source>Collection</source>
        <translation>Collection</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Rechercher dans la collection</translation>
    </message>
    <message>
        <source>Show only fractals whose name, title, theme or source contains these words.</source>
        <translation>N’afficher que les fractales dont le nom, le titre, le thème ou la source contient ces mots.</translation>
    </message>
    <message>
        <source>Fractals of the collection</source>
        <translation>Fractales de la collection</translation>
    </message>
    <message>
        <source>No favourites yet. Choose a fractal and press Ctrl+D.</source>
        <translation>Pas encore de favoris. Choisissez une fractale et appuyez sur Ctrl+D.</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Rien ici ne contient ces mots.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Open the chosen fractal as a document of its own.</source>
        <translation>Ouvrir la fractale choisie dans un document à part.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>&amp;Ajouter à ce fichier</translation>
    </message>
    <message>
        <source>Add the chosen fractal to the open file.</source>
        <translation>Ajouter la fractale choisie au fichier ouvert.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>&amp;Favori</translation>
    </message>
    <message>
        <source>Mark the chosen fractal as one of your favourites.</source>
        <translation>Mettre la fractale choisie dans vos favoris.</translation>
    </message>
    <message>
        <source>Only Fa&amp;vourites</source>
        <translation>Fa&amp;voris seulement</translation>
    </message>
    <message>
        <source>Show nothing but your favourites.</source>
        <translation>N’afficher que vos favoris.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>Ajouter un &amp;dossier…</translation>
    </message>
    <message>
        <source>Show the .ifs files of a folder of yours here, too.</source>
        <translation>Afficher ici aussi les fichiers .ifs d’un dossier à vous.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>&amp;Retirer le dossier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Show this folder here no more. Its files stay as they are.</source>
        <translation>Ne plus afficher ce dossier ici. Ses fichiers restent tels quels.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Dossier de fichiers .ifs</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment has these words. Enter opens the first of them.</source>
        <translation>N’affiche que les fractales dont le nom, le thème ou le commentaire contient ces mots. Entrée ouvre la première.</translation>
    </message>
    <message>
        <source>Fractals to begin with. Double-click or Enter opens one in this window; the menu of the right button adds it to the file instead.</source>
        <translation>Des fractales pour commencer. Un double-clic ou Entrée en ouvre une dans cette fenêtre&#x202f;; le menu du bouton droit permet plutôt de l’ajouter au fichier.</translation>
    </message>
    <message>
        <source>Files of the collection that were read</source>
        <translation>Fichiers de la collection déjà lus</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Arrêter la lecture</translation>
    </message>
    <message>
        <source>Stop reading this folder. What was read so far stays here.</source>
        <translation>Arrêter la lecture de ce dossier. Ce qui a été lu reste ici.</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Lecture de la collection…</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
</context>
<context>
    <name>view::ColourButton</name>
    <message>
        <source>transparent</source>
        <translation>transparent</translation>
    </message>
    <message>
        <source>%1, %2 % opaque</source>
        <translation>%1, opaque à %2&#x202f;%</translation>
    </message>
    <message>
        <source>Click to choose another colour.</source>
        <translation>Cliquez pour choisir une autre couleur.</translation>
    </message>
</context>
<context>
    <name>view::ColumnOrders</name>
    <message>
        <source>a b c d e f p: Fractint, Barnsley</source>
        <translation>a b c d e f p&#x202f;: Fractint, Barnsley</translation>
    </message>
    <message>
        <source>a b e c d f p: each equation in a row</source>
        <translation>a b e c d f p&#x202f;: chaque équation sur une ligne</translation>
    </message>
    <message>
        <source>a c b d e f p: column by column</source>
        <translation>a c b d e f p&#x202f;: colonne par colonne</translation>
    </message>
    <message>
        <source>p a b c d e f: the weight first</source>
        <translation>p a b c d e f&#x202f;: le poids en premier</translation>
    </message>
    <message>
        <source>r s theta phi e f p: scales, and angles in degrees</source>
        <translation>r s theta phi e f p&#x202f;: facteurs d’échelle, et angles en degrés</translation>
    </message>
    <message>
        <source>a b c d e f, and weights that add up row by row</source>
        <translation>a b c d e f, et des poids qui se cumulent ligne par ligne</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Autre…</translation>
    </message>
    <message>
        <source>Order of the columns</source>
        <translation>Ordre des colonnes</translation>
    </message>
    <message>
        <source>Names of the columns in their order</source>
        <translation>Noms des colonnes dans leur ordre</translation>
    </message>
    <message>
        <source>The names of the columns in their order: a b c d or r s theta phi, then e and f, each once, and p for a weight or cumulative for a sum of weights where there is one. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Les noms des colonnes dans leur ordre&#x202f;: a b c d ou r s theta phi, puis e et f, chacun une fois, et p pour un poids ou cumulative pour une somme de poids s’il y en a. x′ = a·x + b·y + e et y′ = c·x + d·y + f.</translation>
    </message>
</context>
<context>
    <name>view::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Palette de commandes</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Tapez ce que vous voulez faire</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Commandes correspondantes</translation>
    </message>
    <message>
        <source>Type some letters of what you want to do. Arrow keys choose, Enter does it.</source>
        <translation>Tapez quelques lettres de ce que vous voulez faire. Les touches fléchées choisissent, Entrée exécute.</translation>
    </message>
    <message>
        <source>The commands whose names have these letters.</source>
        <translation>Les commandes dont le nom contient ces lettres.</translation>
    </message>
    <message>
        <source>No command is called that.</source>
        <translation>Aucune commande ne s’appelle ainsi.</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three vertices. The picture stays where it is; Esc leaves.</source>
        <translation>Cliquez sur le premier des trois sommets. L’image reste où elle est&#x202f;; Échap abandonne.</translation>
    </message>
    <message>
        <source>Click the second vertex. Backspace takes the first one back.</source>
        <translation>Cliquez sur le deuxième sommet. Retour arrière annule le premier.</translation>
    </message>
    <message>
        <source>Click the third vertex. Backspace takes the second one back.</source>
        <translation>Cliquez sur le troisième sommet. Retour arrière annule le deuxième.</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Commentaire de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Comment behind the name</source>
        <translation>Commentaire à la suite du nom</translation>
    </message>
    <message>
        <source>Written on the first line of the entry, for example its title or author.</source>
        <translation>Écrit sur la première ligne de l’entrée&#x202f;: son titre ou son auteur, par exemple.</translation>
    </message>
    <message>
        <source>Comment lines</source>
        <translation>Lignes de commentaire</translation>
    </message>
    <message>
        <source>Written as lines of their own below the name, each behind a semicolon.</source>
        <translation>Écrites sur des lignes à part sous le nom, chacune après un point-virgule.</translation>
    </message>
    <message>
        <source>Reason why the comment cannot be kept</source>
        <translation>Raison pour laquelle le commentaire ne peut pas être conservé</translation>
    </message>
    <message>
        <source>Keep or discard the comment</source>
        <translation>Conserver ou abandonner le commentaire</translation>
    </message>
    <message>
        <source>&amp;Behind the name:</source>
        <translation>À la &amp;suite du nom&#x202f;:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Lignes de commentaire&#x202f;:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines keep the cage and the colours.</source>
        <translation>Un commentaire ne peut pas commencer par «&#x202f;barycage:&#x202f;»&#x202f;; ces lignes conservent la cage et les couleurs.</translation>
    </message>
    <message>
        <source>A line holds at most %1 bytes; Fractint cuts longer ones. Break it in two.</source>
        <translation>Une ligne compte au plus %1 octets&#x202f;; Fractint coupe les plus longues. Coupez-la en deux.</translation>
    </message>
</context>
<context>
    <name>view::EntriesDelegate</name>
    <message>
        <source>Name of the entry</source>
        <translation>Nom de l’entrée</translation>
    </message>
</context>
<context>
    <name>view::EntriesEdits</name>
    <message>
        <source>An entry needs a name.</source>
        <translation>Une entrée a besoin d’un nom.</translation>
    </message>
    <message>
        <source>A name holds no blanks: Fractint would read its first word only.</source>
        <translation>Un nom ne contient pas d’espaces&#x202f;: Fractint n’en lirait que le premier mot.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas figurer dans un nom, car il a un sens particulier dans les fichiers .ifs.</translation>
    </message>
    <message>
        <source>A name has at most %1 characters; Fractint ignores the rest.</source>
        <translation>Un nom a au plus %1 caractères&#x202f;; Fractint ignore le reste.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint ne liste pas une entrée nommée «&#x202f;%1&#x202f;»&#x202f;; choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case count as equal).</source>
        <translation>Une autre entrée se nomme «&#x202f;%1&#x202f;» (majuscules et minuscules ne sont pas distinguées).</translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer «&#x202f;%1&#x202f;» en «&#x202f;%2&#x202f;»</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D&#x202f;: pas encore affiché</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>n’a pas pu être lue</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 application</translation>
    </message>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n application</numerusform>
            <numerusform>%n applications</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, no attractor</source>
        <translation>%1, pas d’attracteur</translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation>Ligne %1, colonne %2&#x202f;: </translation>
    </message>
    <message>
        <source>modified</source>
        <translation>modifiée</translation>
    </message>
    <message>
        <source>has errors</source>
        <translation>contient des erreurs</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>donne lieu à des avertissements</translation>
    </message>
</context>
<context>
    <name>view::EntriesPanel</name>
    <message>
        <source>Entries of the file</source>
        <translation>Entrées du fichier</translation>
    </message>
    <message>
        <source>Filter entries by name</source>
        <translation>Filtrer les entrées par nom</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Filtrer par nom</translation>
    </message>
    <message>
        <source>Show only the entries whose name contains this text.</source>
        <translation>N’afficher que les entrées dont le nom contient ce texte.</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Entrées</translation>
    </message>
    <message>
        <source>This file holds no entries. Add one, or paste the text of an .ifs file.</source>
        <translation>Ce fichier ne contient aucune entrée. Ajoutez-en une, ou collez le texte d’un fichier .ifs.</translation>
    </message>
    <message>
        <source>&amp;Add Entry</source>
        <translation>&amp;Ajouter une entrée</translation>
    </message>
    <message>
        <source>Add a Sierpiński triangle as a new entry.</source>
        <translation>Ajouter un triangle de Sierpiński comme nouvelle entrée.</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Add a copy of each selected entry.</source>
        <translation>Ajouter une copie de chaque entrée sélectionnée.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected entries from the file.</source>
        <translation>Supprimer du fichier les entrées sélectionnées.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>Give the entry another name.</source>
        <translation>Donner un autre nom à l’entrée.</translation>
    </message>
    <message>
        <source>Edit &amp;Comment…</source>
        <translation>Modifier le co&amp;mmentaire…</translation>
    </message>
    <message>
        <source>Edit the comment of the entry.</source>
        <translation>Modifier le commentaire de l’entrée.</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Mon&amp;ter</translation>
    </message>
    <message>
        <source>Move the selected entries towards the top of the file.</source>
        <translation>Déplacer les entrées sélectionnées vers le début du fichier.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>D&amp;escendre</translation>
    </message>
    <message>
        <source>Move the selected entries towards the end of the file.</source>
        <translation>Déplacer les entrées sélectionnées vers la fin du fichier.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy the selected entries as .ifs text.</source>
        <translation>Copier les entrées sélectionnées comme texte .ifs.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Paste the entries of .ifs text behind the current entry.</source>
        <translation>Coller les entrées d’un texte .ifs après l’entrée courante.</translation>
    </message>
    <message>
        <source>Add an entry</source>
        <translation>Ajouter une entrée</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n entries</source>
        <translation>
            <numerusform>Supprimer %n entrée</numerusform>
            <numerusform>Supprimer %n entrées</numerusform>
        </translation>
    </message>
    <message>
        <source>An entry that could not be read cannot be duplicated: it would keep its name.</source>
        <translation>Une entrée qui n’a pas pu être lue ne peut pas être dupliquée&#x202f;: sa copie garderait le même nom.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Dupliquer %1</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n entries</source>
        <translation>
            <numerusform>Dupliquer %n entrée</numerusform>
            <numerusform>Dupliquer %n entrées</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit the comment of %1</source>
        <translation>Modifier le commentaire de %1</translation>
    </message>
    <message>
        <source>There is no entry of an .ifs file in what was pasted.</source>
        <translation>Ce qui a été collé ne contient aucune entrée de fichier .ifs.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Coller %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n entries</source>
        <translation>
            <numerusform>Coller %n entrée</numerusform>
            <numerusform>Coller %n entrées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pasted entries could not be read; their text is kept as it is.</source>
        <translation>
            <numerusform>%n entrée collée n’a pas pu être lue&#x202f;; son texte est conservé tel quel.</numerusform>
            <numerusform>%n entrées collées n’ont pas pu être lues&#x202f;; leur texte est conservé tel quel.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n entries</source>
        <translation>
            <numerusform>Déplacer %n entrée</numerusform>
            <numerusform>Déplacer %n entrées</numerusform>
        </translation>
    </message>
    <message>
        <source>No entry has “%1” in its name.</source>
        <translation>Aucune entrée n’a «&#x202f;%1&#x202f;» dans son nom.</translation>
    </message>
    <message>
        <source>Shows only the entries whose name has these letters.</source>
        <translation>N’affiche que les entrées dont le nom contient ces lettres.</translation>
    </message>
    <message>
        <source>The fractals of the file. Click one to edit it, drag it to another place, press F2 to give it another name.</source>
        <translation>Les fractales du fichier. Cliquez sur l’une d’elles pour la modifier, faites-la glisser pour la changer de place, appuyez sur F2 pour la renommer.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>Rien n’a été collé : il n’y a pas de texte dans le presse-papiers.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Lecture de ce qui a été collé…</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Ajout des entrées…</translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Exporter les données de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>What the file will hold</source>
        <translation>Ce que contiendra le fichier</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progression de l’exportation</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>Copier le &amp;texte</translation>
    </message>
    <message>
        <source>Flame: flam3, Apophysis, JWildfire, Fractorium</source>
        <translation>Flamme&#x202f;: flam3, Apophysis, JWildfire, Fractorium</translation>
    </message>
    <message>
        <source>IFStile (.aifs)</source>
        <translation>IFStile (.aifs)</translation>
    </message>
    <message>
        <source>Table with commas (.csv)</source>
        <translation>Tableau avec virgules (.csv)</translation>
    </message>
    <message>
        <source>Table with tabs (.tsv)</source>
        <translation>Tableau avec tabulations (.tsv)</translation>
    </message>
    <message>
        <source>Points (.csv)</source>
        <translation>Points (.csv)</translation>
    </message>
    <message>
        <source>Points, coloured (.ply)</source>
        <translation>Points en couleurs (.ply)</translation>
    </message>
    <message>
        <source>&amp;Turn y around, so that the flame is the same way up</source>
        <translation>&amp;Retourner y, pour que la flamme soit dans le même sens</translation>
    </message>
    <message>
        <source>&amp;Bake the placement, so that the maps draw what is shown</source>
        <translation>&amp;Intégrer le placement, pour que les applications dessinent ce qui est montré</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Colonnes&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>&amp;Points&#x202f;:</translation>
    </message>
    <message>
        <source>Only the numbers of plane systems can be exported.</source>
        <translation>Seuls les nombres des systèmes du plan peuvent être exportés.</translation>
    </message>
    <message>
        <source>The points of the chaos game where they are shown, without the first 14.</source>
        <translation>Les points du jeu du chaos là où ils sont affichés, sans les 14 premiers.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Fichiers %1 (*.%2)</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Exporter les données</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>The text is on the clipboard.</source>
        <translation>Le texte est dans le presse-papiers.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Fer&amp;mer</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>L’exportation a été arrêtée&#x202f;; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>Le début du fichier tel qu’il sera écrit.</translation>
    </message>
    <message>
        <source>For which program the data are: each format has what that program reads.</source>
        <translation>Le programme auquel les données sont destinées&#x202f;: chaque format contient ce que ce programme lit.</translation>
    </message>
    <message>
        <source>The order in which each row has its coefficients; other programs expect other orders.</source>
        <translation>L’ordre des coefficients dans chaque ligne&#x202f;; d’autres programmes attendent d’autres ordres.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Combien de points du jeu du chaos sont écrits.</translation>
    </message>
    <message>
        <source>Flame programs let y grow downwards. With this the flame looks as the fractal does here; without it the numbers are the same.</source>
        <translation>Les programmes de flammes font croître y vers le bas. Avec cette option, la flamme a la même allure que la fractale ici&#x202f;; sans elle, les nombres sont les mêmes.</translation>
    </message>
    <message>
        <source>With this, the cage is made part of the maps. Without it, the maps are written as they stand in the table.</source>
        <translation>Avec cette option, la cage est intégrée aux applications. Sans elle, les applications sont écrites telles qu’elles figurent dans le tableau.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it.</source>
        <translation>Demande le nom du fichier et l’écrit.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Copie le texte entier dans le presse-papiers au lieu d’écrire un fichier.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exporter «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>PNG: pixels</source>
        <translation>PNG&#x202f;: pixels</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG&#x202f;: formes pour logiciels de dessin</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF&#x202f;: formes pour l’impression</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>Fond &amp;transparent</translation>
    </message>
    <message>
        <source>Include the &amp;control triangle</source>
        <translation>&amp;Inclure le triangle de contrôle</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format&#x202f;:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Taille&#x202f;:</translation>
    </message>
    <message>
        <source>Draft: 25 samples a pixel</source>
        <translation>Brouillon&#x202f;: 25 échantillons par pixel</translation>
    </message>
    <message>
        <source>Good: 100 samples a pixel</source>
        <translation>Bonne&#x202f;: 100 échantillons par pixel</translation>
    </message>
    <message>
        <source>Fine: 400 samples a pixel</source>
        <translation>Fine&#x202f;: 400 échantillons par pixel</translation>
    </message>
    <message>
        <source>Finest: 2000 samples a pixel</source>
        <translation>Maximale&#x202f;: 2000 échantillons par pixel</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Cells along the side of a pixel</source>
        <translation>Cellules le long du côté d’un pixel</translation>
    </message>
    <message>
        <source>8 bits a channel</source>
        <translation>8 bits par canal</translation>
    </message>
    <message>
        <source>16 bits a channel, for further work on the picture</source>
        <translation>16 bits par canal, pour retravailler l’image</translation>
    </message>
    <message>
        <source>Colour depth</source>
        <translation>Profondeur de couleur</translation>
    </message>
    <message>
        <source>Memory needed</source>
        <translation>Mémoire nécessaire</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Qualité&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Supersampling:</source>
        <translation>&amp;Suréchantillonnage&#x202f;:</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>Profondeur de &amp;couleur&#x202f;:</translation>
    </message>
    <message>
        <source>Memory:</source>
        <translation>Mémoire&#x202f;:</translation>
    </message>
    <message>
        <source>Copies of copies: a small file</source>
        <translation>Copies de copies&#x202f;: un petit fichier</translation>
    </message>
    <message>
        <source>Outline, for cutters and plotters</source>
        <translation>Contour, pour machines de découpe et traceurs</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Kind of shapes</source>
        <translation>Type de formes</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Nombre de points</translation>
    </message>
    <message>
        <source>As deep as a pixel &amp;needs</source>
        <translation>Aussi profond que &amp;le demande un pixel</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Niveaux de copies</translation>
    </message>
    <message>
        <source>What the picture will be like</source>
        <translation>Ce que sera l’image</translation>
    </message>
    <message>
        <source>S&amp;hapes:</source>
        <translation>F&amp;ormes&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>&amp;Points&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Depth:</source>
        <translation>Profon&amp;deur&#x202f;:</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progression de l’exportation</translation>
    </message>
    <message>
        <source>Only plane systems can be exported as a picture.</source>
        <translation>Seuls les systèmes du plan peuvent être exportés comme image.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>One dot for every point of the chaos game that is in view.</source>
        <translation>Un point dessiné pour chaque point visible du jeu du chaos.</translation>
    </message>
    <message>
        <source> The cage bends the picture, which copies cannot follow: the affine fit of the cage is written. A PNG shows the bend.</source>
        <translation> La cage courbe l’image, ce que des copies ne peuvent pas suivre&#x202f;: c’est l’ajustement affine de la cage qui est écrit. Un PNG montre l’image courbée.</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documents PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Scalable pictures (*.svg)</source>
        <translation>Images vectorielles (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>L’exportation a été arrêtée&#x202f;; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Fer&amp;mer</translation>
    </message>
    <message>
        <source>PNG is a picture of pixels; SVG and PDF are made of shapes, which stay sharp at every size.</source>
        <translation>Une image PNG est faite de pixels&#x202f;; SVG et PDF sont faits de formes, qui restent nettes à toutes les tailles.</translation>
    </message>
    <message>
        <source>The picture has no background and can be laid over another.</source>
        <translation>L’image n’a pas de fond et peut être superposée à une autre.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Dessine la cage par-dessus l’image.</translation>
    </message>
    <message>
        <source>How many points are drawn for each pixel: more make a smoother picture and take longer.</source>
        <translation>Combien de points sont dessinés par pixel&#x202f;: davantage de points donnent une image plus lisse et prennent plus de temps.</translation>
    </message>
    <message>
        <source>Every pixel is drawn from so many finer ones along its side: smoother edges, for more memory and time.</source>
        <translation>Chaque pixel est dessiné à partir d’autant de pixels plus fins le long de son côté&#x202f;: des bords plus lisses, pour plus de mémoire et de temps.</translation>
    </message>
    <message>
        <source>16 bits keep fine steps of brightness for later work in a picture editor; 8 bits are enough to look at.</source>
        <translation>16 bits conservent les fines nuances de luminosité pour un travail ultérieur dans un éditeur d’images&#x202f;; 8 bits suffisent pour regarder.</translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation>Les copies de copies donnent un petit fichier que les logiciels de dessin savent modifier&#x202f;; le contour est un seul tracé&#x202f;; les points sont ceux du jeu du chaos.</translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation>Combien de points du jeu du chaos sont dessinés.</translation>
    </message>
    <message>
        <source>How many levels of copies the picture has. The file hardly grows with it, the time to draw it does.</source>
        <translation>Combien de niveaux de copies a l’image. Le fichier n’en grossit guère, mais la durée du dessin, elle, augmente.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it. The window can be used meanwhile.</source>
        <translation>Demande le nom du fichier et l’écrit. La fenêtre reste utilisable pendant ce temps.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Copie de l’image…</translation>
    </message>
    <message>
        <source>Copies are made smaller until no pixel of this size could tell the difference, or programs would take long to draw them.</source>
        <translation>Les copies sont réduites jusqu’à ce qu’aucun pixel de cette taille ne puisse montrer la différence, ou que les logiciels mettent longtemps à les dessiner.</translation>
    </message>
    <message>
        <source>%1 references (fewer than %3 are allowed). Nothing that is drawn is farther than %2 pixels from the attractor, and nothing of it is farther from what is drawn.</source>
        <translation>%1 références (moins de %3 sont permises). Rien de ce qui est dessiné n’est à plus de %2 pixels de l’attracteur, et rien de celui-ci n’est plus loin de ce qui est dessiné.</translation>
    </message>
    <message>
        <source> A pixel needs more: this is as deep as programs draw without a long wait.</source>
        <translation> Un pixel en demande plus&#x202f;: c’est la plus grande profondeur que les logiciels dessinent sans longue attente.</translation>
    </message>
    <message>
        <source>Working out the shapes…</source>
        <translation>Calcul des formes…</translation>
    </message>
</context>
<context>
    <name>view::ExportSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixels</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pouces</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Unité de longueur</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Comme à l’écran</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × l’écran</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Taille au choix</translation>
    </message>
    <message>
        <source>Size relative to the screen</source>
        <translation>Taille par rapport à l’écran</translation>
    </message>
    <message>
        <source>Keep shape</source>
        <translation>Garder les proportions</translation>
    </message>
    <message>
        <source>Keep the shape of the picture on the screen</source>
        <translation>Garder les proportions de l’image à l’écran</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> ppp</translation>
    </message>
    <message>
        <source>Resolution in dots per inch</source>
        <translation>Résolution en points par pouce</translation>
    </message>
    <message>
        <source>A length in the unit chosen beside it. The other side follows while the shape is kept.</source>
        <translation>Une longueur dans l’unité choisie à côté. L’autre côté suit tant que les proportions sont gardées.</translation>
    </message>
    <message>
        <source>In pixels, or on paper at the resolution given.</source>
        <translation>En pixels, ou sur papier à la résolution indiquée.</translation>
    </message>
    <message>
        <source>The picture as on the screen or some times as large.</source>
        <translation>L’image comme à l’écran, ou plusieurs fois plus grande.</translation>
    </message>
    <message>
        <source>How many pixels go on an inch of paper: 300 is usual in print.</source>
        <translation>Combien de pixels tiennent sur un pouce de papier&#x202f;: 300 est l’usage en imprimerie.</translation>
    </message>
</context>
<context>
    <name>view::GradientChooser</name>
    <message>
        <source>of this fractal</source>
        <translation>de cette fractale</translation>
    </message>
    <message>
        <source>%1 (of this fractal)</source>
        <translation>%1 (de cette fractale)</translation>
    </message>
</context>
<context>
    <name>view::GradientEditor</name>
    <message>
        <source>Palette editor</source>
        <translation>Éditeur de palette</translation>
    </message>
    <message>
        <source>Colour of the stop</source>
        <translation>Couleur du repère</translation>
    </message>
    <message>
        <source>Position of the stop</source>
        <translation>Position du repère</translation>
    </message>
    <message>
        <source>Position of the stop, from 0 to 1</source>
        <translation>Position du repère, de 0 à 1</translation>
    </message>
    <message>
        <source>Add Stop</source>
        <translation>Ajouter un repère</translation>
    </message>
    <message>
        <source>Add a stop after the chosen one</source>
        <translation>Ajouter un repère après celui qui est choisi</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Supprimer le repère</translation>
    </message>
    <message>
        <source>Delete the chosen stop</source>
        <translation>Supprimer le repère choisi</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Turn the palette round</source>
        <translation>Retourner la palette</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Répartir</translation>
    </message>
    <message>
        <source>Put the stops at equal distances</source>
        <translation>Mettre les repères à distances égales</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Charger…</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ugr or .map file</source>
        <translation>Charger une palette depuis un fichier .gpl, .ugr ou .map</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Save the palette as a .gpl file</source>
        <translation>Enregistrer la palette dans un fichier .gpl</translation>
    </message>
    <message>
        <source>Change a colour of the palette</source>
        <translation>Changer une couleur de la palette</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Déplacer un repère de la palette</translation>
    </message>
    <message>
        <source>Save Palette</source>
        <translation>Enregistrer la palette</translation>
    </message>
    <message>
        <source>palette</source>
        <translation>palette</translation>
    </message>
    <message>
        <source>GIMP palettes (*.gpl)</source>
        <translation>Palettes GIMP (*.gpl)</translation>
    </message>
    <message>
        <source>Reverse the palette</source>
        <translation>Inverser la palette</translation>
    </message>
    <message>
        <source>Distribute the stops of the palette</source>
        <translation>Répartir les repères de la palette</translation>
    </message>
    <message>
        <source>Load Palette</source>
        <translation>Charger une palette</translation>
    </message>
    <message>
        <source>Palettes (*.gpl *.ugr *.gradient *.map);;All files (*)</source>
        <translation>Palettes (*.gpl *.ugr *.gradient *.map);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, ligne %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Load the palette %1</source>
        <translation>Charger la palette %1</translation>
    </message>
    <message>
        <source>Palettes of the file</source>
        <translation>Palettes du fichier</translation>
    </message>
    <message>
        <source>Load a palette</source>
        <translation>Charger une palette</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 est enregistré.</translation>
    </message>
    <message>
        <source>The palettes that the file holds. Choose one.</source>
        <translation>Les palettes que contient le fichier. Choisissez-en une.</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Repères du dégradé</translation>
    </message>
    <message>
        <source>Double-click: new stop, or the colour of one. Drag: move. Del: delete it.
Keys: Page Up and Page Down choose a stop, the arrows move it, Ins adds one, Enter opens its colour.</source>
        <translation>Double-clic&#x202f;: nouveau repère, ou couleur d’un repère. Glisser&#x202f;: déplacer. Suppr&#x202f;: supprimer.
Clavier&#x202f;: Page préc. et Page suiv. choisissent un repère, les flèches le déplacent, Inser en ajoute un, Entrée ouvre sa couleur.</translation>
    </message>
    <message>
        <source>Stop %1 of %2 at %3 %, %4</source>
        <translation>Repère %1 sur %2 à %3&#x202f;%, %4</translation>
    </message>
    <message>
        <source>Add a stop to the palette</source>
        <translation>Ajouter un repère à la palette</translation>
    </message>
    <message>
        <source>Delete a stop of the palette</source>
        <translation>Supprimer un repère de la palette</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Déplacer un repère de la palette</translation>
    </message>
</context>
<context>
    <name>view::Guide</name>
    <message>
        <source>User Guide</source>
        <translation>Guide d’utilisation</translation>
    </message>
    <message>
        <source>The user guide: what can be done here, in the order in which one needs it.</source>
        <translation>Le guide d’utilisation&#x202f;: ce que l’on peut faire ici, dans l’ordre où l’on en a besoin.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Chercher dans le guide</translation>
    </message>
    <message>
        <source>Marks these words in the guide. Enter shows the next place, Shift+Enter the one before. Ctrl+F leads here.</source>
        <translation>Marque ces mots dans le guide. Entrée montre le passage suivant, Maj+Entrée le précédent. Ctrl+F mène ici.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Introuvable</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>view::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Étapes de l’historique</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward.</source>
        <translation>Choisissez une étape pour y revenir ou pour y avancer.</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward. The disk marks what is saved.</source>
        <translation>Choisissez une étape pour y revenir ou pour y avancer. La disquette marque ce qui est enregistré.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>État à l’ouverture</translation>
    </message>
</context>
<context>
    <name>view::MapShapeEditor</name>
    <message>
        <source>Rotation °</source>
        <translation>Rotation °</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise with y up</source>
        <translation>Angle en degrés, dans le sens direct quand y est vers le haut</translation>
    </message>
    <message>
        <source>Scale x</source>
        <translation>Échelle x</translation>
    </message>
    <message>
        <source>Length of the image of the x unit vector</source>
        <translation>Longueur de l’image du vecteur unité de l’axe des x</translation>
    </message>
    <message>
        <source>Scale y</source>
        <translation>Échelle y</translation>
    </message>
    <message>
        <source>Scale across; negative when the map reflects</source>
        <translation>Échelle en travers&#x202f;; négative quand l’application renverse l’orientation</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <source>Shear along x, applied before everything else</source>
        <translation>Cisaillement selon x, appliqué avant tout le reste</translation>
    </message>
    <message>
        <source>Shift x</source>
        <translation>Translation x</translation>
    </message>
    <message>
        <source>Translation e, applied last</source>
        <translation>Translation e, appliquée en dernier</translation>
    </message>
    <message>
        <source>Shift y</source>
        <translation>Translation y</translation>
    </message>
    <message>
        <source>Translation f, applied last</source>
        <translation>Translation f, appliquée en dernier</translation>
    </message>
    <message>
        <source>No map is selected</source>
        <translation>Aucune application n’est sélectionnée</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>Change the shape of map %1</source>
        <translation>Modifier la forme de l’application %1</translation>
    </message>
</context>
<context>
    <name>view::MapsDelegate</name>
    <message>
        <source>%1 of map %2</source>
        <translation>%1 de l’application %2</translation>
    </message>
    <message>
        <source>%1 The cell keeps its value.</source>
        <translation>%1 La cellule garde sa valeur.</translation>
    </message>
</context>
<context>
    <name>view::MapsModel</name>
    <message>
        <source>similarity</source>
        <translation>similitude</translation>
    </message>
    <message>
        <source>reflected similarity</source>
        <translation>similitude indirecte</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>affine</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>singulière</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>A similarity keeps shapes: it turns, scales and shifts.</source>
        <translation>Une similitude conserve les formes&#x202f;: elle tourne, change l’échelle et translate.</translation>
    </message>
    <message>
        <source>A reflected similarity keeps shapes, as a mirror does, and scales and shifts them.</source>
        <translation>Une similitude indirecte conserve les formes à la manière d’un miroir, change l’échelle et translate.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels, not angles.</source>
        <translation>Une application affine conserve les droites et le parallélisme, mais pas les angles.</translation>
    </message>
    <message>
        <source>A singular map takes the plane to a line.</source>
        <translation>Une application singulière envoie le plan dans une droite.</translation>
    </message>
    <message>
        <source>A constant map takes the plane to one point.</source>
        <translation>Une application constante envoie le plan sur un seul point.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Oui</translation>
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
        <translation>Nature</translation>
    </message>
    <message>
        <source>The map takes (x, y) to (a x + b y + e, c x + d y + f).</source>
        <translation>L’application envoie (x, y) sur (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage. Bake makes it the code.</source>
        <translation>Code effectif&#x202f;: l’application telle qu’elle agit sur l’image sous la cage actuelle. «&#x202f;Intégrer&#x202f;» en fait le code.</translation>
    </message>
    <message>
        <source>Whether the map takes part.</source>
        <translation>Si l’application est active.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map.</source>
        <translation>Couleur de l’application, utilisée quand l’image est colorée selon les applications.</translation>
    </message>
    <message>
        <source>Weight as given: how often the chaos game takes the map. The weights need not sum to 1.</source>
        <translation>Poids tel qu’il est donné&#x202f;: la fréquence à laquelle le jeu du chaos choisit l’application. La somme des poids n’est pas forcément 1.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor of areas; negative when the map reflects.</source>
        <translation>Déterminant ad − bc&#x202f;: le facteur des aires&#x202f;; négatif quand l’application renverse l’orientation.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the most by which distances grow.</source>
        <translation>Facteur de contraction ‖A‖, la plus grande valeur singulière&#x202f;: le plus grand facteur dont les distances augmentent.</translation>
    </message>
    <message>
        <source>What the map is geometrically.</source>
        <translation>Ce qu’est l’application géométriquement.</translation>
    </message>
    <message>
        <source>Map %1 takes part.</source>
        <translation>L’application %1 est active.</translation>
    </message>
    <message>
        <source>Map %1 is switched off.</source>
        <translation>L’application %1 est désactivée.</translation>
    </message>
    <message>
        <source>Colour of map %1. Press Space or double-click to change it.</source>
        <translation>Couleur de l’application %1. Appuyez sur Espace ou double-cliquez pour la changer.</translation>
    </message>
    <message>
        <source>The cage is flat or bent: there is no effective code.</source>
        <translation>La cage est plate ou courbe l’image&#x202f;: il n’y a pas de code effectif.</translation>
    </message>
    <message>
        <source>No weight is given; the determinant rule makes the probability %1.</source>
        <translation>Aucun poids n’est donné&#x202f;; selon la règle des déterminants, la probabilité est %1.</translation>
    </message>
    <message>
        <source>Weight %1: a weight that is not positive switches the map off.</source>
        <translation>Poids %1&#x202f;: un poids qui n’est pas strictement positif désactive l’application.</translation>
    </message>
    <message>
        <source>Weight %1, probability %2.</source>
        <translation>Poids %1, probabilité %2.</translation>
    </message>
    <message>
        <source>%1, not contracting</source>
        <translation>%1, non contractante</translation>
    </message>
    <message>
        <source>colour %1</source>
        <translation>couleur %1</translation>
    </message>
    <message>
        <source>Map %1 does not contract: it stretches by up to %2. The system may still have an attractor if longer words contract.</source>
        <translation>L’application %1 n’est pas contractante&#x202f;: elle étire d’un facteur pouvant atteindre %2. Le système peut tout de même avoir un attracteur si des mots plus longs sont contractants.</translation>
    </message>
    <message>
        <source>Map %1. Drag to reorder.</source>
        <translation>Application %1. Faites glisser pour changer l’ordre.</translation>
    </message>
    <message>
        <source>Change weight of map %1</source>
        <translation>Modifier le poids de l’application %1</translation>
    </message>
    <message>
        <source>Change %1 of map %2</source>
        <translation>Modifier %1 de l’application %2</translation>
    </message>
    <message>
        <source>Switch map %1 on</source>
        <translation>Activer l’application %1</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Désactiver l’application %1</translation>
    </message>
    <message>
        <source>Change colour of map %1</source>
        <translation>Changer la couleur de l’application %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>active</translation>
    </message>
    <message>
        <source>off</source>
        <translation>inactive</translation>
    </message>
</context>
<context>
    <name>view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation>Applications</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a map of half the size</source>
        <translation>Ajouter une application réduisant de moitié</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Dupliquer les applications sélectionnées</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Supprimer les applications sélectionnées</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move the selected maps up</source>
        <translation>Déplacer les applications sélectionnées vers le haut</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Move the selected maps down</source>
        <translation>Déplacer les applications sélectionnées vers le bas</translation>
    </message>
    <message>
        <source>Copy Rows</source>
        <translation>Copier les lignes</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f p, separated by tabs</source>
        <translation>Copier les applications sélectionnées en lignes a b c d e f p, séparées par des tabulations</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>Coller sur place</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 6 or 7 numbers from the clipboard</source>
        <translation>Remplacer les applications sélectionnées par des lignes de 6 ou 7 nombres du presse-papiers</translation>
    </message>
    <message>
        <source>Paste as New Maps</source>
        <translation>Coller comme nouvelles applications</translation>
    </message>
    <message>
        <source>Add rows of 6 or 7 numbers from the clipboard as new maps</source>
        <translation>Ajouter des lignes de 6 ou 7 nombres du presse-papiers comme nouvelles applications</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Intégrer</translation>
    </message>
    <message>
        <source>Make the effective code the code; the cage then rests</source>
        <translation>Faire du code effectif le code&#x202f;; la cage est ensuite au repos</translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Selon |déterminant|</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, so that the picture is even</source>
        <translation>Poids proportionnels aux aires des images, pour une image uniforme</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Égaux</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>Le même poids pour toutes les applications</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Selon la dimension</translation>
    </message>
    <message>
        <source>Weights for an even cover of the attractor at its own dimension</source>
        <translation>Poids couvrant uniformément l’attracteur dans sa propre dimension</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normaliser</translation>
    </message>
    <message>
        <source>The same proportions, with the sum 1</source>
        <translation>Les mêmes proportions, avec la somme 1</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>Weights of all maps that are on, by a rule</source>
        <translation>Poids de toutes les applications actives, selon une règle</translation>
    </message>
    <message>
        <source>Show columns: %1</source>
        <translation>Colonnes affichées&#x202f;: %1</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Show the coefficients a … f</source>
        <translation>Afficher les coefficients a … f</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Afficher le déterminant, le facteur de contraction et la nature de chaque application</translation>
    </message>
    <message>
        <source>Effective code</source>
        <translation>Code effectif</translation>
    </message>
    <message>
        <source>Show the maps as they act on the picture under the current cage</source>
        <translation>Afficher les applications telles qu’elles agissent sur l’image sous la cage actuelle</translation>
    </message>
    <message>
        <source>Table of maps</source>
        <translation>Tableau des applications</translation>
    </message>
    <message>
        <source>No maps: add one, or paste rows of 6 or 7 numbers.</source>
        <translation>Aucune application&#x202f;: ajoutez-en une, ou collez des lignes de 6 ou 7 nombres.</translation>
    </message>
    <message>
        <source>3D: not yet shown.
The entry is kept as it is.</source>
        <translation>3D&#x202f;: pas encore affiché.
L’entrée est conservée telle quelle.</translation>
    </message>
    <message>
        <source>This entry could not be read. It is kept as it is.</source>
        <translation>Cette entrée n’a pas pu être lue. Elle est conservée telle quelle.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Ligne %1, colonne %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>Add a map</source>
        <translation>Ajouter une application</translation>
    </message>
    <message>
        <source>Duplicate a map</source>
        <translation>Dupliquer une application</translation>
    </message>
    <message>
        <source>Duplicate %1 maps</source>
        <translation>Dupliquer %1 applications</translation>
    </message>
    <message>
        <source>Delete a map</source>
        <translation>Supprimer une application</translation>
    </message>
    <message>
        <source>Delete %1 maps</source>
        <translation>Supprimer %1 applications</translation>
    </message>
    <message>
        <source>Reorder maps</source>
        <translation>Réordonner les applications</translation>
    </message>
    <message>
        <source>Nothing was pasted. Line %1 of the clipboard: %2</source>
        <translation>Rien n’a été collé. Ligne %1 du presse-papiers&#x202f;: %2</translation>
    </message>
    <message>
        <source>Nothing was pasted. %1</source>
        <translation>Rien n’a été collé. %1</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard holds no rows of 6 or 7 numbers.</source>
        <translation>Rien n’a été collé&#x202f;: le presse-papiers ne contient pas de lignes de 6 ou 7 nombres.</translation>
    </message>
    <message>
        <source>Paste a map</source>
        <translation>Coller une application</translation>
    </message>
    <message>
        <source>Paste %1 maps</source>
        <translation>Coller %1 applications</translation>
    </message>
    <message>
        <source>Maps added: %1.</source>
        <translation>Applications ajoutées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The selected maps were replaced; maps pasted: %1.</source>
        <translation>Les applications sélectionnées ont été remplacées&#x202f;; applications collées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Set the weights</source>
        <translation>Fixer les poids</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Intégrer la cage au code</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Couleur de l’application %1</translation>
    </message>
    <message>
        <source>Every row is a map: (x, y) goes to (a x + b y + e, c x + d y + f), as often as its weight p says. Double-click a number, or begin to type, to change it; the picture follows every key. Drag the number of a row to move it.</source>
        <translation>Chaque ligne est une application&#x202f;: (x, y) devient (a x + b y + e, c x + d y + f), aussi souvent que le dit son poids p. Double-cliquez sur un nombre, ou commencez à taper, pour le modifier&#x202f;; l’image suit chaque frappe. Faites glisser le numéro d’une ligne pour la déplacer.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Lecture de ce qui a été collé…</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Numéros des applications</translation>
    </message>
    <message>
        <source>Drag a number to put the map elsewhere. A mark warns of a map that does not contract.</source>
        <translation>Faites glisser un numéro pour placer l’application ailleurs. Une marque signale une application qui n’est pas contractante.</translation>
    </message>
</context>
<context>
    <name>view::MapsTool</name>
    <message>
        <source>Move corner %1 of map %2</source>
        <translation>Déplacer le coin %1 de l’application %2</translation>
    </message>
    <message>
        <source>Move map %1</source>
        <translation>Déplacer l’application %1</translation>
    </message>
    <message>
        <source>Move %1 maps</source>
        <translation>Déplacer %1 applications</translation>
    </message>
    <message>
        <source>Rotate map %1</source>
        <translation>Tourner l’application %1</translation>
    </message>
    <message>
        <source>Rotate %1 maps</source>
        <translation>Tourner %1 applications</translation>
    </message>
    <message>
        <source>Scale map %1</source>
        <translation>Mettre à l’échelle l’application %1</translation>
    </message>
    <message>
        <source>Scale %1 maps</source>
        <translation>Mettre à l’échelle %1 applications</translation>
    </message>
    <message>
        <source>What is flat on the screen cannot be taken. Open the cage, or the maps, first.</source>
        <translation>Ce qui est plat à l’écran ne peut pas être saisi. Ouvrez d’abord la cage ou les applications.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Choisissez d’abord une application.</translation>
    </message>
    <message>
        <source>Of so many maps only some are shown. Zoom in to see the others.</source>
        <translation>De si nombreuses applications, seules quelques-unes sont montrées. Agrandissez la vue pour voir les autres.</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Variations de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Fractals by Chance</source>
        <translation>Fractales au hasard</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Utiliser celle-ci</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>&amp;Ajouter au fichier</translation>
    </message>
    <message>
        <source>&amp;Vary This One</source>
        <translation>Faire &amp;varier celle-ci</translation>
    </message>
    <message>
        <source>Make the chosen one what the variations start from</source>
        <translation>Faire de celle qui est choisie le point de départ des variations</translation>
    </message>
    <message>
        <source>How different the variations are</source>
        <translation>À quel point les variations diffèrent</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Graine des nombres aléatoires</translation>
    </message>
    <message>
        <source>The same seed gives the same sheet again</source>
        <translation>La même graine redonne la même planche</translation>
    </message>
    <message>
        <source>&amp;Others</source>
        <translation>Au&amp;tres</translation>
    </message>
    <message>
        <source>Another sheet: the next seed</source>
        <translation>Une autre planche&#x202f;: la graine suivante</translation>
    </message>
    <message>
        <source>&amp;Difference:</source>
        <translation>&amp;Différence&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Graine&#x202f;:</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>Variation %1</translation>
    </message>
    <message>
        <source>Mutate</source>
        <translation>Faire muter</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Ajouter une fractale aléatoire</translation>
    </message>
    <message>
        <source>Choose one and press OK, or double-click it: it takes the place of the fractal, as one step that can be undone.</source>
        <translation>Choisissez-en une et appuyez sur OK, ou double-cliquez dessus&#x202f;: elle prend la place de la fractale, en une seule étape annulable.</translation>
    </message>
    <message>
        <source>To the left the variations are much like what they start from, to the right they are wild.</source>
        <translation>À gauche, les variations ressemblent beaucoup à leur point de départ&#x202f;; à droite, elles sont débridées.</translation>
    </message>
    <message>
        <source>Takes the chosen one, as one step that can be undone.</source>
        <translation>Prend celle qui est choisie, en une seule étape annulable.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma. Arrow keys and the wheel change it: with Shift ten times as fast, with Alt a tenth. Esc takes back what was typed.</source>
        <translation>Un nombre, avec un point ou une virgule décimale. Les touches fléchées et la molette le modifient&#x202f;: avec Maj, dix fois plus vite&#x202f;; avec Alt, dix fois moins. Échap annule la saisie.</translation>
    </message>
</context>
<context>
    <name>view::PasteTableDialog</name>
    <message>
        <source>Paste maps</source>
        <translation>Coller des applications</translation>
    </message>
    <message>
        <source>Paste a Table</source>
        <translation>Coller un tableau</translation>
    </message>
    <message>
        <source>The rows do not say which column is which, and programs differ. Choose the order in which the picture behind this dialog is the one you expect.</source>
        <translation>Les lignes ne disent pas à quoi correspond chaque colonne, et les programmes diffèrent. Choisissez l’ordre pour lequel l’image derrière ce dialogue est celle que vous attendez.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Les applications telles qu’elles seront collées</translation>
    </message>
    <message>
        <source>The maps in the order chosen: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
        <translation>Les applications dans l’ordre choisi&#x202f;: (x, y) devient (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>What the maps do</source>
        <translation>Ce que font les applications</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Colonnes&#x202f;:</translation>
    </message>
    <message>
        <source>There are no rows of 6 or 7 numbers.</source>
        <translation>Il n’y a pas de lignes de 6 ou 7 nombres.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>In this order every map contracts.</source>
        <translation>Dans cet ordre, toutes les applications sont contractantes.</translation>
    </message>
    <message>
        <source>In this order these maps do not contract: %1. Perhaps the columns mean something else.</source>
        <translation>Dans cet ordre, ces applications ne sont pas contractantes&#x202f;: %1. Peut-être les colonnes signifient-elles autre chose.</translation>
    </message>
    <message>
        <source>Order of the Columns</source>
        <translation>Ordre des colonnes</translation>
    </message>
    <message>
        <source>&amp;Use This Order</source>
        <translation>&amp;Utiliser cet ordre</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>The language changes when Barycage is started again.</source>
        <translation>La langue changera au prochain démarrage de Barycage.</translation>
    </message>
    <message>
        <source>&amp;Open the files of last time at the start</source>
        <translation>R&amp;ouvrir au démarrage les fichiers de la dernière fois</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>That of the desktop</source>
        <translation>Celle du bureau</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>The language of menus and messages. Files and numbers are the same in every language.</source>
        <translation>La langue des menus et des messages. Les fichiers et les nombres sont les mêmes dans toutes les langues.</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>The colours of windows and panels. The picture keeps its own.</source>
        <translation>Les couleurs des fenêtres et des panneaux. L’image garde les siennes.</translation>
    </message>
    <message>
        <source>Draft: 50 million points</source>
        <translation>Brouillon&#x202f;: 50 millions de points</translation>
    </message>
    <message>
        <source>Good: 200 million points</source>
        <translation>Bonne&#x202f;: 200 millions de points</translation>
    </message>
    <message>
        <source>Fine: 1000 million points</source>
        <translation>Fine&#x202f;: 1 milliard de points</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Image au repos</translation>
    </message>
    <message>
        <source>How many points are drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Combien de points sont dessinés tant que rien ne bouge. Davantage de points donnent une image plus lisse et occupent le processeur plus longtemps.</translation>
    </message>
    <message>
        <source>When on, Barycage opens the files that were open when it was closed, a window each.</source>
        <translation>Si cette case est cochée, Barycage ouvre les fichiers qui étaient ouverts à sa fermeture, chacun dans sa fenêtre.</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Langue&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Thème&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>Image au &amp;repos&#x202f;:</translation>
    </message>
    <message>
        <source>Puts every choice of this dialog back to what it is at first.</source>
        <translation>Ramène tous les choix de ce dialogue à leur valeur initiale.</translation>
    </message>
</context>
<context>
    <name>view::ProblemsModel</name>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Line:column</source>
        <translation>Ligne:colonne</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Ce qui a été trouvé</translation>
    </message>
</context>
<context>
    <name>view::ProblemsPanel</name>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>Problems found while reading</source>
        <translation>Problèmes trouvés à la lecture</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Choose a line to show the entry it concerns.</source>
        <translation>Choisissez une ligne pour afficher l’entrée concernée.</translation>
    </message>
    <message>
        <source>Number of problems</source>
        <translation>Nombre de problèmes</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy the selected problems as text.</source>
        <translation>Copier les problèmes sélectionnés sous forme de texte.</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
    <message>
        <source>Select all problems.</source>
        <translation>Sélectionner tous les problèmes.</translation>
    </message>
    <message>
        <source>1 problem was found while reading.</source>
        <translation>1 problème a été trouvé à la lecture.</translation>
    </message>
    <message numerus="yes">
        <source>%n problems were found while reading.</source>
        <translation>
            <numerusform>%n problème a été trouvé à la lecture.</numerusform>
            <numerusform>%n problèmes ont été trouvés à la lecture.</numerusform>
        </translation>
    </message>
    <message>
        <source>What could not be read is kept as it is.</source>
        <translation>Ce qui n’a pas pu être lu est conservé tel quel.</translation>
    </message>
    <message>
        <source>Nothing to report: every entry was read.</source>
        <translation>Rien à signaler&#x202f;: toutes les entrées ont été lues.</translation>
    </message>
    <message>
        <source>What the reader of the file remarked, with line and column. Double-click a line to go to its entry.</source>
        <translation>Ce qui a été remarqué à la lecture du fichier, avec la ligne et la colonne. Double-cliquez sur une ligne pour aller à son entrée.</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsDialog</name>
    <message>
        <source>On the canvas</source>
        <translation>Dans la zone de dessin</translation>
    </message>
    <message>
        <source>Move a vertex, an edge, the whole cage</source>
        <translation>Déplacer un sommet, une arête, la cage entière</translation>
    </message>
    <message>
        <source>drag it</source>
        <translation>les faire glisser</translation>
    </message>
    <message>
        <source>Rotate about the pivot</source>
        <translation>Tourner autour du pivot</translation>
    </message>
    <message>
        <source>Ctrl + drag, or the round handle</source>
        <translation>Ctrl + glisser, ou la poignée ronde</translation>
    </message>
    <message>
        <source>Scale about the pivot</source>
        <translation>Redimensionner autour du pivot</translation>
    </message>
    <message>
        <source>Alt + drag, or the square handle</source>
        <translation>Alt + glisser, ou la poignée carrée</translation>
    </message>
    <message>
        <source>Move or scale along one axis, turn in steps of 15°</source>
        <translation>Déplacer ou redimensionner selon un axe, tourner par pas de 15°</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Maj en glissant</translation>
    </message>
    <message>
        <source>Take the drag back</source>
        <translation>Annuler le geste en cours</translation>
    </message>
    <message>
        <source>Esc while dragging</source>
        <translation>Échap en glissant</translation>
    </message>
    <message>
        <source>Next or previous handle</source>
        <translation>Poignée suivante ou précédente</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Maj+Tab</translation>
    </message>
    <message>
        <source>Nudge the handle</source>
        <translation>Déplacer un peu la poignée</translation>
    </message>
    <message>
        <source>arrow keys; Shift ×10, Alt ×0.1</source>
        <translation>touches fléchées&#x202f;; Maj ×10, Alt ×0,1</translation>
    </message>
    <message>
        <source>Leave the canvas</source>
        <translation>Quitter la zone de dessin</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Zoomer sur le pointeur</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>middle drag, or Space + drag</source>
        <translation>glisser avec le bouton du milieu, ou Espace + glisser</translation>
    </message>
    <message>
        <source>Keyboard and Mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Rechercher dans les raccourcis</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Comment</translation>
    </message>
    <message>
        <source>Shows only the lines that have these words.</source>
        <translation>N’affiche que les lignes qui contiennent ces mots.</translation>
    </message>
    <message>
        <source>What every key and every movement of the mouse does.</source>
        <translation>Ce que fait chaque touche et chaque mouvement de la souris.</translation>
    </message>
    <message>
        <source>Shift or Ctrl + click</source>
        <translation>Maj ou Ctrl + clic</translation>
    </message>
    <message>
        <source>Select map 1 … 9, all maps</source>
        <translation>Choisir l’application 1 … 9, toutes les applications</translation>
    </message>
    <message>
        <source>Alt + digit, Ctrl+A</source>
        <translation>Alt + chiffre, Ctrl+A</translation>
    </message>
    <message>
        <source>A deeper or a larger branch</source>
        <translation>Une branche plus profonde ou plus grande</translation>
    </message>
    <message>
        <source>Shift + wheel, Page Down, Page Up</source>
        <translation>Maj + molette, Page suivante, Page précédente</translation>
    </message>
    <message>
        <source>Select the maps, or the vertices, in a rectangle</source>
        <translation>Choisir les applications, ou les sommets, dans un rectangle</translation>
    </message>
    <message>
        <source>drag from the empty canvas; Shift adds</source>
        <translation>faire glisser depuis la zone de dessin vide&#x202f;; Maj ajoute</translation>
    </message>
    <message>
        <source>Select one more map or vertex, or one less</source>
        <translation>Choisir une application ou un sommet de plus ou de moins</translation>
    </message>
    <message>
        <source>Delete the selected vertices or maps</source>
        <translation>Supprimer les sommets ou les applications choisis</translation>
    </message>
    <message>
        <source>Insert a vertex on an edge, duplicate the selected maps</source>
        <translation>Insérer un sommet sur une arête, dupliquer les applications choisies</translation>
    </message>
    <message>
        <source>Take the last vertex back while a triangle is defined</source>
        <translation>Reprendre le dernier sommet pendant la définition d’un triangle</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Choose another stop</source>
        <translation>Choisir un autre repère</translation>
    </message>
    <message>
        <source>Page Up, Page Down, Home, End, or Ctrl + Left, Right</source>
        <translation>Page préc., Page suiv., Début, Fin, ou Ctrl + Gauche, Droite</translation>
    </message>
    <message>
        <source>Move the stop</source>
        <translation>Déplacer le repère</translation>
    </message>
    <message>
        <source>Left, Right; Shift ×10</source>
        <translation>Gauche, Droite ; Maj ×10</translation>
    </message>
    <message>
        <source>Add a stop</source>
        <translation>Ajouter un repère</translation>
    </message>
    <message>
        <source>Ins or +, or double-click</source>
        <translation>Inser ou +, ou double-clic</translation>
    </message>
    <message>
        <source>Delete the stop</source>
        <translation>Supprimer le repère</translation>
    </message>
    <message>
        <source>Del or Backspace</source>
        <translation>Suppr ou Retour arrière</translation>
    </message>
    <message>
        <source>Change the colour of the stop</source>
        <translation>Changer la couleur du repère</translation>
    </message>
    <message>
        <source>Enter or Space, or double-click it</source>
        <translation>Entrée ou Espace, ou double-clic dessus</translation>
    </message>
    <message>
        <source>Take the change back</source>
        <translation>Annuler la modification</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>On the strip of the gradient</source>
        <translation>Sur la bande du dégradé</translation>
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
        <translation>Transformer par valeurs numériques</translation>
    </message>
    <message>
        <source>x of the fixed point</source>
        <translation>x du point fixe</translation>
    </message>
    <message>
        <source>y of the fixed point</source>
        <translation>y du point fixe</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Shear along x</source>
        <translation>Cisaillement selon x</translation>
    </message>
    <message>
        <source>Scale in x</source>
        <translation>Échelle en x</translation>
    </message>
    <message>
        <source>Scale in y</source>
        <translation>Échelle en y</translation>
    </message>
    <message>
        <source>Same in x and y</source>
        <translation>Identique en x et en y</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise</source>
        <translation>Rotation en degrés, dans le sens direct</translation>
    </message>
    <message>
        <source>Translation in x</source>
        <translation>Translation en x</translation>
    </message>
    <message>
        <source>Translation in y</source>
        <translation>Translation en y</translation>
    </message>
    <message>
        <source>Done in this order, from top to bottom.</source>
        <translation>Effectué dans cet ordre, de haut en bas.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Start Again</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>All values as they were when the dialog opened</source>
        <translation>Toutes les valeurs comme à l’ouverture du dialogue</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Placer l’image</translation>
    </message>
    <message>
        <source>The code stays; the cage moves</source>
        <translation>Le code reste&#x202f;; la cage se déplace</translation>
    </message>
    <message>
        <source>Rewrite the code</source>
        <translation>Réécrire le code</translation>
    </message>
    <message>
        <source>Every map w becomes T∘w∘T⁻¹; the cage follows</source>
        <translation>Chaque application w devient T∘w∘T⁻¹&#x202f;; la cage suit</translation>
    </message>
    <message>
        <source>The point that stays</source>
        <translation>Le point qui reste fixe</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>l’origine</translation>
    </message>
    <message>
        <source>the mean of the invariant measure</source>
        <translation>la moyenne de la mesure invariante</translation>
    </message>
    <message>
        <source>a typed point</source>
        <translation>un point saisi</translation>
    </message>
    <message>
        <source>in the line at the angle °</source>
        <translation>par rapport à la droite d’angle °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Angle de l’axe de symétrie en degrés&#x202f;: 0 pour l’horizontale, 90 pour la verticale</translation>
    </message>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Cette entrée n’a pas d’applications du plan.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be undone, so it cannot be written into the code. Choose other scales, or place the picture.</source>
        <translation>Cette transformation est trop plate pour que l’on puisse l’inverser&#x202f;; elle ne peut donc pas être inscrite dans le code. Choisissez d’autres échelles, ou placez l’image.</translation>
    </message>
    <message>
        <source>Transform the picture</source>
        <translation>Transformer l’image</translation>
    </message>
    <message>
        <source>Transform the code</source>
        <translation>Transformer le code</translation>
    </message>
    <message>
        <source>Keeps the factor in y equal to that in x.</source>
        <translation>Maintient le facteur en y égal à celui en x.</translation>
    </message>
    <message>
        <source>About which point the fractal is turned, scaled and reflected: it stays where it is.</source>
        <translation>Le point autour duquel on tourne, redimensionne et réfléchit la fractale&#x202f;: il reste où il est.</translation>
    </message>
    <message>
        <source>Mirrors in a line through the point that stays; the angle is counted from the x axis.</source>
        <translation>Symétrie par rapport à une droite passant par le point fixe&#x202f;; l’angle se compte depuis l’axe des x.</translation>
    </message>
    <message>
        <source>Change:</source>
        <translation>Effet :</translation>
    </message>
    <message>
        <source>About:</source>
        <translation>Autour de :</translation>
    </message>
    <message>
        <source>Reflect:</source>
        <translation>Symétrie :</translation>
    </message>
    <message>
        <source>Shear:</source>
        <translation>Cisaillement :</translation>
    </message>
    <message>
        <source>Scale:</source>
        <translation>Échelle :</translation>
    </message>
    <message>
        <source>Rotate °:</source>
        <translation>Rotation ° :</translation>
    </message>
    <message>
        <source>Translate:</source>
        <translation>Translation :</translation>
    </message>
    <message>
        <source>the middle of the picture’s box</source>
        <translation>le centre de la boîte englobante de l’image</translation>
    </message>
</context>
<context>
    <name>view::VertexDialog</name>
    <message>
        <source>Move vertex %1</source>
        <translation>Déplacer le sommet %1</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Sommet %1</translation>
    </message>
    <message>
        <source>x of the vertex</source>
        <translation>x du sommet</translation>
    </message>
    <message>
        <source>y of the vertex</source>
        <translation>y du sommet</translation>
    </message>
    <message>
        <source>What is wrong with the numbers</source>
        <translation>Ce qui ne va pas dans les nombres</translation>
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
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre. Écrivez-le avec un point décimal, par exemple -0.25.</translation>
    </message>
    <message>
        <source>A coordinate of the vertex, with a decimal point or comma. The picture follows as you type.</source>
        <translation>Une coordonnée du sommet, avec un point ou une virgule décimale. L’image suit la saisie.</translation>
    </message>
</context>
</TS>
