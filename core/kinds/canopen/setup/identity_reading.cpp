// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/setup/identity_reading.h"

namespace codewheel::canopen {

std::optional<SdoRequest> IdentityReading::next() const
{
    constexpr std::uint16_t identityObject = 0x1018;
    if (m_result)
        return std::nullopt;
    return SdoRequest{.node = m_node, .object = {identityObject, m_sub}};
}

void IdentityReading::answered(const SdoOutcome &outcome)
{
    if (m_result)
        return;
    switch (outcome.kind) {
    case SdoOutcome::Kind::read:
        m_identity.words.at(m_sub - 1U) = numberOf(outcome.value);
        if (m_sub++ == NodeIdentity::size)
            m_result = Result::read;
        break;
    case SdoOutcome::Kind::noAnswer:
        m_result = Result::noAnswer;
        break;
    case SdoOutcome::Kind::notSent:
        m_result = Result::notSent;
        break;
    default:
        m_result = Result::notTold;
        break;
    }
}

} // namespace codewheel::canopen
