// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/arguments.h"
#include "cli/encoder/allowed_jobs.h"

#include <QtGlobal>

namespace codewheel {

struct Call;

// For the commands that may write to an EEPROM.
inline constexpr Option beyondLimitOption{
    "--beyond-eeprom-limit", "PLACE",
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "write even where the manual guarantees nothing any more: "
                                                "the place (or places, as 1.0,2.0) once more")};
inline constexpr Option budgetYesOption{
    "--yes", nullptr,
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "do not ask where the budget of the EEPROM is used")};
inline constexpr Option ledgerOption{
    "--ledger", "FILE",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "count EEPROM writes in this file; those of the training bus are else forgotten")};

enum class AsksAnyway { yes, no };

// What has to be said and agreed to before a job, by how often this program has written to the EEPROM
// (journal/eeprom_cost.h). `asks`: the command asks before it writes; --yes answers.
Checked<AllowedJob> eepromConsent(const Call &call, EncoderSession &encoder, const Job &job, AsksAnyway asks);
// For anything else that writes, this many times.
Checked<void> eepromConsent(const Call &call, const EncoderSession &encoder, int writes, AsksAnyway asks);
// ", and 1 more ...": what it may cost to leave the mode it is in. Empty: nothing.
QString costOfLeaving(const EncoderSession &encoder);
// For each encoder, covering all of its jobs.
Checked<AllowedRound> eepromConsent(const Call &call, std::vector<EncoderJobs> encoders, AsksAnyway asks);

} // namespace codewheel
