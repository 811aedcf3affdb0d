// SPDX-License-Identifier: MIT
#include "bench/frames_bench.h"

#include "attractor/render/renderer.h"
#include "bench/engine_cases.h"
#include "document/edits/timeline/motion_edits.h"
#include "document/fractal/fractal_geometry.h"
#include "document/moments/animated_fractal.h"
#include "io/animation/animation_export.h"
#include "io/sums/picture_sums.h"

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>

namespace frames_bench {

namespace {

constexpr QSize size(1920, 1080);
constexpr std::uint64_t points = 100ULL * 1920 * 1080; // of a frame
constexpr int lengthOfTarget = 240;
constexpr int tasks = 6;
constexpr int parts = 8;

double seconds(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double processorSeconds(const auto& work) {
    const std::clock_t begin = std::clock();
    work();
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

double shortest(int repetitions, const auto& measured) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < repetitions; ++i)
        least = std::min(least, measured());
    return least;
}

io::AnimationExport exportOf(const document::Fractal& entry, int first, int last) {
    io::AnimationExport what;
    what.entry = entry;
    what.size = size;
    what.points = points;
    what.first = first;
    what.last = last;
    return what;
}

bool isWritten(const io::AnimationExport& what, const QString& path) {
    const io::ExportOutcome outcome = io::exportAnimation(what, path);
    return !outcome.failure && !outcome.stopped;
}

// The same frames, drawn alone.
double drawing(const document::Fractal& entry, int frames) {
    return seconds([&] {
        for (int frame = 0; frame < frames; ++frame) {
            const document::AnimatedFrame shown = document::frameAt(entry, animation::moment(frame));
            auto request = document::renderRequest(
                shown.fractal, attractor::cameraOf(*shown.view, {size.width(), size.height()}));
            request.samples = points;
            request.threads = 2;
            attractor::render(request);
        }
    });
}

// A few frames stand for all: those of a short animation would measure its exposure as often as those of a
// long one. The shortest of three rounds, each of which draws and exports.
void addAnimate(std::vector<timing::Row>& rows, int frames) {
    const document::Fractal entry = windyMaple(std::max(frames, lengthOfTarget));
    const auto exporting = [&](std::optional<io::VideoFormat> format, const char* name) {
        const QTemporaryDir folder;
        io::AnimationExport what = exportOf(entry, 0, frames - 1);
        what.format = format;
        bool isDone = false;
        const double taken = seconds([&] { isDone = isWritten(what, folder.filePath(QLatin1String(name))); });
        return isDone ? taken : std::nan("");
    };
    constexpr double never = std::numeric_limits<double>::infinity();
    double alone = never, png = never, mp4 = never;
    for (int round = 0; round < (frames < lengthOfTarget ? 3 : 1); ++round) {
        alone = std::min(alone, drawing(entry, frames));
        png = std::min(png, exporting(std::nullopt, "a.png"));
        mp4 = std::min(mp4, exporting(io::VideoFormat::Mp4, "a.mp4"));
    }
    rows.push_back({"time.animate.vs_drawing.png", png / alone, "<= 1.15"});
    rows.push_back({"time.animate.vs_drawing.mp4", mp4 / alone, "<= 1.4"});
}

// Processor time of six tasks over that of one, for the same frames.
void addFarm(std::vector<timing::Row>& rows, int frames) {
    const int each = std::max(1, frames / tasks);
    const document::Fractal entry = windyMaple(each * tasks);
    bool isDone = true;
    const auto taken = [&](int share) {
        const QTemporaryDir folder;
        return processorSeconds([&] {
            for (int first = 0; first < each * tasks; first += share)
                isDone = isWritten(exportOf(entry, first, first + share - 1),
                                   folder.filePath(QStringLiteral("a.png"))) &&
                         isDone;
        });
    };
    const double one = taken(each * tasks), six = taken(each);
    rows.push_back({"time.farm.vs_one", isDone ? six / one : std::nan(""), "<= 1.1"});
}

QStringList writtenParts(const QTemporaryDir& folder, std::uint64_t samples) {
    io::PlaneExport picture;
    picture.fractal = windyMaple(1);
    document::plane(picture.fractal)->animation.reset();
    attractor::Camera camera;
    camera.width = size.width();
    camera.height = size.height();
    const auto box = document::displayedBox(picture.fractal);
    picture.request = document::renderRequest(picture.fractal, attractor::fitted(camera, box->min, box->max));
    picture.request.samples = samples;
    picture.request.threads = 2;
    QStringList paths;
    for (int i = 0; i < parts; ++i) {
        const QString path = folder.filePath(QStringLiteral("%1.sum").arg(i));
        const attractor::PicturePart part{std::uint64_t(i), std::uint64_t(parts)};
        if (!io::exportSums(io::partOf(picture, 0, camera.height, part), path).failure) paths << path;
    }
    return paths;
}

bool areRead(const QStringList& paths) {
    for (const QString& path : paths) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) return false;
        io::SumReader reader(file);
        for (const auto& [number, place] : reader.tiles())
            if (!reader.read(number)) return false;
        if (reader.failure()) return false;
    }
    return paths.size() == parts;
}

bool areMerged(const QStringList& paths, const QString& output) {
    const auto files = std::make_shared<io::SumFiles>(paths);
    if (files->failure()) return false;
    const io::LoadedSums loaded = io::sumsIn(files, 2);
    return !loaded.failure && !io::exportSums(loaded.sums, output).failure;
}

void addMerge(std::vector<timing::Row>& rows, int repetitions) {
    const QTemporaryDir folder;
    const QStringList paths = writtenParts(folder, points);
    bool isDone = true;
    const double reading =
        shortest(repetitions, [&] { return seconds([&] { isDone = areRead(paths) && isDone; }); });
    const double merging = shortest(repetitions, [&] {
        return seconds(
            [&] { isDone = areMerged(paths, folder.filePath(QStringLiteral("all.sum"))) && isDone; });
    });
    rows.push_back({"time.merge.vs_read", isDone ? merging / reading : std::nan(""), "<= 1.5"});
}

} // namespace

document::Fractal windyMaple(int length) {
    document::Fractal maple;
    maple.name = QStringLiteral("maple");
    maple.shape = document::Shape<2>{engine::cases()[2].request.system};
    document::Fractal entry = *document::withWind(maple, animation::swayPresets()[1]);
    const auto box = document::displayedBox(maple);
    const attractor::View view{(box->min + box->max) / 2, 1.2 * (box->max - box->min).y()};
    auto& animation = *document::plane(entry)->animation;
    animation.length = length;
    animation.camera = {{0, view, {}}};
    return entry;
}

std::vector<timing::Row> measure(int frames, int repetitions) {
    std::vector<timing::Row> rows;
    addAnimate(rows, frames);
    addFarm(rows, std::min(frames, 24));
    addMerge(rows, repetitions);
    return rows;
}

} // namespace frames_bench
