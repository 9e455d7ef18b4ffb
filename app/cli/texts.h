// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The translation context of what the command line says: CommandLine::tr("..."). Tables of constant texts
// mark theirs with QT_TRANSLATE_NOOP("codewheel::CommandLine", "...").
struct CommandLine
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CommandLine)
};

} // namespace codewheel
