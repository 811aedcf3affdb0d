// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace view {

class Timeline;

// Play and pause, the frame, the next key; the length of the animation, its rate, and its behaviour after the
// end.
class TransportBar : public QWidget {
    Q_OBJECT

public:
    // `last` stands at the end of the row.
    TransportBar(Timeline* timeline, QWidget* last, QWidget* parent = nullptr);

    QToolButton* play() const { return m_play; }
    QSpinBox* frame() const { return m_frame; }
    QSpinBox* length() const { return m_length; }
    QComboBox* rate() const { return m_rate; }
    QComboBox* loop() const { return m_loop; }

    // The size without names and optional controls, which are hidden when there is too little room.
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitInto(int width);
    void makeRate();
    void makeFields();
    void showAnimation();
    void showFrame();
    void showPlaying(bool playing);
    void showRate();
    void takeRate(); // adopts the typed or chosen rate

    Timeline* m_timeline;
    QToolButton* m_play;
    QSpinBox* m_frame;
    QSpinBox* m_length;
    QComboBox* m_rate;
    QComboBox* m_loop;
    QLabel* m_pictures;            // how many a second
    QList<QWidget*> m_dispensable; // the first ones first
    bool m_hasComplained = false;  // of the rate that was typed last
    QTimer m_count;
};

} // namespace view
