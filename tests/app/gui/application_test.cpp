// SPDX-License-Identifier: MIT
#include "application.h"
#include "support/named_test.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

class ApplicationTest : public QObject {
    Q_OBJECT

private slots:
    void aDialogHasRoomForItsTitle();
    void aLongTitleIsCut();
    void fieldsLeaveCommandsTheirKeys();
    void aLetterAnswersNoQuestion();
    void theWheelNeedsTheFocus();
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

// It may be meant for the field behind it. With Alt it is meant.
void ApplicationTest::aLetterAnswersNoQuestion() {
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Unsaved"), QStringLiteral("Save?"),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    box.button(QMessageBox::Save)->setText(QStringLiteral("&Save"));
    box.button(QMessageBox::Discard)->setText(QStringLiteral("&Discard"));
    box.open();
    QVERIFY(QTest::qWaitForWindowActive(&box));
    QSignalSpy clicked(&box, &QMessageBox::buttonClicked);
    for (const int key : {Qt::Key_S, Qt::Key_D})
        for (const auto modifier : {Qt::NoModifier, Qt::ShiftModifier}) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key(key), modifier);
            for (const QAbstractButton* button : box.buttons())
                QVERIFY(!button->isDown());
        }
    QVERIFY(clicked.isEmpty());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_D, Qt::AltModifier);
    QTRY_COMPARE(clicked.count(), 1);
    QCOMPARE(box.clickedButton(), box.button(QMessageBox::Discard));
}

// Of lists and sliders of every window.
void ApplicationTest::theWheelNeedsTheFocus() {
    QWidget window;
    auto* layout = new QVBoxLayout(&window);
    auto* field = new QLineEdit;
    auto* list = new QComboBox;
    list->addItems({QStringLiteral("a"), QStringLiteral("b")});
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setValue(50);
    for (QWidget* widget : QList<QWidget*>{field, list, slider})
        layout->addWidget(widget);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const auto turn = [](QWidget* widget) {
        const QPointF middle = QRectF(widget->rect()).center();
        QWheelEvent event(middle, widget->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        qApp->notify(widget, &event);
    };
    field->setFocus();
    turn(list);
    turn(slider);
    QCOMPARE(list->currentIndex(), 0);
    QCOMPARE(slider->value(), 50);
    list->setFocus();
    turn(list);
    QCOMPARE(list->currentIndex(), 1);
    slider->setFocus();
    turn(slider);
    QVERIFY(slider->value() < 50);
}

BARYCAGE_TEST(ApplicationTest, Application);

#include "application_test.moc"
