// SPDX-License-Identifier: MIT
#pragma once

#include "options/options.h"

#include "animation/animation.h"
#include "attractor/colour/palette.h"
#include "attractor/request/appearance.h"
#include "attractor/request/camera.h"
#include "attractor/request/space_appearance.h"
#include "document/moments/shutter.h"
#include "ifs/names.h"
#include "ifs/system/affine_map.h"

#include <QSize>
#include <QSizeF>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

// Readers of the values of options. Each throws UsageError with a sentence that names the option.
namespace cli {

// Numbers between commas, with the text they were typed as; no values when one of them is no number.
struct NumberList {
    std::string text;
    std::vector<double> values;
};
std::vector<double> numbers(const QString& text);
NumberList numbersArgument(const std::string& option, const std::string& text); // any number of values

// The place of one of the names, else the sentence lists them.
std::size_t choiceArgument(const std::string& option, const std::string& text,
                           const std::vector<std::string>& names);
template <class Words> std::vector<std::string> wordsOf(const Words& words) {
    std::vector<std::string> ids;
    for (const auto& word : words)
        ids.emplace_back(word.id);
    return ids;
}
// A word of an enumeration, with completion of the option.
template <class T, class E> Value choice(T* place, std::span<const ifs::Named<E>> words) {
    const std::vector<std::string> ids = wordsOf(words);
    Value value = parsed(place, [words, ids](const std::string& option, const std::string& text) {
        return words[choiceArgument(option, text, ids)].value;
    });
    value.completion = {Completion::Kind::Words, ids};
    return value;
}
template <class E> Value choice(std::optional<E>* place) {
    return choice(place, std::span<const ifs::Named<E>>(ifs::names<E>));
}
template <class E> Value choice(E* place) {
    return choice(place, std::span<const ifs::Named<E>>(ifs::names<E>));
}

int integerArgument(const std::string& option, const std::string& text, int min, int max);
// A whole number, which may be written as 1e6, 2.5M or 4G as well.
std::uint64_t countArgument(const std::string& option, const std::string& text, std::uint64_t min,
                            std::uint64_t max);
double numberArgument(const std::string& option, const std::string& text, double min, double max);

// The same as readers of parsed().
inline auto integerFrom(int min, int max) {
    return [=](const std::string& option, const std::string& text) {
        return integerArgument(option, text, min, max);
    };
}
inline auto countFrom(std::uint64_t min, std::uint64_t max) {
    return [=](const std::string& option, const std::string& text) {
        return countArgument(option, text, min, max);
    };
}
inline auto numberFrom(double min, double max) {
    return [=](const std::string& option, const std::string& text) {
        return numberArgument(option, text, min, max);
    };
}
inline const auto threadsArgument = integerFrom(1, 1024);

QSize sizeArgument(const std::string& option, const std::string& text); // "1200x900"
// A size such as "1200x900"; "1200x" and "x900" leave the other side, 0, to the proportions of the picture.
QSize pictureSizeArgument(const std::string& option, const std::string& text);
std::string sizeText(const QSize& size); // inverse of sizeArgument()
// "58mmx40mm"; "58mmx" and "x40mm" as above. nullopt: these are no lengths on paper.
std::optional<QSizeF> paperSizeArgument(const std::string& option, const std::string& text);
constexpr int maxSide = 1'000'000;                                                              // pixels
std::vector<ifs::Vector<2>> pointsArgument(const std::string& option, const std::string& text); // "x,y x,y …"
std::vector<ifs::Vector<2>> pointListArgument(const std::string& option,
                                              const std::string& text); // at least one point
std::uint64_t wholeArgument(const std::string& option, const std::string& text);
double positiveArgument(const std::string& option, const std::string& text);
// Seconds above 0, at most 1e6.
std::chrono::duration<double> secondsArgument(const std::string& option, const std::string& text);
double marginArgument(const std::string& option, const std::string& text); // per cent, below one half
attractor::Rgba colourArgument(const std::string& option, const std::string& text);
void putOn(attractor::Appearance& appearance,
           const attractor::Rgba& background); // also picks colours that are visible on it
attractor::Palette paletteArgument(const std::string& option, const std::string& text);

// The words of --colour for entries in the plane: those of files, but for one.
inline constexpr auto coloursInPlane = std::to_array<ifs::Named<attractor::ColourBy>>({
    {attractor::ColourBy::Density, "density"},
    {attractor::ColourBy::Map, "map"},
    {attractor::ColourBy::Address, "address"},
    {attractor::ColourBy::Blend, "blend"},
    {attractor::ColourBy::Plain, "none"},
});
// The meaning given to --colour: entries in the plane and solids know different ones.
struct ColourMeaning {
    std::string word;
    std::optional<attractor::ColourBy> inPlane;
    std::optional<attractor::SolidColour> inSpace;
};
ColourMeaning meaningArgument(const std::string& option, const std::string& text);

animation::Moment momentArgument(const std::string& option,
                                 const std::string& text); // moment in frames: "12.5", "25/2"

document::ShutterAngle shutterArgument(const std::string& option,
                                       const std::string& text); // degrees, rounded to thousandths
animation::FrameRate rateArgument(const std::string& option, const std::string& text); // "24", "30000/1001"

double rotationArgument(const std::string& option, const std::string& text); // rotation of a view in degrees
attractor::View viewArgument(const std::string& option, const std::string& text); // "cx,cy,height"

} // namespace cli
