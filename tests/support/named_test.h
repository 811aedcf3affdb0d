// SPDX-License-Identifier: MIT
#pragma once

#include <QTest>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
#elif defined(QT_GUI_LIB)
#include <QGuiApplication>
#endif

#include <type_traits>

/// @file
/// A program of tests holds the test classes of many files, and runs one of them in a process: that whose
/// file its first argument names. `io_tests number_test decimals -v2` runs one function of `number_test.cpp`.

namespace support {

/// What a program does when its first argument is the name of a file of tests, without the folder and `.cpp`.
/// The program's other arguments follow the name, which stands where main() has the name of the program.
class NamedTest {
public:
    using Run = int (*)(int argc, char** argv);

    NamedTest(const char* file, Run run);
};

struct NoApplication {
    NoApplication(int& /*argc*/, char** /*argv*/) {}
};

template <class Test, class Application = NoApplication> int runTest(int argc, char** argv) {
    [[maybe_unused]] const Application application(argc, argv);
#ifdef QT_GUI_LIB
    if constexpr (std::is_base_of_v<QGuiApplication, Application>)
        QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
#endif
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace support

/// BARYCAGE_TEST(Class) or BARYCAGE_TEST(Class, Application): in place of QTEST_APPLESS_MAIN and its kin.
#define BARYCAGE_TEST(...) BARYCAGE_NAMED_TEST(__COUNTER__, support::runTest<__VA_ARGS__>)
#define BARYCAGE_NAMED_TEST(number, ...) BARYCAGE_NUMBERED_TEST(number, (__VA_ARGS__))
#define BARYCAGE_NUMBERED_TEST(number, run) static const support::NamedTest namedTest##number(__FILE__, run)
