// SPDX-License-Identifier: MIT
#include "panels/maps/maps_texts.h"

#include "widgets/numbers/number_text.h"

#include <QCoreApplication>

#include <cmath>

namespace view {

namespace {

struct OfModel {
    Q_DECLARE_TR_FUNCTIONS(view::MapsModel)
};
struct OfPanel {
    Q_DECLARE_TR_FUNCTIONS(view::MapsPanel)
};

} // namespace

int decimalsOf(const QString& number) {
    const auto point = number.indexOf(u'.');
    return point < 0 || number.contains(u'e') ? 0 : static_cast<int>(number.size() - point - 1);
}

QString steadyNumber(double value, int decimals) {
    const double one = std::pow(10, decimals);
    const double rounded = std::abs(value) < 1e6 ? std::round(value * one) / one : value;
    return roundedNumber(rounded != 0 ? rounded : value, decimals);
}

QString kindText(ifs::MapKind kind) {
    switch (kind) {
    case ifs::MapKind::Similarity:
        return OfModel::tr("similarity");
    case ifs::MapKind::ReflectedSimilarity:
        return OfModel::tr("reflected similarity");
    case ifs::MapKind::Affine:
        return OfModel::tr("affine");
    case ifs::MapKind::Singular:
        return OfModel::tr("singular");
    case ifs::MapKind::Constant:
        return OfModel::tr("constant");
    }
    return {};
}

QString kindTip(ifs::MapKind kind, int dimension) {
    const bool plane = dimension == 2;
    switch (kind) {
    case ifs::MapKind::Similarity:
        return OfModel::tr("A similarity keeps shapes: it turns, scales and shifts.");
    case ifs::MapKind::ReflectedSimilarity:
        return OfModel::tr(
            "A reflected similarity keeps shapes but mirrors them; it also turns, scales and shifts them.");
    case ifs::MapKind::Affine:
        return OfModel::tr("An affine map keeps lines and parallels but not angles.");
    case ifs::MapKind::Singular:
        return plane ? OfModel::tr("A singular map takes the whole plane to a line.")
                     : OfModel::tr("A singular map takes the whole of space to a plane or a line.");
    case ifs::MapKind::Constant:
        return plane ? OfModel::tr("A constant map takes the whole plane to one point.")
                     : OfModel::tr("A constant map takes the whole of space to one point.");
    }
    return {};
}

QString coefficientTip(int dimension) {
    return dimension == 2
               ? OfModel::tr("The map takes (x, y) to (a x + b y + e, c x + d y + f).")
               : OfModel::tr("The map takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, "
                             "g x + h y + i z + l).");
}

QString tableWhatsThis(int dimension) {
    return dimension == 2
               ? OfPanel::tr(
                     "Each row is a map: it takes (x, y) to (a x + b y + e, c x + d y + f) and is used in "
                     "proportion to its weight p. Double-click a number or start typing to change it; the "
                     "picture follows every keystroke. Drag the number of a row to move it.")
               : OfPanel::tr(
                     "Each row is a map: it takes (x, y, z) to (a x + b y + c z + j, d x + e y + f z + k, "
                     "g x + h y + i z + l) and is used in proportion to its weight p. Double-click a number "
                     "or "
                     "start typing to change it; the picture follows every keystroke. Drag the number of a "
                     "row "
                     "to move it.");
}

QString typedPlace(ifs::MapId map, int column) {
    return QStringLiteral("map %1 %2").arg(int(map)).arg(column);
}

QString factsText(const std::array<QString, 3>& facts, int row, int selected) {
    if (row < 0) return OfPanel::tr("Select a map to see and edit it here.");
    const QString text = OfPanel::tr("det %1    ‖A‖ %2    %3").arg(facts[0], facts[1], facts[2]);
    return selected < 2 ? text
                        : OfPanel::tr("Map %1 only, of %2 selected    %3")
                              .arg(QString::number(row + 1), QString::number(selected), text);
}

} // namespace view
