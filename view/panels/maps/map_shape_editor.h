// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/live_edit.h"
#include "document/edits/maps/map_shape.h"

#include <QWidget>

#include <array>
#include <map>
#include <tuple>
#include <vector>

class QLabel;

namespace view {

class MapBlendRow;
class NumberField;

// A map as rotation, scale, shear and translation (shear acts first, translation last): the same map as its
// row in the table, in other words; and below, its place on the palette. Angles in degrees, counter-clockwise
// with y up; in space, counter-clockwise as seen from the tip of the axis. Each field edit is live and one
// undo step.
class MapShapeEditor : public QWidget {
    Q_OBJECT

public:
    explicit MapShapeEditor(document::Document* document, QWidget* parent = nullptr);

    void setMap(ifs::MapId id); // MapId::None: nothing to edit
    enum Part { Rotation, ScaleX, ScaleY, Shear, TranslationX, TranslationY, PartCount };
    // The axis is a direction of any length. A shear is what the second coordinate adds to the first.
    enum SpacePart {
        AxisX,
        AxisY,
        AxisZ,
        Angle,
        SpaceScaleX,
        SpaceScaleY,
        SpaceScaleZ,
        ShearXY,
        ShearXZ,
        ShearYZ,
        SpaceTranslationX,
        SpaceTranslationY,
        SpaceTranslationZ,
        SpacePartCount,
    };
    NumberField* field(Part part) const { return m_forms[0].fields.at(part); }
    NumberField* field(SpacePart part) const { return m_forms[1].fields.at(part); }

private:
    // The fields of one dimension.
    struct Form {
        QWidget* box = nullptr;
        std::vector<NumberField*> fields;
        int firstTranslation = 0;
    };
    // Shapes of the maps shown so far: what was typed stays.
    template <int Dim> struct Shapes {
        std::map<ifs::MapId, document::MapShapeIn<Dim>> known;
        document::MapShapeIn<Dim> before; // shape of the edited map at the beginning of the edit
    };
    struct Place {
        int row;
        int column;
    };
    Form& makeForm(int dimension, int firstTranslation);
    void makePlaneForm();
    void makeSpaceForm();
    void addField(int dimension, const QString& name, const QString& tip, Place place);
    Form& formOf(int dimension) { return m_forms.at(static_cast<std::size_t>(dimension - 2)); }
    template <int Dim> Shapes<Dim>& shapes() { return std::get<Shapes<Dim>>(m_shapes); }
    void follow();
    void clear();
    template <int Dim> void show(const ifs::IteratedFunctionSystem<Dim>& system);
    QString placeOf(int dimension, int part) const; // place of the edited map in document::TypedNumbers
    void edit(int dimension, int part, double value, const QString& typed = {});
    void commit(int dimension, int part);
    template <int Dim>
    void change(ifs::IteratedFunctionSystem<Dim>& system, int part, double value, const QString& typed);
    void cancel();
    int rowOfMap() const; // −1: none

    document::Document* m_document;
    document::LiveEdit m_edit;
    ifs::MapId m_id = ifs::MapId::None;
    QLabel* m_title;
    MapBlendRow* m_blend;
    std::array<Form, 2> m_forms{}; // forms of the plane and of space
    std::tuple<Shapes<2>, Shapes<3>> m_shapes;
};

} // namespace view
