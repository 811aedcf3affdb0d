// SPDX-License-Identifier: MIT
#include "dialogs/preferences_dialog.h"

#include "dialogs/shortcuts_page.h"
#include "dialogs/toolbar_page.h"
#include "widgets/choices.h"
#include "widgets/layout/grow_to_fit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTabWidget>
#include <QVBoxLayout>

namespace view {

namespace {

// Languages in their own names, so that people find theirs who do not read the present one.
const QList<std::pair<QString, QString>>& languages() {
    static const QList<std::pair<QString, QString>> list{
        {QStringLiteral("English"), QStringLiteral("en")},
        {QStringLiteral("Deutsch"), QStringLiteral("de")},
        {QStringLiteral("Español"), QStringLiteral("es")},
        {QStringLiteral("Français"), QStringLiteral("fr")},
        {QStringLiteral("Македонски"), QStringLiteral("mk")}};
    return list;
}

} // namespace

PreferencesDialog::PreferencesDialog(QWidget* parent, const QList<NamedAction>& commands,
                                     const QStringList& usualTools)
    : QDialog(parent), m_pages(new QTabWidget(this)), m_spoken(Preferences::spokenLanguage()) {
    setWindowTitle(tr("Preferences"));
    addPages(commands, usualTools);
    fill(Preferences::stored());
}

void PreferencesDialog::addPages(const QList<NamedAction>& commands, const QStringList& usualTools) {
    m_pages->addTab(generalPage(), tr("&General"));
    if (!commands.isEmpty()) {
        addToolbarPage(commands, usualTools);
        m_pages->addTab(new ShortcutsPage(commands, this), tr("S&hortcuts"));
    }
    m_pages->setTabBarAutoHide(true);
    m_pages->setAccessibleName(tr("Preferences"));
    m_pages->setWhatsThis(
        tr("The settings of windows and pictures, the commands of the toolbar, and the keys of commands."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults, this);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_pages);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    QPushButton* defaults = buttons->button(QDialogButtonBox::RestoreDefaults);
    defaults->setAutoDefault(false);
    buttons->button(QDialogButtonBox::Close)->setDefault(true);
    defaults->setWhatsThis(tr("Resets every setting on this page to its default."));
    connect(defaults, &QPushButton::clicked, this, &PreferencesDialog::restoreDefaults);
}

void PreferencesDialog::addToolbarPage(const QList<NamedAction>& commands, const QStringList& usualTools) {
    auto* page = new ToolbarPage(commands, usualTools, this);
    m_fields.push_back({[page](const Preferences& preferences) { page->setTools(preferences.tools); },
                        [page](Preferences& preferences) { preferences.tools = page->tools(); }});
    connect(page, &ToolbarPage::changed, this, &PreferencesDialog::take);
    m_pages->addTab(page, tr("Tool&bar"));
}

template <class Value>
QComboBox* PreferencesDialog::list(Value Preferences::*member, const QString& name, const QString& whatsThis,
                                   const QList<std::pair<QString, Value>>& choices) {
    auto* box = new QComboBox(this);
    for (const auto& [text, value] : choices)
        addChoice(box, text, value);
    box->setAccessibleName(name);
    box->setWhatsThis(whatsThis);
    const auto show = [box, member](const Preferences& preferences) {
        if (!chooseValue(box, preferences.*member)) box->setCurrentIndex(0);
    };
    m_fields.push_back(
        {show, [box, member](Preferences& preferences) { preferences.*member = chosenValue<Value>(box); }});
    connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::take);
    return box;
}

QCheckBox* PreferencesDialog::checkBox(bool Preferences::*member, const QString& text,
                                       const QString& whatsThis) {
    auto* box = new QCheckBox(text, this);
    box->setWhatsThis(whatsThis);
    m_fields.push_back(
        {[box, member](const Preferences& preferences) { box->setChecked(preferences.*member); },
         [box, member](Preferences& preferences) { preferences.*member = box->isChecked(); }});
    connect(box, &QCheckBox::toggled, this, &PreferencesDialog::take);
    return box;
}

QWidget* PreferencesDialog::generalPage() {
    using Theme = Preferences::Theme;
    using Motion = Preferences::Motion;
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setHorizontalSpacing(16);
    addLanguage(form);
    form->addRow(tr("&Theme:"),
                 list(&Preferences::theme, tr("Theme"),
                      tr("The colours of windows and panels. The picture keeps its own colours."),
                      {{tr("System default"), Theme::Desktop},
                       {tr("Light"), Theme::Light},
                       {tr("Dark"), Theme::Dark}}));
    form->addRow(tr("&Motion:"),
                 list(&Preferences::motion, tr("Motion"),
                      tr("Whether an entry that moves plays as soon as it is opened. When your desktop asks "
                         "for less motion, the system default shows a still picture until you press Play."),
                      {{tr("System default"), Motion::Desktop},
                       {tr("Play when opened"), Motion::Full},
                       {tr("Still until played"), Motion::Reduced}}));
    form->addRow(
        tr("&Picture at rest:"),
        list(&Preferences::quality, tr("Picture at rest"),
             tr("The number of points drawn while nothing moves. More points make a smoother picture "
                "and keep the processor busy for longer."),
             {{tr("Draft: 50 million points"), 50'000'000},
              {tr("Good: 200 million points"), 200'000'000},
              {tr("Fine: 1000 million points"), 1'000'000'000}}));
    form->addRow(
        tr("&Solids turn like:"),
        list(&Preferences::trackball, tr("Solids turn like"),
             tr("How a drag turns a solid. On a turntable, vertical lines stay vertical. A trackball turns "
                "freely about the axes of the screen, even over the poles; to level the view again, look "
                "along "
                "an axis."),
             {{tr("Turntable"), false}, {tr("Trackball"), true}}));
    form->addRow(
        QString(),
        checkBox(&Preferences::labels, tr("&Names under the symbols of the toolbar"),
                 tr("When this is on, the toolbar shows the name of each command under its symbol.")));
    form->addRow(QString(), checkBox(&Preferences::reopen, tr("Re&open last files on startup"),
                                     tr("When this is on, Barycage reopens the files that were open when you "
                                        "closed it, each in its own window.")));
    form->addRow(QString(),
                 checkBox(&Preferences::keepPrevious, tr("&Keep the previous version of files"),
                          tr("When this is on, the first time that you save a file after opening it, the "
                             "version before stays beside it under the same name with “~” behind it, such as "
                             "maple.ifs~.")));
    return page;
}

void PreferencesDialog::restoreDefaults() {
    if (auto* shortcuts = qobject_cast<ShortcutsPage*>(m_pages->currentWidget()))
        return shortcuts->restoreDefaults();
    const auto* toolbar = qobject_cast<ToolbarPage*>(m_pages->currentWidget());
    Preferences chosen = toolbar ? Preferences::stored() : Preferences();
    chosen.tools = toolbar ? QStringList() : Preferences::stored().tools;
    fill(chosen);
    take();
}

void PreferencesDialog::addLanguage(QFormLayout* form) {
    form->addRow(tr("&Language:"),
                 list(&Preferences::language, tr("Language"),
                      tr("The language of menus and messages. Files and numbers are the same in every "
                         "language."),
                      QList<std::pair<QString, QString>>{{tr("System default"), QString()}} + languages()));
    m_restart = new QLabel(tr("Restart to change the language."), this);
    m_restart->setForegroundRole(QPalette::PlaceholderText);
    m_restart->setWordWrap(true);
    m_restartNow = new QPushButton(tr("Restart &Now"), this);
    m_restart->setObjectName(QStringLiteral("restart-note"));
    m_restartNow->setObjectName(QStringLiteral("restart"));
    m_restartNow->setAutoDefault(false);
    m_restartNow->setWhatsThis(
        tr("Closes all windows, asking about unsaved changes first, and opens the same "
           "files again in the new language."));
    connect(m_restartNow, &QPushButton::clicked, this, &PreferencesDialog::restartRequested);
    auto* row = new QHBoxLayout;
    row->addWidget(m_restartNow);
    row->addStretch();
    form->addRow(QString(), m_restart);
    form->addRow(QString(), row);
}

void PreferencesDialog::fill(const Preferences& preferences) {
    const QScopedValueRollback filling(m_isFilling, true);
    for (const Field& field : m_fields)
        field.show(preferences);
    showRestart(preferences.language != m_spoken);
}

void PreferencesDialog::showRestart(bool shown) {
    m_restart->setVisible(shown);
    m_restartNow->setVisible(shown);
}

void PreferencesDialog::setUnsaved(const QStringList& names) {
    m_restart->setText(tr("Restart to change the language."));
    if (!names.isEmpty())
        m_restart->setText(m_restart->text() + u' ' +
                           tr("Not saved yet: %1.").arg(names.join(QStringLiteral(", "))));
}

void PreferencesDialog::take() {
    if (m_isFilling) return;
    Preferences chosen = Preferences::stored(); // includes settings without a row here
    for (const Field& field : m_fields)
        field.take(chosen);
    showRestart(chosen.language != m_spoken);
    growToFit(*this);
    chosen.store();
    emit changed(chosen);
}

} // namespace view
