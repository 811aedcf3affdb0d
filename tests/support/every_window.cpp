// SPDX-License-Identifier: MIT
#include "support/every_window.h"

#include "canvas/tools/vertex_dialog.h"
#include "support/events.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>
#include <QUndoStack>

namespace support {

namespace {

QList<QAction*> leaves(const QWidget* menu) {
    QList<QAction*> found;
    for (QAction* action : menu->actions()) {
        if (action->menu())
            found += leaves(action->menu());
        else if (!action->isSeparator())
            found << action;
    }
    return found;
}

// Dialogs of the system, and what ends the program.
bool isLeftOut(const QAction* action) {
    const QKeySequence key = action->shortcut();
    for (const auto standard : {QKeySequence::Open, QKeySequence::Print, QKeySequence::Close,
                                QKeySequence::Quit, QKeySequence::WhatsThis})
        if (QKeySequence::keyBindings(standard).contains(key)) return true;
    return key == QKeySequence(QStringLiteral("Ctrl+Shift+S")) ||
           action->objectName() == QStringLiteral("save-for-other-programs") ||
           action->objectName() == QStringLiteral("export-web-page");
}

} // namespace

EveryWindow::EveryWindow(const QString& path) : m_main(new MainWindow) {
    m_main->setAttribute(Qt::WA_DeleteOnClose, false);
    m_main->resize(1400, 900);
    if (path.isEmpty())
        m_main->openFirstPicture();
    else if (!m_main->openPath(path))
        qFatal("not opened: %s", qPrintable(path));
    m_main->show();
    if (!QTest::qWaitForWindowExposed(m_main)) qFatal("the window does not appear");
    handleEvents();
    for (QAction* action : leaves(m_main->menuBar())) {
        // “…” and the last item of Help open something; so do some others.
        const bool opens = action->text().contains(u'…') || action->menuRole() == QAction::AboutRole ||
                           action->shortcut() == QKeySequence(QKeySequence::HelpContents);
        if (!opens || isLeftOut(action)) continue;
        const QWidgetList before = QApplication::topLevelWidgets();
        action->trigger();
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (!before.contains(widget) && widget->isVisible() && !qobject_cast<QMenu*>(widget)) {
                m_dialogs << widget;
                // The next one is not to be kept waiting by this.
                if (widget->isModal()) {
                    widget->setAttribute(Qt::WA_DeleteOnClose, false);
                    widget->hide();
                }
            }
    }
    m_dialogs << new view::VertexDialog(&m_main->document(), 0, m_main);
}

EveryWindow::~EveryWindow() {
    for (const auto& dialog : m_dialogs)
        delete dialog.data();
    m_main->document().undoStack()->setClean();
    delete m_main;
}

QList<QWidget*> EveryWindow::all() const {
    QList<QWidget*> windows{m_main};
    for (const auto& dialog : m_dialogs)
        if (dialog) windows << dialog;
    return windows;
}

QList<QWidget*> EveryWindow::controls(const QWidget* window) {
    QList<QWidget*> found;
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        const bool inner = widget->objectName().startsWith(u"qt_") || qobject_cast<QScrollBar*>(widget) ||
                           qobject_cast<QHeaderView*>(widget) || qobject_cast<QMenu*>(widget) ||
                           qobject_cast<QMenuBar*>(widget) || qobject_cast<QTabBar*>(widget) ||
                           qobject_cast<QTabBar*>(widget->parentWidget()) ||
                           qobject_cast<QAbstractScrollArea*>(widget->parentWidget()) ||
                           qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) ||
                           qobject_cast<QComboBox*>(widget->parentWidget()) ||
                           widget->window()->inherits("QComboBoxPrivateContainer") ||
                           (widget->isWindow() && widget != window) || widget->window() != window;
        if (inner) continue;
        if (qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
            qobject_cast<QLineEdit*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
            qobject_cast<QAbstractSlider*>(widget) || qobject_cast<QAbstractItemView*>(widget) ||
            (widget->focusPolicy() & Qt::TabFocus))
            found << widget;
    }
    return found;
}

QString EveryWindow::describe(const QWidget* widget) {
    QStringList path;
    for (const QWidget* at = widget; at; at = at->parentWidget()) {
        QString name = QString::fromLatin1(at->metaObject()->className());
        const QString said =
            at->accessibleName().isEmpty() ? at->property("text").toString() : at->accessibleName();
        if (!said.isEmpty()) name += QStringLiteral(" “%1”").arg(said);
        if (name != QLatin1String("QWidget")) path.prepend(name);
        if (at->isWindow()) break;
    }
    return path.join(QStringLiteral(" › "));
}

} // namespace support
