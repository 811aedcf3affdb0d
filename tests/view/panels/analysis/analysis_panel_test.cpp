// SPDX-License-Identifier: MIT
#include "bridges/analysis_bridge.h"
#include "canvas/items/analysis_item.h"
#include "document/edit_gesture.h"
#include "document/edits/maps/link_edits.h"
#include "panels/analysis/analysis_facts.h"
#include "panels/analysis/analysis_panel.h"
#include "panels/analysis/box_counting_plot.h"
#include "support/events.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/panels/analysis/facts_support.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_text.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QSet>
#include <QSignalSpy>
#include <QTimer>

#include <algorithm>
#include <memory>

using namespace facts_support;
using namespace maps_support;

namespace {

constexpr int patience = 60'000; // milliseconds, on a busy machine

// A word of a value for which its label, or the panel, has no room; empty when there is none.
QString cutText(const view::AnalysisPanel& panel) {
    const int reach = panel.viewport()->width() + panel.horizontalScrollBar()->maximum();
    for (const auto& fact : panel.facts())
        for (const auto* label : panel.findChildren<QLabel*>()) {
            if (label->accessibleName() != fact.name) continue;
            for (const QString& piece : label->text().split(u' '))
                if (label->fontMetrics().horizontalAdvance(piece) > label->width()) return piece;
            const bool isWithin = label->mapTo(panel.widget(), QPoint(label->width(), 0)).x() <= reach;
            if (!isWithin || label->height() < label->heightForWidth(label->width())) return label->text();
        }
    return {};
}

} // namespace

class AnalysisPanelTest : public QObject {
    Q_OBJECT

private slots:
    // As other whole numbers; without spaces where they are copied.
    void manyHullVerticesAreGrouped() {
        auto analysis = std::make_shared<document::Analysis>(
            document::Analyser().begun({std::make_shared<const document::Fractal>(maple()), {}, 1, 0}));
        QVERIFY(analysis->facts.hull);
        analysis->facts.hull->vertices.resize(12'345, analysis->facts.hull->vertices.front());
        const QList<view::Fact> facts = view::analysisFacts(analysis);
        const auto vertices = std::ranges::find(facts, QStringLiteral("Hull vertices"), &view::Fact::name);
        QVERIFY(vertices != facts.end());
        QCOMPARE(vertices->value, view::groupedNumber(12'345) + QStringLiteral(" (approximation)"));
        QCOMPARE(vertices->exact(), QStringLiteral("12345 (approximation)"));
    }

    void knowsThePublishedFactsOfTheMaple() {
        const auto facts = factsOf(maple());
        QCOMPARE(valueOf(facts, QStringLiteral("Contraction")),
                 QStringLiteral("0.6896  0.61  0.7225  0.7232"));
        QCOMPARE(valueOf(facts, QStringLiteral("Canonical simplex")),
                 QStringLiteral("(−, −), leg 11.7047, corner (3.3442, 5.0725)"));
        QCOMPARE(valueOf(facts, QStringLiteral("Mean")), QStringLiteral("(0.0728, 1.4312)"));
        QCOMPARE(valueOf(facts, QStringLiteral("Covariance")), QStringLiteral("1.0709, -0.0524, 3.7828"));
        QVERIFY(valueOf(facts, QStringLiteral("Attractor")).contains(QStringLiteral("hyperbolic")));
        QVERIFY(valueOf(facts, QStringLiteral("Box")).startsWith(QStringLiteral("[-3.3001, 3.3442]")));
        QVERIFY(valueOf(facts, QStringLiteral("Similarity dimension")).isEmpty());
        QCOMPARE(valueOf(facts, QStringLiteral("Affinity dimension")), QStringLiteral("at least 2"));
        QVERIFY(
            std::abs(valueOf(facts, QStringLiteral("Box-counting dimension")).section(u' ', 0, 0).toDouble() -
                     1.8) < 0.3);
        QVERIFY(valueOf(facts, QStringLiteral("Hull area")).startsWith(QStringLiteral("35.75")));
        QVERIFY(valueOf(facts, QStringLiteral("Hull vertices")).section(u' ', 0, 0).toInt() > 20);
        QVERIFY(valueOf(facts, QStringLiteral("Hull error bound")).toDouble() > 0);
        QVERIFY(valueOf(facts, QStringLiteral("Hull error bound")).toDouble() < 1e-4);
        QVERIFY(valueOf(facts, QStringLiteral("Fixed points")).contains(QStringLiteral("(0.1795, 5.0725)")));
        for (const auto& fact : facts)
            QVERIFY2(fact.definition.size() > 40, qPrintable(fact.name));
    }

    void knowsTheDimensionOfTheSierpinskiTriangle() {
        const auto facts = factsOf(document::sierpinskiTriangle());
        QCOMPARE(valueOf(facts, QStringLiteral("Similarity dimension")),
                 QStringLiteral("1.585 (the open set condition holds)"));
        QCOMPARE(valueOf(facts, QStringLiteral("Affinity dimension")), QStringLiteral("1.585"));
        QCOMPARE(valueOf(facts, QStringLiteral("Connectedness")), QStringLiteral("connected"));
        QCOMPARE(valueOf(facts, QStringLiteral("Hull vertices")), QStringLiteral("3"));
        QCOMPARE(valueOf(facts, QStringLiteral("Entropy")), QStringLiteral("1.0986"));
        QCOMPARE(valueOf(facts, QStringLiteral("Joint spectral radius")), QStringLiteral("0.5"));
        QVERIFY(
            std::abs(valueOf(facts, QStringLiteral("Box-counting dimension")).section(u' ', 0, 0).toDouble() -
                     1.585) < 0.1);
    }

    void writesTheMoranEquationInNumbers() {
        const auto equation = [](const document::Fractal& fractal) {
            return valueOf(factsOf(fractal), QStringLiteral("Moran equation"));
        };
        QCOMPARE(equation(document::sierpinskiTriangle()), QStringLiteral("3 · 0.5ᴰ = 1 ⇒ D = ln 3 / ln 2"));
        const double third = 1.0 / 3;
        QCOMPARE(equation(fractalOf({{third, 0, 0, third, 0, 0, 1}, {0, -third, third, 0, .5, 0, 1}})),
                 QStringLiteral("2 · 0.3333ᴰ = 1 ⇒ D = ln 2 / ln 3"));
        QCOMPARE(equation(fractalOf(
                     {{.25, 0, 0, .25, 0, 0, 1}, {.5, 0, 0, .5, .5, 0, 1}, {-.25, 0, 0, .25, 0, 0, 1}})),
                 QStringLiteral("0.5ᴰ + 2 · 0.25ᴰ = 1"));
        QVERIFY(equation(maple()).isEmpty()); // no similarities
        document::Fractal linked = document::sierpinskiTriangle();
        QVERIFY(equation(document::withLink(linked, 0, 0, 0)).isEmpty()); // another equation
    }

    // By 1 − 10⁻¹¹ in x, so slowly that rounding shows.
    void figuresCarryTheirErrors() {
        const double slow = 1 - 1e-11;
        const auto facts = factsOf(fractalOf({{slow, 0, 0, .5, 1, 0, 1}, {slow, 0, 0, .25, 3, 1, 1}}));
        QVERIFY(valueOf(facts, QStringLiteral("Mean")).contains(QStringLiteral(" ± ")));
        auto twice = document::sierpinskiTriangle();
        auto& maps = document::system2(twice)->maps;
        maps.push_back(maps[1]);
        const auto overlapping = factsOf(twice);
        QCOMPARE(valueOf(overlapping, QStringLiteral("Overlaps")), QStringLiteral("2 = 4"));
        QCOMPARE(valueOf(overlapping, QStringLiteral("Similarity dimension")),
                 QStringLiteral("2 (upper bound: pieces coincide)"));
    }

    void allIsKnownOfAPoint() {
        const auto facts = factsOf(fractalOf({{.3, .1, -.2, .3, .5, 1.6, 1}}));
        QCOMPARE(valueOf(facts, QStringLiteral("Similarity dimension")), QStringLiteral("0"));
        QCOMPARE(valueOf(facts, QStringLiteral("Covariance")), QStringLiteral("0, 0, 0"));
        QCOMPARE(valueOf(facts, QStringLiteral("Hull area")), QStringLiteral("0"));
    }

    // Nine tenths three times are too much for the plane, and what lies far away is as small as it is.
    void figuresFitTheSizeOfThings() {
        const auto large =
            factsOf(fractalOf({{.9, 0, 0, .9, 1, 0, 1}, {.9, 0, 0, .9, 0, 1, 1}, {.9, 0, 0, .9, 1, 1, 1}}));
        QVERIFY(valueOf(large, QStringLiteral("Similarity dimension"))
                    .endsWith(QStringLiteral("(upper bound: the open set condition fails)")));
        auto far = document::sierpinskiTriangle();
        for (auto& map : document::system2(far)->maps)
            map.map.translation += ifs::Vector<2>(5e8, 5e8);
        QVERIFY(valueOf(factsOf(far), QStringLiteral("Box"))
                    .startsWith(QStringLiteral("[1000000000, 1000000001] × [1000000000, 100000000")));
    }

    // A hundred thousand numbers in a label would hold up the window.
    void longListsAreCutShortToReadAndCopiedWhole() {
        document::Fractal fractal = document::sierpinskiTriangle();
        auto& maps = document::system2(fractal)->maps;
        while (maps.size() < 300)
            maps.push_back(maps[maps.size() % 3]);
        const auto facts = factsOf(fractal);
        for (const char* name : {"Contraction", "Fixed points"}) {
            const auto fact = std::find_if(facts.begin(), facts.end(), [&](const auto& each) {
                return each.name == QLatin1String(name);
            });
            QVERIFY(fact != facts.end());
            QVERIFY2(fact->value.size() < 1000, name);
            QVERIFY2(fact->value.endsWith(QStringLiteral("… and 276 more")), qPrintable(fact->value));
            QCOMPARE(fact->exact().count(QStringLiteral("  ")), 299);
        }
    }

    void aLineEndsBetweenPairsAndItsNameIsLevelWithTheFirst() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.resize(260, 900);
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(!valueOf(panel.facts(), QStringLiteral("Fixed points")).isEmpty(), patience);
        QLabel* value = nullptr;
        QLabel* name = nullptr;
        for (auto* label : panel.findChildren<QLabel*>()) {
            if (label->accessibleName() == QStringLiteral("Fixed points")) value = label;
            if (label->text() == QStringLiteral("Fixed points")) name = label;
        }
        QVERIFY(name && value);
        QVERIFY(value->text().contains(QStringLiteral("(0.1795,\u00a05.0725)")));
        QVERIFY(value->text().contains(u' ')); // between the pairs
        QTRY_VERIFY_WITH_TIMEOUT(value->height() >= 2 * value->fontMetrics().height(), patience);
        QVERIFY(name->alignment() & Qt::AlignTop);
        QVERIFY(value->alignment() & Qt::AlignTop);
        // Below its name where there is not room enough for both.
        QVERIFY(name->y() == value->y() || name->geometry().bottom() < value->y());
        panel.resize(40 * panel.fontMetrics().averageCharWidth() + 260, 900);
        QTRY_COMPARE_WITH_TIMEOUT(name->y(), value->y(), patience);
    }

    // A remark in brackets is as long as a sentence, and does not push its value below the name.
    void aRemarkIsBrokenIntoLines() {
        document::Document document;
        document.setFile(document::fileOf(fractalOf({{0.5, -0.3, 0.3, 0.5, 0, 0, 1},
                                                     {0.5, 0.3, -0.3, 0.5, 1, 0, 1},
                                                     {0.6, 0, 0, 0.6, 0.4, 0.5, 1}})));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.resize(40 * panel.fontMetrics().averageCharWidth() + 60, 900);
        panel.show();
        const QString fact = QStringLiteral("Similarity dimension");
        QTRY_VERIFY_WITH_TIMEOUT(valueOf(panel.facts(), fact).contains(u'('), patience);
        QLabel* value = nullptr;
        QLabel* name = nullptr;
        for (auto* label : panel.findChildren<QLabel*>()) {
            if (label->accessibleName() == fact) value = label;
            if (label->text() == fact) name = label;
        }
        QVERIFY(name && value);
        QVERIFY2(!value->text().contains(QChar::Nbsp), qPrintable(value->text()));
        QTRY_VERIFY_WITH_TIMEOUT(name->y() == value->y() && name->geometry().right() < value->x(), patience);
    }

    // A number without its last digits is another number.
    void noDigitIsOutOfSight() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisBridge bridge(&document); // analyses once for all panels
        for (const int points : {10, 16, 24})
            for (const int width : {90, 160, 260, 430}) {
                view::AnalysisPanel panel(&document, &bridge);
                QFont font = panel.font();
                font.setPointSize(points);
                panel.setFont(font);
                panel.resize(width, 900);
                panel.show();
                QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
                support::handleEvents(); // it is laid out
                const QString cut = cutText(panel);
                QVERIFY2(
                    cut.isEmpty(),
                    qPrintable(QStringLiteral("%1 points, %2 wide: %3").arg(points).arg(width).arg(cut)));
            }
    }

    void aFactThatGrowsHasRoomForItsLines_data() {
        QTest::addColumn<int>("width");
        for (const int width : {260, 300, 350, 430})
            QTest::addRow("%d wide", width) << width;
    }
    void aFactThatGrowsHasRoomForItsLines() {
        QFETCH(int, width);
        document::Document document;
        document.setFile(document::fileOf(document::sierpinskiTriangle()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.resize(width, 900);
        panel.show();
        document::Fractal inSpace;
        inSpace.shape = document::Shape<3>();
        for (const auto& fractal :
             {inSpace, fractalOf({{0.5, 0, 0, 0.5, 0, 0, 0}, {0.5, 0, 0, 0.5, 1, 0, 0}}),
              fractalOf({{0, 0, 0, 0.5, 0, 0, 1}, {0.5, 0, 0, 0, 1, 0, 1}})}) {
            QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
            document.edit(QStringLiteral("x"), fractal);
        }
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
        QTRY_COMPARE_WITH_TIMEOUT(valueOf(panel.facts(), QStringLiteral("Attractor")),
                                  QStringLiteral("hyperbolic, s = 0.5"), patience);
        support::handleEvents(); // it is laid out
        for (const auto* label : panel.findChildren<QLabel*>())
            if (label->isVisible() && label->wordWrap())
                QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
    }

    void computesOnlyWhenVisibleAndFollows() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        view::AnalysisBridge watched(&document);
        watched.setWatched(true);
        QTRY_VERIFY_WITH_TIMEOUT(watched.isCurrent(), patience); // meanwhile
        QVERIFY(panel.facts().isEmpty() && !bridge.analysis());
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(!panel.facts().isEmpty(), patience);
        document.edit(QStringLiteral("x"), document::sierpinskiTriangle());
        QTRY_COMPARE_WITH_TIMEOUT(valueOf(panel.facts(), QStringLiteral("Similarity dimension")),
                                  QStringLiteral("1.585"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
        QVERIFY(panel.plot().isVisible());
        QCOMPARE(panel.plot().table().count(u'\n'), 10); // eleven sizes
        QSignalSpy said(&panel, &view::AnalysisPanel::message);
        panel.copyAll();
        QCOMPARE(said.size(), 1); // nothing else shows that it was done
        QVERIFY(QGuiApplication::clipboard()->text().contains(
            QStringLiteral("Similarity dimension\t1.58496250072115")));
    }

    // Which facts are those of the picture, and which those of the code.
    void movedBranchesAreSpokenOf() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        const auto isSaid = [&] {
            return std::ranges::any_of(panel.findChildren<QLabel*>(), [&](const QLabel* label) {
                return label->isVisibleTo(&panel) &&
                       label->text().contains(QStringLiteral("Branches are moved"));
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
        QVERIFY(!isSaid());
        const QString hull = valueOf(panel.facts(), QStringLiteral("Hull area"));
        document::Fractal moved = document.fractal();
        auto& shape = *document::plane(moved);
        shape.moved = {{{shape.system.maps[0].id}, {ifs::Matrix<2>::Identity(), {300, 0}}}};
        document.edit(QStringLiteral("x"), moved);
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent() && isSaid(), patience);
        QVERIFY(valueOf(panel.facts(), QStringLiteral("Hull area")) != hull);
    }

    // What has no value says why; what is on its way says so.
    void absencesAndWorkAreToldApart() {
        document::Document document;
        const document::Fractal none = fractalOf({{2, 0, 0, 2, 0, 0, 1}, {2, 0, 0, 2, 1, 0, 1}});
        document.setFile(document::fileOf(none));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
        const auto labelOf = [&](const QString& name) -> const QLabel& {
            for (const auto* label : panel.findChildren<QLabel*>())
                if (label->accessibleName() == name) return *label;
            qFatal("no label");
        };
        const QLabel& similarity = labelOf(QStringLiteral("Similarity dimension"));
        const QLabel& counting = labelOf(QStringLiteral("Box-counting dimension"));
        QCOMPARE(counting.text(), QStringLiteral("–"));
        QVERIFY2(counting.toolTip().contains(QStringLiteral("no attractor")), qPrintable(counting.toolTip()));

        QStringList seen; // while it is being worked out, which may be too short to be seen
        const auto look = connect(&bridge, &view::AnalysisBridge::changed, &panel, [&] {
            if (bridge.analysis() && !bridge.analysis()->isComplete)
                seen << counting.text() + counting.toolTip().section(u'\n', 0, 0);
        });
        for (int i = 0; i < 50 && seen.isEmpty(); ++i) {
            document.edit(QStringLiteral("none"), none);
            QTRY_COMPARE_WITH_TIMEOUT(counting.text(), QStringLiteral("–"), patience);
            QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
            seen.clear();
            document.edit(QStringLiteral("maple"), maple());
            QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent() && counting.text().contains(u'±'), patience);
        }
        disconnect(look);
        QVERIFY(!seen.isEmpty());
        QCOMPARE(seen.last(), QStringLiteral("computing…This value is still being computed."));
        QVERIFY(!counting.toolTip().contains(QStringLiteral("still")));
        QCOMPARE(similarity.text(), QStringLiteral("–"));
        QVERIFY2(similarity.toolTip().contains(QStringLiteral("not all similarities")),
                 qPrintable(similarity.toolTip()));
    }

    void aNumberIsExplainedAndCopied() {
        document::Document document;
        document.setFile(document::fileOf(document::sierpinskiTriangle()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), patience);
        QLabel* value = nullptr;
        for (auto* label : panel.findChildren<QLabel*>())
            if (label->accessibleName() == QStringLiteral("Similarity dimension")) value = label;
        QVERIFY(value);
        QVERIFY(value->text().startsWith(QStringLiteral("1.585")));
        QVERIFY(value->toolTip().size() > 40);
        QTimer::singleShot(0, &panel, [] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            QTest::keyClick(menu, Qt::Key_Down);
            QTest::keyClick(menu, Qt::Key_Return);
        });
        emit value->customContextMenuRequested({});
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("1.58496250072115")));
    }

    // In the middle of the gesture, before the button is let go.
    void followsADragOfTheCage() {
        document::Document document;
        document.setFile(document::fileOf(withTriangle(maple())));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(panel.facts(), QStringLiteral("Hull area")).startsWith(QStringLiteral("35.75")),
            patience);
        document::EditGesture gesture = document.beginGesture(QStringLiteral("drag"));
        document::Fractal moved = document.fractal();
        document::plane(moved)->cage->current = {{-3, -3}, {13, -3}, {-3, 6}}; // twice as wide
        gesture.preview(moved);
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(panel.facts(), QStringLiteral("Hull area")).startsWith(QStringLiteral("71.5")), patience);
        QVERIFY(document.undoStack()->count() == 0);
        document::plane(moved)->cage->current = {{-3, -3}, {5, -3}, {-3, -3}}; // flat
        gesture.preview(moved);
        QTRY_COMPARE_WITH_TIMEOUT(valueOf(panel.facts(), QStringLiteral("Hull area")), QStringLiteral("0"),
                                  patience);
    }

    void saysWhoseFactsTheyAreWhenThePictureIsBent() {
        document::Document document;
        document::Fractal fractal = maple();
        document::plane(fractal)->cage =
            ifs::ControlCage<2>{{{-4, -4}, {4, -4}, {4, 6}, {-4, 6}}, {{-4, -4}, {4, -4}, {8, 9}, {-4, 6}}};
        document.setFile(document::fileOf(fractal));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(panel.facts(), QStringLiteral("Hull area")).startsWith(QStringLiteral("35.75")),
            patience);
        const auto labels = panel.findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().startsWith(QStringLiteral("The cage bends"));
        }));
    }

    void checkBoxesOutlineOnTheCanvas() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        panel.outlineBox(document::Outline::Hull)->click();
        QTRY_VERIFY_WITH_TIMEOUT(bridge.analysis() && bridge.analysis()->shapes.size() == 1, patience);
        panel.outlineBox(document::Outline::FixedPoints)->click();
        QTRY_COMPARE_WITH_TIMEOUT(bridge.analysis()->shapes.size(), std::size_t(5), patience);
        panel.hide(); // what is outlined still follows
        document.edit(QStringLiteral("x"), document::sierpinskiTriangle());
        QTRY_COMPARE_WITH_TIMEOUT(bridge.analysis()->shapes.size(), std::size_t(4), patience);
        panel.show();
        panel.outlineBox(document::Outline::Hull)->click();
        panel.outlineBox(document::Outline::FixedPoints)->click();
        QTRY_VERIFY_WITH_TIMEOUT(bridge.analysis()->shapes.empty(), patience);
        QVERIFY(document.undoStack()->count() == 1); // a state of the view
    }

    // So that it is seen which outline is whose.
    void outlinesHaveTheColoursOfTheirSwitches() {
        using document::Outline;
        for (const auto& background : {attractor::Rgba{0, 0, 0}, attractor::Rgba{255, 255, 255}}) {
            document::Document document;
            document::Fractal fractal = maple();
            fractal.appearance.background = background;
            document.setFile(document::fileOf(fractal));
            view::AnalysisBridge bridge(&document);
            const view::AnalysisPanel panel(&document, &bridge);
            QSet<QRgb> seen;
            for (const Outline kind : {Outline::Box, Outline::Hull, Outline::Simplex, Outline::Ellipse}) {
                const QImage icon = panel.outlineBox(kind)->icon().pixmap(32, 32).toImage();
                const QRgb swatch = icon.pixel(icon.width() / 2, icon.height() / 2);
                seen << swatch;
                view::AnalysisItem item;
                attractor::Camera camera;
                camera.width = camera.height = 100;
                camera.pixelsPerUnit = 10;
                camera.centre = {0, 0};
                item.setView(camera);
                item.setStyle(view::overlayStyle(background, panel.palette()));
                item.setShapes({{kind, {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {}}});
                QImage image(100, 100, QImage::Format_ARGB32_Premultiplied);
                image.fill(QColor(128, 128, 128));
                QPainter painter(&image);
                item.paint(&painter, nullptr, nullptr);
                painter.end();
                int nearest = 1000; // of the pixels across the line
                for (int x = 15; x < 25; ++x) {
                    const QRgb p = image.pixel(x, 50);
                    nearest = std::min(nearest, std::abs(qRed(p) - qRed(swatch)) +
                                                    std::abs(qGreen(p) - qGreen(swatch)) +
                                                    std::abs(qBlue(p) - qBlue(swatch)));
                }
                QVERIFY2(nearest < 12, qPrintable(QString::number(nearest)));
            }
            QCOMPARE(seen.size(), 4);
        }
    }

    // On black and on white, with a halo of the other shade beside the line.
    void outlinesAreSeenOnAnyPicture() {
        for (const auto& background : {attractor::Rgba{0, 0, 0}, attractor::Rgba{255, 255, 255}}) {
            view::AnalysisItem item;
            attractor::Camera camera;
            camera.width = camera.height = 100;
            camera.pixelsPerUnit = 10;
            camera.centre = {0, 0};
            item.setView(camera);
            const view::OverlayStyle style = view::overlayStyle(background, QPalette());
            item.setStyle(style);
            item.setShapes({{document::Outline::Box, {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {}}});
            QVERIFY(item.boundingRect().contains(QRectF(20, 20, 60, 60)));
            QImage image(100, 100, QImage::Format_ARGB32_Premultiplied);
            image.fill(QColor(128, 128, 128));
            QPainter painter(&image);
            item.paint(&painter, nullptr, nullptr);
            painter.end();
            int darkest = 255, lightest = 0;
            for (int x = 15; x < 25; ++x) {
                const int grey = qGray(image.pixel(x, 50));
                darkest = std::min(darkest, grey);
                lightest = std::max(lightest, grey);
            }
            QVERIFY2(lightest - darkest > 80, qPrintable(QString::number(lightest - darkest)));
            QCOMPARE(qGray(image.pixel(50, 50)), 128);
        }
    }

    // The numbers of barycage-cli info, where the cage puts them.
    void knowsASystemInSpace() {
        document::Fractal fern = fernInSpace();
        const auto facts = factsOf(fern);
        QVERIFY(valueOf(facts, QStringLiteral("Attractor")).contains(QStringLiteral("hyperbolic")));
        QVERIFY(valueOf(facts, QStringLiteral("Contraction")).startsWith(QStringLiteral("0.18  0.8559")));
        QVERIFY(valueOf(facts, QStringLiteral("Fixed points")).startsWith(QStringLiteral("(0, 0, 0)  (0, ")));
        QCOMPARE(valueOf(facts, QStringLiteral("Box")),
                 QStringLiteral("[-1.6232, 1.6232] × [0, 7.9977] × [-4.999, 0]"));
        QVERIFY(!valueOf(facts, QStringLiteral("Box error bound")).isEmpty());
        QVERIFY(valueOf(facts, QStringLiteral("Box error bound")).toDouble() < 1e-6);
        const QString simplex = valueOf(facts, QStringLiteral("Canonical simplex"));
        QCOMPARE(simplex, QStringLiteral("(+, −, −), leg 10.3268, corner (-1.6232, 7.9977, 0)"));
        QVERIFY(std::abs(valueOf(facts, QStringLiteral("Hull volume")).section(u' ', 0, 0).toDouble() -
                         24.9516) < 1e-3);
        QVERIFY(valueOf(facts, QStringLiteral("Hull vertices")).section(u' ', 0, 0).toInt() > 100);
        QCOMPARE(valueOf(facts, QStringLiteral("Covariance")).count(u','), 5);
        for (const auto& fact : facts) {
            QVERIFY2(fact.definition.size() > 40, qPrintable(fact.name));
            QVERIFY(fact.name != QStringLiteral("Box-counting dimension"));
        }
        // Twice as high.
        document::space(fern)->cage = ifs::ControlCage<3>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                          {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 1}}};
        QCOMPARE(valueOf(factsOf(fern), QStringLiteral("Box")),
                 QStringLiteral("[-1.6232, 1.6232] × [0, 15.9955] × [-4.999, 0]"));

        document::Fractal tetrahedron;
        document::System3 corners;
        for (const auto& map : canonical::tetrahedron())
            ifs::append(corners, map, 0.25);
        tetrahedron.shape = document::Shape<3>{std::move(corners)};
        const auto corner = factsOf(tetrahedron);
        QVERIFY(valueOf(corner, QStringLiteral("Similarity dimension")).startsWith(QStringLiteral("2 (")));
        QCOMPARE(valueOf(corner, QStringLiteral("Connectedness")), QStringLiteral("connected"));
        QCOMPARE(valueOf(corner, QStringLiteral("Entropy")), QStringLiteral("1.3863"));
        QCOMPARE(valueOf(corner, QStringLiteral("Joint spectral radius")), QStringLiteral("0.5"));
    }

    // The lines of the one do not stay among those of the other.
    void goesFromThePlaneToSpaceAndBack() {
        document::Document document;
        document.setFile(document::fileOf(maple()));
        view::AnalysisBridge bridge(&document);
        view::AnalysisPanel panel(&document, &bridge);
        panel.show();
        const auto shownNames = [&] {
            QStringList names;
            for (const auto* label : panel.findChildren<QLabel*>())
                if (label->isVisible() && !label->accessibleName().isEmpty())
                    names << label->accessibleName();
            return names;
        };
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        const QStringList inThePlane = shownNames();
        QVERIFY(inThePlane.contains(QStringLiteral("Hull area")));
        document.setFile(document::fileOf(fernInSpace()));
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60000);
        const QStringList inSpace = shownNames();
        QVERIFY(inSpace.contains(QStringLiteral("Hull volume")));
        QVERIFY(!inSpace.contains(QStringLiteral("Hull area")));
        QCOMPARE(inSpace.size(), panel.facts().size());
        panel.copyAll();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("Hull volume\t24.9")));
        document.setFile(document::fileOf(maple()));
        QTRY_VERIFY_WITH_TIMEOUT(bridge.isCurrent(), 60'000);
        QCOMPARE(shownNames(), inThePlane);
    }
};

BARYCAGE_TEST(AnalysisPanelTest, QApplication);
#include "analysis_panel_test.moc"
