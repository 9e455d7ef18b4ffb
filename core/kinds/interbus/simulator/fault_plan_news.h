// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_controls.h"

#include <utility>

namespace codewheel {

// Which steps of a ring's fault plan have been carried out since it was last asked.
class FaultPlanNews
{
public:
    std::vector<FaultStep> take(const TrainingControls::PlanProgress &progress)
    {
        if (std::exchange(m_plan, progress.plan) != progress.plan)
            m_told = 0;
        std::vector<FaultStep> steps;
        for (; m_plan && m_told < progress.next; ++m_told)
            steps.push_back(m_plan->steps[m_told]);
        return steps;
    }

private:
    std::shared_ptr<const FaultPlan> m_plan; // whose steps were told
    std::size_t m_told = 0;
};

} // namespace codewheel
