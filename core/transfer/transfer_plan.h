// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/write_plan.h"
#include "transfer/transfer_wish.h"

namespace codewheel {

class Buses;

struct TransferCamRow
{
    CamProgram wanted;
    std::optional<KnownCams> known{};
    bool isThere = false;
};

// What is to be done with one encoder, for review before anything is sent.
struct EncoderPlan
{
    Place place;
    QString station{};
    QString device{};                   // "FRABA OCD-IB K3"; empty: nothing there
    std::optional<Refusal> hindrance{}; // nothing is written
    WritePlan write{};                  // of the values and the position
    std::vector<TransferCamRow> cams{};
    std::optional<std::int64_t> position{};
    std::vector<Job> jobs{}; // one after the other; empty: everything is there, or a hindrance
    // What the encoder is that replaces another; empty: the one that is there.
    std::optional<DeviceDescription> newEncoder{};
    int eepromWrites = 0;         // at most
    bool presetIsRearmed = false; // FRABA: the preset may have to be programmed again before it acts

    bool isWritten() const { return !hindrance && !jobs.empty(); }
};
using TransferPlan = std::vector<EncoderPlan>;

// Whether a bus in Watch keeps its encoders from being written, or whoever writes leaves Watch for it.
enum class InWatch : std::uint8_t { isHindrance, isLeft };

// Compares each wish with what is known of the encoder at its place. If one value of an encoder cannot be
// written, the encoder is not written at all. Sends nothing.
TransferPlan planTransfer(const Buses &buses, const std::vector<TransferWish> &wishes,
                          InWatch watch = InWatch::isHindrance);

int eepromWritesOf(const TransferPlan &plan); // at most

} // namespace codewheel
