// SPDX-License-Identifier: MIT
#include "io/palette/palette_ugr.h"

#include "document/text/text.h"
#include "io/palette/palette_stops.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace io {

namespace {

using attractor::Palette;
using attractor::Rgba;
using document::Problem;

constexpr int circle = 400; // colours on the circle
constexpr std::size_t maxPalettes = 4000;
constexpr qsizetype maxUgrProblems = 10;

// Words of the text: { and } on their own, key=value (the value possibly in quotes), everything else by
// blanks. Comments run from a semicolon to the end of the line.
class Words {
public:
    explicit Words(const QByteArray& text) : m_text(text) {}

    QByteArray next() { // empty at the end
        skip();
        m_wordLine = m_line;
        const qsizetype begin = m_at;
        if (m_at < m_text.size() && (m_text[m_at] == '{' || m_text[m_at] == '}'))
            ++m_at;
        else
            while (m_at < m_text.size() && !ends(m_text[m_at])) {
                if (m_text[m_at] == '"') skipQuoted();
                if (m_at < m_text.size()) ++m_at;
            }
        return m_text.sliced(begin, m_at - begin);
    }
    int line() const { return m_wordLine; }
    QByteArray restOfLine() { // ends at a brace or a comment
        const qsizetype begin = m_at;
        while (m_at < m_text.size() && m_text[m_at] != '\n' && m_text[m_at] != '{' && m_text[m_at] != ';')
            ++m_at;
        return m_text.sliced(begin, m_at - begin);
    }

private:
    static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    static bool ends(char c) { return blank(c) || c == '{' || c == '}' || c == ';'; }
    void skipQuoted() { // ends at the closing quote on the same line
        qsizetype end = m_at + 1;
        while (end < m_text.size() && m_text[end] != '"' && m_text[end] != '\n')
            ++end;
        if (end < m_text.size() && m_text[end] == '"') m_at = end;
    }
    void skip() {
        while (m_at < m_text.size() && (blank(m_text[m_at]) || m_text[m_at] == ';')) {
            if (m_text[m_at] == ';')
                while (m_at + 1 < m_text.size() && m_text[m_at + 1] != '\n')
                    ++m_at;
            m_line += m_text[m_at] == '\n' ? 1 : 0;
            ++m_at;
        }
    }

    const QByteArray& m_text;
    qsizetype m_at = 0;
    int m_line = 1;
    int m_wordLine = 1;
};

struct Gradient {
    QString name;
    int line = 0;
    bool smooth = false;
    int rotation = 0;
    std::map<int, Rgba> knots; // colours by index on the circle
};

int onCircle(long long index) {
    return int((index % circle + circle) % circle);
}

// Through knots around a circle: by straight lines, or by cubics that never leave the range of the two knots
// they join (Fritsch and Carlson 1980).
class Curve {
public:
    Curve(std::vector<double> at, std::vector<double> values, bool smooth)
        : m_at(std::move(at)), m_values(std::move(values)), m_slopes(m_at.size(), 0) {
        for (std::size_t i = 0; smooth && i < m_at.size(); ++i) {
            const double before = rise((i + m_at.size() - 1) % m_at.size());
            const double after = rise(i);
            if (before * after > 0) m_slopes[i] = 2 * before * after / (before + after);
        }
        m_smooth = smooth;
    }

    double operator()(double position) const {
        const auto above = std::upper_bound(m_at.begin(), m_at.end(), position);
        const std::size_t i = (above == m_at.begin() ? m_at.size() : std::size_t(above - m_at.begin())) - 1;
        const std::size_t j = (i + 1) % m_at.size();
        const double h = width(i);
        double t = position - m_at[i];
        if (t < 0) t += circle;
        t /= h;
        if (!m_smooth) return m_values[i] + t * (m_values[j] - m_values[i]);
        const double u = 1 - t;
        return u * u * (1 + 2 * t) * m_values[i] + t * t * (3 - 2 * t) * m_values[j] +
               h * t * u * (u * m_slopes[i] - t * m_slopes[j]);
    }

private:
    double width(std::size_t i) const {
        return i + 1 < m_at.size() ? m_at[i + 1] - m_at[i] : m_at.front() + circle - m_at[i];
    }
    double rise(std::size_t i) const {
        return (m_values[(i + 1) % m_values.size()] - m_values[i]) / width(i);
    }

    std::vector<double> m_at;
    std::vector<double> m_values;
    std::vector<double> m_slopes;
    bool m_smooth = false;
};

std::vector<Palette::Stop> stopsOf(const Gradient& gradient) {
    std::vector<double> at;
    std::array<std::vector<double>, 3> values;
    for (const auto& [index, colour] : gradient.knots) {
        at.push_back(index);
        values[0].push_back(colour.red);
        values[1].push_back(colour.green);
        values[2].push_back(colour.blue);
    }
    const std::array<Curve, 3> curves{Curve(at, values[0], gradient.smooth),
                                      Curve(at, values[1], gradient.smooth),
                                      Curve(at, values[2], gradient.smooth)};
    std::vector<Rgba> colours;
    for (int index = 0; index < circle; ++index) {
        const double from = onCircle((long long)index - gradient.rotation);
        const auto level = [&](std::size_t channel) {
            return std::uint8_t(std::clamp(std::lround(curves[channel](from)), 0L, 255L));
        };
        colours.push_back({level(0), level(1), level(2), 255});
    }
    return stopsThrough(colours);
}

class Reader {
public:
    Reader(const QByteArray& text, PaletteFile& file) : m_words(text), m_file(file) {}

    void read() {
        QByteArray name;
        for (QByteArray word = m_words.next(); !word.isEmpty(); word = m_words.next()) {
            if (word == "{")
                readEntry(std::exchange(name, {}));
            else
                name = word + m_words.restOfLine();
            if (m_file.palettes.size() >= maxPalettes) {
                report(
                    Problem::Severity::Warning,
                    Text::tr("The file has more than %1 palettes; the rest are ignored.").arg(maxPalettes));
                break;
            }
        }
        if (m_file.palettes.empty())
            report(Problem::Severity::Error, Text::tr("The file contains no gradients."));
    }

private:
    void report(Problem::Severity severity, const QString& message) {
        if (m_file.problems.size() < maxUgrProblems || severity == Problem::Severity::Error)
            m_file.problems << Problem{severity, {}, m_words.line(), 1, message};
    }

    void readEntry(const QByteArray& name) {
        Gradient gradient;
        gradient.name = QString::fromUtf8(name.left(200)).simplified();
        gradient.line = m_words.line();
        bool inGradient = false;
        int index = 0;
        QByteArray word = m_words.next();
        for (; !word.isEmpty() && word != "}"; word = m_words.next()) {
            if (word.endsWith(':') && !word.contains('='))
                inGradient = word.toLower() == "gradient:";
            else if (inGradient)
                readSetting(word, gradient, index);
        }
        if (word.isEmpty())
            report(Problem::Severity::Warning,
                   Text::tr("The gradient that starts in line %1 is not closed.").arg(gradient.line));
        if (!gradient.knots.empty())
            m_file.palettes.push_back({gradient.name.toStdString(), stopsOf(gradient)});
    }

    void readSetting(const QByteArray& word, Gradient& gradient, int& index) {
        const qsizetype equals = word.indexOf('=');
        if (equals <= 0) return;
        const QByteArray key = word.left(equals).toLower();
        QByteArray value = word.sliced(equals + 1);
        if (value.size() >= 2 && value.startsWith('"') && value.endsWith('"'))
            value = value.sliced(1, value.size() - 2);
        if (key == "title") {
            const QString title = QString::fromUtf8(value.left(200)).simplified();
            if (!title.isEmpty()) gradient.name = title;
        } else if (key == "smooth") {
            gradient.smooth = value.toLower() == "yes";
        } else if (key == "index" || key == "color" || key == "rotation") {
            readNumber(key, value, gradient, index);
        }
    }

    void readNumber(const QByteArray& key, const QByteArray& value, Gradient& gradient, int& index) {
        bool good = false;
        const long long number = value.toLongLong(&good);
        if (!good) {
            report(Problem::Severity::Warning,
                   Text::tr("“%1” is not a whole number.").arg(QString::fromUtf8(value.left(40))));
        } else if (key == "index") {
            index = onCircle(number);
        } else if (key == "rotation") {
            gradient.rotation = onCircle(number);
        } else { // red in the lowest byte
            const auto bits = std::uint32_t(number);
            gradient.knots[index] = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
                                     255};
        }
    }

    Words m_words;
    PaletteFile& m_file;
};

} // namespace

void readUltraFractalGradients(const QByteArray& text, PaletteFile& file) {
    Reader(text, file).read();
}

} // namespace io
