// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/appearance.h"

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

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
    QByteArray layout() const; // of docks and tool bar
    void setWindow(const QByteArray &geometry, const QByteArray &layout);

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
