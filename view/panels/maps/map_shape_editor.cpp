// SPDX-License-Identifier: MIT
#include "panels/maps/map_shape_editor.h"

#include "document/edits/maps/map_locks.h"
#include "document/maps/map_names.h"
#include "document/moments/animated_fractal.h"
#include "io/text/typed_coefficient.h"
#include "panels/maps/calculated_maps.h"
#include "panels/maps/map_blend_row.h"
#include "panels/maps/maps_model.h"
#include "panels/maps/maps_texts.h"
#include "widgets/numbers/number_field.h"
#include "widgets/text/tooltip_text.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

using Editor = MapShapeEditor;

template <int Dim> int rowIn(const ifs::IteratedFunctionSystem<Dim>& system, ifs::MapId id) {
    const auto found = std::ranges::find(system.maps, id, &ifs::WeightedMap<Dim>::id);
    return id == ifs::MapId::None || found == system.maps.end() ? -1 : int(found - system.maps.begin());
}

static_assert(int(Editor::Rotation) == document::MapShape::Rotation &&
              int(Editor::TranslationX) == document::MapShape::PartCount);
static_assert(int(Editor::AxisX) == document::MapShape3::AxisX &&
              int(Editor::SpaceTranslationX) == document::MapShape3::PartCount);

} // namespace

MapShapeEditor::MapShapeEditor(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_edit(document), m_title(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    layout->addWidget(m_title);
    makePlaneForm();
    makeSpaceForm();
    m_blend = new MapBlendRow(document, this);
    layout->addWidget(m_blend);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        if (change.parts & (document::Change::Current | document::Change::File)) {
            shapes<2>().known.clear();
            shapes<3>().known.clear();
        }
        follow();
    });
    follow();
}

MapShapeEditor::Form& MapShapeEditor::makeForm(int dimension, int firstTranslation) {
    Form& form = formOf(dimension);
    form.firstTranslation = firstTranslation;
    form.box = new QWidget(this);
    auto* grid = new QGridLayout(form.box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    layout()->addWidget(form.box);
    return form;
}

void MapShapeEditor::makePlaneForm() {
    const Form& form = makeForm(2, TranslationX);
    addField(2, tr("Rotation °"), tr("Angle in degrees, counter-clockwise with y up"), {1, 0});
    addField(2, tr("Scale x"), tr("Length of the image of the x unit vector"), {1, 1});
    addField(2, tr("Scale y"), tr("Scale at right angles to that; negative if the map reflects"), {1, 2});
    addField(2, tr("Shear"), tr("Shear along x, applied first"), {3, 0});
    addField(2, tr("Shift x"), tr("Translation e, applied last"), {3, 1});
    addField(2, tr("Shift y"), tr("Translation f, applied last"), {3, 2});
    form.fields[Rotation]->setDegrees();
    form.fields[Rotation]->setStep(1);
    form.fields[ScaleX]->setRange({0.0, std::nullopt});
}

void MapShapeEditor::makeSpaceForm() {
    const Form& form = makeForm(3, SpaceTranslationX);
    const QString axis = tr("Axis of the rotation; only its direction matters");
    addField(3, tr("Axis x"), axis, {1, 0});
    addField(3, tr("Axis y"), axis, {1, 1});
    addField(3, tr("Axis z"), axis, {1, 2});
    addField(3, tr("Rotation °"),
             tr("Angle in degrees, counter-clockwise as seen from the tip of the axis looking back"), {1, 3});
    addField(3, tr("Scale x"), tr("Length of the image of the x unit vector"), {3, 0});
    addField(3, tr("Scale y"), tr("Scale along y, before the rotation"), {3, 1});
    addField(3, tr("Scale z"), tr("Scale along z, before the rotation; negative if the map reflects"),
             {3, 2});
    addField(3, tr("Shear xy"), tr("What y adds to x, applied first"), {5, 0});
    addField(3, tr("Shear xz"), tr("What z adds to x, applied first"), {5, 1});
    addField(3, tr("Shear yz"), tr("What z adds to y, applied first"), {5, 2});
    addField(3, tr("Shift x"), tr("Translation j, applied last"), {7, 0});
    addField(3, tr("Shift y"), tr("Translation k, applied last"), {7, 1});
    addField(3, tr("Shift z"), tr("Translation l, applied last"), {7, 2});
    form.fields[Angle]->setDegrees();
    form.fields[Angle]->setStep(1);
    form.fields[SpaceScaleX]->setRange({0.0, std::nullopt});
    form.fields[SpaceScaleY]->setRange({0.0, std::nullopt});
}

void MapShapeEditor::addField(int dimension, const QString& name, const QString& tip, Place place) {
    Form& form = formOf(dimension);
    const int part = int(form.fields.size());
    auto* label = new QLabel(name, form.box);
    label->setForegroundRole(QPalette::PlaceholderText);
    auto* field = new NumberField(form.box);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    label->setBuddy(field);
    auto* grid = static_cast<QGridLayout*>(form.box->layout());
    grid->addWidget(label, place.row, place.column);
    grid->addWidget(field, place.row + 1, place.column);
    grid->setColumnStretch(place.column, 1);
    form.fields.push_back(field);
    connect(field, &NumberField::edited, this,
            [this, dimension, part](double value) { edit(dimension, part, value); });
    connect(field, &NumberField::committed, this, [this, dimension, part] { commit(dimension, part); });
    connect(field, &NumberField::cancelled, this, &MapShapeEditor::cancel);
}

int MapShapeEditor::rowOfMap() const {
    const document::Fractal& fractal = m_document->fractal();
    if (const document::System2* system = document::system2(fractal)) return rowIn(*system, m_id);
    if (const document::System3* system = document::system3(fractal)) return rowIn(*system, m_id);
    return -1;
}

void MapShapeEditor::setMap(ifs::MapId id) {
    if (id == m_id) return;
    m_edit.commit();
    m_id = id;
    m_blend->setMap(id);
    follow();
}

void MapShapeEditor::follow() {
    const document::Fractal& fractal = m_document->fractal();
    const bool isSpace = document::space(fractal) != nullptr;
    formOf(2).box->setVisible(!isSpace);
    formOf(3).box->setVisible(isSpace);
    const int row = rowOfMap();
    const QString locked =
        row < 0 ? QString() : document::lockObstacle(fractal, std::vector{std::size_t(row)});
    setEnabled(row >= 0 && locked.isEmpty());
    setToolTip(tooltipText(locked));
    const QString name = row < 0 ? QString() : document::mapTitle(fractal, std::size_t(row));
    m_title->setText(row < 0            ? tr("No map is selected")
                     : locked.isEmpty() ? tr("Map %1").arg(name)
                                        : tr("Map %1, locked").arg(name));
    if (row < 0) return clear();
    if (isSpace)
        show(*document::system3(fractal));
    else
        show(*document::system2(fractal));
}

void MapShapeEditor::clear() {
    for (const Form& form : m_forms)
        for (NumberField* field : form.fields)
            if (!field->isEdited()) field->clear();
}

template <int Dim> void MapShapeEditor::show(const ifs::IteratedFunctionSystem<Dim>& system) {
    const Form& form = formOf(Dim);
    const ifs::WeightedMap<Dim>& map = system.maps[std::size_t(rowIn(system, m_id))];
    document::MapShapeIn<Dim>& shape = shapes<Dim>().known[m_id];
    shape.show(map.map.linear);
    const auto showPart = [&](int part, double value) {
        const ifs::TypedCoefficient* typed =
            part < form.firstTranslation ? nullptr
                                         : map.typed.of(Dim * Dim + part - form.firstTranslation, value);
        form.fields[std::size_t(part)]->setValue(
            value, typed
                       ? QString::fromStdString(typed->text)
                       : m_document->typedNumbers().text(m_document->currentId(), placeOf(Dim, part), value));
    };
    for (std::size_t part = 0; part < shape.parts().size(); ++part)
        showPart(int(part), shape.parts()[part]);
    // As in the table.
    const bool isMoving = document::animationFacts(m_document->entryFractal()).has_value();
    const auto shift = isMoving ? withoutResidue<Dim>(map.map).translation : map.map.translation;
    for (int k = 0; k < Dim; ++k)
        showPart(form.firstTranslation + k, shift[k]);
}

// A translation is a number of the table, too, and is written in both places as it was typed in one.
QString MapShapeEditor::placeOf(int dimension, int part) const {
    const int translation = part - m_forms[std::size_t(dimension - 2)].firstTranslation;
    return translation >= 0 ? typedPlace(m_id, MapsModel::A + dimension * dimension + translation)
                            : QStringLiteral("shape %1 %2 %3").arg(int(m_id)).arg(dimension).arg(part);
}

void MapShapeEditor::commit(int dimension, int part) {
    const NumberField* field = formOf(dimension).fields[std::size_t(part)];
    if (m_edit.isOpen()) {
        if (part >= formOf(dimension).firstTranslation)
            edit(dimension, part, field->value(), field->typedText());
        m_document->typedNumbers().keep(m_document->currentId(), placeOf(dimension, part), field->value(),
                                        field->typedText());
    }
    m_edit.commit();
}

void MapShapeEditor::edit(int dimension, int part, double value, const QString& typed) {
    const int row = rowOfMap();
    if (row < 0 || document::dimension(m_document->fractal()) != dimension) return;
    if (!m_edit.isOpen()) {
        if (dimension == 2)
            shapes<2>().before = shapes<2>().known[m_id];
        else
            shapes<3>().before = shapes<3>().known[m_id];
    }
    const NumberField* field = formOf(dimension).fields[std::size_t(part)];
    const QString text =
        tr("%1: %2 %3").arg(tr("Map %1").arg(row + 1), field->accessibleName(), shortNumber(value));
    m_edit.preview(text, [&](document::Fractal& fractal) {
        if (dimension == 2)
            change(*document::system2(fractal), part, value, typed);
        else
            change(*document::system3(fractal), part, value, typed);
    });
}

template <int Dim>
void MapShapeEditor::change(ifs::IteratedFunctionSystem<Dim>& system, int part, double value,
                            const QString& typed) {
    const Form& form = formOf(Dim);
    const int row = rowIn(system, m_id);
    if (row < 0) return;
    ifs::WeightedMap<Dim>& map = system.maps[std::size_t(row)];
    using Shape = document::MapShapeIn<Dim>;
    if (const int axis = part - form.firstTranslation; axis >= 0) {
        map.map.translation[axis] = value; // the linear part keeps its digits
        map.typed.clear(Dim * Dim + axis);
        io::keepTyped(map, Dim * Dim + axis, typed);
    } else {
        map.map.linear = shapes<Dim>().known[m_id].changed(typename Shape::Part(part), value);
    }
}

// A number that changes no coefficient, as the axis of no rotation, comes back as well.
void MapShapeEditor::cancel() {
    if (!m_edit.isOpen()) return;
    m_edit.cancel();
    if (document::dimension(m_document->fractal()) == 2)
        shapes<2>().known[m_id] = shapes<2>().before;
    else
        shapes<3>().known[m_id] = shapes<3>().before;
    follow();
}

} // namespace view
