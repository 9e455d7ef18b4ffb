// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_controls.h"

#include <algorithm>

namespace codewheel {

// A running fault plan: knows which step is due in which cycle of 1 ms. Used by SimulatedRing.
class FaultPlanRun
{
public:
    void start(const FaultPlan &plan)
    {
        m_plan = std::make_shared<const FaultPlan>(plan);
        m_next = 0;
        m_elapsed = -1; // the next cycle is at 0
        m_isRunning = true;
    }
    void stop() { m_isRunning = false; }
    bool isRunning() const { return m_isRunning; }

    // To be called once per cycle, then due() until it returns null.
    void passCycle() { ++m_elapsed; }
    const FaultStep *due()
    {
        if (m_plan->steps[m_next].at.count() > m_elapsed)
            return nullptr;
        const FaultStep *step = &m_plan->steps[m_next++];
        m_isRunning = m_next < m_plan->steps.size();
        return step;
    }

    TrainingControls::PlanProgress progress() const
    {
        return {m_plan, m_next, std::chrono::milliseconds(std::max<std::int64_t>(m_elapsed, 0)), m_isRunning};
    }

private:
    std::shared_ptr<const FaultPlan> m_plan;
    std::size_t m_next = 0;
    std::int64_t m_elapsed = 0; // ms
    bool m_isRunning = false;
};

} // namespace codewheel
