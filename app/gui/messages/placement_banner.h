// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "messages/message_banner.h"

class WindowMessages;

// Banner after entries with a placement were saved: says that other programs show them without it, and offers
// to write it into their code. Closes when another file is opened.
class PlacementBanner : public MessageBanner {
    Q_OBJECT

public:
    // Says nothing where no entry of the file is placed; whether it has said something.
    static bool offer(QMainWindow* window, document::Document& document, WindowMessages& messages);

private:
    PlacementBanner(QMainWindow* host, document::Document& document, WindowMessages& messages,
                    const QStringList& names);
    void bake(document::Document& document, WindowMessages& messages);
};
