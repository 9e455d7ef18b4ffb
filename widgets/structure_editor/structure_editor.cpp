// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/structure_editor.h"

#include "encoder/refusal_text.h"
#include "project/project_take_over.h"
#include "project/ring_plan.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure_editor/insert_panel.h"
#include "widgets/structure_editor/plan_model.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>

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

// What is chosen in the ring before is not chosen anew while its rows go.
void StructureEditor::setRing(BusId ring)
{
    if (ring == m_ring)
        return;
    const QSignalBlocker silent(this);
    m_ring = ring;
    m_edits.setRing(ring);
    m_model->setRing(ring);
    m_summary->setRing(ring);
    showProject();
}

void StructureEditor::choose(Place number)
{
    const auto id = m_document.idAt(number);
    if (id && number.bus == m_ring && id != current()) // else what is selected with it stays so
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

void StructureEditor::moveUp()
{
    if (const auto id = current())
        say(m_edits.moveBy(*id, -1));
}

void StructureEditor::moveDown()
{
    if (const auto id = current())
        say(m_edits.moveBy(*id, 1));
}

void StructureEditor::moveIn()
{
    if (const auto id = current())
        say(m_edits.moveIn(*id));
}

void StructureEditor::moveOut()
{
    if (const auto id = current())
        say(m_edits.moveOut(*id));
}

void StructureEditor::changeBus()
{
    if (const auto id = current())
        say(m_edits.changeBus(*id));
}

void StructureEditor::insert(const Participant &device, const RingPlace &place)
{
    const auto inserted = m_edits.insert(device, place);
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

// From the chosen device on, round and round.
void StructureEditor::goToFound(int by)
{
    if (by != 0) // it may have been edited meanwhile
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

void StructureEditor::setAddressing()
{
    if (sender() != m_first)
        m_stepping = m_document.newGesture();
    Project after = m_document.project();
    RingPlan plan = ringPlan(after, m_ring);
    plan.addresses = {.unit = static_cast<AddressRules::Unit>(m_unit->currentIndex()),
                      .first = m_first->value(),
                      .step5 = m_step5->isChecked()};
    setRingPlan(after, m_ring, std::move(plan));
    m_document.edit(std::move(after), tr("Addresses"), m_stepping);
}

// From the chosen device on, round and round.
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
}

void StructureEditor::showCurrent()
{
    const auto id = current();
    for (QAction *action : m_deviceActions)
        action->setEnabled(id.has_value());
    const auto place = id ? m_document.indexOf(*id) : std::nullopt;
    m_insert->setPlace(structureOf(m_document.project(), m_ring), place);
    if (place) // while rows go, their numbers are not yet those of the plan
        Q_EMIT chosen(m_document.device(*id)->place());
}

void StructureEditor::showProject()
{
    const AddressRules rules = ringPlan(m_document.project(), m_ring).addresses;
    const QSignalBlocker first(m_first);
    m_unit->setCurrentIndex(static_cast<int>(rules.unit));
    m_first->setValue(rules.first);
    m_step5->setChecked(rules.step5);
    const bool isEmpty = devicesOn(m_document.project(), m_ring).empty();
    m_empty->setVisible(isEmpty);
    m_empty->setAction(tr("Insert a device"));
    m_tree->setVisible(!isEmpty);
    m_message->withdraw();
    showName();
    showFindings();
    const auto id = current();
    m_insert->setPlace(structureOf(m_document.project(), m_ring),
                       id ? m_document.indexOf(*id) : std::nullopt);
}

void StructureEditor::showName()
{
    const Project &project = m_document.project();
    const PlannedBus *planned = findBus(project, m_ring);
    const bool isOneOfSeveral =
        planned != nullptr && std::ranges::count(project.buses, planned->kind, &PlannedBus::kind) > 1;
    m_name->setVisible(isOneOfSeveral);
    if (isOneOfSeveral)
        m_name->setText(planned->name);
}

void StructureEditor::say(const Result<void> &done)
{
    if (done)
        m_message->withdraw();
    else
        m_message->showMessage(Role::attention, refusalText(done.error()));
}

} // namespace codewheel
