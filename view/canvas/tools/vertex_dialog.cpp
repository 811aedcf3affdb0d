// SPDX-License-Identifier: MIT
#include "canvas/tools/vertex_dialog.h"

#include "document/edits/cage/cage_actions.h"
#include "document/edits/cage/cage_edits.h"
#include "document/fractal/fractal.h"
#include "document/fractal/fractal_geometry.h"
#include "io/text/number.h"
#include "widgets/layout/grow_to_fit.h"
#include "widgets/numbers/number_text.h"
#include "widgets/whats_this.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace view {

namespace {

constexpr int letters = 40; // width in letters, with room for the title and for messages

} // namespace

VertexDialog::VertexDialog(document::Document* document, int index, QWidget* parent)
    : QDialog(parent),
      m_document(document),
      m_index(index),
      m_gesture(document->beginGesture(tr("Move vertex %1").arg(index + 1))),
      m_x(new QLineEdit),
      m_y(new QLineEdit),
      m_problem(new QLabel) {
    setWindowTitle(tr("Vertex %1").arg(index + 1));
    const ifs::Vector<2> position =
        document::effectiveCage(m_gesture.before()).current.at(std::size_t(index));
    m_x->setText(QString::fromLatin1(io::formatNumber(position.x())));
    m_y->setText(QString::fromLatin1(io::formatNumber(position.y())));
    m_x->setAccessibleName(tr("x of the vertex"));
    m_x->setWhatsThis(
        tr("A coordinate of the vertex, with a decimal point or comma. The picture follows as you type."));
    m_y->setAccessibleName(tr("y of the vertex"));
    m_y->setWhatsThis(
        tr("A coordinate of the vertex, with a decimal point or comma. The picture follows as you type."));
    m_problem->setAccessibleName(tr("Problem with the numbers"));
    m_problem->setWordWrap(true);
    setMinimumWidth(letters * fontMetrics().averageCharWidth());

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_accept = buttons->button(QDialogButtonBox::Ok);
    auto* layout = new QFormLayout(this);
    layout->addRow(tr("&x"), m_x);
    layout->addRow(tr("&y"), m_y);
    layout->addRow(m_problem);
    layout->addRow(buttons);
    m_x->selectAll();

    explainByTips(this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_x, &QLineEdit::textEdited, this, &VertexDialog::follow);
    connect(m_y, &QLineEdit::textEdited, this, &VertexDialog::follow);
}

void VertexDialog::follow() {
    const std::optional<double> x = typedNumber(m_x->text());
    const std::optional<double> y = typedNumber(m_y->text());
    const QString obstacle = document::moveCageObstacle(*m_document);
    m_accept->setEnabled(x && y && obstacle.isEmpty());
    m_problem->setText(x && y ? obstacle
                              : tr("“%1” is not a number. Write it with a decimal point, for example -0.25.")
                                    .arg(x ? m_y->text() : m_x->text()));
    growToFit(*this);
    if (!m_accept->isEnabled() || !m_gesture.isOpen()) return;
    document::Fractal fractal = m_gesture.before();
    ifs::ControlCage<2> cage = document::effectiveCage(fractal);
    if (cage.current[std::size_t(m_index)] != ifs::Vector<2>(*x, *y)) {
        cage.current[std::size_t(m_index)] = {*x, *y};
        m_gesture.describe(
            tr("Move vertex %1 to (%2, %3)").arg(m_index + 1).arg(shortNumber(*x), shortNumber(*y)));
        fractal = withCageMoved(std::move(fractal), std::move(cage), m_document->cageMode());
    }
    m_gesture.preview(std::move(fractal));
}

void VertexDialog::done(int result) {
    if (result == QDialog::Accepted)
        m_gesture.commit();
    else
        m_gesture.cancel();
    QDialog::done(result);
}

} // namespace view
