// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/offered_view.h"

#include "kinds/interbus/gateway/served_ring.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/interbus/offer/seats_view.h"
#include "widgets/kinds/interbus/offer/served_clients_model.h"
#include "widgets/kinds/interbus/offer/served_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/heading_width.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/role_label.h"
#include "widgets/look/wrapped_label.h"

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QTabWidget>

namespace codewheel {
namespace {

QString howText(const OfferedPlace &place)
{
    QStringList sentences;
    sentences << (place.seats == 0
                      ? OfferedView::tr("All units are the ring of this window.")
                      : OfferedView::tr("Units 1 to %n are the seats, each with a ring of its own. The ring "
                                        "of this window is not offered.",
                                        nullptr, place.seats));
    if (place.readOnly)
        sentences << OfferedView::tr("Clients may only read.");
    if (place.reachesOthers)
        sentences << OfferedView::tr("It can be reached from other computers, without a password.");
    return sentences.join(u' ');
}

} // namespace

OfferedView::OfferedView(QWidget *parent)
    : QWidget(parent)
    , m_clients(new ServedClientsModel(this))
    , m_registers(new ServedRegistersModel(this))
    , m_address(named(new RoleLabel(this), "offeredAddress"))
    , m_copy(describe(new QPushButton(lineIcon(Icon::copy), tr("Cop&y"), this), "copyAddress",
                      tr("Copies address and port (Alt+Y)")))
    , m_how(wrappedLabel(this, "offeredHow"))
    , m_counts(wrappedLabel(this, "clientCounts"))
    , m_tables(named(new QTabWidget(this), "offeredTables"))
    , m_seats(named(new SeatsView(this), "seatPage"))
{
    m_tables->addTab(
        addTable(*m_clients, "servedClients", tr("Clients"),
                 {QStringLiteral("192.168.100.100:50000"), QStringLiteral("255"), ServedText::widestWritten(),
                  ServedText::count(1'000'000), ServedText::count(100'000), ServedText::count(10'000),
                  QStringLiteral("00:00:00")}),
        tr("Clients"));
    m_tables->addTab(m_seats, tr("Seats"));
    m_tables->addTab(makeRegisters(), tr("Registers"));
    m_copy->setAutoDefault(false);
    connect(m_copy, &QPushButton::clicked, this, &OfferedView::copy);
    layOutColumn(this, {layOutRow({m_address, m_copy, Stretch{1}}), m_how, m_counts, {m_tables, 1}},
                 {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_tables->widget(0));
}

OfferedView::~OfferedView()
{
    for (auto *table : findChildren<QTableView *>())
        table->setModel(nullptr);
}

QTableView *OfferedView::addTable(QAbstractItemModel &model, const char *id, const QString &name,
                                  const QStringList &widest)
{
    auto *table = named(new QTableView(this), id);
    setUpQuietTable(*table, model, name);
    fixColumns(*table, widest);
    return table;
}

QWidget *OfferedView::makeRegisters()
{
    auto *page = new QWidget(this);
    QTableView *table =
        addTable(*m_registers, "servedRegisters", tr("Registers"),
                 {QStringLiteral("10.0"), QStringLiteral("1000\u20131001"), QStringLiteral("1000\u20131001"),
                  QStringLiteral("1000\u20131001"), QString(grid::largeIcon, u'n')});
    auto *rules = wrappedLabel(page, "registerRules");
    rules->setText(
        sentence(tr("Registers are counted from 0, with the high word first. The status register is "
                    "%1, the diagnostic parameter %2, as input and as holding registers."),
                 {QString::number(served_registers::status), QString::number(served_registers::parameter)}));
    layOutColumn(page, {{table, 1}, rules}, {.spacing = grid::margin, .margins = QMargins()});
    return page;
}

void OfferedView::setPlace(const OfferedPlace &place)
{
    m_place = place;
    m_address->setState(place.reachesOthers ? Role::attention : Role::running,
                        sentence(tr("Offered at %1"), {place.address}));
    m_how->setText(howText(place));
    m_tables->setTabVisible(m_tables->indexOf(m_seats), place.seats > 0);
}

void OfferedView::setDevices(std::vector<ServedDevice> devices)
{
    m_seats->setDevices(devices);
    m_registers->show(std::move(devices));
}

void OfferedView::showClients(const std::vector<ServedClient> &clients, const ClientCounts &counts)
{
    m_clients->show(clients);
    const QString text = ServedText::clients(counts);
    if (m_counts->text() != text)
        m_counts->setText(text);
}

void OfferedView::copy()
{
    QApplication::clipboard()->setText(m_place.address);
}

} // namespace codewheel
