// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recorded_channel.h"
#include "recording/recorded_key.h"

namespace codewheel {

class RecordingArchive;

// A channel of a recording as a History, with the shift of its archive. What cannot be read is not there; the
// archive tells why. Keeps what it read of the span that was last looked at.
class RecordedHistory final : public History
{
public:
    RecordedHistory(RecordedChannel channel, const RecordedKey &key, const RecordingArchive &archive)
        : m_channel(std::move(channel))
        , m_key(key)
        , m_archive(archive)
    {}

    std::optional<TimeSpan> span() const override;
    std::optional<Sample> newest() const override;
    std::optional<Sample> at(Instant at) const override;
    std::optional<Sample> after(Instant at) const override;
    std::size_t count(const TimeSpan &span) const override;
    std::optional<Extent> extent(const TimeSpan &span) const override;
    Columns columns(const TimeSpan &span, std::size_t count) const override;
    std::optional<Statistics> statistics(const TimeSpan &span) const override;
    std::vector<Gap> gaps(const TimeSpan &span) const override;
    void forEach(const TimeSpan &span, const With &with) const override;

private:
    const RecordedChannel::Look &look(const TimeSpan &span, std::size_t count) const;
    TimeSpan recorded(const TimeSpan &span) const; // as it is in the file
    Instant recorded(Instant at) const;
    Sample shown(const Sample &sample) const;
    template <class What>
    What valueOr(Result<What> result, What other) const;

    mutable RecordedChannel m_channel; // notes what is damaged
    RecordedKey m_key;
    const RecordingArchive &m_archive;
    mutable TimeSpan m_seen{};
    mutable std::size_t m_seenColumns = 0; // 0: none
    mutable RecordedChannel::Look m_look;
};

} // namespace codewheel
