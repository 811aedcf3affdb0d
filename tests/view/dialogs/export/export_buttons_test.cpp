// SPDX-License-Identifier: MIT
#include "dialogs/export/export_dialog.h"

#include "document/document.h"
#include "support/named_test.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using view::ExportDialog;

// The buttons of all dialogs that export.
class ExportButtonsTest : public QObject {
    Q_OBJECT

private slots:
    // The focus must not go to a button beside Export, which is disabled for a while.
    void returnExportsAgain() {
        document::Document document;
        ExportDialog dialog(&document, camera());
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        auto* start = dialog.findChild<QPushButton*>(QStringLiteral("export"));
        start->setFocus();
        QSignalSpy exported(&dialog, &ExportDialog::exported);
        dialog.exportTo(m_folder.filePath(QStringLiteral("again.png")));
        QVERIFY(!dialog.focusWidget());
        const QRect place = start->geometry();
        QVERIFY(exported.wait(20'000));
        QCOMPARE(dialog.focusWidget(), start);
        QCoreApplication::processEvents();
        QCOMPARE(start->geometry(), place); // under the pointer
    }

private:
    attractor::Camera camera() const {
        attractor::Camera view;
        view.width = 160;
        view.height = 120;
        return fitted(view, {0, 0}, {1, 0.9});
    }
    QTemporaryDir m_folder;
};

BARYCAGE_TEST(ExportButtonsTest, QApplication);
#include "export_buttons_test.moc"
