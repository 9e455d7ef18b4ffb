// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/work_under_way.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <optional>
#include <vector>

namespace codewheel {

class NodeSetupView;

// Whatever of the window gives devices of a CAN bus number and rate, for the question before the bus is left.
class SetupsUnderWay final : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    void add(NodeSetupView &view); // may go before this
    std::optional<WorkUnderWay> now() const;
    // `then` gets whether nothing of it is in doubt; at once where nothing is under way.
    void breakOff(const std::function<void(bool isSettled)> &then);

private:
    NodeSetupView *busy() const; // null: none is

    std::vector<QPointer<NodeSetupView>> m_views;
};

} // namespace codewheel
