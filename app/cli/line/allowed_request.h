// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/eeprom_consent.h"
#include "esc/esc_request.h"

namespace codewheel {

// A typed request that may be sent as far as the EEPROM of its encoder is concerned: as AllowedJob.
class AllowedRequest
{
public:
    // Nothing where it writes: that is asked for.
    static std::optional<AllowedRequest> reading(const esc::Request &request)
    {
        if (esc::shapeOf(request.command).writes)
            return std::nullopt;
        return AllowedRequest(request);
    }

    const esc::Request &request() const { return m_request; }

private:
    friend Checked<AllowedRequest> requestConsent(const Call &call, const EncoderSession *encoder,
                                                  const esc::Request &request);
    explicit AllowedRequest(const esc::Request &request)
        : m_request(request)
    {}

    esc::Request m_request;
};

// Of one that writes, which has been agreed to; each counts as one write. `encoder`: null where it is not
// known whose EEPROM it is.
inline Checked<AllowedRequest> requestConsent(const Call &call, const EncoderSession *encoder,
                                              const esc::Request &request)
{
    constexpr int oneWrite = 1;
    const auto may =
        encoder != nullptr ? eepromConsent(call, *encoder, oneWrite, AsksAnyway::yes) : Checked<void>();
    return may.map([&] { return AllowedRequest(request); });
}

} // namespace codewheel
