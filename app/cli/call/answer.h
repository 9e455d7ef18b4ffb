// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/complaint.h"

#include <QJsonObject>

#include <optional>

namespace codewheel {

// What a command has to say: the same for people and for programs. With a complaint, text and json say how
// far it got.
struct Answer
{
    QString text{};
    QJsonObject json{};
    bool hasBegunJson = false; // its object has been printed so far, by a JsonList
    // What was done to encoders or files, if the text is no account of it, or of nothing else.
    QString done{};
    std::optional<Complaint> complaint{};
};

} // namespace codewheel
