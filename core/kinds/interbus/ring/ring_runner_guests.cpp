// SPDX-License-Identifier: GPL-3.0-or-later
// Guests of the ring: what they want written, and what they see.
#include "kinds/interbus/ring/ring_runner_private.h"

#include <utility>

namespace codewheel {

void RingRunner::Private::carryOut(command::OfferTo &c)
{
    if (guests == c.guests)
        return;
    if (guests)
        guests->leave();
    guests = std::move(c.guests);
    generationOfGuests = 0;
}

// Not over a word that the user has just written.
void RingRunner::Private::carryOutGuestWords()
{
    if (!guests || generationOfGuests != ring.generation)
        return;
    std::vector<bool> taken(image.size());
    for (const std::size_t device : written)
        taken[device] = true;
    guests->carryOut(std::move(taken), [this](auto &words) { return takeGuestWords(words); });
}

// All words of a write, or none.
Result<void> RingRunner::Private::takeGuestWords(std::vector<GuestWord> &words)
{
    for (GuestWord &word : words) {
        word.before = image[word.device];
        word.word = (word.before & ~word.mask) | (word.word & word.mask);
        word.mask = ~Word{0};
        if (auto allowed = mayWrite(word.device, word.word); !allowed)
            return allowed;
    }
    for (const GuestWord &word : words) {
        link.claimOut(word.device);
        guestChanges.push_back({word.device, word.word, std::exchange(image[word.device], word.word)});
    }
    return {};
}

// A cycle that was skipped takes the words back: they were refused.
void RingRunner::Private::tellGuestWords(bool isExchanged)
{
    for (const GuestChange &change : std::exchange(guestChanges, {})) {
        if (!isExchanged && ring.state == MasterState::run)
            image[change.device] = change.before;
        else if (isExchanged && change.word != change.before)
            tell(change.device, GuestWrote{change.word});
    }
}

// Why the words of this cycle count as not sent.
Result<void> RingRunner::Private::whetherExchanged(bool isExchanged) const
{
    if (isExchanged)
        return {};
    if (ring.whyLost)
        return tl::unexpected(*ring.whyLost);
    return refuse(RefusalKind::busy, RefusalId::notRunning, {QString()});
}

void RingRunner::Private::showGuests(bool isExchanged)
{
    tellGuestWords(isExchanged);
    if (!guests)
        return;
    guests->show(whetherExchanged(isExchanged), [this](GuestImage &shown) {
        if (ring.generation == 0) // not read in yet
            return;
        if (std::exchange(generationOfGuests, ring.generation) != ring.generation)
            shown.ring = std::make_shared<const RingStructure>(structure);
        shown.in.resize(ring.devices.size());
        shown.out.resize(ring.devices.size());
        for (std::size_t i = 0; i < ring.devices.size(); ++i) {
            shown.in[i] = ring.devices[i].in;
            shown.out[i] = ring.devices[i].out;
        }
        shown.status = statusRegister();
        shown.parameter = ring.master ? ring.master->parameter : std::uint16_t{0};
        shown.cycle = ring.cycle;
        shown.at = ring.at;
    });
}

std::uint16_t RingRunner::Private::statusRegister() const
{
    return ring.master ? ring.master->statusBits : registerOf(ring.state);
}

} // namespace codewheel
