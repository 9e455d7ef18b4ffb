// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// Where the texts about files of the journal are translated.
struct Journal
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Journal)
};

} // namespace codewheel
