// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/other_master.h"

#include "kinds/canopen/protocol/cob_id.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>

namespace codewheel {
namespace {

// The translation context of these texts.
struct OtherMasterText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::OtherMaster)
};

std::optional<OtherMaster::Sign> signOf(const CanFrame &frame)
{
    using Service = canopen::CobId::Service;
    const auto cob = frame.isExtended || frame.isError ? std::nullopt : canopen::CobId::of(frame.id);
    if (!cob)
        return std::nullopt;
    if (frame.isRemote)
        return cob->service == Service::errorControl ? std::optional(OtherMaster::Sign::guarding)
                                                     : std::nullopt;
    switch (cob->service) {
    case Service::nmt:
        return OtherMaster::Sign::commands;
    case Service::sync:
        return OtherMaster::Sign::sync;
    case Service::sdoRequest:
        return OtherMaster::Sign::requests;
    case Service::lssRequest:
        return OtherMaster::Sign::configures;
    default:
        return std::nullopt;
    }
}

} // namespace

bool OtherMaster::take(const CanFrame &frame)
{
    const auto sign = signOf(frame);
    if (!sign || isHeard(*sign))
        return false;
    m_signs |= 1U << static_cast<unsigned>(*sign);
    return true;
}

QString OtherMaster::textOf(const RefusalArgument &argument)
{
    const std::array texts{QStringLiteral("NMT"), QStringLiteral("SYNC"), OtherMasterText::tr("SDO requests"),
                           OtherMasterText::tr("guarding"), QStringLiteral("LSS")};
    const auto *signs = std::get_if<std::int64_t>(&argument);
    QStringList heard;
    for (std::size_t i = 0; signs != nullptr && i < texts.size(); ++i)
        if ((*signs >> i & 1) != 0)
            heard << texts[i];
    return heard.join(QStringLiteral(", "));
}

} // namespace codewheel
