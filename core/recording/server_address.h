// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <map>

namespace codewheel {

// Where recordings of several stations come together:
//   postgresql://[USER@]HOST[:PORT]/DATABASE[?sslmode=...&sslrootcert=...&connect_timeout=...&recording=NAME]
// HOST is a name, an address, or the folder of a socket with %2F for each slash. There is never a password in
// it: PostgreSQL's own library takes it from PGPASSFILE, ~/.pgpass or PGPASSWORD.
struct ServerAddress
{
    QString host;
    int port = 0; // 0: the usual one
    QString user;
    QString database;
    QString recording; // its schema; empty: not said
    std::map<QString, QString> options{};

    static bool isMeant(const QString &text);
    static Result<ServerAddress> parse(const QString &text);

    // Without the name of a recording: the same for the same database and user.
    QString place() const;
    QString text() const;
    ServerAddress withRecording(const QString &name) const;
};

} // namespace codewheel
