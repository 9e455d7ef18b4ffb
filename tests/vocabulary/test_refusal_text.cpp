// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/refusal_text.h"
#include "vocabulary/texts_of_kinds.h"

#include <QRegularExpression>
#include <QSet>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Arguments = std::vector<RefusalArgument>;

std::string text(RefusalCode id, Arguments arguments = {})
{
    return refusalText({RefusalKind::device, id, std::move(arguments)}).toStdString();
}

TEST(RefusalText, SaysWhatWasWrongAndWhatWouldBeRight)
{
    const QString fraba = QStringLiteral("FRABA OCD-IB K3");
    struct Row
    {
        RefusalCode id;
        Arguments arguments;
        const char *text;
    };
    const Row rows[] = {
        {RefusalId::valueOutOfRange,
         {Parameter::revolutions, std::int64_t{5000}, std::int64_t{1}, std::int64_t{4096}},
         "Revolutions = 5000 is out of range. Give a value from 1 to 4096."},
        {RefusalId::valueNotAllowed,
         {Parameter::direction, QStringLiteral("%2 left"), QStringLiteral("cw, ccw")},
         "Direction cannot be \"%2 left\". Allowed are: cw, ccw."},
        {RefusalId::parameterNotSupported,
         {Parameter::coding, fraba},
         "The FRABA OCD-IB K3 does not have the parameter \"Coding\". Leave it out, or check which encoder "
         "it is."},
        {RefusalId::serverPortTaken,
         {std::int64_t{15'020}},
         "Port 15020 is used by another program. End it, or take another port."},
        {RefusalId::unknownDevice,
         {QStringLiteral("7.0"), QStringLiteral("1.0, 2.0")},
         "There is no device at 7.0. There are devices at: 1.0, 2.0."},
        {RefusalId::jobRunning,
         {QStringLiteral("1.0")},
         "A job is running at 1.0. Wait for its end, or cancel it."},
        {RefusalId::jobRunning, {}, "A job is running at this encoder. Wait for its end, or cancel it."},
        {RefusalId::noAnswer,
         {2.0, Word{0x0200'00FF}, Word{0x0000'3039}},
         "The encoder did not answer within 2 s (OUT 020000FF, IN 00003039). Check which encoder it is, and "
         "whether it is switched on."},
        {RefusalId::wrongParameterData,
         {Parameter::revolutions, Word{0x8200'0000}},
         "Error 1: the encoder refused the value of Revolutions (IN 82000000). Check the value and write it "
         "again."},
        {RefusalId::wrongParameterData,
         {Parameter::steps, std::int64_t{6}, Word{0x8200'0000}},
         "Error 1: the encoder refused the value of Steps or parameter 6 (IN 82000000). Check the value and "
         "write "
         "it again."},
        {RefusalId::wrongParameterData,
         {Word{0x8200'0000}},
         "Error 1: the encoder refused a value (IN 82000000). Check the values and write them again."},
        {RefusalId::unknownParameterNumber,
         {Parameter::steps, Word{0x0200'03E8}, Word{0x8400'0000}},
         "Error 2: the encoder refused 020003E8, the word for Steps (IN 84000000). Perhaps it is in cam "
         "mode, "
         "where it takes no parameters: switch it to position mode, then try again. If it was in position "
         "mode, check which encoder it is."},
        {RefusalId::presetNotKnown,
         {std::int64_t{1'000}, Word{10}},
         "The preset was sent, but it is not known whether the position was set: position mode would show "
         "1000, but IN is 0000000A, which may be the speed of velocity mode. Compare the position with the "
         "machine, in position mode, before you go on."},
        {RefusalId::verificationFailed,
         {Parameter::steps, std::int64_t{255}, std::int64_t{254}},
         "Steps was written as 255 but read back as 254. Read the encoder before you rely on it, and write "
         "again."},
        // k3.md: "in cam mode this word sets the start of cam 0 to 0"
        {RefusalId::modeNotKnown,
         {Word{0x4000'0000}},
         "Nothing was sent: the mode of the encoder is not known. In cam mode the word 40000000 sets the "
         "start of "
         "cam 0 to 0. Make sure that the encoder is in position mode, and confirm it."},
        {RefusalId::modeNotKnown,
         {Word{0x2040'0001}},
         "Nothing was sent: the mode of the encoder is not known. In cam mode the word 20400001 changes "
         "which cams "
         "are active. Make sure that the encoder is in position mode, and confirm it."},
        {RefusalId::inCamMode,
         {Word{0x6000'0000}},
         "Nothing was sent: the encoder is in cam mode, where the word 60000000 sets the stop of cam 0 to 0. "
         "Switch it to position mode first."},
        {RefusalId::linkFailed, {QStringLiteral("100%1 gone")}, "The link failed: 100%1 gone"},
    };
    for (const Row &row : rows)
        EXPECT_EQ(text(row.id, row.arguments), row.text);
}

// As many arguments as any refusal takes, of the types it may get.
const std::vector<Arguments> anyArguments = {
    {},
    {Word{0x8200'0000}},
    {std::int64_t{1}, std::int64_t{2}, std::int64_t{3}, std::int64_t{4}},
    {Parameter::steps, QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")},
    {1.5, QString(), Word{1}, Parameter::temperature, std::int64_t{-1}, std::int64_t{-2}},
};

TEST(RefusalText, EveryRefusalHasASentenceWhateverItsArguments)
{
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    for (const RefusalCode &code : codesOf(refusalFamilies()))
        for (const Arguments &arguments : anyArguments) {
            const QString sentence = refusalText({RefusalKind::badInput, code, arguments});
            EXPECT_GT(sentence.size(), 10) << code.row().key;
            EXPECT_FALSE(sentence.contains(place)) << sentence.toStdString();
        }
}

TEST(RefusalText, EveryRefusalAndMessageHasAKeyOfItsOwn)
{
    static const QRegularExpression camelCase(QStringLiteral("^[a-z][A-Za-z0-9]*$"));
    QSet<QString> keys;
    const auto refusals = codesOf(refusalFamilies());
    for (const RefusalCode &code : refusals)
        keys << refusalKey(code);
    EXPECT_EQ(keys.size(), std::ssize(refusals));
    QSet<QString> messageKeys;
    const auto messages = codesOf(messageFamilies());
    for (const MessageCode &code : messages)
        messageKeys << messageKey(code);
    EXPECT_EQ(messageKeys.size(), std::ssize(messages));
    for (const QString &key : keys + messageKeys)
        EXPECT_TRUE(camelCase.match(key).hasMatch()) << key.toStdString();
    EXPECT_EQ(refusalKey(RefusalId::valueOutOfRange), QStringLiteral("valueOutOfRange"));
    EXPECT_EQ(refusalKey(RefusalId::busStopped), QStringLiteral("busStopped"));
}

TEST(MessageText, TellsWhatHappened)
{
    const auto told = [](MessageCode id, Arguments arguments = {}, std::optional<Refusal> refusal = {}) {
        return messageText({.id = id, .arguments = std::move(arguments), .refusal = std::move(refusal)})
            .toStdString();
    };
    EXPECT_EQ(told(MessageId::wordWritten, {Word{0x0200'00FF}}), "OUT 020000FF written.");
    EXPECT_EQ(told(MessageId::parametersWritten,
                   {std::int64_t{2}, std::int64_t{2}, QStringLiteral("Steps = 255, Preset = 0")}),
              "Written and activated: Steps = 255, Preset = 0 (parameters: 2, EEPROM writes: 2).");
    EXPECT_EQ(told(MessageId::presetDone, {std::int64_t{12345}, std::int64_t{0}}),
              "Preset initialised: position 12345 before, 0 after.");
    EXPECT_EQ(told(MessageId::presetDone, {QString(), std::int64_t{0}}),
              "Preset initialised: position 0 after.");
    EXPECT_EQ(told(MessageId::presetDone, {QString(), QString()}), "Preset initialised.");
    EXPECT_EQ(told(MessageId::refused, {}, Refusal{RefusalKind::stopped, RefusalId::cancelled, {}}),
              "The job was cancelled.");
    EXPECT_EQ(told(MessageId::training, {QStringLiteral("Shaft of 1.0 turned")}), "Shaft of 1.0 turned");
}

TEST(MessageText, EveryMessageHasASentenceWhateverItsArguments)
{
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    for (const MessageCode &code : codesOf(messageFamilies()))
        for (const Arguments &arguments : anyArguments) {
            const QString sentence = messageText({.id = code, .arguments = arguments});
            EXPECT_FALSE(sentence.isEmpty()) << code.row().key;
            EXPECT_FALSE(sentence.contains(place)) << sentence.toStdString();
        }
}

} // namespace
} // namespace codewheel
