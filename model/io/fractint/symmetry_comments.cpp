// SPDX-License-Identifier: MIT
#include "io/fractint/symmetry_comments.h"

#include "document/text/text.h"
#include "io/text/metadata_line.h"
#include "io/text/number.h"
#include "io/text/symmetry_text.h"

namespace io {

namespace {

constexpr std::size_t maxFrameNumbers = 9; // numbers of a frame in space

template <int Dim>
std::optional<ifs::Symmetry<Dim>> symmetryOf(const QByteArray& name, const std::vector<double>& centre,
                                             const std::vector<double>& frame) {
    const auto named = symmetryNamed(QString::fromLatin1(name));
    if (!named || named->group == ifs::SymmetryGroup::None || !named->centre.empty()) return std::nullopt;
    auto symmetry = symmetryIn<Dim>(*named);
    if (!symmetry || (!centre.empty() && centre.size() != Dim) ||
        (!frame.empty() && frame.size() != Dim * Dim))
        return std::nullopt;
    if (!centre.empty()) symmetry->centre = Eigen::Map<const ifs::Vector<Dim>>(centre.data());
    if (!frame.empty())
        symmetry->frame = Eigen::Map<const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>>(frame.data());
    return ifs::isValid(*symmetry) ? symmetry : std::nullopt;
}

} // namespace

template <int Dim> QByteArrayList symmetryComments(const ifs::Symmetry<Dim>& symmetry) {
    if (symmetry.group == ifs::SymmetryGroup::None) return {};
    QByteArray name = symmetryName(symmetry.group, symmetry.order).toLatin1();
    if (symmetry.angle != 0 && symmetry.group != ifs::SymmetryGroup::Rotation)
        name += ':' + formatNumber(symmetry.angle);
    QByteArrayList lines{metadataLine("symmetry", name)};
    QByteArrayList centre, frame;
    for (int i = 0; i < Dim; ++i) {
        centre << formatNumber(symmetry.centre[i]);
        for (int j = 0; j < Dim; ++j)
            frame << formatNumber(symmetry.frame(i, j));
    }
    if (symmetry.centre != ifs::Vector<Dim>::Zero()) lines << metadataLines("symmetry-centre", centre);
    if (symmetry.frame != ifs::Matrix<Dim>::Identity()) lines << metadataLines("symmetry-frame", frame);
    return lines;
}
template QByteArrayList symmetryComments<2>(const ifs::Symmetry<2>&);
template QByteArrayList symmetryComments<3>(const ifs::Symmetry<3>&);

bool SymmetryComments::readNumbers(const QByteArrayList& values, std::vector<double>& numbers) {
    for (const QByteArray& value : values) {
        const auto number = parseNumber(QString::fromLatin1(value));
        if (!number || numbers.size() == maxFrameNumbers) return false;
        numbers.push_back(*number);
    }
    return !values.isEmpty();
}

bool SymmetryComments::read(const QByteArray& key, const QByteArrayList& values, std::size_t line) {
    if (key == "symmetry") {
        m_isUnderstood = m_isUnderstood && m_name.isEmpty() && values.size() == 1;
        m_name = values.value(0);
    } else if (key == "symmetry-centre") {
        m_isUnderstood = readNumbers(values, m_centre) && m_isUnderstood;
    } else if (key == "symmetry-frame") {
        m_isUnderstood = readNumbers(values, m_frame) && m_isUnderstood;
    } else {
        return false;
    }
    m_lines.push_back(line);
    return true;
}

template <int Dim>
std::optional<QString> SymmetryComments::applyTo(ifs::IteratedFunctionSystem<Dim>& system) const {
    if (m_lines.empty()) return std::nullopt;
    const auto symmetry = m_isUnderstood ? symmetryOf<Dim>(m_name, m_centre, m_frame) : std::nullopt;
    if (!symmetry)
        return Text::tr("The stored symmetry “%1” is not valid for this entry and is not applied; its lines "
                        "are kept. A rotation repeats each map 2 to %2 times; polyhedra belong to space.")
            .arg(QString::fromLatin1(m_name), QString::number(ifs::maxSymmetryOrder));
    ifs::IteratedFunctionSystem<Dim> tried;
    tried.maps.resize(system.maps.size());
    tried.symmetry = *symmetry;
    if (ifs::copiesOfEachMap(tried) == 1)
        return Text::tr(
                   "With its stored symmetry the entry would have more than %1 maps, which is the limit. The "
                   "symmetry is not applied; its lines are kept.")
            .arg(ifs::maxSymmetricMaps);
    system.symmetry = *symmetry;
    return std::nullopt;
}
template std::optional<QString> SymmetryComments::applyTo<2>(ifs::IteratedFunctionSystem<2>&) const;
template std::optional<QString> SymmetryComments::applyTo<3>(ifs::IteratedFunctionSystem<3>&) const;

} // namespace io
