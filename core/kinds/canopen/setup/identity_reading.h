// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/node_identity.h"
#include "kinds/canopen/setup/node_task.h"

namespace codewheel::canopen {

// Reads the identity of a node (1018h:1 to 4), by which LSS selects it.
class IdentityReading final : public NodeTask
{
public:
    enum class Result : std::uint8_t {
        read,
        noAnswer,
        notTold, // it lacks some of it
        notSent,
    };

    explicit IdentityReading(int node)
        : m_node(node)
    {}

    std::optional<SdoRequest> next() const; // empty: it has ended
    std::optional<Request> next(const CanopenSnapshot &) override
    {
        const auto request = next();
        return request ? std::optional<Request>(*request) : std::nullopt;
    }
    using NodeTask::answered;
    void answered(const SdoOutcome &outcome) override;
    bool isEnded() const override { return m_result.has_value(); }
    void cancel() override { m_result = Result::notSent; }

    int node() const { return m_node; }
    const std::optional<Result> &result() const { return m_result; } // empty: it goes on
    const NodeIdentity &identity() const { return m_identity; }      // once it is read

private:
    int m_node;
    std::uint8_t m_sub = 1;
    NodeIdentity m_identity{};
    std::optional<Result> m_result{};
};

} // namespace codewheel::canopen
