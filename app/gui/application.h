// SPDX-License-Identifier: MIT
#pragma once

#include <QApplication>

// Who the program is to the desktop: names, icon, settings, translations.
class Application : public QApplication {
    Q_OBJECT

public:
    Application(int& argc, char** argv);

    // One window per file; without files one window with the maple.
    void openWindows(const QStringList& files);

protected:
    bool event(QEvent* event) override;

private:
    void speak(const QString& language); // empty: that of the desktop
};
