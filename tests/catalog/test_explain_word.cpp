// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/explain_word.h"
#include "kinds/interbus/words/k3_word.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr WordContext positionOut{WordDirection::out, Mode::position, {}, {}};
constexpr WordContext positionIn{WordDirection::in, Mode::position, {}, {}};

class ExplainWord : public testing::Test
{
protected:
    std::string text(const DeviceDescription &device, Word word, const WordContext &context) const
    {
        return explanationText(device, explainWord(device, word, context)).toStdString();
    }
    // Together with the word of the other direction.
    std::string inBeside(const DeviceDescription &device, Word word, Word counterpart,
                         Mode mode = Mode::position)
    {
        return text(device, word, {WordDirection::in, mode, {}, counterpart});
    }

    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = *catalog.find(u"fraba-ocd-ib");
    const DeviceDescription &baumer = *catalog.find(u"baumer-gxp6w");
    const DeviceDescription &generic = *catalog.find(u"generic-k3");
    const DeviceDescription &rod = *catalog.find(u"tr-la66");
};

// The rows of the FRABA appendix are in test_fraba_appendix.cpp; here is what stands between them.
TEST_F(ExplainWord, OutWordsOfFraba)
{
    EXPECT_EQ(text(fraba, 0x8200'0000, positionOut), "Run; the other bits (02000000) are ignored");
    EXPECT_EQ(text(fraba, 0x0600'0005, positionOut), "Parameter 3 direction = 5 (there are only 3, 4)");
    EXPECT_EQ(text(fraba, 0x0E00'0001, positionOut), "Parameter 7 = 1");
}

TEST_F(ExplainWord, InWordsOfFraba)
{
    EXPECT_EQ(text(fraba, 0x0001'2A4F, positionIn), "Running, position 76367");
    EXPECT_EQ(text(fraba, 0xC200'00FF, positionIn), "Parameter 1 steps = 255 confirmed");
    EXPECT_EQ(inBeside(fraba, 0xC200'00FF, 0x0400'0001), "Old confirmation: parameter 1 steps = 255");
    EXPECT_EQ(inBeside(fraba, 0xA000'FFCE, 0x2021'000C), "Read-out: temperature = -5.0 °C");
    EXPECT_EQ(inBeside(fraba, 0xA1FF'FFCE, 0x2021'000C), "Read-out: temperature = -5.0 °C");
    EXPECT_EQ(inBeside(fraba, 0xA000'0009, 0x2021'0008), "Read-out: operating time = 1.5 h");
    EXPECT_EQ(inBeside(fraba, 0xA000'0005, 0x2021'0009), "Read-out: start-up mode = 5 (cam program 3)");
    EXPECT_EQ(text(fraba, 0xA000'2000, positionIn), "Self test, or read-out of 8192");
    EXPECT_EQ(text(fraba, 0x9800'0017, positionIn), "Manufacturer's error 23");
    EXPECT_EQ(text(fraba, 0x9800'0100, positionIn), "Error 12: an error of the manufacturer's own");
    EXPECT_EQ(text(fraba, 0x4000'0000, positionIn), "D31 D30 = 01: a state that no manual describes");
}

TEST_F(ExplainWord, CamWordsOfFraba)
{
    WordContext cam = positionOut;
    cam.mode = Mode::cam;
    EXPECT_EQ(text(fraba, 0x2040'0000, cam), "Active cams: none");
    EXPECT_EQ(inBeside(fraba, 0x0000'2008, 0x8000'0000, Mode::cam), "Running, cams on: 3, position part 32");
}

TEST_F(ExplainWord, UnknownModeGivesEachMeaning)
{
    EXPECT_EQ(text(fraba, 0x4000'0000, {WordDirection::out, {}, {}, {}}),
              "Initialise the preset, or: Start of cam 0 = 0");
    EXPECT_EQ(text(fraba, 0x0000'0101, {WordDirection::in, {}, {}, {}}),
              "Running, position 257, or: speed 257 rpm, or: cams on: 0, position part 1");
    // no modes, no doubt
    EXPECT_EQ(text(baumer, 0x4000'0000, {WordDirection::out, {}, {}, {}}), "Initialise the preset");
}

TEST_F(ExplainWord, WordsOfBaumer)
{
    EXPECT_EQ(text(baumer, 0xCE00'0000, positionIn), "Parameter 7 = 0 (reset to factory settings) confirmed");
    EXPECT_EQ(text(baumer, 0x0600'0003, positionOut), "Parameter 3 coding = 3 (unsigned, CW)");
    EXPECT_EQ(text(baumer, 0x1E00'1000, positionOut), "Parameter 15 measuring range = 4096");
    EXPECT_EQ(text(baumer, 0x2200'00FF, positionOut), "Parameter 1 steps = 255 (D29 is ignored)");
    EXPECT_EQ(inBeside(baumer, 0xC000'4E20, 0x0400'4E20), "Processing, data 20000");
    EXPECT_EQ(text(baumer, 0x9C00'0000, positionIn), "Error 14: battery low");
    EXPECT_EQ(text(baumer, 0x8800'0000, positionIn), "Error 4: not defined for this encoder");
    // Its coding is a parameter, which is not given here.
    EXPECT_EQ(text(baumer, 0x0001'2A4F, positionIn),
              "Running, position 00012A4F in a coding that is not known");
    WordContext decoded = positionIn;
    decoded.coding = PositionCoding::signedBinary;
    EXPECT_EQ(text(baumer, 0x01FF'FFFF, decoded), "Running, position -1 (signed)");
}

// FRABA's manual has 1 to 5 and 7, Baumer's also 6 and 15.
TEST_F(ExplainWord, AParameterThatTheEncoderHasNotIsSaidToBeUndefined)
{
    for (const unsigned number : {6U, 8U, 9U, 14U, 15U}) {
        const Explanation asked = explainWord(fraba, k3::parameterWord(number, 1), positionOut);
        EXPECT_EQ(asked, (Meaning{MeaningId::parameterRequestUndefined, {number, 1}})) << number;
    }
    EXPECT_EQ(text(fraba, 0x0C00'0005, positionOut), "Parameter 6 (not defined for this encoder) = 5");
    EXPECT_EQ(text(fraba, 0xD000'0001, positionIn),
              "Parameter 8 (not defined for this encoder) = 1 confirmed");
    EXPECT_EQ(text(baumer, 0x1000'0001, positionOut), "Parameter 8 (not defined for this encoder) = 1");
    EXPECT_EQ(text(baumer, 0x0C00'0005, positionOut), "Parameter 6 offset = 5");
    EXPECT_EQ(explainWord(baumer, 0x0C00'0005, positionOut).first().id, MeaningId::parameterRequest);
    EXPECT_EQ(explainWord(fraba, 0x0E00'0000, positionOut).first().id, MeaningId::resetToDefault);
    EXPECT_EQ(explainWord(fraba, 0x0E00'0001, positionOut).first().id, MeaningId::parameterRequest);
}

TEST_F(ExplainWord, AValueOutOfRangeIsSaidToBe)
{
    EXPECT_EQ(text(baumer, 0x0400'4E20, positionOut), "Parameter 2 revolutions = 20000 (outside 1 to 4096)");
    EXPECT_EQ(explainWord(baumer, 0x0400'4E20, positionOut),
              (Meaning{MeaningId::parameterRequestInvalid, {2, 20'000}}));
    EXPECT_EQ(text(baumer, 0xC400'4E20, positionIn),
              "Parameter 2 revolutions = 20000 (outside 1 to 4096) confirmed");
    EXPECT_EQ(text(baumer, 0x0200'0000, positionOut), "Parameter 1 steps = 0 (outside 1 to 33554431)");
    EXPECT_EQ(text(baumer, 0x0600'0007, positionOut),
              "Parameter 3 coding = 7 (there are only 1, 2, 3, 4, 5, 6)");
    EXPECT_EQ(text(baumer, 0x2400'4E20, positionOut),
              "Parameter 2 revolutions = 20000 (outside 1 to 4096) (D29 is ignored)");
    EXPECT_EQ(explainWord(baumer, 0x1E00'1000, positionOut).first().id, MeaningId::parameterRequest);
    EXPECT_EQ(explainWord(baumer, 0x1E00'1001, positionOut).first().id, MeaningId::parameterRequestInvalid);
    EXPECT_EQ(text(fraba, 0x0400'0000, positionOut), "Parameter 2 revolutions = 0 (outside 1 to 4096)");
    EXPECT_EQ(inBeside(fraba, 0xC400'1001, 0x0600'0003),
              "Old confirmation: parameter 2 revolutions = 4097 (outside 1 to 4096)");
    EXPECT_EQ(explainWord(fraba, 0x0200'0000, positionOut).first().id, MeaningId::parameterRequest)
        << "one step, to an encoder that counts steps minus 1";
    EXPECT_EQ(inBeside(fraba, 0xA000'0002, 0x2021'0006), "Read-out: preset flag = 2 (there are only 0, 1)");
    EXPECT_EQ(inBeside(fraba, 0xA000'1001, 0x2021'0002), "Read-out: revolutions = 4097 (outside 1 to 4096)");
    EXPECT_EQ(inBeside(fraba, 0xA000'0001, 0x2021'0003), "Read-out: direction = 1");
}

// The limits are those of the description, which may be narrower than the service's.
TEST_F(ExplainWord, ARodRefusesWhatItsDescriptionDoes)
{
    DeviceDescription shorter = rod;
    for (ParameterDescription &each : shorter.parameters)
        if (each.parameter == Parameter::measuringLength)
            each.maximum = 1'000;
    EXPECT_EQ(explainWord(shorter, 0x4200'03E8, positionOut).first().id, MeaningId::serviceWrite);
    EXPECT_EQ(explainWord(shorter, 0x4200'03E9, positionOut).first().id, MeaningId::serviceWriteInvalid);
}

TEST_F(ExplainWord, WordsOfAnUnnamedK3)
{
    EXPECT_EQ(text(generic, 0x0200'00FF, positionOut), "Parameter 1 steps = 255");
    EXPECT_EQ(text(generic, 0x0600'0003, positionOut), "Parameter 3 = 3");
    EXPECT_EQ(text(generic, 0x1E00'0003, positionOut), "Parameter 15 = 3") << "as a Baumer has it";
    EXPECT_EQ(text(generic, 0x1000'0001, positionOut), "Parameter 8 (not defined for this encoder) = 1");
    EXPECT_EQ(text(generic, 0x2021'0001, positionOut),
              "Manufacturer specific (D29), and the make is not known");
}

// An unnamed one may be a FRABA; a named one has the modes of its description.
TEST_F(ExplainWord, AnUnnamedK3MayHaveModes)
{
    const WordContext untold{WordDirection::out, {}, {}, {}};
    for (const DeviceDescription *unnamed : {&generic, catalog.find(u"generic-k3-loop2")}) {
        EXPECT_TRUE(unnamed->mayHaveModes());
        EXPECT_EQ(text(*unnamed, 0x4000'0000, untold), "Initialise the preset, or: Start of cam 0 = 0");
    }
    EXPECT_EQ(text(generic, 0x6000'0000, untold),
              "Manufacturer specific (D29), and the make is not known, or: FRABA preset: activate the preset "
              "in every cycle, or: Stop of cam 0 = 0");
    EXPECT_EQ(text(generic, 0x0000'0101, {WordDirection::in, {}, {}, {}}),
              "Running, position 00000101 in a coding that is not known, or: speed 257 rpm, or: cams on: 0, "
              "position part 1");
    EXPECT_EQ(text(generic, 0x4000'0000, positionOut), "Initialise the preset");
    for (const char *key : {"baumer-gxp6w", "twk-k3"}) {
        const DeviceDescription &named = *catalog.find(QString::fromLatin1(key));
        EXPECT_FALSE(named.mayHaveModes()) << key;
        EXPECT_EQ(text(named, 0x4000'0000, untold), "Initialise the preset") << key;
    }
    for (const char *key : {"generic-k1", "generic-k2", "generic-k4"})
        EXPECT_FALSE(catalog.find(QString::fromLatin1(key))->mayHaveModes()) << key;
}

TEST_F(ExplainWord, WordsOfARod)
{
    EXPECT_EQ(text(rod, 0x4200'C350, positionOut),
              "Service 2 measuring length in steps: write 50000, service bit 0");
    EXPECT_EQ(text(rod, 0xC200'C350, positionOut),
              "Service 2 measuring length in steps: write 50000, service bit 1");
    EXPECT_EQ(text(rod, 0x8200'0000, positionOut),
              "Service 2 measuring length in steps: read, service bit 1");
    EXPECT_EQ(text(rod, 0xC100'0001, positionOut),
              "Service 1 direction: write 1 (decreasing), service bit 1");
    EXPECT_EQ(text(rod, 0xC600'03E8, positionOut), "Service 6 preset adjustment: write 1000, service bit 1");
    EXPECT_EQ(text(rod, 0xC200'0000, positionOut),
              "Service 2 measuring length in steps: write 0, service bit 1; the encoder refuses this value");
    EXPECT_EQ(text(rod, 0xC300'0000, positionOut), "Not defined for this encoder");
    EXPECT_EQ(text(rod, 0x0000'3039, positionIn), "Running, position 12345");
    EXPECT_EQ(text(rod, 0x2000'3039, positionIn),
              "Error bit: the magnet is or was outside the measuring range; position 12345");
    EXPECT_EQ(text(rod, 0xC200'C350, positionIn), "Service 2 measuring length in steps: 50000 written");
    EXPECT_EQ(text(rod, 0x8400'1388, positionIn), "Service 4 external preset: 5000 read");
    EXPECT_EQ(text(rod, 0x8800'0020, positionIn),
              "Service 8 error status: 32 (magnet outside the measuring range) read");
    EXPECT_EQ(text(rod, 0xE100'0002, positionIn),
              "Refused: Service 1 direction: write 2, service bit 1; the encoder refuses this value");
    EXPECT_EQ(text(rod, 0xA600'0000, positionIn), "Refused: Not defined for this encoder");
    EXPECT_EQ(inBeside(rod, 0x8100'0000, 0x8800'0000), "Old answer: service 1 direction, 0 (increasing)");
}

TEST_F(ExplainWord, WordsOfEncodersThatOnlyTellTheirPosition)
{
    const DeviceDescription &k1 = *catalog.find(u"fraba-ocd-ib-k1");
    EXPECT_EQ(text(k1, 0x0000'0FFF, positionIn), "Running, position 4095");
    EXPECT_EQ(text(k1, 0x0000'9800, positionIn),
              "No position: D15, D12 should be 0, since the position has 12 bits");
    EXPECT_EQ(text(k1, 0x0200'00FF, positionOut), "This encoder has no OUT word: it only sends its position");
    const DeviceDescription &k2 = *catalog.find(u"fraba-ocd-ib-k2");
    EXPECT_EQ(text(k2, 0x00FF'FFFF, positionIn), "Running, position 16777215");
    EXPECT_EQ(text(k2, 0x0100'0000, positionIn),
              "No position: D24 should be 0, since the position has 24 bits");
    EXPECT_EQ(text(*catalog.find(u"generic-k2"), 0x01FF'FFFF, positionIn), "Running, position 33554431");
    EXPECT_EQ(text(*catalog.find(u"twk-k2"), 0xC200'0005, positionIn),
              "No position: D31, D30, D25 should be 0, since the position has 25 bits");
    const DeviceDescription &k4 = *catalog.find(u"twk-k4");
    EXPECT_EQ(
        text(k4, 0x0001'2A4F, positionIn),
        "Running, position 76367, as long as all four status bits are 0: no source says where they stand");
    EXPECT_EQ(text(k4, 0x0200'00FF, positionOut), "No source describes the OUT word of a K4 encoder");

    DeviceDescription coded = k2;
    coded.coding = PositionCoding::gray;
    EXPECT_EQ(text(coded, 0x0000'0214, positionIn), "Running, position 999 (Gray code 00000214)");
    coded.coding = PositionCoding::signedBinary;
    EXPECT_EQ(text(coded, 0x00FF'FFFF, positionIn), "Running, position -1 (signed)");
}

TEST_F(ExplainWord, BitsAreNamedAsInTheManual)
{
    const auto bit = [](const DeviceDescription &device, WordDirection direction, int number) {
        return bitText(device, direction, number).toStdString();
    };
    EXPECT_EQ(bit(baumer, WordDirection::out, 31), "D31: start (run), when it changes from 0 to 1");
    EXPECT_EQ(bit(baumer, WordDirection::out, 25), "D28..D25: parameter number");
    EXPECT_EQ(bit(baumer, WordDirection::out, 24), "D24..D0: parameter data");
    EXPECT_EQ(bit(baumer, WordDirection::out, 29), "D29: ignored by this encoder");
    EXPECT_EQ(bit(baumer, WordDirection::out, 30), "D30: initialise the preset");
    EXPECT_EQ(bit(generic, WordDirection::out, 30),
              "D30: initialise the preset; in cam mode: start or stop of a cam");
    EXPECT_EQ(bit(generic, WordDirection::in, 29), "D29: manufacturer specific");
    EXPECT_EQ(bit(fraba, WordDirection::in, 28), "D28..D25: parameter number, or error number");
    EXPECT_EQ(bit(rod, WordDirection::out, 31), "D31: service bit, asks when it changes from 0 to 1");
    EXPECT_EQ(bit(rod, WordDirection::in, 29), "D29: error");
    EXPECT_EQ(bit(rod, WordDirection::out, 24), "D27..D24: service number");
    EXPECT_EQ(bit(rod, WordDirection::out, 23), "D23..D0: data to write");
    const DeviceDescription &k1 = *catalog.find(u"fraba-ocd-ib-k1");
    EXPECT_EQ(bit(k1, WordDirection::in, 11), "D11..D0: position");
    EXPECT_EQ(bit(k1, WordDirection::in, 12), "D12: not used, always 0");
    EXPECT_EQ(bit(k1, WordDirection::out, 31), "D31: this encoder has no OUT word");
    EXPECT_EQ(bit(*catalog.find(u"twk-k4"), WordDirection::in, 31),
              "D31..D0: position; no source says which four bits are status bits");
    EXPECT_EQ(bit(*catalog.find(u"twk-k4"), WordDirection::out, 31), "D31..D0: no source describes them");
    for (const DeviceDescription &device : catalog.devices())
        for (const WordDirection direction : {WordDirection::in, WordDirection::out}) {
            for (int i = 0; i < 32; ++i)
                EXPECT_EQ(bitText(device, direction, i).startsWith(u'D'), device.hasWords()) << i;
            EXPECT_TRUE(bitText(device, direction, -1).isEmpty());
            EXPECT_TRUE(bitText(device, direction, 32).isEmpty());
        }
}

} // namespace
} // namespace codewheel
