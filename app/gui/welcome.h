// SPDX-License-Identifier: MIT
#pragma once

#include "messages/message_banner.h"

class MainWindow;

// Suggestions in a window that opened nothing: the last files, another file, the collection. Goes away with
// the first thing done: a command, a tool, another panel, a press on the picture.
class Welcome : public MessageBanner {
    Q_OBJECT

public:
    // Does nothing when there are no recent files.
    static void offer(MainWindow* window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    explicit Welcome(MainWindow* host);
};
