// SPDX-License-Identifier: MIT
#pragma once

#include "panels/timeline/timeline_panel.h"
#include "support/own_settings.h"

#include <QTest>

#include <memory>

// Every test has the rows of a new document's timeline.
class TimelineFixture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { support::useOwnSettings(); }
    void init() {
        m_document = std::make_unique<document::Document>();
        m_panel = std::make_unique<view::TimelinePanel>(m_document.get());
        m_panel->resize(900, 300);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
        m_panel->showTracks();
    }
    void cleanup() { m_panel.reset(); }

protected:
    std::unique_ptr<document::Document> m_document;
    std::unique_ptr<view::TimelinePanel> m_panel;
};
