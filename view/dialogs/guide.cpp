// SPDX-License-Identifier: MIT
#include "dialogs/guide.h"

#include "document/text/text.h"
#include "io/file/background.h"
#include "widgets/icon.h"
#include "widgets/text/text_edit_workarounds.h"

#include <QAbstractTextDocumentLayout>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFutureWatcher>
#include <QHBoxLayout>
#include <QHash>
#include <QImage>
#include <QImageReader>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr int pageMargin = 16;

struct Picture {
    QUrl name;
    QImage image;
};

QString pathOf(const QUrl& picture) {
    return u':' + picture.path();
}

// A page as wide as its window and no wider: long lines of code are broken, and wide pictures made smaller.
// Pictures are decoded in the background; until they are there, the place of each is kept.
class Page : public TextEditWithWorkarounds<QTextBrowser> {
public:
    explicit Page(QWidget* parent) : TextEditWithWorkarounds(parent) {
        document()->setDocumentMargin(pageMargin);
        document()->setIndentWidth(1.25 * pageMargin);
        setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // keeps the width independent of the height
        connect(&m_decoding, &QFutureWatcherBase::resultReadyAt, this, [this](int i) {
            const Picture picture = m_decoding.resultAt(i);
            m_decoded.insert(picture.name, picture.image);
            document()->addResource(QTextDocument::ImageResource, picture.name, picture.image);
            viewport()->update();
        });
    }
    ~Page() override { m_decoding.cancel(); }

    void open(const QUrl& text) {
        setSource(text);
        QTextCursor cursor(document());
        QTextBlockFormat breakable;
        breakable.setNonBreakableLines(false);
        cursor.select(QTextCursor::Document);
        cursor.mergeBlockFormat(breakable);
    }

    // First visible position. Qt finds it only if the page is laid out completely.
    int top() const {
        document()->documentLayout()->blockBoundingRect(document()->lastBlock());
        return cursorForPosition({0, 0}).position();
    }

    // Scrolls so that the heading becomes the first visible line.
    void showSection(const QString& heading) {
        for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
            if (block.blockFormat().headingLevel() == 0 || block.text() != heading) continue;
            setTextCursor(QTextCursor(block));
            verticalScrollBar()->setValue(int(document()->documentLayout()->blockBoundingRect(block).top()));
            return;
        }
    }

    // Scrolls to a match, with some lines before it, unless it is visible already.
    void scrollTo(const QTextCursor& match) {
        const QRect there = cursorRect(match);
        if (!viewport()->rect().contains(there))
            verticalScrollBar()->setValue(verticalScrollBar()->value() + there.top() -
                                          viewport()->height() / 3);
        setTextCursor(match);
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QList<Picture> wanted;
        for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (const auto format = part.fragment().charFormat().toImageFormat(); format.isValid())
                    wanted << place(source().resolved(QUrl(format.name())));
        for (const auto& [name, image] : wanted)
            document()->addResource(QTextDocument::ImageResource, name, image);
        document()->markContentsDirty(0, document()->characterCount());
        TextEditWithWorkarounds::resizeEvent(event);
        wanted.removeIf(
            [this](const Picture& p) { return m_decoded.value(p.name).size() == p.image.size(); });
        decode(wanted);
    }

    QVariant loadResource(int type, const QUrl& name) override {
        return type == QTextDocument::ImageResource ? QVariant(place(source().resolved(name)).image)
                                                    : TextEditWithWorkarounds::loadResource(type, name);
    }

private:
    // Picture in the size that fits: the available one, stretched, or an empty one.
    Picture place(const QUrl& name) const {
        const int room = viewport()->width() - 2 * pageMargin;
        const QSize whole = QImageReader(pathOf(name)).size();
        const double scale = std::min(1.0, double(room) / whole.width()) * devicePixelRatioF();
        const QSize size = (QSizeF(whole) * scale).toSize().expandedTo({1, 1});
        QImage image(size, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        if (const auto decoded = m_decoded.find(name); decoded != m_decoded.end())
            image = decoded->scaled(size);
        image.setDevicePixelRatio(devicePixelRatioF());
        return {name, image};
    }

    void decode(const QList<Picture>& wanted) {
        m_decoding.cancel();
        m_decoding.setFuture(io::inBackground<Picture>([wanted](QPromise<Picture>& decoded) {
            for (const auto& [name, place] : wanted) {
                if (decoded.isCanceled()) return;
                QImage image = QImage(pathOf(name))
                                   .scaled(place.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
                image.setDevicePixelRatio(place.devicePixelRatio());
                decoded.addResult(Picture{name, image});
            }
        }));
    }

    QFutureWatcher<Picture> m_decoding;
    QHash<QUrl, QImage> m_decoded; // pictures in their last size
};

// Marks the typed words wherever the page has them, and shows one place after the other.
class FindField : public QLineEdit {
public:
    FindField(Page* page, QLabel* count, QWidget* parent) : QLineEdit(parent), m_page(page), m_count(count) {
        setPlaceholderText(Text::tr("Find in the guide"));
        setAccessibleName(placeholderText());
        setWhatsThis(
            Text::tr("Finds these words in the guide. Enter goes to the next match, Shift+Enter to the "
                     "previous one. Ctrl+F comes back here."));
        setClearButtonEnabled(true);
        addAction(icon(QStringLiteral("search")), LeadingPosition);
        connect(this, &QLineEdit::textChanged, this, &FindField::find);
    }

    void step(int by) {
        if (m_matches.isEmpty()) return;
        m_shown = (m_shown + by + m_matches.size()) % m_matches.size();
        mark();
    }

protected:
    void keyPressEvent(QKeyEvent* event) override {
        const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        if (isEnter)
            step(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
        else if (event->key() == Qt::Key_Escape && !text().isEmpty())
            clear();
        else
            QLineEdit::keyPressEvent(event);
    }
    void changeEvent(QEvent* event) override {
        if (event->type() == QEvent::PaletteChange && !m_matches.isEmpty()) mark();
        QLineEdit::changeEvent(event);
    }

private:
    // Finds the first match after the current one, or after the top of the page.
    void find() {
        const int from = m_matches.isEmpty() ? m_page->top() : m_matches[m_shown].selectionStart();
        m_matches.clear();
        m_shown = 0;
        const QString words = text().simplified();
        for (QTextCursor match(m_page->document()); !words.isEmpty();) {
            match = m_page->document()->find(words, match);
            if (match.isNull()) break;
            if (match.selectionStart() < from) ++m_shown;
            m_matches << match;
        }
        if (m_shown == m_matches.size()) m_shown = 0;
        mark();
    }

    void mark() {
        QList<QTextEdit::ExtraSelection> marks;
        for (const QTextCursor& match : m_matches) {
            QTextEdit::ExtraSelection mark{match, {}};
            QColor colour = palette().color(QPalette::Active, QPalette::Highlight);
            if (&match == &m_matches.at(m_shown))
                mark.format.setForeground(palette().color(QPalette::Active, QPalette::HighlightedText));
            else
                colour.setAlphaF(0.3F);
            mark.format.setBackground(colour);
            marks << mark;
        }
        m_page->setExtraSelections(marks);
        if (m_matches.isEmpty()) {
            m_count->setText(text().simplified().isEmpty() ? QString() : Text::tr("Not found"));
            return;
        }
        m_count->setText(Text::tr("%1 of %2").arg(m_shown + 1).arg(m_matches.size()));
        QTextCursor match = m_matches[m_shown];
        match.setPosition(match.selectionStart());
        m_page->scrollTo(match);
    }

    Page* m_page;
    QLabel* m_count;
    QList<QTextCursor> m_matches;
    qsizetype m_shown = 0;
};

// Shows the guide; its parts belong to the dialog.
struct Guide {
    Page* page;
    FindField* field;
};

Guide openGuide(QWidget* parent) {
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(Text::tr("User Guide"));
    auto* browser = new Page(dialog);
    browser->setAccessibleName(dialog->windowTitle());
    browser->setWhatsThis(
        Text::tr("The user guide: what you can do with Barycage, in the order in which you need it."));
    browser->setOpenExternalLinks(true);
    browser->open(QUrl(QStringLiteral("qrc:/guide/guide.md")));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false); // Enter finds the next match
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* count = new QLabel(dialog);
    auto* field = new FindField(browser, count, dialog);
    field->setMinimumWidth(dialog->fontMetrics().averageCharWidth() * 30);
    const auto onKey = [dialog, field](QKeySequence::StandardKey key, auto&& what) {
        QObject::connect(new QShortcut(key, dialog), &QShortcut::activated, field, what);
    };
    onKey(QKeySequence::FindNext, [field] { field->step(1); });
    onKey(QKeySequence::FindPrevious, [field] { field->step(-1); });
    onKey(QKeySequence::Find, [field] {
        field->setFocus();
        field->selectAll();
    });
    auto* foot = new QHBoxLayout;
    foot->addWidget(field);
    foot->addWidget(count);
    foot->addStretch();
    foot->addWidget(buttons);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(browser);
    layout->addLayout(foot);
    browser->setFocus();
    const QSize page(dialog->fontMetrics().averageCharWidth() * 96, dialog->fontMetrics().lineSpacing() * 42);
    dialog->resize(page.boundedTo(dialog->screen()->availableSize()));
    dialog->show();
    return {browser, field};
}

} // namespace

void showGuide(QWidget* parent, const QString& heading) {
    const Guide guide = openGuide(parent);
    if (!heading.isEmpty()) guide.page->showSection(heading);
}

void searchGuide(QWidget* parent, const QString& words) {
    const Guide guide = openGuide(parent);
    guide.field->setText(words);
    guide.field->setFocus();
}

} // namespace view
