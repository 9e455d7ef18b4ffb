// SPDX-License-Identifier: GPL-3.0-or-later
// The objects of a node in the window, and the project.
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/dictionary/object_model.h"

#include <QTableView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::nodeSix;

class CanopenObjectsTest : public test::CanopenWindowTest
{
protected:
    CanopenObjectsTest()
    {
        canActions().training->trigger();
        advance(1'500);
        tree().choose(nodeSix);
        advance(50);
    }
    DictionaryView &objects() { return *window().findChild<DictionaryView *>(); }
    QString cell(const char *object, int column)
    {
        const auto *model = objects().findChild<QTableView *>()->model();
        for (int row = 0; row < model->rowCount(); ++row)
            if (model->index(row, ObjectModel::object).data().toString() == QLatin1String(object))
                return model->index(row, column).data().toString();
        return {};
    }
};

TEST_F(CanopenObjectsTest, WhatTheProjectWantsOfTheEncoderStandsBesideItsObjects)
{
    shown->project().editDevice(nodeSix, {}, [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 4096}};
    });
    advance(50);
    EXPECT_EQ(cell("6001h:0", ObjectModel::project), QStringLiteral("00001000h = 4096"));
    shown->project().undoStack().undo();
    advance(50);
    EXPECT_EQ(cell("6001h:0", ObjectModel::project), QString());
}

} // namespace
} // namespace codewheel
