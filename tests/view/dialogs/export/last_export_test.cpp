// SPDX-License-Identifier: MIT
#include "dialogs/export/last_export.h"

#include "attractor/space_systems.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/export/export_data_dialog.h"
#include "dialogs/export/export_dialog.h"
#include "dialogs/export/export_size_editor.h"
#include "dialogs/export/space_export_dialog.h"
#include "document/edits/timeline/motion_edits.h"
#include "support/choose.h"
#include "support/forget_settings.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <functional>
#include <memory>

using namespace Qt::StringLiterals;

// Format, size and folder of an export are those of the last one of its kind.
class LastExportTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init() {
        support::forgetSettings();
        m_folder = std::make_unique<QTemporaryDir>();
        m_document = std::make_unique<document::Document>();
    }
    void pictures();
    void shapes();
    void solids();
    void animations();
    void data();
    void theEndingOfTheNameIsTheFormat();
    void kindsKnowNothingOfEachOther();
    void theFolderOfTheFileIsTheFirst();
    void namesAreNoPaths();

private:
    template <class Widget> static Widget* named(const QDialog& dialog, const char* name) {
        for (auto* found : dialog.findChildren<Widget*>())
            if (found->accessibleName() == QLatin1String(name)) return found;
        return nullptr;
    }
    static QComboBox* format(const QDialog& dialog) { return dialog.findChild<QComboBox*>(); }
    static void setPixels(const QDialog& dialog, const QSize& size) {
        dialog.findChild<view::ExportSizeEditor*>()->setPixels(size);
    }
    static QSize pixels(const QDialog& dialog) {
        return dialog.findChild<view::ExportSizeEditor*>()->pixels();
    }
    QString path(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    // Exports into that file, or cancels without one; returns what was suggested.
    static QString exportAs(const QDialog& dialog, const QString& path) {
        QString suggested;
        QTimer answering;
        connect(&answering, &QTimer::timeout, &answering, [&] {
            auto* files = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (!files) return;
            if (suggested.isEmpty())
                suggested =
                    files->directory().filePath(files->findChild<QLineEdit*>(u"fileNameEdit"_s)->text());
            if (!path.isEmpty()) files->findChild<QLineEdit*>(u"fileNameEdit"_s)->setText(path);
            QMetaObject::invokeMethod(files, path.isEmpty() ? "reject" : "accept", Qt::QueuedConnection);
        });
        answering.start(50);
        support::button(dialog, "export")->click();
        return suggested;
    }
    std::unique_ptr<view::ExportDialog> picture() const {
        attractor::Camera camera;
        camera.width = 160;
        camera.height = 120;
        return std::make_unique<view::ExportDialog>(m_document.get(),
                                                    attractor::fitted(camera, {0, 0}, {1, 0.9}));
    }
    std::unique_ptr<view::SpaceExportDialog> solid() const {
        document::Fractal menger;
        menger.name = u"menger"_s;
        menger.shape = document::Shape<3>{systems::menger()};
        m_document->setFile(document::fileOf(menger));
        attractor::OrbitCamera camera;
        camera.size = {160, 120};
        return std::make_unique<view::SpaceExportDialog>(m_document.get(), camera);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<document::Document> m_document;
};

void LastExportTest::pictures() {
    auto dialog = picture();
    using File = view::ExportDialog::File;
    const File tiff(io::PictureFile::Tiff);
    support::choose(format(*dialog), tiff);
    setPixels(*dialog, {50, 70});
    exportAs(*dialog, path("a.tiff"));
    QTRY_VERIFY(QFileInfo::exists(path("a.tiff")));
    dialog = picture();
    QVERIFY(view::chosenValue<File>(format(*dialog)) == tiff);
    QCOMPARE(pixels(*dialog), QSize(50, 70));
    const QString suggested = exportAs(*dialog, {});
    QCOMPARE(QFileInfo(suggested).path(), m_folder->path());
    QVERIFY2(suggested.endsWith(u".tiff"_s), qPrintable(suggested));
    // Who cancels has exported nothing.
    support::choose(format(*dialog), File(io::PictureFile::Png));
    exportAs(*dialog, {});
    QVERIFY(view::chosenValue<File>(format(*picture())) == tiff);
}

void LastExportTest::shapes() {
    using File = view::ExportDialog::File;
    const auto style = [](const QDialog& dialog) { return named<QComboBox>(dialog, "Kind of shapes"); };
    auto dialog = picture();
    support::choose(format(*dialog), File(io::ShapeFile::Svg));
    support::choose(style(*dialog), io::ShapeStyle::Outline);
    exportAs(*dialog, path("a.svg"));
    QTRY_VERIFY(QFileInfo::exists(path("a.svg")));
    dialog = picture();
    QCOMPARE(view::chosenValue<io::ShapeStyle>(style(*dialog)), io::ShapeStyle::Outline);
    support::choose(format(*dialog), File(io::PictureFile::Png)); // a picture of pixels leaves it
    exportAs(*dialog, path("a.png"));
    QTRY_VERIFY(QFileInfo::exists(path("a.png")));
    dialog = picture();
    QCOMPARE(view::chosenValue<io::ShapeStyle>(style(*dialog)), io::ShapeStyle::Outline);
}

void LastExportTest::solids() {
    std::unique_ptr<view::SpaceExportDialog> dialog = solid();
    dialog->setFormat(io::PictureFile::Jpeg);
    setPixels(*dialog, {30, 20});
    exportAs(*dialog, path("a.jpg"));
    QTRY_VERIFY(QFileInfo::exists(path("a.jpg")));
    dialog = solid();
    using Format = view::SpaceExportDialog::Format;
    QVERIFY(view::chosenValue<Format>(format(*dialog)) == Format(io::PictureFile::Jpeg));
    QCOMPARE(pixels(*dialog), QSize(30, 20));
    QCOMPARE(exportAs(*dialog, {}), path("menger.jpg"));
    // The settings of a mesh stay, whatever is exported in between.
    const auto resolution = [&]() -> QSpinBox* {
        for (auto* found : dialog->findChildren<QSpinBox*>())
            if (found->maximum() == io::SolidOptions::maxResolution) return found;
        return nullptr;
    };
    dialog->setFormat(io::MeshFormat::Stl);
    resolution()->setValue(16);
    exportAs(*dialog, path("a.stl"));
    QTRY_VERIFY(QFileInfo::exists(path("a.stl")));
    QTRY_VERIFY(dialog->canExport()); // it has heard of that
    dialog->setFormat(io::PictureFile::Jpeg);
    exportAs(*dialog, path("b.jpg"));
    QTRY_VERIFY(QFileInfo::exists(path("b.jpg")));
    dialog = solid();
    QCOMPARE(resolution()->value(), 16);
}

void LastExportTest::animations() {
    document::Fractal entry =
        *document::withWind(document::Document().entryFractal(), animation::swayPresets()[0]);
    std::get<document::Shape<2>>(entry.shape).animation->length = 2;
    m_document->setFile(document::fileOf(entry));
    const auto open = [this] {
        return std::make_unique<view::AnimationExportDialog>(
            m_document.get(), attractor::View{{0.4, 0.3}, 1.5, attractor::YAxis::Up});
    };
    auto dialog = open();
    dialog->setFormat(std::nullopt);
    named<QToolButton>(*dialog, "Lock proportions")->setChecked(false);
    named<QSpinBox>(*dialog, "Width")->setValue(32);
    named<QSpinBox>(*dialog, "Height")->setValue(24);
    exportAs(*dialog, path("a.0.png"));
    QTRY_VERIFY(dialog->message().contains(m_folder->path()));
    dialog = open();
    using Dialog = view::AnimationExportDialog;
    QCOMPARE(view::chosenValue<Dialog::Format>(format(*dialog)), std::nullopt);
    QCOMPARE(named<QSpinBox>(*dialog, "Width")->value(), 32);
    QCOMPARE(named<QSpinBox>(*dialog, "Height")->value(), 24);
    QCOMPARE(QFileInfo(exportAs(*dialog, {})).path(), m_folder->path());
}

void LastExportTest::data() {
    auto dialog = std::make_unique<view::ExportDataDialog>(m_document.get());
    using Format = view::ExportDataDialog::Format;
    support::choose(format(*dialog), Format(io::TextFormat::Tsv));
    exportAs(*dialog, path("a.tsv"));
    QTRY_VERIFY(QFileInfo::exists(path("a.tsv")));
    dialog = std::make_unique<view::ExportDataDialog>(m_document.get());
    QVERIFY(view::chosenValue<Format>(format(*dialog)) == Format(io::TextFormat::Tsv));
    QCOMPARE(QFileInfo(exportAs(*dialog, {})).path(), m_folder->path());
}

void LastExportTest::theEndingOfTheNameIsTheFormat() {
    exportAs(*picture(), path("a.webp"));
    const auto dialog = picture();
    QVERIFY(format(*dialog)->currentText().startsWith(u"WebP"_s));
    // A size by the screen is that of the screen that there is.
    QCOMPARE(pixels(*dialog), QSize(160, 120));
    view::ExportSizeEditor twice({160, 120});
    twice.choose(view::ExportSizeEditor({100, 50}).choice());
    QCOMPARE(twice.pixels(), QSize(160, 120));
    for (const QString& nonsense : {u""_s, u"0 0 0 0 0"_s, u"a b c d e"_s, u"1 2 3"_s})
        twice.choose(nonsense);
    QCOMPARE(twice.pixels(), QSize(160, 120));
}

void LastExportTest::kindsKnowNothingOfEachOther() {
    view::rememberExport(u"picture"_s, {u"svg"_s, u"0 10 20 0 300"_s}, path("a.svg"));
    QCOMPARE(view::lastExport(u"picture"_s).format, u"svg"_s);
    QVERIFY(view::lastExport(u"solid"_s).format.isEmpty());
    const auto dialog = solid();
    using Format = view::SpaceExportDialog::Format;
    QVERIFY(view::chosenValue<Format>(format(*dialog)) == Format(io::PictureFile::Png));
    QCOMPARE(pixels(*dialog), QSize(160, 120));
}

void LastExportTest::theFolderOfTheFileIsTheFirst() {
    const QTemporaryDir own;
    auto dialog = picture();
    dialog->suggestFolderOf(own.filePath(QStringLiteral("a.ifs")));
    QCOMPARE(QFileInfo(exportAs(*dialog, {})).path(), own.path());
    exportAs(*dialog, path("a.png"));
    dialog = picture();
    dialog->suggestFolderOf(own.filePath(QStringLiteral("a.ifs")));
    QCOMPARE(QFileInfo(exportAs(*dialog, {})).path(), m_folder->path());
}

void LastExportTest::namesAreNoPaths() {
    view::rememberExport(u"picture"_s, {}, path("a.png"));
    for (const QString& name : {u"/etc/x"_s, u"../up"_s, u"a\u202ez"_s}) {
        const QString suggested = view::suggestedPath(u"picture"_s, name + u".png"_s, {});
        QCOMPARE(QFileInfo(suggested).path(), m_folder->path());
        QVERIFY2(!suggested.contains(u'\u202e') && suggested.endsWith(u".png"_s), qPrintable(suggested));
    }
}

BARYCAGE_TEST(LastExportTest, QApplication);
#include "last_export_test.moc"
