// SPDX-License-Identifier: MIT
#include "io/text/typed_coefficient.h"

#include "notation/text/typed_coefficient.h"

#include <QByteArray>
#include <QString>

namespace io {

std::optional<ifs::TypedCoefficient> typedCoefficient(int which, QStringView text) {
    return notation::typedCoefficient(which, text.toString().simplified().toUtf8().toStdString());
}

} // namespace io
