// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_settings.h"

#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/gateway_texts.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <functional>

namespace codewheel {
namespace {

using namespace gateway_limits;
using std::chrono::milliseconds;
using Transport = GatewaySettings::Transport;
using Parity = SerialSettings::Parity;

// One setting as text. `take` says whether the text is one of its values.
struct Setting
{
    const char *name;
    std::optional<Transport> only; // empty: of both
    std::function<QString(const GatewaySettings &)> text;
    std::function<bool(GatewaySettings &, const QString &)> take;
    QString allowed;
};

std::optional<int> numberIn(const QString &text, Limits ends)
{
    bool isNumber = false;
    const int number = text.toInt(&isNumber);
    return isNumber && ends.hold(number) ? std::optional(number) : std::nullopt;
}

// As a file or the command line takes them.
QString range(Limits ends)
{
    return sentence(GatewayTexts::tr("a number from %1 to %2"),
                    {QString::number(ends.least), QString::number(ends.most)});
}

Setting number(const char *name, int GatewaySettings::*its, Limits ends,
               std::optional<Transport> only = std::nullopt)
{
    return {name, only, [its](const GatewaySettings &all) { return QString::number(all.*its); },
            [its, ends](GatewaySettings &all, const QString &text) {
                const auto read = numberIn(text, ends);
                all.*its = read.value_or(all.*its);
                return read.has_value();
            },
            range(ends)};
}

Setting time(const char *name, Instant GatewaySettings::*its, Limits ends)
{
    return {name,
            {},
            [its](const GatewaySettings &all) {
                return QString::number(std::chrono::duration_cast<milliseconds>(all.*its).count());
            },
            [its, ends](GatewaySettings &all, const QString &text) {
                const auto read = numberIn(text, ends);
                if (read)
                    all.*its = milliseconds(*read);
                return read.has_value();
            },
            sentence(GatewayTexts::tr("%1 (ms)"), {range(ends)})};
}

// Of two values: the first stands for true.
Setting choice(const char *name, const char *on, const char *off,
               const std::function<bool(const GatewaySettings &)> &isOn,
               const std::function<void(GatewaySettings &, bool)> &set)
{
    const QString yes = QString::fromLatin1(on);
    const QString no = QString::fromLatin1(off);
    return {name,
            {},
            [=](const GatewaySettings &all) { return isOn(all) ? yes : no; },
            [=](GatewaySettings &all, const QString &text) {
                if (text != yes && text != no)
                    return false;
                set(all, text == yes);
                return true;
            },
            sentence(GatewayTexts::tr("%1 or %2"), {yes, no})};
}

Setting choice(const char *name, const char *on, const char *off, bool GatewaySettings::*its)
{
    return choice(
        name, on, off, [its](const GatewaySettings &all) { return all.*its; },
        [its](GatewaySettings &all, bool isOn) { all.*its = isOn; });
}

const QString none = QStringLiteral("none");

Setting optionalNumber(const char *name, std::optional<int> GatewaySettings::*its, Limits ends)
{
    return {name,
            {},
            [=](const GatewaySettings &all) { return all.*its ? QString::number(*(all.*its)) : none; },
            [=](GatewaySettings &all, const QString &text) {
                const auto read = numberIn(text, ends);
                if (read || text == none)
                    all.*its = read;
                return read || text == none;
            },
            sentence(GatewayTexts::tr("%1, or %2"), {range(ends), none})};
}

// "2+3+9".
QString bitsText(std::uint16_t set)
{
    QStringList numbers;
    for (int i = bit.least; i <= bit.most; ++i)
        if ((set >> i & 1) != 0)
            numbers << QString::number(i);
    return numbers.isEmpty() ? none : numbers.join(u'+');
}

std::optional<std::uint16_t> bitsIn(const QString &text)
{
    std::uint16_t set = 0;
    if (text == none)
        return set;
    for (const QString &part : text.split(u'+')) {
        const auto number = numberIn(part, bit);
        if (!number)
            return std::nullopt;
        set = static_cast<std::uint16_t>(set | 1U << *number);
    }
    return set;
}

// "8E1".
QString formOf(const GatewaySettings &all)
{
    return all.serial.format();
}

bool takeForm(GatewaySettings &all, const QString &text)
{
    const qsizetype parity = text.size() == 3 ? QStringLiteral("NEO").indexOf(text[1].toUpper()) : -1;
    if (parity < 0 || text[0] != u'8' || (text[2] != u'1' && text[2] != u'2'))
        return false;
    all.serial.dataBits = 8;
    all.serial.parity = static_cast<Parity>(parity);
    all.serial.stopBits = text[2].digitValue();
    return true;
}

std::vector<Setting> makeSettings()
{
    return {
        number("unit", &GatewaySettings::unit, tcpUnit, Transport::tcp),
        number("unit", &GatewaySettings::unit, rtuUnit, Transport::rtu),
        {"baud", Transport::rtu,
         [](const GatewaySettings &all) { return QString::number(all.serial.baudRate); },
         [](GatewaySettings &all, const QString &text) {
             const auto read = numberIn(text, baudRate);
             all.serial.baudRate = read.value_or(all.serial.baudRate);
             return read.has_value();
         },
         range(baudRate)},
        {"format", Transport::rtu, formOf, takeForm, QStringLiteral("8E1, 8N1, 8N2, 8O1, 8E2, 8O2")},
        choice(
            "in-area", "holding", "input",
            [](const GatewaySettings &all) { return all.inArea == RegisterArea::holding; },
            [](GatewaySettings &all, bool isHolding) {
                all.inArea = isHolding ? RegisterArea::holding : RegisterArea::input;
            }),
        number("in", &GatewaySettings::inFirst, registers),
        number("out", &GatewaySettings::outFirst, registers),
        choice("write", "23", "16", &GatewaySettings::writesWithRead),
        choice("order", "high", "low", &GatewaySettings::highWordFirst),
        optionalNumber("status", &GatewaySettings::statusRegister, registers),
        optionalNumber("run-bit", &GatewaySettings::runBit, bit),
        {"fault-bits",
         {},
         [](const GatewaySettings &all) { return bitsText(all.faultBits); },
         [](GatewaySettings &all, const QString &text) {
             const auto read = bitsIn(text);
             all.faultBits = read.value_or(all.faultBits);
             return read.has_value();
         },
         sentence(GatewayTexts::tr("bits from 0 to 15, as %1, or %2"), {QStringLiteral("2+3"), none})},
        optionalNumber("place", &GatewaySettings::placeRegister, registers),
        optionalNumber("control", &GatewaySettings::controlRegister, registers),
        optionalNumber("watchdog", &GatewaySettings::watchdogRegister, registers),
        number("watchdog-value", &GatewaySettings::watchdogValue, registerValue),
        number("most-read", &GatewaySettings::mostRead, mostRead),
        number("most-written", &GatewaySettings::mostWritten, mostWritten),
        choice("read-back", "on", "off", &GatewaySettings::readsBack),
        time("interval", &GatewaySettings::pollInterval, interval),
        time("delay", &GatewaySettings::reactionDelay, delay),
        time("time-out", &GatewaySettings::timeOut, timeOut),
        number("retries", &GatewaySettings::retries, retries),
        time("copy-time", &GatewaySettings::copyTime, copyTime),
        time("patience", &GatewaySettings::patience, patience),
    };
}

bool isOf(const Setting &setting, Transport transport)
{
    return !setting.only || setting.only == transport;
}

tl::unexpected<Refusal> settingWrong(const QString &name, const QString &text, const QString &allowed)
{
    return refuse(RefusalKind::badInput, GatewayRefusalId::linkSettingWrong, {name, text, allowed});
}

} // namespace

std::optional<ToldRing> toldRing(const GatewaySettings &settings, Register status)
{
    if (!settings.tellsRing())
        return std::nullopt;
    return ToldRing{.status = status,
                    .runs = !settings.runBit || (status >> *settings.runBit & 1) != 0,
                    .hasFailed = (status & settings.faultBits) != 0};
}

std::map<QString, QString> allSettingTexts(const GatewaySettings &settings)
{
    std::map<QString, QString> texts;
    for (const Setting &setting : makeSettings())
        if (isOf(setting, settings.transport))
            texts[QString::fromLatin1(setting.name)] = setting.text(settings);
    return texts;
}

std::map<QString, QString> settingTexts(const GatewaySettings &settings)
{
    std::map<QString, QString> texts = allSettingTexts(settings);
    const auto usual = allSettingTexts({.transport = settings.transport});
    std::erase_if(texts, [&usual](const auto &text) { return usual.at(text.first) == text.second; });
    return texts;
}

QStringList settingNames(Transport transport)
{
    QStringList names;
    for (const Setting &setting : makeSettings())
        if (isOf(setting, transport))
            names << QString::fromLatin1(setting.name);
    return names;
}

Result<void> applySettings(GatewaySettings &settings, const std::map<QString, QString> &texts)
{
    const std::vector<Setting> all = makeSettings();
    GatewaySettings wanted = settings;
    for (const auto &[name, text] : texts) {
        const auto setting = std::ranges::find_if(all, [&, &name = name](const Setting &its) {
            return isOf(its, settings.transport) && name == QLatin1String(its.name);
        });
        if (setting == all.end())
            return refuse(RefusalKind::badInput, GatewayRefusalId::linkSettingUnknown,
                          {name, settingNames(settings.transport).join(QStringLiteral(", "))});
        if (!setting->take(wanted, text))
            return settingWrong(name, text, setting->allowed);
    }
    settings = wanted;
    return {};
}

bool isGatewayLink(const QString &kind)
{
    return kind == QLatin1String(modbusTcpLink) || kind == QLatin1String(modbusRtuLink);
}

QString linkKindOf(const GatewaySettings &settings)
{
    return QString::fromLatin1(settings.transport == Transport::tcp ? modbusTcpLink : modbusRtuLink);
}

Result<GatewaySettings> gatewaySettings(const QString &linkKind, const std::map<QString, QString> &texts)
{
    GatewaySettings settings;
    settings.transport = linkKind == QLatin1String(modbusRtuLink) ? Transport::rtu : Transport::tcp;
    std::map<QString, QString> others = texts;
    const auto take = [&others](const char *name) {
        auto node = others.extract(QString::fromLatin1(name));
        return node ? node.mapped() : QString();
    };
    if (settings.transport == Transport::tcp) {
        settings.host = take("host");
        const QString port = take("port");
        const auto number =
            port.isEmpty() ? std::optional(int{modbus_limit::tcpPort}) : numberIn(port, tcpPort);
        if (!number)
            return settingWrong(QStringLiteral("port"), port, range(tcpPort));
        settings.tcpPort = *number;
    } else {
        settings.serialPort = take("port");
    }
    return applySettings(settings, others).map([&] { return settings; });
}

std::map<QString, QString> linkTexts(const GatewaySettings &settings)
{
    std::map<QString, QString> texts = settingTexts(settings);
    if (settings.transport == Transport::rtu) {
        texts[QStringLiteral("port")] = settings.serialPort;
        return texts;
    }
    texts[QStringLiteral("host")] = settings.host;
    if (settings.tcpPort != modbus_limit::tcpPort)
        texts[QStringLiteral("port")] = QString::number(settings.tcpPort);
    return texts;
}

// An IPv6 address stands in brackets before its port.
QString gatewayAddress(const GatewaySettings &settings)
{
    if (settings.transport == Transport::rtu)
        return settings.serialPort;
    const bool isIpv6 = settings.host.contains(u':');
    const QString host = isIpv6 ? QStringLiteral("[%1]").arg(settings.host) : settings.host;
    return QStringLiteral("%1:%2").arg(host).arg(settings.tcpPort);
}

QString gatewayUnit(const GatewaySettings &settings)
{
    const QString unit = sentence(GatewayTexts::tr("unit %1"), {QString::number(settings.unit)});
    return QStringLiteral("%1, %2").arg(gatewayAddress(settings), unit);
}

QString gatewayText(const GatewaySettings &settings)
{
    if (settings.transport == Transport::tcp)
        return gatewayUnit(settings);
    const QString unit = sentence(GatewayTexts::tr("unit %1"), {QString::number(settings.unit)});
    return QStringLiteral("%1, %2 Bd, %3, %4")
        .arg(settings.serialPort)
        .arg(settings.serial.baudRate)
        .arg(formOf(settings), unit);
}

} // namespace codewheel
