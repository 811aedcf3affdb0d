// SPDX-License-Identifier: MIT
// Prints the noise of the systems of the collection in the plane, or of those named: docs/testing.md,
// "Noise". barycage_noise [ENTRY...]
#include "attractor/noise.h"
#include "golden/collection.h"

#include <QGuiApplication>

#include <cstdio>

namespace {

void printNoise(const QStringList& names) {
    std::printf("%-28s %8s   %6s %6s %6s   %6s %6s %6s\n", "system", "samples", "pixels", "mean", "worst",
                "tiles", "mean", "worst");
    for (const golden::Theme& theme : golden::collection())
        for (const document::Entry& entry : theme.file.entries) {
            if (document::plane(*entry.fractal) == nullptr) continue;
            if (!names.isEmpty() && !names.contains(entry.fractal->name)) continue;
            for (const std::uint64_t samples : {1'000'000, 10'000'000}) {
                attractor::RenderRequest request = golden::tileRequest(*entry.fractal);
                const int side = request.camera.width;
                request.camera.width = 1920;
                request.camera.height = 1080;
                request.camera.pixelsPerUnit *= 1080.0 / side;
                request.appearance = {};
                request.samples = samples;
                const auto [pixels, tiles] = noise::measured(request);
                std::printf("%-28s %8g   %6.2f %6.2f %6.2f   %6.2f %6.2f %6.2f\n",
                            qUtf8Printable(entry.fractal->name), static_cast<double>(samples), pixels.median,
                            pixels.mean, pixels.worst, tiles.median, tiles.mean, tiles.worst);
                std::fflush(stdout);
            }
        }
}

} // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    printNoise(QGuiApplication::arguments().mid(1));
    return 0;
}
