// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/sent_zeros_text.h"

#include "bus/word_channel.h"
#include "cli/call/keys.h"
#include "cli/call/texts.h"
#include "cli/kinds/interbus/gateway_access.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QJsonArray>

#include <algorithm>

namespace codewheel {
namespace {

enum class ZerosState : std::uint8_t { notSent, refused, unanswered, acknowledged, readBack, overwritten };

constexpr NamedValue<ZerosState> zerosStateKeys[] = {
    {"notSent", ZerosState::notSent},       {"refused", ZerosState::refused},
    {"unanswered", ZerosState::unanswered}, {"acknowledged", ZerosState::acknowledged},
    {"readBack", ZerosState::readBack},     {"overwritten", ZerosState::overwritten},
};

ZerosState stateOf(const SentZeros &zeros)
{
    if (zeros.readBackAt)
        return ZerosState::readBack;
    if (zeros.acknowledgedAt)
        return ZerosState::acknowledged;
    if (zeros.mayHaveArrived && zeros.refusedBy.empty())
        return ZerosState::unanswered;
    return zeros.sentAt ? ZerosState::refused : ZerosState::notSent;
}

QString registersOfOut(const GatewayMap &map)
{
    if (map.outBlocks().empty())
        return CommandLine::tr("no registers");
    return sentence(
        CommandLine::tr("registers %1 to %2"),
        {QString::number(map.outBlocks().front().first), QString::number(map.outBlocks().back().end() - 1)});
}

qint64 zerosMilliseconds(Instant at)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(at).count();
}

QString atTime(const QString &pattern, const GatewayAccess &access, Instant at)
{
    return sentence(pattern, {QString::number(zerosMilliseconds(at)),
                              access.ring().dateTime(at).toString(QStringLiteral("HH:mm:ss.zzz"))});
}

QString acknowledgementText(const GatewayAccess &access, const SentZeros &zeros)
{
    if (zeros.acknowledgedAt)
        return atTime(CommandLine::tr("acknowledged at %1 ms (%2)"), access, *zeros.acknowledgedAt);
    if (!zeros.refusedBy.empty())
        return sentence(CommandLine::tr("acknowledged, but refused for %1"),
                        {listed(zeros.refusedBy, [&](std::size_t device) {
                            return access.devices()[device].participant.number.toString();
                        })});
    return zeros.mayHaveArrived ? CommandLine::tr("not acknowledged") : CommandLine::tr("refused");
}

QString readBackText(const GatewayAccess &access, const SentZeros &zeros, bool areOverwritten)
{
    if (!zeros.readBackAt)
        return areOverwritten ? CommandLine::tr("read back as something else")
                              : CommandLine::tr("not read back");
    const QString text =
        atTime(CommandLine::tr("read back as 00000000 at %1 ms (%2)"), access, *zeros.readBackAt);
    return areOverwritten ? text + QStringLiteral(", ") + CommandLine::tr("then as something else") : text;
}

QJsonValue timeJson(const GatewayAccess &access, std::optional<Instant> at)
{
    if (!at)
        return {};
    return QJsonObject{{QStringLiteral("milliseconds"), zerosMilliseconds(*at)},
                       {QStringLiteral("time"), access.ring().dateTime(*at).toString(Qt::ISODateWithMs)}};
}

// Null while it is not known.
QJsonValue outJson(const GatewayAccess &access, NodeId node)
{
    const WordChannel *channel = access.ring().channel(node);
    return channel != nullptr && channel->outIsKnown() ? QJsonValue(hexWord(channel->out())) : QJsonValue();
}

QJsonArray outRegistersJson(const GatewayAccess &access, const SentZeros &zeros)
{
    QJsonArray rows;
    const auto map = mapOf(access.devices(), access.gateway());
    for (std::size_t i = 0; map && i < map->devices(); ++i) {
        if (map->out(i).count == 0)
            continue;
        const NodeId node = access.devices()[i].participant.number;
        rows.append(QJsonObject{{QStringLiteral("place"), node.toString()},
                                {QStringLiteral("first"), map->out(i).first},
                                {QStringLiteral("count"), map->out(i).count},
                                {QStringLiteral("out"), outJson(access, node)},
                                {QStringLiteral("refused"), std::ranges::count(zeros.refusedBy, i) > 0}});
    }
    return rows;
}

} // namespace

QString unfinishedZerosText(const SentZeros &zeros)
{
    switch (stateOf(zeros)) {
    case ZerosState::notSent:
    case ZerosState::refused:
        return CommandLine::tr(
            "The zeros of the ALARM STOP have not arrived yet. Stop the machine by its own means.");
    case ZerosState::unanswered:
        return CommandLine::tr(
            "The zeros of the ALARM STOP were sent, but are not acknowledged yet: it is not known whether "
            "they have arrived. Stop the machine by its own means.");
    case ZerosState::acknowledged:
        return CommandLine::tr("The zeros of the ALARM STOP are acknowledged, but not read back yet.");
    case ZerosState::readBack:
    case ZerosState::overwritten:
        break;
    }
    return {};
}

Complaint missedZeros(const SentZeros &zeros, std::chrono::seconds after)
{
    const ZerosState state = stateOf(zeros);
    const auto about = [&](const char *key, const QString &pattern) {
        return notDone(key, sentence(pattern, {QString::number(after.count())}),
                       {static_cast<std::int64_t>(after.count())});
    };
    if (state == ZerosState::unanswered)
        return about("zerosUnanswered",
                     CommandLine::tr(
                         "The zeros of the ALARM STOP were sent, but not acknowledged within %1 s: it is not "
                         "known whether they have arrived. Stop the machine by its own means."));
    if (state == ZerosState::acknowledged || state == ZerosState::readBack)
        return about(
            "zerosNotReadBack",
            CommandLine::tr(
                "The zeros of the ALARM STOP were acknowledged, but not read back within %1 s: it is "
                "not known whether they are still there. Stop the machine by its own means."));
    return about("zerosMissing",
                 CommandLine::tr("The zeros of the ALARM STOP have not arrived within %1 s. Stop the machine "
                                 "by its own means."));
}

QString sentZerosText(const GatewayAccess &access, const SentZeros &zeros, bool areOverwritten)
{
    QStringList parts;
    if (const auto map = mapOf(access.devices(), access.gateway()))
        parts << registersOfOut(*map);
    if (!zeros.sentAt)
        parts << CommandLine::tr("not sent");
    else
        parts << atTime(CommandLine::tr("sent at %1 ms (%2)"), access, *zeros.sentAt)
              << acknowledgementText(access, zeros);
    if (zeros.acknowledgedAt)
        parts << readBackText(access, zeros, areOverwritten);
    return CommandLine::tr("Zeros:          %1").arg(parts.join(QStringLiteral(", "))) + u'\n';
}

QJsonObject sentZerosJson(const GatewayAccess &access, const SentZeros &zeros, bool areOverwritten)
{
    const ZerosState state = areOverwritten ? ZerosState::overwritten : stateOf(zeros);
    return {{QStringLiteral("state"), keyOf(zerosStateKeys, state)},
            {QStringLiteral("sent"), timeJson(access, zeros.sentAt)},
            {QStringLiteral("acknowledged"), timeJson(access, zeros.acknowledgedAt)},
            {QStringLiteral("readBack"), timeJson(access, zeros.readBackAt)},
            {QStringLiteral("registers"), outRegistersJson(access, zeros)}};
}

} // namespace codewheel
