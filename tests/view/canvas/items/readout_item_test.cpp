// SPDX-License-Identifier: MIT
#include "canvas/items/readout_item.h"
#include "support/named_test.h"

#include <QTest>

// The box at the pointer that says what a drag has come to.
class ReadoutItemTest : public QObject {
    Q_OBJECT

private slots:
    void staysInside_data() {
        QTest::addColumn<int>("width");
        QTest::newRow("wide") << 900;
        QTest::newRow("beside the partner") << 260;
        QTest::newRow("narrower than the text") << 120;
    }

    // At every edge and in every corner, however narrow the canvas, and never under the pointer.
    void staysInside() {
        QFETCH(int, width);
        const QRectF view(0, 0, width, 500);
        view::ReadoutItem item;
        item.setView(view);
        for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0})
            for (const double y : {0.0, 0.5, 1.0}) {
                const QPointF pointer(x * width, y * view.height());
                item.setText(QStringLiteral("x 0.123456  y −0.654321\nα 0.25  β 0.33  γ 0.5"), pointer);
                QVERIFY(view.contains(item.box()));
                QVERIFY(!item.box().contains(pointer));
            }
    }
};

BARYCAGE_TEST(ReadoutItemTest, QApplication);
#include "readout_item_test.moc"
