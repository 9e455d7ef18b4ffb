// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/port_finder.h"
#include "links/serial_port_link.h"

namespace codewheel {

// Looks for whoever is on the line of a serial port of this computer. Opens it with its first step.
class PortSearch final : public PlaceFinder
{
public:
    // A name as in the list of ports, or a path.
    PortSearch(const QString &port, bool mayAsk)
        : m_link(port)
        , m_finder(m_link, mayAsk)
    {}

    bool isDone() const override { return m_finder.isDone(); }
    FinderNews next() override { return m_finder.next(); }
    void interrupt() override { m_finder.interrupt(); }
    // Nothing came while it listened: asking may find out more.
    bool isSilent() const { return m_finder.isSilent(); }

private:
    SerialPortLink m_link;
    PortFinder m_finder;
};

} // namespace codewheel
