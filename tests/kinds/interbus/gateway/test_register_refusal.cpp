// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of registers, in the language of the moment it is shown in: messages are stored.
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/register_refusal.h"
#include "kinds/interbus/gateway/register_texts.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>
#include <QTranslator>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Kind = RegisterError::Kind;

constexpr RegisterBlock someRegisters{0, 8};
constexpr int writesRegisters = 16;

// Another language: everything in capitals.
class Capitals final : public QTranslator
{
public:
    Capitals() { QCoreApplication::installTranslator(this); }
    ~Capitals() override { QCoreApplication::removeTranslator(this); }
    Capitals(const Capitals &) = delete;
    Capitals &operator=(const Capitals &) = delete;

    bool isEmpty() const override { return false; }
    QString translate(const char * /*context*/, const char *source, const char * /*comment*/,
                      int /*n*/) const override
    {
        return QString::fromUtf8(source).toUpper();
    }
};

Refusal refusalOf(const RegisterError &error)
{
    return registerRefusal(error, QStringLiteral("10.0.0.5:502"), writesRegisters, someRegisters, 3);
}

std::vector<RegisterError> errorsOfRegisters()
{
    std::vector<RegisterError> errors{
        {.kind = Kind::noAnswer},
        {.kind = Kind::noAnswer, .isLate = true},
        {.kind = Kind::exception, .exception = 2},
        {.kind = Kind::exception, .exception = 3},
        {.kind = Kind::exception, .exception = 4},
    };
    for (int what = 0; what <= static_cast<int>(WrongAnswer::noPause); ++what)
        errors.push_back(
            {.kind = Kind::wrongAnswer, .text = wrongAnswerKey(static_cast<WrongAnswer>(what), {7, 22})});
    return errors;
}

TEST(RegisterRefusal, IsSaidInTheLanguageItIsShownIn)
{
    for (const RegisterError &error : errorsOfRegisters()) {
        const QString english = refusalText(refusalOf(error));
        const Refusal stored = [&] {
            const Capitals other;
            return refusalOf(error);
        }();
        EXPECT_EQ(refusalText(stored), english);
        const Capitals other;
        EXPECT_EQ(refusalText(stored), english.toUpper());
    }
}

TEST(RegisterRefusal, IsWholeSentencesWithAdvice)
{
    for (const RegisterError &error : errorsOfRegisters()) {
        const QString text = refusalText(refusalOf(error));
        EXPECT_TRUE(text.endsWith(u'.')) << text.toStdString();
        if (error.kind == Kind::wrongAnswer) {
            EXPECT_EQ(text.count(QStringLiteral(". ")), 1) << text.toStdString();
        }
        EXPECT_FALSE(text.contains(u'%')) << text.toStdString();
    }
    EXPECT_EQ(
        refusalText(refusalOf({.kind = Kind::exception, .exception = 4})),
        QStringLiteral("10.0.0.5:502 does not carry out function 16, registers 0 to 7 (exception 4). The "
                       "watchdog of its outputs may have tripped: acknowledge it, then go to Operate "
                       "again."));
}

// As an earlier version has stored it.
TEST(RegisterRefusal, OfAnEarlierVersionIsShownAsItWasStored)
{
    EXPECT_EQ(
        refusalText({RefusalKind::link,
                     GatewayRefusalId::registersGarbled,
                     {QStringLiteral("10.0.0.5:502"), QStringLiteral("function 4, register 1"),
                      QStringLiteral("it is not Modbus")}}),
        QStringLiteral("The answer of 10.0.0.5:502 to function 4, register 1 is wrong: it is not Modbus"));
    EXPECT_EQ(refusalText({RefusalKind::link,
                           GatewayRefusalId::registersRefused,
                           {QStringLiteral("10.0.0.5:502"), QStringLiteral("function 4, register 1"),
                            std::int64_t{6}, QStringLiteral("it is busy.")}}),
              QStringLiteral("10.0.0.5:502 refuses function 4, register 1 with exception 6: it is busy."));
}

} // namespace
} // namespace codewheel
