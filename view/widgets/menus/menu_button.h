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
    QRect labelRect() const; // centred area of text and icon
    QRect arrowRect() const;

protected:
    void initStyleOption(QStyleOptionToolButton* option) const override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace view
