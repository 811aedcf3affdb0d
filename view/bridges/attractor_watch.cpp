// SPDX-License-Identifier: MIT
#include "bridges/attractor_watch.h"

#include "widgets/number_text.h"

#include <utility>

namespace view {

AttractorWatch::AttractorWatch(QObject* parent)
    : QObject(parent), m_work([this](const std::optional<Lost>& lost) {
          if (lost) setLost(*lost);
      }) {}

void AttractorWatch::look(std::shared_ptr<const document::Fractal> entry) {
    if (entry == m_entry) return;
    m_entry = std::move(entry);
    m_work.cancel();
    if (!m_entry || !document::animationFacts(*m_entry)) return setLost(std::nullopt);
    m_work.submit([looked = m_entry](const std::stop_token& stop) -> std::optional<Lost> {
        const Lost lost = document::firstWithoutAttractor(*looked, stop);
        if (stop.stop_requested()) return std::nullopt;
        return std::optional<Lost>(std::in_place, lost);
    });
}

std::optional<double> AttractorWatch::lostFrame() const {
    if (!m_lost) return std::nullopt;
    return double(m_lost->moment.numerator) / double(m_lost->moment.denominator);
}

QString AttractorWatch::sentence() const {
    if (!m_lost) return {};
    const QString frame = roundedNumber(*lostFrame(), 2);
    if (m_lost->verdict == ifs::Verdict::Undecided)
        return tr("At frame %1, it could not be decided whether there is an attractor.").arg(frame);
    return (m_hasMotions
                ? tr("At frame %1, there is no attractor. Weaken the motions, or set a key there.")
                : tr("At frame %1, there is no attractor. Set a key there, or change those around it."))
        .arg(frame);
}

void AttractorWatch::setLost(const Lost& lost) {
    const auto frame = lostFrame();
    const QString before = sentence();
    m_lost = lost;
    const auto facts = m_entry ? document::animationFacts(*m_entry) : std::nullopt;
    m_hasMotions = facts && facts->motions > 0;
    if (frame != lostFrame() || before != sentence()) emit changed();
}

} // namespace view
