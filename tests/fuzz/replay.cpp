// SPDX-License-Identifier: MIT
#include "fuzz/readers.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <random>

#include <unistd.h>

// Without libFuzzer: gives a reader its seeds, then changed ones, always the same and in the same order for
// the same seeds.
//
//   fuzz_readers READER [SECONDS]       changed inputs for so long, and at least 500
//   fuzz_readers READER FILE…           these files alone, for what was found before
//   fuzz_readers --write FOLDER READER  the seeds as files, and tokens.dict beside them
//   fuzz_readers --list

namespace {

constexpr qsizetype maxInput = 1 << 15;

QByteArray current; // is left in a file when a reader breaks over it

void keepCurrent(int signal) {
    // Of what may be called here, as little as will do.
    if (std::FILE* file = std::fopen("fuzz_broken_input", "wb")) {
        std::fwrite(current.constData(), 1, std::size_t(current.size()), file);
        std::fclose(file);
        std::fputs("the input is kept in ./fuzz_broken_input\n", stderr);
    }
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void give(const fuzz::Reader& reader, const QByteArray& input) {
    current = input;
    reader.read(input);
}

class Mutator {
public:
    explicit Mutator(QByteArrayList seeds) : m_seeds(std::move(seeds)) {}

    QByteArray next() {
        QByteArray input = any(m_seeds);
        if (input.size() > maxInput) input = input.mid(below(input.size() - maxInput), maxInput);
        for (qsizetype i = below(6); i >= 0; --i)
            change(input);
        return input.left(maxInput);
    }

private:
    qsizetype below(qsizetype count) { return count > 0 ? qsizetype(m_random() % std::uint64_t(count)) : 0; }
    const QByteArray& any(const QByteArrayList& list) { return list[below(list.size())]; }

    void change(QByteArray& input) {
        const qsizetype at = below(input.size() + 1);
        const qsizetype length = below(std::min<qsizetype>(input.size() - at, 64) + 1);
        switch (below(8)) {
        case 0:
            if (at < input.size()) input[at] = char(input[at] ^ (1 << below(8)));
            break;
        case 1:
            if (at < input.size()) input[at] = char(below(256));
            break;
        case 2:
            input.remove(at, length);
            break;
        case 3:
            input.insert(at, fuzz::tokens()[below(fuzz::tokens().size())]);
            break;
        case 4: { // in place of a word
            const auto isEnd = [](char c) { return std::strchr(" \t\r\n;,<>={}\"", c) != nullptr; };
            const auto end = std::find_if(input.cbegin() + at, input.cend(), isEnd);
            input.replace(at, end - (input.cbegin() + at), fuzz::tokens()[below(fuzz::tokens().size())]);
            break;
        }
        case 5:
            input.insert(at, input.mid(at, length).repeated(1 + (below(20) == 0 ? below(200) : below(3))));
            break;
        case 6: { // the end of another
            const QByteArray& other = any(m_seeds);
            input = input.left(at) + other.mid(below(other.size()), maxInput);
            break;
        }
        default:
            input.truncate(at);
        }
    }

    QByteArrayList m_seeds;
    std::mt19937_64 m_random{1};
};

QByteArray asDictionaryEntry(const QByteArray& token) {
    QByteArray text;
    for (const char c : token)
        text += "\\x" + QByteArray(1, c).toHex();
    return '"' + text + "\"\n";
}

bool put(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

int writeSeeds(const QString& folder, const fuzz::Reader& reader) {
    const QDir seeds(folder + QLatin1Char('/') + QLatin1String(reader.name));
    bool good = seeds.mkpath(QStringLiteral("."));
    int number = 0;
    for (const QByteArray& seed : fuzz::seedsOf(reader))
        good = good && put(seeds.filePath(QString::number(++number)), seed);
    QByteArray dictionary;
    for (const QByteArray& token : fuzz::tokens())
        dictionary += asDictionaryEntry(token);
    return good && put(folder + QStringLiteral("/tokens.dict"), dictionary) ? 0 : 1;
}

int replay(const fuzz::Reader& reader, const QStringList& files) {
    for (const QString& path : files) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) return 2;
        give(reader, file.readAll());
    }
    return 0;
}

int mutate(const fuzz::Reader& reader, int seconds) {
    constexpr int minRuns = 500; // also where everything is slow: under a sanitizer, on a busy machine

    const QByteArrayList seeds = fuzz::seedsOf(reader);
    for (const QByteArray& seed : seeds)
        give(reader, seed);
    Mutator mutator(seeds);
    const QDeadlineTimer end(std::chrono::seconds{seconds});
    int count = 0;
    for (; count < minRuns || !end.hasExpired(); ++count)
        give(reader, mutator.next());
    std::printf("%s: %d seeds, %d inputs made of them\n", reader.name, int(seeds.size()), count);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    const auto all = fuzz::readers();
    if (arguments.value(0) == QLatin1String("--list")) {
        for (const fuzz::Reader& reader : all)
            std::puts(reader.name);
        return 0;
    }
    const bool write = arguments.value(0) == QLatin1String("--write");
    const QString name = arguments.value(write ? 2 : 0);
    const auto found = std::find_if(all.begin(), all.end(), [&](const fuzz::Reader& reader) {
        return name == QLatin1String(reader.name);
    });
    if (found == all.end()) {
        std::fprintf(stderr, "there is no reader “%s”\n", qPrintable(name));
        return 2;
    }
    if (write) return writeSeeds(arguments.value(1), *found);
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS})
        std::signal(signal, keepCurrent);
    bool isDuration = true;
    const int seconds = arguments.value(1, QStringLiteral("3")).toInt(&isDuration);
    return isDuration ? mutate(*found, seconds) : replay(*found, arguments.mid(1));
}
