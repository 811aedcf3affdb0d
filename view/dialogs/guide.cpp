// SPDX-License-Identifier: MIT
#include "dialogs/guide.h"

#include "mended_text.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QImage>
#include <QScreen>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr int margin = 16;

// As wide as its window and no wider: long lines of code are broken, and wide pictures made smaller.
class Page : public MendedText<QTextBrowser> {
public:
    explicit Page(QWidget* parent) : MendedText(parent) {
        document()->setDocumentMargin(margin);
        setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // the width does not depend on the height
    }

    void open(const QUrl& text) {
        setSource(text);
        QTextCursor cursor(document());
        QTextBlockFormat breakable;
        breakable.setNonBreakableLines(false);
        cursor.select(QTextCursor::Document);
        cursor.mergeBlockFormat(breakable);
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        const int room = viewport()->width() - 2 * margin;
        for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (const auto picture = part.fragment().charFormat().toImageFormat(); picture.isValid())
                    fit(source().resolved(QUrl(picture.name())), room);
        document()->markContentsDirty(0, document()->characterCount());
        MendedText::resizeEvent(event);
    }

private:
    void fit(const QUrl& picture, int room) {
        const QImage whole(u':' + picture.path());
        QImage fitted = whole.scaledToWidth(int(std::min(whole.width(), room) * devicePixelRatioF()),
                                            Qt::SmoothTransformation);
        fitted.setDevicePixelRatio(devicePixelRatioF());
        document()->addResource(QTextDocument::ImageResource, picture, fitted);
    }
};

} // namespace

void showGuide(QWidget* parent) {
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QCoreApplication::translate("view::Guide", "User Guide"));
    auto* browser = new Page(dialog);
    browser->setAccessibleName(dialog->windowTitle());
    browser->setWhatsThis(QCoreApplication::translate(
        "view::Guide", "The user guide: what can be done here, in the order in which one needs it."));
    browser->setOpenExternalLinks(true);
    browser->open(QUrl(QStringLiteral("qrc:/guide/guide.md")));
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
