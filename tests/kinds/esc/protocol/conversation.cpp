// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/protocol/conversation.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel::esc {

Arrival whole(const QByteArray &bytes, Instant start)
{
    return {start + character * bytes.size(), bytes};
}

Arrivals byteByByte(const QByteArray &bytes, Instant start)
{
    Arrivals arrivals;
    for (qsizetype i = 0; i < bytes.size(); ++i)
        arrivals.push_back({start + character * (i + 1), bytes.mid(i, 1)});
    return arrivals;
}

Arrivals operator+(Arrivals first, const Arrivals &then)
{
    first.insert(first.end(), then.begin(), then.end());
    return first;
}

QByteArray Conversation::bytesOf(EscLineRow::Kind kind) const
{
    QByteArray bytes;
    for (const EscLineRow &row : rows)
        if (row.kind == kind)
            bytes += row.bytes;
    return bytes;
}

QByteArray Conversation::bytesOfAllArrivals() const
{
    QByteArray bytes;
    for (const EscLineRow &row : rows)
        if (row.kind != EscLineRow::Kind::sent)
            bytes += row.bytes;
    return bytes;
}

Conversation converse(const Request &request, const Peer &peer, const Timing &timing, const Arrivals &before)
{
    constexpr int mostSteps = 20'000;
    Exchange exchange(request, timing);
    Conversation conversation;
    Arrivals coming;
    Instant now{};
    const auto arrive = [&](const Arrival &arrival) {
        now = std::max(now, arrival.at);
        exchange.received(arrival.bytes, arrival.at);
        conversation.arrived += arrival.bytes;
    };
    std::ranges::for_each(before, arrive);
    for (int step = 0; step < mostSteps && !conversation.ended; ++step) {
        const Exchange::Action action = exchange.next(now);
        if (const auto *send = std::get_if<Exchange::Send>(&action)) {
            const Instant end = now + timing.character * send->bytes.size();
            const Arrivals because = peer(static_cast<int>(conversation.sendings.size()), end);
            coming.insert(coming.end(), because.begin(), because.end());
            std::ranges::stable_sort(coming, {}, &Arrival::at);
            conversation.sendings.push_back(now);
            conversation.sent.push_back(send->bytes);
        } else if (const auto *wait = std::get_if<Exchange::Wait>(&action)) {
            EXPECT_GT(wait->until, now);
            if (!coming.empty() && coming.front().at <= wait->until) {
                arrive(coming.front());
                coming.erase(coming.begin());
            } else {
                now = wait->until;
            }
        } else {
            conversation.ended = true;
        }
        for (EscLineRow &row : exchange.takeRows())
            conversation.rows.push_back(std::move(row));
    }
    conversation.doneAt = now;
    conversation.result = exchange.result();
    EXPECT_TRUE(conversation.ended);
    EXPECT_EQ(conversation.bytesOfAllArrivals(), conversation.arrived);
    EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::garbage).size(), conversation.result.garbageBytes);
    EXPECT_EQ(conversation.bytesOf(EscLineRow::Kind::late).size(), conversation.result.lateBytes);
    EXPECT_EQ(static_cast<int>(conversation.sendings.size()), conversation.result.sent);
    return conversation;
}

Peer answering(const QByteArray &bytes)
{
    return [bytes](int, Instant end) { return Arrivals{whole(bytes, end + 2 * millisecond)}; };
}

Peer silent()
{
    return [](int, Instant) { return Arrivals(); };
}

Request positionOf05()
{
    return {EscLineAddress{5}, Command::position, 0};
}

Request presetOf03()
{
    return {EscLineAddress{3}, Command::writePreset, 0x5200};
}

void PrintTo(const Answer &answer, std::ostream *out)
{
    *out << "answer " << static_cast<int>(answer.kind) << ", " << answer.value << ", \""
         << answer.text.toStdString() << '"';
}

} // namespace codewheel::esc
