// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/palette.h"
#include "ifs/affine_map.h"

#include <QSize>

#include <cstdint>
#include <string>
#include <vector>

// Option values that are more than a number. Each throws UsageError with a sentence that names the option.
namespace cli {

QSize sizeArgument(const std::string& option, const std::string& text);                         // "1200x900"
std::vector<ifs::Vector<2>> pointsArgument(const std::string& option, const std::string& text); // "x,y x,y …"
std::uint64_t wholeArgument(const std::string& option, const std::string& text);
double positiveArgument(const std::string& option, const std::string& text);
double marginArgument(const std::string& option, const std::string& text); // per cent → share, below one half
attractor::Rgba colourArgument(const std::string& option, const std::string& text);
attractor::Palette paletteArgument(const std::string& option, const std::string& text);

struct View {
    ifs::Vector<2> centre;
    double height;
};
View viewArgument(const std::string& option, const std::string& text); // "cx,cy,height"

} // namespace cli
