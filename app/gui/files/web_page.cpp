// SPDX-License-Identifier: MIT
#include "files/web_page.h"

#include "actions/action_menu.h"
#include "document/fractal_file.h"
#include "document/text/text.h"
#include "io/file/background.h"
#include "io/page/page_export.h"
#include "messages/written_banner.h"
#include "widgets/background/save_beside.h"
#include "widgets/background/wait_for.h"
#include "widgets/file_dialogs.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>

#include <new>

namespace {

struct WindowText {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)
};

} // namespace

void exportWebPage(const MenuContext& context, const QString& folder) {
    io::PageExport page;
    page.fractal = context.document->fractal();
    QString suggestion =
        view::suggestedName(document::uniqueName({}, page.fractal.name), QStringLiteral("html"));
    if (!folder.isEmpty()) suggestion.prepend(folder + u'/');
    const QString path = view::chooseFileToSave(context.window, WindowText::tr("Export Web Page"), suggestion,
                                                WindowText::tr("Web pages (*.html)"), QStringLiteral("html"));
    if (path.isEmpty()) return;
    const QString name = QFileInfo(path).fileName();
    QFuture<QByteArray> work =
        io::inBackground<QByteArray>([page = std::move(page)](QPromise<QByteArray>& promise) {
            try {
                promise.addResult(io::pageOf(page));
            } catch (const std::bad_alloc&) {
                promise.addResult(QByteArray());
            }
        });
    const QPointer<QMainWindow> window(context.window);
    const document::Document* const edited = context.document;
    WindowMessages* const messages = context.messages;
    const QString saving = WindowText::tr("Saving “%1”…").arg(name);
    if (!view::waitFor(QFuture<void>(work), saving, window) || !window) return;
    const QByteArray text = work.takeResult();
    const QString notSaved = WindowText::tr("%1 was not saved").arg(name);
    if (text.isEmpty())
        return messages->fail(notSaved, Text::tr("There is not enough memory for this picture."));
    const auto [isCancelled, failure] = view::saveBeside(path, text, window);
    if (isCancelled || !window) return;
    if (failure) return messages->fail(notSaved, *failure);
    WrittenBanner::offer(
        window, *edited, path, WindowText::tr("Web page written"),
        WindowText::tr("%1 was written. Open it in a browser, or mail it: it needs no network."));
}
