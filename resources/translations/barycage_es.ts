<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Analysis</name>
    <message>
        <source>Attractor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A system has one attractor if some power of it contracts: then every start leads to the same set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contraction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‖A‖ of each map that takes part: the most by which it stretches distances.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest box with sides parallel to the axes that holds the attractor; certified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canonical simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, leg %2, corner %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that holds the attractor. The signs are the directions of its legs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Convex hull area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area of the convex hull&apos;s inner polygon with %1 vertices; the hull reaches at most %2 beyond it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Similarity dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The D with Σ sᵢᴰ = 1 over the ratios sᵢ. It is the dimension of the attractor when the pieces do not overlap.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the invariant measure, solved exactly: the centre of mass of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covariance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covariance xx, xy, yy of the invariant measure, solved exactly: how widely the picture spreads.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Take a fractal by its corners: an editor for iterated function systems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>.ifs files to open, a window each</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CageEdits</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is at rest: the code is what is displayed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage bends the picture, and no affine code has a bent picture. Choose “Affine fit” to bake what comes nearest to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is flat: no code has this picture. Open the cage first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the cage moves the picture. The code stays as it is until you bake.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the whole cage rewrites the code. Moving single vertices bends the picture, which no code can follow, and leaves it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the cage rewrites every coefficient of the code, and the cage rests where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage already places the code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a triangle can be taken out of the code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage has a notch: the picture may fold over itself there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is folded: parts of the picture lie over one another. Move the vertices apart to unfold it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to enclose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A bent picture cannot be held by another cage. Reset the cage, or choose “Affine fit”, first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is flat. Open the triangle, or reset it, first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This system has no attractor that could be enclosed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Collection</name>
    <message>
        <source>From the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two systems of E. Hadzieva and M. Shuminoska, with the coefficients as printed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ferns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fronds: a long slow map climbs the rachis, two short ones hang the pinnae, a flat one draws the stem.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trunks that fork: the whole tree stands on its own branches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dragons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folded paper curves and the fractals of two or three twisted similarities.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sierpiński family</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaskets and carpets: a polygon holds shrunken copies of itself and keeps its holes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Koch family</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves built by replacing a segment, and the islands they bound.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spirals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One map that turns and shrinks a little, and small ones that bead its path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves and flowers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaf outlines, and flowers whose petals are turned copies of one another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiles and reptiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets that tile the plane: copies of themselves, rep-tiles, and the central tiles of number systems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cantor sets and dust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets full of gaps at every scale: points everywhere near, hardly any of them joined.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crystals and snowflakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets with the symmetry of frost: five, six and more arms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves and graphs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Graphs of strange functions, smooth curves as attractors, space-filling coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Abstract</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Affine patterns without a name in nature: relatives of the gasket, weaves, rosettes.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ColumnOrders</name>
    <message>
        <source>a b c d e f p: Fractint, Barnsley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a b e c d f p: each equation in a row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a c b d e f p: column by column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p a b c d e f: the weight first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>r s theta phi e f p: scales, and angles in degrees</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExportJob</name>
    <message>
        <source>There is not enough memory for this picture. Make it smaller, or supersample less.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Fractint collections (*.ifs *.par);;Flames (*.flame *.flam3);;Tables of numbers (*.csv *.tsv *.txt);;Pictures that carry their fractal (*.png *.svg);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the panel “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the maple by a corner and pull. Or press D and define another triangle by three clicks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovered %1. It is not saved yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n entries</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them could not be read and are kept as they are</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with a remark</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do you want to save them?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was changed by another program since it was opened here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving replaces what the other program wrote.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save As</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractint collections (*.ifs)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back to “%1” as it is on disk? The changes made since then are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] — %2</source>
        <comment>file, entry</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>what it does, shortcut</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with a Sierpiński triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a collection of fractals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the file; entries not edited keep every byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the file under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;vert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back to the file as it is on disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the picture as PNG, SVG or PDF, framed as on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;Data…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the maps or points as a flame, for IFStile, as a table or a point cloud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the picture to the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is on the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print the picture, its name and its coefficients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last edit back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the edit again that was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Transform…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate, scale, shear, reflect or move the whole fractal by numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mutate…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick one of many variations of this fractal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only systems in the plane can be varied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;Random Fractal…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick one of many fractals made by chance, and add it to the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language, theme, quality of the picture at rest, what is opened at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Drag the Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the fractal by the vertices of its control triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;fine Triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define the control triangle by three clicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the attractor in the smallest isosceles right triangle around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the cage back to rest: the code is drawn as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the placement part of the code: the picture stays, the coefficients change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unbake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the placement out of the code: the picture stays, the code becomes that of the triangle (0, 0), (1, 0), (0, 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the vertices on the regular polygon nearest to them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Affine &amp;Invariant Form…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show every map as a row-stochastic matrix over the control triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole fractal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show one unit as one hundred pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let y grow downwards, as in window coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Only the Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide everything on the canvas but the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Snap To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let dragged vertices snap to this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How It Arises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;How It Arises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watch the attractor arise: by steps of the deterministic algorithm, or by the chaos game</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find any command by typing what it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard and Mouse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every shortcut and gesture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;User Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the user guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Barycage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Barycage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Barycage %1&lt;/h3&gt;&lt;p&gt;Take a fractal by its corners: an editor for iterated function systems whose attractors are held in barycentric coordinates of a control triangle.&lt;/p&gt;&lt;p&gt;After E. Hadzieva and M. Shuminoska, &lt;i&gt;Real-time Tool for Affine Transformations of Two Dimensional IFS Fractals&lt;/i&gt;.&lt;/p&gt;&lt;p&gt;MIT licence.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolkit this program is built with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fractals of the open file. The one chosen here is in the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractals to begin with, by theme, and your own folders of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maps of the fractal: its code, one map in a row.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The control cage by numbers: where its vertices are, where they are at rest, what moving them does, and other cages to choose from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours, brightness and background of the picture. They are saved with the fractal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What mathematics knows of this fractal. Point at a name to read what it means.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every step since the file was opened. Choose one to go back to it, or forward.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was odd in the file, with line and column. It is kept as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six short steps in this window: contraction, fixed point, chaos game, address, barycentric coordinates, dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What’s This?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click anything to read what it is for</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NumberField</name>
    <message>
        <source>The number must be greater than %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number must be at least %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number must be less than %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number must be at most %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A number is missing here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a fraction: write it as a decimal number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Maple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glacier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orchid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aurora</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Herbarium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sanguine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cyanotype</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PngExport</name>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PngSystem</name>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed its text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no PNG picture, or it is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PngWriter</name>
    <message>
        <source>The picture cannot be written: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>%1, %2</source>
        <comment>file, time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved work was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barycage ended last time before this work was saved:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask Later</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>%1 G points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 M points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 (words of %2 maps)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no attractor: the word %1 does not contract</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>existence of an attractor undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no map takes part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pointer position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>World and barycentric coordinates of the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the system has an attractor, and the factor by which it contracts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points drawn so far and the time of the last pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  barycentric (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this entry could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SvgSystem</name>
    <message>
        <source>The system in the picture has more than 8 MB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system in the picture is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture declares a document type, which Barycage never writes and does not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no SVG picture, or it is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture holds no system: it was not written by Barycage, or another program removed it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>a document type is not accepted in a flame file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The XML ends here: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no flame in this file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no attractor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet would be %1 by %2 pixels; at most %3 a side can be drawn. Take smaller tiles, or other columns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the amount of “%1” is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it uses a variation other than linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it acts in space (“%1”)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it uses the variation “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its “coefs” are not six numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its “post” is not six numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its “chaos” allows some successors only, which a list of maps cannot say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it takes part without being drawn (opacity 0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its weight is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has a final transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it adds a symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The flame “%1” is not a system of affine maps: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has more than %1 transforms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>transform %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The flame “%1” has no transforms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry that opens here is not closed by “}” before the next entry or the end of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more problems in this entry are not listed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name “%1” holds a blank; Fractint takes only its first word.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name “%1” is longer than 18 bytes; Fractint cuts it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The opening brace stands on a line of its own; Fractint does not find this entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry has more than %1 maps, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: the comma can be read as a decimal point or between two numbers, and both give whole rows. Write decimal points and blanks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”: neither as a decimal point nor between two numbers does the comma give whole rows of 7 numbers (13 with “(3D)”).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The numbers on the line of the opening brace are ignored, as Fractint ignores them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not understood by this version of Barycage; the line is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry holds no numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This line has %1 numbers and the entry %2, which is no multiple of %3: a map is %3 numbers%4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> in an entry marked “(3D)”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a plain number: Fractint reads %2 and ignores the rest. Write it as one decimal number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a finite number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is larger than a coefficient can be (3.4e38 in size).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” begins with a typographic minus sign (U+2212). Write the plain “-”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers stand on the line of the opening brace, where Fractint ignores them; they are read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commas are read as decimal points; Fractint reads other numbers here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commas or apostrophes stand between the numbers; Iterated Dynamics cannot read this entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maps have no weights (%1 numbers each); weights are taken from the determinants. Fractint cannot read this entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of %1 numbers without “(3D)” after the name are read as a 3D system; Fractint cannot read this entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines do not hold 7 numbers each, but all numbers together fill rows of 7 and are read so, as Fractint does. Probably the weights are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The closing brace touches the last number; Fractint cannot read this entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line is longer than 200 bytes; Fractint cuts it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A NUL byte; the rest of the line is ignored, as Fractint ignores it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint and Iterated Dynamics read at most 63.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The weight of map %1 is negative; the map counts as switched off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The weight of map %1 is 0; the map takes no part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The weights sum to %1, not 1. They are used in proportion; Fractint gives what is missing to the last map and cuts what is too much.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are Fractint parameter sets or formulas; no iterated function system is among them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No iterated function system was found: an entry is a name, “{”, rows of 7 numbers and “}”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has more than %1 entries; the rest is kept as text but not shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A block without a name is kept as text; Fractint does not list it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two opening braces on one line: no reader finds an entry here. The text is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a parameter set or a formula, not an iterated function system; it is kept as text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name is taken by the entry in line %1 (Fractint compares 18 characters and ignores case); Fractint never reaches this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file begins with a byte order mark, which Fractint takes for a part of the first name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractint stops reading at this byte (^Z); the entries after it are read all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has %1 entries; Fractint and Iterated Dynamics use the first 2000.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry has no map that takes part and is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 maps that take no part are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry is written under the name “%1”: other programs take 18 plain characters, and each name once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The entry has %1 maps; Fractint up to 17.2 reads at most 31.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hyperbolic, s = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eventually contractive, γ = %1 from words of length %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: a word of length %1 does not contract</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: no map takes part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   norm %1, determinant %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>attractor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>covariance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>canonical simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>convex hull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices, area %2; error at most %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices, %2 facets, volume %3; error at most %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>similarity dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>affinity dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — in the plane, %2 maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — in space, %2 maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cage at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cage now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored cage is not usable (its lists of vertices do not match, or its rest vertices lie on one line, cross each other or are more than 64) and is not applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stored palette “%1” is unknown and is not applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map %1 was switched off here, but another program has given it a weight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A palette has at most %1 colours; the others are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This line is left out: three whole numbers from 0 to 255 make a colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no colours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has more than 16 MB, which no palette needs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no text, so it is no palette.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a GIMP gradient; palettes are read from .gpl, .ugr and .map files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has more than %1 palettes; the others are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no gradient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gradient of line %1 is not closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no whole number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a system in the plane, of which alone points are written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has no map that takes part, so it has no points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cage of more than three corners bends the picture, and its points are not written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point cloud has from 1 to %1 points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a folder. Choose a file name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not an ordinary file and is not replaced. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder “%1” does not exist. Create it, or save somewhere else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is read-only. Save under another name, or change its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was not saved: the disk is full. Free some space and save again; the file on the disk is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was not saved: you may not write to the folder “%2”. Save somewhere else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was not saved: the name is too long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” was not saved: %2. The file on the disk is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has no name. Choose one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a folder, not a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is larger than 256 MB, which is the limit for a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only plane systems can be written as a scalable picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system has no attractor of which an outline could be certified, so there is nothing to make copies of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no rows of numbers: a row is a b c d e f and perhaps a weight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After the count, a map is its weight and a matrix of 3 rows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last row of the matrix of an affine map is 0 0 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table says that it has %1 maps, and it has %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header does not say which column is a, b, c, d, e and f; choose the order of the columns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This row has %1 numbers; a map is 6 numbers, or 7 with its weight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a decimal number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table has more than %1 rows, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a %1 file, not a text with iterated function systems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a text in UTF-16. Save it as UTF-8 or ASCII and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a list written by a Racket program (wgmitchener&apos;s IFS editor), not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a flame file (XML), not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is an SVG picture, not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is an XML file of an IFS program such as IFS Explorer, not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is an XML or HTML file, not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is an IFStile file (.aifs), not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a XaoS position file, not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines are expressions in x and y, as pyfractal writes them, not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a table of the program Fraktale: a count, maps with cumulative percentages and a window. It is not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This table has 5 numbers per map (scales, shifts and a rotation in pixels). It is not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a StyrofoamIFS script, not a Fractint collection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a binary file (perhaps a fractal-compressed image or an icon library), not a text with iterated function systems.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Contraction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every row of this table is a map that makes a smaller copy of the whole, and the picture is all copies together. Double-click a number and type another: the copy moves as you type. ‖A‖ is the most by which a map stretches. While it is less than 1, the map contracts. Ctrl+Z takes everything back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixed point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A map that contracts leaves exactly one point where it is: its fixed point. Switch off all maps but two by the boxes on the left, and see how little is left of the picture. With one map alone nothing is left but its fixed point. Ctrl+Z brings the maps back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chaos game</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Chaos Game and then the triangle that starts it. One point jumps about, each time by a map drawn at random, and leaves a dot where it lands. Let it go faster: whatever the dice say, the dots fill the same picture, the attractor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map that made the last jump to a point, the one before it, and so on: these numbers are the address of the point. Choose Colour by: Address. Points whose addresses begin alike lie close together, and now they look alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every point of the picture is a weighted mean of the three corners of the triangle. Take a corner and pull: the points keep their weights, and the whole fractal follows. Squeeze the triangle flat and open it again: nothing is lost. The weights at the pointer stand at the bottom of the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the plane does the attractor fill? The dimension of a curve is 1, that of an area is 2, and most attractors lie between the two. Change a map and look here again. That was the tour; the user guide under Help tells the rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New here?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six short steps show what an attractor is, by pulling on one. You can take the tour later, too: it is in the Help menu.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start the Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Takes what the dialog shows, and closes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the dialog and changes nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the dialog.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::AifsDialog</name>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Affine Invariant Form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row j of a matrix holds the barycentric coordinates of the image of vertex j in the triangle, so each row sums to 1. The matrices do not change when the triangle is dragged. Where no entry is negative, the map takes the triangle into itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every map as a matrix that takes barycentric coordinates over the control triangle to barycentric coordinates: each row has the sum 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the matrices to the clipboard as text.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::AnalysisPanel</name>
    <message>
        <source>Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all facts with all digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This entry could not be read, so nothing is known of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is placed by its cage; these are facts of the code. Bake to see those of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy with All Digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy All Facts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::AppearancePanel</name>
    <message>
        <source>Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every setting of this panel as in a new fractal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The palette follows the density of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colour of the last map applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The palette follows the address of each point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One colour; the density is its opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change what the colour shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the plain colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit Palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the palette, or load one from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the background colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the background transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the background opaque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How early thin parts become visible: κ of the logarithmic tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the gamma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent of the tone curve: higher values lift the dark parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Supersampling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %1 sub-pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the supersampling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the colour of map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the colour of a point tells: how many points fall there, which map came last, or the whole address.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours from the thinnest parts to the densest, or along the addresses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the background out of exported pictures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws every pixel from several finer ones: smoother edges, for more memory and time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::AppearanceSlider</name>
    <message>
        <source>Drag, or use the arrow keys. The number beside it is the same value.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ArisingBar</name>
    <message>
        <source>How the attractor arises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The invariant measure, refined while nothing moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps Wⁿ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The deterministic algorithm: all maps applied n times to the cage at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chaos Game</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One point that jumps by maps drawn at random; the first 14 points are not plotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n: how often all maps are applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No points yet, and other dice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot one more point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let points appear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W%1: the cage itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W%1: %2 copies of the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay at these points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, the last by map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often all maps are applied to the cage: 0 is the cage itself, and with every step the picture comes closer to the attractor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many points the chaos game plots in a second.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CageActions</name>
    <message>
        <source>This entry is not a system of the plane, so it has no control cage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is too flat to be undone. Open it by dragging a vertex, or reset it, and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three points lie on one line and hold no coordinates. Put the third one beside the line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the minimal canonical simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is at rest already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake the placement into the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define the control triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertex %1 is there already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cage has at most %1 vertices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no room for a vertex here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cage has at least three vertices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without this vertex the cage at rest would cross itself or be flat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the cage regular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unbake: take the placement out of the code</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CagePanel</name>
    <message>
        <source>Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning about the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rewrite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the cage moves the picture; the code stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moving the cage rewrites the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Affine fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every vertex is followed; the picture bends, which cannot be baked into a code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture moves by the affine map that comes nearest to the vertices; it can be baked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bend the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the picture by an affine map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define the triangle by three clicks on the canvas; the picture stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimal Canonical Simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canonical Simplex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounding Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n Corners</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Convex Hull, Simplified to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regular Polygon with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rest cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the vertices that hold the attractor while the cage is at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the rest cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimal canonical simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest isosceles right triangle with legs parallel to the axes that contains the picture. The signs say to which side its legs point from the right angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barycentric coordinates of a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The weights a, b, c with a + b + c = 1 that the vertices take to balance in the point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x of the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y of the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barycentric coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of vertex %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of rest vertex %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The three points are on one line: the rest cage must enclose an area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rest cage must be a polygon that does not cross itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is too thin for such a cage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D: not yet shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This entry could not be read, so it has no cage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At rest: the picture is that of the code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices, at rest: the picture is that of the code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices: bent by Wachspress coordinates, not bakeable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 vertices: bent by mean value coordinates, not bakeable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat: the picture lies on one line. Open the cage and it comes back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placed and mirrored: areas change by the factor %1, and the sense of rotation is reversed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Placed: areas change by the factor %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a triangle has barycentric coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The triangle is flat: it holds no coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, leg %2, corner (%3, %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the picture by a fitted cage; the picture stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is at rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the cage and the picture back to rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the displayed picture the code; the cage then rests</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CageTool</name>
    <message>
        <source>Move the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move edge %1–%2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::Canvas</name>
    <message>
        <source>No attractor: map %1 does not contract (largest singular value %2, spectral radius %3). Make it smaller, or switch it off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No attractor: the maps %1, one after the other, do not contract (largest singular value %2, spectral radius %3). Make one of them smaller, or switch it off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor: map %1 stretches by %2. Points that run away are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is not settled whether this system has an attractor. Points that run away are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This entry is a system in space: not yet shown. It is kept as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This entry could not be read. Its text is kept as it is in the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No map takes part, so there is nothing to draw. Add a map or switch one on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is as deep as the arithmetic reaches: zoom out a little for a true picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn with fewer iterations than asked for: more would need more memory than allowed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is flat, and so is the picture. Drag a vertex to open it: nothing is lost.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CanvasMenu</name>
    <message>
        <source>Vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Coordinates…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Types the place of this vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset This Vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts this vertex back to rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to &amp;Grid Point (%1, %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves this vertex to the nearest point of the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to the &amp;x Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves this vertex straight to the x axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snap to the &amp;y Axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves this vertex straight to the y axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete This Vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes this vertex out of the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the &amp;Pivot Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns and scales the cage about this vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Insert a Vertex Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts one more vertex on this edge; a double click does the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate: Shift turns in steps of 15°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale: Shift keeps to x or y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the &amp;Pivot in the Middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns and scales the cage about its middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit &amp;Minimal Canonical Simplex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds the picture by the smallest right-angled triangle around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Define Triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds the picture by three points that are clicked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;eset Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts every vertex back to rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make Re&amp;gular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the vertices on the regular polygon nearest to them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bake Placement into the Code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rewrites the maps so that they draw what is shown, with the cage at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit	F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the whole picture and its cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;100 %	1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows one unit of the plane as a hundred pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows or hides the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows or hides the axes and their numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Y Axis Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns the plane over, as on the screen of a computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Only the Picture	H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hides the cage, the grid and the axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the picture as it is seen, without the cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CanvasScene</name>
    <message>
        <source>Vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge from vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pivot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arrow keys move both its ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arrow keys move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arrow keys turn the cage by one degree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arrow keys scale the cage by one percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the pivot: the cage turns and scales about it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn the cage about the pivot; Shift: in steps of 15°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to scale the cage about the pivot; Shift: along x or y only.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CanvasView</name>
    <message>
        <source>Canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The attractor and its control cage. Tab goes from handle to handle, the arrow keys move the one in focus, F6 leaves the canvas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Define triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is flat, so new vertices cannot be related to the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the cage back to rest first?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the Cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the picture is shown. Press H to see the cage again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture and its cage. Drag a corner, an edge or the inside of the cage; Ctrl turns, Alt scales, Shift keeps directions. The wheel zooms at the pointer, the middle button moves the plane. Tab goes from handle to handle, arrow keys move them, F6 leaves.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::Clipboard</name>
    <message>
        <source>pasted</source>
        <comment>name of an entry made from a table</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CollectionModel</name>
    <message>
        <source>Theme: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from %2, a favourite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CollectionPanel</name>
    <message>
        <source>Collection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the collection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only fractals whose name, title, theme or source contains these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractals of the collection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No favourites yet. Choose a fractal and press Ctrl+D.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the chosen fractal as a document of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add to This File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the chosen fractal to the open file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fa&amp;vourite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the chosen fractal as one of your favourites.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only Fa&amp;vourites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show nothing but your favourites.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;Folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the .ifs files of a folder of yours here, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove Folder “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show this folder here no more. Its files stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of .ifs Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only the fractals whose name, theme or comment has these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractals to begin with. Double-click or Enter opens one in this window; the menu of the right button adds it to the file instead.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ColourButton</name>
    <message>
        <source>transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 % opaque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to choose another colour.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type some letters of what you want to do. Arrow keys choose, Enter does it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The commands whose names have these letters.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::DefineTool</name>
    <message>
        <source>Click the first of the three vertices. The picture stays where it is; Esc leaves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the second vertex. Backspace takes the first one back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the third vertex. Backspace takes the second one back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::EntriesCommentDialog</name>
    <message>
        <source>Comment of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment behind the name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written on the first line of the entry, for example its title or author.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written as lines of their own below the name, each behind a semicolon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reason why the comment cannot be kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep or discard the comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Behind the name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment &amp;lines:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A comment cannot begin with “barycage:”; such lines keep the cage and the colours.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A line holds at most %1 bytes; Fractint cuts longer ones. Break it in two.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::EntriesDelegate</name>
    <message>
        <source>Name of the entry</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::EntriesEdits</name>
    <message>
        <source>An entry needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name holds no blanks: Fractint would read its first word only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be part of a name, because it has a meaning in .ifs files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name has at most %1 characters; Fractint ignores the rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractint does not list an entry called “%1”; choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another entry is called “%1” (upper and lower case count as equal).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message>
        <source>Rename “%1” to “%2”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D: not yet shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 map</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n maps</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, no attractor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>modified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has warnings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::EntriesPanel</name>
    <message>
        <source>Entries of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter entries by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only the entries whose name contains this text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file holds no entries. Add one, or paste the text of an .ifs file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add Entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a Sierpiński triangle as a new entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;uplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a copy of each selected entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected entries from the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the entry another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit &amp;Comment…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the comment of the entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move &amp;Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected entries towards the top of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move &amp;Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected entries towards the end of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected entries as .ifs text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste the entries of .ifs text behind the current entry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Remove %n entries</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>An entry that could not be read cannot be duplicated: it would keep its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n entries</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Edit the comment of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no entry of an .ifs file in what was pasted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Paste %n entries</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pasted entries could not be read; their text is kept as it is.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Move %n entries</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>No entry has “%1” in its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only the entries whose name has these letters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fractals of the file. Click one to edit it, drag it to another place, press F2 to give it another name.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ExportDataDialog</name>
    <message>
        <source>Export Data of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the file will hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flame: flam3, Apophysis, JWildfire, Fractorium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IFStile (.aifs)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table with commas (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table with tabs (.tsv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points, coloured (.ply)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Turn y around, so that the flame is the same way up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bake the placement, so that the maps draw what is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the numbers of plane systems can be exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The points of the chaos game where they are shown, without the first 14.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The text is on the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The beginning of the file as it will be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For which program the data are: each format has what that program reads.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The order in which each row has its coefficients; other programs expect other orders.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many points of the chaos game are written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flame programs let y grow downwards. With this the flame looks as the fractal does here; without it the numbers are the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With this, the cage is made part of the maps. Without it, the maps are written as they stand in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the whole text to the clipboard instead of writing a file.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ExportDialog</name>
    <message>
        <source>Export “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG: pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SVG: shapes for drawing programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF: shapes for print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Include the &amp;control triangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft: 25 samples a pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: 100 samples a pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine: 400 samples a pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finest: 2000 samples a pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells along the side of a pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8 bits a channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bits a channel, for further work on the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Supersampling:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;olour depth:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies of copies: a small file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline, for cutters and plotters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As deep as a pixel &amp;needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels of copies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture will be like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;hapes:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Points:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Depth:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only plane systems can be exported as a picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One dot for every point of the chaos game that is in view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 references (fewer than 400,000 are allowed). Nothing that is drawn is farther than %2 pixels from the attractor, and nothing of it is farther from what is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The cage bends the picture, which copies cannot follow: the affine fit of the cage is written. A PNG shows the bend.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scalable pictures (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The export was stopped; nothing was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG is a picture of pixels; SVG and PDF are made of shapes, which stay sharp at every size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture has no background and can be laid over another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws the cage over the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many points are drawn for each pixel: more make a smoother picture and take longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every pixel is drawn from so many finer ones along its side: smoother edges, for more memory and time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bits keep fine steps of brightness for later work in a picture editor; 8 bits are enough to look at.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies of copies make a small file that drawing programs can edit; the outline is one path; points are dots of the chaos game.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many dots of the chaos game are drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies are made smaller until no pixel of this size could tell the difference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many levels of copies the picture has. The file hardly grows with it, the time to draw it does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the name of the file and writes it. The window can be used meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ExportSizeEditor</name>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size relative to the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the shape of the picture on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> dpi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution in dots per inch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A length in the unit chosen beside it. The other side follows while the shape is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In pixels, or on paper at the resolution given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture as on the screen or some times as large.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many pixels go on an inch of paper: 300 is usual in print.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::GradientChooser</name>
    <message>
        <source>of this fractal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (of this fractal)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::GradientEditor</name>
    <message>
        <source>Palette editor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the stop, from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a stop after the chosen one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the palette round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the stops at equal distances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a palette from a .gpl, .ugr or .map file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the palette as a .gpl file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change a colour of the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GIMP palettes (*.gpl)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute the stops of the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load Palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palettes (*.gpl *.ugr *.gradient *.map);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load the palette %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palettes of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load a palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The palettes that the file holds. Choose one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::GradientStrip</name>
    <message>
        <source>Stops of the gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click: new stop, or the colour of one. Drag: move. Del: remove.
Keys: Page Up and Page Down choose a stop, the arrows move it, Ins adds one, Enter opens its colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop %1 of %2 at %3 %, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a stop to the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a stop of the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a stop of the palette</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::Guide</name>
    <message>
        <source>User Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The user guide: what can be done here, in the order in which one needs it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a step to go back to it, or forward. The disk marks what is saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As opened</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::MapShapeEditor</name>
    <message>
        <source>Rotation °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle in degrees, counter-clockwise with y up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the image of the x unit vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale across; negative when the map reflects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear along x, applied before everything else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translation e, applied last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translation f, applied last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No map is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the shape of map %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::MapsDelegate</name>
    <message>
        <source>%1 of map %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 The cell keeps its value.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::MapsModel</name>
    <message>
        <source>similarity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reflected similarity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>affine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>singular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A similarity keeps shapes: it turns, scales and shifts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A reflected similarity keeps shapes, as a mirror does, and scales and shifts them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An affine map keeps lines and parallels, not angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A singular map takes the plane to a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A constant map takes the plane to one point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>det</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‖A‖</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map takes (x, y) to (a x + b y + e, c x + d y + f).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effective code: the map as it acts on the picture under the current cage. Bake makes it the code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the map takes part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the map, used when the picture is coloured by map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight as given: how often the chaos game takes the map. The weights need not sum to 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Determinant ad − bc: the factor of areas; negative when the map reflects.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contraction factor ‖A‖, the largest singular value: the most by which distances grow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map is geometrically.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map %1 takes part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map %1 is switched off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of map %1. Press Space or double-click to change it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cage is flat or bent: there is no effective code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No weight is given; the determinant rule makes the probability %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight %1: a weight that is not positive switches the map off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight %1, probability %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, not contracting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map %1 does not contract: it stretches by up to %2. The system may still have an attractor if longer words contract.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map %1. Drag to reorder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change weight of map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 of map %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch map %1 on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch map %1 off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change colour of map %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a map of half the size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the selected maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected maps up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected maps down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected maps as rows a b c d e f p, separated by tabs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste in Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace the selected maps by rows of 6 or 7 numbers from the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste as New Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add rows of 6 or 7 numbers from the clipboard as new maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the effective code the code; the cage then rests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By |Determinant|</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights in proportion to the areas of the images, so that the picture is even</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same weight for every map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By Dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights for an even cover of the attractor at its own dimension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same proportions, with the sum 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights of all maps that are on, by a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show columns: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the coefficients a … f</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Facts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show determinant, contraction factor and kind of each map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effective code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the maps as they act on the picture under the current cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table of maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No maps: add one, or paste rows of 6 or 7 numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D: not yet shown.
The entry is kept as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This entry could not be read. It is kept as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1 maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1 maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reorder maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted. Line %1 of the clipboard: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted: the clipboard holds no rows of 6 or 7 numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste a map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste %1 maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps added: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected maps were replaced; maps pasted: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake the cage into the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of map %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every row is a map: (x, y) goes to (a x + b y + e, c x + d y + f), as often as its weight p says. Double-click a number, or begin to type, to change it; the picture follows every key. Drag the number of a row to move it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::MapsRowHeader</name>
    <message>
        <source>Numbers of the maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a number to put the map elsewhere. A mark warns of a map that does not contract.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::MutateDialog</name>
    <message>
        <source>Variations of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fractals by Chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use This One</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add to the File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Vary This One</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the chosen one what the variations start from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How different the variations are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the random numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same seed gives the same sheet again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another sheet: the next seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Difference:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Seed:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mutate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Random Fractal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one and press OK, or double-click it: it takes the place of the fractal, as one step that can be undone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the left the variations are much like what they start from, to the right they are wild.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the chosen one, as one step that can be undone.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::NumberField</name>
    <message>
        <source>A number, with a decimal point or comma. Arrow keys and the wheel change it: with Shift ten times as fast, with Alt a tenth. Esc takes back what was typed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::PasteTableDialog</name>
    <message>
        <source>Paste maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste a Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rows do not say which column is which, and programs differ. Choose the order in which the picture behind this dialog is the one you expect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maps as they will be pasted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maps in the order chosen: (x, y) goes to (a x + b y + e, c x + d y + f).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the maps do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Columns:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no rows of 6 or 7 numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In this order every map contracts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In this order these maps do not contract: %1. Perhaps the columns mean something else.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::PreferencesDialog</name>
    <message>
        <source>The language changes when Barycage is started again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open the files of last time at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That of the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language of menus and messages. Files and numbers are the same in every language.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours of windows and panels. The picture keeps its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft: 50 million points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: 200 million points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine: 1000 million points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many points are drawn while nothing moves. More points make a smoother picture and keep the processor busy for longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When on, Barycage opens the files that were open when it was closed, a window each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture at rest:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts every choice of this dialog back to what it is at first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ProblemsModel</name>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line:column</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Entry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was found</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ProblemsPanel</name>
    <message>
        <source>file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems found while reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a line to show the entry it concerns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected problems as text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all problems.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 problem was found while reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n problems were found while reading.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>What could not be read is kept as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to report: every entry was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the reader of the file remarked, with line and column. Double-click a line to go to its entry.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::ShortcutsDialog</name>
    <message>
        <source>On the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a vertex, an edge, the whole cage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate about the pivot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl + drag, or the round handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale about the pivot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt + drag, or the square handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move or scale along one axis, turn in steps of 15°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift while dragging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the drag back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc while dragging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next or previous handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nudge the handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrow keys; Shift ×10, Alt ×0.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the canvas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle drag, or Space + drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard and Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only the lines that have these words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What every key and every movement of the mouse does.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::TransformDialog</name>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transform by Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x of the fixed point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y of the fixed point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear along x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale in x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale in y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Same in x and y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation in degrees, counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translation in x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translation in y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done in this order, from top to bottom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All values as they were when the dialog opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The code stays; the cage moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rewrite the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every map w becomes T∘w∘T⁻¹; the cage follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The point that stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the middle of the picture&apos;s box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean of the invariant measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a typed point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the line at the angle °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the mirror line in degrees: 0 is horizontal, 90 vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This entry has no maps of the plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This transformation is too flat to be undone, so it cannot be written into the code. Choose other scales, or place the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transform the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transform the code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the factor in y equal to that in x.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About which point the fractal is turned, scaled and reflected: it stays where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrors in a line through the point that stays; the angle is counted from the x axis.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>view::VertexDialog</name>
    <message>
        <source>Move vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x of the vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y of the vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong with the numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number. Write it with a decimal point, for example -0.25.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A coordinate of the vertex, with a decimal point or comma. The picture follows as you type.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
