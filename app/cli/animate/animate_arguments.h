// SPDX-License-Identifier: MIT
#pragma once

#include "render/render_arguments.h"

#include "animation/animation.h"
#include "io/video/format/video_format.h"

#include <QString>

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

// Every n-th file: those whose place in the list, counted from 0, leaves i when divided by n.
struct Chunk {
    int i = 0;
    int n = 1;
};

enum class Existing {
    Skip,    // what is complete and was drawn by the same request stays
    Replace, // everything is drawn again
    Fail,    // nothing is drawn when a file is there
};

struct AnimateArguments {
    std::string file;
    RenderArguments picture; // of every frame
    std::optional<std::string> frames, chunk, existing, rate;

    std::optional<io::VideoFormat> video; // that the output is, in place of pictures
    std::vector<FileRange> ranges;        // that `frames` asks for; none: all
    Chunk part;
    Existing whatExists = Existing::Skip; // of videos never
    std::optional<animation::FrameRate> framesPerSecond;
};

void addAnimateOptions(Command& command, AnimateArguments& arguments);

// Looks at every value before a file is read.
void check(AnimateArguments& arguments);

// Of "1-240x2,300". Throws UsageError.
std::vector<FileRange> rangesOf(const std::string& text);

// The numbers that the ranges ask for, ascending, each once, up to `count`.
std::vector<int> filesIn(const std::vector<FileRange>& ranges, int count);
bool isAnyBeyond(const std::vector<FileRange>& ranges, int count);

// Throws UsageError unless the name has one group of #, and ends in .png. A # in the folder is a letter of
// its name.
void checkPattern(const QString& pattern);

// The name of the file with this number: it stands for the #### behind the folder, with leading zeros.
QString numbered(const QString& pattern, int number);

} // namespace cli
