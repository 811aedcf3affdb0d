// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QString>

class QFile;

namespace document {

// Opens what `name`, the bytes of a path, leads to for reading, unless it is something else than a regular
// file: a pipe, a device or a socket may never answer, nor come to an end, and does not get a chance to hold
// anybody up, also if it takes the place of a file at this moment.
struct Opened {
    enum class State { Open, NotRegular, Closed };
    State state = State::Open;
    QString error{}; // reason why it is closed

    bool isOpen() const { return state == State::Open; }
    bool isSpecial() const { return state == State::NotRegular; }
};
Opened openRegular(QFile& file, const QByteArray& name);

} // namespace document
