// SPDX-License-Identifier: MIT
#include "dialogs/aifs_dialog.h"

#include "document/fractal/fractal_geometry.h"
#include "io/exchange/aifs.h"
#include "widgets/numbers/number_text.h"
#include "widgets/text/text_edit_workarounds.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr std::size_t maxShown = 500; // maps; a text of ten thousand would be slow

// A coefficient for reading: without what rounding has left of a zero or a one.
QString entry(double value, Digits digits) {
    if (digits == Digits::All) return fullNumber(value).rightJustified(26);
    const double rounded = std::round(value * 1e12) / 1e12;
    return shortNumber(rounded + 0.0).rightJustified(16);
}

// The triangle of the cage; of a cage with more vertices, the one that a new cage would have.
ifs::ControlCage<2> triangleOf(const document::Fractal& fractal) {
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    return cage.rest.size() == 3 ? cage : document::canonicalCage(fractal);
}

} // namespace

QString aifsText(const document::Fractal& fractal, Digits digits) {
    const auto number = digits == Digits::All ? &fullNumber : &shortNumber;
    const document::System2* system = document::system2(fractal);
    if (!system) return AifsDialog::tr("This entry is not a system in the plane.");
    const ifs::ControlCage<2> cage = triangleOf(fractal);
    const ifs::Simplex<2> rest{cage.rest[0], cage.rest[1], cage.rest[2]};
    const io::AffineInvariantForm form = io::affineInvariantForm(*system, rest);
    QString text;
    for (std::size_t j = 0; j < 3; ++j)
        text += QStringLiteral("V%1 = (%2, %3)\n")
                    .arg(j + 1)
                    .arg(number(cage.current[j].x()), number(cage.current[j].y()));
    const std::size_t shown = digits == Digits::All ? form.maps.size() : std::min(form.maps.size(), maxShown);
    for (std::size_t i = 0; i < shown; ++i) {
        text += QStringLiteral("\nS%1 =\n").arg(i + 1);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                text += entry(form.maps[i](row, column), digits);
            text += u'\n';
        }
    }
    if (shown < form.maps.size())
        text += AifsDialog::tr("\n… and %1 more. Copy includes all of them.\n").arg(form.maps.size() - shown);
    return text;
}

AifsDialog::AifsDialog(const document::Fractal& fractal, QWidget* parent)
    : QDialog(parent), m_fractal(fractal) {
    setWindowTitle(tr("Affine Invariant Form"));
    auto* explanation =
        new QLabel(tr("Row j of a matrix contains the barycentric coordinates of the image of vertex j in "
                      "the triangle, so each row sums to 1. Dragging the triangle does not change the "
                      "matrices. If no entry is negative, the map takes the triangle to a part of itself."),
                   this);
    explanation->setWordWrap(true);
    auto* text = new TextEditWithWorkarounds<QPlainTextEdit>(aifsText(fractal, Digits::Few), this);
    text->setReadOnly(true);
    text->setAccessibleName(windowTitle());
    text->setWhatsThis(tr("Each map as a matrix that acts on barycentric coordinates in the control "
                          "triangle; every row sums to 1."));
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copy->setWhatsThis(tr("Copies the triangle and the matrices at full precision."));
    connect(copy, &QPushButton::clicked, this, &AifsDialog::copy);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(explanation);
    layout->addWidget(text, 1);
    layout->addWidget(buttons);
    resize(520, 460);
}

void AifsDialog::copy() const {
    QGuiApplication::clipboard()->setText(aifsText(m_fractal, Digits::All));
}

} // namespace view
