// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/words/word_rules.h"

namespace codewheel {
namespace {

enum class Coding { fixed, notDescribed };

class PositionRules final : public RingRules
{
public:
    PositionRules(PlaceOnRing place, Coding coding)
        : RingRules(std::move(place))
        , m_coding(coding)
    {}

    const WordMeanings *wordMeanings() const override { return &positionMeanings(); }
    bool hasFixedCoding() const override { return m_coding == Coding::fixed; }

private:
    Coding m_coding;
};

} // namespace

const ProtocolRules &k1Rules()
{
    static const PositionRules rules({.inWords = 1, .outWords = 0, .deviceCodes = {0x0136, 0x01B2}},
                                     Coding::fixed);
    return rules;
}

const ProtocolRules &k2Rules()
{
    static const PositionRules rules({.inWords = 2, .outWords = 0, .deviceCodes = {0x0236, 0x02B2}},
                                     Coding::fixed);
    return rules;
}

const ProtocolRules &k4Rules()
{
    static const PositionRules rules({.inWords = 2, .outWords = 2, .deviceCodes = {0x03F7}},
                                     Coding::notDescribed);
    return rules;
}

} // namespace codewheel
