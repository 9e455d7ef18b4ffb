// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/known_text.h"

#include "catalog/value_text.h"
#include "jobs/job_report.h"
#include "jobs/value_notes.h"
#include "vocabulary/known_words.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/state_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace codewheel {
namespace {

// The context of these texts.
struct KnownText
{
    Q_DECLARE_TR_FUNCTIONS(KnownText)
};

// The positions of the job, or that of now.
QStringList whereItWent(const EncoderSession &encoder, const Outcome &outcome)
{
    if (outcome.leftIn != EncoderState::operation)
        return {};
    const auto after =
        outcome.positionAfter || !encoder.showsPosition() ? outcome.positionAfter : encoder.latest().position;
    if (!after)
        return {};
    return {outcome.positionBefore && outcome.positionBefore != after
                ? KnownText::tr("The position went from %1 to %2.")
                      .arg(numberText(*outcome.positionBefore), numberText(*after))
                : KnownText::tr("The position is %1.").arg(numberText(*after))};
}

} // namespace

QString howKnown(const std::optional<Known> &known, const EncoderSession &encoder)
{
    const QString how = known_words::explanation(known, encoder.can().reads);
    return known ? how + u'\n' + QLocale().toString(encoder.dateTime(known->at), QLocale::ShortFormat) : how;
}

QString whyNotToldByWord(Parameter parameter, const EncoderSession &encoder)
{
    const bool maySayLess = parameter == Parameter::steps && encoder.device().quirks.mayCountStepsMinusOne &&
                            !encoder.known(Parameter::multiTurnAndStepsMinusOne);
    return maySayLess
               ? KnownText::tr("As long as it is not known whether the encoder counts steps minus 1, a word "
                               "written by hand does not tell its steps.")
               : QString();
}

QString valueWithUnit(const DeviceDescription &device, const ParameterValue &value, const KindData &options)
{
    const ParameterDescription *parameter = device.find(value.parameter);
    if (parameter == nullptr)
        return plainText(value.value);
    return QStringLiteral("%1 %2")
        .arg(valueText(*parameter, value.value, options), unitText(*parameter, value.value))
        .trimmed();
}

QString valueList(const DeviceDescription &device, const ParameterValues &values)
{
    QStringList texts;
    for (const ParameterValue &value : values) {
        const ParameterDescription *parameter = device.find(value.parameter);
        texts += QStringLiteral("%1 = %2").arg(parameterName(&device, value.parameter),
                                               parameter ? valueText(*parameter, value.value)
                                                         : plainText(value.value));
    }
    return texts.join(QStringLiteral(", "));
}

QString knownText(const DeviceDescription &device, const std::optional<Known> &known)
{
    if (!known)
        return known_words::word(known);
    return QStringLiteral("%1 (%2)").arg(valueWithUnit(device, {known->parameter, known->value}),
                                         known_words::word(known));
}

QString restoredText(const std::optional<Evidence> &restored)
{
    if (!restored)
        return {};
    return restored == Evidence::read
               ? KnownText::tr("It has its earlier values again: they were read back and match.")
               : KnownText::tr("It has confirmed its earlier values and runs with them; it cannot be read.");
}

QStringList movementTexts(const EncoderSession &encoder)
{
    if (!encoder.showsPosition() || std::abs(encoder.latest().stepsPerSecond.value_or(0)) < 1)
        return {};
    return {
        KnownText::tr("The encoder moves: the place that gets the new position is where it stands when the "
                      "command arrives.")};
}

QStringList positionNowTexts(const EncoderSession &encoder)
{
    if (!encoder.showsPosition())
        return {KnownText::tr("Which position it shows now is not known.")};
    return QStringList(KnownText::tr("It shows %1 now.").arg(numberText(*encoder.latest().position)))
           << movementTexts(encoder);
}

bool isCancelled(const Outcome &outcome)
{
    return !outcome.result && outcome.result.error().id == RefusalId::cancelled;
}

QStringList validNowTexts(const EncoderSession &encoder, const Outcome &outcome)
{
    if (outcome.restored || outcome.written.empty())
        return {};
    ParameterValues values = outcome.written;
    for (const ParameterValue &along : outcome.setAlong)
        replaceValue(values, along);
    const QString list = valueList(encoder.device(), values);
    const auto unscaled = scalingNote(encoder, values);
    const QString valid =
        unscaled ? KnownText::tr("Written: %1.", "names and values").arg(list) + u' ' + noteText(*unscaled)
                 : KnownText::tr("Valid now: %1.", "names and values").arg(list);
    return QStringList(valid) << whereItWent(encoder, outcome);
}

QString leftInText(EncoderState state)
{
    switch (state) {
    case EncoderState::operation:
        return KnownText::tr("The encoder is in operation.");
    case EncoderState::parameterization:
        return KnownText::tr("The encoder is in parameterization: it gives no position until run is sent.");
    case EncoderState::error:
        return KnownText::tr("The encoder is in the error state: it gives no valid position.");
    case EncoderState::readOut:
        return KnownText::tr("The encoder still shows a read-out value.");
    case EncoderState::service:
        return KnownText::tr("The encoder is in service mode: it gives no position until the service bit "
                             "is 0.");
    case EncoderState::waiting:
        return waitingText();
    case EncoderState::notSeen:
        return KnownText::tr("The encoder has not been seen on the bus.");
    case EncoderState::silent:
        return KnownText::tr("The encoder does not answer any more.");
    case EncoderState::unknown:
        break;
    }
    return KnownText::tr("The state of the encoder is not known.");
}

QString endText(const Outcome &outcome)
{
    QStringList sentences;
    if (outcome.isPositionSet)
        sentences << KnownText::tr("The position was set before, and stays so.");
    if (outcome.restored)
        sentences << restoredText(outcome.restored);
    sentences << leftInText(outcome.leftIn);
    if (const auto left = leftModeReport(outcome))
        sentences << messageText(*left);
    return sentences.join(u' ');
}

} // namespace codewheel
