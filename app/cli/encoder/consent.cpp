// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/consent.h"

#include "cli/call/texts.h"
#include "project/file_access.h"

#include <QFileInfo>

namespace codewheel {

Checked<void> checkWasShown(const Call &call)
{
    if (call.terminal.canPrint())
        return {};
    return tl::unexpected(
        notDone("outputFailed", CommandLine::tr("Nothing was sent: what would be sent could not be shown.")));
}

Checked<void> consent(const Call &call, const QString &question, const QString &howWithoutAsking)
{
    if (auto shown = checkWasShown(call); !shown)
        return shown;
    if (call.arguments.has("--yes"))
        return {};
    if (!call.terminal.isInteractive || call.arguments.has("--json"))
        return badInput("noConsent", howWithoutAsking);
    if (!call.terminal.confirms(question))
        return badInput("declined", CommandLine::tr("Nothing was sent."));
    return {};
}

QString nothingSaved()
{
    return CommandLine::tr("%1 is there already. Nothing was saved. Name another file, or add --yes "
                           "to replace it.");
}

Checked<void> checkTargetFile(const Arguments &arguments, const QString &path, const QString &whereThere)
{
    // No file is overwritten unasked.
    if (!arguments.has("--yes") && QFileInfo::exists(path))
        return badInput("fileExists", whereThere, {path});
    if (const auto can = checkReplaceable(path); !can)
        return tl::unexpected(complaintAbout(can.error()));
    return {};
}

} // namespace codewheel
