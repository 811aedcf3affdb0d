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
    <name>ActionDetails</name>
    <message>
        <source>Drag an edge to move both its ends, the inside to move the whole cage. Ctrl rotates, Alt scales, Shift keeps directions. The fractal follows at once, and each drag is one step of the history.</source>
        <translation>Une arête déplace ses deux extrémités, l’intérieur toute la cage. Ctrl fait tourner, Alt met à l’échelle, Maj conserve les directions. La fractale suit aussitôt, et chaque glissement est une étape de l’historique.</translation>
    </message>
    <message>
        <source>Each map is shown as the image of the cage in its colour. A corner changes one map; the inside moves all selected maps. A drag stops where the attractor would be lost.</source>
        <translation>Chaque application est montrée comme image de la cage dans sa couleur. Un coin modifie une application, l’intérieur déplace toutes celles qui sont sélectionnées. Le glissement s’arrête là où l’attracteur serait perdu.</translation>
    </message>
    <message>
        <source>The picture stays where it is and follows the new triangle from now on. Backspace removes the last point, Esc cancels.</source>
        <translation>L’image reste où elle est&#x202f;: elle est désormais tenue par le nouveau triangle. Retour arrière reprend le dernier coin, Échap annule.</translation>
    </message>
    <message>
        <source>The picture stays where it is. Every point of the fractal then has barycentric coordinates that are not negative.</source>
        <translation>L’image reste où elle est. Chaque point de la fractale a ensuite des coordonnées barycentriques qui ne sont pas négatives.</translation>
    </message>
    <message>
        <source>The coefficients do not change. To keep the picture as it is and change the coefficients instead, use Bake.</source>
        <translation>Les coefficients ne changent pas. Pour garder l’image et modifier plutôt les coefficients, utilisez Intégrer au code.</translation>
    </message>
    <message>
        <source>Each map w becomes T w T⁻¹, where T is the affine map from the cage at rest to the current cage. The cage is at rest afterwards. A cage that is flat or bends the picture cannot be baked.</source>
        <translation>Chaque application w devient T w T⁻¹, où T est ce que la cage fait à l’image. La cage est ensuite au repos. Une cage plate ou qui courbe l’image ne peut pas être intégrée.</translation>
    </message>
    <message>
        <source>The table of maps keeps its numbers, and Bake writes the placement into them later.</source>
        <translation>Le tableau des applications garde ses nombres&#x202f;; Intégrer au code y écrit le placement plus tard.</translation>
    </message>
    <message>
        <source>The table of maps shows the new numbers during the drag, and the cage is at rest again afterwards.</source>
        <translation>Le tableau des applications montre les nouveaux nombres pendant le glissement, et la cage est ensuite de nouveau au repos.</translation>
    </message>
    <message>
        <source>The cage is included if that needs little space. The fractal itself does not change.</source>
        <translation>La cage est comprise là où cela prend peu de place. La fractale elle-même ne change pas.</translation>
    </message>
    <message>
        <source>Only the view is flipped: coefficients and coordinates do not change.</source>
        <translation>Seule la vue est retournée&#x202f;: ni les coefficients ni les coordonnées ne changent.</translation>
    </message>
    <message>
        <source>Press the key again to show the cage, handles, grid, axes and outlines.</source>
        <translation>La cage, les poignées, la grille, les axes et les contours reviennent quand vous appuyez de nouveau sur la touche.</translation>
    </message>
    <message>
        <source>A bar appears under the canvas: choose the number of steps, or let the chaos game run point by point at any speed.</source>
        <translation>Une barre apparaît sous le canevas&#x202f;: choisissez le nombre d’étapes, ou laissez le jeu du chaos avancer point par point à n’importe quelle vitesse.</translation>
    </message>
    <message>
        <source>As a placement, it leaves the coefficients unchanged; as code, it replaces them by those of the transformed fractal. The canvas shows the result before you accept it.</source>
        <translation>Comme placement, les coefficients restent&#x202f;; comme code, ils deviennent ceux de la fractale transformée. Le canevas montre le résultat avant que vous l’acceptiez.</translation>
    </message>
    <message>
        <source>A new language takes effect at the next start; everything else at once, in all windows.</source>
        <translation>Une nouvelle langue prend effet au prochain démarrage, tout le reste aussitôt et dans toutes les fenêtres.</translation>
    </message>
    <message>
        <source>Choose a motion, which needs no keys, or set keys. A change to something that has keys sets a key at the playhead; any other change applies to the whole animation.</source>
        <translation>Choisissez un mouvement qui n’a pas besoin de clés, ou créez des clés&#x202f;: ce qui a des clés en reçoit une autre partout où vous le modifiez&#x202f;; ce qui n’en a pas change pour toute l’animation.</translation>
    </message>
    <message>
        <source>If a table does not name its columns, you are asked for their order. In the Maps panel, Paste adds the copied maps, or rows of numbers, to the fractal.</source>
        <translation>Si un tableau ne nomme pas ses colonnes, leur ordre vous est demandé. Dans le panneau Applications, Coller ajoute à la fractale les applications copiées ou les lignes de nombres.</translation>
    </message>
    <message>
        <source>Acts on maps while the table of maps, or the canvas with the Maps tool, has the focus, and on entries while the list of entries has it.</source>
        <translation>Ce qui a le focus décide&#x202f;: le tableau des applications et le canevas avec l’outil des applications déplacent des applications, la liste des entrées des entrées.</translation>
    </message>
    <message>
        <source>Maps are copied with their names and as rows of numbers, entries as .ifs text that other programs can read.</source>
        <translation>Les applications sont copiées avec leurs noms et en lignes de nombres, les entrées en texte .ifs que d’autres programmes peuvent lire.</translation>
    </message>
    <message>
        <source>A locked map cannot be edited in the table, dragged, nudged, arranged, fitted or deleted. Changes to the whole fractal, such as a cage that rewrites the code, also change its locked maps.</source>
        <translation>Une application verrouillée ne peut être ni retapée, ni glissée, ni poussée, ni disposée, ni ajustée, ni supprimée. Ce qui change toute la fractale, comme une cage qui réécrit le code, change aussi ses applications verrouillées.</translation>
    </message>
    <message>
        <source>Draws only the part of the attractor that this map makes. The file does not change. If you select another entry, its whole attractor is shown.</source>
        <translation>Seule la partie de l’attracteur que produit l’application est dessinée. Le fichier ne change pas, et une autre entrée est de nouveau affichée entière.</translation>
    </message>
    <message>
        <source>Shift + wheel chooses how deep the branch is. The bar under the canvas says what the drag changes: a new map for this branch, the last map of its address, only this branch, or this branch and the same one inside it.</source>
        <translation>Maj + molette choisit la profondeur de la branche. La barre sous le canevas dit ce que le glissement modifie&#x202f;: une nouvelle application pour cette branche, la dernière application de son adresse, cette branche seule, ou cette branche et la même à l’intérieur.</translation>
    </message>
    <message>
        <source>The spacing of its lines follows the zoom. Vertices snap to it if this is chosen under View › Canvas › Snap To.</source>
        <translation>L’écartement de ses lignes suit le zoom. Les sommets s’y accrochent si c’est choisi sous Affichage › Zone de dessin › Accrochage.</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Attracteur</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Contraction</translation>
    </message>
    <message>
        <source>‖A‖ of each active map: the largest factor by which it stretches distances.</source>
        <translation>‖A‖ pour chaque application active&#x202f;: le plus grand facteur dont elle étire les distances.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte englobante</translation>
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
        <source>Covariance</source>
        <translation>Covariance</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Points fixes</translation>
    </message>
    <message>
        <source>The point that each map leaves unchanged; it belongs to the attractor.</source>
        <translation>Le point que chaque application laisse à sa place&#x202f;; il est sur l’attracteur.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Dimension d’affinité</translation>
    </message>
    <message>
        <source>Falconer’s dimension, at most 2: the exponent at which the sum of the singular value functions of all words of one length neither grows nor shrinks as the words get longer. It is an upper bound for the box-counting dimension, and equal to it for almost all translations if the maps contract enough.</source>
        <translation>La dimension de Falconer&#x202f;: là où la somme des fonctions de valeurs singulières de tous les mots d’une même longueur ni ne croît ni ne décroît, au plus 2. Une borne supérieure de la dimension par comptage de boîtes, égale à elle pour presque toutes les translations quand les applications contractent assez.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Dimension par comptage de boîtes</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Aire de l’enveloppe</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Sommets de l’enveloppe</translation>
    </message>
    <message>
        <source>Vertices of the computed hull; each is a point of the attractor. If the exact hull has infinitely many, as many are computed as the tolerance requires.</source>
        <translation>Sommets de l’enveloppe convexe tels que trouvés, chacun un point de l’attracteur. Une enveloppe qui en a une infinité en a autant que sa tolérance l’exige.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Borne d’erreur de l’enveloppe</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polygon; certified.</source>
        <translation>L’attracteur dépasse le polygone d’au plus cette distance&#x202f;; certifié.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… et %n autre</numerusform>
            <numerusform>… et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Séparation</translation>
    </message>
    <message>
        <source>Whether the pieces that the maps make of the attractor are disjoint (strong separation, proved by disjoint covers), or words of maps coincide, so that the open set condition fails.</source>
        <translation>Si les morceaux que les applications font de l’attracteur sont disjoints (séparation forte, prouvée par des recouvrements disjoints), ou si des mots d’applications coïncident, ce qui contredit la condition de l’ensemble ouvert.</translation>
    </message>
    <message>
        <source>Connectedness</source>
        <translation>Connexité</translation>
    </message>
    <message>
        <source>Overlaps</source>
        <translation>Recouvrements</translation>
    </message>
    <message>
        <source>Different words that compose to the same map, neither a prefix of the other: their pieces coincide.</source>
        <translation>Mots d’applications qui sont une seule et même application, sans que l’un soit le début de l’autre&#x202f;: leurs morceaux coïncident.</translation>
    </message>
    <message>
        <source>Joint spectral radius</source>
        <translation>Rayon spectral joint</translation>
    </message>
    <message>
        <source>Entropy</source>
        <translation>Entropie</translation>
    </message>
    <message>
        <source>−Σ pᵢ ln pᵢ: the uncertainty of one step of the chaos game, in nats.</source>
        <translation>−Σ pᵢ ln pᵢ&#x202f;: ce qu’un pas du jeu du chaos laisse ouvert, en nats.</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Exposant de Liapounov</translation>
    </message>
    <message>
        <source>Σ pᵢ ln sᵢ: how the logarithm of a distance changes per step of the chaos game, if all maps are similarities in some coordinates.</source>
        <translation>Σ pᵢ ln sᵢ&#x202f;: la variation du logarithme d’une distance à chaque pas du jeu du chaos, si toutes les applications sont des similitudes dans certaines coordonnées.</translation>
    </message>
    <message>
        <source>Dimension of the measure</source>
        <translation>Dimension de la mesure</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 2: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>L’entropie divisée par l’opposé de l’exposant de Liapounov, au plus 2&#x202f;: la dimension de la mesure invariante sous la condition de l’ensemble ouvert, sinon un majorant.</translation>
    </message>
    <message>
        <source>The number D with Σ sᵢᴰ = 1, where sᵢ are the ratios of the maps, if all maps are similarities in some coordinates. It is the dimension of the attractor under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Le nombre D tel que Σ sᵢᴰ = 1, où les sᵢ sont les rapports des applications, si toutes sont des similitudes dans certaines coordonnées. C’est la dimension de l’attracteur sous la condition de l’ensemble ouvert, sinon un majorant.</translation>
    </message>
    <message>
        <source>Slope of the least-squares line of ln N against ln 1/ε, where N is the number of boxes of side ε that meet the attractor, over the sizes where it is most stable. This is an estimate: the uncertainty is the difference between parts of that range, not a proven bound.</source>
        <translation>Pente de la droite des moindres carrés de ln N en fonction de ln 1/ε, où N est le nombre de boîtes de côté ε qui rencontrent l’attracteur, sur les tailles où elle est la plus régulière. C’est une estimation&#x202f;; l’incertitude vient de l’écart entre des parties de cet intervalle et n’est pas une preuve.</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved without sampling: the centre of mass of the picture.</source>
        <translation>Moyenne de la mesure invariante, calculée sans échantillonnage&#x202f;: le centre de masse de l’image.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved without sampling: how far the picture spreads. A uniform mass on the ellipse has the same mean and covariance.</source>
        <translation>Covariance xx, xy, yy de la mesure invariante, calculée sans échantillonnage&#x202f;: l’étendue de l’image. Une masse uniforme qui remplit l’ellipse a la même moyenne et la même covariance.</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that contains the attractor; certified. Each side is off by at most the error.</source>
        <translation>Le plus petit rectangle de côtés parallèles aux axes qui contient l’attracteur&#x202f;; certifié. Ses côtés s’écartent au plus de l’erreur.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>Le plus petit triangle rectangle isocèle aux côtés parallèles aux axes qui contient l’attracteur&#x202f;; certifié. Les signes donnent les directions de ses cathètes. Pour un seul point, la cathète vaut 1.</translation>
    </message>
    <message>
        <source>Area of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most its perimeter times the error bound e, and πe² for the corners.</source>
        <translation>Aire de l’enveloppe calculée, dont les sommets sont des points de l’attracteur. L’enveloppe convexe exacte est plus grande d’au plus son périmètre fois la borne d’erreur e, et πe² pour les coins.</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 3: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Entropie divisée par l’opposé de l’exposant de Liapounov, au plus 3&#x202f;: la dimension de la mesure invariante sous la condition de l’ensemble ouvert, sinon un majorant.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, xz, yy, yz, zz of the invariant measure, solved without sampling: how far the picture spreads.</source>
        <translation>Covariance xx, xy, xz, yy, yz, zz de la mesure invariante, résolue sans échantillonnage&#x202f;: l’étendue de l’image.</translation>
    </message>
    <message>
        <source>Box</source>
        <comment>in space</comment>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>The smallest box with edges parallel to the axes that contains the attractor, to the error bound.</source>
        <translation>La plus petite boîte aux arêtes parallèles aux axes qui contient l’attracteur, à la borne d’erreur près.</translation>
    </message>
    <message>
        <source>Box error bound</source>
        <translation>Borne d’erreur de la boîte</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the box; certified.</source>
        <translation>L’attracteur dépasse la boîte d’au plus cette distance&#x202f;; certifié.</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>Le plus petit tétraèdre à trois côtés égaux parallèles aux axes qui contient l’attracteur&#x202f;; certifié. Les signes donnent les directions de ses côtés. Pour un seul point, le côté vaut 1.</translation>
    </message>
    <message>
        <source>Hull volume</source>
        <translation>Volume de l’enveloppe</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polyhedron; certified.</source>
        <translation>L’attracteur dépasse le polyèdre d’au plus cette distance&#x202f;; certifié.</translation>
    </message>
    <message>
        <source>Tile area</source>
        <translation>Aire de la tuile</translation>
    </message>
    <message>
        <source>Boundary dimension</source>
        <translation>Dimension de la frontière</translation>
    </message>
    <message>
        <source>Dimension of the boundary, if all maps are similarities of one ratio whose pieces fill an area and meet in finitely many ways: from the growth of the number of contacts.</source>
        <translation>Dimension de la frontière si toutes les applications sont des similitudes de même rapport dont les morceaux remplissent une aire et se touchent d’un nombre fini de façons&#x202f;: d’après la croissance du nombre de contacts.</translation>
    </message>
    <message>
        <source>Moran equation</source>
        <translation>Équation de Moran</translation>
    </message>
    <message>
        <source>Σ sᵢᴰ = 1 with the ratios of these maps, equal ratios combined. Its solution is the similarity dimension.</source>
        <translation>Σ sᵢᴰ = 1 avec les rapports de ces applications, ceux qui sont égaux étant regroupés. Sa solution est la dimension de similitude.</translation>
    </message>
    <message>
        <source>A compact set to which the iterates of every compact set converge. A system has one if and only if its maps contract in some norm.</source>
        <translation>Un ensemble compact auquel mène, pas à pas, tout ensemble compact de départ. Un système en a un si et seulement si ses applications contractent dans une norme.</translation>
    </message>
    <message>
        <source>An attractor is connected if and only if its pieces are joined by common points (Hata). Common points are looked for among fixed points of short words, and their absence is proved by disjoint covers.</source>
        <translation>Un attracteur est connexe si et seulement si des points communs relient ses morceaux (Hata). Les points communs sont cherchés parmi les points fixes de mots courts&#x202f;; leur absence est prouvée par des recouvrements disjoints.</translation>
    </message>
    <message>
        <source>The largest factor per map by which long words stretch. Both ends of the interval are proved; a system contracts in some norm if and only if it is less than 1.</source>
        <translation>Le plus grand facteur par application dont les longs mots étirent. Les deux bornes de l’intervalle sont prouvées&#x202f;; un système contracte dans une norme si et seulement s’il est inférieur à 1.</translation>
    </message>
    <message>
        <source>Volume of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most the error.</source>
        <translation>Volume de l’enveloppe calculée, dont les sommets sont des points de l’attracteur. L’enveloppe convexe exacte est plus grande d’au plus l’erreur.</translation>
    </message>
    <message>
        <source>There is no value, because it is not proved that there is an attractor.</source>
        <translation>Il n’y a pas de valeur, car il n’est pas prouvé qu’il existe un attracteur.</translation>
    </message>
    <message>
        <source>There is no value, because there is no attractor.</source>
        <translation>Il n’y a pas de valeur, car il n’y a pas d’attracteur.</translation>
    </message>
    <message>
        <source>There is no value: for these maps, none could be computed.</source>
        <translation>Il n’y a pas de valeur&#x202f;: pour ces applications, aucune n’a pu être calculée.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not all similarities in the same coordinates.</source>
        <translation>Il n’y a pas de valeur, car ces applications ne sont pas toutes des similitudes dans les mêmes coordonnées.</translation>
    </message>
    <message>
        <source>No overlaps were found.</source>
        <translation>Aucun recouvrement n’a été trouvé.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not of this kind.</source>
        <translation>Il n’y a pas de valeur, car ces applications ne sont pas de ce genre.</translation>
    </message>
    <message>
        <source>There is no value, because the maps are linked: the equation is another.</source>
        <translation>Il n’y a pas de valeur, car les applications sont liées&#x202f;: l’équation est une autre.</translation>
    </message>
    <message>
        <source>There is no value, because the maps contract by too little to bound it.</source>
        <translation>Il n’y a pas de valeur, car les applications contractent trop peu pour la borner.</translation>
    </message>
    <message>
        <source>Open set condition</source>
        <translation>Condition de l’ensemble ouvert</translation>
    </message>
    <message>
        <source>Whether there is an open set with disjoint images in it. It is proved where the pieces are disjoint, where an area of the attractor is, and where the neighbours of pieces of one size are finitely many, and none of them coincides with its neighbour.</source>
        <translation>S’il existe un ensemble ouvert qui contient ses images et dont les images sont disjointes. C’est prouvé si les morceaux sont disjoints, s’il est prouvé que l’attracteur a une aire, ou si les morceaux d’une même taille ont un nombre fini de voisins et qu’aucun ne coïncide avec son voisin.</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Dimension de Hausdorff</translation>
    </message>
    <message>
        <source>Dimension of the attractor, where it is proved: the similarity dimension under the open set condition; or, where pieces coincide and there are finitely many neighbours, by the growth of the number of different maps.</source>
        <translation>Dimension de l’attracteur, là où elle est prouvée&#x202f;: la dimension de similitude sous la condition de l’ensemble ouvert&#x202f;; ou, si des morceaux coïncident et que les voisins sont en nombre fini, d’après la croissance du nombre d’applications différentes.</translation>
    </message>
    <message>
        <source>There is no value: it is not known how much the pieces overlap, or the maps are no similarities.</source>
        <translation>Il n’y a pas de valeur&#x202f;: on ignore dans quelle mesure les morceaux se chevauchent, ou les applications ne sont pas des similitudes.</translation>
    </message>
    <message>
        <source>Area of the attractor, if its copies, moved by a lattice and turned by a few turns, cover the plane equally often; proved by the contacts of the copies, or by counting those that hold a point.</source>
        <translation>Aire de l’attracteur si ses copies, translatées suivant un réseau et tournées de quelques angles, recouvrent partout le plan le même nombre de fois&#x202f;; prouvée par les contacts des copies ou en comptant celles qui contiennent un point.</translation>
    </message>
    <message>
        <source>There is no value: it is not proved that copies of the attractor cover the plane in this way.</source>
        <translation>Il n’y a pas de valeur&#x202f;: il n’est pas prouvé que des copies de l’attracteur recouvrent le plan de cette façon.</translation>
    </message>
    <message>
        <source>%1 (approximation)</source>
        <translation>%1 (approximation)</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Grab a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Prenez une fractale par les coins&#x202f;: un éditeur de systèmes de fonctions itérées.</translation>
    </message>
    <message>
        <source>.ifs files to open, each in its own window</source>
        <translation>Fichiers .ifs à ouvrir, chacun dans sa fenêtre</translation>
    </message>
    <message>
        <source>start with the maple instead of the last session</source>
        <translation>commencer par l’érable au lieu de la dernière session</translation>
    </message>
    <message>
        <source>open a window with the collection</source>
        <translation>ouvrir une fenêtre avec la collection</translation>
    </message>
    <message>
        <source>open a window with random fractals to choose from</source>
        <translation>ouvrir une fenêtre avec des fractales au hasard, à choisir</translation>
    </message>
    <message>
        <source>draw the maple to a PNG file instead; needs no display</source>
        <translation>dessiner plutôt l’érable dans un fichier PNG&#x202f;; ne demande pas d’écran</translation>
    </message>
    <message>
        <source>The system does not let Barycage start another thread. Close other programs, or raise the limit on processes, and try again.</source>
        <translation>Le système ne laisse pas Barycage démarrer un autre fil d’exécution. Fermez d’autres programmes ou augmentez la limite du nombre de processus, puis réessayez.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Il n’y a pas assez de mémoire pour cela.</translation>
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
        <source>Fronds: one large map climbs the rachis, two small ones attach the pinnae, and a flat one draws the stem.</source>
        <translation>Frondes&#x202f;: une grande application monte le long du rachis, deux petites y attachent les pennes, et une plate trace la tige.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Arbres</translation>
    </message>
    <message>
        <source>Forking trunks: the branches of the tree are copies of the whole tree.</source>
        <translation>Des troncs qui fourchent&#x202f;: les branches de l’arbre sont des copies de l’arbre entier.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Dragons</translation>
    </message>
    <message>
        <source>Paper-folding curves, and fractals of two or three rotating similarities.</source>
        <translation>Courbes de papier plié et fractales de deux ou trois similitudes avec rotation.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Famille de Sierpiński</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon made of smaller copies of itself, with holes between them.</source>
        <translation>Tamis et tapis&#x202f;: un polygone fait de copies plus petites de lui-même, avec des trous entre elles.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Famille de Koch</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment again and again, and the islands they enclose.</source>
        <translation>Des courbes construites en remplaçant un segment encore et encore, et les îles qu’elles entourent.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Spirales</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small maps that set beads along its path.</source>
        <translation>Une application qui tourne et réduit un peu, et de petites qui posent des perles le long de son chemin.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Feuilles et fleurs</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are rotated copies of one another.</source>
        <translation>Contours de feuilles, et fleurs dont les pétales se déduisent les uns des autres par rotation.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Pavages et reptuiles</translation>
    </message>
    <message>
        <source>Sets that tile the plane: rep-tiles, which are made of copies of themselves, and the central tiles of number systems.</source>
        <translation>Des ensembles qui pavent le plan&#x202f;: reptuiles, faites de copies d’elles-mêmes, et tuiles centrales de systèmes de numération.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Ensembles de Cantor et poussières</translation>
    </message>
    <message>
        <source>Sets with gaps at every scale: the points crowd together, but hardly any are connected.</source>
        <translation>Des ensembles lacunaires à toutes les échelles&#x202f;: les points se pressent, mais presque aucun n’est relié à un autre.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Cristaux et flocons de neige</translation>
    </message>
    <message>
        <source>Sets with the symmetry of snow crystals: five, six and more arms.</source>
        <translation>Des ensembles qui ont la symétrie des cristaux de neige&#x202f;: cinq, six branches et davantage.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Courbes et graphes</translation>
    </message>
    <message>
        <source>Graphs of unusual functions, smooth curves as attractors, and coordinates of space-filling curves.</source>
        <translation>Graphes de fonctions inhabituelles, courbes lisses en attracteurs et coordonnées de courbes remplissant le plan.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Abstraites</translation>
    </message>
    <message>
        <source>Affine patterns with no counterpart in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Motifs affines sans équivalent dans la nature&#x202f;: cousins du tamis, tissages, rosaces.</translation>
    </message>
    <message>
        <source>Polyhedra in space</source>
        <translation>Polyèdres dans l’espace</translation>
    </message>
    <message>
        <source>A polyhedron made of smaller copies of itself, one at each corner.</source>
        <translation>Un polyèdre fait de copies plus petites de lui-même, une à chaque sommet.</translation>
    </message>
    <message>
        <source>Sponges and cubes in space</source>
        <translation>Éponges et cubes dans l’espace</translation>
    </message>
    <message>
        <source>Cubes divided into smaller cubes, some of which are left out or turned.</source>
        <translation>Des cubes divisés en cubes plus petits, dont certains sont omis ou tournés.</translation>
    </message>
    <message>
        <source>Plants in space</source>
        <translation>Plantes dans l’espace</translation>
    </message>
    <message>
        <source>Fronds and trees with branches all around the stem.</source>
        <translation>Des frondes et des arbres aux branches tout autour de la tige.</translation>
    </message>
    <message>
        <source>Shells and corals in space</source>
        <translation>Coquilles et coraux dans l’espace</translation>
    </message>
    <message>
        <source>Helical shells, cones arranged by the golden angle, and corals with thick branches.</source>
        <translation>Des coquilles hélicoïdales, des cônes disposés selon l’angle d’or et des coraux aux branches épaisses.</translation>
    </message>
    <message>
        <source>Dragons in space</source>
        <translation>Dragons dans l’espace</translation>
    </message>
    <message>
        <source>Folded surfaces, and polyhedra whose copies are turned.</source>
        <translation>Des surfaces pliées et des polyèdres dont les copies sont tournées.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>Fractals that move: wind, folding, growing, morphs, endless zooms, and flights in space.</source>
        <translation>Des fractales qui bougent&#x202f;: vent, pliage, croissance, métamorphoses, zooms sans fin et vols dans l’espace.</translation>
    </message>
    <message>
        <source>Linked maps</source>
        <translation>Applications liées</translation>
    </message>
    <message>
        <source>Maps that may follow only certain maps: Penrose tiles, boundaries, and chaos games with rules.</source>
        <translation>Des applications qui ne peuvent en suivre que certaines&#x202f;: pavés de Penrose, frontières et jeux du chaos avec des règles.</translation>
    </message>
    <message>
        <source>Fractal transformations</source>
        <translation>Transformations fractales</translation>
    </message>
    <message>
        <source>Fractals coloured by a picture on another fractal; a double click opens both side by side.</source>
        <translation>Des fractales aux couleurs d’une image posée sur une autre&#x202f;; un double clic ouvre les deux côte à côte.</translation>
    </message>
</context>
<context>
    <name>CollectionNames</name>
    <message>
        <source>Maple</source>
        <translation>Érable</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Fleur</translation>
    </message>
    <message>
        <source>Maple in the wind</source>
        <translation>Érable au vent</translation>
    </message>
    <message>
        <source>Fern that unrolls</source>
        <translation>Fougère qui se déroule</translation>
    </message>
    <message>
        <source>Paper strip that folds to a dragon</source>
        <translation>Bande de papier qui se plie en dragon</translation>
    </message>
    <message>
        <source>Koch curve that grows spikes</source>
        <translation>Courbe de Koch à qui poussent des épines</translation>
    </message>
    <message>
        <source>Zoom into a flake without end</source>
        <translation>Zoom sans fin dans un flocon</translation>
    </message>
    <message>
        <source>Walk through a weaving flower</source>
        <translation>Promenade dans une fleur qui ondule</translation>
    </message>
    <message>
        <source>Tree in a storm</source>
        <translation>Arbre dans la tempête</translation>
    </message>
    <message>
        <source>Sea fan in the swell</source>
        <translation>Gorgone dans la houle</translation>
    </message>
    <message>
        <source>Bracts that breathe</source>
        <translation>Bractées qui respirent</translation>
    </message>
    <message>
        <source>Pentagons that turn in place</source>
        <translation>Pentagones qui tournent sur place</translation>
    </message>
    <message>
        <source>Menger sponge that turns</source>
        <translation>Éponge de Menger qui tourne</translation>
    </message>
    <message>
        <source>Flight into the Menger sponge</source>
        <translation>Vol dans l’éponge de Menger</translation>
    </message>
    <message>
        <source>Tree in space that sways</source>
        <translation>Arbre dans l’espace qui se balance</translation>
    </message>
    <message>
        <source>Snow star that becomes a fern of ice</source>
        <translation>Étoile de neige qui devient fougère de glace</translation>
    </message>
    <message>
        <source>Maple that becomes a fern</source>
        <translation>Érable qui devient fougère</translation>
    </message>
    <message>
        <source>Black spleenwort fern</source>
        <translation>Doradille noire</translation>
    </message>
    <message>
        <source>Maiden fern</source>
        <translation>Fougère des marais</translation>
    </message>
    <message>
        <source>Culcita fern</source>
        <translation>Fougère Culcita</translation>
    </message>
    <message>
        <source>Fishbone fern</source>
        <translation>Néphrolépis</translation>
    </message>
    <message>
        <source>Fiddlehead: a frond still curled</source>
        <translation>Crosse&#x202f;: une fronde encore enroulée</translation>
    </message>
    <message>
        <source>Bracken: opposite pinnae at the same height</source>
        <translation>Fougère aigle&#x202f;: pennes opposées à la même hauteur</translation>
    </message>
    <message>
        <source>Lady fern: alternate pinnae, a nodding tip</source>
        <translation>Fougère femelle&#x202f;: pennes alternes, pointe penchée</translation>
    </message>
    <message>
        <source>Maidenhair: a fan on a fine stalk</source>
        <translation>Capillaire&#x202f;: un éventail sur une tige fine</translation>
    </message>
    <message>
        <source>Ostrich fern: a shuttlecock plume</source>
        <translation>Fougère à l’autruche&#x202f;: un panache en volant</translation>
    </message>
    <message>
        <source>Golden fern: pinnae smaller by the golden ratio squared</source>
        <translation>Fougère d’or&#x202f;: pennes réduites selon le carré du nombre d’or</translation>
    </message>
    <message>
        <source>Moss: a frond of frond-like feathers</source>
        <translation>Mousse&#x202f;: une fronde de plumes semblables à des frondes</translation>
    </message>
    <message>
        <source>Fractal tree</source>
        <translation>Arbre fractal</translation>
    </message>
    <message>
        <source>Golden tree: branches of 1/phi at 60 degrees, just touching</source>
        <translation>Arbre d’or&#x202f;: branches de rapport 1/φ à 60°, qui se touchent tout juste</translation>
    </message>
    <message>
        <source>Stone pine: an umbrella of three boughs</source>
        <translation>Pin parasol&#x202f;: une ombrelle de trois branches</translation>
    </message>
    <message>
        <source>Spruce: whorls of drooping boughs</source>
        <translation>Épicéa&#x202f;: verticilles de branches tombantes</translation>
    </message>
    <message>
        <source>Willow: branches that bend down</source>
        <translation>Saule&#x202f;: branches qui retombent</translation>
    </message>
    <message>
        <source>Tree in the wind</source>
        <translation>Arbre au vent</translation>
    </message>
    <message>
        <source>Bonsai pine: flat cushions on a leaning trunk</source>
        <translation>Pin bonsaï&#x202f;: coussins plats sur un tronc penché</translation>
    </message>
    <message>
        <source>Cypress</source>
        <translation>Cyprès</translation>
    </message>
    <message>
        <source>Thorn bush: alternate twigs</source>
        <translation>Buisson épineux&#x202f;: rameaux alternes</translation>
    </message>
    <message>
        <source>Poplar: narrow and steep</source>
        <translation>Peuplier&#x202f;: étroit et dressé</translation>
    </message>
    <message>
        <source>Ternary tree: three halves, drawn with their branches</source>
        <translation>Arbre ternaire&#x202f;: trois moitiés dessinées avec leurs branches</translation>
    </message>
    <message>
        <source>Branching coral</source>
        <translation>Corail ramifié</translation>
    </message>
    <message>
        <source>H-tree: right angles all the way</source>
        <translation>Arbre en H&#x202f;: rien que des angles droits</translation>
    </message>
    <message>
        <source>Heighway dragon</source>
        <translation>Dragon de Heighway</translation>
    </message>
    <message>
        <source>Twindragon</source>
        <translation>Dragon jumeau</translation>
    </message>
    <message>
        <source>Levy dragon (C curve)</source>
        <translation>Dragon de Lévy (courbe du C)</translation>
    </message>
    <message>
        <source>Terdragon</source>
        <translation>Terdragon</translation>
    </message>
    <message>
        <source>Golden dragon</source>
        <translation>Dragon d’or</translation>
    </message>
    <message>
        <source>Tame twindragon</source>
        <translation>Dragon jumeau apprivoisé</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 100 degrees only</source>
        <translation>Courbe du dragon dépliée à 100° seulement</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 115 degrees</source>
        <translation>Courbe du dragon dépliée à 115°</translation>
    </message>
    <message>
        <source>C curve on triangles of 100 degrees</source>
        <translation>Courbe du C sur des triangles de 100°</translation>
    </message>
    <message>
        <source>Z dragon: the three strokes of a Z</source>
        <translation>Dragon en Z&#x202f;: les trois traits d’un Z</translation>
    </message>
    <message>
        <source>Sierpinski triangle</source>
        <translation>Triangle de Sierpiński</translation>
    </message>
    <message>
        <source>Right-angled Sierpinski triangle</source>
        <translation>Triangle rectangle de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski carpet</source>
        <translation>Tapis de Sierpiński</translation>
    </message>
    <message>
        <source>Vicsek fractal (saltire)</source>
        <translation>Fractale de Vicsek (sautoir)</translation>
    </message>
    <message>
        <source>Vicsek fractal (cross)</source>
        <translation>Fractale de Vicsek (croix)</translation>
    </message>
    <message>
        <source>Sierpinski pentagon</source>
        <translation>Pentagone de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski hexagon</source>
        <translation>Hexagone de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski heptagon</source>
        <translation>Heptagone de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski octagon</source>
        <translation>Octogone de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski dodecagon</source>
        <translation>Dodécagone de Sierpiński</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 3</source>
        <translation>Triangle de Pascal modulo 3</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 5</source>
        <translation>Triangle de Pascal modulo 5</translation>
    </message>
    <message>
        <source>Sierpinski pedal triangle</source>
        <translation>Triangle orthique de Sierpiński</translation>
    </message>
    <message>
        <source>Bedford-McMullen carpet</source>
        <translation>Tapis de Bedford-McMullen</translation>
    </message>
    <message>
        <source>Bedford-McMullen weave of 3 by 5 cells</source>
        <translation>Tissage de Bedford-McMullen de 3 sur 5 cases</translation>
    </message>
    <message>
        <source>Carpet of fifths with a cross-shaped hole</source>
        <translation>Tapis de cinquièmes percé d’une croix</translation>
    </message>
    <message>
        <source>Carpet of quarters with a square hole</source>
        <translation>Tapis de quarts percé d’un carré</translation>
    </message>
    <message>
        <source>Checkered carpet</source>
        <translation>Tapis en damier</translation>
    </message>
    <message>
        <source>Koch curve</source>
        <translation>Courbe de Koch</translation>
    </message>
    <message>
        <source>Koch snowflake, filled</source>
        <translation>Flocon de Koch plein</translation>
    </message>
    <message>
        <source>Cesaro curve of 85 degrees</source>
        <translation>Courbe de Cesàro à 85°</translation>
    </message>
    <message>
        <source>Quadratic Koch curve of five edges</source>
        <translation>Courbe de Koch quadratique à cinq segments</translation>
    </message>
    <message>
        <source>Minkowski sausage</source>
        <translation>Saucisse de Minkowski</translation>
    </message>
    <message>
        <source>Mandelbrot-Given curve</source>
        <translation>Courbe de Mandelbrot-Given</translation>
    </message>
    <message>
        <source>Ice fractal on a square</source>
        <translation>Fractale de glace sur un carré</translation>
    </message>
    <message>
        <source>Ice fractal with a pair of spikes</source>
        <translation>Fractale de glace à deux épines</translation>
    </message>
    <message>
        <source>Koch curve drawn on both sides</source>
        <translation>Courbe de Koch des deux côtés</translation>
    </message>
    <message>
        <source>Koch curve with peaks turned inwards</source>
        <translation>Courbe de Koch aux pics tournés vers l’intérieur</translation>
    </message>
    <message>
        <source>Pentigree</source>
        <translation>Pentigree</translation>
    </message>
    <message>
        <source>Pentadendrite</source>
        <translation>Pentadendrite</translation>
    </message>
    <message>
        <source>Edge of the Gosper island</source>
        <translation>Bord de l’île de Gosper</translation>
    </message>
    <message>
        <source>Spiral of spirals</source>
        <translation>Spirale de spirales</translation>
    </message>
    <message>
        <source>Swirl</source>
        <translation>Tourbillon</translation>
    </message>
    <message>
        <source>Galaxy with two arms</source>
        <translation>Galaxie à deux bras</translation>
    </message>
    <message>
        <source>Whorl of three-fold rosettes</source>
        <translation>Verticille de rosaces triples</translation>
    </message>
    <message>
        <source>Ram&apos;s horn</source>
        <translation>Corne de bélier</translation>
    </message>
    <message>
        <source>Whirl of pentagons</source>
        <translation>Tourbillon de pentagones</translation>
    </message>
    <message>
        <source>Double spiral between two eyes</source>
        <translation>Double spirale entre deux yeux</translation>
    </message>
    <message>
        <source>Spiral of feathers</source>
        <translation>Spirale de plumes</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a golden spiral</source>
        <translation>Nautile&#x202f;: des loges le long d’une spirale d’or</translation>
    </message>
    <message>
        <source>Sunflower: seeds at the golden angle</source>
        <translation>Tournesol&#x202f;: des graines à l’angle d’or</translation>
    </message>
    <message>
        <source>Shell: ribs that follow the turn</source>
        <translation>Coquille&#x202f;: des côtes qui suivent la rotation</translation>
    </message>
    <message>
        <source>Three spirals passing into one another</source>
        <translation>Trois spirales qui passent l’une dans l’autre</translation>
    </message>
    <message>
        <source>Maple leaf</source>
        <translation>Feuille d’érable</translation>
    </message>
    <message>
        <source>Pointed leaf</source>
        <translation>Feuille pointue</translation>
    </message>
    <message>
        <source>Poinsettia: five bracts</source>
        <translation>Poinsettia&#x202f;: cinq bractées</translation>
    </message>
    <message>
        <source>Edelweiss: eight woolly rays</source>
        <translation>Edelweiss&#x202f;: huit rayons laineux</translation>
    </message>
    <message>
        <source>Lily of six petals</source>
        <translation>Lis à six pétales</translation>
    </message>
    <message>
        <source>Oak leaf</source>
        <translation>Feuille de chêne</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Plume</translation>
    </message>
    <message>
        <source>Plane-tree leaf: five blades from one root</source>
        <translation>Feuille de platane&#x202f;: cinq lobes d’une même base</translation>
    </message>
    <message>
        <source>Dill umbel</source>
        <translation>Ombelle d’aneth</translation>
    </message>
    <message>
        <source>Thistle head</source>
        <translation>Capitule de chardon</translation>
    </message>
    <message>
        <source>Dandelion clock</source>
        <translation>Aigrette de pissenlit</translation>
    </message>
    <message>
        <source>Marigold: rings of petals</source>
        <translation>Souci&#x202f;: des couronnes de pétales</translation>
    </message>
    <message>
        <source>Ear of wheat</source>
        <translation>Épi de blé</translation>
    </message>
    <message>
        <source>Chair rep-tile (L tromino)</source>
        <translation>Reptuile de la chaise (tromino en L)</translation>
    </message>
    <message>
        <source>Golden bee (Ammann&apos;s chair)</source>
        <translation>Abeille d’or (chaise d’Ammann)</translation>
    </message>
    <message>
        <source>Gosper island</source>
        <translation>Île de Gosper</translation>
    </message>
    <message>
        <source>Quintet</source>
        <translation>Quintette</translation>
    </message>
    <message>
        <source>Eisenstein fractal</source>
        <translation>Fractale d’Eisenstein</translation>
    </message>
    <message>
        <source>Rauzy fractal (tribonacci)</source>
        <translation>Fractale de Rauzy (tribonacci)</translation>
    </message>
    <message>
        <source>Hokkaido tile</source>
        <translation>Tuile de Hokkaido</translation>
    </message>
    <message>
        <source>Tile of Narayana&apos;s cows</source>
        <translation>Tuile des vaches de Narayana</translation>
    </message>
    <message>
        <source>Tile of x^2 + x + 3</source>
        <translation>Tuile de x² + x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 3</source>
        <translation>Tuile de x² + 2x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 3 x + 3</source>
        <translation>Tuile de x² + 3x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 4</source>
        <translation>Tuile de x² + 2x + 4</translation>
    </message>
    <message>
        <source>Jigsaw square: nine thirds, one pushed out</source>
        <translation>Carré puzzle&#x202f;: neuf tiers, dont un poussé au-dehors</translation>
    </message>
    <message>
        <source>Numbers in base -2+i with digits 0 to 4</source>
        <translation>Nombres en base −2+i avec les chiffres de 0 à 4</translation>
    </message>
    <message>
        <source>Fudgeflake: three terdragons round a point</source>
        <translation>Fudgeflake&#x202f;: trois terdragons autour d’un point</translation>
    </message>
    <message>
        <source>Central tile of x^3 = 2 x^2 + x + 1</source>
        <translation>Tuile centrale de x³ = 2x² + x + 1</translation>
    </message>
    <message>
        <source>Penrose tiles</source>
        <translation>Pavés de Penrose</translation>
    </message>
    <message>
        <source>Penrose tiles, cracked</source>
        <translation>Pavés de Penrose fissurés</translation>
    </message>
    <message>
        <source>Parts of the Rauzy fractal</source>
        <translation>Parties de la fractale de Rauzy</translation>
    </message>
    <message>
        <source>Boundary of the dragon</source>
        <translation>Frontière du dragon</translation>
    </message>
    <message>
        <source>Boundary of the twindragon</source>
        <translation>Frontière du dragon jumeau</translation>
    </message>
    <message>
        <source>Golden mean carpet</source>
        <translation>Tapis du nombre d’or</translation>
    </message>
    <message>
        <source>Golden mean dragon</source>
        <translation>Dragon du nombre d’or</translation>
    </message>
    <message>
        <source>Restless pentagon</source>
        <translation>Pentagone sans repos</translation>
    </message>
    <message>
        <source>One-way square</source>
        <translation>Carré à sens unique</translation>
    </message>
    <message>
        <source>Neighbouring corners</source>
        <translation>Sommets voisins</translation>
    </message>
    <message>
        <source>Steps around a hexagon</source>
        <translation>Pas autour d’un hexagone</translation>
    </message>
    <message>
        <source>Steps around a pentagon</source>
        <translation>Pas autour d’un pentagone</translation>
    </message>
    <message>
        <source>Old and young</source>
        <translation>Vieilles et jeunes</translation>
    </message>
    <message>
        <source>Sunset in a triangle</source>
        <translation>Coucher de soleil dans un triangle</translation>
    </message>
    <message>
        <source>Triangle for the sunset</source>
        <translation>Triangle pour le coucher de soleil</translation>
    </message>
    <message>
        <source>Bent window</source>
        <translation>Vitrail courbé</translation>
    </message>
    <message>
        <source>Triangle for the glass</source>
        <translation>Triangle pour le vitrail</translation>
    </message>
    <message>
        <source>Tartan in a square</source>
        <translation>Tartan dans un carré</translation>
    </message>
    <message>
        <source>Square for the tartan</source>
        <translation>Carré pour le tartan</translation>
    </message>
    <message>
        <source>Grid of a square</source>
        <translation>Quadrillage d’un carré</translation>
    </message>
    <message>
        <source>Square for the grid</source>
        <translation>Carré pour le quadrillage</translation>
    </message>
    <message>
        <source>Rainbow fern</source>
        <translation>Fougère arc-en-ciel</translation>
    </message>
    <message>
        <source>Maple for the fern</source>
        <translation>Érable pour la fougère</translation>
    </message>
    <message>
        <source>Autumn maple</source>
        <translation>Érable d’automne</translation>
    </message>
    <message>
        <source>Square for the maple</source>
        <translation>Carré pour l’érable</translation>
    </message>
    <message>
        <source>Dragon of paper</source>
        <translation>Dragon de papier</translation>
    </message>
    <message>
        <source>Sheet for the dragon</source>
        <translation>Feuille de papier pour le dragon</translation>
    </message>
    <message>
        <source>Curve of waves</source>
        <translation>Courbe de vagues</translation>
    </message>
    <message>
        <source>Sheet for the curve</source>
        <translation>Feuille de papier pour la courbe</translation>
    </message>
    <message>
        <source>Koch curve across a square</source>
        <translation>Courbe de Koch à travers un carré</translation>
    </message>
    <message>
        <source>Square for the curve</source>
        <translation>Carré pour la courbe</translation>
    </message>
    <message>
        <source>Hilbert curve along a coast</source>
        <translation>Courbe de Hilbert le long d’une côte</translation>
    </message>
    <message>
        <source>Curve for the square</source>
        <translation>Courbe pour le carré</translation>
    </message>
    <message>
        <source>Broken picture</source>
        <translation>Image brisée</translation>
    </message>
    <message>
        <source>Square to break</source>
        <translation>Carré à briser</translation>
    </message>
    <message>
        <source>Gasket of a dragon</source>
        <translation>Tamis d’un dragon</translation>
    </message>
    <message>
        <source>Terdragon for the gasket</source>
        <translation>Terdragon pour le tamis</translation>
    </message>
    <message>
        <source>Cantor dust</source>
        <translation>Poussière de Cantor</translation>
    </message>
    <message>
        <source>Cantor comb: a Cantor set times an interval</source>
        <translation>Peigne de Cantor&#x202f;: un ensemble de Cantor fois un intervalle</translation>
    </message>
    <message>
        <source>Dust on a triangle</source>
        <translation>Poussière sur un triangle</translation>
    </message>
    <message>
        <source>Dust on a pentagon</source>
        <translation>Poussière sur un pentagone</translation>
    </message>
    <message>
        <source>Dust of unequal ratios</source>
        <translation>Poussière de rapports inégaux</translation>
    </message>
    <message>
        <source>Dust on an octagon</source>
        <translation>Poussière sur un octogone</translation>
    </message>
    <message>
        <source>Rings of dust</source>
        <translation>Anneaux de poussière</translation>
    </message>
    <message>
        <source>Tartan dust</source>
        <translation>Tartan de poussière</translation>
    </message>
    <message>
        <source>Pinwheel dust</source>
        <translation>Moulinet de poussière</translation>
    </message>
    <message>
        <source>Swirling dust of three</source>
        <translation>Poussière de trois copies qui tourbillonne</translation>
    </message>
    <message>
        <source>Hexaflake</source>
        <translation>Flocon hexagonal</translation>
    </message>
    <message>
        <source>Pentaflake</source>
        <translation>Flocon pentagonal</translation>
    </message>
    <message>
        <source>Stellar snowflake</source>
        <translation>Flocon en étoile</translation>
    </message>
    <message>
        <source>Fern-like snowflake</source>
        <translation>Flocon en fougère</translation>
    </message>
    <message>
        <source>Sectored plate</source>
        <translation>Plaquette de neige à secteurs</translation>
    </message>
    <message>
        <source>Needle snowflake</source>
        <translation>Flocon en aiguilles</translation>
    </message>
    <message>
        <source>Frost flower</source>
        <translation>Fleur de givre</translation>
    </message>
    <message>
        <source>Decaflake</source>
        <translation>Flocon décagonal</translation>
    </message>
    <message>
        <source>Pentagram flake</source>
        <translation>Flocon de pentagrammes</translation>
    </message>
    <message>
        <source>Quartz: four-fold lattice</source>
        <translation>Quartz&#x202f;: réseau d’ordre quatre</translation>
    </message>
    <message>
        <source>Crystal of two maps</source>
        <translation>Cristal de deux applications</translation>
    </message>
    <message>
        <source>Dendrite snowflake</source>
        <translation>Flocon dendritique</translation>
    </message>
    <message>
        <source>Eight-pointed star</source>
        <translation>Étoile à huit branches</translation>
    </message>
    <message>
        <source>Frost cross: squares turned by 45 degrees</source>
        <translation>Croix de givre&#x202f;: des carrés tournés de 45°</translation>
    </message>
    <message>
        <source>Takagi curve (blancmange)</source>
        <translation>Courbe de Takagi (du blanc-manger)</translation>
    </message>
    <message>
        <source>Quadratic Bezier arc by de Casteljau</source>
        <translation>Arc de Bézier quadratique selon de Casteljau</translation>
    </message>
    <message>
        <source>Devil&apos;s staircase</source>
        <translation>Escalier du diable</translation>
    </message>
    <message>
        <source>Okamoto function, a = 2/3 (Bourbaki&apos;s)</source>
        <translation>Fonction d’Okamoto, a = 2/3 (celle de Bourbaki)</translation>
    </message>
    <message>
        <source>Okamoto function, a = 5/6 (Perkins&apos;s)</source>
        <translation>Fonction d’Okamoto, a = 5/6 (celle de Perkins)</translation>
    </message>
    <message>
        <source>Kiesswetter curve</source>
        <translation>Courbe de Kiesswetter</translation>
    </message>
    <message>
        <source>Bolzano function</source>
        <translation>Fonction de Bolzano</translation>
    </message>
    <message>
        <source>Fractal interpolation of four points</source>
        <translation>Interpolation fractale de quatre points</translation>
    </message>
    <message>
        <source>Mountain skyline</source>
        <translation>Ligne de crête</translation>
    </message>
    <message>
        <source>First coordinate of Peano&apos;s curve</source>
        <translation>Première coordonnée de la courbe de Peano</translation>
    </message>
    <message>
        <source>Lebesgue&apos;s singular function, a = 0.3</source>
        <translation>Fonction singulière de Lebesgue, a = 0,3</translation>
    </message>
    <message>
        <source>Takagi curve and its mirror image</source>
        <translation>Courbe de Takagi et son image dans un miroir</translation>
    </message>
    <message>
        <source>Hilbert&apos;s four maps, shrunk so that the seams open</source>
        <translation>Les quatre applications de Hilbert, réduites jusqu’à ce que s’ouvrent les coutures</translation>
    </message>
    <message>
        <source>Relative of the Sierpinski triangle</source>
        <translation>Cousin du triangle de Sierpiński</translation>
    </message>
    <message>
        <source>Zigzag of two maps</source>
        <translation>Zigzag de deux applications</translation>
    </message>
    <message>
        <source>Coral</source>
        <translation>Corail</translation>
    </message>
    <message>
        <source>Rosette of three</source>
        <translation>Rosace de trois</translation>
    </message>
    <message>
        <source>Rosette of five</source>
        <translation>Rosace de cinq</translation>
    </message>
    <message>
        <source>Rosette of seven</source>
        <translation>Rosace de sept</translation>
    </message>
    <message>
        <source>Mandala of twelve</source>
        <translation>Mandala de douze</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Dentelle</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Tissage</translation>
    </message>
    <message>
        <source>Twigs: a turn and a mirror</source>
        <translation>Brindilles&#x202f;: une rotation et un miroir</translation>
    </message>
    <message>
        <source>Heather</source>
        <translation>Bruyère</translation>
    </message>
    <message>
        <source>Breaking wave</source>
        <translation>Vague déferlante</translation>
    </message>
    <message>
        <source>City seen from above</source>
        <translation>Ville vue d’en haut</translation>
    </message>
    <message>
        <source>Flames</source>
        <translation>Flammes</translation>
    </message>
    <message>
        <source>Hills in haze</source>
        <translation>Collines dans la brume</translation>
    </message>
    <message>
        <source>Knotwork: four copies turned by 45 degrees</source>
        <translation>Entrelacs&#x202f;: quatre copies tournées de 45°</translation>
    </message>
    <message>
        <source>Sea dragon</source>
        <translation>Dragon de mer</translation>
    </message>
    <message>
        <source>Kaleidoscope</source>
        <translation>Kaléidoscope</translation>
    </message>
    <message>
        <source>Sierpinski tetrahedron</source>
        <translation>Tétraèdre de Sierpiński</translation>
    </message>
    <message>
        <source>Octahedron flake</source>
        <translation>Flocon octaédrique</translation>
    </message>
    <message>
        <source>Sierpinski pyramid</source>
        <translation>Pyramide de Sierpiński</translation>
    </message>
    <message>
        <source>Icosahedron flake</source>
        <translation>Flocon icosaédrique</translation>
    </message>
    <message>
        <source>Dodecahedron flake</source>
        <translation>Flocon dodécaédrique</translation>
    </message>
    <message>
        <source>Cuboctahedron flake</source>
        <translation>Flocon cuboctaédrique</translation>
    </message>
    <message>
        <source>Menger sponge</source>
        <translation>Éponge de Menger</translation>
    </message>
    <message>
        <source>Mosely snowflake</source>
        <translation>Flocon de Mosely</translation>
    </message>
    <message>
        <source>Jerusalem cube</source>
        <translation>Cube de Jérusalem</translation>
    </message>
    <message>
        <source>Cross in space</source>
        <translation>Croix dans l’espace</translation>
    </message>
    <message>
        <source>Saltire in space</source>
        <translation>Sautoir dans l’espace</translation>
    </message>
    <message>
        <source>Cantor dust in space</source>
        <translation>Poussière de Cantor dans l’espace</translation>
    </message>
    <message>
        <source>Cube corner: seven of eight cubes</source>
        <translation>Coin de cube&#x202f;: sept cubes sur huit</translation>
    </message>
    <message>
        <source>Cube corners in mirrors</source>
        <translation>Coins de cube dans des miroirs</translation>
    </message>
    <message>
        <source>Quadratic Koch surface: cubes on squares</source>
        <translation>Surface de Koch quadratique&#x202f;: des cubes sur des carrés</translation>
    </message>
    <message>
        <source>Fern in space</source>
        <translation>Fougère dans l’espace</translation>
    </message>
    <message>
        <source>Tree with three boughs</source>
        <translation>Arbre à trois branches</translation>
    </message>
    <message>
        <source>Oak with a leader and four boughs</source>
        <translation>Chêne à une flèche et quatre branches</translation>
    </message>
    <message>
        <source>Fir: drooping whorls around a leader</source>
        <translation>Sapin&#x202f;: verticilles tombants autour d’une flèche</translation>
    </message>
    <message>
        <source>Poplar: pairs of steep twigs</source>
        <translation>Peuplier&#x202f;: paires de rameaux dressés</translation>
    </message>
    <message>
        <source>Umbel: six rays from the top of a stalk</source>
        <translation>Ombelle&#x202f;: six rayons au sommet d’une tige</translation>
    </message>
    <message>
        <source>Thuja: flat sprays turned by the golden angle</source>
        <translation>Thuya&#x202f;: rameaux plats tournés de l’angle d’or</translation>
    </message>
    <message>
        <source>Romanesco: cones on a cone, by the golden angle</source>
        <translation>Romanesco&#x202f;: des cônes sur un cône, selon l’angle d’or</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Chou-fleur</translation>
    </message>
    <message>
        <source>Turret shell</source>
        <translation>Turritelle</translation>
    </message>
    <message>
        <source>Top shell: whorls of whorls</source>
        <translation>Troque&#x202f;: des tours faits de tours</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a flat spiral</source>
        <translation>Nautile&#x202f;: des loges le long d’une spirale plane</translation>
    </message>
    <message>
        <source>Double helix that narrows to a point</source>
        <translation>Double hélice qui finit en pointe</translation>
    </message>
    <message>
        <source>Staghorn coral</source>
        <translation>Corail corne de cerf</translation>
    </message>
    <message>
        <source>Bush coral</source>
        <translation>Corail buissonnant</translation>
    </message>
    <message>
        <source>Sea fan: forks almost in one plane</source>
        <translation>Gorgone&#x202f;: des fourches presque dans un même plan</translation>
    </message>
    <message>
        <source>Allium: a ball of twelve stalks with alliums at their ends</source>
        <translation>Ail d’ornement&#x202f;: une boule de douze tiges portant chacune un ail</translation>
    </message>
    <message>
        <source>Dragon in space: each fold about another axis</source>
        <translation>Dragon dans l’espace&#x202f;: chaque pli autour d’un autre axe</translation>
    </message>
    <message>
        <source>C curve in space</source>
        <translation>Courbe du C dans l’espace</translation>
    </message>
    <message>
        <source>Terdragon in space</source>
        <translation>Terdragon dans l’espace</translation>
    </message>
    <message>
        <source>Tetrahedra, each turned by 60 degrees</source>
        <translation>Tétraèdres, chacun tourné de 60°</translation>
    </message>
    <message>
        <source>Cubes, each turned by 60 degrees</source>
        <translation>Cubes, chacun tourné de 60°</translation>
    </message>
    <message>
        <source>Octahedra, each turned by 45 degrees</source>
        <translation>Octaèdres, chacun tourné de 45°</translation>
    </message>
</context>
<context>
    <name>FirstChips</name>
    <message>
        <source>What to try next</source>
        <translation>Que tenter maintenant</translation>
    </message>
</context>
<context>
    <name>FirstMinute</name>
    <message>
        <source>Take a corner.</source>
        <translation>Attrapez un coin.</translation>
    </message>
    <message>
        <source>Make it sway</source>
        <translation>Le faire balancer</translation>
    </message>
    <message>
        <source>Grow variations</source>
        <translation>Cultiver des variations</translation>
    </message>
    <message>
        <source>Save a poster</source>
        <translation>Enregistrer une affiche</translation>
    </message>
</context>
<context>
    <name>FlameBanner</name>
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
        <source>In flame files, y points down. The flames were flipped so that they look the same here as in flame programs.</source>
        <translation>Dans les flammes, y croît vers le bas. Elles ont été retournées, pour avoir ici la même allure que dans les programmes de flammes.</translation>
    </message>
    <message>
        <source>Keep &amp;y As Written</source>
        <translation>Laisser &amp;y comme il est écrit</translation>
    </message>
    <message>
        <source>Uses the numbers as they are in the file. The picture is then upside down.</source>
        <translation>Prend les nombres des flammes tels qu’ils sont dans le texte. L’image est alors à l’envers.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Keep y as written</source>
        <translation>Laisser y comme il est écrit</translation>
    </message>
    <message>
        <source>Flip the flames</source>
        <translation>Retourner les flammes</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Show or hide the “%1” panel</source>
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
        <source>, %n of them could not be read and are kept unchanged</source>
        <translation>
            <numerusform>, dont %n qui n’a pas pu être lue et reste telle quelle</numerusform>
            <numerusform>, dont %n qui n’ont pas pu être lues et restent telles quelles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with warnings</source>
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
        <source>“%1” has unsaved changes.</source>
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
        <source>Another program has changed “%1” since you opened it.</source>
        <translation>«&#x202f;%1&#x202f;» a été modifié par un autre programme depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Saving overwrites the changes made by the other program.</source>
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
        <source>Revert to “%1” as it is on disk? Your changes since then will be lost.</source>
        <translation>Revenir à «&#x202f;%1&#x202f;» tel qu’il est sur le disque&#x202f;? Les modifications faites depuis seront perdues.</translation>
    </message>
    <message>
        <source>%1 could not be reloaded</source>
        <translation>Impossible de relire %1</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Aucun fichier récent</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Vider la liste</translation>
    </message>
    <message>
        <source>%1[*] — %2</source>
        <comment>file, entry</comment>
        <translation>%1[*] — %2</translation>
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
        <source>Save the file; entries that you did not edit stay unchanged, byte for byte</source>
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
        <source>Discard your changes and reload the file from disk</source>
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
        <source>The picture was copied to the clipboard.</source>
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
        <source>Undo the last edit</source>
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
        <source>Redo the last edit that was undone</source>
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
        <source>Rotate, scale, shear, reflect or move the whole fractal by exact amounts</source>
        <translation>Faire tourner, redimensionner, cisailler, réfléchir ou déplacer toute la fractale en saisissant des nombres</translation>
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
        <source>De&amp;fine Triangle</source>
        <translation>Définir un &amp;triangle</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Ajuster le simplexe canonique &amp;minimal</translation>
    </message>
    <message>
        <source>Fit the smallest isosceles right triangle with legs parallel to the axes around the attractor</source>
        <translation>Tenir l’attracteur par le plus petit triangle rectangle isocèle qui le contient</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>Return the cage to rest: the picture shows the code as it is</source>
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
        <source>Write the placement into the code: the picture stays, and the coefficients change</source>
        <translation>Intégrer le placement au code&#x202f;: l’image reste, les coefficients changent</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Extraire du code</translation>
    </message>
    <message>
        <source>Extract the placement from the code: the picture stays, and the code is rewritten for the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Extraire le placement du code&#x202f;: l’image reste, le code devient celui du triangle (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Rendre ré&amp;gulière</translation>
    </message>
    <message>
        <source>Move the vertices to the nearest regular polygon</source>
        <translation>Mettre les sommets sur le polygone régulier le plus proche</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>Forme &amp;affinement invariante…</translation>
    </message>
    <message>
        <source>Show every map as a matrix over the control triangle, with rows that sum to 1</source>
        <translation>Montrer chaque application comme une matrice stochastique par lignes relative au triangle de contrôle</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>P&amp;lacer</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code does not change</source>
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
        <source>Point the y axis down, as in window coordinates</source>
        <translation>Faire croître y vers le bas, comme dans les coordonnées d’une fenêtre</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas except the picture</source>
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
        <source>Make dragged vertices snap to this</source>
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
        <source>Fill the whole screen</source>
        <translation>Utiliser tout l’écran</translation>
    </message>
    <message>
        <source>How It Is Built</source>
        <translation>Construction de l’attracteur</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor being built: in steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Regarder l’attracteur se construire&#x202f;: par les étapes de l’algorithme déterministe, ou par le jeu du chaos</translation>
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
        <translation>&amp;Guide d’utilisation (en anglais)</translation>
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
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Grab a fractal by its corners: an editor for iterated function systems that describes their attractors in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Prenez une fractale par les coins&#x202f;: un éditeur de systèmes de fonctions itérées dont les attracteurs sont tenus par les coordonnées barycentriques d’un triangle de contrôle.&lt;/p&gt;&lt;p&gt;D’après E. Hadzieva et M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Licence MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>À propos de &amp;Qt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Visite guidée</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>Qu’est-ce que c’&amp;est&#x202f;?</translation>
    </message>
    <message>
        <source>Click anything to see what it does</source>
        <translation>Cliquez sur un élément pour lire à quoi il sert</translation>
    </message>
    <message>
        <source>Recovery Unavailable</source>
        <translation>Récupération impossible</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Autoriser les systèmes &amp;sans attracteur</translation>
    </message>
    <message>
        <source>Let a drag of maps continue where an attractor is no longer guaranteed</source>
        <translation>Laisser le glissement des applications continuer là où un attracteur n’est plus garanti</translation>
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
        <source>Show each map as its image of the cage, and drag it by its corners</source>
        <translation>Montrer chaque application comme son image de la cage et la faire glisser par ses coins</translation>
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
        <source>Click a point of the attractor and drag the branch that contains it</source>
        <translation>Cliquer sur un point de l’attracteur et faire glisser la branche qui le contient</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Your unsaved work was recovered nevertheless.</source>
        <translation>Le travail non enregistré est ici malgré tout.</translation>
    </message>
    <message>
        <source>%1 was not recovered. Barycage will offer it again at the next start.</source>
        <translation>%1 n’a pas été récupéré. Il sera proposé à nouveau au prochain démarrage.</translation>
    </message>
    <message>
        <source>Press Esc to bring back the menus and panels.</source>
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
        <source>Show only the canvas in full screen, for example on a projector; press Esc to return</source>
        <translation>Laisser tout l’écran au canevas, par exemple pour un projecteur&#x202f;; Échap ramène le reste</translation>
    </message>
    <message>
        <source>Add Ra&amp;ndom Fractal…</source>
        <translation>Ajouter une &amp;fractale aléatoire…</translation>
    </message>
    <message>
        <source>Only the Pi&amp;cture</source>
        <translation>&amp;Image seule</translation>
    </message>
    <message>
        <source>Ca&amp;mera</source>
        <translation>Ca&amp;méra</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Avant</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Précédent</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>De&amp;ssus</translation>
    </message>
    <message>
        <source>Look down (7 on the keypad)</source>
        <translation>Regarder vers le bas (7 sur le pavé numérique)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>Dess&amp;ous</translation>
    </message>
    <message>
        <source>Look up (Ctrl+7 on the keypad)</source>
        <translation>Regarder vers le haut (Ctrl+7 sur le pavé numérique)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrique</translation>
    </message>
    <message>
        <source>Look from a corner (Home)</source>
        <translation>Regarder depuis un coin (Origine)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspective</translation>
    </message>
    <message>
        <source>In the menu %1.</source>
        <translation>Dans le menu %1.</translation>
    </message>
    <message>
        <source>Shortcut: %1</source>
        <translation>Raccourci&#x202f;: %1</translation>
    </message>
    <message>
        <source>Tool Options</source>
        <translation>Options de l’outil</translation>
    </message>
    <message>
        <source>Show the options of the tool under the canvas</source>
        <translation>Afficher les options de l’outil sous le canevas</translation>
    </message>
    <message>
        <source>A bar with the options of the current tool, or a reminder of how to use it.</source>
        <translation>Une barre avec les options de l’outil en cours, ou un rappel de son emploi.</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>A&amp;pplications</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>Retourner &amp;horizontalement</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the vertical line through their centre</source>
        <translation>Retourner les applications sélectionnées par rapport à la verticale passant par leur centre</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>Retourner &amp;verticalement</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the horizontal line through their centre</source>
        <translation>Retourner les applications sélectionnées par rapport à l’horizontale passant par leur centre</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Left</source>
        <translation>Tourner de 90° à &amp;gauche</translation>
    </message>
    <message>
        <source>Rotate the selected maps counter-clockwise about their centre</source>
        <translation>Faire tourner les applications sélectionnées dans le sens inverse des aiguilles d’une montre autour de leur centre</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Right</source>
        <translation>Tourner de 90° à &amp;droite</translation>
    </message>
    <message>
        <source>Rotate the selected maps clockwise about their centre</source>
        <translation>Faire tourner les applications sélectionnées dans le sens des aiguilles d’une montre autour de leur centre</translation>
    </message>
    <message>
        <source>Ali&amp;gn Centres</source>
        <translation>&amp;Aligner les centres</translation>
    </message>
    <message>
        <source>In a &amp;Row</source>
        <translation>En &amp;ligne</translation>
    </message>
    <message>
        <source>Move the selected maps up or down until their centres are at the same height</source>
        <translation>Déplacer les applications sélectionnées vers le haut ou le bas jusqu’à ce que leurs centres soient à la même hauteur</translation>
    </message>
    <message>
        <source>In a &amp;Column</source>
        <translation>En &amp;colonne</translation>
    </message>
    <message>
        <source>Move the selected maps left or right until their centres are one below the other</source>
        <translation>Déplacer les applications sélectionnées vers la gauche ou la droite jusqu’à ce que leurs centres soient l’un sous l’autre</translation>
    </message>
    <message>
        <source>D&amp;istribute Centres</source>
        <translation>Répar&amp;tir les centres</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Horizontalement</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from left to right</source>
        <translation>Espacer également les centres des applications sélectionnées de gauche à droite</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>&amp;Verticalement</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from bottom to top</source>
        <translation>Espacer également les centres des applications sélectionnées de bas en haut</translation>
    </message>
    <message>
        <source>&amp;Fit to Corners</source>
        <translation>Placer aux &amp;coins</translation>
    </message>
    <message>
        <source>Move each selected map so that it leaves the nearest corner of the cage fixed</source>
        <translation>Déplacer chaque application sélectionnée jusqu’à ce qu’elle envoie le coin le plus proche de la cage sur lui-même</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Choisissez d’abord une application.</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Dupliquer les applications sélectionnées</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Supprimer les applications sélectionnées</translation>
    </message>
    <message>
        <source>Select all maps</source>
        <translation>Sélectionner toutes les applications</translation>
    </message>
    <message>
        <source>&amp;Duplicate Maps</source>
        <translation>&amp;Dupliquer les applications</translation>
    </message>
    <message>
        <source>D&amp;elete Maps</source>
        <translation>&amp;Supprimer les applications</translation>
    </message>
    <message>
        <source>Select &amp;All Maps</source>
        <translation>Sélectionner t&amp;outes les applications</translation>
    </message>
    <message>
        <source>Missing on disk</source>
        <translation>Absent du disque</translation>
    </message>
    <message>
        <source>“%1” has been deleted, renamed or moved since you opened it.</source>
        <translation>«&#x202f;%1&#x202f;» a été supprimé, renommé ou déplacé depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Saving creates it again in its old location.</source>
        <translation>L’enregistrement le recréera à son ancien emplacement.</translation>
    </message>
    <message>
        <source>Other names of the file (hard links) keep the old contents.</source>
        <translation>Les autres noms du fichier (liens physiques) gardent l’ancien contenu.</translation>
    </message>
    <message>
        <source>&amp;Lift to Space</source>
        <translation>É&amp;lever dans l’espace</translation>
    </message>
    <message>
        <source>Lift to Space</source>
        <translation>Élever dans l’espace</translation>
    </message>
    <message>
        <source>&amp;Flatten to the Plane</source>
        <translation>Aplatir dans le pla&amp;n</translation>
    </message>
    <message>
        <source>Flatten to the Plane</source>
        <translation>Aplatir dans le plan</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen, or a solid as a mesh for 3D printing</source>
        <translation>Exporte l’image en PNG, SVG ou PDF, cadrée comme à l’écran&#x202f;; un solide, aussi comme corps à imprimer</translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation>A&amp;nimation</translation>
    </message>
    <message>
        <source>A&amp;nimate</source>
        <translation>A&amp;nimer</translation>
    </message>
    <message>
        <source>Show the timeline under the canvas</source>
        <translation>Afficher la chronologie sous le canevas</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Play or stop the animation (Space on the canvas)</source>
        <translation>Lire ou arrêter l’animation (Espace sur le canevas)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>P&amp;revious Frame</source>
        <translation>Image p&amp;récédente</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Move the playhead back one frame</source>
        <translation>Reculer la tête de lecture d’une image</translation>
    </message>
    <message>
        <source>Ne&amp;xt Frame</source>
        <translation>Image &amp;suivante</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Move the playhead forward one frame</source>
        <translation>Avancer la tête de lecture d’une image</translation>
    </message>
    <message>
        <source>Pre&amp;vious Key</source>
        <translation>Clé pré&amp;cédente</translation>
    </message>
    <message>
        <source>Alt+,</source>
        <translation>Alt+,</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Déplacer la tête de lecture sur la clé précédente</translation>
    </message>
    <message>
        <source>Nex&amp;t Key</source>
        <translation>Clé suivan&amp;te</translation>
    </message>
    <message>
        <source>Alt+.</source>
        <translation>Alt+.</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Déplacer la tête de lecture sur la clé suivante</translation>
    </message>
    <message>
        <source>Set &amp;Key</source>
        <translation>Poser une cl&amp;é</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Key the current track at the playhead</source>
        <translation>Poser une clé de la piste actuelle à la tête de lecture</translation>
    </message>
    <message>
        <source>Set Keys of &amp;All Tracks</source>
        <translation>Poser des clés de to&amp;utes les pistes</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Key all tracks that have keys at the playhead, or all tracks if none has</source>
        <translation>Poser à la tête de lecture des clés de toutes les pistes qui en ont, ou de toutes si aucune n’en a</translation>
    </message>
    <message>
        <source>&amp;Delete Keys</source>
        <translation>Supprimer &amp;des clés</translation>
    </message>
    <message>
        <source>Delete the selected keys</source>
        <translation>Supprimer les clés sélectionnées</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Fractal &amp;Transformation</source>
        <translation>&amp;Transformation fractale</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Show another entry beside this one, and colour this one by a picture placed on the other</source>
        <translation>Afficher une autre entrée à côté de celle-ci et peindre celle-ci avec une image posée dessus</translation>
    </message>
    <message>
        <source>Export Ani&amp;mation…</source>
        <translation>Exporter l’ani&amp;mation…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Export the animation as a video, an animated image or frames, on this computer or on a cluster</source>
        <translation>Exporter l’animation en vidéo, en image animée ou en images, ici ou sur une grappe de calcul</translation>
    </message>
    <message>
        <source>Nothing moves in this entry yet. Choose a motion in the timeline first: Animation, Animate.</source>
        <translation>Rien ne bouge encore dans cette entrée. Choisissez d’abord un mouvement dans la chronologie&#x202f;: Animation, Animer.</translation>
    </message>
    <message>
        <source>A mesh needs a solid, and this entry lies in a plane: lift it to space first.</source>
        <translation>Un maillage demande un solide, et cette entrée est plane : élevez-la d’abord dans l’espace.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Liens</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Collage</translation>
    </message>
    <message>
        <source>Four &amp;Views</source>
        <translation>Quatre &amp;vues</translation>
    </message>
    <message>
        <source>Define the control triangle with three clicks, or in space the tetrahedron with four</source>
        <translation>Définit le triangle de contrôle par trois clics, dans l’espace le tétraèdre par quatre</translation>
    </message>
    <message>
        <source>Look from the front (1 on the keypad)</source>
        <translation>Regarder de devant (1 du pavé numérique)</translation>
    </message>
    <message>
        <source>Look from behind (Ctrl+1 on the keypad)</source>
        <translation>Regarder de derrière (Ctrl+1 du pavé numérique)</translation>
    </message>
    <message>
        <source>Look from the right (3 on the keypad)</source>
        <translation>Regarder de droite (3 du pavé numérique)</translation>
    </message>
    <message>
        <source>Look from the left (Ctrl+3 on the keypad)</source>
        <translation>Regarder de gauche (Ctrl+3 du pavé numérique)</translation>
    </message>
    <message>
        <source>&amp;Z Up</source>
        <translation>&amp;Z vers le haut</translation>
    </message>
    <message>
        <source>Point the z axis up, as in CAD programs; the fractal stays as it is</source>
        <translation>L’axe z pointe vers le haut, comme dans les logiciels de CAO&#x202f;; la fractale reste telle quelle</translation>
    </message>
    <message>
        <source>De&amp;fine Tetrahedron</source>
        <translation>Définir un &amp;tétraèdre</translation>
    </message>
    <message>
        <source>Select maps or entries first: in their panels, or on the canvas with the Maps tool.</source>
        <translation>Sélectionnez d’abord des applications ou des entrées&#x202f;: dans leurs panneaux, ou sur le canevas avec l’outil des applications.</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>Cou&amp;per</translation>
    </message>
    <message>
        <source>Move the selected maps or entries to the clipboard</source>
        <translation>Déplacer les applications ou les entrées sélectionnées dans le presse-papiers</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Add fractals from the clipboard to the file: entries of an .ifs file, flames or a table of numbers; or maps to the fractal</source>
        <translation>Ajouter au fichier des fractales du presse-papiers&#x202f;: entrées d’un fichier .ifs, flames ou tableau de nombres&#x202f;; ou des applications à la fractale</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate the selected maps or entries</source>
        <translation>Dupliquer les applications ou les entrées sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected maps or entries</source>
        <translation>Supprimer les applications ou les entrées sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Select All</source>
        <translation>Tout sélec&amp;tionner</translation>
    </message>
    <message>
        <source>Select all maps or all entries</source>
        <translation>Sélectionner toutes les applications ou toutes les entrées</translation>
    </message>
    <message>
        <source>Breed variations of this fractal, or cross it with another one</source>
        <translation>Élever des variations de cette fractale ou la croiser avec une autre</translation>
    </message>
    <message>
        <source>The Chaos Game</source>
        <translation>Le jeu du chaos</translation>
    </message>
    <message>
        <source>Why the Maple Fits Its Triangle</source>
        <translation>Pourquoi l’érable tient dans son triangle</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Leçon</translation>
    </message>
    <message>
        <source>&amp;Play Lesson</source>
        <translation>&amp;Jouer la leçon</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>Étape &amp;suivante</translation>
    </message>
    <message>
        <source>Show the next step of the lesson being played</source>
        <translation>Montrer l’étape suivante de la leçon en cours</translation>
    </message>
    <message>
        <source>Previous &amp;Step</source>
        <translation>Étape &amp;précédente</translation>
    </message>
    <message>
        <source>Show the previous step of the lesson being played</source>
        <translation>Montrer l’étape précédente de la leçon en cours</translation>
    </message>
    <message>
        <source>&amp;Add Step</source>
        <translation>A&amp;jouter une étape</translation>
    </message>
    <message>
        <source>Add a step to the lesson, with the current state of the window</source>
        <translation>Ajouter à la leçon une étape avec l’état actuel de la fenêtre</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>&amp;Enregistrer la leçon…</translation>
    </message>
    <message>
        <source>The step now has the current state of the window.</source>
        <translation>L’étape a maintenant l’état de la fenêtre.</translation>
    </message>
    <message>
        <source>End the lesson before you save (Esc).</source>
        <translation>Terminez la leçon avant d’enregistrer (Échap).</translation>
    </message>
    <message>
        <source>Play this lesson, in a window of its own if this one is in use</source>
        <translation>Jouer cette leçon, dans une fenêtre à part si celle-ci sert déjà</translation>
    </message>
    <message>
        <source>Unsaved lesson</source>
        <translation>Leçon non enregistrée</translation>
    </message>
    <message>
        <source>The lesson “%1” has unsaved changes.</source>
        <translation>La leçon «&#x202f;%1&#x202f;» contient des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The lesson was not saved</source>
        <translation>La leçon n’a pas été enregistrée</translation>
    </message>
    <message>
        <source>Lessons (*.lesson)</source>
        <translation>Leçons (*.lesson)</translation>
    </message>
    <message>
        <source>The fractals have unsaved changes.</source>
        <translation>Les fractales contiennent des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Step %1 has the current state of the window. Now write its text.</source>
        <translation>L’étape %1 a l’état de la fenêtre. Écrivez son texte.</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Instantanés</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exports</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>&amp;Ready-Made Lessons</source>
        <translation>Leçons prê&amp;tes</translation>
    </message>
    <message>
        <source>Re&amp;name Map</source>
        <translation>Re&amp;nommer l’application</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Donner un nom à l’application courante</translation>
    </message>
    <message>
        <source>Loc&amp;k or Unlock Maps</source>
        <translation>&amp;Verrouiller ou déverrouiller les applications</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing, or unlock them</source>
        <translation>Protéger les applications sélectionnées des modifications, ou cesser de le faire</translation>
    </message>
    <message>
        <source>Show Map Al&amp;one</source>
        <translation>Afficher l’applicati&amp;on seule</translation>
    </message>
    <message>
        <source>Show the current map alone, or all of them again</source>
        <translation>Afficher seule l’application courante, ou de nouveau toutes</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>V&amp;ues enregistrées</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>&amp;Enregistrer la vue…</translation>
    </message>
    <message>
        <source>Keep what the canvas shows under a name, with the fractal</source>
        <translation>Garder sous un nom, avec la fractale, ce que montre le canevas</translation>
    </message>
    <message>
        <source>&amp;Edit Views…</source>
        <translation>&amp;Modifier les vues…</translation>
    </message>
    <message>
        <source>Go to saved views, rename or delete them</source>
        <translation>Aller aux vues enregistrées, les renommer ou les supprimer</translation>
    </message>
    <message>
        <source>No saved views</source>
        <translation>Aucune vue enregistrée</translation>
    </message>
    <message>
        <source>Views that you save are listed here.</source>
        <translation>Les vues que vous enregistrez sont listées ici.</translation>
    </message>
    <message>
        <source>Show this part of the fractal again</source>
        <translation>Montrer de nouveau cette partie de la fractale</translation>
    </message>
    <message>
        <source>Save the view “%1”</source>
        <translation>Enregistrer la vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Print &amp;Handout…</source>
        <translation>Imprimer une &amp;fiche pour la classe…</translation>
    </message>
    <message>
        <source>Print entries for a class: pictures with cage, maps and formulas, or a blank worksheet</source>
        <translation>Imprimer des entrées pour la classe&#x202f;: images avec cage, applications et formules, ou une feuille d’exercices vierge</translation>
    </message>
    <message>
        <source>Copy as La&amp;TeX</source>
        <translation>Copier en &amp;LaTeX</translation>
    </message>
    <message>
        <source>&amp;Table of Maps</source>
        <translation>&amp;Tableau des applications</translation>
    </message>
    <message>
        <source>Copy the coefficients as a tabular</source>
        <translation>Copier les coefficients en tabular</translation>
    </message>
    <message>
        <source>&amp;Formulas with Matrices</source>
        <translation>&amp;Formules avec matrices</translation>
    </message>
    <message>
        <source>Copy each map as a matrix and a vector</source>
        <translation>Copier chaque application comme matrice et vecteur</translation>
    </message>
    <message>
        <source>&amp;Affine Invariant Form</source>
        <translation>Forme &amp;affinement invariante</translation>
    </message>
    <message>
        <source>Copy one matrix per map, in barycentric coordinates of the triangle</source>
        <translation>Copier une matrice par application, en coordonnées barycentriques du triangle</translation>
    </message>
    <message>
        <source>Fi&amp;gure (TikZ)</source>
        <translation>Fi&amp;gure (TikZ)</translation>
    </message>
    <message>
        <source>Copy the cage and its images under the maps, with numbers and fixed points, as shown on the canvas</source>
        <translation>Copier la cage et ses images par les applications, avec numéros et points fixes, comme affichées</translation>
    </message>
    <message>
        <source>Copied. The document needs %1.</source>
        <translation>Copié. Le document a besoin de %1.</translation>
    </message>
    <message>
        <source>Map numbers</source>
        <translation>Numéros</translation>
    </message>
    <message>
        <source>&amp;Numbers of Maps</source>
        <translation>Numéros &amp;des applications</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Show the number and the fixed point of each map</source>
        <translation>Afficher le numéro et le point fixe de chaque application</translation>
    </message>
    <message>
        <source>Rotate View &amp;Left</source>
        <translation>Faire pivoter la vue à &amp;gauche</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate the view counter-clockwise by 15°</source>
        <translation>Tourner de 15° dans le sens inverse des aiguilles d’une montre ce que montre le canevas</translation>
    </message>
    <message>
        <source>Rotate View &amp;Right</source>
        <translation>Faire pivoter la vue à &amp;droite</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>Rotate the view clockwise by 15°</source>
        <translation>Tourner de 15° dans le sens des aiguilles d’une montre ce que montre le canevas</translation>
    </message>
    <message>
        <source>Re&amp;set Rotation</source>
        <translation>&amp;Annuler la rotation</translation>
    </message>
    <message>
        <source>Return the view to upright</source>
        <translation>Redresser la vue</translation>
    </message>
    <message>
        <source>Side &amp;by Side</source>
        <translation>&amp;Côte à côte</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Show another entry beside this one, to compare and edit both</source>
        <translation>Afficher une autre entrée à côté de celle-ci, pour comparer et modifier les deux</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Copié.</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Retrouver…</translation>
    </message>
    <message>
        <source>Find “%1”</source>
        <translation>Retrouver «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs *.par)</source>
        <translation>Collections Fractint (*.ifs *.par)</translation>
    </message>
    <message>
        <source>The lesson now refers to %1. Save the lesson to keep this change.</source>
        <translation>La leçon appartient maintenant à %1. Enregistrez-la pour que cela reste ainsi.</translation>
    </message>
    <message>
        <source>The fractal transformation was hidden to show how the attractor is built.</source>
        <translation>La transformation fractale a été masquée pour montrer comment l’attracteur se construit.</translation>
    </message>
    <message>
        <source>Add a third dimension to every map; the picture stays flat until you move a map</source>
        <translation>Ajoute une troisième dimension à chaque application&#x202f;; l’image reste plane tant que vous ne déplacez pas d’application</translation>
    </message>
    <message>
        <source>Replace the solid by its projection along the first axis that every map keeps</source>
        <translation>Remplace le solide par sa projection le long du premier axe que chaque application conserve</translation>
    </message>
    <message>
        <source>Plays this lesson in full screen, with its text next to the picture. Page Down and Page Up go to the next and the previous step. Esc ends the lesson.</source>
        <translation>Joue cette leçon en plein écran, avec son texte à côté de l’image. Page suivante et Page précédente mènent à l’étape suivante et à la précédente. Échap termine la leçon.</translation>
    </message>
    <message>
        <source>Make distant parts look smaller (5 on the keypad)</source>
        <translation>Montrer plus petites les parties éloignées (5 sur le pavé numérique)</translation>
    </message>
    <message>
        <source>Snapshots are not saved with the file and will be lost: %1. To keep one, cancel and choose Add as Entry in the Snapshots panel.</source>
        <translation>Les instantanés ne sont pas enregistrés avec le fichier et seront perdus&#x202f;: %1. Pour en garder un, annulez et choisissez «&#x202f;Ajouter comme entrée&#x202f;» dans le panneau Instantanés.</translation>
    </message>
    <message>
        <source>The target in the Collage panel is not saved with the file.</source>
        <translation>La cible du panneau «&#x202f;Collage&#x202f;» n’est pas enregistrée avec le fichier.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Jouer la leçon sur tout l’écran, depuis le début ou à partir de l’étape sur laquelle vous avez cliqué dans la liste</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Abandonner</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>The lesson has unsaved changes.</source>
        <translation>La leçon a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Enregistrer la leçon comme un texte qui désigne ses fractales</translation>
    </message>
    <message>
        <source>Sa&amp;ve Lesson As…</source>
        <translation>Enregistrer la leçon so&amp;us…</translation>
    </message>
    <message>
        <source>Save the lesson under another name or in another folder</source>
        <translation>Enregistrer la leçon sous un autre nom ou dans un autre dossier</translation>
    </message>
    <message>
        <source>The lesson names no file of fractals (“file: name.ifs”).</source>
        <translation>La leçon ne nomme aucun fichier de fractales («&#x202f;file: nom.ifs&#x202f;»).</translation>
    </message>
    <message>
        <source>The file of its fractals, “%1”, was not found. It may have been renamed or moved.</source>
        <translation>Le fichier de ses fractales, «&#x202f;%1&#x202f;», est introuvable. Il a peut-être été renommé ou déplacé.</translation>
    </message>
    <message>
        <source>Save Lesson</source>
        <translation>Enregistrer la leçon</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. Save the fractals as a .ifs file first, with no : * ? &quot; &lt; &gt; | in its name and folders.</source>
        <translation>Une leçon ne peut pas désigner «&#x202f;%1&#x202f;». Enregistrez d’abord les fractales dans un fichier .ifs, sans : * ? &quot; &lt; &gt; | dans son nom ni dans ses dossiers.</translation>
    </message>
    <message>
        <source>If you discard the changes, the snapshots of them will be lost, too: %1.</source>
        <translation>Si vous abandonnez les modifications, leurs instantanés seront perdus aussi&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Unsaved snapshots</source>
        <translation>Instantanés non enregistrés</translation>
    </message>
    <message>
        <source>“%1” has snapshots that are not saved.</source>
        <translation>«&#x202f;%1&#x202f;» contient des instantanés non enregistrés.</translation>
    </message>
    <message>
        <source>Revert to “%1” as it is on disk?</source>
        <translation>Revenir à «&#x202f;%1&#x202f;» tel qu’il est sur le disque&#x202f;?</translation>
    </message>
    <message>
        <source>Replace the view “%1”</source>
        <translation>Remplacer la vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Drag the corners of the cage</source>
        <translation>Faire glisser les coins de la cage</translation>
    </message>
    <message>
        <source>Show the solid from the top, the front and the right, and in perspective</source>
        <translation>Montrer le solide de dessus, de face, de droite et en perspective</translation>
    </message>
    <message>
        <source>%1 names a file outside its folder.</source>
        <translation>%1 désigne un fichier hors de son dossier.</translation>
    </message>
    <message>
        <source>Its fractals are in “%1”. Open that file only if you trust the lesson.</source>
        <translation>Ses fractales sont dans «&#x202f;%1&#x202f;». N’ouvrez ce fichier que si vous avez confiance en la leçon.</translation>
    </message>
    <message>
        <source>&amp;Open It</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Save a Copy for Other Programs</source>
        <translation>Enregistrer une copie pour d’autres programmes</translation>
    </message>
    <message>
        <source>A copy needs another name than the file itself.</source>
        <translation>Une copie doit porter un autre nom que le fichier lui-même.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Enregistrement de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>Saved the copy %1.</source>
        <translation>La copie %1 est enregistrée.</translation>
    </message>
    <message>
        <source>Other programs still draw these entries differently: %1.</source>
        <translation>D’autres programmes dessinent toujours autrement ces entrées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Save a Copy &amp;for Other Programs…</source>
        <translation>Enregistrer une copie &amp;pour d’autres programmes…</translation>
    </message>
    <message>
        <source>Save a copy with the placements written into the code and every map listed, so that other programs draw what you see</source>
        <translation>Enregistrer une copie où les placements sont intégrés au code et toutes les applications énumérées, pour que d’autres programmes dessinent ce que vous voyez</translation>
    </message>
    <message>
        <source>The previous version is %1.</source>
        <translation>La version précédente est %1.</translation>
    </message>
    <message>
        <source>The previous version was not kept: there is already a file %1 that Barycage did not make.</source>
        <translation>La version précédente n’a pas été conservée&#x202f;: il existe déjà un fichier %1 que Barycage n’a pas créé.</translation>
    </message>
    <message>
        <source>The previous version could not be kept as %1.</source>
        <translation>La version précédente n’a pas pu être conservée sous le nom %1.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n files?</source>
        <translation>
            <numerusform>Ouvrir %n fichier&#x202f;?</numerusform>
            <numerusform>Ouvrir %n fichiers&#x202f;?</numerusform>
        </translation>
    </message>
    <message>
        <source>Each of them opens in a window of its own.</source>
        <translation>Chacun s’ouvre dans sa propre fenêtre.</translation>
    </message>
    <message>
        <source>Open &amp;All</source>
        <translation>Tout &amp;ouvrir</translation>
    </message>
    <message>
        <source>Open the &amp;First %1</source>
        <translation>Ouvrir les %1 &amp;premiers</translation>
    </message>
    <message>
        <source>Opening files…</source>
        <translation>Ouverture des fichiers…</translation>
    </message>
    <message>
        <source>%1 is also open in another window of Barycage. Whichever saves last replaces what the other saved.</source>
        <translation>%1 est aussi ouvert dans une autre fenêtre de Barycage. La dernière à enregistrer remplace ce que l’autre a enregistré.</translation>
    </message>
    <message>
        <source>Export Web Page</source>
        <translation>Exporter une page web</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>%1 was written. Open it in a browser, or mail it: it needs no network.</source>
        <translation>%1 est écrite. Ouvrez-la dans un navigateur, ou envoyez-la par courriel&#x202f;: elle n’a pas besoin de réseau.</translation>
    </message>
    <message>
        <source>Stretch Ke&amp;ys…</source>
        <translation>Étir&amp;er les clés…</translation>
    </message>
    <message>
        <source>Make a range of frames slower or faster: the keys of all tracks spread</source>
        <translation>Ralentit ou accélère un intervalle&#x202f;: les clés de toutes les pistes se répartissent</translation>
    </message>
    <message>
        <source>There are no keys to stretch. Choose Set Key first.</source>
        <translation>Il n’y a pas de clés à étirer. Posez d’abord une clé.</translation>
    </message>
    <message>
        <source>Copy the picture, the selected maps or the selected entries</source>
        <translation>Copie l’image, les applications sélectionnées ou les entrées sélectionnées</translation>
    </message>
    <message>
        <source>Export We&amp;b Page…</source>
        <translation>Exporter une page we&amp;b…</translation>
    </message>
    <message>
        <source>Export the fractal in its cage as one file for browsers, in which it can be dragged</source>
        <translation>Exporter la fractale dans sa cage en un seul fichier pour navigateurs, où l’on peut la manipuler</translation>
    </message>
    <message>
        <source>Six short steps that you do yourself: drag, squeeze, undo, collection, wind, export</source>
        <translation>Six courtes étapes que vous faites vous-même&#x202f;: glisser, écraser, annuler, collection, vent, export</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Show a centre and height, the point of an address, or a fixed point</source>
        <translation>Montre un centre et une hauteur, le point d’une adresse ou un point fixe</translation>
    </message>
    <message>
        <source>Language, theme, picture quality, shortcuts, and what opens at startup</source>
        <translation>Langue, thème, qualité de l’image, raccourcis et ce qui s’ouvre au démarrage</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>&amp;Variations…</translation>
    </message>
    <message>
        <source>S&amp;hadow</source>
        <translation>Om&amp;bre</translation>
    </message>
    <message>
        <source>Lay a flat, dark copy of the picture on the ground behind it</source>
        <translation>Étendre au sol, derrière l’image, une copie plate et sombre</translation>
    </message>
    <message>
        <source>Add a shadow</source>
        <translation>Ajouter une ombre</translation>
    </message>
    <message>
        <source>Remove the shadow</source>
        <translation>Retirer l’ombre</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>&amp;Keys and Frames</source>
        <translation>&amp;Clés et images</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Branche</translation>
    </message>
    <message>
        <source>M&amp;ore</source>
        <translation>&amp;Plus</translation>
    </message>
    <message>
        <source>D&amp;iscover</source>
        <translation>Décou&amp;vrir</translation>
    </message>
    <message>
        <source>&amp;Collection</source>
        <translation>&amp;Collection</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Search the fractals that come with the program, and your favourites</source>
        <translation>Chercher parmi les fractales fournies avec le programme et vos favorites</translation>
    </message>
    <message>
        <source>S&amp;napshots</source>
        <translation>I&amp;nstantanés</translation>
    </message>
    <message>
        <source>&amp;Fractal</source>
        <translation>&amp;Fractale</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>&amp;Selected Maps</source>
        <translation>Applications &amp;sélectionnées</translation>
    </message>
    <message>
        <source>&amp;Teach</source>
        <translation>&amp;Enseigner</translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation>&amp;Naviguer</translation>
    </message>
    <message>
        <source>&amp;Go To…</source>
        <translation>&amp;Aller à…</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Zone de dessin</translation>
    </message>
    <message>
        <source>How It Is &amp;Built</source>
        <translation>Construction de l’attrac&amp;teur</translation>
    </message>
    <message>
        <source>Web page written</source>
        <translation>Page web enregistrée</translation>
    </message>
    <message>
        <source>Copy &amp;Link</source>
        <translation>Copier le l&amp;ien</translation>
    </message>
    <message>
        <source>Copy a link that holds the fractal: Barycage opens it when it is pasted</source>
        <translation>Copier un lien qui contient la fractale&#x202f;: Barycage l’ouvre quand on le colle</translation>
    </message>
    <message>
        <source>The link was copied to the clipboard. It holds the whole fractal.</source>
        <translation>Le lien a été copié dans le presse-papiers. Il contient toute la fractale.</translation>
    </message>
    <message>
        <source>Hidden in this small window: %1 (View › Panels).</source>
        <translation>Masqués dans cette petite fenêtre&#x202f;: %1 (Affichage › Panneaux).</translation>
    </message>
    <message>
        <source>Pr&amp;int Lesson…</source>
        <translation>&amp;Imprimer la leçon…</translation>
    </message>
    <message>
        <source>Print the steps of the lesson, with their pictures and texts</source>
        <translation>Imprimer les étapes de la leçon, avec leurs images et leurs textes</translation>
    </message>
    <message>
        <source>Copy as &amp;Python</source>
        <translation>Copier en P&amp;ython</translation>
    </message>
    <message>
        <source>Copy lines for a notebook that make the fractal with the Python package “barycage”</source>
        <translation>Copier des lignes pour un notebook, qui créent la fractale avec le paquet Python «&#xa0;barycage&#xa0;»</translation>
    </message>
    <message>
        <source>Files with fractals (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures with an embedded fractal (*.png *.svg);;Lessons (*.lesson);;All files (*)</source>
        <translation>Fichiers avec des fractales (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Collections Fractint (*.ifs *.par);;Flammes (*.flame *.flam3);;Tableaux de nombres (*.csv *.tsv *.txt);;Images contenant leur fractale (*.png *.svg);;Leçons (*.lesson);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The lesson is not saved yet: choose Save Lesson.</source>
        <translation>La leçon n’est pas encore enregistrée&#x202f;: choisissez Enregistrer la leçon.</translation>
    </message>
    <message>
        <source>laser plotter cutter engrave dxf outline millimetres millimeters</source>
        <translation>laser traceur découpe découper graver contour millimètres</translation>
    </message>
    <message>
        <source>Copy saved</source>
        <translation>Copie enregistrée</translation>
    </message>
    <message>
        <source>%1 was saved for other programs.</source>
        <translation>%1 a été enregistré pour d’autres programmes.</translation>
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
        <source>“%1” is not a number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>«&#x202f;%1&#x202f;» est un nombre trop grand.</translation>
    </message>
    <message>
        <source>“%1” has no finite value.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas de valeur finie.</translation>
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
        <source>Saving “%1” was cancelled. The file on disk is unchanged.</source>
        <translation>L’enregistrement de «&#x202f;%1&#x202f;» a été annulé. Le fichier sur le disque est resté tel quel.</translation>
    </message>
    <message>
        <source>Adjust Picture Paths</source>
        <translation>Adapter les chemins des images</translation>
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
    <message>
        <source>%1 Glow</source>
        <translation>Lueur %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>De %1 à %2</translation>
    </message>
    <message>
        <source>%1 into %2</source>
        <translation>%1 contre %2</translation>
    </message>
    <message>
        <source>%1 Spectrum</source>
        <translation>Spectre depuis %1</translation>
    </message>
    <message>
        <source>%1 Pastel</source>
        <translation>Pastel %1</translation>
    </message>
    <message>
        <source>%1 Metal</source>
        <translation>Métal %1</translation>
    </message>
    <message>
        <source>%1 Bands</source>
        <translation>Bandes %1</translation>
    </message>
    <message>
        <source>%1 Ink</source>
        <translation>Encre %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1 Twilight</source>
        <translation>Crépuscule %1</translation>
    </message>
    <message>
        <source>%1 Wheel</source>
        <translation>Roue depuis %1</translation>
    </message>
    <message>
        <source>Rose</source>
        <translation>Rose</translation>
    </message>
    <message>
        <source>Crimson</source>
        <translation>Cramoisi</translation>
    </message>
    <message>
        <source>Scarlet</source>
        <translation>Écarlate</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Vermillon</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Ambre</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>Or</translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation>Citron</translation>
    </message>
    <message>
        <source>Lime</source>
        <translation>Citron vert</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>Herbe</translation>
    </message>
    <message>
        <source>Emerald</source>
        <translation>Émeraude</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>Jade</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>Sarcelle</translation>
    </message>
    <message>
        <source>Sea</source>
        <translation>Mer</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Ciel</translation>
    </message>
    <message>
        <source>Azure</source>
        <translation>Azur</translation>
    </message>
    <message>
        <source>Cobalt</source>
        <translation>Cobalt</translation>
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
        <translation>Violet</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Pourpre</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Fuchsia</source>
        <translation>Fuchsia</translation>
    </message>
</context>
<context>
    <name>PlacementBanner</name>
    <message>
        <source>Saved with dragged corners</source>
        <translation>Enregistré avec des sommets déplacés</translation>
    </message>
    <message>
        <source>Other programs will show “%1” without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>D’autres programmes montreront «&#x202f;%1&#x202f;» sans les sommets que vous avez déplacés, conservés dans des commentaires. Intégrer au code les inscrit dans les nombres que lit tout programme.</translation>
    </message>
    <message numerus="yes">
        <source>Other programs will show %n entries without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>
            <numerusform>D’autres programmes montreront %n entrée sans les sommets que vous avez déplacés, conservés dans des commentaires. Intégrer au code les inscrit dans les nombres que lit tout programme.</numerusform>
            <numerusform>D’autres programmes montreront %n entrées sans les sommets que vous avez déplacés, conservés dans des commentaires. Intégrer au code les inscrit dans les nombres que lit tout programme.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Intégrer au code</translation>
    </message>
    <message>
        <source>Writes the placements into the code, as one step of the history.</source>
        <translation>Écrit les placements dans le code&#x202f;: une étape de l’historique.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Bake the placements into the code</source>
        <translation>Intégrer les placements au code</translation>
    </message>
    <message>
        <source>Not baked, because no code has this picture or keys move it: %1.</source>
        <translation>Non intégré, parce qu’aucun code ne donne cette image ou que des images clés la déplacent&#x202f;: %1.</translation>
    </message>
    <message>
        <source>This cage cannot be baked: it bends or flattens the picture, or keys move it.</source>
        <translation>Cette cage ne peut pas être intégrée au code&#x202f;: elle courbe ou aplatit l’image, ou des clés la déplacent.</translation>
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
        <source>In the last session, Barycage ended before this work was saved:</source>
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
        <source>Unsaved work cannot be kept for recovery: the folder “%1” is not writable, or the disk is full. Save often.</source>
        <translation>Le travail non enregistré ne peut pas être gardé pour la récupération&#x202f;: on ne peut pas écrire dans le dossier «&#x202f;%1&#x202f;», ou le disque est plein. Enregistrez souvent.</translation>
    </message>
    <message>
        <source>The unsaved work from the last session is damaged and cannot be recovered. What remains of it is in:</source>
        <translation>Un travail non enregistré de la dernière fois est endommagé et ne peut pas être récupéré. Ce qu’il en reste se trouve dans&#x202f;:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Recherche du travail non enregistré…</translation>
    </message>
    <message numerus="yes">
        <source>(%n windows)</source>
        <translation>
            <numerusform>(%n fenêtre)</numerusform>
            <numerusform>(%n fenêtres)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SnapshotBanner</name>
    <message>
        <source>Snapshot on the canvas</source>
        <translation>Instantané sur le canevas</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B&#x202f;: %1</translation>
    </message>
    <message>
        <source>Back to the Fractal</source>
        <translation>Retour à la fractale</translation>
    </message>
    <message>
        <source>Shows the fractal again. Nothing has changed.</source>
        <translation>Montre de nouveau la fractale. Rien n’a changé.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Restores the fractal to this snapshot, as one step of the history.</source>
        <translation>Remet la fractale comme elle était dans cet instantané&#x202f;: une étape de l’historique.</translation>
    </message>
    <message>
        <source>The canvas shows “%1”.</source>
        <translation>Le canevas montre «&#x202f;%1&#x202f;».</translation>
    </message>
</context>
<context>
    <name>SnapshotCommands</name>
    <message>
        <source>Snapshots cannot be compared while a fractal transformation is shown.</source>
        <translation>On ne peut pas comparer d’instantanés tant qu’une transformation fractale est affichée.</translation>
    </message>
    <message>
        <source>Ta&amp;ke Snapshot</source>
        <translation>Prendre un &amp;instantané</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Keep the current state of this fractal in the Snapshots panel</source>
        <translation>Garder l’état présent de cette fractale dans le panneau «&#x202f;Instantanés&#x202f;»</translation>
    </message>
    <message>
        <source>C&amp;ompare with Snapshot</source>
        <translation>&amp;Comparer avec l’instantané</translation>
    </message>
    <message>
        <source>Q</source>
        <translation>Q</translation>
    </message>
    <message>
        <source>Kept as “%1”. To see it, choose View, Panels, Snapshots.</source>
        <translation>Gardé sous «&#x202f;%1&#x202f;». «&#x202f;Affichage&#x202f;», «&#x202f;Panneaux&#x202f;», «&#x202f;Instantanés&#x202f;» le montre.</translation>
    </message>
    <message>
        <source>Show the snapshot selected in the Snapshots panel, or the newest one, in place of the fractal; to return, press the key again, or hold it and release it</source>
        <translation>Montrer à la place de la fractale l’instantané sélectionné dans le panneau «&#x202f;Instantanés&#x202f;», ou le plus récent&#x202f;; appuyez encore, ou maintenez la touche et relâchez-la, pour revenir</translation>
    </message>
    <message>
        <source>Snapshots can be compared only while the density is shown. Choose Density in the bar under the canvas first.</source>
        <translation>On ne peut comparer des instantanés que lorsque la densité est affichée. Choisissez d’abord «&#x202f;Densité&#x202f;» dans la barre sous le canevas.</translation>
    </message>
</context>
<context>
    <name>SpaceBranch</name>
    <message>
        <source>No branch can be selected here: the address of this point is not known.</source>
        <translation>Aucune branche ne peut être choisie ici&#x202f;: l’adresse de ce point n’est pas connue.</translation>
    </message>
    <message>
        <source>A branch cannot be dragged while it or the cage is flat.</source>
        <translation>On ne peut pas faire glisser une branche tant qu’elle ou la cage est plate.</translation>
    </message>
</context>
<context>
    <name>SpaceDefinition</name>
    <message>
        <source>Click the first of the four corners. The picture stays where it is; Esc cancels.</source>
        <translation>Cliquez le premier des quatre sommets. L’image ne bouge pas&#x202f;; Échap annule.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Cliquez le deuxième sommet. Retour arrière supprime le dernier point.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Cliquez le troisième sommet. Retour arrière supprime le dernier point.</translation>
    </message>
    <message>
        <source>Click the fourth corner, in front of the other three. The wheel pushes it away, and the right button turns the view.</source>
        <translation>Cliquez le quatrième sommet, devant les trois autres. La molette l’éloigne et le bouton droit tourne la vue.</translation>
    </message>
</context>
<context>
    <name>SpaceMapDrag</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Arrêté&#x202f;: au-delà, la branche ne deviendrait pas plus petite à l’intérieur d’elle-même.</translation>
    </message>
</context>
<context>
    <name>SpaceMaps</name>
    <message>
        <source>Maps cannot be dragged while the cage is flat. First open or reset the cage.</source>
        <translation>On ne peut pas faire glisser d’applications tant que la cage est plate. Ouvrez ou réinitialisez d’abord la cage.</translation>
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
        <source>Pointer position</source>
        <translation>Position du pointeur</translation>
    </message>
    <message>
        <source>Existence of an attractor</source>
        <translation>Existence d’un attracteur</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and its contraction factor</source>
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
        <source>Plane and barycentric coordinates of the pointer; the address of the point of the attractor under it, outermost map first, and the fixed point of its branch</source>
        <translation>Coordonnées cartésiennes et barycentriques du pointeur&#x202f;; l’adresse du point de l’attracteur qui est dessous, l’application la plus extérieure d’abord, et le point fixe de sa branche</translation>
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
        <source>latest changes not yet kept for recovery</source>
        <translation>dernières modifications pas encore gardées pour la récupération</translation>
    </message>
    <message>
        <source>A crash would lose your latest changes: keeping them takes longer than two seconds, because the disk is slow or full or the file is very large. Save what you do not want to lose.</source>
        <translation>Un plantage ferait perdre vos dernières modifications&#x202f;: les garder prend plus de deux secondes, parce que le disque est lent ou plein, ou que le fichier est très volumineux. Enregistrez ce qui ne doit pas être perdu.</translation>
    </message>
    <message>
        <source>  depth %1</source>
        <translation>  profondeur %1</translation>
    </message>
    <message>
        <source>  along %1</source>
        <translation>  le long de %1</translation>
    </message>
    <message>
        <source>  across %1</source>
        <translation>  en travers de %1</translation>
    </message>
    <message>
        <source>  along the normal</source>
        <translation>  le long de la normale</translation>
    </message>
    <message>
        <source>  azimuth %1°  elevation %2°</source>
        <translation>  azimut %1°  élévation %2°</translation>
    </message>
    <message>
        <source>Rotation of the view</source>
        <translation>Rotation de la vue</translation>
    </message>
    <message>
        <source>How far the view is turned, counter-clockwise; choose View, Rotate View, Reset Rotation to return it to upright</source>
        <translation>De combien la vue est tournée dans le sens inverse des aiguilles d’une montre&#x202f;; choisissez Affichage, Faire pivoter la vue, Annuler la rotation pour la redresser</translation>
    </message>
    <message>
        <source>rotated %1°</source>
        <translation>pivotée de %1°</translation>
    </message>
    <message>
        <source>attractor: %1</source>
        <translation>attracteur&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>Le système contenu dans l’image dépasse 8 Mo.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>Le système contenu dans l’image est endommagé.</translation>
    </message>
    <message>
        <source>The picture contains a document type declaration, which Barycage neither writes nor reads.</source>
        <translation>L’image déclare un type de document, ce que Barycage n’écrit jamais et ne lit pas.</translation>
    </message>
    <message>
        <source>The file is not an SVG picture, or it is damaged.</source>
        <translation>Le fichier n’est pas une image SVG, ou il est endommagé.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed it.</source>
        <translation>L’image ne contient pas de système&#x202f;: elle n’a pas été écrite par Barycage, ou un autre programme l’en a retiré.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a flame file cannot contain a document type declaration</source>
        <translation>un type de document n’est pas accepté dans un fichier de flammes</translation>
    </message>
    <message>
        <source>The XML cannot be read beyond this point: %1.</source>
        <translation>Le XML s’arrête ici&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The file contains no flames.</source>
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
        <source>no attractor</source>
        <translation>pas d’attracteur</translation>
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
        <source>it uses the variation “%1”</source>
        <translation>elle utilise la variation «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>it is active but not drawn (opacity 0)</source>
        <translation>elle agit sans être dessinée (opacity 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>son poids n’est pas un nombre</translation>
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
        <source>The entry that starts here has no closing “}” before the next entry or the end of the file.</source>
        <translation>L’entrée qui s’ouvre ici n’est pas fermée par «&#x202f;}&#x202f;» avant l’entrée suivante ou la fin du fichier.</translation>
    </message>
    <message>
        <source>The name “%1” contains a control character, at which other programs may end it.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» contient un caractère de contrôle, où d’autres programmes peuvent le terminer.</translation>
    </message>
    <message>
        <source>The name “%1” contains a space; Fractint uses only its first word.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» contient une espace&#x202f;; Fractint n’en retient que le premier mot.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint truncates it.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» dépasse 18 octets&#x202f;; Fractint le coupe là.</translation>
    </message>
    <message>
        <source>The opening brace is on a line of its own; Fractint does not find this entry.</source>
        <translation>L’accolade ouvrante est seule sur sa ligne&#x202f;; Fractint ne trouve pas cette entrée.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>L’entrée a plus de %1 applications, ce qui est la limite.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be a decimal comma or a separator; both readings give complete rows. Use decimal points and spaces.</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: la virgule peut être décimale ou séparer deux nombres, et les deux lectures donnent des lignes complètes. Écrivez des points décimaux et des espaces.</translation>
    </message>
    <message>
        <source>“%1”: the comma gives complete rows of 7 numbers (13 with “(3D)”) neither as a decimal comma nor as a separator.</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: que la virgule soit décimale ou sépare deux nombres, on n’obtient pas de lignes complètes de 7 nombres (13 avec «&#x202f;(3D)&#x202f;»).</translation>
    </message>
    <message>
        <source>Numbers on the line of the opening brace are ignored, as in Fractint.</source>
        <translation>Les nombres placés sur la ligne de l’accolade ouvrante sont ignorés, comme le fait Fractint.</translation>
    </message>
    <message>
        <source>This version of Barycage does not understand “%1”; the line is kept.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas compris par cette version de Barycage&#x202f;; la ligne est conservée.</translation>
    </message>
    <message>
        <source>The entry contains no numbers.</source>
        <translation>L’entrée ne contient pas de nombres.</translation>
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
        <source>“%1” is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>«&#x202f;%1&#x202f;» est plus grand que ne peut l’être un coefficient (3,4e38 en valeur absolue).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Use a plain “-”.</source>
        <translation>«&#x202f;%1&#x202f;» commence par un signe moins typographique (U+2212). Écrivez le simple «&#x202f;-&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>There are numbers on the line of the opening brace, where Fractint ignores them; Barycage reads them.</source>
        <translation>Des nombres se trouvent sur la ligne de l’accolade ouvrante, où Fractint les ignore&#x202f;; ils sont lus.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads different numbers here.</source>
        <translation>Les virgules sont lues comme des séparateurs décimaux&#x202f;; Fractint lit ici d’autres nombres.</translation>
    </message>
    <message>
        <source>Commas or apostrophes separate the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Des virgules ou des apostrophes séparent les nombres&#x202f;; Iterated Dynamics ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each), so the weights are computed from the determinants. Fractint cannot read this entry.</source>
        <translation>Les applications n’ont pas de poids (%1 nombres chacune)&#x202f;; les poids sont tirés des déterminants. Fractint ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Des lignes de %1 nombres sans «&#x202f;(3D)&#x202f;» après le nom sont lues comme un système 3D&#x202f;; Fractint ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>The lines do not have 7 numbers each, but together the numbers fill rows of 7 and are read that way, as in Fractint. The weights are probably missing.</source>
        <translation>Les lignes n’ont pas 7 nombres chacune, mais tous les nombres réunis remplissent des lignes de 7 et sont lus ainsi, comme le fait Fractint. Les poids manquent probablement.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>L’accolade fermante touche le dernier nombre&#x202f;; Fractint ne peut pas lire cette entrée.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint truncates it.</source>
        <translation>La ligne dépasse 200 octets&#x202f;; Fractint la coupe là.</translation>
    </message>
    <message>
        <source>There is a NUL byte here; the rest of the line is ignored, as in Fractint.</source>
        <translation>Un octet NUL&#x202f;; le reste de la ligne est ignoré, comme le fait Fractint.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>L’entrée a %1 applications&#x202f;; Fractint et Iterated Dynamics en lisent au plus 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map is treated as switched off.</source>
        <translation>Le poids de l’application %1 est négatif&#x202f;; l’application est considérée comme désactivée.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0, so the map is inactive.</source>
        <translation>Le poids de l’application %1 est nul&#x202f;; l’application n’est pas active.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are scaled in proportion; Fractint gives any shortfall to the last map and cuts off any excess.</source>
        <translation>La somme des poids est %1, et non 1. Ils sont utilisés en proportion&#x202f;; Fractint donne ce qui manque à la dernière application et coupe ce qui est en trop.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Le fichier est vide.</translation>
    </message>
    <message>
        <source>The file contains Fractint parameter sets or formulas, but no iterated function system.</source>
        <translation>Ce sont des jeux de paramètres ou des formules de Fractint&#x202f;; aucun système de fonctions itérées n’y figure.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry consists of a name, “{”, rows of 7 numbers and “}”.</source>
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
        <source>There are two opening braces on one line: no program finds an entry here. The text is kept.</source>
        <translation>Deux accolades ouvrantes sur une même ligne&#x202f;: aucun programme ne trouve d’entrée ici. Le texte est conservé.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>«&#x202f;%1&#x202f;» est un jeu de paramètres ou une formule, et non un système de fonctions itérées&#x202f;; il est conservé comme texte.</translation>
    </message>
    <message>
        <source>The entry in line %1 has the same name (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>Le nom est déjà pris par l’entrée de la ligne %1 (Fractint compare 18 caractères sans distinguer majuscules et minuscules)&#x202f;; Fractint n’atteint jamais celle-ci.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint treats as part of the first name.</source>
        <translation>Le fichier commence par une marque d’ordre des octets (BOM), que Fractint prend pour une partie du premier nom.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); Barycage reads the entries after it too.</source>
        <translation>Fractint cesse de lire à cet octet (^Z)&#x202f;; les entrées suivantes sont lues malgré tout.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use only the first 2000.</source>
        <translation>Le fichier a %1 entrées&#x202f;; Fractint et Iterated Dynamics utilisent les 2000 premières.</translation>
    </message>
    <message>
        <source>The entry has no active map and is omitted.</source>
        <translation>L’entrée n’a aucune application active et est omise.</translation>
    </message>
    <message>
        <source>The entry is saved under the name “%1”: other programs need unique names of at most 18 plain characters.</source>
        <translation>L’entrée est écrite sous le nom «&#x202f;%1&#x202f;»&#x202f;: d’autres programmes acceptent 18 caractères simples, et chaque nom une seule fois.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>L’entrée a %1 applications&#x202f;; Fractint jusqu’à 17.2 en lit au plus 31.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>indécis</translation>
    </message>
    <message>
        <source>none: no map is active</source>
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
        <source>similarity dimension</source>
        <translation>dimension de similitude</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>dimension d’affinité</translation>
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
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its rest polygon is flat, crosses itself or has more than 64 vertices.</source>
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
        <source>A palette can have at most %1 colours; the rest are ignored.</source>
        <translation>Une palette a au plus %1 couleurs&#x202f;; les autres sont omises.</translation>
    </message>
    <message>
        <source>This line is ignored: a colour consists of three whole numbers from 0 to 255.</source>
        <translation>Cette ligne est omise&#x202f;: une couleur est formée de trois entiers de 0 à 255.</translation>
    </message>
    <message>
        <source>The file contains no colours.</source>
        <translation>Le fichier ne contient pas de couleurs.</translation>
    </message>
    <message>
        <source>The file is larger than 16 MB, which is the limit for a palette.</source>
        <translation>Le fichier dépasse 16 Mo, bien plus qu’il n’en faut à une palette.</translation>
    </message>
    <message>
        <source>The file is not a text file, so it is not a palette.</source>
        <translation>Le fichier n’est pas un texte, ce n’est donc pas une palette.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the rest are ignored.</source>
        <translation>Le fichier a plus de %1 palettes&#x202f;; les autres sont omises.</translation>
    </message>
    <message>
        <source>The file contains no gradients.</source>
        <translation>Le fichier ne contient pas de dégradé.</translation>
    </message>
    <message>
        <source>The gradient that starts in line %1 is not closed.</source>
        <translation>Le dégradé de la ligne %1 n’est pas fermé.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un entier.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so it has no points.</source>
        <translation>«&#x202f;%1&#x202f;» n’a aucune application active, donc pas de points.</translation>
    </message>
    <message>
        <source>A point cloud can have from 1 to %1 points.</source>
        <translation>Un nuage de points compte de 1 à %1 points.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>«&#x202f;%1&#x202f;» est un dossier. Choisissez un nom de fichier.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and will not be replaced. Choose another name.</source>
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
        <source>“%1” was not saved: you do not have permission to write to the folder “%2”. Save somewhere else.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: vous n’avez pas le droit d’écrire dans le dossier «&#x202f;%2&#x202f;». Enregistrez ailleurs.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: le nom est trop long.</translation>
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
        <source>Only systems in the plane can be written as vector graphics.</source>
        <translation>Seuls les systèmes du plan peuvent être écrits en graphiques vectoriels.</translation>
    </message>
    <message>
        <source>No outline of an attractor could be certified for this system, so there is nothing to copy.</source>
        <translation>Le système n’a pas d’attracteur dont on puisse certifier un contour&#x202f;: il n’y a donc rien à copier.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>Dans cette vue, l’image est trop grande pour être écrite en formes vectorielles.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row consists of a b c d e f and optionally a weight.</source>
        <translation>Il n’y a pas de lignes de nombres&#x202f;: une ligne est a b c d e f, suivie éventuellement d’un poids.</translation>
    </message>
    <message>
        <source>After the count, a map consists of its weight and a matrix of 3 rows.</source>
        <translation>Après leur nombre, chaque application est donnée par son poids et une matrice de 3 lignes.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map must be 0 0 1.</source>
        <translation>La dernière ligne de la matrice d’une application affine est 0 0 1.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>L’en-tête ne dit pas quelles colonnes sont a, b, c, d, e et f&#x202f;; choisissez l’ordre des colonnes.</translation>
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
        <source>This is a %1 file, not a text file with iterated function systems.</source>
        <translation>C’est un fichier %1, et non un texte contenant des systèmes de fonctions itérées.</translation>
    </message>
    <message>
        <source>This text is encoded in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
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
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text file with iterated function systems.</source>
        <translation>C’est un fichier binaire (peut-être une image à compression fractale ou une bibliothèque d’icônes), et non un texte contenant des systèmes de fonctions itérées.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and the file is too large for a table of numbers: the limit is 64 MB.</source>
        <translation>Aucun système de fonctions itérées n’a été trouvé, et pour un tableau de nombres le fichier est trop grand&#x202f;: la limite est de 64 Mo.</translation>
    </message>
    <message>
        <source>a number is too large for a coefficient (the largest absolute value is 3.4e38)</source>
        <translation>un nombre est plus grand que ne peut l’être un coefficient (3.4e38 en valeur absolue)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest are ignored.</source>
        <translation>Le fichier a plus de %1 flammes&#x202f;; le reste est omis.</translation>
    </message>
    <message>
        <source>%1 flames in total are not systems of affine maps.</source>
        <translation>%1 flammes en tout ne sont pas des systèmes d’applications affines.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>L’entrée a plus de %1 lignes, ce qui est la limite&#x202f;; elle est gardée comme texte.</translation>
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
        <source>A number in this row is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>Un nombre de cette ligne est plus grand que ne peut l’être un coefficient (3.4e38 en valeur absolue).</translation>
    </message>
    <message>
        <source>The text is larger than 64 MB, which is the limit for a table of numbers.</source>
        <translation>Le texte dépasse 64 Mo, ce qui est la limite pour un tableau de nombres.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Une balise a plus de %1 attributs, ce qui est la limite.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 levels deep, which is the limit.</source>
        <translation>Les éléments sont imbriqués à plus de %1 niveaux, ce qui est la limite.</translation>
    </message>
    <message>
        <source>The file is larger than 64 MB, which is the limit for XML.</source>
        <translation>Le fichier dépasse 64 Mo, ce qui est la limite pour le XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>branche déplacée</translation>
    </message>
    <message>
        <source>The stored position of a branch is not valid and is not applied: its map is incomplete, its address names maps that do not exist or occurs twice, or there are too many.</source>
        <translation>Une place enregistrée d’une branche n’est pas utilisable (son application est incomplète, son adresse nomme des applications qui n’existent pas ou apparaît deux fois, ou il y en a trop) et n’est pas appliquée.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Une cellule de cette ligne est vide.</translation>
    </message>
    <message>
        <source>A comma can be a decimal comma or a separator here; both readings give complete rows. Use decimal points.</source>
        <translation>La virgule peut ici être décimale ou séparer deux nombres, et les deux lectures donnent des lignes complètes. Écrivez des points décimaux.</translation>
    </message>
    <message>
        <source>The table mixes maps of the plane and maps of space.</source>
        <translation>Le tableau a des applications du plan et des applications de l’espace.</translation>
    </message>
    <message>
        <source>This is a list of other files, as used by the program Fraktale, not a Fractint collection.</source>
        <translation>C’est une liste d’autres fichiers, comme celle du programme Fraktale, et non une collection Fractint.</translation>
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
        <source>There is no column “%1”: the columns are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Aucune colonne ne s’appelle «&#x202f;%1&#x202f;»&#x202f;: il y a a b c d ou r s theta phi, e f, et p ou cumulative.</translation>
    </message>
    <message>
        <source>“%1” occurs twice.</source>
        <translation>«&#x202f;%1&#x202f;» apparaît deux fois.</translation>
    </message>
    <message>
        <source>A row has only one weight: p or cumulative.</source>
        <translation>Une ligne a un seul poids&#x202f;: p ou cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi cannot be combined.</source>
        <translation>a b c d et r s theta phi ne vont pas ensemble.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Il manque&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than other programs can read in one path. Choose a smaller depth.</source>
        <translation>Le contour a plus de sommets que les programmes n’en lisent dans un seul tracé. Choisissez une profondeur plus petite.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers describe the picture at rest.</source>
        <translation>La cage courbe ou aplatit l’image. Les nombres sont ceux de l’image au repos.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid UTF-8. Rename the file, or open it through a symbolic link.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» n’est pas de l’UTF-8 valide. Renommez le fichier, ou ouvrez-le par un lien symbolique.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so all weights are computed from the determinants and the given ones are ignored.</source>
        <translation>L’application %1 n’a pas de poids&#x202f;; les poids de toutes les applications sont donc tirés des déterminants, et ceux qui sont donnés ne sont pas utilisés.</translation>
    </message>
    <message>
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its vertices at rest are in one plane or coincide.</source>
        <translation>La cage enregistrée est inutilisable (ses listes de sommets ne se correspondent pas, ou ses sommets au repos sont dans un même plan ou confondus) et n’est pas appliquée.</translation>
    </message>
    <message>
        <source>This entry is %1-dimensional, but its stored cage or moved branches are not: they are not applied, and their lines are kept.</source>
        <translation>Cette entrée a %1 dimensions, mais pas sa cage enregistrée ou ses branches déplacées&#x202f;: elles ne sont pas appliquées, et leurs lignes sont conservées.</translation>
    </message>
    <message>
        <source>none: ρ(A) ≥ 1 for the word %1</source>
        <translation>aucun&#x202f;: ρ(A) ≥ 1 pour le mot %1</translation>
    </message>
    <message>
        <source>(of the attractor: its pieces are disjoint)</source>
        <translation>(de l’attracteur&#x202f;: ses morceaux sont disjoints)</translation>
    </message>
    <message>
        <source>(upper bound: pieces coincide)</source>
        <translation>(majorant&#x202f;: des morceaux coïncident)</translation>
    </message>
    <message>
        <source>(if the open set condition holds; else an upper bound)</source>
        <translation>(si la condition de l’ensemble ouvert est remplie&#x202f;; sinon, un majorant)</translation>
    </message>
    <message>
        <source>strong: no two pieces meet</source>
        <translation>forte&#x202f;: deux morceaux ne se touchent jamais</translation>
    </message>
    <message>
        <source>none: pieces coincide</source>
        <translation>aucune&#x202f;: des morceaux coïncident</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>connexe</translation>
    </message>
    <message>
        <source>connected, within rounding error</source>
        <translation>connexe, autant que l’arrondi permet d’en juger</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connexe</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>séparation</translation>
    </message>
    <message>
        <source>connectedness</source>
        <translation>connexité</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>recouvrement</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map</source>
        <translation>les mots %1 et %2 sont la même application</translation>
    </message>
    <message>
        <source>joint spectral radius</source>
        <translation>rayon spectral joint</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 et %2</translation>
    </message>
    <message>
        <source>entropy</source>
        <translation>entropie</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Exposant de Liapounov</translation>
    </message>
    <message>
        <source>dimension of measure</source>
        <translation>dimension de la mesure</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of 6 numbers, line by line, or as %2 maps of 7 numbers, whose weights then sum to 1. They are read line by line; for the other reading, put 7 numbers on each line.</source>
        <translation>Les nombres peuvent se lire ligne par ligne comme %1 applications de 6 nombres, ou comme %2 applications de 7 nombres, dont les poids ont alors pour somme 1. Ils sont lus ligne par ligne&#x202f;; pour l’autre lecture, mettez 7 nombres sur chaque ligne.</translation>
    </message>
    <message>
        <source>The block names no maps: a line such as “A=(f1|f2)*A” is missing.</source>
        <translation>Le bloc ne nomme aucune application&#x202f;: il manque une ligne comme «&#x202f;A=(f1|f2)*A&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is not understood: Barycage reads blocks of affine maps, such as “f1=[e,f]*[a,b,c,d]” and “A=(f1|f2)*A”.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas compris&#x202f;: Barycage lit des blocs d’applications affines, comme «&#x202f;f1=[e,f]*[a,b,c,d]&#x202f;» et «&#x202f;A=(f1|f2)*A&#x202f;».</translation>
    </message>
    <message>
        <source>The file has more than %1 blocks, which is the limit; the rest was not read.</source>
        <translation>Le fichier a plus de %1 blocs, la limite&#x202f;; le reste n’a pas été lu.</translation>
    </message>
    <message>
        <source>This IFStile file contains no affine system.</source>
        <translation>Ce fichier IFStile ne contient aucun système affine.</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of %2 numbers, line by line, or as %3 maps of 7 numbers, whose weights then sum to 1. They are read line by line, unlike in Fractint; for the other reading, put 7 numbers on each line.</source>
        <translation>Les nombres peuvent se lire ligne par ligne comme %1 applications de %2 nombres, ou comme %3 applications de 7 nombres, dont les poids ont alors pour somme 1. Ils sont lus ligne par ligne, contrairement à Fractint&#x202f;; pour l’autre lecture, mettez 7 nombres sur chaque ligne.</translation>
    </message>
    <message>
        <source>The numbers are read line by line, as %1 maps of %2 numbers. Fractint ignores line ends and reads %3 maps of 7 numbers.</source>
        <translation>Les nombres sont lus ligne par ligne, comme %1 applications de %2 nombres. Fractint ignore les fins de ligne et lit %3 applications de 7 nombres.</translation>
    </message>
    <message>
        <source>Entries whose names begin with “ifs:” belong in parameter files (.par); in a collection, Fractint takes the prefix as part of the name.</source>
        <translation>Les entrées dont le nom commence par «&#x202f;ifs:&#x202f;» ont leur place dans les fichiers de paramètres (.par)&#x202f;; dans une collection, Fractint prend le préfixe pour une partie du nom.</translation>
    </message>
    <message>
        <source>The lines end with CR alone, as on old Macintosh computers; Fractint reads such a file as a single line.</source>
        <translation>Les lignes se terminent par CR seul, comme sur les anciens Macintosh&#x202f;; Fractint lit un tel fichier comme une seule ligne.</translation>
    </message>
    <message>
        <source>The convex hull has an error of up to %1: the tolerance %2 was not reached.</source>
        <translation>L’enveloppe convexe a une erreur d’au plus %1&#x202f;: la tolérance %2 n’a pas été atteinte.</translation>
    </message>
    <message>
        <source>contractive in an ellipsoidal norm, γ %1</source>
        <translation>contractant dans une norme ellipsoïdale, γ %1</translation>
    </message>
    <message>
        <source>contractive in a polytope norm, γ %1</source>
        <translation>contractant dans une norme polytopale, γ %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ %1 from words of length %2</source>
        <translation>finalement contractant, γ %1 à partir des mots de longueur %2</translation>
    </message>
    <message>
        <source>hyperbolic, s %1</source>
        <translation>hyperbolique, s %1</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 application</translation>
    </message>
    <message>
        <source>%1 maps</source>
        <translation>%1 applications</translation>
    </message>
    <message>
        <source>%1 — in space, %2</source>
        <translation>%1 – dans l’espace, %2</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2</source>
        <translation>%1 – dans le plan, %2</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>n’a pas pu être lue</translation>
    </message>
    <message>
        <source>in space, %1</source>
        <translation>dans l’espace, %1</translation>
    </message>
    <message>
        <source>in the plane, %1</source>
        <translation>dans le plan, %1</translation>
    </message>
    <message>
        <source>its cage</source>
        <translation>sa cage</translation>
    </message>
    <message>
        <source>its moved branches</source>
        <translation>ses branches déplacées</translation>
    </message>
    <message>
        <source>its palette</source>
        <translation>sa palette</translation>
    </message>
    <message>
        <source>its background</source>
        <translation>son arrière-plan</translation>
    </message>
    <message>
        <source>its other colour settings</source>
        <translation>ses autres réglages de couleur</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>“%1” is written without %2: other programs will draw a different picture.</source>
        <translation>«&#x202f;%1&#x202f;» est écrit sans %2&#x202f;: d’autres programmes dessineront une image différente.</translation>
    </message>
    <message>
        <source>“%1” is written without %2.</source>
        <translation>«&#x202f;%1&#x202f;» est écrit sans %2.</translation>
    </message>
    <message>
        <source>The stored animation is not applied, because “%1” is not understood; its lines are kept.</source>
        <translation>L’animation enregistrée n’est pas appliquée, car «&#x202f;%1&#x202f;» n’est pas compris&#x202f;; ses lignes sont conservées.</translation>
    </message>
    <message>
        <source>The entry has more than one stored animation: the last valid one is used, and the lines of the others are kept.</source>
        <translation>L’entrée a plusieurs animations enregistrées&#x202f;: la dernière valide est utilisée et les lignes des autres sont conservées.</translation>
    </message>
    <message>
        <source>The stored animation is not valid and is not applied: it moves maps or vertices that do not exist, a frame, number or curve is out of its range, or keys are not in order. Its lines are kept.</source>
        <translation>L’animation enregistrée n’est pas valide et n’est pas appliquée&#x202f;: elle déplace des applications ou des sommets qui n’existent pas, une image, un nombre ou une courbe sort de son intervalle, ou les images clés ne sont pas dans l’ordre. Ses lignes sont conservées.</translation>
    </message>
    <message>
        <source>in a cycle</source>
        <translation>en boucle</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>en aller-retour</translation>
    </message>
    <message>
        <source>once</source>
        <translation>une fois</translation>
    </message>
    <message>
        <source>animation</source>
        <translation>animation</translation>
    </message>
    <message>
        <source>This is not the format of a fractal program. Its lists of numbers are read as tables of maps (systems: %1, maps: %2), in the order a b c d e f unless names give another order.</source>
        <translation>Ce n’est pas un format de programmes de fractales. Ses listes de nombres sont lues comme des tableaux d’applications (systèmes&#x202f;: %1, applications&#x202f;: %2), dans l’ordre a b c d e f là où des noms n’en indiquent pas d’autre.</translation>
    </message>
    <message>
        <source>it acts in space after its variations (“%1”)</source>
        <translation>elle agit dans l’espace après ses variations («&#x202f;%1&#x202f;»)</translation>
    </message>
    <message>
        <source>its “%1” is not six numbers</source>
        <translation>son «&#x202f;%1&#x202f;» n’est pas formé de six nombres</translation>
    </message>
    <message>
        <source>The flame names a palette of another program by its number; its colours are not in the file.</source>
        <translation>La flamme n’indique que le numéro d’une palette d’un autre programme&#x202f;; ses couleurs ne sont pas dans le fichier.</translation>
    </message>
    <message>
        <source>“%1” could not be read, so it has no points.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas pu être lu et n’a donc pas de points.</translation>
    </message>
    <message>
        <source>This is JSON text (data of another program), not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>C’est un texte JSON (données d’un autre programme), et non une collection Fractint, et aucune de ses listes n’est faite d’applications affines.</translation>
    </message>
    <message>
        <source>This is the text of a program, not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>C’est le texte d’un programme, et non une collection Fractint, et aucune de ses listes n’est faite d’applications affines.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it has no solid.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un système de l’espace et n’a donc pas de solide.</translation>
    </message>
    <message>
        <source>The cage of “%1” bends the picture, so its solid cannot be written.</source>
        <translation>La cage de «&#x202f;%1&#x202f;» courbe l’image&#x202f;; son solide ne peut donc pas être écrit.</translation>
    </message>
    <message>
        <source>“%1” has no certified attractor, so it has no solid.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas d’attracteur certifié et n’a donc pas de solide.</translation>
    </message>
    <message>
        <source>“%1” would need more than %2 parts in OpenSCAD. Choose larger voxels.</source>
        <translation>«&#x202f;%1&#x202f;» demanderait plus de %2 parties dans OpenSCAD. Choisissez des voxels plus grands.</translation>
    </message>
    <message>
        <source>“%1” is too large for a solid.</source>
        <translation>«&#x202f;%1&#x202f;» est trop grand pour un solide.</translation>
    </message>
    <message>
        <source>“%1” is a single point: only the size of its voxel can be chosen.</source>
        <translation>«&#x202f;%1&#x202f;» est un seul point&#x202f;: seule la taille de son voxel peut être choisie.</translation>
    </message>
    <message>
        <source>The surface of “%1” is not closed, so it was not written.</source>
        <translation>La surface de «&#x202f;%1&#x202f;» n’est pas fermée et n’a donc pas été écrite.</translation>
    </message>
    <message>
        <source>Size: %1 × %2 × %3 mm; volume: %4 mm³; triangles: %5.</source>
        <translation>Taille&#x202f;: %1 × %2 × %3 mm&#x202f;; volume&#x202f;: %4 mm³&#x202f;; triangles&#x202f;: %5.</translation>
    </message>
    <message>
        <source>Distance from the attractor: at most %1 mm = √3 · %2 mm + %3 mm for the wall.</source>
        <translation>Distance à l’attracteur&#x202f;: au plus %1 mm = √3 · %2 mm + %3 mm pour la paroi.</translation>
    </message>
    <message>
        <source>Cavities filled: %1, with %2 mm³.</source>
        <translation>Cavités remplies&#x202f;: %1, de %2 mm³.</translation>
    </message>
    <message>
        <source>Closed cavities: %1, with %2 mm³.</source>
        <translation>Cavités fermées&#x202f;: %1, de %2 mm³.</translation>
    </message>
    <message>
        <source>Separate bodies: %1.</source>
        <translation>Corps séparés&#x202f;: %1.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>«&#x202f;%1&#x202f;»&#x202f;: %2</translation>
    </message>
    <message>
        <source>“%1” belongs to another picture: the entry, the view, the size, the seed or the format differs.</source>
        <translation>«&#x202f;%1&#x202f;» vient d’une autre image&#x202f;: l’entrée, la vue, la taille, la graine ou le format diffèrent.</translation>
    </message>
    <message>
        <source>“%1” belongs to a picture with a different number of points, so the sums cannot be combined.</source>
        <translation>«&#x202f;%1&#x202f;» vient d’une image avec un autre nombre de points&#x202f;: les sommes ne peuvent pas être ajoutées.</translation>
    </message>
    <message>
        <source>“%1” and “%2” hold the same part of the picture, which would be counted twice.</source>
        <translation>«&#x202f;%1&#x202f;» et «&#x202f;%2&#x202f;» contiennent la même partie de l’image, qui serait comptée deux fois.</translation>
    </message>
    <message>
        <source>“%1” was written by another version of the program, which may draw other pixels.</source>
        <translation>«&#x202f;%1&#x202f;» a été écrit par une autre version du programme, qui peut dessiner d’autres pixels.</translation>
    </message>
    <message>
        <source>The picture is incomplete: only %1 % of it is present. Add the files of the other parts, or merge to a .sum file.</source>
        <translation>L’image n’est pas complète&#x202f;: %1 % sont présents. Ajoutez les fichiers des autres parties, ou écrivez un fichier .sum.</translation>
    </message>
    <message>
        <source>This is not a file of sums.</source>
        <translation>Ce n’est pas un fichier de sommes.</translation>
    </message>
    <message>
        <source>The file of sums is damaged or incomplete.</source>
        <translation>Le fichier de sommes est endommagé ou incomplet.</translation>
    </message>
    <message>
        <source>“%1” is a symbolic link that leads back to itself, or through too many others.</source>
        <translation>«&#x202f;%1&#x202f;» est un lien symbolique qui revient à lui-même, ou passe par trop d’autres.</translation>
    </message>
    <message>
        <source>You do not have permission to enter the folder “%1”.</source>
        <translation>Vous n’avez pas le droit d’entrer dans le dossier «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>not computed within the budget</source>
        <translation>non calculé dans le temps imparti</translation>
    </message>
    <message>
        <source>A cage with more than four corners bends the solid; its points cannot be written.</source>
        <translation>Une cage de plus de quatre sommets courbe le solide&#x202f;; ses points ne peuvent pas être écrits.</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
    <message>
        <source>The sheet would have %1 by %2 pixels; the limit is %3 pixels in width. Use smaller tiles or fewer columns.</source>
        <translation>La planche aurait %1 sur %2 pixels&#x202f;; la largeur maximale est de %3 pixels. Prenez des vignettes plus petites ou moins de colonnes.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it down.</source>
        <translation>L’image a %1 × %2 pixels. Au plus 32 millions de pixels peuvent être lus&#x202f;; réduisez-la.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. Each side needs at least %3 pixels.</source>
        <translation>L’image a %1 × %2 pixels. Chaque côté doit avoir au moins %3 pixels.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete.</source>
        <translation>L’image est endommagée ou incomplète.</translation>
    </message>
    <message>
        <source>The picture is a JPEG in CMYK colours, which programs read differently. Convert it to RGB or grey levels.</source>
        <translation>L’image est un JPEG en couleurs CMJN, que chaque programme lit autrement. Convertissez-la en RVB ou en niveaux de gris.</translation>
    </message>
    <message>
        <source>The picture is animated. Save one of its frames as a picture of its own.</source>
        <translation>L’image est animée. Enregistrez l’une de ses images comme fichier à part.</translation>
    </message>
    <message>
        <source>The picture is too long and thin to be traced.</source>
        <translation>L’image est trop longue et trop mince pour être décalquée.</translation>
    </message>
    <message>
        <source>There is no fractal transformation between these entries.</source>
        <translation>Il n’y a pas de transformation fractale entre ces entrées.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un système du plan.</translation>
    </message>
    <message>
        <source>The cage of “%1” is flat or bends the picture. Bake or reset it first.</source>
        <translation>La cage de «&#x202f;%1&#x202f;» est plate ou courbe l’image. Intégrez-la d’abord au code, ou remettez-la au repos.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so there is nothing to draw.</source>
        <translation>«&#x202f;%1&#x202f;» n’a aucune application active, il n’y a donc rien à dessiner.</translation>
    </message>
    <message>
        <source>No attractor could be proved for “%1”, so its points have no addresses.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas d’attracteur démontrable, ses points n’ont donc pas d’adresses.</translation>
    </message>
    <message>
        <source>The stored order does not list every active map of “%1” once.</source>
        <translation>L’ordre enregistré ne cite pas une fois chaque application active de «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” has %2 maps; with a symmetry of %3 elements they would be more than %4, which is the limit.</source>
        <translation>«&#x202f;%1&#x202f;» a %2 applications&#x202f;; avec une symétrie de %3 éléments, il y en aurait plus de %4, ce qui est la limite.</translation>
    </message>
    <message>
        <source>The maps of “%1” move in its animation, and the copies that its symmetry makes would not move with them. Remove the motions and the keys of the maps first.</source>
        <translation>Les applications de «&#x202f;%1&#x202f;» bougent dans son animation, et les copies créées par sa symétrie ne bougeraient pas avec elles. Supprimez d’abord les mouvements et les clés des applications.</translation>
    </message>
    <message>
        <source>its “chaos” is not a list of numbers from 0 upwards</source>
        <translation>son «&#x202f;chaos&#x202f;» n’est pas une liste de nombres positifs ou nuls</translation>
    </message>
    <message>
        <source>its symmetry is not of a kind from −%1 to %1</source>
        <translation>sa symétrie n’est pas d’un type compris entre −%1 et %1</translation>
    </message>
    <message>
        <source>it links more than %1 transforms by “chaos”</source>
        <translation>elle lie plus de %1 transformations par «&#x202f;chaos&#x202f;»</translation>
    </message>
    <message>
        <source>it links transforms in space by “chaos”</source>
        <translation>elle lie des transformations de l’espace par «&#x202f;chaos&#x202f;»</translation>
    </message>
    <message>
        <source>Maps of a system in space cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>Les applications d’un système de l’espace ne peuvent pas être liées&#x202f;: les liens ne sont pas appliqués, et leurs lignes sont conservées.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>On ne peut pas lier plus de %1 applications&#x202f;: les liens ne sont pas appliqués, et leurs lignes sont conservées.</translation>
    </message>
    <message>
        <source>The links of map %1 are not valid, so no links are applied: a row of links has one number for each map, 0 or larger.</source>
        <translation>Les liens de l’application %1 ne sont pas valides, donc aucun n’est appliqué&#x202f;: une ligne de liens a un nombre par application, 0 ou plus.</translation>
    </message>
    <message>
        <source>With these links every sequence of maps ends, so no map is active.</source>
        <translation>Avec ces liens, toute suite d’applications prend fin&#x202f;; aucune application n’est donc active.</translation>
    </message>
    <message>
        <source>With its stored symmetry the entry would have more than %1 maps, which is the limit. The symmetry is not applied; its lines are kept.</source>
        <translation>Avec la symétrie enregistrée, l’entrée aurait plus de %1 applications, ce qui est la limite. La symétrie n’est pas appliquée&#x202f;; ses lignes sont conservées.</translation>
    </message>
    <message>
        <source>The maps are linked, so the picture is not made of copies of itself.</source>
        <translation>Les applications sont liées&#x202f;; l’image n’est donc pas faite de copies d’elle-même.</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 sommet</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 sommets</translation>
    </message>
    <message>
        <source>%1, area %2; error at most %3; periodic addresses not computed within the budget</source>
        <translation>%1, aire %2&#x202f;; erreur d’au plus %3&#x202f;; adresses périodiques non calculées dans le temps imparti</translation>
    </message>
    <message>
        <source>%1, all of them with periodic addresses, area %2; exact</source>
        <translation>%1, tous d’adresses périodiques, aire %2&#x202f;; exacte</translation>
    </message>
    <message>
        <source>%1, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1, dont %2 d’adresses périodiques, aire %3&#x202f;; erreur d’au plus %4</translation>
    </message>
    <message>
        <source>%1, %2, volume %3; error at most %4</source>
        <translation>%1, %2, volume %3&#x202f;; erreur d’au plus %4</translation>
    </message>
    <message>
        <source>1 facet</source>
        <translation>1 facette</translation>
    </message>
    <message>
        <source>%1 facets</source>
        <translation>%1 facettes</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>(within rounding error)</source>
        <translation>(autant que l’arrondi permet d’en juger)</translation>
    </message>
    <message>
        <source>area of the tile</source>
        <translation>aire de la tuile</translation>
    </message>
    <message>
        <source>dimension of boundary</source>
        <translation>dimension de la frontière</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>symétrie</translation>
    </message>
    <message>
        <source>takes no part: after it, the chaos game ends</source>
        <translation>ne participe pas&#x202f;: après elle, le jeu du chaos prend fin</translation>
    </message>
    <message>
        <source>takes no part: no map leads to it</source>
        <translation>ne participe pas&#x202f;: aucune application n’y mène</translation>
    </message>
    <message>
        <source>takes no part: the chaos game leaves it and never returns</source>
        <translation>ne participe pas&#x202f;: le jeu du chaos la quitte et n’y revient jamais</translation>
    </message>
    <message>
        <source>links from map %1</source>
        <translation>liens de l’application %1</translation>
    </message>
    <message>
        <source>linked maps</source>
        <translation>applications liées</translation>
    </message>
    <message>
        <source>separation, connectedness, joint spectral radius and periodic addresses are not computed for linked maps</source>
        <translation>la séparation, la connexité, le rayon spectral joint et les adresses périodiques ne sont pas déterminés pour les applications liées</translation>
    </message>
    <message>
        <source>the links of its maps</source>
        <translation>les liens de ses applications</translation>
    </message>
    <message>
        <source>The symmetry of “%1” is written as the maps that it stands for.</source>
        <translation>La symétrie de «&#x202f;%1&#x202f;» est écrite sous la forme des applications qu’elle représente.</translation>
    </message>
    <message>
        <source>, in a frame of its own</source>
        <translation>, dans un repère qui lui est propre</translation>
    </message>
    <message>
        <source>mirror at %1° through %2</source>
        <translation>miroir à %1° passant par %2</translation>
    </message>
    <message>
        <source>%1-fold rotation about %2</source>
        <translation>rotation d’ordre %1 autour de %2</translation>
    </message>
    <message>
        <source>%1-fold dihedral about %2, a mirror at %3°</source>
        <translation>diédrale d’ordre %1 autour de %2, avec un miroir à %3°</translation>
    </message>
    <message>
        <source>rotations of the tetrahedron about %1</source>
        <translation>rotations du tétraèdre autour de %1</translation>
    </message>
    <message>
        <source>rotations of the octahedron about %1</source>
        <translation>rotations de l’octaèdre autour de %1</translation>
    </message>
    <message>
        <source>rotations of the icosahedron about %1</source>
        <translation>rotations de l’icosaèdre autour de %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, so not every address is one of its points.</source>
        <translation>Les applications de «&#x202f;%1&#x202f;» sont liées, donc toute adresse n’est pas l’un de ses points.</translation>
    </message>
    <message>
        <source>A GIMP gradient states its number of segments here, from 1 to %1.</source>
        <translation>Un dégradé GIMP indique ici son nombre de segments, de 1 à %1.</translation>
    </message>
    <message>
        <source>This is not a segment of a GIMP gradient that continues the one before.</source>
        <translation>Ce n’est pas un segment de dégradé GIMP qui prolonge le précédent.</translation>
    </message>
    <message>
        <source>its fractal transformation</source>
        <translation>sa transformation fractale</translation>
    </message>
    <message>
        <source>its saved views</source>
        <translation>ses vues enregistrées</translation>
    </message>
    <message>
        <source>the names of its maps</source>
        <translation>les noms de ses applications</translation>
    </message>
    <message>
        <source>the locks of its maps</source>
        <translation>les verrous de ses applications</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nom&#x202f;:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Date&#x202f;:</translation>
    </message>
    <message>
        <source>part of map %1</source>
        <translation>partie de l’application %1</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>This is not a PNG, JPEG, GIF, BMP, PNM, WebP, TIFF or OpenEXR picture.</source>
        <translation>Ce n’est pas une image PNG, JPEG, GIF, BMP, PNM, WebP, TIFF ou OpenEXR.</translation>
    </message>
    <message>
        <source>The picture stores its pixels in a way that cannot be read. Save it as a PNG picture.</source>
        <translation>L’image enregistre ses pixels d’une manière qui ne peut pas être lue. Enregistrez-la en PNG.</translation>
    </message>
    <message>
        <source>Too many maps to bound the jumps</source>
        <translation>Trop d’applications pour majorer les sauts</translation>
    </message>
    <message>
        <source>Proved continuous: the pieces do not touch</source>
        <translation>Continuité démontrée&#x202f;: les parties ne se touchent pas</translation>
    </message>
    <message>
        <source>Proved so far: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Démontré jusqu’ici&#x202f;: aucun saut entre parties ne dépasse %1 (%2 % du partenaire), au pire près de %3</translation>
    </message>
    <message>
        <source>Proved: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Démontré&#x202f;: aucun saut entre parties ne dépasse %1 (%2 % du partenaire), au pire près de %3</translation>
    </message>
    <message>
        <source>Proved to be a homeomorphism</source>
        <translation>Homéomorphisme, c’est démontré</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism</source>
        <translation>Ce n’est pas un homéomorphisme, c’est démontré</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism</source>
        <translation>On ne sait pas si c’est un homéomorphisme</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>Ce n’est pas un homéomorphisme, c’est démontré&#x202f;; au retour, aucun saut ne dépasse %1 (%2 % de cette fractale), au pire près de %3</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>On ne sait pas si c’est un homéomorphisme&#x202f;; au retour, aucun saut ne dépasse %1 (%2 % de cette fractale), au pire près de %3</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map within rounding error</source>
        <translation>les mots %1 et %2 sont la même application à l’arrondi près</translation>
    </message>
    <message>
        <source>Omitted lines of blocks that are not iterated function systems: %1.</source>
        <translation>Lignes omises de blocs qui ne sont pas des systèmes de fonctions itérées&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Omitted inactive maps: %1.</source>
        <translation>Applications inactives omises&#x202f;: %1.</translation>
    </message>
    <message>
        <source>a point; exact</source>
        <translation>un point&#x202f;; exacte</translation>
    </message>
    <message>
        <source>(upper bound: the open set condition fails)</source>
        <translation>(majorant&#x202f;: la condition de l’ensemble ouvert n’est pas remplie)</translation>
    </message>
    <message>
        <source>%1, and inside itself</source>
        <translation>%1, et en elle-même</translation>
    </message>
    <message>
        <source>The picture in “%1” needs more than 4 GB of memory in space.</source>
        <translation>L’image de «&#x202f;%1&#x202f;» demande plus de 4 Go de mémoire dans l’espace.</translation>
    </message>
    <message>
        <source>The stored symmetry “%1” is not valid for this entry and is not applied; its lines are kept. A rotation repeats each map 2 to %2 times; polyhedra belong to space.</source>
        <translation>La symétrie enregistrée «&#x202f;%1&#x202f;» n’est pas valable pour cette entrée et n’est pas appliquée&#x202f;; ses lignes sont conservées. Une rotation répète chaque application 2 à %2 fois&#x202f;; les polyèdres sont du domaine de l’espace.</translation>
    </message>
    <message>
        <source>“%1” and “%2” must have the same number of active maps; they have %3 and %4.</source>
        <translation>«&#x202f;%1&#x202f;» et «&#x202f;%2&#x202f;» doivent avoir le même nombre d’applications actives&#x202f;; elles en ont %3 et %4.</translation>
    </message>
    <message>
        <source>Other problems in this entry, not listed: %1.</source>
        <translation>Autres problèmes de cette entrée, non listés&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Numbers are missing or left over: this line has %1, the entry has %2, and each map has %3%4.</source>
        <translation>Des nombres manquent ou sont en trop&#x202f;: cette ligne en a %1, l’entrée en a %2, et chaque application en a %3%4.</translation>
    </message>
    <message>
        <source>moved branches</source>
        <translation>branches déplacées</translation>
    </message>
    <message>
        <source>all figures are those of the code, where no branch is moved</source>
        <translation>tous les chiffres sont ceux du code, où aucune branche n’est déplacée</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time. Choose a lower resolution, which makes larger voxels.</source>
        <translation>Les parties de «&#x202f;%1&#x202f;» se recouvrent ou se touchent trop pour trouver ses voxels en un temps raisonnable. Choisissez une résolution plus basse, donc des voxels plus grands.</translation>
    </message>
    <message>
        <source>The surface of “%1” would have more than %2 million triangles. Choose a lower resolution, which makes larger voxels.</source>
        <translation>La surface de «&#x202f;%1&#x202f;» aurait plus de %2 millions de triangles. Choisissez une résolution plus basse, donc des voxels plus grands.</translation>
    </message>
    <message>
        <source>The count says %1, but the number of maps is %2.</source>
        <translation>Le compte annonce %1, mais le nombre d’applications est %2.</translation>
    </message>
    <message>
        <source>The header names %2 columns, but this row has %1.</source>
        <translation>L’en-tête nomme %2 colonnes, mais cette ligne en a %1.</translation>
    </message>
    <message>
        <source>A map has 6 numbers, or 7 with its weight; this row has %1.</source>
        <translation>Une application compte 6 nombres, ou 7 avec son poids&#x202f;; cette ligne en a %1.</translation>
    </message>
    <message>
        <source>its animation</source>
        <translation>son animation</translation>
    </message>
    <message>
        <source>tracks: %1</source>
        <translation>pistes&#x202f;: %1</translation>
    </message>
    <message>
        <source>motions: %1</source>
        <translation>mouvements&#x202f;: %1</translation>
    </message>
    <message>
        <source>frames: %1, %2 per second, %3</source>
        <translation>images&#x202f;: %1, %2 par seconde, %3</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose larger voxels.</source>
        <translation>Le solide de «&#x202f;%1&#x202f;» demanderait plus de %2 millions de voxels. Choisissez des voxels plus grands.</translation>
    </message>
    <message>
        <source>The wall is too thick for a solid of this size. Choose a thinner wall.</source>
        <translation>La paroi est trop épaisse pour un solide de cette taille. Choisissez une paroi plus mince.</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose a lower resolution: at most %3.</source>
        <translation>Le solide de «&#x202f;%1&#x202f;» demanderait plus de %2 millions de voxels. Choisissez une résolution plus basse&#x202f;: %3 au maximum.</translation>
    </message>
    <message>
        <source>Transform %1 has opacity %2; its points are drawn in full.</source>
        <translation>La transformation %1 a l’opacité %2&#x202f;; ses points sont dessinés pleinement.</translation>
    </message>
    <message>
        <source>The file on disk is unchanged.</source>
        <translation>Le fichier sur le disque est resté tel quel.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: %2.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas été enregistré&#x202f;: le disque est plein. Libérez de la place et enregistrez à nouveau.</translation>
    </message>
    <message>
        <source>“%1” is too small for its distance from the origin: the numbers in the file cannot distinguish its points. Move it to the origin, or make it larger.</source>
        <translation>«&#x202f;%1&#x202f;» est trop petit pour sa distance à l’origine&#x202f;: les nombres du fichier ne distinguent pas ses points. Déplacez-le à l’origine ou agrandissez-le.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and cannot be opened.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un fichier ordinaire et ne peut pas être ouvert.</translation>
    </message>
    <message>
        <source>The system does not follow the symbolic link “%1”, because another user may have put it there. Choose another name.</source>
        <translation>Le système ne suit pas le lien symbolique «&#x202f;%1&#x202f;», car un autre utilisateur l’a peut-être placé là. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>The picture is a JPEG with more than %1 scans. Save it as a PNG picture.</source>
        <translation>L’image est un JPEG de plus de %1 passes. Enregistrez-la comme image PNG.</translation>
    </message>
    <message>
        <source>This is read as %3 (systems: %1, maps: %2).</source>
        <translation>Lu comme&#x202f;: %3 (systèmes&#x202f;: %1, applications&#x202f;: %2).</translation>
    </message>
    <message>
        <source>Nothing names its columns: their order is taken to be a b c d e f.</source>
        <translation>Rien ne nomme les colonnes&#x202f;: leur ordre est supposé être a b c d e f.</translation>
    </message>
    <message>
        <source>In %1, row %2: %3</source>
        <translation>%1, ligne %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>The text is encoded in UTF-16; it is saved as UTF-8.</source>
        <translation>Le texte est codé en UTF-16&#x202f;; il est enregistré en UTF-8.</translation>
    </message>
    <message>
        <source>This is a program, a page or another document, not a Fractint collection, and none of its numbers are affine maps.</source>
        <translation>C’est un programme, une page ou un autre document, pas une collection Fractint, et aucun de ses nombres ne forme d’application affine.</translation>
    </message>
    <message>
        <source>final transform: %1</source>
        <translation>transformation finale&#x202f;: %1</translation>
    </message>
    <message>
        <source>it has several final transforms</source>
        <translation>elle a plusieurs transformations finales</translation>
    </message>
    <message>
        <source>it has a final transform in space</source>
        <translation>elle a une transformation finale dans l’espace</translation>
    </message>
    <message>
        <source>it has a final transform and a symmetry</source>
        <translation>elle a une transformation finale et une symétrie</translation>
    </message>
    <message>
        <source>its final transform flattens the picture</source>
        <translation>sa transformation finale aplatit l’image</translation>
    </message>
    <message>
        <source>The attribute “%1” occurs twice; the first one is read.</source>
        <translation>L’attribut «&#x202f;%1&#x202f;» apparaît deux fois&#x202f;; le premier est lu.</translation>
    </message>
    <message>
        <source>A blank is missing before the attribute “%1”; it is read as if there were one.</source>
        <translation>Il manque une espace avant l’attribut «&#x202f;%1&#x202f;»&#x202f;; il est lu comme s’il y en avait une.</translation>
    </message>
    <message>
        <source>The attribute “%1” contains “%2”, which must be “%3” in XML; it is read as it stands.</source>
        <translation>L’attribut «&#x202f;%1&#x202f;» contient «&#x202f;%2&#x202f;», qui doit s’écrire «&#x202f;%3&#x202f;» en XML&#x202f;; il est lu tel quel.</translation>
    </message>
    <message>
        <source>%1 flames with different times are the keys of this animation, a frame for each unit of time. Its colours are those of the first one.</source>
        <translation>%1 flames à des temps différents sont les clés de cette animation, une image par unité de temps. Ses couleurs sont celles de la première.</translation>
    </message>
    <message>
        <source>Columns that do not belong to a map are not read: %1.</source>
        <translation>Les colonnes qui n’appartiennent pas à une application ne sont pas lues&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The weights rise to %1, so they may be running sums. They are read as weights; to read them as sums, name their column “cumulative” instead of “p”.</source>
        <translation>Les poids croissent jusqu’à %1&#x202f;; ce sont peut-être des sommes cumulées. Ils sont lus comme des poids&#x202f;; pour les lire comme des sommes, nommez leur colonne «&#x202f;cumulative&#x202f;» au lieu de «&#x202f;p&#x202f;».</translation>
    </message>
    <message>
        <source>YAML</source>
        <translation>YAML</translation>
    </message>
    <message>
        <source>a text of GIMP’s IFS Fractal</source>
        <translation>un texte de «&#x202f;Fractale IFS&#x202f;» de GIMP</translation>
    </message>
    <message>
        <source>a LaTeX table</source>
        <translation>tableau LaTeX</translation>
    </message>
    <message>
        <source>an HTML table</source>
        <translation>tableau HTML</translation>
    </message>
    <message>
        <source>a Markdown table</source>
        <translation>tableau Markdown</translation>
    </message>
    <message>
        <source>a wiki table</source>
        <translation>tableau wiki</translation>
    </message>
    <message>
        <source>matrices in LaTeX</source>
        <translation>matrices en LaTeX</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>équations</translation>
    </message>
    <message>
        <source>Standard output cannot be written to: %1.</source>
        <translation>Impossible d’écrire sur la sortie standard&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message numerus="yes">
        <source>%n exports from the last session are in the queue.</source>
        <translation>
            <numerusform>%n export de la dernière fois est dans la file d’attente.</numerusform>
            <numerusform>%n exports de la dernière fois sont dans la file d’attente.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export is not finished</source>
        <translation>L’export n’est pas terminé</translation>
    </message>
    <message>
        <source>A file is still being exported.</source>
        <translation>Un fichier est encore en cours d’exportation.</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>&amp;Animation…</translation>
    </message>
    <message>
        <source>Exports the motion instead, as GIF, MP4 and others.</source>
        <translation>Exporte plutôt le mouvement, en GIF, MP4 et autres.</translation>
    </message>
    <message>
        <source>If you stop now, no file is written.</source>
        <translation>Si vous l’arrêtez maintenant, aucun fichier n’est écrit.</translation>
    </message>
    <message>
        <source>&amp;Stop Export</source>
        <translation>&amp;Arrêter l’export</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Continuer</translation>
    </message>
    <message>
        <source>Exports are not finished</source>
        <translation>Des exports ne sont pas terminés</translation>
    </message>
    <message numerus="yes">
        <source>Barycage closes when they are finished. Closed now, it continues with them at its next start.</source>
        <translation>
            <numerusform>Barycage se ferme quand il est terminé. Si vous le fermez maintenant, il reprendra au prochain démarrage.</numerusform>
            <numerusform>Barycage se ferme quand ils sont terminés. Si vous le fermez maintenant, ils reprendront au prochain démarrage.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Fer&amp;mer</translation>
    </message>
    <message numerus="yes">
        <source>%n exports are still in the queue.</source>
        <translation>
            <numerusform>%n export est encore dans la file d’attente.</numerusform>
            <numerusform>%n exports sont encore dans la file d’attente.</numerusform>
        </translation>
    </message>
    <message>
        <source>The file has no entry “%1”.</source>
        <translation>Le fichier n’a pas d’entrée «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Show a step of the lesson</source>
        <translation>Montrer une étape de la leçon</translation>
    </message>
    <message>
        <source>The cage of this entry does not have the same corners as in the lesson.</source>
        <translation>La cage de cette entrée a d’autres sommets que dans la leçon.</translation>
    </message>
    <message>
        <source>The fractals in the open file. The canvas shows the one you select here.</source>
        <translation>Les fractales du fichier ouvert. Celle que l’on choisit ici est à l’image.</translation>
    </message>
    <message>
        <source>Ready-made fractals by theme, and your own folders of fractals.</source>
        <translation>Des fractales pour commencer, classées par thème, et vos propres dossiers de fractales.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map per row.</source>
        <translation>Les applications de la fractale&#x202f;: son code, une application par ligne.</translation>
    </message>
    <message>
        <source>Which map may follow which in the chaos game, as a graph and as a matrix.</source>
        <translation>Quelles applications le jeu du chaos peut appliquer après lesquelles, sous forme de graphe et de matrice.</translation>
    </message>
    <message>
        <source>The control cage in numbers: its vertices, their positions at rest, what moving them does, and other cages to choose from.</source>
        <translation>La cage de contrôle en nombres&#x202f;: où sont ses sommets, où ils sont au repos, ce que produit leur déplacement, et d’autres cages à choisir.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Couleurs, luminosité et fond de l’image. Ils sont enregistrés avec la fractale.</translation>
    </message>
    <message>
        <source>Mathematical properties of this fractal. Point to a name to see what it means.</source>
        <translation>Propriétés mathématiques de cette fractale. Pointez un nom pour lire ce qu’il signifie.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Select one to go back or forward to it.</source>
        <translation>Toutes les étapes depuis l’ouverture du fichier. Choisissez-en une pour y revenir ou pour y avancer.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept while working on it. Click one to restore it.</source>
        <translation>États de cette fractale que vous avez gardés en travaillant. Cliquez sur l’un d’eux pour le rétablir.</translation>
    </message>
    <message>
        <source>The animation of this fractal: its motions, and the keys of everything that can move.</source>
        <translation>L’animation de cette fractale&#x202f;: ses mouvements et les clés de tout ce qui peut bouger.</translation>
    </message>
    <message>
        <source>Find a fractal that looks like a picture: the target, how well the fractal agrees with it, and ways to fit it.</source>
        <translation>Une fractale pour une image&#x202f;: la cible, son accord avec la fractale, et des ajustements.</translation>
    </message>
    <message>
        <source>Pictures drawn one after another in the background, with the progress of each.</source>
        <translation>Les images dessinées l’une après l’autre en arrière-plan, et l’avancement de chacune.</translation>
    </message>
    <message>
        <source>A lesson about these fractals: its steps, each with a text and the state of the window, to be played in full screen.</source>
        <translation>Une leçon sur ces fractales&#x202f;: ses étapes, chacune avec un texte et l’état de la fenêtre, à jouer sur tout l’écran.</translation>
    </message>
    <message>
        <source>Problems found in the file, with line and column. The text in the file is kept unchanged.</source>
        <translation>Problèmes trouvés dans le fichier, avec la ligne et la colonne. Le texte du fichier reste inchangé.</translation>
    </message>
    <message>
        <source>%1 is already open in this window.</source>
        <translation>%1 est déjà ouvert dans cette fenêtre.</translation>
    </message>
    <message>
        <source>%1 by %2°</source>
        <translation>%1 de %2°</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 d’un facteur %2</translation>
    </message>
    <message>
        <source>%1 to (%2, %3)</source>
        <translation>%1 en (%2, %3)</translation>
    </message>
    <message>
        <source>%1 by (%2, %3)</source>
        <translation>%1 de (%2, %3)</translation>
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
        <translation>Δ (%1, %2)  longueur %3</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>arête %1</translation>
    </message>
    <message>
        <source>edges %1 and %2</source>
        <translation>arêtes %1 et %2</translation>
    </message>
    <message>
        <source>Map %1</source>
        <comment>begins a sentence</comment>
        <translation>L’application %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>Map that takes no part</source>
        <translation>Application qui ne participe pas</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Branche %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, coin %2</translation>
    </message>
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
        <source>Round handle</source>
        <translation>Poignée ronde</translation>
    </message>
    <message>
        <source>Square handle</source>
        <translation>Poignée carrée</translation>
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
        <source>the arrow keys turn by one degree</source>
        <translation>les flèches tournent d’un degré</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>les flèches changent l’échelle d’un pour cent</translation>
    </message>
    <message>
        <source>Drag to move the pivot, the centre of rotation and scaling.</source>
        <translation>Tirez le pivot&#x202f;: rotation et mise à l’échelle se font autour de lui.</translation>
    </message>
    <message>
        <source>Drag to rotate about the pivot; hold Shift for steps of 15°.</source>
        <translation>Tirez pour tourner autour du pivot&#x202f;; Maj&#x202f;: par pas de 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; hold Shift for x or y only.</source>
        <translation>Tirez pour mettre à l’échelle autour du pivot&#x202f;; Maj&#x202f;: selon x ou y seulement.</translation>
    </message>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>collage</translation>
    </message>
    <message>
        <source>The name “%1” does not match the chosen format. Choose another name.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» ne correspond pas au format choisi. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Another export in the queue writes “%1”. Choose another name.</source>
        <translation>Un autre export de la file d’attente écrit «&#x202f;%1&#x202f;». Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Added to the queue: %1.</source>
        <translation>Ajouté à la file d’attente&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 × %2 are %3 million pixels. Drawing them may take hours, and the file may need up to %4.</source>
        <translation>%1 × %2 font %3 millions de pixels. Les dessiner peut prendre des heures, et le fichier peut occuper jusqu’à %4.</translation>
    </message>
    <message>
        <source>Memory needed: about %1.</source>
        <translation>Mémoire nécessaire&#x202f;: environ %1.</translation>
    </message>
    <message>
        <source>Very large picture</source>
        <translation>Très grande image</translation>
    </message>
    <message>
        <source>This picture is very large.</source>
        <translation>Cette image est très grande.</translation>
    </message>
    <message>
        <source>&amp;Export Anyway</source>
        <translation>&amp;Exporter quand même</translation>
    </message>
    <message>
        <source>%1 could not be written. Print it to another folder.</source>
        <translation>%1 n’a pas pu être écrit. Imprimez dans un autre dossier.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Chercher dans le guide</translation>
    </message>
    <message>
        <source>Finds these words in the guide. Enter goes to the next match, Shift+Enter to the previous one. Ctrl+F comes back here.</source>
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
    <message>
        <source>User Guide</source>
        <translation>Guide d’utilisation</translation>
    </message>
    <message>
        <source>The user guide: what you can do with Barycage, in the order in which you need it.</source>
        <translation>Le guide d’utilisation&#x202f;: ce que l’on peut faire ici, dans l’ordre où l’on en a besoin.</translation>
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
    <message>
        <source>Smallest Rectangle</source>
        <translation>Plus petit rectangle</translation>
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
        <source>Three Edges of the Bounding Box</source>
        <translation>Trois arêtes de la boîte englobante</translation>
    </message>
    <message>
        <source>Bounding Box, Eight Corners</source>
        <translation>Boîte englobante, huit coins</translation>
    </message>
    <message>
        <source>Octahedron</source>
        <translation>Octaèdre</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Lecture de ce qui a été collé…</translation>
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
        <source>Nothing was pasted: the clipboard contains no rows of 6 or 7 numbers.</source>
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
    <message numerus="yes">
        <source>%n maps added.</source>
        <translation>
            <numerusform>%n application ajoutée.</numerusform>
            <numerusform>%n applications ajoutées.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The selected maps were replaced; %n maps pasted.</source>
        <translation>
            <numerusform>Les applications sélectionnées ont été remplacées&#x202f;; %n application collée.</numerusform>
            <numerusform>Les applications sélectionnées ont été remplacées&#x202f;; %n applications collées.</numerusform>
        </translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Selon |déterminant|</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Égaux</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Selon la dimension</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normaliser</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Poids</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>Le même poids pour toutes les applications</translation>
    </message>
    <message>
        <source>Weights that cover the attractor evenly at its own dimension</source>
        <translation>Poids couvrant uniformément l’attracteur dans sa propre dimension</translation>
    </message>
    <message>
        <source>Scale all weights so that they sum to 1</source>
        <translation>Les mêmes proportions, avec la somme 1</translation>
    </message>
    <message>
        <source>Set the weights of all maps that are switched on by a rule</source>
        <translation>Poids de toutes les applications actives, selon une règle</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Images (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Enregistrement de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Dihedral</source>
        <translation>Diédrale</translation>
    </message>
    <message>
        <source>Tetrahedral</source>
        <translation>Tétraédrique</translation>
    </message>
    <message>
        <source>Octahedral</source>
        <translation>Octaédrique</translation>
    </message>
    <message>
        <source>Icosahedral</source>
        <translation>Icosaédrique</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Cette entrée n’a pas d’applications du plan.</translation>
    </message>
    <message>
        <source>The cage is at rest: the picture shows the code.</source>
        <translation>La cage est au repos&#x202f;: l’image affichée est celle du code.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code produces a bent picture. Choose “Affine fit” to bake the closest affine placement.</source>
        <translation>La cage courbe l’image, et aucun code affine ne donne une image courbée. Choisissez «&#x202f;Ajustement affine&#x202f;» pour intégrer au code ce qui s’en approche le plus.</translation>
    </message>
    <message>
        <source>The cage is flat, so its placement cannot be baked into the code. Open the cage first.</source>
        <translation>La cage est plate&#x202f;: son placement ne peut pas être intégré au code. Ouvrez d’abord la cage.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>La cage est au repos.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. Bake to change the code.</source>
        <translation>Déplacer la cage déplace l’image. Le code reste tel quel tant que vous n’y intégrez pas le placement.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can reproduce, so the code does not change.</source>
        <translation>Déplacer la cage entière réécrit le code. Déplacer un seul sommet courbe l’image, ce qu’aucun code ne peut suivre&#x202f;; le code reste alors tel quel.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites all coefficients of the code; the cage is then at rest in its new position.</source>
        <translation>Déplacer la cage réécrit tous les coefficients du code, et la cage est au repos là où elle se trouve.</translation>
    </message>
    <message>
        <source>The cage is not at rest: it already holds a placement.</source>
        <translation>La cage n’est pas au repos&#x202f;: elle porte déjà un placement.</translation>
    </message>
    <message>
        <source>Only a cage with three vertices can be unbaked.</source>
        <translation>Seul un triangle peut être extrait du code.</translation>
    </message>
    <message>
        <source>The cage is not convex: the picture may fold over itself at the notch.</source>
        <translation>La cage a une encoche&#x202f;: l’image peut s’y replier sur elle-même.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture overlap. Move the vertices apart to unfold it.</source>
        <translation>La cage est repliée&#x202f;: des parties de l’image se superposent. Écartez les sommets pour la déplier.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to enclose.</source>
        <translation>Aucune application n’est active&#x202f;: il n’y a rien à entourer.</translation>
    </message>
    <message>
        <source>The maps are linked; a cage cannot be fitted to linked maps.</source>
        <translation>Les applications sont liées&#x202f;; on ne peut pas ajuster de cage à des applications liées.</translation>
    </message>
    <message>
        <source>A bent picture cannot be given another cage. First reset the cage or choose “Affine fit”.</source>
        <translation>Une image courbée ne peut pas être confiée à une autre cage. Réinitialisez d’abord la cage, ou choisissez «&#x202f;Ajustement affine&#x202f;».</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the triangle.</source>
        <translation>La cage est plate. Ouvrez d’abord le triangle, ou réinitialisez-le.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Ce système n’a pas d’attracteur à entourer.</translation>
    </message>
    <message>
        <source>All maps are off.</source>
        <translation>Toutes les applications sont désactivées.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be compared with a picture.</source>
        <translation>Les applications sont liées. Seules des applications qui peuvent toutes se suivre peuvent être comparées à une image.</translation>
    </message>
    <message>
        <source>A symmetry repeats the maps. Expand it to compare them with a picture.</source>
        <translation>Une symétrie répète les applications. Développez-la pour comparer les applications à une image.</translation>
    </message>
    <message>
        <source>The cage bends the picture, or is flat. Reset the cage to compare the maps.</source>
        <translation>La cage déforme l’image ou est plate. Réinitialisez-la pour comparer les applications.</translation>
    </message>
    <message>
        <source>The animation of “%1” cannot be taken to another dimension, so it is left out.</source>
        <translation>L’animation de «&#x202f;%1&#x202f;» ne peut pas être transposée dans une autre dimension&#x202f;; elle est omise.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, so it cannot be lifted.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un système du plan et ne peut donc pas être élevé dans l’espace.</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, and maps in space cannot be linked.</source>
        <translation>Les applications de «&#x202f;%1&#x202f;» sont liées, ce que ne peuvent pas être celles de l’espace.</translation>
    </message>
    <message>
        <source>The cage of “%1” has more than three corners, so it cannot become a tetrahedron. Bake or reset it first.</source>
        <translation>La cage de «&#x202f;%1&#x202f;» a plus de trois sommets et ne donne pas de tétraèdre. Intégrez-la ou réinitialisez-la d’abord.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it cannot be flattened.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un système de l’espace et ne peut donc pas être aplati.</translation>
    </message>
    <message>
        <source>The direction must have a length other than 0.</source>
        <translation>La direction ne peut pas être de longueur nulle.</translation>
    </message>
    <message>
        <source>“%1” has moved branches, which cannot be flattened. Reset them first.</source>
        <translation>«&#x202f;%1&#x202f;» a des branches déplacées, qui ne peuvent pas être aplaties. Réinitialisez-les d’abord.</translation>
    </message>
    <message>
        <source>The cage of “%1” cannot be baked into its maps, so it cannot be flattened.</source>
        <translation>La cage de «&#x202f;%1&#x202f;» ne peut pas être intégrée aux applications&#x202f;; il ne peut donc pas être aplati.</translation>
    </message>
    <message>
        <source>Map %1 of “%2” does not keep this direction, so the projection is not an iterated function system. Export a picture seen from that direction instead.</source>
        <translation>L’application %1 de «&#x202f;%2&#x202f;» change cette direction&#x202f;; la projection n’est donc pas un système de fonctions itérées. Exportez plutôt une image vue de ce côté.</translation>
    </message>
    <message>
        <source>An entry needs a name.</source>
        <translation>Une entrée a besoin d’un nom.</translation>
    </message>
    <message>
        <source>Names cannot contain spaces: Fractint reads only the first word.</source>
        <translation>Les noms ne peuvent pas contenir d’espaces&#x202f;: Fractint ne lit que le premier mot.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas figurer dans un nom, car il a un sens particulier dans les fichiers .ifs.</translation>
    </message>
    <message>
        <source>A name can have at most %1 characters; Fractint ignores the rest.</source>
        <translation>Un nom a au plus %1 caractères&#x202f;; Fractint ignore le reste.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint ne liste pas une entrée nommée «&#x202f;%1&#x202f;»&#x202f;; choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case are not distinguished).</source>
        <translation>Une autre entrée se nomme «&#x202f;%1&#x202f;» (majuscules et minuscules ne sont pas distinguées).</translation>
    </message>
    <message>
        <source>A branch</source>
        <translation>Une branche</translation>
    </message>
    <message>
        <source>%1 has keys, which the maps of the new system could not follow. Remove its keys in the timeline first.</source>
        <translation>%1 a des images clés que les applications du nouveau système ne pourraient pas suivre. Supprimez-les d’abord de la ligne de temps.</translation>
    </message>
    <message>
        <source>A motion moves single maps, and the maps of the new system are others. Remove this motion from the timeline first.</source>
        <translation>Un mouvement déplace certaines applications, et celles du nouveau système sont autres. Supprimez d’abord ce mouvement de la ligne de temps.</translation>
    </message>
    <message>
        <source>%1 has keys: it would be rewritten at this frame only, and what has none at every frame. Remove its keys in the timeline first.</source>
        <translation>%1 a des images clés&#x202f;: la réécriture ne vaudrait que pour cette image, et pour toutes là où il n’y en a pas. Supprimez-les d’abord de la ligne de temps.</translation>
    </message>
    <message>
        <source>Maps in space cannot be linked.</source>
        <translation>Les applications de l’espace ne peuvent pas être liées.</translation>
    </message>
    <message>
        <source>This entry could not be read, so its maps cannot be linked.</source>
        <translation>Cette entrée n’a pas pu être lue&#x202f;; ses applications ne peuvent donc pas être liées.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked.</source>
        <translation>On ne peut pas lier plus de %1 applications.</translation>
    </message>
    <message>
        <source>With the links of “%1” every sequence of maps ends, so plain maps would have nothing to draw.</source>
        <translation>Les liens de «&#x202f;%1&#x202f;» font finir toute suite d’applications&#x202f;: il n’y a rien que des applications simples pourraient dessiner.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be more than %2 words of its maps, which is the limit. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Les applications simples de «&#x202f;%1&#x202f;» seraient plus de %2 mots de ses applications, ce qui est la limite. Gardez les liens dans un fichier .ifs ou .flame, ou supprimez-les.</translation>
    </message>
    <message>
        <source>The links of “%1” cannot be written as plain maps: a sequence of maps can go on for ever without reaching one that may follow every map. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Les liens de «&#x202f;%1&#x202f;» ne peuvent pas s’écrire comme des applications simples&#x202f;: une suite d’applications peut continuer sans fin sans en atteindre une qui puisse suivre toutes les autres. Gardez les liens dans un fichier .ifs ou .flame, ou retirez-les.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be words of its maps, which cannot take part in its animation or in its moved branches. Remove these first.</source>
        <translation>Les applications simples de «&#x202f;%1&#x202f;» seraient des mots de ses applications, qui ne peuvent participer ni à son animation ni à ses branches déplacées. Retirez-les d’abord.</translation>
    </message>
    <message>
        <source>Map %1 is locked. Unlock it in the Maps panel first.</source>
        <translation>L’application %1 est verrouillée. Déverrouillez-la d’abord dans le panneau Applications.</translation>
    </message>
    <message>
        <source>Maps %1 are locked. Unlock them in the Maps panel first.</source>
        <translation>Les applications %1 sont verrouillées. Déverrouillez-les d’abord dans le panneau Applications.</translation>
    </message>
    <message>
        <source>Lock a map</source>
        <translation>Verrouiller une application</translation>
    </message>
    <message>
        <source>Unlock a map</source>
        <translation>Déverrouiller une application</translation>
    </message>
    <message>
        <source>Lock %1 maps</source>
        <translation>Verrouiller %1 applications</translation>
    </message>
    <message>
        <source>Unlock %1 maps</source>
        <translation>Déverrouiller %1 applications</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Supprimer le nom de l’application %1</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Nommer «&#x202f;%2&#x202f;» l’application %1</translation>
    </message>
    <message>
        <source>Only a cage with four vertices can be unbaked.</source>
        <translation>Seule une cage à quatre sommets peut être extraite.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so no other cage would show it. First reset the cage or choose “Affine fit”.</source>
        <translation>La cage courbe l’image, et aucune autre cage ne la montrerait. Réinitialisez d’abord la cage ou choisissez «&#x202f;Ajustement affine&#x202f;».</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the tetrahedron.</source>
        <translation>La cage est plate. Ouvrez ou réinitialisez d’abord le tétraèdre.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Choisissez d’abord une application.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be shown alone.</source>
        <translation>Les applications sont liées. Seules des applications qui peuvent toutes se suivre peuvent être affichées seules.</translation>
    </message>
    <message>
        <source>The cage bends the picture, in which no map can be shown alone. Reset the cage first.</source>
        <translation>La cage courbe l’image&#x202f;: aucune application ne peut y être affichée seule. Réinitialisez d’abord la cage.</translation>
    </message>
    <message>
        <source>Map %1 takes everything to one point, so there is nothing to show alone.</source>
        <translation>L’application %1 envoie tout en un point&#x202f;: il n’y a rien à afficher seul.</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Cette entrée n’est pas un système dans l’espace.</translation>
    </message>
    <message>
        <source>This entry has no maps to vary.</source>
        <translation>Cette entrée n’a pas d’applications à faire varier.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>Le dossier %1 ne peut pas être créé.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size or the supersampling.</source>
        <translation>La mémoire ne suffit pas pour cette image. Réduisez-la, ou diminuez le suréchantillonnage.</translation>
    </message>
    <message>
        <source>It is damaged.</source>
        <translation>Il est endommagé.</translation>
    </message>
    <message>
        <source>It is not an export of this program.</source>
        <translation>Ce n’est pas un export de ce programme.</translation>
    </message>
    <message>
        <source>Its settings are not supported by this version.</source>
        <translation>Ses réglages ne sont pas ceux de cette version.</translation>
    </message>
    <message>
        <source>Its file name does not match its format.</source>
        <translation>Le fichier qu’il nomme ne correspond pas à son format.</translation>
    </message>
    <message>
        <source>It is not a regular file.</source>
        <translation>Ce n’est pas un fichier ordinaire.</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>Il ne peut pas être lu.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Il est trop volumineux.</translation>
    </message>
    <message>
        <source>An export from the last session was skipped. %1 Its damaged file was renamed to %2.</source>
        <translation>Un export de la dernière fois a été ignoré. %1 Son fichier endommagé a été renommé en %2.</translation>
    </message>
    <message>
        <source>A file “%1” was created after you added this export. Choose Try Again to replace it.</source>
        <translation>Un fichier «&#x202f;%1&#x202f;» est apparu depuis que vous avez ajouté cet export. Réessayer le remplace.</translation>
    </message>
    <message>
        <source>The fractal in this export cannot be read.</source>
        <translation>La fractale de cet export ne peut pas être lue.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Il n’y a pas assez de mémoire pour cette image.</translation>
    </message>
    <message>
        <source>The lesson is larger than 4 MB, which is the limit.</source>
        <translation>La leçon dépasse la limite de 4 Mo.</translation>
    </message>
    <message>
        <source>This is not a lesson: its first line does not begin with “lesson:”.</source>
        <translation>Ce n’est pas une leçon&#x202f;: sa première ligne ne commence pas par «&#x202f;lesson:&#x202f;».</translation>
    </message>
    <message>
        <source>The lesson has no steps.</source>
        <translation>La leçon n’a pas d’étapes.</translation>
    </message>
    <message>
        <source>This line was ignored: settings look like “file: name.ifs”, and steps begin with “##”.</source>
        <translation>Cette ligne a été ignorée&#x202f;: les réglages ont la forme «&#x202f;file: nom.ifs&#x202f;» et les étapes commencent par «&#x202f;##&#x202f;».</translation>
    </message>
    <message>
        <source>The lesson has more than %1 steps; the others were ignored.</source>
        <translation>La leçon a plus de %1 étapes&#x202f;; les autres ont été ignorées.</translation>
    </message>
    <message>
        <source>The text of step %1 is longer than %2 characters and was cut.</source>
        <translation>Le texte de l’étape %1 dépasse %2 caractères et a été coupé.</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. It can refer to a file in its own folder, or to a .ifs or .par file in another one.</source>
        <translation>Une leçon ne peut pas désigner «&#x202f;%1&#x202f;», mais seulement un fichier de son propre dossier, ou un fichier .ifs ou .par d’un autre.</translation>
    </message>
    <message>
        <source>“%1: %2” was not understood.</source>
        <translation>«&#x202f;%1: %2&#x202f;» n’a pas été compris.</translation>
    </message>
    <message>
        <source>“%1” is unknown to this version and is kept.</source>
        <translation>«&#x202f;%1&#x202f;» est inconnu de cette version et reste conservé.</translation>
    </message>
    <message>
        <source>A %1 picture has at most %2 pixels along a side.</source>
        <translation>Une image %1 a au plus %2 pixels de côté.</translation>
    </message>
    <message>
        <source>A JPEG picture cannot be transparent. Choose a background colour or another format.</source>
        <translation>Une image JPEG ne peut pas être transparente. Choisissez une couleur de fond ou un autre format.</translation>
    </message>
    <message>
        <source>A JPEG picture has at most %1 dots per inch.</source>
        <translation>Une image JPEG a au plus %1 points par pouce.</translation>
    </message>
    <message>
        <source>Such a picture cannot be written as %1.</source>
        <translation>Une telle image ne peut pas être écrite en %1.</translation>
    </message>
    <message>
        <source>The picture cannot be opened.</source>
        <translation>L’image ne peut pas être ouverte.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture.</source>
        <translation>Le fichier n’est pas une image PNG.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete. Draw it again.</source>
        <translation>L’image est endommagée ou incomplète. Dessinez-la à nouveau.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed the text that holds it.</source>
        <translation>L’image ne contient pas de système&#x202f;: elle n’a pas été écrite par Barycage, ou un autre programme en a retiré le texte.</translation>
    </message>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>Le système contenu dans l’image dépasse 8 Mo.</translation>
    </message>
    <message>
        <source>The picture contains too much text: the limit is 40 MB in total.</source>
        <translation>L’image contient trop de texte&#x202f;: la limite est de 40 Mo en tout.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture, or it is damaged.</source>
        <translation>Le fichier n’est pas une image PNG, ou il est endommagé.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Impossible d’écrire l’image&#x202f;: %1</translation>
    </message>
    <message>
        <source>The picture is damaged, or its text cannot be read.</source>
        <translation>L’image est endommagée, ou son texte est illisible.</translation>
    </message>
    <message>
        <source>the WebP encoder does not have enough memory.</source>
        <translation>l’encodeur WebP n’a pas assez de mémoire.</translation>
    </message>
    <message>
        <source>An exact picture of this system would take too long. Draw it with points.</source>
        <translation>Une image exacte de ce système prendrait trop de temps. Dessinez-la par points.</translation>
    </message>
    <message>
        <source>The folder for temporary files does not have enough space for the frames: %1.</source>
        <translation>Le dossier des fichiers temporaires n’a pas assez de place pour les images&#x202f;: %1.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries are not installed on this machine, so no videos can be written. Install them, or write the frames as PNG pictures instead.</source>
        <translation>Les bibliothèques de FFmpeg ne sont pas installées sur cette machine, aucune vidéo ne peut donc être écrite. Installez-les, ou écrivez plutôt les images en PNG.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries on this machine cannot write %1 files: the encoder %2 is missing. Choose another format.</source>
        <translation>Les bibliothèques de FFmpeg de cette machine ne peuvent pas écrire de fichiers %1&#x202f;: l’encodeur %2 manque. Choisissez un autre format.</translation>
    </message>
    <message>
        <source>The video cannot be written: %1.</source>
        <translation>La vidéo ne peut pas être écrite&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Flip maps</source>
        <translation>Retourner des applications</translation>
    </message>
    <message>
        <source>Rotate maps by 90°</source>
        <translation>Tourner des applications de 90°</translation>
    </message>
    <message>
        <source>Rotate maps by −90°</source>
        <translation>Tourner des applications de −90°</translation>
    </message>
    <message>
        <source>Align maps</source>
        <translation>Aligner des applications</translation>
    </message>
    <message>
        <source>Distribute maps</source>
        <translation>Répartir des applications</translation>
    </message>
    <message>
        <source>Fit maps to the corners</source>
        <translation>Placer des applications aux coins</translation>
    </message>
    <message>
        <source>Only maps in the plane can be arranged.</source>
        <translation>Seules des applications du plan peuvent être disposées.</translation>
    </message>
    <message>
        <source>Select at least two maps first.</source>
        <translation>Choisissez d’abord au moins deux applications.</translation>
    </message>
    <message>
        <source>Select at least three maps first.</source>
        <translation>Choisissez d’abord au moins trois applications.</translation>
    </message>
    <message>
        <source>The cage is flat, so maps cannot be moved in it. Reset the cage first.</source>
        <translation>La cage est plate&#x202f;: les applications ne peuvent pas y être déplacées. Réinitialisez d’abord la cage.</translation>
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
        <source>contractive in some norm, γ &lt; 1</source>
        <translation>contractant dans une certaine norme, γ &lt; 1</translation>
    </message>
    <message>
        <source>(the open set condition holds)</source>
        <translation>(la condition de l’ensemble ouvert est remplie)</translation>
    </message>
    <message>
        <source>(the open set condition holds, within rounding error)</source>
        <translation>(la condition de l’ensemble ouvert est remplie, autant que l’arrondi permet d’en juger)</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>remplie</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>non remplie</translation>
    </message>
    <message>
        <source>open set condition</source>
        <translation>condition de l’ensemble ouvert</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>voisins</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Dimension de Hausdorff</translation>
    </message>
    <message>
        <source>(finite type)</source>
        <translation>(type fini)</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>spectre</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>holds, within rounding error</source>
        <translation>remplie, autant que l’arrondi permet d’en juger</translation>
    </message>
    <message>
        <source>fails, within rounding error</source>
        <translation>non remplie, autant que l’arrondi permet d’en juger</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time, even at the lowest resolution.</source>
        <translation>Les morceaux de «&#x202f;%1&#x202f;» se chevauchent ou se touchent trop pour trouver ses voxels en un temps raisonnable, même à la plus basse résolution.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries cannot be loaded, so no videos can be written: %1.</source>
        <translation>Les bibliothèques de FFmpeg ne peuvent pas être chargées, aucune vidéo ne peut donc être écrite&#x202f;: %1.</translation>
    </message>
    <message>
        <source>This entry is not an iterated function system.</source>
        <translation>Cette entrée n’est pas un système de fonctions itérées.</translation>
    </message>
    <message>
        <source>This entry has %1 maps; a web page can have at most %2.</source>
        <translation>Cette entrée a %1 applications&#x202f;; une page web peut en avoir %2 au plus.</translation>
    </message>
    <message>
        <source>A solid has no shadow on the ground. Move its light in the Appearance panel: the solid darkens the side that faces away from it.</source>
        <translation>Un solide ne projette pas d’ombre au sol. Déplacez sa lumière dans le panneau Apparence&#x202f;: le côté opposé s’assombrit.</translation>
    </message>
    <message>
        <source>This entry could not be read, so there is no picture to cast a shadow.</source>
        <translation>Cette entrée n’a pas pu être lue&#x202f;: il n’y a donc pas d’image qui projette une ombre.</translation>
    </message>
    <message>
        <source>its shadow</source>
        <translation>son ombre</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size.</source>
        <translation>Il n’y a pas assez de mémoire pour cette image. Réduisez sa taille.</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Une image</translation>
    </message>
    <message>
        <source>Both eyes, side by side</source>
        <translation>Les deux yeux, côte à côte</translation>
    </message>
    <message>
        <source>Stereo, &amp;Side by Side</source>
        <translation>Stéréo, &amp;côte à côte</translation>
    </message>
    <message>
        <source>Show the views of both eyes side by side, the left eye on the left</source>
        <translation>Montre ce que voit chaque œil, le gauche à gauche</translation>
    </message>
    <message>
        <source>Red and cyan glasses</source>
        <translation>Lunettes rouge et cyan</translation>
    </message>
    <message>
        <source>Stereo, for Red and &amp;Cyan Glasses</source>
        <translation>Stéréo, pour lunettes rouge et c&amp;yan</translation>
    </message>
    <message>
        <source>Show the views of both eyes in one picture, in red and cyan</source>
        <translation>Montre en une image ce que voient les deux yeux, en rouge et cyan</translation>
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
        <source>Formulas and a figure for LaTeX (.tex)</source>
        <translation>Formules et figure pour LaTeX (.tex)</translation>
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
        <source>PNG: pixels</source>
        <translation>PNG&#x202f;: pixels</translation>
    </message>
    <message>
        <source>JPEG: pixels, a small file</source>
        <translation>JPEG&#x202f;: pixels, un petit fichier</translation>
    </message>
    <message>
        <source>WebP: pixels, for web pages</source>
        <translation>WebP&#x202f;: pixels, pour les pages web</translation>
    </message>
    <message>
        <source>TIFF: pixels, for print</source>
        <translation>TIFF&#x202f;: pixels, pour l’impression</translation>
    </message>
    <message>
        <source>OpenEXR: linear light, for compositing</source>
        <translation>OpenEXR&#x202f;: lumière linéaire, pour le compositing</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF&#x202f;: formes pour l’impression</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG&#x202f;: formes pour logiciels de dessin</translation>
    </message>
    <message>
        <source>Mesh for 3D printing (.stl)</source>
        <translation>Corps à imprimer (.stl)</translation>
    </message>
    <message>
        <source>Mesh (.obj)</source>
        <translation>Corps (.obj)</translation>
    </message>
    <message>
        <source>Mesh (.glb)</source>
        <translation>Corps (.glb)</translation>
    </message>
    <message>
        <source>Mesh (.ply)</source>
        <translation>Corps (.ply)</translation>
    </message>
    <message>
        <source>“%1” has %2 numbers for %3 maps, so it is not read as their weights, which are computed from the determinants.</source>
        <translation>«&#x202f;%1&#x202f;» a %2 nombres pour %3 applications et n’est donc pas lu comme leurs poids, qui sont tirés des déterminants.</translation>
    </message>
    <message>
        <source>MP4: plays everywhere</source>
        <translation>MP4&#x202f;: lisible partout</translation>
    </message>
    <message>
        <source>WebM: for web pages, with transparency</source>
        <translation>WebM&#x202f;: pour les pages web, avec transparence</translation>
    </message>
    <message>
        <source>MKV: lossless, for editing</source>
        <translation>MKV&#x202f;: sans perte, pour le montage</translation>
    </message>
    <message>
        <source>GIF: 256 colours</source>
        <translation>GIF&#x202f;: 256 couleurs</translation>
    </message>
    <message>
        <source>WebP: a lossless animated image</source>
        <translation>WebP&#x202f;: image animée sans perte</translation>
    </message>
    <message>
        <source>APNG: a lossless animated image</source>
        <translation>APNG&#x202f;: image animée sans perte</translation>
    </message>
    <message>
        <source>The link holds more than 1 MB of text, which is the limit.</source>
        <translation>Le lien contient plus de 1 Mo de texte, ce qui est la limite.</translation>
    </message>
    <message>
        <source>This link is damaged, or it holds no fractal.</source>
        <translation>Ce lien est endommagé, ou il ne contient pas de fractale.</translation>
    </message>
    <message>
        <source>This link was cut off: its end is missing. Copy all of it.</source>
        <translation>Ce lien a été coupé&#x202f;: il manque la fin. Copiez-le en entier.</translation>
    </message>
    <message>
        <source>Drawing the pictures…</source>
        <translation>Dessin des images…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>PDF: a page with the picture</source>
        <translation>PDF : une page avec l’image</translation>
    </message>
    <message>
        <source>SVG: a page with the picture</source>
        <translation>SVG : une page avec l’image</translation>
    </message>
    <message>
        <source>There is not enough memory for the video.</source>
        <translation>La mémoire ne suffit pas pour la vidéo.</translation>
    </message>
    <message>
        <source>The encoder of the video does not work. There may not be enough memory for it.</source>
        <translation>L’encodeur de la vidéo ne fonctionne pas. La mémoire ne lui suffit peut-être pas.</translation>
    </message>
    <message>
        <source>lists of numbers</source>
        <translation>listes de nombres</translation>
    </message>
    <message>
        <source>This map is not understood, so none is read.</source>
        <translation>Cette application n’est pas comprise : aucune n’est donc lue.</translation>
    </message>
    <message>
        <source>“%1” is not understood, so no map is read.</source>
        <translation>« %1 » n’est pas compris : aucune application n’est donc lue.</translation>
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
        <translation>&amp;Précédent</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminer</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <source>Drag a corner of the triangle: the whole picture follows.</source>
        <translation>Faites glisser un coin du triangle&#x202f;: toute l’image suit.</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Push a corner onto the opposite side until the picture is flat, then pull it open again.</source>
        <translation>Poussez un coin sur le côté opposé jusqu’à ce que l’image soit plate, puis rouvrez-la.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Press %1 to take back what you have just done.</source>
        <translation>Appuyez sur %1 pour annuler ce que vous venez de faire.</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Collection</translation>
    </message>
    <message>
        <source>Double-click a picture of the collection that you like.</source>
        <translation>Double-cliquez sur une image de la collection qui vous plaît.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>Press Wind in the timeline and watch the picture sway.</source>
        <translation>Appuyez sur Vent dans la ligne de temps et regardez l’image se balancer.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Press %1 to save the picture for others.</source>
        <translation>Appuyez sur %1 pour enregistrer l’image à partager.</translation>
    </message>
    <message>
        <source>That Is It</source>
        <translation>Et voilà</translation>
    </message>
    <message>
        <source>Three more steps show what the picture is made of.</source>
        <translation>Trois étapes de plus montrent de quoi l’image est faite.</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Application</translation>
    </message>
    <message>
        <source>Each row is a map that makes one smaller copy of the whole: double-click a number and type another.</source>
        <translation>Chaque ligne est une application qui fait une copie plus petite du tout&#x202f;: double-cliquez sur un nombre et tapez-en un autre.</translation>
    </message>
    <message>
        <source>Click a point: the maps that lead there are its address, and you hold the branch that they make.</source>
        <translation>Cliquez sur un point&#x202f;: les applications qui y mènent sont son adresse, et vous tenez la branche qu’elles forment.</translation>
    </message>
    <message>
        <source>Norm</source>
        <translation>Norme</translation>
    </message>
    <message>
        <source>‖A‖ is how far a map stretches at most: change a number, and keep it below 1.</source>
        <translation>‖A‖ est ce qu’une application étire au plus&#x202f;: changez un nombre et restez au-dessous de 1.</translation>
    </message>
    <message>
        <source>In the timeline, choose Wind under Add Motion and watch the picture sway as well.</source>
        <translation>Dans la ligne de temps, choisissez Vent sous «&#x202f;Ajouter un mouvement&#x202f;» et regardez l’image se balancer aussi.</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>Pa&amp;sser</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>&amp;Continuer</translation>
    </message>
    <message>
        <source>Open the panel %1 again: it is under View › Panels.</source>
        <translation>Rouvrez le panneau %1&#x202f;: il est sous Affichage › Panneaux.</translation>
    </message>
    <message>
        <source>That Is All</source>
        <translation>C’est tout</translation>
    </message>
    <message>
        <source>Now take whatever you like by its corners.</source>
        <translation>Prenez maintenant ce que vous voulez par ses coins.</translation>
    </message>
    <message>
        <source>Press %1 once more: the picture is still flat.</source>
        <translation>Appuyez encore une fois sur %1 : l’image est encore plate.</translation>
    </message>
</context>
<context>
    <name>VideoSystem</name>
    <message>
        <source>The file is not a video.</source>
        <translation>Le fichier n’est pas une vidéo.</translation>
    </message>
    <message>
        <source>The video contains no system: it was not written by Barycage, it is damaged, or another program removed the text that holds it.</source>
        <translation>La vidéo ne contient pas de système&#x202f;: elle n’a pas été écrite par Barycage, elle est endommagée, ou un autre programme a retiré le texte qui le contient.</translation>
    </message>
    <message>
        <source>The system in the video is larger than 8 MB.</source>
        <translation>Le système de la vidéo dépasse 8 Mo.</translation>
    </message>
</context>
<context>
    <name>VideoWriter</name>
    <message>
        <source>There is not enough memory for a frame of the video.</source>
        <translation>La mémoire ne suffit pas pour une image de la vidéo.</translation>
    </message>
    <message>
        <source>A frame of the GIF cannot be created.</source>
        <translation>Une image du GIF ne peut pas être créée.</translation>
    </message>
    <message>
        <source>The animation cannot be stored in the video.</source>
        <translation>L’animation ne peut pas être enregistrée dans la vidéo.</translation>
    </message>
    <message>
        <source>A side of %1 pixels is too long for this format; the limit is %2.</source>
        <translation>Un côté de %1 pixels est trop long pour ce format&#x202f;; la limite est %2.</translation>
    </message>
    <message>
        <source>This format shows at most %1 frames per second. Choose a lower rate.</source>
        <translation>Ce format montre au plus %1 images par seconde. Choisissez une cadence plus basse.</translation>
    </message>
    <message>
        <source>This build of Barycage does not include FFmpeg&apos;s libraries and cannot write videos. Write the frames as PNG pictures instead.</source>
        <translation>Ce Barycage a été compilé sans les bibliothèques de FFmpeg et n’écrit pas de vidéos. Écrivez plutôt les images en PNG.</translation>
    </message>
    <message>
        <source>There is not enough memory for the palette of the GIF.</source>
        <translation>La mémoire ne suffit pas pour la palette du GIF.</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Recent files and the collection.</source>
        <translation>Les derniers fichiers et la collection.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenue</translation>
    </message>
    <message>
        <source>Continue with</source>
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
        <source>A file or the collection.</source>
        <translation>Un fichier ou la collection.</translation>
    </message>
    <message>
        <source>Start with</source>
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
        <source>Accepts the settings and closes the dialog.</source>
        <translation>Applique ce que montre le dialogue, et le ferme.</translation>
    </message>
    <message>
        <source>Closes the dialog without changing anything.</source>
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
    <message>
        <source>%1 Panel “%2”: %3</source>
        <comment>what it does, panel, what the panel is for</comment>
        <translation>%1 Panneau «&#x202f;%2&#x202f;»&#x202f;: %3</translation>
    </message>
</context>
<context>
    <name>WrittenBanner</name>
    <message>
        <source>Show in Folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Montre le dossier du fichier écrit dans le gestionnaire de fichiers.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Printed to a file</source>
        <translation>Imprimé dans un fichier</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>%1 a été écrit.</translation>
    </message>
</context>
<context>
    <name>document::CageActions</name>
    <message>
        <source>This entry is not a system in the plane, so it has no control cage.</source>
        <translation>Cette entrée n’est pas un système du plan&#x202f;; elle n’a donc pas de cage de contrôle.</translation>
    </message>
    <message>
        <source>The cage is too flat to be inverted. Open it by dragging a corner, or reset it, and try again.</source>
        <translation>La cage est trop plate pour que l’on puisse l’inverser. Ouvrez-la en déplaçant un sommet, ou réinitialisez-la, puis réessayez.</translation>
    </message>
    <message>
        <source>The three points are on one line, so they define no coordinates. Click a third point off the line.</source>
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
        <source>Vertex %1 is already there.</source>
        <translation>Le sommet %1 y est déjà.</translation>
    </message>
    <message>
        <source>A cage can have at most %1 vertices.</source>
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
        <source>A cage needs at least three vertices.</source>
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
        <source>Unbake: extract the placement from the code</source>
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
        <source>The cage is already the minimal canonical simplex.</source>
        <translation>La cage est déjà le simplexe canonique minimal.</translation>
    </message>
    <message>
        <source>The cage is already regular.</source>
        <translation>La cage est déjà régulière.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Déplacer le sommet %1 en (%2, %3)</translation>
    </message>
    <message>
        <source>The four points are in one plane, so they define no coordinates. Click the fourth point off the plane.</source>
        <translation>Les quatre points sont dans un même plan et ne définissent donc pas de coordonnées. Cliquez le quatrième point hors du plan.</translation>
    </message>
    <message>
        <source>Define the control tetrahedron</source>
        <translation>Définir le tétraèdre de contrôle</translation>
    </message>
</context>
<context>
    <name>document::Document</name>
    <message>
        <source>%1 (frame %2)</source>
        <comment>what is done, at which frame</comment>
        <translation>%1 (image %2)</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Cette entrée n’a pas d’applications du plan.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Forme affinement invariante</translation>
    </message>
    <message>
        <source>Row j of a matrix contains the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. Dragging the triangle does not change the matrices. If no entry is negative, the map takes the triangle to a part of itself.</source>
        <translation>La ligne j d’une matrice contient les coordonnées barycentriques, dans le triangle, de l’image du sommet j&#x202f;; la somme de chaque ligne est donc 1. Les matrices ne changent pas quand on déplace le triangle. Là où aucun coefficient n’est négatif, l’application envoie le triangle dans lui-même.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Each map as a matrix that acts on barycentric coordinates in the control triangle; every row sums to 1.</source>
        <translation>Chaque application comme une matrice qui, relativement au triangle de contrôle, envoie des coordonnées barycentriques sur des coordonnées barycentriques&#x202f;: la somme de chaque ligne est 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices at full precision.</source>
        <translation>Copie le triangle et les matrices avec tous les chiffres.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy includes all of them.
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
        <source>Copy all properties at full precision</source>
        <translation>Copier toutes les propriétés avec tous les chiffres</translation>
    </message>
    <message>
        <source>This entry could not be read, so it cannot be analysed.</source>
        <translation>Cette entrée n’a pas pu être lue&#x202f;: on n’en sait donc rien.</translation>
    </message>
    <message>
        <source>Copy at Full Precision</source>
        <translation>Copier avec tous les chiffres</translation>
    </message>
    <message>
        <source>Copies the name and the value of every line, at full precision.</source>
        <translation>Copie chaque ligne comme son nom et sa valeur avec tous les chiffres.</translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation>Sur le canevas</translation>
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
        <source>Show the mean and the covariance ellipse</source>
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
        <source>Length of the addresses</source>
        <translation>Longueur des adresses</translation>
    </message>
    <message>
        <source>The number of symbols in the addresses of the cylinders; fewer if there would be thousands of cylinders</source>
        <translation>Combien de symboles ont les adresses des cylindres&#x202f;; moins là où il y en aurait des milliers</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Longueur d’adresse</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system produces a bent picture. These are the properties of the code; on the canvas, the outlines bend with the picture.</source>
        <translation>La cage courbe l’image, et aucun système ne produit une image courbée. Ce sont les propriétés du code&#x202f;; sur le canevas, les contours se courbent avec l’image.</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with addresses of the same length, each in the colour of its first map; click one to see its address</source>
        <translation>Tracer les enveloppes de tous les morceaux dont l’adresse a la même longueur, dans la couleur de sa première application&#x202f;; cliquez sur l’une d’elles pour voir son adresse</translation>
    </message>
    <message>
        <source>This value is still being computed.</source>
        <translation>Cette valeur est encore en cours de calcul.</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>calcul en cours…</translation>
    </message>
    <message>
        <source>Branches are moved. Box, simplex, hull, mean and covariance are those of the picture; the other properties are those of the code.</source>
        <translation>Des branches sont déplacées. La boîte, le simplexe, l’enveloppe, la moyenne et la covariance sont ceux de l’image&#x202f;; les autres propriétés sont celles du code.</translation>
    </message>
    <message>
        <source>How Pieces Meet…</source>
        <translation>Comment les morceaux se touchent…</translation>
    </message>
    <message>
        <source>Read in the user guide what these properties mean and how they are proved</source>
        <translation>Lire dans le guide d’utilisation ce que signifient ces propriétés et comment elles sont prouvées</translation>
    </message>
    <message>
        <source>Opens the user guide where it explains how the pieces of an attractor meet.</source>
        <translation>Ouvre le guide d’utilisation à l’endroit qui explique comment les morceaux d’un attracteur se touchent.</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Copié.</translation>
    </message>
</context>
<context>
    <name>view::AnimationExportDialog</name>
    <message>
        <source>Export the Animation “%1”</source>
        <translation>Exporter l’animation «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>PNG: one picture for each frame</source>
        <translation>PNG&#x202f;: une image par trame</translation>
    </message>
    <message>
        <source>A video, an animated image for web pages and messages, or one picture for each frame. All of them contain the animation, so Barycage can open them again.</source>
        <translation>Une vidéo, une image animée pour les pages et les messages, ou une image par trame. Toutes contiennent l’animation, et Barycage les rouvre.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format&#x202f;:</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Cadrage</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vue du canevas</translation>
    </message>
    <message>
        <source>The whole animation</source>
        <translation>Toute l’animation</translation>
    </message>
    <message>
        <source>What the frames show where the camera has no keys: the view on the canvas, or everything that becomes visible, with a small margin.</source>
        <translation>Ce que montrent les images quand aucune clé de la caméra ne le fixe&#x202f;: ce que montre le canevas, ou tout ce qui apparaît, avec une petite marge.</translation>
    </message>
    <message>
        <source>&amp;Size in pixels:</source>
        <translation>Taille en pixel&amp;s&#x202f;:</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>The first frame to export.</source>
        <translation>La première image à exporter.</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>The last frame to export.</source>
        <translation>La dernière image à exporter.</translation>
    </message>
    <message>
        <source>F&amp;rames:</source>
        <translation>Ima&amp;ges&#x202f;:</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>The number of points for each pixel of each frame: more points make smoother frames and take longer.</source>
        <translation>Le nombre de points pour chaque pixel de chaque image&#x202f;: plus il y en a, plus les images sont lisses et longues à dessiner.</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Brouillon&#x202f;: 25 points par pixel</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Bonne&#x202f;: 100 points par pixel</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Fine&#x202f;: 400 points par pixel</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Très fine&#x202f;: 2000 points par pixel</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>&amp;Qualité&#x202f;:</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Obturateur</translation>
    </message>
    <message>
        <source>Motion blur: the angle for which the shutter is open around each frame. 180° is half the time of a frame, as in films.</source>
        <translation>Flou de mouvement&#x202f;: l’angle pendant lequel l’obturateur est ouvert autour de chaque image. 180° valent la moitié du temps d’une image, comme au cinéma.</translation>
    </message>
    <message>
        <source>No motion blur</source>
        <translation>Pas de flou de mouvement</translation>
    </message>
    <message>
        <source>S&amp;hutter:</source>
        <translation>O&amp;bturateur&#x202f;:</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposition</translation>
    </message>
    <message>
        <source>Smooth: no flicker</source>
        <translation>Lissée&#x202f;: sans scintillement</translation>
    </message>
    <message>
        <source>Fixed: as in frame 0</source>
        <translation>Fixe&#x202f;: celle de l’image 0</translation>
    </message>
    <message>
        <source>Each: frame by frame</source>
        <translation>Chacune&#x202f;: pour elle-même</translation>
    </message>
    <message>
        <source>How bright the frames are: following the whole animation without flicker, all like frame 0, or each as bright as it is on the canvas.</source>
        <translation>La luminosité des images&#x202f;: suivant toute l’animation sans scintillement, toutes comme l’image 0, ou chacune comme sur le canevas.</translation>
    </message>
    <message>
        <source>E&amp;xposure:</source>
        <translation>E&amp;xposition&#x202f;:</translation>
    </message>
    <message>
        <source>Tasks on a cluster</source>
        <translation>Tâches sur une grappe</translation>
    </message>
    <message>
        <source>How many cluster tasks share the frames when you choose On a Cluster.</source>
        <translation>Entre combien de tâches d’une grappe les images sont réparties avec «&#x202f;Sur une grappe&#x202f;».</translation>
    </message>
    <message>
        <source>&amp;Tasks on a cluster:</source>
        <translation>&amp;Tâches sur une grappe&#x202f;:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the animation. You can continue editing in the meantime: the animation is exported as it was when this dialog opened.</source>
        <translation>Demande un nom de fichier et écrit l’animation. Vous pouvez continuer à éditer&#x202f;: l’animation est exportée telle qu’elle était à l’ouverture de ce dialogue.</translation>
    </message>
    <message>
        <source>On a &amp;Cluster…</source>
        <translation>Sur une grapp&amp;e…</translation>
    </message>
    <message>
        <source>Writes a folder with the animation and with scripts that draw it on a Slurm cluster, and submits the job if sbatch is found.</source>
        <translation>Écrit un dossier avec l’animation et les scripts qui la dessinent sur une grappe Slurm, et le soumet là où sbatch est trouvé.</translation>
    </message>
    <message>
        <source>Export Animation</source>
        <translation>Exporter l’animation</translation>
    </message>
    <message>
        <source>Measuring the brightness…</source>
        <translation>Mesure de la luminosité…</translation>
    </message>
    <message>
        <source>Export stopped. The pictures written so far are complete; export again to draw the others.</source>
        <translation>Exportation arrêtée. Les images déjà écrites sont complètes&#x202f;; exportez de nouveau pour dessiner les autres.</translation>
    </message>
    <message>
        <source>Written to %1 and so on, up to %2.</source>
        <translation>Écrit dans %1 et ainsi de suite jusqu’à %2.</translation>
    </message>
    <message>
        <source>Folder That the Cluster Can Read and Write</source>
        <translation>Dossier que la grappe peut lire et écrire</translation>
    </message>
    <message>
        <source>Writing the job folder…</source>
        <translation>Écriture du dossier du travail…</translation>
    </message>
    <message>
        <source>Cancelled; the folder may be incomplete.</source>
        <translation>Annulé&#x202f;; le dossier est peut-être incomplet.</translation>
    </message>
    <message>
        <source>The job is in %1. sbatch was not found on this computer: run submit.sh in this folder on the cluster.</source>
        <translation>Le travail est dans %1. Il n’y a pas de sbatch ici&#x202f;: lancez submit.sh de ce dossier sur la grappe.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>La vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Image sans attracteur</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Ca&amp;drage&#x202f;:</translation>
    </message>
    <message>
        <source>The animation “%1” is still being exported.</source>
        <translation>L’animation «&#x202f;%1&#x202f;» est encore en cours d’export.</translation>
    </message>
    <message>
        <source>The pictures written so far are complete and will be kept.</source>
        <translation>Les images déjà écrites sont complètes et seront conservées.</translation>
    </message>
    <message>
        <source>Summary of the export</source>
        <translation>Résumé de l’exportation</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), %1 s.</source>
        <translation>
            <numerusform>%n image, %1 s.</numerusform>
            <numerusform>%n images, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for existing pictures…</source>
        <translation>Recherche d’images existantes…</translation>
    </message>
    <message>
        <source>Replace Files?</source>
        <translation>Remplacer les fichiers&#x202f;?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) with the names of these pictures exist already and hold something else.</source>
        <translation>
            <numerusform>%n fichier portant le nom d’une de ces images existe déjà et contient autre chose.</numerusform>
            <numerusform>%n fichiers portant les noms de ces images existent déjà et contiennent autre chose.</numerusform>
        </translation>
    </message>
    <message>
        <source>The first one is “%1”. If you replace them, their contents are lost.</source>
        <translation>Le premier est «&#x202f;%1&#x202f;». Si vous les remplacez, leur contenu est perdu.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Frame of the preview</source>
        <translation>Image de l’aperçu</translation>
    </message>
    <message>
        <source>The frame that the preview shows</source>
        <translation>L’image que montre l’aperçu</translation>
    </message>
    <message>
        <source>Choose how many tasks share the frames, then click On a Cluster… again.</source>
        <translation>Choisissez combien de tâches se partagent les images, puis cliquez de nouveau sur «&#x202f;Sur une grappe…&#x202f;».</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Suréchantillonnage</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Dessine autant de pixels le long de chaque côté d’un pixel&#x202f;: des bords plus lisses.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>S&amp;uréchantillonnage&#x202f;:</translation>
    </message>
    <message>
        <source>%1 needs even sides: the last column or row is shown twice.</source>
        <translation>%1 exige des côtés pairs&#x202f;: la dernière colonne ou ligne est montrée deux fois.</translation>
    </message>
    <message>
        <source>%1 has no transparency: the background becomes black.</source>
        <translation>%1 n’a pas de transparence&#x202f;: le fond devient noir.</translation>
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
        <source>Reset every setting of this panel to its default</source>
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
        <source>Colour by the density of points</source>
        <translation>La palette suit la densité des points</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Application</translation>
    </message>
    <message>
        <source>Colour by the last map applied</source>
        <translation>La couleur de la dernière application appliquée</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Colour by the address of each point</source>
        <translation>La palette suit l’adresse de chaque point</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Uni</translation>
    </message>
    <message>
        <source>One colour, with the density as its opacity</source>
        <translation>Une seule couleur&#x202f;; la densité en donne l’opacité</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Couleur unie</translation>
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
        <source>How strongly thin parts show: κ of the logarithmic tone curve</source>
        <translation>À partir de quelle densité les parties ténues deviennent visibles&#x202f;: κ de la courbe de tons logarithmique</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
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
        <source>Makes the background of exported pictures transparent.</source>
        <translation>Omet le fond dans les images exportées.</translation>
    </message>
    <message>
        <source>Computes every pixel from several smaller ones: smoother edges, at the cost of memory and time.</source>
        <translation>Dessine chaque pixel à partir de plusieurs pixels plus fins&#x202f;: des bords plus lisses, pour plus de mémoire et de temps.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Colorer selon&#x202f;: %1</translation>
    </message>
    <message>
        <source>Palette: %1</source>
        <translation>Palette&#x202f;: %1</translation>
    </message>
    <message>
        <source>Supersampling: %1</source>
        <translation>Suréchantillonnage&#x202f;: %1</translation>
    </message>
    <message>
        <source>More Palettes…</source>
        <translation>Plus de palettes…</translation>
    </message>
    <message>
        <source>Browse hundreds of palettes, change their hue and shift them</source>
        <translation>Parcourir des centaines de palettes, les tourner et les décaler</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>Above 1, light parts become lighter and dark parts darker</source>
        <translation>Au-dessus de 1, les parties claires s’éclaircissent et les sombres s’assombrissent</translation>
    </message>
    <message>
        <source>Above 1, tones lighter than the middle become lighter, and darker ones darker. Below 1, they come closer together. Black, middle and white stay.</source>
        <translation>Au-dessus de 1, les tons plus clairs que le ton moyen s’éclaircissent et les plus sombres s’assombrissent. Au-dessous de 1, ils se rapprochent. Le noir, le ton moyen et le blanc ne changent pas.</translation>
    </message>
    <message>
        <source>Vibrancy</source>
        <translation>Vivacité</translation>
    </message>
    <message>
        <source>Below 1, colours are paler, the more so the higher the gamma</source>
        <translation>Au-dessous de 1, les couleurs sont plus pâles, d’autant plus que le gamma est élevé</translation>
    </message>
    <message>
        <source>At 1, the gamma decides only how strongly a colour shows, and the colour keeps its hue. At 0, the gamma acts on red, green and blue as well, and colours are paler. Flames have the same setting.</source>
        <translation>À 1, le gamma décide seulement de la force avec laquelle une couleur apparaît, et la couleur garde sa teinte. À 0, le gamma agit aussi sur le rouge, le vert et le bleu, et les couleurs sont plus pâles. Les flammes ont le même réglage.</translation>
    </message>
    <message>
        <source>What the colour of a point shows: how many points fall there, which map came last, the whole address, or the blend of the colours of all maps applied, as in flames. The position of each map on the palette, and its speed, are in the Maps panel.</source>
        <translation>Ce que dit la couleur d’un point&#x202f;: combien de points tombent là, quelle application a agi en dernier, l’adresse entière, ou le mélange des couleurs de toutes les applications du chemin, comme dans les flames. Le panneau Applications a la place de chaque application sur la palette, et sa vitesse.</translation>
    </message>
    <message>
        <source>Blend of maps</source>
        <translation>Mélange des applications</translation>
    </message>
    <message>
        <source>As in flames: each map moves colours towards its position on the palette</source>
        <translation>Comme dans les flames&#x202f;: chaque application attire les couleurs vers sa place sur la palette</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, along the addresses, or along the positions between which maps blend.</source>
        <translation>Les couleurs, des parties les plus ténues aux plus denses, le long des adresses, ou le long des places entre lesquelles les applications mélangent.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Ombre</translation>
    </message>
    <message>
        <source>Opacity of the shadow on the ground behind the picture; 0: no shadow</source>
        <translation>Opacité de l’ombre au sol derrière l’image&#x202f;; 0&#x202f;: pas d’ombre</translation>
    </message>
    <message>
        <source>The shadow is the picture once more: darker, flattened, and laid on the ground on which the picture stands. Drag its tip on the canvas to turn it.</source>
        <translation>L’ombre est l’image une seconde fois&#x202f;: plus sombre, aplatie et étendue sur le sol où l’image est posée. Faites glisser sa pointe sur le canevas pour la tourner.</translation>
    </message>
    <message>
        <source>Shadow sideways</source>
        <translation>Ombre de côté</translation>
    </message>
    <message>
        <source>How far to the right the shadow of what is 1 high ends; below 0, to the left</source>
        <translation>À quelle distance à droite finit l’ombre de ce qui est haut de 1&#x202f;; au-dessous de 0, à gauche</translation>
    </message>
    <message>
        <source>Shadow backwards</source>
        <translation>Ombre vers l’arrière</translation>
    </message>
    <message>
        <source>How far up the shadow of what is 1 high ends; below 0, it falls to the front</source>
        <translation>À quelle hauteur finit l’ombre de ce qui est haut de 1&#x202f;; au-dessous de 0, elle tombe vers l’avant</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The field next to it shows the same value.</source>
        <translation>Faites glisser, ou utilisez les touches fléchées. Le nombre à côté est la même valeur.</translation>
    </message>
</context>
<context>
    <name>view::AttractorWatch</name>
    <message>
        <source>At frame %1, it could not be decided whether there is an attractor.</source>
        <translation>À l’image %1, il n’a pas été possible de décider s’il existe un attracteur.</translation>
    </message>
    <message>
        <source>Weaken the motions.</source>
        <translation>Affaiblissez les mouvements.</translation>
    </message>
    <message>
        <source>Change the maps.</source>
        <translation>Modifiez les applications.</translation>
    </message>
    <message>
        <source>Weaken the motions, or change the keys of the maps (frames: %1).</source>
        <translation>Affaiblissez les mouvements, ou modifiez les clés des applications (images&#x202f;: %1).</translation>
    </message>
    <message>
        <source>Change the keys of the maps (frames: %1).</source>
        <translation>Modifiez les clés des applications (images&#x202f;: %1).</translation>
    </message>
    <message>
        <source>Set a key there, or change the keys of the maps (frames: %1).</source>
        <translation>Posez-y une clé, ou modifiez les clés des applications (images&#x202f;: %1).</translation>
    </message>
    <message>
        <source>At frame %1, there is no attractor.</source>
        <translation>À l’image %1, il n’y a pas d’attracteur.</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Diagramme du comptage de boîtes</translation>
    </message>
    <message>
        <source>The number of boxes that meet the attractor, against their fineness: log₂ N over k for boxes of side L·2⁻ᵏ, where L is the side of the square around the attractor. Hollow points are not used for the line: at those sizes, the size of the whole or of a cell affects the count.</source>
        <translation>Combien de boîtes rencontrent l’attracteur selon leur finesse&#x202f;: log₂ N en fonction de k pour des boîtes de côté L·2⁻ᵏ, L le côté du carré autour de l’attracteur. Les points évidés ne comptent pas pour la droite&#x202f;: là se voit la taille de l’ensemble ou d’une cellule.</translation>
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
        <source>The number of maps in the address of the branch (Shift + wheel over the canvas)</source>
        <translation>Combien d’applications de l’adresse nomment la branche (Maj + molette sur le canevas)</translation>
    </message>
    <message>
        <source>The address of the clicked point, outermost map first; the bold part is the address of the branch</source>
        <translation>L’adresse du point cliqué, l’application la plus extérieure d’abord&#x202f;; la partie en gras est l’adresse de la branche</translation>
    </message>
    <message>
        <source>New map for this branch</source>
        <translation>Nouvelle application pour cette branche</translation>
    </message>
    <message>
        <source>Gives this branch and each of its sibling branches a map of its own. The change appears again at all smaller scales.</source>
        <translation>Cette branche et chacune de ses branches sœurs reçoivent leur propre application. Le changement réapparaît à toutes les échelles plus petites.</translation>
    </message>
    <message>
        <source>Last map of the address</source>
        <translation>Dernière application de l’adresse</translation>
    </message>
    <message>
        <source>The system keeps its number of maps. All branches that this map makes change in the same way.</source>
        <translation>Le système garde le même nombre d’applications. Toutes les branches que produit cette application changent de la même façon.</translation>
    </message>
    <message>
        <source>What editing the branch changes</source>
        <translation>Ce que change une modification de la branche</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Angle dont les applications choisies oscillent autour de leurs racines</translation>
    </message>
    <message>
        <source>Swings the selected maps, each about the image of the lowest point of the fractal; the slider returns to the middle when you release it</source>
        <translation>Fait osciller les applications choisies, chacune autour de l’image du point le plus bas de la fractale&#x202f;; relâché, le curseur revient au milieu</translation>
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
        <source>Swing maps</source>
        <translation>Faire osciller des applications</translation>
    </message>
    <message>
        <source>Only here</source>
        <translation>Seulement ici</translation>
    </message>
    <message>
        <source>The code does not change. Only this branch is shown in another position; the same change does not appear at other scales.</source>
        <translation>Le code ne change pas. Seule cette branche est montrée ailleurs&#x202f;; le changement ne se répète pas aux autres échelles.</translation>
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
        <source>Shows the branch in its original position, given by its maps</source>
        <translation>Montre la branche là où ses applications la mettent</translation>
    </message>
    <message>
        <source>Shows all branches in their original positions, given by their maps</source>
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
    <message>
        <source>What changes in the code when you drag the branch</source>
        <translation>Ce qui change dans le code quand vous faites glisser la branche</translation>
    </message>
    <message>
        <source>Here and inside it</source>
        <translation>Ici et à l’intérieur</translation>
    </message>
    <message>
        <source>The code does not change. This branch is shown in another position, and so is the same branch inside it, again and again: a frond curls up. Nothing beside it changes.</source>
        <translation>Le code ne change pas. Cette branche est affichée dans une autre position, et de même la même branche à l’intérieur, encore et encore&#x202f;: une fronde s’enroule. Rien ne change à côté.</translation>
    </message>
    <message>
        <source>Maps cannot swing while the cage is flat. First open or reset the cage.</source>
        <translation>Les applications ne peuvent pas osciller tant que la cage est plate. Ouvrez ou réinitialisez d’abord la cage.</translation>
    </message>
    <message>
        <source>S&amp;wing</source>
        <translation>&amp;Balancer</translation>
    </message>
</context>
<context>
    <name>view::BranchChoice</name>
    <message>
        <source>Branch %1</source>
        <translation>Branche %1</translation>
    </message>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Cliquez sur un point de l’attracteur pour choisir sa branche.</translation>
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
        <source>Move corner %1 of branch %2</source>
        <translation>Déplacer le coin %1 de la branche %2</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Déplacer la branche %1</translation>
    </message>
    <message>
        <source>This branch is now map 1. You can change it further in the table.</source>
        <translation>Cette branche est maintenant l’application 1. Les nombres du tableau continuent de la modifier.</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Arrêté&#x202f;: au-delà, la branche ne deviendrait pas plus petite à l’intérieur d’elle-même.</translation>
    </message>
</context>
<context>
    <name>view::CageFitter</name>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>L’image est trop mince pour une telle cage.</translation>
    </message>
    <message>
        <source>The cage already has this shape.</source>
        <translation>La cage y est déjà.</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Ajuster la cage</translation>
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
        <source>Moving the cage moves the picture; the code does not change</source>
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
        <source>The picture follows every vertex and bends; a bent picture cannot be baked into the code</source>
        <translation>Chaque sommet est suivi&#x202f;; l’image se courbe, ce qui ne peut pas être intégré à un code</translation>
    </message>
    <message>
        <source>The picture follows the vertices by the closest affine map; it can be baked</source>
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
        <source>Define the triangle with three clicks on the canvas; the picture stays</source>
        <translation>Définir le triangle en trois clics sur le canevas&#x202f;; l’image reste</translation>
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
        <source>Show the positions of the vertices when the cage is at rest</source>
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
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from the right angle.</source>
        <translation>Le plus petit triangle rectangle isocèle aux cathètes parallèles aux axes qui contient l’image. Les signes disent de quel côté pointent ses cathètes depuis l’angle droit.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Coordonnées barycentriques d’un point</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 for which the point is the weighted mean of the vertices.</source>
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
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Les trois points sont alignés&#x202f;: la cage au repos doit entourer une aire.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>La cage au repos doit être un polygone non croisé.</translation>
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
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Cette entrée n’a pas pu être lue&#x202f;; elle n’a donc pas de cage.</translation>
    </message>
    <message>
        <source>At rest: the picture shows the code.</source>
        <translation>Au repos&#x202f;: l’image est celle du code.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture shows the code.</source>
        <translation>%1 sommets, au repos&#x202f;: l’image est celle du code.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates; cannot be baked.</source>
        <translation>%1 sommets&#x202f;: image courbée par les coordonnées de Wachspress, impossible à intégrer au code.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates; cannot be baked.</source>
        <translation>%1 sommets&#x202f;: image courbée par les coordonnées de la valeur moyenne, impossible à intégrer au code.</translation>
    </message>
    <message>
        <source>Flat: the picture is squeezed onto a line. Open the cage to get it back.</source>
        <translation>Plate&#x202f;: l’image est tout entière sur une droite. Ouvrez la cage et elle réapparaît.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the orientation is reversed.</source>
        <translation>Placée et retournée&#x202f;: les aires sont multipliées par %1, et l’orientation est inversée.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Placée&#x202f;: les aires sont multipliées par %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it defines no coordinates.</source>
        <translation>Le triangle est plat&#x202f;: il ne porte pas de coordonnées.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, cathète %2, angle droit en (%3, %4)</translation>
    </message>
    <message>
        <source>Replace the cage by one fitted to the picture; the picture stays</source>
        <translation>Tenir l’image par une cage ajustée&#x202f;; l’image reste</translation>
    </message>
    <message>
        <source>Return the cage and the picture to rest</source>
        <translation>Remettre la cage et l’image au repos</translation>
    </message>
    <message>
        <source>Write the displayed picture into the code; the cage is then at rest</source>
        <translation>Faire de l’image affichée le code&#x202f;; la cage est ensuite au repos</translation>
    </message>
    <message>
        <source>Available for triangles only.</source>
        <translation>Disponible pour les triangles seulement.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Déplacer le sommet %1 en (%2, %3)</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3)</source>
        <translation>Définir le sommet %1 en (%2, %3)</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>z at rest</source>
        <translation>z au repos</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from their common corner.</source>
        <translation>Le plus petit tétraèdre à trois arêtes égales parallèles aux axes qui contient l’image. Les signes disent où pointent ces arêtes depuis leur sommet commun.</translation>
    </message>
    <message>
        <source>The weights a, b, c, d with a + b + c + d = 1 for which the point is the weighted mean of the vertices.</source>
        <translation>Les poids a, b, c, d de somme a + b + c + d = 1 à placer aux sommets pour que le point soit leur barycentre.</translation>
    </message>
    <message>
        <source>z of the point</source>
        <translation>z du point</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3, %4)</source>
        <translation>Déplacer le sommet %1 en (%2, %3, %4)</translation>
    </message>
    <message>
        <source>The vertices are in one plane: the rest cage must enclose a volume.</source>
        <translation>Les sommets sont dans un même plan&#x202f;: la cage au repos doit enfermer un volume.</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3, %4)</source>
        <translation>Définir le sommet %1 en (%2, %3, %4)</translation>
    </message>
    <message>
        <source>Flat: the solid is squeezed onto a plane or a line. Open the cage to get it back.</source>
        <translation>Aplatie&#x202f;: le solide est écrasé sur un plan ou une droite. Ouvrez la cage et il revient.</translation>
    </message>
    <message>
        <source>Placed and mirrored: volumes change by the factor %1, and the orientation is reversed.</source>
        <translation>Placée et retournée&#x202f;: les volumes sont multipliés par %1 et l’orientation est renversée.</translation>
    </message>
    <message>
        <source>Placed: volumes change by the factor %1.</source>
        <translation>Placée&#x202f;: les volumes sont multipliés par %1.</translation>
    </message>
    <message>
        <source>Available for tetrahedra only.</source>
        <translation>Disponible pour les tétraèdres seulement.</translation>
    </message>
    <message>
        <source>The tetrahedron is flat: it defines no coordinates.</source>
        <translation>Le tétraèdre est plat&#x202f;: il ne porte pas de coordonnées.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Ce système n’a pas d’attracteur que l’on puisse enfermer.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4, %5)</source>
        <translation>%1, arête %2, sommet (%3, %4, %5)</translation>
    </message>
    <message>
        <source>The system has very many maps. Computing the cage around it…</source>
        <translation>Le système a de très nombreuses applications&#x202f;: la cage qui l’entoure est en cours de calcul…</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, cannot be baked.</source>
        <translation>%1 sommets&#x202f;: image courbée par les coordonnées de la valeur moyenne, impossible à intégrer au code.</translation>
    </message>
    <message>
        <source>Define the tetrahedron with four clicks on the canvas; the picture stays</source>
        <translation>Définit le tétraèdre par quatre clics sur le canevas&#x202f;; l’image reste</translation>
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
        <source>Select a corner first.</source>
        <translation>Choisissez d’abord un sommet.</translation>
    </message>
    <message>
        <source>To insert a corner, point to an edge or select a corner.</source>
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
        <source>No attractor: the maps %1, applied one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Pas d’attracteur&#x202f;: les applications %1, l’une après l’autre, ne sont pas contractantes (plus grande valeur singulière %2, rayon spectral %3). Réduisez l’une d’elles, ou désactivez-la.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor: map %1 stretches by up to %2. Points that escape are left out.</source>
        <translation>On n’a pas pu décider si ce système a un attracteur&#x202f;: l’application %1 étire d’un facteur %2. Les points qui s’échappent sont omis.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor. Points that escape are left out.</source>
        <translation>On n’a pas pu décider si ce système a un attracteur. Les points qui s’échappent sont omis.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept unchanged in the file.</source>
        <translation>Cette entrée n’a pas pu être lue. Son texte est conservé tel qu’il est dans le fichier.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Aucune application n’est active&#x202f;: il n’y a rien à dessiner. Ajoutez une application ou activez-en une.</translation>
    </message>
    <message>
        <source>This is the limit of numerical precision: zoom out a little for an accurate picture.</source>
        <translation>L’arithmétique ne descend pas plus profond&#x202f;: faites un petit zoom arrière pour une image fidèle.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than requested: more would exceed the memory limit.</source>
        <translation>Dessiné avec moins d’itérations que demandé&#x202f;: davantage exigerait plus de mémoire que permis.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a corner to open it: nothing is lost.</source>
        <translation>La cage est plate, et l’image aussi. Tirez un sommet pour l’ouvrir&#x202f;: rien n’est perdu.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Arrêté&#x202f;: plus loin, l’application %1 ne contracterait pas (plus grande valeur singulière %2, rayon spectral %3), et il n’y aurait pas d’attracteur.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, the maps %1, applied one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Arrêté&#x202f;: plus loin, les applications %1, l’une après l’autre, ne contracteraient pas (plus grande valeur singulière %2, rayon spectral %3), et il n’y aurait pas d’attracteur.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, an attractor is not guaranteed (map %1 has the largest singular value, %2).</source>
        <translation>Arrêté&#x202f;: au-delà, l’existence d’un attracteur n’est pas garantie (l’application %1 a la plus grande valeur singulière, %2).</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point is left.</source>
        <translation>Une seule application&#x202f;: il ne reste que son point fixe.</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point (%1, %2) is left.</source>
        <translation>Une seule application&#x202f;: il ne reste que son point fixe (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is switched on has a positive weight, so there is nothing to draw. Give one of them a weight.</source>
        <translation>Aucune application activée n’a un poids supérieur à 0&#x202f;: il n’y a rien à dessiner. Donnez un poids à l’une d’elles.</translation>
    </message>
    <message>
        <source>Whether this system has an attractor is undecided.</source>
        <translation>On ne sait pas si ce système a un attracteur.</translation>
    </message>
    <message>
        <source>This system has no attractor, so the picture may be incomplete or empty.</source>
        <translation>Ce système n’a pas d’attracteur&#x202f;; l’image peut être incomplète ou vide.</translation>
    </message>
    <message>
        <source>So many pieces overlap that parts of this solid may be missing. The look Cloud shows all of it.</source>
        <translation>Tant de morceaux se superposent que des parties de ce solide peuvent manquer. L’aspect «&#x202f;Nuage&#x202f;» le montre en entier.</translation>
    </message>
    <message>
        <source>What lies far behind this small view may be drawn in the wrong order. Zoom out a little for an accurate picture.</source>
        <translation>Ce qui se trouve loin derrière cette petite vue peut être dessiné dans le mauvais ordre. Faites un petit zoom arrière pour une image fidèle.</translation>
    </message>
    <message>
        <source>Nothing here. Press %1 to see the whole picture.</source>
        <translation>Rien ici. Appuyez sur %1 pour voir toute l’image.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Déplacer la cage réécrit le code</translation>
    </message>
</context>
<context>
    <name>view::CanvasInput</name>
    <message>
        <source>Cylinder %1</source>
        <translation>Cylindre %1</translation>
    </message>
    <message>
        <source>Corner outside the view: click to fit the picture and its cage</source>
        <translation>Coin hors de la vue&#x202f;: cliquez pour cadrer l’image et sa cage</translation>
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
        <source>Lets you type the coordinates of this vertex</source>
        <translation>Permet de saisir les coordonnées de ce sommet</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>Ré&amp;initialiser ce sommet</translation>
    </message>
    <message>
        <source>Returns this vertex to its position at rest</source>
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
        <source>Removes this vertex from the cage</source>
        <translation>Retirer ce sommet de la cage</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>Placer le &amp;pivot ici</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about this vertex</source>
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
        <source>Inserts a vertex on this edge; double-clicking does the same</source>
        <translation>Mettre un sommet de plus sur cette arête&#x202f;; un double-clic fait de même</translation>
    </message>
    <message>
        <source>Rotate: hold Shift for steps of 15°</source>
        <translation>Rotation&#x202f;: Maj tourne par pas de 15°</translation>
    </message>
    <message>
        <source>Scale: hold Shift for x or y only</source>
        <translation>Échelle&#x202f;: Maj s’en tient à x ou à y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Centre</source>
        <translation>Placer le &amp;pivot au milieu</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about its centre</source>
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
        <source>Fits the smallest isosceles right triangle with legs parallel to the axes around the picture</source>
        <translation>Ajuste autour de l’image le plus petit triangle rectangle isocèle à côtés parallèles aux axes</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Définir un triangle</translation>
    </message>
    <message>
        <source>Defines the triangle with three clicks; the picture stays</source>
        <translation>Tenir l’image par trois points choisis d’un clic</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>&amp;Réinitialiser la cage</translation>
    </message>
    <message>
        <source>Returns every vertex to its position at rest</source>
        <translation>Remettre tous les sommets au repos</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Rendre régu&amp;lière</translation>
    </message>
    <message>
        <source>Moves the vertices to the nearest regular polygon</source>
        <translation>Mettre les sommets sur le polygone régulier le plus proche</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw the picture as shown, with the cage at rest</source>
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
        <source>Shows one unit of the plane as one hundred pixels</source>
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
        <source>Points the y axis down, as in window coordinates</source>
        <translation>Dirige l’axe y vers le bas, comme dans les coordonnées d’une fenêtre</translation>
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
        <source>Copies the picture as shown, without the cage</source>
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
        <source>Switches this map on or off</source>
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
        <source>Adds a copy of this map</source>
        <translation>Met une copie de cette application à côté</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Removes this map from the system</source>
        <translation>Retire cette application du système</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>Dé&amp;verrouiller</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Verrouiller</translation>
    </message>
    <message>
        <source>Lets this map be edited again</source>
        <translation>Permet de nouveau de modifier cette application</translation>
    </message>
    <message>
        <source>Locks this map against editing</source>
        <translation>Protège cette application des modifications</translation>
    </message>
    <message>
        <source>&amp;Reset Rotation</source>
        <translation>Annuler la r&amp;otation</translation>
    </message>
    <message>
        <source>Returns the view to upright</source>
        <translation>Redresse la vue</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Intégrer au code</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Zone de dessin</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab moves from handle to handle, the arrow keys move the handle in focus, F6 leaves the canvas.</source>
        <translation>L’attracteur et sa cage de contrôle. Tab passe d’une poignée à l’autre, les touches fléchées déplacent celle qui a le focus, F6 quitte le canevas.</translation>
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
        <source>Reset the cage first?</source>
        <translation>Remettre d’abord la cage au repos&#x202f;?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Réinitialiser la cage</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press %1 to see the cage again.</source>
        <translation>Seule l’image est affichée. Appuyez sur %1 pour revoir la cage.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; hold Ctrl to rotate, Alt to scale, Shift to keep directions. The wheel zooms at the pointer, the middle button pans. Tab moves from handle to handle, the arrow keys move the handle, F6 leaves the canvas.</source>
        <translation>L’image et sa cage. Tirez un sommet, une arête ou l’intérieur de la cage&#x202f;; Ctrl fait tourner, Alt redimensionne, Maj garde les directions. La molette zoome sur le pointeur, le bouton du milieu déplace le plan. Tab passe d’une poignée à l’autre, les touches fléchées les déplacent, F6 quitte la zone.</translation>
    </message>
</context>
<context>
    <name>view::ClusterQueue</name>
    <message>
        <source>%1 running</source>
        <translation>%1 en cours</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 en attente</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 en échec</translation>
    </message>
    <message>
        <source>Drawing: %1.</source>
        <translation>Dessin&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Video: done.</source>
        <translation>Vidéo&#x202f;: terminée.</translation>
    </message>
    <message>
        <source>Video: failed.</source>
        <translation>Vidéo&#x202f;: échec.</translation>
    </message>
    <message>
        <source>Video: running.</source>
        <translation>Vidéo&#x202f;: en cours.</translation>
    </message>
    <message>
        <source>Video: waiting.</source>
        <translation>Vidéo&#x202f;: en attente.</translation>
    </message>
    <message>
        <source>Submitting…</source>
        <translation>Soumission…</translation>
    </message>
    <message>
        <source>The script ended without submitting anything.</source>
        <translation>Le script s’est terminé sans rien soumettre.</translation>
    </message>
    <message>
        <source>The result is in %1.</source>
        <translation>Le résultat est dans %1.</translation>
    </message>
    <message>
        <source>The reason is in the logs in %1.</source>
        <translation>La raison est dans les journaux de %1.</translation>
    </message>
    <message>
        <source>Slurm did not accept the job: %1</source>
        <translation>Slurm n’a pas accepté le travail&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 sur %2 terminées</translation>
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
        <translation>Couverture</translation>
    </message>
    <message>
        <source>The part of the target that is covered</source>
        <translation>La part de la cible qui est couverte</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Excédent</translation>
    </message>
    <message>
        <source>Overlap (IoU)</source>
        <translation>Recouvrement (IoU)</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Distance moyenne</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % à moins de</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Plus grande distance</translation>
    </message>
    <message>
        <source>The Hausdorff distance; the mark on the canvas shows where it is</source>
        <translation>La distance de Hausdorff&#x202f;; la marque sur le canevas montre où elle se trouve</translation>
    </message>
    <message>
        <source>%1 (s = %2)</source>
        <translation>%1 (s = %2)</translation>
    </message>
    <message>
        <source>none: a map stretches by %1</source>
        <translation>aucune&#x202f;: une application étire de %1</translation>
    </message>
    <message>
        <source>No point of the target is farther from the attractor than this, and no point of the attractor from the target. The value is larger during a drag, when a coarser picture is measured</source>
        <translation>Aucun point de la cible n’est plus loin de l’attracteur que cela, ni l’inverse. Elle est plus grande pendant que vous faites glisser, car une image plus grossière est mesurée</translation>
    </message>
    <message>
        <source>%1 (ellipsoidal norm, γ = %2)</source>
        <translation>%1 (norme ellipsoïdale, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (polytope norm, γ = %2)</source>
        <translation>%1 (norme polytopale, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (any %2 maps in a row contract, γ = %3)</source>
        <translation>%1 (%2 applications consécutives contractent, γ = %3)</translation>
    </message>
    <message>
        <source>The area covered outside the target, relative to the area of the target</source>
        <translation>L’aire couverte hors de la cible, rapportée à l’aire de la cible</translation>
    </message>
    <message>
        <source>The area that both cover, relative to the area that either covers</source>
        <translation>L’aire que les deux couvrent, rapportée à l’aire que l’un ou l’autre couvre</translation>
    </message>
    <message>
        <source>How often the images of the maps cover the same places: their areas together, divided by the area that they cover. It is 1 where no two of them overlap</source>
        <translation>Combien de fois les images des applications couvrent les mêmes endroits&#x202f;: la somme de leurs aires, divisée par l’aire qu’elles couvrent. Il vaut 1 si elles ne se recouvrent pas deux à deux</translation>
    </message>
    <message>
        <source>95 % of all points are within this distance of the other shape</source>
        <translation>95 % des points sont au plus à cette distance de l’autre forme</translation>
    </message>
    <message>
        <source>From each point to the nearest point of the other shape, in pixels of the picture as it is traced</source>
        <translation>De chaque point au point le plus proche de l’autre forme, en pixels de l’image telle qu’elle est tracée</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Mean distance of the collage: %1 → %2.</source>
        <translation>Distance moyenne du collage&#x202f;: %1 → %2.</translation>
    </message>
    <message>
        <source>Mean distance of the attractor: %1 → %2.</source>
        <translation>Distance moyenne de l’attracteur&#x202f;: %1 → %2.</translation>
    </message>
    <message>
        <source>Guarantee: %1 → %2.</source>
        <translation>Garantie&#x202f;: %1 → %2.</translation>
    </message>
    <message>
        <source>The distance has increased, but the overlap (IoU) has improved.</source>
        <translation>La distance a augmenté, mais le recouvrement (IoU) s’est amélioré.</translation>
    </message>
    <message>
        <source>Nothing is guaranteed any more.</source>
        <translation>Plus rien n’est garanti.</translation>
    </message>
    <message>
        <source>The guarantee is now weaker.</source>
        <translation>La garantie est maintenant plus faible.</translation>
    </message>
    <message>
        <source>Overlap of the maps</source>
        <translation>Recouvrement des applications</translation>
    </message>
    <message>
        <source>Guaranteed within</source>
        <translation>Garanti à moins de</translation>
    </message>
</context>
<context>
    <name>view::CollagePanel</name>
    <message>
        <source>Use Suggestion</source>
        <translation>Utiliser la suggestion</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Affiner les applications</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Affiner l’attracteur</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Ajuster les poids</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Ajuster la cage</translation>
    </message>
    <message>
        <source>Add Map</source>
        <translation>Ajouter une application</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Collage</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Accord</translation>
    </message>
    <message>
        <source>of the collage</source>
        <translation>du collage</translation>
    </message>
    <message>
        <source>of the attractor</source>
        <translation>de l’attracteur</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>masqué</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustement</translation>
    </message>
    <message>
        <source>The maps do not contract, so there is no attractor to compare.</source>
        <translation>Les applications ne sont pas contractantes&#x202f;; il n’y a pas d’attracteur à comparer.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Il n’y a pas assez de mémoire pour cela.</translation>
    </message>
    <message numerus="yes">
        <source>%n suggestions. Click one to use it.</source>
        <translation>
            <numerusform>%n suggestion. Cliquez dessus pour l’utiliser.</numerusform>
            <numerusform>%n suggestions. Cliquez sur l’une d’elles pour l’utiliser.</numerusform>
        </translation>
    </message>
    <message>
        <source>The fractal has changed meanwhile, so the result was not used.</source>
        <translation>La fractale a changé entre-temps&#x202f;; le résultat n’a pas été utilisé.</translation>
    </message>
    <message>
        <source>No better agreement was found.</source>
        <translation>Rien de plus concordant n’a été trouvé.</translation>
    </message>
    <message>
        <source>Guarantee for the shades</source>
        <translation>Garantie pour les nuances</translation>
    </message>
    <message>
        <source>Moved by at most this distance on average, the shades of the attractor become those of the picture</source>
        <translation>Déplacées en moyenne d’au plus cette distance, les nuances de l’attracteur deviennent celles de l’image</translation>
    </message>
    <message>
        <source>On average, the shades of the attractor are guaranteed to lie within %1 px of those of the picture.</source>
        <translation>En moyenne, les nuances de l’attracteur se trouvent, c’est garanti, à %1 px au plus de celles de l’image.</translation>
    </message>
    <message>
        <source>With these weights, the maps do not contract on average, so nothing is guaranteed for the shades.</source>
        <translation>Avec ces poids, les applications ne sont pas contractantes en moyenne&#x202f;; rien n’est donc garanti pour les nuances.</translation>
    </message>
    <message>
        <source>Choose what the canvas compares with the target</source>
        <translation>Choisir ce que le canevas compare à la cible</translation>
    </message>
    <message>
        <source>Compares the target with its images under the maps, or with the attractor. Agreement is grey, excess red, and missing parts blue.</source>
        <translation>Compare la cible à ses images par les applications, ou à l’attracteur. Le commun en gris, l’excédent en rouge, le manque en bleu.</translation>
    </message>
    <message>
        <source>Result of refining</source>
        <translation>Résultat de l’affinage</translation>
    </message>
    <message>
        <source>What the last refinement has made of the distance and of the guarantee</source>
        <translation>Ce que le dernier affinage a fait de la distance et de la garantie</translation>
    </message>
    <message>
        <source>1. Choose a picture</source>
        <translation>1. Choisissez une image</translation>
    </message>
    <message>
        <source>2. Ask for suggestions</source>
        <translation>2. Demandez des propositions</translation>
    </message>
    <message>
        <source>3. Pick one</source>
        <translation>3. Choisissez-en une</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>More ways to trace</source>
        <translation>Autres façons de décalquer</translation>
    </message>
    <message>
        <source>Show how the picture is read, the agreement, and what refines a suggestion</source>
        <translation>Montre comment l’image est lue, la concordance et ce qui affine une proposition</translation>
    </message>
    <message>
        <source>Another picture is shown, so the search for the last one was cancelled.</source>
        <translation>Une autre image est affichée, la recherche pour la précédente a donc été annulée.</translation>
    </message>
</context>
<context>
    <name>view::CollectionGrid</name>
    <message>
        <source>Fractals of the collection</source>
        <translation>Fractales de la collection</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Aucun résultat</translation>
    </message>
    <message>
        <source>No favourites yet. Select a fractal and press Ctrl+D.</source>
        <translation>Pas encore de favoris. Choisissez une fractale et appuyez sur Ctrl+D.</translation>
    </message>
    <message>
        <source>Fractals that you use appear here.</source>
        <translation>Les fractales que vous utilisez apparaissent ici.</translation>
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
    <message>
        <source>solid 3D space</source>
        <comment>words of a search</comment>
        <translation>solide 3D espace</translation>
    </message>
    <message>
        <source>moving animation motion</source>
        <comment>words of a search</comment>
        <translation>mouvement animation animé</translation>
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
        <source>Open the selected fractal as a separate document.</source>
        <translation>Ouvrir la fractale choisie dans un document à part.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>&amp;Ajouter à ce fichier</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Ajouter la fractale choisie au fichier ouvert.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>&amp;Favori</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites.</source>
        <translation>Mettre la fractale choisie dans vos favoris.</translation>
    </message>
    <message>
        <source>Fa&amp;vourites Only</source>
        <translation>Fa&amp;voris seulement</translation>
    </message>
    <message>
        <source>Show only your favourites.</source>
        <translation>N’afficher que vos favoris.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>Ajouter un &amp;dossier…</translation>
    </message>
    <message>
        <source>Add the .ifs files of one of your own folders to this list.</source>
        <translation>Afficher ici aussi les fichiers .ifs d’un dossier à vous.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>&amp;Retirer le dossier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Remove this folder from the list. Its files are not changed.</source>
        <translation>Retirer ce dossier de la liste. Ses fichiers ne sont pas modifiés.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Dossier de fichiers .ifs</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>N’affiche que les fractales dont le nom, le thème ou le commentaire contient ces mots. Entrée ouvre la première.</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it in this window; right-click it to add it to the file instead.</source>
        <translation>Des fractales pour commencer. Un double-clic ou Entrée en ouvre une dans cette fenêtre&#x202f;; le menu du bouton droit permet plutôt de l’ajouter au fichier.</translation>
    </message>
    <message>
        <source>Progress of reading the collection</source>
        <translation>Fichiers de la collection déjà lus</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Arrêter la lecture</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Lecture de la collection…</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Utiliser</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Ajouter la fractale sélectionnée au fichier ouvert, ou l’ouvrir si rien n’a encore été modifié.</translation>
    </message>
    <message>
        <source>&amp;Open as New Document</source>
        <translation>&amp;Ouvrir comme nouveau document</translation>
    </message>
    <message>
        <source>Stop reading this folder; files that were already read stay in the list</source>
        <translation>Arrêter la lecture de ce dossier&#x202f;; ce qui a été lu reste dans la liste</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>Show the collection over the whole window, in large pictures.</source>
        <translation>Afficher la collection sur toute la fenêtre, en grandes images.</translation>
    </message>
    <message>
        <source>&amp;Recent Only</source>
        <translation>&amp;Récentes seulement</translation>
    </message>
    <message>
        <source>Show only the fractals that you used last.</source>
        <translation>N’afficher que les fractales utilisées en dernier.</translation>
    </message>
</context>
<context>
    <name>view::CollectionWindow</name>
    <message>
        <source>Collection</source>
        <translation>Collection</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it. Those with a triangle in the corner move under the pointer.</source>
        <translation>Des fractales toutes prêtes. Un double-clic ou Entrée en ouvre une. Celles qui portent un triangle dans le coin bougent sous le pointeur.</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Rechercher dans la collection</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>N’affiche que les fractales dont le nom, le thème ou le commentaire contient ces mots. Entrée ouvre la première.</translation>
    </message>
    <message>
        <source>Themes</source>
        <translation>Thèmes</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favori</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites (Ctrl+D)</source>
        <translation>Ajouter la fractale sélectionnée aux favorites (Ctrl+D)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Ajouter la fractale sélectionnée au fichier ouvert, ou l’ouvrir si rien n’a encore été modifié.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>&amp;Ajouter à ce fichier</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Ajouter la fractale choisie au fichier ouvert.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favorites</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récentes</translation>
    </message>
    <message>
        <source>Double-click a fractal to open it.</source>
        <translation>Double-cliquez sur une fractale pour l’ouvrir.</translation>
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
        <source>a b e c d f p: one equation after the other</source>
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
        <source>a b c d e f, and cumulative weights</source>
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
        <source>Column names in order</source>
        <translation>Noms des colonnes dans leur ordre</translation>
    </message>
    <message>
        <source>The names of the columns in order: a b c d or r s theta phi, then e and f, each once; if there are weights, also p, or cumulative for running sums of weights. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Les noms des colonnes dans leur ordre&#x202f;: a b c d ou r s theta phi, puis e et f, chacun une fois, et p pour un poids ou cumulative pour une somme de poids s’il y en a. x′ = a·x + b·y + e et y′ = c·x + d·y + f.</translation>
    </message>
    <message>
        <source>The names of the columns in their order, such as a b c d e f p</source>
        <translation>Les noms des colonnes dans leur ordre, par exemple a b c d e f p</translation>
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
        <source>Type some letters of what you want to do. The arrow keys select a command, Enter runs it.</source>
        <translation>Tapez quelques lettres de ce que vous voulez faire. Les touches fléchées choisissent, Entrée exécute.</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Aucune commande correspondante</translation>
    </message>
    <message>
        <source>Commands whose names contain these words come first, then those whose descriptions do.</source>
        <translation>Les commandes dont le nom contient ces mots, puis celles dont la description les contient.</translation>
    </message>
    <message>
        <source>Search the guide for “%1”</source>
        <translation>Chercher «&#x202f;%1&#x202f;» dans le guide</translation>
    </message>
</context>
<context>
    <name>view::CommandSynonyms</name>
    <message>
        <source>render save image picture png svg pdf jpeg tiff webp exr poster wallpaper stl obj ply glb mesh print 3d laser plotter cutter engrave dxf outline vector transparent millimetres</source>
        <translation>rendu rendre enregistrer image png svg pdf jpeg tiff poster affiche fond stl obj ply maillage impression 3d laser traceur découpe graver dxf contour vectoriel transparent millimètres</translation>
    </message>
    <message>
        <source>render video movie film mp4 webm gif apng frames cluster slurm</source>
        <translation>rendu rendre vidéo film mp4 webm gif apng images grappe slurm</translation>
    </message>
    <message>
        <source>flame apophysis csv table points cloud ply ifstile save</source>
        <translation>flame apophysis csv tableau points nuage ply ifstile enregistrer</translation>
    </message>
    <message>
        <source>clipboard screenshot image</source>
        <translation>presse-papiers capture image</translation>
    </message>
    <message>
        <source>paper printer pdf page</source>
        <translation>papier imprimante pdf page</translation>
    </message>
    <message>
        <source>surprise chance lucky generate dice new</source>
        <translation>surprise hasard chance générer dé nouveau</translation>
    </message>
    <message>
        <source>mirror reflect reverse</source>
        <translation>miroir refléter retourner</translation>
    </message>
    <message>
        <source>mirror reflect upside down</source>
        <translation>miroir refléter retourner à l’envers</translation>
    </message>
    <message>
        <source>hull triangle tight smallest</source>
        <translation>enveloppe triangle serré plus petit</translation>
    </message>
    <message>
        <source>apply freeze write flatten</source>
        <translation>appliquer figer écrire</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>copier cloner</translation>
    </message>
    <message>
        <source>centre home whole zoom all</source>
        <translation>centrer accueil tout</translation>
    </message>
    <message>
        <source>maximise whole</source>
        <translation>maximiser plein</translation>
    </message>
    <message>
        <source>3d extrude solid</source>
        <translation>3d extruder solide</translation>
    </message>
    <message>
        <source>settings options language theme dark light configuration motion</source>
        <translation>réglages options langue thème sombre clair configuration mouvement</translation>
    </message>
    <message>
        <source>shortcuts keys hotkeys gestures</source>
        <translation>raccourcis touches gestes</translation>
    </message>
    <message>
        <source>help manual documentation</source>
        <translation>aide manuel documentation</translation>
    </message>
    <message>
        <source>tutorial introduction beginner learn</source>
        <translation>tutoriel introduction débutant apprendre</translation>
    </message>
    <message>
        <source>sway wind storm blow</source>
        <translation>balancer brise tempête souffler</translation>
    </message>
    <message>
        <source>turntable spin rotate camera</source>
        <translation>plateau tournant tourner caméra</translation>
    </message>
    <message>
        <source>spin rotate</source>
        <translation>tourner pivoter</translation>
    </message>
    <message>
        <source>pulse grow shrink</source>
        <translation>pulser grandir rétrécir</translation>
    </message>
    <message>
        <source>colours rainbow</source>
        <translation>couleurs arc-en-ciel</translation>
    </message>
    <message>
        <source>infinite dive</source>
        <translation>infini plongée</translation>
    </message>
    <message>
        <source>mutate mutation vary breed evolve grow similar</source>
        <translation>muter mutation varier élever évoluer semblable</translation>
    </message>
    <message>
        <source>shade silhouette drop cast ground light sun</source>
        <translation>silhouette sol lumière soleil projeter</translation>
    </message>
    <message>
        <source>share send email mail post message url</source>
        <translation>partager envoyer courriel e-mail mail message url</translation>
    </message>
    <message>
        <source>dimension proof certificate | prove certified Hausdorff area measure overlap connected</source>
        <translation>dimension preuve certificat | prouver démontrer Hausdorff aire mesure recouvrement connexe</translation>
    </message>
    <message>
        <source>reorder rearrange order sort</source>
        <translation>réordonner réorganiser ordre trier</translation>
    </message>
    <message>
        <source>gallery examples library favourites leaf tree fern snowflake dragon sponge</source>
        <translation>galerie exemples bibliothèque favoris feuille arbre fougère flocon dragon éponge</translation>
    </message>
    <message>
        <source>linked maps graph-directed which follows which forbidden</source>
        <translation>applications liées graphe orienté interdit</translation>
    </message>
    <message>
        <source>colours palette gradient hue background transparent brightness contrast black white grey</source>
        <translation>couleurs palette dégradé teinte fond transparent luminosité contraste noir blanc gris</translation>
    </message>
    <message>
        <source>flip mirror reflect | rotate scale shear move shift turn size resize bigger larger smaller</source>
        <translation>retourner miroir refléter symétrie | tourner pivoter agrandir cisailler déplacer taille plus grand petit réduire</translation>
    </message>
    <message>
        <source>timeline motion movie keyframes speed faster slower morph</source>
        <translation>ligne de temps mouvement film images clés vitesse rapide lent morphing transformer</translation>
    </message>
    <message>
        <source>share send browser html embed publish interactive mail email</source>
        <translation>partager envoyer navigateur html intégrer publier interactif courriel e-mail</translation>
    </message>
    <message>
        <source>worksheet class students exercise paper teacher</source>
        <translation>fiche classe élèves exercice papier professeur</translation>
    </message>
    <message>
        <source>undo original restore straighten start over again</source>
        <translation>origine restaurer redresser recommencer</translation>
    </message>
</context>
<context>
    <name>view::ComparePane</name>
    <message>
        <source>Entry to compare with</source>
        <translation>Entrée à comparer</translation>
    </message>
    <message>
        <source>Canvas of the entry to compare with</source>
        <translation>Canevas de l’entrée à comparer</translation>
    </message>
    <message>
        <source>There is no other entry in this file. Add or duplicate one to compare it.</source>
        <translation>Ce fichier n’a pas d’autre entrée. Ajoutez-en ou dupliquez-en une pour la comparer.</translation>
    </message>
    <message>
        <source>The entry that is shown beside the current one</source>
        <translation>L’entrée affichée à côté de l’entrée actuelle</translation>
    </message>
    <message>
        <source>Link Views</source>
        <translation>Lier les vues</translation>
    </message>
    <message>
        <source>Pan and zoom both together, at the same position and scale</source>
        <translation>Déplacer et zoomer les deux ensemble, au même endroit et à la même échelle</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Show the current entry alone</source>
        <translation>Afficher seulement l’entrée actuelle</translation>
    </message>
    <message>
        <source>An entry in the plane and one in space cannot share a view</source>
        <translation>Une entrée du plan et une de l’espace n’ont pas de vue commune</translation>
    </message>
    <message>
        <source>Another entry of the file beside the current one, to compare the two.</source>
        <translation>Une autre entrée du fichier à côté de l’entrée en cours, pour les comparer.</translation>
    </message>
</context>
<context>
    <name>view::ConstructionBar</name>
    <message>
        <source>How the attractor is built</source>
        <translation>Comment l’attracteur se construit</translation>
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
        <source>Chaos Game</source>
        <translation>Jeu du chaos</translation>
    </message>
    <message>
        <source>One point that jumps by maps chosen at random; the first 14 points are not plotted</source>
        <translation>Un point qui saute par des applications tirées au hasard&#x202f;; les 14 premiers points ne sont pas tracés</translation>
    </message>
    <message>
        <source>n: how many times all maps are applied</source>
        <translation>n&#x202f;: combien de fois toutes les applications sont appliquées</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Clear the points and start with new random numbers</source>
        <translation>Repartir sans aucun point, avec d’autres tirages</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Plot points continuously</source>
        <translation>Faire apparaître des points</translation>
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
        <source>Stop at these points</source>
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
        <source>no points yet: press Play (▶)</source>
        <translation>pas encore de points&#x202f;: appuyez sur Lancer (▶)</translation>
    </message>
    <message>
        <source>How many times all maps are applied: 0 is the starting shape, and with every step the picture gets closer to the attractor. Each image has the colour of its outermost map.</source>
        <translation>Combien de fois toutes les applications sont appliquées&#x202f;: 0 donne la figure de départ, et à chaque étape l’image se rapproche de l’attracteur. Chaque copie a la couleur de son application la plus externe.</translation>
    </message>
    <message>
        <source>One Jump</source>
        <translation>Un saut</translation>
    </message>
    <message>
        <source>Roll the die once and jump</source>
        <translation>Lancer le dé une fois et sauter</translation>
    </message>
    <message>
        <source>Jumps per second</source>
        <translation>Sauts par seconde</translation>
    </message>
    <message>
        <source>How many jumps the chaos game makes per second. At up to ten per second, the die shows each map that is rolled.</source>
        <translation>Combien de sauts le jeu du chaos fait par seconde. Jusqu’à dix par seconde, le dé montre chaque application qui sort.</translation>
    </message>
    <message>
        <source>W%1: the start</source>
        <translation>W%1&#x202f;: la figure de départ</translation>
    </message>
    <message>
        <source>W%1: %2 copies</source>
        <translation>W%1&#x202f;: %2 copies</translation>
    </message>
    <message>
        <source>The Hausdorff distance from the picture to the attractor A, and its upper bound</source>
        <translation>La distance de Hausdorff de l’image à l’attracteur A, et ce qu’elle ne peut dépasser</translation>
    </message>
    <message>
        <source>The Hausdorff distance from Wⁿ(B) to the attractor A, measured on cells of side %1. It is at most sⁿ times the distance from the start B to A, where s = %2 is the largest contraction factor of the maps.</source>
        <translation>La distance de Hausdorff de Wⁿ(B) à l’attracteur A, mesurée sur des cellules de côté %1. Elle vaut au plus sⁿ fois la distance de la figure de départ B à A, où s = %2 est le plus grand facteur de contraction des applications.</translation>
    </message>
    <message>
        <source>no bound: a map has the contraction factor %1</source>
        <translation>pas de borne&#x202f;: une application a le facteur de contraction %1</translation>
    </message>
    <message>
        <source>distance to A at most %1</source>
        <translation>distance à A&#x202f;: au plus %1</translation>
    </message>
    <message>
        <source>distance to A &lt; %1, at most %2</source>
        <translation>distance à A &lt; %1, au plus %2</translation>
    </message>
    <message>
        <source>distance to A ≈ %1, at most %2</source>
        <translation>distance à A ≈ %1, au plus %2</translation>
    </message>
    <message>
        <source>jump %1 of the %2 that are not plotted</source>
        <translation>saut %1 des %2 qui ne sont pas tracés</translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>jumps per second</comment>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Step by Step</source>
        <translation>Pas à pas</translation>
    </message>
    <message>
        <source>All maps at once, applied n times to the cage or another shape (Wⁿ)</source>
        <translation>Toutes les applications à la fois, n fois sur la cage ou une autre figure (Wⁿ)</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three corners. The picture stays where it is; Esc cancels.</source>
        <translation>Cliquez sur le premier des trois sommets. L’image reste où elle est&#x202f;; Échap annule.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Cliquez sur le deuxième sommet. Retour arrière supprime le dernier point.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Cliquez sur le troisième sommet. Retour arrière supprime le dernier point.</translation>
    </message>
</context>
<context>
    <name>view::Die</name>
    <message>
        <source>Die</source>
        <translation>Dé</translation>
    </message>
    <message>
        <source>The die of the chaos game. It has a face for each map, as wide as the probability of the map. The face that was rolled is shown in the colour of its map, and so is the point that the map leads to. At more than ten jumps per second, the die rolls too fast to be read.</source>
        <translation>Le dé du jeu du chaos. Il a une face par application, aussi large que la probabilité de celle-ci. La face sortie apparaît dans la couleur de son application, comme le point auquel celle-ci a mené. Au-delà de dix sauts par seconde, il roule trop vite pour être lu.</translation>
    </message>
    <message>
        <source>Each map has a face, as wide as its probability.</source>
        <translation>Chaque application a une face, aussi large que sa probabilité.</translation>
    </message>
    <message>
        <source>Map %1 was rolled; its probability is %2.</source>
        <translation>L’application %1 est sortie&#x202f;; sa probabilité est %2.</translation>
    </message>
</context>
<context>
    <name>view::EaseDialog</name>
    <message>
        <source>Custom Ease</source>
        <translation>Transition personnalisée</translation>
    </message>
    <message>
        <source>Curve: time to the right, progress upwards</source>
        <translation>Courbe&#x202f;: le temps vers la droite, le chemin vers le haut</translation>
    </message>
    <message>
        <source>How the motion to the next key progresses over time. Drag the two handles.</source>
        <translation>Comment le chemin jusqu’à la clé suivante est parcouru dans le temps. Tirez les deux poignées.</translation>
    </message>
    <message>
        <source>Time of the first handle</source>
        <translation>Temps de la première poignée</translation>
    </message>
    <message>
        <source>Progress of the first handle</source>
        <translation>Chemin de la première poignée</translation>
    </message>
    <message>
        <source>Time of the second handle</source>
        <translation>Temps de la seconde poignée</translation>
    </message>
    <message>
        <source>Progress of the second handle</source>
        <translation>Chemin de la seconde poignée</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>First handle:</source>
        <translation>Première poignée&#x202f;:</translation>
    </message>
    <message>
        <source>Second handle:</source>
        <translation>Seconde poignée&#x202f;:</translation>
    </message>
    <message>
        <source>A number from 0 to 1. A curve that would be too steep is flattened.</source>
        <translation>Une fraction de 0 à 1. Une courbe trop raide est aplatie.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Commentaire de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
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
        <source>Written on separate lines below the name, each after a semicolon.</source>
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
        <source>&amp;Title:</source>
        <translation>&amp;Titre&#x202f;:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Lignes de commentaire&#x202f;:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines store the cage and the colours.</source>
        <translation>Un commentaire ne peut pas commencer par «&#x202f;barycage:&#x202f;»&#x202f;; ces lignes conservent la cage et les couleurs.</translation>
    </message>
    <message>
        <source>A line can have at most %1 bytes; Fractint truncates longer ones. Split it in two.</source>
        <translation>Une ligne compte au plus %1 octets&#x202f;; Fractint coupe les plus longues. Coupez-la en deux.</translation>
    </message>
    <message>
        <source>Comments are stored with the entry in the file and do not change the fractal.</source>
        <translation>Les commentaires sont enregistrés avec l’entrée dans le fichier et ne changent pas la fractale.</translation>
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
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Renommer «&#x202f;%1&#x202f;» en «&#x202f;%2&#x202f;»</translation>
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
    <message>
        <source>%1 in space</source>
        <translation>%1 dans l’espace</translation>
    </message>
    <message>
        <source>%1, placed</source>
        <translation>%1, placé</translation>
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
        <source>This file contains no entries. Add one, or paste the text of an .ifs file.</source>
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
        <source>Paste entries from .ifs text after the current entry.</source>
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
        <source>An entry that could not be read cannot be duplicated: the copy would have the same name.</source>
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
        <source>The pasted text contains no entry of an .ifs file.</source>
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
        <source>%n pasted entries could not be read; their text is kept unchanged.</source>
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
        <source>No entry name contains “%1”.</source>
        <translation>Aucune entrée n’a «&#x202f;%1&#x202f;» dans son nom.</translation>
    </message>
    <message>
        <source>Shows only the entries whose names contain these letters.</source>
        <translation>N’affiche que les entrées dont le nom contient ces lettres.</translation>
    </message>
    <message>
        <source>The fractals in the file. Click one to edit it, drag it to move it, press F2 to rename it.</source>
        <translation>Les fractales du fichier. Cliquez sur l’une d’elles pour la modifier, faites-la glisser pour la changer de place, appuyez sur F2 pour la renommer.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>Rien n’a été collé&#x202f;: il n’y a pas de texte dans le presse-papiers.</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Lecture de ce qui a été collé…</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Ajout des entrées…</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Coupe&amp;r</translation>
    </message>
    <message>
        <source>Move the selected entries to the clipboard.</source>
        <translation>Déplace les entrées sélectionnées dans le presse-papiers.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Couper %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n entries</source>
        <translation>
            <numerusform>Couper %n entrée</numerusform>
            <numerusform>Couper %n entrées</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Exporter les données de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Ce que contiendra le fichier</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>Copier le &amp;texte</translation>
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
        <source>Flip &amp;y so that the flame is the right way up</source>
        <translation>&amp;Retourner y, pour que la flamme soit dans le même sens</translation>
    </message>
    <message>
        <source>&amp;Bake the placement so that the maps draw the picture as shown</source>
        <translation>&amp;Intégrer le placement, pour que les applications dessinent ce qui est montré</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format&#x202f;:</translation>
    </message>
    <message>
        <source>C&amp;olumns:</source>
        <translation>&amp;Colonnes&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>&amp;Points&#x202f;:</translation>
    </message>
    <message>
        <source>The points of the chaos game as shown, without the first 14.</source>
        <translation>Les points du jeu du chaos là où ils sont affichés, sans les 14 premiers.</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Exporter les données</translation>
    </message>
    <message>
        <source>The text was copied to the clipboard.</source>
        <translation>Le texte est dans le presse-papiers.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>Le début du fichier tel qu’il sera écrit.</translation>
    </message>
    <message>
        <source>The program that will read the data; each format contains what that program understands.</source>
        <translation>Le programme auquel les données sont destinées&#x202f;: chaque format contient ce que ce programme lit.</translation>
    </message>
    <message>
        <source>The order of the coefficients in each row; programs differ.</source>
        <translation>L’ordre des coefficients dans chaque ligne&#x202f;; d’autres programmes attendent d’autres ordres.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Combien de points du jeu du chaos sont écrits.</translation>
    </message>
    <message>
        <source>In flame programs, y points down. With this option, the flame looks as it does here; without it, the numbers stay the same.</source>
        <translation>Les programmes de flammes font croître y vers le bas. Avec cette option, la flamme a la même allure que la fractale ici&#x202f;; sans elle, les nombres sont les mêmes.</translation>
    </message>
    <message>
        <source>With this option, the cage becomes part of the maps. Without it, the maps are written as they are in the table.</source>
        <translation>Avec cette option, la cage est intégrée aux applications. Sans elle, les applications sont écrites telles qu’elles figurent dans le tableau.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Demande le nom du fichier et l’écrit.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Copie le texte entier dans le presse-papiers au lieu d’écrire un fichier.</translation>
    </message>
    <message>
        <source>This format can store only systems in the plane.</source>
        <translation>Ce format ne peut enregistrer que des systèmes du plan.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exporter «&#x202f;%1&#x202f;»</translation>
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
        <source>Include the ca&amp;ge</source>
        <translation>&amp;Inclure la cage</translation>
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
        <source>Quality</source>
        <translation>Qualité</translation>
    </message>
    <message>
        <source>Cells along each side of a pixel</source>
        <translation>Cellules le long du côté d’un pixel</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 bits par canal</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
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
        <source>S&amp;upersampling:</source>
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
        <source>&amp;Automatic depth</source>
        <translation>Profondeur &amp;automatique</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Niveaux de copies</translation>
    </message>
    <message>
        <source>Description of the picture</source>
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
        <source>Only systems in the plane can be exported as a picture.</source>
        <translation>Seuls les systèmes du plan peuvent être exportés comme image.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>One dot for every visible point of the chaos game.</source>
        <translation>Un point dessiné pour chaque point visible du jeu du chaos.</translation>
    </message>
    <message>
        <source>Guaranteed accuracy: %1.</source>
        <translation>Précision garantie : %1.</translation>
    </message>
    <message>
        <source>The shape itself measures %1 × %2.</source>
        <translation>La forme elle-même mesure %1 × %2.</translation>
    </message>
    <message>
        <source>Shades of density need pixels: the shapes have one colour.</source>
        <translation>Les nuances de densité demandent des pixels : les formes ont une seule couleur.</translation>
    </message>
    <message>
        <source>The cage bends the picture, which copies cannot reproduce: the affine fit of the cage is written instead. A PNG shows the bend.</source>
        <translation>La cage courbe l’image, ce que des copies ne peuvent pas suivre&#x202f;: c’est l’ajustement affine de la cage qui est écrit. Un PNG montre l’image courbée.</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source>The picture has no background and can be placed over another.</source>
        <translation>L’image n’a pas de fond et peut être superposée à une autre.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Dessine la cage par-dessus l’image.</translation>
    </message>
    <message>
        <source>The number of points drawn for each pixel: more points make a smoother picture and take longer.</source>
        <translation>Combien de points sont dessinés par pixel&#x202f;: davantage de points donnent une image plus lisse et prennent plus de temps.</translation>
    </message>
    <message>
        <source>The number of smaller cells along each side of a pixel: more cells make smoother edges, at the cost of memory and time.</source>
        <translation>Chaque pixel est dessiné à partir d’autant de pixels plus fins le long de son côté&#x202f;: des bords plus lisses, pour plus de mémoire et de temps.</translation>
    </message>
    <message>
        <source>16 bits keep fine gradations for later editing; 8 bits are enough for viewing.</source>
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
        <source>The number of levels of copies. More levels hardly enlarge the file, but the picture takes longer to draw.</source>
        <translation>Combien de niveaux de copies a l’image. Le fichier n’en grossit guère, mais la durée du dessin, elle, augmente.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file. You can keep working in the meantime.</source>
        <translation>Demande le nom du fichier et l’écrit. La fenêtre reste utilisable pendant ce temps.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Copie de l’image…</translation>
    </message>
    <message>
        <source>Makes the copies smaller until they cannot be distinguished from the attractor at this pixel size, or until programs would take long to draw them.</source>
        <translation>Les copies sont réduites jusqu’à ce qu’aucun pixel de cette taille ne puisse montrer la différence, ou que les logiciels mettent longtemps à les dessiner.</translation>
    </message>
    <message>
        <source>More levels would be more accurate, but programs would take long to draw them.</source>
        <translation>Plus de niveaux seraient plus précis, mais les programmes mettraient longtemps à les dessiner.</translation>
    </message>
    <message>
        <source>Computing the shapes…</source>
        <translation>Calcul des formes…</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vue du canevas</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>L’attracteur entier</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Cadrage</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>&amp;Cadrage&#x202f;:</translation>
    </message>
    <message>
        <source>SVG and PDF are made of shapes, which stay sharp at every size; the others are made of pixels. If the file name has the ending of another format, that format is written.</source>
        <translation>SVG et PDF sont faits de formes, qui restent nettes à toutes les tailles&#x202f;; les autres sont faits de pixels. Si le nom du fichier a l’extension d’un autre format, c’est ce format qui est écrit.</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format: it must end with .png, .jpg, .webp, .tiff, .exr, .svg or .pdf.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» n’indique pas le format&#x202f;: il doit se terminer par .png, .jpg, .webp, .tiff, .exr, .svg ou .pdf.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the picture to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Demande un nom de fichier et dessine l’image à son tour, après celles qui attendent dans le panneau Exports. La file d’attente reprend après un redémarrage.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>La vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Ce que montre l’image&#x202f;: ce que montre le canevas, ou l’attracteur avec une petite marge, où que regarde le canevas. Les vues enregistrées sont aussi dans la liste.</translation>
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
        <translation>Précision garantie&#x202f;: %2. Copies dessinées par les programmes qui ouvrent le fichier&#x202f;: %1 (la limite est %3).</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Brouillon&#x202f;: 25 points par pixel</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Bonne&#x202f;: 100 points par pixel</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Fine&#x202f;: 400 points par pixel</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Très fine&#x202f;: 2000 points par pixel</translation>
    </message>
</context>
<context>
    <name>view::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>What the file will show</source>
        <translation>Ce que montrera le fichier</translation>
    </message>
    <message>
        <source>The picture as it will be exported: its proportions and the section it shows. A chequerboard marks transparent parts. The preview follows every field.</source>
        <translation>L’image telle qu’elle sera exportée&#x202f;: sa forme et la section qu’elle montre. Là où elle est transparente, un damier apparaît. Elle suit tous les champs.</translation>
    </message>
    <message>
        <source>Drawing the preview…</source>
        <translation>Dessin de l’aperçu…</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Aucun aperçu</translation>
    </message>
</context>
<context>
    <name>view::ExportProgress</name>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>Encore %n seconde environ.</numerusform>
            <numerusform>Encore %n secondes environ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n minute(s) left.</source>
        <translation>
            <numerusform>Encore %n minute environ.</numerusform>
            <numerusform>Encore %n minutes environ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n hour(s) left.</source>
        <translation>
            <numerusform>Encore %n heure environ.</numerusform>
            <numerusform>Encore %n heures environ.</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progression de l’exportation</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Temps restant</translation>
    </message>
</context>
<context>
    <name>view::ExportQueue</name>
    <message>
        <source>Barycage ended unexpectedly twice while drawing this picture. Try it again alone, or export a smaller one.</source>
        <translation>Le programme s’est arrêté deux fois pendant qu’il dessinait cette image. Réessayez avec elle seule, ou exportez-en une plus petite.</translation>
    </message>
    <message>
        <source>The export queue cannot be saved for the next session: its folder is not writable, or the disk is full.</source>
        <translation>La file d’attente des exports ne peut pas être conservée pour le prochain démarrage&#x202f;: son dossier n’est pas accessible en écriture, ou le disque est plein.</translation>
    </message>
</context>
<context>
    <name>view::ExportShell</name>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>Add to Queue…</source>
        <translation>Ajouter à la file d’attente…</translation>
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
        <source>Export stopped; nothing was written.</source>
        <translation>L’exportation a été arrêtée&#x202f;; rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Montre le dossier du fichier écrit dans le gestionnaire de fichiers.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Fichiers %1 (*.%2)</translation>
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
        <source>Same as on the screen</source>
        <translation>Comme à l’écran</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × l’écran</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisée</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Garder les proportions</translation>
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
        <source>A length in the selected unit. The other side follows as long as the proportions are locked.</source>
        <translation>Une longueur dans l’unité choisie à côté. L’autre côté suit tant que les proportions sont gardées.</translation>
    </message>
    <message>
        <source>Pixels, or a length on paper at the given resolution.</source>
        <translation>En pixels, ou sur papier à la résolution indiquée.</translation>
    </message>
    <message>
        <source>The number of pixels per inch of paper: 300 is usual for print.</source>
        <translation>Combien de pixels tiennent sur un pouce de papier&#x202f;: 300 est l’usage en imprimerie.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Taille nommée</translation>
    </message>
    <message>
        <source>The size of the picture on the screen or a multiple of it, of a common screen, or of a sheet of paper. Everything that the window shows stays in the picture; if the proportions differ, the picture shows more around it.</source>
        <translation>La taille de l’image à l’écran ou un multiple de celle-ci, celle d’un écran courant ou d’une feuille de papier. Tout ce que montre la fenêtre reste dans l’image&#x202f;; si la forme diffère, on en voit davantage autour.</translation>
    </message>
    <message>
        <source>Keep the proportions of the picture</source>
        <translation>Garder les proportions de l’image</translation>
    </message>
    <message>
        <source>Full HD: 1920 × 1080</source>
        <translation>Full HD&#x202f;: 1920 × 1080</translation>
    </message>
    <message>
        <source>4K: 3840 × 2160</source>
        <translation>4K&#x202f;: 3840 × 2160</translation>
    </message>
    <message>
        <source>8K: 7680 × 4320</source>
        <translation>8K&#x202f;: 7680 × 4320</translation>
    </message>
    <message>
        <source>Square: 2048 × 2048</source>
        <translation>Carré&#x202f;: 2048 × 2048</translation>
    </message>
    <message>
        <source>A4 at 300 dpi</source>
        <translation>A4 à 300 ppp</translation>
    </message>
    <message>
        <source>A3 at 300 dpi</source>
        <translation>A3 à 300 ppp</translation>
    </message>
    <message>
        <source>The size of the picture, in pixels or on paper.</source>
        <translation>La taille de l’image, en pixels ou sur le papier.</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Portrait ou paysage</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Échanger largeur et hauteur</translation>
    </message>
</context>
<context>
    <name>view::ExportsModel</name>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>environ %n seconde restante</numerusform>
            <numerusform>environ %n secondes restantes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n minute(s) left</source>
        <translation>
            <numerusform>environ %n minute restante</numerusform>
            <numerusform>environ %n minutes restantes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n hour(s) left</source>
        <translation>
            <numerusform>environ %n heure restante</numerusform>
            <numerusform>environ %n heures restantes</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En attente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Paused at %1 %</source>
        <translation>En pause à %1 %</translation>
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
        <translation>%1&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>view::ExportsPanel</name>
    <message>
        <source>Exports</source>
        <translation>Exports</translation>
    </message>
    <message>
        <source>Queue of exports</source>
        <translation>File d’attente des exports</translation>
    </message>
    <message>
        <source>The exports, drawn from top to bottom.</source>
        <translation>Les exports, dessinés de haut en bas.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Mon&amp;ter</translation>
    </message>
    <message>
        <source>Draw the selected export earlier.</source>
        <translation>Dessiner plus tôt l’export sélectionné.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>D&amp;escendre</translation>
    </message>
    <message>
        <source>Draw the selected export later.</source>
        <translation>Dessiner plus tard l’export sélectionné.</translation>
    </message>
    <message>
        <source>&amp;Try Again</source>
        <translation>R&amp;éessayer</translation>
    </message>
    <message>
        <source>Try again to draw the selected exports that failed.</source>
        <translation>Redessiner les exports sélectionnés qui ont échoué.</translation>
    </message>
    <message>
        <source>Show the folder of the selected export in the file manager.</source>
        <translation>Afficher le dossier de l’export sélectionné dans le gestionnaire de fichiers.</translation>
    </message>
    <message>
        <source>&amp;Cancel Export</source>
        <translation>&amp;Annuler l’export</translation>
    </message>
    <message>
        <source>Clear &amp;Finished</source>
        <translation>Retirer les &amp;terminés</translation>
    </message>
    <message>
        <source>Remove all finished exports from the list; their files are kept.</source>
        <translation>Retirer de la liste tous les exports terminés&#x202f;; leurs fichiers restent.</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Reprendre</translation>
    </message>
    <message>
        <source>The exports that you have added to the queue. They are drawn one after another, from top to bottom, while you continue editing. Exports that are not finished when you quit continue the next time you start Barycage.</source>
        <translation>Les exports que vous avez ajoutés à la file d’attente. Ils sont dessinés l’un après l’autre, de haut en bas, pendant que vous continuez à travailler. Ceux qui ne sont pas terminés quand vous quittez reprennent au prochain démarrage de Barycage.</translation>
    </message>
    <message>
        <source>Pause or resume all exports without losing progress.</source>
        <translation>Mettre en pause ou reprendre tous les exports sans perdre ce qui est déjà dessiné.</translation>
    </message>
    <message>
        <source>Cancel the selected exports and remove them from the list; files already written are kept.</source>
        <translation>Annuler les exports sélectionnés et les retirer de la liste&#x202f;; les fichiers déjà écrits sont conservés.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>No exports are waiting. Choose Add to Queue in File › Export › Export Picture… to draw pictures one after another while you continue editing.</source>
        <translation>Aucun export n’attend. Choisissez Ajouter à la file d’attente dans Fichier › Exporter › Exporter l’image… pour dessiner des images l’une après l’autre pendant que vous continuez.</translation>
    </message>
</context>
<context>
    <name>view::FamilySliders</name>
    <message>
        <source>Parameter %1 of the family</source>
        <translation>Paramètre %1 de la famille</translation>
    </message>
    <message>
        <source>Change Family</source>
        <translation>Modifier la famille</translation>
    </message>
</context>
<context>
    <name>view::FitBox</name>
    <message>
        <source>Best of 2 to 8</source>
        <translation>La meilleure de 2 à 8</translation>
    </message>
    <message>
        <source>How many maps a suggestion has; in a range, a map is added only if it improves the fit enough</source>
        <translation>Combien d’applications a une suggestion&#x202f;; dans un intervalle, chacune doit être rentable</translation>
    </message>
    <message>
        <source>Number of maps</source>
        <translation>Nombre d’applications</translation>
    </message>
    <message>
        <source>Maps:</source>
        <translation>Applications&#x202f;:</translation>
    </message>
    <message>
        <source>Seconds to search</source>
        <translation>Secondes de recherche</translation>
    </message>
    <message>
        <source>How long to search for suggestions</source>
        <translation>Combien de temps chercher des suggestions</translation>
    </message>
    <message>
        <source>Seconds:</source>
        <translation>Secondes&#x202f;:</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Graine des nombres aléatoires</translation>
    </message>
    <message>
        <source>Another seed gives another search</source>
        <translation>Une autre graine cherche ailleurs</translation>
    </message>
    <message>
        <source>Seed:</source>
        <translation>Graine&#x202f;:</translation>
    </message>
    <message>
        <source>Similarities only</source>
        <translation>Similitudes seulement</translation>
    </message>
    <message>
        <source>Only maps that keep all angles</source>
        <translation>Seulement des applications qui conservent tous les angles</translation>
    </message>
    <message>
        <source>No mirror images</source>
        <translation>Sans images miroir</translation>
    </message>
    <message>
        <source>Only maps without reflection</source>
        <translation>Seulement des applications sans réflexion</translation>
    </message>
    <message>
        <source>First map a stem</source>
        <translation>Première application&#x202f;: une tige</translation>
    </message>
    <message>
        <source>The first map flattens the shape to a line, like the stem of a fern</source>
        <translation>La première application aplatit la forme en une ligne, comme la tige d’une fougère</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Quelconques</translation>
    </message>
    <message>
        <source>Multiples of %1°</source>
        <translation>Multiples de %1°</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>The angles by which the maps may rotate</source>
        <translation>De quels angles les applications peuvent tourner</translation>
    </message>
    <message>
        <source>Angles:</source>
        <translation>Angles&#x202f;:</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Suggérer</translation>
    </message>
    <message>
        <source>Find systems whose attractor looks like the target</source>
        <translation>Trouver des systèmes dont l’attracteur ressemble à la cible</translation>
    </message>
    <message>
        <source>Add a Map</source>
        <translation>Ajouter une application</translation>
    </message>
    <message>
        <source>Add a map where the agreement is worst</source>
        <translation>Ajouter une application là où l’accord est le plus mauvais</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Affiner les applications</translation>
    </message>
    <message>
        <source>Move the maps so that their images of the target cover it better</source>
        <translation>Déplacer les applications pour que leurs images de la cible la couvrent mieux</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Affiner l’attracteur</translation>
    </message>
    <message>
        <source>Move the maps so that the attractor itself comes closer to the target</source>
        <translation>Déplacer les applications pour que l’attracteur lui-même se rapproche de la cible</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Ajuster les poids</translation>
    </message>
    <message>
        <source>Find the weights that reproduce the shades of the picture</source>
        <translation>Trouver les poids qui reproduisent les nuances de l’image</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Ajuster la cage</translation>
    </message>
    <message>
        <source>Deform the attractor by a cage so that its outline follows that of the target</source>
        <translation>Déformer l’attracteur par une cage pour que son contour suive celui de la cible</translation>
    </message>
    <message>
        <source>Refine selected maps only</source>
        <translation>N’affiner que les applications sélectionnées</translation>
    </message>
    <message>
        <source>The maps that are not selected stay as they are</source>
        <translation>Les applications non sélectionnées restent telles quelles</translation>
    </message>
    <message>
        <source>Locked maps stay as they are while others are refined</source>
        <translation>Les applications verrouillées restent telles quelles pendant qu’on affine les autres</translation>
    </message>
    <message>
        <source>Corners of the cage</source>
        <translation>Sommets de la cage</translation>
    </message>
    <message>
        <source>How many corners the fitted cage has</source>
        <translation>Combien de sommets a la cage ajustée</translation>
    </message>
    <message>
        <source>Corners of the cage:</source>
        <translation>Sommets de la cage&#x202f;:</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Lock Selected Maps</source>
        <translation>Verrouiller les applications sélectionnées</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>Verrouillées&#x202f;: %1</translation>
    </message>
    <message>
        <source>Stop without changing anything</source>
        <translation>Arrêter sans rien changer</translation>
    </message>
</context>
<context>
    <name>view::FourViews</name>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
</context>
<context>
    <name>view::FrameSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>The width of the frames in pixels.</source>
        <translation>La largeur des images en pixels.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>The height of the frames in pixels.</source>
        <translation>La hauteur des images en pixels.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Taille nommée</translation>
    </message>
    <message>
        <source>Usual sizes of videos.</source>
        <translation>Tailles usuelles de vidéos.</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Garder les proportions</translation>
    </message>
    <message>
        <source>Keep the proportions of the frames</source>
        <translation>Garder les proportions des images</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Portrait ou paysage</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Échanger largeur et hauteur</translation>
    </message>
    <message>
        <source>Full HD: 1920 × 1080</source>
        <translation>Full HD&#x202f;: 1920 × 1080</translation>
    </message>
    <message>
        <source>HD: 1280 × 720</source>
        <translation>HD&#x202f;: 1280 × 720</translation>
    </message>
    <message>
        <source>4K: 3840 × 2160</source>
        <translation>4K&#x202f;: 3840 × 2160</translation>
    </message>
    <message>
        <source>Square: 1080 × 1080</source>
        <translation>Carré&#x202f;: 1080 × 1080</translation>
    </message>
    <message>
        <source>Portrait: 1080 × 1920</source>
        <translation>Portrait&#x202f;: 1080 × 1920</translation>
    </message>
    <message>
        <source>For a message: 640 × 360</source>
        <translation>Pour un message&#x202f;: 640 × 360</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisée</translation>
    </message>
</context>
<context>
    <name>view::GoToDialog</name>
    <message>
        <source>Centre, x</source>
        <translation>Centre, x</translation>
    </message>
    <message>
        <source>The x coordinate in the middle of the view.</source>
        <translation>L’abscisse au milieu de la vue.</translation>
    </message>
    <message>
        <source>Centre, y</source>
        <translation>Centre, y</translation>
    </message>
    <message>
        <source>The y coordinate in the middle of the view.</source>
        <translation>L’ordonnée au milieu de la vue.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>How much of the plane is seen, from the lower edge to the upper one.</source>
        <translation>Ce que l’on voit du plan, du bord inférieur au bord supérieur.</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Aller à</translation>
    </message>
    <message>
        <source>such as 3 2 1</source>
        <translation>par exemple 3 2 1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Numbers of maps, as the status bar shows them for the point under the pointer. They repeat, and the centre becomes the point that they lead to.</source>
        <translation>Des numéros d’applications, comme la barre d’état les montre pour le point sous le pointeur. Ils se répètent, et le centre devient le point où ils mènent.</translation>
    </message>
    <message>
        <source>Choose a map</source>
        <translation>Choisir une application</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Point fixe</translation>
    </message>
    <message>
        <source>The centre becomes the point that this map leaves where it is.</source>
        <translation>Le centre devient le point que cette application laisse en place.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>&amp;Centre:</source>
        <translation>&amp;Centre&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Hauteur&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Adresse&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Fixed point of:</source>
        <translation>Point &amp;fixe de&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>A&amp;ller</translation>
    </message>
    <message>
        <source>Shows this part of the plane. The fractal stays as it is.</source>
        <translation>Montre cette partie du plan. La fractale reste telle quelle.</translation>
    </message>
    <message>
        <source>No point has this address: a map in it is switched off, or does not contract.</source>
        <translation>Aucun point n’a cette adresse&#x202f;: une de ses applications est désactivée ou n’est pas contractante.</translation>
    </message>
    <message>
        <source>An address has the numbers of maps, from 1 to %1.</source>
        <translation>Une adresse est faite de numéros d’applications, de 1 à %1.</translation>
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
        <source>Stop Colour</source>
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
        <source>Add a stop after the selected one</source>
        <translation>Ajouter un repère après celui qui est choisi</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Supprimer le repère</translation>
    </message>
    <message>
        <source>Delete the selected stop</source>
        <translation>Supprimer le repère choisi</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Reverse the order of the colours</source>
        <translation>Retourner la palette</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Répartir</translation>
    </message>
    <message>
        <source>Space the stops evenly</source>
        <translation>Mettre les repères à distances égales</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Charger…</translation>
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
        <source>The palettes in the file. Select one.</source>
        <translation>Les palettes que contient le fichier. Choisissez-en une.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>Take the palette from a picture</source>
        <translation>Prendre la palette d’une image</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ggr, .ugr or .map file, or take it from a picture</source>
        <translation>Charger une palette d’un fichier .gpl, .ggr, .ugr ou .map, ou la prendre d’une image</translation>
    </message>
    <message>
        <source>Palettes and pictures (%1);;All files (*)</source>
        <translation>Palettes et images (%1);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Repères du dégradé</translation>
    </message>
    <message>
        <source>Double-click: add a stop, or change the colour of one. Drag: move. Del: delete.
Keys: Page Up and Page Down select a stop, the arrow keys move it, Ins adds one, Enter opens its colour.</source>
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
    <name>view::HandoutDialog</name>
    <message>
        <source>&amp;Cage and maps</source>
        <translation>&amp;Cage et applications</translation>
    </message>
    <message>
        <source>&amp;Formulas</source>
        <translation>F&amp;ormules</translation>
    </message>
    <message>
        <source>&amp;Line for name and date</source>
        <translation>&amp;Ligne pour le nom et la date</translation>
    </message>
    <message>
        <source>Print a Handout</source>
        <translation>Imprimer une fiche pour la classe</translation>
    </message>
    <message>
        <source>Pre&amp;view…</source>
        <translation>A&amp;perçu…</translation>
    </message>
    <message>
        <source>Show the pages before they are printed</source>
        <translation>Afficher les pages avant de les imprimer</translation>
    </message>
    <message>
        <source>&amp;Entries:</source>
        <translation>&amp;Entrées&#x202f;:</translation>
    </message>
    <message>
        <source>Entries to print</source>
        <translation>Entrées à imprimer</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Toutes</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>A&amp;ucune</translation>
    </message>
    <message>
        <source>Print all entries of the list</source>
        <translation>Imprimer toutes les entrées de la liste</translation>
    </message>
    <message>
        <source>Remove all ticks</source>
        <translation>Décocher toutes les entrées</translation>
    </message>
    <message>
        <source>Handout with pictures</source>
        <translation>Fiche avec images</translation>
    </message>
    <message>
        <source>Blank worksheet</source>
        <translation>Feuille d’exercices vierge</translation>
    </message>
    <message>
        <source>Kind of sheet</source>
        <translation>Type de feuille</translation>
    </message>
    <message>
        <source>Entries per page</source>
        <translation>Entrées par page</translation>
    </message>
    <message>
        <source>How many entries are printed on one page.</source>
        <translation>Combien d’entrées sont imprimées sur une page.</translation>
    </message>
    <message>
        <source>Draw the cage and its numbered images over the picture</source>
        <translation>Tracer la cage et ses images numérotées par-dessus l’image</translation>
    </message>
    <message>
        <source>Print the formula and the probability of each map</source>
        <translation>Imprimer la formule et la probabilité de chaque application</translation>
    </message>
    <message>
        <source>Leave lines at the top of each page for a name and a date</source>
        <translation>Laisser en haut de chaque page des lignes pour un nom et une date</translation>
    </message>
    <message>
        <source>&amp;Sheet:</source>
        <translation>&amp;Feuille&#x202f;:</translation>
    </message>
    <message>
        <source>Entries per &amp;page:</source>
        <translation>Entrées par p&amp;age&#x202f;:</translation>
    </message>
    <message>
        <source>Choose at most %1 entries</source>
        <translation>Choisissez au plus %1 entrées</translation>
    </message>
    <message>
        <source>Choose an entry first</source>
        <translation>Choisissez d’abord une entrée</translation>
    </message>
    <message>
        <source>%1-handout.pdf</source>
        <comment>name of a file</comment>
        <translation>%1-fiche.pdf</translation>
    </message>
    <message>
        <source>Prints entries of the file for a class: with pictures and formulas, or as blank worksheets.</source>
        <translation>Imprime des entrées du fichier pour une classe&#x202f;: avec images et formules, ou comme feuilles d’exercices vierges.</translation>
    </message>
    <message>
        <source>The entries of the file that could be read. Ticked entries are printed in this order, up to %1 of them.</source>
        <translation>Les entrées du fichier qui ont pu être lues. Celles qui sont cochées sont imprimées dans cet ordre, %1 au plus.</translation>
    </message>
    <message>
        <source>A handout has the picture of each entry, with its cage, its maps and their formulas. A blank worksheet has the cage, in the plane on a grid, and an empty table, to be filled in by hand.</source>
        <translation>Une fiche montre l’image de chaque entrée avec sa cage, ses applications et leurs formules. Une feuille d’exercices vierge montre la cage, dans le plan sur une grille, et un tableau vide à remplir à la main.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
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
        <source>Select a step to go back or forward to it.</source>
        <translation>Choisissez une étape pour y revenir ou pour y avancer.</translation>
    </message>
    <message>
        <source>Select a step to go back or forward to it. The disk marks the saved state.</source>
        <translation>Choisissez une étape pour y revenir ou pour y avancer. La disquette marque ce qui est enregistré.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>État à l’ouverture</translation>
    </message>
</context>
<context>
    <name>view::LessonCard</name>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Précédent</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Texte de l’étape</translation>
    </message>
    <message>
        <source>Show the previous step (Page Up)</source>
        <translation>Montrer l’étape précédente (Page préc.)</translation>
    </message>
    <message>
        <source>Show the next step (Page Down)</source>
        <translation>Montrer l’étape suivante (Page suiv.)</translation>
    </message>
    <message>
        <source>End the lesson and return to the window as it was (Esc)</source>
        <translation>Terminer la leçon et revenir à la fenêtre telle qu’elle était (Échap)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
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
        <source>A lesson in progress: the text of the current step, and buttons to go to the others.</source>
        <translation>Une leçon en cours&#x202f;: le texte de l’étape actuelle, et des boutons pour passer aux autres.</translation>
    </message>
</context>
<context>
    <name>view::LessonNotebook</name>
    <message>
        <source>Rename lesson</source>
        <translation>Renommer la leçon</translation>
    </message>
    <message>
        <source>Add step</source>
        <translation>Ajouter une étape</translation>
    </message>
    <message>
        <source>Update step</source>
        <translation>Mettre à jour l’étape</translation>
    </message>
    <message>
        <source>Rename step</source>
        <translation>Renommer l’étape</translation>
    </message>
    <message>
        <source>Edit text</source>
        <translation>Modifier le texte</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>Retirer l’étape</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Déplacer l’étape</translation>
    </message>
</context>
<context>
    <name>view::LessonPanel</name>
    <message>
        <source>Arrange the window as you want to show it, and press Add Step. Then write the text of the step.</source>
        <translation>Disposez la fenêtre comme la classe doit la voir et cliquez sur «&#x202f;Ajouter une étape&#x202f;». Écrivez ensuite ce que vous voulez en dire.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Jouer</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>&amp;Enregistrer la leçon…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>Add Step</source>
        <translation>Ajouter une étape</translation>
    </message>
    <message>
        <source>Add a step with the current state of the window</source>
        <translation>Ajouter une étape avec l’état actuel de la fenêtre</translation>
    </message>
    <message>
        <source>Update Step</source>
        <translation>Mettre à jour l’étape</translation>
    </message>
    <message>
        <source>Replace the state of the selected step by the current state of the window</source>
        <translation>Donner à l’étape choisie l’état actuel de la fenêtre</translation>
    </message>
    <message>
        <source>Show Step</source>
        <translation>Montrer l’étape</translation>
    </message>
    <message>
        <source>Restore the window to the state of the selected step</source>
        <translation>Mettre la fenêtre dans l’état de l’étape choisie</translation>
    </message>
    <message>
        <source>Remove Step</source>
        <translation>Retirer l’étape</translation>
    </message>
    <message>
        <source>Remove the selected step</source>
        <translation>Retirer l’étape choisie</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Show the selected step earlier</source>
        <translation>Montrer plus tôt l’étape choisie</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Show the selected step later</source>
        <translation>Montrer plus tard l’étape choisie</translation>
    </message>
    <message>
        <source>Undo in the Lesson</source>
        <translation>Annuler dans la leçon</translation>
    </message>
    <message>
        <source>Undo the last change of the lesson</source>
        <translation>Annuler la dernière modification de la leçon</translation>
    </message>
    <message>
        <source>Redo in the Lesson</source>
        <translation>Rétablir dans la leçon</translation>
    </message>
    <message>
        <source>Redo the change of the lesson</source>
        <translation>Rétablir la modification de la leçon</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Titre de la leçon</translation>
    </message>
    <message>
        <source>Shown above every step while the lesson is played</source>
        <translation>Affiché au-dessus de chaque étape pendant la leçon</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Étapes de la leçon</translation>
    </message>
    <message>
        <source>Double-click a step to restore its state of the window</source>
        <translation>Double-cliquez sur une étape pour mettre la fenêtre dans son état</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>Titre de l’étape</translation>
    </message>
    <message>
        <source>Shown in large letters above the text</source>
        <translation>Affiché en grandes lettres au-dessus du texte</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Texte de l’étape</translation>
    </message>
    <message>
        <source>Shown beside the picture; leave a line empty to begin a paragraph</source>
        <translation>Affiché à côté de l’image&#x202f;; une ligne vide commence un paragraphe</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>The panels that this step shows beside the canvas; all others are hidden</source>
        <translation>Les panneaux que cette étape montre à côté du canevas&#x202f;; tous les autres sont masqués</translation>
    </message>
    <message>
        <source>Panels of the step</source>
        <translation>Panneaux de l’étape</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and title of a step</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. A lesson is a list of steps. Each has a text, and the state of the window that belongs to it: the entry, the view, the tool, colours and outlines.</source>
        <translation>%1. Une leçon est une liste d’étapes. Chacune a un texte et l’état de la fenêtre qui lui correspond&#x202f;: l’entrée, ce qu’on en voit, l’outil, les couleurs et les contours.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Jouer la leçon sur tout l’écran, depuis le début ou à partir de l’étape sur laquelle vous avez cliqué dans la liste</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Enregistrer la leçon comme un texte qui désigne ses fractales</translation>
    </message>
</context>
<context>
    <name>view::LightBall</name>
    <message>
        <source>Direction of the light</source>
        <translation>Direction de la lumière</translation>
    </message>
    <message>
        <source>Drag the light over the sphere, or use the arrow keys</source>
        <translation>Faites glisser la lumière sur la sphère, ou utilisez les touches fléchées</translation>
    </message>
    <message>
        <source>Azimuth %1°, elevation %2°</source>
        <translation>Azimut %1°, élévation %2°</translation>
    </message>
</context>
<context>
    <name>view::LinePicture</name>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it; click to take all</source>
        <translation>Tracez une ligne pour ne prendre que les couleurs le long de celle-ci&#x202f;; cliquez pour les prendre toutes</translation>
    </message>
</context>
<context>
    <name>view::LinkGraph</name>
    <message>
        <source>Graph of links</source>
        <translation>Graphe des liens</translation>
    </message>
    <message>
        <source>Drag from one map to another to link them; click an arrow and press Delete to remove it.</source>
        <translation>Faites glisser d’une application à une autre pour les lier&#x202f;; cliquez sur une flèche et appuyez sur Suppr pour la retirer.</translation>
    </message>
    <message>
        <source>Each circle is a map, and an arrow leads to each map that may follow it in the chaos game; thicker arrows have more weight. Drag from one map to another to link them, or out of a map and back to link it to itself. Click an arrow and press Delete to remove it, or double-click it to enter its weight. With the keyboard: Left and Right walk through the maps, Up and Down through the arrows of a map; Space begins a new arrow, Left and Right choose its end, Enter adds it. Maps with a dashed ring take no part; the reason is shown beside them.</source>
        <translation>Chaque cercle est une application, et une flèche mène à chaque application qui peut la suivre dans le jeu du chaos&#x202f;; les flèches plus épaisses ont plus de poids. Faites glisser d’une application à une autre pour les lier, ou hors d’une application et retour pour la lier à elle-même. Cliquez sur une flèche et appuyez sur Suppr pour la retirer, ou double-cliquez pour saisir son poids. Au clavier&#x202f;: Gauche et Droite parcourent les applications, Haut et Bas les flèches d’une application&#x202f;; Espace commence une nouvelle flèche, Gauche et Droite en choisissent la fin, Entrée l’ajoute. Les applications à l’anneau pointillé ne participent pas, pour la raison indiquée à côté.</translation>
    </message>
    <message>
        <source>No map is selected.</source>
        <translation>Aucune application n’est sélectionnée.</translation>
    </message>
    <message>
        <source>New arrow from map %1 to map %2. Enter adds it, Esc cancels.</source>
        <translation>Nouvelle flèche de l’application %1 à l’application %2. Entrée l’ajoute, Échap non.</translation>
    </message>
    <message>
        <source>Map %1: %2</source>
        <translation>Application %1&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>view::LinksModel</name>
    <message>
        <source>Switched off</source>
        <translation>Désactivée</translation>
    </message>
    <message>
        <source>Unreached: no map leads to it</source>
        <translation>Non atteinte&#x202f;: aucune application n’y mène</translation>
    </message>
    <message>
        <source>Transient: the chaos game never returns</source>
        <translation>Quittée&#x202f;: le jeu du chaos n’y revient jamais</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Participe</translation>
    </message>
    <message>
        <source>From map %1 to map %2: %3</source>
        <translation>De l’application %1 à l’application %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>Link map %1 to map %2</source>
        <translation>Lier l’application %1 à l’application %2</translation>
    </message>
    <message>
        <source>In the chaos game</source>
        <translation>Dans le jeu du chaos</translation>
    </message>
    <message>
        <source>Whether the chaos game keeps applying the map, or why not</source>
        <translation>Si l’application est appliquée encore et encore, ou pourquoi pas</translation>
    </message>
    <message>
        <source>To map %1</source>
        <translation>Vers l’application %1</translation>
    </message>
    <message>
        <source>From map %1</source>
        <translation>De l’application %1</translation>
    </message>
    <message>
        <source>Unlink map %1 from map %2</source>
        <translation>Délier l’application %1 de l’application %2</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n link(s)</source>
        <translation>
            <numerusform>Supprimer %n lien</numerusform>
            <numerusform>Supprimer %n liens</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends: every sequence from here stops</source>
        <translation>S’arrête&#x202f;: toute suite à partir d’ici prend fin</translation>
    </message>
    <message>
        <source>Directly after map %1, map %2 has %3 times its weight.</source>
        <translation>Juste après l’application %1, l’application %2 est appliquée avec son poids multiplié par %3.</translation>
    </message>
    <message>
        <source>Map %2 is never applied directly after map %1.</source>
        <translation>Juste après l’application %1, l’application %2 n’est jamais appliquée.</translation>
    </message>
</context>
<context>
    <name>view::LinksPanel</name>
    <message>
        <source>Remove All Links</source>
        <translation>Retirer tous les liens</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Liens</translation>
    </message>
    <message>
        <source>Links between maps</source>
        <translation>Liens entre applications</translation>
    </message>
    <message>
        <source>Rows are the maps applied before, columns the maps applied after. A number multiplies the weight of the map in its column: 1 leaves it unchanged, 0 forbids the link.</source>
        <translation>Les lignes sont les applications appliquées avant, les colonnes celles d’après. Un nombre multiplie le poids de l’application de la colonne&#x202f;: 1 le laisse tel quel, 0 l’interdit.</translation>
    </message>
    <message>
        <source>Any map may follow any other again</source>
        <translation>Toute application peut de nouveau suivre toute autre</translation>
    </message>
    <message>
        <source>Every sequence of maps ends, so nothing is drawn.</source>
        <translation>Toute suite d’applications prend fin&#x202f;; rien n’est donc dessiné.</translation>
    </message>
    <message>
        <source>Remove all links</source>
        <translation>Retirer tous les liens</translation>
    </message>
    <message>
        <source>Any map may follow any other. Click an arrow and press Delete to forbid it.</source>
        <translation>Toute application peut suivre toute autre. Cliquez sur une flèche et appuyez sur Suppr pour l’interdire.</translation>
    </message>
    <message>
        <source>No map has a choice of what follows it, so only single points are drawn.</source>
        <translation>Une seule application peut suivre chacune&#x202f;: seuls des points isolés sont dessinés.</translation>
    </message>
    <message>
        <source>Row: the map before. Column: the map after.</source>
        <translation>Ligne&#x202f;: l’application d’avant. Colonne&#x202f;: celle d’après.</translation>
    </message>
</context>
<context>
    <name>view::MapBlendRow</name>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>The position on the palette to which this map moves colours, from 0 to 1</source>
        <translation>Vers où sur la palette cette application attire les couleurs&#x202f;: de 0, son début, à 1</translation>
    </message>
    <message>
        <source>Whenever this map is applied, the colour of the point moves towards the position of the map on the palette: 0 is the beginning of the palette, 1 its end. Flame programs call it the colour coordinate.</source>
        <translation>Chaque fois qu’une application agit, la couleur d’un point se rapproche de la place de cette application sur la palette&#x202f;: 0 est le début de la palette, 1 sa fin. Les flames l’appellent la coordonnée de couleur.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How far this map moves colours each time, from 0 (not at all) to 1 (all the way)</source>
        <translation>Jusqu’où cette application attire les couleurs chaque fois&#x202f;: de 0, pas du tout, à 1, tout le chemin</translation>
    </message>
    <message>
        <source>How far the map moves colours towards its position on the palette each time: with 1, its piece has a single colour; with 0, all colours stay as they are. Flame programs call it the colour speed.</source>
        <translation>Quelle part du chemin vers sa place sur la palette l’application fait parcourir aux couleurs chaque fois&#x202f;: avec 1, sa pièce a une seule couleur, avec 0, elle laisse toutes les couleurs telles quelles. Les flames l’appellent la vitesse de couleur.</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1&#x202f;: %2 %3</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
</context>
<context>
    <name>view::MapOrder</name>
    <message>
        <source>Order of the maps</source>
        <translation>Ordre des applications</translation>
    </message>
    <message>
        <source>Where pieces overlap, the map that is higher in this list is on top; drag a map to move it</source>
        <translation>Là où des parties se recouvrent, l’application placée plus haut dans cette liste est au-dessus&#x202f;; faites glisser une application pour la déplacer</translation>
    </message>
    <message>
        <source>Move the map towards the top</source>
        <translation>Déplacer l’application vers le haut</translation>
    </message>
    <message>
        <source>Move the map towards the bottom</source>
        <translation>Déplacer l’application vers le bas</translation>
    </message>
    <message>
        <source>On top</source>
        <translation>Au-dessus</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Réinitialiser l’ordre</translation>
    </message>
    <message>
        <source>Reset Order: puts the maps back in the order of their numbers</source>
        <translation>Réinitialiser l’ordre&#x202f;: remet les applications dans l’ordre de leurs numéros</translation>
    </message>
    <message>
        <source>Puts the maps back in the order of their numbers, which is that of the Maps panel: map 1 is on top. This is one step that you can undo.</source>
        <translation>Remet les applications dans l’ordre de leurs numéros, celui du panneau Applications&#x202f;: l’application 1 est au-dessus. C’est une seule étape, que vous pouvez annuler.</translation>
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
        <source>Scale at right angles to that; negative if the map reflects</source>
        <translation>Échelle en travers&#x202f;; négative quand l’application renverse l’orientation</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <source>Shear along x, applied first</source>
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
        <source>%1: %2 %3</source>
        <translation>%1&#x202f;: %2 %3</translation>
    </message>
    <message>
        <source>Axis of the rotation; only its direction matters</source>
        <translation>Axe de la rotation&#x202f;; seule sa direction compte</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>Axe x</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Axe y</translation>
    </message>
    <message>
        <source>Axis z</source>
        <translation>Axe z</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise as seen from the tip of the axis looking back</source>
        <translation>Angle en degrés, dans le sens antihoraire vu depuis la pointe de l’axe</translation>
    </message>
    <message>
        <source>Scale along y, before the rotation</source>
        <translation>Échelle selon y, avant la rotation</translation>
    </message>
    <message>
        <source>Scale z</source>
        <translation>Échelle z</translation>
    </message>
    <message>
        <source>Scale along z, before the rotation; negative if the map reflects</source>
        <translation>Échelle selon z, avant la rotation&#x202f;; négative quand l’application renverse l’orientation</translation>
    </message>
    <message>
        <source>Shear xy</source>
        <translation>Cisaillement xy</translation>
    </message>
    <message>
        <source>What y adds to x, applied first</source>
        <translation>Ce que y ajoute à x, appliqué en premier</translation>
    </message>
    <message>
        <source>Shear xz</source>
        <translation>Cisaillement xz</translation>
    </message>
    <message>
        <source>What z adds to x, applied first</source>
        <translation>Ce que z ajoute à x, appliqué en premier</translation>
    </message>
    <message>
        <source>Shear yz</source>
        <translation>Cisaillement yz</translation>
    </message>
    <message>
        <source>What z adds to y, applied first</source>
        <translation>Ce que z ajoute à y, appliqué en premier</translation>
    </message>
    <message>
        <source>Translation j, applied last</source>
        <translation>Translation j, appliquée en dernier</translation>
    </message>
    <message>
        <source>Translation k, applied last</source>
        <translation>Translation k, appliquée en dernier</translation>
    </message>
    <message>
        <source>Shift z</source>
        <translation>Translation z</translation>
    </message>
    <message>
        <source>Translation l, applied last</source>
        <translation>Translation l, appliquée en dernier</translation>
    </message>
    <message>
        <source>Map %1, locked</source>
        <translation>Application %1, verrouillée</translation>
    </message>
</context>
<context>
    <name>view::MapsClipboard</name>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in space.</source>
        <translation>Rien n’a été collé&#x202f;: les applications copiées sont celles d’un système dans l’espace.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in the plane.</source>
        <translation>Rien n’a été collé&#x202f;: les applications copiées sont celles d’un système dans le plan.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard contains no rows of 12 or 13 numbers.</source>
        <translation>Rien n’a été collé&#x202f;: le presse-papiers ne contient pas de lignes de 12 ou 13 nombres.</translation>
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
    <message>
        <source>Name of map %1</source>
        <translation>Nom de l’application %1</translation>
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
        <source>A reflected similarity keeps shapes but mirrors them; it also turns, scales and shifts them.</source>
        <translation>Une similitude indirecte conserve les formes à la manière d’un miroir, change l’échelle et translate.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels but not angles.</source>
        <translation>Une application affine conserve les droites et le parallélisme, mais pas les angles.</translation>
    </message>
    <message>
        <source>A singular map takes the whole plane to a line.</source>
        <translation>Une application singulière envoie le plan dans une droite.</translation>
    </message>
    <message>
        <source>A constant map takes the whole plane to one point.</source>
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
        <source>Effective code: the map as it acts on the picture under the current cage. Bake turns it into the code.</source>
        <translation>Code effectif&#x202f;: l’application telle qu’elle agit sur l’image sous la cage actuelle. «&#x202f;Intégrer&#x202f;» en fait le code.</translation>
    </message>
    <message>
        <source>Weight as entered: how often the chaos game chooses the map. The weights need not sum to 1.</source>
        <translation>Poids tel qu’il est donné&#x202f;: la fréquence à laquelle le jeu du chaos choisit l’application. La somme des poids n’est pas forcément 1.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor by which areas change; negative if the map reflects.</source>
        <translation>Déterminant ad − bc&#x202f;: le facteur des aires&#x202f;; négatif quand l’application renverse l’orientation.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the largest factor by which distances are stretched.</source>
        <translation>Facteur de contraction ‖A‖, la plus grande valeur singulière&#x202f;: le plus grand facteur dont les distances augmentent.</translation>
    </message>
    <message>
        <source>The geometric kind of the map.</source>
        <translation>Ce qu’est l’application géométriquement.</translation>
    </message>
    <message>
        <source>Map %1 is switched on.</source>
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
        <source>No weight is given; the determinant rule gives the probability %1.</source>
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
        <source>Switch map %1 on</source>
        <translation>Activer l’application %1</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Désactiver l’application %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>active</translation>
    </message>
    <message>
        <source>off</source>
        <translation>inactive</translation>
    </message>
    <message>
        <source>Set %1 of map %2 to %3</source>
        <translation>Fixer %1 de l’application %2 à %3</translation>
    </message>
    <message>
        <source>Colour of map %1: %2</source>
        <translation>Couleur de l’application %1&#x202f;: %2</translation>
    </message>
    <message>
        <source>A singular map takes the whole of space to a plane or a line.</source>
        <translation>Une application singulière envoie l’espace dans un plan ou une droite.</translation>
    </message>
    <message>
        <source>A constant map takes the whole of space to one point.</source>
        <translation>Une application constante envoie l’espace sur un seul point.</translation>
    </message>
    <message>
        <source>The map takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</source>
        <translation>L’application envoie (x, y, z) sur (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage.</source>
        <translation>Code effectif&#x202f;: l’application telle qu’elle agit sur l’image sous la cage actuelle.</translation>
    </message>
    <message>
        <source>Determinant: the factor by which volumes change; negative if the map reflects.</source>
        <translation>Déterminant&#x202f;: le facteur des volumes&#x202f;; négatif quand l’application renverse l’orientation.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Whether the map is switched on. Alt+click shows one map alone.</source>
        <translation>Si l’application est active. Alt+clic affiche une application seule.</translation>
    </message>
    <message>
        <source>Whether the map is locked: then it cannot be edited, moved or deleted by mistake.</source>
        <translation>Si l’application est verrouillée&#x202f;: elle ne peut alors être ni modifiée, ni déplacée, ni supprimée par erreur.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map, and the part of the attractor that the map makes.</source>
        <translation>Couleur de l’application, quand l’image est colorée par application, et la partie de l’attracteur qu’elle produit.</translation>
    </message>
    <message>
        <source>Name of the map.</source>
        <translation>Nom de l’application.</translation>
    </message>
    <message>
        <source>Map %1 is shown alone.</source>
        <translation>L’application %1 est affichée seule.</translation>
    </message>
    <message>
        <source>Map %1 is locked.</source>
        <translation>L’application %1 est verrouillée.</translation>
    </message>
    <message>
        <source>Map %1 is not locked.</source>
        <translation>L’application %1 n’est pas verrouillée.</translation>
    </message>
    <message>
        <source>Map %1 has no name. Double-click to name it.</source>
        <translation>L’application %1 n’a pas de nom. Double-cliquez pour la nommer.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillée</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>non verrouillée</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>sans nom</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Supprimer le nom de l’application %1</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Nommer «&#x202f;%2&#x202f;» l’application %1</translation>
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
        <source>Replace the code by the effective code; the cage is then at rest</source>
        <translation>Faire du code effectif le code&#x202f;; la cage est ensuite au repos</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, for an even picture</source>
        <translation>Poids proportionnels aux aires des images, pour une image uniforme</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Poids</translation>
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
        <source>Properties</source>
        <translation>Propriétés</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Afficher le déterminant, le facteur de contraction et la nature de chaque application</translation>
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
        <source>This entry could not be read. It is kept unchanged.</source>
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
        <source>Reorder maps</source>
        <translation>Réordonner les applications</translation>
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
        <source>Each row is a map: it takes (x, y) to (a x + b y + e, c x + d y + f) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Chaque ligne est une application&#x202f;: (x, y) devient (a x + b y + e, c x + d y + f), aussi souvent que le dit son poids p. Double-cliquez sur un nombre, ou commencez à taper, pour le modifier&#x202f;; l’image suit chaque frappe. Faites glisser le numéro d’une ligne pour la déplacer.</translation>
    </message>
    <message>
        <source>Properties of the map</source>
        <translation>Propriétés de l’application</translation>
    </message>
    <message>
        <source>det %1    ‖A‖ %2    %3</source>
        <translation>det %1    ‖A‖ %2    %3</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>Poids&#x202f;: %1</translation>
    </message>
    <message>
        <source>No maps: add one.</source>
        <translation>Pas d’application&#x202f;: ajoutez-en une.</translation>
    </message>
    <message>
        <source>Weights in proportion to the volumes of the images, for an even picture</source>
        <translation>Poids proportionnels aux volumes des images, pour une image uniforme</translation>
    </message>
    <message>
        <source>Show the coefficients a … l</source>
        <translation>Afficher les coefficients a … l</translation>
    </message>
    <message>
        <source>Each row is a map: it takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Chaque ligne est une application&#x202f;: (x, y, z) devient (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l), aussi souvent que le dit son poids p. Double-cliquez sur un nombre, ou commencez à taper, pour le modifier&#x202f;; l’image suit chaque frappe. Faites glisser le numéro d’une ligne pour la déplacer.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Move the selected maps to the clipboard</source>
        <translation>Déplacer les applications sélectionnées dans le presse-papiers</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Donner un nom à l’application courante</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing</source>
        <translation>Protéger les applications sélectionnées des modifications</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Show the current map alone; the file does not change</source>
        <translation>Afficher seule l’application courante&#x202f;; le fichier ne change pas</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms</translation>
    </message>
    <message>
        <source>Show the names of the maps</source>
        <translation>Afficher les noms des applications</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f g h i j k l p, separated by tabs</source>
        <translation>Copier les applications sélectionnées en lignes a b c d e f g h i j k l p, séparées par des tabulations</translation>
    </message>
    <message>
        <source>Add rows of 12 or 13 numbers from the clipboard as new maps</source>
        <translation>Ajouter des lignes de 12 ou 13 nombres du presse-papiers comme nouvelles applications</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 12 or 13 numbers from the clipboard</source>
        <translation>Remplacer les applications sélectionnées par des lignes de 12 ou 13 nombres du presse-papiers</translation>
    </message>
    <message>
        <source>Cut a map</source>
        <translation>Couper une application</translation>
    </message>
    <message>
        <source>Cut %1 maps</source>
        <translation>Couper %1 applications</translation>
    </message>
    <message>
        <source>Effective</source>
        <translation>Effectif</translation>
    </message>
    <message>
        <source>Select a map to see and edit it here.</source>
        <translation>Sélectionnez une application pour la voir et la modifier ici.</translation>
    </message>
    <message>
        <source>Map %1 only, of %2 selected    %3</source>
        <translation>Application %1 seule, sur %2 sélectionnées    %3</translation>
    </message>
    <message>
        <source>Show the coefficients of the maps</source>
        <translation>Afficher les coefficients des applications</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Numéros des applications</translation>
    </message>
    <message>
        <source>Drag a number to move the map. A warning sign marks a map that does not contract, or that a negative weight switches off.</source>
        <translation>Faites glisser un numéro pour placer l’application ailleurs. Une marque signale une application qui n’est pas contractante ou qu’un poids négatif désactive.</translation>
    </message>
</context>
<context>
    <name>view::MapsTable</name>
    <message>
        <source>Drag the name of a number left or right to change it in the current map: a tenth as fast with Shift, ten times as fast with Ctrl. The wheel does the same while the pointer is over the current cell. Drag the edge of a name to change the width of its column.</source>
        <translation>Faites glisser le nom d’un nombre vers la gauche ou la droite pour le modifier dans l’application courante&#x202f;: dix fois moins vite avec Maj, dix fois plus vite avec Ctrl. La molette fait de même tant que le pointeur est sur la cellule courante. Faites glisser le bord d’un nom pour changer la largeur de sa colonne.</translation>
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
        <source>Maps that are flat on the screen cannot be dragged. First open the cage or the maps.</source>
        <translation>Les applications qui sont plates à l’écran ne peuvent pas être déplacées. Ouvrez d’abord la cage ou les applications.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Choisissez d’abord une application.</translation>
    </message>
    <message>
        <source>There are too many maps to show them all. Zoom in to see the others.</source>
        <translation>De si nombreuses applications, seules quelques-unes sont montrées. Agrandissez la vue pour voir les autres.</translation>
    </message>
</context>
<context>
    <name>view::MorphDialog</name>
    <message>
        <source>A fractal in the plane cannot become one in space.</source>
        <translation>Une fractale du plan ne peut pas devenir une fractale de l’espace.</translation>
    </message>
    <message>
        <source>One of the two fractals has more than 256 maps.</source>
        <translation>L’une des deux fractales a plus de 256 applications.</translation>
    </message>
    <message>
        <source>The maps of one of the two fractals are linked.</source>
        <translation>Les applications de l’une des deux fractales sont liées.</translation>
    </message>
    <message>
        <source>A bent cage has no code to start from. Reset or bake it first.</source>
        <translation>Une cage courbée n’a pas de code d’où partir. Réinitialisez-la ou intégrez-la d’abord.</translation>
    </message>
    <message>
        <source>One of the two fractals has no attractor.</source>
        <translation>L’une des deux fractales n’a pas d’attracteur.</translation>
    </message>
    <message>
        <source>Morph “%1”</source>
        <translation>Morphing de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>The entry of this file that the fractal becomes.</source>
        <translation>L’entrée de ce fichier que devient la fractale.</translation>
    </message>
    <message>
        <source>&amp;Becomes:</source>
        <translation>&amp;Devient&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Add Morph</source>
        <translation>&amp;Ajouter le morphing</translation>
    </message>
    <message>
        <source>Adds the morph to the file as an entry of its own, in one step that you can undo.</source>
        <translation>Ajoute le morphing au fichier comme entrée à part, en une seule étape que vous pouvez annuler.</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>&amp;Libérer les paires</translation>
    </message>
    <message>
        <source>Pairs all maps so that the total distance is shortest.</source>
        <translation>Laisse toutes les applications suivre le chemin le plus court.</translation>
    </message>
    <message>
        <source>The morph at %1 %</source>
        <translation>Le morphing à %1 %</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Ce fichier n’a pas d’autre fractale de cette dimension.</translation>
    </message>
</context>
<context>
    <name>view::MorphLines</name>
    <message>
        <source>Pairs of maps</source>
        <translation>Paires d’applications</translation>
    </message>
    <message>
        <source>The maps of this fractal are on the left, those of the other one on the right. A line shows what a map becomes, and its thickness shows its share of the weight. Drag from a map to one in the other column to pin the pair, and again to unpin it. With the keyboard: choose a map with the arrow keys, press Space, go to the other map and press Space again. Del removes all pins of a map.</source>
        <translation>À gauche les applications de cette fractale, à droite celles de l’autre. Une ligne montre ce que devient une application, et son épaisseur la part du poids qui prend ce chemin. Faites glisser d’une application à une autre de l’autre colonne pour fixer la paire, et de nouveau pour la libérer. Au clavier&#x202f;: choisissez une application avec les flèches, appuyez sur Espace, allez à l’autre et appuyez de nouveau sur Espace. Suppr libère toutes les paires fixées d’une application.</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>%1 (%2 %, pinned)</source>
        <translation>%1 (%2 %, fixée)</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Map %1 takes no part.</source>
        <translation>L’application %1 ne participe pas.</translation>
    </message>
    <message>
        <source>Map %1 becomes map %2.</source>
        <translation>L’application %1 devient l’application %2.</translation>
    </message>
    <message>
        <source>Map %1 comes from map %2.</source>
        <translation>L’application %1 vient de l’application %2.</translation>
    </message>
</context>
<context>
    <name>view::MotionDialog</name>
    <message>
        <source>Change the motion “%1”</source>
        <translation>Modifier le mouvement «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Motion: %1</source>
        <translation>Mouvement&#x202f;: %1</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Force</translation>
    </message>
    <message>
        <source>How far the branches swing at most, as an angle about their roots. A negative strength swings them the other way.</source>
        <translation>Jusqu’où les branches oscillent au plus, en angle autour de leur base. Avec une force négative, elles oscillent dans l’autre sens.</translation>
    </message>
    <message>
        <source>How much the maps swell and shrink at most. With a negative strength they shrink first.</source>
        <translation>De combien les applications gonflent et rétrécissent au plus. Avec une force négative, elles rétrécissent d’abord.</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Tours</translation>
    </message>
    <message>
        <source>Cycles of wave %1</source>
        <translation>Cycles de l’onde %1</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Cycles</translation>
    </message>
    <message>
        <source>How many turns it makes during the animation. A negative number turns the other way.</source>
        <translation>Combien de fois il fait le tour pendant la durée de l’animation. Un nombre négatif tourne dans l’autre sens.</translation>
    </message>
    <message>
        <source>How many times it moves back and forth during the animation.</source>
        <translation>Combien de fois il va et vient pendant la durée de l’animation.</translation>
    </message>
    <message>
        <source>Limit of the strength</source>
        <translation>Limite de l’intensité</translation>
    </message>
    <message>
        <source>Only %1 is used: with more there would be no attractor at some moment.</source>
        <translation>Seulement %1 est utilisé&#x202f;: avec plus, il n’y aurait pas d’attracteur à certains moments.</translation>
    </message>
</context>
<context>
    <name>view::MotionPage</name>
    <message>
        <source>Make Keys</source>
        <translation>Créer des clés</translation>
    </message>
    <message>
        <source>Make a first key, and show the tracks</source>
        <translation>Créer une première clé et afficher les pistes</translation>
    </message>
    <message>
        <source>Or set a key, move the playhead, and change the fractal.</source>
        <translation>Ou posez une clé, déplacez la tête de lecture et modifiez la fractale.</translation>
    </message>
    <message>
        <source>Nothing moves yet. Choose a motion:</source>
        <translation>Rien ne bouge encore. Choisissez un mouvement&#x202f;:</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Variations de «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variations</translation>
    </message>
    <message>
        <source>How strongly the variations differ</source>
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
        <source>&amp;New Set</source>
        <translation>&amp;Nouvelle série</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Une autre planche&#x202f;: la graine suivante</translation>
    </message>
    <message>
        <source>S&amp;trength:</source>
        <translation>&amp;Intensité&#x202f;:</translation>
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
        <source>The fractal in the middle replaces the one that you began with, in one step that you can undo.</source>
        <translation>La fractale du milieu remplace celle du départ, en une seule étape que vous pouvez annuler.</translation>
    </message>
    <message>
        <source>Line of descent</source>
        <translation>Lignée</translation>
    </message>
    <message>
        <source>Every parent so far, the oldest at the top. Select one to go back to it. Its descendants stay in the list until you choose another child of it.</source>
        <translation>Tous les parents jusqu’ici, le plus ancien en haut. Choisissez-en un pour y revenir. Ses descendants restent dans la liste jusqu’à ce que vous choisissiez un autre enfant.</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Line of &amp;descent</source>
        <translation>&amp;Lignée</translation>
    </message>
    <message>
        <source>How far the variations are from their parent</source>
        <translation>Distance des variations à leur parent</translation>
    </message>
    <message>
        <source>On the left, the variations stay close to their parent; on the right, they differ greatly.</source>
        <translation>À gauche, les variations restent proches de leur parent&#x202f;; à droite, elles s’en éloignent beaucoup.</translation>
    </message>
    <message>
        <source>Sha&amp;pe</source>
        <translation>&amp;Forme</translation>
    </message>
    <message>
        <source>Turn, stretch and move the maps</source>
        <translation>Tourner, étirer et déplacer les applications</translation>
    </message>
    <message>
        <source>The maps are turned, stretched and moved, and occasionally one is added or removed. Locked maps, and maps that are off, stay as they are.</source>
        <translation>Les applications sont tournées, étirées et déplacées&#x202f;; de temps en temps, l’une est ajoutée ou retirée. Celles qui sont verrouillées ou désactivées restent telles quelles.</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>&amp;Couleur</translation>
    </message>
    <message>
        <source>Try other colours</source>
        <translation>Essayer d’autres couleurs</translation>
    </message>
    <message>
        <source>The hues of the palette, the plain colour and the colours of the maps change. The background and the meaning of the colours stay the same.</source>
        <translation>La palette, la couleur unie et les couleurs des applications changent de teinte. L’arrière-plan reste, de même que ce que les couleurs représentent.</translation>
    </message>
    <message>
        <source>&amp;Weights</source>
        <translation>&amp;Poids</translation>
    </message>
    <message>
        <source>Make some maps denser and others fainter</source>
        <translation>Rendre certaines applications plus denses, d’autres plus pâles</translation>
    </message>
    <message>
        <source>The weights change at random and follow the sizes of the maps. Otherwise, each map keeps its weight. A solid in space does not depend on weights; a cloud does.</source>
        <translation>Les poids changent au hasard et suivent la taille des applications. Sinon, chaque application garde le sien. Un solide dans l’espace ne dépend pas des poids&#x202f;; un nuage, si.</translation>
    </message>
    <message>
        <source>What may change:</source>
        <translation>Ce qui peut changer&#x202f;:</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Ce fichier n’a pas d’autre fractale de cette dimension.</translation>
    </message>
    <message>
        <source>Mix the parent with another entry of this file</source>
        <translation>Mélanger le parent avec une autre entrée de ce fichier</translation>
    </message>
    <message>
        <source>The variations take some maps from the parent, some from the other entry, and some that are halfway between two corresponding maps. The checkboxes above determine whether shape, colour and weights are mixed. Every child has an attractor.</source>
        <translation>Les variations prennent certaines applications du parent, d’autres de l’autre entrée, et d’autres encore à mi-chemin entre deux qui se correspondent. Les cases ci-dessus disent si forme, couleur et poids sont mélangés. Chaque enfant a un attracteur.</translation>
    </message>
    <message>
        <source>C&amp;ross with:</source>
        <translation>C&amp;roiser avec&#x202f;:</translation>
    </message>
    <message>
        <source>The number from which the variations are generated. With the same parent, the same settings and the same seed you get the same sheet again.</source>
        <translation>Le nombre dont naissent les variations. Avec le même parent, les mêmes réglages et la même graine, vous retrouvez la même planche.</translation>
    </message>
    <message>
        <source>Shows other variations of the same parent, from the next seed.</source>
        <translation>Affiche d’autres variations du même parent, avec la graine suivante.</translation>
    </message>
    <message>
        <source>Variation %1, not ready yet</source>
        <translation>Variation %1, pas encore prête</translation>
    </message>
    <message>
        <source>Generation %1</source>
        <translation>Génération %1</translation>
    </message>
    <message>
        <source>Parent: the original</source>
        <translation>Parent&#x202f;: l’original</translation>
    </message>
    <message>
        <source>Parent: generation %1</source>
        <translation>Parent&#x202f;: génération %1</translation>
    </message>
    <message>
        <source>Nothing may change, so there are no variations. Tick at least one of the checkboxes.</source>
        <translation>Rien ne peut changer&#x202f;: il n’y a pas de variations. Cochez au moins une case.</translation>
    </message>
    <message>
        <source>All maps are locked and keep their weights: the variations differ only in colours and, occasionally, in an added map. Many look like their parent.</source>
        <translation>Toutes les applications sont verrouillées et gardent leurs poids&#x202f;: les variations ne diffèrent que par les couleurs et, de temps en temps, par une application ajoutée. Beaucoup sont semblables à leur parent.</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Utiliser celle-ci</translation>
    </message>
    <message>
        <source>Use a variation</source>
        <translation>Utiliser une variation</translation>
    </message>
    <message>
        <source>Around the picture in the middle are its variations. Click one, or press Enter on it, to put it in the middle. Double-click one to use it at once.</source>
        <translation>Autour de l’image du milieu se trouvent ses variations. Cliquez sur l’une d’elles, ou appuyez dessus sur Entrée, pour la mettre au milieu. Un double-clic l’utilise tout de suite.</translation>
    </message>
    <message>
        <source>Click a picture to put it in the middle, with variations of its own around it.</source>
        <translation>Cliquez sur une image pour la mettre au milieu, entourée de ses propres variations.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma, or an expression such as 1/2, sqrt(3)/6, cos(36°) or pi. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Un nombre, avec un point ou une virgule décimale, ou une expression comme 1/2, sqrt(3)/6, cos(36°) ou pi. Les touches fléchées et la molette le modifient&#x202f;: dix fois plus vite avec Maj, dix fois moins vite avec Alt. Échap rétablit le nombre précédent.</translation>
    </message>
    <message>
        <source>An angle in degrees, with or without °, or an expression such as 360/7. An expression with pi, or with asin, acos, atan or atan2, is in radians and becomes degrees: pi/2 is 90. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Un angle en degrés, avec ou sans °, ou une expression comme 360/7. Une expression avec pi, ou avec asin, acos, atan ou atan2, est en radians et devient des degrés&#x202f;: pi/2 est 90. Les touches fléchées et la molette le modifient&#x202f;: dix fois plus vite avec Maj, dix fois moins vite avec Alt. Échap rétablit le nombre précédent.</translation>
    </message>
    <message>
        <source>%1: the number stays as it was. %2</source>
        <translation>%1 : le nombre reste inchangé. %2</translation>
    </message>
</context>
<context>
    <name>view::OrbitRows</name>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>The axis that the camera goes round.</source>
        <translation>L’axe autour duquel tourne la caméra.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>How far the axis is tilted, like that of a globe. With 180° the camera goes round the other way.</source>
        <translation>De combien l’axe est incliné, comme celui d’un globe. À 180°, la caméra tourne dans l’autre sens.</translation>
    </message>
    <message>
        <source>Direction of the tilt</source>
        <translation>Direction de l’inclinaison</translation>
    </message>
    <message>
        <source>Where the axis is tilted to: at 0° to the next one, X to Y, Y to Z and Z to X, and at 90° to the one after that.</source>
        <translation>Vers où l’axe est incliné&#x202f;: à 0°, vers le suivant, X vers Y, Y vers Z et Z vers X, et à 90°, vers celui d’après.</translation>
    </message>
    <message>
        <source>Centre of the fractal</source>
        <translation>Centre de la fractale</translation>
    </message>
    <message>
        <source>A point</source>
        <translation>Un point</translation>
    </message>
    <message>
        <source>Middle of the view</source>
        <translation>Milieu de la vue</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivot</translation>
    </message>
    <message>
        <source>What stays in its place while everything turns.</source>
        <translation>Ce qui reste en place pendant que tout tourne.</translation>
    </message>
    <message>
        <source>%1 of the pivot</source>
        <translation>%1 du pivot</translation>
    </message>
    <message>
        <source>The point that stays in its place.</source>
        <translation>Le point qui reste en place.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
</context>
<context>
    <name>view::PaletteBrowser</name>
    <message>
        <source>Palettes</source>
        <translation>Palettes</translation>
    </message>
    <message>
        <source>&amp;Use This Palette</source>
        <translation>&amp;Utiliser cette palette</translation>
    </message>
    <message>
        <source>Search palettes</source>
        <translation>Rechercher des palettes</translation>
    </message>
    <message>
        <source>&amp;Favourites Only</source>
        <translation>&amp;Favoris seulement</translation>
    </message>
    <message>
        <source>Shows only the palettes that you marked with the star.</source>
        <translation>N’affiche que les palettes marquées de l’étoile.</translation>
    </message>
    <message>
        <source>Palettes made in Oklab, whose steps look equally large. Select one to see it on the fractal; double-click it to keep it.</source>
        <translation>Palettes construites dans Oklab, dont les pas paraissent égaux. Sélectionnez-en une pour la voir sur la fractale&#x202f;; un double-clic la conserve.</translation>
    </message>
    <message>
        <source>The palette as it will be used</source>
        <translation>La palette telle qu’elle sera utilisée</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favori</translation>
    </message>
    <message>
        <source>Mark the selected palette as a favourite (Ctrl+D)</source>
        <translation>Marquer la palette sélectionnée comme favori (Ctrl+D)</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Teinte</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>&amp;Reversed</source>
        <translation>&amp;Inversée</translation>
    </message>
    <message>
        <source>%1, a favourite</source>
        <translation>%1, un favori</translation>
    </message>
    <message>
        <source>No favourites yet. Select a palette and press Ctrl+D.</source>
        <translation>Pas encore de favoris. Sélectionnez une palette et appuyez sur Ctrl+D.</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Aucun résultat</translation>
    </message>
    <message>
        <source>Rotate all hues by this many degrees; the lightness stays the same</source>
        <translation>Tourner toutes les teintes de ce nombre de degrés&#x202f;; la clarté reste la même</translation>
    </message>
    <message>
        <source>Start farther along the palette; the part before moves to the end</source>
        <translation>Commencer plus loin dans la palette&#x202f;; la partie qui précède passe à la fin</translation>
    </message>
    <message>
        <source>All palettes: search them, mark favourites, and adjust the one that is selected.</source>
        <translation>Toutes les palettes&#x202f;: cherchez-les, marquez des favorites et ajustez celle qui est sélectionnée.</translation>
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
        <source>The rows do not say which column is which, and programs differ. Choose the order that gives the picture you expect in the background.</source>
        <translation>Les lignes ne disent pas à quoi correspond chaque colonne, et les programmes diffèrent. Choisissez l’ordre pour lequel l’image derrière ce dialogue est celle que vous attendez.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Les applications telles qu’elles seront collées</translation>
    </message>
    <message>
        <source>The maps in the chosen order: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
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
        <source>C&amp;olumns:</source>
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
        <source>In this order these maps do not contract: %1. The columns may have a different meaning.</source>
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
    <message>
        <source>&amp;Keep as It Is</source>
        <translation>&amp;Laisser ainsi</translation>
    </message>
</context>
<context>
    <name>view::PicturePaletteDialog</name>
    <message>
        <source>Palette from Picture</source>
        <translation>Palette d’une image</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>How many colours the palette has</source>
        <translation>Nombre de couleurs de la palette</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it.</source>
        <translation>Tracez une ligne pour ne prendre que les couleurs le long de celle-ci.</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Couleurs&#x202f;:</translation>
    </message>
    <message>
        <source>Makes a palette of the colours of a picture, or of those along a line in it.</source>
        <translation>Crée une palette avec les couleurs d’une image, ou avec celles le long d’une ligne.</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>Restart to change the language.</source>
        <translation>Redémarrez pour changer de langue.</translation>
    </message>
    <message>
        <source>Re&amp;open last files on startup</source>
        <translation>R&amp;ouvrir les derniers fichiers au démarrage</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Réglage du système</translation>
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
        <source>The colours of windows and panels. The picture keeps its own colours.</source>
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
        <source>The number of points drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Combien de points sont dessinés tant que rien ne bouge. Davantage de points donnent une image plus lisse et occupent le processeur plus longtemps.</translation>
    </message>
    <message>
        <source>When this is on, Barycage reopens the files that were open when you closed it, each in its own window.</source>
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
        <source>Not saved yet: %1.</source>
        <translation>Pas encore enregistré&#x202f;: %1.</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Plateau tournant</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>How a drag turns a solid. On a turntable, vertical lines stay vertical. A trackball turns freely about the axes of the screen, even over the poles; to level the view again, look along an axis.</source>
        <translation>Comment un solide tourne quand on le fait glisser. Sur un plateau tournant, ce qui est vertical le reste. Un trackball tourne librement autour des axes de l’écran, même au-delà des pôles&#x202f;; pour remettre la vue d’aplomb, regardez le long d’un axe.</translation>
    </message>
    <message>
        <source>Restart &amp;Now</source>
        <translation>Re&amp;démarrer maintenant</translation>
    </message>
    <message>
        <source>Closes all windows, asking about unsaved changes first, and opens the same files again in the new language.</source>
        <translation>Ferme toutes les fenêtres, demande d’abord que faire des modifications non enregistrées et rouvre les mêmes fichiers dans la nouvelle langue.</translation>
    </message>
    <message>
        <source>&amp;Keep the previous version of files</source>
        <translation>&amp;Conserver la version précédente des fichiers</translation>
    </message>
    <message>
        <source>When this is on, the first time that you save a file after opening it, the version before stays beside it under the same name with “~” behind it, such as maple.ifs~.</source>
        <translation>Si cette option est active, au premier enregistrement d’un fichier après son ouverture, la version précédente reste à côté sous le même nom suivi de «&#x202f;~&#x202f;», par exemple maple.ifs~.</translation>
    </message>
    <message>
        <source>Play when opened</source>
        <translation>Lire à l’ouverture</translation>
    </message>
    <message>
        <source>Still until played</source>
        <translation>Immobile jusqu’à la lecture</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Whether an entry that moves plays as soon as it is opened. When your desktop asks for less motion, the system default shows a still picture until you press Play.</source>
        <translation>Si une entrée qui bouge est lue dès son ouverture. Quand votre bureau demande moins de mouvement, le réglage du système montre une image immobile jusqu’à ce que vous appuyiez sur Lecture.</translation>
    </message>
    <message>
        <source>&amp;Motion:</source>
        <translation>&amp;Mouvement&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Général</translation>
    </message>
    <message>
        <source>S&amp;hortcuts</source>
        <translation>&amp;Raccourcis</translation>
    </message>
    <message>
        <source>Resets every setting on this page to its default.</source>
        <translation>Rétablit les valeurs par défaut de tous les réglages de cette page.</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Image au repos</translation>
    </message>
    <message>
        <source>Solids turn like</source>
        <translation>Les solides tournent comme</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>&amp;Image au repos&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Solids turn like:</source>
        <translation>Les &amp;solides tournent comme&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Names under the symbols of the toolbar</source>
        <translation>&amp;Noms sous les symboles de la barre d’outils</translation>
    </message>
    <message>
        <source>When this is on, the toolbar shows the name of each command under its symbol.</source>
        <translation>Si cette case est cochée, la barre d’outils montre le nom de chaque commande sous son symbole.</translation>
    </message>
    <message>
        <source>The settings of windows and pictures, the commands of the toolbar, and the keys of commands.</source>
        <translation>Les réglages des fenêtres et des images, les commandes de la barre d’outils et les touches des commandes.</translation>
    </message>
    <message>
        <source>Tool&amp;bar</source>
        <translation>Barre d’o&amp;utils</translation>
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
        <source>Problem</source>
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
        <source>Select a line to show its entry.</source>
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
        <source>Text that could not be read is kept unchanged.</source>
        <translation>Ce qui n’a pas pu être lu est conservé tel quel.</translation>
    </message>
    <message>
        <source>No problems: every entry was read.</source>
        <translation>Aucun problème&#x202f;: toutes les entrées ont été lues.</translation>
    </message>
    <message>
        <source>The problems found while reading the file, with line and column. Double-click a line to go to its entry.</source>
        <translation>Les problèmes trouvés à la lecture du fichier, avec la ligne et la colonne. Double-cliquez sur une ligne pour aller à son entrée.</translation>
    </message>
</context>
<context>
    <name>view::RandomDialog</name>
    <message>
        <source>Random Fractals</source>
        <translation>Fractales au hasard</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>&amp;Ajouter au fichier</translation>
    </message>
    <message>
        <source>Adds the selected one as an entry of its own, in one step that you can undo.</source>
        <translation>Ajoute celle qui est choisie comme entrée à part, en une seule étape que vous pouvez annuler.</translation>
    </message>
    <message>
        <source>Random fractals</source>
        <translation>Fractales au hasard</translation>
    </message>
    <message>
        <source>Select one and confirm, or double-click it: it is added to the file, in one step that you can undo.</source>
        <translation>Choisissez-en une et confirmez, ou double-cliquez dessus&#x202f;: elle est ajoutée au fichier, en une seule étape que vous pouvez annuler.</translation>
    </message>
    <message>
        <source>In the plane</source>
        <translation>Dans le plan</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Dans l’espace</translation>
    </message>
    <message>
        <source>Plane or space</source>
        <translation>Plan ou espace</translation>
    </message>
    <message>
        <source>Make systems in the plane or in space</source>
        <translation>Créer des systèmes dans le plan ou dans l’espace</translation>
    </message>
    <message>
        <source>In the plane, the contraction of the maps follows a rule that makes the fractal fill its view. In space there is no such rule: the two larger scale factors of each map follow that of the plane, and the third is smaller.</source>
        <translation>Dans le plan, la contraction des applications suit une règle selon laquelle la fractale remplit sa vue. Dans l’espace, il n’y a pas de telle règle&#x202f;: les deux plus grands étirements de chaque application suivent celle du plan, et le troisième est plus petit.</translation>
    </message>
    <message>
        <source>How many maps the systems have</source>
        <translation>Nombre d’applications des systèmes</translation>
    </message>
    <message>
        <source>How many maps each system lists. With a symmetry, each of them also acts rotated or mirrored.</source>
        <translation>Nombre d’applications dans la liste de chaque système. Avec une symétrie, chacune agit aussi tournée ou réfléchie.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Make systems that are symmetric about the origin</source>
        <translation>Créer des systèmes symétriques autour de l’origine</translation>
    </message>
    <message>
        <source>Each map also acts rotated or mirrored about the origin, so the fractal is symmetric. You can change the symmetry later in the Maps panel. The tetrahedral, octahedral and icosahedral groups exist in space only.</source>
        <translation>Chaque application agit aussi tournée ou réfléchie autour de l’origine, si bien que la fractale est symétrique. Vous pourrez changer la symétrie dans le panneau Applications. Les groupes tétraédrique, octaédrique et icosaédrique n’existent que dans l’espace.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Ordre de la symétrie</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Nombre de répétitions de la fractale en un tour complet</translation>
    </message>
    <message>
        <source>A rotation of order 5 repeats the fractal five times in a full turn.</source>
        <translation>Une rotation d’ordre 5 répète la fractale cinq fois en un tour complet.</translation>
    </message>
    <message>
        <source>&amp;Maps:</source>
        <translation>A&amp;pplications&#x202f;:</translation>
    </message>
    <message>
        <source>S&amp;ymmetry:</source>
        <translation>S&amp;ymétrie&#x202f;:</translation>
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
        <source>The number from which the systems are generated. With the same settings and the same seed you get the same sheet again.</source>
        <translation>Le nombre dont naissent les systèmes. Avec les mêmes réglages et la même graine, vous retrouvez la même planche.</translation>
    </message>
    <message>
        <source>&amp;New Set</source>
        <translation>&amp;Nouvelle série</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Une autre planche&#x202f;: la graine suivante</translation>
    </message>
    <message>
        <source>Shows other systems of the same kind, from the next seed.</source>
        <translation>Affiche d’autres systèmes du même genre, avec la graine suivante.</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Graine&#x202f;:</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Quelconques</translation>
    </message>
    <message>
        <source>Fractal %1</source>
        <translation>Fractale %1</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Ajouter une fractale aléatoire</translation>
    </message>
</context>
<context>
    <name>view::SaveViewDialog</name>
    <message>
        <source>Save View</source>
        <translation>Enregistrer la vue</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Nom de la vue</translation>
    </message>
    <message>
        <source>The name under which the view is listed in View, Saved Views, beside the zoom and in the export dialogs.</source>
        <translation>Le nom sous lequel la vue figure dans «&#x202f;Affichage&#x202f;», «&#x202f;Vues enregistrées&#x202f;», à côté du zoom et dans les dialogues d’exportation.</translation>
    </message>
    <message>
        <source>&amp;Name of the view:</source>
        <translation>&amp;Nom de la vue&#x202f;:</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>A fractal can have at most %1 saved views. Delete one first.</source>
        <translation>Une fractale peut avoir au plus %1 vues enregistrées. Supprimez-en d’abord une.</translation>
    </message>
    <message>
        <source>Replaces the view of this name.</source>
        <translation>Remplace la vue de ce nom.</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Sera enregistrée sous «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Keeps the view with the fractal: one step of the history. A view of the same name is replaced.</source>
        <translation>Garde la vue avec la fractale&#x202f;: une étape de l’historique. Une vue du même nom est remplacée.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
</context>
<context>
    <name>view::SavedViewsDialog</name>
    <message>
        <source>Saved Views</source>
        <translation>Vues enregistrées</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>Vues enregistrées</translation>
    </message>
    <message>
        <source>The views of this fractal. Double-click one to go to it, press F2 to rename it.</source>
        <translation>Les vues de cette fractale. Double-cliquez sur l’une d’elles pour y aller, appuyez sur F2 pour la renommer.</translation>
    </message>
    <message>
        <source>&amp;Go To</source>
        <translation>&amp;Aller à</translation>
    </message>
    <message>
        <source>Shows this view on the canvas.</source>
        <translation>Montre cette vue sur le canevas.</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Mettre à jour</translation>
    </message>
    <message>
        <source>Replaces it by the current view of the canvas.</source>
        <translation>La remplace par ce que montre maintenant le canevas.</translation>
    </message>
    <message>
        <source>Update the view “%1”</source>
        <translation>Mettre à jour la vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>Gives the view another name.</source>
        <translation>Donne un autre nom à la vue.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Deletes the view; the fractal stays as it is.</source>
        <translation>Supprime la vue&#x202f;; la fractale reste comme elle est.</translation>
    </message>
    <message>
        <source>Delete the view “%1”</source>
        <translation>Supprimer la vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Rename the view “%1” to “%2”</source>
        <translation>Renommer la vue «&#x202f;%1&#x202f;» en «&#x202f;%2&#x202f;»</translation>
    </message>
</context>
<context>
    <name>view::ShadowTool</name>
    <message>
        <source>Turn the shadow</source>
        <translation>Tourner l’ombre</translation>
    </message>
</context>
<context>
    <name>view::Shortcuts</name>
    <message>
        <source>“%1” is used on the canvas and in fields. Choose other keys.</source>
        <translation>«&#x202f;%1&#x202f;» sert sur le canevas et dans les champs. Choisissez d’autres touches.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>« %1 »</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsDialog</name>
    <message>
        <source>On the canvas</source>
        <translation>Sur le canevas</translation>
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
        <source>Move or scale along one axis, rotate in steps of 15°</source>
        <translation>Déplacer ou redimensionner selon un axe, tourner par pas de 15°</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Maj en glissant</translation>
    </message>
    <message>
        <source>Cancel the drag</source>
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
        <source>Shows only the lines that contain these words.</source>
        <translation>N’affiche que les lignes qui contiennent ces mots.</translation>
    </message>
    <message>
        <source>All keys and mouse gestures, and what they do.</source>
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
        <source>Select a deeper or a larger branch</source>
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
        <translation>faire glisser depuis le canevas vide&#x202f;; Maj ajoute</translation>
    </message>
    <message>
        <source>Add a map or vertex to the selection, or remove it</source>
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
        <source>Remove the last vertex while defining a triangle</source>
        <translation>Reprendre le dernier sommet pendant la définition d’un triangle</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Select another stop</source>
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
        <translation>Gauche, Droite&#x202f;; Maj ×10</translation>
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
        <source>Enter or Space, or double-click it</source>
        <translation>Entrée ou Espace, ou double-clic dessus</translation>
    </message>
    <message>
        <source>Cancel the change</source>
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
    <message>
        <source>Next or previous part of the window</source>
        <translation>Partie suivante ou précédente de la fenêtre</translation>
    </message>
    <message>
        <source>F6, Shift+F6</source>
        <translation>F6, Maj+F6</translation>
    </message>
    <message>
        <source>Play or stop the animation</source>
        <translation>Lire ou arrêter l’animation</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Move the playhead</source>
        <translation>Déplacer la tête de lecture</translation>
    </message>
    <message>
        <source>drag in the ruler, or Left, Right</source>
        <translation>faire glisser dans la règle, ou Gauche, Droite</translation>
    </message>
    <message>
        <source>Previous or next key</source>
        <translation>Clé précédente ou suivante</translation>
    </message>
    <message>
        <source>Ctrl + Left, Right</source>
        <translation>Ctrl + Gauche, Droite</translation>
    </message>
    <message>
        <source>First or last frame</source>
        <translation>Première ou dernière image</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Début, Fin</translation>
    </message>
    <message>
        <source>Select another row</source>
        <translation>Sélectionner une autre ligne</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Haut, Bas</translation>
    </message>
    <message>
        <source>Make or delete the key of the row</source>
        <translation>Créer ou supprimer la clé de la ligne</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Move the selected keys</source>
        <translation>Déplacer les clés sélectionnées</translation>
    </message>
    <message>
        <source>drag them</source>
        <translation>les faire glisser</translation>
    </message>
    <message>
        <source>Move all later keys of the row, too</source>
        <translation>Déplacer aussi toutes les clés suivantes de la ligne</translation>
    </message>
    <message>
        <source>Alt while dragging</source>
        <translation>Alt en faisant glisser</translation>
    </message>
    <message>
        <source>Copy the keys</source>
        <translation>Copier les clés</translation>
    </message>
    <message>
        <source>Ctrl while dragging</source>
        <translation>Ctrl en faisant glisser</translation>
    </message>
    <message>
        <source>Copy, paste, select all keys</source>
        <translation>Copier, coller, sélectionner toutes les clés</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V, Ctrl+A</source>
        <translation>Ctrl+C, Ctrl+V, Ctrl+A</translation>
    </message>
    <message>
        <source>Delete the selected keys, or the motion</source>
        <translation>Supprimer les clés sélectionnées ou le mouvement</translation>
    </message>
    <message>
        <source>Choose how a key leads to the next</source>
        <translation>Choisir comment une clé mène à la suivante</translation>
    </message>
    <message>
        <source>right-click it</source>
        <translation>clic droit dessus</translation>
    </message>
    <message>
        <source>Zoom the ruler</source>
        <translation>Agrandir la règle</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + molette</translation>
    </message>
    <message>
        <source>In the timeline</source>
        <translation>Dans la chronologie</translation>
    </message>
    <message>
        <source>In the table of maps</source>
        <translation>Dans le tableau des applications</translation>
    </message>
    <message>
        <source>Show one map alone, or all of them again</source>
        <translation>Afficher une application seule, ou de nouveau toutes</translation>
    </message>
    <message>
        <source>Alt + click on its eye</source>
        <translation>Alt + clic sur son œil</translation>
    </message>
    <message>
        <source>Rotate the view</source>
        <translation>Faire pivoter la vue</translation>
    </message>
    <message>
        <source>Ctrl + Shift + wheel</source>
        <translation>Ctrl + Maj + molette</translation>
    </message>
    <message>
        <source>Change the stop colour</source>
        <translation>Changer la couleur du repère</translation>
    </message>
    <message>
        <source>Ball of axes, after the last handle: choose an end</source>
        <translation>Boule des axes, après la dernière poignée&#x202f;: choisir une extrémité</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>touches fléchées</translation>
    </message>
    <message>
        <source>Ball of axes: look along the axis, then from behind</source>
        <translation>Boule des axes&#x202f;: regarder le long de l’axe, puis de derrière</translation>
    </message>
    <message>
        <source>Enter or Space</source>
        <translation>Entrée ou Espace</translation>
    </message>
    <message>
        <source>Ball of axes: turn the view, return to the canvas</source>
        <translation>Boule des axes&#x202f;: tourner la vue, revenir au canevas</translation>
    </message>
    <message>
        <source>Shift + arrow keys, Esc</source>
        <translation>Maj + touches fléchées, Échap</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsPage</name>
    <message>
        <source>&amp;Default</source>
        <translation>Par &amp;défaut</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>É&amp;changer</translation>
    </message>
    <message>
        <source>Find a command or keys</source>
        <translation>Chercher une commande ou des touches</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>&amp;Shortcut:</source>
        <translation>Racco&amp;urci&#x202f;:</translation>
    </message>
    <message>
        <source>Press the keys that the selected command is to have. Tab goes on to the next field.</source>
        <translation>Appuyez sur les touches que la commande choisie doit avoir. Tab passe au champ suivant.</translation>
    </message>
    <message>
        <source>Takes the keys from the selected command.</source>
        <translation>Retire les touches de la commande choisie.</translation>
    </message>
    <message>
        <source>Gives the selected command the keys that it has without your choice.</source>
        <translation>Rend à la commande choisie ses touches d’origine.</translation>
    </message>
    <message>
        <source>Gives these keys to the selected command, and its present ones to the other.</source>
        <translation>Donne ces touches à la commande choisie, et à l’autre celles qu’elle avait.</translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”.</source>
        <translation>«&#x202f;%1&#x202f;» appartient à «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” has no keys now.</source>
        <translation>«&#x202f;%1&#x202f;» n’a plus de touches.</translation>
    </message>
    <message>
        <source>“%1” has “%2” now.</source>
        <translation>«&#x202f;%1&#x202f;» a maintenant «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>&amp;Effacer</translation>
    </message>
    <message>
        <source>Show only the commands whose name, synonyms or keys begin with these words.</source>
        <translation>Montre seulement les commandes dont le nom, un synonyme ou les touches commencent par ces mots.</translation>
    </message>
    <message>
        <source>The commands of the menus and their keys; your own are bold. Select one to change its keys.</source>
        <translation>Les commandes des menus et leurs touches&#x202f;; les vôtres sont en gras. Choisissez-en une pour changer ses touches.</translation>
    </message>
</context>
<context>
    <name>view::SliceRows</name>
    <message>
        <source>Slice</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Entier</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Moitié</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Position du plan</translation>
    </message>
    <message>
        <source>Thickness of the slice</source>
        <translation>Épaisseur de la tranche</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Déplacer la coupe</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Direction of the plane</source>
        <translation>Direction du plan</translation>
    </message>
    <message>
        <source>Sets the plane perpendicular to an axis or the diagonal; type any other normal in the fields below.</source>
        <translation>Place le plan en travers d’un axe ou de la diagonale&#x202f;; les champs ci-dessous acceptent toute normale.</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>En travers de X</translation>
    </message>
    <message>
        <source>Across Y</source>
        <translation>En travers de Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>En travers de Z</translation>
    </message>
    <message>
        <source>Across the diagonal</source>
        <translation>En travers de la diagonale</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Comme saisi</translation>
    </message>
    <message>
        <source>Turn the Slice</source>
        <translation>Tourner la coupe</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>x of the normal</source>
        <translation>x de la normale</translation>
    </message>
    <message>
        <source>y of the normal</source>
        <translation>y de la normale</translation>
    </message>
    <message>
        <source>z of the normal</source>
        <translation>z de la normale</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Show the Whole Solid</source>
        <translation>Afficher le solide entier</translation>
    </message>
    <message>
        <source>Cut the Solid</source>
        <translation>Couper le solide</translation>
    </message>
    <message>
        <source>Cuts the picture open by hiding everything in front of a plane, or everything outside a slice. Drag the plane by the handle at its centre.</source>
        <translation>Ouvre l’image en masquant tout ce qui est devant un plan, ou tout ce qui est hors d’une tranche. Faites glisser le plan par la poignée en son centre.</translation>
    </message>
    <message>
        <source>The direction perpendicular to the plane</source>
        <translation>La direction perpendiculaire au plan</translation>
    </message>
    <message>
        <source>Thin slice</source>
        <translation>Tranche fine</translation>
    </message>
</context>
<context>
    <name>view::SnapshotDelegate</name>
    <message>
        <source>Name of the snapshot</source>
        <translation>Nom de l’instantané</translation>
    </message>
</context>
<context>
    <name>view::SnapshotLook</name>
    <message>
        <source>There is no snapshot to compare with yet. Take one first: Edit, Take Snapshot.</source>
        <translation>Il n’y a pas encore d’instantané avec lequel comparer. Prenez-en d’abord un&#x202f;: «&#x202f;Édition&#x202f;», «&#x202f;Prendre un instantané&#x202f;».</translation>
    </message>
    <message>
        <source>Nothing has changed since “%1”.</source>
        <translation>Rien n’a changé depuis «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” cannot be compared: one is in the plane, the other in space. Click the snapshot to restore it.</source>
        <translation>«&#x202f;%1&#x202f;» ne peut pas être comparé&#x202f;: l’un est dans le plan, l’autre dans l’espace. Cliquez sur l’instantané pour le rétablir.</translation>
    </message>
    <message>
        <source>This is “%1”. Esc returns to the fractal.</source>
        <translation>Ceci est «&#x202f;%1&#x202f;». Échap revient à la fractale.</translation>
    </message>
</context>
<context>
    <name>view::Snapshots</name>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Une entrée qui n’a pas pu être lue n’a pas d’instantanés.</translation>
    </message>
    <message>
        <source>“%1” is the same as the fractal.</source>
        <translation>«&#x202f;%1&#x202f;» est déjà identique.</translation>
    </message>
    <message>
        <source>Snapshot %1</source>
        <translation>Instantané %1</translation>
    </message>
    <message>
        <source>Restore “%1”</source>
        <translation>Rétablir «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>“%1” was deleted. To bring it back, use the menu of the panel.</source>
        <translation>«&#x202f;%1&#x202f;» a été supprimé. Le menu du panneau le fait revenir.</translation>
    </message>
    <message>
        <source>Add “%1” as an entry</source>
        <translation>Ajouter «&#x202f;%1&#x202f;» comme entrée</translation>
    </message>
    <message>
        <source>Added to the file as the entry “%1”.</source>
        <translation>Ajouté au fichier sous l’entrée «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>%1 of “%2”</source>
        <comment>snapshot, entry</comment>
        <translation>%1 de «&#x202f;%2&#x202f;»</translation>
    </message>
</context>
<context>
    <name>view::SnapshotsPanel</name>
    <message>
        <source>Snapshots</source>
        <translation>Instantanés</translation>
    </message>
    <message>
        <source>Snapshots of the fractal</source>
        <translation>Instantanés de la fractale</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Restore the fractal to this snapshot.</source>
        <translation>Remettre la fractale comme elle était dans cet instantané.</translation>
    </message>
    <message>
        <source>&amp;Add as Entry</source>
        <translation>&amp;Ajouter comme entrée</translation>
    </message>
    <message>
        <source>Add the snapshot to the file as an entry of its own, after this one.</source>
        <translation>Ajouter l’instantané au fichier comme une entrée à part, après celle-ci.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>Give the snapshot another name.</source>
        <translation>Donner un autre nom à l’instantané.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete the snapshot; the fractal stays as it is.</source>
        <translation>Supprimer l’instantané&#x202f;; la fractale reste comme elle est.</translation>
    </message>
    <message>
        <source>&amp;Bring Back</source>
        <translation>Faire re&amp;venir</translation>
    </message>
    <message>
        <source>Bring back the snapshot that was deleted last.</source>
        <translation>Faire revenir le dernier instantané supprimé.</translation>
    </message>
    <message>
        <source>shown on the canvas</source>
        <translation>affiché sur le canevas</translation>
    </message>
    <message>
        <source>the one to compare with</source>
        <translation>celui avec lequel on compare</translation>
    </message>
    <message>
        <source>&amp;Bring Back “%1”</source>
        <translation>Faire re&amp;venir «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>No snapshots of this fractal yet. Press %1 to keep its state, change it, and press %2 to compare.</source>
        <translation>Pas encore d’instantané de cette fractale. Appuyez sur %1 pour garder son état, modifiez-la, puis appuyez sur %2 pour comparer.</translation>
    </message>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Une entrée qui n’a pas pu être lue n’a pas d’instantanés.</translation>
    </message>
    <message>
        <source>Click a snapshot to restore it; undo goes back. The arrow keys or a right click select the one to compare with. F2 renames it, Del deletes it.</source>
        <translation>Cliquez sur un instantané pour le rétablir&#x202f;; annuler revient en arrière. Les touches fléchées ou un clic droit sélectionnent celui avec lequel on compare. F2 le renomme, Suppr le supprime.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept. Click one to restore it, as one step of the history. The frame marks the snapshot that the canvas shows. The B marks the selected snapshot, the one to compare with: the newest, until you select another one with the arrow keys or a right click. Snapshots last until the file is closed; Add as Entry keeps one in the file.</source>
        <translation>États de cette fractale que vous avez gardés. Cliquez sur l’un d’eux pour le rétablir&#x202f;: une étape de l’historique. Celui qui est encadré est ce que montre le canevas. Celui qui porte un B est sélectionné, et c’est avec lui que l’on compare&#x202f;: le plus récent, jusqu’à ce que vous en sélectionniez un autre avec les touches fléchées ou un clic droit. Les instantanés durent jusqu’à la fermeture du fichier&#x202f;; «&#x202f;Ajouter comme entrée&#x202f;» en garde un dans le fichier.</translation>
    </message>
</context>
<context>
    <name>view::SoloMap</name>
    <message>
        <source>One map is shown alone. Choose Solo again to show all; the file does not change.</source>
        <translation>Une application est affichée seule. Choisissez de nouveau Solo pour les voir toutes&#x202f;; le fichier ne change pas.</translation>
    </message>
</context>
<context>
    <name>view::SpaceExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exporter «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>OpenSCAD program (.scad)</source>
        <translation>Programme OpenSCAD (.scad)</translation>
    </message>
    <message>
        <source>A picture as the camera shows it, a watertight mesh that contains the attractor, or the maps as a program for OpenSCAD.</source>
        <translation>Une image telle que la caméra la montre, un corps étanche qui contient l’attracteur, ou les applications sous forme de programme pour OpenSCAD.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Format&#x202f;:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Demande le nom du fichier et l’écrit.</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Taille&#x202f;:</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Dessine autant de pixels le long de chaque côté d’un pixel&#x202f;: des bords plus lisses.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>S&amp;uréchantillonnage&#x202f;:</translation>
    </message>
    <message>
        <source>Bits per channel. Depths always have 16.</source>
        <translation>Bits par canal. Les profondeurs en ont toujours 16.</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>Fond trans&amp;parent</translation>
    </message>
    <message>
        <source>Makes the surroundings of the solid transparent.</source>
        <translation>Omet ce qui entoure le solide.</translation>
    </message>
    <message>
        <source>For both eyes: two pictures side by side, or one in red and cyan.</source>
        <translation>Pour les deux yeux&#x202f;: deux images côte à côte, ou une seule en rouge et cyan.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The longest side of the mesh.</source>
        <translation>Le plus long côté du corps.</translation>
    </message>
    <message>
        <source>&amp;Longest side:</source>
        <translation>Plus &amp;long côté&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>Résolutio&amp;n&#x202f;:</translation>
    </message>
    <message>
        <source>Thinner parts are thickened to this, so that they can be printed.</source>
        <translation>Les parties plus minces sont épaissies jusque-là pour pouvoir être imprimées.</translation>
    </message>
    <message>
        <source>Smallest &amp;wall:</source>
        <translation>Pa&amp;roi minimale&#x202f;:</translation>
    </message>
    <message>
        <source>Fill closed ca&amp;vities</source>
        <translation>Remplir les ca&amp;vités fermées</translation>
    </message>
    <message>
        <source>Fills spaces that are closed off from the outside.</source>
        <translation>Remplit ce qui est isolé de l’extérieur.</translation>
    </message>
    <message>
        <source>One multmatrix for each map; open it in OpenSCAD to render it.</source>
        <translation>Un multmatrix par application&#x202f;; ouvrez-le dans OpenSCAD pour le calculer.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Depths can be written only as PNG.</source>
        <translation>Les profondeurs ne s’écrivent qu’en PNG.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the file to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Demande un nom de fichier et crée le fichier à son tour, après ceux qui attendent dans le panneau Exports. La file d’attente reprend après un redémarrage.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vue du canevas</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>La vue «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Cadrage</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Ca&amp;drage&#x202f;:</translation>
    </message>
    <message>
        <source>A closed surface around the attractor, for a printer.</source>
        <translation>Une surface fermée autour de l’attracteur, pour une imprimante.</translation>
    </message>
    <message>
        <source>The whole solid is written, not only the slice.</source>
        <translation>Le solide entier est écrit, pas seulement la coupe.</translation>
    </message>
    <message>
        <source>Voxels along the longest side: more voxels make finer steps. A solid has at most %1 million voxels and %2 million triangles.</source>
        <translation>Voxels le long du plus long côté&#x202f;: des marches plus fines, et plus nombreuses. Un solide a au plus %1 millions de voxels et %2 millions de triangles.</translation>
    </message>
    <message>
        <source>A solid has no shapes: the file contains its picture in pixels.</source>
        <translation>Un solide n’a pas de formes&#x202f;: le fichier contient son image en pixels.</translation>
    </message>
    <message>
        <source>Stere&amp;o:</source>
        <translation>Stéré&amp;o&#x202f;:</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format. It must end with one of these: %2.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» n’indique pas le format. Il doit se terminer par l’une de ces extensions&#x202f;: %2.</translation>
    </message>
    <message>
        <source>Include the ca&amp;ge</source>
        <translation>&amp;Inclure la cage</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Dessine la cage par-dessus l’image.</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>L’attracteur entier</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Ce que montre l’image&#x202f;: ce que montre le canevas, ou l’attracteur avec une petite marge, où que regarde le canevas. Les vues enregistrées sont aussi dans la liste.</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 bits par canal</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
        <translation>16 bits par canal, pour retravailler l’image</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>Profondeur de &amp;couleur&#x202f;:</translation>
    </message>
</context>
<context>
    <name>view::SpaceInput</name>
    <message>
        <source>Rotate Cage</source>
        <translation>Faire tourner la cage</translation>
    </message>
    <message>
        <source>Scale Cage</source>
        <translation>Mettre la cage à l’échelle</translation>
    </message>
    <message>
        <source>Move Vertex %1</source>
        <translation>Déplacer le sommet %1</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Déplacer la coupe</translation>
    </message>
    <message>
        <source>Move Face %1</source>
        <translation>Déplacer la face %1</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Déplacer le centre de la symétrie</translation>
    </message>
</context>
<context>
    <name>view::SpaceRows</name>
    <message>
        <source>Look</source>
        <translation>Aspect</translation>
    </message>
    <message>
        <source>A lit solid, the density of its points, or data for other programs.</source>
        <translation>Un solide éclairé, la densité de ses points, ou des nombres pour d’autres programmes.</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Pierre</translation>
    </message>
    <message>
        <source>A solid lit by a lamp that you can move</source>
        <translation>Un solide à la lumière d’une lampe que l’on peut déplacer</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Encre</translation>
    </message>
    <message>
        <source>A solid with dark creases on paper, for print</source>
        <translation>Un solide aux plis sombres sur papier, pour l’impression</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Nuage</translation>
    </message>
    <message>
        <source>The density of points, as in the plane</source>
        <translation>La densité des points, comme dans le plan</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rayons X</translation>
    </message>
    <message>
        <source>The density of points, coloured by their mean depth</source>
        <translation>La densité des points, colorée selon leur profondeur moyenne</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Near white, far black</source>
        <translation>Proche blanc, lointain noir</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>The direction of the surface as a colour, for compositing</source>
        <translation>La direction de la surface en couleur, pour le compositing</translation>
    </message>
    <message>
        <source>Look: %1</source>
        <translation>Aspect&#x202f;: %1</translation>
    </message>
    <message>
        <source>Colour of the solid by</source>
        <translation>Couleur du solide selon</translation>
    </message>
    <message>
        <source>What the colour of the surface shows.</source>
        <translation>Ce que montre la couleur de la surface.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Uni</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Une seule couleur</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Application</translation>
    </message>
    <message>
        <source>The colour of the map whose piece it is</source>
        <translation>La couleur de l’application dont c’est la pièce</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>The palette along the addresses</source>
        <translation>La palette le long des adresses</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>The palette from bottom to top</source>
        <translation>La palette de bas en haut</translation>
    </message>
    <message>
        <source>The palette from near to far</source>
        <translation>La palette du proche au lointain</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Colorer selon&#x202f;: %1</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colorer selon</translation>
    </message>
    <message>
        <source>The direction of the light as seen by the camera; in the middle, it shines from the camera.</source>
        <translation>Où se trouve la lampe vue de l’œil&#x202f;: au milieu, c’est l’œil lui-même.</translation>
    </message>
    <message>
        <source>Light: %1°, %2°</source>
        <translation>Lumière&#x202f;: %1°, %2°</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Lumière</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Brouillard</translation>
    </message>
    <message>
        <source>How fast colours fade with depth</source>
        <translation>À quelle vitesse les couleurs s’estompent avec la profondeur</translation>
    </message>
    <message>
        <source>Fog: %1</source>
        <translation>Brouillard&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>view::SpaceView</name>
    <message>
        <source>Canvas in space</source>
        <translation>Canevas dans l’espace</translation>
    </message>
    <message>
        <source>The solid and its tetrahedron. Drag a corner: X, Y or Z keeps it on an axis, with Shift in a plane, and the wheel pushes it away. Drag anywhere else to turn the view; the wheel zooms at the pointer, the middle button pans. Double-click the solid to turn about that point.</source>
        <translation>Le solide et son tétraèdre. Faites glisser un coin&#x202f;: X, Y ou Z le garde sur un axe, avec Maj dans un plan, et la molette l’éloigne. Faites glisser ailleurs pour tourner la vue&#x202f;; la molette zoome au pointeur, le bouton du milieu déplace. Double-cliquez sur le solide pour tourner autour de ce point.</translation>
    </message>
    <message>
        <source>Vertex %1 at %2, %3, %4</source>
        <translation>Sommet %1 en %2, %3, %4</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;juster à la vue</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspective</translation>
    </message>
    <message>
        <source>Look from the F&amp;ront</source>
        <translation>Regarder de f&amp;ace</translation>
    </message>
    <message>
        <source>Look from the &amp;Right</source>
        <translation>Regarder de &amp;droite</translation>
    </message>
    <message>
        <source>Look from &amp;Above</source>
        <translation>Regarder d’en &amp;haut</translation>
    </message>
    <message>
        <source>Canvas in space: %1</source>
        <translation>Zone de dessin dans l’espace&#x202f;: %1</translation>
    </message>
    <message>
        <source>Map %5, corner %1 at %2, %3, %4</source>
        <translation>Application %5, coin %1 en %2, %3, %4</translation>
    </message>
    <message>
        <source>Corner %1 of the branch at %2, %3, %4</source>
        <translation>Coin %1 de la branche en %2, %3, %4</translation>
    </message>
    <message>
        <source>Map %4, its middle at %1, %2, %3</source>
        <translation>Application %4, son milieu en %1, %2, %3</translation>
    </message>
    <message>
        <source>The middle of the branch at %1, %2, %3</source>
        <translation>Le milieu de la branche en %1, %2, %3</translation>
    </message>
    <message>
        <source>The attractor and its control tetrahedron. Tab moves from corner to corner and to the ball of axes, the arrow keys move the corner in focus or turn the view, F6 leaves the canvas.</source>
        <translation>L’attracteur et son tétraèdre de contrôle. Tab passe de coin en coin et à la boule des axes, les flèches déplacent le coin qui a le focus ou tournent la vue, F6 quitte le canevas.</translation>
    </message>
    <message>
        <source>Ball of axes, positive end of %1.</source>
        <translation>Boule des axes, extrémité positive de %1.</translation>
    </message>
    <message>
        <source>Ball of axes, negative end of %1.</source>
        <translation>Boule des axes, extrémité négative de %1.</translation>
    </message>
    <message>
        <source>The view looks from there; Enter looks from behind.</source>
        <translation>La vue regarde de là&#x202f;; Entrée regarde de derrière.</translation>
    </message>
    <message>
        <source>Enter looks from there, the arrow keys choose another end.</source>
        <translation>Entrée regarde de là, les flèches choisissent une autre extrémité.</translation>
    </message>
</context>
<context>
    <name>view::StartShapeBox</name>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Depuis</translation>
    </message>
    <message>
        <source>The Cage</source>
        <translation>La cage</translation>
    </message>
    <message>
        <source>A Square</source>
        <translation>Un carré</translation>
    </message>
    <message>
        <source>A Letter</source>
        <translation>Une lettre</translation>
    </message>
    <message>
        <source>A Picture…</source>
        <translation>Une image…</translation>
    </message>
    <message>
        <source>What the steps start from</source>
        <translation>Ce dont partent les étapes</translation>
    </message>
    <message>
        <source>What the steps start from. Whatever you choose, the images get closer to the same attractor: a square, a letter that you type, or the dark shape in a picture, each as large as the attractor.</source>
        <translation>Ce dont partent les étapes. Quel que soit votre choix, les images se rapprochent du même attracteur&#x202f;: un carré, une lettre que vous tapez ou la forme sombre d’une image, chacun aussi grand que l’attracteur.</translation>
    </message>
    <message>
        <source>Letters to start from</source>
        <translation>Lettres de départ</translation>
    </message>
    <message>
        <source>One letter, or up to three</source>
        <translation>Une lettre, ou jusqu’à trois</translation>
    </message>
    <message>
        <source>The letter that the steps start from, or up to three letters. One that is not symmetric, such as R, shows how the maps turn and reflect.</source>
        <translation>La lettre dont partent les étapes, ou jusqu’à trois lettres. Une lettre sans symétrie, comme R, montre comment les applications tournent et reflètent.</translation>
    </message>
    <message>
        <source>Choose a Picture to Start From</source>
        <translation>Choisir l’image de départ</translation>
    </message>
</context>
<context>
    <name>view::StepsBridge</name>
    <message>
        <source>The picture has no dark shape on a light background.</source>
        <translation>L’image ne contient aucune forme sombre sur fond clair.</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>L’image n’a pas pu être lue.</translation>
    </message>
</context>
<context>
    <name>view::StoringReport</name>
    <message>
        <source>The settings cannot be saved: “%1” is not writable, or the disk is full.</source>
        <translation>Les réglages ne peuvent pas être enregistrés&#x202f;: «&#x202f;%1&#x202f;» n’est pas accessible en écriture, ou le disque est plein.</translation>
    </message>
</context>
<context>
    <name>view::StretchDialog</name>
    <message>
        <source>From frame</source>
        <translation>De l’image</translation>
    </message>
    <message>
        <source>Keys up to this frame stay where they are.</source>
        <translation>Les clés jusqu’à cette image restent à leur place.</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>À l’image</translation>
    </message>
    <message>
        <source>The end of the range. Later keys keep their distance to it.</source>
        <translation>La fin de l’intervalle. Les clés suivantes gardent leur distance.</translation>
    </message>
    <message>
        <source>Ends at frame</source>
        <translation>Finit à l’image</translation>
    </message>
    <message>
        <source>Where the range ends from now on: later for slower, earlier for faster.</source>
        <translation>Où l’intervalle finit désormais&#x202f;: plus tard pour ralentir, plus tôt pour accélérer.</translation>
    </message>
    <message>
        <source>Stretch Keys</source>
        <translation>Étirer les clés</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>&amp;Stretch</source>
        <translation>&amp;Étirer</translation>
    </message>
    <message>
        <source>Moves the keys of all tracks, in one step that you can undo.</source>
        <translation>Déplace les clés de toutes les pistes, en une étape que vous pouvez annuler.</translation>
    </message>
    <message>
        <source>&amp;From frame:</source>
        <translation>&amp;De l’image&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;To frame:</source>
        <translation>À &amp;l’image&#x202f;:</translation>
    </message>
    <message>
        <source>&amp;Ends at frame:</source>
        <translation>&amp;Finit à l’image&#x202f;:</translation>
    </message>
    <message>
        <source>The range has to end after its first frame.</source>
        <translation>L’intervalle doit finir après sa première image.</translation>
    </message>
    <message>
        <source>Two keys would meet at one frame, or the animation would be too long.</source>
        <translation>Deux clés tomberaient sur une même image, ou l’animation serait trop longue.</translation>
    </message>
    <message>
        <source>Stretch keys</source>
        <translation>Étirer les clés</translation>
    </message>
</context>
<context>
    <name>view::SuggestionList</name>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n application</numerusform>
            <numerusform>%n applications</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean distance %1 px</source>
        <translation>Distance moyenne %1 px</translation>
    </message>
    <message>
        <source>Overlap %1 %</source>
        <translation>Recouvrement %1 %</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Suggestions</translation>
    </message>
    <message>
        <source>Click a suggestion to use it; undo goes back</source>
        <translation>Cliquez sur une suggestion pour l’utiliser&#x202f;; annuler revient en arrière</translation>
    </message>
    <message>
        <source>Guaranteed within %1 px</source>
        <translation>Garanti à %1 px près</translation>
    </message>
</context>
<context>
    <name>view::SymmetryRow</name>
    <message>
        <source>Symmetry</source>
        <translation>Symétrie</translation>
    </message>
    <message>
        <source>Repeat every map under a group of rotations or mirror images</source>
        <translation>Répéter chaque application sous un groupe de rotations ou de symétries miroir</translation>
    </message>
    <message>
        <source>With a symmetry, each map of the list also acts rotated or mirrored about the centre, so the fractal is symmetric. The copies are not listed; Expand lists them. On the canvas, drag the handle of the centre.</source>
        <translation>Avec une symétrie, chaque application de la liste agit aussi tournée ou réfléchie autour du centre, si bien que la fractale est symétrique. Les copies ne figurent pas dans la liste&#x202f;; «&#x202f;Développer&#x202f;» les y ajoute. Sur le canevas, faites glisser la poignée du centre.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Ordre de la symétrie</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Nombre de répétitions de la fractale en un tour complet</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Développer</translation>
    </message>
    <message>
        <source>Expand the symmetry</source>
        <translation>Développer la symétrie</translation>
    </message>
    <message>
        <source>Writes the copies that the symmetry makes into the list, as maps of their own, so that you can change them individually. The picture stays the same.</source>
        <translation>Inscrit dans la liste les copies créées par la symétrie, comme applications à part entière, pour pouvoir n’en modifier qu’une. L’image reste la même.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Centre x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Centre y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Centre z</translation>
    </message>
    <message>
        <source>Centre of the symmetry, x</source>
        <translation>Centre de la symétrie, x</translation>
    </message>
    <message>
        <source>Centre of the symmetry, y</source>
        <translation>Centre de la symétrie, y</translation>
    </message>
    <message>
        <source>Centre of the symmetry, z</source>
        <translation>Centre de la symétrie, z</translation>
    </message>
    <message>
        <source>The point that the symmetry leaves unchanged</source>
        <translation>Le point que la symétrie laisse en place</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Déplacer le centre de la symétrie</translation>
    </message>
    <message>
        <source>Angle of the mirror</source>
        <translation>Angle du miroir</translation>
    </message>
    <message>
        <source>Direction of a mirror, in degrees counter-clockwise</source>
        <translation>Direction d’un miroir, en degrés dans le sens antihoraire</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Angle °</translation>
    </message>
    <message>
        <source>Turn the mirrors of the symmetry</source>
        <translation>Tourner les miroirs de la symétrie</translation>
    </message>
    <message>
        <source>List the maps that the symmetry stands for</source>
        <translation>Lister les applications que la symétrie représente</translation>
    </message>
    <message>
        <source>Remove the symmetry</source>
        <translation>Supprimer la symétrie</translation>
    </message>
    <message>
        <source>Set the symmetry</source>
        <translation>Définir la symétrie</translation>
    </message>
</context>
<context>
    <name>view::SymmetryTool</name>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Déplacer le centre de la symétrie</translation>
    </message>
</context>
<context>
    <name>view::TargetBox</name>
    <message>
        <source>Only maps that contract give a shape to trace.</source>
        <translation>Seules des applications contractantes donnent une forme à décalquer.</translation>
    </message>
    <message>
        <source>The attractor is a single point.</source>
        <translation>L’attracteur est un point unique.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Choose the picture that the fractal should look like</source>
        <translation>Choisir l’image à laquelle la fractale doit ressembler</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>Entry of This File</source>
        <translation>Entrée de ce fichier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Use the picture on the clipboard</source>
        <translation>Utiliser l’image du presse-papiers</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Shape:</source>
        <translation>Forme&#x202f;:</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Trace the background instead</source>
        <translation>Décalquer plutôt le fond</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Seuil</translation>
    </message>
    <message>
        <source>The shade up to which a pixel belongs to the shape</source>
        <translation>La nuance jusqu’à laquelle un pixel appartient à la forme</translation>
    </message>
    <message>
        <source>Threshold:</source>
        <translation>Seuil&#x202f;:</translation>
    </message>
    <message>
        <source>Automatic threshold</source>
        <translation>Seuil automatique</translation>
    </message>
    <message>
        <source>Find the threshold that best separates dark from light (Otsu)</source>
        <translation>Séparer le sombre du clair aussi bien qu’un seuil le peut (Otsu)</translation>
    </message>
    <message>
        <source>Opacity of the target</source>
        <translation>Opacité de la cible</translation>
    </message>
    <message>
        <source>How strongly the target is shown on the canvas</source>
        <translation>Avec quelle intensité la cible apparaît sur le canevas</translation>
    </message>
    <message>
        <source>Opacity:</source>
        <translation>Opacité&#x202f;:</translation>
    </message>
    <message>
        <source>Crop to Shape</source>
        <translation>Rogner à la forme</translation>
    </message>
    <message>
        <source>Use only the part around the shape</source>
        <translation>N’utiliser que la partie autour de la forme</translation>
    </message>
    <message>
        <source>Whole Picture</source>
        <translation>Image entière</translation>
    </message>
    <message>
        <source>Use the whole picture again</source>
        <translation>Utiliser de nouveau toute l’image</translation>
    </message>
    <message>
        <source>There is no picture on the clipboard.</source>
        <translation>Le presse-papiers ne contient pas d’image.</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Image collée</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Lecture de «&#x202f;%1&#x202f;»…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>L’image n’a pas pu être lue.</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels</source>
        <translation>%1, %2 × %3 pixels</translation>
    </message>
    <message>
        <source>Choose, paste or drop a picture on the window.</source>
        <translation>Choisissez ou collez une image, ou déposez-la sur la fenêtre.</translation>
    </message>
    <message>
        <source>With these settings, the shape is empty or fills the picture.</source>
        <translation>Avec ces réglages, la forme est vide ou remplit l’image.</translation>
    </message>
    <message>
        <source>Remove the target and work without one</source>
        <translation>Retirer la cible et travailler sans elle</translation>
    </message>
    <message>
        <source>Dark pixels</source>
        <translation>Pixels sombres</translation>
    </message>
    <message>
        <source>Opaque pixels</source>
        <translation>Pixels opaques</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape</source>
        <translation>Quels pixels appartiennent à la forme</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape. Automatic takes the opaque pixels if any part of the picture is transparent, otherwise the dark ones.</source>
        <translation>Quels pixels appartiennent à la forme. En automatique, ceux qui sont opaques si l’image a de la transparence, sinon ceux qui sont sombres.</translation>
    </message>
    <message>
        <source>%1, reduced to %2 × %3 pixels</source>
        <translation>%1, réduite à %2 × %3 pixels</translation>
    </message>
    <message>
        <source>The target is not saved with the file. It is kept while the file is open.</source>
        <translation>La cible n’est pas enregistrée avec le fichier. Elle est conservée tant que le fichier est ouvert.</translation>
    </message>
    <message>
        <source>Choose a Picture</source>
        <translation>Choisir une image</translation>
    </message>
</context>
<context>
    <name>view::TargetPreview</name>
    <message>
        <source>Preview of the target</source>
        <translation>Aperçu de la cible</translation>
    </message>
    <message>
        <source>Drag a rectangle to crop the picture; double-click to use all of it</source>
        <translation>Tracez un rectangle pour rogner l’image&#x202f;; double-cliquez pour l’utiliser entière</translation>
    </message>
</context>
<context>
    <name>view::TheftExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exporter «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the picture. You can keep working in the meantime.</source>
        <translation>Demande un nom de fichier et écrit l’image. Vous pouvez continuer à travailler.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vue du canevas</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>L’attracteur entier</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Cadrage</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin.</source>
        <translation>Ce que montre l’image&#x202f;: ce que montre le canevas, ou l’attracteur avec une petite marge, où que le canevas regarde.</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>&amp;Cadrage&#x202f;:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Taille&#x202f;:</translation>
    </message>
    <message>
        <source>Export Stolen Picture</source>
        <translation>Exporter l’image volée</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>The name “%1” does not end with .png. Choose another name.</source>
        <translation>Le nom «&#x202f;%1&#x202f;» ne se termine pas par .png. Choisissez un autre nom.</translation>
    </message>
</context>
<context>
    <name>view::Timeline</name>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Orbite</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Respiration</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Cycle de palette</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Application %1</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Branche %1</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Motions need no keys. Select a track first.</source>
        <translation>Les mouvements n’ont pas besoin de clés. Sélectionnez d’abord une piste.</translation>
    </message>
    <message>
        <source>Key of %1 (frame %2)</source>
        <translation>Clé de %1 (image %2)</translation>
    </message>
    <message>
        <source>Keys of all tracks (frame %1)</source>
        <translation>Clés de toutes les pistes (image %1)</translation>
    </message>
    <message>
        <source>Delete keys</source>
        <translation>Supprimer des clés</translation>
    </message>
    <message>
        <source>Delete the motion “%1”</source>
        <translation>Supprimer le mouvement «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Copy keys</source>
        <translation>Copier des clés</translation>
    </message>
    <message>
        <source>Move keys and all later ones</source>
        <translation>Déplacer des clés et toutes les suivantes</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Déplacer des clés</translation>
    </message>
    <message>
        <source>None of these keys fits this fractal.</source>
        <translation>Aucune de ces clés ne convient à cette fractale.</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Coller des clés</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Slow Start and End</source>
        <translation>Lent au début et à la fin</translation>
    </message>
    <message>
        <source>Slow Start</source>
        <translation>Lent au début</translation>
    </message>
    <message>
        <source>Slow End</source>
        <translation>Lent à la fin</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Maintien</translation>
    </message>
    <message>
        <source>Ease to the Next Key</source>
        <translation>Transition vers la clé suivante</translation>
    </message>
    <message>
        <source>Copy Keys</source>
        <translation>Copier les clés</translation>
    </message>
    <message>
        <source>Paste Keys at the Playhead</source>
        <translation>Coller les clés à la tête de lecture</translation>
    </message>
    <message>
        <source>Delete Keys</source>
        <translation>Supprimer les clés</translation>
    </message>
    <message>
        <source>Key at the Playhead</source>
        <translation>Clé à la tête de lecture</translation>
    </message>
    <message>
        <source>Delete the Motion</source>
        <translation>Supprimer le mouvement</translation>
    </message>
    <message>
        <source>Custom…</source>
        <translation>Personnalisée…</translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) beyond the new end deleted. Undo brings them back.</source>
        <translation>
            <numerusform>%n clé au-delà de la nouvelle fin supprimée. Annuler la rétablit.</numerusform>
            <numerusform>%n clés au-delà de la nouvelle fin supprimées. Annuler les rétablit.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) not pasted: beyond the end of the animation, or of a part that this fractal does not have.</source>
        <translation>
            <numerusform>%n clé non collée&#x202f;: au-delà de la fin de l’animation, ou d’une partie que cette fractale n’a pas.</numerusform>
            <numerusform>%n clés non collées&#x202f;: au-delà de la fin de l’animation, ou d’une partie que cette fractale n’a pas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Fluide</translation>
    </message>
    <message>
        <source>Ease of keys (frame %1)</source>
        <translation>Transition de clés (image %1)</translation>
    </message>
    <message>
        <source>Ease of keys (frames %1–%2)</source>
        <translation>Transition de clés (images %1–%2)</translation>
    </message>
    <message>
        <source>Edit the Motion…</source>
        <translation>Modifier le mouvement…</translation>
    </message>
    <message>
        <source>Branch %1, inside itself</source>
        <translation>Branche %1, en elle-même</translation>
    </message>
    <message>
        <source>Stretch Keys…</source>
        <translation>Étirer les clés…</translation>
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
        <translation>Rafales</translation>
    </message>
    <message>
        <source>Storm</source>
        <translation>Tempête</translation>
    </message>
    <message>
        <source>Under Water</source>
        <translation>Sous l’eau</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Calme</translation>
    </message>
    <message>
        <source>Add Motion</source>
        <translation>Ajouter un mouvement</translation>
    </message>
    <message>
        <source>Add a motion that needs no keys, or a morph to another entry</source>
        <translation>Ajouter un mouvement sans clés, ou un morphing vers une autre entrée</translation>
    </message>
    <message>
        <source>Add &amp;Motion</source>
        <translation>Ajouter un &amp;mouvement</translation>
    </message>
    <message>
        <source>It is one step of the history.</source>
        <translation>C’est une étape de l’historique.</translation>
    </message>
    <message>
        <source>There are no maps to move.</source>
        <translation>Il n’y a pas d’applications à animer.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>All branches sway about their roots.</source>
        <translation>Toutes les branches oscillent autour de leur base.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Each map turns once in its place.</source>
        <translation>Les applications tournent une fois sur place.</translation>
    </message>
    <message>
        <source>Turn the maps</source>
        <translation>Faire tourner les applications</translation>
    </message>
    <message>
        <source>No map can turn without losing the attractor.</source>
        <translation>Aucune application ne peut tourner sans perdre l’attracteur.</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Orbite</translation>
    </message>
    <message>
        <source>The whole picture turns once.</source>
        <translation>Toute l’image fait un tour.</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Respiration</translation>
    </message>
    <message>
        <source>The maps swell and shrink.</source>
        <translation>Les applications gonflent et rétrécissent.</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Cycle de palette</translation>
    </message>
    <message>
        <source>The colours run through the palette and back.</source>
        <translation>Les couleurs parcourent la palette et reviennent.</translation>
    </message>
    <message>
        <source>Cycle the palette</source>
        <translation>Parcourir la palette</translation>
    </message>
    <message>
        <source>Zoom In Endlessly</source>
        <translation>Zoom sans fin</translation>
    </message>
    <message>
        <source>The view moves into a small copy of the whole; the last frame matches the first.</source>
        <translation>La vue plonge dans une petite copie de l’ensemble, où la dernière image est la première.</translation>
    </message>
    <message>
        <source>Zoom in endlessly</source>
        <translation>Zoomer sans fin</translation>
    </message>
    <message>
        <source>No map makes a scaled copy of the fractal that is clear of the others.</source>
        <translation>Aucune application ne fait que réduire la fractale en une copie à l’écart des autres.</translation>
    </message>
    <message>
        <source>Morph To</source>
        <translation>Morphing vers</translation>
    </message>
    <message>
        <source>The fractal becomes another entry of this file, and returns.</source>
        <translation>La fractale devient une autre entrée de ce fichier, puis revient.</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Vent&#x202f;: %1</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension</source>
        <translation>Ce fichier n’a pas d’autre fractale de cette dimension</translation>
    </message>
    <message>
        <source>Morph to %1</source>
        <translation>Morphing vers %1</translation>
    </message>
    <message>
        <source>Trying the motion…</source>
        <translation>Essai du mouvement…</translation>
    </message>
    <message>
        <source>Choose &amp;Pairs…</source>
        <translation>Choisir les &amp;paires…</translation>
    </message>
    <message>
        <source>Shows which map becomes which, and lets you pin pairs.</source>
        <translation>Montre quelle application devient laquelle et permet de fixer des paires.</translation>
    </message>
    <message>
        <source>Pairing the maps…</source>
        <translation>Appariement des applications…</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Image sans attracteur</translation>
    </message>
    <message>
        <source>Steady Sway</source>
        <translation>Balancement régulier</translation>
    </message>
</context>
<context>
    <name>view::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation>Options de l’outil</translation>
    </message>
    <message>
        <source>Drag a corner, an edge or the inside of the cage.  Ctrl rotates  ·  Alt scales  ·  Shift keeps directions  ·  double-click an edge for a new corner</source>
        <translation>Faites glisser un sommet, une arête ou l’intérieur de la cage.  Ctrl fait tourner  ·  Alt met à l’échelle  ·  Maj conserve les directions  ·  double-clic sur une arête&#x202f;: nouveau sommet</translation>
    </message>
    <message>
        <source>Click the three corners of the new triangle.  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Cliquez sur les trois coins du nouveau triangle.  Retour arrière retire le dernier point  ·  Échap annule</translation>
    </message>
    <message>
        <source>Click the four corners of the new tetrahedron, the fourth in front of the others.  The wheel pushes it away  ·  right-drag turns the view  ·  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Cliquez les quatre sommets du nouveau tétraèdre, le quatrième devant les autres.  La molette l’éloigne  ·  glisser à droite tourne la vue  ·  Retour arrière supprime le dernier point  ·  Échap annule</translation>
    </message>
    <message>
        <source>Drag a corner or a face of the cage.  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Faites glisser un coin ou une face de la cage.  X, Y, Z gardent un axe  ·  Ctrl fait tourner  ·  Alt met à l’échelle  ·  faites glisser ailleurs pour tourner la vue</translation>
    </message>
    <message>
        <source>Click a corner of a map to select it, Shift+click for more.  Drag its corners or its middle  ·  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Cliquez sur un coin d’une application pour la sélectionner, Maj+clic pour d’autres.  Faites glisser ses coins ou son milieu  ·  X, Y, Z gardent un axe  ·  Ctrl fait tourner  ·  Alt met à l’échelle  ·  faites glisser ailleurs pour tourner la vue</translation>
    </message>
    <message>
        <source>Side by side, the fractal can be turned and zoomed.  To change it, switch stereo off.</source>
        <translation>Côte à côte, la fractale peut être tournée et zoomée.  Pour la modifier, désactivez la stéréo.</translation>
    </message>
</context>
<context>
    <name>view::ToolbarPage</name>
    <message>
        <source>Move &amp;Up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>R&amp;etirer</translation>
    </message>
    <message>
        <source>Commands in the toolbar</source>
        <translation>Commandes de la barre d’outils</translation>
    </message>
    <message>
        <source>The toolbar from left to right. Drag a command to move it.</source>
        <translation>La barre d’outils de gauche à droite. Faites glisser une commande pour la déplacer.</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Choisir une commande</translation>
    </message>
    <message>
        <source>Command to add</source>
        <translation>Commande à ajouter</translation>
    </message>
    <message>
        <source>Adds a command of the menus, or a separator, after the selected one.</source>
        <translation>Ajoute une commande des menus, ou un séparateur, après celle qui est sélectionnée.</translation>
    </message>
    <message>
        <source>&amp;Add:</source>
        <translation>A&amp;jouter&#x202f;:</translation>
    </message>
    <message>
        <source>Moves the selected command towards the left end of the toolbar.</source>
        <translation>Déplace la commande sélectionnée vers l’extrémité gauche de la barre d’outils.</translation>
    </message>
    <message>
        <source>Moves the selected command towards the right end of the toolbar.</source>
        <translation>Déplace la commande sélectionnée vers l’extrémité droite de la barre d’outils.</translation>
    </message>
    <message>
        <source>Takes the selected command out of the toolbar. It stays in its menu.</source>
        <translation>Retire la commande sélectionnée de la barre d’outils. Elle reste dans son menu.</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Séparateur</translation>
    </message>
</context>
<context>
    <name>view::TrackView</name>
    <message>
        <source>Tracks and keys</source>
        <translation>Pistes et clés</translation>
    </message>
    <message>
        <source>Unit of the ruler</source>
        <translation>Unité de la règle</translation>
    </message>
    <message>
        <source>Switch the ruler between frames and seconds</source>
        <translation>Basculer la règle entre images et secondes</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Secondes</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, image %2</translation>
    </message>
    <message>
        <source>, key</source>
        <translation>, clé</translation>
    </message>
    <message>
        <source>, keys in this row: %1</source>
        <translation>, clés dans cette ligne&#x202f;: %1</translation>
    </message>
    <message>
        <source>One row for each part that can move. The diamond on the left sets a key at the playhead, or deletes it. Drag keys to move them: Alt moves all later ones too, Ctrl copies. Drag in the ruler to move the playhead, or from an empty area to select keys. Ctrl + wheel zooms. Right-click a key for its ease. Round keys are smooth: the motion runs through them without a corner. Double-click a motion to change its strength or number of turns.</source>
        <translation>Une ligne pour chaque partie qui peut bouger. Le losange devant crée une clé à la tête de lecture ou la supprime. Faites glisser des clés pour les déplacer&#x202f;: Alt déplace aussi les suivantes, Ctrl les copie. Faites glisser dans la règle pour déplacer la tête de lecture, depuis un endroit vide pour sélectionner des clés. Ctrl + molette agrandit. Clic droit sur une clé pour sa transition. Les clés rondes sont fluides&#x202f;: le mouvement les traverse sans angle. Double-cliquez sur un mouvement pour modifier sa force ou son nombre de tours.</translation>
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
        <translation>Transformer</translation>
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
        <source>Applied in this order, from top to bottom.</source>
        <translation>Effectué dans cet ordre, de haut en bas.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Reset all values to what they were when the dialog opened</source>
        <translation>Toutes les valeurs comme à l’ouverture du dialogue</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Placer l’image</translation>
    </message>
    <message>
        <source>The cage moves; the code does not change</source>
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
        <source>Fixed point</source>
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
        <source>a point of your choice</source>
        <translation>un point saisi</translation>
    </message>
    <message>
        <source>in the line at the angle (°)</source>
        <translation>par rapport à la droite d’angle °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Angle de l’axe de symétrie en degrés&#x202f;: 0 pour l’horizontale, 90 pour la verticale</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Cette entrée n’a pas d’applications du plan.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be inverted, so it cannot be written into the code. Choose other scales, or place the picture.</source>
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
        <source>The point about which the fractal is rotated, scaled and reflected; it stays where it is.</source>
        <translation>Le point autour duquel on tourne, redimensionne et réfléchit la fractale&#x202f;: il reste où il est.</translation>
    </message>
    <message>
        <source>Reflects in a line through the fixed point; the angle is measured from the x axis.</source>
        <translation>Symétrie par rapport à une droite passant par le point fixe&#x202f;; l’angle se compte depuis l’axe des x.</translation>
    </message>
    <message>
        <source>Change:</source>
        <translation>Effet&#x202f;:</translation>
    </message>
    <message>
        <source>About:</source>
        <translation>Autour de&#x202f;:</translation>
    </message>
    <message>
        <source>Reflect:</source>
        <translation>Symétrie&#x202f;:</translation>
    </message>
    <message>
        <source>Shear:</source>
        <translation>Cisaillement&#x202f;:</translation>
    </message>
    <message>
        <source>Scale:</source>
        <translation>Échelle&#x202f;:</translation>
    </message>
    <message>
        <source>Rotate °:</source>
        <translation>Rotation °&#x202f;:</translation>
    </message>
    <message>
        <source>Translate:</source>
        <translation>Translation&#x202f;:</translation>
    </message>
    <message>
        <source>the centre of the picture’s box</source>
        <translation>le centre de la boîte englobante de l’image</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Reflects, shears, scales, rotates and translates the whole fractal by numbers.</source>
        <translation>Réfléchit, cisaille, met à l’échelle, tourne et déplace toute la fractale selon des nombres.</translation>
    </message>
    <message>
        <source>z of the fixed point</source>
        <translation>z du point fixe</translation>
    </message>
    <message>
        <source>Scale in z</source>
        <translation>Échelle en z</translation>
    </message>
    <message>
        <source>Axis:</source>
        <translation>Axe&#x202f;:</translation>
    </message>
    <message>
        <source>x of the direction of the axis</source>
        <translation>x de la direction de l’axe</translation>
    </message>
    <message>
        <source>y of the direction of the axis</source>
        <translation>y de la direction de l’axe</translation>
    </message>
    <message>
        <source>z of the direction of the axis</source>
        <translation>z de la direction de l’axe</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise as seen from the tip of the axis</source>
        <translation>Rotation en degrés, dans le sens direct vu depuis la pointe de l’axe</translation>
    </message>
    <message>
        <source>Translation in z</source>
        <translation>Translation en z</translation>
    </message>
    <message>
        <source>Same in x, y and z</source>
        <translation>Identique en x, en y et en z</translation>
    </message>
    <message>
        <source>Keeps the factors in x, y and z equal.</source>
        <translation>Maintient égaux les facteurs en x, en y et en z.</translation>
    </message>
    <message>
        <source>Axis of the rotation</source>
        <translation>Axe de la rotation</translation>
    </message>
    <message>
        <source>The axis of the rotation; it passes through the fixed point.</source>
        <translation>L’axe de la rotation&#x202f;; il passe par le point fixe.</translation>
    </message>
    <message>
        <source>the x axis</source>
        <translation>l’axe x</translation>
    </message>
    <message>
        <source>the y axis</source>
        <translation>l’axe y</translation>
    </message>
    <message>
        <source>the z axis</source>
        <translation>l’axe z</translation>
    </message>
    <message>
        <source>a direction of your choice</source>
        <translation>une direction saisie</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Cette entrée n’est pas un système dans l’espace.</translation>
    </message>
    <message>
        <source>The axis has no direction.</source>
        <translation>L’axe n’a pas de direction.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so only a transformation that scales alike in all directions can be written into the code. Choose equal scales, or place the picture.</source>
        <translation>La cage courbe l’image&#x202f;; seule une transformation de même échelle dans toutes les directions peut donc être inscrite dans le code. Choisissez des échelles égales, ou placez l’image.</translation>
    </message>
</context>
<context>
    <name>view::TransformationBar</name>
    <message>
        <source>Partner</source>
        <translation>Partenaire</translation>
    </message>
    <message>
        <source>The entry on which the picture is placed</source>
        <translation>L’entrée sur laquelle l’image est posée</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>What the fractal transformation does with the picture</source>
        <translation>Ce que la transformation fractale fait de l’image</translation>
    </message>
    <message>
        <source>Fractal transformation</source>
        <translation>Transformation fractale</translation>
    </message>
    <message>
        <source>Steal Colours</source>
        <translation>Voler les couleurs</translation>
    </message>
    <message>
        <source>Transform a Picture</source>
        <translation>Transformer une image</translation>
    </message>
    <message>
        <source>Deformation Grid</source>
        <translation>Grille de déformation</translation>
    </message>
    <message>
        <source>Filter: Reduce</source>
        <translation>Filtre&#x202f;: réduire</translation>
    </message>
    <message>
        <source>Filter: Posterise</source>
        <translation>Filtre&#x202f;: postériser</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Save the stolen picture as PNG</source>
        <translation>Enregistrer l’image volée en PNG</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>The picture on the partner; you can also drop one there</source>
        <translation>L’image sur le partenaire&#x202f;; vous pouvez aussi en déposer une</translation>
    </message>
    <message>
        <source>Choose Picture…</source>
        <translation>Choisir une image…</translation>
    </message>
    <message>
        <source>Colour Wheel</source>
        <translation>Roue chromatique</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Anneaux</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Coucher de soleil</translation>
    </message>
    <message>
        <source>Starters</source>
        <translation>Amorces</translation>
    </message>
    <message>
        <source>Add two entries with the same addresses, whose parameters you can slide</source>
        <translation>Ajouter deux entrées de mêmes adresses, aux paramètres réglables</translation>
    </message>
    <message>
        <source>Triangle Family</source>
        <translation>Famille du triangle</translation>
    </message>
    <message>
        <source>Square Family</source>
        <translation>Famille du carré</translation>
    </message>
    <message>
        <source>%1 →</source>
        <translation>%1 →</translation>
    </message>
    <message>
        <source>The picture on the partner: %1</source>
        <translation>L’image sur le partenaire&#x202f;: %1</translation>
    </message>
    <message>
        <source>Find Picture…</source>
        <translation>Retrouver l’image…</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Diviser les mots</translation>
    </message>
    <message>
        <source>Choose the current location of the picture</source>
        <translation>Choisir l’image là où elle est maintenant</translation>
    </message>
    <message>
        <source>Divide maps of both entries into words until both have the same number</source>
        <translation>Diviser des applications des deux entrées en mots jusqu’à en avoir autant</translation>
    </message>
    <message>
        <source>Stained Glass</source>
        <translation>Vitrail</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Marbre</translation>
    </message>
    <message>
        <source>Tartan</source>
        <translation>Tartan</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Vagues</translation>
    </message>
    <message>
        <source>State of the fractal transformation</source>
        <translation>État de la transformation fractale</translation>
    </message>
    <message>
        <source>There is no stolen picture yet</source>
        <translation>Il n’y a pas encore d’image volée</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Empiler</translation>
    </message>
    <message>
        <source>Show the two fractals one above the other instead of side by side</source>
        <translation>Afficher les deux fractales l’une au-dessus de l’autre plutôt que côte à côte</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposer</translation>
    </message>
    <message>
        <source>Show the partner half transparent over the fractal, in the same coordinates</source>
        <translation>Afficher le partenaire à demi transparent par-dessus la fractale, dans les mêmes coordonnées</translation>
    </message>
    <message>
        <source>Embed in the File</source>
        <translation>Incorporer au fichier</translation>
    </message>
    <message>
        <source>Store the picture itself with the entry, not only its path</source>
        <translation>Enregistrer avec l’entrée l’image elle-même, pas seulement son chemin</translation>
    </message>
    <message>
        <source>Stores the picture itself with the entry, so that the file shows it wherever it goes. A picture of more than 128 KB is stored smaller. Otherwise only its path is stored.</source>
        <translation>Enregistre avec l’entrée l’image elle-même, pour que le fichier la montre où qu’il aille. Une image de plus de 128 Ko est enregistrée en plus petit. Sinon, seul son chemin est enregistré.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Réinitialiser l’ordre</translation>
    </message>
    <message>
        <source>Put the maps back in the order of their numbers</source>
        <translation>Remettre les applications dans l’ordre de leurs numéros</translation>
    </message>
    <message>
        <source>Open It</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open this picture, which is outside the folder of the file</source>
        <translation>Ouvrir cette image, qui est hors du dossier du fichier</translation>
    </message>
</context>
<context>
    <name>view::TransformationView</name>
    <message>
        <source>Canvas of the partner</source>
        <translation>Toile du partenaire</translation>
    </message>
    <message>
        <source>Choose Partner</source>
        <translation>Choisir le partenaire</translation>
    </message>
    <message>
        <source>Choose Mode</source>
        <translation>Choisir le mode</translation>
    </message>
    <message>
        <source>Choose Picture</source>
        <translation>Choisir une image</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Diviser les mots</translation>
    </message>
    <message>
        <source>There is no other entry of the plane in this file. Add one, or choose a starter.</source>
        <translation>Ce fichier n’a pas d’autre entrée du plan. Ajoutez-en une, ou choisissez une amorce.</translation>
    </message>
    <message>
        <source>The partner “%1” is not in this file. Choose another one.</source>
        <translation>Le partenaire «&#x202f;%1&#x202f;» n’est pas dans ce fichier. Choisissez-en un autre.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Add Family</source>
        <translation>Ajouter une famille</translation>
    </message>
    <message>
        <source>Points of two fractals that have the same address correspond to each other. A picture on the partner is carried over to this fractal in that way.</source>
        <translation>Les points de deux fractales qui ont la même adresse se correspondent. Une image posée sur le partenaire est ainsi reportée sur cette fractale.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Réinitialiser l’ordre</translation>
    </message>
    <message>
        <source>Reorder Overlapping Maps</source>
        <translation>Réordonner les applications</translation>
    </message>
    <message>
        <source>Do Not Embed Picture</source>
        <translation>Ne pas incorporer l’image</translation>
    </message>
    <message>
        <source>Embed Picture</source>
        <translation>Incorporer l’image</translation>
    </message>
    <message>
        <source>The file names a picture outside its folder: %1. Open it only if you trust the file.</source>
        <translation>Le fichier désigne une image hors de son dossier&#x202f;: %1. Ne l’ouvrez que si vous avez confiance en ce fichier.</translation>
    </message>
</context>
<context>
    <name>view::TransportBar</name>
    <message>
        <source>Play</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>Lire l’animation</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>The frame that is shown and edited</source>
        <translation>L’image affichée et modifiée</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>The length of the animation in frames</source>
        <translation>Nombre d’images de l’animation</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Images par seconde</translation>
    </message>
    <message>
        <source>The number of frames played per second</source>
        <translation>Nombre d’images lues par seconde</translation>
    </message>
    <message>
        <source>Previous Key</source>
        <translation>Clé précédente</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Déplacer la tête de lecture sur la clé précédente</translation>
    </message>
    <message>
        <source>Next Key</source>
        <translation>Clé suivante</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Déplacer la tête de lecture sur la clé suivante</translation>
    </message>
    <message>
        <source>Frame:</source>
        <translation>Image&#x202f;:</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>Durée&#x202f;:</translation>
    </message>
    <message>
        <source>fps:</source>
        <translation>i/s&#x202f;:</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Boucle&#x202f;:</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>What happens after the last frame</source>
        <translation>Ce qui suit la dernière image</translation>
    </message>
    <message>
        <source>Off: the animation stops at its last frame. Cycle: it starts again from frame 0. There and Back: it runs backwards to the start.</source>
        <translation>Non&#x202f;: l’animation s’arrête à sa dernière image. Cycle&#x202f;: elle recommence, et l’image de la fin est l’image 0. Aller-retour&#x202f;: elle revient en arrière jusqu’au début.</translation>
    </message>
    <message>
        <source>Off</source>
        <comment>loop</comment>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>There and Back</source>
        <translation>Aller-retour</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 i/s</translation>
    </message>
    <message>
        <source>The number of frames drawn per second during playback</source>
        <translation>Nombre d’images dessinées par seconde pendant la lecture</translation>
    </message>
    <message>
        <source>Frames per second: %1</source>
        <translation>Images par seconde&#x202f;: %1</translation>
    </message>
    <message>
        <source>Loop: %1</source>
        <translation>Boucle&#x202f;: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop at this frame</source>
        <translation>S’arrêter à cette image</translation>
    </message>
    <message>
        <source>The number of frames played per second: a number or a fraction, such as 24, 12.5 or 30000/1001. 29.97 stands for the latter, the rate of television.</source>
        <translation>Nombre d’images lues par seconde&#x202f;: un nombre ou une fraction, par exemple 24, 12.5 ou 30000/1001. 29.97 désigne cette dernière, la cadence de la télévision.</translation>
    </message>
    <message>
        <source>“%1” is not a frame rate. Enter frames per second, above 0 and at most %2, such as 24, 29.97 or 30000/1001.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une cadence d’images. Saisissez des images par seconde, plus de 0 et au plus %2, par exemple 24, 29.97 ou 30000/1001.</translation>
    </message>
    <message numerus="yes">
        <source>Length of the animation: %n frame(s)</source>
        <translation>
            <numerusform>Durée de l’animation&#x202f;: %n image</numerusform>
            <numerusform>Durée de l’animation&#x202f;: %n images</numerusform>
        </translation>
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
        <source>Problem with the numbers</source>
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
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Déplacer le sommet %1 en (%2, %3)</translation>
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
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Zoom in percent: 100 % shows a unit of the plane as 100 pixels; type another value, or choose one</source>
        <translation>Zoom en pour cent&#x202f;: à 100 %, une unité du plan occupe 100 pixels&#x202f;; saisissez une autre valeur ou choisissez-en une</translation>
    </message>
    <message>
        <source>Zoom in percent: at 100 %, one unit of the plane is 100 pixels long. Type a number, or choose a value, a saved view, or Fit, which shows the whole attractor.</source>
        <translation>Zoom en pour cent&#x202f;: à 100 %, une unité du plan occupe 100 pixels. Saisissez un nombre, ou choisissez une valeur, une vue enregistrée ou «&#x202f;Ajuster&#x202f;», qui montre tout l’attracteur.</translation>
    </message>
</context>
</TS>
