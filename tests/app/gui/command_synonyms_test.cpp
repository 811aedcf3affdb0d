// SPDX-License-Identifier: MIT
#include "dialogs/command_synonyms.h"

#include "app/gui/window_fixture.h"
#include "attractor/space_systems.h"
#include "dialogs/command_palette.h"
#include "dialogs/export/space_export_dialog.h"
#include "dialogs/guide.h"
#include "io/solid/mesh_writer.h"
#include "support/languages.h"
#include "support/named_test.h"
#include "widgets/choices.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
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
    void aMeshIsExportedWhereThereIsASolid();
    void theGuideOpensWithTheWords();

private:
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
    const MainWindow window;
    view::CommandPalette palette(view::actionsOf(window));
    palette.findChild<QLineEdit*>()->setText(word);
    const QAbstractItemModel* model = palette.findChild<QListView*>()->model();
    QStringList found;
    for (int row = 0; row < qMin(3, model->rowCount()); ++row)
        found << model->index(row, 0)
                     .data()
                     .toString()
                     .section(QStringLiteral(" › "), -1)
                     .section(QStringLiteral("    "), 0, 0);
    QVERIFY2(found.contains(command), qPrintable(found.join(u'|')));
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

void CommandSynonymsTest::theGuideOpensWithTheWords() {
    view::searchGuide(m_window.get(), QStringLiteral("barycentric"));
    const auto* page = m_window->findChild<QTextBrowser*>();
    QVERIFY(page);
    QTRY_VERIFY(!page->extraSelections().isEmpty());
}

BARYCAGE_TEST(CommandSynonymsTest, QApplication);
#include "command_synonyms_test.moc"
