// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_line_address.h"
#include "tests/support/places.h"
#include "trend/trend_csv.h"

#include <QBuffer>
#include <QStringList>

#include <map>

namespace codewheel::test {

// 2026-03-01 13:02:00 UTC
inline constexpr Instant noon = std::chrono::seconds(1'772'370'120);

constexpr Instant at(std::int64_t milliseconds)
{
    return noon + std::chrono::milliseconds(milliseconds);
}

// Histories of tracks, and the tables made of them.
class SampledTracks
{
public:
    MemoryHistory &operator[](const Track &track) { return m_histories[track.key()]; }
    HistoryOf historyOf() const
    {
        return [this](const Track &track) -> const History * {
            const auto found = m_histories.find(track.key());
            return found == m_histories.end() ? nullptr : &found->second;
        };
    }
    void forget() { m_histories.clear(); }

    QByteArray written(const TrendExtract &extract, const CsvStyle &style = {}) const
    {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        TrendCsv csv(buffer, extract, historyOf(), style);
        while (csv.writeSome()) {
        }
        return buffer.data();
    }
    // Without the row of titles, and with times in milliseconds after noon: "5,100,".
    QStringList rows(const TrendExtract &extract) const
    {
        QStringList rows = QString::fromUtf8(written(extract)).split(QStringLiteral("\r\n"));
        rows.removeFirst();
        rows.removeLast();
        for (QString &row : rows) {
            const qsizetype end = row.indexOf(u',');
            const double seconds = row.first(end).toDouble() - std::chrono::duration<double>(noon).count();
            row = QString::number(std::llround(seconds * 1'000)) + row.sliced(end);
        }
        return rows;
    }

private:
    std::map<QString, MemoryHistory> m_histories;
};

inline const Track ringPosition{"1.0"_ring, Channel::position, {}};
inline const Track ringIn{"1.0"_ring, Channel::in, {}};
inline const Track linePosition{placeOnLine({5}), Channel::position, {}};

} // namespace codewheel::test
