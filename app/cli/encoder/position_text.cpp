// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/position_text.h"

#include "cli/call/texts.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "vocabulary/state_text.h"

namespace codewheel {

QString positionText(std::optional<std::int64_t> position, const Reading &shown,
                     const std::optional<RodScale> &scale)
{
    if (position && scale)
        return QStringLiteral("%1 (%2)").arg(argumentText(*position), scale->text(*position));
    if (position)
        return argumentText(*position);
    if (shown.velocity)
        return CommandLine::tr("not shown in velocity mode");
    if (shown.coding && !shown.mode && shown.state == EncoderState::operation)
        return sentence(CommandLine::tr("IN %1, and the mode of the encoder is not known"),
                        {hexWord(shown.in)});
    return sentence(CommandLine::tr("IN %1, and how it is coded is not known"), {hexWord(shown.in)});
}

QString whereItWasLeft(const Outcome &outcome, const Reading &left)
{
    if (endedOutOfSight(outcome))
        return CommandLine::tr("In which state the encoder is, is not known until it is seen again.");
    if (outcome.foundInParameterization && left.state == EncoderState::parameterization)
        return CommandLine::tr("The encoder is still in parameterization, as before: it shows no position.");
    return whereItWasLeft(left);
}

QString whereItWasLeft(const Reading &left)
{
    switch (left.state) {
    case EncoderState::parameterization:
        return CommandLine::tr("The encoder was left in parameterization: it shows no position.");
    case EncoderState::service:
        return CommandLine::tr("The encoder was left in service mode: it shows no position.");
    case EncoderState::error:
        return left.position ? CommandLine::tr("The encoder was left in error: it shows the last position "
                                               "it knew.")
                             : CommandLine::tr("The encoder was left in error: it shows no position.");
    case EncoderState::waiting:
        return waitingText();
    default:
        return CommandLine::tr("The encoder is in operation.");
    }
}

} // namespace codewheel
