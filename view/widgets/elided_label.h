// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>

namespace view {

// One line of plain text that ends in dots where there is no room for all of it, and asks for no width.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace view
