// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever comes from an SLCAN adapter, in whatever pieces and at whatever time: opening ends, every frame
// that was sent has one fate, and what was received is a frame that can be written and read again.
//
// The bits of the first byte choose the use, whether watching may be unsure, and whether the port is new;
// then follow pieces: their delay after the previous one in units of 20 ms, their length, their bytes.
#include "can/slcan_conversation.h"
#include "tests/fuzz/must.h"

#include <QByteArrayView>

using namespace codewheel;
using namespace std::chrono_literals;

namespace {

using State = SlcanConversation::State;

struct Talk
{
    SlcanConversation talk{QStringLiteral("port"), 250'000};
    Instant now{};
    std::size_t sent = 0;
    std::size_t fates = 0;

    void takeNews()
    {
        const CanNews news = talk.takeNews();
        fates += news.fates.size();
        must(fates <= sent, "no fate without a frame");
        for (CanFrame frame : news.frames) {
            must(frame.time && *frame.time <= now, "received by now");
            must(frame.length <= CanFrame::mostBytes, "a frame has eight bytes at most");
            frame.time.reset();
            if (!frame.isError)
                must(SlcanReader().read(slcanCommand(frame)) ==
                         std::vector{SlcanItem{.kind = SlcanItem::Kind::frame, .frame = frame}},
                     "what is written is read");
        }
    }

    void step()
    {
        talk.next(now);
        takeNews();
        must(talk.state() != State::opening || talk.wakesAt(), "opening goes on by itself");
    }

    void passUntil(Instant until)
    {
        constexpr int mostSteps = 100'000;
        step();
        for (int i = 0; talk.wakesAt() && *talk.wakesAt() <= until; ++i) {
            must(i < mostSteps, "time passes");
            now = std::max(now, *talk.wakesAt());
            step();
        }
        now = until;
        step();
    }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    constexpr Instant unit = 20ms;
    QByteArrayView pieces(data + 1, static_cast<qsizetype>(size - 1));
    Talk it;
    it.talk.open((data[0] & 1) != 0 ? CanUse::watch : CanUse::operate, (data[0] & 2) != 0, (data[0] & 4) != 0,
                 it.now);
    while (pieces.size() >= 2) {
        it.passUntil(it.now + unit * static_cast<unsigned char>(pieces[0]));
        const qsizetype length =
            std::min<qsizetype>(static_cast<unsigned char>(pieces[1]), pieces.size() - 2);
        it.talk.received(pieces.sliced(2, length).toByteArray(), it.now);
        it.takeNews();
        pieces = pieces.sliced(2 + length);
        if (it.talk.send({.id = 0x101}, it.now))
            ++it.sent;
    }
    it.passUntil(it.now + 30s);
    must(it.talk.state() != State::opening, "opening ends");
    it.talk.close();
    it.takeNews();
    must(it.fates == it.sent, "each frame has a fate");
    return 0;
}
