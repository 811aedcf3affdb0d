// SPDX-License-Identifier: MIT
#include "panels/history/history_panel.h"

#include "widgets/icon.h"

#include <QStyledItemDelegate>
#include <QUndoView>
#include <QVBoxLayout>

namespace view {

namespace {

// Steps that have been undone are dimmed.
class StepDelegate : public QStyledItemDelegate {
public:
    StepDelegate(const QUndoStack* stack, QObject* parent) : QStyledItemDelegate(parent), m_stack(stack) {}

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.row() > m_stack->index()) // row 0 is the state before all steps
            option->palette.setColor(QPalette::Text,
                                     option->palette.color(QPalette::Disabled, QPalette::Text));
    }

private:
    const QUndoStack* m_stack;
};

} // namespace

HistoryPanel::HistoryPanel(document::Document* document, QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("History"));
    auto* steps = new QUndoView(document->undoStack(), this);
    steps->setAccessibleName(tr("Steps of the history"));
    steps->setStatusTip(tr("Select a step to go back or forward to it."));
    steps->setToolTip(tr("Select a step to go back or forward to it. The disk marks the saved state."));
    steps->setEmptyLabel(tr("As opened"));
    steps->setCleanIcon(icon(QStringLiteral("save")));
    steps->setIconSize({14, 14});
    steps->setSpacing(1);
    steps->setItemDelegate(new StepDelegate(document->undoStack(), steps));
    connect(document->undoStack(), &QUndoStack::indexChanged, steps->viewport(),
            qOverload<>(&QWidget::update));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(steps);
}

} // namespace view
