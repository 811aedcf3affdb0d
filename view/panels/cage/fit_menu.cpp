// SPDX-License-Identifier: MIT
#include "panels/cage/fit_menu.h"

#include "document/text/text.h"
#include "panels/cage/cage_texts.h"

#include <QMenu>

#include <array>

namespace view {

QMenu* makeFitMenu(QWidget* parent, const PlaneFits& fits) {
    auto* menu = new QMenu(parent);
    const auto add = [&](const QString& text, document::SimplexChoice choice) {
        menu->addAction(text, parent, [fits, choice] { fits.simplex(choice); });
    };
    add(Text::tr("Minimal Canonical Simplex"), document::SimplexChoice::Minimal);
    menu->addSeparator();
    const std::array choices{document::SimplexChoice::PlusPlus, document::SimplexChoice::MinusPlus,
                             document::SimplexChoice::PlusMinus, document::SimplexChoice::MinusMinus};
    const std::array<ifs::Orientation<2>, 4> orientations{{{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (std::size_t i = 0; i < choices.size(); ++i)
        add(Text::tr("Canonical Simplex %1").arg(document::orientationText(orientations[i])), choices[i]);
    menu->addSeparator();
    menu->addAction(Text::tr("Bounding Box"), parent,
                    [fits] { fits.polygon(document::PolygonChoice::Box, 4); });
    menu->addAction(Text::tr("Smallest Rectangle"), parent,
                    [fits] { fits.polygon(document::PolygonChoice::Rectangle, 4); });
    const auto addPolygons = [&](const QString& title, document::PolygonChoice choice) {
        QMenu* polygons = menu->addMenu(title);
        for (const int corners : {3, 4, 5, 6, 8, 12, 16, 24})
            polygons->addAction(Text::tr("%n Corners", nullptr, corners), parent,
                                [fits, choice, corners] { fits.polygon(choice, corners); });
    };
    addPolygons(Text::tr("Convex Hull, Simplified to"), document::PolygonChoice::Hull);
    addPolygons(Text::tr("Regular Polygon with"), document::PolygonChoice::Regular);
    return menu;
}

QMenu* makeFitMenu(QWidget* parent, const SpaceFits& fits) {
    auto* menu = new QMenu(parent);
    menu->addAction(Text::tr("Minimal Canonical Simplex"), parent,
                    [fits] { fits.tetrahedron(std::nullopt); });
    menu->addSeparator();
    for (int k = 0; k < 8; ++k) {
        const ifs::Orientation<3> orientation{(k & 1) != 0 ? -1 : 1, (k & 2) != 0 ? -1 : 1,
                                              (k & 4) != 0 ? -1 : 1};
        menu->addAction(Text::tr("Canonical Simplex %1").arg(document::orientationText(orientation)), parent,
                        [fits, orientation] { fits.tetrahedron(orientation); });
    }
    menu->addSeparator();
    menu->addAction(Text::tr("Three Edges of the Bounding Box"), parent, [fits] { fits.box(); });
    menu->addSeparator();
    using document::SpacePolyhedron;
    menu->addAction(Text::tr("Bounding Box, Eight Corners"), parent,
                    [fits] { fits.polyhedron(SpacePolyhedron::Box, 8); });
    menu->addAction(Text::tr("Octahedron"), parent,
                    [fits] { fits.polyhedron(SpacePolyhedron::Octahedron, 6); });
    QMenu* hulls = menu->addMenu(Text::tr("Convex Hull, Simplified to"));
    for (const int corners : {10, 12, 16, 20, 24})
        hulls->addAction(Text::tr("%n Corners", nullptr, corners), parent,
                         [fits, corners] { fits.polyhedron(SpacePolyhedron::Hull, corners); });
    return menu;
}

} // namespace view
