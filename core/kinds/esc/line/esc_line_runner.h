// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asking_runner.h"
#include "kinds/esc/line/esc_line_command.h"
#include "kinds/esc/line/esc_line_event.h"
#include "kinds/esc/line/esc_line_snapshot.h"
#include "serial/byte_link.h"

namespace codewheel {

// Owns the line: one request at a time. What was typed goes first, then a scan, then the devices in turn: of
// those that want something, the one that has waited longest.
//
// It begins in Watch, where only reads are sent, and without polling. A port that is
// gone is opened again at the same adapter, and at no other unasked.
class EscLineRunner final : public AskingRunner<EscLineCommand, EscLineEvent, EscLineSnapshot>
{
public:
    EscLineRunner(ByteLink &link, const SerialSettings &settings, const esc::Timing &timing);
};

} // namespace codewheel
