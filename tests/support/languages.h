// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QString>
#include <QTest>
#include <QTranslator>

namespace support {

// A row for each language of the program, with its code in the column "language".
inline void addLanguages() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "de", "es", "fr", "mk"})
        QTest::newRow(language) << QString::fromLatin1(language);
}

// Texts are in the language while this lives.
class Spoken {
public:
    explicit Spoken(const QString& language)
        : m_isInstalled(m_catalogue.load(QStringLiteral(":/translations/barycage_%1.qm").arg(language)) &&
                        QCoreApplication::installTranslator(&m_catalogue)) {}
    bool isInstalled() const { return m_isInstalled; }

private:
    QTranslator m_catalogue; // removes itself
    bool m_isInstalled;
};

} // namespace support
