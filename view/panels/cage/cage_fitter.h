// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/cage_edits.h"
#include "document/edits/space_cage_edits.h"

#include <QFutureWatcher>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

namespace view {

// Replaces the cage by one fitted to the picture, as one step of the history, or says why not.
class CageFitter : public QObject {
    Q_OBJECT

public:
    explicit CageFitter(document::Document* document);

    void fit(document::SimplexChoice choice);
    void fit(document::PolygonChoice choice, int corners = 4);
    void fitTetrahedron(const std::optional<ifs::Orientation<3>>& orientation = {}); // in space; the smallest
    void fitBox();
    void fitPolyhedron(document::SpacePolyhedron choice, int corners);

signals:
    void message(const QString& text);

private:
    // A fractal in space, and what it is with another cage; nullopt where there is none.
    struct Fitted {
        std::shared_ptr<const document::Fractal> from;
        std::optional<document::Fractal> to;
    };
    using Fitting = std::function<std::optional<document::Fractal>(const document::Fractal&)>;
    void fitInSpace(const Fitting& fitting);
    void takeFitted();
    void fitTo(std::optional<document::Fractal> fitted, const QString& obstacle); // nullopt: says why

    document::Document* m_document;
    QFutureWatcher<Fitted> m_fitting;
    bool m_isFitting = false; // nobody has taken what m_fitting finds
};

} // namespace view
