// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/export/export_preview.h"
#include "document/edits/timeline/motion_edits.h"
#include "support/choose.h"
#include "support/forget_settings.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QApplication>
#include <QComboBox>
#include <QDesktopServices>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include <memory>

using Dialog = view::AnimationExportDialog;

namespace {

template <int Dim> document::Fractal ofSixFrames(document::Fractal entry) {
    std::get<document::Shape<Dim>>(entry.shape).animation->length = 6;
    return entry;
}

document::Fractal inTheWind() {
    return ofSixFrames<2>(
        *document::withWind(document::Document().entryFractal(), animation::swayPresets()[0]));
}

document::Fractal goingRound() {
    document::Fractal entry;
    entry.name = QStringLiteral("menger");
    entry.shape = document::Shape<3>{systems::menger()};
    return ofSixFrames<3>(*document::withOrbit(entry));
}

} // namespace

// Takes the place of the file manager.
class FolderSpy : public QObject {
    Q_OBJECT

public:
    FolderSpy() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "open"); }
    ~FolderSpy() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
    const QUrl& opened() const { return m_opened; }

public slots:
    void open(const QUrl& url) { m_opened = url; }

private:
    QUrl m_opened;
};

// What the dialog proposes and shows before anything is written, and what it offers afterwards.
class AnimationChoicesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init() {
        support::forgetSettings();
        m_folder = std::make_unique<QTemporaryDir>();
        open(inTheWind());
    }
    void cleanup() { m_dialog.reset(); }
    void aGifIsProposedSmall();
    void proportionsAreKept();
    void thePreviewShowsAFrame();
    void aClusterIsNotMentionedWithoutSlurm();
    void aClusterIsOfferedWithSlurm();
    void theFolderIsShownAfterwards();

private:
    template <class Widget> Widget* named(const QString& name) const {
        for (auto* widget : m_dialog->findChildren<Widget*>())
            if (widget->accessibleName() == name) return widget;
        return nullptr;
    }
    QSpinBox* number(const QString& name) const { return named<QSpinBox>(name); }
    QSize size() const {
        return {number(QStringLiteral("Width"))->value(), number(QStringLiteral("Height"))->value()};
    }
    void open(const document::Fractal& entry) {
        m_dialog.reset();
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(entry));
        Dialog::Camera camera = attractor::View{{0.4, 0.3}, 1.5, attractor::YAxis::Up};
        if (document::space(entry)) camera = attractor::OrbitCamera{};
        m_dialog = std::make_unique<Dialog>(m_document.get(), camera);
        m_dialog->show();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<Dialog> m_dialog;
};

void AnimationChoicesTest::aGifIsProposedSmall() {
    QCOMPARE(size(), QSize(1920, 1080));
    m_dialog->setFormat(io::VideoFormat::Gif);
    QCOMPARE(size(), QSize(640, 360));
    m_dialog->setFormat(io::VideoFormat::WebM);
    QCOMPARE(size(), QSize(1920, 1080));
    number(QStringLiteral("Width"))->setValue(1280);
    m_dialog->setFormat(io::VideoFormat::Gif);
    QCOMPARE(size(), QSize(1280, 720)); // what was chosen stays
}

void AnimationChoicesTest::proportionsAreKept() {
    auto* named = this->named<QComboBox>(QStringLiteral("Named size"));
    auto* lock = this->named<QToolButton>(QStringLiteral("Lock proportions"));
    auto* turn = this->named<QToolButton>(QStringLiteral("Portrait or landscape"));
    support::choose(named, QSize(1280, 720));
    QCOMPARE(size(), QSize(1280, 720));
    lock->setChecked(true);
    number(QStringLiteral("Height"))->setValue(360);
    QCOMPARE(size(), QSize(640, 360));
    turn->click();
    QCOMPARE(size(), QSize(360, 640));
    number(QStringLiteral("Width"))->setValue(1080);
    QCOMPARE(size(), QSize(1080, 1920));
    QCOMPARE(named->currentData().toSize(), QSize(1080, 1920));
    lock->setChecked(false);
    number(QStringLiteral("Width"))->setValue(1000);
    QCOMPARE(size(), QSize(1000, 1920));
    QVERIFY(!view::chosenValue<QSize>(named).isValid());
}

void AnimationChoicesTest::thePreviewShowsAFrame() {
    for (const document::Fractal& entry : {inTheWind(), goingRound()}) {
        open(entry);
        auto* preview = m_dialog->findChild<view::ExportPreview*>();
        QVERIFY(preview);
        QTRY_VERIFY(!preview->picture().isNull() && !preview->isBusy());
        const QImage first = preview->picture();
        bool isPlain = true;
        for (int y = 0; y < first.height() && isPlain; ++y)
            for (int x = 0; x < first.width() && isPlain; ++x)
                isPlain = first.pixel(x, y) == first.pixel(0, 0);
        QVERIFY(!isPlain);
        auto* frame = named<QSlider>(QStringLiteral("Frame of the preview"));
        frame->setValue(frame->value() == 1 ? 2 : 1);
        QTRY_VERIFY(!preview->isBusy() && preview->picture() != first);
    }
}

void AnimationChoicesTest::aClusterIsNotMentionedWithoutSlurm() {
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", "/nowhere");
    open(inTheWind());
    auto* tasks = number(QStringLiteral("Tasks on a cluster"));
    QVERIFY(!tasks->isVisibleTo(m_dialog.get()));
    support::button(*m_dialog, "cluster")->click();
    QVERIFY(tasks->isVisibleTo(m_dialog.get()));
    QVERIFY(m_dialog->message().contains(QLatin1String("On a Cluster")));
    qputenv("PATH", before);
}

void AnimationChoicesTest::aClusterIsOfferedWithSlurm() {
    QFile sbatch(m_folder->filePath(QStringLiteral("sbatch")));
    QVERIFY(sbatch.open(QIODevice::WriteOnly));
    sbatch.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    const QByteArray before = qgetenv("PATH");
    qputenv("PATH", QFile::encodeName(m_folder->path()));
    open(inTheWind());
    QVERIFY(number(QStringLiteral("Tasks on a cluster"))->isVisibleTo(m_dialog.get()));
    qputenv("PATH", before);
}

void AnimationChoicesTest::theFolderIsShownAfterwards() {
    const auto button = [this] { return support::button(*m_dialog, "show-in-folder"); };
    QVERIFY(!button()->isEnabled());
    m_dialog->setFormat(io::VideoFormat::Gif);
    number(QStringLiteral("Width"))->setValue(64);
    QSignalSpy written(m_dialog.get(), &Dialog::exported);
    m_dialog->exportTo(m_folder->filePath(QStringLiteral("a.gif")));
    QVERIFY(!written.isEmpty() || written.wait(60'000));
    QVERIFY(button()->isEnabled() && button()->isVisibleTo(m_dialog.get()));
    FolderSpy spy;
    button()->click();
    QCOMPARE(spy.opened(), QUrl::fromLocalFile(m_folder->path()));
}

BARYCAGE_TEST(AnimationChoicesTest, QApplication);
#include "animation_choices_test.moc"
