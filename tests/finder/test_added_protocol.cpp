// SPDX-License-Identifier: GPL-3.0-or-later
// What a kind of bus that the program does not know speaks on serial lines. In a program of its own, since
// whatever was added is spoken to its end.
#include "finder/listening.h"
#include "finder/port_finder.h"
#include "tests/kinds/esc/line/scripted_line.h"
#include "tests/kinds/plain/plain_kind.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QByteArray plainRequest = "who?\n";
const QByteArray plainAnswer = "plain n:1\n";

SerialSettings plainSettings()
{
    SerialSettings settings;
    settings.baudRate = 31'250; // at which nobody else speaks
    return settings;
}

Found plainAt(const QString &place)
{
    return {.kind = QStringLiteral("plain"),
            .place = place,
            .settings = formatText(plainSettings()),
            .sentence = QStringLiteral("A plain node"),
            .plan = KindData(24),
            .link = QStringLiteral("plain:") + place};
}

class PlainAsking final : public Asking
{
public:
    explicit PlainAsking(QString place)
        : m_place(std::move(place))
    {}

    bool isDone() const override { return m_isDone; }
    SerialSettings settings() const override { return plainSettings(); }
    QString doing() const override { return QStringLiteral("Asks plainly."); }
    Result<Asked> step(ByteLink &link, const std::atomic<bool> &isStopped) override
    {
        constexpr Instant patience{50'000};
        m_isDone = true;
        if (const auto written = link.write(plainRequest); !written)
            return tl::unexpected(written.error());
        const auto heard = hearUntil(link, link.now() + patience, isStopped);
        if (!heard)
            return tl::unexpected(heard.error());
        return *heard == plainAnswer ? Asked{.found = plainAt(m_place)} : Asked{.others = {*heard}};
    }

private:
    const QString m_place;
    bool m_isDone = false;
};

class PlainProtocol final : public SpokenProtocol
{
public:
    QString name() const override { return QStringLiteral("Plain"); }
    std::vector<SerialSettings> usualSettings() const override { return {plainSettings()}; }
    std::optional<Found> heard(const QString &place, const SerialSettings &settings,
                               const QByteArray &bytes) const override
    {
        if (settings != plainSettings() || !bytes.contains(plainAnswer))
            return std::nullopt;
        Found found = plainAt(place);
        found.isMasterAtWork = true;
        return found;
    }
    QString announcement() const override { return QStringLiteral("Plain: one question."); }
    std::unique_ptr<Asking> ask(const QString &place) const override
    {
        return std::make_unique<PlainAsking>(place);
    }
};

class AddedProtocol : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        addBusKind(std::make_unique<test::PlainKind>());
        addSpokenProtocol(std::make_unique<PlainProtocol>());
    }
    std::vector<Found> found()
    {
        PortFinder finder(link, true);
        std::vector<Found> all;
        while (!finder.isDone())
            if (const FinderNews news = finder.next(); news.found)
                all.push_back(*news.found);
        return all;
    }
    bool wasSent(const QByteArray &bytes) const
    {
        return std::ranges::find(link.sent, bytes, &ScriptedLink::Sent::bytes) != link.sent.end();
    }

    ScriptedLink link;
};

TEST_F(AddedProtocol, IsAnnouncedWithTheOthers)
{
    const QStringList all = askingAnnouncements({QStringLiteral("/dev/ttyUSB0")});
    EXPECT_TRUE(all.front().startsWith(u"Kübler ESC: "));
    EXPECT_EQ(all.back(), QStringLiteral("Plain: one question."));
}

TEST_F(AddedProtocol, IsListenedForWithItsSettings)
{
    link.chatter = plainAnswer;
    const auto heard = found();
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0].kind, QStringLiteral("plain"));
    EXPECT_EQ(heard[0].settings, formatText(plainSettings()));
    EXPECT_TRUE(heard[0].isMasterAtWork);
    EXPECT_TRUE(link.sent.empty()) << "somebody talks";
}

TEST_F(AddedProtocol, IsAskedAndConnectsAsItsKind)
{
    link.answersAt = plainSettings().baudRate;
    link.answers[plainRequest] = plainAnswer;
    const auto answered = found();
    ASSERT_EQ(answered.size(), 1U);
    EXPECT_EQ(answered[0].link, QStringLiteral("plain:scripted line"));
    EXPECT_FALSE(answered[0].isMasterAtWork);
    ASSERT_NE(busKind(answered[0].kind), nullptr);
    EXPECT_EQ(answered[0].plan, KindData(24)) << "what is planned of such a bus";
}

TEST_F(AddedProtocol, IsNotSpokenWhereAnotherIs)
{
    link.answersAt = 9'600;
    link.answers[QByteArray::fromHex("02040000000131f9")] = QByteArray::fromHex("0204021234f047");
    const auto answered = found();
    ASSERT_EQ(answered.size(), 1U);
    EXPECT_EQ(answered[0].kind, QStringLiteral("interbus"));
    EXPECT_FALSE(wasSent(plainRequest));
}

} // namespace
} // namespace codewheel
