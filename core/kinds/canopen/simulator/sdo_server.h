// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo.h"
#include "kinds/canopen/simulator/abort_code.h"

#include <array>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

namespace codewheel::canopen {

// What a server of SDO reads and writes.
class SdoObjects
{
public:
    virtual ~SdoObjects() = default;

    virtual tl::expected<std::vector<std::uint8_t>, AbortCode> read(SdoObject object) = 0;
    // With isSizeTold = false, there may be octets behind the value.
    virtual tl::expected<void, AbortCode> write(SdoObject object, Octets octets, bool isSizeTold) = 0;
};

// The side of a node in transfers of objects: in one frame or in segments, both ways. A new request ends a
// transfer that is under way.
class SdoServer
{
public:
    using Answer = std::array<std::uint8_t, 8>;

    // Empty: there is none.
    std::optional<Answer> answer(Octets request, SdoObjects &objects);
    void reset() { m_transfer.reset(); }

private:
    struct Transfer
    {
        SdoObject object{};
        bool isRead = false;
        std::vector<std::uint8_t> octets{}; // all of them, or those that have come
        std::size_t sent = 0;
        std::optional<std::uint32_t> size{}; // announced
        bool toggle = false;                 // of the next segment
    };

    Answer begin(const SdoFrame &request, SdoObjects &objects);
    Answer segment(const SdoFrame &request, SdoObjects &objects);
    Answer nextSegment();
    Answer takeSegment(const SdoFrame &request, SdoObjects &objects);
    Answer abort(SdoObject object, AbortCode code);

    std::optional<Transfer> m_transfer;
};

} // namespace codewheel::canopen
