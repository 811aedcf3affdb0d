// SPDX-License-Identifier: MIT
#pragma once

#include <QSize>
#include <QWidget>

class QComboBox;
class QSpinBox;
class QToolButton;

namespace view {

// Width and height of the frames of an animation in pixels: usual sizes by name, upright or lying, and the
// proportions locked or free.
class FrameSizeEditor : public QWidget {
    Q_OBJECT

public:
    explicit FrameSizeEditor(QWidget* parent = nullptr);

    QSize size() const;
    void setFrameSize(const QSize& size); // as it is, also against the lock

signals:
    void changed();
    void edited(); // by the user

private:
    void addNamedSizes();
    void takeWidth(int width);
    void takeHeight(int height);
    void show(const QSize& size);

    QSize m_locked; // has the proportions that are kept
    QComboBox* m_named;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QToolButton* m_lock;
    QToolButton* m_turn;
};

} // namespace view
