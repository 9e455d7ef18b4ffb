// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/link_figures_text.h"

#include "catalog/hex_code.h"
#include "cli/bus/answer_time_text.h"
#include "cli/call/texts.h"
#include "kinds/interbus/gateway/register_texts.h"
#include "vocabulary/sentence.h"

#include <QLocale>

namespace codewheel {
namespace {

constexpr int statusDigits = 4;

QString exceptionLines(const std::map<int, std::uint64_t> &exceptions)
{
    QString text;
    for (const auto &[code, count] : exceptions)
        text += sentence(CommandLine::tr("Exception %1: %2 (%3)"),
                         {QString::number(code), countText(count), exceptionText(code)}) +
                u'\n';
    return text;
}

// What is put up with; nothing is lost by it.
QString toleratedLine(const LinkFigures &figures)
{
    if (figures.reconnections + figures.strayBytes + figures.echoes == 0)
        return {};
    return sentence(
               CommandLine::tr("Connections that the gateway had closed while idle: %1. Stray bytes: %2. "
                               "Echoes of our requests: %3."),
               {countText(figures.reconnections), countText(figures.strayBytes), countText(figures.echoes)}) +
           u'\n';
}

QString closingLine(const LinkFigures &figures)
{
    if (!figures.closesAfterEach)
        return {};
    return sentence(CommandLine::tr("The gateway closes the connection after each answer. Connections that "
                                    "ended so: %1."),
                    {countText(figures.closedAfterEach)}) +
           u'\n';
}

QJsonObject exceptionsJson(const std::map<int, std::uint64_t> &exceptions)
{
    QJsonObject json;
    for (const auto &[code, count] : exceptions)
        json.insert(QString::number(code), countJson(count));
    return json;
}

} // namespace

QString figuresText(const LinkFigures &figures)
{
    QString text =
        sentence(CommandLine::tr("Transactions: %1. Exchanges: %2 (%3 a second). Retries: %4. Time-outs: %5. "
                                 "Wrong answers: %6. Connections: %7, of them lost: %8. Torn words: %9."),
                 {countText(figures.transactions), countText(figures.exchanges),
                  QLocale().toString(figures.exchangesPerSecond, 'f', 1), countText(figures.retries),
                  countText(figures.noAnswers), countText(figures.wrongAnswers),
                  countText(figures.connections), countText(figures.closed), countText(figures.tornWords)}) +
        u'\n' + toleratedLine(figures) + closingLine(figures) + exceptionLines(figures.exceptions) +
        answerTimeText(figures.roundTrip);
    if (figures.status)
        text += sentence(CommandLine::tr("Status register: %1"), {hexCode(*figures.status, statusDigits)}) +
                u'\n';
    return text;
}

QJsonObject figuresJson(const LinkFigures &figures)
{
    return {{QStringLiteral("transactions"), countJson(figures.transactions)},
            {QStringLiteral("exchanges"), countJson(figures.exchanges)},
            {QStringLiteral("exchangesPerSecond"), figures.exchangesPerSecond},
            {QStringLiteral("retries"), countJson(figures.retries)},
            {QStringLiteral("timeOuts"), countJson(figures.noAnswers)},
            {QStringLiteral("wrongAnswers"), countJson(figures.wrongAnswers)},
            {QStringLiteral("exceptions"), exceptionsJson(figures.exceptions)},
            {QStringLiteral("connections"), countJson(figures.connections)},
            {QStringLiteral("reconnections"), countJson(figures.reconnections)},
            {QStringLiteral("closesAfterEachAnswer"), figures.closesAfterEach},
            {QStringLiteral("closedAfterEachAnswer"), countJson(figures.closedAfterEach)},
            {QStringLiteral("strayBytes"), countJson(figures.strayBytes)},
            {QStringLiteral("echoes"), countJson(figures.echoes)},
            {QStringLiteral("connectionsLost"), countJson(figures.closed)},
            {QStringLiteral("tornWords"), countJson(figures.tornWords)},
            {QStringLiteral("answerTime"), answerTimeJson(figures.roundTrip)},
            {QStringLiteral("status"), figures.status ? QJsonValue(*figures.status) : QJsonValue()}};
}

} // namespace codewheel
