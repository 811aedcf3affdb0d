// SPDX-License-Identifier: MIT
#pragma once

#include "io/picture/plane_export.h"
#include "io/sums/sum_file.h"

#include <QFile>
#include <QStringList>

#include <memory>
#include <utility>
#include <vector>

namespace io {

// Files of sums of one picture, which share no unit.
class SumFiles {
public:
    explicit SumFiles(const QStringList& paths); // opens and checks all files

    const Failure& failure() const { return m_failure; }         // first failure, with the name of its file
    bool isUnreadable() const { return m_isUnreadable; }         // true if a file or disk failed
    const SumHeader& header() const { return m_header; }         // header of the union
    const QString& name() const { return m_parts.front().path; } // path of the first file

    bool addTo(attractor::CellSums& sums); // adds to the rows of its window; false on a failure
    // Tile by tile, in memory for a few tiles of each file. False when stopped or on a failure.
    bool writeTo(SumWriter& writer, int threads, const Progress& progress, const std::stop_token& stop);

private:
    struct Part {
        QString path;
        std::unique_ptr<QFile> file;
        std::unique_ptr<SumReader> reader;
    };
    // A tile of all files.
    struct Merged {
        std::uint32_t number = 0;
        std::vector<std::pair<Part*, QByteArray>> blocks;
        QByteArray stored{};
        Part* damaged = nullptr;
    };
    bool open(const QString& path);
    bool collect(Merged& merged);
    void add(Merged& merged) const;
    Failure misfit(const QString& name, const SumHeader& other) const;
    bool failed(const Part& part);

    SumHeader m_header;
    std::vector<Part> m_parts;
    std::vector<QString> m_names; // name of the file for each share of the header
    Failure m_failure;
    bool m_isUnreadable = false;
};

} // namespace io
