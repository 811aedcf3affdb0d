// SPDX-License-Identifier: MIT
#include "app/gui/choose_file.h"
#include "app/gui/window_fixture.h"
#include "desktop/settings.h"
#include "panels/appearance/palettes/gradient_editor.h"
#include "support/commands.h"
#include "support/named_test.h"
#include "support/unprivileged.h"
#include "widgets/file_dialogs.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <functional>

using namespace Qt::StringLiterals;

// The names that dialogs suggest for new files come from entries and palettes of a file.
class SuggestedNamesTest : public WindowFixture {
    Q_OBJECT

private slots:
    void theyAreNamesOfFiles_data();
    void theyAreNamesOfFiles();
    void palettesAreNoPaths_data() { names(); }
    void palettesAreNoPaths();
    void foldersThatRefuseAreNotKept();
    void theEndingStays();

private:
    static void names() {
        QTest::addColumn<QString>("name");
        for (const QString& name :
             {u"/etc/x"_s, u"../up"_s, u"a/b"_s, u".hidden"_s, u"a\u202ez"_s, u"a\U000e0041z"_s, u"a\nz"_s})
            QTest::newRow(name.toUtf8().toPercentEncoding().constData()) << name;
    }
    // What the dialog that `command` opens suggests.
    static QString suggestedBy(const std::function<void()>& command) {
        QString suggested;
        QTimer answering;
        connect(&answering, &QTimer::timeout, &answering, [&suggested] {
            auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!files) return;
            const QString name = files->findChild<QLineEdit*>(u"fileNameEdit"_s)->text();
            suggested = files->directory().absolutePath() + u'/' + name;
            files->reject();
        });
        answering.start(10);
        command();
        return suggested;
    }
    static void verify(const QString& suggested, const QString& folder) {
        const QString name = suggested.sliced(suggested.lastIndexOf(u'/') + 1);
        // Where a busy machine does not answer in time, dialogs begin at home.
        const bool isThere = suggested == QDir(folder).absoluteFilePath(name) ||
                             suggested == QDir::home().absoluteFilePath(name);
        QVERIFY2(isThere, qPrintable(suggested));
        QVERIFY2(!name.isEmpty() && !name.startsWith(u'.'), qPrintable(suggested));
        for (const QString& unseen : {u"\u202e"_s, u"\n"_s, u"\U000e0041"_s})
            QVERIFY2(!name.contains(unseen), name.toUtf8().toPercentEncoding().constData());
    }
    void beginIn(const QString& folder) { QSettings().setValue(u"dialogs/folder"_s, folder); }

    QTemporaryDir m_folder;
};

void SuggestedNamesTest::theyAreNamesOfFiles_data() {
    names();
}

void SuggestedNamesTest::theyAreNamesOfFiles() {
    QFETCH(const QString, name);
    beginIn(m_folder.path());
    document::Fractal renamed = m_window->document().fractal();
    renamed.name = name;
    m_window->document().setFile(document::fileOf(renamed));
    for (const char* id : {"save-as", "save-for-other-programs", "export-web-page"}) {
        const QString suggested = suggestedBy([&] { support::command(*m_window, id)->trigger(); });
        QVERIFY2(!suggested.isEmpty(), id);
        verify(suggested, m_folder.path());
        if (QTest::currentTestFailed()) return;
    }
}

void SuggestedNamesTest::palettesAreNoPaths() {
    QFETCH(const QString, name);
    beginIn(m_folder.path());
    view::GradientEditor editor;
    attractor::Palette palette = attractor::builtInPalettes().front();
    palette.name = name.toStdString();
    editor.setGradient(palette);
    verify(suggestedBy([&] { editor.findChild<QToolButton*>(u"save-palette"_s)->click(); }), m_folder.path());
}

// What could not be saved there is not what the next dialog begins with.
void SuggestedNamesTest::foldersThatRefuseAreNotKept() {
    const QString refusing = m_folder.filePath(u"refusing"_s);
    QVERIFY(QDir().mkdir(refusing));
    view::store(u"dialogs/folder"_s, m_folder.path());
    QVERIFY(QFile::setPermissions(refusing, QFile::ReadOwner | QFile::ExeOwner));
    QVERIFY(QFile::setPermissions(m_folder.path(),
                                  QFile::permissions(m_folder.path()) | QFile::ReadOther | QFile::ExeOther));
    QVERIFY(view::finishStoring());
    QString chosen;
    {
        const support::Unprivileged nobody(refusing);
        QVERIFY(nobody.isInForce());
        QTimer answering;
        support::chooseFile(answering, refusing + u"/a.png"_s);
        chosen = view::chooseFileToSave(nullptr, u"Save"_s, u"a.png"_s, u"PNG (*.png)"_s, u"png"_s);
    }
    QCOMPARE(chosen, refusing + u"/a.png"_s);
    QCOMPARE(view::stored(u"dialogs/folder"_s).toString(), m_folder.path());
}

void SuggestedNamesTest::theEndingStays() {
    const QString name = view::suggestedName(QString(400, u'ä'), u"lesson"_s);
    QVERIFY(name.endsWith(u"ä.lesson"_s));
    QVERIFY(name.toUtf8().size() <= 255);
}

BARYCAGE_TEST(SuggestedNamesTest, QApplication);
#include "suggested_names_test.moc"
