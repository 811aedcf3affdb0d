// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/picture_writers.h"

#include <QString>

#include <functional>
#include <string>
#include <vector>

// The endings of the names of pictures and videos, for messages, help and completions.
namespace cli {

using WhichPictures = std::function<bool(const io::PictureFileFacts&)>;
bool anyPicture(const io::PictureFileFacts& facts);

// All suffixes, "png", "jpg", "jpeg", …, followed by `more`.
std::vector<std::string> pictureSuffixes(const WhichPictures& which,
                                         const std::vector<std::string>& more = {});
// The usual ones.
std::vector<std::string> usualSuffixes(const WhichPictures& which, const std::vector<std::string>& more = {});
// ".png, .jpg or .pdf"
QString namedSuffixes(const WhichPictures& which, const QString& last,
                      const std::vector<std::string>& more = {});

// "mp4", "webm", …, after others.
std::vector<std::string> videoSuffixes(std::vector<std::string> others = {});
// ".mp4, .webm or .apng"
QString namedVideos(const QString& last);
// "Videos are .mp4 (H.264), …"
std::string describedVideos();

} // namespace cli
