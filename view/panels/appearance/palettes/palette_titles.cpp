// SPDX-License-Identifier: MIT
#include "panels/appearance/palettes/palette_titles.h"

#include "attractor/colour/palette_library.h"

#include <QCoreApplication>

#include <algorithm>

namespace view {

namespace {

// Names for the translators: the palettes themselves know no Qt.
[[maybe_unused]] constexpr const char* names[] = {
    QT_TRANSLATE_NOOP("Palette", "Maple"),       QT_TRANSLATE_NOOP("Palette", "Fern"),
    QT_TRANSLATE_NOOP("Palette", "Glacier"),     QT_TRANSLATE_NOOP("Palette", "Orchid"),
    QT_TRANSLATE_NOOP("Palette", "Aurora"),      QT_TRANSLATE_NOOP("Palette", "Dusk"),
    QT_TRANSLATE_NOOP("Palette", "Copper"),      QT_TRANSLATE_NOOP("Palette", "Lagoon"),
    QT_TRANSLATE_NOOP("Palette", "Silver"),      QT_TRANSLATE_NOOP("Palette", "Ink"),
    QT_TRANSLATE_NOOP("Palette", "Herbarium"),   QT_TRANSLATE_NOOP("Palette", "Sanguine"),
    QT_TRANSLATE_NOOP("Palette", "Cyanotype"),   QT_TRANSLATE_NOOP("Palette", "%1 Glow"),
    QT_TRANSLATE_NOOP("Palette", "%1 to %2"),    QT_TRANSLATE_NOOP("Palette", "%1 into %2"),
    QT_TRANSLATE_NOOP("Palette", "%1 Spectrum"), QT_TRANSLATE_NOOP("Palette", "%1 Pastel"),
    QT_TRANSLATE_NOOP("Palette", "%1 Metal"),    QT_TRANSLATE_NOOP("Palette", "%1 Bands"),
    QT_TRANSLATE_NOOP("Palette", "%1 Ink"),      QT_TRANSLATE_NOOP("Palette", "%1 and %2"),
    QT_TRANSLATE_NOOP("Palette", "%1 Twilight"), QT_TRANSLATE_NOOP("Palette", "%1 Wheel"),
    QT_TRANSLATE_NOOP("Palette", "Rose"),        QT_TRANSLATE_NOOP("Palette", "Crimson"),
    QT_TRANSLATE_NOOP("Palette", "Scarlet"),     QT_TRANSLATE_NOOP("Palette", "Vermilion"),
    QT_TRANSLATE_NOOP("Palette", "Orange"),      QT_TRANSLATE_NOOP("Palette", "Amber"),
    QT_TRANSLATE_NOOP("Palette", "Gold"),        QT_TRANSLATE_NOOP("Palette", "Lemon"),
    QT_TRANSLATE_NOOP("Palette", "Lime"),        QT_TRANSLATE_NOOP("Palette", "Grass"),
    QT_TRANSLATE_NOOP("Palette", "Emerald"),     QT_TRANSLATE_NOOP("Palette", "Jade"),
    QT_TRANSLATE_NOOP("Palette", "Teal"),        QT_TRANSLATE_NOOP("Palette", "Sea"),
    QT_TRANSLATE_NOOP("Palette", "Cyan"),        QT_TRANSLATE_NOOP("Palette", "Sky"),
    QT_TRANSLATE_NOOP("Palette", "Azure"),       QT_TRANSLATE_NOOP("Palette", "Cobalt"),
    QT_TRANSLATE_NOOP("Palette", "Sapphire"),    QT_TRANSLATE_NOOP("Palette", "Indigo"),
    QT_TRANSLATE_NOOP("Palette", "Violet"),      QT_TRANSLATE_NOOP("Palette", "Purple"),
    QT_TRANSLATE_NOOP("Palette", "Magenta"),     QT_TRANSLATE_NOOP("Palette", "Fuchsia"),
};

QString translated(std::string_view english) {
    return QCoreApplication::translate("Palette", std::string(english).c_str());
}

QString titleOf(const attractor::LibraryPalette& entry) {
    const QString title = translated(entry.pattern).arg(translated(entry.hue));
    return entry.otherHue.empty() ? title : title.arg(translated(entry.otherHue));
}

const attractor::LibraryPalette* entryOf(const attractor::Palette& palette) {
    const auto library = attractor::paletteLibrary();
    const auto found = std::ranges::find(library, palette, &attractor::LibraryPalette::palette);
    return found == library.end() ? nullptr : &*found;
}

} // namespace

QString paletteTitle(const attractor::Palette& palette) {
    if (const attractor::Palette* known = attractor::findPalette(palette.name); known && *known == palette)
        return translated(palette.name);
    const attractor::LibraryPalette* entry = entryOf(palette);
    return entry ? titleOf(*entry) : QString::fromStdString(palette.name);
}

bool isOfLibrary(const attractor::Palette& palette) {
    return entryOf(palette) != nullptr;
}

std::vector<TitledPalette> titledPalettes() {
    std::vector<TitledPalette> all;
    for (const attractor::Palette& palette : attractor::builtInPalettes())
        all.push_back({palette, translated(palette.name)});
    for (const attractor::LibraryPalette& entry : attractor::paletteLibrary())
        all.push_back({entry.palette, titleOf(entry)});
    return all;
}

} // namespace view
