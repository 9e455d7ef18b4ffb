// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/sql_connection.h"
#include "recording/server_address.h"

namespace codewheel {

// Why there is no connection: PostgreSQL's library tells it as an English text and nothing else.
DatabaseError connectionError(const ServerAddress &address, const QString &text);
// Why a statement failed: by its SQLSTATE; without one the connection is lost.
DatabaseError statementError(const QSqlError &error);

} // namespace codewheel
