// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "transfer/transfer_plan.h"

namespace codewheel {

class Buses;
class ProjectPlaces;

// One line of the table of a transfer: an encoder, or below it a value, a cam program, or a sentence.
struct TransferLine
{
    enum class Kind : std::uint8_t { encoder, value, note };

    Kind kind = Kind::encoder;
    Place place;
    QString what{}; // of an encoder: its name and station
    QString now{};  // with its evidence
    QString wanted{};
    QString sent{};   // its word, or its request
    QString eeprom{}; // writes at most
    QString tip{};    // what the line says in a sentence
    bool canBeChosen = false;
    bool isThere = false; // left out
    bool isHindered = false;

    friend bool operator==(const TransferLine &, const TransferLine &) = default;
};

std::vector<TransferLine> linesOf(const Buses &buses, const TransferPlan &plan);
// What would be read, and what the project has stored so far.
std::vector<TransferLine> linesToStore(const Buses &buses, const ProjectPlaces &places,
                                       const std::vector<ProjectDevice> &devices, bool withCams);

} // namespace codewheel
