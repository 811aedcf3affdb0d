// SPDX-License-Identifier: MIT
#pragma once

#include "document/animated_fractal.h"
#include "widgets/newest_work.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>

namespace view {

// Whether an animation has an attractor all the time: looked for in the background.
class AttractorWatch : public QObject {
    Q_OBJECT

public:
    explicit AttractorWatch(QObject* parent = nullptr);

    // Until it is known, what was known of the entry before stays; nullptr is known at once.
    void look(std::shared_ptr<const document::Fractal> entry);
    // nullopt: no moment is known that has none.
    const std::optional<document::MomentWithoutAttractor>& lost() const { return m_lost; }
    std::optional<double> lostFrame() const;
    QString sentence() const; // empty where nothing is lost

signals:
    void changed();

private:
    using Lost = std::optional<document::MomentWithoutAttractor>;
    void setLost(const Lost& lost);

    std::shared_ptr<const document::Fractal> m_entry; // the one that has been looked at
    Lost m_lost;
    bool m_hasMotions = false; // the entry that m_lost is of
    NewestWork<Lost> m_work;   // last: it stops before the rest goes
};

} // namespace view
