// SPDX-License-Identifier: MIT
#include "dialogs/preferences_dialog.h"

#include "dialogs/shortcuts_page.h"
#include "widgets/choices.h"
#include "widgets/layout/grow_to_fit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

namespace view {

namespace {

// Each in itself, so that whoever does not read the present one finds theirs.
const QList<std::pair<QString, QString>>& languages() {
    static const QList<std::pair<QString, QString>> list{
        {QStringLiteral("en"), QStringLiteral("English")},
        {QStringLiteral("de"), QStringLiteral("Deutsch")},
        {QStringLiteral("es"), QStringLiteral("Español")},
        {QStringLiteral("fr"), QStringLiteral("Français")},
        {QStringLiteral("mk"), QStringLiteral("Македонски")}};
    return list;
}

template <class Value> void fillIn(QComboBox* box, const Value& value) {
    const QSignalBlocker quiet(box);
    if (!chooseValue(box, value)) box->setCurrentIndex(0);
}

void offerThemes(QComboBox* box) {
    addChoice(box, PreferencesDialog::tr("System default"), Preferences::Theme::Desktop);
    addChoice(box, PreferencesDialog::tr("Light"), Preferences::Theme::Light);
    addChoice(box, PreferencesDialog::tr("Dark"), Preferences::Theme::Dark);
    box->setAccessibleName(PreferencesDialog::tr("Theme"));
    box->setWhatsThis(
        PreferencesDialog::tr("The colours of windows and panels. The picture keeps its own colours."));
}

void offerQuality(QComboBox* box) {
    addChoice(box, PreferencesDialog::tr("Draft: 50 million points"), quint64(50'000'000));
    addChoice(box, PreferencesDialog::tr("Good: 200 million points"), quint64(200'000'000));
    addChoice(box, PreferencesDialog::tr("Fine: 1000 million points"), quint64(1'000'000'000));
    box->setAccessibleName(PreferencesDialog::tr("Picture at rest"));
    box->setWhatsThis(
        PreferencesDialog::tr("The number of points drawn while nothing moves. More points make a smoother "
                              "picture and keep the processor busy for longer."));
}

void offerTurning(QComboBox* box) {
    addChoice(box, PreferencesDialog::tr("Turntable"), false);
    addChoice(box, PreferencesDialog::tr("Trackball"), true);
    box->setAccessibleName(PreferencesDialog::tr("Solids turn like"));
    box->setWhatsThis(PreferencesDialog::tr(
        "How a drag turns a solid. On a turntable, vertical lines stay vertical. A trackball turns freely "
        "about the axes of the screen, even over the poles; to level the view again, look along an axis."));
}

void explainFiles(QCheckBox* reopen, QCheckBox* keepPrevious) {
    reopen->setWhatsThis(
        PreferencesDialog::tr("When this is on, Barycage reopens the files that were open when you closed "
                              "it, each in its own window."));
    keepPrevious->setWhatsThis(PreferencesDialog::tr(
        "When this is on, the first time that you save a file after opening it, the version before stays "
        "beside it under the same name with “~” behind it, such as maple.ifs~."));
}

void offerMotion(QComboBox* box) {
    addChoice(box, PreferencesDialog::tr("System default"), Preferences::Motion::Desktop);
    addChoice(box, PreferencesDialog::tr("Play when opened"), Preferences::Motion::Full);
    addChoice(box, PreferencesDialog::tr("Still until played"), Preferences::Motion::Reduced);
    box->setAccessibleName(PreferencesDialog::tr("Motion"));
    box->setWhatsThis(PreferencesDialog::tr(
        "Whether an entry that moves plays as soon as it is opened. When your desktop asks for less motion, "
        "the system default shows a still picture until you press Play."));
}

} // namespace

PreferencesDialog::PreferencesDialog(QWidget* parent, const QList<NamedAction>& commands)
    : QDialog(parent),
      m_pages(new QTabWidget(this)),
      m_spoken(Preferences::spokenLanguage()),
      m_language(new QComboBox(this)),
      m_restart(new QLabel(tr("Restart to change the language."), this)),
      m_restartNow(new QPushButton(tr("Restart &Now"), this)),
      m_theme(new QComboBox(this)),
      m_motion(new QComboBox(this)),
      m_quality(new QComboBox(this)),
      m_turning(new QComboBox(this)),
      m_reopen(new QCheckBox(tr("Re&open last files on startup"), this)),
      m_keepPrevious(new QCheckBox(tr("&Keep the previous version of files"), this)) {
    setWindowTitle(tr("Preferences"));
    addChoice(m_language, tr("System default"), QString());
    for (const auto& [code, name] : languages())
        addChoice(m_language, name, code);
    m_language->setAccessibleName(tr("Language"));
    m_language->setWhatsThis(tr("The language of menus and messages. Files and numbers are the same in every "
                                "language."));
    offerThemes(m_theme);
    offerQuality(m_quality);
    offerTurning(m_turning);
    explainFiles(m_reopen, m_keepPrevious);
    offerMotion(m_motion);

    addPages(commands);

    fill(Preferences::stored());
    for (QComboBox* box : {m_language, m_theme, m_motion, m_quality, m_turning})
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::take);
    for (QCheckBox* box : {m_reopen, m_keepPrevious})
        connect(box, &QCheckBox::toggled, this, &PreferencesDialog::take);
}

void PreferencesDialog::addPages(const QList<NamedAction>& commands) {
    m_pages->addTab(generalPage(), tr("&General"));
    if (!commands.isEmpty()) m_pages->addTab(new ShortcutsPage(commands, this), tr("S&hortcuts"));
    m_pages->setTabBarAutoHide(true);
    m_pages->setAccessibleName(tr("Preferences"));
    m_pages->setWhatsThis(tr("The settings of windows and pictures, and the keys of commands."));
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

QWidget* PreferencesDialog::generalPage() {
    auto* page = new QWidget(this);
    auto* form = new QFormLayout(page);
    form->setHorizontalSpacing(16);
    form->addRow(tr("&Language:"), m_language);
    form->addRow(QString(), m_restart);
    form->addRow(QString(), restartRow());
    form->addRow(tr("&Theme:"), m_theme);
    form->addRow(tr("&Motion:"), m_motion);
    form->addRow(tr("&Picture at rest:"), m_quality);
    form->addRow(tr("&Solids turn like:"), m_turning);
    form->addRow(QString(), m_reopen);
    form->addRow(QString(), m_keepPrevious);
    return page;
}

void PreferencesDialog::restoreDefaults() {
    if (auto* shortcuts = qobject_cast<ShortcutsPage*>(m_pages->currentWidget()))
        return shortcuts->restoreDefaults();
    fill({});
    take();
}

QLayout* PreferencesDialog::restartRow() {
    m_restart->setForegroundRole(QPalette::PlaceholderText);
    m_restart->setWordWrap(true);
    m_restartNow->setAutoDefault(false);
    m_restartNow->setWhatsThis(
        tr("Closes all windows, asking about unsaved changes first, and opens the same "
           "files again in the new language."));
    connect(m_restartNow, &QPushButton::clicked, this, &PreferencesDialog::restartRequested);
    auto* row = new QHBoxLayout;
    row->addWidget(m_restartNow);
    row->addStretch();
    return row;
}

void PreferencesDialog::fill(const Preferences& preferences) {
    fillIn(m_language, preferences.language);
    fillIn(m_theme, preferences.theme);
    fillIn(m_motion, preferences.motion);
    fillIn(m_quality, quint64(preferences.quality));
    fillIn(m_turning, preferences.trackball);
    const QSignalBlocker quiet(m_reopen), quietToo(m_keepPrevious);
    m_reopen->setChecked(preferences.reopen);
    m_keepPrevious->setChecked(preferences.keepPrevious);
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
    Preferences chosen;
    chosen.language = chosenValue<QString>(m_language);
    chosen.theme = chosenValue<Preferences::Theme>(m_theme);
    chosen.motion = chosenValue<Preferences::Motion>(m_motion);
    chosen.quality = chosenValue<quint64>(m_quality);
    chosen.trackball = chosenValue<bool>(m_turning);
    chosen.reopen = m_reopen->isChecked();
    chosen.keepPrevious = m_keepPrevious->isChecked();
    showRestart(chosen.language != m_spoken);
    growToFit(*this);
    chosen.store();
    emit changed(chosen);
}

} // namespace view
