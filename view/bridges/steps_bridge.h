// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/steps/start_shape.h"
#include "document/steps/step_distance.h"
#include "widgets/background/newest_work.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace attractor {
struct Frame;
}

namespace view {

class RenderBridge;

// The starting shape of the deterministic algorithm, and the distance of its steps from the attractor. The
// render bridge draws steps from the cage; those from another shape are drawn here, in the background, and
// replace its pictures.
class StepsBridge : public QObject {
    Q_OBJECT

public:
    enum class Start { Cage, Square, Letter, Picture };

    StepsBridge(document::Document* document, RenderBridge* bridge);
    ~StepsBridge() override;

    // A letter or a picture that is missing leaves the cage.
    Start start() const { return m_start; }
    void setStart(Start start);
    const QString& letter() const { return m_letter; }
    void setLetter(const QString& letter);
    void readPicture(const QString& path); // reads in the background
    const QString& pictureName() const { return m_pictureName; }
    const QString& flaw() const { return m_flaw; } // reason why there is no shape, as a sentence

    void show(std::optional<int> step); // nullopt: hides the steps

    // The distance of the step that is shown, as it was a moment ago; nullopt while nothing is known.
    const std::optional<document::StepDistance>& distance() const { return m_distance; }

signals:
    void changed();

private:
    using ShapePointer = std::shared_ptr<const document::StartShape>;
    struct Read {
        ShapePointer shape; // nullptr: see flaw
        QString name;
        QString flaw;
    };

    void update();
    void findShape();
    void substitute(bool on);
    void requestPicture();
    void requestDistance();
    void finishReading(std::optional<Read> read);

    document::Document* m_document;
    RenderBridge* m_bridge;
    Start m_start = Start::Cage;
    QString m_letter;
    QString m_pictureName;
    QString m_flaw;
    ShapePointer m_picture; // last picture that was read
    ShapePointer m_shape;   // nullptr: the cage
    std::optional<int> m_step;
    bool m_isSubstituting = false;
    std::optional<document::StepDistance> m_distance;
    QTimer m_measuring; // delays the request for the distance
    NewestWork<std::shared_ptr<const attractor::Frame>> m_drawing;
    NewestWork<document::StepDistance> m_distances;
    NewestWork<Read> m_reading;
};

} // namespace view
