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

namespace view {

// Pictures to steal colours from, read or drawn in the background. The newest wish wins.
class PictureSource : public QObject {
    Q_OBJECT

public:
    using Picture = std::shared_ptr<const attractor::MipPicture>;

    explicit PictureSource(QObject* parent = nullptr);
    ~PictureSource() override;

    void draw(attractor::Pattern pattern);
    void read(const QString& path);                // absolute
    void decode(const QByteArray& file);           // of a picture
    const QString& wish() const { return m_wish; } // the path, or wishFor() the rest
    static QString wishFor(attractor::Pattern pattern);
    static QString wishFor(const QByteArray& file);

signals:
    void ready(const std::shared_ptr<const attractor::MipPicture>& picture);
    void failed(const QString& sentence);

private:
    struct Outcome {
        Picture picture;
        QString failure;
    };

    void wait(io::Lane lane, std::function<io::ReadPicture()> reader);

    QString m_wish;
    QFutureWatcher<Outcome> m_work;
};

} // namespace view
