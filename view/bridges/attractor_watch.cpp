// SPDX-License-Identifier: MIT
#include "bridges/attractor_watch.h"

#include "widgets/numbers/number_text.h"

#include <algorithm>
#include <set>
#include <utility>

namespace view {

namespace {

double frameOf(const animation::Moment& moment) {
    return double(moment.numerator) / double(moment.denominator);
}

QString list(const std::vector<int>& frames) {
    constexpr std::size_t most = 8;
    QStringList texts;
    for (std::size_t i = 0; i < std::min(frames.size(), most); ++i)
        texts << QString::number(frames[i]);
    if (frames.size() > most) texts << QStringLiteral("…");
    return texts.join(QStringLiteral(", "));
}

} // namespace

std::optional<AttractorLoss> attractorLoss(const document::Fractal& entry, const std::stop_token& stop) {
    const auto first = document::firstWithoutAttractor(entry, stop);
    const auto facts = document::animationFacts(entry);
    if (!first || !facts) return std::nullopt;
    AttractorLoss loss{*first, {}, {}, false, facts->motions > 0};
    const std::set<int> keys = document::keyFramesOfMaps(entry);
    std::vector<int> lostKeys;
    for (const int frame : document::framesToTry(entry)) {
        if (stop.stop_requested()) return std::nullopt;
        const auto verdict = document::lossAt(entry, animation::moment(frame));
        if (!verdict) continue;
        if (loss.frames.empty()) loss.first = {animation::moment(frame), *verdict};
        loss.frames.push_back(frame);
        if (keys.contains(frame)) lostKeys.push_back(frame);
    }
    loss.isAtKeys = !lostKeys.empty();
    loss.keys = std::move(lostKeys);
    if (loss.isAtKeys || keys.empty()) return loss;
    const auto after = keys.upper_bound(int(frameOf(loss.first.moment)));
    if (after != keys.begin()) loss.keys.push_back(*std::prev(after));
    if (after != keys.end()) loss.keys.push_back(*after);
    return loss;
}

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
        const Lost lost = attractorLoss(*looked, stop);
        if (stop.stop_requested()) return std::nullopt;
        return std::optional<Lost>(std::in_place, lost);
    });
}

// The first moment alone where no whole frame is known.
std::vector<double> AttractorWatch::lostFrames() const {
    if (!m_lost) return {};
    if (m_lost->frames.empty()) return {frameOf(m_lost->first.moment)};
    return {m_lost->frames.begin(), m_lost->frames.end()};
}

QString AttractorWatch::advice() const {
    const QString frames = list(m_lost->keys);
    if (frames.isEmpty()) return m_lost->hasMotions ? tr("Weaken the motions.") : tr("Change the maps.");
    if (m_lost->hasMotions)
        return tr("Weaken the motions, or change the keys of the maps (frames: %1).").arg(frames);
    if (m_lost->isAtKeys) return tr("Change the keys of the maps (frames: %1).").arg(frames);
    return tr("Set a key there, or change the keys of the maps (frames: %1).").arg(frames);
}

QString AttractorWatch::sentence() const {
    if (!m_lost) return {};
    const QString frame = roundedNumber(frameOf(m_lost->first.moment), 2);
    if (m_lost->first.verdict == ifs::Verdict::Undecided)
        return tr("At frame %1, it could not be decided whether there is an attractor.").arg(frame);
    return tr("At frame %1, there is no attractor.").arg(frame) + u' ' + advice();
}

void AttractorWatch::setLost(const Lost& lost) {
    const auto frames = lostFrames();
    const QString before = sentence();
    m_lost = lost;
    if (frames != lostFrames() || before != sentence()) emit changed();
}

} // namespace view
