// SPDX-License-Identifier: MIT
#include "theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>

namespace view {

namespace {

struct RoleColour {
    QPalette::ColorGroup group;
    QPalette::ColorRole role;
    QRgb light, dark;
};

constexpr RoleColour colours[] = {
    {QPalette::All, QPalette::Window, 0xffefefef, 0xff333337},
    {QPalette::All, QPalette::Base, 0xffffffff, 0xff1d1d20},
    {QPalette::All, QPalette::AlternateBase, 0xfff6f6f6, 0xff252528},
    {QPalette::All, QPalette::ToolTipBase, 0xffefefef, 0xff434348},
    {QPalette::All, QPalette::Button, 0xffefefef, 0xff434348},
    {QPalette::All, QPalette::Light, 0xffffffff, 0xff55555a},
    {QPalette::All, QPalette::Midlight, 0xffe4e4e4, 0xff424247},
    {QPalette::All, QPalette::Mid, 0xffb8b8b8, 0xff242427},
    {QPalette::All, QPalette::Dark, 0xff9f9f9f, 0xff19191b},
    {QPalette::All, QPalette::Shadow, 0xff767676, 0xff0e0e10},
    {QPalette::All, QPalette::WindowText, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::Text, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::ButtonText, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::ToolTipText, 0xff1c1c1c, 0xffe8e8e8},
    {QPalette::All, QPalette::BrightText, 0xffffffff, 0xffffffff},
    {QPalette::All, QPalette::Highlight, 0xff2a6fb0, 0xff2f7ac2},
    {QPalette::All, QPalette::HighlightedText, 0xffffffff, 0xffffffff},
    {QPalette::All, QPalette::Link, 0xff1d5fa8, 0xff72b2f2},
    {QPalette::All, QPalette::LinkVisited, 0xff1d5fa8, 0xff72b2f2},
    {QPalette::Disabled, QPalette::WindowText, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::Text, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::ButtonText, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::HighlightedText, 0xff8c8c8c, 0xff808084},
    {QPalette::Disabled, QPalette::Highlight, 0xffb8b8b8, 0xff242427},
};

QPalette paletteOf(Preferences::Theme theme) {
    QPalette palette;
    for (const RoleColour& colour : colours)
        palette.setColor(colour.group, colour.role,
                         QColor::fromRgba(theme == Preferences::Theme::Dark ? colour.dark : colour.light));
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
    QApplication::setPalette(own ? paletteOf(theme) : QPalette());
    completePalette();
}

} // namespace view
