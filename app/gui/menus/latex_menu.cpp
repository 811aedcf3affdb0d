// SPDX-License-Identifier: MIT
#include "menus/latex_menu.h"

#include "document/edits/cage/cage_edits.h"
#include "io/exchange/latex.h"
#include "io/file/background.h"

#include <QClipboard>
#include <QGuiApplication>

LatexMenu::LatexMenu(const MenuContext& context) : ActionMenu(context, tr("Copy as La&TeX")) {
    setToolTipsVisible(true);
    const auto fractal = [document = context.document] { return document->sharedFractal(); };
    QAction* table =
        add({"copy-table-of-maps", tr("&Table of Maps"), {}, tr("Copy the coefficients as a tabular")},
            [this, fractal] { copy(&io::latexTable, fractal(), {}); });
    QAction* matrices =
        add({"copy-formulas-with-matrices",
             tr("&Formulas with Matrices"),
             {},
             tr("Copy each map as a matrix and a vector")},
            [this, fractal] { copy(&io::latexMatrices, fractal(), QStringLiteral("amsmath")); });
    QAction* form =
        add({"copy-affine-invariant-form",
             tr("&Affine Invariant Form"),
             {},
             tr("Copy one matrix per map, in barycentric coordinates of the triangle")},
            [this, fractal] { copy(&io::latexInvariantForm, fractal(), QStringLiteral("amsmath")); });
    QAction* figure = add({"copy-figure-tikz",
                           tr("Fi&gure (TikZ)"),
                           {},
                           tr("Copy the cage and its images under the maps, with numbers and fixed points, "
                              "as shown on the canvas")},
                          [this, fractal] {
                              const auto displayed = [](const document::Fractal& entry) {
                                  const auto baked = document::baked(entry);
                                  return io::tikzFigure(baked ? *baked : entry);
                              };
                              copy(displayed, fractal(), QStringLiteral("tikz"));
                          });
    for (QAction* any : {table, matrices})
        disableWhen(any, &document::cageObstacle);
    for (QAction* ofThePlane : {form, figure})
        disableWhen(ofThePlane, &document::planeObstacle);
}

// Copies in the background: an entry may have many maps.
void LatexMenu::copy(Write write, std::shared_ptr<const document::Fractal> fractal, const QString& package) {
    io::inBackground<QString>([write = std::move(write), fractal = std::move(fractal)](auto& promise) {
        promise.addResult(QString::fromUtf8(write(*fractal)));
    }).then(context().window, [messages = context().messages, package](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        messages->say(
            package.isEmpty()
                ? tr("Copied.")
                : tr("Copied. The document needs %1.").arg(QStringLiteral("\\usepackage{%1}").arg(package)));
    });
}
