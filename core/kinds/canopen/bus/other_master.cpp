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

// The heartbeat of node 0, which no device can be.
constexpr std::uint32_t heartbeatOfNone = 0x700;

std::optional<OtherMaster::Sign> signOf(const CanFrame &frame)
{
    using enum canopen::CobId::Service;
    if (!frame.isExtended && !frame.isError && frame.id == heartbeatOfNone)
        return frame.isRemote ? OtherMaster::Sign::guarding : OtherMaster::Sign::heartbeat;
    const auto cob = frame.isExtended || frame.isError ? std::nullopt : canopen::CobId::of(frame.id);
    if (!cob)
        return std::nullopt;
    if (frame.isRemote)
        return cob->service == errorControl ? std::optional(OtherMaster::Sign::guarding) : std::nullopt;
    switch (cob->service) {
    case nmt:
        return OtherMaster::Sign::commands;
    case sync:
        return OtherMaster::Sign::sync;
    case sdoRequest:
        return OtherMaster::Sign::requests;
    case lssRequest:
        return OtherMaster::Sign::configures;
    case canopen::CobId::Service::time:
        return OtherMaster::Sign::time;
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
    const std::array texts{QStringLiteral("NMT"),
                           QStringLiteral("SYNC"),
                           OtherMasterText::tr("SDO requests"),
                           OtherMasterText::tr("guarding"),
                           QStringLiteral("LSS"),
                           QStringLiteral("TIME"),
                           OtherMasterText::tr("heartbeat of a master")};
    const auto *signs = std::get_if<std::int64_t>(&argument);
    QStringList heard;
    for (std::size_t i = 0; signs != nullptr && i < texts.size(); ++i)
        if ((*signs >> i & 1) != 0)
            heard << texts[i];
    return heard.join(QStringLiteral(", "));
}

} // namespace codewheel
