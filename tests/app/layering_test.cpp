// SPDX-License-Identifier: MIT
#include "support/paths.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <map>

// The include directions of the architecture: each layer may know those below it and nothing else.
class LayeringTest : public QObject {
    Q_OBJECT

private slots:
    void includesPointDownwards_data();
    void includesPointDownwards();
    void coreCompilesWithoutQt();
    void viewStartsNoThread();
};

namespace {

QStringList sourceFiles(const QString& folder) {
    QStringList files;
    QDirIterator it(support::sourcePath(folder), {QStringLiteral("*.h"), QStringLiteral("*.cpp")},
                    QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext())
        files << it.next();
    return files;
}

QString contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

void LayeringTest::includesPointDownwards_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QStringList>("mayKnow");
    QTest::addColumn<QString>("mustNotInclude");

    const QString qt = QStringLiteral("^Q");
    const QString widgets = QStringLiteral("^(QtWidgets|QWidget|QDialog|QMainWindow|QGraphics|QApplication|"
                                           "QMenu|QLabel|QAbstractItemView|QPrint)");
    const QStringList ifs{QStringLiteral("ifs")};
    const QStringList attractor = ifs + QStringList{QStringLiteral("attractor")};
    const QStringList document = attractor + QStringList{QStringLiteral("document")};
    const QStringList io = document + QStringList{QStringLiteral("io")};
    const QStringList view = io + QStringList{QStringLiteral("canvas"), QStringLiteral("panels"),
                                              QStringLiteral("dialogs"), QString()};
    QTest::newRow("model/ifs") << "model/ifs" << ifs << qt;
    QTest::newRow("model/attractor") << "model/attractor" << attractor << qt;
    QTest::newRow("model/document") << "model/document" << document << widgets;
    QTest::newRow("model/io") << "model/io" << io << widgets;
    QTest::newRow("view") << "view" << view << QStringLiteral("^$");
}

void LayeringTest::includesPointDownwards() {
    QFETCH(QString, folder);
    QFETCH(QStringList, mayKnow);
    QFETCH(QString, mustNotInclude);

    const QStringList files = sourceFiles(folder);
    QVERIFY2(!files.isEmpty(), "the folder has no sources: the test looks at the wrong place");
    static const QRegularExpression include(QStringLiteral("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]"),
                                            QRegularExpression::MultilineOption);
    const QRegularExpression forbidden(mustNotInclude);
    for (const QString& path : files) {
        auto matches = include.globalMatch(contents(path));
        while (matches.hasNext()) {
            const auto match = matches.next();
            const QString header = match.captured(2);
            if (match.captured(1) == QLatin1String("<")) {
                QVERIFY2(!forbidden.match(header).hasMatch(),
                         qPrintable(path + QStringLiteral(" includes <%1>").arg(header)));
                continue;
            }
            const QString layer = header.contains(u'/') ? header.section(u'/', 0, 0) : QString();
            if (header.endsWith(QLatin1String(".moc"))) continue;
            QVERIFY2(mayKnow.contains(layer),
                     qPrintable(path + QStringLiteral(" includes \"%1\"").arg(header)));
        }
    }
}

void LayeringTest::coreCompilesWithoutQt() {
    QFile file(QStringLiteral(BARYCAGE_BUILD_DIR "/compile_commands.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    int seen = 0;
    for (const QJsonValue& entry : QJsonDocument::fromJson(file.readAll()).array()) {
        const QString path = entry[QLatin1String("file")].toString();
        if (!path.contains(QLatin1String("/model/ifs/")) &&
            !path.contains(QLatin1String("/model/attractor/")))
            continue;
        if (!path.startsWith(support::sourcePath(QStringLiteral("model/")))) continue;
        ++seen;
        QVERIFY2(!entry[QLatin1String("command")].toString().contains(QLatin1String("QtCore")),
                 qPrintable(path));
    }
    QVERIFY(seen > 0);
}

void LayeringTest::viewStartsNoThread() {
    static const QRegularExpression thread(QStringLiteral(
        "\\b(std::j?thread|std::async|QThread(?!::currentThread)|QThreadPool|QtConcurrent)\\b"));
    const QStringList files = sourceFiles(QStringLiteral("view"));
    QVERIFY(!files.isEmpty());
    for (const QString& path : files)
        QVERIFY2(!thread.match(contents(path)).hasMatch(), qPrintable(path));
}

QTEST_APPLESS_MAIN(LayeringTest)
#include "layering_test.moc"
