// SPDX-License-Identifier: MIT
#include "render/rest_cage.h"

#include "options/tr.h"
#include "options/usage_error.h"

#include <QString>

namespace cli {

namespace {

// N of "hull:N".
int fittedCorners(const std::string& id, const document::CornerCounts& counts, const QString& where,
                  const std::string& text) {
    bool isNumber = false;
    const int corners = QString::fromStdString(text).toInt(&isNumber);
    if (!isNumber || corners < counts.least || corners > counts.most)
        throw UsageError{tr("--rest-cage %1:N%2 must have %3 to %4 corners, not “%5”.")
                             .arg(QString::fromStdString(id), where)
                             .arg(counts.least)
                             .arg(counts.most)
                             .arg(QString::fromStdString(text))};
    return corners;
}

} // namespace

template <int Dim> std::optional<AskedFit<Dim>> askedFit(const std::string& text) {
    const QString where = Dim == 2 ? QString() : u' ' + tr("in space");
    const std::size_t colon = text.find(':');
    const std::string id = text.substr(0, colon);
    for (const auto& fit : document::cageFits<Dim>()) {
        if (id.empty() || id != fit.id) continue;
        if (colon == std::string::npos) return AskedFit<Dim>{fit, fit.corners.usual};
        if (fit.corners.offered.empty()) continue;
        return AskedFit<Dim>{fit, fittedCorners(id, fit.corners, where, text.substr(colon + 1))};
    }
    return std::nullopt;
}

template std::optional<AskedFit<2>> askedFit<2>(const std::string&);
template std::optional<AskedFit<3>> askedFit<3>(const std::string&);

} // namespace cli
