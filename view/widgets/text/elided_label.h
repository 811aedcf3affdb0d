// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QStringList>

namespace view {

// A line of plain text, or a few, that end in dots where there is no room for all of it; asks for no width.
// Its tip then begins with all of it: composedTip().
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    void setLines(int most); // most lines; also the constant height of the label
    bool isCut() const;

    QSize sizeHint() const override { return withHeight(QLabel::sizeHint()); }
    QSize minimumSizeHint() const override { return withHeight(QLabel::minimumSizeHint()); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QStringList lines() const; // last line with all of the remaining text
    QSize withHeight(QSize size) const;

    int m_most = 1;
};

} // namespace view
