// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/kept_adapter.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace codewheel {
std::optional<PortInfo> portAt(const QString &path, const std::vector<PortInfo> &present)
{
    const QString canonical = QFileInfo(path).canonicalFilePath();
    const auto found = std::ranges::find_if(
        present, [&](const PortInfo &port) { return port.path == path || port.path == canonical; });
    return found == present.end() ? std::nullopt : std::optional(*found);
}

KeptAdapter::KeptAdapter(QString path)
    : m_path(std::move(path))
{}

KeptAdapter::KeptAdapter(PortInfo adapter)
    : m_path(adapter.path)
    , m_adapter(std::move(adapter))
{}

Result<QString> KeptAdapter::find(const std::vector<PortInfo> &present)
{
    const std::optional<PortInfo> there = portAt(m_path, present);
    if (!m_adapter)
        m_adapter = there;
    if (!m_adapter)
        return m_path;
    const AdapterMatch match = sameAdapter(*m_adapter, present);
    if (match.kind == AdapterMatch::Kind::ask)
        return other(match.ports.front());
    if (match.kind == AdapterMatch::Kind::absent && there)
        return other(*there);
    m_other.reset();
    if (match.kind == AdapterMatch::Kind::absent)
        return refuse(RefusalKind::link, RefusalId::portNotFound, {m_path});
    m_adapter = match.ports.front();
    if (there != m_adapter) // otherwise the path as it was given
        m_path = m_adapter->path;
    return m_path;
}

tl::unexpected<Refusal> KeptAdapter::other(const PortInfo &there)
{
    m_other = there;
    return refuse(RefusalKind::link, RefusalId::portOfOther, {there.label(), m_adapter->label()});
}

void KeptAdapter::takeOther()
{
    if (!m_other)
        return;
    m_adapter = std::exchange(m_other, std::nullopt);
    m_path = m_adapter->path;
}

} // namespace codewheel
