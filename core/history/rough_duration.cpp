// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/rough_duration.h"

namespace codewheel {

QString roughDurationText(Instant duration, const QLocale &locale)
{
    using namespace std::chrono_literals;
    using std::chrono::duration_cast;
    const auto number = [&](auto amount) { return locale.toString(static_cast<qint64>(amount.count())); };
    if (duration < 1min)
        return QStringLiteral("%1 s").arg(number(duration_cast<std::chrono::seconds>(duration)));
    if (duration < 1h)
        return QStringLiteral("%1 min").arg(number(duration_cast<std::chrono::minutes>(duration)));
    const auto hours = duration_cast<std::chrono::hours>(duration);
    if (duration < 48h)
        return QStringLiteral("%1 h %2 min")
            .arg(number(hours), number(duration_cast<std::chrono::minutes>(duration - hours)));
    return QStringLiteral("%1 d %2 h").arg(locale.toString(qint64{hours / 24h}), number(hours % 24h));
}

} // namespace codewheel
