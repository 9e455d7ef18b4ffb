// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_link.h"

#include "cli/bus/present_ports.h"
#include "cli/call/texts.h"
#include "kinds/esc/line/esc_line_limits.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "links/port_access.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QStringList>

#include <array>

namespace codewheel {
namespace {

const QString simulatedPort = QStringLiteral("training");

using std::chrono::milliseconds;

// A setting that is a whole number.
struct NumberSetting
{
    const char *key;
    line_limits::Limits limits;
    void (*apply)(EscLineLink &link, int value);
};

constexpr auto fractionBitsKey = "fraction-bits";

constexpr auto numberSettings = std::to_array<NumberSetting>({
    {"baud", line_limits::baudRate, [](EscLineLink &link, int v) { link.settings.serial.baudRate = v; }},
    {"time-out", line_limits::timeOut,
     [](EscLineLink &link, int v) { link.settings.timing.answerTimeOut = milliseconds(v); }},
    {"retries", line_limits::retries, [](EscLineLink &link, int v) { link.settings.timing.retries = v; }},
    {"quiet", line_limits::quietAfterWrite,
     [](EscLineLink &link, int v) { link.settings.timing.quietAfterWrite = milliseconds(v); }},
    {"poll", line_limits::pollInterval,
     [](EscLineLink &link, int v) { link.settings.pollInterval = milliseconds(v); }},
    {"top-speed", line_limits::topSpeed, [](EscLineLink &link, int v) { link.settings.topSpeed = v; }},
    {fractionBitsKey, line_limits::fractionBits,
     [](EscLineLink &link, int v) { link.settings.fractionBits = v; }},
    {"low-latency", {0, 1}, [](EscLineLink &link, int v) { link.settings.serial.lowLatency = v == 1; }},
    {"swap-warnings",
     {0, 1},
     [](EscLineLink &link, int v) {
         link.swapWarningBytes = v == 1;
         link.swapping.clear();
     }},
});

const QString fromDevice = QStringLiteral("device");
const QString formatKey = QStringLiteral("format");

// "8N2": data bits, parity, stop bits.
Checked<void> takeFormat(EscLineLink &link, const QString &text)
{
    using Parity = SerialSettings::Parity;
    const QString letters = QStringLiteral("NEO");
    constexpr std::array parities{Parity::none, Parity::even, Parity::odd};
    const bool isFormat = text.size() == 3 && (text[0] == u'7' || text[0] == u'8') &&
                          letters.contains(text[1], Qt::CaseInsensitive) &&
                          (text[2] == u'1' || text[2] == u'2');
    if (!isFormat)
        return badInput("lineFormatWrong",
                        CommandLine::tr("\"%1\" is not a format of a serial line. Give data bits (7, 8), "
                                        "parity (N, E, O) and stop bits (1, 2), as 8N2."),
                        {text});
    link.settings.serial.dataBits = text[0].digitValue();
    link.settings.serial.parity = parities.at(static_cast<std::size_t>(letters.indexOf(text[1].toUpper())));
    link.settings.serial.stopBits = text[2].digitValue();
    return {};
}

Checked<void> takeSetting(EscLineLink &link, const QString &setting)
{
    const QString key = setting.section(u'=', 0, 0);
    const QString text = setting.section(u'=', 1);
    if (key == formatKey)
        return takeFormat(link, text);
    if (key == QLatin1String(fractionBitsKey) && text == fromDevice) {
        link.asksForFractionBits = true;
        return {};
    }
    const NumberSetting *known = rowByKey(numberSettings, key);
    if (known == nullptr)
        return badInput(
            "unknownLineSetting",
            CommandLine::tr("A serial line has no setting \"%1\". Its settings are: %2. Write them "
                            "behind the port, as esc:ttyUSB0,baud=9600."),
            {key, lineSettingKeys().join(QStringLiteral(", "))});
    const auto number = parseNumber(text);
    if (!number || *number < known->limits.least || *number > known->limits.most)
        return badInput(
            "lineSettingOutOfRange",
            CommandLine::tr("The setting %1 of the line cannot be \"%2\". Give a whole number from "
                            "%3 to %4."),
            {key, text, std::int64_t{known->limits.least}, std::int64_t{known->limits.most}});
    known->apply(link, static_cast<int>(*number));
    return {};
}

Checked<EscLineLink> withSettings(EscLineLink link, const QStringList &settings)
{
    for (const QString &setting : settings)
        if (const auto taken = takeSetting(link, setting); !taken)
            return tl::unexpected(taken.error());
    return link;
}

Complaint noPort(const QString &bus)
{
    return notDone(
        "noPortInProject",
        sentence(CommandLine::tr("The project has no port for \"%1\" yet. Choose one in the window, or "
                                 "name it, as --link esc:ttyUSB0."),
                 {bus}),
        {bus});
}

// What a project says of an encoder holds at any port.
std::set<EscLineAddress> swappingOf(const Project *project, BusId line)
{
    std::set<EscLineAddress> swapping;
    if (project != nullptr)
        for (const ProjectDevice &encoder : devicesOn(*project, line))
            if (encoder.its<EscEncoderSettings>().swapsWarningBytes)
                swapping.insert(EscLineAddress::of(encoder.place().node));
    return swapping;
}

QString otherAtPort(const Project &project, BusId line, const QString &port)
{
    for (const PlannedBus &bus : project.buses)
        if (bus.id != line && bus.kind == QLatin1String(escKind) &&
            isSamePort(linePlan(project, bus.id)->settings.port, port))
            return bus.name;
    return {};
}

Checked<EscLineLink> lineAt(const QString &port, const Project *project, BusId line)
{
    if (port.isEmpty())
        return badInput("portMissing",
                        CommandLine::tr("Name the port of the serial line, as --link esc:ttyUSB0. %1"),
                        {presentPortsText()});
    EscLineLink link;
    if (port == simulatedPort)
        return link;
    link.swapping = swappingOf(project, line);
    link.settings.port = port;
    return link;
}

} // namespace

QStringList lineSettingKeys()
{
    QStringList keys;
    for (const NumberSetting &setting : numberSettings)
        keys << QString::fromLatin1(setting.key);
    keys.insert(1, formatKey);
    return keys;
}

EscSettings EscLineLink::driver() const
{
    return {.positionInterval = settings.pollInterval,
            .topSpeed = settings.topSpeed,
            .fractionBits = settings.fractionBits};
}

esc::ExplainOptions EscLineLink::explainOptions() const
{
    return {
        .swapWarningBytes = swapWarningBytes, .fractionBits = settings.fractionBits, .swapping = swapping};
}

Checked<EscLineLink> lineOf(const Project &project, BusId line, const QStringList &settings)
{
    const EscLinePlan &planned = *linePlan(project, line);
    const EscLineLink link{.settings = planned.settings,
                           .swapping = swappingOf(&project, line),
                           .adapter = planned.adapter,
                           .whyNot = planned.settings.port.isEmpty()
                                         ? std::optional(noPort(findBus(project, line)->name))
                                         : std::nullopt,
                           .alsoOf = otherAtPort(project, line, planned.settings.port)};
    return withSettings(link, settings);
}

Checked<EscLineLink> lineMeant(const LinkText &text, const Project *project, BusId line)
{
    return lineAt(text.where, project, line).and_then([&](const EscLineLink &link) {
        return withSettings(link, text.settings);
    });
}

} // namespace codewheel
