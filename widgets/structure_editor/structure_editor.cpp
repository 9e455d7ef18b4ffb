// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/structure_editor.h"

#include "vocabulary/refusal_text.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/may_elide.h"
#include "widgets/structure_editor/insert_panel.h"
#include "widgets/structure_editor/plan_model.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

std::optional<PlanEdits::Id> StructureEditor::current() const
{
    return m_model->idAt(m_tree->currentIndex());
}

PlanEdits::Ids StructureEditor::selected() const
{
    PlanEdits::Ids ids;
    for (const QModelIndex &index : m_tree->selectionModel()->selectedRows())
        if (const auto id = m_model->idAt(index))
            ids.push_back(*id);
    return ids;
}

void StructureEditor::makeCurrent(PlanEdits::Id id)
{
    const QModelIndex index = m_model->indexOf(id);
    m_tree->setCurrentIndex(index);
    m_tree->scrollTo(index);
}

// Removing the rows of the previous bus must not count as a choice.
void StructureEditor::setBus(BusId bus, const QString &kind, const QString &name)
{
    m_name = name;
    if (bus == m_edits.bus() && (kind.isEmpty() || kind == m_edits.kindKey()))
        return;
    const QSignalBlocker silent(this);
    m_model->setBus(bus, kind);
    showKind();
    showProject();
    fitColumns();
}

QString StructureEditor::about() const
{
    return busName();
}

QString StructureEditor::busName() const
{
    const PlannedBus *bus = findBus(m_document.project(), m_edits.bus());
    return bus != nullptr     ? bus->name
           : m_name.isEmpty() ? tr("not planned yet")
                              : tr("%1, not planned yet").arg(m_name);
}

void StructureEditor::addFields(BusId bus, QWidget *fields)
{
    m_below->addWidget(fields);
    m_fields[bus] = fields;
    fields->setVisible(bus == m_edits.bus());
}

void StructureEditor::choose(Place number)
{
    const auto id = m_document.idAt(number);
    m_connected = id ? std::nullopt : std::optional(number);
    showPlace();
    if (id && number.bus == m_edits.bus() && id != current()) // otherwise a multiple selection would be lost
        makeCurrent(*id);
}

void StructureEditor::openInsertPanel()
{
    m_insert->show();
    m_insert->focusSearch();
}

void StructureEditor::remove()
{
    say(m_edits.remove(selected()));
}

void StructureEditor::insert(const Participant &device, const KindData &where)
{
    const auto inserted = m_edits.insert(device, where);
    if (inserted)
        makeCurrent(*inserted);
    say(inserted.map([](PlanEdits::Id) {}));
}

void StructureEditor::changeTo(const Participant &device)
{
    if (const auto id = current())
        say(m_edits.change(*id, device));
}

void StructureEditor::search()
{
    m_matches = m_model->find(m_search->text());
    goToFound(0);
}

// Starts at the chosen device, and wraps around.
void StructureEditor::goToFound(int by)
{
    if (by != 0) // the text may have been edited meanwhile
        m_matches = m_model->find(m_search->text());
    const bool isAsked = !m_search->text().trimmed().isEmpty();
    if (m_matches.empty()) {
        m_found->setText(isAsked ? tr("not found") : QString());
        return;
    }
    const auto count = std::ssize(m_matches);
    const auto here = current() ? std::ranges::find(m_matches, *current()) : m_matches.end();
    auto at = here - m_matches.begin();
    at = here == m_matches.end() ? (by < 0 ? count - 1 : 0) : (at + by + count) % count;
    makeCurrent(m_matches[static_cast<std::size_t>(at)]);
    m_found->setText(tr("%1 of %2", "hits of a search").arg(at + 1).arg(count));
}

// Starts at the chosen device, and wraps around.
void StructureEditor::goToFinding()
{
    const std::vector<PlanEdits::Id> found = m_model->withFindings();
    if (found.empty())
        return;
    const std::size_t here = current() ? m_document.indexOf(*current()).value_or(0) : 0;
    const auto next = std::ranges::find_if(
        found, [&](PlanEdits::Id id) { return m_document.indexOf(id).value_or(0) > here; });
    makeCurrent(next == found.end() ? found.front() : *next);
    m_tree->setFocus();
}

void StructureEditor::showFindings()
{
    const std::vector<PlanEdits::Id> found = m_model->withFindings();
    const Role role = found.empty() ? Role::running : Role::attention;
    m_findings->setIcon(lineIcon(roleIcon(role), role));
    m_findings->setText(found.empty()
                            ? tr("No findings")
                            : tr("%n devices with findings", nullptr, static_cast<int>(found.size())));
    m_findings->setEnabled(!found.empty());
    showFindingsOfCurrent();
}

// In full; its column has what room there is.
void StructureEditor::showFindingsOfCurrent()
{
    const QModelIndex cell = m_tree->currentIndex().siblingAtColumn(m_model->columnCount() - 1);
    m_finding->setText(cell.data(Qt::DisplayRole).toString());
}

void StructureEditor::showCurrent()
{
    const auto id = current();
    for (QAction *action : m_deviceActions)
        action->setEnabled(id.has_value());
    if (id)
        m_connected.reset();
    showPlace();
    showFindingsOfCurrent();
    if (id && m_document.indexOf(*id)) // while rows go, their numbers are not yet those of the plan
        Q_EMIT chosen(m_document.device(*id)->place());
}

void StructureEditor::showProject()
{
    showWhetherEmpty();
    m_message->withdraw();
    widenPlaces();
    showBuses();
    showFindings();
    showPlace();
}

// The keys of the page work in an empty plan, too, and the columns fit its first device.
void StructureEditor::showWhetherEmpty()
{
    const bool isEmpty = devicesOn(m_document.project(), m_edits.bus()).empty();
    const bool wasEmpty = m_tree->isHidden();
    const bool hadFocus = m_tree->hasFocus();
    m_empty->setAction(tr("Insert a device"));
    m_empty->setVisible(isEmpty);
    m_tree->setVisible(!isEmpty);
    setFocusProxy(isEmpty ? static_cast<QWidget *>(m_empty) : m_tree);
    if (isEmpty && hadFocus)
        m_empty->setFocus();
    if (wasEmpty && !isEmpty)
        fitColumns();
}

void StructureEditor::showPlace()
{
    const auto id = current();
    const bool isHere = m_connected && m_connected->bus == m_edits.bus() && !m_document.idAt(*m_connected);
    m_insert->setPlace(id && !isHere ? m_document.indexOf(*id) : std::nullopt,
                       isHere ? std::optional(m_connected->node) : std::nullopt);
}

// A bus that is not planned yet goes last.
void StructureEditor::showBuses()
{
    m_buses.clear();
    m_bus->clear();
    for (const PlannedBus &bus : m_document.project().buses) {
        m_buses.push_back(bus.id);
        m_bus->addItem(bus.name);
    }
    if (findBus(m_document.project(), m_edits.bus()) == nullptr) {
        m_buses.push_back(m_edits.bus());
        m_bus->addItem(busName());
    }
    m_bus->setCurrentIndex(static_cast<int>(std::ranges::find(m_buses, m_edits.bus()) - m_buses.begin()));
    m_bus->setVisible(m_buses.size() > 1);
    m_busLabel->setVisible(m_buses.size() > 1);
    Q_EMIT headChanged();
}

// The kind decides what is shown and possible.
void StructureEditor::showKind()
{
    const bool isOrdered = m_edits.rules().isOrdered();
    for (QAction *action : m_orderActions)
        action->setVisible(isOrdered);
    m_tree->setToolTip(
        isOrdered ? tr("Drag devices to move them. F2 or a double click edits station, group, serial "
                       "number, note and addresses.")
                  : tr("F2 or a double click edits address, station, group, serial number and note."));
    m_tree->setRootIsDecorated(isOrdered);
    m_tree->setProperty(mayElideProperty, {});
    allowEliding(*m_tree, m_model->columnCount() - 1); // the findings, which stand below in full
    m_search->setPlaceholderText(m_edits.rules().coded(0, 0) ? tr("Number, name, ID code, station")
                                                             : tr("Address, name, station"));
    m_insert->showKind();
    for (const auto &[bus, fields] : m_fields)
        if (fields)
            fields->setVisible(bus == m_edits.bus());
}

void StructureEditor::say(const Result<void> &done)
{
    if (done)
        m_message->withdraw();
    else
        m_message->showMessage(Role::attention, refusalText(done.error()));
}

} // namespace codewheel
