// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_guests.h"

#include "kinds/interbus/ring/master_status.h"
#include "kinds/interbus/ring/ring_refusals.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

Refusal noSuchRing()
{
    return {RefusalKind::link, RingRefusalId::notInRing, {QString()}};
}

bool isFree(const std::vector<GuestWord> &wanted, const std::vector<bool> &taken)
{
    return std::ranges::none_of(wanted, [&](const GuestWord &word) { return taken[word.device]; });
}

} // namespace

GuestImage RingGuests::image(std::chrono::milliseconds patience) const
{
    std::unique_lock lock(m_mutex);
    m_shown.wait_for(lock, patience, [this] { return m_isShown; });
    return m_image;
}

Result<GuestSent> RingGuests::write(const GuestImage &seen, std::vector<GuestWord> words,
                                    std::chrono::milliseconds patience)
{
    Write write{seen.ring, std::move(words)};
    std::unique_lock lock(m_mutex);
    if (!m_image.ring || m_image.ring != write.ring)
        return tl::unexpected(noSuchRing());
    m_waiting.push_back(&write);
    const auto hasEnded = [&write] { return write.result.has_value(); };
    if (!write.ended.wait_for(lock, patience, hasEnded)) {
        if (std::erase(m_waiting, &write) > 0)
            return refuse(RefusalKind::stopped, RefusalId::busStopped);
        write.ended.wait(lock, hasEnded); // the exchange that decides is under way
    }
    return *std::move(write.result);
}

// What has to wait keeps its devices for itself, so that no later write overtakes it.
void RingGuests::carryOut(std::vector<bool> taken, const CarryOut &carryOut)
{
    const std::scoped_lock lock(m_mutex);
    std::vector<Write *> waiting;
    for (Write *write : std::exchange(m_waiting, {})) {
        if (write->ring != m_image.ring) {
            end(*write, tl::unexpected(noSuchRing()));
            continue;
        }
        const bool goesNow = isFree(write->words, taken);
        for (const GuestWord &word : write->words)
            taken[word.device] = true;
        if (!goesNow)
            waiting.push_back(write);
        else if (const auto done = carryOut(write->words); !done)
            end(*write, tl::unexpected(done.error()));
        else
            m_carriedOut.push_back(write);
    }
    m_waiting = std::move(waiting);
}

void RingGuests::show(const Result<void> &exchanged, const std::function<void(GuestImage &)> &update)
{
    const std::scoped_lock lock(m_mutex);
    const auto before = m_image.ring;
    update(m_image);
    letAnotherStand(m_image.ring && m_image.ring != before);
    m_isShown = true;
    m_shown.notify_all();
    for (Write *write : std::exchange(m_carriedOut, {})) {
        if (!exchanged) {
            end(*write, tl::unexpected(exchanged.error()));
            continue;
        }
        GuestSent sent{m_image.cycle, m_image.at, {}, {}};
        for (const GuestWord &word : write->words) {
            sent.words.push_back(word.word);
            sent.before.push_back(word.before);
        }
        end(*write, std::move(sent));
    }
}

void RingGuests::letAnotherStand(bool isAnother)
{
    if (isAnother)
        m_standsUntil = std::exchange(m_hasHadRing, true) ? m_image.at + anotherStandsFor : Instant{};
    if (m_image.at < m_standsUntil)
        m_image.status = registerOf(MasterState::active);
}

void RingGuests::leave()
{
    const std::scoped_lock lock(m_mutex);
    m_image = {};
    m_isShown = true;
    m_shown.notify_all();
    const Refusal why{RefusalKind::stopped, RefusalId::busStopped, {}};
    for (std::vector<Write *> *writes : {&m_waiting, &m_carriedOut})
        for (Write *write : std::exchange(*writes, {}))
            end(*write, tl::unexpected(why));
}

// Under the lock: once it is released, the write may no longer exist.
void RingGuests::end(Write &write, Result<GuestSent> result)
{
    write.result = std::move(result);
    write.ended.notify_one();
}

} // namespace codewheel
