// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_command.h"
#include "kinds/esc/protocol/esc_line_address.h"

#include <QByteArray>

namespace codewheel::esc {

struct Request
{
    EscLineAddress to; // 0: the master address
    Command command = Command::position;
    std::uint32_t data = 0; // of a write; within the digits of the command

    // What is between ESC and CR LF: "03GP00005200".
    QByteArray text() const;
    // As sent: ESC, text, CR LF.
    QByteArray bytes() const;

    friend bool operator==(const Request &, const Request &) = default;
};

// As typed by a user ("05P", "03gp5200"): data may be shorter than the command's digits. Empty for anything
// else.
std::optional<Request> parseRequest(QByteArrayView text);

} // namespace codewheel::esc
