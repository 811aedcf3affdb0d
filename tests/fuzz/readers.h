// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArrayList>

#include <span>

// Every reader of the program behind one door, for whoever feeds it: the tests and libFuzzer.
namespace fuzz {

struct Reader {
    const char* name;
    // Reads, and ends the program when a promise of the reader is broken: nothing lost, every number finite,
    // what is written reads back.
    void (*read)(const QByteArray& bytes);
    QByteArrayList suffixes; // of the files that are seeds for it
};

std::span<const Reader> readers();

// Well-formed input: files of tests/data, of the bundled collection and of $BARYCAGE_CORPUS, and what the
// program itself writes.
QByteArrayList seedsOf(const Reader& reader);

// Pieces of the formats, and numbers that readers stumble over.
const QByteArrayList& tokens();

} // namespace fuzz
