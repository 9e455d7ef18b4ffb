// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "esc/esc_exchange.h"
#include "esc/esc_explain.h"

#include <array>
#include <memory>

namespace codewheel {

// What passed on a serial line, in text: for terminals, traces and exports.

inline constexpr std::array lineTrafficColumns{TrafficColumn::time, TrafficColumn::direction,
                                               TrafficColumn::meaning, TrafficColumn::text,
                                               TrafficColumn::bytes};

// What the program asks an encoder without having been told to: position, warnings, alarms, and who it is.
bool isAutomatic(esc::Command command);

// The answer that these bytes are to such a request.
std::optional<esc::Answer> answerIn(const QByteArray &bytes, esc::Command command);

// What passed on a line, with the request it belongs to.
struct PassedRow
{
    esc::LineRow row;
    std::optional<esc::Request> request; // that was sent, or that was sent before what came in

    // Of a position request, and nothing is wrong with it: the polling.
    bool isPoll() const;
    // Of whatever the program may have asked by itself, and nothing is wrong with it.
    bool isAutomatic() const;
};

// The request of each row, as rows come one after the other.
PassedRow passedRow(const esc::LineRow &row, std::optional<esc::Request> &lastRequest);

// One row in words.
QString rowMeaning(const PassedRow &passed, const esc::ExplainOptions &options);

// Makes the rows of a line, one after the other.
class LineTraffic
{
public:
    explicit LineTraffic(const esc::ExplainOptions &options = {})
        : m_options(std::make_shared<esc::ExplainOptions>(options))
    {}

    // Of the rows made already, too.
    void setExplainOptions(const esc::ExplainOptions &options) { *m_options = options; }
    TrafficRow row(const esc::LineRow &what);

private:
    std::shared_ptr<esc::ExplainOptions> m_options; // rows outlive the session
    std::optional<esc::Request> m_lastRequest;
};

} // namespace codewheel
