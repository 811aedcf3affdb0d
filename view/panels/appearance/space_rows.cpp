// SPDX-License-Identifier: MIT
#include "panels/appearance/space_rows.h"

#include "document/fractal/space_geometry.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/light_ball.h"
#include "widgets/numbers/number_text.h"

#include <QComboBox>
#include <QFormLayout>

#include <algorithm>
#include <utility>

namespace view {

namespace {

using attractor::LookInSpace;
using attractor::SolidColour;
using attractor::SpaceAppearance;

constexpr double maxSliderFog = 8; // of the slider; more hides all but the nearest

template <class Value> void addChoice(QComboBox* box, const QString& name, const QString& tip, Value value) {
    box->addItem(name, static_cast<int>(value));
    box->setItemData(box->count() - 1, tip, Qt::ToolTipRole);
}

} // namespace

SpaceRows::SpaceRows(QFormLayout* form, document::Document* document, QWidget* parent)
    : QObject(parent), m_form(form), m_document(document), m_edit(document) {
    makeLook(parent);
    makeColours(parent);
    makeLight(parent);
}

void SpaceRows::makeLook(QWidget* parent) {
    m_look = new QComboBox(parent);
    m_look->setAccessibleName(tr("Look"));
    m_look->setWhatsThis(tr("A lit solid, the density of its points, or data for other programs."));
    addChoice(m_look, tr("Stone"), tr("A solid lit by a lamp that you can move"), LookInSpace::Stone);
    addChoice(m_look, tr("Ink"), tr("A solid with dark creases on paper, for print"), LookInSpace::Ink);
    addChoice(m_look, tr("Cloud"), tr("The density of points, as in the plane"), LookInSpace::Cloud);
    addChoice(m_look, tr("X-ray"), tr("The density of points, coloured by their mean depth"),
              LookInSpace::XRay);
    addChoice(m_look, tr("Depth"), tr("Near white, far black"), LookInSpace::Depth);
    addChoice(m_look, tr("Normals"), tr("The direction of the surface as a colour, for compositing"),
              LookInSpace::Normals);
    connect(m_look, &QComboBox::activated, this, [this] {
        const auto look = static_cast<LookInSpace>(m_look->currentData().toInt());
        edit(tr("Look: %1").arg(m_look->currentText()), [look](SpaceAppearance& a) { a.look = look; });
    });
    m_form->addRow(tr("Look"), m_look);
}

void SpaceRows::makeColours(QWidget* parent) {
    m_colourBy = new QComboBox(parent);
    m_colourBy->setAccessibleName(tr("Colour of the solid by"));
    m_colourBy->setWhatsThis(tr("What the colour of the surface shows."));
    addChoice(m_colourBy, tr("Plain"), tr("One colour"), SolidColour::Plain);
    addChoice(m_colourBy, tr("Map"), tr("The colour of the map whose piece it is"), SolidColour::Map);
    addChoice(m_colourBy, tr("Address"), tr("The palette along the addresses"), SolidColour::Address);
    addChoice(m_colourBy, tr("Height"), tr("The palette from bottom to top"), SolidColour::Height);
    addChoice(m_colourBy, tr("Depth"), tr("The palette from near to far"), SolidColour::Depth);
    connect(m_colourBy, &QComboBox::activated, this, [this] {
        const auto colour = static_cast<SolidColour>(m_colourBy->currentData().toInt());
        edit(tr("Colour by: %1").arg(m_colourBy->currentText()),
             [colour](SpaceAppearance& a) { a.colourBy = colour; });
    });
    m_form->addRow(tr("Colour by"), m_colourBy);
}

void SpaceRows::makeLight(QWidget* parent) {
    m_light = new LightBall(parent);
    m_light->setWhatsThis(
        tr("The direction of the light as seen by the camera; in the middle, it shines from the camera."));
    connect(m_light, &LightBall::tried, this, [this](double azimuth, double elevation) {
        preview(tr("Light: %1°, %2°").arg(shortNumber(azimuth), shortNumber(elevation)),
                [=](SpaceAppearance& a) {
                    a.lightAzimuth = azimuth;
                    a.lightElevation = elevation;
                });
    });
    connect(m_light, &LightBall::accepted, this, [this] { m_edit.commit(); });
    connect(m_light, &LightBall::rejected, this, [this] { m_edit.cancel(); });
    m_form->addRow(tr("Light"), m_light);

    m_fog = new AppearanceSlider(tr("Fog"), 0, maxSliderFog, AppearanceSlider::Scale::Linear, parent);
    m_fog->setToolTip(tr("How fast colours fade with depth"));
    connect(m_fog, &AppearanceSlider::tried, this, [this](double fog) {
        preview(tr("Fog: %1").arg(shortNumber(fog)),
                [fog](SpaceAppearance& a) { a.fog = std::min(fog, SpaceAppearance::maxFog); });
    });
    connect(m_fog, &AppearanceSlider::accepted, this, [this] { m_edit.commit(); });
    connect(m_fog, &AppearanceSlider::rejected, this, [this] { m_edit.cancel(); });
    m_form->addRow(tr("Fog"), m_fog);
}

void SpaceRows::edit(const QString& text, const Setting& set) {
    m_edit.commit();
    document::Fractal fractal = m_document->fractal();
    set(fractal.inSpace);
    m_document->edit(text, std::move(fractal));
}

void SpaceRows::preview(const QString& text, const Setting& set) {
    m_edit.preview(text, [&](document::Fractal& fractal) { set(fractal.inSpace); });
}

void SpaceRows::follow() {
    const document::Fractal& fractal = m_document->fractal();
    const SpaceAppearance& inSpace = fractal.inSpace;
    const bool isSpace = document::space(fractal) != nullptr;
    if (!isSpace && !std::exchange(m_isShown, false)) return;
    m_isShown = isSpace;
    const bool isLit = isSpace && (inSpace.look == LookInSpace::Stone || inSpace.look == LookInSpace::Ink);
    m_form->setRowVisible(m_look, isSpace);
    m_form->setRowVisible(m_colourBy, isLit);
    m_form->setRowVisible(m_light, isSpace && inSpace.look == LookInSpace::Stone); // ink has the eye's alone
    m_form->setRowVisible(m_fog, isLit);
    m_look->setCurrentIndex(m_look->findData(static_cast<int>(inSpace.look)));
    m_colourBy->setCurrentIndex(m_colourBy->findData(static_cast<int>(document::solidColour(fractal))));
    m_light->setDirection(inSpace.lightAzimuth, inSpace.lightElevation);
    m_fog->setValue(inSpace.fog);
}

} // namespace view
