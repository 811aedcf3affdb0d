// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"

#include <QWidget>

class QGridLayout;
class QLabel;

namespace view {

class NumberField;

// Position and speed of one map on the palette; shown while these make the colours of the picture. Each field
// edit is live and one undo step.
class MapBlendRow : public QWidget {
    Q_OBJECT

public:
    explicit MapBlendRow(document::Document* document, QWidget* parent = nullptr);

    void setMap(ifs::MapId id); // MapId::None: nothing to edit
    NumberField* coordinate() const { return m_coordinate; }
    NumberField* speed() const { return m_speed; }

private:
    NumberField* makeField(QGridLayout* grid, const QString& name, const QString& tip,
                           double attractor::MapBlend::*part);
    QString placeOf(const NumberField* field) const; // place in document::TypedNumbers
    void follow();
    int rowOfMap() const; // −1: none
    attractor::MapBlend blendOf(const document::Fractal& fractal, int row) const;

    document::Document* m_document;
    document::LiveEdit m_edit;
    ifs::MapId m_id = ifs::MapId::None;
    NumberField* m_coordinate;
    NumberField* m_speed;
    QLabel* m_swatch; // colour at the coordinate
};

} // namespace view
