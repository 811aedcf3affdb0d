// SPDX-License-Identifier: MIT
#include "panels/appearance/space_rows.h"

#include "document/fractal/space_geometry.h"
#include "panels/appearance/controls/appearance_slider.h"
#include "panels/appearance/light_ball.h"
#include "widgets/choices.h"
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

constexpr double maxSliderFog = 8; // end of the slider; more fog hides all but the nearest parts

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
    addChoice(m_look, tr("Stone"), LookInSpace::Stone, tr("A solid lit by a lamp that you can move"));
    addChoice(m_look, tr("Ink"), LookInSpace::Ink, tr("A solid with dark creases on paper, for print"));
    addChoice(m_look, tr("Cloud"), LookInSpace::Cloud, tr("The density of points, as in the plane"));
    addChoice(m_look, tr("X-ray"), LookInSpace::XRay,
              tr("The density of points, coloured by their mean depth"));
    addChoice(m_look, tr("Depth"), LookInSpace::Depth, tr("Near white, far black"));
    addChoice(m_look, tr("Normals"), LookInSpace::Normals,
              tr("The direction of the surface as a colour, for compositing"));
    connect(m_look, &QComboBox::activated, this, [this] {
        const auto look = chosenValue<LookInSpace>(m_look);
        edit(tr("Look: %1").arg(m_look->currentText()), [look](SpaceAppearance& a) { a.look = look; });
    });
    m_form->addRow(tr("Look"), m_look);
}

void SpaceRows::makeColours(QWidget* parent) {
    m_colourBy = new QComboBox(parent);
    m_colourBy->setAccessibleName(tr("Colour of the solid by"));
    m_colourBy->setWhatsThis(tr("What the colour of the surface shows."));
    addChoice(m_colourBy, tr("Plain"), SolidColour::Plain, tr("One colour"));
    addChoice(m_colourBy, tr("Map"), SolidColour::Map, tr("The colour of the map whose piece it is"));
    addChoice(m_colourBy, tr("Address"), SolidColour::Address, tr("The palette along the addresses"));
    addChoice(m_colourBy, tr("Height"), SolidColour::Height, tr("The palette from bottom to top"));
    addChoice(m_colourBy, tr("Depth"), SolidColour::Depth, tr("The palette from near to far"));
    connect(m_colourBy, &QComboBox::activated, this, [this] {
        const auto colour = chosenValue<SolidColour>(m_colourBy);
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
    // Ink has no light but the eye's.
    m_form->setRowVisible(m_light, isSpace && inSpace.look == LookInSpace::Stone);
    m_form->setRowVisible(m_fog, isLit);
    chooseValue(m_look, inSpace.look);
    chooseValue(m_colourBy, document::solidColour(fractal));
    m_light->setDirection(inSpace.lightAzimuth, inSpace.lightElevation);
    m_fog->setValue(inSpace.fog);
}

} // namespace view
