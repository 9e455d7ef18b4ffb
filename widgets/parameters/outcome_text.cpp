// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/outcome_text.h"

#include "catalog/device_description.h"
#include "encoder/refusal_text.h"
#include "widgets/functions/function_questions.h"
#include "widgets/job/known_text.h"
#include "widgets/parameters/parameter_panel.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

QString writtenText(const EncoderSession &encoder, const ParameterValues &written)
{
    const auto isReadBack = [&](const ParameterValue &value) {
        const auto known = encoder.known(value.parameter);
        return known && known->evidence == Evidence::read;
    };
    const QString verified =
        std::ranges::all_of(written, isReadBack)
            ? ParameterPanel::tr("%1 written, active and read back.", "names of parameters")
            : ParameterPanel::tr("%1 written, echoed and active.", "names of parameters");
    QStringList names;
    for (const ParameterValue &value : written)
        names << parameterName(value.parameter);
    return verified.arg(names.join(QStringLiteral(", ")));
}

} // namespace

QString outcomeText(const EncoderSession &encoder, const Outcome &outcome)
{
    QStringList sentences;
    if (!outcome.written.empty())
        sentences << writtenText(encoder, outcome.written);
    for (const ParameterValue &along : outcome.setAlong)
        sentences << ParameterPanel::tr("%1: %2, set by the encoder itself with the steps.",
                                        "name of a parameter, value")
                         .arg(parameterName(along.parameter), QLocale().toString(qlonglong{along.value}));
    if (!outcome.written.empty() || outcome.eepromWrites > 0)
        sentences << ParameterPanel::tr("EEPROM writes: %1.").arg(outcome.eepromWrites);
    if (outcome.positionAfter)
        sentences
            << ParameterPanel::tr("Position: %1.").arg(QLocale().toString(qlonglong{*outcome.positionAfter}));
    if (encoder.device().mayHaveModes() && encoder.latest().mode != Mode::position)
        sentences << ParameterPanel::tr("Mode: %1.").arg(modeName(encoder.latest().mode));
    if (!outcome.alreadyThere.empty())
        sentences << ParameterPanel::tr("There already: %1.").arg(outcome.alreadyThere.size());
    else if (outcome.written.empty() && !outcome.read.empty())
        sentences << ParameterPanel::tr("Values read: %1.").arg(outcome.read.size());
    sentences << leftInText(outcome.leftIn);
    if (outcome.onlyZeroSinceRun)
        sentences << messageText({.id = MessageId::onlyZeroSinceRun});
    return sentences.join(QLatin1Char(' '));
}

} // namespace codewheel
