// SPDX-License-Identifier: MIT
#include "widgets/layout/wrapping_form.h"

#include <algorithm>

namespace view {

WrappingForm::WrappingForm() {
    setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    setRowWrapPolicy(QFormLayout::DontWrapRows);
}

WrappingForm::Widths WrappingForm::minWidths() const {
    Widths widths;
    const auto take = [this](int row, ItemRole role, int& width) {
        const QLayoutItem* item = itemAt(row, role);
        if (item && !item->isEmpty()) width = std::max(width, item->minimumSize().width());
    };
    for (int row = 0; row < rowCount(); ++row) {
        take(row, LabelRole, widths.label);
        take(row, FieldRole, widths.field);
        take(row, SpanningRole, widths.spanning);
    }
    return widths;
}

QSize WrappingForm::minimumSize() const {
    const Widths widths = minWidths();
    const QMargins margins = contentsMargins();
    return {std::max({widths.label, widths.field, widths.spanning}) + margins.left() + margins.right(),
            QFormLayout::minimumSize().height()};
}

void WrappingForm::setGeometry(const QRect& rect) {
    const Widths widths = minWidths();
    const QMargins margins = contentsMargins();
    const int beside = std::max(widths.label + horizontalSpacing() + widths.field, widths.spanning);
    setRowWrapPolicy(rect.width() < beside + margins.left() + margins.right() ? WrapAllRows : DontWrapRows);
    QFormLayout::setGeometry(rect);
}

} // namespace view
