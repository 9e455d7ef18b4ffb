// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/mode_left.h"

#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "jobs/job_report.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

bool isKnown(const LeftMode &mode)
{
    return mode.mode && (*mode.mode != Mode::cam || mode.camProgram);
}

QString modeName(const LeftMode &mode)
{
    return modeText(*mode.mode, mode.camProgram);
}

} // namespace

LeftMode modeShown(const EncoderSession &encoder)
{
    return {encoder.latest().mode, encoder.latest().camProgram};
}

QString ModeLeft::toText() const
{
    if (hasFailed && isAnother && now.mode != Mode::position)
        return messageText(leftModeMessage(now));
    if (isOutOfSight || !isKnown(now))
        return CommandLine::tr("In which mode the encoder is now is not known.");
    if (now == before)
        return sentence(CommandLine::tr("The encoder is in %1 again, as before."), {modeName(now)});
    if (isKnown(before))
        return sentence(CommandLine::tr("The encoder is now in %1; before, it was in %2."),
                        {modeName(now), modeName(before)});
    return sentence(CommandLine::tr("The encoder is now in %1; in which mode it was before is not known."),
                    {modeName(now)});
}

void ModeLeft::addTo(QJsonObject &json) const
{
    json.insert(QStringLiteral("mode"), modeJson(now.mode));
    if (now.camProgram)
        json.insert(QStringLiteral("camProgram"), static_cast<int>(*now.camProgram));
}

ModeLeft modeLeft(const EncoderSession &encoder, const Outcome &outcome, const LeftMode &before,
                  const LeftMode &atStart)
{
    const bool isOutOfSight = endedOutOfSight(outcome);
    const LeftMode now = outcome.leftInMode.value_or(isOutOfSight ? atStart : modeShown(encoder));
    return {.before = before,
            .now = now,
            .isAnother = outcome.leftInMode || now != before,
            .hasFailed = !outcome.result,
            .isOutOfSight = isOutOfSight};
}

} // namespace codewheel
