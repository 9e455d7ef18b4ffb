// SPDX-License-Identifier: GPL-3.0-or-later
// The buses in the window: each has views of its own kind, and one of them is the chosen one.
#include "app/window/device_choice.h"
#include "app/window/main_window.h"
#include "app/window/plant.h"
#include "app/window/window_kinds.h"
#include "bus/buses.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QLabel>
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
    connect(m_editor, &StructureEditor::busChosen, m_structure, qOverload<BusId>(&StructureView::choose));
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

// A kind without views of its own is looked at, in the bus structure and the panels of a device.
void MainWindow::addBus(BusAtWork *bus)
{
    auto *rows = static_cast<QVBoxLayout *>(centralWidget()->layout());
    if (const WindowKind *kind = windowKind(bus->kind()); kind != nullptr && kind->makeViews != nullptr)
        addViews(*bus, *kind->makeViews(*bus,
                                        {m_settings, *m_leaving, m_actions, *m_pages, *rows, *m_notice,
                                         *m_status, *m_device, *m_editor},
                                        this));
    connect(bus, &BusAtWork::aboutToChange, this, [this, bus] { leaveBus(*bus); });
    connect(bus, &BusAtWork::changed, this, [this, bus] { takeBus(*bus); });
    takeBus(*bus);
    if (!m_currentOf.contains(bus->kind()))
        setCurrent(*bus);
}

void MainWindow::addViews(const BusAtWork &bus, BusViews &views)
{
    const BusId id = bus.id();
    m_views[id] = &views;
    for (const auto &[panel, page] : views.pages())
        m_panels.addPage(*panel, page);
    connect(&views, &BusViews::told, this, [this, id](Message message) {
        message.place = Place{id, message.place ? message.place->node : NodeId()};
        tell(message);
    });
    connect(&views, &BusViews::panelRequested, this, [this, id](const Panel &panel) {
        chooseBus(id);
        m_panels.show(panel);
    });
    connect(
        &views, &BusViews::devicesChanged, this, [this] { m_choice->keep(m_choice->place()); },
        Qt::QueuedConnection); // when all views have the new ones
}

void MainWindow::removeBus(BusAtWork *bus)
{
    leaveBus(*bus);
    bus->disconnect(this);
    const BusId id = bus->id();
    if (BusViews *views = viewsOf(id)) {
        views->setCurrent(false);
        m_views.erase(id);
        delete views;
    }
    if (m_currentOf.value(bus->kind()) == id)
        m_currentOf.remove(bus->kind());
    for (BusAtWork *other : m_plant->all())
        if (other != bus && other->kind() == bus->kind() && !m_currentOf.contains(bus->kind()))
            setCurrent(*other);
    if (m_chosenBus == id)
        chooseBus(firstRing);
}

// It is there, connected or not; whatever it was before has been left.
void MainWindow::takeBus(BusAtWork &bus)
{
    if (EncoderBus *its = bus.bus())
        connect(its, &EncoderBus::stateChanged, this, [this, &bus] { showWhetherOpen(bus); });
    showWhetherOpen(bus);
    showBusState();
}

void MainWindow::leaveBus(BusAtWork &bus)
{
    const auto chosen = m_choice->place();
    m_structure->removeBus(bus.id());
    m_shown.erase(bus.id());
    if (EncoderBus *its = bus.bus())
        its->disconnect(this);
    if (chosen)
        m_choice->choose(chosen);
}

void MainWindow::showWhetherOpen(BusAtWork &bus)
{
    if (bus.isOpen() == m_shown.contains(bus.id()))
        return;
    // The row of a bus may be chosen; the panels show a device of another one then.
    const auto place = m_choice->place();
    const bool isPlaceChosen = place && place->bus == m_chosenBus;
    const BusId chosen = m_chosenBus;
    if (bus.isOpen()) {
        m_shown.insert(bus.id());
        m_structure->addBus(*bus.bus());
        if (isPlaceChosen || chosen != bus.id())
            m_choice->keep(place);
    } else {
        m_shown.erase(bus.id());
        m_structure->removeBus(bus.id());
        m_choice->choose(place);
    }
    if (!isPlaceChosen && m_chosenBus != chosen)
        m_structure->choose(chosen);
}

// The actions of its kind, and the status line, mean this bus from now on.
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
    m_editor->setBus(bus, its != nullptr ? its->kind() : QString());
    if (its == nullptr)
        return;
    const BusViews *before = viewsOf(std::exchange(m_chosenBus, bus));
    if (const BusViews *views = viewsOf(bus)) {
        if (before != nullptr && m_pages->currentWidget() == before->comparison())
            m_pages->setCurrentWidget(views->comparison());
        for (const auto &[panel, page] : views->pages())
            m_panels.showPage(*panel, page);
    }
    setCurrent(*its);
    showBusState();
}

// The tree, pages and panels of a kind of which there are several buses have the name of theirs.
void MainWindow::tellWhose()
{
    if (m_structure != nullptr)
        m_structure->showTitles();
    QString ofPage;
    for (const auto &[bus, views] : m_views) {
        if (views->owns(m_pages->currentWidget()))
            ofPage = nameAmongOthers(bus);
        const bool isCurrent = bus == m_currentOf.value(m_plant->find(bus)->kind());
        for (const auto &[panel, page] : views->pages())
            if (panel == &panel::training ? bus == m_chosenBus : isCurrent)
                m_panels.tellWhose(*panel, nameAmongOthers(bus));
    }
    m_whosePage->setText(ofPage);
    m_whosePage->setVisible(!ofPage.isEmpty());
}

void MainWindow::chooseBusOf(Place place)
{
    chooseBus(place.bus);
    m_editor->choose(place);
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
