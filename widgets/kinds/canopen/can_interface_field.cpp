// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_interface_field.h"

#include "widgets/connect/setting_row.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int longestInterface = 15; // characters, as the system allows

} // namespace

CanInterfaceField::CanInterfaceField(QWidget *parent)
    : QWidget(parent)
    , m_name(describe(new QComboBox(this), tr("CAN interface"),
                      tr("Choose the interface of the system, or type its name")))
    , m_refresh(describe(new QPushButton(lineIcon(Icon::refresh), tr("&Refresh"), this), "refreshInterfaces",
                         tr("Looks for CAN interfaces again (Alt+R)")))
    , m_state(named(settingSentence({}, this), "interfaceState"))
    , m_trouble(new InlineMessage(this))
{
    m_name->setEditable(true);
    m_name->setLineEdit(new TextField(m_name));
    m_name->setInsertPolicy(QComboBox::NoInsert);
    m_name->lineEdit()->setMaxLength(longestInterface);
    m_name->lineEdit()->setPlaceholderText(QStringLiteral("can0"));
    describe(m_name->lineEdit(), m_name->accessibleName(), m_name->toolTip());
    m_refresh->setAutoDefault(false);
    m_state->setTextFormat(Qt::PlainText);
    auto *row = layOutRow({{m_name, 1}, m_refresh}, {.spacing = grid::unit});
    layOutColumn(this, {row, m_state}, {.spacing = 0, .margins = QMargins()});
    setFocusProxy(m_name);
    connect(m_refresh, &QPushButton::clicked, this, &CanInterfaceField::refreshWanted);
    connect(m_name, &QComboBox::editTextChanged, this, &CanInterfaceField::showChosen);
    connect(m_name, &QComboBox::editTextChanged, this, &CanInterfaceField::edited);
    showChosen();
}

void CanInterfaceField::addTo(QFormLayout &form, const QString &label)
{
    form.addRow(label, this);
    qobject_cast<QLabel *>(form.labelForField(this))->setBuddy(m_name);
    form.addRow(m_trouble);
}

QString CanInterfaceField::interface() const
{
    return m_name->currentText().trimmed();
}

const CanInterfaceRow *CanInterfaceField::chosen() const
{
    const auto found = std::ranges::find(m_interfaces.rows, interface(), &CanInterfaceRow::name);
    return found == m_interfaces.rows.end() ? nullptr : &*found;
}

void CanInterfaceField::setInterfaces(const CanInterfaceRows &interfaces)
{
    const QString name = interface();
    m_interfaces = interfaces;
    showList();
    setInterface(name.isEmpty() && !interfaces.rows.empty() ? interfaces.rows.front().name : name);
}

void CanInterfaceField::setRate(int rate)
{
    m_rate = rate;
    showChosen();
}

void CanInterfaceField::setInterface(const QString &name)
{
    const int listed = m_name->findText(name);
    m_name->setCurrentIndex(listed);
    if (listed < 0)
        m_name->setEditText(name);
    showChosen();
}

// Nobody has edited anything by that.
void CanInterfaceField::showList()
{
    const QSignalBlocker blocked(m_name);
    m_name->clear();
    for (const CanInterfaceRow &row : m_interfaces.rows) {
        m_name->addItem(row.name);
        m_name->setItemData(m_name->count() - 1, QStringLiteral("%1, %2").arg(row.name, row.state),
                            Qt::AccessibleTextRole);
    }
    m_name->setCurrentIndex(-1);
    m_name->setEditText({});
}

void CanInterfaceField::showChosen()
{
    const CanInterfaceRow *row = chosen();
    const QString unknown = interface().isEmpty() || m_interfaces.rows.empty()
                                ? m_name->toolTip()
                                : tr("The system has no CAN interface of this name now");
    m_state->setText(row != nullptr ? row->state : unknown);
    m_name->setAccessibleDescription(row != nullptr ? row->state : QString());
    Trouble trouble;
    if (row != nullptr && row->trouble)
        trouble = row->trouble(m_rate);
    else if (m_interfaces.rows.empty())
        trouble = m_interfaces.none;
    if (trouble.sentence.isEmpty())
        m_trouble->withdraw();
    else if (trouble.sentence != m_trouble->sentence() || trouble.command != m_trouble->command())
        m_trouble->showTrouble(Role::attention, trouble);
}

} // namespace codewheel
