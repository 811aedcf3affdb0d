// SPDX-License-Identifier: MIT
#include "identity.h"

namespace resources {

QString applicationId() {
    return QStringLiteral(BARYCAGE_APPLICATION_ID);
}

QString applicationName() {
    return QStringLiteral("Barycage");
}

QString version() {
    return QStringLiteral(BARYCAGE_VERSION);
}

} // namespace resources
