// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal_geometry.h"
#include "main_window.h"
#include "support/events.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "support/place_on_x.h"
#include "support/watchdog.h"
#include "support/x_input.h"
#include "widgets/choices.h"

#include <QApplication>
#include <QPointer>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

class QAbstractItemView;
class QDialog;
class QMenu;
class QModelIndex;

namespace view {
struct CanvasPart;
}

namespace support {

// Counts the presses of keys that reach the program, those too by which the server repeats a key that is
// held.
class KeyPresses : public QObject {
    Q_OBJECT

public:
    KeyPresses() { qApp->installEventFilter(this); }
    int count() const { return m_count; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    int m_count = 0;
    std::optional<quint64> m_last; // when it was; several objects are told of one press
};

// Waits until `condition` is true, in an event loop, as the program itself waits. False after a time limit.
bool waitFor(const std::function<bool()>& condition);

// A window of the program on a real X server and the input for it, for tests to derive from. Each test
// function has a fresh window with the maple and fails if an event occupied the thread of the window for too
// long.
class WindowOnX : public QObject {
    Q_OBJECT

protected:
    void openWindow();  // skips the test where there is no X server
    void closeWindow(); // discards unsaved work; reports late events

    MainWindow& window() const { return *m_window; }
    view::CanvasView& canvas() const;
    XInput& hand() const { return *m_hand; }
    document::Document& document() const { return m_window->document(); }
    const document::Fractal& fractal() const { return document().fractal(); }
    const document::System2& code() const { return *document::system2(fractal()); }
    ifs::ControlCage<2> cage() const { return document::effectiveCage(fractal()); }
    std::vector<ifs::Vector<2>> vertices() const { return cage().current; }
    int steps() const { return document().undoStack()->count(); }

    QPoint onScreen(const ifs::Vector<2>& world) const;
    QPoint handle(const view::CanvasPart& part) const;
    QPoint vertex(int index) const; // on the screen
    QPoint insideTheCage() const { return (vertex(0) * 2 + vertex(1) * 3 + vertex(2) * 4) / 9; }
    double pixelsPerUnit() const;
    // How far the way from `before` to `after` in the plane is from `by` on the screen.
    double offsetInPixels(const ifs::Vector<2>& after, const ifs::Vector<2>& before, const QPoint& by) const;
    QPoint onCanvas(const QPoint& pixel) const { return canvas().viewport()->mapToGlobal(pixel); }
    QString folder() const { return m_folder.path(); } // for what the test writes
    QPoint middleOf(const QWidget* widget) const { return widget->mapToGlobal(widget->rect().center()); }

    // The collection `name` of the program in a file of its own that can be written.
    QString copyOfCollection(const QString& name);
    document::Fractal savedEntry(const QString& path) const; // the current entry as it is in the file

    void dragBy(const QPoint& start, const QPoint& by);
    void zoomOut(int notches); // of the wheel, at the middle of the canvas
    void click(const QWidget* widget) { hand().clickAt(middleOf(widget)); }
    void clickOn(QAbstractItemView* list, const QModelIndex& index); // scrolls to it first
    void type(QWidget* field, const QString& text);                  // instead of what is in it, then Tab
    template <class Value> void pick(QComboBox* box, const Value& value) {
        pickRow(box, box->findData(view::choiceData(value)));
    }
    QAction* chooseFrom(const QMenu* menu, const QString& name);      // that opens; names without "&"
    void showPanel(const QString& title);                             // by its tab
    QDialog* openDialog(const char* shortcut, const char* className); // null when none appears

    // Opens the menus one by one with the pointer and clicks the last name. Names without "&".
    void choose(const QStringList& path);

    // Does `open` and, when a dialog of this kind has appeared, in whatever event loop, `use`, which is to
    // close it. False when it did not appear or stayed.
    template <typename Dialog>
    bool answer(const std::function<void()>& open, const std::function<void(Dialog&)>& use) {
        bool met = false;
        bool gone = false;
        QTimer poll;
        QRect place; // where it was before: the window manager may still move it
        QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
            auto* found = visible<Dialog>();
            if (!found || met || !isInPlace(found)) return;
            if (std::exchange(place, found->geometry()) != found->geometry()) return;
            met = true;
            watchdog().ignoreThisEvent(); // it holds the work of the test
            const QPointer<Dialog> dialog = found;
            use(*dialog);
            gone = waitFor([&] { return !dialog || !dialog->isVisible(); });
            if (!gone) dialog->close();
        });
        poll.start(30);
        waitFor([] { // keys go where they are meant to
            const QWidget* active = QApplication::activeWindow();
            return active ? isInPlace(active) : !visible<QWidget>();
        });
        open();
        waitFor([&] { return met; });
        return met && waitFor([&] { return gone; });
    }
    template <typename Widget> static Widget* visible() {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* found = qobject_cast<Widget*>(widget); found && found->isVisible()) return found;
        return nullptr;
    }
    // The part of a dialog that has this accessible name or, of buttons, this text without "&"; waits until
    // it is to be seen, and ends the test program when it never is.
    template <typename Widget> static Widget* named(const QWidget& parent, const QString& name) {
        Widget* found = nullptr;
        waitFor([&] {
            for (auto* child : parent.findChildren<Widget*>()) {
                const QString text = child->property("text").toString().remove(u'&');
                if (!child->isVisible() || (child->accessibleName() != name && text != name)) continue;
                found = child;
                return true;
            }
            return false;
        });
        if (!found) qFatal("nothing is called %s", qPrintable(name));
        return found;
    }

    static WatchedApplication& watchdog() { return *static_cast<WatchedApplication*>(qApp); }
    void photograph(const QString& name) const; // of the screen, into the folder that BARYCAGE_KEEP names

private:
    void pickRow(QComboBox* box, int row);

    QPointer<MainWindow> m_window;
    std::unique_ptr<XInput> m_hand;
    QTemporaryDir m_folder;
};

// Names, and so settings and folders, away from the user's; of tests and of the programs that they start.
void useTestFolders();

int runOnX(QObject& test, int& argc, char** argv);

template <class Test> int runOnX(int argc, char** argv) {
    Test test;
    return runOnX(test, argc, argv);
}

} // namespace support

/// BARYCAGE_TEST() of a class that derives from WindowOnX.
#define BARYCAGE_TEST_ON_X(Class) BARYCAGE_NAMED_TEST(__COUNTER__, support::runOnX<Class>)
