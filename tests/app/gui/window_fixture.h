// SPDX-License-Identifier: MIT
#pragma once

#include "main_window.h"
#include "support/own_settings.h"
#include "support/patient_tries.h"

#include <QApplication>

#include <memory>

// Every test has a window with the first picture, as if the program had never run before.
class WindowFixture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QApplication::setQuitOnLastWindowClosed(false); }
    void init() {
        support::useOwnSettings();
        m_window = std::make_unique<MainWindow>();
        m_window->setAttribute(Qt::WA_DeleteOnClose, false);
        m_window->resize(1280, 800);
        m_window->openFirstPicture();
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }
    void cleanup() { m_window.reset(); }

protected:
    std::unique_ptr<MainWindow> m_window;
};
