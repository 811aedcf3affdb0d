// SPDX-License-Identifier: MIT
#pragma once

#include <QJsonObject>
#include <QTemporaryDir>

class QProcess;

// The numbers of a fact, as a test compares them: to within `tolerance`.
void compare(double actual, double expected, double tolerance);
void compare(const QJsonValue& pair, double x, double y, double tolerance);

// barycage-cli as a black box: arguments in; status, text and files out. The base of the tests of its
// commands: each works in a folder of its own that begins with systems.ifs (the maple, the fern, and one
// without an attractor) and broken.ifs (an entry that can be read, and one that cannot). The application of
// such a test is a QGuiApplication.
class CommandLineTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();

protected:
    struct Result {
        int status = -1; // of a program that did not end by itself
        QByteArray out;
        QByteArray err;

        QJsonObject entry(int index = 0) const; // of what `info --json` printed
    };

    // Arguments as one types them, with double quotes around those that hold spaces. The program runs in the
    // process of the test.
    Result run(const QByteArray& arguments, const QByteArray& input = {}) const;
    // The same in a process, for what concerns one: its environment, limits, signals and its end.
    Result runProgram(const QByteArray& arguments, const QByteArray& input = {}) const;
    void start(QProcess& process, const QByteArray& arguments) const;

    QString path(const QByteArray& name) const;
    void write(const QByteArray& name, const QByteArray& bytes) const;
    QByteArray read(const QByteArray& name) const;
    void makeOld(const QByteArray& name) const; // as if it had been written yesterday

private:
    QTemporaryDir m_folder;
};
