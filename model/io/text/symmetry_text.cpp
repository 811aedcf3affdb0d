// SPDX-License-Identifier: MIT
#include "io/text/symmetry_text.h"

#include "document/text/text.h"
#include <QByteArray>
#include <QStringList>

namespace io {

namespace {

using enum ifs::SymmetryGroup;

template <int Dim> QString pointText(const ifs::Vector<Dim>& point) {
    QStringList numbers;
    for (int i = 0; i < Dim; ++i)
        numbers << QString::number(point[i], 'g', 6);
    return u'(' + numbers.join(QStringLiteral(", ")) + u')';
}

} // namespace

std::optional<NamedSymmetry> symmetryNamed(QStringView text) {
    return notation::symmetryNamed(text.trimmed().toUtf8().toStdString());
}

QString symmetryName(ifs::SymmetryGroup group, int order) {
    return QString::fromStdString(notation::symmetryName(group, order));
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
