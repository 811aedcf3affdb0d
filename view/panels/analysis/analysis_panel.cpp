// SPDX-License-Identifier: MIT
#include "panels/analysis/analysis_panel.h"

#include "bridges/analysis_bridge.h"
#include "canvas/items/analysis_item.h"
#include "canvas/items/overlay_style.h"
#include "dialogs/guide.h"
#include "panels/analysis/box_counting_plot.h"
#include "widgets/numbers/number_box.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTextLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace view {

namespace {

constexpr int deepest = 12; // symbols of a cylinder; fewer if there are too many cylinders

constexpr int lineSpacing = 8; // pixels between facts

// The line as it is on the canvas.
QIcon swatch(const QColor& colour, const QColor& backdrop) {
    QPixmap pixmap(32, 32);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(backdrop);
    painter.drawRoundedRect(1, 5, 30, 22, 4, 4);
    painter.fillRect(5, 13, 22, 6, colour);
    return pixmap;
}

// The text without line breaks inside the brackets of a pair of numbers; those of a remark are as long as a
// sentence.
QString unbroken(QString text) {
    static const QRegularExpression brackets(QStringLiteral("[(\\[][^()\\[\\]]*[)\\]]"));
    static const QRegularExpression word(QStringLiteral("\\p{L}{2}"));
    for (auto each = brackets.globalMatch(text); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        if (match.captured().contains(word)) continue;
        for (qsizetype i = match.capturedStart(); i < match.capturedEnd(); ++i)
            if (text[i] == u' ') text[i] = QChar::Nbsp;
    }
    return text;
}

// The width of the widest piece that no line ends in.
int widestPiece(const QLabel& label) {
    QTextLayout layout(label.text(), label.font());
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    return int(std::ceil(layout.minimumWidth())) + 1;
}

} // namespace

AnalysisPanel::AnalysisPanel(document::Document* document, AnalysisBridge* bridge, QWidget* parent)
    : QScrollArea(parent), m_document(document), m_bridge(bridge) {
    setAccessibleName(tr("Analysis"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus); // its fields take the focus
    auto* content = new QWidget(this);
    m_notice = new QLabel(content);
    m_notice->setWordWrap(true);
    m_notice->setForegroundRole(QPalette::PlaceholderText);
    m_box = new QWidget(content);
    m_grid = new QGridLayout(m_box);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setVerticalSpacing(0); // values may be directly below their names
    m_grid->setHorizontalSpacing(16);
    m_grid->setColumnStretch(1, 1);
    m_plot = new BoxCountingPlot(content);
    m_copy = new QToolButton(content);
    m_copy->setText(tr("Copy All"));
    m_copy->setToolTip(tr("Copy all properties at full precision"));
    m_copy->setWhatsThis(tr("Copies the name and the value of every line, at full precision."));
    m_copy->setAutoRaise(true);
    connect(m_copy, &QToolButton::clicked, this, &AnalysisPanel::copyAll);
    m_explain = new QToolButton(content);
    m_explain->setText(tr("How Pieces Meet…"));
    m_explain->setToolTip(tr("Read in the user guide what these properties mean and how they are proved"));
    m_explain->setWhatsThis(
        tr("Opens the user guide where it explains how the pieces of an attractor meet."));
    m_explain->setAutoRaise(true);
    connect(m_explain, &QToolButton::clicked, this,
            [this] { showGuide(window(), QStringLiteral("How pieces meet")); });
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(10);
    layout->addWidget(m_notice);
    layout->addWidget(makeOutlines());
    layout->addWidget(m_box);
    layout->addWidget(m_plot);
    layout->addWidget(m_explain, 0, Qt::AlignLeft);
    layout->addWidget(m_copy, 0, Qt::AlignLeft);
    layout->addStretch();
    setWidget(content);
    connect(bridge, &AnalysisBridge::changed, this, &AnalysisPanel::showAnalysis);
    connect(bridge, &AnalysisBridge::outlinesChosen, this, [this] {
        for (const auto& [kind, box] : m_outlineBoxes)
            box->setChecked(m_bridge->outlined().contains(kind));
        m_depth->setValue(m_bridge->cylinderDepth());
    });
    connect(document, &document::Document::changed, this, &AnalysisPanel::showNotice);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (change.parts & (Change::Appearance | Change::Current | Change::File)) colourOutlines();
    });
    showAnalysis();
}

QWidget* AnalysisPanel::makeOutlines() {
    using document::Outline;
    m_outlines = new QWidget(this);
    auto* grid = new QGridLayout(m_outlines);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(6);
    auto* title = new QLabel(tr("On the canvas"), m_outlines);
    m_outlines->setAccessibleName(title->text());
    title->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(title, 0, 0, 1, 2);
    const auto add = [&](Outline kind, const QString& text, const QString& tip, int row, int column) {
        auto* box = new QCheckBox(text, m_outlines);
        box->setToolTip(tip);
        connect(box, &QCheckBox::toggled, this,
                [this, kind](bool checked) { m_bridge->setOutlined(kind, checked); });
        m_outlineBoxes[kind] = box;
        grid->addWidget(box, row, column);
    };
    add(Outline::Box, tr("Box"), tr("Outline the certified bounding box"), 1, 0);
    add(Outline::Hull, tr("Hull"), tr("Outline the convex hull"), 1, 1);
    add(Outline::Simplex, tr("Simplex"), tr("Outline the minimal canonical simplex"), 2, 0);
    add(Outline::Ellipse, tr("Ellipse"), tr("Show the mean and the covariance ellipse"), 2, 1);
    add(Outline::FixedPoints, tr("Fixed points"), tr("Mark the fixed point of each map in its colour"), 3, 0);
    add(Outline::Cylinders, tr("Cylinders"),
        tr("Outline the hulls of all pieces with addresses of the same length, each in the colour of its "
           "first map; click one to see its address"),
        3, 1);
    auto* depth = new QWidget(m_outlines);
    auto* line = new QHBoxLayout(depth);
    line->setContentsMargins(0, 0, 0, 0);
    m_depth = new WholeNumberBox(depth);
    m_depth->setRange(1, deepest);
    m_depth->setAccessibleName(tr("Length of the addresses"));
    m_depth->setToolTip(tr("The number of symbols in the addresses of the cylinders; fewer if there would be "
                           "thousands of cylinders"));
    auto* label = new QLabel(tr("Address length"), depth);
    label->setBuddy(m_depth);
    line->addWidget(label);
    line->addWidget(m_depth);
    line->addStretch();
    depth->setVisible(false);
    connect(m_depth, &QSpinBox::valueChanged, m_bridge, &AnalysisBridge::setCylinderDepth);
    connect(m_outlineBoxes[Outline::Cylinders], &QCheckBox::toggled, depth, &QWidget::setVisible);
    grid->addWidget(depth, 4, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    colourOutlines();
    return m_outlines;
}

void AnalysisPanel::addOutlineAction(QAction* action, const QString& text) {
    auto* box = new QCheckBox(text, m_outlines);
    box->setChecked(action->isChecked());
    const auto follow = [box, action] {
        box->setEnabled(action->isEnabled());
        box->setToolTip(action->toolTip());
        box->setWhatsThis(action->whatsThis());
    };
    follow();
    connect(box, &QCheckBox::toggled, action, &QAction::setChecked);
    connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
    connect(action, &QAction::changed, box, follow);
    auto* grid = static_cast<QGridLayout*>(m_outlines->layout());
    grid->addWidget(box, grid->rowCount(), 0, 1, 2);
}

void AnalysisPanel::colourOutlines() {
    const OverlayStyle style = overlayStyle(m_document->fractal().appearance.background, palette());
    for (const auto& [kind, box] : m_outlineBoxes)
        if (kind != document::Outline::FixedPoints && kind != document::Outline::Cylinders)
            box->setIcon(swatch(outlineColour(kind, style.onDark), style.backdrop));
}

void AnalysisPanel::changeEvent(QEvent* event) {
    QScrollArea::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) colourOutlines();
    if (event->type() == QEvent::FontChange) arrangeLines();
}

void AnalysisPanel::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    arrangeLines();
}

void AnalysisPanel::showEvent(QShowEvent* event) {
    QScrollArea::showEvent(event);
    m_bridge->setWatched(true);
    showAnalysis();
}

void AnalysisPanel::hideEvent(QHideEvent* event) {
    QScrollArea::hideEvent(event);
    m_bridge->setWatched(false);
}

void AnalysisPanel::showNotice() {
    const document::Fractal& fractal = m_document->fractal();
    const auto analysis = m_bridge->analysis();
    QString text;
    if (document::dimension(fractal) == 0)
        text = tr("This entry could not be read, so it cannot be analysed.");
    else if (analysis && analysis->isOfCode)
        text = tr("The cage bends the picture, and no system produces a bent picture. These are the "
                  "properties of the code; on the canvas, the outlines bend with the picture.");
    else if (analysis && analysis->hasMovedBranches)
        text = tr("Branches are moved. Box, simplex, hull, mean and covariance are those of the picture; the "
                  "other properties are those of the code.");
    m_notice->setText(text);
    m_notice->setVisible(!text.isEmpty());
    m_outlines->setVisible(document::dimension(fractal) != 0);
}

void AnalysisPanel::showAnalysis() {
    showNotice();
    if (!isVisible()) return;
    const auto analysis = m_bridge->analysis();
    QList<Fact> facts = analysis ? analysisFacts(analysis) : QList<Fact>();
    // Keeps the previous value of facts still being computed.
    for (qsizetype k = 0; k < facts.size() && k < m_facts.size(); ++k)
        if (facts[k].isPending && facts[k].name == m_facts[k].name) {
            facts[k].value = m_facts[k].value;
            facts[k].exact = m_facts[k].exact;
        }
    m_facts = facts;
    m_box->setVisible(analysis != nullptr);
    m_copy->setVisible(analysis != nullptr);
    m_explain->setVisible(analysis != nullptr);
    m_plot->setCounting(analysis ? analysis->boxCounting : std::nullopt, analysis && !analysis->isComplete);
    if (!analysis) return;
    if (m_lines.size() < facts.size()) makeLines(facts.size());
    showLines();
}

void AnalysisPanel::makeLines(qsizetype count) {
    for (qsizetype i = m_lines.size(); i < count; ++i) {
        auto* name = new QLabel(m_box);
        name->setForegroundRole(QPalette::PlaceholderText);
        name->setWordWrap(true);
        name->setAlignment(Qt::AlignLeading | Qt::AlignTop); // level with the first line of the value
        auto* value = new QLabel(m_box);
        value->setWordWrap(true);
        value->setAlignment(Qt::AlignLeading | Qt::AlignTop);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        value->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(value, &QWidget::customContextMenuRequested, this, [this, i, value](const QPoint& position) {
            QMenu menu(value);
            menu.addAction(tr("Copy at Full Precision"),
                           [this, i] { QGuiApplication::clipboard()->setText(m_facts.at(i).exact()); });
            menu.addAction(tr("Copy All"), this, &AnalysisPanel::copyAll);
            menu.exec(value->mapToGlobal(position));
        });
        m_lines << Line{name, value};
    }
}

void AnalysisPanel::showLines() {
    for (qsizetype row = 0; row < m_lines.size(); ++row) {
        const auto [name, value, isBelow] = m_lines.at(row);
        const bool isUsed = row < m_facts.size(); // fewer lines in space
        name->setVisible(isUsed);
        value->setVisible(isUsed);
        if (!isUsed) {
            name->clear();
            value->clear();
            continue;
        }
        const Fact& fact = m_facts.at(row);
        const bool isEmpty = fact.value.isEmpty();
        const QString state = fact.isPending ? tr("This value is still being computed.")
                              : isEmpty      ? fact.absence
                                             : QString();
        const QString tip =
            state.isEmpty() ? fact.definition : state + QStringLiteral("\n\n") + fact.definition;
        name->setText(fact.name);
        name->setToolTip(fact.definition);
        value->setText(!isEmpty         ? unbroken(fact.value)
                       : fact.isPending ? tr("computing…")
                                        : QStringLiteral("–"));
        value->setForegroundRole(fact.isPending ? QPalette::PlaceholderText : QPalette::WindowText);
        value->setToolTip(tip);
        value->setAccessibleName(fact.name);
        value->setAccessibleDescription(tip);
    }
    arrangeLines();
}

// Puts a value beside its name if it has room there, else below it. No digit is ever cut off: for a number
// that is too wide even so, there is a scroll bar.
void AnalysisPanel::arrangeLines() {
    const QMargins margins = widget()->layout()->contentsMargins();
    const int room = viewport()->width() - margins.left() - margins.right();
    int whole = 0;
    int least = 0;
    for (const Line& line : std::as_const(m_lines)) {
        whole = std::max(whole, line.name->fontMetrics().horizontalAdvance(line.name->text()) + 2);
        least = std::max(least, widestPiece(*line.name));
    }
    const int names = std::clamp(room * 2 / 5, least, whole);
    const int values = room - names - m_grid->horizontalSpacing();
    for (int row = 0; row < m_lines.size(); ++row) {
        auto& [name, value, isBelow] = m_lines[row];
        const int needed = widestPiece(*value);
        name->setFixedWidth(names);
        value->setMinimumWidth(needed);
        if (isBelow == (needed > values)) continue;
        isBelow = needed > values;
        m_grid->removeWidget(name);
        m_grid->removeWidget(value);
        m_grid->addWidget(name, 3 * row, 0);
        if (*isBelow)
            m_grid->addWidget(value, 3 * row + 1, 0, 1, 2);
        else
            m_grid->addWidget(value, 3 * row, 1);
        m_grid->setRowMinimumHeight(3 * row + 2, row + 1 < m_lines.size() ? lineSpacing : 0);
    }
}

void AnalysisPanel::copyAll() {
    QStringList lines;
    for (const Fact& fact : m_facts)
        if (!fact.value.isEmpty()) lines << fact.name + u'\t' + fact.exact();
    QGuiApplication::clipboard()->setText(lines.join(u'\n'));
    emit message(tr("Copied."));
}

} // namespace view
