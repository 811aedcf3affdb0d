// SPDX-License-Identifier: MIT
#include "actions/panel_texts.h"
#include "document/text/text.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

#include <utility>

void explainPanels(const QMainWindow& window) {
    for (const auto& [id, text] :
         {std::pair{"entries",
                    Text::tr("The fractals in the open file. The canvas shows the one you select here.")},
          {"collection", Text::tr("Ready-made fractals by theme, and your own folders of fractals.")},
          {"maps", Text::tr("The maps of the fractal: its code, one map per row.")},
          {"links", Text::tr("Which map may follow which in the chaos game, as a graph and as a matrix.")},
          {"cage",
           Text::tr("The control cage in numbers: its vertices, their positions at rest, what moving them "
                    "does, and other cages to choose from.")},
          {"appearance",
           Text::tr("Colours, brightness and background of the picture. They are saved with the fractal.")},
          {"analysis",
           Text::tr("Mathematical properties of this fractal. Point to a name to see what it means.")},
          {"history",
           Text::tr("Every step since the file was opened. Select one to go back or forward to it.")},
          {"snapshots",
           Text::tr("States of this fractal that you kept while working on it. Click one to restore it.")},
          {"timeline",
           Text::tr("The animation of this fractal: its motions, and the keys of everything that can move.")},
          {"collage", Text::tr("Find a fractal that looks like a picture: the target, how well the fractal "
                               "agrees with it, and ways to fit it.")},
          {"exports",
           Text::tr("Pictures drawn one after another in the background, with the progress of each.")},
          {"lesson",
           Text::tr("A lesson about these fractals: its steps, each with a text and the state of the "
                    "window, to be played in full screen.")},
          {"problems",
           Text::tr(
               "Problems found in the file, with line and column. The text in the file is kept unchanged.")}})
        if (auto* panel = window.findChild<QDockWidget*>(QLatin1String(id))) {
            panel->setWhatsThis(text);
            panel->toggleViewAction()->setWhatsThis(panel->toggleViewAction()->statusTip() +
                                                    QStringLiteral(". ") + text);
        }
}
