// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "messages/message_banner.h"

// Banner after flames were opened or pasted: says that they were turned over, since their y grows downwards,
// and offers to keep their numbers as written. Closes at the next edit.
class FlameBanner : public MessageBanner {
    Q_OBJECT

public:
    // Replaces the one that is open.
    static void offer(QMainWindow* window, document::Document& document,
                      const QList<document::EntryId>& flames);

private:
    FlameBanner(QMainWindow* host, document::Document& document, const QList<document::EntryId>& flames);

    bool m_isTurning = false;
};
