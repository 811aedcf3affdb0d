// SPDX-License-Identifier: MIT
#include "panels/appearance/number_rows.h"

#include "panels/appearance/controls/appearance_slider.h"
#include "widgets/numbers/number_field.h"
#include "widgets/numbers/number_text.h"

#include <QCoreApplication>
#include <QFormLayout>

#include <algorithm>
#include <array>
#include <optional>

namespace view {

namespace {

using attractor::Appearance, attractor::AppearanceNumber;

struct NumberText {
    double Appearance::*member;
    const char* title;
    const char* tip;
    const char* explanation;               // null: the tip suffices
    double lowest, highest;                // range of the slider
    std::optional<NumberRange> typed = {}; // nullopt: range that the appearance accepts
};

constexpr double leastContrast = 0.01; // limit beyond which all tones are the middle one, or black and white
constexpr double mostContrast = 100;

const std::array numberTexts{
    NumberText{&Appearance::brightness, QT_TRANSLATE_NOOP("view::AppearancePanel", "Brightness"),
               QT_TRANSLATE_NOOP("view::AppearancePanel",
                                 "How strongly thin parts show: κ of the logarithmic tone curve"),
               nullptr, 0.1, 1000},
    NumberText{&Appearance::gamma, QT_TRANSLATE_NOOP("view::AppearancePanel", "Gamma"),
               QT_TRANSLATE_NOOP("view::AppearancePanel",
                                 "Exponent of the tone curve: higher values lift the dark parts"),
               nullptr, 0.5, 8},
    NumberText{&Appearance::contrast, QT_TRANSLATE_NOOP("view::AppearancePanel", "Contrast"),
               QT_TRANSLATE_NOOP("view::AppearancePanel",
                                 "Above 1, light parts become lighter and dark parts darker"),
               QT_TRANSLATE_NOOP("view::AppearancePanel",
                                 "Above 1, tones lighter than the middle become lighter, and darker ones "
                                 "darker. Below 1, they come closer together. Black, middle and white stay."),
               0.2, 5, NumberRange{leastContrast, mostContrast, NumberRange::Ends::Closed}},
    NumberText{&Appearance::vibrancy, QT_TRANSLATE_NOOP("view::AppearancePanel", "Vibrancy"),
               QT_TRANSLATE_NOOP("view::AppearancePanel",
                                 "Below 1, colours are paler, the more so the higher the gamma"),
               QT_TRANSLATE_NOOP("view::AppearancePanel",
                                 "At 1, the gamma decides only how strongly a colour shows, and the colour "
                                 "keeps its hue. At 0, the gamma acts on red, green and blue as well, and "
                                 "colours are paler. Flames have the same setting."),
               0, 1},
    NumberText{
        &Appearance::shadow, QT_TRANSLATE_NOOP("view::AppearancePanel", "Shadow"),
        QT_TRANSLATE_NOOP("view::AppearancePanel",
                          "Opacity of the shadow on the ground behind the picture; 0: no shadow"),
        QT_TRANSLATE_NOOP("view::AppearancePanel",
                          "The shadow is the picture once more: darker, flattened, and laid on the "
                          "ground on which the picture stands. Drag its tip on the canvas to turn it."),
        0, 1},
    NumberText{
        &Appearance::shadowLean, QT_TRANSLATE_NOOP("view::AppearancePanel", "Shadow sideways"),
        QT_TRANSLATE_NOOP("view::AppearancePanel",
                          "How far to the right the shadow of what is 1 high ends; below 0, to the left"),
        nullptr, -3, 3,
        NumberRange{-attractor::longestShadow, attractor::longestShadow, NumberRange::Ends::Closed}},
    NumberText{
        &Appearance::shadowLength, QT_TRANSLATE_NOOP("view::AppearancePanel", "Shadow backwards"),
        QT_TRANSLATE_NOOP("view::AppearancePanel",
                          "How far up the shadow of what is 1 high ends; below 0, it falls to the front"),
        nullptr, -3, 3,
        NumberRange{-attractor::longestShadow, attractor::longestShadow, NumberRange::Ends::Closed}},
};
static_assert(std::tuple_size_v<decltype(numberTexts)> == attractor::appearanceNumbers.size());

QString translated(const char* text) {
    return QCoreApplication::translate("view::AppearancePanel", text);
}

} // namespace

NumberRows::NumberRows(QFormLayout* form, document::Document* document, QWidget* parent)
    : QObject(parent), m_form(form), m_edit(document) {
    for (const AppearanceNumber& number : attractor::appearanceNumbers)
        addRow(number, parent);
}

void NumberRows::addRow(const AppearanceNumber& number, QWidget* parent) {
    using Scale = AppearanceSlider::Scale;
    const NumberText& text = *std::ranges::find(numberTexts, number.member, &NumberText::member);
    const QString title = translated(text.title);
    const bool isFactor = number.scale == AppearanceNumber::Scale::Factor;
    auto* slider = new AppearanceSlider(title, text.lowest, text.highest,
                                        isFactor ? Scale::Logarithmic : Scale::Bounded, parent);
    if (text.typed) slider->field()->setRange(*text.typed);
    if (text.explanation)
        slider->explain(translated(text.tip), translated(text.explanation));
    else
        slider->setToolTip(translated(text.tip));
    connect(slider, &AppearanceSlider::tried, this, [this, title, member = number.member](double value) {
        m_edit.preview(translated("%1: %2").arg(title, shortNumber(value)),
                       [&](document::Fractal& fractal) { fractal.appearance.*member = value; });
    });
    connect(slider, &AppearanceSlider::accepted, this, [this] { m_edit.commit(); });
    connect(slider, &AppearanceSlider::rejected, this, [this] { m_edit.cancel(); });
    m_form->addRow(title, slider);
    m_sliders.push_back(slider);
}

AppearanceSlider* NumberRows::slider(double Appearance::*member) const {
    const auto number = std::ranges::find(attractor::appearanceNumbers, member, &AppearanceNumber::member);
    return m_sliders[std::size_t(number - attractor::appearanceNumbers.begin())];
}

void NumberRows::follow(const Appearance& appearance) {
    for (const AppearanceNumber& number : attractor::appearanceNumbers)
        slider(number.member)->setValue(appearance.*number.member);
    m_hasShadow = appearance.shadow > 0;
    showRows();
}

void NumberRows::setVisible(bool tones, bool shadow) {
    m_showsTones = tones;
    m_showsShadow = shadow;
    showRows();
}

// Rows of a shadow that is not there stay where they are: one that came would push away what the hand holds.
void NumberRows::showRows() {
    for (const AppearanceNumber& number : attractor::appearanceNumbers) {
        const bool isTone = number.part == AppearanceNumber::Part::Tone;
        const bool isUsed = m_hasShadow || number.member == &Appearance::shadow;
        m_form->setRowVisible(slider(number.member), isTone ? m_showsTones : m_showsShadow);
        if (isTone) continue;
        slider(number.member)->setEnabled(isUsed);
        m_form->labelForField(slider(number.member))->setEnabled(isUsed);
    }
}

} // namespace view
