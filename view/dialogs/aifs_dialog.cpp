// SPDX-License-Identifier: MIT
#include "dialogs/aifs_dialog.h"

#include "io/aifs.h"
#include "panels/number_text.h"

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

// A number without what rounding has left of a zero or a one.
QString entry(double value) {
    const double rounded = std::round(value * 1e12) / 1e12;
    return shortNumber(rounded + 0.0).rightJustified(16);
}

// The triangle of the cage; of a cage with more vertices, the one that a new cage would have.
ifs::ControlCage<2> triangleOf(const document::Fractal& fractal) {
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    if (cage.rest.size() == 3) return cage;
    document::Fractal bare = fractal;
    bare.cage.reset();
    return document::effectiveCage(bare);
}

} // namespace

QString aifsText(const document::Fractal& fractal) {
    const document::System2* system = document::system2(fractal);
    if (!system) return AifsDialog::tr("This entry has no maps of the plane.");
    const ifs::ControlCage<2> cage = triangleOf(fractal);
    const ifs::Simplex<2> rest{cage.rest[0], cage.rest[1], cage.rest[2]};
    const io::AffineInvariantForm form = io::affineInvariantForm(*system, rest);
    QString text;
    for (std::size_t j = 0; j < 3; ++j)
        text += QStringLiteral("V%1 = (%2, %3)\n")
                    .arg(j + 1)
                    .arg(shortNumber(cage.current[j].x()), shortNumber(cage.current[j].y()));
    for (std::size_t i = 0; i < form.maps.size(); ++i) {
        text += QStringLiteral("\nS%1 =\n").arg(i + 1);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                text += entry(form.maps[i](row, column));
            text += u'\n';
        }
    }
    return text;
}

AifsDialog::AifsDialog(const document::Fractal& fractal, QWidget* parent)
    : QDialog(parent), m_text(new QPlainTextEdit(aifsText(fractal), this)) {
    setWindowTitle(tr("Affine Invariant Form"));
    auto* explanation = new QLabel(
        tr("Row j of a matrix holds the barycentric coordinates of the image of vertex j in the triangle, so "
           "each row sums to 1. The matrices do not change when the triangle is dragged. Where no entry is "
           "negative, the map takes the triangle into itself."),
        this);
    explanation->setWordWrap(true);
    m_text->setReadOnly(true);
    m_text->setAccessibleName(windowTitle());
    m_text->setWhatsThis(tr("Every map as a matrix that takes barycentric coordinates over the control "
                            "triangle to barycentric coordinates: each row has the sum 1."));
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    copy->setWhatsThis(tr("Copies the matrices to the clipboard as text."));
    connect(copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(explanation);
    layout->addWidget(m_text, 1);
    layout->addWidget(buttons);
    resize(520, 460);
}

QString AifsDialog::text() const {
    return m_text->toPlainText();
}

} // namespace view
