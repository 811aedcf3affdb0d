// SPDX-License-Identifier: MIT
#include "io/lesson/lesson_words.h"

namespace io {

namespace {

using attractor::ColourBy;
using document::LessonState;
using document::LessonTool;
using document::Outline;

constexpr LessonWord<LessonTool> tools[] = {
    {QLatin1String("cage"), LessonTool::Cage},
    {QLatin1String("maps"), LessonTool::Maps},
    {QLatin1String("branch"), LessonTool::Branch},
};

constexpr LessonWord<ColourBy> colours[] = {
    {QLatin1String("density"), ColourBy::Density}, {QLatin1String("map"), ColourBy::Map},
    {QLatin1String("address"), ColourBy::Address}, {QLatin1String("plain"), ColourBy::Plain},
    {QLatin1String("blend"), ColourBy::Blend},
};

constexpr LessonWord<Outline> outlines[] = {
    {QLatin1String("box"), Outline::Box},         {QLatin1String("hull"), Outline::Hull},
    {QLatin1String("simplex"), Outline::Simplex}, {QLatin1String("fixed-points"), Outline::FixedPoints},
    {QLatin1String("ellipse"), Outline::Ellipse}, {QLatin1String("cylinders"), Outline::Cylinders},
};

constexpr LessonWord<bool LessonState::*> marks[] = {
    {QLatin1String("grid"), &LessonState::showsGrid},
    {QLatin1String("axes"), &LessonState::showsAxes},
    {QLatin1String("cage"), &LessonState::showsCage},
};

constexpr LessonWord<bool LessonState::*> extras[] = {
    {QLatin1String("map-numbers"), &LessonState::showsMapNumbers},
};

} // namespace

std::span<const LessonWord<LessonTool>> lessonTools() {
    return tools;
}

std::span<const LessonWord<ColourBy>> lessonColours() {
    return colours;
}

std::span<const LessonWord<Outline>> lessonOutlines() {
    return outlines;
}

std::span<const LessonWord<bool LessonState::*>> lessonMarks() {
    return marks;
}

std::span<const LessonWord<bool LessonState::*>> lessonExtras() {
    return extras;
}

} // namespace io
