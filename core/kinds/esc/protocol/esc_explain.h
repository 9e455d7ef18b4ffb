// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_answer.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/protocol/esc_request.h"
#include "kinds/esc/protocol/esc_scaling.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <set>

namespace codewheel::esc {

// What the manual leaves open and a setting of the device decides.
struct ExplainOptions
{
    bool swapWarningBytes = false;          // of all devices
    int fractionBits = defaultFractionBits; // of the scaling factor
    std::set<EscLineAddress> swapping{};    // the devices whose warning bytes are swapped

    bool swaps(EscLineAddress device) const { return swapWarningBytes || swapping.contains(device); }
};

// One line of the protocol in words, translated, values hexadecimal and decimal. Used by the terminal and by
// `explain`.

// "05: position?", "03: preset := 5200h = 20992"
QString requestText(const Request &request, const ExplainOptions &options = {});
// With what was typed: "03: preset := 5200h = 20992 (03GP00005200)". Its text and the fraction bits are what
// messages store.
std::vector<RefusalArgument> typedArguments(const Request &request, const ExplainOptions &options);
QString typedText(const std::vector<RefusalArgument> &arguments);
// "1235h = 4661", "4000h: battery flat", "accepted", "command unknown (03)"
QString answerText(const Request &request, const Answer &answer, const ExplainOptions &options = {});
// The digits of a bit field as sent, which are always shown: "4000h", "0098h, bytes swapped 9800h".
QString bitDigits(std::uint16_t asSent, bool isSwapped);
// "05: position? -> 1235h = 4661"
QString exchangeText(const Request &request, const Answer &answer, const ExplainOptions &options = {});

// The name of what a command reads or writes: "position", "upper limit switch".
QString commandName(Command command);

} // namespace codewheel::esc
