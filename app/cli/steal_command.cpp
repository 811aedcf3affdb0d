// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/files_read.h"
#include "process/input.h"
#include "process/interrupt.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/progress_bar.h"
#include "render/render_note.h"
#include "render/render_plane.h"
#include "render/render_view.h"
#include "steal_arguments.h"

#include "attractor/tops/picture_patterns.h"
#include "document/branches/addresses.h"
#include "document/edits/coupled_entries.h"
#include "document/tops/laid_picture.h"
#include "ifs/tops/fractal_transformation.h"
#include "ifs/tops/tear.h"
#include "io/file/named_path.h"
#include "io/file/standard_output.h"
#include "io/report/json_writer.h"
#include "io/text/number.h"
#include "io/tops/picture_reader.h"
#include "io/tops/steal_export.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cerrno>
#include <memory>

namespace cli {

namespace {

using Layout = io::JsonWriter::Layout;

// The two entries, and the files that they are in.
struct Sources {
    std::optional<Input> file, fromFile;
    const document::Entry* first = nullptr;
    const document::Entry* second = nullptr;
    document::KeptTheft theft;
    ExitStatus status = ExitStatus::Done;

    const Input& secondFile() const { return fromFile ? *fromFile : *file; }
};

const document::Entry* onlyEntry(const ToDraw& found, const std::string& name) {
    if (found.entries.size() > 1)
        throw UsageError{
            tr("--entry and --from each name one entry, not “%1”.").arg(QString::fromStdString(name))};
    return found.entries.empty() ? nullptr : found.entries.front();
}

Sources readSources(const StealArguments& arguments) {
    Sources sources;
    sources.file = readInput(arguments.file);
    const bool isOneFile = !arguments.fromFile || *arguments.fromFile == arguments.file ||
                           isSameFile(fileNameOf(*arguments.fromFile), fileNameOf(arguments.file));
    if (!isOneFile && sources.file) sources.fromFile = readInput(*arguments.fromFile);
    if (!sources.file || (!isOneFile && !sources.fromFile)) {
        sources.status = ExitStatus::CannotReadOrWrite;
        return sources;
    }
    const std::vector<std::string> names =
        arguments.entry ? std::vector{*arguments.entry} : std::vector<std::string>{};
    const ToDraw drawn = entriesToDraw(*sources.file, names);
    sources.status = drawn.status;
    sources.first = onlyEntry(drawn, arguments.entry.value_or(std::string()));
    if (sources.first == nullptr) return sources;
    sources.theft = theftOf(arguments, *sources.first->fractal);
    const std::string partner = sources.theft.partner.toStdString();
    const ToDraw painted = entriesToDraw(sources.secondFile(), {partner}, isOneFile ? &drawn : nullptr);
    sources.status = std::max(sources.status, painted.status);
    sources.second = onlyEntry(painted, partner);
    return sources;
}

QString sentence(const document::CouplingOutcome& outcome, const QString& name) {
    switch (outcome.flaw) {
    case document::CouplingFlaw::NotInPlane:
        return tr("“%1” is in space; colours can be stolen only between entries in the plane.").arg(name);
    case document::CouplingFlaw::BentCage:
        return tr("The cage of “%1” is flat or bends the picture; bake or reset it first.").arg(name);
    case document::CouplingFlaw::NoMaps:
        return tr("“%1” has no active map, so there is nothing to draw.").arg(name);
    case document::CouplingFlaw::Linked:
        return tr("The maps of “%1” are linked; colours can be stolen only between entries whose maps are "
                  "not.")
            .arg(name);
    case document::CouplingFlaw::NoAttractor:
        return tr("No attractor could be proved for “%1”, so its points have no addresses.").arg(name);
    case document::CouplingFlaw::Order:
        return tr("--order must list every active map of “%1” once.").arg(name);
    case document::CouplingFlaw::Counts:
        break;
    }
    return {};
}

QString sentenceOfKeptOrder(const QString& name) {
    return tr("The order stored in “%1” does not list every active map once. Give --order.").arg(name);
}

QString sentenceOfCounts(const document::CouplingOutcome& outcome, const Sources& sources) {
    return tr("“%1” and “%2” must have the same number of active maps; they have %3 and %4. Divide maps into "
              "several until they do.")
        .arg(printableLine(sources.first->fractal->name), printableLine(sources.second->fractal->name),
             QString::number(outcome.fromCount), QString::number(outcome.toCount));
}

void warnOfMovedBranches(const document::Entry& entry, const QString& fileName) {
    const auto* shape = document::plane(*entry.fractal);
    if (shape != nullptr && !shape->moved.empty())
        reportWarning(fileName, tr("The moved branches of “%1” are drawn in their original positions: a "
                                   "fractal transformation uses only the maps.")
                                    .arg(printableLine(entry.fractal->name)));
}

std::optional<document::CoupledEntries> coupledEntries(const Sources& sources,
                                                       const StealArguments& arguments) {
    document::CouplingOutcome outcome =
        document::coupled(*sources.first->fractal, *sources.second->fractal, sources.theft.order);
    if (outcome.entries) {
        warnOfMovedBranches(*sources.first, sources.file->name);
        if (sources.second != sources.first) warnOfMovedBranches(*sources.second, sources.secondFile().name);
        return std::move(outcome.entries);
    }
    const auto& entry = outcome.isOfSecond ? sources.second : sources.first;
    const QString& fileName = outcome.isOfSecond ? sources.secondFile().name : sources.file->name;
    if (outcome.flaw == document::CouplingFlaw::Order && arguments.order)
        throw UsageError{sentence(outcome, printableLine(entry->fractal->name))};
    const QString name = printableLine(entry->fractal->name);
    reportError(fileName, outcome.flaw == document::CouplingFlaw::Counts  ? sentenceOfCounts(outcome, sources)
                          : outcome.flaw == document::CouplingFlaw::Order ? sentenceOfKeptOrder(name)
                                                                          : sentence(outcome, name));
    return std::nullopt;
}

ExitStatus printed(const QByteArray& text, const QString& fileName, ExitStatus status) {
    if (print(text)) return status;
    reportError(fileName, io::cannotPrint(errno));
    return ExitStatus::CannotReadOrWrite;
}

void addPoint(io::JsonWriter& json, const ifs::Vector<2>& x) {
    json.beginArray(Layout::Inline);
    json.value(x.x());
    json.value(x.y());
    json.endArray();
}

QByteArray pointText(const ifs::Vector<2>& x) {
    return '(' + io::formatNumber(x.x()) + ", " + io::formatNumber(x.y()) + ')';
}

// T at points.
class PointTable {
public:
    PointTable(const document::CoupledEntries& entries, bool isJson, QString fileName)
        : m_transformation(entries.fromAttractor, entries.toAttractor.maps()),
          m_numbers(entries.numbers),
          m_isJson(isJson),
          m_fileName(std::move(fileName)) {}

    void add(const ifs::Vector<2>& x) {
        const auto answer = m_transformation.at(x);
        if (!answer.top || !answer.image) {
            m_status = ExitStatus::InputProblems;
            const QString point = QString::fromLatin1(pointText(x));
            reportError(
                m_fileName,
                answer.isCutShort
                    ? tr("The address of the point %1 could not be found in reasonable time.").arg(point)
                    : tr("The point %1 is not on the attractor.").arg(point));
        }
        const QString address = answer.top ? addressOf(*answer.top) : QString();
        m_text += m_isJson ? jsonLine(x, answer, address) : textLine(x, answer, address);
    }
    const QByteArray& text() const { return m_text; }
    ExitStatus status() const { return m_status; }

private:
    // Digits for at most nine maps, else numbers separated by spaces.
    QString addressOf(const ifs::TopAddress& top) const {
        constexpr std::size_t minSymbols = 40;
        const std::size_t known = top.word.size();
        ifs::Word word = ifs::symbols(top, top.period > 0 ? std::max(known, minSymbols) : known);
        for (int& symbol : word)
            symbol = int(m_numbers[std::size_t(symbol)]);
        QString text = document::addressText(word, word.size());
        if (*std::ranges::max_element(m_numbers) < 9) text.remove(u' ');
        return text;
    }

    static QByteArray jsonLine(const ifs::Vector<2>& x, const ifs::FractalTransformation::Answer& answer,
                               const QString& address) {
        io::JsonWriter json;
        json.beginObject(Layout::Inline);
        json.key("point");
        addPoint(json, x);
        json.key("address");
        answer.top ? json.value(address) : json.null();
        json.key("image");
        answer.image ? addPoint(json, *answer.image) : json.null();
        json.endObject();
        return json.text();
    }

    static QByteArray textLine(const ifs::Vector<2>& x, const ifs::FractalTransformation::Answer& answer,
                               const QString& address) {
        if (!answer.image) return pointText(x) + " -\n";
        return pointText(x) + " -> " + pointText(*answer.image) + "  address " + address.toUtf8() + '\n';
    }

    ifs::FractalTransformation m_transformation;
    std::vector<std::size_t> m_numbers;
    bool m_isJson;
    QString m_fileName;
    QByteArray m_text;
    ExitStatus m_status = ExitStatus::Done;
};

ExitStatus mapPoints(const document::CoupledEntries& entries, const StealArguments& arguments,
                     const QString& fileName) {
    PointTable table(entries, arguments.isJson, fileName);
    for (const ifs::Vector<2>& x : *arguments.map)
        table.add(x);
    return printed(table.text(), fileName, table.status());
}

QByteArray tearJson(const ifs::Tear& torn, ifs::Homeomorphism verdict) {
    io::JsonWriter json;
    json.beginObject(Layout::Inline);
    json.member("tear", torn.size);
    json.key("at");
    if (torn.place) {
        json.beginArray(Layout::Inline);
        for (const ifs::Vector<2>& x : *torn.place)
            addPoint(json, x);
        json.endArray();
    } else {
        json.null();
    }
    json.key("homeomorphism");
    verdict == ifs::Homeomorphism::Unknown ? json.null() : json.value(verdict == ifs::Homeomorphism::Proved);
    json.endObject();
    return json.text();
}

QByteArray tearText(const ifs::Tear& torn, ifs::Homeomorphism verdict) {
    QString place;
    if (torn.place)
        place = tr(", between %1 and %2")
                    .arg(QString::fromLatin1(pointText(torn.place->front())),
                         QString::fromLatin1(pointText(torn.place->back())));
    const QString proof = verdict == ifs::Homeomorphism::Proved    ? tr("yes (the tear vanishes as EPS does)")
                          : verdict == ifs::Homeomorphism::Refuted ? tr("no")
                                                                   : tr("not known");
    return tr("Tear: %1%2\nHomeomorphism: %3\n")
        .arg(QString::fromLatin1(io::formatNumber(torn.size)), place, proof)
        .toUtf8();
}

ExitStatus printTear(const document::CoupledEntries& entries, const StealArguments& arguments,
                     const QString& fileName) {
    const ifs::Tear torn = ifs::tear(entries.fromAttractor, entries.toAttractor, *arguments.tear);
    if (torn.isCutShort)
        reportWarning(fileName, tr("There are too many pieces of that size; the value printed is only an "
                                   "upper bound for the tear."));
    const ifs::Homeomorphism verdict = ifs::homeomorphism(entries.fromAttractor, entries.toAttractor);
    return printed(arguments.isJson ? tearJson(torn, verdict) : tearText(torn, verdict), fileName,
                   ExitStatus::Done);
}

InputError foreignPicture(const Sources& sources) {
    return {sources.file->name,
            tr("“%1” names the picture “%2”, which is not in the folder of the file. If you trust "
               "it, name it with --picture.")
                .arg(printableLine(sources.first->fractal->name), printableLine(sources.theft.picture))};
}

// Empty where a pattern is drawn, or a picture that is embedded. Of its own accord, a file names only
// pictures in its folder.
QString picturePath(const Sources& sources, const StealArguments& arguments) {
    if (arguments.picture) return fileNameOf(*arguments.picture);
    const QString& kept = sources.theft.picture;
    if (kept.isEmpty() || !sources.theft.embedded.isEmpty()) return {};
    const QDir folder = arguments.file == "-" ? QDir() : QFileInfo(fileNameOf(arguments.file)).dir();
    if (!io::liesInside(folder.path(), kept)) throw foreignPicture(sources);
    return QDir::cleanPath(folder.filePath(kept));
}

// Null when stopped.
std::shared_ptr<const attractor::MipPicture>
pictureOf(const Sources& sources, const StealArguments& arguments, const std::stop_token& stop) {
    const QString path = picturePath(sources, arguments);
    QByteArray bytes = sources.theft.embedded;
    if (path.isEmpty() && bytes.isEmpty())
        return std::make_shared<const attractor::MipPicture>(attractor::picture(sources.theft.pattern));
    if (!path.isEmpty()) {
        io::Loaded loaded = arguments.picture ? io::loadSource(path) : io::loadFile(path);
        if (loaded.failure) throw InputError{path, *loaded.failure, ExitStatus::CannotReadOrWrite};
        bytes = std::move(loaded.bytes);
    }
    io::ReadPicture read = io::decodePicture(bytes, stop);
    if (stop.stop_requested()) return nullptr;
    if (read.failure) throw InputError{path.isEmpty() ? sources.file->name : path, *read.failure};
    return std::make_shared<const attractor::MipPicture>(std::move(read.picture));
}

// The picture in its place on G.
std::optional<document::LaidPicture> laidPicture(const document::CoupledEntries& entries,
                                                 const Sources& sources, const StealArguments& arguments,
                                                 const std::stop_token& stop) {
    const auto picture = pictureOf(sources, arguments, stop);
    if (!picture) return std::nullopt;
    const document::KeptTheft& theft = sources.theft;
    const int width = picture->width(), height = picture->height();
    if (arguments.pictureView && theft.mode == document::TheftMode::StealColours)
        return document::LaidPicture{
            picture, attractor::worldToPixel(attractor::cameraOf(*arguments.pictureView, {width, height}))};
    if (!theft.view && theft.mode == document::TheftMode::StealColours) {
        document::Fractal to = entries.to;
        to.appearance.shadow = 0; // a shadow has no colours to steal
        const ViewBox box = boxOfAttractor(to);
        return document::LaidPicture{
            picture, attractor::worldToPixel(io::pictureCamera(width, height, box.min, box.max))};
    }
    attractor::DeferredTheft there(io::threadsOfThisMachine());
    return document::laid(entries, picture, theft.mode, theft.view, there, stop);
}

attractor::TheftRequest requestOf(const document::CoupledEntries& entries, const StealArguments& arguments,
                                  const QString& fileName) {
    const RenderArguments& shown = arguments.shown;
    attractor::TheftRequest request;
    request.camera = cameraOf(Shown{entries.from, entries.from}, shown, fileName);
    request.isExact = arguments.isExact;
    const auto pixels = std::uint64_t(request.camera.width) * std::uint64_t(request.camera.height);
    request.points = shown.points.value_or(
        std::clamp<std::uint64_t>(100 * pixels, 1'000'000, attractor::KeyTops::maxPoints));
    request.seed = shown.seed;
    request.threads = threadsOf(shown.threads);
    request.background = shown.background.value_or(entries.from.appearance.background);
    return request;
}

ExitStatus stealPicture(const document::CoupledEntries& entries, const StealArguments& arguments,
                        const Sources& sources) {
    const ProgressMode mode = applied(arguments.shown.verbosity);
    const Interrupt interrupt;
    const QString& fileName = sources.file->name;
    const QString output = fileNameOf(*arguments.output);
    const QString picture = picturePath(sources, arguments);
    if (!picture.isEmpty()) noteRead(picture);
    refuseToReplaceInput(output);
    const auto laid = laidPicture(entries, sources, arguments, interrupt.token());
    if (!laid) return interrupt.status();
    attractor::TheftRequest request = requestOf(entries, arguments, fileName);
    request.toPicture = laid->toPicture;
    const io::StealExport what{*sources.first->fractal, entries.system(), *laid->picture, request};
    ProgressBar bar(mode);
    const io::ExportOutcome outcome = io::exportStolen(
        what, isStandardOutput(output) ? io::standardOutputPath() : output,
        [&](double fraction) { bar.show(fraction); }, interrupt.token());
    bar.clear();
    if (outcome.stopped) return interrupt.status();
    if (outcome.failure) {
        reportError(output, *outcome.failure);
        return ExitStatus::CannotReadOrWrite;
    }
    reportNote(outcome.note, false, fileName);
    return ExitStatus::Done;
}

ExitStatus steal(const StealArguments& arguments) {
    applied(arguments.shown.verbosity);
    const StealTask task = checked(arguments);
    const Sources sources = readSources(arguments);
    if (!sources.file || sources.status == ExitStatus::CannotReadOrWrite) return sources.status;
    if (sources.first == nullptr || sources.second == nullptr) return ExitStatus::InputProblems;
    const auto entries = coupledEntries(sources, arguments);
    if (!entries) return ExitStatus::InputProblems;
    const QString& fileName = sources.file->name;
    const ExitStatus status = task == StealTask::Map    ? mapPoints(*entries, arguments, fileName)
                              : task == StealTask::Tear ? printTear(*entries, arguments, fileName)
                                                        : stealPicture(*entries, arguments, sources);
    return std::max(sources.status, status);
}

} // namespace

Command stealCommand() {
    auto arguments = std::make_shared<StealArguments>();
    Command command("steal", "Paint an entry with the colours of a picture on another entry",
                    "steal FILE --entry F [--from G --picture PICTURE] -o OUT.png [OPTION]...");
    command.more = "Every point of the attractor of one entry has the colour of the point of another "
                   "with the same address, on which the picture lies; if a point has several addresses, "
                   "the one on top counts. Both entries must have the same number of active maps; the "
                   "k-th of one corresponds to the k-th of the other. Cages are applied; moved branches "
                   "are not. The picture shows the second entry as render would show it in a picture of "
                   "its size: its certified bounding box, with its proportions and a margin of at least "
                   "5 % on each side.";
    addStealOptions(command, *arguments);
    command.run = [arguments] { return steal(*arguments); };
    return command;
}

} // namespace cli
