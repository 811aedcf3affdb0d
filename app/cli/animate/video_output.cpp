// SPDX-License-Identifier: MIT
#include "animate/video_output.h"

#include "options/parser.h"
#include "options/tr.h"
#include "process/messages.h"

#include <QLatin1String>
#include <QStringList>

#include <memory>
#include <optional>
#include <utility>

namespace cli {

namespace {

constexpr double shareOfFrames = 0.9; // share of the frames in the progress; the rest is finishing

// Titles of formats that store any transparency; a colour of a palette is transparent or not.
QStringList transparentFormats() {
    QStringList titles;
    for (const io::VideoFormatFacts& facts : io::videoFormats())
        if (facts.storesAlpha && !facts.isPaletted) titles << QLatin1String(facts.title);
    return titles;
}

void warnAboutFormat(const QString& path, const io::VideoSettings& settings) {
    const io::VideoFormatFacts& facts = io::factsOf(settings.format);
    const bool isOdd = settings.width % 2 != 0 || settings.height % 2 != 0;
    if (facts.needsEvenSides && isOdd)
        reportWarning(path,
                      tr("%1 needs even sides: the last column or row is shown twice, and the video has "
                         "%2x%3 pixels.")
                          .arg(QLatin1String(facts.title))
                          .arg(settings.width + settings.width % 2)
                          .arg(settings.height + settings.height % 2));
    if (!facts.storesAlpha && settings.isTransparent)
        reportWarning(path, tr("%1 stores no transparency: the background is black. %2 store it.")
                                .arg(QLatin1String(facts.title), listed(transparentFormats(), tr("and"))));
}

class VideoSession {
public:
    VideoSession(const QString& path, VideoSource source, ProgressBar& bar, const Interrupt& interrupt)
        : m_path(path), m_source(std::move(source)), m_bar(bar), m_interrupt(interrupt) {}

    ExitStatus run() {
        for (int index = 0; index < m_source.count; ++index)
            if (const auto problem = add(index)) return *problem;
        const auto progress = [this](double fraction) {
            m_bar.show(shareOfFrames + (1 - shareOfFrames) * fraction);
        };
        const io::Failure failure = m_writer->finish(progress, m_interrupt.token());
        if (!failure && m_interrupt.token().stop_requested()) return interrupted();
        m_bar.clear();
        return failure ? failed(*failure) : ExitStatus::Done;
    }

private:
    // Returns nullopt if the frame has been added.
    std::optional<ExitStatus> add(int index) {
        const auto progress = [this, index](double fraction) {
            m_bar.show(shareOfFrames * (index + fraction) / m_source.count);
        };
        const QImage frame = m_source.frame(index, progress);
        if (m_interrupt.token().stop_requested()) return interrupted();
        if (frame.isNull()) return ExitStatus::InputProblems;
        if (!m_writer) open(frame);
        if (const io::Failure failure = m_writer->writeFrame(frame)) return failed(*failure);
        return std::nullopt;
    }

    void open(const QImage& frame) {
        m_source.settings.width = frame.width();
        m_source.settings.height = frame.height();
        m_writer = std::make_unique<io::VideoWriter>(m_path, m_source.settings);
        if (m_writer->failure()) return;
        m_bar.clear();
        warnAboutFormat(m_path, m_source.settings);
    }

    ExitStatus failed(const QString& sentence) {
        m_bar.clear();
        reportError(m_path, sentence);
        return ExitStatus::CannotReadOrWrite;
    }

    ExitStatus interrupted() {
        m_bar.clear();
        reportError(QStringLiteral("barycage-cli"), tr("Interrupted; no video was written."));
        return m_interrupt.status();
    }

    QString m_path;
    VideoSource m_source;
    ProgressBar& m_bar;
    const Interrupt& m_interrupt;
    std::unique_ptr<io::VideoWriter> m_writer; // null until the size is known
};

} // namespace

ExitStatus writeVideo(const QString& path, VideoSource source, ProgressBar& bar, const Interrupt& interrupt) {
    return VideoSession(path, std::move(source), bar, interrupt).run();
}

} // namespace cli
