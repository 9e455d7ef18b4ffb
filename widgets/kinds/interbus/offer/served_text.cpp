// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/served_text.h"

#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QDateTime>
#include <QLocale>

namespace codewheel {

QString ServedText::time(ServedClient::Time at)
{
    const auto sinceEpoch = std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(sinceEpoch.count()).time().toString(QStringLiteral("HH:mm:ss"));
}

QString ServedText::written(const std::optional<ServedClient::Written> &written)
{
    if (!written)
        return QStringLiteral("\u2013");
    return QStringLiteral("%1  %2  %3")
        .arg(written->word.place.toString(), hexWord(written->word.word), time(written->at));
}

QString ServedText::count(std::uint64_t count)
{
    return QLocale().toString(qulonglong{count});
}

QString ServedText::clients(const ClientCounts &counts)
{
    const std::uint64_t present = counts.came - counts.left;
    const QString before =
        sentence(tr("%1 came, %2 refused", "clients so far"), {count(counts.came), count(counts.refused)});
    if (present == 0)
        return sentence(tr("Nobody is connected (%1)."), {before});
    return sentence(tr("Connected: %1 (%2)."), {count(present), before});
}

} // namespace codewheel
