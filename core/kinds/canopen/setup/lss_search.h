// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/lss_selection.h"
#include "kinds/canopen/setup/node_task.h"

namespace codewheel::canopen {

// Finds a device by LSS, reads who it is, and leaves it as it was: one without a number by a fast scan, or
// whoever is alone on the bus.
class LssSearch final : public NodeTask
{
public:
    explicit LssSearch(LssSelection::By by)
        : m_selection(by)
    {}

    std::optional<Request> next(const CanopenSnapshot &bus) override;
    using NodeTask::answered;
    void answered(const LssOutcome &outcome) override;
    bool isEnded() const override { return m_hasLeft; }
    void cancel() override { m_isCancelled = true; } // what runs ends when its request does

    const LssSelection &selection() const { return m_selection; }
    bool isCancelled() const { return m_isCancelled; }
    bool mayStayInConfiguration() const { return m_mayStay; }

private:
    bool isSearching() const { return !m_isCancelled && m_selection.next(); }

    LssSelection m_selection;
    bool m_isAsked = false;
    bool m_isLeaving = false;
    bool m_hasLeft = false;
    bool m_mayStay = false;
    bool m_isCancelled = false;
};

} // namespace codewheel::canopen
