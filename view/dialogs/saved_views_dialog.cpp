// SPDX-License-Identifier: MIT
#include "dialogs/saved_views_dialog.h"

#include "widgets/text/tooltip_text.h"

#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QShortcut>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace view {

using document::SavedView;

SaveViewDialog::SaveViewDialog(const document::Fractal& fractal, QWidget* parent)
    : QDialog(parent),
      m_views(document::savedViews(fractal)),
      m_name(new QLineEdit(this)),
      m_note(new QLabel(this)) {
    setWindowTitle(tr("Save View"));
    m_name->setAccessibleName(tr("Name of the view"));
    m_name->setWhatsThis(tr("The name under which the view is listed in View, Saved Views, beside the zoom "
                            "and in the export dialogs."));
    auto* caption = new QLabel(tr("&Name of the view:"), this);
    caption->setBuddy(m_name);
    m_note->setWordWrap(true);
    m_note->setAccessibleName(tr("Note"));
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing()); // constant height
    m_note->setAlignment(Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_save = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
    m_save->setDefault(true);
    m_save->setWhatsThis(tr("Keeps the view with the fractal: one step of the history. A view of "
                            "the same name is replaced."));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(caption);
    layout->addWidget(m_name);
    layout->addWidget(m_note);
    layout->addStretch();
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_name, &QLineEdit::textChanged, this, &SaveViewDialog::check);
    const auto isTaken = [this](const QString& name) {
        return std::ranges::any_of(m_views, [&](const SavedView& view) { return view.name == name; });
    };
    std::size_t number = 1;
    while (isTaken(tr("View %1").arg(number)))
        ++number;
    m_name->setText(tr("View %1").arg(number));
    m_name->selectAll();
    resize(sizeHint().expandedTo({340, 0}));
}

QString SaveViewDialog::name() const {
    return document::storableViewName(m_name->text());
}

void SaveViewDialog::check() {
    const QString name = this->name();
    const bool isTaken =
        std::ranges::any_of(m_views, [&](const SavedView& view) { return view.name == name; });
    const bool isFull = !isTaken && m_views.size() >= document::maxSavedViews;
    QString note;
    if (isFull)
        note =
            tr("A fractal can have at most %1 saved views. Delete one first.").arg(document::maxSavedViews);
    else if (isTaken)
        note = tr("Replaces the view of this name.");
    else if (name != m_name->text().simplified())
        note = tr("Saved as “%1”.").arg(name);
    m_note->setText(note);
    m_save->setText(isTaken ? tr("&Replace") : tr("&Save"));
    m_save->setEnabled(!name.isEmpty() && !isFull);
}

SavedViewsDialog::SavedViewsDialog(document::Document* document, Canvas canvas, QWidget* parent)
    : QDialog(parent), m_document(document), m_canvas(std::move(canvas)), m_list(new QListWidget(this)) {
    setWindowTitle(tr("Saved Views"));
    m_list->setAccessibleName(tr("Saved views"));
    m_list->setWhatsThis(
        tr("The views of this fractal. Double-click one to go to it, press F2 to rename it."));
    setWhatsThis(m_list->whatsThis());
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    auto* column = new QVBoxLayout;
    for (QPushButton* button :
         {addButton(tr("&Go To"), tr("Shows this view on the canvas."),
                    [this](const SavedView& view) { m_canvas.lookAt(view.camera); }),
          addButton(tr("&Update"), tr("Replaces it by the current view of the canvas."),
                    [this](const SavedView& view) {
                        m_document->editEntry(tr("Update the view “%1”").arg(view.name),
                                              document::withSavedView(m_document->entryFractal(),
                                                                      {view.name, m_canvas.camera()}));
                    }),
          addButton(tr("&Rename"), tr("Gives the view another name."),
                    [this](const SavedView&) { m_list->editItem(m_list->currentItem()); }),
          addButton(tr("&Delete"), tr("Deletes the view; the fractal stays as it is."),
                    [this](const SavedView& view) {
                        m_document->editEntry(
                            tr("Delete the view “%1”").arg(view.name),
                            document::withoutSavedView(m_document->entryFractal(), view.name));
                    })})
        column->addWidget(button);
    column->addStretch();
    auto* row = new QHBoxLayout;
    row->addWidget(m_list, 1);
    row->addLayout(column);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(row);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { m_buttons.front()->click(); });
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) { rename(*item); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int current) {
        for (QPushButton* button : m_buttons)
            button->setEnabled(current >= 0);
    });
    auto* erase = new QShortcut(QKeySequence::Delete, m_list, nullptr, nullptr, Qt::WidgetShortcut);
    connect(erase, &QShortcut::activated, m_buttons.back(), &QPushButton::click);
    connect(document, &document::Document::changed, this, [this](const document::Change& change) {
        if (!change.live) refresh();
    });
    refresh();
    resize(sizeHint().expandedTo({360, 240}));
}

QPushButton* SavedViewsDialog::addButton(const QString& text, const QString& tip,
                                         const std::function<void(const SavedView&)>& operation) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    button->setEnabled(false);
    connect(button, &QPushButton::clicked, this, [this, operation] {
        if (const auto view = chosen()) operation(*view);
    });
    m_buttons << button;
    return button;
}

std::optional<SavedView> SavedViewsDialog::chosen() const {
    const QListWidgetItem* item = m_list->currentItem();
    return item ? document::savedView(m_document->fractal(), item->data(Qt::UserRole).toString())
                : std::nullopt;
}

void SavedViewsDialog::refresh() {
    const std::vector<SavedView> views = document::savedViews(m_document->fractal());
    const QScopedValueRollback<bool> guard(m_isRefreshing, true);
    const int row = m_list->currentRow();
    QStringList names, listed;
    for (const SavedView& view : views)
        names << view.name;
    for (int i = 0; i < m_list->count(); ++i)
        listed << m_list->item(i)->text();
    if (names == listed) return;
    m_list->clear();
    for (const QString& name : names) {
        auto* item = new QListWidgetItem(name, m_list);
        item->setData(Qt::UserRole, name);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    if (!names.isEmpty()) m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
}

void SavedViewsDialog::rename(const QListWidgetItem& item) {
    if (m_isRefreshing) return;
    const QString before = item.data(Qt::UserRole).toString();
    const QString after = document::storableViewName(item.text());
    const document::Fractal& entry = m_document->entryFractal();
    if (!after.isEmpty() && after != before && !document::savedView(entry, after))
        m_document->editEntry(tr("Rename the view “%1” to “%2”").arg(before, after),
                              document::withViewRenamed(entry, before, after));
    // Shows the stored name.
    QMetaObject::invokeMethod(this, &SavedViewsDialog::refresh, Qt::QueuedConnection);
}

} // namespace view
