// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/settings/settings_dialog.h"

#include <QObject>
#include <QPointer>

namespace codewheel {

class WindowSettings;

// The program's settings in use: saved, passed on to whoever needs them, and shown in their dialog, which
// continues in the new window when a change of language rebuilds it.
class SettingsAtWork : public QObject
{
    Q_OBJECT

public:
    // Where things are kept, shown in the dialog.
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
    // The window has changed these itself.
    void takeAppearance();

    void open(QWidget &window);
    void goOnIn(QWidget &window); // after it was rebuilt

Q_SIGNALS:
    void languageChanged(); // or the format of numbers: all texts have to be made again
    void appearanceChanged();
    void changed();

private:
    void show(QWidget &window);
    void end(int result);

    WindowSettings &m_settings;
    const Folders m_folders;
    ProgramSettings m_now;
    ProgramSettings m_before; // when the dialog was opened
    bool m_isOpen = false;
    int m_page = 0;
    QPointer<SettingsDialog> m_dialog;
};

} // namespace codewheel
