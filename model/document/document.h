// SPDX-License-Identifier: MIT
#pragma once

#include "document/edit_gesture.h"
#include "document/fractal_file.h"
#include "document/moments/animated_fractal.h"
#include "document/typed_numbers.h"

#include <QFlags>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <memory>
#include <optional>

namespace document {

// Parts of the document that a change affects.
struct Change {
    enum Part {
        System = 0x01, // maps, weights, order, on/off
        Cage = 0x02,
        Appearance = 0x04,
        Name = 0x08,       // includes comments
        Entries = 0x10,    // added, removed, reordered
        Current = 0x20,    // different entry shown
        File = 0x40,       // different file
        Time = 0x80,       // different moment of the animation shown
        Animation = 0x100, // keys, motions, length, …
        Everything = 0x1ff,
    };
    Q_DECLARE_FLAGS(Parts, Part)
    Parts parts;
    bool live = false; // true within a gesture or while time runs: more such changes follow
};

// The parts in which two fractals differ, as they are shown: all but Animation.
Change::Parts difference(const Fractal& a, const Fractal& b);

// Effect on the code when the cage is moved.
enum class CageMode {
    Place,   // leaves the code; the picture is drawn elsewhere
    Rewrite, // replaces the code by that of the moved picture; the cage stays at rest
};

// The open file, the entry being edited, and the history. Lives in the GUI thread.
// One step of the history holds whole values before and after; undoing an edit shows the entry it belongs to.
// Undo or redo while a gesture is open drops what the gesture was showing.
// One moment of an animation is shown and edited: docs/decisions/0010.
class Document : public QObject, private GestureHost {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr); // starts with a Sierpiński triangle
    ~Document() override;                         // ends an open gesture

    const FractalFile& file() const { return m_file; }
    const Entry& currentEntry() const; // entry without id and system if the file has none
    // The fractal that is seen and edited: the entry at the moment, as an ordinary fractal without an
    // animation. For an entry without animation, its fractal itself. A cage that is not stored lasts: that of
    // the entry at rest through all moments, and that from before a gesture until its end.
    const Fractal& fractal() const { return *m_shown.fractal; }
    const std::shared_ptr<const Fractal>& sharedFractal() const { return m_shown.fractal; }
    // The entry with its animation, if it has one.
    const Fractal& entryFractal() const { return *currentEntry().fractal; }
    EntryId currentId() const { return m_current; }
    std::uint64_t revision() const { return m_revision; } // increases with every change
    QUndoStack* undoStack() { return &m_undoStack; }
    bool isModified() const; // true if changed since it was opened or saved, even by an open gesture

    void setFile(FractalFile file,
                 EntryId current = EntryId::None); // clears the history; None: the first loadable entry
    void setCurrent(EntryId id);                   // no step of the history; ignores unknown ids
    // An entry that is shown beside the current one: undoing and redoing its edits leaves the current one.
    void setBeside(EntryId id) { m_beside = id; }
    // Declares the present state clean after saving, and takes over the problems of `saved`, the file read
    // back.
    void markSaved(const FractalFile& saved);

    // The moment that is shown: no part of the file, no step of the history. 0 for another entry.
    const animation::Moment& moment() const { return m_moment; }
    // The views that keys give at the moment: in the plane, and in space as AnimatedFrame::camera, without
    // the orbit.
    const std::optional<attractor::View>& view() const { return m_shown.view; }
    const std::optional<attractor::OrbitCamera>& camera() const { return m_shown.camera; }
    // Turns that the camera in space has made: animation::orbited().
    const std::vector<animation::CameraTurn>& orbit() const { return m_shown.orbit; }
    enum class Pace { Rest, Running }; // Running: more moments follow at once
    void setMoment(const animation::Moment& moment, Pace pace = Pace::Rest);

    // Edits of one undo step each, described by `text` in the imperative; nothing happens when nothing would
    // change. An open gesture is committed first.
    // `after` is derived from fractal(); in an animation, values with keys get a key at the moment
    // (withFrameEdited()), and the description then names the frame.
    void edit(const QString& text, Fractal after);
    void editEntry(const QString& text, Fractal after); // `after` must be derived from entryFractal()
    void editFile(const QString& text, FractalFile after, EntryId current = EntryId::None);

    // A gesture on the current entry, whose step will be described by `text`.
    // Another one that is open is committed first. It may outlive the document.
    EditGesture beginGesture(const QString& text);

    // The extent of the current entry, and with it the cage in force, took long to find and is known now:
    // tells everybody that the cage has changed. No step of the history.
    void announceExtent() { announce(Change::Cage); }

    TypedNumbers& typedNumbers() { return m_typedNumbers; } // texts of this session; not stored in the file
    const TypedNumbers& typedNumbers() const { return m_typedNumbers; }

    // The current mode of editing; no part of the file, no step of the history.
    CageMode cageMode() const { return m_cageMode; }
    void setCageMode(CageMode mode);

signals:
    void changed(const document::Change& change);
    void cageModeChanged(document::CageMode mode);

private:
    friend class EditCommand;
    // The state to which a step of the history goes back: one entry's fractal, or the whole file.
    struct State {
        EntryId current = EntryId::None;
        std::shared_ptr<const Fractal> fractal;
        std::optional<FractalFile> file;
    };
    enum class Live { No, Yes };
    // The current entry as shown at the moment.
    struct Shown {
        std::shared_ptr<const Fractal> fractal;
        std::optional<attractor::View> view;
        std::optional<attractor::OrbitCamera> camera;
        std::vector<animation::CameraTurn> orbit;
    };

    void apply(const State& state);
    void refresh();
    Change::Parts replace(const std::shared_ptr<const Fractal>& entry); // returns the parts that differ
    static QString textOf(const QString& text, std::optional<int> keyedFrame);
    void announce(Change::Parts parts, Live live = Live::No);
    void push(const QString& text, State before, State after, int kind = -1);

    // Has no effect while no gesture is open.
    void previewGesture(Fractal fractal) override;
    void previewGestureOfEntry(Fractal entry) override;
    void showInGesture(Fractal entry, std::optional<int> keyedFrame);
    void commitGesture() override;
    void cancelGesture() override;
    void describeGesture(const QString& text, int kind) override;
    struct Gesture {
        std::shared_ptr<EditGesture::Link> link;
        QString text;
        std::shared_ptr<const Fractal> entry; // state at its beginning, as is `moment`
        animation::Moment moment;
        std::optional<int> keyedFrame; // frame at which the preview has keys
        Change::Parts previewed;       // parts announced as live
        LastingCage lasting;           // set on demand
        int kind = -1;                 // kind of steps to merge; −1: none
    };
    std::optional<Gesture> endGesture();

    FractalFile m_file;
    EntryId m_current = EntryId::None;
    EntryId m_beside = EntryId::None;
    qsizetype m_index = -1; // index of the current entry
    std::uint64_t m_revision = 0;
    animation::Moment m_moment;
    Change::Parts m_run; // parts announced since time began to run
    Shown m_shown;
    std::shared_ptr<const Fractal> m_held; // entry of m_lasting
    LastingCage m_lasting;
    QUndoStack m_undoStack;
    TypedNumbers m_typedNumbers;
    CageMode m_cageMode = CageMode::Place;
    std::optional<Gesture> m_gesture; // open gesture, if any
};

Q_DECLARE_OPERATORS_FOR_FLAGS(Change::Parts)

} // namespace document

Q_DECLARE_METATYPE(document::Change)
