// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/recorded_device.h"
#include "recording/recording_reader.h"

#include <array>

namespace codewheel {

// One device of a recording, at any moment of it. Used by Playback and ReplayBus. What cannot be read is not
// known; problem() says why.
class RecordedEncoder
{
public:
    // What stood at a moment, channel by channel; nothing: it is not recorded.
    struct Moment
    {
        std::array<std::optional<std::int64_t>, channelCount> values{};

        const std::optional<std::int64_t> &of(Channel channel) const
        {
            return values[static_cast<std::size_t>(channel)];
        }
        bool isKnown() const;
        friend bool operator==(const Moment &, const Moment &) = default;
    };
    // What is in force from a time on.
    struct Described
    {
        Instant since{};
        RecordedDevice device;
    };

    static Result<RecordedEncoder> make(const RecordingReader &reader, const RecordingReader::Device &device);

    Place place() const { return m_device.place; } // in the recording
    bool has(Channel channel) const { return m_channels[static_cast<std::size_t>(channel)].has_value(); }
    bool hasWords() const { return has(Channel::in) || has(Channel::out); }
    std::optional<TimeSpan> span() const; // of all its channels

    Moment at(Instant at);
    // Of the description in force then; before the first one, of that. Null: there is none.
    const Described *describedAt(Instant at) const;
    const std::vector<Described> &described() const { return m_described; } // oldest first
    // The bits of a word that changed in any cycle between two times.
    Word changedBits(Channel channel, Instant from, Instant to);
    // Of the nearest sample behind that time, or before it.
    std::optional<Instant> next(Instant at);
    std::optional<Instant> previous(Instant at);

    const std::optional<Refusal> &problem() const { return m_problem; }

private:
    explicit RecordedEncoder(RecordingReader::Device device)
        : m_device(std::move(device))
    {}
    template <class Value>
    std::optional<Value> take(const Result<std::optional<Value>> &read);

    RecordingReader::Device m_device;
    std::array<std::optional<RecordedChannel>, channelCount> m_channels;
    std::vector<Described> m_described;
    std::optional<Refusal> m_problem;
};

} // namespace codewheel
