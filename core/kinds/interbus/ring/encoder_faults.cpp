// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/shown_error.h"
#include "jobs/what_run_makes_valid.h"
#include "kinds/interbus/ring/ring_checks.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/ring/word_doubts.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/profiles.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/hex.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The translation context of these texts.
struct EncoderFaultText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EncoderFaults)
};

Fault ofEncoder(NodeId node, const StateWord &shown, const QString &text)
{
    return {.extent = Fault::Extent::device, .node = node, .shown = shown, .text = text};
}

// "error 13"; "invalid": it has no valid position.
StateWord errorWord(const EncoderSession *encoder, const Reading &reading)
{
    const unsigned number = reading.errorNumber.value_or(0);
    if (number == 0)
        return {Role::fault, EncoderFaultText::tr("invalid", "position")};
    if (encoder != nullptr && encoder->device().profile == profile::la66)
        return {Role::fault, EncoderFaultText::tr("no magnet")};
    return {Role::fault, EncoderFaultText::tr("error %1").arg(number)};
}

std::optional<Fault> doubt(const RingSession &bus, std::size_t device)
{
    const NodeId node = bus.structure()[device].number;
    if (bus.doubts().mayBeOff(device))
        return ofEncoder(node, {Role::attention, EncoderFaultText::tr("IN is 0")},
                         sentence(EncoderFaultText::tr(
                                      "IN of %1 fell to 00000000: the encoder has no supply, or is at "
                                      "position 0. Check its supply, or turn the shaft to see it change."),
                                  {node.toString()}));
    if (const auto word = bus.doubts().slowlyConfirmed(device))
        return ofEncoder(node, {Role::attention, EncoderFaultText::tr("slow", "to confirm")},
                         sentence(EncoderFaultText::tr(
                                      "%1 takes long to confirm OUT %2, or does not know the word. Wait; if "
                                      "nothing comes, check which encoder it is, and switch it off and "
                                      "on."),
                                  {node.toString(), hexWord(*word)}));
    return std::nullopt;
}

// OUT is 0, or as it was found, and no job is at work: nobody goes on with it.
std::optional<Fault> leftInParameterization(const RingSession &bus, std::size_t device)
{
    const Snapshot::Device &its = bus.latest().devices[device];
    const NodeId node = bus.structure()[device].number;
    const EncoderSession *encoder = bus.encoder(node);
    if (its.reading.state != EncoderState::parameterization || !encoder->device().hasWords() ||
        (its.out != k3::normalRunning && !its.outIsFound) || its.leftOut || its.heldByJob ||
        encoder->runningJob())
        return std::nullopt;
    Fault fault =
        ofEncoder(node, {Role::attention, EncoderFaultText::tr("parameters", "parameterization")},
                  sentence(EncoderFaultText::tr("%1 was left in parameterization and gives no position."),
                           {node.toString()}) +
                      u' ' + whatRunMakesValid(*encoder));
    fault.actions = {FaultAction::run};
    return fault;
}

// By a job that was cut off.
std::optional<Fault> leftInMode(const RingSession &bus, std::size_t device)
{
    const NodeId node = bus.structure()[device].number;
    const EncoderSession *encoder = bus.encoder(node);
    const auto left = encoder->leftInMode();
    if (!left || encoder->runningJob())
        return std::nullopt;
    const Reading &reading = encoder->latest();
    Fault fault =
        reading.mode
            ? ofEncoder(node, {Role::attention, modeText(*reading.mode, std::nullopt)},
                        sentence(EncoderFaultText::tr("%1 was left in %2: the controller gets no position.",
                                                      "an encoder, a mode"),
                                 {node.toString(), modeText(*reading.mode, reading.camProgram)}))
            : ofEncoder(node, {Role::attention, EncoderFaultText::tr("mode?", "it is not known")},
                        sentence(EncoderFaultText::tr("It is not known in which mode %1 was left: the "
                                                      "controller may get no position."),
                                 {node.toString()}));
    fault.actions = {FaultAction::positionMode};
    return fault;
}

} // namespace

std::optional<Fault> encoderFault(const RingSession &bus, std::size_t device)
{
    if (device >= bus.latest().devices.size() || !bus.latest().devices[device].inRing)
        return std::nullopt;
    const NodeId node = bus.structure()[device].number;
    const EncoderSession *encoder = bus.encoder(node);
    if (encoder == nullptr)
        return std::nullopt;
    // An error in such a word is none.
    if (const QString wrong = bus.doubts().wrongWord(device); !wrong.isEmpty())
        return ofEncoder(node, {Role::attention, EncoderFaultText::tr("doubtful", "IN word")},
                         QStringLiteral("%1: %2").arg(node.toString(), wrong));
    const Reading &reading = bus.latest().devices[device].reading;
    if (reading.state == EncoderState::error)
        return ofEncoder(node, errorWord(encoder, reading),
                         QStringLiteral("%1: %2").arg(node.toString(),
                                                      refusalText(shownError(encoder->device(), reading))));
    if (auto left = leftInParameterization(bus, device))
        return left;
    if (auto left = leftInMode(bus, device))
        return left;
    return doubt(bus, device);
}

} // namespace codewheel
