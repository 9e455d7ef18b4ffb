// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_replay.h"

#include "kinds/esc/line/esc_line_session.h"
#include "kinds/esc/line/row_text.h"
#include "kinds/esc/line/typed_request.h"
#include "kinds/esc/protocol/esc_frame.h"

namespace codewheel {
namespace {

// As in esc::Answer::text; blanks may be part of a version.
QByteArray betweenLineEnds(QByteArrayView bytes)
{
    if (bytes.endsWith(esc::lineEnd))
        bytes.chop(esc::lineEndSize);
    if (bytes.startsWith(esc::lineEnd))
        bytes = bytes.sliced(esc::lineEndSize);
    return bytes.toByteArray();
}

} // namespace

std::vector<ReplayStep> replaySteps(const EscLineRecord &record, ReplayWish wish)
{
    std::vector<ReplayStep> steps;
    bool isOpen = false; // the last step has not been answered yet
    bool isWanted = false;
    for (const EscLineRecord::Row &row : record.rows) {
        if (row.what.kind == esc::EscLineRow::Kind::sent) {
            const auto request = sentRequest(row.what.bytes);
            const bool isAutomaticRow = request && isAutomatic(request->command) && !row.typed;
            const bool isWrite = request && esc::shapeOf(request->command).writes;
            const bool isAgain = isOpen && isWanted && !row.typed && steps.back().request == request;
            isWanted = request && (wish.automatic || !isAutomaticRow) && (wish.writes || !isWrite);
            if (isWanted && !isAgain)
                steps.push_back({*request, {}});
            isOpen = isWanted;
        } else if (row.what.kind == esc::EscLineRow::Kind::answer && isOpen) {
            steps.back().answer = betweenLineEnds(row.what.bytes);
            isOpen = false;
        }
    }
    return steps;
}

void EscLineReplay::start(EscLineSession &line, std::vector<ReplayStep> steps)
{
    m_line = &line;
    m_steps = std::move(steps);
    m_next = 0;
    connect(&line, &EscLineSession::typedAnswered, this, &EscLineReplay::take);
    connect(&line, &EscLineSession::stateChanged, this, &EscLineReplay::checkState);
    connect(&line, &EscLineSession::alarmStopped, this, [this] { end(End::cancelled); });
    connect(&line, &QObject::destroyed, this, [this] { end(End::portGone); });
    sendNext();
}

void EscLineReplay::sendNext()
{
    if (m_next == m_steps.size()) {
        end(End::done);
        return;
    }
    const esc::Request &request = m_steps[m_next].request;
    if (esc::shapeOf(request.command).writes && !m_line->isOperating())
        end(End::watchOnly);
    else
        m_line->send(request);
}

void EscLineReplay::take(const TypedAnswered &answer)
{
    const ReplayStep &step = m_steps[m_next];
    if (answer.request != step.request || answer.result.sent == 0)
        return;
    const auto &came = answer.result.answer;
    Verdict verdict = Verdict::noAnswer;
    if (came || !step.answer)
        verdict = came && step.answer == came->text ? Verdict::same : Verdict::differs;
    if (!came && !step.answer)
        verdict = Verdict::same;
    const int index = static_cast<int>(m_next++);
    Q_EMIT answered(index, verdict, came ? came->text : QByteArray());
    if (isRunning())
        sendNext();
}

// What has been sent by then ends without an answer to wait for.
void EscLineReplay::checkState()
{
    if (!m_line->isOpen() || !m_line->latest().connected)
        end(End::portGone);
    else if (esc::shapeOf(m_steps[m_next].request.command).writes && !m_line->isOperating())
        end(End::watchOnly);
}

void EscLineReplay::cancel()
{
    if (isRunning())
        end(End::cancelled);
}

void EscLineReplay::end(End how)
{
    if (m_line)
        m_line->disconnect(this);
    m_line = nullptr;
    Q_EMIT ended(how);
}

} // namespace codewheel
