// SPDX-License-Identifier: MIT
#include "dialogs/export/handout_dialog.h"
#include "dialogs/export/handout_page.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "support/choose.h"
#include "support/named_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QPushButton>
#include <QtTest>

#include <algorithm>
#include <set>

using namespace view;

namespace {

HandoutItem item(std::size_t maps = 3) {
    document::Fractal fractal = document::sierpinskiTriangle();
    fractal.name = QStringLiteral("triangle");
    document::system2(fractal)->maps.resize(maps, document::system2(fractal)->maps.front());
    QImage picture(80, 70, QImage::Format_RGB32);
    picture.fill(Qt::red);
    return {std::make_shared<const document::Fractal>(fractal), picture};
}

document::Fractal tetrahedron() {
    document::Fractal fractal;
    fractal.name = QStringLiteral("tetrahedron");
    document::Shape<3> shape;
    for (int k = 0; k < 4; ++k) {
        const ifs::Vector<3> shift =
            k == 0 ? ifs::Vector<3>::Zero() : ifs::Vector<3>(0.5 * ifs::Vector<3>::Unit(k - 1));
        ifs::append<3>(shape.system, {0.5 * ifs::Matrix<3>::Identity(), shift});
    }
    fractal.shape = shape;
    return fractal;
}

// Numbers of as many digits as they have; of the probabilities of the first two maps, the last digits differ.
template <int Dim> HandoutItem withLongNumbers(document::Fractal fractal, double first, double second) {
    auto& system = std::get<document::Shape<Dim>>(fractal.shape).system;
    for (auto& map : system.maps) {
        map.map.linear.fill(-1.0 / 7);
        map.map.translation.fill(-0.1234);
        map.weight = 0.2;
    }
    system.maps.back().weight = 0.8 - 0.2 * double(system.maps.size() - 2);
    system.maps[0].weight = first;
    system.maps[1].weight = second;
    return {std::make_shared<const document::Fractal>(fractal), item().picture};
}

// How many pixels of a page are of that colour: red for the picture, else dark.
int count(const QImage& page, bool isRed) {
    int all = 0;
    for (int y = 0; y < page.height(); ++y)
        for (int x = 0; x < page.width(); ++x) {
            const QColor colour = page.pixelColor(x, y);
            const bool red = colour.red() > 200 && colour.green() < 60;
            all += isRed ? red : colour.lightness() < 110 && !red;
        }
    return all;
}

std::vector<QImage> pagesOf(const std::vector<HandoutItem>& items, const HandoutOptions& options) {
    std::vector<QImage> pages;
    QImage page(600, 850, QImage::Format_RGB32);
    page.fill(Qt::white);
    QPainter painter(&page);
    paintHandout(painter, QRectF(20, 20, 560, 810), items, options, [&] {
        pages.push_back(page.copy());
        page.fill(Qt::white);
    });
    painter.end();
    pages.push_back(page);
    return pages;
}

} // namespace

class HandoutTest : public QObject {
    Q_OBJECT

private slots:
    void formulasLeaveOutWhatIsZero() {
        ifs::AffineMap<2> map;
        map.linear << 0.5, 0, -0.25, 1;
        map.translation << 0, -2;
        QCOMPARE(formulaText(map, 12), QStringLiteral("w₁₂(x, y) = (0.5x, −0.25x + y − 2)"));
        map.linear << -1, 0, 0, 0;
        map.translation << 1.0 / 3, 0;
        QCOMPARE(formulaText(map, 1), QStringLiteral("w₁(x, y) = (−x + 0.3333, 0)"));
    }

    void longFormulasAreBrokenBetweenTheirNumbers() {
        const QString formula =
            QStringLiteral("w₁(x, y, z) = (0.8x − 0.2y + 0.1z + 1, −0.25x + y, z)   p₁ = 0.3333");
        for (const qsizetype width : {24, 40, 60, 100}) {
            const auto fits = [width](const QString& text) { return text.size() <= width; };
            const QStringList lines = onLines(formula, fits);
            QVERIFY(std::ranges::all_of(lines, fits));
            QVERIFY(lines.last().endsWith(QStringLiteral("p₁ = 0.3333")));
            QCOMPARE(lines.join(u' ').simplified(), formula.simplified()); // nothing is left out
            QCOMPARE(lines.size() == 1, formula.size() <= width);
        }
    }

    void probabilitiesAreNotCut() {
        for (const int perPage : {1, 2, 4, 6}) {
            HandoutOptions options;
            options.perPage = perPage;
            const auto page = [&](double first, double second) {
                const HandoutItem one = withLongNumbers<2>(*item().fractal, first, second);
                return pagesOf(std::vector<HandoutItem>(std::size_t(perPage), one), options).front();
            };
            QVERIFY2(page(0.1111, 0.1112) != page(0.1112, 0.1111), qPrintable(QString::number(perPage)));
            const auto solid = [&](double first, double second) {
                const HandoutItem one = withLongNumbers<3>(tetrahedron(), first, second);
                return pagesOf(std::vector<HandoutItem>(std::size_t(perPage), one), options).front();
            };
            QVERIFY2(solid(0.1111, 0.1112) != solid(0.1112, 0.1111), qPrintable(QString::number(perPage)));
        }
    }

    void pagesHoldAsManyAsTheyShould() {
        const std::vector<HandoutItem> items(7, item());
        for (const int perPage : {1, 2, 4, 6}) {
            HandoutOptions options;
            options.perPage = perPage;
            const auto pages = pagesOf(items, options);
            QCOMPARE(pages.size(), std::size_t((7 + perPage - 1) / perPage));
            for (const QImage& page : pages) {
                QVERIFY(count(page, true) > 2000);
                QVERIFY(count(page, false) > 100); // name and formulas
            }
        }
    }

    // A single entry has the page to itself, and on a sheet that lies, entries stand side by side.
    void entriesUseThePage() {
        HandoutOptions options;
        options.perPage = 1;
        const QImage alone = pagesOf({item()}, options).front();
        for (const int perPage : {2, 4, 6}) {
            options.perPage = perPage;
            QVERIFY(pagesOf({item()}, options).front() == alone);
        }
        options.perPage = 2;
        QImage page(850, 600, QImage::Format_RGB32);
        page.fill(Qt::white);
        QPainter painter(&page);
        paintHandout(painter, QRectF(20, 20, 810, 560), std::vector<HandoutItem>(2, item()), options,
                     [] { QFAIL("one page is enough"); });
        painter.end();
        const int left = count(page.copy(0, 0, 425, 600), true),
                  right = count(page.copy(425, 0, 425, 600), true);
        QVERIFY2(left > 2000 && std::abs(left - right) < left / 20,
                 qPrintable(QStringLiteral("%1 %2").arg(left).arg(right)));
    }

    void aTaskSheetHasNoPictureAndNoNumbersOfMaps() {
        HandoutOptions options;
        options.kind = HandoutOptions::Kind::TaskSheet;
        const QImage page = pagesOf({item()}, options).front();
        QCOMPARE(count(page, true), 0);
        QVERIFY(count(page, false) > 500); // cage, grid and table
        // The same sheet for every system with this cage and as many maps.
        HandoutItem other = item();
        document::Fractal changed = *other.fractal;
        document::plane(changed)->cage = ifs::ControlCage<2>{
            document::plane(*item().fractal)->cage.value_or(ifs::polygonAtRest<2>({{0, 0}, {1, 0}, {0, 1}}))};
        HandoutItem same{std::make_shared<const document::Fractal>(changed), {}};
        document::system2(changed)->maps[1].map.translation *= 0.9;
        HandoutItem moved{std::make_shared<const document::Fractal>(changed), {}};
        QVERIFY(pagesOf({same}, options).front() == pagesOf({moved}, options).front());
        options.hasNameLine = true;
        QVERIFY(pagesOf({same}, options).front() != pagesOf({moved}, HandoutOptions()).front());
    }

    // Whatever does not fit is named, and nothing is drawn outside of the page.
    void manyMapsEndWithHowManyMoreThereAre() {
        for (const int perPage : {1, 6})
            for (const auto kind : {HandoutOptions::Kind::Handout, HandoutOptions::Kind::TaskSheet}) {
                HandoutOptions options;
                options.perPage = perPage;
                options.kind = kind;
                const std::vector<HandoutItem> items(std::size_t(perPage), item(400));
                const QImage page = pagesOf(items, options).front();
                for (int x = 0; x < page.width(); ++x) {
                    QCOMPARE(page.pixel(x, 0), 0xffffffff);
                    QCOMPARE(page.pixel(x, page.height() - 1), 0xffffffff);
                }
            }
        QImage empty(10, 10, QImage::Format_RGB32);
        QPainter painter(&empty);
        const std::vector<HandoutItem> items{item()};
        paintHandout(painter, QRectF(), items, {}, [] {}); // of a printer that is not set up yet
    }

    void theDialogPrintsWhatIsTicked() {
        document::Document document;
        HandoutDialog dialog(&document);
        QCOMPARE(dialog.chosen().size(), std::size_t{1});
        QCOMPARE(dialog.chosen().front()->name, document.fractal().name);
        auto* list = dialog.findChild<QListWidget*>();
        list->item(0)->setCheckState(Qt::Unchecked);
        const auto buttons = dialog.findChildren<QPushButton*>();
        const auto* preview = *std::ranges::find_if(
            buttons, [](const QPushButton* button) { return button->text().contains(u'…'); });
        QVERIFY(!preview->isEnabled());
        list->item(0)->setCheckState(Qt::Checked);
        QVERIFY(preview->isEnabled());
        support::choose(dialog.findChildren<QComboBox*>().front(), HandoutOptions::Kind::TaskSheet);
        QVERIFY(dialog.options().kind == HandoutOptions::Kind::TaskSheet);
        QVERIFY(dialog.options().hasNameLine);
        QCOMPARE(dialog.printedName(), document.fractal().name + QStringLiteral("-handout.pdf"));
        dialog.setName(QStringLiteral("ferns 1.2"));
        QCOMPARE(dialog.printedName(), QStringLiteral("ferns 1.2-handout.pdf"));
        dialog.setName(QStringLiteral("../a\u202e\n") + QChar(0) + QStringLiteral("ä").repeated(300));
        QVERIFY2(dialog.printedName().startsWith(u"_._a___ä"), qPrintable(dialog.printedName()));
        QVERIFY(dialog.printedName().toUtf8().size() <= 255);
    }

    // As the print dialog does it, where there is no printer.
    void theDialogSaysWhereAHandoutIsWritten() {
        const QTemporaryDir folder;
        document::Document document;
        HandoutDialog dialog(&document);
        support::choose(dialog.findChildren<QComboBox*>().front(), HandoutOptions::Kind::TaskSheet);
        dialog.show();
        const auto said = [&dialog](const QString& path) {
            dialog.showPreview();
            auto* preview = dialog.findChild<QPrintPreviewDialog*>();
            if (!preview) return QStringLiteral("no preview");
            preview->printer()->setOutputFormat(QPrinter::PdfFormat);
            preview->printer()->setOutputFileName(path);
            preview->findChild<QPrintPreviewWidget*>()->print();
            preview->accept();
            delete preview;
            for (const auto* label : dialog.findChildren<QLabel*>())
                if (label->accessibleName() == QStringLiteral("Result")) return label->text();
            return QString();
        };
        const QString path = folder.filePath(QStringLiteral("handout.pdf"));
        QCOMPARE(said(path), QStringLiteral("Written to %1.").arg(path));
        QVERIFY(QFileInfo(path).size() > 0);
        const QString nowhere = folder.filePath(QStringLiteral("missing/handout.pdf"));
        QTest::ignoreMessage(QtWarningMsg, "QPainter::begin(): Returned false");
        const QString failure = said(nowhere);
        QVERIFY2(failure.startsWith(nowhere + QStringLiteral(" could not be written")), qPrintable(failure));
        QCOMPARE(said(QString()), QString()); // on paper
    }

    void formulasOfSpaceHaveThreeCoordinates() {
        ifs::AffineMap<3> map;
        map.linear << 0.5, 0, 0, 0, -1, 0, 0.25, 0, 1;
        map.translation << 0, 0, -2;
        QCOMPARE(formulaText(map, 3), QStringLiteral("w₃(x, y, z) = (0.5x, −y, 0.25x + z − 2)"));
        ifs::ControlCage<3> cage = ifs::polygonAtRest<3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
        cage.current[1] = {-0.5, 1.0 / 3, 1e-9};
        QCOMPARE(cornerTexts(cage), QStringList({QStringLiteral("v₁ = (0, 0, 0)   v₂ = (−0.5, 0.3333, 0)"),
                                                 QStringLiteral("v₃ = (0, 1, 0)   v₄ = (0, 0, 1)")}));
    }

    // A page has the formulas of the displayed maps, and the corners of the cage.
    void aSolidHasItsOwnPages() {
        QImage picture(80, 80, QImage::Format_RGB32);
        picture.fill(Qt::red);
        const auto page = [&picture](const document::Fractal& fractal, const HandoutOptions& options) {
            return pagesOf({{std::make_shared<const document::Fractal>(fractal), picture}}, options).front();
        };
        const document::Fractal rests = tetrahedron();
        document::Fractal moved = rests;
        document::space(moved)->cage = document::spaceCage(rests);
        document::space(moved)->cage->current[3] = {0.5, 0.25, 2};
        document::Fractal other = moved; // the same corners, other maps
        document::system3(other)->maps[1].map.translation *= 0.9;
        HandoutOptions options;
        QVERIFY(count(page(rests, options), true) > 2000);
        QVERIFY(page(rests, options) != page(moved, options));
        QVERIFY(page(moved, options) != page(other, options));
        options.kind = HandoutOptions::Kind::TaskSheet;
        QCOMPARE(count(page(moved, options), true), 0);
        QVERIFY(count(page(moved, options), false) > 500);
        QVERIFY(page(rests, options) != page(moved, options));
        QVERIFY(page(moved, options) == page(other, options));
    }

    void theDialogListsSolids() {
        document::Document document;
        document.setFile(document::fileOf(tetrahedron()));
        HandoutDialog dialog(&document);
        QCOMPARE(dialog.chosen().size(), std::size_t{1});
        QCOMPARE(dialog.chosen().front()->name, QStringLiteral("tetrahedron"));
    }

    // Lit, on paper, with the cage and its images over it; nothing is cut off.
    void theSolidIsDrawnWithAllOfTheCage() {
        document::Fractal fractal = tetrahedron();
        document::space(fractal)->cage = document::spaceCage(fractal);
        document::space(fractal)->cage->current[3] = {3, 1, 2};
        const HandoutPictureInSpace shown = handoutPictureInSpace(fractal, {});
        const attractor::RasterSize& size = shown.picture.request.camera.size;
        int edges = 0, words = 0;
        for (const io::OverlayMark& mark : shown.marks) {
            for (const QPointF& point : mark.polygon)
                QVERIFY(QRectF(0, 0, size.width, size.height).contains(point));
            edges += mark.polygon.size() == 2;
            words += !mark.word.isEmpty();
        }
        QCOMPARE(edges, 2 * (6 + 4 * 6)); // of the cage and of four maps, each with a halo
        QCOMPARE(words, 4 + 4);
        HandoutOptions plain;
        plain.showsMaps = false;
        QVERIFY(handoutPictureInSpace(fractal, plain).marks.empty());
        io::SpaceExport small = shown.picture;
        small.request.camera.size = {140, 140};
        const QImage image = io::drawSpacePicture(small).image;
        QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
        std::set<QRgb> colours;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                colours.insert(image.pixel(x, y));
        QVERIFY(colours.size() > 20); // light and shade
    }

    void thePictureShowsAllOfTheCage() {
        const document::Fractal fractal = document::sierpinskiTriangle();
        const io::PlaneExport with = handoutPicture(fractal, {});
        QVERIFY(with.overlay.cage && with.overlay.maps && with.overlay.numbers);
        HandoutOptions plain;
        plain.showsMaps = false;
        const io::PlaneExport without = handoutPicture(fractal, plain);
        QVERIFY(!without.overlay.cage && !without.overlay.maps);
        // Of this colour are the maps that have it, but not the cage.
        const auto coloured = [&](const io::PictureOverlay& overlay) {
            return std::ranges::count(io::overlayMarks(with.fractal, with.request.camera, overlay),
                                      io::cageColour(), &io::OverlayMark::stroke);
        };
        io::PictureOverlay maps = with.overlay;
        maps.cage = false;
        QCOMPARE(coloured(with.overlay), coloured(maps));
        maps = with.overlay;
        maps.isCageInked = false;
        QVERIFY(coloured(with.overlay) < coloured(maps));
        QVERIFY(with.request.appearance.background.alpha == 255);
        QVERIFY(with.request.appearance.background.red > 200); // paper
        // Dashed, where it was before it was dragged.
        document::Fractal dragged = fractal;
        document::plane(dragged)->cage = document::effectiveCage(fractal);
        document::plane(dragged)->cage->current[0] *= 0.25;
        document::plane(dragged)->cage->current[1] *= 0.25;
        document::plane(dragged)->cage->current[2] *= 0.25;
        const io::PlaneExport placed = handoutPicture(dragged, {});
        const attractor::Camera& camera = placed.request.camera;
        for (const io::OverlayMark& mark : io::overlayMarks(placed.fractal, camera, placed.overlay))
            if (!mark.dashes.isEmpty())
                for (const QPointF& point : mark.polygon)
                    QVERIFY(QRectF(0, 0, camera.width, camera.height).contains(point));
    }
};

BARYCAGE_TEST(HandoutTest, QApplication);
#include "handout_test.moc"
