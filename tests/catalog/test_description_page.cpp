// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "tests/support/breakage.h"

#include <QFile>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// The names known to the reader, as it lists them on meeting an unknown one instead of `from`.
QStringList namesKnownInPlaceOf(const char *from, const char *to)
{
    QFile file(QStringLiteral(CODEWHEEL_ROOT "/resources/devices/tr-la66.json"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray json = brokenBy({.from = from, .to = to, .line = 0, .key = "", .reason = ""},
                                     file.readAll(), Occurs::firstOfSeveral);
    const auto added = Catalog().add(json, QString());
    EXPECT_FALSE(added);
    const QString intro = QStringLiteral("Known are: ");
    const QString reason = added ? QString() : added.error().reason;
    EXPECT_TRUE(reason.contains(intro)) << from << ": " << reason.toStdString();
    QStringList names = reason.mid(reason.indexOf(intro) + intro.size()).split(QStringLiteral(", "));
    names.last().chop(1); // the full stop
    return names;
}

bool standsOnThePage(const QString &page, const QString &name)
{
    return page.contains(u'`' + name + u'`');
}

TEST(DescriptionPage, NamesEverythingTheReaderKnows)
{
    QFile page(QStringLiteral(CODEWHEEL_ROOT "/docs/device-descriptions.md"));
    ASSERT_TRUE(page.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    struct Row
    {
        const char *from; // in the description of the LA-66
        qsizetype names;
        const char *to = R"("nonsense")";
    };
    const Row rows[] = {
        {R"("manual")", 30},                                      // the device
        {R"("profile": "LA-66")", 7, R"("profile": "nonsense")"}, // profiles
        {R"("direction")", 29},                                   // parameters
        {R"("readOut")", 21},                                     // a parameter
        {R"("micrometres")", 8},                                  // units
        {R"("magnetOutOfRange")", 9},                             // meanings of errors
        {R"("text")", 4},                                         // an error
        {R"("presetNeedsValue")", 11},                            // capabilities
        {R"("hasModes")", 4},                                     // quirks
    };
    for (const Row &row : rows) {
        const QStringList names = namesKnownInPlaceOf(row.from, row.to);
        EXPECT_EQ(names.size(), row.names) << row.from;
        for (const QString &name : names)
            EXPECT_TRUE(standsOnThePage(text, name)) << name.toStdString();
    }
}

} // namespace
} // namespace codewheel
