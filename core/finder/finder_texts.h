// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace codewheel {

// The context of the sentences of the finder.
class FinderTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Finder)
};

} // namespace codewheel
