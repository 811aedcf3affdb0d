// SPDX-License-Identifier: MIT
#pragma once

#include "card.h"
#include "document/document.h"

class MainWindow;

// After flames were opened or pasted: they let y grow downwards and were turned over to look the same here,
// unless a check box says that their numbers are to stay as written. Goes away with the next edit.
class FlameCard : public Card {
    Q_OBJECT

public:
    // In place of the one that is there.
    static void offer(MainWindow* window, const QList<document::EntryId>& flames);

private:
    FlameCard(MainWindow* host, const QList<document::EntryId>& flames);

    bool m_isTurning = false;
};
