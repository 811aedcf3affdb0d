// SPDX-License-Identifier: MIT
#include "bridges/analysis_bridge.h"
#include "canvas/marks/address_walk.h"
#include "document/fractal/fractal_geometry.h"
#include "support/named_test.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QSignalSpy>

using document::Outline;
using document::OutlineShape;

// A cylinder that an analysis outlines is clicked.
class CylinderWalkTest : public CanvasFixture {
    Q_OBJECT

private slots:
    void init() {
        open();
        m_document->edit(QStringLiteral("triangle"), document::sierpinskiTriangle());
        m_canvas->fit();
        m_analysis = std::make_unique<view::AnalysisBridge>(m_document.get());
        connect(m_analysis.get(), &view::AnalysisBridge::changed, m_canvas.get(), [this] {
            const auto analysis = m_analysis->analysis();
            using Shapes = std::vector<OutlineShape>;
            m_canvas->showOutlines(analysis ? analysis->shapes : Shapes(),
                                   analysis ? analysis->outerCylinders : Shapes());
        });
        m_analysis->setCylinderDepth(2);
        m_analysis->setOutlined(Outline::Cylinders, true);
        QTRY_VERIFY(m_analysis->isCurrent());
    }
    void cleanup() {
        m_analysis.reset();
        close();
    }

    void aClickChoosesItAndSaysItsAddress() {
        QSignalSpy said(m_canvas.get(), &CanvasView::message);
        const int before = steps();
        click(middleOf({1, 2}));
        QCOMPARE(chosen(), (ifs::Word{1, 2}));
        QCOMPARE(said.last().first().toString(), QStringLiteral("Cylinder 2 3"));
        const auto walk = scene().marks().cylinderWalk();
        QCOMPARE(walk.size(), std::size_t{2});
        QCOMPARE(walk[0]->word, (ifs::Word{1}));
        click(middleOf({0, 0}));
        QCOMPARE(chosen(), (ifs::Word{0, 0}));
        click(empty());
        QVERIFY(chosen().empty());
        QCOMPARE(steps(), before); // nothing has been edited
    }

    void aDragChoosesNone() {
        drag(middleOf({1, 2}), {20, 0});
        QVERIFY(chosen().empty());
    }

    void itIsOutlinedWithWhatContainsIt() {
        auto* mark = new view::AddressWalk; // owned by the scene
        m_canvas->scene()->addItem(mark);
        const QPointF inside = middleOf({1, 2}), outside = middleOf({0, 0});
        click(inside);
        QTRY_VERIFY(m_bridge->isCurrent());
        // No event comes between the two: the picture is the same.
        const QImage with = m_canvas->viewport()->grab().toImage();
        mark->setVisible(false);
        const QImage without = m_canvas->viewport()->grab().toImage();
        const auto differs = [&](const QPointF& p) {
            return with.pixel(p.toPoint()) != without.pixel(p.toPoint());
        };
        QVERIFY(differs(inside));
        QVERIFY(!differs(outside));
        const QPolygonF outer =
            view::pixelsOf(m_canvas->camera(), scene().marks().cylinderWalk().front()->points);
        int changed = 0;
        for (int i = 0; i < 3; ++i)
            for (const double share : {0.2, 0.35, 0.65, 0.8})
                changed += differs(outer[i] * share + outer[(i + 1) % 3] * (1 - share));
        QVERIFY2(changed >= 4, qPrintable(QString::number(changed)));
    }

    void itStaysChosenWhileTheCageMovesAndGoesWithItsDepth() {
        const int before = steps();
        click(middleOf({1, 2}));
        drag(vertex(0), {-18, 9});
        QCOMPARE(steps(), before + 1);
        QTRY_VERIFY(m_analysis->isCurrent());
        QCOMPARE(chosen(), (ifs::Word{1, 2}));
        m_analysis->setCylinderDepth(3);
        QTRY_VERIFY(chosen().empty());
    }

private:
    // Of the triangle that the cylinder is.
    QPointF middleOf(const ifs::Word& word) const {
        for (const OutlineShape& shape : m_analysis->analysis()->shapes) {
            if (shape.word != word) continue;
            ifs::Vector<2> sum = ifs::Vector<2>::Zero();
            for (const auto& point : shape.points)
                sum += point;
            return view::pixelOf(m_canvas->camera(), sum / double(shape.points.size()));
        }
        return {};
    }
    ifs::Word chosen() const {
        const auto walk = scene().marks().cylinderWalk();
        return walk.empty() ? ifs::Word() : walk.back()->listed;
    }

    std::unique_ptr<view::AnalysisBridge> m_analysis;
};

BARYCAGE_TEST(CylinderWalkTest, QApplication);
#include "cylinder_walk_test.moc"
