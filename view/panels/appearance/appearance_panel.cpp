// SPDX-License-Identifier: MIT
#include "panels/appearance/appearance_panel.h"

#include "document/fractal/space_geometry.h"
#include "panels/appearance/controls/appearance_colour_button.h"
#include "panels/appearance/number_rows.h"
#include "panels/appearance/palettes/gradient_editor.h"
#include "panels/appearance/palettes/gradient_preview.h"
#include "panels/appearance/palettes/palette_browser.h"
#include "panels/appearance/slice_rows.h"
#include "panels/appearance/space_rows.h"
#include "widgets/choices.h"
#include "widgets/flat_buttons.h"
#include "widgets/layout/wrapping_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace view {

namespace {

using attractor::Appearance;
using attractor::ColourBy;

constexpr int labelSpacing = 16;
constexpr int browserInset = 12;
constexpr int swatchesPerRow = 7;
constexpr int maxSwatches = 70; // limit; further maps have their colours in the table

QString stepText(const QString& name, const attractor::Rgba& colour) {
    return AppearancePanel::tr("%1: %2").arg(name, QColor(colour.red, colour.green, colour.blue).name());
}

std::vector<ifs::MapId> mapsWithSwatches(const document::Fractal& fractal) {
    std::vector<ifs::MapId> ids;
    const auto take = [&](const auto* system) {
        for (std::size_t i = 0; system && i < std::min<std::size_t>(system->maps.size(), maxSwatches); ++i)
            ids.push_back(system->maps[i].id);
    };
    take(document::system2(fractal));
    take(document::system3(fractal));
    return ids;
}

} // namespace

AppearancePanel::AppearancePanel(document::Document* document, QWidget* parent)
    : QWidget(parent), m_document(document), m_edit(document) {
    setAccessibleName(tr("Appearance"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    auto* form = new WrappingForm; // narrow, in favour of the picture
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setHorizontalSpacing(labelSpacing);
    form->setVerticalSpacing(10);
    layout->addLayout(form);
    m_form = form;
    m_space = new SpaceRows(form, document, this);
    m_slice = new SliceRows(form, document, this);
    makeColourRows(form);
    makeToneRows(form);
    makeMapColours(form);
    m_reset = new QToolButton(this);
    m_reset->setText(tr("Reset to Default"));
    m_reset->setToolTip(tr("Reset every setting of this panel to its default"));
    m_reset->setAutoRaise(true);
    connect(m_reset, &QToolButton::clicked, this, &AppearancePanel::resetToDefault);
    layout->addSpacing(4);
    layout->addWidget(m_reset, 0, Qt::AlignLeft);
    layout->addStretch();
    connect(document, &document::Document::changed, this, &AppearancePanel::follow);
    follow({document::Change::Everything, false});
}

void AppearancePanel::makeColourRows(QFormLayout* form) {
    m_colourBy = new QComboBox(this);
    m_colourBy->setAccessibleName(tr("Colour by"));
    m_colourBy->setWhatsThis(
        tr("What the colour of a point shows: how many points fall there, which map "
           "came last, the whole address, or the blend of the colours of all maps applied, as in flames. The "
           "position of each map on the palette, and its speed, are in the Maps panel."));
    const auto add = [this](const QString& name, const QString& tip, ColourBy value) {
        addChoice(m_colourBy, name, value);
        m_colourBy->setItemData(m_colourBy->count() - 1, tip, Qt::ToolTipRole);
    };
    add(tr("Density"), tr("Colour by the density of points"), ColourBy::Density);
    add(tr("Map"), tr("Colour by the last map applied"), ColourBy::Map);
    add(tr("Address"), tr("Colour by the address of each point"), ColourBy::Address);
    add(tr("Blend of maps"), tr("As in flames: each map moves colours towards its position on the palette"),
        ColourBy::Blend);
    add(tr("Plain"), tr("One colour, with the density as its opacity"), ColourBy::Plain);
    connect(m_colourBy, &QComboBox::activated, this, [this] {
        const auto value = chosenValue<ColourBy>(m_colourBy);
        edit(tr("Colour by: %1").arg(m_colourBy->currentText()),
             [value](Appearance& a) { a.colourBy = value; });
    });
    form->addRow(tr("Colour by"), m_colourBy);

    makeGradientRows(form);

    m_plain = colourButton(tr("Plain colour"), &Appearance::plain);
    m_plainLabel = new QLabel(tr("Colour"), this);
    form->addRow(m_plainLabel, m_plain);
}

void AppearancePanel::makeGradientRows(QFormLayout* form) {
    m_gradient = new GradientChooser(this);
    m_gradient->setAccessibleName(tr("Palette"));
    m_gradient->setWhatsThis(tr("The colours from the thinnest parts to the densest, along the addresses, or "
                                "along the positions between which maps blend."));
    m_gradientLabel = new QLabel(tr("Palette"), this);
    m_gradientLabel->setBuddy(m_gradient);
    connect(m_gradient, &GradientChooser::chosen, this, [this](const attractor::Palette& palette) {
        edit(tr("Palette: %1").arg(m_gradient->currentText()), [&](Appearance& a) { a.palette = palette; });
    });
    m_browsePalettes = flatButton(QStringLiteral("palette"), tr("More Palettes…"),
                                  tr("Browse hundreds of palettes, change their hue and shift them"), this);
    connect(m_browsePalettes, &QToolButton::clicked, this, &AppearancePanel::choosePalette);
    m_editGradient = flatButton(QStringLiteral("edit"), tr("Edit Palette"),
                                tr("Edit the palette, or load one from a file"), this);
    m_editGradient->setCheckable(true);
    m_gradientRow = new QHBoxLayout;
    m_gradientRow->setSpacing(6);
    m_gradientRow->addWidget(m_gradient, 1);
    m_gradientRow->addWidget(m_browsePalettes);
    m_gradientRow->addWidget(m_editGradient);
    form->addRow(m_gradientLabel, m_gradientRow);
    makeGradientEditor(form);
}

void AppearancePanel::makeGradientEditor(QFormLayout* form) {
    m_editor = new GradientEditor(this);
    m_editor->hide();
    form->addRow(m_editor);
    connect(m_editGradient, &QToolButton::toggled, m_editor, &QWidget::setVisible);
    connect(m_editor, &GradientEditor::tried, this,
            [this](const QString& what, const attractor::Palette& palette) {
                preview(what, [&](Appearance& a) { a.palette = palette; });
            });
    connect(m_editor, &GradientEditor::accepted, this, [this] { m_edit.commit(); });
    connect(m_editor, &GradientEditor::rejected, this, [this] { m_edit.cancel(); });
    connect(m_editor, &GradientEditor::message, this, &AppearancePanel::message);
}

void AppearancePanel::choosePalette() {
    m_edit.commit();
    PaletteBrowser browser(m_document->fractal().appearance.palette, this);
    const auto text = [&browser] { return tr("Palette: %1").arg(browser.title()); };
    connect(&browser, &PaletteBrowser::tried, this,
            [&] { preview(text(), [&](Appearance& a) { a.palette = browser.palette(); }); });
    // Left of the window, so that most of the picture stays visible.
    const QRect frame = window()->geometry();
    browser.move(frame.left() + browserInset,
                 frame.top() + std::max(0, frame.height() - browser.height()) / 2);
    if (browser.exec() == QDialog::Accepted)
        m_edit.commit();
    else
        m_edit.cancel();
}

void AppearancePanel::makeToneRows(QFormLayout* form) {
    m_background = colourButton(tr("Background colour"), &Appearance::background);
    m_transparent = new QCheckBox(tr("Transparent"), this);
    m_transparent->setWhatsThis(tr("Makes the background of exported pictures transparent."));
    connect(m_transparent, &QCheckBox::clicked, this, [this](bool on) {
        edit(on ? tr("Make the background transparent") : tr("Make the background opaque"),
             [on](Appearance& a) { a.background.alpha = on ? 0 : 255; });
    });
    auto* background = new QHBoxLayout;
    background->setSpacing(12);
    background->addWidget(m_background);
    background->addWidget(m_transparent);
    background->addStretch();
    form->addRow(tr("Background"), background);

    m_numbers = new NumberRows(form, m_document, this);

    m_supersampling = new QComboBox(this);
    m_supersampling->setAccessibleName(tr("Supersampling"));
    m_supersampling->setWhatsThis(tr(
        "Computes every pixel from several smaller ones: smoother edges, at the cost of memory and time."));
    for (int factor = 1; factor <= 4; ++factor)
        addChoice(m_supersampling, factor == 1 ? tr("Off") : tr("%1 × %1 sub-pixels").arg(factor), factor);
    connect(m_supersampling, &QComboBox::activated, this, [this] {
        const int factor = chosenValue<int>(m_supersampling);
        edit(tr("Supersampling: %1").arg(m_supersampling->currentText()),
             [factor](Appearance& a) { a.supersample = factor; });
    });
    form->addRow(tr("Supersampling"), m_supersampling);
}

void AppearancePanel::makeMapColours(QFormLayout* form) {
    m_mapColoursLabel = new QLabel(tr("Map colours"), this);
    m_mapColours = new QWidget(this);
    m_mapColoursGrid = new QGridLayout(m_mapColours);
    m_mapColoursGrid->setContentsMargins(0, 0, 0, 0);
    m_mapColoursGrid->setSpacing(4);
    m_mapColoursGrid->setColumnStretch(swatchesPerRow, 1);
    form->addRow(m_mapColoursLabel, m_mapColours);
}

ColourButton* AppearancePanel::colourButton(const QString& name, attractor::Rgba Appearance::*member) {
    const auto alpha =
        member == &Appearance::background ? ColourButton::Alpha::Adjustable : ColourButton::Alpha::Opaque;
    auto* button = new ColourButton(name, alpha, this);
    connect(button, &ColourButton::tried, this, [this, name, member](const attractor::Rgba& colour) {
        preview(stepText(name, colour), [&](Appearance& a) { a.*member = colour; });
    });
    connect(button, &ColourButton::accepted, this, [this] { m_edit.commit(); });
    connect(button, &ColourButton::rejected, this, [this] { m_edit.cancel(); });
    return button;
}

void AppearancePanel::preview(const QString& text, const Setting& set) {
    m_edit.preview(text, [&](document::Fractal& fractal) { set(fractal.appearance); });
}

void AppearancePanel::edit(const QString& text, const Setting& set) {
    m_edit.commit();
    document::Fractal fractal = m_document->fractal();
    set(fractal.appearance);
    m_document->edit(text, std::move(fractal));
}

void AppearancePanel::resetToDefault() {
    m_edit.commit();
    document::Fractal fractal = m_document->fractal();
    fractal.appearance = {};
    fractal.inSpace = {};
    m_document->edit(tr("Reset the appearance"), std::move(fractal));
}

void AppearancePanel::follow(const document::Change& change) {
    using document::Change;
    const bool isPlacedOtherwise = change.parts & Change::Cage && !change.live;
    if (isPlacedOtherwise && document::space(m_document->fractal())) m_slice->follow(false);
    if (!(change.parts &
          (Change::Appearance | Change::System | Change::Current | Change::File | Change::Entries)))
        return;
    const document::Fractal& fractal = m_document->fractal();
    const Appearance& appearance = fractal.appearance;
    setEnabled(document::dimension(fractal) != 0);
    m_space->follow();
    m_slice->follow(change.live);
    chooseValue(m_colourBy, appearance.colourBy);
    m_gradient->showPalette(appearance.palette);
    m_editor->setGradient(appearance.palette);
    const bool isSpace = document::space(fractal) != nullptr;
    m_plain->setColour(isSpace ? document::solidAppearance(fractal).plain : appearance.plain);
    m_background->setColour(isSpace ? document::backgroundInSpace(fractal) : appearance.background);
    m_transparent->setChecked(appearance.background.alpha == 0);
    m_numbers->follow(appearance);
    chooseValue(m_supersampling, int(appearance.supersample));
    showUses();
    m_reset->setEnabled(!(appearance == Appearance{}) || !(fractal.inSpace == attractor::SpaceAppearance{}));
    showMapColours();
}

AppearancePanel::Uses AppearancePanel::uses() const {
    const document::Fractal& fractal = m_document->fractal();
    const ColourBy colourBy = fractal.appearance.colourBy;
    const attractor::LookInSpace look = fractal.inSpace.look;
    Uses uses;
    if (!document::space(fractal) || look == attractor::LookInSpace::Cloud) {
        uses = {true, colourBy != ColourBy::Map && colourBy != ColourBy::Plain, colourBy == ColourBy::Plain,
                colourBy == ColourBy::Map, true};
    } else if (look == attractor::LookInSpace::XRay) {
        uses.palette = uses.tone = true;
    } else if (look == attractor::LookInSpace::Stone || look == attractor::LookInSpace::Ink) {
        const attractor::SolidColour solid = document::solidColour(fractal);
        uses.plain = solid == attractor::SolidColour::Plain;
        uses.mapColours = solid == attractor::SolidColour::Map;
        uses.palette = !uses.plain && !uses.mapColours;
    }
    uses.isPlane = document::space(fractal) == nullptr;
    return uses;
}

// In the plane, unused controls are disabled and keep their places; in space they are hidden, with all
// controls that make no sense for a solid.
void AppearancePanel::showUses() {
    const Uses used = uses();
    if (std::exchange(m_shownUses, used) == used) return;
    const bool isPlane = used.isPlane;
    m_form->setRowVisible(m_colourBy, isPlane || used.colourBy);
    m_form->setRowVisible(m_gradientRow, isPlane || used.palette);
    m_form->setRowVisible(m_plain, isPlane || used.plain);
    m_numbers->setVisible(isPlane || used.tone, isPlane);
    m_form->setRowVisible(m_supersampling, isPlane || used.tone);
    m_form->setRowVisible(m_mapColours, isPlane || used.mapColours);
    m_editor->setVisible(m_editGradient->isChecked() && (isPlane || used.palette));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_gradient, m_gradientLabel, m_browsePalettes,
                                                           m_editGradient, m_editor})
        widget->setEnabled(used.palette);
    m_plain->setEnabled(used.plain);
    m_plainLabel->setEnabled(used.plain);
}

void AppearancePanel::showMapColours() {
    const Appearance& appearance = m_document->fractal().appearance;
    const std::vector<ifs::MapId> maps = mapsWithSwatches(m_document->fractal());
    const std::size_t count = maps.size();
    while (m_mapButtons.size() < count) {
        const std::size_t index = m_mapButtons.size();
        auto* button =
            new ColourButton(tr("Colour of map %1").arg(index + 1), ColourButton::Alpha::Opaque, this);
        const auto at = static_cast<int>(index);
        m_mapColoursGrid->addWidget(button, at / swatchesPerRow, at % swatchesPerRow);
        connect(button, &ColourButton::tried, this, [this, index](const attractor::Rgba& colour) {
            const std::vector<ifs::MapId> now = mapsWithSwatches(m_document->fractal());
            if (index >= now.size()) return;
            const ifs::MapId id = now[index];
            preview(stepText(tr("Colour of map %1").arg(index + 1), colour),
                    [&](Appearance& a) { a.mapColours[id] = colour; });
        });
        connect(button, &ColourButton::accepted, this, [this] { m_edit.commit(); });
        connect(button, &ColourButton::rejected, this, [this] { m_edit.cancel(); });
        m_mapButtons.push_back(button);
    }
    const auto shown = std::ranges::count_if(m_mapButtons, [](const QWidget* b) { return !b->isHidden(); });
    if (std::size_t(shown) != count) {
        const bool wasShown = !m_mapColours->isHidden();
        m_mapColours->hide(); // otherwise every button causes a layout of the window
        for (std::size_t i = 0; i < m_mapButtons.size(); ++i)
            m_mapButtons[i]->setVisible(i < count);
        m_mapColours->setVisible(wasShown);
    }
    for (std::size_t i = 0; i < count; ++i)
        m_mapButtons[i]->setColour(attractor::mapColour(appearance, maps[i], i));
    m_mapColours->setEnabled(uses().mapColours);
    m_mapColoursLabel->setEnabled(m_mapColours->isEnabled());
}

} // namespace view
