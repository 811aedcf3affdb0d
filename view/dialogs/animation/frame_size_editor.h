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
    void setFrameSize(const QSize& size); // exact size, even against the lock

signals:
    void changed();
    void edited(); // sent for edits by the user

private:
    void addNamedSizes();
    void takeWidth(int width);
    void takeHeight(int height);
    void show(const QSize& size);

    QSize m_locked; // size with the locked proportions
    QComboBox* m_named;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QToolButton* m_lock;
    QToolButton* m_turn;
};

} // namespace view
