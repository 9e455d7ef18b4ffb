// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recording/recording_at_work.h"

#include "history/histories.h"

#include <QFileInfo>
#include <QLocale>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto betweenLooks = 500ms;
constexpr Instant afterTheEnd = 1s; // for what is still on its way

} // namespace

RecordingAtWork::RecordingAtWork(Buses &buses, Histories &histories, BusFeed::WallClockNow now,
                                 QObject *parent)
    : QObject(parent)
    , m_buses(buses)
    , m_histories(histories)
    , m_now(std::move(now))
{
    m_timer.setInterval(betweenLooks);
    connect(&m_timer, &QTimer::timeout, this, &RecordingAtWork::look);
    connect(&histories, &Histories::noted, this, [this](Instant at, const QString &text) {
        if (m_recorder)
            m_recorder->note(at, text);
    });
}

RecordingAtWork::~RecordingAtWork()
{
    if (m_recorder)
        m_recorder->end();
}

Result<void> RecordingAtWork::begin(const RecordingPlan &plan)
{
    auto recorder = BusRecorder::begin(m_buses, m_histories, plan, m_now);
    if (!recorder)
        return tl::unexpected(recorder.error());
    m_recorder = std::move(*recorder);
    // Queued: it must not go while it tells.
    connect(m_recorder.get(), &BusRecorder::stateChanged, this, &RecordingAtWork::look, Qt::QueuedConnection);
    m_waits = m_recorder->state() == BusRecorder::State::waiting;
    m_isByHand = false;
    m_problem.reset();
    m_timer.start();
    tell(m_waits ? MessageId::recordingWaits : MessageId::recordingBegun);
    look();
    return {};
}

void RecordingAtWork::fire()
{
    if (!m_recorder)
        return;
    m_isByHand = true;
    m_recorder->fire();
    look();
}

void RecordingAtWork::note(const QString &text)
{
    const auto all = m_histories.span();
    m_histories.note(all ? all->to : std::chrono::milliseconds(m_now().toMSecsSinceEpoch()), text);
}

void RecordingAtWork::end()
{
    if (!m_recorder)
        return;
    m_recorder->end();
    look();
}

void RecordingAtWork::look()
{
    if (!m_recorder)
        return;
    endIfOver();
    const bool hasFired = m_recorder->span() || m_recorder->state() == BusRecorder::State::recording;
    if (m_waits && hasFired) {
        m_waits = false;
        tell(m_isByHand ? MessageId::recordingBegun : MessageId::recordingTriggered);
    }
    const RecordingStatus status = m_recorder->status();
    tellProblem(status.problem);
    if (status.hasEnded)
        finish();
    Q_EMIT changed();
}

// Where no bus is connected any more, nothing tells the recorder that its time is over.
void RecordingAtWork::endIfOver()
{
    const auto &span = m_recorder->span();
    if (!span || span->to == Instant::max() || !m_buses.connected().empty())
        return;
    if (std::chrono::milliseconds(m_now().toMSecsSinceEpoch()) > span->to + afterTheEnd)
        m_recorder->end();
}

void RecordingAtWork::tellProblem(const std::optional<Refusal> &problem)
{
    const auto id = problem ? std::optional(problem->id) : std::nullopt;
    if (std::exchange(m_problem, id) == id)
        return;
    const RecordingStatus status = m_recorder->status();
    if (problem)
        Q_EMIT messaged({.severity = status.hasEnded ? Severity::fault : Severity::attention,
                         .id = MessageId::refused,
                         .refusal = problem});
    else
        tell(MessageId::recordingGoesOn, {static_cast<std::int64_t>(status.lost)});
}

void RecordingAtWork::tell(MessageCode id, std::vector<RefusalArgument> more)
{
    more.insert(more.begin(), m_recorder->plan().settings.file);
    Q_EMIT messaged({.id = id, .arguments = std::move(more)});
}

// One whose file is gone has said so already.
void RecordingAtWork::finish()
{
    m_timer.stop();
    const std::unique_ptr<BusRecorder> ended = std::move(m_recorder);
    ended->end();
    const QString file = ended->plan().settings.file;
    if (m_problem == RefusalId::recordingGone)
        return;
    const qint64 size = QFileInfo(file).size();
    Q_EMIT messaged({.id = MessageId::recordingEnded, .arguments = {file, std::int64_t{size}}});
    Q_EMIT this->ended(file, QLocale().formattedDataSize(size, 1, QLocale::DataSizeSIFormat));
}

} // namespace codewheel
