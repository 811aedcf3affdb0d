// SPDX-License-Identifier: MIT
#pragma once

#include "document/fractal/fractal.h"
#include "main_window.h"
#include "session/session.h"
#include "support/events.h"
#include "support/own_settings.h"

#include <QApplication>
#include <QTest>

// For tests that open and close windows themselves; none is left to the next one.
class SessionFixture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        support::useOwnSettings();
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void cleanup() { closeWindows(); }

protected:
    static void closeWindows() {
        for (SessionWindow* window : windows())
            delete window;
    }
    static QList<SessionWindow*> windows() { return session::windows(); }
    static MainWindow* shown(const QString& path) {
        auto* window = new MainWindow;
        if (!path.isEmpty()) window->openPath(path);
        window->show();
        return window;
    }
    static document::Fractal pairOfCubes() {
        document::System3 system;
        ifs::append(system, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() / 2, {0, 0, 0}});
        ifs::append(system, ifs::AffineMap<3>{ifs::Matrix<3>::Identity() / 2, {1, 1, 1}});
        document::Fractal solid;
        solid.shape = document::Shape<3>{system};
        return solid;
    }
};
