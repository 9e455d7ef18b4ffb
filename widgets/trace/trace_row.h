// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/exchange.h"
#include "encoder/place.h"

#include <QDateTime>

namespace codewheel {

// One row of a handshake trace, as it is shown, copied and exported.
struct TraceRow
{
    Exchange exchange;
    std::optional<Word> asked; // the OUT word that IN answers, where that is known
    QDateTime at;
    std::optional<Instant> sinceLast; // nothing for the first row
    QString remark;                   // the user's
};

// What both words say, in one sentence like the manual's: "Parameter 1 steps = 255: confirmed".
QString exchangeText(const DeviceDescription &device, const TraceRow &row);

// By locale: time to the millisecond, date and time, milliseconds since the last row.
QString clockText(const TraceRow &row);
QString traceTimeText(const TraceRow &row);
QString sinceLastText(const TraceRow &row);

// A table for other programs, with a header: comma separated, UTF-8, time as ISO 8601, whatever the locale.
QByteArray traceCsv(Place place, const DeviceDescription &device, const std::vector<TraceRow> &rows);
// Tab separated as on the screen, without a header.
QString traceText(const DeviceDescription &device, const std::vector<TraceRow> &rows);

} // namespace codewheel
