// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/transfer_words.h"

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "jobs/job_report.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/hex.h"
#include "vocabulary/known_words.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>

namespace codewheel::transfer_words {
namespace {

// The translation context of these texts.
struct TransferWords
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TransferWords)
};

constexpr auto becameTexts = std::to_array<TextOf<Became>>({
    {Became::written, QT_TRANSLATE_NOOP("codewheel::TransferWords", "Written")},
    {Became::alreadyThere, QT_TRANSLATE_NOOP("codewheel::TransferWords", "Already there")},
    {Became::stored, QT_TRANSLATE_NOOP("codewheel::TransferWords", "In force before, and stored now")},
    {Became::restored, QT_TRANSLATE_NOOP("codewheel::TransferWords", "Earlier value restored")},
    {Became::confirmed,
     QT_TRANSLATE_NOOP("codewheel::TransferWords", "Accepted, but not valid until run is sent")},
    {Became::notActive, QT_TRANSLATE_NOOP("codewheel::TransferWords", "Acknowledged, not active")},
    {Became::unknown,
     QT_TRANSLATE_NOOP("codewheel::TransferWords", "Sent: it is not known whether the encoder has it")},
});

QString text(Became became)
{
    return TransferWords::tr(
        textFor(becameTexts, became, QT_TRANSLATE_NOOP("codewheel::TransferWords", "Not done")));
}

// After its state.
QString withMode(const QString &state, const std::optional<LeftMode> &left)
{
    if (!left)
        return state;
    if (!left->mode)
        return sentence(TransferWords::tr("%1; in which mode is not known", "a state"), {state});
    const QString mode = modeText(*left->mode, left->camProgram);
    return left->mode == Mode::position
               ? sentence(TransferWords::tr("%1, in %2", "a state, a mode"), {state, mode})
               : sentence(
                     TransferWords::tr("%1; left in %2: the controller gets no position", "a state, a mode"),
                     {state, mode});
}

} // namespace

QString became(const AccountRow &row)
{
    if (row.became != Became::written || !row.after)
        return text(row.became);
    return row.after->evidence == Evidence::read ? TransferWords::tr("Written, and read back")
                                                 : TransferWords::tr("Written, confirmed by the handshake");
}

QString became(const AccountCamRow &row)
{
    return row.became == Became::written ? TransferWords::tr("Written, and read back") : text(row.became);
}

QString becameOfPosition(const EncoderAccount &account)
{
    return account.positionSet ? TransferWords::tr("Set", "the position")
                               : text(account.positionUnknown ? Became::unknown : Became::notDone);
}

QString value(const DeviceDescription *device, const ParameterValue &value)
{
    const ParameterDescription *parameter = device ? device->find(value.parameter) : nullptr;
    return parameter ? valueText(*parameter, value.value) : plainText(value.value);
}

QString known(const DeviceDescription *device, Parameter parameter, const std::optional<Known> &known)
{
    if (!known)
        return known_words::word(known);
    return QStringLiteral("%1 (%2)").arg(value(device, {parameter, known->value}), known_words::word(known));
}

constexpr auto leftInTexts = std::to_array<TextOf<EncoderState>>({
    {EncoderState::operation, QT_TRANSLATE_NOOP("codewheel::TransferWords", "in operation")},
    {EncoderState::parameterization,
     QT_TRANSLATE_NOOP("codewheel::TransferWords",
                       "in parameterization: it gives no position until run is sent")},
    {EncoderState::error,
     QT_TRANSLATE_NOOP("codewheel::TransferWords", "in the error state: it gives no valid position")},
    {EncoderState::readOut, QT_TRANSLATE_NOOP("codewheel::TransferWords", "still showing a read-out value")},
    {EncoderState::service,
     QT_TRANSLATE_NOOP("codewheel::TransferWords",
                       "in service mode: it gives no position until the service bit is 0")},
    {EncoderState::waiting,
     QT_TRANSLATE_NOOP("codewheel::TransferWords",
                       "waiting for its parameters or to be started: it gives no position")},
    {EncoderState::silent, QT_TRANSLATE_NOOP("codewheel::TransferWords", "silent: it does not answer")},
});

QString leftIn(EncoderState state)
{
    return TransferWords::tr(
        textFor(leftInTexts, state, QT_TRANSLATE_NOOP("codewheel::TransferWords", "not known")));
}

QString leftIn(const EncoderAccount &account)
{
    const QString state = withMode(leftIn(account.leftIn), account.leftInMode);
    QStringList words;
    for (const Word word : account.outLeft)
        words << hexWord(word);
    words.removeDuplicates();
    return words.isEmpty() ? state
                           : sentence(TransferWords::tr("%1; OUT may still hold %2", "a state, words"),
                                      {state, words.join(QStringLiteral(", "))});
}

QStringList notes(const EncoderPlan &plan)
{
    if (!plan.isWritten())
        return {};
    QStringList notes = howItIsWritten(plan.write);
    if (std::ranges::any_of(plan.cams, [](const TransferCamRow &row) { return !row.isThere; }))
        notes << TransferWords::tr("Cam programs are read, written where they differ, and stored when they "
                                   "are left.");
    if (plan.position)
        notes << sentence(TransferWords::tr("At the end, the position is set to %1."),
                          {numberText(*plan.position)});
    if (plan.presetIsRearmed)
        notes << TransferWords::tr("A preset acts once: it is programmed again where it is used up.");
    for (const ValueNote &note : plan.write.notes)
        notes << noteText(note);
    return notes;
}

QString summary(const EncoderPlan &plan)
{
    if (plan.hindrance)
        return refusalText(*plan.hindrance);
    if (plan.write.rows.empty() && plan.cams.empty() && !plan.position)
        return TransferWords::tr("Nothing is wanted for it.");
    if (!plan.isWritten())
        return TransferWords::tr("It has everything already: nothing is sent.");
    const auto values = std::ranges::count(plan.write.rows, false, &WriteRow::isThere);
    const auto cams = std::ranges::count(plan.cams, false, &TransferCamRow::isThere);
    return sentence(TransferWords::tr("Values and cam programs to write: %1. EEPROM writes: at most %2."),
                    {numberText(values + cams), numberText(plan.eepromWrites)});
}

QString outcome(const EncoderAccount &account)
{
    if (account.why)
        return account.leftInMode
                   ? refusalText(*account.why) + u' ' + messageText(leftModeMessage(*account.leftInMode))
                   : refusalText(*account.why);
    if (!account.isDone())
        return TransferWords::tr("Not started.");
    if (!account.isBegun)
        return TransferWords::tr("It had everything already: nothing was sent.");
    return account.onlyZeroSinceRun ? messageText({.id = MessageId::onlyZeroSinceRun})
                                    : TransferWords::tr("Done.");
}

QStringList differences(const ReplacementDifferences &differences, const Replacement &now)
{
    QStringList lines;
    if (!differences.makeBefore.isEmpty())
        lines << sentence(TransferWords::tr("A %1 was planned; the new one is a %2."),
                          {differences.makeBefore, now.device->fullName()});
    if (differences.stepsPerTurn)
        lines << sentence(
            TransferWords::tr("It has %2 physical steps per turn, the previous one had %1."),
            {numberText(differences.stepsPerTurn->first), numberText(differences.stepsPerTurn->second)});
    if (differences.turns)
        lines << sentence(TransferWords::tr("It has %2 turns, the previous one had %1."),
                          {numberText(differences.turns->first), numberText(differences.turns->second)});
    for (const ParameterValue &value : differences.notTaken)
        lines << sentence(TransferWords::tr("It has no \"%1\": the value %2 is not written."),
                          {parameterName(value.parameter), plainText(value.value)});
    if (differences.camsNotTaken)
        lines << TransferWords::tr("It has no cams: the cam programs are not written.");
    return lines;
}

} // namespace codewheel::transfer_words
