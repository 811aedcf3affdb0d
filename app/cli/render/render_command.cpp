// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/memory_limit.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/output_names.h"
#include "process/progress_bar.h"
#include "render/picture_parts.h"
#include "render/render_arguments.h"
#include "render/render_note.h"
#include "render/render_plane.h"
#include "render/render_space.h"
#include "render/shown_frame.h"

#include "attractor/colour/palette_library.h"
#include "document/fractal/fractal_geometry.h"
#include "io/export_job.h"

#include <QDir>
#include <QFileInfo>
#include <QHash>

#include <cmath>
#include <limits>
#include <list>
#include <memory>

namespace cli {

namespace {

void checkDepth(const document::Fractal& fractal, const attractor::Camera& camera,
                const RenderArguments& arguments) {
    if (!arguments.depth) return;
    const io::SvgPlan plan = io::svgPlan(fractal, camera, shapesOf(arguments));
    if (!plan.failure && plan.depth != shapesOf(arguments).depth)
        throw UsageError{
            tr("--depth %1 would need 400,000 references or more; the deepest possible here is %2.")
                .arg(*arguments.depth)
                .arg(plan.deepest)};
}

io::Export exportOf(const Shown& shown, const attractor::Camera& camera, Format format,
                    const RenderArguments& arguments, const Steps& steps) {
    if (arguments.overlay.hull && !document::supportFunction(shown.fractal))
        throw UsageError{
            document::linkedExtent(shown.fractal)
                ? tr("--overlay hull cannot be used here: the maps are linked.")
                : tr("--overlay hull cannot be used here: the system has no certified attractor.")};
    if (isOfShapes(format)) {
        checkDepth(shown.fractal, camera, arguments);
        const auto file = format == Format::Pdf ? io::ShapeFile::Pdf : io::ShapeFile::Svg;
        return io::SvgExport{shown.fractal, camera, shapesOf(arguments), file};
    }
    io::PlaneExport picture = planeExportOf(shown, camera, arguments, steps.first);
    if (const io::Failure reason = io::whyImpossible(picture)) throw UsageError{*reason};
    if (steps.first == steps.last) return picture;
    if (camera.width > maxSide / (steps.last - steps.first + 1))
        throw UsageError{
            tr("The strip would be wider than %1 pixels. Use a smaller --size, or write each step to a "
               "file of its own with %i in the name of the output.")
                .arg(maxSide)};
    io::PictureStrip strip;
    for (int n = steps.first; n <= steps.last; ++n) {
        picture.request.iterations = n;
        strip.push_back(picture);
    }
    return strip;
}

// A picture in one file.
struct Task {
    const Input* input;
    const document::Entry* entry;
    Steps steps;
    QString output;
};

bool hasSeveral(const std::vector<Task>& tasks, const Task& task) {
    return std::ranges::any_of(tasks, [&](const Task& other) {
        return &other != &task && (other.input != task.input || other.entry != task.entry);
    });
}

QString identity(const Task& task) {
    return tr("“%1” of %2").arg(printableLine(task.entry->fractal->name), task.input->name);
}

// Refuses to write a file twice.
void refuseCollisions(const std::vector<Task>& tasks, const QString& pattern) {
    QHash<QString, const Task*> taken;
    for (const Task& task : tasks) {
        const QString key = QDir::cleanPath(task.output).toLower();
        if (const Task* other = taken.value(key)) {
            if (!hasPlaceholders(pattern) && hasSeveral(tasks, task))
                throw UsageError{
                    tr("There is more than one picture to write: put %e (the name of the entry), %n (its "
                       "number) or %f (the name of its file) into the name of the output, such as "
                       "-o '%e.png'.")};
            throw UsageError{
                tr("%1 and %2 would both be written to “%3”; tell them apart with %n (the number of the "
                   "entry) or %f (the name of its file).")
                    .arg(identity(*other), identity(task), task.output)};
        }
        taken.insert(key, &task);
    }
}

std::vector<Task> tasksFor(const Input& input, const document::Entry* entry,
                           const RenderArguments& arguments) {
    const QString pattern = fileNameOf(arguments.output);
    const auto& entries = input.collection.file.entries;
    OutputName name{
        entry->fractal->name,  int(entry - entries.data()) + 1, int(entries.size()), input.name, {},
        arguments.steps().last};
    if (isStandardOutput(pattern)) return {{&input, entry, arguments.steps(), pattern}};
    if (!hasIterations(pattern) || !arguments.iterations)
        return {{&input, entry, arguments.steps(), outputFor(pattern, name)}};
    std::vector<Task> tasks;
    for (int n = arguments.steps().first; n <= arguments.steps().last; ++n) {
        name.iterations = n;
        tasks.push_back({&input, entry, {n, n}, outputFor(pattern, name)});
    }
    return tasks;
}

class Session {
public:
    Session(const RenderArguments& arguments, Format format, ProgressMode mode)
        : m_arguments(arguments), m_format(format), m_interrupt(arguments.timeLimit), m_bar(mode) {}

    ExitStatus run() {
        std::list<Input> inputs;
        std::vector<Task> tasks;
        for (const std::string& file : m_arguments.files) {
            auto input = readInput(file);
            if (!input) {
                m_status = ExitStatus::CannotReadOrWrite;
                continue;
            }
            inputs.push_back(*std::move(input));
            const ToDraw toDraw = entriesToDraw(inputs.back(), m_arguments.entries);
            m_status = std::max(m_status, toDraw.status);
            for (const document::Entry* entry : toDraw.entries)
                if (hasMaps(*entry->fractal, inputs.back().name))
                    std::ranges::copy(tasksFor(inputs.back(), entry, m_arguments), std::back_inserter(tasks));
                else
                    m_status = std::max(m_status, ExitStatus::InputProblems);
        }
        refuseCollisions(tasks, fileNameOf(m_arguments.output));
        for (const Task& task : tasks)
            refuseToReplaceInput(task.output);
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            const ExitStatus done = draw(tasks[i], double(i), double(tasks.size()));
            m_bar.clear();
            m_status = std::max(m_status, done);
            if (m_interrupt.token().stop_requested() && done == m_interrupt.status()) {
                m_interrupt.isOutOfTime() ? sayLate(i, tasks.size()) : sayInterrupted(i, tasks.size());
                return done;
            }
        }
        return m_status;
    }

private:
    static void sayInterrupted(std::size_t written, std::size_t all) {
        reportError(QStringLiteral("barycage-cli"),
                    written == 0 ? tr("Interrupted; nothing was written.")
                                 : tr("Interrupted; pictures written: %1 of %2.").arg(written).arg(all));
    }

    static void sayLate(std::size_t written, std::size_t all) {
        reportError(QStringLiteral("barycage-cli"),
                    written == 0
                        ? tr("The time limit has passed; nothing was written.")
                        : tr("The time limit has passed; pictures written: %1 of %2.").arg(written).arg(all));
    }

    ExitStatus draw(const Task& task, double before, double all) {
        const QString& name = task.input->name;
        const document::Fractal& entry = *task.entry->fractal;
        if (m_arguments.frame && !document::animationFacts(entry))
            reportWarning(name, tr("“%1” has no animation: it is drawn as it is in every frame.")
                                    .arg(printableLine(entry.name)));
        settlePaperSize(m_arguments, isOfShapes(m_format) && document::plane(entry));
        if (document::space(entry)) return drawInSpace(task, before, all);
        refuseSpaceOptions(m_arguments);
        if (isOfShapes(m_format)) checkShapes(m_arguments);
        Shown shown = shownBy(entry, m_arguments);
        applyCage(shown.fractal, m_arguments);
        if (m_arguments.cage || m_arguments.restCage) shown.box.reset();
        if (!m_arguments.frame) shown.entry = shown.fractal;
        const attractor::Camera camera = cameraOf(shown, m_arguments, name);
        const io::Export what = exportOf(shown, camera, m_format, m_arguments, task.steps);
        if (const auto* svg = std::get_if<io::SvgExport>(&what); svg && !isPossible(*svg, name))
            return ExitStatus::InputProblems;
        if (m_format == Format::Sum) return drawSums(std::get<io::PlaneExport>(what), task, before, all);
        if (m_arguments.dryRun) return ExitStatus::Done;
        const auto outcome = exportOutput(
            what, task.output, [&](double fraction) { m_bar.show((before + fraction) / all); },
            m_interrupt.token());
        return finish(outcome, task);
    }

    template <class Picture>
    ExitStatus drawSums(const Picture& picture, const Task& task, double before, double all) {
        const auto part = partOfPicture(picture, m_arguments);
        if (m_arguments.dryRun) return ExitStatus::Done;
        const auto outcome = io::exportSums(
            part, task.output, [&](double fraction) { m_bar.show((before + fraction) / all); },
            m_interrupt.token());
        return finish(outcome, task);
    }

    ExitStatus drawInSpace(const Task& task, double before, double all) {
        const io::SpaceExport picture =
            spaceExportOf(shownBy(*task.entry->fractal, m_arguments), m_arguments, task.input->name);
        if (m_format == Format::Sum) return drawSums(picture, task, before, all);
        if (picture.page)
            reportWarning(task.input->name, tr("A solid has no shapes: the file contains its picture in "
                                               "pixels."));
        if (m_arguments.dryRun) return ExitStatus::Done;
        const auto outcome = exportOutput(
            picture, task.output, [&](double fraction) { m_bar.show((before + fraction) / all); },
            m_interrupt.token());
        return finish(outcome, task);
    }

    ExitStatus finish(const io::ExportOutcome& outcome, const Task& task) {
        m_bar.clear();
        if (outcome.stopped) return m_interrupt.status();
        if (outcome.failure) {
            reportError(task.output, *outcome.failure);
            return ExitStatus::CannotReadOrWrite;
        }
        reportNote(outcome.note, document::space(*task.entry->fractal) != nullptr, task.input->name);
        if (outcome.isCoarse)
            reportWarning(task.input->name, tr("So many pieces overlap that parts of the solid may be "
                                               "missing. --look cloud shows all of it."));
        return ExitStatus::Done;
    }

    static bool isPossible(const io::SvgExport& svg, const QString& fileName) {
        const io::SvgPlan plan = io::svgPlan(svg.fractal, svg.camera, svg.format);
        if (plan.failure) {
            reportError(fileName, *plan.failure);
            return false;
        }
        if (plan.unbent)
            reportWarning(fileName,
                          tr("The cage bends the picture, which the copies in vector graphics cannot "
                             "reproduce: the affine fit of the cage is written instead."));
        return true;
    }

    RenderArguments m_arguments;
    Format m_format;
    Interrupt m_interrupt;
    ProgressBar m_bar;
    ExitStatus m_status = ExitStatus::Done;
};

ExitStatus listPalettes() {
    QByteArray names;
    for (const auto& palette : attractor::builtInPalettes())
        names += QByteArray::fromStdString(palette.name) + '\n';
    for (const auto& entry : attractor::paletteLibrary())
        names += QByteArray::fromStdString(entry.palette.name) + '\n';
    return writeOutput(QStringLiteral("-"), names);
}

ExitStatus render(const RenderArguments& arguments) {
    if (arguments.listPalettes) return listPalettes();
    const ProgressMode mode = applied(arguments.verbosity);
    const Format format = checked(arguments);
    checkParts(arguments, format);
    if (arguments.memoryLimit) limitMemory(*arguments.memoryLimit);
    if (arguments.resume) return resumePicture(arguments);
    return Session(arguments, format, mode).run();
}

} // namespace

Command renderCommand() {
    auto arguments = std::make_shared<RenderArguments>();
    Command command("render", "Draw an entry as PNG, SVG or PDF", "render FILE... -o OUT [OPTION]...");
    addRenderOptions(command, *arguments);
    command.run = [arguments] { return render(*arguments); };
    return command;
}

} // namespace cli
