// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/bus_recorder.h"
#include "vocabulary/message.h"

#include <QTimer>

namespace codewheel {

// The recording of the program: none, or one. Outlives the window, which is rebuilt when the language
// changes, and all that is done to buses meanwhile.
class RecordingAtWork : public QObject
{
    Q_OBJECT

public:
    // Both outlive it.
    RecordingAtWork(Buses &buses, Histories &histories, BusFeed::WallClockNow now, QObject *parent = nullptr);
    ~RecordingAtWork() override;

    // While none runs. Refused: the file cannot be begun.
    Result<void> begin(const RecordingPlan &plan);
    const BusRecorder *recorder() const { return m_recorder.get(); } // null: none runs or waits
    void fire();
    // At this moment, here and in the trend. Notes of the trend come into the recording by themselves.
    void note(const QString &text);
    void end();

Q_SIGNALS:
    void changed(); // begun, ended, or about once a second how it gets on
    void ended(const QString &file, const QString &size);
    void messaged(const codewheel::Message &message);

private:
    void look();
    void endIfOver();
    void tellProblem(const std::optional<Refusal> &problem);
    void tell(MessageCode id, std::vector<RefusalArgument> more = {});
    void finish();

    Buses &m_buses;
    Histories &m_histories;
    const BusFeed::WallClockNow m_now;
    std::unique_ptr<BusRecorder> m_recorder;
    bool m_waits = false; // for its trigger, as last told
    bool m_isByHand = false;
    std::optional<RefusalCode> m_problem; // as last told
    QTimer m_timer;
};

} // namespace codewheel
