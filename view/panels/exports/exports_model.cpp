// SPDX-License-Identifier: MIT
#include "panels/exports/exports_model.h"

#include "widgets/text/tooltip_text.h"

#include <QDir>
#include <QFileInfo>

#include <cmath>

namespace view {

namespace {

using State = QueuedExport::State;

// Rounded up, so that it does not end early.
QString timeText(qint64 milliseconds) {
    const qint64 seconds = (milliseconds + 999) / 1000;
    if (seconds < 90) return ExportsModel::tr("about %n second(s) left", nullptr, int(seconds));
    const qint64 minutes = (seconds + 59) / 60;
    if (minutes < 90) return ExportsModel::tr("about %n minute(s) left", nullptr, int(minutes));
    return ExportsModel::tr("about %n hour(s) left", nullptr, int((minutes + 59) / 60));
}

} // namespace

ExportsModel::ExportsModel(ExportQueue* queue, QObject* parent) : QAbstractListModel(parent), m_queue(queue) {
    connect(queue, &ExportQueue::listChanged, this, [this] {
        beginResetModel();
        endResetModel();
    });
    connect(queue, &ExportQueue::exportChanged, this,
            [this](int row) { emit dataChanged(index(row), index(row)); });
    connect(queue, &ExportQueue::pausedChanged, this, [this] {
        if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
    });
}

int ExportsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_queue->exports().size());
}

QString ExportsModel::sentence(const QueuedExport& one) const {
    const int percent = int(std::floor(100 * one.progress));
    switch (one.state) {
    case State::Waiting:
        return m_queue->isPaused() ? tr("Paused") : tr("Waiting");
    case State::Failed:
        return one.task.failure;
    case State::Done:
        return tr("Done");
    case State::Drawing:
        break;
    }
    if (m_queue->isPaused()) return tr("Paused at %1 %").arg(percent);
    if (!one.millisecondsLeft) return tr("%1 %").arg(percent);
    return tr("%1 %, %2", "how much is done, time left").arg(percent).arg(timeText(*one.millisecondsLeft));
}

QVariant ExportsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const QueuedExport& one = m_queue->exports()[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return QFileInfo(one.task.path).fileName();
    case Qt::ToolTipRole:
        return tooltipText(QDir::toNativeSeparators(one.task.path) + u'\n' + sentence(one));
    case Qt::AccessibleTextRole:
        return tr("%1: %2", "file, how far it is").arg(QFileInfo(one.task.path).fileName(), sentence(one));
    case IdRole:
        return one.id;
    case StateRole:
        return int(one.state);
    case SentenceRole:
        return sentence(one);
    case ProgressRole:
        return one.state == State::Drawing ? QVariant(one.progress) : QVariant();
    case PathRole:
        return one.task.path;
    default:
        return {};
    }
}

} // namespace view
