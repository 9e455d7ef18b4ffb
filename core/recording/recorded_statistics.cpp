// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorded_statistics.h"

#include "recording/recording_reader.h"

#include <algorithm>

namespace codewheel {
namespace {

std::optional<History::Statistics> statisticsOf(const RecordingReader &reader, const RecordedKey &key,
                                                const TimeSpan &span)
{
    auto channel = reader.channel({.id = key.device}, key.channel);
    if (!channel)
        return {};
    const auto statistics = channel->statistics(span);
    return statistics ? *statistics : std::nullopt;
}

} // namespace

RecordedStatistics::RecordedStatistics(QString file)
    : m_file(std::move(file))
{}

// The thread begins with the first question: most recordings are never asked one.
std::optional<History::Statistics> RecordedStatistics::of(const RecordedKey &key, const TimeSpan &span)
{
    const std::lock_guard lock(m_mutex);
    Question &question = m_questions[key];
    if (question.span == span)
        return question.answer;
    question = {.span = span};
    m_asked.notify_one();
    if (!m_thread.joinable())
        m_thread = std::jthread([this](const std::stop_token &stop) { run(stop); });
    return {};
}

void RecordedStatistics::forget()
{
    const std::lock_guard lock(m_mutex);
    m_questions.clear();
}

std::optional<std::pair<RecordedKey, TimeSpan>> RecordedStatistics::next(const std::stop_token &stop)
{
    std::unique_lock lock(m_mutex);
    auto open = m_questions.end();
    m_asked.wait(lock, stop, [&] {
        open = std::ranges::find_if(m_questions, [](const auto &one) { return !one.second.isAnswered; });
        return open != m_questions.end();
    });
    return stop.stop_requested() ? std::nullopt : std::optional(std::pair(open->first, open->second.span));
}

void RecordedStatistics::run(const std::stop_token &stop)
{
    const auto reader = RecordingReader::open(m_file);
    while (const auto question = next(stop)) {
        const auto &[key, span] = *question;
        const auto answer = reader ? statisticsOf(*reader, key, span) : std::nullopt;
        {
            const std::lock_guard lock(m_mutex);
            if (Question &asked = m_questions[key]; asked.span == span)
                asked = {.span = span, .isAnswered = true, .answer = answer};
        }
        Q_EMIT ready(); // connected across threads: it is delivered in the thread of whoever asked
    }
}

} // namespace codewheel
