// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connect/port_field.h"

#include "vocabulary/sentence.h"
#include "widgets/connect/setting_row.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyledItemDelegate>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int longestPort = 4'096; // characters of a path

// What tells it from others, beside the name of its port.
QString adapterText(const PortRow &port)
{
    QStringList parts;
    if (!port.description.isEmpty())
        parts << port.description;
    if (!port.serialNumber.isEmpty())
        parts << sentence(PortField::tr("serial number %1"), {port.serialNumber});
    return parts.join(QStringLiteral(", "));
}

// In the opened list a port is told with its adapter.
class WholePort final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->text = index.data(Qt::AccessibleTextRole).toString();
    }
};

} // namespace

PortField::PortField(QWidget *parent)
    : QWidget(parent)
    , m_port(new QComboBox(this))
    , m_refresh(new QPushButton(lineIcon(Icon::refresh), tr("&Refresh"), this))
    , m_adapter(named(settingSentence({}, this), "adapter"))
    , m_trouble(new InlineMessage(this))
{
    makePort();
    makeRefresh();
    m_adapter->setTextFormat(Qt::PlainText);
    auto *row = layOutRow({{m_port, 1}, m_refresh}, {.spacing = grid::unit});
    layOutColumn(this, {row, m_adapter}, {.spacing = 0, .margins = QMargins()});
    setFocusProxy(m_port);
    connect(m_port, &QComboBox::editTextChanged, this, &PortField::showAdapter);
    connect(m_port, &QComboBox::editTextChanged, this, &PortField::edited);
    connect(m_port, &QComboBox::activated, this, &PortField::pick);
    connect(m_port->lineEdit(), &QLineEdit::textEdited, this, &PortField::pick);
    showPorts();
    showAdapter();
}

void PortField::makePort()
{
    describe(m_port, tr("Port"), tr("Choose the adapter, or type the path of a port or a pseudo terminal"));
    m_port->setEditable(true);
    m_port->setLineEdit(new TextField(m_port));
    m_port->setInsertPolicy(QComboBox::NoInsert);
    m_port->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_port->setMinimumContentsLength(16);
    m_port->setItemDelegate(new WholePort(m_port));
    m_port->lineEdit()->setMaxLength(longestPort);
    m_port->lineEdit()->setPlaceholderText(QStringLiteral("/dev/ttyUSB0"));
    describe(m_port->lineEdit(), m_port->accessibleName(), m_port->toolTip());
}

void PortField::makeRefresh()
{
    m_refresh->setAutoDefault(false);
    m_refresh->setToolTip(tr("Looks for serial ports again (Alt+R)"));
    connect(m_refresh, &QPushButton::clicked, this, &PortField::refreshWanted);
}

void PortField::addTo(QFormLayout &form, const QString &label)
{
    form.addRow(label, this);
    qobject_cast<QLabel *>(form.labelForField(this))->setBuddy(m_port);
    form.addRow(m_trouble);
}

QString PortField::port() const
{
    return m_port->currentText().trimmed();
}

void PortField::setPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    const QString chosen = port();
    const bool isPicked = m_isPicked;
    m_ports = ports;
    showPorts();
    setPort(chosen.isEmpty() && !ports.empty() ? ports.front().name : chosen);
    m_isPicked = isPicked;
    if (!trouble.sentence.isEmpty())
        m_trouble->showTrouble(Role::attention, trouble);
    else if (ports.empty())
        m_trouble->showMessage(Role::attention,
                               tr("No serial port was found. Plug the adapter in and refresh the "
                                  "list, or type the path of a port."));
    else
        m_trouble->withdraw();
}

void PortField::showPorts()
{
    m_port->clear();
    int widest = 0;
    for (const PortRow &port : m_ports) {
        const QString adapter = adapterText(port);
        const QString whole =
            adapter.isEmpty() ? port.name : QStringLiteral("%1, %2").arg(port.name, adapter);
        m_port->addItem(port.name);
        m_port->setItemData(m_port->count() - 1, whole, Qt::AccessibleTextRole);
        widest = std::max(widest, m_port->fontMetrics().horizontalAdvance(whole));
    }
    m_port->view()->setMinimumWidth(widest + 2 * grid::groupGap);
}

// Of whatever adapter there is; its name alone stands in the field. Without one, what the field is for.
void PortField::showAdapter()
{
    const auto chosen = std::ranges::find(m_ports, port(), &PortRow::name);
    const QString adapter = chosen == m_ports.end() ? QString() : adapterText(*chosen);
    m_adapter->setText(adapter.isEmpty() ? m_port->toolTip() : adapter);
    m_port->setAccessibleDescription(adapter);
}

void PortField::setPort(const QString &port)
{
    const int listed = m_port->findText(port);
    m_port->setCurrentIndex(listed);
    if (listed < 0)
        m_port->setEditText(port);
    showAdapter();
    m_isPicked = false;
}

} // namespace codewheel
