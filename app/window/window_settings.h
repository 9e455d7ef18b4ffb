// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/look/window_size.h"
#include "vocabulary/place.h"
#include "widgets/settings/program_settings.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>

class QSettings;

namespace codewheel {

// What the window keeps between two runs. The only place that knows the keys.
class WindowSettings
{
public:
    // An ini file; empty: the user's own.
    explicit WindowSettings(const QString &file = {});
    ~WindowSettings();

    // The choices of the dialog, each within its range, whatever the file says.
    ProgramSettings choices() const;
    void setChoices(const ProgramSettings &choices);

    bool isFirstStart() const;
    void noteStart();         // from now on, whatever becomes of this one
    QString lastFile() const; // the project that was open last; empty: none was
    void setLastFile(const QString &file);
    QStringList recentFiles() const; // most recent first
    void setRecentFiles(const QStringList &files);

    QByteArray geometry() const;
    // Of docks and tool bar, for each size the window has had.
    std::map<WindowSize, QByteArray> layouts() const;
    void setWindow(const QByteArray &geometry, const std::map<WindowSize, QByteArray> &layouts);

    std::optional<QJsonObject> monitors() const; // nothing at the first start
    void setMonitors(const QJsonObject &monitors);

    QStringList trend() const; // which curves it shows
    void setTrend(const QStringList &curves);

    QJsonObject recording() const; // what was chosen for the last one
    void setRecording(const QJsonObject &choices);

    // The settings that a link of this kind was connected with last; empty: it never was.
    std::map<QString, QString> lastLink(const QString &kind) const;
    void setLastLink(const QString &kind, const std::map<QString, QString> &settings);

    QSettings &ofKinds() { return *m_settings; } // what a kind of bus keeps of its own

    std::optional<Place> pinnedDial() const; // by the user
    void setPinnedDial(std::optional<Place> place);

    QByteArray helpLayout() const; // of the help window
    void setHelpLayout(const QByteArray &layout);

    // What was typed into the terminal of the serial line, oldest first.
    QStringList typedRequests() const;
    void setTypedRequests(const QStringList &requests);

    QStringList usedCommands() const; // in the command palette, last one first
    void setUsedCommands(const QStringList &ids);

    QString folder() const; // of the file

private:
    int number(const QString &key, int usual, SettingRange range) const;

    std::unique_ptr<QSettings> m_settings;
};

} // namespace codewheel
