// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_outline.h"

namespace codewheel {

class CanopenSession;

extern const AskedOutlineWords canopenOutlineWords;

// A CAN bus with CANopen, and its encoders in the order of their numbers.
class CanopenOutline final : public AskedOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenOutline)

public:
    explicit CanopenOutline(const CanopenSession &bus); // must outlive it

    using AskedOutline::toolTip;
    QString toolTip() const override;
    QString alarmStop() const override;
    using AskedOutline::state;
    StateWord state() const override;
    std::vector<Fault> faults() const override;

private:
    StateWord shown(Place place) const override;

    const CanopenSession &m_bus;
};

} // namespace codewheel
