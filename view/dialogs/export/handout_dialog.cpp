// SPDX-License-Identifier: MIT
#include "dialogs/export/handout_dialog.h"

#include "dialogs/export/print_preview.h"
#include "dialogs/export/printed_parts.h"
#include "document/fractal/fractal_geometry.h"
#include "document/fractal/space_geometry.h"
#include "document/maps/map_handles.h"
#include "document/text/file_names.h"
#include "io/export_job.h"
#include "io/overlay/space_overlay.h"
#include "widgets/choices.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace view {

namespace {

constexpr double areaMargin = 0.04; // margin around the visible area

int longSideOf(const HandoutOptions& options) {
    return options.perPage <= 2 ? 1400 : 900;
}

QImage drawnInSpace(const HandoutPictureInSpace& shown, QWidget* parent) {
    QImage image = drawnForPaper(shown.picture, parent);
    if (!image.isNull()) io::paintOverlay(image, shown.marks, 0);
    return image;
}

} // namespace

HandoutDialog::HandoutDialog(const document::Document* document, QWidget* parent)
    : QDialog(parent),
      m_name(document->fractal().name),
      m_entries(new QListWidget(this)),
      m_kind(new QComboBox(this)),
      m_perPage(new QComboBox(this)),
      m_maps(new QCheckBox(tr("&Cage and maps"), this)),
      m_formulas(new QCheckBox(tr("&Formulas"), this)),
      m_nameLine(new QCheckBox(tr("&Line for name and date"), this)),
      m_message(new QLabel(this)) {
    setWindowTitle(tr("Print a Handout"));
    setWhatsThis(
        tr("Prints entries of the file for a class: with pictures and formulas, or as blank worksheets."));
    auto* layout = new QVBoxLayout(this);
    createEntries(*document);
    createOptions();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_preview = buttons->addButton(tr("Pre&view…"), QDialogButtonBox::ActionRole);
    m_preview->setDefault(true);
    m_preview->setToolTip(tr("Show the pages before they are printed"));
    connect(m_preview, &QPushButton::clicked, this, &HandoutDialog::showPreview);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_message->setWordWrap(true);
    m_message->setAccessibleName(tr("Result"));
    layout->addWidget(m_message);
    layout->addWidget(buttons);
    update();
    resize(560, 460);
}

void HandoutDialog::createEntries(const document::Document& document) {
    auto* label = new QLabel(tr("&Entries:"), this);
    label->setBuddy(m_entries);
    m_entries->setAccessibleName(tr("Entries to print"));
    m_entries->setWhatsThis(
        tr("The entries of the file that could be read. Ticked entries are printed in this "
           "order, up to %1 of them.")
            .arg(maxEntries));
    for (const document::Entry& entry : document.file().entries) {
        if (m_entries->count() == maxListed) break;
        const bool isCurrent = entry.id == document.currentId();
        const std::shared_ptr<const document::Fractal> fractal =
            isCurrent ? document.sharedFractal() : entry.fractal;
        if (document::dimension(*fractal) == 0) continue;
        auto* row = new QListWidgetItem(fractal->name, m_entries);
        row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        row->setCheckState(isCurrent ? Qt::Checked : Qt::Unchecked);
        if (isCurrent) m_entries->setCurrentItem(row);
        m_fractals.push_back(fractal);
    }
    connect(m_entries, &QListWidget::itemChanged, this, &HandoutDialog::update);
    auto* all = new QPushButton(tr("&All"), this);
    auto* none = new QPushButton(tr("&None"), this);
    all->setToolTip(tr("Print all entries of the list"));
    none->setToolTip(tr("Remove all ticks"));
    const auto setAll = [this](Qt::CheckState state) {
        for (int k = 0; k < m_entries->count(); ++k)
            m_entries->item(k)->setCheckState(state);
    };
    connect(all, &QPushButton::clicked, this, [setAll] { setAll(Qt::Checked); });
    connect(none, &QPushButton::clicked, this, [setAll] { setAll(Qt::Unchecked); });
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(label);
    buttons->addStretch();
    buttons->addWidget(all);
    buttons->addWidget(none);
    static_cast<QVBoxLayout*>(layout())->addLayout(buttons);
    static_cast<QVBoxLayout*>(layout())->addWidget(m_entries, 1);
}

void HandoutDialog::createOptions() {
    addChoice(m_kind, tr("Handout with pictures"), HandoutOptions::Kind::Handout);
    addChoice(m_kind, tr("Blank worksheet"), HandoutOptions::Kind::TaskSheet);
    m_kind->setAccessibleName(tr("Kind of sheet"));
    m_kind->setWhatsThis(tr("A handout has the picture of each entry, with its cage, its maps and their "
                            "formulas. A blank worksheet has the cage, in the plane on a grid, and an empty "
                            "table, to be filled in by hand."));
    for (const int count : {1, 2, 4, 6})
        addChoice(m_perPage, QString::number(count), count);
    chooseValue(m_perPage, HandoutOptions().perPage);
    m_perPage->setAccessibleName(tr("Entries per page"));
    m_perPage->setWhatsThis(tr("How many entries are printed on one page."));
    m_maps->setChecked(true);
    m_maps->setToolTip(tr("Draw the cage and its numbered images over the picture"));
    m_formulas->setChecked(true);
    m_formulas->setToolTip(tr("Print the formula and the probability of each map"));
    m_nameLine->setToolTip(tr("Leave lines at the top of each page for a name and a date"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Sheet:"), m_kind);
    form->addRow(tr("Entries per &page:"), m_perPage);
    form->addRow(QString(), m_maps);
    form->addRow(QString(), m_formulas);
    form->addRow(QString(), m_nameLine);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        m_nameLine->setChecked(options().kind == HandoutOptions::Kind::TaskSheet);
        update();
    });
}

void HandoutDialog::update() {
    const bool isHandout = options().kind == HandoutOptions::Kind::Handout;
    m_maps->setEnabled(isHandout);
    m_formulas->setEnabled(isHandout);
    if (!m_preview) return;
    const std::size_t count = chosen().size();
    m_preview->setEnabled(count > 0 && count <= std::size_t(maxEntries));
    m_preview->setToolTip(count > std::size_t(maxEntries) ? tr("Choose at most %1 entries").arg(maxEntries)
                          : count == 0                    ? tr("Choose an entry first")
                                                          : tr("Show the pages before they are printed"));
}

HandoutOptions HandoutDialog::options() const {
    return {chosenValue<HandoutOptions::Kind>(m_kind), chosenValue<int>(m_perPage), m_maps->isChecked(),
            m_formulas->isChecked(), m_nameLine->isChecked()};
}

std::vector<std::shared_ptr<const document::Fractal>> HandoutDialog::chosen() const {
    std::vector<std::shared_ptr<const document::Fractal>> all;
    for (int k = 0; k < m_entries->count(); ++k)
        if (m_entries->item(k)->checkState() == Qt::Checked) all.push_back(m_fractals[std::size_t(k)]);
    return all;
}

io::PlaneExport handoutPicture(const document::Fractal& fractal, const HandoutOptions& options) {
    const document::Fractal printed = onPaper(fractal);
    ifs::Vector<2> low = ifs::Vector<2>::Constant(0), high = ifs::Vector<2>::Constant(1);
    if (const auto box = document::boxWithShadow(fractal, attractor::YAxis::Up)) {
        low = box->min;
        high = box->max;
    }
    if (options.showsMaps) {
        const ifs::ControlCage<2> cage = document::effectiveCage(fractal);
        const auto take = [&](const ifs::Vector<2>& corner) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        };
        const auto include = [&](const ifs::AffineMap<2>& map) {
            for (const ifs::Vector<2>& corner : cage.current)
                take(map(corner));
        };
        std::ranges::for_each(cage.rest, take); // dashed, if it was dragged
        include({});
        if (const auto displayed = document::effectiveSystem(fractal))
            for (const auto& map : displayed->maps)
                if (map.enabled) include(map.map);
    }
    if (!((high - low).maxCoeff() > 0)) { // single point
        low.array() -= 0.5;
        high.array() += 0.5;
    }
    const int longSide = longSideOf(options);
    const ifs::Vector<2> size = (high - low).cwiseMax(0.2 * (high - low).maxCoeff());
    attractor::Camera camera;
    camera.width = std::max(1, int(longSide * size.x() / size.maxCoeff()));
    camera.height = std::max(1, int(longSide * size.y() / size.maxCoeff()));
    camera = fitted(camera, low, high, areaMargin);
    io::PlaneExport picture{printed, document::renderRequest(printed, camera), {}};
    picture.request.threads = io::threadsOfThisMachine();
    picture.request.samples = 40ULL * std::uint64_t(camera.width) * std::uint64_t(camera.height);
    picture.overlay.maps = picture.overlay.numbers = picture.overlay.fixedPoints = options.showsMaps;
    picture.overlay.cage = picture.overlay.isCageInked = options.showsMaps;
    return picture;
}

HandoutPictureInSpace handoutPictureInSpace(const document::Fractal& fractal, const HandoutOptions& options) {
    io::PictureOverlay overlay;
    overlay.maps = overlay.numbers = overlay.fixedPoints = options.showsMaps;
    overlay.cage = overlay.isCageInked = options.showsMaps;
    attractor::OrbitCamera camera = standardView();
    camera.size.width = camera.size.height = longSideOf(options);
    const auto marked = document::reachOfVertices(io::spaceOverlayPoints(fractal, overlay));
    const auto reach = [&](const ifs::Vector<3>& u) {
        const double picture = document::extentAlong(fractal, u).high;
        return options.showsMaps ? std::max(picture, marked(u)) : picture;
    };
    camera = attractor::fitted(camera, reach, areaMargin);
    return {spacePicture(fractal, camera, longSideOf(options)),
            io::spaceOverlayMarks(onPaper(fractal), camera, overlay)};
}

// Print dialogs take it for the name of the file that they write.
QString HandoutDialog::printedName() const {
    return tr("%1-handout.pdf", "name of a file").arg(document::fileNamePart(m_name, 200));
}

void HandoutDialog::showPreview() {
    const HandoutOptions wanted = options();
    m_message->clear();
    std::vector<HandoutItem> items;
    const QPointer<HandoutDialog> self(this); // the dialog may close meanwhile
    for (const auto& fractal : chosen()) {
        HandoutItem item{fractal, {}};
        if (wanted.kind == HandoutOptions::Kind::Handout) {
            item.picture = document::plane(*fractal)
                               ? drawnForPaper(handoutPicture(*fractal, wanted), this)
                               : drawnInSpace(handoutPictureInSpace(*fractal, wanted), this);
            if (!self || item.picture.isNull()) return; // cancelled by the user
        }
        items.push_back(std::move(item));
    }
    const auto paint = [items = std::move(items), wanted](QPainter& painter, const QRectF& page,
                                                          const std::function<void()>& newPage) {
        paintHandout(painter, page, items, wanted, newPage);
    };
    showPrintPreview({windowTitle(), printedName(), paint}, this,
                     [this](const QString& sentence, const QString& path) {
                         m_message->setText(sentence);
                         if (!path.isEmpty()) emit written(path);
                     });
}

} // namespace view
