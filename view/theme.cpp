// SPDX-License-Identifier: MIT
#include "theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>

namespace view {

namespace {

struct Colours {
    QRgb window, base, alternate, text, button, light, midlight, mid, dark, shadow, highlight, link, disabled;
};

constexpr Colours lightColours{0xffefefef, 0xffffffff, 0xfff6f6f6, 0xff1c1c1c, 0xffefefef,
                               0xffffffff, 0xffe4e4e4, 0xffb8b8b8, 0xff9f9f9f, 0xff767676,
                               0xff2a6fb0, 0xff1d5fa8, 0xff8c8c8c};
constexpr Colours darkColours{0xff2b2b2e, 0xff1d1d20, 0xff252528, 0xffe8e8e8, 0xff38383c,
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
    const bool own = theme != Preferences::Theme::Desktop;
    // Only this style of the toolkit takes every colour from the palette.
    const QString style = own ? QStringLiteral("fusion") : desktopStyle;
    if (QApplication::style()->name().compare(style, Qt::CaseInsensitive) != 0) QApplication::setStyle(style);
    QApplication::setPalette(own ? paletteOf(theme == Preferences::Theme::Dark ? darkColours : lightColours)
                                 : QPalette());
    completePalette();
}

} // namespace view
