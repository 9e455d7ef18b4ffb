// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_exchange.h"

#include <QDateTime>

#include <tl/expected.hpp>

namespace codewheel {

// What passed on a serial line, to be kept, looked at and sent again (docs/line-sessions.md). Disk access is
// up to the caller.
struct EscLineRecord
{
    static constexpr std::size_t mostRows = 100'000;

    struct Row
    {
        esc::EscLineRow what;
        bool typed = false; // of a typed request, or of its answer

        friend bool operator==(const Row &, const Row &) = default;
    };

    QDateTime begin; // the time of Instant 0 of the rows
    QString port;    // as known to the user
    int baudRate = 19'200;
    std::vector<Row> rows;

    friend bool operator==(const EscLineRecord &, const EscLineRecord &) = default;
};

// The same record always gives the same bytes.
QByteArray lineRecordToJson(const EscLineRecord &record);

// Rejects the file as a whole if it breaks a rule, with a sentence that names file, line and key. `name` is
// the file's.
tl::expected<EscLineRecord, QString> lineRecordFromJson(const QByteArray &json, const QString &name);

} // namespace codewheel
