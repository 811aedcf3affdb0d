// SPDX-License-Identifier: MIT
#include "application.h"
#include "document/fractal/fractal.h"
#include "io/exchange/entry_link.h"
#include "main_window.h"
#include "session/session.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/paths.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDropEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <new>

class ApplicationTest : public QObject {
    Q_OBJECT

private slots:
    void aDialogHasRoomForItsTitle();
    void aLongTitleIsCut();
    void fieldsLeaveCommandsTheirKeys();
    void aLetterAnswersNoQuestion();
    void theWheelNeedsTheFocus();
    void manyFilesAreAskedAboutAtTheStart();
    void linksAndAddressesAreOpenedAtTheStart();
    void aDamagedLinkIsSaidAtTheStart();
    void filesAreNotMovedIntoTexts();
    void anEventWithoutMemoryIsSaid_data();
    void anEventWithoutMemoryIsSaid();
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

void ApplicationTest::manyFilesAreAskedAboutAtTheStart() {
    support::useOwnSettings();
    QStringList paths;
    for (int i = 0; i < 12; ++i)
        paths << support::testData(QStringLiteral("shapes.ifs"));
    int asked = 0;
    QTimer answering;
    connect(&answering, &QTimer::timeout, &answering, [&asked] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box || box->findChild<QPushButton*>(QStringLiteral("all")) == nullptr) return;
        ++asked;
        box->reject();
    });
    answering.start(10);
    QVERIFY(static_cast<Application*>(qApp)->openWindows(paths));
    QCOMPARE(asked, 1);
    QCOMPARE(session::windows().size(), 1);
    QVERIFY(session::windows().first()->path().isEmpty());
    delete session::windows().first();
}

// As a desktop passes them.
void ApplicationTest::linksAndAddressesAreOpenedAtTheStart() {
    support::useOwnSettings();
    document::Fractal fern = document::sierpinskiTriangle();
    fern.name = QStringLiteral("Ärger & Co");
    const io::WrittenLink written = io::linkOf(fern);
    QVERIFY(!written.failure);
    const QString file = support::testData(QStringLiteral("shapes.ifs"));
    QVERIFY(static_cast<Application*>(qApp)->openWindows(
        {QString::fromUtf8(written.link), QUrl::fromLocalFile(file).toString(QUrl::FullyEncoded)}));
    QStringList paths, names;
    for (SessionWindow* window : session::windows()) {
        paths << window->path();
        names << static_cast<MainWindow*>(window)->document().entryFractal().name;
    }
    paths.sort();
    QCOMPARE(paths, QStringList({QString(), file}));
    QVERIFY2(names.contains(QStringLiteral("Ärger_&_Co")),
             qPrintable(names.join(u'|'))); // as .ifs text holds it
    for (SessionWindow* window : session::windows())
        delete window;
}

void ApplicationTest::aDamagedLinkIsSaidAtTheStart() {
    support::useOwnSettings();
    QVERIFY(static_cast<Application*>(qApp)->openWindows({QStringLiteral("barycage:AAAA")}));
    QCOMPARE(session::windows().size(), 1);
    SessionWindow* window = session::windows().first();
    QVERIFY(window->path().isEmpty());
    const auto boxes = window->findChildren<QMessageBox*>();
    QCOMPARE(boxes.size(), 1);
    QVERIFY(!boxes.front()->informativeText().isEmpty()); // why
    delete window;
}

// Texts take what is moved to them, and a file manager would delete the file.
void ApplicationTest::filesAreNotMovedIntoTexts() {
    QPlainTextEdit text;
    text.show();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QStringLiteral("/somewhere/a.ifs"))});
    data.setText(QStringLiteral("/somewhere/a.ifs"));
    const Qt::DropActions offered = Qt::CopyAction | Qt::MoveAction;
    const QPoint middle = text.viewport()->rect().center();
    QDragEnterEvent enter(middle, offered, &data, Qt::LeftButton, Qt::ShiftModifier);
    QDragMoveEvent move(middle, offered, &data, Qt::LeftButton, Qt::ShiftModifier);
    QDropEvent drop(middle, offered, &data, Qt::LeftButton, Qt::ShiftModifier);
    for (QDropEvent* event : {static_cast<QDropEvent*>(&enter), static_cast<QDropEvent*>(&move), &drop}) {
        event->setDropAction(Qt::MoveAction);
        QApplication::sendEvent(text.viewport(), event);
        QVERIFY(event->isAccepted());
        QCOMPARE(event->dropAction(), Qt::CopyAction);
    }
    QVERIFY(text.toPlainText().contains(QStringLiteral("a.ifs")));
}

void ApplicationTest::anEventWithoutMemoryIsSaid_data() {
    QTest::addColumn<QByteArray>("event");
    for (const char* event : {"timer", "posted call", "key", "event"})
        QTest::newRow(event) << QByteArray(event);
}

// The windows there are go on, and the next event is no worse off.
void ApplicationTest::anEventWithoutMemoryIsSaid() {
    QFETCH(const QByteArray, event);
    class Greedy : public QWidget { // all its events of two kinds fail
        bool event(QEvent* event) override {
            if (event->type() == QEvent::User || event->type() == QEvent::KeyPress) fail();
            return QWidget::event(event);
        }

    public:
        [[noreturn]] static void fail() { throw std::bad_alloc(); }
    } window;
    window.show();
    const auto boxes = [] {
        QList<QMessageBox*> shown;
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible()) shown << box;
        return shown;
    };
    for (int i = 0; i < 2; ++i) {
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        if (event == "timer")
            QTimer::singleShot(0, &window, &Greedy::fail);
        else if (event == "posted call")
            QMetaObject::invokeMethod(&window, &Greedy::fail, Qt::QueuedConnection);
        else if (event == "key")
            for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease})
                QApplication::postEvent(&window, new QKeyEvent(type, Qt::Key_A, Qt::NoModifier));
        else
            QApplication::postEvent(&window, new QEvent(QEvent::User));
        QTRY_COMPARE(boxes().size(), 1);
        QVERIFY2(boxes().first()->text().contains(QStringLiteral("not enough memory")),
                 qPrintable(boxes().first()->text()));
        boxes().first()->accept();
        QTRY_VERIFY(boxes().isEmpty());
    }
    QVERIFY(window.isVisible());
}

BARYCAGE_TEST(ApplicationTest, Application);

#include "application_test.moc"
