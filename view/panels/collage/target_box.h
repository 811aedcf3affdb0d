// SPDX-License-Identifier: MIT
#pragma once

#include "document/document.h"
#include "document/traced_picture.h"
#include "widgets/background/newest_work.h"

#include <QHash>
#include <QWidget>

#include <memory>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QMenu;
class QSlider;
class QToolButton;

namespace io {
struct LoadedGrey;
}

namespace view {

class TargetPreview;

// Chooses the target of each entry and which part of it counts. The targets last as long as the window:
// docs/decisions, "Targets of collages".
class TargetBox : public QWidget {
    Q_OBJECT

public:
    // Controls for reading and showing the picture, for the panel to place.
    QWidget* controls() const { return m_controls; }

    explicit TargetBox(document::Document* document, QWidget* parent);
    ~TargetBox() override;

    // Reads in the background; a sentence says why a picture cannot be used.
    void read(const QString& path);
    void take(const std::shared_ptr<const document::Fractal>& entry); // attractor of the entry as the target

    const std::shared_ptr<const document::TracedPicture>& traced() const { return m_traced; } // null: none
    bool hasTargets() const; // true if any entry of the file has one
    QString name() const;    // name of the current entry's target
    // Gives another entry the target of the current one.
    void share(document::EntryId with) { m_states[with] = state(); }
    bool isBusy() const { return m_reading.isBusy() || m_tracing.isBusy(); }

signals:
    void tracedChanged();
    void opacityChanged(int percent);

private:
    using PicturePointer = std::shared_ptr<const collage::GreyPicture>;
    using TracedPointer = std::shared_ptr<const document::TracedPicture>;
    struct State {
        PicturePointer picture;
        bool isReduced = false; // true: reduced for tracing
        QString name;
        QString sentence; // reason why there is no picture
        document::TraceOptions options;
        // Box of the attractor when the picture was added, which determines the size of the shape.
        std::optional<document::Box> onto;

        bool isTracedAs(const State& other) const;
    };
    struct Read {
        document::EntryId entry = document::EntryId::None;
        State state;
    };

    static void keep(const io::LoadedGrey& grey, State& state);
    void createSources();
    void createControls();
    void createShape(QGridLayout& grid);
    void connectControls();
    void fillEntries(QMenu* menu);
    void choose();
    void paste();
    void remove();
    void submit(const std::function<State(const std::stop_token&)>& reading, const QString& name);
    void finishReading(std::optional<Read> read);
    void follow(const document::Change& change);
    void setOptions(const std::function<void(document::TraceOptions&)>& change);
    void showState();
    void trace();
    void show(TracedPointer traced);
    State& state() { return m_states[m_document->currentId()]; }

    document::Document* m_document;
    QHash<document::EntryId, State> m_states;
    document::EntryId m_shown = document::EntryId::None;
    TracedPointer m_traced;
    QToolButton* m_remove = nullptr;
    QLabel* m_name = nullptr;
    TargetPreview* m_preview = nullptr;
    QWidget* m_controls = nullptr; // controls of a picture
    QComboBox* m_shape = nullptr;
    QCheckBox* m_inverted = nullptr;
    QCheckBox* m_automatic = nullptr;
    QSlider* m_threshold = nullptr;
    QToolButton* m_whole = nullptr;
    QToolButton* m_toShape = nullptr;
    QSlider* m_opacity = nullptr;
    NewestWork<Read> m_reading;
    NewestWork<TracedPointer> m_tracing;
};

} // namespace view
