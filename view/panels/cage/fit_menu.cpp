// SPDX-License-Identifier: MIT
#include "panels/cage/fit_menu.h"

#include "document/edits/cage_edits.h"
#include "panels/cage/cage_panel.h"
#include "panels/cage/cage_texts.h"

#include <QMenu>

#include <array>

namespace view {

QMenu* makeFitMenu(CagePanel* panel) {
    auto* menu = new QMenu(panel);
    const auto add = [&](const QString& text, document::SimplexChoice choice) {
        menu->addAction(text, panel, [panel, choice] { panel->fit(choice); });
    };
    add(CagePanel::tr("Minimal Canonical Simplex"), document::SimplexChoice::Minimal);
    menu->addSeparator();
    const std::array choices{document::SimplexChoice::PlusPlus, document::SimplexChoice::MinusPlus,
                             document::SimplexChoice::PlusMinus, document::SimplexChoice::MinusMinus};
    const std::array<ifs::Orientation<2>, 4> orientations{{{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (std::size_t i = 0; i < choices.size(); ++i)
        add(CagePanel::tr("Canonical Simplex %1").arg(document::orientationText(orientations[i])),
            choices[i]);
    menu->addSeparator();
    menu->addAction(CagePanel::tr("Bounding Box"), panel,
                    [panel] { panel->fit(document::PolygonChoice::Box); });
    const auto addPolygons = [&](const QString& title, document::PolygonChoice choice) {
        QMenu* polygons = menu->addMenu(title);
        for (const int corners : {3, 4, 5, 6, 8, 12, 16, 24})
            polygons->addAction(CagePanel::tr("%n Corners", nullptr, corners), panel,
                                [panel, choice, corners] { panel->fit(choice, corners); });
    };
    addPolygons(CagePanel::tr("Convex Hull, Simplified to"), document::PolygonChoice::Hull);
    addPolygons(CagePanel::tr("Regular Polygon with"), document::PolygonChoice::Regular);
    return menu;
}

QMenu* makeSpaceFitMenu(CagePanel* panel) {
    auto* menu = new QMenu(panel);
    menu->addAction(CagePanel::tr("Minimal Canonical Simplex"), panel, [panel] { panel->fitTetrahedron(); });
    menu->addSeparator();
    for (int k = 0; k < 8; ++k) {
        const ifs::Orientation<3> orientation{(k & 1) != 0 ? -1 : 1, (k & 2) != 0 ? -1 : 1,
                                              (k & 4) != 0 ? -1 : 1};
        menu->addAction(CagePanel::tr("Canonical Simplex %1").arg(orientationText(orientation)), panel,
                        [panel, orientation] { panel->fitTetrahedron(orientation); });
    }
    menu->addSeparator();
    menu->addAction(CagePanel::tr("Three Edges of the Bounding Box"), panel, [panel] { panel->fitBox(); });
    return menu;
}

} // namespace view
