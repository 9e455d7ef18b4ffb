// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/cyclic_driver.h"
#include "kinds/interbus/words/k3_word.h"

#include <deque>

namespace codewheel {

// A driver for tests of the runner: sends the words of SendWords one per cycle, then 00000000 and an outcome;
// takes no other job. Treats D31 D30 = 10 as an error.
class WordByWordDriver : public CyclicDriver
{
public:
    const Reading &reading() const override { return m_reading; }
    bool busy() const override { return m_busy; }
    void setKnown(const std::vector<Known> &known) override { m_known = known; }
    const std::vector<Known> &known() const { return m_known; }
    void learn(KnowledgeChanged change) { m_events.emplace_back(std::move(change)); }

    Result<void> begin(JobId id, const Job &job, Pace, Word, Word, Instant) override
    {
        const auto *send = std::get_if<SendWords>(&job);
        if (!send)
            return refuse(RefusalKind::notSupported, RefusalId::writingNotSupported,
                          {QStringLiteral("fake")});
        m_id = id;
        m_words.assign(send->words.begin(), send->words.end());
        m_busy = true;
        return {};
    }
    void proceed() override {}
    void cancel(OnCancel, Instant) override { end(Refusal{RefusalKind::stopped, RefusalId::cancelled, {}}); }
    void stop(const Refusal &why, Instant) override { end(why); }

    Word cycle(Word in, Word out, Instant now) override
    {
        const bool error = k3::isErrorOrReadOut(in) && !k3::isReadOutAnswer(in);
        m_reading = {.at = now,
                     .state = error ? EncoderState::error : EncoderState::operation,
                     .in = in,
                     .position = std::nullopt,
                     .mode = Mode::position,
                     .coding = std::nullopt,
                     .errorNumber = error ? std::optional(k3::number(in)) : std::nullopt};
        if (!m_busy)
            return out;
        if (m_words.empty()) {
            end({});
            return 0;
        }
        const Word next = m_words.front();
        m_words.pop_front();
        return next;
    }
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }

private:
    void end(std::optional<Refusal> refusal)
    {
        Outcome outcome;
        outcome.job = m_id;
        if (refusal)
            outcome.result = tl::unexpected(*refusal);
        outcome.leftIn = m_reading.state;
        m_events.emplace_back(std::move(outcome));
        m_busy = false;
    }

    Reading m_reading;
    bool m_busy = false;
    JobId m_id = 0;
    std::deque<Word> m_words;
    std::vector<Known> m_known;
    std::vector<Event> m_events;
};

} // namespace codewheel
