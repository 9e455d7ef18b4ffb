// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/settings/folder_rows.h"
#include "widgets/settings/program_settings.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;
class QTabWidget;

namespace codewheel {

// The settings of the program. Not modal, so that ALARM STOP stays within reach; choices take effect at once:
// changed(). Whoever shows it undoes the changes when it is rejected.
class SettingsDialog : public QDialog
{
    Q_OBJECT

public:
    SettingsDialog(const ProgramSettings &settings, const std::vector<KeptFolder> &folders,
                   QWidget *parent = nullptr);

    const ProgramSettings &settings() const { return m_settings; }
    void setSettings(const ProgramSettings &settings); // after a change made elsewhere
    int page() const;
    void setPage(int page);

    void accept() override;

Q_SIGNALS:
    void changed(const codewheel::ProgramSettings &settings);

private:
    QFormLayout *addPage(const QString &title);
    QComboBox *addChoice(QFormLayout &form, const QString &label, const QString &what);
    QCheckBox *addSwitch(QFormLayout &form, const char *id, const QString &label, const QString &what);
    QLineEdit *addText(QFormLayout &form, const QString &label, const QString &what, int longest);
    QSpinBox *addNumber(QFormLayout &form, const QString &label, const QString &unit, const QString &what,
                        SettingRange range);
    void makeLook();
    void makeWarnings();
    void makeKept(const std::vector<KeptFolder> &folders);
    void makeNotices();
    void makeButtons();
    void showValues(const ProgramSettings &settings);
    void take();

    ProgramSettings m_settings;
    bool m_isShowing = true; // changes of the fields are not the user's
    QTabWidget *m_pages;
    QComboBox *m_language = nullptr;
    QComboBox *m_scheme = nullptr;
    QCheckBox *m_largeControls = nullptr;
    QCheckBox *m_lessMotion = nullptr;
    QComboBox *m_decimalSign = nullptr;
    QComboBox *m_frames = nullptr;
    QSpinBox *m_eeprom = nullptr;
    QLineEdit *m_userName = nullptr;
    QSpinBox *m_messageFile = nullptr;
    QSpinBox *m_traceRows = nullptr;
    QSpinBox *m_trendMemory = nullptr;
    QSpinBox *m_keeping = nullptr;
    QCheckBox *m_notices = nullptr;
    QCheckBox *m_noticeSound = nullptr;
};

} // namespace codewheel
