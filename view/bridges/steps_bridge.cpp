// SPDX-License-Identifier: MIT
#include "bridges/steps_bridge.h"

#include "bridges/render_bridge.h"
#include "document/steps/step_picture.h"
#include "io/file/save_file.h"
#include "io/picture/decoding/grey_picture.h"

#include <QFileInfo>

#include <utility>

namespace view {

namespace {

constexpr int stepsPatience = 30; // milliseconds reserved for the picture before the distance is measured

} // namespace

StepsBridge::StepsBridge(document::Document* document, RenderBridge* bridge)
    : m_document(document),
      m_bridge(bridge),
      m_letter(QStringLiteral("R")), // asymmetric, so that rotations and reflections are visible
      m_drawing([this](std::optional<std::shared_ptr<const attractor::Frame>> frame) {
          if (frame && m_isSubstituting) m_bridge->take(*frame);
      }),
      m_distances([this](std::optional<document::StepDistance> distance) {
          if (!m_step) return;
          m_distance = distance;
          emit changed();
      }),
      m_reading([this](std::optional<Read> read) { finishReading(std::move(read)); }, io::Lane::Reading) {
    m_measuring.setSingleShot(true);
    m_measuring.setInterval(stepsPatience);
    connect(&m_measuring, &QTimer::timeout, this, &StepsBridge::requestDistance);
    connect(bridge, &RenderBridge::wanted, this, &StepsBridge::requestPicture);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        using document::Change;
        if (!m_step || !(change.parts & (Change::System | Change::Cage | Change::Current | Change::File)))
            return;
        if (change.parts & (Change::Current | Change::File)) m_distance.reset();
        update();
    });
}

StepsBridge::~StepsBridge() = default;

void StepsBridge::setStart(Start start) {
    if (start == m_start) return;
    m_start = start;
    findShape();
}

void StepsBridge::setLetter(const QString& letter) {
    if (letter == m_letter) return;
    m_letter = letter;
    if (m_start == Start::Letter) findShape();
}

void StepsBridge::readPicture(const QString& path) {
    m_reading.submit([path](const std::stop_token& stop) {
        Read read{nullptr, QFileInfo(path).fileName(), {}};
        const io::Loaded loaded = io::loadFile(path);
        if (loaded.failure) {
            read.flaw = *loaded.failure;
            return std::optional(read);
        }
        const io::LoadedGrey grey = io::readGreyPicture(loaded.bytes, stop);
        if (grey.flaw) {
            read.flaw = *grey.flaw;
            return std::optional(read);
        }
        const auto traced = document::tracedPicture(document::reducedForTracing(grey.picture), {});
        if (traced)
            read.shape = std::make_shared<const document::StartShape>(document::pictureShape(*traced));
        else
            read.flaw = tr("The picture has no dark shape on a light background.");
        return std::optional(read);
    });
}

void StepsBridge::finishReading(std::optional<Read> read) {
    if (read && read->shape) {
        m_picture = read->shape;
        m_pictureName = read->name;
        m_start = Start::Picture;
        findShape();
    } else {
        m_flaw = read ? read->flaw : tr("The picture could not be read.");
        emit changed();
    }
}

void StepsBridge::findShape() {
    m_flaw.clear();
    m_shape.reset();
    switch (m_start) {
    case Start::Cage:
        break;
    case Start::Square:
        m_shape = std::make_shared<const document::StartShape>(document::squareShape());
        break;
    case Start::Letter:
        if (auto letter = document::letterShape(m_letter))
            m_shape = std::make_shared<const document::StartShape>(*std::move(letter));
        break;
    case Start::Picture:
        m_shape = m_picture;
        break;
    }
    update();
    if (m_isSubstituting) requestPicture();
    emit changed();
}

void StepsBridge::show(std::optional<int> step) {
    m_step = step; // the render bridge requests its picture
    if (!step) {
        m_drawing.cancel();
        m_distances.cancel();
        m_measuring.stop();
        m_distance.reset();
    }
    update();
}

void StepsBridge::update() {
    substitute(m_step && m_shape && document::system2(m_document->fractal()));
    if (m_step && !m_measuring.isActive()) m_measuring.start();
}

// Pictures that another has put in place of the density stay.
void StepsBridge::substitute(bool on) {
    if (on == m_isSubstituting || (on && m_bridge->isSubstituted())) return;
    m_isSubstituting = on;
    m_bridge->setSubstituted(on);
}

void StepsBridge::requestPicture() {
    const attractor::Camera& camera = m_bridge->camera();
    if (!m_isSubstituting || !m_step || !m_shape || camera.width <= 0 || camera.height <= 0) return;
    if (!document::system2(m_document->fractal())) return;
    document::StepJob job{m_document->sharedFractal(), m_shape, *m_step, camera, m_bridge->requested()};
    m_drawing.submit([job = std::move(job)](const std::stop_token& stop)
                         -> std::optional<std::shared_ptr<const attractor::Frame>> {
        auto frame = document::stepPicture(job, stop);
        if (!frame) return std::nullopt;
        return std::make_shared<const attractor::Frame>(*std::move(frame));
    });
}

void StepsBridge::requestDistance() {
    if (!m_step || !document::system2(m_document->fractal())) return;
    m_distances.submit([fractal = m_document->sharedFractal(), shape = m_shape,
                        step = *m_step](const std::stop_token& stop) {
        return document::stepDistance(*fractal, shape.get(), step, stop);
    });
}

} // namespace view
