// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/dcf_writer.h"
#include "tests/kinds/canopen/eds/file_literal.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace codewheel::canopen {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

// One row an object: what it is called, its type, access, limits and default.
// Left out is what the package "canopen" of npm reads otherwise than CiA 306 has it
// (findings/npm-canopen-eds.sh): values that $NODEID is added to, limits of 0, and the count of subindexes,
// of which it makes one of its own.
constexpr const char *npmScript = R"JS(
const { Eds } = require('canopen');
const limit = (value) => value || '-';
const told = (entry) => {
    const given = entry.defaultValue;
    return given === undefined || given === '' || /nodeid/i.test(given) ? '-' : entry.value;
};
const row = (index, sub, entry) => console.log([index, sub, entry.parameterName, entry.dataType, entry.accessType,
    limit(entry.lowLimit), limit(entry.highLimit), told(entry)].join('|'));
const eds = Eds.fromFile(process.argv[1]);
for (const entry of Object.values(eds.dataObjects)) {
    if (entry.dataType !== undefined)
        row(entry.index, 0, entry);
    else
        for (let sub = 1; sub < 256; ++sub)
            if (entry.at(sub))
                row(entry.index, sub, entry.at(sub));
}
)JS";

QString limitText(const std::optional<FileValue> &limit)
{
    const bool isTold = limit && limit->number() != nullptr && *limit->number() != 0;
    return isTold ? QString::number(*limit->number()) : QStringLiteral("-");
}

QString rowOf(const FileObject &object)
{
    const bool isTold = object.factory && !object.factory->addsNode;
    return QStringList{QString::number(object.object.index),
                       QString::number(object.object.sub),
                       object.name,
                       QString::number(static_cast<int>(*object.type)),
                       fileAccessKey(*object.access),
                       limitText(object.minimum),
                       limitText(object.maximum),
                       isTold ? object.factory->text(object.type) : QStringLiteral("-")}
        .join(u'|');
}

bool isCountOfSubindexes(const DeviceFile &file, const FileObject &object)
{
    constexpr int variable = 7;
    const auto group = file.groups.find(object.object.index);
    return object.object.sub == 0 && group != file.groups.end() && group->second.objectType != variable;
}

std::vector<std::string> rowsByUs(const DeviceFile &file)
{
    std::vector<std::string> rows;
    for (const FileObject &object : file.objects)
        if (!isCountOfSubindexes(file, object))
            rows.push_back(rowOf(object).toStdString());
    return rows;
}

QByteArray seed(const QString &name)
{
    QFile file(QStringLiteral(CODEWHEEL_EDS_SEEDS "/") + name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name.toStdString();
    return file.readAll();
}

// The package "canopen" of npm, where node finds it: installed globally, or where NODE_PATH says.
class NpmCanopen : public testing::TestWithParam<const char *>
{
protected:
    void SetUp() override
    {
        m_node = QStandardPaths::findExecutable(QStringLiteral("node"));
        if (!qEnvironmentVariableIsSet("NODE_PATH"))
            m_environment.insert(QStringLiteral("NODE_PATH"), globalFolder());
        if (m_node.isEmpty() || run(QStringLiteral("require('canopen')"), {}).exit != 0)
            GTEST_SKIP() << "The package \"canopen\" of npm is not installed: it cannot be tried whether it "
                            "reads of an EDS what we read, and the DCF that we write.";
    }

    struct Run
    {
        int exit;
        QString out;
        QString err;
    };
    Run run(const QString &script, const QStringList &arguments) const
    {
        QProcess process;
        process.setProcessEnvironment(m_environment);
        process.start(m_node, QStringList{QStringLiteral("-e"), script} + arguments);
        EXPECT_TRUE(process.waitForFinished(60'000));
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }
    // What it reads of a file with these bytes.
    std::vector<std::string> rowsByNpm(const QByteArray &bytes)
    {
        QFile file(m_folder.filePath(QStringLiteral("device")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        const Run run = this->run(QString::fromLatin1(npmScript), {file.fileName()});
        EXPECT_EQ(run.exit, 0) << run.err.toStdString();
        std::vector<std::string> rows;
        for (const QString &row : run.out.split(u'\n', Qt::SkipEmptyParts))
            rows.push_back(row.toStdString());
        return rows;
    }

private:
    static QString globalFolder()
    {
        QProcess npm;
        npm.start(QStringLiteral("npm"), {QStringLiteral("root"), QStringLiteral("-g")});
        return npm.waitForFinished(60'000) ? QString::fromUtf8(npm.readAllStandardOutput()).trimmed()
                                           : QString();
    }

    QString m_node;
    QProcessEnvironment m_environment = QProcessEnvironment::systemEnvironment();
    QTemporaryDir m_folder;
};

TEST_P(NpmCanopen, ReadsOfAnEdsWhatWeRead)
{
    const QByteArray bytes = seed(QString::fromLatin1(GetParam()));
    const auto rows = rowsByUs(fileOf(bytes));
    EXPECT_THAT(rows, Not(SizeIs(0)));
    EXPECT_THAT(rowsByNpm(bytes), ElementsAreArray(rows));
}

TEST_P(NpmCanopen, ReadsTheDcfThatWeWrite)
{
    DeviceFile file = fileOf(seed(QString::fromLatin1(GetParam())));
    file.commissioning.node = 9;
    for (FileObject &object : file.objects)
        if (isNumber(*object.type))
            object.value = FileValue{std::int64_t{7}};
    const QByteArray dcf = dcfOf(file, {.fileName = QStringLiteral("hoist.dcf"),
                                        .ofFile = QString::fromLatin1(GetParam()),
                                        .now = QDateTime(QDate(2027, 2, 1), QTime(14, 5))});
    EXPECT_THAT(dcf.toStdString(), HasSubstr("ParameterValue=7"));
    EXPECT_THAT(rowsByNpm(dcf), ElementsAreArray(rowsByUs(file)));
}

// Those of our seeds that it reads at all.
INSTANTIATE_TEST_SUITE_P(SmallFiles, NpmCanopen, testing::Values("encoder.eds", "whole.dcf"));

} // namespace
} // namespace codewheel::canopen
