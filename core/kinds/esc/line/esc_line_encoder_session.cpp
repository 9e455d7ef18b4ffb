// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_encoder_session.h"

#include "kinds/esc/line/esc_line_session.h"

namespace codewheel {

EscEncoderSession::EscEncoderSession(EscLineSession &line, std::size_t device, NodeId node,
                                     const DeviceDescription &description)
    : AskedEncoder(line, device, node, description)
    , m_line(line)
{}

Result<std::vector<Step>> EscEncoderSession::planned(const std::vector<Job> &jobs) const
{
    for (const Job &job : jobs)
        if (const auto checked = checkAddress(job); !checked)
            return tl::unexpected(checked.error());
    return AskedEncoder::planned(jobs);
}

// The driver checks it once more: by then another encoder may have come.
Result<void> EscEncoderSession::checkAddress(const Job &job) const
{
    const auto *write = std::get_if<WriteParameters>(&job);
    const auto wanted = write != nullptr ? valueOf(write->values, Parameter::lineAddress) : std::nullopt;
    if (!wanted)
        return {};
    if (auto taken =
            m_line.addressTaken({static_cast<std::uint8_t>(*wanted)}, EscLineAddress::of(place().node)))
        return tl::unexpected(*std::move(taken));
    return {};
}

int EscEncoderSession::fractionBits() const
{
    return m_line.fractionBits();
}

} // namespace codewheel
