// SPDX-License-Identifier: MIT
#include "options/commands.h"
#include "options/describe.h"
#include "options/help.h"
#include "options/parser.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/messages.h"
#include "process/output.h"
#include "process/short_memory.h"

#include "io/report/info_json.h"

#include <QGuiApplication>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <system_error>
#include <vector>

namespace {

using cli::ExitStatus;

ExitStatus answer(const cli::Program& program, const cli::Call& call) {
    const std::string text = call.question == cli::Question::Help ? cli::helpText(program, call.command)
                                                                  : "barycage-cli " BARYCAGE_VERSION "\n";
    return cli::writeOutput(QStringLiteral("-"), QByteArray::fromStdString(text));
}

ExitStatus call(const cli::Program& program, const std::vector<std::string>& words) {
    if (words.size() == 2 && words.front() == "--describe") {
        const bool isSchema = words.back() == "schema";
        return cli::writeOutput(QStringLiteral("-"),
                                isSchema ? io::infoSchema()
                                         : QByteArray::fromStdString(cli::describe(program, words.back())));
    }
    const cli::Call call = cli::parse(program, words);
    return call.question != cli::Question::None ? answer(program, call) : call.command->run();
}

ExitStatus run(const cli::Program& program, const std::vector<std::string>& words) {
    try {
        return call(program, words);
    } catch (const cli::InputError& error) {
        cli::reportError(error.fileName, error.sentence);
        return error.status;
    } catch (const cli::UsageError& error) {
        const bool isCommand = !words.empty() && program.find(words.front()) != nullptr;
        cli::reportUsage(isCommand ? QString::fromStdString(words.front()) : QString(), error.sentence);
        return ExitStatus::WrongUsage;
    } catch (const std::bad_alloc&) {
        cli::reportError(QStringLiteral("barycage-cli"), cli::tr("There is not enough memory for this."));
        return ExitStatus::CannotReadOrWrite;
    } catch (const std::system_error& error) {
        cli::reportError(QStringLiteral("barycage-cli"), QString::fromLocal8Bit(error.what()));
        return ExitStatus::CannotReadOrWrite;
    }
}

// Of a sheet, or over a picture.
bool paintsLetters(const std::vector<std::string>& words) {
    const auto explains = [](const std::string& word) {
        return word.starts_with("--overlay") || word.starts_with("--legend");
    };
    return !words.empty() && (words.front() == "gallery" || std::ranges::any_of(words, explains));
}

// What libraries say of their own is no sentence of ours: whatever fails is reported by us.
void silenceLibraries() {
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        // Qt goes on, and waits without end for the work of the thread that the system did not start.
        if (text.startsWith(u"QThread::start: Thread creation error")) std::_Exit(cli::memoryIsShort());
        if (type != QtFatalMsg) return;
        std::fprintf(stderr, "barycage-cli: error: %s\n", qPrintable(text));
    });
}

} // namespace

int main(int argc, char** argv) try {
    qputenv("QT_NO_GLIB", "1"); // whose loop of events is never used
    silenceLibraries();
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files is an error of writing, not the end
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    // Letters need a QGuiApplication; it gets no display all the same.
    std::unique_ptr<QCoreApplication> application;
    if (paintsLetters(words)) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        application = std::make_unique<QGuiApplication>(argc, argv);
    } else {
        application = std::make_unique<QCoreApplication>(argc, argv);
    }
    const cli::Program program("Iterated function systems from the command line",
                               {cli::infoCommand(), cli::renderCommand(), cli::convertCommand(),
                                cli::galleryCommand(), cli::animateCommand(), cli::encodeCommand(),
                                cli::morphCommand(), cli::mergeCommand(), cli::collageCommand(),
                                cli::stealCommand(), cli::pageCommand()});
    return int(run(program, words));
} catch (const std::bad_alloc&) { // before anything could be read
    return cli::memoryIsShort();
}
