// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/state_note.h"

#include "catalog/explain_word.h"
#include "catalog/protocol_rules.h"
#include "catalog/word_form.h"
#include "jobs/shown_error.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/freshness_text.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/state_text.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The context of these texts.
struct DialNote
{
    Q_DECLARE_TR_FUNCTIONS(DialNote)
};

// An encoder that still shows a position is described by its error; the others show no position.
QString errorNote(const DeviceDescription &device, const Reading &reading)
{
    const unsigned number = reading.errorNumber.value_or(0);
    const DeviceError *error = device.findError(number);
    if (error != nullptr && !device.hasWords())
        return refusalText(shownError(device, reading));
    if (reading.position && error != nullptr)
        return refusalText({RefusalKind::device, error->meaning, {reading.in}});
    return number == 0 ? DialNote::tr("The encoder has no valid position.")
                       : DialNote::tr("The encoder shows error %1: there is no position.").arg(number);
}

// A K1 or K2 has no states: this means that bits it does not use are 1.
QString unknownNote(const DeviceDescription &device, const Reading &reading)
{
    if (onlyTellsPosition(device))
        return explanationText(device, explainWord(device, reading.in, {}));
    return DialNote::tr("No manual describes IN %1: there is no position.").arg(hexWord(reading.in));
}

} // namespace

StateNote noteOfState(const DeviceDescription &device, const Reading &reading)
{
    switch (reading.state) {
    case EncoderState::parameterization:
        return {DialNote::tr("In parameterization: there is no position.")};
    case EncoderState::readOut:
        return {DialNote::tr("IN holds a read-out value: there is no position.")};
    case EncoderState::service:
        return {DialNote::tr("In service mode: there is no position.")};
    case EncoderState::error:
        return {errorNote(device, reading), Role::fault};
    case EncoderState::waiting:
        return {waitingText()};
    case EncoderState::silent:
        return {reading.position ? DialNote::tr("The encoder does not answer: the last position is shown.")
                                 : DialNote::tr("The encoder does not answer: no position is known."),
                Role::fault};
    case EncoderState::unknown:
        return {unknownNote(device, reading)};
    case EncoderState::notSeen:
        return {DialNote::tr("No word of the encoder is known."), Role::inactive};
    case EncoderState::operation:
        break;
    }
    return {{}, Role::running};
}

// The age itself is shown below the number.
StateNote noteOfAge(const EncoderSession &encoder)
{
    const Freshness::Reason reason = encoder.freshness().reason();
    if (reason == Freshness::Reason::silent)
        return noteOfState(encoder.device(), encoder.latest());
    const bool isFault = reason == Freshness::Reason::linkLost;
    return {DialNote::tr("Not up to date: %1", "a sentence").arg(freshnessText(reason)),
            isFault ? Role::fault : Role::inactive};
}

StateNote noteOfRecording(const EncoderSession &encoder, const StateNote &then)
{
    const QString what = freshnessText(encoder.freshness().reason());
    if (then.sentence.isEmpty() || !encoder.freshness().isOld())
        return {what, Role::inactive};
    return {QStringLiteral("%1 %2").arg(what, then.sentence), then.role};
}

QString whyNoPosition(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    const Reading &reading = encoder.latest();
    if (reading.position)
        return {};
    if (reading.state != EncoderState::operation)
        return noteOfState(device, reading).sentence;
    if (reading.velocity)
        return DialNote::tr("No position while the encoder sends its velocity.");
    const QString raw = hexWord(dataOf(device, reading.in));
    if (device.isGeneric())
        return DialNote::tr("Raw word %1. The make of the encoder is not known, and so neither is its "
                            "coding: name it in the bus structure.")
            .arg(raw);
    if (!device.quirks.hasModes || reading.mode == Mode::position)
        return DialNote::tr(
                   "Raw word %1. The coding is not known: write it, or set it manually under Parameters.")
            .arg(raw);
    return reading.mode
               ? DialNote::tr("Raw word %1, in cam mode: there is no position.").arg(raw)
               : DialNote::tr(
                     "Raw word %1. The mode is not known: set the start-up mode manually under Parameters.")
                     .arg(raw);
}

} // namespace codewheel
