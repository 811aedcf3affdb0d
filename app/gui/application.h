// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>

// Who the program is to the desktop: names, icon, settings, translations.
class Application : public QApplication {
    Q_OBJECT

public:
    Application(int& argc, char** argv);
    ~Application() override;

    // First content of a window without files.
    enum class Start { AsLastTime, New, Collection, Random };
    // Opens a window per file or link; without them one window with the maple, or those of the last run if
    // that is wished. Returns whether there is any: all may have been closed while a file was read.
    bool openWindows(const QStringList& arguments, Start start = Start::AsLastTime);

    bool notify(QObject* receiver, QEvent* event) override;

protected:
    bool event(QEvent* event) override;

private:
    void speak(const QString& language); // empty: the language of the desktop
};
