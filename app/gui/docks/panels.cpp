// SPDX-License-Identifier: MIT
#include "docks/panels.h"

#include "document/text/text.h"

#include <QCoreApplication>
#include <QDockWidget>

#include <algorithm>

namespace {

struct PanelRow {
    Panel panel;
    Qt::DockWidgetArea area;
    const char* title;
    const char* whatsThis;
};
constexpr PanelRow panelRows[] = {
    {Panel::Entries, Qt::LeftDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Entries"),
     QT_TRANSLATE_NOOP("Text", "The fractals in the open file. The canvas shows the one you select here.")},
    {Panel::Collection, Qt::LeftDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Collection"),
     QT_TRANSLATE_NOOP("Text", "Ready-made fractals by theme, and your own folders of fractals.")},
    {Panel::Maps, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Maps"),
     QT_TRANSLATE_NOOP("Text", "The maps of the fractal: its code, one map per row.")},
    {Panel::Cage, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Cage"),
     QT_TRANSLATE_NOOP("Text", "The control cage in numbers: its vertices, their positions at rest, what "
                               "moving them does, and other cages to choose from.")},
    {Panel::Appearance, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Appearance"),
     QT_TRANSLATE_NOOP(
         "Text", "Colours, brightness and background of the picture. They are saved with the fractal.")},
    {Panel::Analysis, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Analysis"),
     QT_TRANSLATE_NOOP("Text",
                       "Mathematical properties of this fractal. Point to a name to see what it means.")},
    {Panel::History, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "History"),
     QT_TRANSLATE_NOOP("Text",
                       "Every step since the file was opened. Select one to go back or forward to it.")},
    {Panel::Collage, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Collage"),
     QT_TRANSLATE_NOOP("Text", "Find a fractal that looks like a picture: the target, how well the fractal "
                               "agrees with it, and ways to fit it.")},
    {Panel::Links, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Links"),
     QT_TRANSLATE_NOOP("Text", "Which map may follow which in the chaos game, as a graph and as a matrix.")},
    {Panel::Exports, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Exports"),
     QT_TRANSLATE_NOOP("Text",
                       "Pictures drawn one after another in the background, with the progress of each.")},
    {Panel::Problems, Qt::BottomDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Problems"),
     QT_TRANSLATE_NOOP(
         "Text",
         "Problems found in the file, with line and column. The text in the file is kept unchanged.")},
    {Panel::Timeline, Qt::BottomDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Timeline"),
     QT_TRANSLATE_NOOP(
         "Text", "The animation of this fractal: its motions, and the keys of everything that can move.")},
    {Panel::Lesson, Qt::RightDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Lesson"),
     QT_TRANSLATE_NOOP("Text", "A lesson about these fractals: its steps, each with a text and the state of "
                               "the window, to be played in full screen.")},
    {Panel::Snapshots, Qt::BottomDockWidgetArea, QT_TRANSLATE_NOOP("MainWindow", "Snapshots"),
     QT_TRANSLATE_NOOP("Text",
                       "States of this fractal that you kept while working on it. Click one to restore it.")},
};

} // namespace

PanelFacts factsOf(Panel panel) {
    const auto* row =
        std::ranges::find_if(panelRows, [panel](const PanelRow& each) { return each.panel == panel; });
    return {row->area, QCoreApplication::translate("MainWindow", row->title), Text::tr(row->whatsThis)};
}

void Panels::show(Panel panel) const {
    dock(panel)->show();
    dock(panel)->raise();
}
