// SPDX-License-Identifier: MIT
#include "widgets/icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace view {
namespace {

QColor inkColour(QIcon::Mode mode) {
    const QPalette palette = QGuiApplication::palette();
    switch (mode) {
    case QIcon::Disabled:
        return palette.color(QPalette::Disabled, QPalette::WindowText);
    case QIcon::Selected:
        return palette.color(QPalette::Active, QPalette::HighlightedText);
    case QIcon::Normal:
    case QIcon::Active:
        break;
    }
    return palette.color(QPalette::Active, QPalette::WindowText);
}

// Asks for the colour when it draws, so an icon made once is right under every palette.
class PaletteIconEngine : public QIconEngine {
public:
    PaletteIconEngine(const QString& name, const QByteArray& svg) : m_name(name), m_svg(svg) {}

    QIconEngine* clone() const override { return new PaletteIconEngine(*this); }
    QString key() const override { return QStringLiteral("barycage-palette-icon"); }
    bool isNull() override { return false; }
    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override { return square(size); }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const qreal scale = painter->device()->devicePixelRatioF();
        const QSize size = square(rect.size());
        const QPixmap pixels = scaledPixmap(size * scale, mode, state, scale);
        QRect target(QPoint(), size);
        target.moveCenter(rect.center());
        painter->drawPixmap(target, pixels);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1);
    }

    // `size` counts device pixels.
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal scale) override {
        const QSize pixels = square(size);
        const QColor ink = inkColour(mode);
        const QString cacheKey = QStringLiteral("barycage-icon/%1/%2/%3/%4")
                                     .arg(m_name)
                                     .arg(pixels.width())
                                     .arg(ink.rgba(), 8, 16)
                                     .arg(scale);
        QPixmap result;
        if (!QPixmapCache::find(cacheKey, &result)) {
            result = drawn(pixels, ink);
            result.setDevicePixelRatio(scale);
            QPixmapCache::insert(cacheKey, result);
        }
        return result;
    }

private:
    static QSize square(const QSize& size) {
        const int side = qMax(1, qMin(size.width(), size.height()));
        return QSize(side, side);
    }

    QPixmap drawn(const QSize& size, const QColor& ink) const {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        QSvgRenderer(m_svg).render(&painter, QRectF(QPointF(), QSizeF(size)));
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(result.rect(), ink);
        return result;
    }

    QString m_name;
    QByteArray m_svg;
};

} // namespace

QIcon icon(const QString& name) {
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) return QIcon();
    return QIcon(new PaletteIconEngine(name, file.readAll()));
}

} // namespace view
