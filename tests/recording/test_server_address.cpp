// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/server_address.h"
#include "vocabulary/refusal_text.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

Refusal wrong(const char *text)
{
    const auto address = ServerAddress::parse(QString::fromLatin1(text));
    EXPECT_FALSE(address) << text;
    return address ? Refusal() : address.error();
}

TEST(ServerAddress, HasUserHostPortAndDatabase)
{
    const auto address = ServerAddress::parse(QStringLiteral(
        "postgresql://station%201@db.example.org:5433/test%2Fbench?sslmode=require&recording=codewheel_1"));
    ASSERT_TRUE(address);
    EXPECT_EQ(address->user, QStringLiteral("station 1"));
    EXPECT_EQ(address->host, QStringLiteral("db.example.org"));
    EXPECT_EQ(address->port, 5'433);
    EXPECT_EQ(address->database, QStringLiteral("test/bench"));
    EXPECT_EQ(address->options.at(QStringLiteral("sslmode")), QStringLiteral("require"));
    EXPECT_EQ(address->recording, QStringLiteral("codewheel_1"));
    EXPECT_EQ(address->place(), QStringLiteral("postgresql://station%201@db.example.org:5433/test%2Fbench"));
}

TEST(ServerAddress, IsWrittenAsItIsRead)
{
    for (const char *text :
         {"postgresql://db/all", "postgresql://%2Frun%2Fpostgresql/all", "postgresql://me@[::1]:5432/all",
          "postgresql:///all?connect_timeout=3&recording=a_1"})
        EXPECT_EQ(ServerAddress::parse(QString::fromLatin1(text))->text(), QString::fromLatin1(text));
}

TEST(ServerAddress, APasswordIsRefusedAndNeverRepeated)
{
    for (const char *text : {"postgresql://me:secret@db/all", "postgresql://me:s@secret@db/all",
                             "postgresql://db/all?password=secret", "postgresql://db/all?passfile=secret"}) {
        EXPECT_EQ(wrong(text).id, RefusalId::passwordInAddress) << text;
        EXPECT_THAT(refusalText(wrong(text)).toStdString(), HasSubstr("PGPASSFILE"));
    }
    for (const char *text : {"postgresql://me:sec/secret@db/all", "postgresql://me:5432?secret@db/all"})
        EXPECT_THAT(refusalText(wrong(text)).toStdString(), Not(HasSubstr("sec")));
}

// It would wait for ever for a server that no one can set up.
TEST(ServerAddress, ANameThatCannotExistIsRefusedAtOnce)
{
    for (const char *host : {"no%20such%20host", "-plant", "plant-", "a..b", ".plant", "a,b", "a%2Cb",
                             "plant%0A", "a%3Db", "plant!"})
        EXPECT_FALSE(ServerAddress::parse(QStringLiteral("postgresql://%1/db").arg(QLatin1String(host))))
            << host;
    const QString longLabel(64, u'a');
    EXPECT_FALSE(ServerAddress::parse(QStringLiteral("postgresql://%1/db").arg(longLabel)));
    EXPECT_FALSE(ServerAddress::parse(QStringLiteral("postgresql://plant/%1").arg(longLabel)));
    for (const char *host : {"plant", "plant.example.org.", "10.0.0.7", "[::1]", "hall_3", "h%C3%A4lle-7", "",
                             "%2Frun%2Fpostgresql", "3hall"})
        EXPECT_TRUE(ServerAddress::parse(QStringLiteral("postgresql://%1/db").arg(QLatin1String(host))))
            << host;
}

TEST(ServerAddress, WhatIsWrongIsSaid)
{
    for (const char *text :
         {"http://db/all", "postgresql://db", "postgresql://db/", "postgresql://db:70000/all",
          "postgresql://db:x/all", "postgresql://db/all?options=-c",
          "postgresql://db/all?sslmode=a%20host=other", "postgresql://db/all?recording=A;B"})
        EXPECT_EQ(wrong(text).id, RefusalId::serverAddressWrong) << text;
}

} // namespace
} // namespace codewheel
