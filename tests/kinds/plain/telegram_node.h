// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/kinds/plain/plain_peer.h"

#include <set>

namespace codewheel::test {

// A second kind of encoder on the bus of the tests' own, as a peer. It is given all its values in one line,
// "all steps=100 direction=0 2000:1=-5 1008=Hoist", takes all of it or nothing ("no steps"), tells none of
// them, and keeps none without supply. Asked by "at" it answers "at 500", or "none" as long as it has only
// the values of the factory.
class TelegramNode final : public PlainPeer
{
public:
    explicit TelegramNode(const Values &factory)
        : PlainPeer(factory)
        , m_factory(factory)
    {}

    QByteArray answer(const QByteArray &line) override;
    void switchOffAndOn() override;
    void refuse(const QByteArray &key) { m_refused.insert(key); }

private:
    QByteArray take(const QByteArray &values);

    const Values m_factory;
    bool m_isGiven = false;
    std::set<QByteArray> m_refused; // whatever their value
};

} // namespace codewheel::test
