// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The texts of the rules for descriptions of devices.
struct DescriptionRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DescriptionRules)
};

} // namespace codewheel
