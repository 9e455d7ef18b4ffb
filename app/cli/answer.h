// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/complaint.h"

#include <QJsonObject>

#include <optional>

namespace codewheel {

// What a command has to say: the same for people and for programs. With a complaint, text and json tell how
// far it came.
struct Answer
{
    QString text{};
    QJsonObject json{};
    // What was done to encoders or files, where the text is no account of it, or nothing else.
    QString done{};
    std::optional<Complaint> complaint{};
};

} // namespace codewheel
