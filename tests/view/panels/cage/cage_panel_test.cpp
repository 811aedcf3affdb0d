// SPDX-License-Identifier: MIT
#include "dialogs/aifs_dialog.h"
#include "document/fractal/fractal_geometry.h"
#include "panels/cage/cage_panel.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include "ifs/extent/polygon.h"
#include "support/named.h"
#include "support/named_test.h"
#include "support/patient_tries.h"

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>

#include <memory>

using namespace maps_support;
using view::CagePanel;
using view::NumberField;

class CagePanelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_document->setFile(document::fileOf(withTriangle(maple())));
        m_panel = std::make_unique<CagePanel>(m_document.get());
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }

    void aTypedVertexMovesThePicture() {
        NumberField* x = m_panel->field(CagePanel::Vertices::Current, 1, 0);
        QCOMPARE(x->value(), 5.0);
        type(x, QStringLiteral("6.5"));
        QCOMPARE(cage().current[1].x(), 6.5);
        QCOMPARE(cage().rest[1].x(), 5.0);
        QCOMPARE(m_document->undoStack()->count(), 0);
        QTest::keyClick(x, Qt::Key_Return);
        QCOMPARE(m_document->undoStack()->count(), 1);
        QVERIFY(m_panel->status().contains(QStringLiteral("1.1875"))); // (6.5 + 3) / (5 + 3)
        QVERIFY(m_panel->bakeAction()->isEnabled());
    }

    void stepsSayWhereTheVertexIs() {
        for (int axis = 0; axis < 2; ++axis) {
            NumberField* field = m_panel->field(CagePanel::Vertices::Current, 1, axis);
            type(field, axis == 0 ? QStringLiteral("1.2") : QStringLiteral("3"));
            QTest::keyClick(field, Qt::Key_Return);
        }
        const QUndoStack& history = *m_document->undoStack();
        QCOMPARE(history.count(), 2);
        QCOMPARE(history.text(0), QStringLiteral("Move vertex 2 to (1.2, -3)"));
        QCOMPARE(history.text(1), QStringLiteral("Move vertex 2 to (1.2, 3)"));
    }

    void aTypedRestVertexKeepsThePicture() {
        document::Fractal fractal = m_document->fractal();
        document::plane(fractal)->cage->current = {{0, 0}, {4, 1}, {-1, 5}};
        m_document->edit(QStringLiteral("place"), fractal);
        const auto shown = *document::effectiveSystem(m_document->fractal());
        NumberField* y = m_panel->field(CagePanel::Vertices::Rest, 2, 1);
        y->setVisible(true);
        type(y, QStringLiteral("8"));
        QTest::keyClick(y, Qt::Key_Return);
        QCOMPARE(cage().rest[2].y(), 8.0);
        const auto now = *document::effectiveSystem(m_document->fractal());
        for (std::size_t i = 0; i < shown.maps.size(); ++i)
            QVERIFY(distance(shown.maps[i].map, now.maps[i].map) < 1e-12);
    }

    void aRestTriangleOnOneLineIsRefused() {
        QSignalSpy messages(m_panel.get(), &CagePanel::message);
        const document::Fractal before = m_document->fractal();
        NumberField* y = m_panel->field(CagePanel::Vertices::Rest, 2, 1);
        y->setVisible(true);
        type(y, QStringLiteral("-3")); // (-3, -3) again
        QTest::keyClick(y, Qt::Key_Return);
        QVERIFY(!messages.isEmpty());
        QVERIFY(m_document->fractal() == before);
        QCOMPARE(y->value(), 6.0);
    }

    void rewriteModeRewritesTheCode() {
        QVERIFY(m_panel->modeButton(document::CageMode::Place)->isChecked());
        QTest::mouseClick(m_panel->modeButton(document::CageMode::Rewrite), Qt::LeftButton);
        QCOMPARE(m_document->cageMode(), document::CageMode::Rewrite);
        document::Fractal placed = m_document->fractal();
        document::plane(placed)->cage->current[1].x() = 6.5;
        const auto expected = *document::effectiveSystem(placed);
        NumberField* x = m_panel->field(CagePanel::Vertices::Current, 1, 0);
        type(x, QStringLiteral("6.5"));
        QTest::keyClick(x, Qt::Key_Return);
        QVERIFY(cage().rest == cage().current && cage().rest[1].x() == 6.5);
        const auto& maps = document::system2(m_document->fractal())->maps;
        for (std::size_t i = 0; i < maps.size(); ++i)
            QVERIFY(distance(maps[i].map, expected.maps[i].map) < 1e-12);
        QCOMPARE(m_document->undoStack()->count(), 1);
        // A flat cage has no code: it is placed.
        type(m_panel->field(CagePanel::Vertices::Current, 1, 0), QStringLiteral("-3"));
        type(m_panel->field(CagePanel::Vertices::Current, 1, 1), QStringLiteral("-3"));
        QVERIFY(cage().rest != cage().current);
    }

    void aBentCageSaysSoAndCannotBeBaked() {
        m_panel->fit(document::PolygonChoice::Box);
        QCOMPARE(cage().rest.size(), std::size_t{4});
        QVERIFY(m_panel->status().startsWith(QStringLiteral("4 ")));
        document::Fractal fractal = m_document->fractal();
        document::plane(fractal)->cage->current[2] += ifs::Vector<2>(2, 1);
        m_document->edit(QStringLiteral("bend"), fractal);
        QVERIFY(m_panel->deformationButton(ifs::Deformation::Bend)->isVisible());
        QVERIFY(m_panel->status().contains(QStringLiteral("Wachspress")));
        QVERIFY(!m_panel->bakeAction()->isEnabled());
        QVERIFY(m_panel->bakeAction()->toolTip().contains(QStringLiteral("bends")));
        QVERIFY(m_panel->warning().isEmpty());
        document::plane(fractal)->cage->current[2] =
            document::plane(fractal)->cage->current[0] - ifs::Vector<2>(1, 1);
        m_document->edit(QStringLiteral("fold"), fractal);
        QVERIFY(m_panel->warning().contains(QStringLiteral("folded")));
        QTest::mouseClick(m_panel->deformationButton(ifs::Deformation::AffineFit), Qt::LeftButton);
        QVERIFY(cage().deformation == ifs::Deformation::AffineFit);
        QVERIFY(m_panel->bakeAction()->isEnabled() && m_panel->warning().isEmpty());
        const auto shown = *document::effectiveSystem(m_document->fractal());
        m_panel->bake();
        QVERIFY(cage().rest == cage().current);
        const auto& maps = document::system2(m_document->fractal())->maps;
        for (std::size_t i = 0; i < maps.size(); ++i)
            QVERIFY(distance(maps[i].map, shown.maps[i].map) < 1e-12);
    }

    void polygonsAreFittedAroundThePicture() {
        const auto support =
            ifs::SupportFunction<2>::of(ifs::activeMaps(*document::system2(m_document->fractal())).maps);
        for (const auto choice : {document::PolygonChoice::Hull, document::PolygonChoice::Regular})
            for (const int corners : {3, 5, 8, 24}) {
                m_panel->fit(choice, corners);
                const auto rest = cage().rest;
                QCOMPARE(rest.size(), std::size_t(corners));
                QVERIFY(cage().current == rest);
                QCOMPARE(ifs::suitableCoordinates(rest, &*support), ifs::Coordinates::Wachspress);
            }
        m_panel->fit(document::PolygonChoice::Rectangle);
        QCOMPARE(cage().rest.size(), std::size_t{4});
        const double inBox = [this] {
            const auto box = document::displayedBox(m_document->fractal());
            return (box->max - box->min).prod();
        }();
        QVERIFY(ifs::area(cage().rest) <= 1.001 * inBox);
        // Around the picture as it is placed, and the picture stays.
        document::Fractal fractal = m_document->fractal();
        for (auto& vertex : document::plane(fractal)->cage->current)
            vertex = ifs::Vector<2>(2 * vertex.y() + 1, vertex.x());
        m_document->edit(QStringLiteral("place"), fractal);
        const auto shown = *document::effectiveSystem(m_document->fractal());
        m_panel->fit(document::PolygonChoice::Hull, 6);
        const auto now = *document::effectiveSystem(m_document->fractal());
        for (std::size_t i = 0; i < shown.maps.size(); ++i)
            QVERIFY(distance(shown.maps[i].map, now.maps[i].map) < 1e-9);
        QCOMPARE(cage().rest.size(), std::size_t{6});
    }

    void theAffineInvariantFormIsShown() {
        document::Document sierpinski; // over its own triangle: halves and ones
        document::Fractal fractal = sierpinski.fractal();
        const QStringList lines = view::aifsText(fractal, view::Digits::Few).split(u'\n');
        QCOMPARE(lines.filter(QStringLiteral("S")).size(), 3);
        double sum = 0;
        int rows = 0;
        for (const QString& line : lines) {
            const QStringList entries = line.simplified().split(u' ');
            if (entries.size() != 3 || line.startsWith(u'V')) continue;
            ++rows;
            for (const QString& text : entries)
                sum += text.toDouble();
        }
        QCOMPARE(rows, 9);
        QVERIFY(std::abs(sum - 9) < 1e-9);
        // Dragging the triangle moves its vertices and leaves the matrices.
        document::plane(fractal)->cage = document::effectiveCage(fractal);
        document::plane(fractal)->cage->current[0] = {-3, 2};
        const QStringList dragged = view::aifsText(fractal, view::Digits::Few).split(u'\n');
        QVERIFY(dragged[0] != lines[0] && dragged.mid(3) == lines.mid(3));
        document::system2(fractal)->maps[0].map.linear(0, 0) = 1. / 3;
        view::AifsDialog(fractal).copy();
        QVERIFY(
            QGuiApplication::clipboard()->text().contains(QRegularExpression(QStringLiteral("0\\.\\d{15}"))));
        // Of very many, some are shown and all copied.
        document::System2& system = *document::system2(fractal);
        system.maps.resize(700, system.maps[0]);
        const QString some = view::aifsText(fractal, view::Digits::Few);
        QVERIFY(some.contains(QStringLiteral("S500 =")) && !some.contains(QStringLiteral("S501 =")));
        QVERIFY(some.contains(QStringLiteral("and 200 more")));
        QVERIFY(view::aifsText(fractal, view::Digits::All).contains(QStringLiteral("S700 =")));
    }

    void unbakeKeepsThePicture() {
        const auto before = *document::effectiveSystem(m_document->fractal());
        const auto after = document::unbaked(m_document->fractal());
        QVERIFY(after.has_value());
        QVERIFY(document::plane(*after)->cage->rest[1] == ifs::Vector<2>(1, 0));
        const auto now = *document::effectiveSystem(*after);
        for (std::size_t i = 0; i < before.maps.size(); ++i)
            QVERIFY(distance(before.maps[i].map, now.maps[i].map) < 1e-12);
        QVERIFY(distance(document::system2(*after)->maps[0].map, before.maps[0].map) > 1e-3);
        for (const auto& map : document::system2(*after)->maps) // no noise in the table
            for (const double x : {map.map.linear(0, 0), map.map.linear(0, 1), map.map.linear(1, 0),
                                   map.map.linear(1, 1), map.map.translation.x(), map.map.translation.y()})
                QVERIFY(x == 0 || std::abs(x) > 1e-14);
        QVERIFY(!document::unbaked(*after));
    }

    void saysMirroredAndFlat() {
        document::Fractal fractal = m_document->fractal();
        QVERIFY(m_panel->status().contains(QStringLiteral("At rest")));
        document::plane(fractal)->cage->current = {{-3, -3}, {-11, -3}, {-3, 6}};
        m_document->edit(QStringLiteral("mirror"), fractal);
        QVERIFY(m_panel->status().contains(QStringLiteral("mirrored")));
        document::plane(fractal)->cage->current = {{-3, -3}, {0, 0}, {4, 4}};
        m_document->edit(QStringLiteral("flat"), fractal);
        QVERIFY(m_panel->status().contains(QStringLiteral("Flat")));
        QVERIFY(!m_panel->bakeAction()->isEnabled());
        QVERIFY(m_panel->bakeAction()->toolTip().contains(QStringLiteral("flat")));
        m_panel->reset();
        QVERIFY(m_panel->status().contains(QStringLiteral("At rest")));
    }

    void showsBarycentricCoordinates() {
        document::Fractal fractal = m_document->fractal();
        document::plane(fractal)->cage =
            ifs::cageAtRest<2>({ifs::Vector<2>(0, 0), ifs::Vector<2>(4, 0), ifs::Vector<2>(0, 3)});
        m_document->edit(QStringLiteral("cage"), fractal);
        type(m_panel->pointField(0), QStringLiteral("1"));
        type(m_panel->pointField(1), QStringLiteral("1"));
        QCOMPARE(m_panel->barycentric(), QStringLiteral("(0.4167, 0.25, 0.3333)"));
    }

    void fitsTheMinimalCanonicalSimplex() {
        document::Fractal fractal = m_document->fractal();
        document::plane(fractal)->cage->current = {{0, 0}, {4, 1}, {-1, 5}};
        m_document->edit(QStringLiteral("place"), fractal);
        const auto shown = *document::effectiveSystem(fractal);
        m_panel->fit(document::SimplexChoice::Minimal);
        const auto& corners = cage().current;
        QVERIFY(qAbs(corners[1].y() - corners[0].y()) < 1e-9 && qAbs(corners[2].x() - corners[0].x()) < 1e-9);
        QVERIFY(qAbs(qAbs(corners[1].x() - corners[0].x()) - qAbs(corners[2].y() - corners[0].y())) < 1e-9);
        const auto now = *document::effectiveSystem(m_document->fractal());
        for (std::size_t i = 0; i < shown.maps.size(); ++i)
            QVERIFY(distance(shown.maps[i].map, now.maps[i].map) < 1e-9);
        const int steps = m_document->undoStack()->count();
        QSignalSpy said(m_panel.get(), &CagePanel::message);
        m_panel->fit(document::SimplexChoice::Minimal); // where it is already
        QCOMPARE(m_document->undoStack()->count(), steps);
        QCOMPARE(said.size(), 1);

        m_panel->reset();
        m_panel->fit(document::SimplexChoice::MinusMinus);
        // Of the maple itself, as published for (−, −): corner (3.34421, 5.07246), leg 11.70466.
        fractal = maple();
        m_document->setFile(document::fileOf(fractal));
        m_panel->fit(document::SimplexChoice::MinusMinus);
        QVERIFY((cage().rest[0] - ifs::Vector<2>(3.34421444954056, 5.07246376811594)).norm() < 1e-6);
        QVERIFY(qAbs(cage().rest[0].x() - cage().rest[1].x() - 11.704657475156326) < 1e-6);
    }

    void saysTheMinimalCanonicalSimplexOfWhatIsShown() {
        const auto text = [this] {
            for (const auto* label : m_panel->findChildren<QLabel*>())
                if (label->accessibleName() == QStringLiteral("Minimal canonical simplex"))
                    return label->text();
            return QString();
        };
        m_document->setFile(document::fileOf(maple()));
        QTRY_COMPARE(text(), QStringLiteral("(−, −), leg 11.7047, corner (3.3442, 5.0725)"));
        document::Fractal twice = withTriangle(maple());
        for (std::size_t i = 0; i < 3; ++i)
            document::plane(twice)->cage->current[i] = 2 * document::plane(twice)->cage->rest[i];
        m_document->setFile(document::fileOf(twice));
        QTRY_COMPARE(text(), QStringLiteral("(−, −), leg 23.4093, corner (6.6884, 10.1449)"));
        document::Fractal none = maple();
        document::system2(none)->maps.clear();
        m_document->setFile(document::fileOf(none));
        QTRY_COMPARE(text(), QStringLiteral("No map is active, so there is nothing to enclose."));
    }

    void asksForTheThreeClicks() {
        QSignalSpy asked(m_panel.get(), &CagePanel::defineRequested);
        support::action(*m_panel, "define")->trigger();
        QCOMPARE(asked.size(), 1);
    }

private:
    const ifs::ControlCage<2>& cage() const { return *document::plane(m_document->fractal())->cage; }
    static void type(NumberField* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
    }
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<CagePanel> m_panel;
};

BARYCAGE_TEST(CagePanelTest, QApplication);
#include "cage_panel_test.moc"
