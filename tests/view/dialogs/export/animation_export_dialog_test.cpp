// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/export/cluster_queue.h"
#include "document/edits/timeline/motion_edits.h"
#include "io/collection_reader.h"
#include "io/fractint/fractint_writer.h"
#include "support/choose.h"
#include "support/forget_settings.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/paths.h"
#include "support/patient_tries.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextDocument>
#include <QTimer>
#include <QToolButton>

#include <memory>

using Dialog = view::AnimationExportDialog;

// The dialog, what it writes, and that this is what the command line writes.
class AnimationExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init();
    void cleanup() { m_dialog.reset(); }
    void videosHoldTheFrames_data();
    void videosHoldTheFrames();
    void picturesAreThoseOfTheCommandLine_data();
    void picturesAreThoseOfTheCommandLine();
    void aSolidIsShownWhole();
    void completePicturesStay();
    void otherPicturesAreAskedAbout();
    void editingGoesOn();
    void stoppingLeavesNothing();
    void closingAsksFirst();
    void theQuestionEndsWithTheExport();
    void theEndingDecidesTheFormat();
    void theTimeLeftIsSaid();
    void failuresAreSaid();
    void whatAFormatLacksIsSaid();
    void aJobFolderHoldsAllThatItNeeds();
    void theHeadingOfAJobFolderIsTheName();
    void slurmIsAskedForTheState_data();
    void slurmIsAskedForTheState();

private:
    QSpinBox* number(const QString& name) const { return named<QSpinBox>(name); }
    Dialog::Section shownSection() const {
        return view::chosenValue<Dialog::Section>(named<QComboBox>(QStringLiteral("Section")));
    }
    template <class Widget> Widget* named(const QString& name) const {
        for (auto* widget : m_dialog->findChildren<Widget*>())
            if (widget->accessibleName() == name) return widget;
        return nullptr;
    }
    void setSize(const QSize& size) {
        named<QToolButton>(QStringLiteral("Lock proportions"))->setChecked(false);
        number(QStringLiteral("Width"))->setValue(size.width());
        number(QStringLiteral("Height"))->setValue(size.height());
    }
    void open(const document::Fractal& entry);
    bool exported(Dialog::Format format, const QString& name);
    QString path(const QString& name) const { return m_folder->filePath(name); }
    QString path(const char* name) const { return path(QString::fromLatin1(name)); }
    void prepare(const QString& folder); // where there is no Slurm
    QStringList files() const { return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<Dialog> m_dialog;
};

namespace {

template <int Dim> document::Fractal shortened(document::Fractal entry) {
    std::get<document::Shape<Dim>>(entry.shape).animation->length = 6;
    return entry;
}

document::Fractal wind() {
    return shortened<2>(
        *document::withWind(document::Document().entryFractal(), animation::swayPresets()[0]));
}

document::Fractal turningSponge() {
    document::Fractal entry;
    entry.name = QStringLiteral("menger");
    entry.shape = document::Shape<3>{systems::menger()};
    return shortened<3>(*document::withOrbit(entry));
}

QStringList list(std::initializer_list<const char*> texts) {
    QStringList result;
    for (const char* text : texts)
        result << QString::fromLatin1(text);
    return result;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

void AnimationExportDialogTest::init() {
    support::forgetSettings();
    m_folder = std::make_unique<QTemporaryDir>();
    open(wind());
}

void AnimationExportDialogTest::open(const document::Fractal& entry) {
    m_dialog.reset();
    m_document = std::make_unique<document::Document>();
    m_document->setFile(document::fileOf(entry));
    Dialog::Camera camera = attractor::View{{0.4, 0.3}, 1.5, attractor::YAxis::Up};
    if (document::space(entry)) {
        attractor::OrbitCamera eye;
        eye.size = {160, 120};
        eye.orientation = attractor::orbit(20, 10);
        eye.target = {0.5, 0.5, 0.5};
        eye.height = 2;
        camera = eye;
    }
    m_dialog = std::make_unique<Dialog>(m_document.get(), camera);
    m_dialog->show();
    setSize({64, 48});
}

void AnimationExportDialogTest::prepare(const QString& folder) {
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", "/nowhere");
    m_dialog->prepareCluster(folder);
    qputenv("PATH", before);
}

bool AnimationExportDialogTest::exported(Dialog::Format format, const QString& name) {
    m_dialog->setFormat(format);
    QSignalSpy spy(m_dialog.get(), &Dialog::exported);
    m_dialog->exportTo(path(name));
    return !spy.isEmpty() || spy.wait(60000);
}

void AnimationExportDialogTest::videosHoldTheFrames_data() {
    QTest::addColumn<QString>("suffix");
    QTest::addColumn<QString>("codec");
    QTest::newRow("MP4") << "mp4"
                         << "h264";
    QTest::newRow("WebM") << "webm"
                          << "vp9";
    QTest::newRow("MKV") << "mkv"
                         << "ffv1";
    QTest::newRow("GIF") << "gif"
                         << "gif";
    QTest::newRow("WebP") << "webp"
                          << "";
    QTest::newRow("APNG") << "apng"
                          << "apng";
}

void AnimationExportDialogTest::videosHoldTheFrames() {
    QFETCH(QString, suffix);
    QFETCH(QString, codec);
    const QString name = QStringLiteral("wind.") + suffix;
    QVERIFY2(exported(io::videoFormat(suffix), name), qPrintable(m_dialog->message()));
    QCOMPARE(files(), QStringList{name});
    const io::Collection again = io::readCollection(contents(path(name)), path(name));
    QCOMPARE(again.file.entries.size(), 1);
    QVERIFY(document::animationFacts(*again.file.entries[0].fractal));
    if (codec.isEmpty() || QStandardPaths::findExecutable(QStringLiteral("ffprobe")).isEmpty()) return;
    QProcess probe;
    probe.start(QStringLiteral("ffprobe"),
                list({"-v", "error", "-count_frames", "-show_streams", "-of", "json"}) << path(name));
    QVERIFY(probe.waitForFinished(30000));
    const QJsonObject stream =
        QJsonDocument::fromJson(probe.readAllStandardOutput()).object()[u"streams"].toArray()[0].toObject();
    QCOMPARE(stream[u"codec_name"].toString(), codec);
    QCOMPARE(stream[u"width"].toInt(), 64);
    QCOMPARE(stream[u"height"].toInt(), 48);
    QCOMPARE(stream[u"nb_read_frames"].toString(), QStringLiteral("6"));
}

void AnimationExportDialogTest::picturesAreThoseOfTheCommandLine_data() {
    QTest::addColumn<bool>("inSpace");
    QTest::addColumn<int>("section");
    QTest::addColumn<int>("shutter");
    QTest::newRow("the whole animation") << false << int(Dialog::Section::Animation) << 0;
    QTest::newRow("the view on the canvas") << false << int(Dialog::Section::View) << 0;
    QTest::newRow("blurred") << false << int(Dialog::Section::Animation) << 180;
    QTest::newRow("in space") << true << int(Dialog::Section::View) << 0;
    QTest::newRow("in space, whole") << true << int(Dialog::Section::Animation) << 0;
}

// With the options that a job folder names, byte for byte.
void AnimationExportDialogTest::picturesAreThoseOfTheCommandLine() {
    QFETCH(bool, inSpace);
    QFETCH(int, section);
    QFETCH(int, shutter);
    if (inSpace) open(turningSponge());
    m_dialog->setSection(Dialog::Section(section));
    number(QStringLiteral("Shutter"))->setValue(shutter);
    number(QStringLiteral("First frame"))->setValue(2);
    number(QStringLiteral("Last frame"))->setValue(3);
    if (!inSpace) support::choose(named<QComboBox>(QStringLiteral("Quality")), 400);
    auto* supersample = number(QStringLiteral("Supersampling"));
    QCOMPARE(supersample->isVisibleTo(m_dialog.get()), inSpace);
    if (inSpace) supersample->setValue(3);
    QVERIFY2(exported(std::nullopt, QStringLiteral("a.png")), qPrintable(m_dialog->message()));
    QCOMPARE(files(), list({"a.0003.png", "a.0004.png"}));
    prepare(m_folder->path());
    const QStringList jobs = QDir(m_folder->path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    QCOMPARE(jobs.size(), 1);
    const QString submit = QString::fromUtf8(contents(path(jobs[0] + QStringLiteral("/submit.sh"))));
    const qsizetype from = submit.indexOf(QStringLiteral("--size"));
    QVERIFY(from > 0);
    QCOMPARE(submit.mid(from).contains(QStringLiteral("--supersample 3")), inSpace);
    QProcess animate;
    animate.setWorkingDirectory(path(jobs[0]));
    animate.start(support::buildPath(QStringLiteral("barycage-cli")),
                  list({"animate", "entry.ifs", "--entry", "#1", "-o", "b.####.png"}) +
                      submit.mid(from).simplified().split(u' '));
    QVERIFY(animate.waitForFinished(60000));
    QCOMPARE(QString::fromUtf8(animate.readAllStandardError()), QString());
    for (const char* file : {"0003.png", "0004.png"}) {
        const QByteArray ours = contents(path(QStringLiteral("a.") + QLatin1String(file)));
        QVERIFY(!ours.isEmpty());
        QVERIFY(contents(path(jobs[0] + QStringLiteral("/b.") + QLatin1String(file))) == ours);
    }
}

// From where it is seen on the canvas; in the plane the view on the canvas is the usual one.
void AnimationExportDialogTest::aSolidIsShownWhole() {
    QCOMPARE(shownSection(), Dialog::Section::View);
    open(turningSponge());
    QCOMPARE(shownSection(), Dialog::Section::Animation);
    QVERIFY(exported(io::VideoFormat::Gif, QStringLiteral("a.gif")));
    const io::Collection again = io::readCollection(contents(path("a.gif")), path("a.gif"));
    const auto camera = document::frameAt(*again.file.entries[0].fractal, animation::moment(0)).camera;
    QVERIFY(camera.has_value());
    QVERIFY(camera->orientation.angularDistance(attractor::orbit(20, 10)) < 1e-7);
    QVERIFY((camera->target - ifs::Vector<3>(0.5, 0.5, 0.5)).norm() < 0.05);
}

void AnimationExportDialogTest::completePicturesStay() {
    QVERIFY(exported(std::nullopt, QStringLiteral("a.png")));
    QCOMPARE(files().size(), 6);
    const QByteArray whole = contents(path("a.0002.png"));
    const QDateTime written = QDateTime::currentDateTime().addDays(-1);
    QFile first(path("a.0001.png"));
    QVERIFY(first.open(QIODevice::ReadWrite) &&
            first.setFileTime(written, QFileDevice::FileModificationTime));
    first.close();
    QVERIFY(QFile::resize(path("a.0002.png"), 100)); // as a full disk would leave it
    QVERIFY(exported(std::nullopt, QStringLiteral("a.png")));
    QVERIFY(contents(path("a.0002.png")) == whole);
    QCOMPARE(QFileInfo(path("a.0001.png")).lastModified(), written);
}

// Also when the name that was typed is that of no file.
void AnimationExportDialogTest::otherPicturesAreAskedAbout() {
    QVERIFY(exported(std::nullopt, QStringLiteral("a.png")));
    for (const QString& name : {QStringLiteral("a.0002.png"), QStringLiteral("a.0005.png")}) {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    }
    QAbstractButton* start = support::button(*m_dialog, "export");
    QStringList asked;
    bool isAgreed = false;
    QString name;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] {
        if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
            for (auto* field : dialog->findChildren<QLineEdit*>())
                field->setText(path(name));
            static_cast<QDialog*>(dialog)->accept();
        } else if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            asked << box->text() + box->informativeText();
            (isAgreed ? support::button(*box, "replace") : box->button(QMessageBox::Cancel))->click();
        }
    });
    timer.start(20);
    QSignalSpy spy(m_dialog.get(), &Dialog::exported);
    for (const char* typed : {"a", "a.0001.png"}) {
        asked.clear();
        name = QString::fromLatin1(typed);
        start->click();
        QCOMPARE(asked.size(), 1);
        QVERIFY2(asked[0].startsWith(u'2') && asked[0].contains(QStringLiteral("a.0002.png")),
                 qPrintable(asked[0]));
        QVERIFY(start->isEnabled() && spy.isEmpty()); // nothing goes on
    }
    QCOMPARE(contents(path("a.0005.png")), QByteArray("mine"));
    isAgreed = true;
    start->click();
    QTRY_COMPARE(spy.size(), 1);
    QCOMPARE(asked.size(), 2);
    QVERIFY(contents(path("a.0005.png")) != "mine");
    start->click(); // now all are its own
    QTRY_COMPARE(spy.size(), 2);
    QCOMPARE(asked.size(), 2);
}

// What is exported is the animation as it was when the dialog opened.
void AnimationExportDialogTest::editingGoesOn() {
    m_dialog->setFormat(io::VideoFormat::Mkv);
    QSignalSpy spy(m_dialog.get(), &Dialog::exported);
    m_dialog->exportTo(path("a.mkv"));
    document::Fractal other = m_document->entryFractal();
    other.name = QStringLiteral("other");
    m_document->editEntry(QStringLiteral("Rename"), other);
    QVERIFY(!spy.isEmpty() || spy.wait(60000));
    const io::Collection again = io::readCollection(contents(path("a.mkv")), path("a.mkv"));
    QVERIFY(again.file.entries[0].fractal->name != other.name);
}

void AnimationExportDialogTest::stoppingLeavesNothing() {
    setSize({1600, 1200});
    support::choose(named<QComboBox>(QStringLiteral("Quality")), 2000);
    m_dialog->setFormat(io::VideoFormat::Mp4);
    m_dialog->exportTo(path("a.mp4"));
    QTRY_VERIFY_WITH_TIMEOUT(m_dialog->findChild<QProgressBar*>()->value() > 0, 60'000);
    auto* stop = support::button(*m_dialog, "close");
    QVERIFY(stop->text().contains(QStringLiteral("Stop")));
    QTest::mouseClick(stop, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(m_dialog->message().contains(QStringLiteral("nothing was written")), 60000);
    QCOMPARE(files(), QStringList());
    QVERIFY(stop->text().contains(QStringLiteral("Close")));
}

void AnimationExportDialogTest::closingAsksFirst() {
    setSize({1600, 1200});
    support::choose(named<QComboBox>(QStringLiteral("Quality")), 2000);
    m_dialog->setFormat(io::VideoFormat::Mp4);
    m_dialog->show();
    m_dialog->exportTo(path("a.mp4"));
    QStringList asked;
    const char* wanted = nullptr;
    QTimer answering;
    connect(&answering, &QTimer::timeout, this, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box) return;
        answering.stop();
        asked << box->text();
        support::button(*box, wanted)->click();
    });
    const auto answer = [&](const char* name) {
        wanted = name;
        answering.start(10);
    };
    answer("continue");
    QTest::keyClick(m_dialog.get(), Qt::Key_Escape);
    QCOMPARE(asked.size(), 1);
    QVERIFY(m_dialog->isVisible());
    answer("continue");
    QVERIFY(!m_dialog->mayClose()); // what the window asks
    answer("stop");
    QTest::keyClick(m_dialog.get(), Qt::Key_Escape);
    QCOMPARE(asked.size(), 3);
    QVERIFY(!m_dialog->isVisible());
    m_dialog.reset();
    QCOMPARE(files(), QStringList());
}

void AnimationExportDialogTest::theQuestionEndsWithTheExport() {
    m_dialog->setFormat(io::VideoFormat::Gif);
    m_dialog->show();
    m_dialog->exportTo(path("a.gif"));
    QTest::keyClick(m_dialog.get(), Qt::Key_Escape); // nobody answers
    QVERIFY(m_dialog->isVisible());
    QVERIFY2(m_dialog->message().startsWith(QStringLiteral("Written to")), qPrintable(m_dialog->message()));
    QTest::keyClick(m_dialog.get(), Qt::Key_Escape);
    QVERIFY(!m_dialog->isVisible());
    QCOMPARE(files(), QStringList{QStringLiteral("a.gif")});
}

void AnimationExportDialogTest::theEndingDecidesTheFormat() {
    m_dialog->setFormat(io::VideoFormat::Mp4);
    m_dialog->exportTo(path("a.gif"));
    QTRY_VERIFY_WITH_TIMEOUT(m_dialog->message().startsWith(QStringLiteral("Written to")), 120'000);
    QFile file(path("a.gif"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.read(4), QByteArray("GIF8"));
    QCOMPARE(view::chosenValue<Dialog::Format>(named<QComboBox>(QStringLiteral("Format"))),
             io::VideoFormat::Gif);
}

void AnimationExportDialogTest::theTimeLeftIsSaid() {
    setSize({1600, 1200});
    support::choose(named<QComboBox>(QStringLiteral("Quality")), 2000);
    auto* left = named<QLabel>(QStringLiteral("Time left"));
    QVERIFY(left && !left->isVisible());
    m_dialog->setFormat(std::nullopt);
    m_dialog->exportTo(path("a.png"));
    QTRY_VERIFY_WITH_TIMEOUT(left->isVisible() && left->text().endsWith(QStringLiteral(" left.")), 120'000);
}

void AnimationExportDialogTest::failuresAreSaid() {
    m_dialog->setFormat(io::VideoFormat::Mp4);
    m_dialog->exportTo(QStringLiteral("/nowhere/at/all.mp4"));
    QTRY_VERIFY_WITH_TIMEOUT(m_dialog->message().contains(QStringLiteral("nowhere")), 60'000);
}

void AnimationExportDialogTest::whatAFormatLacksIsSaid() {
    setSize({65, 48});
    QVERIFY(named<QLabel>(QStringLiteral("Summary of the export"))->text().contains(QStringLiteral("even")));
    number(QStringLiteral("Width"))->setValue(64);
    QVERIFY(!named<QLabel>(QStringLiteral("Summary of the export"))->text().contains(QStringLiteral("even")));
    document::Fractal fast = wind();
    document::plane(fast)->animation->rate = {120, 1};
    open(fast);
    m_dialog->setFormat(io::VideoFormat::Gif); // has at most 50 frames a second
    QVERIFY(m_dialog->message().contains(QStringLiteral("50")));
}

void AnimationExportDialogTest::aJobFolderHoldsAllThatItNeeds() {
    number(QStringLiteral("Tasks on a cluster"))->setValue(100);
    prepare(m_folder->path());
    prepare(m_folder->path());
    QVERIFY2(m_dialog->message().contains(QStringLiteral("submit.sh")), qPrintable(m_dialog->message()));
    const QStringList jobs = QDir(m_folder->path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    QCOMPARE(jobs.size(), 2); // the second does not touch the first
    const QDir job(path(jobs[0]));
    QCOMPARE(job.entryList(QDir::Files, QDir::Name),
             list({"README.md", "animate.sh", "animation-options.sh", "encode.sh", "entry.ifs", "names.sh",
                   "submit-animation.sh", "submit.sh"}));
    QVERIFY(QFileInfo(job.filePath(QStringLiteral("submit.sh"))).isExecutable());
    const QByteArray submit = contents(job.filePath(QStringLiteral("submit.sh")));
    QVERIFY2(submit.contains("'#1' 'animation.mp4' 6 --size 64x48"),
             submit.constData()); // no more tasks than frames
    const io::Collection entry =
        io::readCollection(contents(job.filePath(QStringLiteral("entry.ifs"))), QStringLiteral("entry.ifs"));
    QVERIFY(document::animationFacts(*entry.file.entries[0].fractal));
    prepare(path("not there"));
    QVERIFY2(m_dialog->message().contains(QStringLiteral("not there")), qPrintable(m_dialog->message()));
}

void AnimationExportDialogTest::theHeadingOfAJobFolderIsTheName() {
    document::Fractal named = wind();
    named.name = QStringLiteral("*wind* <b>&amp;\n# \\[a](b)_1\u202e");
    open(named);
    prepare(m_folder->path());
    const QStringList jobs = QDir(m_folder->path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    QCOMPARE(jobs.size(), 1);
    QTextDocument readme;
    readme.setMarkdown(QString::fromUtf8(contents(path(jobs[0] + QStringLiteral("/README.md")))));
    QCOMPARE(readme.firstBlock().text(), QStringLiteral("*wind* <b>&amp;_# \\[a](b)_1_ on a cluster"));
}

void AnimationExportDialogTest::slurmIsAskedForTheState_data() {
    QTest::addColumn<QByteArray>("states");
    QTest::addColumn<QString>("sentence");
    QTest::addColumn<bool>("isOver");
    QTest::newRow("running") << QByteArray("41 COMPLETED\\n41 RUNNING\\n41 PENDING\\n42 PENDING\\n")
                             << "Drawing: 1 of 3 done, 1 running, 1 waiting. Video: waiting." << false;
    QTest::newRow("done") << QByteArray("41 COMPLETED\\n41 COMPLETED\\n42 COMPLETED\\n")
                          << "Drawing: 2 of 2 done. Video: done. The result is in %1." << true;
    QTest::newRow("no video") << QByteArray("41 COMPLETED\\n42 FAILED\\n")
                              << "Drawing: 1 of 1 done. Video: failed. The reason is in the logs in %1."
                              << true;
    QTest::newRow("some failed") << QByteArray("41 RUNNING\\n41 FAILED\\n42 CANCELLED\\n")
                                 << "Drawing: 0 of 2 done, 1 running, 1 failed. Video: failed." << false;
    QTest::newRow("failed") << QByteArray("41 COMPLETED\\n41 FAILED\\n42 PENDING\\n")
                            << "Drawing: 1 of 2 done, 1 failed. The reason is in the logs in %1." << true;
}

// By programs that answer as Slurm's do.
void AnimationExportDialogTest::slurmIsAskedForTheState() {
    QFETCH(QByteArray, states);
    QFETCH(QString, sentence);
    QFETCH(bool, isOver);
    const auto program = [&](const char* name, const QByteArray& text) {
        QFile file(path(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("#!/bin/sh\n" + text);
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    };
    program("sbatch", "case \"$*\" in *dependency*) echo 42 ;; *) echo '41;here' ;; esac\n");
    program("squeue", "case \"$*\" in *--jobs=41,42*) printf '" + states + "' ;; esac\n");
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", m_folder->path().toLocal8Bit() + ':' + before);
    view::ClusterQueue* queue = m_dialog->findChild<view::ClusterQueue*>();
    QSignalSpy over(queue, &view::ClusterQueue::finished);
    m_dialog->prepareCluster(m_folder->path());
    const QStringList jobs = QDir(m_folder->path()).entryList({QStringLiteral("*-cluster")}, QDir::Dirs);
    QCOMPARE(jobs.size(), 1);
    sentence.replace(QStringLiteral("%1"), path(jobs.first()));
    QTRY_COMPARE_WITH_TIMEOUT(m_dialog->message(), sentence, 60'000);
    qputenv("PATH", before);
    QCOMPARE(over.size(), isOver ? 1 : 0);
}

BARYCAGE_TEST(AnimationExportDialogTest, QApplication);
#include "animation_export_dialog_test.moc"
