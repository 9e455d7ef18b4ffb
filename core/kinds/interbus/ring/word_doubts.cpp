// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/word_doubts.h"

#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/la66_word.h"
#include "kinds/interbus/words/profiles.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace codewheel {
namespace {

constexpr Instant usualConfirmation = std::chrono::milliseconds(50); // at most, assumed
constexpr Instant toldFor = std::chrono::seconds(5);
constexpr Instant judgedEvery = std::chrono::milliseconds(250);
constexpr int suspicious = 3;             // wrong words
constexpr std::uint64_t farAway = 1024;   // steps; between two snapshots a shaft turns less than that
constexpr std::uint64_t farFromRest = 64; // the same of one that stood still (assumed)
constexpr int snapshotsAtRest = 3;        // snapshots

// After the last position comes 0 again, which is no jump; the number of positions is usually a power of two.
bool isFarFromZero(std::int64_t position, std::uint64_t far)
{
    const auto distance = static_cast<std::uint64_t>(std::abs(position));
    return distance > far && std::bit_ceil(distance + 1) - distance > far;
}

// If its coding is not known, IN as a number will do.
std::optional<std::int64_t> positionIn(const Reading &reading)
{
    if (reading.state != EncoderState::operation || reading.velocity || reading.cams)
        return std::nullopt;
    return reading.position.value_or(reading.in);
}

bool isConfirmed(Profile profile, Word out, Word in)
{
    if (profile == profile::la66)
        return !la66::isServiceMode(out) || la66::answers(in, out);
    const bool isAsked = profile == profile::k3 && k3::isParameterWord(out);
    return !isAsked || (k3::isConfirmation(in) && k3::number(in) == k3::number(out));
}

} // namespace

void WordDoubts::look(const Snapshot &ring, const ProfileOf &profileOf, const Judge &judge)
{
    if (ring.generation != m_generation || ring.devices.size() != m_devices.size()) {
        m_devices.assign(ring.devices.size(), {});
        m_generation = ring.generation;
        m_next = 0;
        m_nextRound = {};
    }
    m_now = ring.at;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        const auto profile = profileOf(i);
        if (ring.state != MasterState::run || !ring.devices[i].inRing || !profile) {
            m_devices[i] = {};
            continue;
        }
        lookAtZero(m_devices[i], ring.devices[i]);
        lookAtConfirmation(m_devices[i], ring.devices[i], *profile);
        m_devices[i].in = ring.devices[i].in;
        m_devices[i].out = ring.devices[i].out;
        m_devices[i].position = positionIn(ring.devices[i].reading);
    }
    lookAtWordOfNext(ring, judge);
}

// One a snapshot, since judging takes time; none during a job, which changes what its encoder can send.
void WordDoubts::lookAtWordOfNext(const Snapshot &ring, const Judge &judge)
{
    if (m_next >= m_devices.size()) {
        if (m_now < m_nextRound)
            return;
        m_next = 0;
    }
    if (m_next == 0)
        m_nextRound = m_now + judgedEvery;
    const std::size_t device = m_next++;
    if (device >= m_devices.size() || ring.state != MasterState::run || !ring.devices[device].inRing ||
        ring.devices[device].heldByJob)
        return;
    Device &its = m_devices[device];
    const QString wrong = judge(device);
    its.wrongWords = std::clamp(its.wrongWords + (wrong.isEmpty() ? -1 : 1), 0, suspicious);
    its.isWrong = its.wrongWords == suspicious || (its.isWrong && its.wrongWords > 0);
    if (!wrong.isEmpty())
        its.wrong = wrong;
}

QString WordDoubts::wrongWord(std::size_t device) const
{
    return device < m_devices.size() && m_devices[device].isWrong ? m_devices[device].wrong : QString();
}

void WordDoubts::lookAtZero(Device &before, const Snapshot::Device &now)
{
    const bool isOutSame = now.out == before.out && now.outEdges == 0;
    const std::uint64_t far = before.sameFor >= snapshotsAtRest ? farFromRest : farAway;
    const bool fell = before.in != 0 && before.position && isFarFromZero(*before.position, far);
    before.mayBeOff = now.in == 0 && (before.mayBeOff || (isOutSame && fell));
    before.sameFor = now.in == before.in && isOutSame ? std::min(before.sameFor + 1, snapshotsAtRest) : 0;
}

void WordDoubts::lookAtConfirmation(Device &before, const Snapshot::Device &now, Profile profile) const
{
    const bool waits = now.reading.state != EncoderState::error && !isConfirmed(profile, now.out, now.in);
    if (!waits || now.out != before.out)
        before.waitsSince.reset();
    if (!waits)
        return;
    if (!before.waitsSince)
        before.waitsSince = m_now;
    if (m_now - *before.waitsSince < usualConfirmation)
        return;
    before.slowAt = m_now;
    before.slowWord = now.out;
}

std::optional<Word> WordDoubts::slowlyConfirmed(std::size_t device) const
{
    if (device >= m_devices.size())
        return std::nullopt;
    const Device &its = m_devices[device];
    return its.slowAt && m_now - *its.slowAt < toldFor ? std::optional(its.slowWord) : std::nullopt;
}

} // namespace codewheel
