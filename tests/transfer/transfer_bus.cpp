// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/transfer/transfer_bus.h"

namespace codewheel::test {

TransferBus::TransferBus(RingSession::Start start)
{
    EXPECT_TRUE(bus.open(start));
    buses.add(bus);
    for (const Place number : bus.places())
        if (EncoderSession *one = bus.encoder(number))
            QObject::connect(one, &EncoderSession::exchanged, &bus, [this, number](const Exchange &row) {
                std::vector<Word> &words = m_words[number];
                if (row.out != 0 && (words.empty() || words.back() != row.out))
                    words.push_back(row.out);
            });
    encoder(fraba).tell(Parameter::startUpMode, 1);
    encoder(onLoop).tell(Parameter::startUpMode, 1);
    bus.advance(10);
}

void TransferBus::advance(int milliseconds)
{
    for (int i = 0; i < milliseconds && round.isRunning(); ++i)
        bus.advance(1);
}

TransferAccount TransferBus::carryOut(const TransferPlan &plan, JobRound::AfterRefusal afterRefusal)
{
    round.start(jobsOf(plan), afterRefusal);
    advance();
    EXPECT_FALSE(round.isRunning());
    return accountOf(buses, TransferKind::write, plan, round.results());
}

QString TransferBus::words(Place number) const
{
    QStringList texts;
    if (const auto found = m_words.find(number); found != m_words.end())
        for (const Word word : found->second)
            texts << hexWord(word);
    return texts.join(u' ');
}

} // namespace codewheel::test
