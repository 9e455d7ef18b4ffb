// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_permission.h"

namespace codewheel {
namespace {

tl::unexpected<Refusal> notNow(RefusalCode why, const QString &place)
{
    return refuse(RefusalKind::busy, why, {place});
}

tl::unexpected<Refusal> portLost(const QString &link)
{
    return refuse(RefusalKind::link, RefusalId::portLost, {link});
}

} // namespace

Result<void> mayStart(const LineState &line, const Job &job, const QString &place, const QString &link)
{
    if (!line.connected)
        return portLost(link);
    if (!line.running)
        return notNow(RefusalId::notRunning, place);
    if (!line.operate && !std::holds_alternative<ReadParameters>(job))
        return notNow(RefusalId::watchOnly, place);
    return {};
}

Result<void> maySend(const LineState &line, const esc::Request &request, const QString &link)
{
    if (!line.connected)
        return portLost(link);
    if (!line.operate && esc::shapeOf(request.command).writes)
        return notNow(RefusalId::watchOnly, request.to.node().toString());
    return {};
}

} // namespace codewheel
