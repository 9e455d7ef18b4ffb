// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/settings_at_work.h"

#include "app/window/window_settings.h"

namespace codewheel {

SettingsAtWork::SettingsAtWork(WindowSettings &settings, Folders folders, QObject *parent)
    : QObject(parent)
    , m_settings(settings)
    , m_folders(std::move(folders))
    , m_now(settings.choices())
{}

void SettingsAtWork::use(const ProgramSettings &settings)
{
    const ProgramSettings before = std::exchange(m_now, settings);
    if (m_now == before)
        return;
    m_settings.setChoices(m_now);
    if (m_dialog) {
        m_dialog->setSettings(m_now);
        m_page = m_dialog->page();
    }
    Q_EMIT changed();
    if (m_now.appearance != before.appearance)
        Q_EMIT appearanceChanged();
    if (m_now.language != before.language || m_now.decimalSign != before.decimalSign)
        Q_EMIT languageChanged();
}

void SettingsAtWork::takeAppearance()
{
    m_now.appearance = m_settings.choices().appearance;
    if (m_dialog)
        m_dialog->setSettings(m_now);
}

void SettingsAtWork::open(QWidget &window)
{
    if (!m_isOpen) {
        m_before = m_now;
        m_page = 0;
    }
    show(window);
}

void SettingsAtWork::goOnIn(QWidget &window)
{
    if (m_isOpen)
        show(window);
}

void SettingsAtWork::show(QWidget &window)
{
    if (!m_dialog) {
        const std::vector<KeptFolder> folders{
            {tr("Settings of the window"), m_settings.folder()},
            {tr("Messages and account of EEPROM writes"), m_folders.messages},
            {tr("Unsaved changes, kept in case of a crash"), m_folders.recovery},
            {tr("Your own device descriptions"), m_folders.devices},
        };
        m_dialog = new SettingsDialog(m_now, folders, &window);
        m_dialog->setAttribute(Qt::WA_DeleteOnClose);
        m_dialog->setPage(m_page);
        connect(m_dialog, &SettingsDialog::changed, this, &SettingsAtWork::use);
        connect(m_dialog, &QDialog::finished, this, &SettingsAtWork::end);
    }
    m_isOpen = true;
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void SettingsAtWork::end(int result)
{
    m_isOpen = false;
    m_dialog = nullptr;
    if (result == QDialog::Rejected)
        use(m_before);
}

} // namespace codewheel
