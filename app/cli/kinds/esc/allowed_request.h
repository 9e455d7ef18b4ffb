// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/encoder/eeprom_consent.h"
#include "kinds/esc/protocol/esc_request.h"

namespace codewheel {

using Encoders = std::vector<const EncoderSession *>;

// A typed request that may be sent as far as the EEPROM of its encoder is concerned, like AllowedJob.
class AllowedRequest
{
public:
    // Empty if it writes: that needs consent.
    static std::optional<AllowedRequest> reading(const esc::Request &request)
    {
        if (esc::shapeOf(request.command).writes)
            return std::nullopt;
        return AllowedRequest(request);
    }

    const esc::Request &request() const { return m_request; }

private:
    friend Checked<AllowedRequest> requestConsent(const Call &call, const Encoders &encoders,
                                                  const esc::Request &request);
    explicit AllowedRequest(const esc::Request &request)
        : m_request(request)
    {}

    esc::Request m_request;
};

// For one that writes, which has been agreed to; it counts as one write for each of these encoders.
inline Checked<AllowedRequest> requestConsent(const Call &call, const Encoders &encoders,
                                              const esc::Request &request)
{
    constexpr int oneWrite = 1;
    for (const EncoderSession *encoder : encoders)
        if (const auto may = eepromConsent(call, *encoder, oneWrite, AsksAnyway::yes); !may)
            return tl::unexpected(may.error());
    return AllowedRequest(request);
}

} // namespace codewheel
