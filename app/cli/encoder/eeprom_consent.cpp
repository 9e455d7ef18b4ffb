// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/eeprom_consent.h"

#include "bus/buses.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <numeric>

namespace codewheel {
namespace {

bool canAsk(const Call &call)
{
    return call.terminal.isInteractive && !call.arguments.has("--json");
}

Checked<void> refused(const EncoderSession &encoder, RefusalCode id, std::optional<int> mark)
{
    return tl::unexpected(
        complaintAbout({RefusalKind::busy,
                        id,
                        {encoder.place().shown(), std::int64_t{encoder.eepromCount().atMost()},
                         std::int64_t{mark.value_or(0)}}}));
}

Checked<void> askForPlace(const Call &call, const EncoderSession &encoder)
{
    const QString place = encoder.place().shown();
    const auto isMeant = [&](const QString &typed) {
        const auto meant = placeMeant(call, call.project, typed);
        return meant && *meant == encoder.place();
    };
    const QString named = call.arguments.value("--beyond-eeprom-limit").value_or(QString());
    if (isMeant(named) ||
        std::ranges::any_of(named.split(u','), isMeant)) // several, in commands for several encoders
        return {};
    if (canAsk(call) &&
        isMeant(call.terminal.answer(sentence(CommandLine::tr("Type %1 to write nevertheless:"), {place}))))
        return {};
    auto why = refused(encoder, RefusalId::eepromLimitPassed, encoder.can().eepromLimit);
    if (!canAsk(call))
        why.error().text +=
            u' ' + sentence(CommandLine::tr("As an option: --beyond-eeprom-limit %1."), {place});
    return why;
}

} // namespace

Checked<void> eepromConsent(const Call &call, const EncoderSession &encoder, int writes, AsksAnyway asks)
{
    const EepromConcern concern = eepromConcern(encoder, writes);
    if (concern == EepromConcern::none)
        return {};
    call.terminal.complain(encoder.place().shown() + QStringLiteral(": ") +
                           eepromConcernText(encoder, writes));
    if (concern == EepromConcern::typed)
        return askForPlace(call, encoder);
    if (asks == AsksAnyway::yes || call.arguments.has("--yes"))
        return {};
    if (canAsk(call) && call.terminal.confirms(CommandLine::tr("Write to the EEPROM nevertheless?")))
        return {};
    return refused(encoder, RefusalId::eepromBudgetUsed, encoder.can().eepromBudget);
}

Checked<AllowedJob> eepromConsent(const Call &call, EncoderSession &encoder, const Job &job, AsksAnyway asks)
{
    return eepromConsent(call, encoder, mostEepromWrites(encoder, job), asks).map([&] {
        return AllowedJob(encoder, job);
    });
}

QString costOfLeaving(const EncoderSession &encoder)
{
    return mostEepromWrites(encoder, SwitchMode{}) > 0
               ? CommandLine::tr(", and 1 more where it is in a cam program that was changed")
               : QString();
}

Checked<AllowedRound> eepromConsent(const Call &call, std::vector<EncoderJobs> encoders, AsksAnyway asks)
{
    for (const EncoderJobs &one : encoders) {
        const EncoderSession &encoder = *call.buses.encoder(one.place);
        const int planned =
            std::accumulate(one.jobs.begin(), one.jobs.end(), 0,
                            [&](int sum, const Job &job) { return sum + mostEepromWrites(encoder, job); });
        if (const auto may = eepromConsent(call, encoder, planned, asks); !may)
            return tl::unexpected(may.error());
    }
    return AllowedRound(std::move(encoders));
}

} // namespace codewheel
