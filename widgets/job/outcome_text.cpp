// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/outcome_text.h"

#include "catalog/device_description.h"
#include "jobs/job_report.h"
#include "jobs/value_notes.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/job/known_text.h"
#include "widgets/models/device_traits.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct OutcomeText
{
    Q_DECLARE_TR_FUNCTIONS(OutcomeText)
};

QString namesOfValues(const EncoderSession &encoder, const ParameterValues &values)
{
    QStringList names;
    for (const ParameterValue &value : values)
        names << parameterName(&encoder.device(), value.parameter);
    return names.join(QStringLiteral(", "));
}

QString activeText(const EncoderSession &encoder, const ParameterValues &written)
{
    const auto isReadBack = [&](const ParameterValue &value) {
        const auto known = encoder.known(value.parameter);
        return known && known->evidence == Evidence::read;
    };
    const QString verified =
        std::ranges::all_of(written, isReadBack)
            ? OutcomeText::tr("%1 written, active and read back.", "names of parameters")
            : OutcomeText::tr("%1 written, confirmed and active.", "names of parameters");
    return verified.arg(namesOfValues(encoder, written));
}

QStringList writtenTexts(const EncoderSession &encoder, const ParameterValues &written)
{
    const auto note = scalingNote(encoder, written);
    if (!note)
        return {activeText(encoder, written)};
    ParameterValues active = written;
    ParameterValues kept = written;
    std::erase_if(active, [](const ParameterValue &value) { return isOfScaling(value.parameter); });
    std::erase_if(kept, [](const ParameterValue &value) { return !isOfScaling(value.parameter); });
    QStringList texts{
        OutcomeText::tr("%1 written and read back.", "names of parameters").arg(namesOfValues(encoder, kept)),
        noteText(*note)};
    if (!active.empty())
        texts.prepend(activeText(encoder, active));
    return texts;
}

QString camsText(const Outcome &outcome)
{
    const bool isWritten = !outcome.camsWritten.empty();
    const auto &programs = isWritten ? outcome.camsWritten : outcome.camsRead;
    const bool isOne = programs.size() == 1;
    const QString pattern = isWritten ? isOne ? OutcomeText::tr("Program %1 was written and read back.")
                                              : OutcomeText::tr("Programs %1 were written and read back.")
                            : isOne ? OutcomeText::tr("Program %1 was read.")
                                      : OutcomeText::tr("Programs %1 were read.");
    return programs.empty() ? QString() : pattern.arg(programList(programs));
}

QStringList doneTexts(const EncoderSession &encoder, const Outcome &outcome)
{
    QStringList sentences;
    if (const QString cams = camsText(outcome); !cams.isEmpty())
        sentences << cams;
    if (!outcome.written.empty())
        sentences << writtenTexts(encoder, outcome.written);
    for (const ParameterValue &along : outcome.setAlong)
        sentences << OutcomeText::tr("%1: %2, set by the encoder itself with the steps.",
                                     "name of a parameter, value")
                         .arg(parameterName(&encoder.device(), along.parameter), plainText(along.value));
    if (!outcome.stored.empty())
        sentences << OutcomeText::tr("%1 stored, in force before.", "names of parameters")
                         .arg(namesOfValues(encoder, outcome.stored));
    if (!outcome.written.empty() || outcome.eepromWrites > 0)
        sentences << OutcomeText::tr("EEPROM writes: %1.").arg(outcome.eepromWrites);
    if (outcome.positionAfter)
        sentences << OutcomeText::tr("Position: %1.").arg(numberText(*outcome.positionAfter));
    return sentences;
}

QString modeSentence(const Reading &reading)
{
    return reading.mode
               ? OutcomeText::tr("The encoder is in %1.").arg(modeText(*reading.mode, reading.camProgram))
               : OutcomeText::tr("In which mode the encoder is now is not known.");
}

QString resetText(const Outcome &outcome)
{
    return messageText({.id = MessageId::resetDone, .arguments = {std::int64_t{outcome.eepromWrites}}});
}

QString successText(const EncoderSession &encoder, const Outcome &outcome, bool isReset)
{
    QStringList sentences = isReset ? QStringList{resetText(outcome)} : doneTexts(encoder, outcome);
    if (encoder.device().mayHaveModes() && encoder.latest().mode != Mode::position)
        sentences << modeSentence(encoder.latest());
    if (!outcome.alreadyThere.empty())
        sentences << OutcomeText::tr("Already there: %1.").arg(outcome.alreadyThere.size());
    else if (outcome.written.empty() && outcome.stored.empty() && !outcome.read.empty())
        sentences << OutcomeText::tr("Values read: %1.").arg(outcome.read.size());
    sentences << leftInText(outcome.leftIn);
    if (outcome.onlyZeroSinceRun)
        sentences << messageText({.id = MessageId::onlyZeroSinceRun});
    return sentences.join(u' ');
}

QStringList perhapsWritten(const Outcome &outcome)
{
    if (outcome.inDoubt.eepromWrites == 0)
        return {};
    return {OutcomeText::tr("EEPROM writes: %1.")
                .arg(eepromWritesText(outcome.eepromWrites, outcome.inDoubt.eepromWrites))};
}

QStringList doneBefore(const EncoderSession &encoder, const DoneJobs &before)
{
    const QStringList done = doneTexts(encoder, before.followedBy(Outcome()));
    return done.isEmpty()
               ? QStringList()
               : QStringList(OutcomeText::tr("Done before that: %1", "sentences").arg(done.join(u' ')));
}

QString wayBackText(WayBack way)
{
    return way == WayBack::run          ? OutcomeText::tr("Send run")
           : way == WayBack::endService ? OutcomeText::tr("End the service")
                                        : QString();
}

} // namespace

QString programList(const std::vector<CamProgram> &programs)
{
    QStringList numbers;
    for (const CamProgram &program : programs)
        numbers << QString::number(program.number);
    return numbers.join(QStringLiteral(", "));
}

JobEnd endOf(const EncoderSession &encoder, const Outcome &outcome, const DoneJobs &before, bool isReset)
{
    const WayBack way = wayBack(encoder.device(), outcome.leftIn);
    if (outcome.result)
        return {.role = way == WayBack::none ? Role::running : Role::attention,
                .text = successText(encoder, before.followedBy(outcome), isReset),
                .wayBack = wayBackText(way)};
    const Refusal &why = outcome.result.error();
    const QStringList validTexts = isCancelled(outcome) ? validNowTexts(encoder, outcome) : QStringList();
    return {.role = why.kind == RefusalKind::device ? Role::fault : Role::attention,
            .text = (QStringList(refusalText(why)) + validTexts +
                     QStringList(endText(before.followedBy(outcome))) +
                     doubtSentences(outcome.inDoubt, encoder.device()) + perhapsWritten(outcome) +
                     doneBefore(encoder, before))
                        .join(u' '),
            .wayBack = wayBackText(way)};
}

} // namespace codewheel
