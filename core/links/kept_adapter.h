// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/serial_ports.h"
#include "vocabulary/refusal.h"

#include <optional>

namespace codewheel {

// The port at this path, which may be a link to it, like those in /dev/serial/by-id.
std::optional<PortInfo> portAt(const QString &path, const std::vector<PortInfo> &present);

// Which adapter a line is connected by, and where it is after it was plugged in again: by its serial number,
// otherwise by its place on USB. No other adapter is taken for it unasked. No I/O: the present ports are an
// argument. Used by SerialPortLink.
class KeptAdapter
{
public:
    // Whichever adapter is at this path when it is first looked for; a path without one, such as that of a
    // pseudo terminal, is used as it is.
    explicit KeptAdapter(QString path);
    // This one; its `path` is where it was last.
    explicit KeptAdapter(PortInfo adapter);

    const QString &path() const { return m_path; }
    // Empty until one was found at the path.
    const std::optional<PortInfo> &adapter() const { return m_adapter; }

    // Where the adapter is now. Refused: portNotFound; portOfOther if a different one is at its path, or one
    // that may be it, which takeOther() makes the right one.
    Result<QString> find(const std::vector<PortInfo> &present);
    void takeOther();

private:
    tl::unexpected<Refusal> other(const PortInfo &there);

    QString m_path;
    std::optional<PortInfo> m_adapter;
    std::optional<PortInfo> m_other; // that was refused
};

} // namespace codewheel
