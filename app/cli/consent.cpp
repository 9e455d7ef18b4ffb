// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/consent.h"

#include "cli/texts.h"

namespace codewheel {

Checked<void> checkWasShown(const Call &call)
{
    if (call.terminal.canPrint())
        return {};
    return tl::unexpected(
        Complaint{ExitCode::refused, QStringLiteral("outputFailed"),
                  CommandLine::tr("Nothing was sent: what would be sent could not be shown.")});
}

Checked<void> consent(const Call &call, const QString &question, const QString &howWithoutAsking)
{
    if (auto shown = checkWasShown(call); !shown)
        return shown;
    if (call.arguments.has("--yes"))
        return {};
    if (!call.terminal.isInteractive || call.arguments.has("--json"))
        return badInput(QStringLiteral("noConsent"), howWithoutAsking);
    if (!call.terminal.confirms(question))
        return badInput(QStringLiteral("declined"), CommandLine::tr("Nothing was sent."));
    return {};
}

} // namespace codewheel
