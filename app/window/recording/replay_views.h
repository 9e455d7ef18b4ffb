// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_views.h"

namespace codewheel {

class ReplayAtWork;
class ReplayBar;

// What a recording adds to the window: the bar that plays it, while one of its buses is chosen.
class ReplayViews final : public BusViews
{
    Q_OBJECT

public:
    ReplayViews(ReplayAtWork &bus, const WindowParts &parts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override { return {}; }
    QWidget *comparison() const override { return nullptr; }
    QMenu *menu() const override;
    void setChosen(std::optional<Place> place) override;
    void open() override;

private:
    void showCurrent() override;
    void tell(const Message &message);

    ReplayAtWork &m_bus;
    const WindowParts m_parts;
    ReplayBar *m_bar;
    QMenu *m_menu;
};

} // namespace codewheel
