// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/archive.h"
#include "recording/recorded_history.h"
#include "recording/recorded_statistics.h"
#include "recording/recording_reader.h"

namespace codewheel {

// What a recording has, as it was when it was opened.
class RecordingArchive final : public Archive
{
    Q_OBJECT

public:
    // The bus a recorded one is here, so that its places are not those of another; without one, it is itself.
    using BusesHere = std::map<BusId, BusId>;

    static Result<std::unique_ptr<RecordingArchive>> open(const QString &file, const BusesHere &buses = {});

    const RecordingReader &reader() const { return m_reader; }
    Place placeHere(Place recorded) const;
    // Of a recording that is still being written: what came since. What cannot be read now stays as it was.
    void lookAgain();

    std::vector<Place> places() const override;
    const History *of(Place place, Channel channel) const override;
    std::optional<TimeSpan> span() const override;
    std::vector<Mark> marks() const override;
    std::vector<ValuesSince> known(Place place) const override;
    std::optional<Instant> played() const override;
    void setPlayed(std::optional<Instant> at) { m_played = at; } // as recorded

    // Why something could not be read, once.
    void tell(const Refusal &why) const;
    void tellDamage(const std::optional<Refusal> &damage) const;
    // Of that many samples that they take a while: the first time nothing, then statisticsReady().
    std::optional<History::Statistics> slowStatistics(const RecordedKey &key, const TimeSpan &recorded) const;

private:
    RecordingArchive(RecordingReader reader, BusesHere buses);
    // What is known of the file without looking at any channel.
    struct Contents
    {
        std::map<Place, RecordingReader::Device> devices; // by place here
        std::map<Place, std::vector<ValuesSince>> known;  // by place here
        std::optional<TimeSpan> span;                     // as recorded
        std::vector<Mark> marks;                          // as recorded
    };
    using Histories = std::map<std::pair<Place, Channel>, std::unique_ptr<RecordedHistory>>;

    Result<Contents> read() const;
    Result<std::vector<Mark>> readMarks() const;
    Result<std::vector<ValuesSince>> readKnown(const RecordingReader::Device &device) const;

    RecordingReader m_reader;
    BusesHere m_buses;
    Contents m_contents;
    mutable Histories m_histories; // of those that were asked for
    std::optional<Instant> m_played;
    mutable std::optional<Refusal> m_told;
    mutable RecordedStatistics m_statistics;
};

} // namespace codewheel
