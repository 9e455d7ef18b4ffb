// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/bus_list.h"

#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "widgets/input/checked_delegate.h"
#include "widgets/input/form_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/tool.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QToolBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int leastRows = 2; // always in sight

// What is being typed stays when its row changes.
class NameCells final : public CheckedDelegate
{
public:
    using CheckedDelegate::CheckedDelegate;

    void setEditorData(QWidget *editor, const QModelIndex &index) const override
    {
        const auto *field = qobject_cast<QLineEdit *>(editor);
        if (field == nullptr || !field->isModified())
            CheckedDelegate::setEditorData(editor, index);
    }
};

} // namespace

BusList::BusList(ProjectDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_model(new BusModel(document, this))
    , m_tools(new QToolBar(this))
    , m_table(describe(new QTableView(this), "projectBuses", tr("Buses of the project"),
                       tr("The buses that are planned, each with its devices. Insert adds one, Delete "
                          "removes one, F2 renames one.")))
    , m_message(new InlineMessage(this))
    , m_kinds(new QMenu(this))
{
    makeTable();
    makeTools();
    arrange();
    connect(m_message, &InlineMessage::actionTriggered, this, [this] {
        if (m_question)
            remove(m_question->bus);
    });
    connect(m_message, &InlineMessage::closed, this, [this] { m_question.reset(); });
    connect(&m_document, &ProjectDocument::changed, this, &BusList::followProject);
    connect(&m_document, &ProjectDocument::replaced, this, &BusList::withdraw);
    m_table->selectRow(0);
    showWhatIsPossible();
}

void BusList::makeTable()
{
    setUpQuietTable(*m_table, *m_model, tr("Buses of the project"));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked);
    auto *names = new NameCells(
        [this](const QModelIndex &cell, const QString &text) { return m_model->complaint(cell, text); },
        this);
    m_table->setItemDelegate(names);
    connect(names, &CheckedDelegate::inputChecked, this, &BusList::showInput);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &BusList::showWhatIsPossible);
    setFocusProxy(m_table);
}

void BusList::makeTools()
{
    setUpToolBar(*m_tools);
    m_add = addTool(*this, *m_tools,
                    {Icon::add, tr("Add"), QKeySequence(Qt::Key_Insert), tr("Plan another bus")});
    m_remove =
        addTool(*this, *m_tools,
                {Icon::remove, tr("Remove"), QKeySequence(Qt::Key_Delete),
                 tr("Remove the bus from the project with its devices; what is connected is not touched")});
    m_rename =
        addTool(*this, *m_tools,
                {Icon::write, tr("Rename"), QKeySequence(Qt::Key_F2), tr("Give the bus another name")});
    m_kinds->setAccessibleName(tr("Kinds of buses"));
    m_add->setMenu(m_kinds);
    connect(m_kinds, &QMenu::aboutToShow, this, &BusList::fillKinds);
    connect(m_add, &QAction::triggered, this, &BusList::showKinds);
    connect(m_remove, &QAction::triggered, this, &BusList::askRemove);
    connect(m_rename, &QAction::triggered, this, &BusList::rename);
}

void BusList::arrange()
{
    const int row = m_table->verticalHeader()->defaultSectionSize();
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() + leastRows * row);
    layOutColumn(this, {m_tools, {m_table, 1}, m_message}, {.spacing = grid::unit, .margins = QMargins()});
}

void BusList::showKinds()
{
    const QWidget *button = m_tools->widgetForAction(m_add);
    m_kinds->popup(button->mapToGlobal(QPoint(0, button->height())));
    if (!m_kinds->actions().isEmpty())
        m_kinds->setActiveAction(m_kinds->actions().front());
}

void BusList::fillKinds()
{
    m_kinds->clear();
    for (const QString &key : busKindKeys()) {
        if (m_offers && !m_offers(key))
            continue;
        const BusKind *kind = busKind(key);
        m_kinds->addAction(asLabel(kind->title()), this, [this, kind] { add(*kind); });
    }
}

void BusList::add(const BusKind &kind)
{
    if (!takesFields())
        return;
    withdraw();
    const auto isFree = [&](BusId bus) { return !m_isFree || m_isFree(bus, kind.key()); };
    const BusId bus = freeNumber(m_document.project(), kind, isFree);
    Project after = m_document.project();
    const QString name = planBus(after, bus, kind).name;
    m_document.edit(std::move(after), tr("Add %1").arg(name));
    if (plansTraining(m_document.project(), bus))
        m_message->showMessage(
            Role::running, tr("Until its connection leads to a real bus, \"%1\" is simulated: it is that of "
                              "the training bus, and what is connected there stays connected.")
                               .arg(name));
    m_table->selectRow(m_model->rowOf(bus).value_or(0));
    m_table->setFocus();
}

void BusList::rename()
{
    const QModelIndex cell = m_model->index(m_table->currentIndex().row(), BusModel::name);
    m_table->setCurrentIndex(cell);
    m_table->edit(cell);
}

// Asks if devices would go with the bus.
void BusList::askRemove()
{
    const auto bus = chosen();
    if (!bus || !takesFields())
        return;
    const BusRow row = m_model->rowAt(*m_model->rowOf(*bus));
    if (row.devices == 0) {
        remove(*bus);
        return;
    }
    m_question = row;
    m_message->showMessage(
        Role::attention,
        tr("All that is planned and known of the %n devices of \"%1\" leaves the project with it. What is "
           "connected is not touched.",
           nullptr, row.devices)
            .arg(row.name),
        tr("&Remove \"%1\" and its %n devices", nullptr, row.devices).arg(asLabel(row.name)));
}

void BusList::remove(BusId bus)
{
    withdraw();
    const PlannedBus *planned = findBus(m_document.project(), bus);
    if (planned == nullptr)
        return;
    const QString what = tr("Remove %1").arg(planned->name);
    Project after = m_document.project();
    removeBus(after, bus);
    m_document.edit(std::move(after), what);
    m_table->selectRow(std::max(m_table->currentIndex().row(), 0));
    m_table->setFocus();
}

void BusList::showInput(const QString &wrong)
{
    if (!wrong.isEmpty()) {
        m_question.reset();
        m_message->showMessage(Role::attention, wrong);
    } else if (!m_question) {
        m_message->withdraw();
    }
}

// A question lapses when what it is about changes.
void BusList::followProject()
{
    if (m_question) {
        const auto row = m_model->rowOf(m_question->bus);
        if (!row || m_model->rowAt(*row) != *m_question)
            withdraw();
    }
    if (!m_table->currentIndex().isValid())
        m_table->selectRow(0);
    showWhatIsPossible();
}

void BusList::showWhatIsPossible()
{
    m_add->setEnabled(m_document.project().buses.size() < mostBuses);
    m_remove->setEnabled(chosen().has_value());
    m_rename->setEnabled(chosen().has_value());
}

void BusList::withdraw()
{
    m_question.reset();
    m_message->withdraw();
}

// Half-typed input is taken first; if refused, it stays to be corrected.
bool BusList::takesFields()
{
    const QString wrong = takeFields(*this);
    if (!wrong.isEmpty())
        showInput(wrong);
    return wrong.isEmpty();
}

std::optional<BusId> BusList::chosen() const
{
    const int row = m_table->currentIndex().row();
    return row >= 0 && row < m_model->rowCount() ? std::optional(m_model->rowAt(row).bus) : std::nullopt;
}

} // namespace codewheel
