// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/hindrance.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array hindranceKeys{"noPort",
                                   "portMissing",
                                   "notAPort",
                                   "noRights",
                                   "rightsAtNextLogin",
                                   "noRightsForAnyone",
                                   "portTaken",
                                   "slowPort",
                                   "noDriver",
                                   "brltty",
                                   "modemManager",
                                   "canDown",
                                   "privilegedPort",
                                   "serverPortTaken",
                                   "hostUnknown",
                                   "hostRefuses",
                                   "hostSilent",
                                   "portLocked",
                                   "canMissing",
                                   "noCan",
                                   "noCanPlugin"};
constexpr std::array weightKeys{"prevents", "slows", "remark"};

} // namespace

QString hindranceKey(HindranceId id)
{
    return QString::fromLatin1(hindranceKeys.at(static_cast<std::size_t>(id)));
}

QString weightKey(Hindrance::Weight weight)
{
    return QString::fromLatin1(weightKeys.at(static_cast<std::size_t>(weight)));
}

} // namespace codewheel
