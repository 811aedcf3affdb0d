// SPDX-License-Identifier: MIT
#include "io/text/symmetry_text.h"

#include "document/text/text.h"
#include "io/text/number.h"

#include <QStringList>

#include <algorithm>
#include <array>

namespace io {

namespace {

using enum ifs::SymmetryGroup;

struct GroupName {
    ifs::SymmetryGroup group;
    const char* name;
};
constexpr std::array groupNames{GroupName{None, "none"}, GroupName{Mirror, "mirror"},
                                GroupName{Tetrahedral, "tetrahedral"}, GroupName{Octahedral, "octahedral"},
                                GroupName{Icosahedral, "icosahedral"}};

bool readGroup(QStringView name, NamedSymmetry& result) {
    for (const GroupName& known : groupNames)
        if (name.compare(QLatin1String(known.name), Qt::CaseInsensitive) == 0) {
            result.group = known.group;
            return true;
        }
    if (name.size() < 2 || name.size() > 3) return false;
    const QChar letter = name.front().toLower();
    if (letter != u'c' && letter != u'd') return false;
    if (!std::ranges::all_of(name.sliced(1), [](QChar c) { return c >= u'0' && c <= u'9'; })) return false;
    result.group = letter == u'c' ? Rotation : Dihedral;
    result.order = name.sliced(1).toInt();
    return result.order >= ifs::minSymmetryOrder && result.order <= ifs::maxSymmetryOrder;
}

bool readCentre(QStringView text, NamedSymmetry& result) {
    for (const QStringView part : text.split(u',')) {
        const auto coordinate = parseNumber(part);
        if (!coordinate) return false;
        result.centre.push_back(*coordinate);
    }
    return result.centre.size() == 2 || result.centre.size() == 3;
}

template <int Dim> QString pointText(const ifs::Vector<Dim>& point) {
    QStringList numbers;
    for (int i = 0; i < Dim; ++i)
        numbers << QString::number(point[i], 'g', 6);
    return u'(' + numbers.join(QStringLiteral(", ")) + u')';
}

} // namespace

std::optional<NamedSymmetry> symmetryNamed(QStringView text) {
    NamedSymmetry result;
    text = text.trimmed();
    if (const qsizetype at = text.indexOf(u'@'); at >= 0) {
        if (!readCentre(text.sliced(at + 1), result)) return std::nullopt;
        text.truncate(at);
    }
    if (const qsizetype colon = text.indexOf(u':'); colon >= 0) {
        result.angle = parseNumber(text.sliced(colon + 1));
        if (!result.angle) return std::nullopt;
        text.truncate(colon);
    }
    if (!readGroup(text, result)) return std::nullopt;
    if (result.angle && result.group != Mirror && result.group != Dihedral) return std::nullopt;
    return result;
}

template <int Dim> std::optional<ifs::Symmetry<Dim>> symmetryIn(const NamedSymmetry& named) {
    if (named.centre.size() > Dim) return std::nullopt;
    ifs::Symmetry<Dim> symmetry{named.group, named.order, named.angle.value_or(0)};
    if (named.group == None) return symmetry;
    for (std::size_t i = 0; i < named.centre.size(); ++i)
        symmetry.centre[Eigen::Index(i)] = named.centre[i];
    return ifs::isValid(symmetry) ? std::optional(symmetry) : std::nullopt;
}
template std::optional<ifs::Symmetry<2>> symmetryIn<2>(const NamedSymmetry&);
template std::optional<ifs::Symmetry<3>> symmetryIn<3>(const NamedSymmetry&);

QString symmetryName(ifs::SymmetryGroup group, int order) {
    if (group == Rotation) return QStringLiteral("c%1").arg(order);
    if (group == Dihedral) return QStringLiteral("d%1").arg(order);
    return QLatin1String(std::ranges::find(groupNames, group, &GroupName::group)->name);
}

template <int Dim> QString symmetrySentence(const ifs::Symmetry<Dim>& symmetry) {
    const QString centre = pointText<Dim>(symmetry.centre);
    const QString angle = QString::number(symmetry.angle, 'g', 6);
    const QString frame =
        symmetry.frame == ifs::Matrix<Dim>::Identity() ? QString() : Text::tr(", in a frame of its own");
    switch (symmetry.group) {
    case None:
        break;
    case Mirror:
        return Text::tr("mirror at %1° through %2").arg(angle, centre) + frame;
    case Rotation:
        return Text::tr("%1-fold rotation about %2").arg(symmetry.order).arg(centre) + frame;
    case Dihedral:
        return Text::tr("%1-fold dihedral about %2, a mirror at %3°").arg(symmetry.order).arg(centre, angle) +
               frame;
    case Tetrahedral:
        return Text::tr("rotations of the tetrahedron about %1").arg(centre) + frame;
    case Octahedral:
        return Text::tr("rotations of the octahedron about %1").arg(centre) + frame;
    case Icosahedral:
        return Text::tr("rotations of the icosahedron about %1").arg(centre) + frame;
    }
    return Text::tr("none");
}
template QString symmetrySentence<2>(const ifs::Symmetry<2>&);
template QString symmetrySentence<3>(const ifs::Symmetry<3>&);

} // namespace io
