// SPDX-License-Identifier: MIT
#include "panels/map_shape_editor.h"

#include "panels/number_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QtMath>

#include <algorithm>

namespace view {

MapShapeEditor::MapShapeEditor(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_edit(document), m_title(new QLabel(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    grid->addWidget(m_title, 0, 0, 1, 3);
    addField(Rotation, tr("Rotation °"), tr("Angle in degrees, counter-clockwise with y up"), 1, 0);
    addField(ScaleX, tr("Scale x"), tr("Length of the image of the x unit vector"), 1, 1);
    addField(ScaleY, tr("Scale y"), tr("Scale across; negative when the map reflects"), 1, 2);
    addField(Shear, tr("Shear"), tr("Shear along x, applied before everything else"), 3, 0);
    addField(TranslationX, tr("Shift x"), tr("Translation e, applied last"), 3, 1);
    addField(TranslationY, tr("Shift y"), tr("Translation f, applied last"), 3, 2);
    m_fields[Rotation]->setStep(1);
    m_fields[ScaleX]->setRange({0.0, std::nullopt});
    connect(document, &document::Document::changed, this, &MapShapeEditor::follow);
    follow();
}

void MapShapeEditor::addField(Part part, const QString& name, const QString& tip, int row, int column) {
    auto* label = new QLabel(name, this);
    label->setForegroundRole(QPalette::PlaceholderText);
    auto* field = new NumberField(this);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    label->setBuddy(field);
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->addWidget(label, row, column);
    grid->addWidget(field, row + 1, column);
    grid->setColumnStretch(column, 1);
    m_fields[part] = field;
    connect(field, &NumberField::edited, this, [this, part](double value) { edit(part, value); });
    connect(field, &NumberField::committed, this, [this] { m_edit.commit(); });
    connect(field, &NumberField::cancelled, this, [this] { m_edit.cancel(); });
}

MapShapeEditor::Parts MapShapeEditor::partsOf(const ifs::AffineMap<2>& map) {
    const auto parts = ifs::rotationScaleShear(map.linear);
    return {qRadiansToDegrees(parts.rotation),
            parts.scaleX,
            parts.scaleY,
            parts.shear,
            map.translation.x(),
            map.translation.y()};
}

ifs::Matrix<2> MapShapeEditor::linearPartOf(const Parts& parts) {
    return ifs::linearPart({qDegreesToRadians(parts[Rotation]), parts[ScaleX], parts[ScaleY], parts[Shear]});
}

const ifs::WeightedMap<2>* MapShapeEditor::map() const {
    const document::System2* system = document::system2(m_document->fractal());
    if (!system || m_id == ifs::MapId::None) return nullptr;
    const auto found = std::find_if(system->maps.begin(), system->maps.end(),
                                    [this](const auto& m) { return m.id == m_id; });
    return found == system->maps.end() ? nullptr : &*found;
}

void MapShapeEditor::setMap(ifs::MapId id) {
    if (id == m_id) return;
    m_edit.commit();
    m_id = id;
    follow();
}

void MapShapeEditor::follow() {
    const ifs::WeightedMap<2>* shown = map();
    setEnabled(shown != nullptr);
    if (!shown) {
        m_title->setText(tr("No map is selected"));
        return;
    }
    const auto place = shown - document::system2(m_document->fractal())->maps.data();
    m_title->setText(tr("Map %1").arg(place + 1));
    if (linearPartOf(m_parts) != shown->map.linear) m_parts = partsOf(shown->map);
    m_parts[TranslationX] = shown->map.translation.x();
    m_parts[TranslationY] = shown->map.translation.y();
    for (int part = 0; part < PartCount; ++part)
        m_fields[part]->setValue(m_parts[part]);
}

void MapShapeEditor::edit(Part part, double value) {
    if (!map()) return;
    m_parts[part] = value;
    const QString text = tr("Change the shape of map %1")
                             .arg(map() - document::system2(m_document->fractal())->maps.data() + 1);
    m_edit.preview(text, [&](document::Fractal& fractal) {
        for (auto& candidate : document::system2(fractal)->maps) {
            if (candidate.id != m_id) continue;
            if (part == TranslationX || part == TranslationY)
                candidate.map.translation[part - TranslationX] = value; // a … d keep their digits
            else
                candidate.map.linear = linearPartOf(m_parts);
        }
    });
}

} // namespace view
