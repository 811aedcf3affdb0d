// SPDX-License-Identifier: MIT
#include "document/document.h"
#include "document/edits/cage/cage_edits.h"
#include "document/edits/cage/cage_fits.h"
#include "document/fractal/fractal_geometry.h"
#include "ifs/extent/support_function.h"
#include "support/named_test.h"

#include <QGuiApplication>
#include <QSet>
#include <QString>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace document;

class CageFitsTest : public QObject {
    Q_OBJECT

private:
    template <int Dim> static void namesAreUnique() {
        QSet<QString> ids, titles;
        for (const auto& fit : cageFits<Dim>()) {
            if (*fit.id) QVERIFY2(!ids.contains(QString::fromLatin1(fit.id)), fit.id);
            QVERIFY2(*fit.title && !titles.contains(QString::fromUtf8(fit.title)), fit.title);
            ids << QString::fromLatin1(fit.id);
            titles << QString::fromUtf8(fit.title);
            QVERIFY(fit.corners.least <= fit.corners.usual && fit.corners.usual <= fit.corners.most);
            for (const int offered : fit.corners.offered)
                QVERIFY(fit.corners.least <= offered && offered <= fit.corners.most);
        }
    }

private slots:
    void everyFitHasNamesAndCounts() {
        namesAreUnique<2>();
        namesAreUnique<3>();
    }

    // In every direction they reach as far, and they have no more corners than were asked for.
    void polygonsHoldTheAttractor() {
        const Fractal fractal = sierpinskiTriangle();
        const auto support = displayedSupport<2>(fractal);
        QVERIFY(support);
        for (const auto& fit : cageFits<2>()) {
            const auto polygon = verticesAround(fractal, fit.choice, fit.corners.usual);
            QVERIFY2(polygon && polygon->size() >= 3, fit.title);
            QVERIFY2(int(polygon->size()) <= fit.corners.usual, fit.title);
            for (int k = 0; k < 64; ++k) {
                const double angle = 2 * std::numbers::pi * k / 64;
                const ifs::Vector<2> way(std::cos(angle), std::sin(angle));
                double reach = -std::numeric_limits<double>::infinity();
                for (const auto& corner : *polygon)
                    reach = std::max(reach, corner.dot(way));
                QVERIFY2(reach >= (*support)(way).value - 1e-12, fit.title);
            }
        }
    }
};

BARYCAGE_TEST(CageFitsTest, QGuiApplication);
#include "cage_fits_test.moc"
