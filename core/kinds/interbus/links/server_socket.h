// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/descriptor.h"
#include "vocabulary/refusal.h"

#include <utility>

namespace codewheel {

// Where a server listens.
struct ServerPlace
{
    QString host = QStringLiteral("127.0.0.1"); // name or address of this computer; "0.0.0.0": all it has
    int port = 0;                               // 0: one that the system chooses
};

// A TCP socket that listens there. Refused: hostNotFound, serverAddressNotOurs, serverPortTaken,
// serverPortPrivileged, linkFailed.
Result<Descriptor> listenAt(const ServerPlace &place);

// Where it listens, with the port the system chose.
ServerPlace placeOf(const Descriptor &listening);

// The next client that connected, and its address; none: nobody did, or there are too many sockets.
std::pair<Descriptor, QString> acceptClient(const Descriptor &listening);

// "127.0.0.1:502", "[::1]:502".
QString shownAddress(const ServerPlace &place);

} // namespace codewheel
