// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "cli/recording/recording_facts.h"
#include "trend/trend_extract.h"
#include "trend/trend_origin.h"

namespace codewheel {

// What of a recording a call of `export` asks for: the tracks of --tracks, or all it has, from --from to
// --to, in the unit of --unit.
Checked<TrendExtract> extractMeant(const Call &call, const RecordingFacts &facts);

// Of the encoders of these columns.
std::vector<TrendEncoder> encodersOf(const Call &call, const RecordingFacts &facts,
                                     const TrendExtract &extract);

// From --from to --to, both included: local times by the clock of the computer that recorded, or seconds from
// the beginning (+60) or before the end (-60). Where an hour of the day came twice, from the first to the
// last of them. Refused if nothing was recorded then.
Checked<TimeSpan> spanMeant(const Arguments &arguments, const RecordingFacts &facts);

} // namespace codewheel
