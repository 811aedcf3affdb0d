<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Analysis</name>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… and %n more</numerusform>
            <numerusform>… and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FlameBanner</name>
    <message numerus="yes">
        <source>%n flames</source>
        <translation>
            <numerusform>%n flame</numerusform>
            <numerusform>%n flames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message numerus="yes">
        <source>%n entries</source>
        <translation>
            <numerusform>%n entry</numerusform>
            <numerusform>%n entries</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them could not be read and are kept unchanged</source>
        <translation>
            <numerusform>, %n of them could not be read and is kept unchanged</numerusform>
            <numerusform>, %n of them could not be read and are kept unchanged</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n read with warnings</source>
        <translation>
            <numerusform>, %n read with warnings</numerusform>
            <numerusform>, %n read with warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Open %n files?</source>
        <translation>
            <numerusform>Open %n file?</numerusform>
            <numerusform>Open %n files?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlacementBanner</name>
    <message numerus="yes">
        <source>Other programs will show %n entries without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</source>
        <translation>
            <numerusform>Other programs will show %n entry without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</numerusform>
            <numerusform>Other programs will show %n entries without your dragged corners, which are saved as comments. Bake puts them into the numbers that every program reads.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message numerus="yes">
        <source>(%n windows)</source>
        <translation>
            <numerusform>(%n window)</numerusform>
            <numerusform>(%n windows)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message numerus="yes">
        <source>%n more maps</source>
        <translation>
            <numerusform>%n more map</numerusform>
            <numerusform>%n more maps</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exports from the last session are in the queue.</source>
        <translation>
            <numerusform>%n export from the last session is in the queue.</numerusform>
            <numerusform>%n exports from the last session are in the queue.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Barycage closes when they are finished. Closed now, it continues with them at its next start.</source>
        <translation>
            <numerusform>Barycage closes when it is finished. Closed now, it continues with it at its next start.</numerusform>
            <numerusform>Barycage closes when they are finished. Closed now, it continues with them at its next start.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exports are still in the queue.</source>
        <translation>
            <numerusform>%n export is still in the queue.</numerusform>
            <numerusform>%n exports are still in the queue.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n Corners</source>
        <translation>
            <numerusform>%n Corner</numerusform>
            <numerusform>%n Corners</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n maps added.</source>
        <translation>
            <numerusform>%n map added.</numerusform>
            <numerusform>%n maps added.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The selected maps were replaced; %n maps pasted.</source>
        <translation>
            <numerusform>The selected maps were replaced; %n map pasted.</numerusform>
            <numerusform>The selected maps were replaced; %n maps pasted.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::AnimationExportDialog</name>
    <message numerus="yes">
        <source>%n frame(s), %1 s.</source>
        <translation>
            <numerusform>%n frame, %1 s.</numerusform>
            <numerusform>%n frames, %1 s.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) with the names of these pictures exist already and hold something else.</source>
        <translation>
            <numerusform>%n file with the name of one of these pictures exists already and holds something else.</numerusform>
            <numerusform>%n files with the names of these pictures exist already and hold something else.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::CollagePanel</name>
    <message numerus="yes">
        <source>%n suggestions. Click one to use it.</source>
        <translation>
            <numerusform>%n suggestion. Click it to use it.</numerusform>
            <numerusform>%n suggestions. Click one to use it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::EntriesModel</name>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n map</numerusform>
            <numerusform>%n maps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::EntriesPanel</name>
    <message numerus="yes">
        <source>Duplicate %n entries</source>
        <translation>
            <numerusform>Duplicate %n entry</numerusform>
            <numerusform>Duplicate %n entries</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paste %n entries</source>
        <translation>
            <numerusform>Paste %n entry</numerusform>
            <numerusform>Paste %n entries</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pasted entries could not be read; their text is kept unchanged.</source>
        <translation>
            <numerusform>%n pasted entry could not be read; its text is kept unchanged.</numerusform>
            <numerusform>%n pasted entries could not be read; their text is kept unchanged.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n entries</source>
        <translation>
            <numerusform>Move %n entry</numerusform>
            <numerusform>Move %n entries</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n entries</source>
        <translation>
            <numerusform>Delete %n entry</numerusform>
            <numerusform>Delete %n entries</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cut %n entries</source>
        <translation>
            <numerusform>Cut %n entry</numerusform>
            <numerusform>Cut %n entries</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ExportProgress</name>
    <message numerus="yes">
        <source>About %n second(s) left.</source>
        <translation>
            <numerusform>About %n second left.</numerusform>
            <numerusform>About %n seconds left.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n minute(s) left.</source>
        <translation>
            <numerusform>About %n minute left.</numerusform>
            <numerusform>About %n minutes left.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>About %n hour(s) left.</source>
        <translation>
            <numerusform>About %n hour left.</numerusform>
            <numerusform>About %n hours left.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ExportsModel</name>
    <message numerus="yes">
        <source>about %n second(s) left</source>
        <translation>
            <numerusform>about %n second left</numerusform>
            <numerusform>about %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n minute(s) left</source>
        <translation>
            <numerusform>about %n minute left</numerusform>
            <numerusform>about %n minutes left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n hour(s) left</source>
        <translation>
            <numerusform>about %n hour left</numerusform>
            <numerusform>about %n hours left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::LinksModel</name>
    <message numerus="yes">
        <source>Remove %n link(s)</source>
        <translation>
            <numerusform>Remove %n link</numerusform>
            <numerusform>Remove %n links</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::ProblemsPanel</name>
    <message numerus="yes">
        <source>%n problems were found while reading.</source>
        <translation>
            <numerusform>%n problem was found while reading.</numerusform>
            <numerusform>%n problems were found while reading.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::SuggestionList</name>
    <message numerus="yes">
        <source>%n maps</source>
        <translation>
            <numerusform>%n map</numerusform>
            <numerusform>%n maps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::Timeline</name>
    <message numerus="yes">
        <source>%n key(s) beyond the new end deleted. Undo brings them back.</source>
        <translation>
            <numerusform>%n key beyond the new end deleted. Undo brings it back.</numerusform>
            <numerusform>%n keys beyond the new end deleted. Undo brings them back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n key(s) not pasted: beyond the end of the animation, or of a part that this fractal does not have.</source>
        <translation>
            <numerusform>%n key not pasted: beyond the end of the animation, or of a part that this fractal does not have.</numerusform>
            <numerusform>%n keys not pasted: beyond the end of the animation, or of a part that this fractal does not have.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>view::TransportBar</name>
    <message numerus="yes">
        <source>Length of the animation: %n frame(s)</source>
        <translation>
            <numerusform>Length of the animation: %n frame</numerusform>
            <numerusform>Length of the animation: %n frames</numerusform>
        </translation>
    </message>
</context>
</TS>
