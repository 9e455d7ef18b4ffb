// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_rate.h"

#include "kinds/esc/line/esc_line_session.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace codewheel {
namespace {

// The context of these texts.
struct EscLineRateText
{
    Q_DECLARE_TR_FUNCTIONS(EscLineRate)
};

// No encoder reports its rate: it is the line's unless this program has changed it.
int rateOf(const EscLineSession &line, Place number)
{
    const auto known = knownNumber(*line.encoder(number), Parameter::baudRate);
    return known ? static_cast<int>(*known) : line.settings().baudRate;
}

} // namespace

EscLineRate lineRateAfter(const EscLineSession &line, Place changed, int baudRate)
{
    const int lineRate = line.settings().baudRate;
    QStringList strangers;
    bool isShared = true; // by all of them
    for (const Place number : line.places()) {
        const int rate = number == changed ? baudRate : rateOf(line, number);
        isShared = isShared && rate == baudRate;
        if (rate != lineRate)
            strangers << sentence(EscLineRateText::tr("%1 (at %2 Bd)"),
                                  {number.shown(), QLocale().toString(rate)});
    }
    if (strangers.isEmpty())
        return {};
    const QString what =
        sentence(EscLineRateText::tr("Connected again at %1 Bd these encoders will not answer: %2."),
                 {QLocale().toString(lineRate), strangers.join(QStringLiteral(", "))});
    if (isShared)
        return {what, baudRate};
    return {what + u' ' + EscLineRateText::tr("Give all encoders of the line the same baud rate."),
            std::nullopt};
}

} // namespace codewheel
