// SPDX-License-Identifier: MIT
#include "panels/entries_comment_dialog.h"

#include "io/fractint_rows.h"
#include "mended_text.h"
#include "whats_this.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace view {
namespace {

constexpr int longestLine =
    198; // bytes; with the semicolon and the line end it still fits what Fractint reads

bool isOurs(const QString& line) {
    return line.trimmed().startsWith(QLatin1String("barycage:"), Qt::CaseInsensitive);
}

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
      m_lines(new MendedText<QPlainTextEdit>(fractal.comments.join(QLatin1Char('\n')), this)),
      m_problem(new QLabel(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Comment of “%1”").arg(fractal.name));
    m_header->setAccessibleName(tr("Comment behind the name"));
    m_header->setToolTip(tr("Written on the first line of the entry, for example its title or author."));
    m_lines->setAccessibleName(tr("Comment lines"));
    m_lines->setToolTip(tr("Written as lines of their own below the name, each behind a semicolon."));
    m_lines->setTabChangesFocus(true);
    m_problem->setWordWrap(true);
    m_problem->setVisible(false);
    m_problem->setAccessibleName(tr("Reason why the comment cannot be kept"));
    m_buttons->setAccessibleName(tr("Keep or discard the comment"));

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(caption(tr("&Behind the name:"), m_header, this));
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
    // As it will be read from the file: what was pasted may hold line ends and tabs.
    after.headerComment = io::fractint::storedComment(m_header->text());
    after.comments = lines();
    for (QString& line : after.comments)
        line = io::fractint::storedComment(line);
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
        if (isOurs(line))
            problem =
                tr("A comment cannot begin with “barycage:”; such lines keep the cage and the colours.");
        else if (line.toUtf8().size() > longestLine)
            problem = tr("A line holds at most %1 bytes; Fractint cuts longer ones. Break it in two.")
                          .arg(longestLine);
    }
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

} // namespace view
