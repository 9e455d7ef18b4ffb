// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/setup/lss_search.h"
#include "kinds/canopen/setup/node_check.h"
#include "kinds/canopen/setup/node_setup.h"

#include <QString>

#include <optional>

// What is said of a device that gets its number and rate.
namespace codewheel::node_setup_text {

QString identity(const canopen::NodeIdentity &identity);
// "Node 6 (06h)", "A device without a number".
QString device(std::optional<int> node);
QString step(canopen::NodeSetup::Step step, const canopen::NodeSetupWish &wish);
// What will happen, before anything is sent.
QString consequences(const canopen::NodeSetupWish &wish);

// What runs, and what it leads to that it is cut off.
struct AtStake
{
    QString what{};
    QString consequence{};
};
AtStake ofSearch(); // for a device without a number
AtStake ofWriting(const canopen::NodeSetupWish &wish);
AtStake ofChecking(const canopen::NodeSetupWish &wish); // for the device at its new number

// How it ended: what is known of it, and what to do.
QString end(const canopen::NodeSetup &setup);
QString end(const canopen::NodeCheck &check, bool wasWithoutSupply);
QString end(const canopen::LssSearch &search); // that has found nobody
QString end(const canopen::IdentityReading &reading);

} // namespace codewheel::node_setup_text
