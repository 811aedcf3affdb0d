// SPDX-License-Identifier: MIT
#include "dialogs/command_synonyms.h"

#include <QCoreApplication>
#include <QStringList>

namespace view {

namespace {

// Words that users of other programs type, and names of the results. A translation has the words of its own
// language, not translations of these. The words in front of a bar mean this command rather than those that
// have them in their names; translations have the bar, too.
constexpr CommandSynonyms synonyms[] = {
    {"MainWindow", "&Export Picture…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms",
                       "render save image picture png svg pdf jpeg tiff webp exr poster wallpaper stl obj "
                       "ply glb mesh print 3d laser plotter cutter engrave dxf outline vector transparent "
                       "millimetres")},
    {"MainWindow", "Export Ani&mation…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms",
                       "render video movie film mp4 webm gif apng frames cluster slurm")},
    {"MainWindow", "Export &Data…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "flame apophysis csv table points cloud ply ifstile save")},
    {"MainWindow", "Export We&b Page…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms",
                       "share send browser html embed publish interactive mail email")},
    {"MainWindow", "Copy &Link",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "share send email mail post message url")},
    {"MainWindow", "Analysis",
     QT_TRANSLATE_NOOP(
         "view::CommandSynonyms",
         "dimension proof certificate | prove certified Hausdorff area measure overlap connected")},
    {"MainWindow", "&Collection",
     QT_TRANSLATE_NOOP("view::CommandSynonyms",
                       "gallery examples library favourites leaf tree fern snowflake dragon sponge")},
    {"MainWindow", "Links",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "linked maps graph-directed which follows which forbidden")},
    {"MainWindow", "Appearance",
     QT_TRANSLATE_NOOP(
         "view::CommandSynonyms",
         "colours palette gradient hue background transparent brightness contrast black white grey")},
    {"view::EntriesPanel", "Move &Up",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "reorder rearrange order sort")},
    {"view::EntriesPanel", "Move &Down",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "reorder rearrange order sort")},
    {"MainWindow", "&Copy Picture", QT_TRANSLATE_NOOP("view::CommandSynonyms", "clipboard screenshot image")},
    {"MainWindow", "&Print…", QT_TRANSLATE_NOOP("view::CommandSynonyms", "paper printer pdf page")},
    {"MainWindow", "Print &Handout…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "worksheet class students exercise paper teacher")},
    {"MainWindow", "&Variations…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "mutate mutation vary breed evolve grow similar")},
    {"MainWindow", "Add Ra&ndom Fractal…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "surprise chance lucky generate dice new")},
    {"MainWindow", "Flip &Horizontally",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "mirror reflect reverse")},
    {"MainWindow", "Flip &Vertically",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "mirror reflect upside down")},
    {"MainWindow", "&Transform…",
     QT_TRANSLATE_NOOP(
         "view::CommandSynonyms",
         "flip mirror reflect | rotate scale shear move shift turn size resize bigger larger smaller")},
    {"MainWindow", "S&hadow",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "shade silhouette drop cast ground light sun")},
    {"MainWindow", "&Reset",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "undo original restore straighten start over again")},
    {"MainWindow", "Fit &Minimal Canonical Simplex",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "hull triangle tight smallest")},
    {"MainWindow", "&Bake", QT_TRANSLATE_NOOP("view::CommandSynonyms", "apply freeze write flatten")},
    {"MainWindow", "&Duplicate Maps", QT_TRANSLATE_NOOP("view::CommandSynonyms", "copy clone")},
    {"MainWindow", "&Fit", QT_TRANSLATE_NOOP("view::CommandSynonyms", "centre home whole zoom all")},
    {"MainWindow", "F&ull Screen", QT_TRANSLATE_NOOP("view::CommandSynonyms", "maximise whole")},
    {"MainWindow", "&Lift to Space", QT_TRANSLATE_NOOP("view::CommandSynonyms", "3d extrude solid")},
    {"MainWindow", "&Preferences…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms",
                       "settings options language theme dark light configuration motion")},
    {"MainWindow", "&Keyboard and Mouse…",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "shortcuts keys hotkeys gestures")},
    {"MainWindow", "&User Guide", QT_TRANSLATE_NOOP("view::CommandSynonyms", "help manual documentation")},
    {"MainWindow", "&Tour",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "tutorial introduction beginner learn")},
    {"MainWindow", "A&nimate",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "timeline motion movie keyframes speed faster slower morph")},
    {"view::TimelinePanel", "Breeze", QT_TRANSLATE_NOOP("view::CommandSynonyms", "sway wind storm blow")},
    {"view::TimelinePanel", "Orbit",
     QT_TRANSLATE_NOOP("view::CommandSynonyms", "turntable spin rotate camera")},
    {"view::TimelinePanel", "Turn", QT_TRANSLATE_NOOP("view::CommandSynonyms", "spin rotate")},
    {"view::TimelinePanel", "Breathe", QT_TRANSLATE_NOOP("view::CommandSynonyms", "pulse grow shrink")},
    {"view::TimelinePanel", "Palette Cycle", QT_TRANSLATE_NOOP("view::CommandSynonyms", "colours rainbow")},
    {"view::TimelinePanel", "Zoom In Endlessly", QT_TRANSLATE_NOOP("view::CommandSynonyms", "infinite dive")},
};

// The name as a menu shows it, without the marks of its key and of a dialog.
QString plainName(QString text) {
    return text.remove(u'&').remove(u'…');
}

bool isNamed(const CommandSynonyms& each, const QString& name) {
    const QString shown = plainName(QCoreApplication::translate(each.context, each.text));
    return shown.compare(name, Qt::CaseInsensitive) == 0;
}

} // namespace

std::span<const CommandSynonyms> commandSynonyms() {
    return synonyms;
}

QString firstSynonymsOf(const QString& name) {
    QStringList words;
    for (const CommandSynonyms& each : synonyms) {
        const QString here = QString::fromUtf8(each.words);
        if (!here.contains(u'|') || !isNamed(each, name)) continue;
        words << QCoreApplication::translate("view::CommandSynonyms", each.words).section(u'|', 0, 0)
              << here.section(u'|', 0, 0);
    }
    return words.join(u' ');
}

QString synonymsOf(const QString& name) {
    QStringList words;
    for (const CommandSynonyms& each : synonyms) {
        if (!isNamed(each, name)) continue;
        words << QCoreApplication::translate("view::CommandSynonyms", each.words)
              << QString::fromUtf8(each.words) << plainName(QString::fromUtf8(each.text));
    }
    return words.join(u' ');
}

} // namespace view
