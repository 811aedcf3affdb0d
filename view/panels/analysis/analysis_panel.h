// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "panels/analysis/analysis_facts.h"

#include <QScrollArea>

#include <map>
#include <optional>

class QAction;
class QCheckBox;
class QGridLayout;
class QLabel;
class QSpinBox;
class QToolButton;

namespace view {

class AnalysisBridge;
class BoxCountingPlot;

// Facts of the picture, live during a drag, and the choice of outlines on the canvas. Nothing is computed
// while the panel is hidden.
class AnalysisPanel : public QScrollArea {
    Q_OBJECT

public:
    AnalysisPanel(document::Document* document, AnalysisBridge* bridge, QWidget* parent = nullptr);

    const QList<Fact>& facts() const { return m_facts; }
    QCheckBox* outlineBox(document::Outline kind) const { return m_outlineBoxes.at(kind); }
    // Adds a box that switches the action, and is switched by it.
    void addOutlineAction(QAction* action, const QString& text);
    const BoxCountingPlot& plot() const { return *m_plot; }
    void copyAll(); // one "name<tab>value" a line, all digits

signals:
    void message(const QString& text);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Line {
        QLabel* name;
        QLabel* value;
        std::optional<bool> isBelow = {}; // true: value below its name; false: beside it
    };

    QWidget* makeOutlines();
    void makeLines(qsizetype count);
    void showAnalysis();
    void showNotice();
    void showLines();
    void arrangeLines();
    void colourOutlines();

    document::Document* m_document;
    AnalysisBridge* m_bridge;
    QList<Fact> m_facts;
    QLabel* m_notice;
    QWidget* m_box; // box of the facts
    QGridLayout* m_grid = nullptr;
    QList<Line> m_lines;
    BoxCountingPlot* m_plot;
    QWidget* m_outlines = nullptr;
    std::map<document::Outline, QCheckBox*> m_outlineBoxes;
    QSpinBox* m_depth = nullptr;
    QToolButton* m_copy;
    QToolButton* m_explain;
};

} // namespace view
