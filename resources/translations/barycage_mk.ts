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
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation>Атрактор</translation>
    </message>
    <message>
        <source>A system has one attractor if some power of it contracts: then every start leads to the same set.</source>
        <translation>Системот има единствен атрактор ако некој негов степен е контракција: тогаш секој почеток води кон истото множество.</translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation>Контракција</translation>
    </message>
    <message>
        <source>‖A‖ of each map that takes part: the most by which it stretches distances.</source>
        <translation>‖A‖ на секое пресликување што учествува: колку пати најмногу ги растегнува растојанијата.</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Правоаголник</translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that holds the attractor; certified.</source>
        <translation>Најмалиот правоаголник со страни паралелни на оските што го содржи атракторот; докажано.</translation>
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
        <source>Mean of the invariant measure, solved exactly: the centre of mass of the picture.</source>
        <translation>Средна вредност на инваријантната мера, точно пресметана: тежиштето на сликата.</translation>
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
        <source>The point that each map leaves where it is; it lies on the attractor.</source>
        <translation>Точката што секое пресликување ја остава на место; таа лежи на атракторот.</translation>
    </message>
    <message>
        <source>The D with Σ sᵢᴰ = 1 over the ratios sᵢ, when all maps are similarities in some coordinates. It is the dimension of the attractor when the pieces do not overlap.</source>
        <translation>Она D за кое Σ sᵢᴰ = 1 по односите sᵢ, кога сите пресликувања се сличности во некои координати. Тоа е димензијата на атракторот кога деловите не се преклопуваат.</translation>
    </message>
    <message>
        <source>Affinity dimension</source>
        <translation>Афина димензија</translation>
    </message>
    <message>
        <source>Falconer’s dimension: where the sum of the singular value functions of all words of one length neither grows nor falls, at most 2. An upper bound of the box-counting dimension, and equal to it for almost all translations when the maps contract enough.</source>
        <translation>Димензијата на Фалконер: каде што збирот на функциите на сингуларни вредности на сите зборови со иста должина ниту расте ниту опаѓа, најмногу 2. Горна граница на димензијата со броење кутии и еднаква на неа за речиси сите поместувања кога пресликувањата доволно контрахираат.</translation>
    </message>
    <message>
        <source>Box-counting dimension</source>
        <translation>Димензија со броење кутии</translation>
    </message>
    <message>
        <source>Slope of the least-squares line through ln N against ln 1/ε, where N boxes of side ε meet the attractor. An estimate: it depends on the sizes counted.</source>
        <translation>Наклон на правата на најмали квадрати низ ln N спрема ln 1/ε, каде што N кутии со страна ε го допираат атракторот. Проценка: зависи од избраните големини.</translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture spreads. The ellipse is the one on which an even mass has the same mean and covariance.</source>
        <translation>Коваријанса xx, xy, yy на инваријантната мера, точно решена: колку е распространета сликата. Елипсата е онаа на која рамномерна маса ја има истата средина и коваријанса.</translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that holds the attractor; certified. The signs are the directions of its legs.</source>
        <translation>Најмалиот рамнокрак правоаголен триаголник со катети паралелни на оските што го содржи атракторот; докажано. Знаците се насоките на катетите.</translation>
    </message>
    <message>
        <source>Hull area</source>
        <translation>Плоштина на обвивката</translation>
    </message>
    <message>
        <source>Area of the convex hull: of the polygon whose vertices were found on the attractor. The hull itself is larger by at most its border times the error bound.</source>
        <translation>Плоштина на конвексната обвивка: на многуаголникот чии темиња се најдени на атракторот. Самата обвивка е поголема најмногу за нејзиниот раб помножен со границата на грешката.</translation>
    </message>
    <message>
        <source>Hull vertices</source>
        <translation>Темиња на обвивката</translation>
    </message>
    <message>
        <source>Corners of the convex hull as found, each a point of the attractor. A hull with infinitely many has as many as its tolerance asks for.</source>
        <translation>Темиња на конвексната обвивка како што се најдени, секое точка на атракторот. Обвивка со бесконечно многу има онолку колку што бара нејзината толеранција.</translation>
    </message>
    <message>
        <source>Hull error bound</source>
        <translation>Граница на грешката на обвивката</translation>
    </message>
    <message>
        <source>The attractor reaches at most this far beyond the polygon; certified.</source>
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
        <source>Yes: hyperbolic, every map contracts by %1 or less.</source>
        <translation>Да: хиперболичен, секое пресликување контрахира со фактор %1 или помалку.</translation>
    </message>
    <message>
        <source>Yes: eventually contractive, every word of %1 maps contracts (%2 a map).</source>
        <translation>Да: на крајот контрактивен, секој збор од %1 пресликувања контрахира (%2 по пресликување).</translation>
    </message>
    <message>
        <source>None: the word %1 does not contract (%2 a map).</source>
        <translation>Нема: зборот %1 не контрахира (%2 по пресликување).</translation>
    </message>
    <message>
        <source>Undecided: no proof either way was found.</source>
        <translation>Неодлучено: не е најден доказ ниту за едното ниту за другото.</translation>
    </message>
    <message>
        <source>None: no map takes part.</source>
        <translation>Нема: ниту едно пресликување не учествува.</translation>
    </message>
    <message>
        <source>None: map %1 does not contract (%2 a map).</source>
        <translation>Нема: пресликувањето %1 не контрахира (%2 по пресликување).</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Take a fractal by its corners: an editor for iterated function systems.</source>
        <translation>Фатете го фракталот за темињата: уредувач на итерирани функциски системи.</translation>
    </message>
    <message>
        <source>.ifs files to open, a window each</source>
        <translation>.ifs-датотеки за отворање, секоја во свој прозорец</translation>
    </message>
    <message>
        <source>a window with the maple, whatever was open before</source>
        <translation>прозорец со јаворот, што и да било отворено претходно</translation>
    </message>
    <message>
        <source>a window that shows the collection</source>
        <translation>прозорец што ја покажува збирката</translation>
    </message>
    <message>
        <source>a window with fractals made by chance to pick from</source>
        <translation>прозорец со случајни фрактали за избор</translation>
    </message>
</context>
<context>
    <name>CageEdits</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Овој запис нема пресликувања на рамнината.</translation>
    </message>
    <message>
        <source>The cage is at rest: the code is what is displayed.</source>
        <translation>Кафезот е во мирување: се прикажува самиот код.</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code has a bent picture. Choose “Affine fit” to bake what comes nearest to it.</source>
        <translation>Кафезот ја свиткува сликата, а ниеден афин код не дава свиткана слика. Изберете „Афино приближување“ за да се впише она што е најблиску до неа.</translation>
    </message>
    <message>
        <source>The cage is flat: no code has this picture. Open the cage first.</source>
        <translation>Кафезот е сплескан: ниеден код ја нема оваа слика. Прво раширете го кафезот.</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. The code stays as it is until you bake.</source>
        <translation>Поместувањето на кафезот ја поместува сликата. Кодот останува ист додека не го впишете тоа во него.</translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can follow, and leaves it.</source>
        <translation>Поместувањето на целиот кафез го менува кодот. Поместувањето на одделни темиња ја свиткува сликата; тоа кодот не може да го следи, па останува ист.</translation>
    </message>
    <message>
        <source>Moving the cage rewrites every coefficient of the code, and the cage rests where it is.</source>
        <translation>Поместувањето на кафезот ги менува сите коефициенти на кодот, а кафезот останува во мирување таму каде што е.</translation>
    </message>
    <message>
        <source>The cage already places the code.</source>
        <translation>Кафезот веќе го поставува кодот.</translation>
    </message>
    <message>
        <source>Only a triangle can be taken out of the code.</source>
        <translation>Од кодот може да се извади само триаголник.</translation>
    </message>
    <message>
        <source>The cage has a notch: the picture may fold over itself there.</source>
        <translation>Кафезот има вдлабнатина: таму сликата може да се превитка преку себе.</translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture lie over one another. Move the vertices apart to unfold it.</source>
        <translation>Кафезот е превиткан: делови од сликата лежат еден врз друг. Раздалечете ги темињата за да го одвиткате.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to enclose.</source>
        <translation>Не учествува ниедно пресликување, па нема што да се опфати.</translation>
    </message>
    <message>
        <source>A bent picture cannot be held by another cage. Reset the cage, or choose “Affine fit”, first.</source>
        <translation>Свиткана слика не може да ја држи друг кафез. Прво вратете го кафезот во мирување или изберете „Афино приближување“.</translation>
    </message>
    <message>
        <source>The cage is flat. Open the triangle, or reset it, first.</source>
        <translation>Кафезот е сплескан. Прво раширете го триаголникот или вратете го во мирување.</translation>
    </message>
    <message>
        <source>This system has no attractor that could be enclosed.</source>
        <translation>Овој систем нема атрактор што би можел да се опфати.</translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation>Кафезот е во мирување.</translation>
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
        <source>Fronds: a long slow map climbs the rachis, two short ones hang the pinnae, a flat one draws the stem.</source>
        <translation>Папратови листови: едно долго бавно пресликување се качува по главната оска, две кратки ги додаваат страничните ливчиња, а едно сплескано ја црта дршката.</translation>
    </message>
    <message>
        <source>Trees</source>
        <translation>Дрвја</translation>
    </message>
    <message>
        <source>Trunks that fork: the whole tree stands on its own branches.</source>
        <translation>Стебла што се разгрануваат: целото дрво стои на секоја од своите гранки.</translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation>Змејови</translation>
    </message>
    <message>
        <source>Folded paper curves and the fractals of two or three twisted similarities.</source>
        <translation>Криви од свиткана хартија и фрактали од две или три завртени сличности.</translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation>Фамилија Серпињски</translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon holds shrunken copies of itself and keeps its holes.</source>
        <translation>Триаголници и килими: многуаголникот содржи смалени копии од себе и ги задржува дупките.</translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation>Фамилија Кох</translation>
    </message>
    <message>
        <source>Curves built by replacing a segment, and the islands they bound.</source>
        <translation>Криви добиени со замена на отсечка и островите што тие ги оградуваат.</translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation>Спирали</translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small ones that bead its path.</source>
        <translation>Едно пресликување што врти и малку смалува, и други, мали, што го нижат неговиот пат како мониста.</translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation>Листови и цветови</translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are turned copies of one another.</source>
        <translation>Контури на листови и цветови чии ливчиња се завртени копии едни од други.</translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation>Поплочувања и рептајли</translation>
    </message>
    <message>
        <source>Sets that tile the plane: copies of themselves, rep-tiles, and the central tiles of number systems.</source>
        <translation>Множества што ја поплочуваат рамнината: копии од самите себе, рептајли и централните плочки на бројните системи.</translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation>Канторови множества и прав</translation>
    </message>
    <message>
        <source>Sets full of gaps at every scale: points everywhere near, hardly any of them joined.</source>
        <translation>Множества полни со празнини во секој размер: насекаде во близина има точки, а речиси ниедни не се поврзани.</translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation>Кристали и снегулки</translation>
    </message>
    <message>
        <source>Sets with the symmetry of frost: five, six and more arms.</source>
        <translation>Множества со симетрија на мраз: со пет, шест и повеќе краци.</translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation>Криви и графици</translation>
    </message>
    <message>
        <source>Graphs of strange functions, smooth curves as attractors, space-filling coordinates.</source>
        <translation>Графици на необични функции, мазни криви како атрактори, координати на криви што го исполнуваат просторот.</translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation>Апстрактни</translation>
    </message>
    <message>
        <source>Affine patterns without a name in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation>Афини шари без име во природата: роднини на триаголникот на Серпињски, плетенки, розети.</translation>
    </message>
</context>
<context>
    <name>ExportJob</name>
    <message>
        <source>There is not enough memory for this picture. Make it smaller, or supersample less.</source>
        <translation>Нема доволно меморија за оваа слика. Намалете ја или намалете го суперсемплирањето.</translation>
    </message>
</context>
<context>
    <name>FlameCard</name>
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
        <source>In flames y grows downwards. They were turned over, so that they look here as they do in flame programs.</source>
        <translation>Во пламените y расте надолу. Превртени се, за тука да изгледаат како во flame-програмите.</translation>
    </message>
    <message>
        <source>Leave &amp;y as it is written</source>
        <translation>Остави ја &amp;y како што е запишана</translation>
    </message>
    <message>
        <source>Takes the numbers of the flames as they are in the text. The picture is then upside down.</source>
        <translation>Ги зема броевите на пламените како што се во текстот. Сликата тогаш е превртена.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Leave y as it is written</source>
        <translation>Остави ја y како што е запишана</translation>
    </message>
    <message>
        <source>Turn the flames over</source>
        <translation>Преврти ги пламените</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures that carry their fractal (*.png *.svg);;All files (*)</source>
        <translation>Збирки на Fractint (*.ifs *.par);;Пламени (*.flame *.flam3);;Табели со броеви (*.csv *.tsv *.txt);;Слики што го носат својот фрактал (*.png *.svg);;Сите датотеки (*)</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Додавање на %1</translation>
    </message>
    <message>
        <source>Show or hide the panel “%1”</source>
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
        <source>Take the maple by a corner and pull. Or press D and define another triangle by three clicks.</source>
        <translation>Фатете го јаворот за едно теме и повлечете. Или притиснете D и со три кликања дефинирајте друг триаголник.</translation>
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
        <source>, %n of them could not be read and are kept as they are</source>
        <translation>
            <numerusform>, %n од нив не можеше да се прочита и е задржан како што е</numerusform>
            <numerusform>, %n од нив не можеа да се прочитаат и се задржани како што се</numerusform>
            <numerusform>, %n од нив не можеа да се прочитаат и се задржани како што се</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with a remark</source>
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
        <source>“%1” has changes that are not saved.</source>
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
        <source>“%1” was changed by another program since it was opened here.</source>
        <translation>Откако е отворена тука, датотеката „%1“ ја изменила друга програма.</translation>
    </message>
    <message>
        <source>Saving replaces what the other program wrote.</source>
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
        <source>Go back to “%1” as it is on disk? The changes made since then are lost.</source>
        <translation>Да се врати „%1“ како што е на дискот? Измените направени оттогаш ќе се изгубат.</translation>
    </message>
    <message>
        <source>%1 could not be read again</source>
        <translation>„%1“ не можеше повторно да се прочита</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Нема неодамнешни датотеки</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Исчисти го списоков</translation>
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
        <source>Save the file; entries not edited keep every byte</source>
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
        <source>Go back to the file as it is on disk</source>
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
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen</source>
        <translation>Извези ја сликата како PNG, SVG или PDF, со истата рамка како на екранот</translation>
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
        <source>The picture is on the clipboard.</source>
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
        <source>Take the last edit back</source>
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
        <source>Make the edit again that was taken back</source>
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
        <source>Rotate, scale, shear, reflect or move the whole fractal by numbers</source>
        <translation>Ротирај, скалирај, искоси, отсликај или премести го целиот фрактал со внесување броеви</translation>
    </message>
    <message>
        <source>&amp;Mutate…</source>
        <translation>&amp;Мутирај…</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Pick one of many variations of this fractal</source>
        <translation>Избери една од многуте варијанти на овој фрактал</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Pick one of many fractals made by chance, and add it to the file</source>
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
        <source>Language, theme, quality of the picture at rest, what is opened at the start</source>
        <translation>Јазик, тема, квалитет на сликата во мирување, што се отвора на почетокот</translation>
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
        <source>Take the fractal by the vertices of its control triangle</source>
        <translation>Фати го фракталот за темињата на неговиот контролен триаголник</translation>
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
        <source>Define the control triangle by three clicks</source>
        <translation>Дефинирај го контролниот триаголник со три кликања</translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation>Опфати со минимален каноничен &amp;симплекс</translation>
    </message>
    <message>
        <source>Hold the attractor in the smallest isosceles right triangle around it</source>
        <translation>Опфати го атракторот со најмалиот рамнокрак правоаголен триаголник околу него</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Врати во &amp;мирување</translation>
    </message>
    <message>
        <source>Put the cage back to rest: the code is drawn as it is</source>
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
        <source>Make the placement part of the code: the picture stays, the coefficients change</source>
        <translation>Впиши ја поставеноста во кодот: сликата останува иста, се менуваат коефициентите</translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation>&amp;Извади од кодот</translation>
    </message>
    <message>
        <source>Take the placement out of the code: the picture stays, the code becomes that of the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation>Извади ја поставеноста од кодот: сликата останува иста, а кодот станува код на триаголникот (0, 0), (1, 0), (0, 1)</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>&amp;Направи го правилен</translation>
    </message>
    <message>
        <source>Put the vertices on the regular polygon nearest to them</source>
        <translation>Стави ги темињата на правилниот многуаголник што им е најблизок</translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation>&amp;Афино инваријантен облик…</translation>
    </message>
    <message>
        <source>Show every map as a row-stochastic matrix over the control triangle</source>
        <translation>Прикажи го секое пресликување како редично-стохастичка матрица во однос на контролниот триаголник</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>Само п&amp;остави</translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
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
        <source>Let y grow downwards, as in window coordinates</source>
        <translation>Нека y расте надолу, како кај координатите на прозорец</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Hide everything on the canvas but the picture</source>
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
        <source>Let dragged vertices snap to this</source>
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
        <source>Use the whole screen</source>
        <translation>Користи го целиот екран</translation>
    </message>
    <message>
        <source>How It Arises</source>
        <translation>Како настанува</translation>
    </message>
    <message>
        <source>&amp;How It Arises</source>
        <translation>&amp;Како настанува</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>Watch the attractor arise: by steps of the deterministic algorithm, or by the chaos game</source>
        <translation>Гледај како настанува атракторот: по чекори на детерминистичкиот алгоритам или со игра на хаос</translation>
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
        <translation>&amp;Упатство за корисници</translation>
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
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Take a fractal by its corners: an editor for iterated function systems whose attractors are held in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Фатете го фракталот за темињата: уредувач на итерирани функциски системи чии атрактори се зададени во барицентрични координати на контролен триаголник.&lt;/p&gt;&lt;p&gt;Според Е. Хаџиева и М. Шуминоска, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;Лиценца MIT.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>З&amp;а Qt</translation>
    </message>
    <message>
        <source>The toolkit this program is built with</source>
        <translation>Библиотеката со која е изградена оваа програма</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Алатки</translation>
    </message>
    <message>
        <source>The fractals of the open file. The one chosen here is in the picture.</source>
        <translation>Фракталите од отворената датотека. Избраниот се прикажува на сликата.</translation>
    </message>
    <message>
        <source>Fractals to begin with, by theme, and your own folders of them.</source>
        <translation>Фрактали за почеток, подредени по теми, и Ваши папки со фрактали.</translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map in a row.</source>
        <translation>Пресликувањата на фракталот: неговиот код, по едно пресликување во редица.</translation>
    </message>
    <message>
        <source>The control cage by numbers: where its vertices are, where they are at rest, what moving them does, and other cages to choose from.</source>
        <translation>Контролниот кафез во броеви: каде му се темињата, каде се тие во мирување, што прави нивното поместување и други кафези за избор.</translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation>Бои, осветленост и позадина на сликата. Се зачувуваат со фракталот.</translation>
    </message>
    <message>
        <source>What mathematics knows of this fractal. Point at a name to read what it means.</source>
        <translation>Што знае математиката за овој фрактал. Задржете го покажувачот над некое име за да прочитате што значи.</translation>
    </message>
    <message>
        <source>Every step since the file was opened. Choose one to go back to it, or forward.</source>
        <translation>Сите чекори откако е отворена датотеката. Изберете еден за да се вратите на него или да одите напред.</translation>
    </message>
    <message>
        <source>What was odd in the file, with line and column. It is kept as it is.</source>
        <translation>Што беше необично во датотеката, со ред и колона. Тоа е задржано како што е.</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>&amp;Обиколка</translation>
    </message>
    <message>
        <source>Six short steps in this window: contraction, fixed point, chaos game, address, barycentric coordinates, dimension</source>
        <translation>Шест кратки чекори во овој прозорец: контракција, неподвижна точка, игра на хаос, адреса, барицентрични координати, димензија</translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation>&amp;Што е ова?</translation>
    </message>
    <message>
        <source>Click anything to read what it is for</source>
        <translation>Кликнете на што било за да прочитате за што служи</translation>
    </message>
    <message>
        <source>No recovery</source>
        <translation>Нема обновување</translation>
    </message>
    <message>
        <source>Allow Systems &amp;without an Attractor</source>
        <translation>Дозволи системи &amp;без атрактор</translation>
    </message>
    <message>
        <source>Let maps be dragged to where they no longer contract; otherwise the drag stops there</source>
        <translation>Пресликувањата да може да се влечат до каде што веќе не контрахираат; инаку влечењето запира таму</translation>
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
        <source>Show the maps as images of the cage and take them by their corners</source>
        <translation>Прикажи ги пресликувањата како слики на кафезот и фати ги за аглите</translation>
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
        <source>Click a point of the attractor and take the branch that it belongs to</source>
        <translation>Кликни на точка од атракторот и фати ја гранката на која ѝ припаѓа</translation>
    </message>
    <message>
        <source>Maps and Branches</source>
        <translation>Пресликувања и гранки</translation>
    </message>
    <message>
        <source>P&amp;aste</source>
        <translation>&amp;Залепи</translation>
    </message>
    <message>
        <source>Add the fractals on the clipboard to the file: entries of an .ifs file, flames or a table of numbers</source>
        <translation>Додај ги во датотеката фракталите од таблата со исечоци: записи од датотека .ifs, flame-фрактали или табела со броеви</translation>
    </message>
    <message>
        <source>The unsaved work is here all the same.</source>
        <translation>Незачуваната работа е сепак тука.</translation>
    </message>
    <message>
        <source>%1 was not recovered. It is offered again at the next start.</source>
        <translation>%1 не е вратено. Повторно ќе биде понудено при следното стартување.</translation>
    </message>
    <message>
        <source>Esc brings menus and panels back.</source>
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
        <source>Leave the whole screen to the canvas, as for a projector; Esc brings the rest back</source>
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
        <source>“%1” is a fraction: write it as a decimal number.</source>
        <translation>„%1“ е дропка: напишете ја како децимален број.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ не е број.</translation>
    </message>
    <message>
        <source>“%1” is too large a number.</source>
        <translation>„%1“ е преголем број.</translation>
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
        <source>Saving “%1” was cancelled. The file on the disk is as it was.</source>
        <translation>Зачувувањето на „%1“ е откажано. Датотеката на дискот е како што беше.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and cannot be opened.</source>
        <translation>„%1“ не е обична датотека и не може да се отвори.</translation>
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
</context>
<context>
    <name>PngSystem</name>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed its text.</source>
        <translation>Сликата не содржи систем: не ја запишал Barycage или друга програма ѝ го отстранила текстот.</translation>
    </message>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>Системот во сликата е поголем од 8 MB.</translation>
    </message>
    <message>
        <source>The file is no PNG picture, or it is damaged.</source>
        <translation>Датотеката не е PNG-слика или е оштетена.</translation>
    </message>
</context>
<context>
    <name>PngWriter</name>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation>Сликата не може да се запише: %1</translation>
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
        <source>Barycage ended last time before this work was saved:</source>
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
        <source>Unsaved work cannot be kept for recovery: the folder “%1” cannot be written to, or the disk is full. Save often.</source>
        <translation>Незачуваната работа не може да се чува за обновување: во папката „%1“ не може да се запишува или дискот е полн. Зачувувајте често.</translation>
    </message>
    <message>
        <source>Unsaved work of last time is damaged and cannot be recovered. What is left of it lies in:</source>
        <translation>Незачуваната работа од минатиот пат е оштетена и не може да се врати. Она што остана од неа се наоѓа во:</translation>
    </message>
    <message>
        <source>Looking for unsaved work…</source>
        <translation>Се бара незачувана работа…</translation>
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
        <source>hyperbolic, s = %1</source>
        <translation>хиперболичен, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 (words of %2 maps)</source>
        <translation>некој степен е контракција, γ = %1 (зборови од %2 пресликувања)</translation>
    </message>
    <message>
        <source>no attractor: the word %1 does not contract</source>
        <translation>нема атрактор: зборот %1 не е контракција</translation>
    </message>
    <message>
        <source>existence of an attractor undecided</source>
        <translation>не е утврдено дали постои атрактор</translation>
    </message>
    <message>
        <source>no map takes part</source>
        <translation>не учествува ниедно пресликување</translation>
    </message>
    <message>
        <source>Pointer position</source>
        <translation>Положба на покажувачот</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Заклучок</translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and the factor by which it contracts</source>
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
        <source>3D: not yet shown</source>
        <translation>3D: засега не се прикажува</translation>
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
        <source>World and barycentric coordinates of the pointer; the address of the point of the attractor under it, outermost map first, and the fixed point of its branch</source>
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
        <source>no attractor: map %1 does not contract</source>
        <translation>нема атрактор: пресликувањето %1 не е контракција</translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation>Системот во сликата е поголем од 8 MB.</translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation>Системот во сликата е оштетен.</translation>
    </message>
    <message>
        <source>The picture declares a document type, which Barycage never writes and does not read.</source>
        <translation>Сликата декларира тип на документ; тоа Barycage никогаш не го запишува и не го чита.</translation>
    </message>
    <message>
        <source>The file is no SVG picture, or it is damaged.</source>
        <translation>Датотеката не е SVG-слика или е оштетена.</translation>
    </message>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed it.</source>
        <translation>Сликата не содржи систем: не ја запишал Barycage или друга програма го отстранила.</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a document type is not accepted in a flame file</source>
        <translation>тип на документ не се прифаќа во flame-датотека</translation>
    </message>
    <message>
        <source>The XML ends here: %1.</source>
        <translation>XML-от завршува тука: %1.</translation>
    </message>
    <message>
        <source>There is no flame in this file.</source>
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
        <source>in space</source>
        <translation>во простор</translation>
    </message>
    <message>
        <source>no attractor</source>
        <translation>нема атрактор</translation>
    </message>
    <message>
        <source>The sheet would be %1 by %2 pixels; at most %3 a side can be drawn. Take smaller tiles, or other columns.</source>
        <translation>Листот би бил %1 на %2 пиксели; најмногу може да се нацртаат %3 по страна. Земете помали плочки или поинаков број колони.</translation>
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
        <source>it acts in space (“%1”)</source>
        <translation>дејствува во простор („%1“)</translation>
    </message>
    <message>
        <source>it uses the variation “%1”</source>
        <translation>користи ја варијацијата „%1“</translation>
    </message>
    <message>
        <source>its “coefs” are not six numbers</source>
        <translation>неговиот „coefs“ не е од шест броја</translation>
    </message>
    <message>
        <source>its “post” is not six numbers</source>
        <translation>неговиот „post“ не е од шест броја</translation>
    </message>
    <message>
        <source>its “chaos” allows some successors only, which a list of maps cannot say</source>
        <translation>неговиот „chaos“ дозволува само некои следбеници, а тоа не може да се каже со список пресликувања</translation>
    </message>
    <message>
        <source>it takes part without being drawn (opacity 0)</source>
        <translation>учествува, но не се црта (opacity 0)</translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation>неговата тежина не е број</translation>
    </message>
    <message>
        <source>it has a final transform</source>
        <translation>има завршна трансформација</translation>
    </message>
    <message>
        <source>it adds a symmetry</source>
        <translation>додава симетрија</translation>
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
        <source>The entry that opens here is not closed by “}” before the next entry or the end of the file.</source>
        <translation>Записот што се отвора тука не е затворен со „}“ пред следниот запис или пред крајот на датотеката.</translation>
    </message>
    <message>
        <source>%1 more problems in this entry are not listed.</source>
        <translation>Уште %1 проблеми во овој запис не се наведени.</translation>
    </message>
    <message>
        <source>The name “%1” holds a blank; Fractint takes only its first word.</source>
        <translation>Името „%1“ содржи празно место; Fractint го зема само првиот збор.</translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint cuts it there.</source>
        <translation>Името „%1“ е подолго од 18 бајти; Fractint тука го сече.</translation>
    </message>
    <message>
        <source>The opening brace stands on a line of its own; Fractint does not find this entry.</source>
        <translation>Отворената заграда стои сама во ред; Fractint не го наоѓа овој запис.</translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation>Записот има повеќе од %1 пресликувања, а тоа е границата.</translation>
    </message>
    <message>
        <source>“%1”: the comma can be read as a decimal point or between two numbers, and both give whole rows. Write decimal points and blanks.</source>
        <translation>„%1“: запирката може да се чита како децимална или како запирка меѓу два броја, и во двата случаи се добиваат цели редици. Пишувајте децимални точки и празни места.</translation>
    </message>
    <message>
        <source>“%1”: neither as a decimal point nor between two numbers does the comma give whole rows of 7 numbers (13 with “(3D)”).</source>
        <translation>„%1“: ниту како децимална ниту како запирка меѓу два броја не се добиваат цели редици од 7 броја (13 со „(3D)“).</translation>
    </message>
    <message>
        <source>The numbers on the line of the opening brace are ignored, as Fractint ignores them.</source>
        <translation>Броевите во редот на отворената заграда се занемаруваат, како што ги занемарува и Fractint.</translation>
    </message>
    <message>
        <source>“%1” is not understood by this version of Barycage; the line is kept.</source>
        <translation>Оваа верзија на Barycage не го разбира „%1“; редот е задржан.</translation>
    </message>
    <message>
        <source>The entry holds no numbers.</source>
        <translation>Записот не содржи броеви.</translation>
    </message>
    <message>
        <source>This line has %1 numbers and the entry %2, which is no multiple of %3: a map is %3 numbers%4.</source>
        <translation>Овој ред има %1 броја, а записот %2, што не се дели со %3: едно пресликување е %3 броја%4.</translation>
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
        <source>“%1” is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>„%1“ е поголем отколку што може да биде коефициент (по апсолутна вредност најмногу 3.4e38).</translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Write the plain “-”.</source>
        <translation>„%1“ почнува со типографски минус (U+2212). Напишете обичен „-“.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ не е број.</translation>
    </message>
    <message>
        <source>Numbers stand on the line of the opening brace, where Fractint ignores them; they are read.</source>
        <translation>Броевите стојат во редот на отворената заграда, каде што Fractint ги занемарува; тука се читаат.</translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads other numbers here.</source>
        <translation>Запирките се читаат како децимални; Fractint тука чита други броеви.</translation>
    </message>
    <message>
        <source>Commas or apostrophes stand between the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation>Меѓу броевите стојат запирки или апострофи; Iterated Dynamics не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each); weights are taken from the determinants. Fractint cannot read this entry.</source>
        <translation>Пресликувањата немаат тежини (по %1 броја секое); тежините се земаат од детерминантите. Fractint не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation>Редиците од %1 броја без „(3D)“ по името се читаат како 3D-систем; Fractint не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>The lines do not hold 7 numbers each, but all numbers together fill rows of 7 and are read so, as Fractint does. Probably the weights are missing.</source>
        <translation>Во секој ред нема по 7 броја, но сите броеви заедно пополнуваат редици од 7 и така се читаат, како што прави и Fractint. Веројатно недостигаат тежините.</translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation>Затворената заграда е слепена со последниот број; Fractint не може да го прочита овој запис.</translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint cuts it there.</source>
        <translation>Редот е подолг од 200 бајти; Fractint тука го сече.</translation>
    </message>
    <message>
        <source>A NUL byte; the rest of the line is ignored, as Fractint ignores it.</source>
        <translation>Бајт NUL; остатокот од редот се занемарува, како што прави и Fractint.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation>Записот има %1 пресликувања; Fractint и Iterated Dynamics читаат најмногу 63.</translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map counts as switched off.</source>
        <translation>Тежината на пресликувањето %1 е негативна; пресликувањето се смета за исклучено.</translation>
    </message>
    <message>
        <source>The weight of map %1 is 0; the map takes no part.</source>
        <translation>Тежината на пресликувањето %1 е 0; пресликувањето не учествува.</translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are used in proportion; Fractint gives what is missing to the last map and cuts what is too much.</source>
        <translation>Збирот на тежините е %1, а не 1. Тие се земаат пропорционално; Fractint она што недостига му го дава на последното пресликување, а вишокот го сече.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Датотеката е празна.</translation>
    </message>
    <message>
        <source>These are Fractint parameter sets or formulas; no iterated function system is among them.</source>
        <translation>Ова се параметри или формули на Fractint; меѓу нив нема итериран функциски систем.</translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry is a name, “{”, rows of 7 numbers and “}”.</source>
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
        <source>Two opening braces on one line: no reader finds an entry here. The text is kept.</source>
        <translation>Две отворени загради во еден ред: ниедна програма тука не наоѓа запис. Текстот е задржан.</translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation>„%1“ е збир параметри или формула, а не итериран функциски систем; се чува како текст.</translation>
    </message>
    <message>
        <source>The name is taken by the entry in line %1 (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation>Името веќе го има записот во ред %1 (Fractint споредува 18 знаци и не разликува големи и мали букви); Fractint никогаш не стигнува до овој.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint takes for a part of the first name.</source>
        <translation>Датотеката почнува со ознака за редослед на бајтите, која Fractint ја зема како дел од првото име.</translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); the entries after it are read all the same.</source>
        <translation>Fractint престанува да чита кај овој бајт (^Z); записите по него сепак се читаат.</translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use the first 2000.</source>
        <translation>Датотеката има %1 записи; Fractint и Iterated Dynamics ги користат првите 2000.</translation>
    </message>
    <message>
        <source>The entry has no map that takes part and is left out.</source>
        <translation>Записот нема пресликување што учествува, па се изоставува.</translation>
    </message>
    <message>
        <source>%1 maps that take no part are left out.</source>
        <translation>Изоставени се %1 пресликувања што не учествуваат.</translation>
    </message>
    <message>
        <source>The entry is written under the name “%1”: other programs take 18 plain characters, and each name once.</source>
        <translation>Записот е запишан под името „%1“: другите програми прифаќаат 18 обични знаци, и секое име само еднаш.</translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation>Записот има %1 пресликувања; Fractint до верзија 17.2 чита најмногу 31.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>не е познато</translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation>хиперболичен, s = %1</translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 from words of length %2</source>
        <translation>некој степен е контракција, γ = %1 од зборови со должина %2</translation>
    </message>
    <message>
        <source>none: a word of length %1 does not contract</source>
        <translation>нема: еден збор со должина %1 не е контракција</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>не е утврдено</translation>
    </message>
    <message>
        <source>none: no map takes part</source>
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
        <source>%1 vertices, %2 facets, volume %3; error at most %4</source>
        <translation>%1 темиња, %2 ѕидови, волумен %3; грешка најмногу %4</translation>
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
        <source>%1 — in the plane, %2 maps</source>
        <translation>%1 — во рамнината, %2 пресликувања</translation>
    </message>
    <message>
        <source>%1 — in space, %2 maps</source>
        <translation>%1 — во просторот, %2 пресликувања</translation>
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
        <source>The stored cage is not usable (its lists of vertices do not match, or its rest vertices lie on one line, cross each other or are more than 64) and is not applied.</source>
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
        <source>A palette has at most %1 colours; the others are left out.</source>
        <translation>Палетата има најмногу %1 бои; останатите се изоставени.</translation>
    </message>
    <message>
        <source>This line is left out: three whole numbers from 0 to 255 make a colour.</source>
        <translation>Овој ред е изоставен: боја се три цели броја од 0 до 255.</translation>
    </message>
    <message>
        <source>The file holds no colours.</source>
        <translation>Датотеката не содржи бои.</translation>
    </message>
    <message>
        <source>The file has more than 16 MB, which no palette needs.</source>
        <translation>Датотеката е поголема од 16 MB, а тоа не ѝ треба на ниедна палета.</translation>
    </message>
    <message>
        <source>The file is no text, so it is no palette.</source>
        <translation>Датотеката не е текст, па не е палета.</translation>
    </message>
    <message>
        <source>This is a GIMP gradient; palettes are read from .gpl, .ugr and .map files.</source>
        <translation>Ова е градиент на GIMP; палети се читаат од датотеки .gpl, .ugr и .map.</translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the others are left out.</source>
        <translation>Датотеката има повеќе од %1 палети; останатите се изоставени.</translation>
    </message>
    <message>
        <source>The file holds no gradient.</source>
        <translation>Датотеката не содржи градиент.</translation>
    </message>
    <message>
        <source>The gradient of line %1 is not closed.</source>
        <translation>Градиентот од ред %1 не е затворен.</translation>
    </message>
    <message>
        <source>“%1” is no whole number.</source>
        <translation>„%1“ не е цел број.</translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, of which alone points are written.</source>
        <translation>„%1“ не е систем во рамнината, а точки се запишуваат само за такви системи.</translation>
    </message>
    <message>
        <source>“%1” has no map that takes part, so it has no points.</source>
        <translation>„%1“ нема пресликување што учествува, па нема точки.</translation>
    </message>
    <message>
        <source>A cage of more than three corners bends the picture, and its points are not written.</source>
        <translation>Кафез со повеќе од три темиња ја свиткува сликата, па нејзините точки не се запишуваат.</translation>
    </message>
    <message>
        <source>A point cloud has from 1 to %1 points.</source>
        <translation>Облакот има од 1 до %1 точки.</translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation>„%1“ е папка. Изберете име на датотека.</translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and is not replaced. Choose another name.</source>
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
        <source>“%1” was not saved: the disk is full. Free some space and save again; the file on the disk is as it was.</source>
        <translation>„%1“ не е зачувана: дискот е полн. Ослободете место и зачувајте повторно; датотеката на дискот е како што беше.</translation>
    </message>
    <message>
        <source>“%1” was not saved: you may not write to the folder “%2”. Save somewhere else.</source>
        <translation>„%1“ не е зачувана: немате дозвола за запишување во папката „%2“. Зачувајте на друго место.</translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation>„%1“ не е зачувана: името е предолго.</translation>
    </message>
    <message>
        <source>“%1” was not saved: %2. The file on the disk is as it was.</source>
        <translation>„%1“ не е зачувана: %2. Датотеката на дискот е како што беше.</translation>
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
        <source>Only plane systems can be written as a scalable picture.</source>
        <translation>Како векторска слика можат да се запишат само системи во рамнината.</translation>
    </message>
    <message>
        <source>The system has no attractor of which an outline could be certified, so there is nothing to make copies of.</source>
        <translation>Системот нема атрактор чија контура би можела со сигурност да се определи, па нема од што да се прават копии.</translation>
    </message>
    <message>
        <source>In this view the picture is too large to be written as shapes.</source>
        <translation>Во овој поглед сликата е преголема за да се запише како облици.</translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row is a b c d e f and perhaps a weight.</source>
        <translation>Нема редици од броеви: редицата е a b c d e f и евентуално тежина.</translation>
    </message>
    <message>
        <source>After the count, a map is its weight and a matrix of 3 rows.</source>
        <translation>По бројот на пресликувања, секое пресликување е неговата тежина и матрица со 3 редици.</translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map is 0 0 1.</source>
        <translation>Последната редица од матрицата на афино пресликување е 0 0 1.</translation>
    </message>
    <message>
        <source>The table says that it has %1 maps, and it has %2.</source>
        <translation>Табелата вели дека има %1 пресликувања, а има %2.</translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation>Заглавието не кажува која колона е a, b, c, d, e и f; изберете го редоследот на колоните.</translation>
    </message>
    <message>
        <source>This row has %1 numbers; a map is 6 numbers, or 7 with its weight.</source>
        <translation>Оваа редица има %1 броја; пресликувањето е 6 броја, или 7 со тежината.</translation>
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
        <source>This is a %1 file, not a text with iterated function systems.</source>
        <translation>Ова е датотека %1, а не текст со итерирани функциски системи.</translation>
    </message>
    <message>
        <source>This is a text in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
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
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text with iterated function systems.</source>
        <translation>Ова е бинарна датотека (можеби фрактално компресирана слика или библиотека со икони), а не текст со итерирани функциски системи.</translation>
    </message>
    <message>
        <source>No iterated function system was found, and for a table of numbers the file is too large: the limit is 64 MB.</source>
        <translation>Не е најден итериран функциски систем, а за табела со броеви датотеката е преголема: границата е 64 MB.</translation>
    </message>
    <message>
        <source>a number is larger than a coefficient can be (3.4e38 in size)</source>
        <translation>еден број е поголем отколку што може да биде коефициент (3.4e38 по големина)</translation>
    </message>
    <message>
        <source>The file has more than %1 flames; the rest is left out.</source>
        <translation>Датотеката има повеќе од %1 пламени; останатите се изоставени.</translation>
    </message>
    <message>
        <source>%1 flames in all are no systems of affine maps.</source>
        <translation>Вкупно %1 пламени не се системи од афини пресликувања.</translation>
    </message>
    <message>
        <source>The entry has more than %1 lines, which is the limit; it is kept as text.</source>
        <translation>Записот има повеќе од %1 редови, што е границата; се чува како текст.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 of them with periodic addresses, area %3; error at most %4</source>
        <translation>%1 темиња, од нив %2 со периодични адреси, плоштина %3; грешка најмногу %4</translation>
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
        <source>A number of this row is larger than a coefficient can be (3.4e38 in size).</source>
        <translation>Еден број во овој ред е поголем отколку што може да биде коефициент (3.4e38 по големина).</translation>
    </message>
    <message>
        <source>The text has more than 64 MB, which is the limit for a table of numbers.</source>
        <translation>Текстот има повеќе од 64 MB, што е границата за табела со броеви.</translation>
    </message>
    <message>
        <source>A tag has more than %1 attributes, which is the limit.</source>
        <translation>Една ознака има повеќе од %1 атрибути, што е границата.</translation>
    </message>
    <message>
        <source>The elements are nested more than %1 deep, which is the limit.</source>
        <translation>Елементите се вгнездени подлабоко од %1, што е границата.</translation>
    </message>
    <message>
        <source>The file has more than 64 MB, which is the limit for XML.</source>
        <translation>Датотеката има повеќе од 64 MB, што е границата за XML.</translation>
    </message>
    <message>
        <source>moved branch</source>
        <translation>поместена гранка</translation>
    </message>
    <message>
        <source>A stored place of a branch is not usable (its map is incomplete, or its address names maps that are not there, or occurs twice, or there are too many) and is not applied.</source>
        <translation>Зачувано место на гранка не е употребливо (нејзиното пресликување е нецелосно, нејзината адреса именува пресликувања што ги нема или се јавува двапати, или ги има премногу) и не се применува.</translation>
    </message>
    <message>
        <source>%1 lines of blocks that are no iterated function systems are left out.</source>
        <translation>Се изоставуваат %1 редови од блокови што не се итерирани функциски системи.</translation>
    </message>
    <message>
        <source>A cell of this row is empty.</source>
        <translation>Една ќелија во оваа редица е празна.</translation>
    </message>
    <message>
        <source>A comma can be read as a decimal point or between two numbers here, and both give whole rows. Write decimal points.</source>
        <translation>Тука запирката може да се чита како децимална или како запирка меѓу два броја, и во двата случаи се добиваат цели редици. Пишувајте децимални точки.</translation>
    </message>
    <message>
        <source>The cage and the colours of the entry are left out.</source>
        <translation>Кафезот и боите на записот се изоставуваат.</translation>
    </message>
    <message>
        <source>The code is written without its cage and moved branches: other programs draw another picture.</source>
        <translation>Кодот се запишува без кафезот и без поместените гранки: другите програми цртаат друга слика.</translation>
    </message>
    <message>
        <source>The table has maps of the plane and maps of space.</source>
        <translation>Табелата има пресликувања на рамнината и пресликувања на просторот.</translation>
    </message>
    <message>
        <source>This is a list of other files, as the program Fraktale has one, not a Fractint collection.</source>
        <translation>Ова е список на други датотеки, каков што има програмата Fraktale, а не збирка на Fractint.</translation>
    </message>
    <message>
        <source>This row has %1 numbers, and the header names %2 columns.</source>
        <translation>Оваа редица има %1 броја, а заглавието именува %2 колони.</translation>
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
        <source>No column is called “%1”: they are a b c d or r s theta phi, e f, and p or cumulative.</source>
        <translation>Ниедна колона не се вика „%1“: тие се a b c d или r s theta phi, e f, и p или cumulative.</translation>
    </message>
    <message>
        <source>“%1” is there twice.</source>
        <translation>„%1“ се јавува двапати.</translation>
    </message>
    <message>
        <source>A row has one weight: p or cumulative.</source>
        <translation>Една редица има една тежина: p или cumulative.</translation>
    </message>
    <message>
        <source>a b c d and r s theta phi do not go together.</source>
        <translation>a b c d и r s theta phi не одат заедно.</translation>
    </message>
    <message>
        <source>Missing: %1.</source>
        <translation>Недостасува: %1.</translation>
    </message>
    <message>
        <source>The outline has more corners than programs read in one path. Choose a smaller depth.</source>
        <translation>Контурот има повеќе темиња отколку што програмите читаат во една патека. Изберете помала длабочина.</translation>
    </message>
    <message>
        <source>The cage bends or flattens the picture. The numbers are those of the picture at rest.</source>
        <translation>Кафезот ја витка или сплескува сликата. Броевите се на сликата во мирување.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8. Please rename the file, or lead to it by a link.</source>
        <translation>Името „%1“ не е во UTF-8. Преименувајте ја датотеката или водете до неа преку врска.</translation>
    </message>
    <message>
        <source>Map %1 has no weight, so the weights of all maps are taken from the determinants and those that are given are not used.</source>
        <translation>Пресликувањето %1 нема тежина, па тежините на сите пресликувања се земаат од детерминантите, а дадените не се користат.</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Contraction</source>
        <translation>Контракција</translation>
    </message>
    <message>
        <source>Every row of this table is a map that makes a smaller copy of the whole, and the picture is all copies together. Double-click a number and type another: the copy moves as you type. ‖A‖ is the most by which a map stretches. While it is less than 1, the map contracts. Ctrl+Z takes everything back.</source>
        <translation>Секоја редица од оваа табела е пресликување што прави помала копија од целината, а сликата ја сочинуваат сите копии заедно. Кликнете двапати на некој број и внесете друг: копијата се поместува додека пишувате. ‖A‖ кажува колку пати најмногу растегнува пресликувањето. Сѐ додека е помало од 1, пресликувањето е контракција. Ctrl+Z враќа сѐ како што беше.</translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation>Неподвижна точка</translation>
    </message>
    <message>
        <source>A map that contracts leaves exactly one point where it is: its fixed point. Switch off all maps but two by the boxes on the left of the table, and see how little is left of the picture. With one map alone nothing is left but its fixed point. Ctrl+Z brings the maps back.</source>
        <translation>Контракцијата остава точно една точка на нејзиното место: тоа е нејзината неподвижна точка. Со полињата лево во табелата исклучете ги сите пресликувања освен две и погледнете колку малку останува од сликата. Со само едно пресликување не останува ништо освен неговата неподвижна точка. Ctrl+Z ги враќа пресликувањата.</translation>
    </message>
    <message>
        <source>Chaos game</source>
        <translation>Игра на хаос</translation>
    </message>
    <message>
        <source>Press Chaos Game and then the triangle that starts it. One point jumps about, each time by a map drawn at random, and leaves a dot where it lands. Let it go faster: whatever the dice say, the dots fill the same picture, the attractor.</source>
        <translation>Притиснете „Игра на хаос“, а потоа триаголничето што ја започнува. Една точка скока, секојпат според случајно извлечено пресликување, и остава трага таму каде што ќе падне. Пуштете ја побрзо: што и да покаже коцката, трагите ја пополнуваат истата слика, атракторот.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адреса</translation>
    </message>
    <message>
        <source>The map that made the last jump to a point, the one before it, and so on: these numbers are the address of the point. Choose Colour by: Address. Points whose addresses begin alike lie close together, and now they look alike.</source>
        <translation>Пресликувањето што го направило последниот скок до некоја точка, па она пред него, и така натаму: тие броеви се адресата на точката. Изберете „Боја според: Адреса“. Точките чии адреси почнуваат исто лежат блиску една до друга, а сега и личат една на друга.</translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation>Барицентрични координати</translation>
    </message>
    <message>
        <source>Every point of the picture is a weighted mean of the three corners of the triangle. Take a corner and pull: the points keep their weights, and the whole fractal follows. Squeeze the triangle flat and open it again: nothing is lost. The weights at the pointer stand at the bottom of the window.</source>
        <translation>Секоја точка на сликата е тежинска средина на трите темиња на триаголникот. Фатете едно теме и повлечете: точките ги задржуваат своите тежини, а целиот фрактал се движи со нив. Сплескајте го триаголникот и повторно раширете го: ништо не се губи. Тежините кај покажувачот стојат на дното од прозорецот.</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Димензија</translation>
    </message>
    <message>
        <source>How much of the plane does the attractor fill? The dimension of a curve is 1, that of an area is 2, and most attractors lie between the two. Change a map and look here again. That was the tour; the user guide under Help tells the rest.</source>
        <translation>Колкав дел од рамнината исполнува атракторот? Димензијата на крива е 1, на плоштина 2, а повеќето атрактори се меѓу нив. Променете некое пресликување и погледнете повторно тука. Тоа беше обиколката; сѐ друго кажува упатството за корисници во менито „Помош“.</translation>
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
        <source>New here?</source>
        <translation>Првпат сте тука?</translation>
    </message>
    <message>
        <source>Six short steps show what an attractor is, by pulling on one. You can take the tour later, too: it is in the Help menu.</source>
        <translation>Шест кратки чекори покажуваат што е атрактор, така што ќе повлечете еден. Обиколката можете да ја направите и подоцна: таа е во менито „Помош“.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 од %2</translation>
    </message>
    <message>
        <source>&amp;Start the Tour</source>
        <translation>&amp;Започни ја обиколката</translation>
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
        <source>Not Now</source>
        <translation>Не сега</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>The last files, and the collection.</source>
        <translation>Последните датотеки и збирката.</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Добре дојдовте</translation>
    </message>
    <message>
        <source>Go on with</source>
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
        <source>A file, or the collection.</source>
        <translation>Датотека или збирката.</translation>
    </message>
    <message>
        <source>Begin with</source>
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
        <source>Takes what the dialog shows, and closes it.</source>
        <translation>Го презема она што го покажува дијалогот и го затвора.</translation>
    </message>
    <message>
        <source>Closes the dialog and changes nothing.</source>
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
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Овој запис нема пресликувања на рамнината.</translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation>Афино инваријантен облик</translation>
    </message>
    <message>
        <source>Row j of a matrix holds the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. The matrices do not change when the triangle is dragged. Where no entry is negative, the map takes the triangle into itself.</source>
        <translation>Редицата j на матрицата ги содржи барицентричните координати на сликата на темето j во однос на триаголникот, па збирот на секоја редица е 1. Матриците не се менуваат кога се влече триаголникот. Ако ниеден елемент не е негативен, пресликувањето го пресликува триаголникот во самиот себе.</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Копирај</translation>
    </message>
    <message>
        <source>Every map as a matrix that takes barycentric coordinates over the control triangle to barycentric coordinates: each row has the sum 1.</source>
        <translation>Секое пресликување како матрица што барицентрични координати во однос на контролниот триаголник ги пресликува во барицентрични координати: збирот на секоја редица е 1.</translation>
    </message>
    <message>
        <source>Copies the triangle and the matrices with all digits.</source>
        <translation>Ги копира триаголникот и матриците со сите цифри.</translation>
    </message>
    <message>
        <source>
… and %1 more. Copy takes all of them.
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
        <source>Copy all facts with all digits</source>
        <translation>Копирај ги сите својства со сите цифри</translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation>3D: засега не се прикажува.</translation>
    </message>
    <message>
        <source>This entry could not be read, so nothing is known of it.</source>
        <translation>Овој запис не можеше да се прочита, па за него не е познато ништо.</translation>
    </message>
    <message>
        <source>Copy with All Digits</source>
        <translation>Копирај со сите цифри</translation>
    </message>
    <message>
        <source>Copy All Facts</source>
        <translation>Копирај ги сите својства</translation>
    </message>
    <message>
        <source>Copies every line as its name and its value with all digits.</source>
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
        <source>Show the mean and the ellipse of the covariance</source>
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
        <source>Outline the hulls of all pieces with an address of the same length, in the colour of its first map</source>
        <translation>Исцртај ги обвивките на сите делови со адреса со иста должина, во бојата на нејзиното прво пресликување</translation>
    </message>
    <message>
        <source>Length of the addresses</source>
        <translation>Должина на адресите</translation>
    </message>
    <message>
        <source>How many symbols the addresses of the cylinders have; fewer where there would be thousands</source>
        <translation>Колку симболи имаат адресите на цилиндрите; помалку каде што би имало илјадници</translation>
    </message>
    <message>
        <source>Address length</source>
        <translation>Должина на адреса</translation>
    </message>
    <message>
        <source>The cage bends the picture, and no system has it. These are facts of the code; on the canvas they are bent with the picture.</source>
        <translation>Кафезот ја свиткува сликата и ниеден систем ја нема. Ова се својства на кодот; на платното тие се свиткани со сликата.</translation>
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
        <source>Every setting of this panel as in a new fractal</source>
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
        <source>The palette follows the density of points</source>
        <translation>Палетата ја следи густината на точките</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Пресликување</translation>
    </message>
    <message>
        <source>The colour of the last map applied</source>
        <translation>Бојата на последното применето пресликување</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адреса</translation>
    </message>
    <message>
        <source>The palette follows the address of each point</source>
        <translation>Палетата ја следи адресата на секоја точка</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Едноставно</translation>
    </message>
    <message>
        <source>One colour; the density is its opacity</source>
        <translation>Една боја; густината е нејзината непроѕирност</translation>
    </message>
    <message>
        <source>Change what the colour shows</source>
        <translation>Промена на она што го покажува бојата</translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation>Единствена боја</translation>
    </message>
    <message>
        <source>Change the plain colour</source>
        <translation>Промена на единствената боја</translation>
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
        <source>Change the palette</source>
        <translation>Промена на палетата</translation>
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
        <source>Change the background colour</source>
        <translation>Промена на бојата на позадината</translation>
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
        <source>Change the brightness</source>
        <translation>Промена на осветленоста</translation>
    </message>
    <message>
        <source>How early thin parts become visible: κ of the logarithmic tone curve</source>
        <translation>Колку рано стануваат видливи ретките делови: κ од логаритамската тонска крива</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Гама</translation>
    </message>
    <message>
        <source>Change the gamma</source>
        <translation>Промена на гама</translation>
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
        <source>Change the supersampling</source>
        <translation>Промена на суперсемплирањето</translation>
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
        <source>Change the colour of map %1</source>
        <translation>Промена на бојата на пресликувањето %1</translation>
    </message>
    <message>
        <source>What the colour of a point tells: how many points fall there, which map came last, or the whole address.</source>
        <translation>Што кажува бојата на една точка: колку точки паѓаат таму, кое пресликување било последно или целата адреса.</translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, or along the addresses.</source>
        <translation>Боите од најретките делови до најгустите, или по адресите.</translation>
    </message>
    <message>
        <source>Leaves the background out of exported pictures.</source>
        <translation>Ја изоставува позадината од извезените слики.</translation>
    </message>
    <message>
        <source>Draws every pixel from several finer ones: smoother edges, for more memory and time.</source>
        <translation>Го црта секој пиксел од неколку поситни: помазни рабови, но повеќе меморија и време.</translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The number beside it is the same value.</source>
        <translation>Влечете или користете ги стрелките. Бројот до лизгачот ја покажува истата вредност.</translation>
    </message>
</context>
<context>
    <name>view::ArisingBar</name>
    <message>
        <source>How the attractor arises</source>
        <translation>Како настанува атракторот</translation>
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
        <source>Steps Wⁿ</source>
        <translation>Чекори Wⁿ</translation>
    </message>
    <message>
        <source>The deterministic algorithm: all maps applied n times to the cage at rest</source>
        <translation>Детерминистичкиот алгоритам: сите пресликувања применети n пати врз кафезот во мирување</translation>
    </message>
    <message>
        <source>Chaos Game</source>
        <translation>Игра на хаос</translation>
    </message>
    <message>
        <source>One point that jumps by maps drawn at random; the first 14 points are not plotted</source>
        <translation>Една точка што скока според случајно извлечени пресликувања; првите 14 точки не се цртаат</translation>
    </message>
    <message>
        <source>n: how often all maps are applied</source>
        <translation>n: колку пати се применуваат сите пресликувања</translation>
    </message>
    <message>
        <source>Begin Again</source>
        <translation>Почни одново</translation>
    </message>
    <message>
        <source>No points yet, and other dice</source>
        <translation>Одново без ниедна точка, со други случајни броеви</translation>
    </message>
    <message>
        <source>One Point</source>
        <translation>Една точка</translation>
    </message>
    <message>
        <source>Plot one more point</source>
        <translation>Нацртај уште една точка</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Започни</translation>
    </message>
    <message>
        <source>Let points appear</source>
        <translation>Нека се појавуваат точки</translation>
    </message>
    <message>
        <source>Points a second</source>
        <translation>Точки во секунда</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 во секунда</translation>
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
        <source>Stay at these points</source>
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
        <source>How often all maps are applied to the cage: 0 is the cage itself, and with every step the picture comes closer to the attractor.</source>
        <translation>Колку пати сите пресликувања се применуваат врз кафезот: 0 е самиот кафез, а со секој чекор сликата се приближува кон атракторот.</translation>
    </message>
    <message>
        <source>How many points the chaos game plots in a second.</source>
        <translation>Колку точки црта играта на хаос во една секунда.</translation>
    </message>
    <message>
        <source>no points yet: press ▶</source>
        <translation>сè уште нема точки: притиснете ▶</translation>
    </message>
</context>
<context>
    <name>view::BoxCountingPlot</name>
    <message>
        <source>Box-counting plot</source>
        <translation>Дијаграм на броење кутии</translation>
    </message>
    <message>
        <source>How many boxes meet the attractor, against how fine they are: log₂ N over k for boxes of side L·2⁻ᵏ, L the side of the square around the attractor. Points in outline are left out of the line: there the size of the whole or of a cell shows.</source>
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
        <source>How many maps of the address name the branch (Shift + wheel over the canvas)</source>
        <translation>Колку пресликувања од адресата ја именуваат гранката (Shift + тркалце над платното)</translation>
    </message>
    <message>
        <source>The address of the point clicked, outermost map first; the branch is what is bold</source>
        <translation>Адресата на кликнатата точка, прво најнадворешното пресликување; гранката е она што е задебелено</translation>
    </message>
    <message>
        <source>this branch, as a map of its own</source>
        <translation>оваа гранка, како посебно пресликување</translation>
    </message>
    <message>
        <source>The system gets a map for this branch and one for every branch beside it. Its change is seen again at all smaller scales.</source>
        <translation>Системот добива пресликување за оваа гранка и по едно за секоја гранка покрај неа. Промената се гледа пак во сите помали размери.</translation>
    </message>
    <message>
        <source>the last map of its address</source>
        <translation>последното пресликување од нејзината адреса</translation>
    </message>
    <message>
        <source>The code keeps its maps. All branches that this map makes change alike.</source>
        <translation>Кодот ги задржува своите пресликувања. Сите гранки што ги прави ова пресликување се менуваат еднакво.</translation>
    </message>
    <message>
        <source>What changing the branch changes</source>
        <translation>Што менува промената на гранката</translation>
    </message>
    <message>
        <source>&amp;Weave</source>
        <translation>&amp;Ткај</translation>
    </message>
    <message>
        <source>Angle by which the selected maps swing about their roots</source>
        <translation>Агол за кој избраните пресликувања се нишаат околу своите корени</translation>
    </message>
    <message>
        <source>Lets the selected maps swing, each about the image of the lowest point of the fractal; the slider goes back to the middle when it is let go</source>
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
        <source>Let maps swing</source>
        <translation>Нишање на пресликувања</translation>
    </message>
    <message>
        <source>where it is shown, and it alone</source>
        <translation>каде се прикажува, и само таа</translation>
    </message>
    <message>
        <source>The code stays as it is. This branch is shown elsewhere, and nothing like it at other scales.</source>
        <translation>Кодот останува каков што е. Оваа гранка се прикажува на друго место, и ништо слично на неа во други размери.</translation>
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
        <source>Shows the branch where its maps put it</source>
        <translation>Ја прикажува гранката таму каде што ја ставаат нејзините пресликувања</translation>
    </message>
    <message>
        <source>Shows every branch where its maps put it</source>
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
</context>
<context>
    <name>view::BranchTool</name>
    <message>
        <source>Click a point of the attractor to select its branch.</source>
        <translation>Кликнете на точка од атракторот за да ја изберете нејзината гранка.</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Гранка %1</translation>
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
        <source>Rotate branch %1</source>
        <translation>Ротирај ја гранката %1</translation>
    </message>
    <message>
        <source>Scale branch %1</source>
        <translation>Скалирај ја гранката %1</translation>
    </message>
    <message>
        <source>This branch is map 1 now. Numbers in the table change it further.</source>
        <translation>Оваа гранка сега е пресликување 1. Броевите во табелата ја менуваат понатаму.</translation>
    </message>
</context>
<context>
    <name>view::CageActions</name>
    <message>
        <source>This entry is not a system of the plane, so it has no control cage.</source>
        <translation>Овој запис не е систем во рамнината, па нема контролен кафез.</translation>
    </message>
    <message>
        <source>The cage is too flat to be undone. Open it by dragging a vertex, or reset it, and try again.</source>
        <translation>Кафезот е премногу сплескан за да може да се врати. Раширете го со влечење на некое теме или вратете го во мирување, па обидете се повторно.</translation>
    </message>
    <message>
        <source>The three points lie on one line and hold no coordinates. Put the third one beside the line.</source>
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
        <source>Vertex %1 is there already.</source>
        <translation>Темето %1 е веќе таму.</translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation>Поместување на темето %1</translation>
    </message>
    <message>
        <source>A cage has at most %1 vertices.</source>
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
        <source>A cage has at least three vertices.</source>
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
        <source>Unbake: take the placement out of the code</source>
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
        <source>The cage is the minimal canonical simplex already.</source>
        <translation>Кафезот веќе е минималниот каноничен симплекс.</translation>
    </message>
    <message>
        <source>The cage is regular already.</source>
        <translation>Кафезот веќе е правилен.</translation>
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
        <source>Moving the cage moves the picture; the code stays</source>
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
        <source>Every vertex is followed; the picture bends, which cannot be baked into a code</source>
        <translation>Се следи секое теме; сликата се свиткува, а тоа не може да се впише во кодот</translation>
    </message>
    <message>
        <source>The picture moves by the affine map that comes nearest to the vertices; it can be baked</source>
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
        <source>Define the triangle by three clicks on the canvas; the picture stays</source>
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
        <source>Show the vertices that hold the attractor while the cage is at rest</source>
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
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs say to which side its legs point from the right angle.</source>
        <translation>Најмалиот рамнокрак правоаголен триаголник со катети паралелни на оските што ја содржи сликата. Знаците кажуваат на која страна од правиот агол се насочени катетите.</translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation>Барицентрични координати на точка</translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 that the vertices take to balance in the point.</source>
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
        <source>Move vertex %1</source>
        <translation>Поместување на темето %1</translation>
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
        <source>Define vertex %1</source>
        <translation>Дефинирање на темето %1</translation>
    </message>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation>Сликата е претенка за таков кафез.</translation>
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
        <source>3D: not yet shown.</source>
        <translation>3D: засега не се прикажува.</translation>
    </message>
    <message>
        <source>This entry could not be read, so it has no cage.</source>
        <translation>Овој запис не можеше да се прочита, па нема кафез.</translation>
    </message>
    <message>
        <source>At rest: the picture is that of the code.</source>
        <translation>Во мирување: сликата е онаа на кодот.</translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture is that of the code.</source>
        <translation>%1 темиња, во мирување: сликата е онаа на кодот.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates, not bakeable.</source>
        <translation>%1 темиња: свиткана со Вакспресови координати, не може да се впише во кодот.</translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, not bakeable.</source>
        <translation>%1 темиња: свиткана со координати на средна вредност, не може да се впише во кодот.</translation>
    </message>
    <message>
        <source>Flat: the picture lies on one line. Open the cage and it comes back.</source>
        <translation>Сплескано: сликата лежи на една права. Раширете го кафезот и таа се враќа.</translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the sense of rotation is reversed.</source>
        <translation>Поставена и огледално превртена: плоштините се менуваат со коефициент %1, а ориентацијата е спротивна.</translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation>Поставена: плоштините се менуваат со коефициент %1.</translation>
    </message>
    <message>
        <source>The triangle is flat: it holds no coordinates.</source>
        <translation>Триаголникот е сплескан: не определува координати.</translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation>%1, катета %2, теме (%3, %4)</translation>
    </message>
    <message>
        <source>Hold the picture by a fitted cage; the picture stays</source>
        <translation>Опфати ја сликата со нов кафез; сликата останува иста</translation>
    </message>
    <message>
        <source>Put the cage and the picture back to rest</source>
        <translation>Врати ги кафезот и сликата во мирување</translation>
    </message>
    <message>
        <source>Make the displayed picture the code; the cage then rests</source>
        <translation>Впиши ја прикажаната слика во кодот; потоа кафезот е во мирување</translation>
    </message>
    <message>
        <source>The cage is there already.</source>
        <translation>Кафезот веќе е таму.</translation>
    </message>
    <message>
        <source>The coordinates are read over a triangle.</source>
        <translation>Координатите се читаат над триаголник.</translation>
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
        <source>Select a vertex first.</source>
        <translation>Прво избери теме.</translation>
    </message>
    <message>
        <source>Point at an edge, or select a vertex, to insert one.</source>
        <translation>За да вметнеш теме, покажи на страна или избери теме.</translation>
    </message>
</context>
<context>
    <name>view::Canvas</name>
    <message>
        <source>No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). Make it smaller, or switch it off.</source>
        <translation>Нема атрактор: пресликувањето %1 не е контракција (најголема сингуларна вредност %2, спектрален радиус %3). Смалете го или исклучете го.</translation>
    </message>
    <message>
        <source>No attractor: the maps %1, one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation>Нема атрактор: пресликувањата %1, едно по друго, не се контракција (најголема сингуларна вредност %2, спектрален радиус %3). Смалете некое од нив или исклучете го.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor: map %1 stretches by %2. Points that run away are left out.</source>
        <translation>Не е утврдено дали овој систем има атрактор: пресликувањето %1 растегнува %2 пати. Точките што бегаат се изоставени.</translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor. Points that run away are left out.</source>
        <translation>Не е утврдено дали овој систем има атрактор. Точките што бегаат се изоставени.</translation>
    </message>
    <message>
        <source>This entry is a system in space: not yet shown. It is kept as it is.</source>
        <translation>Овој запис е систем во просторот: засега не се прикажува. Тој е задржан како што е.</translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept as it is in the file.</source>
        <translation>Овој запис не можеше да се прочита. Неговиот текст е задржан како што е во датотеката.</translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to draw. Add a map or switch one on.</source>
        <translation>Не учествува ниедно пресликување, па нема што да се црта. Додајте пресликување или вклучете некое.</translation>
    </message>
    <message>
        <source>This is as deep as the arithmetic reaches: zoom out a little for a true picture.</source>
        <translation>Подлабоко од ова аритметиката не стигнува: намалете го малку приказот за верна слика.</translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than asked for: more would need more memory than allowed.</source>
        <translation>Нацртано со помалку итерации од бараните: за повеќе би требало повеќе меморија од дозволената.</translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a vertex to open it: nothing is lost.</source>
        <translation>Кафезот е сплескан, па и сликата. Повлечете некое теме за да го раширите: ништо не се губи.</translation>
    </message>
    <message>
        <source>Stopped: any farther, map %1 would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Запрено: понатаму пресликувањето %1 не би контрахирало (најголема сингуларна вредност %2, спектрален радиус %3) и не би имало атрактор.</translation>
    </message>
    <message>
        <source>Stopped: any farther, the maps %1, one after the other, would not contract (largest singular value %2, spectral radius %3), and there would be no attractor.</source>
        <translation>Запрено: понатаму пресликувањата %1, едно по друго, не би контрахирале (најголема сингуларна вредност %2, спектрален радиус %3) и не би имало атрактор.</translation>
    </message>
    <message>
        <source>Stopped: any farther, it is not settled whether there would be an attractor (map %1 has the largest singular value, %2).</source>
        <translation>Запрено: понатаму не е решено дали би имало атрактор (пресликувањето %1 има најголема сингуларна вредност, %2).</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point.</source>
        <translation>Само едно пресликување: останува единствено неговата неподвижна точка.</translation>
    </message>
    <message>
        <source>One map alone: nothing is left but its fixed point (%1, %2).</source>
        <translation>Само едно пресликување: останува единствено неговата неподвижна точка (%1, %2).</translation>
    </message>
    <message>
        <source>No map that is on has a weight above 0, so there is nothing to draw. Give one a weight.</source>
        <translation>Ниедно вклучено пресликување нема тежина поголема од 0, па нема што да се црта. Дајте му тежина на некое.</translation>
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
        <source>Types the place of this vertex</source>
        <translation>Го внесува местото на ова теме со броеви</translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation>&amp;Врати го темето во мирување</translation>
    </message>
    <message>
        <source>Puts this vertex back to rest</source>
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
        <source>Takes this vertex out of the cage</source>
        <translation>Го вади ова теме од кафезот</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation>Премести го с&amp;тожерот тука</translation>
    </message>
    <message>
        <source>Turns and scales the cage about this vertex</source>
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
        <source>Puts one more vertex on this edge; a double click does the same</source>
        <translation>Става уште едно теме на оваа страна; истото го прави и двојното кликање</translation>
    </message>
    <message>
        <source>Rotate: Shift turns in steps of 15°</source>
        <translation>Ротирање: Shift врти во чекори од 15°</translation>
    </message>
    <message>
        <source>Scale: Shift keeps to x or y</source>
        <translation>Скалирање: Shift останува на x или y</translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation>Стожер</translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Middle</source>
        <translation>Премести го стожерот во с&amp;редината</translation>
    </message>
    <message>
        <source>Turns and scales the cage about its middle</source>
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
        <source>Holds the picture by the smallest right-angled triangle around it</source>
        <translation>Ја опфаќа сликата со најмалиот рамнокрак правоаголен триаголник околу неа</translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation>&amp;Дефинирај триаголник</translation>
    </message>
    <message>
        <source>Holds the picture by three points that are clicked</source>
        <translation>Ја држи сликата со три точки избрани со кликање</translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation>Врати го ка&amp;фезот во мирување</translation>
    </message>
    <message>
        <source>Puts every vertex back to rest</source>
        <translation>Ги враќа сите темиња во мирување</translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation>&amp;Направи го правилен</translation>
    </message>
    <message>
        <source>Puts the vertices on the regular polygon nearest to them</source>
        <translation>Ги става темињата на правилниот многуаголник што им е најблизок</translation>
    </message>
    <message>
        <source>&amp;Bake Placement into the Code</source>
        <translation>Впи&amp;ши ја поставеноста во кодот</translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw what is shown, with the cage at rest</source>
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
        <source>Shows one unit of the plane as a hundred pixels</source>
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
        <source>Turns the plane over, as on the screen of a computer</source>
        <translation>Ја превртува рамнината, како на компјутерски екран</translation>
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
        <source>Copies the picture as it is seen, without the cage</source>
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
        <source>Lets this map take part, or not</source>
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
        <source>Puts a copy of this map beside it</source>
        <translation>Става копија на ова пресликување до него</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Избриши</translation>
    </message>
    <message>
        <source>Takes this map out of the system</source>
        <translation>Го вади ова пресликување од системот</translation>
    </message>
</context>
<context>
    <name>view::CanvasScene</name>
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
        <source>Rotate handle</source>
        <translation>Рачка за ротирање</translation>
    </message>
    <message>
        <source>Scale handle</source>
        <translation>Рачка за скалирање</translation>
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
        <source>Branch %1</source>
        <translation>Гранка %1</translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation>Пресликување %1</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, агол %2</translation>
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
        <source>Drag the pivot: turning and scaling are about it.</source>
        <translation>Влечете ја стожерната точка: ротирањето и скалирањето се околу неа.</translation>
    </message>
    <message>
        <source>Drag to turn about the pivot; Shift: in steps of 15°.</source>
        <translation>Влечете за ротирање околу стожерот; Shift: во чекори од 15°.</translation>
    </message>
    <message>
        <source>Drag to scale about the pivot; Shift: along x or y only.</source>
        <translation>Влечете за скалирање околу стожерот; Shift: само по x или y.</translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation>Платно</translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab goes from handle to handle, the arrow keys move the one in focus, F6 leaves the canvas.</source>
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
        <source>Put the cage back to rest first?</source>
        <translation>Прво да се врати кафезот во мирување?</translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation>Врати го кафезот во мирување</translation>
    </message>
    <message>
        <source>Only the picture is shown. Press H to see the cage again.</source>
        <translation>Се прикажува само сликата. Притиснете H за повторно да го видите кафезот.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; Ctrl turns, Alt scales, Shift keeps directions. The wheel zooms at the pointer, the middle button moves the plane. Tab goes from handle to handle, arrow keys move them, F6 leaves.</source>
        <translation>Сликата и нејзиниот кафез. Влечете теме, страна или внатрешноста на кафезот; Ctrl ротира, Alt скалира, Shift ги задржува правците. Тркалцето зумира кај покажувачот, средното копче ја поместува рамнината. Tab оди од рачка на рачка, стрелките ја поместуваат избраната, F6 го напушта платното.</translation>
    </message>
</context>
<context>
    <name>view::Clipboard</name>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation>вметнато</translation>
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
        <source>Fractals of the collection</source>
        <translation>Фрактали од збирката</translation>
    </message>
    <message>
        <source>No favourites yet. Choose a fractal and press Ctrl+D.</source>
        <translation>Сѐ уште нема омилени. Изберете фрактал и притиснете Ctrl+D.</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Ништо тука не ги содржи овие зборови.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Отвори</translation>
    </message>
    <message>
        <source>Open the chosen fractal as a document of its own.</source>
        <translation>Отвори го избраниот фрактал како посебен документ.</translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation>&amp;Додај во оваа датотека</translation>
    </message>
    <message>
        <source>Add the chosen fractal to the open file.</source>
        <translation>Додај го избраниот фрактал во отворената датотека.</translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation>О&amp;милен</translation>
    </message>
    <message>
        <source>Mark the chosen fractal as one of your favourites.</source>
        <translation>Означи го избраниот фрактал како омилен.</translation>
    </message>
    <message>
        <source>Only Fa&amp;vourites</source>
        <translation>Само омил&amp;ени</translation>
    </message>
    <message>
        <source>Show nothing but your favourites.</source>
        <translation>Прикажи ги само омилените.</translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation>Додај &amp;папка…</translation>
    </message>
    <message>
        <source>Show the .ifs files of a folder of yours here, too.</source>
        <translation>Прикажи ги тука и .ifs-датотеките од Ваша папка.</translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation>О&amp;тстрани ја папката „%1“</translation>
    </message>
    <message>
        <source>Show this folder here no more. Its files stay as they are.</source>
        <translation>Не ја прикажувај повеќе оваа папка тука. Датотеките во неа остануваат какви што се.</translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation>Папка со .ifs-датотеки</translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment has these words. Enter opens the first of them.</source>
        <translation>Ги прикажува само фракталите чие име, тема или коментар ги содржи овие зборови. Enter го отвора првиот од нив.</translation>
    </message>
    <message>
        <source>Fractals to begin with. Double-click or Enter opens one in this window; the menu of the right button adds it to the file instead.</source>
        <translation>Фрактали за почеток. Двојно кликање или Enter го отвора фракталот во овој прозорец; менито на десното копче го додава во датотеката.</translation>
    </message>
    <message>
        <source>Files of the collection that were read</source>
        <translation>Прочитани датотеки од збирката</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Запри со читање</translation>
    </message>
    <message>
        <source>Stop reading this folder. What was read so far stays here.</source>
        <translation>Запри со читање на оваа папка. Прочитаното останува тука.</translation>
    </message>
    <message>
        <source>Reading the collection…</source>
        <translation>Се чита збирката…</translation>
    </message>
    <message>
        <source>Reading “%1”…</source>
        <translation>Се чита „%1“…</translation>
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
        <source>a b e c d f p: each equation in a row</source>
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
        <source>a b c d e f, and weights that add up row by row</source>
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
        <source>Names of the columns in their order</source>
        <translation>Имињата на колоните по ред</translation>
    </message>
    <message>
        <source>The names of the columns in their order: a b c d or r s theta phi, then e and f, each once, and p for a weight or cumulative for a sum of weights where there is one. x′ = a·x + b·y + e and y′ = c·x + d·y + f.</source>
        <translation>Имињата на колоните по ред: a b c d или r s theta phi, потоа e и f, секое еднаш, и p за тежина или cumulative за збир на тежини каде што го има. x′ = a·x + b·y + e и y′ = c·x + d·y + f.</translation>
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
        <source>Type some letters of what you want to do. Arrow keys choose, Enter does it.</source>
        <translation>Напишете неколку букви од она што сакате да го направите. Стрелките избираат, Enter извршува.</translation>
    </message>
    <message>
        <source>The commands whose names have these letters.</source>
        <translation>Наредбите чии имиња ги содржат овие букви.</translation>
    </message>
    <message>
        <source>No command is called that.</source>
        <translation>Нема команда со такво име.</translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three vertices. The picture stays where it is; Esc leaves.</source>
        <translation>Кликнете на првото од трите темиња. Сликата останува каде што е; Esc прекинува.</translation>
    </message>
    <message>
        <source>Click the second vertex. Backspace takes the first one back.</source>
        <translation>Кликнете на второто теме. Backspace го враќа првото.</translation>
    </message>
    <message>
        <source>Click the third vertex. Backspace takes the second one back.</source>
        <translation>Кликнете на третото теме. Backspace го враќа второто.</translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation>Коментар на „%1“</translation>
    </message>
    <message>
        <source>Comment behind the name</source>
        <translation>Коментар по името</translation>
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
        <source>Written as lines of their own below the name, each behind a semicolon.</source>
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
        <source>&amp;Behind the name:</source>
        <translation>&amp;По името:</translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation>&amp;Редови на коментарот:</translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines keep the cage and the colours.</source>
        <translation>Коментарот не може да почнува со „barycage:“; таквите редови ги чуваат кафезот и боите.</translation>
    </message>
    <message>
        <source>A line holds at most %1 bytes; Fractint cuts longer ones. Break it in two.</source>
        <translation>Редот содржи најмногу %1 бајти; подолгите Fractint ги сече. Поделете го на два.</translation>
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
    <name>view::EntriesEdits</name>
    <message>
        <source>An entry needs a name.</source>
        <translation>Записот мора да има име.</translation>
    </message>
    <message>
        <source>A name holds no blanks: Fractint would read its first word only.</source>
        <translation>Името не смее да содржи празни места: Fractint би го прочитал само првиот збор.</translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation>„%1“ не може да биде дел од името, бидејќи има посебно значење во .ifs-датотеките.</translation>
    </message>
    <message>
        <source>A name has at most %1 characters; Fractint ignores the rest.</source>
        <translation>Името има најмногу %1 знаци; остатокот Fractint го занемарува.</translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation>Fractint не наведува запис со име „%1“; изберете друго име.</translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case count as equal).</source>
        <translation>Друг запис се вика „%1“ (големите и малите букви не се разликуваат).</translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation>Преименување на „%1“ во „%2“</translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation>3D: засега не се прикажува</translation>
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
        <source>This file holds no entries. Add one, or paste the text of an .ifs file.</source>
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
        <source>Paste the entries of .ifs text behind the current entry.</source>
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
        <source>An entry that could not be read cannot be duplicated: it would keep its name.</source>
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
        <source>There is no entry of an .ifs file in what was pasted.</source>
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
        <source>%n pasted entries could not be read; their text is kept as it is.</source>
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
        <source>No entry has “%1” in its name.</source>
        <translation>Ниеден запис нема „%1“ во името.</translation>
    </message>
    <message>
        <source>Shows only the entries whose name has these letters.</source>
        <translation>Ги прикажува само записите чие име ги содржи овие букви.</translation>
    </message>
    <message>
        <source>The fractals of the file. Click one to edit it, drag it to another place, press F2 to give it another name.</source>
        <translation>Фракталите во датотеката. Кликнете на некој за да го уредувате, повлечете го на друго место, притиснете F2 за да му дадете друго име.</translation>
    </message>
    <message>
        <source>Nothing was pasted: there is no text on the clipboard.</source>
        <translation>Ништо не е вметнато: нема текст на таблата со исечоци.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Се чита вметнатото…</translation>
    </message>
    <message>
        <source>Adding entries…</source>
        <translation>Се додаваат записи…</translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation>Извоз на податоци од „%1“</translation>
    </message>
    <message>
        <source>What the file will hold</source>
        <translation>Што ќе содржи датотеката</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Резултат</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Напредок на извозот</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Извези…</translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation>Копирај &amp;текст</translation>
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
        <source>Table with commas (.csv)</source>
        <translation>Табела со запирки (.csv)</translation>
    </message>
    <message>
        <source>Table with tabs (.tsv)</source>
        <translation>Табела со табулатори (.tsv)</translation>
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
        <source>&amp;Turn y around, so that the flame is the same way up</source>
        <translation>П&amp;реврти ја y-оската, за пламенот да стои исправено</translation>
    </message>
    <message>
        <source>&amp;Bake the placement, so that the maps draw what is shown</source>
        <translation>&amp;Впиши ја поставеноста, за пресликувањата да го цртаат прикажаното</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Формат:</translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation>&amp;Колони:</translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation>Т&amp;очки:</translation>
    </message>
    <message>
        <source>Only the numbers of plane systems can be exported.</source>
        <translation>Можат да се извезат само броевите на системи во рамнината.</translation>
    </message>
    <message>
        <source>The points of the chaos game where they are shown, without the first 14.</source>
        <translation>Точките од играта на хаос таму каде што се прикажани, без првите 14.</translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation>Датотеки %1 (*.%2)</translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation>Извоз на податоци</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Запри</translation>
    </message>
    <message>
        <source>The text is on the clipboard.</source>
        <translation>Текстот е на таблата со исечоци.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Затвори</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>Извозот е запрен; ништо не е запишано.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Запишано во %1.</translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation>Почетокот на датотеката како што ќе биде запишана.</translation>
    </message>
    <message>
        <source>For which program the data are: each format has what that program reads.</source>
        <translation>За која програма се податоците: секој формат го содржи она што го чита таа програма.</translation>
    </message>
    <message>
        <source>The order in which each row has its coefficients; other programs expect other orders.</source>
        <translation>Редоследот на коефициентите во секоја редица; другите програми очекуваат поинаков редослед.</translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation>Колку точки од играта на хаос се запишуваат.</translation>
    </message>
    <message>
        <source>Flame programs let y grow downwards. With this the flame looks as the fractal does here; without it the numbers are the same.</source>
        <translation>Flame-програмите пуштаат y да расте надолу. Со ова пламенот изгледа како фракталот тука; без ова броевите остануваат исти.</translation>
    </message>
    <message>
        <source>With this, the cage is made part of the maps. Without it, the maps are written as they stand in the table.</source>
        <translation>Со ова кафезот станува дел од пресликувањата. Без ова пресликувањата се запишуваат како што стојат во табелата.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it.</source>
        <translation>Прашува за името на датотеката и ја запишува.</translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation>Го копира целиот текст на таблата со исечоци наместо да запише датотека.</translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation>Извоз на „%1“</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Извези…</translation>
    </message>
    <message>
        <source>PNG: pixels</source>
        <translation>PNG: пиксели</translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation>SVG: облици за програми за цртање</translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation>PDF: облици за печатење</translation>
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
        <source>Include the &amp;control triangle</source>
        <translation>Вклучи го &amp;контролниот триаголник</translation>
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
        <source>Draft: 25 samples a pixel</source>
        <translation>Скица: 25 примероци по пиксел</translation>
    </message>
    <message>
        <source>Good: 100 samples a pixel</source>
        <translation>Добро: 100 примероци по пиксел</translation>
    </message>
    <message>
        <source>Fine: 400 samples a pixel</source>
        <translation>Фино: 400 примероци по пиксел</translation>
    </message>
    <message>
        <source>Finest: 2000 samples a pixel</source>
        <translation>Најфино: 2000 примероци по пиксел</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Квалитет</translation>
    </message>
    <message>
        <source>Cells along the side of a pixel</source>
        <translation>Ќелии долж страната на пикселот</translation>
    </message>
    <message>
        <source>8 bits a channel</source>
        <translation>8 бита по канал</translation>
    </message>
    <message>
        <source>16 bits a channel, for further work on the picture</source>
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
        <source>&amp;Supersampling:</source>
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
        <source>As deep as a pixel &amp;needs</source>
        <translation>Колку што &amp;треба за еден пиксел</translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation>Нивоа на копии</translation>
    </message>
    <message>
        <source>What the picture will be like</source>
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
        <source>Result</source>
        <translation>Резултат</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Напредок на извозот</translation>
    </message>
    <message>
        <source>Only plane systems can be exported as a picture.</source>
        <translation>Како слика можат да се извезат само системи во рамнината.</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>околу %1</translation>
    </message>
    <message>
        <source>One dot for every point of the chaos game that is in view.</source>
        <translation>По една точка за секоја видлива точка од играта на хаос.</translation>
    </message>
    <message>
        <source> The cage bends the picture, which copies cannot follow: the affine fit of the cage is written. A PNG shows the bend.</source>
        <translation> Кафезот ја свиткува сликата, а копиите не можат да го следат тоа: се запишува афиното приближување на кафезот. PNG го покажува свиткувањето.</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-документи (*.pdf)</translation>
    </message>
    <message>
        <source>Scalable pictures (*.svg)</source>
        <translation>Векторски слики (*.svg)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Слики (*.png)</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Извоз на слика</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation>Извозот е запрен; ништо не е запишано.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Запишано во %1.</translation>
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
        <source>PNG is a picture of pixels; SVG and PDF are made of shapes, which stay sharp at every size.</source>
        <translation>PNG е слика од пиксели; SVG и PDF се составени од облици, кои остануваат остри во секоја големина.</translation>
    </message>
    <message>
        <source>The picture has no background and can be laid over another.</source>
        <translation>Сликата нема позадина и може да се стави врз друга.</translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation>Го црта кафезот врз сликата.</translation>
    </message>
    <message>
        <source>How many points are drawn for each pixel: more make a smoother picture and take longer.</source>
        <translation>Колку точки се цртаат за секој пиксел: со повеќе точки сликата е помазна, но трае подолго.</translation>
    </message>
    <message>
        <source>Every pixel is drawn from so many finer ones along its side: smoother edges, for more memory and time.</source>
        <translation>Секој пиксел се црта од толку поситни пиксели долж неговата страна: помазни рабови, но повеќе меморија и време.</translation>
    </message>
    <message>
        <source>16 bits keep fine steps of brightness for later work in a picture editor; 8 bits are enough to look at.</source>
        <translation>16 бита ги задржуваат фините преливи на осветленоста за подоцнежна работа во уредувач на слики; за гледање се доволни 8 бита.</translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation>Копиите од копии даваат мала датотека што програмите за цртање можат да ја уредуваат; контурата е една патека; точките се точки од играта на хаос.</translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation>Колку точки од играта на хаос се цртаат.</translation>
    </message>
    <message>
        <source>How many levels of copies the picture has. The file hardly grows with it, the time to draw it does.</source>
        <translation>Колку нивоа на копии има сликата. Датотеката речиси не расте со нив, но времето за цртање расте.</translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it. The window can be used meanwhile.</source>
        <translation>Прашува за името на датотеката и ја запишува. Во меѓувреме прозорецот може да се користи.</translation>
    </message>
    <message>
        <source>Copying the picture…</source>
        <translation>Сликата се копира…</translation>
    </message>
    <message>
        <source>Copies are made smaller until no pixel of this size could tell the difference, or programs would take long to draw them.</source>
        <translation>Копиите се смалуваат сѐ додека ниеден пиксел со оваа големина не може да ја забележи разликата или додека на програмите не им треба долго да ги нацртаат.</translation>
    </message>
    <message>
        <source>%1 references (fewer than %3 are allowed). Nothing that is drawn is farther than %2 pixels from the attractor, and nothing of it is farther from what is drawn.</source>
        <translation>%1 упатувања (дозволени се помалку од %3). Ништо од нацртаното не е на растојание поголемо од %2 пиксели од атракторот и ниеден негов дел не е подалеку од нацртаното.</translation>
    </message>
    <message>
        <source> A pixel needs more: this is as deep as programs draw without a long wait.</source>
        <translation> За еден пиксел треба повеќе: ова е најголемата длабочина што програмите ја цртаат без долго чекање.</translation>
    </message>
    <message>
        <source>Working out the shapes…</source>
        <translation>Се пресметуваат облиците…</translation>
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
        <source>As on the screen</source>
        <translation>Како на екранот</translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation>%1 × екранот</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Сопствена големина</translation>
    </message>
    <message>
        <source>Size relative to the screen</source>
        <translation>Големина во однос на екранот</translation>
    </message>
    <message>
        <source>Keep shape</source>
        <translation>Задржи облик</translation>
    </message>
    <message>
        <source>Keep the shape of the picture on the screen</source>
        <translation>Задржи го обликот на сликата од екранот</translation>
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
        <source>A length in the unit chosen beside it. The other side follows while the shape is kept.</source>
        <translation>Должина во единицата избрана до неа. Другата страна се менува сразмерно додека се задржува обликот.</translation>
    </message>
    <message>
        <source>In pixels, or on paper at the resolution given.</source>
        <translation>Во пиксели, или на хартија со зададената резолуција.</translation>
    </message>
    <message>
        <source>The picture as on the screen or some times as large.</source>
        <translation>Сликата како на екранот или неколку пати поголема.</translation>
    </message>
    <message>
        <source>How many pixels go on an inch of paper: 300 is usual in print.</source>
        <translation>Колку пиксели доаѓаат на еден инч хартија: за печат вообичаени се 300.</translation>
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
        <source>Colour of the stop</source>
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
        <source>Add a stop after the chosen one</source>
        <translation>Додај маркер по избраниот</translation>
    </message>
    <message>
        <source>Delete Stop</source>
        <translation>Избриши маркер</translation>
    </message>
    <message>
        <source>Delete the chosen stop</source>
        <translation>Избриши го избраниот маркер</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Преврти</translation>
    </message>
    <message>
        <source>Turn the palette round</source>
        <translation>Преврти го редоследот на палетата</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Распореди</translation>
    </message>
    <message>
        <source>Put the stops at equal distances</source>
        <translation>Стави ги маркерите на еднакви растојанија</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Вчитај…</translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ugr or .map file</source>
        <translation>Вчитај палета од датотека .gpl, .ugr или .map</translation>
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
        <source>Palettes (*.gpl *.ugr *.gradient *.map);;All files (*)</source>
        <translation>Палети (*.gpl *.ugr *.gradient *.map);;Сите датотеки (*)</translation>
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
        <source>The palettes that the file holds. Choose one.</source>
        <translation>Палетите што ги содржи датотеката. Изберете една.</translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation>Маркери на градиентот</translation>
    </message>
    <message>
        <source>Double-click: new stop, or the colour of one. Drag: move. Del: delete it.
Keys: Page Up and Page Down choose a stop, the arrows move it, Ins adds one, Enter opens its colour.</source>
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
    <name>view::Guide</name>
    <message>
        <source>User Guide</source>
        <translation>Упатство за корисници</translation>
    </message>
    <message>
        <source>The user guide: what can be done here, in the order in which one needs it.</source>
        <translation>Упатството за корисници: што може да се направи тука, по редоследот по кој е потребно.</translation>
    </message>
    <message>
        <source>Find in the guide</source>
        <translation>Барај во упатството</translation>
    </message>
    <message>
        <source>Marks these words in the guide. Enter shows the next place, Shift+Enter the one before. Ctrl+F leads here.</source>
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
        <source>Choose a step to go back to it, or forward.</source>
        <translation>Изберете чекор за да се вратите на него или да одите напред.</translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward. The disk marks what is saved.</source>
        <translation>Изберете чекор за да се вратите на него или да одите напред. Дискетата означува што е зачувано.</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Како при отворањето</translation>
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
        <source>Scale across; negative when the map reflects</source>
        <translation>Размер напречно; негативен ако пресликувањето ја менува ориентацијата</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Искосување</translation>
    </message>
    <message>
        <source>Shear along x, applied before everything else</source>
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
        <source>Change the shape of map %1</source>
        <translation>Промена на обликот на пресликувањето %1</translation>
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
        <source>A reflected similarity keeps shapes, as a mirror does, and scales and shifts them.</source>
        <translation>Огледалната сличност го запазува обликот, како огледало, а притоа скалира и поместува.</translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels, not angles.</source>
        <translation>Афиното пресликување ги запазува правите и паралелноста, но не и аглите.</translation>
    </message>
    <message>
        <source>A singular map takes the plane to a line.</source>
        <translation>Сингуларното пресликување ја пресликува рамнината во права.</translation>
    </message>
    <message>
        <source>A constant map takes the plane to one point.</source>
        <translation>Константното пресликување ја пресликува рамнината во една точка.</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Вкл.</translation>
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
        <source>Effective code: the map as it acts on the picture under the current cage. Bake makes it the code.</source>
        <translation>Ефективен код: пресликувањето онака како што дејствува на сликата под сегашниот кафез. Со „Впиши“ тој станува код.</translation>
    </message>
    <message>
        <source>Whether the map takes part.</source>
        <translation>Дали пресликувањето учествува.</translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map.</source>
        <translation>Бојата на пресликувањето, кога сликата се бои според пресликување.</translation>
    </message>
    <message>
        <source>Weight as given: how often the chaos game takes the map. The weights need not sum to 1.</source>
        <translation>Тежината како што е зададена: колку често играта на хаос го зема пресликувањето. Збирот на тежините не мора да биде 1.</translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor of areas; negative when the map reflects.</source>
        <translation>Детерминантата ad − bc: коефициентот со кој се менуваат плоштините; негативна е ако пресликувањето ја менува ориентацијата.</translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the most by which distances grow.</source>
        <translation>Коефициентот на контракција ‖A‖, најголемата сингуларна вредност: колку пати најмногу растат растојанијата.</translation>
    </message>
    <message>
        <source>What the map is geometrically.</source>
        <translation>Што е пресликувањето геометриски.</translation>
    </message>
    <message>
        <source>Map %1 takes part.</source>
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
        <source>No weight is given; the determinant rule makes the probability %1.</source>
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
        <source>Change weight of map %1</source>
        <translation>Промена на тежината на пресликувањето %1</translation>
    </message>
    <message>
        <source>Change %1 of map %2</source>
        <translation>Промена на %1 на пресликувањето %2</translation>
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
        <source>Change colour of map %1</source>
        <translation>Промена на бојата на пресликувањето %1</translation>
    </message>
    <message>
        <source>on</source>
        <translation>вклучено</translation>
    </message>
    <message>
        <source>off</source>
        <translation>исклучено</translation>
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
        <source>Make the effective code the code; the cage then rests</source>
        <translation>Ефективниот код нека стане код; потоа кафезот е во мирување</translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation>Според |детерминанта|</translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, so that the picture is even</source>
        <translation>Тежини пропорционални на плоштините на сликите, за сликата да биде рамномерна</translation>
    </message>
    <message>
        <source>Equal</source>
        <translation>Еднакви</translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation>Иста тежина за секое пресликување</translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation>Според димензија</translation>
    </message>
    <message>
        <source>Weights for an even cover of the attractor at its own dimension</source>
        <translation>Тежини за рамномерна покриеност на атракторот во неговата сопствена димензија</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>Нормализирај</translation>
    </message>
    <message>
        <source>The same proportions, with the sum 1</source>
        <translation>Истите односи, со збир 1</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Тежини</translation>
    </message>
    <message>
        <source>Weights of all maps that are on, by a rule</source>
        <translation>Тежини на сите вклучени пресликувања, според некое правило</translation>
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
        <source>Facts</source>
        <translation>Својства</translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation>Прикажи ги детерминантата, коефициентот на контракција и видот на секое пресликување</translation>
    </message>
    <message>
        <source>Effective code</source>
        <translation>Ефективен код</translation>
    </message>
    <message>
        <source>Show the maps as they act on the picture under the current cage</source>
        <translation>Прикажи ги пресликувањата онака како што дејствуваат на сликата под сегашниот кафез</translation>
    </message>
    <message>
        <source>Table of maps</source>
        <translation>Табела со пресликувања</translation>
    </message>
    <message>
        <source>No maps: add one, or paste rows of 6 or 7 numbers.</source>
        <translation>Нема пресликувања: додајте едно или вметнете редици од 6 или 7 броја.</translation>
    </message>
    <message>
        <source>3D: not yet shown.
The entry is kept as it is.</source>
        <translation>3D: засега не се прикажува.
Записот е задржан како што е.</translation>
    </message>
    <message>
        <source>This entry could not be read. It is kept as it is.</source>
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
        <source>Reorder maps</source>
        <translation>Промена на редоследот на пресликувањата</translation>
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
        <source>Nothing was pasted: the clipboard holds no rows of 6 or 7 numbers.</source>
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
    <message>
        <source>Maps added: %1.</source>
        <translation>Додадени пресликувања: %1.</translation>
    </message>
    <message>
        <source>The selected maps were replaced; maps pasted: %1.</source>
        <translation>Избраните пресликувања се заменети; вметнати пресликувања: %1.</translation>
    </message>
    <message>
        <source>Set the weights</source>
        <translation>Задавање на тежините</translation>
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
        <source>Every row is a map: (x, y) goes to (a x + b y + e, c x + d y + f), as often as its weight p says. Double-click a number, or begin to type, to change it; the picture follows every key. Drag the number of a row to move it.</source>
        <translation>Секоја редица е пресликување: (x, y) се пресликува во (a x + b y + e, c x + d y + f), толку често колку што кажува неговата тежина p. За да промените некој број, кликнете двапати на него или почнете да пишувате; сликата го следи секое копче. Повлечете го бројот на редицата за да ја преместите.</translation>
    </message>
    <message>
        <source>Reading what was pasted…</source>
        <translation>Се чита вметнатото…</translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation>Броеви на пресликувањата</translation>
    </message>
    <message>
        <source>Drag a number to put the map elsewhere. A mark warns of a map that does not contract.</source>
        <translation>Повлечете го бројот за да го ставите пресликувањето на друго место. Ознаката предупредува на пресликување што не е контракција.</translation>
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
        <source>What is flat on the screen cannot be taken. Open the cage, or the maps, first.</source>
        <translation>Она што е рамно на екранот не може да се фати. Прво отворете го кафезот или пресликувањата.</translation>
    </message>
    <message>
        <source>Select a map first.</source>
        <translation>Прво избери пресликување.</translation>
    </message>
    <message>
        <source>Of so many maps only some are shown. Zoom in to see the others.</source>
        <translation>Од толку многу пресликувања прикажани се само некои. Зголемете го приказот за останатите.</translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation>Варијанти на „%1“</translation>
    </message>
    <message>
        <source>Fractals by Chance</source>
        <translation>Случајни фрактали</translation>
    </message>
    <message>
        <source>Variations</source>
        <translation>Варијанти</translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation>&amp;Употреби го ова</translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation>&amp;Додај во датотеката</translation>
    </message>
    <message>
        <source>&amp;Vary This One</source>
        <translation>&amp;Варирај го ова</translation>
    </message>
    <message>
        <source>Make the chosen one what the variations start from</source>
        <translation>Варијантите нека тргнуваат од избраното</translation>
    </message>
    <message>
        <source>How different the variations are</source>
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
        <source>&amp;Others</source>
        <translation>Дру&amp;ги</translation>
    </message>
    <message>
        <source>Another sheet: the next seed</source>
        <translation>Друга страница: следното семе</translation>
    </message>
    <message>
        <source>&amp;Difference:</source>
        <translation>&amp;Разлика:</translation>
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
        <source>Mutate</source>
        <translation>Мутирање</translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation>Додавање на случаен фрактал</translation>
    </message>
    <message>
        <source>Choose one and press OK, or double-click it: it takes the place of the fractal, as one step that can be undone.</source>
        <translation>Изберете еден и притиснете „Во ред“, или кликнете двапати на него: тој го зазема местото на фракталот, како еден чекор што може да се врати.</translation>
    </message>
    <message>
        <source>To the left the variations are much like what they start from, to the right they are wild.</source>
        <translation>Лево варијантите многу личат на она од што тргнуваат, а десно се сосема диви.</translation>
    </message>
    <message>
        <source>Takes the chosen one, as one step that can be undone.</source>
        <translation>Го зема избраниот, како еден чекор што може да се врати.</translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma. Arrow keys and the wheel change it: with Shift ten times as fast, with Alt a tenth. Esc takes back what was typed.</source>
        <translation>Број, со децимална точка или запирка. Стрелките и тркалцето го менуваат: со Shift десетпати побрзо, со Alt десетпати побавно. Esc го поништува внесеното.</translation>
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
        <source>The rows do not say which column is which, and programs differ. Choose the order in which the picture behind this dialog is the one you expect.</source>
        <translation>Редиците не кажуваат која колона е која, а програмите се разликуваат. Изберете го редоследот при кој сликата зад овој дијалог е онаа што ја очекувате.</translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation>Пресликувањата како што ќе бидат вметнати</translation>
    </message>
    <message>
        <source>The maps in the order chosen: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
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
        <source>&amp;Columns:</source>
        <translation>&amp;Колони:</translation>
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
        <source>In this order these maps do not contract: %1. Perhaps the columns mean something else.</source>
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
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>The language changes when Barycage is started again.</source>
        <translation>Јазикот ќе се смени кога Barycage ќе се стартува повторно.</translation>
    </message>
    <message>
        <source>&amp;Open the files of last time at the start</source>
        <translation>На почетокот &amp;отвори ги датотеките од минатиот пат</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Поставки</translation>
    </message>
    <message>
        <source>That of the desktop</source>
        <translation>Јазикот на работната околина</translation>
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
        <source>As the desktop</source>
        <translation>Како работната околина</translation>
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
        <source>The colours of windows and panels. The picture keeps its own.</source>
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
        <source>Picture at rest</source>
        <translation>Слика во мирување</translation>
    </message>
    <message>
        <source>How many points are drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation>Колку точки се цртаат додека ништо не се движи. Со повеќе точки сликата е помазна, а процесорот е подолго зафатен.</translation>
    </message>
    <message>
        <source>When on, Barycage opens the files that were open when it was closed, a window each.</source>
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
        <source>&amp;Picture at rest:</source>
        <translation>&amp;Слика во мирување:</translation>
    </message>
    <message>
        <source>Puts every choice of this dialog back to what it is at first.</source>
        <translation>Ги враќа сите избори во овој дијалог на почетните.</translation>
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
        <source>What was found</source>
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
        <source>Choose a line to show the entry it concerns.</source>
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
        <source>What could not be read is kept as it is.</source>
        <translation>Она што не можеше да се прочита е задржано како што е.</translation>
    </message>
    <message>
        <source>Nothing to report: every entry was read.</source>
        <translation>Нема што да се пријави: сите записи се прочитани.</translation>
    </message>
    <message>
        <source>What the reader of the file remarked, with line and column. Double-click a line to go to its entry.</source>
        <translation>Што забележал читачот на датотеката, со ред и колона. Кликнете двапати на некој ред за да отидете на неговиот запис.</translation>
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
        <source>Move or scale along one axis, turn in steps of 15°</source>
        <translation>Поместување или скалирање по една оска, вртење во чекори од 15°</translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation>Shift при влечењето</translation>
    </message>
    <message>
        <source>Take the drag back</source>
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
        <source>Leave the canvas</source>
        <translation>Напуштање на платното</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
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
        <source>Shows only the lines that have these words.</source>
        <translation>Ги прикажува само редовите што ги содржат овие зборови.</translation>
    </message>
    <message>
        <source>What every key and every movement of the mouse does.</source>
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
        <source>A deeper or a larger branch</source>
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
        <source>Select one more map or vertex, or one less</source>
        <translation>Избери едно пресликување или теме повеќе или помалку</translation>
    </message>
    <message>
        <source>Delete the selected vertices or maps</source>
        <translation>Избриши ги избраните темиња или пресликувања</translation>
    </message>
    <message>
        <source>Insert a vertex on an edge, duplicate the selected maps</source>
        <translation>Вметни теме на страна, удвој ги избраните пресликувања</translation>
    </message>
    <message>
        <source>Take the last vertex back while a triangle is defined</source>
        <translation>Врати го последното теме додека се задава триаголник</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
    <message>
        <source>Choose another stop</source>
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
        <source>Change the colour of the stop</source>
        <translation>Смени ја бојата на маркерот</translation>
    </message>
    <message>
        <source>Enter or Space, or double-click it</source>
        <translation>Enter или Space, или двоен клик на него</translation>
    </message>
    <message>
        <source>Take the change back</source>
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
        <translation>Трансформирање со броеви</translation>
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
        <source>Done in this order, from top to bottom.</source>
        <translation>Се изведува по овој редослед, одозгора надолу.</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Проблем</translation>
    </message>
    <message>
        <source>Start Again</source>
        <translation>Почни одново</translation>
    </message>
    <message>
        <source>All values as they were when the dialog opened</source>
        <translation>Сите вредности како што беа при отворањето на дијалогот</translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation>Постави ја сликата</translation>
    </message>
    <message>
        <source>The code stays; the cage moves</source>
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
        <source>The point that stays</source>
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
        <source>a typed point</source>
        <translation>внесена точка</translation>
    </message>
    <message>
        <source>in the line at the angle °</source>
        <translation>во однос на правата под агол °</translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation>Агол на оската на симетрија во степени: 0 е хоризонтална, 90 вертикална</translation>
    </message>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation>Овој запис нема пресликувања на рамнината.</translation>
    </message>
    <message>
        <source>This transformation is too flat to be undone, so it cannot be written into the code. Choose other scales, or place the picture.</source>
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
        <source>About which point the fractal is turned, scaled and reflected: it stays where it is.</source>
        <translation>Околу која точка фракталот се врти, скалира и отсликува: таа останува на место.</translation>
    </message>
    <message>
        <source>Mirrors in a line through the point that stays; the angle is counted from the x axis.</source>
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
        <source>the middle of the picture’s box</source>
        <translation>средината на правоаголникот на сликата</translation>
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
        <source>What is wrong with the numbers</source>
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
</context>
</TS>
