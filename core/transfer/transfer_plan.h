// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/transfer_wish.h"

namespace codewheel {

class Buses;

// One value of the difference between what is wanted and what is known.
struct TransferRow
{
    ParameterValue wanted;
    std::optional<Known> known{}; // of the encoder now
    std::optional<Step> step{};   // which carries it: its word, or its request; nothing: it is not sent
    bool isThere = false;         // known to be there: left out
    bool goesAlong = false;       // not wanted: computed from the others, as the factor of a serial encoder
    std::optional<Refusal> hindrance{};
};

struct TransferCamRow
{
    CamProgram wanted;
    std::optional<KnownCams> known{};
    bool isThere = false;
};

// What is to be done with one encoder, to be looked at before anything is sent.
struct EncoderPlan
{
    Place place;
    QString station{};
    QString device{};                   // "FRABA OCD-IB K3"; empty: nothing there
    std::optional<Refusal> hindrance{}; // nothing is written
    std::vector<TransferRow> rows{};
    std::vector<TransferCamRow> cams{};
    std::optional<std::int64_t> position{};
    std::vector<Job> jobs{};      // one after the other; none: all is there, or a hindrance
    int eepromWrites = 0;         // at most
    bool readsFirst = false;      // what the encoder turns out to have is left out as well
    bool stepsMayBeLess = false;  // the encoder may count steps minus 1: its word may be one less
    bool presetIsRearmed = false; // FRABA: the preset may have to be programmed again before it acts

    bool isWritten() const { return !hindrance && !jobs.empty(); }
};
using TransferPlan = std::vector<EncoderPlan>;

// Compares each wish with what is known of the encoder at its place. An encoder of which one value cannot be
// written is not written at all. Sends nothing.
TransferPlan planTransfer(const Buses &buses, const std::vector<TransferWish> &wishes);

int eepromWritesOf(const TransferPlan &plan); // at most

} // namespace codewheel
