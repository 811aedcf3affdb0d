// SPDX-License-Identifier: MIT
#include "panels/links/links_model.h"

#include "attractor/request/appearance.h"
#include "document/edits/maps/link_edits.h"
#include "widgets/numbers/number_text.h"

#include <QGuiApplication>
#include <QPalette>

namespace view {

namespace {

QString stateText(ifs::LinkState state) {
    switch (state) {
    case ifs::LinkState::Off:
        return LinksModel::tr("Switched off");
    case ifs::LinkState::Ends:
        return LinksModel::tr("Ends: every sequence from here stops");
    case ifs::LinkState::Unreached:
        return LinksModel::tr("Unreached: no map leads to it");
    case ifs::LinkState::Left:
        return LinksModel::tr("Transient: the chaos game never returns");
    case ifs::LinkState::TakesPart:
        break;
    }
    return LinksModel::tr("Takes part");
}

} // namespace

LinksModel::LinksModel(document::Document* document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (change.parts & (Change::System | Change::Appearance | Change::Current | Change::File)) reload();
    });
    reload();
}

void LinksModel::reload() {
    const document::Fractal& fractal = m_document->fractal();
    std::vector<double> matrix;
    std::vector<ifs::LinkState> states;
    if (document::linkObstacle(fractal).isEmpty()) {
        matrix = ifs::linkMatrix(*document::system2(fractal));
        states = ifs::linkStates(*document::system2(fractal));
    }
    if (states.size() == m_states.size()) { // keeps editors and the selection
        m_matrix = std::move(matrix);
        m_states = std::move(states);
        if (!m_states.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
        return;
    }
    beginResetModel();
    m_matrix = std::move(matrix);
    m_states = std::move(states);
    endResetModel();
}

int LinksModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_states.size());
}

int LinksModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || m_states.empty() ? 0 : int(m_states.size()) + 1;
}

QString LinksModel::reason(int map) const {
    return stateText(state(map));
}

QColor LinksModel::colour(int map) const {
    const document::Fractal& fractal = m_document->fractal();
    const auto c = attractor::mapColour(
        fractal.appearance, document::system2(fractal)->maps[std::size_t(map)].id, std::size_t(map));
    return {c.red, c.green, c.blue};
}

QVariant LinksModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const ifs::LinkState state = m_states[std::size_t(index.row())];
    if (isState(index.column())) {
        if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return stateText(state);
        if (role == Qt::ForegroundRole && state != ifs::LinkState::TakesPart)
            return QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text);
        return {};
    }
    switch (role) {
    case Qt::DisplayRole:
        return shortNumber(weight(index));
    case Qt::EditRole:
        return fullNumber(weight(index));
    case Qt::TextAlignmentRole:
        return int(Qt::AlignCenter);
    case Qt::ForegroundRole:
        return weight(index) > 0
                   ? QVariant()
                   : QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
    case Qt::ToolTipRole:
        return weight(index) > 0 ? tr("Directly after map %1, map %2 has %3 times its weight.")
                                       .arg(index.row() + 1)
                                       .arg(index.column() + 1)
                                       .arg(fullNumber(weight(index)))
                                 : tr("Map %2 is never applied directly after map %1.")
                                       .arg(index.row() + 1)
                                       .arg(index.column() + 1);
    case Qt::AccessibleTextRole:
        return tr("From map %1 to map %2: %3")
            .arg(index.row() + 1)
            .arg(index.column() + 1)
            .arg(fullNumber(weight(index)));
    default:
        return {};
    }
}

bool LinksModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::EditRole || isState(index.column()))
        return false;
    const QString text = value.toString();
    if (const QString problem = numberProblem(text, {0.0, {}}); !problem.isEmpty()) {
        emit refused(problem);
        return false;
    }
    setWeight(index.row(), index.column(), *typedNumber(text));
    return true;
}

void LinksModel::setWeight(int from, int to, double weight) {
    if (weight == this->weight(from, to)) return;
    const QString text = weight > 0 ? tr("Link map %1 to map %2") : tr("Unlink map %1 from map %2");
    m_document->edit(weight > 0 ? text.arg(from + 1).arg(to + 1) : text.arg(to + 1).arg(from + 1),
                     document::withLink(m_document->fractal(), from, to, weight));
}

void LinksModel::forbid(const QModelIndexList& cells) {
    QModelIndexList links;
    for (const QModelIndex& cell : cells)
        if (cell.isValid() && !isState(cell.column()) && weight(cell) > 0) links << cell;
    if (links.size() == 1) return setWeight(links.front().row(), links.front().column(), 0);
    if (links.isEmpty()) return;
    document::Fractal fractal = m_document->fractal();
    for (const QModelIndex& link : links)
        fractal = document::withLink(std::move(fractal), link.row(), link.column(), 0);
    m_document->edit(tr("Remove %n link(s)", nullptr, int(links.size())), std::move(fractal));
}

QVariant LinksModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const bool isLast = orientation == Qt::Horizontal && isState(section);
    if (role == Qt::DisplayRole) return isLast ? tr("In the chaos game") : QString::number(section + 1);
    if (role != Qt::ToolTipRole) return {};
    if (isLast) return tr("Whether the chaos game keeps applying the map, or why not");
    return orientation == Qt::Horizontal ? tr("To map %1").arg(section + 1)
                                         : tr("From map %1").arg(section + 1);
}

Qt::ItemFlags LinksModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags shown = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return isState(index.column()) ? shown : shown | Qt::ItemIsEditable;
}

} // namespace view
