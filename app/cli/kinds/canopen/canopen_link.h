// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link_argument.h"
#include "cli/kinds/link_kind.h"
#include "kinds/canopen/plan/canopen_plan.h"

namespace codewheel {

// The CAN bus that --link names.
struct CanopenLink
{
    CanopenSettings settings{};        // without a link: the simulated bus
    CanLinkArgument at{};              // likewise
    bool takesUnsureWatch = false;     // the user agrees that watching may acknowledge frames
    bool sendsBesideOthers = false;    // that frames are sent beside another master
    bool mayStopNodes = false;         // that a running node is stopped where it takes something only then
    std::optional<Complaint> whyNot{}; // if it cannot be opened
    bool isLog = false;

    bool isSimulated() const { return settings.link.isEmpty() && !isLog; }
};

// What may stand behind it, each "yes".
inline constexpr const char *unsureWatchKey = "unsure-watch";
inline constexpr const char *besideMasterKey = "beside-master";
inline constexpr const char *mayStopKey = "may-stop";
QStringList canopenSettingKeys(const QString &scheme);

// "can:can0", "slcan:ttyACM0,rate=250000", "canopen:training".
Checked<CanopenLink> canopenLinkMeant(const LinkText &text);
// A bus of the project; these settings take precedence over its own.
Checked<CanopenLink> canopenLinkOf(const Project &project, BusId bus, const QStringList &settings = {});

} // namespace codewheel
