// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

// The end that asks nothing: by a signal to the program, or with the session of the desktop. What is unsaved
// is stored for the next start, however the program is ended then. One for the program; it belongs to the
// thread of the windows.
class SuddenEnd : public QObject {
    Q_OBJECT

public:
    SuddenEnd();
    ~SuddenEnd() override; // restores the default: signals end the program at once

private:
    void watchSignals();
    void endBySignal();
};
