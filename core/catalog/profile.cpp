// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/profile.h"

namespace codewheel {

const QStringList &profileNames()
{
    static const QStringList names{QStringLiteral("K1"), QStringLiteral("K2"),    QStringLiteral("K3"),
                                   QStringLiteral("K4"), QStringLiteral("LA-66"), QStringLiteral("ESC")};
    return names;
}

QString profileName(Profile profile)
{
    return profileNames().at(static_cast<qsizetype>(profile));
}

} // namespace codewheel
