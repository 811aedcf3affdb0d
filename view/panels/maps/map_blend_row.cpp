// SPDX-License-Identifier: MIT
#include "panels/maps/map_blend_row.h"

#include "document/fractal/fractal_geometry.h"
#include "widgets/numbers/number_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>

#include <algorithm>

namespace view {

namespace {

bool areColoursBlended(const document::Fractal& fractal) {
    const bool isDensity =
        document::plane(fractal) != nullptr || fractal.inSpace.look == attractor::LookInSpace::Cloud;
    return isDensity && fractal.appearance.colourBy == attractor::ColourBy::Blend;
}

template <class Use> auto withMaps(const document::Fractal& fractal, Use use) {
    if (const auto* solid = document::system3(fractal)) return use(solid->maps);
    static const document::System2 none;
    const auto* system = document::system2(fractal);
    return use(system != nullptr ? system->maps : none.maps);
}

QPixmap stripOf(const attractor::Rgba& colour, const QSize& size) {
    QPixmap strip(size);
    strip.fill(Qt::transparent);
    QPainter painter(&strip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(colour.red, colour.green, colour.blue));
    painter.drawRoundedRect(QRectF(QPointF(), QSizeF(size)), 3, 3);
    return strip;
}

} // namespace

MapBlendRow::MapBlendRow(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_edit(document), m_swatch(new QLabel(this)) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // keeps names next to their fields
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    m_coordinate = makeField(grid, tr("Colour"),
                             tr("The position on the palette to which this map moves colours, from 0 to 1"),
                             &attractor::MapBlend::coordinate);
    m_coordinate->setWhatsThis(tr("Whenever this map is applied, the colour of the point moves towards the "
                                  "position of the map on the palette: 0 is the beginning of the palette, 1 "
                                  "its end. Flame programs call it the colour coordinate."));
    m_speed =
        makeField(grid, tr("Speed"),
                  tr("How far this map moves colours each time, from 0 (not at all) to 1 (all the way)"),
                  &attractor::MapBlend::speed);
    m_speed->setWhatsThis(tr(
        "How far the map moves colours towards its position on the palette each time: with 1, its piece has "
        "a single colour; with 0, all colours stay as they are. Flame programs call it the colour speed."));
    m_swatch->setMinimumWidth(1);
    m_swatch->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    grid->addWidget(m_swatch, 1, 2);
    grid->setColumnStretch(2, 1);
    connect(document, &document::Document::changed, this, &MapBlendRow::follow);
    follow();
}

NumberField* MapBlendRow::makeField(QGridLayout* grid, const QString& name, const QString& tip,
                                    double attractor::MapBlend::*part) {
    const int column = grid->count() / 2;
    auto* label = new QLabel(name, this);
    label->setForegroundRole(QPalette::PlaceholderText);
    auto* field = new NumberField(this);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    field->setRange({0.0, 1.0});
    field->setStep(0.05);
    label->setBuddy(field);
    grid->addWidget(label, 0, column);
    grid->addWidget(field, 1, column);
    grid->setColumnStretch(column, 1);
    connect(field, &NumberField::edited, this, [this, field, part](double value) {
        const int row = rowOfMap();
        if (row < 0) return;
        const QString text =
            tr("%1: %2 %3").arg(tr("Map %1").arg(row + 1), field->accessibleName(), shortNumber(value));
        m_edit.preview(text, [&](document::Fractal& fractal) {
            attractor::MapBlend blend = blendOf(fractal, row);
            blend.*part = value;
            fractal.appearance.mapBlends[m_id] = blend;
        });
    });
    connect(field, &NumberField::committed, this, [this, field] {
        if (m_edit.isOpen())
            m_document->typedNumbers().keep(m_document->currentId(), placeOf(field), field->value(),
                                            field->typedText());
        m_edit.commit();
    });
    connect(field, &NumberField::cancelled, this, [this] { m_edit.cancel(); });
    return field;
}

void MapBlendRow::setMap(ifs::MapId id) {
    if (id == m_id) return;
    m_edit.commit();
    m_id = id;
    follow();
}

int MapBlendRow::rowOfMap() const {
    return withMaps(m_document->fractal(), [this](const auto& maps) {
        const auto found = std::ranges::find_if(maps, [this](const auto& map) { return map.id == m_id; });
        return m_id == ifs::MapId::None || found == maps.end() ? -1 : int(found - maps.begin());
    });
}

attractor::MapBlend MapBlendRow::blendOf(const document::Fractal& fractal, int row) const {
    const std::size_t count = withMaps(fractal, [](const auto& maps) { return maps.size(); });
    return attractor::mapBlend(fractal.appearance, m_id, std::size_t(row), count);
}

QString MapBlendRow::placeOf(const NumberField* field) const {
    return QStringLiteral("blend %1 %2").arg(int(m_id)).arg(field == m_speed ? 1 : 0);
}

void MapBlendRow::follow() {
    const document::Fractal& fractal = m_document->fractal();
    setVisible(areColoursBlended(fractal));
    if (isHidden()) return;
    const int row = rowOfMap();
    setEnabled(row >= 0);
    if (row < 0) {
        for (NumberField* field : {m_coordinate, m_speed})
            if (!field->isEdited()) field->clear();
        return m_swatch->clear();
    }
    const attractor::MapBlend blend = blendOf(fractal, row);
    const auto show = [this](NumberField* field, double value) {
        field->setValue(value,
                        m_document->typedNumbers().text(m_document->currentId(), placeOf(field), value));
    };
    show(m_coordinate, blend.coordinate);
    show(m_speed, blend.speed);
    const int height = fontMetrics().ascent();
    m_swatch->setPixmap(
        stripOf(attractor::colourAt(fractal.appearance.palette, blend.coordinate), {3 * height, height}));
}

} // namespace view
