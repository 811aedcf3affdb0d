// SPDX-License-Identifier: MIT
#include "widgets/background/save_beside.h"

#include "document/text/text.h"
#include "io/file/background.h"
#include "widgets/background/wait_for.h"

#include <QFileInfo>
#include <QPointer>
#include <QWidget>

#include <atomic>
#include <memory>
#include <utility>

namespace view {

namespace {

// State shared by saving and cancelling, which may coincide; the first one decides.
struct Shared {
    std::atomic<bool> isDecided = false;
    io::Failure failure;
};

} // namespace

Saving saveBeside(const QString& path, const QByteArray& bytes, QWidget* window,
                  std::function<void()> beforeReplacing) {
    const auto shared = std::make_shared<Shared>();
    QFuture<void> work(io::inBackground<bool>(
        io::Lane::Saving,
        [shared, path, bytes, beforeReplacing = std::move(beforeReplacing)](QPromise<bool>&) {
            io::NewFile file(path);
            if (!file.failure()) file.write(bytes);
            if (beforeReplacing && !file.failure() && !shared->isDecided) beforeReplacing();
            if (!shared->isDecided.exchange(true)) shared->failure = file.commit();
        }));
    const QString label = Text::tr("Saving “%1”…").arg(QFileInfo(path).fileName());
    const QPointer over(window);
    while (!waitFor(work, label, over)) // ends when the file is saved or saving is cancelled
        if (!shared->isDecided.exchange(true)) return {true, {}};
    work.waitForFinished(); // rethrows other exceptions
    return {false, shared->failure};
}

} // namespace view
