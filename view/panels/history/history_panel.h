// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"

#include <QWidget>

namespace view {

// The steps of the history; choosing one goes back or forward to it. The saved state carries a mark.
class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(document::Document* document, QWidget* parent = nullptr);
};

} // namespace view
