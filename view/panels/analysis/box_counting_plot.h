// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/dimension/box_counting.h"

#include <QWidget>

#include <optional>

namespace view {

// log₂ of the number of boxes over log₂ of their fineness, with the fitted line and its slope.
class BoxCountingPlot : public QWidget {
    Q_OBJECT

public:
    explicit BoxCountingPlot(QWidget* parent = nullptr);

    // An older one may be shown, paler, while a new one is under way.
    void setCounting(const std::optional<ifs::BoxCounting>& counting, bool isPending);
    QString table() const; // lines "ε<tab>N" with all digits

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    std::optional<ifs::BoxCounting> m_counting;
    bool m_isPending = false;
};

} // namespace view
