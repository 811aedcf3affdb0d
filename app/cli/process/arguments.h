// SPDX-License-Identifier: MIT
#pragma once

#include "animation/animation.h"
#include "attractor/colour/palette.h"
#include "attractor/request/appearance.h"
#include "attractor/request/camera.h"
#include "document/moments/shutter.h"
#include "ifs/system/affine_map.h"

#include <QSize>

#include <cstdint>
#include <string>
#include <vector>

// Option values that are more than a number. Each throws UsageError with a sentence that names the option.
namespace cli {

std::vector<double> numbers(const QString& text); // between commas; empty when one of them is none

// One of the names, else the sentence lists them.
std::string choiceArgument(const std::string& option, const std::string& text,
                           const std::vector<std::string>& names);
int integerArgument(const std::string& option, const std::string& text, int min, int max);
// A whole number, which may be written as 1e6, 2.5M or 4G as well.
std::uint64_t countArgument(const std::string& option, const std::string& text, std::uint64_t min,
                            std::uint64_t max);
QSize sizeArgument(const std::string& option, const std::string& text); // "1200x900"
// "1200x900"; "1200x" and "x900" leave the other side, 0, to the proportions of what is drawn.
QSize pictureSizeArgument(const std::string& option, const std::string& text);
constexpr int maxSide = 1'000'000;                                                              // pixels
std::vector<ifs::Vector<2>> pointsArgument(const std::string& option, const std::string& text); // "x,y x,y …"
std::vector<ifs::Vector<2>> pointListArgument(const std::string& option,
                                              const std::string& text); // at least one
std::uint64_t wholeArgument(const std::string& option, const std::string& text);
double positiveArgument(const std::string& option, const std::string& text);
double secondsArgument(const std::string& option, const std::string& text); // above 0, at most 1e6
double marginArgument(const std::string& option, const std::string& text); // per cent → share, below one half
attractor::Rgba colourArgument(const std::string& option, const std::string& text);
attractor::ColourBy colourByArgument(const std::string& option, const std::string& text);
void putOn(attractor::Appearance& appearance,
           const attractor::Rgba& background); // in colours that are seen on it
attractor::Palette paletteArgument(const std::string& option, const std::string& text);

animation::Moment momentArgument(const std::string& option,
                                 const std::string& text); // frames: "12.5", "25/2"

document::ShutterAngle shutterArgument(const std::string& option,
                                       const std::string& text); // degrees, to a thousandth
animation::FrameRate rateArgument(const std::string& option, const std::string& text); // "24", "30000/1001"

double rotationArgument(const std::string& option, const std::string& text);      // of a view, from degrees
attractor::View viewArgument(const std::string& option, const std::string& text); // "cx,cy,height"

} // namespace cli
