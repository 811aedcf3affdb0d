// SPDX-License-Identifier: MIT
#include "application.h"
#include "bars/construction_bar.h"
#include "dialogs/export/animation_export_dialog.h"
#include "dialogs/paste_table_dialog.h"
#include "identity.h"
#include "messages/tour.h"
#include "panels/appearance/palettes/palette_browser.h"
#include "panels/appearance/palettes/picture_palette_dialog.h"
#include "panels/entries/entries_comment_dialog.h"
#include "panels/lesson/lesson_card.h"
#include "panels/timeline/ease_dialog.h"
#include "panels/timeline/morph_dialog.h"
#include "panels/timeline/motion_dialog.h"
#include "panels/timeline/stretch_dialog.h"
#include "panels/timeline/timeline_panel.h"
#include "support/background_rest.h"
#include "support/every_window.h"
#include "support/named_test.h"
#include "support/own_settings.h"
#include "support/paths.h"
#include "support/thorough.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAction>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QProcessEnvironment>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cstdio>
#include <initializer_list>
#include <utility>

namespace {

constexpr int titleBar = 28; // pixels that a desktop takes from a window, which this platform has not

QString sizeOf(const QWidget& widget) {
    return QStringLiteral("%1 × %2").arg(widget.width()).arg(widget.height());
}

bool scrolls(const QScrollBar* bar) {
    return bar->minimum() < bar->maximum();
}

// Whether a part of it is neither seen nor scrolled to.
bool isLost(const QWidget* widget) {
    constexpr int least = 24; // pixels of what scrolls
    for (const QWidget* at = widget; !at->isWindow(); at = at->parentWidget()) {
        const QWidget* around = at->parentWidget();
        const QRect seen(widget->mapTo(around, QPoint()), widget->size());
        const auto* area = qobject_cast<const QAbstractScrollArea*>(around->parentWidget());
        const bool isView = area && area->viewport() == around;
        const bool across = isView && scrolls(area->horizontalScrollBar());
        const bool down = isView && scrolls(area->verticalScrollBar());
        if (!across && (seen.left() < 0 || seen.right() >= around->width())) return true;
        if (!down && (seen.top() < 0 || seen.bottom() >= around->height())) return true;
        if (across || down) return around->width() < least || around->height() < least;
    }
    return false;
}

// Every part of small screens, in a process that has one. What does not fit is written a line each.
class SmallScreen {
public:
    SmallScreen()
        : m_room(QGuiApplication::primaryScreen()->availableGeometry().adjusted(0, titleBar, 0, 0)) {}

    int check() {
        checkLessons();
        checkTour();
        checkWindow();
        checkDialogs({});
        checkDialogs(support::sourcePath(QStringLiteral("ifs_library/space_plants.ifs")));
        checkCollection();
        m_found.removeDuplicates();
        for (const QString& line : m_found)
            std::printf("%s\n", qPrintable(line));
        std::printf("%d steps, %d cards, %d panels, %d dialogs\n", m_steps, m_cards, m_panels, m_dialogs);
        return 0;
    }

private:
    void find(const QString& where, const QString& what) { m_found << where + QStringLiteral(": ") + what; }

    void checkSize(const QWidget& window, const QString& name) {
        if (window.width() > m_room.width() || window.height() > m_room.height()) find(name, sizeOf(window));
    }

    void checkButtons(const QWidget& part, const QString& name) {
        for (const auto* button : part.findChildren<QAbstractButton*>())
            if (button->isVisible() && button->window() == part.window() &&
                !button->objectName().startsWith(u"qt_") && isLost(button))
                find(name, support::EveryWindow::describe(button));
    }

    void checkLessons();
    void checkTour();
    void checkWindow();
    void checkDialogs(const QString& path);
    void checkDialog(QWidget& dialog);
    void checkCollection();

    const QRect m_room;
    QStringList m_found;
    int m_steps = 0;
    int m_cards = 0;
    int m_panels = 0;
    int m_dialogs = 0;
};

void SmallScreen::checkLessons() {
    for (const char* name : {"chaos_game", "maple_triangle"}) {
        MainWindow window;
        window.setAttribute(Qt::WA_DeleteOnClose, false);
        window.openFirstPicture();
        window.show();
        support::handleEvents();
        for (auto* action : window.findChildren<QAction*>())
            if (action->data() == QLatin1String(name)) action->trigger();
        const auto* card = window.findChild<view::LessonCard*>();
        if (!card) return;
        for (QAbstractButton* next = nullptr; card->isVisible(); next->click()) {
            support::handleEvents();
            const QString where = QStringLiteral("%1, step %2").arg(QLatin1String(name)).arg(++m_steps);
            next = card->findChild<QAbstractButton*>(QStringLiteral("next"));
            if (!next || window.width() > m_room.width() || window.height() > m_room.bottom() + 1)
                return find(where, sizeOf(window));
            checkButtons(*card, where);
            const auto* text = card->findChild<QScrollArea*>();
            if (text->viewport()->height() < 3 * text->widget()->fontMetrics().lineSpacing())
                find(where, QStringLiteral("the text is %1 pixels high").arg(text->viewport()->height()));
            if (text->viewport()->width() < text->widget()->minimumSizeHint().width())
                find(where, QStringLiteral("the text is %1 pixels wide").arg(text->viewport()->width()));
            for (const auto* label : card->findChildren<QLabel*>())
                if (label->isVisible() && label != text->widget() && isLost(label))
                    find(where, support::EveryWindow::describe(label));
        }
        window.document().undoStack()->setClean();
    }
}

// The words and buttons of each card are whole, whatever room the panels leave.
void SmallScreen::checkTour() {
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.openFirstPicture();
    window.show();
    support::handleEvents();
    Tour::start(&window, &window.document(), window.panels());
    for (const auto* tour = window.findChild<Tour*>(); tour && tour->isVisible();) {
        support::handleEvents();
        const QString where = QStringLiteral("tour, step %1").arg(tour->step());
        checkSize(window, where);
        checkButtons(*tour, where);
        QAbstractButton* next = nullptr;
        for (auto* button : tour->findChildren<QAbstractButton*>()) {
            if (!button->isVisible()) continue;
            if (button->width() < button->sizeHint().width())
                find(where, support::EveryWindow::describe(button));
            for (const char* name : {"skip", "go-on", "done"})
                if (button->objectName() == QLatin1String(name)) next = button;
        }
        for (const auto* label : tour->findChildren<QLabel*>())
            if (label->isVisible() && (isLost(label) || label->width() < label->minimumSizeHint().width() ||
                                       label->height() < label->heightForWidth(label->width())))
                find(where, support::EveryWindow::describe(label));
        if (!next) return find(where, QStringLiteral("no button leads on"));
        ++m_cards;
        next->click();
        support::handleEvents();
        tour = window.findChild<Tour*>();
    }
    window.document().undoStack()->setClean();
}

void SmallScreen::checkWindow() {
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.openFirstPicture();
    window.show();
    support::handleEvents();
    checkSize(window, QStringLiteral("window"));
    auto* built = window.findChild<QAction*>(QStringLiteral("how-it-is-built"));
    built->trigger();
    for (auto* button : window.findChild<view::ConstructionBar*>()->findChildren<QToolButton*>())
        if (button->isCheckable() && button->isVisible()) {
            button->click();
            support::handleEvents();
            checkSize(window, QStringLiteral("window with ") + support::EveryWindow::describe(button));
        }
    built->trigger();
    support::handleEvents();
    const QRect place = window.geometry();
    for (auto* dock : window.findChildren<QDockWidget*>()) {
        if (dock->features() == QDockWidget::NoDockWidgetFeatures) continue;
        const QString name = dock->objectName();
        const bool isUsual = !dock->isHidden();
        dock->show();
        dock->raise();
        if (!support::backgroundRests()) find(name, QStringLiteral("the background does not rest"));
        ++m_panels;
        checkSize(window, QStringLiteral("window with ") + name);
        if (dock->visibleRegion().isEmpty() || !window.rect().contains(dock->geometry()))
            find(name, QStringLiteral("is not seen"));
        checkButtons(*dock, name);
        dock->setFloating(true);
        support::handleEvents();
        checkSize(*dock, name + QStringLiteral(", floating"));
        checkButtons(*dock, name + QStringLiteral(", floating"));
        dock->setFloating(false);
        if (!isUsual) dock->hide();
        support::handleEvents();
        window.setGeometry(place);
        support::handleEvents();
    }
    window.document().undoStack()->setClean();
}

void SmallScreen::checkDialogs(const QString& path) {
    const support::EveryWindow windows(path);
    for (const auto& dialog : windows.dialogs())
        if (dialog) checkDialog(*dialog); // the command palette goes when another window comes
    document::Document& document = windows.main().document();
    const document::Fractal& fractal = document.fractal();
    view::PaletteBrowser palettes(fractal.appearance.palette);
    view::PicturePaletteDialog picture(QImage(800, 600, QImage::Format_RGB32));
    view::EntriesCommentDialog comment(fractal);
    view::EaseDialog ease({});
    view::MorphDialog morph(document, 60);
    view::StretchDialog stretch(document.sharedFractal(), {});
    for (QDialog* dialog :
         std::initializer_list<QDialog*>{&palettes, &picture, &comment, &ease, &morph, &stretch})
        checkDialog(*dialog);
    if (document::plane(document.fractal())) {
        view::PasteTableDialog table(&document, {}, QStringLiteral(".5 0 0 .5 0 0\n.5 0 0 .5 .5 0\n"));
        checkDialog(table);
    }
    windows.main().findChild<view::TimelinePanel*>()->motions().front()->trigger();
    view::MotionDialog motion(document, 0, QStringLiteral("motion"));
    checkDialog(motion);
    using Camera = view::AnimationExportDialog::Camera;
    const bool isSolid = document::space(document.fractal()) != nullptr;
    view::AnimationExportDialog animation(&document, isSolid ? Camera(attractor::OrbitCamera())
                                                             : Camera(attractor::View()));
    checkDialog(animation);
}

// Without its pictures, which take long to be drawn and change no size.
void SmallScreen::checkCollection() {
    MainWindow window;
    window.setAttribute(Qt::WA_DeleteOnClose, false);
    window.openFirstPicture();
    window.show();
    window.findChild<QAction*>(QStringLiteral("collection"))->trigger();
    support::handleEvents();
    auto* collection = window.findChild<QDialog*>(QStringLiteral("collection-window"));
    checkSize(*collection, QStringLiteral("collection"));
    checkButtons(*collection, QStringLiteral("collection"));
    ++m_dialogs;
    collection->close();
    window.document().undoStack()->setClean();
}

// With each of its pages.
void SmallScreen::checkDialog(QWidget& dialog) {
    const QString name = QString::fromLatin1(dialog.metaObject()->className());
    ++m_dialogs;
    dialog.setWindowModality(Qt::NonModal);
    dialog.show();
    const auto check = [&] {
        if (!support::backgroundRests()) find(name, QStringLiteral("the background does not rest"));
        checkSize(dialog, name);
        checkButtons(dialog, name);
    };
    check();
    for (auto* tabs : dialog.findChildren<QTabWidget*>())
        for (int page = 0; page < tabs->count(); ++page) {
            tabs->setCurrentIndex(page);
            check();
        }
    dialog.hide();
}

} // namespace

// At 1024 × 768 with letters for 96, 120 and 144 dots per inch, and at 1920 × 1080 for 192: desktops enlarge
// everything by as much, so that the screen is as much smaller.
class SmallScreensTest : public QObject {
    Q_OBJECT

private slots:
    void everythingFits_data();
    void everythingFits();
};

void SmallScreensTest::everythingFits_data() {
    QTest::addColumn<QSize>("pixels");
    QTest::addColumn<int>("dpi");
    QTest::addColumn<QString>("language");
    constexpr std::array languages{"en", "de", "es", "fr", "mk"};
    const std::array<std::pair<QSize, int>, 4> screens{
        {{{1024, 768}, 96}, {{1024, 768}, 120}, {{1024, 768}, 144}, {{1920, 1080}, 192}}};
    for (std::size_t i = 0; i < languages.size(); ++i)
        for (std::size_t k = 0; k < screens.size(); ++k) {
            const auto& [pixels, dpi] = screens[k];
            if (support::isThorough() || i == (k + 1) % 4 || (i == 4 && k == 2)) // each language, each screen
                QTest::addRow("%d × %d, %d dpi, %s", pixels.width(), pixels.height(), dpi, languages[i])
                    << pixels << dpi << QString::fromLatin1(languages[i]);
        }
}

void SmallScreensTest::everythingFits() {
    QFETCH(QSize, pixels);
    QFETCH(int, dpi);
    QFETCH(QString, language);
    const QTemporaryDir folder;
    QFile screen(folder.filePath(QStringLiteral("screen.json")));
    QVERIFY(screen.open(QIODevice::WriteOnly));
    screen.write(QStringLiteral(R"({"screens": [{"name": "small", "x": 0, "y": 0, "width": %1, "height": %2,
        "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1}]})")
                     .arg(pixels.width() * 96 / dpi)
                     .arg(pixels.height() * 96 / dpi)
                     .toUtf8());
    screen.close();
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"),
                       QStringLiteral("offscreen:configfile=") + screen.fileName());
    environment.insert(QStringLiteral("HOME"), folder.path()); // where the language is stored
    environment.remove(QStringLiteral("XDG_CONFIG_HOME"));
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("small_screens_test"), QStringLiteral("--look"), language});
    const bool hasEnded = program.waitForFinished(240'000);
    if (!hasEnded) program.kill();
    program.waitForFinished();
    QVERIFY2(hasEnded && program.exitStatus() == QProcess::NormalExit, program.readAllStandardError());
    QStringList said = QString::fromUtf8(program.readAllStandardOutput()).split(u'\n', Qt::SkipEmptyParts);
    QVERIFY(!said.isEmpty());
    const QString seen = said.takeLast();
    QVERIFY2(said.isEmpty(), qPrintable(said.join(u'\n')));
    QCOMPARE(seen, QStringLiteral("15 steps, 11 cards, 14 panels, 44 dialogs"));
}

static int runSmallScreens(int argc, char** argv) {
    if (argc > 2 && qstrcmp(argv[1], "--look") == 0) {
        const QString language = QString::fromLatin1(argv[2]);
        const auto speak = [&] { QSettings().setValue(QStringLiteral("preferences/language"), language); };
        QCoreApplication::setOrganizationName(resources::applicationName());
        QCoreApplication::setApplicationName(resources::applicationName());
        speak();
        Application application(argc, argv);
        QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
        QApplication::setQuitOnLastWindowClosed(false);
        support::useOwnSettings();
        speak();
        return SmallScreen().check();
    }
    const QCoreApplication application(argc, argv);
    SmallScreensTest test;
    return QTest::qExec(&test, argc, argv);
}

static const support::NamedTest namedSmallScreens(__FILE__, runSmallScreens);

#include "small_screens_test.moc"
