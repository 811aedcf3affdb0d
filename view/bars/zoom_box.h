// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>

namespace view {

class CanvasView;

// Shows the zoom of the canvas in percent, 100 % being a hundred pixels a unit of the plane; takes another by
// typing, or one of the list, or that at which the attractor fits. What is typed and cannot be taken stays,
// with the reason, until it is mended or left.
class ZoomBox : public QComboBox {
    Q_OBJECT

public:
    explicit ZoomBox(CanvasView* canvas, QWidget* parent = nullptr);

    static QString textOf(double factor); // "100 %" for 1

    void setViews(const QStringList& names); // names listed below the factors

signals:
    void viewChosen(const QString& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void choose(int index);
    void takeText();
    void showZoom();
    void showProblem(const QString& reason);

    CanvasView* m_canvas;
    int m_factors; // number of items before the views
};

} // namespace view
