// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/protocol_rules.h"

#include <vector>

namespace codewheel {

// How an encoder with words shows itself on a ring (FRABA manual 2.2).
struct PlaceOnRing
{
    int inWords = 2; // 16 bit each
    int outWords = 2;
    std::vector<unsigned> deviceCodes; // length code << 8 | ID code; remote bus, then Loop 2
};

// For encoders in the process image of a ring.
class RingRules : public ProtocolRules
{
public:
    explicit RingRules(PlaceOnRing place)
        : m_place(std::move(place))
    {}

    bool hasWords() const override { return true; }
    void readPlaceOnBus(const JsonObject &json, DeviceDescription &device) const override;

private:
    void checkCodes(const JsonObject &json, const DeviceDescription &device) const;
    void checkWordCounts(const JsonObject &json, const DeviceDescription &device) const;

    PlaceOnRing m_place;
};

// For those that receive values in words.
class WordRules : public RingRules
{
public:
    using RingRules::RingRules;

    bool hasParameters() const override { return true; }

    void readReach(const JsonObject &row, ParameterDescription &parameter,
                   const DeviceDescription &before) const override;
    ReachText reachText(const ParameterDescription &parameter) const override;
    void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                        const DeviceDescription &device) const override;

private:
    virtual void checkWords(const JsonObject &row, const ParameterDescription &parameter,
                            const DeviceDescription &device) const = 0;
    void checkRange(const JsonObject &row, const ParameterDescription &parameter) const;
};

} // namespace codewheel
