// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The context of the sentences about what keeps a link from working.
class DoctorTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Doctor)
};

} // namespace codewheel
