// SPDX-License-Identifier: MIT
#include "dialogs/command_synonyms.h"

#include "app/gui/window_fixture.h"
#include "attractor/space_systems.h"
#include "dialogs/command_palette.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/space_export_dialog.h"
#include "dialogs/guide.h"
#include "io/solid/mesh_writer.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "widgets/choices.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QStringList>
#include <QTest>
#include <QTextBrowser>

// Every synonym leads to a command of the window, in every language.
class CommandSynonymsTest : public WindowFixture {
    Q_OBJECT

private slots:
    void eachIsOfACommand_data();
    void eachIsOfACommand();
    void wordsOfOthersFindTheirCommand_data();
    void wordsOfOthersFindTheirCommand();
    void someWordsComeFirst_data();
    void someWordsComeFirst();
    void americanSpellingFindsTheSame();
    void aMeshIsExportedWhereThereIsASolid();
    void machinesGetAnOutline();
    void theGuideOpensWithTheWords();

private:
    static QStringList foundBy(const QString& word);
    void run(const QString& words) const {
        view::CommandPalette palette(view::actionsOf(*m_window));
        palette.findChild<QLineEdit*>()->setText(words);
        QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
    }
};

void CommandSynonymsTest::eachIsOfACommand_data() {
    support::addLanguages();
}

void CommandSynonymsTest::eachIsOfACommand() {
    QFETCH(QString, language);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    const MainWindow window;
    QSet<QString> names;
    for (const view::NamedAction& action : view::actionsOf(window))
        names.insert(action.path.section(QStringLiteral(" › "), -1));
    for (const view::CommandSynonyms& each : view::commandSynonyms()) {
        const QString name = QCoreApplication::translate(each.context, each.text).remove(u'&').remove(u'…');
        QVERIFY2(names.contains(name), qPrintable(name));
        QVERIFY(!view::synonymsOf(name).isEmpty());
        const QString words = QCoreApplication::translate("view::CommandSynonyms", each.words);
        QCOMPARE(words.count(u'|'), QString::fromUtf8(each.words).count(u'|'));
    }
}

void CommandSynonymsTest::wordsOfOthersFindTheirCommand_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("command");
    const auto row = [](const char* language, const char* word, const char* command) {
        QTest::addRow("%s %s", language, word)
            << QString::fromLatin1(language) << QString::fromUtf8(word) << QString::fromUtf8(command);
    };
    row("en", "stl", "Export Picture");
    row("en", "render", "Export Picture");
    row("en", "turntable", "Orbit");
    row("en", "mp4", "Export Animation");
    row("en", "worksheet", "Print Handout");
    row("en", "breed", "Variations");
    row("en", "mutate", "Variations");
    row("en", "mirror", "Flip Horizontally");
    row("en", "laser", "Export Picture");
    row("en", "plotter", "Export Picture");
    row("en", "cutter", "Export Picture");
    row("en", "dxf", "Export Picture");
    row("en", "millimetres", "Export Picture");
    row("en", "millimeters", "Export Picture");
    row("en", "transparent", "Export Picture");
    row("en", "gif", "Export Animation");
    row("en", "video", "Export Animation");
    row("en", "email", "Copy Link");
    row("en", "mail", "Copy Link");
    row("en", "send", "Copy Link");
    row("en", "share", "Copy Link");
    row("en", "reorder", "Move Up");
    row("de", "Schneideplotter", "Bild exportieren");
    row("de", "gif", "Animation exportieren");
    row("de", "teilen", "Link kopieren");
    row("de", "umordnen", "Nach oben");
    row("es", "láser", "Exportar imagen");
    row("es", "vídeo", "Exportar animación");
    row("es", "compartir", "Copiar enlace");
    row("fr", "traceur", "Exporter l’image");
    row("fr", "vidéo", "Exporter l’animation");
    row("fr", "partager", "Copier le lien");
    row("mk", "ласер", "Извези слика");
    row("mk", "видео", "Извези анимација");
    row("mk", "сподели", "Копирај врска");
    row("de", "stl", "Bild exportieren");
    row("de", "Drehteller", "Umlauf");
    row("de", "Arbeitsblatt", "Handout drucken");
    row("de", "render", "Bild exportieren"); // the English word is found, too
}

void CommandSynonymsTest::wordsOfOthersFindTheirCommand() {
    QFETCH(QString, language);
    QFETCH(QString, word);
    QFETCH(QString, command);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    const QStringList found = foundBy(word).mid(0, 3);
    QVERIFY2(found.contains(command), qPrintable(found.join(u'|')));
}

// Before commands that have the word in their names.
void CommandSynonymsTest::someWordsComeFirst_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("word");
    QTest::addColumn<QByteArray>("command"); // in the source
    const auto row = [](const char* language, const char* word, const char* command) {
        QTest::addRow("%s %s", language, word)
            << QString::fromLatin1(language) << QString::fromUtf8(word) << QByteArray(command);
    };
    const char* const flip = "&Transform…";
    row("en", "flip", flip);
    row("en", "mirror", flip);
    row("de", "spiegeln", flip);
    row("es", "reflejar", flip);
    row("fr", "miroir", flip);
    row("mk", "преврти", flip);
    const char* const analysis = "Analysis";
    row("en", "dimension", analysis);
    row("en", "proof", analysis);
    row("en", "certificate", analysis);
    row("de", "Dimension", analysis);
    row("es", "dimensión", analysis);
    row("fr", "dimension", analysis);
    row("mk", "димензија", analysis);
}

void CommandSynonymsTest::someWordsComeFirst() {
    QFETCH(QString, language);
    QFETCH(QString, word);
    QFETCH(QByteArray, command);
    const support::Spoken spoken(language);
    QVERIFY(spoken.isInstalled());
    const QString name =
        QCoreApplication::translate("MainWindow", command.constData()).remove(u'&').remove(u'…').trimmed();
    QCOMPARE(foundBy(word).constFirst(), name);
}

void CommandSynonymsTest::americanSpellingFindsTheSame() {
    QCOMPARE(foundBy(QStringLiteral("color")), foundBy(QStringLiteral("colour")));
    QVERIFY(foundBy(QStringLiteral("colors")).contains(QStringLiteral("Appearance")));
    QVERIFY(foundBy(QStringLiteral("center")).contains(QStringLiteral("Fit")));
}

// Names, the best first, without their menus and keys.
QStringList CommandSynonymsTest::foundBy(const QString& word) {
    const MainWindow window;
    view::CommandPalette palette(view::actionsOf(window));
    palette.findChild<QLineEdit*>()->setText(word);
    const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
    QStringList found;
    for (int row = 0; row < model->rowCount() - 1; ++row) // the last one leads to the guide
        found << model->index(row, 0)
                     .data()
                     .toString()
                     .section(QStringLiteral(" › "), -1)
                     .section(QStringLiteral("    "), 0, 0)
                     .trimmed();
    return found;
}

// Whatever was exported last.
void CommandSynonymsTest::aMeshIsExportedWhereThereIsASolid() {
    run(QStringLiteral("stl"));
    QVERIFY(!m_window->findChild<view::ExportShell*>()); // of a picture in the plane
    document::Fractal solid;
    solid.name = QStringLiteral("menger");
    solid.shape = document::Shape<3>{systems::menger()};
    m_window->document().setFile(document::fileOf(solid));
    run(QStringLiteral("obj"));
    const auto* dialog = m_window->findChild<view::SpaceExportDialog*>();
    QVERIFY(dialog);
    QVERIFY(view::chosenValue<view::SpaceExportDialog::Format>(dialog->findChild<QComboBox*>()) ==
            view::SpaceExportDialog::Format(io::MeshFormat::Obj));
}

// Whatever was exported last.
void CommandSynonymsTest::machinesGetAnOutline() {
    for (const char* word : {"laser cutter", "engrave"}) {
        run(QLatin1String(word));
        auto* dialog = m_window->findChild<view::ExportDialog*>();
        QVERIFY2(dialog, word);
        QCOMPARE(view::chosenValue<io::ShapeStyle>(dialog->findChild<QComboBox*>(QStringLiteral("style"))),
                 io::ShapeStyle::Outline);
        QVERIFY(!dialog->findChild<QComboBox*>(QStringLiteral("style"))->isHidden());
        QVERIFY(dialog->findChild<view::ExportSizeEditor*>()->isOnPaper());
        dialog->close();
        QTRY_VERIFY(!m_window->findChild<view::ExportDialog*>());
    }
}

void CommandSynonymsTest::theGuideOpensWithTheWords() {
    view::searchGuide(m_window.get(), QStringLiteral("barycentric"));
    const auto* page = m_window->findChild<QTextBrowser*>();
    QVERIFY(page);
    QTRY_VERIFY(!page->extraSelections().isEmpty());
}

BARYCAGE_TEST(CommandSynonymsTest, QApplication);
#include "command_synonyms_test.moc"
