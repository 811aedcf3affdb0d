// SPDX-License-Identifier: MIT
#include "document/tops/partner_names.h"

#include "document/tops/kept_theft.h"
#include "document/tops/theft_starters.h"
#include "support/named_test.h"

#include <QTest>

using document::EntryId;
using document::FractalFile;

// The partner of a fractal transformation under renaming, copying and moving.
class PartnerNamesTest : public QObject {
    Q_OBJECT

private slots:
    void followsARename() {
        const FractalFile file = family();
        const FractalFile after = document::renamed(file, file.entries[2].id, QStringLiteral("moved"));
        QCOMPARE(after.entries[2].fractal->name, QStringLiteral("moved"));
        QCOMPARE(partnerOf(after, 1), QStringLiteral("moved"));
        // All else stays: the order, the mode and the picture.
        auto kept = document::keptTheft(*file.entries[1].fractal);
        kept->partner = QStringLiteral("moved");
        QCOMPARE(document::keptTheft(*after.entries[1].fractal), kept);
        QCOMPARE(after.entries[0].fractal, file.entries[0].fractal);
    }

    void anotherNameChangesNothingElse() {
        const FractalFile file = family();
        const FractalFile after = document::renamed(file, file.entries[0].id, QStringLiteral("other"));
        QCOMPARE(after.entries[1].fractal, file.entries[1].fractal);
    }

    void comesWithItsPartner() {
        const FractalFile file = family();
        const document::Inserted added =
            document::insertedTogether(file, {file.entries[1], file.entries[2]}, EntryId::None);
        QCOMPARE(added.file.entries.size(), 5);
        const QString name = added.file.entries[4].fractal->name;
        QVERIFY(name != file.entries[2].fractal->name);
        QCOMPARE(partnerOf(added.file, 3), name);
        QCOMPARE(partnerOf(added.file, 1), file.entries[2].fractal->name); // the first pair stays
    }

    void aloneItKeepsTheName() {
        const FractalFile file = family();
        const document::Inserted added = document::insertedTogether(file, {file.entries[1]}, EntryId::None);
        QCOMPARE(partnerOf(added.file, 3), file.entries[2].fractal->name);
    }

    void picturesGetAFullPath() {
        document::KeptTheft theft;
        theft.partner = QStringLiteral("b");
        theft.picture = QStringLiteral("../pictures/a.png");
        const document::Fractal kept = document::withTheft(document::sierpinskiTriangle(), theft);
        const document::Fractal elsewhere = document::withPictureFrom(kept, QStringLiteral("/home/me/ifs"));
        QCOMPARE(document::keptTheft(elsewhere)->picture, QStringLiteral("/home/me/pictures/a.png"));
        QVERIFY(document::withPictureFrom(kept, {}) == kept);
        theft.picture.clear();
        const document::Fractal pattern = document::withTheft(document::sierpinskiTriangle(), theft);
        QVERIFY(document::withPictureFrom(pattern, QStringLiteral("/home/me")) == pattern);
    }

private:
    static FractalFile family() { // a triangle, F and G
        return document::withStarter(document::fileOf(document::sierpinskiTriangle()),
                                     document::TheftFamily::Triangle)
            .file;
    }
    static QString partnerOf(const FractalFile& file, qsizetype index) {
        return document::keptTheft(*file.entries[index].fractal).value_or(document::KeptTheft()).partner;
    }
};

BARYCAGE_TEST(PartnerNamesTest, QCoreApplication);
#include "partner_names_test.moc"
