// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/encoder_history.h"
#include "vocabulary/place.h"

namespace codewheel {

// One curve of a trend: what is shown of which encoder, in any session and in any program.
struct Track
{
    Place place{};
    Channel channel = Channel::position;
    std::optional<unsigned> bit{}; // only of channels that have any (bitCount())

    // As kept in settings and typed at the command line: "1.0/position", "1.0/in.25", "esc:05/speed",
    // "4/esc:05/speed".
    QString key() const;
    static std::optional<Track> parse(QStringView text); // nothing: it is none
    // What it shows where its channel has this sample: the sample itself, or 0 or 1.
    std::int64_t of(std::int64_t sample) const { return bit ? (sample >> *bit) & 1 : sample; }

    friend bool operator==(const Track &, const Track &) = default;
    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    friend std::strong_ordering operator<=>(const Track &,
                                            const Track &) = default; // NOLINT(modernize-use-nullptr)
};

QLatin1String channelKey(Channel channel); // "position", the same in every language
std::optional<Channel> channelFromKey(QStringView key);
unsigned bitCount(Channel channel); // how many it has; 0: it is no word, but a number

// What positions are measured in; speeds in the same, per second, and turns per minute.
enum class TrackUnit : std::uint8_t { steps, turns, degrees, millimetres };
inline constexpr std::array trackUnits{TrackUnit::steps, TrackUnit::turns, TrackUnit::degrees,
                                       TrackUnit::millimetres};

QLatin1String unitKey(TrackUnit unit); // "steps", the same in every language
std::optional<TrackUnit> trackUnit(QStringView key);

// How much of a unit a step is.
struct TrackScale
{
    struct Earlier
    {
        Instant until{};
        double perStep = 1;

        friend bool operator==(const Earlier &, const Earlier &) = default;
    };

    TrackUnit unit = TrackUnit::steps;
    double perStep = 1;
    std::vector<Earlier> earlier{}; // how much it was before, oldest first

    TrackScale at(Instant at) const; // as it was then
    bool changesIn(const TimeSpan &span) const;
    // From a sample of this channel to its value in the unit; words, and so bits, are not scaled.
    double factor(Channel channel) const;
    double factor(Channel channel, Instant then) const;
    // As written with a number in files, in ASCII and the same in every language: "mm", "rpm"; empty for
    // words.
    QLatin1String symbol(Channel channel) const;

    friend bool operator==(const TrackScale &, const TrackScale &) = default;
};

// The parts of a span in which a step is the same, oldest first; at least one.
struct ScaledSpan
{
    TimeSpan span;
    TrackScale scale;
};
std::vector<ScaledSpan> scaledSpans(const TrackScale &scale, const TimeSpan &span);

} // namespace codewheel
