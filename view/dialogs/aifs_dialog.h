// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal.h"

#include <QDialog>

class QPlainTextEdit;

namespace view {

// The affine invariant form of a fractal, as text: the triangle and one row-stochastic matrix for each map.
class AifsDialog : public QDialog {
    Q_OBJECT

public:
    explicit AifsDialog(const document::Fractal& fractal, QWidget* parent = nullptr);
    QString text() const;

private:
    QPlainTextEdit* m_text;
};

// What the dialog shows; a sentence for an entry that is no system of the plane.
QString aifsText(const document::Fractal& fractal);

} // namespace view
