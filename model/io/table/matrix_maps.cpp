// SPDX-License-Identifier: MIT
#include "io/table/matrix_maps.h"

#include "io/table/markup_tables.h"
#include "io/text/expression.h"
#include "io/text/latex_text.h"
#include "io/text/plain_signs.h"

#include <QRegularExpression>

#include <algorithm>

namespace io {

namespace {

// A matrix of numbers, row by row.
struct Matrix {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> numbers;
    qsizetype begin = 0, end = 0;

    double at(std::size_t row, std::size_t column) const { return numbers[row * columns + column]; }
    bool isVector() const { return columns == 1 && (rows == 2 || rows == 3); }
    // True for a last row 0 … 0 1.
    bool isHomogeneous() const {
        if (rows != columns || rows < 3) return false;
        for (std::size_t column = 0; column < columns; ++column)
            if (at(rows - 1, column) != (column + 1 == columns ? 1 : 0)) return false;
        return true;
    }
};

std::optional<double> numberOf(QString text) {
    static const QRegularExpression decimalComma(QStringLiteral("^-?\\d*,\\d+$"));
    text = plainSigns(text);
    if (decimalComma.match(text).hasMatch()) text.replace(u',', u'.');
    return evaluate(text);
}

// Numbers before a matrix: all that stands behind the last sign that parts it from something else.
double factorBefore(QStringView source) {
    QString text = plainSigns(plainLatex(source)).trimmed();
    for (const QChar open : {u'(', u'['})
        if (text.endsWith(open)) text = text.chopped(1).trimmed();
    if (text.endsWith(u'*')) text = text.chopped(1).trimmed();
    qsizetype begin = 0;
    int depth = 0;
    for (qsizetype i = text.size() - 1; i >= 0; --i) {
        const QChar c = text[i];
        depth += c == u')' ? 1 : c == u'(' ? -1 : 0;
        const bool isSign = (c == u'+' || c == u'-') && depth == 0;
        if (depth < 0 || isSign || c == u'=' || c == u'&' || c == u',' || c == u':') {
            begin = c == u'-' ? i : i + 1;
            break;
        }
    }
    const QString factor = text.sliced(begin).trimmed();
    if (factor == u"-") return -1;
    return numberOf(factor).value_or(factor.startsWith(u'-') ? -1 : 1);
}

// A matrix in place of a mere factor, as in S(x) = \tfrac13 x + …; lines stay. Alone, x' = x/3 is an
// equation.
QString withFactorsAsMatrices(const QString& text) {
    static const QRegularExpression factor(QStringLiteral(
        R"((\)\s*&?\s*)?=\s*&?\s*)"
        R"((\\[tdcs]?frac\s*(?:\{[^{}]{1,40}\}|\d)\s*(?:\{[^{}]{1,40}\}|\d)|[-\d./]+|\([-\d./]+\))?)"
        R"(\s*(?:\\cdot|\\,|\*)?\s*)"
        R"((?:(\\(?:mathbf|vec|boldsymbol|bm|mathrm|underline)\s*(?:\{\s*[a-z]\s*\}|[a-z]))|\bx\b))"
        R"((\s*/\s*\d+)?(?=\s*(?:[+,;&.$)]|\\\\|\\end|\\quad|\n|$)))"));
    QString matrices;
    qsizetype before = 0;
    for (auto found = factor.globalMatch(text); found.hasNext();) {
        const auto match = found.next();
        const bool isOfPoint = !match.captured(1).isEmpty() || !match.captured(3).isEmpty();
        const QString one = match.captured(2).isEmpty() ? QStringLiteral("1") : match.captured(2);
        const QString number = (one + match.captured(4)).simplified();
        if (!isOfPoint || number == u"1" || !numberOf(plainLatex(number))) continue;
        matrices += QStringView(text).sliced(before, match.capturedStart() - before);
        matrices += match.captured(1);
        matrices += QStringLiteral("=\\begin{pmatrix}%1&0\\\\0&%1\\end{pmatrix}x").arg(number);
        before = match.capturedEnd();
    }
    return matrices + text.sliced(before);
}

std::vector<Matrix> matricesOfNumbers(const QString& text) {
    std::vector<Matrix> matrices;
    qsizetype before = 0;
    for (const LatexMatrix& latex : latexMatrices(text)) {
        Matrix matrix{std::size_t(latex.rows.size()), 0, {}, latex.begin, latex.end};
        bool isGood = !latex.rows.isEmpty();
        for (const QStringList& row : latex.rows) {
            isGood = isGood && (matrix.columns == 0 || matrix.columns == std::size_t(row.size()));
            matrix.columns = std::size_t(row.size());
            for (const QString& cell : row) {
                const auto number = numberOf(cell);
                isGood = isGood && number;
                matrix.numbers.push_back(number.value_or(0));
            }
        }
        const qsizetype from = std::exchange(before, latex.end);
        if (!isGood || matrix.rows > 4 || matrix.columns > 4) continue;
        if (!matrix.isHomogeneous() && from <= latex.begin) {
            const double factor = factorBefore(QStringView(text).sliced(from, latex.begin - from));
            for (double& number : matrix.numbers)
                number *= factor;
        }
        matrices.push_back(std::move(matrix));
    }
    return matrices;
}

// The map of a matrix, and of the vector behind it if there is one.
std::optional<std::vector<double>> numbersOf(const Matrix& matrix, const Matrix* vector) {
    const bool isHomogeneous = matrix.isHomogeneous() && !(vector && vector->rows == matrix.rows);
    const std::size_t dim = isHomogeneous ? matrix.rows - 1 : matrix.rows;
    if (dim != 2 && dim != 3) return std::nullopt;
    const bool isAugmented = matrix.columns == dim + 1;
    if (!isAugmented && matrix.columns != dim) return std::nullopt;
    std::vector<double> numbers;
    for (std::size_t row = 0; row < dim; ++row)
        for (std::size_t column = 0; column < dim; ++column)
            numbers.push_back(matrix.at(row, column));
    for (std::size_t row = 0; row < dim; ++row)
        numbers.push_back(isAugmented ? matrix.at(row, dim) : vector ? vector->at(row, 0) : 0);
    return numbers;
}

} // namespace

std::vector<WrittenMap> matrixMaps(const QString& source) {
    if (!source.contains(QStringLiteral("\\begin{"))) return {};
    const QString text = withFactorsAsMatrices(source);
    const std::vector<Matrix> matrices = matricesOfNumbers(text);
    std::vector<WrittenMap> maps;
    QStringList between;
    qsizetype before = 0, counted = 0;
    int line = 1;
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        const Matrix& matrix = matrices[i];
        line += int(QStringView(text).sliced(counted, matrix.begin - counted).count(u'\n'));
        counted = matrix.begin;
        if (matrix.columns < 2 || matrix.begin < before) continue;
        const bool hasVector = i + 1 < matrices.size() && matrices[i + 1].isVector() &&
                               matrices[i + 1].rows == matrix.rows && matrix.columns == matrix.rows;
        auto numbers = numbersOf(matrix, hasVector ? &matrices[i + 1] : nullptr);
        if (!numbers) continue;
        const qsizetype end = matrices[i + (hasVector ? 1 : 0)].end;
        between << plainLatex(QStringView(text).sliced(before, matrix.begin - before));
        maps.push_back({*std::move(numbers), {}, line});
        before = end;
    }
    if (maps.empty()) return {};
    between << plainLatex(QStringView(text).sliced(before));
    const auto weights = weightsBetween(between);
    for (std::size_t i = 0; i < maps.size(); ++i)
        maps[i].weight = weights[i];
    return maps;
}

} // namespace io
