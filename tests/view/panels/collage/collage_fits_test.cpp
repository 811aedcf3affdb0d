// SPDX-License-Identifier: MIT
#include "document/edits/cage/cage_edits.h"
#include "document/edits/maps/map_locks.h"
#include "panels/collage/collage_numbers.h"
#include "panels/collage/suggestion_list.h"
#include "support/choose.h"
#include "support/named_test.h"
#include "view/panels/collage_panel_fixture.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QRegularExpression>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace {

// The measure of the Sierpiński triangle with the weights .2 (left), .3 (right) and .5 (top) on 256 × 256
// pixels, the darkest of which is black.
QImage sierpinskiShades() {
    QImage image(256, 256, QImage::Format_Grayscale8);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            double mass = 1;
            for (int bit = 0; bit < 8; ++bit) {
                const int right = x >> bit & 1, up = (255 - y) >> bit & 1;
                mass *= right + up == 2 ? 0 : right ? 0.6 : up ? 1 : 0.4;
            }
            image.scanLine(y)[x] = uchar(255 - std::lround(255 * mass));
        }
    return image;
}

// A black square of 900 pixels and a white one of 400 on nothing.
QImage squaresOnNothing() {
    QImage image(80, 60, QImage::Format_ARGB32);
    image.fill(0U);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 30; ++x)
            image.setPixel(x + 5, y + 5, qRgba(0, 0, 0, 255));
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            image.setPixel(x + 50, y + 20, qRgba(255, 255, 255, 255));
    return image;
}

} // namespace

// What is chosen in the panel of collages, and what its fits make of it.
class CollageFitsTest : public CollagePanelFixture {
    Q_OBJECT

    void tick(const char* box) {
        auto* found = named<QCheckBox>(QLatin1String(box));
        QVERIFY2(found, box);
        QTest::mouseClick(found, Qt::LeftButton, {}, {8, 8});
        QVERIFY2(found->isChecked(), box);
    }
    void trace(const QImage& image) {
        m_panel->target()->read(write(QStringLiteral("picture.png"), encoded(image, "PNG")));
        settle();
    }
    void take(const std::vector<ifs::AffineMap<2>>& maps) {
        document::Fractal fractal = m_document->fractal();
        document::Shape<2> shape;
        for (const auto& map : maps)
            ifs::append<2>(shape.system, placed(map), 1.0 / double(maps.size()));
        fractal.shape = std::move(shape);
        m_document->edit(QStringLiteral("Prepare"), std::move(fractal));
        settle();
    }
    // Takes the first of the suggestions with four maps.
    void useSuggestion() {
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(0.5);
        support::choose(named<QComboBox>(QStringLiteral("Number of maps")), 4);
        push("Suggest");
        settle();
        auto* list = m_panel->findChild<view::SuggestionList*>();
        QVERIFY(list->count() > 0);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        settle();
        QCOMPARE(steps(), 1);
        QCOMPARE(system().maps.size(), std::size_t{4});
    }

private slots:
    void init() { openPanel(); }
    void cleanup() {
        m_panel.reset();
        close();
    }

    void weightsComeBackFromShades() {
        trace(sierpinskiShades());
        named<QSlider>(QStringLiteral("Threshold"))->setValue(254); // all that is not white
        settle();
        take({ifs::affineMap(0.5, 0, 0, 0.5, -0.25, -0.25), ifs::affineMap(0.5, 0, 0, 0.5, 0.25, -0.25),
              ifs::affineMap(0.5, 0, 0, 0.5, -0.25, 0.25)});
        auto* guarantee = named<QLabel>(QStringLiteral("Guarantee for the shades"));
        QVERIFY(guarantee->isHidden());
        push("Fit Weights");
        settle();
        const double expected[] = {0.2, 0.3, 0.5};
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY2(std::abs(system().maps[i].weight.value_or(0) - expected[i]) < 1e-3,
                     qPrintable(QString::number(system().maps[i].weight.value_or(0))));
        QVERIFY(!guarantee->isHidden());
        const auto found = QRegularExpression(QStringLiteral("within ([0-9.]+) px")).match(guarantee->text());
        QVERIFY2(found.hasMatch(), qPrintable(guarantee->text()));
        const double pixels = found.captured(1).toDouble();
        QVERIFY2(pixels > 0 && pixels < 4, qPrintable(guarantee->text()));
        m_document->undoStack()->undo(); // it was of other weights
        QVERIFY(guarantee->isHidden());
    }

    void escapeStopsAFit_data() {
        QTest::addColumn<QString>("fit");
        for (const char* fit : {"Fit Weights", "Refine Maps", "Suggest"})
            QTest::newRow(fit) << QString::fromLatin1(fit);
    }
    void escapeStopsAFit() {
        QFETCH(QString, fit);
        m_panel->target()->read(write(QStringLiteral("large.png"), encoded(leaf(512), "PNG")));
        settle();
        takeRoughMaps();
        const document::Fractal before = m_document->fractal();
        const int stepsBefore = steps();
        named<QDoubleSpinBox>(QStringLiteral("Seconds to search"))->setValue(60);
        push(fit.toLatin1().constData());
        QVERIFY(!m_panel->isSettled());
        auto* button = named<QPushButton>(QStringLiteral("Cancel"));
        QVERIFY(button->isVisible());
        m_panel->activateWindow();
        QTRY_VERIFY(m_panel->isActiveWindow());
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Escape);
        QVERIFY(m_panel->isSettled());
        QVERIFY(!button->isVisible());
        QCOMPARE(steps(), stepsBefore);
        QVERIFY(m_document->fractal() == before);
        push(fit.toLatin1().constData()); // begins anew
        QVERIFY(!m_panel->isSettled());
        push("Cancel");
    }

    // What is chosen in the panel binds the maps that are refined, too.
    void constraintsHoldForRefinements_data() {
        QTest::addColumn<QString>("fit");
        QTest::newRow("maps") << QStringLiteral("Refine Maps");
        QTest::newRow("attractor") << QStringLiteral("Refine Attractor");
    }
    void constraintsHoldForRefinements() {
        QFETCH(QString, fit);
        traceLeaf();
        tick("Similarities only");
        tick("No mirror images");
        tick("First map a stem");
        support::choose(named<QComboBox>(QStringLiteral("Angles")), 90);
        take({ifs::affineMap(0.1, 0, 0, 0.6, 0, 0), ifs::affineMap(0.4, 0, 0, 0.4, 0, 0.3),
              ifs::affineMap(0, -0.35, 0.35, 0, 0.06, -0.05), ifs::affineMap(0.3, 0, 0, 0.3, 0, -0.3)});
        const document::System2 before = system();
        push(fit.toLatin1().constData());
        settle();
        QVERIFY(!(system() == before));
        QVERIFY(std::abs(ifs::determinant<2>(system().maps[0].map.linear)) < 1e-9);
        for (const std::size_t i : {1U, 2U, 3U}) {
            const ifs::Matrix<2>& a = system().maps[i].map.linear;
            const double scale = std::sqrt(std::abs(ifs::determinant<2>(a)));
            QVERIFY(scale > 0 && ifs::determinant<2>(a) > 0);
            QVERIFY(std::abs(a(0, 0) - a(1, 1)) < 1e-6 && std::abs(a(0, 1) + a(1, 0)) < 1e-6);
            QVERIFY(std::min(std::abs(a(0, 0)), std::abs(a(0, 1))) < 1e-6 * scale);
        }
    }

    void constraintsHoldForSuggestions() {
        traceLeaf();
        tick("Similarities only");
        tick("No mirror images");
        support::choose(named<QComboBox>(QStringLiteral("Angles")), 90);
        useSuggestion();
        for (const auto& map : system().maps) {
            const ifs::Matrix<2>& a = map.map.linear;
            const double scale = std::sqrt(std::abs(ifs::determinant<2>(a)));
            QVERIFY(scale > 0 && ifs::determinant<2>(a) > 0);
            QVERIFY(std::abs(a(0, 0) - a(1, 1)) < 1e-6 && std::abs(a(0, 1) + a(1, 0)) < 1e-6);
            QVERIFY(std::min(std::abs(a(0, 0)), std::abs(a(0, 1))) < 1e-6 * scale);
        }
    }

    void theFirstMapMayBeAStem() {
        traceLeaf();
        tick("First map a stem");
        useSuggestion();
        QVERIFY(std::abs(ifs::determinant<2>(system().maps[0].map.linear)) < 1e-9);
        for (const std::size_t i : {1U, 2U, 3U})
            QVERIFY(std::abs(ifs::determinant<2>(system().maps[i].map.linear)) > 1e-6);
    }

    void refiningSaysWhatItHasDone() {
        traceLeaf();
        takeRoughMaps();
        auto* said = named<QLabel>(QStringLiteral("Result of refining"));
        QVERIFY(said->isHidden());
        const auto numbers = [this] {
            return std::pair(number("Mean distance"),
                             number("Guaranteed within").section(QStringLiteral(" ("), 0, 0));
        };
        const auto [distance, guarantee] = numbers();
        push("Refine Maps");
        settle();
        QVERIFY(!said->isHidden());
        const auto [shorter, other] = numbers();
        QVERIFY(shorter != distance && other != guarantee);
        QCOMPARE(said->text().section(QStringLiteral(". "), 0, 0),
                 QStringLiteral("Mean distance of the collage: %1 → %2").arg(distance, shorter));
        QVERIFY2(said->text().contains(QStringLiteral("Guarantee: %1 → %2.").arg(guarantee, other)),
                 qPrintable(said->text()));
        m_document->undoStack()->undo(); // it was of other maps
        QVERIFY(said->isHidden());
    }

    void whatBecomesWorseIsSaid_data() {
        QTest::addColumn<double>("distance"); // 1 before
        QTest::addColumn<double>("bound");    // 20 before; 0: none
        QTest::addColumn<QString>("worse");
        QTest::newRow("nothing") << 0.5 << 10.0 << QString();
        QTest::newRow("the same") << 1.0 << 20.0 << QString();
        QTest::newRow("distance") << 1.5 << 10.0 << QStringLiteral("The distance has increased");
        QTest::newRow("guarantee") << 0.5 << 30.0 << QStringLiteral("The guarantee is now weaker.");
        QTest::newRow("no guarantee") << 0.5 << 0.0 << QStringLiteral("Nothing is guaranteed any more.");
    }
    void whatBecomesWorseIsSaid() {
        QFETCH(double, distance);
        QFETCH(double, bound);
        QFETCH(QString, worse);
        view::Refinement refinement{document::Compared::Attractor, {}, {}};
        refinement.before.agreement.mean = 1;
        refinement.before.bound = 20;
        refinement.after.agreement.mean = distance;
        if (bound > 0) refinement.after.bound = bound;
        const QString text = view::refinementText(refinement);
        QVERIFY2(text.startsWith(QStringLiteral("Mean distance of the attractor: 1 px → ")),
                 qPrintable(text));
        for (const char* part : {"The distance has increased", "The guarantee is now weaker.",
                                 "Nothing is guaranteed any more."}) {
            const bool isExpected = !worse.isEmpty() && worse == QLatin1String(part);
            QVERIFY2(text.contains(QLatin1String(part)) == isExpected, qPrintable(text));
        }
    }

    // The panel stays as narrow as it was.
    void longGuaranteesWrap() {
        view::CollageNumbers numbers(nullptr);
        document::MeasuredFractal measured;
        measured.bound = 1234.5;
        measured.norm.norm = ifs::NormKind::Words;
        measured.norm.wordLength = 12;
        measured.norm.contractivity = 0.987;
        numbers.show(measured);
        const QLabel* guarantee = nullptr;
        for (const QLabel* label : numbers.findChildren<QLabel*>())
            if (label->accessibleName() == QLatin1String("Guaranteed within")) guarantee = label;
        QVERIFY(guarantee && guarantee->text().contains(QStringLiteral("any 12 maps in a row")));
        QVERIFY(numbers.minimumSizeHint().width() <
                guarantee->fontMetrics().horizontalAdvance(guarantee->text()));
    }

    void onlySelectedMapsAreRefined() {
        traceLeaf();
        takeRoughMaps();
        const document::System2 before = system();
        m_canvas->selectMaps({before.maps[1].id});
        tick("Refine selected maps only");
        push("Refine Maps");
        settle();
        QVERIFY(!(system().maps[1].map == before.maps[1].map));
        QVERIFY(system().maps[0].map == before.maps[0].map);
        QVERIFY(system().maps[2].map == before.maps[2].map);
    }

    // Then maps are taken through the cage and back: not those that stay.
    void lockedMapsStayUnderAMovedCage() {
        traceLeaf();
        takeRoughMaps();
        auto cage = document::withCageAround(document::withCageAtRest(m_document->fractal()),
                                             document::PolygonChoice::Regular, 3);
        QVERIFY(cage);
        QVERIFY(document::plane(*cage)->cage.has_value());
        for (auto& vertex : document::plane(*cage)->cage->current)
            vertex = Vector<2>(1.1 * vertex.x() + 0.07 * vertex.y(), 0.93 * vertex.y() - 0.013);
        m_document->edit(QStringLiteral("Cage"), *std::move(cage));
        settle();
        QVERIFY(document::collageObstacle(m_document->fractal()).isEmpty());
        const document::System2 before = system();
        document::lockMaps(*m_document, std::vector{before.maps[2].id}, true);
        push("Refine Maps");
        settle();
        QCOMPARE(undoText(), QStringLiteral("Refine Maps"));
        QVERIFY(system().maps[2].map == before.maps[2].map);
        QVERIFY(!(system().maps[0].map == before.maps[0].map));
    }

    void theShapeIsWhatIsDarkOrOpaque() {
        trace(squaresOnNothing());
        const auto area = [this] {
            const auto& traced = m_panel->target()->traced();
            return traced ? collage::area(traced->mask) : 0;
        };
        using Shape = document::TraceOptions::Shape;
        auto* shape = named<QComboBox>(QStringLiteral("Shape"));
        QCOMPARE(view::chosenValue<Shape>(shape), Shape::Automatic);
        QCOMPARE(area(), std::size_t{1300}); // there is transparency
        support::choose(shape, Shape::Dark);
        settle();
        QCOMPARE(area(), std::size_t{900});
        support::choose(shape, Shape::Opaque);
        settle();
        QCOMPARE(area(), std::size_t{1300});
        traceLeaf();
        support::choose(shape, Shape::Opaque); // all of it is
        settle();
        QVERIFY(!m_panel->target()->traced());
        QVERIFY2(sentence().contains(QStringLiteral("empty or fills")), qPrintable(sentence()));
        support::choose(shape, Shape::Automatic);
        settle();
        QVERIFY(area() > 0);
    }
};

BARYCAGE_TEST(CollageFitsTest, QApplication);
#include "collage_fits_test.moc"
