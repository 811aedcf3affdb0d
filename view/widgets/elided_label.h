// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>

namespace view {

// One line of plain text that ends in dots where there is no room for all of it, and asks for no width. Its
// tip then begins with all of it: composedTip().
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    bool isCut() const;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace view
