// SPDX-License-Identifier: MIT
#include "latex_menu.h"

#include "document/edits/cage_edits.h"
#include "io/exchange/latex.h"

#include <QClipboard>
#include <QGuiApplication>

LatexMenu::LatexMenu(const MenuContext& context) : ActionMenu(context, tr("Copy as La&TeX")) {
    setToolTipsVisible(true);
    const auto fractal = [document = context.document] { return document->sharedFractal(); };
    QAction* table = add({nullptr, tr("&Table of Maps"), {}, tr("Copy the coefficients as a tabular")},
                         [this, fractal] { copy(io::latexTable(*fractal())); });
    QAction* matrices =
        add({nullptr, tr("&Formulas with Matrices"), {}, tr("Copy each map as a matrix and a vector")},
            [this, fractal] { copy(io::latexMatrices(*fractal())); });
    QAction* form = add({nullptr,
                         tr("&Affine Invariant Form"),
                         {},
                         tr("Copy one matrix per map, in barycentric coordinates of the triangle")},
                        [this, fractal] { copy(io::latexInvariantForm(*fractal())); });
    QAction* figure =
        add({nullptr,
             tr("Fi&gure (TikZ)"),
             {},
             tr("Copy the cage and its images under the maps, with numbers and fixed points, as "
                "they are displayed")},
            [this, fractal] {
                const auto displayed = document::baked(*fractal());
                copy(io::tikzFigure(displayed ? *displayed : *fractal()));
            });
    for (QAction* any : {table, matrices})
        disableWhen(any, &document::cageObstacle);
    for (QAction* ofThePlane : {form, figure})
        disableWhen(ofThePlane, &document::planeObstacle);
}

void LatexMenu::copy(const QByteArray& text) {
    QGuiApplication::clipboard()->setText(QString::fromUtf8(text));
    context().messages->say(
        tr("Copied. The document needs %1.").arg(QStringLiteral("\\usepackage{amsmath,tikz}")));
}
