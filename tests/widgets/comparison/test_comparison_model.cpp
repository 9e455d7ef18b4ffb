// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "tests/kinds/interbus/ring/written_ring.h"
#include "tests/support/model_tester.h"
#include "widgets/comparison/comparison_model.h"
#include "widgets/structure_editor/plan_edits.h"

namespace codewheel {
namespace {

class ComparisonModelTest : public testing::Test
{
protected:
    void compare(const char *configured, const char *connected, bool onlyDifferences = false)
    {
        document.setProject(projectOf(writtenRing(configured)), {});
        model.compare(PlanEdits(document, catalog), {participantsOf(writtenRing(connected)), {}},
                      onlyDifferences);
    }
    QString text(int row, int column) const { return model.index(row, column).data().toString(); }

    int differences() const { return codewheel::differences(model.comparison()); }

    Catalog catalog = Catalog::builtIn();
    ProjectDocument document;
    ComparisonModel model;
    test::ModelTester tester{model};
};

TEST_F(ComparisonModelTest, ShowsTheTwoRingsBesideEachOther)
{
    compare("K3 BT .K3L K2", "K3 BT .K3L K2");
    EXPECT_EQ(differences(), 0);
    EXPECT_EQ(model.rowCount(), 4);
    EXPECT_EQ(text(1, ComparisonModel::configuredColumn), QStringLiteral("2.0  bus terminal  0Ch"));
    EXPECT_EQ(text(3, ComparisonModel::connectedColumn), QStringLiteral("3.0  K2, make not known  36h"));
    EXPECT_EQ(text(3, ComparisonModel::differenceColumn), QStringLiteral("same"));
}

TEST_F(ComparisonModelTest, SaysInWordsWhatDiffers)
{
    compare("K3 BT K3", "K3 BT K2");
    EXPECT_EQ(differences(), 1);
    EXPECT_EQ(text(2, ComparisonModel::differenceColumn),
              QStringLiteral("3.0: configured K3 37h, found K2 36h"));
    compare("K3 BT", "K3");
    EXPECT_EQ(text(1, ComparisonModel::connectedColumn), QStringLiteral("–"));
    EXPECT_TRUE(text(1, ComparisonModel::differenceColumn).contains(QStringLiteral("missing")));
}

TEST_F(ComparisonModelTest, OnlyDifferencesAreShownIfWanted)
{
    compare("K3 BT .K3L K2", "K3 BT K2 LA", true);
    EXPECT_EQ(model.rowCount(), differences());
    EXPECT_GT(model.rowCount(), 0);
    EXPECT_GT(model.rowAt(0).line, 0u) << "it knows its line of the comparison";
    compare("K3", "K3", true);
    EXPECT_EQ(model.rowCount(), 0);
}

} // namespace
} // namespace codewheel
