// SPDX-License-Identifier: MIT
#include "io/exchange/aifs_reader.h"

#include "document/text/text.h"
#include "io/fractint/fractint_entry.h"
#include "io/text/coefficient.h"
#include "io/text/number.h"

#include <QHash>

#include <algorithm>

namespace io {

namespace {

using document::Problem;

constexpr qsizetype maxQuoted = 60;

// "[1,2]" → 1, 2; nullopt for anything else.
std::optional<std::vector<double>> numbersOf(QByteArrayView text) {
    text = text.trimmed();
    if (text.size() < 2 || !text.startsWith('[') || !text.endsWith(']')) return std::nullopt;
    std::vector<double> numbers;
    for (const QByteArray& part : text.sliced(1, text.size() - 2).toByteArray().split(',')) {
        const auto number = parseNumber(QString::fromLatin1(part));
        if (!number || !isCoefficient(*number)) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

bool isIdentifier(QByteArrayView text) {
    return !text.isEmpty() && std::ranges::all_of(text, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

struct Map {
    std::vector<double> translation; // number of entries: the dimension
    std::vector<double> linear;      // number of entries: the dimension squared
};

// A block, read line by line.
class Block {
public:
    explicit Block(const QByteArray& id) : m_name(QString::fromUtf8(id)) {}

    void read(QByteArrayView line, int number) {
        line = line.trimmed();
        if (line.startsWith('#')) return readComment(line.sliced(1).trimmed());
        if (const qsizetype comment = line.indexOf('#'); comment >= 0 && !line.startsWith("$n="))
            line = line.first(comment).trimmed();
        if (line.isEmpty() || m_failure) return;
        const qsizetype equals = line.indexOf('=');
        const QByteArrayView name = line.first(std::max<qsizetype>(equals, 0)).trimmed();
        const QByteArrayView value = line.sliced(equals + 1).trimmed();
        if (name == "$n") {
            m_name = QString::fromUtf8(value);
        } else if (name == "$dim") {
            m_dimension = value == "3" ? 3 : 2;
            if (value != "2" && value != "3") fail(line, number);
        } else if (isIdentifier(name) && value.startsWith('(') && value.contains(')')) {
            readUnion(name, value, line, number);
        } else if (!isIdentifier(name) || !readMap(name, value)) {
            fail(line, number);
        }
    }

    document::Entry entry(std::uint32_t id) {
        auto fractal = std::make_shared<document::Fractal>();
        document::Entry entry;
        entry.id = static_cast<document::EntryId>(id);
        fractal->name = m_name;
        if (!m_failure && m_order.isEmpty()) fail({}, 0);
        if (!m_failure) {
            if (m_dimension == 3)
                fractal->shape = document::Shape<3>{systemOf<3>()};
            else
                fractal->shape = document::Shape<2>{systemOf<2>()};
        } else {
            m_failure->entry = m_name;
            entry.problems << *m_failure;
        }
        entry.fractal = std::move(fractal);
        return entry;
    }

    // Returns true for a block of settings only: the head of a file.
    bool isEmpty() const { return m_maps.isEmpty() && m_order.isEmpty() && !m_failure; }

private:
    void fail(QByteArrayView line, int number) {
        const QString sentence =
            line.isEmpty()
                ? Text::tr("The block names no maps: a line such as “A=(f1|f2)*A” is missing.")
                : Text::tr("“%1” is not understood: Barycage reads blocks of affine maps, such as "
                           "“f1=[e,f]*[a,b,c,d]” and “A=(f1|f2)*A”.")
                      .arg(QString::fromUtf8(line.first(std::min(line.size(), maxQuoted)).toByteArray()));
        m_failure = Problem{Problem::Severity::Error, {}, number, number > 0 ? 1 : 0, sentence};
    }

    bool readMap(QByteArrayView name, QByteArrayView value) {
        const qsizetype times = value.indexOf('*');
        const auto translation = numbersOf(value.first(std::max<qsizetype>(times, 0)));
        const auto linear = numbersOf(value.sliced(times + 1));
        const auto dimension = std::size_t(m_dimension);
        if (times < 0 || !translation || !linear || translation->size() != dimension ||
            linear->size() != dimension * dimension || m_maps.contains(name.toByteArray()))
            return false;
        m_maps.insert(name.toByteArray(), {*translation, *linear});
        return true;
    }

    // "A=(f1|f2)*A"
    void readUnion(QByteArrayView name, QByteArrayView value, QByteArrayView line, int number) {
        const qsizetype close = value.indexOf(')');
        const QByteArray after = value.sliced(close + 1).toByteArray().replace(' ', "");
        if (after != "*" + name.toByteArray() || !m_order.isEmpty()) return fail(line, number);
        for (const QByteArray& part : value.sliced(1, close - 1).toByteArray().split('|')) {
            const QByteArray map = part.trimmed();
            if (!m_maps.contains(map) || std::size_t(m_order.size()) >= fractint::maxMaps) {
                m_order.clear();
                return fail(line, number);
            }
            m_order << map;
        }
    }

    void readComment(QByteArrayView comment) {
        constexpr QByteArrayView key = "weights:";
        if (!comment.startsWith(key)) return;
        m_weights.clear();
        for (const QByteArray& part : comment.sliced(key.size()).toByteArray().simplified().split(' '))
            if (const auto weight = parseNumber(QString::fromLatin1(part)); weight && isCoefficient(*weight))
                m_weights.push_back(*weight);
    }

    template <int Dim> ifs::IteratedFunctionSystem<Dim> systemOf() const {
        ifs::IteratedFunctionSystem<Dim> system;
        const bool hasWeights = m_weights.size() == std::size_t(m_order.size());
        for (qsizetype i = 0; i < m_order.size(); ++i) {
            const Map& values = *m_maps.constFind(m_order[i]);
            ifs::WeightedMap<Dim> map;
            map.id = static_cast<ifs::MapId>(i + 1);
            for (int k = 0; k < Dim * Dim; ++k)
                map.map.linear(k / Dim, k % Dim) = values.linear[std::size_t(k)];
            for (int k = 0; k < Dim; ++k)
                map.map.translation[k] = values.translation[std::size_t(k)];
            if (hasWeights) map.weight = m_weights[std::size_t(i)];
            system.maps.push_back(map);
        }
        return system;
    }

    QString m_name;
    int m_dimension = 2;
    QHash<QByteArray, Map> m_maps;
    QByteArrayList m_order; // order of the union
    std::vector<double> m_weights;
    std::optional<Problem> m_failure; // first failure
};

// "@id:" alone on a line.
std::optional<QByteArray> headingOf(QByteArrayView line) {
    line = line.trimmed();
    if (!line.startsWith('@') || !line.endsWith(':')) return std::nullopt;
    const QByteArray id = line.sliced(1, line.size() - 2).trimmed().toByteArray();
    return isIdentifier(id) ? std::optional(id) : std::nullopt;
}

QByteArrayView withoutMark(QByteArrayView bytes) {
    return bytes.startsWith("\xef\xbb\xbf") ? bytes.sliced(3) : bytes;
}

QByteArrayView nextLine(QByteArrayView& rest) {
    const qsizetype end = rest.indexOf('\n');
    const QByteArrayView line = end < 0 ? rest : rest.first(end);
    rest = end < 0 ? QByteArrayView() : rest.sliced(end + 1);
    return line;
}

} // namespace

document::FractalFile readAifs(const QByteArray& bytes) {
    document::FractalFile file;
    std::optional<Block> block;
    std::uint32_t id = 0;
    const auto finish = [&] {
        if (block && !block->isEmpty()) file.entries << block->entry(++id);
    };
    int number = 0;
    for (QByteArrayView rest = withoutMark(bytes); !rest.isEmpty();) {
        const QByteArrayView line = nextLine(rest);
        ++number;
        if (const auto heading = headingOf(line)) {
            finish();
            block.emplace(*heading);
            if (file.entries.size() < fractint::maxEntries) continue;
            block.reset();
            file.problems << Problem{
                Problem::Severity::Error,
                {},
                number,
                1,
                Text::tr("The file has more than %1 blocks, which is the limit; the rest "
                         "was not read.")
                    .arg(fractint::maxEntries)};
            break;
        }
        if (!block) block.emplace(QByteArrayLiteral("aifs"));
        block->read(line, number);
    }
    finish();
    if (file.entries.isEmpty())
        file.problems << Problem{
            Problem::Severity::Error, {}, 0, 0, Text::tr("This IFStile file contains no affine system.")};
    return file;
}

bool looksLikeAifs(const QByteArray& bytes) {
    QByteArrayView rest = withoutMark(bytes);
    while (!rest.isEmpty()) {
        const QByteArrayView line = nextLine(rest).trimmed();
        if (line.isEmpty() || line.startsWith('#')) continue;
        return headingOf(line).has_value() || line.startsWith("$dim=") || line.startsWith("$n=");
    }
    return false;
}

} // namespace io
