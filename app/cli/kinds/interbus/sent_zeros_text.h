// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/complaint.h"
#include "kinds/interbus/gateway/sent_zeros.h"

#include <QJsonObject>

#include <chrono>

namespace codewheel {

class GatewayAccess;

// How zeros stand that are on their way; empty: they have arrived.
QString unfinishedZerosText(const SentZeros &zeros);
// Why nobody tries any longer, after that time.
Complaint missedZeros(const SentZeros &zeros, std::chrono::seconds after);

// Where they went and when, as a line and for programs. `areOverwritten`: something else was read back later.
QString sentZerosText(const GatewayAccess &access, const SentZeros &zeros, bool areOverwritten);
QJsonObject sentZerosJson(const GatewayAccess &access, const SentZeros &zeros, bool areOverwritten);

} // namespace codewheel
