// SPDX-License-Identifier: MIT
#include "support/events.h"
#include "support/every_window.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QApplication>
#include <QComboBox>
#include <QList>
#include <QPointer>
#include <QTest>

using support::EveryWindow;

// In the window and all its dialogs, Esc closes the list that is open, and nothing else.
class OpenListsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void escClosesTheList();
};

void OpenListsTest::escClosesTheList() {
    const EveryWindow windows;
    QList<QPointer<QWidget>> all{&windows.main()};
    all += windows.dialogs();
    int tried = 0;
    for (const QPointer<QWidget>& window : all) {
        if (!window) continue;
        window->setWindowModality(Qt::NonModal);
        window->show();
        support::handleEvents();
        QList<QPointer<QComboBox>> lists; // handling events may replace some
        for (QComboBox* list : window->findChildren<QComboBox*>())
            lists << list;
        for (const QPointer<QComboBox>& list : lists) {
            if (!list || !list->isVisible() || !list->isEnabled() || list->count() == 0) continue;
            const QString where = EveryWindow::describe(list);
            list->showPopup();
            QTRY_VERIFY2(QApplication::activePopupWidget(), qPrintable(where));
            QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
            QTRY_VERIFY2(!QApplication::activePopupWidget(), qPrintable(where));
            support::handleEvents();
            QVERIFY2(window && window->isVisible(), qPrintable(where));
            ++tried;
        }
        if (window != &windows.main()) window->hide();
    }
    QVERIFY2(tried > 20, qPrintable(QString::number(tried)));
}

BARYCAGE_TEST(OpenListsTest, QApplication);
#include "open_lists_test.moc"
