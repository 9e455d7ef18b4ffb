// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"

#include <QCoreApplication>

namespace codewheel {

// What clients of an offered ring do, as their tables show it.
class ServedText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ServedText)

public:
    static QString time(ServedClient::Time at); // of the day
    // "1.0  020000FF  14:02:11"; nothing was written: a dash.
    static QString written(const std::optional<ServedClient::Written> &written);
    // For the width of a column.
    static QString widestWritten() { return QStringLiteral("10.0  00000000  00:00:00"); }
    static QString count(std::uint64_t count);
    // How many are there, and how many came, left and were refused.
    static QString clients(const ClientCounts &counts);
};

} // namespace codewheel
