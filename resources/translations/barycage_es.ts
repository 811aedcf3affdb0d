<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AccessibleHandle</name>
    <message>
        <source>Move left</source>
        <translation>Mover a la izquierda</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>Mover a la derecha</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Mover hacia arriba</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Mover hacia abajo</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Atractor</translation>
    </message>
    <message>
        <source>A system has one attractor if some power of it contracts: then every start leads to the same set.</source>
        <translation>Un sistema tiene un único atractor si alguna de sus potencias es contractiva: entonces, se empiece por donde se empiece, se llega al mismo conjunto.</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Contracción</translation>
    </message>
    <message>
        <source>‖A‖ of each map that takes part: the most by which it stretches distances.</source>
        <translation>‖A‖ de cada aplicación que interviene: el mayor factor con que alarga las distancias.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that holds the attractor; certified.</source>
        <translation>El menor rectángulo de lados paralelos a los ejes que contiene el atractor; demostrado.</translation>
    </message>
    <message>
        <source>Canonical simplex</source>
        <translation>Símplex canónico</translation>
    </message>
    <message>
        <source>%1, leg %2, corner %3</source>
        <translation>%1, cateto %2, vértice %3</translation>
    </message>
    <message>
        <source>Similarity dimension</source>
        <translation>Dimensión de semejanza</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved exactly: the centre of mass of the picture.</source>
        <translation>Media de la medida invariante, resuelta de forma exacta: el centro de masas de la imagen.</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Covarianza</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Puntos fijos</translation>
    </message>
    <message>
        <source>The point that each map leaves where it is; it lies on the attractor.</source>
        <translation>El punto que cada aplicación deja donde está; pertenece al atractor.</translation>
    </message>
    <message>
        <source>The D with Σ sᵢᴰ = 1 over the ratios sᵢ, when all maps are similarities in some coordinates. It is the dimension of the attractor when the pieces do not overlap.</source>
        <translation>El D con Σ sᵢᴰ = 1 sobre las razones sᵢ, cuando todas las aplicaciones son semejanzas en ciertas coordenadas. Es la dimensión del atractor cuando las partes no se solapan.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Dimensión de afinidad</translation>
    </message>
    <message>
        <source>Falconer’s dimension: where the sum of the singular value functions of all words of one length neither grows nor falls, at most 2. An upper bound of the box-counting dimension, and equal to it for almost all translations when the maps contract enough.</source>
        <translation>La dimensión de Falconer: donde la suma de las funciones de valores singulares de todas las palabras de una longitud ni crece ni decrece, a lo sumo 2. Una cota superior de la dimensión por conteo de cajas, igual a ella para casi todas las traslaciones si las aplicaciones contraen lo suficiente.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Dimensión por conteo de cajas</translation>
    </message>
    <message>
        <source>Slope of the least-squares line through ln N against ln 1/ε, where N boxes of side ε meet the attractor. An estimate: it depends on the sizes counted.</source>
        <translation>Pendiente de la recta de mínimos cuadrados de ln N frente a ln 1/ε, donde N cajas de lado ε tocan el atractor. Una estimación: depende de los tamaños contados.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture spreads. The ellipse is the one on which an even mass has the same mean and covariance.</source>
        <translation>Covarianza xx, xy, yy de la medida invariante, resuelta exactamente: cuánto se extiende la imagen. La elipse es aquella en la que una masa uniforme tiene la misma media y covarianza.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that holds the attractor; certified. The signs are the directions of its legs.</source>
        <translation>El menor triángulo rectángulo isósceles con catetos paralelos a los ejes que contiene el atractor; certificado. Los signos son las direcciones de sus catetos.</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Área de la envolvente</translation>
    </message>
    <message>
        <source>Area of the convex hull: of the polygon whose vertices were found on the attractor. The hull itself is larger by at most its border times the error bound.</source>
        <translation>Área de la envolvente convexa: del polígono cuyos vértices se hallaron en el atractor. La envolvente misma es mayor a lo sumo en su borde por la cota de error.</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Vértices de la envolvente</translation>
    </message>
    <message>
        <source>Corners of the convex hull as found, each a point of the attractor. A hull with infinitely many has as many as its tolerance asks for.</source>
        <translation>Vértices de la envolvente convexa hallados, cada uno un punto del atractor. Una envolvente con infinitos tiene tantos como pide su tolerancia.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Cota de error de la envolvente</translation>
    </message>
    <message>
        <source>The attractor reaches at most this far beyond the polygon; certified.</source>
        <translation>El atractor sobresale del polígono a lo sumo esta distancia; certificado.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… y %n más</numerusform>
            <numerusform>… y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes: hyperbolic, every map contracts by %1 or less.</source>
        <translation>Sí: hiperbólico, cada aplicación contrae con factor %1 o menos.</translation>
    </message>
    <message>
        <source>Yes: eventually contractive, every word of %1 maps contracts (%2 a map).</source>
        <translation>Sí: finalmente contractivo, cada palabra de %1 aplicaciones contrae (%2 por aplicación).</translation>
    </message>
    <message>
        <source>None: the word %1 does not contract (%2 a map).</source>
        <translation>Ninguno: la palabra %1 no contrae (%2 por aplicación).</translation>
    </message>
    <message>
        <source>Undecided: no proof either way was found.</source>
        <translation>Sin decidir: no se halló prueba en ningún sentido.</translation>
    </message>
    <message>
        <source>None: no map takes part.</source>
        <translation>Ninguno: no participa ninguna aplicación.</translation>
    </message>
    <message>
        <source>None: map %1 does not contract (%2 a map).</source>
        <translation>Ninguno: la aplicación %1 no contrae (%2 por aplicación).</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Take a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Tome un fractal por sus esquinas: un editor de sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>.ifs files to open, a window each</source>
        <translation>archivos .ifs que se abren, cada uno en una ventana</translation>
    </message>
    <message>
        <source>a window with the maple, whatever was open before</source>
        <translation>una ventana con el arce, sin importar lo que estuviera abierto</translation>
    </message>
    <message>
        <source>a window that shows the collection</source>
        <translation>una ventana que muestra la colección</translation>
    </message>
    <message>
        <source>a window with fractals made by chance to pick from</source>
        <translation>una ventana con fractales al azar para elegir</translation>
    </message>
</context>
<context>
    <name>CageEdits</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Esta entrada no tiene aplicaciones del plano.</translation>
    </message>
    <message>
        <source>The cage is at rest: the code is what is displayed.</source>
        <translation>La jaula está en reposo: lo que se muestra es el código.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code has a bent picture. Choose “Affine fit” to bake what comes nearest to it.</source>
        <translation>La jaula curva la imagen, y ningún código afín tiene una imagen curvada. Elija «Ajuste afín» para incorporar lo que más se le acerca.</translation>
    </message>
    <message>
        <source>The cage is flat: no code has this picture. Open the cage first.</source>
        <translation>La jaula está aplastada: ningún código tiene esta imagen. Abra primero la jaula.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. The code stays as it is until you bake.</source>
        <translation>Mover la jaula mueve la imagen. El código queda como está hasta que usted incorpore la colocación.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can follow, and leaves it.</source>
        <translation>Mover la jaula entera reescribe el código. Mover vértices sueltos curva la imagen, lo que ningún código puede seguir, y el código no cambia.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites every coefficient of the code, and the cage rests where it is.</source>
        <translation>Mover la jaula reescribe todos los coeficientes del código, y la jaula queda en reposo donde está.</translation>
    </message>
    <message>
        <source>The cage already places the code.</source>
        <translation>La jaula ya coloca el código.</translation>
    </message>
    <message>
        <source>Only a triangle can be taken out of the code.</source>
        <translation>Solo un triángulo se puede extraer del código.</translation>
    </message>
    <message>
        <source>The cage has a notch: the picture may fold over itself there.</source>
        <translation>La jaula tiene un entrante: ahí la imagen puede plegarse sobre sí misma.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture lie over one another. Move the vertices apart to unfold it.</source>
        <translation>La jaula está plegada: hay partes de la imagen unas sobre otras. Separe los vértices para desplegarla.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to enclose.</source>
        <translation>No interviene ninguna aplicación, así que no hay nada que encerrar.</translation>
    </message>
    <message>
        <source>A bent picture cannot be held by another cage. Reset the cage, or choose “Affine fit”, first.</source>
        <translation>Una imagen curvada no se puede sujetar con otra jaula. Antes restablezca la jaula o elija «Ajuste afín».</translation>
    </message>
    <message>
        <source>The cage is flat. Open the triangle, or reset it, first.</source>
        <translation>La jaula está aplastada. Antes abra el triángulo o restablézcalo.</translation>
    </message>
    <message>
        <source>This system has no attractor that could be enclosed.</source>
        <translation>Este sistema no tiene un atractor que se pueda encerrar.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>La jaula está en reposo.</translation>
    </message>
</context>
<context>
    <name>Collection</name>
    <message>
        <source>From the paper</source>
        <translation>Del artículo</translation>
    </message>
    <message>
        <source>The two systems of E. Hadzieva and M. Shuminoska, with the coefficients as printed.</source>
        <translation>Los dos sistemas de E. Hadzieva y M. Shuminoska, con los coeficientes tal como se imprimieron.</translation>
    </message>
    <message>
        <source>Ferns</source>
        <translation>Helechos</translation>
    </message>
    <message>
        <source>Fronds: a long slow map climbs the rachis, two short ones hang the pinnae, a flat one draws the stem.</source>
        <translation>Frondes: una aplicación larga y lenta sube por el raquis, dos cortas cuelgan las pinnas y una plana traza el tallo.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Árboles</translation>
    </message>
    <message>
        <source>Trunks that fork: the whole tree stands on its own branches.</source>
        <translation>Troncos que se bifurcan: el árbol entero se sostiene sobre sus propias ramas.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Dragones</translation>
    </message>
    <message>
        <source>Folded paper curves and the fractals of two or three twisted similarities.</source>
        <translation>Curvas de papel plegado y los fractales de dos o tres semejanzas con giro.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Familia de Sierpiński</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon holds shrunken copies of itself and keeps its holes.</source>
        <translation>Triángulos y alfombras: un polígono contiene copias reducidas de sí mismo y conserva sus agujeros.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Familia de Koch</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment, and the islands they bound.</source>
        <translation>Curvas que nacen de sustituir un segmento, y las islas que delimitan.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Espirales</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small ones that bead its path.</source>
        <translation>Una aplicación que gira y reduce un poco, y otras pequeñas que ponen cuentas en su camino.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Hojas y flores</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are turned copies of one another.</source>
        <translation>Contornos de hojas, y flores cuyos pétalos son copias giradas unos de otros.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Teselas y reptiles</translation>
    </message>
    <message>
        <source>Sets that tile the plane: copies of themselves, rep-tiles, and the central tiles of number systems.</source>
        <translation>Conjuntos que teselan el plano: copias de sí mismos, «rep-tiles» y las teselas centrales de los sistemas de numeración.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Conjuntos de Cantor y polvo</translation>
    </message>
    <message>
        <source>Sets full of gaps at every scale: points everywhere near, hardly any of them joined.</source>
        <translation>Conjuntos llenos de huecos a toda escala: puntos cercanos por doquier, casi ninguno unido a otro.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Cristales y copos de nieve</translation>
    </message>
    <message>
        <source>Sets with the symmetry of frost: five, six and more arms.</source>
        <translation>Conjuntos con la simetría de la escarcha: cinco, seis y más brazos.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Curvas y gráficas</translation>
    </message>
    <message>
        <source>Graphs of strange functions, smooth curves as attractors, space-filling coordinates.</source>
        <translation>Gráficas de funciones extrañas, curvas suaves como atractores, coordenadas de curvas que llenan el plano.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Abstractos</translation>
    </message>
    <message>
        <source>Affine patterns without a name in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Motivos afines sin nombre en la naturaleza: parientes del triángulo de Sierpiński, tejidos, rosetones.</translation>
    </message>
</context>
<context>
    <name>ExportJob</name>
    <message>
        <source>There is not enough memory for this picture. Make it smaller, or supersample less.</source>
        <translation>No hay memoria suficiente para esta imagen. Hágala más pequeña o use menos supermuestreo.</translation>
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
            <numerusform>%n flame</numerusform>
            <numerusform>%n flames</numerusform>
        </translation>
    </message>
    <message>
        <source>In flames y grows downwards. They were turned over, so that they look here as they do in flame programs.</source>
        <translation>En los flames, y crece hacia abajo. Se han invertido para que se vean aquí como en los programas de flames.</translation>
    </message>
    <message>
        <source>Leave &amp;y as it is written</source>
        <translation>&amp;Dejar y como está escrita</translation>
    </message>
    <message>
        <source>Takes the numbers of the flames as they are in the text. The picture is then upside down.</source>
        <translation>Toma los números de los flames como están en el texto. La imagen queda entonces cabeza abajo.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Leave y as it is written</source>
        <translation>Dejar y como está escrita</translation>
    </message>
    <message>
        <source>Turn the flames over</source>
        <translation>Invertir los flames</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures that carry their fractal (*.png *.svg);;All files (*)</source>
        <translation>Colecciones de Fractint (*.ifs *.par);;Flames (*.flame *.flam3);;Tablas de números (*.csv *.tsv *.txt);;Imágenes que llevan su fractal (*.png *.svg);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation>Mostrar u ocultar el panel «%1»</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Colección</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Aplicaciones</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Take the maple by a corner and pull. Or press D and define another triangle by three clicks.</source>
        <translation>Tome el arce por una esquina y tire. O pulse D y defina otro triángulo con tres clics.</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>No se pudo abrir %1</translation>
    </message>
    <message>
        <source>Recovered %1. It is not saved yet.</source>
        <translation>Se ha recuperado %1. Aún no está guardado.</translation>
    </message>
    <message numerus="yes">
        <source>%n entries</source>
        <translation>
            <numerusform>%n entrada</numerusform>
            <numerusform>%n entradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them could not be read and are kept as they are</source>
        <translation>
            <numerusform>; %n de ellas no se pudo leer y se conserva tal cual</numerusform>
            <numerusform>; %n de ellas no se pudieron leer y se conservan tal cual</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with a remark</source>
        <translation>
            <numerusform>; %n leída con una observación</numerusform>
            <numerusform>; %n leídas con observaciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>«%1» tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation>¿Desea guardarlos?</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Modificado en el disco</translation>
    </message>
    <message>
        <source>“%1” was changed by another program since it was opened here.</source>
        <translation>Otro programa ha modificado «%1» desde que se abrió aquí.</translation>
    </message>
    <message>
        <source>Saving replaces what the other program wrote.</source>
        <translation>Al guardar se sustituye lo que escribió el otro programa.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sustituir</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>No se guardó %1</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se ha guardado %1.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs)</source>
        <translation>Colecciones de Fractint (*.ifs)</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
    <message>
        <source>Go back to “%1” as it is on disk? The changes made since then are lost.</source>
        <translation>¿Volver a «%1» tal como está en el disco? Se perderán los cambios hechos desde entonces.</translation>
    </message>
    <message>
        <source>%1 could not be read again</source>
        <translation>No se pudo volver a leer %1</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>No hay archivos recientes</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Vaciar esta lista</translation>
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
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>Start with a Sierpiński triangle</source>
        <translation>Empezar con un triángulo de Sierpiński</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Nueva &amp;ventana</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation>Abrir otra ventana</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a collection of fractals</source>
        <translation>Abrir una colección de fractales</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the file; entries not edited keep every byte</source>
        <translation>Guardar el archivo; las entradas no editadas conservan cada byte</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Save the file under another name</source>
        <translation>Guardar el archivo con otro nombre</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Rever&amp;tir</translation>
    </message>
    <message>
        <source>Go back to the file as it is on disk</source>
        <translation>Volver al archivo tal como está en el disco</translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation>Exportar &amp;imagen…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen</source>
        <translation>Exportar la imagen como PNG, SVG o PDF, con el encuadre de la pantalla</translation>
    </message>
    <message>
        <source>Export &amp;Data…</source>
        <translation>Exportar &amp;datos…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Export the maps or points as a flame, for IFStile, as a table or a point cloud</source>
        <translation>Exportar las aplicaciones o los puntos como flame, para IFStile, como tabla o como nube de puntos</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>C&amp;opiar imagen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy the picture to the clipboard</source>
        <translation>Copiar la imagen al portapapeles</translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation>La imagen está en el portapapeles.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Im&amp;primir…</translation>
    </message>
    <message>
        <source>Print the picture, its name and its coefficients</source>
        <translation>Imprimir la imagen, su nombre y sus coeficientes</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>C&amp;errar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Cerrar todas las ventanas</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Ctrl+Z</translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation>Deshacer la última edición</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
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
        <translation>Repetir la edición que se deshizo</translation>
    </message>
    <message>
        <source>&amp;Transform…</source>
        <translation>&amp;Transformar…</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Rotate, scale, shear, reflect or move the whole fractal by numbers</source>
        <translation>Girar, escalar, cizallar, reflejar o mover todo el fractal con números</translation>
    </message>
    <message>
        <source>&amp;Mutate…</source>
        <translation>&amp;Mutar…</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Pick one of many variations of this fractal</source>
        <translation>Elegir una entre muchas variaciones de este fractal</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Pick one of many fractals made by chance, and add it to the file</source>
        <translation>Elegir uno entre muchos fractales hechos al azar y añadirlo al archivo</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Preferencias…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>Language, theme, quality of the picture at rest, what is opened at the start</source>
        <translation>Idioma, tema, calidad de la imagen en reposo, qué se abre al inicio</translation>
    </message>
    <message>
        <source>&amp;Cage</source>
        <translation>&amp;Jaula</translation>
    </message>
    <message>
        <source>&amp;Drag the Cage</source>
        <translation>&amp;Arrastrar la jaula</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Take the fractal by the vertices of its control triangle</source>
        <translation>Tomar el fractal por los vértices de su triángulo de control</translation>
    </message>
    <message>
        <source>De&amp;fine Triangle</source>
        <translation>&amp;Definir el triángulo</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Define the control triangle by three clicks</source>
        <translation>Definir el triángulo de control con tres clics</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Ajustar el símplex canónico &amp;mínimo</translation>
    </message>
    <message>
        <source>Hold the attractor in the smallest isosceles right triangle around it</source>
        <translation>Sujetar el atractor con el menor triángulo rectángulo isósceles que lo rodea</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Restab&amp;lecer</translation>
    </message>
    <message>
        <source>Put the cage back to rest: the code is drawn as it is</source>
        <translation>Devolver la jaula al reposo: el código se dibuja tal como es</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Incorporar</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Make the placement part of the code: the picture stays, the coefficients change</source>
        <translation>Hacer que la colocación forme parte del código: la imagen no cambia, los coeficientes cambian</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Extraer</translation>
    </message>
    <message>
        <source>Take the placement out of the code: the picture stays, the code becomes that of the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Sacar la colocación del código: la imagen no cambia, el código pasa a ser el del triángulo (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Hacer re&amp;gular</translation>
    </message>
    <message>
        <source>Put the vertices on the regular polygon nearest to them</source>
        <translation>Llevar los vértices al polígono regular más próximo</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>&amp;Forma afín invariante…</translation>
    </message>
    <message>
        <source>Show every map as a row-stochastic matrix over the control triangle</source>
        <translation>Mostrar cada aplicación como matriz estocástica por filas sobre el triángulo de control</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Colocar</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation>Mover la jaula mueve la imagen; el código no cambia</translation>
    </message>
    <message>
        <source>Re&amp;write</source>
        <translation>Ree&amp;scribir</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Mover la jaula reescribe el código</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Ajustar la vista</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Show the whole fractal</source>
        <translation>Mostrar todo el fractal</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>A&amp;cercar</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar la vista</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>A&amp;lejar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Alejar la vista</translation>
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
        <translation>Mostrar una unidad como cien píxeles</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>C&amp;uadrícula</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Mostrar la cuadrícula</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Ejes</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Show the axes</source>
        <translation>Mostrar los ejes</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>Eje &amp;Y hacia abajo</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Let y grow downwards, as in window coordinates</source>
        <translation>Hacer que y crezca hacia abajo, como en las coordenadas de una ventana</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas but the picture</source>
        <translation>Ocultar todo lo que hay en el lienzo salvo la imagen</translation>
    </message>
    <message>
        <source>&amp;Snap To</source>
        <translation>E&amp;nganchar a</translation>
    </message>
    <message>
        <source>&amp;Vertices</source>
        <translation>&amp;Vértices</translation>
    </message>
    <message>
        <source>Let dragged vertices snap to this</source>
        <translation>Enganchar aquí los vértices que se arrastran</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneles</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>Pantalla co&amp;mpleta</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Usar toda la pantalla</translation>
    </message>
    <message>
        <source>How It Arises</source>
        <translation>Cómo surge</translation>
    </message>
    <message>
        <source>&amp;How It Arises</source>
        <translation>Cómo su&amp;rge</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor arise: by steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Ver surgir el atractor: por pasos del algoritmo determinista o con el juego del caos</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>&amp;Buscar una orden…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Find any command by typing what it does</source>
        <translation>Encontrar cualquier orden escribiendo lo que hace</translation>
    </message>
    <message>
        <source>&amp;Keyboard and Mouse…</source>
        <translation>&amp;Teclado y ratón…</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Every shortcut and gesture</source>
        <translation>Todos los atajos y gestos</translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation>&amp;Guía del usuario</translation>
    </message>
    <message>
        <source>Read the user guide</source>
        <translation>Leer la guía del usuario</translation>
    </message>
    <message>
        <source>&amp;About Barycage</source>
        <translation>&amp;Acerca de Barycage</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Versión y licencia</translation>
    </message>
    <message>
        <source>About Barycage</source>
        <translation>Acerca de Barycage</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Take a fractal by its corners: an editor for iterated function systems whose attractors are held in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Tome un fractal por sus esquinas: un editor de sistemas de funciones iteradas cuyos atractores se sujetan con las coordenadas baricéntricas de un triángulo de control.&lt;/p&gt;&lt;p&gt;Según E. Hadzieva y M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Licencia MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Acerca de &amp;Qt</translation>
    </message>
    <message>
        <source>The toolkit this program is built with</source>
        <translation>La biblioteca con la que está hecho este programa</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>The fractals of the open file. The one chosen here is in the picture.</source>
        <translation>Los fractales del archivo abierto. El que se elige aquí es el que aparece en la imagen.</translation>
    </message>
    <message>
        <source>Fractals to begin with, by theme, and your own folders of them.</source>
        <translation>Fractales para empezar, por temas, y las carpetas de fractales de usted.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map in a row.</source>
        <translation>Las aplicaciones del fractal: su código, una aplicación por fila.</translation>
    </message>
    <message>
        <source>The control cage by numbers: where its vertices are, where they are at rest, what moving them does, and other cages to choose from.</source>
        <translation>La jaula de control en números: dónde están sus vértices, dónde están en reposo, qué efecto tiene moverlos y otras jaulas entre las que elegir.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Colores, brillo y fondo de la imagen. Se guardan con el fractal.</translation>
    </message>
    <message>
        <source>What mathematics knows of this fractal. Point at a name to read what it means.</source>
        <translation>Lo que las matemáticas saben de este fractal. Señale un nombre para leer qué significa.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Choose one to go back to it, or forward.</source>
        <translation>Cada paso desde que se abrió el archivo. Elija uno para volver a él o para avanzar hasta él.</translation>
    </message>
    <message>
        <source>What was odd in the file, with line and column. It is kept as it is.</source>
        <translation>Lo que extrañaba en el archivo, con línea y columna. Se conserva tal cual.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Recorrido</translation>
    </message>
    <message>
        <source>Six short steps in this window: contraction, fixed point, chaos game, address, barycentric coordinates, dimension</source>
        <translation>Seis pasos breves en esta ventana: contracción, punto fijo, juego del caos, dirección, coordenadas baricéntricas, dimensión</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>¿Qué es &amp;esto?</translation>
    </message>
    <message>
        <source>Click anything to read what it is for</source>
        <translation>Hacer clic en cualquier cosa para leer para qué sirve</translation>
    </message>
    <message>
        <source>No recovery</source>
        <translation>Sin recuperación</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Permitir sistemas &amp;sin atractor</translation>
    </message>
    <message>
        <source>Let maps be dragged to where they no longer contract; otherwise the drag stops there</source>
        <translation>Dejar arrastrar las aplicaciones hasta donde ya no contraen; si no, el arrastre se detiene ahí</translation>
    </message>
    <message>
        <source>Drag t&amp;he Maps</source>
        <translation>Arrastrar las a&amp;plicaciones</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Show the maps as images of the cage and take them by their corners</source>
        <translation>Mostrar las aplicaciones como imágenes de la jaula y tomarlas por sus esquinas</translation>
    </message>
    <message>
        <source>Drag a Bra&amp;nch</source>
        <translation>Arrastrar una &amp;rama</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Click a point of the attractor and take the branch that it belongs to</source>
        <translation>Pulsar en un punto del atractor y tomar la rama a la que pertenece</translation>
    </message>
    <message>
        <source>Maps and Branches</source>
        <translation>Aplicaciones y ramas</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>P&amp;egar</translation>
    </message>
    <message>
        <source>Add the fractals on the clipboard to the file: entries of an .ifs file, flames or a table of numbers</source>
        <translation>Añadir al archivo los fractales del portapapeles: entradas de un archivo .ifs, flames o una tabla de números</translation>
    </message>
    <message>
        <source>The unsaved work is here all the same.</source>
        <translation>El trabajo no guardado está aquí de todos modos.</translation>
    </message>
    <message>
        <source>%1 was not recovered. It is offered again at the next start.</source>
        <translation>%1 no se ha recuperado. Se ofrecerá de nuevo en el próximo inicio.</translation>
    </message>
    <message>
        <source>Esc brings menus and panels back.</source>
        <translation>Esc devuelve los menús y los paneles.</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>Presentac&amp;ión</translation>
    </message>
    <message>
        <source>Shift+F11</source>
        <translation>Shift+F11</translation>
    </message>
    <message>
        <source>Leave the whole screen to the canvas, as for a projector; Esc brings the rest back</source>
        <translation>Dejar toda la pantalla al lienzo, por ejemplo para un proyector; Esc devuelve lo demás</translation>
    </message>
    <message>
        <source>Add Ra&amp;ndom Fractal…</source>
        <translation>Añadir un fractal al &amp;azar…</translation>
    </message>
    <message>
        <source>Only the Pi&amp;cture</source>
        <translation>&amp;Solo la imagen</translation>
    </message>
</context>
<context>
    <name>NumberField</name>
    <message>
        <source>The number must be greater than %1.</source>
        <translation>El número debe ser mayor que %1.</translation>
    </message>
    <message>
        <source>The number must be at least %1.</source>
        <translation>El número debe ser al menos %1.</translation>
    </message>
    <message>
        <source>The number must be less than %1.</source>
        <translation>El número debe ser menor que %1.</translation>
    </message>
    <message>
        <source>The number must be at most %1.</source>
        <translation>El número debe ser a lo sumo %1.</translation>
    </message>
    <message>
        <source>A number is missing here.</source>
        <translation>Aquí falta un número.</translation>
    </message>
    <message>
        <source>“%1” is a fraction: write it as a decimal number.</source>
        <translation>«%1» es una fracción: escríbala como número decimal.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>«%1» es un número demasiado grande.</translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recuperar el trabajo sin guardar</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
    <message>
        <source>Reading “%1” was cancelled.</source>
        <translation>Se canceló la lectura de «%1».</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Guardando «%1»…</translation>
    </message>
    <message>
        <source>Saving “%1” was cancelled. The file on the disk is as it was.</source>
        <translation>Se canceló el guardado de «%1». El archivo del disco sigue como estaba.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and cannot be opened.</source>
        <translation>«%1» no es un archivo ordinario y no se puede abrir.</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Maple</source>
        <translation>Arce</translation>
    </message>
    <message>
        <source>Fern</source>
        <translation>Helecho</translation>
    </message>
    <message>
        <source>Glacier</source>
        <translation>Glaciar</translation>
    </message>
    <message>
        <source>Orchid</source>
        <translation>Orquídea</translation>
    </message>
    <message>
        <source>Aurora</source>
        <translation>Aurora</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Crepúsculo</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Cobre</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Laguna</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>Plata</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinta</translation>
    </message>
    <message>
        <source>Herbarium</source>
        <translation>Herbario</translation>
    </message>
    <message>
        <source>Sanguine</source>
        <translation>Sanguina</translation>
    </message>
    <message>
        <source>Cyanotype</source>
        <translation>Cianotipo</translation>
    </message>
</context>
<context>
    <name>PngSystem</name>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed its text.</source>
        <translation>La imagen no contiene ningún sistema: no la escribió Barycage, u otro programa eliminó su texto.</translation>
    </message>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>El sistema de la imagen ocupa más de 8 MB.</translation>
    </message>
    <message>
        <source>The file is no PNG picture, or it is damaged.</source>
        <translation>El archivo no es una imagen PNG o está dañado.</translation>
    </message>
</context>
<context>
    <name>PngWriter</name>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>No se puede escribir la imagen: %1</translation>
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
        <translation>Se ha encontrado trabajo sin guardar</translation>
    </message>
    <message>
        <source>Barycage ended last time before this work was saved:</source>
        <translation>La última vez Barycage terminó antes de que se guardara este trabajo:</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Ask Later</source>
        <translation>Preguntar después</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for recovery: the folder “%1” cannot be written to, or the disk is full. Save often.</source>
        <translation>El trabajo sin guardar no se puede conservar para recuperarlo: no se puede escribir en la carpeta «%1», o el disco está lleno. Guarde a menudo.</translation>
    </message>
    <message>
        <source>Unsaved work of last time is damaged and cannot be recovered. What is left of it lies in:</source>
        <translation>El trabajo sin guardar de la última vez está dañado y no se puede recuperar. Lo que queda de él está en:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Buscando trabajo sin guardar…</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 G points</source>
        <translation>%1 mil M de puntos</translation>
    </message>
    <message>
        <source>%1 M points</source>
        <translation>%1 M de puntos</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>hiperbólico, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 (words of %2 maps)</source>
        <translation>contractivo a la larga, γ = %1 (palabras de %2 aplicaciones)</translation>
    </message>
    <message>
        <source>no attractor: the word %1 does not contract</source>
        <translation>sin atractor: la palabra %1 no es contractiva</translation>
    </message>
    <message>
        <source>existence of an attractor undecided</source>
        <translation>la existencia de un atractor está sin decidir</translation>
    </message>
    <message>
        <source>no map takes part</source>
        <translation>no interviene ninguna aplicación</translation>
    </message>
    <message>
        <source>Pointer position</source>
        <translation>Posición del puntero</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Dictamen</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and the factor by which it contracts</source>
        <translation>Si el sistema tiene atractor, y el factor con que se contrae</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Points drawn so far and the time of the last pass</source>
        <translation>Puntos dibujados hasta ahora y duración de la última pasada</translation>
    </message>
    <message>
        <source>  barycentric (%1)</source>
        <translation>  baricéntricas (%1)</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D: todavía no se muestra</translation>
    </message>
    <message>
        <source>this entry could not be read</source>
        <translation>esta entrada no se pudo leer</translation>
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
        <translation>Coordenadas cartesianas y baricéntricas del puntero; la dirección del punto del atractor bajo él, la aplicación más externa primero, y el punto fijo de su rama</translation>
    </message>
    <message>
        <source>  address %1</source>
        <translation>  dirección %1</translation>
    </message>
    <message>
        <source>  fixed point of %1 (%2, %3)</source>
        <translation>  punto fijo de %1 (%2, %3)</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 punto</translation>
    </message>
    <message>
        <source>no attractor: map %1 does not contract</source>
        <translation>sin atractor: la aplicación %1 no es contractiva</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>El sistema de la imagen ocupa más de 8 MB.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>El sistema de la imagen está dañado.</translation>
    </message>
    <message>
        <source>The picture declares a document type, which Barycage never writes and does not read.</source>
        <translation>La imagen declara un tipo de documento, cosa que Barycage nunca escribe y no lee.</translation>
    </message>
    <message>
        <source>The file is no SVG picture, or it is damaged.</source>
        <translation>El archivo no es una imagen SVG o está dañado.</translation>
    </message>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed it.</source>
        <translation>La imagen no contiene ningún sistema: no la escribió Barycage, u otro programa lo eliminó.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a document type is not accepted in a flame file</source>
        <translation>no se admite un tipo de documento en un archivo flame</translation>
    </message>
    <message>
        <source>The XML ends here: %1.</source>
        <translation>El XML termina aquí: %1.</translation>
    </message>
    <message>
        <source>There is no flame in this file.</source>
        <translation>No hay ningún flame en este archivo.</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Dibujando la imagen…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Print “%1”</source>
        <translation>Imprimir «%1»</translation>
    </message>
    <message>
        <source>in space</source>
        <translation>en el espacio</translation>
    </message>
    <message>
        <source>no attractor</source>
        <translation>sin atractor</translation>
    </message>
    <message>
        <source>The sheet would be %1 by %2 pixels; at most %3 a side can be drawn. Take smaller tiles, or other columns.</source>
        <translation>La lámina tendría %1 por %2 píxeles; se pueden dibujar a lo sumo %3 por lado. Elija recuadros más pequeños u otro número de columnas.</translation>
    </message>
    <message>
        <source>the amount of “%1” is not a number</source>
        <translation>la cantidad de «%1» no es un número</translation>
    </message>
    <message>
        <source>it uses a variation other than linear</source>
        <translation>usa una variación distinta de «linear»</translation>
    </message>
    <message>
        <source>it acts in space (“%1”)</source>
        <translation>actúa en el espacio («%1»)</translation>
    </message>
    <message>
        <source>it uses the variation “%1”</source>
        <translation>usa la variación «%1»</translation>
    </message>
    <message>
        <source>its “coefs” are not six numbers</source>
        <translation>su «coefs» no son seis números</translation>
    </message>
    <message>
        <source>its “post” is not six numbers</source>
        <translation>su «post» no son seis números</translation>
    </message>
    <message>
        <source>its “chaos” allows some successors only, which a list of maps cannot say</source>
        <translation>su «chaos» solo permite algunos sucesores, lo que una lista de aplicaciones no puede expresar</translation>
    </message>
    <message>
        <source>it takes part without being drawn (opacity 0)</source>
        <translation>interviene sin dibujarse (opacidad 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>su peso no es un número</translation>
    </message>
    <message>
        <source>it has a final transform</source>
        <translation>tiene una transformación final</translation>
    </message>
    <message>
        <source>it adds a symmetry</source>
        <translation>añade una simetría</translation>
    </message>
    <message>
        <source>it has motion</source>
        <translation>tiene movimiento</translation>
    </message>
    <message>
        <source>it has layers</source>
        <translation>tiene capas</translation>
    </message>
    <message>
        <source>The flame “%1” is not a system of affine maps: %2.</source>
        <translation>El flame «%1» no es un sistema de aplicaciones afines: %2.</translation>
    </message>
    <message>
        <source>it has more than %1 transforms</source>
        <translation>tiene más de %1 transformaciones</translation>
    </message>
    <message>
        <source>transform %1: %2</source>
        <translation>transformación %1: %2</translation>
    </message>
    <message>
        <source>The flame “%1” has no transforms.</source>
        <translation>El flame «%1» no tiene transformaciones.</translation>
    </message>
    <message>
        <source>The entry that opens here is not closed by “}” before the next entry or the end of the file.</source>
        <translation>La entrada que se abre aquí no se cierra con «}» antes de la siguiente entrada o del final del archivo.</translation>
    </message>
    <message>
        <source>%1 more problems in this entry are not listed.</source>
        <translation>Hay %1 problemas más en esta entrada que no se enumeran.</translation>
    </message>
    <message>
        <source>The name “%1” holds a blank; Fractint takes only its first word.</source>
        <translation>El nombre «%1» contiene un espacio; Fractint toma solo la primera palabra.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint cuts it there.</source>
        <translation>El nombre «%1» tiene más de 18 bytes; Fractint lo corta ahí.</translation>
    </message>
    <message>
        <source>The opening brace stands on a line of its own; Fractint does not find this entry.</source>
        <translation>La llave de apertura está sola en una línea; Fractint no encuentra esta entrada.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>La entrada tiene más de %1 aplicaciones, que es el límite.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be read as a decimal point or between two numbers, and both give whole rows. Write decimal points and blanks.</source>
        <translation>«%1»: la coma se puede leer como signo decimal o como separador de números, y en ambos casos salen filas completas. Escriba puntos decimales y espacios.</translation>
    </message>
    <message>
        <source>“%1”: neither as a decimal point nor between two numbers does the comma give whole rows of 7 numbers (13 with “(3D)”).</source>
        <translation>«%1»: ni como signo decimal ni como separador da la coma filas completas de 7 números (13 con «(3D)»).</translation>
    </message>
    <message>
        <source>The numbers on the line of the opening brace are ignored, as Fractint ignores them.</source>
        <translation>Los números de la línea de la llave de apertura no se tienen en cuenta, igual que en Fractint.</translation>
    </message>
    <message>
        <source>“%1” is not understood by this version of Barycage; the line is kept.</source>
        <translation>Esta versión de Barycage no entiende «%1»; la línea se conserva.</translation>
    </message>
    <message>
        <source>The entry holds no numbers.</source>
        <translation>La entrada no contiene números.</translation>
    </message>
    <message>
        <source>This line has %1 numbers and the entry %2, which is no multiple of %3: a map is %3 numbers%4.</source>
        <translation>Esta línea tiene %1 números y la entrada %2, que no es múltiplo de %3: una aplicación son %3 números%4.</translation>
    </message>
    <message>
        <source> in an entry marked “(3D)”</source>
        <translation> en una entrada marcada con «(3D)»</translation>
    </message>
    <message>
        <source>“%1” is not a plain number: Fractint reads %2 and ignores the rest. Write it as one decimal number.</source>
        <translation>«%1» no es un número simple: Fractint lee %2 y omite el resto. Escríbalo como un solo número decimal.</translation>
    </message>
    <message>
        <source>“%1” is not a finite number.</source>
        <translation>«%1» no es un número finito.</translation>
    </message>
    <message>
        <source>“%1” is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>«%1» es mayor de lo que puede ser un coeficiente (3.4e38 en valor absoluto).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Write the plain “-”.</source>
        <translation>«%1» empieza con un signo menos tipográfico (U+2212). Escriba el simple «-».</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>Numbers stand on the line of the opening brace, where Fractint ignores them; they are read.</source>
        <translation>Hay números en la línea de la llave de apertura, donde Fractint los omite; aquí se leen.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads other numbers here.</source>
        <translation>Las comas se leen como signos decimales; Fractint lee aquí otros números.</translation>
    </message>
    <message>
        <source>Commas or apostrophes stand between the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Hay comas o apóstrofos entre los números; Iterated Dynamics no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each); weights are taken from the determinants. Fractint cannot read this entry.</source>
        <translation>Las aplicaciones no tienen pesos (%1 números cada una); los pesos se toman de los determinantes. Fractint no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Las filas de %1 números sin «(3D)» tras el nombre se leen como un sistema 3D; Fractint no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>The lines do not hold 7 numbers each, but all numbers together fill rows of 7 and are read so, as Fractint does. Probably the weights are missing.</source>
        <translation>Las líneas no contienen 7 números cada una, pero todos los números juntos llenan filas de 7 y así se leen, como hace Fractint. Probablemente faltan los pesos.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>La llave de cierre toca el último número; Fractint no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint cuts it there.</source>
        <translation>La línea tiene más de 200 bytes; Fractint la corta ahí.</translation>
    </message>
    <message>
        <source>A NUL byte; the rest of the line is ignored, as Fractint ignores it.</source>
        <translation>Un byte NUL; el resto de la línea se omite, como hace Fractint.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>La entrada tiene %1 aplicaciones; Fractint e Iterated Dynamics leen a lo sumo 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map counts as switched off.</source>
        <translation>El peso de la aplicación %1 es negativo; la aplicación cuenta como desactivada.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0; the map takes no part.</source>
        <translation>El peso de la aplicación %1 es 0; la aplicación no interviene.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are used in proportion; Fractint gives what is missing to the last map and cuts what is too much.</source>
        <translation>Los pesos suman %1, no 1. Se usan en proporción; Fractint da lo que falta a la última aplicación y recorta lo que sobra.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>El archivo está vacío.</translation>
    </message>
    <message>
        <source>These are Fractint parameter sets or formulas; no iterated function system is among them.</source>
        <translation>Son conjuntos de parámetros o fórmulas de Fractint; entre ellos no hay ningún sistema de funciones iteradas.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry is a name, “{”, rows of 7 numbers and “}”.</source>
        <translation>No se encontró ningún sistema de funciones iteradas: una entrada es un nombre, «{», filas de 7 números y «}».</translation>
    </message>
    <message>
        <source>The file has more than %1 entries; the rest is kept as text but not shown.</source>
        <translation>El archivo tiene más de %1 entradas; el resto se conserva como texto, pero no se muestra.</translation>
    </message>
    <message>
        <source>A block without a name is kept as text; Fractint does not list it.</source>
        <translation>Un bloque sin nombre se conserva como texto; Fractint no lo incluye en su lista.</translation>
    </message>
    <message>
        <source>Two opening braces on one line: no reader finds an entry here. The text is kept.</source>
        <translation>Dos llaves de apertura en una línea: ningún programa encuentra aquí una entrada. El texto se conserva.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>«%1» es un conjunto de parámetros o una fórmula, no un sistema de funciones iteradas; se conserva como texto.</translation>
    </message>
    <message>
        <source>The name is taken by the entry in line %1 (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>El nombre ya lo lleva la entrada de la línea %1 (Fractint compara 18 caracteres sin distinguir mayúsculas); Fractint nunca llega a esta.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint takes for a part of the first name.</source>
        <translation>El archivo empieza con una marca de orden de bytes, que Fractint toma por una parte del primer nombre.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); the entries after it are read all the same.</source>
        <translation>Fractint deja de leer en este byte (^Z); aun así se leen las entradas que siguen.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use the first 2000.</source>
        <translation>El archivo tiene %1 entradas; Fractint e Iterated Dynamics usan las primeras 2000.</translation>
    </message>
    <message>
        <source>The entry has no map that takes part and is left out.</source>
        <translation>La entrada no tiene ninguna aplicación que intervenga y se omite.</translation>
    </message>
    <message>
        <source>%1 maps that take no part are left out.</source>
        <translation>Se omiten %1 aplicaciones que no intervienen.</translation>
    </message>
    <message>
        <source>The entry is written under the name “%1”: other programs take 18 plain characters, and each name once.</source>
        <translation>La entrada se escribe con el nombre «%1»: otros programas admiten 18 caracteres simples, y cada nombre una sola vez.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>La entrada tiene %1 aplicaciones; Fractint hasta la versión 17.2 lee a lo sumo 31.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>hiperbólico, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 from words of length %2</source>
        <translation>contractivo a la larga, γ = %1 con palabras de longitud %2</translation>
    </message>
    <message>
        <source>none: a word of length %1 does not contract</source>
        <translation>ninguno: una palabra de longitud %1 no es contractiva</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>sin decidir</translation>
    </message>
    <message>
        <source>none: no map takes part</source>
        <translation>ninguno: no interviene ninguna aplicación</translation>
    </message>
    <message>
        <source>   norm %1, determinant %2</source>
        <translation>   norma %1, determinante %2</translation>
    </message>
    <message>
        <source>map %1</source>
        <translation>aplicación %1</translation>
    </message>
    <message>
        <source>attractor</source>
        <translation>atractor</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>media</translation>
    </message>
    <message>
        <source>covariance</source>
        <translation>covarianza</translation>
    </message>
    <message>
        <source>bounding box</source>
        <translation>rectángulo envolvente</translation>
    </message>
    <message>
        <source>canonical simplex</source>
        <translation>símplex canónico</translation>
    </message>
    <message>
        <source>convex hull</source>
        <translation>envolvente convexa</translation>
    </message>
    <message>
        <source>%1 vertices, %2 facets, volume %3; error at most %4</source>
        <translation>%1 vértices, %2 caras, volumen %3; error a lo sumo %4</translation>
    </message>
    <message>
        <source>similarity dimension</source>
        <translation>dimensión de semejanza</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>dimensión de afinidad</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2 maps</source>
        <translation>%1 — en el plano, %2 aplicaciones</translation>
    </message>
    <message>
        <source>%1 — in space, %2 maps</source>
        <translation>%1 — en el espacio, %2 aplicaciones</translation>
    </message>
    <message>
        <source>%1 — could not be read</source>
        <translation>%1 — no se pudo leer</translation>
    </message>
    <message>
        <source>cage at rest</source>
        <translation>jaula en reposo</translation>
    </message>
    <message>
        <source>cage now</source>
        <translation>jaula actual</translation>
    </message>
    <message>
        <source>The stored cage is not usable (its lists of vertices do not match, or its rest vertices lie on one line, cross each other or are more than 64) and is not applied.</source>
        <translation>La jaula guardada no se puede usar (sus listas de vértices no se corresponden, o sus vértices de reposo están alineados, se cruzan o son más de 64) y no se aplica.</translation>
    </message>
    <message>
        <source>The stored palette “%1” is unknown and is not applied.</source>
        <translation>La paleta guardada «%1» es desconocida y no se aplica.</translation>
    </message>
    <message>
        <source>Map %1 was switched off here, but another program has given it a weight.</source>
        <translation>La aplicación %1 se había desactivado aquí, pero otro programa le ha dado un peso.</translation>
    </message>
    <message>
        <source>A palette has at most %1 colours; the others are left out.</source>
        <translation>Una paleta tiene a lo sumo %1 colores; los demás se omiten.</translation>
    </message>
    <message>
        <source>This line is left out: three whole numbers from 0 to 255 make a colour.</source>
        <translation>Esta línea se omite: un color son tres números enteros de 0 a 255.</translation>
    </message>
    <message>
        <source>The file holds no colours.</source>
        <translation>El archivo no contiene colores.</translation>
    </message>
    <message>
        <source>The file has more than 16 MB, which no palette needs.</source>
        <translation>El archivo ocupa más de 16 MB, que ninguna paleta necesita.</translation>
    </message>
    <message>
        <source>The file is no text, so it is no palette.</source>
        <translation>El archivo no es texto, así que no es una paleta.</translation>
    </message>
    <message>
        <source>This is a GIMP gradient; palettes are read from .gpl, .ugr and .map files.</source>
        <translation>Esto es un degradado de GIMP; las paletas se leen de archivos .gpl, .ugr y .map.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the others are left out.</source>
        <translation>El archivo tiene más de %1 paletas; las demás se omiten.</translation>
    </message>
    <message>
        <source>The file holds no gradient.</source>
        <translation>El archivo no contiene ningún degradado.</translation>
    </message>
    <message>
        <source>The gradient of line %1 is not closed.</source>
        <translation>El degradado de la línea %1 no está cerrado.</translation>
    </message>
    <message>
        <source>“%1” is no whole number.</source>
        <translation>«%1» no es un número entero.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, of which alone points are written.</source>
        <translation>«%1» no es un sistema del plano, y solo de ellos se escriben los puntos.</translation>
    </message>
    <message>
        <source>“%1” has no map that takes part, so it has no points.</source>
        <translation>«%1» no tiene ninguna aplicación que intervenga, así que no tiene puntos.</translation>
    </message>
    <message>
        <source>A cage of more than three corners bends the picture, and its points are not written.</source>
        <translation>Una jaula de más de tres vértices curva la imagen, y sus puntos no se escriben.</translation>
    </message>
    <message>
        <source>A point cloud has from 1 to %1 points.</source>
        <translation>Una nube de puntos tiene de 1 a %1 puntos.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>«%1» es una carpeta. Elija un nombre de archivo.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and is not replaced. Choose another name.</source>
        <translation>«%1» no es un archivo corriente y no se sustituye. Elija otro nombre.</translation>
    </message>
    <message>
        <source>The folder “%1” does not exist. Create it, or save somewhere else.</source>
        <translation>La carpeta «%1» no existe. Créela o guarde en otro lugar.</translation>
    </message>
    <message>
        <source>“%1” is read-only. Save under another name, or change its permissions.</source>
        <translation>«%1» es de solo lectura. Guarde con otro nombre o cambie los permisos.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again; the file on the disk is as it was.</source>
        <translation>No se guardó «%1»: el disco está lleno. Libere espacio y vuelva a guardar; el archivo del disco sigue como estaba.</translation>
    </message>
    <message>
        <source>“%1” was not saved: you may not write to the folder “%2”. Save somewhere else.</source>
        <translation>No se guardó «%1»: no tiene permiso para escribir en la carpeta «%2». Guarde en otro lugar.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>No se guardó «%1»: el nombre es demasiado largo.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2. The file on the disk is as it was.</source>
        <translation>No se guardó «%1»: %2. El archivo del disco sigue como estaba.</translation>
    </message>
    <message>
        <source>The file has no name. Choose one.</source>
        <translation>El archivo no tiene nombre. Elija uno.</translation>
    </message>
    <message>
        <source>“%1” does not exist.</source>
        <translation>«%1» no existe.</translation>
    </message>
    <message>
        <source>“%1” is a folder, not a file.</source>
        <translation>«%1» es una carpeta, no un archivo.</translation>
    </message>
    <message>
        <source>“%1” is larger than 256 MB, which is the limit for a file.</source>
        <translation>«%1» ocupa más de 256 MB, que es el límite para un archivo.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>«%1» no se puede leer: %2.</translation>
    </message>
    <message>
        <source>Only plane systems can be written as a scalable picture.</source>
        <translation>Solo los sistemas del plano se pueden escribir como imagen vectorial.</translation>
    </message>
    <message>
        <source>The system has no attractor of which an outline could be certified, so there is nothing to make copies of.</source>
        <translation>El sistema no tiene un atractor cuyo contorno se pueda demostrar, así que no hay nada de lo que hacer copias.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>En esta vista la imagen es demasiado grande para escribirla como formas.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row is a b c d e f and perhaps a weight.</source>
        <translation>No hay filas de números: una fila es a b c d e f y, si acaso, un peso.</translation>
    </message>
    <message>
        <source>After the count, a map is its weight and a matrix of 3 rows.</source>
        <translation>Tras el número de aplicaciones, cada aplicación es su peso y una matriz de 3 filas.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map is 0 0 1.</source>
        <translation>La última fila de la matriz de una aplicación afín es 0 0 1.</translation>
    </message>
    <message>
        <source>The table says that it has %1 maps, and it has %2.</source>
        <translation>La tabla dice que tiene %1 aplicaciones, y tiene %2.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>El encabezado no dice qué columna es a, b, c, d, e y f; elija el orden de las columnas.</translation>
    </message>
    <message>
        <source>This row has %1 numbers; a map is 6 numbers, or 7 with its weight.</source>
        <translation>Esta fila tiene %1 números; una aplicación son 6 números, o 7 con su peso.</translation>
    </message>
    <message>
        <source>“%1” is not a decimal number.</source>
        <translation>«%1» no es un número decimal.</translation>
    </message>
    <message>
        <source>The table has more than %1 rows, which is the limit.</source>
        <translation>La tabla tiene más de %1 filas, que es el límite.</translation>
    </message>
    <message>
        <source>This is a %1 file, not a text with iterated function systems.</source>
        <translation>Esto es un archivo %1, no un texto con sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>This is a text in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
        <translation>Esto es un texto en UTF-16. Guárdelo como UTF-8 o ASCII y vuelva a abrirlo.</translation>
    </message>
    <message>
        <source>This is a list written by a Racket program (wgmitchener&apos;s IFS editor), not a Fractint collection.</source>
        <translation>Esto es una lista escrita por un programa en Racket (el editor de IFS de wgmitchener), no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is a flame file (XML), not a Fractint collection.</source>
        <translation>Esto es un archivo flame (XML), no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is an SVG picture, not a Fractint collection.</source>
        <translation>Esto es una imagen SVG, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is an XML file of an IFS program such as IFS Explorer, not a Fractint collection.</source>
        <translation>Esto es un archivo XML de un programa de IFS como IFS Explorer, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is an XML or HTML file, not a Fractint collection.</source>
        <translation>Esto es un archivo XML o HTML, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is an IFStile file (.aifs), not a Fractint collection.</source>
        <translation>Esto es un archivo de IFStile (.aifs), no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is a XaoS position file, not a Fractint collection.</source>
        <translation>Esto es un archivo de posición de XaoS, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>The lines are expressions in x and y, as pyfractal writes them, not a Fractint collection.</source>
        <translation>Las líneas son expresiones en x e y, como las que escribe pyfractal, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is a table of the program Fraktale: a count, maps with cumulative percentages and a window. It is not a Fractint collection.</source>
        <translation>Esto es una tabla del programa Fraktale: un número de aplicaciones, las aplicaciones con porcentajes acumulados y una ventana. No es una colección de Fractint.</translation>
    </message>
    <message>
        <source>This table has 5 numbers per map (scales, shifts and a rotation in pixels). It is not a Fractint collection.</source>
        <translation>Esta tabla tiene 5 números por aplicación (escalas, desplazamientos y una rotación en píxeles). No es una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is a StyrofoamIFS script, not a Fractint collection.</source>
        <translation>Esto es un guion de StyrofoamIFS, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text with iterated function systems.</source>
        <translation>Esto es un archivo binario (quizá una imagen con compresión fractal o una biblioteca de iconos), no un texto con sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and for a table of numbers the file is too large: the limit is 64 MB.</source>
        <translation>No se encontró ningún sistema de funciones iteradas, y para una tabla de números el archivo es demasiado grande: el límite es de 64 MB.</translation>
    </message>
    <message>
        <source>a number is larger than a coefficient can be (3.4e38 in size)</source>
        <translation>un número es mayor de lo que puede ser un coeficiente (3.4e38 en valor absoluto)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest is left out.</source>
        <translation>El archivo tiene más de %1 llamas; el resto se omite.</translation>
    </message>
    <message>
        <source>%1 flames in all are no systems of affine maps.</source>
        <translation>%1 llamas en total no son sistemas de aplicaciones afines.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>La entrada tiene más de %1 líneas, que es el límite; se conserva como texto.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1 vértices, %2 de ellos con direcciones periódicas, área %3; error a lo sumo %4</translation>
    </message>
    <message>
        <source>deformation</source>
        <translation>deformación</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>curvatura</translation>
    </message>
    <message>
        <source>affine fit</source>
        <translation>ajuste afín</translation>
    </message>
    <message>
        <source>A number of this row is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>Un número de esta fila es mayor de lo que puede ser un coeficiente (3.4e38 en valor absoluto).</translation>
    </message>
    <message>
        <source>The text has more than 64 MB, which is the limit for a table of numbers.</source>
        <translation>El texto tiene más de 64 MB, que es el límite para una tabla de números.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Una etiqueta tiene más de %1 atributos, que es el límite.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 deep, which is the limit.</source>
        <translation>Los elementos están anidados a más de %1 niveles, que es el límite.</translation>
    </message>
    <message>
        <source>The file has more than 64 MB, which is the limit for XML.</source>
        <translation>El archivo tiene más de 64 MB, que es el límite para XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>rama desplazada</translation>
    </message>
    <message>
        <source>A stored place of a branch is not usable (its map is incomplete, or its address names maps that are not there, or occurs twice, or there are too many) and is not applied.</source>
        <translation>Un lugar guardado de una rama no es utilizable (su aplicación está incompleta, su dirección nombra aplicaciones que no existen o aparece dos veces, o hay demasiados) y no se aplica.</translation>
    </message>
    <message>
        <source>%1 lines of blocks that are no iterated function systems are left out.</source>
        <translation>Se omiten %1 líneas de bloques que no son sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Una celda de esta fila está vacía.</translation>
    </message>
    <message>
        <source>A comma can be read as a decimal point or between two numbers here, and both give whole rows. Write decimal points.</source>
        <translation>Aquí la coma se puede leer como signo decimal o como separador de números, y en ambos casos salen filas completas. Escriba puntos decimales.</translation>
    </message>
    <message>
        <source>The cage and the colours of the entry are left out.</source>
        <translation>Se omiten la jaula y los colores de la entrada.</translation>
    </message>
    <message>
        <source>The code is written without its cage and moved branches: other programs draw another picture.</source>
        <translation>El código se escribe sin su jaula ni sus ramas desplazadas: otros programas dibujan otra imagen.</translation>
    </message>
    <message>
        <source>The table has maps of the plane and maps of space.</source>
        <translation>La tabla tiene aplicaciones del plano y aplicaciones del espacio.</translation>
    </message>
    <message>
        <source>This is a list of other files, as the program Fraktale has one, not a Fractint collection.</source>
        <translation>Esto es una lista de otros archivos, como la del programa Fraktale, no una colección de Fractint.</translation>
    </message>
    <message>
        <source>This row has %1 numbers, and the header names %2 columns.</source>
        <translation>Esta fila tiene %1 números, y el encabezado nombra %2 columnas.</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>motivo</translation>
    </message>
    <message numerus="yes">
        <source>%n more maps</source>
        <translation>
            <numerusform>%n aplicación más</numerusform>
            <numerusform>%n aplicaciones más</numerusform>
        </translation>
    </message>
    <message>
        <source>No column is called “%1”: they are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Ninguna columna se llama «%1»: son a b c d o r s theta phi, e f, y p o cumulative.</translation>
    </message>
    <message>
        <source>“%1” is there twice.</source>
        <translation>«%1» aparece dos veces.</translation>
    </message>
    <message>
        <source>A row has one weight: p or cumulative.</source>
        <translation>Una fila tiene un solo peso: p o cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi do not go together.</source>
        <translation>a b c d y r s theta phi no van juntos.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Falta: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than programs read in one path. Choose a smaller depth.</source>
        <translation>El contorno tiene más vértices de los que los programas leen en un solo trazado. Elija una profundidad menor.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers are those of the picture at rest.</source>
        <translation>La jaula dobla o aplana la imagen. Los números son los de la imagen en reposo.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8. Please rename the file, or lead to it by a link.</source>
        <translation>El nombre «%1» no está en UTF-8. Cambie el nombre del archivo o llegue a él por un enlace.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so the weights of all maps are taken from the determinants and those that are given are not used.</source>
        <translation>La aplicación %1 no tiene peso; por eso los pesos de todas las aplicaciones se toman de los determinantes, y los indicados no se usan.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Contraction</source>
        <translation>Contracción</translation>
    </message>
    <message>
        <source>Every row of this table is a map that makes a smaller copy of the whole, and the picture is all copies together. Double-click a number and type another: the copy moves as you type. ‖A‖ is the most by which a map stretches. While it is less than 1, the map contracts. Ctrl+Z takes everything back.</source>
        <translation>Cada fila de esta tabla es una aplicación que hace una copia más pequeña del todo, y la imagen es la reunión de todas las copias. Haga doble clic en un número y escriba otro: la copia se mueve mientras usted escribe. ‖A‖ es el mayor factor con que una aplicación alarga las distancias. Mientras sea menor que 1, la aplicación es contractiva. Ctrl+Z lo deshace todo.</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Punto fijo</translation>
    </message>
    <message>
        <source>A map that contracts leaves exactly one point where it is: its fixed point. Switch off all maps but two by the boxes on the left of the table, and see how little is left of the picture. With one map alone nothing is left but its fixed point. Ctrl+Z brings the maps back.</source>
        <translation>Una aplicación contractiva deja exactamente un punto donde está: su punto fijo. Desactive todas las aplicaciones menos dos con las casillas de la izquierda de la tabla y vea qué poco queda de la imagen. Con una sola aplicación no queda más que su punto fijo. Ctrl+Z recupera las aplicaciones.</translation>
    </message>
    <message>
        <source>Chaos game</source>
        <translation>Juego del caos</translation>
    </message>
    <message>
        <source>Press Chaos Game and then the triangle that starts it. One point jumps about, each time by a map drawn at random, and leaves a dot where it lands. Let it go faster: whatever the dice say, the dots fill the same picture, the attractor.</source>
        <translation>Pulse «Juego del caos» y después el triángulo que lo pone en marcha. Un punto salta de un lado a otro, cada vez con una aplicación elegida al azar, y deja una marca donde cae. Déjelo ir más deprisa: digan lo que digan los dados, las marcas llenan siempre la misma imagen, el atractor.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>The map that made the last jump to a point, the one before it, and so on: these numbers are the address of the point. Choose Colour by: Address. Points whose addresses begin alike lie close together, and now they look alike.</source>
        <translation>La aplicación que dio el último salto hasta un punto, la que dio el anterior, y así sucesivamente: estos números son la dirección del punto. En «Colorear por» elija «Dirección». Los puntos cuyas direcciones empiezan igual están cerca unos de otros, y ahora se parecen también en el color.</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Coordenadas baricéntricas</translation>
    </message>
    <message>
        <source>Every point of the picture is a weighted mean of the three corners of the triangle. Take a corner and pull: the points keep their weights, and the whole fractal follows. Squeeze the triangle flat and open it again: nothing is lost. The weights at the pointer stand at the bottom of the window.</source>
        <translation>Cada punto de la imagen es una media ponderada de los tres vértices del triángulo. Tome un vértice y tire: los puntos conservan sus pesos, y todo el fractal los sigue. Aplaste el triángulo y vuelva a abrirlo: no se pierde nada. Los pesos del puntero se leen en la parte inferior de la ventana.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Dimensión</translation>
    </message>
    <message>
        <source>How much of the plane does the attractor fill? The dimension of a curve is 1, that of an area is 2, and most attractors lie between the two. Change a map and look here again. That was the tour; the user guide under Help tells the rest.</source>
        <translation>¿Cuánto del plano llena el atractor? La dimensión de una curva es 1, la de una superficie es 2, y la mayoría de los atractores están entre ambas. Cambie una aplicación y vuelva a mirar aquí. Este era el recorrido; lo demás lo cuenta la guía del usuario, en el menú Ayuda.</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>At&amp;rás</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>New here?</source>
        <translation>¿Es la primera vez?</translation>
    </message>
    <message>
        <source>Six short steps show what an attractor is, by pulling on one. You can take the tour later, too: it is in the Help menu.</source>
        <translation>Seis pasos breves muestran qué es un atractor, tirando de uno. También puede hacer el recorrido más tarde: está en el menú Ayuda.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>&amp;Start the Tour</source>
        <translation>Empezar el re&amp;corrido</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminar</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Siguiente</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>The last files, and the collection.</source>
        <translation>Los últimos archivos y la colección.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>Go on with</source>
        <translation>Continuar con</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>A&amp;brir…</translation>
    </message>
    <message>
        <source>A file, or the collection.</source>
        <translation>Un archivo o la colección.</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Empezar con</translation>
    </message>
    <message>
        <source>Co&amp;llection</source>
        <translation>&amp;Colección</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Takes what the dialog shows, and closes it.</source>
        <translation>Acepta lo que muestra el diálogo y lo cierra.</translation>
    </message>
    <message>
        <source>Closes the dialog and changes nothing.</source>
        <translation>Cierra el diálogo sin cambiar nada.</translation>
    </message>
    <message>
        <source>Closes the dialog.</source>
        <translation>Cierra el diálogo.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Esta entrada no tiene aplicaciones del plano.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Forma afín invariante</translation>
    </message>
    <message>
        <source>Row j of a matrix holds the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. The matrices do not change when the triangle is dragged. Where no entry is negative, the map takes the triangle into itself.</source>
        <translation>La fila j de una matriz contiene las coordenadas baricéntricas de la imagen del vértice j en el triángulo, de modo que cada fila suma 1. Las matrices no cambian cuando se arrastra el triángulo. Si ningún elemento es negativo, la aplicación lleva el triángulo dentro de sí mismo.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Every map as a matrix that takes barycentric coordinates over the control triangle to barycentric coordinates: each row has the sum 1.</source>
        <translation>Cada aplicación como matriz que lleva coordenadas baricéntricas respecto del triángulo de control a coordenadas baricéntricas: cada fila suma 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices with all digits.</source>
        <translation>Copia el triángulo y las matrices con todas las cifras.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy takes all of them.
</source>
        <translation>
… y %1 más. «Copiar» las toma todas.
</translation>
    </message>
</context>
<context>
    <name>view::AnalysisPanel</name>
    <message>
        <source>Analysis</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>Copy All</source>
        <translation>Copiar todo</translation>
    </message>
    <message>
        <source>Copy all facts with all digits</source>
        <translation>Copiar todos los datos con todas sus cifras</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D: todavía no se muestra.</translation>
    </message>
    <message>
        <source>This entry could not be read, so nothing is known of it.</source>
        <translation>Esta entrada no se pudo leer, así que nada se sabe de ella.</translation>
    </message>
    <message>
        <source>Copy with All Digits</source>
        <translation>Copiar con todas las cifras</translation>
    </message>
    <message>
        <source>Copy All Facts</source>
        <translation>Copiar todos los datos</translation>
    </message>
    <message>
        <source>Copies every line as its name and its value with all digits.</source>
        <translation>Copia cada línea como su nombre y su valor con todas las cifras.</translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation>En el lienzo</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Outline the certified bounding box</source>
        <translation>Dibujar la caja envolvente certificada</translation>
    </message>
    <message>
        <source>Hull</source>
        <translation>Envolvente</translation>
    </message>
    <message>
        <source>Outline the convex hull</source>
        <translation>Dibujar la envolvente convexa</translation>
    </message>
    <message>
        <source>Simplex</source>
        <translation>Símplex</translation>
    </message>
    <message>
        <source>Outline the minimal canonical simplex</source>
        <translation>Dibujar el símplex canónico mínimo</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Show the mean and the ellipse of the covariance</source>
        <translation>Mostrar la media y la elipse de la covarianza</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Puntos fijos</translation>
    </message>
    <message>
        <source>Mark the fixed point of each map in its colour</source>
        <translation>Marcar el punto fijo de cada aplicación en su color</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Cilindros</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with an address of the same length, in the colour of its first map</source>
        <translation>Dibujar las envolventes de todas las partes con dirección de igual longitud, en el color de su primera aplicación</translation>
    </message>
    <message>
        <source>Length of the addresses</source>
        <translation>Longitud de las direcciones</translation>
    </message>
    <message>
        <source>How many symbols the addresses of the cylinders have; fewer where there would be thousands</source>
        <translation>Cuántos símbolos tienen las direcciones de los cilindros; menos donde habría miles</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Longitud de dirección</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system has it. These are facts of the code; on the canvas they are bent with the picture.</source>
        <translation>La jaula curva la imagen, y ningún sistema la tiene. Estos son hechos del código; en el lienzo se curvan con la imagen.</translation>
    </message>
</context>
<context>
    <name>view::AppearancePanel</name>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Reset to Default</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Every setting of this panel as in a new fractal</source>
        <translation>Todos los ajustes de este panel como en un fractal nuevo</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colorear por</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>The palette follows the density of points</source>
        <translation>La paleta sigue la densidad de los puntos</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Aplicación</translation>
    </message>
    <message>
        <source>The colour of the last map applied</source>
        <translation>El color de la última aplicación aplicada</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>The palette follows the address of each point</source>
        <translation>La paleta sigue la dirección de cada punto</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Color único</translation>
    </message>
    <message>
        <source>One colour; the density is its opacity</source>
        <translation>Un solo color; la densidad es su opacidad</translation>
    </message>
    <message>
        <source>Change what the colour shows</source>
        <translation>Cambiar lo que muestra el color</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Color único</translation>
    </message>
    <message>
        <source>Change the plain colour</source>
        <translation>Cambiar el color único</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Paleta</translation>
    </message>
    <message>
        <source>Change the palette</source>
        <translation>Cambiar la paleta</translation>
    </message>
    <message>
        <source>Edit Palette</source>
        <translation>Editar la paleta</translation>
    </message>
    <message>
        <source>Edit the palette, or load one from a file</source>
        <translation>Editar la paleta o cargar una de un archivo</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Color de fondo</translation>
    </message>
    <message>
        <source>Change the background colour</source>
        <translation>Cambiar el color de fondo</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparente</translation>
    </message>
    <message>
        <source>Make the background transparent</source>
        <translation>Hacer transparente el fondo</translation>
    </message>
    <message>
        <source>Make the background opaque</source>
        <translation>Hacer opaco el fondo</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Brillo</translation>
    </message>
    <message>
        <source>Change the brightness</source>
        <translation>Cambiar el brillo</translation>
    </message>
    <message>
        <source>How early thin parts become visible: κ of the logarithmic tone curve</source>
        <translation>Cuán pronto se hacen visibles las partes tenues: κ de la curva tonal logarítmica</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Change the gamma</source>
        <translation>Cambiar la gamma</translation>
    </message>
    <message>
        <source>Exponent of the tone curve: higher values lift the dark parts</source>
        <translation>Exponente de la curva tonal: los valores mayores aclaran las partes oscuras</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Supermuestreo</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>%1 × %1 sub-pixels</source>
        <translation>%1 × %1 subpíxeles</translation>
    </message>
    <message>
        <source>Change the supersampling</source>
        <translation>Cambiar el supermuestreo</translation>
    </message>
    <message>
        <source>Map colours</source>
        <translation>Colores de las aplicaciones</translation>
    </message>
    <message>
        <source>Reset the appearance</source>
        <translation>Restablecer el aspecto</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Color de la aplicación %1</translation>
    </message>
    <message>
        <source>Change the colour of map %1</source>
        <translation>Cambiar el color de la aplicación %1</translation>
    </message>
    <message>
        <source>What the colour of a point tells: how many points fall there, which map came last, or the whole address.</source>
        <translation>Lo que dice el color de un punto: cuántos puntos caen allí, qué aplicación fue la última o la dirección entera.</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, or along the addresses.</source>
        <translation>Los colores, de las partes más tenues a las más densas, o a lo largo de las direcciones.</translation>
    </message>
    <message>
        <source>Leaves the background out of exported pictures.</source>
        <translation>Prescinde del fondo en las imágenes exportadas.</translation>
    </message>
    <message>
        <source>Draws every pixel from several finer ones: smoother edges, for more memory and time.</source>
        <translation>Dibuja cada píxel a partir de varios más finos: bordes más suaves, a cambio de más memoria y tiempo.</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The number beside it is the same value.</source>
        <translation>Arrastre o use las teclas de flecha. El número de al lado es el mismo valor.</translation>
    </message>
</context>
<context>
    <name>view::ArisingBar</name>
    <message>
        <source>How the attractor arises</source>
        <translation>Cómo surge el atractor</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>The invariant measure, refined while nothing moves</source>
        <translation>La medida invariante, que se refina mientras nada se mueve</translation>
    </message>
    <message>
        <source>Steps Wⁿ</source>
        <translation>Pasos Wⁿ</translation>
    </message>
    <message>
        <source>The deterministic algorithm: all maps applied n times to the cage at rest</source>
        <translation>El algoritmo determinista: todas las aplicaciones, aplicadas n veces a la jaula en reposo</translation>
    </message>
    <message>
        <source>Chaos Game</source>
        <translation>Juego del caos</translation>
    </message>
    <message>
        <source>One point that jumps by maps drawn at random; the first 14 points are not plotted</source>
        <translation>Un punto que salta con aplicaciones elegidas al azar; los 14 primeros puntos no se dibujan</translation>
    </message>
    <message>
        <source>n: how often all maps are applied</source>
        <translation>n: cuántas veces se aplican todas las aplicaciones</translation>
    </message>
    <message>
        <source>Begin Again</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>No points yet, and other dice</source>
        <translation>Ningún punto todavía, y otros dados</translation>
    </message>
    <message>
        <source>One Point</source>
        <translation>Un punto</translation>
    </message>
    <message>
        <source>Plot one more point</source>
        <translation>Dibujar un punto más</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Let points appear</source>
        <translation>Hacer que aparezcan puntos</translation>
    </message>
    <message>
        <source>Points a second</source>
        <translation>Puntos por segundo</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 por segundo</translation>
    </message>
    <message>
        <source>W%1: the cage itself</source>
        <translation>W%1: la propia jaula</translation>
    </message>
    <message>
        <source>W%1: %2 copies of the cage</source>
        <translation>W%1: %2 copias de la jaula</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Stay at these points</source>
        <translation>Detenerse en estos puntos</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 punto</translation>
    </message>
    <message>
        <source>, the last by map %1</source>
        <translation>, el último con la aplicación %1</translation>
    </message>
    <message>
        <source>How often all maps are applied to the cage: 0 is the cage itself, and with every step the picture comes closer to the attractor.</source>
        <translation>Cuántas veces se aplican todas las aplicaciones a la jaula: con 0 se ve la propia jaula, y con cada paso la imagen se acerca más al atractor.</translation>
    </message>
    <message>
        <source>How many points the chaos game plots in a second.</source>
        <translation>Cuántos puntos dibuja el juego del caos en un segundo.</translation>
    </message>
    <message>
        <source>no points yet: press ▶</source>
        <translation>aún no hay puntos: pulse ▶</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Diagrama del conteo de cajas</translation>
    </message>
    <message>
        <source>How many boxes meet the attractor, against how fine they are: log₂ N over k for boxes of side L·2⁻ᵏ, L the side of the square around the attractor. Points in outline are left out of the line: there the size of the whole or of a cell shows.</source>
        <translation>Cuántas cajas tocan el atractor según su finura: log₂ N frente a k para cajas de lado L·2⁻ᵏ, L el lado del cuadrado alrededor del atractor. Los puntos huecos no cuentan para la recta: ahí se nota el tamaño del conjunto o de una celda.</translation>
    </message>
    <message>
        <source>Slope %1 over %2 sizes</source>
        <translation>Pendiente %1 sobre %2 tamaños</translation>
    </message>
    <message>
        <source>Copy Sizes and Counts</source>
        <translation>Copiar tamaños y recuentos</translation>
    </message>
    <message>
        <source>log₂ N</source>
        <translation>log₂ N</translation>
    </message>
    <message>
        <source>k, boxes of side L·2⁻ᵏ</source>
        <translation>k, cajas de lado L·2⁻ᵏ</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>pendiente %1</translation>
    </message>
</context>
<context>
    <name>view::BranchBar</name>
    <message>
        <source>Maps and branches</source>
        <translation>Aplicaciones y ramas</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Profundidad</translation>
    </message>
    <message>
        <source>Depth of the branch</source>
        <translation>Profundidad de la rama</translation>
    </message>
    <message>
        <source>How many maps of the address name the branch (Shift + wheel over the canvas)</source>
        <translation>Cuántas aplicaciones de la dirección nombran la rama (Mayús + rueda sobre el lienzo)</translation>
    </message>
    <message>
        <source>The address of the point clicked, outermost map first; the branch is what is bold</source>
        <translation>La dirección del punto pulsado, la aplicación más externa primero; la rama es lo que está en negrita</translation>
    </message>
    <message>
        <source>this branch, as a map of its own</source>
        <translation>esta rama, como aplicación propia</translation>
    </message>
    <message>
        <source>The system gets a map for this branch and one for every branch beside it. Its change is seen again at all smaller scales.</source>
        <translation>El sistema recibe una aplicación para esta rama y una para cada rama vecina. El cambio se ve de nuevo en todas las escalas menores.</translation>
    </message>
    <message>
        <source>the last map of its address</source>
        <translation>la última aplicación de su dirección</translation>
    </message>
    <message>
        <source>The code keeps its maps. All branches that this map makes change alike.</source>
        <translation>El código conserva sus aplicaciones. Todas las ramas que hace esta aplicación cambian igual.</translation>
    </message>
    <message>
        <source>What changing the branch changes</source>
        <translation>Qué cambia al cambiar la rama</translation>
    </message>
    <message>
        <source>&amp;Weave</source>
        <translation>&amp;Tejer</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Ángulo en que las aplicaciones elegidas oscilan sobre sus raíces</translation>
    </message>
    <message>
        <source>Lets the selected maps swing, each about the image of the lowest point of the fractal; the slider goes back to the middle when it is let go</source>
        <translation>Hace oscilar las aplicaciones elegidas, cada una sobre la imagen del punto más bajo del fractal; al soltarlo, el deslizador vuelve al centro</translation>
    </message>
    <message>
        <source>no branch selected</source>
        <translation>ninguna rama elegida</translation>
    </message>
    <message>
        <source>branch &lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation>rama &lt;b&gt;%1&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Let maps swing</source>
        <translation>Hacer oscilar aplicaciones</translation>
    </message>
    <message>
        <source>where it is shown, and it alone</source>
        <translation>dónde se muestra, y solo ella</translation>
    </message>
    <message>
        <source>The code stays as it is. This branch is shown elsewhere, and nothing like it at other scales.</source>
        <translation>El código queda como está. Esta rama se muestra en otro lugar, y nada semejante a otras escalas.</translation>
    </message>
    <message>
        <source>Put &amp;Back</source>
        <translation>&amp;Devolver a su lugar</translation>
    </message>
    <message>
        <source>Put All &amp;Back</source>
        <translation>&amp;Devolver todas</translation>
    </message>
    <message>
        <source>Shows the branch where its maps put it</source>
        <translation>Muestra la rama donde la ponen sus aplicaciones</translation>
    </message>
    <message>
        <source>Shows every branch where its maps put it</source>
        <translation>Muestra cada rama donde la ponen sus aplicaciones</translation>
    </message>
    <message>
        <source>Put branch %1 back</source>
        <translation>Devolver la rama %1 a su lugar</translation>
    </message>
    <message>
        <source>Put all branches back</source>
        <translation>Devolver todas las ramas a su lugar</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>&amp;Cambiar</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Pulse en un punto del atractor para elegir su rama.</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>Move corner %1 of branch %2</source>
        <translation>Mover la esquina %1 de la rama %2</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Mover la rama %1</translation>
    </message>
    <message>
        <source>Rotate branch %1</source>
        <translation>Girar la rama %1</translation>
    </message>
    <message>
        <source>Scale branch %1</source>
        <translation>Escalar la rama %1</translation>
    </message>
    <message>
        <source>This branch is map 1 now. Numbers in the table change it further.</source>
        <translation>Esta rama es ahora la aplicación 1. Los números de la tabla la siguen cambiando.</translation>
    </message>
</context>
<context>
    <name>view::CageActions</name>
    <message>
        <source>This entry is not a system of the plane, so it has no control cage.</source>
        <translation>Esta entrada no es un sistema del plano, así que no tiene jaula de control.</translation>
    </message>
    <message>
        <source>The cage is too flat to be undone. Open it by dragging a vertex, or reset it, and try again.</source>
        <translation>La jaula está demasiado aplastada para invertir su efecto. Ábrala arrastrando un vértice, o restablézcala, y vuelva a intentarlo.</translation>
    </message>
    <message>
        <source>The three points lie on one line and hold no coordinates. Put the third one beside the line.</source>
        <translation>Los tres puntos están alineados y no determinan coordenadas. Ponga el tercero fuera de la recta.</translation>
    </message>
    <message>
        <source>Fit the minimal canonical simplex</source>
        <translation>Ajustar el símplex canónico mínimo</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Restablecer la jaula</translation>
    </message>
    <message>
        <source>Bake the placement into the code</source>
        <translation>Incorporar la colocación al código</translation>
    </message>
    <message>
        <source>Define the control triangle</source>
        <translation>Definir el triángulo de control</translation>
    </message>
    <message>
        <source>Vertex %1 is there already.</source>
        <translation>El vértice %1 ya está ahí.</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Mover el vértice %1</translation>
    </message>
    <message>
        <source>A cage has at most %1 vertices.</source>
        <translation>Una jaula tiene a lo sumo %1 vértices.</translation>
    </message>
    <message>
        <source>There is no room for a vertex here.</source>
        <translation>Aquí no hay sitio para un vértice.</translation>
    </message>
    <message>
        <source>Insert a vertex</source>
        <translation>Insertar un vértice</translation>
    </message>
    <message>
        <source>A cage has at least three vertices.</source>
        <translation>Una jaula tiene al menos tres vértices.</translation>
    </message>
    <message>
        <source>Without this vertex the cage at rest would cross itself or be flat.</source>
        <translation>Sin este vértice, la jaula en reposo se cruzaría a sí misma o quedaría aplastada.</translation>
    </message>
    <message>
        <source>Delete vertex %1</source>
        <translation>Eliminar el vértice %1</translation>
    </message>
    <message>
        <source>Make the cage regular</source>
        <translation>Hacer regular la jaula</translation>
    </message>
    <message>
        <source>Unbake: take the placement out of the code</source>
        <translation>Extraer: sacar la colocación del código</translation>
    </message>
    <message>
        <source>Without these vertices the cage at rest would cross itself or be flat.</source>
        <translation>Sin estos vértices, la jaula en reposo se cruzaría a sí misma o quedaría aplastada.</translation>
    </message>
    <message>
        <source>Delete %1 vertices</source>
        <translation>Eliminar %1 vértices</translation>
    </message>
    <message>
        <source>The cage is the minimal canonical simplex already.</source>
        <translation>La jaula ya es el símplex canónico mínimo.</translation>
    </message>
    <message>
        <source>The cage is regular already.</source>
        <translation>La jaula ya es regular.</translation>
    </message>
</context>
<context>
    <name>view::CagePanel</name>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>State of the cage</source>
        <translation>Estado de la jaula</translation>
    </message>
    <message>
        <source>Warning about the cage</source>
        <translation>Aviso sobre la jaula</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Colocar</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Reescribir</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation>Mover la jaula mueve la imagen; el código no cambia</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Mover la jaula reescribe el código</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Curvar</translation>
    </message>
    <message>
        <source>Affine fit</source>
        <translation>Ajuste afín</translation>
    </message>
    <message>
        <source>Every vertex is followed; the picture bends, which cannot be baked into a code</source>
        <translation>La imagen sigue a todos los vértices y se curva, lo que no se puede incorporar a un código</translation>
    </message>
    <message>
        <source>The picture moves by the affine map that comes nearest to the vertices; it can be baked</source>
        <translation>La imagen se mueve según la aplicación afín que más se acerca a los vértices; se puede incorporar</translation>
    </message>
    <message>
        <source>Bend the picture</source>
        <translation>Curvar la imagen</translation>
    </message>
    <message>
        <source>Fit the picture by an affine map</source>
        <translation>Ajustar la imagen con una aplicación afín</translation>
    </message>
    <message>
        <source>Define…</source>
        <translation>Definir…</translation>
    </message>
    <message>
        <source>Define the triangle by three clicks on the canvas; the picture stays</source>
        <translation>Definir el triángulo con tres clics en el lienzo; la imagen no cambia</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Incorporar</translation>
    </message>
    <message>
        <source>Minimal Canonical Simplex</source>
        <translation>Símplex canónico mínimo</translation>
    </message>
    <message>
        <source>Canonical Simplex %1</source>
        <translation>Símplex canónico %1</translation>
    </message>
    <message>
        <source>Bounding Box</source>
        <translation>Rectángulo envolvente</translation>
    </message>
    <message numerus="yes">
        <source>%n Corners</source>
        <translation>
            <numerusform>%n vértice</numerusform>
            <numerusform>%n vértices</numerusform>
        </translation>
    </message>
    <message>
        <source>Convex Hull, Simplified to</source>
        <translation>Envolvente convexa, simplificada a</translation>
    </message>
    <message>
        <source>Regular Polygon with</source>
        <translation>Polígono regular de</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Ajustar la jaula</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>Rest cage</source>
        <translation>Jaula de reposo</translation>
    </message>
    <message>
        <source>Show the vertices that hold the attractor while the cage is at rest</source>
        <translation>Mostrar los vértices que sujetan el atractor mientras la jaula está en reposo</translation>
    </message>
    <message>
        <source>Show the rest cage</source>
        <translation>Mostrar la jaula de reposo</translation>
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
        <translation>x en reposo</translation>
    </message>
    <message>
        <source>y at rest</source>
        <translation>y en reposo</translation>
    </message>
    <message>
        <source>Minimal canonical simplex</source>
        <translation>Símplex canónico mínimo</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs say to which side its legs point from the right angle.</source>
        <translation>El menor triángulo rectángulo isósceles de catetos paralelos a los ejes que contiene la imagen. Los signos dicen hacia qué lado apuntan sus catetos desde el ángulo recto.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Coordenadas baricéntricas de un punto</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 that the vertices take to balance in the point.</source>
        <translation>Los pesos a, b, c con a + b + c = 1 que hay que poner en los vértices para que el punto sea su centro de masas.</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>x del punto</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>y del punto</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Coordenadas baricéntricas</translation>
    </message>
    <message>
        <source>%1 of vertex %2</source>
        <translation>%1 del vértice %2</translation>
    </message>
    <message>
        <source>%1 of rest vertex %2</source>
        <translation>%1 del vértice de reposo %2</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Mover el vértice %1</translation>
    </message>
    <message>
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Los tres puntos están alineados: la jaula de reposo debe encerrar un área.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>La jaula de reposo debe ser un polígono que no se cruce a sí mismo.</translation>
    </message>
    <message>
        <source>Define vertex %1</source>
        <translation>Definir el vértice %1</translation>
    </message>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>La imagen es demasiado estrecha para una jaula así.</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Restablecer la jaula</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Incorporar la jaula al código</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D: todavía no se muestra.</translation>
    </message>
    <message>
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Esta entrada no se pudo leer, así que no tiene jaula.</translation>
    </message>
    <message>
        <source>At rest: the picture is that of the code.</source>
        <translation>En reposo: la imagen es la del código.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture is that of the code.</source>
        <translation>%1 vértices, en reposo: la imagen es la del código.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates, not bakeable.</source>
        <translation>%1 vértices: curvada con coordenadas de Wachspress, no se puede incorporar.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, not bakeable.</source>
        <translation>%1 vértices: curvada con coordenadas de valor medio, no se puede incorporar.</translation>
    </message>
    <message>
        <source>Flat: the picture lies on one line. Open the cage and it comes back.</source>
        <translation>Aplastada: la imagen está en una recta. Abra la jaula y volverá.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the sense of rotation is reversed.</source>
        <translation>Colocada y reflejada: las áreas se multiplican por %1 y el sentido de giro se invierte.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Colocada: las áreas se multiplican por %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it holds no coordinates.</source>
        <translation>El triángulo está aplastado: no determina coordenadas.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, cateto %2, vértice (%3, %4)</translation>
    </message>
    <message>
        <source>Hold the picture by a fitted cage; the picture stays</source>
        <translation>Sujetar la imagen con una jaula ajustada; la imagen no cambia</translation>
    </message>
    <message>
        <source>Put the cage and the picture back to rest</source>
        <translation>Devolver la jaula y la imagen al reposo</translation>
    </message>
    <message>
        <source>Make the displayed picture the code; the cage then rests</source>
        <translation>Convertir la imagen mostrada en el código; la jaula queda entonces en reposo</translation>
    </message>
    <message>
        <source>The cage is there already.</source>
        <translation>La jaula ya está ahí.</translation>
    </message>
    <message>
        <source>The coordinates are read over a triangle.</source>
        <translation>Las coordenadas se leen sobre un triángulo.</translation>
    </message>
</context>
<context>
    <name>view::CageTool</name>
    <message>
        <source>Move the cage</source>
        <translation>Mover la jaula</translation>
    </message>
    <message>
        <source>Rotate the cage</source>
        <translation>Girar la jaula</translation>
    </message>
    <message>
        <source>Scale the cage</source>
        <translation>Escalar la jaula</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Mover el vértice %1</translation>
    </message>
    <message>
        <source>Move edge %1–%2</source>
        <translation>Mover la arista %1–%2</translation>
    </message>
    <message>
        <source>Move %1 vertices</source>
        <translation>Mover %1 vértices</translation>
    </message>
    <message>
        <source>Select a vertex first.</source>
        <translation>Elija primero un vértice.</translation>
    </message>
    <message>
        <source>Point at an edge, or select a vertex, to insert one.</source>
        <translation>Para insertar un vértice, señale una arista o elija un vértice.</translation>
    </message>
</context>
<context>
    <name>view::Canvas</name>
    <message>
        <source>No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). Make it smaller, or switch it off.</source>
        <translation>Sin atractor: la aplicación %1 no es contractiva (mayor valor singular %2, radio espectral %3). Redúzcala o desactívela.</translation>
    </message>
    <message>
        <source>No attractor: the maps %1, one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Sin atractor: las aplicaciones %1, una tras otra, no son contractivas (mayor valor singular %2, radio espectral %3). Reduzca una de ellas o desactívela.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor: map %1 stretches by %2. Points that run away are left out.</source>
        <translation>No está decidido si este sistema tiene atractor: la aplicación %1 alarga las distancias con factor %2. Los puntos que se escapan no se dibujan.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor. Points that run away are left out.</source>
        <translation>No está decidido si este sistema tiene atractor. Los puntos que se escapan no se dibujan.</translation>
    </message>
    <message>
        <source>This entry is a system in space: not yet shown. It is kept as it is.</source>
        <translation>Esta entrada es un sistema del espacio: todavía no se muestra. Se conserva tal cual.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept as it is in the file.</source>
        <translation>Esta entrada no se pudo leer. Su texto se conserva tal cual en el archivo.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>No interviene ninguna aplicación, así que no hay nada que dibujar. Añada una aplicación o active alguna.</translation>
    </message>
    <message>
        <source>This is as deep as the arithmetic reaches: zoom out a little for a true picture.</source>
        <translation>Más profundo no llega la aritmética: aleje un poco la vista para obtener una imagen fiel.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than asked for: more would need more memory than allowed.</source>
        <translation>Dibujado con menos iteraciones de las pedidas: más necesitarían más memoria de la permitida.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a vertex to open it: nothing is lost.</source>
        <translation>La jaula está aplastada, y la imagen también. Arrastre un vértice para abrirla: no se pierde nada.</translation>
    </message>
    <message>
        <source>Stopped: any farther, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Detenido: más allá, la aplicación %1 no contraería (mayor valor singular %2, radio espectral %3) y no habría atractor.</translation>
    </message>
    <message>
        <source>Stopped: any farther, the maps %1, one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Detenido: más allá, las aplicaciones %1, una tras otra, no contraerían (mayor valor singular %2, radio espectral %3) y no habría atractor.</translation>
    </message>
    <message>
        <source>Stopped: any farther, it is not settled whether there would be an attractor (map %1 has the largest singular value, %2).</source>
        <translation>Detenido: más allá, no está resuelto si habría atractor (la aplicación %1 tiene el mayor valor singular, %2).</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point.</source>
        <translation>Una sola aplicación: no queda más que su punto fijo.</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point (%1, %2).</source>
        <translation>Una sola aplicación: no queda más que su punto fijo (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is on has a weight above 0, so there is nothing to draw. Give one a weight.</source>
        <translation>Ninguna aplicación activa tiene un peso mayor que 0, así que no hay nada que dibujar. Dé un peso a alguna.</translation>
    </message>
</context>
<context>
    <name>view::CanvasMenu</name>
    <message>
        <source>Vertex %1</source>
        <translation>Vértice %1</translation>
    </message>
    <message>
        <source>&amp;Coordinates…</source>
        <translation>&amp;Coordenadas…</translation>
    </message>
    <message>
        <source>Types the place of this vertex</source>
        <translation>Permite escribir la posición de este vértice</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>&amp;Restablecer este vértice</translation>
    </message>
    <message>
        <source>Puts this vertex back to rest</source>
        <translation>Devuelve este vértice al reposo</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid Point (%1, %2)</source>
        <translation>Enganchar al punto de la c&amp;uadrícula (%1, %2)</translation>
    </message>
    <message>
        <source>Moves this vertex to the nearest point of the grid</source>
        <translation>Mueve este vértice al punto más próximo de la cuadrícula</translation>
    </message>
    <message>
        <source>Snap to the &amp;x Axis</source>
        <translation>Enganchar al eje &amp;x</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the x axis</source>
        <translation>Lleva este vértice en línea recta al eje x</translation>
    </message>
    <message>
        <source>Snap to the &amp;y Axis</source>
        <translation>Enganchar al eje &amp;y</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the y axis</source>
        <translation>Lleva este vértice en línea recta al eje y</translation>
    </message>
    <message>
        <source>&amp;Delete This Vertex</source>
        <translation>&amp;Eliminar este vértice</translation>
    </message>
    <message>
        <source>Takes this vertex out of the cage</source>
        <translation>Quita este vértice de la jaula</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>Poner aquí el &amp;pivote</translation>
    </message>
    <message>
        <source>Turns and scales the cage about this vertex</source>
        <translation>Gira y escala la jaula en torno a este vértice</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arista</translation>
    </message>
    <message>
        <source>&amp;Insert a Vertex Here</source>
        <translation>&amp;Insertar aquí un vértice</translation>
    </message>
    <message>
        <source>Puts one more vertex on this edge; a double click does the same</source>
        <translation>Pone un vértice más en esta arista; un doble clic hace lo mismo</translation>
    </message>
    <message>
        <source>Rotate: Shift turns in steps of 15°</source>
        <translation>Girar: con Mayús, en pasos de 15°</translation>
    </message>
    <message>
        <source>Scale: Shift keeps to x or y</source>
        <translation>Escalar: con Mayús, solo en x o en y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivote</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Middle</source>
        <translation>Poner el &amp;pivote en el centro</translation>
    </message>
    <message>
        <source>Turns and scales the cage about its middle</source>
        <translation>Gira y escala la jaula en torno a su centro</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Ajustar el símplex canónico &amp;mínimo</translation>
    </message>
    <message>
        <source>Holds the picture by the smallest right-angled triangle around it</source>
        <translation>Sujeta la imagen con el menor triángulo rectángulo que la rodea</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Definir el triángulo</translation>
    </message>
    <message>
        <source>Holds the picture by three points that are clicked</source>
        <translation>Sujeta la imagen con tres puntos en los que se hace clic</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>Res&amp;tablecer la jaula</translation>
    </message>
    <message>
        <source>Puts every vertex back to rest</source>
        <translation>Devuelve todos los vértices al reposo</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Hacer re&amp;gular</translation>
    </message>
    <message>
        <source>Puts the vertices on the regular polygon nearest to them</source>
        <translation>Lleva los vértices al polígono regular más próximo</translation>
    </message>
    <message>
        <source>&amp;Bake Placement into the Code</source>
        <translation>I&amp;ncorporar la colocación al código</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw what is shown, with the cage at rest</source>
        <translation>Reescribe las aplicaciones para que dibujen lo que se muestra, con la jaula en reposo</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>&amp;Fit	F</source>
        <translation>&amp;Ajustar la vista	F</translation>
    </message>
    <message>
        <source>Shows the whole picture and its cage</source>
        <translation>Muestra toda la imagen y su jaula</translation>
    </message>
    <message>
        <source>&amp;100 %	1</source>
        <translation>&amp;100 %	1</translation>
    </message>
    <message>
        <source>Shows one unit of the plane as a hundred pixels</source>
        <translation>Muestra una unidad del plano como cien píxeles</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>C&amp;uadrícula</translation>
    </message>
    <message>
        <source>Shows or hides the grid</source>
        <translation>Muestra u oculta la cuadrícula</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Ejes</translation>
    </message>
    <message>
        <source>Shows or hides the axes and their numbers</source>
        <translation>Muestra u oculta los ejes y sus números</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>Eje &amp;Y hacia abajo</translation>
    </message>
    <message>
        <source>Turns the plane over, as on the screen of a computer</source>
        <translation>Da la vuelta al plano, como en las coordenadas de la pantalla</translation>
    </message>
    <message>
        <source>&amp;Only the Picture	H</source>
        <translation>&amp;Solo la imagen	H</translation>
    </message>
    <message>
        <source>Hides the cage, the grid and the axes</source>
        <translation>Oculta la jaula, la cuadrícula y los ejes</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>&amp;Copiar imagen</translation>
    </message>
    <message>
        <source>Copies the picture as it is seen, without the cage</source>
        <translation>Copia la imagen tal como se ve, sin la jaula</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>&amp;Switch On</source>
        <translation>&amp;Activar</translation>
    </message>
    <message>
        <source>&amp;Switch Off</source>
        <translation>&amp;Desactivar</translation>
    </message>
    <message>
        <source>Lets this map take part, or not</source>
        <translation>Hace participar a esta aplicación, o no</translation>
    </message>
    <message>
        <source>Switch on map %1</source>
        <translation>Activar la aplicación %1</translation>
    </message>
    <message>
        <source>Switch off map %1</source>
        <translation>Desactivar la aplicación %1</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>Puts a copy of this map beside it</source>
        <translation>Pone una copia de esta aplicación al lado</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Takes this map out of the system</source>
        <translation>Quita esta aplicación del sistema</translation>
    </message>
</context>
<context>
    <name>view::CanvasScene</name>
    <message>
        <source>Vertex %1</source>
        <translation>Vértice %1</translation>
    </message>
    <message>
        <source>Edge from vertex %1</source>
        <translation>Arista desde el vértice %1</translation>
    </message>
    <message>
        <source>The whole cage</source>
        <translation>La jaula entera</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivote</translation>
    </message>
    <message>
        <source>Rotate handle</source>
        <translation>Tirador de giro</translation>
    </message>
    <message>
        <source>Scale handle</source>
        <translation>Tirador de escala</translation>
    </message>
    <message>
        <source>the arrow keys move both its ends</source>
        <translation>las teclas de flecha mueven sus dos extremos</translation>
    </message>
    <message>
        <source>the arrow keys move it</source>
        <translation>las teclas de flecha lo mueven</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, esquina %2</translation>
    </message>
    <message>
        <source>the arrow keys turn by one degree</source>
        <translation>las flechas giran un grado</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>las flechas escalan un uno por ciento</translation>
    </message>
    <message>
        <source>Drag the pivot: turning and scaling are about it.</source>
        <translation>Arrastre el pivote: se gira y se escala en torno a él.</translation>
    </message>
    <message>
        <source>Drag to turn about the pivot; Shift: in steps of 15°.</source>
        <translation>Arrastre para girar en torno al pivote; Mayús: en pasos de 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; Shift: along x or y only.</source>
        <translation>Arrastre para escalar en torno al pivote; Mayús: solo en x o en y.</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab goes from handle to handle, the arrow keys move the one in focus, F6 leaves the canvas.</source>
        <translation>El atractor y su jaula de control. Tab pasa de un tirador a otro, las teclas de flecha mueven el que tiene el foco, F6 sale del lienzo.</translation>
    </message>
    <message>
        <source>Define triangle</source>
        <translation>Definir el triángulo</translation>
    </message>
    <message>
        <source>The cage is flat, so new vertices cannot be related to the picture.</source>
        <translation>La jaula está aplastada, así que no se pueden relacionar vértices nuevos con la imagen.</translation>
    </message>
    <message>
        <source>Put the cage back to rest first?</source>
        <translation>¿Devolver antes la jaula al reposo?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Restablecer la jaula</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press H to see the cage again.</source>
        <translation>Solo se muestra la imagen. Pulse H para volver a ver la jaula.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; Ctrl turns, Alt scales, Shift keeps directions. The wheel zooms at the pointer, the middle button moves the plane. Tab goes from handle to handle, arrow keys move them, F6 leaves.</source>
        <translation>La imagen y su jaula. Arrastre un vértice, una arista o el interior de la jaula; Ctrl gira, Alt escala, Mayús conserva la dirección. La rueda amplía o reduce en torno al puntero, el botón central mueve el plano. Tab pasa de un tirador a otro, las teclas de flecha los mueven, F6 sale.</translation>
    </message>
</context>
<context>
    <name>view::Clipboard</name>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>pegado</translation>
    </message>
</context>
<context>
    <name>view::CollectionModel</name>
    <message>
        <source>Theme: %1</source>
        <translation>Tema: %1</translation>
    </message>
    <message>
        <source>%1, from %2, a favourite</source>
        <translation>%1, de %2, favorito</translation>
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
        <translation>Colección</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Buscar en la colección</translation>
    </message>
    <message>
        <source>Show only fractals whose name, title, theme or source contains these words.</source>
        <translation>Mostrar solo los fractales cuyo nombre, título, tema o fuente contiene estas palabras.</translation>
    </message>
    <message>
        <source>Fractals of the collection</source>
        <translation>Fractales de la colección</translation>
    </message>
    <message>
        <source>No favourites yet. Choose a fractal and press Ctrl+D.</source>
        <translation>Todavía no hay favoritos. Elija un fractal y pulse Ctrl+D.</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Nada contiene aquí estas palabras.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Abrir</translation>
    </message>
    <message>
        <source>Open the chosen fractal as a document of its own.</source>
        <translation>Abrir el fractal elegido como documento propio.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>Aña&amp;dir a este archivo</translation>
    </message>
    <message>
        <source>Add the chosen fractal to the open file.</source>
        <translation>Añadir el fractal elegido al archivo abierto.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>Fa&amp;vorito</translation>
    </message>
    <message>
        <source>Mark the chosen fractal as one of your favourites.</source>
        <translation>Marcar el fractal elegido como uno de sus favoritos.</translation>
    </message>
    <message>
        <source>Only Fa&amp;vourites</source>
        <translation>S&amp;olo favoritos</translation>
    </message>
    <message>
        <source>Show nothing but your favourites.</source>
        <translation>Mostrar únicamente sus favoritos.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>Añadir &amp;carpeta…</translation>
    </message>
    <message>
        <source>Show the .ifs files of a folder of yours here, too.</source>
        <translation>Mostrar aquí también los archivos .ifs de una carpeta suya.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>&amp;Quitar la carpeta «%1»</translation>
    </message>
    <message>
        <source>Show this folder here no more. Its files stay as they are.</source>
        <translation>No mostrar más esta carpeta aquí. Sus archivos quedan como están.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Carpeta de archivos .ifs</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment has these words. Enter opens the first of them.</source>
        <translation>Muestra solo los fractales cuyo nombre, tema o comentario contiene estas palabras. Intro abre el primero.</translation>
    </message>
    <message>
        <source>Fractals to begin with. Double-click or Enter opens one in this window; the menu of the right button adds it to the file instead.</source>
        <translation>Fractales para empezar. Un doble clic o Intro abre uno en esta ventana; en cambio, el menú del botón derecho lo añade al archivo.</translation>
    </message>
    <message>
        <source>Files of the collection that were read</source>
        <translation>Archivos leídos de la colección</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Dejar de leer</translation>
    </message>
    <message>
        <source>Stop reading this folder. What was read so far stays here.</source>
        <translation>Dejar de leer esta carpeta. Lo ya leído queda aquí.</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Leyendo la colección…</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
</context>
<context>
    <name>view::ColourButton</name>
    <message>
        <source>transparent</source>
        <translation>transparente</translation>
    </message>
    <message>
        <source>%1, %2 % opaque</source>
        <translation>%1, opaco al %2 %</translation>
    </message>
    <message>
        <source>Click to choose another colour.</source>
        <translation>Haga clic para elegir otro color.</translation>
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
        <translation>a b e c d f p: cada ecuación en una fila</translation>
    </message>
    <message>
        <source>a c b d e f p: column by column</source>
        <translation>a c b d e f p: columna por columna</translation>
    </message>
    <message>
        <source>p a b c d e f: the weight first</source>
        <translation>p a b c d e f: primero el peso</translation>
    </message>
    <message>
        <source>r s theta phi e f p: scales, and angles in degrees</source>
        <translation>r s theta phi e f p: escalas, y ángulos en grados</translation>
    </message>
    <message>
        <source>a b c d e f, and weights that add up row by row</source>
        <translation>a b c d e f, y pesos que se acumulan fila a fila</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Otro…</translation>
    </message>
    <message>
        <source>Order of the columns</source>
        <translation>Orden de las columnas</translation>
    </message>
    <message>
        <source>Names of the columns in their order</source>
        <translation>Nombres de las columnas en su orden</translation>
    </message>
    <message>
        <source>The names of the columns in their order: a b c d or r s theta phi, then e and f, each once, and p for a weight or cumulative for a sum of weights where there is one. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Los nombres de las columnas en su orden: a b c d o r s theta phi, además e y f, cada uno una vez, y p para un peso o cumulative para una suma de pesos donde la haya. x′ = a·x + b·y + e e y′ = c·x + d·y + f.</translation>
    </message>
</context>
<context>
    <name>view::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Paleta de órdenes</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Escriba lo que quiere hacer</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Órdenes que coinciden</translation>
    </message>
    <message>
        <source>Type some letters of what you want to do. Arrow keys choose, Enter does it.</source>
        <translation>Escriba algunas letras de lo que quiere hacer. Las teclas de flecha eligen, Intro lo ejecuta.</translation>
    </message>
    <message>
        <source>The commands whose names have these letters.</source>
        <translation>Las órdenes cuyo nombre contiene estas letras.</translation>
    </message>
    <message>
        <source>No command is called that.</source>
        <translation>Ninguna orden se llama así.</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three vertices. The picture stays where it is; Esc leaves.</source>
        <translation>Haga clic en el primero de los tres vértices. La imagen queda donde está; Esc sale.</translation>
    </message>
    <message>
        <source>Click the second vertex. Backspace takes the first one back.</source>
        <translation>Haga clic en el segundo vértice. Retroceso anula el primero.</translation>
    </message>
    <message>
        <source>Click the third vertex. Backspace takes the second one back.</source>
        <translation>Haga clic en el tercer vértice. Retroceso anula el segundo.</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Comentario de «%1»</translation>
    </message>
    <message>
        <source>Comment behind the name</source>
        <translation>Comentario detrás del nombre</translation>
    </message>
    <message>
        <source>Written on the first line of the entry, for example its title or author.</source>
        <translation>Se escribe en la primera línea de la entrada: por ejemplo, su título o su autor.</translation>
    </message>
    <message>
        <source>Comment lines</source>
        <translation>Líneas de comentario</translation>
    </message>
    <message>
        <source>Written as lines of their own below the name, each behind a semicolon.</source>
        <translation>Se escriben en líneas propias debajo del nombre, cada una tras un punto y coma.</translation>
    </message>
    <message>
        <source>Reason why the comment cannot be kept</source>
        <translation>Motivo por el que no se puede conservar el comentario</translation>
    </message>
    <message>
        <source>Keep or discard the comment</source>
        <translation>Conservar o descartar el comentario</translation>
    </message>
    <message>
        <source>&amp;Behind the name:</source>
        <translation>&amp;Detrás del nombre:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Líneas de comentario:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines keep the cage and the colours.</source>
        <translation>Un comentario no puede empezar por «barycage:»; esas líneas guardan la jaula y los colores.</translation>
    </message>
    <message>
        <source>A line holds at most %1 bytes; Fractint cuts longer ones. Break it in two.</source>
        <translation>Una línea contiene a lo sumo %1 bytes; Fractint corta las más largas. Pártala en dos.</translation>
    </message>
</context>
<context>
    <name>view::EntriesDelegate</name>
    <message>
        <source>Name of the entry</source>
        <translation>Nombre de la entrada</translation>
    </message>
</context>
<context>
    <name>view::EntriesEdits</name>
    <message>
        <source>An entry needs a name.</source>
        <translation>Una entrada necesita un nombre.</translation>
    </message>
    <message>
        <source>A name holds no blanks: Fractint would read its first word only.</source>
        <translation>Un nombre no contiene espacios: Fractint leería solo su primera palabra.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>«%1» no puede formar parte de un nombre, porque tiene un significado en los archivos .ifs.</translation>
    </message>
    <message>
        <source>A name has at most %1 characters; Fractint ignores the rest.</source>
        <translation>Un nombre tiene a lo sumo %1 caracteres; Fractint omite el resto.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint no incluye en su lista una entrada llamada «%1»; elija otro nombre.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case count as equal).</source>
        <translation>Otra entrada se llama «%1» (no se distinguen mayúsculas y minúsculas).</translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Cambiar el nombre «%1» por «%2»</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D: todavía no se muestra</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>no se pudo leer</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 aplicación</translation>
    </message>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n aplicación</numerusform>
            <numerusform>%n aplicaciones</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, no attractor</source>
        <translation>%1, sin atractor</translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation>Línea %1, columna %2: </translation>
    </message>
    <message>
        <source>modified</source>
        <translation>modificada</translation>
    </message>
    <message>
        <source>has errors</source>
        <translation>tiene errores</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>tiene avisos</translation>
    </message>
</context>
<context>
    <name>view::EntriesPanel</name>
    <message>
        <source>Entries of the file</source>
        <translation>Entradas del archivo</translation>
    </message>
    <message>
        <source>Filter entries by name</source>
        <translation>Filtrar las entradas por nombre</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Filtrar por nombre</translation>
    </message>
    <message>
        <source>Show only the entries whose name contains this text.</source>
        <translation>Mostrar solo las entradas cuyo nombre contiene este texto.</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Entradas</translation>
    </message>
    <message>
        <source>This file holds no entries. Add one, or paste the text of an .ifs file.</source>
        <translation>Este archivo no contiene entradas. Añada una o pegue el texto de un archivo .ifs.</translation>
    </message>
    <message>
        <source>&amp;Add Entry</source>
        <translation>&amp;Añadir entrada</translation>
    </message>
    <message>
        <source>Add a Sierpiński triangle as a new entry.</source>
        <translation>Añadir un triángulo de Sierpiński como entrada nueva.</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Duplicar</translation>
    </message>
    <message>
        <source>Add a copy of each selected entry.</source>
        <translation>Añadir una copia de cada entrada seleccionada.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected entries from the file.</source>
        <translation>Eliminar del archivo las entradas seleccionadas.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Ca&amp;mbiar nombre</translation>
    </message>
    <message>
        <source>Give the entry another name.</source>
        <translation>Dar otro nombre a la entrada.</translation>
    </message>
    <message>
        <source>Edit &amp;Comment…</source>
        <translation>Editar c&amp;omentario…</translation>
    </message>
    <message>
        <source>Edit the comment of the entry.</source>
        <translation>Editar el comentario de la entrada.</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>&amp;Subir</translation>
    </message>
    <message>
        <source>Move the selected entries towards the top of the file.</source>
        <translation>Mover las entradas seleccionadas hacia el principio del archivo.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>&amp;Bajar</translation>
    </message>
    <message>
        <source>Move the selected entries towards the end of the file.</source>
        <translation>Mover las entradas seleccionadas hacia el final del archivo.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selected entries as .ifs text.</source>
        <translation>Copiar las entradas seleccionadas como texto .ifs.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Paste the entries of .ifs text behind the current entry.</source>
        <translation>Pegar las entradas de un texto .ifs detrás de la entrada actual.</translation>
    </message>
    <message>
        <source>Add an entry</source>
        <translation>Añadir una entrada</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n entries</source>
        <translation>
            <numerusform>Eliminar %n entrada</numerusform>
            <numerusform>Eliminar %n entradas</numerusform>
        </translation>
    </message>
    <message>
        <source>An entry that could not be read cannot be duplicated: it would keep its name.</source>
        <translation>Una entrada que no se pudo leer no se puede duplicar: conservaría su nombre.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n entries</source>
        <translation>
            <numerusform>Duplicar %n entrada</numerusform>
            <numerusform>Duplicar %n entradas</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit the comment of %1</source>
        <translation>Editar el comentario de %1</translation>
    </message>
    <message>
        <source>There is no entry of an .ifs file in what was pasted.</source>
        <translation>En lo que se pegó no hay ninguna entrada de un archivo .ifs.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Pegar %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n entries</source>
        <translation>
            <numerusform>Pegar %n entrada</numerusform>
            <numerusform>Pegar %n entradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pasted entries could not be read; their text is kept as it is.</source>
        <translation>
            <numerusform>%n entrada pegada no se pudo leer; su texto se conserva tal cual.</numerusform>
            <numerusform>%n entradas pegadas no se pudieron leer; su texto se conserva tal cual.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n entries</source>
        <translation>
            <numerusform>Mover %n entrada</numerusform>
            <numerusform>Mover %n entradas</numerusform>
        </translation>
    </message>
    <message>
        <source>No entry has “%1” in its name.</source>
        <translation>Ninguna entrada tiene «%1» en su nombre.</translation>
    </message>
    <message>
        <source>Shows only the entries whose name has these letters.</source>
        <translation>Muestra solo las entradas cuyo nombre contiene estas letras.</translation>
    </message>
    <message>
        <source>The fractals of the file. Click one to edit it, drag it to another place, press F2 to give it another name.</source>
        <translation>Los fractales del archivo. Haga clic en uno para editarlo, arrástrelo a otro lugar, pulse F2 para darle otro nombre.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>No se pegó nada: no hay texto en el portapapeles.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Leyendo lo pegado…</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Añadiendo entradas…</translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Exportar los datos de «%1»</translation>
    </message>
    <message>
        <source>What the file will hold</source>
        <translation>Lo que contendrá el archivo</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progreso de la exportación</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>Copiar &amp;texto</translation>
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
        <translation>Tabla con comas (.csv)</translation>
    </message>
    <message>
        <source>Table with tabs (.tsv)</source>
        <translation>Tabla con tabuladores (.tsv)</translation>
    </message>
    <message>
        <source>Points (.csv)</source>
        <translation>Puntos (.csv)</translation>
    </message>
    <message>
        <source>Points, coloured (.ply)</source>
        <translation>Puntos con color (.ply)</translation>
    </message>
    <message>
        <source>&amp;Turn y around, so that the flame is the same way up</source>
        <translation>&amp;Invertir y para que el flame no salga cabeza abajo</translation>
    </message>
    <message>
        <source>&amp;Bake the placement, so that the maps draw what is shown</source>
        <translation>Incor&amp;porar la colocación para que las aplicaciones dibujen lo que se muestra</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formato:</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Columnas:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>Pu&amp;ntos:</translation>
    </message>
    <message>
        <source>Only the numbers of plane systems can be exported.</source>
        <translation>Solo se pueden exportar los números de los sistemas del plano.</translation>
    </message>
    <message>
        <source>The points of the chaos game where they are shown, without the first 14.</source>
        <translation>Los puntos del juego del caos donde se muestran, sin los 14 primeros.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Archivos %1 (*.%2)</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Exportar datos</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>The text is on the clipboard.</source>
        <translation>El texto está en el portapapeles.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Ce&amp;rrar</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>La exportación se detuvo; no se escribió nada.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Escrito en %1.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>El principio del archivo tal como se escribirá.</translation>
    </message>
    <message>
        <source>For which program the data are: each format has what that program reads.</source>
        <translation>Para qué programa son los datos: cada formato contiene lo que lee ese programa.</translation>
    </message>
    <message>
        <source>The order in which each row has its coefficients; other programs expect other orders.</source>
        <translation>El orden de los coeficientes en cada fila; otros programas esperan otros órdenes.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Cuántos puntos del juego del caos se escriben.</translation>
    </message>
    <message>
        <source>Flame programs let y grow downwards. With this the flame looks as the fractal does here; without it the numbers are the same.</source>
        <translation>En los programas de flames, y crece hacia abajo. Con esto, el flame se ve como aquí el fractal; sin esto, los números son los mismos.</translation>
    </message>
    <message>
        <source>With this, the cage is made part of the maps. Without it, the maps are written as they stand in the table.</source>
        <translation>Con esto, la jaula pasa a formar parte de las aplicaciones. Sin esto, las aplicaciones se escriben como están en la tabla.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it.</source>
        <translation>Pide el nombre del archivo y lo escribe.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Copia todo el texto al portapapeles en vez de escribir un archivo.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exportar «%1»</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>PNG: pixels</source>
        <translation>PNG: píxeles</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG: formas para programas de dibujo</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF: formas para imprimir</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>Fondo &amp;transparente</translation>
    </message>
    <message>
        <source>Include the &amp;control triangle</source>
        <translation>Incluir el triángulo de &amp;control</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formato:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Tamaño:</translation>
    </message>
    <message>
        <source>Draft: 25 samples a pixel</source>
        <translation>Borrador: 25 muestras por píxel</translation>
    </message>
    <message>
        <source>Good: 100 samples a pixel</source>
        <translation>Buena: 100 muestras por píxel</translation>
    </message>
    <message>
        <source>Fine: 400 samples a pixel</source>
        <translation>Fina: 400 muestras por píxel</translation>
    </message>
    <message>
        <source>Finest: 2000 samples a pixel</source>
        <translation>Finísima: 2000 muestras por píxel</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>Cells along the side of a pixel</source>
        <translation>Celdas a lo largo del lado de un píxel</translation>
    </message>
    <message>
        <source>8 bits a channel</source>
        <translation>8 bits por canal</translation>
    </message>
    <message>
        <source>16 bits a channel, for further work on the picture</source>
        <translation>16 bits por canal, para seguir trabajando con la imagen</translation>
    </message>
    <message>
        <source>Colour depth</source>
        <translation>Profundidad de color</translation>
    </message>
    <message>
        <source>Memory needed</source>
        <translation>Memoria necesaria</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>Ca&amp;lidad:</translation>
    </message>
    <message>
        <source>&amp;Supersampling:</source>
        <translation>&amp;Supermuestreo:</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>Profundidad de c&amp;olor:</translation>
    </message>
    <message>
        <source>Memory:</source>
        <translation>Memoria:</translation>
    </message>
    <message>
        <source>Copies of copies: a small file</source>
        <translation>Copias de copias: un archivo pequeño</translation>
    </message>
    <message>
        <source>Outline, for cutters and plotters</source>
        <translation>Contorno, para máquinas de corte y trazadores</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Kind of shapes</source>
        <translation>Clase de formas</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Número de puntos</translation>
    </message>
    <message>
        <source>As deep as a pixel &amp;needs</source>
        <translation>Tan profundo como &amp;necesite un píxel</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Niveles de copias</translation>
    </message>
    <message>
        <source>What the picture will be like</source>
        <translation>Cómo será la imagen</translation>
    </message>
    <message>
        <source>S&amp;hapes:</source>
        <translation>Fo&amp;rmas:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>P&amp;untos:</translation>
    </message>
    <message>
        <source>&amp;Depth:</source>
        <translation>&amp;Profundidad:</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progreso de la exportación</translation>
    </message>
    <message>
        <source>Only plane systems can be exported as a picture.</source>
        <translation>Solo los sistemas del plano se pueden exportar como imagen.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>unos %1</translation>
    </message>
    <message>
        <source>One dot for every point of the chaos game that is in view.</source>
        <translation>Una marca por cada punto del juego del caos que está a la vista.</translation>
    </message>
    <message>
        <source> The cage bends the picture, which copies cannot follow: the affine fit of the cage is written. A PNG shows the bend.</source>
        <translation> La jaula curva la imagen, y las copias no pueden seguirla: se escribe el ajuste afín de la jaula. Un PNG sí muestra la curvatura.</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Documentos PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Scalable pictures (*.svg)</source>
        <translation>Imágenes vectoriales (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>La exportación se detuvo; no se escribió nada.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Escrito en %1.</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Cerr&amp;ar</translation>
    </message>
    <message>
        <source>PNG is a picture of pixels; SVG and PDF are made of shapes, which stay sharp at every size.</source>
        <translation>PNG es una imagen de píxeles; SVG y PDF están hechos de formas, que se ven nítidas a cualquier tamaño.</translation>
    </message>
    <message>
        <source>The picture has no background and can be laid over another.</source>
        <translation>La imagen no tiene fondo y se puede poner encima de otra.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Dibuja la jaula encima de la imagen.</translation>
    </message>
    <message>
        <source>How many points are drawn for each pixel: more make a smoother picture and take longer.</source>
        <translation>Cuántos puntos se dibujan por cada píxel: con más, la imagen es más suave y tarda más.</translation>
    </message>
    <message>
        <source>Every pixel is drawn from so many finer ones along its side: smoother edges, for more memory and time.</source>
        <translation>Cada píxel se dibuja a partir de ese número de píxeles más finos por lado: bordes más suaves, a cambio de más memoria y tiempo.</translation>
    </message>
    <message>
        <source>16 bits keep fine steps of brightness for later work in a picture editor; 8 bits are enough to look at.</source>
        <translation>16 bits conservan gradaciones finas de brillo para seguir trabajando en un editor de imágenes; para mirar bastan 8 bits.</translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation>Las copias de copias dan un archivo pequeño que los programas de dibujo pueden editar; el contorno es un solo trazado; los puntos son marcas del juego del caos.</translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation>Cuántas marcas del juego del caos se dibujan.</translation>
    </message>
    <message>
        <source>How many levels of copies the picture has. The file hardly grows with it, the time to draw it does.</source>
        <translation>Cuántos niveles de copias tiene la imagen. El archivo apenas crece con ello; el tiempo de dibujo, sí.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it. The window can be used meanwhile.</source>
        <translation>Pide el nombre del archivo y lo escribe. Entretanto se puede usar la ventana.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Copiando la imagen…</translation>
    </message>
    <message>
        <source>Copies are made smaller until no pixel of this size could tell the difference, or programs would take long to draw them.</source>
        <translation>Se hacen copias cada vez más pequeñas hasta que ningún píxel de este tamaño pueda notar la diferencia, o hasta que los programas tarden mucho en dibujarlas.</translation>
    </message>
    <message>
        <source>%1 references (fewer than %3 are allowed). Nothing that is drawn is farther than %2 pixels from the attractor, and nothing of it is farther from what is drawn.</source>
        <translation>%1 referencias (se permiten menos de %3). Nada de lo dibujado dista del atractor más de %2 píxeles, y nada del atractor dista más de lo dibujado.</translation>
    </message>
    <message>
        <source> A pixel needs more: this is as deep as programs draw without a long wait.</source>
        <translation> Un píxel necesita más: esta es la mayor profundidad que los programas dibujan sin una larga espera.</translation>
    </message>
    <message>
        <source>Working out the shapes…</source>
        <translation>Calculando las formas…</translation>
    </message>
</context>
<context>
    <name>view::ExportSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>píxeles</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Unidad de longitud</translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation>Como en la pantalla</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × la pantalla</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Tamaño propio</translation>
    </message>
    <message>
        <source>Size relative to the screen</source>
        <translation>Tamaño con respecto a la pantalla</translation>
    </message>
    <message>
        <source>Keep shape</source>
        <translation>Mantener la proporción</translation>
    </message>
    <message>
        <source>Keep the shape of the picture on the screen</source>
        <translation>Mantener la proporción que tiene la imagen en la pantalla</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> ppp</translation>
    </message>
    <message>
        <source>Resolution in dots per inch</source>
        <translation>Resolución en puntos por pulgada</translation>
    </message>
    <message>
        <source>A length in the unit chosen beside it. The other side follows while the shape is kept.</source>
        <translation>Una longitud en la unidad elegida al lado. El otro lado la sigue mientras se mantenga la proporción.</translation>
    </message>
    <message>
        <source>In pixels, or on paper at the resolution given.</source>
        <translation>En píxeles, o en papel con la resolución indicada.</translation>
    </message>
    <message>
        <source>The picture as on the screen or some times as large.</source>
        <translation>La imagen como en la pantalla o varias veces más grande.</translation>
    </message>
    <message>
        <source>How many pixels go on an inch of paper: 300 is usual in print.</source>
        <translation>Cuántos píxeles caben en una pulgada de papel: lo habitual en la imprenta es 300.</translation>
    </message>
</context>
<context>
    <name>view::GradientChooser</name>
    <message>
        <source>of this fractal</source>
        <translation>de este fractal</translation>
    </message>
    <message>
        <source>%1 (of this fractal)</source>
        <translation>%1 (de este fractal)</translation>
    </message>
</context>
<context>
    <name>view::GradientEditor</name>
    <message>
        <source>Palette editor</source>
        <translation>Editor de paletas</translation>
    </message>
    <message>
        <source>Colour of the stop</source>
        <translation>Color de la parada</translation>
    </message>
    <message>
        <source>Position of the stop</source>
        <translation>Posición de la parada</translation>
    </message>
    <message>
        <source>Position of the stop, from 0 to 1</source>
        <translation>Posición de la parada, de 0 a 1</translation>
    </message>
    <message>
        <source>Add Stop</source>
        <translation>Añadir parada</translation>
    </message>
    <message>
        <source>Add a stop after the chosen one</source>
        <translation>Añadir una parada después de la elegida</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Eliminar parada</translation>
    </message>
    <message>
        <source>Delete the chosen stop</source>
        <translation>Eliminar la parada elegida</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Turn the palette round</source>
        <translation>Dar la vuelta a la paleta</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Distribuir</translation>
    </message>
    <message>
        <source>Put the stops at equal distances</source>
        <translation>Poner las paradas a distancias iguales</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Cargar…</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ugr or .map file</source>
        <translation>Cargar una paleta de un archivo .gpl, .ugr o .map</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save the palette as a .gpl file</source>
        <translation>Guardar la paleta como archivo .gpl</translation>
    </message>
    <message>
        <source>Change a colour of the palette</source>
        <translation>Cambiar un color de la paleta</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Mover una parada de la paleta</translation>
    </message>
    <message>
        <source>Save Palette</source>
        <translation>Guardar la paleta</translation>
    </message>
    <message>
        <source>palette</source>
        <translation>paleta</translation>
    </message>
    <message>
        <source>GIMP palettes (*.gpl)</source>
        <translation>Paletas de GIMP (*.gpl)</translation>
    </message>
    <message>
        <source>Reverse the palette</source>
        <translation>Invertir la paleta</translation>
    </message>
    <message>
        <source>Distribute the stops of the palette</source>
        <translation>Distribuir las paradas de la paleta</translation>
    </message>
    <message>
        <source>Load Palette</source>
        <translation>Cargar una paleta</translation>
    </message>
    <message>
        <source>Palettes (*.gpl *.ugr *.gradient *.map);;All files (*)</source>
        <translation>Paletas (*.gpl *.ugr *.gradient *.map);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, línea %2: %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Load the palette %1</source>
        <translation>Cargar la paleta %1</translation>
    </message>
    <message>
        <source>Palettes of the file</source>
        <translation>Paletas del archivo</translation>
    </message>
    <message>
        <source>Load a palette</source>
        <translation>Cargar una paleta</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se ha guardado %1.</translation>
    </message>
    <message>
        <source>The palettes that the file holds. Choose one.</source>
        <translation>Las paletas que contiene el archivo. Elija una.</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Paradas del degradado</translation>
    </message>
    <message>
        <source>Double-click: new stop, or the colour of one. Drag: move. Del: delete it.
Keys: Page Up and Page Down choose a stop, the arrows move it, Ins adds one, Enter opens its colour.</source>
        <translation>Doble clic: parada nueva, o el color de una. Arrastrar: mover. Supr: eliminar.
Teclas: Re Pág y Av Pág eligen una parada, las flechas la mueven, Ins añade una, Intro abre su color.</translation>
    </message>
    <message>
        <source>Stop %1 of %2 at %3 %, %4</source>
        <translation>Parada %1 de %2 al %3 %, %4</translation>
    </message>
    <message>
        <source>Add a stop to the palette</source>
        <translation>Añadir una parada a la paleta</translation>
    </message>
    <message>
        <source>Delete a stop of the palette</source>
        <translation>Eliminar una parada de la paleta</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Mover una parada de la paleta</translation>
    </message>
</context>
<context>
    <name>view::Guide</name>
    <message>
        <source>User Guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>The user guide: what can be done here, in the order in which one needs it.</source>
        <translation>La guía del usuario: lo que se puede hacer aquí, en el orden en que hace falta.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Buscar en la guía</translation>
    </message>
    <message>
        <source>Marks these words in the guide. Enter shows the next place, Shift+Enter the one before. Ctrl+F leads here.</source>
        <translation>Marca estas palabras en la guía. Intro muestra el lugar siguiente, Mayús+Intro el anterior. Ctrl+F lleva hasta aquí.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>No se encontró</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
</context>
<context>
    <name>view::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Pasos del historial</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward.</source>
        <translation>Elija un paso para volver a él o para avanzar hasta él.</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward. The disk marks what is saved.</source>
        <translation>Elija un paso para volver a él o para avanzar hasta él. El disco señala lo que está guardado.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Como se abrió</translation>
    </message>
</context>
<context>
    <name>view::MapShapeEditor</name>
    <message>
        <source>Rotation °</source>
        <translation>Giro °</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise with y up</source>
        <translation>Ángulo en grados, en sentido antihorario con y hacia arriba</translation>
    </message>
    <message>
        <source>Scale x</source>
        <translation>Escala x</translation>
    </message>
    <message>
        <source>Length of the image of the x unit vector</source>
        <translation>Longitud de la imagen del vector unitario x</translation>
    </message>
    <message>
        <source>Scale y</source>
        <translation>Escala y</translation>
    </message>
    <message>
        <source>Scale across; negative when the map reflects</source>
        <translation>Escala en la dirección perpendicular; negativa cuando la aplicación refleja</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cizalladura</translation>
    </message>
    <message>
        <source>Shear along x, applied before everything else</source>
        <translation>Cizalladura a lo largo de x, que se aplica antes que todo lo demás</translation>
    </message>
    <message>
        <source>Shift x</source>
        <translation>Traslación x</translation>
    </message>
    <message>
        <source>Translation e, applied last</source>
        <translation>Traslación e, que se aplica al final</translation>
    </message>
    <message>
        <source>Shift y</source>
        <translation>Traslación y</translation>
    </message>
    <message>
        <source>Translation f, applied last</source>
        <translation>Traslación f, que se aplica al final</translation>
    </message>
    <message>
        <source>No map is selected</source>
        <translation>No hay ninguna aplicación seleccionada</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>Change the shape of map %1</source>
        <translation>Cambiar la forma de la aplicación %1</translation>
    </message>
</context>
<context>
    <name>view::MapsDelegate</name>
    <message>
        <source>%1 of map %2</source>
        <translation>%1 de la aplicación %2</translation>
    </message>
    <message>
        <source>%1 The cell keeps its value.</source>
        <translation>%1 La celda conserva su valor.</translation>
    </message>
</context>
<context>
    <name>view::MapsModel</name>
    <message>
        <source>similarity</source>
        <translation>semejanza</translation>
    </message>
    <message>
        <source>reflected similarity</source>
        <translation>semejanza inversa</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>afín</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>singular</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>constante</translation>
    </message>
    <message>
        <source>A similarity keeps shapes: it turns, scales and shifts.</source>
        <translation>Una semejanza conserva las formas: gira, escala y traslada.</translation>
    </message>
    <message>
        <source>A reflected similarity keeps shapes, as a mirror does, and scales and shifts them.</source>
        <translation>Una semejanza inversa conserva las formas como lo hace un espejo, y las escala y traslada.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels, not angles.</source>
        <translation>Una aplicación afín conserva las rectas y el paralelismo, no los ángulos.</translation>
    </message>
    <message>
        <source>A singular map takes the plane to a line.</source>
        <translation>Una aplicación singular lleva el plano a una recta.</translation>
    </message>
    <message>
        <source>A constant map takes the plane to one point.</source>
        <translation>Una aplicación constante lleva el plano a un solo punto.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sí</translation>
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
        <translation>Tipo</translation>
    </message>
    <message>
        <source>The map takes (x, y) to (a x + b y + e, c x + d y + f).</source>
        <translation>La aplicación lleva (x, y) a (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage. Bake makes it the code.</source>
        <translation>Código efectivo: la aplicación tal como actúa sobre la imagen con la jaula actual. «Incorporar» lo convierte en el código.</translation>
    </message>
    <message>
        <source>Whether the map takes part.</source>
        <translation>Si la aplicación interviene.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map.</source>
        <translation>Color de la aplicación, que se usa cuando la imagen se colorea por aplicación.</translation>
    </message>
    <message>
        <source>Weight as given: how often the chaos game takes the map. The weights need not sum to 1.</source>
        <translation>Peso tal como se da: con qué frecuencia elige el juego del caos esta aplicación. No hace falta que los pesos sumen 1.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor of areas; negative when the map reflects.</source>
        <translation>Determinante ad − bc: el factor de las áreas; negativo cuando la aplicación refleja.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the most by which distances grow.</source>
        <translation>Factor de contracción ‖A‖, el mayor valor singular: lo máximo por lo que se multiplica una distancia.</translation>
    </message>
    <message>
        <source>What the map is geometrically.</source>
        <translation>Qué es geométricamente la aplicación.</translation>
    </message>
    <message>
        <source>Map %1 takes part.</source>
        <translation>La aplicación %1 interviene.</translation>
    </message>
    <message>
        <source>Map %1 is switched off.</source>
        <translation>La aplicación %1 está desactivada.</translation>
    </message>
    <message>
        <source>Colour of map %1. Press Space or double-click to change it.</source>
        <translation>Color de la aplicación %1. Pulse la barra espaciadora o haga doble clic para cambiarlo.</translation>
    </message>
    <message>
        <source>The cage is flat or bent: there is no effective code.</source>
        <translation>La jaula está aplastada o curvada: no hay código efectivo.</translation>
    </message>
    <message>
        <source>No weight is given; the determinant rule makes the probability %1.</source>
        <translation>No se da ningún peso; según la regla del determinante, la probabilidad es %1.</translation>
    </message>
    <message>
        <source>Weight %1: a weight that is not positive switches the map off.</source>
        <translation>Peso %1: un peso que no es positivo desactiva la aplicación.</translation>
    </message>
    <message>
        <source>Weight %1, probability %2.</source>
        <translation>Peso %1, probabilidad %2.</translation>
    </message>
    <message>
        <source>%1, not contracting</source>
        <translation>%1, no contrae</translation>
    </message>
    <message>
        <source>colour %1</source>
        <translation>color %1</translation>
    </message>
    <message>
        <source>Map %1 does not contract: it stretches by up to %2. The system may still have an attractor if longer words contract.</source>
        <translation>La aplicación %1 no es contractiva: alarga las distancias con un factor de hasta %2. Aun así, el sistema puede tener atractor si las palabras más largas son contractivas.</translation>
    </message>
    <message>
        <source>Map %1. Drag to reorder.</source>
        <translation>Aplicación %1. Arrástrela para cambiar el orden.</translation>
    </message>
    <message>
        <source>Change weight of map %1</source>
        <translation>Cambiar el peso de la aplicación %1</translation>
    </message>
    <message>
        <source>Change %1 of map %2</source>
        <translation>Cambiar %1 de la aplicación %2</translation>
    </message>
    <message>
        <source>Switch map %1 on</source>
        <translation>Activar la aplicación %1</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Desactivar la aplicación %1</translation>
    </message>
    <message>
        <source>Change colour of map %1</source>
        <translation>Cambiar el color de la aplicación %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
</context>
<context>
    <name>view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation>Aplicaciones</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Add a map of half the size</source>
        <translation>Añadir una aplicación que reduce a la mitad</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Duplicar las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Eliminar las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Move the selected maps up</source>
        <translation>Subir las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Move the selected maps down</source>
        <translation>Bajar las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Copy Rows</source>
        <translation>Copiar filas</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f p, separated by tabs</source>
        <translation>Copiar las aplicaciones seleccionadas como filas a b c d e f p, separadas por tabuladores</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>Pegar en su lugar</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 6 or 7 numbers from the clipboard</source>
        <translation>Sustituir las aplicaciones seleccionadas por filas de 6 o 7 números del portapapeles</translation>
    </message>
    <message>
        <source>Paste as New Maps</source>
        <translation>Pegar como aplicaciones nuevas</translation>
    </message>
    <message>
        <source>Add rows of 6 or 7 numbers from the clipboard as new maps</source>
        <translation>Añadir filas de 6 o 7 números del portapapeles como aplicaciones nuevas</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Incorporar</translation>
    </message>
    <message>
        <source>Make the effective code the code; the cage then rests</source>
        <translation>Convertir el código efectivo en el código; la jaula queda entonces en reposo</translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Según el |determinante|</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, so that the picture is even</source>
        <translation>Pesos proporcionales a las áreas de las imágenes, para que la imagen sea uniforme</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Iguales</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>El mismo peso para todas las aplicaciones</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Según la dimensión</translation>
    </message>
    <message>
        <source>Weights for an even cover of the attractor at its own dimension</source>
        <translation>Pesos que cubren el atractor de modo uniforme en su propia dimensión</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normalizar</translation>
    </message>
    <message>
        <source>The same proportions, with the sum 1</source>
        <translation>Las mismas proporciones, con suma 1</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>Weights of all maps that are on, by a rule</source>
        <translation>Los pesos de todas las aplicaciones activas, según una regla</translation>
    </message>
    <message>
        <source>Show columns: %1</source>
        <translation>Mostrar columnas: %1</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Show the coefficients a … f</source>
        <translation>Mostrar los coeficientes a … f</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Mostrar el determinante, el factor de contracción y el tipo de cada aplicación</translation>
    </message>
    <message>
        <source>Effective code</source>
        <translation>Código efectivo</translation>
    </message>
    <message>
        <source>Show the maps as they act on the picture under the current cage</source>
        <translation>Mostrar las aplicaciones tal como actúan sobre la imagen con la jaula actual</translation>
    </message>
    <message>
        <source>Table of maps</source>
        <translation>Tabla de aplicaciones</translation>
    </message>
    <message>
        <source>No maps: add one, or paste rows of 6 or 7 numbers.</source>
        <translation>No hay aplicaciones: añada una o pegue filas de 6 o 7 números.</translation>
    </message>
    <message>
        <source>3D: not yet shown.
The entry is kept as it is.</source>
        <translation>3D: todavía no se muestra.
La entrada se conserva tal cual.</translation>
    </message>
    <message>
        <source>This entry could not be read. It is kept as it is.</source>
        <translation>Esta entrada no se pudo leer. Se conserva tal cual.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>Add a map</source>
        <translation>Añadir una aplicación</translation>
    </message>
    <message>
        <source>Duplicate a map</source>
        <translation>Duplicar una aplicación</translation>
    </message>
    <message>
        <source>Duplicate %1 maps</source>
        <translation>Duplicar %1 aplicaciones</translation>
    </message>
    <message>
        <source>Delete a map</source>
        <translation>Eliminar una aplicación</translation>
    </message>
    <message>
        <source>Delete %1 maps</source>
        <translation>Eliminar %1 aplicaciones</translation>
    </message>
    <message>
        <source>Reorder maps</source>
        <translation>Reordenar las aplicaciones</translation>
    </message>
    <message>
        <source>Nothing was pasted. Line %1 of the clipboard: %2</source>
        <translation>No se pegó nada. Línea %1 del portapapeles: %2</translation>
    </message>
    <message>
        <source>Nothing was pasted. %1</source>
        <translation>No se pegó nada. %1</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard holds no rows of 6 or 7 numbers.</source>
        <translation>No se pegó nada: el portapapeles no contiene filas de 6 o 7 números.</translation>
    </message>
    <message>
        <source>Paste a map</source>
        <translation>Pegar una aplicación</translation>
    </message>
    <message>
        <source>Paste %1 maps</source>
        <translation>Pegar %1 aplicaciones</translation>
    </message>
    <message>
        <source>Maps added: %1.</source>
        <translation>Aplicaciones añadidas: %1.</translation>
    </message>
    <message>
        <source>The selected maps were replaced; maps pasted: %1.</source>
        <translation>Se sustituyeron las aplicaciones seleccionadas; aplicaciones pegadas: %1.</translation>
    </message>
    <message>
        <source>Set the weights</source>
        <translation>Fijar los pesos</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Incorporar la jaula al código</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Color de la aplicación %1</translation>
    </message>
    <message>
        <source>Every row is a map: (x, y) goes to (a x + b y + e, c x + d y + f), as often as its weight p says. Double-click a number, or begin to type, to change it; the picture follows every key. Drag the number of a row to move it.</source>
        <translation>Cada fila es una aplicación: (x, y) va a (a x + b y + e, c x + d y + f), con la frecuencia que dice su peso p. Haga doble clic en un número, o empiece a escribir, para cambiarlo; la imagen sigue cada tecla. Arrastre el número de una fila para moverla.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Leyendo lo pegado…</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Números de las aplicaciones</translation>
    </message>
    <message>
        <source>Drag a number to put the map elsewhere. A mark warns of a map that does not contract.</source>
        <translation>Arrastre un número para poner la aplicación en otro lugar. Una marca avisa de que una aplicación no es contractiva.</translation>
    </message>
</context>
<context>
    <name>view::MapsTool</name>
    <message>
        <source>Move corner %1 of map %2</source>
        <translation>Mover la esquina %1 de la aplicación %2</translation>
    </message>
    <message>
        <source>Move map %1</source>
        <translation>Mover la aplicación %1</translation>
    </message>
    <message>
        <source>Move %1 maps</source>
        <translation>Mover %1 aplicaciones</translation>
    </message>
    <message>
        <source>Rotate map %1</source>
        <translation>Girar la aplicación %1</translation>
    </message>
    <message>
        <source>Rotate %1 maps</source>
        <translation>Girar %1 aplicaciones</translation>
    </message>
    <message>
        <source>Scale map %1</source>
        <translation>Escalar la aplicación %1</translation>
    </message>
    <message>
        <source>Scale %1 maps</source>
        <translation>Escalar %1 aplicaciones</translation>
    </message>
    <message>
        <source>What is flat on the screen cannot be taken. Open the cage, or the maps, first.</source>
        <translation>Lo que es plano en la pantalla no se puede tomar. Abra primero la jaula o las aplicaciones.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Elija primero una aplicación.</translation>
    </message>
    <message>
        <source>Of so many maps only some are shown. Zoom in to see the others.</source>
        <translation>De tantas aplicaciones solo se muestran algunas. Acerque la vista para ver las demás.</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Variaciones de «%1»</translation>
    </message>
    <message>
        <source>Fractals by Chance</source>
        <translation>Fractales al azar</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variaciones</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Usar esta</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>&amp;Añadir al archivo</translation>
    </message>
    <message>
        <source>&amp;Vary This One</source>
        <translation>&amp;Variar esta</translation>
    </message>
    <message>
        <source>Make the chosen one what the variations start from</source>
        <translation>Tomar la elegida como punto de partida de las variaciones</translation>
    </message>
    <message>
        <source>How different the variations are</source>
        <translation>Cuán distintas son las variaciones</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Semilla de los números aleatorios</translation>
    </message>
    <message>
        <source>The same seed gives the same sheet again</source>
        <translation>La misma semilla vuelve a dar la misma lámina</translation>
    </message>
    <message>
        <source>&amp;Others</source>
        <translation>&amp;Otras</translation>
    </message>
    <message>
        <source>Another sheet: the next seed</source>
        <translation>Otra lámina: la semilla siguiente</translation>
    </message>
    <message>
        <source>&amp;Difference:</source>
        <translation>&amp;Diferencia:</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Semilla:</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>Variación %1</translation>
    </message>
    <message>
        <source>Mutate</source>
        <translation>Mutar</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Añadir un fractal al azar</translation>
    </message>
    <message>
        <source>Choose one and press OK, or double-click it: it takes the place of the fractal, as one step that can be undone.</source>
        <translation>Elija una y pulse Aceptar, o haga doble clic en ella: ocupa el lugar del fractal, en un solo paso que se puede deshacer.</translation>
    </message>
    <message>
        <source>To the left the variations are much like what they start from, to the right they are wild.</source>
        <translation>Hacia la izquierda, las variaciones se parecen mucho a su punto de partida; hacia la derecha, se alejan sin freno.</translation>
    </message>
    <message>
        <source>Takes the chosen one, as one step that can be undone.</source>
        <translation>Acepta la elegida, en un solo paso que se puede deshacer.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma. Arrow keys and the wheel change it: with Shift ten times as fast, with Alt a tenth. Esc takes back what was typed.</source>
        <translation>Un número, con punto o coma decimal. Las teclas de flecha y la rueda lo cambian: con Mayús, diez veces más deprisa; con Alt, diez veces más despacio. Esc anula lo escrito.</translation>
    </message>
</context>
<context>
    <name>view::PasteTableDialog</name>
    <message>
        <source>Paste maps</source>
        <translation>Pegar aplicaciones</translation>
    </message>
    <message>
        <source>Paste a Table</source>
        <translation>Pegar una tabla</translation>
    </message>
    <message>
        <source>The rows do not say which column is which, and programs differ. Choose the order in which the picture behind this dialog is the one you expect.</source>
        <translation>Las filas no dicen qué columna es cada una, y los programas difieren. Elija el orden con el que la imagen que está detrás de este diálogo sea la que espera.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Las aplicaciones tal como se pegarán</translation>
    </message>
    <message>
        <source>The maps in the order chosen: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
        <translation>Las aplicaciones en el orden elegido: (x, y) va a (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>What the maps do</source>
        <translation>Lo que hacen las aplicaciones</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Columnas:</translation>
    </message>
    <message>
        <source>There are no rows of 6 or 7 numbers.</source>
        <translation>No hay filas de 6 o 7 números.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
    <message>
        <source>In this order every map contracts.</source>
        <translation>En este orden todas las aplicaciones son contractivas.</translation>
    </message>
    <message>
        <source>In this order these maps do not contract: %1. Perhaps the columns mean something else.</source>
        <translation>En este orden no son contractivas estas aplicaciones: %1. Quizá las columnas significan otra cosa.</translation>
    </message>
    <message>
        <source>Order of the Columns</source>
        <translation>Orden de las columnas</translation>
    </message>
    <message>
        <source>&amp;Use This Order</source>
        <translation>&amp;Usar este orden</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>The language changes when Barycage is started again.</source>
        <translation>El idioma cambia cuando se vuelve a iniciar Barycage.</translation>
    </message>
    <message>
        <source>&amp;Open the files of last time at the start</source>
        <translation>A&amp;brir al inicio los archivos de la última vez</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>That of the desktop</source>
        <translation>El del escritorio</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>The language of menus and messages. Files and numbers are the same in every language.</source>
        <translation>El idioma de los menús y los mensajes. Los archivos y los números son iguales en todos los idiomas.</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Como el escritorio</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>The colours of windows and panels. The picture keeps its own.</source>
        <translation>Los colores de ventanas y paneles. La imagen conserva los suyos.</translation>
    </message>
    <message>
        <source>Draft: 50 million points</source>
        <translation>Borrador: 50 millones de puntos</translation>
    </message>
    <message>
        <source>Good: 200 million points</source>
        <translation>Buena: 200 millones de puntos</translation>
    </message>
    <message>
        <source>Fine: 1000 million points</source>
        <translation>Fina: 1000 millones de puntos</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Imagen en reposo</translation>
    </message>
    <message>
        <source>How many points are drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Cuántos puntos se dibujan mientras nada se mueve. Con más puntos la imagen es más suave y el procesador está ocupado más tiempo.</translation>
    </message>
    <message>
        <source>When on, Barycage opens the files that were open when it was closed, a window each.</source>
        <translation>Si está activado, Barycage abre los archivos que estaban abiertos cuando se cerró, cada uno en una ventana.</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Idioma:</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Tema:</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>Imagen en re&amp;poso:</translation>
    </message>
    <message>
        <source>Puts every choice of this dialog back to what it is at first.</source>
        <translation>Devuelve todas las opciones de este diálogo a su valor inicial.</translation>
    </message>
</context>
<context>
    <name>view::ProblemsModel</name>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Line:column</source>
        <translation>Línea:columna</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Lo que se encontró</translation>
    </message>
</context>
<context>
    <name>view::ProblemsPanel</name>
    <message>
        <source>file</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>Problems found while reading</source>
        <translation>Problemas encontrados al leer</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Choose a line to show the entry it concerns.</source>
        <translation>Elija una línea para mostrar la entrada a la que se refiere.</translation>
    </message>
    <message>
        <source>Number of problems</source>
        <translation>Número de problemas</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selected problems as text.</source>
        <translation>Copiar como texto los problemas seleccionados.</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Seleccionar &amp;todo</translation>
    </message>
    <message>
        <source>Select all problems.</source>
        <translation>Seleccionar todos los problemas.</translation>
    </message>
    <message>
        <source>1 problem was found while reading.</source>
        <translation>Se encontró 1 problema al leer.</translation>
    </message>
    <message numerus="yes">
        <source>%n problems were found while reading.</source>
        <translation>
            <numerusform>Se encontró %n problema al leer.</numerusform>
            <numerusform>Se encontraron %n problemas al leer.</numerusform>
        </translation>
    </message>
    <message>
        <source>What could not be read is kept as it is.</source>
        <translation>Lo que no se pudo leer se conserva tal cual.</translation>
    </message>
    <message>
        <source>Nothing to report: every entry was read.</source>
        <translation>Nada que señalar: se leyeron todas las entradas.</translation>
    </message>
    <message>
        <source>What the reader of the file remarked, with line and column. Double-click a line to go to its entry.</source>
        <translation>Lo que se observó al leer el archivo, con línea y columna. Haga doble clic en una línea para ir a su entrada.</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsDialog</name>
    <message>
        <source>On the canvas</source>
        <translation>En el lienzo</translation>
    </message>
    <message>
        <source>Move a vertex, an edge, the whole cage</source>
        <translation>Mover un vértice, una arista o la jaula entera</translation>
    </message>
    <message>
        <source>drag it</source>
        <translation>arrastrar</translation>
    </message>
    <message>
        <source>Rotate about the pivot</source>
        <translation>Girar en torno al pivote</translation>
    </message>
    <message>
        <source>Ctrl + drag, or the round handle</source>
        <translation>Ctrl + arrastrar, o el tirador redondo</translation>
    </message>
    <message>
        <source>Scale about the pivot</source>
        <translation>Escalar respecto del pivote</translation>
    </message>
    <message>
        <source>Alt + drag, or the square handle</source>
        <translation>Alt + arrastrar, o el tirador cuadrado</translation>
    </message>
    <message>
        <source>Move or scale along one axis, turn in steps of 15°</source>
        <translation>Mover o escalar a lo largo de un eje, girar en pasos de 15°</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Mayús mientras se arrastra</translation>
    </message>
    <message>
        <source>Take the drag back</source>
        <translation>Anular el arrastre</translation>
    </message>
    <message>
        <source>Esc while dragging</source>
        <translation>Esc mientras se arrastra</translation>
    </message>
    <message>
        <source>Next or previous handle</source>
        <translation>Tirador siguiente o anterior</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Mayús+Tab</translation>
    </message>
    <message>
        <source>Nudge the handle</source>
        <translation>Desplazar un poco el tirador</translation>
    </message>
    <message>
        <source>arrow keys; Shift ×10, Alt ×0.1</source>
        <translation>teclas de flecha; Mayús ×10, Alt ×0.1</translation>
    </message>
    <message>
        <source>Leave the canvas</source>
        <translation>Salir del lienzo</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Ampliar o reducir en torno al puntero</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>rueda</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar el plano</translation>
    </message>
    <message>
        <source>middle drag, or Space + drag</source>
        <translation>arrastrar con el botón central, o barra espaciadora + arrastrar</translation>
    </message>
    <message>
        <source>Keyboard and Mouse</source>
        <translation>Teclado y ratón</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Buscar entre los atajos</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Qué hace</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Cómo</translation>
    </message>
    <message>
        <source>Shows only the lines that have these words.</source>
        <translation>Muestra solo las líneas que contienen estas palabras.</translation>
    </message>
    <message>
        <source>What every key and every movement of the mouse does.</source>
        <translation>Lo que hace cada tecla y cada movimiento del ratón.</translation>
    </message>
    <message>
        <source>Shift or Ctrl + click</source>
        <translation>Mayús o Ctrl + clic</translation>
    </message>
    <message>
        <source>Select map 1 … 9, all maps</source>
        <translation>Elegir la aplicación 1 … 9, todas las aplicaciones</translation>
    </message>
    <message>
        <source>Alt + digit, Ctrl+A</source>
        <translation>Alt + cifra, Ctrl+A</translation>
    </message>
    <message>
        <source>A deeper or a larger branch</source>
        <translation>Una rama más profunda o más grande</translation>
    </message>
    <message>
        <source>Shift + wheel, Page Down, Page Up</source>
        <translation>Mayús + rueda, Av Pág, Re Pág</translation>
    </message>
    <message>
        <source>Select the maps, or the vertices, in a rectangle</source>
        <translation>Elegir las aplicaciones, o los vértices, de un rectángulo</translation>
    </message>
    <message>
        <source>drag from the empty canvas; Shift adds</source>
        <translation>arrastrar desde el lienzo vacío; Mayús añade</translation>
    </message>
    <message>
        <source>Select one more map or vertex, or one less</source>
        <translation>Elegir una aplicación o un vértice más, o uno menos</translation>
    </message>
    <message>
        <source>Delete the selected vertices or maps</source>
        <translation>Eliminar los vértices o las aplicaciones elegidos</translation>
    </message>
    <message>
        <source>Insert a vertex on an edge, duplicate the selected maps</source>
        <translation>Insertar un vértice en una arista, duplicar las aplicaciones elegidas</translation>
    </message>
    <message>
        <source>Take the last vertex back while a triangle is defined</source>
        <translation>Retirar el último vértice mientras se define un triángulo</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Choose another stop</source>
        <translation>Elegir otra parada</translation>
    </message>
    <message>
        <source>Page Up, Page Down, Home, End, or Ctrl + Left, Right</source>
        <translation>Re Pág, Av Pág, Inicio, Fin, o Ctrl + Izquierda, Derecha</translation>
    </message>
    <message>
        <source>Move the stop</source>
        <translation>Mover la parada</translation>
    </message>
    <message>
        <source>Left, Right; Shift ×10</source>
        <translation>Izquierda, Derecha; Mayús ×10</translation>
    </message>
    <message>
        <source>Add a stop</source>
        <translation>Añadir una parada</translation>
    </message>
    <message>
        <source>Ins or +, or double-click</source>
        <translation>Ins o +, o doble clic</translation>
    </message>
    <message>
        <source>Delete the stop</source>
        <translation>Eliminar la parada</translation>
    </message>
    <message>
        <source>Del or Backspace</source>
        <translation>Supr o Retroceso</translation>
    </message>
    <message>
        <source>Change the colour of the stop</source>
        <translation>Cambiar el color de la parada</translation>
    </message>
    <message>
        <source>Enter or Space, or double-click it</source>
        <translation>Intro o Espacio, o doble clic en ella</translation>
    </message>
    <message>
        <source>Take the change back</source>
        <translation>Deshacer el cambio</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>On the strip of the gradient</source>
        <translation>En la tira del degradado</translation>
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
        <translation>Transformar con números</translation>
    </message>
    <message>
        <source>x of the fixed point</source>
        <translation>x del punto fijo</translation>
    </message>
    <message>
        <source>y of the fixed point</source>
        <translation>y del punto fijo</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Reflejar</translation>
    </message>
    <message>
        <source>Shear along x</source>
        <translation>Cizalladura a lo largo de x</translation>
    </message>
    <message>
        <source>Scale in x</source>
        <translation>Escala en x</translation>
    </message>
    <message>
        <source>Scale in y</source>
        <translation>Escala en y</translation>
    </message>
    <message>
        <source>Same in x and y</source>
        <translation>Igual en x y en y</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise</source>
        <translation>Giro en grados, en sentido antihorario</translation>
    </message>
    <message>
        <source>Translation in x</source>
        <translation>Traslación en x</translation>
    </message>
    <message>
        <source>Translation in y</source>
        <translation>Traslación en y</translation>
    </message>
    <message>
        <source>Done in this order, from top to bottom.</source>
        <translation>Se aplica en este orden, de arriba abajo.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>Start Again</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>All values as they were when the dialog opened</source>
        <translation>Todos los valores como estaban al abrir el diálogo</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Colocar la imagen</translation>
    </message>
    <message>
        <source>The code stays; the cage moves</source>
        <translation>El código no cambia; la jaula se mueve</translation>
    </message>
    <message>
        <source>Rewrite the code</source>
        <translation>Reescribir el código</translation>
    </message>
    <message>
        <source>Every map w becomes T∘w∘T⁻¹; the cage follows</source>
        <translation>Cada aplicación w se convierte en T∘w∘T⁻¹; la jaula la sigue</translation>
    </message>
    <message>
        <source>The point that stays</source>
        <translation>El punto que no se mueve</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>el origen</translation>
    </message>
    <message>
        <source>the mean of the invariant measure</source>
        <translation>la media de la medida invariante</translation>
    </message>
    <message>
        <source>a typed point</source>
        <translation>un punto dado por sus coordenadas</translation>
    </message>
    <message>
        <source>in the line at the angle °</source>
        <translation>en la recta de ángulo °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Ángulo de la recta de reflexión en grados: 0 es horizontal, 90 vertical</translation>
    </message>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Esta entrada no tiene aplicaciones del plano.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be undone, so it cannot be written into the code. Choose other scales, or place the picture.</source>
        <translation>Esta transformación aplasta tanto que no se puede invertir, así que no se puede escribir en el código. Elija otras escalas o coloque la imagen.</translation>
    </message>
    <message>
        <source>Transform the picture</source>
        <translation>Transformar la imagen</translation>
    </message>
    <message>
        <source>Transform the code</source>
        <translation>Transformar el código</translation>
    </message>
    <message>
        <source>Keeps the factor in y equal to that in x.</source>
        <translation>Mantiene el factor en y igual al factor en x.</translation>
    </message>
    <message>
        <source>About which point the fractal is turned, scaled and reflected: it stays where it is.</source>
        <translation>Respecto de qué punto se gira, se escala y se refleja el fractal: ese punto queda donde está.</translation>
    </message>
    <message>
        <source>Mirrors in a line through the point that stays; the angle is counted from the x axis.</source>
        <translation>Refleja en una recta que pasa por el punto que no se mueve; el ángulo se mide desde el eje x.</translation>
    </message>
    <message>
        <source>Change:</source>
        <translation>Efecto:</translation>
    </message>
    <message>
        <source>About:</source>
        <translation>Respecto de:</translation>
    </message>
    <message>
        <source>Reflect:</source>
        <translation>Reflejar:</translation>
    </message>
    <message>
        <source>Shear:</source>
        <translation>Cizallar:</translation>
    </message>
    <message>
        <source>Scale:</source>
        <translation>Escalar:</translation>
    </message>
    <message>
        <source>Rotate °:</source>
        <translation>Girar °:</translation>
    </message>
    <message>
        <source>Translate:</source>
        <translation>Trasladar:</translation>
    </message>
    <message>
        <source>the middle of the picture’s box</source>
        <translation>el centro del rectángulo de la imagen</translation>
    </message>
</context>
<context>
    <name>view::VertexDialog</name>
    <message>
        <source>Move vertex %1</source>
        <translation>Mover el vértice %1</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Vértice %1</translation>
    </message>
    <message>
        <source>x of the vertex</source>
        <translation>x del vértice</translation>
    </message>
    <message>
        <source>y of the vertex</source>
        <translation>y del vértice</translation>
    </message>
    <message>
        <source>What is wrong with the numbers</source>
        <translation>Qué falla en los números</translation>
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
        <translation>«%1» no es un número. Escríbalo con punto decimal, por ejemplo -0.25.</translation>
    </message>
    <message>
        <source>A coordinate of the vertex, with a decimal point or comma. The picture follows as you type.</source>
        <translation>Una coordenada del vértice, con punto o coma decimal. La imagen sigue lo que usted escribe.</translation>
    </message>
</context>
</TS>
