// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/agreement_picture.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace view {

// How well the fractal agrees with the target, in numbers.
class CollageNumbers : public QWidget {
    Q_OBJECT

public:
    explicit CollageNumbers(QWidget* parent);

    void show(const document::MeasuredFractal& measured);
    void clear(const QString& sentence); // why there are no numbers; empty: there is nothing to say

private:
    QLabel* m_sentence;
    QWidget* m_values;
    std::vector<QLabel*> m_labels;
};

} // namespace view
