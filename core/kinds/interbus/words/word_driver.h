// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/words/cyclic_driver.h"
#include "vocabulary/instant.h"
#include "vocabulary/word.h"

#include <optional>
#include <utility>

namespace codewheel {

// Which words are believed behind a link that may tear them: a read-out answer, of which one half may still
// be that of the word before, counts once it has stood for longer than any gateway copies. What never stands
// is left to whoever waits for it.
class StandingAnswer
{
public:
    static constexpr Instant time = std::chrono::milliseconds(50);     // assumed
    static constexpr Instant longest = std::chrono::milliseconds(500); // that it is waited for (assumed)

    bool counts(Word in, bool isAnswer, Instant now)
    {
        if (m_last != in) {
            m_last = in;
            m_since = now;
        }
        if (!isAnswer)
            m_openSince.reset();
        else if (!m_openSince)
            m_openSince = now;
        return !isAnswer || now - m_since >= time || now - *m_openSince >= longest;
    }
    void forget() { *this = {}; }

private:
    std::optional<Word> m_last;
    Instant m_since{};                  // so long it has been the same
    std::optional<Instant> m_openSince; // there have been answers
};

// What the drivers of cyclic encoders that take jobs have in common: it keeps the job in progress, a WordRun.
// `Encoder` is the encoder as currently known, shared with the job: reading, events, check(job), setKnown(),
// observe(), isAnswer(in).
template <typename Encoder, typename Run>
class WordDriver : public CyclicDriver
{
public:
    // The description must outlive the driver.
    template <typename Timing>
    WordDriver(const DeviceDescription &device, Timing timing)
        : m_encoder(device, timing)
    {}

    const Reading &reading() const override { return m_encoder.reading; }
    bool busy() const override { return m_run.has_value(); }
    void setKnown(const std::vector<Known> &known) override { m_encoder.setKnown(known); }
    void expectTornWords() override { m_answer.emplace(); }

    void forget() override
    {
        CyclicDriver::forget();
        if (m_answer)
            m_answer->forget();
    }

    Result<void> begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant) override
    {
        if (m_run)
            return refuse(RefusalKind::busy, RefusalId::jobRunning);
        if (auto checked = m_encoder.check(job); !checked)
            return checked;
        m_run.emplace(id, job, pace, m_encoder);
        if (reading().state == EncoderState::notSeen)
            return {}; // IN is not known before the first cycle
        auto prepared = m_run->prepare(in, out);
        if (!prepared)
            m_run.reset();
        return prepared;
    }

    void proceed() override
    {
        if (m_run)
            m_run->proceed();
    }

    void cancel(OnCancel how, Instant now) override
    {
        if (m_run)
            m_run->cancel(how, now);
    }

    void stop(const Refusal &why, Instant) override
    {
        if (m_run)
            m_run->stop(why);
        m_run.reset();
    }

    void wait(Word out) override
    {
        if (m_run)
            m_run->wait(out);
    }

    Word cycle(Word in, Word out, Instant now) override
    {
        if (m_answer && !m_answer->counts(in, m_encoder.isAnswer(in), now)) {
            wait(out);
            return m_run || mayStand(out) ? out : Word{0};
        }
        m_encoder.observe(in, out, now);
        const Word next = m_run ? m_run->cycle(in, out, now) : out;
        if (m_run && m_run->isDone())
            m_run.reset();
        return m_run || mayStand(next) ? next : Word{0};
    }

    std::vector<Event> takeEvents() override { return std::exchange(m_encoder.events, {}); }

protected:
    Encoder m_encoder;

private:
    std::optional<Run> m_run;
    std::optional<StandingAnswer> m_answer; // if words may be torn
};

} // namespace codewheel
