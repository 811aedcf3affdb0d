// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "panels/analysis_facts.h"

#include <QTimer>
#include <QWidget>

class QFormLayout;
class QLabel;
class QToolButton;

namespace view {

// What is known of the code, read-only; computed while the panel is visible and the hand rests.
class AnalysisPanel : public QWidget {
    Q_OBJECT

public:
    explicit AnalysisPanel(document::Document* document, QWidget* parent = nullptr);

    const QList<Fact>& facts() const { return m_facts; }
    void copyAll() const; // one "name<tab>value" a line, all digits

protected:
    void showEvent(QShowEvent* event) override;

private:
    void follow(const document::Change& change);
    void compute();
    void showFacts(const QList<Fact>& facts);
    QString notice() const;

    document::Document* m_document;
    QList<Fact> m_facts;
    QTimer m_settled;
    QLabel* m_notice;
    QWidget* m_box;
    QFormLayout* m_form = nullptr;
    QToolButton* m_copy;
};

} // namespace view
