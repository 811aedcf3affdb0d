// SPDX-License-Identifier: MIT
#include "support/x_input.h"

#include <QEventLoop>
#include <QGuiApplication>
#include <QHash>
#include <QTimer>

// After Qt: these headers define words like None and Bool.
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>

namespace support {

namespace {

QByteArray fullName(const QByteArray& key) {
    if (key == "Control" || key == "Shift" || key == "Alt") return key + "_L";
    return key;
}

// The key of a character and whether it takes Shift, on an English keyboard.
QByteArray keyOf(QChar character, bool& shift) {
    static const QHash<char, QByteArray> names{{' ', "space"}, {'.', "period"},     {'-', "minus"},
                                               {'/', "slash"}, {'_', "underscore"}, {':', "colon"},
                                               {'+', "plus"},  {'(', "parenleft"},  {')', "parenright"},
                                               {',', "comma"}, {'=', "equal"},      {';', "semicolon"}};
    const char plain = character.toLatin1();
    shift = character.isUpper() || QByteArray("_:+()").contains(plain);
    return names.value(plain, QByteArray(1, character.toLower().toLatin1()));
}

} // namespace

struct XInput::Connection {
    Display* display = XOpenDisplay(nullptr);
    ~Connection() {
        if (display) XCloseDisplay(display);
    }
};

QString XInput::obstacle() {
    if (QGuiApplication::platformName() != QLatin1String("xcb")) return QStringLiteral("needs an X server");
    const Connection connection;
    int ignored = 0;
    if (!connection.display ||
        !XTestQueryExtension(connection.display, &ignored, &ignored, &ignored, &ignored))
        return QStringLiteral("needs an X server with the XTEST extension");
    return {};
}

XInput::XInput(std::chrono::milliseconds settling)
    : m_connection(std::make_unique<Connection>()), m_settling(settling) {}

XInput::~XInput() {
    for (const int button : QList(m_buttonsDown))
        fakeButton(button, false);
    for (const QByteArray& key : QList(m_keysDown))
        fakeKey(key, false);
    settle();
}

void XInput::settle() const {
    XSync(m_connection->display, 0);
    if (m_settling.count() == 0) return;
    QEventLoop loop;
    QTimer::singleShot(m_settling, &loop, &QEventLoop::quit);
    loop.exec();
}

void XInput::fakeButton(int button, bool down) {
    m_buttonsDown.removeAll(button);
    if (down) m_buttonsDown.append(button);
    XTestFakeButtonEvent(m_connection->display, unsigned(button), down, CurrentTime);
}

void XInput::fakeKey(const QByteArray& name, bool down) {
    const KeySym symbol = XStringToKeysym(fullName(name).constData());
    const KeyCode code = XKeysymToKeycode(m_connection->display, symbol);
    if (code == 0) qFatal("no key %s on this keyboard", name.constData());
    m_keysDown.removeAll(name);
    if (down) m_keysDown.append(name);
    XTestFakeKeyEvent(m_connection->display, code, down, CurrentTime);
}

void XInput::moveTo(const QPoint& point) {
    XTestFakeMotionEvent(m_connection->display, -1, point.x(), point.y(), CurrentTime);
    settle();
}

void XInput::press(Button button) {
    fakeButton(button, true);
    settle();
}

void XInput::release(Button button) {
    fakeButton(button, false);
    settle();
}

void XInput::click(Button button) {
    press(button);
    release(button);
}

void XInput::clickAt(const QPoint& point, Button button) {
    moveTo(point);
    click(button);
}

// Both clicks at once: on a busy machine two that are handled one by one may be too far apart.
void XInput::doubleClickAt(const QPoint& point) {
    moveTo(point);
    for (const bool down : {true, false, true, false})
        fakeButton(Left, down);
    settle();
}

void XInput::drag(const QPoint& from, const QList<QPoint>& through, Button button) {
    moveTo(from);
    press(button);
    for (const QPoint& point : through)
        moveTo(point);
    release(button);
}

void XInput::wheel(int notches) {
    for (int i = 0; i < std::abs(notches); ++i)
        click(notches > 0 ? WheelUp : WheelDown);
}

void XInput::hold(const char* key) {
    fakeKey(key, true);
    settle();
}

void XInput::letUp(const char* key) {
    fakeKey(key, false);
    settle();
}

void XInput::key(const char* chord) {
    const QList<QByteArray> keys = QByteArray(chord).split('+');
    for (const QByteArray& name : keys)
        fakeKey(name, true);
    for (auto name = keys.crbegin(); name != keys.crend(); ++name)
        fakeKey(*name, false);
    settle();
}

void XInput::type(const QString& text) {
    for (const QChar character : text) {
        bool shift = false;
        const QByteArray name = keyOf(character, shift);
        if (shift) fakeKey("Shift", true);
        fakeKey(name, true);
        fakeKey(name, false);
        if (shift) fakeKey("Shift", false);
        settle();
    }
}

} // namespace support
