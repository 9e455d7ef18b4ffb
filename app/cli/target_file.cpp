// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/target_file.h"

#include "cli/texts.h"
#include "project/file_access.h"

#include <QFileInfo>

namespace codewheel {

Checked<void> checkTargetFile(const Arguments &arguments, const QString &path)
{
    // What is in a file is not lost.
    if (!arguments.has("--yes") && QFileInfo::exists(path))
        return badInput(
            QStringLiteral("fileExists"),
            CommandLine::tr("%1 is there already. Nothing was saved. Name another file, or add --yes "
                            "to replace it."),
            {path});
    if (const auto can = checkReplaceable(path); !can)
        return tl::unexpected(complaintAbout(can.error()));
    return {};
}

} // namespace codewheel
