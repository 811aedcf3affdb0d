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
    <name>ActionDetails</name>
    <message>
        <source>Drag an edge to move both its ends, the inside to move the whole cage. Ctrl rotates, Alt scales, Shift keeps directions. The fractal follows at once, and each drag is one step of the history.</source>
        <translation>Una arista mueve sus dos extremos; el interior, toda la jaula. Ctrl gira, Alt escala, Mayús conserva las direcciones. El fractal sigue al instante y cada arrastre es un paso del historial.</translation>
    </message>
    <message>
        <source>Each map is shown as the image of the cage in its colour. A corner changes one map; the inside moves all selected maps. A drag stops where the attractor would be lost.</source>
        <translation>Cada aplicación se muestra como imagen de la jaula en su color. Un vértice cambia una aplicación; el interior mueve todas las seleccionadas. El arrastre se detiene donde se perdería el atractor.</translation>
    </message>
    <message>
        <source>The picture stays where it is and follows the new triangle from now on. Backspace removes the last point, Esc cancels.</source>
        <translation>La imagen se queda donde está: desde ahora la sujeta el nuevo triángulo. Retroceso quita el último vértice, Esc cancela.</translation>
    </message>
    <message>
        <source>The picture stays where it is. Every point of the fractal then has barycentric coordinates that are not negative.</source>
        <translation>La imagen se queda donde está. Después, cada punto del fractal tiene coordenadas baricéntricas no negativas.</translation>
    </message>
    <message>
        <source>The coefficients do not change. To keep the picture as it is and change the coefficients instead, use Bake.</source>
        <translation>Los coeficientes no cambian. Para conservar la imagen y cambiar los coeficientes, use Incorporar.</translation>
    </message>
    <message>
        <source>Each map w becomes T w T⁻¹, where T is the affine map from the cage at rest to the current cage. The cage is at rest afterwards. A cage that is flat or bends the picture cannot be baked.</source>
        <translation>Cada aplicación w se convierte en T w T⁻¹, donde T es lo que la jaula hace con la imagen. Después, la jaula está en reposo. Una jaula plana o que curva la imagen no se puede incorporar.</translation>
    </message>
    <message>
        <source>The table of maps keeps its numbers, and Bake writes the placement into them later.</source>
        <translation>La tabla de aplicaciones conserva sus números; Incorporar escribe en ellos la colocación más tarde.</translation>
    </message>
    <message>
        <source>The table of maps shows the new numbers during the drag, and the cage is at rest again afterwards.</source>
        <translation>La tabla de aplicaciones muestra los números nuevos durante el arrastre, y después la jaula vuelve a estar en reposo.</translation>
    </message>
    <message>
        <source>The cage is included if that needs little space. The fractal itself does not change.</source>
        <translation>La jaula se incluye cuando ocupa poco espacio. El fractal en sí no cambia.</translation>
    </message>
    <message>
        <source>Only the view is flipped: coefficients and coordinates do not change.</source>
        <translation>Solo se invierte la vista: ni los coeficientes ni las coordenadas cambian.</translation>
    </message>
    <message>
        <source>Press the key again to show the cage, handles, grid, axes and outlines.</source>
        <translation>La jaula, los tiradores, la cuadrícula, los ejes y los contornos vuelven al pulsar otra vez la tecla.</translation>
    </message>
    <message>
        <source>A bar appears under the canvas: choose the number of steps, or let the chaos game run point by point at any speed.</source>
        <translation>Aparece una barra bajo el lienzo: elija el número de pasos o deje correr el juego del caos punto por punto a cualquier velocidad.</translation>
    </message>
    <message>
        <source>As a placement, it leaves the coefficients unchanged; as code, it replaces them by those of the transformed fractal. The canvas shows the result before you accept it.</source>
        <translation>Como colocación, los coeficientes no cambian; como código, pasan a ser los del fractal transformado. El lienzo muestra el resultado antes de aceptarlo.</translation>
    </message>
    <message>
        <source>A new language takes effect at the next start; everything else at once, in all windows.</source>
        <translation>Un idioma nuevo se aplica al volver a iniciar; todo lo demás, enseguida y en todas las ventanas.</translation>
    </message>
    <message>
        <source>Choose a motion, which needs no keys, or set keys. A change to something that has keys sets a key at the playhead; any other change applies to the whole animation.</source>
        <translation>Elija un movimiento que no necesita claves o cree claves: lo que tiene claves recibe otra allí donde lo cambie; lo que no tiene ninguna cambia para toda la animación.</translation>
    </message>
    <message>
        <source>If a table does not name its columns, you are asked for their order. In the Maps panel, Paste adds the copied maps, or rows of numbers, to the fractal.</source>
        <translation>Si una tabla no nombra sus columnas, se le pregunta el orden. En el panel Aplicaciones, Pegar añade al fractal las aplicaciones copiadas o las filas de números.</translation>
    </message>
    <message>
        <source>Acts on maps while the table of maps, or the canvas with the Maps tool, has the focus, and on entries while the list of entries has it.</source>
        <translation>Decide lo que tiene el foco: la tabla de aplicaciones y el lienzo con la herramienta de aplicaciones mueven aplicaciones; la lista de entradas, entradas.</translation>
    </message>
    <message>
        <source>Maps are copied with their names and as rows of numbers, entries as .ifs text that other programs can read.</source>
        <translation>Las aplicaciones se copian con sus nombres y como filas de números; las entradas, como texto .ifs que otros programas pueden leer.</translation>
    </message>
    <message>
        <source>A locked map cannot be edited in the table, dragged, nudged, arranged, fitted or deleted. Changes to the whole fractal, such as a cage that rewrites the code, also change its locked maps.</source>
        <translation>Una aplicación bloqueada no se puede sobrescribir, arrastrar, empujar, ordenar, ajustar ni eliminar. Lo que cambia todo el fractal, como una jaula que reescribe el código, cambia también sus aplicaciones bloqueadas.</translation>
    </message>
    <message>
        <source>Draws only the part of the attractor that this map makes. The file does not change. If you select another entry, its whole attractor is shown.</source>
        <translation>Solo se dibuja la parte del atractor que produce la aplicación. El archivo no cambia, y otra entrada se muestra de nuevo entera.</translation>
    </message>
    <message>
        <source>Shift + wheel chooses how deep the branch is. The bar under the canvas says what the drag changes: a new map for this branch, the last map of its address, only this branch, or this branch and the same one inside it.</source>
        <translation>Mayús + rueda elige la profundidad de la rama. La barra bajo el lienzo dice qué cambia el arrastre: una aplicación nueva para esta rama, la última aplicación de su dirección, solo esta rama, o esta rama y la misma dentro de ella.</translation>
    </message>
    <message>
        <source>The spacing of its lines follows the zoom. Vertices snap to it if this is chosen under View › Canvas › Snap To.</source>
        <translation>La separación de sus líneas sigue al zoom. Los vértices se ajustan a ella si así se elige en Ver › Lienzo › Enganchar a.</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Atractor</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Contracción</translation>
    </message>
    <message>
        <source>‖A‖ of each active map: the largest factor by which it stretches distances.</source>
        <translation>‖A‖ de cada aplicación que interviene: el mayor factor con que alarga las distancias.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rectángulo</translation>
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
        <source>Covariance</source>
        <translation>Covarianza</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Puntos fijos</translation>
    </message>
    <message>
        <source>The point that each map leaves unchanged; it belongs to the attractor.</source>
        <translation>El punto que cada aplicación deja donde está; pertenece al atractor.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Dimensión de afinidad</translation>
    </message>
    <message>
        <source>Falconer’s dimension, at most 2: the exponent at which the sum of the singular value functions of all words of one length neither grows nor shrinks as the words get longer. It is an upper bound for the box-counting dimension, and equal to it for almost all translations if the maps contract enough.</source>
        <translation>La dimensión de Falconer: donde la suma de las funciones de valores singulares de todas las palabras de una longitud ni crece ni decrece, a lo sumo 2. Una cota superior de la dimensión por conteo de cajas, igual a ella para casi todas las traslaciones si las aplicaciones contraen lo suficiente.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Dimensión por conteo de cajas</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Área de la envolvente</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Vértices de la envolvente</translation>
    </message>
    <message>
        <source>Vertices of the computed hull; each is a point of the attractor. If the exact hull has infinitely many, as many are computed as the tolerance requires.</source>
        <translation>Vértices de la envolvente convexa hallados, cada uno un punto del atractor. Una envolvente con infinitos tiene tantos como pide su tolerancia.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Cota de error de la envolvente</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polygon; certified.</source>
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
        <source>Separation</source>
        <translation>Separación</translation>
    </message>
    <message>
        <source>Whether the pieces that the maps make of the attractor are disjoint (strong separation, proved by disjoint covers), or words of maps coincide, so that the open set condition fails.</source>
        <translation>Si las piezas que las aplicaciones hacen del atractor son disjuntas (separación fuerte, demostrada con recubrimientos disjuntos) o coinciden palabras de aplicaciones, de modo que no se cumple la condición del conjunto abierto.</translation>
    </message>
    <message>
        <source>Connectedness</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Overlaps</source>
        <translation>Solapamientos</translation>
    </message>
    <message>
        <source>Different words that compose to the same map, neither a prefix of the other: their pieces coincide.</source>
        <translation>Palabras de aplicaciones que son una misma aplicación, sin que ninguna sea el comienzo de la otra: sus piezas coinciden.</translation>
    </message>
    <message>
        <source>Joint spectral radius</source>
        <translation>Radio espectral conjunto</translation>
    </message>
    <message>
        <source>Entropy</source>
        <translation>Entropía</translation>
    </message>
    <message>
        <source>−Σ pᵢ ln pᵢ: the uncertainty of one step of the chaos game, in nats.</source>
        <translation>−Σ pᵢ ln pᵢ: cuánto deja abierto un paso del juego del caos, en nats.</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Exponente de Liapunov</translation>
    </message>
    <message>
        <source>Σ pᵢ ln sᵢ: how the logarithm of a distance changes per step of the chaos game, if all maps are similarities in some coordinates.</source>
        <translation>Σ pᵢ ln sᵢ: cómo cambia el logaritmo de una distancia en cada paso del juego del caos, si todas las aplicaciones son semejanzas en algunas coordenadas.</translation>
    </message>
    <message>
        <source>Dimension of the measure</source>
        <translation>Dimensión de la medida</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 2: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>La entropía dividida por menos el exponente de Liapunov, como mucho 2: la dimensión de la medida invariante bajo la condición del conjunto abierto y, si no, una cota superior.</translation>
    </message>
    <message>
        <source>The number D with Σ sᵢᴰ = 1, where sᵢ are the ratios of the maps, if all maps are similarities in some coordinates. It is the dimension of the attractor under the open set condition, and an upper bound for it otherwise.</source>
        <translation>El número D con Σ sᵢᴰ = 1, donde sᵢ son las razones de las aplicaciones, si todas son semejanzas en algunas coordenadas. Es la dimensión del atractor bajo la condición del conjunto abierto y, si no, una cota superior.</translation>
    </message>
    <message>
        <source>Slope of the least-squares line of ln N against ln 1/ε, where N is the number of boxes of side ε that meet the attractor, over the sizes where it is most stable. This is an estimate: the uncertainty is the difference between parts of that range, not a proven bound.</source>
        <translation>Pendiente de la recta de mínimos cuadrados de ln N frente a ln 1/ε, donde N es el número de cajas de lado ε que tocan el atractor, en los tamaños en que es más constante. Es una estimación; la incertidumbre sale de cuánto difieren partes de ese intervalo, y no es una demostración.</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved without sampling: the centre of mass of the picture.</source>
        <translation>Media de la medida invariante, calculada sin muestreo: el centro de masa de la imagen.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved without sampling: how far the picture spreads. A uniform mass on the ellipse has the same mean and covariance.</source>
        <translation>Covarianza xx, xy, yy de la medida invariante, calculada sin muestreo: cuánto se extiende la imagen. Una masa uniforme que llena la elipse tiene la misma media y covarianza.</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that contains the attractor; certified. Each side is off by at most the error.</source>
        <translation>El menor rectángulo de lados paralelos a los ejes que contiene el atractor; certificado. Sus lados se desvían como mucho en el error.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>El menor triángulo rectángulo isósceles de catetos paralelos a los ejes que contiene el atractor; certificado. Los signos dan las direcciones de sus catetos. Para un solo punto, el cateto es 1.</translation>
    </message>
    <message>
        <source>Area of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most its perimeter times the error bound e, and πe² for the corners.</source>
        <translation>Área de la envolvente calculada, cuyos vértices son puntos del atractor. La envolvente convexa exacta es mayor como mucho en su perímetro por la cota de error e, y πe² por las esquinas.</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 3: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Entropía dividida por menos el exponente de Liapunov, como mucho 3: la dimensión de la medida invariante bajo la condición del conjunto abierto, y si no, una cota superior.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, xz, yy, yz, zz of the invariant measure, solved without sampling: how far the picture spreads.</source>
        <translation>Covarianza xx, xy, xz, yy, yz, zz de la medida invariante, resuelta sin muestreo: cuánto se extiende la imagen.</translation>
    </message>
    <message>
        <source>Box</source>
        <comment>in space</comment>
        <translation>Caja</translation>
    </message>
    <message>
        <source>The smallest box with edges parallel to the axes that contains the attractor, to the error bound.</source>
        <translation>La menor caja de aristas paralelas a los ejes que contiene el atractor, salvo la cota de error.</translation>
    </message>
    <message>
        <source>Box error bound</source>
        <translation>Cota de error de la caja</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the box; certified.</source>
        <translation>El atractor sobresale de la caja a lo sumo esta distancia; certificado.</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>El menor tetraedro con tres catetos iguales paralelos a los ejes que contiene el atractor; certificado. Los signos dan las direcciones de sus catetos. Para un solo punto, el cateto es 1.</translation>
    </message>
    <message>
        <source>Hull volume</source>
        <translation>Volumen de la envolvente</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polyhedron; certified.</source>
        <translation>El atractor sobresale del poliedro a lo sumo esta distancia; certificado.</translation>
    </message>
    <message>
        <source>Tile area</source>
        <translation>Área de la tesela</translation>
    </message>
    <message>
        <source>Boundary dimension</source>
        <translation>Dimensión de la frontera</translation>
    </message>
    <message>
        <source>Dimension of the boundary, if all maps are similarities of one ratio whose pieces fill an area and meet in finitely many ways: from the growth of the number of contacts.</source>
        <translation>Dimensión de la frontera si todas las aplicaciones son semejanzas de una misma razón cuyas piezas llenan un área y se tocan de un número finito de maneras: a partir del crecimiento del número de contactos.</translation>
    </message>
    <message>
        <source>Moran equation</source>
        <translation>Ecuación de Moran</translation>
    </message>
    <message>
        <source>Σ sᵢᴰ = 1 with the ratios of these maps, equal ratios combined. Its solution is the similarity dimension.</source>
        <translation>Σ sᵢᴰ = 1 con las razones de estas aplicaciones, agrupando las iguales. Su solución es la dimensión de semejanza.</translation>
    </message>
    <message>
        <source>A compact set to which the iterates of every compact set converge. A system has one if and only if its maps contract in some norm.</source>
        <translation>Un conjunto compacto al que lleva, paso a paso, todo conjunto compacto inicial. Un sistema lo tiene si y solo si sus aplicaciones contraen en alguna norma.</translation>
    </message>
    <message>
        <source>An attractor is connected if and only if its pieces are joined by common points (Hata). Common points are looked for among fixed points of short words, and their absence is proved by disjoint covers.</source>
        <translation>Un atractor es conexo si y solo si puntos comunes unen sus piezas (Hata). Los puntos comunes se buscan entre los puntos fijos de palabras cortas; que no los hay se demuestra con recubrimientos disjuntos.</translation>
    </message>
    <message>
        <source>The largest factor per map by which long words stretch. Both ends of the interval are proved; a system contracts in some norm if and only if it is less than 1.</source>
        <translation>El mayor factor por aplicación con que estiran las palabras largas. Los dos extremos del intervalo están demostrados; un sistema contrae en alguna norma si y solo si es menor que 1.</translation>
    </message>
    <message>
        <source>Volume of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most the error.</source>
        <translation>Volumen de la envolvente calculada, cuyos vértices son puntos del atractor. La envolvente convexa exacta es mayor como mucho en el error.</translation>
    </message>
    <message>
        <source>There is no value, because it is not proved that there is an attractor.</source>
        <translation>No hay valor, porque no está demostrado que exista un atractor.</translation>
    </message>
    <message>
        <source>There is no value, because there is no attractor.</source>
        <translation>No hay valor, porque no hay atractor.</translation>
    </message>
    <message>
        <source>There is no value: for these maps, none could be computed.</source>
        <translation>No hay valor: para estas aplicaciones no se pudo calcular ninguno.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not all similarities in the same coordinates.</source>
        <translation>No hay valor, porque no todas estas aplicaciones son semejanzas en las mismas coordenadas.</translation>
    </message>
    <message>
        <source>No overlaps were found.</source>
        <translation>No se encontraron solapamientos.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not of this kind.</source>
        <translation>No hay valor, porque estas aplicaciones no son de este tipo.</translation>
    </message>
    <message>
        <source>There is no value, because the maps are linked: the equation is another.</source>
        <translation>No hay valor, porque las aplicaciones están enlazadas: la ecuación es otra.</translation>
    </message>
    <message>
        <source>There is no value, because the maps contract by too little to bound it.</source>
        <translation>No hay valor, porque las aplicaciones contraen demasiado poco para acotarlo.</translation>
    </message>
    <message>
        <source>Open set condition</source>
        <translation>Condición del conjunto abierto</translation>
    </message>
    <message>
        <source>Whether there is an open set with disjoint images in it. It is proved where the pieces are disjoint, where an area of the attractor is, and where the neighbours of pieces of one size are finitely many, and none of them coincides with its neighbour.</source>
        <translation>Si existe un conjunto abierto que contiene sus imágenes y cuyas imágenes son disjuntas. Queda demostrado cuando las piezas son disjuntas, cuando está demostrado que el atractor tiene área, y cuando las piezas de un mismo tamaño tienen un número finito de vecinas y ninguna coincide con su vecina.</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Dimensión de Hausdorff</translation>
    </message>
    <message>
        <source>Dimension of the attractor, where it is proved: the similarity dimension under the open set condition; or, where pieces coincide and there are finitely many neighbours, by the growth of the number of different maps.</source>
        <translation>Dimensión del atractor, donde está demostrada: la dimensión de semejanza si se cumple la condición del conjunto abierto; o bien, si hay piezas que coinciden y un número finito de vecinas, a partir del crecimiento del número de aplicaciones distintas.</translation>
    </message>
    <message>
        <source>There is no value: it is not known how much the pieces overlap, or the maps are no similarities.</source>
        <translation>No hay valor: no se sabe cuánto se solapan las piezas, o las aplicaciones no son semejanzas.</translation>
    </message>
    <message>
        <source>Area of the attractor, if its copies, moved by a lattice and turned by a few turns, cover the plane equally often; proved by the contacts of the copies, or by counting those that hold a point.</source>
        <translation>Área del atractor si sus copias, trasladadas según una red y giradas por unos pocos giros, cubren el plano el mismo número de veces en todas partes; demostrada por los contactos de las copias o contando las que contienen un punto.</translation>
    </message>
    <message>
        <source>There is no value: it is not proved that copies of the attractor cover the plane in this way.</source>
        <translation>No hay valor: no está demostrado que las copias del atractor cubran el plano de esta manera.</translation>
    </message>
    <message>
        <source>%1 (approximation)</source>
        <translation>%1 (aproximación)</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Grab a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Tome un fractal por sus esquinas: un editor de sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>.ifs files to open, each in its own window</source>
        <translation>archivos .ifs que se abren, cada uno en una ventana</translation>
    </message>
    <message>
        <source>start with the maple instead of the last session</source>
        <translation>empezar con el arce en lugar de la última sesión</translation>
    </message>
    <message>
        <source>open a window with the collection</source>
        <translation>abrir una ventana con la colección</translation>
    </message>
    <message>
        <source>open a window with random fractals to choose from</source>
        <translation>abrir una ventana con fractales al azar para elegir</translation>
    </message>
    <message>
        <source>draw the maple to a PNG file instead; needs no display</source>
        <translation>dibujar en su lugar el arce en un archivo PNG; no necesita pantalla</translation>
    </message>
    <message>
        <source>The system does not let Barycage start another thread. Close other programs, or raise the limit on processes, and try again.</source>
        <translation>El sistema no permite que Barycage inicie otro hilo. Cierre otros programas o aumente el límite de procesos, e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>No hay memoria suficiente para esto.</translation>
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
        <source>Fronds: one large map climbs the rachis, two small ones attach the pinnae, and a flat one draws the stem.</source>
        <translation>Frondas: una aplicación grande sube por el raquis, dos pequeñas añaden las pinnas y una plana traza el tallo.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Árboles</translation>
    </message>
    <message>
        <source>Forking trunks: the branches of the tree are copies of the whole tree.</source>
        <translation>Troncos que se bifurcan: las ramas del árbol son copias del árbol entero.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Dragones</translation>
    </message>
    <message>
        <source>Paper-folding curves, and fractals of two or three rotating similarities.</source>
        <translation>Curvas de papel plegado y fractales de dos o tres semejanzas con giro.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Familia de Sierpiński</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon made of smaller copies of itself, with holes between them.</source>
        <translation>Triángulos y alfombras: un polígono formado por copias más pequeñas de sí mismo, con agujeros entre ellas.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Familia de Koch</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment again and again, and the islands they enclose.</source>
        <translation>Curvas que nacen de sustituir un segmento una y otra vez, y las islas que encierran.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Espirales</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small maps that set beads along its path.</source>
        <translation>Una aplicación que gira y reduce un poco, y otras pequeñas que ponen cuentas en su camino.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Hojas y flores</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are rotated copies of one another.</source>
        <translation>Contornos de hojas, y flores cuyos pétalos son copias giradas unos de otros.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Teselas y reptiles</translation>
    </message>
    <message>
        <source>Sets that tile the plane: rep-tiles, which are made of copies of themselves, and the central tiles of number systems.</source>
        <translation>Conjuntos que teselan el plano: «rep-tiles», formados por copias de sí mismos, y las teselas centrales de los sistemas de numeración.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Conjuntos de Cantor y polvo</translation>
    </message>
    <message>
        <source>Sets with gaps at every scale: the points crowd together, but hardly any are connected.</source>
        <translation>Conjuntos con huecos a toda escala: los puntos se apiñan, pero casi ninguno está unido a otro.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Cristales y copos de nieve</translation>
    </message>
    <message>
        <source>Sets with the symmetry of snow crystals: five, six and more arms.</source>
        <translation>Conjuntos con la simetría de los cristales de nieve: cinco, seis y más brazos.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Curvas y gráficas</translation>
    </message>
    <message>
        <source>Graphs of unusual functions, smooth curves as attractors, and coordinates of space-filling curves.</source>
        <translation>Gráficas de funciones poco comunes, curvas suaves como atractores y coordenadas de curvas que llenan el plano.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Abstractos</translation>
    </message>
    <message>
        <source>Affine patterns with no counterpart in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Motivos afines sin equivalente en la naturaleza: parientes del triángulo de Sierpiński, tejidos, rosetones.</translation>
    </message>
    <message>
        <source>Polyhedra in space</source>
        <translation>Poliedros en el espacio</translation>
    </message>
    <message>
        <source>A polyhedron made of smaller copies of itself, one at each corner.</source>
        <translation>Un poliedro formado por copias más pequeñas de sí mismo, una en cada vértice.</translation>
    </message>
    <message>
        <source>Sponges and cubes in space</source>
        <translation>Esponjas y cubos en el espacio</translation>
    </message>
    <message>
        <source>Cubes divided into smaller cubes, some of which are left out or turned.</source>
        <translation>Cubos divididos en cubos más pequeños, algunos de los cuales se omiten o se giran.</translation>
    </message>
    <message>
        <source>Plants in space</source>
        <translation>Plantas en el espacio</translation>
    </message>
    <message>
        <source>Fronds and trees with branches all around the stem.</source>
        <translation>Frondas y árboles con ramas todo alrededor del tallo.</translation>
    </message>
    <message>
        <source>Shells and corals in space</source>
        <translation>Conchas y corales en el espacio</translation>
    </message>
    <message>
        <source>Helical shells, cones arranged by the golden angle, and corals with thick branches.</source>
        <translation>Conchas helicoidales, conos dispuestos según el ángulo áureo y corales de ramas gruesas.</translation>
    </message>
    <message>
        <source>Dragons in space</source>
        <translation>Dragones en el espacio</translation>
    </message>
    <message>
        <source>Folded surfaces, and polyhedra whose copies are turned.</source>
        <translation>Superficies plegadas y poliedros cuyas copias están giradas.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>Fractals that move: wind, folding, growing, morphs, endless zooms, and flights in space.</source>
        <translation>Fractales que se mueven: viento, plegado, crecimiento, metamorfosis, acercamientos sin fin y vuelos en el espacio.</translation>
    </message>
    <message>
        <source>Linked maps</source>
        <translation>Aplicaciones enlazadas</translation>
    </message>
    <message>
        <source>Maps that may follow only certain maps: Penrose tiles, boundaries, and chaos games with rules.</source>
        <translation>Aplicaciones que solo pueden seguir a algunas: teselas de Penrose, fronteras y juegos del caos con reglas.</translation>
    </message>
    <message>
        <source>Fractal transformations</source>
        <translation>Transformaciones fractales</translation>
    </message>
    <message>
        <source>Fractals coloured by a picture on another fractal; a double click opens both side by side.</source>
        <translation>Fractales con los colores de una imagen sobre otro; un doble clic abre los dos lado a lado.</translation>
    </message>
</context>
<context>
    <name>CollectionNames</name>
    <message>
        <source>Maple</source>
        <translation>Arce</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Flor</translation>
    </message>
    <message>
        <source>Maple in the wind</source>
        <translation>Arce al viento</translation>
    </message>
    <message>
        <source>Fern that unrolls</source>
        <translation>Helecho que se desenrolla</translation>
    </message>
    <message>
        <source>Paper strip that folds to a dragon</source>
        <translation>Tira de papel que se pliega en dragón</translation>
    </message>
    <message>
        <source>Koch curve that grows spikes</source>
        <translation>Curva de Koch a la que le crecen púas</translation>
    </message>
    <message>
        <source>Zoom into a flake without end</source>
        <translation>Acercamiento sin fin a un copo</translation>
    </message>
    <message>
        <source>Walk through a weaving flower</source>
        <translation>Paseo por una flor que se mece</translation>
    </message>
    <message>
        <source>Tree in a storm</source>
        <translation>Árbol en la tormenta</translation>
    </message>
    <message>
        <source>Sea fan in the swell</source>
        <translation>Gorgonia en el oleaje</translation>
    </message>
    <message>
        <source>Bracts that breathe</source>
        <translation>Brácteas que respiran</translation>
    </message>
    <message>
        <source>Pentagons that turn in place</source>
        <translation>Pentágonos que giran en su sitio</translation>
    </message>
    <message>
        <source>Menger sponge that turns</source>
        <translation>Esponja de Menger que gira</translation>
    </message>
    <message>
        <source>Flight into the Menger sponge</source>
        <translation>Vuelo al interior de la esponja de Menger</translation>
    </message>
    <message>
        <source>Tree in space that sways</source>
        <translation>Árbol en el espacio que se mece</translation>
    </message>
    <message>
        <source>Snow star that becomes a fern of ice</source>
        <translation>Estrella de nieve que se vuelve helecho de hielo</translation>
    </message>
    <message>
        <source>Maple that becomes a fern</source>
        <translation>Arce que se vuelve helecho</translation>
    </message>
    <message>
        <source>Black spleenwort fern</source>
        <translation>Culantrillo negro</translation>
    </message>
    <message>
        <source>Maiden fern</source>
        <translation>Helecho de pantano</translation>
    </message>
    <message>
        <source>Culcita fern</source>
        <translation>Helecho de colchonero</translation>
    </message>
    <message>
        <source>Fishbone fern</source>
        <translation>Helecho espada</translation>
    </message>
    <message>
        <source>Fiddlehead: a frond still curled</source>
        <translation>Báculo: una fronda aún enrollada</translation>
    </message>
    <message>
        <source>Bracken: opposite pinnae at the same height</source>
        <translation>Helecho águila: pinnas opuestas a la misma altura</translation>
    </message>
    <message>
        <source>Lady fern: alternate pinnae, a nodding tip</source>
        <translation>Helecho hembra: pinnas alternas y punta inclinada</translation>
    </message>
    <message>
        <source>Maidenhair: a fan on a fine stalk</source>
        <translation>Culantrillo: un abanico sobre un tallo fino</translation>
    </message>
    <message>
        <source>Ostrich fern: a shuttlecock plume</source>
        <translation>Helecho avestruz: un penacho en forma de volante</translation>
    </message>
    <message>
        <source>Golden fern: pinnae smaller by the golden ratio squared</source>
        <translation>Helecho áureo: pinnas reducidas según el cuadrado del número áureo</translation>
    </message>
    <message>
        <source>Moss: a frond of frond-like feathers</source>
        <translation>Musgo: una fronda de plumas que parecen frondas</translation>
    </message>
    <message>
        <source>Fractal tree</source>
        <translation>Árbol fractal</translation>
    </message>
    <message>
        <source>Golden tree: branches of 1/phi at 60 degrees, just touching</source>
        <translation>Árbol áureo: ramas de razón 1/φ a 60° que llegan justo a tocarse</translation>
    </message>
    <message>
        <source>Stone pine: an umbrella of three boughs</source>
        <translation>Pino piñonero: una sombrilla de tres ramas</translation>
    </message>
    <message>
        <source>Spruce: whorls of drooping boughs</source>
        <translation>Pícea: verticilos de ramas colgantes</translation>
    </message>
    <message>
        <source>Willow: branches that bend down</source>
        <translation>Sauce: ramas que se inclinan</translation>
    </message>
    <message>
        <source>Tree in the wind</source>
        <translation>Árbol al viento</translation>
    </message>
    <message>
        <source>Bonsai pine: flat cushions on a leaning trunk</source>
        <translation>Pino bonsái: cojines planos sobre un tronco inclinado</translation>
    </message>
    <message>
        <source>Cypress</source>
        <translation>Ciprés</translation>
    </message>
    <message>
        <source>Thorn bush: alternate twigs</source>
        <translation>Espino: ramitas alternas</translation>
    </message>
    <message>
        <source>Poplar: narrow and steep</source>
        <translation>Álamo: estrecho y empinado</translation>
    </message>
    <message>
        <source>Ternary tree: three halves, drawn with their branches</source>
        <translation>Árbol ternario: tres mitades dibujadas con sus ramas</translation>
    </message>
    <message>
        <source>Branching coral</source>
        <translation>Coral ramificado</translation>
    </message>
    <message>
        <source>H-tree: right angles all the way</source>
        <translation>Árbol H: todo en ángulos rectos</translation>
    </message>
    <message>
        <source>Heighway dragon</source>
        <translation>Dragón de Heighway</translation>
    </message>
    <message>
        <source>Twindragon</source>
        <translation>Dragón gemelo</translation>
    </message>
    <message>
        <source>Levy dragon (C curve)</source>
        <translation>Dragón de Lévy (curva C)</translation>
    </message>
    <message>
        <source>Terdragon</source>
        <translation>Terdragón</translation>
    </message>
    <message>
        <source>Golden dragon</source>
        <translation>Dragón áureo</translation>
    </message>
    <message>
        <source>Tame twindragon</source>
        <translation>Dragón gemelo manso</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 100 degrees only</source>
        <translation>Curva del dragón desplegada solo hasta 100°</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 115 degrees</source>
        <translation>Curva del dragón desplegada hasta 115°</translation>
    </message>
    <message>
        <source>C curve on triangles of 100 degrees</source>
        <translation>Curva C sobre triángulos de 100°</translation>
    </message>
    <message>
        <source>Z dragon: the three strokes of a Z</source>
        <translation>Dragón Z: los tres trazos de una Z</translation>
    </message>
    <message>
        <source>Sierpinski triangle</source>
        <translation>Triángulo de Sierpiński</translation>
    </message>
    <message>
        <source>Right-angled Sierpinski triangle</source>
        <translation>Triángulo rectángulo de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski carpet</source>
        <translation>Alfombra de Sierpiński</translation>
    </message>
    <message>
        <source>Vicsek fractal (saltire)</source>
        <translation>Fractal de Vicsek (aspa)</translation>
    </message>
    <message>
        <source>Vicsek fractal (cross)</source>
        <translation>Fractal de Vicsek (cruz)</translation>
    </message>
    <message>
        <source>Sierpinski pentagon</source>
        <translation>Pentágono de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski hexagon</source>
        <translation>Hexágono de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski heptagon</source>
        <translation>Heptágono de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski octagon</source>
        <translation>Octógono de Sierpiński</translation>
    </message>
    <message>
        <source>Sierpinski dodecagon</source>
        <translation>Dodecágono de Sierpiński</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 3</source>
        <translation>Triángulo de Pascal módulo 3</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 5</source>
        <translation>Triángulo de Pascal módulo 5</translation>
    </message>
    <message>
        <source>Sierpinski pedal triangle</source>
        <translation>Triángulo órtico de Sierpiński</translation>
    </message>
    <message>
        <source>Bedford-McMullen carpet</source>
        <translation>Alfombra de Bedford-McMullen</translation>
    </message>
    <message>
        <source>Bedford-McMullen weave of 3 by 5 cells</source>
        <translation>Tejido de Bedford-McMullen de 3 por 5 celdas</translation>
    </message>
    <message>
        <source>Carpet of fifths with a cross-shaped hole</source>
        <translation>Alfombra de quintos con un agujero en cruz</translation>
    </message>
    <message>
        <source>Carpet of quarters with a square hole</source>
        <translation>Alfombra de cuartos con un agujero cuadrado</translation>
    </message>
    <message>
        <source>Checkered carpet</source>
        <translation>Alfombra ajedrezada</translation>
    </message>
    <message>
        <source>Koch curve</source>
        <translation>Curva de Koch</translation>
    </message>
    <message>
        <source>Koch snowflake, filled</source>
        <translation>Copo de nieve de Koch, relleno</translation>
    </message>
    <message>
        <source>Cesaro curve of 85 degrees</source>
        <translation>Curva de Cesàro de 85°</translation>
    </message>
    <message>
        <source>Quadratic Koch curve of five edges</source>
        <translation>Curva de Koch cuadrática de cinco segmentos</translation>
    </message>
    <message>
        <source>Minkowski sausage</source>
        <translation>Salchicha de Minkowski</translation>
    </message>
    <message>
        <source>Mandelbrot-Given curve</source>
        <translation>Curva de Mandelbrot-Given</translation>
    </message>
    <message>
        <source>Ice fractal on a square</source>
        <translation>Fractal de hielo sobre un cuadrado</translation>
    </message>
    <message>
        <source>Ice fractal with a pair of spikes</source>
        <translation>Fractal de hielo con un par de púas</translation>
    </message>
    <message>
        <source>Koch curve drawn on both sides</source>
        <translation>Curva de Koch por ambos lados</translation>
    </message>
    <message>
        <source>Koch curve with peaks turned inwards</source>
        <translation>Curva de Koch con picos hacia dentro</translation>
    </message>
    <message>
        <source>Pentigree</source>
        <translation>Pentigree</translation>
    </message>
    <message>
        <source>Pentadendrite</source>
        <translation>Pentadendrita</translation>
    </message>
    <message>
        <source>Edge of the Gosper island</source>
        <translation>Borde de la isla de Gosper</translation>
    </message>
    <message>
        <source>Spiral of spirals</source>
        <translation>Espiral de espirales</translation>
    </message>
    <message>
        <source>Swirl</source>
        <translation>Remolino</translation>
    </message>
    <message>
        <source>Galaxy with two arms</source>
        <translation>Galaxia de dos brazos</translation>
    </message>
    <message>
        <source>Whorl of three-fold rosettes</source>
        <translation>Verticilo de rosetones triples</translation>
    </message>
    <message>
        <source>Ram&apos;s horn</source>
        <translation>Cuerno de carnero</translation>
    </message>
    <message>
        <source>Whirl of pentagons</source>
        <translation>Torbellino de pentágonos</translation>
    </message>
    <message>
        <source>Double spiral between two eyes</source>
        <translation>Espiral doble entre dos ojos</translation>
    </message>
    <message>
        <source>Spiral of feathers</source>
        <translation>Espiral de plumas</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a golden spiral</source>
        <translation>Nautilo: cámaras a lo largo de una espiral áurea</translation>
    </message>
    <message>
        <source>Sunflower: seeds at the golden angle</source>
        <translation>Girasol: semillas según el ángulo áureo</translation>
    </message>
    <message>
        <source>Shell: ribs that follow the turn</source>
        <translation>Concha: costillas que siguen el giro</translation>
    </message>
    <message>
        <source>Three spirals passing into one another</source>
        <translation>Tres espirales que pasan de una a otra</translation>
    </message>
    <message>
        <source>Maple leaf</source>
        <translation>Hoja de arce</translation>
    </message>
    <message>
        <source>Pointed leaf</source>
        <translation>Hoja puntiaguda</translation>
    </message>
    <message>
        <source>Poinsettia: five bracts</source>
        <translation>Flor de Pascua: cinco brácteas</translation>
    </message>
    <message>
        <source>Edelweiss: eight woolly rays</source>
        <translation>Edelweiss: ocho radios lanosos</translation>
    </message>
    <message>
        <source>Lily of six petals</source>
        <translation>Azucena de seis pétalos</translation>
    </message>
    <message>
        <source>Oak leaf</source>
        <translation>Hoja de roble</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Pluma</translation>
    </message>
    <message>
        <source>Plane-tree leaf: five blades from one root</source>
        <translation>Hoja de plátano de sombra: cinco lóbulos de una misma base</translation>
    </message>
    <message>
        <source>Dill umbel</source>
        <translation>Umbela de eneldo</translation>
    </message>
    <message>
        <source>Thistle head</source>
        <translation>Cabezuela de cardo</translation>
    </message>
    <message>
        <source>Dandelion clock</source>
        <translation>Vilano de diente de león</translation>
    </message>
    <message>
        <source>Marigold: rings of petals</source>
        <translation>Caléndula: anillos de pétalos</translation>
    </message>
    <message>
        <source>Ear of wheat</source>
        <translation>Espiga de trigo</translation>
    </message>
    <message>
        <source>Chair rep-tile (L tromino)</source>
        <translation>Rep-tile de la silla (tromino en L)</translation>
    </message>
    <message>
        <source>Golden bee (Ammann&apos;s chair)</source>
        <translation>Abeja áurea (silla de Ammann)</translation>
    </message>
    <message>
        <source>Gosper island</source>
        <translation>Isla de Gosper</translation>
    </message>
    <message>
        <source>Quintet</source>
        <translation>Quinteto</translation>
    </message>
    <message>
        <source>Eisenstein fractal</source>
        <translation>Fractal de Eisenstein</translation>
    </message>
    <message>
        <source>Rauzy fractal (tribonacci)</source>
        <translation>Fractal de Rauzy (tribonacci)</translation>
    </message>
    <message>
        <source>Hokkaido tile</source>
        <translation>Tesela de Hokkaido</translation>
    </message>
    <message>
        <source>Tile of Narayana&apos;s cows</source>
        <translation>Tesela de las vacas de Narayana</translation>
    </message>
    <message>
        <source>Tile of x^2 + x + 3</source>
        <translation>Tesela de x² + x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 3</source>
        <translation>Tesela de x² + 2x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 3 x + 3</source>
        <translation>Tesela de x² + 3x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 4</source>
        <translation>Tesela de x² + 2x + 4</translation>
    </message>
    <message>
        <source>Jigsaw square: nine thirds, one pushed out</source>
        <translation>Cuadrado rompecabezas: nueve tercios, uno de ellos desplazado fuera</translation>
    </message>
    <message>
        <source>Numbers in base -2+i with digits 0 to 4</source>
        <translation>Números en base −2+i con cifras de 0 a 4</translation>
    </message>
    <message>
        <source>Fudgeflake: three terdragons round a point</source>
        <translation>Fudgeflake: tres terdragones en torno a un punto</translation>
    </message>
    <message>
        <source>Central tile of x^3 = 2 x^2 + x + 1</source>
        <translation>Tesela central de x³ = 2x² + x + 1</translation>
    </message>
    <message>
        <source>Penrose tiles</source>
        <translation>Teselas de Penrose</translation>
    </message>
    <message>
        <source>Penrose tiles, cracked</source>
        <translation>Teselas de Penrose agrietadas</translation>
    </message>
    <message>
        <source>Parts of the Rauzy fractal</source>
        <translation>Partes del fractal de Rauzy</translation>
    </message>
    <message>
        <source>Boundary of the dragon</source>
        <translation>Frontera del dragón</translation>
    </message>
    <message>
        <source>Boundary of the twindragon</source>
        <translation>Frontera del dragón gemelo</translation>
    </message>
    <message>
        <source>Golden mean carpet</source>
        <translation>Alfombra del número áureo</translation>
    </message>
    <message>
        <source>Golden mean dragon</source>
        <translation>Dragón del número áureo</translation>
    </message>
    <message>
        <source>Restless pentagon</source>
        <translation>Pentágono inquieto</translation>
    </message>
    <message>
        <source>One-way square</source>
        <translation>Cuadrado de sentido único</translation>
    </message>
    <message>
        <source>Neighbouring corners</source>
        <translation>Vértices vecinos</translation>
    </message>
    <message>
        <source>Steps around a hexagon</source>
        <translation>Pasos alrededor de un hexágono</translation>
    </message>
    <message>
        <source>Steps around a pentagon</source>
        <translation>Pasos alrededor de un pentágono</translation>
    </message>
    <message>
        <source>Old and young</source>
        <translation>Viejas y jóvenes</translation>
    </message>
    <message>
        <source>Sunset in a triangle</source>
        <translation>Puesta de sol en un triángulo</translation>
    </message>
    <message>
        <source>Triangle for the sunset</source>
        <translation>Triángulo para la puesta de sol</translation>
    </message>
    <message>
        <source>Bent window</source>
        <translation>Vidriera curvada</translation>
    </message>
    <message>
        <source>Triangle for the glass</source>
        <translation>Triángulo para la vidriera</translation>
    </message>
    <message>
        <source>Tartan in a square</source>
        <translation>Tartán en un cuadrado</translation>
    </message>
    <message>
        <source>Square for the tartan</source>
        <translation>Cuadrado para el tartán</translation>
    </message>
    <message>
        <source>Grid of a square</source>
        <translation>Cuadrícula de un cuadrado</translation>
    </message>
    <message>
        <source>Square for the grid</source>
        <translation>Cuadrado para la cuadrícula</translation>
    </message>
    <message>
        <source>Rainbow fern</source>
        <translation>Helecho arcoíris</translation>
    </message>
    <message>
        <source>Maple for the fern</source>
        <translation>Arce para el helecho</translation>
    </message>
    <message>
        <source>Autumn maple</source>
        <translation>Arce otoñal</translation>
    </message>
    <message>
        <source>Square for the maple</source>
        <translation>Cuadrado para el arce</translation>
    </message>
    <message>
        <source>Dragon of paper</source>
        <translation>Dragón de papel</translation>
    </message>
    <message>
        <source>Sheet for the dragon</source>
        <translation>Hoja de papel para el dragón</translation>
    </message>
    <message>
        <source>Curve of waves</source>
        <translation>Curva de olas</translation>
    </message>
    <message>
        <source>Sheet for the curve</source>
        <translation>Hoja de papel para la curva</translation>
    </message>
    <message>
        <source>Koch curve across a square</source>
        <translation>Curva de Koch a través de un cuadrado</translation>
    </message>
    <message>
        <source>Square for the curve</source>
        <translation>Cuadrado para la curva</translation>
    </message>
    <message>
        <source>Hilbert curve along a coast</source>
        <translation>Curva de Hilbert a lo largo de una costa</translation>
    </message>
    <message>
        <source>Curve for the square</source>
        <translation>Curva para el cuadrado</translation>
    </message>
    <message>
        <source>Broken picture</source>
        <translation>Imagen rota</translation>
    </message>
    <message>
        <source>Square to break</source>
        <translation>Cuadrado para romper</translation>
    </message>
    <message>
        <source>Gasket of a dragon</source>
        <translation>Triángulo de Sierpiński de un dragón</translation>
    </message>
    <message>
        <source>Terdragon for the gasket</source>
        <translation>Terdragón para el triángulo de Sierpiński</translation>
    </message>
    <message>
        <source>Cantor dust</source>
        <translation>Polvo de Cantor</translation>
    </message>
    <message>
        <source>Cantor comb: a Cantor set times an interval</source>
        <translation>Peine de Cantor: un conjunto de Cantor por un intervalo</translation>
    </message>
    <message>
        <source>Dust on a triangle</source>
        <translation>Polvo sobre un triángulo</translation>
    </message>
    <message>
        <source>Dust on a pentagon</source>
        <translation>Polvo sobre un pentágono</translation>
    </message>
    <message>
        <source>Dust of unequal ratios</source>
        <translation>Polvo de razones desiguales</translation>
    </message>
    <message>
        <source>Dust on an octagon</source>
        <translation>Polvo sobre un octógono</translation>
    </message>
    <message>
        <source>Rings of dust</source>
        <translation>Anillos de polvo</translation>
    </message>
    <message>
        <source>Tartan dust</source>
        <translation>Tartán de polvo</translation>
    </message>
    <message>
        <source>Pinwheel dust</source>
        <translation>Molinillo de polvo</translation>
    </message>
    <message>
        <source>Swirling dust of three</source>
        <translation>Polvo arremolinado de tres copias</translation>
    </message>
    <message>
        <source>Hexaflake</source>
        <translation>Copo hexagonal</translation>
    </message>
    <message>
        <source>Pentaflake</source>
        <translation>Copo pentagonal</translation>
    </message>
    <message>
        <source>Stellar snowflake</source>
        <translation>Copo de nieve estrellado</translation>
    </message>
    <message>
        <source>Fern-like snowflake</source>
        <translation>Copo de nieve en forma de helecho</translation>
    </message>
    <message>
        <source>Sectored plate</source>
        <translation>Placa de nieve con sectores</translation>
    </message>
    <message>
        <source>Needle snowflake</source>
        <translation>Copo de nieve de agujas</translation>
    </message>
    <message>
        <source>Frost flower</source>
        <translation>Flor de escarcha</translation>
    </message>
    <message>
        <source>Decaflake</source>
        <translation>Copo decagonal</translation>
    </message>
    <message>
        <source>Pentagram flake</source>
        <translation>Copo de pentagramas</translation>
    </message>
    <message>
        <source>Quartz: four-fold lattice</source>
        <translation>Cuarzo: red de orden cuatro</translation>
    </message>
    <message>
        <source>Crystal of two maps</source>
        <translation>Cristal de dos aplicaciones</translation>
    </message>
    <message>
        <source>Dendrite snowflake</source>
        <translation>Copo de nieve dendrítico</translation>
    </message>
    <message>
        <source>Eight-pointed star</source>
        <translation>Estrella de ocho puntas</translation>
    </message>
    <message>
        <source>Frost cross: squares turned by 45 degrees</source>
        <translation>Cruz de escarcha: cuadrados girados 45°</translation>
    </message>
    <message>
        <source>Takagi curve (blancmange)</source>
        <translation>Curva de Takagi (del manjar blanco)</translation>
    </message>
    <message>
        <source>Quadratic Bezier arc by de Casteljau</source>
        <translation>Arco de Bézier cuadrático según De Casteljau</translation>
    </message>
    <message>
        <source>Devil&apos;s staircase</source>
        <translation>Escalera del diablo</translation>
    </message>
    <message>
        <source>Okamoto function, a = 2/3 (Bourbaki&apos;s)</source>
        <translation>Función de Okamoto, a = 2/3 (la de Bourbaki)</translation>
    </message>
    <message>
        <source>Okamoto function, a = 5/6 (Perkins&apos;s)</source>
        <translation>Función de Okamoto, a = 5/6 (la de Perkins)</translation>
    </message>
    <message>
        <source>Kiesswetter curve</source>
        <translation>Curva de Kiesswetter</translation>
    </message>
    <message>
        <source>Bolzano function</source>
        <translation>Función de Bolzano</translation>
    </message>
    <message>
        <source>Fractal interpolation of four points</source>
        <translation>Interpolación fractal de cuatro puntos</translation>
    </message>
    <message>
        <source>Mountain skyline</source>
        <translation>Perfil de montañas</translation>
    </message>
    <message>
        <source>First coordinate of Peano&apos;s curve</source>
        <translation>Primera coordenada de la curva de Peano</translation>
    </message>
    <message>
        <source>Lebesgue&apos;s singular function, a = 0.3</source>
        <translation>Función singular de Lebesgue, a = 0,3</translation>
    </message>
    <message>
        <source>Takagi curve and its mirror image</source>
        <translation>Curva de Takagi y su imagen especular</translation>
    </message>
    <message>
        <source>Hilbert&apos;s four maps, shrunk so that the seams open</source>
        <translation>Las cuatro aplicaciones de Hilbert, encogidas hasta que se abren las costuras</translation>
    </message>
    <message>
        <source>Relative of the Sierpinski triangle</source>
        <translation>Pariente del triángulo de Sierpiński</translation>
    </message>
    <message>
        <source>Zigzag of two maps</source>
        <translation>Zigzag de dos aplicaciones</translation>
    </message>
    <message>
        <source>Coral</source>
        <translation>Coral</translation>
    </message>
    <message>
        <source>Rosette of three</source>
        <translation>Rosetón de tres</translation>
    </message>
    <message>
        <source>Rosette of five</source>
        <translation>Rosetón de cinco</translation>
    </message>
    <message>
        <source>Rosette of seven</source>
        <translation>Rosetón de siete</translation>
    </message>
    <message>
        <source>Mandala of twelve</source>
        <translation>Mandala de doce</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Encaje</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Tejido</translation>
    </message>
    <message>
        <source>Twigs: a turn and a mirror</source>
        <translation>Ramitas: un giro y un reflejo</translation>
    </message>
    <message>
        <source>Heather</source>
        <translation>Brezo</translation>
    </message>
    <message>
        <source>Breaking wave</source>
        <translation>Ola rompiente</translation>
    </message>
    <message>
        <source>City seen from above</source>
        <translation>Ciudad vista desde arriba</translation>
    </message>
    <message>
        <source>Flames</source>
        <translation>Llamas</translation>
    </message>
    <message>
        <source>Hills in haze</source>
        <translation>Colinas en la bruma</translation>
    </message>
    <message>
        <source>Knotwork: four copies turned by 45 degrees</source>
        <translation>Lacería: cuatro copias giradas 45°</translation>
    </message>
    <message>
        <source>Sea dragon</source>
        <translation>Dragón marino</translation>
    </message>
    <message>
        <source>Kaleidoscope</source>
        <translation>Caleidoscopio</translation>
    </message>
    <message>
        <source>Sierpinski tetrahedron</source>
        <translation>Tetraedro de Sierpiński</translation>
    </message>
    <message>
        <source>Octahedron flake</source>
        <translation>Copo octaédrico</translation>
    </message>
    <message>
        <source>Sierpinski pyramid</source>
        <translation>Pirámide de Sierpiński</translation>
    </message>
    <message>
        <source>Icosahedron flake</source>
        <translation>Copo icosaédrico</translation>
    </message>
    <message>
        <source>Dodecahedron flake</source>
        <translation>Copo dodecaédrico</translation>
    </message>
    <message>
        <source>Cuboctahedron flake</source>
        <translation>Copo cuboctaédrico</translation>
    </message>
    <message>
        <source>Menger sponge</source>
        <translation>Esponja de Menger</translation>
    </message>
    <message>
        <source>Mosely snowflake</source>
        <translation>Copo de nieve de Mosely</translation>
    </message>
    <message>
        <source>Jerusalem cube</source>
        <translation>Cubo de Jerusalén</translation>
    </message>
    <message>
        <source>Cross in space</source>
        <translation>Cruz en el espacio</translation>
    </message>
    <message>
        <source>Saltire in space</source>
        <translation>Aspa en el espacio</translation>
    </message>
    <message>
        <source>Cantor dust in space</source>
        <translation>Polvo de Cantor en el espacio</translation>
    </message>
    <message>
        <source>Cube corner: seven of eight cubes</source>
        <translation>Esquina de cubo: siete de ocho cubos</translation>
    </message>
    <message>
        <source>Cube corners in mirrors</source>
        <translation>Esquinas de cubo en espejos</translation>
    </message>
    <message>
        <source>Quadratic Koch surface: cubes on squares</source>
        <translation>Superficie de Koch cuadrática: cubos sobre cuadrados</translation>
    </message>
    <message>
        <source>Fern in space</source>
        <translation>Helecho en el espacio</translation>
    </message>
    <message>
        <source>Tree with three boughs</source>
        <translation>Árbol de tres ramas</translation>
    </message>
    <message>
        <source>Oak with a leader and four boughs</source>
        <translation>Roble con una guía y cuatro ramas</translation>
    </message>
    <message>
        <source>Fir: drooping whorls around a leader</source>
        <translation>Abeto: verticilos colgantes en torno a una guía</translation>
    </message>
    <message>
        <source>Poplar: pairs of steep twigs</source>
        <translation>Álamo: pares de ramitas empinadas</translation>
    </message>
    <message>
        <source>Umbel: six rays from the top of a stalk</source>
        <translation>Umbela: seis radios desde lo alto de un tallo</translation>
    </message>
    <message>
        <source>Thuja: flat sprays turned by the golden angle</source>
        <translation>Tuya: ramas planas giradas según el ángulo áureo</translation>
    </message>
    <message>
        <source>Romanesco: cones on a cone, by the golden angle</source>
        <translation>Romanesco: conos sobre un cono según el ángulo áureo</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Coliflor</translation>
    </message>
    <message>
        <source>Turret shell</source>
        <translation>Turritela</translation>
    </message>
    <message>
        <source>Top shell: whorls of whorls</source>
        <translation>Caracol peonza: espiras de espiras</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a flat spiral</source>
        <translation>Nautilo: cámaras a lo largo de una espiral plana</translation>
    </message>
    <message>
        <source>Double helix that narrows to a point</source>
        <translation>Doble hélice que acaba en punta</translation>
    </message>
    <message>
        <source>Staghorn coral</source>
        <translation>Coral cuerno de ciervo</translation>
    </message>
    <message>
        <source>Bush coral</source>
        <translation>Coral arbustivo</translation>
    </message>
    <message>
        <source>Sea fan: forks almost in one plane</source>
        <translation>Gorgonia: bifurcaciones casi en un mismo plano</translation>
    </message>
    <message>
        <source>Allium: a ball of twelve stalks with alliums at their ends</source>
        <translation>Ajo ornamental: una bola de doce tallos con ajos en las puntas</translation>
    </message>
    <message>
        <source>Dragon in space: each fold about another axis</source>
        <translation>Dragón en el espacio: cada pliegue en torno a otro eje</translation>
    </message>
    <message>
        <source>C curve in space</source>
        <translation>Curva C en el espacio</translation>
    </message>
    <message>
        <source>Terdragon in space</source>
        <translation>Terdragón en el espacio</translation>
    </message>
    <message>
        <source>Tetrahedra, each turned by 60 degrees</source>
        <translation>Tetraedros, cada uno girado 60°</translation>
    </message>
    <message>
        <source>Cubes, each turned by 60 degrees</source>
        <translation>Cubos, cada uno girado 60°</translation>
    </message>
    <message>
        <source>Octahedra, each turned by 45 degrees</source>
        <translation>Octaedros, cada uno girado 45°</translation>
    </message>
</context>
<context>
    <name>FirstChips</name>
    <message>
        <source>What to try next</source>
        <translation>Qué probar ahora</translation>
    </message>
</context>
<context>
    <name>FirstMinute</name>
    <message>
        <source>Take a corner.</source>
        <translation>Agarre una esquina.</translation>
    </message>
    <message>
        <source>Make it sway</source>
        <translation>Mecerlo al viento</translation>
    </message>
    <message>
        <source>Grow variations</source>
        <translation>Criar variaciones</translation>
    </message>
    <message>
        <source>Save a poster</source>
        <translation>Guardar un póster</translation>
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
            <numerusform>%n flame</numerusform>
            <numerusform>%n flames</numerusform>
        </translation>
    </message>
    <message>
        <source>In flame files, y points down. The flames were flipped so that they look the same here as in flame programs.</source>
        <translation>En los flames, y crece hacia abajo. Se han invertido para que se vean aquí como en los programas de flames.</translation>
    </message>
    <message>
        <source>Keep &amp;y As Written</source>
        <translation>&amp;Dejar y como está escrita</translation>
    </message>
    <message>
        <source>Uses the numbers as they are in the file. The picture is then upside down.</source>
        <translation>Toma los números de los flames como están en el texto. La imagen queda entonces cabeza abajo.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Keep y as written</source>
        <translation>Dejar y como está escrita</translation>
    </message>
    <message>
        <source>Flip the flames</source>
        <translation>Invertir los flames</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Show or hide the “%1” panel</source>
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
        <source>, %n of them could not be read and are kept unchanged</source>
        <translation>
            <numerusform>; %n de ellas no se pudo leer y se conserva tal cual</numerusform>
            <numerusform>; %n de ellas no se pudieron leer y se conservan tal cual</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with warnings</source>
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
        <source>“%1” has unsaved changes.</source>
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
        <source>Another program has changed “%1” since you opened it.</source>
        <translation>Otro programa ha modificado «%1» desde que se abrió aquí.</translation>
    </message>
    <message>
        <source>Saving overwrites the changes made by the other program.</source>
        <translation>Al guardar se sustituye lo que escribió el otro programa.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
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
        <source>Revert to “%1” as it is on disk? Your changes since then will be lost.</source>
        <translation>¿Volver a «%1» tal como está en el disco? Se perderán los cambios hechos desde entonces.</translation>
    </message>
    <message>
        <source>%1 could not be reloaded</source>
        <translation>No se pudo volver a leer %1</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>No hay archivos recientes</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Vaciar la lista</translation>
    </message>
    <message>
        <source>%1[*] — %2</source>
        <comment>file, entry</comment>
        <translation>%1[*] — %2</translation>
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
        <source>Save the file; entries that you did not edit stay unchanged, byte for byte</source>
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
        <source>Discard your changes and reload the file from disk</source>
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
        <source>The picture was copied to the clipboard.</source>
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
        <source>Undo the last edit</source>
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
        <source>Redo the last edit that was undone</source>
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
        <source>Rotate, scale, shear, reflect or move the whole fractal by exact amounts</source>
        <translation>Girar, escalar, cizallar, reflejar o mover todo el fractal con números</translation>
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
        <source>De&amp;fine Triangle</source>
        <translation>&amp;Definir el triángulo</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Ajustar el símplex canónico &amp;mínimo</translation>
    </message>
    <message>
        <source>Fit the smallest isosceles right triangle with legs parallel to the axes around the attractor</source>
        <translation>Sujetar el atractor con el menor triángulo rectángulo isósceles que lo rodea</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Restab&amp;lecer</translation>
    </message>
    <message>
        <source>Return the cage to rest: the picture shows the code as it is</source>
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
        <source>Write the placement into the code: the picture stays, and the coefficients change</source>
        <translation>Hacer que la colocación forme parte del código: la imagen no cambia, los coeficientes cambian</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Extraer</translation>
    </message>
    <message>
        <source>Extract the placement from the code: the picture stays, and the code is rewritten for the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Sacar la colocación del código: la imagen no cambia, el código pasa a ser el del triángulo (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Hacer re&amp;gular</translation>
    </message>
    <message>
        <source>Move the vertices to the nearest regular polygon</source>
        <translation>Llevar los vértices al polígono regular más próximo</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>&amp;Forma afín invariante…</translation>
    </message>
    <message>
        <source>Show every map as a matrix over the control triangle, with rows that sum to 1</source>
        <translation>Mostrar cada aplicación como matriz estocástica por filas sobre el triángulo de control</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>&amp;Colocar</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code does not change</source>
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
        <source>Point the y axis down, as in window coordinates</source>
        <translation>Hacer que y crezca hacia abajo, como en las coordenadas de una ventana</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas except the picture</source>
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
        <source>Make dragged vertices snap to this</source>
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
        <source>Fill the whole screen</source>
        <translation>Usar toda la pantalla</translation>
    </message>
    <message>
        <source>How It Is Built</source>
        <translation>Cómo se construye</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor being built: in steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Ver cómo se construye el atractor: por pasos del algoritmo determinista o con el juego del caos</translation>
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
        <translation>&amp;Guía del usuario (en inglés)</translation>
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
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Grab a fractal by its corners: an editor for iterated function systems that describes their attractors in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Tome un fractal por sus esquinas: un editor de sistemas de funciones iteradas cuyos atractores se sujetan con las coordenadas baricéntricas de un triángulo de control.&lt;/p&gt;&lt;p&gt;Según E. Hadzieva y M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Licencia MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>Acerca de &amp;Qt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Recorrido</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>¿Qué es &amp;esto?</translation>
    </message>
    <message>
        <source>Click anything to see what it does</source>
        <translation>Hacer clic en cualquier cosa para leer para qué sirve</translation>
    </message>
    <message>
        <source>Recovery Unavailable</source>
        <translation>Recuperación no disponible</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Permitir sistemas &amp;sin atractor</translation>
    </message>
    <message>
        <source>Let a drag of maps continue where an attractor is no longer guaranteed</source>
        <translation>Dejar que el arrastre de aplicaciones continúe donde ya no se garantiza un atractor</translation>
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
        <source>Show each map as its image of the cage, and drag it by its corners</source>
        <translation>Mostrar cada aplicación como su imagen de la jaula y arrastrarla por sus esquinas</translation>
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
        <source>Click a point of the attractor and drag the branch that contains it</source>
        <translation>Pulsar en un punto del atractor y arrastrar la rama que lo contiene</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>P&amp;egar</translation>
    </message>
    <message>
        <source>Your unsaved work was recovered nevertheless.</source>
        <translation>El trabajo no guardado está aquí de todos modos.</translation>
    </message>
    <message>
        <source>%1 was not recovered. Barycage will offer it again at the next start.</source>
        <translation>%1 no se ha recuperado. Se ofrecerá de nuevo en el próximo inicio.</translation>
    </message>
    <message>
        <source>Press Esc to bring back the menus and panels.</source>
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
        <source>Show only the canvas in full screen, for example on a projector; press Esc to return</source>
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
    <message>
        <source>Ca&amp;mera</source>
        <translation>Cá&amp;mara</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Frente</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>At&amp;rás</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Derecha</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>I&amp;zquierda</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Arriba</translation>
    </message>
    <message>
        <source>Look down (7 on the keypad)</source>
        <translation>Mirar hacia abajo (7 en el teclado numérico)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>A&amp;bajo</translation>
    </message>
    <message>
        <source>Look up (Ctrl+7 on the keypad)</source>
        <translation>Mirar hacia arriba (Ctrl+7 en el teclado numérico)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrica</translation>
    </message>
    <message>
        <source>Look from a corner (Home)</source>
        <translation>Mirar desde una esquina (Inicio)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspectiva</translation>
    </message>
    <message>
        <source>In the menu %1.</source>
        <translation>En el menú %1.</translation>
    </message>
    <message>
        <source>Shortcut: %1</source>
        <translation>Atajo: %1</translation>
    </message>
    <message>
        <source>Tool Options</source>
        <translation>Opciones de la herramienta</translation>
    </message>
    <message>
        <source>Show the options of the tool under the canvas</source>
        <translation>Mostrar las opciones de la herramienta bajo el lienzo</translation>
    </message>
    <message>
        <source>A bar with the options of the current tool, or a reminder of how to use it.</source>
        <translation>Una barra con las opciones de la herramienta actual, o un recordatorio de cómo se usa.</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>A&amp;plicaciones</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>Voltear en &amp;horizontal</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the vertical line through their centre</source>
        <translation>Reflejar las aplicaciones seleccionadas respecto a la vertical por su centro</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>Voltear en &amp;vertical</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the horizontal line through their centre</source>
        <translation>Reflejar las aplicaciones seleccionadas respecto a la horizontal por su centro</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Left</source>
        <translation>Girar 90° a la &amp;izquierda</translation>
    </message>
    <message>
        <source>Rotate the selected maps counter-clockwise about their centre</source>
        <translation>Girar las aplicaciones seleccionadas en sentido antihorario en torno a su centro</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Right</source>
        <translation>Girar 90° a la &amp;derecha</translation>
    </message>
    <message>
        <source>Rotate the selected maps clockwise about their centre</source>
        <translation>Girar las aplicaciones seleccionadas en sentido horario en torno a su centro</translation>
    </message>
    <message>
        <source>Ali&amp;gn Centres</source>
        <translation>A&amp;linear los centros</translation>
    </message>
    <message>
        <source>In a &amp;Row</source>
        <translation>En una &amp;fila</translation>
    </message>
    <message>
        <source>Move the selected maps up or down until their centres are at the same height</source>
        <translation>Mover las aplicaciones seleccionadas hacia arriba o abajo hasta que sus centros estén a la misma altura</translation>
    </message>
    <message>
        <source>In a &amp;Column</source>
        <translation>En una &amp;columna</translation>
    </message>
    <message>
        <source>Move the selected maps left or right until their centres are one below the other</source>
        <translation>Mover las aplicaciones seleccionadas a izquierda o derecha hasta que sus centros estén uno debajo de otro</translation>
    </message>
    <message>
        <source>D&amp;istribute Centres</source>
        <translation>Distrib&amp;uir los centros</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>En &amp;horizontal</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from left to right</source>
        <translation>Separar por igual los centros de las aplicaciones seleccionadas de izquierda a derecha</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>En &amp;vertical</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from bottom to top</source>
        <translation>Separar por igual los centros de las aplicaciones seleccionadas de abajo arriba</translation>
    </message>
    <message>
        <source>&amp;Fit to Corners</source>
        <translation>A&amp;justar a los vértices</translation>
    </message>
    <message>
        <source>Move each selected map so that it leaves the nearest corner of the cage fixed</source>
        <translation>Mover cada aplicación seleccionada hasta que lleve el vértice más cercano de la jaula a sí mismo</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Elija primero una aplicación.</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Duplicar las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Eliminar las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Select all maps</source>
        <translation>Seleccionar todas las aplicaciones</translation>
    </message>
    <message>
        <source>&amp;Duplicate Maps</source>
        <translation>Dupli&amp;car aplicaciones</translation>
    </message>
    <message>
        <source>D&amp;elete Maps</source>
        <translation>&amp;Eliminar aplicaciones</translation>
    </message>
    <message>
        <source>Select &amp;All Maps</source>
        <translation>Seleccionar &amp;todas las aplicaciones</translation>
    </message>
    <message>
        <source>Missing on disk</source>
        <translation>Ya no está en el disco</translation>
    </message>
    <message>
        <source>“%1” has been deleted, renamed or moved since you opened it.</source>
        <translation>«%1» se ha eliminado, renombrado o movido desde que se abrió aquí.</translation>
    </message>
    <message>
        <source>Saving creates it again in its old location.</source>
        <translation>Al guardar se vuelve a crear en su lugar anterior.</translation>
    </message>
    <message>
        <source>Other names of the file (hard links) keep the old contents.</source>
        <translation>Los otros nombres del archivo (enlaces duros) conservan el contenido anterior.</translation>
    </message>
    <message>
        <source>&amp;Lift to Space</source>
        <translation>&amp;Llevar al espacio</translation>
    </message>
    <message>
        <source>Lift to Space</source>
        <translation>Llevar al espacio</translation>
    </message>
    <message>
        <source>&amp;Flatten to the Plane</source>
        <translation>Aplanar al plan&amp;o</translation>
    </message>
    <message>
        <source>Flatten to the Plane</source>
        <translation>Aplanar al plano</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen, or a solid as a mesh for 3D printing</source>
        <translation>Exporta la imagen como PNG, SVG o PDF, encuadrada como en la pantalla; un sólido, también como cuerpo para imprimir</translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation>A&amp;nimación</translation>
    </message>
    <message>
        <source>A&amp;nimate</source>
        <translation>A&amp;nimar</translation>
    </message>
    <message>
        <source>Show the timeline under the canvas</source>
        <translation>Mostrar la línea de tiempo bajo el lienzo</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Play or stop the animation (Space on the canvas)</source>
        <translation>Reproducir o detener la animación (Espacio en el lienzo)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>P&amp;revious Frame</source>
        <translation>&amp;Fotograma anterior</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Move the playhead back one frame</source>
        <translation>Retroceder el cabezal un fotograma</translation>
    </message>
    <message>
        <source>Ne&amp;xt Frame</source>
        <translation>Fotograma &amp;siguiente</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Move the playhead forward one frame</source>
        <translation>Avanzar el cabezal un fotograma</translation>
    </message>
    <message>
        <source>Pre&amp;vious Key</source>
        <translation>C&amp;lave anterior</translation>
    </message>
    <message>
        <source>Alt+,</source>
        <translation>Alt+,</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Mover el cabezal a la clave anterior</translation>
    </message>
    <message>
        <source>Nex&amp;t Key</source>
        <translation>Cla&amp;ve siguiente</translation>
    </message>
    <message>
        <source>Alt+.</source>
        <translation>Alt+.</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Mover el cabezal a la clave siguiente</translation>
    </message>
    <message>
        <source>Set &amp;Key</source>
        <translation>Poner &amp;clave</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Key the current track at the playhead</source>
        <translation>Poner una clave de la pista actual en el cabezal</translation>
    </message>
    <message>
        <source>Set Keys of &amp;All Tracks</source>
        <translation>Poner claves de &amp;todas las pistas</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Key all tracks that have keys at the playhead, or all tracks if none has</source>
        <translation>Poner en el cabezal claves de todas las pistas que ya tienen, o de todas si ninguna tiene</translation>
    </message>
    <message>
        <source>&amp;Delete Keys</source>
        <translation>&amp;Eliminar claves</translation>
    </message>
    <message>
        <source>Delete the selected keys</source>
        <translation>Eliminar las claves seleccionadas</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Fractal &amp;Transformation</source>
        <translation>&amp;Transformación fractal</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Show another entry beside this one, and colour this one by a picture placed on the other</source>
        <translation>Mostrar otra entrada junto a esta y pintar esta con una imagen que está sobre ella</translation>
    </message>
    <message>
        <source>Export Ani&amp;mation…</source>
        <translation>Exportar ani&amp;mación…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Export the animation as a video, an animated image or frames, on this computer or on a cluster</source>
        <translation>Exportar la animación como vídeo, imagen en movimiento o fotogramas, aquí o en un clúster</translation>
    </message>
    <message>
        <source>Nothing moves in this entry yet. Choose a motion in the timeline first: Animation, Animate.</source>
        <translation>En esta entrada aún no se mueve nada. Elija primero un movimiento en la línea de tiempo: Animación, Animar.</translation>
    </message>
    <message>
        <source>A mesh needs a solid, and this entry lies in a plane: lift it to space first.</source>
        <translation>Una malla necesita un sólido, y esta entrada está en el plano: llévela primero al espacio.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Enlaces</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Collage</translation>
    </message>
    <message>
        <source>Four &amp;Views</source>
        <translation>Cuatro &amp;vistas</translation>
    </message>
    <message>
        <source>Define the control triangle with three clicks, or in space the tetrahedron with four</source>
        <translation>Define el triángulo de control con tres clics; en el espacio, el tetraedro con cuatro</translation>
    </message>
    <message>
        <source>Look from the front (1 on the keypad)</source>
        <translation>Mirar desde delante (1 en el teclado numérico)</translation>
    </message>
    <message>
        <source>Look from behind (Ctrl+1 on the keypad)</source>
        <translation>Mirar desde detrás (Ctrl+1 en el teclado numérico)</translation>
    </message>
    <message>
        <source>Look from the right (3 on the keypad)</source>
        <translation>Mirar desde la derecha (3 en el teclado numérico)</translation>
    </message>
    <message>
        <source>Look from the left (Ctrl+3 on the keypad)</source>
        <translation>Mirar desde la izquierda (Ctrl+3 en el teclado numérico)</translation>
    </message>
    <message>
        <source>&amp;Z Up</source>
        <translation>&amp;Z hacia arriba</translation>
    </message>
    <message>
        <source>Point the z axis up, as in CAD programs; the fractal stays as it is</source>
        <translation>El eje z apunta hacia arriba, como en los programas de CAD; el fractal no cambia</translation>
    </message>
    <message>
        <source>De&amp;fine Tetrahedron</source>
        <translation>&amp;Definir el tetraedro</translation>
    </message>
    <message>
        <source>Select maps or entries first: in their panels, or on the canvas with the Maps tool.</source>
        <translation>Seleccione primero aplicaciones o entradas: en sus paneles, o en el lienzo con la herramienta de aplicaciones.</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>Move the selected maps or entries to the clipboard</source>
        <translation>Mover al portapapeles las aplicaciones o entradas seleccionadas</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Add fractals from the clipboard to the file: entries of an .ifs file, flames or a table of numbers; or maps to the fractal</source>
        <translation>Añadir al archivo fractales del portapapeles: entradas de un archivo .ifs, flames o una tabla de números; o aplicaciones al fractal</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>Duplicate the selected maps or entries</source>
        <translation>Duplicar las aplicaciones o entradas seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected maps or entries</source>
        <translation>Eliminar las aplicaciones o entradas seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Seleccionar todo</translation>
    </message>
    <message>
        <source>Select all maps or all entries</source>
        <translation>Seleccionar todas las aplicaciones o todas las entradas</translation>
    </message>
    <message>
        <source>Breed variations of this fractal, or cross it with another one</source>
        <translation>Criar variaciones de este fractal o cruzarlo con otro</translation>
    </message>
    <message>
        <source>The Chaos Game</source>
        <translation>El juego del caos</translation>
    </message>
    <message>
        <source>Why the Maple Fits Its Triangle</source>
        <translation>Por qué el arce cabe en su triángulo</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Lección</translation>
    </message>
    <message>
        <source>&amp;Play Lesson</source>
        <translation>&amp;Reproducir la lección</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>Paso &amp;siguiente</translation>
    </message>
    <message>
        <source>Show the next step of the lesson being played</source>
        <translation>Mostrar el paso siguiente de la lección en curso</translation>
    </message>
    <message>
        <source>Previous &amp;Step</source>
        <translation>Paso &amp;anterior</translation>
    </message>
    <message>
        <source>Show the previous step of the lesson being played</source>
        <translation>Mostrar el paso anterior de la lección en curso</translation>
    </message>
    <message>
        <source>&amp;Add Step</source>
        <translation>Aña&amp;dir un paso</translation>
    </message>
    <message>
        <source>Add a step to the lesson, with the current state of the window</source>
        <translation>Añadir a la lección un paso con el estado actual de la ventana</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>Guardar la l&amp;ección…</translation>
    </message>
    <message>
        <source>The step now has the current state of the window.</source>
        <translation>El paso tiene ahora el estado de la ventana.</translation>
    </message>
    <message>
        <source>End the lesson before you save (Esc).</source>
        <translation>Termine la lección antes de guardar (Esc).</translation>
    </message>
    <message>
        <source>Play this lesson, in a window of its own if this one is in use</source>
        <translation>Reproducir esta lección, en una ventana propia si esta está en uso</translation>
    </message>
    <message>
        <source>Unsaved lesson</source>
        <translation>Lección sin guardar</translation>
    </message>
    <message>
        <source>The lesson “%1” has unsaved changes.</source>
        <translation>La lección «%1» tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>The lesson was not saved</source>
        <translation>No se guardó la lección</translation>
    </message>
    <message>
        <source>Lessons (*.lesson)</source>
        <translation>Lecciones (*.lesson)</translation>
    </message>
    <message>
        <source>The fractals have unsaved changes.</source>
        <translation>Los fractales tienen cambios sin guardar.</translation>
    </message>
    <message>
        <source>Step %1 has the current state of the window. Now write its text.</source>
        <translation>El paso %1 tiene el estado de la ventana. Escriba su texto.</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Instantáneas</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Exportaciones</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>&amp;Ready-Made Lessons</source>
        <translation>Lecciones &amp;preparadas</translation>
    </message>
    <message>
        <source>Re&amp;name Map</source>
        <translation>Cambiar &amp;nombre de la aplicación</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Dar un nombre a la aplicación actual</translation>
    </message>
    <message>
        <source>Loc&amp;k or Unlock Maps</source>
        <translation>Blo&amp;quear o desbloquear aplicaciones</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing, or unlock them</source>
        <translation>Proteger de cambios las aplicaciones seleccionadas, o dejar de hacerlo</translation>
    </message>
    <message>
        <source>Show Map Al&amp;one</source>
        <translation>Mostrar &amp;sola la aplicación</translation>
    </message>
    <message>
        <source>Show the current map alone, or all of them again</source>
        <translation>Mostrar sola la aplicación actual, o todas de nuevo</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>&amp;Vistas guardadas</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>&amp;Guardar la vista…</translation>
    </message>
    <message>
        <source>Keep what the canvas shows under a name, with the fractal</source>
        <translation>Guardar con un nombre, junto al fractal, lo que muestra el lienzo</translation>
    </message>
    <message>
        <source>&amp;Edit Views…</source>
        <translation>&amp;Editar vistas…</translation>
    </message>
    <message>
        <source>Go to saved views, rename or delete them</source>
        <translation>Ir a las vistas guardadas, cambiarles el nombre o eliminarlas</translation>
    </message>
    <message>
        <source>No saved views</source>
        <translation>No hay vistas guardadas</translation>
    </message>
    <message>
        <source>Views that you save are listed here.</source>
        <translation>Aquí aparecen las vistas que guarde.</translation>
    </message>
    <message>
        <source>Show this part of the fractal again</source>
        <translation>Volver a mostrar esta parte del fractal</translation>
    </message>
    <message>
        <source>Save the view “%1”</source>
        <translation>Guardar la vista «%1»</translation>
    </message>
    <message>
        <source>Print &amp;Handout…</source>
        <translation>Imprimir &amp;hoja para clase…</translation>
    </message>
    <message>
        <source>Print entries for a class: pictures with cage, maps and formulas, or a blank worksheet</source>
        <translation>Imprimir entradas para clase: imágenes con jaula, aplicaciones y fórmulas, o una hoja de ejercicios en blanco</translation>
    </message>
    <message>
        <source>Copy as La&amp;TeX</source>
        <translation>Copiar como &amp;LaTeX</translation>
    </message>
    <message>
        <source>&amp;Table of Maps</source>
        <translation>&amp;Tabla de aplicaciones</translation>
    </message>
    <message>
        <source>Copy the coefficients as a tabular</source>
        <translation>Copiar los coeficientes como tabular</translation>
    </message>
    <message>
        <source>&amp;Formulas with Matrices</source>
        <translation>&amp;Fórmulas con matrices</translation>
    </message>
    <message>
        <source>Copy each map as a matrix and a vector</source>
        <translation>Copiar cada aplicación como matriz y vector</translation>
    </message>
    <message>
        <source>&amp;Affine Invariant Form</source>
        <translation>Forma &amp;afín invariante</translation>
    </message>
    <message>
        <source>Copy one matrix per map, in barycentric coordinates of the triangle</source>
        <translation>Copiar una matriz por aplicación, en coordenadas baricéntricas del triángulo</translation>
    </message>
    <message>
        <source>Fi&amp;gure (TikZ)</source>
        <translation>Fi&amp;gura (TikZ)</translation>
    </message>
    <message>
        <source>Copy the cage and its images under the maps, with numbers and fixed points, as shown on the canvas</source>
        <translation>Copiar la jaula y sus imágenes por las aplicaciones, con números y puntos fijos, tal como se ven</translation>
    </message>
    <message>
        <source>Copied. The document needs %1.</source>
        <translation>Copiado. El documento necesita %1.</translation>
    </message>
    <message>
        <source>Map numbers</source>
        <translation>Números</translation>
    </message>
    <message>
        <source>&amp;Numbers of Maps</source>
        <translation>Números de las aplicaci&amp;ones</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Show the number and the fixed point of each map</source>
        <translation>Mostrar el número y el punto fijo de cada aplicación</translation>
    </message>
    <message>
        <source>Rotate View &amp;Left</source>
        <translation>Girar la vista a la &amp;izquierda</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate the view counter-clockwise by 15°</source>
        <translation>Gira 15° en sentido antihorario lo que muestra el lienzo</translation>
    </message>
    <message>
        <source>Rotate View &amp;Right</source>
        <translation>Girar la vista a la &amp;derecha</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>Rotate the view clockwise by 15°</source>
        <translation>Gira 15° en sentido horario lo que muestra el lienzo</translation>
    </message>
    <message>
        <source>Re&amp;set Rotation</source>
        <translation>&amp;Restablecer el giro</translation>
    </message>
    <message>
        <source>Return the view to upright</source>
        <translation>Vuelve a enderezar la vista</translation>
    </message>
    <message>
        <source>Side &amp;by Side</source>
        <translation>Lado a &amp;lado</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Show another entry beside this one, to compare and edit both</source>
        <translation>Mostrar otra entrada junto a esta para comparar y editar ambas</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Copiado.</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Buscar…</translation>
    </message>
    <message>
        <source>Find “%1”</source>
        <translation>Buscar «%1»</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs *.par)</source>
        <translation>Colecciones de Fractint (*.ifs *.par)</translation>
    </message>
    <message>
        <source>The lesson now refers to %1. Save the lesson to keep this change.</source>
        <translation>La lección pertenece ahora a %1. Guárdela para que siga así.</translation>
    </message>
    <message>
        <source>The fractal transformation was hidden to show how the attractor is built.</source>
        <translation>Se ocultó la transformación fractal para mostrar cómo se construye el atractor.</translation>
    </message>
    <message>
        <source>Add a third dimension to every map; the picture stays flat until you move a map</source>
        <translation>Añade una tercera dimensión a cada aplicación; la imagen sigue siendo plana hasta que mueva una aplicación</translation>
    </message>
    <message>
        <source>Replace the solid by its projection along the first axis that every map keeps</source>
        <translation>Sustituye el sólido por su proyección a lo largo del primer eje que conserva cada aplicación</translation>
    </message>
    <message>
        <source>Plays this lesson in full screen, with its text next to the picture. Page Down and Page Up go to the next and the previous step. Esc ends the lesson.</source>
        <translation>Reproduce esta lección a pantalla completa, con su texto junto a la imagen. Av Pág y Re Pág llevan al paso siguiente y al anterior. Esc termina la lección.</translation>
    </message>
    <message>
        <source>Make distant parts look smaller (5 on the keypad)</source>
        <translation>Mostrar más pequeñas las partes lejanas (5 en el teclado numérico)</translation>
    </message>
    <message>
        <source>Snapshots are not saved with the file and will be lost: %1. To keep one, cancel and choose Add as Entry in the Snapshots panel.</source>
        <translation>Las instantáneas no se guardan con el archivo y se perderán: %1. Para conservar una, cancele y elija «Añadir como entrada» en el panel Instantáneas.</translation>
    </message>
    <message>
        <source>The target in the Collage panel is not saved with the file.</source>
        <translation>El objetivo del panel «Collage» no se guarda con el archivo.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Reproducir la lección en toda la pantalla, desde el principio o desde el paso en el que hizo clic en la lista</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>The lesson has unsaved changes.</source>
        <translation>La lección tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Guardar la lección como un texto que se refiere a sus fractales</translation>
    </message>
    <message>
        <source>Sa&amp;ve Lesson As…</source>
        <translation>Guardar la lección c&amp;omo…</translation>
    </message>
    <message>
        <source>Save the lesson under another name or in another folder</source>
        <translation>Guardar la lección con otro nombre o en otra carpeta</translation>
    </message>
    <message>
        <source>The lesson names no file of fractals (“file: name.ifs”).</source>
        <translation>La lección no nombra ningún archivo de fractales («file: nombre.ifs»).</translation>
    </message>
    <message>
        <source>The file of its fractals, “%1”, was not found. It may have been renamed or moved.</source>
        <translation>No se encontró el archivo de sus fractales, «%1». Quizá se le ha cambiado el nombre o se ha movido.</translation>
    </message>
    <message>
        <source>Save Lesson</source>
        <translation>Guardar la lección</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. Save the fractals as a .ifs file first, with no : * ? &quot; &lt; &gt; | in its name and folders.</source>
        <translation>Una lección no puede referirse a «%1». Guarde antes los fractales como archivo .ifs, sin : * ? &quot; &lt; &gt; | en su nombre ni en sus carpetas.</translation>
    </message>
    <message>
        <source>If you discard the changes, the snapshots of them will be lost, too: %1.</source>
        <translation>Si descarta los cambios, también se perderán sus instantáneas: %1.</translation>
    </message>
    <message>
        <source>Unsaved snapshots</source>
        <translation>Instantáneas sin guardar</translation>
    </message>
    <message>
        <source>“%1” has snapshots that are not saved.</source>
        <translation>«%1» tiene instantáneas sin guardar.</translation>
    </message>
    <message>
        <source>Revert to “%1” as it is on disk?</source>
        <translation>¿Volver a «%1» tal como está en el disco?</translation>
    </message>
    <message>
        <source>Replace the view “%1”</source>
        <translation>Reemplazar la vista «%1»</translation>
    </message>
    <message>
        <source>Drag the corners of the cage</source>
        <translation>Arrastrar los vértices de la jaula</translation>
    </message>
    <message>
        <source>Show the solid from the top, the front and the right, and in perspective</source>
        <translation>Mostrar el sólido desde arriba, de frente, desde la derecha y en perspectiva</translation>
    </message>
    <message>
        <source>%1 names a file outside its folder.</source>
        <translation>%1 nombra un archivo fuera de su carpeta.</translation>
    </message>
    <message>
        <source>Its fractals are in “%1”. Open that file only if you trust the lesson.</source>
        <translation>Sus fractales están en «%1». Abra ese archivo solo si confía en la lección.</translation>
    </message>
    <message>
        <source>&amp;Open It</source>
        <translation>&amp;Abrir</translation>
    </message>
    <message>
        <source>Save a Copy for Other Programs</source>
        <translation>Guardar una copia para otros programas</translation>
    </message>
    <message>
        <source>A copy needs another name than the file itself.</source>
        <translation>Una copia necesita un nombre distinto del del propio archivo.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Guardando «%1»…</translation>
    </message>
    <message>
        <source>Saved the copy %1.</source>
        <translation>Se ha guardado la copia %1.</translation>
    </message>
    <message>
        <source>Other programs still draw these entries differently: %1.</source>
        <translation>Otros programas siguen dibujando de otro modo estas entradas: %1.</translation>
    </message>
    <message>
        <source>Save a Copy &amp;for Other Programs…</source>
        <translation>G&amp;uardar una copia para otros programas…</translation>
    </message>
    <message>
        <source>Save a copy with the placements written into the code and every map listed, so that other programs draw what you see</source>
        <translation>Guardar una copia con las colocaciones incorporadas al código y todas las aplicaciones en la lista, para que otros programas dibujen lo que usted ve</translation>
    </message>
    <message>
        <source>The previous version is %1.</source>
        <translation>La versión anterior es %1.</translation>
    </message>
    <message>
        <source>The previous version was not kept: there is already a file %1 that Barycage did not make.</source>
        <translation>La versión anterior no se ha conservado: ya hay un archivo %1 que Barycage no ha creado.</translation>
    </message>
    <message>
        <source>The previous version could not be kept as %1.</source>
        <translation>La versión anterior no se ha podido conservar como %1.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n files?</source>
        <translation>
            <numerusform>¿Abrir %n archivo?</numerusform>
            <numerusform>¿Abrir %n archivos?</numerusform>
        </translation>
    </message>
    <message>
        <source>Each of them opens in a window of its own.</source>
        <translation>Cada uno se abre en una ventana propia.</translation>
    </message>
    <message>
        <source>Open &amp;All</source>
        <translation>Abrir &amp;todos</translation>
    </message>
    <message>
        <source>Open the &amp;First %1</source>
        <translation>Abrir los &amp;primeros %1</translation>
    </message>
    <message>
        <source>Opening files…</source>
        <translation>Abriendo archivos…</translation>
    </message>
    <message>
        <source>%1 is also open in another window of Barycage. Whichever saves last replaces what the other saved.</source>
        <translation>%1 también está abierto en otra ventana de Barycage. La última que guarde reemplazará lo que haya guardado la otra.</translation>
    </message>
    <message>
        <source>Export Web Page</source>
        <translation>Exportar página web</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>%1 was written. Open it in a browser, or mail it: it needs no network.</source>
        <translation>Se ha escrito %1. Ábrala en un navegador o envíela por correo: no necesita red.</translation>
    </message>
    <message>
        <source>Stretch Ke&amp;ys…</source>
        <translation>Est&amp;irar claves…</translation>
    </message>
    <message>
        <source>Make a range of frames slower or faster: the keys of all tracks spread</source>
        <translation>Hace más lento o más rápido un intervalo: las claves de todas las pistas se reparten</translation>
    </message>
    <message>
        <source>There are no keys to stretch. Choose Set Key first.</source>
        <translation>No hay claves que estirar. Fije primero una clave.</translation>
    </message>
    <message>
        <source>Copy the picture, the selected maps or the selected entries</source>
        <translation>Copia la imagen, las aplicaciones seleccionadas o las entradas seleccionadas</translation>
    </message>
    <message>
        <source>Export We&amp;b Page…</source>
        <translation>Exportar página we&amp;b…</translation>
    </message>
    <message>
        <source>Export the fractal in its cage as one file for browsers, in which it can be dragged</source>
        <translation>Exportar el fractal en su jaula como un solo archivo para navegadores, en los que se puede arrastrar</translation>
    </message>
    <message>
        <source>Six short steps that you do yourself: drag, squeeze, undo, collection, wind, export</source>
        <translation>Seis pasos breves que da usted mismo: arrastrar, aplastar, deshacer, colección, viento, exportar</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Show a centre and height, the point of an address, or a fixed point</source>
        <translation>Muestra un centro y una altura, el punto de una dirección o un punto fijo</translation>
    </message>
    <message>
        <source>Language, theme, picture quality, shortcuts, and what opens at startup</source>
        <translation>Idioma, tema, calidad de la imagen, atajos y qué se abre al iniciar</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>&amp;Variaciones…</translation>
    </message>
    <message>
        <source>S&amp;hadow</source>
        <translation>Som&amp;bra</translation>
    </message>
    <message>
        <source>Lay a flat, dark copy of the picture on the ground behind it</source>
        <translation>Tender en el suelo, detrás de la imagen, una copia plana y oscura de ella</translation>
    </message>
    <message>
        <source>Add a shadow</source>
        <translation>Añadir una sombra</translation>
    </message>
    <message>
        <source>Remove the shadow</source>
        <translation>Quitar la sombra</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animar</translation>
    </message>
    <message>
        <source>&amp;Keys and Frames</source>
        <translation>&amp;Claves y fotogramas</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Rama</translation>
    </message>
    <message>
        <source>M&amp;ore</source>
        <translation>&amp;Más</translation>
    </message>
    <message>
        <source>D&amp;iscover</source>
        <translation>&amp;Descubrir</translation>
    </message>
    <message>
        <source>&amp;Collection</source>
        <translation>&amp;Colección</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Search the fractals that come with the program, and your favourites</source>
        <translation>Buscar entre los fractales incluidos en el programa y sus favoritos</translation>
    </message>
    <message>
        <source>S&amp;napshots</source>
        <translation>I&amp;nstantáneas</translation>
    </message>
    <message>
        <source>&amp;Fractal</source>
        <translation>&amp;Fractal</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>&amp;Selected Maps</source>
        <translation>Aplicaciones &amp;seleccionadas</translation>
    </message>
    <message>
        <source>&amp;Teach</source>
        <translation>En&amp;señar</translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation>&amp;Navegar</translation>
    </message>
    <message>
        <source>&amp;Go To…</source>
        <translation>&amp;Ir a…</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Lienzo</translation>
    </message>
    <message>
        <source>How It Is &amp;Built</source>
        <translation>Cómo se const&amp;ruye</translation>
    </message>
    <message>
        <source>Web page written</source>
        <translation>Página web guardada</translation>
    </message>
    <message>
        <source>Copy &amp;Link</source>
        <translation>Copiar &amp;enlace</translation>
    </message>
    <message>
        <source>Copy a link that holds the fractal: Barycage opens it when it is pasted</source>
        <translation>Copiar un enlace que contiene el fractal: Barycage lo abre al pegarlo</translation>
    </message>
    <message>
        <source>The link was copied to the clipboard. It holds the whole fractal.</source>
        <translation>El enlace se ha copiado al portapapeles. Contiene el fractal completo.</translation>
    </message>
    <message>
        <source>Hidden in this small window: %1 (View › Panels).</source>
        <translation>Ocultos en esta ventana pequeña: %1 (Ver › Paneles).</translation>
    </message>
    <message>
        <source>Pr&amp;int Lesson…</source>
        <translation>&amp;Imprimir la lección…</translation>
    </message>
    <message>
        <source>Print the steps of the lesson, with their pictures and texts</source>
        <translation>Imprimir los pasos de la lección, con sus imágenes y textos</translation>
    </message>
    <message>
        <source>Copy as &amp;Python</source>
        <translation>Copiar como &amp;Python</translation>
    </message>
    <message>
        <source>Copy lines for a notebook that make the fractal with the Python package “barycage”</source>
        <translation>Copiar líneas para un cuaderno que crean el fractal con el paquete de Python «barycage»</translation>
    </message>
    <message>
        <source>Files with fractals (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures with an embedded fractal (*.png *.svg);;Lessons (*.lesson);;All files (*)</source>
        <translation>Archivos con fractales (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Colecciones de Fractint (*.ifs *.par);;Flames (*.flame *.flam3);;Tablas de números (*.csv *.tsv *.txt);;Imágenes que llevan su fractal (*.png *.svg);;Lecciones (*.lesson);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The lesson is not saved yet: choose Save Lesson.</source>
        <translation>La lección aún no está guardada: elija Guardar lección.</translation>
    </message>
    <message>
        <source>laser plotter cutter engrave dxf outline millimetres millimeters</source>
        <translation>láser plóter cortadora grabar cortar contorno milímetros</translation>
    </message>
    <message>
        <source>Copy saved</source>
        <translation>Copia guardada</translation>
    </message>
    <message>
        <source>%1 was saved for other programs.</source>
        <translation>%1 se guardó para otros programas.</translation>
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
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>«%1» es un número demasiado grande.</translation>
    </message>
    <message>
        <source>“%1” has no finite value.</source>
        <translation>«%1» no tiene un valor finito.</translation>
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
        <source>Saving “%1” was cancelled. The file on disk is unchanged.</source>
        <translation>Se canceló el guardado de «%1». El archivo del disco sigue como estaba.</translation>
    </message>
    <message>
        <source>Adjust Picture Paths</source>
        <translation>Ajustar las rutas de las imágenes</translation>
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
    <message>
        <source>%1 Glow</source>
        <translation>Resplandor %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>De %1 a %2</translation>
    </message>
    <message>
        <source>%1 into %2</source>
        <translation>%1 contra %2</translation>
    </message>
    <message>
        <source>%1 Spectrum</source>
        <translation>Espectro desde %1</translation>
    </message>
    <message>
        <source>%1 Pastel</source>
        <translation>Pastel %1</translation>
    </message>
    <message>
        <source>%1 Metal</source>
        <translation>Metal %1</translation>
    </message>
    <message>
        <source>%1 Bands</source>
        <translation>Bandas %1</translation>
    </message>
    <message>
        <source>%1 Ink</source>
        <translation>Tinta %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 Twilight</source>
        <translation>Crepúsculo %1</translation>
    </message>
    <message>
        <source>%1 Wheel</source>
        <translation>Rueda desde %1</translation>
    </message>
    <message>
        <source>Rose</source>
        <translation>Rosa</translation>
    </message>
    <message>
        <source>Crimson</source>
        <translation>Carmesí</translation>
    </message>
    <message>
        <source>Scarlet</source>
        <translation>Escarlata</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>Bermellón</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Naranja</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Ámbar</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>Oro</translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation>Limón</translation>
    </message>
    <message>
        <source>Lime</source>
        <translation>Lima</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>Hierba</translation>
    </message>
    <message>
        <source>Emerald</source>
        <translation>Esmeralda</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>Jade</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>Verde azulado</translation>
    </message>
    <message>
        <source>Sea</source>
        <translation>Mar</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cian</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Cielo</translation>
    </message>
    <message>
        <source>Azure</source>
        <translation>Azur</translation>
    </message>
    <message>
        <source>Cobalt</source>
        <translation>Cobalto</translation>
    </message>
    <message>
        <source>Sapphire</source>
        <translation>Zafiro</translation>
    </message>
    <message>
        <source>Indigo</source>
        <translation>Índigo</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violeta</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>Púrpura</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Fuchsia</source>
        <translation>Fucsia</translation>
    </message>
</context>
<context>
    <name>PlacementBanner</name>
    <message>
        <source>Saved with dragged corners</source>
        <translation>Guardado con vértices movidos</translation>
    </message>
    <message>
        <source>Other programs will show “%1” without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>Otros programas mostrarán «%1» sin los vértices que usted movió, que se guardan en comentarios. Incorporar los pasa a los números que lee cualquier programa.</translation>
    </message>
    <message numerus="yes">
        <source>Other programs will show %n entries without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>
            <numerusform>Otros programas mostrarán %n entrada sin los vértices que usted movió, que se guardan en comentarios. Incorporar los pasa a los números que lee cualquier programa.</numerusform>
            <numerusform>Otros programas mostrarán %n entradas sin los vértices que usted movió, que se guardan en comentarios. Incorporar los pasa a los números que lee cualquier programa.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Incorporar</translation>
    </message>
    <message>
        <source>Writes the placements into the code, as one step of the history.</source>
        <translation>Escribe las colocaciones en el código: un paso del historial.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Bake the placements into the code</source>
        <translation>Incorporar las colocaciones al código</translation>
    </message>
    <message>
        <source>Not baked, because no code has this picture or keys move it: %1.</source>
        <translation>No se ha incorporado, porque ningún código da esta imagen o la mueven fotogramas clave: %1.</translation>
    </message>
    <message>
        <source>This cage cannot be baked: it bends or flattens the picture, or keys move it.</source>
        <translation>Esta jaula no se puede incorporar: dobla o aplasta la imagen, o la mueven claves.</translation>
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
        <source>In the last session, Barycage ended before this work was saved:</source>
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
        <source>Unsaved work cannot be kept for recovery: the folder “%1” is not writable, or the disk is full. Save often.</source>
        <translation>El trabajo sin guardar no se puede conservar para recuperarlo: no se puede escribir en la carpeta «%1», o el disco está lleno. Guarde a menudo.</translation>
    </message>
    <message>
        <source>The unsaved work from the last session is damaged and cannot be recovered. What remains of it is in:</source>
        <translation>El trabajo sin guardar de la última vez está dañado y no se puede recuperar. Lo que queda de él está en:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Buscando trabajo sin guardar…</translation>
    </message>
    <message numerus="yes">
        <source>(%n windows)</source>
        <translation>
            <numerusform>(%n ventana)</numerusform>
            <numerusform>(%n ventanas)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SnapshotBanner</name>
    <message>
        <source>Snapshot on the canvas</source>
        <translation>Instantánea en el lienzo</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B: %1</translation>
    </message>
    <message>
        <source>Back to the Fractal</source>
        <translation>Volver al fractal</translation>
    </message>
    <message>
        <source>Shows the fractal again. Nothing has changed.</source>
        <translation>Vuelve a mostrar el fractal. Nada ha cambiado.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Restores the fractal to this snapshot, as one step of the history.</source>
        <translation>Deja el fractal como estaba en esta instantánea: un paso del historial.</translation>
    </message>
    <message>
        <source>The canvas shows “%1”.</source>
        <translation>El lienzo muestra «%1».</translation>
    </message>
</context>
<context>
    <name>SnapshotCommands</name>
    <message>
        <source>Snapshots cannot be compared while a fractal transformation is shown.</source>
        <translation>No se pueden comparar instantáneas mientras se muestra una transformación fractal.</translation>
    </message>
    <message>
        <source>Ta&amp;ke Snapshot</source>
        <translation>Tomar una &amp;instantánea</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Keep the current state of this fractal in the Snapshots panel</source>
        <translation>Guardar el estado actual de este fractal en el panel «Instantáneas»</translation>
    </message>
    <message>
        <source>C&amp;ompare with Snapshot</source>
        <translation>&amp;Comparar con la instantánea</translation>
    </message>
    <message>
        <source>Q</source>
        <translation>Q</translation>
    </message>
    <message>
        <source>Kept as “%1”. To see it, choose View, Panels, Snapshots.</source>
        <translation>Guardado como «%1». «Ver», «Paneles», «Instantáneas» la muestra.</translation>
    </message>
    <message>
        <source>Show the snapshot selected in the Snapshots panel, or the newest one, in place of the fractal; to return, press the key again, or hold it and release it</source>
        <translation>Mostrar en lugar del fractal la instantánea seleccionada en el panel «Instantáneas», o la más reciente; pulse de nuevo, o mantenga la tecla y suéltela, para volver</translation>
    </message>
    <message>
        <source>Snapshots can be compared only while the density is shown. Choose Density in the bar under the canvas first.</source>
        <translation>Las instantáneas solo se pueden comparar mientras se muestra la densidad. Elija antes «Densidad» en la barra bajo el lienzo.</translation>
    </message>
</context>
<context>
    <name>SpaceBranch</name>
    <message>
        <source>No branch can be selected here: the address of this point is not known.</source>
        <translation>Aquí no se puede elegir ninguna rama: no se conoce la dirección de este punto.</translation>
    </message>
    <message>
        <source>A branch cannot be dragged while it or the cage is flat.</source>
        <translation>Una rama no se puede arrastrar mientras ella o la jaula sea plana.</translation>
    </message>
</context>
<context>
    <name>SpaceDefinition</name>
    <message>
        <source>Click the first of the four corners. The picture stays where it is; Esc cancels.</source>
        <translation>Haga clic en el primero de los cuatro vértices. La imagen no se mueve; Esc cancela.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Haga clic en el segundo vértice. Retroceso quita el último punto.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Haga clic en el tercer vértice. Retroceso quita el último punto.</translation>
    </message>
    <message>
        <source>Click the fourth corner, in front of the other three. The wheel pushes it away, and the right button turns the view.</source>
        <translation>Haga clic en el cuarto vértice, delante de los otros tres. La rueda lo aleja y el botón derecho gira la vista.</translation>
    </message>
</context>
<context>
    <name>SpaceMapDrag</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Detenido: más allá, la rama no se haría más pequeña dentro de sí misma.</translation>
    </message>
</context>
<context>
    <name>SpaceMaps</name>
    <message>
        <source>Maps cannot be dragged while the cage is flat. First open or reset the cage.</source>
        <translation>No se pueden arrastrar aplicaciones mientras la jaula es plana. Antes abra la jaula o restablézcala.</translation>
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
        <source>Pointer position</source>
        <translation>Posición del puntero</translation>
    </message>
    <message>
        <source>Existence of an attractor</source>
        <translation>Existencia de un atractor</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and its contraction factor</source>
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
        <source>Plane and barycentric coordinates of the pointer; the address of the point of the attractor under it, outermost map first, and the fixed point of its branch</source>
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
        <source>latest changes not yet kept for recovery</source>
        <translation>últimos cambios aún no conservados para recuperarlos</translation>
    </message>
    <message>
        <source>A crash would lose your latest changes: keeping them takes longer than two seconds, because the disk is slow or full or the file is very large. Save what you do not want to lose.</source>
        <translation>Un fallo haría perder los últimos cambios: conservarlos tarda más de dos segundos, porque el disco es lento o está lleno, o porque el archivo es muy grande. Guarde lo que no deba perderse.</translation>
    </message>
    <message>
        <source>  depth %1</source>
        <translation>  profundidad %1</translation>
    </message>
    <message>
        <source>  along %1</source>
        <translation>  a lo largo de %1</translation>
    </message>
    <message>
        <source>  across %1</source>
        <translation>  perpendicular a %1</translation>
    </message>
    <message>
        <source>  along the normal</source>
        <translation>  a lo largo de la normal</translation>
    </message>
    <message>
        <source>  azimuth %1°  elevation %2°</source>
        <translation>  acimut %1°  elevación %2°</translation>
    </message>
    <message>
        <source>Rotation of the view</source>
        <translation>Giro de la vista</translation>
    </message>
    <message>
        <source>How far the view is turned, counter-clockwise; choose View, Rotate View, Reset Rotation to return it to upright</source>
        <translation>Cuánto está girada la vista en sentido antihorario; elija Ver, Girar la vista, Restablecer el giro para volver a enderezarla</translation>
    </message>
    <message>
        <source>rotated %1°</source>
        <translation>girada %1°</translation>
    </message>
    <message>
        <source>attractor: %1</source>
        <translation>atractor: %1</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>El sistema de la imagen ocupa más de 8 MB.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>El sistema de la imagen está dañado.</translation>
    </message>
    <message>
        <source>The picture contains a document type declaration, which Barycage neither writes nor reads.</source>
        <translation>La imagen declara un tipo de documento, cosa que Barycage nunca escribe y no lee.</translation>
    </message>
    <message>
        <source>The file is not an SVG picture, or it is damaged.</source>
        <translation>El archivo no es una imagen SVG o está dañado.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed it.</source>
        <translation>La imagen no contiene ningún sistema: no la escribió Barycage, u otro programa lo eliminó.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a flame file cannot contain a document type declaration</source>
        <translation>no se admite un tipo de documento en un archivo flame</translation>
    </message>
    <message>
        <source>The XML cannot be read beyond this point: %1.</source>
        <translation>El XML termina aquí: %1.</translation>
    </message>
    <message>
        <source>The file contains no flames.</source>
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
        <source>no attractor</source>
        <translation>sin atractor</translation>
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
        <source>it uses the variation “%1”</source>
        <translation>usa la variación «%1»</translation>
    </message>
    <message>
        <source>it is active but not drawn (opacity 0)</source>
        <translation>interviene sin dibujarse (opacidad 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>su peso no es un número</translation>
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
        <source>The entry that starts here has no closing “}” before the next entry or the end of the file.</source>
        <translation>La entrada que se abre aquí no se cierra con «}» antes de la siguiente entrada o del final del archivo.</translation>
    </message>
    <message>
        <source>The name “%1” contains a control character, at which other programs may end it.</source>
        <translation>El nombre «%1» contiene un carácter de control, en el que otros programas pueden terminarlo.</translation>
    </message>
    <message>
        <source>The name “%1” contains a space; Fractint uses only its first word.</source>
        <translation>El nombre «%1» contiene un espacio; Fractint toma solo la primera palabra.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint truncates it.</source>
        <translation>El nombre «%1» tiene más de 18 bytes; Fractint lo corta ahí.</translation>
    </message>
    <message>
        <source>The opening brace is on a line of its own; Fractint does not find this entry.</source>
        <translation>La llave de apertura está sola en una línea; Fractint no encuentra esta entrada.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>La entrada tiene más de %1 aplicaciones, que es el límite.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be a decimal comma or a separator; both readings give complete rows. Use decimal points and spaces.</source>
        <translation>«%1»: la coma se puede leer como signo decimal o como separador de números, y en ambos casos salen filas completas. Escriba puntos decimales y espacios.</translation>
    </message>
    <message>
        <source>“%1”: the comma gives complete rows of 7 numbers (13 with “(3D)”) neither as a decimal comma nor as a separator.</source>
        <translation>«%1»: ni como signo decimal ni como separador da la coma filas completas de 7 números (13 con «(3D)»).</translation>
    </message>
    <message>
        <source>Numbers on the line of the opening brace are ignored, as in Fractint.</source>
        <translation>Los números de la línea de la llave de apertura no se tienen en cuenta, igual que en Fractint.</translation>
    </message>
    <message>
        <source>This version of Barycage does not understand “%1”; the line is kept.</source>
        <translation>Esta versión de Barycage no entiende «%1»; la línea se conserva.</translation>
    </message>
    <message>
        <source>The entry contains no numbers.</source>
        <translation>La entrada no contiene números.</translation>
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
        <source>“%1” is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>«%1» es mayor de lo que puede ser un coeficiente (3.4e38 en valor absoluto).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Use a plain “-”.</source>
        <translation>«%1» empieza con un signo menos tipográfico (U+2212). Escriba el simple «-».</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>There are numbers on the line of the opening brace, where Fractint ignores them; Barycage reads them.</source>
        <translation>Hay números en la línea de la llave de apertura, donde Fractint los omite; aquí se leen.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads different numbers here.</source>
        <translation>Las comas se leen como signos decimales; Fractint lee aquí otros números.</translation>
    </message>
    <message>
        <source>Commas or apostrophes separate the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Hay comas o apóstrofos entre los números; Iterated Dynamics no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each), so the weights are computed from the determinants. Fractint cannot read this entry.</source>
        <translation>Las aplicaciones no tienen pesos (%1 números cada una); los pesos se toman de los determinantes. Fractint no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Las filas de %1 números sin «(3D)» tras el nombre se leen como un sistema 3D; Fractint no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>The lines do not have 7 numbers each, but together the numbers fill rows of 7 and are read that way, as in Fractint. The weights are probably missing.</source>
        <translation>Las líneas no contienen 7 números cada una, pero todos los números juntos llenan filas de 7 y así se leen, como hace Fractint. Probablemente faltan los pesos.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>La llave de cierre toca el último número; Fractint no puede leer esta entrada.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint truncates it.</source>
        <translation>La línea tiene más de 200 bytes; Fractint la corta ahí.</translation>
    </message>
    <message>
        <source>There is a NUL byte here; the rest of the line is ignored, as in Fractint.</source>
        <translation>Un byte NUL; el resto de la línea se omite, como hace Fractint.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>La entrada tiene %1 aplicaciones; Fractint e Iterated Dynamics leen a lo sumo 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map is treated as switched off.</source>
        <translation>El peso de la aplicación %1 es negativo; la aplicación cuenta como desactivada.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0, so the map is inactive.</source>
        <translation>El peso de la aplicación %1 es 0; la aplicación no interviene.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are scaled in proportion; Fractint gives any shortfall to the last map and cuts off any excess.</source>
        <translation>Los pesos suman %1, no 1. Se usan en proporción; Fractint da lo que falta a la última aplicación y recorta lo que sobra.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>El archivo está vacío.</translation>
    </message>
    <message>
        <source>The file contains Fractint parameter sets or formulas, but no iterated function system.</source>
        <translation>Son conjuntos de parámetros o fórmulas de Fractint; entre ellos no hay ningún sistema de funciones iteradas.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry consists of a name, “{”, rows of 7 numbers and “}”.</source>
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
        <source>There are two opening braces on one line: no program finds an entry here. The text is kept.</source>
        <translation>Dos llaves de apertura en una línea: ningún programa encuentra aquí una entrada. El texto se conserva.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>«%1» es un conjunto de parámetros o una fórmula, no un sistema de funciones iteradas; se conserva como texto.</translation>
    </message>
    <message>
        <source>The entry in line %1 has the same name (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>El nombre ya lo lleva la entrada de la línea %1 (Fractint compara 18 caracteres sin distinguir mayúsculas); Fractint nunca llega a esta.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint treats as part of the first name.</source>
        <translation>El archivo empieza con una marca de orden de bytes, que Fractint toma por una parte del primer nombre.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); Barycage reads the entries after it too.</source>
        <translation>Fractint deja de leer en este byte (^Z); aun así se leen las entradas que siguen.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use only the first 2000.</source>
        <translation>El archivo tiene %1 entradas; Fractint e Iterated Dynamics usan las primeras 2000.</translation>
    </message>
    <message>
        <source>The entry has no active map and is omitted.</source>
        <translation>La entrada no tiene ninguna aplicación que intervenga y se omite.</translation>
    </message>
    <message>
        <source>The entry is saved under the name “%1”: other programs need unique names of at most 18 plain characters.</source>
        <translation>La entrada se escribe con el nombre «%1»: otros programas admiten 18 caracteres simples, y cada nombre una sola vez.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>La entrada tiene %1 aplicaciones; Fractint hasta la versión 17.2 lee a lo sumo 31.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>sin decidir</translation>
    </message>
    <message>
        <source>none: no map is active</source>
        <translation>ninguno: ninguna aplicación está activa</translation>
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
        <source>similarity dimension</source>
        <translation>dimensión de semejanza</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>dimensión de afinidad</translation>
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
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its rest polygon is flat, crosses itself or has more than 64 vertices.</source>
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
        <source>A palette can have at most %1 colours; the rest are ignored.</source>
        <translation>Una paleta tiene a lo sumo %1 colores; los demás se omiten.</translation>
    </message>
    <message>
        <source>This line is ignored: a colour consists of three whole numbers from 0 to 255.</source>
        <translation>Esta línea se omite: un color son tres números enteros de 0 a 255.</translation>
    </message>
    <message>
        <source>The file contains no colours.</source>
        <translation>El archivo no contiene colores.</translation>
    </message>
    <message>
        <source>The file is larger than 16 MB, which is the limit for a palette.</source>
        <translation>El archivo ocupa más de 16 MB, que ninguna paleta necesita.</translation>
    </message>
    <message>
        <source>The file is not a text file, so it is not a palette.</source>
        <translation>El archivo no es texto, así que no es una paleta.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the rest are ignored.</source>
        <translation>El archivo tiene más de %1 paletas; las demás se omiten.</translation>
    </message>
    <message>
        <source>The file contains no gradients.</source>
        <translation>El archivo no contiene ningún degradado.</translation>
    </message>
    <message>
        <source>The gradient that starts in line %1 is not closed.</source>
        <translation>El degradado de la línea %1 no está cerrado.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>«%1» no es un número entero.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so it has no points.</source>
        <translation>«%1» no tiene ninguna aplicación que intervenga, así que no tiene puntos.</translation>
    </message>
    <message>
        <source>A point cloud can have from 1 to %1 points.</source>
        <translation>Una nube de puntos tiene de 1 a %1 puntos.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>«%1» es una carpeta. Elija un nombre de archivo.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and will not be replaced. Choose another name.</source>
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
        <source>“%1” was not saved: you do not have permission to write to the folder “%2”. Save somewhere else.</source>
        <translation>No se guardó «%1»: no tiene permiso para escribir en la carpeta «%2». Guarde en otro lugar.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>No se guardó «%1»: el nombre es demasiado largo.</translation>
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
        <source>Only systems in the plane can be written as vector graphics.</source>
        <translation>Solo los sistemas del plano se pueden escribir como gráficos vectoriales.</translation>
    </message>
    <message>
        <source>No outline of an attractor could be certified for this system, so there is nothing to copy.</source>
        <translation>El sistema no tiene un atractor cuyo contorno se pueda demostrar, así que no hay nada de lo que hacer copias.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>En esta vista la imagen es demasiado grande para escribirla como formas.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row consists of a b c d e f and optionally a weight.</source>
        <translation>No hay filas de números: una fila es a b c d e f y, si acaso, un peso.</translation>
    </message>
    <message>
        <source>After the count, a map consists of its weight and a matrix of 3 rows.</source>
        <translation>Tras el número de aplicaciones, cada aplicación es su peso y una matriz de 3 filas.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map must be 0 0 1.</source>
        <translation>La última fila de la matriz de una aplicación afín es 0 0 1.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>El encabezado no dice qué columna es a, b, c, d, e y f; elija el orden de las columnas.</translation>
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
        <source>This is a %1 file, not a text file with iterated function systems.</source>
        <translation>Esto es un archivo %1, no un texto con sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>This text is encoded in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
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
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text file with iterated function systems.</source>
        <translation>Esto es un archivo binario (quizá una imagen con compresión fractal o una biblioteca de iconos), no un texto con sistemas de funciones iteradas.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and the file is too large for a table of numbers: the limit is 64 MB.</source>
        <translation>No se encontró ningún sistema de funciones iteradas, y para una tabla de números el archivo es demasiado grande: el límite es de 64 MB.</translation>
    </message>
    <message>
        <source>a number is too large for a coefficient (the largest absolute value is 3.4e38)</source>
        <translation>un número es mayor de lo que puede ser un coeficiente (3.4e38 en valor absoluto)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest are ignored.</source>
        <translation>El archivo tiene más de %1 llamas; el resto se omite.</translation>
    </message>
    <message>
        <source>%1 flames in total are not systems of affine maps.</source>
        <translation>%1 llamas en total no son sistemas de aplicaciones afines.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>La entrada tiene más de %1 líneas, que es el límite; se conserva como texto.</translation>
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
        <source>A number in this row is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>Un número de esta fila es mayor de lo que puede ser un coeficiente (3.4e38 en valor absoluto).</translation>
    </message>
    <message>
        <source>The text is larger than 64 MB, which is the limit for a table of numbers.</source>
        <translation>El texto tiene más de 64 MB, que es el límite para una tabla de números.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Una etiqueta tiene más de %1 atributos, que es el límite.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 levels deep, which is the limit.</source>
        <translation>Los elementos están anidados a más de %1 niveles, que es el límite.</translation>
    </message>
    <message>
        <source>The file is larger than 64 MB, which is the limit for XML.</source>
        <translation>El archivo tiene más de 64 MB, que es el límite para XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>rama desplazada</translation>
    </message>
    <message>
        <source>The stored position of a branch is not valid and is not applied: its map is incomplete, its address names maps that do not exist or occurs twice, or there are too many.</source>
        <translation>Un lugar guardado de una rama no es utilizable (su aplicación está incompleta, su dirección nombra aplicaciones que no existen o aparece dos veces, o hay demasiados) y no se aplica.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Una celda de esta fila está vacía.</translation>
    </message>
    <message>
        <source>A comma can be a decimal comma or a separator here; both readings give complete rows. Use decimal points.</source>
        <translation>Aquí la coma se puede leer como signo decimal o como separador de números, y en ambos casos salen filas completas. Escriba puntos decimales.</translation>
    </message>
    <message>
        <source>The table mixes maps of the plane and maps of space.</source>
        <translation>La tabla tiene aplicaciones del plano y aplicaciones del espacio.</translation>
    </message>
    <message>
        <source>This is a list of other files, as used by the program Fraktale, not a Fractint collection.</source>
        <translation>Esto es una lista de otros archivos, como la del programa Fraktale, no una colección de Fractint.</translation>
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
        <source>There is no column “%1”: the columns are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Ninguna columna se llama «%1»: son a b c d o r s theta phi, e f, y p o cumulative.</translation>
    </message>
    <message>
        <source>“%1” occurs twice.</source>
        <translation>«%1» aparece dos veces.</translation>
    </message>
    <message>
        <source>A row has only one weight: p or cumulative.</source>
        <translation>Una fila tiene un solo peso: p o cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi cannot be combined.</source>
        <translation>a b c d y r s theta phi no van juntos.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Falta: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than other programs can read in one path. Choose a smaller depth.</source>
        <translation>El contorno tiene más vértices de los que los programas leen en un solo trazado. Elija una profundidad menor.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers describe the picture at rest.</source>
        <translation>La jaula dobla o aplana la imagen. Los números son los de la imagen en reposo.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid UTF-8. Rename the file, or open it through a symbolic link.</source>
        <translation>El nombre «%1» no es UTF-8 válido. Cambie el nombre del archivo o ábralo mediante un enlace simbólico.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so all weights are computed from the determinants and the given ones are ignored.</source>
        <translation>La aplicación %1 no tiene peso; por eso los pesos de todas las aplicaciones se toman de los determinantes, y los indicados no se usan.</translation>
    </message>
    <message>
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its vertices at rest are in one plane or coincide.</source>
        <translation>La jaula guardada no se puede usar (sus listas de vértices no se corresponden, o sus vértices de reposo están en un mismo plano o coinciden) y no se aplica.</translation>
    </message>
    <message>
        <source>This entry is %1-dimensional, but its stored cage or moved branches are not: they are not applied, and their lines are kept.</source>
        <translation>Esta entrada tiene %1 dimensiones, pero su jaula guardada o sus ramas desplazadas no: no se aplican y sus líneas se conservan.</translation>
    </message>
    <message>
        <source>none: ρ(A) ≥ 1 for the word %1</source>
        <translation>ninguno: ρ(A) ≥ 1 para la palabra %1</translation>
    </message>
    <message>
        <source>(of the attractor: its pieces are disjoint)</source>
        <translation>(del atractor: sus piezas son disjuntas)</translation>
    </message>
    <message>
        <source>(upper bound: pieces coincide)</source>
        <translation>(cota superior: hay piezas que coinciden)</translation>
    </message>
    <message>
        <source>(if the open set condition holds; else an upper bound)</source>
        <translation>(si se cumple la condición del conjunto abierto; si no, una cota superior)</translation>
    </message>
    <message>
        <source>strong: no two pieces meet</source>
        <translation>fuerte: no se tocan dos piezas</translation>
    </message>
    <message>
        <source>none: pieces coincide</source>
        <translation>ninguna: hay piezas que coinciden</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>conexo</translation>
    </message>
    <message>
        <source>connected, within rounding error</source>
        <translation>conexo, hasta donde deja ver el redondeo</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>no conexo</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>separación</translation>
    </message>
    <message>
        <source>connectedness</source>
        <translation>conexión</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>solapamiento</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map</source>
        <translation>las palabras %1 y %2 son la misma aplicación</translation>
    </message>
    <message>
        <source>joint spectral radius</source>
        <translation>radio espectral conjunto</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 y %2</translation>
    </message>
    <message>
        <source>entropy</source>
        <translation>entropía</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Exponente de Liapunov</translation>
    </message>
    <message>
        <source>dimension of measure</source>
        <translation>dimensión de la medida</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of 6 numbers, line by line, or as %2 maps of 7 numbers, whose weights then sum to 1. They are read line by line; for the other reading, put 7 numbers on each line.</source>
        <translation>Los números pueden leerse línea a línea como %1 aplicaciones de 6 números, o como %2 aplicaciones de 7 números, cuyos pesos suman entonces 1. Se leen línea a línea; para la otra lectura, ponga 7 números en cada línea.</translation>
    </message>
    <message>
        <source>The block names no maps: a line such as “A=(f1|f2)*A” is missing.</source>
        <translation>El bloque no nombra aplicaciones: falta una línea como «A=(f1|f2)*A».</translation>
    </message>
    <message>
        <source>“%1” is not understood: Barycage reads blocks of affine maps, such as “f1=[e,f]*[a,b,c,d]” and “A=(f1|f2)*A”.</source>
        <translation>No se entiende «%1»: Barycage lee bloques de aplicaciones afines, como «f1=[e,f]*[a,b,c,d]» y «A=(f1|f2)*A».</translation>
    </message>
    <message>
        <source>The file has more than %1 blocks, which is the limit; the rest was not read.</source>
        <translation>El archivo tiene más de %1 bloques, que es el límite; el resto no se ha leído.</translation>
    </message>
    <message>
        <source>This IFStile file contains no affine system.</source>
        <translation>Este archivo de IFStile no contiene ningún sistema afín.</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of %2 numbers, line by line, or as %3 maps of 7 numbers, whose weights then sum to 1. They are read line by line, unlike in Fractint; for the other reading, put 7 numbers on each line.</source>
        <translation>Los números pueden leerse línea a línea como %1 aplicaciones de %2 números, o como %3 aplicaciones de 7 números, cuyos pesos suman entonces 1. Se leen línea a línea, a diferencia de Fractint; para la otra lectura, ponga 7 números en cada línea.</translation>
    </message>
    <message>
        <source>The numbers are read line by line, as %1 maps of %2 numbers. Fractint ignores line ends and reads %3 maps of 7 numbers.</source>
        <translation>Los números se leen línea a línea, como %1 aplicaciones de %2 números. Fractint no tiene en cuenta los finales de línea y lee %3 aplicaciones de 7 números.</translation>
    </message>
    <message>
        <source>Entries whose names begin with “ifs:” belong in parameter files (.par); in a collection, Fractint takes the prefix as part of the name.</source>
        <translation>Las entradas cuyo nombre empieza por «ifs:» pertenecen a los archivos de parámetros (.par); en una colección, Fractint toma el prefijo como parte del nombre.</translation>
    </message>
    <message>
        <source>The lines end with CR alone, as on old Macintosh computers; Fractint reads such a file as a single line.</source>
        <translation>Las líneas terminan solo con CR, como en los antiguos Macintosh; Fractint lee un archivo así como una sola línea.</translation>
    </message>
    <message>
        <source>The convex hull has an error of up to %1: the tolerance %2 was not reached.</source>
        <translation>La envolvente convexa tiene un error de hasta %1: no se alcanzó la tolerancia %2.</translation>
    </message>
    <message>
        <source>contractive in an ellipsoidal norm, γ %1</source>
        <translation>contractivo en una norma elipsoidal, γ %1</translation>
    </message>
    <message>
        <source>contractive in a polytope norm, γ %1</source>
        <translation>contractivo en una norma politopal, γ %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ %1 from words of length %2</source>
        <translation>finalmente contractivo, γ %1 a partir de palabras de longitud %2</translation>
    </message>
    <message>
        <source>hyperbolic, s %1</source>
        <translation>hiperbólico, s %1</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 aplicación</translation>
    </message>
    <message>
        <source>%1 maps</source>
        <translation>%1 aplicaciones</translation>
    </message>
    <message>
        <source>%1 — in space, %2</source>
        <translation>%1: en el espacio, %2</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2</source>
        <translation>%1: en el plano, %2</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>no se pudo leer</translation>
    </message>
    <message>
        <source>in space, %1</source>
        <translation>en el espacio, %1</translation>
    </message>
    <message>
        <source>in the plane, %1</source>
        <translation>en el plano, %1</translation>
    </message>
    <message>
        <source>its cage</source>
        <translation>su jaula</translation>
    </message>
    <message>
        <source>its moved branches</source>
        <translation>sus ramas movidas</translation>
    </message>
    <message>
        <source>its palette</source>
        <translation>su paleta</translation>
    </message>
    <message>
        <source>its background</source>
        <translation>su fondo</translation>
    </message>
    <message>
        <source>its other colour settings</source>
        <translation>sus demás ajustes de color</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>“%1” is written without %2: other programs will draw a different picture.</source>
        <translation>«%1» se escribe sin %2: otros programas dibujarán una imagen diferente.</translation>
    </message>
    <message>
        <source>“%1” is written without %2.</source>
        <translation>«%1» se escribe sin %2.</translation>
    </message>
    <message>
        <source>The stored animation is not applied, because “%1” is not understood; its lines are kept.</source>
        <translation>La animación guardada no se aplica porque no se entiende «%1»; sus líneas se conservan.</translation>
    </message>
    <message>
        <source>The entry has more than one stored animation: the last valid one is used, and the lines of the others are kept.</source>
        <translation>La entrada tiene más de una animación guardada: se usa la última válida y se conservan las líneas de las demás.</translation>
    </message>
    <message>
        <source>The stored animation is not valid and is not applied: it moves maps or vertices that do not exist, a frame, number or curve is out of its range, or keys are not in order. Its lines are kept.</source>
        <translation>La animación guardada no es válida y no se aplica: mueve aplicaciones o vértices que no existen, un fotograma, un número o una curva están fuera de su intervalo, o los fotogramas clave no están en orden. Sus líneas se conservan.</translation>
    </message>
    <message>
        <source>in a cycle</source>
        <translation>en bucle</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>ida y vuelta</translation>
    </message>
    <message>
        <source>once</source>
        <translation>una vez</translation>
    </message>
    <message>
        <source>animation</source>
        <translation>animación</translation>
    </message>
    <message>
        <source>This is not the format of a fractal program. Its lists of numbers are read as tables of maps (systems: %1, maps: %2), in the order a b c d e f unless names give another order.</source>
        <translation>Esto no es un formato de programas de fractales. Sus listas de números se leen como tablas de aplicaciones (sistemas: %1, aplicaciones: %2), en el orden a b c d e f donde los nombres no indican otro.</translation>
    </message>
    <message>
        <source>it acts in space after its variations (“%1”)</source>
        <translation>actúa en el espacio después de sus variaciones («%1»)</translation>
    </message>
    <message>
        <source>its “%1” is not six numbers</source>
        <translation>su «%1» no son seis números</translation>
    </message>
    <message>
        <source>The flame names a palette of another program by its number; its colours are not in the file.</source>
        <translation>El flame indica solo el número de una paleta de otro programa; sus colores no están en el archivo.</translation>
    </message>
    <message>
        <source>“%1” could not be read, so it has no points.</source>
        <translation>«%1» no se pudo leer, así que no tiene puntos.</translation>
    </message>
    <message>
        <source>This is JSON text (data of another program), not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>Esto es texto JSON (datos de otro programa), no una colección de Fractint, y ninguna de sus listas es de aplicaciones afines.</translation>
    </message>
    <message>
        <source>This is the text of a program, not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>Esto es el texto de un programa, no una colección de Fractint, y ninguna de sus listas es de aplicaciones afines.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it has no solid.</source>
        <translation>«%1» no es un sistema del espacio, así que no tiene sólido.</translation>
    </message>
    <message>
        <source>The cage of “%1” bends the picture, so its solid cannot be written.</source>
        <translation>La jaula de «%1» curva la imagen, así que su sólido no se puede escribir.</translation>
    </message>
    <message>
        <source>“%1” has no certified attractor, so it has no solid.</source>
        <translation>«%1» no tiene un atractor certificado, así que no tiene sólido.</translation>
    </message>
    <message>
        <source>“%1” would need more than %2 parts in OpenSCAD. Choose larger voxels.</source>
        <translation>«%1» necesitaría más de %2 partes en OpenSCAD. Elija vóxeles más grandes.</translation>
    </message>
    <message>
        <source>“%1” is too large for a solid.</source>
        <translation>«%1» es demasiado grande para un sólido.</translation>
    </message>
    <message>
        <source>“%1” is a single point: only the size of its voxel can be chosen.</source>
        <translation>«%1» es un solo punto: solo se puede elegir el tamaño de su vóxel.</translation>
    </message>
    <message>
        <source>The surface of “%1” is not closed, so it was not written.</source>
        <translation>La superficie de «%1» no es cerrada, así que no se escribió.</translation>
    </message>
    <message>
        <source>Size: %1 × %2 × %3 mm; volume: %4 mm³; triangles: %5.</source>
        <translation>Tamaño: %1 × %2 × %3 mm; volumen: %4 mm³; triángulos: %5.</translation>
    </message>
    <message>
        <source>Distance from the attractor: at most %1 mm = √3 · %2 mm + %3 mm for the wall.</source>
        <translation>Distancia al atractor: como mucho %1 mm = √3 · %2 mm + %3 mm por la pared.</translation>
    </message>
    <message>
        <source>Cavities filled: %1, with %2 mm³.</source>
        <translation>Cavidades rellenadas: %1, con %2 mm³.</translation>
    </message>
    <message>
        <source>Closed cavities: %1, with %2 mm³.</source>
        <translation>Cavidades cerradas: %1, con %2 mm³.</translation>
    </message>
    <message>
        <source>Separate bodies: %1.</source>
        <translation>Cuerpos separados: %1.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>«%1»: %2</translation>
    </message>
    <message>
        <source>“%1” belongs to another picture: the entry, the view, the size, the seed or the format differs.</source>
        <translation>«%1» es de otra imagen: la entrada, la vista, el tamaño, la semilla o el formato son distintos.</translation>
    </message>
    <message>
        <source>“%1” belongs to a picture with a different number of points, so the sums cannot be combined.</source>
        <translation>«%1» es de una imagen con otro número de puntos, así que las sumas no se pueden añadir.</translation>
    </message>
    <message>
        <source>“%1” and “%2” hold the same part of the picture, which would be counted twice.</source>
        <translation>«%1» y «%2» contienen la misma parte de la imagen, que se contaría dos veces.</translation>
    </message>
    <message>
        <source>“%1” was written by another version of the program, which may draw other pixels.</source>
        <translation>«%1» fue escrito por otra versión del programa, que puede dibujar otros píxeles.</translation>
    </message>
    <message>
        <source>The picture is incomplete: only %1 % of it is present. Add the files of the other parts, or merge to a .sum file.</source>
        <translation>La imagen no está completa: hay un %1 %. Añada los archivos de las otras partes o escriba un archivo .sum.</translation>
    </message>
    <message>
        <source>This is not a file of sums.</source>
        <translation>No es un archivo de sumas.</translation>
    </message>
    <message>
        <source>The file of sums is damaged or incomplete.</source>
        <translation>El archivo de sumas está dañado o incompleto.</translation>
    </message>
    <message>
        <source>“%1” is a symbolic link that leads back to itself, or through too many others.</source>
        <translation>«%1» es un enlace simbólico que vuelve a sí mismo o pasa por demasiados otros.</translation>
    </message>
    <message>
        <source>You do not have permission to enter the folder “%1”.</source>
        <translation>No tiene permiso para entrar en la carpeta «%1».</translation>
    </message>
    <message>
        <source>not computed within the budget</source>
        <translation>no calculado dentro del tiempo asignado</translation>
    </message>
    <message>
        <source>A cage with more than four corners bends the solid; its points cannot be written.</source>
        <translation>Una jaula de más de cuatro vértices curva el sólido; sus puntos no se pueden escribir.</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
    <message>
        <source>The sheet would have %1 by %2 pixels; the limit is %3 pixels in width. Use smaller tiles or fewer columns.</source>
        <translation>La lámina tendría %1 por %2 píxeles; el ancho máximo es de %3 píxeles. Elija recuadros más pequeños o menos columnas.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it down.</source>
        <translation>La imagen tiene %1 × %2 píxeles. Se pueden leer como máximo 32 millones de píxeles; redúzcala.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. Each side needs at least %3 pixels.</source>
        <translation>La imagen tiene %1 × %2 píxeles. Cada lado necesita al menos %3 píxeles.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete.</source>
        <translation>La imagen está dañada o incompleta.</translation>
    </message>
    <message>
        <source>The picture is a JPEG in CMYK colours, which programs read differently. Convert it to RGB or grey levels.</source>
        <translation>La imagen es un JPEG en colores CMYK, que cada programa lee de otra manera. Conviértala a RGB o a niveles de gris.</translation>
    </message>
    <message>
        <source>The picture is animated. Save one of its frames as a picture of its own.</source>
        <translation>La imagen está animada. Guarde uno de sus fotogramas como imagen aparte.</translation>
    </message>
    <message>
        <source>The picture is too long and thin to be traced.</source>
        <translation>La imagen es demasiado larga y estrecha para calcarla.</translation>
    </message>
    <message>
        <source>There is no fractal transformation between these entries.</source>
        <translation>No hay transformación fractal entre estas entradas.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane.</source>
        <translation>«%1» no es un sistema del plano.</translation>
    </message>
    <message>
        <source>The cage of “%1” is flat or bends the picture. Bake or reset it first.</source>
        <translation>La jaula de «%1» es plana o dobla la imagen. Escríbala primero en el código o devuélvala al reposo.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so there is nothing to draw.</source>
        <translation>«%1» no tiene ninguna aplicación activa, así que no hay nada que dibujar.</translation>
    </message>
    <message>
        <source>No attractor could be proved for “%1”, so its points have no addresses.</source>
        <translation>«%1» no tiene un atractor demostrable, así que sus puntos no tienen direcciones.</translation>
    </message>
    <message>
        <source>The stored order does not list every active map of “%1” once.</source>
        <translation>El orden guardado no enumera una vez cada aplicación activa de «%1».</translation>
    </message>
    <message>
        <source>“%1” has %2 maps; with a symmetry of %3 elements they would be more than %4, which is the limit.</source>
        <translation>«%1» tiene %2 aplicaciones; con una simetría de %3 elementos serían más de %4, que es el límite.</translation>
    </message>
    <message>
        <source>The maps of “%1” move in its animation, and the copies that its symmetry makes would not move with them. Remove the motions and the keys of the maps first.</source>
        <translation>Las aplicaciones de «%1» se mueven en su animación, y las copias que crea su simetría no se moverían con ellas. Quite antes los movimientos y las claves de las aplicaciones.</translation>
    </message>
    <message>
        <source>its “chaos” is not a list of numbers from 0 upwards</source>
        <translation>su «chaos» no es una lista de números a partir de 0</translation>
    </message>
    <message>
        <source>its symmetry is not of a kind from −%1 to %1</source>
        <translation>su simetría no es de un tipo entre −%1 y %1</translation>
    </message>
    <message>
        <source>it links more than %1 transforms by “chaos”</source>
        <translation>enlaza más de %1 transformaciones mediante «chaos»</translation>
    </message>
    <message>
        <source>it links transforms in space by “chaos”</source>
        <translation>enlaza transformaciones del espacio mediante «chaos»</translation>
    </message>
    <message>
        <source>Maps of a system in space cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>Las aplicaciones de un sistema del espacio no se pueden enlazar: los enlaces no se aplican y sus líneas se conservan.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>No se pueden enlazar más de %1 aplicaciones: los enlaces no se aplican y sus líneas se conservan.</translation>
    </message>
    <message>
        <source>The links of map %1 are not valid, so no links are applied: a row of links has one number for each map, 0 or larger.</source>
        <translation>Los enlaces de la aplicación %1 no son válidos, así que no se aplica ninguno: una fila de enlaces tiene un número por aplicación, 0 o mayor.</translation>
    </message>
    <message>
        <source>With these links every sequence of maps ends, so no map is active.</source>
        <translation>Con estos enlaces toda sucesión de aplicaciones termina, así que no interviene ninguna.</translation>
    </message>
    <message>
        <source>With its stored symmetry the entry would have more than %1 maps, which is the limit. The symmetry is not applied; its lines are kept.</source>
        <translation>Con la simetría guardada, la entrada tendría más de %1 aplicaciones, que es el límite. La simetría no se aplica; sus líneas se conservan.</translation>
    </message>
    <message>
        <source>The maps are linked, so the picture is not made of copies of itself.</source>
        <translation>Las aplicaciones están enlazadas, así que la imagen no se compone de copias de sí misma.</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 vértice</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 vértices</translation>
    </message>
    <message>
        <source>%1, area %2; error at most %3; periodic addresses not computed within the budget</source>
        <translation>%1, área %2; error máximo %3; direcciones periódicas no calculadas dentro del límite de tiempo</translation>
    </message>
    <message>
        <source>%1, all of them with periodic addresses, area %2; exact</source>
        <translation>%1, todos con direcciones periódicas, área %2; exacta</translation>
    </message>
    <message>
        <source>%1, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1, %2 de ellos con direcciones periódicas, área %3; error máximo %4</translation>
    </message>
    <message>
        <source>%1, %2, volume %3; error at most %4</source>
        <translation>%1, %2, volumen %3; error máximo %4</translation>
    </message>
    <message>
        <source>1 facet</source>
        <translation>1 cara</translation>
    </message>
    <message>
        <source>%1 facets</source>
        <translation>%1 caras</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>al menos %1</translation>
    </message>
    <message>
        <source>(within rounding error)</source>
        <translation>(hasta donde deja ver el redondeo)</translation>
    </message>
    <message>
        <source>area of the tile</source>
        <translation>área de la tesela</translation>
    </message>
    <message>
        <source>dimension of boundary</source>
        <translation>dimensión de la frontera</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>simetría</translation>
    </message>
    <message>
        <source>takes no part: after it, the chaos game ends</source>
        <translation>no interviene: después de ella termina el juego del caos</translation>
    </message>
    <message>
        <source>takes no part: no map leads to it</source>
        <translation>no interviene: ninguna aplicación lleva a ella</translation>
    </message>
    <message>
        <source>takes no part: the chaos game leaves it and never returns</source>
        <translation>no interviene: el juego del caos la deja y no vuelve nunca</translation>
    </message>
    <message>
        <source>links from map %1</source>
        <translation>enlaces desde la aplicación %1</translation>
    </message>
    <message>
        <source>linked maps</source>
        <translation>aplicaciones enlazadas</translation>
    </message>
    <message>
        <source>separation, connectedness, joint spectral radius and periodic addresses are not computed for linked maps</source>
        <translation>la separación, la conexión, el radio espectral conjunto y las direcciones periódicas no se determinan para aplicaciones enlazadas</translation>
    </message>
    <message>
        <source>the links of its maps</source>
        <translation>los enlaces de sus aplicaciones</translation>
    </message>
    <message>
        <source>The symmetry of “%1” is written as the maps that it stands for.</source>
        <translation>La simetría de «%1» se escribe como las aplicaciones que representa.</translation>
    </message>
    <message>
        <source>, in a frame of its own</source>
        <translation>, en un sistema de referencia propio</translation>
    </message>
    <message>
        <source>mirror at %1° through %2</source>
        <translation>reflexión a %1° por %2</translation>
    </message>
    <message>
        <source>%1-fold rotation about %2</source>
        <translation>rotación de orden %1 alrededor de %2</translation>
    </message>
    <message>
        <source>%1-fold dihedral about %2, a mirror at %3°</source>
        <translation>diédrica de orden %1 alrededor de %2, con un espejo a %3°</translation>
    </message>
    <message>
        <source>rotations of the tetrahedron about %1</source>
        <translation>rotaciones del tetraedro alrededor de %1</translation>
    </message>
    <message>
        <source>rotations of the octahedron about %1</source>
        <translation>rotaciones del octaedro alrededor de %1</translation>
    </message>
    <message>
        <source>rotations of the icosahedron about %1</source>
        <translation>rotaciones del icosaedro alrededor de %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, so not every address is one of its points.</source>
        <translation>Las aplicaciones de «%1» están enlazadas, así que no toda dirección es uno de sus puntos.</translation>
    </message>
    <message>
        <source>A GIMP gradient states its number of segments here, from 1 to %1.</source>
        <translation>Un degradado de GIMP indica aquí su número de segmentos, de 1 a %1.</translation>
    </message>
    <message>
        <source>This is not a segment of a GIMP gradient that continues the one before.</source>
        <translation>Esto no es un segmento de un degradado de GIMP que continúe el anterior.</translation>
    </message>
    <message>
        <source>its fractal transformation</source>
        <translation>su transformación fractal</translation>
    </message>
    <message>
        <source>its saved views</source>
        <translation>sus vistas guardadas</translation>
    </message>
    <message>
        <source>the names of its maps</source>
        <translation>los nombres de sus aplicaciones</translation>
    </message>
    <message>
        <source>the locks of its maps</source>
        <translation>los bloqueos de sus aplicaciones</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Fecha:</translation>
    </message>
    <message>
        <source>part of map %1</source>
        <translation>parte de la aplicación %1</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>This is not a PNG, JPEG, GIF, BMP, PNM, WebP, TIFF or OpenEXR picture.</source>
        <translation>No es una imagen PNG, JPEG, GIF, BMP, PNM, WebP, TIFF u OpenEXR.</translation>
    </message>
    <message>
        <source>The picture stores its pixels in a way that cannot be read. Save it as a PNG picture.</source>
        <translation>La imagen guarda sus píxeles de una forma que no se puede leer. Guárdela como imagen PNG.</translation>
    </message>
    <message>
        <source>Too many maps to bound the jumps</source>
        <translation>Demasiadas aplicaciones para acotar los saltos</translation>
    </message>
    <message>
        <source>Proved continuous: the pieces do not touch</source>
        <translation>Continuidad demostrada: las partes no se tocan</translation>
    </message>
    <message>
        <source>Proved so far: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Demostrado hasta ahora: ningún salto entre partes supera %1 (%2 % de la pareja), lo peor cerca de %3</translation>
    </message>
    <message>
        <source>Proved: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Demostrado: ningún salto entre partes supera %1 (%2 % de la pareja), lo peor cerca de %3</translation>
    </message>
    <message>
        <source>Proved to be a homeomorphism</source>
        <translation>Homeomorfismo, demostrado</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism</source>
        <translation>No es un homeomorfismo, demostrado</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism</source>
        <translation>No se sabe si es un homeomorfismo</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>No es un homeomorfismo, demostrado; a la vuelta ningún salto supera %1 (%2 % de este fractal), lo peor cerca de %3</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>No se sabe si es un homeomorfismo; a la vuelta ningún salto supera %1 (%2 % de este fractal), lo peor cerca de %3</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map within rounding error</source>
        <translation>las palabras %1 y %2 son la misma aplicación salvo redondeo</translation>
    </message>
    <message>
        <source>Omitted lines of blocks that are not iterated function systems: %1.</source>
        <translation>Líneas omitidas de bloques que no son sistemas de funciones iteradas: %1.</translation>
    </message>
    <message>
        <source>Omitted inactive maps: %1.</source>
        <translation>Aplicaciones que no intervienen y se omiten: %1.</translation>
    </message>
    <message>
        <source>a point; exact</source>
        <translation>un punto; exacta</translation>
    </message>
    <message>
        <source>(upper bound: the open set condition fails)</source>
        <translation>(cota superior: no se cumple la condición del conjunto abierto)</translation>
    </message>
    <message>
        <source>%1, and inside itself</source>
        <translation>%1, y dentro de sí misma</translation>
    </message>
    <message>
        <source>The picture in “%1” needs more than 4 GB of memory in space.</source>
        <translation>La imagen de «%1» necesita más de 4 GB de memoria en el espacio.</translation>
    </message>
    <message>
        <source>The stored symmetry “%1” is not valid for this entry and is not applied; its lines are kept. A rotation repeats each map 2 to %2 times; polyhedra belong to space.</source>
        <translation>La simetría guardada «%1» no es válida para esta entrada y no se aplica; sus líneas se conservan. Una rotación repite cada aplicación de 2 a %2 veces; los poliedros son del espacio.</translation>
    </message>
    <message>
        <source>“%1” and “%2” must have the same number of active maps; they have %3 and %4.</source>
        <translation>«%1» y «%2» necesitan el mismo número de aplicaciones activas; tienen %3 y %4.</translation>
    </message>
    <message>
        <source>Other problems in this entry, not listed: %1.</source>
        <translation>Otros problemas de esta entrada, no enumerados: %1.</translation>
    </message>
    <message>
        <source>Numbers are missing or left over: this line has %1, the entry has %2, and each map has %3%4.</source>
        <translation>Faltan o sobran números: esta línea tiene %1, la entrada tiene %2, y cada aplicación tiene %3%4.</translation>
    </message>
    <message>
        <source>moved branches</source>
        <translation>ramas desplazadas</translation>
    </message>
    <message>
        <source>all figures are those of the code, where no branch is moved</source>
        <translation>todas las cifras son las del código, donde no hay ninguna rama desplazada</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time. Choose a lower resolution, which makes larger voxels.</source>
        <translation>Las partes de «%1» se solapan o se tocan demasiado para encontrar sus vóxeles en un tiempo razonable. Elija una resolución menor, es decir, vóxeles más grandes.</translation>
    </message>
    <message>
        <source>The surface of “%1” would have more than %2 million triangles. Choose a lower resolution, which makes larger voxels.</source>
        <translation>La superficie de «%1» tendría más de %2 millones de triángulos. Elija una resolución menor, es decir, vóxeles más grandes.</translation>
    </message>
    <message>
        <source>The count says %1, but the number of maps is %2.</source>
        <translation>La cuenta dice %1, pero el número de aplicaciones es %2.</translation>
    </message>
    <message>
        <source>The header names %2 columns, but this row has %1.</source>
        <translation>El encabezado nombra %2 columnas, pero esta fila tiene %1.</translation>
    </message>
    <message>
        <source>A map has 6 numbers, or 7 with its weight; this row has %1.</source>
        <translation>Una aplicación son 6 números, o 7 con su peso; esta fila tiene %1.</translation>
    </message>
    <message>
        <source>its animation</source>
        <translation>su animación</translation>
    </message>
    <message>
        <source>tracks: %1</source>
        <translation>pistas: %1</translation>
    </message>
    <message>
        <source>motions: %1</source>
        <translation>movimientos: %1</translation>
    </message>
    <message>
        <source>frames: %1, %2 per second, %3</source>
        <translation>fotogramas: %1, %2 por segundo, %3</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose larger voxels.</source>
        <translation>El sólido de «%1» necesitaría más de %2 millones de vóxeles. Elija vóxeles más grandes.</translation>
    </message>
    <message>
        <source>The wall is too thick for a solid of this size. Choose a thinner wall.</source>
        <translation>La pared es demasiado gruesa para un sólido de este tamaño. Elija una pared más fina.</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose a lower resolution: at most %3.</source>
        <translation>El sólido de «%1» necesitaría más de %2 millones de vóxeles. Elija una resolución menor: %3 como máximo.</translation>
    </message>
    <message>
        <source>Transform %1 has opacity %2; its points are drawn in full.</source>
        <translation>La transformación %1 tiene opacidad %2; sus puntos se dibujan por completo.</translation>
    </message>
    <message>
        <source>The file on disk is unchanged.</source>
        <translation>El archivo del disco sigue como estaba.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2.</source>
        <translation>No se guardó «%1»: %2.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again.</source>
        <translation>No se guardó «%1»: el disco está lleno. Libere espacio y vuelva a guardar.</translation>
    </message>
    <message>
        <source>“%1” is too small for its distance from the origin: the numbers in the file cannot distinguish its points. Move it to the origin, or make it larger.</source>
        <translation>«%1» es demasiado pequeño para su distancia al origen: los números del archivo no distinguen sus puntos. Muévalo al origen o hágalo más grande.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and cannot be opened.</source>
        <translation>«%1» no es un archivo ordinario y no se puede abrir.</translation>
    </message>
    <message>
        <source>The system does not follow the symbolic link “%1”, because another user may have put it there. Choose another name.</source>
        <translation>El sistema no sigue el enlace simbólico «%1», porque puede haberlo puesto ahí otro usuario. Elija otro nombre.</translation>
    </message>
    <message>
        <source>The picture is a JPEG with more than %1 scans. Save it as a PNG picture.</source>
        <translation>La imagen es un JPEG con más de %1 pasadas. Guárdela como imagen PNG.</translation>
    </message>
    <message>
        <source>This is read as %3 (systems: %1, maps: %2).</source>
        <translation>Se lee como: %3 (sistemas: %1, aplicaciones: %2).</translation>
    </message>
    <message>
        <source>Nothing names its columns: their order is taken to be a b c d e f.</source>
        <translation>Nada nombra sus columnas: se supone el orden a b c d e f.</translation>
    </message>
    <message>
        <source>In %1, row %2: %3</source>
        <translation>%1, fila %2: %3</translation>
    </message>
    <message>
        <source>The text is encoded in UTF-16; it is saved as UTF-8.</source>
        <translation>El texto está codificado en UTF-16; se guarda como UTF-8.</translation>
    </message>
    <message>
        <source>This is a program, a page or another document, not a Fractint collection, and none of its numbers are affine maps.</source>
        <translation>Es un programa, una página u otro documento, no una colección de Fractint, y ninguno de sus números son aplicaciones afines.</translation>
    </message>
    <message>
        <source>final transform: %1</source>
        <translation>transformación final: %1</translation>
    </message>
    <message>
        <source>it has several final transforms</source>
        <translation>tiene varias transformaciones finales</translation>
    </message>
    <message>
        <source>it has a final transform in space</source>
        <translation>tiene una transformación final en el espacio</translation>
    </message>
    <message>
        <source>it has a final transform and a symmetry</source>
        <translation>tiene una transformación final y una simetría</translation>
    </message>
    <message>
        <source>its final transform flattens the picture</source>
        <translation>su transformación final aplana la imagen</translation>
    </message>
    <message>
        <source>The attribute “%1” occurs twice; the first one is read.</source>
        <translation>El atributo «%1» aparece dos veces; se lee el primero.</translation>
    </message>
    <message>
        <source>A blank is missing before the attribute “%1”; it is read as if there were one.</source>
        <translation>Falta un espacio antes del atributo «%1»; se lee como si lo hubiera.</translation>
    </message>
    <message>
        <source>The attribute “%1” contains “%2”, which must be “%3” in XML; it is read as it stands.</source>
        <translation>El atributo «%1» contiene «%2», que en XML debe ser «%3»; se lee tal como está.</translation>
    </message>
    <message>
        <source>%1 flames with different times are the keys of this animation, a frame for each unit of time. Its colours are those of the first one.</source>
        <translation>%1 flames con tiempos distintos son las claves de esta animación, un fotograma por unidad de tiempo. Sus colores son los de la primera.</translation>
    </message>
    <message>
        <source>Columns that do not belong to a map are not read: %1.</source>
        <translation>No se leen las columnas que no pertenecen a una aplicación: %1.</translation>
    </message>
    <message>
        <source>The weights rise to %1, so they may be running sums. They are read as weights; to read them as sums, name their column “cumulative” instead of “p”.</source>
        <translation>Los pesos crecen hasta %1, así que pueden ser sumas acumuladas. Se leen como pesos; para leerlos como sumas, llame a su columna «cumulative» en lugar de «p».</translation>
    </message>
    <message>
        <source>YAML</source>
        <translation>YAML</translation>
    </message>
    <message>
        <source>a text of GIMP’s IFS Fractal</source>
        <translation>un texto de «Fractal IFS» de GIMP</translation>
    </message>
    <message>
        <source>a LaTeX table</source>
        <translation>tabla de LaTeX</translation>
    </message>
    <message>
        <source>an HTML table</source>
        <translation>tabla HTML</translation>
    </message>
    <message>
        <source>a Markdown table</source>
        <translation>tabla de Markdown</translation>
    </message>
    <message>
        <source>a wiki table</source>
        <translation>tabla de wiki</translation>
    </message>
    <message>
        <source>matrices in LaTeX</source>
        <translation>matrices en LaTeX</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>ecuaciones</translation>
    </message>
    <message>
        <source>Standard output cannot be written to: %1.</source>
        <translation>No se puede escribir en la salida estándar: %1.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
    <message numerus="yes">
        <source>%n exports from the last session are in the queue.</source>
        <translation>
            <numerusform>%n exportación de la última vez está en la cola.</numerusform>
            <numerusform>%n exportaciones de la última vez están en la cola.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export is not finished</source>
        <translation>La exportación no ha terminado</translation>
    </message>
    <message>
        <source>A file is still being exported.</source>
        <translation>Todavía se está exportando un archivo.</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>&amp;Animación…</translation>
    </message>
    <message>
        <source>Exports the motion instead, as GIF, MP4 and others.</source>
        <translation>Exporta en su lugar el movimiento, como GIF, MP4 y otros.</translation>
    </message>
    <message>
        <source>If you stop now, no file is written.</source>
        <translation>Si la detiene ahora, no se escribe ningún archivo.</translation>
    </message>
    <message>
        <source>&amp;Stop Export</source>
        <translation>&amp;Detener la exportación</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Continuar</translation>
    </message>
    <message>
        <source>Exports are not finished</source>
        <translation>Hay exportaciones sin terminar</translation>
    </message>
    <message numerus="yes">
        <source>Barycage closes when they are finished. Closed now, it continues with them at its next start.</source>
        <translation>
            <numerusform>Barycage se cierra cuando termine. Si lo cierra ahora, continuará en el próximo inicio.</numerusform>
            <numerusform>Barycage se cierra cuando terminen. Si lo cierra ahora, continuarán en el próximo inicio.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Ce&amp;rrar</translation>
    </message>
    <message numerus="yes">
        <source>%n exports are still in the queue.</source>
        <translation>
            <numerusform>%n exportación sigue en la cola.</numerusform>
            <numerusform>%n exportaciones siguen en la cola.</numerusform>
        </translation>
    </message>
    <message>
        <source>The file has no entry “%1”.</source>
        <translation>El archivo no tiene ninguna entrada «%1».</translation>
    </message>
    <message>
        <source>Show a step of the lesson</source>
        <translation>Mostrar un paso de la lección</translation>
    </message>
    <message>
        <source>The cage of this entry does not have the same corners as in the lesson.</source>
        <translation>La jaula de esta entrada tiene otros vértices que en la lección.</translation>
    </message>
    <message>
        <source>The fractals in the open file. The canvas shows the one you select here.</source>
        <translation>Los fractales del archivo abierto. El que se elige aquí es el que aparece en la imagen.</translation>
    </message>
    <message>
        <source>Ready-made fractals by theme, and your own folders of fractals.</source>
        <translation>Fractales para empezar, por temas, y las carpetas de fractales de usted.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map per row.</source>
        <translation>Las aplicaciones del fractal: su código, una aplicación por fila.</translation>
    </message>
    <message>
        <source>Which map may follow which in the chaos game, as a graph and as a matrix.</source>
        <translation>Qué aplicaciones puede aplicar el juego del caos después de cuáles, como grafo y como matriz.</translation>
    </message>
    <message>
        <source>The control cage in numbers: its vertices, their positions at rest, what moving them does, and other cages to choose from.</source>
        <translation>La jaula de control en números: dónde están sus vértices, dónde están en reposo, qué efecto tiene moverlos y otras jaulas entre las que elegir.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Colores, brillo y fondo de la imagen. Se guardan con el fractal.</translation>
    </message>
    <message>
        <source>Mathematical properties of this fractal. Point to a name to see what it means.</source>
        <translation>Propiedades matemáticas de este fractal. Señale un nombre para leer qué significa.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Select one to go back or forward to it.</source>
        <translation>Cada paso desde que se abrió el archivo. Elija uno para volver a él o para avanzar hasta él.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept while working on it. Click one to restore it.</source>
        <translation>Estados de este fractal que guardó mientras trabajaba. Haga clic en uno para restaurarlo.</translation>
    </message>
    <message>
        <source>The animation of this fractal: its motions, and the keys of everything that can move.</source>
        <translation>La animación de este fractal: sus movimientos y las claves de todo lo que puede moverse.</translation>
    </message>
    <message>
        <source>Find a fractal that looks like a picture: the target, how well the fractal agrees with it, and ways to fit it.</source>
        <translation>Un fractal para una imagen: el objetivo, cuánto concuerda con él el fractal, y ajustes.</translation>
    </message>
    <message>
        <source>Pictures drawn one after another in the background, with the progress of each.</source>
        <translation>Imágenes que se dibujan una tras otra en segundo plano, y el progreso de cada una.</translation>
    </message>
    <message>
        <source>A lesson about these fractals: its steps, each with a text and the state of the window, to be played in full screen.</source>
        <translation>Una lección sobre estos fractales: sus pasos, cada uno con un texto y el estado de la ventana, para reproducirla en toda la pantalla.</translation>
    </message>
    <message>
        <source>Problems found in the file, with line and column. The text in the file is kept unchanged.</source>
        <translation>Problemas encontrados en el archivo, con línea y columna. El texto del archivo se conserva sin cambios.</translation>
    </message>
    <message>
        <source>%1 is already open in this window.</source>
        <translation>%1 ya está abierto en esta ventana.</translation>
    </message>
    <message>
        <source>%1 by %2°</source>
        <translation>%1 en %2°</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 por %2</translation>
    </message>
    <message>
        <source>%1 to (%2, %3)</source>
        <translation>%1 a (%2, %3)</translation>
    </message>
    <message>
        <source>%1 by (%2, %3)</source>
        <translation>%1 en (%2, %3)</translation>
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
        <translation>Δ (%1, %2)  longitud %3</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>arista %1</translation>
    </message>
    <message>
        <source>edges %1 and %2</source>
        <translation>aristas %1 y %2</translation>
    </message>
    <message>
        <source>Map %1</source>
        <comment>begins a sentence</comment>
        <translation>La aplicación %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>Map that takes no part</source>
        <translation>Aplicación que no interviene</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, esquina %2</translation>
    </message>
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
        <source>Round handle</source>
        <translation>Tirador redondo</translation>
    </message>
    <message>
        <source>Square handle</source>
        <translation>Tirador cuadrado</translation>
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
        <source>the arrow keys turn by one degree</source>
        <translation>las flechas giran un grado</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>las flechas escalan un uno por ciento</translation>
    </message>
    <message>
        <source>Drag to move the pivot, the centre of rotation and scaling.</source>
        <translation>Arrastre el pivote: se gira y se escala en torno a él.</translation>
    </message>
    <message>
        <source>Drag to rotate about the pivot; hold Shift for steps of 15°.</source>
        <translation>Arrastre para girar en torno al pivote; Mayús: en pasos de 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; hold Shift for x or y only.</source>
        <translation>Arrastre para escalar en torno al pivote; Mayús: solo en x o en y.</translation>
    </message>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>pegado</translation>
    </message>
    <message>
        <source>The name “%1” does not match the chosen format. Choose another name.</source>
        <translation>El nombre «%1» no corresponde al formato elegido. Elija otro nombre.</translation>
    </message>
    <message>
        <source>Another export in the queue writes “%1”. Choose another name.</source>
        <translation>Otra exportación de la cola escribe «%1». Elija otro nombre.</translation>
    </message>
    <message>
        <source>Added to the queue: %1.</source>
        <translation>Añadida a la cola: %1.</translation>
    </message>
    <message>
        <source>%1 × %2 are %3 million pixels. Drawing them may take hours, and the file may need up to %4.</source>
        <translation>%1 × %2 son %3 millones de píxeles. Dibujarlos puede llevar horas, y el archivo puede ocupar hasta %4.</translation>
    </message>
    <message>
        <source>Memory needed: about %1.</source>
        <translation>Memoria necesaria: unos %1.</translation>
    </message>
    <message>
        <source>Very large picture</source>
        <translation>Imagen muy grande</translation>
    </message>
    <message>
        <source>This picture is very large.</source>
        <translation>Esta imagen es muy grande.</translation>
    </message>
    <message>
        <source>&amp;Export Anyway</source>
        <translation>&amp;Exportar de todos modos</translation>
    </message>
    <message>
        <source>%1 could not be written. Print it to another folder.</source>
        <translation>No se pudo escribir %1. Imprima en otra carpeta.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Escrito en %1.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Buscar en la guía</translation>
    </message>
    <message>
        <source>Finds these words in the guide. Enter goes to the next match, Shift+Enter to the previous one. Ctrl+F comes back here.</source>
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
    <message>
        <source>User Guide</source>
        <translation>Guía del usuario</translation>
    </message>
    <message>
        <source>The user guide: what you can do with Barycage, in the order in which you need it.</source>
        <translation>La guía del usuario: lo que se puede hacer aquí, en el orden en que hace falta.</translation>
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
    <message>
        <source>Smallest Rectangle</source>
        <translation>Rectángulo mínimo</translation>
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
        <source>Three Edges of the Bounding Box</source>
        <translation>Tres aristas de la caja envolvente</translation>
    </message>
    <message>
        <source>Bounding Box, Eight Corners</source>
        <translation>Caja envolvente, ocho vértices</translation>
    </message>
    <message>
        <source>Octahedron</source>
        <translation>Octaedro</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Leyendo lo pegado…</translation>
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
        <source>Nothing was pasted: the clipboard contains no rows of 6 or 7 numbers.</source>
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
    <message numerus="yes">
        <source>%n maps added.</source>
        <translation>
            <numerusform>%n aplicación añadida.</numerusform>
            <numerusform>%n aplicaciones añadidas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The selected maps were replaced; %n maps pasted.</source>
        <translation>
            <numerusform>Se reemplazaron las aplicaciones seleccionadas; %n aplicación pegada.</numerusform>
            <numerusform>Se reemplazaron las aplicaciones seleccionadas; %n aplicaciones pegadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Según el |determinante|</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Iguales</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Según la dimensión</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Normalizar</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>El mismo peso para todas las aplicaciones</translation>
    </message>
    <message>
        <source>Weights that cover the attractor evenly at its own dimension</source>
        <translation>Pesos que cubren el atractor de modo uniforme en su propia dimensión</translation>
    </message>
    <message>
        <source>Scale all weights so that they sum to 1</source>
        <translation>Las mismas proporciones, con suma 1</translation>
    </message>
    <message>
        <source>Set the weights of all maps that are switched on by a rule</source>
        <translation>Los pesos de todas las aplicaciones activas, según una regla</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Imágenes (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Guardando «%1»…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Reflexión</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotación</translation>
    </message>
    <message>
        <source>Dihedral</source>
        <translation>Diédrica</translation>
    </message>
    <message>
        <source>Tetrahedral</source>
        <translation>Tetraédrica</translation>
    </message>
    <message>
        <source>Octahedral</source>
        <translation>Octaédrica</translation>
    </message>
    <message>
        <source>Icosahedral</source>
        <translation>Icosaédrica</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Esta entrada no tiene aplicaciones del plano.</translation>
    </message>
    <message>
        <source>The cage is at rest: the picture shows the code.</source>
        <translation>La jaula está en reposo: lo que se muestra es el código.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code produces a bent picture. Choose “Affine fit” to bake the closest affine placement.</source>
        <translation>La jaula curva la imagen, y ningún código afín tiene una imagen curvada. Elija «Ajuste afín» para incorporar lo que más se le acerca.</translation>
    </message>
    <message>
        <source>The cage is flat, so its placement cannot be baked into the code. Open the cage first.</source>
        <translation>La jaula es plana, así que su colocación no se puede incorporar al código. Abra primero la jaula.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>La jaula está en reposo.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. Bake to change the code.</source>
        <translation>Mover la jaula mueve la imagen. El código queda como está hasta que usted incorpore la colocación.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can reproduce, so the code does not change.</source>
        <translation>Mover la jaula entera reescribe el código. Mover vértices sueltos curva la imagen, lo que ningún código puede seguir, y el código no cambia.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites all coefficients of the code; the cage is then at rest in its new position.</source>
        <translation>Mover la jaula reescribe todos los coeficientes del código, y la jaula queda en reposo donde está.</translation>
    </message>
    <message>
        <source>The cage is not at rest: it already holds a placement.</source>
        <translation>La jaula no está en reposo: ya contiene una colocación.</translation>
    </message>
    <message>
        <source>Only a cage with three vertices can be unbaked.</source>
        <translation>Solo un triángulo se puede extraer del código.</translation>
    </message>
    <message>
        <source>The cage is not convex: the picture may fold over itself at the notch.</source>
        <translation>La jaula tiene un entrante: ahí la imagen puede plegarse sobre sí misma.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture overlap. Move the vertices apart to unfold it.</source>
        <translation>La jaula está plegada: hay partes de la imagen unas sobre otras. Separe los vértices para desplegarla.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to enclose.</source>
        <translation>No interviene ninguna aplicación, así que no hay nada que encerrar.</translation>
    </message>
    <message>
        <source>The maps are linked; a cage cannot be fitted to linked maps.</source>
        <translation>Las aplicaciones están enlazadas; no se puede ajustar una jaula a aplicaciones enlazadas.</translation>
    </message>
    <message>
        <source>A bent picture cannot be given another cage. First reset the cage or choose “Affine fit”.</source>
        <translation>Una imagen curvada no se puede sujetar con otra jaula. Antes restablezca la jaula o elija «Ajuste afín».</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the triangle.</source>
        <translation>La jaula está aplastada. Antes abra el triángulo o restablézcalo.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Este sistema no tiene un atractor que se pueda encerrar.</translation>
    </message>
    <message>
        <source>All maps are off.</source>
        <translation>Todas las aplicaciones están desactivadas.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be compared with a picture.</source>
        <translation>Las aplicaciones están enlazadas. Solo se pueden comparar con una imagen aplicaciones que puedan seguirse todas entre sí.</translation>
    </message>
    <message>
        <source>A symmetry repeats the maps. Expand it to compare them with a picture.</source>
        <translation>Una simetría repite las aplicaciones. Despliéguela para comparar las aplicaciones con una imagen.</translation>
    </message>
    <message>
        <source>The cage bends the picture, or is flat. Reset the cage to compare the maps.</source>
        <translation>La jaula dobla la imagen o es plana. Restablezca la jaula para comparar las aplicaciones.</translation>
    </message>
    <message>
        <source>The animation of “%1” cannot be taken to another dimension, so it is left out.</source>
        <translation>La animación de «%1» no puede llevarse a otra dimensión, por lo que se omite.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, so it cannot be lifted.</source>
        <translation>«%1» no es un sistema del plano, así que no se puede llevar al espacio.</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, and maps in space cannot be linked.</source>
        <translation>Las aplicaciones de «%1» están enlazadas, y las del espacio no pueden estarlo.</translation>
    </message>
    <message>
        <source>The cage of “%1” has more than three corners, so it cannot become a tetrahedron. Bake or reset it first.</source>
        <translation>La jaula de «%1» tiene más de tres vértices y no da un tetraedro. Incorpórela o restablézcala antes.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it cannot be flattened.</source>
        <translation>«%1» no es un sistema del espacio, así que no se puede aplanar.</translation>
    </message>
    <message>
        <source>The direction must have a length other than 0.</source>
        <translation>La dirección no puede tener longitud 0.</translation>
    </message>
    <message>
        <source>“%1” has moved branches, which cannot be flattened. Reset them first.</source>
        <translation>«%1» tiene ramas movidas, que no se pueden aplanar. Restablézcalas antes.</translation>
    </message>
    <message>
        <source>The cage of “%1” cannot be baked into its maps, so it cannot be flattened.</source>
        <translation>La jaula de «%1» no se puede incorporar a las aplicaciones, así que no se puede aplanar.</translation>
    </message>
    <message>
        <source>Map %1 of “%2” does not keep this direction, so the projection is not an iterated function system. Export a picture seen from that direction instead.</source>
        <translation>La aplicación %1 de «%2» desvía la dirección, así que la proyección no es un sistema de funciones iteradas. Exporte en su lugar una imagen desde ese lado.</translation>
    </message>
    <message>
        <source>An entry needs a name.</source>
        <translation>Una entrada necesita un nombre.</translation>
    </message>
    <message>
        <source>Names cannot contain spaces: Fractint reads only the first word.</source>
        <translation>Los nombres no pueden contener espacios: Fractint lee solo la primera palabra.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>«%1» no puede formar parte de un nombre, porque tiene un significado en los archivos .ifs.</translation>
    </message>
    <message>
        <source>A name can have at most %1 characters; Fractint ignores the rest.</source>
        <translation>Un nombre tiene a lo sumo %1 caracteres; Fractint omite el resto.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint no incluye en su lista una entrada llamada «%1»; elija otro nombre.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case are not distinguished).</source>
        <translation>Otra entrada se llama «%1» (no se distinguen mayúsculas y minúsculas).</translation>
    </message>
    <message>
        <source>A branch</source>
        <translation>Una rama</translation>
    </message>
    <message>
        <source>%1 has keys, which the maps of the new system could not follow. Remove its keys in the timeline first.</source>
        <translation>%1 tiene fotogramas clave que las aplicaciones del nuevo sistema no podrían seguir. Elimínelos primero de la línea de tiempo.</translation>
    </message>
    <message>
        <source>A motion moves single maps, and the maps of the new system are others. Remove this motion from the timeline first.</source>
        <translation>Un movimiento mueve aplicaciones concretas, y las del nuevo sistema son otras. Elimine primero este movimiento de la línea de tiempo.</translation>
    </message>
    <message>
        <source>%1 has keys: it would be rewritten at this frame only, and what has none at every frame. Remove its keys in the timeline first.</source>
        <translation>%1 tiene fotogramas clave: solo se reescribiría en este fotograma, y lo que no los tiene, en todos. Elimínelos primero de la línea de tiempo.</translation>
    </message>
    <message>
        <source>Maps in space cannot be linked.</source>
        <translation>Las aplicaciones del espacio no se pueden enlazar.</translation>
    </message>
    <message>
        <source>This entry could not be read, so its maps cannot be linked.</source>
        <translation>Esta entrada no se pudo leer, así que sus aplicaciones no se pueden enlazar.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked.</source>
        <translation>No se pueden enlazar más de %1 aplicaciones.</translation>
    </message>
    <message>
        <source>With the links of “%1” every sequence of maps ends, so plain maps would have nothing to draw.</source>
        <translation>Los enlaces de «%1» hacen que toda sucesión de aplicaciones termine, así que no hay nada que aplicaciones simples pudieran dibujar.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be more than %2 words of its maps, which is the limit. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Las aplicaciones simples de «%1» serían más de %2 palabras de sus aplicaciones, que es el límite. Conserve los enlaces en un archivo .ifs o .flame, o elimínelos.</translation>
    </message>
    <message>
        <source>The links of “%1” cannot be written as plain maps: a sequence of maps can go on for ever without reaching one that may follow every map. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Los enlaces de «%1» no se pueden escribir como aplicaciones simples: una sucesión de aplicaciones puede continuar sin fin sin llegar a una que pueda seguir a todas. Conserve los enlaces en un archivo .ifs o .flame, o quítelos.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be words of its maps, which cannot take part in its animation or in its moved branches. Remove these first.</source>
        <translation>Las aplicaciones simples de «%1» serían palabras de sus aplicaciones, que no pueden participar en su animación ni en sus ramas movidas. Quite estas primero.</translation>
    </message>
    <message>
        <source>Map %1 is locked. Unlock it in the Maps panel first.</source>
        <translation>La aplicación %1 está bloqueada. Desbloquéela antes en el panel Aplicaciones.</translation>
    </message>
    <message>
        <source>Maps %1 are locked. Unlock them in the Maps panel first.</source>
        <translation>Las aplicaciones %1 están bloqueadas. Desbloquéelas antes en el panel Aplicaciones.</translation>
    </message>
    <message>
        <source>Lock a map</source>
        <translation>Bloquear una aplicación</translation>
    </message>
    <message>
        <source>Unlock a map</source>
        <translation>Desbloquear una aplicación</translation>
    </message>
    <message>
        <source>Lock %1 maps</source>
        <translation>Bloquear %1 aplicaciones</translation>
    </message>
    <message>
        <source>Unlock %1 maps</source>
        <translation>Desbloquear %1 aplicaciones</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Quitar el nombre de la aplicación %1</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Llamar «%2» a la aplicación %1</translation>
    </message>
    <message>
        <source>Only a cage with four vertices can be unbaked.</source>
        <translation>Solo se puede extraer una jaula de cuatro vértices.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so no other cage would show it. First reset the cage or choose “Affine fit”.</source>
        <translation>La jaula curva la imagen, y ninguna otra jaula la mostraría. Antes restablezca la jaula o elija «Ajuste afín».</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the tetrahedron.</source>
        <translation>La jaula es plana. Primero abra o restablezca el tetraedro.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Elija primero una aplicación.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be shown alone.</source>
        <translation>Las aplicaciones están enlazadas. Solo se pueden mostrar solas aplicaciones que puedan seguirse todas entre sí.</translation>
    </message>
    <message>
        <source>The cage bends the picture, in which no map can be shown alone. Reset the cage first.</source>
        <translation>La jaula dobla la imagen, y así no se puede mostrar una sola aplicación. Restablezca antes la jaula.</translation>
    </message>
    <message>
        <source>Map %1 takes everything to one point, so there is nothing to show alone.</source>
        <translation>La aplicación %1 lleva todo a un punto, así que no hay nada que mostrar solo.</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Esta entrada no es un sistema en el espacio.</translation>
    </message>
    <message>
        <source>This entry has no maps to vary.</source>
        <translation>Esta entrada no tiene aplicaciones que variar.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>No se puede crear la carpeta %1.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size or the supersampling.</source>
        <translation>No hay memoria suficiente para esta imagen. Hágala más pequeña o use menos supermuestreo.</translation>
    </message>
    <message>
        <source>It is damaged.</source>
        <translation>Está dañada.</translation>
    </message>
    <message>
        <source>It is not an export of this program.</source>
        <translation>No es una exportación de este programa.</translation>
    </message>
    <message>
        <source>Its settings are not supported by this version.</source>
        <translation>Sus ajustes no son de esta versión.</translation>
    </message>
    <message>
        <source>Its file name does not match its format.</source>
        <translation>El archivo que nombra no corresponde a su formato.</translation>
    </message>
    <message>
        <source>It is not a regular file.</source>
        <translation>No es un archivo ordinario.</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>No se puede leer.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Es demasiado grande.</translation>
    </message>
    <message>
        <source>An export from the last session was skipped. %1 Its damaged file was renamed to %2.</source>
        <translation>Se ha omitido una exportación de la última vez. %1 Se ha cambiado el nombre de su archivo dañado a %2.</translation>
    </message>
    <message>
        <source>A file “%1” was created after you added this export. Choose Try Again to replace it.</source>
        <translation>Desde que añadió esta exportación ha aparecido un archivo «%1». Reintentar lo reemplaza.</translation>
    </message>
    <message>
        <source>The fractal in this export cannot be read.</source>
        <translation>No se puede leer el fractal de esta exportación.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>No hay memoria suficiente para esta imagen.</translation>
    </message>
    <message>
        <source>The lesson is larger than 4 MB, which is the limit.</source>
        <translation>La lección ocupa más de 4 MB, que es el límite.</translation>
    </message>
    <message>
        <source>This is not a lesson: its first line does not begin with “lesson:”.</source>
        <translation>Esto no es una lección: su primera línea no empieza por «lesson:».</translation>
    </message>
    <message>
        <source>The lesson has no steps.</source>
        <translation>La lección no tiene pasos.</translation>
    </message>
    <message>
        <source>This line was ignored: settings look like “file: name.ifs”, and steps begin with “##”.</source>
        <translation>Se ha pasado por alto esta línea: los ajustes tienen la forma «file: nombre.ifs» y los pasos empiezan por «##».</translation>
    </message>
    <message>
        <source>The lesson has more than %1 steps; the others were ignored.</source>
        <translation>La lección tiene más de %1 pasos; los demás se han pasado por alto.</translation>
    </message>
    <message>
        <source>The text of step %1 is longer than %2 characters and was cut.</source>
        <translation>El texto del paso %1 tiene más de %2 caracteres y se ha cortado.</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. It can refer to a file in its own folder, or to a .ifs or .par file in another one.</source>
        <translation>Una lección no puede referirse a «%1», sino solo a un archivo de su propia carpeta o a un archivo .ifs o .par de otra.</translation>
    </message>
    <message>
        <source>“%1: %2” was not understood.</source>
        <translation>No se ha entendido «%1: %2».</translation>
    </message>
    <message>
        <source>“%1” is unknown to this version and is kept.</source>
        <translation>Esta versión no conoce «%1» y lo conserva.</translation>
    </message>
    <message>
        <source>A %1 picture has at most %2 pixels along a side.</source>
        <translation>Una imagen %1 tiene como máximo %2 píxeles por lado.</translation>
    </message>
    <message>
        <source>A JPEG picture cannot be transparent. Choose a background colour or another format.</source>
        <translation>Una imagen JPEG no puede ser transparente. Elija un color de fondo u otro formato.</translation>
    </message>
    <message>
        <source>A JPEG picture has at most %1 dots per inch.</source>
        <translation>Una imagen JPEG tiene como máximo %1 puntos por pulgada.</translation>
    </message>
    <message>
        <source>Such a picture cannot be written as %1.</source>
        <translation>Una imagen así no se puede escribir como %1.</translation>
    </message>
    <message>
        <source>The picture cannot be opened.</source>
        <translation>No se puede abrir la imagen.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture.</source>
        <translation>El archivo no es una imagen PNG.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete. Draw it again.</source>
        <translation>La imagen está dañada o incompleta. Dibújela de nuevo.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed the text that holds it.</source>
        <translation>La imagen no contiene ningún sistema: no la escribió Barycage, u otro programa eliminó su texto.</translation>
    </message>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>El sistema de la imagen ocupa más de 8 MB.</translation>
    </message>
    <message>
        <source>The picture contains too much text: the limit is 40 MB in total.</source>
        <translation>La imagen lleva demasiado texto: el límite es de 40 MB en total.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture, or it is damaged.</source>
        <translation>El archivo no es una imagen PNG o está dañado.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>No se puede escribir la imagen: %1</translation>
    </message>
    <message>
        <source>The picture is damaged, or its text cannot be read.</source>
        <translation>La imagen está dañada o no se puede leer su texto.</translation>
    </message>
    <message>
        <source>the WebP encoder does not have enough memory.</source>
        <translation>el codificador WebP no tiene suficiente memoria.</translation>
    </message>
    <message>
        <source>An exact picture of this system would take too long. Draw it with points.</source>
        <translation>Una imagen exacta de este sistema tardaría demasiado. Dibújela con puntos.</translation>
    </message>
    <message>
        <source>The folder for temporary files does not have enough space for the frames: %1.</source>
        <translation>En la carpeta de archivos temporales no hay espacio para los fotogramas: %1.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries are not installed on this machine, so no videos can be written. Install them, or write the frames as PNG pictures instead.</source>
        <translation>Las bibliotecas de FFmpeg no están instaladas en este equipo, así que no se pueden escribir vídeos. Instálelas o escriba los fotogramas como imágenes PNG.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries on this machine cannot write %1 files: the encoder %2 is missing. Choose another format.</source>
        <translation>Las bibliotecas de FFmpeg de este equipo no pueden escribir archivos %1: falta el codificador %2. Elija otro formato.</translation>
    </message>
    <message>
        <source>The video cannot be written: %1.</source>
        <translation>No se puede escribir el vídeo: %1.</translation>
    </message>
    <message>
        <source>Flip maps</source>
        <translation>Voltear aplicaciones</translation>
    </message>
    <message>
        <source>Rotate maps by 90°</source>
        <translation>Girar aplicaciones 90°</translation>
    </message>
    <message>
        <source>Rotate maps by −90°</source>
        <translation>Girar aplicaciones −90°</translation>
    </message>
    <message>
        <source>Align maps</source>
        <translation>Alinear aplicaciones</translation>
    </message>
    <message>
        <source>Distribute maps</source>
        <translation>Distribuir aplicaciones</translation>
    </message>
    <message>
        <source>Fit maps to the corners</source>
        <translation>Ajustar aplicaciones a los vértices</translation>
    </message>
    <message>
        <source>Only maps in the plane can be arranged.</source>
        <translation>Solo se pueden ordenar aplicaciones del plano.</translation>
    </message>
    <message>
        <source>Select at least two maps first.</source>
        <translation>Elija primero al menos dos aplicaciones.</translation>
    </message>
    <message>
        <source>Select at least three maps first.</source>
        <translation>Elija primero al menos tres aplicaciones.</translation>
    </message>
    <message>
        <source>The cage is flat, so maps cannot be moved in it. Reset the cage first.</source>
        <translation>La jaula es plana, así que las aplicaciones no se pueden mover en ella. Restablezca antes la jaula.</translation>
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
        <source>contractive in some norm, γ &lt; 1</source>
        <translation>contractivo en cierta norma, γ &lt; 1</translation>
    </message>
    <message>
        <source>(the open set condition holds)</source>
        <translation>(se cumple la condición del conjunto abierto)</translation>
    </message>
    <message>
        <source>(the open set condition holds, within rounding error)</source>
        <translation>(se cumple la condición del conjunto abierto, hasta donde deja ver el redondeo)</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>se cumple</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>no se cumple</translation>
    </message>
    <message>
        <source>open set condition</source>
        <translation>condición del conjunto abierto</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>vecinas</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Dimensión de Hausdorff</translation>
    </message>
    <message>
        <source>(finite type)</source>
        <translation>(tipo finito)</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>espectro</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>como máximo %1</translation>
    </message>
    <message>
        <source>holds, within rounding error</source>
        <translation>se cumple, hasta donde deja ver el redondeo</translation>
    </message>
    <message>
        <source>fails, within rounding error</source>
        <translation>no se cumple, hasta donde deja ver el redondeo</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time, even at the lowest resolution.</source>
        <translation>Las piezas de «%1» se superponen o se tocan demasiado para encontrar sus vóxeles en un tiempo razonable, incluso con la resolución más baja.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries cannot be loaded, so no videos can be written: %1.</source>
        <translation>No se pueden cargar las bibliotecas de FFmpeg, por lo que no se pueden escribir vídeos: %1.</translation>
    </message>
    <message>
        <source>This entry is not an iterated function system.</source>
        <translation>Esta entrada no es un sistema iterado de funciones.</translation>
    </message>
    <message>
        <source>This entry has %1 maps; a web page can have at most %2.</source>
        <translation>Esta entrada tiene %1 aplicaciones; una página web puede tener %2 como máximo.</translation>
    </message>
    <message>
        <source>A solid has no shadow on the ground. Move its light in the Appearance panel: the solid darkens the side that faces away from it.</source>
        <translation>Un sólido no proyecta sombra en el suelo. Mueva su luz en el panel Aspecto: el lado opuesto a ella se oscurece.</translation>
    </message>
    <message>
        <source>This entry could not be read, so there is no picture to cast a shadow.</source>
        <translation>No se pudo leer esta entrada, así que no hay imagen que proyecte una sombra.</translation>
    </message>
    <message>
        <source>its shadow</source>
        <translation>su sombra</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size.</source>
        <translation>No hay memoria suficiente para esta imagen. Reduzca su tamaño.</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Una imagen</translation>
    </message>
    <message>
        <source>Both eyes, side by side</source>
        <translation>Ambos ojos, uno al lado del otro</translation>
    </message>
    <message>
        <source>Stereo, &amp;Side by Side</source>
        <translation>Estéreo, &amp;lado a lado</translation>
    </message>
    <message>
        <source>Show the views of both eyes side by side, the left eye on the left</source>
        <translation>Muestra lo que ve cada ojo, el izquierdo a la izquierda</translation>
    </message>
    <message>
        <source>Red and cyan glasses</source>
        <translation>Gafas rojo y cian</translation>
    </message>
    <message>
        <source>Stereo, for Red and &amp;Cyan Glasses</source>
        <translation>Estéreo, para gafas rojo y &amp;cian</translation>
    </message>
    <message>
        <source>Show the views of both eyes in one picture, in red and cyan</source>
        <translation>Muestra en una imagen lo que ven ambos ojos, en rojo y cian</translation>
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
        <translation>Fórmulas y una figura para LaTeX (.tex)</translation>
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
        <source>PNG: pixels</source>
        <translation>PNG: píxeles</translation>
    </message>
    <message>
        <source>JPEG: pixels, a small file</source>
        <translation>JPEG: píxeles, un archivo pequeño</translation>
    </message>
    <message>
        <source>WebP: pixels, for web pages</source>
        <translation>WebP: píxeles, para páginas web</translation>
    </message>
    <message>
        <source>TIFF: pixels, for print</source>
        <translation>TIFF: píxeles, para imprimir</translation>
    </message>
    <message>
        <source>OpenEXR: linear light, for compositing</source>
        <translation>OpenEXR: luz lineal, para composición</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF: formas para imprimir</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG: formas para programas de dibujo</translation>
    </message>
    <message>
        <source>Mesh for 3D printing (.stl)</source>
        <translation>Cuerpo para imprimir (.stl)</translation>
    </message>
    <message>
        <source>Mesh (.obj)</source>
        <translation>Cuerpo (.obj)</translation>
    </message>
    <message>
        <source>Mesh (.glb)</source>
        <translation>Cuerpo (.glb)</translation>
    </message>
    <message>
        <source>Mesh (.ply)</source>
        <translation>Cuerpo (.ply)</translation>
    </message>
    <message>
        <source>“%1” has %2 numbers for %3 maps, so it is not read as their weights, which are computed from the determinants.</source>
        <translation>«%1» tiene %2 números para %3 aplicaciones; por eso no se lee como sus pesos, que se toman de los determinantes.</translation>
    </message>
    <message>
        <source>MP4: plays everywhere</source>
        <translation>MP4: se reproduce en todas partes</translation>
    </message>
    <message>
        <source>WebM: for web pages, with transparency</source>
        <translation>WebM: para páginas web, con transparencia</translation>
    </message>
    <message>
        <source>MKV: lossless, for editing</source>
        <translation>MKV: sin pérdida, para editar</translation>
    </message>
    <message>
        <source>GIF: 256 colours</source>
        <translation>GIF: 256 colores</translation>
    </message>
    <message>
        <source>WebP: a lossless animated image</source>
        <translation>WebP: imagen en movimiento sin pérdida</translation>
    </message>
    <message>
        <source>APNG: a lossless animated image</source>
        <translation>APNG: imagen en movimiento sin pérdida</translation>
    </message>
    <message>
        <source>The link holds more than 1 MB of text, which is the limit.</source>
        <translation>El enlace contiene más de 1 MB de texto, que es el límite.</translation>
    </message>
    <message>
        <source>This link is damaged, or it holds no fractal.</source>
        <translation>Este enlace está dañado o no contiene ningún fractal.</translation>
    </message>
    <message>
        <source>This link was cut off: its end is missing. Copy all of it.</source>
        <translation>Este enlace está cortado: falta el final. Cópielo entero.</translation>
    </message>
    <message>
        <source>Drawing the pictures…</source>
        <translation>Dibujando las imágenes…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>PDF: a page with the picture</source>
        <translation>PDF: una página con la imagen</translation>
    </message>
    <message>
        <source>SVG: a page with the picture</source>
        <translation>SVG: una página con la imagen</translation>
    </message>
    <message>
        <source>There is not enough memory for the video.</source>
        <translation>No hay suficiente memoria para el vídeo.</translation>
    </message>
    <message>
        <source>The encoder of the video does not work. There may not be enough memory for it.</source>
        <translation>El codificador del vídeo no funciona. Puede que no haya suficiente memoria para él.</translation>
    </message>
    <message>
        <source>lists of numbers</source>
        <translation>listas de números</translation>
    </message>
    <message>
        <source>This map is not understood, so none is read.</source>
        <translation>Esta aplicación no se entiende, así que no se lee ninguna.</translation>
    </message>
    <message>
        <source>“%1” is not understood, so no map is read.</source>
        <translation>«%1» no se entiende, así que no se lee ninguna aplicación.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
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
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Arrastrar</translation>
    </message>
    <message>
        <source>Drag a corner of the triangle: the whole picture follows.</source>
        <translation>Arrastre una esquina del triángulo: toda la imagen la sigue.</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Aplastar</translation>
    </message>
    <message>
        <source>Push a corner onto the opposite side until the picture is flat, then pull it open again.</source>
        <translation>Lleve una esquina sobre el lado opuesto hasta que la imagen quede plana y vuelva a abrirla.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Press %1 to take back what you have just done.</source>
        <translation>Pulse %1 para deshacer lo que acaba de hacer.</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Colección</translation>
    </message>
    <message>
        <source>Double-click a picture of the collection that you like.</source>
        <translation>Haga doble clic en una imagen de la colección que le guste.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>Press Wind in the timeline and watch the picture sway.</source>
        <translation>Pulse Viento en la línea de tiempo y vea cómo se mece la imagen.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Press %1 to save the picture for others.</source>
        <translation>Pulse %1 para guardar la imagen y compartirla.</translation>
    </message>
    <message>
        <source>That Is It</source>
        <translation>Eso es todo</translation>
    </message>
    <message>
        <source>Three more steps show what the picture is made of.</source>
        <translation>Tres pasos más muestran de qué está hecha la imagen.</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Aplicación</translation>
    </message>
    <message>
        <source>Each row is a map that makes one smaller copy of the whole: double-click a number and type another.</source>
        <translation>Cada fila es una aplicación que hace una copia menor del conjunto: haga doble clic en un número y escriba otro.</translation>
    </message>
    <message>
        <source>Click a point: the maps that lead there are its address, and you hold the branch that they make.</source>
        <translation>Haga clic en un punto: las aplicaciones que llevan a él son su dirección, y usted sostiene la rama que forman.</translation>
    </message>
    <message>
        <source>Norm</source>
        <translation>Norma</translation>
    </message>
    <message>
        <source>‖A‖ is how far a map stretches at most: change a number, and keep it below 1.</source>
        <translation>‖A‖ es lo que una aplicación estira como máximo: cambie un número y manténgala por debajo de 1.</translation>
    </message>
    <message>
        <source>In the timeline, choose Wind under Add Motion and watch the picture sway as well.</source>
        <translation>En la línea de tiempo, elija Viento en «Añadir movimiento» y vea cómo se mece también la imagen.</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Omitir</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>&amp;Seguir</translation>
    </message>
    <message>
        <source>Open the panel %1 again: it is under View › Panels.</source>
        <translation>Vuelva a abrir el panel %1: está en Ver › Paneles.</translation>
    </message>
    <message>
        <source>That Is All</source>
        <translation>Eso es todo</translation>
    </message>
    <message>
        <source>Now take whatever you like by its corners.</source>
        <translation>Ahora tome lo que quiera por sus esquinas.</translation>
    </message>
    <message>
        <source>Press %1 once more: the picture is still flat.</source>
        <translation>Pulse %1 otra vez: la imagen aún está plana.</translation>
    </message>
</context>
<context>
    <name>VideoSystem</name>
    <message>
        <source>The file is not a video.</source>
        <translation>El archivo no es un vídeo.</translation>
    </message>
    <message>
        <source>The video contains no system: it was not written by Barycage, it is damaged, or another program removed the text that holds it.</source>
        <translation>El vídeo no contiene ningún sistema: no lo escribió Barycage, está dañado, u otro programa eliminó el texto que lo contiene.</translation>
    </message>
    <message>
        <source>The system in the video is larger than 8 MB.</source>
        <translation>El sistema del vídeo ocupa más de 8 MB.</translation>
    </message>
</context>
<context>
    <name>VideoWriter</name>
    <message>
        <source>There is not enough memory for a frame of the video.</source>
        <translation>No hay memoria suficiente para un fotograma del vídeo.</translation>
    </message>
    <message>
        <source>A frame of the GIF cannot be created.</source>
        <translation>No se puede crear un fotograma del GIF.</translation>
    </message>
    <message>
        <source>The animation cannot be stored in the video.</source>
        <translation>No se puede guardar la animación en el vídeo.</translation>
    </message>
    <message>
        <source>A side of %1 pixels is too long for this format; the limit is %2.</source>
        <translation>Un lado de %1 píxeles es demasiado largo para este formato; el límite es %2.</translation>
    </message>
    <message>
        <source>This format shows at most %1 frames per second. Choose a lower rate.</source>
        <translation>Este formato muestra como máximo %1 fotogramas por segundo. Elija una frecuencia menor.</translation>
    </message>
    <message>
        <source>This build of Barycage does not include FFmpeg&apos;s libraries and cannot write videos. Write the frames as PNG pictures instead.</source>
        <translation>Este Barycage se compiló sin las bibliotecas de FFmpeg y no escribe vídeos. Escriba los fotogramas como imágenes PNG.</translation>
    </message>
    <message>
        <source>There is not enough memory for the palette of the GIF.</source>
        <translation>No hay suficiente memoria para la paleta del GIF.</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Recent files and the collection.</source>
        <translation>Los últimos archivos y la colección.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>Continue with</source>
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
        <source>A file or the collection.</source>
        <translation>Un archivo o la colección.</translation>
    </message>
    <message>
        <source>Start with</source>
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
        <source>Accepts the settings and closes the dialog.</source>
        <translation>Acepta lo que muestra el diálogo y lo cierra.</translation>
    </message>
    <message>
        <source>Closes the dialog without changing anything.</source>
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
    <message>
        <source>%1 Panel “%2”: %3</source>
        <comment>what it does, panel, what the panel is for</comment>
        <translation>%1 Panel «%2»: %3</translation>
    </message>
</context>
<context>
    <name>WrittenBanner</name>
    <message>
        <source>Show in Folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Muestra la carpeta del archivo escrito en el gestor de archivos.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Printed to a file</source>
        <translation>Impreso en un archivo</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>%1 se ha escrito.</translation>
    </message>
</context>
<context>
    <name>document::CageActions</name>
    <message>
        <source>This entry is not a system in the plane, so it has no control cage.</source>
        <translation>Esta entrada no es un sistema del plano, así que no tiene jaula de control.</translation>
    </message>
    <message>
        <source>The cage is too flat to be inverted. Open it by dragging a corner, or reset it, and try again.</source>
        <translation>La jaula está demasiado aplastada para invertir su efecto. Ábrala arrastrando un vértice, o restablézcala, y vuelva a intentarlo.</translation>
    </message>
    <message>
        <source>The three points are on one line, so they define no coordinates. Click a third point off the line.</source>
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
        <source>Vertex %1 is already there.</source>
        <translation>El vértice %1 ya está ahí.</translation>
    </message>
    <message>
        <source>A cage can have at most %1 vertices.</source>
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
        <source>A cage needs at least three vertices.</source>
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
        <source>Unbake: extract the placement from the code</source>
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
        <source>The cage is already the minimal canonical simplex.</source>
        <translation>La jaula ya es el símplex canónico mínimo.</translation>
    </message>
    <message>
        <source>The cage is already regular.</source>
        <translation>La jaula ya es regular.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Mover el vértice %1 a (%2, %3)</translation>
    </message>
    <message>
        <source>The four points are in one plane, so they define no coordinates. Click the fourth point off the plane.</source>
        <translation>Los cuatro puntos están en un plano, así que no definen coordenadas. Haga clic en el cuarto punto fuera del plano.</translation>
    </message>
    <message>
        <source>Define the control tetrahedron</source>
        <translation>Definir el tetraedro de control</translation>
    </message>
</context>
<context>
    <name>document::Document</name>
    <message>
        <source>%1 (frame %2)</source>
        <comment>what is done, at which frame</comment>
        <translation>%1 (fotograma %2)</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Esta entrada no tiene aplicaciones del plano.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Forma afín invariante</translation>
    </message>
    <message>
        <source>Row j of a matrix contains the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. Dragging the triangle does not change the matrices. If no entry is negative, the map takes the triangle to a part of itself.</source>
        <translation>La fila j de una matriz contiene las coordenadas baricéntricas de la imagen del vértice j en el triángulo, de modo que cada fila suma 1. Las matrices no cambian cuando se arrastra el triángulo. Si ningún elemento es negativo, la aplicación lleva el triángulo dentro de sí mismo.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Each map as a matrix that acts on barycentric coordinates in the control triangle; every row sums to 1.</source>
        <translation>Cada aplicación como matriz que lleva coordenadas baricéntricas respecto del triángulo de control a coordenadas baricéntricas: cada fila suma 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices at full precision.</source>
        <translation>Copia el triángulo y las matrices con todas las cifras.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy includes all of them.
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
        <source>Copy all properties at full precision</source>
        <translation>Copiar todas las propiedades con todas sus cifras</translation>
    </message>
    <message>
        <source>This entry could not be read, so it cannot be analysed.</source>
        <translation>Esta entrada no se pudo leer, así que nada se sabe de ella.</translation>
    </message>
    <message>
        <source>Copy at Full Precision</source>
        <translation>Copiar con todas las cifras</translation>
    </message>
    <message>
        <source>Copies the name and the value of every line, at full precision.</source>
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
        <source>Show the mean and the covariance ellipse</source>
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
        <source>Length of the addresses</source>
        <translation>Longitud de las direcciones</translation>
    </message>
    <message>
        <source>The number of symbols in the addresses of the cylinders; fewer if there would be thousands of cylinders</source>
        <translation>Cuántos símbolos tienen las direcciones de los cilindros; menos donde habría miles</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Longitud de dirección</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system produces a bent picture. These are the properties of the code; on the canvas, the outlines bend with the picture.</source>
        <translation>La jaula curva la imagen, y ningún sistema produce una imagen curvada. Estas son las propiedades del código; en el lienzo, los contornos se curvan con la imagen.</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with addresses of the same length, each in the colour of its first map; click one to see its address</source>
        <translation>Dibujar las envolventes de todas las partes con dirección de igual longitud, en el color de su primera aplicación; haga clic en una para ver su dirección</translation>
    </message>
    <message>
        <source>This value is still being computed.</source>
        <translation>Este valor todavía se está calculando.</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>Branches are moved. Box, simplex, hull, mean and covariance are those of the picture; the other properties are those of the code.</source>
        <translation>Hay ramas desplazadas. La caja, el símplex, la envolvente, la media y la covarianza son las de la imagen; las demás propiedades son las del código.</translation>
    </message>
    <message>
        <source>How Pieces Meet…</source>
        <translation>Cómo se tocan las piezas…</translation>
    </message>
    <message>
        <source>Read in the user guide what these properties mean and how they are proved</source>
        <translation>Leer en la guía del usuario qué significan estas propiedades y cómo se demuestran</translation>
    </message>
    <message>
        <source>Opens the user guide where it explains how the pieces of an attractor meet.</source>
        <translation>Abre la guía del usuario donde explica cómo se tocan las piezas de un atractor.</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Copiado.</translation>
    </message>
</context>
<context>
    <name>view::AnimationExportDialog</name>
    <message>
        <source>Export the Animation “%1”</source>
        <translation>Exportar la animación «%1»</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>PNG: one picture for each frame</source>
        <translation>PNG: una imagen por fotograma</translation>
    </message>
    <message>
        <source>A video, an animated image for web pages and messages, or one picture for each frame. All of them contain the animation, so Barycage can open them again.</source>
        <translation>Un vídeo, una imagen en movimiento para páginas y mensajes, o una imagen por fotograma. Todos contienen la animación y Barycage vuelve a abrirlos.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formato:</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Encuadre</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vista del lienzo</translation>
    </message>
    <message>
        <source>The whole animation</source>
        <translation>Toda la animación</translation>
    </message>
    <message>
        <source>What the frames show where the camera has no keys: the view on the canvas, or everything that becomes visible, with a small margin.</source>
        <translation>Lo que muestran los fotogramas cuando ninguna clave de la cámara lo fija: lo que muestra el lienzo, o todo lo que llega a verse, con un pequeño margen.</translation>
    </message>
    <message>
        <source>&amp;Size in pixels:</source>
        <translation>Tamaño en píxele&amp;s:</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Primer fotograma</translation>
    </message>
    <message>
        <source>The first frame to export.</source>
        <translation>El primer fotograma que se exporta.</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Último fotograma</translation>
    </message>
    <message>
        <source>The last frame to export.</source>
        <translation>El último fotograma que se exporta.</translation>
    </message>
    <message>
        <source>F&amp;rames:</source>
        <translation>Fotog&amp;ramas:</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>The number of points for each pixel of each frame: more points make smoother frames and take longer.</source>
        <translation>El número de puntos por píxel de cada fotograma: más puntos dan fotogramas más suaves y tardan más.</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Borrador: 25 puntos por píxel</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Buena: 100 puntos por píxel</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Fina: 400 puntos por píxel</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Finísima: 2000 puntos por píxel</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>Ca&amp;lidad:</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Obturador</translation>
    </message>
    <message>
        <source>Motion blur: the angle for which the shutter is open around each frame. 180° is half the time of a frame, as in films.</source>
        <translation>Desenfoque de movimiento: el ángulo durante el que el obturador está abierto en torno a cada fotograma. 180° son la mitad del tiempo de un fotograma, como en el cine.</translation>
    </message>
    <message>
        <source>No motion blur</source>
        <translation>Sin desenfoque de movimiento</translation>
    </message>
    <message>
        <source>S&amp;hutter:</source>
        <translation>O&amp;bturador:</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Exposición</translation>
    </message>
    <message>
        <source>Smooth: no flicker</source>
        <translation>Suave: sin parpadeo</translation>
    </message>
    <message>
        <source>Fixed: as in frame 0</source>
        <translation>Fija: la del fotograma 0</translation>
    </message>
    <message>
        <source>Each: frame by frame</source>
        <translation>Cada uno: por sí mismo</translation>
    </message>
    <message>
        <source>How bright the frames are: following the whole animation without flicker, all like frame 0, or each as bright as it is on the canvas.</source>
        <translation>Lo claros que son los fotogramas: siguiendo toda la animación sin parpadeo, todos como el fotograma 0, o cada uno como en el lienzo.</translation>
    </message>
    <message>
        <source>E&amp;xposure:</source>
        <translation>E&amp;xposición:</translation>
    </message>
    <message>
        <source>Tasks on a cluster</source>
        <translation>Tareas en un clúster</translation>
    </message>
    <message>
        <source>How many cluster tasks share the frames when you choose On a Cluster.</source>
        <translation>Entre cuántas tareas de un clúster se reparten los fotogramas al elegir «En un clúster».</translation>
    </message>
    <message>
        <source>&amp;Tasks on a cluster:</source>
        <translation>&amp;Tareas en un clúster:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the animation. You can continue editing in the meantime: the animation is exported as it was when this dialog opened.</source>
        <translation>Pide un nombre de archivo y escribe la animación. Mientras tanto puede seguir editando: se exporta la animación tal como estaba al abrir este diálogo.</translation>
    </message>
    <message>
        <source>On a &amp;Cluster…</source>
        <translation>En un &amp;clúster…</translation>
    </message>
    <message>
        <source>Writes a folder with the animation and with scripts that draw it on a Slurm cluster, and submits the job if sbatch is found.</source>
        <translation>Escribe una carpeta con la animación y con guiones que la dibujan en un clúster Slurm, y la envía si se encuentra sbatch.</translation>
    </message>
    <message>
        <source>Export Animation</source>
        <translation>Exportar animación</translation>
    </message>
    <message>
        <source>Measuring the brightness…</source>
        <translation>Midiendo la luminosidad…</translation>
    </message>
    <message>
        <source>Export stopped. The pictures written so far are complete; export again to draw the others.</source>
        <translation>Exportación detenida. Las imágenes escritas hasta ahora están completas; exporte de nuevo para dibujar las demás.</translation>
    </message>
    <message>
        <source>Written to %1 and so on, up to %2.</source>
        <translation>Escrito en %1 y así sucesivamente hasta %2.</translation>
    </message>
    <message>
        <source>Folder That the Cluster Can Read and Write</source>
        <translation>Carpeta que el clúster puede leer y escribir</translation>
    </message>
    <message>
        <source>Writing the job folder…</source>
        <translation>Escribiendo la carpeta del trabajo…</translation>
    </message>
    <message>
        <source>Cancelled; the folder may be incomplete.</source>
        <translation>Cancelado; la carpeta puede estar incompleta.</translation>
    </message>
    <message>
        <source>The job is in %1. sbatch was not found on this computer: run submit.sh in this folder on the cluster.</source>
        <translation>El trabajo está en %1. Aquí no hay sbatch: ejecute submit.sh de esa carpeta en el clúster.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>La vista «%1»</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Fotograma sin atractor</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>E&amp;ncuadre:</translation>
    </message>
    <message>
        <source>The animation “%1” is still being exported.</source>
        <translation>La animación «%1» aún se está exportando.</translation>
    </message>
    <message>
        <source>The pictures written so far are complete and will be kept.</source>
        <translation>Las imágenes escritas hasta ahora están completas y se conservan.</translation>
    </message>
    <message>
        <source>Summary of the export</source>
        <translation>Resumen de la exportación</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), %1 s.</source>
        <translation>
            <numerusform>%n fotograma, %1 s.</numerusform>
            <numerusform>%n fotogramas, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for existing pictures…</source>
        <translation>Buscando imágenes existentes…</translation>
    </message>
    <message>
        <source>Replace Files?</source>
        <translation>¿Reemplazar los archivos?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) with the names of these pictures exist already and hold something else.</source>
        <translation>
            <numerusform>Ya existe %n archivo con el nombre de una de estas imágenes, y contiene otra cosa.</numerusform>
            <numerusform>Ya existen %n archivos con los nombres de estas imágenes, y contienen otra cosa.</numerusform>
        </translation>
    </message>
    <message>
        <source>The first one is “%1”. If you replace them, their contents are lost.</source>
        <translation>El primero es «%1». Si los reemplaza, se perderá su contenido.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>Frame of the preview</source>
        <translation>Fotograma de la vista previa</translation>
    </message>
    <message>
        <source>The frame that the preview shows</source>
        <translation>El fotograma que muestra la vista previa</translation>
    </message>
    <message>
        <source>Choose how many tasks share the frames, then click On a Cluster… again.</source>
        <translation>Elija cuántas tareas se reparten los fotogramas y vuelva a hacer clic en «En un clúster…».</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Supermuestreo</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Dibuja tantos píxeles a lo largo de cada lado de uno: bordes más suaves.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>Sobre&amp;muestreo:</translation>
    </message>
    <message>
        <source>%1 needs even sides: the last column or row is shown twice.</source>
        <translation>%1 necesita lados pares: la última columna o fila se muestra dos veces.</translation>
    </message>
    <message>
        <source>%1 has no transparency: the background becomes black.</source>
        <translation>%1 no tiene transparencia: el fondo se vuelve negro.</translation>
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
        <source>Reset every setting of this panel to its default</source>
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
        <source>Colour by the density of points</source>
        <translation>La paleta sigue la densidad de los puntos</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Aplicación</translation>
    </message>
    <message>
        <source>Colour by the last map applied</source>
        <translation>El color de la última aplicación aplicada</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Colour by the address of each point</source>
        <translation>La paleta sigue la dirección de cada punto</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Color único</translation>
    </message>
    <message>
        <source>One colour, with the density as its opacity</source>
        <translation>Un solo color; la densidad es su opacidad</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Color único</translation>
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
        <source>How strongly thin parts show: κ of the logarithmic tone curve</source>
        <translation>Cuán pronto se hacen visibles las partes tenues: κ de la curva tonal logarítmica</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
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
        <source>Makes the background of exported pictures transparent.</source>
        <translation>Prescinde del fondo en las imágenes exportadas.</translation>
    </message>
    <message>
        <source>Computes every pixel from several smaller ones: smoother edges, at the cost of memory and time.</source>
        <translation>Dibuja cada píxel a partir de varios más finos: bordes más suaves, a cambio de más memoria y tiempo.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Colorear según: %1</translation>
    </message>
    <message>
        <source>Palette: %1</source>
        <translation>Paleta: %1</translation>
    </message>
    <message>
        <source>Supersampling: %1</source>
        <translation>Supermuestreo: %1</translation>
    </message>
    <message>
        <source>More Palettes…</source>
        <translation>Más paletas…</translation>
    </message>
    <message>
        <source>Browse hundreds of palettes, change their hue and shift them</source>
        <translation>Explorar cientos de paletas, girarlas y desplazarlas</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Contraste</translation>
    </message>
    <message>
        <source>Above 1, light parts become lighter and dark parts darker</source>
        <translation>Por encima de 1, las partes claras se aclaran y las oscuras se oscurecen</translation>
    </message>
    <message>
        <source>Above 1, tones lighter than the middle become lighter, and darker ones darker. Below 1, they come closer together. Black, middle and white stay.</source>
        <translation>Por encima de 1, los tonos más claros que el medio se aclaran y los más oscuros se oscurecen. Por debajo de 1, se acercan entre sí. El negro, el medio y el blanco no cambian.</translation>
    </message>
    <message>
        <source>Vibrancy</source>
        <translation>Vivacidad</translation>
    </message>
    <message>
        <source>Below 1, colours are paler, the more so the higher the gamma</source>
        <translation>Por debajo de 1, los colores son más pálidos, tanto más cuanto mayor es el gamma</translation>
    </message>
    <message>
        <source>At 1, the gamma decides only how strongly a colour shows, and the colour keeps its hue. At 0, the gamma acts on red, green and blue as well, and colours are paler. Flames have the same setting.</source>
        <translation>Con 1, el gamma solo decide con qué intensidad se ve un color, y el color conserva su matiz. Con 0, el gamma actúa también sobre el rojo, el verde y el azul, y los colores son más pálidos. Las flames tienen el mismo ajuste.</translation>
    </message>
    <message>
        <source>What the colour of a point shows: how many points fall there, which map came last, the whole address, or the blend of the colours of all maps applied, as in flames. The position of each map on the palette, and its speed, are in the Maps panel.</source>
        <translation>Lo que dice el color de un punto: cuántos puntos caen allí, qué aplicación fue la última, la dirección entera o la mezcla de los colores de todas las aplicaciones del camino, como en los flames. El panel Aplicaciones tiene el lugar de cada aplicación en la paleta y su velocidad.</translation>
    </message>
    <message>
        <source>Blend of maps</source>
        <translation>Mezcla de aplicaciones</translation>
    </message>
    <message>
        <source>As in flames: each map moves colours towards its position on the palette</source>
        <translation>Como en los flames: cada aplicación atrae los colores hacia su lugar en la paleta</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, along the addresses, or along the positions between which maps blend.</source>
        <translation>Los colores, de las partes más tenues a las más densas, a lo largo de las direcciones o de los lugares entre los que mezclan las aplicaciones.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Sombra</translation>
    </message>
    <message>
        <source>Opacity of the shadow on the ground behind the picture; 0: no shadow</source>
        <translation>Opacidad de la sombra en el suelo detrás de la imagen; 0: sin sombra</translation>
    </message>
    <message>
        <source>The shadow is the picture once more: darker, flattened, and laid on the ground on which the picture stands. Drag its tip on the canvas to turn it.</source>
        <translation>La sombra es la imagen otra vez: más oscura, aplanada y tendida en el suelo en el que la imagen se apoya. Arrastre su punta en el lienzo para girarla.</translation>
    </message>
    <message>
        <source>Shadow sideways</source>
        <translation>Sombra de lado</translation>
    </message>
    <message>
        <source>How far to the right the shadow of what is 1 high ends; below 0, to the left</source>
        <translation>Cuán a la derecha termina la sombra de lo que mide 1 de alto; por debajo de 0, a la izquierda</translation>
    </message>
    <message>
        <source>Shadow backwards</source>
        <translation>Sombra hacia atrás</translation>
    </message>
    <message>
        <source>How far up the shadow of what is 1 high ends; below 0, it falls to the front</source>
        <translation>Cuán arriba termina la sombra de lo que mide 1 de alto; por debajo de 0 cae hacia delante</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The field next to it shows the same value.</source>
        <translation>Arrastre o use las teclas de flecha. El número de al lado es el mismo valor.</translation>
    </message>
</context>
<context>
    <name>view::AttractorWatch</name>
    <message>
        <source>At frame %1, it could not be decided whether there is an attractor.</source>
        <translation>En el fotograma %1 no se pudo decidir si existe un atractor.</translation>
    </message>
    <message>
        <source>Weaken the motions.</source>
        <translation>Atenúe los movimientos.</translation>
    </message>
    <message>
        <source>Change the maps.</source>
        <translation>Cambie las aplicaciones.</translation>
    </message>
    <message>
        <source>Weaken the motions, or change the keys of the maps (frames: %1).</source>
        <translation>Atenúe los movimientos o cambie las claves de las aplicaciones (fotogramas: %1).</translation>
    </message>
    <message>
        <source>Change the keys of the maps (frames: %1).</source>
        <translation>Cambie las claves de las aplicaciones (fotogramas: %1).</translation>
    </message>
    <message>
        <source>Set a key there, or change the keys of the maps (frames: %1).</source>
        <translation>Ponga una clave allí o cambie las claves de las aplicaciones (fotogramas: %1).</translation>
    </message>
    <message>
        <source>At frame %1, there is no attractor.</source>
        <translation>En el fotograma %1 no hay atractor.</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Diagrama del conteo de cajas</translation>
    </message>
    <message>
        <source>The number of boxes that meet the attractor, against their fineness: log₂ N over k for boxes of side L·2⁻ᵏ, where L is the side of the square around the attractor. Hollow points are not used for the line: at those sizes, the size of the whole or of a cell affects the count.</source>
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
        <source>The number of maps in the address of the branch (Shift + wheel over the canvas)</source>
        <translation>Cuántas aplicaciones de la dirección nombran la rama (Mayús + rueda sobre el lienzo)</translation>
    </message>
    <message>
        <source>The address of the clicked point, outermost map first; the bold part is the address of the branch</source>
        <translation>La dirección del punto pulsado, con la aplicación más externa primero; la parte en negrita es la dirección de la rama</translation>
    </message>
    <message>
        <source>New map for this branch</source>
        <translation>Una aplicación nueva para esta rama</translation>
    </message>
    <message>
        <source>Gives this branch and each of its sibling branches a map of its own. The change appears again at all smaller scales.</source>
        <translation>Esta rama y cada una de sus ramas hermanas reciben una aplicación propia. El cambio reaparece en todas las escalas menores.</translation>
    </message>
    <message>
        <source>Last map of the address</source>
        <translation>La última aplicación de la dirección</translation>
    </message>
    <message>
        <source>The system keeps its number of maps. All branches that this map makes change in the same way.</source>
        <translation>El sistema conserva su número de aplicaciones. Todas las ramas que produce esta aplicación cambian de la misma manera.</translation>
    </message>
    <message>
        <source>What editing the branch changes</source>
        <translation>Qué cambia al editar la rama</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Ángulo en que las aplicaciones elegidas oscilan sobre sus raíces</translation>
    </message>
    <message>
        <source>Swings the selected maps, each about the image of the lowest point of the fractal; the slider returns to the middle when you release it</source>
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
        <source>Swing maps</source>
        <translation>Hacer oscilar aplicaciones</translation>
    </message>
    <message>
        <source>Only here</source>
        <translation>Solo aquí</translation>
    </message>
    <message>
        <source>The code does not change. Only this branch is shown in another position; the same change does not appear at other scales.</source>
        <translation>El código no cambia. Solo esta rama se muestra en otro lugar; el cambio no se repite a otras escalas.</translation>
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
        <source>Shows the branch in its original position, given by its maps</source>
        <translation>Muestra la rama donde la ponen sus aplicaciones</translation>
    </message>
    <message>
        <source>Shows all branches in their original positions, given by their maps</source>
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
    <message>
        <source>What changes in the code when you drag the branch</source>
        <translation>Qué cambia en el código al arrastrar la rama</translation>
    </message>
    <message>
        <source>Here and inside it</source>
        <translation>Aquí y en su interior</translation>
    </message>
    <message>
        <source>The code does not change. This branch is shown in another position, and so is the same branch inside it, again and again: a frond curls up. Nothing beside it changes.</source>
        <translation>El código no cambia. Esta rama se muestra en otra posición, y también la misma rama dentro de ella, una y otra vez: una fronda se enrosca. Nada cambia a su lado.</translation>
    </message>
    <message>
        <source>Maps cannot swing while the cage is flat. First open or reset the cage.</source>
        <translation>Las aplicaciones no pueden oscilar mientras la jaula es plana. Antes abra la jaula o restablézcala.</translation>
    </message>
    <message>
        <source>S&amp;wing</source>
        <translation>&amp;Balancear</translation>
    </message>
</context>
<context>
    <name>view::BranchChoice</name>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Pulse en un punto del atractor para elegir su rama.</translation>
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
        <source>Move corner %1 of branch %2</source>
        <translation>Mover la esquina %1 de la rama %2</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Mover la rama %1</translation>
    </message>
    <message>
        <source>This branch is now map 1. You can change it further in the table.</source>
        <translation>Esta rama es ahora la aplicación 1. Los números de la tabla la siguen cambiando.</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Detenido: más allá, la rama no se haría más pequeña dentro de sí misma.</translation>
    </message>
</context>
<context>
    <name>view::CageFitter</name>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>La imagen es demasiado estrecha para una jaula así.</translation>
    </message>
    <message>
        <source>The cage already has this shape.</source>
        <translation>La jaula ya está ahí.</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Ajustar la jaula</translation>
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
        <source>Moving the cage moves the picture; the code does not change</source>
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
        <source>The picture follows every vertex and bends; a bent picture cannot be baked into the code</source>
        <translation>La imagen sigue a todos los vértices y se curva, lo que no se puede incorporar a un código</translation>
    </message>
    <message>
        <source>The picture follows the vertices by the closest affine map; it can be baked</source>
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
        <source>Define the triangle with three clicks on the canvas; the picture stays</source>
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
        <source>Show the positions of the vertices when the cage is at rest</source>
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
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from the right angle.</source>
        <translation>El menor triángulo rectángulo isósceles de catetos paralelos a los ejes que contiene la imagen. Los signos dicen hacia qué lado apuntan sus catetos desde el ángulo recto.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Coordenadas baricéntricas de un punto</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 for which the point is the weighted mean of the vertices.</source>
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
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Los tres puntos están alineados: la jaula de reposo debe encerrar un área.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>La jaula de reposo debe ser un polígono que no se cruce a sí mismo.</translation>
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
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Esta entrada no se pudo leer, así que no tiene jaula.</translation>
    </message>
    <message>
        <source>At rest: the picture shows the code.</source>
        <translation>En reposo: la imagen es la del código.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture shows the code.</source>
        <translation>%1 vértices, en reposo: la imagen es la del código.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates; cannot be baked.</source>
        <translation>%1 vértices: curvada con coordenadas de Wachspress, no se puede incorporar.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates; cannot be baked.</source>
        <translation>%1 vértices: curvada con coordenadas de valor medio, no se puede incorporar.</translation>
    </message>
    <message>
        <source>Flat: the picture is squeezed onto a line. Open the cage to get it back.</source>
        <translation>Aplastada: la imagen está en una recta. Abra la jaula y volverá.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the orientation is reversed.</source>
        <translation>Colocada y reflejada: las áreas se multiplican por %1 y el sentido de giro se invierte.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Colocada: las áreas se multiplican por %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it defines no coordinates.</source>
        <translation>El triángulo está aplastado: no determina coordenadas.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, cateto %2, vértice (%3, %4)</translation>
    </message>
    <message>
        <source>Replace the cage by one fitted to the picture; the picture stays</source>
        <translation>Sujetar la imagen con una jaula ajustada; la imagen no cambia</translation>
    </message>
    <message>
        <source>Return the cage and the picture to rest</source>
        <translation>Devolver la jaula y la imagen al reposo</translation>
    </message>
    <message>
        <source>Write the displayed picture into the code; the cage is then at rest</source>
        <translation>Convertir la imagen mostrada en el código; la jaula queda entonces en reposo</translation>
    </message>
    <message>
        <source>Available for triangles only.</source>
        <translation>Disponible solo para triángulos.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Mover el vértice %1 a (%2, %3)</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3)</source>
        <translation>Definir el vértice %1 en (%2, %3)</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>z at rest</source>
        <translation>z en reposo</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from their common corner.</source>
        <translation>El menor tetraedro con tres aristas iguales paralelas a los ejes que contiene la imagen. Los signos dicen hacia dónde apuntan estas aristas desde su vértice común.</translation>
    </message>
    <message>
        <source>The weights a, b, c, d with a + b + c + d = 1 for which the point is the weighted mean of the vertices.</source>
        <translation>Los pesos a, b, c, d con a + b + c + d = 1 que hay que poner en los vértices para que el punto sea su centro de masas.</translation>
    </message>
    <message>
        <source>z of the point</source>
        <translation>z del punto</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3, %4)</source>
        <translation>Mover el vértice %1 a (%2, %3, %4)</translation>
    </message>
    <message>
        <source>The vertices are in one plane: the rest cage must enclose a volume.</source>
        <translation>Los vértices están en un mismo plano: la jaula de reposo debe encerrar un volumen.</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3, %4)</source>
        <translation>Definir el vértice %1 en (%2, %3, %4)</translation>
    </message>
    <message>
        <source>Flat: the solid is squeezed onto a plane or a line. Open the cage to get it back.</source>
        <translation>Aplastada: el sólido está en un plano o en una recta. Abra la jaula y volverá.</translation>
    </message>
    <message>
        <source>Placed and mirrored: volumes change by the factor %1, and the orientation is reversed.</source>
        <translation>Colocada y reflejada: los volúmenes se multiplican por %1 y la orientación se invierte.</translation>
    </message>
    <message>
        <source>Placed: volumes change by the factor %1.</source>
        <translation>Colocada: los volúmenes se multiplican por %1.</translation>
    </message>
    <message>
        <source>Available for tetrahedra only.</source>
        <translation>Disponible solo para tetraedros.</translation>
    </message>
    <message>
        <source>The tetrahedron is flat: it defines no coordinates.</source>
        <translation>El tetraedro está aplastado: no determina coordenadas.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Este sistema no tiene ningún atractor que se pueda encerrar.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4, %5)</source>
        <translation>%1, arista %2, vértice (%3, %4, %5)</translation>
    </message>
    <message>
        <source>The system has very many maps. Computing the cage around it…</source>
        <translation>El sistema tiene muchísimas aplicaciones: se está buscando la jaula que lo rodea…</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, cannot be baked.</source>
        <translation>%1 vértices: curvada con coordenadas de valor medio, no se puede incorporar.</translation>
    </message>
    <message>
        <source>Define the tetrahedron with four clicks on the canvas; the picture stays</source>
        <translation>Define el tetraedro con cuatro clics en el lienzo; la imagen no cambia</translation>
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
        <source>Select a corner first.</source>
        <translation>Elija primero un vértice.</translation>
    </message>
    <message>
        <source>To insert a corner, point to an edge or select a corner.</source>
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
        <source>No attractor: the maps %1, applied one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Sin atractor: las aplicaciones %1, una tras otra, no son contractivas (mayor valor singular %2, radio espectral %3). Reduzca una de ellas o desactívela.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor: map %1 stretches by up to %2. Points that escape are left out.</source>
        <translation>No está decidido si este sistema tiene atractor: la aplicación %1 alarga las distancias con factor %2. Los puntos que se escapan no se dibujan.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor. Points that escape are left out.</source>
        <translation>No está decidido si este sistema tiene atractor. Los puntos que se escapan no se dibujan.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept unchanged in the file.</source>
        <translation>Esta entrada no se pudo leer. Su texto se conserva tal cual en el archivo.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Ninguna aplicación está activa, así que no hay nada que dibujar. Añada una aplicación o active alguna.</translation>
    </message>
    <message>
        <source>This is the limit of numerical precision: zoom out a little for an accurate picture.</source>
        <translation>Más profundo no llega la aritmética: aleje un poco la vista para obtener una imagen fiel.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than requested: more would exceed the memory limit.</source>
        <translation>Dibujado con menos iteraciones de las pedidas: más necesitarían más memoria de la permitida.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a corner to open it: nothing is lost.</source>
        <translation>La jaula está aplastada, y la imagen también. Arrastre un vértice para abrirla: no se pierde nada.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Detenido: más allá, la aplicación %1 no contraería (mayor valor singular %2, radio espectral %3) y no habría atractor.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, the maps %1, applied one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Detenido: más allá, las aplicaciones %1, una tras otra, no contraerían (mayor valor singular %2, radio espectral %3) y no habría atractor.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, an attractor is not guaranteed (map %1 has the largest singular value, %2).</source>
        <translation>Detenido: más allá no se garantiza un atractor (la aplicación %1 tiene el mayor valor singular, %2).</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point is left.</source>
        <translation>Una sola aplicación: no queda más que su punto fijo.</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point (%1, %2) is left.</source>
        <translation>Una sola aplicación: no queda más que su punto fijo (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is switched on has a positive weight, so there is nothing to draw. Give one of them a weight.</source>
        <translation>Ninguna aplicación activa tiene un peso mayor que 0, así que no hay nada que dibujar. Dé un peso a alguna.</translation>
    </message>
    <message>
        <source>Whether this system has an attractor is undecided.</source>
        <translation>No se ha decidido si este sistema tiene un atractor.</translation>
    </message>
    <message>
        <source>This system has no attractor, so the picture may be incomplete or empty.</source>
        <translation>Este sistema no tiene atractor, por lo que la imagen puede estar incompleta o vacía.</translation>
    </message>
    <message>
        <source>So many pieces overlap that parts of this solid may be missing. The look Cloud shows all of it.</source>
        <translation>Se superponen tantas piezas que pueden faltar partes de este sólido. El aspecto «Nube» lo muestra entero.</translation>
    </message>
    <message>
        <source>What lies far behind this small view may be drawn in the wrong order. Zoom out a little for an accurate picture.</source>
        <translation>Lo que está muy por detrás de esta vista tan pequeña puede dibujarse en un orden incorrecto. Aleje un poco la vista para obtener una imagen fiel.</translation>
    </message>
    <message>
        <source>Nothing here. Press %1 to see the whole picture.</source>
        <translation>Aquí no hay nada. Pulse %1 para ver toda la imagen.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Mover la jaula reescribe el código</translation>
    </message>
</context>
<context>
    <name>view::CanvasInput</name>
    <message>
        <source>Cylinder %1</source>
        <translation>Cilindro %1</translation>
    </message>
    <message>
        <source>Corner outside the view: click to fit the picture and its cage</source>
        <translation>Esquina fuera de la vista: haga clic para encuadrar la imagen y su jaula</translation>
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
        <source>Lets you type the coordinates of this vertex</source>
        <translation>Permite escribir las coordenadas de este vértice</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>&amp;Restablecer este vértice</translation>
    </message>
    <message>
        <source>Returns this vertex to its position at rest</source>
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
        <source>Removes this vertex from the cage</source>
        <translation>Quita este vértice de la jaula</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>Poner aquí el &amp;pivote</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about this vertex</source>
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
        <source>Inserts a vertex on this edge; double-clicking does the same</source>
        <translation>Pone un vértice más en esta arista; un doble clic hace lo mismo</translation>
    </message>
    <message>
        <source>Rotate: hold Shift for steps of 15°</source>
        <translation>Girar: con Mayús, en pasos de 15°</translation>
    </message>
    <message>
        <source>Scale: hold Shift for x or y only</source>
        <translation>Escalar: con Mayús, solo en x o en y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivote</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Centre</source>
        <translation>Poner el &amp;pivote en el centro</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about its centre</source>
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
        <source>Fits the smallest isosceles right triangle with legs parallel to the axes around the picture</source>
        <translation>Ajusta alrededor de la imagen el menor triángulo rectángulo isósceles de catetos paralelos a los ejes</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Definir el triángulo</translation>
    </message>
    <message>
        <source>Defines the triangle with three clicks; the picture stays</source>
        <translation>Sujeta la imagen con tres puntos en los que se hace clic</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>Res&amp;tablecer la jaula</translation>
    </message>
    <message>
        <source>Returns every vertex to its position at rest</source>
        <translation>Devuelve todos los vértices al reposo</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>Hacer re&amp;gular</translation>
    </message>
    <message>
        <source>Moves the vertices to the nearest regular polygon</source>
        <translation>Lleva los vértices al polígono regular más próximo</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw the picture as shown, with the cage at rest</source>
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
        <source>Shows one unit of the plane as one hundred pixels</source>
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
        <source>Points the y axis down, as in window coordinates</source>
        <translation>Dirige el eje y hacia abajo, como en las coordenadas de una ventana</translation>
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
        <source>Copies the picture as shown, without the cage</source>
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
        <source>Switches this map on or off</source>
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
        <source>Adds a copy of this map</source>
        <translation>Pone una copia de esta aplicación al lado</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Removes this map from the system</source>
        <translation>Quita esta aplicación del sistema</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>Des&amp;bloquear</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Bloquear</translation>
    </message>
    <message>
        <source>Lets this map be edited again</source>
        <translation>Permite editar de nuevo esta aplicación</translation>
    </message>
    <message>
        <source>Locks this map against editing</source>
        <translation>Protege esta aplicación de cambios</translation>
    </message>
    <message>
        <source>&amp;Reset Rotation</source>
        <translation>Resta&amp;blecer el giro</translation>
    </message>
    <message>
        <source>Returns the view to upright</source>
        <translation>Vuelve a enderezar la vista</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Incorporar</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab moves from handle to handle, the arrow keys move the handle in focus, F6 leaves the canvas.</source>
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
        <source>Reset the cage first?</source>
        <translation>¿Devolver antes la jaula al reposo?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Restablecer la jaula</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press %1 to see the cage again.</source>
        <translation>Solo se muestra la imagen. Pulse %1 para volver a ver la jaula.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; hold Ctrl to rotate, Alt to scale, Shift to keep directions. The wheel zooms at the pointer, the middle button pans. Tab moves from handle to handle, the arrow keys move the handle, F6 leaves the canvas.</source>
        <translation>La imagen y su jaula. Arrastre un vértice, una arista o el interior de la jaula; Ctrl gira, Alt escala, Mayús conserva la dirección. La rueda amplía o reduce en torno al puntero, el botón central mueve el plano. Tab pasa de un tirador a otro, las teclas de flecha los mueven, F6 sale.</translation>
    </message>
</context>
<context>
    <name>view::ClusterQueue</name>
    <message>
        <source>%1 running</source>
        <translation>%1 en curso</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 en espera</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 fallidas</translation>
    </message>
    <message>
        <source>Drawing: %1.</source>
        <translation>Dibujo: %1.</translation>
    </message>
    <message>
        <source>Video: done.</source>
        <translation>Vídeo: terminado.</translation>
    </message>
    <message>
        <source>Video: failed.</source>
        <translation>Vídeo: fallido.</translation>
    </message>
    <message>
        <source>Video: running.</source>
        <translation>Vídeo: en curso.</translation>
    </message>
    <message>
        <source>Video: waiting.</source>
        <translation>Vídeo: en espera.</translation>
    </message>
    <message>
        <source>Submitting…</source>
        <translation>Enviando…</translation>
    </message>
    <message>
        <source>The script ended without submitting anything.</source>
        <translation>El guion terminó sin enviar nada.</translation>
    </message>
    <message>
        <source>The result is in %1.</source>
        <translation>El resultado está en %1.</translation>
    </message>
    <message>
        <source>The reason is in the logs in %1.</source>
        <translation>La causa está en los registros de %1.</translation>
    </message>
    <message>
        <source>Slurm did not accept the job: %1</source>
        <translation>Slurm no aceptó el trabajo: %1</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 de %2 terminadas</translation>
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
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>The part of the target that is covered</source>
        <translation>La parte del objetivo que está cubierta</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Exceso</translation>
    </message>
    <message>
        <source>Overlap (IoU)</source>
        <translation>Solapamiento (IoU)</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Distancia media</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % dentro de</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Distancia mayor</translation>
    </message>
    <message>
        <source>The Hausdorff distance; the mark on the canvas shows where it is</source>
        <translation>La distancia de Hausdorff; la marca del lienzo muestra dónde está</translation>
    </message>
    <message>
        <source>%1 (s = %2)</source>
        <translation>%1 (s = %2)</translation>
    </message>
    <message>
        <source>none: a map stretches by %1</source>
        <translation>ninguna: una aplicación estira por %1</translation>
    </message>
    <message>
        <source>No point of the target is farther from the attractor than this, and no point of the attractor from the target. The value is larger during a drag, when a coarser picture is measured</source>
        <translation>Ningún punto del objetivo está más lejos del atractor que esto, ni al revés. Es mayor mientras se arrastra, porque se mide una imagen más gruesa</translation>
    </message>
    <message>
        <source>%1 (ellipsoidal norm, γ = %2)</source>
        <translation>%1 (norma elipsoidal, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (polytope norm, γ = %2)</source>
        <translation>%1 (norma politopal, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (any %2 maps in a row contract, γ = %3)</source>
        <translation>%1 (%2 aplicaciones seguidas contraen, γ = %3)</translation>
    </message>
    <message>
        <source>The area covered outside the target, relative to the area of the target</source>
        <translation>El área cubierta fuera del objetivo, en relación con el área del objetivo</translation>
    </message>
    <message>
        <source>The area that both cover, relative to the area that either covers</source>
        <translation>El área que cubren ambos, en relación con el área que cubre al menos uno</translation>
    </message>
    <message>
        <source>How often the images of the maps cover the same places: their areas together, divided by the area that they cover. It is 1 where no two of them overlap</source>
        <translation>Cuántas veces las imágenes de las aplicaciones cubren los mismos lugares: la suma de sus áreas, dividida entre el área que cubren. Es 1 si no hay dos que se solapen</translation>
    </message>
    <message>
        <source>95 % of all points are within this distance of the other shape</source>
        <translation>El 95 % de los puntos está como mucho a esta distancia de la otra forma</translation>
    </message>
    <message>
        <source>From each point to the nearest point of the other shape, in pixels of the picture as it is traced</source>
        <translation>De cada punto al punto más cercano de la otra forma, en píxeles de la imagen tal como se calca</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Mean distance of the collage: %1 → %2.</source>
        <translation>Distancia media del collage: %1 → %2.</translation>
    </message>
    <message>
        <source>Mean distance of the attractor: %1 → %2.</source>
        <translation>Distancia media del atractor: %1 → %2.</translation>
    </message>
    <message>
        <source>Guarantee: %1 → %2.</source>
        <translation>Garantía: %1 → %2.</translation>
    </message>
    <message>
        <source>The distance has increased, but the overlap (IoU) has improved.</source>
        <translation>La distancia ha aumentado, pero la solapamiento (IoU) ha mejorado.</translation>
    </message>
    <message>
        <source>Nothing is guaranteed any more.</source>
        <translation>Ya no se garantiza nada.</translation>
    </message>
    <message>
        <source>The guarantee is now weaker.</source>
        <translation>La garantía es ahora más débil.</translation>
    </message>
    <message>
        <source>Overlap of the maps</source>
        <translation>Solapamiento de las aplicaciones</translation>
    </message>
    <message>
        <source>Guaranteed within</source>
        <translation>Garantizado dentro de</translation>
    </message>
</context>
<context>
    <name>view::CollagePanel</name>
    <message>
        <source>Use Suggestion</source>
        <translation>Usar la sugerencia</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Afinar las aplicaciones</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Afinar el atractor</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Ajustar los pesos</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Ajustar la jaula</translation>
    </message>
    <message>
        <source>Add Map</source>
        <translation>Añadir aplicación</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Collage</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Concordancia</translation>
    </message>
    <message>
        <source>of the collage</source>
        <translation>del collage</translation>
    </message>
    <message>
        <source>of the attractor</source>
        <translation>del atractor</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>no mostrar</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>The maps do not contract, so there is no attractor to compare.</source>
        <translation>Las aplicaciones no contraen, así que no hay atractor que comparar.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>No hay memoria suficiente para esto.</translation>
    </message>
    <message numerus="yes">
        <source>%n suggestions. Click one to use it.</source>
        <translation>
            <numerusform>%n sugerencia. Haga clic en ella para usarla.</numerusform>
            <numerusform>%n sugerencias. Haga clic en una para usarla.</numerusform>
        </translation>
    </message>
    <message>
        <source>The fractal has changed meanwhile, so the result was not used.</source>
        <translation>El fractal ha cambiado entretanto, así que no se usó el resultado.</translation>
    </message>
    <message>
        <source>No better agreement was found.</source>
        <translation>No se encontró nada que concuerde mejor.</translation>
    </message>
    <message>
        <source>Guarantee for the shades</source>
        <translation>Garantía para los tonos</translation>
    </message>
    <message>
        <source>Moved by at most this distance on average, the shades of the attractor become those of the picture</source>
        <translation>Desplazados como mucho esta distancia en promedio, los tonos del atractor pasan a ser los de la imagen</translation>
    </message>
    <message>
        <source>On average, the shades of the attractor are guaranteed to lie within %1 px of those of the picture.</source>
        <translation>En promedio, se garantiza que los tonos del atractor están a no más de %1 px de los de la imagen.</translation>
    </message>
    <message>
        <source>With these weights, the maps do not contract on average, so nothing is guaranteed for the shades.</source>
        <translation>Con estos pesos, las aplicaciones no contraen en promedio, así que no se garantiza nada para los tonos.</translation>
    </message>
    <message>
        <source>Choose what the canvas compares with the target</source>
        <translation>Elige qué compara el lienzo con el objetivo</translation>
    </message>
    <message>
        <source>Compares the target with its images under the maps, or with the attractor. Agreement is grey, excess red, and missing parts blue.</source>
        <translation>Compara el objetivo con sus imágenes por las aplicaciones, o con el atractor. Lo común en gris, lo que sobra en rojo, lo que falta en azul.</translation>
    </message>
    <message>
        <source>Result of refining</source>
        <translation>Resultado del afinado</translation>
    </message>
    <message>
        <source>What the last refinement has made of the distance and of the guarantee</source>
        <translation>Qué ha hecho el último afinado con la distancia y la garantía</translation>
    </message>
    <message>
        <source>1. Choose a picture</source>
        <translation>1. Elija una imagen</translation>
    </message>
    <message>
        <source>2. Ask for suggestions</source>
        <translation>2. Pida propuestas</translation>
    </message>
    <message>
        <source>3. Pick one</source>
        <translation>3. Elija una</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>More ways to trace</source>
        <translation>Más formas de calcar</translation>
    </message>
    <message>
        <source>Show how the picture is read, the agreement, and what refines a suggestion</source>
        <translation>Muestra cómo se lee la imagen, la concordancia y lo que refina una propuesta</translation>
    </message>
    <message>
        <source>Another picture is shown, so the search for the last one was cancelled.</source>
        <translation>Se muestra otra imagen, así que se canceló la búsqueda para la anterior.</translation>
    </message>
</context>
<context>
    <name>view::CollectionGrid</name>
    <message>
        <source>Fractals of the collection</source>
        <translation>Fractales de la colección</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Sin resultados</translation>
    </message>
    <message>
        <source>No favourites yet. Select a fractal and press Ctrl+D.</source>
        <translation>Todavía no hay favoritos. Elija un fractal y pulse Ctrl+D.</translation>
    </message>
    <message>
        <source>Fractals that you use appear here.</source>
        <translation>Aquí aparecen los fractales que usa.</translation>
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
    <message>
        <source>solid 3D space</source>
        <comment>words of a search</comment>
        <translation>sólido 3D espacio</translation>
    </message>
    <message>
        <source>moving animation motion</source>
        <comment>words of a search</comment>
        <translation>movimiento animación animado</translation>
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
        <source>Open the selected fractal as a separate document.</source>
        <translation>Abrir el fractal elegido como documento propio.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>Aña&amp;dir a este archivo</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Añadir el fractal elegido al archivo abierto.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>Fa&amp;vorito</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites.</source>
        <translation>Marcar el fractal elegido como uno de sus favoritos.</translation>
    </message>
    <message>
        <source>Fa&amp;vourites Only</source>
        <translation>S&amp;olo favoritos</translation>
    </message>
    <message>
        <source>Show only your favourites.</source>
        <translation>Mostrar únicamente sus favoritos.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>Añadir &amp;carpeta…</translation>
    </message>
    <message>
        <source>Add the .ifs files of one of your own folders to this list.</source>
        <translation>Mostrar aquí también los archivos .ifs de una carpeta suya.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>&amp;Quitar la carpeta «%1»</translation>
    </message>
    <message>
        <source>Remove this folder from the list. Its files are not changed.</source>
        <translation>Quitar esta carpeta de la lista. Sus archivos no cambian.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Carpeta de archivos .ifs</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>Muestra solo los fractales cuyo nombre, tema o comentario contiene estas palabras. Intro abre el primero.</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it in this window; right-click it to add it to the file instead.</source>
        <translation>Fractales para empezar. Un doble clic o Intro abre uno en esta ventana; en cambio, el menú del botón derecho lo añade al archivo.</translation>
    </message>
    <message>
        <source>Progress of reading the collection</source>
        <translation>Archivos leídos de la colección</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Dejar de leer</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Leyendo la colección…</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Usar</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Añadir el fractal seleccionado al archivo abierto, o abrirlo si aún no se ha editado nada.</translation>
    </message>
    <message>
        <source>&amp;Open as New Document</source>
        <translation>&amp;Abrir como documento nuevo</translation>
    </message>
    <message>
        <source>Stop reading this folder; files that were already read stay in the list</source>
        <translation>Dejar de leer esta carpeta; lo ya leído queda en la lista</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>E&amp;xplorar…</translation>
    </message>
    <message>
        <source>Show the collection over the whole window, in large pictures.</source>
        <translation>Mostrar la colección en toda la ventana, con imágenes grandes.</translation>
    </message>
    <message>
        <source>&amp;Recent Only</source>
        <translation>Solo &amp;recientes</translation>
    </message>
    <message>
        <source>Show only the fractals that you used last.</source>
        <translation>Mostrar solo los fractales usados últimamente.</translation>
    </message>
</context>
<context>
    <name>view::CollectionWindow</name>
    <message>
        <source>Collection</source>
        <translation>Colección</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it. Those with a triangle in the corner move under the pointer.</source>
        <translation>Fractales listos para usar. Un doble clic o Intro abre uno. Los que tienen un triángulo en la esquina se mueven bajo el puntero.</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Buscar en la colección</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>Muestra solo los fractales cuyo nombre, tema o comentario contiene estas palabras. Intro abre el primero.</translation>
    </message>
    <message>
        <source>Themes</source>
        <translation>Temas</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorita</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites (Ctrl+D)</source>
        <translation>Añadir el fractal seleccionado a los favoritos (Ctrl+D)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>A&amp;brir</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Añadir el fractal seleccionado al archivo abierto, o abrirlo si aún no se ha editado nada.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>Aña&amp;dir a este archivo</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Añadir el fractal elegido al archivo abierto.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoritos</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Double-click a fractal to open it.</source>
        <translation>Haga doble clic en un fractal para abrirlo.</translation>
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
        <source>a b e c d f p: one equation after the other</source>
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
        <source>a b c d e f, and cumulative weights</source>
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
        <source>Column names in order</source>
        <translation>Nombres de las columnas en su orden</translation>
    </message>
    <message>
        <source>The names of the columns in order: a b c d or r s theta phi, then e and f, each once; if there are weights, also p, or cumulative for running sums of weights. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Los nombres de las columnas en su orden: a b c d o r s theta phi, además e y f, cada uno una vez, y p para un peso o cumulative para una suma de pesos donde la haya. x′ = a·x + b·y + e e y′ = c·x + d·y + f.</translation>
    </message>
    <message>
        <source>The names of the columns in their order, such as a b c d e f p</source>
        <translation>Los nombres de las columnas en su orden, como a b c d e f p</translation>
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
        <source>Type some letters of what you want to do. The arrow keys select a command, Enter runs it.</source>
        <translation>Escriba algunas letras de lo que quiere hacer. Las teclas de flecha eligen, Intro lo ejecuta.</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Ninguna orden coincide</translation>
    </message>
    <message>
        <source>Commands whose names contain these words come first, then those whose descriptions do.</source>
        <translation>Los comandos cuyos nombres contienen estas palabras y, después, aquellos cuyas descripciones las contienen.</translation>
    </message>
    <message>
        <source>Search the guide for “%1”</source>
        <translation>Buscar «%1» en la guía</translation>
    </message>
</context>
<context>
    <name>view::CommandSynonyms</name>
    <message>
        <source>render save image picture png svg pdf jpeg tiff webp exr poster wallpaper stl obj ply glb mesh print 3d laser plotter cutter engrave dxf outline vector transparent millimetres</source>
        <translation>renderizar guardar imagen png svg pdf jpeg tiff póster cartel fondo stl obj ply malla impresión 3d láser plóter trazador cortadora grabar dxf contorno vectorial transparente milímetros</translation>
    </message>
    <message>
        <source>render video movie film mp4 webm gif apng frames cluster slurm</source>
        <translation>renderizar vídeo película mp4 webm gif apng fotogramas clúster slurm</translation>
    </message>
    <message>
        <source>flame apophysis csv table points cloud ply ifstile save</source>
        <translation>flame apophysis csv tabla puntos nube ply ifstile guardar</translation>
    </message>
    <message>
        <source>clipboard screenshot image</source>
        <translation>portapapeles captura imagen</translation>
    </message>
    <message>
        <source>paper printer pdf page</source>
        <translation>papel impresora pdf página</translation>
    </message>
    <message>
        <source>surprise chance lucky generate dice new</source>
        <translation>sorpresa azar suerte generar dado nuevo</translation>
    </message>
    <message>
        <source>mirror reflect reverse</source>
        <translation>espejo reflejar invertir</translation>
    </message>
    <message>
        <source>mirror reflect upside down</source>
        <translation>espejo reflejar invertir boca abajo</translation>
    </message>
    <message>
        <source>hull triangle tight smallest</source>
        <translation>envolvente triángulo ajustado menor</translation>
    </message>
    <message>
        <source>apply freeze write flatten</source>
        <translation>aplicar congelar escribir</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>copiar clonar</translation>
    </message>
    <message>
        <source>centre home whole zoom all</source>
        <translation>centrar inicio todo</translation>
    </message>
    <message>
        <source>maximise whole</source>
        <translation>maximizar</translation>
    </message>
    <message>
        <source>3d extrude solid</source>
        <translation>3d extruir sólido</translation>
    </message>
    <message>
        <source>settings options language theme dark light configuration motion</source>
        <translation>ajustes opciones idioma tema oscuro claro configuración movimiento</translation>
    </message>
    <message>
        <source>shortcuts keys hotkeys gestures</source>
        <translation>atajos teclas gestos</translation>
    </message>
    <message>
        <source>help manual documentation</source>
        <translation>ayuda manual documentación</translation>
    </message>
    <message>
        <source>tutorial introduction beginner learn</source>
        <translation>tutorial introducción principiante aprender</translation>
    </message>
    <message>
        <source>sway wind storm blow</source>
        <translation>mecer brisa tormenta soplar</translation>
    </message>
    <message>
        <source>turntable spin rotate camera</source>
        <translation>plataforma giratoria girar rotar cámara</translation>
    </message>
    <message>
        <source>spin rotate</source>
        <translation>girar rotar</translation>
    </message>
    <message>
        <source>pulse grow shrink</source>
        <translation>pulsar crecer encoger</translation>
    </message>
    <message>
        <source>colours rainbow</source>
        <translation>colores arcoíris</translation>
    </message>
    <message>
        <source>infinite dive</source>
        <translation>infinito sumergirse acercar</translation>
    </message>
    <message>
        <source>mutate mutation vary breed evolve grow similar</source>
        <translation>mutar mutación variar criar evolucionar parecido</translation>
    </message>
    <message>
        <source>shade silhouette drop cast ground light sun</source>
        <translation>silueta suelo luz sol proyectar</translation>
    </message>
    <message>
        <source>share send email mail post message url</source>
        <translation>compartir enviar correo email mensaje url</translation>
    </message>
    <message>
        <source>dimension proof certificate | prove certified Hausdorff area measure overlap connected</source>
        <translation>dimensión demostración certificado | demostrar Hausdorff área medida solapamiento conexo</translation>
    </message>
    <message>
        <source>reorder rearrange order sort</source>
        <translation>reordenar ordenar orden</translation>
    </message>
    <message>
        <source>gallery examples library favourites leaf tree fern snowflake dragon sponge</source>
        <translation>galería ejemplos biblioteca favoritos hoja árbol helecho copo dragón esponja</translation>
    </message>
    <message>
        <source>linked maps graph-directed which follows which forbidden</source>
        <translation>aplicaciones enlazadas grafo dirigido prohibido</translation>
    </message>
    <message>
        <source>colours palette gradient hue background transparent brightness contrast black white grey</source>
        <translation>colores paleta degradado tono fondo transparente brillo contraste blanco negro gris</translation>
    </message>
    <message>
        <source>flip mirror reflect | rotate scale shear move shift turn size resize bigger larger smaller</source>
        <translation>voltear reflejar espejo | rotar girar escalar cizallar mover tamaño más grande pequeño</translation>
    </message>
    <message>
        <source>timeline motion movie keyframes speed faster slower morph</source>
        <translation>línea de tiempo movimiento película fotogramas clave velocidad rápido lento morphing transformar</translation>
    </message>
    <message>
        <source>share send browser html embed publish interactive mail email</source>
        <translation>compartir enviar navegador html insertar publicar interactivo correo</translation>
    </message>
    <message>
        <source>worksheet class students exercise paper teacher</source>
        <translation>hoja clase alumnos ejercicio papel profesor profesora</translation>
    </message>
    <message>
        <source>undo original restore straighten start over again</source>
        <translation>original restaurar enderezar empezar de nuevo</translation>
    </message>
</context>
<context>
    <name>view::ComparePane</name>
    <message>
        <source>Entry to compare with</source>
        <translation>Entrada para comparar</translation>
    </message>
    <message>
        <source>Canvas of the entry to compare with</source>
        <translation>Lienzo de la entrada para comparar</translation>
    </message>
    <message>
        <source>There is no other entry in this file. Add or duplicate one to compare it.</source>
        <translation>Este archivo no tiene otra entrada. Añada o duplique una para compararla.</translation>
    </message>
    <message>
        <source>The entry that is shown beside the current one</source>
        <translation>La entrada que se muestra junto a la actual</translation>
    </message>
    <message>
        <source>Link Views</source>
        <translation>Enlazar las vistas</translation>
    </message>
    <message>
        <source>Pan and zoom both together, at the same position and scale</source>
        <translation>Mover y ampliar ambas a la vez, en el mismo lugar y a la misma escala</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Show the current entry alone</source>
        <translation>Mostrar solo la entrada actual</translation>
    </message>
    <message>
        <source>An entry in the plane and one in space cannot share a view</source>
        <translation>Una entrada del plano y una del espacio no tienen ninguna vista en común</translation>
    </message>
    <message>
        <source>Another entry of the file beside the current one, to compare the two.</source>
        <translation>Otra entrada del archivo junto a la actual, para comparar las dos.</translation>
    </message>
</context>
<context>
    <name>view::ConstructionBar</name>
    <message>
        <source>How the attractor is built</source>
        <translation>Cómo se construye el atractor</translation>
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
        <source>Chaos Game</source>
        <translation>Juego del caos</translation>
    </message>
    <message>
        <source>One point that jumps by maps chosen at random; the first 14 points are not plotted</source>
        <translation>Un punto que salta con aplicaciones elegidas al azar; los 14 primeros puntos no se dibujan</translation>
    </message>
    <message>
        <source>n: how many times all maps are applied</source>
        <translation>n: cuántas veces se aplican todas las aplicaciones</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Clear the points and start with new random numbers</source>
        <translation>Ningún punto todavía, y otros dados</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Plot points continuously</source>
        <translation>Hacer que aparezcan puntos</translation>
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
        <source>Stop at these points</source>
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
        <source>no points yet: press Play (▶)</source>
        <translation>aún no hay puntos: pulse Reproducir (▶)</translation>
    </message>
    <message>
        <source>How many times all maps are applied: 0 is the starting shape, and with every step the picture gets closer to the attractor. Each image has the colour of its outermost map.</source>
        <translation>Cuántas veces se aplican todas las aplicaciones: con 0 se ve la figura inicial, y con cada paso la imagen se acerca más al atractor. Cada copia tiene el color de su aplicación más externa.</translation>
    </message>
    <message>
        <source>One Jump</source>
        <translation>Un salto</translation>
    </message>
    <message>
        <source>Roll the die once and jump</source>
        <translation>Tirar el dado una vez y saltar</translation>
    </message>
    <message>
        <source>Jumps per second</source>
        <translation>Saltos por segundo</translation>
    </message>
    <message>
        <source>How many jumps the chaos game makes per second. At up to ten per second, the die shows each map that is rolled.</source>
        <translation>Cuántos saltos da el juego del caos por segundo. Hasta diez por segundo, el dado muestra cada aplicación que sale.</translation>
    </message>
    <message>
        <source>W%1: the start</source>
        <translation>W%1: la figura inicial</translation>
    </message>
    <message>
        <source>W%1: %2 copies</source>
        <translation>W%1: %2 copias</translation>
    </message>
    <message>
        <source>The Hausdorff distance from the picture to the attractor A, and its upper bound</source>
        <translation>La distancia de Hausdorff de la imagen al atractor A, y lo que no puede superar</translation>
    </message>
    <message>
        <source>The Hausdorff distance from Wⁿ(B) to the attractor A, measured on cells of side %1. It is at most sⁿ times the distance from the start B to A, where s = %2 is the largest contraction factor of the maps.</source>
        <translation>La distancia de Hausdorff de Wⁿ(B) al atractor A, medida en celdas de lado %1. Es como mucho sⁿ veces la distancia de la figura inicial B a A, donde s = %2 es el mayor factor de contracción de las aplicaciones.</translation>
    </message>
    <message>
        <source>no bound: a map has the contraction factor %1</source>
        <translation>sin cota: una aplicación tiene el factor de contracción %1</translation>
    </message>
    <message>
        <source>distance to A at most %1</source>
        <translation>distancia a A: como mucho %1</translation>
    </message>
    <message>
        <source>distance to A &lt; %1, at most %2</source>
        <translation>distancia a A &lt; %1, como mucho %2</translation>
    </message>
    <message>
        <source>distance to A ≈ %1, at most %2</source>
        <translation>distancia a A ≈ %1, como mucho %2</translation>
    </message>
    <message>
        <source>jump %1 of the %2 that are not plotted</source>
        <translation>salto %1 de los %2 que no se dibujan</translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>jumps per second</comment>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Step by Step</source>
        <translation>Paso a paso</translation>
    </message>
    <message>
        <source>All maps at once, applied n times to the cage or another shape (Wⁿ)</source>
        <translation>Todas las aplicaciones a la vez, n veces sobre la jaula u otra figura (Wⁿ)</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three corners. The picture stays where it is; Esc cancels.</source>
        <translation>Haga clic en el primero de los tres vértices. La imagen queda donde está; Esc cancela.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Haga clic en el segundo vértice. Retroceso borra el último punto.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Haga clic en el tercer vértice. Retroceso borra el último punto.</translation>
    </message>
</context>
<context>
    <name>view::Die</name>
    <message>
        <source>Die</source>
        <translation>Dado</translation>
    </message>
    <message>
        <source>The die of the chaos game. It has a face for each map, as wide as the probability of the map. The face that was rolled is shown in the colour of its map, and so is the point that the map leads to. At more than ten jumps per second, the die rolls too fast to be read.</source>
        <translation>El dado del juego del caos. Tiene una cara por aplicación, tan ancha como la probabilidad de esta. La cara que ha salido se muestra en el color de su aplicación, igual que el punto al que esta ha llevado. Con más de diez saltos por segundo rueda demasiado rápido para leerlo.</translation>
    </message>
    <message>
        <source>Each map has a face, as wide as its probability.</source>
        <translation>Cada aplicación tiene una cara, tan ancha como su probabilidad.</translation>
    </message>
    <message>
        <source>Map %1 was rolled; its probability is %2.</source>
        <translation>Ha salido la aplicación %1, cuya probabilidad es %2.</translation>
    </message>
</context>
<context>
    <name>view::EaseDialog</name>
    <message>
        <source>Custom Ease</source>
        <translation>Transición propia</translation>
    </message>
    <message>
        <source>Curve: time to the right, progress upwards</source>
        <translation>Curva: el tiempo a la derecha, el camino hacia arriba</translation>
    </message>
    <message>
        <source>How the motion to the next key progresses over time. Drag the two handles.</source>
        <translation>Cómo se recorre con el tiempo el camino hasta la clave siguiente. Arrastre los dos tiradores.</translation>
    </message>
    <message>
        <source>Time of the first handle</source>
        <translation>Tiempo del primer tirador</translation>
    </message>
    <message>
        <source>Progress of the first handle</source>
        <translation>Camino del primer tirador</translation>
    </message>
    <message>
        <source>Time of the second handle</source>
        <translation>Tiempo del segundo tirador</translation>
    </message>
    <message>
        <source>Progress of the second handle</source>
        <translation>Camino del segundo tirador</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>First handle:</source>
        <translation>Primer tirador:</translation>
    </message>
    <message>
        <source>Second handle:</source>
        <translation>Segundo tirador:</translation>
    </message>
    <message>
        <source>A number from 0 to 1. A curve that would be too steep is flattened.</source>
        <translation>Una fracción de 0 a 1. Una curva demasiado empinada se aplana.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Comentario de «%1»</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
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
        <source>Written on separate lines below the name, each after a semicolon.</source>
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
        <source>&amp;Title:</source>
        <translation>&amp;Título:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Líneas de comentario:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines store the cage and the colours.</source>
        <translation>Un comentario no puede empezar por «barycage:»; esas líneas guardan la jaula y los colores.</translation>
    </message>
    <message>
        <source>A line can have at most %1 bytes; Fractint truncates longer ones. Split it in two.</source>
        <translation>Una línea contiene a lo sumo %1 bytes; Fractint corta las más largas. Pártala en dos.</translation>
    </message>
    <message>
        <source>Comments are stored with the entry in the file and do not change the fractal.</source>
        <translation>Los comentarios se guardan con la entrada en el archivo y no cambian el fractal.</translation>
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
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Cambiar el nombre «%1» por «%2»</translation>
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
    <message>
        <source>%1 in space</source>
        <translation>%1 en el espacio</translation>
    </message>
    <message>
        <source>%1, placed</source>
        <translation>%1, colocado</translation>
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
        <source>This file contains no entries. Add one, or paste the text of an .ifs file.</source>
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
        <source>Paste entries from .ifs text after the current entry.</source>
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
        <source>An entry that could not be read cannot be duplicated: the copy would have the same name.</source>
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
        <source>The pasted text contains no entry of an .ifs file.</source>
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
        <source>%n pasted entries could not be read; their text is kept unchanged.</source>
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
        <source>No entry name contains “%1”.</source>
        <translation>Ninguna entrada tiene «%1» en su nombre.</translation>
    </message>
    <message>
        <source>Shows only the entries whose names contain these letters.</source>
        <translation>Muestra solo las entradas cuyo nombre contiene estas letras.</translation>
    </message>
    <message>
        <source>The fractals in the file. Click one to edit it, drag it to move it, press F2 to rename it.</source>
        <translation>Los fractales del archivo. Haga clic en uno para editarlo, arrástrelo a otro lugar, pulse F2 para darle otro nombre.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>No se pegó nada: no hay texto en el portapapeles.</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Leyendo lo pegado…</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Añadiendo entradas…</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>Move the selected entries to the clipboard.</source>
        <translation>Mueve al portapapeles las entradas seleccionadas.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Cortar %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n entries</source>
        <translation>
            <numerusform>Cortar %n entrada</numerusform>
            <numerusform>Cortar %n entradas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Exportar los datos de «%1»</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Lo que contendrá el archivo</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>Copiar &amp;texto</translation>
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
        <source>Flip &amp;y so that the flame is the right way up</source>
        <translation>&amp;Invertir y para que el flame no salga cabeza abajo</translation>
    </message>
    <message>
        <source>&amp;Bake the placement so that the maps draw the picture as shown</source>
        <translation>Incor&amp;porar la colocación para que las aplicaciones dibujen lo que se muestra</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formato:</translation>
    </message>
    <message>
        <source>C&amp;olumns:</source>
        <translation>&amp;Columnas:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>Pu&amp;ntos:</translation>
    </message>
    <message>
        <source>The points of the chaos game as shown, without the first 14.</source>
        <translation>Los puntos del juego del caos donde se muestran, sin los 14 primeros.</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Exportar datos</translation>
    </message>
    <message>
        <source>The text was copied to the clipboard.</source>
        <translation>El texto está en el portapapeles.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>El principio del archivo tal como se escribirá.</translation>
    </message>
    <message>
        <source>The program that will read the data; each format contains what that program understands.</source>
        <translation>Para qué programa son los datos: cada formato contiene lo que lee ese programa.</translation>
    </message>
    <message>
        <source>The order of the coefficients in each row; programs differ.</source>
        <translation>El orden de los coeficientes en cada fila; otros programas esperan otros órdenes.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Cuántos puntos del juego del caos se escriben.</translation>
    </message>
    <message>
        <source>In flame programs, y points down. With this option, the flame looks as it does here; without it, the numbers stay the same.</source>
        <translation>En los programas de flames, y crece hacia abajo. Con esto, el flame se ve como aquí el fractal; sin esto, los números son los mismos.</translation>
    </message>
    <message>
        <source>With this option, the cage becomes part of the maps. Without it, the maps are written as they are in the table.</source>
        <translation>Con esto, la jaula pasa a formar parte de las aplicaciones. Sin esto, las aplicaciones se escriben como están en la tabla.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Pide el nombre del archivo y lo escribe.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Copia todo el texto al portapapeles en vez de escribir un archivo.</translation>
    </message>
    <message>
        <source>This format can store only systems in the plane.</source>
        <translation>Este formato solo puede guardar sistemas del plano.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exportar «%1»</translation>
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
        <source>Include the ca&amp;ge</source>
        <translation>In&amp;cluir la jaula</translation>
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
        <source>Quality</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>Cells along each side of a pixel</source>
        <translation>Celdas a lo largo del lado de un píxel</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 bits por canal</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
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
        <source>S&amp;upersampling:</source>
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
        <source>&amp;Automatic depth</source>
        <translation>Profundidad &amp;automática</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Niveles de copias</translation>
    </message>
    <message>
        <source>Description of the picture</source>
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
        <source>Only systems in the plane can be exported as a picture.</source>
        <translation>Solo los sistemas del plano se pueden exportar como imagen.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>unos %1</translation>
    </message>
    <message>
        <source>One dot for every visible point of the chaos game.</source>
        <translation>Una marca por cada punto del juego del caos que está a la vista.</translation>
    </message>
    <message>
        <source>Guaranteed accuracy: %1.</source>
        <translation>Exactitud garantizada: %1.</translation>
    </message>
    <message>
        <source>The shape itself measures %1 × %2.</source>
        <translation>La figura misma mide %1 × %2.</translation>
    </message>
    <message>
        <source>Shades of density need pixels: the shapes have one colour.</source>
        <translation>Los tonos de la densidad necesitan píxeles: las formas tienen un solo color.</translation>
    </message>
    <message>
        <source>The cage bends the picture, which copies cannot reproduce: the affine fit of the cage is written instead. A PNG shows the bend.</source>
        <translation>La jaula curva la imagen, y las copias no pueden seguirla: se escribe el ajuste afín de la jaula. Un PNG sí muestra la curvatura.</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>The picture has no background and can be placed over another.</source>
        <translation>La imagen no tiene fondo y se puede poner encima de otra.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Dibuja la jaula encima de la imagen.</translation>
    </message>
    <message>
        <source>The number of points drawn for each pixel: more points make a smoother picture and take longer.</source>
        <translation>Cuántos puntos se dibujan por cada píxel: con más, la imagen es más suave y tarda más.</translation>
    </message>
    <message>
        <source>The number of smaller cells along each side of a pixel: more cells make smoother edges, at the cost of memory and time.</source>
        <translation>Cada píxel se dibuja a partir de ese número de píxeles más finos por lado: bordes más suaves, a cambio de más memoria y tiempo.</translation>
    </message>
    <message>
        <source>16 bits keep fine gradations for later editing; 8 bits are enough for viewing.</source>
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
        <source>The number of levels of copies. More levels hardly enlarge the file, but the picture takes longer to draw.</source>
        <translation>Cuántos niveles de copias tiene la imagen. El archivo apenas crece con ello; el tiempo de dibujo, sí.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file. You can keep working in the meantime.</source>
        <translation>Pide el nombre del archivo y lo escribe. Entretanto se puede usar la ventana.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Copiando la imagen…</translation>
    </message>
    <message>
        <source>Makes the copies smaller until they cannot be distinguished from the attractor at this pixel size, or until programs would take long to draw them.</source>
        <translation>Se hacen copias cada vez más pequeñas hasta que ningún píxel de este tamaño pueda notar la diferencia, o hasta que los programas tarden mucho en dibujarlas.</translation>
    </message>
    <message>
        <source>More levels would be more accurate, but programs would take long to draw them.</source>
        <translation>Con más niveles sería más preciso, pero los programas tardarían mucho en dibujarlo.</translation>
    </message>
    <message>
        <source>Computing the shapes…</source>
        <translation>Calculando las formas…</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vista del lienzo</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>El atractor completo</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Encuadre</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>E&amp;ncuadre:</translation>
    </message>
    <message>
        <source>SVG and PDF are made of shapes, which stay sharp at every size; the others are made of pixels. If the file name has the ending of another format, that format is written.</source>
        <translation>SVG y PDF están hechos de formas, que se ven nítidas a cualquier tamaño; los demás, de píxeles. Si el nombre del archivo tiene la terminación de otro formato, se escribe ese formato.</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format: it must end with .png, .jpg, .webp, .tiff, .exr, .svg or .pdf.</source>
        <translation>El nombre «%1» no indica el formato: debe terminar en .png, .jpg, .webp, .tiff, .exr, .svg o .pdf.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the picture to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Pide un nombre de archivo y dibuja la imagen cuando le toca, después de las que esperan en el panel Exportaciones. La cola continúa tras reiniciar.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>La vista «%1»</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Lo que muestra la imagen: lo que muestra el lienzo, o el atractor con un pequeño margen, mire donde mire el lienzo. Las vistas guardadas también están en la lista.</translation>
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
        <translation>Precisión garantizada: %2. Copias que dibujan los programas que abren el archivo: %1 (el límite es %3).</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Borrador: 25 puntos por píxel</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Buena: 100 puntos por píxel</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Fina: 400 puntos por píxel</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Finísima: 2000 puntos por píxel</translation>
    </message>
</context>
<context>
    <name>view::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>What the file will show</source>
        <translation>Lo que mostrará el archivo</translation>
    </message>
    <message>
        <source>The picture as it will be exported: its proportions and the section it shows. A chequerboard marks transparent parts. The preview follows every field.</source>
        <translation>La imagen tal como se exportará: su forma y la sección que muestra. Donde es transparente se ve un damero. Sigue todos los campos.</translation>
    </message>
    <message>
        <source>Drawing the preview…</source>
        <translation>Dibujando la vista previa…</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Sin vista previa</translation>
    </message>
</context>
<context>
    <name>view::ExportProgress</name>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>Queda cerca de %n segundo.</numerusform>
            <numerusform>Quedan unos %n segundos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n minute(s) left.</source>
        <translation>
            <numerusform>Queda cerca de %n minuto.</numerusform>
            <numerusform>Quedan unos %n minutos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n hour(s) left.</source>
        <translation>
            <numerusform>Queda cerca de %n hora.</numerusform>
            <numerusform>Quedan unas %n horas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progreso de la exportación</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Tiempo restante</translation>
    </message>
</context>
<context>
    <name>view::ExportQueue</name>
    <message>
        <source>Barycage ended unexpectedly twice while drawing this picture. Try it again alone, or export a smaller one.</source>
        <translation>El programa ha terminado dos veces mientras dibujaba esta imagen. Vuelva a intentarlo con ella sola o exporte una más pequeña.</translation>
    </message>
    <message>
        <source>The export queue cannot be saved for the next session: its folder is not writable, or the disk is full.</source>
        <translation>La cola de exportaciones no se puede conservar para el próximo inicio: no se puede escribir en su carpeta o el disco está lleno.</translation>
    </message>
</context>
<context>
    <name>view::ExportShell</name>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Add to Queue…</source>
        <translation>Añadir a la cola…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Ce&amp;rrar</translation>
    </message>
    <message>
        <source>Export stopped; nothing was written.</source>
        <translation>La exportación se detuvo; no se escribió nada.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Escrito en %1.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Muestra la carpeta del archivo escrito en el gestor de archivos.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Archivos %1 (*.%2)</translation>
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
        <source>Same as on the screen</source>
        <translation>Como en la pantalla</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × la pantalla</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Mantener la proporción</translation>
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
        <source>A length in the selected unit. The other side follows as long as the proportions are locked.</source>
        <translation>Una longitud en la unidad elegida al lado. El otro lado la sigue mientras se mantenga la proporción.</translation>
    </message>
    <message>
        <source>Pixels, or a length on paper at the given resolution.</source>
        <translation>En píxeles, o en papel con la resolución indicada.</translation>
    </message>
    <message>
        <source>The number of pixels per inch of paper: 300 is usual for print.</source>
        <translation>Cuántos píxeles caben en una pulgada de papel: lo habitual en la imprenta es 300.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Tamaño con nombre</translation>
    </message>
    <message>
        <source>The size of the picture on the screen or a multiple of it, of a common screen, or of a sheet of paper. Everything that the window shows stays in the picture; if the proportions differ, the picture shows more around it.</source>
        <translation>El tamaño de la imagen en la pantalla o un múltiplo de él, el de una pantalla habitual o el de una hoja de papel. Todo lo que muestra la ventana queda en la imagen; si la forma es distinta, se ve más alrededor.</translation>
    </message>
    <message>
        <source>Keep the proportions of the picture</source>
        <translation>Mantener las proporciones de la imagen</translation>
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
        <translation>Cuadrado: 2048 × 2048</translation>
    </message>
    <message>
        <source>A4 at 300 dpi</source>
        <translation>A4 a 300 ppp</translation>
    </message>
    <message>
        <source>A3 at 300 dpi</source>
        <translation>A3 a 300 ppp</translation>
    </message>
    <message>
        <source>The size of the picture, in pixels or on paper.</source>
        <translation>El tamaño de la imagen, en píxeles o en papel.</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Vertical u horizontal</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Intercambiar anchura y altura</translation>
    </message>
</context>
<context>
    <name>view::ExportsModel</name>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>falta aproximadamente %n segundo</numerusform>
            <numerusform>faltan aproximadamente %n segundos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n minute(s) left</source>
        <translation>
            <numerusform>falta aproximadamente %n minuto</numerusform>
            <numerusform>faltan aproximadamente %n minutos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n hour(s) left</source>
        <translation>
            <numerusform>falta aproximadamente %n hora</numerusform>
            <numerusform>faltan aproximadamente %n horas</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En espera</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminada</translation>
    </message>
    <message>
        <source>Paused at %1 %</source>
        <translation>En pausa al %1 %</translation>
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
        <translation>Exportaciones</translation>
    </message>
    <message>
        <source>Queue of exports</source>
        <translation>Cola de exportaciones</translation>
    </message>
    <message>
        <source>The exports, drawn from top to bottom.</source>
        <translation>Las exportaciones, dibujadas de arriba abajo.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>&amp;Subir</translation>
    </message>
    <message>
        <source>Draw the selected export earlier.</source>
        <translation>Dibujar antes la exportación seleccionada.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>&amp;Bajar</translation>
    </message>
    <message>
        <source>Draw the selected export later.</source>
        <translation>Dibujar después la exportación seleccionada.</translation>
    </message>
    <message>
        <source>&amp;Try Again</source>
        <translation>Rein&amp;tentar</translation>
    </message>
    <message>
        <source>Try again to draw the selected exports that failed.</source>
        <translation>Volver a dibujar las exportaciones seleccionadas que fallaron.</translation>
    </message>
    <message>
        <source>Show the folder of the selected export in the file manager.</source>
        <translation>Mostrar la carpeta de la exportación seleccionada en el gestor de archivos.</translation>
    </message>
    <message>
        <source>&amp;Cancel Export</source>
        <translation>Ca&amp;ncelar la exportación</translation>
    </message>
    <message>
        <source>Clear &amp;Finished</source>
        <translation>Quitar las &amp;terminadas</translation>
    </message>
    <message>
        <source>Remove all finished exports from the list; their files are kept.</source>
        <translation>Quitar de la lista todas las exportaciones terminadas; sus archivos se conservan.</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Reanudar</translation>
    </message>
    <message>
        <source>The exports that you have added to the queue. They are drawn one after another, from top to bottom, while you continue editing. Exports that are not finished when you quit continue the next time you start Barycage.</source>
        <translation>Las exportaciones que ha añadido a la cola. Se dibujan una tras otra, de arriba abajo, mientras sigue editando. Las que no hayan terminado al salir continúan la próxima vez que inicie Barycage.</translation>
    </message>
    <message>
        <source>Pause or resume all exports without losing progress.</source>
        <translation>Pone en pausa o reanuda todas las exportaciones sin perder lo ya dibujado.</translation>
    </message>
    <message>
        <source>Cancel the selected exports and remove them from the list; files already written are kept.</source>
        <translation>Cancelar las exportaciones seleccionadas y quitarlas de la lista; los archivos ya escritos se conservan.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>No exports are waiting. Choose Add to Queue in File › Export › Export Picture… to draw pictures one after another while you continue editing.</source>
        <translation>No hay exportaciones en espera. Elija Añadir a la cola en Archivo › Exportar › Exportar imagen… para dibujar imágenes una tras otra mientras sigue editando.</translation>
    </message>
</context>
<context>
    <name>view::FamilySliders</name>
    <message>
        <source>Parameter %1 of the family</source>
        <translation>Parámetro %1 de la familia</translation>
    </message>
    <message>
        <source>Change Family</source>
        <translation>Cambiar la familia</translation>
    </message>
</context>
<context>
    <name>view::FitBox</name>
    <message>
        <source>Best of 2 to 8</source>
        <translation>La mejor de 2 a 8</translation>
    </message>
    <message>
        <source>How many maps a suggestion has; in a range, a map is added only if it improves the fit enough</source>
        <translation>Cuántas aplicaciones tiene una sugerencia; en un rango, cada una debe compensar</translation>
    </message>
    <message>
        <source>Number of maps</source>
        <translation>Número de aplicaciones</translation>
    </message>
    <message>
        <source>Maps:</source>
        <translation>Aplicaciones:</translation>
    </message>
    <message>
        <source>Seconds to search</source>
        <translation>Segundos de búsqueda</translation>
    </message>
    <message>
        <source>How long to search for suggestions</source>
        <translation>Cuánto tiempo buscar sugerencias</translation>
    </message>
    <message>
        <source>Seconds:</source>
        <translation>Segundos:</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Semilla de los números aleatorios</translation>
    </message>
    <message>
        <source>Another seed gives another search</source>
        <translation>Otra semilla busca en otros lugares</translation>
    </message>
    <message>
        <source>Seed:</source>
        <translation>Semilla:</translation>
    </message>
    <message>
        <source>Similarities only</source>
        <translation>Solo semejanzas</translation>
    </message>
    <message>
        <source>Only maps that keep all angles</source>
        <translation>Solo aplicaciones que conservan todos los ángulos</translation>
    </message>
    <message>
        <source>No mirror images</source>
        <translation>Sin imágenes especulares</translation>
    </message>
    <message>
        <source>Only maps without reflection</source>
        <translation>Solo aplicaciones que no reflejan</translation>
    </message>
    <message>
        <source>First map a stem</source>
        <translation>Primera aplicación, un tallo</translation>
    </message>
    <message>
        <source>The first map flattens the shape to a line, like the stem of a fern</source>
        <translation>La primera aplicación aplana la forma en una línea, como el tallo de un helecho</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Cualquiera</translation>
    </message>
    <message>
        <source>Multiples of %1°</source>
        <translation>Múltiplos de %1°</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Ángulos</translation>
    </message>
    <message>
        <source>The angles by which the maps may rotate</source>
        <translation>Qué ángulos pueden girar las aplicaciones</translation>
    </message>
    <message>
        <source>Angles:</source>
        <translation>Ángulos:</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Sugerir</translation>
    </message>
    <message>
        <source>Find systems whose attractor looks like the target</source>
        <translation>Buscar sistemas cuyo atractor se parezca al objetivo</translation>
    </message>
    <message>
        <source>Add a Map</source>
        <translation>Añadir una aplicación</translation>
    </message>
    <message>
        <source>Add a map where the agreement is worst</source>
        <translation>Añadir una aplicación donde la concordancia es peor</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Afinar las aplicaciones</translation>
    </message>
    <message>
        <source>Move the maps so that their images of the target cover it better</source>
        <translation>Mover las aplicaciones para que sus imágenes del objetivo lo cubran mejor</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Afinar el atractor</translation>
    </message>
    <message>
        <source>Move the maps so that the attractor itself comes closer to the target</source>
        <translation>Mover las aplicaciones para que el propio atractor se acerque al objetivo</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Ajustar los pesos</translation>
    </message>
    <message>
        <source>Find the weights that reproduce the shades of the picture</source>
        <translation>Buscar los pesos que reproducen los tonos de la imagen</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Ajustar la jaula</translation>
    </message>
    <message>
        <source>Deform the attractor by a cage so that its outline follows that of the target</source>
        <translation>Deformar el atractor con una jaula para que su contorno siga el del objetivo</translation>
    </message>
    <message>
        <source>Refine selected maps only</source>
        <translation>Afinar solo las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>The maps that are not selected stay as they are</source>
        <translation>Las aplicaciones no seleccionadas quedan como están</translation>
    </message>
    <message>
        <source>Locked maps stay as they are while others are refined</source>
        <translation>Las aplicaciones bloqueadas quedan como están mientras se afinan las demás</translation>
    </message>
    <message>
        <source>Corners of the cage</source>
        <translation>Esquinas de la jaula</translation>
    </message>
    <message>
        <source>How many corners the fitted cage has</source>
        <translation>Cuántas esquinas tiene la jaula ajustada</translation>
    </message>
    <message>
        <source>Corners of the cage:</source>
        <translation>Esquinas de la jaula:</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Lock Selected Maps</source>
        <translation>Bloquear las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>Bloqueadas: %1</translation>
    </message>
    <message>
        <source>Stop without changing anything</source>
        <translation>Detener sin cambiar nada</translation>
    </message>
</context>
<context>
    <name>view::FourViews</name>
    <message>
        <source>Top</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>De frente</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Desde la derecha</translation>
    </message>
</context>
<context>
    <name>view::FrameSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>The width of the frames in pixels.</source>
        <translation>La anchura de los fotogramas en píxeles.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>The height of the frames in pixels.</source>
        <translation>La altura de los fotogramas en píxeles.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Tamaño con nombre</translation>
    </message>
    <message>
        <source>Usual sizes of videos.</source>
        <translation>Tamaños habituales de vídeos.</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Mantener la proporción</translation>
    </message>
    <message>
        <source>Keep the proportions of the frames</source>
        <translation>Mantener la proporción de los fotogramas</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Vertical u horizontal</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Intercambiar anchura y altura</translation>
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
        <translation>Cuadrado: 1080 × 1080</translation>
    </message>
    <message>
        <source>Portrait: 1080 × 1920</source>
        <translation>Vertical: 1080 × 1920</translation>
    </message>
    <message>
        <source>For a message: 640 × 360</source>
        <translation>Para un mensaje: 640 × 360</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
</context>
<context>
    <name>view::GoToDialog</name>
    <message>
        <source>Centre, x</source>
        <translation>Centro, x</translation>
    </message>
    <message>
        <source>The x coordinate in the middle of the view.</source>
        <translation>La coordenada x en el centro de la vista.</translation>
    </message>
    <message>
        <source>Centre, y</source>
        <translation>Centro, y</translation>
    </message>
    <message>
        <source>The y coordinate in the middle of the view.</source>
        <translation>La coordenada y en el centro de la vista.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>How much of the plane is seen, from the lower edge to the upper one.</source>
        <translation>Cuánto del plano se ve, del borde inferior al superior.</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Ir a</translation>
    </message>
    <message>
        <source>such as 3 2 1</source>
        <translation>por ejemplo 3 2 1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Numbers of maps, as the status bar shows them for the point under the pointer. They repeat, and the centre becomes the point that they lead to.</source>
        <translation>Números de aplicaciones, tal como los muestra la barra de estado para el punto bajo el puntero. Se repiten, y el centro pasa a ser el punto al que llevan.</translation>
    </message>
    <message>
        <source>Choose a map</source>
        <translation>Elija una aplicación</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Punto fijo</translation>
    </message>
    <message>
        <source>The centre becomes the point that this map leaves where it is.</source>
        <translation>El centro pasa a ser el punto que esta aplicación deja en su sitio.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>&amp;Centre:</source>
        <translation>&amp;Centro:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Altura:</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Dirección:</translation>
    </message>
    <message>
        <source>&amp;Fixed point of:</source>
        <translation>&amp;Punto fijo de:</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Ir</translation>
    </message>
    <message>
        <source>Shows this part of the plane. The fractal stays as it is.</source>
        <translation>Muestra esta parte del plano. El fractal queda como está.</translation>
    </message>
    <message>
        <source>No point has this address: a map in it is switched off, or does not contract.</source>
        <translation>Ningún punto tiene esta dirección: una de sus aplicaciones está desactivada o no contrae.</translation>
    </message>
    <message>
        <source>An address has the numbers of maps, from 1 to %1.</source>
        <translation>Una dirección consta de números de aplicaciones, de 1 a %1.</translation>
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
        <source>Stop Colour</source>
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
        <source>Add a stop after the selected one</source>
        <translation>Añadir una parada después de la elegida</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Eliminar parada</translation>
    </message>
    <message>
        <source>Delete the selected stop</source>
        <translation>Eliminar la parada elegida</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Reverse the order of the colours</source>
        <translation>Dar la vuelta a la paleta</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Distribuir</translation>
    </message>
    <message>
        <source>Space the stops evenly</source>
        <translation>Poner las paradas a distancias iguales</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Cargar…</translation>
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
        <source>The palettes in the file. Select one.</source>
        <translation>Las paletas que contiene el archivo. Elija una.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
    <message>
        <source>Take the palette from a picture</source>
        <translation>Tomar la paleta de una imagen</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ggr, .ugr or .map file, or take it from a picture</source>
        <translation>Cargar una paleta de un archivo .gpl, .ggr, .ugr o .map, o tomarla de una imagen</translation>
    </message>
    <message>
        <source>Palettes and pictures (%1);;All files (*)</source>
        <translation>Paletas e imágenes (%1);;Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Paradas del degradado</translation>
    </message>
    <message>
        <source>Double-click: add a stop, or change the colour of one. Drag: move. Del: delete.
Keys: Page Up and Page Down select a stop, the arrow keys move it, Ins adds one, Enter opens its colour.</source>
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
    <name>view::HandoutDialog</name>
    <message>
        <source>&amp;Cage and maps</source>
        <translation>&amp;Jaula y aplicaciones</translation>
    </message>
    <message>
        <source>&amp;Formulas</source>
        <translation>&amp;Fórmulas</translation>
    </message>
    <message>
        <source>&amp;Line for name and date</source>
        <translation>&amp;Línea para nombre y fecha</translation>
    </message>
    <message>
        <source>Print a Handout</source>
        <translation>Imprimir una hoja para clase</translation>
    </message>
    <message>
        <source>Pre&amp;view…</source>
        <translation>&amp;Vista previa…</translation>
    </message>
    <message>
        <source>Show the pages before they are printed</source>
        <translation>Mostrar las páginas antes de imprimirlas</translation>
    </message>
    <message>
        <source>&amp;Entries:</source>
        <translation>&amp;Entradas:</translation>
    </message>
    <message>
        <source>Entries to print</source>
        <translation>Entradas que se imprimen</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Todas</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguna</translation>
    </message>
    <message>
        <source>Print all entries of the list</source>
        <translation>Imprimir todas las entradas de la lista</translation>
    </message>
    <message>
        <source>Remove all ticks</source>
        <translation>Quitar todas las marcas</translation>
    </message>
    <message>
        <source>Handout with pictures</source>
        <translation>Hoja con imágenes</translation>
    </message>
    <message>
        <source>Blank worksheet</source>
        <translation>Hoja de ejercicios en blanco</translation>
    </message>
    <message>
        <source>Kind of sheet</source>
        <translation>Tipo de hoja</translation>
    </message>
    <message>
        <source>Entries per page</source>
        <translation>Entradas por página</translation>
    </message>
    <message>
        <source>How many entries are printed on one page.</source>
        <translation>Cuántas entradas se imprimen en una página.</translation>
    </message>
    <message>
        <source>Draw the cage and its numbered images over the picture</source>
        <translation>Dibujar la jaula y sus imágenes numeradas sobre la imagen</translation>
    </message>
    <message>
        <source>Print the formula and the probability of each map</source>
        <translation>Imprimir la fórmula y la probabilidad de cada aplicación</translation>
    </message>
    <message>
        <source>Leave lines at the top of each page for a name and a date</source>
        <translation>Dejar líneas arriba en cada página para nombre y fecha</translation>
    </message>
    <message>
        <source>&amp;Sheet:</source>
        <translation>&amp;Hoja:</translation>
    </message>
    <message>
        <source>Entries per &amp;page:</source>
        <translation>Entradas por &amp;página:</translation>
    </message>
    <message>
        <source>Choose at most %1 entries</source>
        <translation>Elija como mucho %1 entradas</translation>
    </message>
    <message>
        <source>Choose an entry first</source>
        <translation>Elija antes una entrada</translation>
    </message>
    <message>
        <source>%1-handout.pdf</source>
        <comment>name of a file</comment>
        <translation>%1-hoja-para-clase.pdf</translation>
    </message>
    <message>
        <source>Prints entries of the file for a class: with pictures and formulas, or as blank worksheets.</source>
        <translation>Imprime entradas del archivo para una clase: con imágenes y fórmulas, o como hojas de trabajo en blanco.</translation>
    </message>
    <message>
        <source>The entries of the file that could be read. Ticked entries are printed in this order, up to %1 of them.</source>
        <translation>Las entradas del archivo que se han podido leer. Se imprimen las marcadas, en este orden, como mucho %1.</translation>
    </message>
    <message>
        <source>A handout has the picture of each entry, with its cage, its maps and their formulas. A blank worksheet has the cage, in the plane on a grid, and an empty table, to be filled in by hand.</source>
        <translation>Una hoja para clase muestra la imagen de cada entrada con su jaula, sus aplicaciones y las fórmulas de estas. Una hoja de ejercicios en blanco muestra la jaula, en el plano sobre una cuadrícula, y una tabla vacía para rellenar a mano.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
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
        <source>Select a step to go back or forward to it.</source>
        <translation>Elija un paso para volver a él o para avanzar hasta él.</translation>
    </message>
    <message>
        <source>Select a step to go back or forward to it. The disk marks the saved state.</source>
        <translation>Elija un paso para volver a él o para avanzar hasta él. El disco señala lo que está guardado.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Como se abrió</translation>
    </message>
</context>
<context>
    <name>view::LessonCard</name>
    <message>
        <source>&amp;Back</source>
        <translation>At&amp;rás</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>Ter&amp;minar</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Texto del paso</translation>
    </message>
    <message>
        <source>Show the previous step (Page Up)</source>
        <translation>Mostrar el paso anterior (Re Pág)</translation>
    </message>
    <message>
        <source>Show the next step (Page Down)</source>
        <translation>Mostrar el paso siguiente (Av Pág)</translation>
    </message>
    <message>
        <source>End the lesson and return to the window as it was (Esc)</source>
        <translation>Terminar la lección y volver a la ventana como estaba (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
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
        <source>A lesson in progress: the text of the current step, and buttons to go to the others.</source>
        <translation>Una lección en curso: el texto del paso actual y botones para ir a los demás.</translation>
    </message>
</context>
<context>
    <name>view::LessonNotebook</name>
    <message>
        <source>Rename lesson</source>
        <translation>Cambiar el título de la lección</translation>
    </message>
    <message>
        <source>Add step</source>
        <translation>Añadir un paso</translation>
    </message>
    <message>
        <source>Update step</source>
        <translation>Actualizar el paso</translation>
    </message>
    <message>
        <source>Rename step</source>
        <translation>Cambiar el título del paso</translation>
    </message>
    <message>
        <source>Edit text</source>
        <translation>Editar el texto</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>Quitar el paso</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Mover el paso</translation>
    </message>
</context>
<context>
    <name>view::LessonPanel</name>
    <message>
        <source>Arrange the window as you want to show it, and press Add Step. Then write the text of the step.</source>
        <translation>Disponga la ventana como debe verla la clase y pulse «Añadir un paso». Escriba después lo que quiera decir.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>Guardar la l&amp;ección…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>Add Step</source>
        <translation>Añadir un paso</translation>
    </message>
    <message>
        <source>Add a step with the current state of the window</source>
        <translation>Añadir un paso con el estado actual de la ventana</translation>
    </message>
    <message>
        <source>Update Step</source>
        <translation>Actualizar el paso</translation>
    </message>
    <message>
        <source>Replace the state of the selected step by the current state of the window</source>
        <translation>Dar al paso elegido el estado actual de la ventana</translation>
    </message>
    <message>
        <source>Show Step</source>
        <translation>Mostrar el paso</translation>
    </message>
    <message>
        <source>Restore the window to the state of the selected step</source>
        <translation>Poner la ventana en el estado del paso elegido</translation>
    </message>
    <message>
        <source>Remove Step</source>
        <translation>Quitar el paso</translation>
    </message>
    <message>
        <source>Remove the selected step</source>
        <translation>Quitar el paso elegido</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Show the selected step earlier</source>
        <translation>Mostrar antes el paso elegido</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Show the selected step later</source>
        <translation>Mostrar después el paso elegido</translation>
    </message>
    <message>
        <source>Undo in the Lesson</source>
        <translation>Deshacer en la lección</translation>
    </message>
    <message>
        <source>Undo the last change of the lesson</source>
        <translation>Deshacer el último cambio de la lección</translation>
    </message>
    <message>
        <source>Redo in the Lesson</source>
        <translation>Rehacer en la lección</translation>
    </message>
    <message>
        <source>Redo the change of the lesson</source>
        <translation>Rehacer el cambio de la lección</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Título de la lección</translation>
    </message>
    <message>
        <source>Shown above every step while the lesson is played</source>
        <translation>Aparece sobre cada paso mientras se reproduce la lección</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Pasos de la lección</translation>
    </message>
    <message>
        <source>Double-click a step to restore its state of the window</source>
        <translation>Haga doble clic en un paso para poner la ventana en su estado</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>Título del paso</translation>
    </message>
    <message>
        <source>Shown in large letters above the text</source>
        <translation>Aparece en letras grandes sobre el texto</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Texto del paso</translation>
    </message>
    <message>
        <source>Shown beside the picture; leave a line empty to begin a paragraph</source>
        <translation>Aparece junto a la imagen; una línea vacía empieza un párrafo</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>The panels that this step shows beside the canvas; all others are hidden</source>
        <translation>Los paneles que este paso muestra junto al lienzo; los demás quedan ocultos</translation>
    </message>
    <message>
        <source>Panels of the step</source>
        <translation>Paneles del paso</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and title of a step</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. A lesson is a list of steps. Each has a text, and the state of the window that belongs to it: the entry, the view, the tool, colours and outlines.</source>
        <translation>%1. Una lección es una lista de pasos. Cada uno tiene un texto y el estado de la ventana que le corresponde: la entrada, lo que se ve de ella, la herramienta, los colores y los contornos.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Reproducir la lección en toda la pantalla, desde el principio o desde el paso en el que hizo clic en la lista</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Guardar la lección como un texto que se refiere a sus fractales</translation>
    </message>
</context>
<context>
    <name>view::LightBall</name>
    <message>
        <source>Direction of the light</source>
        <translation>Dirección de la luz</translation>
    </message>
    <message>
        <source>Drag the light over the sphere, or use the arrow keys</source>
        <translation>Arrastre la luz por la esfera o use las teclas de flecha</translation>
    </message>
    <message>
        <source>Azimuth %1°, elevation %2°</source>
        <translation>Acimut %1°, elevación %2°</translation>
    </message>
</context>
<context>
    <name>view::LinePicture</name>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it; click to take all</source>
        <translation>Arrastre una línea para tomar solo los colores a lo largo de ella; haga clic para tomarlos todos</translation>
    </message>
</context>
<context>
    <name>view::LinkGraph</name>
    <message>
        <source>Graph of links</source>
        <translation>Grafo de los enlaces</translation>
    </message>
    <message>
        <source>Drag from one map to another to link them; click an arrow and press Delete to remove it.</source>
        <translation>Arrastre de una aplicación a otra para enlazarlas; haga clic en una flecha y pulse Supr para quitarla.</translation>
    </message>
    <message>
        <source>Each circle is a map, and an arrow leads to each map that may follow it in the chaos game; thicker arrows have more weight. Drag from one map to another to link them, or out of a map and back to link it to itself. Click an arrow and press Delete to remove it, or double-click it to enter its weight. With the keyboard: Left and Right walk through the maps, Up and Down through the arrows of a map; Space begins a new arrow, Left and Right choose its end, Enter adds it. Maps with a dashed ring take no part; the reason is shown beside them.</source>
        <translation>Cada círculo es una aplicación, y una flecha lleva a cada aplicación que puede seguirla en el juego del caos; las flechas más gruesas tienen más peso. Arrastre de una aplicación a otra para enlazarlas, o fuera de una aplicación y de vuelta para enlazarla consigo misma. Haga clic en una flecha y pulse Supr para quitarla, o haga doble clic para introducir su peso. Con el teclado: Izquierda y Derecha recorren las aplicaciones, Arriba y Abajo las flechas de una aplicación; Espacio empieza una flecha nueva, Izquierda y Derecha eligen su final, Intro la añade. Las aplicaciones con anillo discontinuo no participan, por el motivo que se indica al lado.</translation>
    </message>
    <message>
        <source>No map is selected.</source>
        <translation>No hay ninguna aplicación seleccionada.</translation>
    </message>
    <message>
        <source>New arrow from map %1 to map %2. Enter adds it, Esc cancels.</source>
        <translation>Flecha nueva de la aplicación %1 a la aplicación %2. Intro la añade, Esc no.</translation>
    </message>
    <message>
        <source>Map %1: %2</source>
        <translation>Aplicación %1: %2</translation>
    </message>
</context>
<context>
    <name>view::LinksModel</name>
    <message>
        <source>Switched off</source>
        <translation>Desactivada</translation>
    </message>
    <message>
        <source>Unreached: no map leads to it</source>
        <translation>Inalcanzable: ninguna aplicación lleva a ella</translation>
    </message>
    <message>
        <source>Transient: the chaos game never returns</source>
        <translation>Abandonada: el juego del caos no vuelve nunca</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Interviene</translation>
    </message>
    <message>
        <source>From map %1 to map %2: %3</source>
        <translation>De la aplicación %1 a la aplicación %2: %3</translation>
    </message>
    <message>
        <source>Link map %1 to map %2</source>
        <translation>Enlazar la aplicación %1 con la aplicación %2</translation>
    </message>
    <message>
        <source>In the chaos game</source>
        <translation>En el juego del caos</translation>
    </message>
    <message>
        <source>Whether the chaos game keeps applying the map, or why not</source>
        <translation>Si la aplicación se usa una y otra vez, o por qué no</translation>
    </message>
    <message>
        <source>To map %1</source>
        <translation>A la aplicación %1</translation>
    </message>
    <message>
        <source>From map %1</source>
        <translation>De la aplicación %1</translation>
    </message>
    <message>
        <source>Unlink map %1 from map %2</source>
        <translation>Desenlazar la aplicación %1 de la aplicación %2</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n link(s)</source>
        <translation>
            <numerusform>Eliminar %n enlace</numerusform>
            <numerusform>Eliminar %n enlaces</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends: every sequence from here stops</source>
        <translation>Termina: toda sucesión desde aquí se detiene</translation>
    </message>
    <message>
        <source>Directly after map %1, map %2 has %3 times its weight.</source>
        <translation>Justo después de la aplicación %1, la aplicación %2 se usa con su peso multiplicado por %3.</translation>
    </message>
    <message>
        <source>Map %2 is never applied directly after map %1.</source>
        <translation>Justo después de la aplicación %1 no se usa nunca la aplicación %2.</translation>
    </message>
</context>
<context>
    <name>view::LinksPanel</name>
    <message>
        <source>Remove All Links</source>
        <translation>Quitar todos los enlaces</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Enlaces</translation>
    </message>
    <message>
        <source>Links between maps</source>
        <translation>Enlaces entre aplicaciones</translation>
    </message>
    <message>
        <source>Rows are the maps applied before, columns the maps applied after. A number multiplies the weight of the map in its column: 1 leaves it unchanged, 0 forbids the link.</source>
        <translation>Las filas son las aplicaciones usadas antes; las columnas, las de después. Un número multiplica el peso de la aplicación de la columna: 1 lo deja igual, 0 la prohíbe.</translation>
    </message>
    <message>
        <source>Any map may follow any other again</source>
        <translation>Cualquier aplicación puede seguir de nuevo a cualquier otra</translation>
    </message>
    <message>
        <source>Every sequence of maps ends, so nothing is drawn.</source>
        <translation>Toda sucesión de aplicaciones termina, así que no se dibuja nada.</translation>
    </message>
    <message>
        <source>Remove all links</source>
        <translation>Quitar todos los enlaces</translation>
    </message>
    <message>
        <source>Any map may follow any other. Click an arrow and press Delete to forbid it.</source>
        <translation>Cualquier aplicación puede seguir a cualquier otra. Haga clic en una flecha y pulse Supr para prohibirlo.</translation>
    </message>
    <message>
        <source>No map has a choice of what follows it, so only single points are drawn.</source>
        <translation>A cada aplicación solo puede seguirle una, por lo que solo se dibujan puntos aislados.</translation>
    </message>
    <message>
        <source>Row: the map before. Column: the map after.</source>
        <translation>Fila: la aplicación anterior. Columna: la siguiente.</translation>
    </message>
</context>
<context>
    <name>view::MapBlendRow</name>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>The position on the palette to which this map moves colours, from 0 to 1</source>
        <translation>Hacia qué lugar de la paleta atrae los colores esta aplicación: de 0, su comienzo, a 1</translation>
    </message>
    <message>
        <source>Whenever this map is applied, the colour of the point moves towards the position of the map on the palette: 0 is the beginning of the palette, 1 its end. Flame programs call it the colour coordinate.</source>
        <translation>Cada vez que se aplica una aplicación, el color de un punto se acerca al lugar de esa aplicación en la paleta: 0 es el comienzo de la paleta y 1 su final. En los flames se llama coordenada de color.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>How far this map moves colours each time, from 0 (not at all) to 1 (all the way)</source>
        <translation>Cuánto atrae los colores esta aplicación cada vez: de 0, nada, a 1, todo el camino</translation>
    </message>
    <message>
        <source>How far the map moves colours towards its position on the palette each time: with 1, its piece has a single colour; with 0, all colours stay as they are. Flame programs call it the colour speed.</source>
        <translation>Qué parte del camino hacia su lugar en la paleta lleva la aplicación los colores cada vez: con 1 su pieza tiene un solo color, con 0 deja todos los colores como están. En los flames se llama velocidad de color.</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
</context>
<context>
    <name>view::MapOrder</name>
    <message>
        <source>Order of the maps</source>
        <translation>Orden de las aplicaciones</translation>
    </message>
    <message>
        <source>Where pieces overlap, the map that is higher in this list is on top; drag a map to move it</source>
        <translation>Donde las partes se solapan, queda encima la aplicación que está más arriba en esta lista; arrastre una aplicación para moverla</translation>
    </message>
    <message>
        <source>Move the map towards the top</source>
        <translation>Mover la aplicación hacia arriba</translation>
    </message>
    <message>
        <source>Move the map towards the bottom</source>
        <translation>Mover la aplicación hacia abajo</translation>
    </message>
    <message>
        <source>On top</source>
        <translation>Encima</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Restablecer el orden</translation>
    </message>
    <message>
        <source>Reset Order: puts the maps back in the order of their numbers</source>
        <translation>Restablecer el orden: vuelve a poner las aplicaciones en el orden de sus números</translation>
    </message>
    <message>
        <source>Puts the maps back in the order of their numbers, which is that of the Maps panel: map 1 is on top. This is one step that you can undo.</source>
        <translation>Vuelve a poner las aplicaciones en el orden de sus números, que es el del panel Aplicaciones: la aplicación 1 queda encima. Es un solo paso que se puede deshacer.</translation>
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
        <source>Scale at right angles to that; negative if the map reflects</source>
        <translation>Escala en la dirección perpendicular; negativa cuando la aplicación refleja</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cizalladura</translation>
    </message>
    <message>
        <source>Shear along x, applied first</source>
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
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Axis of the rotation; only its direction matters</source>
        <translation>Eje del giro; solo cuenta su dirección</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>Eje x</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Eje y</translation>
    </message>
    <message>
        <source>Axis z</source>
        <translation>Eje z</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise as seen from the tip of the axis looking back</source>
        <translation>Ángulo en grados, en sentido antihorario visto desde la punta del eje hacia atrás</translation>
    </message>
    <message>
        <source>Scale along y, before the rotation</source>
        <translation>Escala a lo largo de y, antes del giro</translation>
    </message>
    <message>
        <source>Scale z</source>
        <translation>Escala z</translation>
    </message>
    <message>
        <source>Scale along z, before the rotation; negative if the map reflects</source>
        <translation>Escala a lo largo de z, antes del giro; negativa cuando la aplicación refleja</translation>
    </message>
    <message>
        <source>Shear xy</source>
        <translation>Cizalladura xy</translation>
    </message>
    <message>
        <source>What y adds to x, applied first</source>
        <translation>Lo que y añade a x; se aplica primero</translation>
    </message>
    <message>
        <source>Shear xz</source>
        <translation>Cizalladura xz</translation>
    </message>
    <message>
        <source>What z adds to x, applied first</source>
        <translation>Lo que z añade a x; se aplica primero</translation>
    </message>
    <message>
        <source>Shear yz</source>
        <translation>Cizalladura yz</translation>
    </message>
    <message>
        <source>What z adds to y, applied first</source>
        <translation>Lo que z añade a y; se aplica primero</translation>
    </message>
    <message>
        <source>Translation j, applied last</source>
        <translation>Traslación j, que se aplica al final</translation>
    </message>
    <message>
        <source>Translation k, applied last</source>
        <translation>Traslación k, que se aplica al final</translation>
    </message>
    <message>
        <source>Shift z</source>
        <translation>Traslación z</translation>
    </message>
    <message>
        <source>Translation l, applied last</source>
        <translation>Traslación l, que se aplica al final</translation>
    </message>
    <message>
        <source>Map %1, locked</source>
        <translation>Aplicación %1, bloqueada</translation>
    </message>
</context>
<context>
    <name>view::MapsClipboard</name>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in space.</source>
        <translation>No se pegó nada: las aplicaciones copiadas son de un sistema en el espacio.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in the plane.</source>
        <translation>No se pegó nada: las aplicaciones copiadas son de un sistema en el plano.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard contains no rows of 12 or 13 numbers.</source>
        <translation>No se pegó nada: el portapapeles no contiene filas de 12 o 13 números.</translation>
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
    <message>
        <source>Name of map %1</source>
        <translation>Nombre de la aplicación %1</translation>
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
        <source>A reflected similarity keeps shapes but mirrors them; it also turns, scales and shifts them.</source>
        <translation>Una semejanza inversa conserva las formas como lo hace un espejo, y las escala y traslada.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels but not angles.</source>
        <translation>Una aplicación afín conserva las rectas y el paralelismo, no los ángulos.</translation>
    </message>
    <message>
        <source>A singular map takes the whole plane to a line.</source>
        <translation>Una aplicación singular lleva el plano a una recta.</translation>
    </message>
    <message>
        <source>A constant map takes the whole plane to one point.</source>
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
        <source>Effective code: the map as it acts on the picture under the current cage. Bake turns it into the code.</source>
        <translation>Código efectivo: la aplicación tal como actúa sobre la imagen con la jaula actual. «Incorporar» lo convierte en el código.</translation>
    </message>
    <message>
        <source>Weight as entered: how often the chaos game chooses the map. The weights need not sum to 1.</source>
        <translation>Peso tal como se da: con qué frecuencia elige el juego del caos esta aplicación. No hace falta que los pesos sumen 1.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor by which areas change; negative if the map reflects.</source>
        <translation>Determinante ad − bc: el factor de las áreas; negativo cuando la aplicación refleja.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the largest factor by which distances are stretched.</source>
        <translation>Factor de contracción ‖A‖, el mayor valor singular: lo máximo por lo que se multiplica una distancia.</translation>
    </message>
    <message>
        <source>The geometric kind of the map.</source>
        <translation>Qué es geométricamente la aplicación.</translation>
    </message>
    <message>
        <source>Map %1 is switched on.</source>
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
        <source>No weight is given; the determinant rule gives the probability %1.</source>
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
        <source>Switch map %1 on</source>
        <translation>Activar la aplicación %1</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Desactivar la aplicación %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>Set %1 of map %2 to %3</source>
        <translation>Fijar %1 de la aplicación %2 en %3</translation>
    </message>
    <message>
        <source>Colour of map %1: %2</source>
        <translation>Color de la aplicación %1: %2</translation>
    </message>
    <message>
        <source>A singular map takes the whole of space to a plane or a line.</source>
        <translation>Una aplicación singular lleva el espacio a un plano o a una recta.</translation>
    </message>
    <message>
        <source>A constant map takes the whole of space to one point.</source>
        <translation>Una aplicación constante lleva el espacio a un solo punto.</translation>
    </message>
    <message>
        <source>The map takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</source>
        <translation>La aplicación lleva (x, y, z) a (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage.</source>
        <translation>Código efectivo: la aplicación tal como actúa sobre la imagen con la jaula actual.</translation>
    </message>
    <message>
        <source>Determinant: the factor by which volumes change; negative if the map reflects.</source>
        <translation>Determinante: el factor de los volúmenes; negativo cuando la aplicación refleja.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Whether the map is switched on. Alt+click shows one map alone.</source>
        <translation>Si la aplicación interviene. Alt+clic muestra una sola aplicación.</translation>
    </message>
    <message>
        <source>Whether the map is locked: then it cannot be edited, moved or deleted by mistake.</source>
        <translation>Si la aplicación está bloqueada: así no se puede editar, mover ni eliminar por error.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map, and the part of the attractor that the map makes.</source>
        <translation>Color de la aplicación, cuando la imagen se colorea por aplicaciones, y la parte del atractor que produce.</translation>
    </message>
    <message>
        <source>Name of the map.</source>
        <translation>Nombre de la aplicación.</translation>
    </message>
    <message>
        <source>Map %1 is shown alone.</source>
        <translation>La aplicación %1 se muestra sola.</translation>
    </message>
    <message>
        <source>Map %1 is locked.</source>
        <translation>La aplicación %1 está bloqueada.</translation>
    </message>
    <message>
        <source>Map %1 is not locked.</source>
        <translation>La aplicación %1 no está bloqueada.</translation>
    </message>
    <message>
        <source>Map %1 has no name. Double-click to name it.</source>
        <translation>La aplicación %1 no tiene nombre. Haga doble clic para dárselo.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueada</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>no bloqueada</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>sin nombre</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Quitar el nombre de la aplicación %1</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Llamar «%2» a la aplicación %1</translation>
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
        <source>Replace the code by the effective code; the cage is then at rest</source>
        <translation>Convertir el código efectivo en el código; la jaula queda entonces en reposo</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, for an even picture</source>
        <translation>Pesos proporcionales a las áreas de las imágenes, para que la imagen sea uniforme</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesos</translation>
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
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Mostrar el determinante, el factor de contracción y el tipo de cada aplicación</translation>
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
        <source>This entry could not be read. It is kept unchanged.</source>
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
        <source>Reorder maps</source>
        <translation>Reordenar las aplicaciones</translation>
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
        <source>Each row is a map: it takes (x, y) to (a x + b y + e, c x + d y + f) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Cada fila es una aplicación: (x, y) va a (a x + b y + e, c x + d y + f), con la frecuencia que dice su peso p. Haga doble clic en un número, o empiece a escribir, para cambiarlo; la imagen sigue cada tecla. Arrastre el número de una fila para moverla.</translation>
    </message>
    <message>
        <source>Properties of the map</source>
        <translation>Propiedades de la aplicación</translation>
    </message>
    <message>
        <source>det %1    ‖A‖ %2    %3</source>
        <translation>det %1    ‖A‖ %2    %3</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>Pesos: %1</translation>
    </message>
    <message>
        <source>No maps: add one.</source>
        <translation>No hay aplicaciones: añada una.</translation>
    </message>
    <message>
        <source>Weights in proportion to the volumes of the images, for an even picture</source>
        <translation>Pesos proporcionales a los volúmenes de las imágenes, para una imagen uniforme</translation>
    </message>
    <message>
        <source>Show the coefficients a … l</source>
        <translation>Mostrar los coeficientes a … l</translation>
    </message>
    <message>
        <source>Each row is a map: it takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Cada fila es una aplicación: (x, y, z) pasa a (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l), tan a menudo como dice su peso p. Haga doble clic en un número o empiece a escribir para cambiarlo; la imagen sigue cada tecla. Arrastre el número de una fila para moverla.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Move the selected maps to the clipboard</source>
        <translation>Mover al portapapeles las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Cambiar nombre</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Dar un nombre a la aplicación actual</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Bloquear</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing</source>
        <translation>Proteger de cambios las aplicaciones seleccionadas</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>Show the current map alone; the file does not change</source>
        <translation>Mostrar sola la aplicación actual; el archivo no cambia</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Show the names of the maps</source>
        <translation>Mostrar los nombres de las aplicaciones</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f g h i j k l p, separated by tabs</source>
        <translation>Copiar las aplicaciones seleccionadas como filas a b c d e f g h i j k l p, separadas por tabuladores</translation>
    </message>
    <message>
        <source>Add rows of 12 or 13 numbers from the clipboard as new maps</source>
        <translation>Añadir filas de 12 o 13 números del portapapeles como aplicaciones nuevas</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 12 or 13 numbers from the clipboard</source>
        <translation>Sustituir las aplicaciones seleccionadas por filas de 12 o 13 números del portapapeles</translation>
    </message>
    <message>
        <source>Cut a map</source>
        <translation>Cortar una aplicación</translation>
    </message>
    <message>
        <source>Cut %1 maps</source>
        <translation>Cortar %1 aplicaciones</translation>
    </message>
    <message>
        <source>Effective</source>
        <translation>Efectivo</translation>
    </message>
    <message>
        <source>Select a map to see and edit it here.</source>
        <translation>Seleccione una aplicación para verla y editarla aquí.</translation>
    </message>
    <message>
        <source>Map %1 only, of %2 selected    %3</source>
        <translation>Solo la aplicación %1, de %2 seleccionadas    %3</translation>
    </message>
    <message>
        <source>Show the coefficients of the maps</source>
        <translation>Mostrar los coeficientes de las aplicaciones</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Números de las aplicaciones</translation>
    </message>
    <message>
        <source>Drag a number to move the map. A warning sign marks a map that does not contract, or that a negative weight switches off.</source>
        <translation>Arrastre un número para poner la aplicación en otro lugar. Una marca avisa de que una aplicación no es contractiva o de que un peso negativo la desactiva.</translation>
    </message>
</context>
<context>
    <name>view::MapsTable</name>
    <message>
        <source>Drag the name of a number left or right to change it in the current map: a tenth as fast with Shift, ten times as fast with Ctrl. The wheel does the same while the pointer is over the current cell. Drag the edge of a name to change the width of its column.</source>
        <translation>Arrastre el nombre de un número a la izquierda o a la derecha para cambiarlo en la aplicación actual: diez veces más lento con Mayús, diez veces más rápido con Ctrl. La rueda hace lo mismo mientras el puntero está sobre la celda actual. Arrastre el borde de un nombre para cambiar la anchura de su columna.</translation>
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
        <source>Maps that are flat on the screen cannot be dragged. First open the cage or the maps.</source>
        <translation>Las aplicaciones que se ven planas en la pantalla no se pueden arrastrar. Abra primero la jaula o las aplicaciones.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Elija primero una aplicación.</translation>
    </message>
    <message>
        <source>There are too many maps to show them all. Zoom in to see the others.</source>
        <translation>De tantas aplicaciones solo se muestran algunas. Acerque la vista para ver las demás.</translation>
    </message>
</context>
<context>
    <name>view::MorphDialog</name>
    <message>
        <source>A fractal in the plane cannot become one in space.</source>
        <translation>Un fractal del plano no puede convertirse en uno del espacio.</translation>
    </message>
    <message>
        <source>One of the two fractals has more than 256 maps.</source>
        <translation>Uno de los dos fractales tiene más de 256 aplicaciones.</translation>
    </message>
    <message>
        <source>The maps of one of the two fractals are linked.</source>
        <translation>Las aplicaciones de uno de los dos fractales están enlazadas.</translation>
    </message>
    <message>
        <source>A bent cage has no code to start from. Reset or bake it first.</source>
        <translation>Una jaula doblada no tiene código del que partir. Antes restablézcala o incorpórela.</translation>
    </message>
    <message>
        <source>One of the two fractals has no attractor.</source>
        <translation>Uno de los dos fractales no tiene atractor.</translation>
    </message>
    <message>
        <source>Morph “%1”</source>
        <translation>Transformar «%1»</translation>
    </message>
    <message>
        <source>The entry of this file that the fractal becomes.</source>
        <translation>La entrada de este archivo en que se convierte el fractal.</translation>
    </message>
    <message>
        <source>&amp;Becomes:</source>
        <translation>&amp;Se convierte en:</translation>
    </message>
    <message>
        <source>&amp;Add Morph</source>
        <translation>&amp;Añadir transformación</translation>
    </message>
    <message>
        <source>Adds the morph to the file as an entry of its own, in one step that you can undo.</source>
        <translation>Añade la transformación al archivo como entrada propia, en un solo paso que puede deshacer.</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>So&amp;ltar las parejas</translation>
    </message>
    <message>
        <source>Pairs all maps so that the total distance is shortest.</source>
        <translation>Deja que todas las aplicaciones sigan el camino más corto.</translation>
    </message>
    <message>
        <source>The morph at %1 %</source>
        <translation>La transformación al %1 %</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Este archivo no tiene otro fractal de esta dimensión.</translation>
    </message>
</context>
<context>
    <name>view::MorphLines</name>
    <message>
        <source>Pairs of maps</source>
        <translation>Parejas de aplicaciones</translation>
    </message>
    <message>
        <source>The maps of this fractal are on the left, those of the other one on the right. A line shows what a map becomes, and its thickness shows its share of the weight. Drag from a map to one in the other column to pin the pair, and again to unpin it. With the keyboard: choose a map with the arrow keys, press Space, go to the other map and press Space again. Del removes all pins of a map.</source>
        <translation>A la izquierda, las aplicaciones de este fractal; a la derecha, las del otro. Una línea muestra en qué se convierte una aplicación, y su grosor, qué parte del peso sigue ese camino. Arrastre de una aplicación a otra de la otra columna para fijar la pareja, y otra vez para soltarla. Con el teclado: elija una aplicación con las flechas, pulse Espacio, vaya a la otra y pulse Espacio de nuevo. Supr suelta todas las parejas fijadas de una aplicación.</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>%1 (%2 %, pinned)</source>
        <translation>%1 (%2 %, fijada)</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Map %1 takes no part.</source>
        <translation>La aplicación %1 no participa.</translation>
    </message>
    <message>
        <source>Map %1 becomes map %2.</source>
        <translation>La aplicación %1 se convierte en la %2.</translation>
    </message>
    <message>
        <source>Map %1 comes from map %2.</source>
        <translation>La aplicación %1 procede de la %2.</translation>
    </message>
</context>
<context>
    <name>view::MotionDialog</name>
    <message>
        <source>Change the motion “%1”</source>
        <translation>Cambiar el movimiento «%1»</translation>
    </message>
    <message>
        <source>Motion: %1</source>
        <translation>Movimiento: %1</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>How far the branches swing at most, as an angle about their roots. A negative strength swings them the other way.</source>
        <translation>Cuánto oscilan las ramas como máximo, como ángulo en torno a donde empiezan. Con una intensidad negativa oscilan al revés.</translation>
    </message>
    <message>
        <source>How much the maps swell and shrink at most. With a negative strength they shrink first.</source>
        <translation>Cuánto se agrandan y se encogen las aplicaciones como máximo. Con una intensidad negativa se encogen primero.</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Vueltas</translation>
    </message>
    <message>
        <source>Cycles of wave %1</source>
        <translation>Ciclos de la onda %1</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Ciclos</translation>
    </message>
    <message>
        <source>How many turns it makes during the animation. A negative number turns the other way.</source>
        <translation>Cuántas veces da la vuelta en la duración de la animación. Con un número negativo gira al revés.</translation>
    </message>
    <message>
        <source>How many times it moves back and forth during the animation.</source>
        <translation>Cuántas veces va y viene en la duración de la animación.</translation>
    </message>
    <message>
        <source>Limit of the strength</source>
        <translation>Límite de la intensidad</translation>
    </message>
    <message>
        <source>Only %1 is used: with more there would be no attractor at some moment.</source>
        <translation>Solo se usa %1: con más no habría atractor en algún momento.</translation>
    </message>
</context>
<context>
    <name>view::MotionPage</name>
    <message>
        <source>Make Keys</source>
        <translation>Crear claves</translation>
    </message>
    <message>
        <source>Make a first key, and show the tracks</source>
        <translation>Crear una primera clave y mostrar las pistas</translation>
    </message>
    <message>
        <source>Or set a key, move the playhead, and change the fractal.</source>
        <translation>O ponga una clave, mueva el cabezal y cambie el fractal.</translation>
    </message>
    <message>
        <source>Nothing moves yet. Choose a motion:</source>
        <translation>Todavía no se mueve nada. Elija un movimiento:</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Variaciones de «%1»</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Variaciones</translation>
    </message>
    <message>
        <source>How strongly the variations differ</source>
        <translation>Cuánto difieren las variaciones</translation>
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
        <source>&amp;New Set</source>
        <translation>&amp;Nuevo conjunto</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Otra lámina: la semilla siguiente</translation>
    </message>
    <message>
        <source>S&amp;trength:</source>
        <translation>I&amp;ntensidad:</translation>
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
        <source>The fractal in the middle replaces the one that you began with, in one step that you can undo.</source>
        <translation>El fractal del centro sustituye a aquel con el que empezó, en un solo paso que puede deshacer.</translation>
    </message>
    <message>
        <source>Line of descent</source>
        <translation>Línea de descendencia</translation>
    </message>
    <message>
        <source>Every parent so far, the oldest at the top. Select one to go back to it. Its descendants stay in the list until you choose another child of it.</source>
        <translation>Todos los progenitores hasta ahora, el más antiguo arriba. Elija uno para volver a él. Sus descendientes siguen en la lista hasta que elija otro hijo suyo.</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Original</translation>
    </message>
    <message>
        <source>Line of &amp;descent</source>
        <translation>Línea de &amp;descendencia</translation>
    </message>
    <message>
        <source>How far the variations are from their parent</source>
        <translation>Cuánto se alejan las variaciones de su progenitor</translation>
    </message>
    <message>
        <source>On the left, the variations stay close to their parent; on the right, they differ greatly.</source>
        <translation>A la izquierda, las variaciones se parecen a su progenitor; a la derecha, difieren mucho.</translation>
    </message>
    <message>
        <source>Sha&amp;pe</source>
        <translation>&amp;Forma</translation>
    </message>
    <message>
        <source>Turn, stretch and move the maps</source>
        <translation>Girar, estirar y mover las aplicaciones</translation>
    </message>
    <message>
        <source>The maps are turned, stretched and moved, and occasionally one is added or removed. Locked maps, and maps that are off, stay as they are.</source>
        <translation>Las aplicaciones se giran, se estiran y se mueven; de vez en cuando se añade o se quita una. Las bloqueadas y las desactivadas se quedan como están.</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>C&amp;olor</translation>
    </message>
    <message>
        <source>Try other colours</source>
        <translation>Probar otros colores</translation>
    </message>
    <message>
        <source>The hues of the palette, the plain colour and the colours of the maps change. The background and the meaning of the colours stay the same.</source>
        <translation>La paleta, el color único y los colores de las aplicaciones cambian de tono. El fondo se mantiene, igual que lo que representan los colores.</translation>
    </message>
    <message>
        <source>&amp;Weights</source>
        <translation>&amp;Pesos</translation>
    </message>
    <message>
        <source>Make some maps denser and others fainter</source>
        <translation>Hacer unas aplicaciones más densas y otras más tenues</translation>
    </message>
    <message>
        <source>The weights change at random and follow the sizes of the maps. Otherwise, each map keeps its weight. A solid in space does not depend on weights; a cloud does.</source>
        <translation>Los pesos cambian al azar y siguen el tamaño de las aplicaciones. Si no, cada aplicación conserva el suyo. Un sólido en el espacio no depende de los pesos; una nube, sí.</translation>
    </message>
    <message>
        <source>What may change:</source>
        <translation>Qué puede cambiar:</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nada</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Este archivo no tiene otro fractal de esta dimensión.</translation>
    </message>
    <message>
        <source>Mix the parent with another entry of this file</source>
        <translation>Mezclar el progenitor con otra entrada de este archivo</translation>
    </message>
    <message>
        <source>The variations take some maps from the parent, some from the other entry, and some that are halfway between two corresponding maps. The checkboxes above determine whether shape, colour and weights are mixed. Every child has an attractor.</source>
        <translation>Las variaciones toman unas aplicaciones del progenitor, otras de la otra entrada, y otras que están entre dos que se corresponden. Las casillas de arriba indican si se mezclan forma, color y pesos. Cada hijo tiene un atractor.</translation>
    </message>
    <message>
        <source>C&amp;ross with:</source>
        <translation>C&amp;ruzar con:</translation>
    </message>
    <message>
        <source>The number from which the variations are generated. With the same parent, the same settings and the same seed you get the same sheet again.</source>
        <translation>El número del que salen las variaciones. Con el mismo progenitor, los mismos ajustes y la misma semilla se obtiene otra vez la misma lámina.</translation>
    </message>
    <message>
        <source>Shows other variations of the same parent, from the next seed.</source>
        <translation>Muestra otras variaciones del mismo progenitor, con la semilla siguiente.</translation>
    </message>
    <message>
        <source>Variation %1, not ready yet</source>
        <translation>Variación %1, todavía sin hacer</translation>
    </message>
    <message>
        <source>Generation %1</source>
        <translation>Generación %1</translation>
    </message>
    <message>
        <source>Parent: the original</source>
        <translation>Progenitor: el original</translation>
    </message>
    <message>
        <source>Parent: generation %1</source>
        <translation>Progenitor: generación %1</translation>
    </message>
    <message>
        <source>Nothing may change, so there are no variations. Tick at least one of the checkboxes.</source>
        <translation>Nada puede cambiar: no hay variaciones. Marque al menos una casilla.</translation>
    </message>
    <message>
        <source>All maps are locked and keep their weights: the variations differ only in colours and, occasionally, in an added map. Many look like their parent.</source>
        <translation>Todas las aplicaciones están bloqueadas y conservan sus pesos: las variaciones solo se distinguen por los colores y, de vez en cuando, por una aplicación añadida. Muchas son iguales a su progenitor.</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Usar este</translation>
    </message>
    <message>
        <source>Use a variation</source>
        <translation>Usar una variación</translation>
    </message>
    <message>
        <source>Around the picture in the middle are its variations. Click one, or press Enter on it, to put it in the middle. Double-click one to use it at once.</source>
        <translation>Alrededor de la imagen del centro están sus variaciones. Haga clic en una, o pulse Intro sobre ella, para ponerla en el centro. Un doble clic la usa enseguida.</translation>
    </message>
    <message>
        <source>Click a picture to put it in the middle, with variations of its own around it.</source>
        <translation>Haga clic en una imagen para ponerla en el centro, rodeada de sus propias variaciones.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma, or an expression such as 1/2, sqrt(3)/6, cos(36°) or pi. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Un número, con punto o coma decimal, o una expresión como 1/2, sqrt(3)/6, cos(36°) o pi. Las teclas de flecha y la rueda lo cambian: diez veces más rápido con Mayús, diez veces más lento con Alt. Esc restaura el número anterior.</translation>
    </message>
    <message>
        <source>An angle in degrees, with or without °, or an expression such as 360/7. An expression with pi, or with asin, acos, atan or atan2, is in radians and becomes degrees: pi/2 is 90. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Un ángulo en grados, con o sin °, o una expresión como 360/7. Una expresión con pi, o con asin, acos, atan o atan2, está en radianes y se convierte en grados: pi/2 es 90. Las teclas de flecha y la rueda lo cambian: diez veces más rápido con Mayús, diez veces más lento con Alt. Esc restaura el número anterior.</translation>
    </message>
    <message>
        <source>%1: the number stays as it was. %2</source>
        <translation>%1: el número queda como estaba. %2</translation>
    </message>
</context>
<context>
    <name>view::OrbitRows</name>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>The axis that the camera goes round.</source>
        <translation>El eje alrededor del cual gira la cámara.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinación</translation>
    </message>
    <message>
        <source>How far the axis is tilted, like that of a globe. With 180° the camera goes round the other way.</source>
        <translation>Cuánto se inclina el eje, como el de un globo terráqueo. Con 180° la cámara gira al revés.</translation>
    </message>
    <message>
        <source>Direction of the tilt</source>
        <translation>Dirección de la inclinación</translation>
    </message>
    <message>
        <source>Where the axis is tilted to: at 0° to the next one, X to Y, Y to Z and Z to X, and at 90° to the one after that.</source>
        <translation>Hacia dónde se inclina el eje: con 0° hacia el siguiente, X hacia Y, Y hacia Z y Z hacia X, y con 90° hacia el que viene después.</translation>
    </message>
    <message>
        <source>Centre of the fractal</source>
        <translation>Centro del fractal</translation>
    </message>
    <message>
        <source>A point</source>
        <translation>Un punto</translation>
    </message>
    <message>
        <source>Middle of the view</source>
        <translation>Centro de la vista</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Pivote</translation>
    </message>
    <message>
        <source>What stays in its place while everything turns.</source>
        <translation>Lo que se queda en su sitio mientras todo gira.</translation>
    </message>
    <message>
        <source>%1 of the pivot</source>
        <translation>%1 del pivote</translation>
    </message>
    <message>
        <source>The point that stays in its place.</source>
        <translation>El punto que se queda en su sitio.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
</context>
<context>
    <name>view::PaletteBrowser</name>
    <message>
        <source>Palettes</source>
        <translation>Paletas</translation>
    </message>
    <message>
        <source>&amp;Use This Palette</source>
        <translation>&amp;Usar esta paleta</translation>
    </message>
    <message>
        <source>Search palettes</source>
        <translation>Buscar paletas</translation>
    </message>
    <message>
        <source>&amp;Favourites Only</source>
        <translation>Solo &amp;favoritas</translation>
    </message>
    <message>
        <source>Shows only the palettes that you marked with the star.</source>
        <translation>Muestra solo las paletas que ha marcado con la estrella.</translation>
    </message>
    <message>
        <source>Palettes made in Oklab, whose steps look equally large. Select one to see it on the fractal; double-click it to keep it.</source>
        <translation>Paletas creadas en Oklab, cuyos pasos se ven iguales. Seleccione una para verla en el fractal; haga doble clic para conservarla.</translation>
    </message>
    <message>
        <source>The palette as it will be used</source>
        <translation>La paleta tal como se usará</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Favorita</translation>
    </message>
    <message>
        <source>Mark the selected palette as a favourite (Ctrl+D)</source>
        <translation>Marcar la paleta seleccionada como favorita (Ctrl+D)</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Tono</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Desplazamiento</translation>
    </message>
    <message>
        <source>&amp;Reversed</source>
        <translation>&amp;Invertida</translation>
    </message>
    <message>
        <source>%1, a favourite</source>
        <translation>%1, favorita</translation>
    </message>
    <message>
        <source>No favourites yet. Select a palette and press Ctrl+D.</source>
        <translation>Aún no hay favoritas. Seleccione una paleta y pulse Ctrl+D.</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Sin resultados</translation>
    </message>
    <message>
        <source>Rotate all hues by this many degrees; the lightness stays the same</source>
        <translation>Girar todos los tonos estos grados; la claridad se conserva</translation>
    </message>
    <message>
        <source>Start farther along the palette; the part before moves to the end</source>
        <translation>Empezar más adelante en la paleta; la parte anterior pasa al final</translation>
    </message>
    <message>
        <source>All palettes: search them, mark favourites, and adjust the one that is selected.</source>
        <translation>Todas las paletas: búsquelas, marque favoritas y ajuste la que está seleccionada.</translation>
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
        <source>The rows do not say which column is which, and programs differ. Choose the order that gives the picture you expect in the background.</source>
        <translation>Las filas no dicen qué columna es cada una, y los programas difieren. Elija el orden con el que la imagen que está detrás de este diálogo sea la que espera.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Las aplicaciones tal como se pegarán</translation>
    </message>
    <message>
        <source>The maps in the chosen order: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
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
        <source>C&amp;olumns:</source>
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
        <source>In this order these maps do not contract: %1. The columns may have a different meaning.</source>
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
    <message>
        <source>&amp;Keep as It Is</source>
        <translation>&amp;Dejar como está</translation>
    </message>
</context>
<context>
    <name>view::PicturePaletteDialog</name>
    <message>
        <source>Palette from Picture</source>
        <translation>Paleta de una imagen</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>How many colours the palette has</source>
        <translation>Cuántos colores tiene la paleta</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it.</source>
        <translation>Arrastre una línea para tomar solo los colores a lo largo de ella.</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Colores:</translation>
    </message>
    <message>
        <source>Makes a palette of the colours of a picture, or of those along a line in it.</source>
        <translation>Crea una paleta con los colores de una imagen, o con los que hay a lo largo de una línea en ella.</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>Restart to change the language.</source>
        <translation>Reinicie para cambiar el idioma.</translation>
    </message>
    <message>
        <source>Re&amp;open last files on startup</source>
        <translation>Rea&amp;brir los últimos archivos al inicio</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Predeterminado del sistema</translation>
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
        <source>The colours of windows and panels. The picture keeps its own colours.</source>
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
        <source>The number of points drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Cuántos puntos se dibujan mientras nada se mueve. Con más puntos la imagen es más suave y el procesador está ocupado más tiempo.</translation>
    </message>
    <message>
        <source>When this is on, Barycage reopens the files that were open when you closed it, each in its own window.</source>
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
        <source>Not saved yet: %1.</source>
        <translation>Sin guardar: %1.</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Plato giratorio</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Trackball</translation>
    </message>
    <message>
        <source>How a drag turns a solid. On a turntable, vertical lines stay vertical. A trackball turns freely about the axes of the screen, even over the poles; to level the view again, look along an axis.</source>
        <translation>Cómo gira un sólido al arrastrar. En un plato giratorio, lo vertical sigue vertical. Un trackball gira libremente sobre los ejes de la pantalla, también por encima de los polos; para nivelar la vista de nuevo, mire a lo largo de un eje.</translation>
    </message>
    <message>
        <source>Restart &amp;Now</source>
        <translation>Reiniciar &amp;ahora</translation>
    </message>
    <message>
        <source>Closes all windows, asking about unsaved changes first, and opens the same files again in the new language.</source>
        <translation>Cierra todas las ventanas, pregunta antes por los cambios sin guardar y vuelve a abrir los mismos archivos en el nuevo idioma.</translation>
    </message>
    <message>
        <source>&amp;Keep the previous version of files</source>
        <translation>&amp;Conservar la versión anterior de los archivos</translation>
    </message>
    <message>
        <source>When this is on, the first time that you save a file after opening it, the version before stays beside it under the same name with “~” behind it, such as maple.ifs~.</source>
        <translation>Si está activado, la primera vez que guarde un archivo tras abrirlo, la versión anterior queda junto a él con el mismo nombre seguido de «~», por ejemplo maple.ifs~.</translation>
    </message>
    <message>
        <source>Play when opened</source>
        <translation>Reproducir al abrir</translation>
    </message>
    <message>
        <source>Still until played</source>
        <translation>Quieto hasta reproducir</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Whether an entry that moves plays as soon as it is opened. When your desktop asks for less motion, the system default shows a still picture until you press Play.</source>
        <translation>Si una entrada que se mueve se reproduce en cuanto se abre. Cuando el escritorio pide menos movimiento, la opción del sistema muestra una imagen quieta hasta que pulse Reproducir.</translation>
    </message>
    <message>
        <source>&amp;Motion:</source>
        <translation>&amp;Movimiento:</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;General</translation>
    </message>
    <message>
        <source>S&amp;hortcuts</source>
        <translation>&amp;Atajos</translation>
    </message>
    <message>
        <source>Resets every setting on this page to its default.</source>
        <translation>Devuelve todos los ajustes de esta página a sus valores predeterminados.</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Imagen en reposo</translation>
    </message>
    <message>
        <source>Solids turn like</source>
        <translation>Los sólidos giran como</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>Imag&amp;en en reposo:</translation>
    </message>
    <message>
        <source>&amp;Solids turn like:</source>
        <translation>Los &amp;sólidos giran como:</translation>
    </message>
    <message>
        <source>&amp;Names under the symbols of the toolbar</source>
        <translation>&amp;Nombres bajo los símbolos de la barra de herramientas</translation>
    </message>
    <message>
        <source>When this is on, the toolbar shows the name of each command under its symbol.</source>
        <translation>Si está activado, la barra de herramientas muestra el nombre de cada orden bajo su símbolo.</translation>
    </message>
    <message>
        <source>The settings of windows and pictures, the commands of the toolbar, and the keys of commands.</source>
        <translation>Los ajustes de las ventanas y las imágenes, las órdenes de la barra de herramientas y las teclas de las órdenes.</translation>
    </message>
    <message>
        <source>Tool&amp;bar</source>
        <translation>Barra de &amp;herramientas</translation>
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
        <source>Problem</source>
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
        <source>Select a line to show its entry.</source>
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
        <source>Text that could not be read is kept unchanged.</source>
        <translation>Lo que no se pudo leer se conserva tal cual.</translation>
    </message>
    <message>
        <source>No problems: every entry was read.</source>
        <translation>Ningún problema: se leyeron todas las entradas.</translation>
    </message>
    <message>
        <source>The problems found while reading the file, with line and column. Double-click a line to go to its entry.</source>
        <translation>Los problemas encontrados al leer el archivo, con línea y columna. Haga doble clic en una línea para ir a su entrada.</translation>
    </message>
</context>
<context>
    <name>view::RandomDialog</name>
    <message>
        <source>Random Fractals</source>
        <translation>Fractales al azar</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>&amp;Añadir al archivo</translation>
    </message>
    <message>
        <source>Adds the selected one as an entry of its own, in one step that you can undo.</source>
        <translation>Añade el elegido como entrada propia, en un solo paso que puede deshacer.</translation>
    </message>
    <message>
        <source>Random fractals</source>
        <translation>Fractales al azar</translation>
    </message>
    <message>
        <source>Select one and confirm, or double-click it: it is added to the file, in one step that you can undo.</source>
        <translation>Elija uno y confirme, o haga doble clic en él: se añade al archivo, en un solo paso que puede deshacer.</translation>
    </message>
    <message>
        <source>In the plane</source>
        <translation>En el plano</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>En el espacio</translation>
    </message>
    <message>
        <source>Plane or space</source>
        <translation>Plano o espacio</translation>
    </message>
    <message>
        <source>Make systems in the plane or in space</source>
        <translation>Crear sistemas en el plano o en el espacio</translation>
    </message>
    <message>
        <source>In the plane, the contraction of the maps follows a rule that makes the fractal fill its view. In space there is no such rule: the two larger scale factors of each map follow that of the plane, and the third is smaller.</source>
        <translation>En el plano, lo que contraen las aplicaciones sigue una regla con la que el fractal llena su vista. En el espacio no existe tal regla: los dos estiramientos mayores de cada aplicación siguen la del plano y el tercero es menor.</translation>
    </message>
    <message>
        <source>How many maps the systems have</source>
        <translation>Cuántas aplicaciones tienen los sistemas</translation>
    </message>
    <message>
        <source>How many maps each system lists. With a symmetry, each of them also acts rotated or mirrored.</source>
        <translation>Cuántas aplicaciones figuran en la lista de cada sistema. Con una simetría, cada una actúa también girada o reflejada.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Make systems that are symmetric about the origin</source>
        <translation>Crear sistemas simétricos respecto al origen</translation>
    </message>
    <message>
        <source>Each map also acts rotated or mirrored about the origin, so the fractal is symmetric. You can change the symmetry later in the Maps panel. The tetrahedral, octahedral and icosahedral groups exist in space only.</source>
        <translation>Cada aplicación actúa también girada o reflejada respecto al origen, de modo que el fractal es simétrico. Puede cambiar la simetría después en el panel Aplicaciones. Los grupos tetraédrico, octaédrico e icosaédrico solo existen en el espacio.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Orden de la simetría</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Cuántas veces se repite el fractal en una vuelta completa</translation>
    </message>
    <message>
        <source>A rotation of order 5 repeats the fractal five times in a full turn.</source>
        <translation>Una rotación de orden 5 repite el fractal cinco veces en una vuelta completa.</translation>
    </message>
    <message>
        <source>&amp;Maps:</source>
        <translation>A&amp;plicaciones:</translation>
    </message>
    <message>
        <source>S&amp;ymmetry:</source>
        <translation>S&amp;imetría:</translation>
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
        <source>The number from which the systems are generated. With the same settings and the same seed you get the same sheet again.</source>
        <translation>El número del que salen los sistemas. Con los mismos ajustes y la misma semilla se obtiene otra vez la misma lámina.</translation>
    </message>
    <message>
        <source>&amp;New Set</source>
        <translation>&amp;Nuevo conjunto</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Otra lámina: la semilla siguiente</translation>
    </message>
    <message>
        <source>Shows other systems of the same kind, from the next seed.</source>
        <translation>Muestra otros sistemas del mismo tipo, con la semilla siguiente.</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Semilla:</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Cualquiera</translation>
    </message>
    <message>
        <source>Fractal %1</source>
        <translation>Fractal %1</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Añadir un fractal al azar</translation>
    </message>
</context>
<context>
    <name>view::SaveViewDialog</name>
    <message>
        <source>Save View</source>
        <translation>Guardar la vista</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Nombre de la vista</translation>
    </message>
    <message>
        <source>The name under which the view is listed in View, Saved Views, beside the zoom and in the export dialogs.</source>
        <translation>El nombre con el que la vista aparece en «Ver», «Vistas guardadas», junto al zoom y en los diálogos de exportación.</translation>
    </message>
    <message>
        <source>&amp;Name of the view:</source>
        <translation>&amp;Nombre de la vista:</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Vista %1</translation>
    </message>
    <message>
        <source>A fractal can have at most %1 saved views. Delete one first.</source>
        <translation>Un fractal puede tener como máximo %1 vistas guardadas. Elimine antes una.</translation>
    </message>
    <message>
        <source>Replaces the view of this name.</source>
        <translation>Sustituye la vista de este nombre.</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Se guarda como «%1».</translation>
    </message>
    <message>
        <source>Keeps the view with the fractal: one step of the history. A view of the same name is replaced.</source>
        <translation>Guarda la vista con el fractal: un paso del historial. Una vista del mismo nombre se reemplaza.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
</context>
<context>
    <name>view::SavedViewsDialog</name>
    <message>
        <source>Saved Views</source>
        <translation>Vistas guardadas</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>Vistas guardadas</translation>
    </message>
    <message>
        <source>The views of this fractal. Double-click one to go to it, press F2 to rename it.</source>
        <translation>Las vistas de este fractal. Haga doble clic en una para ir a ella, pulse F2 para cambiarle el nombre.</translation>
    </message>
    <message>
        <source>&amp;Go To</source>
        <translation>&amp;Ir</translation>
    </message>
    <message>
        <source>Shows this view on the canvas.</source>
        <translation>Muestra esta vista en el lienzo.</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Actualizar</translation>
    </message>
    <message>
        <source>Replaces it by the current view of the canvas.</source>
        <translation>La sustituye por lo que muestra ahora el lienzo.</translation>
    </message>
    <message>
        <source>Update the view “%1”</source>
        <translation>Actualizar la vista «%1»</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Ca&amp;mbiar nombre</translation>
    </message>
    <message>
        <source>Gives the view another name.</source>
        <translation>Da otro nombre a la vista.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Deletes the view; the fractal stays as it is.</source>
        <translation>Elimina la vista; el fractal queda como está.</translation>
    </message>
    <message>
        <source>Delete the view “%1”</source>
        <translation>Eliminar la vista «%1»</translation>
    </message>
    <message>
        <source>Rename the view “%1” to “%2”</source>
        <translation>Cambiar el nombre de la vista «%1» por «%2»</translation>
    </message>
</context>
<context>
    <name>view::ShadowTool</name>
    <message>
        <source>Turn the shadow</source>
        <translation>Girar la sombra</translation>
    </message>
</context>
<context>
    <name>view::Shortcuts</name>
    <message>
        <source>“%1” is used on the canvas and in fields. Choose other keys.</source>
        <translation>«%1» se usa en el lienzo y en los campos. Elija otras teclas.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
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
        <source>Move or scale along one axis, rotate in steps of 15°</source>
        <translation>Mover o escalar a lo largo de un eje, girar en pasos de 15°</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Mayús mientras se arrastra</translation>
    </message>
    <message>
        <source>Cancel the drag</source>
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
        <source>Shows only the lines that contain these words.</source>
        <translation>Muestra solo las líneas que contienen estas palabras.</translation>
    </message>
    <message>
        <source>All keys and mouse gestures, and what they do.</source>
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
        <source>Select a deeper or a larger branch</source>
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
        <source>Add a map or vertex to the selection, or remove it</source>
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
        <source>Remove the last vertex while defining a triangle</source>
        <translation>Retirar el último vértice mientras se define un triángulo</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Select another stop</source>
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
        <source>Enter or Space, or double-click it</source>
        <translation>Intro o Espacio, o doble clic en ella</translation>
    </message>
    <message>
        <source>Cancel the change</source>
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
    <message>
        <source>Next or previous part of the window</source>
        <translation>Parte siguiente o anterior de la ventana</translation>
    </message>
    <message>
        <source>F6, Shift+F6</source>
        <translation>F6, Mayús+F6</translation>
    </message>
    <message>
        <source>Play or stop the animation</source>
        <translation>Reproducir o detener la animación</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Move the playhead</source>
        <translation>Mover el cabezal</translation>
    </message>
    <message>
        <source>drag in the ruler, or Left, Right</source>
        <translation>arrastrar en la regla, o Izquierda, Derecha</translation>
    </message>
    <message>
        <source>Previous or next key</source>
        <translation>Clave anterior o siguiente</translation>
    </message>
    <message>
        <source>Ctrl + Left, Right</source>
        <translation>Ctrl + Izquierda, Derecha</translation>
    </message>
    <message>
        <source>First or last frame</source>
        <translation>Primer o último fotograma</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Inicio, Fin</translation>
    </message>
    <message>
        <source>Select another row</source>
        <translation>Seleccionar otra fila</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Arriba, Abajo</translation>
    </message>
    <message>
        <source>Make or delete the key of the row</source>
        <translation>Crear o eliminar la clave de la fila</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Move the selected keys</source>
        <translation>Mover las claves seleccionadas</translation>
    </message>
    <message>
        <source>drag them</source>
        <translation>arrastrarlas</translation>
    </message>
    <message>
        <source>Move all later keys of the row, too</source>
        <translation>Mover también todas las claves posteriores de la fila</translation>
    </message>
    <message>
        <source>Alt while dragging</source>
        <translation>Alt al arrastrar</translation>
    </message>
    <message>
        <source>Copy the keys</source>
        <translation>Copiar las claves</translation>
    </message>
    <message>
        <source>Ctrl while dragging</source>
        <translation>Ctrl al arrastrar</translation>
    </message>
    <message>
        <source>Copy, paste, select all keys</source>
        <translation>Copiar, pegar, seleccionar todas las claves</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V, Ctrl+A</source>
        <translation>Ctrl+C, Ctrl+V, Ctrl+A</translation>
    </message>
    <message>
        <source>Delete the selected keys, or the motion</source>
        <translation>Eliminar las claves seleccionadas o el movimiento</translation>
    </message>
    <message>
        <source>Choose how a key leads to the next</source>
        <translation>Elegir cómo lleva una clave a la siguiente</translation>
    </message>
    <message>
        <source>right-click it</source>
        <translation>clic derecho en ella</translation>
    </message>
    <message>
        <source>Zoom the ruler</source>
        <translation>Ampliar la regla</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + rueda</translation>
    </message>
    <message>
        <source>In the timeline</source>
        <translation>En la línea de tiempo</translation>
    </message>
    <message>
        <source>In the table of maps</source>
        <translation>En la tabla de aplicaciones</translation>
    </message>
    <message>
        <source>Show one map alone, or all of them again</source>
        <translation>Mostrar una sola aplicación, o todas de nuevo</translation>
    </message>
    <message>
        <source>Alt + click on its eye</source>
        <translation>Alt + clic en su ojo</translation>
    </message>
    <message>
        <source>Rotate the view</source>
        <translation>Girar la vista</translation>
    </message>
    <message>
        <source>Ctrl + Shift + wheel</source>
        <translation>Ctrl + Mayús + rueda</translation>
    </message>
    <message>
        <source>Change the stop colour</source>
        <translation>Cambiar el color de la parada</translation>
    </message>
    <message>
        <source>Ball of axes, after the last handle: choose an end</source>
        <translation>Bola de los ejes, tras el último tirador: elegir un extremo</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>teclas de flecha</translation>
    </message>
    <message>
        <source>Ball of axes: look along the axis, then from behind</source>
        <translation>Bola de los ejes: mirar a lo largo del eje, después desde detrás</translation>
    </message>
    <message>
        <source>Enter or Space</source>
        <translation>Intro o Espacio</translation>
    </message>
    <message>
        <source>Ball of axes: turn the view, return to the canvas</source>
        <translation>Bola de los ejes: girar la vista, volver al lienzo</translation>
    </message>
    <message>
        <source>Shift + arrow keys, Esc</source>
        <translation>Mayús + teclas de flecha, Esc</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsPage</name>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Predeterminado</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>&amp;Intercambiar</translation>
    </message>
    <message>
        <source>Find a command or keys</source>
        <translation>Buscar una orden o unas teclas</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>&amp;Shortcut:</source>
        <translation>Ata&amp;jo:</translation>
    </message>
    <message>
        <source>Press the keys that the selected command is to have. Tab goes on to the next field.</source>
        <translation>Pulse las teclas que tendrá la orden seleccionada. El tabulador pasa al campo siguiente.</translation>
    </message>
    <message>
        <source>Takes the keys from the selected command.</source>
        <translation>Quita las teclas de la orden seleccionada.</translation>
    </message>
    <message>
        <source>Gives the selected command the keys that it has without your choice.</source>
        <translation>Devuelve a la orden seleccionada las teclas que tiene de fábrica.</translation>
    </message>
    <message>
        <source>Gives these keys to the selected command, and its present ones to the other.</source>
        <translation>Da estas teclas a la orden seleccionada y las que esta tenía a la otra.</translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”.</source>
        <translation>«%1» pertenece a «%2».</translation>
    </message>
    <message>
        <source>“%1” has no keys now.</source>
        <translation>«%1» ya no tiene teclas.</translation>
    </message>
    <message>
        <source>“%1” has “%2” now.</source>
        <translation>«%1» tiene ahora «%2».</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>Show only the commands whose name, synonyms or keys begin with these words.</source>
        <translation>Muestra solo las órdenes cuyo nombre, sinónimos o teclas empiezan por estas palabras.</translation>
    </message>
    <message>
        <source>The commands of the menus and their keys; your own are bold. Select one to change its keys.</source>
        <translation>Las órdenes de los menús y sus teclas; las suyas están en negrita. Seleccione una para cambiar sus teclas.</translation>
    </message>
</context>
<context>
    <name>view::SliceRows</name>
    <message>
        <source>Slice</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Entero</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Mitad</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Posición del plano</translation>
    </message>
    <message>
        <source>Thickness of the slice</source>
        <translation>Grosor de la rodaja</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Mover el corte</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>Direction of the plane</source>
        <translation>Dirección del plano</translation>
    </message>
    <message>
        <source>Sets the plane perpendicular to an axis or the diagonal; type any other normal in the fields below.</source>
        <translation>Coloca el plano perpendicular a un eje o a la diagonal; los campos de abajo admiten cualquier normal.</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>Perpendicular a X</translation>
    </message>
    <message>
        <source>Across Y</source>
        <translation>Perpendicular a Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>Perpendicular a Z</translation>
    </message>
    <message>
        <source>Across the diagonal</source>
        <translation>Perpendicular a la diagonal</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Según lo escrito</translation>
    </message>
    <message>
        <source>Turn the Slice</source>
        <translation>Girar el corte</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>x of the normal</source>
        <translation>x de la normal</translation>
    </message>
    <message>
        <source>y of the normal</source>
        <translation>y de la normal</translation>
    </message>
    <message>
        <source>z of the normal</source>
        <translation>z de la normal</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Show the Whole Solid</source>
        <translation>Mostrar el sólido entero</translation>
    </message>
    <message>
        <source>Cut the Solid</source>
        <translation>Cortar el sólido</translation>
    </message>
    <message>
        <source>Cuts the picture open by hiding everything in front of a plane, or everything outside a slice. Drag the plane by the handle at its centre.</source>
        <translation>Abre la imagen ocultando todo lo que está delante de un plano o todo lo que está fuera de una rodaja. Arrastre el plano por el tirador de su centro.</translation>
    </message>
    <message>
        <source>The direction perpendicular to the plane</source>
        <translation>La dirección perpendicular al plano</translation>
    </message>
    <message>
        <source>Thin slice</source>
        <translation>Rodaja</translation>
    </message>
</context>
<context>
    <name>view::SnapshotDelegate</name>
    <message>
        <source>Name of the snapshot</source>
        <translation>Nombre de la instantánea</translation>
    </message>
</context>
<context>
    <name>view::SnapshotLook</name>
    <message>
        <source>There is no snapshot to compare with yet. Take one first: Edit, Take Snapshot.</source>
        <translation>Todavía no hay ninguna instantánea con la que comparar. Tome antes una: «Editar», «Tomar una instantánea».</translation>
    </message>
    <message>
        <source>Nothing has changed since “%1”.</source>
        <translation>Nada ha cambiado desde «%1».</translation>
    </message>
    <message>
        <source>“%1” cannot be compared: one is in the plane, the other in space. Click the snapshot to restore it.</source>
        <translation>«%1» no se puede comparar: uno está en el plano y el otro en el espacio. Haga clic en la instantánea para restaurarla.</translation>
    </message>
    <message>
        <source>This is “%1”. Esc returns to the fractal.</source>
        <translation>Esto es «%1». Esc vuelve al fractal.</translation>
    </message>
</context>
<context>
    <name>view::Snapshots</name>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Una entrada que no se pudo leer no tiene instantáneas.</translation>
    </message>
    <message>
        <source>“%1” is the same as the fractal.</source>
        <translation>«%1» ya es igual.</translation>
    </message>
    <message>
        <source>Snapshot %1</source>
        <translation>Instantánea %1</translation>
    </message>
    <message>
        <source>Restore “%1”</source>
        <translation>Restaurar «%1»</translation>
    </message>
    <message>
        <source>“%1” was deleted. To bring it back, use the menu of the panel.</source>
        <translation>«%1» se ha eliminado. El menú del panel la recupera.</translation>
    </message>
    <message>
        <source>Add “%1” as an entry</source>
        <translation>Añadir «%1» como entrada</translation>
    </message>
    <message>
        <source>Added to the file as the entry “%1”.</source>
        <translation>Añadida al archivo como la entrada «%1».</translation>
    </message>
    <message>
        <source>%1 of “%2”</source>
        <comment>snapshot, entry</comment>
        <translation>%1 de «%2»</translation>
    </message>
</context>
<context>
    <name>view::SnapshotsPanel</name>
    <message>
        <source>Snapshots</source>
        <translation>Instantáneas</translation>
    </message>
    <message>
        <source>Snapshots of the fractal</source>
        <translation>Instantáneas del fractal</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Restaurar</translation>
    </message>
    <message>
        <source>Restore the fractal to this snapshot.</source>
        <translation>Dejar el fractal como estaba en esta instantánea.</translation>
    </message>
    <message>
        <source>&amp;Add as Entry</source>
        <translation>&amp;Añadir como entrada</translation>
    </message>
    <message>
        <source>Add the snapshot to the file as an entry of its own, after this one.</source>
        <translation>Añadir la instantánea al archivo como entrada propia, detrás de esta.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>Ca&amp;mbiar nombre</translation>
    </message>
    <message>
        <source>Give the snapshot another name.</source>
        <translation>Dar otro nombre a la instantánea.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Delete the snapshot; the fractal stays as it is.</source>
        <translation>Eliminar la instantánea; el fractal queda como está.</translation>
    </message>
    <message>
        <source>&amp;Bring Back</source>
        <translation>Rec&amp;uperar</translation>
    </message>
    <message>
        <source>Bring back the snapshot that was deleted last.</source>
        <translation>Recuperar la última instantánea eliminada.</translation>
    </message>
    <message>
        <source>shown on the canvas</source>
        <translation>se muestra en el lienzo</translation>
    </message>
    <message>
        <source>the one to compare with</source>
        <translation>aquella con la que se compara</translation>
    </message>
    <message>
        <source>&amp;Bring Back “%1”</source>
        <translation>Rec&amp;uperar «%1»</translation>
    </message>
    <message>
        <source>No snapshots of this fractal yet. Press %1 to keep its state, change it, and press %2 to compare.</source>
        <translation>Todavía no hay instantáneas de este fractal. Pulse %1 para guardar su estado, cámbielo y pulse %2 para comparar.</translation>
    </message>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Una entrada que no se pudo leer no tiene instantáneas.</translation>
    </message>
    <message>
        <source>Click a snapshot to restore it; undo goes back. The arrow keys or a right click select the one to compare with. F2 renames it, Del deletes it.</source>
        <translation>Haga clic en una instantánea para restaurarla; deshacer vuelve atrás. Con las teclas de flecha o un clic derecho se selecciona aquella con la que se compara. F2 le cambia el nombre, Supr la elimina.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept. Click one to restore it, as one step of the history. The frame marks the snapshot that the canvas shows. The B marks the selected snapshot, the one to compare with: the newest, until you select another one with the arrow keys or a right click. Snapshots last until the file is closed; Add as Entry keeps one in the file.</source>
        <translation>Estados de este fractal que guardó. Haga clic en uno para restaurarlo: un paso del historial. El que tiene marco es el que muestra el lienzo. El que lleva una B está seleccionado y es con el que se compara: el más reciente, hasta que seleccione otro con las teclas de flecha o un clic derecho. Las instantáneas duran hasta que se cierra el archivo; «Añadir como entrada» guarda una en el archivo.</translation>
    </message>
</context>
<context>
    <name>view::SoloMap</name>
    <message>
        <source>One map is shown alone. Choose Solo again to show all; the file does not change.</source>
        <translation>Se muestra una sola aplicación. Elija de nuevo Solo para verlas todas; el archivo no cambia.</translation>
    </message>
</context>
<context>
    <name>view::SpaceExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exportar «%1»</translation>
    </message>
    <message>
        <source>OpenSCAD program (.scad)</source>
        <translation>Programa de OpenSCAD (.scad)</translation>
    </message>
    <message>
        <source>A picture as the camera shows it, a watertight mesh that contains the attractor, or the maps as a program for OpenSCAD.</source>
        <translation>Una imagen tal como la muestra la cámara, un cuerpo estanco que contiene el atractor, o las aplicaciones como programa para OpenSCAD.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formato:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Pide el nombre del archivo y lo escribe.</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>Ta&amp;maño:</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Dibuja tantos píxeles a lo largo de cada lado de uno: bordes más suaves.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>Sup&amp;ermuestreo:</translation>
    </message>
    <message>
        <source>Bits per channel. Depths always have 16.</source>
        <translation>Bits por canal. Las profundidades siempre tienen 16.</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>Fondo trans&amp;parente</translation>
    </message>
    <message>
        <source>Makes the surroundings of the solid transparent.</source>
        <translation>Omite lo que rodea al sólido.</translation>
    </message>
    <message>
        <source>For both eyes: two pictures side by side, or one in red and cyan.</source>
        <translation>Para ambos ojos: dos imágenes una al lado de la otra, o una en rojo y cian.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The longest side of the mesh.</source>
        <translation>El lado más largo del cuerpo.</translation>
    </message>
    <message>
        <source>&amp;Longest side:</source>
        <translation>&amp;Lado más largo:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>Res&amp;olución:</translation>
    </message>
    <message>
        <source>Thinner parts are thickened to this, so that they can be printed.</source>
        <translation>Las partes más finas se engrosan hasta aquí para que se puedan imprimir.</translation>
    </message>
    <message>
        <source>Smallest &amp;wall:</source>
        <translation>Pare&amp;d mínima:</translation>
    </message>
    <message>
        <source>Fill closed ca&amp;vities</source>
        <translation>Rellenar ca&amp;vidades cerradas</translation>
    </message>
    <message>
        <source>Fills spaces that are closed off from the outside.</source>
        <translation>Rellena lo que está aislado del exterior.</translation>
    </message>
    <message>
        <source>One multmatrix for each map; open it in OpenSCAD to render it.</source>
        <translation>Un multmatrix por aplicación; ábralo en OpenSCAD para calcularlo.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Depths can be written only as PNG.</source>
        <translation>Las profundidades solo se escriben como PNG.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the file to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Pide un nombre de archivo y crea el archivo cuando le toca, después de los que esperan en el panel Exportaciones. La cola continúa tras reiniciar.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vista del lienzo</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>La vista «%1»</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Encuadre</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Enc&amp;uadre:</translation>
    </message>
    <message>
        <source>A closed surface around the attractor, for a printer.</source>
        <translation>Una superficie cerrada alrededor del atractor, para una impresora.</translation>
    </message>
    <message>
        <source>The whole solid is written, not only the slice.</source>
        <translation>Se escribe el sólido entero, no solo el corte.</translation>
    </message>
    <message>
        <source>Voxels along the longest side: more voxels make finer steps. A solid has at most %1 million voxels and %2 million triangles.</source>
        <translation>Vóxeles a lo largo del lado más largo: escalones más finos, y más de ellos. Un sólido tiene como máximo %1 millones de vóxeles y %2 millones de triángulos.</translation>
    </message>
    <message>
        <source>A solid has no shapes: the file contains its picture in pixels.</source>
        <translation>Un sólido no tiene formas: el archivo contiene su imagen en píxeles.</translation>
    </message>
    <message>
        <source>Stere&amp;o:</source>
        <translation>Es&amp;téreo:</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format. It must end with one of these: %2.</source>
        <translation>El nombre «%1» no indica el formato. Debe terminar en una de estas extensiones: %2.</translation>
    </message>
    <message>
        <source>Include the ca&amp;ge</source>
        <translation>In&amp;cluir la jaula</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Dibuja la jaula encima de la imagen.</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>El atractor completo</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Lo que muestra la imagen: lo que muestra el lienzo, o el atractor con un pequeño margen, mire donde mire el lienzo. Las vistas guardadas también están en la lista.</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 bits por canal</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
        <translation>16 bits por canal, para seguir trabajando con la imagen</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>Profundidad de c&amp;olor:</translation>
    </message>
</context>
<context>
    <name>view::SpaceInput</name>
    <message>
        <source>Rotate Cage</source>
        <translation>Girar la jaula</translation>
    </message>
    <message>
        <source>Scale Cage</source>
        <translation>Escalar la jaula</translation>
    </message>
    <message>
        <source>Move Vertex %1</source>
        <translation>Mover el vértice %1</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Mover el corte</translation>
    </message>
    <message>
        <source>Move Face %1</source>
        <translation>Mover la cara %1</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Mover el centro de la simetría</translation>
    </message>
</context>
<context>
    <name>view::SpaceRows</name>
    <message>
        <source>Look</source>
        <translation>Estilo</translation>
    </message>
    <message>
        <source>A lit solid, the density of its points, or data for other programs.</source>
        <translation>Un sólido iluminado, la densidad de sus puntos, o números para otros programas.</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Piedra</translation>
    </message>
    <message>
        <source>A solid lit by a lamp that you can move</source>
        <translation>Un sólido a la luz de una lámpara que se puede mover</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinta</translation>
    </message>
    <message>
        <source>A solid with dark creases on paper, for print</source>
        <translation>Un sólido con pliegues oscuros sobre papel, para imprimir</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Nube</translation>
    </message>
    <message>
        <source>The density of points, as in the plane</source>
        <translation>La densidad de puntos, como en el plano</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Rayos X</translation>
    </message>
    <message>
        <source>The density of points, coloured by their mean depth</source>
        <translation>La densidad de puntos, coloreada según su profundidad media</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Near white, far black</source>
        <translation>Cerca blanco, lejos negro</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normales</translation>
    </message>
    <message>
        <source>The direction of the surface as a colour, for compositing</source>
        <translation>La dirección de la superficie como color, para composición</translation>
    </message>
    <message>
        <source>Look: %1</source>
        <translation>Estilo: %1</translation>
    </message>
    <message>
        <source>Colour of the solid by</source>
        <translation>Color del sólido según</translation>
    </message>
    <message>
        <source>What the colour of the surface shows.</source>
        <translation>Lo que muestra el color de la superficie.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Liso</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Un solo color</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Aplicación</translation>
    </message>
    <message>
        <source>The colour of the map whose piece it is</source>
        <translation>El color de la aplicación a cuya pieza pertenece</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>The palette along the addresses</source>
        <translation>La paleta a lo largo de las direcciones</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>The palette from bottom to top</source>
        <translation>La paleta de abajo arriba</translation>
    </message>
    <message>
        <source>The palette from near to far</source>
        <translation>La paleta de cerca a lejos</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Colorear según: %1</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colorear por</translation>
    </message>
    <message>
        <source>The direction of the light as seen by the camera; in the middle, it shines from the camera.</source>
        <translation>Dónde está la lámpara vista desde el ojo: en el centro es el propio ojo.</translation>
    </message>
    <message>
        <source>Light: %1°, %2°</source>
        <translation>Luz: %1°, %2°</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Niebla</translation>
    </message>
    <message>
        <source>How fast colours fade with depth</source>
        <translation>Con qué rapidez se desvanecen los colores con la profundidad</translation>
    </message>
    <message>
        <source>Fog: %1</source>
        <translation>Niebla: %1</translation>
    </message>
</context>
<context>
    <name>view::SpaceView</name>
    <message>
        <source>Canvas in space</source>
        <translation>Lienzo en el espacio</translation>
    </message>
    <message>
        <source>The solid and its tetrahedron. Drag a corner: X, Y or Z keeps it on an axis, with Shift in a plane, and the wheel pushes it away. Drag anywhere else to turn the view; the wheel zooms at the pointer, the middle button pans. Double-click the solid to turn about that point.</source>
        <translation>El sólido y su tetraedro. Arrastre una esquina: X, Y o Z la mantiene en un eje, con Mayús en un plano, y la rueda la aleja. Arrastre en otro lugar para girar la vista; la rueda amplía en el puntero y el botón central desplaza. Haga doble clic en el sólido para girar alrededor de ese punto.</translation>
    </message>
    <message>
        <source>Vertex %1 at %2, %3, %4</source>
        <translation>Vértice %1 en %2, %3, %4</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Ajustar la vista</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>&amp;Perspectiva</translation>
    </message>
    <message>
        <source>Look from the F&amp;ront</source>
        <translation>Mirar desde el f&amp;rente</translation>
    </message>
    <message>
        <source>Look from the &amp;Right</source>
        <translation>Mirar desde la &amp;derecha</translation>
    </message>
    <message>
        <source>Look from &amp;Above</source>
        <translation>Mirar desde &amp;arriba</translation>
    </message>
    <message>
        <source>Canvas in space: %1</source>
        <translation>Lienzo en el espacio: %1</translation>
    </message>
    <message>
        <source>Map %5, corner %1 at %2, %3, %4</source>
        <translation>Aplicación %5, esquina %1 en %2, %3, %4</translation>
    </message>
    <message>
        <source>Corner %1 of the branch at %2, %3, %4</source>
        <translation>Esquina %1 de la rama en %2, %3, %4</translation>
    </message>
    <message>
        <source>Map %4, its middle at %1, %2, %3</source>
        <translation>Aplicación %4, su centro en %1, %2, %3</translation>
    </message>
    <message>
        <source>The middle of the branch at %1, %2, %3</source>
        <translation>El centro de la rama en %1, %2, %3</translation>
    </message>
    <message>
        <source>The attractor and its control tetrahedron. Tab moves from corner to corner and to the ball of axes, the arrow keys move the corner in focus or turn the view, F6 leaves the canvas.</source>
        <translation>El atractor y su tetraedro de control. Tab pasa de esquina en esquina y a la bola de los ejes, las flechas mueven la esquina enfocada o giran la vista, F6 sale del lienzo.</translation>
    </message>
    <message>
        <source>Ball of axes, positive end of %1.</source>
        <translation>Bola de los ejes, extremo positivo de %1.</translation>
    </message>
    <message>
        <source>Ball of axes, negative end of %1.</source>
        <translation>Bola de los ejes, extremo negativo de %1.</translation>
    </message>
    <message>
        <source>The view looks from there; Enter looks from behind.</source>
        <translation>La vista mira desde ahí; Intro mira desde detrás.</translation>
    </message>
    <message>
        <source>Enter looks from there, the arrow keys choose another end.</source>
        <translation>Intro mira desde ahí, las flechas eligen otro extremo.</translation>
    </message>
</context>
<context>
    <name>view::StartShapeBox</name>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Desde</translation>
    </message>
    <message>
        <source>The Cage</source>
        <translation>La jaula</translation>
    </message>
    <message>
        <source>A Square</source>
        <translation>Un cuadrado</translation>
    </message>
    <message>
        <source>A Letter</source>
        <translation>Una letra</translation>
    </message>
    <message>
        <source>A Picture…</source>
        <translation>Una imagen…</translation>
    </message>
    <message>
        <source>What the steps start from</source>
        <translation>De qué parten los pasos</translation>
    </message>
    <message>
        <source>What the steps start from. Whatever you choose, the images get closer to the same attractor: a square, a letter that you type, or the dark shape in a picture, each as large as the attractor.</source>
        <translation>De qué parten los pasos. Elija lo que elija, las imágenes se acercan al mismo atractor: un cuadrado, una letra que escriba o la forma oscura de una imagen, siempre tan grandes como el atractor.</translation>
    </message>
    <message>
        <source>Letters to start from</source>
        <translation>Letras iniciales</translation>
    </message>
    <message>
        <source>One letter, or up to three</source>
        <translation>Una letra, o hasta tres</translation>
    </message>
    <message>
        <source>The letter that the steps start from, or up to three letters. One that is not symmetric, such as R, shows how the maps turn and reflect.</source>
        <translation>La letra de la que parten los pasos, o hasta tres. Una sin simetría, como la R, muestra cómo giran y reflejan las aplicaciones.</translation>
    </message>
    <message>
        <source>Choose a Picture to Start From</source>
        <translation>Elegir la imagen inicial</translation>
    </message>
</context>
<context>
    <name>view::StepsBridge</name>
    <message>
        <source>The picture has no dark shape on a light background.</source>
        <translation>La imagen no contiene ninguna forma oscura sobre fondo claro.</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>No se pudo leer la imagen.</translation>
    </message>
</context>
<context>
    <name>view::StoringReport</name>
    <message>
        <source>The settings cannot be saved: “%1” is not writable, or the disk is full.</source>
        <translation>Los ajustes no se pueden guardar: no se puede escribir en «%1» o el disco está lleno.</translation>
    </message>
</context>
<context>
    <name>view::StretchDialog</name>
    <message>
        <source>From frame</source>
        <translation>Desde el fotograma</translation>
    </message>
    <message>
        <source>Keys up to this frame stay where they are.</source>
        <translation>Las claves hasta este fotograma quedan donde están.</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>Hasta el fotograma</translation>
    </message>
    <message>
        <source>The end of the range. Later keys keep their distance to it.</source>
        <translation>El final del intervalo. Las claves posteriores conservan su distancia a él.</translation>
    </message>
    <message>
        <source>Ends at frame</source>
        <translation>Termina en el fotograma</translation>
    </message>
    <message>
        <source>Where the range ends from now on: later for slower, earlier for faster.</source>
        <translation>Dónde termina ahora el intervalo: más tarde para ir más lento, antes para ir más rápido.</translation>
    </message>
    <message>
        <source>Stretch Keys</source>
        <translation>Estirar claves</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>&amp;Stretch</source>
        <translation>&amp;Estirar</translation>
    </message>
    <message>
        <source>Moves the keys of all tracks, in one step that you can undo.</source>
        <translation>Mueve las claves de todas las pistas en un solo paso que puede deshacer.</translation>
    </message>
    <message>
        <source>&amp;From frame:</source>
        <translation>&amp;Desde el fotograma:</translation>
    </message>
    <message>
        <source>&amp;To frame:</source>
        <translation>&amp;Hasta el fotograma:</translation>
    </message>
    <message>
        <source>&amp;Ends at frame:</source>
        <translation>&amp;Termina en el fotograma:</translation>
    </message>
    <message>
        <source>The range has to end after its first frame.</source>
        <translation>El intervalo debe terminar después de su primer fotograma.</translation>
    </message>
    <message>
        <source>Two keys would meet at one frame, or the animation would be too long.</source>
        <translation>Dos claves coincidirían en un fotograma, o la animación sería demasiado larga.</translation>
    </message>
    <message>
        <source>Stretch keys</source>
        <translation>Estirar claves</translation>
    </message>
</context>
<context>
    <name>view::SuggestionList</name>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n aplicación</numerusform>
            <numerusform>%n aplicaciones</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean distance %1 px</source>
        <translation>Distancia media %1 px</translation>
    </message>
    <message>
        <source>Overlap %1 %</source>
        <translation>Solapamiento %1 %</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Sugerencias</translation>
    </message>
    <message>
        <source>Click a suggestion to use it; undo goes back</source>
        <translation>Haga clic en una sugerencia para usarla; deshacer la retira</translation>
    </message>
    <message>
        <source>Guaranteed within %1 px</source>
        <translation>Garantizado a menos de %1 px</translation>
    </message>
</context>
<context>
    <name>view::SymmetryRow</name>
    <message>
        <source>Symmetry</source>
        <translation>Simetría</translation>
    </message>
    <message>
        <source>Repeat every map under a group of rotations or mirror images</source>
        <translation>Repetir cada aplicación bajo un grupo de rotaciones o reflexiones</translation>
    </message>
    <message>
        <source>With a symmetry, each map of the list also acts rotated or mirrored about the centre, so the fractal is symmetric. The copies are not listed; Expand lists them. On the canvas, drag the handle of the centre.</source>
        <translation>Con una simetría, cada aplicación de la lista actúa también girada o reflejada respecto al centro, de modo que el fractal es simétrico. Las copias no aparecen en la lista; «Desplegar» las añade. En el lienzo, arrastre el tirador del centro.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Orden de la simetría</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Cuántas veces se repite el fractal en una vuelta completa</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Desplegar</translation>
    </message>
    <message>
        <source>Expand the symmetry</source>
        <translation>Desplegar la simetría</translation>
    </message>
    <message>
        <source>Writes the copies that the symmetry makes into the list, as maps of their own, so that you can change them individually. The picture stays the same.</source>
        <translation>Escribe en la lista las copias que crea la simetría como aplicaciones propias, para poder cambiar una sola. La imagen no cambia.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Centro x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Centro y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Centro z</translation>
    </message>
    <message>
        <source>Centre of the symmetry, x</source>
        <translation>Centro de la simetría, x</translation>
    </message>
    <message>
        <source>Centre of the symmetry, y</source>
        <translation>Centro de la simetría, y</translation>
    </message>
    <message>
        <source>Centre of the symmetry, z</source>
        <translation>Centro de la simetría, z</translation>
    </message>
    <message>
        <source>The point that the symmetry leaves unchanged</source>
        <translation>El punto que la simetría deja en su sitio</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Mover el centro de la simetría</translation>
    </message>
    <message>
        <source>Angle of the mirror</source>
        <translation>Ángulo del espejo</translation>
    </message>
    <message>
        <source>Direction of a mirror, in degrees counter-clockwise</source>
        <translation>Dirección de un espejo, en grados en sentido antihorario</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Ángulo °</translation>
    </message>
    <message>
        <source>Turn the mirrors of the symmetry</source>
        <translation>Girar los espejos de la simetría</translation>
    </message>
    <message>
        <source>List the maps that the symmetry stands for</source>
        <translation>Listar las aplicaciones que representa la simetría</translation>
    </message>
    <message>
        <source>Remove the symmetry</source>
        <translation>Quitar la simetría</translation>
    </message>
    <message>
        <source>Set the symmetry</source>
        <translation>Establecer la simetría</translation>
    </message>
</context>
<context>
    <name>view::SymmetryTool</name>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Mover el centro de la simetría</translation>
    </message>
</context>
<context>
    <name>view::TargetBox</name>
    <message>
        <source>Only maps that contract give a shape to trace.</source>
        <translation>Solo las aplicaciones que contraen dan una forma que calcar.</translation>
    </message>
    <message>
        <source>The attractor is a single point.</source>
        <translation>El atractor es un solo punto.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Elegir</translation>
    </message>
    <message>
        <source>Choose the picture that the fractal should look like</source>
        <translation>Elegir la imagen a la que debe parecerse el fractal</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Imagen…</translation>
    </message>
    <message>
        <source>Entry of This File</source>
        <translation>Entrada de este archivo</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Use the picture on the clipboard</source>
        <translation>Usar la imagen del portapapeles</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Shape:</source>
        <translation>Forma:</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Trace the background instead</source>
        <translation>Calcar el fondo en su lugar</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Umbral</translation>
    </message>
    <message>
        <source>The shade up to which a pixel belongs to the shape</source>
        <translation>El tono hasta el que un píxel pertenece a la forma</translation>
    </message>
    <message>
        <source>Threshold:</source>
        <translation>Umbral:</translation>
    </message>
    <message>
        <source>Automatic threshold</source>
        <translation>Umbral automático</translation>
    </message>
    <message>
        <source>Find the threshold that best separates dark from light (Otsu)</source>
        <translation>Separar lo oscuro de lo claro tan bien como puede un umbral (Otsu)</translation>
    </message>
    <message>
        <source>Opacity of the target</source>
        <translation>Opacidad del objetivo</translation>
    </message>
    <message>
        <source>How strongly the target is shown on the canvas</source>
        <translation>Con qué intensidad se muestra el objetivo en el lienzo</translation>
    </message>
    <message>
        <source>Opacity:</source>
        <translation>Opacidad:</translation>
    </message>
    <message>
        <source>Crop to Shape</source>
        <translation>Recortar a la forma</translation>
    </message>
    <message>
        <source>Use only the part around the shape</source>
        <translation>Usar solo la parte que rodea la forma</translation>
    </message>
    <message>
        <source>Whole Picture</source>
        <translation>Imagen completa</translation>
    </message>
    <message>
        <source>Use the whole picture again</source>
        <translation>Volver a usar toda la imagen</translation>
    </message>
    <message>
        <source>There is no picture on the clipboard.</source>
        <translation>No hay ninguna imagen en el portapapeles.</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Imagen pegada</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Leyendo «%1»…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>No se pudo leer la imagen.</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels</source>
        <translation>%1, %2 × %3 píxeles</translation>
    </message>
    <message>
        <source>Choose, paste or drop a picture on the window.</source>
        <translation>Elija o pegue una imagen, o suéltela en la ventana.</translation>
    </message>
    <message>
        <source>With these settings, the shape is empty or fills the picture.</source>
        <translation>Con estos ajustes, la forma está vacía o llena la imagen.</translation>
    </message>
    <message>
        <source>Remove the target and work without one</source>
        <translation>Quitar el objetivo y trabajar sin él</translation>
    </message>
    <message>
        <source>Dark pixels</source>
        <translation>Píxeles oscuros</translation>
    </message>
    <message>
        <source>Opaque pixels</source>
        <translation>Píxeles opacos</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape</source>
        <translation>Qué píxeles pertenecen a la forma</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape. Automatic takes the opaque pixels if any part of the picture is transparent, otherwise the dark ones.</source>
        <translation>Qué píxeles pertenecen a la forma. En automático, los opacos si la imagen tiene alguna transparencia y, si no, los oscuros.</translation>
    </message>
    <message>
        <source>%1, reduced to %2 × %3 pixels</source>
        <translation>%1, reducida a %2 × %3 píxeles</translation>
    </message>
    <message>
        <source>The target is not saved with the file. It is kept while the file is open.</source>
        <translation>El objetivo no se guarda con el archivo. Se conserva mientras el archivo está abierto.</translation>
    </message>
    <message>
        <source>Choose a Picture</source>
        <translation>Elegir una imagen</translation>
    </message>
</context>
<context>
    <name>view::TargetPreview</name>
    <message>
        <source>Preview of the target</source>
        <translation>Vista previa del objetivo</translation>
    </message>
    <message>
        <source>Drag a rectangle to crop the picture; double-click to use all of it</source>
        <translation>Arrastre un rectángulo para recortar la imagen; haga doble clic para usarla entera</translation>
    </message>
</context>
<context>
    <name>view::TheftExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Exportar «%1»</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the picture. You can keep working in the meantime.</source>
        <translation>Pide un nombre de archivo y escribe la imagen. Mientras tanto puede seguir trabajando.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>La vista del lienzo</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>El atractor completo</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Encuadre</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin.</source>
        <translation>Lo que muestra la imagen: lo que muestra el lienzo, o el atractor con un margen pequeño, mire donde mire el lienzo.</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>E&amp;ncuadre:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Tamaño:</translation>
    </message>
    <message>
        <source>Export Stolen Picture</source>
        <translation>Exportar la imagen robada</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>The name “%1” does not end with .png. Choose another name.</source>
        <translation>El nombre «%1» no termina en .png. Elija otro nombre.</translation>
    </message>
</context>
<context>
    <name>view::Timeline</name>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Órbita</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Respirar</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Ciclo de la paleta</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Aplicación %1</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Motions need no keys. Select a track first.</source>
        <translation>Los movimientos no necesitan claves. Seleccione antes una pista.</translation>
    </message>
    <message>
        <source>Key of %1 (frame %2)</source>
        <translation>Clave de %1 (fotograma %2)</translation>
    </message>
    <message>
        <source>Keys of all tracks (frame %1)</source>
        <translation>Claves de todas las pistas (fotograma %1)</translation>
    </message>
    <message>
        <source>Delete keys</source>
        <translation>Eliminar claves</translation>
    </message>
    <message>
        <source>Delete the motion “%1”</source>
        <translation>Eliminar el movimiento «%1»</translation>
    </message>
    <message>
        <source>Copy keys</source>
        <translation>Copiar claves</translation>
    </message>
    <message>
        <source>Move keys and all later ones</source>
        <translation>Mover claves y todas las posteriores</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Mover claves</translation>
    </message>
    <message>
        <source>None of these keys fits this fractal.</source>
        <translation>Ninguna de estas claves encaja en este fractal.</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Pegar claves</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Slow Start and End</source>
        <translation>Lento al principio y al final</translation>
    </message>
    <message>
        <source>Slow Start</source>
        <translation>Lento al principio</translation>
    </message>
    <message>
        <source>Slow End</source>
        <translation>Lento al final</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Mantener</translation>
    </message>
    <message>
        <source>Ease to the Next Key</source>
        <translation>Transición a la clave siguiente</translation>
    </message>
    <message>
        <source>Copy Keys</source>
        <translation>Copiar claves</translation>
    </message>
    <message>
        <source>Paste Keys at the Playhead</source>
        <translation>Pegar claves en el cabezal</translation>
    </message>
    <message>
        <source>Delete Keys</source>
        <translation>Eliminar claves</translation>
    </message>
    <message>
        <source>Key at the Playhead</source>
        <translation>Clave en el cabezal</translation>
    </message>
    <message>
        <source>Delete the Motion</source>
        <translation>Eliminar el movimiento</translation>
    </message>
    <message>
        <source>Custom…</source>
        <translation>Propia…</translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) beyond the new end deleted. Undo brings them back.</source>
        <translation>
            <numerusform>%n clave más allá del nuevo final eliminada. Deshacer la recupera.</numerusform>
            <numerusform>%n claves más allá del nuevo final eliminadas. Deshacer las recupera.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) not pasted: beyond the end of the animation, or of a part that this fractal does not have.</source>
        <translation>
            <numerusform>%n clave no pegada: más allá del final de la animación, o de una parte que este fractal no tiene.</numerusform>
            <numerusform>%n claves no pegadas: más allá del final de la animación, o de una parte que este fractal no tiene.</numerusform>
        </translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Ease of keys (frame %1)</source>
        <translation>Transición de claves (fotograma %1)</translation>
    </message>
    <message>
        <source>Ease of keys (frames %1–%2)</source>
        <translation>Transición de claves (fotogramas %1–%2)</translation>
    </message>
    <message>
        <source>Edit the Motion…</source>
        <translation>Editar el movimiento…</translation>
    </message>
    <message>
        <source>Branch %1, inside itself</source>
        <translation>Rama %1, dentro de sí misma</translation>
    </message>
    <message>
        <source>Stretch Keys…</source>
        <translation>Estirar claves…</translation>
    </message>
</context>
<context>
    <name>view::TimelinePanel</name>
    <message>
        <source>Breeze</source>
        <translation>Brisa</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Ráfagas</translation>
    </message>
    <message>
        <source>Storm</source>
        <translation>Tormenta</translation>
    </message>
    <message>
        <source>Under Water</source>
        <translation>Bajo el agua</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Calma</translation>
    </message>
    <message>
        <source>Add Motion</source>
        <translation>Añadir movimiento</translation>
    </message>
    <message>
        <source>Add a motion that needs no keys, or a morph to another entry</source>
        <translation>Añadir un movimiento que no necesita claves o una transformación en otra entrada</translation>
    </message>
    <message>
        <source>Add &amp;Motion</source>
        <translation>Añadir &amp;movimiento</translation>
    </message>
    <message>
        <source>It is one step of the history.</source>
        <translation>Es un paso del historial.</translation>
    </message>
    <message>
        <source>There are no maps to move.</source>
        <translation>No hay aplicaciones que mover.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>All branches sway about their roots.</source>
        <translation>Todas las ramas oscilan en torno a donde empiezan.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Each map turns once in its place.</source>
        <translation>Las aplicaciones giran una vez en su lugar.</translation>
    </message>
    <message>
        <source>Turn the maps</source>
        <translation>Girar las aplicaciones</translation>
    </message>
    <message>
        <source>No map can turn without losing the attractor.</source>
        <translation>Ninguna aplicación puede girar sin perder el atractor.</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Órbita</translation>
    </message>
    <message>
        <source>The whole picture turns once.</source>
        <translation>Toda la imagen da una vuelta.</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Respirar</translation>
    </message>
    <message>
        <source>The maps swell and shrink.</source>
        <translation>Las aplicaciones crecen y menguan.</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Ciclo de la paleta</translation>
    </message>
    <message>
        <source>The colours run through the palette and back.</source>
        <translation>Los colores recorren la paleta y vuelven.</translation>
    </message>
    <message>
        <source>Cycle the palette</source>
        <translation>Recorrer la paleta</translation>
    </message>
    <message>
        <source>Zoom In Endlessly</source>
        <translation>Acercar sin fin</translation>
    </message>
    <message>
        <source>The view moves into a small copy of the whole; the last frame matches the first.</source>
        <translation>La vista entra en una pequeña copia del conjunto, donde el último fotograma es el primero.</translation>
    </message>
    <message>
        <source>Zoom in endlessly</source>
        <translation>Acercar sin fin</translation>
    </message>
    <message>
        <source>No map makes a scaled copy of the fractal that is clear of the others.</source>
        <translation>Ninguna aplicación se limita a reducir el fractal a una copia separada de las demás.</translation>
    </message>
    <message>
        <source>Morph To</source>
        <translation>Transformar en</translation>
    </message>
    <message>
        <source>The fractal becomes another entry of this file, and returns.</source>
        <translation>El fractal se convierte en otra entrada de este archivo y vuelve.</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Viento: %1</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension</source>
        <translation>Este archivo no tiene otro fractal de esta dimensión</translation>
    </message>
    <message>
        <source>Morph to %1</source>
        <translation>Transformar en %1</translation>
    </message>
    <message>
        <source>Trying the motion…</source>
        <translation>Probando el movimiento…</translation>
    </message>
    <message>
        <source>Choose &amp;Pairs…</source>
        <translation>Elegir &amp;parejas…</translation>
    </message>
    <message>
        <source>Shows which map becomes which, and lets you pin pairs.</source>
        <translation>Muestra qué aplicación se convierte en cuál y permite fijar parejas.</translation>
    </message>
    <message>
        <source>Pairing the maps…</source>
        <translation>Emparejando las aplicaciones…</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Fotograma sin atractor</translation>
    </message>
    <message>
        <source>Steady Sway</source>
        <translation>Vaivén regular</translation>
    </message>
</context>
<context>
    <name>view::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation>Opciones de la herramienta</translation>
    </message>
    <message>
        <source>Drag a corner, an edge or the inside of the cage.  Ctrl rotates  ·  Alt scales  ·  Shift keeps directions  ·  double-click an edge for a new corner</source>
        <translation>Arrastre un vértice, una arista o el interior de la jaula.  Ctrl gira  ·  Alt escala  ·  Mayús conserva las direcciones  ·  doble clic en una arista: vértice nuevo</translation>
    </message>
    <message>
        <source>Click the three corners of the new triangle.  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Haga clic en los tres vértices del triángulo nuevo.  Retroceso quita el último punto  ·  Esc cancela</translation>
    </message>
    <message>
        <source>Click the four corners of the new tetrahedron, the fourth in front of the others.  The wheel pushes it away  ·  right-drag turns the view  ·  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Haga clic en los cuatro vértices del nuevo tetraedro, el cuarto delante de los demás.  La rueda lo aleja  ·  arrastrar con el botón derecho gira la vista  ·  Retroceso quita el último punto  ·  Esc cancela</translation>
    </message>
    <message>
        <source>Drag a corner or a face of the cage.  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Arrastre un vértice o una cara de la jaula.  X, Y, Z conservan un eje  ·  Ctrl gira  ·  Alt escala  ·  arrastre en otra parte para girar la vista</translation>
    </message>
    <message>
        <source>Click a corner of a map to select it, Shift+click for more.  Drag its corners or its middle  ·  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Haga clic en un vértice de una aplicación para seleccionarla, Mayús+clic para más.  Arrastre sus vértices o su centro  ·  X, Y, Z conservan un eje  ·  Ctrl gira  ·  Alt escala  ·  arrastre en otra parte para girar la vista</translation>
    </message>
    <message>
        <source>Side by side, the fractal can be turned and zoomed.  To change it, switch stereo off.</source>
        <translation>Lado a lado, el fractal se puede girar y ampliar.  Para cambiarlo, desactive el estéreo.</translation>
    </message>
</context>
<context>
    <name>view::ToolbarPage</name>
    <message>
        <source>Move &amp;Up</source>
        <translation>&amp;Subir</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>&amp;Bajar</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>Commands in the toolbar</source>
        <translation>Órdenes de la barra de herramientas</translation>
    </message>
    <message>
        <source>The toolbar from left to right. Drag a command to move it.</source>
        <translation>La barra de herramientas de izquierda a derecha. Arrastre una orden para moverla.</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Elija una orden</translation>
    </message>
    <message>
        <source>Command to add</source>
        <translation>Orden que se añade</translation>
    </message>
    <message>
        <source>Adds a command of the menus, or a separator, after the selected one.</source>
        <translation>Añade una orden de los menús, o un separador, después de la seleccionada.</translation>
    </message>
    <message>
        <source>&amp;Add:</source>
        <translation>Aña&amp;dir:</translation>
    </message>
    <message>
        <source>Moves the selected command towards the left end of the toolbar.</source>
        <translation>Mueve la orden seleccionada hacia el extremo izquierdo de la barra de herramientas.</translation>
    </message>
    <message>
        <source>Moves the selected command towards the right end of the toolbar.</source>
        <translation>Mueve la orden seleccionada hacia el extremo derecho de la barra de herramientas.</translation>
    </message>
    <message>
        <source>Takes the selected command out of the toolbar. It stays in its menu.</source>
        <translation>Quita la orden seleccionada de la barra de herramientas. Permanece en su menú.</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Separador</translation>
    </message>
</context>
<context>
    <name>view::TrackView</name>
    <message>
        <source>Tracks and keys</source>
        <translation>Pistas y claves</translation>
    </message>
    <message>
        <source>Unit of the ruler</source>
        <translation>Unidad de la regla</translation>
    </message>
    <message>
        <source>Switch the ruler between frames and seconds</source>
        <translation>Cambiar la regla entre fotogramas y segundos</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Segundos</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, fotograma %2</translation>
    </message>
    <message>
        <source>, key</source>
        <translation>, clave</translation>
    </message>
    <message>
        <source>, keys in this row: %1</source>
        <translation>, claves en esta fila: %1</translation>
    </message>
    <message>
        <source>One row for each part that can move. The diamond on the left sets a key at the playhead, or deletes it. Drag keys to move them: Alt moves all later ones too, Ctrl copies. Drag in the ruler to move the playhead, or from an empty area to select keys. Ctrl + wheel zooms. Right-click a key for its ease. Round keys are smooth: the motion runs through them without a corner. Double-click a motion to change its strength or number of turns.</source>
        <translation>Una fila por cada parte que puede moverse. El rombo de delante crea una clave en el cabezal o la elimina. Arrastre claves para moverlas: Alt mueve también las posteriores, Ctrl las copia. Arrastre en la regla para mover el cabezal, o desde un lugar vacío para seleccionar claves. Ctrl + rueda amplía. Clic derecho en una clave para su transición. Las claves redondas son suaves: el movimiento pasa por ellas sin esquinas. Haga doble clic en un movimiento para cambiar su intensidad o su número de vueltas.</translation>
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
        <translation>Transformar</translation>
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
        <source>Applied in this order, from top to bottom.</source>
        <translation>Se aplica en este orden, de arriba abajo.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problema</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Reset all values to what they were when the dialog opened</source>
        <translation>Todos los valores como estaban al abrir el diálogo</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Colocar la imagen</translation>
    </message>
    <message>
        <source>The cage moves; the code does not change</source>
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
        <source>Fixed point</source>
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
        <source>a point of your choice</source>
        <translation>un punto dado por sus coordenadas</translation>
    </message>
    <message>
        <source>in the line at the angle (°)</source>
        <translation>en la recta de ángulo °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Ángulo de la recta de reflexión en grados: 0 es horizontal, 90 vertical</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Esta entrada no tiene aplicaciones del plano.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be inverted, so it cannot be written into the code. Choose other scales, or place the picture.</source>
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
        <source>The point about which the fractal is rotated, scaled and reflected; it stays where it is.</source>
        <translation>Respecto de qué punto se gira, se escala y se refleja el fractal: ese punto queda donde está.</translation>
    </message>
    <message>
        <source>Reflects in a line through the fixed point; the angle is measured from the x axis.</source>
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
        <source>the centre of the picture’s box</source>
        <translation>el centro del rectángulo de la imagen</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Reflects, shears, scales, rotates and translates the whole fractal by numbers.</source>
        <translation>Refleja, inclina, escala, gira y traslada todo el fractal según números.</translation>
    </message>
    <message>
        <source>z of the fixed point</source>
        <translation>z del punto fijo</translation>
    </message>
    <message>
        <source>Scale in z</source>
        <translation>Escala en z</translation>
    </message>
    <message>
        <source>Axis:</source>
        <translation>Eje:</translation>
    </message>
    <message>
        <source>x of the direction of the axis</source>
        <translation>x de la dirección del eje</translation>
    </message>
    <message>
        <source>y of the direction of the axis</source>
        <translation>y de la dirección del eje</translation>
    </message>
    <message>
        <source>z of the direction of the axis</source>
        <translation>z de la dirección del eje</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise as seen from the tip of the axis</source>
        <translation>Giro en grados, en sentido antihorario visto desde la punta del eje</translation>
    </message>
    <message>
        <source>Translation in z</source>
        <translation>Traslación en z</translation>
    </message>
    <message>
        <source>Same in x, y and z</source>
        <translation>Igual en x, en y y en z</translation>
    </message>
    <message>
        <source>Keeps the factors in x, y and z equal.</source>
        <translation>Mantiene iguales los factores en x, en y y en z.</translation>
    </message>
    <message>
        <source>Axis of the rotation</source>
        <translation>Eje del giro</translation>
    </message>
    <message>
        <source>The axis of the rotation; it passes through the fixed point.</source>
        <translation>El eje del giro; pasa por el punto fijo.</translation>
    </message>
    <message>
        <source>the x axis</source>
        <translation>el eje x</translation>
    </message>
    <message>
        <source>the y axis</source>
        <translation>el eje y</translation>
    </message>
    <message>
        <source>the z axis</source>
        <translation>el eje z</translation>
    </message>
    <message>
        <source>a direction of your choice</source>
        <translation>una dirección dada por sus coordenadas</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Esta entrada no es un sistema en el espacio.</translation>
    </message>
    <message>
        <source>The axis has no direction.</source>
        <translation>El eje no tiene dirección.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so only a transformation that scales alike in all directions can be written into the code. Choose equal scales, or place the picture.</source>
        <translation>La jaula curva la imagen, así que solo una transformación que escala igual en todas las direcciones puede escribirse en el código. Elija escalas iguales o coloque la imagen.</translation>
    </message>
</context>
<context>
    <name>view::TransformationBar</name>
    <message>
        <source>Partner</source>
        <translation>Pareja</translation>
    </message>
    <message>
        <source>The entry on which the picture is placed</source>
        <translation>La entrada sobre la que está la imagen</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>What the fractal transformation does with the picture</source>
        <translation>Qué hace la transformación fractal con la imagen</translation>
    </message>
    <message>
        <source>Fractal transformation</source>
        <translation>Transformación fractal</translation>
    </message>
    <message>
        <source>Steal Colours</source>
        <translation>Robar colores</translation>
    </message>
    <message>
        <source>Transform a Picture</source>
        <translation>Transformar una imagen</translation>
    </message>
    <message>
        <source>Deformation Grid</source>
        <translation>Cuadrícula de deformación</translation>
    </message>
    <message>
        <source>Filter: Reduce</source>
        <translation>Filtro: reducir</translation>
    </message>
    <message>
        <source>Filter: Posterise</source>
        <translation>Filtro: posterizar</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Save the stolen picture as PNG</source>
        <translation>Guardar la imagen robada como PNG</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>The picture on the partner; you can also drop one there</source>
        <translation>La imagen sobre la pareja; también puede soltar una allí</translation>
    </message>
    <message>
        <source>Choose Picture…</source>
        <translation>Elegir imagen…</translation>
    </message>
    <message>
        <source>Colour Wheel</source>
        <translation>Círculo cromático</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Anillos</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Puesta de sol</translation>
    </message>
    <message>
        <source>Starters</source>
        <translation>Inicios</translation>
    </message>
    <message>
        <source>Add two entries with the same addresses, whose parameters you can slide</source>
        <translation>Añadir dos entradas con las mismas direcciones, cuyos parámetros se pueden deslizar</translation>
    </message>
    <message>
        <source>Triangle Family</source>
        <translation>Familia del triángulo</translation>
    </message>
    <message>
        <source>Square Family</source>
        <translation>Familia del cuadrado</translation>
    </message>
    <message>
        <source>%1 →</source>
        <translation>%1 →</translation>
    </message>
    <message>
        <source>The picture on the partner: %1</source>
        <translation>La imagen sobre la pareja: %1</translation>
    </message>
    <message>
        <source>Find Picture…</source>
        <translation>Buscar la imagen…</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Dividir palabras</translation>
    </message>
    <message>
        <source>Choose the current location of the picture</source>
        <translation>Elegir la imagen donde está ahora</translation>
    </message>
    <message>
        <source>Divide maps of both entries into words until both have the same number</source>
        <translation>Dividir aplicaciones de ambas entradas en palabras hasta que tengan las mismas</translation>
    </message>
    <message>
        <source>Stained Glass</source>
        <translation>Vidriera</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Mármol</translation>
    </message>
    <message>
        <source>Tartan</source>
        <translation>Tartán</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Olas</translation>
    </message>
    <message>
        <source>State of the fractal transformation</source>
        <translation>Estado de la transformación fractal</translation>
    </message>
    <message>
        <source>There is no stolen picture yet</source>
        <translation>Aún no hay ninguna imagen robada</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Apilar</translation>
    </message>
    <message>
        <source>Show the two fractals one above the other instead of side by side</source>
        <translation>Mostrar los dos fractales uno encima del otro en vez de uno al lado del otro</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superponer</translation>
    </message>
    <message>
        <source>Show the partner half transparent over the fractal, in the same coordinates</source>
        <translation>Muestra la pareja semitransparente sobre el fractal, en las mismas coordenadas</translation>
    </message>
    <message>
        <source>Embed in the File</source>
        <translation>Incrustar en el archivo</translation>
    </message>
    <message>
        <source>Store the picture itself with the entry, not only its path</source>
        <translation>Guardar con la entrada la imagen misma, no solo su ruta</translation>
    </message>
    <message>
        <source>Stores the picture itself with the entry, so that the file shows it wherever it goes. A picture of more than 128 KB is stored smaller. Otherwise only its path is stored.</source>
        <translation>Guarda con la entrada la imagen misma, de modo que el archivo la muestra vaya donde vaya. Una imagen de más de 128 KB se guarda reducida. Si no, solo se guarda su ruta.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Restablecer el orden</translation>
    </message>
    <message>
        <source>Put the maps back in the order of their numbers</source>
        <translation>Volver a poner las aplicaciones en el orden de sus números</translation>
    </message>
    <message>
        <source>Open It</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open this picture, which is outside the folder of the file</source>
        <translation>Abrir esta imagen, que está fuera de la carpeta del archivo</translation>
    </message>
</context>
<context>
    <name>view::TransformationView</name>
    <message>
        <source>Canvas of the partner</source>
        <translation>Lienzo de la pareja</translation>
    </message>
    <message>
        <source>Choose Partner</source>
        <translation>Elegir pareja</translation>
    </message>
    <message>
        <source>Choose Mode</source>
        <translation>Elegir modo</translation>
    </message>
    <message>
        <source>Choose Picture</source>
        <translation>Elegir imagen</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Dividir palabras</translation>
    </message>
    <message>
        <source>There is no other entry of the plane in this file. Add one, or choose a starter.</source>
        <translation>No hay otra entrada del plano en este archivo. Añada una o elija un inicio.</translation>
    </message>
    <message>
        <source>The partner “%1” is not in this file. Choose another one.</source>
        <translation>La pareja «%1» no está en este archivo. Elija otra.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Add Family</source>
        <translation>Añadir familia</translation>
    </message>
    <message>
        <source>Points of two fractals that have the same address correspond to each other. A picture on the partner is carried over to this fractal in that way.</source>
        <translation>Los puntos de dos fractales que tienen la misma dirección se corresponden. Así se traslada a este fractal una imagen del compañero.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Restablecer el orden</translation>
    </message>
    <message>
        <source>Reorder Overlapping Maps</source>
        <translation>Reordenar las de encima</translation>
    </message>
    <message>
        <source>Do Not Embed Picture</source>
        <translation>No incrustar imagen</translation>
    </message>
    <message>
        <source>Embed Picture</source>
        <translation>Incrustar imagen</translation>
    </message>
    <message>
        <source>The file names a picture outside its folder: %1. Open it only if you trust the file.</source>
        <translation>El archivo nombra una imagen fuera de su carpeta: %1. Ábrala solo si confía en el archivo.</translation>
    </message>
</context>
<context>
    <name>view::TransportBar</name>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>Reproducir la animación</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>The frame that is shown and edited</source>
        <translation>El fotograma que se muestra y se edita</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>The length of the animation in frames</source>
        <translation>Cuántos fotogramas dura la animación</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source>The number of frames played per second</source>
        <translation>Cuántos fotogramas se reproducen por segundo</translation>
    </message>
    <message>
        <source>Previous Key</source>
        <translation>Clave anterior</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Mover el cabezal a la clave anterior</translation>
    </message>
    <message>
        <source>Next Key</source>
        <translation>Clave siguiente</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Mover el cabezal a la clave siguiente</translation>
    </message>
    <message>
        <source>Frame:</source>
        <translation>Fotograma:</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>Duración:</translation>
    </message>
    <message>
        <source>fps:</source>
        <translation>fps:</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Bucle:</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>What happens after the last frame</source>
        <translation>Qué viene después del último fotograma</translation>
    </message>
    <message>
        <source>Off: the animation stops at its last frame. Cycle: it starts again from frame 0. There and Back: it runs backwards to the start.</source>
        <translation>Desactivado: la animación se detiene en su último fotograma. Ciclo: empieza de nuevo, y el fotograma del final es el 0. Ida y vuelta: retrocede hasta el principio.</translation>
    </message>
    <message>
        <source>Off</source>
        <comment>loop</comment>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>There and Back</source>
        <translation>Ida y vuelta</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>The number of frames drawn per second during playback</source>
        <translation>Cuántas imágenes por segundo se dibujan al reproducir</translation>
    </message>
    <message>
        <source>Frames per second: %1</source>
        <translation>Fotogramas por segundo: %1</translation>
    </message>
    <message>
        <source>Loop: %1</source>
        <translation>Bucle: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Stop at this frame</source>
        <translation>Detener en este fotograma</translation>
    </message>
    <message>
        <source>The number of frames played per second: a number or a fraction, such as 24, 12.5 or 30000/1001. 29.97 stands for the latter, the rate of television.</source>
        <translation>Cuántos fotogramas se reproducen por segundo: un número o una fracción, como 24, 12.5 o 30000/1001. 29.97 equivale a esta última, la frecuencia de la televisión.</translation>
    </message>
    <message>
        <source>“%1” is not a frame rate. Enter frames per second, above 0 and at most %2, such as 24, 29.97 or 30000/1001.</source>
        <translation>«%1» no es una frecuencia de fotogramas. Escriba fotogramas por segundo, más de 0 y como máximo %2, por ejemplo 24, 29.97 o 30000/1001.</translation>
    </message>
    <message numerus="yes">
        <source>Length of the animation: %n frame(s)</source>
        <translation>
            <numerusform>Duración de la animación: %n fotograma</numerusform>
            <numerusform>Duración de la animación: %n fotogramas</numerusform>
        </translation>
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
        <source>Problem with the numbers</source>
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
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Mover el vértice %1 a (%2, %3)</translation>
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
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Zoom in percent: 100 % shows a unit of the plane as 100 pixels; type another value, or choose one</source>
        <translation>Zoom en porcentaje: al 100 %, una unidad del plano ocupa 100 píxeles; escriba otro valor o elija uno</translation>
    </message>
    <message>
        <source>Zoom in percent: at 100 %, one unit of the plane is 100 pixels long. Type a number, or choose a value, a saved view, or Fit, which shows the whole attractor.</source>
        <translation>Zoom en porcentaje: al 100 %, una unidad del plano ocupa 100 píxeles. Escriba un número, o elija un valor, una vista guardada o «Ajustar», que muestra el atractor entero.</translation>
    </message>
</context>
</TS>
