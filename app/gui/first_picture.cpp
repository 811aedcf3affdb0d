// SPDX-License-Identifier: MIT
#include "first_picture.h"

#include "document/fractal/fractal_geometry.h"
#include "io/fractint/fractint_reader.h"
#include "io/picture/plane_export.h"

#include <QFile>

FirstPicture firstPicture() {
    QFile resource(QStringLiteral(":/ifs_library/paper.ifs"));
    if (!resource.open(QIODevice::ReadOnly)) return {};
    FirstPicture first{io::readFractint(resource.readAll())};
    for (const document::Entry& entry : first.file.entries)
        if (entry.fractal->name == QLatin1String("maple")) first.maple = entry.id;
    return first;
}

io::Failure drawFirstPicture(const QString& path) {
    const FirstPicture first = firstPicture();
    if (first.maple == document::EntryId::None)
        return QStringLiteral("The maple is missing in this program.");
    const document::Fractal& maple = *first.file.entries[document::indexOf(first.file, first.maple)].fractal;
    attractor::Camera camera;
    camera.width = 1600;
    camera.height = 1200;
    if (const auto box = document::displayedBox(maple))
        camera = attractor::fitted(camera, box->min, box->max);
    io::PlaneExport picture{maple, document::renderRequest(maple, camera), {}};
    picture.request.threads = io::threadsOfThisMachine();
    picture.request.samples = 40ULL * std::uint64_t(camera.width) * std::uint64_t(camera.height);
    return io::exportPlane(picture, path).failure;
}
