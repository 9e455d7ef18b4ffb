// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/word_meanings.h"
#include "kinds/interbus/interbus_protocols.h"
#include "kinds/interbus/meaning/meaning_parts.h"
#include "kinds/interbus/meaning/position_format.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/la66_explain.h"

namespace codewheel {
namespace {

// A request for a value, as it applies to this device: it may have no such parameter, or not accept the
// value. The words alone do not tell.
Meaning forDevice(const DeviceDescription &device, Meaning meaning)
{
    const auto number = static_cast<unsigned>(meaning.number[0]);
    if (meaning.id == MeaningId::parameterRequest) {
        if (!hasNumber(device, number))
            meaning.id = MeaningId::parameterRequestUndefined;
        else if (!takesValue(device, number, meaning.number[1]))
            meaning.id = MeaningId::parameterRequestInvalid;
    } else if (meaning.id == MeaningId::serviceWrite && !takesValue(device, number, meaning.number[1])) {
        meaning.id = MeaningId::serviceWriteInvalid;
    }
    return meaning;
}

Explanation forDevice(const DeviceDescription &device, const Explanation &explanation)
{
    Explanation possible;
    for (const Meaning &meaning : explanation)
        possible.add(forDevice(device, meaning));
    return possible;
}

class InterbusMeanings : public WordMeanings
{
public:
    QStringList parts(const DeviceDescription &device, const Meaning &meaning) const override
    {
        return meaningParts(device, meaning);
    }
    bool answersUnnamed(Word in) const override { return k3::isReadOutAnswer(in); }
};

// Status D31..D29 | parameter number D28..D25 | data D24..D0 by nibbles.
constexpr WordForm k3Form{.bits = 32,
                          .groupStarts = 1U << 29 | 1U << 25 | (WordForm::nibbles & k3::dataMask),
                          .dataBits = k3::dataBits,
                          .commandBits = k3::controlMask};

// Service, read or write, error, 0: D31..D28 | service number D27..D24 | data D23..D0 by nibbles. Nothing
// happens until the service bit is set.
constexpr WordForm la66Form{.bits = 32,
                            .groupStarts = WordForm::nibbles,
                            .dataBits = la66::dataBits,
                            .commandBits = la66::serviceBit};

class K3Meanings final : public InterbusMeanings
{
public:
    Explanation explain(const DeviceDescription &device, Word word, const WordContext &context) const override
    {
        k3::ExplainContext known{context.direction, device.dialect.as<k3::Dialect>(), context.mode,
                                 context.coding, context.counterpart};
        if (!device.mayHaveModes())
            known.mode = Mode::position;
        // A FRABA has a single coding; with a Baumer it is a parameter.
        if (device.dialect == k3::Dialect::fraba && !known.coding)
            known.coding = PositionCoding::binary;
        return forDevice(device, k3::explain(word, known));
    }
    QString bitText(const DeviceDescription &device, WordDirection direction, int bit) const override
    {
        return k3BitText(device, direction, bit);
    }
    WordForm form() const override { return k3Form; }
};

class La66Meanings final : public InterbusMeanings
{
public:
    Explanation explain(const DeviceDescription &device, Word word, const WordContext &context) const override
    {
        return forDevice(device, la66::explain(word, context.direction, context.counterpart));
    }
    QString bitText(const DeviceDescription & /*device*/, WordDirection direction, int bit) const override
    {
        return la66BitText(direction, bit);
    }
    WordForm form() const override { return la66Form; }
};

class PositionMeanings final : public InterbusMeanings
{
public:
    Explanation explain(const DeviceDescription &device, Word word, const WordContext &context) const override
    {
        return position_word::explain(word, context.direction, positionFormat(device));
    }
    QString bitText(const DeviceDescription &device, WordDirection direction, int bit) const override
    {
        return positionBitText(device, direction, bit);
    }
};

} // namespace

const WordMeanings &k3Meanings()
{
    static const K3Meanings meanings;
    return meanings;
}

const WordMeanings &la66Meanings()
{
    static const La66Meanings meanings;
    return meanings;
}

const WordMeanings &positionMeanings()
{
    static const PositionMeanings meanings;
    return meanings;
}

} // namespace codewheel
