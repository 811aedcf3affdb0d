// SPDX-License-Identifier: MIT
#include "panels/history_panel.h"

#include "icon.h"

#include <QUndoView>
#include <QVBoxLayout>

namespace view {

HistoryPanel::HistoryPanel(document::Document* document, QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("History"));
    auto* steps = new QUndoView(document->undoStack(), this);
    steps->setAccessibleName(tr("Steps of the history"));
    steps->setStatusTip(tr("Choose a step to go back to it, or forward."));
    steps->setToolTip(tr("Choose a step to go back to it, or forward. The disk marks what is saved."));
    steps->setEmptyLabel(tr("As opened"));
    steps->setCleanIcon(icon(QStringLiteral("save")));
    steps->setIconSize({14, 14});
    steps->setSpacing(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(steps);
}

} // namespace view
