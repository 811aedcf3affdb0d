// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/picture_patterns.h"
#include "io/file/background.h"
#include "io/tops/picture_reader.h"

#include <QByteArray>
#include <QFutureWatcher>
#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <stop_token>

namespace view {

// Pictures to steal colours from, read or drawn in the background. The newest wish wins.
class PictureSource : public QObject {
    Q_OBJECT

public:
    using Picture = std::shared_ptr<const attractor::MipPicture>;

    explicit PictureSource(QObject* parent = nullptr);
    ~PictureSource() override;

    void draw(attractor::Pattern pattern);
    void read(const QString& path); // absolute path
    // The same of what a file in the folder names: foreign(), and nothing is read, where it is foreign.
    void readNamed(const QString& folder, const QString& path);
    void decode(const QByteArray& file); // bytes of a picture file
    void forget();
    const QString& wish() const { return m_wish; } // absolute path, or wishFor() embedded pictures
    // Returns true if the path leads out of the folder, which is empty if the file is in none. This asks the
    // disk.
    static bool isForeign(const QString& folder, const QString& path);
    static QString absolutePath(const QString& folder, const QString& path);
    static QString wishFor(attractor::Pattern pattern);
    static QString wishFor(const QByteArray& file);

signals:
    void ready(const std::shared_ptr<const attractor::MipPicture>& picture);
    void failed(const QString& sentence);
    void foreign();

private:
    struct Outcome {
        Picture picture;
        QString failure;
        bool isForeign = false;
    };
    using Reader = std::function<io::ReadPicture(const std::stop_token&)>;

    void wait(io::Lane lane, Reader reader, std::function<bool()> isForeign = nullptr);

    QString m_wish;
    QFutureWatcher<Outcome> m_work;
    std::stop_source m_stop; // stops the reading
};

} // namespace view
