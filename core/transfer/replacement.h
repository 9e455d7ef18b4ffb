// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"
#include "transfer/transfer_wish.h"

namespace codewheel {

// The encoder that takes the place of another, as its label tells.
struct Replacement
{
    const DeviceDescription *device = nullptr; // outlives this
    int turns = 0;                             // 0: not told
    int stepsPerTurn = 0;
    QString serialNumber; // empty: not told
};

// How the new encoder differs from the one before; what is not told of either is not compared.
struct ReplacementDifferences
{
    QString makeBefore{};                              // empty: the same make, or not known before
    std::optional<std::pair<int, int>> stepsPerTurn{}; // before, now
    std::optional<std::pair<int, int>> turns{};
    ParameterValues notTaken{}; // of the values for it: the new make has no such parameter
    bool camsNotTaken = false;

    bool areNone() const
    {
        return makeBefore.isEmpty() && !stepsPerTurn && !turns && notTaken.empty() && !camsNotTaken;
    }
};

// `before` is the description of the planned device; null: not known.
ReplacementDifferences differencesOf(const ProjectDevice &planned, const DeviceDescription *before,
                                     const Replacement &now);

// The values for the new encoder: what the project wants, else what was stored of the one before. A FRABA's
// direction 3 and 4 is a Baumer's unsigned coding 3 and 4, and the other way round. With a position to be
// set, the zero offset stays behind: it belongs to the encoder before, and setting the position makes it.
TransferWish wishToReplace(const ProjectDevice &planned, const Replacement &now,
                           std::optional<std::int64_t> position, const ProjectPlaces &places);

// The project's device, before anything is written: make and label are those of the new one. All that
// wishToReplace writes to it is wanted of it from now on, so that it can be written again when the writing
// breaks off, and an old zero offset is not when the position is set; what was stored of the one before is
// not known of the new one, and goes.
ProjectDevice replaced(ProjectDevice planned, const Replacement &now, std::optional<std::int64_t> position);

// "encoderReplaced" for the message log.
Message encoderReplacedMessage(const ProjectDevice &before, const Replacement &now);

} // namespace codewheel
