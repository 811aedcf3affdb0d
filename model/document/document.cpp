// SPDX-License-Identifier: MIT
#include "document/document.h"

#include "document/background/free_in_background.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/moments/frame_edit.h"

#include <QUndoCommand>

#include <algorithm>
#include <chrono>
#include <utility>

namespace document {

class EditCommand : public QUndoCommand {
public:
    EditCommand(Document* document, const QString& text, Document::State before, Document::State after,
                int kind)
        : QUndoCommand(text),
          m_document(document),
          m_before(std::move(before)),
          m_after(std::move(after)),
          m_kind(kind) {}

    ~EditCommand() override { // may hold the last references to a hundred thousand entries
        for (Document::State* state : {&m_before, &m_after})
            if (state->file) freeInBackground(std::move(*state->file));
    }
    EditCommand(const EditCommand&) = delete;
    EditCommand& operator=(const EditCommand&) = delete;

    void undo() override { m_document->apply(m_before); }
    void redo() override { m_document->apply(m_after); }

    int id() const override { return m_kind; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto& step = *static_cast<const EditCommand*>(next);
        if (step.m_made - m_made > toJoin || step.m_before.current != m_before.current) return false;
        m_after = step.m_after;
        m_made = step.m_made;
        setText(step.text());
        setObsolete(*m_after.fractal == *m_before.fractal);
        return true;
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds toJoin{1};

    Document* m_document; // owner of the stack that owns this command
    Document::State m_before;
    Document::State m_after;
    int m_kind;
    Clock::time_point m_made = Clock::now();
};

namespace {

const Entry& noEntry() {
    static const Entry entry{EntryId::None, std::make_shared<const Fractal>(), nullptr, {}};
    return entry;
}

EntryId firstLoadable(const FractalFile& file) {
    for (const Entry& entry : file.entries)
        if (dimension(*entry.fractal) != 0) return entry.id;
    return file.entries.isEmpty() ? EntryId::None : file.entries.front().id;
}

bool isSame(const std::shared_ptr<const Fractal>& a, const std::shared_ptr<const Fractal>& b) {
    return a == b || *a == *b;
}

// Returns true if anything but the entry `except` differs.
bool entriesDiffer(const FractalFile& a, const FractalFile& b, EntryId except) {
    return a.head != b.head || a.tail != b.tail || a.lineEnd != b.lineEnd ||
           !std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(),
                       [&](const Entry& x, const Entry& y) {
                           return x.id == y.id && x.source == y.source &&
                                  (x.id == except || isSame(x.fractal, y.fractal));
                       });
}

// The fractal as an entry of the file: its cage is chosen anew.
std::shared_ptr<const Fractal> settled(const std::shared_ptr<const Fractal>& fractal) {
    if (!fractal->lasting) return fractal;
    auto entry = std::make_shared<Fractal>(*fractal);
    entry->lasting = {};
    return entry;
}

void settle(FractalFile& file) {
    for (qsizetype i = 0; i < file.entries.size(); ++i)
        if (const auto& fractal = file.entries.at(i).fractal; fractal->lasting)
            file.entries[i].fractal = settled(fractal);
}

template <int Dim> bool isHeldAlike(const Shape<Dim>* a, const Shape<Dim>* b) {
    return a && b ? a->cage == b->cage && a->moved == b->moved : a == b;
}

template <int Dim> bool isMovedAlike(const Shape<Dim>* a, const Shape<Dim>* b) {
    return a && b ? a->animation == b->animation : !(a && a->animation) && !(b && b->animation);
}

bool isMovedAlike(const Fractal& a, const Fractal& b) {
    return &a == &b || (isMovedAlike(plane(a), plane(b)) && isMovedAlike(space(a), space(b)));
}

} // namespace

Change::Parts difference(const Fractal& a, const Fractal& b) {
    Change::Parts parts;
    parts.setFlag(Change::System, !isSameSystem(a, b));
    parts.setFlag(Change::Cage, !isHeldAlike(plane(a), plane(b)) || !isHeldAlike(space(a), space(b)));
    parts.setFlag(Change::Appearance, !(a.appearance == b.appearance) || !(a.inSpace == b.inSpace));
    parts.setFlag(Change::Name, a.name != b.name || a.headerComment != b.headerComment ||
                                    a.comments != b.comments || !(a.mapLabels == b.mapLabels));
    return parts;
}

Document::Document(QObject* parent) : QObject(parent), m_file(fileOf(sierpinskiTriangle())) {
    m_current = m_file.entries.front().id;
    m_index = 0;
    refresh();
}

Document::~Document() {
    endGesture();
}

const Entry& Document::currentEntry() const {
    return m_index < 0 ? noEntry() : m_file.entries.at(m_index);
}

bool Document::isModified() const {
    return !m_undoStack.isClean() || (m_gesture && entryFractal() != *m_gesture->entry);
}

void Document::setFile(FractalFile file, EntryId current) {
    endGesture();
    m_file = std::move(file);
    settle(m_file);
    m_current = indexOf(m_file, current) >= 0 ? current : firstLoadable(m_file);
    m_index = indexOf(m_file, m_current);
    m_undoStack.clear();
    m_undoStack.setClean();
    m_typedNumbers.clear();
    m_moment = {};
    refresh();
    announce(Change::Everything);
}

void Document::setCurrent(EntryId id) {
    const qsizetype index = indexOf(m_file, id);
    if (index < 0 || id == m_current) return;
    commitGesture();
    const auto before = m_shown.fractal, entry = currentEntry().fractal;
    m_current = id;
    m_index = index;
    m_moment = {};
    refresh();
    Change::Parts parts = Change::Current | difference(*before, fractal());
    parts.setFlag(Change::Animation, !isMovedAlike(*entry, entryFractal()));
    announce(parts);
}

void Document::setMoment(const animation::Moment& moment, Pace pace) {
    const bool stops = pace == Pace::Rest && m_run;
    if (moment == m_moment && !stops) return;
    const auto before = m_shown.fractal;
    m_moment = moment;
    refresh();
    const Change::Parts parts = m_run | Change::Time | difference(*before, fractal());
    m_run = pace == Pace::Running ? parts : Change::Parts();
    announce(parts, pace == Pace::Running ? Live::Yes : Live::No);
}

void Document::refresh() {
    const auto& entry = currentEntry().fractal;
    if (!animationFacts(*entry)) {
        m_shown = {entry, {}, {}, {}};
        return;
    }
    const auto& held = m_gesture ? m_gesture->entry : entry;
    if (std::exchange(m_held, held) != held) m_lasting = lastingCage(*held);
    AnimatedFrame frame = frameAt(*entry, m_moment);
    frame.fractal.lasting = m_lasting;
    m_shown = {std::make_shared<const Fractal>(std::move(frame.fractal)), frame.view, frame.camera,
               std::move(frame.orbit)};
}

Change::Parts Document::replace(const std::shared_ptr<const Fractal>& entry) {
    if (m_index < 0) return {};
    const auto before = std::exchange(m_file.entries[m_index].fractal, entry);
    const auto shown = m_shown.fractal;
    refresh();
    Change::Parts parts = difference(*shown, fractal());
    parts.setFlag(Change::Animation, !isMovedAlike(*before, *entry));
    return parts;
}

QString Document::textOf(const QString& text, std::optional<int> keyedFrame) {
    return keyedFrame
               ? tr("%1 (frame %2)", "what is done, at which frame").arg(text, QString::number(*keyedFrame))
               : text;
}

void Document::markSaved(const FractalFile& saved) {
    commitGesture();
    if (saved.entries.size() == m_file.entries.size()) {
        for (qsizetype i = 0; i < saved.entries.size(); ++i)
            if (m_file.entries.at(i).problems != saved.entries.at(i).problems)
                m_file.entries[i].problems = saved.entries.at(i).problems;
        m_file.problems = saved.problems;
    }
    m_undoStack.setClean();
}

void Document::edit(const QString& text, Fractal after) {
    commitGesture();
    if (m_index < 0) return;
    FrameEdit edit = withFrameEdited(entryFractal(), m_moment, fractal(), std::move(after));
    editEntry(textOf(text, edit.isKeyed ? std::optional(edit.frame) : std::nullopt), std::move(edit.fractal));
}

void Document::editEntry(const QString& text, Fractal after) {
    commitGesture();
    if (m_index < 0 || after == entryFractal()) return;
    after.lasting = {};
    push(text, {m_current, currentEntry().fractal, {}},
         {m_current, std::make_shared<const Fractal>(std::move(after)), {}});
}

void Document::editFile(const QString& text, FractalFile after, EntryId current) {
    commitGesture();
    settle(after);
    if (indexOf(after, current) < 0) current = m_current;
    if (indexOf(after, current) < 0) { // removed entry: a neighbour becomes current
        const qsizetype last = after.entries.size() - 1;
        current = last < 0 ? EntryId::None : after.entries.at(std::clamp<qsizetype>(m_index, 0, last)).id;
    }
    if (after == m_file) return setCurrent(current);
    push(text, {m_current, {}, m_file}, {current, {}, std::move(after)});
}

void Document::push(const QString& text, State before, State after, int kind) {
    m_undoStack.push(new EditCommand(this, text, std::move(before), std::move(after), kind));
}

void Document::apply(const State& state) {
    Change::Parts parts;
    const auto before = m_shown.fractal, entry = currentEntry().fractal;
    if (const auto gesture = endGesture()) parts |= gesture->previewed;
    const bool isInSight =
        state.current == m_beside && indexOf(state.file ? *state.file : m_file, m_current) >= 0;
    const EntryId current = isInSight ? m_current : state.current;
    if (state.file) {
        parts.setFlag(Change::Entries, entriesDiffer(m_file, *state.file, current));
        m_file = *state.file;
    }
    const qsizetype changed = indexOf(m_file, state.current);
    if (state.fractal && changed >= 0) {
        m_file.entries[changed].fractal = state.fractal;
        parts.setFlag(Change::Entries, current != state.current);
    }
    parts.setFlag(Change::Current, current != m_current);
    if (current != m_current) m_moment = {};
    m_current = current;
    m_index = indexOf(m_file, m_current);
    refresh();
    parts.setFlag(Change::Animation, !isMovedAlike(*entry, entryFractal()));
    announce(parts | difference(*before, fractal()));
}

void Document::announce(Change::Parts parts, Live live) {
    ++m_revision;
    emit changed({parts, live == Live::Yes});
}

EditGesture Document::beginGesture(const QString& text) {
    commitGesture();
    const auto link = std::make_shared<EditGesture::Link>(EditGesture::Link{this, m_shown.fractal});
    m_gesture = {link, text, currentEntry().fractal, m_moment, {}, {}, {}, -1};
    return EditGesture(link);
}

void Document::previewGesture(Fractal fractal) {
    if (!m_gesture || m_index < 0) return;
    FrameEdit edit =
        withFrameEdited(*m_gesture->entry, m_gesture->moment, *m_gesture->link->before, std::move(fractal));
    showInGesture(std::move(edit.fractal), edit.isKeyed ? std::optional(edit.frame) : std::nullopt);
}

void Document::previewGestureOfEntry(Fractal entry) {
    if (m_gesture && m_index >= 0) showInGesture(std::move(entry), std::nullopt);
}

void Document::showInGesture(Fractal entry, std::optional<int> keyedFrame) {
    m_gesture->keyedFrame = keyedFrame;
    if (!animationFacts(entry) && !isSameSystem(entry, *m_gesture->entry)) {
        if (!m_gesture->lasting) m_gesture->lasting = lastingCage(*m_gesture->link->before);
        entry.lasting = m_gesture->lasting;
    }
    const Change::Parts parts = replace(std::make_shared<const Fractal>(std::move(entry)));
    m_gesture->previewed |= parts;
    if (parts) announce(parts, Live::Yes);
}

void Document::commitGesture() {
    if (!m_gesture) return;
    const auto before = m_gesture->entry, after = settled(currentEntry().fractal);
    if (*after == *before) return cancelGesture();
    // The announcement of the step ends the live state; the gesture stays open until then, so that nothing is
    // missed.
    push(textOf(m_gesture->text, m_gesture->keyedFrame), {m_current, before, {}}, {m_current, after, {}},
         m_gesture->kind);
}

void Document::describeGesture(const QString& text, int kind) {
    if (!m_gesture) return;
    m_gesture->text = text;
    m_gesture->kind = kind;
}

void Document::cancelGesture() {
    const auto gesture = endGesture();
    if (!gesture) return;
    if (const Change::Parts parts = gesture->previewed | replace(gesture->entry)) announce(parts);
}

std::optional<Document::Gesture> Document::endGesture() {
    if (m_gesture) m_gesture->link->host = nullptr;
    return std::exchange(m_gesture, std::nullopt);
}

void Document::setCageMode(CageMode mode) {
    if (mode == m_cageMode) return;
    m_cageMode = mode;
    emit cageModeChanged(mode);
}

} // namespace document
