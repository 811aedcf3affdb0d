// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/edits/timeline/animation_edits.h"

#include <QDialog>

#include <vector>

class QLabel;

namespace view {

class OrbitRows;

// The numbers of a motion of the current entry: its strength, turns and cycles, and where an orbit turns.
// What is chosen is seen at once; OK makes it one step of the history, Cancel takes it back.
class MotionDialog : public QDialog {
    Q_OBJECT

public:
    // `name` is that of the motion.
    MotionDialog(document::Document& document, std::size_t motion, const QString& name,
                 QWidget* parent = nullptr);

private:
    // The number of this index, the `ordinal`-th of those of its kind.
    QWidget* field(std::size_t index, int ordinal);
    void take(std::size_t index, double value);
    void preview();
    // The entry with these numbers or, so that an attractor is left at all times, with a smaller strength and
    // a note about it.
    document::Fractal changed() const;

    document::Fractal m_entry; // entry at the opening of the dialog
    std::size_t m_motion;
    std::vector<document::MotionNumber> m_numbers; // exact values of numbers that the fields show rounded
    OrbitRows* m_orbit = nullptr;                  // orbits only
    QLabel* m_note = nullptr;
    document::EditGesture m_gesture;
};

} // namespace view
