// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/setups_under_way.h"

#include "widgets/kinds/canopen/setup/node_setup_view.h"

namespace codewheel {

void SetupsUnderWay::add(NodeSetupView &view)
{
    std::erase(m_views, nullptr);
    m_views.emplace_back(&view);
}

NodeSetupView *SetupsUnderWay::busy() const
{
    for (const auto &view : m_views)
        if (view && view->atStake())
            return view;
    return nullptr;
}

std::optional<WorkUnderWay> SetupsUnderWay::now() const
{
    const NodeSetupView *view = busy();
    if (view == nullptr)
        return std::nullopt;
    const auto atStake = view->atStake();
    return WorkUnderWay{atStake->what, atStake->consequence};
}

void SetupsUnderWay::breakOff(const std::function<void(bool isSettled)> &then)
{
    NodeSetupView *view = busy();
    if (view == nullptr) {
        then(true);
        return;
    }
    auto *waits = new QObject(view);
    connect(view, &NodeSetupView::changed, waits, [view, waits, then] {
        if (view->isBusy())
            return;
        waits->deleteLater();
        waits->disconnect();
        QObject::disconnect(view, nullptr, waits, nullptr);
        then(view->isSettled());
    });
    view->breakOff();
}

} // namespace codewheel
