// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>

namespace codewheel {
namespace {

constexpr int generous = 300'000; // ms; sanitizers are slow

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
}

// Antialiasing at the edges: how Qt rounds depends on the memory address of the picture.
constexpr int rounding = 8; // of 255

// The largest difference over all pixels and colours; 255 if the pictures cannot be compared.
int difference(const QImage &one, const QImage &other)
{
    const QImage a = one.convertToFormat(QImage::Format_RGBA8888);
    const QImage b = other.convertToFormat(QImage::Format_RGBA8888);
    if (a.isNull() || a.size() != b.size())
        return 255;
    int largest = 0;
    for (qsizetype i = 0; i < a.sizeInBytes(); ++i)
        largest = std::max(largest, std::abs(a.constBits()[i] - b.constBits()[i]));
    return largest;
}

void makePictures(const QString &folder)
{
    QProcess program;
    program.start(QStringLiteral(CODEWHEEL_SCREENSHOTS), {folder});
    ASSERT_TRUE(program.waitForFinished(generous));
    ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
}

// The pictures are made once for all tests.
class ManualPictures : public testing::Test
{
protected:
    static void SetUpTestSuite()
    {
        made = std::make_unique<QTemporaryDir>();
        makePictures(made->path());
    }
    static void TearDownTestSuite() { made.reset(); }

    static inline std::unique_ptr<QTemporaryDir> made;
};

// The pictures of the manual are from the training bus in virtual time: nothing in them is random.
TEST_F(ManualPictures, TwoRunsGiveTheSameFiles)
{
    const QTemporaryDir &first = *made;
    const QTemporaryDir second;
    makePictures(second.path());
    const QStringList names = QDir(first.path()).entryList({QStringLiteral("*.png")});
    EXPECT_EQ(names, QDir(second.path()).entryList({QStringLiteral("*.png")}));
    EXPECT_TRUE(names.contains(QStringLiteral("window.png")));
    EXPECT_TRUE(names.contains(QStringLiteral("window-dark.png")));
    for (const QString &name : names)
        EXPECT_LE(difference(QImage(first.filePath(name)), QImage(second.filePath(name))), rounding)
            << name.toStdString();
}

TEST_F(ManualPictures, EveryPictureOfTheManualIsMade)
{
    QDir root(QStringLiteral(CODEWHEEL_ROOT));
    QStringList pages{root.filePath(QStringLiteral("README.md"))};
    QDir manual(root.filePath(QStringLiteral("docs/manual")));
    for (const QString &page : manual.entryList({QStringLiteral("*.md")}))
        pages.append(manual.filePath(page));
    const QRegularExpression picture(QStringLiteral(R"(images/([a-z-]+\.png))"));
    for (const QString &page : pages) {
        auto found = picture.globalMatch(QString::fromUtf8(contentOf(page)));
        while (found.hasNext()) {
            const QString name = found.next().captured(1);
            EXPECT_TRUE(QFile::exists(made->filePath(name)))
                << page.toStdString() << " shows " << name.toStdString();
        }
    }
}

} // namespace
} // namespace codewheel
