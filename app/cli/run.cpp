// SPDX-License-Identifier: MIT
#include "run.h"

#include "options/commands.h"
#include "options/describe.h"
#include "options/help.h"
#include "options/parser.h"
#include "options/tr.h"
#include "options/usage_error.h"
#include "process/files_read.h"
#include "process/messages.h"
#include "process/output.h"

#include "io/report/info_json.h"

#include <algorithm>
#include <new>
#include <system_error>

namespace cli {

namespace {

ExitStatus answer(const Program& program, const Call& call) {
    const std::string text = call.question == Question::Help ? helpText(program, call.command)
                                                             : "barycage-cli " BARYCAGE_VERSION "\n";
    return writeOutput(QStringLiteral("-"), QByteArray::fromStdString(text));
}

ExitStatus call(const Program& program, const std::vector<std::string>& words) {
    if (words.size() == 2 && words.front() == "--describe") {
        const bool isSchema = words.back() == "schema";
        return writeOutput(QStringLiteral("-"),
                           isSchema ? io::infoSchema()
                                    : QByteArray::fromStdString(describe(program, words.back())));
    }
    const Call call = parse(program, words);
    return call.question != Question::None ? answer(program, call) : call.command->run();
}

} // namespace

bool paintsLetters(const std::vector<std::string>& words) {
    const auto explains = [](const std::string& word) {
        return word.starts_with("--overlay") || word.starts_with("--legend");
    };
    return !words.empty() && (words.front() == "gallery" || std::ranges::any_of(words, explains));
}

ExitStatus run(const std::vector<std::string>& words) {
    forgetFilesRead();
    hideWarnings(false);
    const Program program("Iterated function systems from the command line",
                          {infoCommand(), renderCommand(), convertCommand(), galleryCommand(),
                           animateCommand(), encodeCommand(), morphCommand(), mergeCommand(),
                           collageCommand(), stealCommand(), pageCommand()});
    try {
        return call(program, words);
    } catch (const InputError& error) {
        reportError(error.fileName, error.sentence);
        return error.status;
    } catch (const UsageError& error) {
        const bool isCommand = !words.empty() && program.find(words.front()) != nullptr;
        reportUsage(isCommand ? QString::fromStdString(words.front()) : QString(), error.sentence);
        return ExitStatus::WrongUsage;
    } catch (const std::bad_alloc&) {
        reportError(QStringLiteral("barycage-cli"), tr("There is not enough memory for this."));
        return ExitStatus::CannotReadOrWrite;
    } catch (const std::system_error& error) {
        const bool isThread = error.code() == std::errc::resource_unavailable_try_again; // was not started
        reportError(QStringLiteral("barycage-cli"), isThread ? tr("There is not enough memory for this.")
                                                             : QString::fromLocal8Bit(error.what()));
        return ExitStatus::CannotReadOrWrite;
    }
}

} // namespace cli
