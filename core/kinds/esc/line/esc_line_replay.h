// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_event.h"
#include "kinds/esc/line/esc_line_record.h"

#include <QObject>
#include <QPointer>

namespace codewheel {

class EscLineSession;

// A request of a recorded session, with the answer it got then.
struct ReplayStep
{
    esc::Request request;
    std::optional<QByteArray> answer; // between its line ends; empty: none came

    friend bool operator==(const ReplayStep &, const ReplayStep &) = default;
};

struct ReplayWish
{
    bool automatic = false; // may have been asked automatically by the program, like the position
    bool writes = false;
};

// In the order in which they were sent. A read that was repeated because no answer came is one step.
std::vector<ReplayStep> replaySteps(const EscLineRecord &record, ReplayWish wish);

// Sends the requests of a recorded session again, one after the other, each when the previous one has ended.
// Used by the terminal.
class EscLineReplay : public QObject
{
    Q_OBJECT

public:
    enum class Verdict { same, differs, noAnswer };
    enum class End { done, cancelled, portGone, watchOnly };

    using QObject::QObject;

    // Nothing else may be running. The session must have been opened; if it ends, so does the replay.
    void start(EscLineSession &line, std::vector<ReplayStep> steps);
    void cancel();
    bool isRunning() const { return !m_line.isNull(); }
    const std::vector<ReplayStep> &steps() const { return m_steps; }

Q_SIGNALS:
    // `now`: today's answer, between its line ends.
    void answered(int step, codewheel::EscLineReplay::Verdict verdict, const QByteArray &now);
    void ended(codewheel::EscLineReplay::End how);

private:
    void sendNext();
    void take(const TypedAnswered &answer);
    void checkState();
    void end(End how);

    QPointer<EscLineSession> m_line;
    std::vector<ReplayStep> m_steps;
    std::size_t m_next = 0;
};

} // namespace codewheel
