// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_figures_text.h"

#include "cli/bus/answer_time_text.h"
#include "cli/call/texts.h"
#include "vocabulary/sentence.h"

namespace codewheel {

QString figuresText(const EscLineFigures &figures)
{
    return sentence(
               CommandLine::tr("Requests: %1. Answers: %2. Time-outs: %3. Retries: %4. Not answered: %5. "
                               "Garbage bytes: %6. Late bytes: %7."),
               {countText(figures.requests), countText(figures.answers), countText(figures.timeOuts),
                countText(figures.retries), countText(figures.unanswered), countText(figures.garbageBytes),
                countText(figures.lateBytes)}) +
           u'\n' + answerTimeText(figures.answerTime);
}

QJsonObject figuresJson(const EscLineFigures &figures)
{
    return {{QStringLiteral("requests"), countJson(figures.requests)},
            {QStringLiteral("answers"), countJson(figures.answers)},
            {QStringLiteral("timeOuts"), countJson(figures.timeOuts)},
            {QStringLiteral("retries"), countJson(figures.retries)},
            {QStringLiteral("unanswered"), countJson(figures.unanswered)},
            {QStringLiteral("garbageBytes"), countJson(figures.garbageBytes)},
            {QStringLiteral("lateBytes"), countJson(figures.lateBytes)},
            {QStringLiteral("answerTime"), answerTimeJson(figures.answerTime)}};
}

} // namespace codewheel
