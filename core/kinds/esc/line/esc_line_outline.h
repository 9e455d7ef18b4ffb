// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_outline.h"

namespace codewheel {

class EscLineSession;

extern const AskedOutlineWords lineOutlineWords;

// A serial line, and its encoders in the order of their addresses.
class EscLineOutline final : public AskedOutline
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EscLineOutline)

public:
    explicit EscLineOutline(const EscLineSession &line); // must outlive it

    QString toolTip() const override;
    QString alarmStop() const override;
    using AskedOutline::state;
    StateWord state() const override;
    std::vector<Fault> faults() const override;
    QString toolTip(std::size_t node, const QString &called) const override;

private:
    StateWord shown(Place place) const override;

    const EscLineSession &m_line;
};

} // namespace codewheel
