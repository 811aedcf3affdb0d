// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/space_cage_edits.h"
#include "widgets/background/background_edit.h"

#include <QObject>
#include <QString>

#include <optional>

namespace view {

// Replaces the cage by one fitted to the picture, as one step of the history, or says why not.
class CageFitter : public QObject {
    Q_OBJECT

public:
    explicit CageFitter(document::Document* document);

    void fit(document::SimplexChoice choice);
    void fit(document::PolygonChoice choice, int corners = 4);
    // Space only; nullopt: smallest of all orientations.
    void fitTetrahedron(const std::optional<ifs::Orientation<3>>& orientation = {});
    void fitBox();
    void fitPolyhedron(document::SpacePolyhedron choice, int corners);

signals:
    void message(const QString& text);

private:
    void fitInSpace(BackgroundEdit::Find find);
    // Nullopt: shows the obstacle.
    void fitTo(std::optional<document::Fractal> fitted, const QString& obstacle);

    document::Document* m_document;
    BackgroundEdit m_fitting; // fits in space, which are slow for very many maps
};

} // namespace view
