// SPDX-License-Identifier: MIT
#pragma once

#include <QFormLayout>

namespace view {

// A form whose labels stand beside their fields where there is room, and above them where there is not.
// QFormLayout::WrapLongRows decides for each row, but gives rows that appear later no height (Qt 6.4).
class WrappingForm : public QFormLayout {
public:
    WrappingForm();

    QSize minimumSize() const override; // size with the labels above the fields
    void setGeometry(const QRect& rect) override;

private:
    struct Widths {
        int label = 0;
        int field = 0;
        int spanning = 0;
    };
    Widths minWidths() const;
};

} // namespace view
