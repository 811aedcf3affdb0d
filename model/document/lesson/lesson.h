// SPDX-License-Identifier: MIT
#pragma once

#include "animation/keys/moment.h"
#include "attractor/request/appearance.h"
#include "attractor/request/orbit_camera.h"
#include "document/analysis/space_outlines.h"
#include "ifs/system/affine_map.h"

#include <QList>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <set>
#include <variant>
#include <vector>

// A lesson: text steps, with the state of the window at each. A plain value; docs/formats.md, "Lessons".
namespace document {

constexpr int maxLessonSteps = 500;
constexpr int maxLessonTitle = 200;  // characters; also for a step
constexpr int maxLessonText = 4'000; // characters of a step
constexpr std::uint64_t maxLessonPoints = 10'000'000;
constexpr int maxLessonIterations = 30;
constexpr int maxLessonCylinders = 12; // letters of an address
constexpr std::size_t maxLessonCorners = 64;

enum class LessonTool { Cage, Maps, Branch };

// A view of the whole fractal: in the plane with this axis and rotation; a solid keeps its direction of view.
struct LessonFit {
    attractor::YAxis yAxis = attractor::YAxis::Up;
    double rotation = 0; // same meaning as in attractor::View

    friend bool operator==(const LessonFit&, const LessonFit&) = default;
};

// A view of the plane, with at least this width of it, however the window is shaped.
struct LessonArea {
    attractor::View view;
    double width = 1; // > 0

    friend bool operator==(const LessonArea&, const LessonArea&) = default;
};

// The camera at the place of this window: as high as the area or, in a narrow window, as wide.
attractor::Camera cameraOf(const LessonArea& area, attractor::RasterSize size);
LessonArea areaOf(const attractor::Camera& camera);

// A view of a solid. Its size in pixels is that of the window.
struct LessonOrbit {
    attractor::OrbitCamera camera;
    bool isFitted = false; // fitted to the whole solid, wherever the target is

    friend bool operator==(const LessonOrbit&, const LessonOrbit&) = default;
};

// Content of the canvas: the density, Wⁿ of the cage, or a number of points of a chaos game.
struct LessonConstruction {
    enum class Mode { Density, Steps, ChaosGame };
    Mode mode = Mode::Density;
    int iterations = 0;       // Steps only
    std::uint64_t points = 0; // ChaosGame only; number of points at the start
    double speed = 0;         // points per second; 0: paused

    friend bool operator==(const LessonConstruction&, const LessonConstruction&) = default;
};

struct LessonAtRest {
    friend bool operator==(const LessonAtRest&, const LessonAtRest&) = default;
};
// Position of the cage: as in the entry, at rest, or with these corners.
using LessonCage =
    std::variant<std::monostate, LessonAtRest, std::vector<ifs::Vector<2>>, std::vector<ifs::Vector<3>>>;

struct LessonState {
    QString entry; // name of an entry of the file; empty: the first that can be shown
    std::variant<LessonFit, LessonArea, LessonOrbit> view;
    LessonTool tool = LessonTool::Cage;
    LessonCage cage;
    std::optional<attractor::ColourBy> colourBy; // nullopt: colours of the entry
    std::set<Outline> outlines;
    int cylinderDepth = 1;
    LessonConstruction construction;
    std::optional<animation::Moment> moment; // moment of an animation; nullopt: its start
    bool showsGrid = true;
    bool showsAxes = true;
    bool showsCage = true; // includes the other marks on the canvas
    bool showsMapNumbers = false;
    QStringList panels; // ids of the panels shown beside the canvas

    friend bool operator==(const LessonState&, const LessonState&) = default;
};

struct LessonStep {
    QString title; // one line
    QString text;  // plain text; empty lines separate paragraphs
    LessonState state;
    QStringList unknown; // lines "key: value" of later versions, kept unchanged

    friend bool operator==(const LessonStep&, const LessonStep&) = default;
};

struct Lesson {
    QString title; // one line
    QString file;  // file of its fractals, relative to the folder of the lesson; isLessonFile()
    QList<LessonStep> steps;
    QStringList unknown; // lines of later versions, kept unchanged

    friend bool operator==(const Lesson&, const Lesson&) = default;
};

// Returns true if a lesson may refer to that file: any in its own folder, but for another lesson; elsewhere,
// by a relative or an absolute path with slashes, only a Fractint collection. No other machine, no device.
bool isLessonFile(const QString& path);

// The text as it can be kept: without control characters and marks that reorder text, blanks at the ends of
// lines and empty lines around, and not longer than `limit` characters.
QString lessonLine(const QString& text, int limit = maxLessonTitle);
QString lessonText(const QString& text, int limit = maxLessonText);

} // namespace document
