// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_log_reader.h"
#include "vocabulary/refusal.h"

#include <QFile>
#include <QString>

#include <deque>
#include <memory>
#include <set>

namespace codewheel {

// What is in a log of a CAN bus, without the frames.
struct CanLogSummary
{
    std::string interface {}; // whose frames are taken
    std::int64_t frames = 0;
    std::int64_t otherFrames = 0; // of other interfaces, which are left out
    std::int64_t faults = 0;      // lines that were not read
    bool isSince1970 = false;     // its times; otherwise since its beginning
    Instant first{};
    Instant last{};
    std::set<std::uint32_t> identifiers{}; // of 11 bits

    Instant length() const { return last - first; }
};

// The file of a log of CAN frames (docs/manual/can-logs.md), of which one bus is taken: the interface that is
// named, otherwise that of the first frame. Frames without a time are left out.
class CanLog
{
public:
    explicit CanLog(QString path, std::string interface = {});

    const QString &path() const { return m_path; }
    // Reads all of it, piece by piece. Refused: fileNotReadable, logEmpty, logHasNoTimes, logHasNotThat.
    Result<CanLogSummary> look();

    // From its beginning on, frame by frame. Times never go back: one that does is taken for that before.
    Result<void> begin() { return open(); }
    const CanFrame *next(); // until drop(); null: there is no more
    void drop() { m_frames.pop_front(); }

private:
    Result<void> open();
    bool readSome(); // false: it is at its end
    void count(const CanFrame &frame, CanLogSummary &summary) const;

    QString m_path;
    std::string m_interface;
    QFile m_file;
    std::unique_ptr<CanLogReader> m_reader;
    std::deque<CanFrame> m_frames{};
    std::int64_t m_faults = 0;
    Instant m_latest = Instant::min();
};

} // namespace codewheel
