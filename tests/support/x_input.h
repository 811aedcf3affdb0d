// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QPoint>
#include <QString>

#include <chrono>
#include <memory>

namespace support {

// The pointer and the keyboard of the X server, as a user operates them: every press goes through the server
// and the window manager. Positions are pixels of the screen. Every call processes the events it causes for
// `settling`; zero leaves them to the running event loop.
class XInput {
public:
    explicit XInput(std::chrono::milliseconds settling = std::chrono::milliseconds(25));
    ~XInput(); // releases all buttons and keys

    XInput(const XInput&) = delete;
    XInput& operator=(const XInput&) = delete;

    static QString obstacle(); // why no input can be sent here; empty if it can

    enum Button { Left = 1, Middle, Right, WheelUp, WheelDown };

    void moveTo(const QPoint& point);
    void press(Button button = Left);
    void release(Button button = Left);
    void click(Button button = Left);
    void clickAt(const QPoint& point, Button button = Left);
    void doubleClickAt(const QPoint& point);
    void drag(const QPoint& from, const QList<QPoint>& through, Button button = Left);
    void wheel(int notches); // away from the user is positive

    // Keys by their X names: "Escape", "Left", "s". A chord joins them: "Control+Shift+z".
    void hold(const char* key);
    void letUp(const char* key);
    void key(const char* chord);
    void type(const QString& text); // of the Latin alphabet, as on an English keyboard

    // Windows of all programs, by what their titles contain.
    unsigned long activeWindow() const; // 0: none
    QString activeTitle() const;        // of the one that has the keyboard; empty: none
    bool activate(const QString& title);

    void settle() const;

private:
    void fakeKey(const QByteArray& name, bool down);
    void fakeButton(int button, bool down);

    struct Connection;
    std::unique_ptr<Connection> m_connection;
    std::chrono::milliseconds m_settling;
    QList<QByteArray> m_keysDown;
    QList<int> m_buttonsDown;
};

} // namespace support
