// SPDX-License-Identifier: MIT
#include "animate/animate_video.h"

#include "animate/animated_entry.h"
#include "animate/frame_notes.h"
#include "animate/frame_source.h"
#include "animate/video_output.h"
#include "options/tr.h"
#include "process/files_read.h"
#include "process/interrupt.h"
#include "process/messages.h"

#include "io/fractint/entry_writer.h"

#include <QFileInfo>

#include <memory>

namespace cli {

namespace {

ExitStatus refused(const QString& path, const QString& sentence) {
    reportError(path, sentence);
    return ExitStatus::CannotReadOrWrite;
}

} // namespace

ExitStatus animateVideo(const AnimateArguments& arguments, const Input& input, const document::Fractal& entry,
                        ProgressMode mode) {
    const QString path = fileNameOf(arguments.picture.output);
    const document::AnimationFacts facts = *document::animationFacts(entry);
    VideoSource source;
    source.settings.format = *arguments.video;
    source.settings.rate = arguments.framesPerSecond.value_or(facts.rate);
    source.settings.repeats = facts.loop != animation::Loop::Off;
    source.settings.systemText = io::writeEntry(entry);
    source.settings.title = entry.name;
    if (const io::Failure obstacle = io::videoObstacle(source.settings)) return refused(path, *obstacle);
    const std::vector<int> files = filesOf(arguments, input, entry);
    if (files.empty()) {
        reportError(input.name, tr("--frames names no frame of the animation; no video was written."));
        return ExitStatus::InputProblems;
    }
    refuseToReplaceInput(path);
    if (arguments.whatExists == Existing::Fail && QFileInfo::exists(path))
        return refused(path, tr("The file exists already; nothing was drawn."));
    const Interrupt interrupt;
    ProgressBar bar(mode);
    io::FrameDrawing drawing(
        std::make_unique<FrameSource>(entry, arguments.picture, input.name, FrameSource::Output::Video),
        frameOptions(arguments.picture));
    std::vector<int> frames = files; // 0-based
    for (int& frame : frames)
        --frame;
    FrameNotes notes(input, entry, frames);
    source.count = int(frames.size());
    source.settings.isTransparent = drawing.isTransparent(frames);
    source.frame = [&](int index, const io::VideoWriter::Progress& progress) {
        const int frame = frames[std::size_t(index)];
        io::Picture picture = drawing.draw(frame, progress, interrupt.token());
        notes.add(frame, picture.note);
        return picture.image;
    };
    const ExitStatus status = writeVideo(path, std::move(source), bar, interrupt);
    if (status == ExitStatus::Done) notes.report(path);
    return status;
}

} // namespace cli
