// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/explain_exchange.h"

#include "catalog/protocol_rules.h"
#include "catalog/word_meanings.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

bool isOnly(const Explanation &explanation, MeaningId id)
{
    return explanation.isUnique() && explanation.first().id == id;
}

} // namespace

std::optional<Word> askedWord(const DeviceDescription &device, const Exchange &row, const Exchange *before)
{
    const WordMeanings *meanings = protocolRules(device.profile).wordMeanings();
    const bool mayBeOld = before != nullptr && before->in == row.in && before->out != row.out &&
                          meanings != nullptr && meanings->answersUnnamed(row.in);
    return mayBeOld ? std::nullopt : std::optional(row.out);
}

ExplainedExchange explainExchange(const DeviceDescription &device, const Exchange &row,
                                  std::optional<Word> asked)
{
    WordContext context{.mode = row.mode, .coding = row.coding, .counterpart = asked};
    const Explanation in = explainWord(device, row.in, context);
    context.direction = WordDirection::out;
    context.counterpart = row.in;
    return {explainWord(device, row.out, context), in};
}

// A handshake as the manuals describe it: what the master asks for, and how far the encoder has got.
QString exchangeText(const DeviceDescription &device, const Exchange &row, std::optional<Word> asked)
{
    const auto [out, in] = explainExchange(device, row, asked);
    QString answer = explanationText(device, in);
    if (row.isAnswered && isOnly(out, MeaningId::normalRunning))
        return answer;
    const QString question = explanationText(device, out);
    if (!row.isAnswered)
        return QCoreApplication::translate("Trace", "%1: not answered", "meaning of OUT").arg(question);
    if (out.isUnique() && asksForParameter(out.first().id)) {
        if (isOnly(in, MeaningId::confirmed) && in.first().number == out.first().number)
            return QCoreApplication::translate("Trace", "%1: confirmed", "parameter = value").arg(question);
        if (isOnly(in, MeaningId::oldConfirmation) || isOfOperation(in))
            return QCoreApplication::translate("Trace", "%1: not taken yet", "parameter = value")
                .arg(question);
    }
    return QCoreApplication::translate("Trace", "%1 – %2", "meaning of OUT, meaning of IN")
        .arg(question, answer);
}

} // namespace codewheel
