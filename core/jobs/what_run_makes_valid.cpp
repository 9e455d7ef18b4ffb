// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/what_run_makes_valid.h"

#include "jobs/protocol.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct RunText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::WhatRunMakesValid)
};

// "IN (C2001000) confirms Steps with the data 4,096."
QString confirmed(const DeviceDescription &device, Word in)
{
    const auto value = protocolOf(device).confirmedIn(device, in);
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
    return confirmed(encoder.device(), encoder.latest().in) +
           (taken.isEmpty()
                ? RunText::tr("Run makes valid what was written to it, by whomever.")
                : sentence(RunText::tr("Run makes valid what it has taken, from here: %1."), {taken}));
}

} // namespace codewheel
