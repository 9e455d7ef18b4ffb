// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/profile.h"
#include "kinds/interbus/ring/snapshot.h"

#include <functional>
#include <vector>

namespace codewheel {

// What the words of an encoder do not tell for certain, but their course makes likely. An encoder without
// power shows 00000000, which is also position 0. Used by RingSession, with each snapshot.
class WordDoubts
{
public:
    using ProfileOf = std::function<std::optional<Profile>(std::size_t device)>; // empty: no encoder
    // What is wrong with its IN word, as its link judges it; empty: nothing.
    using Judge = std::function<QString(std::size_t device)>;

    void look(const Snapshot &ring, const ProfileOf &profileOf, const Judge &judge);

    // IN fell to 00000000 from a position far away, while OUT stayed as it was; since then it is that,
    // whatever was sent.
    bool mayBeOff(std::size_t device) const
    {
        return device < m_devices.size() && m_devices[device].mayBeOff;
    }
    // The last OUT word that took longer to be confirmed than encoders need, reported for a while, so that a
    // job of many words is one doubt; empty: there was none.
    std::optional<Word> slowlyConfirmed(std::size_t device) const;
    // What is wrong with its words, such as their order; empty: nothing. So of several words, and until as
    // many right ones have come.
    QString wrongWord(std::size_t device) const;

private:
    struct Device
    {
        Word in = 0;
        Word out = 0;
        std::optional<std::int64_t> position{};
        bool mayBeOff = false;
        int sameFor = 0;                     // snapshots
        std::optional<Instant> waitsSince{}; // for a confirmation
        std::optional<Instant> slowAt{};
        Word slowWord = 0;
        int wrongWords = 0; // more than right ones
        QString wrong{};    // the last of them
        bool isWrong = false;
    };
    static void lookAtZero(Device &before, const Snapshot::Device &now);
    void lookAtConfirmation(Device &before, const Snapshot::Device &now, Profile profile) const;
    void lookAtWordOfNext(const Snapshot &ring, const Judge &judge);

    std::vector<Device> m_devices;
    unsigned m_generation = 0;
    Instant m_now{};
    std::size_t m_next = 0; // whose word is judged in the next snapshot
    Instant m_nextRound{};
};

} // namespace codewheel
