// SPDX-License-Identifier: GPL-3.0-or-later
// The buses in the window: each has views of its own kind, and one of them is the chosen one.
#include "app/window/buses/device_choice.h"
#include "app/window/buses/plant.h"
#include "app/window/kinds/window_kinds.h"
#include "app/window/look/page_head.h"
#include "app/window/main_window.h"
#include "bus/buses.h"
#include "journal/message_fields.h"
#include "vocabulary/sentence.h"
#include "widgets/dial/dial_pin.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace codewheel {

void MainWindow::connectBuses()
{
    connect(m_plant, &Plant::added, this, &MainWindow::addBus);
    connect(m_plant, &Plant::aboutToRemove, this, &MainWindow::removeBus);
    for (BusAtWork *bus : m_plant->all())
        addBus(bus);
    connect(m_structure, &StructureView::busChosen, this, &MainWindow::chooseBus);
    connect(m_structure, &StructureView::chosen, this, &MainWindow::chooseBusOf);
    connect(m_editor, &StructureEditor::busChosen, this, [this](BusId bus) { // it may have no row yet
        m_structure->choose(bus);
        chooseBus(bus);
    });
    connect(&m_project, &ProjectDocument::changed, this, &MainWindow::followRow);
    connect(&m_project, &ProjectDocument::wentBackOrForth, this, &MainWindow::showOneOf);
    connect(m_structure, &StructureView::busOpened, this, [this](BusId bus) {
        if (BusViews *views = viewsOf(bus))
            views->open();
    });
    connect(m_structure, &StructureView::busMenuRequested, this, [this](BusId bus, const QPoint &position) {
        const BusViews *views = viewsOf(bus);
        if (QMenu *menu = views != nullptr ? views->menu() : nullptr)
            menu->popup(position);
    });
}

// A bus of a kind without views is still shown in the bus structure and in the panels of a device.
void MainWindow::addBus(BusAtWork *bus)
{
    auto *rows = static_cast<QVBoxLayout *>(centralWidget()->layout());
    if (const WindowKind *kind = windowKind(bus->kind()); kind != nullptr && kind->makeViews != nullptr)
        addViews(*bus, *kind->makeViews(*bus,
                                        {m_settings, *m_leaving, m_actions, *m_pages, *rows, *m_notice,
                                         *m_status, *m_device, *m_editor},
                                        this));
    connect(bus, &BusAtWork::aboutToChange, this, [this, bus] {
        m_beforeChange = chosen();
        leaveBus(*bus);
    });
    connect(bus, &BusAtWork::changed, this, [this, bus] {
        takeBus(*bus);
        chooseAgain(m_beforeChange, *bus);
    });
    takeBus(*bus);
    if (!m_currentOf.contains(bus->kind()))
        setCurrent(*bus);
    if (bus->id() == m_chosenBus)
        chooseBus(m_chosenBus);
}

void MainWindow::addViews(BusAtWork &bus, BusViews &views)
{
    const BusId id = bus.id();
    m_views[id] = &views;
    views.useSettings(m_settings.choices());
    for (const auto &[panel, page] : views.pages())
        m_panels.addPage(*panel, page);
    connect(&views, &BusViews::told, this, [this, id](Message message) {
        message.place = Place{id, message.place ? message.place->node : NodeId()};
        tell(message);
    });
    connect(&views, &BusViews::panelRequested, this,
            [this, id](const Panel &panel) { showPanel(id, panel); });
    connect(&views, &BusViews::goToWanted, this, &MainWindow::goTo);
    connect(
        &views, &BusViews::devicesChanged, this, [this, &bus] { chooseAgain(chosen(), bus); },
        Qt::QueuedConnection); // once all views have the new ones
}

// The panel may be showing another bus of the same kind.
void MainWindow::showPanel(BusId bus, const Panel &panel)
{
    if (m_currentOf.value(m_plant->find(bus)->kind()) != bus)
        m_structure->choose(bus);
    m_panels.show(panel);
}

void MainWindow::removeBus(BusAtWork *bus)
{
    leaveBus(*bus);
    bus->disconnect(this);
    const BusId id = bus->id();
    if (BusViews *views = viewsOf(id)) {
        if (views->owns(m_pages->currentWidget()))
            showMonitors();
        views->setCurrent(false);
        if (m_keysOf == id)
            giveKeys(firstBus);
        m_views.erase(id);
        delete views;
    }
    if (m_currentOf.value(bus->kind()) == id)
        m_currentOf.remove(bus->kind());
    for (BusAtWork *other : m_plant->all())
        if (other != bus && other->kind() == bus->kind() && !m_currentOf.contains(bus->kind()))
            setCurrent(*other);
    if (m_chosenBus == id && id != firstBus) // another one takes its place
        chooseBus(firstBus);
}

// It is present, connected or not, after leaving whatever it was before.
void MainWindow::takeBus(BusAtWork &bus)
{
    if (EncoderBus *its = bus.bus())
        connect(its, &EncoderBus::stateChanged, this, [this, &bus] { showWhetherOpen(bus); });
    showWhetherOpen(bus);
    showBusState();
}

void MainWindow::leaveBus(BusAtWork &bus)
{
    const Chosen before = chosen();
    m_structure->removeBus(bus.id());
    m_shown.erase(bus.id());
    if (EncoderBus *its = bus.bus())
        its->disconnect(this);
    chooseAgain(before, bus);
}

void MainWindow::showWhetherOpen(BusAtWork &bus)
{
    if (bus.isOpen() == m_shown.contains(bus.id()))
        return;
    const Chosen before = chosen();
    if (bus.isOpen()) {
        m_shown.insert(bus.id());
        m_structure->addBus(*bus.bus());
    } else {
        m_shown.erase(bus.id());
        m_structure->removeBus(bus.id());
    }
    chooseAgain(before, bus);
}

MainWindow::Chosen MainWindow::chosen() const
{
    return {m_structure->row(), m_choice->place()};
}

// As far as it still exists. What its own bus no longer has gives way, if possible to something else on that
// bus.
void MainWindow::chooseAgain(const Chosen &before, const BusAtWork &changed)
{
    if (before.shown && before.shown->bus == changed.id() && changed.isOpen())
        m_choice->keep(before.shown);
    else
        m_choice->choose(before.shown);
    const auto row = m_structure->row();
    if (before.row && m_structure->has(*before.row))
        m_structure->chooseRow(*before.row);
    else if (before.row && !(row && row->bus == before.row->bus) && m_structure->has({before.row->bus}))
        m_structure->choose(before.row->bus);
    followRow();
}

// Keeps the chosen bus in step with the row, whatever the rows have become.
void MainWindow::followRow()
{
    if (!m_structure->row() && !m_choice->place())
        m_structure->choose(m_chosenBus);
    const auto row = m_structure->row();
    if (row && row->bus != m_chosenBus)
        chooseBus(row->bus);
}

// For the row of a bus, the panels go on showing the device before.
void MainWindow::tellDeviceThatStays()
{
    const auto place = m_structure->currentBus() ? m_choice->place() : std::nullopt;
    const auto tell = [this](const Panel &panel, std::optional<Place> shown) {
        m_panels.tellWhose(panel, shown ? shown->shown() : QString());
    };
    tell(panel::parameters, place);
    tell(panel::device, place);
    tell(panel::dial, m_dial->pinned() ? std::nullopt : place);
}

// From now on, this bus is the one that the actions of its kind and the status line apply to.
void MainWindow::setCurrent(BusAtWork &bus)
{
    if (const auto before = m_currentOf.constFind(bus.kind()); before != m_currentOf.constEnd()) {
        if (*before == bus.id())
            return;
        if (BusViews *its = viewsOf(*before))
            its->setCurrent(false);
    }
    m_currentOf[bus.kind()] = bus.id();
    if (BusViews *its = viewsOf(bus.id()))
        its->setCurrent(true);
}

void MainWindow::chooseBus(BusId bus)
{
    BusAtWork *its = m_plant->find(bus);
    m_editor->setBus(bus, its != nullptr ? its->kind() : QString(), m_plant->nameOf(bus));
    if (its == nullptr)
        return;
    const BusViews *before = viewsOf(std::exchange(m_chosenBus, bus));
    if (const BusViews *views = viewsOf(bus)) {
        if (before != nullptr && m_pages->currentWidget() == before->comparison()) {
            if (views->comparison() != nullptr)
                m_pages->setCurrentWidget(views->comparison());
            else
                showMonitors();
        }
        for (const auto &[panel, page] : views->pages())
            m_panels.showPage(*panel, page);
        if (views->takesKeys())
            giveKeys(bus);
    }
    setCurrent(*its);
    tellDeviceThatStays();
    showBusState();
}

// A key never acts on another bus than the chosen one, if that can be connected.
void MainWindow::giveKeys(BusId bus)
{
    if (BusViews *before = viewsOf(m_keysOf))
        before->setHasKeys(false);
    m_keysOf = bus;
    if (BusViews *views = viewsOf(bus))
        views->setHasKeys(true);
}

// If there are several buses of a kind, the tree, pages and panels show which bus they belong to.
void MainWindow::tellWhose()
{
    if (m_structure != nullptr)
        m_structure->showTitles();
    for (const auto &[bus, views] : m_views) {
        const bool isCurrent = bus == m_currentOf.value(m_plant->find(bus)->kind());
        const bool isOneOfSeveral = !nameAmongOthers(bus).isEmpty();
        const bool isPlain = bus == m_chosenBus && !isOneOfSeveral;
        views->setCalled(isPlain ? QString() : m_plant->nameOf(bus), bus != m_chosenBus && isOneOfSeveral);
        for (const auto &[panel, page] : views->pages())
            if (panel == &panel::training ? bus == m_chosenBus : isCurrent)
                m_panels.tellWhose(*panel, nameAmongOthers(bus));
    }
    m_head->showHead();
    showOtherFaults();
}

// What was undone there is seen.
void MainWindow::showOneOf(const std::vector<Place> &places)
{
    const auto isSeen = [this, row = m_structure->row()](Place place) {
        return place == row || (place.isEmpty() && place.bus == m_chosenBus);
    };
    const auto shown = std::ranges::find_if(places, [this](Place place) { return m_structure->has(place); });
    if (shown == places.end() || std::ranges::any_of(places, isSeen))
        return;
    if (shown->isEmpty())
        m_structure->choose(shown->bus);
    else
        m_structure->choose(*shown);
}

void MainWindow::chooseBusOf(Place place)
{
    chooseBus(place.bus);
    m_editor->choose(place);
}

void MainWindow::goTo(Place place)
{
    if (m_structure->has(place)) {
        m_structure->chooseRow(place);
        m_panels.show(panel::structure);
    } else {
        m_notice->showMessage(
            Role::attention,
            sentence(tr("%1 is not in the bus structure: it is neither connected nor in the project."),
                     {placeName(place)}));
    }
}

EncoderBus *MainWindow::chosenBus() const
{
    const BusAtWork *bus = m_plant != nullptr ? m_plant->find(m_chosenBus) : nullptr;
    return bus != nullptr ? bus->bus() : nullptr;
}

BusViews *MainWindow::viewsOf(BusId bus) const
{
    const auto found = m_views.find(bus);
    return found == m_views.end() ? nullptr : found->second;
}

} // namespace codewheel
