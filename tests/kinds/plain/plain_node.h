// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/kinds/plain/plain_peer.h"

namespace codewheel::test {

// An encoder of the tests' own kind as a peer. It is asked in lines: "get steps", "set steps=100 2000:1=-5"
// (up to three values), "go" (what it was given is in force), "keep" (what is in force is stored), "to 500"
// (that is its position now). What is not stored is gone when it was switched off.
class PlainNode final : public PlainPeer
{
public:
    explicit PlainNode(const Values &stored)
        : PlainPeer(stored)
        , m_stored(stored)
    {}

    QByteArray answer(const QByteArray &line) override;
    void switchOffAndOn() override;

    bool isGiven() const { return !m_given.empty(); }            // and not gone with
    void loseAnswerTo(const QByteArray &line) { m_lost = line; } // carried out all the same
    int writes() const { return m_writes; }                      // to its EEPROM
    void lose(const QByteArray &key) { m_inForce.erase(key); }

private:
    QByteArray carryOut(const QByteArray &line);
    QByteArray give(const QByteArray &values);

    Values m_stored;
    Values m_given;
    int m_writes = 0;
    QByteArray m_lost;
};

} // namespace codewheel::test
