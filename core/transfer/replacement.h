// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/transfer_wish.h"
#include "vocabulary/message.h"

namespace codewheel {

// The encoder that replaces another, as given on its label.
struct Replacement
{
    const DeviceDescription *device = nullptr; // must outlive this
    int turns = 0;                             // 0: not given
    int stepsPerTurn = 0;
    QString serialNumber; // empty: not given
};

// How the new encoder differs from the old one; what is not known of either is not compared.
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

// What the project has for the new encoder, by the names of the old one: what it wants, otherwise what was
// stored. `device`: the new one; null: not known.
ParameterValues settingsOfNew(const ProjectDevice &planned, const DeviceDescription *device);

// The values for the new encoder: what the project wants, otherwise what was stored of the old one. A FRABA's
// direction 3 and 4 become a Baumer's unsigned coding 3 and 4, and vice versa. If a position is to be set,
// the plan leaves the zero offset out, and says so (offsetLeftOut).
// Nothing that is known of the place is known of the new encoder (TransferWish::newEncoder).
TransferWish wishToReplace(const ProjectDevice &planned, const Replacement &now,
                           std::optional<std::int64_t> position, const ProjectPlaces &places);

// The project's device, before anything is written: make and label become those of the new one. Everything
// that wishToReplace writes to it is wanted of it from now on, so that it can be written again if the writing
// is interrupted, except an old zero offset when the position is set; what was stored of the old one is not
// known of the new one, and is removed.
ProjectDevice replaced(ProjectDevice planned, const Replacement &now, std::optional<std::int64_t> position);

// "encoderReplaced" for the message log.
Message encoderReplacedMessage(const ProjectDevice &before, const Replacement &now);

} // namespace codewheel
