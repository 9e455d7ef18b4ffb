// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The context of the sentences about gateways and their registers.
class GatewayTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::GatewayTexts)
};

} // namespace codewheel
