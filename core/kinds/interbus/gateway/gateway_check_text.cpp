// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_check_text.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/gateway/gateway_texts.h"
#include "kinds/interbus/gateway/register_refusal.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr int registerDigits = 4;

QString roundTripText(Instant time)
{
    constexpr double microseconds = 1'000; // a millisecond
    return QLocale().toString(static_cast<double>(time.count()) / microseconds, 'f', 1);
}

WordOrder orderSet(const GatewaySettings &settings)
{
    return wordOrderOf(settings.highWordFirst);
}

// What the registers show in the order that is set.
const WordReading *readingSet(const DeviceRegisters &shown, const GatewaySettings &settings)
{
    return readingIn(shown.readings, orderSet(settings));
}

// The other order a setting gives; none for a word of one register.
const WordReading *readingOtherwise(const DeviceRegisters &shown, const GatewaySettings &settings)
{
    if (shown.readings.size() <= 2)
        return nullptr;
    return readingIn(shown.readings, wordOrderOf(!settings.highWordFirst));
}

bool fits(const WordReading *reading)
{
    return reading != nullptr && reading->plausibility == Plausibility::fits;
}

bool fitsExchanged(const DeviceRegisters &shown)
{
    return std::ranges::any_of(shown.readings, [](const WordReading &reading) {
        return fits(&reading) && (reading.order == WordOrder::badc || reading.order == WordOrder::dcba);
    });
}

QString orderText(bool highWordFirst)
{
    return highWordFirst ? GatewayTexts::tr("high word first") : GatewayTexts::tr("low word first");
}

QString whatToDo(const DeviceRegisters &shown, const GatewaySettings &settings, bool advises)
{
    const WordReading *other = readingOtherwise(shown, settings);
    if (fits(other) && !advises)
        return sentence(GatewayTexts::tr("It can with %1 (%2)."),
                        {orderText(!settings.highWordFirst), hexWord(other->word)});
    if (fits(other))
        return sentence(GatewayTexts::tr("It can with %1 (%2): change the word order."),
                        {orderText(!settings.highWordFirst), hexWord(other->word)});
    if (fitsExchanged(shown))
        return GatewayTexts::tr("It can with the bytes of each register exchanged: set the gateway so that "
                                "it does not exchange them.");
    return sentence(GatewayTexts::tr("It can in no order. Check that its IN words begin at register %1."),
                    {QString::number(shown.in.first)});
}

// Whether the order is proven by this word.
QString whatItProves(const DeviceRegisters &shown, const GatewaySettings &settings)
{
    const WordReading *set = readingSet(shown, settings);
    const WordReading *other = readingOtherwise(shown, settings);
    if (!fits(other))
        return {};
    if (set->word == other->word)
        return GatewayTexts::tr("It is the same in both word orders. Test again with another position.");
    return sentence(GatewayTexts::tr("With %1 it can be %2 as well. Test again with another position."),
                    {orderText(!settings.highWordFirst), hexWord(other->word)});
}

bool isSet(const MapReading &map, const GatewaySettings &settings)
{
    return map.in == settings.inFirst && map.highWordFirst == settings.highWordFirst;
}

QString mapName(const MapReading &map)
{
    return sentence(GatewayTexts::tr("IN from register %1, %2"),
                    {QString::number(map.in), orderText(map.highWordFirst)});
}

QString spaced(const QString &one, const QString &other)
{
    return other.isEmpty() ? one : one + u' ' + other;
}

} // namespace

QString gatewayStepText(GatewayStep step, GatewaySettings::Transport transport, NodeId place)
{
    switch (step) {
    case GatewayStep::found:
        return transport == GatewaySettings::Transport::tcp ? GatewayTexts::tr("Address")
                                                            : GatewayTexts::tr("Serial port");
    case GatewayStep::connected:
        return GatewayTexts::tr("Connection");
    case GatewayStep::answered:
        return GatewayTexts::tr("Unit");
    case GatewayStep::inArea:
        return GatewayTexts::tr("IN registers");
    case GatewayStep::outArea:
        return GatewayTexts::tr("OUT registers");
    case GatewayStep::status:
        return GatewayTexts::tr("Status register");
    case GatewayStep::word:
        return sentence(GatewayTexts::tr("Word of %1"), {place.toString()});
    case GatewayStep::map:
        return GatewayTexts::tr("Register map");
    case GatewayStep::closing:
        return GatewayTexts::tr("Connections");
    }
    return {};
}

QString foundText(const GatewaySettings &settings)
{
    if (settings.transport == GatewaySettings::Transport::tcp)
        return sentence(GatewayTexts::tr("The host %1 is known."), {settings.host});
    return sentence(GatewayTexts::tr("The port %1 is there."), {settings.serialPort});
}

QString answeredText(int unit, Instant after)
{
    return sentence(GatewayTexts::tr("Unit %1 answers after %2 ms."),
                    {QString::number(unit), roundTripText(after)});
}

QString readableText(int function, const RegisterBlock &block)
{
    return sentence(GatewayTexts::tr("All registers of the project can be read (%1)."),
                    {registersText(function, block)});
}

QString endsBeforeText(NodeId place, const RegisterBlock &its)
{
    return sentence(GatewayTexts::tr("What can be read ends before the registers of %1, which begin at %2."),
                    {place.toString(), QString::number(its.first)});
}

QString mostInReadText(int most)
{
    return sentence(
        GatewayTexts::tr("All registers can be read, but no more than %1 in one request: set that "
                         "many in a read. How many it takes in a write is not tested, since the "
                         "test writes nothing."),
        {QString::number(most)});
}

QString closingText(std::uint64_t connections)
{
    return sentence(
        GatewayTexts::tr("The gateway closes the connection after each answer: this test took %1 of "
                         "them. Nothing is lost, but each exchange takes longer."),
        {QLocale().toString(qulonglong{connections})});
}

QString registerText(Register word)
{
    return hexCode(word, registerDigits);
}

CheckOutcome wordOutcome(const DeviceRegisters &shown, const GatewaySettings &settings)
{
    const WordReading *set = readingSet(shown, settings);
    if (set == nullptr || set->plausibility == Plausibility::notKnown)
        return CheckOutcome::skipped;
    return fits(set) ? CheckOutcome::passed : CheckOutcome::failed;
}

QString wordText(const DeviceRegisters &shown, const GatewaySettings &settings, bool advises)
{
    const WordReading *set = readingSet(shown, settings);
    if (set == nullptr)
        return GatewayTexts::tr("It has no IN word.");
    const QString word = hexWord(set->word);
    switch (set->plausibility) {
    case Plausibility::fits:
        return spaced(sentence(GatewayTexts::tr("IN is %1: %2."), {word, set->meaning}),
                      whatItProves(shown, settings));
    case Plausibility::unlikely:
        return spaced(
            sentence(GatewayTexts::tr("IN is %1, which is beyond the total range of the encoder."), {word}),
            whatToDo(shown, settings, advises));
    case Plausibility::cannotBe:
        return spaced(sentence(GatewayTexts::tr("IN is %1, which this encoder never sends."), {word}),
                      whatToDo(shown, settings, advises));
    case Plausibility::notKnown:
        break;
    }
    return sentence(GatewayTexts::tr("IN is %1. What this device sends is not described."), {word});
}

CheckOutcome mapOutcome(const MapReadings &readings, const GatewaySettings &settings)
{
    const MapReadings fitting = fittingMaps(readings);
    const bool isSetFitting =
        std::ranges::any_of(fitting, [&](const MapReading &map) { return isSet(map, settings); });
    if (readings.empty())
        return CheckOutcome::skipped;
    return isSetFitting && fitting.size() == 1 ? CheckOutcome::passed : CheckOutcome::failed;
}

QString mapText(const MapReadings &readings, const GatewaySettings &settings)
{
    if (readings.empty())
        return GatewayTexts::tr("No word of this ring can be judged.");
    const MapReadings fitting = fittingMaps(readings);
    QStringList others;
    for (const MapReading &map : fitting)
        if (!isSet(map, settings))
            others << mapName(map);
    const QString named = others.join(QStringLiteral("; "));
    if (fitting.empty())
        return sentence(
            GatewayTexts::tr("The words fit no map near this one (%1). Check the first register of IN, "
                             "and the bus structure."),
            {mapName({settings.inFirst, settings.highWordFirst})});
    if (others.size() < static_cast<qsizetype>(fitting.size()))
        return others.isEmpty()
                   ? GatewayTexts::tr(
                         "The words of IN fit this map, and none near it. Where OUT begins shows nowhere: "
                         "compare it with the manual of the gateway.")
                   : sentence(
                         GatewayTexts::tr("The words fit this map, but also: %1. Test again with other "
                                          "positions, of a shaft that was turned by 65536 steps, before you "
                                          "write."),
                         {named});
    return others.size() == 1
               ? sentence(GatewayTexts::tr("The words do not fit this map, but this one: %1."), {named})
               : sentence(GatewayTexts::tr(
                              "The words do not fit this map, but several others: %1. Test again with "
                              "other positions, or look into the manual of the gateway."),
                          {named});
}

DataCheck wordCheck(const DeviceRegisters &shown, const GatewaySettings &settings)
{
    const DataStep step{DataCheck::Id::order, GatewayTexts::tr("Word order"),
                        orderText(settings.highWordFirst)};
    const WordReading *set = readingSet(shown, settings);
    const QString came = set != nullptr ? hexWord(set->word) : GatewayTexts::tr("no IN word");
    if (wordOutcome(shown, settings) != CheckOutcome::failed)
        return step.passed(came);
    return step.failed(came, wordText(shown, settings), DataCheck::Action::registers);
}

QString plausibilityKey(Plausibility plausibility)
{
    constexpr std::array keys{"fits", "unlikely", "cannotBe", "notKnown"};
    return QString::fromLatin1(keys.at(static_cast<std::size_t>(plausibility)));
}

QString plausibilityText(Plausibility plausibility)
{
    switch (plausibility) {
    case Plausibility::fits:
        return GatewayTexts::tr("the encoder can send this");
    case Plausibility::unlikely:
        return GatewayTexts::tr("beyond its total range");
    case Plausibility::cannotBe:
        return GatewayTexts::tr("the encoder never sends this");
    case Plausibility::notKnown:
        break;
    }
    return GatewayTexts::tr("not known");
}

} // namespace codewheel
