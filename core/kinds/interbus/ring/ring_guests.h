// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/ring_device.h"
#include "vocabulary/instant.h"
#include "vocabulary/refusal.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace codewheel {

// What a guest wants in the OUT word of a device: these bits of it. The others stay as they are.
struct GuestWord
{
    std::size_t device = 0;
    Word word = 0;
    Word mask = ~Word{0};
    Word before = 0; // what stood in OUT; known once it is carried out
};

// The ring as its guests see it, after one cycle.
struct GuestImage
{
    std::shared_ptr<const RingStructure> ring{}; // another one for another ring; null: there is none to use
    std::vector<Word> in{};                      // one word per device, in ring order
    std::vector<Word> out{};                     // as they went out
    std::uint16_t status = 0;                    // diagnostic status register of the master
    std::uint16_t parameter = 0;                 // diagnostic parameter register
    std::uint64_t cycle = 0;
    Instant at{}; // on the ring's clock
};

// Where a guest's words went out.
struct GuestSent
{
    std::uint64_t cycle = 0;
    Instant at{};
    std::vector<Word> words{};  // whole ones, in the order of the write
    std::vector<Word> before{}; // what stood in their place: whoever repeats its words changes nothing
};

// Programs that read and write the words of a ring beside its user, such as clients of a Modbus server: the
// way between their threads and that of the bus. The RingRunner that offers its ring asks it in each cycle,
// and carries out what guests want as it does with words written by hand. Any thread.
//
// A device takes one word per cycle: a further one waits for the next, behind those that came before it. The
// words of one write go out together, in one cycle, or not at all.
class RingGuests
{
public:
    // As of the last cycle. Before the first one since the ring is offered it waits for that, at most
    // `patience`.
    GuestImage image(std::chrono::milliseconds patience) const;

    // Returns once the words were on the bus. Refused: as words written by hand (maySend()); notInRing, if
    // the ring of this image is not the one in use; busStopped, if no cycle came within `patience`. What was
    // refused is not sent later.
    Result<GuestSent> write(const GuestImage &seen, std::vector<GuestWord> words,
                            std::chrono::milliseconds patience);

    // For the runner, in this order.
    //
    // Hands over what is to go out in this cycle: each device at most once, and none that is `taken` already.
    // `carryOut` completes the words to whole ones, or says why not.
    using CarryOut = std::function<Result<void>(std::vector<GuestWord> &words)>;
    void carryOut(std::vector<bool> taken, const CarryOut &carryOut);
    // The cycle is over: what was carried out was on the bus, or why not. Where another ring has taken the
    // place of one, its master seems to stand still at first: guests that watch it notice that its encoders
    // may be others.
    static constexpr std::chrono::seconds anotherStandsFor{2};
    void show(const Result<void> &exchanged, const std::function<void(GuestImage &)> &update);
    // The ring is no longer offered.
    void leave();

private:
    struct Write
    {
        std::shared_ptr<const RingStructure> ring;
        std::vector<GuestWord> words;
        std::optional<Result<GuestSent>> result{};
        std::condition_variable ended{};
    };

    void letAnotherStand(bool isAnother); // under the lock
    static void end(Write &write, Result<GuestSent> result);

    mutable std::mutex m_mutex; // guards everything below
    GuestImage m_image;
    bool m_isShown = false; // or left: there is nothing to wait for
    bool m_hasHadRing = false;
    Instant m_standsUntil{};
    mutable std::condition_variable m_shown;
    std::vector<Write *> m_waiting; // oldest first; those who wait for them own them
    std::vector<Write *> m_carriedOut;
};

} // namespace codewheel
