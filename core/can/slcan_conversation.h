// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "can/slcan_clock.h"
#include "can/slcan_codec.h"

#include <deque>

namespace codewheel {

// What is known of the firmware of an SLCAN adapter.
struct SlcanFirmware
{
    bool answers = false; // to what it does not know; otherwise it is silent, and nobody knows what it did
    QByteArray version{}; // as it says; empty: it does not

    bool isLawicel() const { return isLawicelVersion(version); }
};

// What is said to an SLCAN adapter and what its answers mean, without a port: it is asked what to write,
// given what came in, and told the time. It finds out what kind of firmware there is, opens the bus, and then
// tells frames, fates and states. SlcanLink leads it.
class SlcanConversation
{
public:
    enum class State : std::uint8_t { closed, opening, open, failed };

    // `name` is for its refusals. The rate is one of slcanRates.
    SlcanConversation(QString name, int rate);

    // `isPortNew`: the port was opened just now, which may have reset the board.
    void open(CanUse use, bool takesUnsureWatch, bool isPortNew, Instant now);
    // What closes the bus, to be written before the port is closed.
    QByteArray close();

    // What is to be written now. Also acts on what was not answered in time.
    QByteArray next(Instant now);
    std::optional<Instant> wakesAt() const;
    void received(const QByteArray &bytes, Instant now);
    // False: so many are without an answer that it has to wait, or the bus is not open.
    bool send(const CanFrame &frame, Instant now);

    State state() const { return m_state; }
    const Refusal &failure() const { return m_failure; }
    CanNews takeNews() { return std::exchange(m_news, {}); }
    CanStatus status() const;
    const SlcanFirmware &firmware() const { return m_firmware; }
    // Whether the rate may be another than the one asked for: silent firmware has 750 kBd in place of 800.
    bool mayRunAt750() const;
    // Bytes that were nothing of SLCAN, and what nobody had asked for.
    std::uint64_t skipped() const { return m_reader.skipped() + m_skipped; }

private:
    enum class Step : std::uint8_t {
        boot,    // waits for the board to have started
        close,   //
        version, //
        probe,   // with a command that no firmware has
        settle,  // waits for answers that are late
        rate,    //
        start,   // listens only, or opens
        none,    // the bus is open
    };
    enum class Answer : std::uint8_t { done, refused, none };
    struct Waiting
    {
        enum class What : std::uint8_t { command, version, status, frame };
        What what = What::command;
        Step step = Step::none; // of opening
        Instant until{};
        bool isToldUnknown = false; // its time is over; it still takes a late answer
    };

    void ask(const QByteArray &command, Waiting::What what, Instant now, Instant timeOut);
    void enter(Step step, Instant now);
    void stepEnded(Step step, Answer answer, Instant now);
    void probed(Instant now);
    void rateEnded(Answer answer, Instant now);
    void startEnded(Answer answer, Instant now);
    void openSilently(Instant now);
    void becomeOpen(Instant now);
    void reopen(Instant now);
    void waitForBoot(Instant now);
    void fail(const Refusal &why);

    void take(const SlcanItem &item, Instant now);
    void takeFrame(const SlcanItem &item, Instant now);
    void takeTextInOpening(const QByteArray &text, Instant now);
    void takeText(const QByteArray &text, Instant now);
    void takeStatus(std::uint8_t bits, Instant now);
    bool takeAnswerTo(Waiting::What what);
    void answerOldest(Answer answer, Instant now);
    void tellUnknown(Waiting &one);
    void forgetWaiting();
    void tellTimeOuts(Instant now);
    bool isAwaited(Waiting::What what) const;

    QString m_name;
    int m_rate;
    CanUse m_use = CanUse::watch;
    bool m_takesUnsureWatch = false;
    State m_state = State::closed;
    Refusal m_failure{};
    SlcanFirmware m_firmware{};
    bool m_isKnown = false;    // the firmware
    bool m_opensPlain = false; // though it is to watch, since it cannot listen only
    std::optional<bool> m_listensOnly{};
    CanState m_busState = CanState::notKnown;

    Step m_step = Step::none;
    Instant m_stepEnds{};
    Instant m_opensUntil{};
    Instant m_bootEnds{}; // if the port was new
    int m_tries = 0;      // of this step
    int m_boots = 0;      // times that opening began again because of them
    int m_rateTries = 0;
    Instant m_openSince{};
    Instant m_nextStatus{};
    std::uint8_t m_statusBits = 0;

    SlcanReader m_reader{};
    SlcanClock m_clock{};
    QByteArray m_out{};
    std::deque<Waiting> m_waiting{};
    CanNews m_news{};
    std::uint64_t m_skipped = 0;
};

} // namespace codewheel
