// SPDX-License-Identifier: MIT
#include "dialogs/export/large_export.h"

#include "dialogs/export/export_dialog.h"
#include "dialogs/export/export_size_editor.h"
#include "support/named.h"
#include "support/named_test.h"

#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

using namespace view;

class LargeExportTest : public QObject {
    Q_OBJECT

private slots:
    void aHugePictureIsAskedAbout();
};

// Before anything is drawn or a name is asked for.
void LargeExportTest::aHugePictureIsAskedAbout() {
    QVERIFY(largeExportSentence({7680, 4320}, 1 << 30).isEmpty());
    QVERIFY(!largeExportSentence({7680, 4320}, std::uint64_t(20) << 30).isEmpty());
    document::Document document;
    attractor::Camera camera;
    camera.width = 160;
    camera.height = 120;
    ExportDialog dialog(&document, camera);
    dialog.show();
    dialog.findChild<ExportSizeEditor*>()->setPixels({99'999, 99'999});
    QString asked;
    QTimer answer;
    int looks = 0;
    connect(&answer, &QTimer::timeout, this, [&] {
        ++looks;
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible()) {
                asked = box->informativeText();
                box->button(QMessageBox::Cancel)->click();
            } else if (auto* files = qobject_cast<QFileDialog*>(widget); files && files->isVisible()) {
                asked = QStringLiteral("a name");
                files->reject();
            }
        }
    });
    answer.start(20);
    support::button(dialog, "export")->click();
    QVERIFY2(asked.contains(QStringLiteral("million pixels")), qPrintable(asked));
    QVERIFY2(asked.contains(QStringLiteral("Memory")), qPrintable(asked));
    const int before = looks;
    QTRY_VERIFY(looks > before + 2); // nothing else is asked
    QVERIFY2(asked.contains(QStringLiteral("million pixels")), qPrintable(asked));
}

BARYCAGE_TEST(LargeExportTest, QApplication);
#include "large_export_test.moc"
