// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"
#include "ifs/canonical_systems.h"
#include "io/exchange/latex.h"
#include "io/exchange/text_formats.h"
#include "io/text/expression.h"
#include "io/text/latex_text.h"
#include "io/text/readable_number.h"
#include "support/fractals.h"
#include "support/named_test.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <vector>

namespace {

QByteArray latexOf(const document::Fractal& fractal) {
    return io::writeLatex({std::make_shared<const document::Fractal>(fractal)});
}

document::Fractal inSpace() {
    ifs::AffineMap<3> map;
    map.linear = ifs::Vector<3>(.5, .25, 1e-7).asDiagonal();
    map.translation = ifs::Vector<3>(1, 2, 3);
    return support::fractalOf(std::vector{map});
}

} // namespace

class LatexTest : public QObject {
    Q_OBJECT

private slots:
    void formulasAreExact() {
        const QByteArray tex = latexOf(document::sierpinskiTriangle());
        QVERIFY(tex.contains("\\begin{align*}"));
        QVERIFY(tex.contains("w_{1}(x) &= \\begin{pmatrix} 0.5 & 0 \\\\ 0 & 0.5 \\end{pmatrix} x + "));
        QCOMPARE(tex.count("\\begin{pmatrix}"), 6);
        QVERIFY(tex.contains("p_{3} &= 0.333333333333333"));
    }

    void everyEnvironmentIsClosedAndBracesMatch() {
        document::Fractal fractal = document::sierpinskiTriangle();
        fractal.name = QStringLiteral("50% of {a_b\n} \\ $x$"); // in a comment
        for (QByteArray tex : {latexOf(fractal), latexOf(inSpace())}) {
            QVERIFY(tex.startsWith("% "));
            tex = tex.sliced(tex.indexOf('\n'));
            int depth = 0;
            QStringList open;
            for (qsizetype i = 0; i < tex.size(); ++i) {
                if (tex[i] == '\\') {
                    ++i; // \{ is no brace
                    continue;
                }
                depth += tex[i] == '{' ? 1 : tex[i] == '}' ? -1 : 0;
                QVERIFY(depth >= 0);
            }
            QCOMPARE(depth, 0);
            const QRegularExpression mark(QStringLiteral(R"(\\(begin|end)\{(\w+\*?)\})"));
            auto found = mark.globalMatch(QString::fromUtf8(tex));
            while (found.hasNext()) {
                const auto match = found.next();
                if (match.captured(1) == u"begin")
                    open << match.captured(2);
                else
                    QCOMPARE(open.takeLast(), match.captured(2));
            }
            QVERIFY(open.isEmpty());
        }
    }

    void smallNumbersAreSetAsPowers() {
        const QByteArray tex = latexOf(inSpace());
        QVERIFY(tex.contains("& 10^{-7} \\end{pmatrix}"));
        QVERIFY(!tex.contains("e-"));
        QVERIFY(!tex.contains("tikzpicture")); // a figure lies in the plane
    }

    // The longer side of everything drawn is eight centimetres.
    void theFigureFillsItsSquare() {
        const QString tex = QString::fromUtf8(latexOf(document::sierpinskiTriangle()));
        QCOMPARE(tex.count(QStringLiteral("\\draw")), 4);
        double high = 0;
        auto found = QRegularExpression(QStringLiteral(R"(\((-?[\d.]+),(-?[\d.]+)\) --)")).globalMatch(tex);
        while (found.hasNext()) {
            const auto match = found.next();
            for (int k = 1; k <= 2; ++k) {
                const double value = match.captured(k).toDouble();
                QVERIFY(value >= 0 && value <= 8);
                high = std::max(high, value);
            }
        }
        QCOMPARE(high, 8.0);
    }

    void theFigureNumbersItsImages() {
        const QByteArray tex = io::tikzFigure(document::sierpinskiTriangle());
        QCOMPARE(tex.count("\\node at "), 3);
        QCOMPARE(tex.count("circle[radius=2pt]"), 3);
        for (int i = 1; i <= 3; ++i)
            QVERIFY(tex.contains("{$" + QByteArray::number(i) + "$};"));
        QVERIFY(latexOf(document::sierpinskiTriangle()).contains(tex));
        QVERIFY(io::tikzFigure(inSpace()).isEmpty());
    }

    void tablesHoldEveryNumber() {
        document::Fractal fractal = document::sierpinskiTriangle();
        document::plane(fractal)->system.maps[1].enabled = false;
        const QByteArray tex = io::latexTable(fractal);
        const QByteArrayList lines = tex.split('\n');
        QCOMPARE(lines.front(), QByteArray("\\begin{tabular}{rrrrrrrr}"));
        QCOMPARE(lines[1], QByteArray("  $i$ & $a$ & $b$ & $c$ & $d$ & $e$ & $f$ & $p$ \\\\ \\hline"));
        QVERIFY(lines[2].startsWith("  1 & $0.5$ & $0$ & $0$ & $0.5$ & "));
        QVERIFY(lines[3].startsWith("  3 & ") && lines[3].endsWith("$0.5$ \\\\"));
        QCOMPARE(lines[4], QByteArray("\\end{tabular}"));
        QVERIFY(io::latexTable(inSpace()).contains("& $l$ & $p$"));
        QVERIFY(io::latexTable({}).isEmpty());
    }

    // Rows of the invariant form sum to 1, and those of an entry in space are none.
    void theInvariantFormIsOneMatrixForEachMap() {
        const QByteArray tex = io::latexInvariantForm(document::sierpinskiTriangle());
        QCOMPARE(tex.count("\\begin{pmatrix}"), 3);
        auto found = QRegularExpression(QStringLiteral(R"(pmatrix\} (\S+) & (\S+) & (\S+) )"))
                         .globalMatch(QString::fromUtf8(tex));
        int rows = 0;
        while (found.hasNext()) {
            const auto match = found.next();
            double sum = 0;
            for (int column = 1; column <= 3; ++column)
                sum += io::evaluate(io::plainLatex(match.captured(column))).value_or(NAN);
            QVERIFY(std::abs(sum - 1) < 1e-12);
            ++rows;
        }
        QCOMPARE(rows, 3);
        QVERIFY(io::latexInvariantForm(inSpace()).isEmpty());
        QVERIFY(io::latexMatrices(inSpace()).contains("align*"));
    }

    void numbersAreReadable_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QByteArray>("latex");
        QTest::addColumn<bool>("isRounded");
        const auto row = [](const char* latex, double value, bool isRounded = false) {
            QTest::newRow(latex) << value << QByteArray(latex) << isRounded;
        };
        const double root = std::sqrt(3.0);
        row("0", 5.55e-17);
        row("-0.85", -0.85);
        row("0.3", 0.1 + 0.2);
        row("\\frac{1}{3}", 1.0 / 3);
        row("-\\frac{2}{3}", -2.0 / 3);
        row("\\frac{5}{96}", 5.0 / 96 + 1e-17);
        row("\\frac{\\sqrt{3}}{6}", root / 6);
        row("-\\frac{\\sqrt{3}}{2}", -std::sin(std::acos(-1.0) / 3));
        row("\\frac{2\\sqrt{3}}{3}", 2 / root);
        row("\\frac{\\sqrt{5}-1}{2}", (std::sqrt(5.0) - 1) / 2);
        row("\\frac{3-\\sqrt{5}}{2}", (3 - std::sqrt(5.0)) / 2);
        row("\\sqrt{2}", std::sqrt(2.0));
        row("10^{-7}", 1e-7);
        row("1.5\\cdot 10^{12}", 1.5e12);
        row("0.301511", 1 / std::sqrt(11.0), true);
        row("0.333333", 1.0 / 3 + 1e-9, true);
        row("2.71828", std::exp(1.0), true);
    }

    void numbersAreReadable() {
        QFETCH(double, value);
        const io::ReadableNumber number = io::readableNumber(value);
        QTEST(number.latex, "latex");
        QTEST(number.isRounded, "isRounded");
    }

    // What is copied is readable, and says where it is rounded; what is exported is exact.
    void copiedNumbersAreReadable() {
        document::Fractal fractal = document::sierpinskiTriangle();
        document::plane(fractal)->system.maps[0].map =
            ifs::affineMap(0, std::sqrt(3.0) / 6, 1.0 / 3, 5e-17, 2, 1);
        const QByteArray tex = io::latexMatrices(fractal);
        QVERIFY2(
            tex.contains("\\begin{pmatrix} 0 & \\frac{\\sqrt{3}}{6} \\\\ \\frac{1}{3} & 0 \\end{pmatrix}"),
            tex.constData());
        QVERIFY(!tex.contains("rounded"));
        QVERIFY(latexOf(fractal).contains("0.3333333333333333"));
        document::plane(fractal)->system.maps[0].map.translation.x() = std::exp(1.0);
        for (const QByteArray& copied : {io::latexMatrices(fractal), io::latexTable(fractal)})
            QVERIFY(copied.startsWith("% rounded") && copied.contains("2.71828") &&
                    !copied.contains("2.718281"));
    }

    void manyMapsAreOnSeveralPages() {
        document::Fractal fractal;
        document::Shape<2> shape;
        for (int i = 0; i < 100; ++i)
            ifs::append(shape.system, ifs::affineMap(.5, 0, 0, .5, i, 0));
        fractal.shape = shape;
        const QByteArray matrices = io::latexMatrices(fractal);
        QCOMPARE(matrices.count("\\begin{align*}"), 7);
        QCOMPARE(matrices.count("w_{"), 100);
        const QByteArray table = io::latexTable(fractal);
        QCOMPARE(table.count("\\begin{tabular}"), 3);
        QCOMPARE(table.count("\\hline"), 3);
    }

    void mapsThatAreOffAreLeftOut() {
        document::Fractal fractal = document::sierpinskiTriangle();
        document::plane(fractal)->system.maps[1].enabled = false;
        const QByteArray tex = latexOf(fractal);
        QVERIFY(tex.contains("w_{1}") && !tex.contains("w_{2}") && tex.contains("w_{3}"));
    }

    void theFormatIsKnownByName() {
        QCOMPARE(io::textFormat(QStringLiteral("tex")), io::TextFormat::Latex);
        QCOMPARE(io::textFormat(QStringLiteral("LaTeX")), io::TextFormat::Latex);
        QCOMPARE(io::suffixOf(io::TextFormat::Latex), QStringLiteral("tex"));
        QVERIFY(io::lossOf(io::TextFormat::Latex, document::sierpinskiTriangle()) == std::nullopt);
    }
};

BARYCAGE_TEST(LatexTest, QCoreApplication);
#include "latex_test.moc"
