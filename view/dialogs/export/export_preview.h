// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/background/newest_work.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <stop_token>

namespace view {

// A picture as it will be exported, reduced to the available room: its shape, its content, and a chequer
// where it is transparent. It is drawn in the background; the newest request wins.
class ExportPreview : public QWidget {
    Q_OBJECT

public:
    // Draws the picture at a size of `pixels`, in the shape of the exported one; called in any thread.
    using Drawing = std::function<std::optional<QImage>(const QSize& pixels, const std::stop_token&)>;

    explicit ExportPreview(QWidget* parent = nullptr);

    // Shows a picture of this size, > 0; without a drawing it is not known yet.
    void show(const QSize& size, Drawing drawing);
    const QImage& picture() const { return m_picture; } // null before the first one
    bool isBusy() const { return m_work.isBusy(); }
    QRect frame() const; // area of the picture, in pixels of this widget

    QSize sizeHint() const override;

signals:
    void drawn();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Drawn {
        QImage picture;
        QSize of; // size of the export
    };
    void draw();

    QSize m_size{1, 1};
    Drawing m_drawing;
    QImage m_picture;
    QSize m_shown;  // size for which the picture was drawn
    QTimer m_delay; // delay while fields and edges move
    QTimer m_patience;
    NewestWork<Drawn> m_work;
};

} // namespace view
