// SPDX-License-Identifier: GPL-3.0-or-later
// Dragging an encoder out of the bus structure: onto the monitors, onto the sequence, into another program.
#include "tests/app/window_test.h"
#include "widgets/models/dragged_place.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"

#include <QApplication>
#include <QDropEvent>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class Dragging : public test::WindowTest
{
protected:
    // The data of the place's row when it is dragged.
    std::unique_ptr<QMimeData> dragged(Place place)
    {
        auto &structure = *window().findChild<StructureView *>();
        structure.choose(place);
        const auto *tree = structure.findChild<QTreeView *>();
        EXPECT_TRUE(tree->dragEnabled());
        EXPECT_TRUE(tree->currentIndex().flags() & Qt::ItemIsDragEnabled);
        return std::unique_ptr<QMimeData>(tree->model()->mimeData({tree->currentIndex()}));
    }
    static bool drop(QWidget &onto, const QMimeData &data)
    {
        QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&onto, &enter);
        if (!enter.isAccepted())
            return false;
        QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&onto, &event);
        return event.isAccepted();
    }
    SequenceView &sequence() { return *window().findChild<SequenceView *>(); }
};

TEST_F(Dragging, AnEncoderOntoTheMonitorsPinsItsCard)
{
    const auto data = dragged(baumer);
    EXPECT_TRUE(data->text().contains(QStringLiteral("2.0")));
    window().findChild<StructureView *>()->choose(fraba);
    EXPECT_TRUE(drop(monitors(), *data));
    ASSERT_NE(monitors().card(baumer), nullptr);
    EXPECT_TRUE(monitors().card(baumer)->isPinned());
    const auto onLine = dragged(placeOnLine({0x05}));
    EXPECT_FALSE(drop(monitors(), *onLine)) << "it has no words";
}

TEST_F(Dragging, AnEncoderOntoTheSequenceBringsTheWordsThatWereSent)
{
    const auto data = dragged(fraba);
    EXPECT_TRUE(drop(sequence(), *data));
    EXPECT_TRUE(sequence().list().words.empty()) << "nothing was sent yet";
    send(fraba, 0x020000FF);
    send(fraba, 0);
    bus().channel(fraba)->stage(0x80000000);
    EXPECT_TRUE(drop(sequence(), *data));
    EXPECT_EQ(sequence().list().words, (std::vector<Word>{0x020000FF, 0, 0x80000000}));
}

TEST_F(Dragging, WhatAnotherProgramHasIsNotTaken)
{
    QMimeData other;
    other.setData(QStringLiteral("application/x-codewheel-place"), "1 1.0");
    EXPECT_FALSE(drop(monitors(), other));
    EXPECT_FALSE(drop(sequence(), other));
}

} // namespace
} // namespace codewheel
