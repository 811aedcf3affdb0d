// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/png_export.h"
#include "io/sums/sum_file.h"

#include <QFile>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

// A picture whose samples are counted by several machines or in several runs (docs/formats.md, Files of
// sums).
namespace io {

// Files of sums of one picture, which share no unit.
class SumFiles {
public:
    explicit SumFiles(const QStringList& paths); // opens and checks them all

    const Failure& failure() const { return m_failure; }         // the first; it names the file
    bool isUnreadable() const { return m_isUnreadable; }         // the failure is that of a file or a disk
    const SumHeader& header() const { return m_header; }         // of their union
    const QString& name() const { return m_parts.front().path; } // of the first

    bool addTo(attractor::CellSums& sums); // in the rows of its window; false on a failure
    // Tile by tile, in memory for one tile of each file. False when stopped or on a failure.
    bool writeTo(SumWriter& writer, const Progress& progress, const std::stop_token& stop);

private:
    struct Part {
        QString path;
        std::unique_ptr<QFile> file;
        std::unique_ptr<SumReader> reader;
    };
    bool open(const QString& path);
    Failure misfit(const QString& name, const SumHeader& other) const;
    bool failed(const Part& part);

    SumHeader m_header;
    std::vector<Part> m_parts;
    std::vector<QString> m_names; // of the files that the shares of the header come from
    Failure m_failure;
    bool m_isUnreadable = false;
};

// What is drawn of a picture: `drawn` here, the rest is in the files. The first pass has as many samples as
// the request.
struct PictureSums {
    PngExport picture;
    std::vector<std::uint64_t> passes;
    std::vector<SumShare> drawn;     // at most one of each pass, all of the same rows; none is in the files
    std::shared_ptr<SumFiles> files; // nullptr: none
};

// The picture that the request in sound files asks for.
struct LoadedSums {
    PictureSums sums;
    Failure failure;
};
LoadedSums sumsIn(const std::shared_ptr<SumFiles>& files, int threads);

// The units in rows [firstRow, endRow) of the picture as the file will name it: drawn from the text of its
// request, so that every machine draws the same.
PictureSums partOf(const PngExport& picture, int firstRow, int endRow, const attractor::PicturePart& part);
// One more pass of so many samples on top of what the files hold.
void addPass(PictureSums& sums, std::uint64_t samples);

// Draws what is to be drawn and writes it with what is in the files into one file of sums.
ExportOutcome exportSums(const PictureSums& sums, const QString& path, const Progress& progress = {},
                         std::stop_token stop = {});
// What is missing for the picture; nullopt when all units of all passes are there.
Failure incompleteness(const PictureSums& sums);
// The picture itself, unless it is incomplete.
ExportOutcome exportPicture(const PictureSums& sums, const QString& path, const Progress& progress = {},
                            std::stop_token stop = {});

} // namespace io
