// SPDX-License-Identifier: MIT
#include "panels/cage/fit_menu.h"

#include "document/edits/cage/cage_fits.h"
#include "document/text/text.h"
#include "panels/cage/cage_texts.h"

#include <QMenu>

#include <array>

namespace view {

namespace {

// `fit` takes the choice and the number of corners.
template <int Dim> void addFits(QMenu& menu, QWidget* parent, const auto& fit) {
    for (const auto& row : document::cageFits<Dim>()) {
        const QString title = Text::tr(row.title);
        const auto add = [&](QMenu& to, const QString& text, int corners) {
            to.addAction(text, parent, [fit, choice = row.choice, corners] { fit(choice, corners); });
        };
        if (row.corners.offered.empty()) {
            add(menu, title, row.corners.usual);
            continue;
        }
        QMenu* counts = menu.addMenu(title);
        for (const int corners : row.corners.offered)
            add(*counts, Text::tr("%n Corners", nullptr, corners), corners);
    }
}

} // namespace

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
    addFits<2>(*menu, parent, fits.polygon);
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
    addFits<3>(*menu, parent, fits.polyhedron);
    return menu;
}

} // namespace view
