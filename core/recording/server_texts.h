// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The translation context of texts about the server of a recording.
struct Server
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Server)
};

} // namespace codewheel
