// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/find/find_page.h"

#include "vocabulary/sentence.h"
#include "vocabulary/shown_text.h"
#include "widgets/find/finder_news_model.h"
#include "widgets/input/form_fields.h"
#include "widgets/input/number_fields.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/wrapped_label.h"

#include <QFormLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QVBoxLayout>

#include <initializer_list>
#include <map>
#include <utility>

namespace codewheel {
namespace {

constexpr int usualTcpPort = 502; // of Modbus/TCP
constexpr int lastTcpPort = 65'535;
constexpr int longestHostName = 253; // RFC 1035
constexpr int portsInSight = 4;

QString wholeName(const PortRow &port)
{
    return port.description.isEmpty() ? port.name : QStringLiteral("%1, %2").arg(port.name, port.description);
}

} // namespace

FindPage::FindPage(QWidget *parent)
    : Page(parent)
    , m_ports(describe(new QListWidget(this), "findPorts", tr("Ports and interfaces"),
                       tr("Space ticks a port or an interface, or leaves it out")))
    , m_refresh(new QPushButton(lineIcon(Icon::refresh), tr("&Refresh"), this))
    , m_otherPort(describe(new TextField(this), "findOtherPort", tr("Port by name"),
                           tr("A port that is not in the list, such as a pseudo terminal; empty: none")))
    , m_host(
          describe(new TextField(this), "findHost", tr("Host"),
                   tr("The name or address of a gateway in the network, such as 192.168.0.5; empty: none")))
    , m_tcpPort(describe(new IntegerField(this), "findTcpPort", tr("Port of the host"),
                         tr("502 with nearly every gateway")))
    , m_search(new QPushButton(lineIcon(Icon::search), tr("&Search"), this))
    , m_cancel(new QPushButton(lineIcon(Icon::cancel), tr("&Cancel"), this))
    , m_doing(wrappedLabel(this, "findDoing"))
    , m_trouble(new InlineMessage(this))
    , m_message(new InlineMessage(this))
    , m_news(new FinderNewsModel(this))
{
    setAccessibleName(title());
    m_doing->setTextFormat(Qt::PlainText);
    QWidget *places = makePlaces();
    QWidget *buttons = makeButtons();
    makeTable();
    auto *rows = layOut<QVBoxLayout>(this, grid::margin, grid::margin);
    for (QWidget *row :
         {places, static_cast<QWidget *>(m_trouble), buttons, static_cast<QWidget *>(m_message)})
        rows->addWidget(row);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_empty, 1);
    rows->addWidget(m_connect, 0, Qt::AlignRight);
    setFocusProxy(m_ports);
    orderTabs();
    connect(m_message, &InlineMessage::actionTriggered, this, [this] {
        m_message->withdraw();
        Q_EMIT askAgreed();
    });
    showWhatIsPossible();
}

FindPage::~FindPage()
{
    m_table->setModel(nullptr);
}

void FindPage::orderTabs()
{
    QWidget *last = m_ports;
    for (QWidget *next : std::initializer_list<QWidget *>{m_refresh, m_otherPort, m_host, m_tcpPort, m_search,
                                                          m_cancel, m_table, m_connect})
        setTabOrder(std::exchange(last, next), next);
}

// Return in a field searches.
void FindPage::keyPressEvent(QKeyEvent *event)
{
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isReturn && m_search->isEnabled())
        search();
    else
        Page::keyPressEvent(event);
}

QWidget *FindPage::makePlaces()
{
    auto *places = new QWidget(this);
    auto *form = makeForm(places, grid::unit);
    m_ports->setMaximumHeight(portsInSight * (m_ports->fontMetrics().height() + grid::unit) + grid::margin);
    m_refresh->setToolTip(tr("Looks for serial ports and interfaces again (Alt+R)"));
    connect(m_refresh, &QPushButton::clicked, this, &FindPage::portsWanted);
    form->addRow(tr("&Ports"),
                 layOutRow({{m_ports, 1}, {m_refresh, 0, Qt::AlignTop}}, {.spacing = grid::unit}));
    m_otherPort->setPlaceholderText(QStringLiteral("/dev/ttyUSB0"));
    form->addRow(tr("Port by na&me"), m_otherPort);
    m_host->setMaxLength(longestHostName);
    m_host->setPlaceholderText(QStringLiteral("192.168.0.5"));
    m_tcpPort->setRange(1, lastTcpPort);
    leaveSeparatorsOut(*m_tcpPort);
    m_tcpPort->setValue(usualTcpPort);
    auto *port = new QLabel(tr("por&t"), this);
    port->setBuddy(m_tcpPort);
    auto *host = layOutRow({{m_host, 1}, port, m_tcpPort}, {.spacing = grid::margin});
    form->addRow(tr("H&ost"), host);
    qobject_cast<QLabel *>(form->labelForField(host))->setBuddy(m_host);
    qobject_cast<QLabel *>(form->itemAt(0, QFormLayout::LabelRole)->widget())->setBuddy(m_ports);
    connect(m_ports, &QListWidget::itemChanged, this, &FindPage::placesChanged);
    for (const QLineEdit *field : {m_otherPort, m_host})
        connect(field, &QLineEdit::textChanged, this, &FindPage::placesChanged);
    connect(m_tcpPort, &QSpinBox::valueChanged, this, &FindPage::placesChanged);
    return places;
}

QWidget *FindPage::makeButtons()
{
    auto *buttons = new QWidget(this);
    for (QPushButton *button : {m_refresh, m_search, m_cancel})
        button->setAutoDefault(true); // Return presses it, as Space does
    m_cancel->setToolTip(tr("Ends the search after its present step (Alt+C)"));
    layOutRow(buttons, {m_search, m_cancel, {m_doing, 1}}, {.spacing = grid::margin, .margins = QMargins()});
    connect(m_search, &QPushButton::clicked, this, &FindPage::search);
    connect(m_cancel, &QPushButton::clicked, this, &FindPage::cancelled);
    return buttons;
}

void FindPage::makeTable()
{
    m_table = new QTableView(this);
    m_empty = new EmptyState(Icon::search, tr("Nobody was looked for yet"),
                             tr("Tick the ports to listen at, or enter a host. Then press Search."), this);
    m_connect = new QPushButton(lineIcon(Icon::start), tr("Co&nnect"), this);
    m_connect->setAutoDefault(true);
    connect(m_connect, &QPushButton::clicked, this, &FindPage::connectChosen);
    setUpQuietTable(*m_table, *m_news, tr("What was heard and found"));
    m_table->setToolTip(tr("Return connects where the chosen one was found"));
    FittedColumns::useIn(*m_table, FinderNewsModel::what);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &FindPage::showWhatIsPossible);
    connect(m_table, &QTableView::activated, this, &FindPage::connectChosen);
}

// Of several ports nobody knows which one is meant, until one is plugged in.
void FindPage::setPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    std::map<QString, Qt::CheckState> before;
    for (int i = 0; i < m_ports->count(); ++i)
        before[m_ports->item(i)->data(Qt::UserRole).toString()] = m_ports->item(i)->checkState();
    const bool isMeant = std::exchange(m_hasListedPorts, true) || ports.size() == 1;
    m_ports->clear();
    for (const PortRow &port : ports) {
        auto *item = new QListWidgetItem(wholeName(port), m_ports);
        item->setData(Qt::UserRole, port.name);
        const auto known = before.find(port.name);
        item->setCheckState(known != before.end() ? known->second : isMeant ? Qt::Checked : Qt::Unchecked);
    }
    m_trouble->showTrouble(Role::attention, trouble);
    showWhatIsPossible();
}

FindWish FindPage::wish() const
{
    FindWish wish{.host = m_host->text().trimmed(), .tcpPort = m_tcpPort->value()};
    for (int i = 0; i < m_ports->count(); ++i)
        if (m_ports->item(i)->checkState() == Qt::Checked)
            wish.ports << m_ports->item(i)->data(Qt::UserRole).toString();
    if (const QString other = m_otherPort->text().trimmed(); !other.isEmpty() && !wish.ports.contains(other))
        wish.ports << other;
    return wish;
}

void FindPage::search()
{
    if (const QString wrong = takeFields(*this); !wrong.isEmpty())
        m_message->showMessage(Role::attention, wrong);
    else
        Q_EMIT searchWanted(wish());
}

// What was asked was about the places of before.
void FindPage::placesChanged()
{
    if (std::exchange(m_isAsking, false))
        m_message->withdraw();
    showWhatIsPossible();
}

void FindPage::begin()
{
    m_isAsking = false;
    m_isSearching = true;
    m_hasSearched = true;
    m_news->setRows({});
    m_message->withdraw();
    m_doing->clear();
    showWhatIsPossible();
}

void FindPage::add(const FinderNews &news)
{
    if (news.kind == FinderNews::Kind::looking) {
        m_doing->setText(shownInLine(news.place + QStringLiteral(": ") + news.sentence));
        return;
    }
    m_news->append({news});
    m_table->scrollToBottom();
    if (news.found && chosen() == nullptr)
        m_table->selectRow(m_news->rowCount() - 1);
}

void FindPage::tell(const Trouble &trouble)
{
    m_trouble->showTrouble(Role::attention, trouble);
}

void FindPage::ask(const QStringList &places, const QStringList &announcements)
{
    m_isAsking = true;
    m_message->showMessage(
        Role::attention,
        sentence(tr("Ask %1? Only reads are sent."), {shownInLine(places.join(QStringLiteral(", ")))}) +
            u'\n' + announcements.join(u'\n'),
        tr("&Ask"));
}

void FindPage::end()
{
    m_isSearching = false;
    m_doing->clear();
    showWhatIsPossible();
}

void FindPage::setProblem(const Trouble &trouble)
{
    m_message->showTrouble(Role::fault, trouble);
}

const Found *FindPage::chosen() const
{
    const QModelIndex row = m_table->selectionModel()->currentIndex();
    if (!row.isValid() || !m_table->selectionModel()->hasSelection())
        return nullptr;
    const FinderNews &news = m_news->rowAt(row.row());
    return news.found && !news.found->isMasterAtWork ? &*news.found : nullptr;
}

void FindPage::connectChosen()
{
    if (const Found *found = chosen(); found != nullptr && !m_isSearching)
        Q_EMIT connectWanted(*found, devicesAt(found->link));
}

std::vector<KindData> FindPage::devicesAt(const QString &link) const
{
    std::vector<KindData> devices;
    for (const FinderNews &news : m_news->rows())
        if (news.found && news.found->link == link && news.found->device != KindData())
            devices.push_back(news.found->device);
    return devices;
}

void FindPage::showWhatIsPossible()
{
    const FindWish places = wish();
    const bool hasPlaces = !places.ports.isEmpty() || !places.host.isEmpty();
    for (QWidget *place :
         std::initializer_list<QWidget *>{m_ports, m_otherPort, m_host, m_tcpPort, m_refresh})
        place->setEnabled(!m_isSearching);
    m_table->setVisible(m_hasSearched);
    m_empty->setVisible(!m_hasSearched);
    m_search->setEnabled(!m_isSearching && hasPlaces);
    m_search->setToolTip(hasPlaces
                             ? tr("Listens at the ticked ports, and then says what it would ask (Alt+S)")
                             : tr("Tick a port, or enter a host"));
    m_cancel->setEnabled(m_isSearching);
    m_connect->setEnabled(!m_isSearching && chosen() != nullptr);
    m_connect->setToolTip(
        m_connect->isEnabled() ? tr("Connects with the settings found, and keeps them in the project (Alt+N)")
        : m_isSearching        ? tr("Once the search has ended")
                        : tr("Choose somebody who was found. Where a master works, it has to go first"));
}

} // namespace codewheel
