// SPDX-License-Identifier: MIT
#include "panels/entries/entries_comment_dialog.h"

#include "document/text/user_comments.h"
#include "io/fractint/fractint_rows.h"
#include "widgets/text/text_edit_workarounds.h"
#include "widgets/text/tooltip_text.h"
#include "widgets/whats_this.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace view {
namespace {

constexpr int maxLine = 198; // bytes; with semicolon and line end within what Fractint reads

QLabel* caption(const QString& text, QWidget* buddy, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setBuddy(buddy);
    return label;
}

} // namespace

EntriesCommentDialog::EntriesCommentDialog(const document::Fractal& fractal, QWidget* parent)
    : QDialog(parent),
      m_before(fractal),
      m_header(new QLineEdit(fractal.headerComment, this)),
      m_lines(new TextEditWithWorkarounds<QPlainTextEdit>(
          document::userComments(fractal.comments).join(QLatin1Char('\n')), this)),
      m_problem(new QLabel(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Comment of “%1”").arg(titleText(fractal.name)));
    setWhatsThis(tr("Comments are stored with the entry in the file and do not change the fractal."));
    m_header->setAccessibleName(tr("Title"));
    m_header->setToolTip(tr("Written on the first line of the entry, for example its title or author."));
    m_lines->setAccessibleName(tr("Comment lines"));
    m_lines->setToolTip(tr("Written on separate lines below the name, each after a semicolon."));
    m_lines->setTabChangesFocus(true);
    m_problem->setWordWrap(true);
    m_problem->setVisible(false);
    m_problem->setAccessibleName(tr("Reason why the comment cannot be kept"));
    m_buttons->setAccessibleName(tr("Keep or discard the comment"));

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(caption(tr("&Title:"), m_header, this));
    layout->addWidget(m_header);
    layout->addWidget(caption(tr("Comment &lines:"), m_lines, this));
    layout->addWidget(m_lines, 1);
    layout->addWidget(m_problem);
    layout->addWidget(m_buttons);
    resize(460, 320);

    explainByTips(this);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_header, &QLineEdit::textChanged, this, &EntriesCommentDialog::check);
    connect(m_lines, &QPlainTextEdit::textChanged, this, &EntriesCommentDialog::check);
}

document::Fractal EntriesCommentDialog::fractal() const {
    document::Fractal after = m_before;
    // Comment as the file will return it: pasted text may contain line ends and tabs.
    after.headerComment = io::fractint::storedComment(m_header->text());
    after.comments = lines();
    for (QString& line : after.comments)
        line = io::fractint::storedComment(line);
    if (after.comments == document::userComments(m_before.comments)) {
        after.comments = m_before.comments; // unchanged
        return after;
    }
    for (const QString& kept : m_before.comments)
        if (document::isKeptComment(kept)) after.comments << kept; // not shown here
    return after;
}

QStringList EntriesCommentDialog::lines() const {
    const QString text = m_lines->toPlainText();
    return text.isEmpty() ? QStringList() : text.split(QLatin1Char('\n'));
}

void EntriesCommentDialog::check() {
    QString problem;
    const QStringList all = lines() << m_header->text();
    for (const QString& line : all) {
        if (line.trimmed().startsWith(QLatin1String("barycage:"), Qt::CaseInsensitive))
            problem =
                tr("A comment cannot begin with “barycage:”; such lines store the cage and the colours.");
        else if (line.toUtf8().size() > maxLine)
            problem = tr("A line can have at most %1 bytes; Fractint truncates longer ones. Split it in two.")
                          .arg(maxLine);
    }
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
    if (problem.isEmpty()) emit edited();
}

} // namespace view
