// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The translation context of texts about the files of the journal.
struct Journal
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Journal)
};

} // namespace codewheel
