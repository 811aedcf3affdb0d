// SPDX-License-Identifier: MIT
#include "widgets/layout/fit_screen.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QLayout>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

// Scrolls contents that do not fit, in one direction only if that is enough.
class Contents : public QScrollArea {
public:
    explicit Contents(QWidget* content) {
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus); // the content's fields take it
        setWidget(content);
    }

    QSize sizeHint() const override { return widget()->sizeHint() + QSize(verticalScrollBar()->width(), 0); }
};

bool hasButtons(QLayoutItem& item) {
    if (item.layout() == nullptr) return qobject_cast<QDialogButtonBox*>(item.widget()) != nullptr;
    for (int i = 0; i < item.layout()->count(); ++i)
        if (hasButtons(*item.layout()->itemAt(i))) return true;
    return false;
}

// Done once: the rest needs hardly any room.
void scrollContents(QDialog& dialog) {
    QLayout* layout = dialog.layout();
    if (dynamic_cast<Contents*>(layout->itemAt(0)->widget())) return;
    QLayoutItem* foot =
        hasButtons(*layout->itemAt(layout->count() - 1)) ? layout->takeAt(layout->count() - 1) : nullptr;
    const QMargins margins = layout->contentsMargins();
    const int spacing = layout->spacing();
    auto* content = new QWidget;
    content->setLayout(layout); // removes it from the dialog
    layout->setContentsMargins({});
    auto* column = new QVBoxLayout(&dialog);
    column->setContentsMargins(margins);
    column->setSpacing(spacing);
    column->addWidget(new Contents(content), 1);
    if (foot == nullptr) return;
    if (foot->layout() == nullptr) return column->addItem(foot);
    foot->layout()->setParent(nullptr);
    column->addLayout(foot->layout());
}

void fit(QDialog& dialog) {
    const QLayout* layout = dialog.layout();
    if (layout == nullptr || layout->count() == 0) return;
    const QSize room = roomOnScreen(dialog);
    QSize needed = layout->totalMinimumSize();
    const int width = std::clamp(dialog.width(), std::min(needed.width(), room.width()), room.width());
    if (layout->hasHeightForWidth()) needed.setHeight(layout->totalMinimumHeightForWidth(width));
    if (needed.width() > room.width() || needed.height() > room.height()) {
        scrollContents(dialog);
        if (dialog.minimumWidth() > room.width()) dialog.setMinimumWidth(0);
    }
    // Includes the minimum set for the title, which lets the window be narrower than its contents.
    const QSize wanted(width, std::min(dialog.height(), room.height()));
    if (dialog.size() != wanted) dialog.resize(wanted);
}

// A window manager that puts a dialog of the screen's height at its top hides the title bar, by which people
// move it.
void showTitleBar(QDialog& dialog) {
    const QRect frame = dialog.frameGeometry(), room = dialog.screen()->availableGeometry();
    const QPoint inside(std::max(frame.left(), room.left()), std::max(frame.top(), room.top()));
    if (frame.top() < room.top()) dialog.move(inside);
}

} // namespace

QSize roomOnScreen(const QWidget& window) {
    constexpr double highest = 1.5; // ratio of a desktop's title bar to the style's
    const int titleBar =
        int(highest * window.style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, &window));
    const QSize frame = window.frameGeometry().size() - window.size(); // unknown before the window is shown
    return window.screen()->availableSize() - frame.expandedTo({0, titleBar});
}

FitScreen::FitScreen(QCoreApplication* application) : QObject(application) {
    application->installEventFilter(this);
}

bool FitScreen::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::Show && type != QEvent::LayoutRequest && type != QEvent::WindowActivate) return false;
    auto* dialog = qobject_cast<QDialog*>(watched);
    const bool isOwn = dialog && dialog->isWindow() && !qobject_cast<QMessageBox*>(dialog);
    if (isOwn && type == QEvent::WindowActivate) // its frame is known by then
        showTitleBar(*dialog);
    else if (isOwn && (type == QEvent::Show || dialog->isVisible()))
        fit(*dialog);
    return false;
}

} // namespace view
