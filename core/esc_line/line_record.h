// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "esc/esc_exchange.h"

#include <QDateTime>

#include <tl/expected.hpp>

namespace codewheel {

// What passed on a serial line, to be kept, looked at and sent again (docs/line-sessions.md). Reading and
// writing the disk is the caller's.
struct LineRecord
{
    static constexpr std::size_t mostRows = 100'000;

    struct Row
    {
        esc::LineRow what;
        bool typed = false; // of a request that was typed, or of its answer

        friend bool operator==(const Row &, const Row &) = default;
    };

    QDateTime begin; // what Instant 0 of the rows stands for
    QString port;    // as the user knows it
    int baudRate = 19'200;
    std::vector<Row> rows;

    friend bool operator==(const LineRecord &, const LineRecord &) = default;
};

// The same record always gives the same bytes.
QByteArray lineRecordToJson(const LineRecord &record);

// Refuses what breaks a rule, as a whole, with a sentence that names file, line and key. `name` is the
// file's.
tl::expected<LineRecord, QString> lineRecordFromJson(const QByteArray &json, const QString &name);

} // namespace codewheel
