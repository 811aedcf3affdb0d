// SPDX-License-Identifier: MIT
#pragma once

#include "document/edits/collage_edits.h"
#include "panels/collage/collage_layer.h"
#include "panels/collage/collage_panel.h"
#include "panels/collage/target_box.h"
#include "support/patient_tries.h"
#include "view/canvas/canvas_fixture.h"

#include <QBuffer>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QTemporaryDir>

using view::CollagePanel;

// A dark leaf on a light ground.
inline QImage leaf(int side = 160) {
    QImage image(side, side, QImage::Format_RGB32);
    image.fill(qRgb(245, 245, 240));
    QPainter painter(&image);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(30, 60, 30));
    QPainterPath path(QPointF(0.5, 0.05) * side);
    path.quadTo(QPointF(0.95, 0.5) * side, QPointF(0.5, 0.95) * side);
    path.quadTo(QPointF(0.05, 0.5) * side, QPointF(0.5, 0.05) * side);
    painter.drawPath(path);
    return image;
}

inline QByteArray encoded(const QImage& image, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, format);
    return bytes;
}

// A canvas with the panel of collages beside it.
class CollagePanelFixture : public CanvasFixture {
protected:
    std::unique_ptr<CollagePanel> m_panel;
    QTemporaryDir m_folder;

    void openPanel() {
        open();
        m_panel = std::make_unique<CollagePanel>(m_document.get(), m_canvas.get());
        m_panel->resize(360, 1000);
        m_panel->show();
        m_panel->showMore(true); // all that it has
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    QString write(const QString& name, const QByteArray& bytes) {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) return {};
        return file.fileName();
    }
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(m_panel->isSettled(), 60000); }
    void traceLeaf() {
        m_panel->target()->read(write(QStringLiteral("leaf.png"), encoded(leaf(), "PNG")));
        settle();
        QVERIFY(m_panel->target()->traced());
    }
    template <class Widget> Widget* named(const QString& name) const {
        const QList<Widget*> widgets = m_panel->findChildren<Widget*>();
        for (auto* widget : widgets)
            if (widget->accessibleName() == name) return widget;
        for (auto* widget : widgets)
            if (widget->property("text").toString() == name) return widget;
        return nullptr;
    }
    void push(const char* text) {
        auto* button = named<QPushButton>(QLatin1String(text));
        QVERIFY2(button, text);
        QVERIFY2(button->isEnabled(), text);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    QString number(const char* name) const { return named<QLabel>(QLatin1String(name))->text(); }
    QString sentence() const { return named<QLabel>(QStringLiteral("Target"))->text(); }
    view::CollageLayer* layer() const {
        for (QGraphicsItem* item : scene().items())
            if (auto* found = dynamic_cast<view::CollageLayer*>(item)) return found;
        return nullptr;
    }
    // What is told of a picture that is 1 unit high, with its middle at the origin, where the target lies.
    ifs::Vector<2> placed(const ifs::Vector<2>& point) const {
        return m_panel->target()->traced()->place.map()(point);
    }
    ifs::AffineMap<2> placed(const ifs::AffineMap<2>& map) const {
        return *ifs::conjugate<2>(m_panel->target()->traced()->place.map(), map);
    }
    // Like the leaf, and in its place: three small copies.
    void takeRoughMaps() {
        document::Fractal fractal = m_document->fractal();
        document::Shape<2> shape;
        for (const double y : {-0.25, 0.0, 0.25})
            ifs::append<2>(shape.system, placed(ifs::affineMap(0.5, 0.1, -0.1, 0.5, 0.05 * y, y)), 0.3);
        fractal.shape = std::move(shape);
        m_document->edit(QStringLiteral("Prepare"), std::move(fractal));
        m_canvas->selectMaps({});
        settle();
    }
    double meanDistance() const {
        const auto maps = document::collageMaps(m_document->fractal());
        return collage::collageMeasure(m_panel->target()->traced()->target, maps->maps).images.mean;
    }
};
