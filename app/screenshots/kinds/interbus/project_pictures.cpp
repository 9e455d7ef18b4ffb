// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/kinds/interbus/ring_pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/ring_edit.h"
#include "widgets/kinds/interbus/master/ring_comparison.h"
#include "widgets/structure_editor/plan_edits.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAbstractButton>
#include <QAction>

#include <array>

namespace codewheel {
namespace {

constexpr Place terminal{firstBus, NodeId("6.0")};

// A crane with its names and addresses; one address was typed wrong.
void planCrane(TrainingWindow &shown)
{
    struct Named
    {
        Place number;
        const char16_t *station;
        const char16_t *group;
    };
    static constexpr std::array named{Named{{firstBus, NodeId("1.0")}, u"Crane 1, hoist", u"A"},
                                      Named{{firstBus, NodeId("2.0")}, u"Crane 1, trolley", u"A"},
                                      Named{{firstBus, NodeId("3.0")}, u"Gate", u"B"},
                                      Named{{firstBus, NodeId("5.0")}, u"Press", u"B"},
                                      Named{{firstBus, NodeId("6.1")}, u"Turntable", u"C"}};
    ProjectDocument &project = shown.project();
    for (const Named &each : named)
        project.editDevice(each.number, {}, [&](ProjectDevice &device) {
            device.station = QString::fromUtf16(each.station);
            device.group = QString::fromUtf16(each.group);
        });
    const Catalog catalog = Catalog::builtIn();
    PlanEdits edits(project, catalog);
    (void)edits.insert(deviceOf(0x81BE),
                       KindData(RingPlace{.terminal = project.indexOf(project.idAt(terminal).value_or(0)),
                                          .onLocalBus = true,
                                          .row = 1}));
    const auto giveIn = [&project](NodeId device, int in) {
        project.editDevice({firstBus, device}, {},
                           [in](ProjectDevice &its) { its.set(GivenAddresses{.in = in}); });
    };
    giveIn(NodeId("4.0"), 128);
    giveIn(NodeId("5.0"), 130);
    shown.advance(40);
}

void wantSomething(TrainingWindow &shown, Place number, const ParameterValues &values)
{
    shown.project().editDevice(number, QString(), [&](ProjectDevice &device) { device.wanted = values; });
}

} // namespace

QWidget *structureEditorAtWork(TrainingWindow &shown)
{
    planCrane(shown);
    shown.window().showStructureEditor();
    shown.advance(40);
    return &shown.window();
}

QWidget *insertionAtWork(TrainingWindow &shown)
{
    structureEditorAtWork(shown);
    auto *editor = shown.window().findChild<StructureEditor *>();
    editor->choose(terminal);
    editor->openInsertPanel();
    shown.advance(40);
    return editor;
}

QWidget *comparisonAtWork(TrainingWindow &shown)
{
    planCrane(shown);
    const Catalog catalog = Catalog::builtIn();
    ProjectDocument &project = shown.project();
    PlanEdits edits(project, catalog);
    (void)edits.change(project.ids(firstBus)[1], deviceOf(0x0236));
    (void)edits.remove({project.ids(firstBus)[2]});
    shown.window().showComparison();
    shown.advance(40);
    return shown.window().findChild<RingComparison *>();
}

QWidget *offlineWindow(TrainingWindow &shown)
{
    structureEditorAtWork(shown);
    shown.window().findChild<RingActions *>()->disconnectBus->trigger();
    shown.advance(40);
    return &shown.window();
}

QWidget *transferAtWork(TrainingWindow &shown)
{
    scene::readAll(shown);
    wantSomething(shown, scene::fraba, {{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    wantSomething(shown, scene::baumer, {{Parameter::steps, 4096}, {Parameter::coding, 6}});
    wantSomething(shown, scene::rod, {{Parameter::measuringLength, 50'000}, {Parameter::direction, 1}});
    shown.window().actions().transfer->trigger();
    shown.advance(scene::whileMilliseconds);
    return &shown.window();
}

QWidget *replacementAtWork(TrainingWindow &shown)
{
    wantSomething(shown, scene::fraba, {{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    shown.bus().encoder(scene::fraba)->tell(Parameter::steps, 4096); // as the new one is to have
    shown.advance(scene::whileMilliseconds);
    shown.controls().setFault(TrainingFault::powerOff, scene::fraba.node, 1);
    shown.advance(3 * scene::whileMilliseconds);
    shown.controls().turnBy(scene::fraba.node, 1'000); // of another encoder
    shown.controls().setFault(TrainingFault::powerOff, scene::fraba.node, 0);
    shown.advance(scene::whileMilliseconds);
    shown.window().actions().replaceEncoder->trigger();
    auto *next = shown.window().findChild<QAbstractButton *>(QStringLiteral("replaceNext"));
    next->click();
    next->click();
    shown.advance(33);
    return &shown.window();
}

} // namespace codewheel
