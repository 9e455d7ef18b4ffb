// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/offer_wish.h"

namespace codewheel {

bool reachesOthers(const QString &address)
{
    return !address.startsWith(QStringLiteral("127.")) && address != QStringLiteral("::1") &&
           address != QStringLiteral("localhost");
}

} // namespace codewheel
