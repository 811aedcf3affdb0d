// SPDX-License-Identifier: MIT
#include "dialogs/guide.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace view {

void showGuide(QWidget* parent) {
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QCoreApplication::translate("view::Guide", "User Guide"));
    auto* browser = new QTextBrowser(dialog);
    browser->setAccessibleName(dialog->windowTitle());
    browser->setWhatsThis(QCoreApplication::translate(
        "view::Guide", "The user guide: what can be done here, in the order in which one needs it."));
    browser->setOpenExternalLinks(true);
    browser->document()->setDocumentMargin(16);
    browser->setSource(QUrl(QStringLiteral("qrc:/guide/guide.md")));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(browser);
    layout->addWidget(buttons);
    const QSize page(dialog->fontMetrics().averageCharWidth() * 96, dialog->fontMetrics().lineSpacing() * 42);
    dialog->resize(page.boundedTo(dialog->screen()->availableSize()));
    dialog->show();
}

} // namespace view
