// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_settings.h"

#include "app/journal_files.h"

#include <QFileInfo>
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

constexpr std::array signNames{"language", "point", "comma"};

DecimalSign signOf(const QString &name)
{
    const auto found =
        std::ranges::find_if(signNames, [&](const char *known) { return name == QLatin1String(known); });
    return found == signNames.end() ? DecimalSign::ofLanguage
                                    : static_cast<DecimalSign>(found - signNames.begin());
}

const QString languageKey = QStringLiteral("language");
const QString schemeKey = QStringLiteral("appearance/scheme");
const QString largeControlsKey = QStringLiteral("appearance/largeControls");
const QString lessMotionKey = QStringLiteral("appearance/lessMotion");
const QString lastFileKey = QStringLiteral("project/lastFile");
const QString recentFilesKey = QStringLiteral("project/recentFiles");
const QString startedKey = QStringLiteral("started");
const QString geometryKey = QStringLiteral("window/geometry");
const QString monitorsKey = QStringLiteral("window/monitors");
const QString pinnedDialKey = QStringLiteral("window/pinnedDial");
const QString helpLayoutKey = QStringLiteral("help/layout");
const QString usedCommandsKey = QStringLiteral("palette/used");
const QString typedRequestsKey = QStringLiteral("line/typedRequests");
const QString largestMessageFileKey = QStringLiteral("messages/largestFile");
const QString decimalSignKey = QStringLiteral("appearance/decimalSign");
const QString frameRateKey = QStringLiteral("window/framesPerSecond");
const QString eepromKey = QStringLiteral("eeprom/questionFromPercent");
const QString traceRowsKey = QStringLiteral("trace/mostRows");
const QString trendMemoryKey = QStringLiteral("trend/memory");
const QString trendKey = QStringLiteral("window/trend");
const QString lastLinkKey = QStringLiteral("connect/last/");
const QString recordingKey = QStringLiteral("window/recording");
const QString keepingKey = QStringLiteral("recovery/seconds");
const QString noticesKey = QStringLiteral("notices/faults");
const QString noticeSoundKey = QStringLiteral("notices/sound");

} // namespace

WindowSettings::WindowSettings(const QString &file)
    : m_settings(file.isEmpty() ? userSettings() : std::make_unique<QSettings>(file, QSettings::IniFormat))
{}

WindowSettings::~WindowSettings() = default;

int WindowSettings::number(const QString &key, int usual, SettingRange range) const
{
    return std::clamp(m_settings->value(key, usual).toInt(), range.least, range.most);
}

ProgramSettings WindowSettings::choices() const
{
    const ProgramSettings usual;
    const int rate = m_settings->value(frameRateKey, usual.framesPerSecond).toInt();
    return {
        .language = m_settings->value(languageKey).toString(),
        .appearance = {.scheme = schemeOf(m_settings->value(schemeKey).toString()),
                       .largeControls = m_settings->value(largeControlsKey).toBool(),
                       .lessMotion = m_settings->value(lessMotionKey).toBool()},
        .decimalSign = signOf(m_settings->value(decimalSignKey).toString()),
        .framesPerSecond = std::ranges::count(frameRates, rate) > 0 ? rate : usual.framesPerSecond,
        .eepromQuestionFrom = number(eepromKey, usual.eepromQuestionFrom, eepromQuestionRange),
        .userName = userName(*m_settings),
        .largestMessageFile = number(largestMessageFileKey, usual.largestMessageFile, messageFileRange),
        .traceRows = number(traceRowsKey, usual.traceRows, traceRowsRange),
        .trendMemory = number(trendMemoryKey, usual.trendMemory, trendMemoryRange),
        .secondsBetweenKeeping = number(keepingKey, usual.secondsBetweenKeeping, keepingRange),
        .notifiesOfFaults = m_settings->value(noticesKey, usual.notifiesOfFaults).toBool(),
        .notifiesWithSound = m_settings->value(noticeSoundKey, usual.notifiesWithSound).toBool(),
    };
}

void WindowSettings::setChoices(const ProgramSettings &choices)
{
    m_settings->setValue(languageKey, choices.language);
    m_settings->setValue(schemeKey, nameOf(choices.appearance.scheme));
    m_settings->setValue(largeControlsKey, choices.appearance.largeControls);
    m_settings->setValue(lessMotionKey, choices.appearance.lessMotion);
    m_settings->setValue(decimalSignKey,
                         QLatin1String(signNames.at(static_cast<std::size_t>(choices.decimalSign))));
    m_settings->setValue(frameRateKey, choices.framesPerSecond);
    m_settings->setValue(eepromKey, choices.eepromQuestionFrom);
    setUserName(*m_settings, choices.userName);
    m_settings->setValue(largestMessageFileKey, choices.largestMessageFile);
    m_settings->setValue(traceRowsKey, choices.traceRows);
    m_settings->setValue(trendMemoryKey, choices.trendMemory);
    m_settings->setValue(keepingKey, choices.secondsBetweenKeeping);
    m_settings->setValue(noticesKey, choices.notifiesOfFaults);
    m_settings->setValue(noticeSoundKey, choices.notifiesWithSound);
}

QStringList WindowSettings::usedCommands() const
{
    return m_settings->value(usedCommandsKey).toStringList();
}

void WindowSettings::setUsedCommands(const QStringList &ids)
{
    m_settings->setValue(usedCommandsKey, ids);
}

QString WindowSettings::folder() const
{
    return QFileInfo(m_settings->fileName()).path();
}

bool WindowSettings::isFirstStart() const
{
    return !m_settings->contains(startedKey) && !m_settings->contains(geometryKey); // of earlier versions
}

void WindowSettings::noteStart()
{
    m_settings->setValue(startedKey, true);
    m_settings->sync();
}

QString WindowSettings::lastFile() const
{
    return m_settings->value(lastFileKey).toString();
}

void WindowSettings::setLastFile(const QString &file)
{
    m_settings->setValue(lastFileKey, file);
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

QStringList WindowSettings::trend() const
{
    return m_settings->value(trendKey).toStringList();
}

void WindowSettings::setTrend(const QStringList &curves)
{
    m_settings->setValue(trendKey, curves);
}

QJsonObject WindowSettings::recording() const
{
    return QJsonDocument::fromJson(m_settings->value(recordingKey).toByteArray()).object();
}

void WindowSettings::setRecording(const QJsonObject &choices)
{
    m_settings->setValue(recordingKey, QJsonDocument(choices).toJson(QJsonDocument::Compact));
}

std::map<QString, QString> WindowSettings::lastLink(const QString &kind) const
{
    const auto json = QJsonDocument::fromJson(m_settings->value(lastLinkKey + kind).toByteArray()).object();
    std::map<QString, QString> settings;
    for (auto it = json.begin(); it != json.end(); ++it)
        settings[it.key()] = it.value().toString();
    return settings;
}

void WindowSettings::setLastLink(const QString &kind, const std::map<QString, QString> &settings)
{
    QJsonObject json;
    for (const auto &[name, text] : settings)
        json.insert(name, text);
    m_settings->setValue(lastLinkKey + kind, QJsonDocument(json).toJson(QJsonDocument::Compact));
}

std::optional<Place> WindowSettings::pinnedDial() const
{
    return Place::parse(m_settings->value(pinnedDialKey).toString());
}

void WindowSettings::setPinnedDial(std::optional<Place> place)
{
    if (place)
        m_settings->setValue(pinnedDialKey, place->key());
    else
        m_settings->remove(pinnedDialKey);
}

QByteArray WindowSettings::helpLayout() const
{
    return m_settings->value(helpLayoutKey).toByteArray();
}

void WindowSettings::setHelpLayout(const QByteArray &layout)
{
    m_settings->setValue(helpLayoutKey, layout);
}

QStringList WindowSettings::typedRequests() const
{
    return m_settings->value(typedRequestsKey).toStringList();
}

void WindowSettings::setTypedRequests(const QStringList &requests)
{
    m_settings->setValue(typedRequestsKey, requests);
}

} // namespace codewheel
