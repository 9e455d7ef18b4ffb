// SPDX-License-Identifier: GPL-3.0-or-later
// Several concurrent calls of the program on the same files.
#include "journal/ledger.h"
#include "project/project_file.h"
#include "tests/support/places.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <array>
#include <gtest/gtest.h>
#include <memory>

namespace codewheel {
namespace {

class ParallelCalls : public testing::Test
{
protected:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    QStringList names() const
    {
        return QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }
    void start(const QStringList &words)
    {
        m_calls.push_back(std::make_unique<QProcess>());
        m_calls.back()->setStandardInputFile(QProcess::nullDevice());
        m_calls.back()->start(QStringLiteral(CODEWHEEL_CLI), words);
    }
    // The JSON answer of each.
    std::vector<QJsonObject> ended()
    {
        std::vector<QJsonObject> answers;
        for (const auto &call : m_calls) {
            EXPECT_TRUE(call->waitForFinished(120'000));
            answers.push_back(QJsonDocument::fromJson(call->readAllStandardOutput()).object());
        }
        m_calls.clear();
        return answers;
    }

private:
    QTemporaryDir m_folder;
    std::vector<std::unique_ptr<QProcess>> m_calls;
};

TEST_F(ParallelCalls, CountEachWrite)
{
    constexpr int times = 12;
    for (int i = 0; i < times; ++i)
        start({QStringLiteral("write"), QStringLiteral("1.0"), QStringLiteral("steps=255"),
               QStringLiteral("--yes"), QStringLiteral("--json"), QStringLiteral("--ledger"),
               path("ledger.sqlite")});
    for (const QJsonObject &answer : ended())
        EXPECT_EQ(answer[u"exit"], 0);
    int writes = 0;
    for (const Ledger::Account &account :
         Ledger::open(DatabasePlace::file(path("ledger.sqlite")))->accounts())
        writes += account.count.writes;
    EXPECT_EQ(writes, times);
    EXPECT_EQ(names(), QStringList{QStringLiteral("ledger.sqlite")});
}

TEST_F(ParallelCalls, NoReplacementInAProjectIsLostThatWasToldToBeDone)
{
    const QString project = path("crane.codewheel");
    ASSERT_TRUE(QFile::copy(QStringLiteral(CODEWHEEL_ROOT "/docs/examples/training.codewheel"), project));
    const std::array<Place, 3> places{"1.0"_ring, "2.0"_ring, "6.1"_ring};
    for (int round = 0; round < 8; ++round) {
        const QString serial = QString::number(1000 + round);
        for (const Place place : places)
            start({QStringLiteral("replace"), place.toString(), QStringLiteral("--project"), project,
                   QStringLiteral("--serial"), serial, QStringLiteral("--yes"), QStringLiteral("--json")});
        const auto answers = ended();
        const auto saved = loadProject(project);
        ASSERT_TRUE(saved);
        int done = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool isDone = answers[i][u"error"][u"key"] != QStringLiteral("fileChanged");
            const ProjectDevice *device = findDevice(*saved, places[i]);
            ASSERT_NE(device, nullptr);
            EXPECT_EQ(device->label.serialNumber == serial, isDone)
                << places[i].toString().toStdString() << QJsonDocument(answers[i]).toJson().toStdString();
            done += isDone ? 1 : 0;
        }
        EXPECT_GT(done, 0) << "somebody is the first";
    }
    EXPECT_EQ(names(), (QStringList{QStringLiteral("crane.codewheel"), QStringLiteral("crane.codewheel~")}));
}

} // namespace
} // namespace codewheel
