// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The translation context of the commissioning report: ReportTexts::tr("...").
struct ReportTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ReportTexts)
};

} // namespace codewheel
