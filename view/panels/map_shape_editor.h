// SPDX-License-Identifier: MIT
#pragma once

#include "ifs/decomposition.h"
#include "panels/live_edit.h"

#include <QWidget>

#include <array>

class QLabel;

namespace view {

class NumberField;

// One map as rotation, scale, shear and translation (shear acts first, translation last): the same map as its
// row a … f, in other words. Angles in degrees, counter-clockwise with y up. Each field edit is live and one
// undo step.
class MapShapeEditor : public QWidget {
    Q_OBJECT

public:
    explicit MapShapeEditor(document::Document* document, QWidget* parent = nullptr);

    void setMap(ifs::MapId id); // MapId::None: nothing to edit
    enum Part { Rotation, ScaleX, ScaleY, Shear, TranslationX, TranslationY, PartCount };
    NumberField* field(Part part) const { return m_fields[part]; }

private:
    using Parts = std::array<double, PartCount>;
    void addField(Part part, const QString& name, const QString& tip, int row, int column);
    void follow();
    void edit(Part part, double value);
    const ifs::WeightedMap<2>* map() const;

    static Parts partsOf(const ifs::AffineMap<2>& map);
    static ifs::Matrix<2> linearPartOf(const Parts& parts);

    document::Document* m_document;
    LiveEdit m_edit;
    ifs::MapId m_id = ifs::MapId::None;
    Parts m_parts{}; // as shown; kept while they give the map, so that what was typed stays as it was typed
    QLabel* m_title;
    std::array<NumberField*, PartCount> m_fields{};
};

} // namespace view
