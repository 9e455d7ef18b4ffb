// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"

#include <utility>

namespace codewheel {

// The test of a link (GatewayCheck, EscLineCheck) as work in the background: its findings are handed over one
// by one.
template <class Check, class Link>
class LinkTest final : public BackgroundSteps::Work
{
public:
    using Finding = decltype(std::declval<Check &>().next());
    using Take = std::function<void(const Finding &)>;

    // `rest`: what the check wants besides its link.
    template <class... Rest>
    LinkTest(std::unique_ptr<Link> link, Take take, Rest &&...rest)
        : m_link(std::move(link))
        , m_check(*m_link, std::forward<Rest>(rest)...)
        , m_take(std::move(take))
    {}

    BackgroundSteps::Taken step() override
    {
        if (m_check.isDone())
            return {};
        return [take = m_take, finding = m_check.next()] { take(finding); };
    }
    void interrupt() override { m_check.interrupt(); }

private:
    const std::unique_ptr<Link> m_link;
    Check m_check;
    const Take m_take;
};

} // namespace codewheel
