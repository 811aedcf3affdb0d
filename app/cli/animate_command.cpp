// SPDX-License-Identifier: MIT
#include "animate_arguments.h"
#include "commands.h"
#include "frame_request.h"
#include "input.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "render_note.h"
#include "render_plane.h"
#include "render_space.h"
#include "shown_frame.h"
#include "usage_error.h"

#include "io/export_job.h"
#include "io/picture/png_check.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <memory>

namespace cli {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("cli", text);
}

QString momentText(const animation::Moment& moment) {
    return moment.denominator == 1 ? QString::number(moment.numerator)
                                   : QString::number(double(moment.numerator) / double(moment.denominator));
}

bool isAnimated(const document::Entry& entry) {
    return document::animationFacts(*entry.fractal).has_value();
}

// The entry that is named, or the first one with an animation; nullptr after a message.
const document::Entry* entryOf(const Input& input, const std::vector<std::string>& names,
                               ExitStatus& status) {
    if (names.empty()) {
        const auto& entries = input.collection.file.entries;
        if (const auto found = std::ranges::find_if(entries, isAnimated); found != entries.end()) {
            status = std::max(status, reportAll(input.collection.file.problems, input.name));
            status = std::max(status, reportAll(found->problems, input.name));
            return &*found;
        }
    }
    const ToDraw toDraw = entriesToDraw(input, names);
    status = std::max(status, toDraw.status);
    if (toDraw.entries.empty()) return nullptr;
    const document::Entry& entry = *toDraw.entries.front();
    if (isAnimated(entry)) return hasMaps(*entry.fractal, input.name) ? &entry : nullptr;
    reportError(input.name, tr("“%1” has no animation.").arg(printableLine(entry.fractal->name)));
    return nullptr;
}

class FrameSession {
public:
    FrameSession(const AnimateArguments& arguments, const Input& input, const document::Fractal& fractal,
                 ProgressMode mode)
        : m_arguments(arguments),
          m_input(input),
          m_fractal(fractal),
          m_facts(*document::animationFacts(fractal)),
          m_pattern(fileNameOf(arguments.picture.output)),
          m_bar(mode) {}

    ExitStatus run() {
        if (document::plane(m_fractal)) refuseSpaceOptions(m_arguments.picture);
        const std::vector<int> files = ours();
        if (m_arguments.whatExists == Existing::Fail && isAnyThere(files))
            return ExitStatus::CannotReadOrWrite;
        warnAboutAttractor();
        for (std::size_t i = 0; i < files.size(); ++i) {
            m_before = double(i) / double(files.size());
            m_share = 1.0 / double(files.size());
            const ExitStatus done = write(files[i]);
            m_status = std::max(m_status, done);
            if (m_interrupt.token().stop_requested() && done == m_interrupt.status()) {
                m_bar.clear();
                reportError(QStringLiteral("barycage-cli"),
                            tr("Interrupted; %1 of %2 frames are complete.").arg(i).arg(files.size()));
                return done;
            }
            if (done == ExitStatus::CannotReadOrWrite) return done;
        }
        m_bar.clear();
        return m_status;
    }

private:
    // Those of the list that belong to this chunk.
    std::vector<int> ours() const {
        const int count = animation::frameCount(m_facts.loop, m_facts.length);
        if (isAnyBeyond(m_arguments.ranges, count))
            reportWarning(m_input.name, tr("The animation of “%1” has %2 frames; those of --frames after the "
                                           "last one are left out.")
                                            .arg(printableLine(m_fractal.name))
                                            .arg(count));
        const std::vector<int> all = filesIn(m_arguments.ranges, count);
        std::vector<int> files;
        for (auto i = std::size_t(m_arguments.part.i); i < all.size(); i += std::size_t(m_arguments.part.n))
            files.push_back(all[i]);
        return files;
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

    void warnAboutAttractor() const {
        const auto lost = document::firstWithoutAttractor(m_fractal);
        if (!lost) return;
        reportWarning(m_input.name,
                      (lost->verdict == ifs::Verdict::Undecided
                           ? tr("At frame %1 of “%2” it could not be decided whether there is an attractor.")
                           : tr("At frame %1 of “%2” there is no attractor."))
                          .arg(momentText(lost->moment), printableLine(m_fractal.name)));
    }

    ExitStatus write(int number) {
        const QString path = numbered(m_pattern, number);
        const int frame = number - 1;
        const QByteArray hash = requestHash(m_fractal, frame, m_arguments.picture);
        if (m_arguments.whatExists == Existing::Skip && io::textOfCompletePng(path, requestKeyword) == hash)
            return ExitStatus::Done;
        if (!m_frames) m_frames = std::make_unique<Frames>(m_fractal, m_arguments.picture);
        const Shown shown = m_frames->at(animation::moment(frame));
        const io::ExportOutcome outcome =
            document::plane(m_fractal) ? drawInPlane(shown, path, hash) : drawInSpace(shown, path, hash);
        if (outcome.stopped) return m_interrupt.status();
        if (outcome.failure) {
            m_bar.clear();
            reportError(path, *outcome.failure);
            return ExitStatus::CannotReadOrWrite;
        }
        if (outcome.note != attractor::RenderNote::None) {
            m_bar.clear();
            reportNote(outcome.note, path);
        }
        return ExitStatus::Done;
    }

    io::Progress progress() {
        return [this](double fraction) { m_bar.show(m_before + m_share * fraction); };
    }

    io::ExportOutcome drawInPlane(const Shown& shown, const QString& path, const QByteArray& hash) {
        io::PngExport picture =
            pngOf(shown, cameraOf(shown, m_arguments.picture, path), m_arguments.picture, 0);
        picture.fractal = m_fractal;
        picture.texts = {{requestKeyword, hash}};
        return io::exportTo(picture, path, progress(), m_interrupt.token());
    }

    io::ExportOutcome drawInSpace(const Shown& shown, const QString& path, const QByteArray& hash) {
        io::SpaceExport picture = spaceExportOf(shown, m_arguments.picture, path);
        picture.fractal = m_fractal;
        picture.texts = {{requestKeyword, hash}};
        QByteArray png;
        io::ExportOutcome outcome = io::drawSpacePng(picture, png, progress(), m_interrupt.token());
        if (!outcome.failure && !outcome.stopped) outcome.failure = io::saveFile(path, png);
        return outcome;
    }

    const AnimateArguments& m_arguments;
    const Input& m_input;
    const document::Fractal& m_fractal;
    document::AnimationFacts m_facts;
    QString m_pattern;
    Interrupt m_interrupt;
    ProgressBar m_bar;
    double m_before = 0, m_share = 1; // of the progress: before this frame, and for it
    std::unique_ptr<Frames> m_frames; // once one has to be drawn
    ExitStatus m_status = ExitStatus::Done;
};

ExitStatus animate(AnimateArguments arguments) {
    const ProgressMode mode = applied(arguments.picture.verbosity);
    check(arguments);
    const auto input = readInput(arguments.file);
    if (!input) return ExitStatus::CannotReadOrWrite;
    ExitStatus status = ExitStatus::Done;
    const document::Entry* entry = entryOf(*input, arguments.picture.entries, status);
    if (entry == nullptr) return ExitStatus::InputProblems;
    return std::max(status, FrameSession(arguments, *input, *entry->fractal, mode).run());
}

} // namespace

Command animateCommand(CLI::App& program) {
    auto arguments = std::make_shared<AnimateArguments>();
    CLI::App* command = program.add_subcommand("animate", "Draw the frames of an animation as PNG pictures");
    command->footer("animate FILE -o NAME.####.png [OPTION]...");
    addAnimateOptions(*command, *arguments);
    return {command, [arguments] { return animate(*arguments); }};
}

} // namespace cli
