// SPDX-License-Identifier: MIT
#pragma once

#include "document/moments/animated_fractal.h"
#include "widgets/background/newest_work.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace view {

// The frames and keys at which an animation has no certain attractor.
struct AttractorLoss {
    document::MomentWithoutAttractor first; // whole frame, if one is known
    std::vector<int> frames;                // examined frames without an attractor
    std::vector<int> keys;                  // map keys without an attractor, or else the keys around `first`
    bool isAtKeys = false;
    bool hasMotions = false;
};
// Checks all frames, or evenly spaced ones of a long animation or a large system. nullopt if nothing is lost,
// or when stopped before that was known.
std::optional<AttractorLoss> attractorLoss(const document::Fractal& entry, const std::stop_token& stop);

// Watches in the background whether an animation has an attractor all the time.
class AttractorWatch : public QObject {
    Q_OBJECT

public:
    explicit AttractorWatch(QObject* parent = nullptr);

    // Starts a check. The result of the entry before stays until the new one is known; nullptr is known at
    // once.
    void look(std::shared_ptr<const document::Fractal> entry);
    // nullopt: no moment is known that has none.
    const std::optional<AttractorLoss>& lost() const { return m_lost; }
    std::vector<double> lostFrames() const;
    QString sentence() const; // empty if nothing is lost

signals:
    void changed();

private:
    using Lost = std::optional<AttractorLoss>;
    void setLost(const Lost& lost);
    QString advice() const;

    std::shared_ptr<const document::Fractal> m_entry; // entry that has been examined
    Lost m_lost;
    NewestWork<Lost> m_work; // last member: its thread uses the others
};

} // namespace view
