// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/values_before.h"

#include "catalog/catalog.h"
#include "transfer/project_places.h"
#include "transfer/transfer_words.h"
#include "vocabulary/freshness_text.h"

namespace codewheel {

FindValuesBefore valuesBeforeOf(const LedgerKeeper &keeper)
{
    return [&keeper](Place place) {
        std::vector<ValuesBefore> all;
        const EncoderSession *encoder = keeper.bus().encoder(place);
        if (keeper.ledger() == nullptr || (encoder && encoder->knownBefore()))
            return all;
        for (const Ledger::Entry &entry : keeper.ledger()->valuesBefore(keeper.identity(place))) {
            ValuesBefore one{place, entry.at, entry.device, {}, entry.place};
            const DeviceDescription *device = keeper.bus().catalog().find(entry.device);
            for (const Ledger::Value &known : entry.before)
                if (const ParameterValue value{known.parameter, known.value};
                    isSetting(device, value) && (!entry.settled || findValue(entry.written, value.parameter)))
                    one.values.push_back(value);
            if (!one.values.empty())
                all.push_back(std::move(one));
        }
        return all;
    };
}

FindValuesBefore valuesBeforeOf(FindLedgers ledgers)
{
    return [ledgers = std::move(ledgers)](Place place) {
        for (const LedgerKeeper *keeper : ledgers())
            if (keeper->bus().id() == place.bus)
                return valuesBeforeOf(*keeper)(place);
        return std::vector<ValuesBefore>();
    };
}

Refusal whyNothingBefore(const EncoderSession &encoder)
{
    if (encoder.knownBefore())
        return {RefusalKind::device, RefusalId::notSaidWhetherSame, {encoder.place().shown()}};
    return {RefusalKind::device, RefusalId::noValuesFromBefore, {encoder.place().shown()}};
}

TransferWish wishToRestore(const ValuesBefore &before, const ProjectPlaces &places)
{
    return {.place = before.place,
            .deviceKey = before.deviceKey,
            .values = before.values,
            .hindrance = places.hindrance(before.place)};
}

QString timeOf(const ValuesBefore &before, const QDateTime &now)
{
    return momentText(before.at, now);
}

QString textOf(const ValuesBefore &before, const DeviceDescription *device)
{
    QStringList texts;
    for (const ParameterValue &value : before.values)
        texts << parameterName(device, value.parameter) + u' ' + transfer_words::value(device, value);
    return texts.join(QStringLiteral(", "));
}

Message valuesRestoredMessage(const ValuesBefore &before, const TransferAccount &account)
{
    return {
        .place = before.place,
        .id = MessageId::valuesRestored,
        .arguments = {before.at.toUTC().toString(Qt::ISODate), std::int64_t{account.count(Became::written)}}};
}

} // namespace codewheel
