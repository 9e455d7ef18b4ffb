// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"

#include <QJsonObject>

namespace codewheel {

// A line for a client that comes, goes, or is refused.
QString newsLine(const ClientNews &news);
// What was done for all of them.
QString servedText(const ServedClients &clients);
QJsonObject servedJson(const ServedClients &clients);

} // namespace codewheel
