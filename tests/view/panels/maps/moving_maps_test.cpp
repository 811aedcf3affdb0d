// SPDX-License-Identifier: MIT
#include "document/fractal/fractal_geometry.h"
#include "panels/maps/map_shape_editor.h"
#include "panels/maps/maps_panel.h"
#include "support/named_test.h"
#include "view/panels/maps_support.h"
#include "widgets/numbers/number_field.h"

#include <QAbstractItemDelegate>
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QStyleOptionViewItem>
#include <QTableView>
#include <QTest>

#include <cmath>
#include <memory>

using namespace maps_support;
using view::MapsModel;

// The numbers of an entry that moves, as wide as the panel at the first start.
class MovingMapsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_document = std::make_unique<document::Document>();
        m_panel = std::make_unique<view::MapsPanel>(m_document.get());
        m_panel->resize(334, 400);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }

    // Not one digit less than two, and nothing over its neighbours.
    void numbersHaveTwoDecimals() {
        document::Fractal fractal = withTriangle(maple());
        document::plane(fractal)->system.maps[2].map.linear << 0.288, 0.297, -0.481, 0.3;
        m_document->setFile(document::fileOf(fractal));
        showInMotion(fractal, 0.2);
        const MapsModel* model = m_panel->model();
        for (int frame = 0; frame < 24; ++frame) {
            m_document->setMoment(animation::moment(frame));
            for (int row = 0; row < model->rowCount(); ++row)
                for (int column = MapsModel::A; column <= MapsModel::Weight; ++column) {
                    QVERIFY(model->index(row, column).data(MapsModel::DecimalsRole).toInt() >= 2);
                    const QRect cell = m_panel->table()->visualRect(model->index(row, column));
                    QVERIFY2(inkOutside(cell) == 0, qPrintable(QStringLiteral("%1 %2").arg(row).arg(column)));
                }
        }
        const double a = document::system2(m_document->fractal())->maps[1].map.linear(0, 0);
        const double shown = model->index(1, MapsModel::A).data().toString().toDouble();
        QVERIFY2(std::abs(shown - a) <= 0.005, qPrintable(QString::number(shown)));
    }

    // Where both parts of a shift are what rounding has left.
    void shiftsAreZeroInBothPlaces() {
        document::Fractal fractal = withTriangle(maple());
        document::plane(fractal)->system.maps[0].map.translation = {-0x1p-56, 0x1p-55};
        m_document->setFile(document::fileOf(fractal));
        showInMotion(fractal, 0);
        m_panel->table()->selectRow(0);
        for (const int column : {MapsModel::E, MapsModel::F})
            QCOMPARE(m_panel->model()->index(0, column).data().toString(), QStringLiteral("0"));
        const auto* editor = m_panel->findChild<view::MapShapeEditor*>();
        for (const auto part : {view::MapShapeEditor::TranslationX, view::MapShapeEditor::TranslationY})
            QCOMPARE(editor->field(part)->text(), QStringLiteral("0"));
    }

private:
    void showInMotion(document::Fractal fractal, double strength) {
        animation::Sway<2> sway;
        sway.maps = {document::plane(fractal)->system.maps[1].id};
        sway.strength = strength;
        sway.waves = {{1, 1, 0, 60}};
        auto& animation = document::plane(fractal)->animation.emplace();
        animation.length = 24;
        animation.motions = {sway};
        m_document->editEntry(QStringLiteral("Sway"), fractal);
        m_document->setMoment(animation::moment(3));
    }

    // Pixels beside the cell that its number has painted: the viewport, with this cell alone.
    int inkOutside(const QRect& cell) const {
        QTableView* table = m_panel->table();
        QStyleOptionViewItem option;
        option.initFrom(table);
        option.rect = QRect(cell.width(), 0, cell.width(), cell.height());
        option.font = table->font();
        option.fontMetrics = QFontMetrics(option.font);
        QImage image(3 * cell.width(), cell.height(), QImage::Format_ARGB32);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        table->itemDelegate()->paint(&painter, option, table->indexAt(cell.center()));
        painter.end();
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                pixels += qAlpha(image.pixel(x, y)) > 0 && !option.rect.contains(x, y);
        return pixels;
    }

    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::MapsPanel> m_panel;
};

BARYCAGE_TEST(MovingMapsTest, QApplication);
#include "moving_maps_test.moc"
