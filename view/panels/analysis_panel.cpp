// SPDX-License-Identifier: MIT
#include "panels/analysis_panel.h"

#include "cage_edits.h"

#include <QClipboard>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QShowEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <chrono>

namespace view {

namespace {

constexpr std::chrono::milliseconds restPause{200};

} // namespace

AnalysisPanel::AnalysisPanel(document::Document* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_notice(new QLabel(this)),
      m_box(new QWidget(this)),
      m_copy(new QToolButton(this)) {
    setAccessibleName(tr("Analysis"));
    m_notice->setWordWrap(true);
    m_notice->setForegroundRole(QPalette::PlaceholderText);
    m_copy->setText(tr("Copy All"));
    m_copy->setToolTip(tr("Copy all facts with all digits"));
    m_copy->setAutoRaise(true);
    connect(m_copy, &QToolButton::clicked, this, &AnalysisPanel::copyAll);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    layout->addWidget(m_notice);
    layout->addWidget(m_box);
    layout->addWidget(m_copy, 0, Qt::AlignLeft);
    layout->addStretch();
    m_form = new QFormLayout(m_box);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(8);
    m_form->setHorizontalSpacing(16);
    m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_settled.setSingleShot(true);
    m_settled.setInterval(restPause);
    connect(&m_settled, &QTimer::timeout, this, &AnalysisPanel::compute);
    connect(document, &document::Document::changed, this, &AnalysisPanel::follow);
}

void AnalysisPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_settled.start(0);
}

void AnalysisPanel::follow(const document::Change& change) {
    using document::Change;
    if (isVisible() &&
        change.parts & (Change::System | Change::Cage | Change::Entries | Change::Current | Change::File))
        m_settled.start(restPause);
}

void AnalysisPanel::compute() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) return m_settled.start(restPause); // still held
    showFacts(analysisFacts(m_document->fractal()));
}

QString AnalysisPanel::notice() const {
    const document::Fractal& fractal = m_document->fractal();
    if (document::dimension(fractal) == 3) return tr("3D: not yet shown.");
    if (document::dimension(fractal) == 0)
        return tr("This entry could not be read, so nothing is known of it.");
    return isAtRest(fractal)
               ? QString()
               : tr("The picture is placed by its cage; these are facts of the code. Bake to see those "
                    "of the picture.");
}

void AnalysisPanel::showFacts(const QList<Fact>& facts) {
    m_notice->setText(notice());
    m_notice->setVisible(!m_notice->text().isEmpty());
    m_copy->setVisible(!facts.isEmpty());
    if (facts.size() != m_form->rowCount()) {
        while (m_form->rowCount() > 0)
            m_form->removeRow(0);
        for (qsizetype i = 0; i < facts.size(); ++i) {
            auto* name = new QLabel(m_box);
            name->setForegroundRole(QPalette::PlaceholderText);
            auto* value = new QLabel(m_box);
            value->setWordWrap(true);
            value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
            value->setContextMenuPolicy(Qt::CustomContextMenu);
            connect(value, &QWidget::customContextMenuRequested, this, [this, i, value](const QPoint& place) {
                QMenu menu(value);
                menu.addAction(tr("Copy with All Digits"),
                               [this, i] { QGuiApplication::clipboard()->setText(m_facts.value(i).exact); });
                menu.addAction(tr("Copy All Facts"), this, &AnalysisPanel::copyAll);
                menu.exec(value->mapToGlobal(place));
            });
            m_form->addRow(name, value);
        }
    }
    m_facts = facts;
    for (int row = 0; row < m_form->rowCount(); ++row) {
        const Fact& fact = m_facts.at(row);
        auto* name = static_cast<QLabel*>(m_form->itemAt(row, QFormLayout::LabelRole)->widget());
        auto* value = static_cast<QLabel*>(m_form->itemAt(row, QFormLayout::FieldRole)->widget());
        name->setText(fact.name);
        name->setToolTip(fact.definition);
        value->setText(fact.value);
        value->setToolTip(fact.definition);
        value->setAccessibleName(fact.name);
        value->setAccessibleDescription(fact.definition);
    }
}

void AnalysisPanel::copyAll() const {
    QStringList lines;
    for (const Fact& fact : m_facts)
        lines << fact.name + u'\t' + fact.exact;
    QGuiApplication::clipboard()->setText(lines.join(u'\n'));
}

} // namespace view
