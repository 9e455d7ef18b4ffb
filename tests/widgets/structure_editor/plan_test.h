// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/ring_edit.h"
#include "tests/kinds/interbus/ring/written_ring.h"
#include "widgets/project/project_document.h"

#include <gtest/gtest.h>

namespace codewheel::test {

// The columns of a ring.
enum RingColumn {
    numberColumn,
    stationColumn,
    groupColumn,
    deviceColumn,
    profileColumn,
    idCodeColumn,
    wordsColumn,
    inColumn,
    outColumn,
    serialColumn,
    noteColumn,
    findingsColumn
};

// A project with a terminal that has a local bus and a branch:
// 1.0 K3, 2.0 terminal, 2.1 2.2 on Loop 2, 3.0 and 4.0 in its branch, 5.0 K2, 6.0 terminal, 7.0 LA-66
class PlanTest : public testing::Test
{
protected:
    PlanTest() { document.setProject(projectOf(writtenRing("K3 BT .K3L .K3L /K1 /K3 K2 BT LA")), {}); }

    // "1.0 2.0 2.1 ...", each with the ID of the device there; at the start, the first one has 1.
    QString order() const
    {
        QStringList texts;
        for (std::size_t i = 0; i < document.ids(firstBus).size(); ++i)
            texts << QStringLiteral("%1=%2")
                         .arg(document.project().devices[i].place().toString())
                         .arg(document.ids(firstBus)[i]);
        return texts.join(u' ');
    }
    ProjectDocument::DeviceId id(const QString &number) const
    {
        return *document.idAt(*Place::parse(number));
    }
    static KindData where(const RingPlace &place) { return KindData(place); }
    RingDevice at(const QString &number) const
    {
        return ringDevice(document.device(*Place::parse(number)).participant);
    }

    Catalog catalog = Catalog::builtIn();
    ProjectDocument document;
};

} // namespace codewheel::test
