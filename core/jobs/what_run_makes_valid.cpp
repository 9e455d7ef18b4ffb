// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/what_run_makes_valid.h"

#include "catalog/explain_word.h"
#include "jobs/protocol.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct RunText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::WhatRunMakesValid)
};

// In cam mode an encoder takes no parameters, and outside of it no cams.
std::optional<Mode> modeTakenIn(const EncoderSession &encoder)
{
    if (encoder.hasTakenCams())
        return Mode::cam;
    return encoder.takenWithoutRun().isEmpty() ? encoder.latest().mode : Mode::position;
}

// What has been taken may be cams.
bool mayBeOfCams(const EncoderSession &encoder)
{
    return encoder.device().mayHaveModes() && modeTakenIn(encoder).value_or(Mode::cam) == Mode::cam;
}

// "IN (C2001000) confirms Steps with the data 4,096." The same word may confirm a cam.
QString confirmed(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    const Word in = encoder.latest().in;
    const auto value = protocolOf(device).confirmedIn(device, in);
    if (mayBeOfCams(encoder))
        return sentence(RunText::tr("IN (%1) says: %2.", "what it may confirm"),
                        {hexWord(in),
                         explanationText(device, explainWord(device, in, {.mode = modeTakenIn(encoder)}))}) +
               u' ';
    if (!value)
        return {};
    return sentence(RunText::tr("IN (%1) confirms %2 with the data %3.", "a name, a number"),
                    {hexWord(in), parameterName(value->parameter), plainText(value->value)}) +
           u' ';
}

} // namespace

QString whatRunMakesValid(const EncoderSession &encoder)
{
    const QString taken = encoder.takenWithoutRun();
    return confirmed(encoder) +
           (taken.isEmpty()
                ? RunText::tr("Run makes valid what was written to it, by whomever.")
                : sentence(RunText::tr("Run makes valid what it has taken, from here: %1."), {taken}));
}

QString whatFollowsRun(const EncoderSession &encoder, const QString &positionThen)
{
    if (!mayBeOfCams(encoder))
        return RunText::tr("The encoder then gives its position by these values: it can jump, and what "
                           "the controller drives by it can move.") +
               u' ' +
               (positionThen.isEmpty() ? RunText::tr("Which position it will read is not known.")
                                       : positionThen);
    if (modeTakenIn(encoder) == Mode::cam)
        return RunText::tr("The encoder then switches its cams by these values, and what the controller "
                           "drives by them can move.");
    return RunText::tr(
        "Its mode is not known: the encoder then gives its position by these values, or switches "
        "its cams by them. The position can jump, cams can switch, and what the controller "
        "drives by them can move.");
}

} // namespace codewheel
