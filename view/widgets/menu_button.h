// SPDX-License-Identifier: MIT
#pragma once

#include <QToolButton>

namespace view {

// A button that opens its menu. Its arrow is as high as its text, which tool buttons of some styles put in
// the corner below it.
class MenuButton : public QToolButton {
public:
    explicit MenuButton(QWidget* parent);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace view
