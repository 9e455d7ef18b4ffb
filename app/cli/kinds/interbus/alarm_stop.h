// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/complaint.h"
#include "vocabulary/message.h"

#include <QJsonObject>

#include <chrono>
#include <optional>
#include <vector>

namespace codewheel {

class GatewayAccess;
struct Call;

// What an ALARM STOP of a ring behind a gateway has come to.
struct GatewayStop
{
    std::vector<Message> messages{}; // about its zeros, each at the time when it was so
    std::vector<Message> unsaid{};   // of these, those that standard error does not have
    QString text{};
    QJsonObject json{};
    std::optional<Complaint> complaint{};
};

// A gateway repeats its outputs until it gets others, so it is tried until the zeros are acknowledged and,
// where that is possible, read back. What hinders it is said as it happens, each sentence once, with the ring
// if it is one of several.
Checked<GatewayStop> alarmStopBehindGateway(const Call &call, GatewayAccess &access,
                                            std::chrono::seconds patience, bool isOneOfSeveral);

} // namespace codewheel
