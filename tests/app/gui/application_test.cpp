// SPDX-License-Identifier: MIT
#include "application.h"
#include "support/named_test.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

class ApplicationTest : public QObject {
    Q_OBJECT

private slots:
    void aDialogHasRoomForItsTitle();
    void aLongTitleIsCut();
    void fieldsLeaveCommandsTheirKeys();
};

namespace {

int widthWithTitle(const QString& title) {
    QDialog dialog;
    dialog.setWindowTitle(title);
    (new QVBoxLayout(&dialog))->addWidget(new QLabel(QStringLiteral("x")));
    dialog.show();
    return dialog.width();
}

} // namespace

void ApplicationTest::aDialogHasRoomForItsTitle() {
    const QString title = QStringLiteral("Export the Animation “Fern”");
    QVERIFY(widthWithTitle(title) > QFontMetrics(QApplication::font()).horizontalAdvance(title));
}

void ApplicationTest::aLongTitleIsCut() {
    QVERIFY(widthWithTitle(QString(2000, u'W')) < 1000);
}

void ApplicationTest::fieldsLeaveCommandsTheirKeys() {
    QWidget window;
    auto* field = new QLineEdit(&window);
    QAction action;
    action.setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
    window.addAction(&action);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    field->setFocus();
    QSignalSpy triggered(&action, &QAction::triggered);
    QTest::keyClick(field, Qt::Key_E, Qt::ControlModifier);
    QCOMPARE(triggered.count(), 1);
}

BARYCAGE_TEST(ApplicationTest, Application);

#include "application_test.moc"
