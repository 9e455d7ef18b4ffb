// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/local_text.h"

#include <optional>
#include <vector>

namespace codewheel {

// The key on the label of a device, part by part, as the manual's ordering description gives it. Letters and
// digits count; spaces, dots and dashes are only for readability.
struct OrderingKey
{
    struct Code
    {
        QString code; // capital letters and digits; no code of a part is the beginning of another
        LocalText meaning;
        std::optional<int> turns; // if this part gives them
        std::optional<int> stepsPerTurn;

        friend bool operator==(const Code &, const Code &) = default;
    };

    struct Part
    {
        LocalText name;
        std::vector<Code> codes; // empty: any letters and digits, this many
        int any = 0;
        bool optional = false; // the last part only

        friend bool operator==(const Part &, const Part &) = default;
    };

    LocalText chapter;
    QString example; // as on a label
    std::vector<Part> parts;

    friend bool operator==(const OrderingKey &, const OrderingKey &) = default;
};

} // namespace codewheel
