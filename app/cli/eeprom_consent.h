// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "cli/complaint.h"
#include "encoder/encoder_session.h"

#include <QtGlobal>

namespace codewheel {

struct Call;

// Of the commands that may write to an EEPROM.
inline constexpr Option beyondLimitOption{
    "--beyond-eeprom-limit", "PLACE",
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "write even where the manual guarantees nothing any more: "
                                                "the place (or places, as 1.0,2.0) once more")};
inline constexpr Option ledgerOption{
    "--ledger", "FILE",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "count EEPROM writes in this file; those of the training bus are else forgotten")};

enum class AsksAnyway { yes, no };

// What has to be said and agreed to before `job`, by how often this program has written to the EEPROM
// (journal/eeprom_cost.h). `asks`: the command asks before it writes; --yes answers.
Checked<void> eepromConsent(const Call &call, const EncoderSession &encoder, const Job &job, AsksAnyway asks);

} // namespace codewheel
