// SPDX-License-Identifier: MIT
#include "animation/motions/motion_fields.h"
#include "support/named_test.h"

#include <QtTest>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <variant>

using namespace animation;

namespace {

// How many fields of each kind a motion has.
struct CountedFields {
    int ids = 0, pivots = 0, others = 0;

    void maps(const auto&) { ++ids; }
    void pivot(const auto&) { ++pivots; }
    void count(const auto&) { ++others; }
    void strength(const auto&) { ++others; }
    void axis(const auto&...) { ++others; }
    void waves(const auto&) { ++others; }
};

} // namespace

class MotionFieldsTest : public QObject {
    Q_OBJECT

private:
    template <int Dim, std::size_t... K> static void check(std::index_sequence<K...>) {
        std::set<std::string> ids;
        for (const Motion<Dim>& motion : {Motion<Dim>(std::variant_alternative_t<K, Motion<Dim>>())...}) {
            const std::string id(idOf<Dim>(motion));
            QVERIFY2(ids.insert(id).second, id.c_str());
            const auto again = motionNamed<Dim>(id);
            QVERIFY2(again && again->index() == motion.index(), id.c_str());
            CountedFields fields;
            listFields(motion, fields);
            QVERIFY2(fields.others > 0, id.c_str());
            // What moves maps moves them about a point.
            QVERIFY2(fields.ids <= fields.pivots && fields.pivots <= 1, id.c_str());
        }
        QVERIFY(!motionNamed<Dim>("") && !motionNamed<Dim>("swa") && !motionNamed<Dim>("Sway"));
    }

private slots:
    void everyMotionIsFoundByItsName() {
        check<2>(std::make_index_sequence<std::variant_size_v<Motion<2>>>());
        check<3>(std::make_index_sequence<std::variant_size_v<Motion<3>>>());
    }

    void fieldsOfAMotionAreItsMembers() {
        Motion<2> motion = Breathe<2>{{}, 0.25, 3, {1, 2}};
        struct : SkippedFields {
            int cycles = 0;
            double share = 0;
            void count(int& number) { cycles = number; }
            void strength(double& number) { share = std::exchange(number, 0.5); }
        } found;
        listFields(motion, found);
        QCOMPARE(found.cycles, 3);
        QCOMPARE(found.share, 0.25);
        QCOMPARE(std::get<Breathe<2>>(motion).strength, 0.5);
    }
};

BARYCAGE_TEST(MotionFieldsTest);
#include "motion_fields_test.moc"
