// SPDX-License-Identifier: MIT
#include "io/text/typed_coefficient.h"

#include "entry/text/typed_coefficient.h"

#include <QByteArray>
#include <QString>

namespace io {

std::optional<ifs::TypedCoefficient> typedCoefficient(int which, QStringView text) {
    return entry::typedCoefficient(which, text.toString().simplified().toUtf8().toStdString());
}

} // namespace io
