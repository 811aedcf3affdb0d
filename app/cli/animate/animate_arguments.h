// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"

#include "animation/animation.h"
#include "ifs/names.h"
#include "io/video/format/video_format.h"

#include <QString>

#include <array>
#include <optional>
#include <string>
#include <vector>

// The options of barycage-cli animate. What makes no sense throws UsageError with a sentence that names the
// option.
namespace cli {

struct Command;

// Numbers of files, counted from 1: from the first to the last in steps.
struct FileRange {
    int first = 1;
    int last = 1;
    int step = 1;
};

// Selects every n-th file: those whose place in the list, counted from 0, leaves i when divided by n.
struct Chunk {
    int i = 0;
    int n = 1;
};

enum class Existing {
    Skip,    // complete frames of the same request stay
    Replace, // everything is drawn again
    Fail,    // nothing is drawn when a file is there
};

struct AnimateArguments {
    std::string file;
    RenderArguments picture;       // settings shared by all frames
    std::vector<FileRange> ranges; // numbers of files; empty: all
    std::optional<Chunk> chunk;
    std::optional<Existing> existing;
    std::optional<animation::FrameRate> framesPerSecond;

    std::optional<io::VideoFormat> video; // format of the output, if it is a video
    Existing whatExists = Existing::Skip; // always Skip for videos
};

void addAnimateOptions(Command& command, AnimateArguments& arguments);

// Checks every value before a file is read.
void check(AnimateArguments& arguments);

// --frames: "1-240x2,300", or "all" for none. Throws UsageError.
std::vector<FileRange> rangesArgument(const std::string& option, const std::string& text);

// The numbers that the ranges ask for, ascending, each once, up to `count`.
std::vector<int> filesIn(const std::vector<FileRange>& ranges, int count);
bool isAnyBeyond(const std::vector<FileRange>& ranges, int count);

// Throws UsageError unless the name has one group of #, and ends in .png. A # in the folder is a letter of
// its name.
void checkPattern(const QString& pattern);

// The name of the file with this number: it stands for the #### behind the folder, with leading zeros.
QString numbered(const QString& pattern, int number);

} // namespace cli

template <>
inline constexpr auto ifs::names<cli::Existing> = std::to_array<ifs::Named<cli::Existing>>(
    {{cli::Existing::Skip, "skip"}, {cli::Existing::Replace, "replace"}, {cli::Existing::Fail, "fail"}});
