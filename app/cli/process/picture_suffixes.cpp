// SPDX-License-Identifier: MIT
#include "process/picture_suffixes.h"

#include "io/video/format/video_format.h"
#include "options/parser.h"

namespace cli {

bool anyPicture(const io::PictureFileFacts&) {
    return true;
}

std::vector<std::string> pictureSuffixes(const WhichPictures& which, const std::vector<std::string>& more) {
    std::vector<std::string> suffixes;
    for (const io::PictureFileFacts& facts : io::pictureFiles())
        if (which(facts)) suffixes.insert(suffixes.end(), facts.suffixes.begin(), facts.suffixes.end());
    suffixes.insert(suffixes.end(), more.begin(), more.end());
    return suffixes;
}

std::vector<std::string> usualSuffixes(const WhichPictures& which, const std::vector<std::string>& more) {
    std::vector<std::string> suffixes;
    for (const io::PictureFileFacts& facts : io::pictureFiles())
        if (which(facts) && !facts.suffixes.empty()) suffixes.emplace_back(facts.suffixes.front());
    suffixes.insert(suffixes.end(), more.begin(), more.end());
    return suffixes;
}

QString namedSuffixes(const WhichPictures& which, const QString& last, const std::vector<std::string>& more) {
    std::vector<std::string> names = usualSuffixes(which, more);
    for (std::string& name : names)
        name.insert(0, 1, '.');
    return listed(names, last);
}

std::vector<std::string> videoSuffixes(std::vector<std::string> others) {
    for (const io::VideoFormatFacts& facts : io::videoFormats())
        others.emplace_back(facts.suffix);
    return others;
}

QString namedVideos(const QString& last) {
    std::vector<std::string> names;
    for (const io::VideoFormatFacts& facts : io::videoFormats())
        names.push_back(std::string(".") + facts.suffix);
    return listed(names, last);
}

std::string describedVideos() {
    std::vector<std::string> kinds;
    for (const io::VideoFormatFacts& facts : io::videoFormats())
        kinds.push_back(std::string(".") + facts.suffix + " (" + facts.details + ")");
    return "Videos are " + listed(kinds, tr("and")).toStdString() + ".";
}

} // namespace cli
