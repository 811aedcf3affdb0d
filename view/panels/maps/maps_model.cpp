// SPDX-License-Identifier: MIT
#include "panels/maps/maps_model.h"

#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "document/maps/map_names.h"
#include "document/moments/animated_fractal.h"
#include "ifs/system/decomposition.h"
#include "panels/maps/calculated_maps.h"
#include "panels/maps/maps_texts.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_text.h"
#include "widgets/text/tooltip_text.h"

#include "io/text/export_weights.h"
#include "io/text/number.h"
#include "io/text/typed_coefficient.h"

#include <QColor>
#include <QGuiApplication>
#include <QHash>
#include <QPalette>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace view {

namespace {

template <int Dim>
void setCoefficient(ifs::WeightedMap<Dim>& map, int which, double value, const QString& text) {
    if (which < Dim * Dim)
        map.map.linear(which / Dim, which % Dim) = value;
    else
        map.map.translation[which - Dim * Dim] = value;
    map.typed.clear(which);
    io::keepTyped(map, which, text);
}

template <int Dim> bool contracts(const ifs::AffineMap<Dim>& map) {
    return ifs::spectralNorm<Dim>(map.linear) < 1;
}

constexpr int rowsLookedAt = 1000;

} // namespace

document::Rows rowsIn(const QItemSelection& selection) {
    document::Rows rows;
    for (const QItemSelectionRange& range : selection)
        for (int row = range.top(); row <= range.bottom(); ++row)
            rows.push_back(row);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

MapsModel::MapsModel(document::Document* document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_edit(document) {
    connect(document, &document::Document::changed, this, &MapsModel::follow);
    reload(false);
}

void MapsModel::follow(const document::Change& change) {
    using document::Change;
    if (!(change.parts & (Change::System | Change::Cage | Change::Appearance | Change::Entries |
                          Change::Current | Change::File | Change::Name | Change::Animation)))
        return;
    const bool sameCode = isCodeShown(m_document->fractal()); // true while the cage is dragged
    const bool sameRows = sameCode || areRowsShown(m_document->fractal());
    if (!sameRows || change.parts & (Change::Current | Change::File)) {
        beginResetModel();
        reload(sameCode);
        endResetModel();
        return;
    }
    reload(sameCode);
    if (rowCount() == 0) return;
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    if (!sameCode) emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1); // updates the warnings
}

bool MapsModel::isCodeShown(const document::Fractal& fractal) const {
    const auto isShown = [](const auto& system, const auto& shown) {
        return system.maps == shown.maps && system.links == shown.links;
    };
    if (const document::System2* system = document::system2(fractal))
        return dimension() == 2 && isShown(*system, std::get<0>(m_shown));
    const document::System3* system = document::system3(fractal);
    return system && dimension() == 3 && isShown(*system, std::get<1>(m_shown));
}

bool MapsModel::areRowsShown(const document::Fractal& fractal) const {
    const auto areSame = [](const auto& a, const auto& b) {
        return std::ranges::equal(a, b, [](const auto& p, const auto& q) { return p.id == q.id; });
    };
    if (const document::System2* system = document::system2(fractal))
        return dimension() == 2 && areSame(system->maps, std::get<0>(m_shown).maps);
    const document::System3* system = document::system3(fractal);
    return system && dimension() == 3 && areSame(system->maps, std::get<1>(m_shown).maps);
}

void MapsModel::reload(bool sameCode) {
    const auto show = [&]<int Dim>(const document::Shape<Dim>& shape) {
        if (!sameCode) {
            m_shown = Shown<Dim>{shape.system.maps, shape.system.links, {}};
            m_probabilities = ifs::probabilities(shape.system);
        }
        std::get<Shown<Dim>>(m_shown).display = displayOf(shape);
    };
    m_isMoving = document::animationFacts(m_document->entryFractal()).has_value();
    const document::Fractal& fractal = m_document->fractal();
    if (const auto* plane = document::plane(fractal)) {
        show(*plane);
    } else if (const auto* space = document::space(fractal)) {
        show(*space);
    } else {
        m_shown = Shown<2>{};
        m_probabilities.clear();
    }
    m_decimals.resize(static_cast<std::size_t>(columnCount()));
    std::fill(m_decimals.begin() + (sameCode ? columnOf(EffectiveA) : 0), m_decimals.end(), std::nullopt);
}

int MapsModel::columnOf(Column column) const {
    return column <= A ? int(column) : int(column) + coefficientCount() - (Weight - A);
}

MapsModel::Meaning MapsModel::meaningOf(int column) const {
    if (column < A) return {static_cast<Column>(column)};
    if (column < columnOf(Weight)) return {A, column - A};
    if (column >= columnOf(EffectiveA)) return {EffectiveA, column - columnOf(EffectiveA)};
    return {static_cast<Column>(column - columnOf(Weight) + Weight)};
}

bool MapsModel::isNumber(int column) const {
    return column >= A && column < columnCount() && meaningOf(column).kind != Kind;
}

QString MapsModel::columnName(int column) const {
    const auto [kind, which] = meaningOf(column);
    switch (kind) {
    case A:
        return QChar(u'a' + which);
    case EffectiveA:
        return QChar(u'a' + which) + QStringLiteral("′");
    case Enabled:
        return tr("On");
    case Name:
        return tr("Name");
    case Weight:
        return tr("p");
    case Determinant:
        return tr("det");
    case Contraction:
        return tr("‖A‖");
    case Kind:
        return tr("Kind");
    default:
        return {};
    }
}

QString MapsModel::columnTip(int column) const {
    switch (meaningOf(column).kind) {
    case A:
        return coefficientTip(dimension());
    case EffectiveA:
        return dimension() == 2
                   ? tr("Effective code: the map as it acts on the picture under the current cage. Bake "
                        "turns it into the code.")
                   : tr("Effective code: the map as it acts on the picture under the current cage.");
    case Enabled:
        return tr("Whether the map is switched on. Alt+click shows one map alone.");
    case Lock:
        return tr("Whether the map is locked: then it cannot be edited, moved or deleted by mistake.");
    case Colour:
        return tr(
            "Colour of the map, used when the picture is coloured by map, and the part of the attractor "
            "that the map makes.");
    case Name:
        return tr("Name of the map.");
    case Weight:
        return tr(
            "Weight as entered: how often the chaos game chooses the map. The weights need not sum to 1.");
    case Determinant:
        return dimension() == 2
                   ? tr("Determinant ad − bc: the factor by which areas change; negative if the map "
                        "reflects.")
                   : tr("Determinant: the factor by which volumes change; negative if the map reflects.");
    case Contraction:
        return tr("Contraction factor ‖A‖, the largest singular value: the largest factor by "
                  "which distances are stretched.");
    case Kind:
        return tr("The geometric kind of the map.");
    default:
        return {};
    }
}

// A moving entry has the same decimals at every moment, so that the numbers stand still.
QString MapsModel::textOf(double value, int column) const {
    const int limit = maxDecimalsOf(column);
    return m_isMoving ? steadyNumber(value, limit) : roundedNumber(value, limit);
}

// The most decimals in a column, of as many rows as a header looks at for its widths: views ask for visible
// cells, and a hundred thousand numbers are not written out.
int MapsModel::decimals(int column) const {
    std::optional<int>& most = m_decimals[static_cast<std::size_t>(column)];
    if (most) return *most;
    most = 0;
    const int limit = maxDecimalsOf(column);
    if (m_isMoving) return *(most = isNumber(column) ? limit : 0);
    std::optional<double> previous;
    for (int row = 0; isNumber(column) && row < std::min(rowCount(), rowsLookedAt); ++row) {
        const std::optional<double> value = number(row, column);
        const bool hasMore = *most < limit || (value && std::abs(*value) < std::pow(10, 2 - *most));
        if (value && hasMore && value != previous) most = std::max(*most, decimalsOf(textOf(*value, column)));
        previous = value;
    }
    return *most;
}

void MapsModel::limitDecimals(int decimals) {
    if (decimals == m_maxDecimals) return;
    m_maxDecimals = decimals;
    std::fill_n(m_decimals.begin(), columnOf(Weight) + 1, std::nullopt);
    if (rowCount() > 0)
        emit dataChanged(index(0, A), index(rowCount() - 1, columnOf(Weight)), {Qt::DisplayRole});
}

int MapsModel::rowCount(const QModelIndex& parent) const {
    if (parent.isValid()) return 0;
    return std::visit([](const auto& shown) { return static_cast<int>(shown.maps.size()); }, m_shown);
}

int MapsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columnOf(EffectiveA) + coefficientCount();
}

ifs::MapId MapsModel::idAt(int row) const {
    if (row < 0 || row >= rowCount()) return ifs::MapId::None;
    return withMap(row, [](const auto& map) { return map.id; });
}

std::vector<int> MapsModel::rowsOf(const std::vector<ifs::MapId>& ids) const {
    QHash<ifs::MapId, int> order; // requested maps, usually far fewer than all
    order.reserve(qsizetype(ids.size()));
    std::vector<int> rows(ids.size(), -1);
    for (int i = 0; i < int(ids.size()); ++i)
        order.insert(ids[std::size_t(i)], i);
    for (int row = 0; row < rowCount(); ++row)
        if (const auto index = order.constFind(idAt(row)); index != order.constEnd())
            rows[std::size_t(*index)] = row;
    std::erase(rows, -1);
    return rows;
}

std::optional<double> MapsModel::number(int row, int column) const {
    const auto at = static_cast<std::size_t>(row);
    const auto [kind, which] = meaningOf(column);
    const auto numberIn = [&, kind = kind,
                           which = which]<int Dim>(const Shown<Dim>& shown) -> std::optional<double> {
        const ifs::WeightedMap<Dim>& map = shown.maps[at];
        switch (kind) {
        case A:
            return ifs::coefficient(m_isMoving ? withoutResidue<Dim>(map.map) : map.map, which);
        case EffectiveA:
            if (const auto effective = shown.display ? effectiveMap(*shown.display, map.map) : std::nullopt)
                return ifs::coefficient(*effective, which);
            return std::nullopt;
        case Weight:
            return map.weight ? *map.weight : m_probabilities[at];
        case Determinant:
            return ifs::determinant<Dim>(map.map.linear);
        case Contraction:
            return ifs::spectralNorm<Dim>(map.map.linear);
        default:
            return std::nullopt;
        }
    };
    return std::visit(numberIn, m_shown);
}

document::MapLabel MapsModel::labelOf(int row) const {
    return m_document->fractal().mapLabels.of(idAt(row));
}

QString MapsModel::title(int row) const {
    return document::mapTitle(m_document->fractal(), std::size_t(row));
}

bool MapsModel::hasNames() const {
    const document::MapLabels& labels = m_document->fractal().mapLabels;
    for (int row = 0; !labels.isEmpty() && row < rowCount(); ++row)
        if (!labels.of(idAt(row)).name.isEmpty()) return true;
    return false;
}

void MapsModel::setSolo(ifs::MapId map) {
    if (std::exchange(m_solo, map) == map || rowCount() == 0) return;
    emit dataChanged(index(0, Enabled), index(rowCount() - 1, Enabled));
}

QString MapsModel::editObstacle(const QModelIndex& index) const {
    if (!index.isValid() || !isEditable(index.column())) return {};
    return document::lockObstacle(m_document->fractal(), document::Rows{index.row()});
}

bool MapsModel::isEnabled(int row) const {
    return withMap(row, [](const auto& map) { return map.enabled; });
}

std::optional<double> MapsModel::weightOf(int row) const {
    return withMap(row, [](const auto& map) { return map.weight; });
}

ifs::MapKind MapsModel::kindOf(int row) const {
    return withMap(row,
                   []<int Dim>(const ifs::WeightedMap<Dim>& map) { return ifs::kind<Dim>(map.map.linear); });
}

QString MapsModel::warning(int row) const {
    if (withMap(row, [](const auto& map) { return contracts(map.map); })) return {};
    return tr("Map %1 does not contract: it stretches by up to %2. The system may still have an "
              "attractor if "
              "longer words contract.")
        .arg(row + 1)
        .arg(shortNumber(*number(row, columnOf(Contraction))));
}

QString MapsModel::remark(const QModelIndex& index) const {
    if (!index.isValid() || meaningOf(index.column()).kind != Weight) return {};
    const double weight = weightOf(index.row()).value_or(0);
    return weight < 0 ? *io::weightRemark(std::size_t(index.row()) + 1, weight) : QString();
}

// Texts about the cells before the code.
QString MapsModel::mark(int row, Column column) const {
    const QString name = title(row);
    switch (column) {
    case Enabled:
        if (m_solo != ifs::MapId::None && m_solo == idAt(row)) return tr("Map %1 is shown alone.").arg(name);
        return isEnabled(row) ? tr("Map %1 is switched on.").arg(name)
                              : tr("Map %1 is switched off.").arg(name);
    case Lock:
        return labelOf(row).isLocked ? tr("Map %1 is locked.").arg(name)
                                     : tr("Map %1 is not locked.").arg(name);
    case Colour:
        return tr("Colour of map %1. Press Space or double-click to change it.").arg(name);
    default:
        break;
    }
    const QString text = labelOf(row).name;
    return text.isEmpty() ? tr("Map %1 has no name. Double-click to name it.").arg(row + 1) : text;
}

QString MapsModel::spoken(int row, Column column) const {
    if (column == Colour)
        return tr("colour %1").arg(data(index(row, Colour), Qt::DecorationRole).value<QColor>().name());
    if (column == Enabled) return isEnabled(row) ? tr("on") : tr("off");
    if (column == Lock) return labelOf(row).isLocked ? tr("locked") : tr("not locked");
    return column == Name && labelOf(row).name.isEmpty() ? tr("no name") : QString();
}

QString MapsModel::tip(int row, int column) const {
    const Column kind = meaningOf(column).kind;
    if (kind < A) return mark(row, kind);
    if (kind == Kind) return kindTip(kindOf(row), dimension());
    const auto value = number(row, column);
    if (!value) return tr("The cage is flat or bent: there is no effective code.");
    if (kind != Weight) return fullNumber(*value);
    const QString probability = shortNumber(m_probabilities[static_cast<std::size_t>(row)]);
    const std::optional<double> weight = weightOf(row);
    if (!weight)
        return tr("No weight is given; the determinant rule gives the probability %1.").arg(probability);
    if (*weight <= 0)
        return tr("Weight %1: a weight that is not positive switches the map off.").arg(fullNumber(*weight));
    return tr("Weight %1, probability %2.").arg(fullNumber(*weight), probability);
}

QVariant MapsModel::alignment(int column) const {
    if (isNumber(column)) return int(Qt::AlignRight | Qt::AlignVCenter);
    return int((meaningOf(column).kind == Kind ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
}

QVariant MapsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {}; // asked by views without a current row
    if (!checkIndex(index, CheckIndexOption::ParentIsInvalid)) return {};
    const int row = index.row();
    const int column = index.column();
    const Column kind = meaningOf(column).kind;
    switch (role) {
    case Qt::DisplayRole:
        if (kind == Name) return labelOf(row).name;
        if (kind == Kind)
            return warning(row).isEmpty() ? kindText(kindOf(row))
                                          : tr("%1, not contracting").arg(kindText(kindOf(row)));
        if (isNumber(column)) {
            const auto value = number(row, column);
            return value ? textOf(*value, column) : QStringLiteral("–");
        }
        return {};
    case Qt::EditRole:
        if (kind == Name) return labelOf(row).name;
        if (const auto value = isNumber(column) ? number(row, column) : std::nullopt) return *value;
        return {};
    case Qt::CheckStateRole:
        if (kind == Enabled) return static_cast<int>(isEnabled(row) ? Qt::Checked : Qt::Unchecked);
        if (kind == Lock) return static_cast<int>(labelOf(row).isLocked ? Qt::Checked : Qt::Unchecked);
        return {};
    case Qt::DecorationRole:
        if (kind == Colour) {
            const auto c = attractor::mapColour(m_document->fractal().appearance, idAt(row), index.row());
            return QColor(c.red, c.green, c.blue, c.alpha);
        }
        return {};
    case Qt::ForegroundRole:
        if (!remark(index).isEmpty()) return problemColour(QGuiApplication::palette());
        if (m_probabilities[static_cast<std::size_t>(row)] <= 0 || (kind == Weight && !weightOf(row)) ||
            kind > Weight || (kind >= A && labelOf(row).isLocked))
            return QGuiApplication::palette().color(QPalette::PlaceholderText);
        return {};
    case Qt::ToolTipRole: {
        const QString wrong = kind == Contraction || kind == Kind ? warning(row) : QString();
        if (!wrong.isEmpty()) return wrong;
        const QString typed = typedText(index), said = tooltipText(tip(row, column));
        return typed.isEmpty() ? said : QStringLiteral("%1 = %2").arg(typed, said);
    }
    case Qt::AccessibleTextRole:
        if (const QString text = spoken(row, kind); !text.isEmpty()) return text;
        return {};
    case Qt::TextAlignmentRole:
        return alignment(column);
    case DecimalsRole:
        return decimals(column);
    case WarningRole:
        return warning(row);
    case LockedRole:
        return labelOf(row).isLocked;
    default:
        return {};
    }
}

QVariant MapsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        if (role == Qt::DisplayRole) return section + 1;
        if (section < 0 || section >= rowCount()) return {};
        QStringList wrongs{warning(section), remark(index(section, columnOf(Weight)))};
        wrongs.removeAll(QString());
        const QString wrong = wrongs.join(u'\n');
        if (role == Qt::ToolTipRole)
            return wrong.isEmpty() ? tooltipText(tr("Map %1. Drag to reorder.").arg(title(section))) : wrong;
        if (role == WarningRole) return wrong;
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
    const bool isCode = isEditable(index.column()) && !labelOf(index.row()).isLocked;
    if (isCode || index.column() == Name) flags |= Qt::ItemIsEditable;
    if (index.column() == Enabled || index.column() == Lock) flags |= Qt::ItemIsUserCheckable;
    return flags;
}

void MapsModel::change(document::Fractal& fractal, const QModelIndex& index, double value,
                       const QString& text) const {
    const auto [kind, which] = meaningOf(index.column());
    const auto row = static_cast<std::size_t>(index.row());
    if (kind == Weight)
        fractal = withWeight(std::move(fractal), index.row(), value);
    else if (document::System2* system = document::system2(fractal))
        setCoefficient(system->maps[row], which, value, text);
    else
        setCoefficient(document::system3(fractal)->maps[row], which, value, text);
}

QString MapsModel::editText(int row, int column, double value) const {
    return tr("Set %1 of map %2 to %3").arg(columnName(column)).arg(row + 1).arg(shortNumber(value));
}

QString MapsModel::placeOf(int row, int column) const {
    return typedPlace(idAt(row), column);
}

void MapsModel::keepTyped(const QModelIndex& index, double value, const QString& text) {
    if (!index.isValid() || !m_edit.isOpen()) return; // an editor may close after its document
    m_edit.preview(editText(index.row(), index.column(), value),
                   [&](document::Fractal& fractal) { change(fractal, index, value, text); });
    m_document->typedNumbers().keep(m_document->currentId(), placeOf(index.row(), index.column()), value,
                                    text);
    emit dataChanged(index, index, {Qt::DisplayRole});
}

QString MapsModel::typedText(const QModelIndex& index) const {
    const auto value = isEditable(index.column()) ? number(index.row(), index.column()) : std::nullopt;
    if (!value) return {};
    const auto [kind, which] = meaningOf(index.column());
    const ifs::TypedCoefficient* typed =
        kind != A ? nullptr : withMap(index.row(), [&, which = which](const auto& map) {
            return map.typed.of(which, *value);
        });
    if (typed) return QString::fromStdString(typed->text);
    const QString place = placeOf(index.row(), index.column());
    return m_document->typedNumbers().text(m_document->currentId(), place, *value);
}

void MapsModel::preview(const QModelIndex& index, double value, int kind) {
    if (!index.isValid() || !isEditable(index.column()) || !editObstacle(index).isEmpty()) return;
    m_edit.preview(
        editText(index.row(), index.column(), value),
        [&](document::Fractal& fractal) { change(fractal, index, value); }, kind);
}

void MapsModel::previewName(const QModelIndex& index, const QString& name) {
    if (!index.isValid() || index.column() != Name) return;
    const QString given = document::mapNameOf(name);
    const ifs::MapId id = idAt(index.row());
    m_edit.preview(given.isEmpty() ? tr("Remove the name of map %1").arg(index.row() + 1)
                                   : tr("Name map %1 “%2”").arg(QString::number(index.row() + 1), given),
                   [&](document::Fractal& fractal) {
                       document::MapLabel label = fractal.mapLabels.of(id);
                       label.name = given;
                       fractal.mapLabels.set(id, std::move(label));
                   });
}

bool MapsModel::switchMap(int row, bool on) {
    document::Fractal fractal = m_document->fractal();
    if (document::System2* system = document::system2(fractal))
        system->maps[std::size_t(row)].enabled = on;
    else
        document::system3(fractal)->maps[std::size_t(row)].enabled = on;
    m_document->edit((on ? tr("Switch map %1 on") : tr("Switch map %1 off")).arg(row + 1),
                     std::move(fractal));
    return true;
}

bool MapsModel::colourMap(int row, const QColor& colour) {
    if (!colour.isValid()) return false;
    document::Fractal fractal = m_document->fractal();
    const auto channel = [](int c) { return static_cast<std::uint8_t>(c); };
    const attractor::Rgba chosen{channel(colour.red()), channel(colour.green()), channel(colour.blue()),
                                 channel(colour.alpha())};
    const ifs::MapId id = idAt(row);
    if (chosen == attractor::mapColour(fractal.appearance, id, std::size_t(row))) return true;
    fractal.appearance.mapColours[id] = chosen;
    m_document->edit(tr("Colour of map %1: %2").arg(row + 1).arg(colour.name()), std::move(fractal));
    return true;
}

bool MapsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
    const bool isOn = value.toInt() == Qt::Checked;
    if (role == Qt::CheckStateRole && index.column() == Enabled) return switchMap(index.row(), isOn);
    if (role == Qt::CheckStateRole && index.column() == Lock) {
        const ifs::MapId id = idAt(index.row());
        document::lockMaps(*m_document, std::span(&id, 1), isOn);
        return true;
    }
    if (role == Qt::DecorationRole && index.column() == Colour)
        return colourMap(index.row(), value.value<QColor>());
    if (role == Qt::EditRole && index.column() == Name) {
        document::renameMap(*m_document, std::size_t(index.row()), value.toString());
        return true;
    }
    if (role != Qt::EditRole || !isEditable(index.column()) || !editObstacle(index).isEmpty()) return false;
    const auto number = value.typeId() == QMetaType::QString ? typedNumber(value.toString())
                                                             : std::optional(value.toDouble());
    if (!number || !std::isfinite(*number)) return false;
    document::Fractal fractal = m_document->fractal();
    change(fractal, index, *number, value.toString());
    m_document->edit(editText(index.row(), index.column(), *number), std::move(fractal));
    return true;
}

} // namespace view
