// SPDX-License-Identifier: MIT
#pragma once

#include "attractor/tops/picture_patterns.h"

#include <QFutureWatcher>
#include <QObject>
#include <QString>

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
    const QString& wish() const { return m_wish; } // the path, or wishFor() the pattern
    static QString wishFor(attractor::Pattern pattern);

signals:
    void ready(const std::shared_ptr<const attractor::MipPicture>& picture);
    void failed(const QString& sentence);

private:
    struct Outcome {
        Picture picture;
        QString failure;
    };

    QString m_wish;
    QFutureWatcher<Outcome> m_work;
};

} // namespace view
