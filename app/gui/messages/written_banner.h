// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "messages/message_banner.h"

// Banner after a file was written without a dialog: names it, and leads to its folder. Closes at the next
// edit.
class WrittenBanner : public MessageBanner {
    Q_OBJECT

public:
    // Replaces the one that is open. The sentence has a place for the file's name, %1.
    static void offer(QMainWindow* window, const document::Document& document, const QString& path,
                      const QString& title, const QString& sentence);

    // After something was printed to a file; nothing where the path is empty.
    static void offerPrinted(QMainWindow* window, const document::Document& document, const QString& path);

private:
    WrittenBanner(QMainWindow* host, const document::Document& document, const QString& path,
                  const QString& title, const QString& sentence);
};
