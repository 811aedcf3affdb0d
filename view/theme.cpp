// SPDX-License-Identifier: MIT
#include "theme.h"

#include <QApplication>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOptionButton>

#include <utility>

namespace view {

namespace {

struct Colours {
    QRgb window, base, alternate, text, button, light, midlight, mid, dark, shadow, highlight, link, disabled;
};

constexpr Colours lightColours{0xffefefef, 0xffffffff, 0xfff6f6f6, 0xff1c1c1c, 0xffefefef,
                               0xffffffff, 0xffe4e4e4, 0xffb8b8b8, 0xff9f9f9f, 0xff767676,
                               0xff2a6fb0, 0xff1d5fa8, 0xff8c8c8c};
constexpr Colours darkColours{0xff333337, 0xff1d1d20, 0xff252528, 0xffe8e8e8, 0xff434348,
                              0xff55555a, 0xff424247, 0xff242427, 0xff19191b, 0xff0e0e10,
                              0xff2f7ac2, 0xff72b2f2, 0xff808084};

QPalette paletteOf(const Colours& colours) {
    QPalette palette;
    for (const auto& [role, colour] : {std::pair{QPalette::Window, colours.window},
                                       {QPalette::Base, colours.base},
                                       {QPalette::AlternateBase, colours.alternate},
                                       {QPalette::ToolTipBase, colours.button},
                                       {QPalette::Button, colours.button},
                                       {QPalette::Light, colours.light},
                                       {QPalette::Midlight, colours.midlight},
                                       {QPalette::Mid, colours.mid},
                                       {QPalette::Dark, colours.dark},
                                       {QPalette::Shadow, colours.shadow},
                                       {QPalette::WindowText, colours.text},
                                       {QPalette::Text, colours.text},
                                       {QPalette::ButtonText, colours.text},
                                       {QPalette::ToolTipText, colours.text},
                                       {QPalette::BrightText, 0xffffffff},
                                       {QPalette::Highlight, colours.highlight},
                                       {QPalette::HighlightedText, 0xffffffff},
                                       {QPalette::Link, colours.link},
                                       {QPalette::LinkVisited, colours.link}})
        palette.setColor(role, QColor::fromRgba(colour));
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText})
        palette.setColor(QPalette::Disabled, role, QColor::fromRgba(colours.disabled));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgba(colours.mid));
    return palette;
}

const QString fusion = QStringLiteral("fusion");

// Fusion draws the frames of boxes and circles to be checked a shade darker than the window, which is hardly
// seen in light themes and not at all in dark ones. Here they stand out from it at least by 3 to 1.
class ClearFusion : public QProxyStyle {
public:
    ClearFusion() : QProxyStyle(fusion) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        const auto* button = qstyleoption_cast<const QStyleOptionButton*>(option);
        if (!button || (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton)) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return;
        }
        QStyleOptionButton clear = *button;
        const QColor frame =
            mixed(clear.palette.color(QPalette::Window), clear.palette.color(QPalette::WindowText), 0.6);
        clear.palette.setColor(QPalette::Window, frame.lighter(fusionDarkens));
        QProxyStyle::drawPrimitive(element, &clear, painter, widget);
    }

    // Its ticks and crosses are of another hand than our icons.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* result) const override {
        return hint == SH_DialogButtonBox_ButtonsHaveIcons
                   ? 0
                   : QProxyStyle::styleHint(hint, option, widget, result);
    }

private:
    static constexpr int fusionDarkens = 127; // percent: from the window to the frame

    static QColor mixed(const QColor& from, const QColor& to, float share) {
        const auto mix = [share](float a, float b) { return a + share * (b - a); };
        return QColor::fromRgbF(mix(from.redF(), to.redF()), mix(from.greenF(), to.greenF()),
                                mix(from.blueF(), to.blueF()));
    }
};

} // namespace

void completePalette() {
    QPalette palette = QApplication::palette();
    QColor quiet = palette.color(QPalette::Active, QPalette::Text);
    quiet.setAlpha(150);
    if (palette.color(QPalette::Active, QPalette::PlaceholderText) == quiet) return;
    palette.setColor(QPalette::PlaceholderText, quiet);
    QApplication::setPalette(palette);
}

void wear(Preferences::Theme theme) {
    static const QString desktopStyle = QApplication::style()->name();
    static QString worn;
    const bool own = theme != Preferences::Theme::Desktop;
    // Only this style of the toolkit takes every colour from the palette.
    if (const QString style = own ? fusion : desktopStyle; style != std::exchange(worn, style)) {
        if (style.compare(fusion, Qt::CaseInsensitive) == 0)
            QApplication::setStyle(new ClearFusion);
        else
            QApplication::setStyle(style);
    }
    QApplication::setPalette(own ? paletteOf(theme == Preferences::Theme::Dark ? darkColours : lightColours)
                                 : QPalette());
    completePalette();
}

} // namespace view
