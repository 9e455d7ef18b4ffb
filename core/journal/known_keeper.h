// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/known_before.h"
#include "vocabulary/place.h"

#include <QObject>
#include <QPointer>

#include <map>
#include <utility>

namespace codewheel {

class EncoderBus;
class EncoderSession;

// What is known of the encoders of a bus outlives its connection, and the loss of its link: each new session
// at a place where there was an encoder of the same kind is given what was known of that one
// (EncoderSession::knownBefore); a simulated one, which is the same, has it at once. One that replaces
// another (EncoderBus::replace()) has nothing of it. Not the mode of a real one: somebody else may have
// switched it meanwhile. In memory only, in the thread of the sessions.
class KnownKeeper : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    void watch(EncoderBus &bus); // from now on, in place of any other
    void forget();               // of real ones, except of those that are connected
    void forgetSimulated();      // they are made anew

private:
    struct Memory
    {
        QString deviceKey;
        KnownBefore known;
    };

    void meetAll();
    void meetAgain();
    void forgetAt(Place place);
    void meet(EncoderSession &encoder);
    void remember(const EncoderSession &encoder);

    QPointer<EncoderBus> m_bus;
    std::map<Place, QPointer<EncoderSession>> m_met;
    using Whose = std::pair<Place, bool>; // of a simulated encoder, or of a real one at the same place
    std::map<Whose, Memory> m_memory;
};

} // namespace codewheel
