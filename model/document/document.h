// SPDX-License-Identifier: MIT
#pragma once

#include "document/edit_gesture.h"
#include "document/fractal_file.h"
#include "document/typed_numbers.h"

#include <QFlags>
#include <QObject>
#include <QString>
#include <QUndoStack>

#include <cstdint>
#include <memory>
#include <optional>

namespace document {

// What differs from before.
struct Change {
    enum Part {
        System = 0x01, // maps, weights, order, on/off
        Cage = 0x02,
        Appearance = 0x04,
        Name = 0x08,    // and comments
        Entries = 0x10, // added, removed, reordered
        Current = 0x20, // another entry is shown
        File = 0x40,    // another file altogether
        Everything = 0x7f,
    };
    Q_DECLARE_FLAGS(Parts, Part)
    Parts parts;
    bool live = false; // in the middle of a gesture: more of the same is to come
};

// The parts in which two fractals differ.
Change::Parts difference(const Fractal& a, const Fractal& b);

// What moving the cage does to the code.
enum class CageMode {
    Place,   // nothing: the code is drawn elsewhere
    Rewrite, // it becomes that of the moved picture, and the cage rests where it is
};

// The open file, the entry being edited, and the history. Lives in the GUI thread.
// One step of the history holds whole values before and after; undoing an edit shows the entry it belongs to.
// Undo or redo while a gesture is open drops what the gesture was showing.
class Document : public QObject, private GestureHost {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr); // a new file with a Sierpiński triangle
    ~Document() override;                         // an open gesture ends with it

    const FractalFile& file() const { return m_file; }
    const Entry& currentEntry() const; // of a file without entries: an entry without id and system
    const Fractal& fractal() const { return *currentEntry().fractal; } // the entry being edited
    EntryId currentId() const { return m_current; }
    std::uint64_t revision() const { return m_revision; } // grows with every change
    QUndoStack* undoStack() { return &m_undoStack; }
    bool isModified() const; // not as it was when opened or saved, an open gesture included

    void setFile(FractalFile file,
                 EntryId current = EntryId::None); // clears the history; None: the first loadable entry
    void setCurrent(EntryId id); // not a step of the history; an id that is not in the file is ignored
    // After saving: the present state is the clean one. The problems shown are those of `saved`, the file
    // read back.
    void markSaved(const FractalFile& saved);

    // One undo step each, described by `text` in the imperative; nothing happens when nothing would change.
    // An open gesture is committed first.
    void edit(const QString& text, Fractal after);
    void editFile(const QString& text, FractalFile after, EntryId current = EntryId::None);

    // A gesture on the current entry, whose step will be described by `text`.
    // Another one that is open is committed first. It may outlive the document.
    EditGesture beginGesture(const QString& text);

    TypedNumbers& typedNumbers() { return m_typedNumbers; } // of this session; no part of the file
    const TypedNumbers& typedNumbers() const { return m_typedNumbers; }

    // How the user edits now; no part of the file, no step of the history.
    CageMode cageMode() const { return m_cageMode; }
    void setCageMode(CageMode mode);

signals:
    void changed(const document::Change& change);
    void cageModeChanged(document::CageMode mode);

private:
    friend class EditCommand;
    // What a step of the history goes back to: one entry's fractal, or the whole file.
    struct State {
        EntryId current = EntryId::None;
        std::shared_ptr<const Fractal> fractal;
        std::optional<FractalFile> file;
    };
    enum class Live { No, Yes };

    void apply(const State& state);
    void show(const std::shared_ptr<const Fractal>& fractal, Change::Parts parts, Live live);
    void announce(Change::Parts parts, Live live = Live::No);
    void push(const QString& text, State before, State after, int kind = -1);

    // Nothing happens while no gesture is open.
    void previewGesture(Fractal fractal) override;
    void commitGesture() override;
    void cancelGesture() override;
    void describeGesture(const QString& text, int kind) override;
    struct Gesture {
        std::shared_ptr<EditGesture::Link> link;
        QString text;
        Change::Parts previewed; // what listeners have been told was live
        int kind = -1;           // of steps that become one
    };
    std::optional<Gesture> endGesture();

    FractalFile m_file;
    EntryId m_current = EntryId::None;
    qsizetype m_index = -1; // of the current entry
    std::uint64_t m_revision = 0;
    QUndoStack m_undoStack;
    TypedNumbers m_typedNumbers;
    CageMode m_cageMode = CageMode::Place;
    std::optional<Gesture> m_gesture; // the open one
};

Q_DECLARE_OPERATORS_FOR_FLAGS(Change::Parts)

} // namespace document

Q_DECLARE_METATYPE(document::Change)
