// SPDX-License-Identifier: MIT
#include "panels/maps_model.h"

#include "cage_edits.h"
#include "ifs/decomposition.h"
#include "panels/maps_edits.h"
#include "panels/number_text.h"

#include "io/number.h"

#include <QColor>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

// Coefficient a … f of the map, counted from 0.
double coefficient(const ifs::AffineMap<2>& map, int which) {
    return which < 4 ? map.linear(which / 2, which % 2) : map.translation[which - 4];
}

void setCoefficient(ifs::AffineMap<2>& map, int which, double value) {
    if (which < 4)
        map.linear(which / 2, which % 2) = value;
    else
        map.translation[which - 4] = value;
}

bool contracts(const ifs::AffineMap<2>& map) {
    return ifs::spectralNorm<2>(map.linear) < 1;
}

QString kindText(const ifs::AffineMap<2>& map) {
    switch (ifs::kind<2>(map.linear)) {
    case ifs::MapKind::Similarity:
        return MapsModel::tr("similarity");
    case ifs::MapKind::ReflectedSimilarity:
        return MapsModel::tr("reflected similarity");
    case ifs::MapKind::Affine:
        return MapsModel::tr("affine");
    case ifs::MapKind::Singular:
        return MapsModel::tr("singular");
    case ifs::MapKind::Constant:
        return MapsModel::tr("constant");
    }
    return {};
}

QString kindTip(const ifs::AffineMap<2>& map) {
    switch (ifs::kind<2>(map.linear)) {
    case ifs::MapKind::Similarity:
        return MapsModel::tr("A similarity keeps shapes: it turns, scales and shifts.");
    case ifs::MapKind::ReflectedSimilarity:
        return MapsModel::tr(
            "A reflected similarity keeps shapes, as a mirror does, and scales and shifts them.");
    case ifs::MapKind::Affine:
        return MapsModel::tr("An affine map keeps lines and parallels, not angles.");
    case ifs::MapKind::Singular:
        return MapsModel::tr("A singular map takes the plane to a line.");
    case ifs::MapKind::Constant:
        return MapsModel::tr("A constant map takes the plane to one point.");
    }
    return {};
}

QString columnName(int column) {
    static const QStringList letters{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c"),
                                     QStringLiteral("d"), QStringLiteral("e"), QStringLiteral("f")};
    if (column >= MapsModel::A && column <= MapsModel::F) return letters[column - MapsModel::A];
    if (column >= MapsModel::EffectiveA) return letters[column - MapsModel::EffectiveA] + QStringLiteral("′");
    switch (column) {
    case MapsModel::Enabled:
        return MapsModel::tr("On");
    case MapsModel::Weight:
        return MapsModel::tr("p");
    case MapsModel::Determinant:
        return MapsModel::tr("det");
    case MapsModel::Contraction:
        return MapsModel::tr("‖A‖");
    case MapsModel::Kind:
        return MapsModel::tr("Kind");
    default:
        return {};
    }
}

QString columnTip(int column) {
    if (column >= MapsModel::A && column <= MapsModel::F)
        return MapsModel::tr("The map takes (x, y) to (a x + b y + e, c x + d y + f).");
    if (column >= MapsModel::EffectiveA)
        return MapsModel::tr(
            "Effective code: the map as it acts on the picture under the current cage. Bake makes it "
            "the code.");
    switch (column) {
    case MapsModel::Enabled:
        return MapsModel::tr("Whether the map takes part.");
    case MapsModel::Colour:
        return MapsModel::tr("Colour of the map, used when the picture is coloured by map.");
    case MapsModel::Weight:
        return MapsModel::tr(
            "Weight as given: how often the chaos game takes the map. The weights need not sum to 1.");
    case MapsModel::Determinant:
        return MapsModel::tr("Determinant ad − bc: the factor of areas; negative when the map reflects.");
    case MapsModel::Contraction:
        return MapsModel::tr(
            "Contraction factor ‖A‖, the largest singular value: the most by which distances grow.");
    case MapsModel::Kind:
        return MapsModel::tr("What the map is geometrically.");
    default:
        return {};
    }
}

// What displays the code; nullopt where no code would show the same: while the placement is flat or bends.
std::optional<ifs::AffineMap<2>> displayOf(const document::Fractal& fractal) {
    if (isAtRest(fractal)) return ifs::AffineMap<2>{};
    if (ifs::bends(*fractal.cage)) return std::nullopt;
    const ifs::AffineMap<2> display = ifs::displayMap(*fractal.cage);
    return ifs::conjugate(display, document::System2{}) ? std::optional(display) : std::nullopt;
}

std::optional<ifs::AffineMap<2>> effectiveMap(const ifs::AffineMap<2>& display,
                                              const ifs::AffineMap<2>& map) {
    return display == ifs::AffineMap<2>{} ? map : ifs::conjugate(display, map);
}

constexpr int mostDecimals = 4; // that shortNumber() gives
constexpr int rowsLookedAt = 1000;

int decimalsOf(const QString& number) {
    const auto point = number.indexOf(u'.');
    return point < 0 || number.contains(u'e') ? 0 : static_cast<int>(number.size() - point - 1);
}

} // namespace

MapsModel::MapsModel(document::Document* document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_edit(document) {
    connect(document, &document::Document::changed, this, &MapsModel::follow);
    reload(false);
}

void MapsModel::follow(const document::Change& change) {
    using document::Change;
    if (!(change.parts & (Change::System | Change::Cage | Change::Appearance | Change::Entries |
                          Change::Current | Change::File)))
        return;
    const document::System2* system = document::system2(m_document->fractal());
    const bool sameCode = system && system->maps == m_maps; // as while the cage is dragged
    const bool sameRows =
        sameCode ||
        (system && std::equal(system->maps.begin(), system->maps.end(), m_maps.begin(), m_maps.end(),
                              [](const auto& a, const auto& b) { return a.id == b.id; }));
    if (!sameRows || change.parts & (Change::Current | Change::File)) {
        beginResetModel();
        reload(sameCode);
        endResetModel();
        return;
    }
    reload(sameCode);
    if (m_maps.empty()) return;
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    if (!sameCode) emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1); // the warnings
}

void MapsModel::reload(bool sameCode) {
    const document::Fractal& fractal = m_document->fractal();
    const document::System2* system = document::system2(fractal);
    if (!sameCode) {
        m_maps = system ? system->maps : std::vector<ifs::WeightedMap<2>>{};
        m_probabilities = system ? ifs::probabilities(*system) : std::vector<double>{};
    }
    m_display = system ? displayOf(fractal) : std::nullopt;
    m_decimals.resize(ColumnCount);
    std::fill(m_decimals.begin() + (sameCode ? int(EffectiveA) : 0), m_decimals.end(), std::nullopt);
}

// Asked for by what is in sight, and of as many rows as a header looks at for its widths: a hundred thousand
// numbers are not written out.
int MapsModel::decimals(int column) const {
    std::optional<int>& most = m_decimals[static_cast<std::size_t>(column)];
    if (most) return *most;
    most = 0;
    std::optional<double> previous;
    for (int row = 0; isNumber(column) && row < std::min(rowCount(), rowsLookedAt) && *most < mostDecimals;
         ++row) {
        const std::optional<double> value = number(row, column);
        if (value && value != previous) most = std::max(*most, decimalsOf(shortNumber(*value)));
        previous = value;
    }
    return *most;
}

int MapsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_maps.size());
}

int MapsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(ColumnCount);
}

ifs::MapId MapsModel::idAt(int row) const {
    return row >= 0 && row < rowCount() ? m_maps[static_cast<std::size_t>(row)].id : ifs::MapId::None;
}

std::optional<double> MapsModel::number(int row, int column) const {
    const auto& map = m_maps[static_cast<std::size_t>(row)];
    if (column >= A && column <= F) return coefficient(map.map, column - A);
    if (column >= EffectiveA) {
        const auto effective = m_display ? effectiveMap(*m_display, map.map) : std::nullopt;
        return effective ? std::optional(coefficient(*effective, column - EffectiveA)) : std::nullopt;
    }
    switch (column) {
    case Weight:
        return map.weight ? *map.weight : m_probabilities[static_cast<std::size_t>(row)];
    case Determinant:
        return ifs::determinant<2>(map.map.linear);
    case Contraction:
        return ifs::spectralNorm<2>(map.map.linear);
    default:
        return std::nullopt;
    }
}

QString MapsModel::tip(int row, int column) const {
    const auto& map = m_maps[static_cast<std::size_t>(row)];
    if (column == Enabled)
        return map.enabled ? tr("Map %1 takes part.").arg(row + 1)
                           : tr("Map %1 is switched off.").arg(row + 1);
    if (column == Colour)
        return tr("Colour of map %1. Press Space or double-click to change it.").arg(row + 1);
    if (column == Kind) return kindTip(map.map);
    const auto value = number(row, column);
    if (!value) return tr("The cage is flat or bent: there is no effective code.");
    if (column != Weight) return fullNumber(*value);
    const QString probability = shortNumber(m_probabilities[static_cast<std::size_t>(row)]);
    if (!map.weight)
        return tr("No weight is given; the determinant rule makes the probability %1.").arg(probability);
    if (*map.weight <= 0)
        return tr("Weight %1: a weight that is not positive switches the map off.")
            .arg(fullNumber(*map.weight));
    return tr("Weight %1, probability %2.").arg(fullNumber(*map.weight), probability);
}

QVariant MapsModel::alignment(int column) const {
    if (isNumber(column)) return int(Qt::AlignRight | Qt::AlignVCenter);
    return int((column == Kind ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
}

QVariant MapsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {}; // as views ask when nothing is current
    if (!checkIndex(index, CheckIndexOption::ParentIsInvalid)) return {};
    const int row = index.row();
    const int column = index.column();
    const auto& map = m_maps[static_cast<std::size_t>(row)];
    switch (role) {
    case Qt::DisplayRole:
        if (column == Kind)
            return contracts(map.map) ? kindText(map.map) : tr("%1, not contracting").arg(kindText(map.map));
        if (isNumber(column)) {
            const auto value = number(row, column);
            return value ? shortNumber(*value) : QStringLiteral("–");
        }
        return {};
    case Qt::EditRole:
        if (const auto value = isNumber(column) ? number(row, column) : std::nullopt) return *value;
        return {};
    case Qt::CheckStateRole:
        if (column == Enabled) return static_cast<int>(map.enabled ? Qt::Checked : Qt::Unchecked);
        return {};
    case Qt::DecorationRole:
        if (column == Colour) {
            const auto c = attractor::mapColour(m_document->fractal().appearance, map.id, index.row());
            return QColor(c.red, c.green, c.blue, c.alpha);
        }
        return {};
    case Qt::ForegroundRole:
        if (m_probabilities[static_cast<std::size_t>(row)] <= 0 || (column == Weight && !map.weight) ||
            column > Weight)
            return QGuiApplication::palette().color(QPalette::PlaceholderText);
        return {};
    case Qt::ToolTipRole: {
        const QString warning =
            column == Contraction || column == Kind ? data(index, WarningRole).toString() : QString();
        return warning.isEmpty() ? tip(row, column) : warning;
    }
    case Qt::AccessibleTextRole:
        if (column == Colour)
            return tr("colour %1").arg(data(index, Qt::DecorationRole).value<QColor>().name());
        if (column == Enabled) return map.enabled ? tr("on") : tr("off");
        return {};
    case Qt::TextAlignmentRole:
        return alignment(column);
    case DecimalsRole:
        return decimals(column);
    case WarningRole:
        if (contracts(map.map)) return QString();
        return tr("Map %1 does not contract: it stretches by up to %2. The system may still have an "
                  "attractor if "
                  "longer words contract.")
            .arg(row + 1)
            .arg(shortNumber(ifs::spectralNorm<2>(map.map.linear)));
    default:
        return {};
    }
}

QVariant MapsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        if (role == Qt::DisplayRole) return section + 1;
        if (section < 0 || section >= rowCount()) return {};
        const QString warning = data(index(section, Kind), WarningRole).toString();
        if (role == Qt::ToolTipRole)
            return warning.isEmpty() ? tr("Map %1. Drag to reorder.").arg(section + 1) : warning;
        if (role == WarningRole) return warning;
        return {};
    }
    if (role == Qt::DisplayRole) return columnName(section);
    if (role == Qt::ToolTipRole) return columnTip(section);
    if (role == Qt::TextAlignmentRole) return alignment(section);
    return {};
}

Qt::ItemFlags MapsModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    if (isEditable(index.column())) flags |= Qt::ItemIsEditable;
    if (index.column() == Enabled) flags |= Qt::ItemIsUserCheckable;
    return flags;
}

void MapsModel::change(document::Fractal& fractal, const QModelIndex& index, double value) const {
    if (index.column() == Weight) {
        fractal = withWeight(std::move(fractal), index.row(), value);
        return;
    }
    auto& map = document::system2(fractal)->maps[static_cast<std::size_t>(index.row())].map;
    setCoefficient(map, index.column() - A, value);
}

QString MapsModel::editText(int row, int column) const {
    return column == Weight ? tr("Change weight of map %1").arg(row + 1)
                            : tr("Change %1 of map %2").arg(columnName(column)).arg(row + 1);
}

void MapsModel::preview(const QModelIndex& index, double value) {
    if (!index.isValid() || !isEditable(index.column())) return;
    m_edit.preview(editText(index.row(), index.column()),
                   [&](document::Fractal& fractal) { change(fractal, index, value); });
}

bool MapsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
    document::Fractal fractal = m_document->fractal();
    if (role == Qt::CheckStateRole && index.column() == Enabled) {
        const bool on = value.toInt() == Qt::Checked;
        document::system2(fractal)->maps[static_cast<std::size_t>(index.row())].enabled = on;
        m_document->edit((on ? tr("Switch map %1 on") : tr("Switch map %1 off")).arg(index.row() + 1),
                         std::move(fractal));
        return true;
    }
    if (role == Qt::DecorationRole && index.column() == Colour) {
        const auto colour = value.value<QColor>();
        if (!colour.isValid()) return false;
        const auto channel = [](int c) { return static_cast<std::uint8_t>(c); };
        const attractor::Rgba chosen{channel(colour.red()), channel(colour.green()), channel(colour.blue()),
                                     channel(colour.alpha())};
        const ifs::MapId id = idAt(index.row());
        if (chosen == attractor::mapColour(fractal.appearance, id, std::size_t(index.row()))) return true;
        fractal.appearance.mapColours[id] = chosen;
        m_document->edit(tr("Change colour of map %1").arg(index.row() + 1), std::move(fractal));
        return true;
    }
    if (role != Qt::EditRole || !isEditable(index.column())) return false;
    const auto number = value.typeId() == QMetaType::QString ? typedNumber(value.toString())
                                                             : std::optional(value.toDouble());
    if (!number || !std::isfinite(*number)) return false;
    change(fractal, index, *number);
    m_document->edit(editText(index.row(), index.column()), std::move(fractal));
    return true;
}

} // namespace view
