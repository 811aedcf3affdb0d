// SPDX-License-Identifier: MIT
#include "attractor/space_systems.h"
#include "bridges/export_queue.h"
#include "dialogs/export/export_preview.h"
#include "dialogs/export/space_export_dialog.h"
#include "document/fractal/space_geometry.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLayout>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QWindow>

#include <cstdlib>
#include <memory>
#include <tuple>

using view::SpaceExportDialog;

class SpaceExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        document::Fractal fractal;
        fractal.name = QStringLiteral("menger");
        fractal.shape = document::Shape<3>{systems::menger()};
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(fractal));
        attractor::OrbitCamera camera;
        camera.size = {160, 120};
        camera.orientation = attractor::orbit(30, 20);
        camera = document::fittedTo(fractal, camera, 0.05);
        m_dialog = std::make_unique<SpaceExportDialog>(m_document.get(), camera);
        m_dialog->show();
    }

    void aPictureIsWhatTheCameraShows() {
        QVERIFY(exportedAs(io::PictureFile::Png, QStringLiteral("a.png")));
        const QImage picture(path(QStringLiteral("a.png")));
        QCOMPARE(picture.size(), QSize(160, 120));
        QVERIFY(!picture.textKeys().isEmpty()); // the system is in it
        for (auto* box : m_dialog->findChildren<QComboBox*>())
            if (box->count() == 3 && box->itemText(1).contains(QStringLiteral("side")))
                support::choose(box, io::Stereo::SideBySide);
        QVERIFY(exportedAs(io::PictureFile::Png, QStringLiteral("both.png")));
        const QImage both(path(QStringLiteral("both.png")));
        QCOMPARE(both.size(), QSize(160, 120));
        QVERIFY(both.copy(0, 0, 80, 120) != both.copy(80, 0, 80, 120));
    }

    void thePreviewIsWhatIsWritten() {
        m_dialog->resize(1000, 600);
        QVERIFY(exportedAs(io::PictureFile::Png, QStringLiteral("preview.png")));
        QTRY_COMPARE_WITH_TIMEOUT(m_dialog->preview().picture().size(), QSize(160, 120), 60'000);
        const QImage written = QImage(path(QStringLiteral("preview.png")));
        const QImage seen = m_dialog->preview().picture().convertToFormat(QImage::Format_RGB32);
        const QImage file = written.convertToFormat(QImage::Format_RGB32);
        int others = 0; // pixels
        for (int y = 0; y < file.height(); ++y)
            for (int x = 0; x < file.width(); ++x)
                others += seen.pixel(x, y) != file.pixel(x, y);
        QVERIFY2(others == 0, qPrintable(QString::number(others)));
        m_dialog->setFormat(io::MeshFormat::Stl);
        QVERIFY(!m_dialog->preview().isVisible());
    }

    // A dialog that opens for a mesh has fewer rows than one for a picture.
    void fieldsKeepTheirHeight() {
        m_dialog->setFormat(io::MeshFormat::Stl);
        QCoreApplication::processEvents();
        m_dialog->resize(m_dialog->width(), m_dialog->minimumSizeHint().height());
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
        m_dialog->setFormat(io::PictureFile::Png);
        const auto squeezed = [this] {
            QStringList names;
            for (const auto* field : m_dialog->findChildren<QWidget*>())
                if ((qobject_cast<const QComboBox*>(field) || qobject_cast<const QAbstractSpinBox*>(field)) &&
                    field->isVisible() && field->height() < field->sizeHint().height())
                    names << QString::fromLatin1(field->metaObject()->className());
            return names;
        };
        QTRY_VERIFY2(squeezed().isEmpty(), qPrintable(squeezed().join(u' ')));
        QVERIFY(m_dialog->height() >= m_dialog->layout()->totalSizeHint().height());
    }

    void escClosesTheOpenList() {
        QVERIFY(QTest::qWaitForWindowActive(m_dialog.get()));
        auto* format = m_dialog->findChild<QComboBox*>();
        format->setFocus();
        format->showPopup();
        QTRY_VERIFY(QApplication::activePopupWidget());
        QTest::keyClick(QApplication::activePopupWidget()->windowHandle(), Qt::Key_Escape);
        QTRY_VERIFY(!QApplication::activePopupWidget());
        QVERIFY(m_dialog->isVisible());
        QTest::keyClick(m_dialog->windowHandle(), Qt::Key_Escape);
        QTRY_VERIFY(!m_dialog->isVisible());
    }

    void escStopsBeforeItCloses() {
        m_dialog->setFormat(io::MeshFormat::Stl);
        QVERIFY(QTest::qWaitForWindowActive(m_dialog.get()));
        m_dialog->exportTo(path(QStringLiteral("stopped.stl")));
        auto* format = m_dialog->findChild<QComboBox*>();
        QVERIFY(!format->isEnabled()); // until it has ended
        QTest::keyClick(m_dialog.get(), Qt::Key_Escape);
        QVERIFY(m_dialog->isVisible());
        QTRY_VERIFY(format->isEnabled());
        QTRY_COMPARE(m_dialog->message(), QStringLiteral("Export stopped; nothing was written."));
        QVERIFY(!QFileInfo::exists(path(QStringLiteral("stopped.stl"))));
        QTest::keyClick(m_dialog.get(), Qt::Key_Escape);
        QVERIFY(!m_dialog->isVisible());
    }

    // As where the program quits.
    void closingStopsAtOnce() {
        m_dialog->setFormat(io::MeshFormat::Stl);
        m_dialog->exportTo(path(QStringLiteral("closed.stl")));
        m_dialog->close();
        QVERIFY(!m_dialog->isVisible());
    }

    // The same pixels in every format that loses none; formats without transparency leave it out.
    void picturesComeInAllFormats() {
        using Format = SpaceExportDialog::Format;
        QVERIFY(exportedAs(io::PictureFile::Png, QStringLiteral("a.png")));
        const QImage png = QImage(path(QStringLiteral("a.png"))).convertToFormat(QImage::Format_RGB32);
        for (auto* box : m_dialog->findChildren<QCheckBox*>())
            if (box->text().contains(QStringLiteral("ransparent"))) box->setChecked(true);
        QVERIFY(exportedAs(io::PictureFile::Jpeg, QStringLiteral("a.jpg")));
        const QImage jpeg = QImage(path(QStringLiteral("a.jpg"))).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(jpeg.size(), png.size());
        for (int y = 4; y < png.height(); y += 8)
            for (int x = 4; x < png.width(); x += 8)
                QVERIFY(std::abs(qGreen(jpeg.pixel(x, y)) - qGreen(png.pixel(x, y))) < 48);
        for (const auto& [format, name, magic] :
             {std::tuple{Format(io::PictureFile::WebP), "a.webp", "RIFF"},
              std::tuple{Format(io::PictureFile::Tiff), "a.tiff", "II*"},
              std::tuple{Format(io::PictureFile::ExrHalf), "a.exr", "\x76\x2f\x31\x01"},
              std::tuple{Format(io::ShapeFile::Svg), "a.svg", "<?xml"},
              std::tuple{Format(io::ShapeFile::Pdf), "a.pdf", "%PDF"}}) {
            QVERIFY(exportedAs(format, QLatin1String(name)));
            QFile file(path(QLatin1String(name)));
            QVERIFY(file.open(QIODevice::ReadOnly));
            QVERIFY2(file.readAll().startsWith(magic), name);
        }
    }

    // Whatever the list says: a picture called .jpg is no PNG.
    void theEndingOfTheNameDecides() {
        const auto bytesOf = [this](const char* name) {
            QFile file(path(QLatin1String(name)));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        for (const auto& [name, magic] : {std::pair{"b.jpg", "\xff\xd8"}, std::pair{"b.JPEG", "\xff\xd8"},
                                          std::pair{"b.tif", "II*"}, std::pair{"b.scad", "//"}}) {
            QVERIFY(exportedAs(io::PictureFile::Png, QLatin1String(name)));
            QVERIFY2(bytesOf(name).startsWith(magic), name);
        }
        m_dialog->setFormat(io::PictureFile::Png);
        for (const char* name : {"b.docx", "b"}) {
            m_dialog->exportTo(path(QLatin1String(name)));
            QVERIFY(m_dialog->message().contains(QStringLiteral("must end with one of these: .png, .jpg")));
            QVERIFY(!QFileInfo::exists(path(QLatin1String(name))));
        }
    }

    void vectorGraphicsContainPixels() {
        m_dialog->setFormat(io::ShapeFile::Svg);
        QVERIFY2(m_dialog->message().contains(QStringLiteral("in pixels")), qPrintable(m_dialog->message()));
        QVERIFY(m_dialog->preview().isVisible());
        m_dialog->setFormat(io::PictureFile::Png);
        QVERIFY(m_dialog->message().isEmpty());
    }

    void bodiesAreWrittenWithTheirFacts() {
        for (const auto& [format, name] : {std::pair{io::MeshFormat::Stl, "a.stl"},
                                           {io::MeshFormat::Obj, "a.obj"},
                                           {io::MeshFormat::Glb, "a.glb"},
                                           {io::MeshFormat::Ply, "a.ply"}}) {
            for (auto* field : m_dialog->findChildren<QSpinBox*>())
                if (field->maximum() == io::SolidOptions::maxResolution) field->setValue(16);
            QVERIFY(exportedAs(format, QLatin1String(name)));
            QVERIFY(QFileInfo(path(QLatin1String(name))).size() > 1000);
            QVERIFY2(m_dialog->message().contains(QStringLiteral("mm")), qPrintable(m_dialog->message()));
        }
    }

    void aSliceIsMentionedWhereItIsNotWritten() {
        const QString slice = QStringLiteral("slice");
        document::Fractal fractal = m_document->fractal();
        for (const bool isSliced : {false, true}) {
            if (isSliced) fractal.inSpace.clip = attractor::SpaceClip{ifs::Vector<3>::UnitX(), 0, 1};
            m_document->setFile(document::fileOf(fractal));
            SpaceExportDialog dialog(m_document.get(), {});
            using Format = SpaceExportDialog::Format;
            for (const Format& format :
                 {Format(io::MeshFormat::Stl), Format(SpaceExportDialog::OpenScad())}) {
                dialog.setFormat(format);
                QVERIFY(!dialog.message().isEmpty());
                QCOMPARE(dialog.message().contains(slice), isSliced);
            }
            dialog.setFormat(io::PictureFile::Png);
            QVERIFY(!dialog.message().contains(slice));
        }
    }

    void openScadGetsOneMatrixForEachMap() {
        QVERIFY(exportedAs(SpaceExportDialog::OpenScad(), QStringLiteral("a.scad")));
        QFile file(path(QStringLiteral("a.scad")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("multmatrix"));
    }

    // Before a name is chosen, and no such export waits in the queue to fail there.
    void aBentSolidIsRefusedBeforeItHasAName() {
        document::Fractal fractal = m_document->fractal();
        std::vector<ifs::Vector<3>> corners;
        for (int k = 0; k < 8; ++k)
            corners.emplace_back(k & 1, k >> 1 & 1, k >> 2);
        auto& cage = std::get<document::Shape<3>>(fractal.shape).cage;
        cage = ifs::polygonAtRest<3>(corners);
        cage->current[7] += ifs::Vector<3>(0.4, 0.3, 0.2);
        m_document->setFile(document::fileOf(fractal));
        attractor::OrbitCamera camera;
        camera.size = {160, 120};
        view::ExportQueue queue(m_folder.filePath(QStringLiteral("queue")));
        SpaceExportDialog dialog(m_document.get(), document::fittedTo(fractal, camera, 0.05));
        dialog.setQueue(&queue);
        QSignalSpy queued(&dialog, &SpaceExportDialog::queued);
        QList<SpaceExportDialog::Format> formats{SpaceExportDialog::OpenScad()};
        for (const auto& mesh : ifs::names<io::MeshFormat>)
            formats << mesh.value;
        for (const SpaceExportDialog::Format& format : std::as_const(formats)) {
            dialog.setFormat(io::PictureFile::Png);
            QVERIFY(dialog.canExport());
            dialog.setFormat(format);
            QVERIFY(!dialog.canExport());
            QVERIFY2(dialog.message().contains(QStringLiteral("bends")), qPrintable(dialog.message()));
            dialog.addToQueue(path(QStringLiteral("bent.stl")));
        }
        QVERIFY(queued.isEmpty());
        m_dialog->setFormat(io::MeshFormat::Stl); // the straight one
        QVERIFY(m_dialog->canExport());
    }

    // As the numbers change, each of those that decide it.
    void tooManyVoxelsAreRefusedBeforeTheyHaveAName() {
        const auto field = [this](const QString& end) -> QDoubleSpinBox* {
            for (auto* box : m_dialog->findChildren<QDoubleSpinBox*>())
                if (box->whatsThis().contains(end)) return box;
            return nullptr;
        };
        QDoubleSpinBox* longest = field(QStringLiteral("longest side"));
        QDoubleSpinBox* wall = field(QStringLiteral("thickened"));
        QSpinBox* resolution = nullptr;
        for (auto* box : m_dialog->findChildren<QSpinBox*>())
            if (box->maximum() == io::SolidOptions::maxResolution) resolution = box;
        QVERIFY(longest && wall && resolution);
        m_dialog->setFormat(io::MeshFormat::Stl);
        const QString hint = m_dialog->message();
        QVERIFY(m_dialog->canExport());
        const auto isRefused = [&](const char* because) {
            const bool isSaid = m_dialog->message().contains(QLatin1String(because));
            return isSaid && !m_dialog->canExport();
        };
        const auto isAccepted = [&] { return m_dialog->message() == hint && m_dialog->canExport(); };
        resolution->setValue(1000);
        QVERIFY2(isRefused("at most 510"), qPrintable(m_dialog->message()));
        m_dialog->setFormat(SpaceExportDialog::OpenScad()); // which has no voxels
        QVERIFY(m_dialog->canExport());
        m_dialog->setFormat(io::MeshFormat::Ply);
        QVERIFY2(isRefused("at most 510"), qPrintable(m_dialog->message()));
        resolution->setValue(510);
        QVERIFY2(isAccepted(), qPrintable(m_dialog->message()));
        wall->setValue(49);
        QVERIFY2(isRefused("million voxels"), qPrintable(m_dialog->message()));
        longest->setValue(100'000); // of which the wall is a small part
        QVERIFY2(isAccepted(), qPrintable(m_dialog->message()));
        longest->setValue(1);
        QVERIFY2(isRefused("thinner wall"), qPrintable(m_dialog->message()));
        wall->setValue(1000);
        QVERIFY2(isRefused("thinner wall"), qPrintable(m_dialog->message()));
    }

    void depthsAreRefusedBeforeTheyHaveAName() {
        document::Fractal fractal = m_document->fractal();
        fractal.inSpace.look = attractor::LookInSpace::Depth;
        m_document->setFile(document::fileOf(fractal));
        SpaceExportDialog dialog(m_document.get(), {});
        QVERIFY(dialog.canExport());
        dialog.setFormat(io::PictureFile::Jpeg);
        QVERIFY(!dialog.canExport());
        QVERIFY2(dialog.message().contains(QStringLiteral("PNG")), qPrintable(dialog.message()));
    }

    void whatCannotBeWrittenSaysSo() {
        m_dialog->setFormat(io::PictureFile::Png);
        m_dialog->exportTo(QStringLiteral("/nowhere/at/all.png"));
        QTRY_VERIFY_WITH_TIMEOUT(m_dialog->message().contains(QStringLiteral("nowhere")), 60'000);
    }

private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    bool exportedAs(SpaceExportDialog::Format format, const QString& name) {
        m_dialog->setFormat(format);
        QSignalSpy exported(m_dialog.get(), &SpaceExportDialog::exported);
        m_dialog->exportTo(path(name));
        return !exported.isEmpty() || exported.wait(60000);
    }

    QTemporaryDir m_folder;
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<SpaceExportDialog> m_dialog;
};

BARYCAGE_TEST(SpaceExportDialogTest, QApplication);
#include "space_export_dialog_test.moc"
