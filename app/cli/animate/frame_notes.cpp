// SPDX-License-Identifier: MIT
#include "animate/frame_notes.h"

#include "options/tr.h"
#include "process/messages.h"
#include "render/render_note.h"

#include "document/moments/animated_fractal.h"

namespace cli {

namespace {

QString momentText(const animation::Moment& moment) {
    return moment.denominator == 1 ? QString::number(moment.numerator)
                                   : QString::number(double(moment.numerator) / double(moment.denominator));
}

void warn(const Input& input, const document::Fractal& entry, ifs::Verdict verdict, const QString& frames,
          bool areSeveral) {
    const bool isOpen = verdict == ifs::Verdict::Undecided;
    const QString sentence =
        areSeveral
            ? (isOpen ? tr("At the frames %1 of “%2” it could not be decided whether there is an "
                           "attractor.")
                      : tr("At the frames %1 of “%2” there is no attractor."))
            : (isOpen ? tr("At frame %1 of “%2” it could not be decided whether there is an attractor.")
                      : tr("At frame %1 of “%2” there is no attractor."));
    reportWarning(input.name, sentence.arg(frames, printableLine(entry.name)));
}

} // namespace

QString rangesText(const std::vector<int>& numbers) {
    QStringList ranges;
    for (std::size_t first = 0, last = 0; first < numbers.size(); first = ++last) {
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
            ++last;
        const QString from = QString::number(numbers[first]);
        ranges << (first == last ? from : QStringLiteral("%1–%2").arg(from).arg(numbers[last]));
    }
    return ranges.join(QStringLiteral(", "));
}

FrameNotes::FrameNotes(const Input& input, const document::Fractal& entry, const std::vector<int>& frames)
    : m_isInSpace(document::space(entry) != nullptr) {
    const auto lost = document::firstWithoutAttractor(entry);
    if (!lost) return;
    std::map<bool, std::vector<int>> found; // key: whether the loss is merely undecided
    for (const int frame : frames) {
        if (const auto verdict = document::lossAt(entry, animation::moment(frame)))
            found[verdict == ifs::Verdict::Undecided].push_back(frame);
    }
    for (const auto& [isOpen, those] : found) {
        warn(input, entry, isOpen ? ifs::Verdict::Undecided : ifs::Verdict::None, rangesText(those),
             those.size() > 1);
        m_lost.insert(those.begin(), those.end());
    }
    if (found.empty()) warn(input, entry, lost->verdict, momentText(lost->moment), false);
}

void FrameNotes::add(int frame, attractor::RenderNote note) {
    using attractor::RenderNote;
    const bool isSaid = note == RenderNote::NoAttractor || note == RenderNote::Undecided;
    if (note != RenderNote::None && !(isSaid && m_lost.contains(frame))) m_frames[note].push_back(frame);
}

void FrameNotes::report(const QString& fileName) const {
    for (const auto& [note, frames] : m_frames) {
        const QString sentence = sentenceOf(note, m_isInSpace);
        if (sentence.isEmpty()) continue;
        const QString text = frames.size() > 1 ? tr("Frames %1: %2") : tr("Frame %1: %2");
        reportWarning(fileName, text.arg(rangesText(frames), sentence));
    }
}

} // namespace cli
