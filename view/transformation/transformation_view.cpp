// SPDX-License-Identifier: MIT
#include "transformation/transformation_view.h"

#include "canvas/canvas_view.h"
#include "canvas/marks/map_numbers.h"
#include "document/text/reordered_text.h"
#include "document/tops/divided_words.h"
#include "document/tops/laid_picture.h"
#include "io/file/background.h"
#include "io/picture/decoding/picture_decoder.h"
#include "transformation/family_sliders.h"
#include "transformation/map_order.h"
#include "transformation/picture_source.h"
#include "transformation/theft_export_dialog.h"
#include "transformation/theft_sentences.h"
#include "widgets/accept_as_copy.h"
#include "widgets/file_dialogs.h"
#include "widgets/whats_this.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMimeData>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace view {

namespace {

using document::EntryId;
using document::KeptTheft;

constexpr std::chrono::milliseconds restPause{400};
constexpr double resolution = 1.0 / 256; // share of an attractor's size
constexpr double overlayOpacity = 0.5;
constexpr std::size_t measuredPairs = 1U << 17; // limit of pairs of pieces

// Other files are the window's business.
QString pictureOf(const QMimeData& data) {
    const QList<QUrl> urls = data.urls();
    const QString path =
        urls.size() == 1 && urls.first().isLocalFile() ? urls.first().toLocalFile() : QString();
    return io::pictureSuffixes().contains(QFileInfo(path).suffix().toLower()) ? path : QString();
}

// A sentence about a picture: a problem with the file includes its name, a problem with its content does not.
QString pictureProblem(const QString& path, const QString& sentence) {
    if (sentence.contains(QFileInfo(path).fileName())) return sentence;
    return TransformationView::tr("%1: %2").arg(QDir::toNativeSeparators(path), sentence);
}

// A path from a file, in which nothing pretends to be something else.
QString shownPath(const QString& path) {
    QString shown = QDir::toNativeSeparators(path);
    for (QChar& c : shown)
        if (!c.isPrint() || document::turnsText(c)) c = QChar::ReplacementCharacter;
    return shown;
}

ifs::Tear tearOf(const ifs::SupportFunction<2>& from, const ifs::SupportFunction<2>& to) {
    return ifs::tear(from, to, std::max(2 * from.radius() * resolution, 1e-300), measuredPairs);
}

} // namespace

TransformationView::TransformationView(document::Document* document, RenderBridge* render, CanvasView* canvas,
                                       QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_render(render),
      m_canvas(canvas),
      m_splitter(new QSplitter(Qt::Horizontal, this)),
      m_embedding([this](std::optional<Embedding> read) { keepEmbedded(std::move(read)); },
                  io::Lane::Reading) {
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(canvas);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(m_splitter, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(row, 1);
    setFocusProxy(canvas);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restPause);
}

TransformationView::~TransformationView() {
    m_theft.reset(); // before the bridges are destroyed
    delete m_bar;
    delete m_partnerCanvas;
    delete m_partnerRender;
}

void TransformationView::setTransformationShown(bool shown) {
    if (std::exchange(m_isShown, shown) == shown) return;
    if (shown && !m_bar) create();
    for (QWidget* widget : {static_cast<QWidget*>(m_partnerCanvas), static_cast<QWidget*>(m_order),
                            static_cast<QWidget*>(m_bar)})
        widget->setVisible(shown);
    if (shown) {
        refresh();
        measureLater();
        arrange(m_splitter->orientation());
    }
    m_theft->setActive(shown);
    m_canvas->fit();
}

void TransformationView::arrange(Qt::Orientation orientation) {
    m_splitter->setOrientation(orientation);
    const int half = (orientation == Qt::Horizontal ? m_splitter->width() : m_splitter->height()) / 2;
    m_splitter->setSizes({half, half});
}

void TransformationView::create() {
    m_partner = std::make_unique<document::PartnerDocument>(m_document);
    m_partnerRender = new RenderBridge(&m_partner->document(), this);
    m_partnerRender->setQuality(m_render->quality());
    m_partnerCanvas = new CanvasView(&m_partner->document(), m_partnerRender, m_splitter);
    m_partnerCanvas->setAccessibleName(tr("Canvas of the partner"));
    m_splitter->addWidget(m_partnerCanvas);
    m_theft = std::make_unique<TheftBridge>(m_document, m_render, m_partner.get(), m_partnerRender);
    m_source = new PictureSource(this);
    m_order = new MapOrder(this);
    m_bar = new TransformationBar(this);
    m_bar->addSliders(new FamilySliders(&m_partner->document(), m_bar));
    auto* layout = static_cast<QVBoxLayout*>(this->layout());
    static_cast<QHBoxLayout*>(layout->itemAt(0)->layout())->addWidget(m_order);
    layout->addWidget(m_bar);
    for (QWidget* part : {static_cast<QWidget*>(m_bar), static_cast<QWidget*>(m_order)})
        if (part->whatsThis().isEmpty())
            part->setWhatsThis(
                tr("Points of two fractals that have the same address correspond to each other. "
                   "A picture on the partner is carried over to this fractal in that way."));
    explainByTips(this);
    setAcceptDrops(true);

    followTools();
    connectBar();
    connectSource();
    connect(m_document, &document::Document::changed, this, [this](const document::Change& change) {
        measureLater();
        if (change.parts & (document::Change::Current | document::Change::File)) {
            m_wanted.clear(); // chosen for the previous entry
            m_embedding.cancel();
            m_isOwnPicture = false;
        }
        if (change.parts & document::Change::File) forgetAgreement();
        if (!change.live && m_isShown) refresh();
    });
    connect(&m_partner->document(), &document::Document::changed, this, &TransformationView::measureLater);
    connect(m_partner.get(), &document::PartnerDocument::partnerChanged, this,
            &TransformationView::measureLater);
    connect(m_theft.get(), &TheftBridge::flawChanged, this, &TransformationView::showProblem);
    connect(m_theft.get(), &TheftBridge::paintedChanged, this, [this] { m_bar->setExportable(isPainted()); });
    connect(&m_rest, &QTimer::timeout, this, &TransformationView::measure);
    connect(&m_measuring, &QFutureWatcherBase::finished, this, [this] {
        if (m_measuring.isCanceled() || m_measuring.future().resultCount() == 0) return; // out of memory
        const Continuity found = m_measuring.result();
        m_bar->showContinuity(found.there
                                  ? QStringLiteral("%1. %2").arg(sentenceOf(*found.there),
                                                                 sentenceOf(*found.back, found.verdict))
                                  : QString());
    });
}

void TransformationView::connectSource() {
    connect(m_source, &PictureSource::ready, this, [this](const PictureSource::Picture& picture) {
        m_pictureFailure.clear();
        m_isForeign = false;
        if (!m_wanted.isEmpty()) m_refusal.clear(); // otherwise the refusal still holds
        m_theft->setPicture(picture);
        keepPicture();
        showProblem();
    });
    connect(m_source, &PictureSource::foreign, this, &TransformationView::refuseForeign);
    connect(m_source, &PictureSource::failed, this, [this](const QString& sentence) {
        if (const QString wanted = std::exchange(m_wanted, QString()); !wanted.isEmpty()) {
            m_refusal = pictureProblem(wanted, sentence);
            showPicture(); // previous picture
        } else {
            m_pictureFailure = sentence;
            m_isForeign = false;
            m_theft->setPicture(nullptr);
        }
        showProblem();
    });
}

// The tools of the window serve both canvases.
void TransformationView::followTools() {
    const auto follow = [this](CanvasView::Tool tool) {
        if (tool != CanvasView::Tool::DefineTriangle) m_partnerCanvas->setTool(tool);
    };
    follow(m_canvas->tool());
    connect(m_canvas, &CanvasView::toolChanged, this, follow);
    CanvasOptions& own = m_canvas->options();
    CanvasOptions* other = &m_partnerCanvas->options();
    other->setGridVisible(own.isGridVisible());
    other->setAxesVisible(own.areAxesVisible());
    other->setOverlaysVisible(own.overlaysVisible());
    connect(&own, &CanvasOptions::gridVisibleChanged, other, &CanvasOptions::setGridVisible);
    connect(&own, &CanvasOptions::axesVisibleChanged, other, &CanvasOptions::setAxesVisible);
    connect(&own, &CanvasOptions::overlaysVisibleChanged, other, &CanvasOptions::setOverlaysVisible);
    connect(m_partnerCanvas, &CanvasView::message, this, &TransformationView::message);
    auto* numbers = new MapNumbers; // owned by the scene
    m_partnerCanvas->scene()->addItem(numbers);
    connect(other, &CanvasOptions::mapNumbersVisibleChanged, m_partnerCanvas,
            [numbers](bool visible) { numbers->setVisible(visible); });
    other->setMapNumbersVisible(own.areMapNumbersVisible());
    connect(&own, &CanvasOptions::mapNumbersVisibleChanged, other, &CanvasOptions::setMapNumbersVisible);
}

void TransformationView::connectBar() {
    connect(m_bar, &TransformationBar::partnerChosen, this, [this](EntryId id) {
        const qsizetype index = document::indexOf(m_document->file(), id);
        if (index < 0) return;
        KeptTheft theft = m_kept;
        const document::Fractal& partner = *m_document->file().entries[index].fractal;
        theft.partner = partner.name;
        keep(tr("Choose Partner"), placed(theft, partner));
    });
    connect(m_bar, &TransformationBar::modeChosen, this, [this](document::TheftMode mode) {
        KeptTheft theft = m_kept;
        theft.mode = mode;
        keep(tr("Choose Mode"), placed(theft, m_partner->document().fractal()));
    });
    connect(m_bar, &TransformationBar::patternChosen, this, [this](attractor::Pattern pattern) {
        KeptTheft theft = m_kept;
        theft.pattern = pattern;
        theft.picture.clear();
        theft.embedded.clear();
        m_wanted.clear();
        keep(tr("Choose Picture"), placed(theft, m_partner->document().fractal()));
        showPicture(); // also for the kept picture
    });
    const auto putInOrder = [this](const std::vector<std::size_t>& order) {
        KeptTheft theft = m_kept;
        theft.order = order;
        keep(order.empty() ? tr("Reset Order") : tr("Reorder Overlapping Maps"), theft);
    };
    connect(m_order, &MapOrder::ordered, this, putInOrder);
    connect(m_bar, &TransformationBar::resetOrderWanted, this, [putInOrder] { putInOrder({}); });
    connect(m_bar, &TransformationBar::pictureWanted, this, &TransformationView::choosePicture);
    connect(m_bar, &TransformationBar::foreignPictureWanted, this, &TransformationView::openForeign);
    connect(m_bar, &TransformationBar::embedWanted, this, &TransformationView::embedPicture);
    connect(m_bar, &TransformationBar::starterChosen, this, &TransformationView::start);
    connect(m_bar, &TransformationBar::stacked, this,
            [this](bool on) { arrange(on ? Qt::Vertical : Qt::Horizontal); });
    connect(m_bar, &TransformationBar::overlaid, this,
            [this](bool on) { m_theft->setOverlay(on ? overlayOpacity : 0); });
    connect(m_bar, &TransformationBar::exportWanted, this, &TransformationView::chooseExport);
    connect(m_bar, &TransformationBar::divideWanted, this, [this] {
        m_document->editFile(
            tr("Divide Words"),
            document::withWordsDivided(m_document->file(), m_document->currentId(), m_partner->id()),
            m_document->currentId());
    });
}

void TransformationView::refresh() {
    const document::FractalFile& file = m_document->file();
    const EntryId current = m_document->currentId();
    const auto kept = document::keptTheft(m_document->entryFractal());
    // True as long as the entry of the guess exists, whatever becomes of the maps.
    const bool isGuessed = !kept && m_guessedFor == current && document::indexOf(file, m_partner->id()) >= 0;
    EntryId partner = kept        ? document::entryNamed(file, kept->partner)
                      : isGuessed ? m_partner->id()
                                  : document::likelyPartner(file, current);
    if (partner == current) partner = EntryId::None;
    m_refusal.clear();
    const KeptTheft before = std::exchange(m_kept, kept.value_or(KeptTheft()));
    if (before.picture != m_kept.picture) m_embedding.cancel();
    if (const qsizetype index = document::indexOf(file, partner); index >= 0) {
        const document::Fractal& fractal = *file.entries[index].fractal;
        m_kept.partner = fractal.name;
        // Keeps a guessed view, too.
        if (!kept && before.view && m_guessedFor == current && before.partner == fractal.name)
            m_kept.view = before.view;
        else if (!kept)
            m_kept = placed(m_kept, fractal);
    }
    m_guessedFor = kept ? EntryId::None : current;
    m_partner->setPartner(partner);
    m_partnerCanvas->setEnabled(partner != EntryId::None);
    m_partnerCanvas->setMapFaces(
        document::facesOfPartner(m_document->fractal(), m_partner->document().fractal()));
    m_theft->setTheft(m_kept);
    m_order->show(m_document->fractal(), m_kept.order);
    m_bar->show(file, current, partner, m_kept);
    showPicture();
    showProblem();
}

void TransformationView::showPicture() {
    if (!m_wanted.isEmpty()) return; // kept after the reading
    const bool isEmbedded = !m_kept.embedded.isEmpty(), isPattern = !isEmbedded && m_kept.picture.isEmpty();
    const QString wish = isEmbedded  ? PictureSource::wishFor(m_kept.embedded)
                         : isPattern ? PictureSource::wishFor(m_kept.pattern)
                                     : picturePath();
    if (m_isMoving && !isEmbedded && !isPattern) { // path relative to the new folder
        m_source->forget();
        m_pictureFailure.clear();
        m_isForeign = false;
        return m_theft->setPicture(nullptr);
    }
    const bool isOwn = std::exchange(m_isOwnPicture, true);
    if (m_source->wish() == wish) return;
    m_pictureFailure.clear();
    m_isForeign = false;
    if (!isOwn) m_theft->setPicture(nullptr); // hides the picture of another entry
    if (isEmbedded) return m_source->decode(m_kept.embedded);
    if (isPattern) return m_source->draw(m_kept.pattern);
    m_agreed.contains(wish) ? m_source->read(wish) : m_source->readNamed(folder(), m_kept.picture);
}

void TransformationView::showProblem() {
    using Remedy = TransformationBar::Remedy;
    const QString name = m_document->fractal().name;
    if (m_partner->id() == EntryId::None) {
        const QString sentence =
            m_kept.partner.isEmpty()
                ? tr("There is no other entry of the plane in this file. Add one, or choose a starter.")
                : tr("The partner “%1” is not in this file. Choose another one.").arg(m_kept.partner);
        return m_bar->showProblem(sentence, Remedy::None);
    }
    if (!m_refusal.isEmpty()) return m_bar->showProblem(m_refusal, Remedy::None);
    if (m_isForeign)
        return m_bar->showProblem(tr("The file names a picture outside its folder: %1. Open it only if you "
                                     "trust the file.")
                                      .arg(shownPath(picturePath())),
                                  Remedy::OpenForeignPicture);
    if (!m_pictureFailure.isEmpty())
        return m_bar->showProblem(pictureProblem(m_kept.picture, m_pictureFailure), Remedy::FindPicture);
    if (const auto& flaw = m_theft->flaw()) {
        const bool canAgree = flaw->flaw == document::CouplingFlaw::Counts &&
                              document::commonMapCount(flaw->fromCount, flaw->toCount);
        const Remedy remedy = canAgree                                      ? Remedy::DivideWords
                              : flaw->flaw == document::CouplingFlaw::Order ? Remedy::ResetOrder
                                                                            : Remedy::None;
        return m_bar->showProblem(sentenceOf(*flaw, name, m_kept.partner), remedy);
    }
    m_bar->showProblem({}, Remedy::None);
}

// Drops measurements of the entries before.
void TransformationView::measureLater() {
    m_measuring.future().cancel();
    m_bar->showContinuity({});
    m_rest.start();
}

void TransformationView::measure() {
    if (!m_isShown || m_partner->id() == EntryId::None) return m_bar->showContinuity({});
    m_measuring.setFuture(io::inBackground<Continuity>([from = m_document->sharedFractal(),
                                                        to = m_partner->document().sharedFractal(),
                                                        order = m_kept.order](QPromise<Continuity>& promise) {
        Continuity found;
        const document::CouplingOutcome coupling = document::coupled(*from, *to, order);
        if (coupling.entries) {
            const ifs::SupportFunction<2>& f = coupling.entries->fromAttractor;
            const ifs::SupportFunction<2>& g = coupling.entries->toAttractor;
            found.there = tearOf(f, g);
            if (promise.isCanceled()) return;
            found.back = tearOf(g, f);
            if (promise.isCanceled()) return;
            found.verdict = ifs::homeomorphism(f, g);
        }
        promise.addResult(found);
    }));
}

void TransformationView::keep(const QString& text, const KeptTheft& theft) {
    if (theft.partner.isEmpty()) return refresh(); // nothing to keep: restores the display
    m_document->editEntry(text, document::withTheft(m_document->entryFractal(), theft));
}

void TransformationView::start(document::TheftFamily family) {
    document::StartedTheft started = document::withStarter(m_document->file(), family);
    m_document->editFile(tr("Add Family"), std::move(started.file), started.from);
}

// Places the picture relative to the partner as it is now, so that the partner can be dragged over it.
KeptTheft TransformationView::placed(KeptTheft theft, const document::Fractal& partner) const {
    theft.view.reset();
    if (theft.mode != document::TheftMode::StealColours) return theft;
    const auto& picture = m_theft->picture();
    const bool isFile = picture && !theft.picture.isEmpty(); // patterns are square
    theft.view =
        document::pictureView(partner, isFile ? picture->width() : 1, isFile ? picture->height() : 1);
    return theft;
}

void TransformationView::usePicture(const QString& path) {
    if (!m_isShown || path.isEmpty()) return;
    m_wanted = PictureSource::absolutePath({}, path);
    m_agreed.insert(m_wanted);
    m_source->read(m_wanted); // kept once its size is known
}

void TransformationView::keepPicture() {
    if (m_wanted.isEmpty()) return;
    const QString path = std::exchange(m_wanted, QString());
    KeptTheft theft = m_kept;
    theft.picture = folder().isEmpty() ? path : QDir(folder()).relativeFilePath(path);
    theft.embedded.clear();
    if (theft.mode == document::TheftMode::DeformationGrid) theft.mode = document::TheftMode::StealColours;
    theft = placed(theft, m_partner->document().fractal());
    keep(tr("Choose Picture"), theft);
}

void TransformationView::embedPicture(bool embedded) {
    m_embedding.cancel();
    if (embedded) {
        const bool isAgreed = m_agreed.contains(picturePath());
        m_embedding.submit([path = picturePath(), named = m_kept.picture, folder = folder(),
                            isAgreed](const std::stop_token& stop) -> std::optional<Embedding> {
            if (!isAgreed && PictureSource::isForeign(folder, named)) return Embedding{{}, true};
            return Embedding{io::pictureToEmbed(path, stop)};
        });
        return;
    }
    KeptTheft theft = m_kept;
    theft.embedded.clear();
    keep(tr("Do Not Embed Picture"), theft);
}

void TransformationView::keepEmbedded(std::optional<Embedding> read) {
    if (!read || m_kept.picture.isEmpty()) return; // out of memory
    if (read->isForeign || read->found.failure) {
        if (read->found.failure) m_refusal = pictureProblem(m_kept.picture, *read->found.failure);
        m_bar->show(m_document->file(), m_document->currentId(), m_partner->id(), m_kept);
        return read->isForeign ? refuseForeign() : showProblem();
    }
    KeptTheft theft = m_kept;
    theft.embedded = read->found.bytes;
    keep(tr("Embed Picture"), theft);
}

QString TransformationView::picturePath() const {
    return PictureSource::absolutePath(folder(), m_kept.picture);
}

void TransformationView::refuseForeign() {
    m_isForeign = true;
    m_theft->setPicture(nullptr);
    showProblem();
}

void TransformationView::openForeign() {
    m_agreed.insert(picturePath());
    m_isForeign = false;
    m_source->read(picturePath());
    showProblem();
}

// Drops the user's agreement, which holds for one file only.
void TransformationView::forgetAgreement() {
    m_agreed.clear();
    m_isMoving = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_isMoving = false;
            if (!m_isShown) return;
            showPicture();
            showProblem();
        },
        Qt::QueuedConnection);
}

void TransformationView::choosePicture() {
    usePicture(choosePictureToOpen(this, tr("Choose Picture")));
}

document::TheftJob TransformationView::job() const {
    document::TheftJob job;
    job.from = {m_document->sharedFractal(), m_canvas->camera(), 0};
    job.to = {m_partner->document().sharedFractal(), m_partnerCanvas->camera(), 0};
    job.order = m_kept.order;
    job.mode = m_kept.mode;
    job.view = m_kept.view;
    job.picture = m_theft->picture();
    return job;
}

bool TransformationView::cancelGesture() {
    return m_isShown && m_partnerCanvas->cancelGesture();
}

bool TransformationView::isPainted() const {
    return m_isShown && m_render->isSubstituted();
}

void TransformationView::chooseExport() {
    if (!isPainted()) return;
    for (auto* open : window()->findChildren<TheftExportDialog*>(Qt::FindDirectChildrenOnly)) {
        if (!open->isVisible() || open->job() != job()) continue;
        open->setWindowState(open->windowState() & ~Qt::WindowMinimized);
        open->raise();
        return open->activateWindow();
    }
    auto* dialog = new TheftExportDialog(job(), window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (m_canvas->navigation().isFitted()) dialog->setSection(TheftExportDialog::Section::Attractor);
    dialog->suggestFolderOf(window()->windowFilePath());
    dialog->show();
}

QString TransformationView::folder() const {
    const QString path = window()->windowFilePath();
    return path.isEmpty() ? QString() : QFileInfo(path).path();
}

bool TransformationView::isOverPartner(const QPoint& position) const {
    return m_isShown && m_partnerCanvas->rect().contains(m_partnerCanvas->mapFrom(this, position));
}

void TransformationView::dragEnterEvent(QDragEnterEvent* event) {
    if (m_isShown && !pictureOf(*event->mimeData()).isEmpty())
        acceptAsCopy(*event);
    else
        event->ignore();
}

void TransformationView::dragMoveEvent(QDragMoveEvent* event) {
    if (isOverPartner(event->position().toPoint()))
        acceptAsCopy(*event);
    else
        event->ignore();
}

void TransformationView::dropEvent(QDropEvent* event) {
    const QString path = pictureOf(*event->mimeData());
    if (path.isEmpty() || !isOverPartner(event->position().toPoint())) return event->ignore();
    acceptAsCopy(*event);
    // Runs after the drop, because the source of the drag waits.
    QMetaObject::invokeMethod(
        this, [this, path] { usePicture(path); }, Qt::QueuedConnection);
}

} // namespace view
