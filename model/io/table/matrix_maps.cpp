// SPDX-License-Identifier: MIT
#include "io/table/matrix_maps.h"

#include "io/table/markup_tables.h"
#include "io/text/expression.h"
#include "io/text/latex_text.h"
#include "io/text/plain_signs.h"

#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace io {

namespace {

// A matrix, row by row.
struct Matrix {
    enum class Kind {
        Numbers,
        Point,   // x, y and perhaps z below each other
        General, // letters only, as a, b, c, d
        Unread,
    };
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> numbers;
    qsizetype begin = 0, end = 0;
    Kind kind = Kind::Numbers;
    QString text; // of one that is not read

    double at(std::size_t row, std::size_t column) const { return numbers[row * columns + column]; }
    bool isOfNumbers() const { return kind == Kind::Numbers; }
    bool isVector(std::size_t dim) const {
        return isOfNumbers() && std::min(rows, columns) == 1 && std::max(rows, columns) == dim;
    }
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

// Plain text, in which ";" ends a row.
QString plainRows(QStringView source) {
    static const QRegularExpression rowEnd(QStringLiteral(R"(\\\\\*?(\[[^\]]{0,20}\])?|\\q?quad\b|\n\s*\n)"));
    return plainSigns(plainLatex(source.toString().replace(rowEnd, QStringLiteral(" ; ")))).simplified();
}

Matrix::Kind kindOf(const QStringList& cells) {
    static const QRegularExpression coordinate(QStringLiteral("^[xyz]('|′|_?\\w|_?\\([^)]*\\))*$"));
    static const QRegularExpression letter(QStringLiteral("^-?[A-Za-z](_?\\(?\\w{1,5}\\)?)?$"));
    const auto areAll = [&](const QRegularExpression& pattern) {
        return std::ranges::all_of(cells, [&](const QString& cell) { return cell.contains(pattern); });
    };
    return areAll(coordinate) ? Matrix::Kind::Point
           : areAll(letter)   ? Matrix::Kind::General
                              : Matrix::Kind::Unread;
}

Matrix matrixOf(const LatexMatrix& latex) {
    Matrix matrix{std::size_t(latex.rows.size()), 0, {}, latex.begin, latex.end, Matrix::Kind::Numbers, {}};
    bool isGood = !latex.rows.isEmpty();
    QStringList cells;
    for (const QStringList& row : latex.rows) {
        isGood = isGood && (matrix.columns == 0 || matrix.columns == std::size_t(row.size()));
        matrix.columns = std::size_t(row.size());
        for (const QString& cell : row) {
            const auto number = numberOf(cell);
            if (!number && isGood) matrix.text = cell;
            isGood = isGood && number;
            matrix.numbers.push_back(number.value_or(0));
        }
        cells << row;
    }
    if (!isGood) matrix.kind = kindOf(cells);
    constexpr qsizetype longest = 60;
    matrix.text = (matrix.text.isEmpty() ? cells.join(u' ') : matrix.text).left(longest);
    return matrix;
}

// Matrices up to 4 × 4. Those around others only arrange them.
std::vector<Matrix> matricesIn(const QString& text) {
    constexpr std::size_t most = 4;
    std::vector<Matrix> matrices;
    for (const LatexMatrix& latex : latexMatrices(text)) {
        while (!matrices.empty() && matrices.back().end > latex.begin)
            matrices.pop_back();
        Matrix matrix = matrixOf(latex);
        if (matrix.rows <= most && matrix.columns <= most) matrices.push_back(std::move(matrix));
    }
    const auto isOfNumbers = [](const Matrix& matrix) { return matrix.isOfNumbers(); };
    const auto first = std::ranges::find_if(matrices, isOfNumbers);
    const auto last = std::find_if(matrices.rbegin(), matrices.rend(), isOfNumbers).base();
    for (auto one = matrices.begin(); one != matrices.end(); ++one)
        if (one->kind == Matrix::Kind::General && one >= first && one < last)
            one->kind = Matrix::Kind::Unread;
    return matrices;
}

// The numbers of the matrix, and of its vector.
std::optional<std::vector<double>> numbersOf(const Matrix& matrix, const std::vector<double>& vector) {
    const bool isHomogeneous = matrix.isHomogeneous() && vector.empty();
    const std::size_t dim = isHomogeneous ? matrix.rows - 1 : matrix.rows;
    if (dim != 2 && dim != 3) return std::nullopt;
    const bool isAugmented = matrix.columns == dim + 1;
    if (!isAugmented && matrix.columns != dim) return std::nullopt;
    std::vector<double> numbers;
    for (std::size_t row = 0; row < dim; ++row)
        for (std::size_t column = 0; column < dim; ++column)
            numbers.push_back(matrix.at(row, column));
    for (std::size_t row = 0; row < dim; ++row)
        numbers.push_back(isAugmented ? matrix.at(row, dim) : vector.empty() ? 0 : vector[row]);
    return numbers;
}

// Reads maps, M x + v, and accounts for what stands between the matrices.
class MatrixReader {
public:
    explicit MatrixReader(const QString& text) : m_text(text), m_matrices(matricesIn(text)) {}

    WrittenMaps read() && {
        while (m_next < m_matrices.size() && m_problem.isEmpty()) {
            const Matrix& matrix = m_matrices[m_next];
            m_line += int(QStringView(m_text).sliced(m_counted, matrix.begin - m_counted).count(u'\n'));
            m_counted = matrix.begin;
            take(matrix);
        }
        if (m_problem.isEmpty())
            m_problem = lostRow(plainRows(QStringView(m_text).sliced(std::max(m_before, m_seen))));
        if (m_maps.empty()) return {};
        if (m_problem.isEmpty()) sayWhichIsAlone();
        if (!m_problem.isEmpty()) {
            constexpr qsizetype longest = 60;
            return {m_maps,
                    UnreadMap{m_row > 0 ? m_row : int(m_maps.size()) + 1, m_line, m_problem.left(longest)}};
        }
        m_between << plainLatex(QStringView(m_text).sliced(m_before));
        const auto weights = weightsBetween(m_between);
        for (std::size_t i = 0; i < m_maps.size(); ++i)
            m_maps[i].weight = weights[i];
        return {std::move(m_maps)};
    }

private:
    void take(const Matrix& matrix) {
        ++m_next;
        const qsizetype from = std::max(m_before, std::exchange(m_seen, matrix.end));
        if (matrix.kind == Matrix::Kind::Unread) return fail(matrix.text);
        const QString lost = lostRow(plainRows(QStringView(m_text).sliced(from, matrix.begin - from)));
        if (!lost.isEmpty()) return fail(lost);
        if (!matrix.isOfNumbers()) return;
        const qsizetype near = std::max(m_before, matrix.begin - longestGap);
        const QString before = plainRows(QStringView(m_text).sliced(near, matrix.begin - near));
        if (std::min(matrix.rows, matrix.columns) == 1) { // a vector that no map took
            const bool isAdded = before.endsWith(u'+') || behind(matrix.end).startsWith(u'+');
            if (isAdded || !m_maps.empty()) fail(matrix.text);
            return;
        }
        takeMap(matrix, before);
    }

    void takeMap(Matrix matrix, const QString& before) {
        int brackets = 0;
        const auto factor = factorIn(before, matrix.begin, brackets);
        if (!factor) return fail(before.right(longestHead));
        qsizetype at = matrix.end;
        QString rest = behind(at);
        const bool isPair = brackets == 1 && rest.startsWith(u',');
        for (; brackets > 0 && !isPair; --brackets) {
            if (!rest.startsWith(u')') && !rest.startsWith(u']'))
                return fail(before.right(longestHead) + rest);
            rest = rest.sliced(1).trimmed();
        }
        if (rest.startsWith(u'^') || rest.startsWith(u'/')) return fail(rest);
        m_end = matrix.end;
        const bool hasPoint = takePoint(rest);
        if (!m_problem.isEmpty()) return;
        const bool isWhole = matrix.isHomogeneous() || matrix.columns != matrix.rows;
        std::vector<double> vector;
        if (!takeVector(rest, matrix.rows, isWhole, hasPoint, vector)) return fail(rest);
        const bool isFactorOfAll = !matrix.isHomogeneous() || !vector.empty();
        if (isFactorOfAll)
            for (double& number : matrix.numbers)
                number *= *factor;
        auto numbers = numbersOf(matrix, vector);
        if (!numbers) return fail(matrix.text);
        m_between << plainLatex(QStringView(m_text).sliced(m_before, matrix.begin - m_before));
        const QString head = before.right(longestHead).remove(u' ').remove(u'&');
        const bool isOfPoint = hasPoint || isWhole || head.contains(QStringLiteral(")="));
        m_hasPoints = m_hasPoints || isOfPoint;
        if (!isOfPoint && vector.empty() && head.endsWith(u'=') && m_alone < 0) m_alone = int(m_maps.size());
        m_maps.push_back({*std::move(numbers), {}, m_line});
        m_before = m_end;
    }

    // What multiplies a matrix: a number, or nothing. Brackets that open before it are counted.
    std::optional<double> factorIn(QString before, qsizetype end, int& brackets) const {
        static const QRegularExpression letter(QStringLiteral(
            R"(\\(alpha|beta|gamma|delta|eta|kappa|lambda|mu|nu|rho|sigma|tau|phi|psi|omega|epsilon)\s*(\\left)?[(\[]?\s*$)"));
        const qsizetype from = std::max(m_before, end - 40);
        if (QStringView(m_text).sliced(from, end - from).toString().contains(letter)) return std::nullopt;
        while (before.endsWith(u'(') || before.endsWith(u'[')) {
            before = before.chopped(1).trimmed();
            ++brackets;
        }
        if (before.endsWith(u'*')) before = before.chopped(1).trimmed();
        qsizetype begin = before.size();
        int depth = 0;
        for (; begin > 0; --begin) {
            const QChar c = before[begin - 1];
            depth += c == u')' ? 1 : c == u'(' ? -1 : 0;
            if (depth < 0 || (depth == 0 && QStringView(u"=→;,:&|").contains(c))) break;
        }
        const bool isFormula = begin > 0 && QStringView(u"=→").contains(before[begin - 1]);
        const QString factor = before.sliced(begin).trimmed();
        if (factor.isEmpty() || factor == u"-") return factor.isEmpty() ? 1 : -1;
        if (const auto number = numberOf(factor)) return number;
        const bool isTerm = factor.endsWith(u'+') || factor.endsWith(u'-');
        if (isFormula || isTerm) return std::nullopt;
        return factorBehindWords(factor);
    }

    // "the map 0.5" before a matrix.
    static std::optional<double> factorBehindWords(const QString& words) {
        const QString last = words.sliced(words.lastIndexOf(u' ') + 1);
        return numberOf(last).value_or(1);
    }

    // Plain text from there to the next matrix.
    QString behind(qsizetype at) const {
        const qsizetype end = m_next < m_matrices.size() ? m_matrices[m_next].begin : m_text.size();
        return plainRows(QStringView(m_text).sliced(at, std::clamp(end - at, qsizetype(0), longestGap)));
    }
    const Matrix* next() const { return m_next < m_matrices.size() ? &m_matrices[m_next] : nullptr; }

    // Takes the point behind a matrix: x, (x, y), or a vector of coordinates.
    bool takePoint(QString& rest) {
        static const QRegularExpression head(QStringLiteral(R"(^\s*(\([^()]*\))?\s*&?\s*[=:])"));
        if (rest.isEmpty() && next() && next()->kind == Matrix::Kind::Unread) fail(next()->text);
        static const QRegularExpression letter(QStringLiteral(
            R"(^\*?\s*([A-Za-z](?![A-Za-z])('|_?\w(?![A-Za-z])|_?\([^()]*\))?|\(\s*[xz]\s*([,;]\s*[yz]\s*)*\)(\^T)?)\s*)"));
        if (rest.isEmpty() && next() && next()->kind == Matrix::Kind::Point) {
            m_end = next()->end;
            ++m_next;
            rest = behind(m_end);
            if (rest.startsWith(u'^')) fail(rest);
            return true;
        }
        if (const auto match = letter.match(rest);
            match.hasMatch() && !rest.sliced(match.capturedLength()).contains(head)) {
            rest.remove(0, match.capturedLength());
            return true;
        }
        static const QRegularExpression other(QStringLiteral(R"(^\([^()]*(?<![A-Za-z])[xyz](?![A-Za-z]))"));
        if (rest.contains(other)) fail(rest);
        return false;
    }

    // Takes the vector that is added behind. Without one, what follows must not belong to the map.
    bool takeVector(const QString& rest, std::size_t dim, bool isWhole, bool hasPoint,
                    std::vector<double>& vector) {
        const bool isSum = rest.startsWith(u'+') || (rest.startsWith(u'-') && (hasPoint || next()));
        if (isWhole) return !isSum;
        const Matrix* one = next();
        if (isSum) {
            const double sign = rest.startsWith(u'-') ? -1 : 1;
            QString factor = rest.sliced(1).trimmed();
            if (takeList(factor, dim, sign, vector)) return true;
            if (factor.endsWith(u'*')) factor = factor.chopped(1).trimmed();
            const auto number = factor.isEmpty() ? std::optional(1.0) : numberOf(factor);
            if (!number || !one || !one->isVector(dim)) return false;
            return takeColumn(*one, sign * *number, vector);
        }
        if (!one || !one->isOfNumbers()) return true;
        if (rest.isEmpty() && !hasPoint)
            return one->isVector(dim) && one->columns == 1 && takeColumn(*one, 1, vector);
        static const QRegularExpression parted(QStringLiteral("^[,;]?[^;+=-]{0,40}=?\\s*[(\\[]?$"));
        if (one->isVector(dim) && one->columns == 1 && rest.contains(parted))
            return takeColumn(*one, 1, vector);
        return true;
    }

    // "(1, 0)ᵀ"
    bool takeList(const QString& text, std::size_t dim, double sign, std::vector<double>& vector) {
        static const QRegularExpression list(
            QStringLiteral(R"(^[(\[]([^()\[\]]{1,200})[)\]]\s*(\^\(?\s*T?\s*\)?|')?)"));
        const auto match = list.match(text);
        if (!match.hasMatch()) return false;
        static const QRegularExpression comma(QStringLiteral("[,;]"));
        const QStringList parts = match.captured(1).split(comma);
        if (parts.size() != qsizetype(dim)) return false;
        std::vector<double> numbers;
        for (const QString& part : parts)
            if (const auto number = numberOf(part.trimmed())) numbers.push_back(sign * *number);
        const QString behindIt = text.sliced(match.capturedEnd()).trimmed();
        if (numbers.size() != dim || behindIt.startsWith(u'+') || behindIt.startsWith(u'-')) return false;
        vector = std::move(numbers);
        return true;
    }

    bool takeColumn(const Matrix& column, double factor, std::vector<double>& vector) {
        m_end = column.end;
        ++m_next;
        QString rest = behind(m_end);
        while (rest.startsWith(u')') || rest.startsWith(u']'))
            rest = rest.sliced(1).trimmed();
        if (column.columns > 1 && !rest.startsWith(u'^')) return false; // a row, not turned
        if (column.columns == 1 && rest.startsWith(u'^')) return false;
        if (rest.startsWith(u'+') || rest.startsWith(u'*')) return false;
        for (const double number : column.numbers)
            vector.push_back(factor * number);
        return true;
    }

    // The row of a formula that moves the point but has no matrix; empty without one.
    static QString lostRow(const QString& between) {
        static const QRegularExpression moved(QStringLiteral(
            R"([=→][^=→]*\d[^=→]*(?<![A-Za-z(])x(?![A-Za-z'])(?!(_?\w|_?\([^)]*\)|')*\s*&?\s*[=→:]))"));
        for (const QString& row : between.split(u';'))
            if (row.contains(moved)) return row.trimmed();
        return {};
    }

    // Among maps of a point, a matrix by itself may be anything.
    void sayWhichIsAlone() {
        if (!m_hasPoints || m_alone < 0) return;
        m_row = m_alone + 1;
        m_line = m_maps[std::size_t(m_alone)].line;
        m_problem = m_between[m_alone].simplified().right(longestHead);
    }

    void fail(const QString& what) {
        if (m_problem.isEmpty()) m_problem = what.isEmpty() ? QStringLiteral("?") : what;
    }

    static constexpr qsizetype longestHead = 40;
    static constexpr qsizetype longestGap = 400; // beside a matrix

    const QString& m_text;
    std::vector<Matrix> m_matrices;
    std::size_t m_next = 0;
    qsizetype m_before = 0; // end of the last map
    qsizetype m_end = 0;    // end of what the current map has taken
    qsizetype m_seen = 0;   // end of the matrix before
    qsizetype m_counted = 0;
    int m_line = 1;
    int m_row = 0; // row of the problem; 0: the next one
    QString m_problem;
    QStringList m_between;
    bool m_hasPoints = false; // some maps say which point they move
    int m_alone = -1;         // index of the first matrix with a mere name, D =
    std::vector<WrittenMap> m_maps;
};

// \binom10 and {1 \choose 0} as vectors.
QString withBinomials(QString text) {
    static const QRegularExpression binomial(
        QStringLiteral(R"(\\[td]?binom\s*(?:\{([^{}]{1,60})\}|(\d))\s*(?:\{([^{}]{1,60})\}|(\d)))"));
    static const QRegularExpression choice(QStringLiteral(R"(\{([^{}]{1,60})\\choose\b([^{}]{1,60})\})"));
    text.replace(binomial, QStringLiteral("\\begin{pmatrix}\\1\\2\\\\\\\\\\3\\4\\end{pmatrix}"));
    return text.replace(choice, QStringLiteral("\\begin{pmatrix}\\1\\\\\\\\\\2\\end{pmatrix}"));
}

} // namespace

WrittenMaps matrixMaps(const QString& source) {
    if (!source.contains(QStringLiteral("\\begin{"))) return {};
    const QString text = withFactorsAsMatrices(withBinomials(withoutLatexComments(source)));
    return MatrixReader(text).read();
}

} // namespace io
