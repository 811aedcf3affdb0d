// SPDX-License-Identifier: MIT
#include "support/x_input.h"

#include <QEventLoop>
#include <QGuiApplication>
#include <QHash>
#include <QTimer>

#include <cstring>

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

namespace {

// What a window manager, or a program, says of a window.
QByteArray property(Display* display, Window window, const char* name) {
    Atom type = 0;
    int bits = 0;
    unsigned long count = 0, left = 0;
    unsigned char* data = nullptr;
    constexpr long longest = 4096;
    XGetWindowProperty(display, window, XInternAtom(display, name, 0), 0, longest, 0, AnyPropertyType, &type,
                       &bits, &count, &left, &data);
    const int size = bits == 32 ? int(sizeof(long)) : bits / 8; // that of a long, whatever it holds
    const QByteArray value(reinterpret_cast<const char*>(data), data ? qsizetype(count) * size : 0);
    if (data) XFree(data);
    return value;
}

QList<Window> windowsIn(Display* display, const char* name) {
    const QByteArray value = property(display, DefaultRootWindow(display), name);
    QList<Window> windows(value.size() / qsizetype(sizeof(Window)));
    std::memcpy(windows.data(), value.constData(), std::size_t(windows.size()) * sizeof(Window));
    return windows;
}

QString titleOf(Display* display, Window window) {
    return window == 0 ? QString() : QString::fromUtf8(property(display, window, "_NET_WM_NAME"));
}

// A window may go at any moment.
int forgive(Display*, XErrorEvent*) {
    return 0;
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

unsigned long XInput::activeWindow() const {
    XSetErrorHandler(forgive);
    const QList<Window> active = windowsIn(m_connection->display, "_NET_ACTIVE_WINDOW");
    return active.isEmpty() ? 0 : active.first();
}

QString XInput::activeTitle() const {
    return titleOf(m_connection->display, activeWindow());
}

bool XInput::activate(const QString& title) {
    XSetErrorHandler(forgive);
    Display* display = m_connection->display;
    for (const Window window : windowsIn(display, "_NET_CLIENT_LIST")) {
        if (!titleOf(display, window).contains(title)) continue;
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window;
        event.xclient.message_type = XInternAtom(display, "_NET_ACTIVE_WINDOW", 0);
        event.xclient.format = 32;
        event.xclient.data.l[0] = 2; // as a pager does
        XSendEvent(display, DefaultRootWindow(display), 0, SubstructureRedirectMask | SubstructureNotifyMask,
                   &event);
        settle();
        return true;
    }
    return false;
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
