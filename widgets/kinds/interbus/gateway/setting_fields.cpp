// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/setting_fields.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct SettingFieldTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::SettingField)
};

SettingField ofUnit(GatewaySettings::Transport transport)
{
    const bool isTcp = transport == GatewaySettings::Transport::tcp;
    return {QStringLiteral("unit"), SettingFieldTexts::tr("&Unit"),
            SettingFieldTexts::tr("The number of the device that has the registers; 1 with most gateways"),
            isTcp ? gateway_limits::tcpUnit : gateway_limits::rtuUnit};
}

std::vector<SettingField> ofSerialLine()
{
    return {{QStringLiteral("baud"), SettingFieldTexts::tr("Baud rate"),
             SettingFieldTexts::tr("As set on the gateway; 19200 by the standard"), gateway_limits::baudRate},
            {QStringLiteral("format"),
             SettingFieldTexts::tr("Format"),
             SettingFieldTexts::tr("Data bits, parity and stop bits; 8E1 by the standard"),
             {},
             {},
             {},
             {{QStringLiteral("8E1"), QStringLiteral("8E1")},
              {QStringLiteral("8N1"), QStringLiteral("8N1")},
              {QStringLiteral("8N2"), QStringLiteral("8N2")},
              {QStringLiteral("8O1"), QStringLiteral("8O1")},
              {QStringLiteral("8E2"), QStringLiteral("8E2")},
              {QStringLiteral("8O2"), QStringLiteral("8O2")}}}};
}

std::vector<SettingField> ofImage()
{
    const QString none = SettingFieldTexts::tr("none", "register");
    return {
        {QStringLiteral("in-area"),
         SettingFieldTexts::tr("&IN is in"),
         SettingFieldTexts::tr("Where the gateway shows what comes from the devices"),
         {},
         {},
         {},
         {{QStringLiteral("input"), SettingFieldTexts::tr("input registers (function 4)")},
          {QStringLiteral("holding"), SettingFieldTexts::tr("holding registers (function 3)")}}},
        {QStringLiteral("in"), SettingFieldTexts::tr("First re&gister of IN"),
         SettingFieldTexts::tr("The register of the first device of the ring"), gateway_limits::registers},
        {QStringLiteral("out"), SettingFieldTexts::tr("First register of &OUT"),
         SettingFieldTexts::tr("OUT is in holding registers. The two areas must not overlap"),
         gateway_limits::registers},
        {QStringLiteral("write"),
         SettingFieldTexts::tr("OUT is written by"),
         SettingFieldTexts::tr(
             "Function 23 also reads IN in the same transaction; for that IN must be in holding registers"),
         {},
         {},
         {},
         {{QStringLiteral("16"), SettingFieldTexts::tr("function 16")},
          {QStringLiteral("23"), SettingFieldTexts::tr("function 23, together with IN")}}},
        {QStringLiteral("order"),
         SettingFieldTexts::tr("&Word order"),
         SettingFieldTexts::tr(
             "Of the two registers of an encoder, for IN and OUT alike. The test shows which is right"),
         {},
         {},
         {},
         {{QStringLiteral("high"), SettingFieldTexts::tr("high word first")},
          {QStringLiteral("low"), SettingFieldTexts::tr("low word first")}}},
        {QStringLiteral("read-back"),
         SettingFieldTexts::tr("OUT is read back"),
         SettingFieldTexts::tr(
             "Before each write, so that it is noticed if somebody else writes too. No: it is not"),
         {},
         {},
         {},
         {{QStringLiteral("on"), SettingFieldTexts::tr("yes")},
          {QStringLiteral("off"), SettingFieldTexts::tr("no")}}},
        {QStringLiteral("status"),
         SettingFieldTexts::tr("Status register"),
         SettingFieldTexts::tr(
             "Where the gateway tells its state, if it does; what its bits mean is set below"),
         gateway_limits::registers,
         {},
         none},
        {QStringLiteral("run-bit"),
         SettingFieldTexts::tr("Bit of run"),
         SettingFieldTexts::tr(
             "The bit of the status register that is 1 while the ring runs, by the manual of "
             "the gateway. Without it the program cannot know"),
         gateway_limits::bit,
         {},
         none},
        {.name = QStringLiteral("fault-bits"),
         .label = SettingFieldTexts::tr("Bits of a fault"),
         .sentence =
             SettingFieldTexts::tr("The bits of the status register of which one is 1 when the ring has "
                                   "failed, as 2+3; empty: none"),
         .none = none,
         .isText = true},
        {QStringLiteral("place"),
         SettingFieldTexts::tr("Register of the place"),
         SettingFieldTexts::tr(
             "Where the gateway tells the place of a fault: segment in the high byte, position "
             "in the low one"),
         gateway_limits::registers,
         {},
         none},
        {QStringLiteral("watchdog"),
         SettingFieldTexts::tr("Watchdog register"),
         SettingFieldTexts::tr("The holding register that acknowledges a watchdog of the gateway that has "
                               "tripped; it is written when you say so"),
         gateway_limits::registers,
         {},
         none},
        {QStringLiteral("watchdog-value"), SettingFieldTexts::tr("Value for it"),
         SettingFieldTexts::tr("What acknowledges the watchdog, by the manual of the gateway"),
         gateway_limits::registerValue},
        {QStringLiteral("control"),
         SettingFieldTexts::tr("Control register"),
         SettingFieldTexts::tr("Kept with the project; the program never writes it by itself"),
         gateway_limits::registers,
         {},
         none},
    };
}

std::vector<SettingField> ofTimes()
{
    const QString ms = SettingFieldTexts::tr(" ms", "unit of a time");
    return {
        {QStringLiteral("most-read"), SettingFieldTexts::tr("Registers in a read"),
         SettingFieldTexts::tr("The most that the gateway gives in one request; 125 by the standard"),
         gateway_limits::mostRead},
        {QStringLiteral("most-written"), SettingFieldTexts::tr("Registers in a write"),
         SettingFieldTexts::tr("The most that the gateway takes in one request; 123 by the standard"),
         gateway_limits::mostWritten},
        {QStringLiteral("interval"), SettingFieldTexts::tr("Poll interval"),
         SettingFieldTexts::tr("From one exchange to the next; 0: as fast as the link is"),
         gateway_limits::interval, ms},
        {QStringLiteral("delay"), SettingFieldTexts::tr("Delay after an exchange"),
         SettingFieldTexts::tr("How long the gateway needs to pass words on to the ring and back"),
         gateway_limits::delay, ms},
        {QStringLiteral("time-out"), SettingFieldTexts::tr("Time-out"),
         SettingFieldTexts::tr("How long an answer is waited for"), gateway_limits::timeOut, ms},
        {QStringLiteral("retries"), SettingFieldTexts::tr("Number of retries"),
         SettingFieldTexts::tr(
             "How often a request without a valid answer is repeated before the link counts as lost"),
         gateway_limits::retries},
        {QStringLiteral("copy-time"), SettingFieldTexts::tr("Copy time"),
         SettingFieldTexts::tr("How far apart the gateway may copy the two registers of a word: a new word "
                               "counts once it has stood that long"),
         gateway_limits::copyTime, ms},
        {QStringLiteral("patience"), SettingFieldTexts::tr("Patience"),
         SettingFieldTexts::tr("How long the gateway may say that it is busy before the link counts as lost"),
         gateway_limits::patience, ms}};
}

} // namespace

std::vector<SettingField> settingFields(GatewaySettings::Transport transport)
{
    std::vector<SettingField> fields;
    const auto add = [&fields](const std::vector<SettingField> &more) {
        fields.insert(fields.end(), more.begin(), more.end());
    };
    if (transport == GatewaySettings::Transport::rtu)
        add(ofSerialLine());
    fields.push_back(ofUnit(transport));
    add(ofImage());
    add(ofTimes());
    return fields;
}

} // namespace codewheel
