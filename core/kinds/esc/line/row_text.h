// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "kinds/esc/protocol/esc_exchange.h"
#include "kinds/esc/protocol/esc_explain.h"

#include <array>
#include <memory>

namespace codewheel {

// What passed on a serial line, as text: for terminals, traces and exports.

inline constexpr std::array lineTrafficColumns{TrafficColumn::time, TrafficColumn::direction,
                                               TrafficColumn::meaning, TrafficColumn::text,
                                               TrafficColumn::bytes};

// What the program asks an encoder automatically: position, warnings, alarms, and its identity.
bool isAutomatic(esc::Command command);

// The answer in these bytes to such a request.
std::optional<esc::Answer> answerIn(const QByteArray &bytes, esc::Command command);

// What passed on a line, with the request it belongs to.
struct PassedRow
{
    esc::EscLineRow row;
    std::optional<esc::Request> request; // that was sent, or was the last one sent before this came in

    // Part of a position request, and nothing is wrong with it: the polling.
    bool isPoll() const { return isAutomatic() && request->command == esc::Command::position; }
    // Part of anything the program may have asked automatically, and nothing is wrong with it.
    bool isAutomatic() const;
};

// The request of each row, as rows come one after the other.
PassedRow passedRow(const esc::EscLineRow &row, std::optional<esc::Request> &lastRequest);

// One row in words.
QString rowMeaning(const PassedRow &passed, const esc::ExplainOptions &options);

// Makes the rows of a line, one after the other.
class EscLineTraffic
{
public:
    explicit EscLineTraffic(const esc::ExplainOptions &options = {})
        : m_options(std::make_shared<esc::ExplainOptions>(options))
    {}

    // Applies to rows already made, too.
    void setExplainOptions(const esc::ExplainOptions &options) { *m_options = options; }
    TrafficRow row(const esc::EscLineRow &what);

private:
    std::shared_ptr<esc::ExplainOptions> m_options; // rows outlive the session
    std::optional<esc::Request> m_lastRequest;
};

} // namespace codewheel
