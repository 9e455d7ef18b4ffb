// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"

#include <QPointer>

#include <memory>

namespace codewheel {

// The encoder shown by parameter panel, cam editor and device panel: connected, with its session; or as the
// project plans it, while nothing is connected at its place. Wanted values can be edited either way; only a
// session can send.
class ShownEncoder
{
public:
    ShownEncoder() = default; // none is chosen
    // Connected: its session knows all there is to know. Null: none.
    ShownEncoder(EncoderSession *session)
        : m_session(session)
    {}
    ShownEncoder(Place number, const DeviceDescription &planned)
        : m_place(number)
        , m_planned(std::make_shared<const DeviceDescription>(planned))
    {}

    bool isThere() const { return m_session || m_planned; }
    EncoderSession *session() const { return m_session; } // null: not connected
    // Of one that is there:
    Place place() const { return m_session ? m_session->place() : m_place; }
    const DeviceDescription &device() const { return m_session ? m_session->device() : *m_planned; }
    const Capabilities &can() const { return m_session ? m_session->can() : m_planned->capabilities; }
    std::optional<Known> known(Parameter parameter) const
    {
        return m_session ? m_session->known(parameter) : std::nullopt;
    }

    friend bool operator==(const ShownEncoder &left, const ShownEncoder &right)
    {
        const bool arePlanned = left.m_planned && right.m_planned;
        return left.m_session == right.m_session && left.m_place == right.m_place &&
               (arePlanned ? *left.m_planned == *right.m_planned : left.m_planned == right.m_planned);
    }

private:
    QPointer<EncoderSession> m_session;
    Place m_place;
    std::shared_ptr<const DeviceDescription> m_planned; // null: connected, or none
};

// A chosen encoder, in a line: "1.0  Hoist  FRABA OCD-IB K3".
inline QString calledInFull(Place place, const QString &station, const DeviceDescription &device)
{
    QStringList parts{place.shown(), station, device.fullName()};
    parts.removeAll(QString());
    return parts.join(QStringLiteral("  "));
}

} // namespace codewheel
