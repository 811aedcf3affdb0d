// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"

#include <QDialog>

namespace view {

// The affine invariant form of a fractal, as text: the triangle and one row-stochastic matrix for each map.
class AifsDialog : public QDialog {
    Q_OBJECT

public:
    explicit AifsDialog(const document::Fractal& fractal, QWidget* parent = nullptr);
    void copy() const; // copies all digits

private:
    document::Fractal m_fractal;
};

// The text shown, with few digits and only the first maps, or copied, with all; a sentence for an entry that
// is no system of the plane.
enum class Digits { Few, All };
QString aifsText(const document::Fractal& fractal, Digits digits);

} // namespace view
