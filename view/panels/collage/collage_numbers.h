// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/agreement_picture.h"

#include <QWidget>

#include <vector>

class QLabel;

namespace view {

// Numbers before and after a refinement, with the shape that was compared.
struct Refinement {
    document::Compared compared;
    document::MeasuredFractal before, after;
};
// The distance and the guarantee of both, and which of them has become worse.
QString refinementText(const Refinement& refinement);

// Agreement of the fractal with the target, in numbers.
class CollageNumbers : public QWidget {
    Q_OBJECT

public:
    explicit CollageNumbers(QWidget* parent);

    void show(const document::MeasuredFractal& measured);
    void clear(const QString& sentence); // reason why there are no numbers; empty: none to give

private:
    QLabel* m_sentence;
    QWidget* m_values;
    std::vector<QLabel*> m_labels;
};

} // namespace view
