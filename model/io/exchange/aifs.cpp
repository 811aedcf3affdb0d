// SPDX-License-Identifier: MIT
#include "io/exchange/aifs.h"

#include "document/fractal/fractal_geometry.h"
#include "io/text/export_weights.h"

#include <QSet>

#include <array>
#include <charconv>

namespace io {

namespace {

// A number without an exponent, which IFStile does not promise to read.
QByteArray plain(double value) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0 ? 0.0 : value,
                                   std::chars_format::fixed);
    return {buffer.data(), end.ptr - buffer.data()};
}

template <typename Values> QByteArray list(const Values& values) {
    QByteArrayList texts;
    for (const double value : values)
        texts << plain(value);
    return '[' + texts.join(',') + ']';
}

QByteArray text(const RowStochastic& s) {
    QByteArrayList rows;
    for (int j = 0; j < 3; ++j)
        rows << list(std::array{s(j, 0), s(j, 1), s(j, 2)});
    return '[' + rows.join(',') + ']';
}

// A letter, then letters, digits and underscores; that of no other block.
QByteArray identifier(const QString& name, QSet<QByteArray>& taken) {
    QByteArray id;
    for (const QChar c : name)
        id += c.unicode() < 0x80 && c.isLetterOrNumber() ? c.toLatin1() : '_';
    if (id.isEmpty() || id[0] == '_' || (id[0] >= '0' && id[0] <= '9')) id.prepend("s_");
    QByteArray unique = id;
    for (int number = 2; taken.contains(unique); ++number)
        unique = id + '_' + QByteArray::number(number);
    taken.insert(unique);
    return unique;
}

// The text on one line without '#', which begins a comment.
QByteArray shownName(QString text) {
    for (QChar& c : text) {
        if (c.category() == QChar::Other_Control) c = u' ';
        if (c == u'#') c = u'_';
    }
    return text.toUtf8();
}

// Comments with the corners and the matrices of the affine invariant form, where a triangle holds the system.
QByteArray invariantForm(const document::Fractal& fractal, const document::System2& system,
                         const std::vector<double>& weights) {
    const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    if (cage.rest.size() != 3) return {};
    const auto form = affineInvariantForm(system, {cage.rest[0], cage.rest[1], cage.rest[2]});
    QByteArray text = "# control triangle at rest:";
    for (const auto& vertex : form.simplex)
        text += ' ' + list(std::array{vertex.x(), vertex.y()});
    text += "\n# row j of S: barycentric coordinates of the image of vertex j\n";
    for (std::size_t i = 0; i < form.maps.size(); ++i)
        if (weights[i] > 0)
            text += "# S" + QByteArray::number(qulonglong(i) + 1) + '=' + io::text(form.maps[i]) + '\n';
    return text;
}

template <int Dim>
QByteArray block(const document::Fractal& fractal, const ifs::IteratedFunctionSystem<Dim>& system,
                 QSet<QByteArray>& taken) {
    const std::vector<double> weights = exportWeights(system);
    QByteArray text = '@' + identifier(fractal.name, taken) + ":\n$dim=" + QByteArray::number(Dim) +
                      "\n$n=" + shownName(fractal.name) + '\n';
    QByteArrayList names;
    QByteArrayList shares;
    for (std::size_t i = 0; i < system.maps.size(); ++i) {
        if (!(weights[i] > 0)) continue;
        const auto& [linear, translation] = system.maps[i].map;
        names << 'f' + QByteArray::number(qulonglong(i) + 1);
        shares << plain(weights[i]);
        text += names.last() + '=' + list(translation) + '*' +
                list(linear.template reshaped<Eigen::RowMajor>().eval()) + '\n';
    }
    text += "A=(" + names.join('|') + ")*A\n# weights: " + shares.join(' ') + '\n';
    if constexpr (Dim == 2) text += invariantForm(fractal, system, weights);
    return text;
}

} // namespace

AffineInvariantForm affineInvariantForm(const document::System2& system, const ifs::Simplex<2>& simplex) {
    AffineInvariantForm form{simplex, {}};
    for (const auto& weighted : system.maps)
        form.maps.push_back(ifs::rowStochastic<2>(simplex, weighted.map));
    return form;
}

QByteArray writeAifs(const QList<std::shared_ptr<const document::Fractal>>& fractals) {
    QByteArrayList blocks;
    QSet<QByteArray> taken;
    const auto add = [&](const document::Fractal& fractal, const auto* system) {
        if (system && !ifs::activeMaps(*system).maps.empty()) blocks << block(fractal, *system, taken);
    };
    for (const auto& fractal : fractals) {
        add(*fractal, document::system2(*fractal));
        add(*fractal, document::system3(*fractal));
    }
    return blocks.join('\n');
}

} // namespace io
