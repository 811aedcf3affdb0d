// SPDX-License-Identifier: MIT
#include "animate/animate_arguments.h"
#include "animate/animate_video.h"
#include "animate/animated_entry.h"
#include "animate/frame_notes.h"
#include "animate/frame_request.h"
#include "animate/frame_source.h"
#include "options/commands.h"
#include "options/tr.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/progress_bar.h"
#include "render/render_space.h"

#include "io/picture/png/png_check.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <memory>

namespace cli {

namespace {

class FrameSession {
public:
    FrameSession(const AnimateArguments& arguments, const Input& input, const document::Fractal& fractal,
                 ProgressMode mode)
        : m_arguments(arguments),
          m_input(input),
          m_fractal(fractal),
          m_pattern(fileNameOf(arguments.picture.output)),
          m_bar(mode),
          m_animationHash(requestHash(fractal, std::nullopt, arguments.picture)) {}

    ExitStatus run() {
        const std::vector<int> files = filesOf(m_arguments, m_input, m_fractal);
        for (const int number : files)
            refuseToReplaceInput(numbered(m_pattern, number));
        if (m_arguments.whatExists == Existing::Fail && isAnyThere(files))
            return ExitStatus::CannotReadOrWrite;
        std::vector<int> frames = files; // 0-based
        for (int& frame : frames)
            --frame;
        FrameNotes notes(m_input, m_fractal, frames);
        const ExitStatus status = write(files, notes);
        m_bar.clear();
        notes.report(m_pattern);
        warnOfReplaced();
        return status;
    }

private:
    void warnOfReplaced() const {
        if (m_replaced.empty()) return;
        const QString sentence =
            m_replaced.size() > 1
                ? tr("%1 existing files that were not pictures of this request were replaced: the numbers "
                     "%2.")
                : tr("%1 existing file that was not a picture of this request was replaced: number %2.");
        reportWarning(m_pattern, sentence.arg(m_replaced.size()).arg(rangesText(m_replaced)));
    }

    bool isAnyThere(const std::vector<int>& files) const {
        for (const int number : files) {
            const QString path = numbered(m_pattern, number);
            if (!QFileInfo::exists(path)) continue;
            reportError(path, tr("The file exists already; nothing was drawn."));
            return true;
        }
        return false;
    }

    ExitStatus write(const std::vector<int>& files, FrameNotes& notes) {
        QDir().mkpath(QFileInfo(m_pattern).path()); // if that fails, no file can be written either
        for (std::size_t i = 0; i < files.size(); ++i) {
            m_before = double(i) / double(files.size());
            m_share = 1.0 / double(files.size());
            const ExitStatus done = write(files[i], notes);
            if (m_interrupt.token().stop_requested() && done == m_interrupt.status()) {
                if (const io::Failure failure = m_drawing->finish()) return failed(*failure);
                m_bar.clear();
                reportError(QStringLiteral("barycage-cli"),
                            tr("Interrupted; frames written: %1 of %2.").arg(i).arg(files.size()));
            }
            if (done != ExitStatus::Done) return done;
        }
        const io::Failure failure = m_drawing ? m_drawing->finish() : std::nullopt;
        return failure ? failed(*failure) : ExitStatus::Done;
    }

    ExitStatus failed(const QString& reason) {
        m_bar.clear();
        reportError(m_drawing->failedPath(), reason);
        return ExitStatus::CannotReadOrWrite;
    }

    ExitStatus write(int number, FrameNotes& notes) {
        const QString path = numbered(m_pattern, number);
        const int frame = number - 1;
        const QByteArray hash = requestHash(m_fractal, frame, m_arguments.picture);
        if (m_arguments.whatExists == Existing::Skip &&
            io::textOfCompletePng(path, io::frameRequestKeyword) == hash)
            return ExitStatus::Done;
        const bool isReplaced = m_arguments.whatExists == Existing::Skip && QFileInfo::exists(path);
        if (!m_drawing)
            m_drawing = std::make_unique<io::FrameDrawing>(
                std::make_unique<FrameSource>(m_fractal, m_arguments.picture, m_input.name,
                                              FrameSource::Output::Pictures),
                frameOptions(m_arguments.picture));
        const auto progress = [this](double fraction) { m_bar.show(m_before + m_share * fraction); };
        const io::ExportOutcome outcome =
            m_drawing->writePng(frame, path, {hash, m_animationHash}, progress, m_interrupt.token());
        if (outcome.stopped) return m_interrupt.status();
        if (outcome.failure) return failed(*outcome.failure);
        notes.add(frame, outcome.note);
        if (isReplaced) m_replaced.push_back(number);
        return ExitStatus::Done;
    }

    const AnimateArguments& m_arguments;
    const Input& m_input;
    const document::Fractal& m_fractal;
    QString m_pattern;
    Interrupt m_interrupt;
    ProgressBar m_bar;
    double m_before = 0, m_share = 1; // progress before this frame, and its share
    std::vector<int> m_replaced;      // numbers of files that had other contents
    QByteArray m_animationHash;
    std::unique_ptr<io::FrameDrawing> m_drawing; // null until a frame has to be drawn
};

ExitStatus animate(AnimateArguments arguments) {
    const ProgressMode mode = applied(arguments.picture.verbosity);
    check(arguments);
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    ExitStatus status = ExitStatus::Done;
    const document::Entry* entry = animatedEntry(*input, arguments.picture.entries, status);
    if (entry == nullptr) return ExitStatus::InputProblems;
    const document::Fractal& fractal = *entry->fractal;
    if (document::plane(fractal)) refuseSpaceOptions(arguments.picture);
    return std::max(status, arguments.video ? animateVideo(arguments, *input, fractal, mode)
                                            : FrameSession(arguments, *input, fractal, mode).run());
}

} // namespace

Command animateCommand() {
    auto arguments = std::make_shared<AnimateArguments>();
    Command command("animate", "Draw the frames of an animation as pictures or as a video",
                    "animate FILE -o OUT [OPTION]...");
    command.more = "Files count from 1: file K shows frame K - 1. Without a loop, the frames 0 to L are "
                   "drawn; in a cycle 0 to L - 1, because frame L is frame 0 again; there and back 2L of "
                   "them. The bytes of a file depend only on the entry, its frame and the options. A "
                   "file is written completely or not at all and contains a hash of all of these, so the "
                   "same command finishes interrupted work, and any number of machines can share it.";
    addAnimateOptions(command, *arguments);
    command.run = [arguments] { return animate(*arguments); };
    return command;
}

} // namespace cli
