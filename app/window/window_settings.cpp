// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_settings.h"

#include <QJsonDocument>
#include <QSettings>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr std::array schemeNames{"system", "light", "dark"};

QString nameOf(Scheme scheme)
{
    return QString::fromLatin1(schemeNames.at(static_cast<std::size_t>(scheme)));
}

Scheme schemeOf(const QString &name)
{
    const auto found =
        std::ranges::find_if(schemeNames, [&](const char *known) { return name == QLatin1String(known); });
    return found == schemeNames.end() ? Scheme::system : static_cast<Scheme>(found - schemeNames.begin());
}

QString layoutKey(WindowSize size)
{
    constexpr std::array names{"narrow", "low", "usual", "wide"};
    return QStringLiteral("window/layouts/%1").arg(QLatin1String(names.at(static_cast<std::size_t>(size))));
}

const QString languageKey = QStringLiteral("language");
const QString schemeKey = QStringLiteral("appearance/scheme");
const QString largeControlsKey = QStringLiteral("appearance/largeControls");
const QString lessMotionKey = QStringLiteral("appearance/lessMotion");
const QString recentFilesKey = QStringLiteral("project/recentFiles");
const QString geometryKey = QStringLiteral("window/geometry");
const QString monitorsKey = QStringLiteral("window/monitors");
const QString typedRequestsKey = QStringLiteral("line/typedRequests");
const QString largestMessageFileKey = QStringLiteral("messages/largestFile");
constexpr qint64 usualMessageFile = 200; // MB
constexpr qint64 smallestMessageFile = 1;
constexpr qint64 megabyte = 1'000'000;

} // namespace

WindowSettings::WindowSettings(const QString &file)
    : m_settings(file.isEmpty()
                     ? std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope,
                                                   QStringLiteral("codewheel"), QStringLiteral("codewheel"))
                     : std::make_unique<QSettings>(file, QSettings::IniFormat))
{}

WindowSettings::~WindowSettings() = default;

QString WindowSettings::language() const
{
    return m_settings->value(languageKey).toString();
}

void WindowSettings::setLanguage(const QString &language)
{
    m_settings->setValue(languageKey, language);
}

Appearance WindowSettings::appearance() const
{
    return {.scheme = schemeOf(m_settings->value(schemeKey).toString()),
            .largeControls = m_settings->value(largeControlsKey).toBool(),
            .lessMotion = m_settings->value(lessMotionKey).toBool()};
}

void WindowSettings::setAppearance(const Appearance &appearance)
{
    m_settings->setValue(schemeKey, nameOf(appearance.scheme));
    m_settings->setValue(largeControlsKey, appearance.largeControls);
    m_settings->setValue(lessMotionKey, appearance.lessMotion);
}

QStringList WindowSettings::recentFiles() const
{
    return m_settings->value(recentFilesKey).toStringList();
}

void WindowSettings::setRecentFiles(const QStringList &files)
{
    m_settings->setValue(recentFilesKey, files);
}

QByteArray WindowSettings::geometry() const
{
    return m_settings->value(geometryKey).toByteArray();
}

std::map<WindowSize, QByteArray> WindowSettings::layouts() const
{
    std::map<WindowSize, QByteArray> layouts;
    for (const WindowSize size : allWindowSizes)
        if (const QByteArray layout = m_settings->value(layoutKey(size)).toByteArray(); !layout.isEmpty())
            layouts[size] = layout;
    return layouts;
}

void WindowSettings::setWindow(const QByteArray &geometry, const std::map<WindowSize, QByteArray> &layouts)
{
    m_settings->setValue(geometryKey, geometry);
    for (const WindowSize size : allWindowSizes)
        if (const auto layout = layouts.find(size); layout != layouts.end())
            m_settings->setValue(layoutKey(size), layout->second);
        else
            m_settings->remove(layoutKey(size));
}

std::optional<QJsonObject> WindowSettings::monitors() const
{
    if (!m_settings->contains(monitorsKey))
        return std::nullopt;
    return QJsonDocument::fromJson(m_settings->value(monitorsKey).toByteArray()).object();
}

void WindowSettings::setMonitors(const QJsonObject &monitors)
{
    m_settings->setValue(monitorsKey, QJsonDocument(monitors).toJson(QJsonDocument::Compact));
}

QStringList WindowSettings::typedRequests() const
{
    return m_settings->value(typedRequestsKey).toStringList();
}

void WindowSettings::setTypedRequests(const QStringList &requests)
{
    m_settings->setValue(typedRequestsKey, requests);
}

qint64 WindowSettings::largestMessageFile() const
{
    const qint64 megabytes = m_settings->value(largestMessageFileKey, usualMessageFile).toLongLong();
    return std::max(megabytes, smallestMessageFile) * megabyte;
}

} // namespace codewheel
