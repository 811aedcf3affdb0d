<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="mk" sourcelanguage="en">
<context>
    <name>AccessibleHandle</name>
    <message>
        <source>Move left</source>
        <translation>Помести налево</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>Помести надесно</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Помести нагоре</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Помести надолу</translation>
    </message>
</context>
<context>
    <name>ActionDetails</name>
    <message>
        <source>Drag an edge to move both its ends, the inside to move the whole cage. Ctrl rotates, Alt scales, Shift keeps directions. The fractal follows at once, and each drag is one step of the history.</source>
        <translation>Раб ги поместува двата свои краја, внатрешноста целиот кафез. Ctrl врти, Alt менува големина, Shift ги задржува правците. Фракталот следи веднаш, а секое влечење е еден чекор во историјата.</translation>
    </message>
    <message>
        <source>Each map is shown as the image of the cage in its colour. A corner changes one map; the inside moves all selected maps. A drag stops where the attractor would be lost.</source>
        <translation>Секое пресликување е прикажано како слика на кафезот во своја боја. Теме менува едно пресликување, внатрешноста ги поместува сите избрани. Влечењето запира таму каде што атракторот би се изгубил.</translation>
    </message>
    <message>
        <source>The picture stays where it is and follows the new triangle from now on. Backspace removes the last point, Esc cancels.</source>
        <translation>Сликата останува каде што е: отсега ја држи новиот триаголник. Backspace го враќа последното теме, Esc откажува.</translation>
    </message>
    <message>
        <source>The picture stays where it is. Every point of the fractal then has barycentric coordinates that are not negative.</source>
        <translation>Сликата останува каде што е. Потоа секоја точка на фракталот има барицентрични координати што не се негативни.</translation>
    </message>
    <message>
        <source>The coefficients do not change. To keep the picture as it is and change the coefficients instead, use Bake.</source>
        <translation>Коефициентите не се менуваат. За сликата да остане иста, а да се сменат коефициентите, користете „Впиши во кодот“.</translation>
    </message>
    <message>
        <source>Each map w becomes T w T⁻¹, where T is the affine map from the cage at rest to the current cage. The cage is at rest afterwards. A cage that is flat or bends the picture cannot be baked.</source>
        <translation>Секое пресликување w станува T w T⁻¹, каде што T е она што кафезот ѝ го прави на сликата. Потоа кафезот е во мирување. Рамен кафез или кафез што ја витка сликата не може да се впише.</translation>
    </message>
    <message>
        <source>The table of maps keeps its numbers, and Bake writes the placement into them later.</source>
        <translation>Табелата на пресликувања ги задржува своите броеви, а Впиши во кодот подоцна ја внесува поставеноста.</translation>
    </message>
    <message>
        <source>The table of maps shows the new numbers during the drag, and the cage is at rest again afterwards.</source>
        <translation>Табелата на пресликувања ги покажува новите броеви за време на влечењето, а потоа кафезот пак е во мирување.</translation>
    </message>
    <message>
        <source>The cage is included if that needs little space. The fractal itself does not change.</source>
        <translation>Кафезот е вклучен кога тоа бара малку простор. Самиот фрактал не се менува.</translation>
    </message>
    <message>
        <source>Only the view is flipped: coefficients and coordinates do not change.</source>
        <translation>Се превртува само приказот: коефициентите и координатите не се менуваат.</translation>
    </message>
    <message>
        <source>Press the key again to show the cage, handles, grid, axes and outlines.</source>
        <translation>Кафезот, рачките, мрежата, оските и обрисите се враќаат кога пак ќе го притиснеш копчето.</translation>
    </message>
    <message>
        <source>A bar appears under the canvas: choose the number of steps, or let the chaos game run point by point at any speed.</source>
        <translation>Под платното се појавува лента: изберете број на чекори или пуштете ја играта на хаосот да оди точка по точка со која било брзина.</translation>
    </message>
    <message>
        <source>As a placement, it leaves the coefficients unchanged; as code, it replaces them by those of the transformed fractal. The canvas shows the result before you accept it.</source>
        <translation>Како поставеност, коефициентите остануваат; како код, стануваат коефициенти на трансформираниот фрактал. Платното го покажува резултатот пред да го прифатиш.</translation>
    </message>
    <message>
        <source>A new language takes effect at the next start; everything else at once, in all windows.</source>
        <translation>Новиот јазик важи од следното стартување; сѐ друго веднаш, во сите прозорци.</translation>
    </message>
    <message>
        <source>Choose a motion, which needs no keys, or set keys. A change to something that has keys sets a key at the playhead; any other change applies to the whole animation.</source>
        <translation>Изберете движење за кое не се потребни клучеви или поставете клучеви: она што има клучеви добива уште еден каде и да го измените, а она што нема се менува за целата анимација.</translation>
    </message>
    <message>
        <source>If a table does not name its columns, you are asked for their order. In the Maps panel, Paste adds the copied maps, or rows of numbers, to the fractal.</source>
        <translation>Ако табелата не ги именува колоните, ќе бидете прашани за нивниот редослед. Во панелот „Пресликувања“, „Вметни“ ги додава копираните пресликувања или редиците броеви во фракталот.</translation>
    </message>
    <message>
        <source>Acts on maps while the table of maps, or the canvas with the Maps tool, has the focus, and on entries while the list of entries has it.</source>
        <translation>Одлучува она што е во фокус: табелата со пресликувања и платното со алатката за пресликувања преместуваат пресликувања, а списокот записи записи.</translation>
    </message>
    <message>
        <source>Maps are copied with their names and as rows of numbers, entries as .ifs text that other programs can read.</source>
        <translation>Пресликувањата се копираат со нивните имиња и како редици броеви, а записите како .ifs текст што може да го читаат други програми.</translation>
    </message>
    <message>
        <source>A locked map cannot be edited in the table, dragged, nudged, arranged, fitted or deleted. Changes to the whole fractal, such as a cage that rewrites the code, also change its locked maps.</source>
        <translation>Заклучено пресликување не може да се препишува, влече, поместува, подредува, приспособува или брише. Она што го менува целиот фрактал, како кафез што го препишува кодот, ги менува и неговите заклучени пресликувања.</translation>
    </message>
    <message>
        <source>Draws only the part of the attractor that this map makes. The file does not change. If you select another entry, its whole attractor is shown.</source>
        <translation>Се црта само делот од атракторот што го создава пресликувањето. Датотеката не се менува, а друг запис пак се прикажува цел.</translation>
    </message>
    <message>
        <source>Shift + wheel chooses how deep the branch is. The bar under the canvas says what the drag changes: a new map for this branch, the last map of its address, only this branch, or this branch and the same one inside it.</source>
        <translation>Shift + тркалце избира колку длабока е гранката. Лентата под платното кажува што менува влечењето: ново пресликување за гранката, последното пресликување од нејзината адреса, само оваа гранка, или оваа гранка и истата внатре во неа.</translation>
    </message>
    <message>
        <source>The spacing of its lines follows the zoom. Vertices snap to it if this is chosen under View › Canvas › Snap To.</source>
        <translation>Растојанието меѓу линиите го следи зумот. Темињата се припојуваат на неа ако тоа е избрано во Приказ › Платно › Прилепи кон.</translation>
    </message>
</context>
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Атрактор</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Контракција</translation>
    </message>
    <message>
        <source>‖A‖ of each active map: the largest factor by which it stretches distances.</source>
        <translation>‖A‖ на секое пресликување што учествува: колку пати најмногу ги растегнува растојанијата.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Правоаголник</translation>
    </message>
    <message>
        <source>Canonical simplex</source>
        <translation>Каноничен симплекс</translation>
    </message>
    <message>
        <source>%1, leg %2, corner %3</source>
        <translation>%1, катета %2, теме %3</translation>
    </message>
    <message>
        <source>Similarity dimension</source>
        <translation>Димензија на сличност</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Средна вредност</translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation>Коваријанса</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Неподвижни точки</translation>
    </message>
    <message>
        <source>The point that each map leaves unchanged; it belongs to the attractor.</source>
        <translation>Точката што секое пресликување ја остава на место; таа лежи на атракторот.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Афина димензија</translation>
    </message>
    <message>
        <source>Falconer’s dimension, at most 2: the exponent at which the sum of the singular value functions of all words of one length neither grows nor shrinks as the words get longer. It is an upper bound for the box-counting dimension, and equal to it for almost all translations if the maps contract enough.</source>
        <translation>Димензијата на Фалконер: каде што збирот на функциите на сингуларни вредности на сите зборови со иста должина ниту расте ниту опаѓа, најмногу 2. Горна граница на димензијата со броење кутии и еднаква на неа за речиси сите поместувања кога пресликувањата доволно контрахираат.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Димензија со броење кутии</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Плоштина на обвивката</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Темиња на обвивката</translation>
    </message>
    <message>
        <source>Vertices of the computed hull; each is a point of the attractor. If the exact hull has infinitely many, as many are computed as the tolerance requires.</source>
        <translation>Темиња на конвексната обвивка како што се најдени, секое точка на атракторот. Обвивка со бесконечно многу има онолку колку што бара нејзината толеранција.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Граница на грешката на обвивката</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polygon; certified.</source>
        <translation>Атракторот излегува од многуаголникот најмногу за толку; докажано.</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… и уште %n</numerusform>
            <numerusform>… и уште %n</numerusform>
            <numerusform>… и уште %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Separation</source>
        <translation>Раздвоеност</translation>
    </message>
    <message>
        <source>Whether the pieces that the maps make of the attractor are disjoint (strong separation, proved by disjoint covers), or words of maps coincide, so that the open set condition fails.</source>
        <translation>Дали деловите што пресликувањата ги прават од атракторот се дисјунктни (силна раздвоеност, докажана со дисјунктни покривки) или зборови од пресликувања се совпаѓаат, па условот на отворено множество не важи.</translation>
    </message>
    <message>
        <source>Connectedness</source>
        <translation>Сврзаност</translation>
    </message>
    <message>
        <source>Overlaps</source>
        <translation>Преклопувања</translation>
    </message>
    <message>
        <source>Different words that compose to the same map, neither a prefix of the other: their pieces coincide.</source>
        <translation>Зборови од пресликувања што се едно исто пресликување, а ниеден не е почеток на другиот: нивните делови се совпаѓаат.</translation>
    </message>
    <message>
        <source>Joint spectral radius</source>
        <translation>Заеднички спектрален радиус</translation>
    </message>
    <message>
        <source>Entropy</source>
        <translation>Ентропија</translation>
    </message>
    <message>
        <source>−Σ pᵢ ln pᵢ: the uncertainty of one step of the chaos game, in nats.</source>
        <translation>−Σ pᵢ ln pᵢ: колку остава отворено еден чекор од играта на хаосот, во нати.</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Експонент на Љапунов</translation>
    </message>
    <message>
        <source>Σ pᵢ ln sᵢ: how the logarithm of a distance changes per step of the chaos game, if all maps are similarities in some coordinates.</source>
        <translation>Σ pᵢ ln sᵢ: како се менува логаритмот на растојание по чекор од играта на хаосот, ако сите пресликувања се сличности во некои координати.</translation>
    </message>
    <message>
        <source>Dimension of the measure</source>
        <translation>Димензија на мерата</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 2: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Ентропијата поделена со минус експонентот на Љапунов, најмногу 2: димензијата на инваријантната мера под условот на отворено множество, а инаку нејзина горна граница.</translation>
    </message>
    <message>
        <source>The number D with Σ sᵢᴰ = 1, where sᵢ are the ratios of the maps, if all maps are similarities in some coordinates. It is the dimension of the attractor under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Бројот D со Σ sᵢᴰ = 1, каде што sᵢ се коефициентите на пресликувањата, ако сите се сличности во некои координати. Тоа е димензијата на атракторот под условот на отворено множество, а инаку нејзина горна граница.</translation>
    </message>
    <message>
        <source>Slope of the least-squares line of ln N against ln 1/ε, where N is the number of boxes of side ε that meet the attractor, over the sizes where it is most stable. This is an estimate: the uncertainty is the difference between parts of that range, not a proven bound.</source>
        <translation>Наклон на правата на најмали квадрати за ln N наспроти ln 1/ε, каде што N е бројот на кутии со страна ε што го допираат атракторот, за големините при кои е најрамномерен. Тоа е проценка; несигурноста доаѓа од разликите меѓу деловите на тој опсег и не е доказ.</translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved without sampling: the centre of mass of the picture.</source>
        <translation>Средна вредност на инваријантната мера, пресметана без примероци: тежиштето на сликата.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved without sampling: how far the picture spreads. A uniform mass on the ellipse has the same mean and covariance.</source>
        <translation>Коваријанса xx, xy, yy на инваријантната мера, пресметана без примероци: колку се шири сликата. Рамномерна маса што ја исполнува елипсата има иста средна вредност и коваријанса.</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that contains the attractor; certified. Each side is off by at most the error.</source>
        <translation>Најмалиот правоаголник со страни паралелни на оските што го содржи атракторот; потврдено. Неговите страни отстапуваат најмногу за грешката.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>Најмалиот рамнокрак правоаголен триаголник со катети паралелни на оските што го содржи атракторот; потврдено. Знаците ги даваат насоките на неговите катети. За една точка катетата е 1.</translation>
    </message>
    <message>
        <source>Area of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most its perimeter times the error bound e, and πe² for the corners.</source>
        <translation>Плоштина на пресметаната обвивка, чии темиња се точки од атракторот. Точната конвексна обвивка е поголема најмногу за нејзиниот периметар по границата на грешката e, и πe² за аглите.</translation>
    </message>
    <message>
        <source>Entropy divided by minus the Lyapunov exponent, at most 3: the dimension of the invariant measure under the open set condition, and an upper bound for it otherwise.</source>
        <translation>Ентропија поделена со негативниот експонент на Љапунов, најмногу 3: димензијата на инваријантната мера под условот на отворено множество, инаку нејзина горна граница.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, xz, yy, yz, zz of the invariant measure, solved without sampling: how far the picture spreads.</source>
        <translation>Коваријанса xx, xy, xz, yy, yz, zz на инваријантната мера, решена без примероци: колку се простира сликата.</translation>
    </message>
    <message>
        <source>Box</source>
        <comment>in space</comment>
        <translation>Квадар</translation>
    </message>
    <message>
        <source>The smallest box with edges parallel to the axes that contains the attractor, to the error bound.</source>
        <translation>Најмалиот квадар со рабови паралелни на оските што го содржи атракторот, до границата на грешката.</translation>
    </message>
    <message>
        <source>Box error bound</source>
        <translation>Граница на грешката на квадарот</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the box; certified.</source>
        <translation>Атракторот излегува од квадарот најмногу за толку; докажано.</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the attractor; certified. The signs give the directions of its legs. For a single point, the leg is 1.</source>
        <translation>Најмалиот тетраедар со три еднакви краци паралелни на оските што го содржи атракторот; потврден. Знаците ги даваат насоките на краците. За една точка, кракот е 1.</translation>
    </message>
    <message>
        <source>Hull volume</source>
        <translation>Волумен на обвивката</translation>
    </message>
    <message>
        <source>The attractor extends at most this far beyond the polyhedron; certified.</source>
        <translation>Атракторот излегува од полиедарот најмногу за толку; докажано.</translation>
    </message>
    <message>
        <source>Tile area</source>
        <translation>Плоштина на плочката</translation>
    </message>
    <message>
        <source>Boundary dimension</source>
        <translation>Димензија на границата</translation>
    </message>
    <message>
        <source>Dimension of the boundary, if all maps are similarities of one ratio whose pieces fill an area and meet in finitely many ways: from the growth of the number of contacts.</source>
        <translation>Димензија на границата ако сите пресликувања се сличности со ист сооднос чии делови исполнуваат плоштина и се допираат на конечно многу начини: од растот на бројот на допири.</translation>
    </message>
    <message>
        <source>Moran equation</source>
        <translation>Моранова равенка</translation>
    </message>
    <message>
        <source>Σ sᵢᴰ = 1 with the ratios of these maps, equal ratios combined. Its solution is the similarity dimension.</source>
        <translation>Σ sᵢᴰ = 1 со коефициентите на овие пресликувања, еднаквите земени заедно. Нејзиното решение е димензијата на сличност.</translation>
    </message>
    <message>
        <source>A compact set to which the iterates of every compact set converge. A system has one if and only if its maps contract in some norm.</source>
        <translation>Компактно множество до кое чекор по чекор води секое компактно почетно множество. Систем го има ако и само ако неговите пресликувања контрахираат во некоја норма.</translation>
    </message>
    <message>
        <source>An attractor is connected if and only if its pieces are joined by common points (Hata). Common points are looked for among fixed points of short words, and their absence is proved by disjoint covers.</source>
        <translation>Атрактор е сврзан ако и само ако заеднички точки ги поврзуваат неговите делови (Хата). Заедничките точки се бараат меѓу неподвижните точки на кратки зборови, а дека ги нема се докажува со дисјунктни покривки.</translation>
    </message>
    <message>
        <source>The largest factor per map by which long words stretch. Both ends of the interval are proved; a system contracts in some norm if and only if it is less than 1.</source>
        <translation>Најголемиот фактор по пресликување со кој растегнуваат долгите зборови. Двата краја на интервалот се докажани; систем контрахира во некоја норма ако и само ако е помал од 1.</translation>
    </message>
    <message>
        <source>Volume of the computed hull, whose vertices are points of the attractor. The exact convex hull is larger by at most the error.</source>
        <translation>Волумен на пресметаната обвивка, чии темиња се точки од атракторот. Точната конвексна обвивка е поголема најмногу за грешката.</translation>
    </message>
    <message>
        <source>There is no value, because it is not proved that there is an attractor.</source>
        <translation>Нема вредност, бидејќи не е докажано дека постои атрактор.</translation>
    </message>
    <message>
        <source>There is no value, because there is no attractor.</source>
        <translation>Нема вредност, бидејќи нема атрактор.</translation>
    </message>
    <message>
        <source>There is no value: for these maps, none could be computed.</source>
        <translation>Нема вредност: за овие пресликувања не можеше да се пресмета.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not all similarities in the same coordinates.</source>
        <translation>Нема вредност, бидејќи овие пресликувања не се сите сличности во исти координати.</translation>
    </message>
    <message>
        <source>No overlaps were found.</source>
        <translation>Не се најдени преклопувања.</translation>
    </message>
    <message>
        <source>There is no value, because these maps are not of this kind.</source>
        <translation>Нема вредност, бидејќи овие пресликувања не се од тој вид.</translation>
    </message>
    <message>
        <source>There is no value, because the maps are linked: the equation is another.</source>
        <translation>Нема вредност, бидејќи пресликувањата се поврзани: равенката е друга.</translation>
    </message>
    <message>
        <source>There is no value, because the maps contract by too little to bound it.</source>
        <translation>Нема вредност, бидејќи пресликувањата контрахираат премалку за да се ограничи.</translation>
    </message>
    <message>
        <source>Open set condition</source>
        <translation>Услов на отворено множество</translation>
    </message>
    <message>
        <source>Whether there is an open set with disjoint images in it. It is proved where the pieces are disjoint, where an area of the attractor is, and where the neighbours of pieces of one size are finitely many, and none of them coincides with its neighbour.</source>
        <translation>Дали постои отворено множество што ги содржи своите слики, а сликите му се дисјунктни. Тоа е докажано кога деловите се дисјунктни, кога е докажано дека атракторот има плоштина и кога деловите со иста големина имаат конечно многу соседи и ниту еден не се совпаѓа со својот сосед.</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Хаусдорфова димензија</translation>
    </message>
    <message>
        <source>Dimension of the attractor, where it is proved: the similarity dimension under the open set condition; or, where pieces coincide and there are finitely many neighbours, by the growth of the number of different maps.</source>
        <translation>Димензија на атракторот, таму каде што е докажана: димензијата на сличност кога важи условот на отворено множество; или, кога има делови што се совпаѓаат и конечно многу соседи, според растот на бројот на различни пресликувања.</translation>
    </message>
    <message>
        <source>There is no value: it is not known how much the pieces overlap, or the maps are no similarities.</source>
        <translation>Нема вредност: не се знае колку деловите се преклопуваат или пресликувањата не се сличности.</translation>
    </message>
    <message>
        <source>Area of the attractor, if its copies, moved by a lattice and turned by a few turns, cover the plane equally often; proved by the contacts of the copies, or by counting those that hold a point.</source>
        <translation>Плоштина на атракторот ако неговите копии, поместени по решетка и завртени за неколку агли, насекаде подеднакво пати ја покриваат рамнината; докажана преку допирите на копиите или со броење на копиите што содржат една точка.</translation>
    </message>
    <message>
        <source>There is no value: it is not proved that copies of the attractor cover the plane in this way.</source>
        <translation>Нема вредност: не е докажано дека копии на атракторот ја покриваат рамнината на овој начин.</translation>
    </message>
    <message>
        <source>%1 (approximation)</source>
        <translation>%1 (приближно)</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Grab a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Фатете го фракталот за темињата: уредувач на итерирани функциски системи.</translation>
    </message>
    <message>
        <source>.ifs files to open, each in its own window</source>
        <translation>.ifs-датотеки за отворање, секоја во свој прозорец</translation>
    </message>
    <message>
        <source>start with the maple instead of the last session</source>
        <translation>почни со јаворот наместо со последната сесија</translation>
    </message>
    <message>
        <source>open a window with the collection</source>
        <translation>отвори прозорец со збирката</translation>
    </message>
    <message>
        <source>open a window with random fractals to choose from</source>
        <translation>отвори прозорец со случајни фрактали за избор</translation>
    </message>
    <message>
        <source>draw the maple to a PNG file instead; needs no display</source>
        <translation>наместо тоа нацртај го јаворот во PNG-датотека; не е потребен екран</translation>
    </message>
    <message>
        <source>The system does not let Barycage start another thread. Close other programs, or raise the limit on processes, and try again.</source>
        <translation>Системот не му дозволува на Barycage да започне уште една нишка. Затворете други програми или зголемете го ограничувањето на процесите, па обидете се повторно.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Нема доволно меморија за ова.</translation>
    </message>
</context>
<context>
    <name>Collection</name>
    <message>
        <source>From the paper</source>
        <translation>Од трудот</translation>
    </message>
    <message>
        <source>The two systems of E. Hadzieva and M. Shuminoska, with the coefficients as printed.</source>
        <translation>Двата система на Е. Хаџиева и М. Шуминоска, со коефициентите како што се отпечатени.</translation>
    </message>
    <message>
        <source>Ferns</source>
        <translation>Папрати</translation>
    </message>
    <message>
        <source>Fronds: one large map climbs the rachis, two small ones attach the pinnae, and a flat one draws the stem.</source>
        <translation>Папратови листови: едно големо пресликување се качува по главната оска, две мали ги додаваат страничните ливчиња, а едно сплескано ја црта дршката.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Дрвја</translation>
    </message>
    <message>
        <source>Forking trunks: the branches of the tree are copies of the whole tree.</source>
        <translation>Стебла што се разгрануваат: гранките на дрвото се копии на целото дрво.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Змејови</translation>
    </message>
    <message>
        <source>Paper-folding curves, and fractals of two or three rotating similarities.</source>
        <translation>Криви од свиткана хартија и фрактали од две или три завртени сличности.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Фамилија Серпињски</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon made of smaller copies of itself, with holes between them.</source>
        <translation>Триаголници и килими: многуаголник составен од помали копии на самиот себе, со дупки меѓу нив.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Фамилија Кох</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment again and again, and the islands they enclose.</source>
        <translation>Криви што настануваат кога отсечка постојано се заменува, и островите што тие ги опфаќаат.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Спирали</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small maps that set beads along its path.</source>
        <translation>Едно пресликување што врти и малку смалува, и други, мали, што го нижат неговиот пат како мониста.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Листови и цветови</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are rotated copies of one another.</source>
        <translation>Контури на листови и цветови чии ливчиња се завртени копии едни од други.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Поплочувања и рептајли</translation>
    </message>
    <message>
        <source>Sets that tile the plane: rep-tiles, which are made of copies of themselves, and the central tiles of number systems.</source>
        <translation>Множества што ја поплочуваат рамнината: рептајли, составени од копии на самите себе, и централните плочки на бројните системи.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Канторови множества и прав</translation>
    </message>
    <message>
        <source>Sets with gaps at every scale: the points crowd together, but hardly any are connected.</source>
        <translation>Множества со празнини во секој размер: точките се збиваат, но речиси ниедна не е поврзана со друга.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Кристали и снегулки</translation>
    </message>
    <message>
        <source>Sets with the symmetry of snow crystals: five, six and more arms.</source>
        <translation>Множества со симетрија на снежни кристали: со пет, шест и повеќе краци.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Криви и графици</translation>
    </message>
    <message>
        <source>Graphs of unusual functions, smooth curves as attractors, and coordinates of space-filling curves.</source>
        <translation>Графици на необични функции, мазни криви како атрактори и координати на криви што ја исполнуваат рамнината.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Апстрактни</translation>
    </message>
    <message>
        <source>Affine patterns with no counterpart in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Афини шари што ги нема во природата: роднини на триаголникот на Серпињски, плетенки, розети.</translation>
    </message>
    <message>
        <source>Polyhedra in space</source>
        <translation>Полиедри во простор</translation>
    </message>
    <message>
        <source>A polyhedron made of smaller copies of itself, one at each corner.</source>
        <translation>Полиедар составен од помали копии на самиот себе, по една на секое теме.</translation>
    </message>
    <message>
        <source>Sponges and cubes in space</source>
        <translation>Сунѓери и коцки во простор</translation>
    </message>
    <message>
        <source>Cubes divided into smaller cubes, some of which are left out or turned.</source>
        <translation>Коцки поделени на помали коцки, од кои некои се изоставени или завртени.</translation>
    </message>
    <message>
        <source>Plants in space</source>
        <translation>Растенија во простор</translation>
    </message>
    <message>
        <source>Fronds and trees with branches all around the stem.</source>
        <translation>Папратови листови и дрвја со гранки насекаде околу стеблото.</translation>
    </message>
    <message>
        <source>Shells and corals in space</source>
        <translation>Школки и корали во простор</translation>
    </message>
    <message>
        <source>Helical shells, cones arranged by the golden angle, and corals with thick branches.</source>
        <translation>Спирални школки, конуси распоредени според златниот агол и корали со дебели гранки.</translation>
    </message>
    <message>
        <source>Dragons in space</source>
        <translation>Змејови во простор</translation>
    </message>
    <message>
        <source>Folded surfaces, and polyhedra whose copies are turned.</source>
        <translation>Преклопени површини и полиедри чии копии се завртени.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>Во движење</translation>
    </message>
    <message>
        <source>Fractals that move: wind, folding, growing, morphs, endless zooms, and flights in space.</source>
        <translation>Фрактали што се движат: ветар, превиткување, растење, преобразби, бескрајно приближување и летови низ просторот.</translation>
    </message>
    <message>
        <source>Linked maps</source>
        <translation>Поврзани пресликувања</translation>
    </message>
    <message>
        <source>Maps that may follow only certain maps: Penrose tiles, boundaries, and chaos games with rules.</source>
        <translation>Пресликувања што смеат да следат само некои: Пенроузови плочки, граници и игри на хаосот со правила.</translation>
    </message>
    <message>
        <source>Fractal transformations</source>
        <translation>Фрактални трансформации</translation>
    </message>
    <message>
        <source>Fractals coloured by a picture on another fractal; a double click opens both side by side.</source>
        <translation>Фрактали во боите на слика врз друг фрактал; двоен клик ги отвора двата еден до друг.</translation>
    </message>
</context>
<context>
    <name>CollectionNames</name>
    <message>
        <source>Maple</source>
        <translation>Јавор</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>Цвет</translation>
    </message>
    <message>
        <source>Maple in the wind</source>
        <translation>Јавор на ветер</translation>
    </message>
    <message>
        <source>Fern that unrolls</source>
        <translation>Папрат што се одвиткува</translation>
    </message>
    <message>
        <source>Paper strip that folds to a dragon</source>
        <translation>Хартиена лента што се превиткува во змеј</translation>
    </message>
    <message>
        <source>Koch curve that grows spikes</source>
        <translation>Кохова крива на која ѝ растат боцки</translation>
    </message>
    <message>
        <source>Zoom into a flake without end</source>
        <translation>Бескрајно приближување кон снегулка</translation>
    </message>
    <message>
        <source>Walk through a weaving flower</source>
        <translation>Прошетка низ цвет што се ниша</translation>
    </message>
    <message>
        <source>Tree in a storm</source>
        <translation>Дрво во бура</translation>
    </message>
    <message>
        <source>Sea fan in the swell</source>
        <translation>Морска лепеза меѓу брановите</translation>
    </message>
    <message>
        <source>Bracts that breathe</source>
        <translation>Брактеи што дишат</translation>
    </message>
    <message>
        <source>Pentagons that turn in place</source>
        <translation>Петаголници што се вртат во место</translation>
    </message>
    <message>
        <source>Menger sponge that turns</source>
        <translation>Менгеров сунѓер што се врти</translation>
    </message>
    <message>
        <source>Flight into the Menger sponge</source>
        <translation>Лет во Менгеровиот сунѓер</translation>
    </message>
    <message>
        <source>Tree in space that sways</source>
        <translation>Дрво во простор што се ниша</translation>
    </message>
    <message>
        <source>Snow star that becomes a fern of ice</source>
        <translation>Снежна ѕвезда што станува ледена папрат</translation>
    </message>
    <message>
        <source>Maple that becomes a fern</source>
        <translation>Јавор што станува папрат</translation>
    </message>
    <message>
        <source>Black spleenwort fern</source>
        <translation>Црн асплениум</translation>
    </message>
    <message>
        <source>Maiden fern</source>
        <translation>Мочуришна папрат</translation>
    </message>
    <message>
        <source>Culcita fern</source>
        <translation>Папрат кулцита</translation>
    </message>
    <message>
        <source>Fishbone fern</source>
        <translation>Папрат рибја коска</translation>
    </message>
    <message>
        <source>Fiddlehead: a frond still curled</source>
        <translation>Млада папрат: лист што е сѐ уште завиткан</translation>
    </message>
    <message>
        <source>Bracken: opposite pinnae at the same height</source>
        <translation>Орлова папрат: спротивни ливчиња на иста висина</translation>
    </message>
    <message>
        <source>Lady fern: alternate pinnae, a nodding tip</source>
        <translation>Женска папрат: наизменични ливчиња, наведнат врв</translation>
    </message>
    <message>
        <source>Maidenhair: a fan on a fine stalk</source>
        <translation>Венерина коса: лепеза на тенка дршка</translation>
    </message>
    <message>
        <source>Ostrich fern: a shuttlecock plume</source>
        <translation>Нојова папрат: перјаница налик на инка</translation>
    </message>
    <message>
        <source>Golden fern: pinnae smaller by the golden ratio squared</source>
        <translation>Златна папрат: ливчиња смалени со квадратот на златниот пресек</translation>
    </message>
    <message>
        <source>Moss: a frond of frond-like feathers</source>
        <translation>Мов: лист од пердуви налик на листови</translation>
    </message>
    <message>
        <source>Fractal tree</source>
        <translation>Фрактално дрво</translation>
    </message>
    <message>
        <source>Golden tree: branches of 1/phi at 60 degrees, just touching</source>
        <translation>Златно дрво: гранки со однос 1/φ под 60°, што едвај се допираат</translation>
    </message>
    <message>
        <source>Stone pine: an umbrella of three boughs</source>
        <translation>Пинија: чадор од три гранки</translation>
    </message>
    <message>
        <source>Spruce: whorls of drooping boughs</source>
        <translation>Смрча: венци од обесени гранки</translation>
    </message>
    <message>
        <source>Willow: branches that bend down</source>
        <translation>Врба: гранки што се свиваат надолу</translation>
    </message>
    <message>
        <source>Tree in the wind</source>
        <translation>Дрво на ветер</translation>
    </message>
    <message>
        <source>Bonsai pine: flat cushions on a leaning trunk</source>
        <translation>Бонсаи бор: рамни перничиња на накривено стебло</translation>
    </message>
    <message>
        <source>Cypress</source>
        <translation>Чемпрес</translation>
    </message>
    <message>
        <source>Thorn bush: alternate twigs</source>
        <translation>Трнлива грмушка: наизменични гранчиња</translation>
    </message>
    <message>
        <source>Poplar: narrow and steep</source>
        <translation>Топола: тесна и исправена</translation>
    </message>
    <message>
        <source>Ternary tree: three halves, drawn with their branches</source>
        <translation>Тројно дрво: три половини, нацртани со своите гранки</translation>
    </message>
    <message>
        <source>Branching coral</source>
        <translation>Разгранет корал</translation>
    </message>
    <message>
        <source>H-tree: right angles all the way</source>
        <translation>H-дрво: само прави агли</translation>
    </message>
    <message>
        <source>Heighway dragon</source>
        <translation>Змеј на Хајвеј</translation>
    </message>
    <message>
        <source>Twindragon</source>
        <translation>Змеј близнак</translation>
    </message>
    <message>
        <source>Levy dragon (C curve)</source>
        <translation>Змеј на Леви (C-крива)</translation>
    </message>
    <message>
        <source>Terdragon</source>
        <translation>Троен змеј</translation>
    </message>
    <message>
        <source>Golden dragon</source>
        <translation>Златен змеј</translation>
    </message>
    <message>
        <source>Tame twindragon</source>
        <translation>Питом змеј близнак</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 100 degrees only</source>
        <translation>Змејова крива одвиткана само до 100°</translation>
    </message>
    <message>
        <source>Dragon curve unfolded to 115 degrees</source>
        <translation>Змејова крива одвиткана до 115°</translation>
    </message>
    <message>
        <source>C curve on triangles of 100 degrees</source>
        <translation>C-крива врз триаголници од 100°</translation>
    </message>
    <message>
        <source>Z dragon: the three strokes of a Z</source>
        <translation>Z-змеј: трите потези на буквата Z</translation>
    </message>
    <message>
        <source>Sierpinski triangle</source>
        <translation>Триаголник на Серпињски</translation>
    </message>
    <message>
        <source>Right-angled Sierpinski triangle</source>
        <translation>Правоаголен триаголник на Серпињски</translation>
    </message>
    <message>
        <source>Sierpinski carpet</source>
        <translation>Килим на Серпињски</translation>
    </message>
    <message>
        <source>Vicsek fractal (saltire)</source>
        <translation>Фрактал на Вичек (кос крст)</translation>
    </message>
    <message>
        <source>Vicsek fractal (cross)</source>
        <translation>Фрактал на Вичек (крст)</translation>
    </message>
    <message>
        <source>Sierpinski pentagon</source>
        <translation>Петаголник на Серпињски</translation>
    </message>
    <message>
        <source>Sierpinski hexagon</source>
        <translation>Шестаголник на Серпињски</translation>
    </message>
    <message>
        <source>Sierpinski heptagon</source>
        <translation>Седумаголник на Серпињски</translation>
    </message>
    <message>
        <source>Sierpinski octagon</source>
        <translation>Осумаголник на Серпињски</translation>
    </message>
    <message>
        <source>Sierpinski dodecagon</source>
        <translation>Дванаесетаголник на Серпињски</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 3</source>
        <translation>Паскалов триаголник по модул 3</translation>
    </message>
    <message>
        <source>Pascal&apos;s triangle modulo 5</source>
        <translation>Паскалов триаголник по модул 5</translation>
    </message>
    <message>
        <source>Sierpinski pedal triangle</source>
        <translation>Ортички триаголник на Серпињски</translation>
    </message>
    <message>
        <source>Bedford-McMullen carpet</source>
        <translation>Килим на Бедфорд и Макмален</translation>
    </message>
    <message>
        <source>Bedford-McMullen weave of 3 by 5 cells</source>
        <translation>Плетенка на Бедфорд и Макмален од 3 по 5 полиња</translation>
    </message>
    <message>
        <source>Carpet of fifths with a cross-shaped hole</source>
        <translation>Килим од петтини со дупка во облик на крст</translation>
    </message>
    <message>
        <source>Carpet of quarters with a square hole</source>
        <translation>Килим од четвртини со квадратна дупка</translation>
    </message>
    <message>
        <source>Checkered carpet</source>
        <translation>Шаховски килим</translation>
    </message>
    <message>
        <source>Koch curve</source>
        <translation>Кохова крива</translation>
    </message>
    <message>
        <source>Koch snowflake, filled</source>
        <translation>Кохова снегулка, исполнета</translation>
    </message>
    <message>
        <source>Cesaro curve of 85 degrees</source>
        <translation>Крива на Чезаро од 85°</translation>
    </message>
    <message>
        <source>Quadratic Koch curve of five edges</source>
        <translation>Квадратна Кохова крива од пет отсечки</translation>
    </message>
    <message>
        <source>Minkowski sausage</source>
        <translation>Колбас на Минковски</translation>
    </message>
    <message>
        <source>Mandelbrot-Given curve</source>
        <translation>Крива на Манделброт и Гивен</translation>
    </message>
    <message>
        <source>Ice fractal on a square</source>
        <translation>Леден фрактал врз квадрат</translation>
    </message>
    <message>
        <source>Ice fractal with a pair of spikes</source>
        <translation>Леден фрактал со пар боцки</translation>
    </message>
    <message>
        <source>Koch curve drawn on both sides</source>
        <translation>Кохова крива од двете страни</translation>
    </message>
    <message>
        <source>Koch curve with peaks turned inwards</source>
        <translation>Кохова крива со врвови навнатре</translation>
    </message>
    <message>
        <source>Pentigree</source>
        <translation>Пентигри</translation>
    </message>
    <message>
        <source>Pentadendrite</source>
        <translation>Пентадендрит</translation>
    </message>
    <message>
        <source>Edge of the Gosper island</source>
        <translation>Раб на островот на Госпер</translation>
    </message>
    <message>
        <source>Spiral of spirals</source>
        <translation>Спирала од спирали</translation>
    </message>
    <message>
        <source>Swirl</source>
        <translation>Вртлог</translation>
    </message>
    <message>
        <source>Galaxy with two arms</source>
        <translation>Галаксија со два крака</translation>
    </message>
    <message>
        <source>Whorl of three-fold rosettes</source>
        <translation>Венец од тројни розети</translation>
    </message>
    <message>
        <source>Ram&apos;s horn</source>
        <translation>Овнов рог</translation>
    </message>
    <message>
        <source>Whirl of pentagons</source>
        <translation>Вртлог од петаголници</translation>
    </message>
    <message>
        <source>Double spiral between two eyes</source>
        <translation>Двојна спирала меѓу две очи</translation>
    </message>
    <message>
        <source>Spiral of feathers</source>
        <translation>Спирала од пердуви</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a golden spiral</source>
        <translation>Наутилус: комори долж златна спирала</translation>
    </message>
    <message>
        <source>Sunflower: seeds at the golden angle</source>
        <translation>Сончоглед: семки под златниот агол</translation>
    </message>
    <message>
        <source>Shell: ribs that follow the turn</source>
        <translation>Школка: ребра што го следат вртењето</translation>
    </message>
    <message>
        <source>Three spirals passing into one another</source>
        <translation>Три спирали што преминуваат една во друга</translation>
    </message>
    <message>
        <source>Maple leaf</source>
        <translation>Јаворов лист</translation>
    </message>
    <message>
        <source>Pointed leaf</source>
        <translation>Зашилен лист</translation>
    </message>
    <message>
        <source>Poinsettia: five bracts</source>
        <translation>Божиќна ѕвезда: пет брактеи</translation>
    </message>
    <message>
        <source>Edelweiss: eight woolly rays</source>
        <translation>Еделвајс: осум волнести зраци</translation>
    </message>
    <message>
        <source>Lily of six petals</source>
        <translation>Крин со шест ливчиња</translation>
    </message>
    <message>
        <source>Oak leaf</source>
        <translation>Дабов лист</translation>
    </message>
    <message>
        <source>Feather</source>
        <translation>Пердув</translation>
    </message>
    <message>
        <source>Plane-tree leaf: five blades from one root</source>
        <translation>Лист од чинар: пет делови од ист корен</translation>
    </message>
    <message>
        <source>Dill umbel</source>
        <translation>Соцветие на копар</translation>
    </message>
    <message>
        <source>Thistle head</source>
        <translation>Главичка од магарешки трн</translation>
    </message>
    <message>
        <source>Dandelion clock</source>
        <translation>Прецутено глуварче</translation>
    </message>
    <message>
        <source>Marigold: rings of petals</source>
        <translation>Невен: венци од ливчиња</translation>
    </message>
    <message>
        <source>Ear of wheat</source>
        <translation>Пченичен клас</translation>
    </message>
    <message>
        <source>Chair rep-tile (L tromino)</source>
        <translation>Рептајл „столче“ (L-тромино)</translation>
    </message>
    <message>
        <source>Golden bee (Ammann&apos;s chair)</source>
        <translation>Златна пчела (столче на Аман)</translation>
    </message>
    <message>
        <source>Gosper island</source>
        <translation>Остров на Госпер</translation>
    </message>
    <message>
        <source>Quintet</source>
        <translation>Квинтет</translation>
    </message>
    <message>
        <source>Eisenstein fractal</source>
        <translation>Фрактал на Ајзенштајн</translation>
    </message>
    <message>
        <source>Rauzy fractal (tribonacci)</source>
        <translation>Фрактал на Рози (трибоначи)</translation>
    </message>
    <message>
        <source>Hokkaido tile</source>
        <translation>Плочка на Хокаидо</translation>
    </message>
    <message>
        <source>Tile of Narayana&apos;s cows</source>
        <translation>Плочка на кравите на Нарајана</translation>
    </message>
    <message>
        <source>Tile of x^2 + x + 3</source>
        <translation>Плочка на x² + x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 3</source>
        <translation>Плочка на x² + 2x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 3 x + 3</source>
        <translation>Плочка на x² + 3x + 3</translation>
    </message>
    <message>
        <source>Tile of x^2 + 2 x + 4</source>
        <translation>Плочка на x² + 2x + 4</translation>
    </message>
    <message>
        <source>Jigsaw square: nine thirds, one pushed out</source>
        <translation>Квадрат-сложувалка: девет третини, една истуркана надвор</translation>
    </message>
    <message>
        <source>Numbers in base -2+i with digits 0 to 4</source>
        <translation>Броеви со основа −2+i и цифри од 0 до 4</translation>
    </message>
    <message>
        <source>Fudgeflake: three terdragons round a point</source>
        <translation>Фаџфлејк: три тројни змеја околу една точка</translation>
    </message>
    <message>
        <source>Central tile of x^3 = 2 x^2 + x + 1</source>
        <translation>Централна плочка на x³ = 2x² + x + 1</translation>
    </message>
    <message>
        <source>Penrose tiles</source>
        <translation>Пенроузови плочки</translation>
    </message>
    <message>
        <source>Penrose tiles, cracked</source>
        <translation>Пенроузови плочки, напукнати</translation>
    </message>
    <message>
        <source>Parts of the Rauzy fractal</source>
        <translation>Делови на фракталот на Рози</translation>
    </message>
    <message>
        <source>Boundary of the dragon</source>
        <translation>Граница на змејот</translation>
    </message>
    <message>
        <source>Boundary of the twindragon</source>
        <translation>Граница на змејот близнак</translation>
    </message>
    <message>
        <source>Golden mean carpet</source>
        <translation>Килим на златниот пресек</translation>
    </message>
    <message>
        <source>Golden mean dragon</source>
        <translation>Змеј на златниот пресек</translation>
    </message>
    <message>
        <source>Restless pentagon</source>
        <translation>Немирен петаголник</translation>
    </message>
    <message>
        <source>One-way square</source>
        <translation>Еднонасочен квадрат</translation>
    </message>
    <message>
        <source>Neighbouring corners</source>
        <translation>Соседни темиња</translation>
    </message>
    <message>
        <source>Steps around a hexagon</source>
        <translation>Чекори околу шестаголник</translation>
    </message>
    <message>
        <source>Steps around a pentagon</source>
        <translation>Чекори околу петаголник</translation>
    </message>
    <message>
        <source>Old and young</source>
        <translation>Стари и млади</translation>
    </message>
    <message>
        <source>Sunset in a triangle</source>
        <translation>Зајдисонце во триаголник</translation>
    </message>
    <message>
        <source>Triangle for the sunset</source>
        <translation>Триаголник за зајдисонцето</translation>
    </message>
    <message>
        <source>Bent window</source>
        <translation>Искривен витраж</translation>
    </message>
    <message>
        <source>Triangle for the glass</source>
        <translation>Триаголник за витражот</translation>
    </message>
    <message>
        <source>Tartan in a square</source>
        <translation>Тартан во квадрат</translation>
    </message>
    <message>
        <source>Square for the tartan</source>
        <translation>Квадрат за тартанот</translation>
    </message>
    <message>
        <source>Grid of a square</source>
        <translation>Мрежа на квадрат</translation>
    </message>
    <message>
        <source>Square for the grid</source>
        <translation>Квадрат за мрежата</translation>
    </message>
    <message>
        <source>Rainbow fern</source>
        <translation>Папрат со бои на виножито</translation>
    </message>
    <message>
        <source>Maple for the fern</source>
        <translation>Јавор за папратта</translation>
    </message>
    <message>
        <source>Autumn maple</source>
        <translation>Есенски јавор</translation>
    </message>
    <message>
        <source>Square for the maple</source>
        <translation>Квадрат за јаворот</translation>
    </message>
    <message>
        <source>Dragon of paper</source>
        <translation>Змеј од хартија</translation>
    </message>
    <message>
        <source>Sheet for the dragon</source>
        <translation>Лист хартија за змејот</translation>
    </message>
    <message>
        <source>Curve of waves</source>
        <translation>Крива од бранови</translation>
    </message>
    <message>
        <source>Sheet for the curve</source>
        <translation>Лист хартија за кривата</translation>
    </message>
    <message>
        <source>Koch curve across a square</source>
        <translation>Кохова крива низ квадрат</translation>
    </message>
    <message>
        <source>Square for the curve</source>
        <translation>Квадрат за кривата</translation>
    </message>
    <message>
        <source>Hilbert curve along a coast</source>
        <translation>Хилбертова крива долж брегот</translation>
    </message>
    <message>
        <source>Curve for the square</source>
        <translation>Крива за квадратот</translation>
    </message>
    <message>
        <source>Broken picture</source>
        <translation>Скршена слика</translation>
    </message>
    <message>
        <source>Square to break</source>
        <translation>Квадрат за кршење</translation>
    </message>
    <message>
        <source>Gasket of a dragon</source>
        <translation>Триаголник на Серпињски од змеј</translation>
    </message>
    <message>
        <source>Terdragon for the gasket</source>
        <translation>Троен змеј за триаголникот</translation>
    </message>
    <message>
        <source>Cantor dust</source>
        <translation>Канторова прав</translation>
    </message>
    <message>
        <source>Cantor comb: a Cantor set times an interval</source>
        <translation>Канторов чешел: Канторово множество помножено со интервал</translation>
    </message>
    <message>
        <source>Dust on a triangle</source>
        <translation>Прав врз триаголник</translation>
    </message>
    <message>
        <source>Dust on a pentagon</source>
        <translation>Прав врз петаголник</translation>
    </message>
    <message>
        <source>Dust of unequal ratios</source>
        <translation>Прав со нееднакви односи</translation>
    </message>
    <message>
        <source>Dust on an octagon</source>
        <translation>Прав врз осумаголник</translation>
    </message>
    <message>
        <source>Rings of dust</source>
        <translation>Прстени од прав</translation>
    </message>
    <message>
        <source>Tartan dust</source>
        <translation>Тартан од прав</translation>
    </message>
    <message>
        <source>Pinwheel dust</source>
        <translation>Ветерница од прав</translation>
    </message>
    <message>
        <source>Swirling dust of three</source>
        <translation>Прав од три копии во вртлог</translation>
    </message>
    <message>
        <source>Hexaflake</source>
        <translation>Шестаголна снегулка</translation>
    </message>
    <message>
        <source>Pentaflake</source>
        <translation>Петаголна снегулка</translation>
    </message>
    <message>
        <source>Stellar snowflake</source>
        <translation>Ѕвездеста снегулка</translation>
    </message>
    <message>
        <source>Fern-like snowflake</source>
        <translation>Снегулка налик на папрат</translation>
    </message>
    <message>
        <source>Sectored plate</source>
        <translation>Снежна плочка со сектори</translation>
    </message>
    <message>
        <source>Needle snowflake</source>
        <translation>Игличеста снегулка</translation>
    </message>
    <message>
        <source>Frost flower</source>
        <translation>Цвет од слана</translation>
    </message>
    <message>
        <source>Decaflake</source>
        <translation>Десетаголна снегулка</translation>
    </message>
    <message>
        <source>Pentagram flake</source>
        <translation>Снегулка од пентаграми</translation>
    </message>
    <message>
        <source>Quartz: four-fold lattice</source>
        <translation>Кварц: решетка од четврти ред</translation>
    </message>
    <message>
        <source>Crystal of two maps</source>
        <translation>Кристал од две пресликувања</translation>
    </message>
    <message>
        <source>Dendrite snowflake</source>
        <translation>Дендритна снегулка</translation>
    </message>
    <message>
        <source>Eight-pointed star</source>
        <translation>Осмокрака ѕвезда</translation>
    </message>
    <message>
        <source>Frost cross: squares turned by 45 degrees</source>
        <translation>Крст од слана: квадрати завртени за 45°</translation>
    </message>
    <message>
        <source>Takagi curve (blancmange)</source>
        <translation>Крива на Такаги (бланманже)</translation>
    </message>
    <message>
        <source>Quadratic Bezier arc by de Casteljau</source>
        <translation>Квадратен лак на Безје според Де Кастелжо</translation>
    </message>
    <message>
        <source>Devil&apos;s staircase</source>
        <translation>Ѓаволски скали</translation>
    </message>
    <message>
        <source>Okamoto function, a = 2/3 (Bourbaki&apos;s)</source>
        <translation>Функција на Окамото, a = 2/3 (на Бурбаки)</translation>
    </message>
    <message>
        <source>Okamoto function, a = 5/6 (Perkins&apos;s)</source>
        <translation>Функција на Окамото, a = 5/6 (на Перкинс)</translation>
    </message>
    <message>
        <source>Kiesswetter curve</source>
        <translation>Крива на Кисветер</translation>
    </message>
    <message>
        <source>Bolzano function</source>
        <translation>Болцанова функција</translation>
    </message>
    <message>
        <source>Fractal interpolation of four points</source>
        <translation>Фрактална интерполација на четири точки</translation>
    </message>
    <message>
        <source>Mountain skyline</source>
        <translation>Силуета на планини</translation>
    </message>
    <message>
        <source>First coordinate of Peano&apos;s curve</source>
        <translation>Прва координата на Пеановата крива</translation>
    </message>
    <message>
        <source>Lebesgue&apos;s singular function, a = 0.3</source>
        <translation>Лебегова сингуларна функција, a = 0,3</translation>
    </message>
    <message>
        <source>Takagi curve and its mirror image</source>
        <translation>Крива на Такаги и нејзиниот одраз</translation>
    </message>
    <message>
        <source>Hilbert&apos;s four maps, shrunk so that the seams open</source>
        <translation>Четирите пресликувања на Хилберт, смалени за да се отворат шевовите</translation>
    </message>
    <message>
        <source>Relative of the Sierpinski triangle</source>
        <translation>Роднина на триаголникот на Серпињски</translation>
    </message>
    <message>
        <source>Zigzag of two maps</source>
        <translation>Цик-цак од две пресликувања</translation>
    </message>
    <message>
        <source>Coral</source>
        <translation>Корал</translation>
    </message>
    <message>
        <source>Rosette of three</source>
        <translation>Розета од три</translation>
    </message>
    <message>
        <source>Rosette of five</source>
        <translation>Розета од пет</translation>
    </message>
    <message>
        <source>Rosette of seven</source>
        <translation>Розета од седум</translation>
    </message>
    <message>
        <source>Mandala of twelve</source>
        <translation>Мандала од дванаесет</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Тантела</translation>
    </message>
    <message>
        <source>Weave</source>
        <translation>Плетенка</translation>
    </message>
    <message>
        <source>Twigs: a turn and a mirror</source>
        <translation>Гранчиња: вртење и огледало</translation>
    </message>
    <message>
        <source>Heather</source>
        <translation>Врес</translation>
    </message>
    <message>
        <source>Breaking wave</source>
        <translation>Бран што се крши</translation>
    </message>
    <message>
        <source>City seen from above</source>
        <translation>Град гледан одозгора</translation>
    </message>
    <message>
        <source>Flames</source>
        <translation>Пламени</translation>
    </message>
    <message>
        <source>Hills in haze</source>
        <translation>Ридови во магла</translation>
    </message>
    <message>
        <source>Knotwork: four copies turned by 45 degrees</source>
        <translation>Преплет: четири копии завртени за 45°</translation>
    </message>
    <message>
        <source>Sea dragon</source>
        <translation>Морски змеј</translation>
    </message>
    <message>
        <source>Kaleidoscope</source>
        <translation>Калеидоскоп</translation>
    </message>
    <message>
        <source>Sierpinski tetrahedron</source>
        <translation>Тетраедар на Серпињски</translation>
    </message>
    <message>
        <source>Octahedron flake</source>
        <translation>Октаедарска снегулка</translation>
    </message>
    <message>
        <source>Sierpinski pyramid</source>
        <translation>Пирамида на Серпињски</translation>
    </message>
    <message>
        <source>Icosahedron flake</source>
        <translation>Икосаедарска снегулка</translation>
    </message>
    <message>
        <source>Dodecahedron flake</source>
        <translation>Додекаедарска снегулка</translation>
    </message>
    <message>
        <source>Cuboctahedron flake</source>
        <translation>Кубоктаедарска снегулка</translation>
    </message>
    <message>
        <source>Menger sponge</source>
        <translation>Менгеров сунѓер</translation>
    </message>
    <message>
        <source>Mosely snowflake</source>
        <translation>Снегулка на Моузли</translation>
    </message>
    <message>
        <source>Jerusalem cube</source>
        <translation>Ерусалимска коцка</translation>
    </message>
    <message>
        <source>Cross in space</source>
        <translation>Крст во простор</translation>
    </message>
    <message>
        <source>Saltire in space</source>
        <translation>Кос крст во простор</translation>
    </message>
    <message>
        <source>Cantor dust in space</source>
        <translation>Канторова прав во простор</translation>
    </message>
    <message>
        <source>Cube corner: seven of eight cubes</source>
        <translation>Агол на коцка: седум од осум коцки</translation>
    </message>
    <message>
        <source>Cube corners in mirrors</source>
        <translation>Агли на коцки во огледала</translation>
    </message>
    <message>
        <source>Quadratic Koch surface: cubes on squares</source>
        <translation>Квадратна Кохова површина: коцки врз квадрати</translation>
    </message>
    <message>
        <source>Fern in space</source>
        <translation>Папрат во простор</translation>
    </message>
    <message>
        <source>Tree with three boughs</source>
        <translation>Дрво со три гранки</translation>
    </message>
    <message>
        <source>Oak with a leader and four boughs</source>
        <translation>Даб со водечка гранка и уште четири</translation>
    </message>
    <message>
        <source>Fir: drooping whorls around a leader</source>
        <translation>Ела: обесени венци околу водечка гранка</translation>
    </message>
    <message>
        <source>Poplar: pairs of steep twigs</source>
        <translation>Топола: парови исправени гранчиња</translation>
    </message>
    <message>
        <source>Umbel: six rays from the top of a stalk</source>
        <translation>Штитовидно соцветие: шест зраци од врвот на една дршка</translation>
    </message>
    <message>
        <source>Thuja: flat sprays turned by the golden angle</source>
        <translation>Туја: рамни гранчиња завртени за златниот агол</translation>
    </message>
    <message>
        <source>Romanesco: cones on a cone, by the golden angle</source>
        <translation>Романеско: конуси врз конус, според златниот агол</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Карфиол</translation>
    </message>
    <message>
        <source>Turret shell</source>
        <translation>Кулест полжав</translation>
    </message>
    <message>
        <source>Top shell: whorls of whorls</source>
        <translation>Полжав чигра: навои од навои</translation>
    </message>
    <message>
        <source>Nautilus: chambers along a flat spiral</source>
        <translation>Наутилус: комори долж рамна спирала</translation>
    </message>
    <message>
        <source>Double helix that narrows to a point</source>
        <translation>Двојна завојница што се стеснува во врв</translation>
    </message>
    <message>
        <source>Staghorn coral</source>
        <translation>Корал еленски рог</translation>
    </message>
    <message>
        <source>Bush coral</source>
        <translation>Грмушест корал</translation>
    </message>
    <message>
        <source>Sea fan: forks almost in one plane</source>
        <translation>Морска лепеза: разгранувања речиси во една рамнина</translation>
    </message>
    <message>
        <source>Allium: a ball of twelve stalks with alliums at their ends</source>
        <translation>Украсен лук: топка од дванаесет дршки со лук на крајот</translation>
    </message>
    <message>
        <source>Dragon in space: each fold about another axis</source>
        <translation>Змеј во простор: секое превиткување околу друга оска</translation>
    </message>
    <message>
        <source>C curve in space</source>
        <translation>C-крива во простор</translation>
    </message>
    <message>
        <source>Terdragon in space</source>
        <translation>Троен змеј во простор</translation>
    </message>
    <message>
        <source>Tetrahedra, each turned by 60 degrees</source>
        <translation>Тетраедри, секој завртен за 60°</translation>
    </message>
    <message>
        <source>Cubes, each turned by 60 degrees</source>
        <translation>Коцки, секоја завртена за 60°</translation>
    </message>
    <message>
        <source>Octahedra, each turned by 45 degrees</source>
        <translation>Октаедри, секој завртен за 45°</translation>
    </message>
</context>
<context>
    <name>FirstChips</name>
    <message>
        <source>What to try next</source>
        <translation>Што да пробате понатаму</translation>
    </message>
</context>
<context>
    <name>FirstMinute</name>
    <message>
        <source>Take a corner.</source>
        <translation>Фатете едно теме.</translation>
    </message>
    <message>
        <source>Make it sway</source>
        <translation>Нека се ниша</translation>
    </message>
    <message>
        <source>Grow variations</source>
        <translation>Одгледајте варијанти</translation>
    </message>
    <message>
        <source>Save a poster</source>
        <translation>Зачувајте постер</translation>
    </message>
</context>
<context>
    <name>FlameBanner</name>
    <message>
        <source>Flames</source>
        <translation>Пламени</translation>
    </message>
    <message numerus="yes">
        <source>%n flames</source>
        <translation>
            <numerusform>%n пламен</numerusform>
            <numerusform>%n пламени</numerusform>
            <numerusform>%n пламени</numerusform>
        </translation>
    </message>
    <message>
        <source>In flame files, y points down. The flames were flipped so that they look the same here as in flame programs.</source>
        <translation>Во пламените y расте надолу. Превртени се, за тука да изгледаат како во flame-програмите.</translation>
    </message>
    <message>
        <source>Keep &amp;y As Written</source>
        <translation>Остави ја &amp;y како што е запишана</translation>
    </message>
    <message>
        <source>Uses the numbers as they are in the file. The picture is then upside down.</source>
        <translation>Ги зема броевите на пламените како што се во текстот. Сликата тогаш е превртена.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Keep y as written</source>
        <translation>Остави ја y како што е запишана</translation>
    </message>
    <message>
        <source>Flip the flames</source>
        <translation>Преврти ги пламените</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Show or hide the “%1” panel</source>
        <translation>Прикажи или скриј го панелот „%1“</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Збирка</translation>
    </message>
    <message>
        <source>Maps</source>
        <translation>Пресликувања</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Кафез</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Изглед</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Анализа</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Историја</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Проблеми</translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation>„%1“ не можеше да се отвори</translation>
    </message>
    <message>
        <source>Recovered %1. It is not saved yet.</source>
        <translation>Обновено: %1. Сѐ уште не е зачувано.</translation>
    </message>
    <message numerus="yes">
        <source>%n entries</source>
        <translation>
            <numerusform>%n запис</numerusform>
            <numerusform>%n записи</numerusform>
            <numerusform>%n записи</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them could not be read and are kept unchanged</source>
        <translation>
            <numerusform>, %n од нив не можеше да се прочита и е задржан како што е</numerusform>
            <numerusform>, %n од нив не можеа да се прочитаат и се задржани како што се</numerusform>
            <numerusform>, %n од нив не можеа да се прочитаат и се задржани како што се</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with warnings</source>
        <translation>
            <numerusform>, %n прочитан со забелешка</numerusform>
            <numerusform>, %n прочитани со забелешка</numerusform>
            <numerusform>, %n прочитани со забелешка</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Отвори</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Незачувани измени</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>„%1“ има измени што не се зачувани.</translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation>Дали сакате да ги зачувате?</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>Изменета на дискот</translation>
    </message>
    <message>
        <source>Another program has changed “%1” since you opened it.</source>
        <translation>Откако е отворена тука, датотеката „%1“ ја изменила друга програма.</translation>
    </message>
    <message>
        <source>Saving overwrites the changes made by the other program.</source>
        <translation>Со зачувувањето се заменува она што го запишала другата програма.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Замени</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Зачувај како…</translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation>„%1“ не е зачувана</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Зачувано: %1.</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Зачувај како</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs)</source>
        <translation>Збирки на Fractint (*.ifs)</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Врати од диск</translation>
    </message>
    <message>
        <source>Revert to “%1” as it is on disk? Your changes since then will be lost.</source>
        <translation>Да се врати „%1“ како што е на дискот? Измените направени оттогаш ќе се изгубат.</translation>
    </message>
    <message>
        <source>%1 could not be reloaded</source>
        <translation>„%1“ не можеше повторно да се прочита</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Нема неодамнешни датотеки</translation>
    </message>
    <message>
        <source>Clear List</source>
        <translation>Исчисти го списокот</translation>
    </message>
    <message>
        <source>%1[*] — %2</source>
        <comment>file, entry</comment>
        <translation>%1[*] — %2</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Датотека</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Нова</translation>
    </message>
    <message>
        <source>Start with a Sierpiński triangle</source>
        <translation>Започни со триаголник на Серпињски</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Нов &amp;прозорец</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation>Отвори друг прозорец</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Отвори…</translation>
    </message>
    <message>
        <source>Open a collection of fractals</source>
        <translation>Отвори збирка фрактали</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Неодамна отво&amp;рени</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Зачувај</translation>
    </message>
    <message>
        <source>Save the file; entries that you did not edit stay unchanged, byte for byte</source>
        <translation>Зачувај ја датотеката; неизменетите записи го задржуваат секој бајт</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Зачувај &amp;како…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Save the file under another name</source>
        <translation>Зачувај ја датотеката под друго име</translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation>Врати од &amp;диск</translation>
    </message>
    <message>
        <source>Discard your changes and reload the file from disk</source>
        <translation>Врати ја датотеката како што е на дискот</translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation>Извези &amp;слика…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Export &amp;Data…</source>
        <translation>Извези подато&amp;ци…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Export the maps or points as a flame, for IFStile, as a table or a point cloud</source>
        <translation>Извези ги пресликувањата или точките како пламен, за IFStile, како табела или како облак од точки</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Копира&amp;ј ја сликата</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy the picture to the clipboard</source>
        <translation>Копирај ја сликата на таблата со исечоци</translation>
    </message>
    <message>
        <source>The picture was copied to the clipboard.</source>
        <translation>Сликата е на таблата со исечоци.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Пе&amp;чати…</translation>
    </message>
    <message>
        <source>Print the picture, its name and its coefficients</source>
        <translation>Печати ја сликата, нејзиното име и нејзините коефициенти</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>За&amp;твори</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Затвори го овој прозорец</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Излези</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Затвори ги сите прозорци</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Уреди</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Врати</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Ctrl+Z</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>Врати ја последната измена</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повтори</translation>
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
        <translation>Повтори ја вратената измена</translation>
    </message>
    <message>
        <source>&amp;Transform…</source>
        <translation>&amp;Трансформирај…</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Rotate, scale, shear, reflect or move the whole fractal by exact amounts</source>
        <translation>Ротирај, скалирај, искоси, отсликај или премести го целиот фрактал со внесување броеви</translation>
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
        <translation>Избери еден од многу случајно создадени фрактали и додај го во датотеката</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>Постав&amp;ки…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Cage</source>
        <translation>&amp;Кафез</translation>
    </message>
    <message>
        <source>&amp;Drag the Cage</source>
        <translation>Повле&amp;чи го кафезот</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>De&amp;fine Triangle</source>
        <translation>&amp;Дефинирај триаголник</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Опфати со минимален каноничен &amp;симплекс</translation>
    </message>
    <message>
        <source>Fit the smallest isosceles right triangle with legs parallel to the axes around the attractor</source>
        <translation>Опфати го атракторот со најмалиот рамнокрак правоаголен триаголник околу него</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Врати во &amp;мирување</translation>
    </message>
    <message>
        <source>Return the cage to rest: the picture shows the code as it is</source>
        <translation>Врати го кафезот во мирување: кодот се црта онаков каков што е</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Впиши во кодот</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Write the placement into the code: the picture stays, and the coefficients change</source>
        <translation>Впиши ја поставеноста во кодот: сликата останува иста, се менуваат коефициентите</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Извади од кодот</translation>
    </message>
    <message>
        <source>Extract the placement from the code: the picture stays, and the code is rewritten for the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Извади ја поставеноста од кодот: сликата останува иста, а кодот станува код на триаголникот (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>&amp;Направи го правилен</translation>
    </message>
    <message>
        <source>Move the vertices to the nearest regular polygon</source>
        <translation>Стави ги темињата на правилниот многуаголник што им е најблизок</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>&amp;Афино инваријантен облик…</translation>
    </message>
    <message>
        <source>Show every map as a matrix over the control triangle, with rows that sum to 1</source>
        <translation>Прикажи го секое пресликување како редично-стохастичка матрица во однос на контролниот триаголник</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>Само п&amp;остави</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code does not change</source>
        <translation>Поместувањето на кафезот ја поместува сликата; кодот останува ист</translation>
    </message>
    <message>
        <source>Re&amp;write</source>
        <translation>Измени го &amp;кодот</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Поместувањето на кафезот го менува кодот</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Приказ</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Вклопи</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Show the whole fractal</source>
        <translation>Прикажи го целиот фрактал</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>&amp;Зголеми</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Зголеми го приказот</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>&amp;Намали</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Намали го приказот</translation>
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
        <translation>Прикажи ја единицата како сто пиксели</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Мрежа</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Прикажи ја мрежата</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Оски</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Show the axes</source>
        <translation>Прикажи ги оските</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>y-оската на&amp;долу</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Point the y axis down, as in window coordinates</source>
        <translation>Нека y расте надолу, како кај координатите на прозорец</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas except the picture</source>
        <translation>Скриј сѐ од платното освен сликата</translation>
    </message>
    <message>
        <source>&amp;Snap To</source>
        <translation>При&amp;лепи кон</translation>
    </message>
    <message>
        <source>&amp;Vertices</source>
        <translation>&amp;Темиња</translation>
    </message>
    <message>
        <source>Make dragged vertices snap to this</source>
        <translation>Темињата што се влечат нека се прилепуваат кон ова</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Панели</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>На &amp;цел екран</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Fill the whole screen</source>
        <translation>Користи го целиот екран</translation>
    </message>
    <message>
        <source>How It Is Built</source>
        <translation>Како се гради</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor being built: in steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Гледај како се гради атракторот: по чекори на детерминистичкиот алгоритам или со игра на хаосот</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>П&amp;омош</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>&amp;Најди наредба…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Find any command by typing what it does</source>
        <translation>Најди која било наредба со пишување на она што го прави</translation>
    </message>
    <message>
        <source>&amp;Keyboard and Mouse…</source>
        <translation>&amp;Тастатура и глувче…</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Every shortcut and gesture</source>
        <translation>Сите кратенки и движења</translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation>&amp;Упатство за корисници (на англиски)</translation>
    </message>
    <message>
        <source>Read the user guide</source>
        <translation>Прочитај го упатството за корисници</translation>
    </message>
    <message>
        <source>&amp;About Barycage</source>
        <translation>&amp;За Barycage</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Верзија и лиценца</translation>
    </message>
    <message>
        <source>About Barycage</source>
        <translation>За Barycage</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Grab a fractal by its corners: an editor for iterated function systems that describes their attractors in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Фатете го фракталот за темињата: уредувач на итерирани функциски системи чии атрактори се зададени во барицентрични координати на контролен триаголник.&lt;/p&gt;&lt;p&gt;Според Е. Хаџиева и М. Шуминоска, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Лиценца MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>З&amp;а Qt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Алатки</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Обиколка</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>&amp;Што е ова?</translation>
    </message>
    <message>
        <source>Click anything to see what it does</source>
        <translation>Кликнете на што било за да прочитате за што служи</translation>
    </message>
    <message>
        <source>Recovery Unavailable</source>
        <translation>Обновувањето не е можно</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Дозволи системи &amp;без атрактор</translation>
    </message>
    <message>
        <source>Let a drag of maps continue where an attractor is no longer guaranteed</source>
        <translation>Влечењето на пресликувањата нека продолжи и таму каде што атрактор веќе не е загарантиран</translation>
    </message>
    <message>
        <source>Drag t&amp;he Maps</source>
        <translation>Влечи ги &amp;пресликувањата</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Show each map as its image of the cage, and drag it by its corners</source>
        <translation>Прикажи го секое пресликување како негова слика на кафезот и влечи го за темињата</translation>
    </message>
    <message>
        <source>Drag a Bra&amp;nch</source>
        <translation>Влечи &amp;гранка</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Click a point of the attractor and drag the branch that contains it</source>
        <translation>Кликни на точка од атракторот и влечи ја гранката што ја содржи</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>В&amp;метни</translation>
    </message>
    <message>
        <source>Your unsaved work was recovered nevertheless.</source>
        <translation>Незачуваната работа е сепак тука.</translation>
    </message>
    <message>
        <source>%1 was not recovered. Barycage will offer it again at the next start.</source>
        <translation>%1 не е вратено. Повторно ќе биде понудено при следното стартување.</translation>
    </message>
    <message>
        <source>Press Esc to bring back the menus and panels.</source>
        <translation>Esc ги враќа менијата и панелите.</translation>
    </message>
    <message>
        <source>P&amp;resentation</source>
        <translation>Презен&amp;тација</translation>
    </message>
    <message>
        <source>Shift+F11</source>
        <translation>Shift+F11</translation>
    </message>
    <message>
        <source>Show only the canvas in full screen, for example on a projector; press Esc to return</source>
        <translation>Целиот екран се остава на платното, на пример за проектор; Esc го враќа останатото</translation>
    </message>
    <message>
        <source>Add Ra&amp;ndom Fractal…</source>
        <translation>Додај &amp;случаен фрактал…</translation>
    </message>
    <message>
        <source>Only the Pi&amp;cture</source>
        <translation>&amp;Само сликата</translation>
    </message>
    <message>
        <source>Ca&amp;mera</source>
        <translation>Ка&amp;мера</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>На&amp;пред</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Назад</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Десно</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Лево</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Горе</translation>
    </message>
    <message>
        <source>Look down (7 on the keypad)</source>
        <translation>Поглед надолу (7 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>До&amp;лу</translation>
    </message>
    <message>
        <source>Look up (Ctrl+7 on the keypad)</source>
        <translation>Поглед нагоре (Ctrl+7 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Изометриски</translation>
    </message>
    <message>
        <source>Look from a corner (Home)</source>
        <translation>Поглед од агол (Home)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>Перспе&amp;ктива</translation>
    </message>
    <message>
        <source>In the menu %1.</source>
        <translation>Во менито „%1“.</translation>
    </message>
    <message>
        <source>Shortcut: %1</source>
        <translation>Кратенка: %1</translation>
    </message>
    <message>
        <source>Tool Options</source>
        <translation>Опции на алатката</translation>
    </message>
    <message>
        <source>Show the options of the tool under the canvas</source>
        <translation>Прикажи ги опциите на алатката под платното</translation>
    </message>
    <message>
        <source>A bar with the options of the current tool, or a reminder of how to use it.</source>
        <translation>Лента со опциите на тековната алатка или потсетник како се користи.</translation>
    </message>
    <message>
        <source>&amp;Maps</source>
        <translation>Пр&amp;есликувања</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>Преврти &amp;хоризонтално</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the vertical line through their centre</source>
        <translation>Преврти ги избраните пресликувања околу вертикалата низ нивното средиште</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>Преврти &amp;вертикално</translation>
    </message>
    <message>
        <source>Mirror the selected maps about the horizontal line through their centre</source>
        <translation>Преврти ги избраните пресликувања околу хоризонталата низ нивното средиште</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Left</source>
        <translation>Заврти 90° на&amp;лево</translation>
    </message>
    <message>
        <source>Rotate the selected maps counter-clockwise about their centre</source>
        <translation>Заврти ги избраните пресликувања спротивно од стрелките на часовникот околу нивното средиште</translation>
    </message>
    <message>
        <source>Rotate 90° &amp;Right</source>
        <translation>Заврти 90° на&amp;десно</translation>
    </message>
    <message>
        <source>Rotate the selected maps clockwise about their centre</source>
        <translation>Заврти ги избраните пресликувања во насока на стрелките на часовникот околу нивното средиште</translation>
    </message>
    <message>
        <source>Ali&amp;gn Centres</source>
        <translation>&amp;Порамни ги средиштата</translation>
    </message>
    <message>
        <source>In a &amp;Row</source>
        <translation>Во &amp;ред</translation>
    </message>
    <message>
        <source>Move the selected maps up or down until their centres are at the same height</source>
        <translation>Помести ги избраните пресликувања нагоре или надолу додека средиштата не им се на иста висина</translation>
    </message>
    <message>
        <source>In a &amp;Column</source>
        <translation>Во &amp;колона</translation>
    </message>
    <message>
        <source>Move the selected maps left or right until their centres are one below the other</source>
        <translation>Помести ги избраните пресликувања лево или десно додека средиштата не им се едно под друго</translation>
    </message>
    <message>
        <source>D&amp;istribute Centres</source>
        <translation>&amp;Распореди ги средиштата</translation>
    </message>
    <message>
        <source>&amp;Horizontally</source>
        <translation>&amp;Хоризонтално</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from left to right</source>
        <translation>Рамномерно распореди ги средиштата на избраните пресликувања од лево кон десно</translation>
    </message>
    <message>
        <source>&amp;Vertically</source>
        <translation>&amp;Вертикално</translation>
    </message>
    <message>
        <source>Space the centres of the selected maps evenly from bottom to top</source>
        <translation>Рамномерно распореди ги средиштата на избраните пресликувања од долу кон горе</translation>
    </message>
    <message>
        <source>&amp;Fit to Corners</source>
        <translation>Постави во &amp;темињата</translation>
    </message>
    <message>
        <source>Move each selected map so that it leaves the nearest corner of the cage fixed</source>
        <translation>Помести го секое избрано пресликување додека најблиското теме на кафезот не се пресликува во себе</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Прво изберете пресликување.</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Удвои ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Избриши ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Select all maps</source>
        <translation>Избери ги сите пресликувања</translation>
    </message>
    <message>
        <source>&amp;Duplicate Maps</source>
        <translation>Дуп&amp;лирај пресликувања</translation>
    </message>
    <message>
        <source>D&amp;elete Maps</source>
        <translation>&amp;Избриши пресликувања</translation>
    </message>
    <message>
        <source>Select &amp;All Maps</source>
        <translation>Избери ги &amp;сите пресликувања</translation>
    </message>
    <message>
        <source>Missing on disk</source>
        <translation>Ја нема на дискот</translation>
    </message>
    <message>
        <source>“%1” has been deleted, renamed or moved since you opened it.</source>
        <translation>Откако е отворена тука, датотеката „%1“ е избришана, преименувана или преместена.</translation>
    </message>
    <message>
        <source>Saving creates it again in its old location.</source>
        <translation>Со зачувувањето повторно се создава на старото место.</translation>
    </message>
    <message>
        <source>Other names of the file (hard links) keep the old contents.</source>
        <translation>Другите имиња на датотеката (тврди врски) ја задржуваат старата содржина.</translation>
    </message>
    <message>
        <source>&amp;Lift to Space</source>
        <translation>По&amp;дигни во простор</translation>
    </message>
    <message>
        <source>Lift to Space</source>
        <translation>Подигни во простор</translation>
    </message>
    <message>
        <source>&amp;Flatten to the Plane</source>
        <translation>Сплеска&amp;ј во рамнина</translation>
    </message>
    <message>
        <source>Flatten to the Plane</source>
        <translation>Сплескај во рамнина</translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen, or a solid as a mesh for 3D printing</source>
        <translation>Ја извезува сликата како PNG, SVG или PDF, врамена како на екранот; тело и како предмет за печатење</translation>
    </message>
    <message>
        <source>&amp;Animation</source>
        <translation>&amp;Анимација</translation>
    </message>
    <message>
        <source>A&amp;nimate</source>
        <translation>А&amp;нимирај</translation>
    </message>
    <message>
        <source>Show the timeline under the canvas</source>
        <translation>Прикажи ја временската лента под платното</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Пушти</translation>
    </message>
    <message>
        <source>Play or stop the animation (Space on the canvas)</source>
        <translation>Пушти ја или запри ја анимацијата (Space на платното)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Пауза</translation>
    </message>
    <message>
        <source>P&amp;revious Frame</source>
        <translation>П&amp;ретходен кадар</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Move the playhead back one frame</source>
        <translation>Врати ја главата за пуштање еден кадар назад</translation>
    </message>
    <message>
        <source>Ne&amp;xt Frame</source>
        <translation>&amp;Следен кадар</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Move the playhead forward one frame</source>
        <translation>Помести ја главата за пуштање еден кадар напред</translation>
    </message>
    <message>
        <source>Pre&amp;vious Key</source>
        <translation>Пре&amp;тходен клуч</translation>
    </message>
    <message>
        <source>Alt+,</source>
        <translation>Alt+,</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Помести ја главата за пуштање на претходниот клуч</translation>
    </message>
    <message>
        <source>Nex&amp;t Key</source>
        <translation>С&amp;леден клуч</translation>
    </message>
    <message>
        <source>Alt+.</source>
        <translation>Alt+.</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Помести ја главата за пуштање на следниот клуч</translation>
    </message>
    <message>
        <source>Set &amp;Key</source>
        <translation>Постави &amp;клуч</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Key the current track at the playhead</source>
        <translation>Постави клуч на избраната патека кај главата за пуштање</translation>
    </message>
    <message>
        <source>Set Keys of &amp;All Tracks</source>
        <translation>Постави клучеви на с&amp;ите патеки</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Key all tracks that have keys at the playhead, or all tracks if none has</source>
        <translation>Постави клучеви кај главата за пуштање на сите патеки што веќе имаат, или на сите ако ниедна нема</translation>
    </message>
    <message>
        <source>&amp;Delete Keys</source>
        <translation>И&amp;збриши клучеви</translation>
    </message>
    <message>
        <source>Delete the selected keys</source>
        <translation>Избриши ги избраните клучеви</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Временска лента</translation>
    </message>
    <message>
        <source>Fractal &amp;Transformation</source>
        <translation>Фрактална &amp;трансформација</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Show another entry beside this one, and colour this one by a picture placed on the other</source>
        <translation>Прикажи друг запис покрај овој и обој го овој со слика врз него</translation>
    </message>
    <message>
        <source>Export Ani&amp;mation…</source>
        <translation>Извези ани&amp;мација…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Export the animation as a video, an animated image or frames, on this computer or on a cluster</source>
        <translation>Извезете ја анимацијата како видео, подвижна слика или кадри, тука или на кластер</translation>
    </message>
    <message>
        <source>Nothing moves in this entry yet. Choose a motion in the timeline first: Animation, Animate.</source>
        <translation>Во овој запис сè уште ништо не се движи. Прво изберете движење во временската лента: Анимација, Анимирај.</translation>
    </message>
    <message>
        <source>A mesh needs a solid, and this entry lies in a plane: lift it to space first.</source>
        <translation>Тело за печатење постои само во просторот, а овој запис лежи во рамнина: прво подигнете го во просторот.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Врски</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Колаж</translation>
    </message>
    <message>
        <source>Four &amp;Views</source>
        <translation>Четири &amp;погледи</translation>
    </message>
    <message>
        <source>Define the control triangle with three clicks, or in space the tetrahedron with four</source>
        <translation>Го одредува контролниот триаголник со три клика, во просторот тетраедарот со четири</translation>
    </message>
    <message>
        <source>Look from the front (1 on the keypad)</source>
        <translation>Поглед од напред (1 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>Look from behind (Ctrl+1 on the keypad)</source>
        <translation>Поглед од назад (Ctrl+1 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>Look from the right (3 on the keypad)</source>
        <translation>Поглед од десно (3 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>Look from the left (Ctrl+3 on the keypad)</source>
        <translation>Поглед од лево (Ctrl+3 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>&amp;Z Up</source>
        <translation>&amp;Z нагоре</translation>
    </message>
    <message>
        <source>Point the z axis up, as in CAD programs; the fractal stays as it is</source>
        <translation>Оската z е насочена нагоре, како во CAD-програмите; фракталот останува ист</translation>
    </message>
    <message>
        <source>De&amp;fine Tetrahedron</source>
        <translation>&amp;Дефинирај тетраедар</translation>
    </message>
    <message>
        <source>Select maps or entries first: in their panels, or on the canvas with the Maps tool.</source>
        <translation>Прво изберете пресликувања или записи: во нивните панели, или на платното со алатката за пресликувања.</translation>
    </message>
    <message>
        <source>&amp;Cut</source>
        <translation>&amp;Исечи</translation>
    </message>
    <message>
        <source>Move the selected maps or entries to the clipboard</source>
        <translation>Премести ги избраните пресликувања или записи во таблата со исечоци</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Копирај</translation>
    </message>
    <message>
        <source>Add fractals from the clipboard to the file: entries of an .ifs file, flames or a table of numbers; or maps to the fractal</source>
        <translation>Додај фрактали од таблата со исечоци во датотеката: записи од .ifs датотека, flame или табела со броеви; или пресликувања во фракталот</translation>
    </message>
    <message>
        <source>Dupl&amp;icate</source>
        <translation>&amp;Удвои</translation>
    </message>
    <message>
        <source>Duplicate the selected maps or entries</source>
        <translation>Удвои ги избраните пресликувања или записи</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Delete the selected maps or entries</source>
        <translation>Избриши ги избраните пресликувања или записи</translation>
    </message>
    <message>
        <source>&amp;Select All</source>
        <translation>Избери &amp;сѐ</translation>
    </message>
    <message>
        <source>Select all maps or all entries</source>
        <translation>Избери ги сите пресликувања или сите записи</translation>
    </message>
    <message>
        <source>Breed variations of this fractal, or cross it with another one</source>
        <translation>Одгледувај варијанти на овој фрактал или вкрсти го со друг</translation>
    </message>
    <message>
        <source>The Chaos Game</source>
        <translation>Играта на хаосот</translation>
    </message>
    <message>
        <source>Why the Maple Fits Its Triangle</source>
        <translation>Зошто јаворот се собира во својот триаголник</translation>
    </message>
    <message>
        <source>&amp;Lesson</source>
        <translation>&amp;Лекција</translation>
    </message>
    <message>
        <source>&amp;Play Lesson</source>
        <translation>&amp;Пушти ја лекцијата</translation>
    </message>
    <message>
        <source>&amp;Next Step</source>
        <translation>&amp;Следен чекор</translation>
    </message>
    <message>
        <source>Show the next step of the lesson being played</source>
        <translation>Прикажи го следниот чекор од лекцијата што тече</translation>
    </message>
    <message>
        <source>Previous &amp;Step</source>
        <translation>&amp;Претходен чекор</translation>
    </message>
    <message>
        <source>Show the previous step of the lesson being played</source>
        <translation>Прикажи го претходниот чекор од лекцијата што тече</translation>
    </message>
    <message>
        <source>&amp;Add Step</source>
        <translation>&amp;Додај чекор</translation>
    </message>
    <message>
        <source>Add a step to the lesson, with the current state of the window</source>
        <translation>Додај ѝ на лекцијата чекор со сегашната состојба на прозорецот</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>&amp;Зачувај ја лекцијата…</translation>
    </message>
    <message>
        <source>The step now has the current state of the window.</source>
        <translation>Чекорот сега ја има состојбата на прозорецот.</translation>
    </message>
    <message>
        <source>End the lesson before you save (Esc).</source>
        <translation>Завршете ја лекцијата пред да зачувате (Esc).</translation>
    </message>
    <message>
        <source>Play this lesson, in a window of its own if this one is in use</source>
        <translation>Пушти ја оваа лекција, во посебен прозорец ако овој се користи</translation>
    </message>
    <message>
        <source>Unsaved lesson</source>
        <translation>Незачувана лекција</translation>
    </message>
    <message>
        <source>The lesson “%1” has unsaved changes.</source>
        <translation>Лекцијата „%1“ има измени што не се зачувани.</translation>
    </message>
    <message>
        <source>The lesson was not saved</source>
        <translation>Лекцијата не е зачувана</translation>
    </message>
    <message>
        <source>Lessons (*.lesson)</source>
        <translation>Лекции (*.lesson)</translation>
    </message>
    <message>
        <source>The fractals have unsaved changes.</source>
        <translation>Фракталите имаат измени што не се зачувани.</translation>
    </message>
    <message>
        <source>Step %1 has the current state of the window. Now write its text.</source>
        <translation>Чекорот %1 ја има состојбата на прозорецот. Напишете го неговиот текст.</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Снимки</translation>
    </message>
    <message>
        <source>Exports</source>
        <translation>Извози</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Лекција</translation>
    </message>
    <message>
        <source>&amp;Ready-Made Lessons</source>
        <translation>&amp;Готови лекции</translation>
    </message>
    <message>
        <source>Re&amp;name Map</source>
        <translation>Преиме&amp;нувај пресликување</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Дај му име на тековното пресликување</translation>
    </message>
    <message>
        <source>Loc&amp;k or Unlock Maps</source>
        <translation>&amp;Заклучи или отклучи пресликувања</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing, or unlock them</source>
        <translation>Заштити ги избраните пресликувања од измени, или престани со тоа</translation>
    </message>
    <message>
        <source>Show Map Al&amp;one</source>
        <translation>Прикажи само едн&amp;о пресликување</translation>
    </message>
    <message>
        <source>Show the current map alone, or all of them again</source>
        <translation>Прикажи го само тековното пресликување, или пак сите</translation>
    </message>
    <message>
        <source>Saved &amp;Views</source>
        <translation>За&amp;чувани погледи</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>&amp;Зачувај поглед…</translation>
    </message>
    <message>
        <source>Keep what the canvas shows under a name, with the fractal</source>
        <translation>Зачувај го под име, со фракталот, она што го покажува платното</translation>
    </message>
    <message>
        <source>&amp;Edit Views…</source>
        <translation>&amp;Уреди погледи…</translation>
    </message>
    <message>
        <source>Go to saved views, rename or delete them</source>
        <translation>Оди до зачуваните погледи, преименувај ги или избриши ги</translation>
    </message>
    <message>
        <source>No saved views</source>
        <translation>Нема зачувани погледи</translation>
    </message>
    <message>
        <source>Views that you save are listed here.</source>
        <translation>Тука се наведени погледите што ги зачувувате.</translation>
    </message>
    <message>
        <source>Show this part of the fractal again</source>
        <translation>Повторно прикажи го овој дел од фракталот</translation>
    </message>
    <message>
        <source>Save the view “%1”</source>
        <translation>Зачувување на погледот „%1“</translation>
    </message>
    <message>
        <source>Print &amp;Handout…</source>
        <translation>Печати &amp;лист за час…</translation>
    </message>
    <message>
        <source>Print entries for a class: pictures with cage, maps and formulas, or a blank worksheet</source>
        <translation>Печати записи за час: слики со кафез, пресликувања и формули, или празен лист со задачи</translation>
    </message>
    <message>
        <source>Copy as La&amp;TeX</source>
        <translation>Копирај како &amp;LaTeX</translation>
    </message>
    <message>
        <source>&amp;Table of Maps</source>
        <translation>&amp;Табела на пресликувањата</translation>
    </message>
    <message>
        <source>Copy the coefficients as a tabular</source>
        <translation>Копирај ги коефициентите како tabular</translation>
    </message>
    <message>
        <source>&amp;Formulas with Matrices</source>
        <translation>&amp;Формули со матрици</translation>
    </message>
    <message>
        <source>Copy each map as a matrix and a vector</source>
        <translation>Копирај го секое пресликување како матрица и вектор</translation>
    </message>
    <message>
        <source>&amp;Affine Invariant Form</source>
        <translation>&amp;Афино инваријантен облик</translation>
    </message>
    <message>
        <source>Copy one matrix per map, in barycentric coordinates of the triangle</source>
        <translation>Копирај по една матрица за пресликување, во барицентрични координати на триаголникот</translation>
    </message>
    <message>
        <source>Fi&amp;gure (TikZ)</source>
        <translation>С&amp;лика (TikZ)</translation>
    </message>
    <message>
        <source>Copy the cage and its images under the maps, with numbers and fixed points, as shown on the canvas</source>
        <translation>Копирај го кафезот и неговите слики според пресликувањата, со броеви и неподвижни точки, како што се прикажани</translation>
    </message>
    <message>
        <source>Copied. The document needs %1.</source>
        <translation>Копирано. На документот му треба %1.</translation>
    </message>
    <message>
        <source>Map numbers</source>
        <translation>Броеви</translation>
    </message>
    <message>
        <source>&amp;Numbers of Maps</source>
        <translation>&amp;Броеви на пресликувањата</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Show the number and the fixed point of each map</source>
        <translation>Прикажи ги бројот и неподвижната точка на секое пресликување</translation>
    </message>
    <message>
        <source>Rotate View &amp;Left</source>
        <translation>Сврти го погледот на&amp;лево</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate the view counter-clockwise by 15°</source>
        <translation>Сврти го прикажаното за 15° спротивно од стрелките на часовникот</translation>
    </message>
    <message>
        <source>Rotate View &amp;Right</source>
        <translation>Сврти го погледот на&amp;десно</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>Rotate the view clockwise by 15°</source>
        <translation>Сврти го прикажаното за 15° во насока на стрелките на часовникот</translation>
    </message>
    <message>
        <source>Re&amp;set Rotation</source>
        <translation>Поништи го &amp;вртењето</translation>
    </message>
    <message>
        <source>Return the view to upright</source>
        <translation>Исправи го погледот</translation>
    </message>
    <message>
        <source>Side &amp;by Side</source>
        <translation>Еден до дру&amp;г</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>Show another entry beside this one, to compare and edit both</source>
        <translation>Прикажи друг запис до овој за споредба и уредување на двата</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Копирано.</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Најди…</translation>
    </message>
    <message>
        <source>Find “%1”</source>
        <translation>Најди ја „%1“</translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs *.par)</source>
        <translation>Збирки на Fractint (*.ifs *.par)</translation>
    </message>
    <message>
        <source>The lesson now refers to %1. Save the lesson to keep this change.</source>
        <translation>Лекцијата сега припаѓа на %1. Зачувајте ја лекцијата за да остане така.</translation>
    </message>
    <message>
        <source>The fractal transformation was hidden to show how the attractor is built.</source>
        <translation>Фракталната трансформација е сокриена за да се покаже како се гради атракторот.</translation>
    </message>
    <message>
        <source>Add a third dimension to every map; the picture stays flat until you move a map</source>
        <translation>Му додава трета димензија на секое пресликување; сликата останува рамна додека не поместите пресликување</translation>
    </message>
    <message>
        <source>Replace the solid by its projection along the first axis that every map keeps</source>
        <translation>Го заменува телото со неговата проекција долж првата оска што ја задржува секое пресликување</translation>
    </message>
    <message>
        <source>Plays this lesson in full screen, with its text next to the picture. Page Down and Page Up go to the next and the previous step. Esc ends the lesson.</source>
        <translation>Ја пушта лекцијата на цел екран, со текстот покрај сликата. Page Down и Page Up водат кон следниот и претходниот чекор. Esc ја завршува лекцијата.</translation>
    </message>
    <message>
        <source>Make distant parts look smaller (5 on the keypad)</source>
        <translation>Подалечните делови се прикажуваат помали (5 на нумеричката тастатура)</translation>
    </message>
    <message>
        <source>Snapshots are not saved with the file and will be lost: %1. To keep one, cancel and choose Add as Entry in the Snapshots panel.</source>
        <translation>Снимките не се зачувуваат со датотеката и ќе се изгубат: %1. За да задржите некоја, откажете и изберете „Додај како запис“ во таблата „Снимки“.</translation>
    </message>
    <message>
        <source>The target in the Collage panel is not saved with the file.</source>
        <translation>Целта во панелот „Колаж“ не се зачувува со датотеката.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Пушти ја лекцијата на целиот екран, од почеток или од чекорот на кој кликнавте во списокот</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Отфрли</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;ткажи</translation>
    </message>
    <message>
        <source>The lesson has unsaved changes.</source>
        <translation>Лекцијата има незачувани промени.</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Зачувај ја лекцијата како текст што упатува на нејзините фрактали</translation>
    </message>
    <message>
        <source>Sa&amp;ve Lesson As…</source>
        <translation>Зачувај ја лекцијата к&amp;ако…</translation>
    </message>
    <message>
        <source>Save the lesson under another name or in another folder</source>
        <translation>Зачувај ја лекцијата под друго име или во друга папка</translation>
    </message>
    <message>
        <source>The lesson names no file of fractals (“file: name.ifs”).</source>
        <translation>Лекцијата не именува датотека со фрактали („file: ime.ifs“).</translation>
    </message>
    <message>
        <source>The file of its fractals, “%1”, was not found. It may have been renamed or moved.</source>
        <translation>Датотеката со нејзините фрактали, „%1“, не е најдена. Можеби е преименувана или преместена.</translation>
    </message>
    <message>
        <source>Save Lesson</source>
        <translation>Зачувување на лекцијата</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. Save the fractals as a .ifs file first, with no : * ? &quot; &lt; &gt; | in its name and folders.</source>
        <translation>Лекција не може да упати на „%1“. Прво зачувајте ги фракталите како датотека .ifs, без : * ? &quot; &lt; &gt; | во името и во папките.</translation>
    </message>
    <message>
        <source>If you discard the changes, the snapshots of them will be lost, too: %1.</source>
        <translation>Ако ги отфрлите измените, ќе се изгубат и нивните снимки: %1.</translation>
    </message>
    <message>
        <source>Unsaved snapshots</source>
        <translation>Незачувани снимки</translation>
    </message>
    <message>
        <source>“%1” has snapshots that are not saved.</source>
        <translation>„%1“ има снимки што не се зачувани.</translation>
    </message>
    <message>
        <source>Revert to “%1” as it is on disk?</source>
        <translation>Да се врати „%1“ како што е на дискот?</translation>
    </message>
    <message>
        <source>Replace the view “%1”</source>
        <translation>Замена на погледот „%1“</translation>
    </message>
    <message>
        <source>Drag the corners of the cage</source>
        <translation>Влечи ги темињата на кафезот</translation>
    </message>
    <message>
        <source>Show the solid from the top, the front and the right, and in perspective</source>
        <translation>Прикажи го телото одозгора, однапред, оддесно и во перспектива</translation>
    </message>
    <message>
        <source>%1 names a file outside its folder.</source>
        <translation>%1 именува датотека надвор од својата папка.</translation>
    </message>
    <message>
        <source>Its fractals are in “%1”. Open that file only if you trust the lesson.</source>
        <translation>Нејзините фрактали се во „%1“. Отворете ја таа датотека само ако ѝ верувате на лекцијата.</translation>
    </message>
    <message>
        <source>&amp;Open It</source>
        <translation>&amp;Отвори</translation>
    </message>
    <message>
        <source>Save a Copy for Other Programs</source>
        <translation>Зачувај копија за други програми</translation>
    </message>
    <message>
        <source>A copy needs another name than the file itself.</source>
        <translation>Копијата мора да има друго име од самата датотека.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Се зачувува „%1“…</translation>
    </message>
    <message>
        <source>Saved the copy %1.</source>
        <translation>Зачувана е копијата %1.</translation>
    </message>
    <message>
        <source>Other programs still draw these entries differently: %1.</source>
        <translation>Другите програми сè уште поинаку ги цртаат овие записи: %1.</translation>
    </message>
    <message>
        <source>Save a Copy &amp;for Other Programs…</source>
        <translation>Зачувај копија за дру&amp;ги програми…</translation>
    </message>
    <message>
        <source>Save a copy with the placements written into the code and every map listed, so that other programs draw what you see</source>
        <translation>Зачувај копија со поставеностите впишани во кодот и со сите пресликувања наведени, за другите програми да го нацртаат она што го гледате</translation>
    </message>
    <message>
        <source>The previous version is %1.</source>
        <translation>Претходната верзија е %1.</translation>
    </message>
    <message>
        <source>The previous version was not kept: there is already a file %1 that Barycage did not make.</source>
        <translation>Претходната верзија не е зачувана: веќе постои датотека %1 што Barycage не ја направил.</translation>
    </message>
    <message>
        <source>The previous version could not be kept as %1.</source>
        <translation>Претходната верзија не можеше да се зачува како %1.</translation>
    </message>
    <message numerus="yes">
        <source>Open %n files?</source>
        <translation>
            <numerusform>Да се отвори %n датотека?</numerusform>
            <numerusform>Да се отворат %n датотеки?</numerusform>
            <numerusform>Да се отворат %n датотеки?</numerusform>
        </translation>
    </message>
    <message>
        <source>Each of them opens in a window of its own.</source>
        <translation>Секоја се отвора во свој прозорец.</translation>
    </message>
    <message>
        <source>Open &amp;All</source>
        <translation>Отвори ги &amp;сите</translation>
    </message>
    <message>
        <source>Open the &amp;First %1</source>
        <translation>Отвори ги &amp;првите %1</translation>
    </message>
    <message>
        <source>Opening files…</source>
        <translation>Се отвораат датотеки…</translation>
    </message>
    <message>
        <source>%1 is also open in another window of Barycage. Whichever saves last replaces what the other saved.</source>
        <translation>%1 е отворена и во друг прозорец на Barycage. Што ќе се зачува последно, го заменува она што е зачувано во другиот.</translation>
    </message>
    <message>
        <source>Export Web Page</source>
        <translation>Извези веб-страница</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Веб-страници (*.html)</translation>
    </message>
    <message>
        <source>%1 was written. Open it in a browser, or mail it: it needs no network.</source>
        <translation>%1 е запишана. Отворете ја во прелистувач или пратете ја по пошта: не ѝ треба мрежа.</translation>
    </message>
    <message>
        <source>Stretch Ke&amp;ys…</source>
        <translation>Растегни клу&amp;чеви…</translation>
    </message>
    <message>
        <source>Make a range of frames slower or faster: the keys of all tracks spread</source>
        <translation>Забавува или забрзува дел од анимацијата: клучевите на сите траки се распоредуваат</translation>
    </message>
    <message>
        <source>There are no keys to stretch. Choose Set Key first.</source>
        <translation>Нема клучеви за растегнување. Прво поставете клуч.</translation>
    </message>
    <message>
        <source>Copy the picture, the selected maps or the selected entries</source>
        <translation>Ја копира сликата, избраните пресликувања или избраните записи</translation>
    </message>
    <message>
        <source>Export We&amp;b Page…</source>
        <translation>Извези ве&amp;б-страница…</translation>
    </message>
    <message>
        <source>Export the fractal in its cage as one file for browsers, in which it can be dragged</source>
        <translation>Извези го фракталот во неговиот кафез како една датотека за прелистувачи, во кои може да се влече</translation>
    </message>
    <message>
        <source>Six short steps that you do yourself: drag, squeeze, undo, collection, wind, export</source>
        <translation>Шест кратки чекори што ги правите сами: влечење, стискање, поништување, збирка, ветер, извоз</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Show a centre and height, the point of an address, or a fixed point</source>
        <translation>Прикажува средина и висина, точка на адреса или неподвижна точка</translation>
    </message>
    <message>
        <source>Language, theme, picture quality, shortcuts, and what opens at startup</source>
        <translation>Јазик, тема, квалитет на сликата, кратенки и што се отвора при стартување</translation>
    </message>
    <message>
        <source>&amp;Variations…</source>
        <translation>&amp;Варијанти…</translation>
    </message>
    <message>
        <source>S&amp;hadow</source>
        <translation>Се&amp;нка</translation>
    </message>
    <message>
        <source>Lay a flat, dark copy of the picture on the ground behind it</source>
        <translation>Положи рамна, темна копија на сликата на подот зад неа</translation>
    </message>
    <message>
        <source>Add a shadow</source>
        <translation>Додај сенка</translation>
    </message>
    <message>
        <source>Remove the shadow</source>
        <translation>Отстрани ја сенката</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Анимирај</translation>
    </message>
    <message>
        <source>&amp;Keys and Frames</source>
        <translation>&amp;Клучеви и кадри</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Гранка</translation>
    </message>
    <message>
        <source>M&amp;ore</source>
        <translation>Пове&amp;ќе</translation>
    </message>
    <message>
        <source>D&amp;iscover</source>
        <translation>Отк&amp;ривање</translation>
    </message>
    <message>
        <source>&amp;Collection</source>
        <translation>&amp;Збирка</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Search the fractals that come with the program, and your favourites</source>
        <translation>Пребарај ги фракталите што доаѓаат со програмата и твоите омилени</translation>
    </message>
    <message>
        <source>S&amp;napshots</source>
        <translation>С&amp;нимки</translation>
    </message>
    <message>
        <source>&amp;Fractal</source>
        <translation>&amp;Фрактал</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>Изве&amp;зи</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Зачувај</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Извези</translation>
    </message>
    <message>
        <source>&amp;Selected Maps</source>
        <translation>&amp;Избрани пресликувања</translation>
    </message>
    <message>
        <source>&amp;Teach</source>
        <translation>&amp;Настава</translation>
    </message>
    <message>
        <source>&amp;Navigate</source>
        <translation>&amp;Движење</translation>
    </message>
    <message>
        <source>&amp;Go To…</source>
        <translation>&amp;Оди на…</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Вклопи</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>П&amp;латно</translation>
    </message>
    <message>
        <source>How It Is &amp;Built</source>
        <translation>&amp;Како се гради</translation>
    </message>
    <message>
        <source>Web page written</source>
        <translation>Веб-страницата е запишана</translation>
    </message>
    <message>
        <source>Copy &amp;Link</source>
        <translation>Копирај &amp;врска</translation>
    </message>
    <message>
        <source>Copy a link that holds the fractal: Barycage opens it when it is pasted</source>
        <translation>Копирај врска што го содржи фракталот: Barycage ја отвора кога ќе се вметне</translation>
    </message>
    <message>
        <source>The link was copied to the clipboard. It holds the whole fractal.</source>
        <translation>Врската е на таблата со исечоци. Го содржи целиот фрактал.</translation>
    </message>
    <message>
        <source>Hidden in this small window: %1 (View › Panels).</source>
        <translation>Скриени во овој мал прозорец: %1 (Приказ › Панели).</translation>
    </message>
    <message>
        <source>Pr&amp;int Lesson…</source>
        <translation>П&amp;ечати ја лекцијата…</translation>
    </message>
    <message>
        <source>Print the steps of the lesson, with their pictures and texts</source>
        <translation>Печати ги чекорите на лекцијата, со нивните слики и текстови</translation>
    </message>
    <message>
        <source>Copy as &amp;Python</source>
        <translation>Копирај како &amp;Python</translation>
    </message>
    <message>
        <source>Copy lines for a notebook that make the fractal with the Python package “barycage”</source>
        <translation>Копирај редови за тетратка што го создаваат фракталот со пакетот за Python „barycage“</translation>
    </message>
    <message>
        <source>Files with fractals (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures with an embedded fractal (*.png *.svg);;Lessons (*.lesson);;All files (*)</source>
        <translation>Датотеки со фрактали (*.ifs *.par *.lesson *.flame *.flam3 *.csv *.tsv *.txt *.png *.svg);;Збирки на Fractint (*.ifs *.par);;Пламени (*.flame *.flam3);;Табели со броеви (*.csv *.tsv *.txt);;Слики што го носат својот фрактал (*.png *.svg);;Лекции (*.lesson);;Сите датотеки (*)</translation>
    </message>
    <message>
        <source>The lesson is not saved yet: choose Save Lesson.</source>
        <translation>Лекцијата сè уште не е зачувана: изберете „Зачувај лекција“.</translation>
    </message>
    <message>
        <source>laser plotter cutter engrave dxf outline millimetres millimeters</source>
        <translation>ласер плотер сечење секач гравирање контура милиметри</translation>
    </message>
    <message>
        <source>Copy saved</source>
        <translation>Копијата е зачувана</translation>
    </message>
    <message>
        <source>%1 was saved for other programs.</source>
        <translation>%1 е зачувана за други програми.</translation>
    </message>
</context>
<context>
    <name>NumberField</name>
    <message>
        <source>The number must be greater than %1.</source>
        <translation>Бројот мора да биде поголем од %1.</translation>
    </message>
    <message>
        <source>The number must be at least %1.</source>
        <translation>Бројот мора да биде најмалку %1.</translation>
    </message>
    <message>
        <source>The number must be less than %1.</source>
        <translation>Бројот мора да биде помал од %1.</translation>
    </message>
    <message>
        <source>The number must be at most %1.</source>
        <translation>Бројот мора да биде најмногу %1.</translation>
    </message>
    <message>
        <source>A number is missing here.</source>
        <translation>Тука недостига број.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ не е број.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>„%1“ е преголем број.</translation>
    </message>
    <message>
        <source>“%1” has no finite value.</source>
        <translation>„%1“ нема конечна вредност.</translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Untitled</source>
        <translation>Без наслов</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Обновување на незачуваната работа</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
    </message>
    <message>
        <source>Reading “%1” was cancelled.</source>
        <translation>Читањето на „%1“ е откажано.</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Се зачувува „%1“…</translation>
    </message>
    <message>
        <source>Saving “%1” was cancelled. The file on disk is unchanged.</source>
        <translation>Зачувувањето на „%1“ е откажано. Датотеката на дискот е како што беше.</translation>
    </message>
    <message>
        <source>Adjust Picture Paths</source>
        <translation>Приспособи ги патеките на сликите</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Maple</source>
        <translation>Јавор</translation>
    </message>
    <message>
        <source>Fern</source>
        <translation>Папрат</translation>
    </message>
    <message>
        <source>Glacier</source>
        <translation>Глечер</translation>
    </message>
    <message>
        <source>Orchid</source>
        <translation>Орхидеја</translation>
    </message>
    <message>
        <source>Aurora</source>
        <translation>Поларна светлина</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Самрак</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Бакар</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Лагуна</translation>
    </message>
    <message>
        <source>Silver</source>
        <translation>Сребро</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Мастило</translation>
    </message>
    <message>
        <source>Herbarium</source>
        <translation>Хербариум</translation>
    </message>
    <message>
        <source>Sanguine</source>
        <translation>Сангвина</translation>
    </message>
    <message>
        <source>Cyanotype</source>
        <translation>Цијанотипија</translation>
    </message>
    <message>
        <source>%1 Glow</source>
        <translation>Сјај: %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>Од %1 до %2</translation>
    </message>
    <message>
        <source>%1 into %2</source>
        <translation>%1 наспроти %2</translation>
    </message>
    <message>
        <source>%1 Spectrum</source>
        <translation>Спектар од %1</translation>
    </message>
    <message>
        <source>%1 Pastel</source>
        <translation>Пастел: %1</translation>
    </message>
    <message>
        <source>%1 Metal</source>
        <translation>Метал: %1</translation>
    </message>
    <message>
        <source>%1 Bands</source>
        <translation>Ленти: %1</translation>
    </message>
    <message>
        <source>%1 Ink</source>
        <translation>Мастило: %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 и %2</translation>
    </message>
    <message>
        <source>%1 Twilight</source>
        <translation>Самрак: %1</translation>
    </message>
    <message>
        <source>%1 Wheel</source>
        <translation>Круг од %1</translation>
    </message>
    <message>
        <source>Rose</source>
        <translation>роза</translation>
    </message>
    <message>
        <source>Crimson</source>
        <translation>темноцрвена</translation>
    </message>
    <message>
        <source>Scarlet</source>
        <translation>скерлетна</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>цинобер</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>портокалова</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>килибар</translation>
    </message>
    <message>
        <source>Gold</source>
        <translation>златна</translation>
    </message>
    <message>
        <source>Lemon</source>
        <translation>лимон</translation>
    </message>
    <message>
        <source>Lime</source>
        <translation>лимета</translation>
    </message>
    <message>
        <source>Grass</source>
        <translation>трева</translation>
    </message>
    <message>
        <source>Emerald</source>
        <translation>смарагд</translation>
    </message>
    <message>
        <source>Jade</source>
        <translation>жад</translation>
    </message>
    <message>
        <source>Teal</source>
        <translation>тиркизнозелена</translation>
    </message>
    <message>
        <source>Sea</source>
        <translation>море</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>цијан</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>небо</translation>
    </message>
    <message>
        <source>Azure</source>
        <translation>азур</translation>
    </message>
    <message>
        <source>Cobalt</source>
        <translation>кобалт</translation>
    </message>
    <message>
        <source>Sapphire</source>
        <translation>сафир</translation>
    </message>
    <message>
        <source>Indigo</source>
        <translation>индиго</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>виолетова</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>пурпурна</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>магента</translation>
    </message>
    <message>
        <source>Fuchsia</source>
        <translation>фуксија</translation>
    </message>
</context>
<context>
    <name>PlacementBanner</name>
    <message>
        <source>Saved with dragged corners</source>
        <translation>Зачувано со поместени темиња</translation>
    </message>
    <message>
        <source>Other programs will show “%1” without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>Другите програми ќе го покажат „%1“ без темињата што ги поместивте, кои се запишани во коментари. „Впиши во кодот“ ги внесува во броевите што ги чита секоја програма.</translation>
    </message>
    <message numerus="yes">
        <source>Other programs will show %n entries without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>
            <numerusform>Другите програми ќе покажат %n запис без темињата што ги поместивте, кои се запишани во коментари. „Впиши во кодот“ ги внесува во броевите што ги чита секоја програма.</numerusform>
            <numerusform>Другите програми ќе покажат %n записи без темињата што ги поместивте, кои се запишани во коментари. „Впиши во кодот“ ги внесува во броевите што ги чита секоја програма.</numerusform>
            <numerusform>Другите програми ќе покажат %n записи без темињата што ги поместивте, кои се запишани во коментари. „Впиши во кодот“ ги внесува во броевите што ги чита секоја програма.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Впиши во кодот</translation>
    </message>
    <message>
        <source>Writes the placements into the code, as one step of the history.</source>
        <translation>Ги внесува поставеностите во кодот: еден чекор во историјата.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Bake the placements into the code</source>
        <translation>Впишување на поставеностите во кодот</translation>
    </message>
    <message>
        <source>Not baked, because no code has this picture or keys move it: %1.</source>
        <translation>Не е впишано, бидејќи ниеден код не ја дава оваа слика или ја движат клучеви: %1.</translation>
    </message>
    <message>
        <source>This cage cannot be baked: it bends or flattens the picture, or keys move it.</source>
        <translation>Овој кафез не може да се впише во кодот: ја криви или ја сплескува сликата, или го движат клучеви.</translation>
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
        <translation>Најдена е незачувана работа</translation>
    </message>
    <message>
        <source>In the last session, Barycage ended before this work was saved:</source>
        <translation>Минатиот пат Barycage заврши пред да се зачува оваа работа:</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Обнови</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Отфрли</translation>
    </message>
    <message>
        <source>Ask Later</source>
        <translation>Прашај подоцна</translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for recovery: the folder “%1” is not writable, or the disk is full. Save often.</source>
        <translation>Незачуваната работа не може да се чува за обновување: во папката „%1“ не може да се запишува или дискот е полн. Зачувувајте често.</translation>
    </message>
    <message>
        <source>The unsaved work from the last session is damaged and cannot be recovered. What remains of it is in:</source>
        <translation>Незачуваната работа од минатиот пат е оштетена и не може да се врати. Она што остана од неа се наоѓа во:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Се бара незачувана работа…</translation>
    </message>
    <message numerus="yes">
        <source>(%n windows)</source>
        <translation>
            <numerusform>(%n прозорец)</numerusform>
            <numerusform>(%n прозорци)</numerusform>
            <numerusform>(%n прозорци)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SnapshotBanner</name>
    <message>
        <source>Snapshot on the canvas</source>
        <translation>Снимка на платното</translation>
    </message>
    <message>
        <source>B: %1</source>
        <translation>B: %1</translation>
    </message>
    <message>
        <source>Back to the Fractal</source>
        <translation>Назад кон фракталот</translation>
    </message>
    <message>
        <source>Shows the fractal again. Nothing has changed.</source>
        <translation>Повторно го прикажува фракталот. Ништо не е сменето.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Врати</translation>
    </message>
    <message>
        <source>Restores the fractal to this snapshot, as one step of the history.</source>
        <translation>Го прави фракталот каков што беше на оваа снимка: еден чекор во историјата.</translation>
    </message>
    <message>
        <source>The canvas shows “%1”.</source>
        <translation>Платното ја покажува снимката „%1“.</translation>
    </message>
</context>
<context>
    <name>SnapshotCommands</name>
    <message>
        <source>Snapshots cannot be compared while a fractal transformation is shown.</source>
        <translation>Снимките не може да се споредуваат додека се прикажува фрактална трансформација.</translation>
    </message>
    <message>
        <source>Ta&amp;ke Snapshot</source>
        <translation>Направи с&amp;нимка</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Keep the current state of this fractal in the Snapshots panel</source>
        <translation>Зачувај ја сегашната состојба на фракталот во панелот „Снимки“</translation>
    </message>
    <message>
        <source>C&amp;ompare with Snapshot</source>
        <translation>Сп&amp;ореди со снимка</translation>
    </message>
    <message>
        <source>Q</source>
        <translation>Q</translation>
    </message>
    <message>
        <source>Kept as “%1”. To see it, choose View, Panels, Snapshots.</source>
        <translation>Зачувано како „%1“. Ја покажува „Приказ“, „Панели“, „Снимки“.</translation>
    </message>
    <message>
        <source>Show the snapshot selected in the Snapshots panel, or the newest one, in place of the fractal; to return, press the key again, or hold it and release it</source>
        <translation>Прикажи ја наместо фракталот снимката што е избрана во панелот „Снимки“, или најновата; притиснете повторно, или држете го копчето и пуштете го, за да се вратите</translation>
    </message>
    <message>
        <source>Snapshots can be compared only while the density is shown. Choose Density in the bar under the canvas first.</source>
        <translation>Снимките може да се споредуваат само додека се прикажува густината. Прво изберете „Густина“ во лентата под платното.</translation>
    </message>
</context>
<context>
    <name>SpaceBranch</name>
    <message>
        <source>No branch can be selected here: the address of this point is not known.</source>
        <translation>Тука не може да се избере гранка: адресата на оваа точка не е позната.</translation>
    </message>
    <message>
        <source>A branch cannot be dragged while it or the cage is flat.</source>
        <translation>Гранката не може да се влече додека таа или кафезот е рамен.</translation>
    </message>
</context>
<context>
    <name>SpaceDefinition</name>
    <message>
        <source>Click the first of the four corners. The picture stays where it is; Esc cancels.</source>
        <translation>Кликнете го првото од четирите темиња. Сликата останува каде што е; Esc откажува.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Кликнете го второто теме. Backspace ја отстранува последната точка.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Кликнете го третото теме. Backspace ја отстранува последната точка.</translation>
    </message>
    <message>
        <source>Click the fourth corner, in front of the other three. The wheel pushes it away, and the right button turns the view.</source>
        <translation>Кликнете го четвртото теме, пред другите три. Тркалцето го оддалечува, а десното копче го врти погледот.</translation>
    </message>
</context>
<context>
    <name>SpaceMapDrag</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Запрено: понатаму гранката не би станувала помала внатре во себе.</translation>
    </message>
</context>
<context>
    <name>SpaceMaps</name>
    <message>
        <source>Maps cannot be dragged while the cage is flat. First open or reset the cage.</source>
        <translation>Пресликувањата не може да се влечат додека кафезот е рамен. Прво отворете го или вратете го кафезот.</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 G points</source>
        <translation>%1 G точки</translation>
    </message>
    <message>
        <source>%1 M points</source>
        <translation>%1 M точки</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 точки</translation>
    </message>
    <message>
        <source>Pointer position</source>
        <translation>Положба на покажувачот</translation>
    </message>
    <message>
        <source>Existence of an attractor</source>
        <translation>Постоење на атрактор</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and its contraction factor</source>
        <translation>Дали системот има атрактор и со кој коефициент е контракција</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>Points drawn so far and the time of the last pass</source>
        <translation>Досега нацртани точки и време на последниот премин</translation>
    </message>
    <message>
        <source>  barycentric (%1)</source>
        <translation>  барицентрични (%1)</translation>
    </message>
    <message>
        <source>this entry could not be read</source>
        <translation>овој запис не можеше да се прочита</translation>
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
        <translation>Светски и барицентрични координати на покажувачот; адресата на точката од атракторот под него, прво најнадворешното пресликување, и неподвижната точка на нејзината гранка</translation>
    </message>
    <message>
        <source>  address %1</source>
        <translation>  адреса %1</translation>
    </message>
    <message>
        <source>  fixed point of %1 (%2, %3)</source>
        <translation>  неподвижна точка на %1 (%2, %3)</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 точка</translation>
    </message>
    <message>
        <source>latest changes not yet kept for recovery</source>
        <translation>последните промени сѐ уште не се чуваат за обновување</translation>
    </message>
    <message>
        <source>A crash would lose your latest changes: keeping them takes longer than two seconds, because the disk is slow or full or the file is very large. Save what you do not want to lose.</source>
        <translation>При пад на програмата би се изгубиле последните промени: нивното чување трае подолго од две секунди, бидејќи дискот е бавен или полн или датотеката е многу голема. Зачувајте го она што не смее да се изгуби.</translation>
    </message>
    <message>
        <source>  depth %1</source>
        <translation>  длабочина %1</translation>
    </message>
    <message>
        <source>  along %1</source>
        <translation>  по %1</translation>
    </message>
    <message>
        <source>  across %1</source>
        <translation>  напречно на %1</translation>
    </message>
    <message>
        <source>  along the normal</source>
        <translation>  по нормалата</translation>
    </message>
    <message>
        <source>  azimuth %1°  elevation %2°</source>
        <translation>  азимут %1°  елевација %2°</translation>
    </message>
    <message>
        <source>Rotation of the view</source>
        <translation>Вртење на погледот</translation>
    </message>
    <message>
        <source>How far the view is turned, counter-clockwise; choose View, Rotate View, Reset Rotation to return it to upright</source>
        <translation>Колку е свртен погледот спротивно од стрелките на часовникот; Приказ, Сврти го погледот, Поништи го вртењето повторно го исправа</translation>
    </message>
    <message>
        <source>rotated %1°</source>
        <translation>свртено за %1°</translation>
    </message>
    <message>
        <source>attractor: %1</source>
        <translation>атрактор: %1</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>Системот во сликата е поголем од 8 MB.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>Системот во сликата е оштетен.</translation>
    </message>
    <message>
        <source>The picture contains a document type declaration, which Barycage neither writes nor reads.</source>
        <translation>Сликата декларира тип на документ; тоа Barycage никогаш не го запишува и не го чита.</translation>
    </message>
    <message>
        <source>The file is not an SVG picture, or it is damaged.</source>
        <translation>Датотеката не е SVG-слика или е оштетена.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed it.</source>
        <translation>Сликата не содржи систем: не ја запишал Barycage или друга програма го отстранила.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a flame file cannot contain a document type declaration</source>
        <translation>тип на документ не се прифаќа во flame-датотека</translation>
    </message>
    <message>
        <source>The XML cannot be read beyond this point: %1.</source>
        <translation>XML-от завршува тука: %1.</translation>
    </message>
    <message>
        <source>The file contains no flames.</source>
        <translation>Во оваа датотека нема пламен.</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Се црта сликата…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Откажи</translation>
    </message>
    <message>
        <source>Print “%1”</source>
        <translation>Печатење на „%1“</translation>
    </message>
    <message>
        <source>no attractor</source>
        <translation>нема атрактор</translation>
    </message>
    <message>
        <source>the amount of “%1” is not a number</source>
        <translation>количеството на „%1“ не е број</translation>
    </message>
    <message>
        <source>it uses a variation other than linear</source>
        <translation>користи варијација што не е linear</translation>
    </message>
    <message>
        <source>it uses the variation “%1”</source>
        <translation>користи ја варијацијата „%1“</translation>
    </message>
    <message>
        <source>it is active but not drawn (opacity 0)</source>
        <translation>учествува, но не се црта (opacity 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>неговата тежина не е број</translation>
    </message>
    <message>
        <source>it has motion</source>
        <translation>има движење</translation>
    </message>
    <message>
        <source>it has layers</source>
        <translation>има слоеви</translation>
    </message>
    <message>
        <source>The flame “%1” is not a system of affine maps: %2.</source>
        <translation>Пламенот „%1“ не е систем од афини пресликувања: %2.</translation>
    </message>
    <message>
        <source>it has more than %1 transforms</source>
        <translation>има повеќе од %1 трансформации</translation>
    </message>
    <message>
        <source>transform %1: %2</source>
        <translation>трансформација %1: %2</translation>
    </message>
    <message>
        <source>The flame “%1” has no transforms.</source>
        <translation>Пламенот „%1“ нема трансформации.</translation>
    </message>
    <message>
        <source>The entry that starts here has no closing “}” before the next entry or the end of the file.</source>
        <translation>Записот што се отвора тука не е затворен со „}“ пред следниот запис или пред крајот на датотеката.</translation>
    </message>
    <message>
        <source>The name “%1” contains a control character, at which other programs may end it.</source>
        <translation>Името „%1“ содржи контролен знак, на кој други програми може да го завршат.</translation>
    </message>
    <message>
        <source>The name “%1” contains a space; Fractint uses only its first word.</source>
        <translation>Името „%1“ содржи празно место; Fractint го зема само првиот збор.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint truncates it.</source>
        <translation>Името „%1“ е подолго од 18 бајти; Fractint тука го сече.</translation>
    </message>
    <message>
        <source>The opening brace is on a line of its own; Fractint does not find this entry.</source>
        <translation>Отворената заграда стои сама во ред; Fractint не го наоѓа овој запис.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>Записот има повеќе од %1 пресликувања, а тоа е границата.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be a decimal comma or a separator; both readings give complete rows. Use decimal points and spaces.</source>
        <translation>„%1“: запирката може да се чита како децимална или како запирка меѓу два броја, и во двата случаи се добиваат цели редици. Пишувајте децимални точки и празни места.</translation>
    </message>
    <message>
        <source>“%1”: the comma gives complete rows of 7 numbers (13 with “(3D)”) neither as a decimal comma nor as a separator.</source>
        <translation>„%1“: ниту како децимална ниту како запирка меѓу два броја не се добиваат цели редици од 7 броја (13 со „(3D)“).</translation>
    </message>
    <message>
        <source>Numbers on the line of the opening brace are ignored, as in Fractint.</source>
        <translation>Броевите во редот на отворената заграда се занемаруваат, како што ги занемарува и Fractint.</translation>
    </message>
    <message>
        <source>This version of Barycage does not understand “%1”; the line is kept.</source>
        <translation>Оваа верзија на Barycage не го разбира „%1“; редот е задржан.</translation>
    </message>
    <message>
        <source>The entry contains no numbers.</source>
        <translation>Записот не содржи броеви.</translation>
    </message>
    <message>
        <source> in an entry marked “(3D)”</source>
        <translation> во запис означен со „(3D)“</translation>
    </message>
    <message>
        <source>“%1” is not a plain number: Fractint reads %2 and ignores the rest. Write it as one decimal number.</source>
        <translation>„%1“ не е обичен број: Fractint чита %2 и го занемарува остатокот. Напишете го како еден децимален број.</translation>
    </message>
    <message>
        <source>“%1” is not a finite number.</source>
        <translation>„%1“ не е конечен број.</translation>
    </message>
    <message>
        <source>“%1” is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>„%1“ е поголем отколку што може да биде коефициент (по апсолутна вредност најмногу 3.4e38).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Use a plain “-”.</source>
        <translation>„%1“ почнува со типографски минус (U+2212). Напишете обичен „-“.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ не е број.</translation>
    </message>
    <message>
        <source>There are numbers on the line of the opening brace, where Fractint ignores them; Barycage reads them.</source>
        <translation>Броевите стојат во редот на отворената заграда, каде што Fractint ги занемарува; тука се читаат.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads different numbers here.</source>
        <translation>Запирките се читаат како децимални; Fractint тука чита други броеви.</translation>
    </message>
    <message>
        <source>Commas or apostrophes separate the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Меѓу броевите стојат запирки или апострофи; Iterated Dynamics не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each), so the weights are computed from the determinants. Fractint cannot read this entry.</source>
        <translation>Пресликувањата немаат тежини (по %1 броја секое); тежините се земаат од детерминантите. Fractint не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Редиците од %1 броја без „(3D)“ по името се читаат како 3D-систем; Fractint не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>The lines do not have 7 numbers each, but together the numbers fill rows of 7 and are read that way, as in Fractint. The weights are probably missing.</source>
        <translation>Во секој ред нема по 7 броја, но сите броеви заедно пополнуваат редици од 7 и така се читаат, како што прави и Fractint. Веројатно недостигаат тежините.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>Затворената заграда е слепена со последниот број; Fractint не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint truncates it.</source>
        <translation>Редот е подолг од 200 бајти; Fractint тука го сече.</translation>
    </message>
    <message>
        <source>There is a NUL byte here; the rest of the line is ignored, as in Fractint.</source>
        <translation>Бајт NUL; остатокот од редот се занемарува, како што прави и Fractint.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>Записот има %1 пресликувања; Fractint и Iterated Dynamics читаат најмногу 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map is treated as switched off.</source>
        <translation>Тежината на пресликувањето %1 е негативна; пресликувањето се смета за исклучено.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0, so the map is inactive.</source>
        <translation>Тежината на пресликувањето %1 е 0; пресликувањето не учествува.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are scaled in proportion; Fractint gives any shortfall to the last map and cuts off any excess.</source>
        <translation>Збирот на тежините е %1, а не 1. Тие се земаат пропорционално; Fractint она што недостига му го дава на последното пресликување, а вишокот го сече.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Датотеката е празна.</translation>
    </message>
    <message>
        <source>The file contains Fractint parameter sets or formulas, but no iterated function system.</source>
        <translation>Ова се параметри или формули на Fractint; меѓу нив нема итериран функциски систем.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry consists of a name, “{”, rows of 7 numbers and “}”.</source>
        <translation>Не е најден итериран функциски систем: записот е име, „{“, редици од 7 броја и „}“.</translation>
    </message>
    <message>
        <source>The file has more than %1 entries; the rest is kept as text but not shown.</source>
        <translation>Датотеката има повеќе од %1 записи; остатокот се чува како текст, но не се прикажува.</translation>
    </message>
    <message>
        <source>A block without a name is kept as text; Fractint does not list it.</source>
        <translation>Блок без име се чува како текст; Fractint не го наведува.</translation>
    </message>
    <message>
        <source>There are two opening braces on one line: no program finds an entry here. The text is kept.</source>
        <translation>Две отворени загради во еден ред: ниедна програма тука не наоѓа запис. Текстот е задржан.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>„%1“ е збир параметри или формула, а не итериран функциски систем; се чува како текст.</translation>
    </message>
    <message>
        <source>The entry in line %1 has the same name (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>Името веќе го има записот во ред %1 (Fractint споредува 18 знаци и не разликува големи и мали букви); Fractint никогаш не стигнува до овој.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint treats as part of the first name.</source>
        <translation>Датотеката почнува со ознака за редослед на бајтите, која Fractint ја зема како дел од првото име.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); Barycage reads the entries after it too.</source>
        <translation>Fractint престанува да чита кај овој бајт (^Z); записите по него сепак се читаат.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use only the first 2000.</source>
        <translation>Датотеката има %1 записи; Fractint и Iterated Dynamics ги користат првите 2000.</translation>
    </message>
    <message>
        <source>The entry has no active map and is omitted.</source>
        <translation>Записот нема пресликување што учествува, па се изоставува.</translation>
    </message>
    <message>
        <source>The entry is saved under the name “%1”: other programs need unique names of at most 18 plain characters.</source>
        <translation>Записот е запишан под името „%1“: другите програми прифаќаат 18 обични знаци, и секое име само еднаш.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>Записот има %1 пресликувања; Fractint до верзија 17.2 чита најмногу 31.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>не е познато</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>не е утврдено</translation>
    </message>
    <message>
        <source>none: no map is active</source>
        <translation>нема: не учествува ниедно пресликување</translation>
    </message>
    <message>
        <source>   norm %1, determinant %2</source>
        <translation>   норма %1, детерминанта %2</translation>
    </message>
    <message>
        <source>map %1</source>
        <translation>пресликување %1</translation>
    </message>
    <message>
        <source>attractor</source>
        <translation>атрактор</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>средна вредност</translation>
    </message>
    <message>
        <source>covariance</source>
        <translation>коваријанса</translation>
    </message>
    <message>
        <source>bounding box</source>
        <translation>опфаќачки правоаголник</translation>
    </message>
    <message>
        <source>canonical simplex</source>
        <translation>каноничен симплекс</translation>
    </message>
    <message>
        <source>convex hull</source>
        <translation>конвексна обвивка</translation>
    </message>
    <message>
        <source>similarity dimension</source>
        <translation>димензија на сличност</translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation>афина димензија</translation>
    </message>
    <message>
        <source>%1 — could not be read</source>
        <translation>%1 — не можеше да се прочита</translation>
    </message>
    <message>
        <source>cage at rest</source>
        <translation>кафез во мирување</translation>
    </message>
    <message>
        <source>cage now</source>
        <translation>кафезот сега</translation>
    </message>
    <message>
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its rest polygon is flat, crosses itself or has more than 64 vertices.</source>
        <translation>Зачуваниот кафез не може да се употреби (списоците на темиња не се совпаѓаат, или темињата во мирување лежат на една права, се вкрстуваат или се повеќе од 64), па не се применува.</translation>
    </message>
    <message>
        <source>The stored palette “%1” is unknown and is not applied.</source>
        <translation>Зачуваната палета „%1“ е непозната и не се применува.</translation>
    </message>
    <message>
        <source>Map %1 was switched off here, but another program has given it a weight.</source>
        <translation>Пресликувањето %1 тука беше исклучено, но друга програма му дала тежина.</translation>
    </message>
    <message>
        <source>A palette can have at most %1 colours; the rest are ignored.</source>
        <translation>Палетата има најмногу %1 бои; останатите се изоставени.</translation>
    </message>
    <message>
        <source>This line is ignored: a colour consists of three whole numbers from 0 to 255.</source>
        <translation>Овој ред е изоставен: боја се три цели броја од 0 до 255.</translation>
    </message>
    <message>
        <source>The file contains no colours.</source>
        <translation>Датотеката не содржи бои.</translation>
    </message>
    <message>
        <source>The file is larger than 16 MB, which is the limit for a palette.</source>
        <translation>Датотеката е поголема од 16 MB, а тоа не ѝ треба на ниедна палета.</translation>
    </message>
    <message>
        <source>The file is not a text file, so it is not a palette.</source>
        <translation>Датотеката не е текст, па не е палета.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the rest are ignored.</source>
        <translation>Датотеката има повеќе од %1 палети; останатите се изоставени.</translation>
    </message>
    <message>
        <source>The file contains no gradients.</source>
        <translation>Датотеката не содржи градиент.</translation>
    </message>
    <message>
        <source>The gradient that starts in line %1 is not closed.</source>
        <translation>Градиентот од ред %1 не е затворен.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>„%1“ не е цел број.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so it has no points.</source>
        <translation>„%1“ нема пресликување што учествува, па нема точки.</translation>
    </message>
    <message>
        <source>A point cloud can have from 1 to %1 points.</source>
        <translation>Облакот има од 1 до %1 точки.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>„%1“ е папка. Изберете име на датотека.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and will not be replaced. Choose another name.</source>
        <translation>„%1“ не е обична датотека и не се заменува. Изберете друго име.</translation>
    </message>
    <message>
        <source>The folder “%1” does not exist. Create it, or save somewhere else.</source>
        <translation>Папката „%1“ не постои. Создадете ја или зачувајте на друго место.</translation>
    </message>
    <message>
        <source>“%1” is read-only. Save under another name, or change its permissions.</source>
        <translation>„%1“ е само за читање. Зачувајте под друго име или сменете ѝ ги дозволите.</translation>
    </message>
    <message>
        <source>“%1” was not saved: you do not have permission to write to the folder “%2”. Save somewhere else.</source>
        <translation>„%1“ не е зачувана: немате дозвола за запишување во папката „%2“. Зачувајте на друго место.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>„%1“ не е зачувана: името е предолго.</translation>
    </message>
    <message>
        <source>The file has no name. Choose one.</source>
        <translation>Датотеката нема име. Изберете некое.</translation>
    </message>
    <message>
        <source>“%1” does not exist.</source>
        <translation>„%1“ не постои.</translation>
    </message>
    <message>
        <source>“%1” is a folder, not a file.</source>
        <translation>„%1“ е папка, а не датотека.</translation>
    </message>
    <message>
        <source>“%1” is larger than 256 MB, which is the limit for a file.</source>
        <translation>„%1“ е поголема од 256 MB, а тоа е границата за датотека.</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>„%1“ не може да се прочита: %2.</translation>
    </message>
    <message>
        <source>Only systems in the plane can be written as vector graphics.</source>
        <translation>Само системи во рамнината може да се запишат како векторска графика.</translation>
    </message>
    <message>
        <source>No outline of an attractor could be certified for this system, so there is nothing to copy.</source>
        <translation>Системот нема атрактор чија контура би можела со сигурност да се определи, па нема од што да се прават копии.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>Во овој поглед сликата е преголема за да се запише како облици.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row consists of a b c d e f and optionally a weight.</source>
        <translation>Нема редици од броеви: редицата е a b c d e f и евентуално тежина.</translation>
    </message>
    <message>
        <source>After the count, a map consists of its weight and a matrix of 3 rows.</source>
        <translation>По бројот на пресликувања, секое пресликување е неговата тежина и матрица со 3 редици.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map must be 0 0 1.</source>
        <translation>Последната редица од матрицата на афино пресликување е 0 0 1.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>Заглавието не кажува која колона е a, b, c, d, e и f; изберете го редоследот на колоните.</translation>
    </message>
    <message>
        <source>“%1” is not a decimal number.</source>
        <translation>„%1“ не е децимален број.</translation>
    </message>
    <message>
        <source>The table has more than %1 rows, which is the limit.</source>
        <translation>Табелата има повеќе од %1 редици, а тоа е границата.</translation>
    </message>
    <message>
        <source>This is a %1 file, not a text file with iterated function systems.</source>
        <translation>Ова е датотека %1, а не текст со итерирани функциски системи.</translation>
    </message>
    <message>
        <source>This text is encoded in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
        <translation>Ова е текст во UTF-16. Зачувајте го како UTF-8 или ASCII и отворете го повторно.</translation>
    </message>
    <message>
        <source>This is a list written by a Racket program (wgmitchener&apos;s IFS editor), not a Fractint collection.</source>
        <translation>Ова е список запишан од програма во Racket (IFS-уредувачот на wgmitchener), а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is a flame file (XML), not a Fractint collection.</source>
        <translation>Ова е flame-датотека (XML), а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is an SVG picture, not a Fractint collection.</source>
        <translation>Ова е SVG-слика, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is an XML file of an IFS program such as IFS Explorer, not a Fractint collection.</source>
        <translation>Ова е XML-датотека на IFS-програма како IFS Explorer, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is an XML or HTML file, not a Fractint collection.</source>
        <translation>Ова е датотека XML или HTML, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is an IFStile file (.aifs), not a Fractint collection.</source>
        <translation>Ова е датотека на IFStile (.aifs), а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is a XaoS position file, not a Fractint collection.</source>
        <translation>Ова е датотека со позиција на XaoS, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>The lines are expressions in x and y, as pyfractal writes them, not a Fractint collection.</source>
        <translation>Редовите се изрази по x и y, како што ги запишува pyfractal, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is a table of the program Fraktale: a count, maps with cumulative percentages and a window. It is not a Fractint collection.</source>
        <translation>Ова е табела на програмата Fraktale: број, пресликувања со кумулативни проценти и прозорец. Тоа не е збирка на Fractint.</translation>
    </message>
    <message>
        <source>This table has 5 numbers per map (scales, shifts and a rotation in pixels). It is not a Fractint collection.</source>
        <translation>Оваа табела има по 5 броја за пресликување (размери, поместувања и ротација, во пиксели). Тоа не е збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is a StyrofoamIFS script, not a Fractint collection.</source>
        <translation>Ова е скрипта на StyrofoamIFS, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text file with iterated function systems.</source>
        <translation>Ова е бинарна датотека (можеби фрактално компресирана слика или библиотека со икони), а не текст со итерирани функциски системи.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and the file is too large for a table of numbers: the limit is 64 MB.</source>
        <translation>Не е најден итериран функциски систем, а за табела со броеви датотеката е преголема: границата е 64 MB.</translation>
    </message>
    <message>
        <source>a number is too large for a coefficient (the largest absolute value is 3.4e38)</source>
        <translation>еден број е поголем отколку што може да биде коефициент (3.4e38 по големина)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest are ignored.</source>
        <translation>Датотеката има повеќе од %1 пламени; останатите се изоставени.</translation>
    </message>
    <message>
        <source>%1 flames in total are not systems of affine maps.</source>
        <translation>Вкупно %1 пламени не се системи од афини пресликувања.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>Записот има повеќе од %1 редови, што е границата; се чува како текст.</translation>
    </message>
    <message>
        <source>deformation</source>
        <translation>деформација</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>свиткување</translation>
    </message>
    <message>
        <source>affine fit</source>
        <translation>афино прилагодување</translation>
    </message>
    <message>
        <source>A number in this row is too large for a coefficient (the largest absolute value is 3.4e38).</source>
        <translation>Еден број во овој ред е поголем отколку што може да биде коефициент (3.4e38 по големина).</translation>
    </message>
    <message>
        <source>The text is larger than 64 MB, which is the limit for a table of numbers.</source>
        <translation>Текстот има повеќе од 64 MB, што е границата за табела со броеви.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Една ознака има повеќе од %1 атрибути, што е границата.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 levels deep, which is the limit.</source>
        <translation>Елементите се вгнездени подлабоко од %1, што е границата.</translation>
    </message>
    <message>
        <source>The file is larger than 64 MB, which is the limit for XML.</source>
        <translation>Датотеката има повеќе од 64 MB, што е границата за XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>поместена гранка</translation>
    </message>
    <message>
        <source>The stored position of a branch is not valid and is not applied: its map is incomplete, its address names maps that do not exist or occurs twice, or there are too many.</source>
        <translation>Зачувано место на гранка не е употребливо (нејзиното пресликување е нецелосно, нејзината адреса именува пресликувања што ги нема или се јавува двапати, или ги има премногу) и не се применува.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Една ќелија во оваа редица е празна.</translation>
    </message>
    <message>
        <source>A comma can be a decimal comma or a separator here; both readings give complete rows. Use decimal points.</source>
        <translation>Тука запирката може да се чита како децимална или како запирка меѓу два броја, и во двата случаи се добиваат цели редици. Пишувајте децимални точки.</translation>
    </message>
    <message>
        <source>The table mixes maps of the plane and maps of space.</source>
        <translation>Табелата има пресликувања на рамнината и пресликувања на просторот.</translation>
    </message>
    <message>
        <source>This is a list of other files, as used by the program Fraktale, not a Fractint collection.</source>
        <translation>Ова е список на други датотеки, каков што има програмата Fraktale, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>reason</source>
        <translation>причина</translation>
    </message>
    <message numerus="yes">
        <source>%n more maps</source>
        <translation>
            <numerusform>уште %n пресликување</numerusform>
            <numerusform>уште %n пресликувања</numerusform>
            <numerusform>уште %n пресликувања</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no column “%1”: the columns are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Ниедна колона не се вика „%1“: тие се a b c d или r s theta phi, e f, и p или cumulative.</translation>
    </message>
    <message>
        <source>“%1” occurs twice.</source>
        <translation>„%1“ се јавува двапати.</translation>
    </message>
    <message>
        <source>A row has only one weight: p or cumulative.</source>
        <translation>Една редица има една тежина: p или cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi cannot be combined.</source>
        <translation>a b c d и r s theta phi не одат заедно.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Недостасува: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than other programs can read in one path. Choose a smaller depth.</source>
        <translation>Контурот има повеќе темиња отколку што програмите читаат во една патека. Изберете помала длабочина.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers describe the picture at rest.</source>
        <translation>Кафезот ја витка или сплескува сликата. Броевите се на сликата во мирување.</translation>
    </message>
    <message>
        <source>The name “%1” is not valid UTF-8. Rename the file, or open it through a symbolic link.</source>
        <translation>Името „%1“ не е важечки UTF-8. Преименувајте ја датотеката или отворете ја преку симболичка врска.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so all weights are computed from the determinants and the given ones are ignored.</source>
        <translation>Пресликувањето %1 нема тежина, па тежините на сите пресликувања се земаат од детерминантите, а дадените не се користат.</translation>
    </message>
    <message>
        <source>The stored cage is not valid and is not applied: its lists of vertices do not match, or its vertices at rest are in one plane or coincide.</source>
        <translation>Зачуваниот кафез не може да се употреби (списоците на темиња не се совпаѓаат, или темињата во мирување лежат во една рамнина или се поклопуваат), па не се применува.</translation>
    </message>
    <message>
        <source>This entry is %1-dimensional, but its stored cage or moved branches are not: they are not applied, and their lines are kept.</source>
        <translation>Овој запис има %1 димензии, но неговиот зачуван кафез или неговите поместени гранки немаат: тие не се применуваат, а нивните редови се задржани.</translation>
    </message>
    <message>
        <source>none: ρ(A) ≥ 1 for the word %1</source>
        <translation>нема: ρ(A) ≥ 1 за зборот %1</translation>
    </message>
    <message>
        <source>(of the attractor: its pieces are disjoint)</source>
        <translation>(на атракторот: неговите делови се дисјунктни)</translation>
    </message>
    <message>
        <source>(upper bound: pieces coincide)</source>
        <translation>(горна граница: има делови што се совпаѓаат)</translation>
    </message>
    <message>
        <source>(if the open set condition holds; else an upper bound)</source>
        <translation>(ако важи условот на отворено множество; инаку горна граница)</translation>
    </message>
    <message>
        <source>strong: no two pieces meet</source>
        <translation>силна: никои два дела не се допираат</translation>
    </message>
    <message>
        <source>none: pieces coincide</source>
        <translation>нема: има делови што се совпаѓаат</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>сврзан</translation>
    </message>
    <message>
        <source>connected, within rounding error</source>
        <translation>сврзан, колку што се гледа од заокружувањето</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>не е сврзан</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>раздвоеност</translation>
    </message>
    <message>
        <source>connectedness</source>
        <translation>сврзаност</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>преклопување</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map</source>
        <translation>зборовите %1 и %2 се исто пресликување</translation>
    </message>
    <message>
        <source>joint spectral radius</source>
        <translation>заеднички спектрален радиус</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>меѓу %1 и %2</translation>
    </message>
    <message>
        <source>entropy</source>
        <translation>ентропија</translation>
    </message>
    <message>
        <source>Lyapunov exponent</source>
        <translation>Експонент на Љапунов</translation>
    </message>
    <message>
        <source>dimension of measure</source>
        <translation>димензија на мерата</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of 6 numbers, line by line, or as %2 maps of 7 numbers, whose weights then sum to 1. They are read line by line; for the other reading, put 7 numbers on each line.</source>
        <translation>Броевите може да се читаат ред по ред како %1 пресликувања од 6 броја, или како %2 пресликувања од 7 броја, чии тежини тогаш имаат збир 1. Се читаат ред по ред; за другото читање ставете по 7 броја во секој ред.</translation>
    </message>
    <message>
        <source>The block names no maps: a line such as “A=(f1|f2)*A” is missing.</source>
        <translation>Блокот не именува пресликувања: недостига ред како „A=(f1|f2)*A“.</translation>
    </message>
    <message>
        <source>“%1” is not understood: Barycage reads blocks of affine maps, such as “f1=[e,f]*[a,b,c,d]” and “A=(f1|f2)*A”.</source>
        <translation>„%1“ не се разбира: Barycage чита блокови афини пресликувања, како „f1=[e,f]*[a,b,c,d]“ и „A=(f1|f2)*A“.</translation>
    </message>
    <message>
        <source>The file has more than %1 blocks, which is the limit; the rest was not read.</source>
        <translation>Датотеката има повеќе од %1 блокови, што е границата; останатото не е прочитано.</translation>
    </message>
    <message>
        <source>This IFStile file contains no affine system.</source>
        <translation>Оваа датотека на IFStile не содржи афин систем.</translation>
    </message>
    <message>
        <source>The numbers can be read as %1 maps of %2 numbers, line by line, or as %3 maps of 7 numbers, whose weights then sum to 1. They are read line by line, unlike in Fractint; for the other reading, put 7 numbers on each line.</source>
        <translation>Броевите може да се читаат ред по ред како %1 пресликувања од %2 броја, или како %3 пресликувања од 7 броја, чии тежини тогаш имаат збир 1. За разлика од Fractint, се читаат ред по ред; за другото читање ставете по 7 броја во секој ред.</translation>
    </message>
    <message>
        <source>The numbers are read line by line, as %1 maps of %2 numbers. Fractint ignores line ends and reads %3 maps of 7 numbers.</source>
        <translation>Броевите се читаат ред по ред, како %1 пресликувања од %2 броја. Fractint ги занемарува краевите на редовите и чита %3 пресликувања од 7 броја.</translation>
    </message>
    <message>
        <source>Entries whose names begin with “ifs:” belong in parameter files (.par); in a collection, Fractint takes the prefix as part of the name.</source>
        <translation>Записите чии имиња почнуваат со „ifs:“ припаѓаат во датотеки со параметри (.par); во збирка, Fractint го зема префиксот како дел од името.</translation>
    </message>
    <message>
        <source>The lines end with CR alone, as on old Macintosh computers; Fractint reads such a file as a single line.</source>
        <translation>Редовите завршуваат само со CR, како на старите компјутери Macintosh; Fractint ваква датотека ја чита како еден ред.</translation>
    </message>
    <message>
        <source>The convex hull has an error of up to %1: the tolerance %2 was not reached.</source>
        <translation>Конвексната обвивка има грешка до %1: толеранцијата %2 не е достигната.</translation>
    </message>
    <message>
        <source>contractive in an ellipsoidal norm, γ %1</source>
        <translation>контрактивен во елипсоидна норма, γ %1</translation>
    </message>
    <message>
        <source>contractive in a polytope norm, γ %1</source>
        <translation>контрактивен во политопна норма, γ %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ %1 from words of length %2</source>
        <translation>на крајот контрактивен, γ %1 од зборови со должина %2</translation>
    </message>
    <message>
        <source>hyperbolic, s %1</source>
        <translation>хиперболичен, s %1</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 пресликување</translation>
    </message>
    <message>
        <source>%1 maps</source>
        <translation>%1 пресликувања</translation>
    </message>
    <message>
        <source>%1 — in space, %2</source>
        <translation>%1 – во просторот, %2</translation>
    </message>
    <message>
        <source>%1 — in the plane, %2</source>
        <translation>%1 – во рамнината, %2</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>не можеше да се прочита</translation>
    </message>
    <message>
        <source>in space, %1</source>
        <translation>во просторот, %1</translation>
    </message>
    <message>
        <source>in the plane, %1</source>
        <translation>во рамнината, %1</translation>
    </message>
    <message>
        <source>its cage</source>
        <translation>неговиот кафез</translation>
    </message>
    <message>
        <source>its moved branches</source>
        <translation>неговите поместени гранки</translation>
    </message>
    <message>
        <source>its palette</source>
        <translation>неговата палета</translation>
    </message>
    <message>
        <source>its background</source>
        <translation>неговата позадина</translation>
    </message>
    <message>
        <source>its other colour settings</source>
        <translation>неговите други поставки за боја</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 и %2</translation>
    </message>
    <message>
        <source>“%1” is written without %2: other programs will draw a different picture.</source>
        <translation>„%1“ се запишува без %2: други програми ќе нацртаат поинаква слика.</translation>
    </message>
    <message>
        <source>“%1” is written without %2.</source>
        <translation>„%1“ се запишува без %2.</translation>
    </message>
    <message>
        <source>The stored animation is not applied, because “%1” is not understood; its lines are kept.</source>
        <translation>Зачуваната анимација не се применува, бидејќи „%1“ не е разбирливо; нејзините редови се задржуваат.</translation>
    </message>
    <message>
        <source>The entry has more than one stored animation: the last valid one is used, and the lines of the others are kept.</source>
        <translation>Записот има повеќе од една зачувана анимација: се користи последната важечка, а редовите на другите се задржуваат.</translation>
    </message>
    <message>
        <source>The stored animation is not valid and is not applied: it moves maps or vertices that do not exist, a frame, number or curve is out of its range, or keys are not in order. Its lines are kept.</source>
        <translation>Зачуваната анимација не е важечка и не се применува: движи пресликувања или темиња што не постојат, кадар, број или крива е надвор од својот опсег, или клучните кадри не се по ред. Нејзините редови се задржуваат.</translation>
    </message>
    <message>
        <source>in a cycle</source>
        <translation>во циклус</translation>
    </message>
    <message>
        <source>there and back</source>
        <translation>напред и назад</translation>
    </message>
    <message>
        <source>once</source>
        <translation>еднаш</translation>
    </message>
    <message>
        <source>animation</source>
        <translation>анимација</translation>
    </message>
    <message>
        <source>This is not the format of a fractal program. Its lists of numbers are read as tables of maps (systems: %1, maps: %2), in the order a b c d e f unless names give another order.</source>
        <translation>Ова не е формат на програми за фрактали. Неговите списоци од броеви се читаат како табели со пресликувања (системи: %1, пресликувања: %2), по редот a b c d e f онаму каде што имињата не кажуваат друг.</translation>
    </message>
    <message>
        <source>it acts in space after its variations (“%1”)</source>
        <translation>дејствува во просторот по своите варијации („%1“)</translation>
    </message>
    <message>
        <source>its “%1” is not six numbers</source>
        <translation>неговото „%1“ не се шест броја</translation>
    </message>
    <message>
        <source>The flame names a palette of another program by its number; its colours are not in the file.</source>
        <translation>Пламенот наведува палета на друга програма само по нејзиниот број; боите не се во датотеката.</translation>
    </message>
    <message>
        <source>“%1” could not be read, so it has no points.</source>
        <translation>„%1“ не можеше да се прочита, па нема точки.</translation>
    </message>
    <message>
        <source>This is JSON text (data of another program), not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>Ова е JSON-текст (податоци на друга програма), а не збирка на Fractint, и ниеден од неговите списоци не е од афини пресликувања.</translation>
    </message>
    <message>
        <source>This is the text of a program, not a Fractint collection, and none of its lists are affine maps.</source>
        <translation>Ова е текст на програма, а не збирка на Fractint, и ниеден од неговите списоци не е од афини пресликувања.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it has no solid.</source>
        <translation>„%1“ не е систем во просторот, па нема тело.</translation>
    </message>
    <message>
        <source>The cage of “%1” bends the picture, so its solid cannot be written.</source>
        <translation>Кафезот на „%1“ ја криви сликата, па неговото тело не може да се запише.</translation>
    </message>
    <message>
        <source>“%1” has no certified attractor, so it has no solid.</source>
        <translation>„%1“ нема потврден атрактор, па нема тело.</translation>
    </message>
    <message>
        <source>“%1” would need more than %2 parts in OpenSCAD. Choose larger voxels.</source>
        <translation>За „%1“ во OpenSCAD би биле потребни повеќе од %2 делови. Изберете поголеми воксели.</translation>
    </message>
    <message>
        <source>“%1” is too large for a solid.</source>
        <translation>„%1“ е преголем за тело.</translation>
    </message>
    <message>
        <source>“%1” is a single point: only the size of its voxel can be chosen.</source>
        <translation>„%1“ е една точка: може да се избере само големината на вокселот.</translation>
    </message>
    <message>
        <source>The surface of “%1” is not closed, so it was not written.</source>
        <translation>Површината на „%1“ не е затворена, па не беше запишана.</translation>
    </message>
    <message>
        <source>Size: %1 × %2 × %3 mm; volume: %4 mm³; triangles: %5.</source>
        <translation>Големина: %1 × %2 × %3 mm; волумен: %4 mm³; триаголници: %5.</translation>
    </message>
    <message>
        <source>Distance from the attractor: at most %1 mm = √3 · %2 mm + %3 mm for the wall.</source>
        <translation>Растојание од атракторот: најмногу %1 mm = √3 · %2 mm + %3 mm за ѕидот.</translation>
    </message>
    <message>
        <source>Cavities filled: %1, with %2 mm³.</source>
        <translation>Пополнети шуплини: %1, со %2 mm³.</translation>
    </message>
    <message>
        <source>Closed cavities: %1, with %2 mm³.</source>
        <translation>Затворени шуплини: %1, со %2 mm³.</translation>
    </message>
    <message>
        <source>Separate bodies: %1.</source>
        <translation>Одвоени тела: %1.</translation>
    </message>
    <message>
        <source>“%1”: %2</source>
        <translation>„%1“: %2</translation>
    </message>
    <message>
        <source>“%1” belongs to another picture: the entry, the view, the size, the seed or the format differs.</source>
        <translation>„%1“ е од друга слика: записот, погледот, големината, семето или форматот се разликуваат.</translation>
    </message>
    <message>
        <source>“%1” belongs to a picture with a different number of points, so the sums cannot be combined.</source>
        <translation>„%1“ е од слика со друг број точки, па збировите не можат да се соберат.</translation>
    </message>
    <message>
        <source>“%1” and “%2” hold the same part of the picture, which would be counted twice.</source>
        <translation>„%1“ и „%2“ го содржат истиот дел од сликата, кој би се броел двапати.</translation>
    </message>
    <message>
        <source>“%1” was written by another version of the program, which may draw other pixels.</source>
        <translation>„%1“ е запишана со друга верзија на програмата, која може да црта други пиксели.</translation>
    </message>
    <message>
        <source>The picture is incomplete: only %1 % of it is present. Add the files of the other parts, or merge to a .sum file.</source>
        <translation>Сликата не е целосна: има %1 % од неа. Додајте ги датотеките на другите делови или запишете .sum датотека.</translation>
    </message>
    <message>
        <source>This is not a file of sums.</source>
        <translation>Ова не е датотека со збирови.</translation>
    </message>
    <message>
        <source>The file of sums is damaged or incomplete.</source>
        <translation>Датотеката со збирови е оштетена или нецелосна.</translation>
    </message>
    <message>
        <source>“%1” is a symbolic link that leads back to itself, or through too many others.</source>
        <translation>„%1“ е симболичка врска што води назад кон самата себе или преку премногу други.</translation>
    </message>
    <message>
        <source>You do not have permission to enter the folder “%1”.</source>
        <translation>Немате дозвола за влез во папката „%1“.</translation>
    </message>
    <message>
        <source>not computed within the budget</source>
        <translation>не е пресметано во дозволеното време</translation>
    </message>
    <message>
        <source>A cage with more than four corners bends the solid; its points cannot be written.</source>
        <translation>Кафез со повеќе од четири темиња го свиткува телото; неговите точки не можат да се запишат.</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… и уште %1</translation>
    </message>
    <message>
        <source>The sheet would have %1 by %2 pixels; the limit is %3 pixels in width. Use smaller tiles or fewer columns.</source>
        <translation>Листот би имал %1 на %2 пиксели; најголемата ширина е %3 пиксели. Користете помали плочки или помалку колони.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. At most 32 million pixels can be read; scale it down.</source>
        <translation>Сликата има %1 × %2 пиксели. Може да се прочитаат најмногу 32 милиони пиксели; намалете ја.</translation>
    </message>
    <message>
        <source>The picture has %1 × %2 pixels. Each side needs at least %3 pixels.</source>
        <translation>Сликата има %1 × %2 пиксели. Секоја страна мора да има најмалку %3 пиксели.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete.</source>
        <translation>Сликата е оштетена или нецелосна.</translation>
    </message>
    <message>
        <source>The picture is a JPEG in CMYK colours, which programs read differently. Convert it to RGB or grey levels.</source>
        <translation>Сликата е JPEG во бои CMYK, кои секоја програма ги чита поинаку. Претворете ја во RGB или во нијанси на сиво.</translation>
    </message>
    <message>
        <source>The picture is animated. Save one of its frames as a picture of its own.</source>
        <translation>Сликата е анимирана. Зачувајте еден од нејзините кадри како посебна слика.</translation>
    </message>
    <message>
        <source>The picture is too long and thin to be traced.</source>
        <translation>Сликата е премногу долга и тенка за да се прецрта.</translation>
    </message>
    <message>
        <source>There is no fractal transformation between these entries.</source>
        <translation>Меѓу овие записи нема фрактална трансформација.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane.</source>
        <translation>„%1“ не е систем во рамнината.</translation>
    </message>
    <message>
        <source>The cage of “%1” is flat or bends the picture. Bake or reset it first.</source>
        <translation>Кафезот на „%1“ е рамен или ја свиткува сликата. Прво впишете го во кодот или вратете го во мирување.</translation>
    </message>
    <message>
        <source>“%1” has no active map, so there is nothing to draw.</source>
        <translation>„%1“ нема активно пресликување, па нема што да се нацрта.</translation>
    </message>
    <message>
        <source>No attractor could be proved for “%1”, so its points have no addresses.</source>
        <translation>„%1“ нема докажлив атрактор, па неговите точки немаат адреси.</translation>
    </message>
    <message>
        <source>The stored order does not list every active map of “%1” once.</source>
        <translation>Зачуваниот редослед не го наведува секое активно пресликување на „%1“ точно еднаш.</translation>
    </message>
    <message>
        <source>“%1” has %2 maps; with a symmetry of %3 elements they would be more than %4, which is the limit.</source>
        <translation>„%1“ има %2 пресликувања; со симетрија од %3 елементи би биле повеќе од %4, а тоа е границата.</translation>
    </message>
    <message>
        <source>The maps of “%1” move in its animation, and the copies that its symmetry makes would not move with them. Remove the motions and the keys of the maps first.</source>
        <translation>Пресликувањата на „%1“ се движат во анимацијата, а копиите што ги прави симетријата не би се движеле со нив. Прво отстранете ги движењата и клучевите на пресликувањата.</translation>
    </message>
    <message>
        <source>its “chaos” is not a list of numbers from 0 upwards</source>
        <translation>неговиот „chaos“ не е список од броеви од 0 нагоре</translation>
    </message>
    <message>
        <source>its symmetry is not of a kind from −%1 to %1</source>
        <translation>неговата симетрија не е од вид меѓу −%1 и %1</translation>
    </message>
    <message>
        <source>it links more than %1 transforms by “chaos”</source>
        <translation>поврзува повеќе од %1 трансформации со „chaos“</translation>
    </message>
    <message>
        <source>it links transforms in space by “chaos”</source>
        <translation>поврзува трансформации во просторот со „chaos“</translation>
    </message>
    <message>
        <source>Maps of a system in space cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>Пресликувањата на систем во просторот не можат да се поврзат: врските не се применуваат, а нивните редови се зачувуваат.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked: the links are not applied, and their lines are kept.</source>
        <translation>Повеќе од %1 пресликувања не можат да се поврзат: врските не се применуваат, а нивните редови се зачувуваат.</translation>
    </message>
    <message>
        <source>The links of map %1 are not valid, so no links are applied: a row of links has one number for each map, 0 or larger.</source>
        <translation>Врските на пресликувањето %1 не се важечки, па не се применуваат никакви врски: редот на врските има по еден број за секое пресликување, 0 или поголем.</translation>
    </message>
    <message>
        <source>With these links every sequence of maps ends, so no map is active.</source>
        <translation>Со врските секоја низа пресликувања завршува, па ниедно пресликување не е активно.</translation>
    </message>
    <message>
        <source>With its stored symmetry the entry would have more than %1 maps, which is the limit. The symmetry is not applied; its lines are kept.</source>
        <translation>Со зачуваната симетрија ставката би имала повеќе од %1 пресликувања, а тоа е границата. Симетријата не се применува; нејзините редови се задржуваат.</translation>
    </message>
    <message>
        <source>The maps are linked, so the picture is not made of copies of itself.</source>
        <translation>Пресликувањата се поврзани, па сликата не се состои од копии на самата себе.</translation>
    </message>
    <message>
        <source>1 vertex</source>
        <translation>1 теме</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 темиња</translation>
    </message>
    <message>
        <source>%1, area %2; error at most %3; periodic addresses not computed within the budget</source>
        <translation>%1, плоштина %2; грешка најмногу %3; периодичните адреси не се пресметани во даденото време</translation>
    </message>
    <message>
        <source>%1, all of them with periodic addresses, area %2; exact</source>
        <translation>%1, сите со периодични адреси, плоштина %2; точна</translation>
    </message>
    <message>
        <source>%1, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1, од нив %2 со периодични адреси, плоштина %3; грешка најмногу %4</translation>
    </message>
    <message>
        <source>%1, %2, volume %3; error at most %4</source>
        <translation>%1, %2, волумен %3; грешка најмногу %4</translation>
    </message>
    <message>
        <source>1 facet</source>
        <translation>1 страна</translation>
    </message>
    <message>
        <source>%1 facets</source>
        <translation>%1 страни</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>најмалку %1</translation>
    </message>
    <message>
        <source>(within rounding error)</source>
        <translation>(колку што се гледа од заокружувањето)</translation>
    </message>
    <message>
        <source>area of the tile</source>
        <translation>плоштина на плочката</translation>
    </message>
    <message>
        <source>dimension of boundary</source>
        <translation>димензија на границата</translation>
    </message>
    <message>
        <source>symmetry</source>
        <translation>симетрија</translation>
    </message>
    <message>
        <source>takes no part: after it, the chaos game ends</source>
        <translation>не учествува: по него играта на хаосот завршува</translation>
    </message>
    <message>
        <source>takes no part: no map leads to it</source>
        <translation>не учествува: ниедно пресликување не води до него</translation>
    </message>
    <message>
        <source>takes no part: the chaos game leaves it and never returns</source>
        <translation>не учествува: играта на хаосот го напушта и никогаш не се враќа</translation>
    </message>
    <message>
        <source>links from map %1</source>
        <translation>врски од пресликувањето %1</translation>
    </message>
    <message>
        <source>linked maps</source>
        <translation>поврзани пресликувања</translation>
    </message>
    <message>
        <source>separation, connectedness, joint spectral radius and periodic addresses are not computed for linked maps</source>
        <translation>раздвоеноста, поврзаноста, заедничкиот спектрален радиус и периодичните адреси не се одредуваат за поврзани пресликувања</translation>
    </message>
    <message>
        <source>the links of its maps</source>
        <translation>врските на неговите пресликувања</translation>
    </message>
    <message>
        <source>The symmetry of “%1” is written as the maps that it stands for.</source>
        <translation>Симетријата на „%1“ се запишува како пресликувањата што ги претставува.</translation>
    </message>
    <message>
        <source>, in a frame of its own</source>
        <translation>, во сопствен координатен систем</translation>
    </message>
    <message>
        <source>mirror at %1° through %2</source>
        <translation>огледало на %1° низ %2</translation>
    </message>
    <message>
        <source>%1-fold rotation about %2</source>
        <translation>%1-кратна ротација околу %2</translation>
    </message>
    <message>
        <source>%1-fold dihedral about %2, a mirror at %3°</source>
        <translation>%1-кратна диедарска околу %2, со огледало на %3°</translation>
    </message>
    <message>
        <source>rotations of the tetrahedron about %1</source>
        <translation>ротации на тетраедарот околу %1</translation>
    </message>
    <message>
        <source>rotations of the octahedron about %1</source>
        <translation>ротации на октаедарот околу %1</translation>
    </message>
    <message>
        <source>rotations of the icosahedron about %1</source>
        <translation>ротации на икосаедарот околу %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нема</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, so not every address is one of its points.</source>
        <translation>Пресликувањата на „%1“ се поврзани, па не секоја адреса е негова точка.</translation>
    </message>
    <message>
        <source>A GIMP gradient states its number of segments here, from 1 to %1.</source>
        <translation>GIMP-прелив овде го наведува бројот на сегменти, од 1 до %1.</translation>
    </message>
    <message>
        <source>This is not a segment of a GIMP gradient that continues the one before.</source>
        <translation>Ова не е сегмент од GIMP-прелив што го продолжува претходниот.</translation>
    </message>
    <message>
        <source>its fractal transformation</source>
        <translation>неговата фрактална трансформација</translation>
    </message>
    <message>
        <source>its saved views</source>
        <translation>неговите зачувани погледи</translation>
    </message>
    <message>
        <source>the names of its maps</source>
        <translation>имињата на неговите пресликувања</translation>
    </message>
    <message>
        <source>the locks of its maps</source>
        <translation>заклучувањата на неговите пресликувања</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Име:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Датум:</translation>
    </message>
    <message>
        <source>part of map %1</source>
        <translation>дел од пресликувањето %1</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Кафез</translation>
    </message>
    <message>
        <source>This is not a PNG, JPEG, GIF, BMP, PNM, WebP, TIFF or OpenEXR picture.</source>
        <translation>Ова не е слика PNG, JPEG, GIF, BMP, PNM, WebP, TIFF или OpenEXR.</translation>
    </message>
    <message>
        <source>The picture stores its pixels in a way that cannot be read. Save it as a PNG picture.</source>
        <translation>Сликата ги чува пикселите на начин што не може да се прочита. Зачувајте ја како PNG-слика.</translation>
    </message>
    <message>
        <source>Too many maps to bound the jumps</source>
        <translation>Премногу пресликувања за да се ограничат скоковите</translation>
    </message>
    <message>
        <source>Proved continuous: the pieces do not touch</source>
        <translation>Докажано непрекината: деловите не се допираат</translation>
    </message>
    <message>
        <source>Proved so far: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Досега докажано: ниеден скок меѓу деловите не е поголем од %1 (%2 % од партнерот), најлошо кај %3</translation>
    </message>
    <message>
        <source>Proved: no jump between pieces exceeds %1 (%2 % of the partner), worst near %3</source>
        <translation>Докажано: ниеден скок меѓу деловите не е поголем од %1 (%2 % од партнерот), најлошо кај %3</translation>
    </message>
    <message>
        <source>Proved to be a homeomorphism</source>
        <translation>Докажано хомеоморфизам</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism</source>
        <translation>Докажано не е хомеоморфизам</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism</source>
        <translation>Не е познато дали е хомеоморфизам</translation>
    </message>
    <message>
        <source>Proved not to be a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>Докажано не е хомеоморфизам; назад ниеден скок не е поголем од %1 (%2 % од овој фрактал), најлошо кај %3</translation>
    </message>
    <message>
        <source>Not known whether it is a homeomorphism; no jump back exceeds %1 (%2 % of this fractal), worst near %3</source>
        <translation>Не е познато дали е хомеоморфизам; назад ниеден скок не е поголем од %1 (%2 % од овој фрактал), најлошо кај %3</translation>
    </message>
    <message>
        <source>the words %1 and %2 are the same map within rounding error</source>
        <translation>зборовите %1 и %2 се исто пресликување до заокружување</translation>
    </message>
    <message>
        <source>Omitted lines of blocks that are not iterated function systems: %1.</source>
        <translation>Изоставени редови од блокови што не се итерирани функциски системи: %1.</translation>
    </message>
    <message>
        <source>Omitted inactive maps: %1.</source>
        <translation>Изоставени пресликувања што не учествуваат: %1.</translation>
    </message>
    <message>
        <source>a point; exact</source>
        <translation>точка; точно</translation>
    </message>
    <message>
        <source>(upper bound: the open set condition fails)</source>
        <translation>(горна граница: условот на отворено множество не важи)</translation>
    </message>
    <message>
        <source>%1, and inside itself</source>
        <translation>%1, и внатре во себе</translation>
    </message>
    <message>
        <source>The picture in “%1” needs more than 4 GB of memory in space.</source>
        <translation>Сликата во „%1“ во просторот бара повеќе од 4 GB меморија.</translation>
    </message>
    <message>
        <source>The stored symmetry “%1” is not valid for this entry and is not applied; its lines are kept. A rotation repeats each map 2 to %2 times; polyhedra belong to space.</source>
        <translation>Зачуваната симетрија „%1“ не е важечка за овој запис и не се применува; нејзините редови се задржуваат. Ротацијата го повторува секое пресликување од 2 до %2 пати; полиедрите припаѓаат на просторот.</translation>
    </message>
    <message>
        <source>“%1” and “%2” must have the same number of active maps; they have %3 and %4.</source>
        <translation>„%1“ и „%2“ треба да имаат еднаков број активни пресликувања; имаат %3 и %4.</translation>
    </message>
    <message>
        <source>Other problems in this entry, not listed: %1.</source>
        <translation>Други проблеми во овој запис што не се наведени: %1.</translation>
    </message>
    <message>
        <source>Numbers are missing or left over: this line has %1, the entry has %2, and each map has %3%4.</source>
        <translation>Недостигаат броеви или има вишок: овој ред има %1, записот има %2, а секое пресликување има %3%4.</translation>
    </message>
    <message>
        <source>moved branches</source>
        <translation>поместени гранки</translation>
    </message>
    <message>
        <source>all figures are those of the code, where no branch is moved</source>
        <translation>сите бројки се на кодот, каде што ниту една гранка не е поместена</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time. Choose a lower resolution, which makes larger voxels.</source>
        <translation>Деловите на „%1“ премногу се преклопуваат или се допираат за неговите воксели да се најдат во разумно време. Изберете помала резолуција, односно поголеми воксели.</translation>
    </message>
    <message>
        <source>The surface of “%1” would have more than %2 million triangles. Choose a lower resolution, which makes larger voxels.</source>
        <translation>Површината на „%1“ би имала повеќе од %2 милиони триаголници. Изберете помала резолуција, односно поголеми воксели.</translation>
    </message>
    <message>
        <source>The count says %1, but the number of maps is %2.</source>
        <translation>Наведен е бројот %1, но бројот на пресликувања е %2.</translation>
    </message>
    <message>
        <source>The header names %2 columns, but this row has %1.</source>
        <translation>Заглавието именува %2 колони, но оваа редица има %1.</translation>
    </message>
    <message>
        <source>A map has 6 numbers, or 7 with its weight; this row has %1.</source>
        <translation>Пресликувањето е 6 броја, или 7 со тежината; оваа редица има %1.</translation>
    </message>
    <message>
        <source>its animation</source>
        <translation>неговата анимација</translation>
    </message>
    <message>
        <source>tracks: %1</source>
        <translation>траки: %1</translation>
    </message>
    <message>
        <source>motions: %1</source>
        <translation>движења: %1</translation>
    </message>
    <message>
        <source>frames: %1, %2 per second, %3</source>
        <translation>кадри: %1, %2 во секунда, %3</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose larger voxels.</source>
        <translation>За телото на „%1“ би биле потребни повеќе од %2 милиони воксели. Изберете поголеми воксели.</translation>
    </message>
    <message>
        <source>The wall is too thick for a solid of this size. Choose a thinner wall.</source>
        <translation>Ѕидот е предебел за тело со оваа големина. Изберете потенок ѕид.</translation>
    </message>
    <message>
        <source>The solid of “%1” would need more than %2 million voxels. Choose a lower resolution: at most %3.</source>
        <translation>За телото на „%1“ би биле потребни повеќе од %2 милиони воксели. Изберете помала резолуција: најмногу %3.</translation>
    </message>
    <message>
        <source>Transform %1 has opacity %2; its points are drawn in full.</source>
        <translation>Трансформацијата %1 има непроѕирност %2; нејзините точки се цртаат целосно.</translation>
    </message>
    <message>
        <source>The file on disk is unchanged.</source>
        <translation>Датотеката на дискот е како што беше.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2.</source>
        <translation>„%1“ не е зачувана: %2.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again.</source>
        <translation>„%1“ не е зачувана: дискот е полн. Ослободете место и зачувајте повторно.</translation>
    </message>
    <message>
        <source>“%1” is too small for its distance from the origin: the numbers in the file cannot distinguish its points. Move it to the origin, or make it larger.</source>
        <translation>„%1“ е премал за своето растојание од почетокот: броевите во датотеката не ги разликуваат неговите точки. Преместете го кон почетокот или зголемете го.</translation>
    </message>
    <message>
        <source>“%1” is not a regular file and cannot be opened.</source>
        <translation>„%1“ не е обична датотека и не може да се отвори.</translation>
    </message>
    <message>
        <source>The system does not follow the symbolic link “%1”, because another user may have put it there. Choose another name.</source>
        <translation>Системот не ја следи симболичката врска „%1“, бидејќи можеби ја поставил друг корисник. Изберете друго име.</translation>
    </message>
    <message>
        <source>The picture is a JPEG with more than %1 scans. Save it as a PNG picture.</source>
        <translation>Сликата е JPEG со повеќе од %1 премини. Зачувајте ја како слика PNG.</translation>
    </message>
    <message>
        <source>This is read as %3 (systems: %1, maps: %2).</source>
        <translation>Прочитано како: %3 (системи: %1, пресликувања: %2).</translation>
    </message>
    <message>
        <source>Nothing names its columns: their order is taken to be a b c d e f.</source>
        <translation>Ништо не ги именува колоните: се претпоставува редоследот a b c d e f.</translation>
    </message>
    <message>
        <source>In %1, row %2: %3</source>
        <translation>%1, ред %2: %3</translation>
    </message>
    <message>
        <source>The text is encoded in UTF-16; it is saved as UTF-8.</source>
        <translation>Текстот е кодиран во UTF-16; се зачувува како UTF-8.</translation>
    </message>
    <message>
        <source>This is a program, a page or another document, not a Fractint collection, and none of its numbers are affine maps.</source>
        <translation>Ова е програма, страница или друг документ, а не збирка на Fractint, и ниеден од броевите во него не е афино пресликување.</translation>
    </message>
    <message>
        <source>final transform: %1</source>
        <translation>завршна трансформација: %1</translation>
    </message>
    <message>
        <source>it has several final transforms</source>
        <translation>има неколку завршни трансформации</translation>
    </message>
    <message>
        <source>it has a final transform in space</source>
        <translation>има завршна трансформација во просторот</translation>
    </message>
    <message>
        <source>it has a final transform and a symmetry</source>
        <translation>има завршна трансформација и симетрија</translation>
    </message>
    <message>
        <source>its final transform flattens the picture</source>
        <translation>нејзината завршна трансформација ја сплескува сликата</translation>
    </message>
    <message>
        <source>The attribute “%1” occurs twice; the first one is read.</source>
        <translation>Атрибутот „%1“ се појавува двапати; се чита првиот.</translation>
    </message>
    <message>
        <source>A blank is missing before the attribute “%1”; it is read as if there were one.</source>
        <translation>Недостасува празно место пред атрибутот „%1“; се чита како да го има.</translation>
    </message>
    <message>
        <source>The attribute “%1” contains “%2”, which must be “%3” in XML; it is read as it stands.</source>
        <translation>Атрибутот „%1“ содржи „%2“, што во XML мора да биде „%3“; се чита како што стои.</translation>
    </message>
    <message>
        <source>%1 flames with different times are the keys of this animation, a frame for each unit of time. Its colours are those of the first one.</source>
        <translation>%1 пламени со различни времиња се клучевите на оваа анимација, по еден кадар за единица време. Боите се оние на првиот.</translation>
    </message>
    <message>
        <source>Columns that do not belong to a map are not read: %1.</source>
        <translation>Колоните што не припаѓаат на пресликување не се читаат: %1.</translation>
    </message>
    <message>
        <source>The weights rise to %1, so they may be running sums. They are read as weights; to read them as sums, name their column “cumulative” instead of “p”.</source>
        <translation>Тежините растат до %1, па можеби се збирови. Се читаат како тежини; за да се прочитаат како збирови, наречете ја нивната колона „cumulative“ наместо „p“.</translation>
    </message>
    <message>
        <source>YAML</source>
        <translation>YAML</translation>
    </message>
    <message>
        <source>a text of GIMP’s IFS Fractal</source>
        <translation>текст од IFS Fractal на GIMP</translation>
    </message>
    <message>
        <source>a LaTeX table</source>
        <translation>табела во LaTeX</translation>
    </message>
    <message>
        <source>an HTML table</source>
        <translation>HTML-табела</translation>
    </message>
    <message>
        <source>a Markdown table</source>
        <translation>табела во Markdown</translation>
    </message>
    <message>
        <source>a wiki table</source>
        <translation>вики-табела</translation>
    </message>
    <message>
        <source>matrices in LaTeX</source>
        <translation>матрици во LaTeX</translation>
    </message>
    <message>
        <source>equations</source>
        <translation>равенки</translation>
    </message>
    <message>
        <source>Standard output cannot be written to: %1.</source>
        <translation>Не може да се запише на стандардниот излез: %1.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Додавање на %1</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
    </message>
    <message numerus="yes">
        <source>%n exports from the last session are in the queue.</source>
        <translation>
            <numerusform>%n извоз од минатиот пат е во редот.</numerusform>
            <numerusform>%n извози од минатиот пат се во редот.</numerusform>
            <numerusform>%n извози од минатиот пат се во редот.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export is not finished</source>
        <translation>Извозот не е завршен</translation>
    </message>
    <message>
        <source>A file is still being exported.</source>
        <translation>Датотека сè уште се извезува.</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>&amp;Анимација…</translation>
    </message>
    <message>
        <source>Exports the motion instead, as GIF, MP4 and others.</source>
        <translation>Наместо тоа го извезува движењето, како GIF, MP4 и други.</translation>
    </message>
    <message>
        <source>If you stop now, no file is written.</source>
        <translation>Ако запрете сега, нема да се запише датотека.</translation>
    </message>
    <message>
        <source>&amp;Stop Export</source>
        <translation>&amp;Запри го извозот</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>&amp;Продолжи</translation>
    </message>
    <message>
        <source>Exports are not finished</source>
        <translation>Извозите не се завршени</translation>
    </message>
    <message numerus="yes">
        <source>Barycage closes when they are finished. Closed now, it continues with them at its next start.</source>
        <translation>
            <numerusform>Barycage се затвора кога ќе заврши. Ако го затворите сега, ќе продолжи при следното стартување.</numerusform>
            <numerusform>Barycage се затвора кога ќе завршат. Ако го затворите сега, ќе продолжат при следното стартување.</numerusform>
            <numerusform>Barycage се затвора кога ќе завршат. Ако го затворите сега, ќе продолжат при следното стартување.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Затвори</translation>
    </message>
    <message numerus="yes">
        <source>%n exports are still in the queue.</source>
        <translation>
            <numerusform>%n извоз е сѐ уште во редот.</numerusform>
            <numerusform>%n извози се сѐ уште во редот.</numerusform>
            <numerusform>%n извози се сѐ уште во редот.</numerusform>
        </translation>
    </message>
    <message>
        <source>The file has no entry “%1”.</source>
        <translation>Датотеката нема запис „%1“.</translation>
    </message>
    <message>
        <source>Show a step of the lesson</source>
        <translation>Прикажи чекор од лекцијата</translation>
    </message>
    <message>
        <source>The cage of this entry does not have the same corners as in the lesson.</source>
        <translation>Кафезот на овој запис има други темиња отколку во лекцијата.</translation>
    </message>
    <message>
        <source>The fractals in the open file. The canvas shows the one you select here.</source>
        <translation>Фракталите од отворената датотека. Избраниот се прикажува на сликата.</translation>
    </message>
    <message>
        <source>Ready-made fractals by theme, and your own folders of fractals.</source>
        <translation>Фрактали за почеток, подредени по теми, и Ваши папки со фрактали.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map per row.</source>
        <translation>Пресликувањата на фракталот: неговиот код, по едно пресликување во редица.</translation>
    </message>
    <message>
        <source>Which map may follow which in the chaos game, as a graph and as a matrix.</source>
        <translation>Кои пресликувања играта на хаосот смее да ги примени по кои, како граф и како матрица.</translation>
    </message>
    <message>
        <source>The control cage in numbers: its vertices, their positions at rest, what moving them does, and other cages to choose from.</source>
        <translation>Контролниот кафез во броеви: каде му се темињата, каде се тие во мирување, што прави нивното поместување и други кафези за избор.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Бои, осветленост и позадина на сликата. Се зачувуваат со фракталот.</translation>
    </message>
    <message>
        <source>Mathematical properties of this fractal. Point to a name to see what it means.</source>
        <translation>Математички својства на овој фрактал. Задржете го покажувачот над некое име за да прочитате што значи.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Select one to go back or forward to it.</source>
        <translation>Сите чекори откако е отворена датотеката. Изберете еден за да се вратите на него или да одите напред.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept while working on it. Click one to restore it.</source>
        <translation>Состојби на овој фрактал што сте ги зачувале додека работевте. Кликнете на една за да ја вратите.</translation>
    </message>
    <message>
        <source>The animation of this fractal: its motions, and the keys of everything that can move.</source>
        <translation>Анимацијата на овој фрактал: неговите движења и клучевите на сè што може да се движи.</translation>
    </message>
    <message>
        <source>Find a fractal that looks like a picture: the target, how well the fractal agrees with it, and ways to fit it.</source>
        <translation>Фрактал за слика: целта, колку фракталот се согласува со неа, и прилагодувања.</translation>
    </message>
    <message>
        <source>Pictures drawn one after another in the background, with the progress of each.</source>
        <translation>Слики што се цртаат една по друга во заднина, и докаде е секоја.</translation>
    </message>
    <message>
        <source>A lesson about these fractals: its steps, each with a text and the state of the window, to be played in full screen.</source>
        <translation>Лекција за овие фрактали: нејзините чекори, секој со текст и состојба на прозорецот, за пуштање на целиот екран.</translation>
    </message>
    <message>
        <source>Problems found in the file, with line and column. The text in the file is kept unchanged.</source>
        <translation>Проблеми најдени во датотеката, со ред и колона. Текстот на датотеката останува непроменет.</translation>
    </message>
    <message>
        <source>%1 is already open in this window.</source>
        <translation>%1 веќе е отворена во овој прозорец.</translation>
    </message>
    <message>
        <source>%1 by %2°</source>
        <translation>%1 за %2°</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 со фактор %2</translation>
    </message>
    <message>
        <source>%1 to (%2, %3)</source>
        <translation>%1 во (%2, %3)</translation>
    </message>
    <message>
        <source>%1 by (%2, %3)</source>
        <translation>%1 за (%2, %3)</translation>
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
        <translation>Δ (%1, %2)  должина %3</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>раб %1</translation>
    </message>
    <message>
        <source>edges %1 and %2</source>
        <translation>рабови %1 и %2</translation>
    </message>
    <message>
        <source>Map %1</source>
        <comment>begins a sentence</comment>
        <translation>Пресликувањето %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>Map that takes no part</source>
        <translation>Пресликување што не учествува</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Гранка %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, агол %2</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Теме %1</translation>
    </message>
    <message>
        <source>Edge from vertex %1</source>
        <translation>Страна од темето %1</translation>
    </message>
    <message>
        <source>The whole cage</source>
        <translation>Целиот кафез</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Стожер</translation>
    </message>
    <message>
        <source>Round handle</source>
        <translation>Тркалезна рачка</translation>
    </message>
    <message>
        <source>Square handle</source>
        <translation>Квадратна рачка</translation>
    </message>
    <message>
        <source>the arrow keys move both its ends</source>
        <translation>двата краја се поместуваат со стрелките</translation>
    </message>
    <message>
        <source>the arrow keys move it</source>
        <translation>се поместува со стрелките</translation>
    </message>
    <message>
        <source>the arrow keys turn by one degree</source>
        <translation>стрелките ротираат за еден степен</translation>
    </message>
    <message>
        <source>the arrow keys scale by one percent</source>
        <translation>стрелките скалираат за еден процент</translation>
    </message>
    <message>
        <source>Drag to move the pivot, the centre of rotation and scaling.</source>
        <translation>Влечете ја стожерната точка: ротирањето и скалирањето се околу неа.</translation>
    </message>
    <message>
        <source>Drag to rotate about the pivot; hold Shift for steps of 15°.</source>
        <translation>Влечете за ротирање околу стожерот; Shift: во чекори од 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; hold Shift for x or y only.</source>
        <translation>Влечете за скалирање околу стожерот; Shift: само по x или y.</translation>
    </message>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>вметнато</translation>
    </message>
    <message>
        <source>The name “%1” does not match the chosen format. Choose another name.</source>
        <translation>Името „%1“ не одговара на избраниот формат. Изберете друго име.</translation>
    </message>
    <message>
        <source>Another export in the queue writes “%1”. Choose another name.</source>
        <translation>Друг извоз во редот ја пишува „%1“. Изберете друго име.</translation>
    </message>
    <message>
        <source>Added to the queue: %1.</source>
        <translation>Додадено во редот: %1.</translation>
    </message>
    <message>
        <source>%1 × %2 are %3 million pixels. Drawing them may take hours, and the file may need up to %4.</source>
        <translation>%1 × %2 се %3 милиони пиксели. Цртањето може да трае со часови, а датотеката може да зафати до %4.</translation>
    </message>
    <message>
        <source>Memory needed: about %1.</source>
        <translation>Потребна меморија: околу %1.</translation>
    </message>
    <message>
        <source>Very large picture</source>
        <translation>Многу голема слика</translation>
    </message>
    <message>
        <source>This picture is very large.</source>
        <translation>Оваа слика е многу голема.</translation>
    </message>
    <message>
        <source>&amp;Export Anyway</source>
        <translation>&amp;Сепак извези</translation>
    </message>
    <message>
        <source>%1 could not be written. Print it to another folder.</source>
        <translation>%1 не можеше да се запише. Печатете во друга папка.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Запишано во %1.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Барај во упатството</translation>
    </message>
    <message>
        <source>Finds these words in the guide. Enter goes to the next match, Shift+Enter to the previous one. Ctrl+F comes back here.</source>
        <translation>Ги означува овие зборови во упатството. Enter го покажува следното место, Shift+Enter претходното. Ctrl+F води овде.</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Не е најдено</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 од %2</translation>
    </message>
    <message>
        <source>User Guide</source>
        <translation>Упатство за корисници</translation>
    </message>
    <message>
        <source>The user guide: what you can do with Barycage, in the order in which you need it.</source>
        <translation>Упатството за корисници: што може да се направи тука, по редоследот по кој е потребно.</translation>
    </message>
    <message>
        <source>Minimal Canonical Simplex</source>
        <translation>Минимален каноничен симплекс</translation>
    </message>
    <message>
        <source>Canonical Simplex %1</source>
        <translation>Каноничен симплекс %1</translation>
    </message>
    <message>
        <source>Bounding Box</source>
        <translation>Опфаќачки правоаголник</translation>
    </message>
    <message>
        <source>Smallest Rectangle</source>
        <translation>Најмал правоаголник</translation>
    </message>
    <message numerus="yes">
        <source>%n Corners</source>
        <translation>
            <numerusform>%n теме</numerusform>
            <numerusform>%n темиња</numerusform>
            <numerusform>%n темиња</numerusform>
        </translation>
    </message>
    <message>
        <source>Convex Hull, Simplified to</source>
        <translation>Конвексна обвивка, упростена на</translation>
    </message>
    <message>
        <source>Regular Polygon with</source>
        <translation>Правилен многуаголник со</translation>
    </message>
    <message>
        <source>Three Edges of the Bounding Box</source>
        <translation>Три рабови на опфатната кутија</translation>
    </message>
    <message>
        <source>Bounding Box, Eight Corners</source>
        <translation>Опфаќачка кутија, осум темиња</translation>
    </message>
    <message>
        <source>Octahedron</source>
        <translation>Октаедар</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Се чита вметнатото…</translation>
    </message>
    <message>
        <source>Nothing was pasted. Line %1 of the clipboard: %2</source>
        <translation>Ништо не е вметнато. Ред %1 од таблата со исечоци: %2</translation>
    </message>
    <message>
        <source>Nothing was pasted. %1</source>
        <translation>Ништо не е вметнато. %1</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard contains no rows of 6 or 7 numbers.</source>
        <translation>Ништо не е вметнато: таблата со исечоци не содржи редици од 6 или 7 броја.</translation>
    </message>
    <message>
        <source>Paste a map</source>
        <translation>Вметнување на пресликување</translation>
    </message>
    <message>
        <source>Paste %1 maps</source>
        <translation>Вметнување на %1 пресликувања</translation>
    </message>
    <message numerus="yes">
        <source>%n maps added.</source>
        <translation>
            <numerusform>Додадено %n пресликување.</numerusform>
            <numerusform>Додадени %n пресликувања.</numerusform>
            <numerusform>Додадени %n пресликувања.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The selected maps were replaced; %n maps pasted.</source>
        <translation>
            <numerusform>Избраните пресликувања се заменети; вметнато %n пресликување.</numerusform>
            <numerusform>Избраните пресликувања се заменети; вметнати %n пресликувања.</numerusform>
            <numerusform>Избраните пресликувања се заменети; вметнати %n пресликувања.</numerusform>
        </translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Според |детерминанта|</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Еднакви</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Според димензија</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Нормализирај</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Тежини</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>Иста тежина за секое пресликување</translation>
    </message>
    <message>
        <source>Weights that cover the attractor evenly at its own dimension</source>
        <translation>Тежини за рамномерна покриеност на атракторот во неговата сопствена димензија</translation>
    </message>
    <message>
        <source>Scale all weights so that they sum to 1</source>
        <translation>Истите односи, со збир 1</translation>
    </message>
    <message>
        <source>Set the weights of all maps that are switched on by a rule</source>
        <translation>Тежини на сите вклучени пресликувања, според некое правило</translation>
    </message>
    <message>
        <source>Pictures (%1);;All files (*)</source>
        <translation>Слики (%1);;Сите датотеки (*)</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>Се зачувува „%1“…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Нема</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Огледало</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Ротација</translation>
    </message>
    <message>
        <source>Dihedral</source>
        <translation>Диедарска</translation>
    </message>
    <message>
        <source>Tetrahedral</source>
        <translation>Тетраедарска</translation>
    </message>
    <message>
        <source>Octahedral</source>
        <translation>Октаедарска</translation>
    </message>
    <message>
        <source>Icosahedral</source>
        <translation>Икосаедарска</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Овој запис нема пресликувања на рамнината.</translation>
    </message>
    <message>
        <source>The cage is at rest: the picture shows the code.</source>
        <translation>Кафезот е во мирување: се прикажува самиот код.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code produces a bent picture. Choose “Affine fit” to bake the closest affine placement.</source>
        <translation>Кафезот ја свиткува сликата, а ниеден афин код не дава свиткана слика. Изберете „Афино приближување“ за да се впише она што е најблиску до неа.</translation>
    </message>
    <message>
        <source>The cage is flat, so its placement cannot be baked into the code. Open the cage first.</source>
        <translation>Кафезот е рамен, па неговата положба не може да се впише во кодот. Прво отворете го кафезот.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>Кафезот е во мирување.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. Bake to change the code.</source>
        <translation>Поместувањето на кафезот ја поместува сликата. Кодот останува ист додека не го впишете тоа во него.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can reproduce, so the code does not change.</source>
        <translation>Поместувањето на целиот кафез го менува кодот. Поместувањето на одделни темиња ја свиткува сликата; тоа кодот не може да го следи, па останува ист.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites all coefficients of the code; the cage is then at rest in its new position.</source>
        <translation>Поместувањето на кафезот ги менува сите коефициенти на кодот, а кафезот останува во мирување таму каде што е.</translation>
    </message>
    <message>
        <source>The cage is not at rest: it already holds a placement.</source>
        <translation>Кафезот не мирува: веќе содржи положба.</translation>
    </message>
    <message>
        <source>Only a cage with three vertices can be unbaked.</source>
        <translation>Од кодот може да се извади само триаголник.</translation>
    </message>
    <message>
        <source>The cage is not convex: the picture may fold over itself at the notch.</source>
        <translation>Кафезот има вдлабнатина: таму сликата може да се превитка преку себе.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture overlap. Move the vertices apart to unfold it.</source>
        <translation>Кафезот е превиткан: делови од сликата лежат еден врз друг. Раздалечете ги темињата за да го одвиткате.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to enclose.</source>
        <translation>Не учествува ниедно пресликување, па нема што да се опфати.</translation>
    </message>
    <message>
        <source>The maps are linked; a cage cannot be fitted to linked maps.</source>
        <translation>Пресликувањата се поврзани; кафез не може да се прилагоди на поврзани пресликувања.</translation>
    </message>
    <message>
        <source>A bent picture cannot be given another cage. First reset the cage or choose “Affine fit”.</source>
        <translation>Свиткана слика не може да ја држи друг кафез. Прво вратете го кафезот во мирување или изберете „Афино приближување“.</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the triangle.</source>
        <translation>Кафезот е сплескан. Прво раширете го триаголникот или вратете го во мирување.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Овој систем нема атрактор што би можел да се опфати.</translation>
    </message>
    <message>
        <source>All maps are off.</source>
        <translation>Сите пресликувања се исклучени.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be compared with a picture.</source>
        <translation>Пресликувањата се поврзани. Со слика може да се споредат само пресликувања кои сите може да следат едно по друго.</translation>
    </message>
    <message>
        <source>A symmetry repeats the maps. Expand it to compare them with a picture.</source>
        <translation>Симетрија ги повторува пресликувањата. Разгрнете ја за да ги споредите пресликувањата со слика.</translation>
    </message>
    <message>
        <source>The cage bends the picture, or is flat. Reset the cage to compare the maps.</source>
        <translation>Кафезот ја витка сликата или е рамен. Вратете го за да се споредат пресликувањата.</translation>
    </message>
    <message>
        <source>The animation of “%1” cannot be taken to another dimension, so it is left out.</source>
        <translation>Анимацијата на „%1“ не може да се пренесе во друга димензија, па се изоставува.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, so it cannot be lifted.</source>
        <translation>„%1“ не е систем во рамнината, па не може да се подигне во просторот.</translation>
    </message>
    <message>
        <source>The maps of “%1” are linked, and maps in space cannot be linked.</source>
        <translation>Пресликувањата на „%1“ се поврзани, а пресликувањата во просторот не можат да бидат.</translation>
    </message>
    <message>
        <source>The cage of “%1” has more than three corners, so it cannot become a tetrahedron. Bake or reset it first.</source>
        <translation>Кафезот на „%1“ има повеќе од три темиња, од кои не се добива тетраедар. Прво впишете го или вратете го.</translation>
    </message>
    <message>
        <source>“%1” is not a system in space, so it cannot be flattened.</source>
        <translation>„%1“ не е систем во просторот, па не може да се израмни.</translation>
    </message>
    <message>
        <source>The direction must have a length other than 0.</source>
        <translation>Насоката не смее да има должина 0.</translation>
    </message>
    <message>
        <source>“%1” has moved branches, which cannot be flattened. Reset them first.</source>
        <translation>„%1“ има поместени гранки, кои не можат да се израмнат. Прво вратете ги.</translation>
    </message>
    <message>
        <source>The cage of “%1” cannot be baked into its maps, so it cannot be flattened.</source>
        <translation>Кафезот на „%1“ не може да се впише во пресликувањата, па не може да се израмни.</translation>
    </message>
    <message>
        <source>Map %1 of “%2” does not keep this direction, so the projection is not an iterated function system. Export a picture seen from that direction instead.</source>
        <translation>Пресликувањето %1 од „%2“ ја менува насоката, па проекцијата не е итериран систем функции. Наместо тоа, извезете слика од таа страна.</translation>
    </message>
    <message>
        <source>An entry needs a name.</source>
        <translation>Записот мора да има име.</translation>
    </message>
    <message>
        <source>Names cannot contain spaces: Fractint reads only the first word.</source>
        <translation>Имињата не смеат да содржат празни места: Fractint го чита само првиот збор.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>„%1“ не може да биде дел од името, бидејќи има посебно значење во .ifs-датотеките.</translation>
    </message>
    <message>
        <source>A name can have at most %1 characters; Fractint ignores the rest.</source>
        <translation>Името има најмногу %1 знаци; остатокот Fractint го занемарува.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint не наведува запис со име „%1“; изберете друго име.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case are not distinguished).</source>
        <translation>Друг запис се вика „%1“ (големите и малите букви не се разликуваат).</translation>
    </message>
    <message>
        <source>A branch</source>
        <translation>Една гранка</translation>
    </message>
    <message>
        <source>%1 has keys, which the maps of the new system could not follow. Remove its keys in the timeline first.</source>
        <translation>%1 има клучеви што пресликувањата на новиот систем не би можеле да ги следат. Прво отстранете ги од временската линија.</translation>
    </message>
    <message>
        <source>A motion moves single maps, and the maps of the new system are others. Remove this motion from the timeline first.</source>
        <translation>Едно движење поместува одделни пресликувања, а тие на новиот систем се други. Прво отстранете го ова движење од временската линија.</translation>
    </message>
    <message>
        <source>%1 has keys: it would be rewritten at this frame only, and what has none at every frame. Remove its keys in the timeline first.</source>
        <translation>%1 има клучеви: би се препишало само во овој кадар, а она што нема клучеви во сите. Прво отстранете ги од временската линија.</translation>
    </message>
    <message>
        <source>Maps in space cannot be linked.</source>
        <translation>Пресликувањата во просторот не можат да се поврзат.</translation>
    </message>
    <message>
        <source>This entry could not be read, so its maps cannot be linked.</source>
        <translation>Овој запис не можеше да се прочита, па неговите пресликувања не можат да се поврзат.</translation>
    </message>
    <message>
        <source>More than %1 maps cannot be linked.</source>
        <translation>Повеќе од %1 пресликувања не можат да се поврзат.</translation>
    </message>
    <message>
        <source>With the links of “%1” every sequence of maps ends, so plain maps would have nothing to draw.</source>
        <translation>Врските на „%1“ ја завршуваат секоја низа пресликувања, па нема ништо што обични пресликувања би можеле да го нацртаат.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be more than %2 words of its maps, which is the limit. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Обичните пресликувања на „%1“ би биле повеќе од %2 зборови од неговите пресликувања, што е границата. Задржете ги врските во датотека .ifs или .flame, или отстранете ги.</translation>
    </message>
    <message>
        <source>The links of “%1” cannot be written as plain maps: a sequence of maps can go on for ever without reaching one that may follow every map. Keep the links in an .ifs or .flame file, or remove them.</source>
        <translation>Врските на „%1“ не можат да се запишат како обични пресликувања: низа пресликувања може да продолжи бескрајно без да стигне до пресликување што смее да го следи секое. Задржете ги врските во датотека .ifs или .flame, или отстранете ги.</translation>
    </message>
    <message>
        <source>Plain maps of “%1” would be words of its maps, which cannot take part in its animation or in its moved branches. Remove these first.</source>
        <translation>Обичните пресликувања на „%1“ би биле зборови од неговите пресликувања, кои не можат да учествуваат во неговата анимација или во поместените гранки. Прво отстранете ги нив.</translation>
    </message>
    <message>
        <source>Map %1 is locked. Unlock it in the Maps panel first.</source>
        <translation>Пресликувањето %1 е заклучено. Прво отклучете го во панелот Пресликувања.</translation>
    </message>
    <message>
        <source>Maps %1 are locked. Unlock them in the Maps panel first.</source>
        <translation>Пресликувањата %1 се заклучени. Прво отклучете ги во панелот Пресликувања.</translation>
    </message>
    <message>
        <source>Lock a map</source>
        <translation>Заклучување на пресликување</translation>
    </message>
    <message>
        <source>Unlock a map</source>
        <translation>Отклучување на пресликување</translation>
    </message>
    <message>
        <source>Lock %1 maps</source>
        <translation>Заклучување на %1 пресликувања</translation>
    </message>
    <message>
        <source>Unlock %1 maps</source>
        <translation>Отклучување на %1 пресликувања</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Бришење на името на пресликувањето %1</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Именување на пресликувањето %1 „%2“</translation>
    </message>
    <message>
        <source>Only a cage with four vertices can be unbaked.</source>
        <translation>Може да се извади само кафез со четири темиња.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so no other cage would show it. First reset the cage or choose “Affine fit”.</source>
        <translation>Кафезот ја свиткува сликата, па ниеден друг кафез не би ја покажал. Прво вратете го кафезот или изберете „Афино приближување“.</translation>
    </message>
    <message>
        <source>The cage is flat. First open or reset the tetrahedron.</source>
        <translation>Кафезот е рамен. Прво отворете го или вратете го тетраедарот.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Прво изберете пресликување.</translation>
    </message>
    <message>
        <source>The maps are linked. Only maps that may all follow each other can be shown alone.</source>
        <translation>Пресликувањата се поврзани. Само пресликувања кои сите може да следат едно по друго може да се прикажат сами.</translation>
    </message>
    <message>
        <source>The cage bends the picture, in which no map can be shown alone. Reset the cage first.</source>
        <translation>Кафезот ја криви сликата, па ниедно пресликување не може да се прикаже само. Прво вратете го кафезот.</translation>
    </message>
    <message>
        <source>Map %1 takes everything to one point, so there is nothing to show alone.</source>
        <translation>Пресликувањето %1 сѐ води во една точка, па нема што да се прикаже само.</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Овој запис не е систем во просторот.</translation>
    </message>
    <message>
        <source>This entry has no maps to vary.</source>
        <translation>Овој запис нема пресликувања за варирање.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be created.</source>
        <translation>Папката %1 не може да се создаде.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size or the supersampling.</source>
        <translation>Нема доволно меморија за оваа слика. Намалете ја или намалете го суперсемплирањето.</translation>
    </message>
    <message>
        <source>It is damaged.</source>
        <translation>Оштетен е.</translation>
    </message>
    <message>
        <source>It is not an export of this program.</source>
        <translation>Не е извоз од оваа програма.</translation>
    </message>
    <message>
        <source>Its settings are not supported by this version.</source>
        <translation>Неговите поставки не се од оваа верзија.</translation>
    </message>
    <message>
        <source>Its file name does not match its format.</source>
        <translation>Датотеката што ја наведува не одговара на неговиот формат.</translation>
    </message>
    <message>
        <source>It is not a regular file.</source>
        <translation>Не е обична датотека.</translation>
    </message>
    <message>
        <source>It cannot be read.</source>
        <translation>Не може да се прочита.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Преголем е.</translation>
    </message>
    <message>
        <source>An export from the last session was skipped. %1 Its damaged file was renamed to %2.</source>
        <translation>Еден извоз од минатиот пат е прескокнат. %1 Неговата оштетена датотека е преименувана во %2.</translation>
    </message>
    <message>
        <source>A file “%1” was created after you added this export. Choose Try Again to replace it.</source>
        <translation>Откако го додадовте овој извоз, се појави датотека „%1“. „Обиди се повторно“ ја заменува.</translation>
    </message>
    <message>
        <source>The fractal in this export cannot be read.</source>
        <translation>Фракталот во овој извоз не може да се прочита.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Нема доволно меморија за оваа слика.</translation>
    </message>
    <message>
        <source>The lesson is larger than 4 MB, which is the limit.</source>
        <translation>Лекцијата е поголема од 4 MB, што е границата.</translation>
    </message>
    <message>
        <source>This is not a lesson: its first line does not begin with “lesson:”.</source>
        <translation>Ова не е лекција: првиот ред не почнува со „lesson:“.</translation>
    </message>
    <message>
        <source>The lesson has no steps.</source>
        <translation>Лекцијата нема чекори.</translation>
    </message>
    <message>
        <source>This line was ignored: settings look like “file: name.ifs”, and steps begin with “##”.</source>
        <translation>Овој ред е прескокнат: поставките изгледаат како „file: ime.ifs“, а чекорите почнуваат со „##“.</translation>
    </message>
    <message>
        <source>The lesson has more than %1 steps; the others were ignored.</source>
        <translation>Лекцијата има повеќе од %1 чекори; другите се прескокнати.</translation>
    </message>
    <message>
        <source>The text of step %1 is longer than %2 characters and was cut.</source>
        <translation>Текстот на чекорот %1 е подолг од %2 знаци и е скратен.</translation>
    </message>
    <message>
        <source>A lesson cannot refer to “%1”. It can refer to a file in its own folder, or to a .ifs or .par file in another one.</source>
        <translation>Лекција не може да упати на „%1“, туку само на датотека во својата папка или на датотека .ifs или .par во друга.</translation>
    </message>
    <message>
        <source>“%1: %2” was not understood.</source>
        <translation>„%1: %2“ не е разбрано.</translation>
    </message>
    <message>
        <source>“%1” is unknown to this version and is kept.</source>
        <translation>„%1“ ѝ е непознато на оваа верзија и се задржува.</translation>
    </message>
    <message>
        <source>A %1 picture has at most %2 pixels along a side.</source>
        <translation>Слика во формат %1 има најмногу %2 пиксели по страна.</translation>
    </message>
    <message>
        <source>A JPEG picture cannot be transparent. Choose a background colour or another format.</source>
        <translation>Слика JPEG не може да биде проѕирна. Изберете боја на позадината или друг формат.</translation>
    </message>
    <message>
        <source>A JPEG picture has at most %1 dots per inch.</source>
        <translation>Слика JPEG има најмногу %1 точки на инч.</translation>
    </message>
    <message>
        <source>Such a picture cannot be written as %1.</source>
        <translation>Таква слика не може да се запише како %1.</translation>
    </message>
    <message>
        <source>The picture cannot be opened.</source>
        <translation>Сликата не може да се отвори.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture.</source>
        <translation>Датотеката не е PNG-слика.</translation>
    </message>
    <message>
        <source>The picture is damaged or incomplete. Draw it again.</source>
        <translation>Сликата е оштетена или нецелосна. Нацртајте ја повторно.</translation>
    </message>
    <message>
        <source>The picture contains no system: it was not written by Barycage, or another program removed the text that holds it.</source>
        <translation>Сликата не содржи систем: не ја запишал Barycage или друга програма ѝ го отстранила текстот.</translation>
    </message>
    <message>
        <source>The system in the picture is larger than 8 MB.</source>
        <translation>Системот во сликата е поголем од 8 MB.</translation>
    </message>
    <message>
        <source>The picture contains too much text: the limit is 40 MB in total.</source>
        <translation>Сликата носи премногу текст: границата е вкупно 40 MB.</translation>
    </message>
    <message>
        <source>The file is not a PNG picture, or it is damaged.</source>
        <translation>Датотеката не е PNG-слика или е оштетена.</translation>
    </message>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Сликата не може да се запише: %1</translation>
    </message>
    <message>
        <source>The picture is damaged, or its text cannot be read.</source>
        <translation>Сликата е оштетена, или нејзиниот текст не може да се прочита.</translation>
    </message>
    <message>
        <source>the WebP encoder does not have enough memory.</source>
        <translation>кодерот за WebP нема доволно меморија.</translation>
    </message>
    <message>
        <source>An exact picture of this system would take too long. Draw it with points.</source>
        <translation>Точна слика на овој систем би траела предолго. Нацртајте ја со точки.</translation>
    </message>
    <message>
        <source>The folder for temporary files does not have enough space for the frames: %1.</source>
        <translation>Во папката за привремени датотеки нема место за кадрите: %1.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries are not installed on this machine, so no videos can be written. Install them, or write the frames as PNG pictures instead.</source>
        <translation>Библиотеките на FFmpeg не се инсталирани на овој компјутер, па не може да се запишуваат видеа. Инсталирајте ги или запишете ги кадрите како PNG-слики.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries on this machine cannot write %1 files: the encoder %2 is missing. Choose another format.</source>
        <translation>Библиотеките на FFmpeg на овој компјутер не можат да запишуваат датотеки %1: недостасува кодерот %2. Изберете друг формат.</translation>
    </message>
    <message>
        <source>The video cannot be written: %1.</source>
        <translation>Видеото не може да се запише: %1.</translation>
    </message>
    <message>
        <source>Flip maps</source>
        <translation>Преврти пресликувања</translation>
    </message>
    <message>
        <source>Rotate maps by 90°</source>
        <translation>Заврти пресликувања за 90°</translation>
    </message>
    <message>
        <source>Rotate maps by −90°</source>
        <translation>Заврти пресликувања за −90°</translation>
    </message>
    <message>
        <source>Align maps</source>
        <translation>Порамни пресликувања</translation>
    </message>
    <message>
        <source>Distribute maps</source>
        <translation>Распореди пресликувања</translation>
    </message>
    <message>
        <source>Fit maps to the corners</source>
        <translation>Постави пресликувања во темињата</translation>
    </message>
    <message>
        <source>Only maps in the plane can be arranged.</source>
        <translation>Може да се распоредуваат само пресликувања во рамнината.</translation>
    </message>
    <message>
        <source>Select at least two maps first.</source>
        <translation>Прво изберете барем две пресликувања.</translation>
    </message>
    <message>
        <source>Select at least three maps first.</source>
        <translation>Прво изберете барем три пресликувања.</translation>
    </message>
    <message>
        <source>The cage is flat, so maps cannot be moved in it. Reset the cage first.</source>
        <translation>Кафезот е рамен, па пресликувањата не можат да се поместуваат во него. Прво врати го кафезот.</translation>
    </message>
    <message>
        <source>Duplicate a map</source>
        <translation>Удвојување на пресликување</translation>
    </message>
    <message>
        <source>Duplicate %1 maps</source>
        <translation>Удвојување на %1 пресликувања</translation>
    </message>
    <message>
        <source>Delete a map</source>
        <translation>Бришење на пресликување</translation>
    </message>
    <message>
        <source>Delete %1 maps</source>
        <translation>Бришење на %1 пресликувања</translation>
    </message>
    <message>
        <source>contractive in some norm, γ &lt; 1</source>
        <translation>контрактивен во некоја норма, γ &lt; 1</translation>
    </message>
    <message>
        <source>(the open set condition holds)</source>
        <translation>(условот на отворено множество важи)</translation>
    </message>
    <message>
        <source>(the open set condition holds, within rounding error)</source>
        <translation>(условот на отворено множество важи, колку што се гледа од заокружувањето)</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>важи</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>не важи</translation>
    </message>
    <message>
        <source>open set condition</source>
        <translation>услов на отворено множество</translation>
    </message>
    <message>
        <source>neighbours</source>
        <translation>соседи</translation>
    </message>
    <message>
        <source>Hausdorff dimension</source>
        <translation>Хаусдорфова димензија</translation>
    </message>
    <message>
        <source>(finite type)</source>
        <translation>(конечен тип)</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>спектар</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>најмногу %1</translation>
    </message>
    <message>
        <source>holds, within rounding error</source>
        <translation>важи, колку што се гледа од заокружувањето</translation>
    </message>
    <message>
        <source>fails, within rounding error</source>
        <translation>не важи, колку што се гледа од заокружувањето</translation>
    </message>
    <message>
        <source>The pieces of “%1” overlap or touch too much to find its voxels in reasonable time, even at the lowest resolution.</source>
        <translation>Деловите на „%1“ премногу се преклопуваат или се допираат за да се најдат неговите воксели за разумно време, дури и при најниската резолуција.</translation>
    </message>
    <message>
        <source>FFmpeg&apos;s libraries cannot be loaded, so no videos can be written: %1.</source>
        <translation>Библиотеките на FFmpeg не можат да се вчитаат, па не можат да се запишуваат видеа: %1.</translation>
    </message>
    <message>
        <source>This entry is not an iterated function system.</source>
        <translation>Овој запис не е систем од итерирани функции.</translation>
    </message>
    <message>
        <source>This entry has %1 maps; a web page can have at most %2.</source>
        <translation>Овој запис има %1 пресликувања; една веб-страница може да има најмногу %2.</translation>
    </message>
    <message>
        <source>A solid has no shadow on the ground. Move its light in the Appearance panel: the solid darkens the side that faces away from it.</source>
        <translation>Телото не фрла сенка на подот. Поместете ја неговата светлина во панелот „Изглед“: страната свртена од неа потемнува.</translation>
    </message>
    <message>
        <source>This entry could not be read, so there is no picture to cast a shadow.</source>
        <translation>Овој запис не можеше да се прочита, па нема слика што би фрлила сенка.</translation>
    </message>
    <message>
        <source>its shadow</source>
        <translation>неговата сенка</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Reduce its size.</source>
        <translation>Нема доволно меморија за оваа слика. Намалете ја.</translation>
    </message>
    <message>
        <source>One picture</source>
        <translation>Една слика</translation>
    </message>
    <message>
        <source>Both eyes, side by side</source>
        <translation>За двете очи, една до друга</translation>
    </message>
    <message>
        <source>Stereo, &amp;Side by Side</source>
        <translation>Стерео, &amp;еден до друг</translation>
    </message>
    <message>
        <source>Show the views of both eyes side by side, the left eye on the left</source>
        <translation>Прикажува што гледа секое око, левото лево</translation>
    </message>
    <message>
        <source>Red and cyan glasses</source>
        <translation>Очила црвено-цијан</translation>
    </message>
    <message>
        <source>Stereo, for Red and &amp;Cyan Glasses</source>
        <translation>Стерео, за црвено-&amp;цијан очила</translation>
    </message>
    <message>
        <source>Show the views of both eyes in one picture, in red and cyan</source>
        <translation>Прикажува во една слика што гледаат двете очи, во црвено и цијан</translation>
    </message>
    <message>
        <source>Flame: flam3, Apophysis, JWildfire, Fractorium</source>
        <translation>Пламен: flam3, Apophysis, JWildfire, Fractorium</translation>
    </message>
    <message>
        <source>IFStile (.aifs)</source>
        <translation>IFStile (.aifs)</translation>
    </message>
    <message>
        <source>Formulas and a figure for LaTeX (.tex)</source>
        <translation>Формули и слика за LaTeX (.tex)</translation>
    </message>
    <message>
        <source>Table with commas (.csv)</source>
        <translation>Табела со запирки (.csv)</translation>
    </message>
    <message>
        <source>Table with tabs (.tsv)</source>
        <translation>Табела со табулатори (.tsv)</translation>
    </message>
    <message>
        <source>PNG: pixels</source>
        <translation>PNG: пиксели</translation>
    </message>
    <message>
        <source>JPEG: pixels, a small file</source>
        <translation>JPEG: пиксели, мала датотека</translation>
    </message>
    <message>
        <source>WebP: pixels, for web pages</source>
        <translation>WebP: пиксели, за веб-страници</translation>
    </message>
    <message>
        <source>TIFF: pixels, for print</source>
        <translation>TIFF: пиксели, за печатење</translation>
    </message>
    <message>
        <source>OpenEXR: linear light, for compositing</source>
        <translation>OpenEXR: линеарна светлина, за композитинг</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF: облици за печатење</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG: облици за програми за цртање</translation>
    </message>
    <message>
        <source>Mesh for 3D printing (.stl)</source>
        <translation>Тело за печатење (.stl)</translation>
    </message>
    <message>
        <source>Mesh (.obj)</source>
        <translation>Тело (.obj)</translation>
    </message>
    <message>
        <source>Mesh (.glb)</source>
        <translation>Тело (.glb)</translation>
    </message>
    <message>
        <source>Mesh (.ply)</source>
        <translation>Тело (.ply)</translation>
    </message>
    <message>
        <source>“%1” has %2 numbers for %3 maps, so it is not read as their weights, which are computed from the determinants.</source>
        <translation>„%1“ има %2 броеви за %3 пресликувања, па не се чита како нивни тежини; тие се земаат од детерминантите.</translation>
    </message>
    <message>
        <source>MP4: plays everywhere</source>
        <translation>MP4: се пушта насекаде</translation>
    </message>
    <message>
        <source>WebM: for web pages, with transparency</source>
        <translation>WebM: за веб-страници, со проѕирност</translation>
    </message>
    <message>
        <source>MKV: lossless, for editing</source>
        <translation>MKV: без загуба, за обработка</translation>
    </message>
    <message>
        <source>GIF: 256 colours</source>
        <translation>GIF: 256 бои</translation>
    </message>
    <message>
        <source>WebP: a lossless animated image</source>
        <translation>WebP: подвижна слика без загуба</translation>
    </message>
    <message>
        <source>APNG: a lossless animated image</source>
        <translation>APNG: подвижна слика без загуба</translation>
    </message>
    <message>
        <source>The link holds more than 1 MB of text, which is the limit.</source>
        <translation>Врската содржи повеќе од 1 MB текст, а тоа е границата.</translation>
    </message>
    <message>
        <source>This link is damaged, or it holds no fractal.</source>
        <translation>Оваа врска е оштетена или не содржи фрактал.</translation>
    </message>
    <message>
        <source>This link was cut off: its end is missing. Copy all of it.</source>
        <translation>Оваа врска е пресечена: недостасува крајот. Копирајте ја целата.</translation>
    </message>
    <message>
        <source>Drawing the pictures…</source>
        <translation>Се цртаат сликите…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Лекција</translation>
    </message>
    <message>
        <source>PDF: a page with the picture</source>
        <translation>PDF: страница со сликата</translation>
    </message>
    <message>
        <source>SVG: a page with the picture</source>
        <translation>SVG: страница со сликата</translation>
    </message>
    <message>
        <source>There is not enough memory for the video.</source>
        <translation>Нема доволно меморија за видеото.</translation>
    </message>
    <message>
        <source>The encoder of the video does not work. There may not be enough memory for it.</source>
        <translation>Кодерот на видеото не работи. Можеби нема доволно меморија за него.</translation>
    </message>
    <message>
        <source>lists of numbers</source>
        <translation>листи од броеви</translation>
    </message>
    <message>
        <source>This map is not understood, so none is read.</source>
        <translation>Ова пресликување не се разбира, па затоа не се чита ниедно.</translation>
    </message>
    <message>
        <source>“%1” is not understood, so no map is read.</source>
        <translation>„%1“ не се разбира, па затоа не се чита ниедно пресликување.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Address</source>
        <translation>Адреса</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Назад</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Обиколка</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 од %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Готово</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Влечење</translation>
    </message>
    <message>
        <source>Drag a corner of the triangle: the whole picture follows.</source>
        <translation>Повлечете едно теме на триаголникот: целата слика го следи.</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Стискање</translation>
    </message>
    <message>
        <source>Push a corner onto the opposite side until the picture is flat, then pull it open again.</source>
        <translation>Турнете едно теме врз спротивната страна додека сликата не стане рамна, па повторно отворете ја.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Поништување</translation>
    </message>
    <message>
        <source>Press %1 to take back what you have just done.</source>
        <translation>Притиснете %1 за да го поништите она што штотуку го направивте.</translation>
    </message>
    <message>
        <source>Collection</source>
        <translation>Збирка</translation>
    </message>
    <message>
        <source>Double-click a picture of the collection that you like.</source>
        <translation>Кликнете двапати на слика од збирката што ви се допаѓа.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>Press Wind in the timeline and watch the picture sway.</source>
        <translation>Притиснете Ветер на временската линија и гледајте како сликата се ниша.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Извоз</translation>
    </message>
    <message>
        <source>Press %1 to save the picture for others.</source>
        <translation>Притиснете %1 за да ја зачувате сликата за други.</translation>
    </message>
    <message>
        <source>That Is It</source>
        <translation>Тоа е сè</translation>
    </message>
    <message>
        <source>Three more steps show what the picture is made of.</source>
        <translation>Уште три чекори покажуваат од што е направена сликата.</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Пресликување</translation>
    </message>
    <message>
        <source>Each row is a map that makes one smaller copy of the whole: double-click a number and type another.</source>
        <translation>Секој ред е пресликување што прави помала копија на целината: кликнете двапати на број и напишете друг.</translation>
    </message>
    <message>
        <source>Click a point: the maps that lead there are its address, and you hold the branch that they make.</source>
        <translation>Кликнете на точка: пресликувањата што водат до неа се нејзината адреса, а вие ја држите гранката што ја прават.</translation>
    </message>
    <message>
        <source>Norm</source>
        <translation>Норма</translation>
    </message>
    <message>
        <source>‖A‖ is how far a map stretches at most: change a number, and keep it below 1.</source>
        <translation>‖A‖ кажува колку најмногу растегнува пресликувањето: сменете број и останете под 1.</translation>
    </message>
    <message>
        <source>In the timeline, choose Wind under Add Motion and watch the picture sway as well.</source>
        <translation>На временската линија изберете Ветер под „Додај движење“ и гледајте како и сликата се ниша.</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Прескокни</translation>
    </message>
    <message>
        <source>&amp;Go On</source>
        <translation>&amp;Продолжи</translation>
    </message>
    <message>
        <source>Open the panel %1 again: it is under View › Panels.</source>
        <translation>Отворете го панелот %1 повторно: под Приказ › Панели е.</translation>
    </message>
    <message>
        <source>That Is All</source>
        <translation>Тоа е сè</translation>
    </message>
    <message>
        <source>Now take whatever you like by its corners.</source>
        <translation>Сега фатете што сакате за неговите темиња.</translation>
    </message>
    <message>
        <source>Press %1 once more: the picture is still flat.</source>
        <translation>Притиснете %1 уште еднаш: сликата е сè уште рамна.</translation>
    </message>
</context>
<context>
    <name>VideoSystem</name>
    <message>
        <source>The file is not a video.</source>
        <translation>Датотеката не е видео.</translation>
    </message>
    <message>
        <source>The video contains no system: it was not written by Barycage, it is damaged, or another program removed the text that holds it.</source>
        <translation>Видеото не содржи систем: не го запишал Barycage, оштетено е или друга програма го отстранила текстот што го содржи.</translation>
    </message>
    <message>
        <source>The system in the video is larger than 8 MB.</source>
        <translation>Системот во видеото е поголем од 8 MB.</translation>
    </message>
</context>
<context>
    <name>VideoWriter</name>
    <message>
        <source>There is not enough memory for a frame of the video.</source>
        <translation>Нема доволно меморија за кадар од видеото.</translation>
    </message>
    <message>
        <source>A frame of the GIF cannot be created.</source>
        <translation>Кадар од GIF-от не може да се направи.</translation>
    </message>
    <message>
        <source>The animation cannot be stored in the video.</source>
        <translation>Анимацијата не може да се зачува во видеото.</translation>
    </message>
    <message>
        <source>A side of %1 pixels is too long for this format; the limit is %2.</source>
        <translation>Страна од %1 пиксели е предолга за овој формат; границата е %2.</translation>
    </message>
    <message>
        <source>This format shows at most %1 frames per second. Choose a lower rate.</source>
        <translation>Овој формат прикажува најмногу %1 кадри во секунда. Изберете помала брзина.</translation>
    </message>
    <message>
        <source>This build of Barycage does not include FFmpeg&apos;s libraries and cannot write videos. Write the frames as PNG pictures instead.</source>
        <translation>Овој Barycage е изграден без библиотеките на FFmpeg и не запишува видеа. Запишете ги кадрите како PNG-слики.</translation>
    </message>
    <message>
        <source>There is not enough memory for the palette of the GIF.</source>
        <translation>Нема доволно меморија за палетата на GIF-от.</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Recent files and the collection.</source>
        <translation>Последните датотеки и збирката.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Добре дојдовте</translation>
    </message>
    <message>
        <source>Continue with</source>
        <translation>Продолжи со</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>О&amp;твори…</translation>
    </message>
    <message>
        <source>A file or the collection.</source>
        <translation>Датотека или збирката.</translation>
    </message>
    <message>
        <source>Start with</source>
        <translation>Почни со</translation>
    </message>
    <message>
        <source>Co&amp;llection</source>
        <translation>&amp;Збирка</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Accepts the settings and closes the dialog.</source>
        <translation>Го презема она што го покажува дијалогот и го затвора.</translation>
    </message>
    <message>
        <source>Closes the dialog without changing anything.</source>
        <translation>Го затвора дијалогот и не менува ништо.</translation>
    </message>
    <message>
        <source>Closes the dialog.</source>
        <translation>Го затвора дијалогот.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Избриши</translation>
    </message>
    <message>
        <source>%1 Panel “%2”: %3</source>
        <comment>what it does, panel, what the panel is for</comment>
        <translation>%1 Панел „%2“: %3</translation>
    </message>
</context>
<context>
    <name>WrittenBanner</name>
    <message>
        <source>Show in Folder</source>
        <translation>Покажи во папката</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Ја покажува папката на запишаната датотека во управувачот со датотеки.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Printed to a file</source>
        <translation>Отпечатено во датотека</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>%1 е запишана.</translation>
    </message>
</context>
<context>
    <name>document::CageActions</name>
    <message>
        <source>This entry is not a system in the plane, so it has no control cage.</source>
        <translation>Овој запис не е систем во рамнината, па нема контролен кафез.</translation>
    </message>
    <message>
        <source>The cage is too flat to be inverted. Open it by dragging a corner, or reset it, and try again.</source>
        <translation>Кафезот е премногу сплескан за да може да се врати. Раширете го со влечење на некое теме или вратете го во мирување, па обидете се повторно.</translation>
    </message>
    <message>
        <source>The three points are on one line, so they define no coordinates. Click a third point off the line.</source>
        <translation>Трите точки лежат на една права и не определуваат координати. Ставете ја третата надвор од правата.</translation>
    </message>
    <message>
        <source>Fit the minimal canonical simplex</source>
        <translation>Опфаќање со минимален каноничен симплекс</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Враќање на кафезот во мирување</translation>
    </message>
    <message>
        <source>Bake the placement into the code</source>
        <translation>Впишување на поставеноста во кодот</translation>
    </message>
    <message>
        <source>Define the control triangle</source>
        <translation>Дефинирање на контролниот триаголник</translation>
    </message>
    <message>
        <source>Vertex %1 is already there.</source>
        <translation>Темето %1 е веќе таму.</translation>
    </message>
    <message>
        <source>A cage can have at most %1 vertices.</source>
        <translation>Кафезот има најмногу %1 темиња.</translation>
    </message>
    <message>
        <source>There is no room for a vertex here.</source>
        <translation>Тука нема место за теме.</translation>
    </message>
    <message>
        <source>Insert a vertex</source>
        <translation>Додавање на теме</translation>
    </message>
    <message>
        <source>A cage needs at least three vertices.</source>
        <translation>Кафезот има најмалку три темиња.</translation>
    </message>
    <message>
        <source>Without this vertex the cage at rest would cross itself or be flat.</source>
        <translation>Без ова теме кафезот во мирување би се вкрстувал сам со себе или би бил сплескан.</translation>
    </message>
    <message>
        <source>Delete vertex %1</source>
        <translation>Бришење на темето %1</translation>
    </message>
    <message>
        <source>Make the cage regular</source>
        <translation>Правење правилен кафез</translation>
    </message>
    <message>
        <source>Unbake: extract the placement from the code</source>
        <translation>Вадење на поставеноста од кодот</translation>
    </message>
    <message>
        <source>Without these vertices the cage at rest would cross itself or be flat.</source>
        <translation>Без овие темиња кафезот во мирување би се вкрстувал сам со себе или би бил сплескан.</translation>
    </message>
    <message>
        <source>Delete %1 vertices</source>
        <translation>Бришење на %1 темиња</translation>
    </message>
    <message>
        <source>The cage is already the minimal canonical simplex.</source>
        <translation>Кафезот веќе е минималниот каноничен симплекс.</translation>
    </message>
    <message>
        <source>The cage is already regular.</source>
        <translation>Кафезот веќе е правилен.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Премести го темето %1 во (%2, %3)</translation>
    </message>
    <message>
        <source>The four points are in one plane, so they define no coordinates. Click the fourth point off the plane.</source>
        <translation>Четирите точки лежат во една рамнина, па не одредуваат координати. Кликнете ја четвртата точка надвор од рамнината.</translation>
    </message>
    <message>
        <source>Define the control tetrahedron</source>
        <translation>Одреди го контролниот тетраедар</translation>
    </message>
</context>
<context>
    <name>document::Document</name>
    <message>
        <source>%1 (frame %2)</source>
        <comment>what is done, at which frame</comment>
        <translation>%1 (кадар %2)</translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Овој запис нема пресликувања на рамнината.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Афино инваријантен облик</translation>
    </message>
    <message>
        <source>Row j of a matrix contains the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. Dragging the triangle does not change the matrices. If no entry is negative, the map takes the triangle to a part of itself.</source>
        <translation>Редицата j на матрицата ги содржи барицентричните координати на сликата на темето j во однос на триаголникот, па збирот на секоја редица е 1. Матриците не се менуваат кога се влече триаголникот. Ако ниеден елемент не е негативен, пресликувањето го пресликува триаголникот во самиот себе.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копирај</translation>
    </message>
    <message>
        <source>Each map as a matrix that acts on barycentric coordinates in the control triangle; every row sums to 1.</source>
        <translation>Секое пресликување како матрица што барицентрични координати во однос на контролниот триаголник ги пресликува во барицентрични координати: збирот на секоја редица е 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices at full precision.</source>
        <translation>Ги копира триаголникот и матриците со сите цифри.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy includes all of them.
</source>
        <translation>
… и уште %1. „Копирај“ ги зема сите.
</translation>
    </message>
</context>
<context>
    <name>view::AnalysisPanel</name>
    <message>
        <source>Analysis</source>
        <translation>Анализа</translation>
    </message>
    <message>
        <source>Copy All</source>
        <translation>Копирај сѐ</translation>
    </message>
    <message>
        <source>Copy all properties at full precision</source>
        <translation>Копирај ги сите својства со сите цифри</translation>
    </message>
    <message>
        <source>This entry could not be read, so it cannot be analysed.</source>
        <translation>Овој запис не можеше да се прочита, па за него не е познато ништо.</translation>
    </message>
    <message>
        <source>Copy at Full Precision</source>
        <translation>Копирај со сите цифри</translation>
    </message>
    <message>
        <source>Copies the name and the value of every line, at full precision.</source>
        <translation>Го копира секој ред како име и вредност со сите цифри.</translation>
    </message>
    <message>
        <source>On the canvas</source>
        <translation>На платното</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Кутија</translation>
    </message>
    <message>
        <source>Outline the certified bounding box</source>
        <translation>Исцртај ја докажаната опкружувачка кутија</translation>
    </message>
    <message>
        <source>Hull</source>
        <translation>Обвивка</translation>
    </message>
    <message>
        <source>Outline the convex hull</source>
        <translation>Исцртај ја конвексната обвивка</translation>
    </message>
    <message>
        <source>Simplex</source>
        <translation>Симплекс</translation>
    </message>
    <message>
        <source>Outline the minimal canonical simplex</source>
        <translation>Исцртај го минималниот каноничен симплекс</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Елипса</translation>
    </message>
    <message>
        <source>Show the mean and the covariance ellipse</source>
        <translation>Прикажи ги средината и елипсата на коваријансата</translation>
    </message>
    <message>
        <source>Fixed points</source>
        <translation>Неподвижни точки</translation>
    </message>
    <message>
        <source>Mark the fixed point of each map in its colour</source>
        <translation>Означи ја неподвижната точка на секое пресликување во неговата боја</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Цилиндри</translation>
    </message>
    <message>
        <source>Length of the addresses</source>
        <translation>Должина на адресите</translation>
    </message>
    <message>
        <source>The number of symbols in the addresses of the cylinders; fewer if there would be thousands of cylinders</source>
        <translation>Колку симболи имаат адресите на цилиндрите; помалку каде што би имало илјадници</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Должина на адреса</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system produces a bent picture. These are the properties of the code; on the canvas, the outlines bend with the picture.</source>
        <translation>Кафезот ја свиткува сликата, а ниеден систем не дава свиткана слика. Ова се својства на кодот; на платното контурите се свиткуваат со сликата.</translation>
    </message>
    <message>
        <source>Outline the hulls of all pieces with addresses of the same length, each in the colour of its first map; click one to see its address</source>
        <translation>Исцртај ги обвивките на сите делови со адреса со иста должина, во бојата на нејзиното прво пресликување; кликнете на некоја за да ја видите нејзината адреса</translation>
    </message>
    <message>
        <source>This value is still being computed.</source>
        <translation>Оваа вредност сè уште се пресметува.</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>се пресметува…</translation>
    </message>
    <message>
        <source>Branches are moved. Box, simplex, hull, mean and covariance are those of the picture; the other properties are those of the code.</source>
        <translation>Има поместени гранки. Кутијата, симплексот, обвивката, средината и коваријансата се оние на сликата; другите својства се на кодот.</translation>
    </message>
    <message>
        <source>How Pieces Meet…</source>
        <translation>Како се допираат деловите…</translation>
    </message>
    <message>
        <source>Read in the user guide what these properties mean and how they are proved</source>
        <translation>Прочитајте во упатството што значат овие својства и како се докажуваат</translation>
    </message>
    <message>
        <source>Opens the user guide where it explains how the pieces of an attractor meet.</source>
        <translation>Го отвора упатството таму каде што објаснува како се допираат деловите на атракторот.</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>Копирано.</translation>
    </message>
</context>
<context>
    <name>view::AnimationExportDialog</name>
    <message>
        <source>Export the Animation “%1”</source>
        <translation>Извоз на анимацијата „%1“</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>PNG: one picture for each frame</source>
        <translation>PNG: по една слика за секој кадар</translation>
    </message>
    <message>
        <source>A video, an animated image for web pages and messages, or one picture for each frame. All of them contain the animation, so Barycage can open them again.</source>
        <translation>Видео, подвижна слика за страници и пораки, или по една слика за секој кадар. Сите ја содржат анимацијата и Barycage повторно ги отвора.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Формат:</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Исечок</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Погледот на платното</translation>
    </message>
    <message>
        <source>The whole animation</source>
        <translation>Целата анимација</translation>
    </message>
    <message>
        <source>What the frames show where the camera has no keys: the view on the canvas, or everything that becomes visible, with a small margin.</source>
        <translation>Што покажуваат кадрите кога ниеден клуч на камерата не го одредува тоа: она што го покажува платното, или сè што се појавува, со мала маргина.</translation>
    </message>
    <message>
        <source>&amp;Size in pixels:</source>
        <translation>&amp;Големина во пиксели:</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Прв кадар</translation>
    </message>
    <message>
        <source>The first frame to export.</source>
        <translation>Првиот кадар што се извезува.</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Последен кадар</translation>
    </message>
    <message>
        <source>The last frame to export.</source>
        <translation>Последниот кадар што се извезува.</translation>
    </message>
    <message>
        <source>F&amp;rames:</source>
        <translation>Кад&amp;ри:</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Квалитет</translation>
    </message>
    <message>
        <source>The number of points for each pixel of each frame: more points make smoother frames and take longer.</source>
        <translation>Бројот на точки за секој пиксел на секој кадар: повеќе точки даваат помазни кадри и траат подолго.</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Нацрт: 25 точки по пиксел</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Добар: 100 точки по пиксел</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Фин: 400 точки по пиксел</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Најфин: 2000 точки по пиксел</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>Кв&amp;алитет:</translation>
    </message>
    <message>
        <source>Shutter</source>
        <translation>Затворач</translation>
    </message>
    <message>
        <source>Motion blur: the angle for which the shutter is open around each frame. 180° is half the time of a frame, as in films.</source>
        <translation>Заматување од движење: аголот за кој затворачот е отворен околу секој кадар. 180° е половина од времето на кадарот, како во филмовите.</translation>
    </message>
    <message>
        <source>No motion blur</source>
        <translation>Без заматување од движење</translation>
    </message>
    <message>
        <source>S&amp;hutter:</source>
        <translation>&amp;Затворач:</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Експозиција</translation>
    </message>
    <message>
        <source>Smooth: no flicker</source>
        <translation>Мазна: без треперење</translation>
    </message>
    <message>
        <source>Fixed: as in frame 0</source>
        <translation>Постојана: онаа на кадарот 0</translation>
    </message>
    <message>
        <source>Each: frame by frame</source>
        <translation>Секој: за себе</translation>
    </message>
    <message>
        <source>How bright the frames are: following the whole animation without flicker, all like frame 0, or each as bright as it is on the canvas.</source>
        <translation>Колку се светли кадрите: следејќи ја целата анимација без треперење, сите како кадарот 0, или секој светол како на платното.</translation>
    </message>
    <message>
        <source>E&amp;xposure:</source>
        <translation>&amp;Експозиција:</translation>
    </message>
    <message>
        <source>Tasks on a cluster</source>
        <translation>Задачи на кластер</translation>
    </message>
    <message>
        <source>How many cluster tasks share the frames when you choose On a Cluster.</source>
        <translation>Меѓу колку задачи на кластерот се делат кадрите кога ќе изберете „На кластер“.</translation>
    </message>
    <message>
        <source>&amp;Tasks on a cluster:</source>
        <translation>Задачи на &amp;кластер:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the animation. You can continue editing in the meantime: the animation is exported as it was when this dialog opened.</source>
        <translation>Прашува за име на датотека и ја запишува анимацијата. Во меѓувреме можете да продолжите со уредување: се извезува анимацијата каква што била кога се отворил прозорецов.</translation>
    </message>
    <message>
        <source>On a &amp;Cluster…</source>
        <translation>На к&amp;ластер…</translation>
    </message>
    <message>
        <source>Writes a folder with the animation and with scripts that draw it on a Slurm cluster, and submits the job if sbatch is found.</source>
        <translation>Запишува папка со анимацијата и со скрипти што ја цртаат на кластер со Slurm, и ја поднесува ако се најде sbatch.</translation>
    </message>
    <message>
        <source>Export Animation</source>
        <translation>Извоз на анимација</translation>
    </message>
    <message>
        <source>Measuring the brightness…</source>
        <translation>Се мери осветленоста…</translation>
    </message>
    <message>
        <source>Export stopped. The pictures written so far are complete; export again to draw the others.</source>
        <translation>Извозот е запрен. Досега запишаните слики се целосни; извезете повторно за да се нацртаат другите.</translation>
    </message>
    <message>
        <source>Written to %1 and so on, up to %2.</source>
        <translation>Запишано во %1 и така натаму до %2.</translation>
    </message>
    <message>
        <source>Folder That the Cluster Can Read and Write</source>
        <translation>Папка што кластерот може да ја чита и запишува</translation>
    </message>
    <message>
        <source>Writing the job folder…</source>
        <translation>Се запишува папката на задачата…</translation>
    </message>
    <message>
        <source>Cancelled; the folder may be incomplete.</source>
        <translation>Откажано; папката можеби е нецелосна.</translation>
    </message>
    <message>
        <source>The job is in %1. sbatch was not found on this computer: run submit.sh in this folder on the cluster.</source>
        <translation>Задачата е во %1. Тука нема sbatch: пуштете го submit.sh од папката на кластерот.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>Погледот „%1“</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Кадар без атрактор</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Исечо&amp;к:</translation>
    </message>
    <message>
        <source>The animation “%1” is still being exported.</source>
        <translation>Анимацијата „%1“ сè уште се извезува.</translation>
    </message>
    <message>
        <source>The pictures written so far are complete and will be kept.</source>
        <translation>Досега запишаните слики се целосни и ќе останат.</translation>
    </message>
    <message>
        <source>Summary of the export</source>
        <translation>Преглед на извозот</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), %1 s.</source>
        <translation>
            <numerusform>%n кадар, %1 s.</numerusform>
            <numerusform>%n кадри, %1 s.</numerusform>
            <numerusform>%n кадри, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for existing pictures…</source>
        <translation>Се бараат постојни слики…</translation>
    </message>
    <message>
        <source>Replace Files?</source>
        <translation>Да се заменат датотеките?</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) with the names of these pictures exist already and hold something else.</source>
        <translation>
            <numerusform>%n датотека со име на една од овие слики веќе постои и содржи нешто друго.</numerusform>
            <numerusform>%n датотеки со имињата на овие слики веќе постојат и содржат нешто друго.</numerusform>
            <numerusform>%n датотеки со имињата на овие слики веќе постојат и содржат нешто друго.</numerusform>
        </translation>
    </message>
    <message>
        <source>The first one is “%1”. If you replace them, their contents are lost.</source>
        <translation>Првата е „%1“. Ако ги замените, нивната содржина ќе се изгуби.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Замени</translation>
    </message>
    <message>
        <source>Frame of the preview</source>
        <translation>Кадар на прегледот</translation>
    </message>
    <message>
        <source>The frame that the preview shows</source>
        <translation>Кадарот што го покажува прегледот</translation>
    </message>
    <message>
        <source>Choose how many tasks share the frames, then click On a Cluster… again.</source>
        <translation>Изберете колку задачи ќе ги делат кадрите, па кликнете повторно на „На кластер…“.</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Суперсемплирање</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Црта толку пиксели по секоја страна на еден: помазни рабови.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>&amp;Суперсемплирање:</translation>
    </message>
    <message>
        <source>%1 needs even sides: the last column or row is shown twice.</source>
        <translation>%1 бара парни страни: последната колона или редица се прикажува двапати.</translation>
    </message>
    <message>
        <source>%1 has no transparency: the background becomes black.</source>
        <translation>%1 нема проѕирност: позадината станува црна.</translation>
    </message>
</context>
<context>
    <name>view::AppearancePanel</name>
    <message>
        <source>Appearance</source>
        <translation>Изглед</translation>
    </message>
    <message>
        <source>Reset to Default</source>
        <translation>Врати почетни вредности</translation>
    </message>
    <message>
        <source>Reset every setting of this panel to its default</source>
        <translation>Сите поставки на овој панел како кај нов фрактал</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Боја според</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Густина</translation>
    </message>
    <message>
        <source>Colour by the density of points</source>
        <translation>Палетата ја следи густината на точките</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Пресликување</translation>
    </message>
    <message>
        <source>Colour by the last map applied</source>
        <translation>Бојата на последното применето пресликување</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адреса</translation>
    </message>
    <message>
        <source>Colour by the address of each point</source>
        <translation>Палетата ја следи адресата на секоја точка</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Едноставно</translation>
    </message>
    <message>
        <source>One colour, with the density as its opacity</source>
        <translation>Една боја; густината е нејзината непроѕирност</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Единствена боја</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Боја</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Палета</translation>
    </message>
    <message>
        <source>Edit Palette</source>
        <translation>Уреди палета</translation>
    </message>
    <message>
        <source>Edit the palette, or load one from a file</source>
        <translation>Уреди ја палетата или вчитај палета од датотека</translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation>Боја на позадината</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Проѕирна</translation>
    </message>
    <message>
        <source>Make the background transparent</source>
        <translation>Проѕирна позадина</translation>
    </message>
    <message>
        <source>Make the background opaque</source>
        <translation>Непроѕирна позадина</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Позадина</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Осветленост</translation>
    </message>
    <message>
        <source>How strongly thin parts show: κ of the logarithmic tone curve</source>
        <translation>Колку рано стануваат видливи ретките делови: κ од логаритамската тонска крива</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Гама</translation>
    </message>
    <message>
        <source>Exponent of the tone curve: higher values lift the dark parts</source>
        <translation>Експонент на тонската крива: поголемите вредности ги осветлуваат темните делови</translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation>Суперсемплирање</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Исклучено</translation>
    </message>
    <message>
        <source>%1 × %1 sub-pixels</source>
        <translation>%1 × %1 потпиксели</translation>
    </message>
    <message>
        <source>Map colours</source>
        <translation>Бои на пресликувањата</translation>
    </message>
    <message>
        <source>Reset the appearance</source>
        <translation>Враќање на почетниот изглед</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Боја на пресликувањето %1</translation>
    </message>
    <message>
        <source>Makes the background of exported pictures transparent.</source>
        <translation>Ја изоставува позадината од извезените слики.</translation>
    </message>
    <message>
        <source>Computes every pixel from several smaller ones: smoother edges, at the cost of memory and time.</source>
        <translation>Го црта секој пиксел од неколку поситни: помазни рабови, но повеќе меморија и време.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Боење според: %1</translation>
    </message>
    <message>
        <source>Palette: %1</source>
        <translation>Палета: %1</translation>
    </message>
    <message>
        <source>Supersampling: %1</source>
        <translation>Надземање примероци: %1</translation>
    </message>
    <message>
        <source>More Palettes…</source>
        <translation>Уште палети…</translation>
    </message>
    <message>
        <source>Browse hundreds of palettes, change their hue and shift them</source>
        <translation>Прегледај стотици палети, врти ги и поместувај ги</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Контраст</translation>
    </message>
    <message>
        <source>Above 1, light parts become lighter and dark parts darker</source>
        <translation>Над 1, светлите делови стануваат посветли, а темните потемни</translation>
    </message>
    <message>
        <source>Above 1, tones lighter than the middle become lighter, and darker ones darker. Below 1, they come closer together. Black, middle and white stay.</source>
        <translation>Над 1, тоновите посветли од средниот стануваат посветли, а потемните потемни. Под 1, тие се приближуваат. Црното, средината и белото остануваат.</translation>
    </message>
    <message>
        <source>Vibrancy</source>
        <translation>Живост</translation>
    </message>
    <message>
        <source>Below 1, colours are paler, the more so the higher the gamma</source>
        <translation>Под 1, боите се побледи, дотолку повеќе колку што е повисока гамата</translation>
    </message>
    <message>
        <source>At 1, the gamma decides only how strongly a colour shows, and the colour keeps its hue. At 0, the gamma acts on red, green and blue as well, and colours are paler. Flames have the same setting.</source>
        <translation>Со 1, гамата одлучува само колку силно се гледа бојата, а бојата ја задржува својата нијанса. Со 0, гамата дејствува и на црвеното, зеленото и синото, и боите се побледи. Пламените го имаат истото поставување.</translation>
    </message>
    <message>
        <source>What the colour of a point shows: how many points fall there, which map came last, the whole address, or the blend of the colours of all maps applied, as in flames. The position of each map on the palette, and its speed, are in the Maps panel.</source>
        <translation>Што кажува бојата на една точка: колку точки паѓаат таму, кое пресликување било последно, целата адреса или мешавината на боите на сите пресликувања по патот, како кај пламените. Во панелот „Пресликувања“ се местото на секое пресликување на палетата и неговата брзина.</translation>
    </message>
    <message>
        <source>Blend of maps</source>
        <translation>Мешање на пресликувањата</translation>
    </message>
    <message>
        <source>As in flames: each map moves colours towards its position on the palette</source>
        <translation>Како кај пламените: секое пресликување ги влече боите кон своето место на палетата</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, along the addresses, or along the positions between which maps blend.</source>
        <translation>Боите од најретките делови до најгустите, по адресите, или по местата меѓу кои мешаат пресликувањата.</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>Сенка</translation>
    </message>
    <message>
        <source>Opacity of the shadow on the ground behind the picture; 0: no shadow</source>
        <translation>Непроѕирност на сенката на подот зад сликата; 0: без сенка</translation>
    </message>
    <message>
        <source>The shadow is the picture once more: darker, flattened, and laid on the ground on which the picture stands. Drag its tip on the canvas to turn it.</source>
        <translation>Сенката е истата слика уште еднаш: потемна, сплескана и положена на подот на кој стои сликата. Повлечете го нејзиниот врв на платното за да ја завртите.</translation>
    </message>
    <message>
        <source>Shadow sideways</source>
        <translation>Сенка настрана</translation>
    </message>
    <message>
        <source>How far to the right the shadow of what is 1 high ends; below 0, to the left</source>
        <translation>Колку надесно завршува сенката на она што е високо 1; под 0, налево</translation>
    </message>
    <message>
        <source>Shadow backwards</source>
        <translation>Сенка наназад</translation>
    </message>
    <message>
        <source>How far up the shadow of what is 1 high ends; below 0, it falls to the front</source>
        <translation>Колку горе завршува сенката на она што е високо 1; под 0 паѓа напред</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The field next to it shows the same value.</source>
        <translation>Влечете или користете ги стрелките. Бројот до лизгачот ја покажува истата вредност.</translation>
    </message>
</context>
<context>
    <name>view::AttractorWatch</name>
    <message>
        <source>At frame %1, it could not be decided whether there is an attractor.</source>
        <translation>Кај кадар %1 не можеше да се утврди дали постои атрактор.</translation>
    </message>
    <message>
        <source>Weaken the motions.</source>
        <translation>Ослабете ги движењата.</translation>
    </message>
    <message>
        <source>Change the maps.</source>
        <translation>Сменете ги пресликувањата.</translation>
    </message>
    <message>
        <source>Weaken the motions, or change the keys of the maps (frames: %1).</source>
        <translation>Ослабете ги движењата или сменете ги клучевите на пресликувањата (кадри: %1).</translation>
    </message>
    <message>
        <source>Change the keys of the maps (frames: %1).</source>
        <translation>Сменете ги клучевите на пресликувањата (кадри: %1).</translation>
    </message>
    <message>
        <source>Set a key there, or change the keys of the maps (frames: %1).</source>
        <translation>Поставете клуч таму или сменете ги клучевите на пресликувањата (кадри: %1).</translation>
    </message>
    <message>
        <source>At frame %1, there is no attractor.</source>
        <translation>Кај кадар %1 нема атрактор.</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Дијаграм на броење кутии</translation>
    </message>
    <message>
        <source>The number of boxes that meet the attractor, against their fineness: log₂ N over k for boxes of side L·2⁻ᵏ, where L is the side of the square around the attractor. Hollow points are not used for the line: at those sizes, the size of the whole or of a cell affects the count.</source>
        <translation>Колку кутии го допираат атракторот спрема нивната финост: log₂ N над k за кутии со страна L·2⁻ᵏ, L е страната на квадратот околу атракторот. Празните точки не се земени за правата: таму се гледа големината на целината или на една ќелија.</translation>
    </message>
    <message>
        <source>Slope %1 over %2 sizes</source>
        <translation>Наклон %1 преку %2 големини</translation>
    </message>
    <message>
        <source>Copy Sizes and Counts</source>
        <translation>Копирај ги големините и броевите</translation>
    </message>
    <message>
        <source>log₂ N</source>
        <translation>log₂ N</translation>
    </message>
    <message>
        <source>k, boxes of side L·2⁻ᵏ</source>
        <translation>k, кутии со страна L·2⁻ᵏ</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>наклон %1</translation>
    </message>
</context>
<context>
    <name>view::BranchBar</name>
    <message>
        <source>Maps and branches</source>
        <translation>Пресликувања и гранки</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>Д&amp;лабочина</translation>
    </message>
    <message>
        <source>Depth of the branch</source>
        <translation>Длабочина на гранката</translation>
    </message>
    <message>
        <source>The number of maps in the address of the branch (Shift + wheel over the canvas)</source>
        <translation>Колку пресликувања од адресата ја именуваат гранката (Shift + тркалце над платното)</translation>
    </message>
    <message>
        <source>The address of the clicked point, outermost map first; the bold part is the address of the branch</source>
        <translation>Адресата на кликнатата точка, прво најнадворешното пресликување; задебелениот дел е адресата на гранката</translation>
    </message>
    <message>
        <source>New map for this branch</source>
        <translation>Ново пресликување за оваа гранка</translation>
    </message>
    <message>
        <source>Gives this branch and each of its sibling branches a map of its own. The change appears again at all smaller scales.</source>
        <translation>Оваа гранка и секоја нејзина соседна гранка добиваат свое пресликување. Промената се појавува повторно во сите помали размери.</translation>
    </message>
    <message>
        <source>Last map of the address</source>
        <translation>Последното пресликување од адресата</translation>
    </message>
    <message>
        <source>The system keeps its number of maps. All branches that this map makes change in the same way.</source>
        <translation>Бројот на пресликувања останува ист. Сите гранки што ги создава ова пресликување се менуваат на ист начин.</translation>
    </message>
    <message>
        <source>What editing the branch changes</source>
        <translation>Што менува промената на гранката</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Агол за кој избраните пресликувања се нишаат околу своите корени</translation>
    </message>
    <message>
        <source>Swings the selected maps, each about the image of the lowest point of the fractal; the slider returns to the middle when you release it</source>
        <translation>Ги ниша избраните пресликувања, секое околу сликата на најниската точка на фракталот; кога ќе се пушти, лизгачот се враќа на средина</translation>
    </message>
    <message>
        <source>no branch selected</source>
        <translation>нема избрана гранка</translation>
    </message>
    <message>
        <source>branch &lt;b&gt;%1&lt;/b&gt; %2</source>
        <translation>гранка &lt;b&gt;%1&lt;/b&gt; %2</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Swing maps</source>
        <translation>Нишање на пресликувања</translation>
    </message>
    <message>
        <source>Only here</source>
        <translation>Само тука</translation>
    </message>
    <message>
        <source>The code does not change. Only this branch is shown in another position; the same change does not appear at other scales.</source>
        <translation>Кодот не се менува. Само оваа гранка се прикажува на друго место; промената не се повторува во други размери.</translation>
    </message>
    <message>
        <source>Put &amp;Back</source>
        <translation>&amp;Врати на место</translation>
    </message>
    <message>
        <source>Put All &amp;Back</source>
        <translation>&amp;Врати ги сите</translation>
    </message>
    <message>
        <source>Shows the branch in its original position, given by its maps</source>
        <translation>Ја прикажува гранката таму каде што ја ставаат нејзините пресликувања</translation>
    </message>
    <message>
        <source>Shows all branches in their original positions, given by their maps</source>
        <translation>Ја прикажува секоја гранка таму каде што ја ставаат нејзините пресликувања</translation>
    </message>
    <message>
        <source>Put branch %1 back</source>
        <translation>Врати ја гранката %1 на место</translation>
    </message>
    <message>
        <source>Put all branches back</source>
        <translation>Врати ги сите гранки на место</translation>
    </message>
    <message>
        <source>Chan&amp;ge</source>
        <translation>Про&amp;мени</translation>
    </message>
    <message>
        <source>What changes in the code when you drag the branch</source>
        <translation>Што се менува во кодот кога ја влечете гранката</translation>
    </message>
    <message>
        <source>Here and inside it</source>
        <translation>Овде и внатре во неа</translation>
    </message>
    <message>
        <source>The code does not change. This branch is shown in another position, and so is the same branch inside it, again and again: a frond curls up. Nothing beside it changes.</source>
        <translation>Кодот не се менува. Оваа гранка се прикажува на друго место, а исто така и истата гранка внатре во неа, повторно и повторно: листот се витка. Покрај неа ништо не се менува.</translation>
    </message>
    <message>
        <source>Maps cannot swing while the cage is flat. First open or reset the cage.</source>
        <translation>Пресликувањата не може да се нишаат додека кафезот е рамен. Прво отворете го или вратете го кафезот.</translation>
    </message>
    <message>
        <source>S&amp;wing</source>
        <translation>&amp;Заниши</translation>
    </message>
</context>
<context>
    <name>view::BranchChoice</name>
    <message>
        <source>Branch %1</source>
        <translation>Гранка %1</translation>
    </message>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Кликнете на точка од атракторот за да ја изберете нејзината гранка.</translation>
    </message>
    <message>
        <source>Rotate branch %1</source>
        <translation>Ротирај ја гранката %1</translation>
    </message>
    <message>
        <source>Scale branch %1</source>
        <translation>Скалирај ја гранката %1</translation>
    </message>
    <message>
        <source>Move corner %1 of branch %2</source>
        <translation>Помести го аголот %1 на гранката %2</translation>
    </message>
    <message>
        <source>Move branch %1</source>
        <translation>Помести ја гранката %1</translation>
    </message>
    <message>
        <source>This branch is now map 1. You can change it further in the table.</source>
        <translation>Оваа гранка сега е пресликување 1. Броевите во табелата ја менуваат понатаму.</translation>
    </message>
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Stopped: beyond this, the branch would not become smaller inside itself.</source>
        <translation>Запрено: понатаму гранката не би станувала помала внатре во себе.</translation>
    </message>
</context>
<context>
    <name>view::CageFitter</name>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>Сликата е претенка за таков кафез.</translation>
    </message>
    <message>
        <source>The cage already has this shape.</source>
        <translation>Кафезот веќе е таму.</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Опфаќање со кафез</translation>
    </message>
</context>
<context>
    <name>view::CagePanel</name>
    <message>
        <source>Cage</source>
        <translation>Кафез</translation>
    </message>
    <message>
        <source>State of the cage</source>
        <translation>Состојба на кафезот</translation>
    </message>
    <message>
        <source>Warning about the cage</source>
        <translation>Предупредување за кафезот</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Постави</translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation>Измени код</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code does not change</source>
        <translation>Поместувањето на кафезот ја поместува сликата; кодот останува ист</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Поместувањето на кафезот го менува кодот</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Свиткај</translation>
    </message>
    <message>
        <source>Affine fit</source>
        <translation>Афино приближување</translation>
    </message>
    <message>
        <source>The picture follows every vertex and bends; a bent picture cannot be baked into the code</source>
        <translation>Се следи секое теме; сликата се свиткува, а тоа не може да се впише во кодот</translation>
    </message>
    <message>
        <source>The picture follows the vertices by the closest affine map; it can be baked</source>
        <translation>Сликата се поместува со афиното пресликување што е најблиску до темињата; тоа може да се впише во кодот</translation>
    </message>
    <message>
        <source>Bend the picture</source>
        <translation>Свиткување на сликата</translation>
    </message>
    <message>
        <source>Fit the picture by an affine map</source>
        <translation>Афино приближување на сликата</translation>
    </message>
    <message>
        <source>Define…</source>
        <translation>Дефинирај…</translation>
    </message>
    <message>
        <source>Define the triangle with three clicks on the canvas; the picture stays</source>
        <translation>Дефинирај го триаголникот со три кликања на платното; сликата останува иста</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Во мирување</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Впиши</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Опфати</translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation>Опфаќање со кафез</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Темиња</translation>
    </message>
    <message>
        <source>Rest cage</source>
        <translation>Кафез во мирување</translation>
    </message>
    <message>
        <source>Show the positions of the vertices when the cage is at rest</source>
        <translation>Прикажи ги темињата што го држат атракторот додека кафезот е во мирување</translation>
    </message>
    <message>
        <source>Show the rest cage</source>
        <translation>Прикажи го кафезот во мирување</translation>
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
        <translation>x во мирување</translation>
    </message>
    <message>
        <source>y at rest</source>
        <translation>y во мирување</translation>
    </message>
    <message>
        <source>Minimal canonical simplex</source>
        <translation>Минимален каноничен симплекс</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from the right angle.</source>
        <translation>Најмалиот рамнокрак правоаголен триаголник со катети паралелни на оските што ја содржи сликата. Знаците кажуваат на која страна од правиот агол се насочени катетите.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Барицентрични координати на точка</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 for which the point is the weighted mean of the vertices.</source>
        <translation>Тежините a, b, c со a + b + c = 1 што треба да се стават во темињата за тежиштето да биде во таа точка.</translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation>x на точката</translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation>y на точката</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Барицентрични координати</translation>
    </message>
    <message>
        <source>%1 of vertex %2</source>
        <translation>%1 на темето %2</translation>
    </message>
    <message>
        <source>%1 of rest vertex %2</source>
        <translation>%1 на темето %2 во мирување</translation>
    </message>
    <message>
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation>Трите точки лежат на една права: кафезот во мирување мора да опфаќа плоштина.</translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation>Кафезот во мирување мора да биде многуаголник што не се вкрстува сам со себе.</translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation>Враќање на кафезот во мирување</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Впишување на кафезот во кодот</translation>
    </message>
    <message>
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Овој запис не можеше да се прочита, па нема кафез.</translation>
    </message>
    <message>
        <source>At rest: the picture shows the code.</source>
        <translation>Во мирување: сликата е онаа на кодот.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture shows the code.</source>
        <translation>%1 темиња, во мирување: сликата е онаа на кодот.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates; cannot be baked.</source>
        <translation>%1 темиња: свиткана со Вакспресови координати, не може да се впише во кодот.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates; cannot be baked.</source>
        <translation>%1 темиња: свиткана со координати на средна вредност, не може да се впише во кодот.</translation>
    </message>
    <message>
        <source>Flat: the picture is squeezed onto a line. Open the cage to get it back.</source>
        <translation>Сплескано: сликата лежи на една права. Раширете го кафезот и таа се враќа.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the orientation is reversed.</source>
        <translation>Поставена и огледално превртена: плоштините се менуваат со коефициент %1, а ориентацијата е спротивна.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Поставена: плоштините се менуваат со коефициент %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it defines no coordinates.</source>
        <translation>Триаголникот е сплескан: не определува координати.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, катета %2, теме (%3, %4)</translation>
    </message>
    <message>
        <source>Replace the cage by one fitted to the picture; the picture stays</source>
        <translation>Опфати ја сликата со нов кафез; сликата останува иста</translation>
    </message>
    <message>
        <source>Return the cage and the picture to rest</source>
        <translation>Врати ги кафезот и сликата во мирување</translation>
    </message>
    <message>
        <source>Write the displayed picture into the code; the cage is then at rest</source>
        <translation>Впиши ја прикажаната слика во кодот; потоа кафезот е во мирување</translation>
    </message>
    <message>
        <source>Available for triangles only.</source>
        <translation>Достапно само за триаголници.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Премести го темето %1 во (%2, %3)</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3)</source>
        <translation>Дефинирај го темето %1 во (%2, %3)</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>z at rest</source>
        <translation>z во мирување</translation>
    </message>
    <message>
        <source>The smallest tetrahedron with three equal legs parallel to the axes that contains the picture. The signs give the directions in which its legs point from their common corner.</source>
        <translation>Најмалиот тетраедар со три еднакви рабови паралелни на оските што ја содржи сликата. Знаците кажуваат каде се насочени тие рабови од заедничкото теме.</translation>
    </message>
    <message>
        <source>The weights a, b, c, d with a + b + c + d = 1 for which the point is the weighted mean of the vertices.</source>
        <translation>Тежините a, b, c, d со a + b + c + d = 1 што треба да се стават во темињата за тежиштето да биде во таа точка.</translation>
    </message>
    <message>
        <source>z of the point</source>
        <translation>z на точката</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3, %4)</source>
        <translation>Помести го темето %1 на (%2, %3, %4)</translation>
    </message>
    <message>
        <source>The vertices are in one plane: the rest cage must enclose a volume.</source>
        <translation>Темињата лежат во една рамнина: кафезот во мирување мора да опфаќа волумен.</translation>
    </message>
    <message>
        <source>Define vertex %1 at (%2, %3, %4)</source>
        <translation>Дефинирај го темето %1 кај (%2, %3, %4)</translation>
    </message>
    <message>
        <source>Flat: the solid is squeezed onto a plane or a line. Open the cage to get it back.</source>
        <translation>Сплескано: телото лежи во една рамнина или права. Раширете го кафезот и тоа се враќа.</translation>
    </message>
    <message>
        <source>Placed and mirrored: volumes change by the factor %1, and the orientation is reversed.</source>
        <translation>Поставена и огледално превртена: волумените се менуваат со коефициент %1, а ориентацијата е спротивна.</translation>
    </message>
    <message>
        <source>Placed: volumes change by the factor %1.</source>
        <translation>Поставена: волумените се менуваат со коефициент %1.</translation>
    </message>
    <message>
        <source>Available for tetrahedra only.</source>
        <translation>Достапно само за тетраедри.</translation>
    </message>
    <message>
        <source>The tetrahedron is flat: it defines no coordinates.</source>
        <translation>Тетраедарот е сплескан: не определува координати.</translation>
    </message>
    <message>
        <source>This system has no attractor that can be enclosed.</source>
        <translation>Овој систем нема атрактор што може да се опфати.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4, %5)</source>
        <translation>%1, раб %2, теме (%3, %4, %5)</translation>
    </message>
    <message>
        <source>The system has very many maps. Computing the cage around it…</source>
        <translation>Системот има многу пресликувања: кафезот околу него се бара…</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, cannot be baked.</source>
        <translation>%1 темиња: свиткана со координати на средна вредност, не може да се впише во кодот.</translation>
    </message>
    <message>
        <source>Define the tetrahedron with four clicks on the canvas; the picture stays</source>
        <translation>Го одредува тетраедарот со четири клика на платното; сликата останува</translation>
    </message>
</context>
<context>
    <name>view::CageTool</name>
    <message>
        <source>Move the cage</source>
        <translation>Поместување на кафезот</translation>
    </message>
    <message>
        <source>Rotate the cage</source>
        <translation>Ротирање на кафезот</translation>
    </message>
    <message>
        <source>Scale the cage</source>
        <translation>Скалирање на кафезот</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Поместување на темето %1</translation>
    </message>
    <message>
        <source>Move edge %1–%2</source>
        <translation>Поместување на страната %1–%2</translation>
    </message>
    <message>
        <source>Move %1 vertices</source>
        <translation>Поместување на %1 темиња</translation>
    </message>
    <message>
        <source>Select a corner first.</source>
        <translation>Прво изберете теме.</translation>
    </message>
    <message>
        <source>To insert a corner, point to an edge or select a corner.</source>
        <translation>За да вметнете теме, покажете на страна или изберете теме.</translation>
    </message>
</context>
<context>
    <name>view::Canvas</name>
    <message>
        <source>No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). Make it smaller, or switch it off.</source>
        <translation>Нема атрактор: пресликувањето %1 не е контракција (најголема сингуларна вредност %2, спектрален радиус %3). Смалете го или исклучете го.</translation>
    </message>
    <message>
        <source>No attractor: the maps %1, applied one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Нема атрактор: пресликувањата %1, едно по друго, не се контракција (најголема сингуларна вредност %2, спектрален радиус %3). Смалете некое од нив или исклучете го.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor: map %1 stretches by up to %2. Points that escape are left out.</source>
        <translation>Не е утврдено дали овој систем има атрактор: пресликувањето %1 растегнува %2 пати. Точките што бегаат се изоставени.</translation>
    </message>
    <message>
        <source>It is undecided whether this system has an attractor. Points that escape are left out.</source>
        <translation>Не е утврдено дали овој систем има атрактор. Точките што бегаат се изоставени.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept unchanged in the file.</source>
        <translation>Овој запис не можеше да се прочита. Неговиот текст е задржан како што е во датотеката.</translation>
    </message>
    <message>
        <source>No map is active, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Ниедно пресликување не е активно, па нема што да се црта. Додајте пресликување или вклучете некое.</translation>
    </message>
    <message>
        <source>This is the limit of numerical precision: zoom out a little for an accurate picture.</source>
        <translation>Подлабоко од ова аритметиката не стигнува: намалете го малку приказот за верна слика.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than requested: more would exceed the memory limit.</source>
        <translation>Нацртано со помалку итерации од бараните: за повеќе би требало повеќе меморија од дозволената.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a corner to open it: nothing is lost.</source>
        <translation>Кафезот е сплескан, па и сликата. Повлечете некое теме за да го раширите: ништо не се губи.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Запрено: понатаму пресликувањето %1 не би контрахирало (најголема сингуларна вредност %2, спектрален радиус %3) и не би имало атрактор.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, the maps %1, applied one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Запрено: понатаму пресликувањата %1, едно по друго, не би контрахирале (најголема сингуларна вредност %2, спектрален радиус %3) и не би имало атрактор.</translation>
    </message>
    <message>
        <source>Stopped: beyond this, an attractor is not guaranteed (map %1 has the largest singular value, %2).</source>
        <translation>Запрено: натаму не е загарантиран атрактор (пресликувањето %1 има најголема сингуларна вредност, %2).</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point is left.</source>
        <translation>Само едно пресликување: останува единствено неговата неподвижна точка.</translation>
    </message>
    <message>
        <source>With a single map, only its fixed point (%1, %2) is left.</source>
        <translation>Само едно пресликување: останува единствено неговата неподвижна точка (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is switched on has a positive weight, so there is nothing to draw. Give one of them a weight.</source>
        <translation>Ниедно вклучено пресликување нема тежина поголема од 0, па нема што да се црта. Дајте му тежина на некое.</translation>
    </message>
    <message>
        <source>Whether this system has an attractor is undecided.</source>
        <translation>Не е решено дали овој систем има атрактор.</translation>
    </message>
    <message>
        <source>This system has no attractor, so the picture may be incomplete or empty.</source>
        <translation>Овој систем нема атрактор, па сликата може да биде нецелосна или празна.</translation>
    </message>
    <message>
        <source>So many pieces overlap that parts of this solid may be missing. The look Cloud shows all of it.</source>
        <translation>Толку многу делови лежат еден врз друг што може да недостигаат парчиња од ова тело. Изгледот „Облак“ го покажува целото.</translation>
    </message>
    <message>
        <source>What lies far behind this small view may be drawn in the wrong order. Zoom out a little for an accurate picture.</source>
        <translation>Она што е далеку зад овој мал приказ може да биде нацртано по погрешен редослед. Намалете го малку приказот за верна слика.</translation>
    </message>
    <message>
        <source>Nothing here. Press %1 to see the whole picture.</source>
        <translation>Тука нема ништо. Притиснете %1 за да ја видите целата слика.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation>Поместувањето на кафезот го менува кодот</translation>
    </message>
</context>
<context>
    <name>view::CanvasInput</name>
    <message>
        <source>Cylinder %1</source>
        <translation>Цилиндар %1</translation>
    </message>
    <message>
        <source>Corner outside the view: click to fit the picture and its cage</source>
        <translation>Теме надвор од погледот: кликнете за да се соберат сликата и кафезот</translation>
    </message>
</context>
<context>
    <name>view::CanvasMenu</name>
    <message>
        <source>Vertex %1</source>
        <translation>Теме %1</translation>
    </message>
    <message>
        <source>&amp;Coordinates…</source>
        <translation>&amp;Координати…</translation>
    </message>
    <message>
        <source>Lets you type the coordinates of this vertex</source>
        <translation>Го внесува местото на ова теме со броеви</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>&amp;Врати го темето во мирување</translation>
    </message>
    <message>
        <source>Returns this vertex to its position at rest</source>
        <translation>Го враќа ова теме во мирување</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid Point (%1, %2)</source>
        <translation>Прилепи кон точката (%1, %2) од &amp;мрежата</translation>
    </message>
    <message>
        <source>Moves this vertex to the nearest point of the grid</source>
        <translation>Го поместува ова теме во најблиската точка од мрежата</translation>
    </message>
    <message>
        <source>Snap to the &amp;x Axis</source>
        <translation>Прилепи кон x-&amp;оската</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the x axis</source>
        <translation>Го поместува ова теме право на x-оската</translation>
    </message>
    <message>
        <source>Snap to the &amp;y Axis</source>
        <translation>Прилепи кон y-о&amp;ската</translation>
    </message>
    <message>
        <source>Moves this vertex straight to the y axis</source>
        <translation>Го поместува ова теме право на y-оската</translation>
    </message>
    <message>
        <source>&amp;Delete This Vertex</source>
        <translation>&amp;Избриши го темето</translation>
    </message>
    <message>
        <source>Removes this vertex from the cage</source>
        <translation>Го вади ова теме од кафезот</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>Премести го с&amp;тожерот тука</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about this vertex</source>
        <translation>Кафезот се врти и скалира околу ова теме</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Страна</translation>
    </message>
    <message>
        <source>&amp;Insert a Vertex Here</source>
        <translation>Додај &amp;теме тука</translation>
    </message>
    <message>
        <source>Inserts a vertex on this edge; double-clicking does the same</source>
        <translation>Става уште едно теме на оваа страна; истото го прави и двојното кликање</translation>
    </message>
    <message>
        <source>Rotate: hold Shift for steps of 15°</source>
        <translation>Ротирање: Shift врти во чекори од 15°</translation>
    </message>
    <message>
        <source>Scale: hold Shift for x or y only</source>
        <translation>Скалирање: Shift останува на x или y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Стожер</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Centre</source>
        <translation>Премести го стожерот во с&amp;редината</translation>
    </message>
    <message>
        <source>Rotates and scales the cage about its centre</source>
        <translation>Кафезот се врти и скалира околу својата средина</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Кафез</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Опфати со минимален каноничен &amp;симплекс</translation>
    </message>
    <message>
        <source>Fits the smallest isosceles right triangle with legs parallel to the axes around the picture</source>
        <translation>Го поставува околу сликата најмалиот рамнокрак правоаголен триаголник со катети паралелни на оските</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Дефинирај триаголник</translation>
    </message>
    <message>
        <source>Defines the triangle with three clicks; the picture stays</source>
        <translation>Ја држи сликата со три точки избрани со кликање</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>Врати го ка&amp;фезот во мирување</translation>
    </message>
    <message>
        <source>Returns every vertex to its position at rest</source>
        <translation>Ги враќа сите темиња во мирување</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>&amp;Направи го правилен</translation>
    </message>
    <message>
        <source>Moves the vertices to the nearest regular polygon</source>
        <translation>Ги става темињата на правилниот многуаголник што им е најблизок</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw the picture as shown, with the cage at rest</source>
        <translation>Ги менува пресликувањата така што го цртаат прикажаното, со кафезот во мирување</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Приказ</translation>
    </message>
    <message>
        <source>&amp;Fit	F</source>
        <translation>Вк&amp;лопи	F</translation>
    </message>
    <message>
        <source>Shows the whole picture and its cage</source>
        <translation>Ја прикажува целата слика и нејзиниот кафез</translation>
    </message>
    <message>
        <source>&amp;100 %	1</source>
        <translation>&amp;100 %	1</translation>
    </message>
    <message>
        <source>Shows one unit of the plane as one hundred pixels</source>
        <translation>Ја прикажува единицата во рамнината како сто пиксели</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Мрежа</translation>
    </message>
    <message>
        <source>Shows or hides the grid</source>
        <translation>Ја прикажува или скрива мрежата</translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation>&amp;Оски</translation>
    </message>
    <message>
        <source>Shows or hides the axes and their numbers</source>
        <translation>Ги прикажува или скрива оските и броевите на нив</translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation>y-оската надол&amp;у</translation>
    </message>
    <message>
        <source>Points the y axis down, as in window coordinates</source>
        <translation>Ја насочува y-оската надолу, како во координатите на прозорец</translation>
    </message>
    <message>
        <source>&amp;Only the Picture	H</source>
        <translation>С&amp;амо сликата	H</translation>
    </message>
    <message>
        <source>Hides the cage, the grid and the axes</source>
        <translation>Ги скрива кафезот, мрежата и оските</translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation>Ко&amp;пирај ја сликата</translation>
    </message>
    <message>
        <source>Copies the picture as shown, without the cage</source>
        <translation>Ја копира сликата како што се гледа, без кафезот</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>Платно</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>&amp;Switch On</source>
        <translation>&amp;Вклучи</translation>
    </message>
    <message>
        <source>&amp;Switch Off</source>
        <translation>&amp;Исклучи</translation>
    </message>
    <message>
        <source>Switches this map on or off</source>
        <translation>Ова пресликување да учествува или не</translation>
    </message>
    <message>
        <source>Switch on map %1</source>
        <translation>Вклучи го пресликувањето %1</translation>
    </message>
    <message>
        <source>Switch off map %1</source>
        <translation>Исклучи го пресликувањето %1</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Удвои</translation>
    </message>
    <message>
        <source>Adds a copy of this map</source>
        <translation>Става копија на ова пресликување до него</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Removes this map from the system</source>
        <translation>Го вади ова пресликување од системот</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>&amp;Отклучи</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Заклучи</translation>
    </message>
    <message>
        <source>Lets this map be edited again</source>
        <translation>Овозможува повторно менување на ова пресликување</translation>
    </message>
    <message>
        <source>Locks this map against editing</source>
        <translation>Го заштитува ова пресликување од измени</translation>
    </message>
    <message>
        <source>&amp;Reset Rotation</source>
        <translation>Поништи го &amp;вртењето</translation>
    </message>
    <message>
        <source>Returns the view to upright</source>
        <translation>Го исправа погледот</translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation>&amp;Впиши во кодот</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Платно</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab moves from handle to handle, the arrow keys move the handle in focus, F6 leaves the canvas.</source>
        <translation>Атракторот и неговиот контролен кафез. Tab оди од рачка на рачка, стрелките ја поместуваат онаа што е во фокус, F6 го напушта платното.</translation>
    </message>
    <message>
        <source>Define triangle</source>
        <translation>Дефинирање на триаголник</translation>
    </message>
    <message>
        <source>The cage is flat, so new vertices cannot be related to the picture.</source>
        <translation>Кафезот е сплескан, па новите темиња не можат да се поврзат со сликата.</translation>
    </message>
    <message>
        <source>Reset the cage first?</source>
        <translation>Прво да се врати кафезот во мирување?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Врати го кафезот во мирување</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press %1 to see the cage again.</source>
        <translation>Се прикажува само сликата. Притиснете %1 за повторно да го видите кафезот.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; hold Ctrl to rotate, Alt to scale, Shift to keep directions. The wheel zooms at the pointer, the middle button pans. Tab moves from handle to handle, the arrow keys move the handle, F6 leaves the canvas.</source>
        <translation>Сликата и нејзиниот кафез. Влечете теме, страна или внатрешноста на кафезот; Ctrl ротира, Alt скалира, Shift ги задржува правците. Тркалцето зумира кај покажувачот, средното копче ја поместува рамнината. Tab оди од рачка на рачка, стрелките ја поместуваат избраната, F6 го напушта платното.</translation>
    </message>
</context>
<context>
    <name>view::ClusterQueue</name>
    <message>
        <source>%1 running</source>
        <translation>%1 се извршуваат</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 чекаат</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 неуспешни</translation>
    </message>
    <message>
        <source>Drawing: %1.</source>
        <translation>Цртање: %1.</translation>
    </message>
    <message>
        <source>Video: done.</source>
        <translation>Видео: готово.</translation>
    </message>
    <message>
        <source>Video: failed.</source>
        <translation>Видео: неуспешно.</translation>
    </message>
    <message>
        <source>Video: running.</source>
        <translation>Видео: се изработува.</translation>
    </message>
    <message>
        <source>Video: waiting.</source>
        <translation>Видео: чека.</translation>
    </message>
    <message>
        <source>Submitting…</source>
        <translation>Се поднесува…</translation>
    </message>
    <message>
        <source>The script ended without submitting anything.</source>
        <translation>Скриптата заврши без да поднесе ништо.</translation>
    </message>
    <message>
        <source>The result is in %1.</source>
        <translation>Резултатот е во %1.</translation>
    </message>
    <message>
        <source>The reason is in the logs in %1.</source>
        <translation>Причината е во дневниците во %1.</translation>
    </message>
    <message>
        <source>Slurm did not accept the job: %1</source>
        <translation>Slurm не ја прифати задачата: %1</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>готови %1 од %2</translation>
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
        <translation>Покриеност</translation>
    </message>
    <message>
        <source>The part of the target that is covered</source>
        <translation>Делот од целта што е покриен</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Вишок</translation>
    </message>
    <message>
        <source>Overlap (IoU)</source>
        <translation>Преклоп (IoU)</translation>
    </message>
    <message>
        <source>Mean distance</source>
        <translation>Средно растојание</translation>
    </message>
    <message>
        <source>95 % within</source>
        <translation>95 % до</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Најголемо растојание</translation>
    </message>
    <message>
        <source>The Hausdorff distance; the mark on the canvas shows where it is</source>
        <translation>Хаусдорфовото растојание; ознаката на платното покажува каде е</translation>
    </message>
    <message>
        <source>%1 (s = %2)</source>
        <translation>%1 (s = %2)</translation>
    </message>
    <message>
        <source>none: a map stretches by %1</source>
        <translation>нема: едно пресликување растегнува за %1</translation>
    </message>
    <message>
        <source>No point of the target is farther from the attractor than this, and no point of the attractor from the target. The value is larger during a drag, when a coarser picture is measured</source>
        <translation>Ниедна точка од целта не е подалеку од атракторот, ниту обратно. Поголема е додека влечете, бидејќи се мери погруба слика</translation>
    </message>
    <message>
        <source>%1 (ellipsoidal norm, γ = %2)</source>
        <translation>%1 (елипсоидна норма, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (polytope norm, γ = %2)</source>
        <translation>%1 (политопска норма, γ = %2)</translation>
    </message>
    <message>
        <source>%1 (any %2 maps in a row contract, γ = %3)</source>
        <translation>%1 (кои било %2 последователни пресликувања контрахираат, γ = %3)</translation>
    </message>
    <message>
        <source>The area covered outside the target, relative to the area of the target</source>
        <translation>Покриената плоштина надвор од целта, како дел од плоштината на целта</translation>
    </message>
    <message>
        <source>The area that both cover, relative to the area that either covers</source>
        <translation>Плоштината што ја покриваат и двете, како дел од плоштината што ја покрива барем едно</translation>
    </message>
    <message>
        <source>How often the images of the maps cover the same places: their areas together, divided by the area that they cover. It is 1 where no two of them overlap</source>
        <translation>Колку пати сликите на пресликувањата ги покриваат истите места: збирот на нивните плоштини поделен со плоштината што ја покриваат. Тој е 1 ако нема две што се преклопуваат</translation>
    </message>
    <message>
        <source>95 % of all points are within this distance of the other shape</source>
        <translation>95 % од сите точки се најмногу на ова растојание од другата форма</translation>
    </message>
    <message>
        <source>From each point to the nearest point of the other shape, in pixels of the picture as it is traced</source>
        <translation>Од секоја точка до најблиската точка на другата форма, во пиксели на сликата како што се исцртува</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нема</translation>
    </message>
    <message>
        <source>Mean distance of the collage: %1 → %2.</source>
        <translation>Средно растојание на колажот: %1 → %2.</translation>
    </message>
    <message>
        <source>Mean distance of the attractor: %1 → %2.</source>
        <translation>Средно растојание на атракторот: %1 → %2.</translation>
    </message>
    <message>
        <source>Guarantee: %1 → %2.</source>
        <translation>Гаранција: %1 → %2.</translation>
    </message>
    <message>
        <source>The distance has increased, but the overlap (IoU) has improved.</source>
        <translation>Растојанието се зголеми, но преклопот (IoU) се подобри.</translation>
    </message>
    <message>
        <source>Nothing is guaranteed any more.</source>
        <translation>Веќе ништо не е гарантирано.</translation>
    </message>
    <message>
        <source>The guarantee is now weaker.</source>
        <translation>Гаранцијата сега е послаба.</translation>
    </message>
    <message>
        <source>Overlap of the maps</source>
        <translation>Преклоп на пресликувањата</translation>
    </message>
    <message>
        <source>Guaranteed within</source>
        <translation>Гарантирано во рамки од</translation>
    </message>
</context>
<context>
    <name>view::CollagePanel</name>
    <message>
        <source>Use Suggestion</source>
        <translation>Користи предлог</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Дотерај ги пресликувањата</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Дотерај го атракторот</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Прилагоди ги тежините</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Прилагоди го кафезот</translation>
    </message>
    <message>
        <source>Add Map</source>
        <translation>Додај пресликување</translation>
    </message>
    <message>
        <source>Collage</source>
        <translation>Колаж</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Согласност</translation>
    </message>
    <message>
        <source>of the collage</source>
        <translation>на колажот</translation>
    </message>
    <message>
        <source>of the attractor</source>
        <translation>на атракторот</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>не се прикажува</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Прилагодување</translation>
    </message>
    <message>
        <source>The maps do not contract, so there is no attractor to compare.</source>
        <translation>Пресликувањата не собираат, па нема атрактор за споредба.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Нема доволно меморија за ова.</translation>
    </message>
    <message numerus="yes">
        <source>%n suggestions. Click one to use it.</source>
        <translation>
            <numerusform>%n предлог. Кликнете на него за да го користите.</numerusform>
            <numerusform>%n предлози. Кликнете на еден за да го користите.</numerusform>
            <numerusform>%n предлози. Кликнете на еден за да го користите.</numerusform>
        </translation>
    </message>
    <message>
        <source>The fractal has changed meanwhile, so the result was not used.</source>
        <translation>Фракталот во меѓувреме се промени, па резултатот не е искористен.</translation>
    </message>
    <message>
        <source>No better agreement was found.</source>
        <translation>Не е најдено ништо што подобро се согласува.</translation>
    </message>
    <message>
        <source>Guarantee for the shades</source>
        <translation>Гаранција за нијансите</translation>
    </message>
    <message>
        <source>Moved by at most this distance on average, the shades of the attractor become those of the picture</source>
        <translation>Поместени во просек најмногу за ова растојание, нијансите на атракторот стануваат нијанси на сликата</translation>
    </message>
    <message>
        <source>On average, the shades of the attractor are guaranteed to lie within %1 px of those of the picture.</source>
        <translation>Гарантирано е дека нијансите на атракторот во просек се на најмногу %1 px од оние на сликата.</translation>
    </message>
    <message>
        <source>With these weights, the maps do not contract on average, so nothing is guaranteed for the shades.</source>
        <translation>Со овие тежини, пресликувањата во просек не собираат, па за нијансите ништо не е гарантирано.</translation>
    </message>
    <message>
        <source>Choose what the canvas compares with the target</source>
        <translation>Избери што споредува платното со целта</translation>
    </message>
    <message>
        <source>Compares the target with its images under the maps, or with the attractor. Agreement is grey, excess red, and missing parts blue.</source>
        <translation>Ја споредува целта со нејзините слики под пресликувањата, или со атракторот. Заедничкото е сиво, вишокот црвен, недостигот син.</translation>
    </message>
    <message>
        <source>Result of refining</source>
        <translation>Резултат од дотерувањето</translation>
    </message>
    <message>
        <source>What the last refinement has made of the distance and of the guarantee</source>
        <translation>Што направи последното дотерување со растојанието и со гаранцијата</translation>
    </message>
    <message>
        <source>1. Choose a picture</source>
        <translation>1. Изберете слика</translation>
    </message>
    <message>
        <source>2. Ask for suggestions</source>
        <translation>2. Побарајте предлози</translation>
    </message>
    <message>
        <source>3. Pick one</source>
        <translation>3. Изберете еден</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Повеќе</translation>
    </message>
    <message>
        <source>More ways to trace</source>
        <translation>Други начини на прецртување</translation>
    </message>
    <message>
        <source>Show how the picture is read, the agreement, and what refines a suggestion</source>
        <translation>Прикажува како се чита сликата, совпаѓањето и она што го доусовршува предлогот</translation>
    </message>
    <message>
        <source>Another picture is shown, so the search for the last one was cancelled.</source>
        <translation>Прикажана е друга слика, па пребарувањето за претходната е откажано.</translation>
    </message>
</context>
<context>
    <name>view::CollectionGrid</name>
    <message>
        <source>Fractals of the collection</source>
        <translation>Фрактали од збирката</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Нема резултати</translation>
    </message>
    <message>
        <source>No favourites yet. Select a fractal and press Ctrl+D.</source>
        <translation>Сѐ уште нема омилени. Изберете фрактал и притиснете Ctrl+D.</translation>
    </message>
    <message>
        <source>Fractals that you use appear here.</source>
        <translation>Фракталите што ги користите се појавуваат тука.</translation>
    </message>
</context>
<context>
    <name>view::CollectionModel</name>
    <message>
        <source>Theme: %1</source>
        <translation>Тема: %1</translation>
    </message>
    <message>
        <source>%1, from %2, a favourite</source>
        <translation>%1, од %2, омилен</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, од %2</translation>
    </message>
    <message>
        <source>solid 3D space</source>
        <comment>words of a search</comment>
        <translation>тело 3D простор</translation>
    </message>
    <message>
        <source>moving animation motion</source>
        <comment>words of a search</comment>
        <translation>движење анимација</translation>
    </message>
</context>
<context>
    <name>view::CollectionPanel</name>
    <message>
        <source>Collection</source>
        <translation>Збирка</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Пребарај ја збирката</translation>
    </message>
    <message>
        <source>Show only fractals whose name, title, theme or source contains these words.</source>
        <translation>Прикажи ги само фракталите чие име, наслов, тема или извор ги содржи овие зборови.</translation>
    </message>
    <message>
        <source>Open the selected fractal as a separate document.</source>
        <translation>Отвори го избраниот фрактал како посебен документ.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>&amp;Додај во оваа датотека</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Додај го избраниот фрактал во отворената датотека.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>О&amp;милен</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites.</source>
        <translation>Означи го избраниот фрактал како омилен.</translation>
    </message>
    <message>
        <source>Fa&amp;vourites Only</source>
        <translation>Само омил&amp;ени</translation>
    </message>
    <message>
        <source>Show only your favourites.</source>
        <translation>Прикажи ги само омилените.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>Додај &amp;папка…</translation>
    </message>
    <message>
        <source>Add the .ifs files of one of your own folders to this list.</source>
        <translation>Прикажи ги тука и .ifs-датотеките од Ваша папка.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>О&amp;тстрани ја папката „%1“</translation>
    </message>
    <message>
        <source>Remove this folder from the list. Its files are not changed.</source>
        <translation>Тргни ја оваа папка од листата. Нејзините датотеки не се менуваат.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Папка со .ifs-датотеки</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>Ги прикажува само фракталите чие име, тема или коментар ги содржи овие зборови. Enter го отвора првиот од нив.</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it in this window; right-click it to add it to the file instead.</source>
        <translation>Фрактали за почеток. Двојно кликање или Enter го отвора фракталот во овој прозорец; менито на десното копче го додава во датотеката.</translation>
    </message>
    <message>
        <source>Progress of reading the collection</source>
        <translation>Прочитани датотеки од збирката</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Запри со читање</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Се чита збирката…</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Користи</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Додај го избраниот фрактал во отворената датотека или отвори го ако сè уште ништо не е изменето.</translation>
    </message>
    <message>
        <source>&amp;Open as New Document</source>
        <translation>&amp;Отвори како нов документ</translation>
    </message>
    <message>
        <source>Stop reading this folder; files that were already read stay in the list</source>
        <translation>Запри со читање на оваа папка; прочитаното останува во списокот</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Прелистај…</translation>
    </message>
    <message>
        <source>Show the collection over the whole window, in large pictures.</source>
        <translation>Прикажи ја збирката преку целиот прозорец, со големи слики.</translation>
    </message>
    <message>
        <source>&amp;Recent Only</source>
        <translation>Само &amp;неодамнешни</translation>
    </message>
    <message>
        <source>Show only the fractals that you used last.</source>
        <translation>Прикажи ги само последно користените фрактали.</translation>
    </message>
</context>
<context>
    <name>view::CollectionWindow</name>
    <message>
        <source>Collection</source>
        <translation>Збирка</translation>
    </message>
    <message>
        <source>Ready-made fractals. Double-click one or press Enter to open it. Those with a triangle in the corner move under the pointer.</source>
        <translation>Готови фрактали. Двоен клик или Enter отвора еден. Оние со триаголник во аголот се движат под покажувачот.</translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation>Пребарај ја збирката</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment contains these words. Enter opens the first of them.</source>
        <translation>Ги прикажува само фракталите чие име, тема или коментар ги содржи овие зборови. Enter го отвора првиот од нив.</translation>
    </message>
    <message>
        <source>Themes</source>
        <translation>Теми</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Омилена</translation>
    </message>
    <message>
        <source>Add the selected fractal to your favourites (Ctrl+D)</source>
        <translation>Додади го избраниот фрактал во омилените (Ctrl+D)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Отвори</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file, or open it if you have not edited anything.</source>
        <translation>Додај го избраниот фрактал во отворената датотека или отвори го ако сè уште ништо не е изменето.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>&amp;Додај во оваа датотека</translation>
    </message>
    <message>
        <source>Add the selected fractal to the open file.</source>
        <translation>Додај го избраниот фрактал во отворената датотека.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Сите</translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Омилени</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Неодамнешни</translation>
    </message>
    <message>
        <source>Double-click a fractal to open it.</source>
        <translation>Кликнете двапати на фрактал за да го отворите.</translation>
    </message>
</context>
<context>
    <name>view::ColourButton</name>
    <message>
        <source>transparent</source>
        <translation>проѕирна</translation>
    </message>
    <message>
        <source>%1, %2 % opaque</source>
        <translation>%1, %2 % непроѕирна</translation>
    </message>
    <message>
        <source>Click to choose another colour.</source>
        <translation>Кликнете за да изберете друга боја.</translation>
    </message>
</context>
<context>
    <name>view::ColumnOrders</name>
    <message>
        <source>a b c d e f p: Fractint, Barnsley</source>
        <translation>a b c d e f p: Fractint, Барнсли</translation>
    </message>
    <message>
        <source>a b e c d f p: one equation after the other</source>
        <translation>a b e c d f p: секоја равенка во една редица</translation>
    </message>
    <message>
        <source>a c b d e f p: column by column</source>
        <translation>a c b d e f p: колона по колона</translation>
    </message>
    <message>
        <source>p a b c d e f: the weight first</source>
        <translation>p a b c d e f: прво тежината</translation>
    </message>
    <message>
        <source>r s theta phi e f p: scales, and angles in degrees</source>
        <translation>r s theta phi e f p: размери, и агли во степени</translation>
    </message>
    <message>
        <source>a b c d e f, and cumulative weights</source>
        <translation>a b c d e f, и тежини што се собираат редица по редица</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Друго…</translation>
    </message>
    <message>
        <source>Order of the columns</source>
        <translation>Редослед на колоните</translation>
    </message>
    <message>
        <source>Column names in order</source>
        <translation>Имињата на колоните по ред</translation>
    </message>
    <message>
        <source>The names of the columns in order: a b c d or r s theta phi, then e and f, each once; if there are weights, also p, or cumulative for running sums of weights. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Имињата на колоните по ред: a b c d или r s theta phi, потоа e и f, секое еднаш, и p за тежина или cumulative за збир на тежини каде што го има. x′ = a·x + b·y + e и y′ = c·x + d·y + f.</translation>
    </message>
    <message>
        <source>The names of the columns in their order, such as a b c d e f p</source>
        <translation>Имињата на колоните по ред, на пример a b c d e f p</translation>
    </message>
</context>
<context>
    <name>view::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Пребарување наредби</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Напишете што сакате да направите</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Наредба</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>Најдени наредби</translation>
    </message>
    <message>
        <source>Type some letters of what you want to do. The arrow keys select a command, Enter runs it.</source>
        <translation>Напишете неколку букви од она што сакате да го направите. Стрелките избираат, Enter извршува.</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>Нема соодветни команди</translation>
    </message>
    <message>
        <source>Commands whose names contain these words come first, then those whose descriptions do.</source>
        <translation>Наредбите чии имиња ги содржат овие зборови, а потоа оние чии описи ги содржат.</translation>
    </message>
    <message>
        <source>Search the guide for “%1”</source>
        <translation>Побарај „%1“ во водичот</translation>
    </message>
</context>
<context>
    <name>view::CommandSynonyms</name>
    <message>
        <source>render save image picture png svg pdf jpeg tiff webp exr poster wallpaper stl obj ply glb mesh print 3d laser plotter cutter engrave dxf outline vector transparent millimetres</source>
        <translation>рендер зачувај слика png svg pdf jpeg tiff постер плакат позадина stl obj ply мрежа 3d печатење ласер плотер секач гравирај dxf контура вектор проѕирно милиметри</translation>
    </message>
    <message>
        <source>render video movie film mp4 webm gif apng frames cluster slurm</source>
        <translation>рендер видео филм mp4 webm gif apng кадри кластер slurm</translation>
    </message>
    <message>
        <source>flame apophysis csv table points cloud ply ifstile save</source>
        <translation>flame apophysis csv табела точки облак ply ifstile зачувај</translation>
    </message>
    <message>
        <source>clipboard screenshot image</source>
        <translation>клипборд исечок слика од екран</translation>
    </message>
    <message>
        <source>paper printer pdf page</source>
        <translation>хартија печатач pdf страница</translation>
    </message>
    <message>
        <source>surprise chance lucky generate dice new</source>
        <translation>изненадување случајност создај коцка нов</translation>
    </message>
    <message>
        <source>mirror reflect reverse</source>
        <translation>огледало пресликај преврти</translation>
    </message>
    <message>
        <source>mirror reflect upside down</source>
        <translation>огледало пресликај преврти наопаку</translation>
    </message>
    <message>
        <source>hull triangle tight smallest</source>
        <translation>обвивка триаголник најмал</translation>
    </message>
    <message>
        <source>apply freeze write flatten</source>
        <translation>примени замрзни запиши</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>копирај клонирај</translation>
    </message>
    <message>
        <source>centre home whole zoom all</source>
        <translation>центрирај сè цело</translation>
    </message>
    <message>
        <source>maximise whole</source>
        <translation>целосно зголеми</translation>
    </message>
    <message>
        <source>3d extrude solid</source>
        <translation>3d тело истегни</translation>
    </message>
    <message>
        <source>settings options language theme dark light configuration motion</source>
        <translation>поставки опции јазик тема темно светло движење</translation>
    </message>
    <message>
        <source>shortcuts keys hotkeys gestures</source>
        <translation>кратенки копчиња гестови</translation>
    </message>
    <message>
        <source>help manual documentation</source>
        <translation>помош прирачник документација</translation>
    </message>
    <message>
        <source>tutorial introduction beginner learn</source>
        <translation>вовед почетник учење туторијал</translation>
    </message>
    <message>
        <source>sway wind storm blow</source>
        <translation>нишање ветре бура дува</translation>
    </message>
    <message>
        <source>turntable spin rotate camera</source>
        <translation>вртење кружи камера ротирај</translation>
    </message>
    <message>
        <source>spin rotate</source>
        <translation>врти ротирај</translation>
    </message>
    <message>
        <source>pulse grow shrink</source>
        <translation>пулсирај расте се собира</translation>
    </message>
    <message>
        <source>colours rainbow</source>
        <translation>бои виножито</translation>
    </message>
    <message>
        <source>infinite dive</source>
        <translation>бесконечно зумирање нурни</translation>
    </message>
    <message>
        <source>mutate mutation vary breed evolve grow similar</source>
        <translation>мутирај мутација варирај одгледувај развивај слично</translation>
    </message>
    <message>
        <source>shade silhouette drop cast ground light sun</source>
        <translation>силуета под светлина сонце</translation>
    </message>
    <message>
        <source>share send email mail post message url</source>
        <translation>сподели испрати пошта имејл порака url</translation>
    </message>
    <message>
        <source>dimension proof certificate | prove certified Hausdorff area measure overlap connected</source>
        <translation>димензија доказ сертификат | докажи Хаусдорф плоштина мера преклопување поврзано</translation>
    </message>
    <message>
        <source>reorder rearrange order sort</source>
        <translation>прередување редослед подреди сортирај</translation>
    </message>
    <message>
        <source>gallery examples library favourites leaf tree fern snowflake dragon sponge</source>
        <translation>галерија примери библиотека омилени лист дрво папрат снегулка змеј сунѓер</translation>
    </message>
    <message>
        <source>linked maps graph-directed which follows which forbidden</source>
        <translation>поврзани пресликувања граф забрането</translation>
    </message>
    <message>
        <source>colours palette gradient hue background transparent brightness contrast black white grey</source>
        <translation>бои палета прелив нијанса позадина проѕирно осветленост контраст црно бело сиво</translation>
    </message>
    <message>
        <source>flip mirror reflect | rotate scale shear move shift turn size resize bigger larger smaller</source>
        <translation>преврти огледало пресликај | ротирај заврти размер искоси помести големина поголем помал</translation>
    </message>
    <message>
        <source>timeline motion movie keyframes speed faster slower morph</source>
        <translation>временска линија движење филм клучни кадри брзина побрзо побавно морфирање преобразба</translation>
    </message>
    <message>
        <source>share send browser html embed publish interactive mail email</source>
        <translation>сподели испрати прелистувач html вгради објави интерактивно е-пошта</translation>
    </message>
    <message>
        <source>worksheet class students exercise paper teacher</source>
        <translation>работен лист час ученици вежба хартија наставник</translation>
    </message>
    <message>
        <source>undo original restore straighten start over again</source>
        <translation>почетно врати исправи одново</translation>
    </message>
</context>
<context>
    <name>view::ComparePane</name>
    <message>
        <source>Entry to compare with</source>
        <translation>Запис за споредба</translation>
    </message>
    <message>
        <source>Canvas of the entry to compare with</source>
        <translation>Платно на записот за споредба</translation>
    </message>
    <message>
        <source>There is no other entry in this file. Add or duplicate one to compare it.</source>
        <translation>Оваа датотека нема друг запис. Додајте или удвојте еден за споредба.</translation>
    </message>
    <message>
        <source>The entry that is shown beside the current one</source>
        <translation>Записот што се прикажува до тековниот</translation>
    </message>
    <message>
        <source>Link Views</source>
        <translation>Поврзи ги погледите</translation>
    </message>
    <message>
        <source>Pan and zoom both together, at the same position and scale</source>
        <translation>Помести и зголеми ги двете заедно, на исто место и во иста размера</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Show the current entry alone</source>
        <translation>Прикажи го само тековниот запис</translation>
    </message>
    <message>
        <source>An entry in the plane and one in space cannot share a view</source>
        <translation>Запис од рамнината и запис од просторот немаат заеднички поглед</translation>
    </message>
    <message>
        <source>Another entry of the file beside the current one, to compare the two.</source>
        <translation>Друга ставка од датотеката покрај тековната, за споредба.</translation>
    </message>
</context>
<context>
    <name>view::ConstructionBar</name>
    <message>
        <source>How the attractor is built</source>
        <translation>Како се гради атракторот</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Густина</translation>
    </message>
    <message>
        <source>The invariant measure, refined while nothing moves</source>
        <translation>Инваријантната мера, сѐ попрецизна додека ништо не се движи</translation>
    </message>
    <message>
        <source>Chaos Game</source>
        <translation>Игра на хаосот</translation>
    </message>
    <message>
        <source>One point that jumps by maps chosen at random; the first 14 points are not plotted</source>
        <translation>Една точка што скока според случајно извлечени пресликувања; првите 14 точки не се цртаат</translation>
    </message>
    <message>
        <source>n: how many times all maps are applied</source>
        <translation>n: колку пати се применуваат сите пресликувања</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Почни одново</translation>
    </message>
    <message>
        <source>Clear the points and start with new random numbers</source>
        <translation>Одново без ниедна точка, со други случајни броеви</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Пушти</translation>
    </message>
    <message>
        <source>Plot points continuously</source>
        <translation>Нека се појавуваат точки</translation>
    </message>
    <message>
        <source>W%1: the cage itself</source>
        <translation>W%1: самиот кафез</translation>
    </message>
    <message>
        <source>W%1: %2 copies of the cage</source>
        <translation>W%1: %2 копии од кафезот</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>Stop at these points</source>
        <translation>Застани кај овие точки</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 точки</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 точка</translation>
    </message>
    <message>
        <source>, the last by map %1</source>
        <translation>, последната според пресликувањето %1</translation>
    </message>
    <message>
        <source>no points yet: press Play (▶)</source>
        <translation>сѐ уште нема точки: притиснете „Пушти“ (▶)</translation>
    </message>
    <message>
        <source>How many times all maps are applied: 0 is the starting shape, and with every step the picture gets closer to the attractor. Each image has the colour of its outermost map.</source>
        <translation>Колку пати се применуваат сите пресликувања: 0 е почетната фигура, а со секој чекор сликата се приближува кон атракторот. Секоја копија ја има бојата на своето најнадворешно пресликување.</translation>
    </message>
    <message>
        <source>One Jump</source>
        <translation>Еден скок</translation>
    </message>
    <message>
        <source>Roll the die once and jump</source>
        <translation>Фрли ја коцката еднаш и скокни</translation>
    </message>
    <message>
        <source>Jumps per second</source>
        <translation>Скокови во секунда</translation>
    </message>
    <message>
        <source>How many jumps the chaos game makes per second. At up to ten per second, the die shows each map that is rolled.</source>
        <translation>Колку скокови прави играта на хаосот во секунда. До десет во секунда, коцката го покажува секое пресликување што паѓа.</translation>
    </message>
    <message>
        <source>W%1: the start</source>
        <translation>W%1: почетната фигура</translation>
    </message>
    <message>
        <source>W%1: %2 copies</source>
        <translation>W%1: %2 копии</translation>
    </message>
    <message>
        <source>The Hausdorff distance from the picture to the attractor A, and its upper bound</source>
        <translation>Хаусдорфовото растојание од сликата до атракторот A, и она што не може да го надмине</translation>
    </message>
    <message>
        <source>The Hausdorff distance from Wⁿ(B) to the attractor A, measured on cells of side %1. It is at most sⁿ times the distance from the start B to A, where s = %2 is the largest contraction factor of the maps.</source>
        <translation>Хаусдорфовото растојание од Wⁿ(B) до атракторот A, измерено на ќелии со страна %1. Тоа е најмногу sⁿ пати растојанието од почетната фигура B до A, каде што s = %2 е најголемиот коефициент на контракција на пресликувањата.</translation>
    </message>
    <message>
        <source>no bound: a map has the contraction factor %1</source>
        <translation>нема граница: едно пресликување има коефициент на контракција %1</translation>
    </message>
    <message>
        <source>distance to A at most %1</source>
        <translation>растојание до A најмногу %1</translation>
    </message>
    <message>
        <source>distance to A &lt; %1, at most %2</source>
        <translation>растојание до A &lt; %1, најмногу %2</translation>
    </message>
    <message>
        <source>distance to A ≈ %1, at most %2</source>
        <translation>растојание до A ≈ %1, најмногу %2</translation>
    </message>
    <message>
        <source>jump %1 of the %2 that are not plotted</source>
        <translation>скок %1 од првите %2 што не се цртаат</translation>
    </message>
    <message>
        <source>%1/s</source>
        <comment>jumps per second</comment>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>Step by Step</source>
        <translation>Чекори</translation>
    </message>
    <message>
        <source>All maps at once, applied n times to the cage or another shape (Wⁿ)</source>
        <translation>Сите пресликувања одеднаш, применети n пати врз кафезот или друга фигура (Wⁿ)</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three corners. The picture stays where it is; Esc cancels.</source>
        <translation>Кликнете на првото од трите темиња. Сликата останува каде што е; Esc откажува.</translation>
    </message>
    <message>
        <source>Click the second corner. Backspace removes the last point.</source>
        <translation>Кликнете на второто теме. Backspace ја брише последната точка.</translation>
    </message>
    <message>
        <source>Click the third corner. Backspace removes the last point.</source>
        <translation>Кликнете на третото теме. Backspace ја брише последната точка.</translation>
    </message>
</context>
<context>
    <name>view::Die</name>
    <message>
        <source>Die</source>
        <translation>Коцка</translation>
    </message>
    <message>
        <source>The die of the chaos game. It has a face for each map, as wide as the probability of the map. The face that was rolled is shown in the colour of its map, and so is the point that the map leads to. At more than ten jumps per second, the die rolls too fast to be read.</source>
        <translation>Коцката на играта на хаосот. Има по една страна за секое пресликување, широка колку неговата веројатност. Страната што паднала се прикажува во бојата на своето пресликување, исто како и точката до која тоа довело. При повеќе од десет скокови во секунда се тркала пребрзо за да се чита.</translation>
    </message>
    <message>
        <source>Each map has a face, as wide as its probability.</source>
        <translation>Секое пресликување има страна, широка колку неговата веројатност.</translation>
    </message>
    <message>
        <source>Map %1 was rolled; its probability is %2.</source>
        <translation>Падна пресликувањето %1, чија веројатност е %2.</translation>
    </message>
</context>
<context>
    <name>view::EaseDialog</name>
    <message>
        <source>Custom Ease</source>
        <translation>Сопствен премин</translation>
    </message>
    <message>
        <source>Curve: time to the right, progress upwards</source>
        <translation>Крива: времето надесно, патот нагоре</translation>
    </message>
    <message>
        <source>How the motion to the next key progresses over time. Drag the two handles.</source>
        <translation>Како се поминува патот до следниот клуч во времето. Влечете ги двете рачки.</translation>
    </message>
    <message>
        <source>Time of the first handle</source>
        <translation>Време на првата рачка</translation>
    </message>
    <message>
        <source>Progress of the first handle</source>
        <translation>Пат на првата рачка</translation>
    </message>
    <message>
        <source>Time of the second handle</source>
        <translation>Време на втората рачка</translation>
    </message>
    <message>
        <source>Progress of the second handle</source>
        <translation>Пат на втората рачка</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Време</translation>
    </message>
    <message>
        <source>First handle:</source>
        <translation>Прва рачка:</translation>
    </message>
    <message>
        <source>Second handle:</source>
        <translation>Втора рачка:</translation>
    </message>
    <message>
        <source>A number from 0 to 1. A curve that would be too steep is flattened.</source>
        <translation>Дел од 0 до 1. Престрмна крива се израмнува.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Напредок</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Коментар на „%1“</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Наслов</translation>
    </message>
    <message>
        <source>Written on the first line of the entry, for example its title or author.</source>
        <translation>Се запишува во првиот ред на записот, на пример неговиот наслов или автор.</translation>
    </message>
    <message>
        <source>Comment lines</source>
        <translation>Редови на коментарот</translation>
    </message>
    <message>
        <source>Written on separate lines below the name, each after a semicolon.</source>
        <translation>Се запишуваат како посебни редови под името, секој по точка-запирка.</translation>
    </message>
    <message>
        <source>Reason why the comment cannot be kept</source>
        <translation>Причина зошто коментарот не може да се зачува</translation>
    </message>
    <message>
        <source>Keep or discard the comment</source>
        <translation>Зачувај го или отфрли го коментарот</translation>
    </message>
    <message>
        <source>&amp;Title:</source>
        <translation>&amp;Наслов:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Редови на коментарот:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines store the cage and the colours.</source>
        <translation>Коментарот не може да почнува со „barycage:“; таквите редови ги чуваат кафезот и боите.</translation>
    </message>
    <message>
        <source>A line can have at most %1 bytes; Fractint truncates longer ones. Split it in two.</source>
        <translation>Редот содржи најмногу %1 бајти; подолгите Fractint ги сече. Поделете го на два.</translation>
    </message>
    <message>
        <source>Comments are stored with the entry in the file and do not change the fractal.</source>
        <translation>Коментарите се чуваат со ставката во датотеката и не го менуваат фракталот.</translation>
    </message>
</context>
<context>
    <name>view::EntriesDelegate</name>
    <message>
        <source>Name of the entry</source>
        <translation>Име на записот</translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Преименување на „%1“ во „%2“</translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation>не можеше да се прочита</translation>
    </message>
    <message>
        <source>1 map</source>
        <translation>1 пресликување</translation>
    </message>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n пресликување</numerusform>
            <numerusform>%n пресликувања</numerusform>
            <numerusform>%n пресликувања</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, no attractor</source>
        <translation>%1, нема атрактор</translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation>Ред %1, колона %2: </translation>
    </message>
    <message>
        <source>modified</source>
        <translation>изменет</translation>
    </message>
    <message>
        <source>has errors</source>
        <translation>има грешки</translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation>има предупредувања</translation>
    </message>
    <message>
        <source>%1 in space</source>
        <translation>%1 во просторот</translation>
    </message>
    <message>
        <source>%1, placed</source>
        <translation>%1, поставен</translation>
    </message>
</context>
<context>
    <name>view::EntriesPanel</name>
    <message>
        <source>Entries of the file</source>
        <translation>Записи во датотеката</translation>
    </message>
    <message>
        <source>Filter entries by name</source>
        <translation>Филтрирај ги записите по име</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Филтрирај по име</translation>
    </message>
    <message>
        <source>Show only the entries whose name contains this text.</source>
        <translation>Прикажи ги само записите чие име го содржи овој текст.</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>This file contains no entries. Add one, or paste the text of an .ifs file.</source>
        <translation>Оваа датотека не содржи записи. Додајте запис или вметнете текст од .ifs-датотека.</translation>
    </message>
    <message>
        <source>&amp;Add Entry</source>
        <translation>&amp;Додај запис</translation>
    </message>
    <message>
        <source>Add a Sierpiński triangle as a new entry.</source>
        <translation>Додај триаголник на Серпињски како нов запис.</translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation>&amp;Удвои</translation>
    </message>
    <message>
        <source>Add a copy of each selected entry.</source>
        <translation>Додај копија од секој избран запис.</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Delete the selected entries from the file.</source>
        <translation>Избриши ги избраните записи од датотеката.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Преименувај</translation>
    </message>
    <message>
        <source>Give the entry another name.</source>
        <translation>Дај му друго име на записот.</translation>
    </message>
    <message>
        <source>Edit &amp;Comment…</source>
        <translation>Уреди &amp;коментар…</translation>
    </message>
    <message>
        <source>Edit the comment of the entry.</source>
        <translation>Уреди го коментарот на записот.</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Помести на&amp;горе</translation>
    </message>
    <message>
        <source>Move the selected entries towards the top of the file.</source>
        <translation>Помести ги избраните записи кон почетокот на датотеката.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Помести надо&amp;лу</translation>
    </message>
    <message>
        <source>Move the selected entries towards the end of the file.</source>
        <translation>Помести ги избраните записи кон крајот на датотеката.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Коп&amp;ирај</translation>
    </message>
    <message>
        <source>Copy the selected entries as .ifs text.</source>
        <translation>Копирај ги избраните записи како .ifs-текст.</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Вметни</translation>
    </message>
    <message>
        <source>Paste entries from .ifs text after the current entry.</source>
        <translation>Вметни ги записите од .ifs-текст по тековниот запис.</translation>
    </message>
    <message>
        <source>Add an entry</source>
        <translation>Додавање на запис</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Бришење на %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n entries</source>
        <translation>
            <numerusform>Бришење на %n запис</numerusform>
            <numerusform>Бришење на %n записи</numerusform>
            <numerusform>Бришење на %n записи</numerusform>
        </translation>
    </message>
    <message>
        <source>An entry that could not be read cannot be duplicated: the copy would have the same name.</source>
        <translation>Запис што не можеше да се прочита не може да се удвои: копијата би го задржала неговото име.</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Удвојување на %1</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n entries</source>
        <translation>
            <numerusform>Удвојување на %n запис</numerusform>
            <numerusform>Удвојување на %n записи</numerusform>
            <numerusform>Удвојување на %n записи</numerusform>
        </translation>
    </message>
    <message>
        <source>Edit the comment of %1</source>
        <translation>Уредување на коментарот на %1</translation>
    </message>
    <message>
        <source>The pasted text contains no entry of an .ifs file.</source>
        <translation>Во вметнатото нема запис од .ifs-датотека.</translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation>Вметнување на %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n entries</source>
        <translation>
            <numerusform>Вметнување на %n запис</numerusform>
            <numerusform>Вметнување на %n записи</numerusform>
            <numerusform>Вметнување на %n записи</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pasted entries could not be read; their text is kept unchanged.</source>
        <translation>
            <numerusform>%n вметнат запис не можеше да се прочита; неговиот текст е задржан како што е.</numerusform>
            <numerusform>%n вметнати записи не можеа да се прочитаат; нивниот текст е задржан како што е.</numerusform>
            <numerusform>%n вметнати записи не можеа да се прочитаат; нивниот текст е задржан како што е.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Поместување на %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n entries</source>
        <translation>
            <numerusform>Поместување на %n запис</numerusform>
            <numerusform>Поместување на %n записи</numerusform>
            <numerusform>Поместување на %n записи</numerusform>
        </translation>
    </message>
    <message>
        <source>No entry name contains “%1”.</source>
        <translation>Ниеден запис нема „%1“ во името.</translation>
    </message>
    <message>
        <source>Shows only the entries whose names contain these letters.</source>
        <translation>Ги прикажува само записите чие име ги содржи овие букви.</translation>
    </message>
    <message>
        <source>The fractals in the file. Click one to edit it, drag it to move it, press F2 to rename it.</source>
        <translation>Фракталите во датотеката. Кликнете на некој за да го уредувате, повлечете го на друго место, притиснете F2 за да му дадете друго име.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>Ништо не е вметнато: нема текст на таблата со исечоци.</translation>
    </message>
    <message>
        <source>Reading the pasted text…</source>
        <translation>Се чита вметнатото…</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Се додаваат записи…</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>И&amp;сечи</translation>
    </message>
    <message>
        <source>Move the selected entries to the clipboard.</source>
        <translation>Ги преместува избраните записи во таблата со исечоци.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Сечење на %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n entries</source>
        <translation>
            <numerusform>Сечење на %n запис</numerusform>
            <numerusform>Сечење на %n записи</numerusform>
            <numerusform>Сечење на %n записи</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Извоз на податоци од „%1“</translation>
    </message>
    <message>
        <source>Preview of the file</source>
        <translation>Што ќе содржи датотеката</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>Копирај &amp;текст</translation>
    </message>
    <message>
        <source>Points (.csv)</source>
        <translation>Точки (.csv)</translation>
    </message>
    <message>
        <source>Points, coloured (.ply)</source>
        <translation>Точки, обоени (.ply)</translation>
    </message>
    <message>
        <source>Flip &amp;y so that the flame is the right way up</source>
        <translation>П&amp;реврти ја y-оската, за пламенот да стои исправено</translation>
    </message>
    <message>
        <source>&amp;Bake the placement so that the maps draw the picture as shown</source>
        <translation>&amp;Впиши ја поставеноста, за пресликувањата да го цртаат прикажаното</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Формат:</translation>
    </message>
    <message>
        <source>C&amp;olumns:</source>
        <translation>Ко&amp;лони:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>Т&amp;очки:</translation>
    </message>
    <message>
        <source>The points of the chaos game as shown, without the first 14.</source>
        <translation>Точките од играта на хаосот таму каде што се прикажани, без првите 14.</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Извоз на податоци</translation>
    </message>
    <message>
        <source>The text was copied to the clipboard.</source>
        <translation>Текстот е на таблата со исечоци.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>Почетокот на датотеката како што ќе биде запишана.</translation>
    </message>
    <message>
        <source>The program that will read the data; each format contains what that program understands.</source>
        <translation>За која програма се податоците: секој формат го содржи она што го чита таа програма.</translation>
    </message>
    <message>
        <source>The order of the coefficients in each row; programs differ.</source>
        <translation>Редоследот на коефициентите во секоја редица; другите програми очекуваат поинаков редослед.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Колку точки од играта на хаосот се запишуваат.</translation>
    </message>
    <message>
        <source>In flame programs, y points down. With this option, the flame looks as it does here; without it, the numbers stay the same.</source>
        <translation>Flame-програмите пуштаат y да расте надолу. Со ова пламенот изгледа како фракталот тука; без ова броевите остануваат исти.</translation>
    </message>
    <message>
        <source>With this option, the cage becomes part of the maps. Without it, the maps are written as they are in the table.</source>
        <translation>Со ова кафезот станува дел од пресликувањата. Без ова пресликувањата се запишуваат како што стојат во табелата.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Прашува за името на датотеката и ја запишува.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Го копира целиот текст на таблата со исечоци наместо да запише датотека.</translation>
    </message>
    <message>
        <source>This format can store only systems in the plane.</source>
        <translation>Овој формат може да чува само системи во рамнина.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Извоз на „%1“</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Проѕирна позадина</translation>
    </message>
    <message>
        <source>Include the ca&amp;ge</source>
        <translation>Вклучи го &amp;кафезот</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Формат:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Големина:</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Квалитет</translation>
    </message>
    <message>
        <source>Cells along each side of a pixel</source>
        <translation>Ќелии долж страната на пикселот</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 бита по канал</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
        <translation>16 бита по канал, за понатамошна работа на сликата</translation>
    </message>
    <message>
        <source>Colour depth</source>
        <translation>Длабочина на бојата</translation>
    </message>
    <message>
        <source>Memory needed</source>
        <translation>Потребна меморија</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>Кв&amp;алитет:</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>&amp;Суперсемплирање:</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>Длабочина на &amp;бојата:</translation>
    </message>
    <message>
        <source>Memory:</source>
        <translation>Меморија:</translation>
    </message>
    <message>
        <source>Copies of copies: a small file</source>
        <translation>Копии од копии: мала датотека</translation>
    </message>
    <message>
        <source>Outline, for cutters and plotters</source>
        <translation>Контура, за секачи и плотери</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Точки</translation>
    </message>
    <message>
        <source>Kind of shapes</source>
        <translation>Вид на облиците</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Број на точки</translation>
    </message>
    <message>
        <source>&amp;Automatic depth</source>
        <translation>&amp;Автоматска длабочина</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Нивоа на копии</translation>
    </message>
    <message>
        <source>Description of the picture</source>
        <translation>Како ќе изгледа сликата</translation>
    </message>
    <message>
        <source>S&amp;hapes:</source>
        <translation>&amp;Облици:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>То&amp;чки:</translation>
    </message>
    <message>
        <source>&amp;Depth:</source>
        <translation>&amp;Длабочина:</translation>
    </message>
    <message>
        <source>Only systems in the plane can be exported as a picture.</source>
        <translation>Како слика можат да се извезат само системи во рамнината.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>околу %1</translation>
    </message>
    <message>
        <source>One dot for every visible point of the chaos game.</source>
        <translation>По една точка за секоја видлива точка од играта на хаосот.</translation>
    </message>
    <message>
        <source>Guaranteed accuracy: %1.</source>
        <translation>Гарантирана точност: %1.</translation>
    </message>
    <message>
        <source>The shape itself measures %1 × %2.</source>
        <translation>Самата форма мери %1 × %2.</translation>
    </message>
    <message>
        <source>Shades of density need pixels: the shapes have one colour.</source>
        <translation>Нијансите на густината бараат пиксели: формите имаат само една боја.</translation>
    </message>
    <message>
        <source>The cage bends the picture, which copies cannot reproduce: the affine fit of the cage is written instead. A PNG shows the bend.</source>
        <translation>Кафезот ја свиткува сликата, а копиите не можат да го следат тоа: се запишува афиното приближување на кафезот. PNG го покажува свиткувањето.</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Извоз на слика</translation>
    </message>
    <message>
        <source>The picture has no background and can be placed over another.</source>
        <translation>Сликата нема позадина и може да се стави врз друга.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Го црта кафезот врз сликата.</translation>
    </message>
    <message>
        <source>The number of points drawn for each pixel: more points make a smoother picture and take longer.</source>
        <translation>Колку точки се цртаат за секој пиксел: со повеќе точки сликата е помазна, но трае подолго.</translation>
    </message>
    <message>
        <source>The number of smaller cells along each side of a pixel: more cells make smoother edges, at the cost of memory and time.</source>
        <translation>Секој пиксел се црта од толку поситни пиксели долж неговата страна: помазни рабови, но повеќе меморија и време.</translation>
    </message>
    <message>
        <source>16 bits keep fine gradations for later editing; 8 bits are enough for viewing.</source>
        <translation>16 бита ги задржуваат фините преливи на осветленоста за подоцнежна работа во уредувач на слики; за гледање се доволни 8 бита.</translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation>Копиите од копии даваат мала датотека што програмите за цртање можат да ја уредуваат; контурата е една патека; точките се точки од играта на хаосот.</translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation>Колку точки од играта на хаосот се цртаат.</translation>
    </message>
    <message>
        <source>The number of levels of copies. More levels hardly enlarge the file, but the picture takes longer to draw.</source>
        <translation>Колку нивоа на копии има сликата. Датотеката речиси не расте со нив, но времето за цртање расте.</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file. You can keep working in the meantime.</source>
        <translation>Прашува за името на датотеката и ја запишува. Во меѓувреме прозорецот може да се користи.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Сликата се копира…</translation>
    </message>
    <message>
        <source>Makes the copies smaller until they cannot be distinguished from the attractor at this pixel size, or until programs would take long to draw them.</source>
        <translation>Копиите се смалуваат сѐ додека ниеден пиксел со оваа големина не може да ја забележи разликата или додека на програмите не им треба долго да ги нацртаат.</translation>
    </message>
    <message>
        <source>More levels would be more accurate, but programs would take long to draw them.</source>
        <translation>Со повеќе нивоа би било поточно, но програмите долго би цртале.</translation>
    </message>
    <message>
        <source>Computing the shapes…</source>
        <translation>Се пресметуваат облиците…</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Погледот на платното</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>Целиот атрактор</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Исечок</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>&amp;Исечок:</translation>
    </message>
    <message>
        <source>SVG and PDF are made of shapes, which stay sharp at every size; the others are made of pixels. If the file name has the ending of another format, that format is written.</source>
        <translation>SVG и PDF се составени од облици, кои остануваат остри во секоја големина; другите се составени од пиксели. Ако името на датотеката ја има наставката на друг формат, се запишува тој формат.</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format: it must end with .png, .jpg, .webp, .tiff, .exr, .svg or .pdf.</source>
        <translation>Името „%1“ не го кажува форматот: мора да завршува на .png, .jpg, .webp, .tiff, .exr, .svg или .pdf.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the picture to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Прашува за име на датотека и ја црта сликата кога ќе дојде на ред, по оние што чекаат во панелот „Извози“. Редот продолжува по повторно стартување.</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>Погледот „%1“</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Што покажува сликата: она што го покажува платното или атракторот со мала маргина, каде и да гледа платното. Во листата се и зачуваните погледи.</translation>
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
        <translation>Гарантирана точност: %2. Копии што ги цртаат програмите што ја отвораат датотеката: %1 (границата е %3).</translation>
    </message>
    <message>
        <source>Draft: 25 points per pixel</source>
        <translation>Нацрт: 25 точки по пиксел</translation>
    </message>
    <message>
        <source>Good: 100 points per pixel</source>
        <translation>Добар: 100 точки по пиксел</translation>
    </message>
    <message>
        <source>Fine: 400 points per pixel</source>
        <translation>Фин: 400 точки по пиксел</translation>
    </message>
    <message>
        <source>Finest: 2000 points per pixel</source>
        <translation>Најфин: 2000 точки по пиксел</translation>
    </message>
</context>
<context>
    <name>view::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Преглед</translation>
    </message>
    <message>
        <source>What the file will show</source>
        <translation>Што ќе прикаже датотеката</translation>
    </message>
    <message>
        <source>The picture as it will be exported: its proportions and the section it shows. A chequerboard marks transparent parts. The preview follows every field.</source>
        <translation>Сликата како што ќе биде извезена: нејзиниот облик и делот што го прикажува. Каде што е проѕирна, се гледа шаховска шара. Го следи секое поле.</translation>
    </message>
    <message>
        <source>Drawing the preview…</source>
        <translation>Се црта прегледот…</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Нема преглед</translation>
    </message>
</context>
<context>
    <name>view::ExportProgress</name>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>Уште околу %n секунда.</numerusform>
            <numerusform>Уште околу %n секунди.</numerusform>
            <numerusform>Уште околу %n секунди.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n minute(s) left.</source>
        <translation>
            <numerusform>Уште околу %n минута.</numerusform>
            <numerusform>Уште околу %n минути.</numerusform>
            <numerusform>Уште околу %n минути.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n hour(s) left.</source>
        <translation>
            <numerusform>Уште околу %n час.</numerusform>
            <numerusform>Уште околу %n часа.</numerusform>
            <numerusform>Уште околу %n часа.</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Напредок на извозот</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Преостанато време</translation>
    </message>
</context>
<context>
    <name>view::ExportQueue</name>
    <message>
        <source>Barycage ended unexpectedly twice while drawing this picture. Try it again alone, or export a smaller one.</source>
        <translation>Програмата двапати заврши додека ја црташе оваа слика. Обидете се повторно само со неа, или извезете помала.</translation>
    </message>
    <message>
        <source>The export queue cannot be saved for the next session: its folder is not writable, or the disk is full.</source>
        <translation>Редот на извози не може да се зачува за следното стартување: во неговата папка не може да се пишува, или дискот е полн.</translation>
    </message>
</context>
<context>
    <name>view::ExportShell</name>
    <message>
        <source>Result</source>
        <translation>Резултат</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Извези…</translation>
    </message>
    <message>
        <source>Add to Queue…</source>
        <translation>Додај во редот…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Запри</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Затвори</translation>
    </message>
    <message>
        <source>Export stopped; nothing was written.</source>
        <translation>Извозот е запрен; ништо не е запишано.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Запишано во %1.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Покажи во папката</translation>
    </message>
    <message>
        <source>Shows the folder of the written file in the file manager.</source>
        <translation>Ја покажува папката на запишаната датотека во управувачот со датотеки.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Датотеки %1 (*.%2)</translation>
    </message>
</context>
<context>
    <name>view::ExportSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висина</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>пиксели</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>инчи</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Единица за должина</translation>
    </message>
    <message>
        <source>Same as on the screen</source>
        <translation>Како на екранот</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × екранот</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Приспособено</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Задржи го односот на страните</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Resolution in dots per inch</source>
        <translation>Резолуција во точки на инч</translation>
    </message>
    <message>
        <source>A length in the selected unit. The other side follows as long as the proportions are locked.</source>
        <translation>Должина во единицата избрана до неа. Другата страна се менува сразмерно додека се задржува обликот.</translation>
    </message>
    <message>
        <source>Pixels, or a length on paper at the given resolution.</source>
        <translation>Во пиксели, или на хартија со зададената резолуција.</translation>
    </message>
    <message>
        <source>The number of pixels per inch of paper: 300 is usual for print.</source>
        <translation>Колку пиксели доаѓаат на еден инч хартија: за печат вообичаени се 300.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Именувана големина</translation>
    </message>
    <message>
        <source>The size of the picture on the screen or a multiple of it, of a common screen, or of a sheet of paper. Everything that the window shows stays in the picture; if the proportions differ, the picture shows more around it.</source>
        <translation>Големината на сликата на екранот или нејзин повеќекратник, на вообичаен екран или на лист хартија. Сѐ што го покажува прозорецот останува во сликата; ако обликот е поинаков, околу неа се гледа повеќе.</translation>
    </message>
    <message>
        <source>Keep the proportions of the picture</source>
        <translation>Задржи ги пропорциите на сликата</translation>
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
        <translation>Квадрат: 2048 × 2048</translation>
    </message>
    <message>
        <source>A4 at 300 dpi</source>
        <translation>A4 со 300 dpi</translation>
    </message>
    <message>
        <source>A3 at 300 dpi</source>
        <translation>A3 со 300 dpi</translation>
    </message>
    <message>
        <source>The size of the picture, in pixels or on paper.</source>
        <translation>Големината на сликата, во пиксели или на хартија.</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Исправено или легнато</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Замени ги ширината и висината</translation>
    </message>
</context>
<context>
    <name>view::ExportsModel</name>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>уште околу %n секунда</numerusform>
            <numerusform>уште околу %n секунди</numerusform>
            <numerusform>уште околу %n секунди</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n minute(s) left</source>
        <translation>
            <numerusform>уште околу %n минута</numerusform>
            <numerusform>уште околу %n минути</numerusform>
            <numerusform>уште околу %n минути</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n hour(s) left</source>
        <translation>
            <numerusform>уште околу %n час</numerusform>
            <numerusform>уште околу %n часа</numerusform>
            <numerusform>уште околу %n часа</numerusform>
        </translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Паузирано</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Чека</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Готово</translation>
    </message>
    <message>
        <source>Paused at %1 %</source>
        <translation>Паузирано на %1 %</translation>
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
        <translation>Извози</translation>
    </message>
    <message>
        <source>Queue of exports</source>
        <translation>Ред на извози</translation>
    </message>
    <message>
        <source>The exports, drawn from top to bottom.</source>
        <translation>Извозите, цртани од горе надолу.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Паузирај</translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation>Помести на&amp;горе</translation>
    </message>
    <message>
        <source>Draw the selected export earlier.</source>
        <translation>Нацртај го избраниот извоз порано.</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Помести надо&amp;лу</translation>
    </message>
    <message>
        <source>Draw the selected export later.</source>
        <translation>Нацртај го избраниот извоз подоцна.</translation>
    </message>
    <message>
        <source>&amp;Try Again</source>
        <translation>&amp;Обиди се повторно</translation>
    </message>
    <message>
        <source>Try again to draw the selected exports that failed.</source>
        <translation>Нацртај ги повторно избраните извози што не успеале.</translation>
    </message>
    <message>
        <source>Show the folder of the selected export in the file manager.</source>
        <translation>Прикажи ја папката на избраниот извоз во управувачот со датотеки.</translation>
    </message>
    <message>
        <source>&amp;Cancel Export</source>
        <translation>Отка&amp;жи го извозот</translation>
    </message>
    <message>
        <source>Clear &amp;Finished</source>
        <translation>Тргни ги &amp;готовите</translation>
    </message>
    <message>
        <source>Remove all finished exports from the list; their files are kept.</source>
        <translation>Тргни ги од списокот сите готови извози; нивните датотеки остануваат.</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>Про&amp;должи</translation>
    </message>
    <message>
        <source>The exports that you have added to the queue. They are drawn one after another, from top to bottom, while you continue editing. Exports that are not finished when you quit continue the next time you start Barycage.</source>
        <translation>Извозите што ги додадовте во редот. Се цртаат еден по друг, од горе надолу, додека вие уредувате. Извозите што не се готови кога излегувате продолжуваат кога следниот пат ќе го стартувате Barycage.</translation>
    </message>
    <message>
        <source>Pause or resume all exports without losing progress.</source>
        <translation>Паузирај ги или продолжи ги сите извози без да се изгуби нацртаното.</translation>
    </message>
    <message>
        <source>Cancel the selected exports and remove them from the list; files already written are kept.</source>
        <translation>Откажи ги избраните извози и тргни ги од списокот; веќе запишаните датотеки остануваат.</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>Покажи во папката</translation>
    </message>
    <message>
        <source>No exports are waiting. Choose Add to Queue in File › Export › Export Picture… to draw pictures one after another while you continue editing.</source>
        <translation>Нема извози што чекаат. Изберете „Додај во редот“ во „Датотека › Извези › Извези слика…“ за да се цртаат слики една по друга додека уредувате.</translation>
    </message>
</context>
<context>
    <name>view::FamilySliders</name>
    <message>
        <source>Parameter %1 of the family</source>
        <translation>Параметар %1 на фамилијата</translation>
    </message>
    <message>
        <source>Change Family</source>
        <translation>Промени ја фамилијата</translation>
    </message>
</context>
<context>
    <name>view::FitBox</name>
    <message>
        <source>Best of 2 to 8</source>
        <translation>Најдобро од 2 до 8</translation>
    </message>
    <message>
        <source>How many maps a suggestion has; in a range, a map is added only if it improves the fit enough</source>
        <translation>Колку пресликувања има еден предлог; во опсег, секое мора да се исплати</translation>
    </message>
    <message>
        <source>Number of maps</source>
        <translation>Број на пресликувања</translation>
    </message>
    <message>
        <source>Maps:</source>
        <translation>Пресликувања:</translation>
    </message>
    <message>
        <source>Seconds to search</source>
        <translation>Секунди за пребарување</translation>
    </message>
    <message>
        <source>How long to search for suggestions</source>
        <translation>Колку долго да се бараат предлози</translation>
    </message>
    <message>
        <source>Seconds:</source>
        <translation>Секунди:</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Семе на случајните броеви</translation>
    </message>
    <message>
        <source>Another seed gives another search</source>
        <translation>Друга почетна вредност бара на други места</translation>
    </message>
    <message>
        <source>Seed:</source>
        <translation>Семе:</translation>
    </message>
    <message>
        <source>Similarities only</source>
        <translation>Само сличности</translation>
    </message>
    <message>
        <source>Only maps that keep all angles</source>
        <translation>Само пресликувања што ги чуваат сите агли</translation>
    </message>
    <message>
        <source>No mirror images</source>
        <translation>Без огледални слики</translation>
    </message>
    <message>
        <source>Only maps without reflection</source>
        <translation>Само пресликувања што не огледуваат</translation>
    </message>
    <message>
        <source>First map a stem</source>
        <translation>Првото пресликување е стебло</translation>
    </message>
    <message>
        <source>The first map flattens the shape to a line, like the stem of a fern</source>
        <translation>Првото пресликување ја сплескува формата во линија, како стебло на папрат</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Кои било</translation>
    </message>
    <message>
        <source>Multiples of %1°</source>
        <translation>Множители на %1°</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Агли</translation>
    </message>
    <message>
        <source>The angles by which the maps may rotate</source>
        <translation>За кои агли смеат да вртат пресликувањата</translation>
    </message>
    <message>
        <source>Angles:</source>
        <translation>Агли:</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Предложи</translation>
    </message>
    <message>
        <source>Find systems whose attractor looks like the target</source>
        <translation>Најди системи чиј атрактор наликува на целта</translation>
    </message>
    <message>
        <source>Add a Map</source>
        <translation>Додај пресликување</translation>
    </message>
    <message>
        <source>Add a map where the agreement is worst</source>
        <translation>Додај пресликување каде што согласноста е најлоша</translation>
    </message>
    <message>
        <source>Refine Maps</source>
        <translation>Дотерај ги пресликувањата</translation>
    </message>
    <message>
        <source>Move the maps so that their images of the target cover it better</source>
        <translation>Помести ги пресликувањата за нивните слики подобро да ја покријат целта</translation>
    </message>
    <message>
        <source>Refine Attractor</source>
        <translation>Дотерај го атракторот</translation>
    </message>
    <message>
        <source>Move the maps so that the attractor itself comes closer to the target</source>
        <translation>Помести ги пресликувањата за самиот атрактор да ѝ се приближи на целта</translation>
    </message>
    <message>
        <source>Fit Weights</source>
        <translation>Прилагоди ги тежините</translation>
    </message>
    <message>
        <source>Find the weights that reproduce the shades of the picture</source>
        <translation>Најди ги тежините што ги даваат нијансите на сликата</translation>
    </message>
    <message>
        <source>Fit Cage</source>
        <translation>Прилагоди го кафезот</translation>
    </message>
    <message>
        <source>Deform the attractor by a cage so that its outline follows that of the target</source>
        <translation>Деформирај го атракторот со кафез за неговиот обрис да го следи обрисот на целта</translation>
    </message>
    <message>
        <source>Refine selected maps only</source>
        <translation>Дотерај ги само избраните пресликувања</translation>
    </message>
    <message>
        <source>The maps that are not selected stay as they are</source>
        <translation>Неизбраните пресликувања остануваат какви што се</translation>
    </message>
    <message>
        <source>Locked maps stay as they are while others are refined</source>
        <translation>Заклучените пресликувања остануваат какви што се додека другите се дотеруваат</translation>
    </message>
    <message>
        <source>Corners of the cage</source>
        <translation>Агли на кафезот</translation>
    </message>
    <message>
        <source>How many corners the fitted cage has</source>
        <translation>Колку агли има прилагодениот кафез</translation>
    </message>
    <message>
        <source>Corners of the cage:</source>
        <translation>Агли на кафезот:</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Напредок</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Откажи</translation>
    </message>
    <message>
        <source>Lock Selected Maps</source>
        <translation>Заклучи ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <translation>Заклучени: %1</translation>
    </message>
    <message>
        <source>Stop without changing anything</source>
        <translation>Запри без да се промени ништо</translation>
    </message>
</context>
<context>
    <name>view::FourViews</name>
    <message>
        <source>Top</source>
        <translation>Одозгора</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Однапред</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Оддесно</translation>
    </message>
</context>
<context>
    <name>view::FrameSizeEditor</name>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>The width of the frames in pixels.</source>
        <translation>Ширината на кадрите во пиксели.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висина</translation>
    </message>
    <message>
        <source>The height of the frames in pixels.</source>
        <translation>Висината на кадрите во пиксели.</translation>
    </message>
    <message>
        <source>Named size</source>
        <translation>Именувана големина</translation>
    </message>
    <message>
        <source>Usual sizes of videos.</source>
        <translation>Вообичаени големини на видеа.</translation>
    </message>
    <message>
        <source>Lock proportions</source>
        <translation>Задржи го односот на страните</translation>
    </message>
    <message>
        <source>Keep the proportions of the frames</source>
        <translation>Задржи го односот на страните на кадрите</translation>
    </message>
    <message>
        <source>Portrait or landscape</source>
        <translation>Исправено или легнато</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>Замени ги ширината и висината</translation>
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
        <translation>Квадрат: 1080 × 1080</translation>
    </message>
    <message>
        <source>Portrait: 1080 × 1920</source>
        <translation>Исправено: 1080 × 1920</translation>
    </message>
    <message>
        <source>For a message: 640 × 360</source>
        <translation>За порака: 640 × 360</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Приспособено</translation>
    </message>
</context>
<context>
    <name>view::GoToDialog</name>
    <message>
        <source>Centre, x</source>
        <translation>Средина, x</translation>
    </message>
    <message>
        <source>The x coordinate in the middle of the view.</source>
        <translation>Координатата x во средината на погледот.</translation>
    </message>
    <message>
        <source>Centre, y</source>
        <translation>Средина, y</translation>
    </message>
    <message>
        <source>The y coordinate in the middle of the view.</source>
        <translation>Координатата y во средината на погледот.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висина</translation>
    </message>
    <message>
        <source>How much of the plane is seen, from the lower edge to the upper one.</source>
        <translation>Колку од рамнината се гледа, од долниот раб до горниот.</translation>
    </message>
    <message>
        <source>Go To</source>
        <translation>Оди на</translation>
    </message>
    <message>
        <source>such as 3 2 1</source>
        <translation>на пример 3 2 1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адреса</translation>
    </message>
    <message>
        <source>Numbers of maps, as the status bar shows them for the point under the pointer. They repeat, and the centre becomes the point that they lead to.</source>
        <translation>Броеви на пресликувања, како што ги покажува статусната лента за точката под покажувачот. Се повторуваат, а средината станува точката до која водат.</translation>
    </message>
    <message>
        <source>Choose a map</source>
        <translation>Изберете пресликување</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Неподвижна точка</translation>
    </message>
    <message>
        <source>The centre becomes the point that this map leaves where it is.</source>
        <translation>Средината станува точката што ова пресликување ја остава на своето место.</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Забелешка</translation>
    </message>
    <message>
        <source>&amp;Centre:</source>
        <translation>&amp;Средина:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>&amp;Висина:</translation>
    </message>
    <message>
        <source>&amp;Address:</source>
        <translation>&amp;Адреса:</translation>
    </message>
    <message>
        <source>&amp;Fixed point of:</source>
        <translation>&amp;Неподвижна точка на:</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Оди</translation>
    </message>
    <message>
        <source>Shows this part of the plane. The fractal stays as it is.</source>
        <translation>Го прикажува овој дел од рамнината. Фракталот останува како што е.</translation>
    </message>
    <message>
        <source>No point has this address: a map in it is switched off, or does not contract.</source>
        <translation>Ниедна точка нема таква адреса: некое пресликување во неа е исклучено или не стега.</translation>
    </message>
    <message>
        <source>An address has the numbers of maps, from 1 to %1.</source>
        <translation>Адресата се состои од броеви на пресликувања, од 1 до %1.</translation>
    </message>
</context>
<context>
    <name>view::GradientChooser</name>
    <message>
        <source>of this fractal</source>
        <translation>од овој фрактал</translation>
    </message>
    <message>
        <source>%1 (of this fractal)</source>
        <translation>%1 (од овој фрактал)</translation>
    </message>
</context>
<context>
    <name>view::GradientEditor</name>
    <message>
        <source>Palette editor</source>
        <translation>Уредувач на палета</translation>
    </message>
    <message>
        <source>Stop Colour</source>
        <translation>Боја на маркерот</translation>
    </message>
    <message>
        <source>Position of the stop</source>
        <translation>Положба на маркерот</translation>
    </message>
    <message>
        <source>Position of the stop, from 0 to 1</source>
        <translation>Положба на маркерот, од 0 до 1</translation>
    </message>
    <message>
        <source>Add Stop</source>
        <translation>Додај маркер</translation>
    </message>
    <message>
        <source>Add a stop after the selected one</source>
        <translation>Додај маркер по избраниот</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Избриши маркер</translation>
    </message>
    <message>
        <source>Delete the selected stop</source>
        <translation>Избриши го избраниот маркер</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Преврти</translation>
    </message>
    <message>
        <source>Reverse the order of the colours</source>
        <translation>Преврти го редоследот на палетата</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Распореди</translation>
    </message>
    <message>
        <source>Space the stops evenly</source>
        <translation>Стави ги маркерите на еднакви растојанија</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Вчитај…</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Зачувај како…</translation>
    </message>
    <message>
        <source>Save the palette as a .gpl file</source>
        <translation>Зачувај ја палетата како .gpl-датотека</translation>
    </message>
    <message>
        <source>Change a colour of the palette</source>
        <translation>Промена на боја од палетата</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Поместување на маркер од палетата</translation>
    </message>
    <message>
        <source>Save Palette</source>
        <translation>Зачувување на палетата</translation>
    </message>
    <message>
        <source>palette</source>
        <translation>палета</translation>
    </message>
    <message>
        <source>GIMP palettes (*.gpl)</source>
        <translation>Палети на GIMP (*.gpl)</translation>
    </message>
    <message>
        <source>Reverse the palette</source>
        <translation>Превртување на палетата</translation>
    </message>
    <message>
        <source>Distribute the stops of the palette</source>
        <translation>Распоредување на маркерите на палетата</translation>
    </message>
    <message>
        <source>Load Palette</source>
        <translation>Вчитување палета</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, ред %2: %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Load the palette %1</source>
        <translation>Вчитување на палетата %1</translation>
    </message>
    <message>
        <source>Palettes of the file</source>
        <translation>Палети во датотеката</translation>
    </message>
    <message>
        <source>Load a palette</source>
        <translation>Вчитување палета</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Зачувано: %1.</translation>
    </message>
    <message>
        <source>The palettes in the file. Select one.</source>
        <translation>Палетите што ги содржи датотеката. Изберете една.</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
    </message>
    <message>
        <source>Take the palette from a picture</source>
        <translation>Земи ја палетата од слика</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ggr, .ugr or .map file, or take it from a picture</source>
        <translation>Вчитај палета од датотека .gpl, .ggr, .ugr или .map, или земи ја од слика</translation>
    </message>
    <message>
        <source>Palettes and pictures (%1);;All files (*)</source>
        <translation>Палети и слики (%1);;Сите датотеки (*)</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Маркери на градиентот</translation>
    </message>
    <message>
        <source>Double-click: add a stop, or change the colour of one. Drag: move. Del: delete.
Keys: Page Up and Page Down select a stop, the arrow keys move it, Ins adds one, Enter opens its colour.</source>
        <translation>Двојно кликање: нов маркер или боја на постоен. Влечење: поместување. Del: бришење.
Копчиња: Page Up и Page Down избираат маркер, стрелките го поместуваат, Ins додава нов, Enter ја отвора неговата боја.</translation>
    </message>
    <message>
        <source>Stop %1 of %2 at %3 %, %4</source>
        <translation>Маркер %1 од %2 на %3 %, %4</translation>
    </message>
    <message>
        <source>Add a stop to the palette</source>
        <translation>Додавање на маркер во палетата</translation>
    </message>
    <message>
        <source>Delete a stop of the palette</source>
        <translation>Бришење на маркер од палетата</translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation>Поместување на маркер од палетата</translation>
    </message>
</context>
<context>
    <name>view::HandoutDialog</name>
    <message>
        <source>&amp;Cage and maps</source>
        <translation>&amp;Кафез и пресликувања</translation>
    </message>
    <message>
        <source>&amp;Formulas</source>
        <translation>&amp;Формули</translation>
    </message>
    <message>
        <source>&amp;Line for name and date</source>
        <translation>&amp;Линија за име и датум</translation>
    </message>
    <message>
        <source>Print a Handout</source>
        <translation>Печати лист за час</translation>
    </message>
    <message>
        <source>Pre&amp;view…</source>
        <translation>&amp;Преглед…</translation>
    </message>
    <message>
        <source>Show the pages before they are printed</source>
        <translation>Прикажи ги страниците пред печатење</translation>
    </message>
    <message>
        <source>&amp;Entries:</source>
        <translation>&amp;Записи:</translation>
    </message>
    <message>
        <source>Entries to print</source>
        <translation>Записи за печатење</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>&amp;Сите</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ниеден</translation>
    </message>
    <message>
        <source>Print all entries of the list</source>
        <translation>Печати ги сите записи од списокот</translation>
    </message>
    <message>
        <source>Remove all ticks</source>
        <translation>Отстрани ги сите ознаки</translation>
    </message>
    <message>
        <source>Handout with pictures</source>
        <translation>Лист со слики</translation>
    </message>
    <message>
        <source>Blank worksheet</source>
        <translation>Празен лист со задачи</translation>
    </message>
    <message>
        <source>Kind of sheet</source>
        <translation>Вид на листот</translation>
    </message>
    <message>
        <source>Entries per page</source>
        <translation>Записи на страница</translation>
    </message>
    <message>
        <source>How many entries are printed on one page.</source>
        <translation>Колку записи се печатат на една страница.</translation>
    </message>
    <message>
        <source>Draw the cage and its numbered images over the picture</source>
        <translation>Цртај го кафезот и неговите нумерирани слики врз сликата</translation>
    </message>
    <message>
        <source>Print the formula and the probability of each map</source>
        <translation>Печати ги формулата и веројатноста на секое пресликување</translation>
    </message>
    <message>
        <source>Leave lines at the top of each page for a name and a date</source>
        <translation>Остави линии на врвот од секоја страница за име и датум</translation>
    </message>
    <message>
        <source>&amp;Sheet:</source>
        <translation>Л&amp;ист:</translation>
    </message>
    <message>
        <source>Entries per &amp;page:</source>
        <translation>Записи на с&amp;траница:</translation>
    </message>
    <message>
        <source>Choose at most %1 entries</source>
        <translation>Изберете најмногу %1 записи</translation>
    </message>
    <message>
        <source>Choose an entry first</source>
        <translation>Прво изберете запис</translation>
    </message>
    <message>
        <source>%1-handout.pdf</source>
        <comment>name of a file</comment>
        <translation>%1-лист-за-час.pdf</translation>
    </message>
    <message>
        <source>Prints entries of the file for a class: with pictures and formulas, or as blank worksheets.</source>
        <translation>Печати ставки од датотеката за час: со слики и формули, или како празни работни листови.</translation>
    </message>
    <message>
        <source>The entries of the file that could be read. Ticked entries are printed in this order, up to %1 of them.</source>
        <translation>Записите од датотеката што можеа да се прочитаат. Се печатат означените, по овој редослед, најмногу %1.</translation>
    </message>
    <message>
        <source>A handout has the picture of each entry, with its cage, its maps and their formulas. A blank worksheet has the cage, in the plane on a grid, and an empty table, to be filled in by hand.</source>
        <translation>Листот за час ја прикажува сликата на секој запис со неговиот кафез, пресликувањата и нивните формули. Празниот лист со задачи го прикажува кафезот, во рамнината на мрежа, и празна табела што се пополнува рачно.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Резултат</translation>
    </message>
</context>
<context>
    <name>view::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Историја</translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation>Чекори во историјата</translation>
    </message>
    <message>
        <source>Select a step to go back or forward to it.</source>
        <translation>Изберете чекор за да се вратите на него или да одите напред.</translation>
    </message>
    <message>
        <source>Select a step to go back or forward to it. The disk marks the saved state.</source>
        <translation>Изберете чекор за да се вратите на него или да одите напред. Дискетата означува што е зачувано.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Како при отворањето</translation>
    </message>
</context>
<context>
    <name>view::LessonCard</name>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Назад</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Заврши</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Лекција</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Текст на чекорот</translation>
    </message>
    <message>
        <source>Show the previous step (Page Up)</source>
        <translation>Прикажи го претходниот чекор (Page Up)</translation>
    </message>
    <message>
        <source>Show the next step (Page Down)</source>
        <translation>Прикажи го следниот чекор (Page Down)</translation>
    </message>
    <message>
        <source>End the lesson and return to the window as it was (Esc)</source>
        <translation>Заврши ја лекцијата и врати се на прозорецот каков што беше (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 од %2</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Готово</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Следно</translation>
    </message>
    <message>
        <source>A lesson in progress: the text of the current step, and buttons to go to the others.</source>
        <translation>Лекција во тек: текстот на тековниот чекор и копчиња за преминување на другите.</translation>
    </message>
</context>
<context>
    <name>view::LessonNotebook</name>
    <message>
        <source>Rename lesson</source>
        <translation>Преименувај ја лекцијата</translation>
    </message>
    <message>
        <source>Add step</source>
        <translation>Додај чекор</translation>
    </message>
    <message>
        <source>Update step</source>
        <translation>Обнови го чекорот</translation>
    </message>
    <message>
        <source>Rename step</source>
        <translation>Преименувај го чекорот</translation>
    </message>
    <message>
        <source>Edit text</source>
        <translation>Уреди го текстот</translation>
    </message>
    <message>
        <source>Remove step</source>
        <translation>Отстрани го чекорот</translation>
    </message>
    <message>
        <source>Move step</source>
        <translation>Помести го чекорот</translation>
    </message>
</context>
<context>
    <name>view::LessonPanel</name>
    <message>
        <source>Arrange the window as you want to show it, and press Add Step. Then write the text of the step.</source>
        <translation>Наместете го прозорецот како што треба да го види класот и притиснете „Додај чекор“. Потоа напишете што сакате да кажете.</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Пушти</translation>
    </message>
    <message>
        <source>Save &amp;Lesson…</source>
        <translation>&amp;Зачувај ја лекцијата…</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Лекција</translation>
    </message>
    <message>
        <source>Add Step</source>
        <translation>Додај чекор</translation>
    </message>
    <message>
        <source>Add a step with the current state of the window</source>
        <translation>Додај чекор со сегашната состојба на прозорецот</translation>
    </message>
    <message>
        <source>Update Step</source>
        <translation>Обнови го чекорот</translation>
    </message>
    <message>
        <source>Replace the state of the selected step by the current state of the window</source>
        <translation>Дај му на избраниот чекор ја сегашната состојба на прозорецот</translation>
    </message>
    <message>
        <source>Show Step</source>
        <translation>Прикажи го чекорот</translation>
    </message>
    <message>
        <source>Restore the window to the state of the selected step</source>
        <translation>Доведи го прозорецот во состојбата на избраниот чекор</translation>
    </message>
    <message>
        <source>Remove Step</source>
        <translation>Отстрани го чекорот</translation>
    </message>
    <message>
        <source>Remove the selected step</source>
        <translation>Отстрани го избраниот чекор</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Помести нагоре</translation>
    </message>
    <message>
        <source>Show the selected step earlier</source>
        <translation>Прикажи го избраниот чекор порано</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Помести надолу</translation>
    </message>
    <message>
        <source>Show the selected step later</source>
        <translation>Прикажи го избраниот чекор подоцна</translation>
    </message>
    <message>
        <source>Undo in the Lesson</source>
        <translation>Врати во лекцијата</translation>
    </message>
    <message>
        <source>Undo the last change of the lesson</source>
        <translation>Врати ја последната измена на лекцијата</translation>
    </message>
    <message>
        <source>Redo in the Lesson</source>
        <translation>Повтори во лекцијата</translation>
    </message>
    <message>
        <source>Redo the change of the lesson</source>
        <translation>Повтори ја измената на лекцијата</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>Наслов на лекцијата</translation>
    </message>
    <message>
        <source>Shown above every step while the lesson is played</source>
        <translation>Стои над секој чекор додека тече лекцијата</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Чекори на лекцијата</translation>
    </message>
    <message>
        <source>Double-click a step to restore its state of the window</source>
        <translation>Двоен клик на чекор го доведува прозорецот во неговата состојба</translation>
    </message>
    <message>
        <source>Title of the step</source>
        <translation>Наслов на чекорот</translation>
    </message>
    <message>
        <source>Shown in large letters above the text</source>
        <translation>Стои со големи букви над текстот</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Текст на чекорот</translation>
    </message>
    <message>
        <source>Shown beside the picture; leave a line empty to begin a paragraph</source>
        <translation>Стои до сликата; празен ред почнува нов пасус</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Панели</translation>
    </message>
    <message>
        <source>The panels that this step shows beside the canvas; all others are hidden</source>
        <translation>Панелите што ги прикажува овој чекор до платното; сите други се скриени</translation>
    </message>
    <message>
        <source>Panels of the step</source>
        <translation>Панели на чекорот</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Без наслов</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number and title of a step</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1. A lesson is a list of steps. Each has a text, and the state of the window that belongs to it: the entry, the view, the tool, colours and outlines.</source>
        <translation>%1. Лекцијата е список од чекори. Секој има текст и состојба на прозорецот што му припаѓа: записот, што се гледа од него, алатката, боите и контурите.</translation>
    </message>
    <message>
        <source>Play the lesson in full screen, from the beginning or from the step you clicked in the list</source>
        <translation>Пушти ја лекцијата на целиот екран, од почеток или од чекорот на кој кликнавте во списокот</translation>
    </message>
    <message>
        <source>Save the lesson as a text that refers to its fractals</source>
        <translation>Зачувај ја лекцијата како текст што упатува на нејзините фрактали</translation>
    </message>
</context>
<context>
    <name>view::LightBall</name>
    <message>
        <source>Direction of the light</source>
        <translation>Насока на светлината</translation>
    </message>
    <message>
        <source>Drag the light over the sphere, or use the arrow keys</source>
        <translation>Влечете ја светлината по топката или користете ги стрелките</translation>
    </message>
    <message>
        <source>Azimuth %1°, elevation %2°</source>
        <translation>Азимут %1°, висина %2°</translation>
    </message>
</context>
<context>
    <name>view::LinePicture</name>
    <message>
        <source>Picture</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it; click to take all</source>
        <translation>Повлечете линија за да ги земете само боите по неа; кликнете за да ги земете сите</translation>
    </message>
</context>
<context>
    <name>view::LinkGraph</name>
    <message>
        <source>Graph of links</source>
        <translation>Граф на врските</translation>
    </message>
    <message>
        <source>Drag from one map to another to link them; click an arrow and press Delete to remove it.</source>
        <translation>Влечете од едно пресликување до друго за да ги поврзете; кликнете на стрелка и притиснете Delete за да ја отстраните.</translation>
    </message>
    <message>
        <source>Each circle is a map, and an arrow leads to each map that may follow it in the chaos game; thicker arrows have more weight. Drag from one map to another to link them, or out of a map and back to link it to itself. Click an arrow and press Delete to remove it, or double-click it to enter its weight. With the keyboard: Left and Right walk through the maps, Up and Down through the arrows of a map; Space begins a new arrow, Left and Right choose its end, Enter adds it. Maps with a dashed ring take no part; the reason is shown beside them.</source>
        <translation>Секој круг е пресликување, а стрелка води до секое пресликување што смее да го следи во играта на хаосот; подебелите стрелки имаат поголема тежина. Влечете од едно пресликување до друго за да ги поврзете, или надвор од пресликување и назад за да го поврзете со самото себе. Кликнете на стрелка и притиснете Delete за да ја отстраните, или двоен клик за да ја внесете нејзината тежина. Со тастатурата: лево и десно минуваат низ пресликувањата, горе и долу низ стрелките на едно пресликување; празно место почнува нова стрелка, лево и десно го избираат нејзиниот крај, Enter ја додава. Пресликувањата со испрекинат прстен не учествуваат, од причината што стои до нив.</translation>
    </message>
    <message>
        <source>No map is selected.</source>
        <translation>Не е избрано пресликување.</translation>
    </message>
    <message>
        <source>New arrow from map %1 to map %2. Enter adds it, Esc cancels.</source>
        <translation>Нова стрелка од пресликување %1 до пресликување %2. Enter ја додава, Esc не.</translation>
    </message>
    <message>
        <source>Map %1: %2</source>
        <translation>Пресликување %1: %2</translation>
    </message>
</context>
<context>
    <name>view::LinksModel</name>
    <message>
        <source>Switched off</source>
        <translation>Исклучено</translation>
    </message>
    <message>
        <source>Unreached: no map leads to it</source>
        <translation>Недостигнато: ниедно пресликување не води до него</translation>
    </message>
    <message>
        <source>Transient: the chaos game never returns</source>
        <translation>Напуштено: играта на хаосот никогаш не се враќа</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Учествува</translation>
    </message>
    <message>
        <source>From map %1 to map %2: %3</source>
        <translation>Од пресликувањето %1 до пресликувањето %2: %3</translation>
    </message>
    <message>
        <source>Link map %1 to map %2</source>
        <translation>Поврзи го пресликувањето %1 со пресликувањето %2</translation>
    </message>
    <message>
        <source>In the chaos game</source>
        <translation>Во играта на хаосот</translation>
    </message>
    <message>
        <source>Whether the chaos game keeps applying the map, or why not</source>
        <translation>Дали пресликувањето се применува повторно и повторно, или зошто не</translation>
    </message>
    <message>
        <source>To map %1</source>
        <translation>До пресликувањето %1</translation>
    </message>
    <message>
        <source>From map %1</source>
        <translation>Од пресликувањето %1</translation>
    </message>
    <message>
        <source>Unlink map %1 from map %2</source>
        <translation>Одврзи го пресликувањето %1 од пресликувањето %2</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n link(s)</source>
        <translation>
            <numerusform>Отстрани %n врска</numerusform>
            <numerusform>Отстрани %n врски</numerusform>
            <numerusform>Отстрани %n врски</numerusform>
        </translation>
    </message>
    <message>
        <source>Ends: every sequence from here stops</source>
        <translation>Завршува: секоја низа оттука запира</translation>
    </message>
    <message>
        <source>Directly after map %1, map %2 has %3 times its weight.</source>
        <translation>Веднаш по пресликувањето %1, пресликувањето %2 се применува со својата тежина помножена со %3.</translation>
    </message>
    <message>
        <source>Map %2 is never applied directly after map %1.</source>
        <translation>Веднаш по пресликувањето %1, пресликувањето %2 никогаш не се применува.</translation>
    </message>
</context>
<context>
    <name>view::LinksPanel</name>
    <message>
        <source>Remove All Links</source>
        <translation>Отстрани ги сите врски</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Врски</translation>
    </message>
    <message>
        <source>Links between maps</source>
        <translation>Врски меѓу пресликувањата</translation>
    </message>
    <message>
        <source>Rows are the maps applied before, columns the maps applied after. A number multiplies the weight of the map in its column: 1 leaves it unchanged, 0 forbids the link.</source>
        <translation>Редовите се пресликувањата применети претходно, колоните оние потоа. Бројот ја множи тежината на пресликувањето во колоната: 1 ја остава, 0 го забранува.</translation>
    </message>
    <message>
        <source>Any map may follow any other again</source>
        <translation>Секое пресликување повторно смее да следи по секое друго</translation>
    </message>
    <message>
        <source>Every sequence of maps ends, so nothing is drawn.</source>
        <translation>Секоја низа пресликувања завршува, па ништо не се црта.</translation>
    </message>
    <message>
        <source>Remove all links</source>
        <translation>Отстрани ги сите врски</translation>
    </message>
    <message>
        <source>Any map may follow any other. Click an arrow and press Delete to forbid it.</source>
        <translation>Секое пресликување смее да го следи секое друго. Кликнете на стрелка и притиснете Delete за да го забраните тоа.</translation>
    </message>
    <message>
        <source>No map has a choice of what follows it, so only single points are drawn.</source>
        <translation>По секое пресликување може да следи само едно, па се цртаат само поединечни точки.</translation>
    </message>
    <message>
        <source>Row: the map before. Column: the map after.</source>
        <translation>Ред: пресликувањето претходно. Колона: следното.</translation>
    </message>
</context>
<context>
    <name>view::MapBlendRow</name>
    <message>
        <source>Colour</source>
        <translation>Боја</translation>
    </message>
    <message>
        <source>The position on the palette to which this map moves colours, from 0 to 1</source>
        <translation>Кон кое место на палетата ги влече боите ова пресликување: од 0, нејзиниот почеток, до 1</translation>
    </message>
    <message>
        <source>Whenever this map is applied, the colour of the point moves towards the position of the map on the palette: 0 is the beginning of the palette, 1 its end. Flame programs call it the colour coordinate.</source>
        <translation>Секогаш кога се применува едно пресликување, бојата на точката се поместува кон местото на тоа пресликување на палетата: 0 е почетокот на палетата, 1 нејзиниот крај. Кај пламените тоа се вика координата на боја.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Брзина</translation>
    </message>
    <message>
        <source>How far this map moves colours each time, from 0 (not at all) to 1 (all the way)</source>
        <translation>Колку ги влече боите ова пресликување секој пат: од 0, воопшто не, до 1, целиот пат</translation>
    </message>
    <message>
        <source>How far the map moves colours towards its position on the palette each time: with 1, its piece has a single colour; with 0, all colours stay as they are. Flame programs call it the colour speed.</source>
        <translation>Колкав дел од патот до своето место на палетата пресликувањето ги носи боите секој пат: со 1 неговиот дел има една боја, со 0 сите бои ги остава како што се. Кај пламените тоа се вика брзина на боја.</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
</context>
<context>
    <name>view::MapOrder</name>
    <message>
        <source>Order of the maps</source>
        <translation>Редослед на пресликувањата</translation>
    </message>
    <message>
        <source>Where pieces overlap, the map that is higher in this list is on top; drag a map to move it</source>
        <translation>Каде што деловите се преклопуваат, горе е пресликувањето што е повисоко во списокот; повлечете пресликување за да го поместите</translation>
    </message>
    <message>
        <source>Move the map towards the top</source>
        <translation>Помести го пресликувањето нагоре</translation>
    </message>
    <message>
        <source>Move the map towards the bottom</source>
        <translation>Помести го пресликувањето надолу</translation>
    </message>
    <message>
        <source>On top</source>
        <translation>Горе</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Врати го редоследот</translation>
    </message>
    <message>
        <source>Reset Order: puts the maps back in the order of their numbers</source>
        <translation>Врати го редоследот: ги подредува пресликувањата повторно по нивните броеви</translation>
    </message>
    <message>
        <source>Puts the maps back in the order of their numbers, which is that of the Maps panel: map 1 is on top. This is one step that you can undo.</source>
        <translation>Ги подредува пресликувањата повторно по нивните броеви, како во панелот „Пресликувања“: пресликувањето 1 е најгоре. Тоа е еден чекор што може да се врати.</translation>
    </message>
</context>
<context>
    <name>view::MapShapeEditor</name>
    <message>
        <source>Rotation °</source>
        <translation>Ротација °</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise with y up</source>
        <translation>Агол во степени, спротивно од стрелките на часовникот, со y нагоре</translation>
    </message>
    <message>
        <source>Scale x</source>
        <translation>Размер x</translation>
    </message>
    <message>
        <source>Length of the image of the x unit vector</source>
        <translation>Должина на сликата на единичниот вектор по x</translation>
    </message>
    <message>
        <source>Scale y</source>
        <translation>Размер y</translation>
    </message>
    <message>
        <source>Scale at right angles to that; negative if the map reflects</source>
        <translation>Размер напречно; негативен ако пресликувањето ја менува ориентацијата</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Искосување</translation>
    </message>
    <message>
        <source>Shear along x, applied first</source>
        <translation>Искосување по x, се применува пред сѐ друго</translation>
    </message>
    <message>
        <source>Shift x</source>
        <translation>Поместување x</translation>
    </message>
    <message>
        <source>Translation e, applied last</source>
        <translation>Транслација e, се применува последна</translation>
    </message>
    <message>
        <source>Shift y</source>
        <translation>Поместување y</translation>
    </message>
    <message>
        <source>Translation f, applied last</source>
        <translation>Транслација f, се применува последна</translation>
    </message>
    <message>
        <source>No map is selected</source>
        <translation>Не е избрано пресликување</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Axis of the rotation; only its direction matters</source>
        <translation>Оска на ротацијата; важна е само нејзината насока</translation>
    </message>
    <message>
        <source>Axis x</source>
        <translation>Оска x</translation>
    </message>
    <message>
        <source>Axis y</source>
        <translation>Оска y</translation>
    </message>
    <message>
        <source>Axis z</source>
        <translation>Оска z</translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise as seen from the tip of the axis looking back</source>
        <translation>Агол во степени, спротивно од стрелките на часовникот гледано наназад од врвот на оската</translation>
    </message>
    <message>
        <source>Scale along y, before the rotation</source>
        <translation>Размер по y, пред ротацијата</translation>
    </message>
    <message>
        <source>Scale z</source>
        <translation>Размер z</translation>
    </message>
    <message>
        <source>Scale along z, before the rotation; negative if the map reflects</source>
        <translation>Размер по z, пред ротацијата; негативен ако пресликувањето ја менува ориентацијата</translation>
    </message>
    <message>
        <source>Shear xy</source>
        <translation>Искосување xy</translation>
    </message>
    <message>
        <source>What y adds to x, applied first</source>
        <translation>Колку y додава на x; се применува прво</translation>
    </message>
    <message>
        <source>Shear xz</source>
        <translation>Искосување xz</translation>
    </message>
    <message>
        <source>What z adds to x, applied first</source>
        <translation>Колку z додава на x; се применува прво</translation>
    </message>
    <message>
        <source>Shear yz</source>
        <translation>Искосување yz</translation>
    </message>
    <message>
        <source>What z adds to y, applied first</source>
        <translation>Колку z додава на y; се применува прво</translation>
    </message>
    <message>
        <source>Translation j, applied last</source>
        <translation>Транслација j, се применува последна</translation>
    </message>
    <message>
        <source>Translation k, applied last</source>
        <translation>Транслација k, се применува последна</translation>
    </message>
    <message>
        <source>Shift z</source>
        <translation>Поместување z</translation>
    </message>
    <message>
        <source>Translation l, applied last</source>
        <translation>Транслација l, се применува последна</translation>
    </message>
    <message>
        <source>Map %1, locked</source>
        <translation>Пресликување %1, заклучено</translation>
    </message>
</context>
<context>
    <name>view::MapsClipboard</name>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in space.</source>
        <translation>Ништо не е вметнато: копираните пресликувања се од систем во просторот.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the copied maps are of a system in the plane.</source>
        <translation>Ништо не е вметнато: копираните пресликувања се од систем во рамнината.</translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard contains no rows of 12 or 13 numbers.</source>
        <translation>Ништо не е вметнато: таблата со исечоци не содржи редици од 12 или 13 броја.</translation>
    </message>
</context>
<context>
    <name>view::MapsDelegate</name>
    <message>
        <source>%1 of map %2</source>
        <translation>%1 на пресликувањето %2</translation>
    </message>
    <message>
        <source>%1 The cell keeps its value.</source>
        <translation>%1 Ќелијата ја задржува својата вредност.</translation>
    </message>
    <message>
        <source>Name of map %1</source>
        <translation>Име на пресликувањето %1</translation>
    </message>
</context>
<context>
    <name>view::MapsModel</name>
    <message>
        <source>similarity</source>
        <translation>сличност</translation>
    </message>
    <message>
        <source>reflected similarity</source>
        <translation>огледална сличност</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>афино</translation>
    </message>
    <message>
        <source>singular</source>
        <translation>сингуларно</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>константно</translation>
    </message>
    <message>
        <source>A similarity keeps shapes: it turns, scales and shifts.</source>
        <translation>Сличноста го запазува обликот: врти, скалира и поместува.</translation>
    </message>
    <message>
        <source>A reflected similarity keeps shapes but mirrors them; it also turns, scales and shifts them.</source>
        <translation>Огледалната сличност го запазува обликот, како огледало, а притоа скалира и поместува.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels but not angles.</source>
        <translation>Афиното пресликување ги запазува правите и паралелноста, но не и аглите.</translation>
    </message>
    <message>
        <source>A singular map takes the whole plane to a line.</source>
        <translation>Сингуларното пресликување ја пресликува рамнината во права.</translation>
    </message>
    <message>
        <source>A constant map takes the whole plane to one point.</source>
        <translation>Константното пресликување ја пресликува рамнината во една точка.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Да</translation>
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
        <translation>Вид</translation>
    </message>
    <message>
        <source>The map takes (x, y) to (a x + b y + e, c x + d y + f).</source>
        <translation>Пресликувањето ја пресликува (x, y) во (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage. Bake turns it into the code.</source>
        <translation>Ефективен код: пресликувањето онака како што дејствува на сликата под сегашниот кафез. Со „Впиши“ тој станува код.</translation>
    </message>
    <message>
        <source>Weight as entered: how often the chaos game chooses the map. The weights need not sum to 1.</source>
        <translation>Тежината како што е зададена: колку често играта на хаосот го зема пресликувањето. Збирот на тежините не мора да биде 1.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor by which areas change; negative if the map reflects.</source>
        <translation>Детерминантата ad − bc: коефициентот со кој се менуваат плоштините; негативна е ако пресликувањето ја менува ориентацијата.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the largest factor by which distances are stretched.</source>
        <translation>Коефициентот на контракција ‖A‖, најголемата сингуларна вредност: колку пати најмногу растат растојанијата.</translation>
    </message>
    <message>
        <source>The geometric kind of the map.</source>
        <translation>Што е пресликувањето геометриски.</translation>
    </message>
    <message>
        <source>Map %1 is switched on.</source>
        <translation>Пресликувањето %1 учествува.</translation>
    </message>
    <message>
        <source>Map %1 is switched off.</source>
        <translation>Пресликувањето %1 е исклучено.</translation>
    </message>
    <message>
        <source>Colour of map %1. Press Space or double-click to change it.</source>
        <translation>Боја на пресликувањето %1. За да ја промените, притиснете Space или кликнете двапати.</translation>
    </message>
    <message>
        <source>The cage is flat or bent: there is no effective code.</source>
        <translation>Кафезот е сплескан или свиткува: нема ефективен код.</translation>
    </message>
    <message>
        <source>No weight is given; the determinant rule gives the probability %1.</source>
        <translation>Не е зададена тежина; според детерминантите веројатноста е %1.</translation>
    </message>
    <message>
        <source>Weight %1: a weight that is not positive switches the map off.</source>
        <translation>Тежина %1: тежина што не е позитивна го исклучува пресликувањето.</translation>
    </message>
    <message>
        <source>Weight %1, probability %2.</source>
        <translation>Тежина %1, веројатност %2.</translation>
    </message>
    <message>
        <source>%1, not contracting</source>
        <translation>%1, не е контракција</translation>
    </message>
    <message>
        <source>colour %1</source>
        <translation>боја %1</translation>
    </message>
    <message>
        <source>Map %1 does not contract: it stretches by up to %2. The system may still have an attractor if longer words contract.</source>
        <translation>Пресликувањето %1 не е контракција: растегнува до %2 пати. Системот сепак може да има атрактор ако подолгите зборови се контракции.</translation>
    </message>
    <message>
        <source>Map %1. Drag to reorder.</source>
        <translation>Пресликување %1. Повлечете за да го смените редоследот.</translation>
    </message>
    <message>
        <source>Switch map %1 on</source>
        <translation>Вклучување на пресликувањето %1</translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation>Исклучување на пресликувањето %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>вклучено</translation>
    </message>
    <message>
        <source>off</source>
        <translation>исклучено</translation>
    </message>
    <message>
        <source>Set %1 of map %2 to %3</source>
        <translation>Постави %1 на пресликувањето %2 на %3</translation>
    </message>
    <message>
        <source>Colour of map %1: %2</source>
        <translation>Боја на пресликувањето %1: %2</translation>
    </message>
    <message>
        <source>A singular map takes the whole of space to a plane or a line.</source>
        <translation>Сингуларното пресликување го пресликува просторот во рамнина или права.</translation>
    </message>
    <message>
        <source>A constant map takes the whole of space to one point.</source>
        <translation>Константното пресликување го пресликува просторот во една точка.</translation>
    </message>
    <message>
        <source>The map takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</source>
        <translation>Пресликувањето ја пресликува (x, y, z) во (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l).</translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage.</source>
        <translation>Ефективен код: пресликувањето онака како што дејствува на сликата под сегашниот кафез.</translation>
    </message>
    <message>
        <source>Determinant: the factor by which volumes change; negative if the map reflects.</source>
        <translation>Детерминанта: коефициентот со кој се менуваат волумените; негативна е ако пресликувањето ја менува ориентацијата.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Име</translation>
    </message>
    <message>
        <source>Whether the map is switched on. Alt+click shows one map alone.</source>
        <translation>Дали пресликувањето учествува. Alt+клик прикажува само едно пресликување.</translation>
    </message>
    <message>
        <source>Whether the map is locked: then it cannot be edited, moved or deleted by mistake.</source>
        <translation>Дали пресликувањето е заклучено: тогаш не може по грешка да се измени, премести или избрише.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map, and the part of the attractor that the map makes.</source>
        <translation>Боја на пресликувањето, кога сликата е обоена по пресликувања, и делот од атракторот што тоа го создава.</translation>
    </message>
    <message>
        <source>Name of the map.</source>
        <translation>Име на пресликувањето.</translation>
    </message>
    <message>
        <source>Map %1 is shown alone.</source>
        <translation>Пресликувањето %1 е прикажано само.</translation>
    </message>
    <message>
        <source>Map %1 is locked.</source>
        <translation>Пресликувањето %1 е заклучено.</translation>
    </message>
    <message>
        <source>Map %1 is not locked.</source>
        <translation>Пресликувањето %1 не е заклучено.</translation>
    </message>
    <message>
        <source>Map %1 has no name. Double-click to name it.</source>
        <translation>Пресликувањето %1 нема име. Кликнете двапати за да го именувате.</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>заклучено</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>незаклучено</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>без име</translation>
    </message>
    <message>
        <source>Remove the name of map %1</source>
        <translation>Бришење на името на пресликувањето %1</translation>
    </message>
    <message>
        <source>Name map %1 “%2”</source>
        <translation>Именување на пресликувањето %1 „%2“</translation>
    </message>
</context>
<context>
    <name>view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation>Пресликувања</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Додај</translation>
    </message>
    <message>
        <source>Add a map of half the size</source>
        <translation>Додај пресликување со половина големина</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Удвои</translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation>Удвои ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Избриши</translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation>Избриши ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation>Помести нагоре</translation>
    </message>
    <message>
        <source>Move the selected maps up</source>
        <translation>Помести ги избраните пресликувања нагоре</translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation>Помести надолу</translation>
    </message>
    <message>
        <source>Move the selected maps down</source>
        <translation>Помести ги избраните пресликувања надолу</translation>
    </message>
    <message>
        <source>Copy Rows</source>
        <translation>Копирај редици</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f p, separated by tabs</source>
        <translation>Копирај ги избраните пресликувања како редици a b c d e f p, одделени со табулатори</translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation>Вметни наместо избраните</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 6 or 7 numbers from the clipboard</source>
        <translation>Замени ги избраните пресликувања со редици од 6 или 7 броја од таблата со исечоци</translation>
    </message>
    <message>
        <source>Paste as New Maps</source>
        <translation>Вметни како нови пресликувања</translation>
    </message>
    <message>
        <source>Add rows of 6 or 7 numbers from the clipboard as new maps</source>
        <translation>Додај редици од 6 или 7 броја од таблата со исечоци како нови пресликувања</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Впиши</translation>
    </message>
    <message>
        <source>Replace the code by the effective code; the cage is then at rest</source>
        <translation>Ефективниот код нека стане код; потоа кафезот е во мирување</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, for an even picture</source>
        <translation>Тежини пропорционални на плоштините на сликите, за сликата да биде рамномерна</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Тежини</translation>
    </message>
    <message>
        <source>Show columns: %1</source>
        <translation>Прикажи колони: %1</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Код</translation>
    </message>
    <message>
        <source>Show the coefficients a … f</source>
        <translation>Прикажи ги коефициентите a … f</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Својства</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Прикажи ги детерминантата, коефициентот на контракција и видот на секое пресликување</translation>
    </message>
    <message>
        <source>Show the maps as they act on the picture under the current cage</source>
        <translation>Прикажи ги пресликувањата онака како што дејствуваат на сликата под сегашниот кафез</translation>
    </message>
    <message>
        <source>Table of maps</source>
        <translation>Табела на пресликувањата</translation>
    </message>
    <message>
        <source>No maps: add one, or paste rows of 6 or 7 numbers.</source>
        <translation>Нема пресликувања: додајте едно или вметнете редици од 6 или 7 броја.</translation>
    </message>
    <message>
        <source>This entry could not be read. It is kept unchanged.</source>
        <translation>Овој запис не можеше да се прочита. Тој е задржан како што е.</translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation>Ред %1, колона %2: %3</translation>
    </message>
    <message>
        <source>Add a map</source>
        <translation>Додавање на пресликување</translation>
    </message>
    <message>
        <source>Reorder maps</source>
        <translation>Промена на редоследот на пресликувањата</translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation>Впишување на кафезот во кодот</translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation>Боја на пресликувањето %1</translation>
    </message>
    <message>
        <source>Each row is a map: it takes (x, y) to (a x + b y + e, c x + d y + f) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Секоја редица е пресликување: (x, y) се пресликува во (a x + b y + e, c x + d y + f), толку често колку што кажува неговата тежина p. За да промените некој број, кликнете двапати на него или почнете да пишувате; сликата го следи секое копче. Повлечете го бројот на редицата за да ја преместите.</translation>
    </message>
    <message>
        <source>Properties of the map</source>
        <translation>Својства на пресликувањето</translation>
    </message>
    <message>
        <source>det %1    ‖A‖ %2    %3</source>
        <translation>det %1    ‖A‖ %2    %3</translation>
    </message>
    <message>
        <source>Weights: %1</source>
        <translation>Тежини: %1</translation>
    </message>
    <message>
        <source>No maps: add one.</source>
        <translation>Нема пресликувања: додајте едно.</translation>
    </message>
    <message>
        <source>Weights in proportion to the volumes of the images, for an even picture</source>
        <translation>Тежини пропорционални на волумените на сликите, за сликата да биде рамномерна</translation>
    </message>
    <message>
        <source>Show the coefficients a … l</source>
        <translation>Прикажи ги коефициентите a … l</translation>
    </message>
    <message>
        <source>Each row is a map: it takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l) and is used in proportion to its weight p. Double-click a number or start typing to change it; the picture follows every keystroke. Drag the number of a row to move it.</source>
        <translation>Секоја редица е пресликување: (x, y, z) се пресликува во (a x + b y + c z + j, d x + e y + f z + k, g x + h y + i z + l), толку често колку што кажува неговата тежина p. За да промените некој број, кликнете двапати на него или почнете да пишувате; сликата го следи секое копче. Повлечете го бројот на редицата за да ја преместите.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Исечи</translation>
    </message>
    <message>
        <source>Move the selected maps to the clipboard</source>
        <translation>Премести ги избраните пресликувања во таблата со исечоци</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Преименувај</translation>
    </message>
    <message>
        <source>Give the current map a name</source>
        <translation>Дај му име на тековното пресликување</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Заклучи</translation>
    </message>
    <message>
        <source>Lock the selected maps against editing</source>
        <translation>Заштити ги избраните пресликувања од измени</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Соло</translation>
    </message>
    <message>
        <source>Show the current map alone; the file does not change</source>
        <translation>Прикажи го само тековното пресликување; датотеката не се менува</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Имиња</translation>
    </message>
    <message>
        <source>Show the names of the maps</source>
        <translation>Прикажи ги имињата на пресликувањата</translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f g h i j k l p, separated by tabs</source>
        <translation>Копирај ги избраните пресликувања како редици a b c d e f g h i j k l p, одделени со табулатори</translation>
    </message>
    <message>
        <source>Add rows of 12 or 13 numbers from the clipboard as new maps</source>
        <translation>Додај редици од 12 или 13 броја од таблата со исечоци како нови пресликувања</translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 12 or 13 numbers from the clipboard</source>
        <translation>Замени ги избраните пресликувања со редици од 12 или 13 броја од таблата со исечоци</translation>
    </message>
    <message>
        <source>Cut a map</source>
        <translation>Сечење на пресликување</translation>
    </message>
    <message>
        <source>Cut %1 maps</source>
        <translation>Сечење на %1 пресликувања</translation>
    </message>
    <message>
        <source>Effective</source>
        <translation>Ефективен</translation>
    </message>
    <message>
        <source>Select a map to see and edit it here.</source>
        <translation>Изберете пресликување за да го видите и уредите тука.</translation>
    </message>
    <message>
        <source>Map %1 only, of %2 selected    %3</source>
        <translation>Само пресликувањето %1, од избрани %2    %3</translation>
    </message>
    <message>
        <source>Show the coefficients of the maps</source>
        <translation>Прикажи ги коефициентите на пресликувањата</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Броеви на пресликувањата</translation>
    </message>
    <message>
        <source>Drag a number to move the map. A warning sign marks a map that does not contract, or that a negative weight switches off.</source>
        <translation>Повлечете го бројот за да го ставите пресликувањето на друго место. Ознаката предупредува на пресликување што не е контракција или што е исклучено со негативна тежина.</translation>
    </message>
</context>
<context>
    <name>view::MapsTable</name>
    <message>
        <source>Drag the name of a number left or right to change it in the current map: a tenth as fast with Shift, ten times as fast with Ctrl. The wheel does the same while the pointer is over the current cell. Drag the edge of a name to change the width of its column.</source>
        <translation>Повлечете го името на бројот налево или надесно за да го смените во тековното пресликување: десет пати побавно со Shift, десет пати побрзо со Ctrl. Тркалцето го прави истото додека покажувачот е над тековната ќелија. Повлечете го работ на името за да ја смените ширината на неговата колона.</translation>
    </message>
</context>
<context>
    <name>view::MapsTool</name>
    <message>
        <source>Move corner %1 of map %2</source>
        <translation>Помести го аголот %1 на пресликувањето %2</translation>
    </message>
    <message>
        <source>Move map %1</source>
        <translation>Помести го пресликувањето %1</translation>
    </message>
    <message>
        <source>Move %1 maps</source>
        <translation>Помести %1 пресликувања</translation>
    </message>
    <message>
        <source>Rotate map %1</source>
        <translation>Ротирај го пресликувањето %1</translation>
    </message>
    <message>
        <source>Rotate %1 maps</source>
        <translation>Ротирај %1 пресликувања</translation>
    </message>
    <message>
        <source>Scale map %1</source>
        <translation>Скалирај го пресликувањето %1</translation>
    </message>
    <message>
        <source>Scale %1 maps</source>
        <translation>Скалирај %1 пресликувања</translation>
    </message>
    <message>
        <source>Maps that are flat on the screen cannot be dragged. First open the cage or the maps.</source>
        <translation>Пресликувањата што се рамни на екранот не може да се влечат. Прво отворете го кафезот или пресликувањата.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Прво изберете пресликување.</translation>
    </message>
    <message>
        <source>There are too many maps to show them all. Zoom in to see the others.</source>
        <translation>Од толку многу пресликувања прикажани се само некои. Зголемете го приказот за останатите.</translation>
    </message>
</context>
<context>
    <name>view::MorphDialog</name>
    <message>
        <source>A fractal in the plane cannot become one in space.</source>
        <translation>Фрактал во рамнината не може да стане фрактал во просторот.</translation>
    </message>
    <message>
        <source>One of the two fractals has more than 256 maps.</source>
        <translation>Еден од двата фрактала има повеќе од 256 пресликувања.</translation>
    </message>
    <message>
        <source>The maps of one of the two fractals are linked.</source>
        <translation>Пресликувањата на еден од двата фрактали се поврзани.</translation>
    </message>
    <message>
        <source>A bent cage has no code to start from. Reset or bake it first.</source>
        <translation>Искривен кафез нема код од кој би се тргнало. Прво вратете го или вградете го.</translation>
    </message>
    <message>
        <source>One of the two fractals has no attractor.</source>
        <translation>Еден од двата фрактала нема атрактор.</translation>
    </message>
    <message>
        <source>Morph “%1”</source>
        <translation>Преобразба на „%1“</translation>
    </message>
    <message>
        <source>The entry of this file that the fractal becomes.</source>
        <translation>Записот од оваа датотека во кој преминува фракталот.</translation>
    </message>
    <message>
        <source>&amp;Becomes:</source>
        <translation>&amp;Преминува во:</translation>
    </message>
    <message>
        <source>&amp;Add Morph</source>
        <translation>&amp;Додај преобразба</translation>
    </message>
    <message>
        <source>Adds the morph to the file as an entry of its own, in one step that you can undo.</source>
        <translation>Ја додава преобразбата во датотеката како засебен запис, во еден чекор што може да се врати.</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>&amp;Ослободи ги паровите</translation>
    </message>
    <message>
        <source>Pairs all maps so that the total distance is shortest.</source>
        <translation>Ги пушта сите пресликувања по најкраткиот пат.</translation>
    </message>
    <message>
        <source>The morph at %1 %</source>
        <translation>Преобразбата на %1 %</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Оваа датотека нема друг фрактал со оваа димензија.</translation>
    </message>
</context>
<context>
    <name>view::MorphLines</name>
    <message>
        <source>Pairs of maps</source>
        <translation>Парови пресликувања</translation>
    </message>
    <message>
        <source>The maps of this fractal are on the left, those of the other one on the right. A line shows what a map becomes, and its thickness shows its share of the weight. Drag from a map to one in the other column to pin the pair, and again to unpin it. With the keyboard: choose a map with the arrow keys, press Space, go to the other map and press Space again. Del removes all pins of a map.</source>
        <translation>Лево се пресликувањата на овој фрактал, десно на другиот. Линијата покажува во што преминува пресликувањето, а нејзината дебелина колкав дел од тежината оди по тој пат. Повлечете од едно пресликување до друго во другата колона за да го прицврстите парот, и повторно за да го ослободите. Со тастатура: изберете пресликување со стрелките, притиснете празно место, појдете до другото и притиснете повторно. Del ги ослободува сите прицврстени парови на пресликувањето.</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>%1 (%2 %, pinned)</source>
        <translation>%1 (%2 %, прицврстено)</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Map %1 takes no part.</source>
        <translation>Пресликувањето %1 не учествува.</translation>
    </message>
    <message>
        <source>Map %1 becomes map %2.</source>
        <translation>Пресликувањето %1 преминува во пресликување %2.</translation>
    </message>
    <message>
        <source>Map %1 comes from map %2.</source>
        <translation>Пресликувањето %1 настанува од пресликување %2.</translation>
    </message>
</context>
<context>
    <name>view::MotionDialog</name>
    <message>
        <source>Change the motion “%1”</source>
        <translation>Промени го движењето „%1“</translation>
    </message>
    <message>
        <source>Motion: %1</source>
        <translation>Движење: %1</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Јачина</translation>
    </message>
    <message>
        <source>How far the branches swing at most, as an angle about their roots. A negative strength swings them the other way.</source>
        <translation>Колку најмногу се нишаат гранките, како агол околу местото каде што почнуваат. Со негативна јачина се нишаат обратно.</translation>
    </message>
    <message>
        <source>How much the maps swell and shrink at most. With a negative strength they shrink first.</source>
        <translation>Колку најмногу се шират и се собираат пресликувањата. Со негативна јачина прво се собираат.</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Вртења</translation>
    </message>
    <message>
        <source>Cycles of wave %1</source>
        <translation>Циклуси на бранот %1</translation>
    </message>
    <message>
        <source>Cycles</source>
        <translation>Циклуси</translation>
    </message>
    <message>
        <source>How many turns it makes during the animation. A negative number turns the other way.</source>
        <translation>Колку пати обиколува во текот на анимацијата. Со негативен број оди во обратна насока.</translation>
    </message>
    <message>
        <source>How many times it moves back and forth during the animation.</source>
        <translation>Колку пати оди напред-назад во текот на анимацијата.</translation>
    </message>
    <message>
        <source>Limit of the strength</source>
        <translation>Граница на јачината</translation>
    </message>
    <message>
        <source>Only %1 is used: with more there would be no attractor at some moment.</source>
        <translation>Се користи само %1: со повеќе во некој миг не би имало атрактор.</translation>
    </message>
</context>
<context>
    <name>view::MotionPage</name>
    <message>
        <source>Make Keys</source>
        <translation>Постави клучеви</translation>
    </message>
    <message>
        <source>Make a first key, and show the tracks</source>
        <translation>Постави прв клуч и прикажи ги патеките</translation>
    </message>
    <message>
        <source>Or set a key, move the playhead, and change the fractal.</source>
        <translation>Или поставете клуч, поместете ја главата за пуштање и изменете го фракталот.</translation>
    </message>
    <message>
        <source>Nothing moves yet. Choose a motion:</source>
        <translation>Сè уште ништо не се движи. Изберете движење:</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Варијанти на „%1“</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Варијанти</translation>
    </message>
    <message>
        <source>How strongly the variations differ</source>
        <translation>Колку се разликуваат варијантите</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Семе на случајните броеви</translation>
    </message>
    <message>
        <source>The same seed gives the same sheet again</source>
        <translation>Истото семе повторно ја дава истата страница</translation>
    </message>
    <message>
        <source>&amp;New Set</source>
        <translation>&amp;Нов избор</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Друга страница: следното семе</translation>
    </message>
    <message>
        <source>S&amp;trength:</source>
        <translation>&amp;Јачина:</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Семе:</translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation>Варијанта %1</translation>
    </message>
    <message>
        <source>The fractal in the middle replaces the one that you began with, in one step that you can undo.</source>
        <translation>Фракталот во средината го заменува оној со кој почнавте, во еден чекор што може да се врати.</translation>
    </message>
    <message>
        <source>Line of descent</source>
        <translation>Линија на потекло</translation>
    </message>
    <message>
        <source>Every parent so far, the oldest at the top. Select one to go back to it. Its descendants stay in the list until you choose another child of it.</source>
        <translation>Сите досегашни родители, најстариот горе. Изберете еден за да се вратите на него. Неговите потомци остануваат во списокот додека не изберете друго негово дете.</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>Изворник</translation>
    </message>
    <message>
        <source>Line of &amp;descent</source>
        <translation>&amp;Линија на потекло</translation>
    </message>
    <message>
        <source>How far the variations are from their parent</source>
        <translation>Колку варијантите се оддалечени од родителот</translation>
    </message>
    <message>
        <source>On the left, the variations stay close to their parent; on the right, they differ greatly.</source>
        <translation>Лево варијантите остануваат блиски до родителот, а десно многу се разликуваат.</translation>
    </message>
    <message>
        <source>Sha&amp;pe</source>
        <translation>&amp;Облик</translation>
    </message>
    <message>
        <source>Turn, stretch and move the maps</source>
        <translation>Заврти, растегни и помести ги пресликувањата</translation>
    </message>
    <message>
        <source>The maps are turned, stretched and moved, and occasionally one is added or removed. Locked maps, and maps that are off, stay as they are.</source>
        <translation>Пресликувањата се завртуваат, растегнуваат и поместуваат; понекогаш некое се додава или отстранува. Заклучените и исклучените пресликувања остануваат какви што се.</translation>
    </message>
    <message>
        <source>C&amp;olour</source>
        <translation>&amp;Боја</translation>
    </message>
    <message>
        <source>Try other colours</source>
        <translation>Пробај други бои</translation>
    </message>
    <message>
        <source>The hues of the palette, the plain colour and the colours of the maps change. The background and the meaning of the colours stay the same.</source>
        <translation>Палетата, едноставната боја и боите на пресликувањата го менуваат тонот. Заднината останува, како и она што го означуваат боите.</translation>
    </message>
    <message>
        <source>&amp;Weights</source>
        <translation>&amp;Тежини</translation>
    </message>
    <message>
        <source>Make some maps denser and others fainter</source>
        <translation>Некои пресликувања нека бидат погусти, а други побледи</translation>
    </message>
    <message>
        <source>The weights change at random and follow the sizes of the maps. Otherwise, each map keeps its weight. A solid in space does not depend on weights; a cloud does.</source>
        <translation>Тежините се менуваат случајно и ја следат големината на пресликувањата. Инаку секое пресликување ја задржува својата тежина. Тело во простор не зависи од тежините, а облак зависи.</translation>
    </message>
    <message>
        <source>What may change:</source>
        <translation>Што смее да се менува:</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Ништо</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension.</source>
        <translation>Оваа датотека нема друг фрактал со оваа димензија.</translation>
    </message>
    <message>
        <source>Mix the parent with another entry of this file</source>
        <translation>Измешај го родителот со друг запис од оваа датотека</translation>
    </message>
    <message>
        <source>The variations take some maps from the parent, some from the other entry, and some that are halfway between two corresponding maps. The checkboxes above determine whether shape, colour and weights are mixed. Every child has an attractor.</source>
        <translation>Варијантите земаат некои пресликувања од родителот, некои од другиот запис, а некои се меѓу две што си одговараат. Полињата погоре кажуваат дали се мешаат обликот, бојата и тежините. Секое дете има атрактор.</translation>
    </message>
    <message>
        <source>C&amp;ross with:</source>
        <translation>&amp;Вкрсти со:</translation>
    </message>
    <message>
        <source>The number from which the variations are generated. With the same parent, the same settings and the same seed you get the same sheet again.</source>
        <translation>Бројот од кој настануваат варијантите. Со ист родител, исти поставки и исто семе повторно ја добивате истата страница.</translation>
    </message>
    <message>
        <source>Shows other variations of the same parent, from the next seed.</source>
        <translation>Прикажува други варијанти на истиот родител, од следното семе.</translation>
    </message>
    <message>
        <source>Variation %1, not ready yet</source>
        <translation>Варијанта %1, сè уште не е готова</translation>
    </message>
    <message>
        <source>Generation %1</source>
        <translation>Генерација %1</translation>
    </message>
    <message>
        <source>Parent: the original</source>
        <translation>Родител: изворникот</translation>
    </message>
    <message>
        <source>Parent: generation %1</source>
        <translation>Родител: генерација %1</translation>
    </message>
    <message>
        <source>Nothing may change, so there are no variations. Tick at least one of the checkboxes.</source>
        <translation>Ништо не смее да се менува: нема варијанти. Означете барем едно поле.</translation>
    </message>
    <message>
        <source>All maps are locked and keep their weights: the variations differ only in colours and, occasionally, in an added map. Many look like their parent.</source>
        <translation>Сите пресликувања се заклучени и ги задржуваат тежините: варијантите се разликуваат само по боите и, понекогаш, по некое додадено пресликување. Многу од нив се исти како родителот.</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Користи го ова</translation>
    </message>
    <message>
        <source>Use a variation</source>
        <translation>Користи варијанта</translation>
    </message>
    <message>
        <source>Around the picture in the middle are its variations. Click one, or press Enter on it, to put it in the middle. Double-click one to use it at once.</source>
        <translation>Околу сликата во средината се нејзините варијации. Кликнете на една, или притиснете Enter на неа, за да дојде во средината. Двоен клик веднаш ја користи.</translation>
    </message>
    <message>
        <source>Click a picture to put it in the middle, with variations of its own around it.</source>
        <translation>Кликнете на слика за да дојде во средината, со свои варијации околу неа.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma, or an expression such as 1/2, sqrt(3)/6, cos(36°) or pi. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Број, со децимална точка или запирка, или израз како 1/2, sqrt(3)/6, cos(36°) или pi. Стрелките и тркалцето го менуваат: десет пати побрзо со Shift, десет пати побавно со Alt. Esc го враќа претходниот број.</translation>
    </message>
    <message>
        <source>An angle in degrees, with or without °, or an expression such as 360/7. An expression with pi, or with asin, acos, atan or atan2, is in radians and becomes degrees: pi/2 is 90. The arrow keys and the wheel change it: ten times as fast with Shift, a tenth as fast with Alt. Esc restores the previous number.</source>
        <translation>Агол во степени, со или без °, или израз како 360/7. Израз со pi, или со asin, acos, atan или atan2, е во радијани и се претвора во степени: pi/2 е 90. Стрелките и тркалцето го менуваат: десет пати побрзо со Shift, десет пати побавно со Alt. Esc го враќа претходниот број.</translation>
    </message>
    <message>
        <source>%1: the number stays as it was. %2</source>
        <translation>%1: бројот останува каков што беше. %2</translation>
    </message>
</context>
<context>
    <name>view::OrbitRows</name>
    <message>
        <source>Axis</source>
        <translation>Оска</translation>
    </message>
    <message>
        <source>The axis that the camera goes round.</source>
        <translation>Оската околу која обиколува камерата.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Наклон</translation>
    </message>
    <message>
        <source>How far the axis is tilted, like that of a globe. With 180° the camera goes round the other way.</source>
        <translation>Колку е наклонета оската, како кај глобус. Со 180° камерата обиколува во обратна насока.</translation>
    </message>
    <message>
        <source>Direction of the tilt</source>
        <translation>Насока на наклонот</translation>
    </message>
    <message>
        <source>Where the axis is tilted to: at 0° to the next one, X to Y, Y to Z and Z to X, and at 90° to the one after that.</source>
        <translation>Накаде е наклонета оската: на 0° кон следната, X кон Y, Y кон Z и Z кон X, а на 90° кон онаа по неа.</translation>
    </message>
    <message>
        <source>Centre of the fractal</source>
        <translation>Средина на фракталот</translation>
    </message>
    <message>
        <source>A point</source>
        <translation>Точка</translation>
    </message>
    <message>
        <source>Middle of the view</source>
        <translation>Средина на погледот</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Стожер</translation>
    </message>
    <message>
        <source>What stays in its place while everything turns.</source>
        <translation>Она што останува на место додека сè се врти.</translation>
    </message>
    <message>
        <source>%1 of the pivot</source>
        <translation>%1 на стожерот</translation>
    </message>
    <message>
        <source>The point that stays in its place.</source>
        <translation>Точката што останува на место.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Точка</translation>
    </message>
</context>
<context>
    <name>view::PaletteBrowser</name>
    <message>
        <source>Palettes</source>
        <translation>Палети</translation>
    </message>
    <message>
        <source>&amp;Use This Palette</source>
        <translation>&amp;Употреби ја оваа палета</translation>
    </message>
    <message>
        <source>Search palettes</source>
        <translation>Барај палети</translation>
    </message>
    <message>
        <source>&amp;Favourites Only</source>
        <translation>Само &amp;омилени</translation>
    </message>
    <message>
        <source>Shows only the palettes that you marked with the star.</source>
        <translation>Ги прикажува само палетите што сте ги означиле со ѕвездата.</translation>
    </message>
    <message>
        <source>Palettes made in Oklab, whose steps look equally large. Select one to see it on the fractal; double-click it to keep it.</source>
        <translation>Палети создадени во Oklab, чии чекори изгледаат еднакво големи. Изберете една за да ја видите на фракталот; двоен клик ја задржува.</translation>
    </message>
    <message>
        <source>The palette as it will be used</source>
        <translation>Палетата како што ќе се употреби</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>Омилена</translation>
    </message>
    <message>
        <source>Mark the selected palette as a favourite (Ctrl+D)</source>
        <translation>Означи ја избраната палета како омилена (Ctrl+D)</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Нијанса</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Поместување</translation>
    </message>
    <message>
        <source>&amp;Reversed</source>
        <translation>&amp;Обратно</translation>
    </message>
    <message>
        <source>%1, a favourite</source>
        <translation>%1, омилена</translation>
    </message>
    <message>
        <source>No favourites yet. Select a palette and press Ctrl+D.</source>
        <translation>Сè уште нема омилени. Изберете палета и притиснете Ctrl+D.</translation>
    </message>
    <message>
        <source>No matches</source>
        <translation>Нема резултати</translation>
    </message>
    <message>
        <source>Rotate all hues by this many degrees; the lightness stays the same</source>
        <translation>Заврти ги сите нијанси за толку степени; светлината останува иста</translation>
    </message>
    <message>
        <source>Start farther along the palette; the part before moves to the end</source>
        <translation>Почни подоцна во палетата; делот пред тоа оди на крајот</translation>
    </message>
    <message>
        <source>All palettes: search them, mark favourites, and adjust the one that is selected.</source>
        <translation>Сите палети: пребарувајте, означувајте омилени и приспособете ја избраната.</translation>
    </message>
</context>
<context>
    <name>view::PasteTableDialog</name>
    <message>
        <source>Paste maps</source>
        <translation>Вметнување пресликувања</translation>
    </message>
    <message>
        <source>Paste a Table</source>
        <translation>Вметнување табела</translation>
    </message>
    <message>
        <source>The rows do not say which column is which, and programs differ. Choose the order that gives the picture you expect in the background.</source>
        <translation>Редиците не кажуваат која колона е која, а програмите се разликуваат. Изберете го редоследот при кој сликата зад овој дијалог е онаа што ја очекувате.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Пресликувањата како што ќе бидат вметнати</translation>
    </message>
    <message>
        <source>The maps in the chosen order: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
        <translation>Пресликувањата според избраниот редослед: (x, y) се пресликува во (a x + b y + e, c x + d y + f).</translation>
    </message>
    <message>
        <source>What the maps do</source>
        <translation>Што прават пресликувањата</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Вметни</translation>
    </message>
    <message>
        <source>C&amp;olumns:</source>
        <translation>Ко&amp;лони:</translation>
    </message>
    <message>
        <source>There are no rows of 6 or 7 numbers.</source>
        <translation>Нема редици од 6 или 7 броја.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ред %1: %2</translation>
    </message>
    <message>
        <source>In this order every map contracts.</source>
        <translation>При овој редослед секое пресликување е контракција.</translation>
    </message>
    <message>
        <source>In this order these maps do not contract: %1. The columns may have a different meaning.</source>
        <translation>При овој редослед не се контракции пресликувањата: %1. Можеби колоните значат нешто друго.</translation>
    </message>
    <message>
        <source>Order of the Columns</source>
        <translation>Редослед на колоните</translation>
    </message>
    <message>
        <source>&amp;Use This Order</source>
        <translation>&amp;Користи го овој редослед</translation>
    </message>
    <message>
        <source>&amp;Keep as It Is</source>
        <translation>&amp;Остави вака</translation>
    </message>
</context>
<context>
    <name>view::PicturePaletteDialog</name>
    <message>
        <source>Palette from Picture</source>
        <translation>Палета од слика</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Бои</translation>
    </message>
    <message>
        <source>How many colours the palette has</source>
        <translation>Колку бои има палетата</translation>
    </message>
    <message>
        <source>Drag a line to take only the colours along it.</source>
        <translation>Повлечете линија за да ги земете само боите по неа.</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>&amp;Бои:</translation>
    </message>
    <message>
        <source>Makes a palette of the colours of a picture, or of those along a line in it.</source>
        <translation>Прави палета од боите на слика, или од оние по должина на линија во неа.</translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>Restart to change the language.</source>
        <translation>Стартувај повторно за да се смени јазикот.</translation>
    </message>
    <message>
        <source>Re&amp;open last files on startup</source>
        <translation>Повторно отвори ги &amp;последните датотеки на почеток</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Поставки</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Системски избор</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Јазик</translation>
    </message>
    <message>
        <source>The language of menus and messages. Files and numbers are the same in every language.</source>
        <translation>Јазикот на менијата и пораките. Датотеките и броевите се исти на секој јазик.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светла</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Темна</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Тема</translation>
    </message>
    <message>
        <source>The colours of windows and panels. The picture keeps its own colours.</source>
        <translation>Боите на прозорците и панелите. Сликата ги задржува своите.</translation>
    </message>
    <message>
        <source>Draft: 50 million points</source>
        <translation>Скица: 50 милиони точки</translation>
    </message>
    <message>
        <source>Good: 200 million points</source>
        <translation>Добро: 200 милиони точки</translation>
    </message>
    <message>
        <source>Fine: 1000 million points</source>
        <translation>Фино: 1000 милиони точки</translation>
    </message>
    <message>
        <source>The number of points drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Колку точки се цртаат додека ништо не се движи. Со повеќе точки сликата е помазна, а процесорот е подолго зафатен.</translation>
    </message>
    <message>
        <source>When this is on, Barycage reopens the files that were open when you closed it, each in its own window.</source>
        <translation>Ако е вклучено, Barycage ги отвора датотеките што биле отворени при затворањето, секоја во свој прозорец.</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>&amp;Јазик:</translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation>&amp;Тема:</translation>
    </message>
    <message>
        <source>Not saved yet: %1.</source>
        <translation>Сè уште не е зачувано: %1.</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Вртлива плоча</translation>
    </message>
    <message>
        <source>Trackball</source>
        <translation>Тракбол</translation>
    </message>
    <message>
        <source>How a drag turns a solid. On a turntable, vertical lines stay vertical. A trackball turns freely about the axes of the screen, even over the poles; to level the view again, look along an axis.</source>
        <translation>Како влечењето врти тело. На вртлива плоча, вертикалното останува вертикално. Тракболот врти слободно околу оските на екранот, и преку половите; за повторно да го исправите погледот, погледнете по должината на некоја оска.</translation>
    </message>
    <message>
        <source>Restart &amp;Now</source>
        <translation>Стартувај повторно се&amp;га</translation>
    </message>
    <message>
        <source>Closes all windows, asking about unsaved changes first, and opens the same files again in the new language.</source>
        <translation>Ги затвора сите прозорци, претходно прашува за незачуваните промени и повторно ги отвора истите датотеки на новиот јазик.</translation>
    </message>
    <message>
        <source>&amp;Keep the previous version of files</source>
        <translation>&amp;Чувај ја претходната верзија на датотеките</translation>
    </message>
    <message>
        <source>When this is on, the first time that you save a file after opening it, the version before stays beside it under the same name with “~” behind it, such as maple.ifs~.</source>
        <translation>Кога ова е вклучено, при првото зачувување по отворањето, претходната верзија останува покрај датотеката под истото име со „~“ на крајот, на пример maple.ifs~.</translation>
    </message>
    <message>
        <source>Play when opened</source>
        <translation>Пушти при отворање</translation>
    </message>
    <message>
        <source>Still until played</source>
        <translation>Мирно додека не се пушти</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Движење</translation>
    </message>
    <message>
        <source>Whether an entry that moves plays as soon as it is opened. When your desktop asks for less motion, the system default shows a still picture until you press Play.</source>
        <translation>Дали записот што се движи се пушта веднаш штом ќе се отвори. Кога работната околина бара помалку движење, системската поставка покажува мирна слика додека не притиснете Пушти.</translation>
    </message>
    <message>
        <source>&amp;Motion:</source>
        <translation>&amp;Движење:</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;Општо</translation>
    </message>
    <message>
        <source>S&amp;hortcuts</source>
        <translation>&amp;Кратенки</translation>
    </message>
    <message>
        <source>Resets every setting on this page to its default.</source>
        <translation>Ги враќа сите поставки на оваа страница на стандардните вредности.</translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation>Слика во мирување</translation>
    </message>
    <message>
        <source>Solids turn like</source>
        <translation>Телата се вртат како</translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation>&amp;Слика во мирување:</translation>
    </message>
    <message>
        <source>&amp;Solids turn like:</source>
        <translation>Телата се &amp;вртат како:</translation>
    </message>
    <message>
        <source>&amp;Names under the symbols of the toolbar</source>
        <translation>&amp;Имиња под симболите на лентата со алатки</translation>
    </message>
    <message>
        <source>When this is on, the toolbar shows the name of each command under its symbol.</source>
        <translation>Кога е вклучено, лентата со алатки го покажува името на секоја наредба под нејзиниот симбол.</translation>
    </message>
    <message>
        <source>The settings of windows and pictures, the commands of the toolbar, and the keys of commands.</source>
        <translation>Поставките на прозорците и сликите, наредбите на лентата со алатки и копчињата на наредбите.</translation>
    </message>
    <message>
        <source>Tool&amp;bar</source>
        <translation>&amp;Лента со алатки</translation>
    </message>
</context>
<context>
    <name>view::ProblemsModel</name>
    <message>
        <source>Error</source>
        <translation>Грешка</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Предупредување</translation>
    </message>
    <message>
        <source>Line:column</source>
        <translation>Ред:колона</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Запис</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Што е најдено</translation>
    </message>
</context>
<context>
    <name>view::ProblemsPanel</name>
    <message>
        <source>file</source>
        <translation>датотека</translation>
    </message>
    <message>
        <source>Problems found while reading</source>
        <translation>Проблеми најдени при читањето</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Проблеми</translation>
    </message>
    <message>
        <source>Select a line to show its entry.</source>
        <translation>Изберете ред за да се прикаже записот на кој се однесува.</translation>
    </message>
    <message>
        <source>Number of problems</source>
        <translation>Број на проблеми</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копирај</translation>
    </message>
    <message>
        <source>Copy the selected problems as text.</source>
        <translation>Копирај ги избраните проблеми како текст.</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Избери &amp;сѐ</translation>
    </message>
    <message>
        <source>Select all problems.</source>
        <translation>Избери ги сите проблеми.</translation>
    </message>
    <message>
        <source>1 problem was found while reading.</source>
        <translation>При читањето е најден 1 проблем.</translation>
    </message>
    <message numerus="yes">
        <source>%n problems were found while reading.</source>
        <translation>
            <numerusform>При читањето е најден %n проблем.</numerusform>
            <numerusform>При читањето се најдени %n проблеми.</numerusform>
            <numerusform>При читањето се најдени %n проблеми.</numerusform>
        </translation>
    </message>
    <message>
        <source>Text that could not be read is kept unchanged.</source>
        <translation>Она што не можеше да се прочита е задржано како што е.</translation>
    </message>
    <message>
        <source>No problems: every entry was read.</source>
        <translation>Нема проблеми: сите записи се прочитани.</translation>
    </message>
    <message>
        <source>The problems found while reading the file, with line and column. Double-click a line to go to its entry.</source>
        <translation>Проблемите најдени при читањето на датотеката, со ред и колона. Кликнете двапати на некој ред за да отидете на неговиот запис.</translation>
    </message>
</context>
<context>
    <name>view::RandomDialog</name>
    <message>
        <source>Random Fractals</source>
        <translation>Случајни фрактали</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>&amp;Додај во датотеката</translation>
    </message>
    <message>
        <source>Adds the selected one as an entry of its own, in one step that you can undo.</source>
        <translation>Го додава избраниот како засебен запис, во еден чекор што може да се врати.</translation>
    </message>
    <message>
        <source>Random fractals</source>
        <translation>Случајни фрактали</translation>
    </message>
    <message>
        <source>Select one and confirm, or double-click it: it is added to the file, in one step that you can undo.</source>
        <translation>Изберете еден и потврдете, или кликнете двапати на него: се додава во датотеката, во еден чекор што може да се врати.</translation>
    </message>
    <message>
        <source>In the plane</source>
        <translation>Во рамнина</translation>
    </message>
    <message>
        <source>In space</source>
        <translation>Во простор</translation>
    </message>
    <message>
        <source>Plane or space</source>
        <translation>Рамнина или простор</translation>
    </message>
    <message>
        <source>Make systems in the plane or in space</source>
        <translation>Создавај системи во рамнина или во простор</translation>
    </message>
    <message>
        <source>In the plane, the contraction of the maps follows a rule that makes the fractal fill its view. In space there is no such rule: the two larger scale factors of each map follow that of the plane, and the third is smaller.</source>
        <translation>Во рамнина, стегањето на пресликувањата следи правило според кое фракталот го исполнува приказот. Во простор нема такво правило: двете поголеми растегнувања на секое пресликување го следат она од рамнината, а третото е помало.</translation>
    </message>
    <message>
        <source>How many maps the systems have</source>
        <translation>Колку пресликувања имаат системите</translation>
    </message>
    <message>
        <source>How many maps each system lists. With a symmetry, each of them also acts rotated or mirrored.</source>
        <translation>Колку пресликувања има во списокот на секој систем. Со симетрија, секое дејствува и завртено или огледално.</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Симетрија</translation>
    </message>
    <message>
        <source>Make systems that are symmetric about the origin</source>
        <translation>Создавај системи симетрични околу почетокот</translation>
    </message>
    <message>
        <source>Each map also acts rotated or mirrored about the origin, so the fractal is symmetric. You can change the symmetry later in the Maps panel. The tetrahedral, octahedral and icosahedral groups exist in space only.</source>
        <translation>Секое пресликување дејствува и завртено или огледално околу почетокот, па фракталот е симетричен. Симетријата може подоцна да ја смените во панелот „Пресликувања“. Тетраедарската, октаедарската и икосаедарската група постојат само во простор.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Ред на симетријата</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Колку пати се повторува фракталот во еден цел круг</translation>
    </message>
    <message>
        <source>A rotation of order 5 repeats the fractal five times in a full turn.</source>
        <translation>Ротација од ред 5 го повторува фракталот пет пати во еден цел круг.</translation>
    </message>
    <message>
        <source>&amp;Maps:</source>
        <translation>&amp;Пресликувања:</translation>
    </message>
    <message>
        <source>S&amp;ymmetry:</source>
        <translation>С&amp;иметрија:</translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation>Семе на случајните броеви</translation>
    </message>
    <message>
        <source>The same seed gives the same sheet again</source>
        <translation>Истото семе повторно ја дава истата страница</translation>
    </message>
    <message>
        <source>The number from which the systems are generated. With the same settings and the same seed you get the same sheet again.</source>
        <translation>Бројот од кој настануваат системите. Со исти поставки и исто семе повторно ја добивате истата страница.</translation>
    </message>
    <message>
        <source>&amp;New Set</source>
        <translation>&amp;Нов избор</translation>
    </message>
    <message>
        <source>Show another sheet, from the next seed</source>
        <translation>Друга страница: следното семе</translation>
    </message>
    <message>
        <source>Shows other systems of the same kind, from the next seed.</source>
        <translation>Прикажува други системи од ист вид, од следното семе.</translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation>&amp;Семе:</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Кои било</translation>
    </message>
    <message>
        <source>Fractal %1</source>
        <translation>Фрактал %1</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Додавање на случаен фрактал</translation>
    </message>
</context>
<context>
    <name>view::SaveViewDialog</name>
    <message>
        <source>Save View</source>
        <translation>Зачувај поглед</translation>
    </message>
    <message>
        <source>Name of the view</source>
        <translation>Име на погледот</translation>
    </message>
    <message>
        <source>The name under which the view is listed in View, Saved Views, beside the zoom and in the export dialogs.</source>
        <translation>Името под кое погледот е наведен во „Приказ“, „Зачувани погледи“, покрај зумот и во дијалозите за извоз.</translation>
    </message>
    <message>
        <source>&amp;Name of the view:</source>
        <translation>&amp;Име на погледот:</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Забелешка</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Зачувај</translation>
    </message>
    <message>
        <source>View %1</source>
        <translation>Поглед %1</translation>
    </message>
    <message>
        <source>A fractal can have at most %1 saved views. Delete one first.</source>
        <translation>Фрактал може да има најмногу %1 зачувани погледи. Прво избришете еден.</translation>
    </message>
    <message>
        <source>Replaces the view of this name.</source>
        <translation>Го заменува погледот со ова име.</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Се зачувува како „%1“.</translation>
    </message>
    <message>
        <source>Keeps the view with the fractal: one step of the history. A view of the same name is replaced.</source>
        <translation>Го зачувува погледот со фракталот: еден чекор во историјата. Поглед со исто име се заменува.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Замени</translation>
    </message>
</context>
<context>
    <name>view::SavedViewsDialog</name>
    <message>
        <source>Saved Views</source>
        <translation>Зачувани погледи</translation>
    </message>
    <message>
        <source>Saved views</source>
        <translation>Зачувани погледи</translation>
    </message>
    <message>
        <source>The views of this fractal. Double-click one to go to it, press F2 to rename it.</source>
        <translation>Погледите на овој фрактал. Кликнете двапати на еден за да одите до него, притиснете F2 за да го преименувате.</translation>
    </message>
    <message>
        <source>&amp;Go To</source>
        <translation>&amp;Оди до</translation>
    </message>
    <message>
        <source>Shows this view on the canvas.</source>
        <translation>Го прикажува овој поглед на платното.</translation>
    </message>
    <message>
        <source>&amp;Update</source>
        <translation>&amp;Ажурирај</translation>
    </message>
    <message>
        <source>Replaces it by the current view of the canvas.</source>
        <translation>Го заменува со она што платното сега го покажува.</translation>
    </message>
    <message>
        <source>Update the view “%1”</source>
        <translation>Ажурирање на погледот „%1“</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Преименувај</translation>
    </message>
    <message>
        <source>Gives the view another name.</source>
        <translation>Му дава друго име на погледот.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Deletes the view; the fractal stays as it is.</source>
        <translation>Го брише погледот; фракталот останува каков што е.</translation>
    </message>
    <message>
        <source>Delete the view “%1”</source>
        <translation>Бришење на погледот „%1“</translation>
    </message>
    <message>
        <source>Rename the view “%1” to “%2”</source>
        <translation>Преименување на погледот „%1“ во „%2“</translation>
    </message>
</context>
<context>
    <name>view::ShadowTool</name>
    <message>
        <source>Turn the shadow</source>
        <translation>Заврти ја сенката</translation>
    </message>
</context>
<context>
    <name>view::Shortcuts</name>
    <message>
        <source>“%1” is used on the canvas and in fields. Choose other keys.</source>
        <translation>„%1“ се користи на платното и во полињата. Изберете други копчиња.</translation>
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
        <translation>На платното</translation>
    </message>
    <message>
        <source>Move a vertex, an edge, the whole cage</source>
        <translation>Поместување на теме, страна или целиот кафез</translation>
    </message>
    <message>
        <source>drag it</source>
        <translation>со влечење</translation>
    </message>
    <message>
        <source>Rotate about the pivot</source>
        <translation>Ротирање околу стожерот</translation>
    </message>
    <message>
        <source>Ctrl + drag, or the round handle</source>
        <translation>Ctrl + влечење, или кружната рачка</translation>
    </message>
    <message>
        <source>Scale about the pivot</source>
        <translation>Скалирање во однос на стожерот</translation>
    </message>
    <message>
        <source>Alt + drag, or the square handle</source>
        <translation>Alt + влечење, или квадратната рачка</translation>
    </message>
    <message>
        <source>Move or scale along one axis, rotate in steps of 15°</source>
        <translation>Поместување или скалирање по една оска, вртење во чекори од 15°</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Shift при влечењето</translation>
    </message>
    <message>
        <source>Cancel the drag</source>
        <translation>Откажување на влечењето</translation>
    </message>
    <message>
        <source>Esc while dragging</source>
        <translation>Esc при влечењето</translation>
    </message>
    <message>
        <source>Next or previous handle</source>
        <translation>Следна или претходна рачка</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Shift+Tab</translation>
    </message>
    <message>
        <source>Nudge the handle</source>
        <translation>Мало поместување на рачката</translation>
    </message>
    <message>
        <source>arrow keys; Shift ×10, Alt ×0.1</source>
        <translation>стрелките; Shift ×10, Alt ×0.1</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Зумирање кај покажувачот</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>тркалцето</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Поместување на приказот</translation>
    </message>
    <message>
        <source>middle drag, or Space + drag</source>
        <translation>влечење со средното копче, или Space + влечење</translation>
    </message>
    <message>
        <source>Keyboard and Mouse</source>
        <translation>Тастатура и глувче</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Пребарај</translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation>Пребарај ги кратенките</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Кратенки</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Што прави</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Како</translation>
    </message>
    <message>
        <source>Shows only the lines that contain these words.</source>
        <translation>Ги прикажува само редовите што ги содржат овие зборови.</translation>
    </message>
    <message>
        <source>All keys and mouse gestures, and what they do.</source>
        <translation>Што прави секое копче и секое движење на глувчето.</translation>
    </message>
    <message>
        <source>Shift or Ctrl + click</source>
        <translation>Shift или Ctrl + клик</translation>
    </message>
    <message>
        <source>Select map 1 … 9, all maps</source>
        <translation>Избери пресликување 1 … 9, сите пресликувања</translation>
    </message>
    <message>
        <source>Alt + digit, Ctrl+A</source>
        <translation>Alt + цифра, Ctrl+A</translation>
    </message>
    <message>
        <source>Select a deeper or a larger branch</source>
        <translation>Подлабока или поголема гранка</translation>
    </message>
    <message>
        <source>Shift + wheel, Page Down, Page Up</source>
        <translation>Shift + тркалце, Page Down, Page Up</translation>
    </message>
    <message>
        <source>Select the maps, or the vertices, in a rectangle</source>
        <translation>Избери ги пресликувањата, или темињата, во правоаголник</translation>
    </message>
    <message>
        <source>drag from the empty canvas; Shift adds</source>
        <translation>влечење од празното платно; Shift додава</translation>
    </message>
    <message>
        <source>Add a map or vertex to the selection, or remove it</source>
        <translation>Избери едно пресликување или теме повеќе или помалку</translation>
    </message>
    <message>
        <source>Delete the selected vertices or maps</source>
        <translation>Избриши ги избраните темиња или пресликувања</translation>
    </message>
    <message>
        <source>Insert a vertex on an edge, duplicate the selected maps</source>
        <translation>Вметни теме на страна, удвои ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Remove the last vertex while defining a triangle</source>
        <translation>Врати го последното теме додека се задава триаголник</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
    <message>
        <source>Select another stop</source>
        <translation>Избери друг маркер</translation>
    </message>
    <message>
        <source>Page Up, Page Down, Home, End, or Ctrl + Left, Right</source>
        <translation>Page Up, Page Down, Home, End или Ctrl + лево, десно</translation>
    </message>
    <message>
        <source>Move the stop</source>
        <translation>Помести го маркерот</translation>
    </message>
    <message>
        <source>Left, Right; Shift ×10</source>
        <translation>Лево, десно; Shift ×10</translation>
    </message>
    <message>
        <source>Add a stop</source>
        <translation>Додај маркер</translation>
    </message>
    <message>
        <source>Ins or +, or double-click</source>
        <translation>Ins или +, или двоен клик</translation>
    </message>
    <message>
        <source>Delete the stop</source>
        <translation>Избриши го маркерот</translation>
    </message>
    <message>
        <source>Del or Backspace</source>
        <translation>Del или Backspace</translation>
    </message>
    <message>
        <source>Enter or Space, or double-click it</source>
        <translation>Enter или Space, или двоен клик на него</translation>
    </message>
    <message>
        <source>Cancel the change</source>
        <translation>Врати ја промената</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>On the strip of the gradient</source>
        <translation>На лентата на преливот</translation>
    </message>
    <message>
        <source>Next or previous part of the window</source>
        <translation>Следен или претходен дел од прозорецот</translation>
    </message>
    <message>
        <source>F6, Shift+F6</source>
        <translation>F6, Shift+F6</translation>
    </message>
    <message>
        <source>Play or stop the animation</source>
        <translation>Пушти ја или запри ја анимацијата</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>Move the playhead</source>
        <translation>Помести ја главата за пуштање</translation>
    </message>
    <message>
        <source>drag in the ruler, or Left, Right</source>
        <translation>влечење по линијарот, или Left, Right</translation>
    </message>
    <message>
        <source>Previous or next key</source>
        <translation>Претходен или следен клуч</translation>
    </message>
    <message>
        <source>Ctrl + Left, Right</source>
        <translation>Ctrl + Left, Right</translation>
    </message>
    <message>
        <source>First or last frame</source>
        <translation>Прв или последен кадар</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Home, End</translation>
    </message>
    <message>
        <source>Select another row</source>
        <translation>Избери друг ред</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Up, Down</translation>
    </message>
    <message>
        <source>Make or delete the key of the row</source>
        <translation>Постави го или избриши го клучот на редот</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Move the selected keys</source>
        <translation>Помести ги избраните клучеви</translation>
    </message>
    <message>
        <source>drag them</source>
        <translation>влечење</translation>
    </message>
    <message>
        <source>Move all later keys of the row, too</source>
        <translation>Помести ги и сите подоцнежни клучеви на редот</translation>
    </message>
    <message>
        <source>Alt while dragging</source>
        <translation>Alt при влечење</translation>
    </message>
    <message>
        <source>Copy the keys</source>
        <translation>Копирај ги клучевите</translation>
    </message>
    <message>
        <source>Ctrl while dragging</source>
        <translation>Ctrl при влечење</translation>
    </message>
    <message>
        <source>Copy, paste, select all keys</source>
        <translation>Копирај, вметни, избери ги сите клучеви</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V, Ctrl+A</source>
        <translation>Ctrl+C, Ctrl+V, Ctrl+A</translation>
    </message>
    <message>
        <source>Delete the selected keys, or the motion</source>
        <translation>Избриши ги избраните клучеви или движењето</translation>
    </message>
    <message>
        <source>Choose how a key leads to the next</source>
        <translation>Избери како клуч води до следниот</translation>
    </message>
    <message>
        <source>right-click it</source>
        <translation>десен клик на него</translation>
    </message>
    <message>
        <source>Zoom the ruler</source>
        <translation>Зумирај го линијарот</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + тркалце</translation>
    </message>
    <message>
        <source>In the timeline</source>
        <translation>Во временската лента</translation>
    </message>
    <message>
        <source>In the table of maps</source>
        <translation>Во табелата со пресликувања</translation>
    </message>
    <message>
        <source>Show one map alone, or all of them again</source>
        <translation>Прикажи само едно пресликување, или пак сите</translation>
    </message>
    <message>
        <source>Alt + click on its eye</source>
        <translation>Alt + клик на неговото око</translation>
    </message>
    <message>
        <source>Rotate the view</source>
        <translation>Вртење на погледот</translation>
    </message>
    <message>
        <source>Ctrl + Shift + wheel</source>
        <translation>Ctrl + Shift + тркалце</translation>
    </message>
    <message>
        <source>Change the stop colour</source>
        <translation>Смени ја бојата на маркерот</translation>
    </message>
    <message>
        <source>Ball of axes, after the last handle: choose an end</source>
        <translation>Топка на оските, по последната рачка: избор на крај</translation>
    </message>
    <message>
        <source>arrow keys</source>
        <translation>стрелките</translation>
    </message>
    <message>
        <source>Ball of axes: look along the axis, then from behind</source>
        <translation>Топка на оските: поглед по оската, потоа од назад</translation>
    </message>
    <message>
        <source>Enter or Space</source>
        <translation>Enter или Space</translation>
    </message>
    <message>
        <source>Ball of axes: turn the view, return to the canvas</source>
        <translation>Топка на оските: вртење на погледот, враќање на платното</translation>
    </message>
    <message>
        <source>Shift + arrow keys, Esc</source>
        <translation>Shift + стрелките, Esc</translation>
    </message>
</context>
<context>
    <name>view::ShortcutsPage</name>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Стандардно</translation>
    </message>
    <message>
        <source>S&amp;wap</source>
        <translation>&amp;Замени</translation>
    </message>
    <message>
        <source>Find a command or keys</source>
        <translation>Најди наредба или копчиња</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Наредби</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Наредба</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Кратенка</translation>
    </message>
    <message>
        <source>&amp;Shortcut:</source>
        <translation>К&amp;ратенка:</translation>
    </message>
    <message>
        <source>Press the keys that the selected command is to have. Tab goes on to the next field.</source>
        <translation>Притиснете ги копчињата што треба да ги има избраната наредба. Tab води на следното поле.</translation>
    </message>
    <message>
        <source>Takes the keys from the selected command.</source>
        <translation>Ги отстранува копчињата од избраната наредба.</translation>
    </message>
    <message>
        <source>Gives the selected command the keys that it has without your choice.</source>
        <translation>На избраната наредба ѝ ги враќа почетните копчиња.</translation>
    </message>
    <message>
        <source>Gives these keys to the selected command, and its present ones to the other.</source>
        <translation>Овие копчиња ѝ ги дава на избраната наредба, а нејзините на другата.</translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”.</source>
        <translation>„%1“ ѝ припаѓа на „%2“.</translation>
    </message>
    <message>
        <source>“%1” has no keys now.</source>
        <translation>„%1“ сега нема копчиња.</translation>
    </message>
    <message>
        <source>“%1” has “%2” now.</source>
        <translation>„%1“ сега има „%2“.</translation>
    </message>
    <message>
        <source>Cl&amp;ear</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Show only the commands whose name, synonyms or keys begin with these words.</source>
        <translation>Ги прикажува само наредбите чие име, синоними или копчиња почнуваат со овие зборови.</translation>
    </message>
    <message>
        <source>The commands of the menus and their keys; your own are bold. Select one to change its keys.</source>
        <translation>Наредбите од менијата и нивните копчиња; вашите се задебелени. Изберете една за да ѝ ги смените копчињата.</translation>
    </message>
</context>
<context>
    <name>view::SliceRows</name>
    <message>
        <source>Slice</source>
        <translation>Пресек</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Цело</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Половина</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Положба на рамнината</translation>
    </message>
    <message>
        <source>Thickness of the slice</source>
        <translation>Дебелина на слојот</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Помести го пресекот</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Положба</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Дебелина</translation>
    </message>
    <message>
        <source>Direction of the plane</source>
        <translation>Насока на рамнината</translation>
    </message>
    <message>
        <source>Sets the plane perpendicular to an axis or the diagonal; type any other normal in the fields below.</source>
        <translation>Ја поставува рамнината напречно на оска или на дијагоналата; полињата подолу примаат која било нормала.</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>Напречно на X</translation>
    </message>
    <message>
        <source>Across Y</source>
        <translation>Напречно на Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>Напречно на Z</translation>
    </message>
    <message>
        <source>Across the diagonal</source>
        <translation>Напречно на дијагоналата</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Како што е внесено</translation>
    </message>
    <message>
        <source>Turn the Slice</source>
        <translation>Заврти го пресекот</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Насока</translation>
    </message>
    <message>
        <source>x of the normal</source>
        <translation>x на нормалата</translation>
    </message>
    <message>
        <source>y of the normal</source>
        <translation>y на нормалата</translation>
    </message>
    <message>
        <source>z of the normal</source>
        <translation>z на нормалата</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Нормала</translation>
    </message>
    <message>
        <source>Show the Whole Solid</source>
        <translation>Прикажи го целото тело</translation>
    </message>
    <message>
        <source>Cut the Solid</source>
        <translation>Пресечи го телото</translation>
    </message>
    <message>
        <source>Cuts the picture open by hiding everything in front of a plane, or everything outside a slice. Drag the plane by the handle at its centre.</source>
        <translation>Ја отвора сликата: се крие сè што е пред една рамнина или сè што е надвор од еден слој. Влечете ја рамнината за рачката во средината.</translation>
    </message>
    <message>
        <source>The direction perpendicular to the plane</source>
        <translation>Насоката нормална на рамнината</translation>
    </message>
    <message>
        <source>Thin slice</source>
        <translation>Тенок слој</translation>
    </message>
</context>
<context>
    <name>view::SnapshotDelegate</name>
    <message>
        <source>Name of the snapshot</source>
        <translation>Име на снимката</translation>
    </message>
</context>
<context>
    <name>view::SnapshotLook</name>
    <message>
        <source>There is no snapshot to compare with yet. Take one first: Edit, Take Snapshot.</source>
        <translation>Сѐ уште нема снимка за споредба. Прво направете една: „Уреди“, „Направи снимка“.</translation>
    </message>
    <message>
        <source>Nothing has changed since “%1”.</source>
        <translation>Ништо не е сменето од „%1“.</translation>
    </message>
    <message>
        <source>“%1” cannot be compared: one is in the plane, the other in space. Click the snapshot to restore it.</source>
        <translation>„%1“ не може да се спореди: едното е во рамнината, другото во просторот. Кликнете на снимката за да ја вратите.</translation>
    </message>
    <message>
        <source>This is “%1”. Esc returns to the fractal.</source>
        <translation>Ова е „%1“. Esc се враќа кон фракталот.</translation>
    </message>
</context>
<context>
    <name>view::Snapshots</name>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Запис што не можеше да се прочита нема снимки.</translation>
    </message>
    <message>
        <source>“%1” is the same as the fractal.</source>
        <translation>„%1“ е веќе исто.</translation>
    </message>
    <message>
        <source>Snapshot %1</source>
        <translation>Снимка %1</translation>
    </message>
    <message>
        <source>Restore “%1”</source>
        <translation>Враќање на „%1“</translation>
    </message>
    <message>
        <source>“%1” was deleted. To bring it back, use the menu of the panel.</source>
        <translation>„%1“ е избришана. Менито на панелот ја враќа.</translation>
    </message>
    <message>
        <source>Add “%1” as an entry</source>
        <translation>Додавање на „%1“ како запис</translation>
    </message>
    <message>
        <source>Added to the file as the entry “%1”.</source>
        <translation>Додадена во датотеката како запис „%1“.</translation>
    </message>
    <message>
        <source>%1 of “%2”</source>
        <comment>snapshot, entry</comment>
        <translation>%1 од „%2“</translation>
    </message>
</context>
<context>
    <name>view::SnapshotsPanel</name>
    <message>
        <source>Snapshots</source>
        <translation>Снимки</translation>
    </message>
    <message>
        <source>Snapshots of the fractal</source>
        <translation>Снимки на фракталот</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Врати</translation>
    </message>
    <message>
        <source>Restore the fractal to this snapshot.</source>
        <translation>Направи го фракталот каков што беше на оваа снимка.</translation>
    </message>
    <message>
        <source>&amp;Add as Entry</source>
        <translation>&amp;Додај како запис</translation>
    </message>
    <message>
        <source>Add the snapshot to the file as an entry of its own, after this one.</source>
        <translation>Додај ја снимката во датотеката како посебен запис, зад овој.</translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation>&amp;Преименувај</translation>
    </message>
    <message>
        <source>Give the snapshot another name.</source>
        <translation>Дај ѝ друго име на снимката.</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Delete the snapshot; the fractal stays as it is.</source>
        <translation>Избриши ја снимката; фракталот останува каков што е.</translation>
    </message>
    <message>
        <source>&amp;Bring Back</source>
        <translation>Вра&amp;ти</translation>
    </message>
    <message>
        <source>Bring back the snapshot that was deleted last.</source>
        <translation>Врати ја последно избришаната снимка.</translation>
    </message>
    <message>
        <source>shown on the canvas</source>
        <translation>прикажана на платното</translation>
    </message>
    <message>
        <source>the one to compare with</source>
        <translation>онаа со која се споредува</translation>
    </message>
    <message>
        <source>&amp;Bring Back “%1”</source>
        <translation>Вра&amp;ти ја „%1“</translation>
    </message>
    <message>
        <source>No snapshots of this fractal yet. Press %1 to keep its state, change it, and press %2 to compare.</source>
        <translation>Сѐ уште нема снимки од овој фрактал. Притиснете %1 за да ја зачувате состојбата, сменете го, па притиснете %2 за да споредите.</translation>
    </message>
    <message>
        <source>An entry that could not be read has no snapshots.</source>
        <translation>Запис што не можеше да се прочита нема снимки.</translation>
    </message>
    <message>
        <source>Click a snapshot to restore it; undo goes back. The arrow keys or a right click select the one to compare with. F2 renames it, Del deletes it.</source>
        <translation>Кликнете на снимка за да ја вратите; враќањето го поништува тоа. Со стрелките или со десен клик се избира онаа со која се споредува. F2 ја преименува, Del ја брише.</translation>
    </message>
    <message>
        <source>States of this fractal that you kept. Click one to restore it, as one step of the history. The frame marks the snapshot that the canvas shows. The B marks the selected snapshot, the one to compare with: the newest, until you select another one with the arrow keys or a right click. Snapshots last until the file is closed; Add as Entry keeps one in the file.</source>
        <translation>Состојби на овој фрактал што сте ги зачувале. Кликнете на една за да ја вратите: еден чекор во историјата. Врамената е онаа што ја покажува платното. Онаа што носи B е избрана и со неа се споредува: најновата, додека не изберете друга со стрелките или со десен клик. Снимките траат додека не се затвори датотеката; „Додај како запис“ зачувува една во датотеката.</translation>
    </message>
</context>
<context>
    <name>view::SoloMap</name>
    <message>
        <source>One map is shown alone. Choose Solo again to show all; the file does not change.</source>
        <translation>Прикажано е само едно пресликување. Изберете повторно Соло за да се видат сите; датотеката не се менува.</translation>
    </message>
</context>
<context>
    <name>view::SpaceExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Извези „%1“</translation>
    </message>
    <message>
        <source>OpenSCAD program (.scad)</source>
        <translation>Програма за OpenSCAD (.scad)</translation>
    </message>
    <message>
        <source>A picture as the camera shows it, a watertight mesh that contains the attractor, or the maps as a program for OpenSCAD.</source>
        <translation>Слика каква што ја покажува камерата, затворено тело што го содржи атракторот, или пресликувањата како програма за OpenSCAD.</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Формат:</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the file.</source>
        <translation>Прашува за името на датотеката и ја запишува.</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>&amp;Големина:</translation>
    </message>
    <message>
        <source>Computes this many cells along each side of a pixel, for smoother edges.</source>
        <translation>Црта толку пиксели по секоја страна на еден: помазни рабови.</translation>
    </message>
    <message>
        <source>S&amp;upersampling:</source>
        <translation>&amp;Суперсемплирање:</translation>
    </message>
    <message>
        <source>Bits per channel. Depths always have 16.</source>
        <translation>Битови за секој канал. Длабочините секогаш имаат 16.</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>&amp;Проѕирна позадина</translation>
    </message>
    <message>
        <source>Makes the surroundings of the solid transparent.</source>
        <translation>Го изоставува она што е околу телото.</translation>
    </message>
    <message>
        <source>For both eyes: two pictures side by side, or one in red and cyan.</source>
        <translation>За двете очи: две слики една до друга, или една во црвено и цијан.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The longest side of the mesh.</source>
        <translation>Најдолгата страна на телото.</translation>
    </message>
    <message>
        <source>&amp;Longest side:</source>
        <translation>Најдолга ст&amp;рана:</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>Резолу&amp;ција:</translation>
    </message>
    <message>
        <source>Thinner parts are thickened to this, so that they can be printed.</source>
        <translation>Потенките делови се здебелуваат дотолку за да може да се печатат.</translation>
    </message>
    <message>
        <source>Smallest &amp;wall:</source>
        <translation>Најмал &amp;ѕид:</translation>
    </message>
    <message>
        <source>Fill closed ca&amp;vities</source>
        <translation>Пополни затворени &amp;шуплини</translation>
    </message>
    <message>
        <source>Fills spaces that are closed off from the outside.</source>
        <translation>Го пополнува она што е затворено однадвор.</translation>
    </message>
    <message>
        <source>One multmatrix for each map; open it in OpenSCAD to render it.</source>
        <translation>Еден multmatrix за секое пресликување; отворете го во OpenSCAD за да се пресмета.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Извези</translation>
    </message>
    <message>
        <source>Depths can be written only as PNG.</source>
        <translation>Длабочините се запишуваат само како PNG.</translation>
    </message>
    <message>
        <source>Asks for a file name and adds the file to the queue in the Exports panel. The queue continues after a restart.</source>
        <translation>Прашува за име на датотека и ја создава датотеката кога ќе дојде на ред, по оние што чекаат во панелот „Извози“. Редот продолжува по повторно стартување.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Погледот на платното</translation>
    </message>
    <message>
        <source>The view “%1”</source>
        <translation>Погледот „%1“</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Исечок</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>Исе&amp;чок:</translation>
    </message>
    <message>
        <source>A closed surface around the attractor, for a printer.</source>
        <translation>Затворена површина околу атракторот, за печатач.</translation>
    </message>
    <message>
        <source>The whole solid is written, not only the slice.</source>
        <translation>Се запишува целото тело, не само пресекот.</translation>
    </message>
    <message>
        <source>Voxels along the longest side: more voxels make finer steps. A solid has at most %1 million voxels and %2 million triangles.</source>
        <translation>Воксели по најдолгата страна: поситни скали, и повеќе од нив. Едно тело има најмногу %1 милиони воксели и %2 милиони триаголници.</translation>
    </message>
    <message>
        <source>A solid has no shapes: the file contains its picture in pixels.</source>
        <translation>Телото нема форми: датотеката ја содржи неговата слика во пиксели.</translation>
    </message>
    <message>
        <source>Stere&amp;o:</source>
        <translation>&amp;Стерео:</translation>
    </message>
    <message>
        <source>The name “%1” does not determine the format. It must end with one of these: %2.</source>
        <translation>Името „%1“ не го кажува форматот. Мора да завршува на една од овие наставки: %2.</translation>
    </message>
    <message>
        <source>Include the ca&amp;ge</source>
        <translation>Вклучи го &amp;кафезот</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Го црта кафезот врз сликата.</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>Целиот атрактор</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin. Saved views are listed, too.</source>
        <translation>Што покажува сликата: она што го покажува платното или атракторот со мала маргина, каде и да гледа платното. Во листата се и зачуваните погледи.</translation>
    </message>
    <message>
        <source>8 bits per channel</source>
        <translation>8 бита по канал</translation>
    </message>
    <message>
        <source>16 bits per channel, for further editing</source>
        <translation>16 бита по канал, за понатамошна работа на сликата</translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation>Длабочина на &amp;бојата:</translation>
    </message>
</context>
<context>
    <name>view::SpaceInput</name>
    <message>
        <source>Rotate Cage</source>
        <translation>Ротирај го кафезот</translation>
    </message>
    <message>
        <source>Scale Cage</source>
        <translation>Скалирај го кафезот</translation>
    </message>
    <message>
        <source>Move Vertex %1</source>
        <translation>Помести го темето %1</translation>
    </message>
    <message>
        <source>Move the Slice</source>
        <translation>Помести го пресекот</translation>
    </message>
    <message>
        <source>Move Face %1</source>
        <translation>Помести ја страната %1</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Помести го центарот на симетријата</translation>
    </message>
</context>
<context>
    <name>view::SpaceRows</name>
    <message>
        <source>Look</source>
        <translation>Приказ</translation>
    </message>
    <message>
        <source>A lit solid, the density of its points, or data for other programs.</source>
        <translation>Осветлено тело, густината на неговите точки, или броеви за други програми.</translation>
    </message>
    <message>
        <source>Stone</source>
        <translation>Камен</translation>
    </message>
    <message>
        <source>A solid lit by a lamp that you can move</source>
        <translation>Тело на светлина од ламба што може да се движи</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Туш</translation>
    </message>
    <message>
        <source>A solid with dark creases on paper, for print</source>
        <translation>Тело со темни набори на хартија, за печатење</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>Облак</translation>
    </message>
    <message>
        <source>The density of points, as in the plane</source>
        <translation>Густината на точките, како во рамнина</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>Рендген</translation>
    </message>
    <message>
        <source>The density of points, coloured by their mean depth</source>
        <translation>Густината на точките, обоена според средната длабочина</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Длабочина</translation>
    </message>
    <message>
        <source>Near white, far black</source>
        <translation>Блиското бело, далечното црно</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Нормали</translation>
    </message>
    <message>
        <source>The direction of the surface as a colour, for compositing</source>
        <translation>Насоката на површината како боја, за понатамошна обработка</translation>
    </message>
    <message>
        <source>Look: %1</source>
        <translation>Приказ: %1</translation>
    </message>
    <message>
        <source>Colour of the solid by</source>
        <translation>Боја на телото според</translation>
    </message>
    <message>
        <source>What the colour of the surface shows.</source>
        <translation>Што покажува бојата на површината.</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Еднобојно</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Една боја</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Пресликување</translation>
    </message>
    <message>
        <source>The colour of the map whose piece it is</source>
        <translation>Бојата на пресликувањето чиј дел е</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адреса</translation>
    </message>
    <message>
        <source>The palette along the addresses</source>
        <translation>Палетата по адресите</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висина</translation>
    </message>
    <message>
        <source>The palette from bottom to top</source>
        <translation>Палетата од долу нагоре</translation>
    </message>
    <message>
        <source>The palette from near to far</source>
        <translation>Палетата од блиску кон далеку</translation>
    </message>
    <message>
        <source>Colour by: %1</source>
        <translation>Боење според: %1</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Боја според</translation>
    </message>
    <message>
        <source>The direction of the light as seen by the camera; in the middle, it shines from the camera.</source>
        <translation>Каде стои ламбата гледано од окото: во средината тоа е самото око.</translation>
    </message>
    <message>
        <source>Light: %1°, %2°</source>
        <translation>Светлина: %1°, %2°</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светлина</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Магла</translation>
    </message>
    <message>
        <source>How fast colours fade with depth</source>
        <translation>Колку брзо бледеат боите со длабочината</translation>
    </message>
    <message>
        <source>Fog: %1</source>
        <translation>Магла: %1</translation>
    </message>
</context>
<context>
    <name>view::SpaceView</name>
    <message>
        <source>Canvas in space</source>
        <translation>Платно во просторот</translation>
    </message>
    <message>
        <source>The solid and its tetrahedron. Drag a corner: X, Y or Z keeps it on an axis, with Shift in a plane, and the wheel pushes it away. Drag anywhere else to turn the view; the wheel zooms at the pointer, the middle button pans. Double-click the solid to turn about that point.</source>
        <translation>Телото и неговиот тетраедар. Влечете агол: X, Y или Z го држи на оска, со Shift во рамнина, а тркалцето го оддалечува. Влечете на друго место за да го завртите погледот; тркалцето зумира кај покажувачот, а средното копче поместува. Кликнете двапати на телото за вртење околу таа точка.</translation>
    </message>
    <message>
        <source>Vertex %1 at %2, %3, %4</source>
        <translation>Теме %1 кај %2, %3, %4</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Вклопи</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>Перспе&amp;ктива</translation>
    </message>
    <message>
        <source>Look from the F&amp;ront</source>
        <translation>Поглед од на&amp;пред</translation>
    </message>
    <message>
        <source>Look from the &amp;Right</source>
        <translation>Поглед од &amp;десно</translation>
    </message>
    <message>
        <source>Look from &amp;Above</source>
        <translation>Поглед од&amp;горе</translation>
    </message>
    <message>
        <source>Canvas in space: %1</source>
        <translation>Платно во простор: %1</translation>
    </message>
    <message>
        <source>Map %5, corner %1 at %2, %3, %4</source>
        <translation>Пресликување %5, аголот %1 е во %2, %3, %4</translation>
    </message>
    <message>
        <source>Corner %1 of the branch at %2, %3, %4</source>
        <translation>Аголот %1 на гранката е во %2, %3, %4</translation>
    </message>
    <message>
        <source>Map %4, its middle at %1, %2, %3</source>
        <translation>Пресликување %4, неговата средина е во %1, %2, %3</translation>
    </message>
    <message>
        <source>The middle of the branch at %1, %2, %3</source>
        <translation>Средината на гранката е во %1, %2, %3</translation>
    </message>
    <message>
        <source>The attractor and its control tetrahedron. Tab moves from corner to corner and to the ball of axes, the arrow keys move the corner in focus or turn the view, F6 leaves the canvas.</source>
        <translation>Атракторот и неговиот контролен тетраедар. Tab оди од агол на агол и на топката на оските, стрелките го поместуваат аголот во фокус или го вртат погледот, F6 го напушта платното.</translation>
    </message>
    <message>
        <source>Ball of axes, positive end of %1.</source>
        <translation>Топка на оските, позитивен крај на %1.</translation>
    </message>
    <message>
        <source>Ball of axes, negative end of %1.</source>
        <translation>Топка на оските, негативен крај на %1.</translation>
    </message>
    <message>
        <source>The view looks from there; Enter looks from behind.</source>
        <translation>Погледот е оттаму; Enter гледа од назад.</translation>
    </message>
    <message>
        <source>Enter looks from there, the arrow keys choose another end.</source>
        <translation>Enter гледа оттаму, стрелките избираат друг крај.</translation>
    </message>
</context>
<context>
    <name>view::StartShapeBox</name>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Од</translation>
    </message>
    <message>
        <source>The Cage</source>
        <translation>Кафезот</translation>
    </message>
    <message>
        <source>A Square</source>
        <translation>Квадрат</translation>
    </message>
    <message>
        <source>A Letter</source>
        <translation>Буква</translation>
    </message>
    <message>
        <source>A Picture…</source>
        <translation>Слика…</translation>
    </message>
    <message>
        <source>What the steps start from</source>
        <translation>Од што тргнуваат чекорите</translation>
    </message>
    <message>
        <source>What the steps start from. Whatever you choose, the images get closer to the same attractor: a square, a letter that you type, or the dark shape in a picture, each as large as the attractor.</source>
        <translation>Од што тргнуваат чекорите. Што и да изберете, сликите се приближуваат кон истиот атрактор: квадрат, напишана буква или темната форма во слика, секогаш големи колку атракторот.</translation>
    </message>
    <message>
        <source>Letters to start from</source>
        <translation>Почетни букви</translation>
    </message>
    <message>
        <source>One letter, or up to three</source>
        <translation>Една буква, или најмногу три</translation>
    </message>
    <message>
        <source>The letter that the steps start from, or up to three letters. One that is not symmetric, such as R, shows how the maps turn and reflect.</source>
        <translation>Буквата од која тргнуваат чекорите, или најмногу три букви. Буква без симетрија, како R, покажува како пресликувањата вртат и отсликуваат.</translation>
    </message>
    <message>
        <source>Choose a Picture to Start From</source>
        <translation>Изберете почетна слика</translation>
    </message>
</context>
<context>
    <name>view::StepsBridge</name>
    <message>
        <source>The picture has no dark shape on a light background.</source>
        <translation>Сликата нема темна форма на светла позадина.</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Сликата не можеше да се прочита.</translation>
    </message>
</context>
<context>
    <name>view::StoringReport</name>
    <message>
        <source>The settings cannot be saved: “%1” is not writable, or the disk is full.</source>
        <translation>Поставките не може да се зачуваат: во „%1“ не може да се запишува или дискот е полн.</translation>
    </message>
</context>
<context>
    <name>view::StretchDialog</name>
    <message>
        <source>From frame</source>
        <translation>Од кадар</translation>
    </message>
    <message>
        <source>Keys up to this frame stay where they are.</source>
        <translation>Клучевите до овој кадар остануваат каде што се.</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>До кадар</translation>
    </message>
    <message>
        <source>The end of the range. Later keys keep their distance to it.</source>
        <translation>Крајот на делот. Подоцнежните клучеви го задржуваат растојанието до него.</translation>
    </message>
    <message>
        <source>Ends at frame</source>
        <translation>Завршува на кадар</translation>
    </message>
    <message>
        <source>Where the range ends from now on: later for slower, earlier for faster.</source>
        <translation>Каде завршува делот отсега: подоцна за побавно, порано за побрзо.</translation>
    </message>
    <message>
        <source>Stretch Keys</source>
        <translation>Растегни клучеви</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Забелешка</translation>
    </message>
    <message>
        <source>&amp;Stretch</source>
        <translation>&amp;Растегни</translation>
    </message>
    <message>
        <source>Moves the keys of all tracks, in one step that you can undo.</source>
        <translation>Ги поместува клучевите на сите траки, во еден чекор што може да се поништи.</translation>
    </message>
    <message>
        <source>&amp;From frame:</source>
        <translation>&amp;Од кадар:</translation>
    </message>
    <message>
        <source>&amp;To frame:</source>
        <translation>&amp;До кадар:</translation>
    </message>
    <message>
        <source>&amp;Ends at frame:</source>
        <translation>&amp;Завршува на кадар:</translation>
    </message>
    <message>
        <source>The range has to end after its first frame.</source>
        <translation>Делот мора да заврши по својот прв кадар.</translation>
    </message>
    <message>
        <source>Two keys would meet at one frame, or the animation would be too long.</source>
        <translation>Два клуча би се нашле на ист кадар, или анимацијата би станала предолга.</translation>
    </message>
    <message>
        <source>Stretch keys</source>
        <translation>Растегни клучеви</translation>
    </message>
</context>
<context>
    <name>view::SuggestionList</name>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n пресликување</numerusform>
            <numerusform>%n пресликувања</numerusform>
            <numerusform>%n пресликувања</numerusform>
        </translation>
    </message>
    <message>
        <source>Mean distance %1 px</source>
        <translation>Средно растојание %1 px</translation>
    </message>
    <message>
        <source>Overlap %1 %</source>
        <translation>Преклоп %1 %</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Предлози</translation>
    </message>
    <message>
        <source>Click a suggestion to use it; undo goes back</source>
        <translation>Кликнете на предлог за да го користите; враќањето го поништува</translation>
    </message>
    <message>
        <source>Guaranteed within %1 px</source>
        <translation>Загарантирано до %1 px</translation>
    </message>
</context>
<context>
    <name>view::SymmetryRow</name>
    <message>
        <source>Symmetry</source>
        <translation>Симетрија</translation>
    </message>
    <message>
        <source>Repeat every map under a group of rotations or mirror images</source>
        <translation>Повтори го секое пресликување под група ротации или огледални слики</translation>
    </message>
    <message>
        <source>With a symmetry, each map of the list also acts rotated or mirrored about the centre, so the fractal is symmetric. The copies are not listed; Expand lists them. On the canvas, drag the handle of the centre.</source>
        <translation>Со симетрија, секое пресликување од списокот дејствува и завртено или огледално околу центарот, па фракталот е симетричен. Копиите не се во списокот; „Разгрни“ ги додава. На платното, влечете ја рачката на центарот.</translation>
    </message>
    <message>
        <source>Order of the symmetry</source>
        <translation>Ред на симетријата</translation>
    </message>
    <message>
        <source>How many times the fractal repeats in a full turn</source>
        <translation>Колку пати се повторува фракталот во еден цел круг</translation>
    </message>
    <message>
        <source>Expand</source>
        <translation>Разгрни</translation>
    </message>
    <message>
        <source>Expand the symmetry</source>
        <translation>Разгрни ја симетријата</translation>
    </message>
    <message>
        <source>Writes the copies that the symmetry makes into the list, as maps of their own, so that you can change them individually. The picture stays the same.</source>
        <translation>Ги запишува копиите што ги прави симетријата во списокот како посебни пресликувања, за да можете да смените само едно. Сликата останува иста.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Центар x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Центар y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Центар z</translation>
    </message>
    <message>
        <source>Centre of the symmetry, x</source>
        <translation>Центар на симетријата, x</translation>
    </message>
    <message>
        <source>Centre of the symmetry, y</source>
        <translation>Центар на симетријата, y</translation>
    </message>
    <message>
        <source>Centre of the symmetry, z</source>
        <translation>Центар на симетријата, z</translation>
    </message>
    <message>
        <source>The point that the symmetry leaves unchanged</source>
        <translation>Точката што симетријата ја остава на место</translation>
    </message>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Помести го центарот на симетријата</translation>
    </message>
    <message>
        <source>Angle of the mirror</source>
        <translation>Агол на огледалото</translation>
    </message>
    <message>
        <source>Direction of a mirror, in degrees counter-clockwise</source>
        <translation>Насока на огледало, во степени спротивно од стрелките на часовникот</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Агол °</translation>
    </message>
    <message>
        <source>Turn the mirrors of the symmetry</source>
        <translation>Заврти ги огледалата на симетријата</translation>
    </message>
    <message>
        <source>List the maps that the symmetry stands for</source>
        <translation>Наведи ги пресликувањата што ги претставува симетријата</translation>
    </message>
    <message>
        <source>Remove the symmetry</source>
        <translation>Отстрани ја симетријата</translation>
    </message>
    <message>
        <source>Set the symmetry</source>
        <translation>Постави ја симетријата</translation>
    </message>
</context>
<context>
    <name>view::SymmetryTool</name>
    <message>
        <source>Move the centre of the symmetry</source>
        <translation>Помести го центарот на симетријата</translation>
    </message>
</context>
<context>
    <name>view::TargetBox</name>
    <message>
        <source>Only maps that contract give a shape to trace.</source>
        <translation>Само пресликувања што собираат даваат форма за прецртување.</translation>
    </message>
    <message>
        <source>The attractor is a single point.</source>
        <translation>Атракторот е една точка.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Цел</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Избери</translation>
    </message>
    <message>
        <source>Choose the picture that the fractal should look like</source>
        <translation>Изберете ја сликата на која фракталот треба да ѝ наликува</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Слика…</translation>
    </message>
    <message>
        <source>Entry of This File</source>
        <translation>Запис од оваа датотека</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Вметни</translation>
    </message>
    <message>
        <source>Use the picture on the clipboard</source>
        <translation>Користи ја сликата од таблата со исечоци</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Отстрани</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Автоматски</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Форма</translation>
    </message>
    <message>
        <source>Shape:</source>
        <translation>Форма:</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Обратно</translation>
    </message>
    <message>
        <source>Trace the background instead</source>
        <translation>Наместо тоа прецртај ја позадината</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Праг</translation>
    </message>
    <message>
        <source>The shade up to which a pixel belongs to the shape</source>
        <translation>Нијансата до која пикселот ѝ припаѓа на формата</translation>
    </message>
    <message>
        <source>Threshold:</source>
        <translation>Праг:</translation>
    </message>
    <message>
        <source>Automatic threshold</source>
        <translation>Автоматски праг</translation>
    </message>
    <message>
        <source>Find the threshold that best separates dark from light (Otsu)</source>
        <translation>Одвој го темното од светлото најдобро што може со еден праг (Оцу)</translation>
    </message>
    <message>
        <source>Opacity of the target</source>
        <translation>Непроѕирност на целта</translation>
    </message>
    <message>
        <source>How strongly the target is shown on the canvas</source>
        <translation>Колку силно целта се гледа на платното</translation>
    </message>
    <message>
        <source>Opacity:</source>
        <translation>Непроѕирност:</translation>
    </message>
    <message>
        <source>Crop to Shape</source>
        <translation>Исечи до формата</translation>
    </message>
    <message>
        <source>Use only the part around the shape</source>
        <translation>Користи го само делот околу формата</translation>
    </message>
    <message>
        <source>Whole Picture</source>
        <translation>Цела слика</translation>
    </message>
    <message>
        <source>Use the whole picture again</source>
        <translation>Користи ја повторно целата слика</translation>
    </message>
    <message>
        <source>There is no picture on the clipboard.</source>
        <translation>Нема слика во таблата со исечоци.</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>Вметната слика</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
    </message>
    <message>
        <source>The picture could not be read.</source>
        <translation>Сликата не можеше да се прочита.</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels</source>
        <translation>%1, %2 × %3 пиксели</translation>
    </message>
    <message>
        <source>Choose, paste or drop a picture on the window.</source>
        <translation>Изберете или вметнете слика, или пуштете ја врз прозорецот.</translation>
    </message>
    <message>
        <source>With these settings, the shape is empty or fills the picture.</source>
        <translation>Со овие поставки формата е празна или ја исполнува сликата.</translation>
    </message>
    <message>
        <source>Remove the target and work without one</source>
        <translation>Отстрани ја целта и работи без неа</translation>
    </message>
    <message>
        <source>Dark pixels</source>
        <translation>Темни пиксели</translation>
    </message>
    <message>
        <source>Opaque pixels</source>
        <translation>Непроѕирни пиксели</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape</source>
        <translation>Кои пиксели ѝ припаѓаат на формата</translation>
    </message>
    <message>
        <source>Which pixels belong to the shape. Automatic takes the opaque pixels if any part of the picture is transparent, otherwise the dark ones.</source>
        <translation>Кои пиксели ѝ припаѓаат на формата. Автоматски се непроѕирните ако сликата некаде е проѕирна, инаку темните.</translation>
    </message>
    <message>
        <source>%1, reduced to %2 × %3 pixels</source>
        <translation>%1, намалена на %2 × %3 пиксели</translation>
    </message>
    <message>
        <source>The target is not saved with the file. It is kept while the file is open.</source>
        <translation>Целта не се зачувува со датотеката. Останува додека датотеката е отворена.</translation>
    </message>
    <message>
        <source>Choose a Picture</source>
        <translation>Изберете слика</translation>
    </message>
</context>
<context>
    <name>view::TargetPreview</name>
    <message>
        <source>Preview of the target</source>
        <translation>Преглед на целта</translation>
    </message>
    <message>
        <source>Drag a rectangle to crop the picture; double-click to use all of it</source>
        <translation>Повлечете правоаголник за да ја исечете сликата; двоен клик ја враќа целата</translation>
    </message>
</context>
<context>
    <name>view::TheftExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Извоз на „%1“</translation>
    </message>
    <message>
        <source>Asks for a file name and writes the picture. You can keep working in the meantime.</source>
        <translation>Прашува за име на датотека и ја запишува сликата. Во меѓувреме можете да работите.</translation>
    </message>
    <message>
        <source>The view on the canvas</source>
        <translation>Погледот на платното</translation>
    </message>
    <message>
        <source>The whole attractor</source>
        <translation>Целиот атрактор</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Исечок</translation>
    </message>
    <message>
        <source>What the picture shows: the view on the canvas, or the whole attractor with a small margin.</source>
        <translation>Што прикажува сликата: она што го прикажува платното, или атракторот со мала маргина, без разлика каде гледа платното.</translation>
    </message>
    <message>
        <source>Sect&amp;ion:</source>
        <translation>&amp;Исечок:</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Големина:</translation>
    </message>
    <message>
        <source>Export Stolen Picture</source>
        <translation>Извези ја украдената слика</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Слики (*.png)</translation>
    </message>
    <message>
        <source>The name “%1” does not end with .png. Choose another name.</source>
        <translation>Името „%1“ не завршува со .png. Изберете друго име.</translation>
    </message>
</context>
<context>
    <name>view::Timeline</name>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Вртење</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Орбита</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Дишење</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Кружење на палетата</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Кафез</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Гранка %1</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Изглед</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Камера</translation>
    </message>
    <message>
        <source>Motions need no keys. Select a track first.</source>
        <translation>За движењата не се потребни клучеви. Прво изберете патека.</translation>
    </message>
    <message>
        <source>Key of %1 (frame %2)</source>
        <translation>Клуч на %1 (кадар %2)</translation>
    </message>
    <message>
        <source>Keys of all tracks (frame %1)</source>
        <translation>Клучеви на сите патеки (кадар %1)</translation>
    </message>
    <message>
        <source>Delete keys</source>
        <translation>Избриши клучеви</translation>
    </message>
    <message>
        <source>Delete the motion “%1”</source>
        <translation>Избриши го движењето „%1“</translation>
    </message>
    <message>
        <source>Copy keys</source>
        <translation>Копирај клучеви</translation>
    </message>
    <message>
        <source>Move keys and all later ones</source>
        <translation>Помести клучеви и сите подоцнежни</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Помести клучеви</translation>
    </message>
    <message>
        <source>None of these keys fits this fractal.</source>
        <translation>Ниеден од овие клучеви не одговара на овој фрактал.</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Вметни клучеви</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Линеарно</translation>
    </message>
    <message>
        <source>Slow Start and End</source>
        <translation>Бавно на почетокот и на крајот</translation>
    </message>
    <message>
        <source>Slow Start</source>
        <translation>Бавно на почетокот</translation>
    </message>
    <message>
        <source>Slow End</source>
        <translation>Бавно на крајот</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Задржи</translation>
    </message>
    <message>
        <source>Ease to the Next Key</source>
        <translation>Премин до следниот клуч</translation>
    </message>
    <message>
        <source>Copy Keys</source>
        <translation>Копирај клучеви</translation>
    </message>
    <message>
        <source>Paste Keys at the Playhead</source>
        <translation>Вметни клучеви кај главата за пуштање</translation>
    </message>
    <message>
        <source>Delete Keys</source>
        <translation>Избриши клучеви</translation>
    </message>
    <message>
        <source>Key at the Playhead</source>
        <translation>Клуч кај главата за пуштање</translation>
    </message>
    <message>
        <source>Delete the Motion</source>
        <translation>Избриши го движењето</translation>
    </message>
    <message>
        <source>Custom…</source>
        <translation>Сопствен…</translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) beyond the new end deleted. Undo brings them back.</source>
        <translation>
            <numerusform>%n клуч зад новиот крај е избришан. „Врати“ го враќа.</numerusform>
            <numerusform>%n клучеви зад новиот крај се избришани. „Врати“ ги враќа.</numerusform>
            <numerusform>%n клучеви зад новиот крај се избришани. „Врати“ ги враќа.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) not pasted: beyond the end of the animation, or of a part that this fractal does not have.</source>
        <translation>
            <numerusform>%n клуч не е вметнат: зад крајот на анимацијата, или од дел што овој фрактал го нема.</numerusform>
            <numerusform>%n клучеви не се вметнати: зад крајот на анимацијата, или од дел што овој фрактал го нема.</numerusform>
            <numerusform>%n клучеви не се вметнати: зад крајот на анимацијата, или од дел што овој фрактал го нема.</numerusform>
        </translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Мазно</translation>
    </message>
    <message>
        <source>Ease of keys (frame %1)</source>
        <translation>Премин на клучеви (кадар %1)</translation>
    </message>
    <message>
        <source>Ease of keys (frames %1–%2)</source>
        <translation>Премин на клучеви (кадри %1–%2)</translation>
    </message>
    <message>
        <source>Edit the Motion…</source>
        <translation>Уреди го движењето…</translation>
    </message>
    <message>
        <source>Branch %1, inside itself</source>
        <translation>Гранка %1, внатре во себе</translation>
    </message>
    <message>
        <source>Stretch Keys…</source>
        <translation>Растегни клучеви…</translation>
    </message>
</context>
<context>
    <name>view::TimelinePanel</name>
    <message>
        <source>Breeze</source>
        <translation>Ветре</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Налети</translation>
    </message>
    <message>
        <source>Storm</source>
        <translation>Бура</translation>
    </message>
    <message>
        <source>Under Water</source>
        <translation>Под вода</translation>
    </message>
    <message>
        <source>Calm</source>
        <translation>Мирно</translation>
    </message>
    <message>
        <source>Add Motion</source>
        <translation>Додај движење</translation>
    </message>
    <message>
        <source>Add a motion that needs no keys, or a morph to another entry</source>
        <translation>Додај движење за кое не се потребни клучеви или преобразба во друг запис</translation>
    </message>
    <message>
        <source>Add &amp;Motion</source>
        <translation>Додај &amp;движење</translation>
    </message>
    <message>
        <source>It is one step of the history.</source>
        <translation>Тоа е еден чекор во историјата.</translation>
    </message>
    <message>
        <source>There are no maps to move.</source>
        <translation>Нема пресликувања што би се движеле.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>All branches sway about their roots.</source>
        <translation>Сите гранки се нишаат околу местото каде што почнуваат.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Вртење</translation>
    </message>
    <message>
        <source>Each map turns once in its place.</source>
        <translation>Пресликувањата се вртат еднаш на своето место.</translation>
    </message>
    <message>
        <source>Turn the maps</source>
        <translation>Заврти ги пресликувањата</translation>
    </message>
    <message>
        <source>No map can turn without losing the attractor.</source>
        <translation>Ниедно пресликување не може да се врти без да се изгуби атракторот.</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Орбита</translation>
    </message>
    <message>
        <source>The whole picture turns once.</source>
        <translation>Целата слика прави еден круг.</translation>
    </message>
    <message>
        <source>Breathe</source>
        <translation>Дишење</translation>
    </message>
    <message>
        <source>The maps swell and shrink.</source>
        <translation>Пресликувањата растат и се смалуваат.</translation>
    </message>
    <message>
        <source>Palette Cycle</source>
        <translation>Кружење на палетата</translation>
    </message>
    <message>
        <source>The colours run through the palette and back.</source>
        <translation>Боите минуваат низ палетата и назад.</translation>
    </message>
    <message>
        <source>Cycle the palette</source>
        <translation>Кружи низ палетата</translation>
    </message>
    <message>
        <source>Zoom In Endlessly</source>
        <translation>Бескрајно зумирање</translation>
    </message>
    <message>
        <source>The view moves into a small copy of the whole; the last frame matches the first.</source>
        <translation>Погледот навлегува во мала копија на целината, каде што последниот кадар е првиот.</translation>
    </message>
    <message>
        <source>Zoom in endlessly</source>
        <translation>Зумирај бескрајно</translation>
    </message>
    <message>
        <source>No map makes a scaled copy of the fractal that is clear of the others.</source>
        <translation>Ниедно пресликување само не го смалува фракталот во копија одвоена од другите.</translation>
    </message>
    <message>
        <source>Morph To</source>
        <translation>Преобрази во</translation>
    </message>
    <message>
        <source>The fractal becomes another entry of this file, and returns.</source>
        <translation>Фракталот станува друг запис од оваа датотека и се враќа.</translation>
    </message>
    <message>
        <source>Wind: %1</source>
        <translation>Ветер: %1</translation>
    </message>
    <message>
        <source>This file has no other fractal of this dimension</source>
        <translation>Оваа датотека нема друг фрактал од оваа димензија</translation>
    </message>
    <message>
        <source>Morph to %1</source>
        <translation>Преобрази во %1</translation>
    </message>
    <message>
        <source>Trying the motion…</source>
        <translation>Се испробува движењето…</translation>
    </message>
    <message>
        <source>Choose &amp;Pairs…</source>
        <translation>Избери &amp;парови…</translation>
    </message>
    <message>
        <source>Shows which map becomes which, and lets you pin pairs.</source>
        <translation>Покажува кое пресликување преминува во кое и овозможува прицврстување парови.</translation>
    </message>
    <message>
        <source>Pairing the maps…</source>
        <translation>Се спаруваат пресликувањата…</translation>
    </message>
    <message>
        <source>Frame without an attractor</source>
        <translation>Кадар без атрактор</translation>
    </message>
    <message>
        <source>Steady Sway</source>
        <translation>Рамномерно нишање</translation>
    </message>
</context>
<context>
    <name>view::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation>Опции на алатката</translation>
    </message>
    <message>
        <source>Drag a corner, an edge or the inside of the cage.  Ctrl rotates  ·  Alt scales  ·  Shift keeps directions  ·  double-click an edge for a new corner</source>
        <translation>Влечете теме, раб или внатрешност на кафезот.  Ctrl врти  ·  Alt менува големина  ·  Shift ги задржува правците  ·  двоен клик на раб: ново теме</translation>
    </message>
    <message>
        <source>Click the three corners of the new triangle.  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Кликни ги трите темиња на новиот триаголник.  Backspace ја брише последната точка  ·  Esc откажува</translation>
    </message>
    <message>
        <source>Click the four corners of the new tetrahedron, the fourth in front of the others.  The wheel pushes it away  ·  right-drag turns the view  ·  Backspace removes the last point  ·  Esc cancels</source>
        <translation>Кликнете ги четирите темиња на новиот тетраедар, четвртото пред другите.  Тркалцето го оддалечува  ·  влечење со десното копче го врти погледот  ·  Backspace ја отстранува последната точка  ·  Esc откажува</translation>
    </message>
    <message>
        <source>Drag a corner or a face of the cage.  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Влечете теме или страна на кафезот.  X, Y, Z задржуваат оска  ·  Ctrl врти  ·  Alt менува големина  ·  влечете на друго место за да го завртите приказот</translation>
    </message>
    <message>
        <source>Click a corner of a map to select it, Shift+click for more.  Drag its corners or its middle  ·  X, Y, Z keep an axis  ·  Ctrl rotates  ·  Alt scales  ·  drag anywhere else to turn the view</source>
        <translation>Кликнете на теме од пресликување за да го изберете, Shift+клик за уште.  Влечете ги неговите темиња или средината  ·  X, Y, Z задржуваат оска  ·  Ctrl врти  ·  Alt менува големина  ·  влечете на друго место за да го завртите приказот</translation>
    </message>
    <message>
        <source>Side by side, the fractal can be turned and zoomed.  To change it, switch stereo off.</source>
        <translation>Еден до друг, фракталот може да се врти и зумира.  За да го менуваш, исклучи стерео.</translation>
    </message>
</context>
<context>
    <name>view::ToolbarPage</name>
    <message>
        <source>Move &amp;Up</source>
        <translation>Помести на&amp;горе</translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation>Помести надол&amp;у</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Тргни</translation>
    </message>
    <message>
        <source>Commands in the toolbar</source>
        <translation>Наредби на лентата со алатки</translation>
    </message>
    <message>
        <source>The toolbar from left to right. Drag a command to move it.</source>
        <translation>Лентата со алатки од лево кон десно. Повлечете наредба за да ја поместите.</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>Изберете наредба</translation>
    </message>
    <message>
        <source>Command to add</source>
        <translation>Наредба за додавање</translation>
    </message>
    <message>
        <source>Adds a command of the menus, or a separator, after the selected one.</source>
        <translation>Додава наредба од менијата, или разделник, по избраната.</translation>
    </message>
    <message>
        <source>&amp;Add:</source>
        <translation>&amp;Додај:</translation>
    </message>
    <message>
        <source>Moves the selected command towards the left end of the toolbar.</source>
        <translation>Ја поместува избраната наредба кон левиот крај на лентата со алатки.</translation>
    </message>
    <message>
        <source>Moves the selected command towards the right end of the toolbar.</source>
        <translation>Ја поместува избраната наредба кон десниот крај на лентата со алатки.</translation>
    </message>
    <message>
        <source>Takes the selected command out of the toolbar. It stays in its menu.</source>
        <translation>Ја трга избраната наредба од лентата со алатки. Таа останува во своето мени.</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Разделник</translation>
    </message>
</context>
<context>
    <name>view::TrackView</name>
    <message>
        <source>Tracks and keys</source>
        <translation>Патеки и клучеви</translation>
    </message>
    <message>
        <source>Unit of the ruler</source>
        <translation>Единица на линијарот</translation>
    </message>
    <message>
        <source>Switch the ruler between frames and seconds</source>
        <translation>Префрли го линијарот меѓу кадри и секунди</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Секунди</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Кадри</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, кадар %2</translation>
    </message>
    <message>
        <source>, key</source>
        <translation>, клуч</translation>
    </message>
    <message>
        <source>, keys in this row: %1</source>
        <translation>, клучеви во овој ред: %1</translation>
    </message>
    <message>
        <source>One row for each part that can move. The diamond on the left sets a key at the playhead, or deletes it. Drag keys to move them: Alt moves all later ones too, Ctrl copies. Drag in the ruler to move the playhead, or from an empty area to select keys. Ctrl + wheel zooms. Right-click a key for its ease. Round keys are smooth: the motion runs through them without a corner. Double-click a motion to change its strength or number of turns.</source>
        <translation>По еден ред за секој дел што може да се движи. Ромбот напред поставува клуч кај главата за пуштање или го брише. Влечете клучеви за да ги поместите: Alt ги носи и подоцнежните, Ctrl ги копира. Влечете по линијарот за да ја поместите главата, а од празно место за да изберете клучеви. Ctrl + тркалце зумира. Десен клик на клуч за неговиот премин. Тркалезните клучеви се мазни: движењето минува низ нив без агол. Кликнете двапати на движење за да ја промените неговата јачина или бројот на вртења.</translation>
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
        <translation>Трансформирај</translation>
    </message>
    <message>
        <source>x of the fixed point</source>
        <translation>x на неподвижната точка</translation>
    </message>
    <message>
        <source>y of the fixed point</source>
        <translation>y на неподвижната точка</translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation>Отсликај</translation>
    </message>
    <message>
        <source>Shear along x</source>
        <translation>Искосување по x</translation>
    </message>
    <message>
        <source>Scale in x</source>
        <translation>Скалирање по x</translation>
    </message>
    <message>
        <source>Scale in y</source>
        <translation>Скалирање по y</translation>
    </message>
    <message>
        <source>Same in x and y</source>
        <translation>Исто по x и y</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise</source>
        <translation>Ротација во степени, спротивно од стрелките на часовникот</translation>
    </message>
    <message>
        <source>Translation in x</source>
        <translation>Транслација по x</translation>
    </message>
    <message>
        <source>Translation in y</source>
        <translation>Транслација по y</translation>
    </message>
    <message>
        <source>Applied in this order, from top to bottom.</source>
        <translation>Се изведува по овој редослед, одозгора надолу.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Проблем</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Почни одново</translation>
    </message>
    <message>
        <source>Reset all values to what they were when the dialog opened</source>
        <translation>Сите вредности како што беа при отворањето на дијалогот</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Постави ја сликата</translation>
    </message>
    <message>
        <source>The cage moves; the code does not change</source>
        <translation>Кодот останува ист; се поместува кафезот</translation>
    </message>
    <message>
        <source>Rewrite the code</source>
        <translation>Измени го кодот</translation>
    </message>
    <message>
        <source>Every map w becomes T∘w∘T⁻¹; the cage follows</source>
        <translation>Секое пресликување w станува T∘w∘T⁻¹; кафезот го следи тоа</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Точката што останува на место</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>координатниот почеток</translation>
    </message>
    <message>
        <source>the mean of the invariant measure</source>
        <translation>средната вредност на инваријантната мера</translation>
    </message>
    <message>
        <source>a point of your choice</source>
        <translation>внесена точка</translation>
    </message>
    <message>
        <source>in the line at the angle (°)</source>
        <translation>во однос на правата под агол °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Агол на оската на симетрија во степени: 0 е хоризонтална, 90 вертикална</translation>
    </message>
    <message>
        <source>This entry is not a system in the plane.</source>
        <translation>Овој запис нема пресликувања на рамнината.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be inverted, so it cannot be written into the code. Choose other scales, or place the picture.</source>
        <translation>Оваа трансформација е премногу сплескана за да може да се врати, па не може да се запише во кодот. Изберете други размери или поставете ја сликата.</translation>
    </message>
    <message>
        <source>Transform the picture</source>
        <translation>Трансформирање на сликата</translation>
    </message>
    <message>
        <source>Transform the code</source>
        <translation>Трансформирање на кодот</translation>
    </message>
    <message>
        <source>Keeps the factor in y equal to that in x.</source>
        <translation>Го одржува размерот по y еднаков на оној по x.</translation>
    </message>
    <message>
        <source>The point about which the fractal is rotated, scaled and reflected; it stays where it is.</source>
        <translation>Околу која точка фракталот се врти, скалира и отсликува: таа останува на место.</translation>
    </message>
    <message>
        <source>Reflects in a line through the fixed point; the angle is measured from the x axis.</source>
        <translation>Осна симетрија во однос на права низ точката што останува на место; аголот се мери од x-оската.</translation>
    </message>
    <message>
        <source>Change:</source>
        <translation>Измена:</translation>
    </message>
    <message>
        <source>About:</source>
        <translation>Околу:</translation>
    </message>
    <message>
        <source>Reflect:</source>
        <translation>Отсликај:</translation>
    </message>
    <message>
        <source>Shear:</source>
        <translation>Искоси:</translation>
    </message>
    <message>
        <source>Scale:</source>
        <translation>Скалирај:</translation>
    </message>
    <message>
        <source>Rotate °:</source>
        <translation>Ротирај °:</translation>
    </message>
    <message>
        <source>Translate:</source>
        <translation>Транслирај:</translation>
    </message>
    <message>
        <source>the centre of the picture’s box</source>
        <translation>средината на правоаголникот на сликата</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>Reflects, shears, scales, rotates and translates the whole fractal by numbers.</source>
        <translation>Го отсликува, закосува, размерува, врти и поместува целиот фрактал според броеви.</translation>
    </message>
    <message>
        <source>z of the fixed point</source>
        <translation>z на неподвижната точка</translation>
    </message>
    <message>
        <source>Scale in z</source>
        <translation>Скалирање по z</translation>
    </message>
    <message>
        <source>Axis:</source>
        <translation>Оска:</translation>
    </message>
    <message>
        <source>x of the direction of the axis</source>
        <translation>x на насоката на оската</translation>
    </message>
    <message>
        <source>y of the direction of the axis</source>
        <translation>y на насоката на оската</translation>
    </message>
    <message>
        <source>z of the direction of the axis</source>
        <translation>z на насоката на оската</translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise as seen from the tip of the axis</source>
        <translation>Ротација во степени, спротивно од стрелките на часовникот гледано од врвот на оската</translation>
    </message>
    <message>
        <source>Translation in z</source>
        <translation>Транслација по z</translation>
    </message>
    <message>
        <source>Same in x, y and z</source>
        <translation>Исто по x, y и z</translation>
    </message>
    <message>
        <source>Keeps the factors in x, y and z equal.</source>
        <translation>Ги одржува размерите по x, y и z еднакви.</translation>
    </message>
    <message>
        <source>Axis of the rotation</source>
        <translation>Оска на ротацијата</translation>
    </message>
    <message>
        <source>The axis of the rotation; it passes through the fixed point.</source>
        <translation>Оската на ротацијата; минува низ неподвижната точка.</translation>
    </message>
    <message>
        <source>the x axis</source>
        <translation>оската x</translation>
    </message>
    <message>
        <source>the y axis</source>
        <translation>оската y</translation>
    </message>
    <message>
        <source>the z axis</source>
        <translation>оската z</translation>
    </message>
    <message>
        <source>a direction of your choice</source>
        <translation>внесена насока</translation>
    </message>
    <message>
        <source>This entry is not a system in space.</source>
        <translation>Овој запис не е систем во просторот.</translation>
    </message>
    <message>
        <source>The axis has no direction.</source>
        <translation>Оската нема насока.</translation>
    </message>
    <message>
        <source>The cage bends the picture, so only a transformation that scales alike in all directions can be written into the code. Choose equal scales, or place the picture.</source>
        <translation>Кафезот ја криви сликата, па во кодот може да се запише само трансформација со исто скалирање во сите насоки. Изберете еднакви размери или поставете ја сликата.</translation>
    </message>
</context>
<context>
    <name>view::TransformationBar</name>
    <message>
        <source>Partner</source>
        <translation>Партнер</translation>
    </message>
    <message>
        <source>The entry on which the picture is placed</source>
        <translation>Записот врз кој лежи сликата</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Режим</translation>
    </message>
    <message>
        <source>What the fractal transformation does with the picture</source>
        <translation>Што прави фракталната трансформација со сликата</translation>
    </message>
    <message>
        <source>Fractal transformation</source>
        <translation>Фрактална трансформација</translation>
    </message>
    <message>
        <source>Steal Colours</source>
        <translation>Кради бои</translation>
    </message>
    <message>
        <source>Transform a Picture</source>
        <translation>Трансформирај слика</translation>
    </message>
    <message>
        <source>Deformation Grid</source>
        <translation>Мрежа на деформација</translation>
    </message>
    <message>
        <source>Filter: Reduce</source>
        <translation>Филтер: намали</translation>
    </message>
    <message>
        <source>Filter: Posterise</source>
        <translation>Филтер: постеризирај</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Извези…</translation>
    </message>
    <message>
        <source>Save the stolen picture as PNG</source>
        <translation>Зачувај ја украдената слика како PNG</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>The picture on the partner; you can also drop one there</source>
        <translation>Сликата врз партнерот; можете и да пуштите слика таму</translation>
    </message>
    <message>
        <source>Choose Picture…</source>
        <translation>Избери слика…</translation>
    </message>
    <message>
        <source>Colour Wheel</source>
        <translation>Круг на бои</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Мрежа</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Прстени</translation>
    </message>
    <message>
        <source>Sunset</source>
        <translation>Зајдисонце</translation>
    </message>
    <message>
        <source>Starters</source>
        <translation>Почетоци</translation>
    </message>
    <message>
        <source>Add two entries with the same addresses, whose parameters you can slide</source>
        <translation>Додај два записа со исти адреси, чии параметри може да се лизгаат</translation>
    </message>
    <message>
        <source>Triangle Family</source>
        <translation>Фамилија на триаголникот</translation>
    </message>
    <message>
        <source>Square Family</source>
        <translation>Фамилија на квадратот</translation>
    </message>
    <message>
        <source>%1 →</source>
        <translation>%1 →</translation>
    </message>
    <message>
        <source>The picture on the partner: %1</source>
        <translation>Сликата врз партнерот: %1</translation>
    </message>
    <message>
        <source>Find Picture…</source>
        <translation>Најди ја сликата…</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Подели зборови</translation>
    </message>
    <message>
        <source>Choose the current location of the picture</source>
        <translation>Изберете ја сликата таму каде што е сега</translation>
    </message>
    <message>
        <source>Divide maps of both entries into words until both have the same number</source>
        <translation>Подели пресликувања на двата записа во зборови додека не се изедначат</translation>
    </message>
    <message>
        <source>Stained Glass</source>
        <translation>Витраж</translation>
    </message>
    <message>
        <source>Marble</source>
        <translation>Мермер</translation>
    </message>
    <message>
        <source>Tartan</source>
        <translation>Тартан</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Бранови</translation>
    </message>
    <message>
        <source>State of the fractal transformation</source>
        <translation>Состојба на фракталната трансформација</translation>
    </message>
    <message>
        <source>There is no stolen picture yet</source>
        <translation>Сѐ уште нема украдена слика</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Еден над друг</translation>
    </message>
    <message>
        <source>Show the two fractals one above the other instead of side by side</source>
        <translation>Прикажи ги двата фрактали еден над друг наместо еден до друг</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Преклопи</translation>
    </message>
    <message>
        <source>Show the partner half transparent over the fractal, in the same coordinates</source>
        <translation>Прикажи го партнерот полупроѕирно врз фракталот, во истите координати</translation>
    </message>
    <message>
        <source>Embed in the File</source>
        <translation>Вгради во датотеката</translation>
    </message>
    <message>
        <source>Store the picture itself with the entry, not only its path</source>
        <translation>Зачувај ја со записот самата слика, а не само нејзината патека</translation>
    </message>
    <message>
        <source>Stores the picture itself with the entry, so that the file shows it wherever it goes. A picture of more than 128 KB is stored smaller. Otherwise only its path is stored.</source>
        <translation>Ја зачувува самата слика со записот, па датотеката ја прикажува каде и да оди. Слика поголема од 128 KB се зачувува намалена. Инаку се зачувува само нејзината патека.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Врати го редоследот</translation>
    </message>
    <message>
        <source>Put the maps back in the order of their numbers</source>
        <translation>Подреди ги пресликувањата повторно по нивните броеви</translation>
    </message>
    <message>
        <source>Open It</source>
        <translation>Отвори</translation>
    </message>
    <message>
        <source>Open this picture, which is outside the folder of the file</source>
        <translation>Отвори ја оваа слика, која е надвор од папката на датотеката</translation>
    </message>
</context>
<context>
    <name>view::TransformationView</name>
    <message>
        <source>Canvas of the partner</source>
        <translation>Платно на партнерот</translation>
    </message>
    <message>
        <source>Choose Partner</source>
        <translation>Избери партнер</translation>
    </message>
    <message>
        <source>Choose Mode</source>
        <translation>Избери режим</translation>
    </message>
    <message>
        <source>Choose Picture</source>
        <translation>Избери слика</translation>
    </message>
    <message>
        <source>Divide Words</source>
        <translation>Подели зборови</translation>
    </message>
    <message>
        <source>There is no other entry of the plane in this file. Add one, or choose a starter.</source>
        <translation>Во оваа датотека нема друг запис во рамнината. Додајте запис или изберете почеток.</translation>
    </message>
    <message>
        <source>The partner “%1” is not in this file. Choose another one.</source>
        <translation>Партнерот „%1“ не е во оваа датотека. Изберете друг.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Add Family</source>
        <translation>Додај фамилија</translation>
    </message>
    <message>
        <source>Points of two fractals that have the same address correspond to each other. A picture on the partner is carried over to this fractal in that way.</source>
        <translation>Точките на два фрактала што имаат иста адреса си одговараат. Така слика од партнерот се пренесува на овој фрактал.</translation>
    </message>
    <message>
        <source>Reset Order</source>
        <translation>Врати го редоследот</translation>
    </message>
    <message>
        <source>Reorder Overlapping Maps</source>
        <translation>Промени го редоследот</translation>
    </message>
    <message>
        <source>Do Not Embed Picture</source>
        <translation>Не вградувај слика</translation>
    </message>
    <message>
        <source>Embed Picture</source>
        <translation>Вгради слика</translation>
    </message>
    <message>
        <source>The file names a picture outside its folder: %1. Open it only if you trust the file.</source>
        <translation>Датотеката именува слика надвор од својата папка: %1. Отворете ја само ако ѝ верувате на датотеката.</translation>
    </message>
</context>
<context>
    <name>view::TransportBar</name>
    <message>
        <source>Play</source>
        <translation>Пушти</translation>
    </message>
    <message>
        <source>Play the animation</source>
        <translation>Пушти ја анимацијата</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Кадар</translation>
    </message>
    <message>
        <source>The frame that is shown and edited</source>
        <translation>Кадарот што се прикажува и се уредува</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Должина</translation>
    </message>
    <message>
        <source>The length of the animation in frames</source>
        <translation>Колку кадри е долга анимацијата</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Кадри во секунда</translation>
    </message>
    <message>
        <source>The number of frames played per second</source>
        <translation>Колку кадри се пуштаат во секунда</translation>
    </message>
    <message>
        <source>Previous Key</source>
        <translation>Претходен клуч</translation>
    </message>
    <message>
        <source>Move the playhead to the previous key</source>
        <translation>Помести ја главата за пуштање на претходниот клуч</translation>
    </message>
    <message>
        <source>Next Key</source>
        <translation>Следен клуч</translation>
    </message>
    <message>
        <source>Move the playhead to the next key</source>
        <translation>Помести ја главата за пуштање на следниот клуч</translation>
    </message>
    <message>
        <source>Frame:</source>
        <translation>Кадар:</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>Должина:</translation>
    </message>
    <message>
        <source>fps:</source>
        <translation>сл./с:</translation>
    </message>
    <message>
        <source>Loop:</source>
        <translation>Јамка:</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Јамка</translation>
    </message>
    <message>
        <source>What happens after the last frame</source>
        <translation>Што доаѓа по последниот кадар</translation>
    </message>
    <message>
        <source>Off: the animation stops at its last frame. Cycle: it starts again from frame 0. There and Back: it runs backwards to the start.</source>
        <translation>Исклучено: анимацијата запира на последниот кадар. Круг: почнува одново, а кадарот на крајот е кадар 0. Напред и назад: се враќа наназад до почетокот.</translation>
    </message>
    <message>
        <source>Off</source>
        <comment>loop</comment>
        <translation>Исклучено</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Круг</translation>
    </message>
    <message>
        <source>There and Back</source>
        <translation>Напред и назад</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 сл./с</translation>
    </message>
    <message>
        <source>The number of frames drawn per second during playback</source>
        <translation>Колку кадри во секунда се цртаат при пуштањето</translation>
    </message>
    <message>
        <source>Frames per second: %1</source>
        <translation>Кадри во секунда: %1</translation>
    </message>
    <message>
        <source>Loop: %1</source>
        <translation>Јамка: %1</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <source>Stop at this frame</source>
        <translation>Запри на овој кадар</translation>
    </message>
    <message>
        <source>The number of frames played per second: a number or a fraction, such as 24, 12.5 or 30000/1001. 29.97 stands for the latter, the rate of television.</source>
        <translation>Колку кадри се пуштаат во секунда: број или дропка, на пример 24, 12.5 или 30000/1001. 29.97 ја означува последната, брзината на телевизијата.</translation>
    </message>
    <message>
        <source>“%1” is not a frame rate. Enter frames per second, above 0 and at most %2, such as 24, 29.97 or 30000/1001.</source>
        <translation>„%1“ не е брзина на кадри. Внесете кадри во секунда, над 0 и најмногу %2, на пример 24, 29.97 или 30000/1001.</translation>
    </message>
    <message numerus="yes">
        <source>Length of the animation: %n frame(s)</source>
        <translation>
            <numerusform>Должина на анимацијата: %n кадар</numerusform>
            <numerusform>Должина на анимацијата: %n кадри</numerusform>
            <numerusform>Должина на анимацијата: %n кадри</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::VertexDialog</name>
    <message>
        <source>Move vertex %1</source>
        <translation>Поместување на темето %1</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Теме %1</translation>
    </message>
    <message>
        <source>x of the vertex</source>
        <translation>x на темето</translation>
    </message>
    <message>
        <source>y of the vertex</source>
        <translation>y на темето</translation>
    </message>
    <message>
        <source>Problem with the numbers</source>
        <translation>Што не е во ред со броевите</translation>
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
        <translation>„%1“ не е број. Напишете го со децимална точка, на пример -0.25.</translation>
    </message>
    <message>
        <source>A coordinate of the vertex, with a decimal point or comma. The picture follows as you type.</source>
        <translation>Координата на темето, со децимална точка или запирка. Сликата се менува додека пишувате.</translation>
    </message>
    <message>
        <source>Move vertex %1 to (%2, %3)</source>
        <translation>Премести го темето %1 во (%2, %3)</translation>
    </message>
</context>
<context>
    <name>view::ZoomBox</name>
    <message>
        <source>Zoom</source>
        <translation>Зум</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Вклопи</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Zoom in percent: 100 % shows a unit of the plane as 100 pixels; type another value, or choose one</source>
        <translation>Зум во проценти: на 100 % една единица од рамнината е 100 пиксели; внесете друга вредност или изберете</translation>
    </message>
    <message>
        <source>Zoom in percent: at 100 %, one unit of the plane is 100 pixels long. Type a number, or choose a value, a saved view, or Fit, which shows the whole attractor.</source>
        <translation>Зум во проценти: на 100 % една единица од рамнината е 100 пиксели. Внесете број, или изберете вредност, зачуван поглед или „Вклопи“, што го покажува целиот атрактор.</translation>
    </message>
</context>
</TS>
