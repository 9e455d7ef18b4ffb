// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/settings/settings_dialog.h"

#include <QObject>
#include <QPointer>

namespace codewheel {

class WindowSettings;

// The settings of the program, as they are now: kept, told to whoever goes by them, and shown in their
// dialog, which goes on in the new window when another language makes the window anew.
class SettingsAtWork : public QObject
{
    Q_OBJECT

public:
    // Where things are kept, for the dialog.
    struct Folders
    {
        QString messages; // and EEPROM counts
        QString recovery;
        QString devices;
    };
    // The settings outlive it.
    SettingsAtWork(WindowSettings &settings, Folders folders, QObject *parent = nullptr);

    const ProgramSettings &now() const { return m_now; }
    void use(const ProgramSettings &settings);
    // The window has changed these by itself.
    void takeAppearance();

    void open(QWidget &window);
    void goOnIn(QWidget &window); // made anew

Q_SIGNALS:
    void languageChanged(); // or the form of numbers: all texts have to be made again
    void appearanceChanged();
    void changed();

private:
    void show(QWidget &window);
    void end(int result);

    WindowSettings &m_settings;
    const Folders m_folders;
    ProgramSettings m_now;
    ProgramSettings m_before; // the dialog
    bool m_isOpen = false;
    int m_page = 0;
    QPointer<SettingsDialog> m_dialog;
};

} // namespace codewheel
