// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/window_size.h"
#include "widgets/look/appearance.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <map>
#include <memory>
#include <optional>

class QSettings;

namespace codewheel {

// What is kept between two runs of the window. The only place that knows the keys.
class WindowSettings
{
public:
    // An ini file; empty: the user's own.
    explicit WindowSettings(const QString &file = {});
    ~WindowSettings();

    QString language() const; // "de", "en", or empty: the system's
    void setLanguage(const QString &language);
    Appearance appearance() const;
    void setAppearance(const Appearance &appearance);

    QStringList recentFiles() const; // the last one first
    void setRecentFiles(const QStringList &files);

    QByteArray geometry() const;
    // Of docks and tool bar, in each size that the window has had.
    std::map<WindowSize, QByteArray> layouts() const;
    void setWindow(const QByteArray &geometry, const std::map<WindowSize, QByteArray> &layouts);

    std::optional<QJsonObject> monitors() const; // nothing at first start
    void setMonitors(const QJsonObject &monitors);

    // What was typed in the terminal of the serial line, oldest first.
    QStringList typedRequests() const;
    void setTypedRequests(const QStringList &requests);

    // Beyond it the oldest messages are dropped; bytes. "messages/largestFile", in MB, is changed in the
    // file.
    qint64 largestMessageFile() const;

private:
    std::unique_ptr<QSettings> m_settings;
};

} // namespace codewheel
